!> Calibration: least squares with known answers, intervals against regression by hand and against tables of Student's
!> distribution, factors that data cannot tell apart, and how unknowns are laid out.
module dg_test_calibration
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_calibration, only: calibration_type, calibrate_friction, calibrate_friction_axial, factors_of_deck, offset_depths, &
      set_data, set_unknowns, tells, with_factors, apply_factors
   use dg_fit_statistics, only: find_statistics, statistics_type, student_quantile
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_least_squares, only: fit_done, fit_from_less, fit_least_squares, fit_type, fit_without_values, &
                               measured_function_type, unknowns_type
   use dg_load_case, only: load_case_type, operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_contact_friction, only: axial_friction
   use dg_missing, only: given, is_missing
   implicit none
   private
   public :: calibration_suite

   !> A function of two unknowns at given places: kind 'line' a + b x, 'decay' a exp(-b x), 'sum' a + b, alike everywhere.
   type, extends(measured_function_type) :: curve_type
      character(5) :: kind = 'line'
      real(wp), allocatable :: x(:)
      real(wp) :: lost_above = huge(1.0_wp)    !< no value where b is greater
   contains
      procedure :: evaluate
   end type curve_type

   real(wp), parameter :: round_off = 1.0e-10_wp
   !> Fits end at steps of 1e-7 of the scale; differences over 1e-3 of it make the last steps contract slowly.
   real(wp), parameter :: at_rest = 1.0e-6_wp

contains

   function calibration_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('calibration')
      call suite%addTest(TestMethod('student', test_student))
      call suite%addTest(TestMethod('straight_line', test_line))
      call suite%addTest(TestMethod('exponential', test_decay))
      call suite%addTest(TestMethod('no_scatter', test_no_scatter))
      call suite%addTest(TestMethod('bound', test_bound))
      call suite%addTest(TestMethod('not_separated', test_mixture))
      call suite%addTest(TestMethod('not_felt', test_unfelt))
      call suite%addTest(TestMethod('without_values', test_lost))
      call suite%addTest(TestMethod('lost_on_one_side', test_lost_on_one_side))
      call suite%addTest(TestMethod('from_less', test_from_less))
      call suite%addTest(TestMethod('unknowns', test_unknowns))
      call suite%addTest(TestMethod('data_and_weights', test_data))
   end function calibration_suite

   subroutine evaluate(self, points, values, solved)
      class(curve_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      integer :: p
      do p = 1, size(points, 2)
         select case (self%kind)
         case ('line'); values(:, p) = points(1, p) + points(2, p)*self%x
         case ('decay'); values(:, p) = points(1, p)*exp(-points(2, p)*self%x)
         case default; values(:, p) = points(1, p) + points(2, p)
         end select
         solved(:, p) = points(2, p) <= self%lost_above
      end do
   end subroutine evaluate

   !> Table of Student's distribution, 0.975: Abramowitz & Stegun (1964), table 26.10.
   subroutine test_student()
      integer, parameter :: freedom(6) = [1, 2, 5, 10, 30, 1000000]
      real(wp), parameter :: quantiles(6) = [12.706_wp, 4.303_wp, 2.571_wp, 2.228_wp, 2.042_wp, 1.960_wp]
      real(wp), parameter :: printed = 6.0e-4_wp
      integer :: i
      do i = 1, size(freedom)
         call assertEqual(quantiles(i), student_quantile(0.975_wp, freedom(i)), printed)
      end do
      call assertEqual(0.0_wp, student_quantile(0.5_wp, 3), round_off)
   end subroutine test_student

   !> Regression by hand of (0, 1), (1, 3), (2, 4), (3, 8): b = 2.2, a = 0.7, squares 1.8, s^2 = 0.9,
   !> var(b) = s^2/5, var(a) = s^2 (1/4 + 1.5^2/5), cov/(dev dev) = -1.5/sqrt(3.5).
   subroutine test_line()
      type(curve_type) :: curve
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      real(wp), parameter :: y(4) = [1.0_wp, 3.0_wp, 4.0_wp, 8.0_wp], deviation(4) = 0.5_wp
      curve%x = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp]
      call fit_least_squares(curve, [5.0_wp, -5.0_wp], [-100.0_wp, -100.0_wp], [100.0_wp, 100.0_wp], [1.0_wp, 1.0_wp], y, &
                             deviation, fit)
      call assertEqual(fit_done, fit%status)
      call assertEqual(0.7_wp, fit%unknowns(1), at_rest)
      call assertEqual(2.2_wp, fit%unknowns(2), at_rest)
      call find_statistics(fit%jacobian, (fit%values - y)/deviation, [.true., .true.], spread(1, 1, size(y)), statistics)
      call assertEqual(2, statistics%freedom)
      call assertRelativelyEqual(sqrt(0.9_wp)/0.5_wp, statistics%scatter, at_rest)
      call assertRelativelyEqual(sqrt(0.9_wp/5.0_wp), statistics%deviation(2), at_rest)
      call assertRelativelyEqual(sqrt(0.9_wp*(0.25_wp + 0.45_wp)), statistics%deviation(1), at_rest)
      call assertRelativelyEqual(student_quantile(0.975_wp, 2)*sqrt(0.18_wp), statistics%half_width(2), at_rest)
      call assertEqual(-1.5_wp/sqrt(3.5_wp), statistics%correlation(1, 2), at_rest)
      call assertEqual(0, size(statistics%mixtures), message='columns at 37 deg to each other are told apart')
      call find_statistics(fit%jacobian, (fit%values - y)/deviation, [.true., .true.], spread(0, 1, size(y)), statistics)
      call assertRelativelyEqual(sqrt(0.25_wp/5.0_wp), statistics%deviation(2), at_rest, message='deviations that are known')
   end subroutine test_line

   !> Values without error give back what made them, from far away.
   subroutine test_decay()
      type(curve_type) :: curve
      type(fit_type) :: fit
      curve%kind = 'decay'
      curve%x = [0.0_wp, 0.5_wp, 1.0_wp, 2.0_wp]
      call fit_least_squares(curve, [1.0_wp, 0.1_wp], [0.0_wp, 0.0_wp], [100.0_wp, 10.0_wp], [1.0_wp, 1.0_wp], &
                             7.0_wp*exp(-1.5_wp*curve%x), spread(0.1_wp, 1, 4), fit)
      call assertEqual(fit_done, fit%status)
      call assertEqual(7.0_wp, fit%unknowns(1), at_rest)
      call assertEqual(1.5_wp, fit%unknowns(2), at_rest)
   end subroutine test_decay

   !> Data that are met to round-off, as copies of one reading are, tell nothing of their error: no interval of width zero. With a
   !> deviation that is known there is one.
   subroutine test_no_scatter()
      type(statistics_type) :: statistics
      real(wp) :: jacobian(3, 1)
      jacobian = 2.0_wp
      call find_statistics(jacobian, spread(1.0e-9_wp, 1, 3), [.true.], [1, 1, 1], statistics)
      call assertTrue(is_missing(statistics%half_width(1)))
      call assertTrue(is_missing(statistics%deviation(1)))
      call find_statistics(jacobian, spread(1.0e-9_wp, 1, 3), [.true.], [0, 0, 0], statistics)
      call assertEqual(1.0_wp/sqrt(12.0_wp), statistics%deviation(1), round_off)
   end subroutine test_no_scatter

   !> A slope that wants to be -1 and may not fall below 0: the mean is then the best constant.
   subroutine test_bound()
      type(curve_type) :: curve
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      real(wp), parameter :: y(3) = [2.0_wp, 1.0_wp, 0.0_wp], deviation(3) = 1.0_wp
      curve%x = [0.0_wp, 1.0_wp, 2.0_wp]
      call fit_least_squares(curve, [0.0_wp, 3.0_wp], [-10.0_wp, 0.0_wp], [10.0_wp, 10.0_wp], [1.0_wp, 1.0_wp], y, deviation, fit)
      call assertEqual(fit_done, fit%status)
      call assertEqual(1.0_wp, fit%unknowns(1), at_rest)
      call assertEqual(0.0_wp, fit%unknowns(2))
      call assertTrue(fit%at_bound(2))
      call assertFalse(fit%at_bound(1))
      call find_statistics(fit%jacobian, fit%values - y, .not. fit%at_bound, [1, 1, 1], statistics)
      call assertTrue(is_missing(statistics%half_width(2)), message='no interval at a bound')
      call assertEqual(2, statistics%freedom)
   end subroutine test_bound

   !> Only the sum of two unknowns is measured: it is met, they are named as mixed, no interval is made up.
   subroutine test_mixture()
      type(curve_type) :: curve
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      real(wp), parameter :: y(3) = [3.0_wp, 3.1_wp, 2.9_wp], deviation(3) = 0.1_wp
      curve%kind = 'sum'
      curve%x = [0.0_wp, 1.0_wp, 2.0_wp]
      call fit_least_squares(curve, [0.0_wp, 0.0_wp], [-10.0_wp, -10.0_wp], [10.0_wp, 10.0_wp], [1.0_wp, 1.0_wp], y, &
                             deviation, fit)
      call assertEqual(fit_done, fit%status)
      call assertEqual(3.0_wp, sum(fit%unknowns), at_rest)
      call find_statistics(fit%jacobian, (fit%values - y)/deviation, [.true., .true.], spread(1, 1, size(y)), statistics)
      call assertEqual(1, size(statistics%mixtures))
      call assertEqual(2, size(statistics%mixtures(1)%unknowns))
      call assertTrue(all(is_missing(statistics%half_width)))
      ! a slope over a short range far away mixes with the constant, yet has an interval
      curve%kind = 'line'
      curve%x = [100.0_wp, 101.0_wp, 102.0_wp]
      call fit_least_squares(curve, [0.0_wp, 0.0_wp], [-1.0e4_wp, -1.0e4_wp], [1.0e4_wp, 1.0e4_wp], [1.0_wp, 1.0_wp], &
                             y, deviation, fit)
      call find_statistics(fit%jacobian, (fit%values - y)/deviation, [.true., .true.], spread(1, 1, size(y)), statistics)
      call assertEqual(1, size(statistics%mixtures))
      call assertFalse(is_missing(statistics%half_width(2)))
   end subroutine test_mixture

   !> Places where x is 0 say nothing of the slope: it stays.
   subroutine test_unfelt()
      type(curve_type) :: curve
      type(fit_type) :: fit
      curve%x = [0.0_wp, 0.0_wp]
      call fit_least_squares(curve, [0.0_wp, 0.3_wp], [0.0_wp, 0.0_wp], [10.0_wp, 10.0_wp], [1.0_wp, 1.0_wp], &
                             [1.0_wp, 2.0_wp], [0.1_wp, 0.1_wp], fit)
      call assertEqual(fit_done, fit%status)
      call assertTrue(fit%unfelt(2))
      call assertEqual(0.3_wp, fit%unknowns(2))
      call assertEqual(1.5_wp, fit%unknowns(1), at_rest)
   end subroutine test_unfelt

   !> A trial without value is a step too long; a start without value is no fit, and says which datum.
   subroutine test_lost()
      type(curve_type) :: curve
      type(fit_type) :: fit
      curve%kind = 'decay'
      curve%x = [0.0_wp, 0.5_wp, 1.0_wp, 2.0_wp]
      curve%lost_above = 1.6_wp
      call fit_least_squares(curve, [1.0_wp, 0.1_wp], [0.0_wp, 0.0_wp], [100.0_wp, 10.0_wp], [1.0_wp, 1.0_wp], &
                             7.0_wp*exp(-1.5_wp*curve%x), spread(0.1_wp, 1, 4), fit)
      call assertEqual(fit_done, fit%status)
      call assertEqual(1.5_wp, fit%unknowns(2), at_rest)
      call fit_least_squares(curve, [1.0_wp, 1.7_wp], [0.0_wp, 0.0_wp], [100.0_wp, 10.0_wp], [1.0_wp, 1.0_wp], &
                             7.0_wp*exp(-1.5_wp*curve%x), spread(0.1_wp, 1, 4), fit)
      call assertEqual(fit_without_values, fit%status)
      call assertEqual(1, fit%lost)
   end subroutine test_lost

   !> One unknown begins at its bound, the other where there are values on one side only: both are found all the same.
   subroutine test_lost_on_one_side()
      type(curve_type) :: curve
      type(fit_type) :: fit
      curve%x = [0.0_wp, 1.0_wp, 2.0_wp]
      curve%lost_above = 0.5_wp
      call fit_least_squares(curve, [0.0_wp, 0.5_wp], [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp], [1.0_wp, 1.0_wp], &
                             [0.0_wp, 0.2_wp, 0.4_wp], [0.1_wp, 0.1_wp, 0.1_wp], fit)
      call assertEqual(fit_done, fit%status)
      call assertFalse(any(fit%unfelt), message='the data feel both')
      call assertEqual(0.0_wp, fit%unknowns(1), at_rest)
      call assertEqual(0.2_wp, fit%unknowns(2), at_rest)
   end subroutine test_lost_on_one_side

   !> An exponent of 5 has no value and neither has 2.5, 1.25 has: the fit begins there, the other unknown where it was. From 100
   !> not even a sixteenth has one.
   subroutine test_from_less()
      type(curve_type) :: curve
      type(fit_type) :: fit
      integer :: halvings
      curve%kind = 'decay'
      curve%x = [0.0_wp, 0.5_wp, 1.0_wp, 2.0_wp]
      curve%lost_above = 1.6_wp
      call fit_from_less(curve, unknowns_type([1.0_wp, 5.0_wp], [.false., .true.], [0.0_wp, 0.0_wp], [100.0_wp, 10.0_wp], &
                                              [1.0_wp, 1.0_wp]), 7.0_wp*exp(-1.5_wp*curve%x), spread(0.1_wp, 1, 4), fit, halvings)
      call assertEqual(fit_done, fit%status)
      call assertEqual(2, halvings)
      call assertEqual([7.0_wp, 1.5_wp], fit%unknowns, 10.0_wp*at_rest)
      call fit_from_less(curve, unknowns_type([1.0_wp, 100.0_wp], [.false., .true.], [0.0_wp, 0.0_wp], [100.0_wp, 100.0_wp], &
                                              [1.0_wp, 1.0_wp]), 7.0_wp*exp(-1.5_wp*curve%x), spread(0.1_wp, 1, 4), fit, halvings)
      call assertEqual(fit_without_values, fit%status)
   end subroutine test_from_less

   !> Three cases, two sections; the second is reached by two of them.
   subroutine lay_out(calibration, cases, holes)
      type(calibration_type), intent(out) :: calibration
      type(load_case_type), intent(out) :: cases(4)
      type(hole_section_type), intent(out) :: holes(2)
      holes(1) = hole_section_type('cased', 0.0_wp, 500.0_wp, 0.22_wp, 0.2_wp, 0.25_wp)
      holes(2) = hole_section_type('open', 500.0_wp, 900.0_wp, 0.21_wp, 0.3_wp, 0.35_wp)
      cases%operation = [operation_trip_out, operation_trip_in, operation_trip_out, operation_rotate_off_bottom]
      cases%bit_depth = [400.0_wp, 900.0_wp, 900.0_wp, 900.0_wp]
      cases%measured_hookload = given([100.0e3_wp, 200.0e3_wp, 300.0e3_wp, 250.0e3_wp])
      cases(4)%measured_torque = given(8.0e3_wp)
      cases(3)%friction_axial = given(0.1_wp)
      calibration%cases = [1, 2, 3]
      calibration%holes = [1, 2]
      calibration%parameter = calibrate_friction_axial
   end subroutine lay_out

   !> The friction of trip_in is that which a case of trip_in has, and a calibration changes that which its cases have. Of three
   !> cases the second runs in, the third has a friction of its own.
   subroutine test_running_in(calibration, cases, holes)
      type(calibration_type), intent(in) :: calibration
      type(load_case_type), intent(in) :: cases(:)
      type(hole_section_type), intent(in) :: holes(:)
      type(hole_section_type), dimension(size(holes)) :: more, changed
      type(calibration_type) :: alone
      more = holes
      more(2)%friction_running_in = 0.5_wp
      call assertEqual([0.5_wp/3.0_wp, 0.3_wp], factors_of_deck(calibration, more, cases), round_off, message='of 0.5 and 0.1')
      changed = with_factors(calibration, more, cases(2), 2, [0.7_wp, 0.8_wp])
      call assertEqual(0.8_wp, axial_friction(changed(2), operation_trip_in), round_off)
      changed = with_factors(calibration, more, cases(3), 3, [0.7_wp, 0.8_wp])
      call assertEqual([0.7_wp, 0.8_wp], axial_friction(changed, operation_trip_out), round_off)
      alone = calibration
      alone%holes = [1]
      changed = with_factors(alone, more, cases(3), 3, [0.7_wp, 0.8_wp])
      call assertEqual(0.1_wp, axial_friction(changed(2), operation_trip_in), round_off, message='a load case overrides it')
      changed = more
      call apply_factors(calibration, [0.7_wp, 0.8_wp], [.true., .true.], cases, changed)
      call assertEqual([0.7_wp, 0.8_wp], changed%friction_axial, round_off)
      call assertEqual(0.8_wp, changed(2)%friction_running_in, round_off)
      alone = calibration
      alone%cases = [2]
      changed = more
      call apply_factors(alone, [0.7_wp, 0.8_wp], [.true., .true.], cases, changed)
      call assertEqual([0.7_wp, 0.3_wp], changed%friction_axial, round_off, message='trip_in alone says nothing of the other')
      call assertEqual(0.8_wp, changed(2)%friction_running_in, round_off)
      alone%cases = [1]
      changed = more
      call apply_factors(alone, [0.7_wp, 0.8_wp], [.true., .true.], cases, changed)
      call assertEqual(0.8_wp, changed(2)%friction_axial, round_off)
      call assertEqual(0.5_wp, changed(2)%friction_running_in, round_off, message='no case of trip_in')
   end subroutine test_running_in

   subroutine test_unknowns()
      type(calibration_type) :: calibration
      type(load_case_type) :: cases(4)
      type(hole_section_type) :: holes(2), changed(2)
      call lay_out(calibration, cases, holes)
      call set_unknowns(calibration, cases, holes)
      call set_data(calibration, cases)
      call assertEqual(2, size(calibration%unknowns))
      call assertEqual([1, 1, 1], calibration%unknown_of(:, 1))
      call assertEqual([0, 2, 2], calibration%unknown_of(:, 2), message='the bit at 400 m is not in the open hole')
      ! the third case overrides both sections: means of 0.2, 0.2, 0.1 and of 0.3, 0.1
      call assertEqual([0.5_wp/3.0_wp, 0.2_wp], factors_of_deck(calibration, holes, cases), round_off)
      changed = with_factors(calibration, holes, cases(3), 3, [0.7_wp, 0.8_wp])
      call assertEqual([0.7_wp, 0.8_wp], changed%friction_axial, round_off)
      call assertEqual([0.25_wp, 0.35_wp], changed%friction_rotary, round_off, message='not asked for')
      call test_running_in(calibration, cases, holes)
      calibration%by_hole = .false.
      calibration%by_operation = .true.
      calibration%by_depth = .true.
      calibration%offset = offset_depths
      call set_unknowns(calibration, cases, holes)
      call assertEqual(5, size(calibration%unknowns), message='three ways of moving at a depth, two offsets')
      call assertEqual([1, 2, 3], calibration%unknown_of(:, 1))
      call assertEqual([4, 5, 5], calibration%offset_of)
      call assertTrue(tells(calibration, cases, 1, 1))
      call assertFalse(tells(calibration, cases, 1, 2))
      call assertTrue(tells(calibration, cases, 2, 5))
   end subroutine test_unknowns

   !> Rotation: its hook load tells no friction, its torque does. Weights: 2 % of the mean where nothing is given.
   subroutine test_data()
      type(calibration_type) :: calibration
      type(load_case_type) :: cases(4)
      type(hole_section_type) :: holes(2)
      call lay_out(calibration, cases, holes)
      calibration%cases = [2, 4]
      calibration%parameter = calibrate_friction
      calibration%torque_deviation = given(500.0_wp)
      call set_unknowns(calibration, cases, holes)
      call set_data(calibration, cases)
      call assertEqual(3, size(calibration%data))
      call assertEqual([0.02_wp*225.0e3_wp, 0.02_wp*225.0e3_wp, 500.0_wp], calibration%data%deviation, round_off*1.0e3_wp)
      call assertTrue(tells(calibration, cases, 1, 1))
      call assertFalse(tells(calibration, cases, 2, 1))
      call assertTrue(tells(calibration, cases, 3, 1))
   end subroutine test_data
end module dg_test_calibration
