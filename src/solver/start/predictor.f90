!> Start of the iteration: the soft string as beams in the hole.
!>
!> The soft string gives axial force, torque and the side on which each place touches. Steps:
!> - nodes are put on that side, and pressed into the wall by the contact force
!> - they are turned up the wall if the string rotates
!> - the line is bent as a beam (dg_bent_start)
!> - nodes are slid along the hole until every element carries the soft string's axial force
!> - twist follows from the torque
!> From the hole axis with the full load the iteration takes many times as long, and may diverge.
module dg_predictor
   use dg_kinds, only: wp
   use dg_beam_element, only: membrane_length
   use dg_bending_beam, only: bending_beam_type
   use dg_bending_element, only: contact_places, contact_xi
   use dg_bent_start, only: bend_start, new_start_beam
   use dg_buckled_start, only: lay_buckled
   use dg_helical_load, only: wound_compression
   use dg_gap_state, only: state_elastic, state_free
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_slope, hermite_value
   use dg_mesh, only: mesh_type, widest_beside
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_extremum
   use dg_soft_string_loads, only: other_loads_type, soft_string_at
   use dg_trajectory, only: arc_at, frame_on_arc, trajectory_type
   use dg_tuning, only: tuning_type
   use dg_vector, only: cross
   use dg_workspace, only: dof_axial, dof_slope_1, dof_slope_2, dof_twist
   implicit none
   private
   public :: predict, start_type

   !> Settings of a start.
   type :: start_type
      real(wp) :: scale = 1.0_wp       !< factor on friction and bit loads [-]
      real(wp) :: softness = 1.0_wp    !< stiffness of the walls at the start over their own [-]
      !> Contact forces are spread as against a soft wall. Against the wall itself they concentrate where the string touches,
      !> and only then are the places of the gaps right.
      logical :: spread = .false.
   end type start_type

   !> Corrections of an element's slide for its length. The first leaves newtons of axial force, the second thousandths.
   integer, parameter :: slide_steps = 2
   !> A last correction shorter than this leaves the node's slope unchanged [m]. In a hole of 10 m radius that makes an error
   !> of 1e-9.
   real(wp), parameter :: straight_slide = 1.0e-8_wp
   !> A contact side that turns by less than this does not turn [rad]: it is round-off.
   real(wp), parameter :: least_turn = 1.0e-6_wp

contains

   !> Set state(6,nodes), the expected contact forces and the gaps' states from the soft string of the load case, with friction
   !> and bit loads scaled. A gap whose load is off the middle of its element is put there. The string is bent against the soft
   !> wall. If it were outside the hole there, it is bent against the wall itself. Contact forces are those against the wall
   !> itself, unless start%spread. A string under right-hand torque buckles into a left-handed helix.
   pure subroutine predict(model, case_index, mesh, start, sideways, state, gaps, pressed)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_type), intent(in) :: mesh
      type(start_type), intent(in) :: start
      real(wp), intent(in) :: sideways(:) !< factor on the force of circumferential friction, by element [-]
      real(wp), intent(out) :: state(:, :)  !< (6,nodes) [m, rad, -]
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(out) :: pressed(:)   !< contact forces, by element [N]
      real(wp) :: axial(mesh%nodes), torque(mesh%nodes), contact(3, mesh%nodes), wall(mesh%elements)
      real(wp) :: offset(2, mesh%nodes), slope(2, mesh%nodes), load(mesh%nodes), force, n(3), friction, place, depth
      real(wp) :: y(4, mesh%nodes), forces(contact_places, mesh%elements)
      real(wp) :: bent(4, mesh%nodes), hard(contact_places, mesh%elements)
      real(wp) :: wound(mesh%nodes)
      type(bending_beam_type) :: beam
      logical :: found, sharp, left_handed
      integer :: i, e, knots, knot(mesh%nodes)
      wall = start%softness*mesh%wall
      where (mesh%opening < mesh%clearance) wall = mesh%wall     ! bow springs are soft
      call soft_string_at(model, case_index, mesh%md, axial, torque, contact, &
                          other=other_loads_type(start%scale, start%scale, coiled=.true.))
      offset = 0.0_wp
      do i = 1, mesh%nodes
         force = norm2(contact(:, i))
         load(i) = force
         if (.not. force > 0.0_wp) cycle
         e = min(i, mesh%elements)
         friction = mesh%friction_around(e)*sideways(e)*start%scale
         n = contact(:, i)/force
         n = (n - friction*cross(mesh%frame(:, 1, i), n))/sqrt(1.0_wp + friction**2)
         depth = mesh%lying(e) + force*mesh%load_factor(e)/wall(e)
         if (mesh%opening(e) < mesh%clearance(e)) &
            depth = min(mesh%opening(e) + force*mesh%load_factor(e)/wall(e), mesh%clearance(e))
         offset(:, i) = depth*[dot_product(n, mesh%frame(:, 2, i)), dot_product(n, mesh%frame(:, 3, i))]
      end do
      call find_knots(model%numerics%tuning, mesh, knot, knots)
      slope = 0.0_wp
      call slopes_of(mesh, knot(:knots), offset, slope)
      call lay_between(mesh, knot(:knots), offset, slope)
      wound = axial
      do i = 1, mesh%nodes
         if (axial(i) < 0.0_wp) wound(i) = -wound_compression(mesh%section(min(i, mesh%elements))%ei, -axial(i), torque(i))
      end do
      left_handed = coils_left(axial, torque, offset)
      if (left_handed) call mirror(offset, slope)
      call lay_buckled(model, mesh, wound, wall, load, offset, slope)
      if (left_handed) call mirror(offset, slope)
      if (any(mesh%beside_edge)) call lay_between(mesh, knot(:knots), offset, slope)
      if (model%boundary%top_centred) offset(:, 1) = 0.0_wp
      if (model%boundary%bit_centred) offset(:, mesh%nodes) = 0.0_wp
      y(1:2, :) = offset
      y(3:4, :) = slope
      found = .false.
      if (model%numerics%tuning%start_bent) then
         call new_start_beam(model, mesh, axial, torque, start%scale*mesh%friction_along, &
                             start%scale*sideways*mesh%friction_around, beam)
         call bend_start(mesh, wall, 0.0_wp, beam, y, forces, found)
      end if
      if (found .and. .not. start%spread) then
         bent = y
         call bend_start(mesh, mesh%wall, maxval(wall), beam, bent, hard, sharp)
         if (sharp) then
            forces = hard
            if (lies_outside(model%numerics%tuning%start_outside, mesh, y)) y = bent
         end if
      end if
      call slide_into_place(model%trajectory, mesh, axial, y(1:2, :), y(3:4, :), state)
      do e = 1, mesh%elements
         state(dof_twist, e + 1) = state(dof_twist, e) - 0.5_wp*(torque(e) + torque(e + 1))*mesh%length(e)/mesh%section(e)%gj
         pressed(e) = 0.5_wp*mesh%load_factor(e)*(load(e) + load(e + 1))*mesh%length(e)
         if (found) pressed(e) = sum(forces(:, e))
         gaps%state(e) = merge(state_elastic, state_free, pressed(e) > 0.0_wp)
         if (.not. (found .and. pressed(e) > 0.0_wp .and. model%numerics%gap_location == gap_at_extremum)) cycle
         if (mesh%centralizer(e)) cycle
         place = dot_product(contact_xi, forces(:, e))/pressed(e)
         if (abs(place - gaps%xi(e)) > model%numerics%tuning%aside) gaps%xi(e) = place
      end do
   end subroutine predict

   !> True if a compressed string buckles into a left-handed helix. The helix is against its torque. Without torque, it turns
   !> as the contact side of the string turns along the hole. A mirrored hole then has the mirrored helix. In a plane both are
   !> alike.
   pure function coils_left(axial, torque, offset) result(left)
      real(wp), intent(in) :: axial(:), torque(:)   !< by node [N, N.m]
      real(wp), intent(in) :: offset(:, :)          !< before buckling (2,nodes) [m]
      logical :: left
      real(wp) :: turn, wound, size_of_both
      integer :: i
      wound = sum(torque, mask=axial < 0.0_wp)
      turn = 0.0_wp
      do i = 2, size(axial)
         if (max(axial(i - 1), axial(i)) >= 0.0_wp) cycle
         size_of_both = norm2(offset(:, i - 1))*norm2(offset(:, i))
         if (size_of_both > 0.0_wp) &
            turn = turn + (offset(1, i - 1)*offset(2, i) - offset(2, i - 1)*offset(1, i))/size_of_both
      end do
      left = wound > 0.0_wp
      if (.not. abs(wound) > 0.0_wp) left = turn < -least_turn
   end function coils_left

   !> Mirror the line in a plane along the hole. A right-handed helix that is set on the image is left-handed in the hole.
   pure subroutine mirror(offset, slope)
      real(wp), intent(inout) :: offset(:, :), slope(:, :)   !< (2,nodes) [m, -]
      offset(2, :) = -offset(2, :)
      slope(2, :) = -slope(2, :)
   end subroutine mirror

   !> True if a node of the line y(4,nodes) is farther off the axis than `times` its clearance.
   pure function lies_outside(times, mesh, y) result(outside)
      real(wp), intent(in) :: times
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: y(:, :)
      logical :: outside
      integer :: i
      outside = .false.
      do i = 1, mesh%nodes
         outside = norm2(y(1:2, i)) > times*widest_beside(mesh, i)
         if (outside) return
      end do
   end function lies_outside

   !> Find the nodes through which a start is laid. Others follow a cubic between them. These are nodes beside an edge of the
   !> string, and nodes close to one above but next to a much longer element. The latter occur where a component ends beside a
   !> station. The offset may jump there with the clearance. A very short element between two such nodes would start with up to
   !> millions of times the force that it can carry.
   pure subroutine find_knots(tuning, mesh, knot, knots)
      type(tuning_type), intent(in) :: tuning
      type(mesh_type), intent(in) :: mesh
      integer, intent(out) :: knot(:)       !< nodes, increasing, the ends among them
      integer, intent(out) :: knots
      integer :: i, j
      real(wp) :: least
      knots = 1
      knot(1) = 1
      do i = 2, mesh%nodes
         if (mesh%beside_edge(i)) cycle
         least = 0.0_wp
         if (i < mesh%nodes) then
            j = findloc(mesh%beside_edge(i + 1:), .false., dim=1) + i      ! the next that may be one
            if (.not. mesh%spacing(i - 1) > 0.0_wp) least = tuning%sliver*(mesh%md(j) - mesh%md(i))
         end if
         if (mesh%md(i) - mesh%md(knot(knots)) < least .and. knots > 1) cycle
         knots = knots + 1
         knot(knots) = i
      end do
   end subroutine find_knots

   !> Set slopes of lateral offsets (2,nodes) at the knots, by differences between them [-].
   pure subroutine slopes_of(mesh, knot, offset, slope)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: knot(:)
      real(wp), intent(in) :: offset(:, :)
      real(wp), intent(inout) :: slope(:, :)
      integer :: k, before, after
      do k = 1, size(knot)
         before = knot(max(k - 1, 1))
         after = knot(min(k + 1, size(knot)))
         slope(:, knot(k)) = (offset(:, after) - offset(:, before))/(mesh%md(after) - mesh%md(before))
      end do
   end subroutine slopes_of

   !> Put the nodes between knots on the cubic through the knots.
   pure subroutine lay_between(mesh, knot, offset, slope)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: knot(:)
      real(wp), intent(inout) :: offset(:, :), slope(:, :)
      real(wp) :: xi, length, shape(4), rise(4)
      integer :: i, k, before, after
      do k = 2, size(knot)
         before = knot(k - 1)
         after = knot(k)
         length = mesh%md(after) - mesh%md(before)
         do i = before + 1, after - 1
            xi = (mesh%md(i) - mesh%md(before))/length
            shape = hermite_value(xi, length)
            rise = hermite_slope(xi, length)
            slope(:, i) = rise(1)*offset(:, before) + rise(2)*slope(:, before) + rise(3)*offset(:, after) + rise(4)*slope(:, after)
            offset(:, i) = shape(1)*offset(:, before) + shape(2)*slope(:, before) + shape(3)*offset(:, after) &
                           + shape(4)*slope(:, after)
         end do
      end do
   end subroutine lay_between

   !> Slide node after node along the hole until each element carries its axial force. The first slide is the element's
   !> stretch, the next ones correct its length.
   pure subroutine slide_into_place(trajectory, mesh, axial, offset, slope, state)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:), offset(:, :), slope(:, :)
      real(wp), intent(out) :: state(:, :)
      real(wp) :: slide, more, shift(3), previous(3), d(3), previous_d(3), chord(3), strain, reference, tangent(3)
      integer :: e, step
      state = 0.0_wp
      slide = 0.0_wp
      call place(trajectory, mesh, 1, slide, offset(:, 1), slope(:, 1), tangent, previous, previous_d)
      call find_unknowns(mesh%frame(:, :, 1), previous, previous_d, state(:, 1))
      do e = 1, mesh%elements
         reference = mesh%section(e)%membrane_length
         strain = 0.5_wp*(axial(e) + axial(e + 1))/mesh%section(e)%ea
         more = reference*strain
         do step = 1, slide_steps
            slide = slide + more
            call place(trajectory, mesh, e + 1, slide, offset(:, e + 1), slope(:, e + 1), tangent, shift, d)
            chord = mesh%chord(:, e) + (shift - previous)
            more = reference*(1.0_wp + strain) - membrane_length(chord, previous_d, d)
         end do
         slide = slide + more
         if (abs(more) < straight_slide) then
            shift = shift + more*tangent
         else
            call place(trajectory, mesh, e + 1, slide, offset(:, e + 1), slope(:, e + 1), tangent, shift, d)
         end if
         call find_unknowns(mesh%frame(:, :, e + 1), shift, d, state(:, e + 1))
         previous = shift
         previous_d = d
      end do
   end subroutine slide_into_place

   !> Put a node off the hole axis at its depth plus `slide` [m]. Returns the axis' tangent there, displacement [m] and
   !> director.
   pure subroutine place(trajectory, mesh, node, slide, offset, slope, tangent, shift, d)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(in) :: slide, offset(2), slope(2)
      real(wp), intent(out) :: tangent(3), shift(3), d(3)
      real(wp) :: lateral_1(3), lateral_2(3), axis(3), md
      integer :: arc, a
      md = mesh%md(node) + slide
      arc = arc_at(trajectory, md, near=mesh%arc(node))
      call frame_on_arc(trajectory%arcs(arc), md - trajectory%arcs(arc)%md, tangent, lateral_1, lateral_2, axis)
      do a = mesh%arc(node), arc - 1
         axis = axis + trajectory%arcs(a)%chord
      end do
      do a = arc, mesh%arc(node) - 1
         axis = axis - trajectory%arcs(a)%chord
      end do
      shift = axis - mesh%base(:, node) + offset(1)*lateral_1 + offset(2)*lateral_2
      d = (tangent + slope(1)*lateral_1 + slope(2)*lateral_2)*(1.0_wp/sqrt(1.0_wp + slope(1)**2 + slope(2)**2))
   end subroutine place

   !> Compute the unknowns of a node from its displacement and director. Written out, as matmul of the run-time library would
   !> cost more than all the rest.
   pure subroutine find_unknowns(frame, shift, d, unknowns)
      real(wp), intent(in) :: frame(3, 3), shift(3), d(3)
      real(wp), intent(inout) :: unknowns(:)
      real(wp) :: along(3), reciprocal
      integer :: i
      do i = 1, 3
         unknowns(dof_axial - 1 + i) = shift(1)*frame(1, i) + shift(2)*frame(2, i) + shift(3)*frame(3, i)
         along(i) = d(1)*frame(1, i) + d(2)*frame(2, i) + d(3)*frame(3, i)
      end do
      reciprocal = 1.0_wp/along(1)
      unknowns(dof_slope_1) = along(2)*reciprocal
      unknowns(dof_slope_2) = along(3)*reciprocal
   end subroutine find_unknowns
end module dg_predictor
