!> Names that other programs and the rig have for groups and keys of a deck, for advice on unknown ones. None of them is read.
module dg_foreign_names
   use dg_text, only: nearest_name, suggestion
   implicit none
   private
   public :: group_advice, key_advice, meant_key

   !> A group by another name.
   type :: group_name_type
      character(16) :: foreign = ''
      character(16) :: ours = ''
   end type group_name_type

   !> A key by another name.
   type :: key_name_type
      character(16) :: group = ''
      character(20) :: foreign = ''
      character(20) :: ours = ''
   end type key_name_type

   type(group_name_type), parameter :: group_names(*) = [ &
      group_name_type('bha', 'component'), &
      group_name_type('string', 'component'), &
      group_name_type('drillstring', 'component'), &
      group_name_type('drill_string', 'component'), &
      group_name_type('drillpipe', 'component'), &
      group_name_type('drill_pipe', 'component'), &
      group_name_type('pipe', 'component'), &
      group_name_type('collar', 'component'), &
      group_name_type('bit', 'component'), &
      group_name_type('tubular', 'component'), &
      group_name_type('bitrun', 'load_case'), &
      group_name_type('bit_run', 'load_case'), &
      group_name_type('run', 'load_case'), &
      group_name_type('loadcase', 'load_case'), &
      group_name_type('loadcases', 'load_case'), &
      group_name_type('load', 'load_case'), &
      group_name_type('operation', 'load_case'), &
      group_name_type('case', 'load_case'), &
      group_name_type('survey', 'trajectory'), &
      group_name_type('surveys', 'trajectory'), &
      group_name_type('wellpath', 'trajectory'), &
      group_name_type('well_path', 'trajectory'), &
      group_name_type('path', 'trajectory'), &
      group_name_type('deviation', 'trajectory'), &
      group_name_type('mud', 'fluid'), &
      group_name_type('mud_weight', 'fluid'), &
      group_name_type('fluids', 'fluid'), &
      group_name_type('casing', 'hole'), &
      group_name_type('open_hole', 'hole'), &
      group_name_type('openhole', 'hole'), &
      group_name_type('wellbore', 'hole'), &
      group_name_type('hole_section', 'hole'), &
      group_name_type('well', 'job'), &
      group_name_type('units', 'job'), &
      group_name_type('settings', 'job'), &
      group_name_type('general', 'job'), &
      group_name_type('project', 'job')]

   type(key_name_type), parameter :: key_names(*) = [ &
      key_name_type('component', 'tool_joint_od', 'joint_od'), &
      key_name_type('component', 'tooljoint_od', 'joint_od'), &
      key_name_type('component', 'tj_od', 'joint_od'), &
      key_name_type('component', 'blade_od', 'joint_od'), &
      key_name_type('component', 'tool_joint_id', 'joint_id'), &
      key_name_type('component', 'tj_id', 'joint_id'), &
      key_name_type('component', 'tool_joint_length', 'joint_length'), &
      key_name_type('component', 'tj_length', 'joint_length'), &
      key_name_type('component', 'outer_diameter', 'od'), &
      key_name_type('component', 'outside_diameter', 'od'), &
      key_name_type('component', 'diameter', 'od'), &
      key_name_type('component', 'inner_diameter', 'id'), &
      key_name_type('component', 'inside_diameter', 'id'), &
      key_name_type('component', 'weight', 'mass'), &
      key_name_type('component', 'linear_weight', 'mass'), &
      key_name_type('component', 'unit_weight', 'mass'), &
      key_name_type('component', 'yield_strength', 'yield'), &
      key_name_type('component', 'min_yield', 'yield'), &
      key_name_type('component', 'modulus', 'youngs'), &
      key_name_type('component', 'type', 'kind'), &
      key_name_type('component', 'makeup', 'makeup_torque'), &
      key_name_type('hole', 'id', 'diameter'), &
      key_name_type('hole', 'od', 'diameter'), &
      key_name_type('hole', 'size', 'diameter'), &
      key_name_type('hole', 'hole_size', 'diameter'), &
      key_name_type('hole', 'hole_diameter', 'diameter'), &
      key_name_type('hole', 'ff', 'friction'), &
      key_name_type('hole', 'friction_factor', 'friction'), &
      key_name_type('hole', 'mu', 'friction'), &
      key_name_type('hole', 'top', 'md_top'), &
      key_name_type('hole', 'from', 'md_top'), &
      key_name_type('hole', 'bottom', 'md_bottom'), &
      key_name_type('hole', 'to', 'md_bottom'), &
      key_name_type('hole', 'shoe', 'md_bottom'), &
      key_name_type('fluid', 'mud_weight', 'density'), &
      key_name_type('fluid', 'weight', 'density'), &
      key_name_type('fluid', 'mw', 'density'), &
      key_name_type('trajectory', 'depth', 'md'), &
      key_name_type('trajectory', 'inclination', 'inc'), &
      key_name_type('trajectory', 'azimuth', 'azi'), &
      key_name_type('trajectory', 'file', 'survey_file'), &
      key_name_type('load_case', 'depth', 'bit_depth'), &
      key_name_type('load_case', 'md', 'bit_depth'), &
      key_name_type('load_case', 'weight_on_bit', 'wob'), &
      key_name_type('load_case', 'torque_on_bit', 'tob'), &
      key_name_type('load_case', 'bit_torque', 'tob'), &
      key_name_type('load_case', 'hookload', 'measured_hookload'), &
      key_name_type('load_case', 'hook_load', 'measured_hookload'), &
      key_name_type('load_case', 'torque', 'measured_torque'), &
      key_name_type('load_case', 'type', 'operation'), &
      key_name_type('job', 'name', 'title'), &
      key_name_type('job', 'unit_system', 'units'), &
      key_name_type('job', 'output', 'output_dir'), &
      key_name_type('job', 'model', 'models')]

contains

   !> Advice on an unknown group: the one that has its contents, else the nearest by its letters, else all.
   pure function group_advice(name, legal) result(advice)
      character(*), intent(in) :: name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: advice
      character(:), allocatable :: meant
      integer :: i
      meant = ''
      do i = 1, size(group_names)
         if (group_names(i)%foreign == name .and. any(legal == group_names(i)%ours)) meant = trim(group_names(i)%ours)
      end do
      advice = worded(meant, name, legal)
   end function group_advice

   !> Advice on an unknown key of a group, as for groups.
   pure function key_advice(group, name, legal) result(advice)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: advice
      advice = worded(same_key(group, name, legal), name, legal)
   end function key_advice

   !> The key that an unknown one is taken for; '' where none is.
   pure function meant_key(group, name, legal) result(meant)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: meant
      meant = same_key(group, name, legal)
      if (meant == '') meant = nearest_name(name, legal)
   end function meant_key

   !> The key that means the same; '' where none is known.
   pure function same_key(group, name, legal) result(meant)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: meant
      integer :: i
      meant = ''
      do i = 1, size(key_names)
         if (key_names(i)%group == group .and. key_names(i)%foreign == name .and. any(legal == key_names(i)%ours)) &
            meant = trim(key_names(i)%ours)
      end do
   end function same_key

   !> The advice in words.
   pure function worded(meant, name, legal) result(advice)
      character(*), intent(in) :: meant, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: advice
      if (meant /= '') then
         advice = "did you mean '"//meant//"'?"
      else
         advice = suggestion(name, legal)
      end if
   end function worded
end module dg_foreign_names
