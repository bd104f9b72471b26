!> Units of quantities in decks and messages: SI value and name.
module dg_unit_kind
   use dg_kinds, only: wp
   use dg_quantity, only: unit_none => quantity_none, unit_length => quantity_length, unit_diameter => quantity_width, &
      unit_angle => quantity_angle, unit_mass => quantity_mass, unit_density => quantity_density, unit_force => quantity_force, &
      unit_moment => quantity_moment, unit_modulus => quantity_modulus, unit_stress => quantity_stress, &
      unit_pressure => quantity_pressure, unit_wall => quantity_wall, unit_rotation => quantity_rotation, &
      unit_speed => quantity_speed, unit_gravity => quantity_gravity, unit_curvature => quantity_curvature, &
      unit_temperature => quantity_temperature, unit_expansion => quantity_expansion, unit_wear => quantity_wear, &
      unit_loss => quantity_loss, heaviest_mud, lightest_oil
   use dg_rounding, only: rounded_down
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: unit_factor, unit_label, in_units, at_most, heaviest_mud, lightest_oil
   public :: unit_none, unit_length, unit_diameter, unit_angle, unit_mass, unit_density, unit_force, unit_moment, &
      unit_modulus, unit_stress, unit_pressure, unit_wall, unit_rotation, unit_speed, unit_gravity, unit_curvature, &
      unit_temperature, unit_expansion, unit_wear, unit_loss

contains

   !> SI value of one unit of a quantity.
   elemental function unit_factor(units, quantity) result(factor)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      real(wp) :: factor
      factor = units%factor_of(quantity)
   end function unit_factor

   !> Name of a unit for readers; '' for plain numbers. It tells the length of its result, as threads call it (see to_text).
   pure function unit_label(units, quantity) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      character(len_trim(units%label_of(quantity))) :: label
      label = units%label_of(quantity)
   end function unit_label

   !> A value rounded down to so many digits in its unit where it is above 0: of a load or depth that is still possible.
   pure function at_most(units, quantity, value, digits) result(least)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      real(wp), intent(in) :: value
      integer, intent(in) :: digits
      real(wp) :: least
      least = value
      if (value > 0.0_wp) least = unit_factor(units, quantity)*rounded_down(value/unit_factor(units, quantity), digits)
   end function at_most

   !> A value in SI as messages tell it: in a deck's units, to so many digits, with the unit's name. It tells the length of its
   !> result, as threads call it (see to_text), with no more commas than pages for programmers can read.
   pure function in_units(units, quantity, value, digits) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      real(wp), intent(in) :: value       !< [SI]
      integer, intent(in) :: digits
      character(len_trim(to_text(value/units%factor_of(quantity), digits)//' '//units%label_of(quantity))) :: text
      text = to_text(value/units%factor_of(quantity), digits)//' '//units%label_of(quantity)
   end function in_units
end module dg_unit_kind
