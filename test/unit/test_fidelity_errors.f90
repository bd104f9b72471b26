!> Errors of printed quantities against those at fidelity reference.
module dg_test_fidelity_errors
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_fidelity_errors, only: fidelity_errors, printed_type, quantity_count
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   implicit none
   private
   public :: fidelity_errors_suite

   real(wp), parameter :: tolerance = 1.0e-12_wp

contains

   function fidelity_errors_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('fidelity_errors')
      call suite%addTest(TestMethod('relative', test_relative))
      call suite%addTest(TestMethod('small_and_missing', test_small))
      call suite%addTest(TestMethod('jump', test_jump))
   end function fidelity_errors_suite

   !> Every quantity large: each error is relative to the quantity of the reference.
   subroutine test_relative()
      type(printed_type) :: printed, reference
      real(wp) :: errors(quantity_count)
      reference = sample()
      printed = reference
      printed%hookload = 1.01_wp*reference%hookload
      printed%torque = 0.98_wp*reference%torque
      printed%contact_sum = 1.03_wp*reference%contact_sum
      printed%moments = [1.0e3_wp, 5.2e3_wp, 1.0e3_wp]
      printed%side_force = 0.95_wp*reference%side_force
      printed%tilt = 1.06_wp*reference%tilt
      printed%von_mises = 1.07_wp*reference%von_mises
      errors = fidelity_errors(printed, reference)
      call assertEqual([0.01_wp, 0.02_wp, 0.03_wp, 0.04_wp, 0.04_wp, 0.05_wp, 0.06_wp, 0.07_wp], errors, tolerance)
   end subroutine test_relative

   !> A small hook load counts over 0.3 of the weight, a torque below 0.1 kN.m and a bit that nothing holds have no error.
   subroutine test_small()
      type(printed_type) :: printed, reference
      real(wp) :: errors(quantity_count)
      reference = sample()
      reference%hookload = 1.0e3_wp
      reference%torque = 50.0_wp
      reference%tilt = 1.0e-5_wp
      printed = reference
      printed%hookload = 4.0e3_wp
      printed%tilt = 3.6e-4_wp
      printed%side_force = printed_side()
      errors = fidelity_errors(printed, reference)
      call assertEqual(3.0e3_wp/(0.3_wp*reference%weight), errors(1), tolerance)
      call assertTrue(is_missing(errors(2)), message='torque')
      call assertTrue(is_missing(errors(6)), message='side force')
      call assertEqual(1.0_wp, errors(7), tolerance)
   end subroutine test_small

   !> Two rows at one depth of which the moments differ: equal profiles have no error, whatever other rows they have.
   subroutine test_jump()
      type(printed_type) :: printed, reference
      real(wp) :: errors(quantity_count)
      reference = sample()
      reference%md = [0.0_wp, 10.0_wp, 10.0_wp, 20.0_wp]
      reference%moments = [0.0_wp, 1.0e3_wp, 3.0e3_wp, 1.0e3_wp]
      printed = reference
      printed%md = [0.0_wp, 5.0_wp, 10.0_wp, 10.0_wp, 15.0_wp, 20.0_wp]
      printed%moments = [0.0_wp, 0.5e3_wp, 1.0e3_wp, 3.0e3_wp, 2.0e3_wp, 1.0e3_wp]
      errors = fidelity_errors(printed, reference)
      call assertEqual([0.0_wp, 0.0_wp], errors(4:5), tolerance)
   end subroutine test_jump

   pure function sample() result(printed)
      type(printed_type) :: printed
      printed%hookload = 500.0e3_wp
      printed%weight = 600.0e3_wp
      printed%torque = 10.0e3_wp
      printed%contact_sum = 200.0e3_wp
      printed%side_force = 4.0e3_wp
      printed%tilt = 0.01_wp
      printed%von_mises = 200.0e6_wp
      printed%md = [0.0_wp, 100.0_wp, 200.0_wp]
      printed%moments = [1.0e3_wp, 5.0e3_wp, 1.0e3_wp]
   end function sample

   !> Of a bit that nothing holds.
   pure function printed_side() result(force)
      real(wp) :: force
      type(printed_type) :: empty
      force = empty%side_force
   end function printed_side
end module dg_test_fidelity_errors
