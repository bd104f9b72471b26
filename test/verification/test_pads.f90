!> Pads of a push-the-bit tool. In a horizontal hole without friction equal spans of collars lie on stabilizers: a beam over many
!> supports, the bit its end. A pad between the bit and the first stabilizer changes what its weight does by what Clapeyron's
!> equation of three moments says: with F at a distance a from the bit, spans L and moments that fall by 2 - sqrt(3) from one
!> support to the next, the bit presses on the formation with F (1 - a/L - a (L^2 - a^2)/((2 + sqrt(3)) L^3)).
module dg_test_pads
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_static
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: steel
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: pads_suite

   integer, parameter :: spans = 8
   real(wp), parameter :: span = 10.0_wp, blade = 2.0e-3_wp, od = 0.1651_wp, id = 0.0714_wp, hole = 0.2159_wp, clearance = 0.001_wp
   real(wp), parameter :: depth = 300.0_wp, force = 4000.0_wp
   !> Blades have a length. On a rigid wall a level one bears a couple, up to half its length times its force.
   real(wp), parameter :: close = 5.0e-3_wp

contains

   function pads_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('pads')
      call suite%addTest(TestMethod('three_moments', test_three_moments))
      call suite%addTest(TestMethod('forces_balance', test_balance))
      call suite%addTest(TestMethod('string_that_turns', test_turning))
      call suite%addTest(TestMethod('to_the_right', test_right))
   end function pads_suite

   !> The string on its stabilizers, pushed at a part of the first span.
   subroutine solve(part, clock, push, operation, result)
      real(wp), intent(in) :: part         !< of the span, from the bit [-]
      real(wp), intent(in) :: clock, push  !< [rad, N]
      integer, intent(in) :: operation
      type(case_result_type), intent(out) :: result
      type(model_type) :: model
      type(error_type), allocatable :: error
      integer :: i
      call new_trajectory(model%trajectory, [0.0_wp, depth], [90.0_wp, 90.0_wp]*degree, [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depth, hole, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(2*spans + 1))
      do i = 1, spans
         model%strings(1)%components(2*i - 1) = steel('collar', span - blade, od, id)
         model%strings(1)%components(2*i) = steel('stabilizer', blade, od, id)
         model%strings(1)%components(2*i)%joint_od = hole - 2.0_wp*clearance
      end do
      model%strings(1)%components(1)%length = span - 0.5_wp*blade
      model%strings(1)%components(2*spans + 1) = steel('collar', 0.0_wp, od, id)
      model%strings(1)%components(1)%pad_force = push
      model%strings(1)%components(1)%pad_clock = clock
      model%strings(1)%components(1)%pad_position = part*span
      model%mud = standing_mud(0.0_wp)
      model%numerics%moments = .true.
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation
      call solve_static_analysis(model, 1, result, error)
      call assertFalse(allocated(error))
      call assertEqual(result_converged, result%status)
   end subroutine solve

   !> Side force of the bit towards the high side [N].
   pure function upwards(result) result(force_up)
      type(case_result_type), intent(in) :: result
      real(wp) :: force_up
      force_up = result%bit_side_force*cos(result%bit_side_clock)
   end function upwards

   !> Share of the pads' force with which the bit presses.
   pure function by_formula(part) result(share)
      real(wp), intent(in) :: part         !< a/L [-]
      real(wp) :: share
      share = 1.0_wp - part - part*(1.0_wp - part**2)/(2.0_wp + sqrt(3.0_wp))
   end function by_formula

   subroutine test_three_moments()
      type(case_result_type) :: still, pushed
      real(wp), parameter :: parts(3) = [0.1_wp, 0.25_wp, 0.5_wp], clocks(3) = [0.0_wp, 180.0_wp, 0.0_wp]*degree
      integer :: i
      call solve(0.5_wp, 0.0_wp, 0.0_wp, operation_static, still)
      do i = 1, size(parts)
         call solve(parts(i), clocks(i), force, operation_static, pushed)
         call assertRelativelyEqual(cos(clocks(i))*force*by_formula(parts(i)), upwards(pushed) - upwards(still), close)
      end do
   end subroutine test_three_moments

   !> Compare the part of the pads' force that the bit does not take with the relief of the stabilizers on the low side.
   subroutine test_balance()
      type(case_result_type) :: still, pushed
      call solve(0.5_wp, 0.0_wp, 0.0_wp, operation_static, still)
      call solve(0.5_wp, 0.0_wp, force, operation_static, pushed)
      call assertTrue(pushed%equilibrium_force < 1.0_wp .and. pushed%equilibrium_moment < 100.0_wp)
      call assertEqual(force, upwards(pushed) - upwards(still) + still%normal_force - pushed%normal_force, close*force)
   end subroutine test_balance

   !> The direction stays while the string turns.
   subroutine test_turning()
      type(case_result_type) :: still, turning
      call solve(0.25_wp, 0.0_wp, force, operation_static, still)
      call solve(0.25_wp, 0.0_wp, force, operation_rotate_off_bottom, turning)
      call assertRelativelyEqual(upwards(still), upwards(turning), 1.0e-4_wp)
   end subroutine test_turning

   !> Clockwise looking down the hole. Across the plane of the weight the blades roll on the wall, and the bit takes more.
   subroutine test_right()
      type(case_result_type) :: pushed
      call solve(0.25_wp, 90.0_wp*degree, force, operation_static, pushed)
      call assertTrue(pushed%bit_side_force*sin(pushed%bit_side_clock) > (1.0_wp - close)*force*by_formula(0.25_wp))
   end subroutine test_right
end module dg_test_pads
