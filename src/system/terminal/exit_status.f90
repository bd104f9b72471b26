!> The exit status of a run: the gravest of what happened.
module dg_exit_status
   use dg_diagnostic, only: report_line
   use dg_error, only: error_type, status_ok, status_failure, status_bad_input, status_not_converged
   use dg_interruption, only: interruption_name
   implicit none
   private
   public :: note_failure, note_ending, graver

contains

   !> Tells an error, if there is one, and raises the exit status by it.
   subroutine note_failure(error, status)
      type(error_type), allocatable, intent(in) :: error
      integer, intent(inout) :: status
      if (.not. allocated(error)) return
      call report_line(error%message)
      status = graver(status, error%status)
   end subroutine note_failure

   !> Tells that a signal came before something was begun, unless what it cut short has told it.
   subroutine note_ending(what, status)
      character(*), intent(in) :: what
      integer, intent(inout) :: status
      if (status /= status_failure) call report_line('ended by '//interruption_name()//' before '//what)
      status = status_failure
   end subroutine note_ending

   !> The graver of two exit statuses: failure, then bad input, then a case not converged.
   pure function graver(one, other) result(status)
      integer, intent(in) :: one, other
      integer :: status
      integer, parameter :: order(4) = [status_failure, status_bad_input, status_not_converged, status_ok]
      integer :: i
      do i = 1, size(order)
         status = order(i)
         if (one == status .or. other == status) return
      end do
   end function graver
end module dg_exit_status
