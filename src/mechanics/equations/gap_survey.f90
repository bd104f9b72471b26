!> Position of the string in the hole: offsets at the nodes and at the gaps, and new places of the gaps. Gap and normal are
!> measured at the present place of a point, not at its first place. A long string slides by many clearances, and a slide must
!> not count as a gap.
module dg_gap_survey
   use dg_kinds, only: wp
   use dg_gap_location, only: bend_of_displacement, extremum_of_displacement
   use dg_gap_state, only: is_round, state_free
   use dg_gap_table, only: gain_to_move, gap_table_type, lone_contacts, move_gap
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: gap_to_axis, trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: at_blade, node_lie, node_offset, out_of_reach, point_on_string, survey_gaps, survey_between, &
             move_rule_type, relocate_gaps

   !> Least gain in depth, over the clearance [-], for which a gap moves where tool joints touch. Otherwise a joint would be
   !> held alternately at its ends, whichever is a micrometre deeper, and bend the bodies between by some per cent. Elsewhere
   !> gaps have no such limit: with one, elements of 1 m need three times the iterations.
   real(wp), parameter :: least_gain = 0.0025_wp

   !> Which gaps may move, and how far.
   type :: move_rule_type
      real(wp) :: threshold = 0.0_wp       !< threshold of move_gap, relative to the clearance [-]
      real(wp) :: most = huge(1.0_wp)      !< largest distance outside the hole at the new place, over the clearance [-]
      real(wp) :: least = 0.0_wp           !< least gain in depth of a move [m]
      logical :: closed = .false.          !< closed gaps move too
      logical :: closely = .false.         !< threshold of single contacts is relative to their penetration, not to the clearance
   end type move_rule_type

contains

   !> Offset f(3) of a node from the hole axis [m] and the axis' tangent at the present place of the node.
   pure subroutine node_offset(trajectory, mesh, work, node, gap, tangent)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: node
      real(wp), intent(out) :: gap(3), tangent(3)   !< across the hole [m], unit [-]
      real(wp) :: point(3), curvature(3)
      integer :: arc
      arc = mesh%arc(node)
      point = mesh%base(:, node) + work%shift(:, node)
      call gap_to_axis(trajectory, arc, point, gap, tangent, curvature)
   end subroutine node_offset

   !> Offset of a node from the hole axis, and slope of the string against the axis there.
   pure subroutine node_lie(trajectory, mesh, work, node, gap, slope)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: node
      real(wp), intent(out) :: gap(3), slope(3)   !< across the hole [m]; director less tangent [-]
      real(wp) :: tangent(3)
      call node_offset(trajectory, mesh, work, node, gap, tangent)
      slope = work%d(:, node) - tangent
   end subroutine node_lie

   !> Point of an element's axis at xi = x/L, relative to the hole axis at its upper node [m].
   pure function point_on_string(mesh, work, e, xi) result(point)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: e
      real(wp), intent(in) :: xi   !< 0 at the upper node, 1 at the lower one [-]
      real(wp) :: point(3)
      point = point_between(xi, mesh%length(e), mesh%chord(:, e), work%shift(:, e), work%d(:, e), work%shift(:, e + 1), &
                            work%d(:, e + 1))
   end function point_on_string

   !> Point of the string by Hermite's cubic (dg_hermite) through displacements and directors of the nodes.
   pure function point_between(xi, length, chord, shift_i, d_i, shift_j, d_j) result(point)
      real(wp), intent(in) :: xi, length, chord(3), shift_i(3), d_i(3), shift_j(3), d_j(3)
      real(wp) :: point(3)
      real(wp) :: rest, shape_i, turn_i, shape_j, turn_j
      integer :: i
      rest = 1.0_wp - xi
      shape_i = rest*rest*(1.0_wp + 2.0_wp*xi)
      turn_i = rest*rest*xi*length
      shape_j = xi*xi*(1.0_wp + 2.0_wp*rest)
      turn_j = -xi*xi*rest*length
      do i = 1, 3
         point(i) = shape_i*shift_i(i) + turn_i*d_i(i) + shape_j*(chord(i) + shift_j(i)) + turn_j*d_j(i)
      end do
   end function point_between

   !> Measure all gaps at their places x0 and the present places of the nodes (call place_nodes first).
   pure subroutine survey_gaps(trajectory, mesh, gaps, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(inout) :: work
      call survey_between(trajectory, mesh, gaps, 1, mesh%elements, work)
   end subroutine survey_gaps

   !> Measure the gaps of elements first to last.
   pure subroutine survey_between(trajectory, mesh, gaps, first, last, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: first, last
      type(workspace_type), intent(inout) :: work
      integer :: e
      do e = first, last
         call survey_gap(trajectory, mesh, gaps%xi(e), e, work)
      end do
   end subroutine survey_between

   !> Measure the gap of element e at xi.
   pure subroutine survey_gap(trajectory, mesh, xi, e, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: xi
      integer, intent(in) :: e
      type(workspace_type), intent(inout) :: work
      real(wp) :: point(3)
      integer :: arc
      point = mesh%base(:, e) + point_on_string(mesh, work, e, xi)
      arc = mesh%arc(e)
      call gap_to_axis(trajectory, arc, point, work%gap(:, e), work%axis_tangent(:, e), work%axis_curvature(:, e))
      if (allocated(mesh%blade)) then
         associate (t => work%axis_tangent(:, e))
            work%gap(:, e) = work%gap(:, e) + (mesh%blade(:, e) - dot_product(mesh%blade(:, e), t)*t)
         end associate
      end if
      work%displacement(e) = sqrt(work%gap(1, e)**2 + work%gap(2, e)**2 + work%gap(3, e)**2)
   end subroutine survey_gap

   !> Offset from the hole axis of the part of an element that touches the wall [m]: the centre of its blades.
   pure function at_blade(mesh, e, gap) result(offset)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: gap(3)     !< of the axis of the string [m]
      real(wp) :: offset(3)
      offset = gap
      if (allocated(mesh%blade)) offset = gap + mesh%blade(:, e)
   end function at_blade

   !> Put the gaps at the extremum x0 of their element where the string reaches beyond the wall (Eq. 2), by the rule of
   !> move_gap. Measure them there, and count them (`moved`). Closed gaps are only examined if rule%closed. They stay where
   !> they first touched unless the string is far deeper elsewhere, which is found near the equilibrium. Single contacts are
   !> then examined more closely if rule%closely (see `lone_contacts`). If the string is round there, the gap of such a contact
   !> does not move at first. From then on it follows the extremum within the iteration (dg_followed_gaps).
   pure subroutine relocate_gaps(trajectory, mesh, rule, gaps, work, moved)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(move_rule_type), intent(in) :: rule
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      integer, intent(out) :: moved
      real(wp) :: gap_i(3), gap_j(3), slope_i(3), slope_j(3), blade_i(3), blade_j(3), xi, old, estimate, scale
      logical :: changed
      logical :: lone(mesh%elements)
      integer :: e, known
      moved = 0
      lone = .false.
      if (rule%closely) lone = lone_contacts(gaps%state) .and. .not. mesh%spacing > 0.0_wp
      known = 0                    ! node whose offset is in gap_j
      do e = 1, mesh%elements
         if (.not. (rule%closed .or. gaps%state(e) == state_free) .or. mesh%centralizer(e)) cycle
         if (known == e) then
            gap_i = gap_j
            slope_i = slope_j
         else
            call node_lie(trajectory, mesh, work, e, gap_i, slope_i)
         end if
         call node_lie(trajectory, mesh, work, e + 1, gap_j, slope_j)
         known = e + 1
         scale = gaps%law(e)%clearance
         if (lone(e)) scale = deepest(gaps, work, e)
         blade_i = at_blade(mesh, e, gap_i)
         blade_j = at_blade(mesh, e, gap_j)
         if (out_of_reach(blade_i, slope_i, blade_j, slope_j, mesh%length(e), &
                          max(gaps%law(e)%clearance, work%displacement(e) + gain_to_move(gaps, e, rule%threshold*scale)))) cycle
         call extremum_of_displacement(blade_i, slope_i, blade_j, slope_j, mesh%length(e), xi, estimate)
         if (estimate <= gaps%law(e)%clearance .or. estimate > (1.0_wp + rule%most)*gaps%law(e)%clearance) cycle
         if (estimate - work%displacement(e) < rule%least) cycle
         old = gaps%xi(e)
         if (mesh%spacing(e) > 0.0_wp .and. estimate - work%displacement(e) < least_gain*gaps%law(e)%clearance) cycle
         call move_gap(gaps, e, xi, estimate, work%displacement(e), rule%threshold*scale, changed)
         if (.not. changed) cycle
         moved = moved + 1
         if (lone(e) .and. gaps%state(e) /= state_free) then
            gaps%followed(e) = .not. gaps%followed(e)
            if (gaps%followed(e)) gaps%followed(e) = is_round(gaps%law(e), work%normal(e), &
               bend_of_displacement(blade_i, slope_i, blade_j, slope_j, mesh%length(e), old), rule%threshold)
            if (gaps%followed(e)) gaps%xi(e) = old
            if (gaps%followed(e)) cycle
         end if
         call survey_gap(trajectory, mesh, gaps%xi(e), e, work)
      end do
   end subroutine relocate_gaps

   !> Deepest penetration of a gap and its neighbours [m], 0 if all are open.
   pure function deepest(gaps, work, e) result(depth)
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: e
      real(wp) :: depth
      integer :: i
      depth = 0.0_wp
      do i = max(e - 1, 1), min(e + 1, size(gaps%state))
         depth = max(depth, work%displacement(i) - gaps%law(i)%clearance)
      end do
   end function deepest

   !> True if no point of an element can be as far from the axis as `reach` [m]. This follows from N_1 + N_3 = 1, and from
   !> |N_2| and |N_4| of at most 4/27 of the length. The sum of two slopes is at most the root of twice the sum of their
   !> squares. Let a and b be the squares of the farther node's offset and of the slopes' part. Then sqrt(a) + sqrt(b) < r
   !> where 2 sqrt(a b) < r^2 - a - b.
   pure function out_of_reach(gap_i, slope_i, gap_j, slope_j, length, reach) result(out)
      real(wp), intent(in) :: gap_i(3), slope_i(3), gap_j(3), slope_j(3)   !< of its nodes, from node_lie [m], [-]
      real(wp), intent(in) :: length, reach                                !< of the element, and distance from the axis [m]
      logical :: out
      real(wp), parameter :: slope_shape = 2.0_wp*(4.0_wp/27.0_wp)**2
      real(wp) :: farther, slopes, rest
      farther = max(gap_i(1)**2 + gap_i(2)**2 + gap_i(3)**2, gap_j(1)**2 + gap_j(2)**2 + gap_j(3)**2)
      slopes = slope_shape*length**2*(slope_i(1)**2 + slope_i(2)**2 + slope_i(3)**2 &
                                      + slope_j(1)**2 + slope_j(2)**2 + slope_j(3)**2)
      rest = reach**2 - farther - slopes
      out = rest > 0.0_wp .and. 4.0_wp*farther*slopes < rest**2
   end function out_of_reach
end module dg_gap_survey
