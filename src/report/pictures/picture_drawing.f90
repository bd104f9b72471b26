!> Drawing of pictures by gnuplot from their scripts, two at a time. A picture is drawn under another name and gets its own
!> once it is complete.
module dg_picture_drawing
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_child_process, only: child_type, end_child, start_child, wait_for_child
   use dg_error, only: error_type, raise, status_failure
   use dg_file_identity, only: identity_of_link, identity_type
   use dg_file_system, only: delete_file, rename_file, unfinished_suffix
   use dg_gnuplot_script, only: ending_variable, spelled
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_kinds, only: wp
   use dg_system_reason, only: reason_of_failed_write
   use dg_text, only: append_text, either, text_type, to_text
   implicit none
   private
   public :: draw_pictures, complaint_file, usual_patience

   !> Longest time that gnuplot may draw without beginning another picture [s]. It takes 10 ms for one of 1000 rows and two minutes
   !> for one of four million, on a slow machine twice that.
   real(wp), parameter :: usual_patience = 300.0_wp
   !> File of gnuplot's error messages; only kept if it failed.
   character(*), parameter :: complaint_file = 'gnuplot.log'
   !> Variables of the environment that change gnuplot: its terminal, its start, its folders of scripts and fonts.
   character(*), parameter :: hidden_variables(2) = [character(4) :: 'GNU', 'FIT_']
   !> End of a complete picture.
   character(*), parameter :: last_mark = '</svg>'

   !> Gnuplots at a time: more gain nothing, and the machine may be others' too.
   integer, parameter :: at_a_time = 2
   !> Most pictures of one gnuplot: a command line has room for their names.
   integer, parameter :: most_of_one = 50
   !> For how long one gnuplot is waited for before the other is looked at [s].
   real(wp), parameter :: glance = 0.01_wp

   !> A gnuplot and the pictures that it draws, one after the other.
   type :: drawing_type
      type(child_type) :: child
      integer :: first = 1, last = 0          !< numbers of its pictures
      integer :: begun = 0                    !< of them, when it was last asked
      integer(int64) :: asked = 0             !< when that was
      logical :: suspect = .false.            !< the disk was full meanwhile: any of its pictures may lack a piece
   end type drawing_type

contains

   !> Draw `<name>.svg` by `<name>.gp` for all names in the folder, shares of them by one gnuplot each. If a share fails, each
   !> of its pictures gets its own gnuplot, so that one faulty picture does not affect others. Pictures of an earlier run are
   !> removed first. `error` is set if not all are drawn, or if the program was interrupted.
   subroutine draw_pictures(gnuplot, folder, names, patience, drawn, error)
      character(*), intent(in) :: gnuplot          !< the program, from the root of the file system on; '': none, nothing is drawn
      character(*), intent(in) :: folder
      type(text_type), intent(in) :: names(:)
      real(wp), intent(in) :: patience             !< usual_patience [s]; tests have less
      logical, intent(out) :: drawn(:)             !< as many
      type(error_type), allocatable, intent(out) :: error
      type(drawing_type) :: drawings(at_a_time)
      character(:), allocatable :: done
      character(:), allocatable :: reason               ! why the system took no more of a picture; '': it took all
      character(:), allocatable :: found
      integer :: shares(2, 2*size(names) + at_a_time)   ! first and last picture of what is to be drawn
      integer :: i, k, next, known, bad, hung
      drawn = .false.
      do i = 1, size(names)
         call delete_file(picture_path(folder, names(i)%text))
         call delete_file(unfinished_path(folder, names(i)%text))
      end do
      call delete_file(folder//'/'//complaint_file)
      if (gnuplot == '') return
      call share_out(size(names), shares, known)
      next = 1
      hung = 0
      reason = ''
      do
         do k = 1, at_a_time
            associate (drawing => drawings(k))
               if (.not. drawing%child%running) then
                  if (next > known .or. is_interrupted()) cycle
                  drawing%first = shares(1, next)
                  drawing%last = shares(2, next)
                  next = next + 1
                  call start_gnuplot(gnuplot, folder, names(drawing%first:drawing%last), drawing, error)
                  if (allocated(error)) exit
               end if
               call wait_for_child(drawing%child, glance)
               if (drawing%child%running) then
                  if (is_silent(drawing, folder, names, patience)) hung = k
               else
                  call end_drawing(drawing, folder, names, drawn, shares, known, found)
                  if (found /= '') reason = found
                  drawings%suspect = drawings%suspect .or. found /= ''
               end if
            end associate
         end do
         if (allocated(error) .or. hung > 0 .or. is_interrupted()) exit
         if (next > known .and. .not. any(drawings%child%running)) exit
      end do
      do k = 1, at_a_time
         if (.not. drawings(k)%child%running) cycle
         call end_child(drawings(k)%child)
         do i = drawings(k)%first, drawings(k)%last
            if (drawings(k)%suspect) then
               call delete_file(unfinished_path(folder, names(i)%text))
            else
               call rename_picture(folder, names(i)%text, drawn(i), reason)
            end if
         end do
      end do
      if (allocated(error)) return
      done = to_text(count(drawn))//' of '//to_text(size(drawn))//' pictures in '//folder//' are drawn'
      bad = findloc(drawn, .false., dim=1)
      if (is_interrupted()) then
         call delete_file(folder//'/'//complaint_file)
         call raise(error, status_failure, 'ended by '//interruption_name()//': '//done)
      else if (bad == 0) then
         call delete_file(folder//'/'//complaint_file)
      else if (hung > 0) then
         i = findloc(drawn(drawings(hung)%first:drawings(hung)%last), .false., dim=1)
         if (i > 0) bad = drawings(hung)%first + i - 1
         call raise(error, status_failure, gnuplot//' drew nothing for '//to_text(patience)//' s and was ended: '//done// &
                    '; does it draw '//names(bad)%text//'.gp there when you run it yourself?')
      else
         call raise(error, status_failure, 'gnuplot failed: '//done//', '//names(bad)%text//' is not'// &
                    either('; '//complaint_file//' there tells why', ': '//reason, reason == ''))
      end if
   end subroutine draw_pictures

   !> Shares of n pictures, as long as they may be, but one for each gnuplot at least.
   pure subroutine share_out(n, shares, count)
      integer, intent(in) :: n
      integer, intent(out) :: shares(:, :)     !< first and last picture of each
      integer, intent(out) :: count
      integer :: k
      count = min(n, at_a_time*((n + at_a_time*most_of_one - 1)/(at_a_time*most_of_one)))
      shares = 0
      do k = 1, count
         shares(:, k) = [1 + int(int(n, int64)*(k - 1)/count), int(int(n, int64)*k/count)]
      end do
   end subroutine share_out

   !> Starts a gnuplot on some pictures.
   subroutine start_gnuplot(gnuplot, folder, names, drawing, error)
      character(*), intent(in) :: gnuplot, folder
      type(text_type), intent(in) :: names(:)           !< of its pictures
      type(drawing_type), intent(inout) :: drawing
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: arguments(:)
      integer :: i
      call append_text(arguments, '-d')                 ! without the user's own settings
      call append_text(arguments, '-e')
      call append_text(arguments, ending_variable//' = '//spelled(unfinished_suffix))
      do i = 1, size(names)
         call append_text(arguments, names(i)%text//'.gp')
      end do
      call start_child(drawing%child, gnuplot, arguments, folder, complaint_file, hidden_variables, error)
      drawing%begun = 0
      drawing%suspect = .false.
      call system_clock(drawing%asked)
   end subroutine start_gnuplot

   !> True if gnuplot has begun no other picture for too long.
   function is_silent(drawing, folder, names, patience) result(silent)
      type(drawing_type), intent(inout) :: drawing
      character(*), intent(in) :: folder
      type(text_type), intent(in) :: names(:)           !< of all pictures
      real(wp), intent(in) :: patience
      logical :: silent
      integer(int64) :: now, rate
      integer :: before, i
      logical :: is
      silent = .false.
      call system_clock(now, rate)
      if (real(now - drawing%asked, wp) < patience*real(rate, wp)) return
      drawing%asked = now
      before = drawing%begun
      drawing%begun = 0
      do i = drawing%first, drawing%last
         inquire (file=unfinished_path(folder, names(i)%text), exist=is)
         if (is) drawing%begun = drawing%begun + 1
      end do
      silent = drawing%begun == before
   end function is_silent

   !> End a drawing: take the pictures of a gnuplot that has ended. If it failed they are all invalid, and each is drawn alone,
   !> unless it was. The same holds if the disk was full meanwhile: gnuplot leaves a piece out and goes on when there is room
   !> again.
   subroutine end_drawing(drawing, folder, names, drawn, shares, known, reason)
      type(drawing_type), intent(inout) :: drawing
      character(*), intent(in) :: folder
      type(text_type), intent(in) :: names(:)
      logical, intent(inout) :: drawn(:)
      integer, intent(inout) :: shares(:, :)
      integer, intent(inout) :: known                   !< number of shares
      character(:), allocatable, intent(out) :: reason  !< why the system took no more of a picture; '': it took all
      integer :: i
      reason = ''
      do i = drawing%first, drawing%last
         if (drawing%child%exit_status == 0 .and. .not. drawing%suspect) then
            call rename_picture(folder, names(i)%text, drawn(i), reason)
            cycle
         end if
         call note_reason(unfinished_path(folder, names(i)%text), reason)
         call delete_file(unfinished_path(folder, names(i)%text))       ! it may look whole
         if (drawing%first == drawing%last) cycle
         known = known + 1
         shares(:, known) = i
      end do
   end subroutine end_drawing

   !> Gives a picture its own name if it is whole.
   subroutine rename_picture(folder, name, drawn, reason)
      character(*), intent(in) :: folder, name
      logical, intent(inout) :: drawn
      character(:), allocatable, intent(inout) :: reason     !< see note_reason
      type(error_type), allocatable :: failure
      if (is_whole(unfinished_path(folder, name))) then
         call rename_file(unfinished_path(folder, name), picture_path(folder, name), failure)
         drawn = .not. allocated(failure)
      else
         call note_reason(unfinished_path(folder, name), reason)
      end if
      if (.not. drawn) call delete_file(unfinished_path(folder, name))
   end subroutine rename_picture

   !> Find the system's reason why a started picture ends early, which gnuplot does not report. `reason` stays if there is
   !> room.
   subroutine note_reason(path, reason)
      character(*), intent(in) :: path
      character(:), allocatable, intent(inout) :: reason
      type(identity_type) :: there
      character(:), allocatable :: found
      there = identity_of_link(path)
      if (.not. there%is_regular) return
      found = reason_of_failed_write(path)
      if (found /= '') reason = found
   end subroutine note_reason

   pure function picture_path(folder, name) result(path)
      character(*), intent(in) :: folder, name
      character(:), allocatable :: path
      path = folder//'/'//name//'.svg'
   end function picture_path

   pure function unfinished_path(folder, name) result(path)
      character(*), intent(in) :: folder, name
      character(:), allocatable :: path
      path = picture_path(folder, name)//unfinished_suffix
   end function unfinished_path

   !> True if a file is a complete picture.
   function is_whole(path) result(whole)
      character(*), intent(in) :: path
      logical :: whole
      character(len(last_mark) + 2) :: ending      ! gnuplot ends its line and leaves one empty
      integer :: unit, length, status, last
      whole = .false.
      inquire (file=path, size=length)
      if (length < len(ending)) return
      open (newunit=unit, file=path, access='stream', form='unformatted', action='read', status='old', iostat=status)
      if (status /= 0) return
      read (unit, pos=length - len(ending) + 1, iostat=status) ending
      close (unit)
      if (status /= 0) return
      last = verify(ending, new_line('a'), back=.true.)
      if (last >= len(last_mark)) whole = ending(last - len(last_mark) + 1:last) == last_mark
   end function is_whole
end module dg_picture_drawing
