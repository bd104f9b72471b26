!> Progress of long work on standard error: how much it is before it starts, then the time that remains. From two seconds on one
!> line is rewritten on a terminal; elsewhere a line comes every ten seconds. Nothing with --quiet.
module dg_progress
   use, intrinsic :: iso_fortran_env, only: error_unit, int64
   use dg_kinds, only: wp
   use dg_clock, only: seconds_between
   use dg_diagnostic, only: report_line
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_missing, only: is_missing, missing
   use dg_process, only: someone_watches
   use dg_text, only: to_text
   implicit none
   private
   public :: progress_type, start_progress, show_cases, show_time, end_progress

   type, extends(ensemble_watch_type) :: progress_type
      logical :: quiet = .true.
      logical :: on_terminal = .false.
      logical :: timed = .false.                !< the time that remains has been told
      character(:), allocatable :: label
      integer(int64) :: started = 0, last = 0   !< ticks
      integer :: width = 0                      !< of the line that stands there
   contains
      procedure :: show
   end type progress_type

   !> Shortest time between two lines on a terminal, and elsewhere [s].
   real(wp), parameter :: pause = 0.2_wp, long_pause = 10.0_wp
   !> The remaining time is told from this part of the work on [-], or after this time [s].
   real(wp), parameter :: telling = 0.02_wp, telling_after = 2.0_wp
   !> Shortest remaining time that is told where no terminal shows it [s].
   real(wp), parameter :: worth_telling = 2.0_wp
   character(*), parameter :: carriage_return = achar(13)

contains

   !> Shows how many load cases are solved, and names one. Nothing in the first two seconds.
   subroutine show_cases(progress, solved, all, what)
      type(progress_type), intent(inout) :: progress
      integer, intent(in) :: solved, all   !< load cases, each with each model
      character(*), intent(in) :: what     !< the case at work, in words
      integer(int64) :: now
      real(wp) :: seconds, wait
      if (progress%quiet) return
      call system_clock(now)
      seconds = seconds_between(progress%started, now)
      wait = merge(pause, long_pause, progress%on_terminal)
      if (.not. (progress%timed .or. progress%on_terminal)) wait = telling_after     ! the first line
      if (seconds < telling_after .or. seconds_between(progress%last, now) < wait) return
      call write_line(progress, progress%label//': '//to_text(solved)//' of '//to_text(all)//' solved in '// &
                      remaining_text(seconds)//', '//what)
      progress%timed = .true.
      progress%last = now
   end subroutine show_cases

   !> Writes a line over the one before on a terminal, elsewhere below it.
   subroutine write_line(progress, line)
      type(progress_type), intent(inout) :: progress
      character(*), intent(in) :: line
      if (progress%on_terminal) then
         write (error_unit, '(a)', advance='no') carriage_return//line//repeat(' ', max(progress%width - len(line), 0))
         flush (error_unit)
         progress%width = len(line)
      else
         call report_line(line)
      end if
   end subroutine write_line

   !> Begins, and tells how much there is to do.
   subroutine start_progress(progress, label, work, quiet)
      type(progress_type), intent(out) :: progress
      character(*), intent(in) :: label
      character(*), intent(in) :: work     !< '12 solutions'; '': nothing is told yet
      logical, intent(in) :: quiet
      progress%quiet = quiet
      progress%on_terminal = someone_watches() .and. .not. quiet
      progress%label = label
      call system_clock(progress%started)
      progress%last = progress%started
      if (.not. quiet .and. work /= '') call report_line(label//': '//work//' to find')
   end subroutine start_progress

   !> Shows how far the work is. The remaining time supposes that what is left costs as what was done since the start.
   subroutine show(self, share, first_share, what)
      class(progress_type), intent(inout) :: self
      real(wp), intent(in) :: share        !< of the work that is done [-]
      real(wp), intent(in) :: first_share  !< of it that was done at the start [-]
      character(*), intent(in) :: what     !< how much, in words
      character(:), allocatable :: line
      integer(int64) :: now
      real(wp) :: left
      if (self%quiet) return
      call system_clock(now)
      left = seconds_left(self, share - first_share, 1.0_wp - share, now)
      line = self%label//': '//what//', '//to_text(nint(100.0_wp*share))//' %'
      if (.not. is_missing(left)) line = line//', '//remaining_text(left)//' left'
      if (self%on_terminal) then
         if (seconds_between(self%last, now) < pause) return
         call write_line(self, line)
      else
         if (left < worth_telling .or. (self%timed .and. seconds_between(self%last, now) < long_pause)) return
         call report_line(line)
         self%timed = .true.
      end if
      self%last = now
   end subroutine show

   !> Tells once how long the work will take, when the first of it is done.
   subroutine show_time(progress, share)
      type(progress_type), intent(inout) :: progress
      real(wp), intent(in) :: share        !< of the work that is done [-]
      integer(int64) :: now
      real(wp) :: left
      if (progress%quiet .or. progress%timed) return
      call system_clock(now)
      left = seconds_left(progress, share, 1.0_wp - share, now)
      if (is_missing(left)) return
      progress%timed = .true.
      if (left >= worth_telling) call report_line(progress%label//': about '//remaining_text(left)//' left')
   end subroutine show_time

   !> Time that the rest of the work takes [s]; missing where too little is done to tell.
   function seconds_left(progress, done, rest, now) result(left)
      class(progress_type), intent(in) :: progress
      real(wp), intent(in) :: done, rest   !< parts of the work [-]
      integer(int64), intent(in) :: now    !< ticks
      real(wp) :: left
      real(wp) :: seconds
      left = missing
      seconds = seconds_between(progress%started, now)
      if (done > telling .or. (done > 0.0_wp .and. seconds > telling_after)) left = seconds*rest/done
   end function seconds_left

   !> Takes the line away.
   subroutine end_progress(progress)
      type(progress_type), intent(inout) :: progress
      if (progress%width > 0) write (error_unit, '(a)', advance='no') &
         carriage_return//repeat(' ', progress%width)//carriage_return
      flush (error_unit)
      progress%width = 0
   end subroutine end_progress

   !> A time as people say it.
   pure function remaining_text(seconds) result(text)
      real(wp), intent(in) :: seconds
      character(:), allocatable :: text
      integer, parameter :: minute = 60, hour = 60*minute
      real(wp), parameter :: longest = 1.0e8_wp
      integer :: whole
      whole = ceiling(min(seconds, longest))
      if (whole < minute) then
         text = to_text(whole)//' s'
      else if (whole < hour) then
         text = to_text(whole/minute)//' min '//to_text(modulo(whole, minute))//' s'
      else
         text = to_text(whole/hour)//' h '//to_text(modulo(whole, hour)/minute)//' min'
      end if
   end function remaining_text
end module dg_progress
