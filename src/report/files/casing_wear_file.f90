!> casing_wear_<case>_<model>.csv: what a string that turns wears off the casing, one row a depth.
module dg_casing_wear_file
   use dg_case_result, only: case_result_type
   use dg_casing_wear, only: find_casing_wear, groove_type
   use dg_column, only: column_type, field_list_type, put, quantity_length, quantity_line_load, quantity_percent, &
                        quantity_pressure, quantity_text, quantity_width
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_load_case, only: optional_real
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   implicit none
   private
   public :: write_casing_wear

   !> New ones are added at the end only.
   type(column_type), parameter :: casing_wear_columns(7) = [ &
      column_type('md', quantity_length, 'measured depth'), &
      column_type('hole', quantity_text, 'name of the hole section'), &
      column_type('side_force', quantity_line_load, 'mean over the distance of two tool joints'), &
      column_type('groove', quantity_width, 'depth of the groove'), &
      column_type('wall_left', quantity_percent, 'of the wall as it was new'), &
      column_type('burst_left', quantity_pressure, 'burst strength left; empty where casing_yield is not given'), &
      column_type('collapse_left', quantity_pressure, 'collapse strength left, without tension')]

contains

   !> Writes the wear of the casing by `result` to `path`.
   subroutine write_casing_wear(path, job, model, result, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      type(groove_type), allocatable :: grooves(:)
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call find_casing_wear(model, result, grooves)
      call begin_table(table, casing_wear_columns, job%units)
      do i = 1, size(grooves)
         call wear_fields(model%holes(grooves(i)%hole)%name, grooves(i), row)
         call add_row(table, row)
      end do
      call write_table(table, path, error)
   end subroutine write_casing_wear

   !> Values of one groove in the order of the columns.
   pure subroutine wear_fields(hole, groove, row)
      character(*), intent(in) :: hole     !< its name
      type(groove_type), intent(in) :: groove
      type(field_list_type), intent(out) :: row
      call put(row, groove%md)
      call put(row, hole)
      call put(row, groove%side_force)
      call put(row, groove%depth)
      call put(row, 100.0_wp*groove%wall_left)
      call put(row, optional_real(.not. is_missing(groove%burst), groove%burst))
      call put(row, optional_real(.not. is_missing(groove%collapse), groove%collapse))
   end subroutine wear_fields
end module dg_casing_wear_file
