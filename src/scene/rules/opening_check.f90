!> Checks of tools that open: the depth below which they are open, and whether they pass the hole from there.
module dg_opening_check
   use dg_component, only: closed_diameter, component_type, opens
   use dg_hole_check, only: depth_round_off
   use dg_hole_section, only: hole_section_type, last_shoe
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_error, only: add_part_fault, error_list_type
   use dg_shown_size, only: depth_words, diameter_digits, diameter_words
   use dg_text, only: quoted
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: set_opened_depth, check_open_passage, opening_advice

   !> Longest way up from a tool to the opened section that was meant to reach it [m]. A reamer may stand as far above the bit.
   real(wp), parameter :: longest_pilot = 100.0_wp

contains

   !> Set the default depth of a tool that opens: the lower end of the last cased section.
   subroutine set_opened_depth(component, place, holes, found)
      type(component_type), intent(inout) :: component
      integer, intent(in) :: place                     !< of the component
      type(hole_section_type), intent(in) :: holes(:)  !< from the top down
      type(error_list_type), intent(inout) :: found
      if (.not. opens(component)) return
      if (is_missing(component%opened_below)) component%opened_below = last_shoe(holes)
      if (is_missing(component%opened_below)) call add_part_fault(found, 'component', place, 'opened_od', quoted(component%name)// &
         ' has opened_od and no depth from which on it is open; give opened_below, or cased = .true. in the hole sections that '// &
         'are cased')
   end subroutine set_opened_depth

   !> Check that an open tool is no wider than each hole section between the depth where it opened and its place. It may be as
   !> wide: under-reamers cut their hole, packers fill it.
   subroutine check_open_passage(component, place, holes, lower_end, whose, units, found)
      type(component_type), intent(in) :: component       !< an open component
      integer, intent(in) :: place
      type(hole_section_type), intent(in) :: holes(:)     !< from the top down
      real(wp), intent(in) :: lower_end                   !< measured depth of the component's lower end [m]
      character(*), intent(in) :: whose                   !< owner of the depth: "case 'up'"
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      character(:), allocatable :: other
      integer :: h
      do h = size(holes), 1, -1
         if (holes(h)%md_top >= lower_end*(1.0_wp - depth_round_off) .or. holes(h)%diameter >= component%opened_od) cycle
         if (holes(h)%md_bottom <= component%opened_below) return
         other = '; needs opened_od <= '//diameter_words(units, holes(h)%diameter, diameter_digits)
         if (holes(h)%md_bottom < lower_end) then
            other = other//' or opened_below >= '//depth_words(units, holes(h)%md_bottom)
         else if (lower_end - holes(h)%md_top < longest_pilot .and. holes(max(h - 1, 1))%diameter >= component%opened_od) then
            ! the opened section ends too high
            other = '; it stands at '//depth_words(units, lower_end - component%length)//' to '//depth_words(units, lower_end)// &
                    ', the section above ends at '//depth_words(units, holes(h)%md_top)//'; lower md_bottom of that section to '// &
                    depth_words(units, lower_end)//', or check opened_od'
         end if
         call add_part_fault(found, 'component', place, 'opened_od', quoted(component%name)//' opened to '// &
                             diameter_words(units, component%opened_od, diameter_digits)//' does not pass the hole of '// &
                             diameter_words(units, holes(h)%diameter, diameter_digits)//' (', 'hole', h, ') in '//whose//other)
         return
      end do
   end subroutine check_open_passage

   !> Advice on a component that is too wide for a section above its own but fits its own: it may be a tool that opens. Empty
   !> if that does not help.
   function opening_advice(component, holes, lowest, units) result(text)
      type(component_type), intent(in) :: component
      type(hole_section_type), intent(in) :: holes(:)     !< from the top down
      integer, intent(in) :: lowest                       !< section of its lower end
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      character(:), allocatable :: key
      integer :: h
      text = ''
      if (opens(component) .or. component%centralizer%present .or. closed_diameter(component) > holes(lowest)%diameter) return
      do h = lowest - 1, 1, -1
         if (closed_diameter(component) < holes(h)%diameter) cycle
         key = 'od'
         if (component%joint_od > component%od) key = 'joint_od'
         text = '. If it is a tool that opens, give its closed diameter as '//key//', opened_od = '// &
                diameter_words(units, closed_diameter(component), diameter_digits)//' and opened_below = '// &
                depth_words(units, holes(h)%md_bottom)
         return
      end do
   end function opening_advice
end module dg_opening_check
