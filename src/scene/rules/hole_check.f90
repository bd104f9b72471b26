!> Checks of hole sections: each goes down, and together they reach from surface on without a gap.
module dg_hole_check
   use dg_component, only: shortest_contact
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_error, only: add_part_fault, error_list_type
   use dg_shown_size, only: depth_words, diameter_digits, diameter_words, length_digits
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: check_section, join_sections, depth_round_off

   !> Part of a depth that is round-off of a conversion or of a survey table [-].
   real(wp), parameter :: depth_round_off = 1.0e-6_wp
   !> Part of the shortest section that is round-off of two depths [-].
   real(wp), parameter :: part_of_millimetre = 1.0e-3_wp

contains

   !> Check that a section ends below its beginning, by at least the shortest contact.
   subroutine check_section(hole, place, units, found)
      type(hole_section_type), intent(in) :: hole
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      if (.not. hole%md_bottom > hole%md_top) then
         call add_part_fault(found, 'hole', place, 'md_bottom', 'md_bottom = '//depth_words(units, hole%md_bottom)// &
                             ' is not below md_top = '//depth_words(units, hole%md_top))
      else if (hole%md_bottom - hole%md_top < (1.0_wp - part_of_millimetre)*shortest_contact) then
         call add_part_fault(found, 'hole', place, 'md_bottom', 'the section from '//depth_words(units, hole%md_top)//' to '// &
                             depth_words(units, hole%md_bottom)//' is shorter than the shortest contact, '// &
                             diameter_words(units, shortest_contact, length_digits))
      end if
      if (is_missing(hole%casing_od)) then
         if (.not. is_missing(hole%wear_factor)) call add_part_fault(found, 'hole', place, 'wear_factor', 'wear_factor needs '// &
            'casing_od, the outside diameter of the casing that wears')
      else if (.not. hole%casing_od > hole%diameter) then
         call add_part_fault(found, 'hole', place, 'casing_od', 'casing_od = '// &
                             diameter_words(units, hole%casing_od, diameter_digits)//' is not greater than diameter = '// &
                             diameter_words(units, hole%diameter, diameter_digits)//', the inside diameter')
      end if
   end subroutine check_section

   !> Check that sections from the top down begin at surface and abut. Ends that differ by round-off become equal.
   subroutine join_sections(holes, units, found)
      type(hole_section_type), intent(inout) :: holes(:)   !< one at least
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      character(:), allocatable :: gap
      integer :: i
      if (holes(1)%md_top > 0.0_wp) call add_part_fault(found, 'hole', 1, 'md_top', 'the uppermost section begins at '// &
         depth_words(units, holes(1)%md_top)//'; holes must begin at surface, md_top = 0')
      do i = 2, size(holes)
         associate (above => holes(i - 1)%md_bottom, below => holes(i)%md_top)
            if (abs(below - above) <= depth_round_off*above) then
               below = above
            else
               gap = 'an overlap with'
               if (below > above) gap = 'a gap below'
               call add_part_fault(found, 'hole', i, 'md_top', 'md_top = '//depth_words(units, below)//' leaves '//gap// &
                                   ' the section above (', 'hole', i - 1, '), which ends at '//depth_words(units, above)// &
                                   '; sections must abut')
            end if
         end associate
      end do
   end subroutine join_sections
end module dg_hole_check
