!> Curves of the page: columns of a profile as texts 'step value step value ...', thinned as pictures are.
!>
!> Depths are steps in thousandths of the deck's unit of length, values have five digits of its units. Straight lines between
!> the kept points are within `tolerance` of a column's range of all others. The range is that of nine in ten values. One force
!> on an edge, or the safety factor of an unloaded bit, is thousands of times the rest. A missing value is empty.
module dg_page_curves
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_profile, only: profile_type
   use dg_quantity, only: quantity_force
   use dg_constants, only: pi
   use dg_depth_curve, only: kept_points
   use dg_line_load, only: force_on_length
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: is_missing
   use dg_profile_file, only: profile_series
   use dg_series, only: put, series_list_type
   use dg_text, only: put_piece, text_type, to_text
   use dg_units, only: unit_system_type
   use dg_unit_kind, only: unit_factor
   implicit none
   private
   public :: curve_series, curve_text, profile_curves

   character(*), parameter :: clock = 'clock', joint_force = 'side_force_on_joint'
   !> Length of string for the additional curve of side force, a joint of pipe, and number of its places.
   real(wp), parameter :: joint = 9.5_wp
   integer, parameter :: joint_places = 1000
   integer, parameter :: digits = 5, longest_pair = 32
   !> Change of an angle that is kept, at least [rad], and values that are all alike [-].
   real(wp), parameter :: least_turn = pi/180.0_wp, alike = 1.0e-9_wp
   !> Part of the values, at each end of their order, that does not count for the range [-].
   real(wp), parameter :: outer = 0.05_wp
   !> Largest turn of an angle between two points that are kept, where the profile has more [rad].
   real(wp), parameter :: most_turn = 0.5_wp*pi

contains

   !> Profile columns that are curves: all but the depth and the side of a jump, and one more.
   pure function curve_series(profile, along) result(list)
      type(profile_type), intent(in) :: profile      !< with rows
      type(along_string_type), intent(in) :: along
      type(series_list_type) :: list
      type(series_list_type) :: all
      integer :: i
      all = profile_series(profile, along)
      allocate (list%items(all%count + 1))
      do i = 1, all%count
         if (any(all%items(i)%column%name == [character(4) :: 'md', 'side'])) cycle
         list%count = list%count + 1
         list%items(list%count) = all%items(i)
      end do
      call put(list, joint_force, quantity_force, 'contact force on 9.5 m of string, the length of a joint', profile%side_force)
   end function curve_series

   !> A text for each of `curve_series`; '' where a column has no value.
   pure subroutine profile_curves(profile, along, units, tolerance, texts)
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: tolerance          !< of a column's range [-]
      type(text_type), intent(out) :: texts(:)   !< as many
      type(series_list_type) :: list
      real(wp) :: places(0:joint_places), unit
      integer :: i, k, n
      list = curve_series(profile, along)
      n = size(profile%md)
      places = profile%md(1) + (profile%md(n) - profile%md(1))*[(real(i, wp)/joint_places, i=0, joint_places)]
      do k = 1, list%count
         associate (series => list%items(k))
            unit = unit_factor(units, series%column%quantity)
            if (allocated(series%states)) then
               texts(k)%text = states_text(profile%md, series%states, units%length)
            else if (series%column%name == joint_force) then
               texts(k)%text = curve_text(places, force_on_length(profile%md, series%numbers, joint, places), unit, units%length, &
                                          tolerance)
            else if (series%column%name == clock) then
               texts(k)%text = angle_text(profile%md, series%numbers, unit, units%length, tolerance)
            else
               texts(k)%text = curve_text(profile%md, series%numbers, unit, units%length, tolerance)
            end if
         end associate
      end do
   end subroutine profile_curves

   !> A curve of numbers. With a tolerance of zero all points stand, in any order.
   pure function curve_text(md, values, unit, length, tolerance) result(text)
      real(wp), intent(in) :: md(:), values(:)      !< [SI]
      real(wp), intent(in) :: unit, length          !< of values and depths [SI]
      real(wp), intent(in) :: tolerance             !< of the range [-]
      character(:), allocatable :: text
      logical :: there(size(values)), kept(size(values))
      real(wp) :: range
      there = .not. is_missing(values)
      text = ''
      if (.not. any(there)) return
      range = maxval(values, mask=there) - minval(values, mask=there)
      if (tolerance <= 0.0_wp) then
         kept = .true.
      else if (all(there) .and. range <= alike*maxval(abs(values))) then
         kept = .false.
         kept([1, size(kept)]) = .true.
      else
         kept = kept_points(md, values, tolerance*inner_range(pack(values, there), range))
      end if
      text = pairs_text(md, values, kept, unit, length)
   end function curve_text

   !> Range of nine in ten values; the whole range where these are alike.
   pure function inner_range(values, whole) result(range)
      real(wp), intent(in) :: values(:), whole
      real(wp) :: range
      integer :: places(size(values)), cut
      places = sorted_places(values)
      cut = int(outer*size(values))
      range = values(places(size(values) - cut)) - values(places(1 + cut))
      if (range <= alike*whole) range = whole
   end function inner_range

   !> An angle, which is thinned without its jumps from a full turn to zero.
   pure function angle_text(md, values, unit, length, tolerance) result(text)
      real(wp), intent(in) :: md(:), values(:), unit, length, tolerance
      character(:), allocatable :: text
      real(wp) :: steady(size(values)), turn
      logical :: kept(size(values))
      integer :: i, last
      steady = values
      turn = 0.0_wp
      do i = 2, size(values)
         if (is_missing(values(i)) .or. is_missing(values(i - 1))) cycle
         if (values(i) - values(i - 1) > pi) turn = turn - 2.0_wp*pi
         if (values(i) - values(i - 1) < -pi) turn = turn + 2.0_wp*pi
         steady(i) = values(i) + turn
      end do
      kept = kept_points(md, steady, max(least_turn, tolerance*2.0_wp*pi))
      last = 1
      do i = 2, size(values)
         if (is_missing(values(i)) .or. is_missing(values(last))) then
            last = i
         else if (kept(i) .or. abs(steady(i) - steady(last)) > most_turn) then
            ! a reader goes the short way round between two points
            if (abs(steady(i) - steady(last)) > most_turn) kept(i - 1) = .true.
            last = merge(i, i - 1, kept(i))
         end if
      end do
      text = pairs_text(md, values, kept, unit, length)
   end function angle_text

   !> States by their number: both ends of each change.
   pure function states_text(md, codes, length) result(text)
      real(wp), intent(in) :: md(:), length
      integer, intent(in) :: codes(:)
      character(:), allocatable :: text
      logical :: kept(size(codes))
      integer :: i
      kept = .false.
      kept([1, size(codes)]) = .true.
      do i = 2, size(codes)
         if (codes(i) /= codes(i - 1)) kept(i - 1:i) = .true.
      end do
      text = pairs_text(md, real(codes, wp), kept, 1.0_wp, length)
   end function states_text

   !> The text of the points that are kept.
   pure function pairs_text(md, values, kept, unit, length) result(text)
      real(wp), intent(in) :: md(:), values(:), unit, length
      logical, intent(in) :: kept(:)
      character(:), allocatable :: text
      real(wp), parameter :: per_unit = 1000.0_wp
      character(:), allocatable :: room
      integer :: i, filled, place, last
      allocate (character(longest_pair*count(kept)) :: room)
      filled = 0
      last = 0
      do i = 1, size(md)
         if (.not. kept(i)) cycle
         place = nint(per_unit*md(i)/length)
         if (filled > 0) call put_piece(room, filled, ' ')
         call put_piece(room, filled, to_text(place - last)//' ')
         if (.not. is_missing(values(i))) call put_piece(room, filled, to_text(values(i)/unit, digits))
         last = place
      end do
      text = room(:filled)
   end function pairs_text
end module dg_page_curves
