!> Sentences of a verdict, with numbers in the deck's units. They have no full stop at their end.
module dg_verdict_text
   use dg_kinds, only: wp
   use dg_load_case, only: block_way, load_case_type, moves_axially, operation_static
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_force, unit_length, unit_moment, unit_pressure, unit_stress
   use dg_units, only: unit_system_type
   use dg_utilisation, only: limit_burst, limit_collapse, limit_joint_torsion, limit_makeup, limit_rig, limit_slips, &
                             limit_tension, limit_top_drive, limit_torsion, limit_von_mises
   use dg_verdict, only: answer_no, answer_yes, every_limit_count, friction_calibrated, friction_given, friction_upper_end, &
                         friction_upper_end_alone, limit_code, limit_fatigue, limit_lock_up, limit_string_weight, limit_title, &
                         verdict_type
   implicit none
   private
   public :: verdict_reason, verdict_sentences, unchecked_codes, row_mark, mark_meaning

   !> Behind a row of a table that cannot be done or has no solution, and what stands below such a table.
   character(*), parameter :: row_mark = '!', mark_meaning = row_mark//' cannot be done, or no solution'

   !> Digits of loads, depths and factors.
   integer, parameter :: shown = 3, shown_depth = 5, shown_factor = 3
   real(wp), parameter :: percent = 0.01_wp
   !> Part of a limit from which on the text says that little is left [-].
   real(wp), parameter :: close_to_limit = 0.95_wp
   !> Friction reserve below which the text says 'only' [-].
   real(wp), parameter :: little_reserve = 1.1_wp
   !> Limits that all need one thing, the yield strength.
   integer, parameter :: by_yield(5) = [limit_von_mises, limit_tension, limit_torsion, limit_burst, limit_collapse]

contains

   !> Why the answer is no, in one clause with numbers; '' for another answer.
   pure function verdict_reason(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
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
            text = 'String weight alone brings '//force_text(units, verdict%most_wob%value)//' to the bit, '// &
                   force_text(units, load_case%wob)//' asked'
         else if (verdict%limit == limit_lock_up) then
            text = 'String weight does not bring the bit to '//depth_text(units, load_case%bit_depth)
         else if (load_case%operation == operation_static) then
            text = 'The top must be held down with '//force_text(units, push_of(verdict))
         else
            text = force_text(units, push_of(verdict))//' of push needed at surface'
         end if
         if (verdict%limit == limit_lock_up .and. block_way(load_case%operation) <= 0) text = text//' (lock-up)'
      case default
         text = shown_title(verdict%limit)//': '// &
                load_text(units, verdict%limit, verdict%load%value)//place_text(units, verdict)
         if (verdict%allowed%present) text = text//', '//load_text(units, verdict%limit, verdict%allowed%value)//' allowed'
      end select
      if (verdict%friction == friction_upper_end_alone) text = text//', at the upper end of the 95 % interval of friction'
   end function verdict_reason

   !> What stands beside the answer: the reason and what helps; or the nearest limit, what is left of it, the friction reserve and
   !> what was not checked.
   pure function verdict_sentences(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      if (verdict%answer == answer_no) then
         text = verdict_reason(units, load_case, verdict)//help_text(units, verdict)
      else if (verdict%answer == answer_yes) then
         text = nearest_text(units, load_case, verdict)
         if (verdict%most_wob%present .and. moves_axially(load_case%operation) .and. load_case%wob > 0.0_wp) &
            text = text//'. Largest WOB '//force_text(units, max(verdict%most_wob%value, load_case%wob))
         if (verdict%buckled_length > 0.0_wp) text = text//'. Helically buckled over '// &
            trim(in_units(units, unit_length, verdict%buckled_length, shown))// &
            trim(merge(' by formula', '           ', verdict%buckled_by_formula))
         text = text//reserve_text(verdict)
         if (any(verdict%not_checked)) text = text//'. Not checked, no rating given: '//unchecked_text(verdict)
      else
         text = 'No solution was found'
      end if
   end function verdict_sentences

   !> What more friction does.
   pure function reserve_text(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (verdict%friction == friction_upper_end) then
         text = '. Works at the upper end of the 95 % interval of friction'
         if (verdict%friction_reserve%present) text = text//' and'
      end if
      if (verdict%friction_reserve%present) then
         if (text == '') text = '. Works'//trim(merge(' only', '     ', verdict%friction_reserve%value < little_reserve))
         text = text//' up to about '//times_text(verdict, verdict%friction_reserve%value)//reserve_end(verdict)
      end if
      if (verdict%friction == friction_calibrated) text = text//'. The 95 % interval of the calibrated friction is unknown'
   end function reserve_text

   !> A factor of friction, rounded down: with the factor as it stands there the answer is yes.
   pure function times_text(verdict, factor) result(text)
      type(verdict_type), intent(in) :: verdict
      real(wp), intent(in) :: factor       !< > 0 [-]
      character(:), allocatable :: text
      real(wp) :: last
      last = 10.0_wp**(floor(log10(factor)) + 1 - shown_factor)
      text = to_text(last*real(floor(factor/last), wp), shown_factor)//' times the '// &
             trim(merge('friction given     ', 'calibrated friction', verdict%friction == friction_given))
   end function times_text

   !> The limit that ends the friction reserve, where it is another one than the limit used most today.
   pure function reserve_end(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (verdict%reserve_limit > 0 .and. verdict%reserve_limit /= verdict%limit) &
         text = ', limited by '//trim(limit_title(verdict%reserve_limit))
   end function reserve_end

   !> Push at surface that a string needs [N].
   pure function push_of(verdict) result(push)
      type(verdict_type), intent(in) :: verdict
      real(wp) :: push
      push = verdict%load%value - verdict%allowed%value
   end function push_of

   !> What makes the operation possible, as far as it is known; '' else.
   pure function help_text(units, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (verdict%turning_hookload%present) &
         text = '. Rotate the string: the hook load is then about '//force_text(units, verdict%turning_hookload%value)
      if (verdict%possible_friction%present) text = text//'. Possible '// &
         trim(merge('up to', 'with ', verdict%friction == friction_upper_end_alone))//' about '// &
         times_text(verdict, verdict%possible_friction%value)
   end function help_text

   !> The limit used most and what is left of it.
   pure function nearest_text(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      if (verdict%limit == 0) then
         text = 'No limit is known'
         return
      end if
      text = ''
      if (verdict%used%value > close_to_limit) text = 'Close to its limit: '
      text = text//used_text(load_case, verdict)//place_text(units, verdict)
      if (verdict%allowed%present) text = text//', '// &
         load_text(units, verdict%limit, verdict%allowed%value - verdict%load%value)//' left'
      if (verdict%limit == limit_string_weight) text = text//' on the hook'
   end function nearest_text

   !> How much of the limit is used, and by what.
   pure function used_text(load_case, verdict) result(text)
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      logical :: drags
      text = to_text(verdict%used%value/percent, shown_factor)//' %'
      drags = moves_axially(load_case%operation)
      if (verdict%limit == limit_lock_up) then
         text = 'WOB is '//text//' of the largest before lock-up'
      else if (verdict%limit /= limit_string_weight) then
         text = shown_title(verdict%limit)//' '//text//' used'
      else if (drags .and. load_case%wob > 0.0_wp) then
         text = 'friction and WOB take '//text//' of the string weight'
      else
         text = trim(merge('friction takes', 'WOB takes     ', drags))//' '//text//' of the string weight'
      end if
   end function used_text

   !> Name of a limit with the load that it limits.
   pure function shown_title(limit) result(title)
      integer, intent(in) :: limit
      character(:), allocatable :: title
      select case (limit)
      case (limit_rig); title = 'hook load of the rig'
      case (limit_top_drive); title = 'torque of the top drive'
      case (limit_von_mises); title = 'von Mises stress'
      case default; title = trim(limit_title(limit))
      end select
   end function shown_title

   !> A load of a limit.
   pure function load_text(units, limit, load) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: limit
      real(wp), intent(in) :: load       !< [N, N.m or Pa]
      character(:), allocatable :: text
      select case (limit)
      case (limit_torsion, limit_joint_torsion, limit_makeup, limit_top_drive)
         text = trim(in_units(units, unit_moment, load, shown))
      case (limit_von_mises, limit_fatigue)
         text = trim(in_units(units, unit_stress, load, shown))
      case (limit_burst, limit_collapse)
         text = trim(in_units(units, unit_pressure, load, shown))
      case default
         text = force_text(units, load)
      end select
   end function load_text

   !> A force.
   pure function force_text(units, force) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: force      !< [N]
      character(:), allocatable :: text
      text = trim(in_units(units, unit_force, force, shown))
   end function force_text

   !> A depth.
   pure function depth_text(units, md) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: md         !< [m]
      character(:), allocatable :: text
      text = trim(in_units(units, unit_length, md, shown_depth))
   end function depth_text

   !> Where a limit is used most: ' at 2300 ft'; '' for the whole string, and for what is measured at surface alone.
   pure function place_text(units, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = ''
      if (verdict%md%present .and. all(verdict%limit /= [limit_rig, limit_slips, limit_top_drive])) &
         text = ' at '//depth_text(units, verdict%md%value)
   end function place_text

   !> Names of the limits that were not checked, one name for all that need a yield strength.
   pure function unchecked_text(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      integer :: i
      text = ''
      if (verdict%not_checked(limit_tension)) text = 'pipe strength (no yield)'
      do i = 1, every_limit_count
         if (.not. verdict%not_checked(i) .or. any(by_yield == i)) cycle
         if (text /= '') text = text//', '
         text = text//trim(limit_title(i))
      end do
   end function unchecked_text

   !> Names of the limits that were not checked as files have them, blanks between them.
   pure function unchecked_codes(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, every_limit_count
         if (.not. verdict%not_checked(i)) cycle
         if (text /= '') text = text//' '
         text = text//trim(limit_code(i))
      end do
   end function unchecked_codes
end module dg_verdict_text
