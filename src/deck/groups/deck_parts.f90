!> Make holes, components, load cases, boundary, rig and solver settings of checked groups, and check each group by itself.
module dg_deck_parts
   use dg_kinds, only: wp
   use dg_constants, only: psi
   use dg_case_check, only: check_operation
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, is_whole, line_of, real_of, &
      logical_of, text_of, optional_of
   use dg_component, only: component_type, has_joints, tube_area, visit_forces, visit_ratings
   use dg_connection, only: connection_name, connection_torsion, find_connection, makeup_share
   use dg_design_factors, only: design_factors_type
   use dg_deck_draft, only: draft_hole_type, draft_component_type, draft_case_type
   use dg_fatigue_curve, only: fatigue_curve_name, fatigue_curve_type, fatigue_own
   use dg_error, only: error_list_type, key_of
   use dg_hole_section, only: visit_hole
   use dg_key_visitor, only: key_visitor_type
   use dg_load_case, only: operation_from_name, visit_case
   use dg_missing, only: is_missing, missing, optional_real
   use dg_model, only: boundary_type, hold_free, packer_hold_name
   use dg_shown_size, only: length_digits
   use dg_numerics, only: numerics_type, gap_at_extremum, gap_at_nodes, settings_of, solver_name, visit_numerics
   use dg_rig, only: rig_type, visit_rig
   use dg_range_check, only: check_numerics
   use dg_string_check, only: check_component
   use dg_text, only: is_separator_free, quoted, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: draft_hole, draft_component, draft_case, draft_boundary, draft_numerics, draft_rig, draft_design

   !> Yield strength of tool joints where none is given [Pa]: 120 ksi, the least of API Spec 5DP.
   real(wp), parameter :: usual_joint_yield = 120.0e3_wp*psi
   !> Wall left by wear, in the order of the classes (API RP 7G-2).
   real(wp), parameter :: premium_wall = 0.8_wp, class_2_wall = 0.7_wp

   !> Reads the numbers that it visits from a group of a deck. A number that the group does not give stays.
   type, extends(key_visitor_type) :: group_reader_type
      type(checked_group_type), pointer :: group => null()
   contains
      procedure :: number => read_number
      procedure :: number_or_missing => read_number
   end type group_reader_type

contains

   subroutine read_number(self, key, value)
      class(group_reader_type), intent(inout) :: self
      character(*), intent(in) :: key
      real(wp), intent(inout) :: value              !< [SI]
      value = real_of(self%group, key, value)
   end subroutine read_number

   !> A hole section; its ends may still be open.
   subroutine draft_hole(group, number, hole)
      type(checked_group_type), intent(in), target :: group
      integer, intent(in) :: number            !< among the hole sections of the deck
      type(draft_hole_type), intent(out) :: hole
      type(group_reader_type) :: reader
      real(wp) :: friction
      hole%line = group%line
      hole%line_top = line_of(group, 'md_top')
      hole%line_bottom = line_of(group, 'md_bottom')
      hole%has_top = is_given(group, 'md_top')
      hole%has_bottom = is_given(group, 'md_bottom')
      hole%sound = is_whole(group)
      friction = real_of(group, 'friction', 0.0_wp)
      hole%friction_given = is_given(group, 'friction') .or. is_given(group, 'friction_axial') .or. &
                            is_given(group, 'friction_rotary')
      hole%section%name = text_of(group, 'name', 'hole '//to_text(number))
      if (is_given(group, 'name') .and. .not. is_sound(group, 'name')) hole%section%name = ''
      hole%section%friction_axial = friction
      hole%section%friction_rotary = friction
      reader%group => group
      call visit_hole(hole%section, reader)
      hole%section%cased = logical_of(group, 'cased', .false.)
   end subroutine draft_hole

   !> A component; checks its diameters and its joints.
   subroutine draft_component(group, units, item, faults)
      type(checked_group_type), intent(in), target :: group
      type(unit_system_type), intent(in) :: units
      type(draft_component_type), intent(out) :: item
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      type(group_reader_type) :: reader
      integer :: i, before
      before = faults%noted
      item%line = group%line
      item%line_length = line_of(group, 'length')
      item%line_density = line_of(group, 'density')
      item%line_diameter = line_of(group, 'od')
      item%line_opened = line_of(group, 'opened_od')
      item%connected = is_sound(group, 'connection')
      item%string = text_of(group, 'string', 'main')
      if (is_given(group, 'string') .and. .not. is_sound(group, 'string')) item%string = ''
      associate (part => item%component)
         part%kind = text_of(group, 'kind', 'drillpipe')
         part%name = text_of(group, 'name', part%kind)
         item%mass_given = is_given(group, 'mass')
         item%joint_yield = real_of(group, 'joint_yield', item%joint_yield)
         select case (text_of(group, 'wear_class', 'new'))
         case ('premium'); part%wall_left = premium_wall
         case ('class2'); part%wall_left = class_2_wall
         case default
         end select
         part%friction_axial = real_of(group, 'friction', missing)
         part%friction_rotary = part%friction_axial
         part%scale_axial = real_of(group, 'friction_scale', 1.0_wp)
         part%scale_rotary = part%scale_axial
         reader%group => group
         call visit_forces(part, reader)
         call visit_ratings(part, reader)
         call check_friction()
         item%makeup_given = part%makeup_torque > 0.0_wp
         item%torsion_given = part%joint_torsion > 0.0_wp
         part%joint_torsion = joint_torsion_of(group, part)
         if (.not. part%makeup_torque > 0.0_wp) part%makeup_torque = makeup_share*part%joint_torsion
         call draft_tools(group, part, faults)
         if (part%joint_od > part%od) item%line_diameter = line_of(group, 'joint_od')
         if (part%id < part%od .and. .not. is_sound(group, 'mass')) part%mass = part%density*tube_area(part%od, part%id)
      end associate
      call check_component(item%component, 0, units, found)
      do i = 1, found%count
         associate (wrong => found%items(i))
            if (key_of(wrong) == 'id' .and. .not. is_sound(group, 'id')) cycle
            if (any(key_of(wrong) == [character(9) :: 'id', 'joint_od', 'opened_od']) .and. .not. is_sound(group, 'od')) cycle
            if (key_of(wrong) == 'opened_below' .and. is_given(group, 'opened_od') .and. .not. is_sound(group, 'opened_od')) cycle
            call group_fault(group, key_of(wrong), wrong%message, faults)
         end associate
      end do
      item%sound = is_whole(group) .and. faults%noted == before

   contains

      !> Check coefficients of its own, and scales of the hole's: not both for one direction.
      subroutine check_friction()
         logical :: refused
         refused = .false.
         call refuse_both('axial', item%component%friction_axial, refused)
         call refuse_both('rotary', item%component%friction_rotary, refused)
      end subroutine check_friction

      !> Refuse a scale where there is a coefficient of its own.
      subroutine refuse_both(way, own, refused)
         character(*), intent(in) :: way
         real(wp), intent(in) :: own
         logical, intent(inout) :: refused
         character(:), allocatable :: scale
         if (is_missing(own) .or. refused) return
         scale = 'friction_scale_'//way
         if (.not. is_given(group, scale)) scale = 'friction_scale'
         refused = is_given(group, scale)
         if (refused) call group_fault(group, scale, scale//' has nothing to scale: the component has its own '//way// &
                                       ' friction; give one of the two', faults)
      end subroutine refuse_both
   end subroutine draft_component

   !> Extras of a component: bent housing, pads, survey sensor, fatigue curve. A bend and pads need their positions.
   subroutine draft_tools(group, part, faults)
      type(checked_group_type), intent(in) :: group
      type(component_type), intent(inout) :: part
      type(error_list_type), intent(inout) :: faults
      if (part%bend > 0.0_wp .and. .not. is_given(group, 'bend_position')) &
         call group_fault(group, 'bend', 'bend needs bend_position, its distance above the lower end of the component', faults)
      if (part%pad_force > 0.0_wp .and. .not. is_given(group, 'pad_position')) &
         call group_fault(group, 'pad_force', 'pad_force needs pad_position, its distance above the lower end of the '// &
                          'component', faults)
      call draft_fatigue(group, part%fatigue, part%joint_fatigue)
      if (part%fatigue%curve == fatigue_own .and. .not. is_given(group, 'fatigue_limit')) &
         call group_fault(group, 'fatigue_curve', "fatigue_curve = 'own' needs fatigue_limit", faults)
      if (part%fatigue%curve /= fatigue_own .and. is_sound(group, 'fatigue_limit')) &
         call group_fault(group, 'fatigue_limit', "fatigue_limit needs fatigue_curve = 'own'", faults)
      if (part%joint_fatigue%curve /= fatigue_own .and. is_given(group, 'joint_fatigue_exponent')) &
         call group_fault(group, 'joint_fatigue_exponent', 'joint_fatigue_exponent needs joint_fatigue_limit', faults)
   end subroutine draft_tools

   !> A fatigue curve of the body by name, or an own one; an own one of connections.
   subroutine draft_fatigue(group, fatigue, joints)
      type(checked_group_type), intent(in) :: group
      type(fatigue_curve_type), intent(inout) :: fatigue, joints
      if (is_sound(group, 'fatigue_curve')) &
         fatigue%curve = findloc(fatigue_curve_name == text_of(group, 'fatigue_curve', 'none'), .true., dim=1)
      fatigue%limit = real_of(group, 'fatigue_limit', fatigue%limit)
      fatigue%tensile = real_of(group, 'tensile_strength', fatigue%tensile)
      fatigue%share = real_of(group, 'fatigue_share', fatigue%share)
      fatigue%exponent = real_of(group, 'fatigue_exponent', fatigue%exponent)
      fatigue%turns = real_of(group, 'fatigue_turns', fatigue%turns)
      if (is_sound(group, 'joint_fatigue_limit')) joints%curve = fatigue_own
      joints%limit = real_of(group, 'joint_fatigue_limit', joints%limit)
      joints%share = fatigue%share
      joints%exponent = real_of(group, 'joint_fatigue_exponent', joints%exponent)
      joints%turns = real_of(group, 'joint_fatigue_turns', joints%turns)
   end subroutine draft_fatigue

   !> Torque at which the connections of a component yield [N.m]: as given, or by their dimensions; 0: not known.
   function joint_torsion_of(group, part) result(torque)
      type(checked_group_type), intent(in) :: group
      type(component_type), intent(in) :: part
      real(wp) :: torque
      real(wp) :: od, bore, yield
      integer :: number
      torque = part%joint_torsion
      if (torque > 0.0_wp .or. .not. is_sound(group, 'connection')) return
      number = findloc(connection_name == text_of(group, 'connection', ''), .true., dim=1)
      if (number == 0) return
      od = part%od
      bore = part%id
      yield = part%yield
      if (has_joints(part)) then
         od = part%joint_od
         bore = 0.0_wp
         yield = usual_joint_yield
      end if
      if (part%joint_id > 0.0_wp) bore = part%joint_id
      torque = 0.0_wp
      if (bore > 0.0_wp) torque = connection_torsion(find_connection(number), od, bore, real_of(group, 'joint_yield', yield))
   end function joint_torsion_of

   !> Design factors and slips.
   function draft_design(group) result(design)
      type(checked_group_type), intent(in) :: group
      type(design_factors_type) :: design
      design%von_mises = real_of(group, 'von_mises_factor', design%von_mises)
      design%tension = real_of(group, 'tension_factor', design%tension)
      design%torsion = real_of(group, 'torsion_factor', design%torsion)
      design%burst = real_of(group, 'burst_factor', design%burst)
      design%collapse = real_of(group, 'collapse_factor', design%collapse)
      design%slip_length = real_of(group, 'slip_length', design%slip_length)
      design%slip_lateral = real_of(group, 'slip_lateral', design%slip_lateral)
   end function draft_design

   !> A load case; checks its name and what its operation needs.
   subroutine draft_case(group, item, faults)
      type(checked_group_type), intent(in), target :: group
      type(draft_case_type), intent(out) :: item
      type(error_list_type), intent(inout) :: faults
      type(optional_real) :: friction
      type(error_list_type) :: found
      type(group_reader_type) :: reader
      integer :: i, before
      before = faults%noted
      item%line = group%line
      item%line_name = line_of(group, 'name')
      item%line_depth = line_of(group, 'bit_depth')
      item%line_string = line_of(group, 'string')
      item%length_reference = text_of(group, 'length_reference', '')
      item%line_reference = line_of(group, 'length_reference')
      if (is_given(group, 'wob')) item%line_wob = line_of(group, 'wob')
      if (is_given(group, 'tob')) item%line_tob = line_of(group, 'tob')
      friction = optional_of(group, 'friction')
      associate (case => item%load_case)
         case%name = text_of(group, 'name', '')
         case%section = text_of(group, 'section', '')
         case%string = text_of(group, 'string', 'main')
         if (is_sound(group, 'operation')) case%operation = operation_from_name(text_of(group, 'operation', ''))
         case%friction_axial = friction
         case%friction_rotary = friction
         reader%group => group
         call visit_case(case, reader)
         if (is_sound(group, 'name') .and. .not. is_separator_free(case%name)) then
            call group_fault(group, 'name', 'name = '//quoted(case%name)//' cannot be part of a file name; use 1 to 100 '// &
                             'letters, digits and _ - . +, no dot first', faults)
            case%name = ''
         end if
      end associate
      if (is_sound(group, 'operation')) call check_operation(item%load_case, found)
      do i = 1, found%count
         associate (wrong => found%items(i))
            if (is_sound(group, key_of(wrong))) call group_fault(group, key_of(wrong), wrong%message, faults)
         end associate
      end do
      item%sound = is_whole(group) .and. faults%noted == before
   end subroutine draft_case

   !> Supports of the string's ends, and the packer at the lower one.
   subroutine draft_boundary(group, boundary, faults)
      type(checked_group_type), intent(in) :: group
      type(boundary_type), intent(out) :: boundary
      type(error_list_type), intent(inout) :: faults
      boundary%top_centred = text_of(group, 'top_lateral', 'centred') == 'centred'
      boundary%bit_centred = text_of(group, 'bit_lateral', 'centred') == 'centred'
      boundary%packer_bore = real_of(group, 'packer_bore', boundary%packer_bore)
      if (.not. is_sound(group, 'packer_hold')) return
      boundary%packer_hold = findloc(packer_hold_name == text_of(group, 'packer_hold', packer_hold_name(hold_free)), .true., dim=1)
      if (boundary%packer_hold /= hold_free .and. .not. is_given(group, 'packer_bore')) &
         call group_fault(group, 'packer_hold', 'packer_hold needs packer_bore, the diameter of the seal bore', faults)
   end subroutine draft_boundary

   !> The rig; sheaves that take tension need the number of lines.
   subroutine draft_rig(group, rig, faults)
      type(checked_group_type), intent(in), target :: group
      type(rig_type), intent(out) :: rig
      type(error_list_type), intent(inout) :: faults
      type(group_reader_type) :: reader
      rig%given = .true.
      reader%group => group
      call visit_rig(rig, reader)
      rig%active_deadline_sheave = text_of(group, 'deadline_sheave', 'inactive') == 'active'
      if (is_sound(group, 'sheave_efficiency') .and. rig%sheave_efficiency < 1.0_wp .and. .not. is_given(group, 'lines')) &
         call group_fault(group, 'sheave_efficiency', 'sheave_efficiency = '//to_text(rig%sheave_efficiency, length_digits)// &
                          ' needs lines, the number strung to the travelling block', faults)
   end subroutine draft_rig

   !> Settings of the solver; checks their order.
   subroutine draft_numerics(group, numerics, faults)
      type(checked_group_type), intent(in), target :: group
      type(numerics_type), intent(out) :: numerics
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      type(group_reader_type) :: reader
      real(wp) :: rigid_over_elastic
      integer :: i
      numerics = settings_of(text_of(group, 'fidelity', 'auto'))
      if (is_given(group, 'gap_location') .and. is_sound(group, 'gap_location')) &
         numerics%gap_location = merge(gap_at_nodes, gap_at_extremum, text_of(group, 'gap_location', '') == 'nodes')
      numerics%friction_range = logical_of(group, 'friction_range', numerics%friction_range)
      numerics%discrete_joints = is_sound(group, 'tool_joints') .and. text_of(group, 'tool_joints', '') == 'discrete'
      numerics%joints_by_need = numerics%joints_by_need .and. text_of(group, 'tool_joints', 'auto') == 'auto'
      if (is_sound(group, 'linear_solver')) &
         numerics%linear_solver = findloc(solver_name == text_of(group, 'linear_solver', ''), .true., dim=1)
      rigid_over_elastic = numerics%gk_max/numerics%gk_contact
      reader%group => group
      call visit_numerics(numerics, reader)
      if (is_given(group, 'element_length')) numerics%full_length = 0.0_wp
      if (.not. is_sound(group, 'gk_max')) numerics%gk_max = rigid_over_elastic*numerics%gk_contact
      numerics%history = logical_of(group, 'history', numerics%history)
      numerics%mixed_elements = is_sound(group, 'mixed_parts') .and. text_of(group, 'mixed_parts', '') == 'elements'
      numerics%wall_climb = logical_of(group, 'wall_climb', numerics%wall_climb)
      call check_numerics(numerics, found)
      do i = 1, found%count
         call group_fault(group, key_of(found%items(i)), found%items(i)%message, faults)
      end do
   end subroutine draft_numerics
end module dg_deck_parts
