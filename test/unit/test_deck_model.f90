!> Decks read to the end: values in SI units, defaults, strings, operations.
module dg_test_deck_model
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_constants, only: degree, pi
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: hold_in_range, key_rule_type, kind_real
   use dg_error, only: error_list_type, error_text, error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_job, only: job_type, model_mcge, model_soft
   use dg_load_case, only: operation_backream, operation_trip_out
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_nodes, numerics_type
   use dg_read_deck, only: read_deck
   use dg_text, only: append_text, text_type, to_text
   use dg_unit_kind, only: unit_factor
   use dg_units, only: field_units, si_units
   implicit none
   private
   public :: deck_model_suite

   character(*), parameter :: path = 'build/test_deck_model.nml'
   !> Relative tolerance of converted values: some roundings of a double.
   real(wp), parameter :: rounding = 1.0e-14_wp

contains

   function deck_model_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('deck_model')
      call suite%addTest(TestMethod('si_units_and_defaults', test_si, tearDown=remove_deck))
      call suite%addTest(TestMethod('field_units', test_field, tearDown=remove_deck))
      call suite%addTest(TestMethod('all_keys', test_all_keys, tearDown=remove_deck))
      call suite%addTest(TestMethod('depth_a_hair_too_deep', test_hair, tearDown=remove_deck))
      call suite%addTest(TestMethod('ends_of_ranges', test_ends_of_ranges))
   end function deck_model_suite

   subroutine remove_deck()
      call delete_file(path)
   end subroutine remove_deck

   subroutine read_text(lines, model, job)
      type(text_type), intent(in) :: lines(:)
      type(model_type), intent(out) :: model
      type(job_type), intent(out) :: job
      type(error_list_type) :: faults
      type(error_type), allocatable :: error
      character(:), allocatable :: first
      call write_text_file(path, lines, error)
      call assertFalse(allocated(error), message='scratch deck written')
      call read_deck(path, model, job, faults)
      first = ''
      if (faults%count > 0) first = error_text(faults%items(1))
      call assertEqual('', first, message='no fault')
   end subroutine read_text

   subroutine test_si()
      type(model_type) :: model
      type(job_type) :: job
      type(text_type), allocatable :: lines(:)
      type(numerics_type) :: default
      call append_text(lines, '&trajectory md = 0, 1000, inc = 0, 90 azi = 0, 0 /')
      call append_text(lines, '&hole diameter = 215.9 friction = 0.25 /')
      call append_text(lines, "&component kind = 'pipe' od = 127 id = 108.6 /")
      call append_text(lines, "&load_case name='a' operation='up' bit_depth=900 friction_axial=0.1 measured_hookload = 300 /")
      call read_text(lines, model, job)
      if (.not. allocated(model%cases)) return
      call assertEqual([model_mcge], job%models)
      call assertEqual('output/test_deck_model', job%output_dir)
      call assertEqual(1, size(job%notes), message='no fluid')
      call assertEqual(90.0_wp*degree, model%trajectory%inclination(2), rounding)
      call assertEqual(0.0_wp, model%holes(1)%md_top)
      call assertEqual(1000.0_wp, model%holes(1)%md_bottom, message='to the last station')
      call assertEqual(0.2159_wp, model%holes(1)%diameter, rounding)
      call assertEqual(0.25_wp, model%holes(1)%friction_axial)
      call assertEqual(0.25_wp, model%holes(1)%friction_rotary)
      associate (part => model%strings(1)%components(1))
         call assertEqual('main', model%strings(1)%name)
         call assertEqual('pipe', part%name, message='named by its kind')
         call assertEqual(0.0_wp, part%length)
         call assertEqual(206.0e9_wp, part%youngs)
         call assertEqual(0.3_wp, part%poisson)
         call assertEqual(9.5_wp, part%joint_spacing)
         ! steel tube: pi/4 (0.127**2 - 0.1086**2) m2 of 7850 kg/m3
         call assertEqual(7850.0_wp*0.25_wp*pi*(0.127_wp**2 - 0.1086_wp**2), part%mass, 1.0e-12_wp)
      end associate
      associate (case => model%cases(1))
         call assertEqual(operation_trip_out, case%operation)
         call assertEqual(900.0_wp, case%bit_depth)
         call assertTrue(case%friction_axial%present)
         call assertEqual(0.1_wp, case%friction_axial%value)
         call assertFalse(case%friction_rotary%present)
         call assertEqual(300.0e3_wp, case%measured_hookload%value)
         call assertFalse(case%reference_hookload%present)
      end associate
      call assertTrue(model%boundary%top_centred .and. model%boundary%bit_centred)
      call assertEqual(default%tolerance, model%numerics%tolerance)
      call assertEqual(default%gk_max, model%numerics%gk_max)
      call assertEqual(9.80665_wp, model%gravity)
      call assertEqual(0.0_wp, model%mud%fluids(1)%density)
   end subroutine test_si

   !> NIST SP 811: 1 ft = 0.3048 m, 1 in = 25.4 mm, 1 lbm/ft = 1.488163944 kg/m, 1 lbm/gal = 119.826427 kg/m3,
   !> 1 klbf = 4448.2216152605 N.
   subroutine test_field()
      real(wp), parameter :: printed_digits = 1.0e-8_wp   ! relative, of the factors above
      type(model_type) :: model
      type(job_type) :: job
      type(text_type), allocatable :: lines(:)
      call append_text(lines, "&job units = 'FIELD', models = 'soft', 'mcge' /")
      call append_text(lines, '&trajectory md = 0, 1000, inc = 0, 0 /')
      call append_text(lines, '&hole diameter = 8.5 /')
      call append_text(lines, '&fluid density = 10 /')
      call append_text(lines, '&component od = 5, mass = 20 /')
      call append_text(lines, "&load_case name = 'a', operation = 'rotary', bit_depth = 1000, wob = 10, tob = 1")
      call append_text(lines, '  pump_pressure = 3000 /')
      call read_text(lines, model, job)
      if (.not. allocated(model%cases)) return
      call assertEqual([model_soft, model_mcge], job%models)
      call assertEqual('field', trim(job%units%name))
      call assertEqual(304.8_wp, model%trajectory%md(2), 1.0e-12_wp)
      call assertEqual(0.2159_wp, model%holes(1)%diameter, rounding)
      call assertEqual(1198.26427_wp, model%mud%fluids(1)%density, 1198.0_wp*printed_digits)
      call assertEqual(29.76327888_wp, model%strings(1)%components(1)%mass, 30.0_wp*printed_digits)
      call assertEqual(206.0e9_wp, model%strings(1)%components(1)%youngs, message='defaults are SI in any deck')
      call assertEqual(7850.0_wp, model%strings(1)%components(1)%density)
      call assertEqual(44482.216152605_wp, model%cases(1)%wob, 44482.0_wp*printed_digits)
      call assertEqual(1355.8179483_wp, model%cases(1)%tob, 1356.0_wp*printed_digits)
      call assertEqual(20684271.87950_wp, model%cases(1)%pump_pressure, 2.0e7_wp*printed_digits, message='psi')
   end subroutine test_field

   subroutine test_all_keys()
      type(model_type) :: model
      type(job_type) :: job
      type(text_type), allocatable :: lines(:)
      call append_text(lines, "&job title='t' output_dir='x/y' gravity=9.81 hdf5=.true. plots=.true. profiles=f threads=2 /")
      call append_text(lines, "&trajectory md=0,1000 inc=0,20 azi=350,370 interpolation='spline' /")
      call append_text(lines, "&hole name='lower' md_top=600 md_bottom=1000 diameter=200 friction=0.2 friction_rotary=0.1 /")
      call append_text(lines, "&hole name='upper' md_bottom=600 md_top=0 diameter=220 wall_stiffness=5000 mud_sheath=2 /")
      call append_text(lines, "&component string='b' od=100 length=20 density=8000 youngs=70 poisson=0.25 yield=500 /")
      call append_text(lines, "&component string='main' od=120 id=100 joint_od=150 joint_length=0.5 joint_spacing=12")
      call append_text(lines, "  friction_scale=0.8 friction_scale_axial=0.7 /")
      call append_text(lines, "&component string='b' od=110 mass=0 friction=0.15 friction_axial=0.05 /")
      call append_text(lines, "&centralizer string='b' component='drillpipe' kind='bow' od=220 spacing=12 restoring_force=7")
      call append_text(lines, "  running_force=0.5 friction_axial=0.2 /")
      call append_text(lines, "&boundary top_lateral='free' bit_lateral='Centred' /")
      call append_text(lines, "&load_case name='a' section='s' operation='backream' bit_depth=900 wob=-5 string='b'")
      call append_text(lines, "  friction=0.3 friction_rotary=0 rpm=60 trip_speed=0.2 measured_torque=2 reference_hookload=15 /")
      call append_text(lines, "&solver element_length=5 gap_location='nodes' tolerance=1e-6 max_iterations=7 load_steps=3")
      call append_text(lines, "  gk_min=1e-5 gk_contact=2e6 eps_n0=1e-7 eps_nmax=0.1 r_n0=0.01 history=.true. relocation=0.1")
      call append_text(lines, "  step_limit=2 imperfection=0.01 linear_solver='banded' fidelity='standard' /")
      call read_text(lines, model, job)
      if (.not. allocated(model%cases)) return
      call assertEqual(4, size(job%notes), message='no fluid, a solid bar, two materials, string main is used by no case')
      call assertEqual(2, job%threads)
      call assertEqual('x/y', job%output_dir)
      call assertFalse(job%profiles)
      call assertEqual(9.81_wp, model%gravity)
      call assertEqual('upper', model%holes(1)%name, message='from the top down')
      call assertEqual(600.0_wp, model%holes(2)%md_top)
      call assertEqual(1000.0_wp, model%holes(2)%md_bottom)
      call assertEqual(5.0e6_wp, model%holes(1)%wall_stiffness)
      call assertEqual(2.0e-3_wp, model%holes(1)%mud_sheath, rounding)
      call assertEqual(0.2_wp, model%holes(2)%friction_axial)
      call assertEqual(0.1_wp, model%holes(2)%friction_rotary)
      call assertEqual(2, size(model%strings))
      call assertEqual('b', model%strings(1)%name)
      call assertEqual(2, size(model%strings(1)%components))
      call assertEqual(70.0e9_wp, model%strings(1)%components(1)%youngs)
      call assertEqual(500.0e6_wp, model%strings(1)%components(1)%yield)
      call assertEqual(0.0_wp, model%strings(1)%components(2)%mass, message='weightless where the deck says so')
      call assertEqual(0.05_wp, model%strings(1)%components(2)%friction_axial)
      call assertEqual(0.15_wp, model%strings(1)%components(2)%friction_rotary)
      call assertTrue(is_missing(model%strings(1)%components(1)%friction_axial), message='that of the hole')
      call assertEqual(0.15_wp, model%strings(2)%components(1)%joint_od, rounding)
      call assertFalse(model%strings(2)%components(1)%centralizer%present, message='of another string')
      associate (bow => model%strings(1)%components(2)%centralizer)
         call assertTrue(bow%present .and. bow%bow)
         call assertEqual([0.22_wp, 0.22_wp, 12.0_wp, 6.0_wp], [bow%od, bow%rated_hole, bow%spacing, bow%first], rounding)
         call assertEqual([7.0e3_wp, 500.0_wp, 0.2_wp], [bow%restoring_force, bow%running_force, bow%friction_axial], rounding)
         call assertTrue(is_missing(bow%friction_rotary), message='that of the component')
      end associate
      call assertEqual(0.7_wp, model%strings(2)%components(1)%scale_axial)
      call assertEqual(0.8_wp, model%strings(2)%components(1)%scale_rotary)
      call assertFalse(model%boundary%top_centred)
      call assertTrue(model%boundary%bit_centred)
      associate (case => model%cases(1))
         call assertEqual(operation_backream, case%operation)
         call assertEqual(-5000.0_wp, case%wob)
         call assertEqual(0.3_wp, case%friction_axial%value)
         call assertTrue(case%friction_rotary%present)
         call assertEqual(0.0_wp, case%friction_rotary%value)
         call assertEqual(2.0_wp*pi, case%angular_speed, rounding*10.0_wp)
         call assertEqual(0.2_wp, case%trip_speed)
         call assertEqual(2000.0_wp, case%measured_torque%value)
         call assertEqual('s', case%section)
      end associate
      associate (numerics => model%numerics)
         call assertEqual(gap_at_nodes, numerics%gap_location)
         call assertEqual(7, numerics%max_iterations)
         call assertEqual(3, numerics%load_steps)
         call assertEqual(2.0e9_wp, numerics%gk_contact)
         call assertEqual(2.0e10_wp, numerics%gk_max, message='goes with gk_contact where not given')
         call assertEqual(1.0e-2_wp, numerics%gk_min, rounding)
         call assertEqual(10.0_wp, numerics%r_n0)
         call assertTrue(numerics%history)
      end associate
   end subroutine test_all_keys

   !> A bit below the survey by less than round-off stands at its end.
   subroutine test_hair()
      type(model_type) :: model
      type(job_type) :: job
      type(text_type), allocatable :: lines(:)
      call append_text(lines, '&trajectory md = 0, 999.9999 inc = 0, 0 /')
      call append_text(lines, '&hole diameter = 200 /')
      call append_text(lines, '&component od = 100 /')
      call append_text(lines, "&load_case name = 'a', operation = 'static', bit_depth = 1000 /")
      call read_text(lines, model, job)
      if (.not. allocated(model%cases)) return
      call assertEqual(999.9999_wp, model%cases(1)%bit_depth)
   end subroutine test_hair

   !> The ends of all ranges in field units, as --convert writes them: legal, and the very ends. What is beyond them is not.
   subroutine test_ends_of_ranges()
      character(*), parameter :: groups(5) = [character(11) :: 'job', 'hole', 'component', 'load_case', 'solver']
      integer, parameter :: digits = 14
      real(wp), parameter :: rounded = 1.0e-7_wp, beyond = 1.0e-6_wp
      type(key_rule_type), allocatable :: rules(:)
      character(:), allocatable :: written
      real(wp) :: number, factor, ending
      integer :: i, k, d, checked
      logical :: holds
      checked = 0
      do i = 1, size(groups)
         rules = keys_of(trim(groups(i)))
         do k = 1, size(rules)
            if (rules(k)%kind /= kind_real .or. .not. abs(rules(k)%high) < huge(1.0_wp)) cycle
            factor = unit_factor(field_units(), rules(k)%unit)
            ending = rules(k)%high*unit_factor(si_units(), rules(k)%unit)
            written = to_text(ending/factor, digits)
            read (written, *) number
            do d = -1, 1         ! fewer digits where they lie within that
               number = number*factor*(1.0_wp + d*rounded)
               call hold_in_range(rules(k), number, holds)
               call assertTrue(holds, message=trim(rules(k)%key)//' = '//written)
               call assertTrue(number <= ending, message=trim(rules(k)%key)//' is not beyond its range')
               number = ending/factor
            end do
            number = ending*(1.0_wp + beyond)
            call hold_in_range(rules(k), number, holds)
            call assertFalse(holds, message=trim(rules(k)%key)//' beyond its range')
            checked = checked + 1
         end do
      end do
      call assertTrue(checked > 40, message='keys with an end')
   end subroutine test_ends_of_ranges
end module dg_test_deck_model
