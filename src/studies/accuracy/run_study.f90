!> Runs a study: every variant of its cases, one after the other on one core, so that seconds and memory are those of one
!> solution alone.
module dg_run_study
   use dg_case_result, only: case_result_type
   use dg_error, only: error_type
   use dg_interruption, only: by_signals, is_interrupted
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_model, only: model_type
   use dg_printed_text, only: print_and_keep, printed_text_type
   use dg_progress, only: end_progress, progress_type, start_progress
   use dg_process_memory, only: forget_memory_peak, memory_now, memory_peak
   use dg_solve_case, only: solve_case
   use dg_study_comparison, only: compare_case, new_record, study_record_type
   use dg_study_file, only: write_study
   use dg_study_table, only: study_table
   use dg_study_variant, only: set_variant, study_variants, variant_type
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: run_study

   !> A solution shorter than this [s] is timed by the median of three.
   real(wp), parameter :: brief = 0.05_wp

contains

   !> Solves and compares, prints, writes study.csv anew after each case. A variant without solution is marked; that
   !> is what a study is for, and no failure of the run. After a signal the cases that are whole stay and are printed.
   !> `error` tells that the file could not be written.
   subroutine run_study(printed, job, model, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      type(variant_type), allocatable :: variants(:)
      type(study_record_type), allocatable :: records(:, :)
      type(text_type), allocatable :: lines(:)
      type(model_type) :: varied
      integer :: i, j, whole, done
      type(progress_type) :: progress
      call study_variants(job%study, model%numerics, variants)
      allocate (records(size(variants), size(job%study%cases)))
      whole = 0
      call start_progress(progress, 'study', to_text(size(records))//' solutions', job%quiet)
      cases: do j = 1, size(job%study%cases)
         do i = 1, size(variants)
            varied = model
            call set_variant(variants(i), varied)
            call solve_and_measure(varied, variants(i)%model, job%study%cases(j), records(i, j))
            if (is_interrupted()) exit cases
            done = (j - 1)*size(variants) + i
            call progress%show(real(done, wp)/real(size(records), wp), 0.0_wp, &
                               to_text(done)//' of '//to_text(size(records))//' solutions')
         end do
         call compare_case(variants, records(:, j))
         call write_study(job%output_dir//'/study.csv', job, model, variants, records, j, error)
         if (allocated(error)) exit cases
         whole = j
      end do cases
      call end_progress(progress)
      if (whole == 0 .or. allocated(error)) return
      allocate (lines, source=study_table(job, model, variants, records(:, :whole)))
      call print_and_keep(printed, lines)
   end subroutine run_study

   !> One solution with its seconds and the memory that it takes on top of what was there.
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
end module dg_run_study
