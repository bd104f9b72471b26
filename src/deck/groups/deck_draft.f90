!> The contents of a deck in the program's own types and SI units, before the parts are checked against each
!> other. Lines of the deck stay beside each part, so that those checks can name them.
module dg_deck_draft
   use dg_kinds, only: wp
   use dg_constants, only: standard_gravity
   use dg_checked_group, only: checked_group_type, is_sound, line_of, texts_of
   use dg_component, only: component_type
   use dg_design_factors, only: design_factors_type
   use dg_error, only: add_fault, error_list_type
   use dg_fluid, only: fluid_type
   use dg_friction_estimate, only: friction_estimate_type
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: load_case_type
   use dg_merge_sort, only: first_equal
   use dg_model, only: boundary_type
   use dg_numerics, only: numerics_type
   use dg_rig, only: rig_type
   use dg_survey_file, only: station_list_type
   use dg_text, only: name_shown, quoted, suggestion, text_type
   use dg_trajectory, only: interpolation_minimum_curvature
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: draft_type, draft_hole_type, draft_fluid_type, draft_component_type, draft_case_type, find_case
   public :: deck_type, string_use_type, diameter_at, lowest_of, note_use, sections_of, read_cases

   type :: draft_hole_type
      type(hole_section_type) :: section
      logical :: sound = .false.               !< all of its own values are legal
      logical :: has_top = .false.             !< md_top is given
      logical :: has_bottom = .false.          !< md_bottom is given
      logical :: friction_given = .false.      !< friction of some way is given
      integer :: line = 0
      integer :: line_top = 0, line_bottom = 0 !< of md_top and md_bottom; of the group where not given
   end type draft_hole_type

   type :: draft_fluid_type
      type(fluid_type) :: fluid
      logical :: has_tvd = .false.             !< its upper end is a true vertical depth
      logical :: density_given = .false.
      real(wp) :: tvd_top = 0.0_wp             !< [m]
      integer :: line = 0
      integer :: line_tvd = 0, line_density = 0
   end type draft_fluid_type

   type :: draft_component_type
      type(component_type) :: component
      character(:), allocatable :: string
      logical :: sound = .false.
      logical :: connected = .false.           !< its connection is named
      logical :: mass_given = .false.          !< by the deck or the catalogue
      logical :: makeup_given = .false., torsion_given = .false.   !< so are makeup_torque and joint_torsion
      real(wp) :: joint_yield = 0.0_wp         !< of tool joints [Pa]; 0: not given
      integer :: line = 0
      integer :: line_length = 0, line_diameter = 0, line_density = 0 !< line_diameter: of what touches first
      integer :: line_opened = 0               !< of opened_od
      integer :: line_centralizer = 0          !< of the od of rigid centralizers; 0: none
   end type draft_component_type

   type :: draft_case_type
      type(load_case_type) :: load_case
      character(12) :: group = 'load_case'     !< that it comes from, the key of its depth, and what messages call it
      character(16) :: depth_key = 'bit_depth'
      character(8) :: what = 'case'
      logical :: sound = .false.
      integer :: line = 0
      integer :: line_name = 0, line_depth = 0, line_string = 0
      character(:), allocatable :: length_reference   !< name of a load case; '': none
      integer :: line_reference = 0, line_wob = 0, line_tob = 0   !< 0: not given
   end type draft_case_type

   type :: draft_type
      character(:), allocatable :: path        !< of the deck
      type(unit_system_type) :: units
      type(station_list_type) :: stations
      type(station_list_type) :: plan          !< stations of the deck, before tortuosity
      logical :: has_stations = .false.        !< stations are without fault
      integer :: trajectory_line = 0
      integer :: interpolation = interpolation_minimum_curvature
      logical :: tortuous = .false.            !< stations are those of a plan with tortuosity
      type(text_type), allocatable :: path_notes(:) !< additions to the stations of the deck
      type(text_type), allocatable :: path_warnings(:) !< positions of a survey file that differ from its stations
      type(draft_hole_type), allocatable :: holes(:)
      type(draft_component_type), allocatable :: components(:)
      type(draft_case_type), allocatable :: cases(:)
      type(boundary_type) :: boundary
      type(numerics_type) :: numerics
      type(rig_type) :: rig
      type(design_factors_type) :: design
      logical :: block_given = .false.         !< the rig has its block_weight, be it 0
      type(draft_fluid_type), allocatable :: fluids(:)
      real(wp) :: gravity = standard_gravity   !< [m/s2]
   end type draft_type

   !> A string that a study uses, and the depth of its bit.
   type :: string_use_type
      character(:), allocatable :: string
      real(wp) :: depth = 0.0_wp               !< the greatest, measured [m]
      logical :: turns = .false.               !< in one of its operations
      integer, allocatable :: operations(:)
      character(:), allocatable :: group       !< of the deck, by name
      real(wp), allocatable :: wob(:), tob(:)  !< by operation, or one for all [N, N.m]
      type(load_case_type), allocatable :: measured(:)   !< with a measured hook load or torque
   end type string_use_type

   !> A deck while it is read: its parts, its groups for studies with groups of their own, and results that these share.
   type :: deck_type
      type(draft_type) :: draft
      type(checked_group_type), allocatable :: groups(:)
      type(text_type), allocatable :: inputs(:)                  !< paths of the files that it is made of
      type(string_use_type), allocatable :: uses(:)              !< of strings, beside those of load cases
      type(friction_estimate_type), allocatable :: estimates(:)  !< that a study of the deck will find, in its order
   end type deck_type

contains

   !> Notes the use of a string by a study.
   subroutine note_use(deck, use)
      type(deck_type), intent(inout) :: deck
      type(string_use_type), intent(in) :: use
      type(string_use_type), allocatable :: longer(:)
      integer :: n
      n = size(deck%uses)
      allocate (longer(n + 1))
      longer(:n) = deck%uses
      longer(n + 1) = use
      call move_alloc(longer, deck%uses)
   end subroutine note_use

   !> For each component the lowest one of its string.
   pure function lowest_of(draft) result(lowest)
      type(draft_type), intent(in) :: draft
      integer :: lowest(size(draft%components))
      type(text_type) :: names(size(draft%components))
      integer :: i
      do i = 1, size(names)
         names(i)%text = draft%components(i)%string
      end do
      lowest = first_equal(names)
   end function lowest_of

   !> The hole sections.
   pure function sections_of(draft) result(sections)
      type(draft_type), intent(in) :: draft
      type(hole_section_type) :: sections(size(draft%holes))
      integer :: i
      do i = 1, size(sections)
         sections(i) = draft%holes(i)%section
      end do
   end function sections_of

   !> Diameter of the hole just above a depth, of a draft with hole sections [m].
   pure function diameter_at(draft, md) result(diameter)
      type(draft_type), intent(in) :: draft
      real(wp), intent(in) :: md      !< [m]
      real(wp) :: diameter
      integer :: k
      do k = size(draft%holes), 2, -1
         if (draft%holes(k)%section%md_top < md) exit
      end do
      diameter = draft%holes(max(k, 1))%section%diameter
   end function diameter_at

   !> Number of the load case that a group names at a line of the deck. Where there is none, 0 and a fault, unless the name of a
   !> load case is itself at fault.
   pure subroutine find_case(draft, group, line, name, number, faults)
      type(draft_type), intent(in) :: draft
      character(*), intent(in) :: group, name
      integer, intent(in) :: line
      integer, intent(out) :: number
      type(error_list_type), intent(inout) :: faults
      character(name_shown) :: names(size(draft%cases))
      integer :: k
      number = 0
      do k = 1, size(names)
         names(k) = draft%cases(k)%load_case%name
         if (draft%cases(k)%load_case%name == name) number = k
      end do
      if (any(names == '')) return
      if (number == 0) call add_fault(faults, draft%path, line, 'group &'//group// &
                                      ': there is no load case '//quoted(name)//'; '//suggestion(name, names))
   end subroutine find_case

   !> Numbers of the load cases named; all where none is.
   subroutine read_cases(draft, group, cases, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, allocatable, intent(out) :: cases(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: wanted(:)
      integer :: i, k, found
      allocate (wanted, source=texts_of(group, 'cases'))
      allocate (cases(0))
      if (.not. is_sound(group, 'cases')) cases = [(k, k=1, size(draft%cases))]
      do i = 1, size(wanted)
         call find_case(draft, group%name, line_of(group, 'cases'), wanted(i)%text, found, faults)
         if (found > 0 .and. .not. any(cases == found)) cases = [cases, found]
      end do
   end subroutine read_cases
end module dg_deck_draft
