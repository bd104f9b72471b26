!> Lays other programs' results beside ours: prints and writes the comparison.
module dg_run_legacy
   use dg_case_result, only: case_result_type
   use dg_csv_table, only: begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: job_type
   use dg_legacy_comparison, only: comparison_type, compare_with_legacy
   use dg_legacy_report, only: legacy_report
   use dg_legacy_rows, only: add_legacy_rows, legacy_columns
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
      type(csv_table_type) :: rows
      type(text_type), allocatable :: lines(:)
      integer :: i
      call begin_table(rows, legacy_columns, job%units)
      associate (table => job%legacy(number))
         do i = 1, size(results)
            if (results(i)%case_index /= table%case_index .or. .not. allocated(results(i)%profile%md)) cycle
            call compare_with_legacy(table, results(i)%profile, model%trajectory, comparison)
            lines = legacy_report(job%units, table, model%cases(table%case_index)%name, results(i)%model, results(i)%status, &
                                  comparison, results(i)%model == job%models(1))
            call print_and_keep(printed, lines)
            call add_legacy_rows(rows, model%cases(table%case_index)%name, results(i)%model, comparison)
         end do
         call write_table(rows, job%output_dir//'/legacy_'//table%label//'.csv', error)
      end associate
   end subroutine run_legacy
end module dg_run_legacy
