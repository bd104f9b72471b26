!> Starts a program by C's posix_spawn: in one call, which is safe in a program with threads.
!> Numbers of constants are those of Linux.
module dg_posix_spawn
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_ptr
   use dg_text, only: c_text
   implicit none
   private
   public :: spawn

   !> 64-bit words for C's structures of posix_spawn: 80 and 336 bytes in the GNU C library.
   integer, parameter :: structure_size = 64
   integer, parameter :: set_group = 2                                       !< POSIX_SPAWN_SETPGROUP
   integer(c_int), parameter :: read_only = 0_c_int                          !< O_RDONLY
   integer(c_int), parameter :: rights = 438_c_int                           !< rw-rw-rw- less the umask
   integer(c_int), parameter :: append_to = 1_c_int + 64_c_int + 1024_c_int  !< O_WRONLY + O_CREAT + O_APPEND

   abstract interface
      function of_structure(structure) result(status) bind(c)
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: structure(*)
         integer(c_int) :: status
      end function of_structure
   end interface

   ! Not of a form with `value`: gfortran 12 passes such arguments of functions declared so by reference at times.
   procedure(of_structure), bind(c, name='posix_spawn_file_actions_init') :: c_actions_init
   procedure(of_structure), bind(c, name='posix_spawn_file_actions_destroy') :: c_actions_destroy
   procedure(of_structure), bind(c, name='posix_spawnattr_init') :: c_attributes_init
   procedure(of_structure), bind(c, name='posix_spawnattr_destroy') :: c_attributes_destroy

   interface
      function c_posix_spawn(process, path, actions, attributes, arguments, environment) result(status) &
         bind(c, name='posix_spawn')
         import :: c_char, c_int, c_int64_t, c_ptr
         implicit none
         integer(c_int), intent(out) :: process
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int64_t), intent(in) :: actions(*), attributes(*)
         type(c_ptr), intent(in) :: arguments(*), environment(*)
         integer(c_int) :: status
      end function c_posix_spawn

      function c_actions_chdir(actions, path) result(status) bind(c, name='posix_spawn_file_actions_addchdir_np')
         import :: c_char, c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: actions(*)
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: status
      end function c_actions_chdir

      ! mode_t is unsigned int on Linux; 0666 is the same in int
      function c_actions_open(actions, descriptor, path, flags, mode) result(status) &
         bind(c, name='posix_spawn_file_actions_addopen')
         import :: c_char, c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: actions(*)
         integer(c_int), value :: descriptor, flags, mode
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: status
      end function c_actions_open

      function c_actions_dup2(actions, from, to) result(status) bind(c, name='posix_spawn_file_actions_adddup2')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: actions(*)
         integer(c_int), value :: from, to
         integer(c_int) :: status
      end function c_actions_dup2

      ! takes a short, which C hands over in an int
      function c_attributes_set_flags(attributes, flags) result(status) bind(c, name='posix_spawnattr_setflags')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: attributes(*)
         integer(c_int), value :: flags
         integer(c_int) :: status
      end function c_attributes_set_flags
   end interface

contains

   !> Starts a program in `folder`, in a process group of its own: Ctrl-C at a terminal does not reach it. What it prints goes to
   !> the end of the file `output`. `status` is 0 or a number of errno.h.
   subroutine spawn(process, program, arguments, environment, folder, from, output, status)
      integer(c_int), intent(out) :: process                   !< its number
      character(*), intent(in) :: program                      !< from the root of the file system on
      type(c_ptr), intent(in) :: arguments(:), environment(:)  !< texts of C, then a null pointer
      character(*), intent(in) :: folder
      integer(c_int), intent(in) :: from                       !< descriptor that it reads; -1: it reads nothing
      character(*), intent(in) :: output                       !< as seen from `folder`
      integer(c_int), intent(out) :: status
      integer(c_int64_t) :: actions(structure_size), attributes(structure_size)
      integer(c_int) :: freed
      process = 0
      status = c_actions_init(actions)
      if (status == 0) status = c_attributes_init(attributes)
      if (status == 0) status = c_attributes_set_flags(attributes, set_group)     ! group 0, the default: a new one
      if (status == 0) status = c_actions_chdir(actions, c_text(folder))
      if (status == 0 .and. from >= 0) status = c_actions_dup2(actions, from, 0_c_int)
      if (status == 0 .and. from < 0) status = c_actions_open(actions, 0_c_int, c_text('/dev/null'), read_only, 0_c_int)
      if (status == 0) status = c_actions_open(actions, 1_c_int, c_text(output), append_to, rights)
      if (status == 0) status = c_actions_dup2(actions, 1_c_int, 2_c_int)
      if (status == 0) status = c_posix_spawn(process, c_text(program), actions, attributes, arguments, environment)
      freed = c_actions_destroy(actions)
      freed = c_attributes_destroy(attributes)
   end subroutine spawn
end module dg_posix_spawn
