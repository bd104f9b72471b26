!> Prediction of a calibration for measurements that it has not used: the value at the unknowns, and the 95 % interval of a
!> single measurement.
!>
!> The variance of a measurement less its prediction is s^2 + g.C g. Here s is its own scatter, C the unknowns' covariance, and
!> g the derivatives of the predicted value. This is linear theory (Bates & Watts 1988, Nonlinear regression analysis, sec.
!> 2.3). Half the interval is its root times Student's quantile with the degrees of freedom of s.
module dg_prediction
   use dg_kinds, only: wp
   use dg_fit_statistics, only: quantile_between, statistics_type, upper_end
   use dg_least_squares, only: difference_share, fit_type, measured_function_type
   use dg_missing, only: is_missing, missing
   implicit none
   private
   public :: prediction_type, predict

   !> One more value than unknowns, but for round-off: with fewer a scatter is useless.
   real(wp), parameter :: least_freedom = 0.999_wp

   type :: prediction_type
      real(wp), allocatable :: values(:)         !< missing where there is no solution
      real(wp), allocatable :: half_width(:)     !< of the 95 % interval of one measurement; missing where it cannot be told
   end type prediction_type

contains

   !> Predicts the values of a function at the unknowns of a fit.
   subroutine predict(function, fit, statistics, scale, deviation, freedom, prediction)
      class(measured_function_type), intent(inout) :: function   !< of the same unknowns as that fitted, at other conditions
      type(fit_type), intent(in) :: fit
      type(statistics_type), intent(in) :: statistics
      real(wp), intent(in) :: scale(:)             !< > 0: what counts as a large change of each unknown
      real(wp), intent(in) :: deviation(:)         !< of a measurement of each value; missing: not known
      real(wp), intent(in) :: freedom(:)           !< with which that is known
      type(prediction_type), intent(out) :: prediction
      real(wp) :: point(size(scale), 1), values(size(deviation), 1)
      real(wp) :: points(size(scale), size(scale)), changed(size(deviation), size(scale))
      real(wp) :: slope(size(deviation), size(scale)), width(size(scale)), variance, quantile, last
      logical :: solved(size(deviation), 1), changed_solved(size(deviation), size(scale)), certain(size(scale))
      integer :: d, j, k
      allocate (prediction%values(size(deviation)), prediction%half_width(size(deviation)), source=missing)
      point(:, 1) = fit%unknowns
      call function%evaluate(point, values, solved)
      where (solved(:, 1)) prediction%values = values(:, 1)
      ! an unknown that has no effect on the data, or is at its bound, counts as exact
      certain = fit%unfelt .or. fit%at_bound
      do k = 1, size(scale)
         if (.not. certain(k) .and. is_missing(statistics%deviation(k))) return
      end do
      width = difference_share*scale
      do k = 1, size(scale)
         points(:, k) = fit%unknowns
         points(k, k) = fit%unknowns(k) + width(k)
      end do
      call function%evaluate(points, changed, changed_solved)
      slope = 0.0_wp
      do k = 1, size(scale)
         if (.not. certain(k)) slope(:, k) = (changed(:, k) - values(:, 1))/width(k)*statistics%deviation(k)
      end do
      last = 0.0_wp
      quantile = 0.0_wp
      do d = 1, size(deviation)
         if (is_missing(deviation(d)) .or. .not. (solved(d, 1) .and. all(changed_solved(d, :) .or. certain))) cycle
         if (freedom(d) < least_freedom) cycle
         variance = deviation(d)**2
         do k = 1, size(scale)
            do j = 1, size(scale)
               variance = variance + slope(d, j)*statistics%correlation(j, k)*slope(d, k)
            end do
         end do
         if (abs(freedom(d) - last) > 0.0_wp) quantile = quantile_between(upper_end, max(freedom(d), 1.0_wp))
         last = freedom(d)
         prediction%half_width(d) = quantile*sqrt(max(variance, 0.0_wp))
      end do
   end subroutine predict
end module dg_prediction
