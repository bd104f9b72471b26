!> Forces and means of a load per length that is straight between rows: on the length of a joint of pipe, where they are largest.
!> They depend on the force that acts, not on how narrow the peak of its load is.
module dg_line_load
   use dg_kinds, only: wp
   implicit none
   private
   public :: force_on_length, force_between, largest_mean

contains

   !> Force [N] that a load [N/m] has on `length` [m] of string, half of it above and half below each place. The string ends where
   !> its rows do.
   pure function force_on_length(md, load, length, places) result(force)
      real(wp), intent(in) :: md(:)        !< of the rows [m], never decreasing
      real(wp), intent(in) :: load(:)      !< as many
      real(wp), intent(in) :: length
      real(wp), intent(in) :: places(:)    !< [m], never decreasing
      real(wp) :: force(size(places))
      force = force_between(md, load, places - 0.5_wp*length, places + 0.5_wp*length)
   end function force_on_length

   !> Force [N] that a load [N/m] has between an upper and a lower depth. The string ends where its rows do.
   pure function force_between(md, load, upper, lower) result(force)
      real(wp), intent(in) :: md(:)        !< of the rows [m], never decreasing
      real(wp), intent(in) :: load(:)      !< as many
      real(wp), intent(in) :: upper(:)     !< [m], never decreasing
      real(wp), intent(in) :: lower(:)     !< as many, never decreasing
      real(wp) :: force(size(upper))
      real(wp) :: total(size(md))
      integer :: i
      total(1) = 0.0_wp
      do i = 2, size(md)
         total(i) = total(i - 1) + 0.5_wp*(md(i) - md(i - 1))*(load(i) + load(i - 1))
      end do
      force = totals_at(md, load, total, lower) - totals_at(md, load, total, upper)
   end function force_between

   !> Largest mean of a load on `length` of string, and the row of that length with the most load. Lengths that have a row at an end
   !> or in the middle are compared, the first of equal ones counts. A shorter string has the mean of all of it.
   pure subroutine largest_mean(md, load, length, mean, row)
      real(wp), intent(in) :: md(:)        !< of the rows [m], never decreasing
      real(wp), intent(in) :: load(:)      !< as many [N/m]
      real(wp), intent(in) :: length       !< [m]
      real(wp), intent(out) :: mean        !< [N/m]
      integer, intent(out) :: row
      real(wp), parameter :: alike = 1.0e-9_wp       ! of forces and of depths, by round-off [-]
      integer, parameter :: shift(3) = [0, -1, 1]    ! row in the middle, at the lower end, at the upper end [half a length]
      real(wp) :: places(size(md)), force(size(md)), window, most, middle
      logical :: inside(size(md))
      integer :: k, i, n
      n = size(md)
      row = maxloc(load, dim=1)
      mean = load(row)
      window = min(length, md(n) - md(1))
      if (.not. window > 0.0_wp) return
      most = -huge(most)
      middle = md(1)
      do k = 1, size(shift)
         places = min(max(md + 0.5_wp*shift(k)*window, md(1) + 0.5_wp*window), md(n) - 0.5_wp*window)
         force = force_on_length(md, load, window, places)
         if (k > 1 .and. .not. maxval(force) > (1.0_wp + alike)*most) cycle
         most = maxval(force)
         i = max(1, findloc(force >= (1.0_wp - alike)*most, .true., dim=1))
         middle = places(i)
      end do
      mean = most/window
      inside = abs(md - middle) <= (0.5_wp + alike)*window
      row = max(1, findloc(inside .and. load >= (1.0_wp - alike)*maxval(load, mask=inside), .true., dim=1))
   end subroutine largest_mean

   !> The integral from the first row to each place.
   pure function totals_at(md, load, total, places) result(totals)
      real(wp), intent(in) :: md(:), load(:), total(:), places(:)
      real(wp) :: totals(size(places))
      real(wp) :: step, share
      integer :: i, row
      row = 1
      do i = 1, size(places)
         do while (row < size(md) - 1)
            if (md(row + 1) > places(i)) exit
            row = row + 1
         end do
         if (places(i) <= md(1)) then
            totals(i) = 0.0_wp
         else if (places(i) >= md(size(md))) then
            totals(i) = total(size(md))
         else
            step = places(i) - md(row)
            share = step/(md(row + 1) - md(row))
            totals(i) = total(row) + step*(load(row) + 0.5_wp*share*(load(row + 1) - load(row)))
         end if
      end do
   end function totals_at
end module dg_line_load
