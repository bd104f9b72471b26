!> history_<case>_<model>.csv: the course of the iteration, one row an iteration.
module dg_history_file
   use dg_case_result, only: case_result_type, iteration_type, judged_name
   use dg_column, only: column_type, field_list_type, put, quantity_force, quantity_moment, &
                        quantity_none, quantity_width
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: job_type
   implicit none
   private
   public :: write_history, history_columns, history_fields

   type(column_type), parameter :: history_columns(14) = [ &
      column_type('attempt', quantity_none, 'at the case: one that fails is followed by the next; shorter elements count on'), &
      column_type('increment', quantity_none, 'load step'), &
      column_type('stage', quantity_none, 'of the mesh: one more each time that elements are cut where the string stands '// &
         'outside'), &
      column_type('iteration', quantity_none, 'counted through all attempts, load steps and stages of the mesh'), &
      column_type('residual', quantity_force, 'largest nodal force out of balance'), &
      column_type('residual', quantity_moment, 'largest nodal moment out of balance'), &
      column_type('lateral_step', quantity_width, 'largest lateral change asked for by the step that led here'), &
      column_type('viscosity', quantity_none, 'viscous stiffness that held the string back in that step, in units of '// &
         'F^2/(4 EI)'), &
      column_type('judged_by', quantity_none, 'what judged that step: start (there was none), whole (taken as it is: the '// &
         'string is in tension), energy, residual, refused (the string went back); in results.h5 1 to 5 in this order'), &
      column_type('negative_pivots', quantity_none, 'negative eigenvalues of the matrix of that step: ways in which the string '// &
         'was unstable; by linear_solver sparse where friction and torque leave the matrix symmetric, else empty'), &
      column_type('contacts', quantity_none, 'gaps that touch'), &
      column_type('flips', quantity_none, 'gaps that changed state after that step'), &
      column_type('moves', quantity_none, 'gaps that moved to another x0 after that step'), &
      column_type('hookload', quantity_force, 'hook load at this iteration')]

contains

   !> Writes the iteration history of `result` to `path`: only the header where none was kept.
   subroutine write_history(path, job, result, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call begin_table(table, history_columns, job%units)
      if (allocated(result%history)) then
         do i = 1, size(result%history)
            call history_fields(result%history(i), row)
            call add_row(table, row)
         end do
      end if
      call write_table(table, path, error)
   end subroutine write_history

   !> Values of one iteration in the order of the columns.
   pure subroutine history_fields(step, row)
      type(iteration_type), intent(in) :: step
      type(field_list_type), intent(out) :: row
      call put(row, step%attempt)
      call put(row, step%increment)
      call put(row, step%stage)
      call put(row, step%iteration)
      call put(row, step%residual_force)
      call put(row, step%residual_moment)
      call put(row, step%lateral_step)
      call put(row, step%viscosity)
      call put(row, trim(judged_name(step%judged)))
      if (step%negative_pivots >= 0) then
         call put(row, step%negative_pivots)
      else
         call put(row)
      end if
      call put(row, step%contacts)
      call put(row, step%flips)
      call put(row, step%moves)
      call put(row, step%hookload)
   end subroutine history_fields
end module dg_history_file
