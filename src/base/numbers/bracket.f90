!> Root of a falling function of one number, between two numbers on either side of it. The method is inverse quadratic
!> interpolation if the last three values allow it, else a secant at first and halving later. It is by Chandrupatla 1997, A new
!> hybrid quadratic/bisection algorithm, Adv. Eng. Softw. 28. A jump or a kink only costs halvings.
!>
!> The caller computes the values:
!>     bracket = new_bracket(low, value_low, high, value_high)
!>     do while (.not. is_narrow(bracket, tolerance))
!>        x = next_try(bracket, tolerance)
!>        call narrow(bracket, x, value at x)
!>     end do
module dg_bracket
   use dg_kinds, only: wp
   implicit none
   private
   public :: bracket_type, new_bracket, next_try, narrow, is_narrow

   type :: bracket_type
      real(wp) :: low = 0.0_wp                     !< here the value is >= 0
      real(wp) :: high = 0.0_wp                    !< here it is < 0
      real(wp), private :: value_low = 0.0_wp, value_high = 0.0_wp
      real(wp), private :: third = 0.0_wp, value_third = 0.0_wp   !< the end that was given up last
      logical, private :: has_third = .false.
      logical, private :: low_is_new = .false.     !< the end that was taken last
   end type bracket_type

contains

   !> From two numbers with their values, >= 0 at `low` and < 0 at `high`.
   pure function new_bracket(low, value_low, high, value_high) result(bracket)
      real(wp), intent(in) :: low, value_low, high, value_high
      type(bracket_type) :: bracket
      bracket%low = low
      bracket%high = high
      bracket%value_low = value_low
      bracket%value_high = value_high
   end function new_bracket

   !> True if both ends are within twice the tolerance of each other.
   pure function is_narrow(bracket, tolerance) result(is)
      type(bracket_type), intent(in) :: bracket
      real(wp), intent(in) :: tolerance
      logical :: is
      real(wp) :: middle
      middle = bracket%low + 0.5_wp*(bracket%high - bracket%low)
      is = abs(bracket%high - bracket%low) <= 2.0_wp*tolerance .or. .not. abs(middle - bracket%low) > 0.0_wp &
           .or. .not. abs(bracket%high - middle) > 0.0_wp          ! no number lies between
   end function is_narrow

   !> Where to look next: between the ends, no nearer to either than the tolerance.
   pure function next_try(bracket, tolerance) result(x)
      type(bracket_type), intent(in) :: bracket
      real(wp), intent(in) :: tolerance
      real(wp) :: x
      real(wp) :: newest, other, value_newest, value_other, share, along, rise, least
      newest = merge(bracket%low, bracket%high, bracket%low_is_new)
      other = merge(bracket%high, bracket%low, bracket%low_is_new)
      value_newest = merge(bracket%value_low, bracket%value_high, bracket%low_is_new)
      value_other = merge(bracket%value_high, bracket%value_low, bracket%low_is_new)
      share = 0.5_wp
      associate (third => bracket%third, value_third => bracket%value_third)
         if (.not. bracket%has_third) then
            share = value_newest/(value_newest - value_other)
         else if (abs(value_third - value_other) > 0.0_wp .and. abs(value_third - value_newest) > 0.0_wp) then
            along = (newest - other)/(third - other)
            rise = (value_newest - value_other)/(value_third - value_other)
            ! where the quadratic through the three is monotonic between the ends
            if (rise**2 < along .and. (1.0_wp - rise)**2 < 1.0_wp - along) &
               share = value_newest/(value_other - value_newest)*value_third/(value_other - value_third) &
                       + (third - newest)/(other - newest)*value_newest/(value_third - value_newest) &
                       *value_other/(value_third - value_other)
         end if
      end associate
      least = min(tolerance/abs(other - newest), 0.5_wp)
      x = newest + min(max(share, least), 1.0_wp - least)*(other - newest)
   end function next_try

   !> Takes a number between the ends, with its value.
   pure subroutine narrow(bracket, x, value)
      type(bracket_type), intent(inout) :: bracket
      real(wp), intent(in) :: x
      real(wp), intent(in) :: value
      bracket%low_is_new = value >= 0.0_wp
      bracket%has_third = .true.
      if (bracket%low_is_new) then
         bracket%third = bracket%low
         bracket%value_third = bracket%value_low
         bracket%low = x
         bracket%value_low = value
      else
         bracket%third = bracket%high
         bracket%value_third = bracket%value_high
         bracket%high = x
         bracket%value_high = value
      end if
   end subroutine narrow
end module dg_bracket
