!> First decimal digits of a number, much faster than by the run-time library. The result says if they are uncertain.
module dg_decimal_digits
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   implicit none
   private
   public :: find_digits, most_digits

   integer, parameter :: most_digits = 10
   !> Up to this power of ten a double holds it exactly.
   integer, parameter :: most_exact = 22
   integer :: i, ten
   real(wp), parameter :: power_of_ten(0:most_exact) = [(10.0_wp**i, i=0, most_exact)]
   integer(int64), parameter :: whole_power(0:most_digits) = [(10_int64**i, i=0, most_digits)]
   !> In units of 2**-18: right to 1e-6, enough for the greatest exponent of a double.
   integer, parameter :: log10_of_2 = 78913
   character(2), parameter :: pair(0:99) = [((achar(iachar('0') + ten)//achar(iachar('0') + i), i=0, 9), ten=0, 9)]
   !> Distance from a half within which the run-time library decides the last digit. Scaling rounds at most three times, each by at
   !> most 2**-53 of a number below 1e10: by 3.4e-6 in all.
   real(wp), parameter :: near_half = 1.0e-4_wp

contains

   !> Digits and exponent of x >= 0, rounded: x is about d.ddd times ten to the exponent. Of zero all digits are '0'.
   pure subroutine find_digits(x, digits, letters, exponent, certain)
      real(wp), intent(in) :: x
      integer, intent(in) :: digits                        !< 1 to most_digits
      character(most_digits), intent(out) :: letters       !< the last `digits` of them count
      integer, intent(out) :: exponent
      logical, intent(out) :: certain         !< false: too near a half, or too large or small to be scaled so well
      real(wp) :: scaled, rest
      integer(int64) :: bits, whole, hundredth
      integer :: power, place
      ! by its bits, at most one too small; an infinite number or a NaN gives an enormous one, and needs no operation
      bits = transfer(x, bits)
      exponent = shifta(log10_of_2*(int(shiftr(bits, 52)) - 1023), 18)
      certain = bits == 0
      if (certain) then
         letters = '0000000000'
         exponent = 0
         return
      end if
      power = digits - 1 - exponent
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
      if (scaled >= power_of_ten(digits)) then
         exponent = exponent + 1
         scaled = scaled/10.0_wp
      end if
      whole = int(scaled, int64)
      rest = scaled - real(whole, wp)
      if (rest > 0.5_wp) whole = whole + 1
      certain = abs(rest - 0.5_wp) > near_half .and. whole >= whole_power(digits - 1) .and. whole < whole_power(digits)
      do place = most_digits - 1, 1, -2
         hundredth = whole/100
         letters(place:place + 1) = pair(int(whole - 100*hundredth))
         whole = hundredth
      end do
   end subroutine find_digits
end module dg_decimal_digits
