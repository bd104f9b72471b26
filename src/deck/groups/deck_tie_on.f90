!> Tie-on of a survey that begins below surface. The hole above its first station is vertical, or vertical down to a kick-off
!> with one arc from there, or straight.
module dg_deck_tie_on
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, real_of, text_of
   use dg_constants, only: degree
   use dg_deck_draft, only: draft_type
   use dg_error, only: error_list_type
   use dg_shown_size, only: depth_words
   use dg_survey_check, only: at_surface, begins_below, begins_vertical, sharpest_tie
   use dg_text, only: append_text, to_text
   use dg_unit_kind, only: in_units, unit_curvature
   implicit none
   private
   public :: tie_on

   integer, parameter :: few_digits = 4

contains

   !> Add stations, at surface and at the kick-off, to a survey that begins below surface, and note what was added. They are
   !> vertical, or with tie_on = 'straight' have the direction of the first one. Stations of the survey stay. Between the
   !> lowest added one and the first of the survey the hole is the arc of `interpolation`.
   subroutine tie_on(group, draft, faults)
      type(checked_group_type), intent(in) :: group      !< &trajectory
      type(draft_type), intent(inout) :: draft           !< with stations that are without fault
      type(error_list_type), intent(inout) :: faults
      real(wp), allocatable :: added(:)
      real(wp) :: kick_off, inclination
      integer :: i
      logical :: straight
      straight = text_of(group, 'tie_on', 'none') == 'straight'
      kick_off = real_of(group, 'kick_off', 0.0_wp)
      associate (stations => draft%stations)
         if (is_given(group, 'kick_off') .and. is_sound(group, 'kick_off')) then
            if (text_of(group, 'tie_on', 'none') /= 'vertical') then
               call fault("kick_off has no meaning without tie_on = 'vertical'; give both or none")
            else if (kick_off >= stations%md(1)) then
               call fault('kick_off is not above the first station, '//depth_words(draft%units, stations%md(1))// &
                          '; needs a depth above it')
            end if
         end if
         if (.not. draft%has_stations .or. .not. begins_below(stations%md(1))) return
         allocate (added(0))
         added = [0.0_wp]
         if (kick_off > at_surface) added = [0.0_wp, kick_off]
         inclination = merge(stations%inclination(1), 0.0_wp, straight)
         call append_text(draft%path_notes, note())
         stations%md = [added, stations%md]
         stations%inclination = [(inclination, i=1, size(added)), stations%inclination]
         stations%azimuth = [(stations%azimuth(1), i=1, size(added)), stations%azimuth]
         stations%lines = [(stations%lines(1), i=1, size(added)), stations%lines]
      end associate

   contains

      subroutine fault(message)
         character(*), intent(in) :: message
         call group_fault(group, 'kick_off', message, faults)
         draft%has_stations = .false.
      end subroutine fault

      !> Note on the added stations and the turn of the hole there: from vertical to the first station.
      function note() result(text)
         character(:), allocatable :: text
         real(wp) :: length
         associate (stations => draft%stations, units => draft%units)
            length = stations%md(1) - added(size(added))
            text = 'group &trajectory: the survey begins at '//depth_words(draft%units, stations%md(1))//' with '// &
                   to_text(stations%inclination(1)/degree, few_digits)//' deg. The hole is taken as '
            if (straight) then
               text = text//'straight up to surface, in the direction of the first station (a station added there)'
               return
            end if
            text = text//'vertical at surface'
            if (size(added) > 1) text = text//' and down to '//depth_words(draft%units, kick_off)
            if (size(added) > 1) then
               text = text//' (stations added at both)'
            else
               text = text//' (a station added there)'
            end if
            text = text//'. From there to the first station it turns by '// &
                   to_text(stations%inclination(1)/degree, few_digits)//' deg, '// &
                   in_units(units, unit_curvature, stations%inclination(1)/length, few_digits)
            if (begins_vertical(stations%inclination(1)) .or. stations%inclination(1)/length <= sharpest_tie) return
            text = text//'. Warning: holes hardly turn by more than '// &
                   in_units(units, unit_curvature, sharpest_tie, few_digits)// &
                   ', so hook load and torque may be far off. For a sidetrack give parent_file, for a slant well '// &
                   "or a river crossing tie_on = 'straight'"
         end associate
      end function note
   end subroutine tie_on
end module dg_deck_tie_on
