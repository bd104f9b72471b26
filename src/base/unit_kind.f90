!> Kinds of units in decks and messages: what SI value one has, and its name.
module dg_unit_kind
   use dg_kinds, only: wp
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: unit_factor, unit_label, quantity_text
   public :: unit_none, unit_length, unit_diameter, unit_angle, unit_mass, unit_density, unit_force, unit_moment, &
      unit_modulus, unit_stress, unit_wall, unit_rotation, unit_speed, unit_gravity

   integer, parameter :: unit_none = 0
   integer, parameter :: unit_length = 1
   integer, parameter :: unit_diameter = 2
   integer, parameter :: unit_angle = 3
   integer, parameter :: unit_mass = 4       !< mass per length
   integer, parameter :: unit_density = 5
   integer, parameter :: unit_force = 6
   integer, parameter :: unit_moment = 7
   integer, parameter :: unit_modulus = 8
   integer, parameter :: unit_stress = 9
   integer, parameter :: unit_wall = 10      !< wall stiffness
   integer, parameter :: unit_rotation = 11
   integer, parameter :: unit_speed = 12
   integer, parameter :: unit_gravity = 13   !< m/s2 in both systems

contains

   !> SI value of one deck unit of a kind.
   pure function unit_factor(units, unit) result(factor)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      real(wp) :: factor
      select case (unit)
      case (unit_length); factor = units%length
      case (unit_diameter); factor = units%diameter
      case (unit_angle); factor = units%angle
      case (unit_mass); factor = units%mass_per_length
      case (unit_density); factor = units%density
      case (unit_force); factor = units%force
      case (unit_moment); factor = units%moment
      case (unit_modulus); factor = units%modulus
      case (unit_stress); factor = units%stress
      case (unit_wall); factor = units%wall_stiffness
      case (unit_rotation); factor = units%rotation_speed
      case (unit_speed); factor = units%trip_speed
      case default; factor = 1.0_wp
      end select
   end function unit_factor

   !> Name of a unit, with blanks behind it.
   pure function padded_label(units, unit) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      character(8) :: label
      logical :: field
      field = units%name == 'field'
      select case (unit)
      case (unit_length); label = merge('ft', 'm ', field)
      case (unit_diameter); label = merge('in', 'mm', field)
      case (unit_angle); label = 'deg'
      case (unit_mass); label = merge('lbm/ft', 'kg/m  ', field)
      case (unit_density); label = merge('lbm/gal', 'kg/m3  ', field)
      case (unit_force); label = merge('klbf', 'kN  ', field)
      case (unit_moment); label = merge('kft.lbf', 'kN.m   ', field)
      case (unit_modulus); label = merge('1e6 psi', 'GPa    ', field)
      case (unit_stress); label = merge('ksi', 'MPa', field)
      case (unit_wall); label = merge('klbf/ft2', 'kN/m2   ', field)
      case (unit_rotation); label = 'rpm'
      case (unit_speed); label = merge('ft/s', 'm/s ', field)
      case (unit_gravity); label = 'm/s2'
      case default; label = ''
      end select
   end function padded_label

   pure function label_length(units, unit) result(length)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      integer :: length
      length = len_trim(padded_label(units, unit))
   end function label_length

   pure function quantity_length(units, unit, value, digits) result(length)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      real(wp), intent(in) :: value
      integer, intent(in) :: digits
      integer :: length
      length = len(to_text(value/unit_factor(units, unit), digits)) + 1 + label_length(units, unit)
   end function quantity_length

   !> Name of a unit for messages; '' for plain numbers. It tells the length of its result, as threads call it (see to_text).
   pure function unit_label(units, unit) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      character(label_length(units, unit)) :: label
      label = padded_label(units, unit)
   end function unit_label

   !> A value in SI as messages tell it: in a deck's units, to so many digits, with the unit's name.
   pure function quantity_text(units, unit, value, digits) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      real(wp), intent(in) :: value       !< [SI]
      integer, intent(in) :: digits
      character(quantity_length(units, unit, value, digits)) :: text
      text = to_text(value/unit_factor(units, unit), digits)//' '//padded_label(units, unit)
   end function quantity_text
end module dg_unit_kind
