!> The fluids of a deck: what one group &fluid says, and where its fluid begins.
module dg_deck_fluid
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, line_of, real_of, text_of
   use dg_deck_check, only: tell_faults
   use dg_deck_draft, only: draft_fluid_type, draft_type
   use dg_fault_list, only: add_fault, fault_list_type
   use dg_fluid, only: collar_name, collar_none, fluid_type, mud_type, standing_mud
   use dg_fluid_check, only: check_fluid, check_fluid_order
   use dg_model_fault, only: model_faults_type
   use dg_trajectory, only: bottom_md, measured_depth_at, trajectory_type
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: draft_fluid, place_fluids

   integer, parameter :: depth_digits = 9

contains

   !> One fluid, with the checks that concern its group alone.
   subroutine draft_fluid(group, item, faults)
      type(checked_group_type), intent(in) :: group
      type(draft_fluid_type), intent(out) :: item
      type(fault_list_type), intent(inout) :: faults
      type(model_faults_type) :: found
      type(fluid_type) :: begun
      integer :: i
      item%line = group%line
      item%line_tvd = line_of(group, 'tvd_top')
      item%line_density = line_of(group, 'density')
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
            if (wrong%key == 'float_collar' .and. is_given(group, 'above_bit')) cycle     ! said already
            call group_fault(group, trim(wrong%key), wrong%message, faults)
         end associate
      end do
   end subroutine draft_fluid

   !> The fluids of the model; air where the deck has none. Faults: a true vertical depth that the hole does not reach, a fluid
   !> that another hides.
   subroutine place_fluids(draft, trajectory, mud, faults)
      type(draft_type), intent(in) :: draft
      type(trajectory_type), intent(in) :: trajectory
      type(mud_type), intent(out) :: mud
      type(fault_list_type), intent(inout) :: faults
      type(model_faults_type) :: found
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
                        trim(in_units(draft%units, unit_length, draft%fluids(i)%tvd_top, depth_digits))// &
                        ' is deeper than the hole; leave this fluid out')
      end do
      call check_fluid_order(mud%fluids, bottom_md(trajectory), found)
      call tell_faults(draft, found, faults)
   end subroutine place_fluids
end module dg_deck_fluid
