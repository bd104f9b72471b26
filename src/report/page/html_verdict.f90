!> First block of the page: can it be done, one row per load case.
module dg_html_verdict
   use dg_findings, only: findings_type, rows_of
   use dg_html_text, only: said
   use dg_html_well, only: append_well, shown_rows
   use dg_job, only: job_type, leading_model
   use dg_kinds, only: wp
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_merge_sort, only: sorted_places
   use dg_quantity, only: system_base
   use dg_run_outcome, only: outcome_type
   use dg_text, only: text_type, to_text
   use dg_units, only: system_of
   use dg_utilisation, only: limit_von_mises
   use dg_verdict, only: answer_no, answer_unknown, answer_yes, limit_fatigue, limit_joint_fatigue, limit_lock_up, &
                         limit_wob_yield, verdict_type
   use dg_verdict_table, only: answer_word, interval_line, summary_line, unchecked_line, unlike_text, verdict_heading
   use dg_verdict_text, only: task_text, used_text, verdict_sentences
   use dg_warnings_table, only: doubt_of_deck
   implicit none
   private
   public :: append_verdicts

   integer, parameter :: link_digits = 7     !< of depths
   !> Answers on the first printed page beside a string of `few_components`; each two further components take the room of one.
   integer, parameter :: most_answers = 5, few_components = 9
   !> Order on paper of rows behind the one on the others, less their rank (page.css).
   integer, parameter :: after_more = 10

contains

   !> Answers in one sentence, well and string, a table of the leading model, answers of other models that differ. On paper well and
   !> string follow the sentence, on a screen the table.
   subroutine append_verdicts(lines, found, outcome, shown)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(outcome_type), intent(in) :: outcome
      integer, intent(in) :: shown                          !< load case of the string on the first printed page; 0: none
      character(:), allocatable :: other
      integer :: i
      if (size(found%results) == 0) then
         call append_well(lines, found%job, found%model, outcome, shown, 'h2')
         return
      end if
      call add_line(lines, '<div class="lead"><h2>'//verdict_heading(found%job)//'</h2>')
      other = summary_line(found)
      if (other /= '') call add_line(lines, '<p>'//html_safe(other)//'</p>')
      other = doubt_of_deck(found)
      if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      call append_well(lines, found%job, found%model, outcome, shown, 'h3')
      call append_answers(lines, found, most_answers - max(0, shown_rows(found%model, shown) - few_components)/2)
      other = unchecked_line(found)
      if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      other = interval_line(found)
      if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      do i = 1, size(found%job%models)
         other = unlike_text(found, found%job%models(i))
         if (other /= '') call add_line(lines, '<p class="note warn">'//html_safe(other)//'</p>')
      end do
      call add_line(lines, '</div>')
   end subroutine append_verdicts

   !> Append a row for each load case of the leading model: name with operation and depth, answer, deciding limit. On a screen
   !> they are in the order of the deck. On paper those nearest to a limit are first: `first` of them, a row on the others and
   !> the notes fit on the first page.
   subroutine append_answers(lines, found, first)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      integer, intent(in) :: first
      integer, allocatable :: rows(:), order(:), rank(:)
      type(text_type) :: tasks(system_base - 1), sentences(system_base - 1)
      character(:), allocatable :: place, task, sentence
      integer :: i, k
      allocate (rows, source=rows_of(found, leading_model(found%job)))
      order = sorted_places([(-urgency(found%wholes(rows(i))%verdict), i=1, size(rows))])
      allocate (rank(size(rows)))
      rank(order) = [(i, i=1, size(rows))]
      call add_line(lines, '<div class="wide"><table class="answers"><tbody>')
      do i = 1, size(rows)
         place = ''
         if (size(rows) > first) place = place_text(rank(i))
         associate (load_case => found%model%cases(found%results(rows(i))%case_index), verdict => found%wholes(rows(i))%verdict)
            do k = 1, size(tasks)
               tasks(k)%text = task_text(system_of(k), load_case)
               sentences(k)%text = verdict_sentences(system_of(k), load_case, verdict)//'.'
            end do
            task = task_text(found%job%units, load_case)
            sentence = verdict_sentences(found%job%units, load_case, verdict)//'.'
            call add_line(lines, '<tr'//place//'><td class="text">'//case_link(found%job, load_case%name, verdict)//'<br><small'// &
                             said(task, tasks)//'>'//html_safe(task)//'</small></td><td class="text"><b'// &
                             trim(merge(' class="no"', '           ', verdict%answer == answer_no))//'>'// &
                             answer_word(verdict%answer)//'</b></td><td class="text long"'//said(sentence, sentences)//'>'// &
                             html_safe(sentence)//'</td></tr>')
         end associate
      end do
      if (size(rows) > first) call add_line(lines, '<tr class="more"><td class="text" colspan="3">'// &
                                            others_text(found%wholes(rows(order(first + 1:)))%verdict)//'</td></tr>')
      call add_line(lines, '</tbody></table></div>')
   contains
      !> Order on paper of a row with that rank.
      pure function place_text(rank) result(text)
         integer, intent(in) :: rank
         character(:), allocatable :: text
         text = ' style="order:'//to_text(rank)//'"'
         if (rank > first) text = ' style="order:'//to_text(after_more + rank)//'"'
      end function place_text
   end subroutine append_answers

   !> Number by which rows are sorted, the greatest first: NO is 3, no solution 2, yes the share of its limit.
   elemental function urgency(verdict) result(number)
      type(verdict_type), intent(in) :: verdict
      real(wp) :: number
      number = 0.0_wp
      if (verdict%used%present) number = verdict%used%value
      if (verdict%answer == answer_unknown) number = 2.0_wp
      if (verdict%answer == answer_no) number = 3.0_wp
   end function urgency

   !> Number of load cases behind the first ones and their answers.
   pure function others_text(verdicts) result(text)
      type(verdict_type), intent(in) :: verdicts(:)      !< the first is the nearest to a limit
      character(:), allocatable :: text
      character(:), allocatable :: part
      integer, parameter :: order(3) = [answer_no, answer_unknown, answer_yes]
      integer :: i
      text = ''
      do i = 1, size(order)
         part = to_text(count(verdicts%answer == order(i)))//' '//answer_word(order(i))
         if (all(verdicts%answer == order(i))) part = 'all '//answer_word(order(i))
         if (size(verdicts) == 1) part = answer_word(order(i))
         if (any(verdicts%answer == order(i))) text = text//', '//part
      end do
      text = to_text(size(verdicts))//' more below'//text
      if (verdicts(1)%answer == answer_yes .and. verdicts(1)%used%present) text = text//', at most '// &
         used_text(verdicts(1)%used%value)//' % of a limit used'
      text = text//'.'
   end function others_text

   !> The name of a load case as a link to the chart of the limit that decides, at its depth.
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
      select case (verdict%limit)
      case (limit_von_mises, limit_fatigue, limit_joint_fatigue, limit_wob_yield)
         link = link//'&amp;chart=Strength'
      case (limit_lock_up)
         link = link//'&amp;chart=Buckling'
      case default             ! a force or a torque, in the chart that stands first
      end select
      if (verdict%md%present) link = link//'&amp;depth='//to_text(verdict%md%value/job%units%length, link_digits)
      link = link//'">'//html_safe(name)//'</a>'
   end function case_link
end module dg_html_verdict
