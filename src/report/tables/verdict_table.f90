!> The block 'Can it be done?' on standard output: one entry a load case, before all tables.
module dg_verdict_table
   use dg_case_result, only: case_result_type
   use dg_job, only: job_type, model_name
   use dg_model, only: model_type
   use dg_number_text, only: left_aligned
   use dg_text, only: append_text, text_type
   use dg_verdict, only: answer_name, answer_no
   use dg_verdict_text, only: verdict_sentences
   use dg_whole_string, only: whole_string_type
   use dg_wrapped_text, only: append_wrapped, page_width
   implicit none
   private
   public :: verdict_table, verdict_title, answer_word

   character(*), parameter :: verdict_title = 'Can it be done?'
   !> Width of names, and of the answer.
   integer, parameter :: most_name = 26, answer_width = 9

contains

   !> Title of the run and the lines of the block, models one after another.
   pure function verdict_table(job, model, results, wholes) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)      !< as many
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: heading
      integer :: i, k, width
      allocate (lines(0))
      if (allocated(job%title)) then
         if (job%title /= '') call append_text(lines, job%title)
      end if
      width = 0
      do k = 1, size(results)
         width = max(width, min(len(model%cases(results(k)%case_index)%name), most_name) + 2)
      end do
      do i = 1, size(job%models)
         if (.not. any(results%model == job%models(i))) cycle
         heading = verdict_title
         if (size(job%models) > 1) heading = heading//' Model '//trim(model_name(job%models(i)))
         call append_text(lines, '')
         call append_text(lines, heading)
         do k = 1, size(results)
            if (results(k)%model /= job%models(i)) cycle
            associate (load_case => model%cases(results(k)%case_index))
               call append_wrapped(lines, left_aligned(load_case%name, width)// &
                                   left_aligned(answer_word(wholes(k)%verdict%answer), answer_width), &
                                   verdict_sentences(job%units, load_case, wholes(k)%verdict)//'.', page_width)
            end associate
         end do
      end do
   end function verdict_table

   !> The answer as a reader sees it: NO stands out.
   pure function answer_word(answer) result(word)
      integer, intent(in) :: answer
      character(:), allocatable :: word
      word = trim(answer_name(answer))
      if (answer == answer_no) word = 'NO'
   end function answer_word
end module dg_verdict_table
