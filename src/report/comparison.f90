!> Calculated against measured and reference values.
module dg_comparison
   use dg_kinds, only: wp
   use dg_load_case, only: given, optional_real
   implicit none
   private
   public :: percent_error

contains

   !> 100 |calculated - other|/|other| [%]; absent where `other` is absent or zero.
   elemental function percent_error(calculated, other) result(error)
      real(wp), intent(in) :: calculated
      type(optional_real), intent(in) :: other
      type(optional_real) :: error
      if (.not. other%present) return
      if (abs(other%value) <= 0.0_wp) return
      error = given(100.0_wp*abs(calculated - other%value)/abs(other%value))
   end function percent_error
end module dg_comparison
