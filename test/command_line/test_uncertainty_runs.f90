!> Monte Carlo as a user runs it: propagation in closed form, the same file on any number of threads and in parts, refusals.
module dg_test_uncertainty_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_counter_random, only: normal_number
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_kinds, only: wp
   use dg_program_run, only: deck_path, results_path, run_deck_text, run_program, run_type, replaced
   use dg_result_rows, only: field, lines_of, number
   use dg_sample_statistics, only: distribution_type, find_distribution, p10, p50, p90
   use dg_sampled_model, only: quantity_friction, quantity_hookload
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: uncertainty_runs_suite

   character(*), parameter :: newline = achar(10)
   !> Numbers in files have ten digits.
   real(wp), parameter :: printed = 1.0e-8_wp
   integer, parameter :: samples = 4000
   character(*), parameter :: again = deck_path//' --output '//results_path//' '

contains

   function uncertainty_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('uncertainty_runs')
      call suite%addTest(TestMethod('linear_propagation', test_linear))
      call suite%addTest(TestMethod('gauge', test_gauge))
      call suite%addTest(TestMethod('threads_and_seeds', test_threads))
      call suite%addTest(TestMethod('parts', test_parts))
      call suite%addTest(TestMethod('resumed', test_resumed))
      call suite%addTest(TestMethod('bad_groups', test_bad_groups))
   end function uncertainty_runs_suite

   !> Straight hole of 1000 m at 60 deg, pipe of 20 kg/m, no mud; the group stands in line 6.
   function deck(keys) result(text)
      character(*), intent(in) :: keys
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
         "&hole md_bottom = 1000, diameter = 220, friction = 0.3 /"//newline//"&fluid density = 0 /"//newline// &
         "&component od = 127, id = 108.6, mass = 20 /"//newline//"&uncertainty name = 'm', "//keys//" /"//newline
   end function deck

   !> Hook load = w L (cos + mu sin), linear in friction: its quantiles are those of the numbers drawn, exactly, and within four
   !> standard errors those of the normal distribution. Tripping in: the same with the other sign.
   subroutine test_linear()
      real(wp), parameter :: weight = 20.0_wp*9.80665_wp, sine = sqrt(0.75_wp), deviation = 0.05_wp
      real(wp), parameter :: quantile_90 = 1.2815515655446004_wp, density_90 = 0.17549833193248685_wp
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(distribution_type) :: friction
      integer :: i
      run = run_deck_text(deck("operations = 'up', 'down', bit_depth_from = 1000, friction_deviation = 0.05, seed = 5, "// &
                               "samples = "//to_text(samples)))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Uncertainty m: 4000 samples, seed 5') > 0, message=run%output)
      call assertTrue(index(run%output, 'P10 and P90 are uncertain by 4.1 % of their distance from P50') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      call assertEqual(3, size(lines))
      if (size(lines) /= 3) return
      friction = find_distribution(0.3_wp + deviation*normal_number(5, [(i, i=1, samples)], quantity_friction, 1))
      call assertEqual(weight*(0.5_wp + sine*friction%quantiles(p10)), number(lines(2)%text, 5), printed*weight)
      call assertEqual(weight*(0.5_wp + sine*friction%quantiles(p50)), number(lines(2)%text, 6), printed*weight)
      call assertEqual(weight*(0.5_wp + sine*friction%quantiles(p90)), number(lines(2)%text, 7), printed*weight)
      call assertEqual(weight*(0.5_wp + sine*friction%mean), number(lines(2)%text, 8), printed*weight)
      call assertEqual(weight*sine*friction%deviation, number(lines(2)%text, 9), printed*weight)
      call assertEqual(weight*(0.5_wp - sine*friction%quantiles(p90)), number(lines(3)%text, 5), printed*weight)
      call assertEqual(weight*(0.5_wp + sine*(0.3_wp + deviation*quantile_90)), number(lines(2)%text, 7), &
                       weight*sine*deviation*4.0_wp*sqrt(0.09_wp/samples)/density_90, message='P90 of the normal distribution')
      call assertEqual(to_text(samples), field(lines(2)%text, 4))
   end subroutine test_linear

   !> A static string is sure; a gauge of 3 kN makes its reading unsure.
   subroutine test_gauge()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(distribution_type) :: gauge
      integer :: i
      run = run_deck_text(deck("operations = 'static', bit_depth_from = 1000, hookload_deviation = 3, samples = 500"))
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (lines, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      gauge = find_distribution(10.0_wp*9.80665_wp + 3.0_wp*normal_number(1, [(i, i=1, 500)], quantity_hookload, 1))
      call assertEqual(gauge%quantiles(p10), number(lines(2)%text, 5), printed*100.0_wp)
      call assertEqual(gauge%quantiles(p90), number(lines(2)%text, 7), printed*100.0_wp)
      call assertEqual(0.0_wp, number(lines(2)%text, 14))
   end subroutine test_gauge

   function all_unsure() result(text)
      character(:), allocatable :: text
      text = deck("model = 'soft', 'rigid', bit_depth_step = 400, samples = 30, friction_deviation = 0.05, "// &
                  "density_deviation = 5, inclination_deviation = 0.5, azimuth_deviation = 0.5, torque_deviation = 0.1")
   end function all_unsure

   !> One thread and two, and once more: the same file. Another seed: another.
   subroutine test_threads()
      type(run_type) :: run
      type(text_type), allocatable :: one(:), two(:)
      run = run_deck_text(all_unsure(), '--threads 1')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (one, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      call assertEqual(1 + 2*3*3, size(one))
      run = run_deck_text(all_unsure(), '--threads 2')
      allocate (two, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      call compare(one, two)
      run = run_deck_text(replaced(all_unsure(), 'samples = 30', 'samples = 30, seed = 2'))
      deallocate (two)
      allocate (two, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      call assertTrue(one(2)%text /= two(2)%text, message='another seed')
   end subroutine test_threads

   !> Three parts of thirty samples and of four points that three does not divide, joined: the same file. A part that lacks and
   !> one of another seed are refused by name.
   subroutine test_parts()
      type(run_type) :: run
      type(text_type), allocatable :: one(:), two(:)
      integer :: i
      run = run_deck_text(replaced(all_unsure(), 'samples = 30', 'samples = 31'))
      allocate (one, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      run = run_deck_text(replaced(all_unsure(), 'samples = 30', 'samples = 31'), '--part 1/3')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'part 1 of 3: 186 of 558 solutions') > 0, message=run%output)
      run = run_program(again//'--merge 3')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'uncertainty_m.part_2_of_3: it is missing; run --part 2/3') > 0, &
                      message=run%diagnostics)
      do i = 2, 3
         run = run_program(again//'--part '//to_text(i)//'/3')
      end do
      run = run_program(again//'--merge 3')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (two, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      call compare(one, two)
   end subroutine test_parts

   !> A record that an interrupted run left, its last line cut short, is gone on with and gives the same file; one of another
   !> seed is refused, and the difference named. The gauges may change: they come in when all is solved.
   subroutine test_resumed()
      character(*), parameter :: whole = results_path//'/uncertainty_m.part_1_of_1'
      character(*), parameter :: partial = results_path//'/uncertainty_m.partial'
      integer, parameter :: kept = 100
      type(run_type) :: run
      type(text_type), allocatable :: one(:), two(:), lines(:)
      type(error_type), allocatable :: error
      character(:), allocatable :: failure
      run = run_deck_text(all_unsure())
      allocate (one, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      run = run_program(again//'--part 1/1')
      call assertEqual(0, run%status, message=run%diagnostics)
      call read_lines(whole, lines, failure)
      call assertEqual('', failure)
      lines = lines(:size(lines) - kept)
      lines(size(lines))%text = lines(size(lines))%text(:10)
      call write_text_file(partial, lines, error)
      run = run_program(again)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'uncertainty ''m'': ') > 0, message=run%diagnostics)
      call assertTrue(index(run%output, to_text(kept + 1)//' solutions in') > 0, message=run%output)
      allocate (two, source=lines_of(results_path//'/uncertainty_m.csv'))
      if (anyExceptions()) return
      call compare(one, two)
      call write_text_file(partial, lines, error)
      call write_text_file(deck_path, [deck_lines('seed = 2, torque_deviation = 0.2')], error)
      run = run_program(again)
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'seed was 1 and is 2') > 0, message=run%diagnostics)
      call write_text_file(deck_path, [deck_lines('torque_deviation = 0.2')], error)
      run = run_program(again)
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_resumed

   !> The deck of all_unsure with another gauge, as one line of a file.
   function deck_lines(instead) result(line)
      character(*), intent(in) :: instead
      type(text_type) :: line
      line%text = replaced(all_unsure(), 'torque_deviation = 0.1', instead)
   end function deck_lines

   subroutine compare(one, two)
      type(text_type), intent(in) :: one(:), two(:)
      integer :: i
      call assertEqual(size(one), size(two))
      do i = 1, min(size(one), size(two))
         if (one(i)%text /= two(i)%text) call assertEqual(one(i)%text, two(i)%text)
      end do
   end subroutine compare

   subroutine test_bad_groups()
      call refuse("samples = 100", 'nothing is uncertain; give a friction_deviation')
      call refuse("friction_deviation = 0.1, samples = 1", 'samples = 1 is out of range')
      call refuse("friction_deviation = -0.1", 'friction_deviation = -0.1 is out of range')
      call refuse("friction_deviation = 0.1, bit_depth_to = 1200", 'bit_depth_to = 1200 m lies below the survey')
      call refuse("friction_deviation = 0.1, samples = 1000000", 'are more than 5000000 solutions')
      call refuse("friction_deviation = 0.1, survey_errors = 'sytematic'", 'did you mean ''systematic''?')
      call refuse("friction_deviation = 0.1, frictions = 0.2", 'did you mean ''friction''?')
      call refuse("friction_from = 'k'", 'is not a &calibrate of this deck with apply = .true.')
      call refuse("friction_deviations = 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1", 'hole section')
      call refuse("friction_deviation = 0.1, friction_deviations = 0.1", 'not both')
      call refuse("friction_deviation = 0.1, friction_correlation = 1.5", 'is out of range')
      call refuse("friction_deviation = 0.1, operations = 'ream'", 'reaming needs rpm > 0')
      call refuse("friction_deviation = 0.1 / &uncertainty name = 'M', friction_deviation = 0.1", 'name ''M'' is taken')
   end subroutine test_bad_groups

   subroutine refuse(keys, expected)
      character(*), intent(in) :: keys, expected
      type(run_type) :: run
      run = run_deck_text(deck(keys))
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, deck_path//':6: group &uncertainty: ') > 0 .and. &
                      index(run%diagnostics, expected) > 0, message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse
end module dg_test_uncertainty_runs
