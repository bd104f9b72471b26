!> Makes holes, components, load cases, boundary, rig and solver settings of checked groups, with the checks that
!> concern one group alone.
module dg_deck_parts
   use dg_kinds, only: wp
   use dg_case_check, only: check_operation
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, is_whole, line_of, real_of, integer_of, &
      logical_of, text_of, optional_of
   use dg_component, only: component_type, has_joints, tube_area
   use dg_connection, only: connection_name, connection_torsion, find_connection, makeup_share
   use dg_connection_rating, only: connection_rating_type
   use dg_design_factors, only: design_factors_type
   use dg_deck_draft, only: draft_hole_type, draft_component_type, draft_case_type
   use dg_fatigue_curve, only: fatigue_curve_name, fatigue_curve_type, fatigue_own
   use dg_error, only: error_list_type, key_of
   use dg_load_case, only: operation_from_name
   use dg_missing, only: is_missing, missing, optional_real
   use dg_model, only: boundary_type, hold_free, packer_hold_name
   use dg_shown_size, only: length_digits
   use dg_numerics, only: numerics_type, gap_at_extremum, gap_at_nodes, settings_of, solver_name
   use dg_rig, only: rig_type
   use dg_settings_check, only: check_numerics
   use dg_string_check, only: check_component
   use dg_text, only: is_separator_free, quoted, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: draft_hole, draft_component, draft_case, draft_boundary, draft_numerics, draft_rig, draft_design

   !> Yield strength of tool joints where none is given [Pa]: 120 ksi, the least of API Spec 5DP.
   real(wp), parameter :: usual_joint_yield = 120.0e3_wp*6894.757293168_wp
   !> Wall left by wear, in the order of the classes (API RP 7G-2).
   real(wp), parameter :: premium_wall = 0.8_wp, class_2_wall = 0.7_wp

contains

   !> A hole section; its ends may still be open.
   subroutine draft_hole(group, number, hole)
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: number            !< among the hole sections of the deck
      type(draft_hole_type), intent(out) :: hole
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
      hole%section%md_top = real_of(group, 'md_top', 0.0_wp)
      hole%section%md_bottom = real_of(group, 'md_bottom', 0.0_wp)
      hole%section%diameter = real_of(group, 'diameter', 0.0_wp)
      hole%section%friction_axial = real_of(group, 'friction_axial', friction)
      hole%section%friction_rotary = real_of(group, 'friction_rotary', friction)
      hole%section%friction_running_in = real_of(group, 'friction_running_in', missing)
      hole%section%wall_stiffness = real_of(group, 'wall_stiffness', 0.0_wp)
      hole%section%mud_sheath = real_of(group, 'mud_sheath', 0.0_wp)
      hole%section%cased = logical_of(group, 'cased', .false.)
      hole%section%casing_od = real_of(group, 'casing_od', missing)
      hole%section%casing_yield = real_of(group, 'casing_yield', missing)
      hole%section%wear_factor = real_of(group, 'wear_factor', missing)
   end subroutine draft_hole

   !> A component; checks its diameters and its joints.
   subroutine draft_component(group, units, item, faults)
      type(checked_group_type), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(draft_component_type), intent(out) :: item
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
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
         part%length = real_of(group, 'length', part%length)
         part%od = real_of(group, 'od', part%od)
         part%id = real_of(group, 'id', part%id)
         part%density = real_of(group, 'density', part%density)
         part%youngs = real_of(group, 'youngs', part%youngs)
         part%poisson = real_of(group, 'poisson', part%poisson)
         part%expansion = real_of(group, 'expansion', part%expansion)
         part%joint_od = real_of(group, 'joint_od', part%joint_od)
         part%joint_length = real_of(group, 'joint_length', part%joint_length)
         part%opened_od = real_of(group, 'opened_od', part%opened_od)
         part%opened_below = real_of(group, 'opened_below', part%opened_below)
         part%joint_spacing = real_of(group, 'joint_spacing', part%joint_spacing)
         part%yield = real_of(group, 'yield', part%yield)
         part%yield_loss = real_of(group, 'yield_loss', part%yield_loss)
         part%makeup_torque = real_of(group, 'makeup_torque', part%makeup_torque)
         item%mass_given = is_given(group, 'mass')
         call draft_friction()
         select case (text_of(group, 'wear_class', 'new'))
         case ('premium'); part%wall_left = premium_wall
         case ('class2'); part%wall_left = class_2_wall
         case default
         end select
         part%wall_left = real_of(group, 'wall_left', part%wall_left)
         part%joint_torsion = joint_torsion_of(group, part)
         if (.not. part%makeup_torque > 0.0_wp) part%makeup_torque = makeup_share*part%joint_torsion
         call draft_rating(group, part%rating)
         call draft_tools(group, part, faults)
         if (part%joint_od > part%od) item%line_diameter = line_of(group, 'joint_od')
         if (part%id < part%od) part%mass = real_of(group, 'mass', part%density*tube_area(part%od, part%id))
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

      !> Coefficients of its own, or scales of the hole's: not both for one way.
      subroutine draft_friction()
         real(wp) :: own, scale
         logical :: refused
         own = real_of(group, 'friction', missing)
         scale = real_of(group, 'friction_scale', 1.0_wp)
         item%component%friction_axial = real_of(group, 'friction_axial', own)
         item%component%friction_rotary = real_of(group, 'friction_rotary', own)
         item%component%scale_axial = real_of(group, 'friction_scale_axial', scale)
         item%component%scale_rotary = real_of(group, 'friction_scale_rotary', scale)
         refused = .false.
         call refuse_both('axial', item%component%friction_axial, refused)
         call refuse_both('rotary', item%component%friction_rotary, refused)
      end subroutine draft_friction

      !> A coefficient of its own in one way leaves nothing to scale there.
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
      part%sensor = real_of(group, 'sensor', part%sensor)
      part%bend = real_of(group, 'bend', part%bend)
      part%bend_position = real_of(group, 'bend_position', part%bend_position)
      if (part%bend > 0.0_wp .and. .not. is_given(group, 'bend_position')) &
         call group_fault(group, 'bend', 'bend needs bend_position, its distance above the lower end of the component', faults)
      part%pad_force = real_of(group, 'pad_force', part%pad_force)
      part%pad_clock = real_of(group, 'pad_clock', part%pad_clock)
      part%pad_position = real_of(group, 'pad_position', part%pad_position)
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

   !> Ratings of the connections.
   subroutine draft_rating(group, rating)
      type(checked_group_type), intent(in) :: group
      type(connection_rating_type), intent(inout) :: rating
      rating%tension = real_of(group, 'tension_efficiency', rating%tension)
      rating%compression = real_of(group, 'compression_efficiency', rating%compression)
      rating%burst = real_of(group, 'burst_efficiency', rating%burst)
      rating%collapse = real_of(group, 'collapse_efficiency', rating%collapse)
      rating%dogleg = real_of(group, 'joint_dogleg', rating%dogleg)
   end subroutine draft_rating

   !> Torque at which the connections of a component yield [N.m]: as given, or by their dimensions; 0: not known.
   function joint_torsion_of(group, part) result(torque)
      type(checked_group_type), intent(in) :: group
      type(component_type), intent(in) :: part
      real(wp) :: torque
      real(wp) :: od, bore, yield
      integer :: number
      torque = real_of(group, 'joint_torsion', 0.0_wp)
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
      if (real_of(group, 'joint_id', 0.0_wp) > 0.0_wp) bore = real_of(group, 'joint_id', bore)
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
      type(checked_group_type), intent(in) :: group
      type(draft_case_type), intent(out) :: item
      type(error_list_type), intent(inout) :: faults
      type(optional_real) :: friction
      type(error_list_type) :: found
      integer :: i, before
      before = faults%noted
      item%line = group%line
      item%line_name = line_of(group, 'name')
      item%line_depth = line_of(group, 'bit_depth')
      item%line_string = line_of(group, 'string')
      item%length_reference = text_of(group, 'length_reference', '')
      item%line_reference = line_of(group, 'length_reference')
      if (is_given(group, 'wob')) item%line_wob = line_of(group, 'wob')
      friction = optional_of(group, 'friction')
      associate (case => item%load_case)
         case%name = text_of(group, 'name', '')
         case%section = text_of(group, 'section', '')
         case%string = text_of(group, 'string', 'main')
         if (is_sound(group, 'operation')) case%operation = operation_from_name(text_of(group, 'operation', ''))
         case%bit_depth = real_of(group, 'bit_depth', 0.0_wp)
         case%wob = real_of(group, 'wob', 0.0_wp)
         case%tob = real_of(group, 'tob', 0.0_wp)
         case%pump_pressure = real_of(group, 'pump_pressure', 0.0_wp)
         case%temperature_change_top = real_of(group, 'temperature_change_top', 0.0_wp)
         case%temperature_change_bottom = real_of(group, 'temperature_change_bottom', 0.0_wp)
         case%above_ambient_top = real_of(group, 'above_ambient_top', 0.0_wp)
         case%above_ambient_bottom = real_of(group, 'above_ambient_bottom', 0.0_wp)
         case%angular_speed = real_of(group, 'rpm', 0.0_wp)
         case%trip_speed = real_of(group, 'trip_speed', 0.0_wp)
         case%hours = real_of(group, 'hours', 0.0_wp)
         case%toolface = real_of(group, 'toolface', 0.0_wp)
         case%friction_axial = optional_of(group, 'friction_axial')
         case%friction_rotary = optional_of(group, 'friction_rotary')
         if (.not. case%friction_axial%present) case%friction_axial = friction
         if (.not. case%friction_rotary%present) case%friction_rotary = friction
         case%measured_hookload = optional_of(group, 'measured_hookload')
         case%measured_torque = optional_of(group, 'measured_torque')
         case%reference_hookload = optional_of(group, 'reference_hookload')
         if (is_sound(group, 'name') .and. .not. is_separator_free(case%name)) then
            call group_fault(group, 'name', 'name = '//quoted(case%name)//' cannot be part of a file name; use 1 to 100 '// &
                             'letters, digits and _ - . +, no dot first', faults)
            case%name = ''
         end if
      end associate
      if (is_sound(group, 'operation')) call check_operation(item%load_case, 0, found)
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
      type(checked_group_type), intent(in) :: group
      type(rig_type), intent(out) :: rig
      type(error_list_type), intent(inout) :: faults
      rig%given = .true.
      rig%block_weight = real_of(group, 'block_weight', rig%block_weight)
      rig%lines = integer_of(group, 'lines', rig%lines)
      rig%sheave_efficiency = real_of(group, 'sheave_efficiency', rig%sheave_efficiency)
      rig%active_deadline_sheave = text_of(group, 'deadline_sheave', 'inactive') == 'active'
      rig%max_hookload = optional_of(group, 'max_hookload')
      rig%max_torque = optional_of(group, 'max_torque')
      if (is_sound(group, 'sheave_efficiency') .and. rig%sheave_efficiency < 1.0_wp .and. .not. is_given(group, 'lines')) &
         call group_fault(group, 'sheave_efficiency', 'sheave_efficiency = '//to_text(rig%sheave_efficiency, length_digits)// &
                          ' needs lines, the number strung to the travelling block', faults)
   end subroutine draft_rig

   !> Settings of the solver; checks their order.
   subroutine draft_numerics(group, numerics, faults)
      type(checked_group_type), intent(in) :: group
      type(numerics_type), intent(out) :: numerics
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      real(wp) :: rigid_over_elastic
      integer :: i
      numerics = settings_of(text_of(group, 'fidelity', 'auto'))
      numerics%element_length = real_of(group, 'element_length', numerics%element_length)
      if (is_given(group, 'gap_location') .and. is_sound(group, 'gap_location')) &
         numerics%gap_location = merge(gap_at_nodes, gap_at_extremum, text_of(group, 'gap_location', '') == 'nodes')
      numerics%friction_range = logical_of(group, 'friction_range', numerics%friction_range)
      numerics%discrete_joints = is_sound(group, 'tool_joints') .and. text_of(group, 'tool_joints', '') == 'discrete'
      if (is_sound(group, 'linear_solver')) &
         numerics%linear_solver = findloc(solver_name == text_of(group, 'linear_solver', ''), .true., dim=1)
      numerics%tolerance = real_of(group, 'tolerance', numerics%tolerance)
      numerics%max_iterations = integer_of(group, 'max_iterations', numerics%max_iterations)
      numerics%load_steps = integer_of(group, 'load_steps', numerics%load_steps)
      numerics%gk_min = real_of(group, 'gk_min', numerics%gk_min)
      rigid_over_elastic = numerics%gk_max/numerics%gk_contact
      numerics%gk_contact = real_of(group, 'gk_contact', numerics%gk_contact)
      numerics%gk_max = real_of(group, 'gk_max', rigid_over_elastic*numerics%gk_contact)
      numerics%eps_n0 = real_of(group, 'eps_n0', numerics%eps_n0)
      numerics%eps_nmax = real_of(group, 'eps_nmax', numerics%eps_nmax)
      numerics%r_n0 = real_of(group, 'r_n0', numerics%r_n0)
      numerics%relocation = real_of(group, 'relocation', numerics%relocation)
      numerics%step_limit = real_of(group, 'step_limit', numerics%step_limit)
      numerics%imperfection = real_of(group, 'imperfection', numerics%imperfection)
      numerics%history = logical_of(group, 'history', numerics%history)
      numerics%mixed_elements = is_sound(group, 'mixed_parts') .and. text_of(group, 'mixed_parts', '') == 'elements'
      numerics%wall_climb = logical_of(group, 'wall_climb', numerics%wall_climb)
      call check_numerics(numerics, found)
      do i = 1, found%count
         call group_fault(group, key_of(found%items(i)), found%items(i)%message, faults)
      end do
   end subroutine draft_numerics
end module dg_deck_parts
