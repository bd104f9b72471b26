!> Steps of a string along a round wall, in a hole that bends.
module dg_node_moves
   use dg_kinds, only: wp
   use dg_mesh, only: mesh_type
   use dg_round_wall, only: round_move
   use dg_trajectory, only: foot_offset, gap_to_axis, point_on_arc, trajectory_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, workspace_type
   implicit none
   private
   public :: split_step, move_across, slide_along, slide_on

   !> Slides along the hole shorter than this are straight [m]. In a hole of 10 m radius that makes an error of 1e-6 in the
   !> slope.
   real(wp), parameter :: shortest_slide = 1.0e-5_wp

contains

   !> Split a node's step (6) at its present place into a slide along the hole and a move across it. A node that has slid by
   !> metres has another tangent of the hole than the frame of its unknowns.
   pure subroutine split_step(trajectory, mesh, work, node, step, offset, slide, across)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< nodes placed
      integer, intent(in) :: node
      real(wp), intent(in) :: step(6)                !< [m, rad, -]
      real(wp), intent(out) :: offset(2)             !< from the hole axis, along n_1 and n_2 [m]
      real(wp), intent(out) :: slide                 !< [m]
      real(wp), intent(out) :: across(4)             !< lateral (2) and slopes (2) [m, -]
      real(wp) :: point(3), gap(3), tangent(3), curvature(3)
      integer :: arc
      arc = mesh%arc(node)
      point = mesh%base(:, node) + work%shift(:, node)
      call gap_to_axis(trajectory, arc, point, gap, tangent, curvature)
      call split(mesh%frame(:, :, node), gap, tangent, curvature, step, offset, slide, across)
   end subroutine split_step

   !> Split a step where the gap to the hole axis, and the tangent and curvature of that axis, are known.
   pure subroutine split(frame, gap, tangent, curvature, step, offset, slide, across)
      real(wp), intent(in) :: frame(3, 3), gap(3), tangent(3), curvature(3), step(6)
      real(wp), intent(out) :: offset(2), slide, across(4)
      real(wp) :: t(3), k(2)
      integer :: i
      do i = 1, 2
         offset(i) = gap(1)*frame(1, i + 1) + gap(2)*frame(2, i + 1) + gap(3)*frame(3, i + 1)
         k(i) = curvature(1)*frame(1, i + 1) + curvature(2)*frame(2, i + 1) + curvature(3)*frame(3, i + 1)
      end do
      do i = 1, 3
         t(i) = tangent(1)*frame(1, i) + tangent(2)*frame(2, i) + tangent(3)*frame(3, i)
      end do
      slide = step(1)*t(1) + step(2)*t(2) + step(3)*t(3)
      across(1:2) = step(dof_lateral_1:dof_lateral_2) - slide*t(2:3)
      across(3:4) = step(dof_slope_1:dof_slope_2) - slide*k
   end subroutine split

   !> Move the nodes across the hole, in part as turns about its axis (dg_round_wall).
   pure subroutine move_across(turning, offset, share, across, state)
      real(wp), intent(in) :: turning(:, :)              !< turned_part of the nodes (2,nodes) [-, 1/m]; 0: straight moves
      real(wp), contiguous, intent(in) :: offset(:, :)   !< offset of the nodes at `state` (2,nodes) [m]
      real(wp), intent(in) :: share                      !< share of `across` that is taken [-]
      real(wp), contiguous, intent(in) :: across(:, :)   !< lateral (2) and slopes (2) by the whole step (4,nodes) [m, -]
      real(wp), contiguous, intent(inout) :: state(:, :) !< (6,nodes) [m, rad, -]
      real(wp) :: moved(2)
      integer :: n
      do n = 1, size(state, 2)
         call round_move(turning(:, n), offset(:, n), share*across(1:2, n), share*across(3:4, n), moved, &
                         state(dof_slope_1:dof_slope_2, n))
         state(dof_lateral_1:dof_lateral_2, n) = state(dof_lateral_1:dof_lateral_2, n) + moved
      end do
   end subroutine move_across

   !> Slide a node along the hole by `distance` [m]. Its place follows the hole's bend, and its slope turns with the hole.
   !> Elastic strings stretch by metres, over which a bend departs from its tangent by more than the clearance.
   pure subroutine slide_along(trajectory, mesh, node, distance, state, tangent, curvature)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(in) :: distance                    !< > 0 down the hole [m]
      real(wp), intent(inout) :: state(6)                 !< of the node [m, rad, -]
      real(wp), intent(out) :: tangent(3), curvature(3)   !< of the hole axis at the new place [-, 1/m]
      real(wp) :: point(3), gap(3), path(3), before(3), foot
      integer :: arc
      arc = mesh%arc(node)
      associate (frame => mesh%frame(:, :, node))
         point = mesh%base(:, node) + (state(1)*frame(:, 1) + state(2)*frame(:, 2) + state(3)*frame(:, 3))
         call gap_to_axis(trajectory, arc, point, gap, tangent, curvature)
         if (abs(distance) < shortest_slide) then
            call slide_straight(frame, distance, tangent, curvature, state)
         else
            before = tangent
            path = gap - point
            foot = foot_offset(trajectory%arcs(arc), point) + distance
            do while (foot > trajectory%arcs(arc)%length .and. arc < size(trajectory%arcs))
               foot = foot - trajectory%arcs(arc)%length
               path = path + trajectory%arcs(arc)%chord
               arc = arc + 1
            end do
            do while (foot < 0.0_wp .and. arc > 1)
               arc = arc - 1
               foot = foot + trajectory%arcs(arc)%length
               path = path - trajectory%arcs(arc)%chord
            end do
            call point_on_arc(trajectory%arcs(arc), foot, point, tangent, curvature)
            call slide_straight(frame, 1.0_wp, path + point, tangent - before, state)
         end if
      end associate
   end subroutine slide_along

   !> Slide a node further, after slide_along. The path is straight if `distance` is short enough.
   pure subroutine slide_on(trajectory, mesh, node, distance, tangent, curvature, state)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(in) :: distance                      !< > 0 down the hole [m]
      real(wp), intent(inout) :: tangent(3), curvature(3)   !< from slide_along [-, 1/m]
      real(wp), intent(inout) :: state(6)                   !< of the node [m, rad, -]
      if (abs(distance) < shortest_slide) then
         call slide_straight(mesh%frame(:, :, node), distance, tangent, curvature, state)
      else
         call slide_along(trajectory, mesh, node, distance, state, tangent, curvature)
      end if
   end subroutine slide_on

   !> Move a node by `distance` times a path, and turn it by `distance` times a turn, in the frame of its unknowns.
   pure subroutine slide_straight(frame, distance, path, turn, state)
      real(wp), intent(in) :: frame(3, 3), distance, path(3), turn(3)
      real(wp), intent(inout) :: state(6)
      integer :: i
      do i = 1, 3
         state(i) = state(i) + distance*(path(1)*frame(1, i) + path(2)*frame(2, i) + path(3)*frame(3, i))
      end do
      state(dof_slope_1) = state(dof_slope_1) + distance*(turn(1)*frame(1, 2) + turn(2)*frame(2, 2) + turn(3)*frame(3, 2))
      state(dof_slope_2) = state(dof_slope_2) + distance*(turn(1)*frame(1, 3) + turn(2)*frame(2, 3) + turn(3)*frame(3, 3))
   end subroutine slide_straight
end module dg_node_moves
