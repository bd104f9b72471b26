!> The block 'Can it be done?' on standard output: one entry a load case, before all tables.
module dg_verdict_table
   use dg_case_result, only: case_result_type
   use dg_component, only: component_type
   use dg_friction_text, only: reserve_text
   use dg_kinds, only: wp
   use dg_job, only: job_type, leading_model, model_name
   use dg_model, only: model_type, string_index
   use dg_number_text, only: left_aligned, append_wrapped
   use dg_readable, only: first_names
   use dg_text, only: append_text, either, quoted, text_or_nothing, text_type, to_text
   use dg_unchecked_text, only: unchecked_text
   use dg_verdict, only: answer_name, answer_no, answer_unknown, answer_yes, every_limit_count, friction_calibrated, &
                         is_near_by_friction, is_uncertain, is_without_check, limit_title, nearness
   use dg_utilisation, only: limit_slips
   use dg_verdict_text, only: task_text, used_text, verdict_sentences
   use dg_warnings_table, only: doubt_of_deck
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: verdict_table, unchecked_line, interval_line, summary_line, verdict_heading, unlike_text, answer_word

   character(*), parameter :: verdict_title = 'Can it be done?'
   !> Width of names, and of the answer.
   integer, parameter :: most_name = 26, answer_width = 9
   !> Names of cases in one line.
   integer, parameter :: most_names = 6

contains

   !> Title of the run and the lines of the block: answers of the leading model, then those of other models that differ.
   pure function verdict_table(job, model, results, wholes) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      type(text_type), allocatable :: lines(:)
      integer :: i, k, width, shown
      allocate (lines(0))
      if (text_or_nothing(job%title) /= '') call append_text(lines, job%title)
      width = 0
      do k = 1, size(results)
         width = max(width, min(len(model%cases(results(k)%case_index)%name), most_name) + 2)
      end do
      shown = leading_model(job)
      call append_text(lines, '')
      call append_text(lines, verdict_heading(job))
      call append_wrapped(lines, summary_line(job, model, results, wholes))
      call append_wrapped(lines, doubt_of_deck(job, model, results))
      do k = 1, size(results)
         if (results(k)%model /= shown) cycle
         associate (load_case => model%cases(results(k)%case_index))
            call append_wrapped(lines, left_aligned(load_case%name, width)// &
                                left_aligned(answer_word(wholes(k)%verdict%answer), answer_width)// &
                                task_text(job%units, load_case)//'. '// &
                                verdict_sentences(job%units, load_case, wholes(k)%verdict)//'.')
         end associate
      end do
      call append_wrapped(lines, unchecked_line(job, model, results, wholes))
      call append_wrapped(lines, interval_line(model, wholes))
      do i = 1, size(job%models)
         call append_wrapped(lines, unlike_text(job, model, results, wholes, job%models(i)))
      end do
   end function verdict_table

   !> Answers in one line: how many are yes, which are not, which case is nearest to a limit. '' for one case.
   pure function summary_line(job, model, results, wholes) result(text)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      character(:), allocatable :: text, lead
      logical :: shown(size(results)), near(size(results)), bare(size(results)), doubtful(size(results))
      integer :: k
      text = ''
      shown = results%model == leading_model(job)
      if (count(shown) < 2) return
      near = shown .and. wholes%verdict%answer == answer_yes
      text = 'None of '//to_text(count(shown))//' can be done.'
      bare = near .and. is_without_check(wholes%verdict)
      doubtful = near .and. is_uncertain(wholes%verdict)
      if (any(near)) then
         text = to_text(count(near))//' of '//to_text(count(shown))//': yes'
         if (any(bare)) text = text//', '//either('', to_text(count(bare))//' of them ', all(bare .eqv. near))// &
                               'with nothing checked'
         if (any(doubtful)) text = text//', '//either('', to_text(count(doubtful))//' of them ', all(doubtful .eqv. near))// &
                                   'UNCERTAIN'
         text = text//'.'
      end if
      text = text//named('NO', answer_no)//named('No solution', answer_unknown)
      do k = 1, size(results)
         near(k) = near(k) .and. nearness(wholes(k)%verdict) > 0
      end do
      if (.not. any(near)) return
      k = maxloc(nearness(wholes%verdict), dim=1, mask=near)
      lead = ' Nearest to a limit: '
      if (any(shown .and. wholes%verdict%answer /= answer_yes)) lead = ' Of those that can be done, nearest to a limit: '
      text = text//lead//quoted(model%cases(results(k)%case_index)%name)//', '
      associate (verdict => wholes(k)%verdict)
         if (is_near_by_friction(verdict)) then
            text = text//reserve_text(verdict)//'.'
         else
            text = text//used_text(verdict%used%value)//' % used ('//trim(limit_title(verdict%limit))//').'
         end if
      end associate
   contains
      !> Names of the cases with an answer; '' where there are none.
      pure function named(word, answer) result(part)
         character(*), intent(in) :: word
         integer, intent(in) :: answer
         character(:), allocatable :: part
         type(text_type), allocatable :: names(:)
         integer :: i
         part = ''
         allocate (names(0))
         do i = 1, size(results)
            if (shown(i) .and. wholes(i)%verdict%answer == answer) &
               call append_text(names, quoted(model%cases(results(i)%case_index)%name))
         end do
         if (size(names) > 0) part = ' '//word//': '//first_names(names, most_names)//'.'
      end function named
   end function summary_line

   !> Say that answers use calibrated friction without an interval; '' if none does. A section without any friction is a fault of
   !> the measurements.
   pure function interval_line(model, wholes) result(text)
      type(model_type), intent(in) :: model
      type(whole_string_type), intent(in) :: wholes(:)
      character(:), allocatable :: text
      type(text_type), allocatable :: names(:)
      integer :: i
      text = ''
      if (.not. any(wholes%verdict%friction == friction_calibrated)) return
      text = 'Answers hold for the friction found. Not every hole section has a 95 % interval of it, so its upper end is not tried.'
      allocate (names(0))
      do i = 1, size(model%holes)
         if (.not. max(model%holes(i)%friction_axial, model%holes(i)%friction_rotary) > 0.0_wp) &
            call append_text(names, either(model%holes(i)%name, 'a hole section', model%holes(i)%name /= ''))
      end do
      if (size(names) > 0) text = text//' Do not rely on them: after the calibration friction is 0 in '// &
         first_names(names, most_names)//'. See its warnings.'
   end function interval_line

   !> Limits that count for cases with an answer and have no rating in the deck: those of all these cases, then what some have
   !> besides. Slips of cases with a pull at the bit have a sentence of their own. So has a case without a solution.
   pure function unchecked_line(job, model, results, wholes) result(text)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)
      character(:), allocatable :: text, names, head, more, pulled
      logical :: left(size(results)), alike(size(results)), everywhere(every_limit_count), extra(every_limit_count)
      logical :: unrated(every_limit_count, size(results))
      integer :: first, k
      left = results%model == leading_model(job) .and. wholes%verdict%answer /= answer_unknown .and. .not. wholes%verdict%alone
      everywhere = any(left)
      pulled = ''
      do k = 1, size(results)
         unrated(:, k) = wholes(k)%verdict%not_checked
         if (.not. left(k)) cycle
         if (unrated(limit_slips, k) .and. job%design%slip_length > 0.0_wp .and. &
             model%cases(results(k)%case_index)%wob < 0.0_wp) then
            unrated(limit_slips, k) = .false.
            pulled = pulled//either(', ', '', pulled /= '')//quoted(model%cases(results(k)%case_index)%name)
         end if
         everywhere = everywhere .and. unrated(:, k)
      end do
      head = 'NOT CHECKED'
      text = unchecked_text(everywhere, components_of(model, results, left))
      do while (any(left))
         first = findloc(left, .true., dim=1)
         extra = unrated(:, first) .and. .not. everywhere
         names = ''
         do k = 1, size(results)
            alike(k) = left(k) .and. .not. any((unrated(:, k) .neqv. extra) .and. .not. everywhere)
            if (.not. alike(k)) cycle
            if (names /= '') names = names//', '
            names = names//quoted(model%cases(results(k)%case_index)%name)
         end do
         left = left .and. .not. alike
         more = unchecked_text(extra, components_of(model, results, alike))
         if (more == '') cycle
         if (count(alike) > most_names) names = to_text(count(alike))//' cases'
         if (text == '') then
            head = head//' for '//names
         else
            text = text//'. For '//names//': '
         end if
         text = text//more
      end do
      if (text /= '') text = head//', as the deck gives no limit: '//text//'.'
      if (pulled /= '') text = text//either(' ', '', text /= '')//'Slips NOT CHECKED for '//pulled// &
                               ': none are set while the bit is pulled.'
   end function unchecked_line

   !> Components of the strings that some of the results are of, each string once.
   pure function components_of(model, results, some) result(components)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: some(:)             !< of the results
      type(component_type), allocatable :: components(:)
      integer :: i, k
      allocate (components(0))
      do i = 1, size(model%strings)
         do k = 1, size(results)
            if (.not. some(k) .or. string_index(model%strings, model%cases(results(k)%case_index)%string) /= i) cycle
            components = [components, model%strings(i)%components]
            exit
         end do
      end do
   end function components_of

   !> Heading of the block, with the model where there are several.
   pure function verdict_heading(job) result(heading)
      type(job_type), intent(in) :: job
      character(:), allocatable :: heading
      heading = verdict_title
      if (size(job%models) > 1) heading = heading//' By model '//trim(model_name(leading_model(job)))
   end function verdict_heading

   !> Cases that another model answers differently from the leading one; '' if there are none.
   pure function unlike_text(job, model, results, wholes, number) result(text)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)
      integer, intent(in) :: number                      !< of the other model
      character(:), allocatable :: text
      integer :: i, k
      text = ''
      do i = 1, size(results)
         if (results(i)%model /= number) cycle
         do k = 1, size(results)
            if (results(k)%model /= leading_model(job) .or. results(k)%case_index /= results(i)%case_index) cycle
            if (wholes(k)%verdict%answer == wholes(i)%verdict%answer) cycle
            if (text /= '') text = text//', '
            text = text//quoted(model%cases(results(i)%case_index)%name)//' '//answer_word(wholes(i)%verdict%answer)
         end do
      end do
      if (text /= '') text = 'Model '//trim(model_name(number))//' answers otherwise: '//text//'.'
   end function unlike_text

   !> The answer as a reader sees it: NO stands out.
   pure function answer_word(answer) result(word)
      integer, intent(in) :: answer
      character(:), allocatable :: word
      word = trim(answer_name(answer))
      if (answer == answer_no) word = 'NO'
   end function answer_word
end module dg_verdict_table
