!> Whether residuals of a fit follow each other from one depth to the next: errors of single measurements do not, so where they do
!> something is left that the model does not know, and intervals made for errors that know nothing of each other are too narrow.
module dg_residual_order
   use dg_kinds, only: wp
   implicit none
   private
   public :: find_succession

   !> Pairs of neighbours from which on a correlation is told.
   integer, parameter :: least_pairs = 8
   !> Correlation over 1/sqrt(pairs) that independent errors exceed in one of a hundred fits (normal distribution).
   real(wp), parameter :: one_of_hundred = 2.326_wp

contains

   !> Correlation of each residual with that of the next depth in its group (Durbin & Watson's 1 - d/2, without ends), and whether
   !> it is more than chance.
   pure subroutine find_succession(depth, group, residual, correlation, follows)
      real(wp), intent(in) :: depth(:)           !< [m]
      integer, intent(in) :: group(:)            !< what is compared with each other: an operation's hook loads, ...
      real(wp), intent(in) :: residual(:)        !< over its deviation [-]
      real(wp), intent(out) :: correlation       !< [-]; 0 where there are too few pairs
      logical, intent(out) :: follows
      real(wp) :: products, squares, nearest
      integer :: i, j, next, pairs
      products = 0.0_wp
      squares = 0.0_wp
      pairs = 0
      do i = 1, size(depth)
         next = 0
         nearest = huge(nearest)
         do j = 1, size(depth)
            if (group(j) /= group(i) .or. depth(j) <= depth(i) .or. depth(j) >= nearest) cycle
            next = j
            nearest = depth(j)
         end do
         if (next == 0) cycle
         pairs = pairs + 1
         products = products + residual(i)*residual(next)
         squares = squares + 0.5_wp*(residual(i)**2 + residual(next)**2)
      end do
      correlation = 0.0_wp
      follows = .false.
      if (pairs < least_pairs .or. .not. squares > 0.0_wp) return
      correlation = products/squares
      follows = correlation*sqrt(real(pairs, wp)) > one_of_hundred
   end subroutine find_succession
end module dg_residual_order
