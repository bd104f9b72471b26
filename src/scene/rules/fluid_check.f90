!> Checks of fluids: where each may begin, and that none is hidden by another.
module dg_fluid_check
   use dg_fluid, only: collar_none, fills, fluid_top, fluid_type, side_inside, side_outside
   use dg_kinds, only: wp
   use dg_error, only: add_part_fault, error_list_type
   implicit none
   private
   public :: check_fluid, check_fluid_order

   integer, parameter :: sides(2) = [side_inside, side_outside]

contains

   !> Check that a fluid which moves with the string is inside it, and that a float collar belongs to such a fluid. The annulus has
   !> a pressure at surface.
   subroutine check_fluid(fluid, place, found)
      type(fluid_type), intent(in) :: fluid
      integer, intent(in) :: place
      type(error_list_type), intent(inout) :: found
      if (fluid%above_bit > 0.0_wp .and. fluid%outside) call add_part_fault(found, 'fluid', place, 'above_bit', &
         'above_bit is a place of the string; it needs where = ''inside''')
      if (fluid%collar /= collar_none .and. .not. fluid%above_bit > 0.0_wp) call add_part_fault(found, 'fluid', place, &
         'float_collar', 'a float_collar is a part of the string; it needs above_bit, its distance from the bit')
      if (fluid%surface_pressure > 0.0_wp .and. (fluid%md_top > 0.0_wp .or. .not. fluid%outside)) call add_part_fault(found, &
         'fluid', place, 'surface_pressure', 'surface_pressure is the pressure of the annulus; give it in the uppermost fluid '// &
         'outside, which begins at surface')
   end subroutine check_fluid

   !> Check that fluids of a side are listed from the top down: none is hidden by later ones.
   subroutine check_fluid_order(fluids, bottom, found)
      type(fluid_type), intent(in) :: fluids(:)
      real(wp), intent(in) :: bottom               !< of the hole: the lowest place of the bit [m]
      type(error_list_type), intent(inout) :: found
      integer :: i, hider
      do i = 1, size(fluids)
         hider = hidden_by(i)
         if (hider == 0) cycle
         call add_part_fault(found, 'fluid', i, '', 'the fluid in ', 'fluid', hider, ' fills its whole length; list fluids '// &
                             'of a side from the top down, each with the md_top, tvd_top or above_bit where it begins')
      end do
   contains
      !> Last of the later fluids that together fill every side of a fluid, none of them beginning deeper; 0 if a side is left.
      pure function hidden_by(number) result(hider)
         integer, intent(in) :: number
         integer :: hider
         integer :: other
         logical :: left(size(sides))
         hider = 0
         left = fills(fluids(number), sides)
         do other = number + 1, size(fluids)
            if (begins_deeper(fluids(other), fluids(number))) cycle
            if (.not. any(left .and. fills(fluids(other), sides))) cycle
            left = left .and. .not. fills(fluids(other), sides)
            hider = other
         end do
         if (any(left)) hider = 0
      end function hidden_by

      !> True if a fluid begins deeper than the one listed before it. A moving one after a fixed one counts as deeper. A fixed
      !> one after a moving one is compared at the lowest place of the bit.
      pure function begins_deeper(later, earlier) result(yes)
         type(fluid_type), intent(in) :: later, earlier
         logical :: yes
         if (later%above_bit > 0.0_wp) then
            yes = later%above_bit < earlier%above_bit .or. .not. earlier%above_bit > 0.0_wp
         else
            yes = later%md_top > fluid_top(earlier, bottom)
         end if
      end function begins_deeper
   end subroutine check_fluid_order
end module dg_fluid_check
