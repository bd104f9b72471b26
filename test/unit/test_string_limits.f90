!> Results along the string and for the whole string, from made-up profiles whose answers are simple.
module dg_test_string_limits
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_buckling_limits, only: buckling_none, buckling_sinusoidal, sinusoidal_limit, vertical_unit
   use dg_case_result, only: case_result_type, contact_joint, contact_point_type, result_converged
   use dg_component, only: axial_stiffness, bending_stiffness, buoyed_weight, component_type, torsional_stiffness, tube_area, &
                           tube_inertia
   use dg_constants, only: degree
   use dg_design_factors, only: design_factors_type
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge, model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_trip_out
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type
   use dg_profile, only: new_profile, side_above, side_below, side_none
   use dg_soft_string, only: solve_soft_string
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_unchecked_text, only: uncertain_codes
   use dg_verdict, only: answer_no, answer_yes, nearness, note_left_out, verdict_type
   use dg_whole_string, only: find_whole_string, neutral_points_of, whole_string_type
   implicit none
   private
   public :: string_limits_suite

   real(wp), parameter :: rounding = 1.0e-12_wp
   !> Weights on bit are found by halving to 1e-9 of the bracket.
   real(wp), parameter :: halved = 1.0e-8_wp
   real(wp), parameter :: depth = 1000.0_wp, mud = 1200.0_wp

contains

   function string_limits_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('string_limits')
      call suite%addTest(TestMethod('pressure_and_true_force', test_pressure))
      call suite%addTest(TestMethod('stress_and_safety', test_stress))
      call suite%addTest(TestMethod('margins_hold_bending', test_bent_margins))
      call suite%addTest(TestMethod('error_of_the_largest_stress', test_stress_error))
      call suite%addTest(TestMethod('left_out_friction', test_left_out))
      call suite%addTest(TestMethod('nearness', test_nearness))
      call suite%addTest(TestMethod('weight_that_yields', test_wob_yield))
      call suite%addTest(TestMethod('standoff', test_standoff))
      call suite%addTest(TestMethod('weaker_side_of_a_joint', test_joint))
      call suite%addTest(TestMethod('force_of_a_tool_joint', test_joint_forces))
      call suite%addTest(TestMethod('fatigue_only_when_turning', test_fatigue))
      call suite%addTest(TestMethod('limits_by_inclination', test_inclination))
      call suite%addTest(TestMethod('weightless_has_no_limit', test_weightless))
      call suite%addTest(TestMethod('stretch_and_windup', test_stretch))
      call suite%addTest(TestMethod('neutral_points', test_neutral))
      call suite%addTest(TestMethod('margins', test_margins))
      call suite%addTest(TestMethod('weights_on_bit', test_weights))
      call suite%addTest(TestMethod('no_weight_on_a_pulled_bit', test_pulled))
      call suite%addTest(TestMethod('tool_joints', test_tool_joints))
      call suite%addTest(TestMethod('one_helical_limit_in_files_and_warnings', test_one_limit))
   end function string_limits_suite

   !> Friction that smeared joints leave out: five times its rough number may be more than is left on the hook.
   subroutine test_left_out()
      type(verdict_type) :: verdict
      verdict%answer = answer_yes
      call note_left_out(10.0e3_wp, 51.0e3_wp, verdict)
      call assertFalse(verdict%joints_uncertain, message='more is left')
      call note_left_out(10.0e3_wp, 49.0e3_wp, verdict)
      call assertTrue(verdict%joints_uncertain, message='less is left')
      verdict = verdict_type(answer=answer_yes)
      call note_left_out(0.0_wp, 1.0_wp, verdict)
      call assertFalse(verdict%joints_uncertain, message='nothing is left out')
      call assertEqual('', uncertain_codes(verdict))
      call note_left_out(huge(1.0_wp), 1.0e6_wp, verdict)
      call assertTrue(verdict%joints_uncertain, message='lock-up')
      call assertEqual('tool_joints', uncertain_codes(verdict))
      verdict%uncertain = 0.1_wp
      call assertEqual('contact_force tool_joints', uncertain_codes(verdict))
      verdict = verdict_type(answer=answer_yes, friction_reserve=given(1.1_wp))
      call note_left_out(1.0e3_wp, 51.0e3_wp, verdict)
      call assertTrue(verdict%joints_uncertain, message='near lock-up')
      verdict%friction_reserve = given(1.2_wp)
      call note_left_out(1.0e3_wp, 51.0e3_wp, verdict)
      call assertFalse(verdict%joints_uncertain, message='not near lock-up')
      verdict = verdict_type(answer=answer_no)
      call note_left_out(huge(1.0_wp), 1.0_wp, verdict)
      call assertFalse(verdict%joints_uncertain, message='NO stays NO')
   end subroutine test_left_out

   !> The nearest limit is the part that is used, or the friction reserve where that is small and nearer.
   subroutine test_nearness()
      type(verdict_type) :: verdict
      verdict%answer = answer_yes
      call assertEqual(0.0_wp, nearness(verdict), message='not known')
      verdict%used = given(0.64_wp)
      verdict%friction_reserve = given(1.25_wp)
      call assertEqual(0.64_wp, nearness(verdict), message='large reserve')
      verdict%friction_reserve = given(1.02_wp)
      call assertEqual(1.0_wp/1.02_wp, nearness(verdict), 1.0e-12_wp, 'small reserve')
      verdict%used = given(0.99_wp)
      call assertEqual(0.99_wp, nearness(verdict), message='small reserve, but a nearer limit')
   end subroutine test_nearness

   !> A straight hole of 200 mm, a collar of 50 m and pipe above it with yield; profile of four rows, two of them where they meet,
   !> nothing on it.
   subroutine build(model, result, inclination, operation)
      type(model_type), intent(out) :: model
      type(case_result_type), intent(out) :: result
      real(wp), intent(in) :: inclination       !< [deg]
      integer, intent(in) :: operation
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, depth], [inclination, inclination]*degree, [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error), message='trajectory')
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depth, 0.2_wp, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(2))
      model%strings(1)%components(1) = tube(50.0_wp, 0.16_wp, 0.07_wp, 700.0e6_wp)
      model%strings(1)%components(2) = tube(0.0_wp, 0.127_wp, 0.1086_wp, 500.0e6_wp)
      model%mud = standing_mud(mud)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation
      result%case_index = 1
      result%model = model_mcge
      result%status = result_converged
      result%profile = new_profile(4)
      result%profile%md = [0.0_wp, depth - 50.0_wp, depth - 50.0_wp, depth]
      result%profile%side = [side_none, side_above, side_below, side_none]
      result%profile%tvd = result%profile%md*cos(inclination*degree)
      result%profile%inclination = inclination*degree
   end subroutine build

   function tube(length, od, id, yield) result(component)
      real(wp), intent(in) :: length, od, id, yield
      type(component_type) :: component
      component%name = 'tube'
      component%kind = 'drillpipe'
      component%length = length
      component%od = od
      component%id = id
      component%mass = component%density*tube_area(od, id)
      component%yield = yield
   end function tube

   !> p = rho g z; at the bit, where the effective force is 0, the true one is -p A.
   subroutine test_pressure()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp) :: pressure
      call build(model, result, 60.0_wp, operation_trip_out)
      call find_along_string(model, result, along)
      pressure = mud*model%gravity*500.0_wp
      call assertEqual(0.0_wp, along%pressure(1))
      call assertRelativelyEqual(pressure, along%pressure(4), rounding)
      call assertRelativelyEqual(-pressure*tube_area(0.16_wp, 0.07_wp), along%true_axial(4), rounding)
      call assertRelativelyEqual(-pressure, along%hoop_stress(4), rounding)
      call assertEqual(0.2_wp, along%hole_diameter(2), rounding)
   end subroutine test_pressure

   !> 300 MPa of tension in pipe of 500 MPa: safety 5/3, margin 0.4, overpull 200 MPa times the area.
   subroutine test_stress()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp) :: area
      call build(model, result, 60.0_wp, operation_trip_out)
      area = tube_area(0.127_wp, 0.1086_wp)
      result%profile%axial(1) = 300.0e6_wp*area
      call find_along_string(model, result, along)
      call assertRelativelyEqual(300.0e6_wp, along%von_mises(1), rounding)
      call assertRelativelyEqual(5.0_wp/3.0_wp, along%safety_factor(1), rounding)
      call assertRelativelyEqual(0.4_wp, along%envelope_margin(1), rounding)
      call assertRelativelyEqual(200.0e6_wp*area, along%overpull(1), rounding)
      model%design = design_factors_type(von_mises=1.25_wp)
      call find_along_string(model, result, along)
      call assertRelativelyEqual(100.0e6_wp*area, along%overpull(1), rounding, message='500 MPa/1.25 allowed')
      model%design = design_factors_type(tension=2.0_wp)
      call find_along_string(model, result, along)
      call assertRelativelyEqual(-50.0e6_wp*area, along%overpull(1), rounding, message='250 MPa allowed')
      model%strings(1)%components%yield = 0.0_wp
      call find_along_string(model, result, along)
      call assertTrue(all(is_missing(along%safety_factor)), message='no yield, no factor')
      call assertTrue(all(is_missing(along%envelope_margin)) .and. all(is_missing(along%overpull)))
   end subroutine test_stress

   !> 200 MPa of tension and 150 MPa of bending in pipe of 500 MPa: 0.3 of the envelope and 150 MPa of pull are left. With
   !> -200 MPa of axial stress and 400 MPa of bending it yields, and no pull is left.
   subroutine test_bent_margins()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp) :: area, modulus
      call build(model, result, 60.0_wp, operation_trip_out)
      area = tube_area(0.127_wp, 0.1086_wp)
      modulus = tube_inertia(0.127_wp, 0.1086_wp)/0.0635_wp
      result%profile%axial(1) = 200.0e6_wp*area
      result%profile%bending(1) = 150.0e6_wp*modulus
      call find_along_string(model, result, along)
      call assertRelativelyEqual(0.3_wp, along%envelope_margin(1), rounding)
      call assertRelativelyEqual(150.0e6_wp*area, along%overpull(1), rounding)
      result%profile%axial(1) = -200.0e6_wp*area
      result%profile%bending(1) = 400.0e6_wp*modulus
      call find_along_string(model, result, along)
      call assertRelativelyEqual(-100.0e6_wp*area, along%overpull(1), rounding, message='yields already')
   end subroutine test_bent_margins

   !> A largest stress of 300 MPa at a top without moment, 8 kN.m known to 3 % where it is largest: 240 N.m may be at the top, too.
   subroutine test_stress_error()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call build(model, result, 60.0_wp, operation_trip_out)
      result%profile%axial(1) = 300.0e6_wp*tube_area(0.127_wp, 0.1086_wp)
      result%profile%bending(2:3) = 8.0e3_wp
      result%moment_error = 0.03_wp
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(300.0e6_wp, whole%von_mises, rounding)
      call assertTrue(whole%von_mises_error%present, message='the largest stress has an error')
      call assertRelativelyEqual(240.0_wp*0.0635_wp/tube_inertia(0.127_wp, 0.1086_wp)/300.0e6_wp, whole%von_mises_error%value, &
                                 rounding)
   end subroutine test_stress_error

   !> Collar of 5 MPa at 60 deg: it yields at the bit under A Y, which buckles nothing. A vertical pipe coils:
   !> F/A + c F r/(2 I) = Y.
   subroutine test_wob_yield()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(error_type), allocatable :: error
      real(wp), parameter :: od = 0.127_wp, id = 0.1086_wp
      call build(model, result, 60.0_wp, operation_sliding_drilling)
      model%strings(1)%components(1)%yield = 5.0e6_wp
      call solve_soft_string(model, 1, result, error)
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(5.0e6_wp*tube_area(0.16_wp, 0.07_wp), whole%wob_yield%value, halved)
      model%strings(1)%components%yield = 900.0e6_wp
      call find_whole_string(model, result, along, whole)
      call assertFalse(whole%wob_yield%present, message='locked up before')
      call build(model, result, 0.0_wp, operation_sliding_drilling)
      model%strings(1)%components(1) = tube(50.0_wp, od, id, 40.0e6_wp)
      model%strings(1)%components(2)%yield = 500.0e6_wp
      call solve_soft_string(model, 1, result, error)
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(40.0e6_wp/(1.0_wp/tube_area(od, id) + 0.125_wp*(0.2_wp - od)*od/tube_inertia(od, id)), &
                                 whole%wob_yield%value, halved)
   end subroutine test_wob_yield

   !> At a joint of collar and pipe each side has its stresses under the same moment. The true axial force jumps by pressure times
   !> difference of areas. Limits use both sides.
   subroutine test_joint()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp), parameter :: moment = 8.0e3_wp
      real(wp) :: pressure, jump
      call build(model, result, 60.0_wp, operation_trip_out)
      result%profile%bending(2:3) = moment
      result%profile%tvd(2:3) = 475.0_wp
      call find_along_string(model, result, along)
      call assertEqual([0.127_wp, 0.16_wp], along%od(2:3), rounding)
      call assertRelativelyEqual(moment*0.0635_wp/tube_inertia(0.127_wp, 0.1086_wp), along%bending_stress(2), rounding)
      call assertRelativelyEqual(moment*0.08_wp/tube_inertia(0.16_wp, 0.07_wp), along%bending_stress(3), rounding)
      pressure = mud*model%gravity*475.0_wp
      jump = pressure*(tube_area(0.16_wp, 0.07_wp) - tube_area(0.127_wp, 0.1086_wp))
      call assertRelativelyEqual(jump, along%true_axial(2) - along%true_axial(3), rounding)
      ! the pipe is stressed more, the collar's yield decides
      model%strings(1)%components(1)%yield = 1.0e6_wp
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(along%von_mises(2), whole%von_mises, rounding)
      call assertRelativelyEqual(along%safety_factor(3), whole%least_safety%value, rounding)
   end subroutine test_joint

   !> 1 - |offset|/c, c = (D - d)/2 of the body; where two components meet the thicker one stands off less, and what presses into
   !> the wall has none. A soft string has no offset of its own.
   subroutine test_standoff()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call build(model, result, 60.0_wp, operation_trip_out)
      result%profile%displacement = [0.01_wp, 0.015_wp, 0.015_wp, 0.02001_wp]
      call find_along_string(model, result, along)
      call assertEqual([1.0_wp - 0.01_wp/0.0365_wp, 1.0_wp - 0.015_wp/0.0365_wp, 0.25_wp, 0.0_wp], along%standoff, rounding)
      result%profile%displacement(4) = 0.018_wp
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertEqual(0.1_wp, whole%least_standoff%value, rounding)
      call assertEqual(result%profile%md(4), whole%least_standoff_md%value)
      result%model = model_soft
      call find_along_string(model, result, along)
      call assertTrue(all(is_missing(along%standoff)), message='soft')
   end subroutine test_standoff

   !> Pipe on the wall as a whole, its side force straight from 100 to 200 N/m: a joint bears the integral over a spacing, which
   !> ends with its component. Of a component shorter than that it is all of it. Joints solved one by one stand at the row nearest
   !> to them.
   subroutine test_joint_forces()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp), parameter :: spacing = 9.0_wp, short = 2.0_wp**(-10)
      call build(model, result, 60.0_wp, operation_trip_out)
      result%profile%side_force = [100.0_wp, 200.0_wp, 200.0_wp, 300.0_wp]
      call find_along_string(model, result, along)
      call assertTrue(all(is_missing(along%joint_side_force)), message='no joints')
      model%strings(1)%components(2)%joint_od = 0.16_wp
      model%strings(1)%components(2)%joint_spacing = spacing
      call find_along_string(model, result, along)
      call assertEqual([900.0_wp, 1800.0_wp] + [50.0_wp, -50.0_wp]*spacing**2/(depth - 50.0_wp), along%joint_side_force(:2), &
                       1.0e3_wp*rounding)
      call assertTrue(is_missing(along%joint_side_force(3)), message='a collar has none')
      result%profile%side_force(2) = 1.0e6_wp
      result%profile%md(1) = depth - 50.0_wp - short
      call find_along_string(model, result, along)
      call assertEqual(0.5_wp*(100.0_wp + 1.0e6_wp)*short*[1.0_wp, 1.0_wp], along%joint_side_force(:2), 1.0e3_wp*rounding, &
                       message='an edge of a short part')
      result%profile%md(1) = 0.0_wp
      model%numerics%discrete_joints = .true.
      result%model = model_mcge
      allocate (result%contacts, source=[contact_point_type(contact_joint, result%profile%md(1) + 1.0_wp, 5.0e3_wp)])
      call find_along_string(model, result, along)
      call assertEqual([5.0e3_wp, 0.0_wp], along%joint_side_force(:2), 1.0e3_wp*rounding)
      call assertTrue(is_missing(along%joint_side_force(3)), message='nor apart')
   end subroutine test_joint_forces

   subroutine test_fatigue()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      call build(model, result, 60.0_wp, operation_rotary_drilling)
      result%profile%bending = 5.0e3_wp
      call find_along_string(model, result, along)
      call assertRelativelyEqual(2.0_wp*along%bending_stress(1), along%bending_range(1), rounding)
      call assertTrue(along%bending_range(1) > 0.0_wp)
      model%cases(1)%operation = operation_sliding_drilling
      call find_along_string(model, result, along)
      call assertEqual(0.0_wp, along%bending_range(1))
   end subroutine test_fatigue

   !> Inclined: Dawson-Paslay. Vertical: Lubinski, so that 5 kN in drill pipe raise no alarm. Beyond either: buckled.
   subroutine test_inclination()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(component_type) :: pipe        ! a copy: the model is built anew below
      real(wp) :: weight, limit
      call build(model, result, 60.0_wp, operation_sliding_drilling)
      pipe = model%strings(1)%components(2)
      weight = buoyed_weight(pipe, mud, mud, model%gravity)
      limit = sinusoidal_limit(bending_stiffness(pipe), weight*sin(60.0_wp*degree), 0.5_wp*(0.2_wp - 0.127_wp))
      result%profile%axial(1) = -limit - 100.0_wp
      call find_along_string(model, result, along)
      call assertRelativelyEqual(limit, along%sinusoidal(1), rounding)
      call assertRelativelyEqual(sqrt(2.0_wp)*limit, along%helical(1), rounding)
      call assertEqual(-100.0_wp, along%buckling_margin(1), rounding*limit)
      call assertEqual([buckling_sinusoidal, buckling_none, buckling_none, buckling_none], along%buckling)
      call build(model, result, 0.0_wp, operation_sliding_drilling)
      result%profile%axial = -5.0e3_wp
      call find_along_string(model, result, along)
      call assertRelativelyEqual(1.94_wp*vertical_unit(bending_stiffness(pipe), weight), along%sinusoidal(1), rounding)
      call assertTrue(all(along%buckling == buckling_none), message='no false alarm')
   end subroutine test_inclination

   subroutine test_weightless()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call build(model, result, 60.0_wp, operation_sliding_drilling)
      model%strings(1)%components%mass = 0.0_wp
      model%mud = standing_mud(0.0_wp)
      result%profile%axial = -1.0e5_wp
      call find_along_string(model, result, along)
      call assertTrue(all(is_missing(along%sinusoidal)))
      call assertTrue(all(along%buckling == buckling_none))
      call find_whole_string(model, result, along, whole)
      call assertFalse(whole%wob_buckling%present .or. whole%buckling_margin%present)
      call assertEqual(0.0_wp, whole%wob_no_hookload%value, message='nothing to set down')
   end subroutine test_weightless

   !> A constant force and torque: T L/(EA) and M L/(GJ) of each part; pressure -(1 - 2 nu) p/E of its mean.
   subroutine test_stretch()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: mean
      call build(model, result, 60.0_wp, operation_rotary_drilling)
      result%profile%axial = 1.0e5_wp
      result%profile%torque = 1.0e4_wp
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      associate (parts => model%strings(1)%components)
         call assertRelativelyEqual(1.0e5_wp*(50.0_wp/axial_stiffness(parts(1)) + 950.0_wp/axial_stiffness(parts(2))), &
                                    whole%stretch, rounding)
         call assertRelativelyEqual(1.0e4_wp*(50.0_wp/torsional_stiffness(parts(1)) + 950.0_wp/torsional_stiffness(parts(2))), &
                                    whole%windup, rounding)
         mean = 0.5_wp*mud*model%gravity*500.0_wp
         call assertRelativelyEqual(-0.4_wp*mean*depth/206.0e9_wp, whole%pressure_stretch, rounding)
      end associate
   end subroutine test_stretch

   !> Between rows by a straight line; a row of exactly zero is one point; round-off at the bit is none.
   subroutine test_neutral()
      real(wp), allocatable :: points(:)
      allocate (points, source=neutral_points_of([0.0_wp, 10.0_wp, 20.0_wp], [300.0_wp, -100.0_wp, -200.0_wp]))
      call assertEqual(1, size(points))
      call assertEqual(7.5_wp, points(1), rounding)
      deallocate (points)
      allocate (points, source=neutral_points_of([0.0_wp, 10.0_wp, 20.0_wp, 30.0_wp], [100.0_wp, 0.0_wp, -100.0_wp, 50.0_wp]))
      call assertEqual(2, size(points))
      call assertEqual(10.0_wp, points(1), rounding)
      deallocate (points)
      allocate (points, source=neutral_points_of([0.0_wp, 10.0_wp], [1.0e5_wp, -1.0e-8_wp]))
      call assertEqual(0, size(points))
   end subroutine test_neutral

   !> Rig: limit less hook load. Make-up: the weaker of the two connections at a joint.
   subroutine test_margins()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call build(model, result, 60.0_wp, operation_rotary_drilling)
      model%strings(1)%components%makeup_torque = [20.0e3_wp, 30.0e3_wp]
      result%hookload = 700.0e3_wp
      result%profile%torque = [18.0e3_wp, 12.0e3_wp, 12.0e3_wp, 1.0e3_wp]
      call find_along_string(model, result, along)
      model%rig%max_hookload = given(1500.0e3_wp)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(800.0e3_wp, whole%rig_margin%value, rounding)
      call assertRelativelyEqual(8.0e3_wp, whole%makeup_margin%value, rounding)
      call assertRelativelyEqual(depth - 50.0_wp, whole%makeup_margin_md%value, rounding)
      model%strings(1)%components%makeup_torque = 0.0_wp
      model%rig%max_hookload = optional_real()
      call find_whole_string(model, result, along, whole)
      call assertFalse(whole%makeup_margin%present .or. whole%rig_margin%present)
   end subroutine test_margins

   !> Straight hole at 60 deg, no friction: compression is largest just above the bit, and just above the collar. Buckling
   !> begins at the lesser of the collar's limit and the pipe's plus the collar's weight along the hole; the hook load
   !> is the weight along the hole less the weight on bit.
   subroutine test_weights()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(error_type), allocatable :: error
      real(wp) :: along_hole(2), limit(2)
      integer :: i
      call build(model, result, 60.0_wp, operation_sliding_drilling)
      model%cases(1)%wob = 10.0e3_wp
      call solve_soft_string(model, 1, result, error)
      call assertFalse(allocated(error))
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      do i = 1, 2
         associate (part => model%strings(1)%components(i))
            along_hole(i) = buoyed_weight(part, mud, mud, model%gravity)*merge(50.0_wp, 950.0_wp, i == 1)*0.5_wp
            limit(i) = sinusoidal_limit(bending_stiffness(part), &
                                        buoyed_weight(part, mud, mud, model%gravity)*sin(60.0_wp*degree), 0.5_wp*(0.2_wp - part%od))
         end associate
      end do
      call assertRelativelyEqual(min(limit(1), limit(2) + along_hole(1)), whole%wob_buckling%value, halved)
      call assertRelativelyEqual(sum(along_hole), whole%wob_no_hookload%value, halved)
      call assertEqual(1, size(whole%neutral_points))
      call assertRelativelyEqual(depth - 10.0e3_wp/along_hole(1)*50.0_wp, whole%neutral_points(1), 1.0e-9_wp)
      model%strings(1)%components(1)%joint_od = 0.2_wp
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(limit(2) + along_hole(1), whole%wob_buckling%value, halved, message='a collar that fills its hole')
   end subroutine test_weights

   subroutine test_pulled()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call build(model, result, 60.0_wp, operation_trip_out)
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertFalse(whole%wob_buckling%present .or. whole%wob_no_hookload%present)
   end subroutine test_pulled

   !> Pipe with joints 8 m apart at kL = 2: its body is bent 2/tanh(2) times as much, its joint by the same moment. Solved joint by
   !> joint the moment has it already; the collar has no joints.
   subroutine test_tool_joints()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp), parameter :: moment = 5.0e3_wp, joint = 0.168_wp, factor = 2.0746294414550963_wp
      real(wp) :: tension
      call build(model, result, 60.0_wp, operation_trip_out)
      model%mud = standing_mud(0.0_wp)
      model%strings(1)%components(2)%joint_od = joint
      model%strings(1)%components(2)%joint_spacing = 8.0_wp
      tension = 0.25_wp*bending_stiffness(model%strings(1)%components(2))
      result%profile%axial = tension
      result%profile%bending = moment
      call find_along_string(model, result, along)
      call assertRelativelyEqual(factor, along%magnification(1), rounding)
      call assertRelativelyEqual(along%bending_stress(1), along%jointed_bending(1), rounding, message='a straight hole')
      call assertRelativelyEqual(tension/tube_area(joint, 0.1086_wp) + moment*0.5_wp*joint/tube_inertia(joint, 0.1086_wp), &
                                 along%joint_von_mises(1), rounding)
      call assertTrue(is_missing(along%magnification(3)) .and. is_missing(along%joint_von_mises(3)), message='collar')
      model%numerics%discrete_joints = .true.
      call find_along_string(model, result, along)
      call assertEqual(1.0_wp, along%magnification(1), message='solved joint by joint')
      result%model = model_soft
      call find_along_string(model, result, along)
      call assertRelativelyEqual(factor, along%magnification(1), rounding, message='a soft string never is')
      result%profile%axial = -100.0_wp*tension
      call find_along_string(model, result, along)
      call assertTrue(is_missing(along%magnification(1)), message='beyond the closed form')
   end subroutine test_tool_joints

   !> A model on the axis warns by the very limit that the files show: in a straight inclined hole, in a vertical one, in a bend.
   subroutine test_one_limit()
      call warn_by_limit([60.0_wp, 60.0_wp])
      call warn_by_limit([0.0_wp, 0.0_wp])
      call warn_by_limit([0.0_wp, 60.0_wp])
   end subroutine test_one_limit

   subroutine warn_by_limit(inclinations)
      real(wp), intent(in) :: inclinations(2)   !< of the hole's ends [deg]
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(error_type), allocatable :: error
      character(:), allocatable :: rest
      real(wp) :: told
      integer :: at
      call build(model, result, 60.0_wp, operation_sliding_drilling)
      call new_trajectory(model%trajectory, [0.0_wp, depth], inclinations*degree, [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      model%cases(1)%wob = 4.0e5_wp
      call solve_soft_string(model, 1, result, error)
      call find_along_string(model, result, along)
      at = index(result%message, 'Compression is ')
      call assertTrue(at > 0, message='warned: '//result%message)
      if (at == 0) return
      rest = result%message(at + len('compression is '):)
      read (rest(:index(rest, ' ')), *) told
      call assertRelativelyEqual(maxval(-result%profile%axial/along%helical), told, 1.0e-3_wp, message='four digits')
   end subroutine warn_by_limit
end module dg_test_string_limits
