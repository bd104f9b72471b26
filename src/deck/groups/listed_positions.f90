!> Positions that a survey file lists beside its stations, against those that follow from the stations.
module dg_listed_positions
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_survey_file, only: station_list_type
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory, position_at, trajectory_type
   use dg_unit_kind, only: in_units, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: position_words

   !> Difference up to which positions are the same: listings are rounded [m].
   real(wp), parameter :: same = 0.01_wp
   !> Difference above which the file was probably misread [m].
   real(wp), parameter :: far = 1.0_wp
   character(*), parameter :: names(3) = [character(5) :: 'TVD', 'north', 'east']
   !> Their places in a position: north, east, down.
   integer, parameter :: axis(3) = [3, 1, 2]
   integer, parameter :: few_digits = 3, depth_digits = 6

contains

   !> Largest difference of TVD, north and east of a file from minimum curvature through its stations. '' where the file lists none
   !> of them. Both count from the first station that has them. `doubtful`: the difference is a warning.
   subroutine position_words(stations, units, words, doubtful)
      type(station_list_type), intent(in) :: stations
      type(unit_system_type), intent(in) :: units
      character(:), allocatable, intent(out) :: words
      logical, intent(out) :: doubtful
      type(trajectory_type) :: path
      type(error_type), allocatable :: error
      real(wp), allocatable :: position(:, :)
      real(wp) :: tangent(3), difference, largest
      integer :: k, i, first, worst, worst_k
      words = ''
      doubtful = .false.
      call new_trajectory(path, stations%md, stations%inclination, stations%azimuth, interpolation_minimum_curvature, error)
      if (allocated(error)) return
      allocate (position(3, size(stations%md)))
      do i = 1, size(stations%md)
         call position_at(path, stations%md(i), position(:, i), tangent)
      end do
      largest = -1.0_wp
      worst = 1
      worst_k = 1
      do k = 1, 3
         if (count(.not. is_missing(stations%listed(k, :))) < 2) cycle
         if (k > 1 .and. .not. stations%has_azimuth) cycle
         if (words /= '') words = words//', '
         words = words//trim(names(k))
         first = 0
         do i = 1, size(stations%md)
            if (is_missing(stations%listed(k, i))) cycle
            if (first == 0) first = i
            difference = abs(stations%listed(k, i) - stations%listed(k, first) - position(axis(k), i) + position(axis(k), first))
            if (difference <= largest) cycle
            largest = difference
            worst = i
            worst_k = k
         end do
      end do
      if (words == '') return
      if (largest <= same) then
         words = words//verb(' agree')//' with those of the file within '//shown(same)
      else
         words = words//verb(' differ')//' from those of the file by up to '//shown(largest)//', '//trim(names(worst_k))//' at '// &
                 in_units(units, unit_length, stations%md(worst), depth_digits)
         doubtful = largest > far
         if (doubtful) words = words//'. Check columns, units and the north of the azimuths'
      end if

   contains
      !> A verb that goes with one quantity or several.
      function verb(plural) result(text)
         character(*), intent(in) :: plural
         character(:), allocatable :: text
         text = plural
         if (index(words, ',') == 0) text = plural//'s'
      end function verb

      function shown(length) result(text)
         real(wp), intent(in) :: length
         character(:), allocatable :: text
         text = in_units(units, unit_length, length, few_digits)
      end function shown
   end subroutine position_words
end module dg_listed_positions
