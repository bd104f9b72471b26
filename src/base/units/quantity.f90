!> Quantities of decks and results, and their units: one table, a row for each quantity, an entry for each system of units.
!> Inside the program everything is SI. A new system is one more entry in each row, a new quantity one more row: the compiler
!> refuses a table that lacks one.
!> Specific gravity counts from 1000 kg/m3.
module dg_quantity
   use dg_kinds, only: wp
   use dg_constants, only: degree, foot, gallon, inch, pi, pound, pound_force, psi
   implicit none
   private
   public :: unit_type, rows, heaviest_mud, lightest_oil
   public :: system_si, system_field, system_metric, system_base, system_count, system_name, deck_systems
   public :: quantity_none, quantity_text, quantity_length, quantity_width, quantity_angle, quantity_mass, quantity_density, &
      quantity_force, quantity_moment, quantity_line_load, quantity_modulus, quantity_stress, quantity_pressure, quantity_wall, &
      quantity_curvature, quantity_rotation, quantity_speed, quantity_gravity, quantity_percent, quantity_turns, quantity_time, &
      quantity_temperature, quantity_expansion, quantity_wear, quantity_loss

   integer, parameter :: quantity_none = 0       !< a number without unit
   integer, parameter :: quantity_text = 1       !< a text, or a number that stands for one
   integer, parameter :: quantity_length = 2     !< along the hole, or of a position
   integer, parameter :: quantity_width = 3      !< a diameter, a thickness, a lateral displacement
   integer, parameter :: quantity_angle = 4
   integer, parameter :: quantity_mass = 5       !< mass per length
   integer, parameter :: quantity_density = 6
   integer, parameter :: quantity_force = 7
   integer, parameter :: quantity_moment = 8
   integer, parameter :: quantity_line_load = 9  !< force per length
   integer, parameter :: quantity_modulus = 10
   integer, parameter :: quantity_stress = 11
   integer, parameter :: quantity_pressure = 12
   integer, parameter :: quantity_wall = 13      !< stiffness of a wall: force per length and penetration
   integer, parameter :: quantity_curvature = 14
   integer, parameter :: quantity_rotation = 15
   integer, parameter :: quantity_speed = 16
   integer, parameter :: quantity_gravity = 17
   integer, parameter :: quantity_percent = 18
   integer, parameter :: quantity_turns = 19     !< an angle of many turns
   integer, parameter :: quantity_time = 20      !< not named in headers of columns
   integer, parameter :: quantity_temperature = 21  !< difference of temperatures
   integer, parameter :: quantity_expansion = 22    !< thermal
   integer, parameter :: quantity_wear = 23         !< of casing: worn volume per work of friction
   integer, parameter :: quantity_loss = 24         !< of strength by temperature
   integer, parameter :: quantity_last = 24

   !> Systems of units. That of programs stands last; no deck has it.
   integer, parameter :: system_si = 1
   integer, parameter :: system_field = 2
   integer, parameter :: system_metric = 3
   integer, parameter :: system_base = 4
   integer, parameter :: system_count = 4
   character(6), parameter :: system_name(system_count) = [character(6) :: 'SI', 'field', 'metric', 'base']
   !> Systems that a deck may have, blanks between them.
   character(*), parameter :: deck_systems = 'SI field metric'

   !> A unit of a quantity.
   type :: unit_type
      character(10) :: label = ''        !< as readers write it
      character(9) :: suffix = ''        !< behind names of columns
      real(wp) :: factor = 1.0_wp        !< SI value of one
      character(14) :: alike = ''        !< a smaller unit that people write in its place; '': none
      real(wp) :: alike_count = 1.0_wp   !< so many of them are one
   end type unit_type

   !> A quantity in each system: SI, field, metric, base.
   type :: row_type
      integer :: quantity
      type(unit_type) :: units(system_count)
   end type row_type

   !> Heaviest kill mud, 22.5 lbm/gal [kg/m3].
   real(wp), parameter :: heaviest_mud = 2700.0_wp
   !> Lightest liquid in a well, diesel and crude oil [kg/m3].
   real(wp), parameter :: lightest_oil = 780.0_wp

   real(wp), parameter :: one = 1.0_wp, kilo = 1.0e3_wp, mega = 1.0e6_wp, giga = 1.0e9_wp
   real(wp), parameter :: gallons_in_cubic_foot = 1728.0_wp/231.0_wp
   real(wp), parameter :: bar = 1.0e5_wp, kilopascals = 100.0_wp
   real(wp), parameter :: ten_kilonewton = 1.0e4_wp
   real(wp), parameter :: rpm = 2.0_wp*pi/60.0_wp
   real(wp), parameter :: per_30_m = degree/30.0_wp, per_100_ft = degree/(100.0_wp*foot)
   type(unit_type), parameter :: metre = unit_type('m', 'm', one), newton_metre = unit_type('N.m', 'Nm', one)
   type(unit_type), parameter :: number = unit_type('', '', one), percent = unit_type('%', 'pct', one)
   type(unit_type), parameter :: turn = unit_type('turns', 'turns', 2.0_wp*pi), second = unit_type('s', '', one)
   type(unit_type), parameter :: in_degrees = unit_type('deg', 'deg', degree), radian = unit_type('rad', 'rad', one)
   type(unit_type), parameter :: kg_m = unit_type('kg/m', 'kg_m', one), kg_m3 = unit_type('kg/m3', 'kg_m3', one)
   type(unit_type), parameter :: pascal = unit_type('Pa', 'Pa', one), gigapascal = unit_type('GPa', 'GPa', giga)
   type(unit_type), parameter :: megapascal = unit_type('MPa', 'MPa', mega, 'kPa', kilo), &
                                 in_bar = unit_type('bar', 'bar', bar, 'kPa', kilopascals)
   type(unit_type), parameter :: kilonewton_metre = unit_type('kN.m', 'kNm', kilo, 'N.m', kilo)
   type(unit_type), parameter :: turns_a_minute = unit_type('rpm', 'rpm', rpm), metre_a_second = unit_type('m/s', 'm_s', one)
   type(unit_type), parameter :: in_inches = unit_type('in', 'in', inch, 'mm', 25.4_wp), m_s2 = unit_type('m/s2', 'm_s2', one)
   real(wp), parameter :: micro = 1.0e-6_wp, fahrenheit = 5.0_wp/9.0_wp
   type(unit_type), parameter :: kelvin = unit_type('K', 'K', one), micro_kelvin = unit_type('1e-6/K', '1e-6_K', micro)
   real(wp), parameter :: hundredth = 1.0e-2_wp
   type(unit_type), parameter :: percent_kelvin = unit_type('%/K', 'pct_K', hundredth)
   type(unit_type), parameter :: per_pascal = unit_type('1e-14/Pa', '1e-14_Pa', 1.0e-14_wp)
   type(unit_type), parameter :: deg_30_m = unit_type('deg/30 m', 'deg_30m', per_30_m)

   type(row_type), parameter :: rows(0:quantity_last) = [ &
      row_type(quantity_none, [number, number, number, number]), &
      row_type(quantity_text, [number, number, number, number]), &
      row_type(quantity_length, [metre, unit_type('ft', 'ft', foot), metre, metre]), &
      row_type(quantity_width, [unit_type('mm', 'mm', 1.0e-3_wp), in_inches, in_inches, metre]), &
      row_type(quantity_angle, [in_degrees, in_degrees, in_degrees, radian]), &
      row_type(quantity_mass, [kg_m, unit_type('lbm/ft', 'lbm_ft', pound/foot), kg_m, kg_m]), &
      row_type(quantity_density, [kg_m3, &
         unit_type('lbm/gal', 'lbm_gal', pound/gallon, 'pcf (lbm/ft3)', gallons_in_cubic_foot), &
         unit_type('sg', 'sg', kilo, 'lbm/gal', kilo*gallon/pound), kg_m3]), &
      row_type(quantity_force, [unit_type('kN', 'kN', kilo, 'N', kilo), unit_type('klbf', 'klbf', kilo*pound_force, 'lbf', kilo), &
                                unit_type('kdaN', 'kdaN', ten_kilonewton, 'daN', kilo), unit_type('N', 'N', one)]), &
      row_type(quantity_moment, [kilonewton_metre, unit_type('kft.lbf', 'kftlbf', kilo*foot*pound_force, 'ft.lbf', kilo), &
                                 kilonewton_metre, newton_metre]), &
      row_type(quantity_line_load, [unit_type('kN/m', 'kN_m', kilo), unit_type('klbf/ft', 'klbf_ft', kilo*pound_force/foot), &
                                    unit_type('kdaN/m', 'kdaN_m', ten_kilonewton), unit_type('N/m', 'N_m', one)]), &
      row_type(quantity_modulus, [gigapascal, unit_type('1e6 psi', '1e6_psi', mega*psi), gigapascal, pascal]), &
      row_type(quantity_stress, [megapascal, unit_type('ksi', 'ksi', kilo*psi, 'psi', kilo), in_bar, &
                                 pascal]), &
      row_type(quantity_pressure, [megapascal, unit_type('psi', 'psi', psi), in_bar, pascal]), &
      row_type(quantity_wall, [unit_type('kN/m2', 'kN_m2', kilo), unit_type('klbf/ft2', 'klbf_ft2', kilo*pound_force/foot**2), &
                               unit_type('kdaN/m2', 'kdaN_m2', ten_kilonewton), unit_type('N/m2', 'N_m2', one)]), &
      row_type(quantity_curvature, [deg_30_m, unit_type('deg/100 ft', 'deg_100ft', per_100_ft), deg_30_m, &
                                    unit_type('rad/m', 'rad_m', one)]), &
      row_type(quantity_rotation, [turns_a_minute, turns_a_minute, turns_a_minute, unit_type('rad/s', 'rad_s', one)]), &
      row_type(quantity_speed, [metre_a_second, unit_type('ft/s', 'ft_s', foot), metre_a_second, metre_a_second]), &
      row_type(quantity_gravity, [m_s2, m_s2, m_s2, m_s2]), &
      row_type(quantity_percent, [percent, percent, percent, percent]), &
      row_type(quantity_turns, [turn, turn, turn, turn]), &
      row_type(quantity_time, [second, second, second, second]), &
      row_type(quantity_temperature, [kelvin, unit_type('degF', 'degF', fahrenheit), kelvin, kelvin]), &
      row_type(quantity_expansion, [micro_kelvin, unit_type('1e-6/degF', '1e-6_degF', micro/fahrenheit), micro_kelvin, &
                                    unit_type('1/K', '1_K', one)]), &
      row_type(quantity_wear, [per_pascal, unit_type('1e-10/psi', '1e-10_psi', 1.0e-10_wp/psi), per_pascal, &
                               unit_type('1/Pa', '1_Pa', one)]), &
      row_type(quantity_loss, [percent_kelvin, unit_type('%/degF', 'pct_degF', hundredth/fahrenheit), percent_kelvin, &
                               unit_type('1/K', '1_K', one)])]
end module dg_quantity
