module dg_test_component
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_component, only: axial_stiffness, bending_stiffness, buoyed_weight, closed_diameter, component_type, contact_diameter, &
      has_blades, has_joints, is_open, opens, torsional_stiffness, tube_area, tube_inertia
   use dg_constants, only: pi, standard_gravity
   use dg_kinds, only: wp
   implicit none
   private
   public :: component_suite

   !> A handful of roundings.
   real(wp), parameter :: rounding = 16.0_wp*epsilon(1.0_wp)

contains

   function component_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('component')
      call suite%addTest(TestMethod('section_of_a_tube', test_section_of_a_tube))
      call suite%addTest(TestMethod('section_of_a_bar', test_section_of_a_bar))
      call suite%addTest(TestMethod('stiffness', test_stiffness))
      call suite%addTest(TestMethod('joint_touches_first', test_joint_touches_first))
      call suite%addTest(TestMethod('tool_that_opens', test_tool_that_opens))
      call suite%addTest(TestMethod('weight_in_mud', test_weight_in_mud))
   end function component_suite

   !> 5 in x 4.276 in drill pipe, API RP 7G: metal area 5.2746 in2; I = pi/64 (5**4 - 4.276**4) = 14.2692 in4.
   subroutine test_section_of_a_tube()
      real(wp), parameter :: inch = 0.0254_wp
      real(wp), parameter :: printed = 1.0e-5_wp !< five digits in the handbook
      call assertRelativelyEqual(5.2746_wp*inch**2, tube_area(5.0_wp*inch, 4.276_wp*inch), printed)
      call assertRelativelyEqual(14.2692_wp*inch**4, tube_inertia(5.0_wp*inch, 4.276_wp*inch), printed)
   end subroutine test_section_of_a_tube

   subroutine test_section_of_a_bar()
      call assertRelativelyEqual(pi, tube_area(2.0_wp, 0.0_wp), rounding)
      call assertRelativelyEqual(pi/4.0_wp, tube_inertia(2.0_wp, 0.0_wp), rounding)
   end subroutine test_section_of_a_bar

   !> E A, E I, and G J = E/(2 (1 + nu)) times 2 I.
   subroutine test_stiffness()
      type(component_type) :: bar
      bar%od = 2.0_wp
      bar%youngs = 200.0_wp
      bar%poisson = 0.25_wp
      call assertRelativelyEqual(200.0_wp*pi, axial_stiffness(bar), rounding)
      call assertRelativelyEqual(50.0_wp*pi, bending_stiffness(bar), rounding)
      call assertRelativelyEqual(80.0_wp*pi/2.0_wp, torsional_stiffness(bar), rounding)
   end subroutine test_stiffness

   subroutine test_joint_touches_first()
      type(component_type) :: pipe
      pipe%od = 0.127_wp
      call assertEqual(0.127_wp, contact_diameter(pipe, 1.0e3_wp), message='no joint: the body')
      pipe%joint_od = 0.168_wp
      call assertEqual(0.168_wp, contact_diameter(pipe, 1.0e3_wp), message='the joint')
   end subroutine test_joint_touches_first

   !> The diameter by depth of the upper end: closed above, open from opened_below on, to a thousandth of a millimetre.
   subroutine test_tool_that_opens()
      type(component_type) :: tool
      real(wp), parameter :: depths(4) = [0.0_wp, 1499.9_wp, 1500.0_wp - 0.5e-6_wp, 2000.0_wp]
      tool%kind = 'reamer'
      tool%od = 0.19_wp
      tool%joint_od = 0.213_wp
      call assertFalse(opens(tool))
      call assertTrue(has_joints(tool), message='as any part with a joint_od')
      call assertFalse(is_open(tool, 1.0e4_wp))
      tool%opened_od = 0.25_wp
      call assertTrue(opens(tool))
      call assertEqual(0.213_wp, contact_diameter(tool, 1.0e4_wp), message='closed while nobody has said where it opens')
      tool%opened_below = 1500.0_wp
      call assertEqual([0.213_wp, 0.213_wp, 0.25_wp, 0.25_wp], contact_diameter(tool, depths))
      call assertEqual(0.213_wp, closed_diameter(tool))
      call assertTrue(has_blades(tool), message='it touches all along')
      call assertFalse(has_joints(tool))
      tool%kind = 'bit'
      call assertFalse(has_blades(tool), message='a bicentre bit')
      call assertEqual(0.25_wp, contact_diameter(tool, 1500.0_wp))
   end subroutine test_tool_that_opens

   subroutine test_weight_in_mud()
      type(component_type) :: pipe
      pipe%mass = 30.0_wp
      call assertRelativelyEqual(30.0_wp*standard_gravity, buoyed_weight(pipe, 0.0_wp, 0.0_wp, standard_gravity), rounding)
      ! mud of a fifth of steel's density carries a fifth of the weight
      call assertRelativelyEqual(24.0_wp*standard_gravity, buoyed_weight(pipe, 1570.0_wp, 1570.0_wp, standard_gravity), rounding)
      pipe%density = 1570.0_wp
      call assertEqual(0.0_wp, buoyed_weight(pipe, 1570.0_wp, 1570.0_wp, standard_gravity), message='floats')
   end subroutine test_weight_in_mud
end module dg_test_component
