!> Predictions of a calibration in print and in calibration_prediction.csv: load cases that it has not used, with the interval
!> of a single measurement. Measured values are beside them if known. Every line fits 120 columns.
module dg_prediction_table
   use dg_kinds, only: wp
   use dg_calibration, only: ahead_of, calibration_type, hookload_datum, torque_datum
   use dg_calibration_result, only: calibration_result_type
   use dg_column, only: add, quantity_force, quantity_length, quantity_moment, quantity_percent, quantity_text, row_type
   use dg_csv_table, only: add_row, begin_table, csv_table_type
   use dg_comparison, only: difference, percent_error
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, operation_count, operation_label, operation_name
   use dg_missing, only: is_missing, known, missing, optional_real
   use dg_model, only: model_type
   use dg_number_text, only: append_wrapped, fixed_text
   use dg_text, only: append_text, text_type, to_text
   use dg_text_table, only: add_cell, add_right, append_table, end_row, text_table_type
   use dg_unit_kind, only: unit_label, unit_moment
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: append_predictions, add_predictions, interval_text, quantity_words

   integer, parameter :: name_width = 24, quantity_width = 18, cell_width = 10, interval_width = 20, within_width = 7
   real(wp), parameter :: one = 1.0_wp

contains

   !> The table, and how well the predictions hold.
   subroutine append_predictions(lines, units, model, calibration, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(calibration_type) :: ahead
      type(optional_real) :: value, measured, error
      type(text_table_type) :: table
      character(:), allocatable :: verdict
      real(wp) :: unit
      integer :: d, decimals
      ahead = ahead_of(calibration, model%cases)
      do d = 1, size(ahead%data)
         associate (datum => ahead%data(d), case => model%cases(ahead%cases(ahead%data(d)%case)), &
                    half => result%prediction%half_width(d))
            unit = merge(units%force, units%moment, datum%kind == hookload_datum)
            decimals = merge(1, 2, datum%kind == hookload_datum)
            value = known(result%prediction%values(d))
            measured = measured_of(case, datum%kind)
            error = percent_error(result%prediction%values(d), measured)
            verdict = within(result%prediction%values(d), half, measured)
            if (verdict == 'yes') verdict = ''
            call add_cell(table, 'Predicted load case', name_width, case%name)
            call add_cell(table, 'Quantity', quantity_width, quantity_words(units, datum%kind))
            call add_cell(table, 'Predicted', cell_width, value, unit, decimals)
            call add_right(table, '95 % interval', interval_width, interval_text(value%value, half, unit, decimals))
            call add_cell(table, 'Measured', cell_width, measured, unit, decimals)
            call add_cell(table, 'Error %', cell_width, error, one, 2)
            call add_cell(table, 'Within', within_width, verdict)
            call end_row(table, '')
         end associate
      end do
      call append_table(lines, table)
      call append_verdict(lines, units, model, ahead, result)
      call warn_of_drift(lines, ahead, result)
   end subroutine append_predictions

   !> Warn of data that are too few to show errors that grow with depth: the intervals of predictions leave these out.
   subroutine warn_of_drift(lines, ahead, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(calibration_type), intent(in) :: ahead
      type(calibration_result_type), intent(in) :: result
      character(*), parameter :: what(hookload_datum:torque_datum) = [character(10) :: 'hook loads', 'torques']
      integer :: kind
      do kind = hookload_datum, torque_datum
         if (.not. any(ahead%data%kind == kind) .or. result%drifts(kind)%visible) cycle
         call append_wrapped(lines, 'Warning: '//trim(what(kind))//' are measured at too few depths to see errors that grow '// &
                             'with depth. The intervals leave such errors out')
      end do
   end subroutine warn_of_drift

   !> Both ends of an interval; '-' where it is not known.
   pure function interval_text(value, half, unit, decimals, least) result(text)
      real(wp), intent(in) :: value, half      !< its middle and half its width
      real(wp), intent(in) :: unit
      integer, intent(in) :: decimals
      real(wp), intent(in), optional :: least  !< below which no value is possible; absent: none
      character(:), allocatable :: text
      real(wp) :: low
      text = '-'
      if (is_missing(half)) return
      low = value - half
      if (present(least)) low = max(low, least)
      text = fixed_text(low/unit, decimals)//' to '//fixed_text((value + half)/unit, decimals)
   end function interval_text

   !> Errors of what was measured too, how many lie within their intervals, and what is left in the mean by operation.
   subroutine append_verdict(lines, units, model, ahead, result)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: ahead
      type(calibration_result_type), intent(in) :: result
      type(optional_real) :: errors(size(ahead%data)), measured(size(ahead%data))
      real(wp) :: excess(size(ahead%data))
      integer :: operation(size(ahead%data)), d, o, judged, held
      logical :: of_it(size(ahead%data))
      character(:), allocatable :: text
      judged = 0
      held = 0
      excess = 0.0_wp
      do d = 1, size(ahead%data)
         operation(d) = model%cases(ahead%cases(ahead%data(d)%case))%operation
         measured(d) = measured_of(model%cases(ahead%cases(ahead%data(d)%case)), ahead%data(d)%kind)
         if (is_missing(result%prediction%values(d))) measured(d) = optional_real()
         if (.not. measured(d)%present) cycle
         errors(d) = percent_error(result%prediction%values(d), measured(d))
         excess(d) = measured(d)%value - result%prediction%values(d)
         text = within(result%prediction%values(d), result%prediction%half_width(d), measured(d))
         if (text /= '') judged = judged + 1
         if (text == 'yes') held = held + 1
      end do
      if (.not. any(errors%present)) return
      text = to_text(count(errors%present))//' measured values predicted: mean error '// &
         fixed_text(sum(errors%value, mask=errors%present)/count(errors%present), 2)//' %, worst '// &
         fixed_text(maxval(errors%value), 2)//' %'
      if (judged > 0) text = text//'; '//to_text(held)//' of '//to_text(judged)//' within their 95 % interval'
      call append_text(lines, text)
      text = ''
      do o = 1, operation_count
         of_it = measured%present .and. operation == o .and. ahead%data%kind == hookload_datum
         if (any(of_it)) text = text//'; '//trim(operation_label(o))//' '// &
            fixed_text(sum(excess, mask=of_it)/count(of_it)/units%force, 2)
      end do
      if (text /= '') call append_text(lines, 'Measured less predicted hook load in the mean, '//trim(units%force_label)//': '// &
                                       text(len('; ') + 1:))
   end subroutine append_verdict

   !> Add the rows of a calibration at the end of calibration_prediction.csv, which is begun where it is not.
   subroutine add_predictions(job, model, calibration, result, table)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(csv_table_type), intent(inout) :: table
      type(calibration_type) :: ahead
      integer :: d
      call begin_table(table, prediction_row(calibration, result, model%cases(1), hookload_datum, missing, missing), job%units)
      if (.not. allocated(result%prediction%values)) return
      ahead = ahead_of(calibration, model%cases)
      do d = 1, size(ahead%data)
         call add_row(table, prediction_row(calibration, result, model%cases(ahead%cases(ahead%data(d)%case)), ahead%data(d)%kind, &
                                            result%prediction%values(d), result%prediction%half_width(d)), job%units)
      end do
   end subroutine add_predictions

   !> A prediction in the columns of the file. New columns are put at the end only: others rely on the names and the order.
   pure function prediction_row(calibration, result, load_case, kind, value, half) result(row)
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: kind              !< hookload_datum, torque_datum
      real(wp), intent(in) :: value, half      !< predicted, and half its interval; may be missing [N or N.m]
      type(row_type) :: row
      type(optional_real) :: measured, error
      real(wp) :: lower, upper
      logical :: hooks
      hooks = kind == hookload_datum
      measured = measured_of(load_case, kind)
      lower = difference(value, half)
      upper = difference(value, difference(0.0_wp, half))
      error = percent_error(value, measured)
      call add(row, 'calibration', quantity_text, 'its name', calibration%name)
      call add(row, 'model', quantity_text, 'as in summary.csv', model_name(result%model))
      call add(row, 'case', quantity_text, 'load case that is predicted', load_case%name)
      call add(row, 'operation', quantity_text, 'long name of the operation', operation_name(load_case%operation))
      call add(row, 'bit_depth', quantity_length, 'measured depth of the bit', load_case%bit_depth)
      call add(row, 'predicted_hookload', quantity_force, &
               'by the factors found; with &rig: weight indicator; empty in rows of a torque', merge(value, missing, hooks))
      call add(row, 'lower_hookload', quantity_force, &
               'lower end of the interval in which one measurement lies with 95 %', merge(lower, missing, hooks))
      call add(row, 'upper_hookload', quantity_force, 'upper end', merge(upper, missing, hooks))
      call add(row, 'measured_hookload', quantity_force, &
               'as in the deck; the calibration has not used it', optional_real(hooks .and. measured%present, measured%value))
      call add(row, 'predicted_torque', quantity_moment, &
               'the same of torque; empty in rows of a hook load', merge(missing, value, hooks))
      call add(row, 'lower_torque', quantity_moment, 'lower end', merge(missing, lower, hooks))
      call add(row, 'upper_torque', quantity_moment, 'upper end', merge(missing, upper, hooks))
      call add(row, 'measured_torque', quantity_moment, &
               'as in the deck', optional_real(.not. hooks .and. measured%present, measured%value))
      call add(row, 'error', quantity_percent, '100 |predicted - measured| / measured', error)
      call add(row, 'within', quantity_text, &
               'yes or no: the measured value lies in the interval; empty without a measured value', &
               within(value, half, measured))
   end function prediction_row

   !> Text on a measured value: yes if it lies in its interval, no if not. Empty where there is no value or no interval.
   pure function within(value, half, measured) result(text)
      real(wp), intent(in) :: value, half      !< of the prediction; may be missing
      type(optional_real), intent(in) :: measured
      character(:), allocatable :: text
      text = ''
      if (is_missing(half) .or. .not. measured%present) return
      text = 'no'
      if (abs(measured%value - value) <= half) text = 'yes'
   end function within

   pure function measured_of(load_case, kind) result(measured)
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: kind
      type(optional_real) :: measured
      measured = load_case%measured_torque
      if (kind == hookload_datum) measured = load_case%measured_hookload
   end function measured_of

   !> Name of what was measured, with its unit.
   pure function quantity_words(units, kind) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: kind
      character(:), allocatable :: text
      text = 'hook load, '//trim(units%force_label)
      if (kind /= hookload_datum) text = 'torque, '//unit_label(units, unit_moment)
   end function quantity_words
end module dg_prediction_table
