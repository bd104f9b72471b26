!> A real number as text of ten significant digits, letter by letter what `write (text, '(g0.10)')` makes of it, at a
!> twenty-fifth of the cost: result files are mostly numbers.
module dg_ten_digits
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_text, only: put_piece
   implicit none
   private
   public :: put_ten_digits, longest_number

   !> Letters of the longest text: -0.1234567890E-307.
   integer, parameter :: longest_number = 18

   integer, parameter :: digits_wanted = 10
   !> Up to this power of ten a double holds it exactly.
   integer, parameter :: most_exact = 22
   integer :: power_index
   real(wp), parameter :: power_of_ten(0:most_exact) = [(10.0_wp**power_index, power_index=0, most_exact)]
   !> In units of 2**-18: right to 3e-8, enough for the greatest exponent of a double.
   integer, parameter :: log10_of_2 = 78913
   character(2), parameter :: pair(0:99) = [(achar(iachar('0') + power_index/10)//achar(iachar('0') + modulo(power_index, 10)), &
                                             power_index=0, 99)]
   !> Least and one more than the greatest integer of ten digits.
   integer(int64), parameter :: least = 1000000000_int64, too_many = 10*least
   !> So near a half the last digit is left to the run-time library. Scaling rounds at most three times, each by at most
   !> 2**-53 of a number below 1e10: by 3.4e-6 in all.
   real(wp), parameter :: near_half = 1.0e-4_wp

contains

   !> Puts `value` behind the letters that a text has so far. Plain from 0.1 up to 1e10, with an exponent else; a negative zero
   !> has its sign. Any number is right, infinite ones and NaN too.
   pure subroutine put_ten_digits(text, filled, value)
      character(*), intent(inout) :: text     !< with room for `longest_number` letters
      integer, intent(inout) :: filled        !< letters so far
      real(wp), intent(in) :: value
      character(digits_wanted) :: letters
      integer(int64) :: whole
      integer :: exponent, i
      logical :: certain
      call find_digits(abs(value), whole, exponent, certain)
      if (.not. certain) then
         call put_by_library(text, filled, value)
         return
      end if
      letters = decimal(whole)
      if (sign(1.0_wp, value) < 0.0_wp) call put_piece(text, filled, '-')
      if (exponent >= 0 .and. exponent < digits_wanted) then
         ! all digits one place further on, a copy of fixed length; those before the point back by one
         text(filled + 2:filled + digits_wanted + 1) = letters
         do i = 1, exponent + 1
            text(filled + i:filled + i) = letters(i:i)
         end do
         text(filled + exponent + 2:filled + exponent + 2) = '.'
         filled = filled + digits_wanted + 1
      else
         call put_piece(text, filled, '0.')
         call put_piece(text, filled, letters)
         if (exponent /= -1) call put_exponent(text, filled, exponent + 1)
      end if
   end subroutine put_ten_digits

   !> An exponent of one or two digits: find_digits is certain of no other.
   pure subroutine put_exponent(text, filled, number)
      character(*), intent(inout) :: text
      integer, intent(inout) :: filled
      integer, intent(in) :: number
      integer :: tens
      call put_piece(text, filled, merge('E-', 'E+', number < 0))
      tens = abs(number)/10
      if (tens > 0) call put_piece(text, filled, achar(iachar('0') + tens))
      call put_piece(text, filled, achar(iachar('0') + abs(number) - 10*tens))
   end subroutine put_exponent

   !> Digits and exponent of x >= 0: x is about whole*10**(exponent - 9), with `whole` of ten digits, or zero.
   pure subroutine find_digits(x, whole, exponent_of_x, certain)
      real(wp), intent(in) :: x
      integer(int64), intent(out) :: whole
      integer, intent(out) :: exponent_of_x
      logical, intent(out) :: certain         !< false: too near a half, or too large or small to be scaled so well
      real(wp) :: scaled, rest
      integer(int64) :: bits
      integer :: power
      whole = 0
      ! by its bits; at most one too small; of an infinite number or a NaN it is enormous, so that no operation is done with those
      bits = transfer(x, bits)
      exponent_of_x = shifta(log10_of_2*(int(shiftr(bits, 52)) - 1023), 18)
      certain = bits == 0
      if (certain) then
         exponent_of_x = 0
         return
      end if
      power = digits_wanted - 1 - exponent_of_x
      certain = abs(power) <= 2*most_exact
      if (.not. certain) return
      if (power > most_exact) then
         scaled = x*power_of_ten(most_exact)*power_of_ten(power - most_exact)
      else if (power >= 0) then
         scaled = x*power_of_ten(power)
      else if (power >= -most_exact) then
         scaled = x/power_of_ten(-power)
      else
         scaled = x/power_of_ten(most_exact)/power_of_ten(-power - most_exact)
      end if
      if (scaled >= real(too_many, wp)) then
         exponent_of_x = exponent_of_x + 1
         scaled = scaled/10.0_wp
      end if
      whole = int(scaled, int64)
      rest = scaled - real(whole, wp)
      if (rest > 0.5_wp) whole = whole + 1
      certain = abs(rest - 0.5_wp) > near_half .and. whole >= least .and. whole < too_many
   end subroutine find_digits

   !> The ten digits of an integer from 0 on.
   pure function decimal(whole) result(letters)
      integer(int64), intent(in) :: whole
      character(digits_wanted) :: letters
      integer(int64) :: left, hundredth
      integer :: i
      left = whole
      do i = digits_wanted - 1, 1, -2
         hundredth = left/100
         letters(i:i + 1) = pair(int(left - 100*hundredth))
         left = hundredth
      end do
   end function decimal

   pure subroutine put_by_library(text, filled, value)
      character(*), intent(inout) :: text
      integer, intent(inout) :: filled
      real(wp), intent(in) :: value
      character(40) :: buffer
      write (buffer, '(g0.10)') value
      call put_piece(text, filled, trim(buffer))
   end subroutine put_by_library
end module dg_ten_digits
