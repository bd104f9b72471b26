!> The bit depth from which string weight is not enough, for a case that it cannot bring down.
!>
!> The soft string estimates the depth. Its friction is fitted to the beams at the depth of the case. The string may be coiled there
!> alone, or a bend may take a larger part of the friction higher up. So the beams are solved at the estimated depth, and the
!> friction is fitted again.
module dg_reach_by_beams
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_load_case, only: rotates
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_solve_again, only: comes_short, solve_again
   use dg_stopping, only: stop_type
   use dg_weight_on_bit, only: find_reach, friction_by_beams, matching_friction
   implicit none
   private
   public :: find_reach_by_beams

   !> Most solutions, the most iterations of each, and the change of the depth, over it, below which it is found [-]. For strings
   !> that need more iterations the estimate was within 3 % of the beams.
   integer, parameter :: solutions = 3, quick = 60
   real(wp), parameter :: settled = 0.01_wp

contains

   !> Set `result%weight_limits%reach` of a string that goes down without rotation, and locks up or needs more push than
   !> `max_push`. It is absent where beams find no equilibrium at the estimated depth. It is also absent where the
   !> friction has been fitted at another limit of the case.
   subroutine find_reach_by_beams(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(model_type) :: there
      type(case_result_type) :: found
      type(optional_real) :: estimate, next
      real(wp) :: scale
      integer :: i
      associate (load_case => model%cases(case_index))
         if (rotates(load_case%operation) .or. .not. comes_short(model, case_index, result)) return
         if (result%weight_limits%friction_scale%present) return      ! the friction is that of the limit already
         call find_reach(model, case_index, estimate, friction_by_beams(model, result))
         there = model
         there%numerics%max_iterations = min(model%numerics%max_iterations, quick)
         do i = 1, solutions
            if (.not. estimate%value > 0.0_wp) return
            there%cases(case_index)%bit_depth = estimate%value
            call solve_again(there, case_index, stop, result%seconds, result%weight_limits%iterations, found)
            if (found%status /= result_converged) return
            scale = matching_friction(there, case_index, load_case%wob, found%hookload)
            if (.not. scale > 0.0_wp) return
            call find_reach(model, case_index, next, scale)
            if (.not. next%present) return
            result%weight_limits%reach = next
            if (abs(next%value - estimate%value) < settled*estimate%value) return
            estimate = next
         end do
      end associate
   end subroutine find_reach_by_beams
end module dg_reach_by_beams
