!> Intervals of single measurements that a fit has not seen: of a straight line by the textbook's formula, of hook loads and
!> torques in simulated campaigns by how many they hold.
module dg_test_prediction
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_calibration_result, only: calibration_result_type, judge_fit
   use dg_counter_random, only: normal_number
   use dg_fit_by_kinds, only: fit_by_kinds
   use dg_kinds, only: wp
   use dg_least_squares, only: fit_done, measured_function_type
   use dg_missing, only: is_missing, missing
   use dg_prediction, only: predict
   use dg_residual_order, only: find_succession
   implicit none
   private
   public :: prediction_suite

   integer, parameter :: hookload = 1, torque = 2, campaigns = 2000
   real(wp), parameter :: friction = 0.25_wp, block = 180.0_wp

   !> y = a + b x.
   type, extends(measured_function_type) :: line_type
      real(wp), allocatable :: x(:)
   contains
      procedure :: evaluate => evaluate_line
   end type line_type

   !> A string around a bend by the capstan's formula, at several depths: hook load up or down, with a block, and torque.
   type, extends(measured_function_type) :: capstan_type
      real(wp), allocatable :: weight(:)    !< below the bend [kN]
      real(wp), allocatable :: angle(:)     !< of the bend, < 0 going down [rad]
      integer, allocatable :: what(:)
   contains
      procedure :: evaluate => evaluate_capstan
   end type capstan_type

contains

   function prediction_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('prediction')
      call suite%addTest(TestMethod('straight_line', test_line))
      call suite%addTest(TestMethod('no_interval', test_no_interval))
      call suite%addTest(TestMethod('hook_loads', test_hookloads))
      call suite%addTest(TestMethod('residuals_that_follow', test_succession))
      call suite%addTest(TestMethod('hook_loads_and_torques', test_both))
   end function prediction_suite

   subroutine evaluate_line(self, points, values, solved)
      class(line_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      integer :: p
      solved = .true.
      do p = 1, size(points, 2)
         values(:, p) = points(1, p) + points(2, p)*self%x
      end do
   end subroutine evaluate_line

   subroutine evaluate_capstan(self, points, values, solved)
      class(capstan_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      integer :: p
      solved = .true.
      do p = 1, size(points, 2)
         where (self%what == hookload)
            values(:, p) = self%weight*exp(points(1, p)*self%angle) + points(2, p)
         else where
            values(:, p) = 0.08_wp*points(1, p)*self%weight*self%angle
         end where
      end do
   end subroutine evaluate_capstan

   !> Fits a function and predicts another of the same unknowns.
   subroutine fit_and_predict(function, ahead, measured, what, of_ahead, start, scale, result)
      class(measured_function_type), intent(inout) :: function, ahead
      real(wp), intent(in) :: measured(:)
      integer, intent(in) :: what(:), of_ahead(:)
      real(wp), intent(in) :: start(:), scale(:)
      type(calibration_result_type), intent(out) :: result
      real(wp) :: deviation(size(measured)), ahead_deviation(size(of_ahead)), freedom(size(of_ahead))
      integer :: kinds(size(measured)), halvings, k
      kinds = 1
      if (any(what == hookload)) kinds = what
      do k = hookload, torque
         if (any(what == k)) where (what == k) deviation = 0.02_wp*sum(abs(measured), mask=what == k)/count(what == k)
      end do
      call fit_by_kinds(function, start, spread(.true., 1, size(start)), -1.0e3_wp*scale, 1.0e3_wp*scale, scale, measured, kinds, &
                        deviation, result%fit, halvings)
      call judge_fit(result, measured, deviation, kinds, what)
      do k = hookload, torque
         where (of_ahead == k)
            ahead_deviation = result%deviations(k)
            freedom = result%freedoms(k)
         end where
      end do
      call predict(ahead, result%fit, result%statistics, scale, ahead_deviation, freedom, result%prediction)
   end subroutine fit_and_predict

   !> Five points, by hand: x mean 3, S_xx 10, slope 0.95, intercept 1.11, s^2 = 0.0470/3; at x = 8 half the interval is
   !> t s sqrt(1 + 1/5 + 25/10), t = 3.1824 with three degrees of freedom.
   subroutine test_line()
      type(line_type) :: known, ahead
      type(calibration_result_type) :: result
      real(wp), parameter :: y(5) = [2.1_wp, 2.9_wp, 4.1_wp, 4.8_wp, 5.9_wp], t = 3.182446305_wp
      real(wp) :: s
      known%x = [1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp]
      ahead%x = [8.0_wp, 3.0_wp]
      call fit_and_predict(known, ahead, y, spread(hookload, 1, 5), spread(hookload, 1, 2), [0.0_wp, 0.5_wp], [1.0_wp, 1.0_wp], &
                           result)
      call assertEqual(fit_done, result%fit%status)
      call assertRelativelyEqual(1.11_wp + 0.95_wp*8.0_wp, result%prediction%values(1), 1.0e-6_wp)
      s = sqrt(sum((y - 1.11_wp - 0.95_wp*known%x)**2)/3.0_wp)
      call assertRelativelyEqual(3.0_wp, result%freedoms(hookload), 1.0e-6_wp)
      call assertRelativelyEqual(t*s*sqrt(1.0_wp + 0.2_wp + 2.5_wp), result%prediction%half_width(1), 1.0e-5_wp)
      call assertRelativelyEqual(t*s*sqrt(1.2_wp), result%prediction%half_width(2), 1.0e-5_wp)
   end subroutine test_line

   !> Of a kind that was not measured nobody knows the scatter; two points on a line have none.
   subroutine test_no_interval()
      type(line_type) :: known, ahead
      type(calibration_result_type) :: result
      known%x = [1.0_wp, 2.0_wp, 4.0_wp]
      ahead%x = [8.0_wp, 8.0_wp]
      call fit_and_predict(known, ahead, [1.0_wp, 2.1_wp, 4.2_wp], spread(hookload, 1, 3), [hookload, torque], [0.0_wp, 0.5_wp], &
                           [1.0_wp, 1.0_wp], result)
      call assertTrue(.not. is_missing(result%prediction%half_width(1)))
      call assertTrue(is_missing(result%prediction%half_width(2)))
      call assertTrue(.not. is_missing(result%prediction%values(2)))
      known%x = [1.0_wp, 2.0_wp]
      call fit_and_predict(known, ahead, [1.0_wp, 2.1_wp], spread(hookload, 1, 2), [hookload, hookload], [0.0_wp, 0.5_wp], &
                           [1.0_wp, 1.0_wp], result)
      call assertTrue(is_missing(result%prediction%half_width(1)))
   end subroutine test_no_interval

   !> Share of measurements at deeper bits that lie in their intervals, over campaigns whose errors are normal.
   subroutine simulate(torques, seed, share)
      integer, intent(in) :: torques           !< measured values of torque beside eight hook loads
      integer, intent(in) :: seed
      real(wp), intent(out) :: share(2)        !< of hook loads, of torques
      type(capstan_type) :: known, ahead
      type(calibration_result_type) :: result
      real(wp), parameter :: noise(2) = [8.0_wp, 0.6_wp]
      real(wp), allocatable :: exact(:, :), exact_ahead(:, :), measured(:)
      logical, allocatable :: solved(:, :), solved_ahead(:, :)
      integer :: campaign, i, n, held(2), judged(2)
      n = 8 + torques
      known%weight = [(400.0_wp + 50.0_wp*(i - 1)/2, i=1, 8), (400.0_wp + 50.0_wp*i, i=1, torques)]
      known%angle = [(merge(1.0_wp, -1.0_wp, modulo(i, 2) == 1), i=1, 8), spread(1.0_wp, 1, torques)]
      known%what = [spread(hookload, 1, 8), spread(torque, 1, torques)]
      ahead%weight = [700.0_wp, 700.0_wp, 800.0_wp, 800.0_wp, 800.0_wp]
      ahead%angle = [1.2_wp, -1.2_wp, 1.2_wp, -1.2_wp, 1.2_wp]
      ahead%what = [hookload, hookload, hookload, hookload, torque]
      allocate (exact(n, 1), solved(n, 1), exact_ahead(5, 1), solved_ahead(5, 1))
      call known%evaluate(reshape([friction, block], [2, 1]), exact, solved)
      call ahead%evaluate(reshape([friction, block], [2, 1]), exact_ahead, solved_ahead)
      held = 0
      judged = 0
      do campaign = 1, campaigns
         measured = [(exact(i, 1) + noise(known%what(i))*normal_number(seed, campaign, 1, i), i=1, n)]
         call fit_and_predict(known, ahead, measured, known%what, ahead%what, [0.1_wp, 0.0_wp], [1.0_wp, 1.0e3_wp], result)
         if (result%fit%status /= fit_done) cycle
         do i = 1, size(ahead%what)
            associate (k => ahead%what(i), half => result%prediction%half_width(i))
               if (is_missing(half)) cycle
               judged(k) = judged(k) + 1
               if (abs(exact_ahead(i, 1) + noise(k)*normal_number(seed, campaign, 2, i) - result%prediction%values(i)) <= half) &
                  held(k) = held(k) + 1
            end associate
         end do
      end do
      share = missing
      where (judged > 0) share = real(held, wp)/real(max(judged, 1), wp)
   end subroutine simulate

   !> 95 % within four standard errors: those of a campaign's four values share its fit, so that they count as one.
   subroutine test_hookloads()
      real(wp) :: share(2)
      real(wp), parameter :: four_errors = 0.02_wp
      call simulate(0, 1, share)
      call assertEqual(0.95_wp, share(hookload), four_errors)
      call assertTrue(is_missing(share(torque)))
   end subroutine test_hookloads

   !> Ten of the same make a correlation of one. Independent residuals are told to follow in one of a hundred
   !> sets (here of 2000, within four standard
   !> errors), those of an error that stays for ten depths in most.
   subroutine test_succession()
      real(wp), parameter :: depths(20) = [1.0_wp, 3.0_wp, 2.0_wp, 5.0_wp, 4.0_wp, 6.0_wp, 7.0_wp, 8.0_wp, 9.0_wp, 10.0_wp, &
         1.0_wp, 3.0_wp, 2.0_wp, 5.0_wp, 4.0_wp, 6.0_wp, 7.0_wp, 8.0_wp, 9.0_wp, 10.0_wp]
      real(wp) :: residual(20), correlation, slow
      logical :: follows
      integer :: group(20), set, i, told(2)
      group = [spread(1, 1, 10), spread(2, 1, 10)]
      residual = 1.0_wp
      call find_succession(depths, group, residual, correlation, follows)
      call assertRelativelyEqual(1.0_wp, correlation, 1.0e-12_wp)
      call assertTrue(follows)
      residual = [0.0_wp, 3.0_wp, 2.0_wp, spread(0.0_wp, 1, 7), 4.0_wp, 0.0_wp, 5.0_wp, spread(0.0_wp, 1, 7)]
      ! 2 and 3 are neighbours, 4 and 5 are: 6 + 20 over 2 + 6.5 + 4.5 + 20.5 + 12.5
      call find_succession(depths, group, residual, correlation, follows)
      call assertRelativelyEqual(26.0_wp/46.0_wp, correlation, 1.0e-12_wp)
      told = 0
      do set = 1, campaigns
         residual = [(normal_number(3, set, 1, i), i=1, 20)]
         call find_succession(depths, group, residual, correlation, follows)
         if (follows) told(1) = told(1) + 1
         slow = 2.0_wp*normal_number(3, set, 2, 1)
         residual(:10) = residual(:10) + slow
         residual(11:) = residual(11:) - slow
         call find_succession(depths, group, residual, correlation, follows)
         if (follows) told(2) = told(2) + 1
      end do
      call assertEqual(0.01_wp, told(1)/real(campaigns, wp), 0.009_wp)
      call assertTrue(told(2) > campaigns/2)
   end subroutine test_succession

   subroutine test_both()
      real(wp) :: share(2)
      call simulate(4, 2, share)
      call assertGreaterThan(share(hookload), 0.90_wp)
      call assertLessThan(share(hookload), 0.98_wp)
      call assertGreaterThan(share(torque), 0.90_wp)
      call assertLessThan(share(torque), 0.98_wp)
   end subroutine test_both
end module dg_test_prediction
