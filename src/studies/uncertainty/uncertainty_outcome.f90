!> What became of the samples of a Monte Carlo.
module dg_uncertainty_outcome
   use dg_case_result, only: result_locked_up, result_not_converged
   use dg_point_outcome, only: note_points
   use dg_run_outcome, only: add_part, outcome_type
   use dg_sweep, only: point_count
   use dg_sweep_result, only: sweep_result_type
   use dg_text, only: to_text
   use dg_uncertainty, only: piece_number, uncertainty_type
   implicit none
   private
   public :: note_uncertainty

contains

   !> The samples of a Monte Carlo that failed: a row a point. Its table and its file tell how many locked up where.
   pure subroutine note_uncertainty(outcome, uncertainty, pieces)
      type(outcome_type), intent(inout) :: outcome
      type(uncertainty_type), intent(in) :: uncertainty
      type(sweep_result_type), intent(in) :: pieces(:)     !< a point and sample each
      integer :: point, sample, lost, first
      associate (name => 'uncertainty '//uncertainty%range%name)
         call add_part(outcome, name, size(pieces), count(pieces%status == result_locked_up), &
                       count(pieces%status == result_not_converged))
         do point = 1, point_count(uncertainty%range)
            lost = 0
            first = 0
            do sample = uncertainty%samples, 1, -1
               if (pieces(piece_number(uncertainty, point, sample))%status /= result_not_converged) cycle
               lost = lost + 1
               first = sample
            end do
            if (lost > 0) call note_points(outcome, name, uncertainty%range, point, point, lost, &
                                           pieces(piece_number(uncertainty, point, first)), ' (sample '//to_text(first)//')')
         end do
      end associate
   end subroutine note_uncertainty
end module dg_uncertainty_outcome
