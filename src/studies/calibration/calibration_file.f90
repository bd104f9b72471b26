!> Rows of calibration.csv: one a factor; calibration_data.csv: one row a measured number, calculated before and after.
module dg_calibration_file
   use dg_kinds, only: wp
   use dg_calibration, only: applied_factor, calibration_type, hookload_datum, parameter_name, predicts, torque_datum
   use dg_calibration_result, only: calibration_result_type, verdict_name, verdict_of
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_force, quantity_length, &
                        quantity_moment, quantity_none, quantity_percent, quantity_text
   use dg_csv_table, only: add_row, begin_table, csv_table_type, is_begun, write_table
   use dg_comparison, only: difference, known, percent_error
   use dg_error, only: add_error, error_type
   use dg_factor_columns, only: factor_columns, factor_file
   use dg_job, only: job_type, model_name
   use dg_load_case, only: given, operation_name
   use dg_least_squares, only: fit_done
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_prediction_table, only: add_predictions
   implicit none
   private
   public :: datum_columns, write_calibrations

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
   subroutine write_calibrations(job, model, calibrations, owner, results, factors, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibrations(:)
      integer, intent(in) :: owner(:)               !< number of the calibration of each result
      type(calibration_result_type), intent(in) :: results(:)
      type(csv_table_type), intent(inout) :: factors   !< rows of calibration.csv
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: data, predictions
      type(field_list_type) :: row
      integer :: i, k
      call begin_table(data, datum_columns, job%units)
      do i = 1, size(results)
         associate (calibration => calibrations(owner(i)))
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
