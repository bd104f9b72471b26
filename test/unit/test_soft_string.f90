!> The soft string as a result: profile, clock, states, overrides, scales, refusals.
module dg_test_soft_string
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_memory, only: check_case_memory
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_constants, only: degree, pi
   use dg_error, only: error_type, status_bad_input
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_ream, operation_rotary_drilling, operation_static, operation_trip_in, operation_trip_out
   use dg_missing, only: given
   use dg_model, only: model_type
   use dg_profile, only: state_elastic, state_free
   use dg_soft_string, only: solve_soft_string
   use dg_solve_case, only: solve_case
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_string_piece, only: breakpoints
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: soft_string_suite

   real(wp), parameter :: rounding = 1.0e-12_wp
   real(wp), parameter :: weight = 300.0_wp       !< of the pipe [N/m]
   real(wp), parameter :: diameter = 0.2_wp       !< of the hole [m]
   real(wp), parameter :: pipe_diameter = 0.12_wp !< [m]

contains

   function soft_string_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('soft_string')
      call suite%addTest(TestMethod('profile', test_profile))
      call suite%addTest(TestMethod('sides_in_a_build', test_sides_in_a_build))
      call suite%addTest(TestMethod('breakpoints', test_breakpoints))
      call suite%addTest(TestMethod('any_depths_give_the_same', test_any_depths))
      call suite%addTest(TestMethod('friction_by_section_and_case', test_friction))
      call suite%addTest(TestMethod('reaming_splits_friction', test_reaming))
      call suite%addTest(TestMethod('scales', test_scales))
      call suite%addTest(TestMethod('pushed_and_locked', test_pushed_and_locked))
      call suite%addTest(TestMethod('refusals', test_refusals))
   end function soft_string_suite

   !> One pipe in a hole of two sections, friction 0.2 above 500 m and 0.4 below; angles in degrees.
   subroutine build(model, md, inclination)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: md(:), inclination(:)
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, md, inclination*degree, spread(0.0_wp, 1, size(md)), &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error), message='trajectory')
      allocate (model%holes(2), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('upper', 0.0_wp, 500.0_wp, diameter, 0.2_wp, 0.2_wp)
      model%holes(2) = hole_section_type('lower', 500.0_wp, md(size(md)), diameter, 0.4_wp, 0.4_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      associate (pipe => model%strings(1)%components(1))
         pipe%name = 'pipe'
         pipe%kind = 'drillpipe'
         pipe%od = pipe_diameter
         pipe%id = 0.1_wp
         pipe%mass = weight/model%gravity
      end associate
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = md(size(md))
   end subroutine build

   subroutine solve(model, operation, result)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation
      call solve_soft_string(model, 1, result, error)
      call assertFalse(allocated(error), message='solves')
   end subroutine solve

   !> Straight hole at 60 deg, pulled: all of it lies on the low side.
   subroutine test_profile()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: last
      call build(model, [0.0_wp, 1000.0_wp], [60.0_wp, 60.0_wp])
      model%numerics%element_length = 30.0_wp
      call solve(model, operation_trip_out, result)
      associate (profile => result%profile)
         last = size(profile%md)
         call assertEqual(0.0_wp, profile%md(1), message='surface')
         call assertEqual(1000.0_wp, profile%md(last), message='bit')
         call assertTrue(all(profile%md(2:) >= profile%md(:last - 1)), message='never decreases')
         call assertTrue(all(profile%md(2:) - profile%md(:last - 1) <= 30.0_wp), message='spacing')
         call assertTrue(any(abs(profile%md - 500.0_wp) < rounding), message='end of a hole section')
         call assertEqual(500.0_wp, profile%tvd(last), rounding*1.0e3_wp, message='tvd')
         call assertEqual(1000.0_wp*sin(60.0_wp*degree), profile%north(last), 1.0e-9_wp, message='north')
         call assertEqual(weight*sin(60.0_wp*degree), profile%side_force, 1.0e-9_wp, message='side force')
         call assertEqual(pi, profile%clock, rounding, message='low side')
         call assertEqual(0.5_wp*(diameter - pipe_diameter), profile%displacement, rounding, message='clearance')
         call assertEqual(0.0_wp, profile%bending, rounding, message='straight')
         call assertTrue(all(profile%gap_state == state_elastic), message='touches')
      end associate
      call assertEqual(result_converged, result%status)
      call assertEqual(60.0_wp*degree, result%inclination, rounding)
      call assertRelativelyEqual(1000.0_wp*weight*sin(60.0_wp*degree), result%normal_force, rounding)
      ! hook load = buoyed axial weight - wob - friction: friction counts negative when pulled.
      call assertRelativelyEqual(-0.3_wp*1000.0_wp*weight*sin(60.0_wp*degree), result%friction, rounding)
      call assertEqual(0.0_wp, result%torque)
   end subroutine test_profile

   !> Vertical, then a build that starts under tension: free in the vertical part, on the high side in the upper
   !> bend, on the low side where T/R < w sin(theta) near the bit. EI/R is the moment of the hole's curvature.
   subroutine test_sides_in_a_build()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: radius, change
      integer :: i
      call build(model, [0.0_wp, 400.0_wp, 1000.0_wp], [0.0_wp, 0.0_wp, 60.0_wp])
      radius = 600.0_wp/(60.0_wp*degree)
      call solve(model, operation_static, result)
      ! Static: T = w R (sin 60 - sin th), so that sides change where T = w R sin th: sin th = sin(60)/2.
      change = 400.0_wp + radius*asin(0.5_wp*sin(60.0_wp*degree))
      associate (profile => result%profile)
         do i = 1, size(profile%md)
            if (profile%md(i) < 399.0_wp) then
               call assertEqual(state_free, profile%gap_state(i), message='vertical')
               call assertEqual(0.0_wp, profile%displacement(i), message='vertical')
            else if (profile%md(i) > 401.0_wp .and. profile%md(i) < change - 1.0_wp) then
               call assertEqual(1.0_wp, cos(profile%clock(i)), rounding, message='high side')
               call assertRelativelyEqual(206.0e9_wp*pi/64.0_wp*(pipe_diameter**4 - 0.1_wp**4)/radius, profile%bending(i), &
                                          rounding, message='EI/R')
            else if (profile%md(i) > change + 1.0_wp) then
               call assertEqual(-1.0_wp, cos(profile%clock(i)), rounding, message='low side')
            end if
         end do
      end associate
   end subroutine test_sides_in_a_build

   subroutine test_breakpoints()
      type(model_type) :: model
      call build(model, [0.0_wp, 400.0_wp, 1000.0_wp], [0.0_wp, 0.0_wp, 60.0_wp])
      model%strings(1)%components = [model%strings(1)%components(1), model%strings(1)%components(1)]
      model%strings(1)%components(1)%length = 150.0_wp
      model%cases(1)%bit_depth = 900.0_wp
      call assertEqual([0.0_wp, 400.0_wp, 500.0_wp, 750.0_wp, 900.0_wp], breakpoints(model, 1))
      model%cases(1)%bit_depth = 100.0_wp
      call assertEqual([0.0_wp, 100.0_wp], breakpoints(model, 1), message='string longer than the hole')
   end subroutine test_breakpoints

   !> Where values are asked for does not change them, and a list may start and end anywhere.
   subroutine test_any_depths()
      type(model_type) :: model
      real(wp) :: few(2), few_torque(2), few_contact(3, 2), many(101), many_torque(101), many_contact(3, 101), md(101)
      integer :: i
      call build(model, [0.0_wp, 400.0_wp, 1000.0_wp], [0.0_wp, 0.0_wp, 60.0_wp])
      model%cases(1)%operation = operation_trip_out
      md = [(10.0_wp*real(i, wp), i=0, 100)]
      call soft_string_at(model, 1, md, many, many_torque, many_contact)
      call soft_string_at(model, 1, [200.0_wp, 950.0_wp], few, few_torque, few_contact)
      ! Steps differ: fourth order, one change of side.
      call assertRelativelyEqual(many(21), few(1), 1.0e-5_wp)
      call assertRelativelyEqual(many(96), few(2), 1.0e-9_wp)
      do i = 1, 101
         call assertEqual(0.0_wp, many_contact(2, i), rounding, message='a plane well')
      end do
      call assertEqual(0.0_wp, many(101), message='bit')
   end subroutine test_any_depths

   subroutine test_friction()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: across = weight*500.0_wp
      call build(model, [0.0_wp, 1000.0_wp], [90.0_wp, 90.0_wp])
      call solve(model, operation_trip_out, result)
      call assertRelativelyEqual((0.2_wp + 0.4_wp)*across, result%hookload, rounding, message='of the sections')
      model%cases(1)%friction_axial = given(0.1_wp)
      call solve(model, operation_trip_out, result)
      call assertRelativelyEqual(0.2_wp*across, result%hookload, rounding, message='of the case')
      call solve(model, operation_rotary_drilling, result)
      call assertRelativelyEqual(0.6_wp*across*0.5_wp*pipe_diameter, result%torque, rounding, message='rotary is not overridden')
      model%cases(1)%friction_rotary = given(0.0_wp)
      call solve(model, operation_rotary_drilling, result)
      call assertEqual(0.0_wp, result%torque, message='rotary overridden by zero')
   end subroutine test_friction

   !> Equal axial and circumferential speed: each share is 1/sqrt(2).
   subroutine test_reaming()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: normal
      call build(model, [0.0_wp, 1000.0_wp], [90.0_wp, 90.0_wp])
      model%cases(1)%friction_axial = given(0.3_wp)
      model%cases(1)%friction_rotary = given(0.3_wp)
      model%cases(1)%trip_speed = 0.6_wp
      model%cases(1)%angular_speed = 10.0_wp
      normal = weight*1000.0_wp
      call solve(model, operation_ream, result)
      call assertRelativelyEqual(-0.3_wp*normal/sqrt(2.0_wp), result%hookload, rounding, message='axial')
      call assertRelativelyEqual(0.3_wp*normal/sqrt(2.0_wp)*0.06_wp, result%torque, rounding, message='torque')
   end subroutine test_reaming

   subroutine test_scales()
      type(model_type) :: model
      type(soft_totals_type) :: totals
      real(wp) :: axial(2), torque(2), contact(3, 2)
      real(wp), parameter :: md(2) = [0.0_wp, 1000.0_wp]
      call build(model, md, [90.0_wp, 90.0_wp])
      model%cases(1)%operation = operation_trip_out
      model%cases(1)%wob = 1.0e4_wp
      model%cases(1)%tob = 500.0_wp
      call soft_string_at(model, 1, md, axial, torque, contact, totals, other_loads_type(0.5_wp, 0.25_wp))
      call assertEqual(-2500.0_wp, axial(2))
      call assertRelativelyEqual(-2500.0_wp + 0.15_wp*1000.0_wp*weight, axial(1), rounding)
      call assertEqual(125.0_wp, torque(1), message='torque on bit')
      call assertEqual([0.0_wp, 0.0_wp, weight], contact(:, 1), rounding*weight, message='presses down')
      call assertEqual(0.0_wp, totals%weight, 1.0e-9_wp, message='horizontal')
      call assertFalse(totals%runaway)
   end subroutine test_scales

   subroutine test_pushed_and_locked()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: i
      ! Horizontal all the way: nothing pushes it in but the surface.
      call build(model, [0.0_wp, 1000.0_wp], [90.0_wp, 90.0_wp])
      call solve(model, operation_trip_in, result)
      call assertEqual(result_converged, result%status)
      call assertTrue(index(result%message, 'pushed') > 0, message='says that it must be pushed')
      ! Thirty turns with a friction coefficient of 0.4: exp(75) times the force.
      call build(model, [(5.0_wp*real(i, wp), i=0, 400)], [(real(mod(i, 2), wp)*150.0_wp, i=0, 400)])
      call solve(model, operation_trip_out, result)
      call assertEqual(result_locked_up, result%status)
      call assertTrue(index(result%message, 'friction') > 0)
      call assertFalse(allocated(result%profile%md), message='no numbers')
      call assertEqual(0.0_wp, result%hookload, message='no hook load')
   end subroutine test_pushed_and_locked

   subroutine test_refusals()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call build(model, [100.0_wp, 1000.0_wp], [0.0_wp, 0.0_wp])
      model%cases(1)%string = 'other'
      call solve_soft_string(model, 1, result, error)
      call assertTrue(allocated(error), message='unknown string')
      if (allocated(error)) call assertEqual(status_bad_input, error%status)
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = 50.0_wp
      call solve_soft_string(model, 1, result, error)
      call assertTrue(allocated(error), message='bit above the first station')
      if (allocated(error)) call assertTrue(index(error%message, ': bit_depth must lie below the first station') > 0)
      call solve_case(model, 99, 1, result, error)
      call assertTrue(allocated(error), message='no such method')
      if (allocated(error)) call assertEqual('no model of number 99', error%message)
      call build(model, [0.0_wp, 3000.0_wp], [0.0_wp, 0.0_wp])
      model%numerics%element_length = 0.1_wp
      call check_case_memory(model, no_memory, error)
      call assertTrue(allocated(error), message='no memory')
      if (allocated(error)) call assertEqual(1, index(error%message, &
         'the case has 30000 elements and needs 0.18 GB of memory, there are 0; give '), message=error%message)
   contains
      function no_memory() result(bytes)
         real(wp) :: bytes
         bytes = 0.0_wp
      end function no_memory
   end subroutine test_refusals
end module dg_test_soft_string
