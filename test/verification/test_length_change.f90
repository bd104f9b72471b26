!> Change of the length of tubing: the example of Lubinski, Althouse & Logan (1962), Helical buckling of tubing sealed in packers,
!> J. Pet. Technol. 14(6), SPE-178-PA, and vertical strings whose length follows from a formula.
!>
!> Their tubing of 2 7/8 in, 6.5 lb/ft hangs in 10,000 ft of 7 in casing of 32 lb/ft, sealed in a packer bore of 3.25 in that lets
!> it move. Crude oil of 7.31 lb/gal is inside and outside. Then it squeezes cement of 15 lb/gal at 5,000 psi, with 1,000 psi on the
!> annulus, and cools by 20 degF. They find a shortening of 165.2 in in all, of that 16.6 in by the temperature. With 20,000 lbf set
!> down on the packer before, which shorten the tubing by 49.7 in, its lower end moves by 115.5 in.
module dg_test_length_change
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: axial_stiffness, bending_stiffness, buoyed_weight, tube_area
   use dg_error, only: error_type
   use dg_fluid, only: fluid_type, standing_mud
   use dg_held_string, only: find_packer_loads
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge, model_rigid, model_soft
   use dg_kinds, only: wp
   use dg_length_change, only: asks_for_length, find_length_change, length_change_type, less, total_change
   use dg_load_case, only: operation_static
   use dg_missing, only: given
   use dg_model, only: hold_fixed, hold_free, hold_landed, model_type
   use dg_solve_case, only: solve_case
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_unit_kind, only: unit_density, unit_diameter, unit_expansion, unit_factor, unit_force, unit_length, unit_mass, &
      unit_modulus, unit_stress, unit_temperature
   use dg_units, only: field_units
   implicit none
   private
   public :: length_change_suite

   real(wp), parameter :: depth = 10000.0_wp, casing = 6.094_wp, od = 2.875_wp, id = 2.441_wp, mass = 6.5_wp     ! ft, in, lbm/ft
   real(wp), parameter :: oil = 7.31_wp, cement = 15.0_wp, bore = 3.25_wp                       ! lbm/gal, in
   real(wp), parameter :: pumped = 5.0_wp, annulus = 1.0_wp, cooled = -20.0_wp                  ! ksi, degF
   real(wp), parameter :: published_total = -165.2_wp, published_temperature = -16.6_wp         ! in
   real(wp), parameter :: set_down = 20.0_wp, published_set_down = -49.7_wp, published_landed = -115.5_wp      ! klbf, in
   real(wp), parameter :: printed = 0.003_wp       !< their constants have three digits [-]

contains

   function length_change_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('length_change')
      call suite%addTest(TestMethod('packer_by_beams', test_packer_by_beams))
      call suite%addTest(TestMethod('packer_by_formulas', test_packer_by_formulas))
      call suite%addTest(TestMethod('packer_by_two_cases', test_two_cases))
      call suite%addTest(TestMethod('fixed_packer', test_fixed))
      call suite%addTest(TestMethod('landed_string', test_landed))
      call suite%addTest(TestMethod('hanging_in_mud', test_hanging))
      call suite%addTest(TestMethod('pressure_alone', test_pressure))
      call suite%addTest(TestMethod('temperature_alone', test_temperature))
      call suite%addTest(TestMethod('not_asked_for', test_not_asked))
      call suite%addTest(TestMethod('couplings', test_couplings))
   end function length_change_suite

   !> A number in a unit of the field, in SI.
   function si(number, unit) result(value)
      real(wp), intent(in) :: number
      integer, intent(in) :: unit
      real(wp) :: value
      value = number*unit_factor(field_units(), unit)
   end function si

   !> Tubing in its casing, vertical, in oil, at rest.
   subroutine build(model)
      type(model_type), intent(out) :: model
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, si(depth, unit_length)], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('casing', 0.0_wp, si(depth, unit_length), si(casing, unit_diameter), 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      associate (pipe => model%strings(1)%components(1))
         pipe%name = 'tubing'
         pipe%kind = 'tubing'
         pipe%od = si(od, unit_diameter)
         pipe%id = si(id, unit_diameter)
         pipe%mass = si(mass, unit_mass)
         pipe%youngs = si(30.0_wp, unit_modulus)
         pipe%expansion = si(6.9_wp, unit_expansion)
      end associate
      model%mud = standing_mud(si(oil, unit_density))
      model%numerics%moments = .true.
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = si(depth, unit_length)
      model%cases(1)%operation = operation_static
   end subroutine build

   !> Change of length by one method.
   subroutine find(model, method, change)
      type(model_type), intent(in) :: model
      integer, intent(in) :: method
      type(length_change_type), intent(out) :: change
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(error_type), allocatable :: error
      call solve_case(model, method, 1, result, error)
      call assertFalse(allocated(error))
      call assertEqual(result_converged, result%status)
      if (result%status /= result_converged) return
      call find_along_string(model, result, along)
      call find_length_change(model, result, along, change)
   end subroutine find

   !> Parts of the example by one method against the formulas of the paper, their sum and the last part against its figures.
   subroutine check_packer(method, of_force, of_buckling)
      integer, intent(in) :: method
      real(wp), intent(in) :: of_force, of_buckling    !< tolerances [-]
      type(model_type) :: model
      type(length_change_type) :: before, landed, after, change
      real(wp) :: length, pressures(2), at_surface(2), gradients(2), area(3), weight, clearance, ratio, by_formula
      call build(model)
      model%boundary%packer_bore = si(bore, unit_diameter)
      call find(model, method, before)
      model%cases(1)%wob = si(set_down, unit_force)
      call find(model, method, landed)
      model%cases(1)%wob = 0.0_wp
      deallocate (model%mud%fluids)
      allocate (model%mud%fluids(2))
      model%mud%fluids(1) = fluid_type(outside=.false., density=si(cement, unit_density))
      model%mud%fluids(2) = fluid_type(inside=.false., density=si(oil, unit_density), surface_pressure=si(annulus, unit_stress))
      model%cases(1)%pump_pressure = si(pumped, unit_stress)
      model%cases(1)%temperature_change_top = si(cooled, unit_temperature)
      model%cases(1)%temperature_change_bottom = si(cooled, unit_temperature)
      call assertTrue(asks_for_length(model, model%cases(1)))
      call find(model, method, after)
      change = less(after, before)
      length = si(depth, unit_length)
      at_surface = [si(pumped, unit_stress), si(annulus, unit_stress)]                               ! inside, outside
      gradients = [si(cement - oil, unit_density), 0.0_wp]*model%gravity
      pressures = at_surface + gradients*length
      associate (pipe => model%strings(1)%components(1))
         area = [tube_area(pipe%id, 0.0_wp), tube_area(pipe%od, 0.0_wp), tube_area(si(bore, unit_diameter), 0.0_wp)]
         by_formula = -length*((area(3) - area(1))*pressures(1) - (area(3) - area(2))*pressures(2))/axial_stiffness(pipe)
         call assertRelativelyEqual(by_formula, change%force, of_force)
         weight = buoyed_weight(pipe, si(oil, unit_density), si(cement, unit_density), model%gravity)
         clearance = 0.5_wp*(si(casing, unit_diameter) - pipe%od)
         by_formula = -(clearance*area(3)*(pressures(1) - pressures(2)))**2/(8.0_wp*bending_stiffness(pipe)*weight)
         call assertRelativelyEqual(by_formula, change%buckling, of_buckling)
         ratio = (pipe%od/pipe%id)**2
         by_formula = -pipe%poisson/pipe%youngs*((gradients(1) - ratio*gradients(2))*length**2 + &
                                                 2.0_wp*(at_surface(1) - ratio*at_surface(2))*length)/(ratio - 1.0_wp)
         call assertRelativelyEqual(by_formula, change%pressure, 1.0e-9_wp)
      end associate
      call assertRelativelyEqual(si(published_temperature, unit_diameter), change%temperature, printed)
      call assertRelativelyEqual(si(published_total, unit_diameter), total_change(change), printed)
      call assertRelativelyEqual(si(published_set_down, unit_diameter), total_change(less(landed, before)), printed)
      call assertRelativelyEqual(si(published_landed, unit_diameter), total_change(less(after, landed)), printed)
   end subroutine check_packer

   !> The coils that mcge finds shorten the tubing as the helix of the paper does, but for its ends.
   subroutine test_packer_by_beams()
      call check_packer(model_mcge, 1.0e-4_wp, 5.0e-3_wp)
   end subroutine test_packer_by_beams

   !> The closed form leaves out what is compressed less than the lower helical limit, a thousandth.
   subroutine test_packer_by_formulas()
      call check_packer(model_soft, 1.0e-9_wp, 2.0e-3_wp)
      call check_packer(model_rigid, 1.0e-9_wp, 2.0e-3_wp)
   end subroutine test_packer_by_formulas

   !> Couplings hold the helix off the casing, and the tubing between them bows out to it. So buckling takes up less length than
   !> without couplings, and more than with couplings all along. The formula agrees with the beams, which solve couplings one by
   !> one where a length is asked for.
   subroutine test_couplings()
      type(model_type) :: model
      type(length_change_type) :: bare, smeared, beams, by_formula
      call build(model)
      model%boundary%packer_bore = si(bore, unit_diameter)
      model%cases(1)%wob = si(set_down, unit_force)
      call find(model, model_mcge, bare)
      associate (pipe => model%strings(1)%components(1))
         pipe%joint_od = si(3.668_wp, unit_diameter)
         pipe%joint_length = 0.14_wp
         pipe%joint_spacing = 9.45_wp
      end associate
      call find(model, model_mcge, beams)
      call find(model, model_soft, by_formula)
      call assertRelativelyEqual(beams%buckling, by_formula%buckling, 0.03_wp)
      model%numerics%joints_by_need = .false.
      call find(model, model_mcge, smeared)
      call assertLessThan(beams%buckling, 1.2_wp*smeared%buckling, message='more than with couplings all along')
      call assertLessThan(bare%buckling, beams%buckling, message='less than without')
   end subroutine test_couplings

   !> The example as two load cases: tubing is landed in oil, then cement is pumped against pressure of the annulus.
   subroutine test_two_cases()
      type(model_type) :: model
      type(case_result_type) :: results(2)
      type(along_string_type) :: along
      type(length_change_type) :: changes(2)
      type(error_type), allocatable :: error
      integer :: i
      call build_two(model, hold_free, si(cooled, unit_temperature))
      model%cases(2)%wob = 0.0_wp
      model%cases(2)%annulus_pressure = si(annulus, unit_stress)
      model%cases(2)%inside_density = given(si(cement, unit_density))
      do i = 1, 2
         call solve_case(model, model_soft, i, results(i), error)
         call assertFalse(allocated(error))
         call find_along_string(model, results(i), along)
         call find_length_change(model, results(i), along, changes(i))
      end do
      call assertRelativelyEqual(si(published_landed, unit_diameter), total_change(less(changes(2), changes(1))), printed)
      call assertRelativelyEqual(si(published_temperature, unit_diameter), changes(2)%temperature, printed)
   end subroutine test_two_cases

   !> Two load cases: a packer is set, then pressure is pumped and the temperature changes.
   subroutine build_two(model, hold, warmer)
      type(model_type), intent(out) :: model
      integer, intent(in) :: hold
      real(wp), intent(in) :: warmer       !< [K]
      call build(model)
      model%boundary%packer_bore = si(bore, unit_diameter)
      model%boundary%packer_hold = hold
      model%cases = [model%cases(1), model%cases(1)]
      model%cases(1)%wob = si(set_down, unit_force)
      model%cases(2)%length_reference = 1
      model%cases(2)%pump_pressure = si(pumped, unit_stress)
      model%cases(2)%temperature_change_top = warmer
      model%cases(2)%temperature_change_bottom = warmer
   end subroutine build_two

   !> Pull W that brings the lower end back, by the paper's formulas: with the effective compression F = A_p p + W, from F_0 = W_0,
   !>   -((W - W_0) + (A_p - A_i) p) L/(E A) - c^2 (F^2 - F_0^2)/(8 E I w) - 2 nu p A_i L/(E A) + alpha L dt = 0.
   subroutine test_fixed()
      type(model_type) :: model
      integer, allocatable :: failed(:)
      real(wp), parameter :: warmer = -10.0_wp
      real(wp) :: length, area(2), pressure, weight, share, coil, rest, root
      call build_two(model, hold_fixed, warmer)
      call find_packer_loads(model, failed)
      call assertEqual(0, size(failed))
      length = si(depth, unit_length)
      pressure = si(pumped, unit_stress)
      associate (pipe => model%strings(1)%components(1), before => model%cases(1)%wob)
         area = [tube_area(pipe%id, 0.0_wp), tube_area(si(bore, unit_diameter), 0.0_wp)]
         weight = buoyed_weight(pipe, si(oil, unit_density), si(oil, unit_density), model%gravity)
         share = length/axial_stiffness(pipe)
         coil = (0.5_wp*(si(casing, unit_diameter) - pipe%od))**2/(8.0_wp*bending_stiffness(pipe)*weight)
         ! coil F^2 + share F - rest = 0
         rest = share*(area(2)*pressure + before - (area(2) - area(1))*pressure - 2.0_wp*pipe%poisson*pressure*area(1)) + &
                coil*before**2 + pipe%expansion*length*warmer
         root = (-share + sqrt(share**2 + 4.0_wp*coil*rest))/(2.0_wp*coil)
      end associate
      call assertRelativelyEqual(root - area(2)*pressure, model%cases(2)%wob, 1.0e-3_wp)
      call assertTrue(model%cases(2)%wob < 0.0_wp)
   end subroutine test_fixed

   !> A string that shortens stands clear of its shoulder; one that is heated presses on it, as a fixed one does.
   subroutine test_landed()
      type(model_type) :: model, fixed
      integer, allocatable :: failed(:)
      call build_two(model, hold_landed, -10.0_wp)
      call find_packer_loads(model, failed)
      call assertEqual(0, size(failed))
      call assertEqual(0.0_wp, model%cases(2)%wob, 0.0_wp)
      call build_two(model, hold_landed, 60.0_wp)
      call find_packer_loads(model, failed)
      call build_two(fixed, hold_fixed, 60.0_wp)
      call find_packer_loads(fixed, failed)
      call assertTrue(model%cases(2)%wob > 0.0_wp)
      call assertRelativelyEqual(fixed%cases(2)%wob, model%cases(2)%wob, 1.0e-9_wp)
   end subroutine test_landed

   !> Without couplings, free in one mud: w L^2/(2 E A) by its weight in air, -rho g L^2/E by the mud's push on its lower end,
   !> nu rho g L^2/E by the mud all around.
   subroutine test_hanging()
      type(model_type) :: model
      type(length_change_type) :: change
      real(wp) :: length, mud
      call build(model)
      associate (pipe => model%strings(1)%components(1))
         pipe%mass = pipe%density*tube_area(pipe%od, pipe%id)
      end associate
      call find(model, model_soft, change)
      length = si(depth, unit_length)
      mud = si(oil, unit_density)*model%gravity
      associate (pipe => model%strings(1)%components(1))
         call assertRelativelyEqual(length**2*(0.5_wp*(pipe%mass*model%gravity)/axial_stiffness(pipe) - mud/pipe%youngs), &
                                    change%force, 1.0e-9_wp)
         call assertRelativelyEqual(pipe%poisson*mud*length**2/pipe%youngs, change%pressure, 1.0e-9_wp)
      end associate
      call assertEqual(0.0_wp, change%buckling, 0.0_wp)
      call assertEqual(0.0_wp, change%temperature, 0.0_wp)
   end subroutine test_hanging

   !> Pressure inside alone, the lower end plugged: the plug pulls, p A_i L/(E A), and the pipe balloons, -2 nu of that.
   subroutine test_pressure()
      type(model_type) :: model
      type(length_change_type) :: still, change
      real(wp) :: by_formula
      call build(model)
      call find(model, model_soft, still)
      model%cases(1)%pump_pressure = si(pumped, unit_stress)
      call find(model, model_soft, change)
      change = less(change, still)
      associate (pipe => model%strings(1)%components(1))
         by_formula = si(pumped, unit_stress)*tube_area(pipe%id, 0.0_wp)*si(depth, unit_length)/axial_stiffness(pipe)
         call assertRelativelyEqual(by_formula, change%force, 1.0e-9_wp)
         call assertRelativelyEqual(-2.0_wp*pipe%poisson*by_formula, change%pressure, 1.0e-9_wp)
      end associate
      call assertEqual(0.0_wp, change%buckling, 0.0_wp)
   end subroutine test_pressure

   !> Warmer at the bit alone: half of alpha L dt.
   subroutine test_temperature()
      type(model_type) :: model
      type(length_change_type) :: still, change
      call build(model)
      call find(model, model_soft, still)
      model%cases(1)%temperature_change_bottom = 60.0_wp
      call find(model, model_soft, change)
      change = less(change, still)
      call assertRelativelyEqual(0.5_wp*12.42e-6_wp*si(depth, unit_length)*60.0_wp, change%temperature, 1.0e-9_wp)
      call assertEqual(change%temperature, total_change(change), 0.0_wp)
   end subroutine test_temperature

   subroutine test_not_asked()
      type(model_type) :: model
      call build(model)
      model%cases(1)%pump_pressure = si(pumped, unit_stress)
      call assertFalse(asks_for_length(model, model%cases(1)))
      model%mud%fluids(1)%surface_pressure = si(annulus, unit_stress)
      call assertTrue(asks_for_length(model, model%cases(1)))
   end subroutine test_not_asked
end module dg_test_length_change
