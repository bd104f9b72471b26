!> First block of the page: can it be done, one row per load case.
module dg_html_verdict
   use dg_case_result, only: case_result_type
   use dg_html_well, only: append_well
   use dg_job, only: job_type, leading_model
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_model, only: model_type
   use dg_text, only: to_text
   use dg_verdict, only: answer_no, verdict_type
   use dg_verdict_table, only: answer_word, interval_line, summary_line, unchecked_line, unlike_text, verdict_heading
   use dg_verdict_text, only: task_text, verdict_sentences
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: append_verdicts

   integer, parameter :: link_digits = 7     !< of depths

contains

   !> Answers in one sentence, well and string, a table of the leading model: case with operation and depth, answer, what decides.
   !> Answers of other models that differ. On paper well and string follow the sentence, on a screen the table.
   subroutine append_verdicts(lines, job, model, results, wholes, shown)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      integer, intent(in) :: shown                          !< load case of string and chart of the first printed page; 0: none
      character(:), allocatable :: other
      integer :: i, k
      if (size(results) == 0) then
         call append_well(lines, job, model, shown)
         return
      end if
      call add_line(lines, '<div class="lead"><h2>'//verdict_heading(job)//'</h2>')
      other = summary_line(job, model, results, wholes)
      if (other /= '') call add_line(lines, '<p>'//html_safe(other)//'</p>')
      call append_well(lines, job, model, shown)
      call add_line(lines, '<div class="wide"><table class="answers"><tbody>')
      do k = 1, size(results)
         if (results(k)%model /= leading_model(job)) cycle
         associate (load_case => model%cases(results(k)%case_index), verdict => wholes(k)%verdict)
            call add_line(lines, '<tr><td class="text">'//case_link(job, load_case%name, verdict)//'<br><small>'// &
                             task_text(job%units, load_case)//'</small></td><td class="text"><b'// &
                             trim(merge(' class="no"', '           ', verdict%answer == answer_no))//'>'// &
                             answer_word(verdict%answer)//'</b></td><td class="text long">'// &
                             html_safe(verdict_sentences(job%units, load_case, verdict))//'.</td></tr>')
         end associate
      end do
      call add_line(lines, '</tbody></table></div>')
      other = unchecked_line(job, model, results, wholes)
      if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      other = interval_line(wholes)
      if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      do i = 1, size(job%models)
         other = unlike_text(job, model, results, wholes, job%models(i))
         if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      end do
      call add_line(lines, '</div>')
   end subroutine append_verdicts

   !> The name of a load case as a link to its charts, at the depth of the limit that decides.
   pure function case_link(job, name, verdict) result(link)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: name
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: link
      integer :: i
      link = '<a href="#case='
      do i = 1, len(name)
         if (name(i:i) == '+') then
            link = link//'%2B'
         else
            link = link//html_safe(name(i:i))     ! letters, digits and _ - .
         end if
      end do
      if (verdict%md%present) link = link//'&amp;depth='//to_text(verdict%md%value/job%units%length, link_digits)
      link = link//'">'//html_safe(name)//'</a>'
   end function case_link
end module dg_html_verdict
