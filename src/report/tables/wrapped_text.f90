!> Lines of text for a page of fixed width.
module dg_wrapped_text
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: append_wrapped, page_width

   integer, parameter :: page_width = 120

contains

   !> Appends a text in lines of at most `width`, broken at blanks where there are any, later lines
   !> indented by two.
   pure subroutine append_wrapped(lines, head, text, width)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: head
      character(*), intent(in) :: text
      integer, intent(in) :: width
      character(*), parameter :: indent = '  '
      character(:), allocatable :: rest
      integer :: cut
      rest = head//text
      do while (len_trim(rest) > width)
         cut = index(rest(:width + 1), ' ', back=.true.)
         if (cut <= len(indent) + 1) cut = width + 1
         call append_text(lines, trim(rest(:cut - 1)))
         rest = indent//trim(adjustl(rest(cut:)))
      end do
      call append_text(lines, trim(rest))
   end subroutine append_wrapped
end module dg_wrapped_text
