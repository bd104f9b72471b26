!> The fluids of a deck: what one group &fluid says, and where its fluid begins.
module dg_deck_fluid
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, is_given, is_sound, line_of, real_of, text_of
   use dg_deck_draft, only: draft_fluid_type, draft_type
   use dg_fault_list, only: add_fault, fault_list_type
   use dg_fluid, only: collar_name, collar_none, fills, fluid_top, fluid_type, mud_type, side_inside, side_outside, standing_mud
   use dg_text, only: to_text
   use dg_trajectory, only: bottom_md, measured_depth_at, trajectory_type
   implicit none
   private
   public :: draft_fluid, place_fluids

   integer, parameter :: depth_digits = 9
   integer, parameter :: sides(2) = [side_inside, side_outside]

contains

   !> One fluid, with the checks that concern its group alone.
   subroutine draft_fluid(path, group, item, faults)
      character(*), intent(in) :: path
      type(checked_group_type), intent(in) :: group
      type(draft_fluid_type), intent(out) :: item
      type(fault_list_type), intent(inout) :: faults
      item%line = group%line
      item%line_tvd = line_of(group, 'tvd_top')
      item%line_density = line_of(group, 'density')
      item%has_tvd = is_given(group, 'tvd_top') .and. is_sound(group, 'tvd_top')
      item%tvd_top = real_of(group, 'tvd_top', 0.0_wp)
      associate (fluid => item%fluid)
         fluid%density = real_of(group, 'density', 0.0_wp)
         fluid%md_top = real_of(group, 'md_top', 0.0_wp)
         fluid%above_bit = real_of(group, 'above_bit', 0.0_wp)
         fluid%inside = text_of(group, 'where', 'both') /= 'outside'
         fluid%outside = text_of(group, 'where', 'both') /= 'inside'
         if (is_sound(group, 'float_collar')) &
            fluid%collar = findloc(collar_name == text_of(group, 'float_collar', collar_name(collar_none)), .true., dim=1)
         if (count([is_given(group, 'md_top'), is_given(group, 'tvd_top'), is_given(group, 'above_bit')]) > 1) &
            call fault(group%line, 'md_top, tvd_top and above_bit all say where the fluid begins; keep one')
         if (fluid%above_bit > 0.0_wp .and. fluid%outside) &
            call fault(line_of(group, 'above_bit'), 'above_bit is a place of the string; it needs where = ''inside''')
         if (fluid%collar /= collar_none .and. .not. is_given(group, 'above_bit')) &
            call fault(line_of(group, 'float_collar'), 'a float_collar is a part of the string; it needs above_bit, '// &
                       'its distance from the bit')
      end associate
   contains
      subroutine fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, path, line, 'group &fluid: '//message)
      end subroutine fault
   end subroutine draft_fluid

   !> The fluids of the model; air where the deck has none. Faults: a true vertical depth that the hole does not reach, a fluid
   !> that another hides.
   subroutine place_fluids(draft, trajectory, mud, faults)
      type(draft_type), intent(in) :: draft
      type(trajectory_type), intent(in) :: trajectory
      type(mud_type), intent(out) :: mud
      type(fault_list_type), intent(inout) :: faults
      integer :: i, hider
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
                        to_text(draft%fluids(i)%tvd_top/draft%units%length, depth_digits)//' '// &
                        trim(draft%units%length_label)//' is deeper than the hole; leave this fluid out')
      end do
      do i = 1, size(mud%fluids)
         hider = hidden_by(i)
         if (hider == 0) cycle
         call add_fault(faults, draft%path, draft%fluids(i)%line, 'group &fluid: the fluid in line '// &
                        to_text(draft%fluids(hider)%line)//' takes all of its place; list fluids of a side from the top down, '// &
                        'each with the md_top, tvd_top or above_bit where it begins')
      end do
   contains
      !> The last of those fluids listed later, none of them beginning deeper, that fill every side that a fluid fills; 0 where a
      !> side is left.
      pure function hidden_by(number) result(hider)
         integer, intent(in) :: number
         integer :: hider
         integer :: other
         logical :: left(size(sides))
         hider = 0
         left = fills(mud%fluids(number), sides)
         do other = number + 1, size(mud%fluids)
            if (begins_deeper(mud%fluids(other), mud%fluids(number))) cycle
            if (.not. any(left .and. fills(mud%fluids(other), sides))) cycle
            left = left .and. .not. fills(mud%fluids(other), sides)
            hider = other
         end do
         if (any(left)) hider = 0
      end function hidden_by

      !> Whether a fluid begins deeper than the one listed before it. Of one that begins at a depth and one that moves with the
      !> string: a moving one comes in deeper; of a moving one before it, at the lowest place of the bit.
      pure function begins_deeper(later, earlier) result(yes)
         type(fluid_type), intent(in) :: later, earlier
         logical :: yes
         if (later%above_bit > 0.0_wp) then
            yes = later%above_bit < earlier%above_bit .or. .not. earlier%above_bit > 0.0_wp
         else
            yes = later%md_top > fluid_top(earlier, bottom_md(trajectory))
         end if
      end function begins_deeper
   end subroutine place_fluids
end module dg_deck_fluid
