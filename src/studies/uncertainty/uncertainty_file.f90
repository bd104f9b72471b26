!> uncertainty_<name>.csv: one row per point, with the quantiles of its samples.
module dg_uncertainty_file
   use dg_column, only: add, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_percent, &
                        quantity_text, row_type
   use dg_comparison, only: percent_of
   use dg_job, only: model_name
   use dg_load_case, only: operation_name
   use dg_sample_statistics, only: p10, p50, p90, point_statistics_type
   use dg_sweep, only: point_type, sweep_type
   use dg_variance_shares, only: input_density, input_friction, input_gauge, input_rest, input_survey
   implicit none
   private
   public :: uncertainty_row

contains

   !> A point in the columns of the file. New columns are put at the end only: others rely on the names and the order.
   pure function uncertainty_row(range, point, found) result(row)
      type(sweep_type), intent(in) :: range
      type(point_type), intent(in) :: point
      type(point_statistics_type), intent(in) :: found
      type(row_type) :: row
      call add(row, 'model', quantity_text, 'as in summary.csv', model_name(range%models(point%model)))
      call add(row, 'operation', quantity_text, 'long name of the operation', operation_name(range%operations(point%operation)))
      call add(row, 'bit_depth', quantity_length, 'measured depth of the bit', range%depths(point%depth))
      call add(row, 'samples', quantity_none, 'samples that have a solution', found%solved)
      call add(row, 'hookload_p10', quantity_force, &
               'hook load under which 10 % of the samples lie; empty where so many lock up', found%hookload%quantiles(p10))
      call add(row, 'hookload_p50', quantity_force, 'the same for half of them', found%hookload%quantiles(p50))
      call add(row, 'hookload_p90', quantity_force, 'the same for 90 %', found%hookload%quantiles(p90))
      call add(row, 'hookload_mean', quantity_force, 'mean of the samples that have a solution', found%hookload%mean)
      call add(row, 'hookload_deviation', quantity_force, 'their standard deviation', found%hookload%deviation)
      call add(row, 'torque_p10', quantity_moment, &
               'torque at the top under which 10 % of the samples lie', found%torque%quantiles(p10))
      call add(row, 'torque_p50', quantity_moment, 'the same for half of them', found%torque%quantiles(p50))
      call add(row, 'torque_p90', quantity_moment, 'the same for 90 %', found%torque%quantiles(p90))
      call add(row, 'torque_mean', quantity_moment, 'mean of the samples that have a solution', found%torque%mean)
      call add(row, 'torque_deviation', quantity_moment, 'their standard deviation', found%torque%deviation)
      call add(row, 'locked_up', quantity_none, &
               'samples that lock up: below all others in quantiles of the hook load, and above them in torque where the '// &
               'string turns', found%locked_up)
      call add(row, 'not_converged', quantity_none, 'samples without solution, left out of all', found%not_converged)
      call add(row, 'weight_indicator_p10', quantity_force, &
               'as hookload_p10, of what the rig shows; empty without &rig', found%weight_indicator%quantiles(p10))
      call add(row, 'weight_indicator_p50', quantity_force, &
               'the same for half of them', found%weight_indicator%quantiles(p50))
      call add(row, 'weight_indicator_p90', quantity_force, 'the same for 90 %', found%weight_indicator%quantiles(p90))
      call add(row, 'hookload_share_friction', quantity_percent, &
               'share of the variance of the hook load that friction explains', &
               percent_of(found%hookload_shares(input_friction)))
      call add(row, 'hookload_share_mud_density', quantity_percent, &
               'the same of the mud density', percent_of(found%hookload_shares(input_density)))
      call add(row, 'hookload_share_survey', quantity_percent, &
               'the same of the survey; nonlinear effects included if survey_errors is random', &
               percent_of(found%hookload_shares(input_survey)))
      call add(row, 'hookload_share_gauge', quantity_percent, &
               'the same of the gauge', percent_of(found%hookload_shares(input_gauge)))
      call add(row, 'hookload_share_rest', quantity_percent, &
               'nonlinear effects', percent_of(found%hookload_shares(input_rest)))
      call add(row, 'torque_share_friction', quantity_percent, &
               'share of the variance of the torque that friction explains', percent_of(found%torque_shares(input_friction)))
      call add(row, 'torque_share_mud_density', quantity_percent, &
               'the same of the mud density', percent_of(found%torque_shares(input_density)))
      call add(row, 'torque_share_survey', quantity_percent, &
               'the same of the survey; nonlinear effects included if survey_errors is random', &
               percent_of(found%torque_shares(input_survey)))
      call add(row, 'torque_share_gauge', quantity_percent, &
               'the same of the gauge', percent_of(found%torque_shares(input_gauge)))
      call add(row, 'torque_share_rest', quantity_percent, &
               'nonlinear effects', percent_of(found%torque_shares(input_rest)))
   end function uncertainty_row
end module dg_uncertainty_file
