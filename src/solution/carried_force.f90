!> Contact forces as a step's linear equations had them.
!>
!> A string that slides along a round wall by a step leaves that wall, or goes into it, by the step squared over the diameter of its
!> orbit: parts of a micrometre, which a stiff wall answers with kilonewtons. In the residual that is right, and the next step
!> takes it away. In the tangent it is not: there the contact force is what holds the string in its place on the wall, R/|f| across
!> it, and a snake whose stiffness along the wall goes up and down with every step runs zigzag for a hundred of them.
!>
!> So the tangent carries the contact force that the step was to lead to, R + Gk n.dr with all taken before the step; residual,
!> answer, and the tangent at rest are what they were. Magisano, Leonetti and Garcea (2017, Comput. Methods Appl. Mech. Eng. 313,
!> 986: mixed integration points) do so with the stresses of slender beams and shells. With axial forces, which are theirs, it
!> gained nothing here: the stiff thing about a string in a hole is the wall.
module dg_carried_force
   use dg_kinds, only: wp
   use dg_director, only: director_gradient
   use dg_gap_state, only: contact_force, state_free
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_value
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_axial, dof_lateral_2, dof_slope_1, dof_slope_2, nothing_carried, workspace_type
   implicit none
   private
   public :: carry_contact_forces

contains

   !> Contact forces work%carried(e) [N] for the tangent after `step`; `state` is that before it, placed and surveyed in `work`.
   !> A gap that was open, or that the step was to open, has none: there the tangent goes by what it finds.
   pure subroutine carry_contact_forces(mesh, gaps, state, step, work)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :), step(:, :)   !< (6,nodes)
      type(workspace_type), intent(inout) :: work
      real(wp) :: move(3, 2), turn(3, 2), shape(4), outwards, force, stiffness
      integer :: e
      move(:, 2) = moved(mesh, step, 1)
      turn(:, 2) = turned(mesh, state, step, work, 1)
      do e = 1, mesh%elements
         move(:, 1) = move(:, 2)
         turn(:, 1) = turn(:, 2)
         move(:, 2) = moved(mesh, step, e + 1)
         turn(:, 2) = turned(mesh, state, step, work, e + 1)
         work%carried(e) = nothing_carried
         if (gaps%state(e) == state_free) cycle
         shape = hermite_value(gaps%xi(e), mesh%length(e))
         outwards = sum(work%gap(:, e)*(shape(1)*move(:, 1) + shape(2)*turn(:, 1) + shape(3)*move(:, 2) + shape(4)*turn(:, 2))) &
                    /work%displacement(e)
         call contact_force(gaps%law(e), gaps%state(e), work%displacement(e) + outwards, force, stiffness)
         if (force > 0.0_wp) work%carried(e) = force
      end do
   end subroutine carry_contact_forces

   !> Change of a node's place to first order [m].
   pure function moved(mesh, step, node) result(change)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: step(:, :)
      integer, intent(in) :: node
      real(wp) :: change(3)
      change = matmul(mesh%frame(:, :, node), step(dof_axial:dof_lateral_2, node))
   end function moved

   !> Change of a node's director to first order [-].
   pure function turned(mesh, state, step, work, node) result(change)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: state(:, :), step(:, :)
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: node
      real(wp) :: change(3)
      change = matmul(director_gradient(mesh%frame(:, :, node), state(dof_slope_1:dof_slope_2, node), work%d(:, node)), &
                      step(dof_slope_1:dof_slope_2, node))
   end function turned
end module dg_carried_force
