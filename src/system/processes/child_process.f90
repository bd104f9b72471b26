!> Another program, run without a shell. It is found on PATH, and started in a folder of its own. Its output is kept in a file.
!> The program waits for it, and ends it with all processes that it has started. It does not outlive this program. POSIX calls;
!> numbers of constants are those of Linux.
module dg_child_process
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_funptr, c_int, c_loc, c_long, &
                                          c_null_char, c_null_funptr, c_null_ptr, c_ptr, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_c_calls, only: c_waitpid, c_kill, c_dlsym
   use dg_child_guard, only: end_guard, guard_type, start_guard
   use dg_error, only: error_type, raise, status_failure
   use dg_folder, only: is_executable
   use dg_interruption, only: is_interrupted
   use dg_kinds, only: wp
   use dg_posix_spawn, only: spawn
   use dg_signal_handler, only: set_handler
   use dg_system_reason, only: words_of
   use dg_text, only: c_text, text_type
   implicit none
   private
   public :: child_type, find_program, start_child, wait_for_child, end_child

   type :: child_type
      integer(c_int) :: process = 0         !< its number, and that of the group of all that it starts
      logical :: running = .false.
      type(guard_type) :: guard             !< ends it where this program is killed
      integer :: exit_status = 0            !< once it has ended; 128 + n where signal n ended it, as shells count
   end type child_type

   !> A text that C may point to.
   type :: c_string_type
      character(kind=c_char), allocatable :: chars(:)
   end type c_string_type

   !> struct timespec.
   type, bind(c) :: timespec_type
      integer(c_long) :: seconds, nanoseconds
   end type timespec_type

   !> Interval between looks at a child [ns]: far less than the start of any program takes.
   integer(c_long), parameter :: pause = 2000000_c_long
   !> Longest time for a program to end when asked to, before it is ended [s].
   real(wp), parameter :: grace = 1.0_wp
   !> Where programs are looked for when PATH is not set.
   character(*), parameter :: usual_path = '/usr/local/bin:/usr/bin:/bin'

   integer(c_int), parameter :: without_waiting = 1_c_int                  ! WNOHANG
   integer(c_int), parameter :: terminate = 15_c_int, destroy = 9_c_int    ! SIGTERM, SIGKILL
   integer(c_int), parameter :: child_has_ended = 17_c_int                 ! SIGCHLD
   !> Most entries of an environment that are looked at.
   integer, parameter :: most_variables = 1000000

   interface
      function c_nanosleep(wanted, left) result(status) bind(c, name='nanosleep')
         import :: c_int, c_ptr, timespec_type
         implicit none
         type(timespec_type), intent(in) :: wanted
         type(c_ptr), value :: left
         integer(c_int) :: status
      end function c_nanosleep

      function c_getcwd(buffer, size) result(address) bind(c, name='getcwd')
         import :: c_char, c_ptr, c_size_t
         implicit none
         character(kind=c_char), intent(inout) :: buffer(*)
         integer(c_size_t), value :: size
         type(c_ptr) :: address
      end function c_getcwd
   end interface

contains

   !> Where on PATH a program is, from the root of the file system on; '' where there is none.
   function find_program(name) result(path)
      character(*), intent(in) :: name
      character(:), allocatable :: path
      character(:), allocatable :: folders, folder
      integer :: length, status, first, last
      call get_environment_variable('PATH', length=length, status=status)
      if (status == 0 .and. length > 0) then
         allocate (character(length) :: folders)
         call get_environment_variable('PATH', value=folders)
      else
         folders = usual_path
      end if
      folders = folders//':'
      first = 1
      do while (first <= len(folders))
         last = first + index(folders(first:), ':') - 2
         folder = folders(first:last)
         first = last + 2
         if (folder == '') folder = '.'
         if (folder(1:1) /= '/') folder = current_folder()//'/'//folder
         path = folder//'/'//name
         if (is_executable(path)) return
      end do
      path = ''
   end function find_program

   !> Starts a program, given from the root of the file system on, with its arguments in `folder`. It reads nothing; what it
   !> prints goes to the end of the file `output` in that folder. It does not see variables of the environment whose names
   !> begin as one of `hidden`. Its process group is its own: Ctrl-C at a terminal does not reach it, end_child ends all of it.
   subroutine start_child(child, program, arguments, folder, output, hidden, error)
      type(child_type), intent(out) :: child
      character(*), intent(in) :: program
      type(text_type), intent(in) :: arguments(:)     !< without the program's name
      character(*), intent(in) :: folder
      character(*), intent(in) :: output
      character(*), intent(in) :: hidden(:)           !< blanks at the end of each are dropped
      type(error_type), allocatable, intent(out) :: error
      type(c_string_type), target :: texts(0:size(arguments))
      type(c_ptr) :: pointers(size(arguments) + 2)
      type(c_ptr), allocatable :: environment(:)
      type(c_funptr) :: before
      integer(c_int) :: status
      integer :: i
      texts(0)%chars = c_text(program(index(program, '/', back=.true.) + 1:))
      do i = 1, size(arguments)
         texts(i)%chars = c_text(arguments(i)%text)
      end do
      do i = 0, size(arguments)
         pointers(i + 1) = c_loc(texts(i)%chars)
      end do
      pointers(size(pointers)) = c_null_ptr
      call visible_environment(hidden, environment)
      ! under a parent that ignores it, the child's exit status would be lost
      before = set_handler(child_has_ended, c_null_funptr)
      call spawn(child%process, program, pointers, environment, folder, -1_c_int, output, status)
      child%running = status == 0
      if (child%running) call start_guard(child%guard, child%process)
      if (status /= 0) call raise(error, status_failure, 'cannot start '//program//' in '//folder//': '//words_of(status))
   end subroutine start_child

   !> Waits until the child has ended, `seconds` are over or the program is asked to end, whichever comes first.
   subroutine wait_for_child(child, seconds)
      type(child_type), intent(inout) :: child
      real(wp), intent(in) :: seconds
      call look_until(child, seconds, .true.)
   end subroutine wait_for_child

   !> Ends the child and all that it has started: asked to first, then without asking.
   subroutine end_child(child)
      type(child_type), intent(inout) :: child
      integer(c_int) :: status
      if (.not. child%running) return
      status = c_kill(-child%process, terminate)
      call look_until(child, grace, .false.)
      if (.not. child%running) return
      status = c_kill(-child%process, destroy)
      call look_until(child, grace, .false.)      ! one that waits for a dead disk is left to the system
   end subroutine end_child

   !> Looks at the child again and again. What it has left running when it ends is ended, too.
   subroutine look_until(child, seconds, heeds_signals)
      type(child_type), intent(inout) :: child
      real(wp), intent(in) :: seconds
      logical, intent(in) :: heeds_signals
      integer(c_int) :: ended, state, status
      integer(int64) :: start, now, rate
      call system_clock(start, rate)
      do while (child%running)
         state = 0
         ended = c_waitpid(child%process, state, without_waiting)
         if (ended /= 0) then
            child%running = .false.
            ! WTERMSIG in the last seven bits, WEXITSTATUS above
            child%exit_status = iand(int(state), 127)
            if (child%exit_status > 0) child%exit_status = 128 + child%exit_status
            if (child%exit_status == 0) child%exit_status = iand(ishft(int(state), -8), 255)
            status = c_kill(-child%process, destroy)
            call end_guard(child%guard)
            return
         end if
         if (heeds_signals .and. is_interrupted()) return
         call system_clock(now)
         if (real(now - start, wp) >= seconds*real(rate, wp)) return
         status = c_nanosleep(timespec_type(0_c_long, pause), c_null_ptr)
      end do
   end subroutine look_until

   !> This process's environment but for the variables whose names begin as one of `hidden`, as C takes it. The texts stay where
   !> they are.
   subroutine visible_environment(hidden, visible)
      character(*), intent(in) :: hidden(:)
      type(c_ptr), allocatable, intent(out) :: visible(:)
      type(c_ptr), pointer :: first, all(:)
      type(c_ptr) :: address
      integer :: i, k, m, n
      allocate (visible(1))
      visible = c_null_ptr
      address = c_dlsym(c_null_ptr, c_text('environ'))
      if (.not. c_associated(address)) return
      call c_f_pointer(address, first)
      if (.not. c_associated(first)) return
      call c_f_pointer(first, all, [most_variables])
      n = 0
      do while (c_associated(all(n + 1)))
         n = n + 1
         if (n == most_variables) exit
      end do
      deallocate (visible)
      allocate (visible(n + 1))
      visible = c_null_ptr
      k = 0
      do i = 1, n
         if (any([(begins_with(all(i), trim(hidden(m))), m=1, size(hidden))])) cycle
         k = k + 1
         visible(k) = all(i)
      end do
   end subroutine visible_environment

   !> True if a text of C begins with `beginning`.
   function begins_with(text, beginning) result(does)
      type(c_ptr), intent(in) :: text
      character(*), intent(in) :: beginning
      logical :: does
      character(kind=c_char), pointer :: chars(:)
      integer :: k
      call c_f_pointer(text, chars, [len(beginning)])
      does = .false.
      do k = 1, len(beginning)        ! no further than to a difference: the text may end there
         if (chars(k) /= beginning(k:k)) return
      end do
      does = .true.
   end function begins_with

   !> The folder that the program was started in; '.' where the system does not tell.
   function current_folder() result(path)
      character(:), allocatable :: path
      integer, parameter :: longest = 4096        ! PATH_MAX
      character(kind=c_char) :: buffer(longest)
      integer :: length
      path = '.'
      buffer = c_null_char
      if (.not. c_associated(c_getcwd(buffer, int(longest, c_size_t)))) return
      length = findloc(buffer, c_null_char, dim=1) - 1
      path = transfer(buffer(:length), repeat(' ', length))
   end function current_folder
end module dg_child_process
