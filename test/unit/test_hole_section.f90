module dg_test_hole_section
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_hole_section, only: hole_section_at, hole_section_type, last_shoe
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   implicit none
   private
   public :: hole_section_suite

contains

   function hole_section_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('hole_section')
      call suite%addTest(TestMethod('section_at_a_depth', test_section_at_a_depth))
      call suite%addTest(TestMethod('last_shoe', test_last_shoe))
   end function hole_section_suite

   subroutine test_section_at_a_depth()
      type(hole_section_type) :: sections(2)
      sections%md_top = [0.0_wp, 1200.0_wp]
      sections%md_bottom = [1200.0_wp, 3000.0_wp]
      call assertEqual(1, hole_section_at(sections, 0.0_wp))
      call assertEqual(1, hole_section_at(sections, 1199.0_wp))
      call assertEqual(2, hole_section_at(sections, 1200.0_wp), message='at a boundary the lower one')
      call assertEqual(2, hole_section_at(sections, 3000.0_wp))
      call assertEqual(2, hole_section_at(sections, 3500.0_wp), message='below the last')
      call assertEqual(1, hole_section_at(sections, -5.0_wp), message='above the first')
   end subroutine test_section_at_a_depth

   !> Casing, a window of open hole, a liner, open hole.
   subroutine test_last_shoe()
      type(hole_section_type) :: sections(4)
      sections%md_bottom = [1200.0_wp, 1210.0_wp, 2000.0_wp, 3000.0_wp]
      call assertTrue(is_missing(last_shoe(sections)), message='no casing')
      sections(1)%cased = .true.
      call assertEqual(1200.0_wp, last_shoe(sections))
      sections(3)%cased = .true.
      call assertEqual(2000.0_wp, last_shoe(sections))
   end subroutine test_last_shoe
end module dg_test_hole_section
