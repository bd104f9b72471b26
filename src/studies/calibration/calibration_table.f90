!> A calibration in print: factors with their intervals, measured and calculated values before and after, and in words what the
!> data cannot determine. Every line fits 120 columns.
module dg_calibration_table
   use dg_kinds, only: wp
   use dg_calibration, only: apply_factors, apply_offset, calibration_type, hookload_datum, offset_one, parameter_name, &
                             torque_datum, unknown_type
   use dg_calibration_result, only: calibration_result_type, verdict_at_bound, verdict_found, verdict_not_felt, &
      verdict_not_separated, verdict_of
   use dg_comparison, only: difference, percent_error
   use dg_job, only: model_name
   use dg_deck_echo, only: hole_friction_text
   use dg_learnt_friction, only: learn_friction
   use dg_least_squares, only: fit_done
   use dg_load_case, only: block_way, operation_label
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: copy_without_cases, model_type
   use dg_number_text, only: append_wrapped, fixed_text
   use dg_prediction_table, only: append_predictions, quantity_words, interval_text
   use dg_text, only: append_text, either, text_type, to_text
   use dg_text_table, only: add_cell, add_right, append_table, end_row, text_table_type
   use dg_unit_kind, only: in_units, unit_force, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: calibration_table, unknown_text

   integer, parameter :: label_width = 46, cell_width = 10, name_width = 26, quantity_width = 18, interval_width = 20
   integer, parameter :: remark_width = 18
   real(wp), parameter :: one = 1.0_wp
   integer, parameter :: depth_digits = 7, factor_digits = 4

contains

   !> Lines of the table of a calibration by one model.
   function calibration_table(units, model, calibration, result) result(lines)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(text_type), allocatable :: lines(:)
      allocate (lines(0))
      call append_text(lines, '')
      call append_text(lines, 'Calibration '//calibration%name//', model '//trim(model_name(result%model))//': '// &
                       trim(parameter_name(calibration%parameter))//' from '//to_text(size(calibration%data))// &
                       ' measured values of '//to_text(size(calibration%cases))//' load cases')
      if (result%fit%status /= fit_done) then
         call append_text(lines, 'No fit: '//result%message)
         return
      end if
      call append_factors(lines, units, model, calibration, result)
      call append_data(lines, units, model, calibration, result)
      call append_warnings(lines, units, model, calibration, result)
      call append_succession(lines, calibration, result)
      if (allocated(result%prediction%values)) call append_predictions(lines, units, model, calibration, result)
      if (calibration%apply) call append_applied(lines, units, model, calibration, result)
      if (calibration%apply) call append_learnt(lines, calibration, result, size(model%holes))
      call append_text(lines, to_text(result%fit%iterations)//' iterations, '//to_text(result%solutions)//' solutions, '// &
                       to_text(result%seconds, 3)//' s')
   end function calibration_table

   !> The factors.
   subroutine append_factors(lines, units, model, calibration, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(text_table_type) :: table
      character(:), allocatable :: remark
      real(wp) :: unit
      integer :: k, decimals
      do k = 1, size(calibration%unknowns)
         associate (value => result%fit%unknowns(k), half => result%statistics%half_width(k))
            unit = merge(units%force, one, calibration%unknowns(k)%is_offset)
            decimals = merge(1, factor_digits, calibration%unknowns(k)%is_offset)
            remark = ''
            select case (verdict_of(result, k))
            case (verdict_at_bound); remark = 'at its bound'
            case (verdict_not_felt); remark = 'not determined'
            case (verdict_not_separated); remark = 'not separated'
            case (verdict_found)
               if (is_missing(half)) then
                  remark = 'too few values'
                  if (result%statistics%freedom > 0) remark = 'exact fit'
               else if (half >= abs(value)) then
                  remark = 'may be zero'
               end if
            case default
            end select
            call add_cell(table, 'Friction factor', label_width, unknown_text(units, model, calibration%unknowns(k)))
            call add_cell(table, 'In deck', cell_width, result%start(k), unit, decimals)
            call add_cell(table, 'Found', cell_width, value, unit, decimals)
            call add_right(table, '95 % interval', interval_width, &
                           interval_text(value, half, unit, decimals, least=merge(-huge(one), 0.0_wp, &
                                                                                  calibration%unknowns(k)%is_offset)))
            call add_cell(table, 'Remark', remark_width, remark)
            call end_row(table, '')
         end associate
      end do
      call append_table(lines, table)
   end subroutine append_factors

   !> Append measured values, and those calculated before and after.
   subroutine append_data(lines, units, model, calibration, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(text_table_type) :: table
      type(optional_real) :: errors(2)
      character(:), allocatable :: some_lost
      real(wp) :: unit, sums(2), worst(2)
      integer :: d, counted(2), decimals
      sums = 0.0_wp
      worst = 0.0_wp
      counted = 0
      do d = 1, size(calibration%data)
         associate (datum => calibration%data(d))
            unit = merge(units%force, units%moment, datum%kind == hookload_datum)
            decimals = merge(1, 2, datum%kind == hookload_datum)
            errors(1) = percent_error(result%before(d), given(datum%measured))
            errors(2) = percent_error(result%fit%values(d), given(datum%measured))
            where (errors%present)
               sums = sums + errors%value
               worst = max(worst, errors%value)
               counted = counted + 1
            end where
            call add_cell(table, 'Load case', name_width, model%cases(calibration%cases(datum%case))%name)
            call add_cell(table, 'Quantity', quantity_width, quantity_words(units, datum%kind))
            call add_cell(table, 'Measured', cell_width, datum%measured, unit, decimals)
            call add_cell(table, 'Before', cell_width, result%before(d), unit, decimals)
            call add_cell(table, 'Error %', cell_width, errors(1), one, 2)
            call add_cell(table, 'After', cell_width, result%fit%values(d), unit, decimals)
            call add_cell(table, 'Error %', cell_width, errors(2), one, 2)
            call add_cell(table, 'Off by', cell_width, difference(result%fit%values(d), datum%measured), unit, decimals)
            call end_row(table, '')
         end associate
      end do
      call append_table(lines, table)
      if (all(counted > 0)) then
         sums = sums/real(counted, wp)
         some_lost = ''
         if (counted(1) < counted(2)) some_lost = ' ('//to_text(counted(2) - counted(1))//' without solution)'
         call append_text(lines, 'Error of '//to_text(counted(2))//' values before'//some_lost//': mean '// &
            fixed_text(sums(1), 2)//' %, worst '// &
            fixed_text(worst(1), 2)//' %; after: mean '//fixed_text(sums(2), 2)//' %, worst '//fixed_text(worst(2), 2)//' %')
      end if
   end subroutine append_data

   !> Append warnings: unknowns that the data do not determine, and errors too large for the model.
   subroutine append_warnings(lines, units, model, calibration, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      real(wp), parameter :: misfit = 2.0_wp, near_block = 0.25_wp
      logical :: unknown_error(size(calibration%unknowns))
      real(wp) :: scatter
      integer :: k, j
      do k = 1, size(calibration%unknowns)
         if (verdict_of(result, k) == verdict_not_felt) call append_text(lines, 'Warning: the measurements do not depend on '// &
            'friction of '//unknown_text(units, model, calibration%unknowns(k))//'; it stays as the deck has it')
         if (verdict_of(result, k) == verdict_at_bound) call append_wrapped(lines, 'Warning: '// &
            unknown_text(units, model, calibration%unknowns(k))//': the measurements ask for friction '// &
            either('below', 'above', .not. result%fit%unknowns(k) > 0.0_wp)//' '// &
            to_text(result%fit%unknowns(k), factor_digits)//'; look for another cause: weight of the block, mud, '// &
            'gauge, or one section that takes the friction of another (separate = ''none'' finds one factor for all)')
         if (verdict_of(result, k) /= verdict_not_felt .and. calibration%unknowns(k)%is_offset) then
            if (abs(result%fit%unknowns(k) + model%rig%block_weight) < near_block*model%rig%block_weight) &
               call append_text(lines, 'Warning: the offset is about minus the block weight: are the measured hook loads '// &
                                'without the block? Then leave out block_weight of &rig')
         end if
      end do
      call append_wrapped(lines, one_sided_text(units, model, calibration, result))
      if (result%apart) call append_wrapped(lines, 'Warning: hook loads and torques do not agree: each alone asks for other '// &
         'friction. Do not use the factors found. Calibrate friction_axial from hook loads and friction_rotary from torques '// &
         "apart: two &calibrate, parameter = 'friction_axial' and parameter = 'friction_rotary'")
      do k = 1, size(result%statistics%mixtures)
         associate (mixture => result%statistics%mixtures(k))
            call append_text(lines, 'Warning: the measurements cannot tell these factors apart. Each of them may be wrong, '// &
               'together they fit:')
            do j = 1, size(mixture%unknowns)
               call append_text(lines, '         '//unknown_text(units, model, calibration%unknowns(mixture%unknowns(j))))
            end do
            if (result%apart) cycle            ! one factor for all fits even less
            call append_text(lines, '         measure at other depths or in other operations, or find one factor for all '// &
               '(separate = ''none'')')
         end associate
      end do
      if (result%halvings > 0) call append_text(lines, 'Note: not every load case has a solution with the factors of the deck; '// &
         'the fit began with these divided by '//to_text(2**result%halvings))
      if (result%statistics%freedom == 0) call append_text(lines, 'Note: as many factors as measured values: the fit is '// &
         'exact and proves nothing')
      unknown_error = [(verdict_of(result, k) == verdict_found .and. is_missing(result%statistics%half_width(k)), &
                        k=1, size(calibration%unknowns))]
      if (any(unknown_error) .and. result%statistics%freedom > 0) call append_text(lines, 'Note: the measured values are met '// &
         'to round-off, which tells nothing of their error; give '//deviations_wanted(calibration))
      scatter = result%statistics%scatter
      if (all(.not. is_missing(result%deviations))) then
         call append_text(lines, 'Standard deviations by the residuals: '//quantity_words(units, hookload_datum)//': '// &
            to_text(result%deviations(hookload_datum)/units%force, 3)//'; '//quantity_words(units, torque_datum)//': '// &
            to_text(result%deviations(torque_datum)/units%moment, 3))
         scatter = maxval(result%scatters, mask=[calibration%hookload_deviation%present, calibration%torque_deviation%present])
      end if
      if (scatter > misfit .and. (calibration%hookload_deviation%present .or. &
          calibration%torque_deviation%present)) call append_text(lines, 'Warning: residuals are '// &
         to_text(scatter, 2)//' times the standard deviations given: friction alone does not explain '// &
         'what was measured')
   end subroutine append_warnings

   !> Warning that all measured hook loads are above the fit, or all below; '' if not. More friction raises the hook loads of
   !> strings that are pulled, and lowers those of strings that go down. So friction is not the reason.
   function one_sided_text(units, model, calibration, result) result(text)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      character(:), allocatable :: text
      integer, parameter :: enough = 3         ! values
      real(wp), parameter :: apart = 0.25_wp   ! the least difference over the largest one, which scatter does not reach
      logical :: weighed(size(calibration%data))
      real(wp) :: above(size(calibration%data)), least, most
      integer :: way(size(calibration%data)), d
      text = ''
      weighed = calibration%data%kind == hookload_datum
      if (any(calibration%unknowns%is_offset) .or. count(weighed) < enough) return
      above = calibration%data%measured - result%fit%values
      way = [(block_way(model%cases(calibration%cases(calibration%data(d)%case))%operation), d=1, size(way))]
      if (.not. (any(way > 0 .and. weighed) .and. any(way < 0 .and. weighed))) return
      least = minval(abs(above), mask=weighed)
      most = maxval(abs(above), mask=weighed)
      if (least < apart*most .or. any(weighed .and. above > 0.0_wp) .eqv. any(weighed .and. above < 0.0_wp)) return
      text = 'Warning: all '//to_text(count(weighed))//' measured hook loads are '//fixed_text(least/units%force, 1)//' to '// &
             fixed_text(most/units%force, 1)//' '//trim(units%force_label)//' '// &
             either('above', 'below', any(weighed .and. above > 0.0_wp))//' those found, pulled and lowered alike. Friction '// &
             'does not do that. Set offset = ''one'' in &calibrate, or check block_weight and the density of the mud'
   end function one_sided_text

   !> Keys of the gauges whose standard deviation is not given.
   pure function deviations_wanted(calibration) result(keys)
      type(calibration_type), intent(in) :: calibration
      character(:), allocatable :: keys
      keys = ''
      if (any(calibration%data%kind == hookload_datum) .and. .not. calibration%hookload_deviation%present) &
         keys = 'hookload_deviation'
      if (any(calibration%data%kind == torque_datum) .and. .not. calibration%torque_deviation%present) then
         if (keys /= '') keys = keys//' and '
         keys = keys//'torque_deviation'
      end if
   end function deviations_wanted

   !> Report if residuals of an operation follow each other along the depth, and the effect on the intervals.
   subroutine append_succession(lines, calibration, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      if (.not. result%succession%follows) return
      call append_text(lines, 'Warning: residuals follow each other along the depth (correlation '// &
                       to_text(result%succession%observed, 2)//' from one depth to the next): something')
      call append_text(lines, '         is left that is no scatter of the gauge. Intervals allow for it: errors as alike as '// &
                       'that leave '//to_text(sum(result%freedoms), 2)//' of')
      call append_text(lines, '         '//to_text(size(calibration%data))//' values spare. Below the depths measured they '// &
                       'hold where it goes on as above')
   end subroutine append_succession

   !> Append the friction that the rest of the run uses, one line per hole section.
   subroutine append_applied(lines, units, model, calibration, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(model_type) :: applied
      character(:), allocatable :: head
      integer :: i
      logical :: weighed
      call copy_without_cases(model, applied)
      call apply_factors(calibration, result%fit%unknowns, .not. result%fit%unfelt, model%cases, applied%holes)
      call apply_offset(calibration, result%fit%unknowns, .not. result%fit%unfelt, applied%rig, weighed)
      head = 'Applied to all that follows:'
      if (any(calibration%unknowns%is_offset) .and. .not. weighed) then
         head = 'Applied to all that follows, without the offset:'
         if (calibration%offset == offset_one) call append_text(lines, 'The offset is not applied: it is added to the weight '// &
            'of the block, and the deck has no &rig block_weight.')
      end if
      call append_text(lines, head)
      do i = 1, size(calibration%holes)
         associate (hole => applied%holes(calibration%holes(i)))
            call append_text(lines, '  '//hole%name//': '//hole_friction_text(hole)//bound_text(calibration%holes(i)))
         end associate
      end do
      if (weighed) call append_text(lines, '  &rig: block_weight '// &
         in_units(units, unit_force, applied%rig%block_weight, depth_digits)//', the offset counted in')
   contains
      !> Text of a factor at its bound.
      function bound_text(hole) result(text)
         integer, intent(in) :: hole
         character(:), allocatable :: text
         integer :: u
         text = ''
         do u = 1, size(calibration%unknowns)
            if (calibration%unknowns(u)%is_offset .or. verdict_of(result, u) /= verdict_at_bound) cycle
            if (any(calibration%unknowns(u)%hole == [0, hole])) text = ', at its bound: no measured friction'
         end do
      end function bound_text
   end subroutine append_applied

   !> Append the results that an &uncertainty of another deck may repeat.
   subroutine append_learnt(lines, calibration, result, sections)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: sections
      real(wp) :: deviations(sections), correlation(sections, sections)
      character(:), allocatable :: text
      logical :: known
      integer :: i, j
      call learn_friction(calibration, result, deviations, correlation, known)
      if (.not. known) return
      text = ''
      do i = 1, sections
         text = text//', '//fixed_text(deviations(i), 5)
      end do
      call append_text(lines, 'For &uncertainty of another deck, from the 95 % interval: friction_deviations = '//text(3:)// &
                       ", friction_parameter = '"//trim(parameter_name(calibration%parameter))//"'")
      if (sections == 1) return
      text = ''
      do i = 1, sections
         do j = i + 1, sections
            text = text//', '//fixed_text(correlation(i, j), factor_digits)
         end do
      end do
      call append_text(lines, '  friction_correlations = '//text(3:))
   end subroutine append_learnt

   !> Scope of a factor, in words.
   function unknown_text(units, model, unknown) result(text)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(unknown_type), intent(in) :: unknown
      character(:), allocatable :: text
      text = ''
      if (unknown%is_offset) text = ', hook load offset, '//trim(units%force_label)
      if (unknown%hole > 0) text = text//', '//model%holes(unknown%hole)%name
      if (unknown%operation > 0) text = text//', '//trim(operation_label(unknown%operation))
      if (unknown%bit_depth%present) text = text//', bit at '// &
         in_units(units, unit_length, unknown%bit_depth%value, depth_digits)
      if (text == '') text = ', all'
      text = text(len(', ') + 1:)
   end function unknown_text
end module dg_calibration_table
