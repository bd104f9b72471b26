!> &calibrate of strings that are held: resistances at a known depth, free points from stretch.
module dg_sticking_study
   use dg_kinds, only: wp
   use dg_case_result, only: result_not_converged
   use dg_csv_table, only: add_row, begin_table, write_table
   use dg_deck_draft, only: deck_type
   use dg_deck_sticking, only: read_sticking_groups
   use dg_diagnostic, only: report_line
   use dg_error, only: error_list_type, error_type, raise, status_failure, status_not_converged
   use dg_exit_status, only: graver
   use dg_factor_columns, only: factor_file, factor_row, found_type, held_type
   use dg_hold_string, only: free_point, resistance, usual_solutions
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: is_divided, job_type, model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_printed_text, only: print_and_keep
   use dg_progress, only: progress_type, show_time, start_progress
   use dg_run_outcome, only: add_part, note_lost
   use dg_sticking, only: find_free_point, sticking_name, sticking_no_solution, sticking_result_type, sticking_type, &
                          sticking_status_name
   use dg_sticking_table, only: sticking_table
   use dg_study, only: phase_after, phase_first, run_type, study_type
   use dg_text, only: either, joined, quoted, text_list, text_type, to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_column, only: row_type
   use dg_load_case, only: load_case_type, operation_name
   use dg_missing, only: given, missing
   implicit none
   private
   public :: sticking_study_type

   type, extends(study_type) :: sticking_study_type
      private
      type(sticking_type), allocatable :: stickings(:)
   contains
      procedure :: read => read_stickings
      procedure :: run => run_stickings
      procedure :: echo
   end type sticking_study_type

   !> Significant digits of a length.
   integer, parameter :: digits = 7

contains

   !> Reads its groups.
   subroutine read_stickings(self, deck, job, faults)
      class(sticking_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      associate (not_needed => job)
         call read_sticking_groups(deck%draft, deck%groups, self%stickings, faults)
      end associate
      self%asked = size(self%stickings) > 0
      self%fits = .true.
      ! friction is changed before the load cases: strings are held with that
      self%phase = merge(phase_first, phase_after, any(deck%estimates%applied))
      self%files = text_list(factor_file)
      self%forms = self%files
   end subroutine read_stickings

   !> A line a string.
   subroutine echo(self, job, lines)
      class(sticking_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      real(wp) :: where
      integer :: i
      do i = 1, size(self%stickings)
         associate (sticking => self%stickings(i))
            where = sticking%depth
            if (sticking%kind == find_free_point) where = sticking%stretch
            call add_line(lines, 'calibrate   '//sticking%name//': '//trim(sticking_name(sticking%kind))//', '// &
               either('stretch', 'depth', sticking%kind == find_free_point)//' '// &
               in_units(job%units, unit_length, where, digits)//'; '// &
               joined(model_name(sticking%models), ', ')//'; '//to_text(size(sticking%cases))//' load cases')
         end associate
      end do
   end subroutine echo

   !> Each with each of its models; their rows are put at the end of calibration.csv. A run that is a part of others, or joins
   !> them, leaves them out.
   subroutine run_stickings(self, run, error)
      class(sticking_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      integer :: i, done
      if (is_divided(run%job)) return
      done = 0
      do i = 1, size(self%stickings)
         call run_one(self%stickings(i), run)
         if (is_interrupted()) exit
         done = i
      end do
      call begin_table(run%factors, factor_row(found_type()), run%job%units)
      call write_table(run%factors, run%job%output_dir//'/'//factor_file, error)
      if (is_interrupted() .and. .not. allocated(error)) call raise(error, status_failure, 'calibrations: ended by '// &
         interruption_name()//' with '//to_text(done)//' held strings of '//to_text(size(self%stickings))//' done')
   end subroutine run_stickings

   !> One of the deck: solved, printed, put to the rows of calibration.csv.
   subroutine run_one(sticking, run)
      type(sticking_type), intent(in) :: sticking
      type(run_type), intent(inout) :: run
      type(sticking_result_type) :: results(size(sticking%models)*size(sticking%cases))
      type(text_type), allocatable :: lines(:)
      type(progress_type) :: progress
      integer :: j, k, n, many
      n = 0
      many = size(results)
      if (sticking%kind == find_free_point) many = size(sticking%models)
      call start_progress(progress, 'calibration '//quoted(sticking%name), &
                          'about '//to_text(many*usual_solutions(sticking%kind))//' solutions', run%job%quiet)
      do j = 1, size(sticking%models)
         do k = 1, size(sticking%cases)
            if (sticking%kind == find_free_point .and. k == 1) cycle     ! both pulls make one result
            n = n + 1
            results(n)%model = sticking%models(j)
            results(n)%case_index = sticking%cases(k)
            results(n)%message = ''
            if (sticking%kind == find_free_point) then
               call free_point(run%model, sticking, results(n), progress)
            else
               call resistance(run%model, sticking, results(n), progress)
            end if
            if (is_interrupted()) return
            call show_time(progress, real(n, wp)/real(many, wp))
            if (results(n)%status == sticking_no_solution) call report_lost(sticking, results(n), run)
         end do
      end do
      call add_part(run%printed%outcome, 'calibration '//sticking%name, n, 0, count(results(:n)%status == sticking_no_solution))
      allocate (lines, source=sticking_table(run%job%units, run%model, sticking, results(:n)))
      call print_and_keep(run%printed, lines)
      call begin_table(run%factors, factor_row(found_type()), run%job%units)
      do k = 1, n
         call add_row(run%factors, sticking_row(run%model%cases(results(k)%case_index), sticking, results(k)), run%job%units)
      end do
   end subroutine run_one

   !> Tells of a string without a solution.
   subroutine report_lost(sticking, result, run)
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: result
      type(run_type), intent(inout) :: run
      associate (case => run%model%cases(result%case_index))
         call note_lost(run%printed%outcome, 'calibration '//sticking%name, result%model, result_not_converged, &
                        result%message, case)
         call report_line('calibration '//quoted(sticking%name)//', case '//quoted(case%name)//', model '// &
                          trim(model_name(result%model))//': no solution; '//result%message)
      end associate
      run%status = graver(run%status, status_not_converged)
   end subroutine report_lost

   !> A result in the columns of calibration.csv.
   function sticking_row(load_case, sticking, result) result(row)
      type(load_case_type), intent(in) :: load_case
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: result
      type(row_type) :: row
      type(found_type) :: found
      found%calibration = sticking%name
      found%model = model_name(result%model)
      found%parameter = sticking_name(sticking%kind)
      found%operation = operation_name(load_case%operation)
      found%bit_depth = given(load_case%bit_depth)
      found%verdict = sticking_status_name(result%status)
      found%message = result%message
      found%load_case = load_case%name
      found%held = held_type(result%depth, result%depth_without_friction, result%tension_above, result%tension_below, &
                             result%half_width, result%torque_above, result%torque_below)
      if (result%depth_without_friction > load_case%bit_depth) found%held%depth_frictionless = missing   ! below the bit
      row = factor_row(found)
   end function sticking_row
end module dg_sticking_study
