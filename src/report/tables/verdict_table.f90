!> The block 'Can it be done?' on standard output: one entry a load case, before all tables.
module dg_verdict_table
   use dg_component, only: component_type
   use dg_findings, only: findings_type, name_of
   use dg_friction_text, only: reserve_text
   use dg_kinds, only: wp
   use dg_job, only: job_type, leading_model, model_name
   use dg_model, only: string_index
   use dg_number_text, only: left_aligned, append_wrapped
   use dg_readable, only: first_names
   use dg_text, only: append_text, either, quoted, text_or_nothing, text_type, to_text
   use dg_unchecked_text, only: unchecked_text
   use dg_verdict, only: answer_name, answer_no, answer_unknown, answer_yes, every_limit_count, friction_calibrated, &
                         is_near_by_friction, is_uncertain, is_without_check, limit_title, nearness
   use dg_utilisation, only: limit_slips
   use dg_verdict_text, only: task_text, used_text, verdict_sentences
   use dg_warnings_table, only: doubt_of_deck
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
   pure function verdict_table(found) result(lines)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: lines(:)
      integer :: i, k, width, shown
      allocate (lines(0))
      if (text_or_nothing(found%job%title) /= '') call append_text(lines, found%job%title)
      width = 0
      do k = 1, size(found%results)
         width = max(width, min(len(name_of(found, k)), most_name) + 2)
      end do
      shown = leading_model(found%job)
      call append_text(lines, '')
      call append_text(lines, verdict_heading(found%job))
      call append_wrapped(lines, summary_line(found))
      call append_wrapped(lines, doubt_of_deck(found))
      do k = 1, size(found%results)
         if (found%results(k)%model /= shown) cycle
         associate (load_case => found%model%cases(found%results(k)%case_index))
            call append_wrapped(lines, left_aligned(load_case%name, width)// &
                                left_aligned(answer_word(found%wholes(k)%verdict%answer), answer_width)// &
                                task_text(found%job%units, load_case)//'. '// &
                                verdict_sentences(found%job%units, load_case, found%wholes(k)%verdict)//'.')
         end associate
      end do
      call append_wrapped(lines, unchecked_line(found))
      call append_wrapped(lines, interval_line(found))
      do i = 1, size(found%job%models)
         call append_wrapped(lines, unlike_text(found, found%job%models(i)))
      end do
   end function verdict_table

   !> Answers in one line: how many are yes, which are not, which case is nearest to a limit. '' for one case.
   pure function summary_line(found) result(text)
      type(findings_type), intent(in) :: found
      character(:), allocatable :: text, lead
      logical :: shown(size(found%results)), near(size(found%results)), bare(size(found%results)), doubtful(size(found%results))
      integer :: k
      text = ''
      shown = found%results%model == leading_model(found%job)
      if (count(shown) < 2) return
      near = shown .and. found%wholes%verdict%answer == answer_yes
      text = 'None of '//to_text(count(shown))//' can be done.'
      bare = near .and. is_without_check(found%wholes%verdict)
      doubtful = near .and. is_uncertain(found%wholes%verdict)
      if (any(near)) then
         text = to_text(count(near))//' of '//to_text(count(shown))//': yes'
         if (any(bare)) text = text//', '//either('', to_text(count(bare))//' of them ', all(bare .eqv. near))// &
                               'with nothing checked'
         if (any(doubtful)) text = text//', '//either('', to_text(count(doubtful))//' of them ', all(doubtful .eqv. near))// &
                                   'UNCERTAIN'
         text = text//'.'
      end if
      text = text//named('NO', answer_no)//named('No solution', answer_unknown)
      do k = 1, size(found%results)
         near(k) = near(k) .and. nearness(found%wholes(k)%verdict) > 0
      end do
      if (.not. any(near)) return
      k = maxloc(nearness(found%wholes%verdict), dim=1, mask=near)
      lead = ' Nearest to a limit: '
      if (any(shown .and. found%wholes%verdict%answer /= answer_yes)) lead = ' Of those that can be done, nearest to a limit: '
      text = text//lead//quoted(name_of(found, k))//', '
      associate (verdict => found%wholes(k)%verdict)
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
         do i = 1, size(found%results)
            if (shown(i) .and. found%wholes(i)%verdict%answer == answer) &
               call append_text(names, quoted(name_of(found, i)))
         end do
         if (size(names) > 0) part = ' '//word//': '//first_names(names, most_names)//'.'
      end function named
   end function summary_line

   !> Say that answers use calibrated friction without an interval; '' if none does. A section without any friction is a fault of
   !> the measurements.
   pure function interval_line(found) result(text)
      type(findings_type), intent(in) :: found
      character(:), allocatable :: text
      type(text_type), allocatable :: names(:)
      integer :: i
      text = ''
      if (.not. any(found%wholes%verdict%friction == friction_calibrated)) return
      text = 'Answers hold for the friction found. Not every hole section has a 95 % interval of it, so its upper end is not tried.'
      allocate (names(0))
      do i = 1, size(found%model%holes)
         if (.not. max(found%model%holes(i)%friction_axial, found%model%holes(i)%friction_rotary) > 0.0_wp) &
            call append_text(names, either(found%model%holes(i)%name, 'a hole section', found%model%holes(i)%name /= ''))
      end do
      if (size(names) > 0) text = text//' Do not rely on them: after the calibration friction is 0 in '// &
         first_names(names, most_names)//'. See its warnings.'
   end function interval_line

   !> Limits that count for cases with an answer and have no rating in the deck: those of all these cases, then what some have
   !> besides. Slips of cases with a pull at the bit have a sentence of their own. So has a case without a solution.
   pure function unchecked_line(found) result(text)
      type(findings_type), intent(in) :: found
      character(:), allocatable :: text, names, head, more, pulled
      logical :: left(size(found%results)), alike(size(found%results)), everywhere(every_limit_count), extra(every_limit_count)
      logical :: unrated(every_limit_count, size(found%results))
      integer :: first, k
      left = found%results%model == leading_model(found%job) .and. found%wholes%verdict%answer /= answer_unknown .and. &
             .not. found%wholes%verdict%alone
      everywhere = any(left)
      pulled = ''
      do k = 1, size(found%results)
         unrated(:, k) = found%wholes(k)%verdict%not_checked
         if (.not. left(k)) cycle
         if (unrated(limit_slips, k) .and. found%model%design%slip_length > 0.0_wp .and. &
             found%model%cases(found%results(k)%case_index)%wob < 0.0_wp) then
            unrated(limit_slips, k) = .false.
            pulled = pulled//either(', ', '', pulled /= '')//quoted(name_of(found, k))
         end if
         everywhere = everywhere .and. unrated(:, k)
      end do
      head = 'NOT CHECKED'
      text = unchecked_text(everywhere, components_of(found, left))
      do while (any(left))
         first = findloc(left, .true., dim=1)
         extra = unrated(:, first) .and. .not. everywhere
         names = ''
         do k = 1, size(found%results)
            alike(k) = left(k) .and. .not. any((unrated(:, k) .neqv. extra) .and. .not. everywhere)
            if (.not. alike(k)) cycle
            if (names /= '') names = names//', '
            names = names//quoted(name_of(found, k))
         end do
         left = left .and. .not. alike
         more = unchecked_text(extra, components_of(found, alike))
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
   pure function components_of(found, some) result(components)
      type(findings_type), intent(in) :: found
      logical, intent(in) :: some(:)             !< of the results
      type(component_type), allocatable :: components(:)
      integer :: i, k
      allocate (components(0))
      do i = 1, size(found%model%strings)
         do k = 1, size(found%results)
            associate (load_case => found%model%cases(found%results(k)%case_index))
               if (.not. some(k) .or. string_index(found%model%strings, load_case%string) /= i) cycle
            end associate
            components = [components, found%model%strings(i)%components]
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
   pure function unlike_text(found, number) result(text)
      type(findings_type), intent(in) :: found
      integer, intent(in) :: number                      !< of the other model
      character(:), allocatable :: text
      integer :: i, k
      text = ''
      do i = 1, size(found%results)
         if (found%results(i)%model /= number) cycle
         do k = 1, size(found%results)
            if (found%results(k)%model /= leading_model(found%job) .or. &
                found%results(k)%case_index /= found%results(i)%case_index) cycle
            if (found%wholes(k)%verdict%answer == found%wholes(i)%verdict%answer) cycle
            if (text /= '') text = text//', '
            text = text//quoted(name_of(found, i))//' '//answer_word(found%wholes(i)%verdict%answer)
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
