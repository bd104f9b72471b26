!> Mathematical and physical constants with their sources.
module dg_constants
   use dg_kinds, only: wp
   implicit none
   private
   public :: pi, degree, standard_gravity, steel_density
   public :: foot, survey_foot, inch, pound, gallon, pound_force, psi

   real(wp), parameter :: pi = 3.14159265358979323846_wp
   !> One degree [rad].
   real(wp), parameter :: degree = pi/180.0_wp
   !> Standard acceleration of gravity [m/s2], exact (CGPM 1901).
   real(wp), parameter :: standard_gravity = 9.80665_wp
   !> Density of drill pipe steel [kg/m3] (API RP 7G uses 489.5 lbm/ft3 = 7841; 7850 is customary).
   real(wp), parameter :: steel_density = 7850.0_wp
   !> Exact factors of field units (NIST SP 811), the foot of United States' surveys among them [SI].
   real(wp), parameter :: foot = 0.3048_wp, survey_foot = 1200.0_wp/3937.0_wp, inch = 0.0254_wp
   real(wp), parameter :: pound = 0.45359237_wp, pound_force = pound*standard_gravity
   real(wp), parameter :: gallon = 231.0_wp*inch**3, psi = pound_force/inch**2
end module dg_constants
