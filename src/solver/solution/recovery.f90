!> Results from unknowns: forces along the string, sums, and the check of global equilibrium.
module dg_recovery
   use dg_kinds, only: wp
   use dg_beam_bend, only: bend_moment, holding_moment
   use dg_case_result, only: gap_row_type
   use dg_gap_survey, only: node_offset, point_on_string
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_line_load
   use dg_mesh, only: mesh_type
   use dg_model, only: model_type
   use dg_profile, only: new_profile, profile_type, side_above, side_none, taken_rows
   use dg_profile_rows, only: lay_rows
   use dg_trajectory, only: azimuth_of, clock_angle, inclination_of, trajectory_type
   use dg_vector, only: cross
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: recover_profile, part_profile, recover_gaps, recover_bit, check_equilibrium, buoyed_axial_weight

contains

   !> Profile at the nodes, surface to bit, from a workspace assembled at the solution. Axial force (tension positive), shear
   !> force and bending moment belong to the cross-section at the node. They are end forces less the element's own loads, as
   !> the mean of both sides. Torque is equal on both sides. Side force is the contact force of the gaps over their length,
   !> shared by both ends.
   pure subroutine recover_profile(trajectory, mesh, gaps, work, profile)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(profile_type), intent(out) :: profile
      real(wp) :: position(3), tangent(3), gap(3), foot_tangent(3), share, upper(6), lower(6), across(3)
      integer :: n, e, sides
      profile = new_profile(mesh%nodes)
      profile%md = mesh%md
      do n = 1, mesh%nodes
         position = trajectory%arcs(mesh%arc(n))%origin + mesh%base(:, n)
         tangent = mesh%frame(:, 1, n)
         profile%north(n) = position(1)
         profile%east(n) = position(2)
         profile%tvd(n) = position(3)
         profile%inclination(n) = inclination_of(tangent)
         profile%azimuth(n) = azimuth_of(tangent)
         call node_offset(trajectory, mesh, work, n, gap, foot_tangent)
         profile%displacement(n) = norm2(gap)
         profile%clock(n) = clock_angle(foot_tangent, gap)
         ! forces of the elements above and below on this node, whose sum is the node's force
         lower = 0.0_wp
         if (n < mesh%nodes) lower = work%end_force(:, n)
         upper = 0.0_wp
         if (n > 1) upper = work%node_force(:, n) - lower
         if (n == mesh%nodes) upper(1:3) = upper(1:3) + work%bit_reaction + work%bit_load
         share = 0.0_wp
         sides = 0
         if (n > 1) then
            e = n - 1
            sides = sides + 1
            profile%axial(n) = profile%axial(n) + dot_product(upper(1:3), work%d(:, n))
            profile%side_force(n) = profile%side_force(n) + 0.5_wp*work%normal(e)
            share = share + 0.5_wp*mesh%length(e)
            profile%gap_state(n) = max(profile%gap_state(n), gaps%state(e))
         end if
         if (n < mesh%nodes) then
            e = n
            sides = sides + 1
            profile%axial(n) = profile%axial(n) - dot_product(lower(1:3), work%d(:, n))
            profile%side_force(n) = profile%side_force(n) + 0.5_wp*work%normal(e)
            share = share + 0.5_wp*mesh%length(e)
            profile%gap_state(n) = max(profile%gap_state(n), gaps%state(e))
         end if
         profile%axial(n) = profile%axial(n)/sides
         profile%torque(n) = work%node_torque(n)
         profile%bending(n) = norm2(cross(work%d(:, n), upper(4:6) - lower(4:6)))/sides
         across = (upper(1:3) - lower(1:3))/sides
         profile%shear(n) = norm2(across - dot_product(across, work%d(:, n))*work%d(:, n))
         profile%side_force(n) = max(profile%side_force(n), 0.0_wp)/share
      end do
   end subroutine recover_profile

   !> Double the rows of recover_profile where something changes. Each side has side force and state of its own element.
   pure subroutine part_profile(model, case_index, mesh, gaps, work, profile)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(profile_type), intent(inout) :: profile      !< on entry at the nodes of the mesh
      integer, allocatable :: from(:), side(:)
      integer :: i, e
      call lay_rows(model, case_index, profile%md, from, side)
      profile = taken_rows(profile, from)
      profile%side = side
      do i = 1, size(side)
         if (side(i) == side_none) cycle
         e = merge(from(i) - 1, from(i), side(i) == side_above)
         profile%side_force(i) = max(work%normal(e), 0.0_wp)/mesh%length(e)
         profile%gap_state(i) = gaps%state(e)
      end do
   end subroutine part_profile

   !> States of the gaps at the end, one row per element from the top down.
   pure subroutine recover_gaps(mesh, gaps, work, rows)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(gap_row_type), allocatable, intent(out) :: rows(:)
      allocate (rows(mesh%elements))
      rows%md = mesh%md(:mesh%elements) + gaps%xi*mesh%length
      rows%state = gaps%state
      rows%force = max(work%normal, 0.0_wp)
      rows%flips = gaps%flips
      rows%moves = gaps%moves
   end subroutine recover_gaps

   !> Side force and tilt of the bit, against the hole axis at its present place. A string that is free at the bit has no side
   !> force there.
   pure subroutine recover_bit(trajectory, mesh, work, side_force, side_clock, tilt, tilt_clock)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(out) :: side_force    !< on the formation [N]
      real(wp), intent(out) :: side_clock    !< its direction [rad]
      real(wp), intent(out) :: tilt          !< angle between bit and hole axis [rad]
      real(wp), intent(out) :: tilt_clock    !< direction in which the bit points [rad]
      real(wp) :: gap(3), tangent(3), across(3)
      call node_offset(trajectory, mesh, work, mesh%nodes, gap, tangent)
      side_force = norm2(work%bit_reaction)
      side_clock = clock_angle(tangent, -work%bit_reaction)
      across = work%d(:, mesh%nodes) - dot_product(work%d(:, mesh%nodes), tangent)*tangent
      tilt = asin(min(norm2(across), 1.0_wp))
      tilt_clock = clock_angle(tangent, across)
   end subroutine recover_bit

   !> Sum of all external forces [N] and of their moments about the top [N.m] on the displaced string. They are weight,
   !> contact, friction and its moments, pads, bit loads, reactions, and the moments that hold a bend. Both are zero but for
   !> round-off and the residual's tolerance.
   pure subroutine check_equilibrium(mesh, gaps, work, force, moment)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      real(wp), intent(out) :: force, moment   !< their sizes [N, N.m]
      real(wp) :: forces(3), moments(3), lever(3), lower(3), chord(3), weight(4), drag(3, 2), start(3), pushed(3, 4)
      real(wp) :: line(4)
      integer :: e
      forces = work%reaction
      start = 0.0_wp                          ! node on the axis, from the top
      lower = work%shift(:, 1)                ! node where it is
      moments = cross(lower, work%reaction) + work%top_moment
      do e = 1, mesh%elements
         lever = lower
         lower = start + mesh%chord(:, e) + work%shift(:, e + 1)
         weight = mesh%weight(e)*hermite_line_load(mesh%length(e))       ! downwards, on places and directors
         forces(3) = forces(3) + weight(1) + weight(3)
         moments(1) = moments(1) + weight(1)*lever(2) + weight(2)*work%d(2, e) + weight(3)*lower(2) + weight(4)*work%d(2, e + 1)
         moments(2) = moments(2) - weight(1)*lever(1) - weight(2)*work%d(1, e) - weight(3)*lower(1) - weight(4)*work%d(1, e + 1)
         if (abs(mesh%drag(e)) > 0.0_wp) then
            drag = 0.5_wp*mesh%drag(e)*mesh%frame(:, 1, e:e + 1)
            forces = forces + drag(:, 1) + drag(:, 2)
            moments = moments + cross(lever, drag(:, 1)) + cross(lower, drag(:, 2))
         end if
         if (allocated(mesh%push)) then
            line = hermite_line_load(mesh%length(e))
            pushed = spread(line, 1, 3)*spread(mesh%push(:, e), 2, 4)                                 ! likewise
            forces = forces + pushed(:, 1) + pushed(:, 3)
            moments = moments + cross(lever, pushed(:, 1)) + cross(work%d(:, e), pushed(:, 2)) &
                      + cross(lower, pushed(:, 3)) + cross(work%d(:, e + 1), pushed(:, 4))
         end if
         if (allocated(mesh%bend)) then
            if (any(abs(mesh%bend(:, e)) > 0.0_wp)) then
               chord = lower - lever
               moments = moments + holding_moment(bend_moment(mesh%section(e)%ei, mesh%length(e), norm2(mesh%bend(:, e))), &
                                                  mesh%bend(:, e), chord, work%d(:, e), work%d(:, e + 1))
            end if
         end if
         if (any(abs(work%contact_force(:, e)) > 0.0_wp)) then
            lever = start + point_on_string(mesh, work, e, gaps%xi(e))
            forces = forces + work%contact_force(:, e)
            moments = moments + cross(lever, work%contact_force(:, e))
         end if
         moments = moments + work%contact_moment(:, e)
         start = start + mesh%chord(:, e)
      end do
      lever = work%bit_reaction + work%bit_load
      forces = forces + lever
      moments = moments + cross(lower, lever) + work%bit_moment
      force = norm2(forces)
      moment = norm2(moments)
   end subroutine check_equilibrium

   !> Weight of the string along the hole [N]: sum of buoyed weight times vertical extent.
   pure function buoyed_axial_weight(mesh) result(weight)
      type(mesh_type), intent(in) :: mesh
      real(wp) :: weight
      weight = sum(mesh%weight*mesh%chord(3, :))
   end function buoyed_axial_weight
end module dg_recovery
