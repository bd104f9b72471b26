!> legacy_<label>.csv: another program's results beside ours, one row a model and depth.
module dg_legacy_rows
   use dg_column, only: column_type, csv_header, quantity_force, quantity_length, quantity_line_load, quantity_moment, &
                        quantity_text
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_hole_interval, only: interval_at, interval_name
   use dg_job, only: job_type, model_name
   use dg_legacy_comparison, only: comparison_type
   use dg_legacy_table, only: quantity_count
   use dg_kinds, only: wp
   use dg_number_text, only: csv_number
   use dg_text, only: append_text, text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: append_legacy_rows, legacy_columns, write_legacy_file

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

   !> Appends the rows of one model; fields of a quantity that the table has not are empty but for ours.
   subroutine append_legacy_rows(lines, units, case_name, model, comparison)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      type(comparison_type), intent(in) :: comparison
      character(:), allocatable :: row
      real(wp) :: factor(quantity_count)
      integer :: i, k
      factor = [units%force, units%moment, units%force_per_length]
      do i = 1, size(comparison%md)
         row = case_name//','//trim(model_name(model))//','//csv_number(comparison%md(i)/units%length)//','// &
            trim(interval_name(comparison%intervals(interval_at(comparison%intervals, comparison%md(i)))%kind))
         do k = 1, quantity_count
            row = row//','//csv_number(comparison%ours(i, k)/factor(k))
            if (comparison%parting(k)%present) then
               row = row//','//csv_number(comparison%theirs(i, k)/factor(k))//','// &
                  csv_number((comparison%theirs(i, k) - comparison%ours(i, k))/factor(k))
            else
               row = row//',,'
            end if
         end do
         call append_text(lines, row)
      end do
   end subroutine append_legacy_rows

   !> Writes header and rows to `path`.
   subroutine write_legacy_file(path, job, rows, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(text_type), intent(in) :: rows(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: i
      allocate (lines(0:size(rows)))
      lines(0)%text = csv_header(legacy_columns, job%units)
      do i = 1, size(rows)
         lines(i)%text = rows(i)%text
      end do
      call write_text_file(path, lines, error)
   end subroutine write_legacy_file
end module dg_legacy_rows
