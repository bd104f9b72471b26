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
   use dg_gap_action, only: near
   use dg_gap_state, only: contact_force, state_free
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_plane, only: plane_type, row_axial, row_lateral
   use dg_plane_beam_element, only: plane_beam, plane_node_type, unknowns
   use dg_plane_gap, only: plane_contact_type, plane_gap, plane_gap_rows
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_slope_1, dof_slope_2, workspace_type
   implicit none
   private
   public :: assemble_in_plane, find_row_in_plane, find_rows_in_plane

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
      real(wp) :: force(unknowns), stiffness(unknowns, unknowns), chord(2), axial, half
      real(wp) :: corner(3, 3), above(3)       ! what the element before leaves at the common node
      logical :: tangent
      integer :: e, next
      tangent = .not. forces_only
      corner = 0.0_wp
      above = 0.0_wp
      j = node_in_plane(plane, mesh%frame(:, 1, 1), work%shift(:, 1), work%d(:, 1), state(:, 1))
      do e = 1, mesh%elements
         next = e + 1
         i = j
         j = node_in_plane(plane, mesh%frame(:, 1, next), work%shift(:, next), work%d(:, next), state(:, next))
         chord = in_plane(plane, mesh%chord(:, e)) + (j%shift - i%shift)
         section = beam_section_type(mesh%length(e), work%membrane_length(e), mesh%ea(e), mesh%ei(e), mesh%gj(e))
         call plane_beam(section, chord, i, j, tangent, force, axial, stiffness)
         call take_weight(mesh%weight(e), mesh%length(e), i, j, tangent, force, stiffness)
         half = 0.5_wp*loads%friction_scale*mesh%drag(e)
         force(1) = force(1) - half
         force(4) = force(4) - half
         if (gaps%state(e) /= state_free) call take_gap(mesh, plane, loads, gaps, e, chord, i, j, tangent, work, force, stiffness)
         residual(:, e) = above + force(1:3)
         above = force(4:6)
         if (.not. tangent) cycle
         matrix%diagonal(:, :, e) = corner + stiffness(1:3, 1:3)
         matrix%upper(:, :, e) = stiffness(1:3, 4:6)
         matrix%lower(:, :, e) = stiffness(4:6, 1:3)
         corner = stiffness(4:6, 4:6)
      end do
      residual(:, mesh%nodes) = above
      if (tangent) matrix%diagonal(:, :, mesh%nodes) = corner
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

   !> Rows of contact forces as of find_contact_rows of dg_gap_action, by the unknowns of both nodes in the plane: `by`(6,e) and
   !> `on`(6,e) [-, m]. The held unknown of the top has none.
   pure subroutine find_rows_in_plane(mesh, plane, loads, gaps, state, work, by, on)
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(in) :: plane
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(in) :: work       !< placed and surveyed at `state`
      real(wp), intent(out) :: by(:, :), on(:, :)
      type(plane_contact_type) :: contact
      type(plane_node_type) :: i, j
      integer :: e, next
      j = node_in_plane(plane, mesh%frame(:, 1, 1), work%shift(:, 1), work%d(:, 1), state(:, 1))
      do e = 1, mesh%elements
         next = e + 1
         i = j
         j = node_in_plane(plane, mesh%frame(:, 1, next), work%shift(:, next), work%d(:, next), state(:, next))
         if (work%displacement(e) < near*gaps%law(e)%clearance) then
            by(:, e) = 0.0_wp
            on(:, e) = 0.0_wp
            cycle
         end if
         contact = contact_in_plane(mesh, plane, loads, gaps%xi(e), e, in_plane(plane, mesh%chord(:, e)) + (j%shift - i%shift), &
                                    i, j, work)
         call plane_gap_rows(contact, i, j, by(:, e), on(:, e))
      end do
      by(row_axial, 1) = 0.0_wp
      on(row_axial, 1) = 0.0_wp
   end subroutine find_rows_in_plane

   !> Those of one gap.
   pure subroutine find_row_in_plane(mesh, plane, loads, gaps, e, state, work, by, on)
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(in) :: plane
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(in) :: work       !< placed and surveyed at `state`
      real(wp), intent(out) :: by(unknowns), on(unknowns)
      type(plane_node_type) :: i, j
      i = node_in_plane(plane, mesh%frame(:, 1, e), work%shift(:, e), work%d(:, e), state(:, e))
      j = node_in_plane(plane, mesh%frame(:, 1, e + 1), work%shift(:, e + 1), work%d(:, e + 1), state(:, e + 1))
      call plane_gap_rows(contact_in_plane(mesh, plane, loads, gaps%xi(e), e, in_plane(plane, mesh%chord(:, e)) &
                                           + (j%shift - i%shift), i, j, work), i, j, by, on)
      if (e > 1) return
      by(row_axial) = 0.0_wp
      on(row_axial) = 0.0_wp
   end subroutine find_row_in_plane

   !> Takes an element's weight [N/m], down, off its force, and what it does as directors turn off its tangent. Equivalent nodal
   !> loads are those of hermite_line_load.
   pure subroutine take_weight(weight, length, i, j, wanted, force, stiffness)
      real(wp), intent(in) :: weight, length
      type(plane_node_type), intent(in) :: i, j
      logical, intent(in) :: wanted
      real(wp), intent(inout) :: force(unknowns), stiffness(unknowns, unknowns)
      real(wp), parameter :: twelfth = 1.0_wp/12.0_wp
      real(wp) :: half, turning
      half = 0.5_wp*weight*length
      turning = twelfth*weight*length**2
      force(1) = force(1) - half*i%axis(2)
      force(2) = force(2) - half*i%across(2)
      force(3) = force(3) - turning*i%turn*i%d(1)
      force(4) = force(4) - half*j%axis(2)
      force(5) = force(5) - half*j%across(2)
      force(6) = force(6) + turning*j%turn*j%d(1)
      if (.not. wanted) return
      stiffness(3, 3) = stiffness(3, 3) - turning*(i%bend*i%d(1) - i%turn**2*i%d(2))
      stiffness(6, 6) = stiffness(6, 6) + turning*(j%bend*j%d(1) - j%turn**2*j%d(2))
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
      real(wp) :: normal, gap_stiffness
      if (work%separate) then
         normal = work%normal(e)
         gap_stiffness = 0.0_wp
      else
         call contact_force(gaps%law(e), gaps%state(e), work%displacement(e), normal, gap_stiffness)
      end if
      call plane_gap(contact_in_plane(mesh, plane, loads, gaps%xi(e), e, chord, i, j, work), i, j, normal, gap_stiffness, wanted, &
                     force, stiffness)
   end subroutine take_gap

   !> What string and hole are like at the gap of element e, at xi. Shape functions are those of dg_hermite, here so that they are
   !> inlined.
   pure function contact_in_plane(mesh, plane, loads, xi, e, chord, i, j, work) result(contact)
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(in) :: plane
      type(load_type), intent(in) :: loads
      real(wp), intent(in) :: xi
      integer, intent(in) :: e
      real(wp), intent(in) :: chord(2)
      type(plane_node_type), intent(in) :: i, j
      type(workspace_type), intent(in) :: work
      type(plane_contact_type) :: contact
      real(wp) :: rest, length
      rest = 1.0_wp - xi
      length = mesh%length(e)
      contact%shape(1) = rest*rest*(1.0_wp + 2.0_wp*xi)
      contact%shape(2) = rest*rest*xi*length
      contact%shape(3) = xi*xi*(1.0_wp + 2.0_wp*rest)
      contact%shape(4) = -xi*xi*rest*length
      contact%slope(1) = -6.0_wp*xi*rest/length
      contact%slope(2) = rest*(1.0_wp - 3.0_wp*xi)
      contact%slope(3) = -contact%slope(1)
      contact%slope(4) = -xi*(3.0_wp*rest - 1.0_wp)
      contact%direction = contact%slope(3)*chord + contact%slope(2)*i%d + contact%slope(4)*j%d
      contact%gap = in_plane(plane, work%gap(:, e))
      contact%tangent = in_plane(plane, work%axis_tangent(:, e))
      contact%curvature = in_plane(plane, work%axis_curvature(:, e))
      contact%axial = mesh%axial(e)*loads%friction_scale
      contact%radius = mesh%radius(e)
   end function contact_in_plane

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
      node = node_in_plane(plane, mesh%frame(:, 1, n), work%shift(:, n), work%d(:, n), state)
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

   !> A node in the plane from its place and its unknowns state(6).
   pure function node_in_plane(plane, axis, shift, director, state) result(node)
      type(plane_type), intent(in) :: plane
      real(wp), intent(in) :: axis(3)        !< the hole's tangent at the node
      real(wp), intent(in) :: shift(3), director(3), state(6)
      type(plane_node_type) :: node
      node%axis = in_plane(plane, axis)
      node%across(1) = -node%axis(2)
      node%across(2) = node%axis(1)
      node%shift = in_plane(plane, shift)
      node%d = in_plane(plane, director)
      node%turn = (node%d(1)*node%axis(1) + node%d(2)*node%axis(2))**2
      node%bend = -2.0_wp*(plane%lateral(1)*state(dof_slope_1) + plane%lateral(2)*state(dof_slope_2))*node%turn**2
   end function node_in_plane
end module dg_plane_assembly
