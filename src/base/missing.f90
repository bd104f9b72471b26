!> Numbers that may be absent: a safety factor where no yield strength is known, a shear force in a flexible string. They are
!> written as empty fields (CSV) and as NaN (HDF5); no NaN is ever computed with.
!>
!> `missing` marks an absent number among others, as in an array. `optional_real` is one number that may be absent. Do not
!> calculate with `missing`: the result overflows.
module dg_missing
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   implicit none
   private
   public :: missing, missing_count, is_missing, is_mark, is_shown, optional_real, given, known

   !> Marks a number that is not there. No quantity of a drillstring comes near it.
   real(wp), parameter :: missing = -huge(1.0_wp)
   !> Marks a whole number that is not there.
   integer, parameter :: missing_count = -huge(1)

   !> A number that may be absent.
   type :: optional_real
      logical :: present = .false.
      real(wp) :: value = 0.0_wp
   end type optional_real

   !> True for `missing` and `missing_count`.
   interface is_missing
      module procedure is_missing_number, is_missing_count
   end interface is_missing

   !> Exponent of an infinite number and of a NaN (IEEE 754, 64 bits).
   integer(int64), parameter :: all_ones = int(z'7FF0000000000000', int64)

contains

   elemental function is_missing_number(value) result(yes)
      real(wp), intent(in) :: value
      logical :: yes
      yes = value <= missing
   end function is_missing_number

   elemental function is_missing_count(value) result(yes)
      integer, intent(in) :: value
      logical :: yes
      yes = value <= missing_count
   end function is_missing_count

   !> True if a number is `missing` itself. A NaN, which traps where it is compared, is not.
   elemental function is_mark(value) result(yes)
      real(wp), intent(in) :: value
      logical :: yes
      yes = transfer(value, 0_int64) == transfer(missing, 0_int64)
   end function is_mark

   !> An optional number that is present.
   elemental function given(value) result(number)
      real(wp), intent(in) :: value
      type(optional_real) :: number
      number = optional_real(.true., value)
   end function given

   !> A number that may be missing as an optional one.
   elemental function known(value) result(number)
      real(wp), intent(in) :: value
      type(optional_real) :: number
      if (.not. is_missing(value)) number = given(value)
   end function known

   !> True if a number can be written: present and finite. A quotient may overflow, as the error relative to a measurement close to
   !> zero.
   elemental function is_shown(value) result(yes)
      real(wp), intent(in) :: value
      logical :: yes
      ! by its bits: to compare a NaN is an operation that may be trapped
      yes = iand(transfer(value, all_ones), all_ones) /= all_ones
      if (yes) yes = .not. is_missing(value)
   end function is_shown
end module dg_missing
