!> Reads &tortuosity and lays it on the stations of the deck.
module dg_deck_tortuosity
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, integer_of, is_given, is_whole, real_of, text_of
   use dg_constants, only: degree
   use dg_deck_draft, only: draft_type
   use dg_error, only: error_list_type, error_type
   use dg_text, only: append_text, either, to_text
   use dg_tortuosity, only: lay_tortuosity, lower_end, tortuosity_type, turning
   use dg_trajectory, only: new_trajectory, trajectory_type
   use dg_unit_kind, only: in_units, unit_curvature, unit_length
   implicit none
   private
   public :: apply_tortuosity

   !> Least number of periods of a section: less is a bend of the plan.
   real(wp), parameter :: least_periods = 2.0_wp
   !> Depth within which a section ends at the last station [m].
   real(wp), parameter :: at_end = 1.0e-6_wp
   integer, parameter :: digits = 9, few_digits = 4

contains

   !> Apply all groups &tortuosity, in the order of the deck, to the stations of the draft. `draft%path_notes` states them, and
   !> the additional turn of the hole.
   subroutine apply_tortuosity(groups, draft, faults)
      type(checked_group_type), intent(in) :: groups(:)
      type(draft_type), intent(inout) :: draft
      type(error_list_type), intent(inout) :: faults
      type(tortuosity_type), allocatable :: sections(:)
      integer, allocatable :: lines(:)
      integer :: i, k, before
      before = faults%noted
      draft%plan = draft%stations
      allocate (sections(0), lines(0))
      do i = 1, size(groups)
         if (groups(i)%name /= 'tortuosity') cycle
         associate (group => groups(i))
            if (is_given(group, 'seed') .and. text_of(group, 'kind', '') == 'sine') &
               call fault('seed', "seed has no meaning with kind = 'sine'; leave it out, or give kind = 'random'")
            if (.not. is_whole(group)) cycle
            if (.not. draft%has_stations) cycle
            sections = [sections, section_of(group)]
            lines = [lines, group%line]
            call check(sections(size(sections)))
         end associate
      end do
      if (size(sections) == 0 .or. faults%noted > before) return
      call lay(sections, lines, draft)

   contains

      subroutine fault(key, message)
         character(*), intent(in) :: key, message
         call group_fault(groups(i), key, message, faults)
      end subroutine fault

      function section_of(group) result(section)
         type(checked_group_type), intent(in) :: group
         type(tortuosity_type) :: section
         section%random = text_of(group, 'kind', '') == 'random'
         section%amplitude = real_of(group, 'amplitude', 0.0_wp)
         section%period = real_of(group, 'period', 0.0_wp)
         section%md_top = real_of(group, 'md_top', 0.0_wp)
         section%md_bottom = real_of(group, 'md_bottom', draft%stations%md(size(draft%stations%md)))
         section%seed = integer_of(group, 'seed', section%seed)
         section%number = size(sections) + 1
      end function section_of

      !> Check that a section is within the survey, has two periods, and overlaps no other.
      subroutine check(section)
         type(tortuosity_type), intent(inout) :: section
         real(wp) :: last
         last = draft%stations%md(size(draft%stations%md))
         if (abs(section%md_bottom - last) <= at_end) section%md_bottom = last
         if (section%md_bottom > last) then
            call fault('md_bottom', 'md_bottom = '//depth(section%md_bottom)//' is below the last station, '//depth(last)// &
                       '; end it there or above')
         else if (section%md_bottom - section%md_top < least_periods*section%period) then
            call fault('period', 'between md_top = '//depth(section%md_top)//' and md_bottom = '//depth(section%md_bottom)// &
                       ' there is no room for two periods of '//depth(section%period)//'; give a longer section '// &
                       'or a shorter period')
         end if
         do k = 1, size(sections) - 1
            if (min(sections(k)%md_bottom, section%md_bottom) <= max(sections(k)%md_top, section%md_top)) cycle
            call fault('md_top', 'overlaps the section in line '//to_text(lines(k))//', '//depth(sections(k)%md_top)//' to '// &
                       depth(sections(k)%md_bottom)//'; part them by md_top and md_bottom')
         end do
      end subroutine check

      function depth(md) result(text)
         real(wp), intent(in) :: md
         character(:), allocatable :: text
         text = in_units(draft%units, unit_length, md, digits)
      end function depth
   end subroutine apply_tortuosity

   !> Apply sections to the stations. A plan without a valid path stays, and building the model gives the reason.
   subroutine lay(sections, lines, draft)
      type(tortuosity_type), intent(in) :: sections(:)
      integer, intent(in) :: lines(:)                !< of their groups
      type(draft_type), intent(inout) :: draft
      type(trajectory_type) :: plan, path
      type(error_type), allocatable :: error
      integer :: i
      associate (stations => draft%stations)
         call new_trajectory(plan, stations%md, stations%inclination, stations%azimuth, draft%interpolation, error)
         if (allocated(error)) return
         do i = 1, size(sections)
            call lay_tortuosity(plan, sections(i), stations%md, stations%inclination, stations%azimuth)
         end do
         draft%tortuous = .true.
         stations%lines = spread(draft%trajectory_line, 1, size(stations%md))
         call new_trajectory(path, stations%md, stations%inclination, stations%azimuth, draft%interpolation, error)
         if (allocated(error)) return
      end associate
      do i = 1, size(sections)
         call append_text(draft%path_notes, note(sections(i), lines(i)))
      end do

   contains

      function note(section, line) result(text)
         type(tortuosity_type), intent(in) :: section
         integer, intent(in) :: line
         character(:), allocatable :: text
         real(wp) :: turns(2), length
         turns = [turning(path, section%md_top, lower_end(section)), turning(plan, section%md_top, lower_end(section))]
         length = lower_end(section) - section%md_top
         associate (units => draft%units)
            text = 'group &tortuosity in line '//to_text(line)//': laid on the path from '// &
                   to_text(section%md_top/units%length, digits)//' to '// &
                   in_units(units, unit_length, lower_end(section), digits)//': '// &
                   either('random changes', 'a sine', section%random)//' of '// &
                   to_text(section%amplitude/degree, few_digits)//' deg every '// &
                   in_units(units, unit_length, section%period, few_digits)
            if (section%random) text = text//', seed '//to_text(section%seed)
            text = text//'. The hole turns there by '//to_text(turns(1)/degree, few_digits)//' deg in all instead of '// &
                   to_text(turns(2)/degree, few_digits)//', in the mean '// &
                   in_units(units, unit_curvature, turns(1)/length, few_digits)//' instead of '// &
                   to_text(turns(2)/length/units%curvature, few_digits)
         end associate
      end function note
   end subroutine lay
end module dg_deck_tortuosity
