!> Weight on bit that a string which must be pushed, or locks up, brings down by itself.
module dg_arriving_weight
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_locked_up
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_weight_on_bit, only: most_weight_on_bit
   implicit none
   private
   public :: weight_that_arrives

contains

   !> Largest weight on bit that string weight brings [N], with the friction of coils and the factor that beams have beside the soft
   !> string; not more than beams bear of a string that locks up.
   pure function weight_that_arrives(model, result) result(most)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      real(wp) :: most
      most = most_weight_on_bit(model, result%case_index, coiled=.true., pushed=.false., &
                                friction_scale=result%without_load%friction_scale)
      if (result%status == result_locked_up .and. .not. is_missing(result%lock_up_load)) &
         most = min(most, max(result%lock_up_load, 0.0_wp))
   end function weight_that_arrives
end module dg_arriving_weight
