!> Calibrations as a user runs them: friction that is known comes back, by every model; what the data cannot tell is said or
!> refused.
module dg_test_calibration_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_counter_random, only: normal_number
   use dg_kinds, only: wp
   use dg_program_run, only: deck_path, good_deck, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: field, lines_of, number
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: calibration_runs_suite

   character(*), parameter :: newline = achar(10), few_depths = 'measured at too few depths'
   !> Straight hole of 1000 m at 60 deg, pipe of 20 kg/m without mud: weight along the hole and across it [kN].
   real(wp), parameter :: along = 20.0_wp*9.80665_wp*0.5_wp, across = 20.0_wp*9.80665_wp*0.8660254037844386_wp
   !> Fits end at steps of 1e-7.
   real(wp), parameter :: at_rest = 1.0e-6_wp

contains

   function calibration_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('calibration_runs')
      call suite%addTest(TestMethod('known_friction', test_known))
      call suite%addTest(TestMethod('block_left_out_of_measurements', test_block_left_out))
      call suite%addTest(TestMethod('measured_on_one_side', test_one_side))
      call suite%addTest(TestMethod('without_scatter', test_without_scatter))
      call suite%addTest(TestMethod('predicted', test_predicted))
      call suite%addTest(TestMethod('six_depths', test_six_depths))
      call suite%addTest(TestMethod('coverage', test_coverage))
      call suite%addTest(TestMethod('all_models_and_torque', test_models))
      call suite%addTest(TestMethod('hook_loads_against_torques', test_apart))
      call suite%addTest(TestMethod('threads', test_threads))
      call suite%addTest(TestMethod('not_separated', test_not_separated))
      call suite%addTest(TestMethod('no_fit', test_no_fit))
      call suite%addTest(TestMethod('bad_groups', test_bad_groups))
   end function calibration_runs_suite

   !> A straight inclined hole in two sections of 400 m and 600 m; hook loads [kN] of tripping out and in at two depths.
   function straight_deck(up_half, up_full, down_full, calibrate) result(text)
      real(wp), intent(in) :: up_half, up_full, down_full
      character(*), intent(in) :: calibrate
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
         "&hole name = 'upper', md_bottom = 400, diameter = 220, friction = 0.1 /"//newline// &
         "&hole name = 'lower', md_bottom = 1000, diameter = 215.9, friction = 0.1 /"//newline// &
         "&fluid density = 0 /"//newline//"&component od = 127, id = 108.6, mass = 20 /"//newline// &
         "&load_case name = 'a', operation = 'up', bit_depth = 500, measured_hookload = "//to_text(up_half)//" /"//newline// &
         "&load_case name = 'b', operation = 'up', bit_depth = 1000, measured_hookload = "//to_text(up_full)//" /"//newline// &
         "&load_case name = 'c', operation = 'down', bit_depth = 1000, measured_hookload = "//to_text(down_full)//" /"//newline// &
         calibrate//newline
   end function straight_deck

   !> Hook loads and torques of two frictions, at seven depths with scatter.
   function apart_deck(axial, rotary, calibrate) result(text)
      real(wp), intent(in) :: axial, rotary
      character(*), intent(in) :: calibrate
      character(:), allocatable :: text
      real(wp), parameter :: radius = 0.0635_wp
      real(wp) :: part, scatter
      integer :: i
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline//"&hole diameter = 215.9, friction = 0.1 /"//newline// &
         "&fluid density = 0 /"//newline//"&component od = 127, id = 108.6, mass = 20 /"//newline//calibrate//newline
      do i = 1, 7
         part = 0.3_wp + 0.1_wp*i
         scatter = real(modulo(3*i, 7) - 3, wp)/3.0_wp
         call add('up', 'measured_hookload', part*(along + axial*across) + scatter)
         call add('down', 'measured_hookload', part*(along - axial*across) - 0.5_wp*scatter)
         call add('rotate', 'measured_torque', part*rotary*across*radius + 0.02_wp*scatter)
      end do
   contains
      subroutine add(operation, key, measured)
         character(*), intent(in) :: operation, key
         real(wp), intent(in) :: measured
         text = text//"&load_case name = '"//operation//to_text(i)//"', operation = '"//operation//"', bit_depth = "// &
                to_text(1000.0_wp*part)//', '//key//' = '//to_text(measured)//' /'//newline
      end subroutine add
   end function apart_deck

   !> Torques that ask for other friction than hook loads: a warning, whose advice finds both. Measurements that agree have none.
   !> No interval goes below zero friction.
   subroutine test_apart()
      character(*), parameter :: warning = 'hook loads and torques do not agree'
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      run = run_deck_text(apart_deck(0.2_wp, 0.35_wp, "&calibrate name = 'k' /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, warning) > 0, message=run%output)
      run = run_deck_text(apart_deck(0.2_wp, 0.2_wp, "&calibrate name = 'k' /"))
      call assertEqual(0, index(run%output, warning), message=run%output)
      run = run_deck_text(apart_deck(0.2_wp, 0.35_wp, "&calibrate name = 'a', parameter = 'friction_axial' /"//newline// &
                                     "&calibrate name = 'r', parameter = 'friction_rotary' /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, warning), message=run%output)
      allocate (rows, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual(0.2_wp, number(rows(2)%text, 8), 0.01_wp)
      call assertEqual(0.35_wp, number(rows(3)%text, 8), 0.01_wp)
      run = run_deck_text(apart_deck(0.0008_wp, 0.2_wp, "&calibrate name = 'k', parameter = 'friction_axial' /"))
      call assertTrue(index(run%output, ' 0.0000 to 0.0') > 0, message=run%output)
   end subroutine test_apart

   !> Hook loads measured without the block, beside a block weight: the offset takes it back, and a warning says so. Without
   !> block_weight, as it advises, there is none.
   subroutine test_block_left_out()
      type(run_type) :: run
      real(wp), parameter :: friction = 0.2_wp
      character(*), parameter :: warning = 'the offset is about minus the block weight'
      character(:), allocatable :: deck
      deck = straight_deck(0.5_wp*along*(1.0_wp + friction*across/along), along + friction*across, along - friction*across, &
                           "&calibrate name = 'k', offset = 'one', separate = 'none' /")
      run = run_deck_text(deck//'&rig block_weight = 60 /'//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, warning) > 0, message=run%output)
      run = run_deck_text(deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, warning), message=run%output)
   end subroutine test_block_left_out

   !> Hook loads that are all measured 20 kN too high, pulled and lowered. The offset takes it, as the warning advises.
   subroutine test_one_side()
      real(wp), parameter :: friction = 0.2_wp, too_high(3) = [20.0_wp, 0.0_wp, -20.0_wp]
      character(*), parameter :: warning(3) = [character(52) :: 'kN above those found, pulled and lowered alike', &
                                               'pulled and lowered alike', 'kN below those found, pulled and lowered alike']
      type(run_type) :: run
      character(:), allocatable :: deck
      integer :: i
      do i = 1, size(too_high)
         deck = straight_deck(0.5_wp*(along + friction*across) + too_high(i), along + friction*across + too_high(i), &
                              along - friction*across + too_high(i), "&calibrate name = 'k', separate = 'none' /")
         run = run_deck_text(deck)
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertTrue((index(unwrapped(run%output), trim(warning(i))) > 0) .eqv. i /= 2, message=run%output)
         run = run_deck_text(replaced(deck, "separate = 'none'", "separate = 'none', offset = 'one'"))
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertEqual(0, index(unwrapped(run%output), 'pulled and lowered alike'), message=run%output)
      end do
   end subroutine test_one_side

   !> Hook loads, and torques, of one friction factor: the deviation that is asked for gives its interval.
   subroutine test_without_scatter()
      character(*), parameter :: advice = 'met to round-off, which tells nothing of their error; give '
      character(:), allocatable :: deck
      real(wp), parameter :: mu = 0.2_wp, torque = mu*across*0.0635_wp     ! [-, kN.m]
      deck = straight_deck(0.5_wp*(along + mu*across), along + mu*across, along - mu*across, &
                           "&calibrate parameter = 'friction_axial', separate = 'none' /")
      call follow('hookload_deviation'//newline, 'hookload_deviation = 3')
      deck = replaced(replaced(replaced(deck, "'up'", "'rotating'"), "'up'", "'rotating'"), "'down'", "'rotating'")
      deck = replaced(deck, 'hookload = '//to_text(0.5_wp*(along + mu*across)), 'torque = '//to_text(0.5_wp*torque))
      deck = replaced(deck, 'hookload = '//to_text(along + mu*across), 'torque = '//to_text(torque))
      deck = replaced(deck, 'hookload = '//to_text(along - mu*across), 'torque = '//to_text(torque))
      deck = replaced(deck, 'friction_axial', 'friction_rotary')
      call follow('torque_deviation'//newline, 'torque_deviation = 0.1')
   contains
      subroutine follow(keys, remedy)
         character(*), intent(in) :: keys, remedy
         type(run_type) :: run
         run = run_deck_text(deck)
         call assertTrue(index(unwrapped(run%output), advice//keys) > 0, message=run%output)
         run = run_deck_text(replaced(deck, "'none'", "'none', "//remedy))
         call assertEqual(0, index(unwrapped(run%output), advice), message=run%output)
         call assertEqual(0, run%status, message=run%diagnostics)
      end subroutine follow
   end subroutine test_without_scatter

   !> Hook load = weight along + mu weight across, mu 0.2 in the upper 400 m and 0.3 below, and a gauge that shows 5 kN more.
   subroutine test_known()
      real(wp), parameter :: upper = 0.2_wp, lower = 0.3_wp, gauge = 5.0_wp
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      real(wp) :: half, full
      half = across*(0.4_wp*upper + 0.1_wp*lower)
      full = across*(0.4_wp*upper + 0.6_wp*lower)
      run = run_deck_text(straight_deck(0.5_wp*along + half + gauge, along + full + gauge, along - full + gauge, &
                                        "&calibrate name = 'k', parameter = 'friction_axial', offset = 'one' /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Calibration k, model soft: friction_axial from 3 measured values') > 0, &
                      message=run%output)
      call assertTrue(index(run%output, 'the fit is exact and proves nothing') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual(4, size(lines))
      if (size(lines) /= 4) return
      call assertEqual('upper', field(lines(2)%text, 4))
      call assertEqual(upper, number(lines(2)%text, 8), at_rest)
      call assertEqual(lower, number(lines(3)%text, 8), at_rest)
      call assertEqual(gauge, number(lines(4)%text, 15), at_rest*along)
      deallocate (lines)
      allocate (lines, source=lines_of(results_path//'/calibration_data.csv'))
      if (anyExceptions()) return
      call assertEqual(4, size(lines))
      if (size(lines) /= 4) return
      ! before: friction 0.1, no offset
      call assertEqual(along + 0.1_wp*across, number(lines(3)%text, 7), at_rest*along)
      call assertEqual(along + full + gauge, number(lines(3)%text, 8), at_rest*along)
   end subroutine test_known

   !> One friction along a hole of one kind, from two hook loads that are 3 kN apart about what 0.2 gives: by hand 0.2 and s = 3 kN
   !> with one degree of freedom (t = 12.706). The third case, at twice the depth, is predicted; 1 kN off it lies in its interval
   !> of t s sqrt(1 + (x/x_1)^2/2). What is measured there changes nothing.
   subroutine test_predicted()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: deck
      real(wp), parameter :: t = 12.70620474_wp, s = 3.0_wp/1.4142135623730951_wp
      real(wp) :: half
      deck = straight_deck(0.5_wp*(along + 0.2_wp*across) + 1.5_wp, along - 0.2_wp*across - 1.0_wp, 60.0_wp, '')
      deck = replaced(deck, "name = 'b', operation = 'up'", "name = 'b', operation = 'down'")
      deck = replaced(deck, "name = 'c', operation = 'down', bit_depth = 1000, measured_hookload = "//to_text(60.0_wp), &
                      "name = 'c', operation = 'up', bit_depth = 500, measured_hookload = "// &
                      to_text(0.5_wp*(along + 0.2_wp*across) - 1.5_wp))
      run = run_deck_text(deck//"&calibrate parameter = 'friction_axial', separate = 'none', predict = 'b' /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '1 measured values predicted: mean error') > 0, message=run%output)
      call assertTrue(index(run%output, '1 of 1 within their 95 % interval') > 0, message=run%output)
      call assertTrue(index(run%output, few_depths) > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration_prediction.csv'))
      if (anyExceptions()) return
      call assertEqual(2, size(lines))
      if (size(lines) /= 2) return
      call assertEqual('b', field(lines(2)%text, 3))
      call assertEqual(along - 0.2_wp*across, number(lines(2)%text, 6), at_rest*along)
      half = t*s*sqrt(1.0_wp + 2.0_wp**2/2.0_wp)
      call assertEqual(along - 0.2_wp*across - half, number(lines(2)%text, 7), 1.0e-4_wp*half)
      call assertEqual(along - 0.2_wp*across + half, number(lines(2)%text, 8), 1.0e-4_wp*half)
      call assertEqual('yes', field(lines(2)%text, 15))
      call refuse_prediction("cases = 'a', 'b', 'c', predict = 'b'", 'is one of cases, so it would be no prediction')
      call refuse_prediction("predict = 'bb'", "there is no load case 'bb'")
      call refuse_prediction("predict = 'b', separate = 'depths'", 'predict has no meaning with a factor or an offset a depth')
      call refuse_prediction("predict = 'b', separate = 'operations'", 'no measured case tells a factor of trip_in')
   contains
      subroutine refuse_prediction(keys, expected)
         character(*), intent(in) :: keys, expected
         run = run_deck_text(deck//"&calibrate parameter = 'friction_axial', "//keys//' /'//newline)
         call assertEqual(2, run%status, message=keys)
         call assertTrue(index(run%diagnostics, expected) > 0, message=run%diagnostics)
      end subroutine refuse_prediction
   end subroutine test_predicted

   !> Hook loads at six depths show whether errors grow with depth: no warning.
   subroutine test_six_depths()
      type(run_type) :: run
      character(:), allocatable :: deck
      real(wp) :: depth
      integer :: i
      deck = straight_deck(70.0_wp, 150.0_wp, 60.0_wp, '')
      deck = deck(:index(deck, '&load_case') - 1)
      do i = 1, 7
         depth = 0.3_wp + 0.1_wp*i
         deck = deck//"&load_case name = '"//to_text(i)//"', operation = 'up', bit_depth = "//to_text(1000.0_wp*depth)
         if (i < 7) deck = deck//', measured_hookload = '//to_text(depth*(along + 0.2_wp*across) + 2.0_wp*modulo(i, 2))
         deck = deck//' /'//newline
      end do
      run = run_deck_text(deck//"&calibrate parameter = 'friction_axial', separate = 'none', predict = '7' /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Predicted load case') > 0, message=run%output)
      call assertEqual(0, index(run%output, few_depths), message=run%output)
   end subroutine test_six_depths

   !> Friction 0.2 and 0.3, hook loads of tripping out and in at 500 and 1000 m with a noise of 3 kN, 100 times: the intervals
   !> of 95 % hold what is true in 95 % of them, within four standard errors (0.087), from the residuals (two degrees of freedom)
   !> and from the noise where the deck tells it.
   subroutine test_coverage()
      integer, parameter :: sets = 100
      real(wp), parameter :: truth(2) = [0.2_wp, 0.3_wp], noise = 3.0_wp, nominal = 0.95_wp, four_errors = 0.087_wp
      character(:), allocatable :: deck, names, group
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      real(wp) :: depth, drag
      integer :: set, i, k, kind, held(2)
      do kind = 1, 2
         deck = straight_deck(70.0_wp, 150.0_wp, 60.0_wp, '')
         deck = deck(:index(deck, '&load_case') - 1)
         group = ''
         if (kind == 2) group = ', hookload_deviation = 3'
         do set = 1, sets
            names = ''
            do i = 1, 4
               depth = merge(0.5_wp, 1.0_wp, i <= 2)
               drag = across*(0.4_wp*truth(1) + (depth - 0.4_wp)*truth(2))
               names = names//" '"//to_text(4*set + i)//"'"
               deck = deck//"&load_case name = '"//to_text(4*set + i)//"', operation = '"// &
                  trim(merge('up  ', 'down', modulo(i, 2) == 1))//"', bit_depth = "//to_text(1000.0_wp*depth)// &
                  ', measured_hookload = '//to_text(depth*along + merge(drag, -drag, modulo(i, 2) == 1) + &
                                                    noise*normal_number(1, set, 1, i))//" /"//newline
            end do
            deck = deck//"&calibrate parameter = 'friction_axial', cases ="//names//group//" /"//newline
         end do
         run = run_deck_text(deck)
         call assertEqual(0, run%status, message=run%diagnostics)
         allocate (lines, source=lines_of(results_path//'/calibration.csv'))
         if (anyExceptions()) return
         call assertEqual(1 + 2*sets, size(lines))
         held = 0
         do i = 1, size(lines) - 1
            k = 2 - modulo(i, 2)
            if (truth(k) < number(lines(i + 1)%text, 9) .or. truth(k) > number(lines(i + 1)%text, 10)) cycle
            held(k) = held(k) + 1
         end do
         call assertEqual([nominal, nominal], held/real(sets, wp), four_errors, message='sets held')
         deallocate (lines)
      end do
   end subroutine test_coverage

   !> Every model finds the friction 0.3 with which it calculated what was "measured" in the good deck, along by hook load and
   !> around by torque. Its upper section is vertical: there nothing is felt, and the factor stays.
   subroutine test_models()
      character(*), parameter :: models(4) = [character(5) :: 'soft', 'rigid', 'mixed', 'mcge']
      character(:), allocatable :: deck
      type(run_type) :: run
      type(text_type), allocatable :: lines(:), found(:)
      integer :: m
      do m = 1, size(models)
         deck = replaced(good_deck(), "&load_case name = 's', operation = 'sliding', bit_depth = 800.0", &
                         "&load_case name = 's', operation = 'rotate_off_bottom', bit_depth = 880.0")
         deck = replaced(replaced(deck, "'soft'", "'"//trim(models(m))//"'"), 'wob = 20.0', 'wob = 0')
         run = run_deck_text(deck)
         call assertEqual(0, run%status, message=run%diagnostics)
         allocate (lines, source=lines_of(results_path//'/summary.csv'))
         if (anyExceptions()) return
         deck = replaced(replaced(deck, 'bit_depth = 900.0', 'bit_depth = 900, measured_hookload = '//field(lines(2)%text, 8)), &
                         'wob = 0', 'measured_torque = '//field(lines(3)%text, 14))
         deck = replaced(replaced(deck, 'friction = 0.25', 'friction = 0.2'), 'friction = 0.3', 'friction = 0.2')
         run = run_deck_text(deck//"&calibrate model = '"//trim(models(m))//"' /"//newline)
         call assertEqual(0, run%status, message=run%diagnostics)
         allocate (found, source=lines_of(results_path//'/calibration_data.csv'))
         if (anyExceptions()) return
         call assertEqual(3, size(found))
         call assertTrue(number(found(2)%text, 13) < 1.0e-4_wp, message=trim(models(m))//': '//found(2)%text)
         call assertTrue(number(found(3)%text, 13) < 1.0e-4_wp, message=trim(models(m))//': '//found(3)%text)
         deallocate (found)
         allocate (found, source=lines_of(results_path//'/calibration.csv'))
         if (anyExceptions()) return
         call assertEqual('not_felt', field(found(2)%text, 12), message=found(2)%text)
         call assertEqual(0.2_wp, number(found(2)%text, 8))
         call assertEqual(0.3_wp, number(found(3)%text, 8), at_rest, message=found(3)%text)
         deallocate (lines, found)
      end do
   end subroutine test_models

   !> The files of one thread and of two are the same.
   subroutine test_threads()
      character(*), parameter :: group = "&calibrate separate = 'depths', model = 'soft', 'mcge' /"
      type(run_type) :: run
      type(text_type), allocatable :: one(:), two(:)
      integer :: i
      run = run_deck_text(straight_deck(70.0_wp, 150.0_wp, 60.0_wp, group), '--threads 1')
      allocate (one, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      run = run_deck_text(straight_deck(70.0_wp, 150.0_wp, 60.0_wp, group), '--threads 2')
      allocate (two, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual(5, size(one), message=run%diagnostics)
      do i = 1, min(size(one), size(two))
         call assertEqual(one(i)%text, two(i)%text)
      end do
   end subroutine test_threads

   !> One depth, out and in: both tell the same mixture of two sections. One factor for all, as the warning advises, is found.
   subroutine test_not_separated()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(straight_deck(70.0_wp, 150.0_wp, 60.0_wp, "&calibrate cases = 'b', 'c' /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'cannot tell these factors apart') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual('not_separated', field(lines(2)%text, 12), message=lines(2)%text)
      call assertEqual('', field(lines(2)%text, 9), message='no interval')
      call assertTrue(index(run%output, 'or find one factor for all (separate = ''none'')') > 0, message=run%output)
      run = run_deck_text(straight_deck(70.0_wp, 150.0_wp, 60.0_wp, "&calibrate cases = 'b', 'c', separate = 'none' /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, 'cannot tell these factors apart'), message=run%output)
      lines = lines_of(results_path//'/calibration.csv')
      if (anyExceptions()) return
      call assertEqual('found', field(lines(2)%text, 12), message=lines(2)%text)
   end subroutine test_not_separated

   !> A model that finds no solution: said by name, marked in the files, status 3.
   subroutine test_no_fit()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(straight_deck(70.0_wp, 150.0_wp, 60.0_wp, "&calibrate name = 'k', model = 'mcge' /"//newline// &
                                        "&solver max_iterations = 1 /"))
      call assertEqual(3, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'calibration ''k'', model mcge: no fit; load case ''a'' has no solution') > 0, &
                      message=run%diagnostics)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual('no_fit', field(lines(2)%text, 12), message=lines(2)%text)
      deallocate (lines)
      allocate (lines, source=lines_of(results_path//'/calibration_data.csv'))
      if (anyExceptions()) return
      call assertEqual('', field(lines(2)%text, 7), message=lines(2)%text)
      call assertEqual('', field(lines(2)%text, 8), message=lines(2)%text)
   end subroutine test_no_fit

   !> Refuse questions that the data of the straight deck (group in line 10) cannot answer.
   subroutine test_bad_groups()
      call refuse("separate = 'holes', 'operations'", '3 measured values for 4 unknowns: add measurements, or leave out')
      call refuse("cases = 'b'", '1 measured values for 2 unknowns')
      call refuse("parameter = 'friction_rotary'", 'nothing measured tells the factor of hole section ''upper''')
      call refuse("cases = 'd'", 'there is no load case ''d''')
      call refuse("holes = 'lowe'", 'there is no hole section ''lowe''; did you mean ''lower''?')
      call refuse("cases = 'a', holes = 'lower', separate = 'hole'", 'did you mean ''holes''?')
      call refuse("separate = 'none', 'holes'", 'keep one')
      call refuse("parameter = 'fricton'", 'did you mean ''friction''?')
      call refuse("hookload_deviation = 0", 'hookload_deviation = 0 is out of range')
      call refuse("/ &load_case name = 'deep', operation = 'up', bit_depth = 1200, measured_hookload = 1", &
                  'bit_depth = 1200 m lies below the survey, which ends at 1000 m', 'load_case')
      call refuse("/ &load_case name = 'n', operation = 'up', bit_depth = 900 / &calibrate cases = 'n', 'b'", &
                  'load case ''n'' (line 10) has neither measured_hookload nor measured_torque')
   end subroutine test_bad_groups

   subroutine refuse(keys, expected, group)
      character(*), intent(in) :: keys, expected
      character(*), intent(in), optional :: group
      type(run_type) :: run
      character(:), allocatable :: place
      place = deck_path//':10: group &calibrate: '
      if (present(group)) place = deck_path//':10: group &'//group//': '
      run = run_deck_text(straight_deck(70.0_wp, 150.0_wp, 60.0_wp, '&calibrate '//keys//' /'))
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, place) > 0 .and. index(run%diagnostics, expected) > 0, &
                      message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse
end module dg_test_calibration_runs
