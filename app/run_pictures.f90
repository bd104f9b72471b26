!> Draws the pictures of a run and puts all into one page.
module dg_run_pictures
   use dg_deck_echo, only: echo_lines
   use dg_diagnostic, only: report_line
   use dg_error, only: error_type, join_error, raise, status_failure
   use dg_findings, only: findings_type
   use dg_html_report, only: write_html_report
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_picture_files, only: begin_pictures, end_pictures
   use dg_picture_list, only: folder_in, picture_list_type
   use dg_registry, only: echo_studies, studies_type
   use dg_study, only: run_type
   use dg_text, only: text_type
   implicit none
   private
   public :: run_pictures

contains

   !> A missing gnuplot is noted on standard error, not an error: scripts, data and page are written all the same. A run that is
   !> asked to end writes no page.
   subroutine run_pictures(run, studies, error)
      type(run_type), intent(in) :: run
      type(studies_type), intent(in) :: studies
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: page_error
      type(picture_list_type) :: pictures
      type(text_type), allocatable :: echo(:), before(:), after(:)
      integer :: i
      call begin_pictures(run%findings_type, pictures, error)
      do i = 1, size(studies%items)
         if (studies%items(i)%study%asked) call studies%items(i)%study%add_pictures(run, pictures, error)
      end do
      call end_pictures(run%findings_type, pictures, error)
      if (is_interrupted()) then
         if (.not. allocated(error)) call raise(error, status_failure, 'ended by '//interruption_name()//' before report.html')
         return
      end if
      if (pictures%no_gnuplot .and. .not. run%job%quiet) call report_line('note: no gnuplot here, so no pictures are drawn; '// &
         folder_in(run%job)//'/all.gp draws them where there is one')
      call echo_studies(studies, run%job, before, after)
      call echo_lines(run%job, run%model, before, after, echo)
      call write_html_report(run%findings_type, run%printed, pictures, echo, page_error)
      call join_error(error, page_error)
   end subroutine run_pictures
end module dg_run_pictures
