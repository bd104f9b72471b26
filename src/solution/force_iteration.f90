!> Newton-Raphson iteration to equilibrium with contact forces as unknowns of their own, for strings of which plain Newton and
!> damped Newton find none.
!>
!> What makes contact hard for an iteration is that a stiff wall turns micrometres into kilonewtons. Here a contact force R does
!> not follow from the depth |f|: both are unknowns, and meet at equilibrium, R + rho (|f| - depth(R)) > 0 deciding whether a gap
!> is closed. Residual, tangent and the test of a step go by R, which changes smoothly.
!>
!> One iteration:
!>   1. The linear problem of dg_contact_problem gives the step and the contact forces at its end, gaps opened and closed within
!>      it. rho grows from that of a wall that yields by a tenth of the clearance to the wall's own as gaps settle.
!>   2. Viscosity is raised until the energy's tangent is positive definite with it where the string is compressed, and until no
!>      node moves by more than its own clearance.
!>   3. The step is shortened until the slope along it of the energy, friction's forces frozen, is no longer uphill. Walls press
!>      there with the force of the linear problem, and softly on what is off it.
!>   4. A step that leads uphill for all that is refused, and viscosity raised.
!> At convergence rho is the wall's stiffness: the residual is that of dg_newton. Then gaps may move (Eq. 2), as there.
module dg_force_iteration
   use dg_kinds, only: wp
   use dg_block_matrix, only: swap_matrices
   use dg_contact_problem, only: is_definite, measure_contacts
   use dg_force_step, only: find_step, force_iteration_type, go_back, look, measure, move_gaps, new_force_iteration, rigid, &
                            search_along, stiff
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type, keep_gaps, take_gaps_back
   use dg_interruption, only: is_interrupted
   use dg_mesh, only: mesh_type
   use dg_newton, only: longest_round, most_rounds, newton_converged, newton_exhausted, newton_singular, newton_type
   use dg_trajectory, only: trajectory_type
   use dg_viscosity, only: damped_type, ease_viscosity, until_definite, viscosity_most, viscosity_start, weigh_all
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: force_iteration_type, new_force_iteration, iterate_forces

   !> A slope at a step's end over that at its start by which the step is refused [-].
   real(wp), parameter :: refused = 0.6_wp
   !> Viscosity that a compressed equilibrium may need and still count as stable [-].
   real(wp), parameter :: stable = 0.02_wp

contains

   !> Iterates `state` and the contact forces in `work` to a stable equilibrium; it%outcome tells.
   subroutine iterate_forces(it, newton, damped, trajectory, mesh, gaps, state, work)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: ended
      damped%viscosity = 0.0_wp
      damped%drive = 0.0_wp
      it%round_start = newton%iterations
      work%separate = .true.
      call keep_gaps(gaps, it%kept)
      call look(it, trajectory, mesh, .true., gaps, state, work)
      call measure(it, trajectory, mesh, gaps, state, work, damped%energy, it%before)
      do
         call enter_row(it, newton, gaps, work)
         call judge_rest(it, newton, damped, trajectory, mesh, gaps, state, work, ended)
         if (ended) exit
         call find_step(it, newton, damped, mesh, gaps, state, work)
         if (it%outcome == newton_singular) exit
         call search_along(it, newton, trajectory, mesh, gaps, state, work)
         call judge_step(it, newton, damped, trajectory, mesh, gaps, state, work)
         if (damped%viscosity > viscosity_most) exit
      end do
      call enter_row(it, newton, gaps, work)
      work%separate = .false.
   end subroutine iterate_forces

   !> Enters the present row in the history.
   subroutine enter_row(it, newton, gaps, work)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(inout) :: newton
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      it%row%hookload = work%hookload
      it%row%contacts = count(gaps%state /= state_free)
      it%row%iteration = newton%iterations
      newton%history(newton%iterations + 1) = it%row
   end subroutine enter_row

   !> Whether the run has ended: at rest, stable, with no gap that wants another place; or with its iterations used up. Gaps that
   !> moved and find no rest are taken back.
   subroutine judge_rest(it, newton, damped, trajectory, mesh, gaps, state, work, ended)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical, intent(out) :: ended
      logical :: definite
      ended = .false.
      do while (it%growth >= stiff .and. it%before <= it%tolerance*newton%force_scale .and. it%row%flips == 0)
         definite = .true.
         if (it%watched) then
            call weigh_all(mesh, work, it%soft, damped%lump)
            it%problem%closed = gaps%state /= state_free
            call is_definite(damped, it%problem, stable, newton%matrix, definite)
         end if
         if (.not. definite) exit
         if (it%rounds < most_rounds) then
            it%rounds = it%rounds + 1
            it%round_start = newton%iterations
            it%rest = state
            it%rest_force = work%normal
            call keep_gaps(gaps, it%rest_gaps)
            call keep_gaps(gaps, it%kept)
            call move_gaps(it, trajectory, mesh, .true., it%loads%bit_support > 0.0_wp, gaps, work)
            if (it%row%moves > 0) then
               call look(it, trajectory, mesh, .false., gaps, state, work)
               call measure(it, trajectory, mesh, gaps, state, work, damped%energy, it%before)
               cycle
            end if
         end if
         it%outcome = newton_converged
         ended = .true.
         return
      end do
      if (it%rounds > 0 .and. .not. newton%gaps_taken_back .and. newton%iterations >= it%round_start + longest_round) then
         state = it%rest
         work%normal = it%rest_force
         call take_gaps_back(it%rest_gaps, gaps)
         call take_gaps_back(it%rest_gaps, it%kept)
         newton%gaps_taken_back = .true.
         it%rounds = most_rounds
         it%growth = rigid
         call look(it, trajectory, mesh, .false., gaps, state, work)
         call measure(it, trajectory, mesh, gaps, state, work, damped%energy, it%before)
      end if
      ended = newton%iterations >= it%numerics%max_iterations .or. is_interrupted()
      if (ended) it%outcome = newton_exhausted
   end subroutine judge_rest

   !> Takes the step for good where it leads down the energy, or leaves less residual; else goes back and raises viscosity.
   subroutine judge_step(it, newton, damped, trajectory, mesh, gaps, state, work)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: residual(6, mesh%nodes), after
      residual = it%residual
      call measure(it, trajectory, mesh, gaps, state, work, newton%matrix, after)
      if (.not. it%watched .or. (it%slope < 0.0_wp .and. it%slope_after < refused*abs(it%slope)) .or. after < it%before) then
         call swap_matrices(newton%matrix, damped%energy)
         it%before = after
         call ease_viscosity(it%raised <= until_definite, damped%viscosity)
         it%raised = until_definite
      else
         it%growth = it%old_growth
         it%residual = residual
         call go_back(it, trajectory, mesh, gaps, state, work)
         call measure_contacts(mesh, it%loads, gaps, state, it%soft*it%growth, work, it%problem)
         it%row%flips = 0
         damped%viscosity = max(damped%viscosity, viscosity_start)*it%raised
         it%raised = until_definite*it%raised
      end if
   end subroutine judge_step
end module dg_force_iteration
