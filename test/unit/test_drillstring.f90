module dg_test_drillstring
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_component, only: component_type
   use dg_drillstring, only: component_at, component_tops, drillstring_type
   use dg_kinds, only: wp
   implicit none
   private
   public :: drillstring_suite

contains

   function drillstring_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('drillstring')
      call suite%addTest(TestMethod('last_reaches_surface', test_last_reaches_surface))
      call suite%addTest(TestMethod('longer_than_the_hole', test_longer_than_the_hole))
      call suite%addTest(TestMethod('one_component', test_one_component))
      call suite%addTest(TestMethod('component_at_a_distance', test_component_at_a_distance))
   end function drillstring_suite

   !> Bit 0, collar of 100 m, heavy-weight pipe of 50 m, pipe to surface.
   pure function three_part_string() result(string)
      type(drillstring_type) :: string
      allocate (string%components(3))
      string%components%length = [100.0_wp, 50.0_wp, 0.0_wp]
   end function three_part_string

   subroutine test_last_reaches_surface()
      call assertEqual([100.0_wp, 150.0_wp, 2000.0_wp], component_tops(three_part_string(), 2000.0_wp))
   end subroutine test_last_reaches_surface

   subroutine test_longer_than_the_hole()
      call assertEqual([100.0_wp, 120.0_wp, 120.0_wp], component_tops(three_part_string(), 120.0_wp))
   end subroutine test_longer_than_the_hole

   subroutine test_one_component()
      type(drillstring_type) :: string
      allocate (string%components(1))
      string%components(1)%length = 10.0_wp
      call assertEqual([500.0_wp], component_tops(string, 500.0_wp), message='reaches to surface whatever its length')
   end subroutine test_one_component

   subroutine test_component_at_a_distance()
      real(wp), parameter :: tops(3) = [100.0_wp, 150.0_wp, 2000.0_wp]
      call assertEqual(1, component_at(tops, 0.0_wp))
      call assertEqual(1, component_at(tops, 99.9_wp))
      call assertEqual(2, component_at(tops, 100.0_wp), message='at a joint the upper one')
      call assertEqual(3, component_at(tops, 1999.0_wp))
      call assertEqual(3, component_at(tops, 2000.0_wp), message='at the surface')
   end subroutine test_component_at_a_distance
end module dg_test_drillstring
