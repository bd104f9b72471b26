!> The contents of a deck in the program's own types and SI units, before the parts are checked against each
!> other. Lines of the deck stay beside each part, so that those checks can name them.
module dg_deck_draft
   use dg_kinds, only: wp
   use dg_constants, only: standard_gravity
   use dg_component, only: component_type
   use dg_fluid, only: fluid_type
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: load_case_type
   use dg_model, only: boundary_type
   use dg_numerics, only: numerics_type
   use dg_rig, only: rig_type
   use dg_survey_file, only: station_list_type
   use dg_text, only: text_type
   use dg_trajectory, only: interpolation_minimum_curvature
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: draft_type, draft_hole_type, draft_fluid_type, draft_component_type, draft_case_type, case_named

   type :: draft_hole_type
      type(hole_section_type) :: section
      logical :: sound = .false.               !< all of its own values are legal
      logical :: has_top = .false.             !< md_top is given
      logical :: has_bottom = .false.          !< md_bottom is given
      integer :: line = 0
      integer :: line_top = 0, line_bottom = 0 !< of md_top and md_bottom; of the group where not given
   end type draft_hole_type

   type :: draft_fluid_type
      type(fluid_type) :: fluid
      logical :: has_tvd = .false.             !< its upper end is a true vertical depth
      real(wp) :: tvd_top = 0.0_wp             !< [m]
      integer :: line = 0
      integer :: line_tvd = 0, line_density = 0
   end type draft_fluid_type

   type :: draft_component_type
      type(component_type) :: component
      character(:), allocatable :: string
      logical :: sound = .false.
      logical :: connected = .false.           !< its connection is named
      integer :: line = 0
      integer :: line_length = 0, line_diameter = 0, line_density = 0 !< line_diameter: of what touches first
      integer :: line_centralizer = 0          !< of the od of rigid centralisers; 0: none
   end type draft_component_type

   type :: draft_case_type
      type(load_case_type) :: load_case
      character(12) :: group = 'load_case'     !< that it comes from, the key of its depth, and what messages call it
      character(16) :: depth_key = 'bit_depth'
      character(8) :: what = 'case'
      logical :: sound = .false.
      integer :: line = 0
      integer :: line_name = 0, line_depth = 0, line_string = 0
   end type draft_case_type

   type :: draft_type
      character(:), allocatable :: path        !< of the deck
      type(unit_system_type) :: units
      type(station_list_type) :: stations
      logical :: has_stations = .false.        !< stations are without fault
      integer :: trajectory_line = 0
      integer :: interpolation = interpolation_minimum_curvature
      logical :: tortuous = .false.            !< stations are those of a plan with tortuosity laid on it
      type(text_type), allocatable :: path_notes(:) !< what was added to the stations of the deck
      type(draft_hole_type), allocatable :: holes(:)
      type(draft_component_type), allocatable :: components(:)
      type(draft_case_type), allocatable :: cases(:)
      type(boundary_type) :: boundary
      type(numerics_type) :: numerics
      type(rig_type) :: rig
      type(draft_fluid_type), allocatable :: fluids(:)
      real(wp) :: gravity = standard_gravity   !< [m/s2]
   end type draft_type

contains

   !> Number of a load case by its name; 0: there is none.
   pure function case_named(draft, name) result(number)
      type(draft_type), intent(in) :: draft
      character(*), intent(in) :: name
      integer :: number, k
      number = 0
      do k = 1, size(draft%cases)
         if (draft%cases(k)%load_case%name == name) number = k
      end do
   end function case_named
end module dg_deck_draft
