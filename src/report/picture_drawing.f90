!> Has gnuplot draw the scripts of pictures. A picture is drawn under another name and gets its own once it is whole.
module dg_picture_drawing
   use dg_child_process, only: child_type, end_child, start_child, wait_for_child
   use dg_error, only: error_type, raise, status_failure
   use dg_file_system, only: delete_file, rename_file, unfinished_suffix
   use dg_gnuplot_script, only: ending_variable, spelled
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_kinds, only: wp
   use dg_text, only: append_text, text_type, to_text
   implicit none
   private
   public :: draw_pictures, complaint_file, usual_patience

   !> How long gnuplot may draw without beginning another picture [s]: it takes 10 ms for one of 1000 rows and two minutes for one
   !> of four million, on a slow machine twice that.
   real(wp), parameter :: usual_patience = 300.0_wp
   !> Where gnuplot complains; kept only where it failed.
   character(*), parameter :: complaint_file = 'gnuplot.log'
   !> Variables of the environment that change what gnuplot does: its terminal, its start, where it looks for scripts and fonts.
   character(*), parameter :: hidden_variables(2) = [character(4) :: 'GNU', 'FIT_']
   !> What a whole picture ends in.
   character(*), parameter :: last_mark = '</svg>'

   ! How a gnuplot ended.
   integer, parameter :: ended_well = 0, ended_badly = 1, silent = 2, interrupted = 3, not_started = 4

contains

   !> Draws `<name>.svg` by `<name>.gp` for all names in the folder: all by one gnuplot with the script `whole`; where that fails
   !> each by one of its own, so that one that cannot be drawn takes no other along. Pictures of an earlier run go first, so that
   !> what is there is of this one. `error` where not all are drawn, or where the program was asked to end.
   subroutine draw_pictures(gnuplot, folder, names, whole, patience, drawn, error)
      character(*), intent(in) :: gnuplot          !< the program, from the root of the file system on; '': none, nothing is drawn
      character(*), intent(in) :: folder
      type(text_type), intent(in) :: names(:)
      character(*), intent(in) :: whole            !< script that draws all, without ending
      real(wp), intent(in) :: patience             !< usual_patience [s]; tests have less
      logical, intent(out) :: drawn(:)             !< as many
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: done
      integer :: i, outcome, bad
      drawn = .false.
      do i = 1, size(names)
         call delete_file(final_name(i))
         call delete_file(unfinished_name(i))
      end do
      call delete_file(folder//'/'//complaint_file)
      if (gnuplot == '') return
      call run_gnuplot(gnuplot, folder, whole, names, patience, outcome, error)
      if (outcome == ended_badly) then
         do i = 1, size(names)
            call delete_file(unfinished_name(i))       ! a script that failed may have left one that looks whole
         end do
         do i = 1, size(names)
            call run_gnuplot(gnuplot, folder, names(i)%text, names(i:i), patience, outcome, error)
            if (outcome == ended_well) then
               call take(i)
            else
               call delete_file(unfinished_name(i))
               if (outcome /= ended_badly) exit
            end if
         end do
      else
         do i = 1, size(names)
            call take(i)
         end do
      end if
      if (allocated(error)) return
      done = to_text(count(drawn))//' of '//to_text(size(drawn))//' pictures in '//folder//' are drawn'
      bad = findloc(drawn, .false., dim=1)
      if (is_interrupted()) then
         call delete_file(folder//'/'//complaint_file)
         call raise(error, status_failure, 'ended by '//interruption_name()//': '//done)
      else if (bad == 0) then
         call delete_file(folder//'/'//complaint_file)
      else if (outcome == silent) then
         call raise(error, status_failure, gnuplot//' drew nothing for '//to_text(patience)//' s and was ended: '//done// &
                    '; does it draw '//names(bad)%text//'.gp there when you run it yourself?')
      else
         call raise(error, status_failure, 'gnuplot failed: '//done//', '//names(bad)%text//' is not; '//complaint_file// &
                    ' there tells why')
      end if

   contains

      function final_name(i) result(path)
         integer, intent(in) :: i
         character(:), allocatable :: path
         path = folder//'/'//names(i)%text//'.svg'
      end function final_name

      function unfinished_name(i) result(path)
         integer, intent(in) :: i
         character(:), allocatable :: path
         path = final_name(i)//unfinished_suffix
      end function unfinished_name

      !> Gives a picture its own name if it is whole.
      subroutine take(i)
         integer, intent(in) :: i
         type(error_type), allocatable :: failure
         if (is_whole(unfinished_name(i))) then
            call rename_file(unfinished_name(i), final_name(i), failure)
            drawn(i) = .not. allocated(failure)
         end if
         if (.not. drawn(i)) call delete_file(unfinished_name(i))
      end subroutine take
   end subroutine draw_pictures

   !> Runs gnuplot on a script until it ends, the program is asked to end, or no other picture is begun for too long.
   subroutine run_gnuplot(gnuplot, folder, script, names, patience, outcome, error)
      character(*), intent(in) :: gnuplot, folder
      character(*), intent(in) :: script                !< without ending
      type(text_type), intent(in) :: names(:)           !< pictures that it draws
      real(wp), intent(in) :: patience
      integer, intent(out) :: outcome                   !< ended_well, ...
      type(error_type), allocatable, intent(out) :: error
      type(child_type) :: child
      type(text_type), allocatable :: arguments(:)
      integer :: begun, before, i
      logical :: is
      call append_text(arguments, '-d')                 ! without the user's own settings
      call append_text(arguments, '-e')
      call append_text(arguments, ending_variable//' = '//spelled(unfinished_suffix))
      call append_text(arguments, script//'.gp')
      call start_child(child, gnuplot, arguments, folder, complaint_file, hidden_variables, error)
      outcome = not_started
      if (allocated(error)) return
      begun = 0
      do
         call wait_for_child(child, patience)
         if (.not. child%running .or. is_interrupted()) exit
         before = begun
         begun = 0
         do i = 1, size(names)
            inquire (file=folder//'/'//names(i)%text//'.svg'//unfinished_suffix, exist=is)
            if (is) begun = begun + 1
         end do
         if (begun == before) exit
      end do
      if (is_interrupted()) then
         outcome = interrupted
      else if (child%running) then
         outcome = silent
      else if (child%exit_status == 0) then
         outcome = ended_well
      else
         outcome = ended_badly
      end if
      call end_child(child)
   end subroutine run_gnuplot

   !> Whether a file is a whole picture.
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
