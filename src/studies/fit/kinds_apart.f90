!> Agreement of data of several kinds in one fit. Each kind alone is fitted by a linear step from the common fit.
!>
!>   F = (S - S_k)/p / (S_k/(n - p))
!> - S: sum of squares of the kind's residuals in the common fit
!> - S_k: the same, fitted alone
!> - n: number of its data
!> - p: number of combinations of unknowns that they determine
!>
!> Scatter alone gives F of about 1, and more than 10 with less than 1 in 1000.
module dg_kinds_apart
   use dg_kinds, only: wp
   implicit none
   private
   public :: are_apart

   !> F above which a kind asks for other unknowns than the common fit [-], and the least spare data of the kind.
   real(wp), parameter :: most = 10.0_wp
   integer, parameter :: least_spare = 4
   !> Part of a column of the Jacobian that is left without those before it, below which it adds nothing [-].
   real(wp), parameter :: round_off = 1.0e-6_wp

contains

   !> True if at least one of two kinds asks for other unknowns than the common fit, and both depend on them.
   pure function are_apart(jacobian, residual, kinds) result(apart)
      real(wp), intent(in) :: jacobian(:, :)     !< of unknowns that were found, over the deviations
      real(wp), intent(in) :: residual(:)        !< over the deviations
      integer, intent(in) :: kinds(:)            !< 1 or 2
      logical :: apart
      real(wp) :: excess(2)
      integer :: k
      do k = 1, 2
         excess(k) = excess_of(jacobian, residual, kinds == k)
      end do
      apart = all(excess >= 0.0_wp) .and. any(excess > most)
   end function are_apart

   !> F of some of the data [-]; below 0 where too few are spare, or none depends on the unknowns.
   pure function excess_of(jacobian, residual, among) result(excess)
      real(wp), intent(in) :: jacobian(:, :), residual(:)
      logical, intent(in) :: among(:)
      real(wp) :: excess
      real(wp) :: rest(count(among)), columns(count(among), size(jacobian, 2)), length
      integer :: i, j, rank
      excess = -1.0_wp
      rest = pack(residual, among)
      rank = 0
      do j = 1, size(jacobian, 2)
         columns(:, j) = pack(jacobian(:, j), among)
         length = norm2(columns(:, j))
         do i = 1, j - 1
            columns(:, j) = columns(:, j) - dot_product(columns(:, i), columns(:, j))*columns(:, i)
         end do
         if (norm2(columns(:, j)) > round_off*length) then
            rank = rank + 1
            columns(:, j) = columns(:, j)/norm2(columns(:, j))
            rest = rest - dot_product(columns(:, j), rest)*columns(:, j)
         else
            columns(:, j) = 0.0_wp
         end if
      end do
      if (rank == 0 .or. size(rest) - rank < least_spare) return
      excess = 0.0_wp
      if (.not. norm2(rest) > 0.0_wp) return
      excess = (sum(residual**2, mask=among) - sum(rest**2))/real(rank, wp)/(sum(rest**2)/real(size(rest) - rank, wp))
   end function excess_of
end module dg_kinds_apart
