!> Summary of a deck as the program understood it, for the terminal and the page, in the deck's units.
module dg_deck_echo
   use dg_kinds, only: wp
   use dg_component, only: component_type, is_worn, opens, worn_od
   use dg_design_factors, only: design_factors_type
   use dg_fluid, only: collar_name, collar_none
   use dg_hole_section, only: hole_section_type
   use dg_job, only: job_type, model_name
   use dg_line_list, only: add_line, line_list_type, move_lines
   use dg_load_case, only: operation_name
   use dg_centralizer, only: centralizer_type
   use dg_missing, only: is_missing, optional_real
   use dg_model, only: hold_free, model_type, packer_hold_name
   use dg_numerics, only: gap_location_name, numerics_type, smears_all_joints
   use dg_pipe_strength, only: burst_strength, collapse_strength, collapses_as_steel, slip_share, tensile_strength, &
      torsional_strength
   use dg_rig, only: rig_type
   use dg_text, only: either, joined, text_type, to_text
   use dg_tools_text, only: tools_text
   use dg_trajectory, only: position_at, top_md
   use dg_unit_kind, only: unit_angle, unit_density, unit_diameter, unit_factor, unit_force, unit_gravity, unit_label, &
      unit_length, unit_mass, unit_moment, unit_none, unit_pressure, unit_rotation, unit_speed, unit_stress, unit_temperature, &
      unit_wall, unit_wear
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
      integer :: i
      if (job%title /= '') call add_line(list, 'title       '//job%title)
      call add_line(list, 'models      '//joined(model_name(job%models), ', '))
      call add_line(list, 'units       '//trim(job%units%name))
      call add_line(list, 'results in  '//job%output_dir)
      if (model%rig%max_hookload%present) call add_line(list, 'rig         '// &
         shown(job%units, unit_force, model%rig%max_hookload%value)//' of hook load')
      if (model%rig%given) call add_line(list, rig_line(job%units, model%rig))
      call add_hole(list, job%units, model)
      do i = 1, size(model%strings)
         call add_string(list, job, model, i)
      end do
      call add_line(list, 'boundary    top '//either('centred', 'free', model%boundary%top_centred)//', bit '// &
         either('centred', 'free', model%boundary%bit_centred)// &
         optional(job%units, ', packer bore ', unit_diameter, model%boundary%packer_bore)// &
         either('', ', '//trim(packer_hold_name(model%boundary%packer_hold)), model%boundary%packer_hold == hold_free))
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
      call move_lines(list, lines)
   end subroutine echo_lines

   !> Line on the rig between string and weight indicator.
   pure function rig_line(units, rig) result(line)
      type(unit_system_type), intent(in) :: units
      type(rig_type), intent(in) :: rig
      character(:), allocatable :: line
      line = 'rig         block '//shown(units, unit_force, rig%block_weight)
      if (rig%max_torque%present) &
         line = line//', top drive '//shown(units, unit_moment, rig%max_torque%value)
      if (rig%max_push > 0.0_wp) line = line//', push '//shown(units, unit_force, rig%max_push)
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
         call add_line(lines, 'trajectory  '//to_text(n)//' stations to '//number(units, unit_length, path%md(n))//' measured, '// &
            number(units, unit_length, position(3))//' vertical, '//number(units, unit_length, position(1))//' north, '// &
            number(units, unit_length, position(2))//' east ['//unit_label(units, unit_length)//'], inclination up to '// &
            shown(units, unit_angle, maxval(path%inclination)))
      end associate
      do i = 1, size(model%holes)
         associate (hole => model%holes(i))
            call add_line(lines, 'hole        '//hole%name//': '//number(units, unit_length, hole%md_top)//' to '// &
               shown(units, unit_length, hole%md_bottom)//', diameter '// &
               shown(units, unit_diameter, hole%diameter)//', '//hole_friction_text(hole)// &
               optional(units, ', wall ', unit_wall, hole%wall_stiffness)// &
               optional(units, ', mud sheath ', unit_diameter, hole%mud_sheath)// &
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
      if (.not. is_missing(hole%casing_od)) text = ', casing '//shown(units, unit_diameter, hole%casing_od)
      if (.not. is_missing(hole%casing_yield)) text = text//', yield '//shown(units, unit_stress, hole%casing_yield)
      if (.not. is_missing(hole%wear_factor)) text = text//', wear factor '//shown(units, unit_wear, hole%wear_factor)
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
               place = place//', from '//shown(units, unit_length, fluid%above_bit)//' above the bit'
            else if (fluid%md_top > 0.0_wp) then
               place = place//', from '//shown(units, unit_length, fluid%md_top)
            end if
            if (fluid%collar /= collar_none) place = place//', float collar '//trim(collar_name(fluid%collar))
            place = place//optional(units, ', annulus at surface ', unit_pressure, fluid%surface_pressure)
            call add_line(lines, 'fluid       '//shown(units, unit_density, fluid%density)//place)
         end associate
      end do
      lines%lines(lines%count)%text = lines%lines(lines%count)%text//', gravity '//shown(units, unit_gravity, model%gravity)
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
      character(:), allocatable :: length
      associate (string => model%strings(number), units => job%units)
         if (deepest_bit(model, string) > top_md(model%trajectory)) &
            call find_clearances(model, string, deepest_bit(model, string), clearances, places)
         call add_line(lines, 'string      '//string%name//', from the bit upwards')
         do i = 1, size(string%components)
            associate (part => string%components(i))
               length = 'to surface'
               if (part%length > 0.0_wp) length = shown(units, unit_length, part%length)
               call add_line(lines, '  '//part%name//' ('//part%kind//'): '//length//', od '// &
                  shown(units, unit_diameter, part%od)//', id '//shown(units, unit_diameter, part%id)//', '// &
                  shown(units, unit_mass, part%mass)//', density '//shown(units, unit_density, part%density)// &
                  optional(units, ', joints ', unit_diameter, part%joint_od)// &
                  given_text(units, ', clearance ', unit_diameter, clearances(i))//opening_text(units, part)// &
                  optional(units, ', yield ', unit_stress, part%yield)// &
                  optional(units, ', make-up ', unit_moment, part%makeup_torque)// &
                  friction_text(' axial ', part%friction_axial, part%scale_axial)// &
                  friction_text(' rotary ', part%friction_rotary, part%scale_rotary)// &
                  tools_text(units, part))
               call add_strength(lines, units, part, model%design)
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
      if (opens(part)) text = ', opens to '//shown(units, unit_diameter, part%opened_od)// &
                              ' below '//shown(units, unit_length, part%opened_below)
   end function opening_text

   !> The centralizers of a component.
   pure function centralizer_text(units, centralizer) result(text)
      type(unit_system_type), intent(in) :: units
      type(centralizer_type), intent(in) :: centralizer
      character(:), allocatable :: text
      text = either('bow springs', 'rigid centralizers', centralizer%bow)//', od '// &
             shown(units, unit_diameter, centralizer%od)//', every '//shown(units, unit_length, centralizer%spacing)// &
             ' from '//shown(units, unit_length, centralizer%first)// &
             optional(units, ', restoring ', unit_force, centralizer%restoring_force)// &
             optional(units, ', running ', unit_force, centralizer%running_force)// &
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
         text = ', tension '//shown(units, unit_force, tensile_strength(part))//', torsion '// &
            shown(units, unit_moment, torsional_strength(part))//', burst '// &
            shown(units, unit_pressure, burst_strength(part))
         if (collapses_as_steel(part)) &
            text = text//', collapse '//shown(units, unit_pressure, collapse_strength(part, 0.0_wp))
         if (design%slip_length > 0.0_wp) text = text//', in slips '//shown(units, unit_force, tensile_strength(part)* &
            slip_share(worn_od(part), design%slip_lateral, design%slip_length))
      end if
      text = text//optional(units, ', connection ', unit_moment, part%joint_torsion)
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
            shown(units, unit_length, case%bit_depth)//', string '//case%string// &
            optional(units, ', wob ', unit_force, case%wob)// &
            optional(units, ', tob ', unit_moment, case%tob)// &
            optional(units, ', toolface ', unit_angle, case%toolface)// &
            given_text(units, ', friction axial ', unit_none, case%friction_axial)// &
            given_text(units, ', friction rotary ', unit_none, case%friction_rotary)// &
            optional(units, ', pump pressure ', unit_pressure, case%pump_pressure)// &
            optional(units, ', annulus pressure ', unit_pressure, case%annulus_pressure)// &
            given_text(units, ', density inside ', unit_density, case%inside_density)// &
            change('top', case%temperature_change_top)//change('bit', case%temperature_change_bottom)// &
            optional(units, ', above ambient at top by ', unit_temperature, case%above_ambient_top)// &
            optional(units, ', above ambient at bit by ', unit_temperature, case%above_ambient_bottom)// &
            optional(units, ', ', unit_rotation, case%angular_speed)// &
            either(' for '//to_text(case%hours, digits)//' h', '', case%hours > 0.0_wp)// &
            optional(units, ', ', unit_speed, case%trip_speed)// &
            given_text(units, ', measured ', unit_force, case%measured_hookload)// &
            given_text(units, ' and ', unit_moment, case%measured_torque)// &
            given_text(units, ', reference ', unit_force, case%reference_hookload)//reference)
      end associate
   contains
      !> Change of temperature of an end of the string; '' for none.
      pure function change(place, value) result(text)
         character(*), intent(in) :: place
         real(wp), intent(in) :: value      !< [K]
         character(:), allocatable :: text
         text = optional(units, either(', cooler', ', warmer', value < 0.0_wp)//' at '//place//' by ', unit_temperature, abs(value))
      end function change
   end subroutine add_case

   !> Settings of the solver.
   pure subroutine add_numerics(lines, units, numerics)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(numerics_type), intent(in) :: numerics
      character(:), allocatable :: joints
      joints = ''
      if (numerics%discrete_joints) joints = ', tool joints one by one'
      if (smears_all_joints(numerics)) joints = ', tool joints smeared'
      if (numerics%wall_climb) joints = joints//', soft strings climb the wall'
      call add_line(lines, 'solver      elements to '// &
         shown(units, unit_length, numerics%element_length)//', gaps at '// &
         trim(gap_location_name(numerics%gap_location))//joints// &
         ', tolerance '//to_text(numerics%tolerance, digits)//', iterations to '//to_text(numerics%max_iterations)// &
         ', load steps '//to_text(numerics%load_steps))
      call add_line(lines, '            gk_min '//number(units, unit_wall, numerics%gk_min)//', gk_contact '// &
         number(units, unit_wall, numerics%gk_contact)//', gk_max '//shown(units, unit_wall, numerics%gk_max)//', eps_n0 '// &
         to_text(numerics%eps_n0, digits)//', eps_nmax '//to_text(numerics%eps_nmax, digits)//', r_n0 '// &
         shown(units, unit_force, numerics%r_n0))
   end subroutine add_numerics

   !> Value in a deck's unit, without its name. Round-off of metres and other units is 0.
   pure function number(units, unit, value) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      real(wp), intent(in) :: value      !< [SI]
      character(:), allocatable :: text
      real(wp), parameter :: round_off = 1.0e-9_wp
      text = '0'
      if (unit == unit_none .or. abs(value) >= round_off*unit_factor(units, unit)) &
         text = to_text(value/unit_factor(units, unit), digits)
   end function number

   !> Value in a deck's unit, with the unit's name.
   pure function shown(units, unit, value) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: unit
      real(wp), intent(in) :: value      !< [SI]
      character(:), allocatable :: text
      text = trim(number(units, unit, value)//' '//unit_label(units, unit))
   end function shown

   !> Value behind `head`; '' for zero.
   pure function optional(units, head, unit, value) result(text)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: head
      integer, intent(in) :: unit
      real(wp), intent(in) :: value      !< [SI]
      character(:), allocatable :: text
      text = given_text(units, head, unit, optional_real(abs(value) > 0.0_wp, value))
   end function optional

   !> Value behind `head`; '' where it is absent.
   pure function given_text(units, head, unit, value) result(text)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: head
      integer, intent(in) :: unit
      type(optional_real), intent(in) :: value     !< [SI]
      character(:), allocatable :: text
      text = ''
      if (value%present) text = head//shown(units, unit, value%value)
   end function given_text
end module dg_deck_echo
