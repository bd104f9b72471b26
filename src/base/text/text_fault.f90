!> Faults of a user's text that would show or run as something else. They are invalid bytes of UTF-8, letters that turn the
!> direction of writing, and a first letter that makes a cell a formula.
module dg_text_fault
   use dg_printable, only: turning_code
   use dg_text, only: letter_end, to_text
   implicit none
   private
   public :: find_text_fault

   character(*), parameter :: tab = achar(9), carriage_return = achar(13)
   !> First letters of a formula.
   character(*), parameter :: formula_signs = '=+-@'//tab//carriage_return

contains

   !> The first fault of a text in words that go on behind the text itself; '' for a text without fault.
   pure subroutine find_text_fault(text, in_cell, fault)
      character(*), intent(in) :: text
      logical, intent(in) :: in_cell                        !< the text becomes a cell of a table in a file
      character(:), allocatable, intent(out) :: fault
      integer :: first, last
      character(2) :: code
      fault = ''
      first = 1
      do while (first <= len(text))
         last = letter_end(text, first)
         if (last == 0) then
            write (code, '(z2.2)') iachar(text(first:first))
            fault = 'is not UTF-8: byte '//to_text(first)//' is hexadecimal '//code//'; save the file as UTF-8'
            return
         end if
         if (turning_code(text(first:last)) /= '') then
            fault = 'holds the letter U+'//turning_code(text(first:last))//', which turns the direction of writing; remove it'
            return
         end if
         first = last + 1
      end do
      if (.not. in_cell) return
      first = verify(text, ' ')
      if (first == 0) return
      if (index(formula_signs, text(first:first)) == 0) return
      select case (text(first:first))
      case (tab); fault = 'a tab'
      case (carriage_return); fault = 'a carriage return'
      case default; fault = text(first:first)
      end select
      fault = 'begins with '//fault//'. A spreadsheet would run that cell as a formula; begin with a letter or a digit'
   end subroutine find_text_fault
end module dg_text_fault
