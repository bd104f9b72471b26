!> The start put so that its gaps carry the contact forces that are expected of them.
!>
!> A predicted line is right at the nodes, but between them the cubic of an element may overshoot the wall, or stay off it, by a
!> good part of the clearance: against a wall of 1e6 kN/m2 that is 1e7 N, or an open gap where a whole element's load is to be
!> carried. So each gap that is expected to press is put to the depth that carries its share, by the least lateral change of the
!> nodes that does it; not where it would take more than that share to bend the element there, as with short ones. That makes
!> elements longer or shorter: nodes are slid along the hole until axial forces are what they were.
module dg_pressed_start
   use dg_kinds, only: wp
   use dg_beam_element, only: membrane_length
   use dg_bending_beam, only: contact_xi
   use dg_gap_depths, only: depth_of, depths_type, new_depths, put_gaps
   use dg_gap_state, only: contact_force
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, judge_states
   use dg_mesh, only: mesh_type
   use dg_numerics, only: gap_at_extremum, numerics_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_axial, place_nodes, workspace_type
   implicit none
   private
   public :: press_start

   !> Times that gaps are put to their depths and nodes slid: the second undoes what sliding along a bend does to depths.
   integer, parameter :: rounds = 2
   !> A resultant so far off the middle of its element, over its length, places the gap there [-]: next to places that the string
   !> lifts off from. Less comes of the load's change along an element.
   real(wp), parameter :: aside = 0.05_wp
   !> A force at the middle of a beam on two supports that bends it by a unit, over EI/L^3 [-].
   real(wp), parameter :: bends = 48.0_wp

contains

   !> Moves the nodes of a predicted state(6,nodes) so that gaps carry what is `pressed`, where its resultant is, and leaves what
   !> they carry in work%normal. Walls are those of the first stage.
   pure subroutine press_start(trajectory, mesh, numerics, pressed, gaps, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: pressed(:, :)    !< contact forces at `contact_xi` of the elements (2,e) [N]
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      type(depths_type) :: depth
      real(wp) :: length(mesh%elements), force(mesh%elements), stiffness, place
      integer :: round, e, ignored
      call new_depths(mesh%elements, depth)
      call place_nodes(mesh, state, work)
      length = lengths(mesh, work)
      force = sum(pressed, dim=1)
      do e = 1, mesh%elements
         if (numerics%gap_location /= gap_at_extremum .or. .not. force(e) > 0.0_wp) cycle
         place = dot_product(contact_xi, pressed(:, e))/force(e)
         if (abs(place - gaps%xi(e)) > aside) gaps%xi(e) = place
      end do
      call survey_gaps(trajectory, mesh, gaps, work)
      do round = 1, rounds
         do e = 1, mesh%elements
            depth%wanted(e) = 0.0_wp
            if (.not. force(e) > 0.0_wp) cycle
            depth%wanted(e) = depth_of(gaps%law(e), force(e))
            if (abs(depth%wanted(e) - work%displacement(e))*bends*mesh%ei(e)/mesh%length(e)**3 > force(e)) &
               depth%wanted(e) = 0.0_wp
         end do
         call put_gaps(trajectory, mesh, gaps, depth, state, work)
         call keep_lengths(mesh, length, work, state)
         call place_nodes(mesh, state, work)
         call survey_gaps(trajectory, mesh, gaps, work)
      end do
      call judge_states(gaps, work%displacement, ignored)
      do e = 1, mesh%elements
         call contact_force(gaps%law(e), gaps%state(e), work%displacement(e), work%normal(e), stiffness)
      end do
      gaps%flips = 0
   end subroutine press_start

   !> Lengths of the elements that axial forces go by [m].
   pure function lengths(mesh, work) result(length)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp) :: length(mesh%elements)
      integer :: e
      do e = 1, mesh%elements
         length(e) = membrane_length(mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e)), work%d(:, e), work%d(:, e + 1))
      end do
   end function lengths

   !> Slides node after node along the hole until the elements have their lengths.
   pure subroutine keep_lengths(mesh, length, work, state)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: length(:)
      type(workspace_type), intent(in) :: work     !< nodes placed at `state`
      real(wp), intent(inout) :: state(:, :)
      real(wp) :: now(mesh%elements), slide
      integer :: e
      now = lengths(mesh, work)
      slide = 0.0_wp
      do e = 1, mesh%elements
         slide = slide + length(e) - now(e)
         state(dof_axial, e + 1) = state(dof_axial, e + 1) + slide
      end do
   end subroutine keep_lengths
end module dg_pressed_start
