!> Kinds of units in decks and messages: what SI value one has, and its name.
module dg_unit_kind
   use dg_kinds, only: wp
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: unit_factor, unit_label
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

   !> Name of a unit for messages; '' for plain numbers.
   pure function unit_label(units, unit) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      character(:), allocatable :: label
      logical :: field
      field = units%name == 'field'
      select case (unit)
      case (unit_length); label = pick('m', 'ft')
      case (unit_diameter); label = pick('mm', 'in')
      case (unit_angle); label = 'deg'
      case (unit_mass); label = pick('kg/m', 'lbm/ft')
      case (unit_density); label = pick('kg/m3', 'lbm/gal')
      case (unit_force); label = pick('kN', 'klbf')
      case (unit_moment); label = pick('kN.m', 'kft.lbf')
      case (unit_modulus); label = pick('GPa', '1e6 psi')
      case (unit_stress); label = pick('MPa', 'ksi')
      case (unit_wall); label = pick('kN/m2', 'klbf/ft2')
      case (unit_rotation); label = 'rpm'
      case (unit_speed); label = pick('m/s', 'ft/s')
      case (unit_gravity); label = 'm/s2'
      case default; label = ''
      end select
   contains
      pure function pick(si, other) result(one)
         character(*), intent(in) :: si, other
         character(:), allocatable :: one
         if (field) then
            one = other
         else
            one = si
         end if
      end function pick
   end function unit_label
end module dg_unit_kind
