!> Solve a load case once more with other loads, to learn more about the first solution.
module dg_solve_again
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, is_pushed, result_converged, result_locked_up, result_not_converged
   use dg_error, only: error_type
   use dg_load_case, only: block_way
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_stopping, only: stop_type
   implicit none
   private
   public :: comes_short, solve_again

contains

   !> True for the result of a string that goes down, and locks up or needs more push than `max_push` of the rig.
   pure function comes_short(model, case_index, result) result(short)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(in) :: result
      logical :: short
      short = result%status == result_locked_up
      if (result%status == result_converged) short = is_pushed(result%hookload + model%rig%max_push, result%profile%axial)
      short = short .and. block_way(model%cases(case_index)%operation) < 0
   end function comes_short

   !> Solve a case by beams, without a profile. A refused case counts as not converged.
   subroutine solve_again(other, case_index, stop, seconds, iterations, found)
      type(model_type), intent(in) :: other               !< the model with other loads
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      real(wp), intent(inout) :: seconds                  !< of the first solution, to which those of this one are added
      integer, intent(inout) :: iterations                !< the same
      type(case_result_type), intent(out) :: found
      type(error_type), allocatable :: error
      call solve_static_analysis(other, case_index, found, error, totals_only=.true., stop=stop)
      seconds = seconds + found%seconds
      iterations = iterations + found%iterations
      if (allocated(error)) found%status = result_not_converged
   end subroutine solve_again
end module dg_solve_again
