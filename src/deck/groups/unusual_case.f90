!> Notes on legal but unusual loads, speeds and temperatures of a load case or a study. Each has one note.
module dg_unusual_case
   use dg_kinds, only: wp
   use dg_deck_draft, only: string_use_type
   use dg_likely_unit, only: mud_question
   use dg_load_case, only: block_way, load_case_type, moves_axially, operation_name, operation_rotary_drilling, &
                           operation_rotate_off_bottom, operation_sliding_drilling, operation_trip_in, operation_trip_out
   use dg_quantity, only: system_si
   use dg_text, only: append_text, text_type
   use dg_unit_kind, only: in_units, unit_density, unit_force, unit_moment
   use dg_units, only: unit_system_type
   use dg_usual_range, only: note_range, usual_ambient_bottom, usual_ambient_top, usual_density, usual_friction, usual_hours, &
                             usual_measured, usual_pump, usual_rpm, usual_tob, usual_trip_speed, usual_warming_bottom, &
                             usual_warming_top, usual_wob
   implicit none
   private
   public :: note_case, note_light, note_use

   !> Density of gases over their pressure: nitrogen at 0 degC, methane at 200 degC, air at surface [kg/m3/Pa]. Pressure of air
   !> [Pa].
   real(wp), parameter :: densest_gas = 1.3e-5_wp, thinnest_gas = 4.0e-6_wp, thinnest_air = 1.15e-5_wp, atmosphere = 1.0e5_wp
   !> Numbers that may be meant in sg: less is a light or hot gas, more a gas under pressure.
   real(wp), parameter :: lightest_number = 1.0_wp, largest_number = 2.7_wp
   integer, parameter :: digits = 4

contains

   !> Adds a note for each matter of a load case.
   subroutine note_case(units, what, load_case, has_tob, notes)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: what        !< the case, by name
      type(load_case_type), intent(in) :: load_case
      logical, intent(in) :: has_tob          !< the deck gives it, be it 0
      type(text_type), allocatable, intent(inout) :: notes(:)
      call note(usual_wob, load_case%wob)
      call note(usual_tob, load_case%tob)
      if (load_case%angular_speed > 0.0_wp) call note(usual_rpm, load_case%angular_speed)
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
      if (load_case%friction_axial%present) then
         if (load_case%friction_axial%value > 0.0_wp) then
            call note(usual_friction, load_case%friction_axial%value)
         else if (moves_axially(load_case%operation)) then
            call append_text(notes, what//': axial friction is 0, so that there is no drag. Leave it out for that of &hole')
         end if
      end if
      if (load_case%inside_density%present) then
         call note(usual_density, load_case%inside_density%value)
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

   !> Adds a note on a fluid of one side in kg/m3 that is neither a liquid nor air, if it may be in sg.
   subroutine note_light(units, what, density, pressure, notes)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: what         !< has the density
      real(wp), intent(in) :: density, pressure     !< [kg/m3], of pump, annulus or surface [Pa]
      type(text_type), allocatable, intent(inout) :: notes(:)
      if (units%system /= system_si .or. density < lightest_number .or. density > largest_number) return
      associate (ratio => density/(pressure + atmosphere))
         if (ratio >= merge(thinnest_gas, thinnest_air, pressure > 0.0_wp) .and. ratio <= densest_gas) return
      end associate
      call append_text(notes, what//' = '//in_units(units, unit_density, density, digits)//' is neither a liquid nor air'// &
                       mud_question(units, density, digits))
   end subroutine note_light

   !> Adds notes on the loads of a study.
   subroutine note_use(units, use, notes)
      type(unit_system_type), intent(in) :: units
      type(string_use_type), intent(in) :: use
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: k
      character(:), allocatable :: what
      what = 'group &'//use%group
      do k = 1, size(use%wob)
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
      if (wob < 0.0_wp .and. any(operation == [operation_rotary_drilling, operation_sliding_drilling])) &
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
