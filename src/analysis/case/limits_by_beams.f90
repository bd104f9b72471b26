!> Bit depth, friction and weight on bit with which string weight is just enough, for a case that it cannot bring down.
!>
!> The soft string estimates a limit. Its friction is fitted to the beams at the values of the case. The string may be coiled there
!> alone, or a bend may take a larger part of the friction higher up. So the beams are solved at the estimate, and the friction is
!> fitted again. The factor found at a value x leads to a better value y(x). The limit is where y(x) = x, found by the secant
!> method. In 25 wells, the first estimate of friction was 1.9 % off on average, the one found so 0.9 %.
module dg_limits_by_beams
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_contact_friction, only: scale_friction
   use dg_load_case, only: rotates
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type, string_index
   use dg_solve_again, only: comes_short, solve_again
   use dg_stopping, only: stop_type
   use dg_weight_on_bit, only: find_reach, friction_by_beams, matching_friction, most_weight_on_bit, weight_that_arrives
   implicit none
   private
   public :: find_limits_by_beams

   !> Quantities of which a limit is found: bit depth, factor on all friction, weight on bit.
   integer, parameter :: by_depth = 1, by_friction = 2, by_wob = 3
   !> Most solutions for a limit, the most iterations of each, and the change of the value, over it, below which it is found [-].
   integer, parameter :: solutions = 5, quick = 80
   real(wp), parameter :: settled = 0.01_wp
   !> Part by which a value is lowered at which beams find no equilibrium [-].
   real(wp), parameter :: lower = 0.05_wp
   !> Least and greatest change of x - y by x [-].
   real(wp), parameter :: slopes(2) = [0.5_wp, 3.0_wp]

contains

   !> Set `result%weight_limits` of a string that goes down without rotation, and locks up or needs more push than `max_push`.
   !> A limit is absent where beams find no equilibrium near its estimate.
   subroutine find_limits_by_beams(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(optional_real) :: limits(by_wob)
      integer :: quantity
      associate (load_case => model%cases(case_index))
         if (rotates(load_case%operation) .or. .not. comes_short(model, case_index, result)) return
         if (result%weight_limits%friction_scale%present) return      ! the friction is that of the limit already
         do quantity = by_depth, merge(by_wob, by_friction, load_case%wob > 0.0_wp)
            call find_limit(model, case_index, quantity, stop, result, limits(quantity))
         end do
      end associate
      result%weight_limits%reach = limits(by_depth)
      result%weight_limits%friction = limits(by_friction)
      result%weight_limits%wob = limits(by_wob)
   end subroutine find_limits_by_beams

   !> Find one limit [m, - or N].
   subroutine find_limit(model, case_index, quantity, stop, result, limit)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, quantity
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(optional_real), intent(out) :: limit
      type(model_type) :: there
      type(case_result_type) :: found
      real(wp) :: x, y, x_before, y_before, better, low, high, scale
      integer :: i
      if (quantity == by_wob) then
         x = weight_that_arrives(model, result)
      else
         x = estimate(model, case_index, quantity, friction_by_beams(model, result))
      end if
      low = 0.0_wp           ! enough weight here
      high = huge(high)      ! not enough here
      do i = 1, solutions
         if (.not. x > 0.0_wp) return
         there = at_value(model, case_index, quantity, x)
         call solve_again(there, case_index, stop, result%seconds, result%weight_limits%iterations, found)
         select case (found%status)
         case (result_converged)
            scale = matching_friction(there, case_index, there%cases(case_index)%wob, found%hookload)
            if (.not. scale > 0.0_wp) return
            y = estimate(model, case_index, quantity, scale)
            if (.not. y > 0.0_wp) return
            better = y
            if (limit%present) better = next_value(x, y, x_before, y_before)
            if (y > x) low = x
            if (y <= x) high = x
            x_before = x
            y_before = y
         case (result_locked_up)
            better = (1.0_wp - lower)*x
            high = x
         case default
            if (i > 1 .or. quantity == by_depth) return
            better = (1.0_wp - lower)*x
         end select
         if (better <= low .or. better >= high) better = 0.5_wp*(low + high)
         if (found%status == result_converged .or. limit%present) limit = given(better)
         if (limit%present .and. abs(better - x) < settled*x) return
         x = better
      end do
   end subroutine find_limit

   !> The model with a value of a limit.
   pure function at_value(model, case_index, quantity, x) result(there)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, quantity
      real(wp), intent(in) :: x           !< [m, - or N]
      type(model_type) :: there
      integer :: string
      there = model
      there%numerics%max_iterations = min(model%numerics%max_iterations, quick)
      select case (quantity)
      case (by_depth)
         there%cases(case_index)%bit_depth = x
      case (by_friction)
         string = string_index(model%strings, model%cases(case_index)%string)
         call scale_friction(x, there%strings(string)%components)
      case default
         there%cases(case_index)%wob = x
      end select
   end function at_value

   !> A limit by the soft string, whose friction is multiplied by a factor [m, - or N]; 0 if it finds none.
   pure function estimate(model, case_index, quantity, scale) result(value)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, quantity
      real(wp), intent(in) :: scale       !< [-]
      real(wp) :: value
      type(optional_real) :: depth
      select case (quantity)
      case (by_depth)
         call find_reach(model, case_index, depth, scale)
         value = depth%value
      case (by_friction)
         value = matching_friction(model, case_index, model%cases(case_index)%wob, -model%rig%max_push)/scale
      case default
         value = most_weight_on_bit(model, case_index, coiled=.true., pushed=.false., friction_scale=scale)
      end select
   end function estimate

   !> Where x - y is 0 by the secant through two pairs, within bounds of its slope.
   pure function next_value(x, y, x_before, y_before) result(next)
      real(wp), intent(in) :: x, y, x_before, y_before
      real(wp) :: next
      real(wp) :: slope
      slope = ((x - y) - (x_before - y_before))/(x - x_before)
      next = x - (x - y)/min(max(slope, slopes(1)), slopes(2))
   end function next_value
end module dg_limits_by_beams
