!> Units in which people write a number in place of the deck's unit, with the number that is right in the deck.
module dg_likely_unit
   use dg_constants, only: foot, gallon, inch, pi, pound, pound_force, psi, standard_gravity
   use dg_kinds, only: wp
   use dg_quantity, only: heaviest_mud, lightest_oil, quantity_angle, quantity_density, quantity_force, quantity_gravity, &
                          quantity_length, quantity_mass, quantity_moment, quantity_pressure, quantity_rotation, &
                          quantity_speed, quantity_stress, quantity_wall, quantity_wear, quantity_width, system_field, &
                          system_metric, system_si
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_factor
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: unit_questions, mud_question, tonne, tonnes_question

   !> A unit that is not the deck's own.
   type :: other_unit_type
      integer :: quantity
      character(13) :: name
      real(wp) :: factor       !< SI value of one
      logical :: si, field, metric   !< likely in decks of these systems
      logical :: sure = .false.      !< no unit after it is asked for
   end type other_unit_type

   logical, parameter :: T = .true., F = .false.
   real(wp), parameter :: gravity = standard_gravity, minute = 60.0_wp, hour = 3600.0_wp
   !> The likeliest units of a quantity first.
   type(other_unit_type), parameter :: others(*) = [ &
      other_unit_type(quantity_force, 'N', 1.0_wp, T, F, F), &
      other_unit_type(quantity_force, 'daN', 10.0_wp, F, F, T), &
      other_unit_type(quantity_force, 'lbf', pound_force, F, T, F), &
      other_unit_type(quantity_force, 'kN', 1.0e3_wp, F, T, T), &
      other_unit_type(quantity_force, 'klbf', 1.0e3_wp*pound_force, T, F, T), &
      other_unit_type(quantity_force, 'lbf', pound_force, F, F, T), &
      other_unit_type(quantity_force, 't', 1.0e3_wp*gravity, T, T, F), &
      other_unit_type(quantity_force, 'kg', gravity, T, F, F), &
      other_unit_type(quantity_moment, 'N.m', 1.0_wp, T, F, T), &
      other_unit_type(quantity_moment, 'ft.lbf', foot*pound_force, F, T, F), &
      other_unit_type(quantity_moment, 'daN.m', 10.0_wp, T, F, T), &
      other_unit_type(quantity_moment, 'kN.m', 1.0e3_wp, F, T, F), &
      other_unit_type(quantity_moment, 'kft.lbf', 1.0e3_wp*foot*pound_force, T, F, T), &
      other_unit_type(quantity_pressure, 'bar', 1.0e5_wp, T, F, F), &
      other_unit_type(quantity_pressure, 'MPa', 1.0e6_wp, F, T, T), &
      other_unit_type(quantity_pressure, 'psi', psi, T, F, T), &
      other_unit_type(quantity_pressure, 'ksi', 1.0e3_wp*psi, F, T, F), &
      other_unit_type(quantity_pressure, 'bar', 1.0e5_wp, F, T, F), &
      other_unit_type(quantity_pressure, 'kPa', 1.0e3_wp, T, F, T), &
      other_unit_type(quantity_stress, 'MPa', 1.0e6_wp, F, T, T), &
      other_unit_type(quantity_stress, 'ksi', 1.0e3_wp*psi, T, F, T), &
      other_unit_type(quantity_stress, 'psi', psi, T, T, T), &
      other_unit_type(quantity_stress, 'bar', 1.0e5_wp, T, F, F), &
      other_unit_type(quantity_length, 'ft', foot, T, F, T), &
      other_unit_type(quantity_length, 'm', 1.0_wp, F, T, F), &
      other_unit_type(quantity_length, 'mm', 1.0e-3_wp, T, F, T), &
      other_unit_type(quantity_length, 'inches', inch, T, T, T), &
      other_unit_type(quantity_length, 'cm', 1.0e-2_wp, T, F, T), &
      other_unit_type(quantity_width, 'inches', inch, T, F, F), &
      other_unit_type(quantity_width, 'cm', 1.0e-2_wp, T, F, F), &
      other_unit_type(quantity_width, 'm', 1.0_wp, T, T, T), &
      other_unit_type(quantity_width, 'mm', 1.0e-3_wp, F, T, T), &
      other_unit_type(quantity_angle, 'rad', 1.0_wp, T, T, T), &
      other_unit_type(quantity_speed, 'm/min', 1.0_wp/minute, T, F, T), &
      other_unit_type(quantity_speed, 'ft/min', foot/minute, F, T, F), &
      other_unit_type(quantity_speed, 'm/h', 1.0_wp/hour, T, F, T), &
      other_unit_type(quantity_speed, 'ft/h', foot/hour, F, T, F), &
      other_unit_type(quantity_mass, 'lbm/ft', pound/foot, T, F, T), &
      other_unit_type(quantity_mass, 'kg/m', 1.0_wp, F, T, F), &
      other_unit_type(quantity_density, 'sg', 1.0e3_wp, T, T, F, sure=.true.), &
      other_unit_type(quantity_density, 'lbm/gal', pound/gallon, T, F, T), &
      other_unit_type(quantity_density, 'kPa/m', 1.0e3_wp/gravity, T, F, T, sure=.true.), &
      other_unit_type(quantity_density, 'kg/m3', 1.0_wp, F, T, T, sure=.true.), &
      other_unit_type(quantity_density, 'pcf (lbm/ft3)', pound/foot**3, T, T, F, sure=.true.), &
      other_unit_type(quantity_density, 'psi/ft', psi/foot/gravity, T, T, T, sure=.true.), &
      other_unit_type(quantity_gravity, 'ft/s2', foot, T, T, T), &
      other_unit_type(quantity_gravity, 'g', gravity, T, T, T), &
      other_unit_type(quantity_rotation, 'rev/s', 2.0_wp*pi, T, T, T), &
      other_unit_type(quantity_rotation, 'rad/s', 1.0_wp, T, T, T), &
      other_unit_type(quantity_wall, 'GPa', 1.0e9_wp, T, F, T), &
      other_unit_type(quantity_wall, 'MPa', 1.0e6_wp, T, F, T), &
      other_unit_type(quantity_wall, 'N/m2', 1.0_wp, T, F, T), &
      other_unit_type(quantity_wall, '1e6 psi', 1.0e6_wp*psi, F, T, F), &
      other_unit_type(quantity_wall, 'ksi', 1.0e3_wp*psi, F, T, F), &
      other_unit_type(quantity_wall, 'psi', psi, F, T, F), &
      other_unit_type(quantity_wear, '1e-10/psi', 1.0e-10_wp/psi, T, F, T), &
      other_unit_type(quantity_wear, '1e-14/Pa', 1.0e-14_wp, F, T, F), &
      other_unit_type(quantity_wear, '1/psi', 1.0_wp/psi, T, T, T), &
      other_unit_type(quantity_wear, '1/Pa', 1.0_wp, T, T, T)]
   !> Tonnes, and forces that are nearly theirs.
   real(wp), parameter :: tonne = 1000.0_wp, near_tonne = 0.1_wp
   !> Units that one message names.
   integer, parameter :: most_asked = 2

contains

   !> Text that asks for the units in which a number lies within a range: '. Is it in lbf? Then write 25'. Empty if no unit fits.
   pure function unit_questions(units, quantity, number, low, high, digits, what) result(text)
      type(unit_system_type), intent(in) :: units     !< of the deck
      integer, intent(in) :: quantity
      real(wp), intent(in) :: number                  !< as written
      real(wp), intent(in) :: low, high               !< [SI]
      integer, intent(in) :: digits                   !< of the right number
      character(*), intent(in), optional :: what      !< has the number, where the sentence before names two; absent: 'it'
      character(:), allocatable :: text, whose
      type(other_unit_type) :: other
      integer :: i, asked
      text = ''
      whose = 'it'
      if (present(what)) whose = what
      asked = 0
      do i = 1, size(others)
         other = others(i)
         if (other%quantity /= quantity .or. .not. is_likely(other, units%system)) cycle
         if (number*other%factor < low .or. number*other%factor > high) cycle
         text = text//'. Is '//whose//' in '//trim(other%name)//'? Then write '// &
                to_text(number*other%factor/unit_factor(units, quantity), digits)
         asked = asked + 1
         if (asked == most_asked .or. other%sure) return
      end do
   end function unit_questions

   !> Text that asks for the unit of a mud weight; empty if it is that of a mud in no likely unit. Mud in the unit of the other
   !> system with holes in inches may mean that all of the deck is in that system.
   pure function mud_question(units, density, digits) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: density                 !< as read [kg/m3]
      integer, intent(in) :: digits                   !< of the right number
      character(:), allocatable :: text
      text = unit_questions(units, quantity_density, density/units%density, lightest_oil, heaviest_mud, digits)
      if (units%system == system_field .and. index(text, ' sg?') > 0) &
         text = text//". If depths are in m, write units = 'metric' in &job"
      if (units%system == system_metric .and. index(text, ' lbm/gal?') > 0) &
         text = text//". If depths are in ft, write units = 'field' in &job"
   end function mud_question

   !> Question for the unit of a force, with the number that would be right for tonnes. kdaN are nearly tonnes.
   pure function tonnes_question(what, units, force, gravity, digits) result(text)
      character(*), intent(in) :: what     !< has the force
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: force        !< [N]
      real(wp), intent(in) :: gravity      !< [m/s2]
      integer, intent(in) :: digits
      character(:), allocatable :: text
      text = '. Check both numbers'
      if (abs(units%force/(tonne*gravity) - 1.0_wp) < near_tonne) return
      text = '. Is '//what//' in tonnes? '//to_text(force/units%force, digits)//' t are '// &
             in_units(units, quantity_force, force/units%force*tonne*gravity, digits)
   end function tonnes_question

   !> True for a unit that is likely in decks of a system.
   pure function is_likely(other, system) result(likely)
      type(other_unit_type), intent(in) :: other
      integer, intent(in) :: system
      logical :: likely
      likely = other%si .and. system == system_si
      if (system == system_field) likely = other%field
      if (system == system_metric) likely = other%metric
   end function is_likely
end module dg_likely_unit
