!> A guard of a process group: a shell that waits at a pipe from this program. When this program ends, by whatever signal, the
!> system closes the pipe, and the shell kills the group. No signal handler could do that: nothing runs after SIGKILL.
module dg_child_guard
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_loc, c_null_ptr, c_ptr
   use dg_c_calls, only: c_kill, c_waitpid
   use dg_posix_spawn, only: spawn
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
   end interface

contains

   !> Starts a guard of a process group. Where that fails the group goes unguarded.
   subroutine start_guard(guard, group)
      type(guard_type), intent(out) :: guard
      integer(c_int), intent(in) :: group
      character(kind=c_char), allocatable, target :: name(:), option(:), command(:), number(:)
      type(c_ptr) :: arguments(6), environment(1)
      integer(c_int) :: ends(2), status, freed
      if (c_pipe2(ends, close_on_exec) /= 0) return
      name = c_text('drillgap_guard')
      option = c_text('-c')
      command = c_text(script)
      number = c_text(to_text(int(group)))
      arguments = [c_loc(name), c_loc(option), c_loc(command), c_loc(name), c_loc(number), c_null_ptr]
      environment = c_null_ptr
      ! the end of the guarded group does not reach it
      call spawn(guard%process, shell, arguments, environment, '/', ends(1), '/dev/null', status)
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
