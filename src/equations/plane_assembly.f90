!> Global equilibrium as in dg_assembly of a string that stays in the plane of its hole and does not rotate.
!>
!> Unknowns u, v, beta of dg_plane, three a node: residual(3,nodes) [N, N, N.m] and 3 x 3 blocks. It is the same equilibrium,
!> not a simpler one: the forces of dg_assembly at the same state are the same, and none points out of the plane.
module dg_plane_assembly
   use dg_kinds, only: wp
   use dg_assembly, only: load_type
   use dg_beam_element, only: beam_section_type
   use dg_block_matrix, only: block_matrix_type
   use dg_end_supports, only: end_action
   use dg_gap_state, only: contact_force, state_free
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_line_load, hermite_slope, hermite_value
   use dg_mesh, only: mesh_type
   use dg_plane, only: plane_type, row_axial, row_lateral
   use dg_plane_beam_element, only: director_force, director_stiffness, new_plane_node, plane_beam, plane_node_type, unknowns
   use dg_plane_gap, only: plane_gap
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_axial, dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, workspace_type
   implicit none
   private
   public :: assemble_in_plane

contains

   !> Residual(3,nodes) and, unless forces alone are wanted, tangent at `state`, whose nodes have been placed and whose gaps have
   !> been surveyed in `work`. The held unknown u of the top has zero residual and a unit diagonal. Of `work` only hook load and the
   !> bit's forces are set; the rest is for dg_assembly, once, at the end.
   pure subroutine assemble_in_plane(trajectory, mesh, plane, loads, gaps, state, forces_only, work, residual, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(in) :: plane
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      logical, intent(in) :: forces_only
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      type(plane_node_type) :: i, j
      type(beam_section_type) :: section
      real(wp) :: force(unknowns), stiffness(unknowns, unknowns), chord(2), axial
      logical :: tangent
      integer :: e, next
      tangent = .not. forces_only
      stiffness = 0.0_wp
      residual(:, 1) = 0.0_wp
      if (tangent) matrix%diagonal(:, :, 1) = 0.0_wp
      j = node_in_plane(plane, mesh%frame(:, 1, 1), state(:, 1))
      do e = 1, mesh%elements
         next = e + 1
         i = j
         j = node_in_plane(plane, mesh%frame(:, 1, next), state(:, next))
         chord = in_plane(plane, mesh%chord(:, e)) + (j%shift - i%shift)
         section = beam_section_type(mesh%length(e), work%membrane_length(e), mesh%ea(e), mesh%ei(e), mesh%gj(e))
         call plane_beam(section, chord, i, j, tangent, force, axial, stiffness)
         call take_weight(mesh%weight(e)*hermite_line_load(mesh%length(e)), i, j, tangent, force, stiffness)
         force([1, 4]) = force([1, 4]) - 0.5_wp*loads%friction_scale*mesh%drag(e)
         if (gaps%state(e) /= state_free) &
            call take_gap(mesh, plane, loads, gaps, e, chord, i, j, tangent, work, force, stiffness)
         residual(:, e) = residual(:, e) + force(1:3)
         residual(:, next) = force(4:6)
         if (.not. tangent) cycle
         matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + stiffness(1:3, 1:3)
         matrix%upper(:, :, e) = stiffness(1:3, 4:6)
         matrix%lower(:, :, e) = stiffness(4:6, 1:3)
         matrix%diagonal(:, :, next) = stiffness(4:6, 4:6)
      end do
      call add_support(trajectory, mesh, plane, loads%top_support, loads%wob, 1, state(:, 1), tangent, work, residual, matrix)
      call add_support(trajectory, mesh, plane, loads%bit_support, loads%wob, mesh%nodes, state(:, mesh%nodes), tangent, work, &
                       residual, matrix)
      work%hookload = -residual(row_axial, 1)
      work%top_torque = 0.0_wp
      residual(row_axial, 1) = 0.0_wp
      if (.not. tangent) return
      matrix%diagonal(row_axial, :, 1) = 0.0_wp
      matrix%diagonal(:, row_axial, 1) = 0.0_wp
      matrix%diagonal(row_axial, row_axial, 1) = 1.0_wp
      matrix%upper(row_axial, :, 1) = 0.0_wp
      matrix%lower(:, row_axial, 1) = 0.0_wp
   end subroutine assemble_in_plane

   !> Takes an element's weight [N, N.m, N, N.m], down, off its force, and what it does as directors turn off its tangent.
   pure subroutine take_weight(load, i, j, wanted, force, stiffness)
      real(wp), intent(in) :: load(4)
      type(plane_node_type), intent(in) :: i, j
      logical, intent(in) :: wanted
      real(wp), intent(inout) :: force(unknowns), stiffness(unknowns, unknowns)
      force(1) = force(1) - load(1)*i%axis(2)
      force(2) = force(2) - load(1)*i%across(2)
      force(3) = force(3) - director_force(i, [0.0_wp, load(2)])
      force(4) = force(4) - load(3)*j%axis(2)
      force(5) = force(5) - load(3)*j%across(2)
      force(6) = force(6) - director_force(j, [0.0_wp, load(4)])
      if (.not. wanted) return
      stiffness(3, 3) = stiffness(3, 3) - director_stiffness(i, [0.0_wp, load(2)])
      stiffness(6, 6) = stiffness(6, 6) - director_stiffness(j, [0.0_wp, load(4)])
   end subroutine take_weight

   !> Takes a closed gap's force and tangent off the element's.
   pure subroutine take_gap(mesh, plane, loads, gaps, e, chord, i, j, wanted, work, force, stiffness)
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(in) :: plane
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      real(wp), intent(in) :: chord(2)
      type(plane_node_type), intent(in) :: i, j
      logical, intent(in) :: wanted
      type(workspace_type), intent(in) :: work
      real(wp), intent(inout) :: force(unknowns), stiffness(unknowns, unknowns)
      real(wp) :: shape(4), slope(4), direction(2), normal, gap_stiffness
      if (work%separate) then
         normal = work%normal(e)
         gap_stiffness = 0.0_wp
      else
         call contact_force(gaps%law(e), gaps%state(e), work%displacement(e), normal, gap_stiffness)
      end if
      shape = hermite_value(gaps%xi(e), mesh%length(e))
      slope = hermite_slope(gaps%xi(e), mesh%length(e))
      direction = slope(3)*chord + slope(2)*i%d + slope(4)*j%d
      call plane_gap(shape, slope, i, j, direction, in_plane(plane, work%gap(:, e)), in_plane(plane, work%axis_tangent(:, e)), &
                     in_plane(plane, work%axis_curvature(:, e)), normal, gap_stiffness, mesh%axial(e)*loads%friction_scale, &
                     mesh%radius(e), wanted, force, stiffness)
   end subroutine take_gap

   !> Lateral support and load of an end.
   pure subroutine add_support(trajectory, mesh, plane, support, wob, n, state, wanted, work, residual, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(in) :: plane
      real(wp), intent(in) :: support, wob
      integer, intent(in) :: n
      real(wp), intent(in) :: state(:)
      logical, intent(in) :: wanted
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      type(plane_node_type) :: node
      real(wp) :: force(3), by_point(3, 3), ways(3, 2)
      integer :: rows(2)
      rows = [row_axial, row_lateral]
      call end_action(trajectory, mesh, n, support, wob, work, force, by_point)
      node = node_in_plane(plane, mesh%frame(:, 1, n), state)
      ways(:, 1) = node%axis(1)*plane%horizontal
      ways(:, 2) = node%across(1)*plane%horizontal
      ways(3, :) = [node%axis(2), node%across(2)]
      residual(rows, n) = residual(rows, n) - matmul(force, ways)
      if (wanted) matrix%diagonal(rows, rows, n) = matrix%diagonal(rows, rows, n) - matmul(transpose(ways), matmul(by_point, ways))
   end subroutine add_support

   !> Components of a vector of space in the plane; here so that it is inlined.
   pure function in_plane(plane, a) result(components)
      type(plane_type), intent(in) :: plane
      real(wp), intent(in) :: a(3)
      real(wp) :: components(2)
      components(1) = a(1)*plane%horizontal(1) + a(2)*plane%horizontal(2)
      components(2) = a(3)
   end function in_plane

   !> A node in the plane from its unknowns state(6).
   pure function node_in_plane(plane, axis, state) result(node)
      type(plane_type), intent(in) :: plane
      real(wp), intent(in) :: axis(3)        !< the hole's tangent at the node
      real(wp), intent(in) :: state(6)
      type(plane_node_type) :: node
      node = new_plane_node(in_plane(plane, axis), state(dof_axial), &
                            plane%lateral(1)*state(dof_lateral_1) + plane%lateral(2)*state(dof_lateral_2), &
                            plane%lateral(1)*state(dof_slope_1) + plane%lateral(2)*state(dof_slope_2))
   end function node_in_plane
end module dg_plane_assembly
