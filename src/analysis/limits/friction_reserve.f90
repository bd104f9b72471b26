!> Factor by which all friction of a load case may grow before a limit is passed, or must shrink so that none is passed.
!>
!> The result is not solved again. Axial force and torque along the string change as those of the soft string, times a ratio.
!> The ratio is the result's friction over that of the soft string, both at the given friction.
module dg_friction_reserve
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_case_result, only: case_result_type
   use dg_fluid_pressure, only: needed_push, surface_push
   use dg_job, only: model_mcge, model_soft
   use dg_load_case, only: block_way, rotates
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_packer, only: end_compression
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_string_weight, only: too_much, weight_share
   use dg_trajectory, only: top_md
   use dg_utilisation, only: find_utilisation, utilisation_type
   use dg_verdict, only: limit_lock_up, limit_string_weight
   implicit none
   private
   public :: find_friction_reserve, find_possible_friction, find_shifted, buckles_by_friction

   !> Smallest and largest factor of the search, and its accuracy [-].
   real(wp), parameter :: least = 0.1_wp, most = 10.0_wp, narrowness = 1.0e-4_wp
   !> Friction of the soft string below this part of its weight is not scaled [-].
   real(wp), parameter :: no_friction = 1.0e-6_wp

   !> Loads of the soft string for the case, and ratios of the result to them.
   type :: soft_type
      real(wp), allocatable :: axial(:), torque(:)   !< along the string [N, N.m]
      real(wp) :: compression = 0.0_wp               !< of the lower end [N]
      real(wp) :: bit_torque = 0.0_wp                !< [N.m]
      real(wp) :: axial_ratio = 1.0_wp               !< friction of the result over that of the soft string [-]
      real(wp) :: torque_ratio = 1.0_wp              !< torque by friction of the result over that of the soft string [-]
      logical :: coiled = .false.                    !< with the friction of helical buckling
      logical :: climbs = .false.                    !< as in beams that turn: torque grows less than friction then
   end type soft_type

contains

   !> Find the factor, > 1. Absent if no limit is passed up to ten times the given friction, and if one is passed already.
   pure subroutine find_friction_reserve(model, result, reserve, limit)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result       !< converged
      type(optional_real), intent(out) :: reserve
      integer, intent(out) :: limit                      !< limit that is passed beyond the factor; 0: none
      call find_factor(model, result, [1.0_wp, most], reserve, limit)
   end subroutine find_friction_reserve

   !> True for beams that the soft string sees buckled with all friction times a factor. The friction of their coils is not known
   !> then: in four such wells the answer turned at 0.85 to 0.96 of the factor.
   pure function buckles_by_friction(model, result, factor) result(buckles)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result       !< converged
      real(wp), intent(in) :: factor                     !< [-]
      logical :: buckles
      type(soft_totals_type) :: totals
      real(wp) :: axial(1), torque(1)
      associate (load_case => model%cases(result%case_index))
         buckles = result%model == model_mcge .and. block_way(load_case%operation) < 0 .and. .not. rotates(load_case%operation)
      end associate
      if (.not. buckles) return
      call soft_string_at(model, result%case_index, [top_md(model%trajectory)], axial, torque, totals=totals, &
                          other=other_loads_type(friction_scale=factor, coiled=.true.))
      buckles = max(totals%coil, totals%bowed) > 0.0_wp
   end function buckles_by_friction

   !> Find the part of the given friction, < 1, with which a result that passes a limit does not pass it. Absent if friction
   !> does not decide.
   pure subroutine find_possible_friction(model, result, part)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result       !< converged
      type(optional_real), intent(out) :: part
      integer :: limit
      call find_factor(model, result, [least, 1.0_wp], part, limit)
   end subroutine find_possible_friction

   !> Find the factor between two at which a limit is reached. Absent if none is passed at the upper one, or one is passed at
   !> the lower one.
   pure subroutine find_factor(model, result, between, found, passed)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: between(2)       !< [-]
      type(optional_real), intent(out) :: found
      integer, intent(out) :: passed           !< limit that is passed just beyond the factor; 0: none
      type(soft_type) :: soft
      type(bracket_type) :: bracket
      real(wp) :: factor, margin(2), here
      integer :: i, limit
      passed = 0
      if (.not. allocated(result%profile%md)) return
      call begin_soft(model, result, soft)
      if (.not. allocated(soft%axial)) return
      do i = 1, 2
         call find_margin(model, result, soft, between(i), margin(i), limit)
      end do
      if (margin(2) >= 0.0_wp .or. margin(1) < 0.0_wp) return
      passed = limit
      bracket = new_bracket(between(1), margin(1), between(2), margin(2))
      do while (.not. is_narrow(bracket, narrowness*between(2)))
         factor = next_try(bracket, narrowness*between(2))
         call find_margin(model, result, soft, factor, here, limit)
         if (here < 0.0_wp) passed = limit
         call narrow(bracket, factor, here)
      end do
      found = given(bracket%low)
   end subroutine find_factor

   !> Solve the soft string at the given friction. `soft%axial` is not allocated if it locks up.
   pure subroutine begin_soft(model, result, soft)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(soft_type), intent(out) :: soft
      type(soft_totals_type) :: totals
      real(wp) :: axial(size(result%profile%md)), torque(size(result%profile%md)), friction, turning
      ! A rotating string comes farther than the soft string with the friction of helical buckling.
      soft%coiled = result%model /= model_soft .and. .not. rotates(model%cases(result%case_index)%operation)
      soft%climbs = result%model == model_mcge
      call soft_string_at(model, result%case_index, result%profile%md, axial, torque, totals=totals, &
                          other=other_loads_type(coiled=soft%coiled, climbs=soft%climbs))
      if (totals%runaway) return
      soft%axial = axial
      soft%torque = torque
      associate (load_case => model%cases(result%case_index))
         soft%compression = end_compression(model, load_case)
         soft%bit_torque = load_case%tob
         friction = totals%weight - soft%compression - axial(1)
         turning = torque(1) - load_case%tob
         if (abs(friction) > no_friction*abs(totals%weight)) soft%axial_ratio = max(result%friction/friction, 0.0_wp)
         if (turning > 0.0_wp) soft%torque_ratio = max((result%torque - load_case%tob)/turning, 0.0_wp)
      end associate
   end subroutine begin_soft

   !> Shift the result to the friction of another model of the same well, or to another weight on bit and bit torque.
   pure subroutine find_shifted(model, other_model, result, other, locks_up)
      type(model_type), intent(in) :: model
      type(model_type), intent(in) :: other_model        !< with another friction of the hole, wob or tob; all else equal
      type(case_result_type), intent(in) :: result       !< of `model`, converged
      type(case_result_type), intent(out) :: other       !< hook load, torque, friction, profile
      logical, intent(out) :: locks_up                   !< true if there is no such result
      type(soft_type) :: soft
      call begin_soft(model, result, soft)
      locks_up = .not. allocated(soft%axial)
      if (.not. locks_up) call shift_result(other_model, result, soft, 1.0_wp, other, locks_up)
   end subroutine find_shifted

   !> Shift the result to the friction of a model times a factor. Force and torque that are added at the lower end reach the
   !> top unchanged.
   pure subroutine shift_result(model, result, soft, factor, other, locks_up)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(soft_type), intent(in) :: soft
      real(wp), intent(in) :: factor       !< [-]
      type(case_result_type), intent(out) :: other
      logical, intent(out) :: locks_up
      type(soft_totals_type) :: totals
      real(wp) :: axial(size(soft%axial)), torque(size(soft%axial)), added, added_torque
      call soft_string_at(model, result%case_index, result%profile%md, axial, torque, totals=totals, &
                          other=other_loads_type(friction_scale=factor, coiled=soft%coiled, climbs=soft%climbs))
      locks_up = totals%runaway
      if (locks_up) return
      other%case_index = result%case_index
      other%model = result%model
      other%profile = result%profile
      added = end_compression(model, model%cases(result%case_index)) - soft%compression
      other%profile%axial = result%profile%axial - added + soft%axial_ratio*(axial - soft%axial + added)
      added_torque = model%cases(result%case_index)%tob - soft%bit_torque
      other%profile%torque = result%profile%torque + added_torque + soft%torque_ratio*(torque - soft%torque - added_torque)
      other%hookload = result%hookload + other%profile%axial(1) - result%profile%axial(1)
      other%torque = other%profile%torque(1)
      other%friction = result%friction - (other%hookload - result%hookload) - added
   end subroutine shift_result

   !> Find one minus the share of the most used limit with all friction times a factor, and that limit.
   pure subroutine find_margin(model, result, soft, factor, margin, limit)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(soft_type), intent(in) :: soft
      real(wp), intent(in) :: factor       !< [-]
      real(wp), intent(out) :: margin      !< [-]
      integer, intent(out) :: limit        !< number of dg_verdict; 0: none is known
      type(case_result_type) :: other
      type(along_string_type) :: along
      type(utilisation_type) :: utilisation
      type(soft_totals_type) :: totals
      real(wp) :: axial(size(soft%axial)), torque(size(soft%axial)), share, hookload
      logical :: runaway
      call shift_result(model, result, soft, factor, other, runaway)
      if (runaway) then
         margin = 1.0_wp - too_much
         limit = limit_lock_up
         return
      end if
      call find_along_string(model, other, along)
      call find_utilisation(model, other, along, utilisation)
      margin = 1.0_wp
      limit = utilisation%governing
      if (limit > 0) margin = 1.0_wp - utilisation%used(limit)%value
      if (top_md(model%trajectory) > 0.0_wp) return
      share = weight_share(model, model%cases(result%case_index), other)
      if (margin > 1.0_wp - share) then
         margin = 1.0_wp - share
         limit = limit_string_weight
      end if
      if (result%model == model_mcge .or. block_way(model%cases(result%case_index)%operation) >= 0) return
      ! Models without the friction of helical buckling in their hook load are judged by the soft string with it.
      call soft_string_at(model, result%case_index, result%profile%md, axial, torque, totals=totals, &
                          other=other_loads_type(friction_scale=factor, coiled=.true.))
      share = too_much
      if (.not. totals%runaway) then
         hookload = axial(1) - surface_push(model, result%case_index)
         ! this holds for a string that floats too
         share = 1.0_wp - hookload/max(totals%weight, abs(axial(1)), tiny(share))
         if (model%rig%max_push > 0.0_wp) share = needed_push(model, result%case_index, hookload)/model%rig%max_push
      end if
      if (.not. margin > 1.0_wp - share) return
      margin = 1.0_wp - share
      limit = limit_lock_up
   end subroutine find_margin
end module dg_friction_reserve
