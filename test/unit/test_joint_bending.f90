module dg_test_joint_bending
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_joint_bending, only: joint_magnification, pulled_magnification
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   implicit none
   private
   public :: joint_bending_suite

   real(wp), parameter :: rounding = 1.0e-12_wp
   !> EI and half span of one: the force is (kL)^2; a straight hole, in which no body comes to the wall.
   real(wp), parameter :: one = 1.0_wp, straight = 0.0_wp, stand_off = 0.02_wp

contains

   function joint_bending_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('joint_bending')
      call suite%addTest(TestMethod('closed_form', test_closed_form))
      call suite%addTest(TestMethod('slack', test_slack))
      call suite%addTest(TestMethod('body_on_the_wall', test_body))
      call suite%addTest(TestMethod('pulled_to_the_wall', test_pulled))
   end function joint_bending_suite

   !> 2/tanh(2) = 2.0746294414550963, 1/sin(1) = 1.1883951057781212; no half wave fits in kL = pi.
   subroutine test_closed_form()
      call assertRelativelyEqual(2.0746294414550963_wp, joint_magnification(4.0_wp, one, one, straight, stand_off), rounding)
      call assertRelativelyEqual(1.1883951057781212_wp, joint_magnification(-1.0_wp, one, one, straight, stand_off), rounding)
      call assertRelativelyEqual(2.0746294414550963_wp, joint_magnification(1.0e5_wp, 4.0e5_wp, 4.0_wp, straight, stand_off), &
                                 rounding, message='k = sqrt(T/EI) = 1/2, L = 4')
      call assertTrue(is_missing(joint_magnification(-10.0_wp, one, one, straight, stand_off)), message='beyond pi')
   end subroutine test_closed_form

   !> One without force, and no jump where the series ends: kL/tanh(kL) = 1 + x/3 - x^2/45, x = (kL)^2 = 1e-4.
   subroutine test_slack()
      call assertEqual(1.0_wp, joint_magnification(0.0_wp, one, one, straight, stand_off))
      call assertEqual(joint_magnification(1.0001e-4_wp, one, one, straight, stand_off), &
                       joint_magnification(0.9999e-4_wp, one, one, straight, stand_off), 1.0e-8_wp)
      call assertEqual(joint_magnification(-1.0001e-4_wp, one, one, straight, stand_off), &
                       joint_magnification(-0.9999e-4_wp, one, one, straight, stand_off), 1.0e-8_wp)
   end subroutine test_slack

   !> In compression kL = 1 the body comes outwards by (tan(1/2) - 1/2) L^2/R = 0.046302 L^2/R; in tension the factor stays.
   subroutine test_body()
      real(wp), parameter :: touching = 0.02_wp/(0.54630248984379051_wp - 0.5_wp)
      call assertRelativelyEqual(1.1883951057781212_wp, joint_magnification(-1.0_wp, one, one, 0.999_wp*touching, stand_off), &
                                 rounding, message='just clear')
      call assertTrue(is_missing(joint_magnification(-1.0_wp, one, one, 1.001_wp*touching, stand_off)), message='touches')
      call assertRelativelyEqual(2.0746294414550963_wp, joint_magnification(4.0_wp, one, one, touching, stand_off), rounding)
   end subroutine test_body

   !> Against finite differences (800 steps of second order, the wall as a bound): body at the wall at mid-span, or along a length.
   subroutine test_pulled()
      real(wp), parameter :: kl(6) = [1.0_wp, 3.0_wp, 3.0_wp, 6.0_wp, 6.0_wp, 10.0_wp]
      real(wp), parameter :: share(6) = [0.02_wp, 0.05_wp, 0.1_wp, 0.05_wp, 0.02_wp, 0.03_wp]     ! stand-off over L^2/R
      real(wp), parameter :: factor(6) = [1.20395_wp, 1.94868_wp, 2.34196_wp, 2.89734_wp, 2.19998_wp, 3.44940_wp]
      real(wp), parameter :: within = 2.0e-4_wp
      integer :: i
      do i = 1, size(kl)
         call assertRelativelyEqual(factor(i), pulled_magnification(kl(i)**2, one, one, 0.1_wp, 0.1_wp*share(i)), within)
      end do
      call assertRelativelyEqual(2.0746294414550963_wp, pulled_magnification(4.0_wp, one, one, straight, stand_off), rounding)
      call assertEqual(1.0_wp, pulled_magnification(0.0_wp, one, one, 0.1_wp, 0.0_wp))
   end subroutine test_pulled
end module dg_test_joint_bending
