!> Friction and weight on bit with which the weight of a string is just enough, by beams.
!>
!> The soft string has the hook load of beams if its friction is multiplied by a factor. In helically buckled pipe that factor
!> depends on compression: limits by the factor of one solution were up to 25 % too high. So the solved string is taken on from
!> its loads towards the value that the soft string expects. The factor found at a value x leads to a better value y(x). The limit
!> is where y(x) = x, found by the secant method.
module dg_weight_limits
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_end_supports, only: set_loads
   use dg_equilibrium, only: equilibrium_type, find_equilibrium, new_equilibrium
   use dg_fluid_pressure, only: surface_push
   use dg_load_case, only: block_way, rotates
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type, smears_joints
   use dg_numerics, only: numerics_type
   use dg_outcome, only: outcome_converged
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_solution, only: solution_type
   use dg_solution_result, only: begin_again
   use dg_stopping, only: is_stopped
   use dg_trajectory, only: top_md
   use dg_weight_on_bit, only: matching_friction, most_weight_on_bit
   implicit none
   private
   public :: find_weight_limits

   !> Iterations that are spent on one limit: as many as the case has taken, and at least this number.
   integer, parameter :: enough_iterations = 200
   !> Part of the way to a limit that a string takes under growing loads: it may not follow a longer step [-].
   real(wp), parameter :: part_way = 0.5_wp
   !> Distance of a limit from the x that was solved, up to which it is taken, and from y(x), at which it is found [-].
   real(wp), parameter :: near_enough = 0.25_wp, close_enough = 0.03_wp
   !> Friction or load, over that of the case, above which a limit is left to the soft string [-].
   real(wp), parameter :: far = 2.0_wp
   !> Least and greatest change of x - y by x [-].
   real(wp), parameter :: slopes(2) = [0.25_wp, 3.0_wp]

   !> A value of friction over that of the case [-] or of weight on bit [N], and the better one that its solution leads to.
   type :: trial_type
      real(wp) :: x = 0.0_wp, y = 0.0_wp
      real(wp) :: scale = 1.0_wp         !< factor on the friction of the case with which the soft string has that solution [-]
   end type trial_type

contains

   !> Set `result%weight_limits` of a solved string that goes down without turning, where its pipe buckles at the limit. They
   !> stay absent where no limit is near, or the string does not follow. Their iterations are counted apart.
   subroutine find_weight_limits(model, case_index, numerics, solution, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(numerics_type), intent(in) :: numerics    !< of the attempt that led to the solution
      type(solution_type), intent(in) :: solution    !< converged
      type(case_result_type), intent(inout) :: result
      associate (load_case => model%cases(case_index))
         if (block_way(load_case%operation) >= 0 .or. rotates(load_case%operation) .or. top_md(model%trajectory) > 0.0_wp &
             .or. model%hookload%present) return
         call follow(model, case_index, .false., numerics, solution, result, result%weight_limits%friction)
         if (load_case%wob > 0.0_wp) &
            call follow(model, case_index, .true., numerics, solution, result, result%weight_limits%wob)
      end associate
   end subroutine find_weight_limits

   !> Take the string on to its limit of friction or weight on bit.
   subroutine follow(model, case_index, by_wob, numerics, solution, result, limit)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: by_wob                  !< false: by friction
      type(numerics_type), intent(in) :: numerics
      type(solution_type), intent(in) :: solution
      type(case_result_type), intent(inout) :: result
      type(optional_real), intent(inout) :: limit
      type(solution_type) :: here, next
      type(trial_type) :: before, now
      real(wp) :: x
      integer :: most
      logical :: found
      now%x = 1.0_wp
      if (by_wob) now%x = model%cases(case_index)%wob
      call judge(model, case_index, by_wob, solution%work%hookload, now, found)
      if (.not. found) return
      if (now%y > far*now%x) return
      if (.not. can_follow(model, case_index, by_wob, solution%work%hookload, now)) return
      here = solution
      x = now%y
      if (x > now%x) x = now%x + part_way*(x - now%x)
      most = max(result%iterations, enough_iterations)
      do while (most > 0 .and. .not. is_stopped(solution%stop))
         next = here
         call solve_at(model, case_index, by_wob, x, numerics, most, next, found)
         result%weight_limits%iterations = result%weight_limits%iterations + next%equations%iterations
         most = most - max(next%equations%iterations, 1)
         if (.not. found) then
            x = now%x + part_way*(x - now%x)
            cycle
         end if
         before = now
         now%x = x
         call judge(model, case_index, by_wob, next%work%hookload, now, found)
         if (.not. found) return
         here = next
         x = next_value(before, now)
         if (abs(now%x - x) > near_enough*x) cycle
         limit = given(x)
         result%weight_limits%friction_scale = given(now%scale)
         if (abs(now%y - x) <= close_enough*x) return
      end do
   end subroutine follow

   !> Find the value at which string weight is just enough by the soft string with the friction of a solution.
   pure subroutine judge(model, case_index, by_wob, hookload, trial, found)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: by_wob
      real(wp), intent(in) :: hookload           !< of beams at trial%x, without the push of a closed annulus [N]
      type(trial_type), intent(inout) :: trial
      logical, intent(out) :: found
      real(wp) :: wob
      wob = model%cases(case_index)%wob
      if (by_wob) wob = trial%x
      trial%scale = matching_friction(model, case_index, wob, hookload - surface_push(model, case_index))
      found = trial%scale > 0.0_wp
      if (.not. found) return
      if (by_wob) then
         trial%y = most_weight_on_bit(model, case_index, coiled=.true., pushed=.false., friction_scale=trial%scale)
      else
         trial%scale = trial%scale/trial%x
         trial%y = matching_friction(model, case_index, wob, -model%rig%max_push)/trial%scale
      end if
      found = trial%y > 0.0_wp
   end subroutine judge

   !> Solve the string under a friction or weight on bit, from its present state.
   subroutine solve_at(model, case_index, by_wob, x, numerics, most, solution, found)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: by_wob
      real(wp), intent(in) :: x                  !< [- or N]
      type(numerics_type), intent(in) :: numerics
      integer, intent(in) :: most                !< iterations
      type(solution_type), intent(inout) :: solution
      logical, intent(out) :: found
      type(equilibrium_type) :: it
      call set_loads(model, model%cases(case_index), 1.0_wp, solution%loads)
      if (by_wob) then
         solution%loads%wob = solution%loads%wob + x - model%cases(case_index)%wob
      else
         solution%loads%friction_scale = x
      end if
      call begin_again(numerics, (solution%work%normal), solution)
      solution%equations%iterations = 0
      call new_equilibrium(solution, numerics, it)
      it%wall%growth = 1.0_wp
      it%numerics%max_iterations = min(model%numerics%max_iterations, most)
      it%row%attempt = 1
      call find_equilibrium(it, model%trajectory, solution)
      found = it%outcome == outcome_converged
   end subroutine solve_at

   !> Mean of y and of the secant of x - y through two trials, within bounds of its slope. The secant alone goes too far, as
   !> friction of coils grows faster than compression.
   pure function next_value(before, now) result(x)
      type(trial_type), intent(in) :: before, now
      real(wp) :: x
      real(wp) :: slope
      slope = 1.0_wp
      if (abs(now%x - before%x) > close_enough*now%x) &
         slope = ((now%x - now%y) - (before%x - before%y))/(now%x - before%x)
      x = 0.5_wp*(now%y + now%x + (now%y - now%x)/min(max(slope, slopes(1)), slopes(2)))
   end function next_value

   !> True if the soft string sees pipe buckle at a trial's limit, and the solution can be taken there. Smeared joints hold pipe
   !> straight. Coils that were pushed by more than the weight of the string do not go back.
   pure function can_follow(model, case_index, by_wob, hookload, trial) result(can)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: by_wob
      real(wp), intent(in) :: hookload           !< of the solution [N]
      type(trial_type), intent(in) :: trial
      logical :: can
      type(model_type) :: apart
      type(other_loads_type) :: other
      type(soft_totals_type) :: totals
      real(wp) :: axial(1), torque(1)
      apart = model
      apart%numerics%discrete_joints = .true.
      other = other_loads_type(coiled=.true., friction_scale=trial%scale)
      if (by_wob) then
         other%wob = given(trial%y)
      else
         other%friction_scale = trial%scale*trial%y
      end if
      call soft_string_at(apart, case_index, [top_md(model%trajectory)], axial, torque, totals=totals, other=other)
      can = max(totals%coil, totals%bowed) > 0.0_wp .and. hookload + model%rig%max_push > -totals%weight
      if (smears_joints(model, case_index) .and. totals%bowed > 0.0_wp) can = .false.
   end function can_follow
end module dg_weight_limits
