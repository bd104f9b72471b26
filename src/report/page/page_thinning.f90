!> Curves of the page with fewer points: straight lines between the kept points are within a tolerance of a column's range of all
!> others. The range is that of nine in ten values. One force on an edge is thousands of times the rest.
!>
!> The largest and the least value of a curve are always kept.
module dg_page_thinning
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_depth_curve, only: kept_points
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: is_missing
   use dg_page_code, only: per_value, scale_type, scale_within
   implicit none
   private
   public :: clock, finest, inner_range, kept_states, kept_values, rounding, thin_curve, thinned_type

   !> Tolerance to which curves are thinned, over the range of a column [-].
   real(wp), parameter :: finest = 3.0e-4_wp

   type :: thinned_type
      character(:), allocatable :: name
      real(wp), allocatable :: values(:)          !< at all rows
      logical, allocatable :: kept(:)             !< rows that are written; not allocated: none
      type(scale_type) :: scale
      real(wp) :: band = 0.0_wp                   !< within which the curve stays
      real(wp) :: letters = 0.0_wp                !< of its text, about
   end type thinned_type

   character(*), parameter :: clock = 'clock'
   !> Letters of a depth, about.
   real(wp), parameter :: depth_letters = 0.5_wp
   !> Parts of the band around a thinned curve in which its points are rounded: the one with the shorter text is taken [-].
   real(wp), parameter :: rounding(2) = [0.1_wp, 0.5_wp]
   !> Change of an angle that is kept, at least [rad], and values that are all alike [-].
   real(wp), parameter :: least_turn = pi/180.0_wp, alike = 1.0e-9_wp
   !> Part of the values, at each end of their order, that does not count for the range [-].
   real(wp), parameter :: outer = 0.05_wp
   !> Largest turn of an angle between two points that are kept, where the profile has more [rad].
   real(wp), parameter :: most_turn = 0.5_wp*pi

contains

   !> Thin a curve. Of some ways to round its values the one with the shortest text is taken.
   pure subroutine thin_curve(curve, md, angle, within)
      type(thinned_type), intent(inout) :: curve     !< with name and values
      real(wp), intent(in) :: md(:)                  !< as many
      real(wp), intent(in) :: angle                  !< unit of angles [rad]
      real(wp), intent(in) :: within                 !< tolerance over the range [-]
      real(wp) :: angles(size(md)), letters
      logical :: kept(size(md))
      type(scale_type) :: scale
      integer :: i
      angles = curve%values
      where (.not. is_missing(angles)) angles = angles*angle
      curve%band = within*inner_range(curve%values)
      if (curve%name == clock) curve%band = max(least_turn, within*2.0_wp*pi)/angle
      curve%kept = spread(.true., 1, size(md))
      curve%scale = scale_within(curve%values, curve%band)
      curve%letters = per_value(curve%scale)*size(md)
      do i = 1, size(rounding)
         if (curve%name == clock) then
            kept = kept_angles(md, angles, within)
         else
            kept = kept_values(md, curve%values, (1.0_wp - rounding(i))*curve%band)
         end if
         scale = scale_within(pack(curve%values, kept), rounding(i)*curve%band)
         letters = (depth_letters + per_value(scale))*count(kept)
         if (letters >= curve%letters) cycle
         curve%letters = letters
         curve%kept = kept
         curve%scale = scale
      end do
   end subroutine thin_curve

   !> Points of a curve that are kept, the largest and the least value among them. Straight lines between them are within `band`
   !> of all others.
   pure function kept_values(depths, values, band) result(kept)
      real(wp), intent(in) :: depths(:), values(:), band
      logical :: kept(size(values))
      logical :: there(size(values))
      integer :: first, last
      there = .not. is_missing(values)
      kept = .false.
      kept([1, size(kept)]) = .true.
      if (all(there) .and. maxval(values) - minval(values) <= alike*maxval(abs(values))) return
      kept(maxloc(values, mask=there)) = .true.
      kept(minloc(values, mask=there)) = .true.
      first = 1
      do while (first < size(kept))
         last = first + findloc(kept(first + 1:), .true., dim=1)
         kept(first:last) = kept_points(depths(first:last), values(first:last), band)
         first = last
      end do
   end function kept_values

   !> Range of nine in ten values that are there; the whole range where these are alike.
   pure function inner_range(values) result(range)
      real(wp), intent(in) :: values(:)
      real(wp) :: range
      real(wp), allocatable :: there(:)
      integer, allocatable :: places(:)
      integer :: cut
      there = pack(values, .not. is_missing(values))
      places = sorted_places(there)
      there = there(places)
      cut = int(outer*size(there))
      range = there(size(there) - cut) - there(1 + cut)
      if (range <= alike*(there(size(there)) - there(1))) range = there(size(there)) - there(1)
   end function inner_range

   !> Points of an angle that are kept: it is thinned without its jumps from a full turn to zero.
   pure function kept_angles(depths, values, tolerance) result(kept)
      real(wp), intent(in) :: depths(:), values(:), tolerance      !< values [rad]
      logical :: kept(size(values))
      real(wp) :: steady(size(values)), turn
      integer :: i, last
      steady = values
      turn = 0.0_wp
      do i = 2, size(values)
         if (is_missing(values(i)) .or. is_missing(values(i - 1))) cycle
         if (values(i) - values(i - 1) > pi) turn = turn - 2.0_wp*pi
         if (values(i) - values(i - 1) < -pi) turn = turn + 2.0_wp*pi
         steady(i) = values(i) + turn
      end do
      kept = kept_points(depths, steady, max(least_turn, tolerance*2.0_wp*pi))
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
   end function kept_angles

   !> States that are kept: both ends of each change.
   pure function kept_states(codes) result(kept)
      integer, intent(in) :: codes(:)
      logical :: kept(size(codes))
      integer :: i
      kept = .false.
      kept([1, size(codes)]) = .true.
      do i = 2, size(codes)
         if (codes(i) /= codes(i - 1)) kept(i - 1:i) = .true.
      end do
   end function kept_states
end module dg_page_thinning
