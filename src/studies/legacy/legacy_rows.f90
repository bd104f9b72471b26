!> legacy_<label>.csv: another program's results beside ours, one row a model and depth.
module dg_legacy_rows
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_force, quantity_length, quantity_line_load, &
                        quantity_moment, quantity_text
   use dg_csv_table, only: add_row, csv_table_type
   use dg_hole_interval, only: interval_at, interval_name
   use dg_job, only: model_name
   use dg_legacy_comparison, only: comparison_type
   use dg_legacy_table, only: quantity_count
   implicit none
   private
   public :: add_legacy_rows, legacy_columns

   type(column_type), parameter :: legacy_columns(13) = [ &
      column_type('case', quantity_text, 'name of the load case'), &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('md', quantity_length, 'measured depth, of the other program''s row'), &
      column_type('hole', quantity_text, 'kind of hole there: vertical (to 1 deg), build, hold, drop, turn (0.25 deg/30 m '// &
         'and less is held)'), &
      column_type('axial', quantity_force, 'our axial force, between the depths of our profile'), &
      column_type('legacy_axial', quantity_force, 'the other program''s'), &
      column_type('axial_difference', quantity_force, ''), &
      column_type('torque', quantity_moment, 'our torque'), &
      column_type('legacy_torque', quantity_moment, 'the other program''s'), &
      column_type('torque_difference', quantity_moment, ''), &
      column_type('side_force', quantity_line_load, 'our normal contact force per length'), &
      column_type('legacy_side_force', quantity_line_load, 'the other program''s'), &
      column_type('side_force_difference', quantity_line_load, '')]

contains

   !> Puts the rows of one model at the end; fields of a quantity that the table has not are empty but for ours.
   pure subroutine add_legacy_rows(table, case_name, model, comparison)
      type(csv_table_type), intent(inout) :: table     !< begun with `legacy_columns`
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      type(comparison_type), intent(in) :: comparison
      type(field_list_type) :: row
      integer :: i, k
      do i = 1, size(comparison%md)
         row%count = 0
         call put(row, case_name)
         call put(row, trim(model_name(model)))
         call put(row, comparison%md(i))
         call put(row, trim(interval_name(comparison%intervals(interval_at(comparison%intervals, comparison%md(i)))%kind)))
         do k = 1, quantity_count
            call put(row, comparison%ours(i, k))
            if (comparison%parting(k)%present) then
               call put(row, comparison%theirs(i, k))
               call put(row, comparison%theirs(i, k) - comparison%ours(i, k))
            else
               call put_none(row)
               call put_none(row)
            end if
         end do
         call add_row(table, row)
      end do
   end subroutine add_legacy_rows
end module dg_legacy_rows
