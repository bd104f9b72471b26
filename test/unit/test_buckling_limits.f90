!> Published buckling limits.
module dg_test_buckling_limits
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_buckling_limits, only: buckled_state, buckling_helical, buckling_none, buckling_sinusoidal, curved_limit, &
                                 helical_high, helical_limit, helical_low, lubinski_first, sinusoidal_limit, vertical_unit
   use dg_component, only: tube_inertia
   use dg_constants, only: degree
   use dg_kinds, only: wp
   implicit none
   private
   public :: buckling_limits_suite

   !> Wicks et al. 2008: a steel pipe 140 x 116 mm, E 207 GPa, 315 N/m, clearance 41 mm, horizontal.
   real(wp), parameter :: weight = 315.0_wp, clearance = 0.041_wp, youngs = 207.0e9_wp
   !> Published to five digits, from a weight that is given to three: 2.4e-5 apart.
   real(wp), parameter :: five_digits = 5.0e-5_wp
   !> Roots are found to round-off.
   real(wp), parameter :: rounding = 1.0e-12_wp

contains

   function buckling_limits_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('buckling_limits')
      call suite%addTest(TestMethod('horizontal', test_horizontal))
      call suite%addTest(TestMethod('build', test_build))
      call suite%addTest(TestMethod('drop', test_drop))
      call suite%addTest(TestMethod('high_side', test_high_side))
      call suite%addTest(TestMethod('one_root', test_one_root))
      call suite%addTest(TestMethod('hardly_any_weight', test_hardly_any_weight))
      call suite%addTest(TestMethod('turn', test_turn))
      call suite%addTest(TestMethod('no_weight_no_bend', test_nothing))
      call suite%addTest(TestMethod('vertical', test_vertical))
      call suite%addTest(TestMethod('states', test_states))
   end function buckling_limits_suite

   real(wp) function stiffness()
      stiffness = youngs*tube_inertia(0.140_wp, 0.116_wp)
   end function stiffness

   !> 251.84 kN, 356.16 kN (2 sqrt(2) form), 460.47 kN (1.8284 form).
   subroutine test_horizontal()
      real(wp) :: force
      force = sinusoidal_limit(stiffness(), weight, clearance)
      call assertRelativelyEqual(251.84e3_wp, force, five_digits)
      call assertRelativelyEqual(356.16e3_wp, helical_limit(force, 0.0_wp, helical_low), five_digits)
      call assertRelativelyEqual(460.47e3_wp, helical_limit(force, 0.0_wp, helical_high), five_digits)
      call assertRelativelyEqual(force, curved_limit(stiffness(), [0.0_wp, 0.0_wp, weight], spread(0.0_wp, 1, 3), clearance), &
                                 rounding, message='a straight hole is a bend of no curvature')
   end subroutine test_horizontal

   !> The closed form for a build: (2 EI/(c R)) (1 + sqrt(1 + w sin(theta) c R^2/EI)).
   subroutine test_build()
      real(wp), parameter :: radius = 300.0_wp, theta = 40.0_wp*degree
      real(wp) :: across(3), curvature(3), ei, expected
      ei = stiffness()
      call section(theta, radius, across, curvature)
      expected = 2.0_wp*ei/(clearance*radius)*(1.0_wp + sqrt(1.0_wp + weight*sin(theta)*clearance*radius**2/ei))
      call assertRelativelyEqual(expected, curved_limit(ei, across, curvature, clearance), rounding)
   end subroutine test_build

   !> In a drop compression lifts the string off the low side: the same with -R, less than in a straight hole.
   subroutine test_drop()
      real(wp), parameter :: radius = 300.0_wp, theta = 40.0_wp*degree
      real(wp) :: across(3), curvature(3), ei, expected, force
      ei = stiffness()
      call section(theta, radius, across, curvature)
      expected = 2.0_wp*ei/(clearance*radius)*(-1.0_wp + sqrt(1.0_wp + weight*sin(theta)*clearance*radius**2/ei))
      force = curved_limit(ei, across, -curvature, clearance)
      call assertRelativelyEqual(expected, force, rounding)
      call assertTrue(force < sinusoidal_limit(ei, weight*sin(theta), clearance))
   end subroutine test_drop

   !> In a sharp drop the string goes from the low to the high side: limits F^2 c/(4 EI) = w - F k on the one, F k - w on the other.
   !> Between the two lower ones the string goes from side to side: over 40 % of the first one, 1 %, 0.4 %, 0.01 %.
   subroutine test_high_side()
      real(wp), parameter :: radius(4) = [600.0_wp, 150.0_wp, 150.0_wp, 150.0_wp]
      real(wp), parameter :: theta(4) = [16.0_wp, 10.0_wp, 3.0_wp, 0.1_wp]*degree
      real(wp) :: across(3), curvature(3), ei, share, w, k, roots(3)
      integer :: i
      ei = stiffness()
      share = clearance/(4.0_wp*ei)
      do i = 1, size(theta)
         k = 1.0_wp/radius(i)
         call section(theta(i), radius(i), across, curvature)
         w = weight*sin(theta(i))
         roots = [2.0_wp*w/(k + sqrt(k**2 + 4.0_wp*share*w)), 2.0_wp*w/(k + sqrt(k**2 - 4.0_wp*share*w)), &
                  (k + sqrt(k**2 - 4.0_wp*share*w))/(2.0_wp*share)]
         call assertRelativelyEqual(roots(1), curved_limit(ei, across, -curvature, clearance), rounding)
         call assertRelativelyEqual(roots(1), curved_limit(ei, across, -curvature, clearance, 0.99_wp*roots(1)), rounding)
         call assertRelativelyEqual(roots(1), curved_limit(ei, across, -curvature, clearance, 0.5_wp*sum(roots(:2))), rounding, &
                                    message='between the sides')
         call assertRelativelyEqual(roots(3), curved_limit(ei, across, -curvature, clearance, 1.01_wp*roots(2)), rounding, &
                                    message='on the high side')
         call assertRelativelyEqual(roots(3), curved_limit(ei, across, -curvature, clearance, 2.0_wp*roots(3)), rounding)
      end do
   end subroutine test_high_side

   !> A drop in which compression never presses the string to the high side by more than it buckles there: one root, whatever the
   !> compression. The curvature squared is 3.85 times c w/(4 EI): between 3.67 and 4 the excess has a trough above zero.
   subroutine test_one_root()
      real(wp), parameter :: theta = 20.0_wp*degree, compression(3) = [1.0e4_wp, 1.0e5_wp, 2.5e5_wp]
      real(wp) :: across(3), curvature(3), ei, share, w, k
      integer :: i
      ei = stiffness()
      share = clearance/(4.0_wp*ei)
      w = weight*sin(theta)
      k = sqrt(3.85_wp*share*w)
      call section(theta, 1.0_wp/k, across, curvature)
      do i = 1, size(compression)
         call assertRelativelyEqual(2.0_wp*w/(k + sqrt(k**2 + 4.0_wp*share*w)), &
                                    curved_limit(ei, across, -curvature, clearance, compression(i)), rounding)
      end do
   end subroutine test_one_root

   !> Next to no weight across a bend: the first root is a ten thousand millionth of the third one.
   subroutine test_hardly_any_weight()
      real(wp), parameter :: radius = 50.0_wp, theta = 1.0e-9_wp
      real(wp) :: across(3), curvature(3), ei, share, w
      ei = stiffness()
      share = clearance/(4.0_wp*ei)
      w = weight*sin(theta)
      call section(theta, radius, across, curvature)
      call assertRelativelyEqual(2.0_wp*w/(1.0_wp/radius + sqrt(1.0_wp/radius**2 + 4.0_wp*share*w)), &
                                 curved_limit(ei, across, -curvature, clearance), 1.0e-6_wp)
   end subroutine test_hardly_any_weight

   !> In a turn to the side weight and curvature are square to each other: F^2 c/(4 EI) = sqrt((w sin)^2 + (F/R)^2), a quadratic
   !> in F^2.
   subroutine test_turn()
      real(wp), parameter :: radius = 200.0_wp
      real(wp) :: ei, share, square
      ei = stiffness()
      share = clearance/(4.0_wp*ei)
      square = (1.0_wp/radius**2 + sqrt(1.0_wp/radius**4 + 4.0_wp*(share*weight)**2))/(2.0_wp*share**2)
      call assertRelativelyEqual(sqrt(square), curved_limit(ei, [0.0_wp, 0.0_wp, weight], [0.0_wp, 1.0_wp/radius, 0.0_wp], &
                                                            clearance), rounding)
   end subroutine test_turn

   subroutine test_nothing()
      real(wp) :: ei
      ei = stiffness()
      call assertEqual(0.0_wp, curved_limit(ei, spread(0.0_wp, 1, 3), spread(0.0_wp, 1, 3), clearance))
      call assertRelativelyEqual(4.0_wp*ei/(clearance*100.0_wp), &
                                 curved_limit(ei, spread(0.0_wp, 1, 3), [0.01_wp, 0.0_wp, 0.0_wp], clearance), rounding, &
                                 message='the bend alone')
      call assertEqual(0.0_wp, vertical_unit(ei, 0.0_wp))
      call assertRelativelyEqual(vertical_unit(ei, weight), vertical_unit(ei, -weight), rounding, message='upside down')
   end subroutine test_nothing

   !> Lubinski's unit length m = (EI/w)^(1/3) and force w m; helical 5.55 of it where nothing presses sideways.
   subroutine test_vertical()
      real(wp) :: ei, unit
      ei = stiffness()
      unit = weight*(ei/weight)**(1.0_wp/3.0_wp)
      call assertRelativelyEqual(unit, vertical_unit(ei, weight), rounding)
      call assertRelativelyEqual(1.94_wp, lubinski_first, rounding)
      call assertRelativelyEqual(5.55_wp*unit, helical_limit(0.0_wp, vertical_unit(ei, weight), helical_low), rounding)
      call assertRelativelyEqual(5.55_wp*unit, helical_limit(unit, vertical_unit(ei, weight), helical_high), rounding)
   end subroutine test_vertical

   subroutine test_states()
      call assertEqual([buckling_none, buckling_none, buckling_sinusoidal, buckling_helical], &
                       buckled_state([-50.0_wp, 100.0_wp, 101.0_wp, 150.0_wp], 100.0_wp, 140.0_wp))
      call assertEqual(buckling_none, buckled_state(1.0e9_wp, 0.0_wp, 0.0_wp), message='no limit, no alarm')
   end subroutine test_states

   !> Weight across and curvature in a build in the plane of north and down.
   subroutine section(theta, radius, across, curvature)
      real(wp), intent(in) :: theta, radius
      real(wp), intent(out) :: across(3), curvature(3)
      real(wp) :: low(3)
      low = [-cos(theta), 0.0_wp, sin(theta)]     ! unit, to the low side
      across = weight*sin(theta)*low
      curvature = -low/radius
   end subroutine section
end module dg_test_buckling_limits
