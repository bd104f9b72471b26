!> Errors are values: a class, which the main program turns into an exit status, and a message that says
!> what is wrong, where, and what to try. No procedure below the main program stops.
module dg_error
   implicit none
   private
   public :: error_type, raise, add_error
   public :: status_ok, status_failure, status_bad_input, status_not_converged

   !> Exit statuses of the program (contract of the command line).
   integer, parameter :: status_ok = 0            !< everything asked for was solved
   integer, parameter :: status_failure = 1       !< anything not below: disk full, out of memory
   integer, parameter :: status_bad_input = 2     !< bad command line, deck or data file
   integer, parameter :: status_not_converged = 3 !< at least one case did not converge

   type :: error_type
      integer :: status = status_failure            !< one of the statuses above
      character(:), allocatable :: message          !< what, where, remedy
   end type error_type

contains

   !> Raises an error of class `status` with the whole `message`.
   pure subroutine raise(error, status, message)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: status
      character(*), intent(in) :: message
      allocate (error)
      error%status = status
      error%message = message
   end subroutine raise

   !> Adds the message of another error, if there is one, to an error that may be there.
   pure subroutine add_error(error, other)
      type(error_type), allocatable, intent(inout) :: error
      type(error_type), allocatable, intent(in) :: other
      if (.not. allocated(other)) return
      if (allocated(error)) then
         error%message = error%message//'; '//other%message
      else
         error = other
      end if
   end subroutine add_error
end module dg_error
