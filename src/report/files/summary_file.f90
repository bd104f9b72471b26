!> summary.csv: one row a case and model.
module dg_summary_file
   use dg_case_result, only: case_result_type, has_numbers, result_status_name
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_angle, quantity_force, &
                        quantity_length, quantity_moment, quantity_none, quantity_percent, quantity_text, quantity_time
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_comparison, only: as_measured, in_percent, known, percent_error
   use dg_error, only: error_type
   use dg_job, only: job_type, model_name
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_name, optional_real
   use dg_model, only: model_type
   use dg_text, only: text_or_nothing
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_name, limit_code, verdict_type
   use dg_verdict_text, only: unchecked_codes, verdict_reason
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: write_summary, summary_columns, summary_fields

   !> New ones are added at the end only: others rely on the names and the order.
   type(column_type), parameter :: summary_columns(37) = [ &
      column_type('case', quantity_text, 'name of the load case'), &
      column_type('section', quantity_text, 'its label'), &
      column_type('model', quantity_text, 'mcge (beams with contact gap elements), soft (soft string), '// &
         'rigid (stiff string on the hole axis) or mixed (stiff in places)'), &
      column_type('operation', quantity_text, 'long name of the operation'), &
      column_type('bit_depth', quantity_length, 'measured depth of the bit'), &
      column_type('inclination', quantity_angle, 'of the hole at the bit'), &
      column_type('wob', quantity_force, 'weight on bit, as in the deck'), &
      column_type('hookload', quantity_force, 'axial force held at the top'), &
      column_type('measured', quantity_force, 'measured hook load, as in the deck'), &
      column_type('error', quantity_percent, '100 |hookload - measured| / measured; with &rig: '// &
         '100 |weight_indicator - measured| / measured'), &
      column_type('reference', quantity_force, 'hook load of another calculation, as in the deck'), &
      column_type('reference_error', quantity_percent, '100 |hookload - reference| / reference'), &
      column_type('friction', quantity_force, 'frictional resistance: buoyed weight along the hole - wob - hookload; '// &
         'negative going up, positive going down'), &
      column_type('torque', quantity_moment, 'torque at the top, bit torque included'), &
      column_type('normal_force', quantity_force, 'sum of the contact forces over the string'), &
      column_type('status', quantity_text, 'converged, not_converged or locked_up: only the first is a solution'), &
      column_type('iterations', quantity_none, 'Newton iterations of all attempts and meshes of a case '// &
         'together; 0 for the other models'), &
      column_type('elements', quantity_none, 'beam elements, or steps of integration of the others'), &
      column_type('seconds', quantity_time, 'wall time of this case''s solution alone'), &
      column_type('measured_torque', quantity_moment, 'measured torque, as in the deck'), &
      column_type('torque_error', quantity_percent, '100 |torque - measured| / measured'), &
      column_type('gaps_free', quantity_none, 'gap elements (other models: points of the profile) that do not touch'), &
      column_type('gaps_elastic', quantity_none, 'in elastic contact'), &
      column_type('gaps_rigid', quantity_none, 'in rigid contact'), &
      column_type('flips', quantity_none, 'changes of state during the iteration'), &
      column_type('moves', quantity_none, 'changes of place x0 during the iteration'), &
      column_type('equilibrium', quantity_force, 'what is left of the sum of all forces on the string, supports included'), &
      column_type('equilibrium', quantity_moment, 'the same of all moments about the top'), &
      column_type('message', quantity_text, 'reason and remedy where not converged, else warnings'), &
      column_type('weight_indicator', quantity_force, 'what the rig shows: string and block, as the dead line has them; '// &
         'empty without &rig'), &
      column_type('can_be_done', quantity_text, 'yes: no known limit is passed; no: one is, or the string locks up or would '// &
         'have to be pushed; unknown: not_converged'), &
      column_type('reason', quantity_text, 'why not, with numbers; empty for yes'), &
      column_type('limit', quantity_text, 'the one that decides; for yes the one used most'), &
      column_type('used', quantity_percent, 'how much of that limit'), &
      column_type('limit_md', quantity_length, 'where; empty for string_weight and lock_up'), &
      column_type('not_checked', quantity_text, 'limits for which the deck has no rating, blanks between them'), &
      column_type('friction_reserve', quantity_none, 'factor by which all friction may grow until the answer is no, by the '// &
         'soft string scaled to this result; empty for no, and where ten times the friction is possible')]

contains

   !> Writes summary.csv to `path`, in the order of `results`.
   subroutine write_summary(path, job, model, results, wholes, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call begin_table(table, summary_columns, job%units)
      do i = 1, size(results)
         call summary_fields(model%cases(results(i)%case_index), results(i), wholes(i)%verdict, job%units, row)
         call add_row(table, row)
      end do
      call write_table(table, path, error)
   end subroutine write_summary

   !> Values of a result in the order of the columns; nothing that was calculated where it did not converge.
   pure subroutine summary_fields(load_case, result, verdict, units, row)
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      type(verdict_type), intent(in) :: verdict
      type(unit_system_type), intent(in) :: units     !< of the numbers in the reason
      type(field_list_type), intent(out) :: row
      integer :: state
      call put(row, load_case%name)
      call put(row, text_or_nothing(load_case%section))
      call put(row, trim(model_name(result%model)))
      call put(row, trim(operation_name(load_case%operation)))
      call put(row, load_case%bit_depth)
      call put(row, of(result%inclination))
      call put(row, load_case%wob)
      call put(row, of(result%hookload))
      call put(row, load_case%measured_hookload)
      call put(row, error_of(as_measured(result%hookload, result%weight_indicator), load_case%measured_hookload))
      call put(row, load_case%reference_hookload)
      call put(row, error_of(result%hookload, load_case%reference_hookload))
      call put(row, of(result%friction))
      call put(row, of(result%torque))
      call put(row, of(result%normal_force))
      call put(row, trim(result_status_name(result%status)))
      call put(row, result%iterations)
      call put(row, result%elements)
      call put(row, result%seconds)
      call put(row, load_case%measured_torque)
      call put(row, error_of(result%torque, load_case%measured_torque))
      do state = lbound(result%states, 1), ubound(result%states, 1)
         call put(row, result%states(state))
      end do
      call put(row, result%flips)
      call put(row, result%moves)
      call put(row, of(result%equilibrium_force))
      call put(row, of(result%equilibrium_moment))
      call put(row, text_or_nothing(result%message))
      call put(row, known(result%weight_indicator))
      call put(row, trim(answer_name(verdict%answer)))
      call put_text_or_none(row, verdict_reason(units, load_case, verdict))
      call put_text_or_none(row, trim(limit_code(verdict%limit)))
      call put(row, in_percent(verdict%used))
      call put(row, verdict%md)
      call put_text_or_none(row, unchecked_codes(verdict))
      call put(row, verdict%friction_reserve)
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
   end subroutine summary_fields

   !> A text, or an empty cell where it is ''.
   pure subroutine put_text_or_none(row, text)
      type(field_list_type), intent(inout) :: row
      character(*), intent(in) :: text
      if (text == '') then
         call put_none(row)
      else
         call put(row, text)
      end if
   end subroutine put_text_or_none
end module dg_summary_file
