!> How often intervals of least squares hold the truth, in simulated measurements.
module dg_test_fit_coverage
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_counter_random, only: normal_number
   use dg_fit_statistics, only: find_statistics, statistics_type
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
end module dg_test_fit_coverage
