!> The nodal forces of a gap element (Eq. 6) are statically the same as its force and moment, in any displaced shape.
module dg_test_gap_element
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_gap_contact, only: touch_tangent_type, touch_type
   use dg_gap_element, only: gap_derivative_type, gap_derivatives, gap_nodal_force
   use dg_hermite, only: hermite_slope, hermite_value
   use dg_kinds, only: wp
   use dg_vector, only: cross
   implicit none
   private
   public :: gap_element_suite

   real(wp), parameter :: length = 9.0_wp
   real(wp), parameter :: xi(4) = [0.0_wp, 0.31_wp, 0.5_wp, 1.0_wp]
   real(wp), parameter :: force(3) = [300.0_wp, -2100.0_wp, 900.0_wp], moment(3) = [-40.0_wp, 260.0_wp, 75.0_wp]

contains

   function gap_element_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('gap_element')
      call suite%addTest(TestMethod('statically_the_same', test_statically_the_same))
      call suite%addTest(TestMethod('derivatives', test_derivatives))
   end function gap_element_suite

   !> A shape far from straight, of an element stretched by a fifth: the equality is no matter of small angles.
   pure function shape_of_string() result(y)
      real(wp) :: y(12)
      y = [1.0_wp, -2.0_wp, 0.5_wp, 0.36_wp, 0.48_wp, 0.8_wp, 3.0_wp, 2.5_wp, 10.0_wp, -0.48_wp, 0.6_wp, 0.64_wp]
   end function shape_of_string

   !> Point and slope of the axis at xi.
   pure subroutine axis_at(y, place, point, direction)
      real(wp), intent(in) :: y(12), place
      real(wp), intent(out) :: point(3), direction(3)
      point = matmul(reshape(y, [3, 4]), hermite_value(place, length))
      direction = matmul(reshape(y, [3, 4]), hermite_slope(place, length))
   end subroutine axis_at

   pure subroutine nodal_at(y, place, f, m, nodal, twisting)
      real(wp), intent(in) :: y(12), place, f(3), m(3)
      real(wp), intent(out) :: nodal(12), twisting(2)
      real(wp) :: point(3), direction(3)
      call axis_at(y, place, point, direction)
      call gap_nodal_force([1.0_wp - place, place], hermite_value(place, length), hermite_slope(place, length), y(4:6), &
                           y(10:12), direction, f, m, &
                           nodal, twisting)
   end subroutine nodal_at

   !> Sum of forces, and of moments about two points: x x f + d x g + twisting d over both nodes.
   subroutine test_statically_the_same()
      real(wp) :: y(12), nodal(12), twisting(2), point(3), direction(3), about(3), total(3)
      real(wp), parameter :: round_off = 1.0e-11_wp  !< of some 1e4 N.m
      integer :: i, k
      y = shape_of_string()
      do i = 1, size(xi)
         call nodal_at(y, xi(i), force, moment, nodal, twisting)
         call axis_at(y, xi(i), point, direction)
         call assertEqual(force, nodal(1:3) + nodal(7:9), round_off, message='force')
         do k = 0, 1
            about = [5.0_wp, -3.0_wp, 2.0_wp]*k
            total = cross(y(1:3) - about, nodal(1:3)) + cross(y(4:6), nodal(4:6)) + twisting(1)*y(4:6) &
                    + cross(y(7:9) - about, nodal(7:9)) + cross(y(10:12), nodal(10:12)) + twisting(2)*y(10:12)
            call assertEqual(cross(point - about, force) + moment, total, 10.0_wp*round_off, message='moment')
         end do
      end do
   end subroutine test_statically_the_same

   !> The derivatives against differences; force and moment depend on the point through two given matrices.
   subroutine test_derivatives()
      real(wp), parameter :: step = 1.0e-5_wp, tolerance = 1.0e-6_wp  !< of entries near 1e4
      real(wp) :: y(12), y_moved(12), plus(12), minus(12), twist_plus(2), twist_minus(2), by_force(3, 3), by_moment(3, 3)
      real(wp) :: stiffness(12, 12), twist_stiffness(2, 12), point(3), direction(3), d(3, 2), unit(3)
      real(wp) :: shape_there(4), slope_there(4)
      type(touch_type) :: touch
      type(touch_tangent_type) :: at_point
      type(gap_derivative_type) :: by
      integer :: a, i, j, k
      by_force = reshape([(1.0e3_wp*sin(1.0_wp*j), j=1, 9)], [3, 3])
      by_moment = reshape([(1.0e2_wp*cos(2.0_wp*j), j=1, 9)], [3, 3])
      y = shape_of_string()
      do i = 1, size(xi)
         call axis_at(y, xi(i), point, direction)
         d(:, 1) = y(4:6)
         d(:, 2) = y(10:12)
         shape_there = hermite_value(xi(i), length)
         slope_there = hermite_slope(xi(i), length)
         touch%direction = direction
         touch%share = [1.0_wp - xi(i), xi(i)]
         touch%shape = shape_there
         touch%slope = slope_there
         at_point%moment = moment
         at_point%force_by_point = by_force
         at_point%moment_by_point = by_moment
         call gap_derivatives(touch, d, at_point, by)
         do j = 1, 12
            a = (j + 2)/3
            k = j - 3*(a - 1)
            stiffness(:, j) = shape_there(a)*reshape(by%point(:, k, :), [12]) &
                              + slope_there(a)*reshape(by%direction(:, k, :), [12])
            twist_stiffness(:, j) = shape_there(a)*by%twisting_by_point(k, :) &
                                    + slope_there(a)*by%twisting_by_direction(k, :)
            if (a == 2) twist_stiffness(1, j) = twist_stiffness(1, j) + (1.0_wp - xi(i))*by%twist(k)
            if (a == 4) twist_stiffness(2, j) = twist_stiffness(2, j) + xi(i)*by%twist(k)
         end do
         do k = 1, 3
            unit = 0.0_wp
            unit(k) = 1.0_wp
            stiffness(4:6, 3 + k) = stiffness(4:6, 3 + k) + (1.0_wp - xi(i))*cross(by%twist, unit)
            stiffness(10:12, 9 + k) = stiffness(10:12, 9 + k) + xi(i)*cross(by%twist, unit)
         end do
         do j = 1, 12
            y_moved = y
            y_moved(j) = y(j) + step
            call moved_nodal(plus, twist_plus)
            y_moved(j) = y(j) - step
            call moved_nodal(minus, twist_minus)
            call assertEqual((plus - minus)/(2.0_wp*step), stiffness(:, j), tolerance, message='nodal force')
            call assertEqual((twist_plus - twist_minus)/(2.0_wp*step), twist_stiffness(:, j), tolerance, message='twisting')
         end do
      end do
   contains
      subroutine moved_nodal(nodal, twisting)
         real(wp), intent(out) :: nodal(12), twisting(2)
         real(wp) :: moved(3), ignored(3)
         call axis_at(y_moved, xi(i), moved, ignored)
         moved = moved - point
         call nodal_at(y_moved, xi(i), force + matmul(by_force, moved), moment + matmul(by_moment, moved), nodal, twisting)
      end subroutine moved_nodal
   end subroutine test_derivatives
end module dg_test_gap_element
