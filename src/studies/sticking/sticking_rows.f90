!> Rows of calibration.csv that tell of strings that are held.
module dg_sticking_rows
   use dg_column, only: field_list_type, put, put_none
   use dg_comparison, only: difference, known
   use dg_csv_table, only: add_row, csv_table_type
   use dg_job, only: model_name
   use dg_load_case, only: operation_name
   use dg_model, only: model_type
   use dg_sticking, only: sticking_name, sticking_type
   use dg_sticking_result, only: sticking_result_type, sticking_status_name
   implicit none
   private
   public :: add_stickings

contains

   !> Puts one row a result at the end of calibration.csv.
   subroutine add_stickings(model, sticking, results, table)
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: results(:)
      type(csv_table_type), intent(inout) :: table      !< begun with `factor_columns`
      type(field_list_type) :: row
      integer :: i
      do i = 1, size(results)
         call sticking_fields(model, sticking, results(i), row)
         call add_row(table, row)
      end do
   end subroutine add_stickings

   subroutine sticking_fields(model, sticking, result, row)
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: result
      type(field_list_type), intent(inout) :: row
      row%count = 0
      associate (case => model%cases(result%case_index))
         call put(row, sticking%name)
         call put(row, trim(model_name(result%model)))
         call put(row, trim(sticking_name(sticking%kind)))
         call put_none(row)
         call put(row, trim(operation_name(case%operation)))
         call put(row, case%bit_depth)
         call put_nones(5)
         call put(row, trim(sticking_status_name(result%status)))
         call put_none(row)
         call put(row, result%message)
         call put_nones(3)
         call put(row, case%name)
         call put(row, known(result%depth))
         call put(row, known(result%depth_without_friction))
         call put(row, known(result%tension_above))
         call put(row, known(result%tension_below))
         call put(row, known(difference(result%tension_above, result%tension_below)))
         call put(row, known(result%half_width))
         call put(row, known(result%torque_above))
         call put(row, known(result%torque_below))
         call put(row, known(difference(result%torque_above, result%torque_below)))
         call put_nones(3)
      end associate
   contains
      subroutine put_nones(number)
         integer, intent(in) :: number
         integer :: i
         do i = 1, number
            call put_none(row)
         end do
      end subroutine put_nones
   end subroutine sticking_fields
end module dg_sticking_rows
