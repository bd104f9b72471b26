!> The soft string against wells with independently computed answers and against closed forms.
module dg_test_soft_wells
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_rotate_off_bottom, operation_sliding_drilling, &
      operation_static, operation_trip_in, operation_trip_out
   use dg_missing, only: given
   use dg_model, only: model_type
   use dg_soft_string, only: solve_soft_string
   use dg_soft_string_loads, only: soft_string_at
   use dg_test_wells, only: part, three_part_well
   use dg_trajectory, only: new_trajectory, interpolation_minimum_curvature, true_vertical_depth
   use dg_units, only: unit_system_type, field_units
   implicit none
   private
   public :: soft_wells_suite

   !> The reference integrates finely with exact curvature and is printed to 0.1 N, 0.1 N.m: seven digits.
   !> Reached: 3.4e-7 in hook load (0.1 N of 327 kN), 1.8e-6 in torque (0.04 N.m of 22 kN.m).
   real(wp), parameter :: printed = 2.0e-6_wp
   !> Tensions along the string are printed to 10 N.
   real(wp), parameter :: printed_tension = 6.0_wp
   !> Weight is integrated as difference of true vertical depth: round-off of a few hundred arcs.
   real(wp), parameter :: round_off = 1.0e-12_wp
   !> Runge-Kutta in bends, 0.02 rad a step: fourth order. Reached: 3e-12 (capstan), 7e-13 (planar build).
   real(wp), parameter :: integration = 1.0e-10_wp

contains

   function soft_wells_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('soft_wells')
      call suite%addTest(TestMethod('vertical', test_vertical))
      call suite%addTest(TestMethod('slant', test_slant))
      call suite%addTest(TestMethod('buildhold', test_buildhold))
      call suite%addTest(TestMethod('buildhold_tensions', test_buildhold_tensions))
      call suite%addTest(TestMethod('johancsik_well_3', test_johancsik_well_3))
      call suite%addTest(TestMethod('straight_inclined', test_straight_inclined))
      call suite%addTest(TestMethod('capstan', test_capstan))
      call suite%addTest(TestMethod('planar_build', test_planar_build))
      call suite%addTest(TestMethod('frictionless_is_weight_times_depth', test_frictionless))
   end function soft_wells_suite

   subroutine expect(model, operation, wob, tob, hookload, torque, tolerance, what)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob, tob, hookload, torque, tolerance
      character(*), intent(in) :: what
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation
      model%cases(1)%wob = wob
      model%cases(1)%tob = tob
      call solve_soft_string(model, 1, result, error)
      call assertFalse(allocated(error), message=what)
      if (allocated(error)) return
      call assertEqual(result_converged, result%status, message=what//': status')
      call assertRelativelyEqual(hookload, result%hookload, tolerance, message=what//': hook load')
      call assertEqual(torque, result%torque, tolerance*max(torque, 1.0_wp), message=what//': torque')
      call assertEqual(result%hookload, result%profile%axial(1), message=what//': top of the profile')
      call assertEqual(-wob, result%profile%axial(size(result%profile%md)), message=what//': bit end of the profile')
   end subroutine expect

   subroutine test_vertical()
      type(model_type) :: model
      call three_part_well(model, [0.0_wp, 2000.0_wp], [0.0_wp, 0.0_wp], 1200.0_wp, 0.25_wp, 0.35_wp)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, 732311.5_wp, 0.0_wp, printed, 'up')
      call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, 732311.5_wp, 0.0_wp, printed, 'down')
      call expect(model, operation_rotary_drilling, 89.0e3_wp, 2700.0_wp, 643311.5_wp, 2700.0_wp, printed, 'rotary')
      call expect(model, operation_sliding_drilling, 89.0e3_wp, 2700.0_wp, 643311.5_wp, 2700.0_wp, printed, 'sliding')
   end subroutine test_vertical

   subroutine test_slant()
      type(model_type) :: model
      call three_part_well(model, [0.0_wp, 500.0_wp, 1100.0_wp, 3000.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], 1400.0_wp, &
                 0.25_wp, 0.35_wp)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, 1103899.3_wp, 0.0_wp, printed, 'up')
      call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, 604507.2_wp, 0.0_wp, printed, 'down')
      call expect(model, operation_rotary_drilling, 89.0e3_wp, 2700.0_wp, 730839.9_wp, 22207.5_wp, printed, 'rotary')
      call expect(model, operation_sliding_drilling, 89.0e3_wp, 2700.0_wp, 529760.6_wp, 2700.0_wp, printed, 'sliding')
   end subroutine test_slant

   subroutine build_buildhold(model)
      type(model_type), intent(out) :: model
      call three_part_well(model, [0.0_wp, 800.0_wp, 1450.0_wp, 3500.0_wp], [0.0_wp, 0.0_wp, 65.0_wp, 65.0_wp], 1800.0_wp, &
                 0.25_wp, 0.35_wp)
   end subroutine build_buildhold

   subroutine test_buildhold()
      type(model_type) :: model
      call build_buildhold(model)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, 1063531.1_wp, 0.0_wp, printed, 'up')
      call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, 414663.3_wp, 0.0_wp, printed, 'down')
      call expect(model, operation_rotary_drilling, 89.0e3_wp, 2700.0_wp, 576055.4_wp, 26934.2_wp, printed, 'rotary')
      call expect(model, operation_sliding_drilling, 89.0e3_wp, 2700.0_wp, 327352.3_wp, 2700.0_wp, printed, 'sliding')
   end subroutine test_buildhold

   subroutine test_buildhold_tensions()
      type(model_type) :: model
      real(wp), parameter :: md(6) = [500.0_wp, 1000.0_wp, 1500.0_wp, 2000.0_wp, 2500.0_wp, 3000.0_wp]
      real(wp) :: axial(6), torque(6), contact(3, 6)
      call build_buildhold(model)
      model%cases(1)%operation = operation_trip_out
      call soft_string_at(model, 1, md, axial, torque, contact)
      call assertEqual([930.90e3_wp, 732.64e3_wp, 534.57e3_wp, 443.66e3_wp, 345.53e3_wp, 247.40e3_wp], axial, &
                       printed_tension, message='up')
      model%cases(1)%operation = operation_trip_in
      call soft_string_at(model, 1, md, axial, torque, contact)
      call assertEqual([282.03e3_wp, 164.21e3_wp, 84.41e3_wp, 63.21e3_wp, 49.23e3_wp, 35.25e3_wp], axial, &
                       printed_tension, message='down')
      model%cases(1)%operation = operation_sliding_drilling
      model%cases(1)%wob = 89.0e3_wp
      call soft_string_at(model, 1, md, axial, torque, contact)
      call assertEqual([194.72e3_wp, 68.93e3_wp, -4.59e3_wp, -25.79e3_wp, -39.77e3_wp, -53.75e3_wp], axial, &
                       printed_tension, message='sliding')
   end subroutine test_buildhold_tensions

   !> Johancsik, Friesen & Dawson 1984, example well 3 as transcribed in public; reference values integrated
   !> independently, printed to 10 N and 1 N.m. Mud 9.8 lbm/gal where water is 8.33, gravity 9.81.
   subroutine test_johancsik_well_3()
      type(model_type) :: model
      type(unit_system_type) :: field
      real(wp), parameter :: friction(5) = [0.10_wp, 0.20_wp, 0.30_wp, 0.39_wp, 0.40_wp]
      real(wp), parameter :: up(5) = [1044.46e3_wp, 1173.00e3_wp, 1317.15e3_wp, 1461.62e3_wp, 1478.59e3_wp]
      real(wp), parameter :: down(5) = [828.21e3_wp, 737.86e3_wp, 657.80e3_wp, 593.68e3_wp, 586.99e3_wp]
      real(wp), parameter :: torque(5) = [9023.0_wp, 18046.0_wp, 27069.0_wp, 35190.0_wp, 36092.0_wp]
      real(wp), parameter :: rotating = 929.99e3_wp
      !> Half a unit of the last digit printed is 5 N of 587 kN. Reached: 5.2e-6, all within the half unit.
      real(wp), parameter :: printed_here = 1.0e-5_wp
      real(wp), parameter :: inch = 0.0254_wp
      integer :: i
      field = field_units()
      do i = 1, size(friction)
         call three_part_well(model, [0.0_wp, 731.5_wp, 1280.0_wp, 3718.0_wp], [0.0_wp, 0.0_wp, 44.0_wp, 44.0_wp], 1000.0_wp, &
                    friction(i), friction(i))
         model%gravity = 9.81_wp
         model%mud = standing_mud(9.8_wp/8.33_wp*1000.0_wp)
         model%strings(1)%components = [ &
            part('collar', 372.0_wp*field%length, 6.5_wp*inch, 2.5_wp*inch, 146.90_wp*field%mass_per_length, 0.0_wp), &
            part('hwdp', 840.0_wp*field%length, 5.0_wp*inch, 3.0_wp*inch, 46.90_wp*field%mass_per_length, 6.375_wp*inch), &
            part('drillpipe', 0.0_wp, 5.0_wp*inch, 4.276_wp*inch, 20.0_wp*field%mass_per_length, 6.625_wp*inch)]
         call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, up(i), 0.0_wp, printed_here, 'up')
         call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, down(i), 0.0_wp, printed_here, 'down')
         call expect(model, operation_rotate_off_bottom, 0.0_wp, 0.0_wp, rotating, torque(i), printed_here, 'rotating')
      end do
   end subroutine test_johancsik_well_3

   !> Straight hole: hook load = w L (cos +- mu sin) - WOB; one pipe, w = 262 N/m.
   subroutine test_straight_inclined()
      type(model_type) :: model
      real(wp), parameter :: theta = 50.0_wp*degree, length = 500.0_wp, w = 262.0_wp, mu = 0.3_wp
      call three_part_well(model, [0.0_wp, length], [50.0_wp, 50.0_wp], 250.0_wp, mu, mu)
      call one_pipe(model, w)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, w*length*(cos(theta) + mu*sin(theta)), 0.0_wp, round_off, 'up')
      call expect(model, operation_sliding_drilling, 2.0e4_wp, 100.0_wp, w*length*(cos(theta) - mu*sin(theta)) - 2.0e4_wp, &
                  100.0_wp, round_off, 'sliding')
      ! No wall climb in the soft string: the whole weight across the hole is the contact force.
      call expect(model, operation_rotary_drilling, 1.0e4_wp, 2.0e3_wp, w*length*cos(theta) - 1.0e4_wp, &
                  2.0e3_wp + mu*0.0635_wp*w*length*sin(theta), round_off, 'rotary')
   end subroutine test_straight_inclined

   !> Weightless string over a bend of 90 deg that turns in azimuth too: F exp(+-mu beta) at its upper end.
   subroutine test_capstan()
      type(model_type) :: model
      type(error_type), allocatable :: error
      real(wp), parameter :: pull = 5.0e4_wp, mu = 0.3_wp, beta = 90.0_wp*degree
      call three_part_well(model, [0.0_wp, 300.0_wp], [0.0_wp, 90.0_wp], 150.0_wp, mu, mu)
      ! Any two directions 90 deg apart, here from 45 deg north to horizontal east, make an arc of that bend.
      call new_trajectory(model%trajectory, [0.0_wp, 300.0_wp], [45.0_wp, 90.0_wp]*degree, [0.0_wp, 90.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      call one_pipe(model, 0.0_wp)
      call expect(model, operation_trip_out, -pull, 0.0_wp, pull*exp(mu*beta), 0.0_wp, integration, 'up')
      call expect(model, operation_trip_in, -pull, 0.0_wp, pull*exp(-mu*beta), 0.0_wp, integration, 'down')
      call expect(model, operation_rotary_drilling, -pull, 0.0_wp, pull, mu*0.0635_wp*pull*beta, integration, 'rotary')
   end subroutine test_capstan

   !> Planar build with weight, string on the upper side throughout:
   !> T = a sin th + b cos th + C exp(-m th), m = +mu pulling, -mu lowering,
   !> a = -R w (1 - m^2)/(1 + m^2), b = m a - m R w.
   subroutine test_planar_build()
      type(model_type) :: model
      real(wp), parameter :: radius = 500.0_wp, w = 300.0_wp, mu = 0.3_wp, bit_pull = 250.0e3_wp
      real(wp), parameter :: theta = 60.0_wp*degree
      call three_part_well(model, [0.0_wp, radius*theta], [0.0_wp, 60.0_wp], 100.0_wp, mu, mu)
      call one_pipe(model, w)
      ! Numbers printed to 0.01 N; closed(m) is the same form.
      call assertRelativelyEqual(464713.14_wp, closed(mu), 1.0e-7_wp, message='pulling, printed')
      call assertRelativelyEqual(314228.73_wp, closed(-mu), 1.0e-7_wp, message='lowering, printed')
      call expect(model, operation_trip_out, -bit_pull, 0.0_wp, closed(mu), 0.0_wp, integration, 'pulling')
      call expect(model, operation_trip_in, -bit_pull, 0.0_wp, closed(-mu), 0.0_wp, integration, 'lowering')
   contains
      pure function closed(m) result(tension)
         real(wp), intent(in) :: m
         real(wp) :: tension, a, b
         a = -radius*w*(1.0_wp - m*m)/(1.0_wp + m*m)
         b = m*a - m*radius*w
         tension = b + (bit_pull - a*sin(theta) - b*cos(theta))*exp(m*theta)
      end function closed
   end subroutine test_planar_build

   !> Any path: without friction the hook load is w times true vertical depth, less the bit load.
   subroutine test_frictionless()
      type(model_type) :: model
      type(error_type), allocatable :: error
      real(wp), parameter :: w = 262.0_wp
      call three_part_well(model, [0.0_wp, 2000.0_wp], [0.0_wp, 0.0_wp], 600.0_wp, 0.0_wp, 0.0_wp)
      call new_trajectory(model%trajectory, [0.0_wp, 600.0_wp, 1000.0_wp, 1300.0_wp, 2000.0_wp], &
                          [0.0_wp, 0.0_wp, 45.0_wp, 95.0_wp, 80.0_wp]*degree, [0.0_wp, 0.0_wp, 30.0_wp, 75.0_wp, 355.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      call one_pipe(model, w)
      call expect(model, operation_static, 3.0e4_wp, 0.0_wp, w*true_vertical_depth(model%trajectory, 2000.0_wp) - 3.0e4_wp, &
                  0.0_wp, round_off, 'static')
      model%cases(1)%friction_axial = given(0.0_wp)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, w*true_vertical_depth(model%trajectory, 2000.0_wp), 0.0_wp, &
                  round_off, 'up')
   end subroutine test_frictionless

   !> Replaces the string by one pipe, 127 mm, of a buoyed weight [N/m] in no mud.
   subroutine one_pipe(model, weight)
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: weight
      model%mud = standing_mud(0.0_wp)
      model%strings(1)%components = [part('drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, weight/model%gravity, 0.0_wp)]
   end subroutine one_pipe
end module dg_test_soft_wells
