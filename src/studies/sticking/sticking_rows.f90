!> Rows of calibration.csv that tell of strings that are held.
module dg_sticking_rows
   use dg_column, only: row_type, set
   use dg_comparison, only: difference, known
   use dg_csv_table, only: add_row, csv_table_type
   use dg_factor_columns, only: factor_row
   use dg_job, only: model_name
   use dg_load_case, only: given, load_case_type, operation_name
   use dg_model, only: model_type
   use dg_sticking, only: sticking_name, sticking_type
   use dg_sticking_result, only: sticking_result_type, sticking_status_name
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: add_stickings

contains

   !> Puts one row a result at the end of calibration.csv.
   subroutine add_stickings(model, units, sticking, results, table)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: results(:)
      type(csv_table_type), intent(inout) :: table
      integer :: i
      do i = 1, size(results)
         call add_row(table, sticking_row(model%cases(results(i)%case_index), sticking, results(i)), units)
      end do
   end subroutine add_stickings

   function sticking_row(load_case, sticking, result) result(row)
      type(load_case_type), intent(in) :: load_case
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: result
      type(row_type) :: row
      row = factor_row()
      call set(row, 'calibration', sticking%name)
      call set(row, 'model', model_name(result%model))
      call set(row, 'parameter', sticking_name(sticking%kind))
      call set(row, 'operation', operation_name(load_case%operation))
      call set(row, 'bit_depth', given(load_case%bit_depth))
      call set(row, 'verdict', sticking_status_name(result%status))
      call set(row, 'message', result%message)
      call set(row, 'case', load_case%name)
      call set(row, 'depth', known(result%depth))
      call set(row, 'depth_frictionless', known(result%depth_without_friction))
      call set(row, 'tension_above', known(result%tension_above))
      call set(row, 'tension_below', known(result%tension_below))
      call set(row, 'resistance', known(difference(result%tension_above, result%tension_below)))
      call set(row, 'resistance_interval', known(result%half_width))
      call set(row, 'torque_above', known(result%torque_above))
      call set(row, 'torque_below', known(result%torque_below))
      call set(row, 'torque_resistance', known(difference(result%torque_above, result%torque_below)))
   end function sticking_row
end module dg_sticking_rows
