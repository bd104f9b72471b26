!> Ratings of premium connections against hand calculation, and bending as a textbook has it.
!>
!> Bourgoyne et al. (1986), Applied drilling engineering, eq. 7.14a: pipe of d inches in a dogleg of a deg/100 ft has a bending
!> stress of 218 a d psi, with E = 30e6 psi.
module dg_test_connection_rating
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: bending_stiffness, tube_area
   use dg_connection_rating, only: connection_rating_type, is_rated
   use dg_constants, only: degree
   use dg_design_factors, only: design_factors_type
   use dg_error, only: error_type
   use dg_fatigue_curve, only: fatigue_own
   use dg_find_verdict, only: find_verdict
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_trip_out
   use dg_model, only: model_type
   use dg_pipe_strength, only: burst_strength, collapse_strength, tensile_strength
   use dg_profile, only: new_profile, side_none
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_unchecked_text, only: unchecked_codes
   use dg_units, only: si_units
   use dg_unrated_limits, only: note_unrated
   use dg_utilisation, only: find_utilisation, joint_ratings, limit_joint_burst, limit_joint_collapse, limit_joint_compression, &
                             limit_joint_dogleg, limit_joint_tension, limit_tension, utilisation_type
   use dg_verdict, only: answer_no, every_limit_count, limit_fatigue, limit_joint_fatigue, verdict_type
   use dg_verdict_text, only: verdict_reason
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: connection_rating_suite

   real(wp), parameter :: inch = 0.0254_wp, psi = 6894.757293168_wp, per_100_ft = degree/30.48_wp
   real(wp), parameter :: depth = 1000.0_wp, mud = 1200.0_wp
   real(wp), parameter :: close = 1.0e-9_wp

contains

   function connection_rating_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('connection_rating')
      call suite%addTest(TestMethod('published_bending', test_bending))
      call suite%addTest(TestMethod('tension_and_compression', test_axial))
      call suite%addTest(TestMethod('burst_and_collapse', test_pressure))
      call suite%addTest(TestMethod('verdict', test_verdict))
      call suite%addTest(TestMethod('not_checked', test_not_checked))
      call suite%addTest(TestMethod('fatigue_not_checked', test_fatigue_not_checked))
   end function connection_rating_suite

   !> 9-5/8 in casing of 53.5 lb/ft, P110, in a vertical hole. It hangs with half its strength, its lower end is pushed with a
   !> fifth.
   subroutine build(model, result)
      type(model_type), intent(out) :: model
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, depth], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error), message='trajectory')
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depth, 0.3_wp, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      associate (part => model%strings(1)%components(1))
         part%kind = 'casing'
         part%name = 'casing'
         part%od = 9.625_wp*inch
         part%id = 8.535_wp*inch
         part%youngs = 30.0e6_wp*psi
         part%mass = part%density*tube_area(part%od, part%id)
         part%yield = 110.0e3_wp*psi
      end associate
      model%mud = standing_mud(mud)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation_trip_out
      result%case_index = 1
      result%model = model_mcge
      result%status = result_converged
      result%profile = new_profile(3)
      result%profile%md = [0.0_wp, 0.5_wp*depth, depth]
      result%profile%side = side_none
      result%profile%tvd = result%profile%md
      result%profile%axial = tensile_strength(model%strings(1)%components(1))*[0.5_wp, 0.2_wp, -0.2_wp]
      result%hookload = result%profile%axial(1)
   end subroutine build

   subroutine use_up(model, result, factors, most)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(design_factors_type), intent(in) :: factors
      type(utilisation_type), intent(out) :: most
      type(model_type) :: judged
      type(along_string_type) :: along
      judged = model
      judged%design = factors
      call find_along_string(judged, result, along)
      call find_utilisation(judged, result, along, most)
   end subroutine use_up

   !> Check the largest utilisation of a rating, and its depth.
   subroutine check_used(most, limit, share, md)
      type(utilisation_type), intent(in) :: most
      integer, intent(in) :: limit
      real(wp), intent(in) :: share, md
      call assertTrue(most%used(limit)%present)
      call assertEqual(share, most%used(limit)%value, close)
      call assertEqual(md, most%md(limit)%value, close)
   end subroutine check_used

   !> A dogleg of 10 deg/100 ft, of 20 that are rated. The constant 218 has three digits.
   subroutine test_bending()
      type(model_type) :: model
      type(case_result_type) :: result
      type(utilisation_type) :: most
      call build(model, result)
      associate (part => model%strings(1)%components(1))
         part%rating = connection_rating_type(tension=1.0_wp, compression=0.8_wp, dogleg=20.0_wp*per_100_ft)
         result%profile%axial = 0.0_wp
         result%profile%bending = [0.0_wp, 10.0_wp*per_100_ft*bending_stiffness(part), 0.0_wp]
      end associate
      call use_up(model, result, design_factors_type(), most)
      call assertRelativelyEqual(218.0_wp*10.0_wp*9.625_wp/110.0e3_wp, most%used(limit_joint_tension)%value, 1.0e-3_wp)
      call assertRelativelyEqual(most%used(limit_joint_tension)%value/0.8_wp, most%used(limit_joint_compression)%value, close)
      call check_used(most, limit_joint_dogleg, 0.5_wp, 0.5_wp*depth)
   end subroutine test_bending

   !> In mud of one pressure the effective force counts. Pump pressure pulls with p A_i. Where connections bear what the body bears,
   !> the body governs; where they bear less, they do.
   subroutine test_axial()
      type(model_type) :: model
      type(case_result_type) :: result
      type(design_factors_type) :: factors
      type(utilisation_type) :: most
      real(wp) :: bending, pull
      real(wp), parameter :: pressure = 20.0e6_wp
      factors%tension = 1.3_wp
      call build(model, result)
      associate (part => model%strings(1)%components(1))
         part%rating = connection_rating_type(tension=1.0_wp, compression=0.4_wp)
         call use_up(model, result, factors, most)
         call check_used(most, limit_joint_tension, 1.3_wp*0.5_wp, 0.0_wp)
         call check_used(most, limit_joint_compression, 1.3_wp*0.2_wp/0.4_wp, depth)
         call assertEqual(limit_tension, most%governing)
         bending = 0.1_wp*part%yield
         result%profile%bending = bending*2.0_wp*bending_stiffness(part)/(part%youngs*part%od)
         part%rating%tension = 0.7_wp
         model%cases(1)%pump_pressure = pressure
         call use_up(model, result, factors, most)
         pull = pressure*tube_area(part%id, 0.0_wp)/tensile_strength(part)
         call check_used(most, limit_joint_tension, 1.3_wp*(0.5_wp + 0.1_wp + pull)/0.7_wp, 0.0_wp)
         call check_used(most, limit_joint_compression, 1.3_wp*(0.2_wp + 0.1_wp - pull)/0.4_wp, depth)
         call assertRelativelyEqual((0.5_wp + 0.1_wp + pull)*part%yield, most%load(limit_joint_tension), close)
         call assertEqual(limit_joint_tension, most%governing)
      end associate
      call assertFalse(most%used(limit_joint_burst)%present .or. most%used(limit_joint_dogleg)%present)
   end subroutine test_axial

   !> Pump pressure; then air inside, that lets mud press on a string under tension.
   subroutine test_pressure()
      type(model_type) :: model
      type(case_result_type) :: result
      type(design_factors_type) :: factors
      type(utilisation_type) :: most
      real(wp) :: outside
      real(wp), parameter :: pressure = 20.0e6_wp
      factors%burst = 1.1_wp
      factors%collapse = 1.2_wp
      call build(model, result)
      result%profile%axial = 0.5_wp*tensile_strength(model%strings(1)%components(1))
      associate (part => model%strings(1)%components(1))
         part%rating = connection_rating_type(burst=0.9_wp, collapse=0.6_wp)
         model%cases(1)%pump_pressure = pressure
         call use_up(model, result, factors, most)
         call check_used(most, limit_joint_burst, 1.1_wp*pressure/(0.9_wp*burst_strength(part)), 0.0_wp)
         call check_used(most, limit_joint_collapse, 0.0_wp, 0.0_wp)
         model%cases(1)%pump_pressure = 0.0_wp
         model%mud%fluids(1)%inside = .false.
         call use_up(model, result, factors, most)
         outside = mud*model%gravity*depth
         call check_used(most, limit_joint_collapse, 1.2_wp*outside/(0.6_wp*collapse_strength(part, &
            0.5_wp*part%yield - outside*tube_area(part%od, 0.0_wp)/tube_area(part%od, part%id))), depth)
      end associate
   end subroutine test_pressure

   subroutine judge(model, result, verdict)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(verdict_type), intent(out) :: verdict
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call find_utilisation(model, result, along, whole%utilisation)
      call find_verdict(model, result, whole, verdict)
   end subroutine judge

   !> Connections that bear 10 % of the body in compression where it has 20 %.
   subroutine test_verdict()
      type(model_type) :: model
      type(case_result_type) :: result
      type(verdict_type) :: verdict
      call build(model, result)
      model%strings(1)%components(1)%rating%compression = 0.1_wp
      call judge(model, result, verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(limit_joint_compression, verdict%limit)
      call assertEqual("Joint compression at 1000 m in 'casing': 151.68 MPa, 75.84 MPa allowed, 75.84 MPa too much", &
                       verdict_reason(si_units(), model%cases(1), verdict))
   end subroutine test_verdict

   !> Ratings that are lacking are named where a component of the string has one. Without any, tension stands for connections.
   subroutine test_not_checked()
      type(model_type) :: model
      type(case_result_type) :: result
      type(verdict_type) :: verdict
      call build(model, result)
      call judge(model, result, verdict)
      call assertEqual(1, count(verdict%not_checked(joint_ratings)))
      call assertTrue(verdict%not_checked(limit_joint_tension))
      model%strings(1)%components(1)%makeup_torque = 1.0e4_wp
      call judge(model, result, verdict)
      call assertFalse(any(verdict%not_checked(joint_ratings)))
      model%strings(1)%components(1)%rating%tension = 1.0_wp
      call judge(model, result, verdict)
      call assertFalse(verdict%not_checked(limit_joint_tension))
      call assertTrue(index(unchecked_codes(verdict), 'joint_compression joint_burst joint_collapse joint_dogleg') > 0)
      call assertTrue(is_rated(model%strings(1)%components(1)%rating))
   end subroutine test_not_checked

   !> Where pipe that turns has a fatigue curve and no connection has one, fatigue of connections is not checked.
   subroutine test_fatigue_not_checked()
      type(model_type) :: model
      type(case_result_type) :: result
      logical :: unrated(every_limit_count)
      call build(model, result)
      model%cases(1)%operation = operation_rotary_drilling
      unrated = .false.
      call note_unrated(model, 1, unrated)
      call assertTrue(unrated(limit_fatigue) .and. .not. unrated(limit_joint_fatigue), message='no curve at all')
      associate (part => model%strings(1)%components(1))
         part%fatigue%curve = fatigue_own
         call note_unrated(model, 1, unrated)
         call assertTrue(unrated(limit_joint_fatigue), message='none of connections')
         part%joint_fatigue%curve = fatigue_own
         call note_unrated(model, 1, unrated)
         call assertFalse(unrated(limit_joint_fatigue), message='one of connections')
      end associate
   end subroutine test_fatigue_not_checked
end module dg_test_connection_rating
