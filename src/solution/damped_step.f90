!> One step of damped Newton, and what lagged friction does to it.
module dg_damped_step
   use dg_kinds, only: wp
   use dg_assembly, only: add_friction, load_type
   use dg_block_matrix, only: copy_matrix
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   use dg_linear_solver, only: solve_linear, solver_block
   use dg_mesh, only: mesh_type
   use dg_newton, only: newton_type
   use dg_turning_step, only: solve_turning
   use dg_viscosity, only: add_viscosity, damped_type, raise_viscosity
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: find_step, flips_friction, drop_friction

contains

   !> Raises viscosity until the energy's tangent is positive definite with it, or with the viscosity `least`, and solves for
   !> newton%step with it; the energy's factors serve where nothing is added to its tangent.
   subroutine find_step(newton, damped, mesh, loads, gaps, least, vertical, friction, state, work, slope, fault)
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: least
      logical, intent(in) :: vertical      !< the string turns about the axis of a vertical hole
      logical, intent(in) :: friction      !< friction's tangent is added, and torque's
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work   !< placed and surveyed at `state`
      real(wp), intent(out) :: slope       !< of the energy along the step, < 0: down [J]
      integer, intent(out) :: fault        !< 0: none; else there is no step
      logical :: factored
      slope = 0.0_wp
      factored = .false.
      if (vertical .or. friction .or. newton%solver%kind /= solver_block) then
         call raise_viscosity(damped%energy, damped%lump, least, damped%viscosity)
      else
         call raise_viscosity(damped%energy, damped%lump, least, damped%viscosity, newton%solver%block, factored)
      end if
      call copy_matrix(damped%energy, newton%matrix)
      if (friction) call add_friction(mesh, loads, gaps, state, work, newton%matrix)
      call add_viscosity(damped, newton%matrix)
      if (vertical) then
         call solve_turning(newton%solver, damped%lump, damped%mode, damped%pull, newton%residual, newton%matrix, damped%trial, &
                            newton%step, fault)
      else
         call solve_linear(newton%solver, newton%matrix, newton%residual, newton%step, fault, factored)
      end if
      if (fault /= 0) return
      slope = sum(newton%step*newton%residual)
      if (.not. abs(slope) < huge(slope)) fault = 1
   end subroutine find_step

   !> Whether a step opens or closes gaps that have lagged friction.
   pure function flips_friction(damped, gaps, work) result(flips)
      type(damped_type), intent(in) :: damped      !< with the gaps' states before the step
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      logical :: flips
      flips = any((damped%states == state_free .neqv. gaps%state == state_free) .and. work%pressing > 0.0_wp)
   end function flips_friction

   !> Takes lagged friction off those gaps: it would come and go with their states as a whole, however short the step, while the
   !> normal force goes to nothing.
   pure subroutine drop_friction(damped, gaps, work)
      type(damped_type), intent(in) :: damped
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(inout) :: work
      where (damped%states == state_free .neqv. gaps%state == state_free) work%pressing = 0.0_wp
   end subroutine drop_friction
end module dg_damped_step
