!> Depths and diameters in the messages of rules.
module dg_shown_size
   use dg_kinds, only: wp
   use dg_unit_kind, only: in_units, unit_diameter, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: depth_words, diameter_words
   public :: depth_digits, length_digits, diameter_digits

   !> Digits of depths, of other lengths, and of diameters in messages.
   integer, parameter :: depth_digits = 9, length_digits = 7, diameter_digits = 6

contains

   !> A depth with its unit.
   pure function depth_words(units, depth) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: depth          !< [m]
      character(:), allocatable :: text
      text = in_units(units, unit_length, depth, depth_digits)
   end function depth_words

   !> A diameter with its unit.
   pure function diameter_words(units, diameter, digits) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: diameter       !< [m]
      integer, intent(in) :: digits
      character(:), allocatable :: text
      text = in_units(units, unit_diameter, diameter, digits)
   end function diameter_words
end module dg_shown_size
