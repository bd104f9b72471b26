!> sweep_<name>.csv: one row a point, curve after curve.
module dg_sweep_file
   use dg_kinds, only: wp
   use dg_case_result, only: has_numbers, result_status_name
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_force, quantity_length, &
                        quantity_moment, quantity_none, quantity_percent, quantity_text
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_comparison, only: as_measured, known, percent_error
   use dg_error, only: error_type
   use dg_job, only: job_type, model_name
   use dg_load_case, only: operation_name, optional_real
   use dg_sweep, only: point_at, point_type, sweep_type
   use dg_sweep_result, only: answer_of, sweep_result_type
   use dg_text, only: text_or_nothing
   use dg_verdict, only: answer_name, limit_code
   implicit none
   private
   public :: sweep_columns, write_sweep

   !> New ones are added at the end only: others rely on the names and the order.
   type(column_type), parameter :: sweep_columns(19) = [ &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('operation', quantity_text, 'long name of the operation'), &
      column_type('friction', quantity_none, 'coefficient along and around the hole; empty: those of the hole sections'), &
      column_type('bit_depth', quantity_length, 'measured depth of the bit'), &
      column_type('hookload', quantity_force, 'axial force held at the top'), &
      column_type('torque', quantity_moment, 'at the top, bit torque included'), &
      column_type('status', quantity_text, 'converged, not_converged or locked_up: only the first is a solution'), &
      column_type('measured_hookload', quantity_force, 'of the load case with this operation, depth and string'), &
      column_type('measured_torque', quantity_moment, 'the same of torque'), &
      column_type('error', quantity_percent, '100 |hookload - measured| / measured; with &rig of weight_indicator'), &
      column_type('message', quantity_text, 'reason and remedy where there is no solution, else warnings'), &
      column_type('weight_indicator', quantity_force, 'what the rig shows of the hook load, as in summary.csv'), &
      column_type('friction_cased', quantity_none, 'coefficient in cased sections, where they have their own; friction is then '// &
         'that of the others'), &
      column_type('rig_margin', quantity_force, 'max_hookload of the rig (rig_limit) - hook load - block_weight'), &
      column_type('torque_margin', quantity_moment, 'max_torque of the rig - torque'), &
      column_type('overpull_margin', quantity_force, 'pull that may be added before anything yields, by the soft string; '// &
         'empty without yield'), &
      column_type('settings', quantity_text, 'of the solver: empty for those of the deck; earlier: found before --again'), &
      column_type('can_be_done', quantity_text, 'yes: no known limit of string weight, rig or yield is passed; no; unknown: '// &
         'not_converged'), &
      column_type('limit', quantity_text, 'the one that is passed')]

contains

   !> Writes the whole of a sweep to `path`.
   subroutine write_sweep(path, job, sweep, points, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)   !< in the order of their numbers
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call begin_table(table, sweep_columns, job%units)
      do i = 1, size(points)
         call sweep_fields(sweep, point_at(sweep, i), points(i), row)
         call add_row(table, row)
      end do
      call write_table(table, path, error)
   end subroutine write_sweep

   !> Values of a point in the order of the columns.
   pure subroutine sweep_fields(sweep, point, result, row)
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(sweep_result_type), intent(in) :: result
      type(field_list_type), intent(inout) :: row
      type(optional_real) :: hookload, torque
      integer :: i
      do i = size(sweep%measured), 1, -1
         associate (measured => sweep%measured(i))
            if (measured%operation /= sweep%operations(point%operation)) cycle
            if (abs(measured%bit_depth - sweep%depths(point%depth)) > 0.0_wp) cycle
            if (measured%hookload%present) hookload = measured%hookload
            if (measured%torque%present) torque = measured%torque
         end associate
      end do
      row%count = 0
      call put(row, trim(model_name(sweep%models(point%model))))
      call put(row, trim(operation_name(sweep%operations(point%operation))))
      call put(row, sweep%frictions(point%friction))
      call put(row, sweep%depths(point%depth))
      call put(row, optional_real(has_numbers(result%status), result%hookload))
      call put(row, optional_real(has_numbers(result%status), result%torque))
      call put(row, trim(result_status_name(result%status)))
      call put(row, hookload)
      call put(row, torque)
      if (has_numbers(result%status)) then
         call put(row, percent_error(as_measured(result%hookload, result%weight_indicator), hookload))
      else
         call put_none(row)
      end if
      call put(row, text_or_nothing(result%message))
      call put(row, known(result%weight_indicator))
      if (allocated(sweep%frictions_cased)) then
         call put(row, sweep%frictions_cased(point%friction))
      else
         call put_none(row)
      end if
      call put(row, known(result%rig_margin))
      call put(row, known(result%torque_margin))
      call put(row, known(result%overpull_margin))
      call put(row, trim(merge('earlier', '       ', result%earlier)))
      call put(row, trim(answer_name(answer_of(result))))
      call put(row, trim(limit_code(result%limit)))
   end subroutine sweep_fields
end module dg_sweep_file
