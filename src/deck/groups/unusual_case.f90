!> Notes on legal but unusual loads, speeds and temperatures of a load case or a study. Each has one note.
module dg_unusual_case
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, real_of
   use dg_component, only: is_bit, opens
   use dg_deck_draft, only: draft_type, string_use_type
   use dg_hole_section, only: hole_section_at
   use dg_likely_unit, only: mud_question, tonne, tonnes_question, unit_questions
   use dg_load_case, only: block_way, drills, load_case_type, moves_axially, operation_name, operation_rotary_drilling, &
                           operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_model, only: model_type, string_index
   use dg_quantity, only: system_si
   use dg_text, only: append_text, lower_case, quoted, text_type
   use dg_unit_kind, only: at_most, in_units, lightest_oil, unit_density, unit_diameter, unit_factor, unit_force, &
                           unit_moment, unit_pressure, unit_temperature
   use dg_units, only: unit_system_type
   use dg_unusual_component, only: holds_any
   use dg_usual_range, only: is_unusual, note_range, usual_ambient_bottom, usual_ambient_top, usual_annulus, usual_density, &
                             usual_friction, usual_hookload, usual_hours, usual_inside_density, usual_measured, usual_pump, &
                             usual_rpm, usual_rpm_worn, usual_tob, usual_trip_speed, usual_warming_bottom, usual_warming_top, &
                             usual_wob
   implicit none
   private
   public :: air_weight, note_bit_loads, note_case, note_deviations, note_light, note_temperatures, note_use, is_gas, &
             usual_inside

   !> Density of gases over their pressure: nitrogen at 0 degC, methane at 200 degC, air at surface [kg/m3/Pa]. Pressure of air
   !> [Pa].
   real(wp), parameter :: densest_gas = 1.3e-5_wp, thinnest_gas = 4.0e-6_wp, thinnest_air = 1.15e-5_wp, atmosphere = 1.0e5_wp
   !> Numbers that may be meant in sg: less is a light or hot gas, more a gas under pressure.
   real(wp), parameter :: lightest_number = 1.0_wp, largest_number = 2.7_wp
   !> Largest torque on bit, 3 T/(W D) of Pessier & Fear (1992), Quantifying common drilling problems, SPE 24584 [-]. Sharp PDC
   !> bits in soft rock have 2, and reamers and stabilizers add to it. Weight on bit in tonnes read as kN makes it ten times
   !> too large. Then usual weight on bit over diameter, 1 to 7 klbf/in [N/m].
   real(wp), parameter :: most_bit_friction = 4.0_wp, least_load = 0.18e6_wp, most_load = 1.25e6_wp
   !> Weight on bit over diameter that no bit has [N/m].
   real(wp), parameter :: heaviest_load = 2.0e6_wp
   !> Largest usual weight that a string is set down with, over its weight in air [-].
   real(wp), parameter :: most_set_down = 0.2_wp
   !> Least torque in another unit over the most usual one [-].
   real(wp), parameter :: least_tob = 0.03_wp
   !> Words in the kinds and names of tools that cut beside the bit.
   character(*), parameter :: cutters(*) = [character(6) :: 'mill', 'opener', 'reamer']
   !> Least pressure that motor and bit take, and usual pressures while drilling [Pa].
   real(wp), parameter :: least_with_motor = 3.0e6_wp, drilling(2) = [5.0e6_wp, 52.0e6_wp]
   !> Difference of two changes of temperature that must be a slip [K].
   real(wp), parameter :: other_change = 30.0_wp
   integer, parameter :: digits = 4, few_digits = 2

contains

   !> Adds a note for each matter of a load case.
   subroutine note_case(units, what, load_case, has_tob, weight, notes)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: what        !< the case, by name
      type(load_case_type), intent(in) :: load_case
      logical, intent(in) :: has_tob          !< the deck gives it, be it 0
      real(wp), intent(in) :: weight          !< of the string in air [N]
      type(text_type), allocatable, intent(inout) :: notes(:)
      if (drills(load_case%operation) .or. .not. is_set_down(load_case%wob, weight)) call note(usual_wob, load_case%wob)
      call note(usual_tob, load_case%tob)
      if (load_case%angular_speed > 0.0_wp) &
         call note(merge(usual_rpm_worn, usual_rpm, load_case%hours > 0.0_wp), load_case%angular_speed)
      call note(usual_hours, load_case%hours)
      call note(usual_trip_speed, load_case%trip_speed)
      call note_ways(units, what, load_case%operation, load_case%wob, load_case%tob, notes)
      if (load_case%wob > 0.0_wp .and. (block_way(load_case%operation) > 0 .or. &
                                        load_case%operation == operation_rotate_off_bottom)) &
         call append_text(notes, what//': wob = '//in_units(units, unit_force, load_case%wob, digits)// &
                          ' pushes the bit in '//trim(operation_name(load_case%operation))//'. An overpull is a wob below 0')
      if (load_case%operation == operation_rotary_drilling .and. load_case%wob > 0.0_wp .and. .not. has_tob .and. &
          .not. load_case%measured_hookload%present) &
         call append_text(notes, what//' drills without tob, the torque on bit. Torque at surface lacks it. Give tob')
      if (load_case%operation == operation_rotary_drilling .and. .not. abs(load_case%wob) > 0.0_wp .and. &
          .not. (load_case%tob > 0.0_wp .or. load_case%measured_hookload%present)) &
         call append_text(notes, what//' drills without wob and tob. Give both, or '// &
                                                         trim(operation_name(operation_rotate_off_bottom)))
      if (load_case%measured_torque%present) call note(usual_measured, load_case%measured_torque%value)
      if (load_case%pump_pressure > 0.0_wp) call note(usual_pump, load_case%pump_pressure)
      call note(usual_annulus, load_case%annulus_pressure)
      if (load_case%friction_axial%present) then
         if (load_case%friction_axial%value > 0.0_wp) then
            call note(usual_friction, load_case%friction_axial%value)
         else if (moves_axially(load_case%operation)) then
            call append_text(notes, what//': axial friction is 0, so that there is no drag. Leave it out for that of &hole')
         end if
      end if
      if (load_case%inside_density%present) then
         call note(usual_inside_density, load_case%inside_density%value)
         call note_light(units, what//': inside_density', load_case%inside_density%value, &
                         max(load_case%pump_pressure, load_case%annulus_pressure), notes)
      end if
      call note(usual_warming_top, load_case%temperature_change_top)
      call note(usual_warming_bottom, load_case%temperature_change_bottom)
      call note(usual_ambient_top, load_case%above_ambient_top)
      call note(usual_ambient_bottom, load_case%above_ambient_bottom)
   contains
      subroutine note(number, value)
         integer, intent(in) :: number      !< of the range
         real(wp), intent(in) :: value      !< [SI]
         call note_range(units, what, number, value, notes)
      end subroutine note
   end subroutine note_case

   !> The first load case whose temperature differs from that of its reference by another number than its change.
   subroutine note_temperatures(units, cases, notes)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, before
      before = size(notes)
      do i = 1, size(cases)
         if (cases(i)%length_reference == 0 .or. size(notes) > before) cycle
         associate (own => cases(i), other => cases(cases(i)%length_reference))
            call compare('bottom', own%above_ambient_bottom, other%above_ambient_bottom, &
                         own%temperature_change_bottom - other%temperature_change_bottom)
            if (size(notes) == before) call compare('top', own%above_ambient_top, other%above_ambient_top, &
                                                    own%temperature_change_top - other%temperature_change_top)
         end associate
      end do
   contains
      subroutine compare(place, warm, reference, change)
         character(*), intent(in) :: place
         real(wp), intent(in) :: warm, reference, change      !< above ambient, and since the reference [K]
         if (.not. min(warm, reference) > 0.0_wp .or. abs(warm - reference - change) < other_change) return
         call append_text(notes, 'load case '//quoted(cases(i)%name)//': above_ambient_'//place//' differs by '// &
            in_units(units, unit_temperature, warm - reference, digits)//' from that of its length_reference, '// &
            'temperature_change_'//place//' by '//in_units(units, unit_temperature, change, digits)//'. Check both')
      end subroutine compare
   end subroutine note_temperatures

   !> Adds a note on a fluid of one side in kg/m3 that is neither a liquid nor air, if it may be in sg.
   subroutine note_light(units, what, density, pressure, notes)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: what         !< has the density
      real(wp), intent(in) :: density, pressure     !< [kg/m3], of pump, annulus or surface [Pa]
      type(text_type), allocatable, intent(inout) :: notes(:)
      if (units%system /= system_si .or. density < lightest_number .or. density > largest_number) return
      if (is_gas(density, pressure)) return
      call append_text(notes, what//' = '//in_units(units, unit_density, density, digits)//' is neither a liquid nor air'// &
                       mud_question(units, density, digits))
   end subroutine note_light

   !> True for the density of a gas under a pressure above that of the atmosphere.
   elemental function is_gas(density, pressure) result(is)
      real(wp), intent(in) :: density, pressure     !< [kg/m3, Pa]
      logical :: is
      associate (ratio => density/(pressure + atmosphere))
         is = ratio >= merge(thinnest_gas, thinnest_air, pressure > 0.0_wp) .and. ratio <= densest_gas
      end associate
   end function is_gas

   !> The model with mud in place of the fluids inside that have a note already: what else is unusual does not follow from them.
   pure function usual_inside(model) result(usual)
      type(model_type), intent(in) :: model
      type(model_type) :: usual
      integer :: i
      usual = model
      if (.not. allocated(model%mud%fluids)) return
      do i = 1, size(usual%cases)
         associate (inside => usual%cases(i)%inside_density)
            if (inside%present .and. is_unusual(usual_inside_density, inside%value)) &
               inside%value = maxval(model%mud%fluids%density)
         end associate
      end do
   end function usual_inside

   !> Adds notes on the loads of a bit, of the first load case that has them.
   subroutine note_bit_loads(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      call note_weight_on_bit(model, units, notes)
      call note_torque_on_bit(model, units, notes)
      call note_pump(model, units, notes)
   end subroutine note_bit_loads

   !> Note a weight on bit that is too large for the hole, but usual in another unit. Only the first such load case is named.
   subroutine note_weight_on_bit(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: question
      real(wp) :: diameter
      integer :: i
      do i = 1, size(model%cases)
         associate (case => model%cases(i))
            if (.not. drills(case%operation)) cycle
            diameter = model%holes(hole_section_at(model%holes, case%bit_depth))%diameter
            if (case%wob <= heaviest_load*diameter .or. is_unusual(usual_wob, case%wob)) cycle     ! which has a note of its own
            question = unit_questions(units, unit_force, case%wob/units%force, least_load*diameter, most_load*diameter, digits, &
                                      'wob')
            if (question == '') cycle
            call append_text(notes, 'load case '//quoted(case%name)//': wob = '//in_units(units, unit_force, case%wob, digits)// &
               ' is large for a hole of '//in_units(units, unit_diameter, diameter, digits)//'. Usual is at most '// &
               in_units(units, unit_force, at_most(units, unit_force, most_load*diameter, few_digits), few_digits)//question)
            return
         end associate
      end do
   end subroutine note_weight_on_bit

   !> Note a torque on bit that is too large for its weight on bit, or not below the one at surface. Only the first such load
   !> case is named.
   subroutine note_torque_on_bit(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: diameter, usual, in_tonnes       ! weight on bit over diameter [N/m]
      character(:), allocatable :: question
      integer :: i
      do i = 1, size(model%cases)
         associate (case => model%cases(i))
            if (case%operation /= operation_rotary_drilling .or. is_unusual(usual_tob, case%tob)) cycle    ! has a note of its own
            if (case%tob > 0.0_wp .and. case%measured_torque%present) then
               if (case%tob >= case%measured_torque%value) then
                  call append_text(notes, 'load case '//quoted(case%name)//': tob = '// &
                     in_units(units, unit_moment, case%tob, digits)//' is not below measured_torque = '// &
                     in_units(units, unit_moment, case%measured_torque%value, digits)//' at surface, which has the friction of '// &
                     'the string in it. Give the torque of the bit alone')
                  return
               end if
            end if
            if (.not. case%wob > 0.0_wp .or. .not. drills_alone(model, case)) cycle
            diameter = model%holes(hole_section_at(model%holes, case%bit_depth))%diameter
            usual = most_bit_friction*case%wob*diameter/3.0_wp
            in_tonnes = case%wob/units%force*tonne*model%gravity/diameter
            if (case%tob <= usual .or. in_tonnes < least_load) cycle
            question = unit_questions(units, unit_moment, case%tob/unit_factor(units, unit_moment), least_tob*usual, usual, &
                                      digits, 'tob')
            if (in_tonnes <= most_load .and. case%tob <= most_bit_friction*in_tonnes*diameter**2/3.0_wp) &
               question = tonnes_question('wob', units, case%wob, model%gravity, digits)
            call append_text(notes, 'load case '//quoted(case%name)//': tob = '//in_units(units, unit_moment, case%tob, digits)// &
               ' is large for wob = '//in_units(units, unit_force, case%wob, digits)//' in a hole of '// &
               in_units(units, unit_diameter, diameter, digits)//'. Usual is at most '// &
               in_units(units, unit_moment, at_most(units, unit_moment, usual, few_digits), few_digits)// &
               question//'. Is tob the torque at surface? Give that of the bit')
            return
         end associate
      end do
   end subroutine note_torque_on_bit

   !> True if a bit alone drills. Mills and tools that open the hole take more torque for little weight.
   function drills_alone(model, load_case) result(does)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: does
      integer :: i
      associate (parts => model%strings(string_index(model%strings, load_case%string))%components)
         does = is_bit(parts(1)) .or. lower_case(parts(1)%name) == 'bit'
         do i = 1, size(parts)
            if (opens(parts(i)) .or. holds_any(parts(i)%kind//' '//parts(i)%name, cutters)) does = .false.
         end do
      end associate
   end function drills_alone

   !> Pump pressure that is too low to drill with a motor, but usual in another unit. Air takes less. Only the first such load
   !> case is named.
   subroutine note_pump(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: question
      integer :: i, k
      if (.not. allocated(model%mud%fluids)) return
      if (any(model%mud%fluids%density < lightest_oil)) return
      do i = 1, size(model%cases)
         associate (case => model%cases(i), pressure => model%cases(i)%pump_pressure, &
                    parts => model%strings(string_index(model%strings, model%cases(i)%string))%components)
            if (.not. drills(case%operation)) cycle
            if (.not. pressure > 0.0_wp .or. pressure >= least_with_motor .or. is_unusual(usual_pump, pressure)) cycle
            if (case%inside_density%present) then
               if (case%inside_density%value < lightest_oil) cycle
            end if
            question = unit_questions(units, unit_pressure, pressure/unit_factor(units, unit_pressure), drilling(1), drilling(2), &
                                      digits, 'pump_pressure')
            if (question == '') cycle
            do k = 1, size(parts)
               if (.not. holds_any(parts(k)%kind, [character(7) :: 'motor', 'turbine'])) cycle
               call append_text(notes, 'load case '//quoted(case%name)//': pump_pressure = '// &
                  in_units(units, unit_pressure, pressure, digits)//' is too low for '//quoted(parts(k)%name)//' to drill. '// &
                  'Usual is at least '//in_units(units, unit_pressure, least_with_motor, few_digits)//question)
               return
            end do
         end associate
      end do
   end subroutine note_pump

   !> Adds notes on the loads of a study.
   subroutine note_use(units, use, weight, notes)
      type(unit_system_type), intent(in) :: units
      type(string_use_type), intent(in) :: use
      real(wp), intent(in) :: weight          !< of the string in air [N]
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: k
      logical :: drilling
      character(:), allocatable :: what
      what = 'group &'//use%group
      drilling = .true.
      if (allocated(use%operations)) drilling = any(drills(use%operations))
      do k = 1, size(use%wob)
         if (is_set_down(use%wob(k), weight) .and. .not. drilling) cycle
         call note_range(units, what, usual_wob, use%wob(k), notes)
      end do
      do k = 1, size(use%tob)
         call note_range(units, what, usual_tob, use%tob(k), notes)
      end do
      if (.not. allocated(use%operations)) return
      do k = 1, size(use%operations)
         call note_ways(units, what, use%operations(k), load_of(use%wob, k), load_of(use%tob, k), notes)
      end do
   end subroutine note_use

   !> True for a weight that a string without a bit at work is set down with, on a hanger or a packer.
   elemental function is_set_down(wob, weight) result(is)
      real(wp), intent(in) :: wob, weight      !< at the lower end, and of the string in air [N]
      logical :: is
      is = wob > 0.0_wp .and. wob <= most_set_down*weight
   end function is_set_down

   !> Weight of a string in air, from its bit up to surface [N].
   pure function air_weight(draft, string, bit_depth) result(weight)
      type(draft_type), intent(in) :: draft
      character(*), intent(in) :: string
      real(wp), intent(in) :: bit_depth        !< [m]
      real(wp) :: weight, above, length
      integer :: i
      weight = 0.0_wp
      above = bit_depth
      do i = 1, size(draft%components)
         if (draft%components(i)%string /= string) cycle
         associate (part => draft%components(i)%component)
            length = above
            if (part%length > 0.0_wp) length = min(part%length, above)
            weight = weight + draft%gravity*part%mass*length
            above = above - length
         end associate
      end do
   end function air_weight

   !> Adds notes on the standard deviations of studies.
   subroutine note_deviations(units, groups, notes)
      type(unit_system_type), intent(in) :: units
      type(checked_group_type), intent(in) :: groups(:)
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(*), parameter :: keys(*) = [character(18) :: 'friction_deviation', 'density_deviation', 'hookload_deviation', &
                                            'torque_deviation']
      integer, parameter :: ranges(size(keys)) = [usual_friction, usual_density, usual_hookload, usual_measured]
      integer :: i, k
      do i = 1, size(groups)
         do k = 1, size(keys)
            if (.not. any(groups(i)%values%key == keys(k))) cycle
            call note_range(units, 'group &'//groups(i)%name, ranges(k), real_of(groups(i), trim(keys(k)), 0.0_wp), notes, &
                            deviation=trim(keys(k)))
         end do
      end do
   end subroutine note_deviations

   !> Load of an operation: one for each, one for all or none.
   pure function load_of(loads, k) result(load)
      real(wp), intent(in) :: loads(:)
      integer, intent(in) :: k            !< of the operation
      real(wp) :: load
      load = 0.0_wp
      if (size(loads) > 0) load = loads(min(k, size(loads)))
   end function load_of

   !> A bit that is pulled while it drills, or turned in a trip though nothing holds it: a stuck one is pulled and turned.
   subroutine note_ways(units, what, operation, wob, tob, notes)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: what
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob, tob     !< [N, N.m]
      type(text_type), allocatable, intent(inout) :: notes(:)
      if (wob < 0.0_wp .and. drills(operation)) &
         call append_text(notes, what//': wob = '//in_units(units, unit_force, wob, digits)//' pulls the bit in '// &
                          trim(operation_name(operation))//'. Weight on bit is a wob above 0')
      if (tob > 0.0_wp .and. wob > 0.0_wp .and. operation == operation_trip_in) &
         call append_text(notes, what//': with wob and tob the bit drills, and in '//trim(operation_name(operation))// &
                          ' the string does not turn. Drilling is rotary or sliding')
      if (tob > 0.0_wp .and. .not. abs(wob) > 0.0_wp .and. any(operation == [operation_trip_out, operation_trip_in])) &
         call append_text(notes, what//': tob = '//in_units(units, unit_moment, tob, digits)//' turns the free bit in '// &
                          trim(operation_name(operation))//'. Give tob = 0 there')
   end subroutine note_ways
end module dg_unusual_case
