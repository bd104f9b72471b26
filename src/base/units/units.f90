!> Unit systems of decks and reports, each a column of the table of dg_quantity. Inside the program everything is SI; only deck
!> and report convert. A factor is the SI value of one user unit: si = user*factor.
module dg_units
   use dg_kinds, only: wp
   use dg_quantity, only: quantity_angle, quantity_curvature, quantity_density, quantity_force, quantity_length, &
      quantity_mass, quantity_moment, quantity_stress, quantity_wall, quantity_width, rows, system_base, system_count, &
      system_field, system_name, system_si, unit_type
   use dg_text, only: lower_case
   implicit none
   private
   public :: unit_system_type, unit_system, system_of, si_units, field_units, base_units, deck_system, unit_in

   !> SI, until `unit_system` fills it. `unit_in` tells the unit of any quantity; those that texts and pictures ask for most are
   !> components.
   type :: unit_system_type
      integer :: system = system_si           !< column of the table
      character(6) :: name = system_name(system_si)
      !> Factors.
      real(wp) :: length = rows(quantity_length)%units(system_si)%factor             !< [m]
      real(wp) :: diameter = rows(quantity_width)%units(system_si)%factor            !< [m]
      real(wp) :: angle = rows(quantity_angle)%units(system_si)%factor               !< [rad]
      real(wp) :: mass_per_length = rows(quantity_mass)%units(system_si)%factor      !< [kg/m]
      real(wp) :: density = rows(quantity_density)%units(system_si)%factor           !< [kg/m3]
      real(wp) :: force = rows(quantity_force)%units(system_si)%factor               !< [N]
      real(wp) :: moment = rows(quantity_moment)%units(system_si)%factor             !< [N.m]
      real(wp) :: stress = rows(quantity_stress)%units(system_si)%factor             !< [Pa]
      real(wp) :: curvature = rows(quantity_curvature)%units(system_si)%factor       !< [1/m]
      real(wp) :: wall_stiffness = rows(quantity_wall)%units(system_si)%factor       !< [N/m2]
      !> Names of length and force, the same in texts and in headers of columns.
      character(10) :: length_label = rows(quantity_length)%units(system_si)%label
      character(10) :: force_label = rows(quantity_force)%units(system_si)%label
   contains
      procedure :: factor_of
      procedure :: label_of
   end type unit_system_type

contains

   !> The system of that number.
   pure function system_of(system) result(units)
      integer, intent(in) :: system
      type(unit_system_type) :: units
      units%system = system
      units%name = system_name(system)
      units%length = factor(quantity_length)
      units%diameter = factor(quantity_width)
      units%angle = factor(quantity_angle)
      units%mass_per_length = factor(quantity_mass)
      units%density = factor(quantity_density)
      units%force = factor(quantity_force)
      units%moment = factor(quantity_moment)
      units%stress = factor(quantity_stress)
      units%curvature = factor(quantity_curvature)
      units%wall_stiffness = factor(quantity_wall)
      units%length_label = rows(quantity_length)%units(system)%label
      units%force_label = rows(quantity_force)%units(system)%label
   contains
      pure function factor(quantity) result(one)
         integer, intent(in) :: quantity
         real(wp) :: one
         one = rows(quantity)%units(system)%factor
      end function factor
   end function system_of

   !> The unit of a quantity in a system.
   elemental function unit_in(units, quantity) result(unit)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      type(unit_type) :: unit
      unit = rows(quantity)%units(units%system)
   end function unit_in

   !> SI value of one unit of a quantity.
   elemental function factor_of(units, quantity) result(factor)
      class(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      real(wp) :: factor
      factor = rows(quantity)%units(units%system)%factor
   end function factor_of

   !> Name of a unit, with blanks behind it.
   pure function label_of(units, quantity) result(label)
      class(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      character(len(rows(1)%units(1)%label)) :: label
      label = rows(quantity)%units(units%system)%label
   end function label_of

   !> The system of that name, letter case aside; SI where there is none.
   pure function unit_system(name) result(units)
      character(*), intent(in) :: name
      type(unit_system_type) :: units
      units = system_of(max(deck_system(name), system_si))
   end function unit_system

   !> Number of the system of that name among those of decks, letter case aside; 0 where there is none.
   pure function deck_system(name) result(system)
      character(*), intent(in) :: name
      integer :: system
      do system = 1, system_count
         if (system /= system_base .and. lower_case(system_name(system)) == lower_case(name)) return
      end do
      system = 0
   end function deck_system

   !> The system of `units='SI'`.
   pure function si_units() result(units)
      type(unit_system_type) :: units
      units = system_of(system_si)
   end function si_units

   !> The system of `units='field'`.
   pure function field_units() result(units)
      type(unit_system_type) :: units
      units = system_of(system_field)
   end function field_units

   !> Units of programs: those of SI without multiples, angles in radians. No deck has them.
   pure function base_units() result(units)
      type(unit_system_type) :: units
      units = system_of(system_base)
   end function base_units
end module dg_units
