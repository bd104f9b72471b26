!> Distance of a string outside its hole: along elements, at steps of the hole, in soft walls, at the rows of a profile.
module dg_test_outside_hole
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_component, only: component_type
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_trip_out
   use dg_mesh, only: mesh_type, new_mesh
   use dg_model, only: model_type
   use dg_outside_hole, only: measure_outside, measure_rows, outside_message, outside_place, outside_type
   use dg_profile, only: new_profile, profile_type
   use dg_workspace, only: new_workspace, workspace_type
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_units, only: field_units, si_units
   implicit none
   private
   public :: outside_hole_suite

   !> Clearances above and below the shoe, whose depth is that of node 3 [m].
   real(wp), parameter :: wide = 0.05_wp, narrow = 0.02_wp, shoe = 20.0_wp, pipe = 0.1_wp
   real(wp), parameter :: depths(5) = [0.0_wp, 10.0_wp, shoe, 30.0_wp, 40.0_wp]
   real(wp), parameter :: tolerance = 1.0e-9_wp

contains

   function outside_hole_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('outside_hole')
      call suite%addTest(TestMethod('within_an_element', test_within_an_element))
      call suite%addTest(TestMethod('at_a_shoe', test_at_a_shoe))
      call suite%addTest(TestMethod('soft_wall', test_soft_wall))
      call suite%addTest(TestMethod('rows', test_rows))
   end function outside_hole_suite

   !> A straight hole of 60 deg with a shoe, and a string on its axis, which `lay` moves.
   subroutine build(model, mesh, work)
      type(model_type), intent(out) :: model
      type(mesh_type), intent(out) :: mesh
      type(workspace_type), intent(out) :: work
      type(error_type), allocatable :: error
      integer :: n
      call new_trajectory(model%trajectory, [0.0_wp, 40.0_wp], [60.0_wp, 60.0_wp]*degree, [30.0_wp, 30.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(2), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('cased', 0.0_wp, shoe, pipe + 2.0_wp*wide, 0.2_wp, 0.2_wp)
      model%holes(2) = hole_section_type('open', shoe, 40.0_wp, pipe + 2.0_wp*narrow, 0.2_wp, 0.2_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      model%strings(1)%components(1) = component_type('pipe', 'drillpipe', 0.0_wp, pipe, 0.08_wp, 30.0_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = 40.0_wp
      model%cases(1)%operation = operation_trip_out
      call new_mesh(model, model%cases(1), depths, mesh)
      call new_workspace(mesh, work)
      do n = 1, mesh%nodes
         call lay(mesh, n, 0.0_wp, 0.0_wp, work)
      end do
   end subroutine build

   !> Puts a node off the axis [m], sloping away from it [-].
   subroutine lay(mesh, node, offset, slope, work)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(in) :: offset, slope
      type(workspace_type), intent(inout) :: work
      work%shift(:, node) = offset*mesh%frame(:, 2, node)
      work%d(:, node) = (mesh%frame(:, 1, node) + slope*mesh%frame(:, 2, node))/sqrt(1.0_wp + slope**2)
   end subroutine lay

   !> Both nodes on the wall, slopes s and -s: a cubic's middle is L s/4 beyond them. No node is outside.
   subroutine test_within_an_element()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(outside_type) :: outside
      real(wp), parameter :: slope = 0.005_wp
      character(:), allocatable :: text
      real(wp) :: expected
      call build(model, mesh, work)
      call measure_outside(model%trajectory, mesh, work, outside)
      call assertEqual(0, outside%elements, message='on the axis')
      call lay(mesh, 1, wide, slope, work)
      call lay(mesh, 2, wide, -slope, work)
      expected = 10.0_wp*(slope/sqrt(1.0_wp + slope**2))/4.0_wp/wide
      call measure_outside(model%trajectory, mesh, work, outside)
      call assertEqual(1, outside%elements)
      call assertEqual(expected, outside%excess, tolerance)
      call assertEqual(5.0_wp, outside%md, tolerance, message='in the middle')
      call assertFalse(outside%gives_way)
      call outside_message(si_units(), outside, text)
      call assertGreaterThan(index(text, '12 mm'//outside_place//'5 m'), 0, message=text)
      call assertGreaterThan(index(text, 'element_length to 5 m'), 0, message=text)
      call outside_message(field_units(), outside, text)
      call assertGreaterThan(index(text, '0.49 in'//outside_place//'16.4042 ft'), 0, message=text)
      call assertGreaterThan(index(text, 'element_length to 16 ft'), 0, message=text)
   end subroutine test_within_an_element

   !> On the wall of the wide hole at the shoe the string is outside the narrow one; an excess below a fifth is not told.
   subroutine test_at_a_shoe()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(outside_type) :: outside
      call build(model, mesh, work)
      call lay(mesh, 3, wide, 0.0_wp, work)
      call measure_outside(model%trajectory, mesh, work, outside)
      call assertEqual(1, outside%elements)
      call assertEqual(wide/narrow - 1.0_wp, outside%excess, tolerance)
      call assertEqual(shoe, outside%md, tolerance)
      call assertEqual(narrow, outside%clearance, tolerance)
      call lay(mesh, 3, 1.19_wp*narrow, 0.0_wp, work)
      call measure_outside(model%trajectory, mesh, work, outside)
      call assertEqual(0, outside%elements)
   end subroutine test_at_a_shoe

   !> Where the string is as deep in the wall at its gap, the wall gives way; as deep as a mud sheath is thick it may be.
   subroutine test_soft_wall()
      character(:), allocatable :: text
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(outside_type) :: outside
      call build(model, mesh, work)
      call lay(mesh, 4, 1.5_wp*narrow, 0.0_wp, work)
      work%displacement(3:4) = 1.5_wp*narrow
      call measure_outside(model%trajectory, mesh, work, outside)
      call assertEqual(2, outside%elements)
      call assertTrue(outside%gives_way)
      call outside_message(si_units(), outside, text)
      call assertEqual(0, index(text, 'wall_stiffness'), message='nothing is advised: '//text)
      mesh%wall(3:4) = 1.0e8_wp
      call measure_outside(model%trajectory, mesh, work, outside)
      call outside_message(si_units(), outside, text)
      call assertGreaterThan(index(text, 'Set wall_stiffness to 1e8 kN/m2'), 0, message=text)
      mesh%eps_nmax(3:4) = 0.6_wp
      call measure_outside(model%trajectory, mesh, work, outside)
      call assertEqual(0, outside%elements)
   end subroutine test_soft_wall

   !> Rows of a profile: within an element by its clearance, at the shoe by the narrower.
   subroutine test_rows()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(profile_type) :: profile
      type(outside_type) :: outside
      call build(model, mesh, work)
      profile = new_profile(4)
      profile%md = [0.0_wp, 19.0_wp, shoe, 40.0_wp]
      profile%displacement = [0.0_wp, wide, 1.1_wp*narrow, narrow]
      call measure_rows(mesh, profile, outside)
      call assertEqual(0, outside%elements)
      profile%displacement(3) = 1.5_wp*narrow
      call measure_rows(mesh, profile, outside)
      call assertEqual(1, outside%elements)
      call assertEqual(0.5_wp, outside%excess, tolerance)
      call assertEqual(shoe, outside%md, tolerance)
   end subroutine test_rows
end module dg_test_outside_hole
