!> Monte Carlo: the generator against its authors' known answers and the normal distribution, quantiles, what a sample draws,
!> and propagation in closed form.
module dg_test_uncertainty
   use, intrinsic :: iso_fortran_env, only: int64
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: result_converged, result_locked_up, result_not_converged
   use dg_constants, only: degree, pi
   use dg_counter_random, only: normal_number, philox
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_trip_in, operation_trip_out
   use dg_missing, only: given, is_missing, missing
   use dg_model, only: model_type
   use dg_sample_statistics, only: distribution_type, find_distribution, find_point_statistics, p10, p50, p90, &
      point_statistics_type, quantile
   use dg_sampled_model, only: draw_model, draw_of, quantity_density, quantity_friction, quantity_hookload, &
      quantity_inclination
   use dg_soft_string_loads, only: soft_string_at
   use dg_sweep_result, only: sweep_result_type
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_uncertainty, only: correlation_of, friction_factor_of, piece_count, piece_number, uncertainty_type
   use dg_variance_shares, only: variance_shares
   implicit none
   private
   public :: uncertainty_suite

   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   function uncertainty_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('uncertainty')
      call suite%addTest(TestMethod('philox_known_answers', test_philox))
      call suite%addTest(TestMethod('normal_distribution', test_normal))
      call suite%addTest(TestMethod('numbers_are_independent', test_independent))
      call suite%addTest(TestMethod('quantiles', test_quantiles))
      call suite%addTest(TestMethod('what_a_sample_draws', test_draws))
      call suite%addTest(TestMethod('covariance_of_friction', test_factor))
      call suite%addTest(TestMethod('one_hole_in_ten_sections', test_sections))
      call suite%addTest(TestMethod('survey_angles', test_survey))
      call suite%addTest(TestMethod('points_and_gauge', test_points))
      call suite%addTest(TestMethod('shares_of_the_variance', test_shares))
      call suite%addTest(TestMethod('shares_of_few_samples', test_shares_of_few))
   end function uncertainty_suite

   !> Known answers for philox4x32-10 that come with Random123 (kat_vectors): nothing, all ones, digits of pi.
   subroutine test_philox()
      integer(int64), parameter :: ones = int(z'FFFFFFFF', int64)
      call check([0_int64, 0_int64, 0_int64, 0_int64], [0_int64, 0_int64], &
                 [int(z'6627E8D5', int64), int(z'E169C58D', int64), int(z'BC57AC4C', int64), int(z'9B00DBD8', int64)])
      call check([ones, ones, ones, ones], [ones, ones], &
                 [int(z'408F276D', int64), int(z'41C83B0E', int64), int(z'A20BC7C6', int64), int(z'6D5451FD', int64)])
      call check([int(z'243F6A88', int64), int(z'85A308D3', int64), int(z'13198A2E', int64), int(z'03707344', int64)], &
                 [int(z'A4093822', int64), int(z'299F31D0', int64)], &
                 [int(z'D16CFE09', int64), int(z'94FDCCEB', int64), int(z'5001E420', int64), int(z'24126EA1', int64)])
   contains
      subroutine check(counter, key, expected)
         integer(int64), intent(in) :: counter(4), key(2), expected(4)
         call assertTrue(all(philox(counter, key) == expected))
      end subroutine check
   end subroutine test_philox

   !> 100000 numbers: P10, P50, P90, mean and deviation of the normal distribution within four standard errors, which are
   !> sqrt(p (1 - p)/n)/density for quantiles, 1/sqrt(n) for the mean, 1/sqrt(2 n) for the deviation.
   subroutine test_normal()
      integer, parameter :: many = 100000
      real(wp), parameter :: quantile_90 = 1.2815515655446004_wp, errors = 4.0_wp
      real(wp), parameter :: density_90 = 0.17549833193248685_wp, density_50 = 0.3989422804014327_wp
      real(wp), parameter :: n = real(many, wp)
      type(distribution_type) :: found
      integer :: i
      found = find_distribution(normal_number(3, [(i, i=1, many)], 1, 0))
      call assertEqual(-quantile_90, found%quantiles(p10), errors*sqrt(0.09_wp/n)/density_90)
      call assertEqual(0.0_wp, found%quantiles(p50), errors*sqrt(0.25_wp/n)/density_50)
      call assertEqual(quantile_90, found%quantiles(p90), errors*sqrt(0.09_wp/n)/density_90)
      call assertEqual(0.0_wp, found%mean, errors/sqrt(n))
      call assertEqual(1.0_wp, found%deviation, errors/sqrt(2.0_wp*n))
      found = find_distribution(normal_number(3, 1, 1, [(i, i=0, many - 1)]))
      call assertEqual(1.0_wp, found%deviation, errors/sqrt(2.0_wp*n), message='along the index too')
   end subroutine test_normal

   !> Numbers of neighbouring samples, quantities, indices and seeds do not correlate: |r| < 4/sqrt(n).
   subroutine test_independent()
      integer, parameter :: many = 20000
      integer :: i, samples(many)
      real(wp) :: one(many)
      samples = [(i, i=1, many)]
      one = normal_number(1, samples, 1, 1)
      call uncorrelated(normal_number(1, samples + 1, 1, 1), 'samples')
      call uncorrelated(normal_number(1, samples, 2, 1), 'quantities')
      call uncorrelated(normal_number(1, samples, 1, 2), 'indices')
      call uncorrelated(normal_number(2, samples, 1, 1), 'seeds')
      call assertEqual(one(7), normal_number(1, 7, 1, 1), message='in any order')
   contains
      subroutine uncorrelated(other, what)
         real(wp), intent(in) :: other(:)
         character(*), intent(in) :: what
         call assertEqual(0.0_wp, dot_product(one, other)/(norm2(one)*norm2(other)), 4.0_wp/sqrt(real(many, wp)), message=what)
      end subroutine uncorrelated
   end subroutine test_independent

   !> By hand: 0, 10, ..., 100 in any order; one number; none.
   subroutine test_quantiles()
      type(distribution_type) :: found
      found = find_distribution([70.0_wp, 20.0_wp, 100.0_wp, 0.0_wp, 50.0_wp, 40.0_wp, 10.0_wp, 90.0_wp, 30.0_wp, 80.0_wp, 60.0_wp])
      call assertEqual([10.0_wp, 50.0_wp, 90.0_wp], found%quantiles, round_off*100.0_wp)
      call assertEqual(50.0_wp, found%mean, round_off*100.0_wp)
      call assertEqual(sqrt(1100.0_wp), found%deviation, round_off*100.0_wp)
      call assertEqual([1.25_wp], quantile([1.0_wp, 2.0_wp], [0.25_wp], 0, 0), round_off)
      call check_bounded([0.0_wp, 10.0_wp, 20.0_wp, 30.0_wp, 40.0_wp, 50.0_wp, 60.0_wp, 70.0_wp, 80.0_wp], 2, 0, &
                         [missing, 30.0_wp, 70.0_wp])
      call check_bounded([0.0_wp, 10.0_wp, 20.0_wp, 30.0_wp, 40.0_wp, 50.0_wp, 60.0_wp, 70.0_wp, 80.0_wp, 90.0_wp], 0, 1, &
                         [10.0_wp, 50.0_wp, 90.0_wp])
      call check_bounded([0.0_wp, 10.0_wp], 9, 0, [missing, missing, 0.0_wp])
      call check_bounded([0.0_wp, 10.0_wp], 1, 2, [missing, 10.0_wp, missing])
      found = find_distribution([3.0_wp])
      call assertEqual([3.0_wp, 3.0_wp, 3.0_wp], found%quantiles, round_off)
      call assertTrue(is_missing(found%deviation))
      found = find_distribution([real(wp) ::])
      call assertTrue(is_missing(found%quantiles(p50)))
   end subroutine test_quantiles

   !> Of eleven (five) numbers, some only known to lie below or above all: P10 is the second (between first and second), P50 the
   !> sixth (third), P90 the tenth (between fourth and fifth), where these are known. Mean and deviation are of those that are.
   subroutine check_bounded(numbers, below, above, expected)
      real(wp), intent(in) :: numbers(:)
      integer, intent(in) :: below, above
      real(wp), intent(in) :: expected(3)
      type(distribution_type) :: found
      integer :: k
      found = find_distribution(numbers, below, above)
      do k = 1, 3
         if (is_missing(expected(k))) then
            call assertTrue(is_missing(found%quantiles(k)), message='no number')
         else
            call assertEqual(expected(k), found%quantiles(k), round_off*100.0_wp)
         end if
      end do
      call assertEqual(sum(numbers)/size(numbers), found%mean, round_off*100.0_wp)
   end subroutine check_bounded

   !> Two sections, a survey through north in a vertical and an inclined part.
   subroutine build(model, uncertainty)
      type(model_type), intent(out) :: model
      type(uncertainty_type), intent(out) :: uncertainty
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, 300.0_wp, 600.0_wp], [0.0_wp, 0.0_wp, 60.0_wp]*degree, &
                          [0.0_wp, 0.0_wp, 0.0_wp], interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(2), model%strings(0), model%cases(0))
      model%holes(1) = hole_section_type('cased', 0.0_wp, 200.0_wp, 0.22_wp, 0.2_wp, 0.25_wp)
      model%holes(2) = hole_section_type('open', 200.0_wp, 600.0_wp, 0.21_wp, 0.3_wp, 0.35_wp)
      model%mud = standing_mud(1200.0_wp)
      uncertainty%range%models = [1]
      uncertainty%range%operations = [operation_trip_out, operation_trip_in]
      uncertainty%range%depths = [300.0_wp, 600.0_wp]
      allocate (uncertainty%range%frictions(1))
      uncertainty%samples = 50
      uncertainty%seed = 11
   end subroutine build

   !> Friction moves by the same number along and around, sections each by their own; nothing falls below zero; what is not
   !> asked for stays, and does not change with what is.
   subroutine test_draws()
      type(model_type) :: model, drawn
      type(uncertainty_type) :: uncertainty
      type(error_type), allocatable :: error
      real(wp) :: change(2)
      call build(model, uncertainty)
      uncertainty%friction_factor = reshape([0.01_wp, 0.0_wp, 0.0_wp, 0.01_wp], [2, 2])
      call draw_model(model, uncertainty, 7, drawn, error)
      change = drawn%holes%friction_axial - model%holes%friction_axial
      call assertEqual(0.01_wp*draw_of(uncertainty, 7, quantity_friction, [1, 2]), change, round_off)
      call assertEqual(change, drawn%holes%friction_rotary - model%holes%friction_rotary, round_off)
      call assertTrue(abs(change(1) - change(2)) > 1.0e-6_wp, message='sections are drawn apart')
      call assertEqual(1200.0_wp, drawn%mud%fluids(1)%density)
      uncertainty%density_deviation = 20.0_wp
      call draw_model(model, uncertainty, 7, drawn, error)
      call assertEqual(change, drawn%holes%friction_axial - model%holes%friction_axial, round_off)
      call assertTrue(abs(drawn%mud%fluids(1)%density - 1200.0_wp) > 1.0e-3_wp)
      uncertainty%friction_factor = 1.0e4_wp*uncertainty%friction_factor
      uncertainty%range%frictions(1) = given(0.15_wp)
      call draw_model(model, uncertainty, 7, drawn, error)
      call assertTrue(all(drawn%holes%friction_axial >= 0.0_wp))
      model%holes(2)%friction_running_in = 0.4_wp
      call draw_model(model, uncertainty, 7, drawn, error)
      call assertEqual(drawn%holes(2)%friction_axial, drawn%holes(2)%friction_running_in, round_off, message='0.15 holds for all')
      uncertainty%friction_factor = 1.0e-4_wp*uncertainty%friction_factor
      uncertainty%range%frictions(1)%present = .false.
      call draw_model(model, uncertainty, 7, drawn, error)
      call assertEqual(0.4_wp + change(2), drawn%holes(2)%friction_running_in, round_off, message='it moves with friction_axial')
      call assertEqual(0.3_wp + change(2), drawn%holes(2)%friction_axial, round_off)
      call assertTrue(is_missing(drawn%holes(1)%friction_running_in), message='that of friction_axial')
      uncertainty%range%frictions(1) = given(0.15_wp)
      deallocate (uncertainty%friction_factor)
      call draw_model(model, uncertainty, 7, drawn, error)
      call assertEqual([0.15_wp, 0.15_wp], drawn%holes%friction_rotary, round_off)
   end subroutine test_draws

   !> A result 3 f + 2 d + s^2 with a gauge of 1: f, d, s standard normal, the variance of s^2 is 2. In all 9 + 4 + 2 + 1 = 16.
   !> Of stations each on their own, what is left is the survey's; of 20,000 samples a share has a standard error of 0.5 %.
   subroutine test_shares()
      integer, parameter :: many = 20000
      type(uncertainty_type) :: uncertainty
      real(wp) :: values(many)
      integer :: samples(many), i
      uncertainty%samples = many
      uncertainty%friction_factor = reshape([0.05_wp], [1, 1])
      uncertainty%density_deviation = 10.0_wp
      uncertainty%inclination_deviation = 0.01_wp
      samples = [(i, i=1, many)]
      values = 3.0_wp*draw_of(uncertainty, samples, quantity_friction, 1) + &
               2.0_wp*draw_of(uncertainty, samples, quantity_density, 0) + draw_of(uncertainty, samples, quantity_inclination, 7)**2
      call assertEqual([9.0_wp, 4.0_wp, 2.0_wp, 1.0_wp, 0.0_wp]/16.0_wp, variance_shares(uncertainty, samples, values, 1.0_wp), &
                       0.02_wp)
      uncertainty%inclination_deviation = 0.0_wp
      call assertEqual([9.0_wp, 4.0_wp, 0.0_wp, 1.0_wp, 2.0_wp]/16.0_wp, variance_shares(uncertainty, samples, values, 1.0_wp), &
                       0.02_wp)
      call assertTrue(all(is_missing(variance_shares(uncertainty, samples(:20), values(:20), 1.0_wp))), message='few samples')
   end subroutine test_shares

   !> A result that is linear in friction of two sections has no rest, whatever variance and correlation few numbers have by chance:
   !> with 3 f + 2 d, too. A deviation that is round-off has no shares.
   subroutine test_shares_of_few()
      integer, parameter :: many = 60, seeds = 20
      real(wp), parameter :: weight = 7.0e5_wp
      type(uncertainty_type) :: uncertainty
      real(wp) :: values(many), shares(5), two(many)
      integer :: samples(many), i, seed
      samples = [(i, i=1, many)]
      uncertainty%samples = many
      uncertainty%friction_factor = reshape([0.05_wp, 0.0_wp, 0.0_wp, 0.05_wp], [2, 2])
      do seed = 1, seeds
         uncertainty%seed = seed
         two = 3.0_wp*draw_of(uncertainty, samples, quantity_friction, 1) + draw_of(uncertainty, samples, quantity_friction, 2)
         uncertainty%density_deviation = 0.0_wp
         shares = variance_shares(uncertainty, samples, weight + two, 0.0_wp)
         call assertEqual([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], shares, 1.0e-9_wp, message='friction alone')
         uncertainty%density_deviation = 10.0_wp
         values = two + 2.0_wp*draw_of(uncertainty, samples, quantity_density, 0)
         shares = variance_shares(uncertainty, samples, values, 0.0_wp)
         call assertEqual(0.0_wp, shares(5), round_off, message='nothing but friction and density')
         call assertEqual(1.0_wp, shares(1) + shares(2), round_off)
         shares = variance_shares(uncertainty, samples, weight + 1.0e-10_wp*values, 0.0_wp)
         call assertTrue(all(is_missing(shares)), message='round-off of 700 kN')
         call assertTrue(all(is_missing(variance_shares(uncertainty, samples, 1.0e-9_wp*values, 0.0_wp))), message='of zero')
      end do
   end subroutine test_shares_of_few

   !> Factors times their transpose are the covariance; one section goes by its own number; three correlations that no numbers can
   !> have are told.
   subroutine test_factor()
      real(wp), parameter :: deviations(3) = [0.01_wp, 0.02_wp, 0.04_wp], above(3) = [0.5_wp, -0.3_wp, 0.2_wp]
      real(wp) :: factor(3, 3), correlation(3, 3)
      logical :: regular
      integer :: i, j
      correlation = correlation_of(3, 1.0_wp, above)
      call assertEqual(-0.3_wp, correlation(3, 1))
      call friction_factor_of(deviations, correlation, factor, regular)
      call assertTrue(regular)
      do i = 1, 3
         do j = 1, 3
            call assertEqual(deviations(i)*deviations(j)*correlation(i, j), sum(factor(i, :)*factor(j, :)), round_off)
         end do
      end do
      call assertEqual(deviations(1), factor(1, 1), round_off)
      call friction_factor_of(deviations, correlation_of(3, 1.0_wp, [real(wp) ::]), factor, regular)
      call assertTrue(regular)
      call assertEqual(deviations, factor(:, 1), round_off)
      call assertEqual(0.0_wp, maxval(abs(factor(:, 2:))))
      call friction_factor_of(deviations, correlation_of(3, 1.0_wp, [0.9_wp, 0.9_wp, -0.9_wp]), factor, regular)
      call assertFalse(regular, message='first and second alike, third like both, but second and third unlike')
   end subroutine test_factor

   !> A straight hole at 60 deg, pulled: the hook load is linear in friction, its deviation w L sin(60) times that of the mean
   !> friction. One section and ten with correlation 1 give the same sample by sample; with correlation r the deviation is
   !> sqrt((1 + 9 r)/10) of it.
   subroutine test_sections()
      integer, parameter :: many = 3000, sections = 10
      real(wp), parameter :: deviation = 0.02_wp, length = 1000.0_wp, mass = 20.0_wp, correlations(3) = [0.0_wp, 0.5_wp, 1.0_wp]
      type(model_type) :: model, whole, drawn
      type(uncertainty_type) :: uncertainty
      type(error_type), allocatable :: error
      type(distribution_type) :: found
      real(wp) :: hookloads(many), one(many), axial(1), torque(1), expected
      logical :: regular
      integer :: i, k
      call build(model, uncertainty)
      call new_trajectory(model%trajectory, [0.0_wp, length], [60.0_wp, 60.0_wp]*degree, [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      model%mud = standing_mud(0.0_wp)
      deallocate (model%strings)
      allocate (model%strings(1))
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      model%strings(1)%components(1)%mass = mass
      model%strings(1)%components(1)%od = 0.127_wp
      model%strings(1)%components(1)%id = 0.1086_wp
      whole = model
      whole%holes = [hole_section_type('all', 0.0_wp, length, 0.2_wp, 0.25_wp, 0.25_wp)]
      model%holes = [(hole_section_type('part', 0.1_wp*(i - 1)*length, 0.1_wp*i*length, 0.2_wp, 0.25_wp, 0.25_wp), i=1, sections)]
      expected = deviation*mass*model%gravity*length*sin(60.0_wp*degree)
      uncertainty%friction_factor = reshape([deviation], [1, 1])
      do i = 1, many
         call draw_model(whole, uncertainty, i, drawn, error)
         one(i) = hookload()
      end do
      found = find_distribution(one)
      call assertRelativelyEqual(expected, found%deviation, 0.05_wp, message='one section')
      do k = 1, size(correlations)
         deallocate (uncertainty%friction_factor)
         allocate (uncertainty%friction_factor(sections, sections))
         call friction_factor_of(spread(deviation, 1, sections), correlation_of(sections, correlations(k), [real(wp) ::]), &
                                 uncertainty%friction_factor, regular)
         do i = 1, many
            call draw_model(model, uncertainty, i, drawn, error)
            hookloads(i) = hookload()
         end do
         found = find_distribution(hookloads)
         call assertRelativelyEqual(expected*sqrt((1.0_wp + 9.0_wp*correlations(k))/10.0_wp), found%deviation, 0.05_wp, &
                                    message='ten sections')
      end do
      call assertEqual(one, hookloads, 1.0e-3_wp, message='one factor for the whole hole, sample by sample')

   contains

      function hookload() result(force)
         real(wp) :: force
         drawn%cases(1)%name = 'case'
         drawn%cases(1)%section = ''
         drawn%cases(1)%string = 'main'
         drawn%cases(1)%bit_depth = length
         drawn%cases(1)%operation = operation_trip_out
         call soft_string_at(drawn, 1, [0.0_wp], axial, torque)
         force = axial(1)
      end function hookload
   end subroutine test_sections

   !> Systematic: all stations move alike, a vertical one to the side that the sign says. Random: each on its own, with the
   !> deviation asked for.
   subroutine test_survey()
      integer, parameter :: many = 4000
      real(wp), parameter :: deviation = 0.25_wp*degree
      type(model_type) :: model, drawn
      type(uncertainty_type) :: uncertainty
      type(error_type), allocatable :: error
      type(distribution_type) :: found
      real(wp) :: change(many), signed
      integer :: i
      call build(model, uncertainty)
      uncertainty%inclination_deviation = deviation
      uncertainty%systematic_survey = .true.
      do i = 1, 5
         call draw_model(model, uncertainty, i, drawn, error)
         call assertFalse(allocated(error))
         associate (well => drawn%trajectory)
            signed = well%inclination(3) - 60.0_wp*degree
            call assertEqual(abs(signed), well%inclination(1), round_off)
            call assertEqual(merge(0.0_wp, pi, signed > 0.0_wp), well%azimuth(1), round_off)
            call assertEqual(well%inclination(1), well%inclination(2), round_off)
         end associate
      end do
      uncertainty%systematic_survey = .false.
      do i = 1, many
         call draw_model(model, uncertainty, i, drawn, error)
         change(i) = drawn%trajectory%inclination(3) - 60.0_wp*degree
      end do
      found = find_distribution(change)
      call assertEqual(deviation, found%deviation, 4.0_wp*deviation/sqrt(2.0_wp*many))
      call assertEqual(0.0_wp, drawn%trajectory%azimuth(3), round_off, message='not asked for')
   end subroutine test_survey

   !> Pieces are numbered without gap; samples without solution are left out; the gauge adds its own scatter.
   subroutine test_points()
      type(model_type) :: model
      type(uncertainty_type) :: uncertainty
      type(sweep_result_type), allocatable :: pieces(:)
      type(point_statistics_type) :: found
      integer :: i
      call build(model, uncertainty)
      call assertEqual(200, piece_count(uncertainty))
      call assertEqual([1, 50, 51, 200], [piece_number(uncertainty, 1, 1), piece_number(uncertainty, 1, 50), &
                                          piece_number(uncertainty, 2, 1), piece_number(uncertainty, 4, 50)])
      allocate (pieces(200))
      pieces%status = result_converged
      pieces%hookload = [(1.0_wp*i, i=1, 200)]
      pieces(51:60)%status = result_not_converged
      found = find_point_statistics(uncertainty, 2, pieces)
      call assertEqual(40, found%solved)
      call assertEqual(80.5_wp, found%hookload%quantiles(p50), round_off*100.0_wp, message='of 61 to 100')
      call assertEqual([0, 10], [found%locked_up, found%not_converged])
      pieces(61:70)%status = result_locked_up
      found = find_point_statistics(uncertainty, 2, pieces)
      call assertEqual([30, 10, 10], [found%solved, found%locked_up, found%not_converged])
      call assertEqual(80.5_wp, found%hookload%quantiles(p50), round_off*100.0_wp, message='ten below 71 to 100')
      call assertTrue(is_missing(found%hookload%quantiles(p10)), message='a quarter locks up')
      call assertEqual(0.0_wp, found%torque%quantiles(p10), message='nothing turns')
      pieces%hookload = 5.0_wp
      uncertainty%hookload_deviation = 2.0_wp
      found = find_point_statistics(uncertainty, 1, pieces)
      call assertEqual(5.0_wp + 2.0_wp*sum(draw_of(uncertainty, [(i, i=1, 50)], quantity_hookload, 1))/50.0_wp, &
                       found%hookload%mean, round_off*10.0_wp)
      call assertEqual(0.0_wp, found%torque%deviation, round_off)
      call assertGreaterThan(found%hookload%quantiles(p90), found%hookload%quantiles(p10))
   end subroutine test_points
end module dg_test_uncertainty
