!> Checks of surveys: stations in order, from surface on or from where the hole is still vertical.
module dg_survey_check
   use dg_constants, only: degree
   use dg_kinds, only: wp
   use dg_error, only: add_part_fault, error_list_type
   use dg_shown_size, only: depth_words
   use dg_range_check, only: check_range, ranges_type, set_ranges
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: check_station_numbers, check_station_order, begins_below, begins_vertical, at_surface, sharpest_tie

   !> Depth within which the first station is at surface [m].
   real(wp), parameter :: at_surface = 1.0e-6_wp
   !> Largest inclination of a first station that counts as vertical: readings of tools in vertical holes [rad].
   real(wp), parameter :: still_vertical = 0.5_wp*degree
   !> Largest plausible curvature of a hole above a first station, 6 deg/30 m [rad/m].
   real(wp), parameter :: sharpest_tie = 6.0_wp*degree/30.0_wp

contains

   !> Check numbers of stations: as many angles as depths, each in its range.
   subroutine check_station_numbers(md, inclination, azimuth, found)
      real(wp), intent(in) :: md(:)                          !< [m]
      real(wp), intent(in) :: inclination(:), azimuth(:)     !< [rad]
      type(error_list_type), intent(inout) :: found
      type(ranges_type) :: ranges
      integer :: i
      if (size(md) < 2) call add_part_fault(found, 'trajectory', 0, 'md', 'md holds '//to_text(size(md))// &
         ' station(s); at least two are needed')
      if (found%count > 0) return
      call count_of('inclination', size(inclination))
      call count_of('azimuth', size(azimuth))
      if (found%count > 0) return
      call set_ranges('trajectory', 0, ranges)
      do i = 1, size(md)
         ranges%place = i
         call check_range(ranges, 'md', md(i), found)
         call check_range(ranges, 'inc', inclination(i), found, 'inclination')
         call check_range(ranges, 'azi', azimuth(i), found, 'azimuth')
         if (found%count > 0) return       ! one such fault leads to many
      end do
   contains
      subroutine count_of(key, number)
         character(*), intent(in) :: key
         integer, intent(in) :: number
         if (number /= size(md)) call add_part_fault(found, 'trajectory', 0, key, key//' has '//to_text(number)//' values, '// &
                                                     'md has '//to_text(size(md))//'; give one for each station')
      end subroutine count_of
   end subroutine check_station_numbers

   !> Check that every station is below the one before it. Only the first fault is reported.
   subroutine check_station_order(md, units, found)
      real(wp), intent(in) :: md(:)          !< [m]
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      integer :: i
      do i = 2, size(md)
         if (md(i) > md(i - 1)) cycle
         call add_part_fault(found, 'trajectory', i, 'md', 'station '//to_text(i)//' at '//depth_words(units, md(i))// &
                             ' is not below station '//to_text(i - 1)//' at '//depth_words(units, md(i - 1))// &
                             '; measured depth must increase')
         return
      end do
   end subroutine check_station_order

   !> True if a survey lacks the hole next to surface.
   elemental function begins_below(md) result(below)
      real(wp), intent(in) :: md             !< of the first station [m]
      logical :: below
      below = md > at_surface
   end function begins_below

   !> True if the hole is vertical at the first station.
   elemental function begins_vertical(inclination) result(vertical)
      real(wp), intent(in) :: inclination    !< there [rad]
      logical :: vertical
      vertical = inclination < still_vertical
   end function begins_vertical
end module dg_survey_check
