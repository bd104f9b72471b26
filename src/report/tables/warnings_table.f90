!> The block 'Warnings' on standard output, under the verdict. It has unusual settings of the deck, then one entry a load case,
!> those without a solution first.
module dg_warnings_table
   use dg_case_result, only: case_result_type, result_converged, result_locked_up, result_not_converged, result_status_name
   use dg_findings, only: findings_type
   use dg_job, only: job_type, model_name
   use dg_model, only: model_type
   use dg_text, only: append_text, either, text_type, to_text
   use dg_number_text, only: append_wrapped
   implicit none
   private
   public :: warnings_table, warning_sentences, warnings_heading, doubt_of_deck, deck_warnings

   !> Statuses as they follow each other in the block.
   integer, parameter :: by_weight(3) = [result_not_converged, result_locked_up, result_converged]

contains

   !> The lines of the block; none where deck and cases have no message.
   pure function warnings_table(found) result(lines)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: lines(:)
      type(text_type), allocatable :: sentences(:)
      integer :: i
      allocate (lines(0))
      allocate (sentences, source=warning_sentences(found))
      if (size(sentences) == 0) return
      call append_text(lines, '')
      call append_text(lines, warnings_heading(sentences))
      do i = 1, size(sentences)
         call append_wrapped(lines, sentences(i)%text)
      end do
   end function warnings_table

   !> Heading of the block.
   pure function warnings_heading(sentences) result(heading)
      type(text_type), intent(in) :: sentences(:)
      character(:), allocatable :: heading
      heading = 'Warnings ('//to_text(size(sentences))//')'
   end function warnings_heading

   !> Notes on the deck, then messages of load cases, those without a solution first; load cases with the same message have one.
   pure function warning_sentences(found) result(sentences)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: sentences(:)
      character(:), allocatable :: head, text
      integer, allocatable :: order(:), other(:)
      integer :: i
      allocate (sentences, source=deck_warnings(found%job, found%model))
      do i = 1, size(sentences)
         sentences(i)%text = 'Deck: '//sentences(i)%text
      end do
      allocate (order, source=warning_order(found%results))
      do while (size(order) > 0)
         text = warning_text(found%results(order(1)))
         head = ''
         allocate (other(0))
         do i = 1, size(order)
            associate (result => found%results(order(i)))
               if (warning_text(result) /= text) then
                  other = [other, order(i)]
                  cycle
               end if
               if (head /= '') head = head//either(',', ';', size(found%job%models) == 1)//' '
               head = head//found%model%cases(result%case_index)%name
               if (size(found%job%models) > 1) head = head//', '//trim(model_name(result%model))
            end associate
         end do
         call append_text(sentences, head//': '//text//'.')
         call move_alloc(other, order)
      end do
   end function warning_sentences

   !> A line above the answers that are made from a deck with warnings; '' without warnings.
   pure function doubt_of_deck(found) result(text)
      type(findings_type), intent(in) :: found
      character(:), allocatable :: text
      integer :: on_deck, all
      on_deck = size(deck_warnings(found%job, found%model))
      all = size(warning_sentences(found))
      text = ''
      if (on_deck > 0) text = 'There '//either('is 1 warning', 'are '//to_text(all)//' warnings', all == 1)//', '// &
                            either('', to_text(on_deck)//' of them ', on_deck == all)//'on the deck. Read '// &
                            either('it', 'them', all == 1)//' before you use these answers.'
   end function doubt_of_deck

   !> Notes on the deck as sentences, without those on its path, which have lines of their own.
   pure function deck_warnings(job, model) result(notes)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(text_type), allocatable :: notes(:)
      integer :: i, k
      allocate (notes(0))
      if (.not. allocated(job%notes)) return
      do i = 1, size(job%notes)
         if (allocated(model%path_notes)) then
            if (any([(model%path_notes(k)%text == job%notes(i)%text, k=1, size(model%path_notes))])) cycle
         end if
         call append_text(notes, job%notes(i)%text//either('', '.', index('.?', last_of(job%notes(i)%text)) > 0))
      end do
   contains
      !> The last letter.
      pure function last_of(text) result(letter)
         character(*), intent(in) :: text
         character :: letter
         letter = text(len(text):)
      end function last_of
   end function deck_warnings

   !> Results that have a warning: those without a solution first, then locked-up ones, each in the deck's order.
   pure function warning_order(results) result(order)
      type(case_result_type), intent(in) :: results(:)
      integer, allocatable :: order(:)
      integer :: i, k
      allocate (order(0))
      do k = 1, size(by_weight)
         order = [order, pack([(i, i=1, size(results))], [(results(i)%status == by_weight(k) .and. warning_text(results(i)) /= '', &
                                                           i=1, size(results))])]
      end do
   end function warning_order

   !> Status and message of a result; '' for one that has converged and has no message.
   pure function warning_text(result) result(text)
      type(case_result_type), intent(in) :: result
      character(:), allocatable :: text
      text = ''
      if (allocated(result%message)) text = result%message
      if (result%status == result_converged) return
      if (text == '') text = 'no reason given'
      if (result%status == result_not_converged) text = trim(result_status_name(result%status))//': '//text
   end function warning_text
end module dg_warnings_table
