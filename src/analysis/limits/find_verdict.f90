!> Finds the answer to 'can it be done?' for a load case from its result and its limits.
!>
!> The string must go down by its own weight: buoyed weight along the hole - weight on bit - friction = hook load >= 0. A hook
!> load below zero means a push at surface, possible up to `max_push` of the rig. Strengths, slips and rig are in
!> dg_utilisation. If a calibration has found the friction, the limits must also hold at the upper end of its 95 % interval.
module dg_find_verdict
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_casing_wear, only: groove_type
   use dg_contact_friction, only: frictions_met
   use dg_fatigue, only: fatigue_type, hour
   use dg_friction_estimate, only: has_upper_friction, upper_friction_type
   use dg_friction_reserve, only: buckles_by_friction, find_friction_reserve, find_possible_friction, find_shifted
   use dg_fluid_pressure, only: is_hung
   use dg_job, only: model_mcge
   use dg_limit_reach, only: find_limit_reach
   use dg_load_case, only: block_way, load_case_type, moves_axially, rotates
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type, string_index
   use dg_passed_pressure, only: find_passed_pressure, find_pump_pressure
   use dg_string_weight, only: judge_weight
   use dg_upper_friction, only: raise_friction
   use dg_unrated_limits, only: note_unrated
   use dg_utilisation, only: as_much, find_utilisation, limit_count, limit_top_drive, limit_von_mises, utilisation_type
   use dg_verdict, only: answer_no, answer_yes, friction_calibrated, friction_upper_end, friction_upper_end_alone, &
                         limit_casing_wear, limit_fatigue, limit_joint_fatigue, limit_lock_up, limit_string_weight, &
                         limit_wob_yield, limit_worn_casing, limits_by_hours, is_most, note_left_out, note_uncertain, set_name, &
                         verdict_type
   use dg_ways_down, only: find_turning_loads, find_ways_down
   use dg_weight_on_bit, only: locks_up, most_weight_on_bit, weight_that_arrives
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: find_verdict

   !> Number of halvings of an overpull.
   integer, parameter :: halvings = 16

contains

   !> Find the verdict of a result. It is unknown or no if the case has not converged. `whole` is only read if it has.
   pure subroutine find_verdict(model, result, whole, verdict, upper)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(whole_string_type), intent(in) :: whole
      type(verdict_type), intent(out) :: verdict
      type(upper_friction_type), intent(in), optional :: upper   !< of calibrations that are applied
      associate (load_case => model%cases(result%case_index))
         verdict%wob_by_beams = result%weight_limits%wob%present
         verdict%frictions = frictions_met(model%holes, load_case)
         if (result%status == result_locked_up) then
            verdict%answer = answer_no
            verdict%limit = limit_lock_up
            verdict%alone = .true.
            verdict%max_push = model%rig%max_push
            call find_passed_pressure(model, result%case_index, verdict%also, verdict%also_load, verdict%also_allowed, &
                                      verdict%pressures_judged)
            if (block_way(load_case%operation) <= 0) &
               verdict%most_wob = given(weight_that_arrives(model, result))
         else if (result%status == result_converged) then
            verdict%answer = answer_yes
            if (.not. is_hung(model, load_case)) verdict%most_wob = whole%wob_lockup
            verdict%wob_yield = whole%wob_yield
            verdict%buckled_by_formula = result%model /= model_mcge
            verdict%buckled_length = merge(whole%helical_length, whole%coiled_length, verdict%buckled_by_formula)
            call note_unrated(model, result%case_index, verdict%not_checked)
            call judge_strengths(whole%utilisation, verdict)
            call judge_weight(model, result, whole%wob_lockup, verdict)
            if (result%model /= model_mcge) call judge_compressed(load_case, whole, verdict)
            call judge_fatigue(whole%fatigue, limit_fatigue, load_case%hours, verdict)
            call judge_fatigue(whole%joint_fatigue, limit_joint_fatigue, load_case%hours, verdict)
            call judge_casing(whole%groove, load_case%hours, verdict)
            if (cannot_scale(model, result)) then
               verdict%reserve_unknown = verdict%answer == answer_yes
            else if (verdict%answer == answer_yes) then
               call find_friction_reserve(model, result, verdict%friction_reserve, verdict%reserve_limit)
               call take_limit_of_beams(result%weight_limits%friction, verdict)
               if (verdict%friction_reserve%present .and. .not. result%weight_limits%friction%present) &
                  verdict%reserve_buckles = buckles_by_friction(model, result, verdict%friction_reserve%value)
            else if (all(verdict%limit /= limits_by_hours) .and. .not. lacks_weight(load_case, verdict)) then
               call find_possible_friction(model, result, verdict%possible_friction)
            end if
            if (present(upper)) call judge_upper_end(model, result, upper, verdict)
            call note_uncertain(result%unlike_contact%warned, whole%utilisation%used(limit_von_mises)%value, result%coiled, &
                                verdict)
            if (block_way(load_case%operation) < 0) &
               call note_left_out(result%left_out_friction, result%hookload + model%rig%max_push, verdict)
         else
            call judge_bit_torque(model, result%case_index, verdict)
            return
         end if
         if (verdict%answer == answer_no .and. verdict%friction /= friction_upper_end_alone) &
            call judge_without_load(model, model, result, verdict)
         if (lacks_weight(load_case, verdict)) then
            if (verdict%also == 0) call find_turning_loads(model, result%case_index, verdict)
            if (verdict%friction /= friction_upper_end_alone .and. block_way(load_case%operation) <= 0) &
               call find_ways_down(model, result, verdict)
         end if
         if (wants_reach(model, result, verdict)) &
            call find_limit_reach(model, result, whole%utilisation, verdict%reach)
         if (verdict%answer == answer_no .and. verdict%also == 0 .and. verdict%friction /= friction_upper_end_alone .and. &
             all(verdict%passed(limit_count + 1:) <= 1.0_wp)) &
            call find_pump_pressure(model, result, verdict%limit, whole%wob_yield, verdict%pump_pressure, &
                                    verdict%fill)
         if (verdict%part > 0) &
            call set_name(model%strings(string_index(model%strings, load_case%string))%components(verdict%part), verdict)
      end associate
   end subroutine find_verdict

   !> Take the friction with which string weight is just enough by beams as that of a yes, where it is found. Another limit that
   !> is passed with less friction stays.
   pure subroutine take_limit_of_beams(friction, verdict)
      type(optional_real), intent(in) :: friction      !< over that of the case [-]
      type(verdict_type), intent(inout) :: verdict     !< with its friction reserve by the soft string
      if (.not. friction%present) return
      if (verdict%friction_reserve%present .and. all(verdict%reserve_limit /= [limit_string_weight, limit_lock_up]) .and. &
          verdict%friction_reserve%value < friction%value) return
      verdict%friction_reserve = given(max(friction%value, 1.0_wp))
      verdict%reserve_limit = limit_string_weight
   end subroutine take_limit_of_beams

   !> True for beams that turn in helical buckling. Their torque grows with weight on bit and friction much faster than that of
   !> the soft string. Loads of the soft string times a ratio would allow up to three times the possible friction.
   pure function cannot_scale(model, result) result(cannot)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      logical :: cannot
      cannot = result%model == model_mcge .and. result%coiled .and. rotates(model%cases(result%case_index)%operation)
   end function cannot_scale

   !> True for a NO by strengths, slips or rig alone that a shallower bit may mend.
   pure function wants_reach(model, result, verdict) result(wants)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(verdict_type), intent(in) :: verdict
      logical :: wants
      associate (load_case => model%cases(result%case_index))
         wants = verdict%answer == answer_no .and. verdict%limit <= limit_count .and. load_case%wob >= 0.0_wp .and. &
                 verdict%friction /= friction_upper_end_alone .and. .not. is_hung(model, load_case) .and. &
                 .not. cannot_scale(model, result)
      end associate
   end function wants_reach

   !> True for a NO by string weight or lock-up of a string that moves along the hole without turning.
   pure function lacks_weight(load_case, verdict) result(lacks)
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      logical :: lacks
      lacks = verdict%answer == answer_no .and. any(verdict%limit == [limit_lock_up, limit_string_weight]) .and. &
              moves_axially(load_case%operation) .and. .not. rotates(load_case%operation)
   end function lacks_weight

   !> Judge the case once more, with calibrated friction at the upper end of its interval.
   pure subroutine judge_upper_end(model, result, upper, verdict)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(upper_friction_type), intent(in) :: upper
      type(verdict_type), intent(inout) :: verdict
      type(model_type) :: raised
      type(verdict_type) :: at_end
      logical :: judged              ! true if loads at the upper end are known
      if (.not. has_upper_friction(upper, model%cases(result%case_index))) return
      judged = upper%known .and. .not. (verdict%answer == answer_yes .and. cannot_scale(model, result))
      verdict%friction = merge(friction_upper_end, friction_calibrated, judged)
      if (verdict%answer == answer_no .or. .not. judged) return
      raised = model
      call raise_friction(model, result%case_index, upper, raised%holes)
      at_end%friction = friction_upper_end_alone
      at_end%not_checked = verdict%not_checked
      at_end%possible_friction = verdict%friction_reserve
      if (verdict%most_wob%present) &
         at_end%most_wob = given(most_weight_on_bit(raised, result%case_index, coiled=.true., pushed=.false.))
      call judge_other(model, raised, result, at_end)
      if (at_end%answer /= answer_no) return
      verdict = at_end
      call judge_without_load(model, raised, result, verdict)
   end subroutine judge_upper_end

   !> Note the limit that is also passed without weight on bit or overpull, if the case has one of them.
   pure subroutine judge_without_load(model, other_model, result, verdict)
      type(model_type), intent(in) :: model
      type(model_type), intent(in) :: other_model    !< with the friction of the answer
      type(case_result_type), intent(in) :: result   !< of `model`
      type(verdict_type), intent(inout) :: verdict
      type(model_type) :: bare
      type(verdict_type) :: without
      associate (load_case => model%cases(result%case_index))
         if (.not. load_case%wob > 0.0_wp .and. .not. (load_case%wob < 0.0_wp .and. block_way(load_case%operation) > 0)) return
      end associate
      if (is_hung(model, model%cases(result%case_index))) return
      if (result%status /= result_locked_up .and. cannot_scale(model, result)) return
      bare = other_model
      if (model%cases(result%case_index)%wob > 0.0_wp) bare%cases(result%case_index)%tob = 0.0_wp     ! the bit is off bottom
      bare%cases(result%case_index)%wob = 0.0_wp
      if (result%status == result_locked_up) then
         if (locks_up(bare, result%case_index)) verdict%limit_without_load = limit_lock_up
         return
      end if
      without%most_wob = verdict%most_wob
      call judge_other(model, bare, result, without)
      if (without%answer /= answer_no) then
         if (model%cases(result%case_index)%wob < 0.0_wp) &
            call find_most_pull(model, other_model, result, verdict)
         return
      end if
      verdict%limit_without_load = without%limit
      if (without%limit /= limit_lock_up) verdict%excess_without_load = without%load%value - without%allowed%value
   end subroutine judge_without_load

   !> Judge a result with another friction or weight on bit, without fatigue. On entry `verdict` has the largest weight on bit.
   pure subroutine judge_other(model, other_model, result, verdict)
      type(model_type), intent(in) :: model
      type(model_type), intent(in) :: other_model        !< all else equal
      type(case_result_type), intent(in) :: result       !< of `model`, converged
      type(verdict_type), intent(inout) :: verdict
      type(case_result_type) :: other
      type(along_string_type) :: along
      type(utilisation_type) :: utilisation
      logical :: runaway
      verdict%answer = answer_yes
      call find_shifted(model, other_model, result, other, runaway)
      if (runaway) then
         verdict%answer = answer_no
         verdict%limit = limit_lock_up
         return
      end if
      call find_along_string(other_model, other, along)
      call find_utilisation(other_model, other, along, utilisation)
      call judge_strengths(utilisation, verdict)
      call judge_weight(other_model, other, verdict%most_wob, verdict)
   end subroutine judge_other

   !> Judge strengths, slips and rig by the one that is used most.
   pure subroutine judge_strengths(utilisation, verdict)
      type(utilisation_type), intent(in) :: utilisation
      type(verdict_type), intent(inout) :: verdict
      if (utilisation%governing == 0) return
      verdict%passed(:limit_count) = 0.0_wp
      where (utilisation%used%present .and. utilisation%used%value > 1.0_wp + as_much) &
         verdict%passed(:limit_count) = utilisation%used%value
      verdict%limit = utilisation%governing
      verdict%used = utilisation%used(verdict%limit)
      verdict%md = utilisation%md(verdict%limit)
      verdict%part = utilisation%part(verdict%limit)
      if (verdict%used%value > 1.0_wp + as_much) verdict%answer = answer_no
      verdict%load = given(utilisation%load(verdict%limit))
      if (verdict%used%value > 0.0_wp) verdict%allowed = given(verdict%load%value/verdict%used%value)
   end subroutine judge_strengths

   !> Find the largest overpull with which no limit is passed, for a case that is possible without overpull. Bisection.
   pure subroutine find_most_pull(model, other_model, result, verdict)
      type(model_type), intent(in) :: model
      type(model_type), intent(in) :: other_model    !< with the friction of the answer
      type(case_result_type), intent(in) :: result   !< of `model`
      type(verdict_type), intent(inout) :: verdict
      type(model_type) :: less
      type(verdict_type) :: there
      real(wp) :: low, high
      integer :: i
      less = other_model
      low = 0.0_wp
      high = -model%cases(result%case_index)%wob
      verdict%pull_limit = verdict%limit
      do i = 1, halvings
         less%cases(result%case_index)%wob = -0.5_wp*(low + high)
         there = verdict_type()
         call judge_other(model, less, result, there)
         if (there%answer == answer_no) then
            high = 0.5_wp*(low + high)
            verdict%pull_limit = there%limit
         else
            low = 0.5_wp*(low + high)
         end if
      end do
      verdict%most_pull = given(low)
   end subroutine find_most_pull

   !> Judge the yield of compressed pipe by the soft string, whose stresses have no bending of helical buckling. It decides if
   !> it is passed. It also decides if the string is in helical buckling and uses more of it than of other limits.
   pure subroutine judge_compressed(load_case, whole, verdict)
      type(load_case_type), intent(in) :: load_case
      type(whole_string_type), intent(in) :: whole
      type(verdict_type), intent(inout) :: verdict
      real(wp) :: share
      if (.not. whole%wob_yield%present) return
      if (load_case%wob < 0.0_wp .and. .not. whole%helical_length > 0.0_wp) return      ! a pull, no compression by drag
      share = 2.0_wp
      if (whole%wob_yield%value > 0.0_wp) share = load_case%wob/whole%wob_yield%value
      if (share > 1.0_wp) then
         if (verdict%answer == answer_no) return
         verdict%answer = answer_no
      else if (.not. (whole%helical_length > 0.0_wp .and. is_most(share, verdict))) then
         return
      end if
      verdict%limit = limit_wob_yield
      verdict%used = optional_real(whole%wob_yield%value > 0.0_wp, share)
      verdict%load = given(load_case%wob)
      verdict%allowed = whole%wob_yield
      verdict%md%present = .false.
   end subroutine judge_compressed

   !> Judge the hours of rotation until fatigue of pipe or connections. Fatigue counts as checked if the bending has endless life,
   !> or the damage is known.
   pure subroutine judge_fatigue(fatigue, limit, hours, verdict)
      type(fatigue_type), intent(in) :: fatigue
      integer, intent(in) :: limit                  !< of body or connections
      real(wp), intent(in) :: hours                 !< of the case [h]
      type(verdict_type), intent(inout) :: verdict
      if (.not. fatigue%present) return
      verdict%not_checked(limit) = fatigue%used > 1.0_wp .and. is_missing(fatigue%damage)
      if (verdict%not_checked(limit) .and. fatigue%used > verdict%fatigue_used) then
         verdict%fatigue_used = fatigue%used
         verdict%fatigue_md = fatigue%md
      end if
      if (.not. is_missing(fatigue%damage)) call judge_hours(fatigue%damage, fatigue%md, fatigue%part, limit, hours, verdict)
   end subroutine judge_fatigue

   !> Judge the hours of rotation until casing is worn through. The strength of the rest of the wall is not checked.
   pure subroutine judge_casing(groove, hours, verdict)
      type(groove_type), intent(in) :: groove
      real(wp), intent(in) :: hours                 !< of the case [h]
      type(verdict_type), intent(inout) :: verdict
      if (.not. groove%present) return
      verdict%not_checked(limit_worn_casing) = groove%used < 1.0_wp
      call judge_hours(groove%used, groove%md, 0, limit_casing_wear, hours, verdict)
   end subroutine judge_casing

   !> Judge the hours of rotation. They decide if the case uses more of them than of other limits, and no other limit is passed.
   pure subroutine judge_hours(used, md, part, limit, hours, verdict)
      real(wp), intent(in) :: used                  !< part of the hours until failure [-]
      real(wp), intent(in) :: md                    !< [m]
      integer, intent(in) :: part                   !< number of the component, 0: none
      integer, intent(in) :: limit
      real(wp), intent(in) :: hours                 !< of the case [h]
      type(verdict_type), intent(inout) :: verdict
      if (used > 1.0_wp) verdict%passed(limit) = used
      if (.not. is_most(used, verdict)) return
      if (verdict%answer == answer_no .and. all(verdict%limit /= limits_by_hours)) return
      if (used > 1.0_wp) verdict%answer = answer_no
      verdict%limit = limit
      verdict%used = given(used)
      verdict%md = given(md)
      verdict%part = part
      verdict%load = given(hours*hour)
      verdict%allowed = given(hours*hour/used)
   end subroutine judge_hours

   !> Judge a rotating case without a solution. It is impossible if torque on bit alone is more than the top drive has, as
   !> friction adds to it.
   pure subroutine judge_bit_torque(model, case_index, verdict)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(verdict_type), intent(inout) :: verdict
      associate (load_case => model%cases(case_index), most => model%rig%max_torque)
         if (.not. (most%present .and. rotates(load_case%operation))) return
         if (.not. load_case%tob > most%value) return
         verdict%answer = answer_no
         verdict%limit = limit_top_drive
         verdict%used = given(load_case%tob/most%value)
         verdict%load = given(load_case%tob)
         verdict%allowed = most
         verdict%alone = .true.
      end associate
   end subroutine judge_bit_torque
end module dg_find_verdict
