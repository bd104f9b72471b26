!> Usual ranges of numbers in a deck. A number outside is mostly in another unit: it gets a note.
module dg_usual_range
   use dg_kinds, only: wp
   use dg_constants, only: degree, pi
   use dg_likely_unit, only: unit_questions
   use dg_text, only: append_text, either, text_type, to_text
   use dg_unit_kind, only: at_most, heaviest_mud, in_units, unit_angle, unit_density, unit_diameter, unit_factor, unit_force, &
                           unit_gravity, unit_length, unit_moment, unit_none, unit_pressure, unit_rotation, unit_speed, &
                           unit_stress, unit_temperature, unit_wall, unit_wear
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: is_unusual, note_range, usual_yield, usual_wob, usual_tob, usual_density, usual_pump, usual_block, usual_top_drive, &
             usual_makeup, usual_joint_torsion, usual_friction, usual_running_in, usual_trip_speed, usual_rpm, usual_hookload, &
             usual_gravity, usual_hours, usual_warming_top, usual_warming_bottom, usual_ambient_top, usual_ambient_bottom, &
             usual_measured, usual_joint_spacing, usual_joint_length, usual_bend, usual_lines, usual_sheave, usual_wear, &
             usual_restoring, usual_running_force, usual_wall, usual_deep_wall, usual_centralizers, usual_slips, &
             usual_surface, usual_annulus, usual_casing_yield, usual_hole, usual_bore, usual_tension, usual_compression, &
             usual_joint_yield, usual_joint_id, usual_fatigue, usual_joint_fatigue, usual_tensile, usual_inside_density, &
             usual_pad, usual_blade_offset, usual_rpm_worn, usual_enlargement, usual_side_cutting

   !> Usual range of a key.
   type :: usual_type
      character(25) :: key
      integer :: unit              !< unit_none for plain numbers
      real(wp) :: low, high        !< [SI]
      character(72) :: source
   end type usual_type

   integer, parameter :: usual_yield = 1, usual_wob = 2, usual_tob = 3, usual_density = 4, usual_pump = 5, &
                         usual_block = 6, usual_top_drive = 7, usual_makeup = 8, usual_joint_torsion = 9, usual_friction = 10, &
                         usual_trip_speed = 11, usual_rpm = 12, usual_hookload = 13, usual_running_in = 14, usual_gravity = 15, &
                         usual_hours = 16, usual_warming_top = 17, usual_warming_bottom = 18, usual_ambient_top = 19, &
                         usual_ambient_bottom = 20, usual_measured = 21, usual_joint_spacing = 22, usual_joint_length = 23, &
                         usual_bend = 24, usual_lines = 25, usual_sheave = 26, usual_wear = 27, usual_restoring = 28, &
                         usual_running_force = 29, usual_wall = 30, usual_deep_wall = 31, usual_centralizers = 32, &
                         usual_slips = 33, usual_surface = 34, usual_annulus = 35, usual_casing_yield = 36, usual_hole = 37, &
                         usual_bore = 38, usual_tension = 39, usual_compression = 40, usual_joint_yield = 41, usual_joint_id = 42, &
                         usual_fatigue = 43, usual_joint_fatigue = 44, usual_tensile = 45, usual_inside_density = 46, &
                         usual_pad = 47, usual_blade_offset = 48, usual_rpm_worn = 49, usual_enlargement = 50, &
                         usual_side_cutting = 51
   !> Temperatures above that of the air, and changes of them [K].
   real(wp), parameter :: hottest = 325.0_wp, coldest = -260.0_wp
   character(*), parameter :: wells = 'steam and supercritical wells 350 degC; more was meant as kelvin'
   real(wp), parameter :: per_minute = pi/30.0_wp
   type(usual_type), parameter :: usual(51) = [ &
      usual_type('yield', unit_stress, 150.0e6_wp, 1250.0e6_wp, 'API 5CT H40 to proprietary 180 ksi; aluminium pipe 325 MPa'), &
      usual_type('wob', unit_force, -3.0e6_wp, 700.0e3_wp, 'heavy rock bits of 26 in, 150 klbf; overpull of large rigs'), &
      usual_type('tob', unit_moment, 0.0_wp, 100.0e3_wp, 'reamers in soft rock; strongest top drives 130 kN.m'), &
      usual_type('density', unit_density, 0.0_wp, heaviest_mud, 'heaviest kill mud 22.5 lbm/gal'), &
      usual_type('pump_pressure', unit_pressure, 0.35e6_wp, 105.0e6_wp, &
                 'stimulation pumps 15,000 psi; less than 50 psi was meant as ksi'), &
      usual_type('block_weight', unit_force, 0.0_wp, 1.5e6_wp, 'block, compensator and top drive of 1,250 t rigs: 120 t'), &
      usual_type('max_torque', unit_moment, 0.0_wp, 200.0e3_wp, 'strongest top drives 130 kN.m'), &
      usual_type('makeup_torque', unit_moment, 0.0_wp, 250.0e3_wp, 'collars of 11 in: 150 kN.m'), &
      usual_type('joint_torsion', unit_moment, 0.0_wp, 500.0e3_wp, 'tool joints of 8 1/2 in: 200 kN.m'), &
      usual_type('friction', unit_none, 0.03_wp, 1.0_wp, 'roller tools 0.05; brine on casing 0.6'), &
      usual_type('trip_speed', unit_speed, 0.0_wp, 3.0_wp, 'a stand of 28 m in 20 s: 1.4 m/s'), &
      usual_type('rpm', unit_rotation, 2.5_wp*per_minute, 700.0_wp*per_minute, 'top drives 250, diamond coring 600'), &
      usual_type('max_hookload', unit_force, 0.0_wp, 18.0e6_wp, 'largest rigs 1,500 t'), &
      usual_type('friction_running_in', unit_none, 0.03_wp, 1.0_wp, 'as friction'), &
      usual_type('gravity', unit_gravity, 9.7_wp, 10.0_wp, '9.76 on high mountains to 9.83 at the poles'), &
      usual_type('hours', unit_none, 0.0_wp, 3000.0_wp, 'life of a string; one hour in seconds is 3600'), &
      usual_type('temperature_change_top', unit_temperature, coldest, hottest, wells), &
      usual_type('temperature_change_bottom', unit_temperature, coldest, hottest, wells), &
      usual_type('above_ambient_top', unit_temperature, 0.0_wp, hottest, wells), &
      usual_type('above_ambient_bottom', unit_temperature, 0.0_wp, hottest, wells), &
      usual_type('measured_torque', unit_moment, 0.0_wp, 200.0e3_wp, 'strongest top drives 130 kN.m'), &
      usual_type('joint_spacing', unit_length, 2.95_wp, 20.0_wp, 'drill rods of 10 ft to casing of range 3, 48 ft'), &
      usual_type('joint_length', unit_length, 0.0_wp, 3.0_wp, 'heavy weight pipe 1.2 m; 17 in of drill pipe are 0.43 m'), &
      usual_type('bend', unit_angle, 0.1_wp*degree, 6.0_wp*degree, 'motors 0.25 to 4 deg; 1.5 deg are 0.026 in radians'), &
      usual_type('lines', unit_none, 4.0_wp, 16.0_wp, 'small workover rigs 4; largest rigs 14 to 16'), &
      usual_type('sheave_efficiency', unit_none, 0.93_wp, 1.0_wp, 'roller bearings 0.96 to 0.99 a sheave'), &
      usual_type('wear_factor', unit_wear, 1.0e-17_wp, 1.0e-11_wp, 'tests of 1e-10/psi: 0.01 to 1000'), &
      usual_type('restoring_force', unit_force, 0.0_wp, 50.0e3_wp, 'API 10D, 20 in: 1,707 lbf; stiff bows several times that'), &
      usual_type('running_force', unit_force, 0.0_wp, 20.0e3_wp, 'API 10D, 20 in: 2,240 lbf'), &
      usual_type('wall_stiffness', unit_wall, 5.0e4_wp, 1.0e12_wp, 'soft clay 0.1 MPa; steel 200 GPa'), &
      usual_type('wall_stiffness', unit_wall, 1.0e8_wp, 1.0e12_wp, 'clay of deep wells 0.1 GPa, sandstone 10 GPa'), &
      usual_type('spacing', unit_length, 4.0_wp, 150.0_wp, 'three a joint of casing, 13.3 ft, to one in ten joints'), &
      usual_type('slip_length', unit_diameter, 0.1_wp, 1.0_wp, 'slips of drill pipe 0.3 to 0.45 m, hand slips of tubing 0.2 m'), &
      usual_type('surface_pressure', unit_pressure, 0.0_wp, 105.0e6_wp, 'heads of 15,000 psi'), &
      usual_type('annulus_pressure', unit_pressure, 0.0_wp, 105.0e6_wp, 'heads of 15,000 psi'), &
      usual_type('casing_yield', unit_stress, 150.0e6_wp, 1250.0e6_wp, 'as yield'), &
      usual_type('diameter', unit_diameter, 0.0_wp, 1.6_wp, 'crossings and conductors of 60 in'), &
      usual_type('packer_bore', unit_diameter, 0.02_wp, 0.5_wp, 'slim tubing 1 in; tie-back of 13 3/8 in'), &
      usual_type('tension_efficiency', unit_none, 0.1_wp, 2.0_wp, 'connections 0.3 to 1.2 of the body'), &
      usual_type('compression_efficiency', unit_none, 0.1_wp, 2.0_wp, 'connections 0.3 to 1.2 of the body'), &
      usual_type('joint_yield', unit_stress, 150.0e6_wp, 1250.0e6_wp, 'as yield'), &
      usual_type('joint_id', unit_diameter, 0.015_wp, 0.6_wp, 'slim pipe 1 in; casing of 20 in'), &
      usual_type('fatigue_limit', unit_stress, 30.0e6_wp, 600.0e6_wp, 'pipe in brine 10 ksi; half the strength of hard steel'), &
      usual_type('joint_fatigue_limit', unit_stress, 15.0e6_wp, 600.0e6_wp, 'threads 20 to 100 MPa of the bending beside them'), &
      usual_type('tensile_strength', unit_stress, 200.0e6_wp, 1600.0e6_wp, 'soft aluminium 250 MPa; rods and pipe to 1,300 MPa'), &
      usual_type('inside_density', unit_density, 0.0_wp, heaviest_mud, 'as density'), &
      usual_type('pad_force', unit_force, 0.1e3_wp, 100.0e3_wp, 'steering tools 5 to 40 kN'), &
      usual_type('blade_offset', unit_diameter, 0.1e-3_wp, 0.1_wp, 'eccentric blades 1 to 10 mm; less was meant in m or in'), &
      usual_type('rpm', unit_rotation, 20.0_wp*per_minute, 700.0_wp*per_minute, 'wear and fatigue of drilling, 40 to 250'), &
      usual_type('hole_enlargement', unit_diameter, 0.1e-3_wp, 0.2_wp, 'motors drill 1 to 10 mm over gauge'), &
      usual_type('side_cutting', unit_none, 0.0_wp, 2.0_wp, 'fits of motors 0.001 to 0.1; aggressive side cutters 1')]
   integer, parameter :: digits = 4, few_digits = 3
   !> Least value that may be meant in another unit, over the largest usual one [-]. Soft steel is rare, low endurance is not.
   real(wp), parameter :: least_meant = 1.0_wp/150.0_wp, least_steel = 0.25_wp
   !> Largest usual standard deviation over the largest usual value [-].
   real(wp), parameter :: most_deviation = 0.2_wp
   !> Softest rock and solid steel [Pa].
   real(wp), parameter :: least_rock = 1.0e9_wp, steel = 2.1e11_wp
   !> Temperature of the air, 24 degC [K], and minutes of an hour.
   real(wp), parameter :: ambient = 297.0_wp, minutes = 60.0_wp

contains

   !> True for a value outside of its usual range.
   elemental function is_unusual(number, value) result(is)
      integer, intent(in) :: number       !< of the range
      real(wp), intent(in) :: value       !< [SI]
      logical :: is
      is = value < usual(number)%low .or. value > usual(number)%high
   end function is_unusual

   !> Adds a note on a value outside of its usual range.
   subroutine note_range(units, what, number, value, notes, deviation)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: what
      integer, intent(in) :: number       !< of the range
      real(wp), intent(in) :: value       !< [SI]
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(*), intent(in), optional :: deviation   !< key of a standard deviation; absent: the key of the range
      character(:), allocatable :: range
      type(usual_type) :: row
      row = usual(number)
      if (present(deviation)) row = usual_type(deviation, row%unit, 0.0_wp, most_deviation*row%high, '')
      if (value >= row%low .and. value <= row%high) return
      range = 'at least '//value_text(row%low, digits)
      if (value > row%high) range = 'at most '//value_text(at_most(units, row%unit, row%high, few_digits), few_digits)
      call append_text(notes, what//': '//trim(row%key)//' = '//value_text(value, digits)// &
                       ' is unusual. Usual is '//range// &
                       either(unit_question(), '', all(number /= [usual_friction, usual_running_in, usual_lines, usual_sheave, &
                                                                    usual_side_cutting])))

   contains

      !> Questions for the unit, with the number that is right for another one in which it would be usual.
      function unit_question() result(text)
         character(:), allocatable :: text
         real(wp) :: least, most
         text = ''
         select case (number)
         case (usual_hours)
            text = '. Is it in minutes? Then write '//to_text(value/minutes, digits)
         case (usual_ambient_top, usual_ambient_bottom)
            if (value > ambient) text = '. Is it a temperature? Then write '//to_text((value - ambient)/ &
                                        unit_factor(units, unit_temperature), digits)
         case (usual_warming_top, usual_warming_bottom)
            text = '. Is it a temperature? Then write its rise since the string was run'
         case default
            least = max(row%low, least_meant*row%high)
            if (row%unit == unit_stress .and. all(number /= [usual_fatigue, usual_joint_fatigue])) least = least_steel*row%high
            if (present(deviation)) least = most_deviation*least
            most = row%high
            if (row%unit == unit_wall) then
               least = least_rock
               most = steel
            end if
            if (value < 0.0_wp) then      ! an overpull
               least = row%low
               most = least_meant*row%low
            end if
            text = unit_questions(units, row%unit, value/unit_factor(units, row%unit), least, most, digits)
         end select
         if (text == '') text = '. Check the unit'
      end function unit_question

      !> A value in the units of the deck, with its unit where the range has one.
      function value_text(number_in_si, places) result(text)
         real(wp), intent(in) :: number_in_si
         integer, intent(in) :: places        !< digits
         character(:), allocatable :: text
         text = to_text(number_in_si, places)
         if (row%unit /= unit_none) text = in_units(units, row%unit, number_in_si, places)
      end function value_text
   end subroutine note_range
end module dg_usual_range
