!> &study: accuracy against cost. Solves every variant of its cases, one after the other on one core, so that seconds and
!> memory are those of one solution.
module dg_accuracy_study
   use dg_column, only: fields_of
   use dg_kinds, only: wp
   use dg_case_memory, only: elements_in, finer_text, need_type, keep_larger
   use dg_case_result, only: case_result_type
   use dg_deck_draft, only: deck_type
   use dg_deck_study, only: read_study
   use dg_error, only: error_list_type, error_type
   use dg_interruption, only: by_signals, is_interrupted
   use dg_job, only: job_type
   use dg_line_list, only: add_line, line_list_type
   use dg_missing, only: missing
   use dg_model, only: model_type
   use dg_numerics, only: fidelity_name, numerics_type, set_fidelity, solver_banded
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_printed_text, only: print_and_keep
   use dg_process_memory, only: forget_memory_peak, memory_now, memory_peak
   use dg_progress, only: end_progress, progress_type, start_progress
   use dg_solve_case, only: solve_case
   use dg_study, only: run_type, study_type
   use dg_study_comparison, only: compare_case, new_record, study_record_type
   use dg_study_file, only: study_row
   use dg_study_picture, only: study_chart
   use dg_study_plan, only: most_variants, study_plan_type
   use dg_study_table, only: study_table
   use dg_study_variant, only: set_variant, study_variants, variant_type
   use dg_text, only: quoted, text_list, text_type, to_text
   use dg_csv_table, only: add_row, csv_table_type, write_table
   implicit none
   private
   public :: accuracy_study_type

   type, extends(study_type) :: accuracy_study_type
      private
      type(study_plan_type), allocatable :: plan
      type(variant_type), allocatable :: variants(:)
      type(study_record_type), allocatable :: records(:, :)   !< of variants and cases
   contains
      procedure :: read => read_plan
      procedure :: run => run_plan
      procedure :: echo
      procedure :: add_need
      procedure :: add_pictures
   end type accuracy_study_type

   character(*), parameter :: file = 'study.csv'
   !> A solution shorter than this [s] is timed by the median of three.
   real(wp), parameter :: brief = 0.05_wp
   !> Columns of the table beneath the picture.
   character(*), parameter :: shown(17) = [character(24) :: 'model', 'fidelity', 'element_length', 'tolerance', &
      'wall_stiffness', 'gap_location', 'linear_solver', 'status', 'hookload', 'hookload_error', 'torque_error', &
      'normal_force_error', 'bending_error', 'iterations', 'seconds', 'cost', 'pareto']

contains

   !> Reads its group.
   subroutine read_plan(self, deck, job, faults)
      class(accuracy_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      call read_study(deck%draft, deck%groups, job%models, self%plan, faults)
      self%asked = allocated(self%plan)
      self%files = text_list(file)
      self%forms = self%files
   end subroutine read_plan

   !> Add the number of solutions of the study.
   subroutine echo(self, job, lines)
      class(accuracy_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      associate (not_needed => job)
         if (self%asked) call add_line(lines, 'study       at most '//to_text(nint(most_variants(self%plan)))// &
                                            ' variants of '//to_text(size(self%plan%cases))//' cases')
      end associate
   end subroutine echo

   !> Solve and compare, print, and write study.csv anew after each case. A variant without solution is marked, and is no
   !> failure of the run. After a signal complete cases stay and are printed.
   subroutine run_plan(self, run, error)
      class(accuracy_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      type(csv_table_type) :: table
      type(model_type) :: varied
      integer :: i, j, whole, done
      type(progress_type) :: progress
      call study_variants(self%plan, run%model%numerics, self%variants)
      allocate (self%records(size(self%variants), size(self%plan%cases)))
      whole = 0
      call start_progress(progress, 'study', to_text(size(self%records))//' solutions', run%job%quiet)
      cases: do j = 1, size(self%plan%cases)
         do i = 1, size(self%variants)
            varied = run%model
            call set_variant(self%variants(i), varied)
            call solve_and_measure(varied, self%variants(i)%model, self%plan%cases(j), self%records(i, j))
            if (is_interrupted()) exit cases
            done = (j - 1)*size(self%variants) + i
            call progress%show(real(done, wp)/real(size(self%records), wp), 0.0_wp, &
                               to_text(done)//' of '//to_text(size(self%records))//' solutions')
         end do
         call compare_case(self%variants, self%records(:, j))
         do i = 1, size(self%variants)
            call add_row(table, study_row(run%model%cases(self%plan%cases(j))%name, self%variants(i), self%records(i, j)), &
                         run%job%units)
         end do
         call write_table(table, run%job%output_dir//'/'//file, error)
         if (allocated(error)) exit cases
         whole = j
      end do cases
      call end_progress(progress)
      if (whole > 0 .and. .not. allocated(error)) then
         allocate (lines, source=study_table(run%job, run%model, self%plan, self%variants, self%records(:, :whole)))
         call print_and_keep(run%printed, lines)
      end if
   end subroutine run_plan

   !> Solve once, and measure seconds and additional memory.
   subroutine solve_and_measure(model, number, case_index, record)
      type(model_type), intent(in) :: model
      integer, intent(in) :: number, case_index
      type(study_record_type), intent(out) :: record
      type(case_result_type), allocatable :: result
      type(error_type), allocatable :: error
      real(wp) :: seconds(3), before, memory
      logical :: known
      integer :: run
      call forget_memory_peak(known)
      before = memory_now()
      allocate (result)
      call solve_case(model, number, case_index, result, error, stop=by_signals())
      memory = missing
      if (known) memory = max(0.0_wp, memory_peak() - before)
      seconds = result%seconds
      do run = 2, merge(size(seconds), 1, result%seconds < brief)
         call solve_case(model, number, case_index, result, error, stop=by_signals())
         seconds(run) = result%seconds
      end do
      call new_record(result, sum(seconds) - maxval(seconds) - minval(seconds), memory, record)
   end subroutine solve_and_measure

   !> Solutions go one by one.
   subroutine add_need(self, job, model, need)
      class(accuracy_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(need_type), intent(inout) :: need
      type(numerics_type) :: numerics
      real(wp) :: shortest
      integer :: i
      if (.not. self%asked) return
      need%banded = need%banded .or. any(self%plan%linear_solvers == solver_banded)
      if (job%merge > 0 .or. job%parts > 0) return
      shortest = model%numerics%element_length
      if (size(self%plan%element_lengths) > 0) shortest = minval(self%plan%element_lengths)
      do i = 1, size(self%plan%fidelities)
         numerics = model%numerics
         call set_fidelity(numerics, fidelity_name(self%plan%fidelities(i)))
         shortest = min(shortest, numerics%element_length)
      end do
      do i = 1, size(self%plan%cases)
         associate (case => model%cases(self%plan%cases(i)))
            call keep_larger(need, elements_in(model, case%string, case%bit_depth, shortest), 1, &
                             'study, case '//quoted(case%name), finer_text(model, shortest))
         end associate
      end do
   end subroutine add_need

   !> A picture for each case.
   subroutine add_pictures(self, run, list, error)
      class(accuracy_study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      type(picture_data_type) :: data
      integer, allocatable :: rows(:)
      integer :: i, k
      if (.not. allocated(self%records)) return
      do k = 1, size(self%plan%cases)
         associate (load_case => run%model%cases(self%plan%cases(k)))
            call picked_rows(file, spread(.true., 1, size(self%variants)), data, rows)
            do i = 1, size(rows)
               data%rows(i) = fields_of(study_row(load_case%name, self%variants(rows(i)), self%records(rows(i), k)), shown)
            end do
            call add_picture(list, run%job, study_chart(run%job%units, load_case, self%plan%models, self%variants, &
                                                        self%records(:, k)), &
                             'Error against the finest settings, and solution time', self%plan%cases(k), &
                             data, error)
         end associate
      end do
   end subroutine add_pictures
end module dg_accuracy_study
