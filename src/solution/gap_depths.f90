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
   use dg_gap_survey, only: survey_gap
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_value
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, place_node, workspace_type
   implicit none
   private
   public :: depths_type, new_depths, depths_after, depth_of, put_gaps, close_gently, keep_forces

   !> Rounds until gaps are where they are to be, each squaring what is missing over the clearance; changes so small are the
   !> last [m].
   integer, parameter :: most_rounds = 4
   real(wp), parameter :: small_change = 1.0e-7_wp
   !> Changes that are none [m]: a round goes on only where the one before has moved a gap by more.
   real(wp), parameter :: no_change = 1.0e-14_wp
   !> Part of themselves by which equations are made regular where two gaps stand at one node [-].
   real(wp), parameter :: regular = 1.0e-9_wp

   !> Depths, by element, and the room to put gaps there.
   type :: depths_type
      real(wp), allocatable :: wanted(:)      !< |f| that closed gaps are to have, 0 for others [m]
      real(wp), allocatable :: row(:, :)      !< what a gap moves by its two nodes' places, and slopes times length (4,e) [-]
      real(wp), allocatable :: outward(:, :)  !< which way it bears (3,e)
      real(wp), allocatable :: pivot(:)       !< of the equations
      real(wp), allocatable :: coupling(:)    !< of a gap with that above, over the pivot there
      real(wp), allocatable :: push(:)        !< by which a gap moves its nodes [m]
   end type depths_type

contains

   !> Room for so many elements.
   pure subroutine new_depths(elements, depth)
      integer, intent(in) :: elements
      type(depths_type), intent(out) :: depth
      allocate (depth%wanted(elements), depth%pivot(elements), depth%coupling(elements), depth%push(elements), source=0.0_wp)
      allocate (depth%row(4, elements), depth%outward(3, elements), source=0.0_wp)
   end subroutine new_depths

   !> |f| [m] that a step(6,nodes) gives the gaps to first order, from where `work` has them; 0 for open ones.
   pure subroutine depths_after(mesh, gaps, step, work, depth)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: step(:, :)
      type(workspace_type), intent(in) :: work
      type(depths_type), intent(inout) :: depth
      real(wp) :: shape(4), move(3)
      integer :: e
      do e = 1, mesh%elements
         depth%wanted(e) = 0.0_wp
         if (gaps%state(e) == state_free) cycle
         shape = hermite_value(gaps%xi(e), mesh%length(e))
         move = matmul(mesh%frame(:, 2:3, e), shape(1)*step(dof_lateral_1:dof_lateral_2, e) &
                       + shape(2)*step(dof_slope_1:dof_slope_2, e)) &
                + matmul(mesh%frame(:, 2:3, e + 1), shape(3)*step(dof_lateral_1:dof_lateral_2, e + 1) &
                         + shape(4)*step(dof_slope_1:dof_slope_2, e + 1))
         depth%wanted(e) = work%displacement(e) + dot_product(work%gap(:, e), move)/work%displacement(e)
      end do
   end subroutine depths_after

   !> Puts gaps that have just closed, which have no depth yet, to where they touch.
   pure subroutine close_gently(trajectory, mesh, gaps, depth, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      type(depths_type), intent(inout) :: depth
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: closing
      integer :: e
      closing = .false.
      do e = 1, mesh%elements
         if (gaps%state(e) == state_free) then
            depth%wanted(e) = 0.0_wp
         else if (.not. depth%wanted(e) > 0.0_wp) then
            depth%wanted(e) = gaps%law(e)%clearance
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
      type(depths_type), intent(inout) :: depth
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work     !< with the forces of the last assembly
      integer :: e
      do e = 1, mesh%elements
         depth%wanted(e) = 0.0_wp
         if (gaps%state(e) /= state_free) depth%wanted(e) = depth_of(gaps%law(e), work%normal(e))
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

   !> Moves the nodes of `state`, but the lateral places of the ends, so that each gap with a depth wanted has |f| = depth, by the
   !> least sum of squares of lateral changes and of slopes' times length; those gaps are then in the state that belongs to their
   !> depth. Each gap bears on two nodes: the equations are tridiagonal.
   pure subroutine put_gaps(trajectory, mesh, gaps, depth, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      type(depths_type), intent(inout) :: depth
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work   !< placed and surveyed at `state`, before and after
      integer :: e, round
      do e = 1, mesh%elements
         depth%row(:, e) = 0.0_wp
         if (.not. depth%wanted(e) > 0.0_wp) cycle
         depth%row(:, e) = hermite_value(gaps%xi(e), mesh%length(e))/[1.0_wp, bent(mesh, e), 1.0_wp, bent(mesh, e + 1)]
         if (e == 1) depth%row(1, e) = 0.0_wp
         if (e == mesh%elements) depth%row(3, e) = 0.0_wp
         gaps%state(e) = merge(state_rigid, state_elastic, &
                               depth%wanted(e) > gaps%law(e)%clearance*(1.0_wp + gaps%law(e)%eps_nmax))
      end do
      do round = 1, most_rounds
         call find_pushes(work, depth)
         if (.not. any(abs(depth%push) > 0.0_wp)) return
         call move_nodes(trajectory, mesh, gaps, depth, state, work)
         if (maxval(abs(depth%push)) < small_change) return
      end do
   end subroutine put_gaps

   !> What gaps push their nodes by.
   pure subroutine find_pushes(work, depth)
      type(workspace_type), intent(in) :: work
      type(depths_type), intent(inout) :: depth
      integer :: e, before
      do e = 1, size(depth%push)
         depth%push(e) = 0.0_wp
         depth%pivot(e) = 1.0_wp
         depth%coupling(e) = 0.0_wp
         if (.not. depth%wanted(e) > 0.0_wp) cycle
         depth%outward(:, e) = work%gap(:, e)/work%displacement(e)
         depth%push(e) = depth%wanted(e) - work%displacement(e)
         depth%pivot(e) = sum(depth%row(:, e)**2)*(1.0_wp + regular) + regular
         before = e - 1
         if (before < 1) cycle
         if (.not. depth%wanted(before) > 0.0_wp) cycle
         depth%coupling(e) = sum(depth%row(1:2, e)*depth%row(3:4, before)) &
                             *sum(depth%outward(:, e)*depth%outward(:, before))/depth%pivot(before)
         depth%pivot(e) = depth%pivot(e) - depth%coupling(e)**2*depth%pivot(before)
         depth%push(e) = depth%push(e) - depth%coupling(e)*depth%push(before)
      end do
      do e = size(depth%push), 1, -1
         depth%push(e) = depth%push(e)/depth%pivot(e)
         if (e < size(depth%push)) depth%push(e) = depth%push(e) - depth%coupling(e + 1)*depth%push(e + 1)
      end do
      where (abs(depth%push) < no_change) depth%push = 0.0_wp
   end subroutine find_pushes

   !> Moves the nodes that are pushed, and measures what that changes.
   pure subroutine move_nodes(trajectory, mesh, gaps, depth, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(depths_type), intent(in) :: depth
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: push
      integer :: e
      do e = 1, mesh%elements
         push = depth%push(e)
         if (.not. abs(push) > 0.0_wp) cycle
         call move_node(mesh%frame(:, 2:3, e), depth%outward(:, e), push*depth%row(1, e), &
                        push*depth%row(2, e)/bent(mesh, e), state(:, e))
         call move_node(mesh%frame(:, 2:3, e + 1), depth%outward(:, e), push*depth%row(3, e), &
                        push*depth%row(4, e)/bent(mesh, e + 1), state(:, e + 1))
      end do
      do e = 1, mesh%nodes
         if (is_pushed(depth%push, e - 1, e)) call place_node(mesh, state, e, work)
      end do
      do e = 1, mesh%elements
         if (is_pushed(depth%push, e - 1, e + 1)) call survey_gap(trajectory, mesh, gaps%xi(e), e, work)
      end do
   end subroutine move_nodes

   !> Whether any gap from the first to the last pushes.
   pure function is_pushed(push, first, last) result(pushed)
      real(wp), intent(in) :: push(:)
      integer, intent(in) :: first, last     !< as far as there are any
      logical :: pushed
      pushed = any(abs(push(max(first, 1):min(last, size(push)))) > 0.0_wp)
   end function is_pushed

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
