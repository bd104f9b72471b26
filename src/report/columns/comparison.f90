!> Calculated against measured and reference values.
module dg_comparison
   use dg_kinds, only: wp
   use dg_missing, only: given, is_missing, missing, optional_real
   implicit none
   private
   public :: percent_error, in_percent, percent_of, difference, as_measured

contains

   !> 100 |calculated - other|/|other| [%]; absent where either is, or `other` so near zero that no number holds it.
   elemental function percent_error(calculated, other) result(error)
      real(wp), intent(in) :: calculated
      type(optional_real), intent(in) :: other
      type(optional_real) :: error
      if (is_missing(calculated) .or. .not. other%present) return
      if (abs(other%value) <= 100.0_wp*abs(calculated - other%value)/huge(1.0_wp)) return
      error = given(100.0_wp*abs(calculated - other%value)/abs(other%value))
   end function percent_error

   !> A share [-] in per cent.
   elemental function in_percent(share) result(percent)
      type(optional_real), intent(in) :: share
      type(optional_real) :: percent
      percent = share
      if (share%present) percent%value = 100.0_wp*share%value
   end function in_percent

   !> A share [-] in per cent; missing where it is.
   elemental function percent_of(share) result(percent)
      real(wp), intent(in) :: share
      real(wp) :: percent
      percent = missing
      if (.not. is_missing(share)) percent = 100.0_wp*share
   end function percent_of

   !> Hook load to compare with a gauge of the rig: the reading of its indicator, or without a rig the string's own.
   elemental function as_measured(hookload, weight_indicator) result(load)
      real(wp), intent(in) :: hookload
      real(wp), intent(in) :: weight_indicator     !< missing where no rig is given
      real(wp) :: load
      load = weight_indicator
      if (is_missing(weight_indicator)) load = hookload
   end function as_measured

   !> One number less another; missing where either is.
   elemental function difference(one, other) result(value)
      real(wp), intent(in) :: one, other
      real(wp) :: value
      value = missing
      if (.not. (is_missing(one) .or. is_missing(other))) value = one - other
   end function difference
end module dg_comparison
