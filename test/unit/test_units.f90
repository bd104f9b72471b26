module dg_test_units
   use funit, only: assertEqual, assertRelativelyEqual, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_kinds, only: wp
   use dg_units, only: field_units, si_units, unit_system_type
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
   end function units_suite

   subroutine test_si_is_the_default()
      type(unit_system_type) :: units
      units = si_units()
      call assertEqual('SI', units%name)
      call assertEqual(1.0_wp, units%length)
      call assertEqual(1.0e3_wp, units%force)
      call assertEqual(1.0e-3_wp, units%diameter)
      call assertRelativelyEqual(degree/30.0_wp, units%curvature, rounding)
      call assertEqual('kNm', units%moment_label)
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
      call assertRelativelyEqual(6.894757e9_wp, units%modulus, printed, message='1e6 psi')
      call assertRelativelyEqual(6.894757e6_wp, units%stress, printed, message='ksi')
      call assertRelativelyEqual(47880.26_wp, units%wall_stiffness, printed, message='klbf/ft2')
      call assertRelativelyEqual(14593.90_wp, units%force_per_length, printed, message='klbf/ft')
      call assertRelativelyEqual(degree/30.48_wp, units%curvature, rounding, message='deg/100 ft')
   end subroutine test_field_factors

   subroutine test_field_labels()
      type(unit_system_type) :: units
      units = field_units()
      call assertEqual('field', units%name)
      call assertEqual('ft', units%length_label)
      call assertEqual('klbf', units%force_label)
      call assertEqual('kftlbf', units%moment_label)
   end subroutine test_field_labels
end module dg_test_units
