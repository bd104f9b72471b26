!> Tables of tests, written in one text with a mark between lines.
module dg_table_lines
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: lines_between

contains

   !> Lines of a text between marks.
   function lines_between(text, mark) result(lines)
      character(*), intent(in) :: text
      character, intent(in) :: mark
      type(text_type), allocatable :: lines(:)
      integer :: first, length
      allocate (lines(0))
      first = 1
      do while (first <= len(text))
         length = index(text(first:), mark) - 1
         if (length < 0) length = len(text) - first + 1
         call append_text(lines, text(first:first + length - 1))
         first = first + length + 1
      end do
   end function lines_between
end module dg_table_lines
