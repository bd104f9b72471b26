!> Solve a load case once more with other loads, to learn more about the first solution.
module dg_solve_again
   use dg_case_result, only: case_result_type, is_pushed, result_converged, result_locked_up, result_not_converged
   use dg_error, only: error_type
   use dg_load_case, only: block_way
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_stopping, only: stop_type
   implicit none
   private
   public :: comes_short, solve_again, solve_limit

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

   !> Solve a case by beams, without a profile. Its iterations and seconds are added to `result`.
   subroutine solve_again(other, case_index, stop, result, found)
      type(model_type), intent(in) :: other               !< the model with other loads
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result     !< first solution, whose iterations and seconds grow
      type(case_result_type), intent(out) :: found
      call solve_totals(other, case_index, stop, result, found)
      result%iterations = result%iterations + found%iterations
   end subroutine solve_again

   !> The same for a limit of a case. Iterations count as those of the limits.
   subroutine solve_limit(other, case_index, stop, result, found)
      type(model_type), intent(in) :: other
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(case_result_type), intent(out) :: found
      call solve_totals(other, case_index, stop, result, found)
      result%weight_limits%iterations = result%weight_limits%iterations + found%iterations
   end subroutine solve_limit

   !> Solve a case and add its seconds to `result`. A refused case counts as not converged.
   subroutine solve_totals(other, case_index, stop, result, found)
      type(model_type), intent(in) :: other
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(case_result_type), intent(out) :: found
      type(error_type), allocatable :: error
      call solve_static_analysis(other, case_index, found, error, totals_only=.true., stop=stop)
      result%seconds = result%seconds + found%seconds
      if (allocated(error)) found%status = result_not_converged
   end subroutine solve_totals
end module dg_solve_again
