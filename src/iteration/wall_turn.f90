!> Steps of a string that lies against a round wall.
module dg_wall_turn
   use dg_kinds, only: wp
   use dg_gap_survey, only: node_offset
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_tuning, only: tuning_type
   use dg_workspace, only: dof_axial, dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, dof_twist, workspace_type
   implicit none
   private
   public :: turn_along_wall

contains

   !> state <- state + step, where the lateral step of a node across its offset from the hole axis is a turn about that axis:
   !> offset and slope turn by the step over the radius. To first order it is the plain sum; along straight lines a string on a
   !> round wall could only creep.
   pure subroutine turn_along_wall(tuning, trajectory, mesh, work, step, state)
      type(tuning_type), intent(in) :: tuning
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< nodes placed at `state`
      real(wp), intent(in) :: step(:, :)
      real(wp), intent(inout) :: state(:, :)
      real(wp) :: gap(3), tangent(3), offset(2), move(2), slope(2), square, along, turn
      integer :: n
      do n = 1, mesh%nodes
         state(dof_axial, n) = state(dof_axial, n) + step(dof_axial, n)
         state(dof_twist, n) = state(dof_twist, n) + step(dof_twist, n)
         call node_offset(trajectory, mesh, work, n, gap, tangent)
         offset = [dot_product(gap, mesh%frame(:, 2, n)), dot_product(gap, mesh%frame(:, 3, n))]
         move = step(dof_lateral_1:dof_lateral_2, n)
         slope = state(dof_slope_1:dof_slope_2, n)
         square = sum(offset**2)
         turn = offset(1)*move(2) - offset(2)*move(1)
         if (square > (tuning%turned_beyond*mesh%clearance(min(n, mesh%elements)))**2) then
            turn = turn/square
            along = dot_product(move, offset)/square
            move = turned((1.0_wp + along)*offset, turn) - offset
            slope = turned(slope + step(dof_slope_1:dof_slope_2, n) - turn*[-slope(2), slope(1)], turn)
         else
            slope = slope + step(dof_slope_1:dof_slope_2, n)
         end if
         state(dof_lateral_1:dof_lateral_2, n) = state(dof_lateral_1:dof_lateral_2, n) + move
         state(dof_slope_1:dof_slope_2, n) = slope
      end do
   end subroutine turn_along_wall

   pure function turned(a, angle) result(b)
      real(wp), intent(in) :: a(2), angle
      real(wp) :: b(2)
      b = [cos(angle)*a(1) - sin(angle)*a(2), sin(angle)*a(1) + cos(angle)*a(2)]
   end function turned
end module dg_wall_turn
