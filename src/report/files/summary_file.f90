!> summary.csv: one row per case and model.
module dg_summary_file
   use dg_case_result, only: case_result_type, has_numbers, result_status_name
   use dg_column, only: add, add_filled, quantity_angle, quantity_force, quantity_length, quantity_moment, &
                        quantity_none, quantity_percent, quantity_text, quantity_time, row_type
   use dg_csv_table, only: add_row, csv_table_type, write_table
   use dg_comparison, only: as_measured, in_percent, percent_error
   use dg_error, only: error_type
   use dg_findings, only: findings_type
   use dg_job, only: model_name
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_name
   use dg_missing, only: optional_real
   use dg_named_states, only: state_elastic, state_free, state_rigid
   use dg_text, only: text_or_nothing
   use dg_unchecked_text, only: uncertain_codes, unchecked_codes
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_name, limit_code, verdict_type
   use dg_verdict_text, only: verdict_reason
   implicit none
   private
   public :: write_summary, summary_row

contains

   !> Writes summary.csv to `path`, in the order of `results`.
   subroutine write_summary(path, found, error)
      character(*), intent(in) :: path
      type(findings_type), intent(in) :: found
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      integer :: i
      do i = 1, size(found%results)
         call add_row(table, summary_row(found%model%cases(found%results(i)%case_index), found%results(i), &
                                         found%wholes(i)%verdict, found%job%units), found%job%units)
      end do
      call write_table(table, path, error)
   end subroutine write_summary

   !> A result in the columns of summary.csv, without calculated values if it did not converge. New columns are put at the end
   !> only, as others rely on the names and the order.
   pure function summary_row(load_case, result, verdict, units) result(row)
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      type(verdict_type), intent(in) :: verdict
      type(unit_system_type), intent(in) :: units     !< of the numbers in the reason
      type(row_type) :: row
      call add(row, 'case', quantity_text, 'name of the load case', load_case%name)
      call add(row, 'section', quantity_text, 'label of the hole section, as in the deck', text_or_nothing(load_case%section))
      call add(row, 'model', quantity_text, &
               'mcge (beams with contact gap elements), soft (soft string), rigid (stiff string on the hole axis) or mixed '// &
               '(stiff in places)', model_name(result%model))
      call add(row, 'operation', quantity_text, 'long name of the operation', operation_name(load_case%operation))
      call add(row, 'bit_depth', quantity_length, 'measured depth of the bit', load_case%bit_depth)
      call add(row, 'inclination', quantity_angle, 'inclination of the hole at the bit', of(result%inclination))
      call add(row, 'wob', quantity_force, 'weight on bit, as in the deck', load_case%wob)
      call add(row, 'hookload', quantity_force, &
               'hook load without block: axial force at the top, less the push of annulus pressure', of(result%hookload))
      call add(row, 'measured', quantity_force, 'measured hook load, as in the deck', load_case%measured_hookload)
      call add(row, 'error', quantity_percent, &
               '100 |hookload - measured| / measured; with &rig: 100 |weight_indicator - measured| / measured', &
               error_of(as_measured(result%hookload, result%weight_indicator), load_case%measured_hookload))
      call add(row, 'reference', quantity_force, 'hook load of another calculation, as in the deck', load_case%reference_hookload)
      call add(row, 'reference_error', quantity_percent, &
               '100 |hookload - reference| / reference', error_of(result%hookload, load_case%reference_hookload))
      call add(row, 'friction', quantity_force, &
               'frictional resistance: buoyed weight along the hole - wob - axial force at the top; negative going up, '// &
               'positive going down', of(result%friction))
      call add(row, 'torque', quantity_moment, 'torque at the top, bit torque included', of(result%torque))
      call add(row, 'normal_force', quantity_force, 'sum of the contact forces along the string', of(result%normal_force))
      call add(row, 'status', quantity_text, &
               'converged, not_converged or locked_up; only a converged case has valid numbers', result_status_name(result%status))
      call add(row, 'iterations', quantity_none, &
               'Newton iterations of all attempts and meshes; 0 for other models', result%iterations)
      call add(row, 'elements', quantity_none, 'beam elements; for other models steps of integration', result%elements)
      call add(row, 'seconds', quantity_time, 'wall time of the solution of this case', result%seconds)
      call add(row, 'measured_torque', quantity_moment, 'measured torque, as in the deck', load_case%measured_torque)
      call add(row, 'torque_error', quantity_percent, &
               '100 |torque - measured| / measured', error_of(result%torque, load_case%measured_torque))
      call add(row, 'gaps_free', quantity_none, &
               'number of free gap elements; for other models of free points of the profile', result%states(state_free))
      call add(row, 'gaps_elastic', quantity_none, 'number in elastic contact', result%states(state_elastic))
      call add(row, 'gaps_rigid', quantity_none, 'number in rigid contact', result%states(state_rigid))
      call add(row, 'flips', quantity_none, 'changes of state of gap elements in the iteration', result%flips)
      call add(row, 'moves', quantity_none, 'changes of place x0 of gap elements in the iteration', result%moves)
      call add(row, 'equilibrium', quantity_force, &
               'sum of all forces on the string, supports included: zero for an exact solution', of(result%equilibrium_force))
      call add(row, 'equilibrium', quantity_moment, &
               'sum of all moments about the top: zero for an exact solution', of(result%equilibrium_moment))
      call add(row, 'message', quantity_text, &
               'reason of a case that did not converge, else warnings', text_or_nothing(result%message))
      call add(row, 'weight_indicator', quantity_force, &
               'reading of the weight indicator, block included: too low while the block rises, too high while it is lowered, '// &
               'as in drilling; empty without &rig', result%weight_indicator)
      call add(row, 'can_be_done', quantity_text, &
               'yes: no known limit is passed; no: a limit is passed, the string locks up or needs more push than max_push; '// &
               'unknown: not_converged', answer_name(verdict%answer))
      call add_filled(row, 'reason', quantity_text, &
                      'reason of a no, with numbers; else empty', verdict_reason(units, load_case, verdict))
      call add_filled(row, 'limit', quantity_text, 'limit that decides; for yes the limit used most', limit_code(verdict%limit))
      call add(row, 'used', quantity_percent, 'used part of this limit', in_percent(verdict%used))
      call add(row, 'limit_md', quantity_length, 'depth of this limit; 0 for rig, slips and top drive; empty for a limit of '// &
               'the whole string', verdict%md)
      call add_filled(row, 'not_checked', quantity_text, &
                      'limits without a rating in one or more components, separated by blanks', unchecked_codes(verdict))
      call add(row, 'friction_reserve', quantity_none, &
               'factor on all friction at which the answer becomes no: by beams where a buckled string goes down, else by the '// &
               'soft string scaled to this result; empty for no and unknown, above 10, and for rotating beams in helical '// &
               'buckling', verdict%friction_reserve)
      call add_filled(row, 'uncertain', quantity_text, &
                      'what may turn a yes into a no: contact_force (its error), tool_joints (friction that smeared joints '// &
                      'leave out), fatigue (its limit is passed, hours unknown); else empty', uncertain_codes(verdict))
      call add(row, 'limit_iterations', quantity_none, 'Newton iterations to the friction, the wob or the bit depth at which '// &
               'string weight is just enough', result%weight_limits%iterations)
   contains
      !> A number of the result, if there is one.
      pure function of(value) result(number)
         real(wp), intent(in) :: value
         type(optional_real) :: number
         number = optional_real(has_numbers(result%status), value)
      end function of

      pure function error_of(calculated, other) result(number)
         real(wp), intent(in) :: calculated
         type(optional_real), intent(in) :: other
         type(optional_real) :: number
         if (has_numbers(result%status)) number = percent_error(calculated, other)
      end function error_of
   end function summary_row
end module dg_summary_file
