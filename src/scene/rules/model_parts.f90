!> Parts of a model as a program fills them in, before they are checked. SI units.
module dg_model_parts
   use dg_constants, only: standard_gravity
   use dg_drillstring, only: drillstring_type
   use dg_fluid, only: fluid_type
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_model, only: boundary_type
   use dg_numerics, only: numerics_type
   use dg_rig, only: rig_type
   use dg_trajectory, only: interpolation_minimum_curvature
   implicit none
   private
   public :: model_parts_type, survey_type

   !> Stations of the hole from the top down. The first is at surface, or where the hole is still vertical.
   type :: survey_type
      real(wp), allocatable :: md(:)           !< measured depth, increasing [m]
      real(wp), allocatable :: inclination(:)  !< from vertical [rad], 0 to pi
      real(wp), allocatable :: azimuth(:)      !< from north, clockwise seen from above [rad]; not allocated: 0
      integer :: interpolation = interpolation_minimum_curvature
   end type survey_type

   type :: model_parts_type
      type(survey_type) :: survey
      type(hole_section_type), allocatable :: holes(:)   !< from surface down, abutting; md_bottom 0 of the last: end of the survey
      type(drillstring_type), allocatable :: strings(:)  !< each from the bit upwards
      type(fluid_type), allocatable :: fluids(:)         !< from the top down; not allocated: air
      type(boundary_type) :: boundary
      type(numerics_type), allocatable :: numerics       !< not allocated: settings_of('auto'), as for a deck without &solver
      type(rig_type) :: rig
      real(wp) :: gravity = standard_gravity             !< [m/s2]
   end type model_parts_type
end module dg_model_parts
