!> Steps of a string that turns about the hole axis.
!>
!> Along straight lines a string on a round wall could only creep: where a node is near the wall its lateral step is taken as a
!> turn about the axis. In an exactly vertical hole the turn of the whole string costs nothing: the unknowns have then
!> a mode m = J d of no stiffness, which is held still, and what drives it is no matter of equilibrium: it is taken off the residual
!> as lambda M m, M the weights, lambda so that m.(r - lambda M m) = 0. Newton's step p of that is
!>   (K - lambda M J) p - dlambda M m = -(r - lambda M m),  with one node held across its offset.
!> At rest K - lambda M J is singular, and m is its mode: a spring at the held node makes it regular, and does nothing as that
!> node stays. Without these terms torque left a linear convergence, and long steps along m.
module dg_turning_step
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type
   use dg_constants, only: pi
   use dg_gap_survey, only: node_offset
   use dg_linear_solver, only: linear_solver_type, solve_linear
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_axial, dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, dof_twist, workspace_type
   implicit none
   private
   public :: is_straight_down, turn_along_wall, turning_mode, take_off_drive, solve_turning, phase_type, turn_to_rest, axis_of
   public :: upright

   !> Nodes so far off the axis, over the clearance, are turned about it, by no more than this in a step [rad].
   real(wp), parameter :: turned_beyond = 0.3_wp, largest_swing = 0.5_wp
   !> Vertical to round-off: cosine of the inclination.
   real(wp), parameter :: upright = 1.0_wp - 1.0e-12_wp
   !> Turns tried until the phase is found in which nothing drives a string; the first three, quarter turns, tell how the drive
   !> depends on it.
   integer, parameter :: most_turns = 8, samples = 3

   !> The phase in which something holds a string that nothing drives steadily.
   type :: phase_type
      integer :: turns = 0
      real(wp) :: pull(samples) = 0.0_wp     !< at 0, 90 and 180 deg
      real(wp) :: angle = 0.0_wp             !< from where it began [rad]
   end type phase_type

contains

   !> Whether the hole is vertical along the whole string.
   pure function is_straight_down(mesh) result(straight)
      type(mesh_type), intent(in) :: mesh
      logical :: straight
      straight = all(mesh%frame(3, 1, :) > upright)
   end function is_straight_down

   !> state <- state + step, where the lateral step of a node across its offset from the hole axis is a turn about that axis:
   !> offset and slope turn by the step over the radius. To first order it is the plain sum.
   pure subroutine turn_along_wall(trajectory, mesh, work, step, state)
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
         if (square > (turned_beyond*mesh%clearance(min(n, mesh%elements)))**2 .and. abs(turn) < largest_swing*square) then
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

   !> The turn of the whole string about the axis of a vertical hole.
   pure subroutine turning_mode(state, mode)
      real(wp), intent(in) :: state(:, :)
      real(wp), intent(inout) :: mode(:, :)
      mode(dof_lateral_1, :) = -state(dof_lateral_2, :)
      mode(dof_lateral_2, :) = state(dof_lateral_1, :)
      mode(dof_slope_1, :) = -state(dof_slope_2, :)
      mode(dof_slope_2, :) = state(dof_slope_1, :)
   end subroutine turning_mode

   !> What of the lateral places and slopes of a string belongs to the hole axis where its nodes now are: a string that hangs
   !> a little below a vertical hole's end stands in a bend there, and what turns about the axis turns about the bent one.
   pure subroutine axis_of(trajectory, mesh, work, state, axis)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< nodes placed at `state`
      real(wp), intent(in) :: state(:, :)
      real(wp), intent(out) :: axis(:, :)
      real(wp) :: gap(3), tangent(3)
      integer :: n
      axis = 0.0_wp
      do n = 1, mesh%nodes
         call node_offset(trajectory, mesh, work, n, gap, tangent)
         axis(dof_lateral_1:dof_lateral_2, n) = state(dof_lateral_1:dof_lateral_2, n) &
                                                - [dot_product(gap, mesh%frame(:, 2, n)), dot_product(gap, mesh%frame(:, 3, n))]
         axis(dof_slope_1:dof_slope_2, n) = [dot_product(tangent, mesh%frame(:, 2, n)), &
                                             dot_product(tangent, mesh%frame(:, 3, n))]/dot_product(tangent, mesh%frame(:, 1, n))
      end do
   end subroutine axis_of

   !> Turns a string at rest but for the drive to where that may be nothing, and a further turn would be resisted. By the phase
   !> theta the drive is a + b cos(theta) + c sin(theta), whatever holds the string being one tilt or one side load. `lost`: there
   !> is no such phase.
   pure subroutine turn_to_rest(phase, pull, state, lost)
      type(phase_type), intent(inout) :: phase
      real(wp), intent(in) :: pull                 !< lambda of take_off_drive
      real(wp), intent(inout) :: state(:, :)       !< less axis_of
      logical, intent(out) :: lost
      real(wp) :: a, b, c, turn
      integer :: n
      phase%turns = phase%turns + 1
      lost = phase%turns > most_turns
      if (lost) return
      turn = 0.5_wp*pi
      if (phase%turns <= samples) phase%pull(phase%turns) = pull
      if (phase%turns >= samples) then
         a = 0.5_wp*(phase%pull(1) + phase%pull(3))
         b = phase%pull(1) - a
         c = phase%pull(2) - a
         lost = .not. abs(a) < hypot(b, c)
         if (lost) return
         if (phase%turns == samples) then
            turn = atan2(-b, c) - asin(a/hypot(b, c)) - phase%angle
         else
            turn = -pull/(c*cos(phase%angle) - b*sin(phase%angle))
         end if
      end if
      phase%angle = phase%angle + turn
      do n = 1, size(state, 2)
         state(dof_lateral_1:dof_lateral_2, n) = turned(state(dof_lateral_1:dof_lateral_2, n), turn)
         state(dof_slope_1:dof_slope_2, n) = turned(state(dof_slope_1:dof_slope_2, n), turn)
      end do
   end subroutine turn_to_rest

   !> Takes off the residual what drives that turn, spread as mud would resist it; `drive` is the largest force of it [N],
   !> `pull` lambda [-].
   pure subroutine take_off_drive(lump, mode, residual, drive, pull)
      real(wp), intent(in) :: lump(:, :), mode(:, :)
      real(wp), intent(inout) :: residual(:, :)
      real(wp), intent(out) :: drive, pull
      real(wp) :: weight
      drive = 0.0_wp
      pull = 0.0_wp
      weight = sum(mode*lump*mode)
      if (.not. weight > 0.0_wp) return
      pull = sum(mode*residual)/weight
      residual = residual - pull*lump*mode
      drive = maxval(abs(pull*lump(dof_lateral_1, :)*mode(dof_lateral_1, :)))
   end subroutine take_off_drive

   !> Newton's step(6,nodes) of a string that turns; the matrix K comes back with what the turn adds to it. info as of solve_linear.
   subroutine solve_turning(solver, lump, mode, pull, residual, matrix, room, step, info)
      type(linear_solver_type), intent(inout) :: solver
      real(wp), intent(in) :: lump(:, :), mode(:, :)
      real(wp), intent(in) :: pull                        !< lambda [-]
      real(wp), intent(in) :: residual(:, :)              !< without the drive
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), intent(inout) :: room(:, :)
      real(wp), intent(out) :: step(:, :)
      integer, intent(out) :: info
      real(wp) :: part
      integer :: node
      call add_turn(lump, pull, matrix)
      call hold_node(mode, matrix, node)
      if (node > 0) then
         step = -lump*mode
         call solve_linear(solver, matrix, step, room, info)
         if (info /= 0) return
      end if
      call solve_linear(solver, matrix, residual, step, info)
      if (info /= 0 .or. node == 0) return
      associate (across => mode(dof_lateral_1:dof_lateral_2, node))
         part = sum(across*room(dof_lateral_1:dof_lateral_2, node))
         if (abs(part) > 0.0_wp) step = step - (sum(across*step(dof_lateral_1:dof_lateral_2, node))/part)*room
      end associate
      call fix_phase(lump, mode, step)
   end subroutine solve_turning

   !> Takes lambda M J off a matrix.
   pure subroutine add_turn(lump, pull, matrix)
      real(wp), intent(in) :: lump(:, :), pull
      type(block_matrix_type), intent(inout) :: matrix
      integer, parameter :: first(2) = [dof_lateral_1, dof_slope_1], second(2) = [dof_lateral_2, dof_slope_2]
      integer :: n, i
      do n = 1, size(lump, 2)
         do i = 1, size(first)
            matrix%diagonal(first(i), second(i), n) = matrix%diagonal(first(i), second(i), n) + pull*lump(first(i), n)
            matrix%diagonal(second(i), first(i), n) = matrix%diagonal(second(i), first(i), n) - pull*lump(second(i), n)
         end do
      end do
   end subroutine add_turn

   !> Puts a spring, as stiff as the string there, on the node farthest off the axis, across its offset; node = 0: all are on it.
   pure subroutine hold_node(mode, matrix, node)
      real(wp), intent(in) :: mode(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      integer, intent(out) :: node
      real(wp) :: across(2), stiffness
      integer :: i
      node = maxloc(mode(dof_lateral_1, :)**2 + mode(dof_lateral_2, :)**2, dim=1)
      across = mode(dof_lateral_1:dof_lateral_2, node)
      if (.not. norm2(across) > 0.0_wp) then
         node = 0
         return
      end if
      across = across/norm2(across)
      associate (block => matrix%diagonal(dof_lateral_1:dof_lateral_2, dof_lateral_1:dof_lateral_2, node))
         stiffness = abs(block(1, 1)) + abs(block(2, 2))
         do i = 1, 2
            block(:, i) = block(:, i) + stiffness*across(i)*across
         end do
      end associate
   end subroutine hold_node

   !> Takes that turn off a step.
   pure subroutine fix_phase(lump, mode, step)
      real(wp), intent(in) :: lump(:, :), mode(:, :)
      real(wp), intent(inout) :: step(:, :)
      real(wp) :: weight
      weight = sum(mode*lump*mode)
      if (weight > 0.0_wp) step = step - (sum(mode*lump*step)/weight)*mode
   end subroutine fix_phase
end module dg_turning_step
