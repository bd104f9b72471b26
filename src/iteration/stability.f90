!> Stability of an equilibrium: how far it is from being lost. The tangent without friction and torque, the second derivative of an
!> energy, is positive definite where a string is stable.
module dg_stability
   use dg_kinds, only: wp
   use dg_assembly, only: assemble, load_type
   use dg_block_solver, only: block_positive_definite
   use dg_equations, only: equations_type
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_viscosity, only: weigh_compression
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: find_stability_margin

   !> Halvings in the search of the stability margin: to 0.4 %.
   integer, parameter :: margin_halvings = 8

contains

   !> Part by which compression could still grow before the equilibrium is lost [-], no more than 1: the tangent stays positive
   !> definite when nu F^2/(4 EI) is taken off it, and a string on the low side is lost at (1 + nu) F^2/(4 EI) = n/c.
   pure subroutine find_stability_margin(equations, trajectory, mesh, loads, gaps, state, work, margin)
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out) :: margin
      real(wp) :: low, high
      logical :: definite
      integer :: i
      call assemble(trajectory, mesh, loads, gaps, state, .true., work, equations%residual, equations%matrix)
      call weigh_compression(mesh, work, equations%step)
      low = 0.0_wp
      high = 1.0_wp
      margin = high
      call block_positive_definite(equations%matrix, 1.0_wp - (1.0_wp + high)**2, equations%step, definite)
      if (definite) return
      do i = 1, margin_halvings
         margin = 0.5_wp*(low + high)
         call block_positive_definite(equations%matrix, 1.0_wp - (1.0_wp + margin)**2, equations%step, definite)
         if (definite) then
            low = margin
         else
            high = margin
         end if
      end do
      margin = low
   end subroutine find_stability_margin
end module dg_stability
