!> Stability of an equilibrium: whether the tangent without friction and torque, the second derivative of an energy, is positive
!> definite there; how far from being lost it is; the mode in which it is left.
module dg_stability
   use dg_kinds, only: wp
   use dg_assembly, only: assemble, load_type
   use dg_block_solver, only: block_positive_definite
   use dg_gap_survey, only: node_offset
   use dg_gap_table, only: gap_table_type
   use dg_linear_solver, only: solve_linear
   use dg_mesh, only: mesh_type
   use dg_newton, only: newton_type
   use dg_trajectory, only: trajectory_type
   use dg_viscosity, only: add_viscosity, damped_type, raise_viscosity, weigh
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, nothing_carried, workspace_type
   implicit none
   private
   public :: is_stable, margin_of, find_stability_margin, push_off

   !> An equilibrium counts as stable that needs no more viscosity than this: F would have to drop by half of it, 0.5 %.
   real(wp), parameter :: stability_margin = 1.0e-2_wp
   !> The same of a string under torque, which friction and the end's part of torque, neither of them in the energy, turn out of its
   !> minimum and hold there: F would have to drop by 10 %.
   real(wp), parameter :: rotating_margin = 0.2_wp
   !> Rounds of inverse iteration for the mode that grows: it need not be exact.
   integer, parameter :: mode_rounds = 4
   !> Halvings in the search of the stability margin: to 0.4 %.
   integer, parameter :: margin_halvings = 8

contains

   !> Whether the equilibrium at which `work` has been placed and surveyed is stable: the energy's tangent, left in Newton's
   !> matrix, is positive definite but for the margin. Viscosity's weights stand in the room of Newton's step.
   subroutine is_stable(newton, trajectory, mesh, loads, gaps, state, work, stable)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical, intent(out) :: stable
      work%carried = nothing_carried
      call assemble(trajectory, mesh, loads, gaps, state, .true., work, newton%residual, newton%matrix)
      call weigh(mesh, work, newton%step)
      call block_positive_definite(newton%matrix, margin_of(mesh, loads), newton%step, stable)
   end subroutine is_stable

   !> Viscosity that an equilibrium may need and still count as stable [-].
   pure function margin_of(mesh, loads) result(margin)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      real(wp) :: margin
      margin = merge(rotating_margin, stability_margin, any(mesh%rotary > 0.0_wp) .or. abs(loads%tob) > 0.0_wp)
   end function margin_of

   !> Moves an equilibrium that `is_stable` has just found unstable along the mode that grows, off the wall, by the part
   !> `size` of the clearance. The mode is that of the least eigenvalue of the energy's tangent over the viscosity's weights,
   !> by inverse iteration.
   subroutine push_off(newton, damped, trajectory, mesh, size, state, work, fault)
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: size             !< [-]
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      integer, intent(out) :: fault
      real(wp) :: gap(3), tangent(3), largest, lateral, sense
      integer :: round, n
      damped%energy = newton%matrix
      call weigh(mesh, work, damped%lump)
      damped%viscosity = 0.0_wp
      call raise_viscosity(damped%energy, damped%lump, 0.0_wp, damped%viscosity)
      newton%step = 0.0_wp
      do n = 1, mesh%nodes      ! anything but a mode
         newton%step(dof_lateral_1:dof_lateral_2, n) = [cos(real(n**2, wp)), sin(real(n**2, wp))]
      end do
      do round = 1, mode_rounds
         newton%matrix%diagonal = damped%energy%diagonal
         newton%matrix%upper = damped%energy%upper
         newton%matrix%lower = damped%energy%lower
         call add_viscosity(damped, newton%matrix)
         newton%residual = -damped%lump*newton%step
         call solve_linear(newton%solver, newton%matrix, newton%residual, newton%step, fault)
         if (fault /= 0) return
         newton%step = newton%step/maxval(abs(newton%step(dof_lateral_1:dof_lateral_2, :)))
      end do
      largest = 0.0_wp
      sense = 1.0_wp
      do n = 1, mesh%nodes
         lateral = norm2(newton%step(dof_lateral_1:dof_lateral_2, n))
         if (lateral <= largest) cycle
         largest = lateral
         call node_offset(trajectory, mesh, work, n, gap, tangent)
         sense = -sign(size*mesh%clearance(min(n, mesh%elements))/lateral, dot_product(gap, &
                       newton%step(dof_lateral_1, n)*mesh%frame(:, 2, n) + newton%step(dof_lateral_2, n)*mesh%frame(:, 3, n)))
      end do
      state = state + sense*newton%step
   end subroutine push_off

   !> Part by which compression could still grow before the equilibrium is lost [-], no more than 1: the tangent stays positive
   !> definite when nu F^2/(4 EI) is taken off it, and a string on the low side is lost at (1 + nu) F^2/(4 EI) = n/c.
   subroutine find_stability_margin(newton, trajectory, mesh, loads, gaps, state, work, known, margin)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical, intent(in) :: known         !< `is_stable` has left the energy's tangent there in Newton's matrix
      real(wp), intent(out) :: margin
      real(wp) :: low, high
      logical :: definite
      integer :: i
      if (.not. known) call assemble(trajectory, mesh, loads, gaps, state, .true., work, newton%residual, newton%matrix)
      call weigh(mesh, work, newton%step)
      low = 0.0_wp
      high = 1.0_wp
      margin = high
      call block_positive_definite(newton%matrix, 1.0_wp - (1.0_wp + high)**2, newton%step, definite)
      if (definite) return
      do i = 1, margin_halvings
         margin = 0.5_wp*(low + high)
         call block_positive_definite(newton%matrix, 1.0_wp - (1.0_wp + margin)**2, newton%step, definite)
         if (definite) then
            low = margin
         else
            high = margin
         end if
      end do
      margin = low
   end subroutine find_stability_margin
end module dg_stability
