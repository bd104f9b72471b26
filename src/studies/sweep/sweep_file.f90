!> sweep_<name>.csv: one row per point, curve after curve.
module dg_sweep_file
   use dg_case_result, only: has_numbers, result_status_name
   use dg_column, only: add, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_percent, &
                        quantity_text, row_type
   use dg_comparison, only: as_measured, percent_error
   use dg_job, only: model_name
   use dg_load_case, only: operation_name
   use dg_missing, only: given, optional_real
   use dg_sweep, only: measured_at, measured_type, point_type, sweep_type
   use dg_sweep_result, only: answer_of, sweep_result_type
   use dg_text, only: text_or_nothing
   use dg_verdict, only: answer_name, limit_code
   implicit none
   private
   public :: sweep_row

contains

   !> A point in the columns of the file. New columns are put at the end only: others rely on the names and the order.
   pure function sweep_row(sweep, point, result) result(row)
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(sweep_result_type), intent(in) :: result
      type(row_type) :: row
      type(optional_real) :: error, friction_cased
      type(measured_type) :: measured
      measured = measured_at(sweep, point)
      if (has_numbers(result%status)) error = percent_error(as_measured(result%hookload, result%weight_indicator), &
                               measured%hookload)
      if (allocated(sweep%frictions_cased)) friction_cased = given(sweep%frictions_cased(point%friction))
      call add(row, 'model', quantity_text, 'as in summary.csv', model_name(sweep%models(point%model)))
      call add(row, 'operation', quantity_text, 'long name of the operation', operation_name(sweep%operations(point%operation)))
      call add(row, 'friction', quantity_none, &
               'friction factor along and around the hole; empty: those of the hole sections', sweep%frictions(point%friction))
      call add(row, 'bit_depth', quantity_length, 'measured depth of the bit', sweep%depths(point%depth))
      call add(row, 'hookload', quantity_force, &
               'as in summary.csv', optional_real(has_numbers(result%status), result%hookload))
      call add(row, 'torque', quantity_moment, &
               'at the top, bit torque included', optional_real(has_numbers(result%status), result%torque))
      call add(row, 'status', quantity_text, &
               'converged, not_converged or locked_up: only the first is a solution', result_status_name(result%status))
      call add(row, 'measured_hookload', quantity_force, 'measured hook load of the load case with this operation, depth and '// &
               'string', &
               measured%hookload)
      call add(row, 'measured_torque', quantity_moment, 'measured torque of that load case', measured%torque)
      call add(row, 'error', quantity_percent, '100 |hookload - measured| / measured; with &rig of weight_indicator', error)
      call add(row, 'message', quantity_text, &
               'reason of a missing solution, else warnings', text_or_nothing(result%message))
      call add(row, 'weight_indicator', quantity_force, &
               'reading of the weight indicator, as in summary.csv', result%weight_indicator)
      call add(row, 'friction_cased', quantity_none, &
               'friction factor of cased sections, if given; friction is then that of the others', friction_cased)
      call add(row, 'rig_margin', quantity_force, &
               'max_hookload of the rig (rig_limit) - hook load - block_weight', result%rig_margin)
      call add(row, 'torque_margin', quantity_moment, 'max_torque of the rig - torque', result%torque_margin)
      call add(row, 'overpull_margin', quantity_force, &
               'pull that may be added until the weakest part yields, if all of it came there; design factors included, by the '// &
               'soft string; empty without yield', &
               result%overpull_margin)
      call add(row, 'settings', quantity_text, &
               'settings of the solver; empty: those of the deck; earlier: solved before --again', &
               merge('earlier', '       ', result%earlier))
      call add(row, 'can_be_done', quantity_text, &
               'as in summary.csv, without fatigue; strengths by forces of the soft string', &
               answer_name(answer_of(result)))
      call add(row, 'limit', quantity_text, 'limit that is passed', limit_code(result%limit))
   end function sweep_row
end module dg_sweep_file
