!> Eccentric stabilizers. In a horizontal hole without friction equal spans L of collars lie on stabilizers: a beam over many
!> supports, the bit its end. The lowest stabilizer's blades stand off the axis of the string by e. The axis is then e off there,
!> the other way, as at a support that has moved. Clapeyron's equation of three moments, M = EI y'', with the functions of
!> Timoshenko and Gere (Theory of Elastic Stability, 1961, 1.11) of a weight on bit P, z = L sqrt(P/EI),
!>
!>   phi M_(i-1) + 4 psi M_i + phi M_(i+1) = 6 EI (y_(i-1) - 2 y_i + y_(i+1))/L^2,
!>   psi = 3 (1/z - cot z)/z,   phi = 6 (1/sin z - 1/z)/z,   both 1 without P,
!>
!> gives M_1: beyond, each moment is r times the one before, phi r^2 + 4 psi r + phi = 0. The bit presses the formation with
!> (M_1 - P e)/L away from the offset. Blades on the low side are a fulcrum: the assembly builds.
module dg_test_eccentric_blades
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type, tube_inertia
   use dg_constants, only: degree
   use dg_drillstring, only: drillstring_type
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_rotate_off_bottom, operation_sliding_drilling, operation_static
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_three_points, only: three_point_dogleg
   use dg_test_wells, only: steel
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: eccentric_blades_suite

   integer, parameter :: spans = 8
   real(wp), parameter :: span = 6.0_wp, blade = 2.0e-3_wp, od = 0.1651_wp, id = 0.0714_wp, hole = 0.2159_wp, clearance = 0.001_wp
   real(wp), parameter :: depth = 150.0_wp, off = 0.008_wp
   real(wp), parameter :: weight = 20.0e3_wp, out_of_balance = 3.0e-5_wp   !< of a span [N], [-]
   !> Blades have a length. On a rigid wall a level one bears a couple, up to half its length times its force.
   real(wp), parameter :: close = 5.0e-3_wp

contains

   function eccentric_blades_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('eccentric_blades')
      call suite%addTest(TestMethod('three_moments', test_three_moments))
      call suite%addTest(TestMethod('moment_at_the_blades', test_moment))
      call suite%addTest(TestMethod('turned_by_toolface', test_toolface))
      call suite%addTest(TestMethod('to_the_right', test_right))
      call suite%addTest(TestMethod('string_that_turns', test_turning))
      call suite%addTest(TestMethod('three_points', test_three_points))
      call suite%addTest(TestMethod('inclinations_and_weight_on_bit', test_inclinations))
   end function eccentric_blades_suite

   !> The string on its stabilizers, the lowest of them eccentric.
   subroutine solve(offset, clock, case, moments, result, inclination)
      real(wp), intent(in) :: offset, clock     !< [m, rad]
      type(load_case_type), intent(in) :: case  !< operation, toolface, weight on bit
      logical, intent(in) :: moments            !< the string is bent again on short elements
      type(case_result_type), intent(out) :: result
      real(wp), intent(in), optional :: inclination   !< absent: horizontal [rad]
      type(model_type) :: model
      type(error_type), allocatable :: error
      real(wp) :: inclined
      integer :: i
      inclined = 90.0_wp*degree
      if (present(inclination)) inclined = inclination
      call new_trajectory(model%trajectory, [0.0_wp, depth], [inclined, inclined], [0.0_wp, 0.0_wp], &
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
      model%strings(1)%components(2)%blade_offset = offset
      model%strings(1)%components(2)%blade_clock = clock
      model%mud = standing_mud(0.0_wp)
      model%numerics%moments = moments
      model%cases(1) = case
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      call solve_static_analysis(model, 1, result, error)
      call assertFalse(allocated(error))
      call assertEqual(result_converged, result%status)
      call assertTrue(result%equilibrium_force < out_of_balance*max(case%wob, weight))
   end subroutine solve

   pure function static_case(toolface) result(case)
      real(wp), intent(in) :: toolface     !< [rad]
      type(load_case_type) :: case
      case%operation = operation_static
      case%toolface = toolface
   end function static_case

   !> Side force of the bit towards the high side [N].
   pure function upwards(result) result(force_up)
      type(case_result_type), intent(in) :: result
      real(wp) :: force_up
      force_up = result%bit_side_force*cos(result%bit_side_clock)
   end function upwards

   !> M_1 [N.m].
   pure function moment_by_formula(wob) result(moment)
      real(wp), intent(in) :: wob          !< P [N]
      real(wp) :: moment
      real(wp) :: psi, phi, ratio, beyond, ei, z
      type(component_type) :: part
      ei = part%youngs*tube_inertia(od, id)
      psi = 1.0_wp
      phi = 1.0_wp
      z = span*sqrt(wob/ei)
      if (z > 0.0_wp) then
         psi = 3.0_wp*(1.0_wp/z - 1.0_wp/tan(z))/z
         phi = 6.0_wp*(1.0_wp/sin(z) - 1.0_wp/z)/z
      end if
      ratio = sqrt((2.0_wp*psi/phi)**2 - 1.0_wp) - 2.0_wp*psi/phi
      beyond = 4.0_wp*psi + phi*ratio
      moment = ei*off/span**2*(12.0_wp + 6.0_wp*phi/beyond)/(4.0_wp*psi - phi**2/beyond)
   end function moment_by_formula

   !> Force with which the bit presses away from the offset [N].
   pure function force_by_formula(wob) result(force)
      real(wp), intent(in) :: wob          !< P [N]
      real(wp) :: force
      force = (moment_by_formula(wob) - wob*off)/span
   end function force_by_formula

   !> By the iteration alone, and by the short elements.
   subroutine test_three_moments()
      type(case_result_type) :: centred, eccentric
      real(wp), parameter :: clocks(2) = [0.0_wp, 180.0_wp]*degree
      integer :: i, beam
      do beam = 1, 2
         call solve(0.0_wp, 0.0_wp, static_case(0.0_wp), beam == 2, centred)
         do i = 1, size(clocks)
            call solve(off, clocks(i), static_case(0.0_wp), beam == 2, eccentric)
            call assertRelativelyEqual(-cos(clocks(i))*force_by_formula(0.0_wp), upwards(eccentric) - upwards(centred), close)
         end do
      end do
   end subroutine test_three_moments

   !> On the low side they lift the string: the moment of its weight there grows.
   subroutine test_moment()
      type(case_result_type) :: centred, eccentric
      call solve(0.0_wp, 0.0_wp, static_case(0.0_wp), .true., centred)
      call solve(off, 180.0_wp*degree, static_case(0.0_wp), .true., eccentric)
      call assertRelativelyEqual(moment_by_formula(0.0_wp), at_blades(eccentric) - at_blades(centred), 2.0_wp*close)
   contains
      pure function at_blades(result) result(moment)
         type(case_result_type), intent(in) :: result
         real(wp) :: moment
         moment = result%profile%bending(minloc(abs(result%profile%md - (depth - span)), dim=1))
      end function at_blades
   end subroutine test_moment

   !> The clock angle counts from the tool face.
   subroutine test_toolface()
      type(case_result_type) :: by_clock, by_both
      call solve(off, 180.0_wp*degree, static_case(0.0_wp), .true., by_clock)
      call solve(off, 60.0_wp*degree, static_case(120.0_wp*degree), .true., by_both)
      call assertRelativelyEqual(upwards(by_clock), upwards(by_both), 1.0e-6_wp)
   end subroutine test_toolface

   !> Clockwise looking down the hole: blades to the right press the bit to the left. They roll on the low side as they do.
   subroutine test_right()
      type(case_result_type) :: eccentric
      real(wp) :: to_the_left
      call solve(off, 90.0_wp*degree, static_case(0.0_wp), .true., eccentric)
      to_the_left = -eccentric%bit_side_force*sin(eccentric%bit_side_clock)
      call assertTrue(to_the_left > 0.8_wp*force_by_formula(0.0_wp) .and. to_the_left < 1.1_wp*force_by_formula(0.0_wp))
   end subroutine test_right

   !> A string that turns is solved with centred blades.
   subroutine test_turning()
      type(case_result_type) :: centred, turning
      type(load_case_type) :: case
      case%operation = operation_rotate_off_bottom
      call solve(0.0_wp, 0.0_wp, case, .true., centred)
      call solve(off, 180.0_wp*degree, case, .true., turning)
      call assertEqual(upwards(centred), upwards(turning), 1.0e-9_wp)
   end subroutine test_turning

   !> Dogleg by three points. Blades below the bend that stand off towards the tool face, or blades above that stand off from it,
   !> leave the axis as much room as smaller ones in the middle.
   subroutine test_three_points()
      real(wp) :: doglegs(2)
      integer :: blades
      do blades = 2, 4, 2
         doglegs(1) = dogleg(blades, clock=merge(0.0_wp, 180.0_wp*degree, blades == 2), offset=0.003_wp, smaller=0.0_wp)
         doglegs(2) = dogleg(blades, clock=0.0_wp, offset=0.0_wp, smaller=0.006_wp)
         call assertRelativelyEqual(doglegs(2), doglegs(1), 1.0e-12_wp)
         call assertTrue(doglegs(1) < 0.99_wp*dogleg(blades, clock=0.0_wp, offset=0.0_wp, smaller=0.0_wp))
      end do
   contains
      !> Bit, blades, bend, blades, by their numbers in the string.
      function dogleg(changed, clock, offset, smaller)
         integer, intent(in) :: changed
         real(wp), intent(in) :: clock, offset, smaller   !< of the changed blades [rad, m, m]
         real(wp) :: dogleg
         type(drillstring_type) :: string
         allocate (string%components(5))
         string%components = [steel('collar', 0.5_wp, od, id), steel('stabilizer', 0.3_wp, od, id), &
                              steel('collar', 6.0_wp, od, id), steel('stabilizer', 0.3_wp, od, id), &
                              steel('collar', 0.0_wp, od, id)]
         string%components([2, 4])%joint_od = hole - 2.0_wp*clearance
         string%components(changed)%joint_od = hole - 2.0_wp*clearance - smaller
         string%components(changed)%blade_offset = offset
         string%components(changed)%blade_clock = clock
         string%components(3)%bend = 1.5_wp*degree
         string%components(3)%bend_position = 0.8_wp
         dogleg = three_point_dogleg(string, depth, hole)
      end function dogleg
   end subroutine test_three_points

   !> Sliding under weight on bit, from a vertical to a horizontal hole. In steep holes the blades lift the string off those above,
   !> and the bit presses less.
   subroutine test_inclinations()
      type(case_result_type) :: centred, eccentric
      type(load_case_type) :: case
      real(wp) :: share
      integer :: i
      case%operation = operation_sliding_drilling
      case%wob = 100.0e3_wp
      do i = 0, 6
         call solve(0.0_wp, 0.0_wp, case, .true., centred, inclination=15.0_wp*i*degree)
         call solve(off, 180.0_wp*degree, case, .true., eccentric, inclination=15.0_wp*i*degree)
         share = (upwards(eccentric) - upwards(centred))/force_by_formula(case%wob)
         call assertTrue(eccentric%iterations < 60)
         call assertTrue(share < 1.01_wp .and. share > merge(0.7_wp, 0.99_wp, i < 2))
      end do
   end subroutine test_inclinations
end module dg_test_eccentric_blades
