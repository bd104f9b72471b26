!> All data of a computation, in SI units, built once from a deck. A solution only changes copies.
module dg_model
   use dg_kinds, only: wp
   use dg_component, only: has_bend, has_joints
   use dg_constants, only: standard_gravity
   use dg_design_factors, only: design_factors_type
   use dg_drillstring, only: drillstring_type
   use dg_fluid, only: mud_type
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: load_case_type, rotates
   use dg_missing, only: optional_real
   use dg_numerics, only: numerics_type
   use dg_rig, only: rig_type
   use dg_text, only: text_type
   use dg_trajectory, only: trajectory_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: model_type, boundary_type, string_index, is_straightened, smears_joints, copy_without_cases
   public :: hold_free, hold_landed, hold_fixed, packer_hold_name

   !> Motion of the lower end in a packer: up and down; up alone; none.
   integer, parameter :: hold_free = 1, hold_landed = 2, hold_fixed = 3
   character(*), parameter :: packer_hold_name(3) = [character(6) :: 'free', 'landed', 'fixed']

   !> Lateral supports of the string's ends. Rotations are free at both. The top is held axially and against twist, the bit is
   !> loaded.
   type :: boundary_type
      logical :: top_centred = .true.
      logical :: bit_centred = .true.
      real(wp) :: packer_bore = 0.0_wp   !< diameter of the seal bore around the lower end [m]; 0: no packer
      integer :: packer_hold = hold_free
   end type boundary_type

   type :: model_type
      type(trajectory_type) :: trajectory
      type(text_type), allocatable :: path_notes(:)      !< remarks on the path besides the stations of the deck, for every report
      type(hole_section_type), allocatable :: holes(:)   !< from the top down, abutting
      type(drillstring_type), allocatable :: strings(:)
      type(load_case_type), allocatable :: cases(:)
      type(boundary_type) :: boundary
      type(numerics_type) :: numerics
      type(rig_type) :: rig                               !< only for the weight indicator and limits, not for forces in the string
      type(design_factors_type) :: design                 !< on loads, for strengths
      type(mud_type) :: mud
      real(wp) :: gravity = standard_gravity              !< [m/s2]
      type(optional_real) :: hookload                     !< given hook load with an unknown load at the bit; absent: the load is
                                                          !< known [N]
      real(wp) :: stiff_drag = 0.0_wp                     !< friction that the soft string of the present case lacks (dg_stiff_drag)
                                                          !< [N]
      real(wp) :: stiff_share = 1.0_wp                    !< part of the friction of the soft string that beams have (dg_stiff_drag)
      type(unit_system_type) :: units                     !< units of messages; all numbers are SI
   end type model_type

contains

   !> Index of the string of that name, 0 for an unknown name.
   pure function string_index(strings, name) result(index)
      type(drillstring_type), intent(in) :: strings(:)
      character(*), intent(in) :: name
      integer :: index
      do index = 1, size(strings)
         if (strings(index)%name == name) return
      end do
      index = 0
   end function string_index

   !> True if a string has a bent housing and turns, so that it is solved without its bend.
   pure function is_straightened(model, load_case) result(is)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: is
      is = rotates(load_case%operation) .and. .not. load_case%bend_stands .and. &
           any(has_bend(model%strings(string_index(model%strings, load_case%string))%components))
   end function is_straightened

   !> True if the string of a load case has tool joints that are smeared.
   pure function smears_joints(model, case_index) result(smears)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical :: smears
      smears = .not. model%numerics%discrete_joints
      if (smears) smears = any(has_joints(model%strings(string_index(model%strings, model%cases(case_index)%string))%components))
   end function smears_joints

   !> Copy a model without its load cases, with room for one.
   subroutine copy_without_cases(model, copy)
      type(model_type), intent(in) :: model
      type(model_type), intent(out) :: copy
      copy%trajectory = model%trajectory
      copy%holes = model%holes
      copy%strings = model%strings
      copy%boundary = model%boundary
      copy%numerics = model%numerics
      copy%rig = model%rig
      copy%design = model%design
      copy%mud = model%mud
      copy%gravity = model%gravity
      copy%stiff_drag = model%stiff_drag
      copy%stiff_share = model%stiff_share
      copy%hookload = model%hookload
      copy%units = model%units
      allocate (copy%cases(1))
   end subroutine copy_without_cases
end module dg_model
