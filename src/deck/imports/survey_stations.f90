!> Stations of a survey file: their order, doubles, and columns beside md, inc and azi.
module dg_survey_stations
   use dg_constants, only: degree
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_survey, only: turn_between
   use dg_survey_columns, only: layout_type
   use dg_survey_heading, only: column_azi, column_md, column_name, loose_rank
   use dg_text, only: either, quoted, to_text
   implicit none
   private
   public :: station_list_type, order_stations, pick_stations, rival_words

   !> Stations as read, with the place of each for messages. SI units.
   type :: station_list_type
      character(:), allocatable :: file          !< that holds them
      logical :: has_azimuth = .false.
      real(wp), allocatable :: md(:)             !< [m]
      real(wp), allocatable :: inclination(:)    !< [rad]
      real(wp), allocatable :: azimuth(:)        !< [rad]; zero where the table has none
      real(wp), allocatable :: listed(:, :)      !< tvd, north, east that the file lists, (3, stations) [m]; `missing`: none
      real(wp), allocatable :: rival(:, :)       !< md, inc, azi by other columns, (3, stations) [m, rad]; `missing`: none
      integer, allocatable :: lines(:)           !< of each station in its file
      character(:), allocatable :: skipped       !< rows of the file that are no stations, in words; '': all are
      character(:), allocatable :: columns       !< which of several columns was taken, in words; '': none had a rival
      character(:), allocatable :: headings      !< columns read, in words; without azi: headings seen, names known, the key
   end type station_list_type

   !> Differences below which two stations are the same [m], [rad].
   real(wp), parameter :: same_depth = 1.0e-6_wp, same_angle = 1.0e-9_wp
   !> Largest difference at which two columns show the same depth, or the same angle [m], [rad].
   real(wp), parameter :: equal_depth = 0.05_wp, equal_angle = 0.011_wp*degree
   character(*), parameter :: column_meaning(3) = [character(14) :: 'measured depth', 'inclination', 'azimuth']
   !> Inclination above which azimuths are compared [rad].
   real(wp), parameter :: inclined = 1.0_wp*degree

contains

   !> Keeps stations by their numbers, in that order.
   pure subroutine pick_stations(stations, places)
      type(station_list_type), intent(inout) :: stations
      integer, intent(in) :: places(:)
      stations%md = stations%md(places)
      stations%inclination = stations%inclination(places)
      stations%azimuth = stations%azimuth(places)
      stations%listed = stations%listed(:, places)
      stations%rival = stations%rival(:, places)
      stations%lines = stations%lines(places)
   end subroutine pick_stations

   !> Reverse stations that are listed deepest first, and remove a station that is in the file a second time. Any other station
   !> that is not below the one before it stays, for a fault.
   pure subroutine order_stations(stations, turned, repeated, first_repeated)
      type(station_list_type), intent(inout) :: stations
      logical, intent(out) :: turned
      integer, intent(out) :: repeated            !< stations dropped
      integer, intent(out) :: first_repeated      !< line of the first one
      integer :: i, k, n, kept, places(size(stations%md))
      n = size(stations%md)
      repeated = 0
      first_repeated = 0
      turned = .false.
      if (n < 2) return
      turned = stations%md(1) > stations%md(n) .and. all(stations%md(2:) <= stations%md(:n - 1))
      if (turned) call pick_stations(stations, [(i, i=n, 1, -1)])
      kept = 0
      do i = 1, n
         k = 0
         if (kept > 0) then
            if (stations%md(i) <= stations%md(places(kept)) + same_depth) k = same_station(stations, places(:kept), i)
         end if
         if (k > 0) then
            repeated = repeated + 1
            if (first_repeated == 0 .or. turned) first_repeated = stations%lines(i)
            if (turned) first_repeated = min(first_repeated, stations%lines(places(k)))
         else
            kept = kept + 1
            places(kept) = i
         end if
      end do
      if (repeated > 0) call pick_stations(stations, places(:kept))
   end subroutine order_stations

   !> Place of an earlier station at the same depth in the same direction; 0 where there is none. Depths of earlier ones increase,
   !> or the file is at fault.
   pure function same_station(stations, places, i) result(found)
      type(station_list_type), intent(in) :: stations
      integer, intent(in) :: places(:), i
      integer :: found
      integer :: k
      found = 0
      do k = size(places), 1, -1
         associate (j => places(k))
            if (stations%md(j) < stations%md(i) - same_depth) return
            if (abs(stations%md(j) - stations%md(i)) > same_depth) cycle
            if (abs(stations%inclination(j) - stations%inclination(i)) > same_angle) cycle
            if (stations%inclination(i) > same_angle .and. &
                abs(turn_between(stations%azimuth(j), stations%azimuth(i))) > same_angle) cycle
            found = k
            return
         end associate
      end do
   end function same_station

   !> Remark on a heading that was taken for a quantity that it does not surely name. Of two columns for md, inc or azi it
   !> names the one taken and their difference. '' without a remark. `doubt` is a fault: two columns differ, and their headings
   !> do not decide.
   pure subroutine rival_words(stations, layout, words, doubt)
      type(station_list_type), intent(in) :: stations
      type(layout_type), intent(in) :: layout
      character(:), allocatable, intent(out) :: words, doubt
      real(wp) :: difference, largest, unit
      logical :: differ
      integer :: column, i
      words = ''
      doubt = ''
      do column = column_md, column_azi
         if (layout%place(column) > 0) then
            associate (taken => layout%headings(layout%place(column)))
               if (taken%column == column .and. taken%rank >= loose_rank) then
                  if (words /= '') words = words//'. '
                  words = words//quoted(taken%text)//' is read as '//trim(column_meaning(column))
               end if
            end associate
         end if
         if (layout%rival(column) == 0 .or. layout%place(column) == 0) cycle
         largest = missing        ! no station compared
         do i = 1, size(stations%md)
            if (is_missing(stations%rival(column, i))) cycle
            select case (column)
            case (column_md)
               difference = abs(stations%md(i) - stations%rival(column, i))
            case (column_azi)
               if (stations%inclination(i) < inclined) cycle
               difference = abs(turn_between(stations%azimuth(i), stations%rival(column, i)))
            case default
               difference = abs(stations%inclination(i) - stations%rival(column, i))
            end select
            largest = max(largest, difference)
         end do
         associate (taken => layout%headings(layout%place(column)), other => layout%headings(layout%rival(column)))
            unit = merge(1.0_wp, degree, column == column_md)
            differ = largest > merge(equal_depth, equal_angle, column == column_md)
            if (differ .and. taken%rank == other%rank) then
               if (doubt /= '') doubt = doubt//'. '
               doubt = doubt//'two columns may be '//trim(column_name(column))//', '//quoted(taken%text)//' and '// &
                       quoted(other%text)//'. They differ by up to '//amount()//'. Name one in &trajectory: '// &
                       trim(column_name(column))//'_column = '//quoted(taken%text)
            else if (differ .or. (column == column_azi .and. .not. is_missing(largest))) then
               if (words /= '') words = words//'. '
               words = words//trim(column_name(column))//' is column '//quoted(taken%text)//', not '//quoted(other%text)// &
                       '. They differ by up to '//amount()//'. To take another: '//trim(column_name(column))//'_column'
            end if
         end associate
      end do

   contains
      pure function amount() result(text)
         character(:), allocatable :: text
         integer, parameter :: few_digits = 3
         text = to_text(largest/unit, few_digits)//either(' m', ' deg', column == column_md)
      end function amount
   end subroutine rival_words
end module dg_survey_stations
