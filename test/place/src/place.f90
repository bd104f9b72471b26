!> The root of the repository, where tests read `input/` and write below `build/`. fpm starts a test program in the folder of
!> its manifest, a user wherever he stands.
module dg_place
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only: error_unit
   implicit none
   private
   public :: enter_root, absolute_path, set_variable, give_up

   !> Files that only the root has.
   character(*), parameter :: marks(2) = [character(24) :: 'input/catalogue.csv', 'test/place/fpm.toml']
   !> Folders that are looked at on the way up.
   integer, parameter :: most_steps = 12
   !> PATH_MAX of Linux.
   integer, parameter :: longest_path = 4096

   interface
      function c_chdir(path) result(status) bind(c, name='chdir')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: status
      end function c_chdir

      function c_realpath(path, resolved) result(text) bind(c, name='realpath')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         character(kind=c_char), intent(inout) :: resolved(*)
         type(c_ptr) :: text
      end function c_realpath

      function c_setenv(name, value, overwrite) result(status) bind(c, name='setenv')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: name(*), value(*)
         integer(c_int), value :: overwrite
         integer(c_int) :: status
      end function c_setenv
   end interface

contains

   !> Makes the root of the repository the working folder: the first folder above the program, or else above the working folder,
   !> that has the marks of the root. Makes `build` there for what tests write. Stops where there is no such folder.
   subroutine enter_root()
      character(:), allocatable :: root, program
      integer :: status
      program = own_name()
      root = ''
      if (index(program, '/') > 0) root = root_above(absolute_path(program(:index(program, '/', back=.true.))))
      if (root == '') root = root_above(absolute_path('.'))
      if (root == '') call give_up('neither program nor working folder is below the root of the repository, the folder with '// &
                                   trim(marks(1)))
      status = c_chdir(root//c_null_char)
      if (status /= 0) call give_up('cannot enter '//root)
      call execute_command_line('mkdir -p build && test -w build', exitstat=status)
      if (status /= 0) call give_up('cannot write to '//root//'/build')
   end subroutine enter_root

   !> A path from / on, without links; '' where there is nothing of that name.
   function absolute_path(path) result(full)
      character(*), intent(in) :: path
      character(:), allocatable :: full
      character(kind=c_char, len=longest_path) :: resolved
      full = ''
      resolved = c_null_char
      if (c_associated(c_realpath(path//c_null_char, resolved))) full = resolved(:index(resolved, c_null_char) - 1)
   end function absolute_path

   !> Sets a variable of the environment, for this program and those that it starts.
   subroutine set_variable(name, value)
      character(*), intent(in) :: name, value
      if (c_setenv(name//c_null_char, value//c_null_char, 1_c_int) /= 0) call give_up('cannot set '//name)
   end subroutine set_variable

   !> The first folder with the marks of the root, from `folder` upwards; '' where there is none.
   function root_above(folder) result(root)
      character(*), intent(in) :: folder
      character(:), allocatable :: root
      logical :: there(size(marks))
      integer :: i, step
      root = folder
      do step = 1, most_steps
         do i = 1, size(marks)
            inquire (file=root//'/'//trim(marks(i)), exist=there(i))
         end do
         if (all(there)) return
         root = root(:max(index(root, '/', back=.true.) - 1, 0))
      end do
      root = ''
   end function root_above

   !> Name by which this program was started.
   function own_name() result(name)
      character(:), allocatable :: name
      integer :: length
      call get_command_argument(0, length=length)
      allocate (character(length) :: name)
      call get_command_argument(0, value=name)
   end function own_name

   !> Ends the program with exit status 1 and the reason: nothing can be tested.
   subroutine give_up(why)
      character(*), intent(in) :: why
      write (error_unit, '(a)') why
      error stop 1
   end subroutine give_up
end module dg_place
