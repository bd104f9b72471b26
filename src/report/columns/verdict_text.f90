!> Sentences of a verdict, with numbers in the deck's units. They have no full stop at their end.
module dg_verdict_text
   use dg_kinds, only: wp
   use dg_friction_text, only: reserve_text, times_text
   use dg_load_case, only: block_way, load_case_type, moves_axially, operation_name, operation_static, rotates
   use dg_load_text, only: force_text, load_text, number_text, sum_texts, sum_width
   use dg_passed_pressure, only: is_burst
   use dg_push_text, only: is_by_push, push_text, weight_text
   use dg_readable, only: capital, spaced
   use dg_rounding, only: rounded_up
   use dg_text, only: either, to_text
   use dg_unit_kind, only: at_most, in_units, unit_factor, unit_force, unit_length, unit_moment, unit_pressure, &
                           unit_rotation, unit_speed
   use dg_units, only: unit_system_type
   use dg_utilisation, only: limit_joint_torsion, limit_makeup, limit_rig, limit_slips, limit_tension, limit_top_drive, &
                             limit_von_mises
   use dg_verdict, only: answer_no, answer_yes, friction_upper_end, friction_upper_end_alone, is_near_by_friction, &
                         is_without_check, limit_casing_wear, limit_fatigue, &
                         limit_joint_fatigue, limit_lock_up, limit_string_weight, limits_by_hours, limit_title, &
                         limit_wob_yield, slow_turning, verdict_type
   implicit none
   private
   public :: task_text, used_text, verdict_reason, verdict_sentences, row_mark, mark_meaning

   !> Behind a row of a table that cannot be done or has no solution, and what stands below such a table.
   character(*), parameter :: row_mark = '!', mark_meaning = row_mark//' cannot be done, or no solution'

   !> Digits of loads, depths, shares, and of what is rough.
   integer, parameter :: shown = 3, shown_depth = 5, shown_share = 3, few_digits = 2
   !> Most digits of a share below 1.
   integer, parameter :: most_digits = 7
   real(wp), parameter :: percent = 0.01_wp
   !> Part of a limit from which on the text says that little is left [-].
   real(wp), parameter :: close_to_limit = 0.95_wp

contains

   !> Operation and depth of a load case: 'Sliding drilling at 15800 ft'.
   pure function task_text(units, load_case) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      character(:), allocatable :: text
      text = capital(spaced(trim(operation_name(load_case%operation))))//' at '// &
             depth_text(units, load_case%bit_depth)
   end function task_text

   !> Reason why the answer is no, in one clause with numbers; '' for another answer.
   pure function verdict_reason(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      character(sum_width) :: sums(3)      ! load, allowed load, what is too much
      logical :: enough
      text = ''
      if (verdict%answer /= answer_no) return
      enough = .true.      ! the weight on bit that is asked for is not known to be too much
      if (verdict%most_wob%present) enough = load_case%wob <= verdict%most_wob%value
      select case (verdict%limit)
      case (limit_lock_up, limit_string_weight)
         if (block_way(load_case%operation) > 0 .and. verdict%limit == limit_lock_up) then
            text = 'Friction holds the string at '//depth_text(units, load_case%bit_depth)//', a pull does not move it'
         else if (load_case%wob > 0.0_wp .and. .not. enough) then
            text = 'no load'
            if (verdict%most_wob%value > 0.0_wp) text = force_text(units, at_most(units, unit_force, verdict%most_wob%value, shown))
            text = either('String weight and '//force_text(units, verdict%max_push)//' of push bring ', &
                          'String weight alone brings ', verdict%max_push > 0.0_wp)//text//' to the bit, '// &
                   force_text(units, load_case%wob)//' asked'
         else if (verdict%limit == limit_lock_up) then
            text = capital(weight_text(verdict, 'does', 'do'))//' not bring the bit to '// &
                   depth_text(units, load_case%bit_depth)
         else
            text = capital(push_text(units, load_case, verdict))
            if (.not. verdict%used%present) text = text//', as the weight of the string in mud, along the hole, is below zero'
         end if
         if (verdict%limit == limit_lock_up .and. block_way(load_case%operation) <= 0) text = text//' (lock-up)'
      case (limit_wob_yield)
         text = 'Compressed pipe yields, its buckling counted'
         if (verdict%allowed%value > 0.0_wp) then
            text = text//': WOB '//force_text(units, load_case%wob)//', '// &
                   force_text(units, at_most(units, unit_force, verdict%allowed%value, shown))//' allowed by the soft string. '
         else
            text = text//', also without WOB, by the soft string. '
         end if
         text = text//'Model mcge solves its bending'
      case default
         text = capital(shown_title(verdict%limit))//place_text(units, verdict)//': '
         if (verdict%allowed%present) then
            sums = sum_texts(units, verdict%limit, verdict%load%value, verdict%allowed%value)
            text = text//trim(sums(1))//either(' at the bit alone', '', verdict%alone)//', '//trim(sums(2))//' allowed, '// &
                   trim(sums(3))//' too much'
         else
            text = text//load_text(units, verdict%limit, verdict%load%value)//either(' at the bit alone', '', verdict%alone)
         end if
         if (load_case%wob < 0.0_wp) text = text//', with '//force_text(units, -load_case%wob)// &
            either(' of pull on the packer', ' of overpull at the bit', verdict%packer_pushes .and. load_case%length_reference > 0)
      end select
      if (verdict%friction == friction_upper_end_alone) text = text//', at the upper end of the 95 % interval of friction'
   end function verdict_reason

   !> Sentences beside the answer. For NO: the reason and what helps. For yes: the nearest limit and the friction reserve.
   pure function verdict_sentences(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      if (verdict%answer == answer_no) then
         text = verdict_reason(units, load_case, verdict)
         if (verdict%friction == friction_upper_end_alone .and. load_case%measured_hookload%present) text = text//'. A '// &
            'hook load was measured in this case, so it could be done: friction was less then'
         text = text//help_text(units, load_case, verdict)
      else if (verdict%answer == answer_yes) then
         text = ''
         if (verdict%uncertain > 0.0_wp) text = 'UNCERTAIN: contact force may be off by '// &
            to_text(rounded_up(verdict%uncertain/percent, few_digits), few_digits)//' %, more than is left of a limit. '
         if (verdict%joints_uncertain) text = text//'UNCERTAIN: smeared tool joints leave out friction, perhaps more than '// &
            'is left, see Warnings. '
         if (verdict%fatigue_used > 0.0_wp) text = text//'UNCERTAIN: bending at '//depth_text(units, verdict%fatigue_md)// &
            ' is '//used_text(verdict%fatigue_used)//' % of the fatigue limit. Hours of rotation are limited, how many is not '// &
            'known. '
         if (is_near_by_friction(verdict)) text = text//'Close to its limit: the answer '//reserve_text(verdict)//'. '
         text = text//nearest_text(units, load_case, verdict)
         if (verdict%most_wob%present .and. moves_axially(load_case%operation) .and. load_case%wob > 0.0_wp &
             .and. verdict%limit /= limit_lock_up) text = text//'. '// &
            capital(weight_text(verdict, 'brings', 'bring'))//' at most about '// &
            force_text(units, max(verdict%most_wob%value, load_case%wob))//' to the bit'//yield_text()
         if (is_by_push(verdict) .and. verdict%limit /= limit_string_weight) &
            text = text//'. '//capital(push_text(units, load_case, verdict))
         if (verdict%buckled_length > 0.0_wp) text = text//'. Helically buckled over '// &
            in_units(units, unit_length, verdict%buckled_length, shown)// &
            either(' by formula', '', verdict%buckled_by_formula)
         if (verdict%friction == friction_upper_end) &
            text = text//'. The answer is yes at the upper end of the 95 % interval of friction, too'
         if (verdict%reserve_unknown) text = text//'. Its friction reserve is not known, as the string turns under more than '// &
            'its helical load. Find it by a sweep with several frictions'
         if (verdict%friction_reserve%present .and. .not. is_near_by_friction(verdict)) &
            text = text//'. The answer '//reserve_text(verdict)
      else
         text = 'Not converged, see Warnings'
      end if
   contains
      !> Weight on bit above which compressed pipe yields, where more of it reaches the bit.
      pure function yield_text() result(words)
         character(:), allocatable :: words
         words = ''
         if (.not. verdict%wob_yield%present .or. verdict%limit == limit_wob_yield) return
         if (verdict%wob_yield%value > load_case%wob) words = ', but compressed pipe yields above about '// &
            force_text(units, at_most(units, unit_force, verdict%wob_yield%value, shown))//', by the soft string'
      end function yield_text
   end function verdict_sentences

   !> Reason why it is also impossible without weight on bit or overpull; '' if it is possible.
   pure function without_load_text(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      associate (limit => verdict%limit_without_load, excess => verdict%excess_without_load)
         if (limit == 0) return
         select case (limit)
         case (limit_lock_up); text = weight_text(verdict, 'does', 'do')//' not bring the bit to '// &
                                    depth_text(units, load_case%bit_depth)
         case (limit_string_weight); text = weight_text(verdict, 'is', 'are')//' '//force_text(units, excess)//' short'
         case default; text = shown_title(limit)//' '//load_text(units, limit, excess)//' too much then'
         end select
      end associate
      text = '. Not possible without '//either('overpull', 'weight on bit', load_case%wob < 0.0_wp)//' either: '//text
   end function without_load_text

   !> Remedy that makes the operation possible, if known; else ''.
   pure function help_text(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (verdict%also == limit_string_weight) then
         text = '. '//capital(push_text(units, load_case, verdict))
      else if (verdict%also > 0) then
         text = '. Also too much: '//shown_title(verdict%also)//', '//number_text(units, verdict%also, verdict%also_load)// &
                ' of '//load_text(units, verdict%also, verdict%also_allowed)
      end if
      text = text//passed_text(verdict)
      text = text//without_load_text(units, load_case, verdict)
      if (verdict%reach%present) then
         if (verdict%reach%value > 0.0_wp) then
            text = text//'. Deepest bit depth possible: about '// &
                   in_units(units, unit_length, at_most(units, unit_length, verdict%reach%value, shown), shown)// &
                   either(' with this WOB', '', load_case%wob > 0.0_wp)
         else if (load_case%operation /= operation_static) then
            text = text//'. No shallower bit depth is possible either'
         end if
      end if
      if (verdict%fill) text = text//'. Fill the empty string: with the fluid outside in it the answer becomes yes'
      if (verdict%pump_pressure%present) text = text//'. The answer becomes yes with a pump_pressure of at '// &
         pump_text(units, verdict)
      if (verdict%turning_hookload%present) &
         text = text//'. Rotate the string and move it slowly'// &
                either(' (at '//in_units(units, unit_rotation, slow_turning, few_digits)//' at most about '// &
                       in_units(units, unit_speed, at_most(units, unit_speed, &
                       verdict%turning_speed%value, few_digits), few_digits)//')', '', verdict%turning_speed%present)// &
                ', if that is allowed: its weight '// &
                'is enough then, hook load at most about '//force_text(units, verdict%turning_hookload%value)//', torque about '// &
                in_units(units, unit_moment, verdict%turning_torque%value, shown)// &
                either(' without bit torque', '', load_case%wob > 0.0_wp)//', by the soft string. '// &
                'Check it by a case operation = '''//either("rotary'", "reaming' with rpm and trip_speed", load_case%wob > 0.0_wp)
      ! a string that must be held down as it goes up is held by its friction
      if (rotates(load_case%operation) .and. moves_axially(load_case%operation) .and. (verdict%limit == limit_lock_up .or. &
          (verdict%limit == limit_string_weight .and. block_way(load_case%operation) < 0))) &
         text = text//'. Move the string more slowly, or rotate it faster: drag falls with trip_speed over rpm'
      if (load_case%wob < 0.0_wp .and. verdict%limit_without_load == 0) text = text//overpull_text(units, verdict)
      if (verdict%possible_friction%present) then
         if (verdict%friction == friction_upper_end_alone) then
            text = text//'. With up to about '//times_text(verdict, verdict%possible_friction%value)//' the answer is yes'
         else if (verdict%alone) then
            text = text//'. '//capital(weight_text(verdict, 'is', 'are'))//' enough below about '// &
                   times_text(verdict, verdict%possible_friction%value)
         else
            text = text//'. The answer becomes yes below about '//times_text(verdict, verdict%possible_friction%value)
         end if
      end if
      if (verdict%alone) text = text//'. There is no solution: tension, torque and bending along the string are not known. '// &
         either('Of the other limits only burst and collapse are judged', 'No other limit is judged', verdict%pressures_judged)
   end function help_text

   !> Greatest pump pressure without burst, or the least without collapse.
   pure function pump_text(units, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      associate (factor => unit_factor(units, unit_pressure), pressure => verdict%pump_pressure%value)
         if (is_burst(verdict%limit)) then
            text = 'most '//in_units(units, unit_pressure, at_most(units, unit_pressure, pressure, shown), shown)
         else
            text = 'least '//in_units(units, unit_pressure, factor*rounded_up(pressure/factor, shown), shown)
         end if
      end associate
   end function pump_text

   !> Limits that are passed besides those that are already named; '' if there are none.
   pure function passed_text(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, size(verdict%passed)
         if (.not. verdict%passed(i) > 1.0_wp .or. any(i == [verdict%limit, verdict%also])) cycle
         text = text//either(', ', '. Also passed: ', text /= '')//trim(limit_title(i))//' ('// &
                used_text(verdict%passed(i))//' %)'
      end do
   end function passed_text

   !> Largest possible overpull, for a case that is impossible with more; '' if unknown.
   pure function overpull_text(units, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (.not. verdict%most_pull%present .or. any(verdict%limit == limits_by_hours)) return
      if (.not. verdict%most_pull%value > 0.0_wp) return
      text = either('. By the limits checked, o', '. O', any(verdict%not_checked))//'verpull up to about '// &
             force_text(units, at_most(units, unit_force, verdict%most_pull%value, shown))// &
             ' is possible: then '//shown_title(verdict%pull_limit)//' is at its limit'
   end function overpull_text

   !> The limit used most and its margin.
   pure function nearest_text(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text, title
      character(sum_width) :: sums(3)      ! load, allowed load, what is left
      logical :: by_wob, by_push
      if (verdict%limit == 0) then
         text = either('Nothing is checked, as the deck gives no limit', 'String weight is enough', is_without_check(verdict))
         return
      end if
      if (is_near_by_friction(verdict)) then
         text = 'Most used'
      else if (verdict%used%value > close_to_limit) then
         text = 'Close to its limit'
      else
         text = either('Nearest of the limits checked', 'Nearest limit', any(verdict%not_checked))
      end if
      by_push = verdict%limit == limit_string_weight .and. is_by_push(verdict)
      title = shown_title(verdict%limit)
      if (verdict%limit == limit_string_weight .and. verdict%max_push > 0.0_wp) &
         title = either('push at surface', 'string weight and push', by_push)
      text = text//': '//title//place_text(units, verdict)
      by_wob = any(verdict%limit == [limit_lock_up, limit_wob_yield])
      if (verdict%allowed%present) sums = sum_texts(units, verdict%limit, verdict%load%value, verdict%allowed%value)
      if (verdict%limit == limit_string_weight .and. .not. by_push) then
         text = text//' ('//trim(sums(2))//'), '//takers_text(load_case, verdict)//' '//trim(sums(1))//' of it, '
      else if (verdict%allowed%present) then
         text = text//either(', WOB ', ', ', by_wob)//sums(1)(:index(sums(1), ' ') - 1)//' of '// &
                trim(sums(2))//either(' by the soft string, ', ', ', by_wob .and. .not. verdict%wob_by_beams)
      else
         text = text//either(', WOB ', ', ', by_wob)
      end if
      text = text//used_text(verdict%used%value)//' % used'
      if (verdict%allowed%present .and. .not. by_wob) text = text//', '//trim(sums(3))//' left'
      if (verdict%limit == limit_string_weight .and. .not. verdict%max_push > 0.0_wp) text = text//' as hook load'
   end function nearest_text

   !> Used part of a limit in percent; 100 only where all of it is used.
   pure function used_text(used) result(text)
      real(wp), intent(in) :: used       !< [-]
      character(:), allocatable :: text
      integer :: digits
      digits = shown_share
      text = to_text(used/percent, digits)
      do while (text == '100' .and. digits < most_digits)
         digits = digits + 1
         text = to_text(used/percent, digits)
      end do
   end function used_text

   !> Names of what takes string weight, and the verb.
   pure function takers_text(load_case, verdict) result(text)
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (block_way(load_case%operation) > 0 .and. verdict%pressure_pushes) then
         text = 'annulus pressure less drag takes'      ! which pulls down
         return
      end if
      if (moves_axially(load_case%operation)) text = 'drag'
      if (load_case%wob > 0.0_wp) call add('WOB')
      if (verdict%packer_pushes) call add('pressure at the packer')
      if (verdict%pressure_pushes) call add('annulus pressure')
      if (text == '') text = 'WOB'                   ! of nothing
      text = text//either(' take', ' takes', index(text, ' and ') > 0)

   contains

      pure subroutine add(name)
         character(*), intent(in) :: name
         if (text /= '') text = text//' and '
         text = text//name
      end subroutine add
   end function takers_text

   !> Name of a limit with the load that it limits, in the middle of a sentence.
   pure function shown_title(limit) result(title)
      integer, intent(in) :: limit
      character(:), allocatable :: title
      select case (limit)
      case (limit_rig); title = 'hook load with block (rig)'
      case (limit_top_drive); title = 'torque of the top drive'
      case (limit_slips); title = 'hook load off bottom (slips)'
      case (limit_makeup); title = 'torque (make-up torque)'
      case (limit_joint_torsion); title = 'torque (joint torsion)'
      case (limit_von_mises); title = 'von Mises stress'
      case (limit_tension); title = 'tension of the pipe'
      case (limit_string_weight); title = 'string weight along the hole'
      case (limit_fatigue, limit_joint_fatigue, limit_casing_wear); title = trim(limit_title(limit))//' by hours of rotation'
      case default; title = trim(limit_title(limit))
      end select
   end function shown_title

   !> A depth.
   pure function depth_text(units, md) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: md         !< [m]
      character(:), allocatable :: text
      text = in_units(units, unit_length, md, shown_depth)
   end function depth_text

   !> Where a limit is used most: ' at 2300 ft in 'HWDP''; '' for the whole string and for loads at surface.
   pure function place_text(units, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (.not. verdict%md%present .or. any(verdict%limit == [limit_rig, limit_slips, limit_top_drive])) return
      text = ' at '//depth_text(units, verdict%md%value)
      if (allocated(verdict%component)) text = text//either('', " in '"//verdict%component//"'", verdict%component == '')
   end function place_text
end module dg_verdict_text
