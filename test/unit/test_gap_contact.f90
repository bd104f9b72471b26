!> Force and moment of a touching string (Eqs. 4 and 5): components, levers, signs, and derivatives on a bent axis.
module dg_test_gap_contact
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_gap_contact, only: contact_action, contact_action_tangent, support_action
   use dg_kinds, only: wp
   use dg_trajectory, only: closest_point, interpolation_minimum_curvature, new_trajectory, trajectory_type
   use dg_vector, only: cross
   implicit none
   private
   public :: gap_contact_suite

   real(wp), parameter :: round_off = 1.0e-11_wp   !< of newtons in thousands
   real(wp), parameter :: normal_force = 5000.0_wp, radius = 0.08_wp

contains

   function gap_contact_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('gap_contact')
      call suite%addTest(TestMethod('components', test_components))
      call suite%addTest(TestMethod('senses', test_senses))
      call suite%addTest(TestMethod('derivatives_on_a_bend', test_derivatives_on_a_bend))
      call suite%addTest(TestMethod('support', test_support))
   end function gap_contact_suite

   !> F.n = -R, F.t = a R, F.(t x n) = -m R; the moment is that of F at the lever r n, so its part along t is -r m R.
   subroutine test_components()
      real(wp), parameter :: t(3) = [2.0_wp, -1.0_wp, 2.0_wp]/3.0_wp, n(3) = [2.0_wp, 2.0_wp, -1.0_wp]/3.0_wp
      real(wp), parameter :: a(4) = [0.0_wp, 0.3_wp, -0.3_wp, 0.2_wp], m(4) = [0.0_wp, 0.0_wp, 0.0_wp, 0.25_wp]
      real(wp) :: force(3), moment(3)
      integer :: i
      do i = 1, size(a)
         call contact_action(0.04_wp*n, t, normal_force, a(i), m(i), radius, force, moment)
         call assertEqual(-normal_force, dot_product(force, n), round_off, message='normal')
         call assertEqual(a(i)*normal_force, dot_product(force, t), round_off, message='axial')
         call assertEqual(-m(i)*normal_force, dot_product(force, cross(t, n)), round_off, message='circumferential')
         call assertEqual(cross(radius*n, force), moment, round_off, message='lever')
         call assertEqual(-m(i)*radius*normal_force, dot_product(moment, t), round_off, message='torque')
         call assertEqual(0.0_wp, dot_product(moment, n), round_off, message='nothing about the normal')
      end do
   end subroutine test_components

   !> Down the hole along x, wall touched below (z): moving up, friction pulls the string down the hole; turning
   !> right-handed about x, the surface at the bottom moves towards -y, so friction pushes to +y: up the right wall.
   subroutine test_senses()
      real(wp), parameter :: t(3) = [1.0_wp, 0.0_wp, 0.0_wp], gap(3) = [0.0_wp, 0.0_wp, 0.03_wp]
      real(wp) :: force(3), moment(3), surface_velocity(3)
      call contact_action(gap, t, normal_force, 0.3_wp, 0.0_wp, radius, force, moment)
      call assertEqual([1500.0_wp, 0.0_wp, -5000.0_wp], force, round_off, message='up')
      call contact_action(gap, t, normal_force, 0.0_wp, 0.3_wp, radius, force, moment)
      surface_velocity = cross(t, [0.0_wp, 0.0_wp, radius])
      call assertLessThan(dot_product(force, surface_velocity), 0.0_wp, message='against the surface''s motion')
      call assertEqual([0.0_wp, 1500.0_wp, -5000.0_wp], force, round_off, message='turning')
      call assertEqual([-120.0_wp, 0.0_wp, 0.0_wp], moment, round_off, message='torque against the drive')
   end subroutine test_senses

   !> dF/dr and dM/dr against differences, on an arc of 20 m radius so that its curvature tells.
   subroutine test_derivatives_on_a_bend()
      real(wp), parameter :: step = 1.0e-6_wp, contact = 1.0e6_wp, clearance = 0.4_wp
      !> Entries are up to 1e6 N/m; differences lose force*1e-16/step = 1e-6, and step**2 of the third derivative.
      real(wp), parameter :: tolerance = 1.0e-8_wp
      type(trajectory_type) :: trajectory
      type(error_type), allocatable :: error
      real(wp) :: point(3), force(3), moment(3), by_point(3, 3), moment_by_point(3, 3), ignored(3, 3), moment_ignored(3, 3)
      real(wp) :: plus(3), minus(3), moment_plus(3), moment_minus(3), moved(3)
      integer :: j
      call new_trajectory(trajectory, [0.0_wp, 20.0_wp], [10.0_wp, 60.0_wp]*degree, [20.0_wp, 50.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      point = trajectory%arcs(1)%chord*0.5_wp + [0.3_wp, -0.5_wp, 0.6_wp]
      call action_at(point, force, moment, by_point, moment_by_point)
      do j = 1, 3
         moved = point
         moved(j) = point(j) + step
         call action_at(moved, plus, moment_plus, ignored, moment_ignored)
         moved(j) = point(j) - step
         call action_at(moved, minus, moment_minus, ignored, moment_ignored)
         call assertEqual((plus - minus)/(2.0_wp*step), by_point(:, j), tolerance*contact, message='force')
         call assertEqual((moment_plus - moment_minus)/(2.0_wp*step), moment_by_point(:, j), tolerance*contact*radius, &
                          message='moment')
      end do
   contains
      subroutine action_at(where_to, f, mom, df, dm)
         real(wp), intent(in) :: where_to(3)
         real(wp), intent(out) :: f(3), mom(3), df(3, 3), dm(3, 3)
         real(wp) :: place(3), offset, gap(3), t(3), curvature(3), plain_force(3), plain_moment(3)
         integer :: index
         index = 1
         place = where_to
         call closest_point(trajectory, index, place, offset, gap, t, curvature)
         call contact_action_tangent(gap, t, curvature, contact*(norm2(gap) - clearance), contact, 0.3_wp, 0.2_wp, radius, &
                                     f, mom, df, dm)
         call contact_action(gap, t, contact*(norm2(gap) - clearance), 0.3_wp, 0.2_wp, radius, plain_force, plain_moment)
         call assertEqual(plain_force, f, 1.0e-9_wp, message='same force')
         call assertEqual(plain_moment, mom, 1.0e-9_wp, message='same moment')
      end subroutine action_at
   end subroutine test_derivatives_on_a_bend

   !> A support pulls back to the axis and lets the node slide along it.
   subroutine test_support()
      real(wp), parameter :: t(3) = [0.0_wp, 0.0_wp, 1.0_wp], gap(3) = [0.01_wp, -0.02_wp, 0.0_wp]
      real(wp) :: force(3), by_point(3, 3)
      call support_action(gap, t, [0.0_wp, 0.0_wp, 0.0_wp], 1.0e5_wp, force, by_point)
      call assertEqual([-1000.0_wp, 2000.0_wp, 0.0_wp], force, round_off)
      call assertEqual(0.0_wp, by_point(3, 3), round_off, message='free along the axis')
      call assertEqual(-1.0e5_wp, by_point(1, 1), round_off)
      call assertEqual(-1.0e5_wp, by_point(2, 2), round_off)
   end subroutine test_support
end module dg_test_gap_contact
