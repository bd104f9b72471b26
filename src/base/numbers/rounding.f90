!> Rounding to a number of digits. To one side it is for limits and errors that a text must not put on the wrong side.
module dg_rounding
   use dg_kinds, only: wp
   implicit none
   private
   public :: rounded_down, rounded_up

contains

   !> A number > 0, rounded down to so many digits.
   elemental function rounded_down(number, digits) result(rounded)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      real(wp) :: rounded
      rounded = last_digit(number, digits)*real(floor(number/last_digit(number, digits)), wp)
   end function rounded_down

   !> A number > 0, rounded up to so many digits.
   elemental function rounded_up(number, digits) result(rounded)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      real(wp) :: rounded
      rounded = last_digit(number, digits)*real(ceiling(number/last_digit(number, digits)), wp)
   end function rounded_up

   !> Unit of the last of so many digits of a number > 0.
   elemental function last_digit(number, digits) result(unit)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      real(wp) :: unit
      unit = 10.0_wp**(floor(log10(number)) + 1 - digits)
   end function last_digit
end module dg_rounding
