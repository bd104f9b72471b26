!> Intervals of single measurements that a fit has not seen: of a straight line by the textbook's formula, of hook loads and
!> torques in simulated campaigns by how many they hold.
module dg_test_prediction
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_calibration_result, only: calibration_result_type, judge_fit
   use dg_counter_random, only: normal_number
   use dg_depth_correlation, only: find_succession, succession_type
   use dg_fit_by_kinds, only: fit_by_kinds
   use dg_kinds, only: wp
   use dg_least_squares, only: fit_done, measured_function_type, unknowns_type
   use dg_missing, only: is_missing, missing
   use dg_prediction, only: predict
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
      call suite%addTest(TestMethod('mean_of_errors_that_follow', test_mean))
      call suite%addTest(TestMethod('twice_as_deep', test_twice_as_deep))
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
   subroutine fit_and_predict(function, ahead, measured, what, of_ahead, scale, depth, group, result)
      class(measured_function_type), intent(inout) :: function, ahead
      real(wp), intent(in) :: measured(:)
      integer, intent(in) :: what(:), of_ahead(:)
      real(wp), intent(in) :: scale(:)
      real(wp), intent(in) :: depth(:)     !< of what was measured
      integer, intent(in) :: group(:)      !< that follow each other along the depth
      type(calibration_result_type), intent(out) :: result
      real(wp) :: deviation(size(measured)), ahead_deviation(size(of_ahead)), freedom(size(of_ahead))
      integer :: kinds(size(measured)), halvings, k
      kinds = 1
      if (any(what == hookload)) kinds = what
      do k = hookload, torque
         if (any(what == k)) where (what == k) deviation = 0.02_wp*sum(abs(measured), mask=what == k)/count(what == k)
      end do
      call fit_by_kinds(function, unknowns_type(0.1_wp*scale, spread(.true., 1, size(scale)), -1.0e3_wp*scale, &
                                                1.0e3_wp*scale, scale), measured, kinds, deviation, result%fit, halvings)
      call judge_fit(result, measured, deviation, kinds, what, depth, group)
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
      call fit_and_predict(known, ahead, y, spread(hookload, 1, 5), spread(hookload, 1, 2), [1.0_wp, 1.0_wp], known%x, &
                           spread(1, 1, 5), result)
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
      call fit_and_predict(known, ahead, [1.0_wp, 2.1_wp, 4.2_wp], spread(hookload, 1, 3), [hookload, torque], &
                           [1.0_wp, 1.0_wp], known%x, [1, 1, 1], result)
      call assertTrue(.not. is_missing(result%prediction%half_width(1)))
      call assertTrue(is_missing(result%prediction%half_width(2)))
      call assertTrue(.not. is_missing(result%prediction%values(2)))
      known%x = [1.0_wp, 2.0_wp]
      call fit_and_predict(known, ahead, [1.0_wp, 2.1_wp], spread(hookload, 1, 2), [hookload, hookload], &
                           [1.0_wp, 1.0_wp], known%x, [1, 1], result)
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
         call fit_and_predict(known, ahead, measured, known%what, ahead%what, [1.0_wp, 1.0e3_wp], known%weight, &
                              known%what + merge(2, 0, known%angle > 0.0_wp), result)
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

   !> Ten of the same make a correlation of one. Independent residuals are told to follow in one of a hundred sets (here of 2000,
   !> within four standard errors), those of an error that stays for ten depths in most. Where nothing was fitted errors are as
   !> alike as residuals.
   subroutine test_succession()
      real(wp), parameter :: depths(20) = [1.0_wp, 3.0_wp, 2.0_wp, 5.0_wp, 4.0_wp, 6.0_wp, 7.0_wp, 8.0_wp, 9.0_wp, 10.0_wp, &
         1.0_wp, 3.0_wp, 2.0_wp, 5.0_wp, 4.0_wp, 6.0_wp, 7.0_wp, 8.0_wp, 9.0_wp, 10.0_wp]
      type(succession_type) :: succession
      real(wp) :: residual(20), slow, nothing(20, 0)
      integer :: group(20), set, i, told(2)
      group = [spread(1, 1, 10), spread(2, 1, 10)]
      residual = 1.0_wp
      call find_succession(nothing, residual, depths, group, succession)
      call assertRelativelyEqual(1.0_wp, succession%observed, 1.0e-12_wp)
      call assertTrue(succession%follows)
      residual = [0.0_wp, 3.0_wp, 2.0_wp, spread(0.0_wp, 1, 7), 4.0_wp, 0.0_wp, 5.0_wp, spread(0.0_wp, 1, 7)]
      ! 2 and 3 are neighbours, 4 and 5 are: 6 + 20 over 2 + 6.5 + 4.5 + 20.5 + 12.5
      call find_succession(nothing, residual, depths, group, succession)
      call assertRelativelyEqual(26.0_wp/46.0_wp, succession%observed, 1.0e-12_wp)
      call assertEqual(26.0_wp/46.0_wp, succession%correlation, 1.0e-4_wp)
      told = 0
      do set = 1, campaigns
         residual = [(normal_number(3, set, 1, i), i=1, 20)]
         call find_succession(nothing, residual, depths, group, succession)
         if (succession%follows) told(1) = told(1) + 1
         slow = 2.0_wp*normal_number(3, set, 2, 1)
         residual(:10) = residual(:10) + slow
         residual(11:) = residual(11:) - slow
         call find_succession(nothing, residual, depths, group, succession)
         if (succession%follows) told(2) = told(2) + 1
      end do
      call assertEqual(0.01_wp, told(1)/real(campaigns, wp), 0.009_wp)
      call assertTrue(told(2) > campaigns/2)
   end subroutine test_succession

   !> The mean of n errors that follow each other has the variance s^2 v, v = (n + 2 sum (n - k) r^k)/n^2, and squares about it have
   !> the expectation s^2 n (1 - v): textbook formulas of a first-order autoregressive process.
   subroutine test_mean()
      type(line_type) :: known, ahead
      type(calibration_result_type) :: result
      integer, parameter :: n = 14
      real(wp), parameter :: y(n) = [1.0_wp, 2.0_wp, 2.5_wp, 2.0_wp, 1.0_wp, -1.0_wp, -2.0_wp, -1.5_wp, -1.0_wp, 0.5_wp, 1.0_wp, &
         1.5_wp, 1.0_wp, -0.5_wp]
      real(wp) :: r, v, variance
      integer :: k
      known%x = spread(0.0_wp, 1, n)
      ahead%x = [0.0_wp]
      call fit_and_predict(known, ahead, y, spread(hookload, 1, n), [hookload], [1.0_wp, 1.0_wp], [(100.0_wp*k, k=1, n)], &
                           spread(1, 1, n), result)
      r = result%succession%correlation
      call assertGreaterThan(r, result%succession%observed)
      v = (n + 2.0_wp*sum([((n - k)*r**k, k=1, n - 1)]))/n**2
      variance = sum((y - sum(y)/n)**2)/(n*(1.0_wp - v))
      call assertRelativelyEqual(sqrt(variance), result%deviations(hookload), 1.0e-6_wp)
      call assertRelativelyEqual(sqrt(v*variance), result%statistics%deviation(1), 1.0e-6_wp)
      call assertGreaterThan(result%freedoms(hookload), 1.0_wp)
      call assertLessThan(result%freedoms(hookload), 6.0_wp)
   end subroutine test_mean

   !> Share of 26 or 39 values at twice the depths that lie in intervals made from the upper half; errors of an operation follow
   !> each other by `correlation`. `known_independent`: as if they did not.
   subroutine simulate_deep(depths, operations, correlation, known_independent, share, width)
      integer, intent(in) :: depths, operations
      real(wp), intent(in) :: correlation
      logical, intent(in) :: known_independent
      real(wp), intent(out) :: share, width    !< width: median of the mean half of an interval
      type(capstan_type) :: string, known, ahead
      type(calibration_result_type) :: result
      real(wp), allocatable :: exact(:, :), error(:), depth(:)
      logical, allocatable :: solved(:, :), upper(:)
      integer, allocatable :: group(:)
      real(wp) :: widths(campaigns/4)
      real(wp), parameter :: noise = 8.0_wp
      integer :: campaign, i, n
      n = 2*depths*operations
      depth = [(real(modulo(i - 1, 2*depths) + 1, wp)/depths, i=1, n)]
      group = [((i - 1)/(2*depths) + 1, i=1, n)]
      string%weight = 200.0_wp + 200.0_wp*depth
      string%angle = [(-real(group(i) - 2, wp)*max(depth(i) - 0.3_wp, 0.0_wp), i=1, n)]      ! up, rotating, down
      if (operations == 2) string%angle = [((3 - 2*group(i))*max(depth(i) - 0.3_wp, 0.0_wp), i=1, n)]
      string%what = spread(hookload, 1, n)
      upper = depth < 1.0_wp + 0.5_wp/depths
      known%weight = pack(string%weight, upper)
      known%angle = pack(string%angle, upper)
      known%what = pack(string%what, upper)
      ahead%weight = pack(string%weight, .not. upper)
      ahead%angle = pack(string%angle, .not. upper)
      ahead%what = pack(string%what, .not. upper)
      allocate (exact(n, 1), solved(n, 1), error(n))
      call string%evaluate(reshape([friction, block], [2, 1]), exact, solved)
      share = 0.0_wp
      do campaign = 1, size(widths)
         do i = 1, n
            error(i) = normal_number(5, campaign, 1, i)
            if (modulo(i - 1, 2*depths) > 0) error(i) = correlation*error(i - 1) + sqrt(1.0_wp - correlation**2)*error(i)
         end do
         error = exact(:, 1) + noise*error
         if (known_independent) group = [(i, i=1, n)]
         call fit_and_predict(known, ahead, pack(error, upper), known%what, ahead%what, [1.0_wp, 1.0e3_wp], pack(depth, upper), &
                              pack(group, upper), result)
         call assertEqual(fit_done, result%fit%status)
         share = share + count(abs(pack(error, .not. upper) - result%prediction%values) <= result%prediction%half_width)/ &
                 real(size(ahead%what)*size(widths), wp)
         widths(campaign) = sum(result%prediction%half_width)/size(ahead%what)
      end do
      width = middle(widths)
   end subroutine simulate_deep

   pure function middle(numbers) result(median)
      real(wp), intent(in) :: numbers(:)
      real(wp) :: median
      integer :: i
      median = numbers(1)
      do i = 1, size(numbers)
         if (count(numbers < numbers(i)) == size(numbers)/2) median = numbers(i)
      end do
   end function middle

   !> Intervals made from the upper half of a well for the lower: of independent errors they hold 95 % and are hardly wider for not
   !> knowing it; of errors that follow each other by 0.8 they hold 90 % and more, where intervals that know nothing of it hold 80.
   subroutine test_twice_as_deep()
      real(wp) :: share, width, unknowing_share, unknowing_width
      integer :: operations
      integer, parameter :: depths(3) = [20, 8, 13]
      do operations = 2, 3
         call simulate_deep(depths(operations), operations, 0.0_wp, .false., share, width)
         call simulate_deep(depths(operations), operations, 0.0_wp, .true., unknowing_share, unknowing_width)
         call assertGreaterThan(share, 0.90_wp)
         call assertLessThan(share, 0.98_wp)
         call assertLessThan(width, 1.1_wp*unknowing_width)
         call simulate_deep(depths(operations), operations, 0.8_wp, .false., share, width)
         call simulate_deep(depths(operations), operations, 0.8_wp, .true., unknowing_share, unknowing_width)
         call assertGreaterThan(share, 0.90_wp)
         call assertLessThan(unknowing_share, 0.85_wp)
      end do
   end subroutine test_twice_as_deep

   subroutine test_both()
      real(wp) :: share(2)
      call simulate(4, 2, share)
      call assertGreaterThan(share(hookload), 0.90_wp)
      call assertLessThan(share(hookload), 0.98_wp)
      call assertGreaterThan(share(torque), 0.90_wp)
      call assertLessThan(share(torque), 0.98_wp)
   end subroutine test_both
end module dg_test_prediction
