!> Force and moment of a touching string (Eqs. 4 and 5): components, levers, signs, and derivatives on a bent axis.
module dg_test_gap_contact
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_gap_contact, only: contact_action, couple_action, couple_tangents, moment_tangents, support_action, touch_tangent_type, &
                             touch_tangents, touch_type
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
      call suite%addTest(TestMethod('couple_moment', test_couple_moment))
      call suite%addTest(TestMethod('couple_against_turning', test_couple_against_turning))
      call suite%addTest(TestMethod('couple_derivatives', test_couple_derivatives))
      call suite%addTest(TestMethod('support', test_support))
   end function gap_contact_suite

   !> F.n = -R, F.t = a R, F.(t x n) = -m R; the moment is that of F at the lever r n, so its part along t is -r m R.
   subroutine test_components()
      real(wp), parameter :: t(3) = [2.0_wp, -1.0_wp, 2.0_wp]/3.0_wp, n(3) = [2.0_wp, 2.0_wp, -1.0_wp]/3.0_wp
      real(wp), parameter :: a(4) = [0.0_wp, 0.3_wp, -0.3_wp, 0.2_wp], m(4) = [0.0_wp, 0.0_wp, 0.0_wp, 0.25_wp]
      real(wp) :: force(3), moment(3)
      integer :: i
      do i = 1, size(a)
         call contact_action(0.04_wp*n, t, normal_force, a(i), m(i), m(i), radius, force, moment)
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
      call contact_action(gap, t, normal_force, 0.3_wp, 0.0_wp, 0.0_wp, radius, force, moment)
      call assertEqual([1500.0_wp, 0.0_wp, -5000.0_wp], force, round_off, message='up')
      call contact_action(gap, t, normal_force, 0.0_wp, 0.3_wp, 0.3_wp, radius, force, moment)
      surface_velocity = cross(t, [0.0_wp, 0.0_wp, radius])
      call assertLessThan(dot_product(force, surface_velocity), 0.0_wp, message='against the surface''s motion')
      call assertEqual([0.0_wp, 1500.0_wp, -5000.0_wp], force, round_off, message='turning')
      call assertEqual([-120.0_wp, 0.0_wp, 0.0_wp], moment, round_off, message='torque against the drive')
   end subroutine test_senses

   !> dF/dr and dM/dr against differences, on an arc of 20 m radius so that its curvature tells; with friction by the contact
   !> force itself and by a lagged one of three times its size and a tenth of its stiffness.
   subroutine test_derivatives_on_a_bend()
      real(wp), parameter :: step = 1.0e-6_wp, contact = 1.0e6_wp, clearance = 0.4_wp
      !> Entries are up to 1e6 N/m; differences lose force*1e-16/step = 1e-6, and step**2 of the third derivative.
      real(wp), parameter :: tolerance = 1.0e-8_wp
      type(trajectory_type) :: trajectory
      type(error_type), allocatable :: error
      real(wp) :: point(3), force(3), moment(3), by_point(3, 3), moment_by_point(3, 3), ignored(3, 3), moment_ignored(3, 3)
      real(wp) :: plus(3), minus(3), moment_plus(3), moment_minus(3), moved(3), lagged, lag_stiffness
      integer :: j, way
      call new_trajectory(trajectory, [0.0_wp, 20.0_wp], [10.0_wp, 60.0_wp]*degree, [20.0_wp, 50.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      point = trajectory%arcs(1)%chord*0.5_wp + [0.3_wp, -0.5_wp, 0.6_wp]
      do way = 1, 2
         lagged = merge(1.0_wp, 3.0_wp, way == 1)
         lag_stiffness = merge(1.0_wp, 0.1_wp, way == 1)
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
      end do
   contains
      subroutine action_at(where_to, f, mom, df, dm)
         real(wp), intent(in) :: where_to(3)
         real(wp), intent(out) :: f(3), mom(3), df(3, 3), dm(3, 3)
         real(wp) :: place(3), offset, gap(3), t(3), curvature(3), plain(3), rubbing(3), load, pressing, norm
         type(touch_type) :: touch
         type(touch_tangent_type) :: by
         integer :: index
         index = 1
         place = where_to
         call closest_point(trajectory, index, place, offset, gap, t, curvature)
         norm = norm2(gap)
         load = contact*(norm - clearance)
         pressing = lagged*load
         if (way == 2) pressing = lagged*contact*(1.0_wp - clearance) + lag_stiffness*contact*(norm - 1.0_wp)
         touch = touch_of(gap, t, curvature, t)
         touch%normal = load
         touch%normal_stiffness = contact
         touch%pressing = pressing
         touch%pressing_stiffness = lag_stiffness*contact
         call touch_tangents(touch, by)
         call moment_tangents(touch, by)
         df = by%force_by_point
         dm = by%moment_by_point
         ! the normal force by itself, and what friction at its own adds
         call contact_action(gap, t, load, 0.0_wp, 0.0_wp, 0.0_wp, radius, f, mom)
         call contact_action(gap, t, pressing, 0.0_wp, 0.0_wp, 0.0_wp, radius, plain, mom)
         call contact_action(gap, t, pressing, 0.3_wp, 0.2_wp, 0.2_wp, radius, rubbing, mom)
         f = f + rubbing - plain
         call assertEqual(mom, by%moment, 1.0e-9_wp, message='moment')
      end subroutine action_at
   end subroutine test_derivatives_on_a_bend

   !> A gap that rubs.
   pure function touch_of(gap, t, curvature, direction) result(touch)
      real(wp), intent(in) :: gap(3), t(3), curvature(3), direction(3)
      type(touch_type) :: touch
      touch%gap = gap
      touch%tangent = t
      touch%curvature = curvature
      touch%direction = direction
      touch%normal = 0.0_wp
      touch%normal_stiffness = 0.0_wp
      touch%pressing = 0.0_wp
      touch%pressing_stiffness = 0.0_wp
      touch%couple = 0.0_wp
      touch%couple_stiffness = 0.0_wp
      touch%axial = 0.3_wp
      touch%rotary = 0.2_wp
      touch%sideways = 0.2_wp
      touch%radius = radius
   end function touch_of

   !> Along the hole the couple is Eq. 5's moment, d x P = -r R a tau, with no force; a string that slants across the wall
   !> by a small angle turns d x P by that angle, and feels F_tau = -r R a (d.tau)/|f|.
   subroutine test_couple_moment()
      real(wp), parameter :: t(3) = [1.0_wp, 0.0_wp, 0.0_wp], n(3) = [0.0_wp, 0.0_wp, 1.0_wp], tau(3) = [0.0_wp, -1.0_wp, 0.0_wp]
      real(wp), parameter :: straight(3) = 0.0_wp, couple = 0.3_wp*normal_force*radius, offset = 0.04_wp, slant = 0.01_wp
      real(wp) :: d(3), force(3), bend(3), eq4(3), moment(3)
      call contact_action(offset*n, t, normal_force, 0.3_wp, 0.0_wp, 0.0_wp, radius, eq4, moment)
      call couple_action(offset*n, t, t, couple, force, bend)
      call assertEqual(moment, cross(t, bend), round_off, message='moment of Eq. 5')
      call assertEqual(straight, force, round_off, message='no force')
      d = cos(slant)*t + sin(slant)*tau
      call couple_action(offset*n, t, d, couple, force, bend)
      call assertEqual(cos(slant)*moment + couple*sin(slant)*t, cross(d, bend), round_off, message='moment of a slanting string')
      call assertEqual(-couple*sin(slant)/offset*tau, force, round_off, message='force of a slanting string')
   end subroutine test_couple_moment

   !> A string that turns as a whole about a straight hole, place and direction alike, feels no work of the couple.
   subroutine test_couple_against_turning()
      real(wp), parameter :: t(3) = [2.0_wp, -1.0_wp, 2.0_wp]/3.0_wp, n(3) = [2.0_wp, 2.0_wp, -1.0_wp]/3.0_wp
      real(wp), parameter :: gap(3) = 0.04_wp*n
      real(wp) :: d(3), force(3), bend(3)
      d = 0.9_wp*t + 0.2_wp*n + 0.3_wp*cross(t, n)
      call couple_action(gap, t, d, 300.0_wp, force, bend)
      call assertGreaterThan(abs(dot_product(force, cross(t, gap))), 1.0_wp, message='something to balance')
      call assertEqual(0.0_wp, dot_product(force, cross(t, gap)) + dot_product(bend, cross(t, d)), round_off, message='work')
   end subroutine test_couple_against_turning

   !> The couple's four derivatives against differences, on a bend.
   subroutine test_couple_derivatives()
      real(wp), parameter :: step = 1.0e-6_wp, couple_stiffness = 2.0e4_wp, clearance = 0.4_wp, tolerance = 1.0e-4_wp
      type(trajectory_type) :: trajectory
      type(error_type), allocatable :: error
      real(wp) :: point(3), along(3), middle(3, 6), plus(3, 6), minus(3, 6), force(3), bend(3), changed(3)
      integer :: j
      call new_trajectory(trajectory, [0.0_wp, 20.0_wp], [10.0_wp, 60.0_wp]*degree, [20.0_wp, 50.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      point = trajectory%arcs(1)%chord*0.5_wp + [0.3_wp, -0.5_wp, 0.6_wp]
      along = trajectory%arcs(1)%chord/20.0_wp + [0.1_wp, 0.05_wp, -0.08_wp]
      do j = 1, 3
         changed = 0.0_wp
         changed(j) = step
         call couple_at(point, along, middle, j, force, bend)
         call couple_at(point + changed, along, plus, j, force, bend)
         plus(:, 5:6) = reshape([force, bend], [3, 2])
         call couple_at(point - changed, along, minus, j, force, bend)
         call assertEqual((plus(:, 5) - force)/(2.0_wp*step), middle(:, 1), tolerance, message='force by point')
         call assertEqual((plus(:, 6) - bend)/(2.0_wp*step), middle(:, 3), tolerance, message='couple by point')
         call couple_at(point, along + changed, plus, j, force, bend)
         plus(:, 5:6) = reshape([force, bend], [3, 2])
         call couple_at(point, along - changed, minus, j, force, bend)
         call assertEqual((plus(:, 5) - force)/(2.0_wp*step), middle(:, 2), tolerance, message='force by direction')
         call assertEqual((plus(:, 6) - bend)/(2.0_wp*step), middle(:, 4), tolerance, message='couple by direction')
      end do
   contains
      !> Column j of the derivatives in 1 to 4.
      subroutine couple_at(where_to, direction, columns, j, force, bend)
         real(wp), intent(in) :: where_to(3), direction(3)
         real(wp), intent(out) :: columns(3, 6), force(3), bend(3)
         integer, intent(in) :: j
         real(wp) :: place(3), offset, gap(3), t(3), curvature(3)
         type(touch_type) :: touch
         type(touch_tangent_type) :: by
         integer :: index
         index = 1
         place = where_to
         call closest_point(trajectory, index, place, offset, gap, t, curvature)
         touch = touch_of(gap, t, curvature, direction)
         touch%couple = couple_stiffness*(norm2(gap) - clearance)
         touch%couple_stiffness = couple_stiffness
         call couple_action(gap, t, direction, touch%couple, force, bend)
         call touch_tangents(touch, by)      ! of no contact force
         call couple_tangents(touch, by)
         columns(:, 1) = by%force_by_point(:, j)
         columns(:, 2) = by%force_by_direction(:, j)
         columns(:, 3) = by%bend_by_point(:, j)
         columns(:, 4) = by%bend_by_direction(:, j)
         columns(:, 5:6) = 0.0_wp
      end subroutine couple_at
   end subroutine test_couple_derivatives

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
