!> Lays other programs' results beside ours: prints and writes the comparison.
module dg_run_legacy
   use dg_case_result, only: case_result_type
   use dg_error, only: error_type
   use dg_job, only: job_type
   use dg_legacy_comparison, only: comparison_type, compare_with_legacy
   use dg_legacy_report, only: legacy_report
   use dg_legacy_rows, only: append_legacy_rows, write_legacy_file
   use dg_model, only: model_type
   use dg_printed_text, only: print_and_keep, printed_text_type
   use dg_text, only: text_type
   implicit none
   private
   public :: run_legacy

contains

   !> One table beside all results of its case: printed, written to legacy_<label>.csv.
   subroutine run_legacy(printed, job, model, results, number, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      integer, intent(in) :: number            !< of the table in the job
      type(error_type), allocatable, intent(out) :: error
      type(comparison_type) :: comparison
      type(text_type), allocatable :: rows(:), lines(:)
      integer :: i
      allocate (rows(0))
      associate (table => job%legacy(number))
         do i = 1, size(results)
            if (results(i)%case_index /= table%case_index .or. .not. allocated(results(i)%profile%md)) cycle
            call compare_with_legacy(table, results(i)%profile, model%trajectory, comparison)
            lines = legacy_report(job%units, table, model%cases(table%case_index)%name, results(i)%model, comparison, &
                                  results(i)%model == job%models(1))
            call print_and_keep(printed, lines)
            call append_legacy_rows(rows, job%units, model%cases(table%case_index)%name, results(i)%model, comparison)
         end do
         call write_legacy_file(job%output_dir//'/legacy_'//table%label//'.csv', job, rows, error)
      end associate
   end subroutine run_legacy
end module dg_run_legacy
