!> Values along the string for a picture. Points that the eye cannot separate are left out, but no peak is lost. A curve that
!> alternates too often becomes a band.
module dg_depth_curve
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   implicit none
   private
   public :: kept_points, least_around, bands_of, lone_angles

contains

   !> True for the points of a curve that are drawn. Straight lines between them are within `tolerance` of all others. The
   !> method is the swinging door of process computers. Points beside missing values are kept.
   pure function kept_points(depth, values, tolerance) result(kept)
      real(wp), intent(in) :: depth(:)     !< never decreasing
      real(wp), intent(in) :: values(:)    !< as many
      real(wp), intent(in) :: tolerance    !< of values
      logical :: kept(size(depth))
      real(wp) :: low, high, slope, step
      integer :: anchor, i, n
      n = size(depth)
      kept = .false.
      if (n == 0) return
      kept([1, n]) = .true.
      anchor = 1
      low = -huge(low)
      high = huge(high)
      i = 1
      do while (i < n)
         i = i + 1
         if (is_missing(values(i)) .or. is_missing(values(i - 1))) then
            kept(i - 1:i) = .true.
            anchor = i
            low = -huge(low)
            high = huge(high)
            cycle
         end if
         step = depth(i) - depth(anchor)
         if (step > 0.0_wp) then
            slope = (values(i) - values(anchor))/step
            if (slope >= low .and. slope <= high) then
               low = max(low, (values(i) - tolerance - values(anchor))/step)
               high = min(high, (values(i) + tolerance - values(anchor))/step)
               cycle
            end if
         end if
         if (anchor == i - 1) then       ! a jump
            kept(i) = .true.
            anchor = i
         else
            kept(i - 1) = .true.
            anchor = i - 1
            i = i - 1
         end if
         low = -huge(low)
         high = huge(high)
      end do
   end function kept_points

   !> Least of the values that are within half a width of each depth; `missing` where none of them is there.
   pure function least_around(depth, values, width) result(least)
      real(wp), intent(in) :: depth(:)     !< never decreasing
      real(wp), intent(in) :: values(:)    !< as many
      real(wp), intent(in) :: width        !< in units of depth
      real(wp) :: least(size(depth))
      integer :: i, first, last
      first = 1
      last = 0
      do i = 1, size(depth)
         do while (depth(first) < depth(i) - 0.5_wp*width)
            first = first + 1
         end do
         do while (last < size(depth))
            if (depth(last + 1) > depth(i) + 0.5_wp*width) exit
            last = last + 1
         end do
         least(i) = missing
         if (any(.not. is_missing(values(first:last)))) &
            least(i) = minval(values(first:last), mask=.not. is_missing(values(first:last)))
      end do
   end function least_around

   !> Least, mean and greatest value in each of equal parts of the depth; of parts without a row those of the part above.
   pure subroutine bands_of(depth, values, least, mean, greatest)
      real(wp), intent(in) :: depth(:)     !< never decreasing
      real(wp), intent(in) :: values(:)    !< as many, all there
      real(wp), intent(out) :: least(:), mean(:), greatest(:)   !< as many as parts
      real(wp) :: sums(size(least)), lengths(size(least)), step
      integer :: i, above, part, n
      n = size(least)
      sums = 0.0_wp
      lengths = 0.0_wp
      least = huge(1.0_wp)
      greatest = -huge(1.0_wp)
      do i = 1, size(depth)
         part = 1 + min(int(n*(depth(i) - depth(1))/(depth(size(depth)) - depth(1))), n - 1)
         least(part) = min(least(part), values(i))
         greatest(part) = max(greatest(part), values(i))
         above = max(1, i - 1)
         step = depth(i) - depth(above)
         sums(part) = sums(part) + 0.5_wp*step*(values(i) + values(above))
         lengths(part) = lengths(part) + step
      end do
      do i = 1, n
         if (least(i) > greatest(i)) then
            least(i) = least(max(1, i - 1))
            greatest(i) = greatest(max(1, i - 1))
         end if
         mean(i) = 0.5_wp*(least(i) + greatest(i))
         if (lengths(i) > 0.0_wp) mean(i) = sums(i)/lengths(i)
      end do
   end subroutine bands_of

   !> Which angles [rad] of those that count have none near them in the row above or below. All of them stay where they are many:
   !> then the string does turn from row to row.
   pure function lone_angles(angle, counts) result(lone)
      real(wp), intent(in) :: angle(:)
      logical, intent(in) :: counts(:)     !< as many
      logical :: lone(size(angle))
      !> Distance of near angles [rad], and largest share of few rows [-].
      real(wp), parameter :: near = 0.5_wp, few = 0.05_wp
      integer :: i, above, below
      lone = .false.
      do i = 1, size(angle)
         if (.not. counts(i)) cycle
         above = max(1, i - 1)
         below = min(size(angle), i + 1)
         lone(i) = .true.
         if (above < i .and. counts(above)) lone(i) = cos(angle(i) - angle(above)) <= cos(near)
         if (below > i .and. counts(below)) lone(i) = lone(i) .and. cos(angle(i) - angle(below)) <= cos(near)
      end do
      ! one that touches between two that do not is no stray
      do i = 2, size(angle) - 1
         if (.not. (counts(i - 1) .or. counts(i + 1))) lone(i) = .false.
      end do
      if (count(lone) > few*count(counts)) lone = .false.
   end function lone_angles
end module dg_depth_curve
