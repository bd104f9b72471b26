!> Runs with a rig: what its indicator shows is what measurements are compared with, in tables, broomsticks, calibrations and of
!> strings that are held. A straight hole, where hook loads are a product.
module dg_test_rig_runs
   use funit, only: anyExceptions, assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: content, deck_path, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: field, lines_of, number, value_after
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: rig_runs_suite

   character(*), parameter :: newline = achar(10)
   !> Straight hole of 1000 m at 60 deg, pipe of 20 kg/m without mud: weight along the hole and across it [kN].
   real(wp), parameter :: along = 20.0_wp*9.80665_wp*0.5_wp, across = 20.0_wp*9.80665_wp*0.8660254037844386_wp
   real(wp), parameter :: friction = 0.25_wp, block = 140.0_wp, efficiency = 0.96_wp
   integer, parameter :: lines_strung = 10
   !> Hook loads of the soft string, and fits that end at steps of 1e-7 [kN].
   real(wp), parameter :: at_rest = 1.0e-5_wp*along
   integer, parameter :: summary_hookload = 8, summary_indicator = 30, sweep_indicator = 12

contains

   function rig_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('rig_runs')
      call suite%addTest(TestMethod('what_is_shown', test_shown))
      call suite%addTest(TestMethod('block_from_measurements', test_block))
      call suite%addTest(TestMethod('measured_without_block', test_without_block))
      call suite%addTest(TestMethod('held_string', test_held))
      call suite%addTest(TestMethod('sweep_of_pairs_and_limits', test_sweep))
      call suite%addTest(TestMethod('push_of_the_rig', test_push))
      call suite%addTest(TestMethod('push_in_other_units', test_push_units))
      call suite%addTest(TestMethod('push_without_need', test_no_need))
      call suite%addTest(TestMethod('hanger_that_holds_down', test_hanger))
      call suite%addTest(TestMethod('bad_groups', test_bad))
   end function rig_runs_suite

   !> Indicated load for a load on the lines, from the dead line on: each line at the block has 1/e of the tension of the last when
   !> raising, e when lowering.
   pure function shown(load, raising) result(indicated)
      real(wp), intent(in) :: load
      logical, intent(in) :: raising
      real(wp) :: indicated
      integer :: i
      if (raising) then
         indicated = lines_strung*load/sum([(efficiency**(-i), i=0, lines_strung - 1)])
      else
         indicated = lines_strung*load/sum([(efficiency**i, i=0, lines_strung - 1)])
      end if
   end function shown

   function rig_group(block_weight) result(text)
      real(wp), intent(in) :: block_weight
      character(:), allocatable :: text
      text = '&rig block_weight = '//to_text(block_weight)//', lines = 10, sheave_efficiency = 0.96 /'//newline
   end function rig_group

   !> Up, down, rotating; each measured as the rig shows it.
   function deck(in_deck, groups) result(text)
      real(wp), intent(in) :: in_deck          !< friction
      character(*), intent(in) :: groups
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
         "&hole name = 'all', diameter = 215.9, friction = "//to_text(in_deck)//" /"//newline// &
         "&component od = 127, id = 108.6, mass = 20 /"//newline// &
         "&load_case name = 'u', operation = 'up', bit_depth = 1000, measured_hookload = "// &
         to_text(shown(block + along + friction*across, .true.))//" /"//newline// &
         "&load_case name = 'd', operation = 'down', bit_depth = 1000, measured_hookload = "// &
         to_text(shown(block + along - friction*across, .false.))//" /"//newline// &
         "&load_case name = 'r', operation = 'rotate_off_bottom', bit_depth = 1000, measured_hookload = "// &
         to_text(block + along)//" /"//newline//groups//newline
   end function deck

   !> hookload stays the string's own; the last column is what the rig shows, and errors are against it, in the broomstick too.
   subroutine test_shown()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(deck(friction, rig_group(block)//"&sweep name = 'b', bit_depth_from = 500, bit_depth_step = 500 /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'indicator') > 0, message=run%output)
      call assertTrue(index(run%output, 'Weight indicator, block included, against measurement: mean error 0.00 %') > 0, &
                      message=run%output)
      call assertTrue(index(run%output, 'weight indicator (hook load with block and sheaves), kN at friction factors') > 0, &
                      message=run%output)
      allocate (lines, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      call assertEqual('weight_indicator_kN', field(lines(1)%text, summary_indicator))
      call assertEqual(along + friction*across, number(lines(2)%text, 8), at_rest)
      call assertEqual(shown(block + along + friction*across, .true.), number(lines(2)%text, summary_indicator), at_rest)
      call assertEqual(0.0_wp, number(lines(2)%text, 10), at_rest)
      call assertEqual(along - friction*across, number(lines(3)%text, 8), at_rest)
      call assertEqual(shown(block + along - friction*across, .false.), number(lines(3)%text, summary_indicator), at_rest)
      call assertEqual(block + along, number(lines(4)%text, summary_indicator), at_rest)
      deallocate (lines)
      allocate (lines, source=lines_of(results_path//'/sweep_b.csv'))
      if (anyExceptions()) return
      call assertEqual(shown(block + 0.5_wp*(along + friction*across), .true.), number(lines(2)%text, sweep_indicator), at_rest)
      call assertEqual(0.5_wp*(along + friction*across), number(lines(2)%text, 5), at_rest)
      call assertEqual(0.0_wp, number(lines(3)%text, 10), at_rest)
   end subroutine test_shown

   !> Hook loads measured without the block raise a question, which goes when the block weight is added as it says. With the block
   !> they raise none, nor does friction that is wrong by half.
   subroutine test_without_block()
      character(*), parameter :: question = 'Were they measured without the block? Then add block_weight to measured_hookload'
      character(:), allocatable :: page
      type(run_type) :: run
      run = run_deck_text(replaced(bare(0.0_wp), ', plots = .false.', ''))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(unwrapped(run%output), question) > 0, message=run%output)
      page = content(results_path//'/report.html')
      call assertTrue(index(page, question) > 0, message='page')
      run = run_deck_text(bare(block))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(unwrapped(run%output), question), message=run%output)
      run = run_deck_text(deck(0.5_wp*friction, rig_group(block)))
      call assertEqual(0, index(unwrapped(run%output), question), message='half the friction: '//run%output)
      run = run_deck_text(pick_up(bare(0.0_wp)))
      call assertTrue(index(unwrapped(run%output), question) > 0, message='pick-up: '//run%output)
      run = run_deck_text(pick_up(bare(block)))
      call assertEqual(0, index(unwrapped(run%output), question), message='pick-up with block: '//run%output)
      run = run_deck_text(pick_up(deck(1.2_wp, rig_group(block))))
      call assertEqual(0, index(unwrapped(run%output), question), message='friction of 1.2: '//run%output)
   contains
      !> A deck without its cases below the first.
      function pick_up(all) result(text)
         character(*), intent(in) :: all
         character(:), allocatable :: text
         text = all(:index(all, "&load_case name = 'd'") - 1)//rig_group(block)
      end function pick_up

      !> A deck with what the string weighs, and `added` to it.
      function bare(added) result(text)
         real(wp), intent(in) :: added       !< [kN]
         character(:), allocatable :: text
         text = deck(friction, rig_group(block))
         text = replaced(text, to_text(shown(block + along + friction*across, .true.)), to_text(along + friction*across + added))
         text = replaced(text, to_text(shown(block + along - friction*across, .false.)), to_text(along - friction*across + added))
         text = replaced(text, '= '//to_text(block + along), '= '//to_text(along + added))
      end function bare
   end subroutine test_without_block

   !> An offset is what the block weight of the deck lacks; applied, all that follows has it. Without a rig it is added to nothing.
   subroutine test_block()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      character(*), parameter :: calibrate = "&calibrate parameter = 'friction_axial', offset = 'one', apply = .true. /"
      run = run_deck_text(deck(0.1_wp, rig_group(110.0_wp)//calibrate//newline// &
                               "&sweep name = 'b', bit_depth_from = 1000 /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '&rig: block_weight 140') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual(friction, number(lines(2)%text, 8), at_rest/along)
      call assertEqual(block - 110.0_wp, number(lines(3)%text, 15), at_rest)
      deallocate (lines)
      allocate (lines, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      call assertEqual(0.0_wp, number(lines(2)%text, 10), 1.0e-3_wp)
      call assertEqual(0.0_wp, number(lines(4)%text, 10), 1.0e-3_wp)
      deallocate (lines)
      allocate (lines, source=lines_of(results_path//'/sweep_b.csv'))
      if (anyExceptions()) return
      call assertEqual(shown(block + along - friction*across, .false.), number(lines(3)%text, sweep_indicator), at_rest)
      deallocate (lines)
      run = run_deck_text(deck(0.1_wp, calibrate))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'added to the weight of the block, and the deck has no &rig block_weight.') > 0, &
                      message=run%output)
      allocate (lines, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      call assertEqual('', field(lines(2)%text, summary_indicator))
   end subroutine test_block

   !> Stuck at 400 m: what is above weighs and rubs, the rest of what the string carries is the pull there.
   subroutine test_held()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      real(wp), parameter :: pull = 300.0_wp
      run = run_deck_text(deck(friction, rig_group(block)// &
         "&load_case name = 's', operation = 'up', bit_depth = 1000, measured_hookload = "// &
         to_text(shown(block + 0.4_wp*(along + friction*across) + pull, .true.))//" /"//newline// &
         "&calibrate parameter = 'sticking', cases = 's', sticking_depth = 400 /"))
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual('sticking', field(lines(2)%text, 3))
      call assertEqual(pull, number(lines(2)%text, 21), 1.0e-4_wp*pull)
      run = run_deck_text(deck(friction, rig_group(block)//"&load_case name = 's', operation = 'up', bit_depth = 1000, "// &
         "measured_hookload = 60 /"//newline//"&calibrate parameter = 'sticking', cases = 's', sticking_depth = 400 /"))
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'no weight is left for the string') > 0, message=run%diagnostics)
   end subroutine test_held

   !> The upper 400 m cased: hook load = weight along - wob + (0.4 mu cased + 0.6 mu open) weight across going up; torque that of
   !> the bit and mu r times the contact. What is left to the rig's limits, and of the pipe's yield load at the top.
   subroutine test_sweep()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: text
      real(wp), parameter :: cased(2) = [0.1_wp, 0.3_wp], open(2) = [0.35_wp, 0.2_wp], wob = 20.0_wp, tob = 2.0_wp
      real(wp), parameter :: yield = 931.0e3_wp, area = 0.25_wp*3.141592653589793_wp*(0.127_wp**2 - 0.1086_wp**2)
      real(wp) :: drag, hookload
      integer :: k
      text = replaced(deck(friction, '&rig block_weight = 140, max_hookload = 330, max_torque = 4.5 /'//newline// &
         "&sweep name = 'b', operations = 'up', 'rotary', bit_depth_from = 1000, wob = 0, 20, tob = 0, 2, "// &
         'frictions_cased = 0.1, 0.3, frictions_open = 0.35, 0.2 /'), "&hole name = 'all', diameter = 215.9", &
         "&hole name = 'casing', md_bottom = 400, diameter = 215.9, cased = .true. /"//newline// &
         "&hole name = 'open', diameter = 215.9")
      text = replaced(text, 'mass = 20 /', 'mass = 20, yield = 931 /')
      run = run_deck_text(text)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '.1/.35') > 0, message=run%output)
      call assertTrue(index(run%output, 'Cannot be done at 1000 m: rotary drilling, friction .1/.35 (top drive)') > 0, &
                      message=run%output)
      allocate (lines, source=lines_of(results_path//'/sweep_b.csv'))
      if (anyExceptions()) return
      call assertEqual(5, size(lines))
      if (size(lines) /= 5) return
      do k = 1, 2
         drag = across*(0.4_wp*cased(k) + 0.6_wp*open(k))
         hookload = along + drag
         call assertEqual(hookload, number(lines(1 + k)%text, 5), at_rest, message='up')
         call assertEqual(open(k), number(lines(1 + k)%text, 3), 1.0e-12_wp)
         call assertEqual(cased(k), number(lines(1 + k)%text, 13), 1.0e-12_wp)
         call assertEqual(330.0_wp - block - hookload, number(lines(1 + k)%text, 14), at_rest, message='rig margin')
         call assertEqual(yield*area - hookload, number(lines(1 + k)%text, 16), 1.0e-6_wp*yield*area, message='overpull')
         call assertEqual(along - wob, number(lines(3 + k)%text, 5), at_rest, message='rotary')
         call assertEqual(4.5_wp - tob - 0.0635_wp*drag, number(lines(3 + k)%text, 15), at_rest, message='torque margin')
      end do
      call assertEqual(0, index(run%output, 'friction .1/.35 (string weight)'), message=run%output)
      ! 150 kN at the bit are more than the weight along the hole: the string does not go down by itself.
      run = run_deck_text(replaced(text, 'wob = 0, 20', 'wob = 0, 150'))
      call assertTrue(index(run%output, 'Cannot be done at 1000 m: rotary drilling, friction .1/.35 (string weight)') > 0, &
                      message=run%output)
      call assertEqual(0, index(run%output, 'Cannot be done at 1000 m: up'), message=run%output)
      run = run_deck_text(replaced(text, '0.1, 0.3, frictions_open = 0.35, 0.2', '0.135, 0.3, frictions_open = 0.3475, 0.2'))
      call assertTrue(index(run%output, ' .135/.3475 ') > 0 .and. index(run%output, 'friction .135/.3475 (') > 0, &
                      message='factors of the deck: '//run%output)
      call refuse(replaced(text, 'frictions_cased = 0.1, 0.3', 'frictions_cased = 0.1'), 'they go in pairs')
      call refuse(replaced(text, 'frictions_cased = 0.1, 0.3', 'frictions_cased = 0.1, 3'), 'frictions_cased(2) = 3 is out of')
      call assertEqual(0, index(run%diagnostics, 'go in pairs'), message='one message a fault')
      call refuse(replaced(text, 'cased = .true.', 'cased = .false.'), 'pairs of friction need a hole section with cased = .true.')
      call refuse(replaced(text, 'frictions_cased', 'frictions = 0.2, frictions_cased'), 'keep one way')
      call refuse(replaced(text, 'wob = 0, 20', 'wob = 0, 20, 30'), 'wob has 3 values for 2 operations')
      call refuse('&job rig_limit = 500 /'//newline//text(index(text, newline) + 1:), 'rig_limit of &job under another name')
   contains
      subroutine refuse(bad, expected)
         character(*), intent(in) :: bad, expected
         run = run_deck_text(bad)
         call assertEqual(2, run%status, message=expected)
         call assertTrue(index(run%diagnostics, expected) > 0, message=run%diagnostics)
      end subroutine refuse
   end subroutine test_sweep

   !> A crossing below a river, whose string has no weight along the hole: 1 % less push than it needs is NO, 1 % more is yes. The
   !> numbers beside the answer are followed: friction, weight on bit and depth 2 % to either side, by beams.
   subroutine test_push()
      character(*), parameter :: yes = newline//'push  yes ', no = newline//'push  NO '
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      real(wp) :: push, factor
      run = run_deck_text(crossing(0.35_wp, 50.0_wp, 800.0_wp, 0.0_wp))
      call assertTrue(index(run%output, no) > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), 'String weight alone brings no load to the bit, 50 kN asked. ') > 0, &
                      message=run%output)
      allocate (rows, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      push = -number(rows(2)%text, summary_hookload)
      run = run_deck_text(crossing(0.35_wp, 50.0_wp, 800.0_wp, 0.99_wp*push))
      call assertTrue(index(run%output, no) > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), ' kN of push bring ') > 0, message=run%output)
      call assertTrue(index(run%output, 'must be pushed at surface') > 0, message='a warning: '//run%output)
      factor = told('yes below about ')
      run = run_deck_text(crossing(0.35_wp, 50.0_wp, 0.98_wp*told('Deepest bit depth possible: about '), 0.99_wp*push))
      call assertTrue(index(run%output, yes) > 0, message='shallower: '//run%output)
      run = run_deck_text(crossing(0.98_wp*factor*0.35_wp, 50.0_wp, 800.0_wp, 0.99_wp*push))
      call assertTrue(index(run%output, yes) > 0, message='less friction: '//run%output)
      run = run_deck_text(crossing(0.35_wp, 50.0_wp, 800.0_wp, 1.01_wp*push))
      call assertTrue(index(run%output, yes) > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), 'Close to its limit: push at surface, ') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'must be pushed at surface'), message='no warning: '//run%output)
      run = run_deck_text(crossing(0.35_wp, 50.0_wp, 800.0_wp, 1.5_wp*push))
      call assertTrue(index(unwrapped(run%output), ', by string weight and push') > 0, message=run%output)
      factor = told('NO above about ')
      call bracket(factor*0.35_wp, 0.0_wp, 'friction')
      run = run_deck_text(crossing(0.35_wp, 50.0_wp, 800.0_wp, 1.5_wp*push))
      call bracket(0.0_wp, told('String weight and push bring at most about '), 'weight on bit')
   contains
      !> Yes with 2 % less of a number, NO with 2 % more.
      subroutine bracket(friction, wob, what)
         real(wp), intent(in) :: friction, wob      !< 0: as in the deck
         character(*), intent(in) :: what
         real(wp) :: part
         integer :: k
         do k = -1, 1, 2
            part = 1.0_wp + k*0.02_wp
            run = run_deck_text(crossing(merge(part*friction, 0.35_wp, friction > 0.0_wp), &
                                         merge(part*wob, 50.0_wp, wob > 0.0_wp), 800.0_wp, 1.5_wp*push))
            call assertTrue(index(run%output, trim(merge(yes, no//' ', k < 0))) > 0, message=what//': '//run%output)
         end do
      end subroutine bracket

      !> A number of the answer.
      function told(words) result(value)
         character(*), intent(in) :: words
         real(wp) :: value
         value = value_after(run%output(index(run%output, newline//'push '):), words)
      end function told
   end subroutine test_push

   !> A string that is pushed through a crossing of 800 m.
   function crossing(in_deck, wob, bit_depth, max_push) result(text)
      real(wp), intent(in) :: in_deck, wob, bit_depth, max_push      !< friction [-]; [kN, m, kN]
      character(:), allocatable :: text
      text = "&job plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 100, 250, 550, 700, 800, inc = 78, 78, 90, 90, 102, 102, azi = 6*90 /'//newline// &
         '&hole diameter = 250, friction = '//to_text(in_deck)//' /'//newline//'&fluid density = 1150 /'//newline// &
         "&component name = 'bit', kind = 'bit', length = 0.3, od = 150, id = 50, joint_od = 250 /"//newline// &
         "&component name = 'dp', od = 127, id = 108.6, mass = 32, yield = 931 /"//newline// &
         '&rig max_push = '//to_text(max_push)//' /'//newline// &
         "&load_case name = 'push', operation = 'slide', bit_depth = "//to_text(bit_depth)//', wob = '//to_text(wob)//' /'
   end function crossing

   !> A rig that may push does not hide how much of the string weight drag takes. Weight and push carry drag together.
   subroutine test_no_need()
      real(wp), parameter :: most = 10.0_wp
      type(run_type) :: run
      run = run_deck_text(deck(friction, rig_group(block)))
      call assertTrue(index(unwrapped(run%output), 'string weight along the hole (') > 0, message=run%output)
      run = run_deck_text(deck(friction, replaced(rig_group(block), '&rig', '&rig max_push = '//to_text(most)//',')))
      call assertTrue(index(unwrapped(run%output), 'string weight and push ('//to_text(0.1_wp*floor(10.0_wp*(along + most)), 4)// &
                            ' kN), drag takes ') > 0, &
                      message=run%output)
   end subroutine test_no_need

   !> A rotating string without weight along a level hole needs a push of its weight on bit, in all units.
   subroutine test_push_units()
      character(*), parameter :: units(3) = [character(6) :: 'SI', 'field', 'metric']
      character(*), parameter :: force(3) = [character(4) :: 'kN', 'klbf', 'kdaN']
      character(*), parameter :: sweep = "&sweep name = 'a', operations = 'rotary', bit_depth_from = 1000, wob = 10 /"
      type(run_type) :: run
      integer :: i
      do i = 1, 3
         run = run_deck_text(level(trim(units(i)), '9.9'))
         call assertTrue(index(run%output, newline//'turn  NO ') > 0, message=run%output)
         run = run_deck_text(level(trim(units(i)), '10.1'))
         call assertTrue(index(run%output, newline//'turn  yes ') > 0, message=run%output)
         call assertTrue(index(unwrapped(run%output), 'push at surface, 10 of 10.1 '//trim(force(i))) > 0, message=run%output)
         run = run_deck_text(level(trim(units(i)), '9.9')//newline//sweep)
         call assertTrue(index(unwrapped(run%output), 'Cannot be done at 1000 ') > 0, message=run%output)
         run = run_deck_text(level(trim(units(i)), '10.1')//newline//sweep)
         call assertEqual(0, index(unwrapped(run%output), 'Cannot be done at'), message=run%output)
         run = run_deck_text(level(trim(units(i)), '-1'))
         call assertEqual(2, run%status, message=run%output)
      end do
   contains
      function level(units, max_push) result(text)
         character(*), intent(in) :: units, max_push
         character(:), allocatable :: text
         text = "&job units = '"//units//"', models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
            '&trajectory md = 0, 1000, inc = 2*90, azi = 2*0 /'//newline// &
            '&hole diameter = '//trim(merge('8.5  ', '215.9', units /= 'SI'))//', friction = 0.3 /'//newline// &
            '&fluid density = '// &
            trim(merge('1200', merge('10  ', '1.2 ', units == 'field'), units == 'SI'))//' /'//newline// &
            "&component name = 'collar', kind = 'collar', od = "//trim(merge('6.5  ', '165.1', units /= 'SI'))//', id = '// &
            trim(merge('2.8 ', '71.4', units /= 'SI'))//' /'//newline// &
            '&rig max_push = '//max_push//' /'//newline// &
            "&load_case name = 'turn', operation = 'rotary', bit_depth = 1000, wob = 10 /"
      end function level
   end subroutine test_push_units

   !> Heated casing in a packer, whose hanger must hold its top down.
   subroutine test_hanger()
      character(*), parameter :: text = "&job plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 1200, inc = 0, 0 /'//newline//'&hole diameter = 276, friction = 0.2, cased = .true. /'//newline// &
         '&fluid density = 1000 /'//newline//"&component kind = 'casing', od = 244.5, id = 220.5, mass = 69.9 /"//newline// &
         "&boundary packer_bore = 216.8, packer_hold = 'fixed' /"//newline// &
         "&load_case name = 'cold', operation = 'static', bit_depth = 1200 /"//newline// &
         "&load_case name = 'hot', operation = 'static', bit_depth = 1200, temperature_change_top = 70, "// &
         "temperature_change_bottom = 70, length_reference = 'cold' /"//newline
      character(*), parameter :: held = 'The top must be held down with '
      type(run_type) :: run
      real(wp) :: push
      run = run_deck_text(text)
      call assertTrue(index(run%output, newline//'hot   NO ') > 0, message=run%output)
      call assertTrue(index(run%output, held) > 0, message=run%output)
      push = 0.0_wp
      if (index(run%output, held) > 0) read (run%output(index(run%output, held) + len(held):), *) push
      run = run_deck_text(text//'&rig max_push = '//to_text(0.98_wp*push)//' /')
      call assertTrue(index(run%output, newline//'hot   NO ') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), ' kN possible.') > 0, message=run%output)
      run = run_deck_text(text//'&rig max_push = '//to_text(1.02_wp*push)//' /')
      call assertTrue(index(run%output, newline//'hot   yes ') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), 'push at surface') > 0, message=run%output)
   end subroutine test_hanger

   subroutine test_bad()
      type(run_type) :: run
      run = run_deck_text(deck(friction, '&rig sheave_efficiency = 0.98 /'))
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, deck_path//':8: group &rig: sheave_efficiency = 0.98 needs lines') > 0, &
                      message=run%diagnostics)
      run = run_deck_text(deck(friction, '&rig sheave_efficiency = 98, lines = 10 /'))
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, '0.5 to 1') > 0, message=run%diagnostics)
      run = run_deck_text(deck(friction, rig_group(block)//"&calibrate offset = 'one', apply = .true. /"// &
         newline//"&calibrate offset = 'one', parameter = 'friction_axial', apply = .true. /"))
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'applies an offset to the block_weight of &rig already') > 0, message=run%diagnostics)
      run = run_deck_text(deck(friction, rig_group(1.0e3_wp)), options='--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'the block counted in') > 0, message=run%output)
   end subroutine test_bad
end module dg_test_rig_runs
