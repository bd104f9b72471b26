!> Runs with a rig: what its indicator shows is what measurements are compared with, in tables, broomsticks, calibrations and of
!> strings that are held. A straight hole, where hook loads are a product.
module dg_test_rig_runs
   use funit, only: anyExceptions, assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: content, deck_path, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: field, lines_of, number
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
   integer, parameter :: summary_indicator = 30, sweep_indicator = 12

contains

   function rig_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('rig_runs')
      call suite%addTest(TestMethod('what_is_shown', test_shown))
      call suite%addTest(TestMethod('block_from_measurements', test_block))
      call suite%addTest(TestMethod('measured_without_block', test_without_block))
      call suite%addTest(TestMethod('held_string', test_held))
      call suite%addTest(TestMethod('sweep_of_pairs_and_limits', test_sweep))
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
