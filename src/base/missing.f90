!> A number in a list that has no value there: a safety factor where no yield strength is known, a shear force in a
!> flexible string. Such numbers are written as empty fields (CSV) and as NaN (HDF5); no NaN is ever computed with.
module dg_missing
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   implicit none
   private
   public :: missing, is_missing, is_shown

   !> Marks a number that is not there. No quantity of a drillstring comes near it.
   real(wp), parameter :: missing = -huge(1.0_wp)

   !> Exponent of an infinite number and of a NaN (IEEE 754, 64 bits).
   integer(int64), parameter :: all_ones = int(z'7FF0000000000000', int64)

contains

   !> Whether a number is not there.
   elemental function is_missing(value) result(yes)
      real(wp), intent(in) :: value
      logical :: yes
      yes = value <= missing
   end function is_missing

   !> Whether a number may be written: one that is there, and finite. A quotient may be beyond all numbers, as the error
   !> against a measurement next to nothing.
   elemental function is_shown(value) result(yes)
      real(wp), intent(in) :: value
      logical :: yes
      ! by its bits: to compare a NaN is an operation that may be trapped
      yes = iand(transfer(value, all_ones), all_ones) /= all_ones
      if (yes) yes = .not. is_missing(value)
   end function is_shown
end module dg_missing
