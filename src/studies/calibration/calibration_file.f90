!> calibration.csv: one row a factor; calibration_data.csv: one row a measured number, calculated before and after.
module dg_calibration_file
   use dg_kinds, only: wp
   use dg_calibration, only: applied_factor, calibration_type, hookload_datum, parameter_name, predicts, torque_datum
   use dg_calibration_result, only: calibration_result_type, verdict_name, verdict_of
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_force, quantity_length, &
                        quantity_moment, quantity_none, quantity_percent, quantity_text
   use dg_csv_table, only: add_row, add_rows_of, begin_table, csv_table_type, is_begun, write_table
   use dg_comparison, only: difference, known, percent_error
   use dg_error, only: add_error, error_type
   use dg_job, only: job_type, model_name
   use dg_load_case, only: given, operation_name
   use dg_least_squares, only: fit_done
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_prediction_table, only: add_predictions
   implicit none
   private
   public :: factor_columns, datum_columns, write_calibrations

   !> New ones are added at the end only: others rely on the names and the order.
   type(column_type), parameter :: factor_columns(30) = [ &
      column_type('calibration', quantity_text, 'its name'), &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('parameter', quantity_text, &
         'friction, friction_axial, friction_rotary, hookload_offset, sticking or free_point'), &
      column_type('hole', quantity_text, 'hole section that it is for; empty: all named'), &
      column_type('operation', quantity_text, 'operation that it is for; empty: all'), &
      column_type('bit_depth', quantity_length, 'depth of the bit that it is for; empty: all'), &
      column_type('start', quantity_none, 'the factor as the deck has it (mean over cases and sections)'), &
      column_type('value', quantity_none, 'the factor that fits best'), &
      column_type('lower', quantity_none, 'lower end of its 95 % confidence interval; empty: not known'), &
      column_type('upper', quantity_none, 'upper end'), &
      column_type('deviation', quantity_none, 'standard deviation'), &
      column_type('verdict', quantity_text, &
         'found, at_bound (0 or 2; sticking: too little torque), not_felt (data do not depend on it), not_separated '// &
         '(data tell only a mixture), no_fit, no_solution; below_bit: the string is free'), &
      column_type('scatter', quantity_none, &
         'of all residuals over standard deviations (of the deck, else 2 % of the mean); about 1 where these are right'), &
      column_type('message', quantity_text, 'why there is no fit'), &
      column_type('offset', quantity_force, 'what the gauge shows beyond string and block, in rows of a hookload_offset'), &
      column_type('offset_lower', quantity_force, 'lower end of its 95 % confidence interval'), &
      column_type('offset_upper', quantity_force, 'upper end'), &
      column_type('case', quantity_text, 'load case, in rows of sticking and free_point (its second pull)'), &
      column_type('depth', quantity_length, 'of the stuck point, as given (sticking) or found with friction (free_point)'), &
      column_type('depth_frictionless', quantity_length, 'free point by the usual formula, without friction'), &
      column_type('tension_above', quantity_force, 'in the string just above the stuck point'), &
      column_type('tension_below', quantity_force, 'there if nothing stuck'), &
      column_type('resistance', quantity_force, 'above less below: > 0 holds the string down, < 0 up'), &
      column_type('resistance_interval', quantity_force, 'half its 95 % interval, from hookload_deviation alone'), &
      column_type('torque_above', quantity_moment, 'in the string just above the stuck point'), &
      column_type('torque_below', quantity_moment, 'there if nothing stuck'), &
      column_type('torque_resistance', quantity_moment, 'above less below'), &
      column_type('applied', quantity_none, 'the factor that the rest of the run used; empty: that of the deck'), &
      column_type('hookload_deviation', quantity_force, 'standard deviation of hook loads by the residuals'), &
      column_type('torque_deviation', quantity_moment, 'of torques')]

   type(column_type), parameter :: datum_columns(14) = [ &
      column_type('calibration', quantity_text, 'its name'), &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('case', quantity_text, 'load case that was measured'), &
      column_type('operation', quantity_text, 'long name of the operation'), &
      column_type('bit_depth', quantity_length, 'measured depth of the bit'), &
      column_type('measured_hookload', quantity_force, 'empty in rows of a torque'), &
      column_type('before_hookload', quantity_force, 'calculated with the friction of the deck'), &
      column_type('after_hookload', quantity_force, 'calculated with the factors found'), &
      column_type('measured_torque', quantity_moment, 'empty in rows of a hook load'), &
      column_type('before_torque', quantity_moment, 'calculated with the friction of the deck'), &
      column_type('after_torque', quantity_moment, 'calculated with the factors found'), &
      column_type('before_error', quantity_percent, '100 |before - measured| / measured'), &
      column_type('after_error', quantity_percent, '100 |after - measured| / measured'), &
      column_type('residual', quantity_none, '(after - measured) / standard deviation')]

contains

   !> Writes all files.
   subroutine write_calibrations(job, model, owner, results, others, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: owner(:)               !< number of the calibration of each result
      type(calibration_result_type), intent(in) :: results(:)
      type(csv_table_type), intent(in) :: others    !< rows of calibration.csv that follow
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: factors, data, predictions
      type(field_list_type) :: row
      integer :: i, k
      call begin_table(factors, factor_columns, job%units)
      call begin_table(data, datum_columns, job%units)
      do i = 1, size(results)
         associate (calibration => job%calibrations(owner(i)))
            if (predicts(calibration)) call add_predictions(job, model, calibration, results(i), predictions)
            do k = 1, size(calibration%unknowns)
               call factor_fields(model, calibration, results(i), k, row)
               call add_row(factors, row)
            end do
            do k = 1, size(calibration%data)
               call datum_fields(model, calibration, results(i), k, row)
               call add_row(data, row)
            end do
         end associate
      end do
      call add_rows_of(others, factors)
      call write_one(factors, 'calibration.csv')
      if (size(results) > 0) call write_one(data, 'calibration_data.csv')
      if (is_begun(predictions)) call write_one(predictions, 'calibration_prediction.csv')

   contains

      !> The error names every file that could not be written.
      subroutine write_one(table, name)
         type(csv_table_type), intent(in) :: table
         character(*), intent(in) :: name
         type(error_type), allocatable :: failure
         call write_table(table, job%output_dir//'/'//name, failure)
         call add_error(error, failure)
      end subroutine write_one
   end subroutine write_calibrations

   subroutine factor_fields(model, calibration, result, unknown, row)
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: unknown
      type(field_list_type), intent(inout) :: row
      integer :: i
      row%count = 0
      call put(row, calibration%name)
      call put(row, trim(model_name(result%model)))
      if (calibration%unknowns(unknown)%is_offset) then
         call put(row, 'hookload_offset')
      else
         call put(row, trim(parameter_name(calibration%parameter)))
      end if
      associate (one => calibration%unknowns(unknown), value => result%fit%unknowns(unknown), &
                 half => result%statistics%half_width(unknown))
         if (one%hole > 0) then
            call put(row, model%holes(one%hole)%name)
         else
            call put_none(row)
         end if
         if (one%operation > 0) then
            call put(row, trim(operation_name(one%operation)))
         else
            call put_none(row)
         end if
         call put(row, one%bit_depth)
         if (one%is_offset) then
            do i = 1, 5
               call put_none(row)
            end do
         else
            call put(row, result%start(unknown))
            call put_interval(row, value, half)
            call put(row, known(result%statistics%deviation(unknown)))
         end if
         call put(row, trim(verdict_name(verdict_of(result, unknown))))
         call put(row, known(result%statistics%scatter))
         call put(row, result%message)
         if (one%is_offset) then
            call put_interval(row, value, half)
         else
            do i = 1, 3
               call put_none(row)
            end do
         end if
         do i = row%count + 1, size(factor_columns) - 3
            call put_none(row)
         end do
         if (calibration%apply .and. result%fit%status == fit_done .and. .not. (one%is_offset .or. result%fit%unfelt(unknown))) then
            call put(row, applied_factor(value))
         else
            call put_none(row)
         end if
         call put(row, known(result%deviations(hookload_datum)))
         call put(row, known(result%deviations(torque_datum)))
      end associate
   end subroutine factor_fields

   !> A value and the ends of its interval.
   pure subroutine put_interval(row, value, half)
      type(field_list_type), intent(inout) :: row
      real(wp), intent(in) :: value, half      !< `half` may be missing
      call put(row, value)
      call put(row, known(difference(value, half)))
      call put(row, known(difference(value, difference(0.0_wp, half))))
   end subroutine put_interval

   subroutine datum_fields(model, calibration, result, number, row)
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: number
      type(field_list_type), intent(inout) :: row
      real(wp) :: after
      integer :: i
      row%count = 0
      after = missing
      if (result%fit%status == fit_done) after = result%fit%values(number)
      associate (datum => calibration%data(number), before => result%before(number))
         associate (case => model%cases(calibration%cases(datum%case)))
            call put(row, calibration%name)
            call put(row, trim(model_name(result%model)))
            call put(row, case%name)
            call put(row, trim(operation_name(case%operation)))
            call put(row, case%bit_depth)
         end associate
         if (datum%kind /= hookload_datum) then
            do i = 1, 3
               call put_none(row)
            end do
         end if
         call put(row, datum%measured)
         call put(row, known(before))
         call put(row, known(after))
         if (datum%kind == hookload_datum) then
            do i = 1, 3
               call put_none(row)
            end do
         end if
         call put_error(before)
         call put_error(after)
         if (is_missing(after)) then
            call put_none(row)
         else
            call put(row, (after - datum%measured)/datum%deviation)
         end if
      end associate
   contains
      subroutine put_error(calculated)
         real(wp), intent(in) :: calculated
         if (is_missing(calculated)) then
            call put_none(row)
         else
            call put(row, percent_error(calculated, given(calibration%data(number)%measured)))
         end if
      end subroutine put_error
   end subroutine datum_fields
end module dg_calibration_file
