module dg_test_load_case
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_load_case, only: friction_split, load_case_type, operation_backream, operation_count, operation_from_name, &
      operation_name, operation_ream, operation_rotary_drilling, operation_rotate_off_bottom, operation_sliding_drilling, &
      operation_static, operation_trip_in, operation_trip_out
   use dg_missing, only: given, optional_real
   implicit none
   private
   public :: load_case_suite

   real(wp), parameter :: mu_axial = 0.3_wp, mu_rotary = 0.2_wp, radius = 0.08_wp
   !> A handful of roundings.
   real(wp), parameter :: rounding = 16.0_wp*epsilon(1.0_wp)

contains

   function load_case_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('load_case')
      call suite%addTest(TestMethod('names', test_names))
      call suite%addTest(TestMethod('aliases', test_aliases))
      call suite%addTest(TestMethod('optional_numbers', test_optional_numbers))
      call suite%addTest(TestMethod('friction_of_one_motion', test_friction_of_one_motion))
      call suite%addTest(TestMethod('friction_of_both_motions', test_friction_of_both_motions))
      call suite%addTest(TestMethod('reaming_at_rest', test_reaming_at_rest))
   end function load_case_suite

   subroutine test_names()
      integer :: i
      do i = 1, operation_count
         call assertEqual(i, operation_from_name(trim(operation_name(i))), message=trim(operation_name(i)))
      end do
      call assertEqual(0, operation_from_name('sideways'))
      call assertEqual(0, operation_from_name(''))
   end subroutine test_names

   !> The paper's short names.
   subroutine test_aliases()
      call assertEqual(operation_trip_out, operation_from_name('up'))
      call assertEqual(operation_trip_in, operation_from_name('down'))
      call assertEqual(operation_rotary_drilling, operation_from_name('rotary'))
      call assertEqual(operation_sliding_drilling, operation_from_name('sliding'))
      ! of the rig: letter case, blanks, hyphens and underscores do not count
      call assertEqual(operation_trip_out, operation_from_name('pick_up'))
      call assertEqual(operation_trip_out, operation_from_name('PICKUP'))
      call assertEqual(operation_trip_out, operation_from_name('pooh'))
      call assertEqual(operation_trip_out, operation_from_name('Pull-out'))
      call assertEqual(operation_trip_in, operation_from_name('slackoff'))
      call assertEqual(operation_trip_in, operation_from_name('RIH'))
      call assertEqual(operation_trip_in, operation_from_name('running in'))
      call assertEqual(operation_rotary_drilling, operation_from_name('drilling'))
      call assertEqual(operation_rotary_drilling, operation_from_name('rotate_on_bottom'))
      call assertEqual(operation_sliding_drilling, operation_from_name('slide'))
      call assertEqual(operation_rotate_off_bottom, operation_from_name('ROB'))
      call assertEqual(operation_rotate_off_bottom, operation_from_name('rotating'))
      call assertEqual(operation_ream, operation_from_name('reaming'))
      call assertEqual(operation_backream, operation_from_name('back_reaming'))
      call assertEqual(0, operation_from_name('overpull'))
   end subroutine test_aliases

   subroutine test_optional_numbers()
      type(optional_real) :: number
      call assertFalse(number%present)
      number = given(2.5_wp)
      call assertTrue(number%present)
      call assertEqual(2.5_wp, number%value)
   end subroutine test_optional_numbers

   !> Paper, after Eq. 5: mu2 = 0 in rotary drilling, mu1 = 0 in sliding and tripping.
   subroutine test_friction_of_one_motion()
      call expect(operation_trip_out, mu_axial, 0.0_wp)
      call expect(operation_trip_in, -mu_axial, 0.0_wp)
      call expect(operation_sliding_drilling, -mu_axial, 0.0_wp)
      call expect(operation_rotate_off_bottom, 0.0_wp, mu_rotary)
      call expect(operation_rotary_drilling, 0.0_wp, mu_rotary)
      call expect(operation_static, 0.0_wp, 0.0_wp)
   end subroutine test_friction_of_one_motion

   !> Surface speeds 0.3 m/s along and 0.4 m/s around: shares 3/5 and 4/5.
   subroutine test_friction_of_both_motions()
      type(load_case_type) :: load_case
      real(wp) :: axial, rotary
      load_case%trip_speed = 0.3_wp
      load_case%angular_speed = 0.4_wp/radius
      load_case%operation = operation_ream
      call friction_split(load_case, mu_axial, mu_rotary, radius, axial, rotary)
      call assertRelativelyEqual(-0.6_wp*mu_axial, axial, rounding, message='ream moves down')
      call assertRelativelyEqual(0.8_wp*mu_rotary, rotary, rounding)
      load_case%operation = operation_backream
      call friction_split(load_case, mu_axial, mu_rotary, radius, axial, rotary)
      call assertRelativelyEqual(0.6_wp*mu_axial, axial, rounding, message='backream moves up')
      call assertRelativelyEqual(0.8_wp*mu_rotary, rotary, rounding)
   end subroutine test_friction_of_both_motions

   subroutine test_reaming_at_rest()
      call expect(operation_ream, 0.0_wp, 0.0_wp)
   end subroutine test_reaming_at_rest

   subroutine expect(operation, expected_axial, expected_rotary)
      integer, intent(in) :: operation
      real(wp), intent(in) :: expected_axial, expected_rotary
      type(load_case_type) :: load_case
      real(wp) :: axial, rotary
      load_case%operation = operation
      call friction_split(load_case, mu_axial, mu_rotary, radius, axial, rotary)
      call assertEqual(expected_axial, axial, message=trim(operation_name(operation))//', axial')
      call assertEqual(expected_rotary, rotary, message=trim(operation_name(operation))//', rotary')
   end subroutine expect
end module dg_test_load_case
