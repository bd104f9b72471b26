!> C's posix_spawn and what prepares it: a program is started in one call, which is safe in a program with threads.
!> Numbers of constants are those of Linux.
module dg_posix_spawn
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_ptr
   implicit none
   private
   public :: c_posix_spawn, c_actions_init, c_actions_destroy, c_actions_chdir, c_actions_open, c_actions_dup2
   public :: c_attributes_init, c_attributes_destroy, c_attributes_set_flags
   public :: structure_size, set_group, read_only, append_to

   !> 64-bit words for C's structures of posix_spawn: 80 and 336 bytes in the GNU C library.
   integer, parameter :: structure_size = 64
   integer, parameter :: set_group = 2                                       !< POSIX_SPAWN_SETPGROUP
   integer(c_int), parameter :: read_only = 0_c_int                          !< O_RDONLY
   integer(c_int), parameter :: append_to = 1_c_int + 64_c_int + 1024_c_int  !< O_WRONLY + O_CREAT + O_APPEND

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

      function c_actions_init(actions) result(status) bind(c, name='posix_spawn_file_actions_init')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: actions(*)
         integer(c_int) :: status
      end function c_actions_init

      function c_actions_destroy(actions) result(status) bind(c, name='posix_spawn_file_actions_destroy')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: actions(*)
         integer(c_int) :: status
      end function c_actions_destroy

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

      function c_attributes_init(attributes) result(status) bind(c, name='posix_spawnattr_init')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: attributes(*)
         integer(c_int) :: status
      end function c_attributes_init

      function c_attributes_destroy(attributes) result(status) bind(c, name='posix_spawnattr_destroy')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: attributes(*)
         integer(c_int) :: status
      end function c_attributes_destroy

      ! takes a short, which C hands over in an int
      function c_attributes_set_flags(attributes, flags) result(status) bind(c, name='posix_spawnattr_setflags')
         import :: c_int, c_int64_t
         implicit none
         integer(c_int64_t), intent(inout) :: attributes(*)
         integer(c_int), value :: flags
         integer(c_int) :: status
      end function c_attributes_set_flags
   end interface
end module dg_posix_spawn
