module dg_test_drillstring
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_component, only: component_type, has_joints
   use dg_drillstring, only: at_joint, component_at, component_tops, drillstring_type, joint_ends
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
      call suite%addTest(TestMethod('ends_of_tool_joints', test_joint_ends))
      call suite%addTest(TestMethod('at_a_tool_joint', test_at_joint))
      call suite%addTest(TestMethod('what_has_tool_joints', test_has_joints))
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

   !> A collar of 5 m, and pipe with joints of 0.4 m every 10 m above it, from its lower end at 5 m.
   function jointed_string() result(string)
      type(drillstring_type) :: string
      allocate (string%components(2))
      string%components(1)%kind = 'collar'
      string%components(1)%length = 5.0_wp
      string%components(1)%od = 0.16_wp
      string%components(2)%kind = 'drillpipe'
      string%components(2)%od = 0.127_wp
      string%components(2)%joint_od = 0.168_wp
      string%components(2)%joint_length = 0.4_wp
      string%components(2)%joint_spacing = 10.0_wp
   end function jointed_string

   !> Half a joint at the pipe's lower end, whole ones at 15 m and 25 m, half a joint where the string is cut at 35 m, and where
   !> it is cut within one, as much of it as is there. The collar has none.
   subroutine test_joint_ends()
      type(drillstring_type) :: string
      string = jointed_string()
      call expect_ends([5.0_wp, 5.2_wp, 14.8_wp, 15.2_wp, 24.8_wp, 25.2_wp, 34.8_wp, 35.0_wp], 35.0_wp, 'at a joint')
      call expect_ends([5.0_wp, 5.2_wp, 14.8_wp, 15.2_wp], 20.0_wp, 'between joints')
      call expect_ends([5.0_wp, 5.2_wp, 14.8_wp, 14.9_wp], 14.9_wp, 'within a joint')
   contains
      !> Ends that lie beyond the string stand at its end.
      subroutine expect_ends(ends, length, what)
         real(wp), intent(in) :: ends(:), length
         character(*), intent(in) :: what
         real(wp), allocatable :: found(:)
         integer :: i
         allocate (found, source=joint_ends(string, component_tops(string, length)))
         do i = 1, size(ends)
            call assertEqual(ends(i), found(i), 1.0e-12_wp, message=what)
         end do
         call assertTrue(all(found(size(ends) + 1:) >= length), message=what//': no more within the string')
      end subroutine expect_ends
   end subroutine test_joint_ends

   subroutine test_at_joint()
      type(drillstring_type) :: string
      string = jointed_string()
      associate (pipe => string%components(2))
         call assertTrue(at_joint(pipe, 0.0_wp), message='at its lower end')
         call assertTrue(at_joint(pipe, 0.19_wp) .and. at_joint(pipe, 9.81_wp) .and. at_joint(pipe, 20.19_wp))
         call assertFalse(at_joint(pipe, 0.21_wp) .or. at_joint(pipe, 5.0_wp) .or. at_joint(pipe, 9.79_wp))
      end associate
      call assertFalse(at_joint(string%components(1), 0.0_wp), message='a collar has none')
   end subroutine test_at_joint

   !> Joints are thicker than the body; a stabilizer's blades touch all along, however its kind is spelt.
   subroutine test_has_joints()
      type(component_type) :: part
      part%od = 0.127_wp
      part%kind = 'drillpipe'
      call assertFalse(has_joints(part), message='no joint_od')
      part%joint_od = 0.127_wp
      call assertFalse(has_joints(part), message='no thicker than the body')
      part%joint_od = 0.168_wp
      call assertTrue(has_joints(part))
      part%kind = 'stabilizer'
      call assertFalse(has_joints(part))
      part%kind = 'Stabiliser'
      call assertFalse(has_joints(part))
   end subroutine test_has_joints
end module dg_test_drillstring
