!> study.csv: accuracy and cost, one row per load case and variant.
module dg_study_file
   use dg_case_result, only: has_numbers, result_status_name
   use dg_column, only: add, add_filled, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_percent, &
                        quantity_text, quantity_time, quantity_wall, row_type
   use dg_comparison, only: percent_of
   use dg_job, only: model_mcge, model_name
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing, optional_real
   use dg_numerics, only: fidelity_name, gap_location_name, solver_name
   use dg_study_comparison, only: error_bending, error_bending_rms, error_hookload, error_normal_force, error_torque, &
                                  study_record_type
   use dg_study_variant, only: variant_type
   use dg_text, only: either
   implicit none
   private
   public :: study_row

   real(wp), parameter :: megabyte = 1024.0_wp**2

contains

   !> A variant in the columns of the file. New columns are put at the end only.
   pure function study_row(name, variant, record) result(row)
      character(*), intent(in) :: name       !< of the load case
      type(variant_type), intent(in) :: variant
      type(study_record_type), intent(in) :: record
      type(row_type) :: row
      character(:), allocatable :: fidelity, gap_location, linear_solver
      logical :: beams
      beams = variant%model == model_mcge
      fidelity = ''
      gap_location = ''
      linear_solver = ''
      if (variant%fidelity > 0) fidelity = fidelity_name(variant%fidelity)
      if (beams) gap_location = gap_location_name(variant%numerics%gap_location)
      if (beams) linear_solver = solver_name(variant%numerics%linear_solver)
      call add(row, 'case', quantity_text, 'name of the load case', name)
      call add(row, 'model', quantity_text, 'name of the model', model_name(variant%model))
      call add_filled(row, 'fidelity', quantity_text, 'name of the fidelity, if it sets the element length', fidelity)
      call add(row, 'element_length', quantity_length, 'longest element asked for', variant%numerics%element_length)
      call add(row, 'tolerance', quantity_none, &
               'tolerance of the variant; this and the next three: only for mcge', &
               optional_real(beams, variant%numerics%tolerance))
      call add(row, 'wall_stiffness', quantity_wall, &
               'stiffness of every wall; empty: that of the deck', optional_real(beams .and. variant%wall > 0.0_wp, variant%wall))
      call add_filled(row, 'gap_location', quantity_text, 'extremum or nodes', gap_location)
      call add_filled(row, 'linear_solver', quantity_text, 'its name', linear_solver)
      call add(row, 'status', quantity_text, 'as in summary.csv: only converged is a solution', result_status_name(record%status))
      call add(row, 'reference', quantity_text, &
               'yes: finest converged variant of the case, the reference for errors', either('yes', 'no', record%is_reference))
      call add(row, 'hookload', quantity_force, 'as in summary.csv', number(record%hookload))
      call add(row, 'hookload_error', quantity_percent, 'difference from the reference', percent_of(record%errors(error_hookload)))
      call add(row, 'torque', quantity_moment, 'at the top', number(record%torque))
      call add(row, 'torque_error', quantity_percent, &
               'difference from the reference; empty if the reference is zero', percent_of(record%errors(error_torque)))
      call add(row, 'normal_force', quantity_force, 'sum of the contact forces along the string', number(record%normal_force))
      call add(row, 'normal_force_error', quantity_percent, 'difference from the reference', &
               percent_of(record%errors(error_normal_force)))
      call add(row, 'bending', quantity_moment, 'greatest bending moment along the string', number(record%bending))
      call add(row, 'bending_error', quantity_percent, &
               'largest difference along the string, of the largest moment of reference', percent_of(record%errors(error_bending)))
      call add(row, 'iterations', quantity_none, 'Newton iterations; 0 for the other models', record%iterations)
      call add(row, 'elements', quantity_none, 'elements of the mesh, or steps of integration', record%elements)
      call add(row, 'seconds', quantity_time, &
               'wall time of the solution alone, on one core; median of three where short', record%seconds)
      call add(row, 'memory_MB', quantity_none, &
               'largest use of memory; empty if unknown', &
               merge(missing, record%memory/megabyte, is_missing(record%memory)))
      call add(row, 'cost', quantity_none, 'time divided by that of the reference', record%cost)
      call add(row, 'pareto', quantity_text, &
               'yes: no variant of this case is both more accurate (hook load and torque, the worse) and faster', &
               either('yes', 'no', record%in_pareto_set))
      call add(row, 'hookload_order', quantity_none, &
               'order of convergence of hook load, from rows that differ in element length only; empty if there is none', &
               record%orders(error_hookload))
      call add(row, 'torque_order', quantity_none, 'the same', record%orders(error_torque))
      call add(row, 'normal_force_order', quantity_none, 'the same', record%orders(error_normal_force))
      call add(row, 'bending_order', quantity_none, 'the same', record%orders(error_bending))
      call add(row, 'bending_rms', quantity_percent, &
               'root mean square of the difference of bending moments along the string, of the largest moment of reference', &
               percent_of(record%errors(error_bending_rms)))
   contains
      !> A number of the variant; missing where it did not converge.
      pure function number(value) result(shown)
         real(wp), intent(in) :: value
         real(wp) :: shown
         shown = merge(value, missing, has_numbers(record%status))
      end function number
   end function study_row
end module dg_study_file
