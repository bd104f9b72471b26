!> Share of intervals of least squares that hold the truth, in simulated measurements.
module dg_test_fit_coverage
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use dg_counter_random, only: normal_number
   use dg_depth_drift, only: drift_type, find_drift, with_drift
   use dg_fit_statistics, only: find_statistics, quantile_between, statistics_type, upper_end
   use dg_kinds, only: wp
   use dg_least_squares, only: fit_done, fit_least_squares, fit_type, measured_function_type
   implicit none
   private
   public :: fit_coverage_suite

   !> a exp(-b x) at given places.
   type, extends(measured_function_type) :: decay_type
      real(wp), allocatable :: x(:)
   contains
      procedure :: evaluate
   end type decay_type

contains

   function fit_coverage_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('fit_coverage')
      call suite%addTest(TestMethod('decay', test_coverage))
      call suite%addTest(TestMethod('drift_with_depth', test_drift))
   end function fit_coverage_suite

   subroutine evaluate(self, points, values, solved)
      class(decay_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      integer :: p
      do p = 1, size(points, 2)
         values(:, p) = points(1, p)*exp(-points(2, p)*self%x)
      end do
      solved = .true.
   end subroutine evaluate

   !> Intervals of 95 % hold what made the data in 95 % of 2000 sets of them, within four standard errors (0.0195): from the scatter
   !> of the residuals (four degrees of freedom) and from a deviation that is known. The function is not linear.
   subroutine test_coverage()
      integer, parameter :: sets = 2000, points = 6
      real(wp), parameter :: truth(2) = [1.0_wp, 0.3_wp], noise = 0.02_wp, nominal = 0.95_wp
      type(decay_type) :: curve
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      real(wp) :: exact(points), measured(points)
      integer :: held(2, 2), set, k, i
      curve%x = [(1.0_wp*i, i=0, points - 1)]
      exact = truth(1)*exp(-truth(2)*curve%x)
      held = 0
      do set = 1, sets
         measured = exact + noise*normal_number(1, set, 1, [(i, i=1, points)])
         call fit_least_squares(curve, [0.9_wp, 0.2_wp], [0.0_wp, 0.0_wp], [2.0_wp, 2.0_wp], [1.0_wp, 1.0_wp], measured, &
                                spread(noise, 1, points), fit)
         call assertEqual(fit_done, fit%status)
         do k = 1, 2
            call find_statistics(fit%jacobian, (fit%values - measured)/noise, [.true., .true.], spread(2 - k, 1, points), &
                                 statistics)
            where (abs(fit%unknowns - truth) <= statistics%half_width) held(:, k) = held(:, k) + 1
         end do
      end do
      call assertEqual(nominal, held(1, 1)/real(sets, wp), 0.0195_wp, message='factor, from the scatter')
      call assertEqual(nominal, held(2, 1)/real(sets, wp), 0.0195_wp, message='exponent, from the scatter')
      call assertEqual(nominal, held(1, 2)/real(sets, wp), 0.0195_wp, message='factor, deviation known')
      call assertEqual(nominal, held(2, 2)/real(sets, wp), 0.0195_wp, message='exponent, deviation known')
   end subroutine test_coverage

   !> A mean of three operations at nine depths each predicts nine deeper ones. Without a drift the intervals hold 93 to 98 % of
   !> these and are at most a quarter wider in the mean than without a search for one; with drifts of 3 and 8 deviations over all
   !> depths, alike in all operations or of either sign, they hold 85 % or more (of 3, of either sign, can hardly be seen).
   subroutine test_drift()
      integer, parameter :: sets = 500, at = 9, groups = 3, data = at*groups
      real(wp), parameter :: deviation = 5.0e3_wp, slopes(5) = [0.0_wp, 3.0_wp, 8.0_wp, 3.0_wp, 8.0_wp], &
                             signs(groups) = [1.0_wp, -1.0_wp, 1.0_wp]
      real(wp) :: error(2*at, groups), depth(2*at), jacobian(data, 1), residual(data), mean, scatter, half, wide, quantile, side
      integer :: group(data), set, g, k, kind, held
      type(drift_type) :: drift
      character(40) :: label
      depth = [(1000.0_wp + 100.0_wp*k, k=1, 2*at)]
      group = [((g, k=1, at), g=1, groups)]
      jacobian = 1.0_wp
      quantile = quantile_between(upper_end, real(data - 1, wp))
      do kind = 1, size(slopes)
         held = 0
         wide = 0.0_wp
         do set = 1, sets
            do g = 1, groups
               side = merge(signs(g), 1.0_wp, kind > 3)
               error(:, g) = normal_number(2, set, g, [(k, k=1, 2*at)]) + &
                             side*slopes(kind)*(depth - depth(1))/(depth(2*at) - depth(1))
            end do
            mean = sum(error(:at, :))/real(data, wp)
            residual = mean - reshape(error(:at, :), [data])     ! over the deviation
            scatter = norm2(residual)/sqrt(real(data - 1, wp))
            call find_drift(jacobian, residual, spread(deviation, 1, data), [(depth(:at), g=1, groups)], group, drift)
            do k = at + 1, 2*at
               half = quantile*hypot(with_drift(scatter*deviation, drift, depth(k))/deviation, scatter/sqrt(real(data, wp)))
               held = held + count(abs(error(k, :) - mean) <= half)
               wide = wide + half/(quantile*scatter*sqrt(1.0_wp + 1.0_wp/real(data, wp)))/real(sets*at, wp)
            end do
         end do
         write (label, '(a, f0.1, a, i0)') 'drift of ', slopes(kind), ', kind ', kind
         call assertGreaterThan(held/real(sets*at*groups, wp), merge(0.93_wp, 0.85_wp, kind == 1), message=label)
         if (kind > 1) cycle
         call assertLessThan(held/real(sets*at*groups, wp), 0.98_wp, message=label)
         call assertLessThan(wide, 1.25_wp, message='width without a drift')
      end do
   end subroutine test_drift
end module dg_test_fit_coverage
