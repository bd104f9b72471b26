!> The beam element: nothing from rigid motion, balance of every element, the exact arc, stretch, torque.
module dg_test_beam_element
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_beam_element, only: beam_force, beam_tangent, membrane_length, torque_force, torque_tangent
   use dg_beam_section, only: beam_section_type
   use dg_kinds, only: wp
   use dg_vector, only: cross
   implicit none
   private
   public :: beam_element_suite

   real(wp), parameter :: length = 9.5_wp, ea = 7.3e8_wp, ei = 1.26e6_wp
   !> A configuration well off straight, as (x_i, d_i, x_j, d_j).
   real(wp), parameter :: y0(12) = [1.0_wp, 2.0_wp, 3.0_wp, 0.0_wp, 0.28_wp, 0.96_wp, 1.4_wp, 2.9_wp, 12.45_wp, 0.0_wp, -0.6_wp, &
                                    0.8_wp]

contains

   function beam_element_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('beam_element')
      call suite%addTest(TestMethod('rigid_motion_from_rest', test_rigid_motion_from_rest))
      call suite%addTest(TestMethod('forces_turn_with_the_element', test_forces_turn_with_the_element))
      call suite%addTest(TestMethod('balance', test_balance))
      call suite%addTest(TestMethod('arc', test_arc))
      call suite%addTest(TestMethod('stretch', test_stretch))
      call suite%addTest(TestMethod('small_displacements', test_small_displacements))
      call suite%addTest(TestMethod('rigid_motion_costs_nothing', test_rigid_motion_costs_nothing))
      call suite%addTest(TestMethod('torque_balances', test_torque_balances))
      call suite%addTest(TestMethod('torque_derivatives', test_torque_derivatives))
   end function beam_element_suite

   pure function tube() result(section)
      type(beam_section_type) :: section
      section = beam_section_type(length=length, membrane_length=length, ea=ea, ei=ei)
   end function tube

   !> Rotation by `angle` about a skew axis, after Rodrigues.
   pure function rotation(angle) result(r)
      real(wp), intent(in) :: angle
      real(wp) :: r(3, 3)
      real(wp), parameter :: k(3) = [2.0_wp, -3.0_wp, 6.0_wp]/7.0_wp
      real(wp) :: unit(3)
      integer :: j
      do j = 1, 3
         unit = 0.0_wp
         unit(j) = 1.0_wp
         r(:, j) = unit*cos(angle) + cross(k, unit)*sin(angle) + k*(dot_product(k, unit)*(1.0_wp - cos(angle)))
      end do
   end function rotation

   pure function turned(y, angle) result(z)
      real(wp), intent(in) :: y(12), angle
      real(wp) :: z(12)
      z = reshape(matmul(rotation(angle), reshape(y, [3, 4])), [12])
   end function turned

   pure subroutine force_at(y, force, axial)
      real(wp), intent(in) :: y(12)
      real(wp), intent(out) :: force(12), axial
      call beam_force(tube(), y(7:9) - y(1:3), y(4:6), y(10:12), force, axial)
   end subroutine force_at

   !> Director forces count only across the director (its length is fixed): the moment d x f.
   pure function moments(y, force) result(m)
      real(wp), intent(in) :: y(12), force(12)
      real(wp) :: m(6)
      m = [cross(y(4:6), force(4:6)), cross(y(10:12), force(10:12))]
   end function moments

   !> An unstressed straight element, carried off and turned by up to 3 rad: nothing. Round-off of a length of 10 m
   !> times EA leaves 1e-6 N in the axial force; moments see round-off of directions times EI/L.
   subroutine test_rigid_motion_from_rest()
      real(wp) :: y(12), force(12), axial
      integer :: i
      do i = 0, 6
         y = turned([0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, length, 0.0_wp, 0.0_wp, 1.0_wp], 0.5_wp*i)
         y(1:3) = y(1:3) + [100.0_wp, -50.0_wp, 7.0_wp]
         y(7:9) = y(7:9) + [100.0_wp, -50.0_wp, 7.0_wp]
         call force_at(y, force, axial)
         call assertEqual(0.0_wp, axial, 5.0e-6_wp, message='axial')
         call assertEqual(0.0_wp, force(1:3), 5.0e-6_wp, message='force')
         call assertEqual(0.0_wp, moments(y, force), 1.0e-7_wp, message='moment')
      end do
   end subroutine test_rigid_motion_from_rest

   subroutine test_forces_turn_with_the_element()
      real(wp) :: force(12), axial, turned_force(12), turned_axial, y(12)
      integer :: i
      call force_at(y0, force, axial)
      do i = 1, 6
         y = turned(y0, 0.5_wp*i)
         call force_at(y, turned_force, turned_axial)
         call assertEqual(turned(force, 0.5_wp*i), turned_force, 1.0e-13_wp*maxval(abs(force)))
         call assertEqual(axial, turned_axial, 1.0e-13_wp*ea)
      end do
   end subroutine test_forces_turn_with_the_element

   subroutine test_balance()
      real(wp) :: force(12), axial, m(6)
      call force_at(y0, force, axial)
      m = moments(y0, force)
      call assertEqual(0.0_wp, force(1:3) + force(7:9), message='forces')
      call assertEqual(0.0_wp, m(1:3) + m(4:6) + cross(y0(7:9) - y0(1:3), force(7:9)), 1.0e-14_wp*length*maxval(abs(force)), &
                       message='moments')
   end subroutine test_balance

   !> Nodes and tangents on an arc of radius R, unstressed length by the element's own measure: M = E I/R at both ends,
   !> no axial force, whatever the angle it spans; no shear either.
   subroutine test_arc()
      real(wp), parameter :: angle(4) = [1.0e-4_wp, 0.01_wp, 0.1_wp, 1.0_wp]
      real(wp) :: radius, chord(3), d_i(3), d_j(3), force(12), axial, m(6)
      type(beam_section_type) :: section
      integer :: i
      do i = 1, size(angle)
         radius = length/angle(i)
         chord = radius*[sin(angle(i)), 0.0_wp, 2.0_wp*sin(0.5_wp*angle(i))**2]
         d_i = [1.0_wp, 0.0_wp, 0.0_wp]
         d_j = [cos(angle(i)), 0.0_wp, sin(angle(i))]
         section = tube()
         section%membrane_length = membrane_length(chord, d_i, d_j)
         call beam_force(section, chord, d_i, d_j, force, axial)
         m = [cross(d_i, force(4:6)), cross(d_j, force(10:12))]
         call assertEqual(0.0_wp, axial, message='axial')
         ! bending that turns x towards z is a moment about -y on the upper end face of the element, +y on the lower
         call assertEqual(ei/radius, norm2(m(1:3)), 1.0e-9_wp*ei/radius, message='upper moment')
         call assertEqual(ei/radius, norm2(m(4:6)), 1.0e-9_wp*ei/radius, message='lower moment')
         call assertEqual(0.0_wp, m(1:3) + m(4:6), 1.0e-9_wp*ei/radius, message='a couple')
         call assertEqual(0.0_wp, force(7:9), 1.0e-9_wp*ei/radius, message='no force')
      end do
   end subroutine test_arc

   !> N = EA times strain, with no bending.
   subroutine test_stretch()
      real(wp) :: force(12), axial
      real(wp), parameter :: along(3) = [0.6_wp, 0.0_wp, 0.8_wp], strain = 2.0e-3_wp
      call beam_force(tube(), along*length*(1.0_wp + strain), along, along, force, axial)
      call assertEqual(ea*strain, axial, 1.0e-6_wp)
      call assertEqual(ea*strain*along, force(7:9), 1.0e-6_wp)
   end subroutine test_stretch

   !> At rest the tangent is the textbook matrix of the cubic beam: K0. Directors keep their length, so that the part of
   !> the force along one counts in a turn: second derivative less force along the director (dg_director).
   subroutine test_small_displacements()
      real(wp) :: force(12), axial, k(12, 12)
      real(wp), parameter :: x(3) = [1.0_wp, 0.0_wp, 0.0_wp]
      call beam_tangent(tube(), length*x, x, x, force, axial, k)
      call assertEqual(ea/length, k(7, 7), 1.0e-9_wp*ea, message='EA/L')
      call assertEqual(12.0_wp*ei/length**3, k(8, 8), 1.0e-9_wp*ei, message='12 EI/L3')
      call assertEqual(-12.0_wp*ei/length**3, k(3, 9), 1.0e-9_wp*ei, message='-12 EI/L3')
      call assertEqual(6.0_wp*ei/length**2, k(2, 5), 1.0e-9_wp*ei, message='6 EI/L2')
      call assertEqual(-6.0_wp*ei/length**2, k(8, 11), 1.0e-9_wp*ei, message='-6 EI/L2')
      call assertEqual(4.0_wp*ei/length, k(5, 5) - force(4), 1.0e-9_wp*ei, message='4 EI/L')
      call assertEqual(2.0_wp*ei/length, k(6, 12), 1.0e-9_wp*ei, message='2 EI/L')
   end subroutine test_small_displacements

   !> With a force in it, a rigid turn w of the element changes forces by w x f and nothing else.
   subroutine test_rigid_motion_costs_nothing()
      real(wp) :: force(12), axial, k(12, 12), motion(12), change(12)
      real(wp), parameter :: w(3) = [0.3_wp, -0.8_wp, 0.5_wp]
      integer :: a
      call beam_tangent(tube(), y0(7:9) - y0(1:3), y0(4:6), y0(10:12), force, axial, k)
      do a = 1, 10, 3
         motion(a:a + 2) = cross(w, y0(a:a + 2))
         change(a:a + 2) = cross(w, force(a:a + 2))
      end do
      call assertEqual(change, matmul(k, motion), 1.0e-13_wp*maxval(abs(k))*length)
      call assertLessThan(maxval(abs(k - transpose(k)))/maxval(abs(k)), 1.0e-15_wp, message='symmetric')
   end subroutine test_rigid_motion_costs_nothing

   !> -T d_i and +T d_j turned out of line by the bend are balanced by the end-moment vector.
   subroutine test_torque_balances()
      real(wp), parameter :: torque = 2.0e4_wp
      real(wp) :: h(3)
      h = torque_force(torque, y0(4:6), y0(10:12))
      call assertEqual(0.0_wp, cross(y0(4:6), h) + cross(y0(10:12), h) - torque*y0(4:6) + torque*y0(10:12), 1.0e-14_wp*torque)
      call assertEqual(0.0_wp, norm2(torque_force(torque, y0(4:6), y0(4:6))), message='straight')
   end subroutine test_torque_balances

   subroutine test_torque_derivatives()
      real(wp), parameter :: torque = 2.0e4_wp, step = 1.0e-6_wp
      real(wp) :: by_i(3, 3), by_j(3, 3), by_torque(3), d_i(3), d_j(3), shift(3)
      integer :: k
      d_i = y0(4:6)
      d_j = y0(10:12)
      call torque_tangent(torque, d_i, d_j, by_i, by_j, by_torque)
      call assertEqual(torque_force(1.0_wp, d_i, d_j), by_torque, 1.0e-15_wp)
      do k = 1, 3
         shift = 0.0_wp
         shift(k) = step
         call assertEqual((torque_force(torque, d_i + shift, d_j) - torque_force(torque, d_i - shift, d_j))/(2.0_wp*step), &
                          by_i(:, k), 1.0e-9_wp*torque)
         call assertEqual((torque_force(torque, d_i, d_j + shift) - torque_force(torque, d_i, d_j - shift))/(2.0_wp*step), &
                          by_j(:, k), 1.0e-9_wp*torque)
      end do
   end subroutine test_torque_derivatives
end module dg_test_beam_element
