!> Unit systems of decks and reports. Inside the program everything is SI; only deck and report convert.
!> A factor is the SI value of one user unit: si = user*factor.
!> Exact factors (NIST SP 811): foot 0.3048 m, inch 0.0254 m, pound 0.45359237 kg, US gallon 231 in3,
!> pound-force = pound times standard gravity.
module dg_units
   use dg_kinds, only: wp
   use dg_constants, only: degree, pi, standard_gravity
   implicit none
   private
   public :: unit_system_type, si_units, field_units, base_units

   real(wp), parameter :: foot = 0.3048_wp
   real(wp), parameter :: inch = 0.0254_wp
   real(wp), parameter :: pound = 0.45359237_wp
   real(wp), parameter :: gallon = 231.0_wp*inch**3
   real(wp), parameter :: pound_force = pound*standard_gravity
   real(wp), parameter :: minute = 60.0_wp

   type :: unit_system_type
      character(5) :: name = 'SI'
      real(wp) :: length = 1.0_wp               !< m, ft
      real(wp) :: diameter = 1.0e-3_wp          !< mm, in (also mud sheath, displacement)
      real(wp) :: angle = degree                !< deg
      real(wp) :: mass_per_length = 1.0_wp      !< kg/m, lbm/ft
      real(wp) :: density = 1.0_wp              !< kg/m3, lbm/gal
      real(wp) :: force = 1.0e3_wp              !< kN, klbf
      real(wp) :: moment = 1.0e3_wp             !< kN.m, kft.lbf
      real(wp) :: modulus = 1.0e9_wp            !< GPa, 1e6 psi
      real(wp) :: stress = 1.0e6_wp             !< MPa, ksi
      real(wp) :: wall_stiffness = 1.0e3_wp     !< kN/m2, klbf/ft2
      real(wp) :: force_per_length = 1.0e3_wp   !< kN/m, klbf/ft
      real(wp) :: curvature = degree/30.0_wp    !< deg/30 m, deg/100 ft [1/m]
      real(wp) :: rotation_speed = 2.0_wp*pi/minute !< rpm [rad/s]
      real(wp) :: trip_speed = 1.0_wp           !< m/s, ft/s
      !> Suffixes of column headers in files.
      character(8) :: length_label = 'm'
      character(8) :: diameter_label = 'mm'
      character(8) :: force_label = 'kN'
      character(8) :: moment_label = 'kNm'
      character(8) :: force_per_length_label = 'kN_m'
      character(8) :: stress_label = 'MPa'
      character(9) :: curvature_label = 'deg_30m'
      character(8) :: wall_stiffness_label = 'kN_m2'
   end type unit_system_type

contains

   !> The system of `units='SI'`.
   pure function si_units() result(units)
      type(unit_system_type) :: units
      units = unit_system_type()
   end function si_units

   !> The system of `units='field'`.
   pure function field_units() result(units)
      type(unit_system_type) :: units
      units%name = 'field'
      units%length = foot
      units%diameter = inch
      units%mass_per_length = pound/foot
      units%density = pound/gallon
      units%force = 1.0e3_wp*pound_force
      units%moment = 1.0e3_wp*foot*pound_force
      units%modulus = 1.0e6_wp*pound_force/inch**2
      units%stress = 1.0e3_wp*pound_force/inch**2
      units%wall_stiffness = 1.0e3_wp*pound_force/foot**2
      units%force_per_length = 1.0e3_wp*pound_force/foot
      units%curvature = degree/(100.0_wp*foot)
      units%trip_speed = foot
      units%length_label = 'ft'
      units%diameter_label = 'in'
      units%force_label = 'klbf'
      units%moment_label = 'kftlbf'
      units%force_per_length_label = 'klbf_ft'
      units%stress_label = 'ksi'
      units%curvature_label = 'deg_100ft'
      units%wall_stiffness_label = 'klbf_ft2'
   end function field_units

   !> Units of programs: those of SI without multiples, angles in radians. No deck has them.
   pure function base_units() result(units)
      type(unit_system_type) :: units
      units%name = 'base'
      units%diameter = 1.0_wp
      units%angle = 1.0_wp
      units%force = 1.0_wp
      units%moment = 1.0_wp
      units%modulus = 1.0_wp
      units%stress = 1.0_wp
      units%wall_stiffness = 1.0_wp
      units%force_per_length = 1.0_wp
      units%curvature = 1.0_wp
      units%rotation_speed = 1.0_wp
      units%diameter_label = 'm'
      units%force_label = 'N'
      units%moment_label = 'Nm'
      units%force_per_length_label = 'N_m'
      units%stress_label = 'Pa'
      units%curvature_label = 'rad_m'
      units%wall_stiffness_label = 'N_m2'
   end function base_units
end module dg_units
