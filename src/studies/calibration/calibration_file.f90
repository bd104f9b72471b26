!> Rows of calibration.csv: one a factor; calibration_data.csv: one row a measured number, calculated before and after.
module dg_calibration_file
   use dg_kinds, only: wp
   use dg_calibration, only: calibration_type, hookload_datum, parameter_name, predicts, torque_datum
   use dg_calibration_result, only: calibration_result_type, verdict_name, verdict_of
   use dg_column, only: add, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_percent, quantity_text, &
                        row_type
   use dg_csv_table, only: add_row, csv_table_type, is_begun, write_table
   use dg_comparison, only: percent_error
   use dg_error, only: error_type, join_error
   use dg_factor_columns, only: estimate_type, factor_file, factor_row, found_type
   use dg_job, only: job_type, model_name
   use dg_load_case, only: operation_name
   use dg_least_squares, only: fit_done
   use dg_missing, only: given, is_missing, missing, optional_real
   use dg_model, only: model_type
   use dg_prediction_table, only: add_predictions
   implicit none
   private
   public :: datum_row, write_calibrations

contains

   !> Writes all files.
   subroutine write_calibrations(job, model, calibrations, owner, results, factors, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibrations(:)
      integer, intent(in) :: owner(:)               !< number of the calibration of each result
      type(calibration_result_type), intent(in) :: results(:)
      type(csv_table_type), intent(inout) :: factors   !< rows of calibration.csv
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: data, predictions
      integer :: i, k
      do i = 1, size(results)
         associate (calibration => calibrations(owner(i)))
            if (predicts(calibration)) call add_predictions(job, model, calibration, results(i), predictions)
            do k = 1, size(calibration%unknowns)
               call add_row(factors, found_row(model, calibration, results(i), k), job%units)
            end do
            do k = 1, size(calibration%data)
               call add_row(data, datum_row(model, calibration, results(i), k), job%units)
            end do
         end associate
      end do
      call write_one(factors, factor_file)
      if (size(results) > 0) call write_one(data, 'calibration_data.csv')
      if (is_begun(predictions)) call write_one(predictions, 'calibration_prediction.csv')

   contains

      !> The error names every file that could not be written.
      subroutine write_one(table, name)
         type(csv_table_type), intent(in) :: table
         character(*), intent(in) :: name
         type(error_type), allocatable :: failure
         call write_table(table, job%output_dir//'/'//name, failure)
         call join_error(error, failure)
      end subroutine write_one
   end subroutine write_calibrations

   !> Result of an unknown in the columns of calibration.csv.
   function found_row(model, calibration, result, unknown) result(row)
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: unknown
      type(row_type) :: row
      type(found_type) :: found
      type(estimate_type) :: estimate
      estimate%value = result%fit%unknowns(unknown)
      estimate%half_width = result%statistics%half_width(unknown)
      found%calibration = calibration%name
      found%model = model_name(result%model)
      associate (one => calibration%unknowns(unknown))
         if (one%hole > 0) found%hole = model%holes(one%hole)%name
         if (one%operation > 0) found%operation = operation_name(one%operation)
         found%bit_depth = one%bit_depth
         if (one%is_offset) then
            found%parameter = 'hookload_offset'
            found%offset = estimate
         else
            found%parameter = parameter_name(calibration%parameter)
            found%start = result%start(unknown)
            found%factor = estimate
            found%factor%deviation = result%statistics%deviation(unknown)
            if (calibration%apply .and. result%fit%status == fit_done .and. .not. result%fit%unfelt(unknown)) &
               found%applied = estimate%value
         end if
      end associate
      found%verdict = verdict_name(verdict_of(result, unknown))
      found%scatter = result%statistics%scatter
      found%message = result%message
      found%hookload_deviation = result%deviations(hookload_datum)
      found%torque_deviation = result%deviations(torque_datum)
      row = factor_row(found)
   end function found_row

   !> A measured number in the columns of calibration_data.csv.
   pure function datum_row(model, calibration, result, number) result(row)
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: number
      type(row_type) :: row
      real(wp) :: after
      type(optional_real) :: residual
      logical :: hooks
      after = missing
      if (result%fit%status == fit_done) after = result%fit%values(number)
      hooks = calibration%data(number)%kind == hookload_datum
      associate (datum => calibration%data(number), before => result%before(number), &
                 case => model%cases(calibration%cases(calibration%data(number)%case)))
         call add(row, 'calibration', quantity_text, 'its name', calibration%name)
         call add(row, 'model', quantity_text, 'as in summary.csv', model_name(result%model))
         call add(row, 'case', quantity_text, 'load case that was measured', case%name)
         call add(row, 'operation', quantity_text, 'long name of the operation', operation_name(case%operation))
         call add(row, 'bit_depth', quantity_length, 'measured depth of the bit', case%bit_depth)
         call add(row, 'measured_hookload', quantity_force, 'empty in rows of a torque', optional_real(hooks, datum%measured))
         call add(row, 'before_hookload', quantity_force, 'calculated with the friction of the deck', optional_real(hooks, before))
         call add(row, 'after_hookload', quantity_force, 'calculated with the factors found', optional_real(hooks, after))
         call add(row, 'measured_torque', quantity_moment, 'empty in rows of a hook load', &
                  optional_real(.not. hooks, datum%measured))
         call add(row, 'before_torque', quantity_moment, 'calculated with the friction of the deck', &
                  optional_real(.not. hooks, before))
         call add(row, 'after_torque', quantity_moment, 'calculated with the factors found', optional_real(.not. hooks, after))
         call add(row, 'before_error', quantity_percent, '100 |before - measured| / measured', &
                  percent_error(before, given(datum%measured)))
         call add(row, 'after_error', quantity_percent, '100 |after - measured| / measured', &
                  percent_error(after, given(datum%measured)))
         if (.not. is_missing(after)) residual = given((after - datum%measured)/datum%deviation)
         call add(row, 'residual', quantity_none, '(after - measured) / standard deviation', residual)
      end associate
   end function datum_row
end module dg_calibration_file
