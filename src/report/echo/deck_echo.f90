!> Summary of a deck as the program understood it, for the terminal and the page, in the deck's units.
module dg_deck_echo
   use dg_kinds, only: wp
   use dg_component, only: component_type, is_worn, opens, worn_od
   use dg_design_factors, only: design_factors_type
   use dg_fluid, only: collar_name, collar_none
   use dg_hole_section, only: hole_section_type
   use dg_job, only: job_type, model_name
   use dg_line_list, only: add_line, line_list_type, take_lines
   use dg_load_case, only: operation_name
   use dg_centralizer, only: centralizer_type
   use dg_missing, only: is_missing, optional_real
   use dg_model, only: hold_free, model_type, packer_hold_name
   use dg_numerics, only: numerics_type, gap_at_nodes
   use dg_pipe_strength, only: burst_strength, collapse_strength, collapses_as_steel, slip_share, tensile_strength, &
      torsional_strength
   use dg_rig, only: rig_type
   use dg_text, only: either, text_type, to_text
   use dg_tools_text, only: tools_text
   use dg_trajectory, only: position_at, top_md
   use dg_unit_kind, only: unit_angle, unit_factor, unit_label, unit_length, unit_diameter, unit_mass, unit_density, unit_force, &
      unit_moment, unit_pressure, unit_rotation, unit_speed, unit_stress, unit_temperature, unit_wall, unit_wear
   use dg_units, only: unit_system_type
   use dg_well_head, only: deepest_bit, find_clearances
   implicit none
   private
   public :: echo_lines, hole_friction_text

   !> Significant digits of a number in the echo.
   integer, parameter :: digits = 7

contains

   !> Summary of a deck, line by line.
   pure subroutine echo_lines(job, model, before, after, lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(text_type), intent(in) :: before(:), after(:)   !< summaries of studies, before and after the settings of the solver
      type(text_type), allocatable, intent(out) :: lines(:)
      type(line_list_type) :: list
      character(:), allocatable :: models
      integer :: i
      models = ''
      do i = 1, size(job%models)
         if (i > 1) models = models//', '
         models = models//trim(model_name(job%models(i)))
      end do
      if (job%title /= '') call add_line(list, 'title       '//job%title)
      call add_line(list, 'models      '//models)
      call add_line(list, 'units       '//trim(job%units%name))
      call add_line(list, 'results in  '//job%output_dir)
      if (job%rig_limit%present) call add_line(list, 'rig         '// &
         quantity(job%rig_limit%value, job%units%force, unit_label(job%units, unit_force))//' of hook load')
      if (model%rig%given) call add_line(list, rig_line(job%units, model%rig))
      call add_hole(list, job%units, model)
      do i = 1, size(model%strings)
         call add_string(list, job, model, i)
      end do
      call add_line(list, 'boundary    top '//lateral(model%boundary%top_centred)//', bit '// &
         lateral(model%boundary%bit_centred)// &
         optional(', packer bore ', model%boundary%packer_bore, job%units%diameter, unit_label(job%units, unit_diameter))// &
         hold_text(model%boundary%packer_hold))
      call add_line(list, 'load cases  '//to_text(size(model%cases)))
      do i = 1, size(model%cases)
         call add_case(list, job%units, model, i)
      end do
      do i = 1, size(before)
         call add_line(list, before(i)%text)
      end do
      call add_numerics(list, job%units, model%numerics)
      do i = 1, size(after)
         call add_line(list, after(i)%text)
      end do
      call take_lines(list, lines)
   end subroutine echo_lines

   !> Line on the rig between string and weight indicator.
   pure function rig_line(units, rig) result(line)
      type(unit_system_type), intent(in) :: units
      type(rig_type), intent(in) :: rig
      character(:), allocatable :: line
      line = 'rig         block '//quantity(rig%block_weight, units%force, unit_label(units, unit_force))
      if (rig%max_torque%present) &
         line = line//', top drive '//quantity(rig%max_torque%value, units%moment, unit_label(units, unit_moment))
      if (.not. rig%sheave_efficiency < 1.0_wp) return
      line = line//', '//to_text(rig%lines)//' lines, sheaves of efficiency '//to_text(rig%sheave_efficiency, digits)// &
         ', dead-line sheave '//either('active', 'inactive', rig%active_deadline_sheave)
   end function rig_line

   !> Path, sections of the hole, mud.
   pure subroutine add_hole(lines, units, model)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      real(wp) :: position(3), tangent(3)
      integer :: i, n
      associate (path => model%trajectory)
         n = size(path%md)
         call position_at(path, path%md(n), position, tangent)
         call add_line(lines, 'trajectory  '//to_text(n)//' stations to '//quantity(path%md(n), units%length, 'measured')// &
            ', '//quantity(position(3), units%length, 'vertical')//', '//quantity(position(1), units%length, 'north')// &
            ', '//quantity(position(2), units%length, 'east')//' ['//unit_label(units, unit_length)//'], inclination up to '// &
            quantity(maxval(path%inclination), units%angle, 'deg'))
      end associate
      do i = 1, size(model%holes)
         associate (hole => model%holes(i))
            call add_line(lines, 'hole        '//hole%name//': '//span(hole%md_top, hole%md_bottom, units)//', diameter '// &
               quantity(hole%diameter, units%diameter, unit_label(units, unit_diameter))//', '//hole_friction_text(hole)// &
               optional(', wall ', hole%wall_stiffness, units%wall_stiffness, unit_label(units, unit_wall))// &
               optional(', mud sheath ', hole%mud_sheath, units%diameter, unit_label(units, unit_diameter))// &
               casing_text(units, hole))
         end associate
      end do
      call add_fluids(lines, units, model)
   end subroutine add_hole

   !> The casing of a hole section, '' without a calculation of its wear.
   pure function casing_text(units, hole) result(text)
      type(unit_system_type), intent(in) :: units
      type(hole_section_type), intent(in) :: hole
      character(:), allocatable :: text
      text = ''
      if (.not. is_missing(hole%casing_od)) text = ', casing '// &
         quantity(hole%casing_od, units%diameter, unit_label(units, unit_diameter))
      if (.not. is_missing(hole%casing_yield)) text = text//', yield '// &
         quantity(hole%casing_yield, units%stress, unit_label(units, unit_stress))
      if (.not. is_missing(hole%wear_factor)) text = text//', wear factor '// &
         quantity(hole%wear_factor, unit_factor(units, unit_wear), unit_label(units, unit_wear))
   end function casing_text

   !> Friction of a hole section in words.
   pure function hole_friction_text(hole) result(text)
      type(hole_section_type), intent(in) :: hole
      character(:), allocatable :: text
      text = 'friction axial '//to_text(hole%friction_axial, digits)//', rotary '//to_text(hole%friction_rotary, digits)
      if (.not. is_missing(hole%friction_running_in)) text = text//', running in '//to_text(hole%friction_running_in, digits)
   end function hole_friction_text

   !> Fluids and gravity, in one line where one fluid fills all.
   pure subroutine add_fluids(lines, units, model)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      character(:), allocatable :: place
      integer :: i
      do i = 1, size(model%mud%fluids)
         associate (fluid => model%mud%fluids(i))
            place = ''
            if (.not. fluid%outside) place = ' inside'
            if (.not. fluid%inside) place = ' outside'
            if (fluid%above_bit > 0.0_wp) then
               place = place//', from '//quantity(fluid%above_bit, units%length, unit_label(units, unit_length))//' above the bit'
            else if (fluid%md_top > 0.0_wp) then
               place = place//', from '//quantity(fluid%md_top, units%length, unit_label(units, unit_length))
            end if
            if (fluid%collar /= collar_none) place = place//', float collar '//trim(collar_name(fluid%collar))
            place = place//optional(', annulus at surface ', fluid%surface_pressure, unit_factor(units, unit_pressure), &
                                     unit_label(units, unit_pressure))
            call add_line(lines, 'fluid       '//quantity(fluid%density, units%density, unit_label(units, unit_density))//place)
         end associate
      end do
      lines%lines(lines%count)%text = lines%lines(lines%count)%text//', gravity '//quantity(model%gravity, 1.0_wp, 'm/s2')
   end subroutine add_fluids

   !> A string with its components, from the bit upwards.
   pure subroutine add_string(lines, job, model, number)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: number
      type(optional_real) :: clearances(size(model%strings(number)%components))
      real(wp) :: places(size(clearances))
      integer :: i
      character(:), allocatable :: length, clearance
      associate (string => model%strings(number), units => job%units)
         if (deepest_bit(model, string) > top_md(model%trajectory)) &
            call find_clearances(model, string, deepest_bit(model, string), clearances, places)
         call add_line(lines, 'string      '//string%name//', from the bit upwards')
         do i = 1, size(string%components)
            associate (part => string%components(i))
               length = 'to surface'
               if (part%length > 0.0_wp) length = quantity(part%length, units%length, unit_label(units, unit_length))
               clearance = ''
               if (clearances(i)%present) clearance = ', clearance '// &
                  quantity(clearances(i)%value, units%diameter, unit_label(units, unit_diameter))
               call add_line(lines, '  '//part%name//' ('//part%kind//'): '//length//', od '// &
                  quantity(part%od, units%diameter, unit_label(units, unit_diameter))//', id '// &
                  quantity(part%id, units%diameter, unit_label(units, unit_diameter))//', '// &
                  quantity(part%mass, units%mass_per_length, unit_label(units, unit_mass))//', density '// &
                  quantity(part%density, units%density, unit_label(units, unit_density))// &
                  optional(', joints ', part%joint_od, units%diameter, unit_label(units, unit_diameter))// &
                  clearance//opening_text(units, part)// &
                  optional(', yield ', part%yield, units%stress, unit_label(units, unit_stress))// &
                  optional(', make-up ', part%makeup_torque, units%moment, unit_label(units, unit_moment))// &
                  friction_text(' axial ', part%friction_axial, part%scale_axial)// &
                  friction_text(' rotary ', part%friction_rotary, part%scale_rotary)// &
                  tools_text(units, part))
               call add_strength(lines, units, part, job%design)
               if (part%centralizer%present) call add_line(lines, '    '//centralizer_text(units, part%centralizer))
            end associate
         end do
      end associate
   end subroutine add_string

   !> Diameter of a tool that opens, and the depth from which on it is open.
   pure function opening_text(units, part) result(text)
      type(unit_system_type), intent(in) :: units
      type(component_type), intent(in) :: part
      character(:), allocatable :: text
      text = ''
      if (opens(part)) text = ', opens to '//quantity(part%opened_od, units%diameter, unit_label(units, unit_diameter))// &
                              ' below '//quantity(part%opened_below, units%length, unit_label(units, unit_length))
   end function opening_text

   !> The centralizers of a component.
   pure function centralizer_text(units, centralizer) result(text)
      type(unit_system_type), intent(in) :: units
      type(centralizer_type), intent(in) :: centralizer
      character(:), allocatable :: text
      text = either('bow springs', 'rigid centralizers', centralizer%bow)//', od '// &
             quantity(centralizer%od, units%diameter, unit_label(units, unit_diameter))//', every '// &
             quantity(centralizer%spacing, units%length, unit_label(units, unit_length))//' from '// &
             quantity(centralizer%first, units%length, unit_label(units, unit_length))// &
             optional(', restoring ', centralizer%restoring_force, units%force, unit_label(units, unit_force))// &
             optional(', running ', centralizer%running_force, units%force, unit_label(units, unit_force))// &
             friction_text(' axial ', centralizer%friction_axial, 1.0_wp)// &
             friction_text(' rotary ', centralizer%friction_rotary, 1.0_wp)
   end function centralizer_text

   !> Friction of a component, axial or rotary. Empty if it has the friction of the hole.
   pure function friction_text(way, own, scale) result(text)
      character(*), intent(in) :: way
      real(wp), intent(in) :: own, scale    !< missing: none; one: none [-]
      character(:), allocatable :: text
      text = ''
      if (.not. is_missing(own)) then
         text = ', friction'//way//to_text(own, digits)
      else if (abs(scale - 1.0_wp) > 0.0_wp) then
         text = ', friction'//way//to_text(scale, digits)//' of the hole''s'
      end if
   end function friction_text

   !> Strengths of a component, where any is known, each against one load alone and without design factors.
   pure subroutine add_strength(lines, units, part, design)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(component_type), intent(in) :: part
      type(design_factors_type), intent(in) :: design
      character(:), allocatable :: text
      text = ''
      if (part%yield > 0.0_wp) then
         text = ', tension '//quantity(tensile_strength(part), units%force, unit_label(units, unit_force))//', torsion '// &
            quantity(torsional_strength(part), units%moment, unit_label(units, unit_moment))//', burst '// &
            quantity(burst_strength(part), unit_factor(units, unit_pressure), unit_label(units, unit_pressure))
         if (collapses_as_steel(part)) text = text//', collapse '// &
            quantity(collapse_strength(part, 0.0_wp), unit_factor(units, unit_pressure), unit_label(units, unit_pressure))
         if (design%slip_length > 0.0_wp) text = text//', in slips '//quantity(tensile_strength(part)* &
            slip_share(worn_od(part), design%slip_lateral, design%slip_length), units%force, unit_label(units, unit_force))
      end if
      text = text//optional(', connection ', part%joint_torsion, units%moment, unit_label(units, unit_moment))
      if (text == '') return
      text = ':'//text(2:)
      if (is_worn(part)) text = ' with '//to_text(100.0_wp*part%wall_left, digits)//' % of the wall'//text
      call add_line(lines, '    strength'//text)
   end subroutine add_strength

   !> One load case.
   pure subroutine add_case(lines, units, model, number)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      integer, intent(in) :: number
      character(:), allocatable :: reference
      reference = ''
      if (model%cases(number)%length_reference > 0) &
         reference = ', length against '//model%cases(model%cases(number)%length_reference)%name
      associate (case => model%cases(number))
         call add_line(lines, '  '//case%name//': '//trim(operation_name(case%operation))//' at '// &
            quantity(case%bit_depth, units%length, unit_label(units, unit_length))//', string '//case%string// &
            optional(', wob ', case%wob, units%force, unit_label(units, unit_force))// &
            optional(', tob ', case%tob, units%moment, unit_label(units, unit_moment))// &
            optional(', toolface ', case%toolface, units%angle, unit_label(units, unit_angle))// &
            given_text(', friction axial ', case%friction_axial, 1.0_wp, '')// &
            given_text(', friction rotary ', case%friction_rotary, 1.0_wp, '')// &
            optional(', pump pressure ', case%pump_pressure, unit_factor(units, unit_pressure), &
                     unit_label(units, unit_pressure))// &
            optional(', annulus pressure ', case%annulus_pressure, unit_factor(units, unit_pressure), &
                     unit_label(units, unit_pressure))// &
            given_text(', density inside ', case%inside_density, units%density, unit_label(units, unit_density))// &
            optional(', warmer at top by ', case%temperature_change_top, unit_factor(units, unit_temperature), &
                     unit_label(units, unit_temperature))// &
            optional(', at bit by ', case%temperature_change_bottom, unit_factor(units, unit_temperature), &
                     unit_label(units, unit_temperature))// &
            optional(', above ambient at top by ', case%above_ambient_top, unit_factor(units, unit_temperature), &
                     unit_label(units, unit_temperature))// &
            optional(', above ambient at bit by ', case%above_ambient_bottom, unit_factor(units, unit_temperature), &
                     unit_label(units, unit_temperature))// &
            optional(', ', case%angular_speed, unit_factor(units, unit_rotation), unit_label(units, unit_rotation))// &
            optional(' for ', case%hours, 1.0_wp, 'h')// &
            optional(', ', case%trip_speed, unit_factor(units, unit_speed), unit_label(units, unit_speed))// &
            given_text(', measured ', case%measured_hookload, units%force, unit_label(units, unit_force))// &
            given_text(' and ', case%measured_torque, units%moment, unit_label(units, unit_moment))// &
            given_text(', reference ', case%reference_hookload, units%force, unit_label(units, unit_force))//reference)
      end associate
   end subroutine add_case

   !> Hold of a string by a packer. Empty where the packer lets it move.
   pure function hold_text(hold) result(text)
      integer, intent(in) :: hold
      character(:), allocatable :: text
      text = ''
      if (hold /= hold_free) text = ', '//trim(packer_hold_name(hold))
   end function hold_text

   !> Settings of the solver.
   pure subroutine add_numerics(lines, units, numerics)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(numerics_type), intent(in) :: numerics
      character(:), allocatable :: location, joints
      location = 'extremum'
      if (numerics%gap_location == gap_at_nodes) location = 'nodes'
      joints = ''
      if (numerics%discrete_joints) joints = ', tool joints one by one'
      if (numerics%wall_climb) joints = joints//', soft strings climb the wall'
      call add_line(lines, 'solver      elements to '// &
         quantity(numerics%element_length, units%length, unit_label(units, unit_length))//', gaps at '//location//joints// &
         ', tolerance '//to_text(numerics%tolerance, digits)//', iterations to '//to_text(numerics%max_iterations)// &
         ', load steps '//to_text(numerics%load_steps))
      call add_line(lines, '            gk_min '//quantity(numerics%gk_min, units%wall_stiffness, '')//', gk_contact '// &
         quantity(numerics%gk_contact, units%wall_stiffness, '')//', gk_max '// &
         quantity(numerics%gk_max, units%wall_stiffness, unit_label(units, unit_wall))//', eps_n0 '// &
         to_text(numerics%eps_n0, digits)//', eps_nmax '//to_text(numerics%eps_nmax, digits)//', r_n0 '// &
         quantity(numerics%r_n0, units%force, unit_label(units, unit_force)))
   end subroutine add_numerics

   !> An SI value in the deck's unit with its label.
   pure function quantity(value, unit, label) result(text)
      real(wp), intent(in) :: value
      real(wp), intent(in) :: unit       !< SI value of the deck's unit
      character(*), intent(in) :: label
      character(:), allocatable :: text
      real(wp), parameter :: round_off = 1.0e-9_wp ! round-off of metres and other units
      real(wp) :: shown
      shown = value
      if (abs(value) < round_off*unit .and. label /= '') shown = 0.0_wp
      text = trim(to_text(shown/unit, digits)//' '//label)
   end function quantity

   !> `head` and a quantity, or nothing where it is zero.
   pure function optional(head, value, unit, label) result(text)
      character(*), intent(in) :: head
      real(wp), intent(in) :: value, unit
      character(*), intent(in) :: label
      character(:), allocatable :: text
      text = ''
      if (abs(value) > 0.0_wp) text = head//quantity(value, unit, label)
   end function optional

   !> `head` and a quantity, or nothing where it is not given.
   pure function given_text(head, number, unit, label) result(text)
      character(*), intent(in) :: head
      type(optional_real), intent(in) :: number
      real(wp), intent(in) :: unit
      character(*), intent(in) :: label
      character(:), allocatable :: text
      text = ''
      if (number%present) text = head//quantity(number%value, unit, label)
   end function given_text

   !> A range of depths.
   pure function span(top, bottom, units) result(text)
      real(wp), intent(in) :: top, bottom
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      text = quantity(top, units%length, '')//' to '//quantity(bottom, units%length, unit_label(units, unit_length))
   end function span

   !> A lateral support in words.
   pure function lateral(centred) result(text)
      logical, intent(in) :: centred
      character(:), allocatable :: text
      text = 'free'
      if (centred) text = 'centred'
   end function lateral
end module dg_deck_echo
