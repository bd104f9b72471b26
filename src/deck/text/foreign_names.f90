!> Names that other programs and the rig have for groups and keys of a deck, for advice on unknown ones. None of them is read.
module dg_foreign_names
   use dg_text, only: nearest_name, suggestion
   implicit none
   private
   public :: key_advice, meant_key

   !> A group or key of a deck, with its names elsewhere.
   type :: names_type
      character(16) :: group = ''       !< of the key; '': a group is meant
      character(20) :: ours = ''
      character(88) :: foreign = ''     !< a blank between two
   end type names_type

   type(names_type), parameter :: names(*) = [ &
      names_type('', 'component', 'bha string drillstring drill_string drillpipe drill_pipe pipe collar bit tubular'), &
      names_type('', 'load_case', 'bitrun bit_run run loadcase loadcases load operation case'), &
      names_type('', 'trajectory', 'survey surveys wellpath well_path path deviation'), &
      names_type('', 'fluid', 'mud mud_weight fluids'), &
      names_type('', 'hole', 'casing open_hole openhole wellbore hole_section'), &
      names_type('', 'job', 'well units settings general project'), &
      names_type('component', 'joint_od', 'tool_joint_od tooljoint_od tj_od blade_od'), &
      names_type('component', 'joint_id', 'tool_joint_id tj_id'), &
      names_type('component', 'joint_length', 'tool_joint_length tj_length'), &
      names_type('component', 'od', 'outer_diameter outside_diameter diameter'), &
      names_type('component', 'id', 'inner_diameter inside_diameter'), &
      names_type('component', 'mass', 'weight linear_weight unit_weight'), &
      names_type('component', 'yield', 'yield_strength min_yield'), &
      names_type('component', 'youngs', 'modulus'), &
      names_type('component', 'kind', 'type'), &
      names_type('component', 'makeup_torque', 'makeup'), &
      names_type('hole', 'diameter', 'id od size hole_size hole_diameter'), &
      names_type('hole', 'friction', 'ff friction_factor mu'), &
      names_type('hole', 'md_top', 'top from'), &
      names_type('hole', 'md_bottom', 'bottom to shoe'), &
      names_type('fluid', 'density', 'mud_weight weight mw'), &
      names_type('trajectory', 'md', 'depth'), &
      names_type('trajectory', 'inc', 'inclination'), &
      names_type('trajectory', 'azi', 'azimuth'), &
      names_type('trajectory', 'survey_file', 'file'), &
      names_type('load_case', 'bit_depth', 'depth md'), &
      names_type('load_case', 'wob', 'weight_on_bit'), &
      names_type('load_case', 'tob', 'torque_on_bit bit_torque'), &
      names_type('load_case', 'measured_hookload', 'hookload hook_load'), &
      names_type('load_case', 'measured_torque', 'torque'), &
      names_type('load_case', 'operation', 'type'), &
      names_type('job', 'title', 'name'), &
      names_type('job', 'units', 'unit_system'), &
      names_type('job', 'output_dir', 'output'), &
      names_type('job', 'models', 'model')]

contains

   !> Advice on an unknown key of a group, or on an unknown group where `group` is '': the one that means the same, else the nearest
   !> by its letters, else all.
   pure function key_advice(group, name, legal) result(advice)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: advice
      advice = same_name(group, name, legal)
      if (advice /= '') then
         advice = "did you mean '"//advice//"'?"
      else
         advice = suggestion(name, legal)
      end if
   end function key_advice

   !> The key that an unknown one is taken for; '' where none is.
   pure function meant_key(group, name, legal) result(meant)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: meant
      meant = same_name(group, name, legal)
      if (meant == '') meant = nearest_name(name, legal)
   end function meant_key

   !> The group or key that means the same; '' where none is known.
   pure function same_name(group, name, legal) result(meant)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: meant
      integer :: i
      meant = ''
      do i = 1, size(names)
         if (names(i)%group /= group .or. .not. any(legal == names(i)%ours)) cycle
         if (name /= '' .and. index(' '//names(i)%foreign, ' '//name//' ') > 0) meant = trim(names(i)%ours)
      end do
   end function same_name
end module dg_foreign_names
