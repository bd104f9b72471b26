!> Rows of a profile: one at each depth of a solution, two where a component, hole section or fluid changes there.
!>
!> Only this module doubles rows. Methods that know a quantity on both sides of a change first find the rows (`lay_rows`) and
!> fill them. For the others the rows are doubled afterwards (`part_rows`). Data of a side are read in the middle of the piece
!> between two rows. No piece contains a change, and a change that was joined with a neighbour's depth is found too.
module dg_profile_rows
   use dg_kinds, only: wp
   use dg_drillstring, only: component_at, component_tops
   use dg_fluid, only: fluid_at, side_inside, side_outside
   use dg_hole_section, only: hole_section_at
   use dg_model, only: model_type, string_index
   use dg_profile, only: profile_type, side_above, side_below, side_none, taken_rows
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: lay_rows, part_rows

contains

   !> Find the rows for the depths of a solution: the depth of each row, and its side. Depths that are given twice keep their
   !> two rows.
   pure subroutine lay_rows(model, case_index, md, from, side)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)                     !< from the top of the string to the bit, not decreasing [m]
      integer, allocatable, intent(out) :: from(:)      !< numbers of the depths, one a row
      integer, allocatable, intent(out) :: side(:)      !< of each row, see dg_profile
      integer :: rows(2*size(md)), sides(2*size(md)), upper(4), lower(4), i, n
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, next
      logical :: first, changes
      bit = model%cases(case_index)%bit_depth
      allocate (tops, source=component_tops(model%strings(string_index(model%strings, model%cases(case_index)%string)), &
                                            bit - top_md(model%trajectory)))
      n = 0
      first = .true.
      do i = 1, size(md)
         n = n + 1
         rows(n) = i
         sides(n) = side_none
         if (i > 1 .and. .not. md(i) > md(max(i - 1, 1))) sides(n) = side_below
         if (i == size(md)) exit
         next = md(min(i + 1, size(md)))
         if (.not. next > md(i)) then
            sides(n) = side_above
            cycle
         end if
         lower = found_at(model, tops, bit, 0.5_wp*(md(i) + next))
         changes = .not. first .and. sides(n) == side_none
         if (changes) changes = any(lower /= upper)
         if (changes) then
            rows(n + 1) = i
            sides(n:n + 1) = [side_above, side_below]
            n = n + 1
         end if
         upper = lower
         first = .false.
      end do
      from = rows(:n)
      side = sides(:n)
   end subroutine lay_rows

   !> Double the rows of a profile where something changes. Both sides have the values of the one row. This is for quantities
   !> that do not jump, or that are means over both sides.
   pure subroutine part_rows(model, case_index, profile)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(profile_type), intent(inout) :: profile
      integer, allocatable :: from(:), side(:)
      call lay_rows(model, case_index, profile%md, from, side)
      profile = taken_rows(profile, from)
      profile%side = side
   end subroutine part_rows

   !> Numbers of the component, the hole section and the fluids outside and inside at a depth.
   pure function found_at(model, tops, bit, md) result(numbers)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: tops(:)    !< from component_tops [m]
      real(wp), intent(in) :: bit, md    !< [m]
      integer :: numbers(4)
      numbers = [component_at(tops, bit - md), hole_section_at(model%holes, md), &
                 fluid_at(model%mud, side_outside, md, bit), fluid_at(model%mud, side_inside, md, bit)]
   end function found_at
end module dg_profile_rows
