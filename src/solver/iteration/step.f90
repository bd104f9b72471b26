!> One step of the iteration to equilibrium (dg_equilibrium): the linear problem, and its damping.
module dg_step
   use dg_kinds, only: wp
   use dg_assembly, only: add_unsymmetric_part
   use dg_block_matrix, only: copy_symmetric, keep_symmetric
   use dg_case_result, only: judged_start
   use dg_contact_problem, only: damp_until_definite, solve_problem
   use dg_equations, only: add_gap_rigidity, energy_tangent, find_tangent
   use dg_followed_gaps, only: add_place_forces, add_place_stiffness
   use dg_gap_state, only: state_free
   use dg_held_coils, only: add_holding, find_holding
   use dg_iteration_state, only: energy_slope, equilibrium_type, make_room_to_damp, margin_of, rigid
   use dg_node_moves, only: split_step
   use dg_outcome, only: outcome_open, outcome_singular
   use dg_solution, only: solution_type
   use dg_trajectory, only: trajectory_type
   use dg_damping, only: add_damping, weigh_string
   implicit none
   private
   public :: find_step

contains

   !> Find the step and the contact forces at its end. For a string without damping, equations%matrix holds the whole tangent
   !> on entry. It is damped from the first step that is too long or leads up the energy's slope, and if it cycles. Next to an
   !> equilibrium that slope is ignored, as friction and round-off decide its sign. A string that starts in equilibrium, as
   !> straight in a vertical hole, has no slope, and is damped.
   subroutine find_step(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp) :: reach
      logical :: uphill, cycles
      integer :: fault
      associate (equations => solution%equations, mesh => solution%mesh, gaps => solution%gaps, work => solution%work)
         it%problem%closed = gaps%state /= state_free
         if (.not. it%damper%on) then
            call add_gap_rigidity(mesh, it%numerics%gk_min, equations%matrix)
            call solve_problem(it%numerics%tuning%most_settlings, equations, gaps, it%residual%nodal, work%normal, .true., &
                               it%problem, fault)
            if (fault /= 0) then
               it%outcome = outcome_singular
               return
            end if
            call find_reach(it, trajectory, solution, reach)
            uphill = .not. energy_slope(equations, it%problem%load) < 0.0_wp .and. &
                     (it%row%judged == judged_start .or. .not. it%residual%before < it%numerics%tuning%near*equations%force_scale)
            cycles = equations%iterations - it%residual%least_at > it%numerics%tuning%longest_cycle
            if (reach > it%numerics%step_limit .or. uphill .or. cycles) then
               call make_room_to_damp(mesh, it)
               call find_tangent(equations, trajectory, mesh, solution%loads, gaps, solution%state, energy_tangent, work, &
                                 it%residual%nodal)
               call add_place_forces(it%problem%followers, it%residual%nodal)
               call add_place_stiffness(it%problem%followers, .true., .false., equations%matrix)
               call keep_symmetric(equations%matrix, it%damper%energy)
            end if
         end if
         if (it%damper%on) call find_damped_step(it, trajectory, solution, reach)
         if (it%outcome /= outcome_open) return
         it%row%damping = it%damper%factor
         it%row%lateral_step = maxval(abs(it%step%across(1:2, :)))
         it%step%share = 1.0_wp/max(1.0_wp, reach)
         if (.not. it%step%share < 1.0_wp) return
         equations%step = it%step%share*equations%step
      end associate
   end subroutine find_step

   !> Find the step of a damped string. Damping is raised while a node moves too far. It is also raised while gaps with full
   !> wall stiffness do not settle. In a linear problem that is nearly indefinite a gap may pull when closed and be in the wall
   !> when open. Such a problem has no solution, and the string would not move.
   subroutine find_damped_step(it, trajectory, solution, reach)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(out) :: reach           !< of the step
      real(wp) :: margin
      logical :: live          ! friction follows the contact forces within the step
      logical :: settled       ! every gap is open or closed in the linear problem's solution, or walls are soft
      integer :: hold, fault
      associate (equations => solution%equations, mesh => solution%mesh, loads => solution%loads, gaps => solution%gaps, &
                 work => solution%work)
         call weigh_string(it%numerics%tuning, mesh, work, it%wall%soft, it%damper%lump)
         if (it%holder%holding) call find_holding(it%numerics%tuning, it%damper%lump, solution, it%holder)
         it%problem%closed = gaps%state /= state_free
         associate (tuning => it%numerics%tuning)
            margin = 0.0_wp         ! next to an equilibrium that counts as stable no more damping is needed
            if (it%residual%before < tuning%near*equations%force_scale) margin = margin_of(solution)
            live = any(abs(mesh%friction_along) > 0.0_wp) .or. any(mesh%friction_around > 0.0_wp) .or. abs(loads%tob) > 0.0_wp
            do hold = 0, tuning%most_raises
               call damp_until_definite(tuning, it%damper%energy, it%damper%lump, it%problem, margin, it%damper%factor)
               do
                  call copy_symmetric(it%damper%energy, equations%matrix)
                  if (live) then
                     call add_unsymmetric_part(mesh, loads, gaps, solution%state, work, equations%matrix)
                     call add_place_stiffness(it%problem%followers, .false., .true., equations%matrix)
                  end if
                  call add_damping(it%damper%factor, it%damper%lump, equations%matrix)
                  if (it%holder%holding) call add_holding(it%holder, equations%matrix)
                  call add_gap_rigidity(mesh, it%numerics%gk_min, equations%matrix)
                  call solve_problem(tuning%most_settlings, equations, gaps, it%residual%nodal, work%normal, live, it%problem, &
                                     fault)
                  if (fault /= 0) then
                     it%outcome = outcome_singular
                     reach = 0.0_wp
                     return
                  end if
                  if (.not. live .or. energy_slope(equations, it%problem%load) < 0.0_wp) exit
                  live = .false.          ! friction's tangent leads uphill: its forces are held constant
                  it%problem%closed = gaps%state /= state_free
               end do
               call find_reach(it, trajectory, solution, reach)
               settled = it%problem%unsettled == 0 .or. it%wall%growth < rigid
               if ((reach <= it%numerics%step_limit .and. settled) .or. hold == tuning%most_raises) exit
               it%damper%factor = max(it%damper%factor, tuning%damping_start)*tuning%raise_damping
            end do
         end associate
      end associate
   end subroutine find_damped_step

   !> Largest move of a node across the hole by the step, over its clearance [-]. Splits the step into slide and across.
   pure subroutine find_reach(it, trajectory, solution, reach)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(in) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(out) :: reach
      integer :: n
      associate (mesh => solution%mesh)
         reach = 0.0_wp
         do n = 1, mesh%nodes
            call split_step(trajectory, mesh, solution%work, n, solution%equations%step(:, n), it%origin%offset(:, n), &
                            it%step%slide(n), it%step%across(:, n))
            reach = max(reach, norm2(it%step%across(1:2, n))/mesh%clearance(min(n, mesh%elements)))
         end do
      end associate
   end subroutine find_reach
end module dg_step
