!> Straight inclined holes, string free at both ends: everything is known in closed form.
module dg_test_straight_holes
   use funit, only: assertEqual, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_constants, only: degree, pi
   use dg_kinds, only: wp
   use dg_load_case, only: operation_backream, operation_ream, operation_rotary_drilling, operation_sliding_drilling, &
                           operation_static, operation_trip_in, operation_trip_out
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_nodes, settings_of
   use dg_profile, only: state_free
   use dg_test_wells, only: hold_ends, new_well, note, pipe, solve
   implicit none
   private
   public :: straight_holes_suite

   real(wp), parameter :: w = 262.0_wp, length = 200.0_wp, mu = 0.3_wp, radius = 0.0635_wp, wob = 8.0e3_wp, tob = 900.0_wp
   real(wp), parameter :: inclination(7) = [10.0_wp, 30.0_wp, 60.0_wp, 89.0_wp, 90.0_wp, 95.0_wp, 120.0_wp]
   !> The residual is iterated to 1e-9 of the weight, and nodes' shares add up. Seen: 2e-8, most cases 1e-10. Asked for: 1e-6.
   real(wp), parameter :: tolerance = 1.0e-7_wp
   !> A free end hangs over its last gap by up to an element, sags there below the wall, and when rotating swings to another
   !> clock angle than the string that lies. The sag goes with the fourth power of the element, and torque with the square
   !> of the angle: 10 m elements leave 3e-6, 4 m elements 1e-9 of the friction torque.
   real(wp), parameter :: rotary_element = 4.0_wp

contains

   function straight_holes_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('straight_holes')
      call suite%addTest(TestMethod('up_and_down', test_up_and_down))
      call suite%addTest(TestMethod('rotary', test_rotary))
      call suite%addTest(TestMethod('reaming', test_reaming))
      call suite%addTest(TestMethod('gaps_at_nodes', test_gaps_at_nodes))
      call suite%addTest(TestMethod('uneven_mesh', test_uneven_mesh))
      call suite%addTest(TestMethod('straight_up', test_straight_up))
      call suite%addTest(TestMethod('short_string', test_short_string))
   end function straight_holes_suite

   subroutine build(model, theta)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: theta
      call new_well(model, [0.0_wp, length], [theta, theta], [40.0_wp, 40.0_wp], 0.2_wp, mu, pipe(w, 0.127_wp, 0.1086_wp))
   end subroutine build

   !> w L (cos +- mu sin) - WOB; the scale of the error is the weight (a hook load may pass through zero).
   subroutine test_up_and_down()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: theta, expected
      integer :: i
      do i = 1, size(inclination)
         theta = inclination(i)*degree
         call build(model, inclination(i))
         call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'up')
         expected = w*length*(cos(theta) + mu*sin(theta))
         call note('up: deviation over weight', (result%hookload - expected)/(w*length))
         call assertEqual(expected, result%hookload, tolerance*w*length, message='up')
         call assertEqual(-mu*w*length*sin(theta), result%friction, tolerance*w*length, message='up: friction')
         call assertEqual(w*length*sin(theta), result%normal_force, tolerance*w*length, message='up: normal force')
         call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'down')
         expected = w*length*(cos(theta) - mu*sin(theta))
         call assertEqual(expected, result%hookload, tolerance*w*length, message='down')
         call solve(model, operation_sliding_drilling, wob, tob, result, 'sliding')
         call assertEqual(expected - wob, result%hookload, tolerance*w*length, message='sliding')
         call assertEqual(tob, result%torque, 1.0e-6_wp*tob, message='sliding: torque')
         call solve(model, operation_static, wob, 0.0_wp, result, 'static')
         call assertEqual(w*length*cos(theta) - wob, result%hookload, tolerance*w*length, message='static')
      end do
   end subroutine test_up_and_down

   !> The string climbs to atan(mu) off the low side, to the right looking down: N = w sin(theta)/sqrt(1 + mu**2),
   !> torque = mu r N L + TOB, no axial friction.
   subroutine test_rotary()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: theta, normal, clock
      integer :: i, n
      do i = 1, size(inclination)
         theta = inclination(i)*degree
         call build(model, inclination(i))
         model%numerics%element_length = rotary_element
         call solve(model, operation_rotary_drilling, wob, tob, result, 'rotary')
         normal = w*sin(theta)/sqrt(1.0_wp + mu**2)
         call note('rotary: deviation of torque over friction torque', &
                   (result%torque - tob - mu*radius*normal*length)/(mu*radius*normal*length))
         call assertEqual(w*length*cos(theta) - wob, result%hookload, tolerance*w*length, message='hook load')
         call assertRelativelyEqual(tob + mu*radius*normal*length, result%torque, 1.0e-6_wp, message='torque')
         call assertRelativelyEqual(normal*length, result%normal_force, 1.0e-6_wp, message='normal force')
         clock = pi - atan(mu)
         n = size(result%profile%md)
         call assertTrue(all(result%profile%gap_state /= state_free), message='touches everywhere')
         call assertEqual(clock, result%profile%clock(n/2), 1.0e-6_wp, message='clock angle')
         call assertEqual(clock, result%profile%clock, 5.0e-3_wp, message='clock angle, ends included')
         ! torque falls in a line from top to bit
         call assertEqual(tob + mu*radius*normal*(length - result%profile%md(n/2)), result%profile%torque(n/2), &
                          1.0e-6_wp*result%torque, message='torque along the string')
      end do
   end subroutine test_rotary

   !> One Coulomb force against the surface's velocity: with the share s = v/hypot(v, omega r) along the hole,
   !> hook load = w L cos +- mu s N L, torque = mu sqrt(1 - s**2) r N L, N = w sin/sqrt(1 + mu**2 (1 - s**2)).
   subroutine test_reaming()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: theta = 60.0_wp*degree, speed = 0.3_wp, omega = 6.0_wp
      real(wp) :: axial, rotary, normal
      call build(model, 60.0_wp)
      model%numerics%element_length = rotary_element
      model%cases(1)%angular_speed = omega
      model%cases(1)%trip_speed = speed
      axial = mu*speed/hypot(speed, omega*radius)
      rotary = mu*omega*radius/hypot(speed, omega*radius)
      normal = w*sin(theta)/sqrt(1.0_wp + rotary**2)
      call solve(model, operation_backream, 0.0_wp, 0.0_wp, result, 'backream')
      call assertRelativelyEqual(length*(w*cos(theta) + axial*normal), result%hookload, 1.0e-6_wp, message='backream')
      call assertRelativelyEqual(rotary*radius*normal*length, result%torque, 1.0e-6_wp, message='backream: torque')
      call solve(model, operation_ream, wob, tob, result, 'ream')
      call assertRelativelyEqual(length*(w*cos(theta) - axial*normal) - wob, result%hookload, 1.0e-6_wp, message='ream')
      call assertRelativelyEqual(tob + rotary*radius*normal*length, result%torque, 1.0e-6_wp, message='ream: torque')
   end subroutine test_reaming

   subroutine test_gaps_at_nodes()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: theta = 60.0_wp*degree
      call build(model, 60.0_wp)
      model%numerics%element_length = rotary_element
      model%numerics%gap_location = gap_at_nodes
      call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'nodes, up')
      call assertEqual(w*length*(cos(theta) + mu*sin(theta)), result%hookload, tolerance*w*length, message='up')
      call solve(model, operation_rotary_drilling, wob, tob, result, 'nodes, rotary')
      call assertRelativelyEqual(tob + mu*radius*w*sin(theta)/sqrt(1.0_wp + mu**2)*length, result%torque, 1.0e-6_wp, &
                                 message='torque')
   end subroutine test_gaps_at_nodes

   !> Elements from 0.3 to 14.5 m side by side, short ones at the ends as above. (Between gaps 30 m apart this pipe hangs
   !> half a metre through the wall, and its ends are thrown against the upper side.)
   subroutine test_uneven_mesh()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: theta = 60.0_wp*degree
      call new_well(model, [0.0_wp, 3.0_wp, 3.3_wp, 5.0_wp, 19.0_wp, 33.0_wp, 34.0_wp, 62.0_wp, 90.0_wp, 93.5_wp, 150.0_wp, &
                            179.0_wp, 198.0_wp, length], spread(60.0_wp, 1, 14), spread(40.0_wp, 1, 14), 0.2_wp, mu, &
                    pipe(w, 0.127_wp, 0.1086_wp))
      model%numerics%element_length = 14.5_wp
      call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'uneven, up')
      call assertEqual(w*length*(cos(theta) + mu*sin(theta)), result%hookload, tolerance*w*length, message='up')
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'uneven, down')
      call assertEqual(w*length*(cos(theta) - mu*sin(theta)), result%hookload, tolerance*w*length, message='down')
      call solve(model, operation_rotary_drilling, 0.0_wp, tob, result, 'uneven, rotary')
      call assertRelativelyEqual(tob + mu*radius*w*sin(theta)/sqrt(1.0_wp + mu**2)*length, result%torque, 1.0e-6_wp, &
                                 message='torque')
   end subroutine test_uneven_mesh

   !> Straight up, standing on the surface: -w L; friction at a wall that is touched without weight adds next to nothing.
   subroutine test_straight_up()
      type(model_type) :: model
      type(case_result_type) :: result
      call new_well(model, [0.0_wp, 50.0_wp], [180.0_wp, 180.0_wp], [0.0_wp, 0.0_wp], 0.2_wp, 0.3_wp, pipe(w, 0.127_wp, 0.1086_wp))
      call hold_ends(model)
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'straight up')
      call assertRelativelyEqual(-50.0_wp*w, result%hookload, 1.0e-2_wp, message='hook load')
   end subroutine test_straight_up

   !> A string of 5 m at rest in a straight hole lies on its wall without any moment. Its moments are round-off, and no
   !> reason to halve elements: judged against themselves they made 132 rows of 3 elements, or no equilibrium.
   subroutine test_short_string()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: short = 5.0_wp, theta = 50.0_wp, soft = 1.0e9_wp
      call new_well(model, [0.0_wp, short], [theta, theta], [30.0_wp, 30.0_wp], 0.2159_wp, mu, pipe(w, 0.127_wp, 0.1086_wp))
      model%numerics = settings_of('auto')
      model%numerics%gk_contact = soft          ! forces are to balance to 1e-9 of some 1500 N
      model%numerics%gk_max = soft
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'short string')
      call assertEqual(w*short*cos(theta*degree), result%hookload, tolerance*w*short, message='hook load')
      call note('largest moment over weight times length', maxval(result%profile%bending)/(w*short**2))
      call assertLessThan(maxval(result%profile%bending), 1.0e-6_wp*w*short**2, message='moment')
      call assertLessThan(size(result%profile%md), 3*result%elements, message='rows')
      call assertEqual('', result%message, message='nothing is to be said')
   end subroutine test_short_string
end module dg_test_straight_holes
