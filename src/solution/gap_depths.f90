!> Gaps put to the depths in the wall that carry the forces they are to carry.
!>
!> A stiff wall turns micrometres into forces: across a radius of 27 mm a step of 0.2 mm along a wall of 1e8 N/m2 leaves it by a
!> micrometre, hundreds of newtons where ten were, and Newton's tangent, gaps' states and the test of the step go by forces that
!> mean nothing. What a step was solved for are its linear forces. So the string is put back, after the step, to the depth
!> that each closed gap was to have: the least lateral change of the nodes that does it. In the same way forces outlast a change
!> of the wall's stiffness or of a gap's place, and a gap that closes does so without a blow. At rest nothing is put back.
module dg_gap_depths
   use dg_kinds, only: wp
   use dg_gap_state, only: gap_law_type, state_elastic, state_free, state_rigid
   use dg_gap_survey, only: survey_gap, survey_gaps
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_value
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, place_nodes, workspace_type
   implicit none
   private
   public :: depths_after, put_gaps, close_gently, keep_forces

   !> Rounds until gaps are where they are to be, each squaring what is missing; changes so small are the last [m].
   integer, parameter :: most_rounds = 4
   real(wp), parameter :: small_change = 1.0e-8_wp
   !> Part of themselves by which equations are made regular where two gaps stand at one node [-].
   real(wp), parameter :: regular = 1.0e-9_wp

contains

   !> |f| [m] that a step(6,nodes) gives the gaps to first order, from where `work` has them; 0 for open ones.
   pure subroutine depths_after(mesh, gaps, step, work, depth)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: step(:, :)
      type(workspace_type), intent(in) :: work
      real(wp), intent(inout) :: depth(:)
      real(wp) :: shape(4), move(3)
      integer :: e
      do e = 1, mesh%elements
         depth(e) = 0.0_wp
         if (gaps%state(e) == state_free) cycle
         shape = hermite_value(gaps%xi(e), mesh%length(e))
         move = matmul(mesh%frame(:, 2:3, e), shape(1)*step(dof_lateral_1:dof_lateral_2, e) &
                       + shape(2)*step(dof_slope_1:dof_slope_2, e)) &
                + matmul(mesh%frame(:, 2:3, e + 1), shape(3)*step(dof_lateral_1:dof_lateral_2, e + 1) &
                         + shape(4)*step(dof_slope_1:dof_slope_2, e + 1))
         depth(e) = work%displacement(e) + dot_product(work%gap(:, e), move)/work%displacement(e)
      end do
   end subroutine depths_after

   !> Puts gaps that have just closed, which have no depth yet, to where they touch.
   pure subroutine close_gently(trajectory, mesh, gaps, depth, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: depth(:)
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: closing
      integer :: e
      closing = .false.
      do e = 1, mesh%elements
         if (gaps%state(e) == state_free) then
            depth(e) = 0.0_wp
         else if (.not. depth(e) > 0.0_wp) then
            depth(e) = gaps%law(e)%clearance
            closing = .true.
         end if
      end do
      if (closing) call put_gaps(trajectory, mesh, gaps, depth, state, work)
   end subroutine close_gently

   !> Puts closed gaps to where they carry the normal forces that they carried last, whatever their law and place are now.
   pure subroutine keep_forces(trajectory, mesh, gaps, depth, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: depth(:)
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work     !< with the forces of the last assembly
      integer :: e
      do e = 1, mesh%elements
         depth(e) = 0.0_wp
         if (gaps%state(e) /= state_free) depth(e) = depth_of(gaps%law(e), work%normal(e))
      end do
      call put_gaps(trajectory, mesh, gaps, depth, state, work)
   end subroutine keep_forces

   !> |f| [m] at which a closed gap carries a force [N]: the inverse of contact_force.
   pure function depth_of(law, force) result(depth)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: force
      real(wp) :: depth, elastic
      elastic = law%contact*law%clearance*law%eps_nmax
      depth = law%clearance + min(force, elastic)/law%contact + max(force - elastic, 0.0_wp)/law%maximum
   end function depth_of

   !> Moves the nodes of `state`, but the lateral places of the ends, so that each gap with a depth(e) > 0 [m] has |f| = depth(e),
   !> by the least sum of squares of lateral changes and of slopes' times length; `work` is then placed and surveyed, and those gaps
   !> are in the state that belongs to their depth. Each gap bears on two nodes: the equations are tridiagonal.
   pure subroutine put_gaps(trajectory, mesh, gaps, depth, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(in) :: depth(:)
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: row(4, mesh%elements), outward(3, mesh%elements)
      real(wp) :: pivot(mesh%elements), coupling(mesh%elements), push(mesh%elements), largest
      integer :: e, round, before
      do round = 1, most_rounds
         call place_nodes(mesh, state, work)
         largest = 0.0_wp
         do e = 1, mesh%elements
            row(:, e) = 0.0_wp
            outward(:, e) = 0.0_wp
            push(e) = 0.0_wp
            pivot(e) = 1.0_wp
            coupling(e) = 0.0_wp
            if (.not. depth(e) > 0.0_wp) cycle
            call survey_gap(trajectory, mesh, gaps%xi(e), e, work)
            row(:, e) = hermite_value(gaps%xi(e), mesh%length(e))/[1.0_wp, bent(mesh, e), 1.0_wp, bent(mesh, e + 1)]
            if (e == 1) row(1, e) = 0.0_wp
            if (e == mesh%elements) row(3, e) = 0.0_wp
            outward(:, e) = work%gap(:, e)/work%displacement(e)
            push(e) = depth(e) - work%displacement(e)
            largest = max(largest, abs(push(e)))
            pivot(e) = sum(row(:, e)**2)*(1.0_wp + regular) + regular
            before = e - 1
            if (before < 1) cycle
            coupling(e) = sum(row(1:2, e)*row(3:4, before))*dot_product(outward(:, e), outward(:, before))/pivot(before)
            pivot(e) = pivot(e) - coupling(e)**2*pivot(before)
            push(e) = push(e) - coupling(e)*push(before)
         end do
         do e = mesh%elements, 1, -1
            push(e) = push(e)/pivot(e)
            if (e < mesh%elements) push(e) = push(e) - coupling(e + 1)*push(e + 1)
         end do
         do e = 1, mesh%elements
            if (.not. depth(e) > 0.0_wp) cycle
            call move_node(mesh%frame(:, 2:3, e), outward(:, e), push(e)*row(1, e), push(e)*row(2, e)/bent(mesh, e), state(:, e))
            call move_node(mesh%frame(:, 2:3, e + 1), outward(:, e), push(e)*row(3, e), push(e)*row(4, e)/bent(mesh, e + 1), &
                           state(:, e + 1))
         end do
         if (largest < small_change) exit
      end do
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
      do e = 1, mesh%elements
         if (depth(e) > 0.0_wp) gaps%state(e) = merge(state_rigid, state_elastic, &
                                                      depth(e) > gaps%law(e)%clearance*(1.0_wp + gaps%law(e)%eps_nmax))
      end do
   end subroutine put_gaps

   !> Length that makes a slope of a node a displacement [m].
   pure function bent(mesh, n) result(length)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: n
      real(wp) :: length
      length = min(mesh%length(max(n - 1, 1)), mesh%length(min(n, mesh%elements)))
   end function bent

   !> Moves and turns a node outwards.
   pure subroutine move_node(across, outward, by, turn, state)
      real(wp), intent(in) :: across(3, 2)   !< n_1 and n_2 of the node
      real(wp), intent(in) :: outward(3)
      real(wp), intent(in) :: by, turn       !< [m, -]
      real(wp), intent(inout) :: state(6)
      real(wp) :: n(2)
      n = matmul(outward, across)
      state(dof_lateral_1:dof_lateral_2) = state(dof_lateral_1:dof_lateral_2) + by*n
      state(dof_slope_1:dof_slope_2) = state(dof_slope_1:dof_slope_2) + turn*n
   end subroutine move_node
end module dg_gap_depths
