!> The fluids of a deck: the data of one group &fluid, and the place where its fluid begins. Remarks say if a string floats,
!> and what must separate pressures at the bit.
module dg_deck_fluid
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, line_of, real_of, text_of
   use dg_deck_check, only: report_faults
   use dg_deck_draft, only: draft_fluid_type, draft_type
   use dg_drillstring, only: component_at, component_tops
   use dg_error, only: add_fault, error_list_type, key_of
   use dg_fluid, only: collar_name, collar_none, fluid_type, mud_type, standing_mud, fluid_tops, collar_closed, side_inside, &
                       side_outside
   use dg_fluid_check, only: check_fluid, check_fluid_order
   use dg_fluid_pressure, only: fluid_column_type, new_fluid_column, pressure_at, weight_at
   use dg_load_case, only: load_case_type
   use dg_model, only: model_type, string_index
   use dg_text, only: append_text, either, quoted, text_type
   use dg_trajectory, only: bottom_md, measured_depth_at, trajectory_type, top_md, true_vertical_depth
   use dg_unit_kind, only: in_units, unit_length, unit_pressure
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: draft_fluid, place_fluids, note_fluids

   integer, parameter :: depth_digits = 9

   !> Difference of pressure at the bit that needs a float valve [Pa]: a gap of air above the mud outside makes less.
   real(wp), parameter :: least_difference = 0.5e6_wp
   !> Pressure of a side without fluid [Pa].
   real(wp), parameter :: no_pressure = 1.0e3_wp
   !> Just above a depth [m].
   real(wp), parameter :: hair = 1.0e-6_wp
   integer, parameter :: digits = 4

contains

   !> One fluid, with the checks that concern its group alone.
   subroutine draft_fluid(group, item, faults)
      type(checked_group_type), intent(in) :: group
      type(draft_fluid_type), intent(out) :: item
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      type(fluid_type) :: begun
      integer :: i
      item%line = group%line
      item%line_tvd = line_of(group, 'tvd_top')
      item%line_density = line_of(group, 'density')
      item%density_given = is_given(group, 'density')
      item%has_tvd = is_given(group, 'tvd_top') .and. is_sound(group, 'tvd_top')
      item%tvd_top = real_of(group, 'tvd_top', 0.0_wp)
      associate (fluid => item%fluid)
         fluid%density = real_of(group, 'density', 0.0_wp)
         fluid%md_top = real_of(group, 'md_top', 0.0_wp)
         fluid%above_bit = real_of(group, 'above_bit', 0.0_wp)
         fluid%surface_pressure = real_of(group, 'surface_pressure', 0.0_wp)
         fluid%inside = text_of(group, 'where', 'both') /= 'outside'
         fluid%outside = text_of(group, 'where', 'both') /= 'inside'
         if (is_sound(group, 'float_collar')) &
            fluid%collar = findloc(collar_name == text_of(group, 'float_collar', collar_name(collar_none)), .true., dim=1)
         if (count([is_given(group, 'md_top'), is_given(group, 'tvd_top'), is_given(group, 'above_bit')]) > 1) &
            call group_fault(group, '', 'md_top, tvd_top and above_bit all say where the fluid begins; keep one', faults)
      end associate
      begun = item%fluid
      if (item%has_tvd) begun%md_top = item%tvd_top      ! at surface or not: the measured depth is not known yet
      call check_fluid(begun, 0, found)
      do i = 1, found%count
         associate (wrong => found%items(i))
            if (key_of(wrong) == 'float_collar' .and. is_given(group, 'above_bit')) cycle     ! reported already
            call group_fault(group, key_of(wrong), wrong%message, faults)
         end associate
      end do
   end subroutine draft_fluid

   !> Make the fluids of the model; air if the deck has none. Faults: a true vertical depth that the hole does not reach, a
   !> fluid that another hides.
   subroutine place_fluids(draft, trajectory, mud, faults)
      type(draft_type), intent(in) :: draft
      type(trajectory_type), intent(in) :: trajectory
      type(mud_type), intent(out) :: mud
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      integer :: i
      mud = standing_mud(0.0_wp)
      if (size(draft%fluids) == 0) return
      deallocate (mud%fluids)
      allocate (mud%fluids(size(draft%fluids)))
      do i = 1, size(draft%fluids)
         mud%fluids(i) = draft%fluids(i)%fluid
         if (.not. draft%fluids(i)%has_tvd) cycle
         mud%fluids(i)%md_top = measured_depth_at(trajectory, draft%fluids(i)%tvd_top)
         if (mud%fluids(i)%md_top <= bottom_md(trajectory)) cycle
         call add_fault(faults, draft%path, draft%fluids(i)%line_tvd, 'group &fluid: tvd_top = '// &
                        in_units(draft%units, unit_length, draft%fluids(i)%tvd_top, depth_digits)// &
                        ' is deeper than the hole; leave this fluid out')
      end do
      call check_fluid_order(mud%fluids, bottom_md(trajectory), found)
      call report_faults(draft, found, faults)
   end subroutine place_fluids

   !> Add one note a matter, with the first load case that has it.
   subroutine note_fluids(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      logical :: held, floats
      if (.not. allocated(model%mud%fluids)) return
      ! the seal of a packer, or a closed float collar, holds the difference
      held = model%boundary%packer_bore > 0.0_wp .or. any(model%mud%fluids%collar == collar_closed)
      floats = .false.
      do i = 1, size(model%cases)
         if (.not. held) call note_bit(i, held)
         if (.not. floats) call note_floating(i, floats)
      end do

   contains

      subroutine note_bit(number, said)
         integer, intent(in) :: number
         logical, intent(out) :: said
         type(fluid_column_type) :: inside, outside
         type(load_case_type) :: still   ! without pump pressure: a closed collar keeps it from the bit
         real(wp) :: within, around, tvd
         still = model%cases(number)
         still%pump_pressure = 0.0_wp
         associate (case => still)
            tvd = true_vertical_depth(model%trajectory, case%bit_depth)
            call new_fluid_column(model, case, side_inside, inside)
            call new_fluid_column(model, case, side_outside, outside)
            within = pressure_at(inside, case%bit_depth, tvd)
            around = pressure_at(outside, case%bit_depth, tvd)
            said = abs(within - around) > least_difference
            if (said) then
               call append_text(notes, 'group &fluid: load case '//quoted(case%name)// &
               ': without pump pressure the fluid inside presses on the bit with '//pressed(within)//', that outside with '// &
               pressed(around)//'; a float valve or plug at the end of the string must hold the difference'// &
                  either('. There is no fluid '//either('inside', 'outside', within < around)// &
                         ". For one on both sides write where = 'both'", '', &
                         min(within, around) < no_pressure .and. .not. case%inside_density%present))
            end if
         end associate
      end subroutine note_bit

      subroutine note_floating(number, said)
         integer, intent(in) :: number
         logical, intent(out) :: said
         real(wp), allocatable :: tops(:), depths(:)
         real(wp) :: bit, md
         integer :: k
         said = .false.
         bit = model%cases(number)%bit_depth
         associate (string => model%strings(string_index(model%strings, model%cases(number)%string)))
            allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
            allocate (depths, source=[bit, bit - tops, fluid_tops(model%mud, bit)])
            do k = 1, size(depths)
               md = depths(k) - hair        ! every piece of one weight ends at one of these depths
               if (md <= top_md(model%trajectory)) cycle
               associate (part => string%components(component_at(tops, bit - md)))
                  said = weight_at(part, model, model%cases(number), md) < 0.0_wp
                  if (said) call append_text(notes, 'group &fluid: load case '//quoted(model%cases(number)%name)//': '// &
                     quoted(part%name)//' floats at '//in_units(units, unit_length, depths(k), digits)// &
                     ': with what is in it it weighs less than the fluid outside that it displaces')
               end associate
               if (said) return
            end do
         end associate
      end subroutine note_floating

      function pressed(pressure) result(text)
         real(wp), intent(in) :: pressure
         character(:), allocatable :: text
         text = in_units(units, unit_pressure, pressure, digits)
      end function pressed
   end subroutine note_fluids
end module dg_deck_fluid
