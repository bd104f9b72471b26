!> Newton-Raphson iteration to equilibrium with contact forces as unknowns of their own (Eq. 12 with Eqs. 7 and 8).
!>
!> A stiff wall makes contact hard for an iteration, as it turns micrometres into kilonewtons. Here a contact force R does not
!> follow from the depth |f|. Both are unknowns, and meet at equilibrium. A gap is closed where R + rho (|f| - depth(R)) > 0.
!> The stiffness rho softens the wall during the iteration (dg_contact_problem). Residual, tangent and the test of a step
!> depend on R, which changes smoothly.
!>
!> One iteration:
!> 1. The linear problem of dg_contact_problem gives the step and the contact forces at its end. It opens and closes gaps. The
!> stiffness rho grows to the wall's own as gaps settle.
!> 2. A compressed string is damped from the start. Any other string is damped from the first step that is too long or raises
!> the energy. Damping is raised until the energy's tangent is positive definite with it. It is also raised until no node moves
!> by more than the step limit times its clearance. A step that is then still longer than one clearance is scaled to it.
!> 3. The string is moved, and a damped string turns along the round wall. Its nodes are then slid along the hole until its
!> elements have the axial forces of the linear problem. Without that a lateral step s lengthens an element by s^2/(2 L), which
!> EA/L turns into kilonewtons.
!> 4. The step of a damped string is shortened while the energy still rises at its end, with friction forces held constant.
!> Walls press there with the force of the linear problem, and with the softened stiffness on the depth beyond it.
!> 5. A step that still raises the energy, and does not reduce the residual, is refused, and damping is raised.
!> 6. A stable string that keeps moving for longest_quiet iterations, while few of its gaps change, is drifting. From then on
!> friction holds it sideways too (dg_held_coils).
!>
!> At convergence rho is the wall's stiffness. Residual, states (Eqs. 7 and 8) and places (Eq. 2) of the gaps are settled. A
!> damped string is stable and has stopped moving. No element that may still be cut is outside its hole.
module dg_equilibrium
   use dg_kinds, only: wp
   use dg_block_matrix, only: keep_symmetric
   use dg_case_result, only: judged_energy, judged_refused, judged_residual, judged_whole
   use dg_contact_problem, only: is_definite, measure_contacts
   use dg_damping, only: damping_most, ease_damping, weigh_string
   use dg_equations, only: equations_type
   use dg_gap_state, only: state_free
   use dg_gap_survey, only: move_rule_type
   use dg_gap_table, only: keep_gaps, restore_gap_table
   use dg_held_coils, only: holder_type, start_to_hold
   use dg_iteration_state, only: equilibrium_type, go_back, judge_gaps, margin_of, measure, move_gaps, new_equilibrium, &
                                 place_and_survey, rigid
   use dg_line_search, only: search_along
   use dg_mesh, only: is_vertical
   use dg_outcome, only: outcome_converged, outcome_damped, outcome_exhausted, outcome_open, outcome_outside, outcome_stalled, &
                         outcome_stopped
   use dg_outside_hole, only: measure_outside, outside_type
   use dg_solution, only: solution_type
   use dg_step, only: find_step
   use dg_stopping, only: is_stopped
   use dg_trajectory, only: trajectory_type
   implicit none
   private
   public :: equilibrium_type, new_equilibrium, find_equilibrium

contains

   !> Iterate the state and the contact forces of a solution to a stable equilibrium. The result is in it%outcome.
   subroutine find_equilibrium(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      solution%work%separate = .true.
      solution%equations%gaps_taken_back = .false.
      solution%gaps%followed = .false.
      solution%work%held = 0.0_wp
      it%holder = holder_type()
      call keep_gaps(solution%gaps, it%origin%gaps)
      call place_and_survey(trajectory, solution)
      call judge_gaps(it, trajectory, .true., solution)
      call measure_here(it, trajectory, .false., solution)
      do
         call enter_row(it, solution)
         call settle_gaps(it, trajectory, solution)
         if (it%outcome == outcome_open) call judge_progress(it, trajectory, solution)
         if (it%outcome == outcome_open .and. it%damper%on) call judge_drift(it, solution)
         if (it%outcome == outcome_open) call find_step(it, trajectory, solution)
         if (it%outcome /= outcome_open) exit
         call search_along(it, trajectory, solution)
         call judge_step(it, trajectory, solution)
         if (it%damper%factor > damping_most .or. .not. it%residual%before < huge(it%residual%before)) then
            it%outcome = outcome_damped
            exit
         end if
      end do
      call enter_row(it, solution)
      associate (load => it%problem%load(:3, :))
         solution%equations%unbalanced_md = solution%mesh%md(maxloc(maxval(abs(load), dim=1), dim=1))
      end associate
   end subroutine find_equilibrium

   !> Compute residual and tangent at the present state. If the last step began next to an equilibrium, forces are computed
   !> first, without the tangent. Most such states are the last, and need no tangent. For a damped string the tangent is always
   !> computed, as it decides on stability.
   pure subroutine measure_here(it, trajectory, stepped, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      logical, intent(in) :: stepped       !< a step has just been taken
      logical :: forces_first
      forces_first = .not. (it%damper%on .or. it%wall%growth < rigid) .and. &
                     it%residual%before < it%numerics%tuning%near*solution%equations%force_scale
      if (forces_first) then
         call measure(it, trajectory, .true., stepped, solution)
         if (is_within(it, solution%equations, 0.0_wp)) return
      end if
      call measure(it, trajectory, .false., stepped, solution)
      if (it%damper%on) call keep_symmetric(solution%equations%matrix, it%damper%energy)
   end subroutine measure_here

   !> Enter the present row in the history.
   pure subroutine enter_row(it, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      it%row%hookload = solution%work%hookload
      it%row%contacts = count(solution%gaps%state /= state_free)
      it%row%iteration = solution%equations%iterations
      it%row%negative_pivots = solution%equations%solver%negative_pivots
      solution%equations%history(solution%equations%iterations + 1) = it%row
      if (it%residual%before < it%residual%least) then
         it%residual%least = it%residual%before
         it%residual%least_at = solution%equations%iterations
      end if
   end subroutine enter_row

   !> Near an equilibrium: end the run, mark elements to cut, or move gaps. Farther off Newton's steps still change too much for
   !> that.
   subroutine settle_gaps(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      logical :: there, stable, moved
      do while (is_within(it, solution%equations, it%numerics%tuning%nearly))
         there = is_within(it, solution%equations, 0.0_wp)
         if (there .and. it%damper%on) there = it%row%lateral_step <= it%numerics%tuning%still*maxval(solution%mesh%clearance)
         if (there) then
            call judge_stability(it, solution, stable)
            if (.not. stable) return
         end if
         if (it%cut_from < huge(it%cut_from) .and. it%moving%rounds == 0) call find_outside(it, trajectory, solution)
         if (it%outcome == outcome_outside) return
         moved = may_move(it, solution%equations, there)
         if (moved) call move_to_deepest(it, trajectory, there, solution, moved)
         if (moved) cycle
         if (there) it%outcome = outcome_converged
         return
      end do
   end subroutine settle_gaps

   !> Mark the elements outside the hole that may be cut. The run ends if there are any.
   pure subroutine find_outside(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(solution_type), intent(in) :: solution
      type(outside_type) :: outside
      call measure_outside(trajectory, solution%mesh, solution%work, outside, it%outside)
      it%outside = it%outside .and. solution%mesh%length >= it%cut_from
      if (any(it%outside)) it%outcome = outcome_outside
   end subroutine find_outside

   !> Move gaps to where the string is deepest, and measure there. After the last round, restore their places instead.
   subroutine move_to_deepest(it, trajectory, there, solution, moved)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      logical, intent(in) :: there           !< in equilibrium
      logical, intent(out) :: moved          !< true if a gap had to move
      type(move_rule_type) :: rule
      associate (tuning => it%numerics%tuning)
         rule = move_rule_type(least=merge(0.0_wp, tuning%astray, it%moving%rounds < tuning%most_moves), closed=.true., &
                               closely=.true.)
         call keep_gaps(solution%gaps, it%origin%gaps)
         call move_gaps(it, trajectory, rule, solution)
         moved = it%row%moves > 0
         if (.not. moved) return
         if (it%moving%rounds == tuning%most_moves + tuning%more_moves) then      ! moving did not help
            call restore_gaps(it, trajectory, solution)
            return
         end if
         if ((there .or. it%moving%rounds == 0) .and. it%moving%rounds <= tuning%most_moves) then
            it%moving%state = solution%state                   ! an equilibrium, or the place where gaps first touched
            it%moving%force = solution%work%normal
            it%moving%held = solution%work%held
            call keep_gaps(it%origin%gaps, it%moving%gaps)
         end if
         it%moving%rounds = it%moving%rounds + 1
         it%moving%start = solution%equations%iterations
         if (any(abs(solution%gaps%xi - it%origin%gaps%xi) > 0.0_wp)) it%wall%growth = tuning%growth
      end associate
      call judge_gaps(it, trajectory, .false., solution)
      call measure_here(it, trajectory, .false., solution)
   end subroutine move_to_deepest

   !> End a run without progress. Gap places that moved are restored after longest_round iterations without equilibrium, or when
   !> the run ends. The string was in equilibrium before the gaps moved.
   subroutine judge_progress(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      it%outcome = ending(it, solution)
      if (it%moving%rounds == 0 .or. solution%equations%gaps_taken_back .or. it%outcome == outcome_stopped) return
      if (it%outcome /= outcome_open .and. it%moving%rounds > it%numerics%tuning%most_moves) then
         call restore_gaps(it, trajectory, solution)
         if (is_within(it, solution%equations, 0.0_wp)) it%outcome = outcome_converged
      else if (it%outcome == outcome_open .and. &
               solution%equations%iterations >= it%moving%start + it%numerics%tuning%longest_round) then
         call restore_gaps(it, trajectory, solution)
      end if
   end subroutine judge_progress

   !> Begin to hold a string that drifts. If few gaps change, Newton's method finds an equilibrium near a stable string in a few
   !> iterations, if one exists. Attempts after the first begin only when no gap has changed for longer: some strings come to
   !> rest by themselves. Strings with a small residual are not held. Neither are strings in vertical holes,
   !> where every turn about the hole is an equilibrium.
   subroutine judge_drift(it, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      logical :: stable
      if (it%holder%holding .or. is_vertical(solution%mesh)) return
      it%holder%quiet = it%holder%quiet + 1
      associate (tuning => it%numerics%tuning, first => it%row%attempt == 1)
         if (it%row%flips + it%row%moves > merge(tuning%few, 0.0_wp, first)*it%row%contacts .or. it%wall%growth < rigid) &
            it%holder%quiet = 0
         if (it%holder%quiet < merge(1, 2, first)*tuning%longest_quiet .or. &
             it%residual%before < tuning%near*solution%equations%force_scale) return
      end associate
      call judge_stability(it, solution, stable)
      if (.not. stable) return
      call start_to_hold(solution%mesh, it%holder)
      if (it%holder%holding) it%residual%least_at = solution%equations%iterations
   end subroutine judge_drift

   !> Reason why a run without equilibrium ends here; outcome_open if it goes on.
   function ending(it, solution) result(outcome)
      type(equilibrium_type), intent(in) :: it
      type(solution_type), intent(in) :: solution
      integer :: outcome
      outcome = outcome_open
      if (is_stopped(solution%stop)) then
         outcome = outcome_stopped
      else if (solution%equations%iterations >= it%numerics%max_iterations) then
         outcome = outcome_exhausted
      else if (solution%equations%iterations - it%residual%least_at > it%numerics%tuning%longest_stall) then
         outcome = outcome_stalled
      end if
   end function ending

   !> True if gaps may move once more: in the first most_moves rounds, and at equilibrium in more_moves rounds after them. One more
   !> round at equilibrium is the last check.
   pure function may_move(it, equations, there) result(may)
      type(equilibrium_type), intent(in) :: it
      type(equations_type), intent(in) :: equations
      logical, intent(in) :: there           !< in equilibrium
      logical :: may
      associate (tuning => it%numerics%tuning)
         may = it%moving%rounds < tuning%most_moves .or. (there .and. it%moving%rounds <= tuning%most_moves + tuning%more_moves)
         may = may .and. .not. equations%gaps_taken_back
      end associate
   end function may_move

   !> Restore the string before its gaps last moved. From here on no gap moves.
   subroutine restore_gaps(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      solution%state = it%moving%state
      solution%work%normal = it%moving%force
      solution%work%held = it%moving%held
      call restore_gap_table(it%moving%gaps, solution%gaps)
      call restore_gap_table(it%moving%gaps, it%origin%gaps)
      solution%equations%gaps_taken_back = .true.
      it%wall%growth = rigid
      call place_and_survey(trajectory, solution)
      call judge_gaps(it, trajectory, .false., solution)
      it%residual%before = huge(it%residual%before)      ! the iteration goes on from there, and needs the tangent
      call measure_here(it, trajectory, .false., solution)
   end subroutine restore_gaps

   !> True if the string is in equilibrium within `part` of the force scale. The residual and the forces of gaps that opened or
   !> closed count, with walls at their own stiffness.
   pure function is_within(it, equations, part) result(is)
      type(equilibrium_type), intent(in) :: it
      type(equations_type), intent(in) :: equations
      real(wp), intent(in) :: part           !< part of the force scale that is enough if the tolerances are smaller [-]
      logical :: is
      associate (limit => max(it%tolerance, part)*equations%force_scale, residual => it%residual)
         is = .not. it%wall%growth < rigid .and. max(residual%before, residual%flipped) <= limit(1) .and. &
              residual%unbalanced <= limit(2)
      end associate
   end function is_within

   !> Judge the stability of an equilibrium. A string without damping counts as stable.
   subroutine judge_stability(it, solution, stable)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      logical, intent(out) :: stable
      stable = .true.
      if (.not. it%damper%on) return
      call weigh_string(it%numerics%tuning, solution%mesh, solution%work, it%wall%soft, it%damper%lump)
      it%problem%closed = solution%gaps%state /= state_free
      call is_definite(it%damper%energy, it%damper%lump, it%problem, margin_of(solution), stable)
   end subroutine judge_stability

   !> Accept the step if energy or residual decreases; otherwise restore the state and raise the damping.
   subroutine judge_step(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      logical :: taken
      associate (tuning => it%numerics%tuning, damper => it%damper, residual => it%residual)
         taken = .not. damper%on .or. (damper%slope < 0.0_wp .and. damper%slope_after < tuning%refused*abs(damper%slope)) .or. &
                 residual%trial < residual%before
         ! a string that hangs free may start with a residual of round-off, which no step reduces
         if (it%origin%growth < rigid) taken = taken .or. &
            max(residual%before, residual%trial) <= it%tolerance(1)*solution%equations%force_scale
         if (taken) then
            it%row%judged = judged_whole
            if (damper%on) it%row%judged = merge(judged_residual, judged_energy, residual%trial < residual%before)
            call measure_here(it, trajectory, .true., solution)
            call ease_damping(tuning, damper%raised <= tuning%until_definite, damper%factor)
            damper%raised = tuning%until_definite
         else
            it%wall%growth = it%origin%growth
            call go_back(it, trajectory, solution)
            call measure_contacts(solution%mesh, solution%loads, solution%gaps, it%wall%soft*it%wall%growth, solution%work, &
                                  it%problem)
            it%row%flips = 0
            it%row%judged = judged_refused
            damper%factor = max(damper%factor, tuning%damping_start)*damper%raised
            damper%raised = tuning%until_definite*damper%raised
         end if
      end associate
   end subroutine judge_step
end module dg_equilibrium
