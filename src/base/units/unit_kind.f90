!> Kinds of units in decks and messages: what SI value one has, and its name.
module dg_unit_kind
   use dg_kinds, only: wp
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: unit_factor, unit_label, in_units
   public :: unit_none, unit_length, unit_diameter, unit_angle, unit_mass, unit_density, unit_force, unit_moment, &
      unit_modulus, unit_stress, unit_wall, unit_rotation, unit_speed, unit_gravity, unit_curvature

   !> Room for a number and the name of its unit, and for that name.
   integer, parameter :: told_width = 40, longest_label = 10

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
   integer, parameter :: unit_curvature = 14

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
      case (unit_curvature); factor = units%curvature
      case default; factor = 1.0_wp
      end select
   end function unit_factor

   !> Name of a unit, with blanks behind it.
   pure function padded_label(units, unit) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      character(longest_label) :: label
      select case (unit)
      case (unit_length); label = pick('m', 'ft', 'm')
      case (unit_diameter); label = pick('mm', 'in', 'm')
      case (unit_angle); label = pick('deg', 'deg', 'rad')
      case (unit_mass); label = pick('kg/m', 'lbm/ft', 'kg/m')
      case (unit_density); label = pick('kg/m3', 'lbm/gal', 'kg/m3')
      case (unit_force); label = pick('kN', 'klbf', 'N')
      case (unit_moment); label = pick('kN.m', 'kft.lbf', 'N.m')
      case (unit_modulus); label = pick('GPa', '1e6 psi', 'Pa')
      case (unit_stress); label = pick('MPa', 'ksi', 'Pa')
      case (unit_wall); label = pick('kN/m2', 'klbf/ft2', 'N/m2')
      case (unit_rotation); label = pick('rpm', 'rpm', 'rad/s')
      case (unit_speed); label = pick('m/s', 'ft/s', 'm/s')
      case (unit_curvature); label = pick('deg/30 m', 'deg/100 ft', 'rad/m')
      case (unit_gravity); label = 'm/s2'
      case default; label = ''
      end select
   contains
      pure function pick(si, field, base) result(one)
         character(*), intent(in) :: si, field, base
         character(longest_label) :: one
         select case (units%name)
         case ('field'); one = field
         case ('base'); one = base
         case default; one = si
         end select
      end function pick
   end function padded_label

   pure function label_length(units, unit) result(length)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      integer :: length
      length = len_trim(padded_label(units, unit))
   end function label_length

   !> Name of a unit for messages; '' for plain numbers. It tells the length of its result, as threads call it (see to_text).
   pure function unit_label(units, unit) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      character(label_length(units, unit)) :: label
      label = padded_label(units, unit)
   end function unit_label

   !> A value in SI as messages tell it: in a deck's units, to so many digits, with the unit's name and blanks behind it. Of a
   !> fixed length, as threads call it (see to_text).
   pure function in_units(units, unit, value, digits) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      real(wp), intent(in) :: value       !< [SI]
      integer, intent(in) :: digits
      character(told_width) :: text
      text = to_text(value/unit_factor(units, unit), digits)//' '//padded_label(units, unit)
   end function in_units
end module dg_unit_kind
