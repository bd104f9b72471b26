!> The bit depth from which string weight is not enough, for a case that it cannot bring down.
!>
!> The soft string tells a depth, its friction fitted to the beams at the depth of the case. There the string may be coiled, or a
!> bend may be a small part of its friction. So the beams are solved at the depth told, and the friction is fitted once more.
module dg_reach_by_beams
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, is_pushed, result_converged, result_locked_up
   use dg_load_case, only: block_way, rotates
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_solve_again, only: solve_limit
   use dg_stopping, only: stop_type
   use dg_weight_on_bit, only: find_reach, friction_by_beams, matching_friction
   implicit none
   private
   public :: find_reach_by_beams

   !> Most solutions, the most iterations of each, and the change of the depth, over it, below which it is found [-]. Strings
   !> that take more iterations are told within 3 % by the soft string.
   integer, parameter :: solutions = 3, quick = 60
   real(wp), parameter :: settled = 0.01_wp

contains

   !> Set `result%weight_limits%reach` of a string that goes down without rotation, and locks up or needs more push than
   !> `max_push`. It is absent where beams find no equilibrium at the depth told, or have found another limit of the case.
   subroutine find_reach_by_beams(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(model_type) :: there
      type(case_result_type) :: found
      type(optional_real) :: told, next
      real(wp) :: scale
      integer :: i
      associate (load_case => model%cases(case_index))
         if (block_way(load_case%operation) >= 0 .or. rotates(load_case%operation)) return
         if (result%status == result_converged) then
            if (.not. is_pushed(result%hookload + model%rig%max_push, result%profile%axial)) return
         else if (result%status /= result_locked_up) then
            return
         end if
         if (result%weight_limits%friction_scale%present) return      ! the friction is that of the limit already
         call find_reach(model, case_index, told, friction_by_beams(model, result))
         there = model
         there%numerics%max_iterations = min(model%numerics%max_iterations, quick)
         do i = 1, solutions
            if (.not. told%value > 0.0_wp) return
            there%cases(case_index)%bit_depth = told%value
            call solve_limit(there, case_index, stop, result, found)
            if (found%status /= result_converged) return
            scale = matching_friction(there, case_index, load_case%wob, found%hookload)
            if (.not. scale > 0.0_wp) return
            call find_reach(model, case_index, next, scale)
            if (.not. next%present) return
            result%weight_limits%reach = next
            if (abs(next%value - told%value) < settled*told%value) return
            told = next
         end do
      end associate
   end subroutine find_reach_by_beams
end module dg_reach_by_beams
