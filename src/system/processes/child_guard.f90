!> A guard of a process group: a shell that waits at a pipe from this program. When this program ends, by whatever signal, the
!> system closes the pipe, and the shell kills the group. No signal handler could do that: nothing runs after SIGKILL.
module dg_child_guard
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
   use dg_posix_spawn, only: append_to, c_actions_chdir, c_actions_destroy, c_actions_dup2, c_actions_init, c_actions_open, &
                             c_attributes_destroy, c_attributes_init, c_attributes_set_flags, c_posix_spawn, set_group, &
                             structure_size
   use dg_text, only: c_text, to_text
   implicit none
   private
   public :: guard_type, start_guard, end_guard

   type :: guard_type
      private
      integer(c_int) :: process = 0         !< its number; 0: no guard
      integer(c_int) :: pipe_end = -1       !< descriptor that this program holds open
   end type guard_type

   character(*), parameter :: shell = '/bin/sh'
   !> Waits for the end of the pipe, then kills the group whose number is the argument.
   character(*), parameter :: script = 'read -r line; kill -s KILL -- "-$1"'
   integer(c_int), parameter :: close_on_exec = 524288_c_int      ! O_CLOEXEC
   integer(c_int), parameter :: destroy = 9_c_int                 ! SIGKILL

   interface
      function c_pipe2(ends, flags) result(status) bind(c, name='pipe2')
         import :: c_int
         implicit none
         integer(c_int), intent(out) :: ends(2)
         integer(c_int), value :: flags
         integer(c_int) :: status
      end function c_pipe2

      function c_close(descriptor) result(status) bind(c, name='close')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: status
      end function c_close

      function c_kill(process, signal) result(status) bind(c, name='kill')
         import :: c_int
         implicit none
         integer(c_int), value :: process, signal
         integer(c_int) :: status
      end function c_kill

      function c_waitpid(process, status, options) result(ended) bind(c, name='waitpid')
         import :: c_int
         implicit none
         integer(c_int), value :: process, options
         integer(c_int), intent(inout) :: status
         integer(c_int) :: ended
      end function c_waitpid
   end interface

contains

   !> Starts a guard of a process group. Where that fails the group goes unguarded.
   subroutine start_guard(guard, group)
      type(guard_type), intent(out) :: guard
      integer(c_int), intent(in) :: group
      character(kind=c_char), allocatable, target :: name(:), option(:), command(:), number(:)
      type(c_ptr) :: arguments(6), environment(1)
      integer(c_int64_t) :: actions(structure_size), attributes(structure_size)
      integer(c_int) :: ends(2), status, freed
      if (c_pipe2(ends, close_on_exec) /= 0) return
      name = c_text('drillgap_guard')
      option = c_text('-c')
      command = c_text(script)
      number = c_text(to_text(int(group)))
      arguments = [c_loc(name), c_loc(option), c_loc(command), c_loc(name), c_loc(number), c_null_ptr]
      environment = c_null_ptr
      status = c_actions_init(actions)
      if (status == 0) status = c_attributes_init(attributes)
      ! a group of its own: Ctrl-C at a terminal and the end of the guarded group do not reach it
      if (status == 0) status = c_attributes_set_flags(attributes, set_group)
      if (status == 0) status = c_actions_chdir(actions, c_text('/'))
      if (status == 0) status = c_actions_dup2(actions, ends(1), 0_c_int)
      if (status == 0) status = c_actions_open(actions, 1_c_int, c_text('/dev/null'), append_to, 0_c_int)
      if (status == 0) status = c_actions_dup2(actions, 1_c_int, 2_c_int)
      if (status == 0) status = c_posix_spawn(guard%process, c_text(shell), actions, attributes, arguments, environment)
      freed = c_actions_destroy(actions)
      freed = c_attributes_destroy(attributes)
      freed = c_close(ends(1))
      if (status == 0) then
         guard%pipe_end = ends(2)
      else
         guard%process = 0
         freed = c_close(ends(2))
      end if
   end subroutine start_guard

   !> Ends the guard before it acts: its group has ended.
   subroutine end_guard(guard)
      type(guard_type), intent(inout) :: guard
      integer(c_int) :: state, status
      if (guard%process == 0) return
      status = c_kill(guard%process, destroy)
      state = 0
      status = c_waitpid(guard%process, state, 0_c_int)
      status = c_close(guard%pipe_end)
      guard%process = 0
      guard%pipe_end = -1
   end subroutine end_guard
end module dg_child_guard
