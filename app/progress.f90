!> Progress of long work on a terminal: one line that is written over, with the time that remains. Nothing where nobody
!> watches.
module dg_progress
   use, intrinsic :: iso_fortran_env, only: error_unit, int64
   use dg_kinds, only: wp
   use dg_clock, only: seconds_between
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_process, only: someone_watches
   use dg_text, only: to_text
   implicit none
   private
   public :: progress_type, start_progress, end_progress

   type, extends(ensemble_watch_type) :: progress_type
      logical :: shown = .false.
      character(:), allocatable :: label
      integer(int64) :: started = 0, last = 0   !< ticks
      integer :: width = 0                      !< of the line that stands there
   contains
      procedure :: show
   end type progress_type

   !> A new line no sooner than this after the one before [s].
   real(wp), parameter :: pause = 0.2_wp
   !> Part of the work from which the remaining time can be told [-].
   real(wp), parameter :: telling = 0.02_wp
   character(*), parameter :: carriage_return = achar(13)

contains

   !> Begins; `quiet` or no terminal: nothing will be shown.
   subroutine start_progress(progress, label, quiet)
      type(progress_type), intent(out) :: progress
      character(*), intent(in) :: label
      logical, intent(in) :: quiet
      progress%shown = someone_watches() .and. .not. quiet
      progress%label = label
      call system_clock(progress%started)
      progress%last = progress%started
   end subroutine start_progress

   !> Shows how far the work is. The remaining time supposes that what is left costs as what was done since the start.
   subroutine show(self, share, first_share, what)
      class(progress_type), intent(inout) :: self
      real(wp), intent(in) :: share        !< of the work that is done [-]
      real(wp), intent(in) :: first_share  !< of it that was done at the start [-]
      character(*), intent(in) :: what     !< how much, in words
      character(:), allocatable :: line
      integer(int64) :: now
      real(wp) :: done
      if (.not. self%shown) return
      call system_clock(now)
      if (seconds_between(self%last, now) < pause) return
      self%last = now
      line = self%label//': '//what//', '//to_text(nint(100.0_wp*share))//' %'
      done = share - first_share
      if (done > telling) line = line//', '// &
         remaining_text(seconds_between(self%started, now)*(1.0_wp - share)/done)//' left'
      write (error_unit, '(a)', advance='no') carriage_return//line//repeat(' ', max(self%width - len(line), 0))
      flush (error_unit)
      self%width = len(line)
   end subroutine show

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
