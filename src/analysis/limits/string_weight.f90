!> Judges the string's own weight, with a push at surface of at most `max_push` of the rig.
module dg_string_weight
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, is_pushed
   use dg_fluid_pressure, only: is_hung, needed_push, surface_push
   use dg_job, only: model_mcge
   use dg_load_case, only: block_way, load_case_type, moves_axially, operation_static, rotates
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_packer, only: end_compression, packer_push
   use dg_trajectory, only: top_md
   use dg_verdict, only: answer_no, limit_lock_up, limit_string_weight, is_most, verdict_type
   use dg_weight_on_bit, only: locks_up
   implicit none
   private
   public :: judge_weight, passed_weight, weight_share, too_much

   !> Share of a limit that stands for a string which cannot come down, where there is no number [-].
   real(wp), parameter :: too_much = 2.0_wp

contains

   !> Judge string weight or lock-up, which decide if they are passed or used more than the strengths. They are not known if
   !> the survey begins below surface. Tubing in its hanger must only pull there, or push no more than `max_push`.
   pure subroutine judge_weight(model, result, wob_lockup, verdict)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(optional_real), intent(in) :: wob_lockup     !< largest weight on bit by weight and push, of the soft string [N]
      type(verdict_type), intent(inout) :: verdict
      real(wp) :: share, weight
      integer :: passed
      logical :: takes_weight, by_push     ! by_push: the limit is max_push
      if (top_md(model%trajectory) > 0.0_wp) then
         verdict%not_checked(limit_string_weight) = .true.
         return
      end if
      associate (load_case => model%cases(result%case_index))
         weight = own_weight(model, load_case, result)
         verdict%max_push = model%rig%max_push
         verdict%push = max(needed_push(model, result%case_index, result%hookload), 0.0_wp)
         verdict%pressure_pushes = surface_push(model, result%case_index) > 0.0_wp
         verdict%packer_pushes = abs(packer_push(model, load_case)) > 0.0_wp
         passed = passed_weight(model, result%model, result%case_index, result%hookload, maxval(abs(result%profile%axial)))
         by_push = verdict%max_push > 0.0_wp .and. verdict%push > 0.0_wp
         if (is_hung(model, load_case) .and. passed == 0 .and. .not. by_push) return
         if (passed == limit_string_weight .and. verdict%answer == answer_no .and. load_case%operation == operation_static) then
            verdict%also = passed       ! strength decides, as a hanger may hold the top down
            return
         end if
         if (passed > 0 .and. verdict%answer == answer_no) then
            verdict%also = verdict%limit
            verdict%also_load = verdict%load%value
            verdict%also_allowed = verdict%allowed%value
         end if
         share = weight_share(model, load_case, result)
         takes_weight = moves_axially(load_case%operation) .or. load_case%wob > 0.0_wp
         verdict%weight_judged = takes_weight .and. block_way(load_case%operation) <= 0
         if (passed == limit_string_weight .or. ((takes_weight .or. by_push) .and. is_most(share, verdict))) then
            verdict%limit = limit_string_weight
            verdict%used = optional_real(weight > 0.0_wp .or. by_push, share)
            verdict%load = given(weight + needed_push(model, result%case_index, result%hookload))
            verdict%allowed = given(weight + model%rig%max_push)
            if (by_push) then
               verdict%load = given(verdict%push)
               verdict%allowed = given(verdict%max_push)
            ! Both numbers agree with the deck if only weight on bit takes the weight.
            else if (load_case%wob > 0.0_wp .and. .not. (moves_axially(load_case%operation) .or. &
                                                         verdict%pressure_pushes .or. verdict%packer_pushes)) then
               verdict%load = given(load_case%wob)
               verdict%allowed = given(load_case%wob + result%hookload)
            end if
            verdict%md%present = .false.
         end if
         if (passed > 0) verdict%answer = answer_no
         if (passed == limit_string_weight .or. block_way(load_case%operation) > 0 .or. .not. wob_lockup%present) return
         if (passed == 0 .and. (rotates(load_case%operation) .or. .not. moves_axially(load_case%operation))) return
         ! The soft string may lock up where beams do not: then the limit is reached, not passed.
         share = 0.0_wp
         if (load_case%wob > 0.0_wp) share = load_case%wob/max(wob_lockup%value, load_case%wob)
         if (passed == 0 .and. .not. is_most(share, verdict)) return
         verdict%limit = limit_lock_up
         verdict%used = optional_real(load_case%wob > 0.0_wp .and. wob_lockup%value > 0.0_wp, share)
         if (passed > 0 .and. verdict%used%present) verdict%used%value = load_case%wob/wob_lockup%value
         verdict%load = given(load_case%wob)
         verdict%allowed = given(wob_lockup%value)
         if (passed == 0) verdict%allowed%value = max(wob_lockup%value, load_case%wob)
         verdict%md%present = .false.
      end associate
   end subroutine judge_weight

   !> Buoyed weight along the hole [N].
   elemental function own_weight(model, load_case, result) result(weight)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      real(wp) :: weight
      weight = result%hookload + surface_push(model, result%case_index) + end_compression(model, load_case) + result%friction
   end function own_weight

   !> Part of the buoyed weight that weight on bit and friction take [-]; the hook load is the rest. It is > 1 if the string
   !> must be pushed. It is 0 if friction pulls the other way, and 2 if a floating string must be pushed. With a `max_push` it
   !> is the part of weight and push that they take. As soon as a push is needed it is the part of that push.
   elemental function weight_share(model, load_case, result) result(share)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      real(wp) :: share
      real(wp) :: weight, push
      weight = own_weight(model, load_case, result)
      push = needed_push(model, result%case_index, result%hookload)
      if (model%rig%max_push > 0.0_wp .and. push > 0.0_wp) then
         share = push/model%rig%max_push
      else if (weight > 0.0_wp) then
         share = max((weight + push)/(weight + model%rig%max_push), 0.0_wp)
      else
         share = merge(too_much, 0.0_wp, push > 0.0_wp)
      end if
   end function weight_share

   !> Limit of the string's weight that a converged result passes; 0: none.
   !> - string weight: the hook load is below zero, by more than `max_push` of the rig
   !> - lock-up: the friction of helical buckling takes it, which only beams have in their hook load
   !> It is 0 if the survey begins below surface.
   pure function passed_weight(model, method, case_index, hookload, largest) result(limit)
      type(model_type), intent(in) :: model
      integer, intent(in) :: method        !< number of the model that was solved (dg_job)
      integer, intent(in) :: case_index
      real(wp), intent(in) :: hookload     !< [N]
      real(wp), intent(in) :: largest      !< largest axial force along the string, absolute, the scale of round-off [N]
      integer :: limit
      limit = 0
      if (top_md(model%trajectory) > 0.0_wp) return
      if (is_pushed(model%rig%max_push - needed_push(model, case_index, hookload), [largest])) then
         limit = limit_string_weight
      else if (method /= model_mcge) then
         if (locks_up(model, case_index)) limit = limit_lock_up
      end if
   end function passed_weight
end module dg_string_weight
