!> A number in a list that has no value there: a safety factor where no yield strength is known, a shear force in a
!> flexible string. Such numbers are written as empty fields (CSV) and as NaN (HDF5); no NaN is ever computed with.
module dg_missing
   use dg_kinds, only: wp
   implicit none
   private
   public :: missing, is_missing

   !> Marks a number that is not there. No quantity of a drillstring comes near it.
   real(wp), parameter :: missing = -huge(1.0_wp)

contains

   elemental function is_missing(value) result(yes)
      real(wp), intent(in) :: value
      logical :: yes
      yes = value <= missing
   end function is_missing
end module dg_missing
