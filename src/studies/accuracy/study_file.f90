!> study.csv: accuracy and cost, one row a load case and variant.
module dg_study_file
   use dg_case_result, only: has_numbers, result_status_name
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_force, quantity_length, &
                        quantity_moment, quantity_none, quantity_percent, quantity_text, quantity_time, quantity_wall
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: job_type, model_mcge, model_name
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_numerics, only: fidelity_name, gap_location_name, solver_name
   use dg_study_comparison, only: error_bending, error_bending_rms, error_hookload, error_normal_force, error_torque, &
                                  study_record_type
   use dg_study_plan, only: study_plan_type
   use dg_study_variant, only: variant_type
   implicit none
   private
   public :: write_study, study_columns

   real(wp), parameter :: per_cent = 100.0_wp, megabyte = 1024.0_wp**2

   !> New ones are added at the end only.
   type(column_type), parameter :: study_columns(29) = [ &
      column_type('case', quantity_text, 'name of the load case'), &
      column_type('model', quantity_text, 'name of the model'), &
      column_type('fidelity', quantity_text, 'its name, where it set the element length'), &
      column_type('element_length', quantity_length, 'longest element asked for'), &
      column_type('tolerance', quantity_none, 'residual at convergence over the weight; this and the next three: empty for '// &
         'models other than mcge'), &
      column_type('wall_stiffness', quantity_wall, 'of every wall; empty where it is that of the deck'), &
      column_type('gap_location', quantity_text, 'extremum or nodes'), &
      column_type('linear_solver', quantity_text, 'its name'), &
      column_type('status', quantity_text, 'as in summary.csv: only converged is a solution'), &
      column_type('reference', quantity_text, 'yes: the finest variant of the case that converged, against which errors are'), &
      column_type('hookload', quantity_force, 'axial force held at the top'), &
      column_type('hookload_error', quantity_percent, 'of the reference''s'), &
      column_type('torque', quantity_moment, 'at the top'), &
      column_type('torque_error', quantity_percent, 'of the reference''s; empty where that is none'), &
      column_type('normal_force', quantity_force, 'sum of the contact forces over the string'), &
      column_type('normal_force_error', quantity_percent, 'of the reference''s'), &
      column_type('bending', quantity_moment, 'greatest bending moment along the string'), &
      column_type('bending_error', quantity_percent, 'largest difference along the string, of the reference''s greatest'), &
      column_type('iterations', quantity_none, 'Newton iterations; 0 for models without'), &
      column_type('elements', quantity_none, 'of the mesh, or steps of integration'), &
      column_type('seconds', quantity_time, 'wall time of the solution alone, on one core; median of three where short'), &
      column_type('memory_MB', quantity_none, 'greatest use while it was solved; empty where the system does not tell'), &
      column_type('cost', quantity_none, 'seconds over the reference''s'), &
      column_type('pareto', quantity_text, 'yes: nothing in this case is both more accurate (hook load and torque, the worse) '// &
         'and faster'), &
      column_type('hookload_order', quantity_none, 'order of convergence, from all rows of the case that differ in '// &
         'element length alone; empty where they do not tell'), &
      column_type('torque_order', quantity_none, 'the same'), &
      column_type('normal_force_order', quantity_none, 'the same'), &
      column_type('bending_order', quantity_none, 'the same'), &
      column_type('bending_rms', quantity_percent, 'root mean square of the difference of bending moments along the string, of '// &
         'the reference''s greatest')]

contains

   !> Writes study.csv to `path`. records(variants, cases of the study), of which the first `solved` cases are there.
   subroutine write_study(path, job, model, plan, variants, records, solved, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(study_plan_type), intent(in) :: plan
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(in) :: records(:, :)
      integer, intent(in) :: solved
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i, j
      call begin_table(table, study_columns, job%units)
      do j = 1, solved
         do i = 1, size(variants)
            call study_fields(model%cases(plan%cases(j))%name, variants(i), records(i, j), row)
            call add_row(table, row)
         end do
      end do
      call write_table(table, path, error)
   end subroutine write_study

   !> Values of one row in the order of the columns.
   pure subroutine study_fields(name, variant, record, row)
      character(*), intent(in) :: name       !< of the load case
      type(variant_type), intent(in) :: variant
      type(study_record_type), intent(in) :: record
      type(field_list_type), intent(out) :: row
      integer :: k
      call put(row, name)
      call put(row, trim(model_name(variant%model)))
      if (variant%fidelity > 0) then
         call put(row, trim(fidelity_name(variant%fidelity)))
      else
         call put_none(row)
      end if
      call put(row, variant%numerics%element_length)
      if (variant%model == model_mcge) then
         call put(row, variant%numerics%tolerance)
         call put(row, merge(variant%wall, missing, variant%wall > 0.0_wp))
         call put(row, trim(gap_location_name(variant%numerics%gap_location)))
         call put(row, trim(solver_name(variant%numerics%linear_solver)))
      else
         do k = 1, 4
            call put_none(row)
         end do
      end if
      call put(row, trim(result_status_name(record%status)))
      call put(row, yes(record%is_reference))
      call put(row, number(record%hookload))
      call put(row, share(record%errors(error_hookload)))
      call put(row, number(record%torque))
      call put(row, share(record%errors(error_torque)))
      call put(row, number(record%normal_force))
      call put(row, share(record%errors(error_normal_force)))
      call put(row, number(record%bending))
      call put(row, share(record%errors(error_bending)))
      call put(row, record%iterations)
      call put(row, record%elements)
      call put(row, record%seconds)
      call put(row, merge(missing, record%memory/megabyte, is_missing(record%memory)))
      call put(row, record%cost)
      call put(row, yes(record%in_pareto_set))
      do k = error_hookload, error_bending
         call put(row, record%orders(k))
      end do
      call put(row, share(record%errors(error_bending_rms)))
   contains
      !> A number of the variant; missing where it did not converge.
      pure function number(value) result(shown)
         real(wp), intent(in) :: value
         real(wp) :: shown
         shown = merge(value, missing, has_numbers(record%status))
      end function number
   end subroutine study_fields

   !> A share in per cent, missing where it is.
   elemental function share(value) result(percent)
      real(wp), intent(in) :: value
      real(wp) :: percent
      percent = missing
      if (.not. is_missing(value)) percent = per_cent*value
   end function share

   pure function yes(is) result(text)
      logical, intent(in) :: is
      character(:), allocatable :: text
      text = 'no'
      if (is) text = 'yes'
   end function yes
end module dg_study_file
