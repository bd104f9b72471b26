!> Strengths of pipe and connections against published tables, and what a string uses of them against hand calculation.
module dg_test_strength
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type, tube_area, worn_od
   use dg_connection_rating, only: connection_rating_type
   use dg_connection, only: connection_name, connection_torsion, find_connection, makeup_share
   use dg_design_factors, only: design_factors_type
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_pipe_strength, only: burst_strength, collapse_strength, collapses_as_steel, slip_share, tensile_strength, &
                               torsional_strength, yield_left
   use dg_pipe_stress, only: pipe_stress, pipe_stress_type
   use dg_profile, only: new_profile, side_above, side_below, side_none
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_utilisation, only: find_utilisation, governing_name, limit_burst, limit_collapse, limit_joint_torsion, limit_makeup, &
                             limit_rig, limit_slips, limit_tension, limit_torsion, limit_von_mises, utilisation_type
   implicit none
   private
   public :: strength_suite

   real(wp), parameter :: inch = 0.0254_wp, foot = 0.3048_wp, pound_force = 4.4482216152605_wp, psi = pound_force/inch**2
   real(wp), parameter :: rounding = 1.0e-12_wp
   real(wp), parameter :: depth = 1000.0_wp

contains

   function strength_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('strength')
      call suite%addTest(TestMethod('published_drill_pipe', test_drill_pipe))
      call suite%addTest(TestMethod('published_constants_of_collapse', test_collapse))
      call suite%addTest(TestMethod('collapse_under_tension', test_tension))
      call suite%addTest(TestMethod('published_connections', test_connections))
      call suite%addTest(TestMethod('slips', test_slips))
      call suite%addTest(TestMethod('used_by_hand', test_used))
      call suite%addTest(TestMethod('nothing_known', test_nothing_known))
      call suite%addTest(TestMethod('worn_pipe', test_worn))
      call suite%addTest(TestMethod('loss_by_temperature', test_loss))
      call suite%addTest(TestMethod('warm_pipe', test_warm))
   end function strength_suite

   function pipe(od, id, yield, wall_left) result(part)
      real(wp), intent(in) :: od, id      !< [in]
      real(wp), intent(in) :: yield       !< [ksi]
      real(wp), intent(in) :: wall_left   !< [-]
      type(component_type) :: part
      part%kind = 'drillpipe'
      part%name = 'pipe'
      part%od = od*inch
      part%id = id*inch
      part%mass = part%density*tube_area(part%od, part%id)
      part%yield = 1000.0_wp*yield*psi
      part%wall_left = wall_left
   end function pipe

   !> Data sheets of Workstrings International for S-135 pipe, new and premium (API RP 7G): 5 in 19.50 lb/ft (2011; with 95 and
   !> 90 % of the wall, too), 5-1/2 in 21.90 lb/ft (WS41-01). Tolerances are half of the last digit printed, of torsion API's other
   !> roundings.
   subroutine test_drill_pipe()
      call sheet(pipe(5.0_wp, 4.276_wp, 135.0_wp, 1.0_wp), 712100.0_wp, 74100.0_wp, 17105.0_wp, 15672.0_wp, 50.0_wp)
      call sheet(pipe(5.0_wp, 4.276_wp, 135.0_wp, 0.95_wp), 673800.0_wp, 70000.0_wp, 18571.0_wp, 14292.0_wp, 50.0_wp)
      call sheet(pipe(5.0_wp, 4.276_wp, 135.0_wp, 0.9_wp), 635900.0_wp, 66000.0_wp, 17593.0_wp, 12892.0_wp, 50.0_wp)
      call sheet(pipe(5.0_wp, 4.276_wp, 135.0_wp, 0.8_wp), 560800.0_wp, 58100.0_wp, 15638.0_wp, 10029.0_wp, 50.0_wp)
      call sheet(pipe(5.5_wp, 4.778_wp, 135.0_wp, 1.0_wp), 786809.0_wp, 91278.0_wp, 15507.0_wp, 12679.0_wp, 0.5_wp)
      call sheet(pipe(5.5_wp, 4.778_wp, 135.0_wp, 0.8_wp), 620604.0_wp, 71754.0_wp, 14177.0_wp, 7496.0_wp, 0.5_wp)
      call assertEqual(4.855_wp*inch, worn_od(pipe(5.0_wp, 4.276_wp, 135.0_wp, 0.8_wp)), 0.0005_wp*inch, message='worn diameter')
   contains
      subroutine sheet(part, tension, torsion, burst, collapse, last)
         type(component_type), intent(in) :: part
         real(wp), intent(in) :: tension         !< [lbf]
         real(wp), intent(in) :: torsion         !< [ft.lbf]
         real(wp), intent(in) :: burst, collapse !< [psi]
         real(wp), intent(in) :: last            !< half of the last digit of tension and torsion
         call assertEqual(tension, tensile_strength(part)/pound_force, last, message='tension')
         call assertEqual(torsion, torsional_strength(part)/(pound_force*foot), last + 2.0_wp, message='torsion')
         call assertEqual(burst, burst_strength(part)/psi, 0.6_wp, message='burst')
         call assertEqual(collapse, collapse_strength(part, 0.0_wp)/psi, 0.6_wp, message='collapse')
      end subroutine sheet
   end subroutine test_drill_pipe

   !> Collapse from the constants A, B, C, F, G that API Bulletin 5C3 prints for each grade, with the range in which each formula
   !> holds; they are rounded to four digits.
   subroutine test_collapse()
      call plastic(40.0_wp, 20.0_wp, 2.950_wp, 0.0465_wp, 754.0_wp)
      call plastic(55.0_wp, 20.0_wp, 2.991_wp, 0.0541_wp, 1206.0_wp)
      call plastic(80.0_wp, 18.0_wp, 3.071_wp, 0.0667_wp, 1955.0_wp)
      call plastic(95.0_wp, 15.0_wp, 3.124_wp, 0.0743_wp, 2404.0_wp)
      call plastic(110.0_wp, 19.0_wp, 3.181_wp, 0.0819_wp, 2852.0_wp)
      call plastic(125.0_wp, 13.0_wp, 3.239_wp, 0.0895_wp, 3301.0_wp)
      call plastic(40.0_wp, 35.0_wp, 2.063_wp, 0.0325_wp, 0.0_wp)
      call plastic(80.0_wp, 26.0_wp, 1.998_wp, 0.0434_wp, 0.0_wp)
      call plastic(110.0_wp, 24.0_wp, 2.066_wp, 0.0532_wp, 0.0_wp)
      call plastic(125.0_wp, 21.0_wp, 2.106_wp, 0.0582_wp, 0.0_wp)
      ! yield: the bore of a thick tube; elastic: by the modulus alone
      call assertRelativelyEqual(2.0_wp*80.0e3_wp*9.0_wp/100.0_wp, collapse(80.0_wp, 10.0_wp), 1.0e-9_wp)
      call assertRelativelyEqual(46.95e6_wp/(45.0_wp*44.0_wp**2), collapse(40.0_wp, 45.0_wp), 1.0e-9_wp)
      call assertRelativelyEqual(46.95e6_wp/(45.0_wp*44.0_wp**2), collapse(135.0_wp, 45.0_wp), 1.0e-9_wp)
   contains
      subroutine plastic(yield, slenderness, a, b, c)
         real(wp), intent(in) :: yield        !< [ksi]
         real(wp), intent(in) :: slenderness
         real(wp), intent(in) :: a, b, c      !< A, B, C or F, G and 0
         real(wp) :: last
         last = 1000.0_wp*yield*(0.0005_wp/slenderness + 0.00005_wp) + 1.0_wp
         call assertEqual(1000.0_wp*yield*(a/slenderness - b) - c, collapse(yield, slenderness), last)
      end subroutine plastic

      function collapse(yield, slenderness) result(pressure)
         real(wp), intent(in) :: yield        !< [ksi]
         real(wp), intent(in) :: slenderness
         real(wp) :: pressure
         pressure = collapse_strength(pipe(slenderness, slenderness - 2.0_wp, yield, 1.0_wp), 0.0_wp)/psi
      end function collapse
   end subroutine test_collapse

   !> Tension leaves a hoop stress h with which von Mises' stress is the yield strength: h^2 + h s + s^2 = Y^2. In a thick tube
   !> collapse is proportional to it. Compression does not count; at the yield strength nothing is left.
   subroutine test_tension()
      type(component_type) :: part
      real(wp) :: stress, hoop
      part = pipe(8.0_wp, 6.0_wp, 110.0_wp, 1.0_wp)
      stress = 0.4_wp*part%yield
      hoop = collapse_strength(part, stress)/(2.0_wp*7.0_wp/64.0_wp)
      call assertRelativelyEqual(part%yield**2, hoop**2 + hoop*stress + stress**2, 1.0e-10_wp, message='von Mises')
      call assertRelativelyEqual(collapse_strength(part, 0.0_wp), collapse_strength(part, -stress), rounding)
      call assertEqual(0.0_wp, collapse_strength(part, part%yield))
      call assertEqual(0.0_wp, collapse_strength(part, 2.0_wp*part%yield))
      ! 7 in 26 lb/ft P-110 with 11,000 psi of tension, worked by hand with the polynomials in Python: 104,087 psi are left
      part = pipe(7.0_wp, 6.276_wp, 110.0_wp, 1.0_wp)
      call assertEqual(6111.38_wp, collapse_strength(part, 11000.0_wp*psi)/psi, 0.01_wp)
      part%youngs = 71.0e9_wp
      call assertFalse(collapses_as_steel(part), message='aluminium')
   end subroutine test_tension

   !> Torsional yield strengths of new tool joints of 120 ksi as API RP 7G lists them [ft.lbf], from a reader's notes of its table;
   !> that of 5-1/2 FH through its make-up torque, 52,302, which the errata of May 2000 print. The formula gives each of them to
   !> the last digit, which notes or dimensions with a fault would not.
   subroutine test_connections()
      call joint('NC26', 3.375_wp, 1.75_wp, 6875.0_wp)
      call joint('NC38', 5.0_wp, 2.125_wp, 26515.0_wp)
      call joint('NC40', 5.25_wp, 2.8125_wp, 23487.0_wp)
      call joint('NC46', 6.0_wp, 3.25_wp, 33625.0_wp)
      call joint('NC50', 6.375_wp, 3.75_wp, 37676.0_wp)
      call joint('NC50', 6.375_wp, 3.5_wp, 44673.0_wp)
      call joint('NC50', 6.625_wp, 2.75_wp, 63406.0_wp)
      call joint('5-1/2FH', 7.5_wp, 3.0_wp, 52302.0_wp/makeup_share)
      call assertEqual(0.0_wp, connection_torsion(find_connection(9), 6.625_wp*inch, 4.9_wp*inch, 1.0e9_wp), message='no pin')
      call assertEqual(0.0_wp, connection_torsion(find_connection(9), 5.2_wp*inch, 2.0_wp*inch, 1.0e9_wp), message='no box')
   contains
      subroutine joint(name, od, bore, published)
         character(*), intent(in) :: name
         real(wp), intent(in) :: od, bore    !< [in]
         real(wp), intent(in) :: published   !< [ft.lbf]
         real(wp) :: torque
         torque = connection_torsion(find_connection(findloc(connection_name == name, .true., dim=1)), od*inch, bore*inch, &
                                     120.0e3_wp*psi)
         call assertEqual(published, torque/(pound_force*foot), 0.9_wp, message=name)
      end subroutine joint
   end subroutine test_connections

   !> Under the load that slips may hold, the bore of a pipe that is pressed with K F/(pi D L) yields (Lame, von Mises). For 5 in
   !> pipe the ratios that handbooks list are 1.59 for slips of 12 in, 1.42 for 16 in.
   subroutine test_slips()
      type(component_type) :: part
      type(pipe_stress_type) :: stress
      real(wp) :: load, pressure
      real(wp), parameter :: pi = acos(-1.0_wp), lateral = 4.0_wp, length = 16.0_wp*inch
      part = pipe(5.0_wp, 4.276_wp, 135.0_wp, 1.0_wp)
      load = tensile_strength(part)*slip_share(part%od, lateral, length)
      pressure = lateral*load/(pi*part%od*length)
      stress = pipe_stress(part%od, part%id, load, 0.0_wp, 0.0_wp, pressure, 0.0_wp)
      call assertRelativelyEqual(part%yield, stress%von_mises, 1.0e-12_wp)
      call assertEqual(1.42_wp, 1.0_wp/slip_share(5.0_wp*inch, lateral, length), 0.005_wp)
      call assertEqual(1.59_wp, 1.0_wp/slip_share(5.0_wp*inch, lateral, 12.0_wp*inch), 0.005_wp)
   end subroutine test_slips

   !> A vertical hole, 100 m of collar without yield below pipe; half the strength in tension and a tenth in torsion at surface.
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
      allocate (model%strings(1)%components(2))
      model%strings(1)%components(1) = pipe(6.5_wp, 2.8125_wp, 0.0_wp, 1.0_wp)
      model%strings(1)%components(1)%length = 100.0_wp
      model%strings(1)%components(2) = pipe(5.0_wp, 4.276_wp, 135.0_wp, 1.0_wp)
      model%mud = standing_mud(1200.0_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation_rotary_drilling
      result%case_index = 1
      result%model = model_mcge
      result%status = result_converged
      result%profile = new_profile(4)
      result%profile%md = [0.0_wp, depth - 100.0_wp, depth - 100.0_wp, depth]
      result%profile%side = [side_none, side_above, side_below, side_none]
      result%profile%tvd = result%profile%md
      associate (part => model%strings(1)%components(2))
         result%profile%axial = tensile_strength(part)*[0.5_wp, 0.2_wp, 0.2_wp, 0.0_wp]
         result%profile%torque = torsional_strength(part)*[0.1_wp, 0.08_wp, 0.08_wp, 0.08_wp]
         result%hookload = 0.5_wp*tensile_strength(part)
      end associate
   end subroutine build

   !> Each limit by hand, at the place where it is used most, with its factor. In mud of one pressure nothing bursts or collapses;
   !> pump pressure bursts, air inside lets the mud outside press the pipe in.
   subroutine test_used()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(design_factors_type) :: factors
      type(utilisation_type) :: most
      real(wp) :: torque
      call build(model, result)
      torque = result%profile%torque(1)
      model%strings(1)%components(1)%joint_torsion = 10.0_wp*torque
      model%strings(1)%components(2)%makeup_torque = 2.5_wp*torque
      factors%tension = 1.2_wp
      factors%torsion = 1.5_wp
      factors%von_mises = 1.1_wp
      factors%slip_length = 16.0_wp*inch
      call find_along_string(model, result, along)
      model%rig%max_hookload = given(4.0_wp*result%hookload)
      model%design = factors
      call find_utilisation(model, result, along, most)
      call used(limit_tension, 0.6_wp, 0.0_wp)
      call used(limit_torsion, 0.15_wp, 0.0_wp)
      call used(limit_joint_torsion, 1.5_wp*0.08_wp, depth - 100.0_wp)
      call used(limit_makeup, 0.4_wp, 0.0_wp)
      call used(limit_burst, 0.0_wp, 0.0_wp)
      call used(limit_collapse, 0.0_wp, 0.0_wp)
      call used(limit_slips, 0.6_wp*sqrt(1.0_wp + 0.625_wp + 0.625_wp**2), 0.0_wp)
      call used(limit_rig, 0.25_wp, 0.0_wp)
      ! a block that weighs as much as half the string, at the same limit
      model%rig%block_weight = 0.5_wp*result%hookload
      model%rig%max_hookload = given(4.0_wp*result%hookload)
      call find_utilisation(model, result, along, most)
      call used(limit_rig, 0.375_wp, 0.0_wp)
      ! 0.5 Y of tension, 0.1 x 0.577 Y of shear
      call used(limit_von_mises, 1.1_wp*sqrt(0.25_wp + 3.0_wp*0.0577_wp**2), 0.0_wp)
      call assertEqual('slips', trim(governing_name(most)))
      ! weight on bit comes back to the hook, a pull at the bit is on it while no slips are set
      model%cases(1)%wob = 0.5_wp*result%hookload
      model%rig%max_hookload = optional_real()
      call find_utilisation(model, result, along, most)
      call used(limit_slips, 0.9_wp*sqrt(1.0_wp + 0.625_wp + 0.625_wp**2), 0.0_wp)
      model%cases(1)%wob = -model%cases(1)%wob
      call find_utilisation(model, result, along, most)
      call assertFalse(most%used(limit_slips)%present, message='slips under a pull')
      model%cases(1)%wob = 0.0_wp
      factors%burst = 1.2_wp
      factors%collapse = 1.1_wp
      model%cases(1)%pump_pressure = 20.0e6_wp
      call find_along_string(model, result, along)
      model%design = factors
      call find_utilisation(model, result, along, most)
      call used(limit_burst, 1.2_wp*20.0e6_wp/burst_strength(model%strings(1)%components(2)), 0.0_wp)
      model%cases(1)%pump_pressure = 0.0_wp
      model%mud%fluids(1)%inside = .false.
      call find_along_string(model, result, along)
      call find_utilisation(model, result, along, most)
      associate (part => model%strings(1)%components(2), outside => 1200.0_wp*model%gravity*900.0_wp)
         call used(limit_burst, 0.0_wp, 0.0_wp)
         call used(limit_collapse, 1.1_wp*outside/collapse_strength(part, (result%profile%axial(2) - outside* &
                   tube_area(part%od, 0.0_wp))/tube_area(part%od, part%id)), 900.0_wp)
      end associate
      factors%slip_length = 0.0_wp
      factors%torsion = 7.0_wp
      model%design = factors
      call find_utilisation(model, result, along, most)
      call assertFalse(most%used(limit_slips)%present .or. most%used(limit_rig)%present)
      call assertEqual('torsion', trim(governing_name(most)))
   contains
      subroutine used(limit, share, md)
         integer, intent(in) :: limit
         real(wp), intent(in) :: share, md
         call assertTrue(most%used(limit)%present)
         call assertEqual(share, most%used(limit)%value, 1.0e-9_wp)
         call assertEqual(md, most%md(limit)%value, rounding)
      end subroutine used
   end subroutine test_used

   !> Without yield strengths, torques and rig limit nothing governs.
   subroutine test_nothing_known()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(utilisation_type) :: most
      call build(model, result)
      model%strings(1)%components(2)%yield = 0.0_wp
      call find_along_string(model, result, along)
      model%design = design_factors_type(slip_length=0.4_wp)
      call find_utilisation(model, result, along, most)
      call assertFalse(any(most%used%present))
      call assertEqual(0, most%governing)
      call assertEqual('', trim(governing_name(most)))
   end subroutine test_nothing_known

   !> Stresses of worn pipe are those of a pipe with its diameters; overpull is up to its tensile strength.
   subroutine test_worn()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: worn, thin
      call build(model, result)
      result%profile%bending = [20.0e3_wp, 0.0_wp, 0.0_wp, 0.0_wp]
      model%strings(1)%components(2)%wall_left = 0.7_wp
      call find_along_string(model, result, worn)
      associate (part => model%strings(1)%components(2))
         part%od = worn_od(part)
         part%wall_left = 1.0_wp
      end associate
      call find_along_string(model, result, thin)
      call assertRelativelyEqual(thin%von_mises(1), worn%von_mises(1), rounding)
      call assertRelativelyEqual(thin%safety_factor(1), worn%safety_factor(1), rounding)
      call assertRelativelyEqual(thin%true_axial(2), worn%true_axial(2), rounding)
      call assertRelativelyEqual(thin%overpull(1), worn%overpull(1), rounding)
      call assertTrue(worn%od(1) > thin%od(1), message='the column od is that of new pipe')
   end subroutine test_worn

   !> API's straight line for quenched and tempered steel: 0.03 % a degree Fahrenheit above 75 degF, 0.054 % a kelvin. At 400 degF a
   !> yield strength of 110 ksi is 99.275 ksi.
   subroutine test_loss()
      type(component_type) :: part
      part = pipe(7.0_wp, 6.276_wp, 110.0_wp, 1.0_wp)
      call assertRelativelyEqual(99.275_wp, 110.0_wp*yield_left(part, (400.0_wp - 75.0_wp)*5.0_wp/9.0_wp), rounding)
      call assertRelativelyEqual(1.0_wp - 0.054_wp, yield_left(part, 100.0_wp), rounding)
      call assertEqual(1.0_wp, yield_left(part, -20.0_wp), 0.0_wp, message='cold pipe')
      part%yield_loss = 0.01_wp
      call assertTrue(yield_left(part, 500.0_wp) > 0.0_wp, message='beyond the straight line')
   end subroutine test_loss

   !> A warm string has the limits of one with less yield strength and weaker connections. Between its ends strength goes with true
   !> vertical depth.
   subroutine test_warm()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: warm, weak
      type(utilisation_type) :: most, expected
      type(design_factors_type) :: factors
      integer :: i
      call build(model, result)
      result%profile%bending = [20.0e3_wp, 0.0_wp, 0.0_wp, 0.0_wp]
      model%strings(1)%components(2)%joint_torsion = 60.0e3_wp
      model%strings(1)%components(2)%rating = connection_rating_type(0.9_wp, 0.6_wp, 0.8_wp, 0.7_wp)
      model%mud%fluids(1)%inside = .false.
      factors%slip_length = 0.4_wp
      model%cases(1)%above_ambient_top = 100.0_wp
      model%cases(1)%above_ambient_bottom = 100.0_wp
      call find_along_string(model, result, warm)
      model%design = factors
      call find_utilisation(model, result, warm, most)
      model%cases(1)%above_ambient_top = 0.0_wp
      model%cases(1)%above_ambient_bottom = 0.0_wp
      associate (part => model%strings(1)%components(2))
         part%yield = (1.0_wp - 0.054_wp)*part%yield
         part%joint_torsion = (1.0_wp - 0.054_wp)*part%joint_torsion
      end associate
      call find_along_string(model, result, weak)
      call find_utilisation(model, result, weak, expected)
      call assertRelativelyEqual(weak%safety_factor(1), warm%safety_factor(1), rounding)
      call assertRelativelyEqual(weak%envelope_margin(1), warm%envelope_margin(1), 1.0e-10_wp)
      call assertRelativelyEqual(weak%overpull(1), warm%overpull(1), rounding)
      do i = 1, size(most%used)
         call assertTrue(most%used(i)%present .eqv. expected%used(i)%present)
         call assertEqual(expected%used(i)%value, most%used(i)%value, 1.0e-12_wp)
      end do
      call assertTrue(count(most%used%present) >= 10)
      model%cases(1)%above_ambient_bottom = 100.0_wp
      call find_along_string(model, result, warm)
      call assertRelativelyEqual(1.0_wp - 0.9_wp*0.054_wp, warm%yield_left(2), rounding, message='at 900 m of 1000 m')
   end subroutine test_warm
end module dg_test_strength
