!> Draws the pictures of a run and puts all into one page.
module dg_run_pictures
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_deck_echo, only: echo_lines
   use dg_diagnostic, only: tell
   use dg_error, only: add_error, error_type, raise, status_failure
   use dg_html_report, only: write_html_report
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_picture_files, only: write_pictures
   use dg_picture_list, only: folder_in, picture_list_type
   use dg_printed_text, only: printed_text_type
   use dg_text, only: text_type
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: run_pictures

contains

   !> A missing gnuplot is noted on standard error, not an error: scripts, data and page are written all the same. A run that is
   !> asked to end writes no page.
   subroutine run_pictures(printed, job, model, results, alongs, wholes, error)
      type(printed_text_type), intent(in) :: printed        !< what the page takes as it was printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: page_error
      type(picture_list_type) :: pictures
      type(text_type), allocatable :: echo(:), tables(:)
      call write_pictures(job, model, results, alongs, pictures, error)
      if (is_interrupted()) then
         if (.not. allocated(error)) call raise(error, status_failure, 'ended by '//interruption_name()//' before report.html')
         return
      end if
      if (pictures%no_gnuplot .and. .not. job%quiet) call tell('note: no gnuplot here, so no pictures are drawn; '// &
         folder_in(job)//'/all.gp draws them where there is one')
      call echo_lines(job, model, echo)
      allocate (tables(0))
      if (allocated(printed%lines)) tables = printed%lines
      call write_html_report(job, model, results, wholes, tables, printed%outcome, pictures, echo, page_error)
      call add_error(error, page_error)
   end subroutine run_pictures
end module dg_run_pictures
