!> Sentences of verdicts that are set by hand: numbers that add up, limits that are passed together.
module dg_test_verdict_text
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type
   use dg_missing, only: given
   use dg_units, only: si_units
   use dg_utilisation, only: limit_makeup, limit_tension, limit_top_drive
   use dg_verdict, only: answer_no, answer_yes, verdict_type
   use dg_verdict_text, only: verdict_sentences
   implicit none
   private
   public :: verdict_text_suite

contains

   function verdict_text_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('verdict_text')
      call suite%addTest(TestMethod('sums', test_sums))
      call suite%addTest(TestMethod('limits_passed', test_passed))
   end function verdict_text_suite

   !> The three numbers add up. The load is rounded as in tables. What is hardly too much is a step too much.
   subroutine test_sums()
      call expect(741.2_wp, 2465.0_wp, 'Nearest limit: tension of the pipe, 741 of 2465 kN, 30.1 % used, 1724 kN left')
      call expect(245.4_wp, 322.53_wp, 'Nearest limit: tension of the pipe, 245.4 of 322.5 kN, 76.1 % used, 77.1 kN left')
      call expect(245.42_wp, 322.49_wp, 'Nearest limit: tension of the pipe, 245.4 of 322.4 kN, 76.1 % used, 77 kN left')
      call expect(1470.4_wp, 1500.0_wp, 'Close to its limit: tension of the pipe, 1470.4 of 1500 kN, 98 % used, 29.6 kN left')
      call expect(1008.5_wp, 2500.0_wp, 'Nearest limit: tension of the pipe, 1009 of 2500 kN, 40.3 % used, 1491 kN left')
      call expect(1019.6_wp, 2452.0_wp, 'Nearest limit: tension of the pipe, 1020 of 2452 kN, 41.6 % used, 1432 kN left')
      call expect(0.0_wp, 1500.0_wp, 'Nearest limit: tension of the pipe, 0 of 1500 kN, 0 % used, 1500 kN left')
      call expect(1500.0_wp, 1500.0_wp, 'Close to its limit: tension of the pipe, 1500 of 1500 kN, 100 % used, 0 kN left')
      call expect(366.297_wp, 322.53_wp, 'Tension of the pipe: 366.3 kN, 322.5 kN allowed, 43.8 kN too much')
      call expect(322.5004_wp, 322.5_wp, 'Tension of the pipe: 322.51 kN, 322.5 kN allowed, 0.01 kN too much')
   end subroutine test_sums

   !> Each further limit that is passed has its share of it, but the one that the sentence begins with.
   subroutine test_passed()
      type(load_case_type) :: load_case
      type(verdict_type) :: verdict
      verdict = verdict_of(38.0_wp, 35.0_wp)
      verdict%passed([limit_tension, limit_top_drive, limit_makeup]) = [1.0857_wp, 1.0495_wp, 1.32_wp]
      call assertEqual('Tension of the pipe: 38 kN, 35 kN allowed, 3 kN too much. Also passed: make-up torque (132 %), '// &
                       'top drive (105 %)', verdict_sentences(si_units(), load_case, verdict))
      verdict%passed([limit_top_drive, limit_makeup]) = [1.002_wp, 1.00001_wp]
      call assertEqual('Tension of the pipe: 38 kN, 35 kN allowed, 3 kN too much. Also passed: make-up torque (100.001 %), '// &
                       'top drive (100.2 %)', verdict_sentences(si_units(), load_case, verdict), message='next to 100 %')
      verdict%passed = 0.0_wp
      call assertEqual('Tension of the pipe: 38 kN, 35 kN allowed, 3 kN too much', &
                       verdict_sentences(si_units(), load_case, verdict))
   end subroutine test_passed

   subroutine expect(load, allowed, words)
      real(wp), intent(in) :: load, allowed      !< [kN]
      character(*), intent(in) :: words
      type(load_case_type) :: load_case
      call assertEqual(words, verdict_sentences(si_units(), load_case, verdict_of(load, allowed)))
   end subroutine expect

   !> A verdict by tension.
   function verdict_of(load, allowed) result(verdict)
      real(wp), intent(in) :: load, allowed      !< [kN]
      type(verdict_type) :: verdict
      verdict%answer = merge(answer_no, answer_yes, load > allowed)
      verdict%limit = limit_tension
      verdict%load = given(1.0e3_wp*load)
      verdict%allowed = given(1.0e3_wp*allowed)
      verdict%used = given(load/allowed)
   end function verdict_of
end module dg_test_verdict_text
