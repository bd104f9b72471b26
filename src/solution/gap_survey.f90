!> Where the string lies in the hole: offsets at the nodes and at the gaps, and the gaps re-judged and re-placed.
module dg_gap_survey
   use dg_kinds, only: wp
   use dg_assembly, only: workspace_type
   use dg_gap_location, only: extremum_of_displacement
   use dg_gap_table, only: gap_table_type, move_gap
   use dg_hermite, only: hermite_value
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: closest_point, trajectory_type
   implicit none
   private
   public :: node_offset, gap_displacement, relocate_gaps

contains

   !> Offset f(3) of a node off the hole axis [m] and the axis' tangent where the node now is.
   pure subroutine node_offset(trajectory, mesh, work, node, gap, tangent)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: node
      real(wp), intent(out) :: gap(3), tangent(3)
      real(wp) :: point(3), curvature(3), offset
      integer :: arc
      arc = mesh%arc(node)
      point = mesh%base(:, node) + work%shift(:, node)
      call closest_point(trajectory, arc, point, offset, gap, tangent, curvature)
   end subroutine node_offset

   !> |f| [m] of an element's axis at xi.
   pure function gap_displacement(trajectory, mesh, work, e, xi) result(displacement)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: e
      real(wp), intent(in) :: xi
      real(wp) :: displacement
      real(wp) :: shape(4), point(3), gap(3), tangent(3), curvature(3), offset
      integer :: arc
      shape = hermite_value(xi, mesh%length(e))
      point = mesh%base(:, e) + shape(1)*work%shift(:, e) + shape(2)*work%d(:, e) &
              + shape(3)*(mesh%chord(:, e) + work%shift(:, e + 1)) + shape(4)*work%d(:, e + 1)
      arc = mesh%arc(e)
      call closest_point(trajectory, arc, point, offset, gap, tangent, curvature)
      displacement = norm2(gap)
   end function gap_displacement

   !> Places the gaps at the extremum x0 of their element where the string reaches beyond the wall (Eq. 2), by the rule of
   !> move_gap; `displacement` is brought up to date, `moved` counts.
   pure subroutine relocate_gaps(trajectory, mesh, work, threshold, gaps, displacement, moved)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(in) :: threshold          !< relative to the clearance [-]
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: displacement(:) !< |f| at the gaps [m]
      integer, intent(out) :: moved
      real(wp) :: gap_i(3), gap_j(3), tangent_i(3), tangent_j(3), xi, estimate
      logical :: changed
      integer :: e
      moved = 0
      call node_offset(trajectory, mesh, work, 1, gap_i, tangent_i)
      do e = 1, mesh%elements
         call node_offset(trajectory, mesh, work, e + 1, gap_j, tangent_j)
         call extremum_of_displacement(gap_i, work%d(:, e) - tangent_i, gap_j, work%d(:, e + 1) - tangent_j, &
                                       mesh%length(e), xi, estimate)
         if (estimate > gaps%law(e)%clearance) then
            call move_gap(gaps, e, xi, estimate, displacement(e), threshold, changed)
            if (changed) then
               displacement(e) = gap_displacement(trajectory, mesh, work, e, xi)
               moved = moved + 1
            end if
         end if
         gap_i = gap_j
         tangent_i = tangent_j
      end do
   end subroutine relocate_gaps
end module dg_gap_survey
