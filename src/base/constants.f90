!> Mathematical and physical constants with their sources.
module dg_constants
   use dg_kinds, only: wp
   implicit none
   private
   public :: pi, degree, standard_gravity, steel_density

   real(wp), parameter :: pi = 3.14159265358979323846_wp
   !> One degree [rad].
   real(wp), parameter :: degree = pi/180.0_wp
   !> Standard acceleration of gravity [m/s2], exact (CGPM 1901).
   real(wp), parameter :: standard_gravity = 9.80665_wp
   !> Density of drill pipe steel [kg/m3] (API RP 7G uses 489.5 lbm/ft3 = 7841; 7850 is customary).
   real(wp), parameter :: steel_density = 7850.0_wp
end module dg_constants
