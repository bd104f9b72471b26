module dg_test_units
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_kinds, only: wp
   use dg_likely_unit, only: unit_questions
   use dg_quantity, only: quantity_angle, quantity_curvature, quantity_density, quantity_force, quantity_length, &
      quantity_line_load, quantity_mass, quantity_modulus, quantity_moment, quantity_none, quantity_percent, quantity_pressure, &
      quantity_speed, quantity_stress, quantity_text, quantity_time, quantity_turns, quantity_wall, quantity_width, rows, &
      system_base, system_count
   use dg_unit_kind, only: unit_factor, unit_label
   use dg_units, only: base_units, deck_system, field_units, si_units, unit_in, unit_system, unit_system_type
   implicit none
   private
   public :: units_suite

   !> The factors are exact products of a few numbers: some roundings.
   real(wp), parameter :: rounding = 8.0_wp*epsilon(1.0_wp)

contains

   function units_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('units')
      call suite%addTest(TestMethod('si_is_the_default', test_si_is_the_default))
      call suite%addTest(TestMethod('field_factors', test_field_factors))
      call suite%addTest(TestMethod('field_labels', test_field_labels))
      call suite%addTest(TestMethod('metric', test_metric))
      call suite%addTest(TestMethod('each_quantity_in_each_system', test_table))
      call suite%addTest(TestMethod('components_are_those_of_the_table', test_components))
      call suite%addTest(TestMethod('likely_units', test_likely))
   end function units_suite

   subroutine test_si_is_the_default()
      type(unit_system_type) :: units
      units = si_units()
      call assertEqual('SI', units%name)
      call assertEqual(1.0_wp, units%length)
      call assertEqual(1.0e3_wp, units%force)
      call assertEqual(1.0e-3_wp, units%diameter)
      call assertRelativelyEqual(degree/30.0_wp, units%curvature, rounding)
   end subroutine test_si_is_the_default

   !> NIST SP 811, appendix B.8 (seven digits given there; the exact ones follow from foot, inch, pound).
   subroutine test_field_factors()
      type(unit_system_type) :: units
      real(wp), parameter :: printed = 1.0e-6_wp !< NIST prints seven significant digits
      units = field_units()
      call assertEqual(0.3048_wp, units%length)
      call assertEqual(0.0254_wp, units%diameter)
      call assertRelativelyEqual(1.488164_wp, units%mass_per_length, printed, message='lbm/ft')
      call assertRelativelyEqual(119.8264_wp, units%density, printed, message='lbm/gal')
      call assertRelativelyEqual(4448.222_wp, units%force, printed, message='klbf')
      call assertRelativelyEqual(1355.818_wp, units%moment, printed, message='kft.lbf')
      call assertRelativelyEqual(6.894757e9_wp, unit_factor(units, quantity_modulus), printed, message='1e6 psi')
      call assertRelativelyEqual(6.894757e6_wp, units%stress, printed, message='ksi')
      call assertRelativelyEqual(47880.26_wp, units%wall_stiffness, printed, message='klbf/ft2')
      call assertRelativelyEqual(14593.90_wp, unit_factor(units, quantity_line_load), printed, message='klbf/ft')
      call assertRelativelyEqual(degree/30.48_wp, units%curvature, rounding, message='deg/100 ft')
   end subroutine test_field_factors

   subroutine test_field_labels()
      type(unit_system_type) :: units
      units = field_units()
      call assertEqual('field', units%name)
      call assertEqual('ft', units%length_label)
      call assertEqual('klbf', units%force_label)
      call assertRelativelyEqual(6894.757_wp, unit_factor(units, quantity_pressure), 1.0e-6_wp, message='psi')
   end subroutine test_field_labels

   !> Units of a Norwegian rig.
   subroutine test_metric()
      type(unit_system_type) :: units
      integer, parameter :: quantities(13) = [quantity_length, quantity_width, quantity_angle, quantity_mass, quantity_density, &
         quantity_force, quantity_moment, quantity_line_load, quantity_modulus, quantity_stress, quantity_pressure, quantity_wall, &
         quantity_curvature]
      real(wp), parameter :: si(13) = [1.0_wp, 0.0254_wp, degree, 1.0_wp, 1.0e3_wp, 1.0e4_wp, 1.0e3_wp, 1.0e4_wp, 1.0e9_wp, &
         1.0e5_wp, 1.0e5_wp, 1.0e4_wp, degree/30.0_wp]
      character(8), parameter :: suffix(13) = [character(8) :: 'm', 'in', 'deg', 'kg_m', 'sg', 'kdaN', 'kNm', 'kdaN_m', 'GPa', &
         'bar', 'bar', 'kdaN_m2', 'deg_30m']
      integer :: i
      units = unit_system('Metric')
      call assertEqual('metric', units%name)
      do i = 1, size(quantities)
         call assertRelativelyEqual(si(i), unit_factor(units, quantities(i)), rounding, message=suffix(i))
         associate (unit => unit_in(units, quantities(i)))
            call assertEqual(trim(suffix(i)), trim(unit%suffix))
         end associate
      end do
      call assertRelativelyEqual(1.0_wp, unit_factor(units, quantity_speed), rounding)
      call assertEqual('kN.m', unit_label(units, quantity_moment))
      call assertEqual('kdaN/m', unit_label(units, quantity_line_load))
      call assertEqual(0, deck_system('base'), message='no deck has the units of programs')
      call assertEqual(0, deck_system('metres'))
   end subroutine test_metric

   !> Rows stand at the number of their quantity, and each has a label, a suffix that follows from it, and a factor everywhere.
   subroutine test_table()
      character(20) :: place
      integer :: quantity, system
      do quantity = lbound(rows, 1), ubound(rows, 1)
         call assertEqual(quantity, rows(quantity)%quantity)
         do system = 1, system_count
            write (place, '(a, i0, a, i0)') 'row ', quantity, ', system ', system
            associate (unit => rows(quantity)%units(system))
               call assertTrue(unit%factor > 0.0_wp, message=place)
               select case (quantity)
               case (quantity_none, quantity_text)
                  call assertEqual('', trim(unit%label)//trim(unit%suffix), message=place)
               case (quantity_time)
                  call assertEqual('s', trim(unit%label), message=place)
                  call assertEqual('', trim(unit%suffix), message=place)
               case (quantity_percent)
                  call assertEqual('pct', trim(unit%suffix), message=place)
               case default
                  call assertTrue(unit%label /= '', message=place)
                  call assertEqual(plain(trim(unit%label)), trim(unit%suffix), message=place)
               end select
            end associate
            if (system == system_base .and. quantity /= quantity_turns) &
               call assertEqual(1.0_wp, rows(quantity)%units(system)%factor, message=place)
         end do
      end do
   contains
      !> A label without points, and with _ for other marks but that of deg/30 m, which has one blank.
      function plain(label) result(suffix)
         character(*), intent(in) :: label
         character(:), allocatable :: suffix
         integer :: i
         suffix = ''
         do i = 1, len(label)
            if (label(i:i) == '.') cycle
            if (label(i:i) == ' ' .and. index(label, '1e6') /= 1) cycle
            if (scan(label(i:i), '/ ') == 1) suffix = suffix//'_'
            if (label(i:i) == '%') suffix = suffix//'pct'
            if (scan(label(i:i), '/ %') == 0) suffix = suffix//label(i:i)
         end do
      end function plain
   end subroutine test_table

   !> Compare the units that a system holds with the table; a system by default is SI.
   subroutine test_components()
      type(unit_system_type) :: systems(4), default
      integer :: i
      systems = [si_units(), field_units(), unit_system('metric'), base_units()]
      call check(default)
      call assertEqual('SI', default%name)
      do i = 1, size(systems)
         call check(systems(i))
      end do
   contains
      subroutine check(units)
         type(unit_system_type), intent(in) :: units
         call assertEqual([unit_factor(units, quantity_length), unit_factor(units, quantity_width), &
            unit_factor(units, quantity_angle), unit_factor(units, quantity_mass), unit_factor(units, quantity_density), &
            unit_factor(units, quantity_force), unit_factor(units, quantity_moment), unit_factor(units, quantity_stress), &
            unit_factor(units, quantity_curvature), unit_factor(units, quantity_wall)], &
            [units%length, units%diameter, units%angle, units%mass_per_length, units%density, units%force, units%moment, &
             units%stress, units%curvature, units%wall_stiffness], message=units%name)
         call assertEqual(unit_label(units, quantity_length), trim(units%length_label))
         call assertEqual(unit_label(units, quantity_force), trim(units%force_label))
      end subroutine check
   end subroutine test_components

   !> Units that people write in place of those of a deck, with the right number.
   subroutine test_likely()
      real(wp), parameter :: steel(2) = [230.0e6_wp, 1250.0e6_wp], mud(2) = [780.0_wp, 2700.0_wp]
      call assertEqual('. Is it in kg/m3? Then write 1.26', asked(unit_system('metric'), quantity_density, 1260.0_wp, mud))
      call assertEqual('. Is it in MPa? Then write 9310. Is it in psi? Then write 64.19', &
                       asked(unit_system('metric'), quantity_stress, 931.0_wp, [1.0e6_wp, 1250.0e6_wp]))
      call assertEqual('. Is it in psi? Then write 135', asked(field_units(), quantity_stress, 135000.0_wp, steel))
      call assertEqual('. Is it in MPa? Then write 135', asked(field_units(), quantity_stress, 931.0_wp, steel), &
                       message='softer than any steel in psi')
      call assertEqual('. Is it in pcf (lbm/ft3)? Then write 12.03', asked(field_units(), quantity_density, 90.0_wp, mud), &
                       message='gallons in a cubic foot')
      call assertEqual('. Is it in kg/m3? Then write 10.52', asked(field_units(), quantity_density, 1260.0_wp, mud), &
                       message='heavier than any mud in pcf')
      call assertEqual('', asked(field_units(), quantity_density, 12600.0_wp, mud), message='heavier than any mud')
      call assertEqual('', asked(si_units(), quantity_text, 90.0_wp, mud), message='no unit')
   contains
      function asked(units, quantity, number, range) result(text)
         type(unit_system_type), intent(in) :: units
         integer, intent(in) :: quantity
         real(wp), intent(in) :: number, range(2)
         character(:), allocatable :: text
         text = unit_questions(units, quantity, number, range(1), range(2), 4)
      end function asked
   end subroutine test_likely
end module dg_test_units
