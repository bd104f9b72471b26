!> Newton-Raphson iteration to equilibrium with contact forces as unknowns of their own (Eq. 12 with Eqs. 7 and 8).
!>
!> What makes contact hard for an iteration is that a stiff wall turns micrometres into kilonewtons. Here a contact force R does
!> not follow from the depth |f|: both are unknowns, and meet at equilibrium. A gap is closed where R + rho (|f| - depth(R)) > 0,
!> with rho a stiffness that softens the wall on the way (dg_contact_problem). Residual, tangent and the test of a step go by R,
!> which changes smoothly.
!>
!> One iteration:
!>   1. The linear problem of dg_contact_problem gives the step and the contact forces at its end, gaps opened and closed within
!>      it. rho grows to the wall's own as gaps settle.
!>   2. A compressed string is watched from the start, any other from the first step that is too long or raises the energy. The
!>      damping term is raised until the energy's tangent is positive definite with it, and until no node moves by more than the
!>      step limit times its clearance. A step that is then still longer than one clearance is scaled to it.
!>   3. The string is moved, along the wall where it turns about the hole, and slid along the hole until its elements have the
!>      axial forces of the linear problem. Unslid, a lateral step s lengthens an element by s**2/(2 L), which EA/L turns into
!>      kilonewtons.
!>   4. The step of a string that is watched is shortened while the energy still rises at its end, friction's forces held constant.
!>      Walls press there with the force of the linear problem, and with the softened stiffness on the depth beyond it.
!>   5. A step that still raises the energy, and does not lessen the residual, is refused, and damping raised.
!> At convergence rho is the wall's stiffness; residual, states (Eqs. 7 and 8) and places (Eq. 2) of the gaps are settled; a string
!> that is watched is stable and has stopped moving; none stands outside its hole where elements may still be cut.
module dg_equilibrium
   use dg_kinds, only: wp
   use dg_block_matrix, only: keep_symmetric
   use dg_case_result, only: judged_energy, judged_refused, judged_residual, judged_whole
   use dg_contact_problem, only: is_definite, measure_contacts
   use dg_equations, only: equations_type, outcome_converged, outcome_exhausted, outcome_outside, outcome_singular
   use dg_gap_state, only: state_free
   use dg_gap_survey, only: move_rule_type
   use dg_gap_table, only: gap_table_type, keep_gaps, take_gaps_back
   use dg_iteration_state, only: equilibrium_type, go_back, judge_gaps, margin_of, measure, move_gaps, new_equilibrium, &
                                 place_and_survey, rigid
   use dg_line_search, only: search_along
   use dg_mesh, only: mesh_type
   use dg_outside_hole, only: measure_outside, outside_type
   use dg_step, only: find_step
   use dg_stopping, only: is_stopped
   use dg_trajectory, only: trajectory_type
   use dg_viscosity, only: ease_viscosity, viscosity_most, weigh_string
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: equilibrium_type, new_equilibrium, find_equilibrium

contains

   !> Iterates `state` and the contact forces in `work` to a stable equilibrium; it%outcome tells.
   subroutine find_equilibrium(it, equations, trajectory, mesh, gaps, state, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), contiguous, intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: ended
      work%separate = .true.
      equations%gaps_taken_back = .false.
      gaps%followed = .false.
      call keep_gaps(gaps, it%kept)
      call place_and_survey(trajectory, mesh, gaps, state, work)
      call judge_gaps(it, trajectory, mesh, .true., gaps, work)
      call measure_here(it, equations, trajectory, mesh, gaps, state, .false., work)
      do
         call enter_row(it, equations, gaps, work)
         call judge_equilibrium(it, equations, trajectory, mesh, gaps, state, work, ended)
         if (ended) exit
         call find_step(it, equations, trajectory, mesh, gaps, state, work)
         if (it%outcome == outcome_singular) exit
         call search_along(it, equations, trajectory, mesh, gaps, state, work)
         call judge_step(it, equations, trajectory, mesh, gaps, state, work)
         if (it%viscosity > viscosity_most .or. .not. it%before < huge(it%before)) exit
      end do
      call enter_row(it, equations, gaps, work)
      associate (load => it%problem%load(:3, :))
         equations%unbalanced_md = mesh%md(maxloc(maxval(abs(load), dim=1), dim=1))
      end associate
   end subroutine find_equilibrium

   !> Measures the state for good. Where the step before began next to an equilibrium forces are measured alone at first: most such
   !> states are the last, and want no tangent. The stability of a string that is watched is judged by its tangent.
   pure subroutine measure_here(it, equations, trajectory, mesh, gaps, state, stepped, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), contiguous, intent(in) :: state(:, :)
      logical, intent(in) :: stepped       !< a step has just been taken
      type(workspace_type), intent(inout) :: work
      logical :: last
      last = .not. it%watched .and. it%before < it%numerics%tuning%near*equations%force_scale .and. .not. it%growth < rigid
      if (last) then
         call measure(it, equations, trajectory, mesh, gaps, state, .true., stepped, work)
         if (is_within(it, equations, 0.0_wp)) return
      end if
      call measure(it, equations, trajectory, mesh, gaps, state, .false., stepped, work)
      if (it%watched) call keep_symmetric(equations%matrix, it%energy)
   end subroutine measure_here

   !> Enters the present row in the history.
   pure subroutine enter_row(it, equations, gaps, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      it%row%hookload = work%hookload
      it%row%contacts = count(gaps%state /= state_free)
      it%row%iteration = equations%iterations
      it%row%negative_pivots = equations%solver%negative_pivots
      equations%history(equations%iterations + 1) = it%row
      if (it%before < it%least) then
         it%least = it%before
         it%least_at = equations%iterations
      end if
   end subroutine enter_row

   !> Whether the run has ended: in equilibrium, stable, with no gap that wants another place; there, but outside the hole; or with
   !> its iterations used up. Elements are cut and gaps are moved when the equilibrium is near: what Newton's last steps change is
   !> too little for either. Gaps that moved and find no equilibrium, or stay far off for all that, are taken back.
   subroutine judge_equilibrium(it, equations, trajectory, mesh, gaps, state, work, ended)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), contiguous, intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical, intent(out) :: ended
      type(outside_type) :: outside
      type(move_rule_type) :: rule
      logical :: there, stable
      ended = .false.
      rule = move_rule_type(closed=.true., closely=.true.)
      do while (is_within(it, equations, it%numerics%tuning%nearly))
         there = is_within(it, equations, 0.0_wp)
         if (there .and. it%watched) there = it%row%lateral_step <= it%numerics%tuning%still*maxval(mesh%clearance)
         if (there) then
            call judge_stability(it, mesh, gaps, work, stable)
            if (.not. stable) exit
         end if
         if (it%cut_from < huge(it%cut_from) .and. it%rounds == 0) then
            call measure_outside(trajectory, mesh, work, outside, it%outside)
            it%outside = it%outside .and. mesh%length >= it%cut_from
            if (any(it%outside)) then
               it%outcome = outcome_outside
               ended = .true.
               return
            end if
         end if
         if (may_move(it, there)) then
            call keep_gaps(gaps, it%kept)
            rule%least = merge(0.0_wp, it%numerics%tuning%astray, it%rounds < it%numerics%tuning%most_moves)
            call move_gaps(it, trajectory, mesh, rule, gaps, work)
            if (it%row%moves > 0) then
               if (it%rounds == it%numerics%tuning%most_moves + it%numerics%tuning%more_moves) then      ! it did not help
                  call take_back(it, equations, trajectory, mesh, gaps, state, work)
                  cycle
               end if
               if ((there .or. it%rounds == 0) .and. it%rounds <= it%numerics%tuning%most_moves) then
                  it%settled = state                   ! an equilibrium, or where gaps first touched
                  it%settled_force = work%normal
                  call keep_gaps(it%kept, it%settled_gaps)
               end if
               it%rounds = it%rounds + 1
               it%round_start = equations%iterations
               if (any(abs(gaps%xi - it%kept%xi) > 0.0_wp)) it%growth = it%numerics%tuning%growth
               call judge_gaps(it, trajectory, mesh, .false., gaps, work)
               call measure_here(it, equations, trajectory, mesh, gaps, state, .false., work)
               cycle
            end if
         end if
         if (.not. there) exit
         it%outcome = outcome_converged
         ended = .true.
         return
      end do
      ended = equations%iterations >= it%numerics%max_iterations .or. is_stopped(it%stop) .or. &
              equations%iterations - it%least_at > it%numerics%tuning%longest_stall
      if (it%rounds > 0 .and. .not. equations%gaps_taken_back) then
         if (ended .and. it%rounds > it%numerics%tuning%most_moves .and. .not. is_stopped(it%stop)) then
            ! it was in equilibrium before these
            call take_back(it, equations, trajectory, mesh, gaps, state, work)
            if (is_within(it, equations, 0.0_wp)) then
               it%outcome = outcome_converged
               return
            end if
         else if (equations%iterations >= it%round_start + it%numerics%tuning%longest_round) then
            call take_back(it, equations, trajectory, mesh, gaps, state, work)
         end if
      end if
      if (ended) it%outcome = outcome_exhausted
   end subroutine judge_equilibrium

   !> Whether gaps may move once more, or are looked at for the last time: after more_moves rounds, at equilibrium.
   pure function may_move(it, there) result(may)
      type(equilibrium_type), intent(in) :: it
      logical, intent(in) :: there           !< in equilibrium
      logical :: may
      associate (tuning => it%numerics%tuning)
         may = it%rounds < tuning%most_moves .or. (there .and. it%rounds <= tuning%most_moves + tuning%more_moves)
      end associate
   end function may_move

   !> Back to where the string was before its gaps last moved; from here on none moves.
   subroutine take_back(it, equations, trajectory, mesh, gaps, state, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), contiguous, intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      state = it%settled
      work%normal = it%settled_force
      call take_gaps_back(it%settled_gaps, gaps)
      call take_gaps_back(it%settled_gaps, it%kept)
      equations%gaps_taken_back = .true.
      it%rounds = huge(it%rounds)
      it%growth = rigid
      call place_and_survey(trajectory, mesh, gaps, state, work)
      call judge_gaps(it, trajectory, mesh, .false., gaps, work)
      it%before = huge(it%before)      ! the iteration goes on from there, and wants the tangent
      call measure_here(it, equations, trajectory, mesh, gaps, state, .false., work)
   end subroutine take_back

   !> Whether an equilibrium is so near: by the residual and the forces of gaps that opened or closed, walls at their own stiffness.
   pure function is_within(it, equations, part) result(is)
      type(equilibrium_type), intent(in) :: it
      type(equations_type), intent(in) :: equations
      real(wp), intent(in) :: part           !< of the force scale that will do, where the tolerances ask for less [-]
      logical :: is
      is = .not. it%growth < rigid .and. max(it%before, it%flipped) <= max(it%tolerance(1), part)*equations%force_scale .and. &
           it%unbalanced <= max(it%tolerance(2), part)*equations%force_scale
   end function is_within

   !> Whether the equilibrium is stable, as far as that is watched.
   subroutine judge_stability(it, mesh, gaps, work, stable)
      type(equilibrium_type), intent(inout) :: it
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(inout) :: work
      logical, intent(out) :: stable
      stable = .true.
      if (.not. it%watched) return
      call weigh_string(it%numerics%tuning, mesh, work, it%soft, it%lump)
      it%problem%closed = gaps%state /= state_free
      call is_definite(it%energy, it%lump, it%problem, margin_of(it, mesh), stable)
   end subroutine judge_stability

   !> Takes the step for good where it leads down the energy, or leaves less residual; else goes back and raises viscosity.
   subroutine judge_step(it, equations, trajectory, mesh, gaps, state, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), contiguous, intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: taken
      associate (tuning => it%numerics%tuning)
         taken = .not. it%watched .or. (it%slope < 0.0_wp .and. it%slope_after < tuning%refused*abs(it%slope)) .or. &
                 it%trial < it%before
         ! a string that hangs free may start with no residual but round-off, which no step makes less
         if (it%old_growth < rigid) taken = taken .or. max(it%before, it%trial) <= it%tolerance(1)*equations%force_scale
         if (taken) then
            it%row%judged = judged_whole
            if (it%watched) it%row%judged = merge(judged_residual, judged_energy, it%trial < it%before)
            call measure_here(it, equations, trajectory, mesh, gaps, state, .true., work)
            call ease_viscosity(tuning, it%raised <= tuning%until_definite, it%viscosity)
            it%raised = tuning%until_definite
         else
            it%growth = it%old_growth
            call go_back(it, trajectory, mesh, gaps, state, work)
            call measure_contacts(mesh, it%loads, gaps, it%soft*it%growth, work, it%problem)
            it%row%flips = 0
            it%row%judged = judged_refused
            it%viscosity = max(it%viscosity, tuning%viscosity_start)*it%raised
            it%raised = tuning%until_definite*it%raised
         end if
      end associate
   end subroutine judge_step
end module dg_equilibrium
