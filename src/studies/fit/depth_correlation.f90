!> Errors that are alike from one depth to the next, and their effect on a fit.
!>
!> Scatter of a gauge is independent of depth. Errors of the model (weights, a friction that is not the same everywhere)
!> persist over many depths, so that many measurements count as few. Errors of an operation are assumed an autoregressive
!> process of first order, with the correlation exp(-distance/length). A fit absorbs part of such errors, so that residuals are
!> less alike than errors. The length is the one at which the expected correlation of residuals is that found. It uses moments
!> of Durbin & Watson's ratio, and no negative correlation.
!> The unknowns stay those of least squares. Their covariance is A R A', with A the inverse of the fit and R the correlation of
!> errors (White & Huber's form). With M = I - J A, the variance of errors is r.r/tr(M R M). Its degrees of freedom are
!> Satterthwaite's (1946), tr(M R M)^2/tr((M R M)^2). If R is the unit matrix these are the usual ones.
module dg_depth_correlation
   use dg_kinds, only: wp
   use dg_fit_statistics, only: as_normal, quantile_between, statistics_type, upper_end
   use dg_missing, only: is_missing
   use dg_variance_components, only: invert_normal
   implicit none
   private
   public :: succession_type, find_succession, scatter_along, widen_intervals

   !> Least number of pairs of neighbours for a correlation. With fewer, the chance correlation of independent errors would
   !> widen their intervals by more than a tenth.
   integer, parameter :: least_pairs = 12
   !> Correlation over 1/sqrt(pairs) that independent errors exceed in one of a hundred fits (normal distribution).
   real(wp), parameter :: one_of_hundred = 2.326_wp
   !> Largest correlation of neighbours. Beyond it errors of thirty depths are like an offset.
   real(wp), parameter :: most_correlation = 0.98_wp
   !> Halvings of the interval of the correlation: four decimals are enough.
   integer, parameter :: halvings = 14
   !> Spare part of a datum that is round-off [-].
   real(wp), parameter :: none_spare = 1.0e-9_wp

   type :: succession_type
      real(wp) :: observed = 0.0_wp               !< correlation of residuals from one depth to the next; 0: too few pairs [-]
      logical :: follows = .false.                !< it is more than chance
      real(wp) :: correlation = 0.0_wp            !< of errors at the neighbours' mean distance; 0: as independent ones [-]
      !> Where `correlation` > 0, all over the variance of errors: R, covariance of residuals M R M, and A.
      real(wp), allocatable :: errors(:, :), left(:, :), inverse(:, :)
   end type succession_type

contains

   !> Correlation of residuals of neighbours in depth, and that of their errors.
   pure subroutine find_succession(jacobian, residual, depth, group, succession)
      real(wp), intent(in) :: jacobian(:, :)     !< (data, unknowns found), over the deviations
      real(wp), intent(in) :: residual(:)        !< over the deviations [-]
      real(wp), intent(in) :: depth(:)           !< [m]
      integer, intent(in) :: group(:)            !< what is compared with each other: an operation's hook loads, ...
      type(succession_type), intent(out) :: succession
      real(wp) :: inverse(size(jacobian, 2), size(jacobian, 2)), low, high
      integer :: next(size(depth)), step
      logical :: regular
      call find_neighbours(depth, group, next)
      if (count(next > 0) < least_pairs) return
      succession%observed = likeness(next, residual_products(residual))
      succession%follows = succession%observed*sqrt(real(count(next > 0), wp)) > one_of_hundred
      call invert_normal(jacobian, inverse, regular)
      if (.not. regular .or. size(residual) <= size(jacobian, 2)) return
      succession%inverse = matmul(inverse, transpose(jacobian))
      call let_errors_be(0.0_wp, jacobian, depth, group, next, succession)
      if (succession%observed <= likeness(next, succession%left)) return
      low = 0.0_wp
      high = most_correlation
      do step = 1, halvings
         succession%correlation = 0.5_wp*(low + high)
         call let_errors_be(succession%correlation, jacobian, depth, group, next, succession)
         if (likeness(next, succession%left) < succession%observed) then
            low = succession%correlation
         else
            high = succession%correlation
         end if
      end do
   end subroutine find_succession

   !> Number of the next deeper datum of the same group; 0: none.
   pure subroutine find_neighbours(depth, group, next)
      real(wp), intent(in) :: depth(:)
      integer, intent(in) :: group(:)
      integer, intent(out) :: next(:)
      real(wp) :: nearest
      integer :: i, j
      do i = 1, size(depth)
         next(i) = 0
         nearest = huge(nearest)
         do j = 1, size(depth)
            if (group(j) /= group(i) .or. depth(j) <= depth(i) .or. depth(j) >= nearest) cycle
            next(i) = j
            nearest = depth(j)
         end do
      end do
   end subroutine find_neighbours

   !> Products of residuals of neighbours over the mean of their squares (Durbin & Watson's 1 - d/2, without ends).
   pure function likeness(next, products) result(ratio)
      integer, intent(in) :: next(:)
      real(wp), intent(in) :: products(:, :)     !< of residuals with each other, or what they are expected to be
      real(wp) :: ratio
      real(wp) :: crossed, squares
      integer :: i
      crossed = 0.0_wp
      squares = 0.0_wp
      do i = 1, size(next)
         if (next(i) == 0) cycle
         crossed = crossed + products(i, next(i))
         squares = squares + 0.5_wp*(products(i, i) + products(next(i), next(i)))
      end do
      ratio = 0.0_wp
      if (squares > tiny(squares)) ratio = crossed/squares
   end function likeness

   pure function residual_products(residual) result(products)
      real(wp), intent(in) :: residual(:)
      real(wp) :: products(size(residual), size(residual))
      integer :: i
      do i = 1, size(residual)
         products(:, i) = residual*residual(i)
      end do
   end function residual_products

   !> Correlation of errors that are alike by `correlation` at the mean distance of neighbours. Covariance of residuals after a
   !> fit: M R M = R - J (A R) - (J (A R))' + J (A R A') J'.
   pure subroutine let_errors_be(correlation, jacobian, depth, group, next, succession)
      real(wp), intent(in) :: correlation, jacobian(:, :), depth(:)
      integer, intent(in) :: group(:), next(:)
      type(succession_type), intent(inout) :: succession
      real(wp) :: taken(size(jacobian, 2), size(depth)), fitted(size(depth), size(depth)), distance
      integer :: i, j
      distance = 0.0_wp
      do i = 1, size(next)
         if (next(i) > 0) distance = distance + (depth(next(i)) - depth(i))/real(count(next > 0), wp)
      end do
      if (.not. allocated(succession%errors)) allocate (succession%errors(size(depth), size(depth)))
      do i = 1, size(depth)
         do j = 1, size(depth)
            succession%errors(j, i) = 0.0_wp
            if (i == j) then
               succession%errors(j, i) = 1.0_wp
            else if (group(i) == group(j) .and. correlation > 0.0_wp) then
               succession%errors(j, i) = correlation**(abs(depth(i) - depth(j))/distance)
            end if
         end do
      end do
      taken = matmul(succession%inverse, succession%errors)
      fitted = matmul(jacobian, taken)
      succession%left = succession%errors - fitted - transpose(fitted) &
                        + matmul(jacobian, matmul(matmul(taken, transpose(succession%inverse)), transpose(jacobian)))
   end subroutine let_errors_be

   !> Standard deviation of some errors by their residuals, and its degrees of freedom. Both stay if no value is spare.
   pure subroutine scatter_along(succession, residual, among, scatter, freedom)
      type(succession_type), intent(in) :: succession   !< `correlation` > 0
      real(wp), intent(in) :: residual(:)
      logical, intent(in) :: among(:)
      real(wp), intent(inout) :: scatter, freedom
      real(wp) :: spare, squares
      integer :: i, j
      spare = 0.0_wp
      squares = 0.0_wp
      do i = 1, size(among)
         if (.not. among(i)) cycle
         spare = spare + succession%left(i, i)
         do j = 1, size(among)
            if (among(j)) squares = squares + succession%left(j, i)**2
         end do
      end do
      if (spare <= none_spare*real(count(among), wp)) return
      scatter = sqrt(sum(residual**2, mask=among)/spare)
      freedom = max(1.0_wp, spare**2/squares)
   end subroutine scatter_along

   !> Covariance and intervals of the unknowns. Each is that for independent errors, times the factor of A R A'.
   pure subroutine widen_intervals(succession, growth, by_residuals, freedom, columns, statistics)
      type(succession_type), intent(in) :: succession   !< `correlation` > 0
      real(wp), intent(in) :: growth(:)          !< factor on the standard deviation of each datum that the fit has gone by
      logical, intent(in) :: by_residuals        !< any deviation is told by the residuals, with
      real(wp), intent(in) :: freedom            !< degrees of freedom
      integer, intent(in) :: columns(:)          !< unknowns found
      type(statistics_type), intent(inout) :: statistics
      real(wp), dimension(size(columns), size(columns)) :: covariance, independent
      real(wp) :: weighed(size(columns), size(growth)), factor, quantiles
      integer :: k, j
      if (any(is_missing(statistics%deviation(columns)))) return
      do k = 1, size(growth)
         weighed(:, k) = succession%inverse(:, k)*growth(k)
      end do
      covariance = matmul(matmul(weighed, succession%errors), transpose(weighed))
      independent = matmul(succession%inverse, transpose(succession%inverse))
      quantiles = 1.0_wp
      if (by_residuals) quantiles = quantile_between(upper_end, min(freedom, real(as_normal, wp)))/ &
         quantile_between(upper_end, real(statistics%freedom, wp))
      do k = 1, size(columns)
         factor = sqrt(covariance(k, k)/independent(k, k))
         statistics%deviation(columns(k)) = factor*statistics%deviation(columns(k))
         if (.not. is_missing(statistics%half_width(columns(k)))) &
            statistics%half_width(columns(k)) = factor*quantiles*statistics%half_width(columns(k))
         do j = 1, size(columns)
            statistics%correlation(columns(j), columns(k)) = covariance(j, k)/sqrt(covariance(j, j)*covariance(k, k))
         end do
      end do
   end subroutine widen_intervals
end module dg_depth_correlation
