!> First block of the page: can it be done, one row a load case and model.
module dg_html_verdict
   use dg_case_result, only: case_result_type
   use dg_html_text, only: html_safe, spaced
   use dg_job, only: job_type, model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_load_case, only: operation_label
   use dg_model, only: model_type
   use dg_unit_kind, only: in_units, unit_length
   use dg_verdict, only: answer_no
   use dg_verdict_table, only: answer_word, verdict_title
   use dg_verdict_text, only: verdict_sentences
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: append_verdicts

   integer, parameter :: shown_depth = 5     !< digits

contains

   !> A table a model: case with operation and depth, answer, what decides.
   subroutine append_verdicts(lines, job, model, results, wholes)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      integer :: i, k
      if (size(results) == 0) return
      call add_line(lines, '<h2>'//verdict_title//'</h2>')
      do i = 1, size(job%models)
         if (.not. any(results%model == job%models(i))) cycle
         if (size(job%models) > 1) call add_line(lines, '<h3>Model '//trim(model_name(job%models(i)))//'</h3>')
         call add_line(lines, '<div class="wide"><table><tbody>')
         do k = 1, size(results)
            if (results(k)%model /= job%models(i)) cycle
            associate (load_case => model%cases(results(k)%case_index), verdict => wholes(k)%verdict)
               call add_line(lines, '<tr><td class="text">'//html_safe(load_case%name)//'<br><small>'// &
                                spaced(trim(operation_label(load_case%operation)))//', '// &
                                trim(in_units(job%units, unit_length, load_case%bit_depth, shown_depth))// &
                                '</small></td><td class="text"><b'// &
                                trim(merge(' class="no"', '           ', verdict%answer == answer_no))//'>'// &
                                answer_word(verdict%answer)//'</b></td><td class="text long">'// &
                                html_safe(verdict_sentences(job%units, load_case, verdict))//'.</td></tr>')
            end associate
         end do
         call add_line(lines, '</tbody></table></div>')
      end do
   end subroutine append_verdicts
end module dg_html_verdict
