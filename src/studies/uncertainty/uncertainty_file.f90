!> uncertainty_<name>.csv: one row a point, with the quantiles of its samples.
module dg_uncertainty_file
   use dg_column, only: column_type, field_list_type, put, quantity_force, quantity_length, quantity_moment, quantity_none, &
                        quantity_percent, quantity_text
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_comparison, only: in_percent, known
   use dg_error, only: error_type
   use dg_job, only: job_type, model_name
   use dg_kinds, only: wp
   use dg_load_case, only: operation_name
   use dg_sample_statistics, only: distribution_type, p10, p50, p90, point_statistics_type
   use dg_sweep, only: point_at, point_type
   use dg_uncertainty, only: uncertainty_type
   implicit none
   private
   public :: uncertainty_columns, write_uncertainty

   !> New ones are added at the end only: others rely on the names and the order.
   type(column_type), parameter :: uncertainty_columns(29) = [ &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('operation', quantity_text, 'long name of the operation'), &
      column_type('bit_depth', quantity_length, 'measured depth of the bit'), &
      column_type('samples', quantity_none, 'samples that have a solution'), &
      column_type('hookload_p10', quantity_force, 'hook load under which 10 % of the samples lie; empty where so many lock up'), &
      column_type('hookload_p50', quantity_force, 'the same for half of them'), &
      column_type('hookload_p90', quantity_force, 'the same for 90 %'), &
      column_type('hookload_mean', quantity_force, 'mean of the samples that have a solution'), &
      column_type('hookload_deviation', quantity_force, 'their standard deviation'), &
      column_type('torque_p10', quantity_moment, 'torque at the top under which 10 % of the samples lie'), &
      column_type('torque_p50', quantity_moment, 'the same for half of them'), &
      column_type('torque_p90', quantity_moment, 'the same for 90 %'), &
      column_type('torque_mean', quantity_moment, 'mean of the samples that have a solution'), &
      column_type('torque_deviation', quantity_moment, 'their standard deviation'), &
      column_type('locked_up', quantity_none, 'samples that lock up: below all others in quantiles of the hook load, and above '// &
                  'them in torque where the string turns'), &
      column_type('not_converged', quantity_none, 'samples without solution, left out of all'), &
      column_type('weight_indicator_p10', quantity_force, 'as hookload_p10, of what the rig shows; empty without &rig'), &
      column_type('weight_indicator_p50', quantity_force, 'the same for half of them'), &
      column_type('weight_indicator_p90', quantity_force, 'the same for 90 %'), &
      column_type('hookload_share_friction', quantity_percent, 'share of the variance of the hook load that friction explains'), &
      column_type('hookload_share_mud_density', quantity_percent, 'the same of the mud density'), &
      column_type('hookload_share_survey', quantity_percent, 'the same of the survey; of stations each '// &
                  'on their own with what is not linear'), &
      column_type('hookload_share_gauge', quantity_percent, 'the same of the gauge'), &
      column_type('hookload_share_rest', quantity_percent, 'what is not linear, and chance'), &
      column_type('torque_share_friction', quantity_percent, 'share of the variance of the torque that friction explains'), &
      column_type('torque_share_mud_density', quantity_percent, 'the same of the mud density'), &
      column_type('torque_share_survey', quantity_percent, 'the same of the survey; of stations each '// &
                  'on their own with what is not linear'), &
      column_type('torque_share_gauge', quantity_percent, 'the same of the gauge'), &
      column_type('torque_share_rest', quantity_percent, 'what is not linear, and chance')]

contains

   !> Writes all points to `path`.
   subroutine write_uncertainty(path, job, uncertainty, statistics, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(uncertainty_type), intent(in) :: uncertainty
      type(point_statistics_type), intent(in) :: statistics(:)   !< in the order of the points' numbers
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      type(point_type) :: point
      integer :: i
      call begin_table(table, uncertainty_columns, job%units)
      do i = 1, size(statistics)
         point = point_at(uncertainty%range, i)
         row%count = 0
         call put(row, trim(model_name(uncertainty%range%models(point%model))))
         call put(row, trim(operation_name(uncertainty%range%operations(point%operation))))
         call put(row, uncertainty%range%depths(point%depth))
         call put(row, statistics(i)%solved)
         call put_distribution(row, statistics(i)%hookload)
         call put_distribution(row, statistics(i)%torque)
         call put(row, statistics(i)%locked_up)
         call put(row, statistics(i)%not_converged)
         call put(row, known(statistics(i)%weight_indicator%quantiles(p10)))
         call put(row, known(statistics(i)%weight_indicator%quantiles(p50)))
         call put(row, known(statistics(i)%weight_indicator%quantiles(p90)))
         call put_shares(row, statistics(i)%hookload_shares)
         call put_shares(row, statistics(i)%torque_shares)
         call add_row(table, row)
      end do
      call write_table(table, path, error)
   end subroutine write_uncertainty

   pure subroutine put_shares(row, shares)
      type(field_list_type), intent(inout) :: row
      real(wp), intent(in) :: shares(:)      !< [-]
      integer :: i
      do i = 1, size(shares)
         call put(row, in_percent(known(shares(i))))
      end do
   end subroutine put_shares

   pure subroutine put_distribution(row, distribution)
      type(field_list_type), intent(inout) :: row
      type(distribution_type), intent(in) :: distribution
      call put(row, known(distribution%quantiles(p10)))
      call put(row, known(distribution%quantiles(p50)))
      call put(row, known(distribution%quantiles(p90)))
      call put(row, known(distribution%mean))
      call put(row, known(distribution%deviation))
   end subroutine put_distribution
end module dg_uncertainty_file
