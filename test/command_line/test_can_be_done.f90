!> The answer to 'can it be done?' as a run prints and writes it: terminal, summary.csv, sweep, page, exit status.
module dg_test_can_be_done
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: content, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: field, lines_of, value_after
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: can_be_done_suite

   character(*), parameter :: newline = achar(10)
   integer, parameter :: col_hookload = 8, col_torque = 14, col_status = 16, col_answer = 31

contains

   function can_be_done_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('can_be_done')
      call suite%addTest(TestMethod('terminal_and_summary', test_terminal))
      call suite%addTest(TestMethod('answers_of_a_doubtful_deck', test_doubtful_deck))
      call suite%addTest(TestMethod('advice_followed', test_advice))
      call suite%addTest(TestMethod('torque_advice_followed', test_torque))
      call suite%addTest(TestMethod('more_friction_in_coils', test_more_friction))
      call suite%addTest(TestMethod('weight_that_string_brings', test_most_weight))
      call suite%addTest(TestMethod('overpull_left_out', test_overpull))
      call suite%addTest(TestMethod('reaming', test_reaming))
      call suite%addTest(TestMethod('depth_that_is_reached', test_reach))
      call suite%addTest(TestMethod('depth_within_strengths_and_rig', test_limit_reach))
      call suite%addTest(TestMethod('locked_up_without_numbers', test_locked_up))
      call suite%addTest(TestMethod('no_empty_chart', test_no_empty_chart))
      call suite%addTest(TestMethod('less_weight_than_locks_up', test_less_weight))
      call suite%addTest(TestMethod('what_string_weight_can_do', test_ways_down))
      call suite%addTest(TestMethod('several_limits', test_several))
      call suite%addTest(TestMethod('sweep', test_sweep))
      call suite%addTest(TestMethod('sweep_as_load_case', test_sweep_as_case))
      call suite%addTest(TestMethod('page', test_page))
      call suite%addTest(TestMethod('models_on_page', test_models))
      call suite%addTest(TestMethod('answers_on_paper', test_paper))
      call suite%addTest(TestMethod('head_and_jar', test_head))
   end function can_be_done_suite

   !> A lateral in field units by the soft string. `loads` stand in the load case of sliding.
   function deck(loads, plots) result(text)
      character(*), intent(in) :: loads
      logical, intent(in) :: plots
      character(:), allocatable :: text
      text = "&job units = 'field', models = 'soft', hdf5 = .false., profiles = .false., plots = "// &
         trim(merge('.true. ', '.false.', plots))//' /'//newline// &
         '&trajectory md = 0, 2000, 8200, 9200, 12000, 15000'//newline// &
         '  inc = 0, 0, 0, 90, 90, 90, azi = 178, 178, 178, 178, 178, 178 /'//newline// &
         "&hole name = 'casing', md_bottom = 8000, diameter = 8.681, friction = 0.20, cased = .true. /"//newline// &
         "&hole name = 'open', diameter = 8.5, friction = 0.30 /"//newline// &
         '&fluid density = 9.6 /'//newline// &
         '&rig max_hookload = 500, block_weight = 0, max_torque = 30 /'//newline// &
         "&component name = 'bit', kind = 'bit', length = 1, od = 6.0, joint_od = 8.5 /"//newline// &
         "&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 /"//newline// &
         "&component name = 'jar', kind = 'jar', length = 30, od = 6.5, id = 2.75 /"//newline// &
         "&component name = 'DP', od = 5, id = 4.276, mass = 20.87, joint_od = 6.625, yield = 135 /"//newline// &
         "&load_case name = 'up', operation = 'up', bit_depth = 15000 /"//newline// &
         "&load_case name = 'slide', bit_depth = 15000, "//loads//' /'//newline
   end function deck

   !> Answers from a deck with a warning begin with a line that says so.
   subroutine test_doubtful_deck()
      character(*), parameter :: line = 'There is 1 warning, on the deck. Read it before you use these answers.'
      type(run_type) :: run
      run = run_deck_text(deck("operation = 'rotate_off_bottom'", .false.))
      call assertEqual(0, index(run%output, 'before you use these answers'), message=run%output)
      run = run_deck_text(replaced(deck("operation = 'rotate_off_bottom'", .true.), 'yield = 135', 'yield = 931'))
      call assertTrue(index(run%output, newline//line//newline) > 0, message=run%output)
      call assertTrue(index(content(results_path//'/report.html'), '<p class="note warn">'//line) > 0, message='on the page')
      call assertTrue(index(run%output, 'WOB where buckling begins') == 0, message='no WOB in this case: '//run%output)
   end subroutine test_doubtful_deck

   !> A no is an answer: exit status 0, the reason with numbers, a mark in Table 1.
   subroutine test_terminal()
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      run = run_deck_text(deck("operation = 'sliding', wob = 150", .false.))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Can it be done?') < index(run%output, 'Model soft'), message='first: '//run%output)
      call assertTrue(index(run%output, newline//'slide  NO       Sliding drilling at 15000 ft. String weight alone brings ') > 0, &
                      message=run%output)
      call assertTrue(index(run%output, newline//'up     yes ') > 0, message=run%output)
      call assertTrue(index(run%output, 'Can it be done?'//newline// &
                            "1 of 2: yes. NO: 'slide'. Of those that can be done, nearest to a limit: 'up', ") > 0, &
                      message=run%output)
      call assertTrue(index(run%output, 'WOB where buckling begins   0.0 klbf (slide, buckles without WOB)') > 0, &
                      message=run%output)
      call assertTrue(index(run%output, newline//'! cannot be done') > 0, message=run%output)
      call assertTrue(index(run%output, newline//'    without MWD, jar (no yield)'//newline) > 0, message=run%output)
      allocate (rows, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      call assertEqual('can_be_done', field(rows(1)%text, col_answer))
      call assertTrue(index(rows(2)%text, ',yes,') > 0, message=rows(2)%text)
      call assertTrue(index(rows(3)%text, ',no,"String weight alone brings ') > 0, message=rows(3)%text)
      call assertTrue(index(rows(3)%text, ' to the bit, 150 klbf asked",') > 0, message=rows(3)%text)
   end subroutine test_terminal

   !> 'Rotate the string' and 'The answer becomes yes below' are followed with the friction and the numbers as they stand there:
   !> it can be done, and the hook load is as said. More friction than 'The answer becomes NO above' is too much.
   subroutine test_advice()
      character(*), parameter :: loads = "operation = 'sliding', wob = 50, friction = "
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      character(:), allocatable :: hookload
      real(wp) :: found, promised, turned, factor
      run = run_deck_text(deck(loads//'0.5', .false.))
      call assertTrue(index(run%output, newline//'slide  NO ') > 0, message=run%output)
      promised = value_after(run%output, 'its weight is enough then, hook load at most about ')
      call assertTrue(index(unwrapped(run%output), ' without bit torque, by the soft string. Check it by') > 0, message=run%output)
      turned = value_after(run%output, ', torque about ')
      factor = factor_after('The answer becomes yes below about ')
      run = run_deck_text(deck("operation = 'rotary', wob = 50, friction = 0.5", .false.))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      allocate (rows, source=lines_of(results_path//'/summary.csv'))
      hookload = field(rows(3)%text, col_hookload)
      read (hookload, *) found
      call assertTrue(abs(found - promised) < 0.01_wp*promised, message='hook load of a string that turns: '//hookload)
      hookload = field(rows(3)%text, col_torque)
      read (hookload, *) found
      ! contact of coils counts, which this model leaves out
      call assertTrue(abs(found - turned) < 0.1_wp*turned, message=hookload//' of torque, told '//to_text(turned))
      run = run_deck_text(replaced(deck(loads//'0.5', .false.), 'max_torque = 30', 'max_torque = '//to_text(0.9_wp*turned)))
      call assertEqual(0, index(run%output, 'Rotate the string'), message='beyond the top drive: '//run%output)
      run = run_deck_text(deck(loads//to_text(0.5_wp*factor), .false.))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      run = run_deck_text(deck("operation = 'sliding', wob = 20, friction = 0.27", .false.))
      factor = factor_after('answer becomes NO above about ')
      run = run_deck_text(deck("operation = 'sliding', wob = 20, friction = "//to_text(0.27_wp*factor), .false.))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      run = run_deck_text(deck("operation = 'sliding', wob = 20, friction = "//to_text(0.27_wp*1.02_wp*factor), .false.))
      call assertTrue(index(run%output, newline//'slide  NO ') > 0, message=run%output)
   contains
      !> Factor of friction of the sliding case behind words.
      function factor_after(words) result(value)
         character(*), intent(in) :: words
         real(wp) :: value
         character(:), allocatable :: number
         value = value_after(unwrapped(run%output(index(run%output, newline//'slide '):)), words)
      end function factor_after
   end subroutine test_advice

   !> 'The answer becomes yes at about' after a NO by torque of the top drive: yes with 1 % less friction than that, NO with 1 %
   !> more. By beams the factor is an estimate: 4 %.
   subroutine test_torque()
      character(*), parameter :: models(2) = ['soft', 'mcge']
      real(wp), parameter :: beside(2) = [0.01_wp, 0.04_wp]
      character(:), allocatable :: factor
      type(run_type) :: run
      real(wp) :: part
      integer :: i, k
      do i = 1, 2
         run = run_deck_text(turning(models(i), 1.0_wp))
         call assertTrue(index(unwrapped(run%output), 'Torque of the top drive: ') > 0, message=run%output)
         part = value_after(run%output, 'The answer becomes yes below about ')
         do k = -1, 1, 2
            run = run_deck_text(turning(models(i), part*(1.0_wp + k*beside(i))))
            call assertTrue(index(run%output, newline//'slide  '//trim(merge('yes', 'NO ', k < 0))//' ') > 0, message=run%output)
         end do
      end do
   contains
      !> Rotary drilling with part of the friction, by a top drive that is too weak.
      function turning(model, part) result(text)
         character(*), intent(in) :: model
         real(wp), intent(in) :: part
         character(:), allocatable :: text
         text = replaced(deck("operation = 'rotary', wob = 5, tob = 3, friction = "//to_text(0.3_wp*part), .false.), &
                         'max_torque = 30', 'max_torque = 10')
         text = replaced(text, "models = 'soft'", "models = '"//model//"'")
      end function turning
   end subroutine test_torque

   !> 'run it with more friction' after a yes of beams that turn in helical buckling: with twice and four times the friction there
   !> is an answer each, and the last is NO by torque.
   subroutine test_more_friction()
      type(run_type) :: run
      run = run_deck_text(coiled(0.3_wp))
      call assertTrue(index(unwrapped(run%output), 'as the string turns under more than its helical load. Find it by a '// &
                            'sweep with several frictions') > 0, message=run%output)
      run = run_deck_text(coiled(0.6_wp))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      run = run_deck_text(coiled(1.2_wp))
      call assertTrue(index(run%output, newline//'slide  NO ') > 0, message=run%output)
      call assertTrue(index(run%output, 'Torque of the top drive: ') > 0, message=run%output)
   contains
      function coiled(friction) result(text)
         real(wp), intent(in) :: friction
         character(:), allocatable :: text
         text = replaced(deck("operation = 'rotary', wob = 30, tob = 3, friction = "//to_text(friction), .false.), &
                         "models = 'soft'", "models = 'mcge'")
      end function coiled
   end subroutine test_more_friction

   !> 'String weight brings at most about' a load to the bit, of a yes: yes with 1 % less, NO with 1 % more.
   subroutine test_most_weight()
      type(run_type) :: run
      character(:), allocatable :: number
      real(wp) :: most
      run = run_deck_text(deck("operation = 'sliding', wob = 5, friction = 0.25", .false.))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      most = value_after(run%output, 'String weight brings at most about ')
      run = run_deck_text(deck("operation = 'sliding', friction = 0.25, wob = "//to_text(0.99_wp*most), .false.))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      run = run_deck_text(deck("operation = 'sliding', friction = 0.25, wob = "//to_text(1.01_wp*most), .false.))
      call assertTrue(index(run%output, newline//'slide  NO ') > 0, message=run%output)
   end subroutine test_most_weight

   !> Overpull is left out. After 'Not possible without overpull either': NO, by as much as it says. After 'Overpull up to about':
   !> yes with that overpull.
   subroutine test_overpull()
      character(*), parameter :: excess = 'Not possible without overpull either: hook load with block (rig) '
      type(run_type) :: run
      character(:), allocatable :: told
      run = run_deck_text(deck_of('-200', '300'))
      call assertTrue(index(unwrapped(run%output), 'verpull up to about ') > 0, message=run%output)
      run = run_deck_text(deck_of('0', '300'))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      run = run_deck_text(deck_of('-200', '205'))
      told = to_text(value_after(run%output, excess))
      run = run_deck_text(deck_of('0', '205'))
      call assertTrue(index(unwrapped(run%output), ', '//told//' klbf too much') > 0, message=told//' told; '//run%output)
      run = run_deck_text(deck_of('-90', '300'))
      run = run_deck_text(deck_of('-'//to_text(value_after(run%output, 'verpull up to about ')), '300'))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
   contains
      !> Pulling with weight on bit and rig limit [klbf].
      function deck_of(wob, limit) result(text)
         character(*), intent(in) :: wob, limit
         character(:), allocatable :: text
         text = replaced(deck("operation = 'up', wob = "//wob, .false.), 'max_hookload = 500', 'max_hookload = '//limit)
      end function deck_of
   end subroutine test_overpull

   !> 'Rotate the string' where it does not go down by itself: reaming can be done, with that hook load.
   subroutine test_reaming()
      character(*), parameter :: advice = "Check it by a case operation = 'reaming' with rpm and trip_speed"
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      character(:), allocatable :: hookload
      real(wp) :: found, promised
      run = run_deck_text(deck("operation = 'down', friction = 0.6", .false.))
      call assertTrue(index(unwrapped(run%output), advice) > 0, message=run%output)
      promised = value_after(run%output, 'its weight is enough then, hook load at most about ')
      run = run_deck_text(deck("operation = 'reaming', rpm = 20, trip_speed = 3, friction = 0.6", .false.))
      call assertTrue(index(unwrapped(run%output), '. Move the string more slowly, or rotate it faster: drag falls with '// &
                            'trip_speed over rpm') > 0, message=run%output)
      run = run_deck_text(deck("operation = 'reaming', rpm = 120, trip_speed = 0.02, friction = 0.6", .false.))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      allocate (rows, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      hookload = field(rows(3)%text, col_hookload)
      read (hookload, *) found
      call assertTrue(abs(found - promised) < 0.01_wp*promised, message='hook load of a string that turns: '//hookload)
   end subroutine test_reaming

   !> 'Deepest bit depth possible: about' a depth: yes 1 % above it, NO 1 % below it.
   subroutine test_reach()
      type(run_type) :: run
      character(:), allocatable :: slide, depth
      real(wp) :: reach
      slide = deck("operation = 'sliding', wob = 30, friction = 0.4", .false.)
      run = run_deck_text(slide)
      reach = value_after(run%output, 'Deepest bit depth possible: about ')
      run = run_deck_text(replaced(slide, "'slide', bit_depth = 15000", "'slide', bit_depth = "//to_text(0.99_wp*reach)))
      call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=run%output)
      run = run_deck_text(replaced(slide, "'slide', bit_depth = 15000", "'slide', bit_depth = "//to_text(1.01_wp*reach)))
      call assertTrue(index(run%output, newline//'slide  NO ') > 0, message=run%output)
   end subroutine test_reach

   !> The same after a NO by hook load and by torque: yes at that depth, NO 2 % below it. Where torque on bit alone is more than the
   !> top drive has, no depth is possible.
   subroutine test_limit_reach()
      character(*), parameter :: models(2) = ['soft', 'mcge']
      type(run_type) :: run
      integer :: i
      do i = 1, 2
         call check(models(i), "operation = 'up'", 'max_hookload = 500', 'max_hookload = 180')
         call check(models(i), "operation = 'rotary', wob = 5, tob = 3", 'max_torque = 30', 'max_torque = 10')
      end do
      run = run_deck_text(deck("operation = 'rotary', wob = 30, tob = 31", .false.))
      call assertTrue(index(unwrapped(run%output), 'Torque of the top drive: ') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), 'No shallower bit depth is possible either') > 0, message=run%output)
      call assertEqual(3, unsolved('31', 'NO       Rotary drilling at 15000 ft. Torque of the top drive: 31 kft.lbf at the bit '// &
                                   'alone, 30 kft.lbf allowed, 1 kft.lbf too much. There is no solution: tension, torque and '// &
                                   'bending along the string are not known. No other limit is judged'))
      call assertEqual(3, unsolved('29', 'unknown  Rotary drilling at 15000 ft. Not converged'))
   contains
      !> Exit status of a case that has not converged, with a torque on bit [kft.lbf] and its answer.
      integer function unsolved(tob, answer)
         character(*), intent(in) :: tob, answer
         run = run_deck_text(replaced(deck("operation = 'rotary', wob = 30, tob = "//tob, .false.), "'soft'", "'mcge'")// &
                             '&solver max_iterations = 1 /'//newline)
         unsolved = run%status
         call assertTrue(index(unwrapped(run%output), newline//'slide  '//answer) > 0, message=run%output)
      end function unsolved

      subroutine check(model, loads, old, new)
         character(*), intent(in) :: model, loads, old, new
         character(:), allocatable :: text, depth
         real(wp) :: reach
         text = replaced(replaced(deck(loads, .false.), "models = 'soft'", "models = '"//model//"'"), old, new)
         run = run_deck_text(text)
         reach = value_after(run%output(index(run%output, newline//'slide '):), 'Deepest bit depth possible: about ')
         run = run_deck_text(replaced(text, "'slide', bit_depth = 15000", "'slide', bit_depth = "//to_text(reach)))
         call assertTrue(index(run%output, newline//'slide  yes ') > 0, message=depth//' told: '//run%output)
         run = run_deck_text(replaced(text, "'slide', bit_depth = 15000", "'slide', bit_depth = "//to_text(1.02_wp*reach)))
         call assertTrue(index(run%output, newline//'slide  NO ') > 0, message=depth//' told: '//run%output)
      end subroutine check
   end subroutine test_limit_reach

   !> By beams 20,000 klbf lock the string up: no hook load, no torque.
   subroutine test_locked_up()
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      run = run_deck_text(replaced(deck("operation = 'rotary', wob = 20000", .false.), "models = 'soft'", "models = 'mcge'"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, newline//'NOT CHECKED, as the deck gives no limit: ') > 0, message=run%output)
      allocate (rows, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      call assertEqual('locked_up', field(rows(3)%text, col_status))
      call assertEqual('', field(rows(3)%text, col_hookload), message='hook load')
      call assertEqual('', field(rows(3)%text, col_torque), message='torque')
      call assertTrue(index(rows(3)%text, ',no,') > 0, message=rows(3)%text)
   end subroutine test_locked_up

   !> Where all cases lock up there is no chart of hook loads, and the page says so.
   subroutine test_no_empty_chart()
      character(*), parameter :: locked = "operation = 'rotary', wob = 20000"
      type(run_type) :: run
      character(:), allocatable :: page
      logical :: there
      page = replaced(deck(locked, .true.), "operation = 'up'", locked)
      run = run_deck_text(replaced(page, "models = 'soft'", "models = 'mcge'"))
      call assertEqual(0, run%status, message=run%diagnostics)
      page = content(results_path//'/report.html')
      call assertTrue(index(page, '">Not drawn, as no value is known: Hook load of all cases. ') > 0)
      call assertEqual(0, index(page, '<svg'), message='a chart')
      inquire (file=results_path//'/pictures/hookload.gp', exist=there)
      call assertFalse(there, message='the script of a chart')
   end subroutine test_no_empty_chart

   !> The weight on bit that is said to arrive without a push does so within 2 %.
   subroutine test_less_weight()
      real(wp), parameter :: part(2) = [0.98_wp, 1.02_wp]
      character(*), parameter :: answer(2) = [',yes,', ',no, ']
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      character(:), allocatable :: text, most
      real(wp) :: wob
      integer :: i
      text = replaced(deck("operation = 'sliding', wob = 150", .false.), "models = 'soft'", "models = 'mcge'")
      text = text//"&solver tool_joints = 'smeared', fidelity = 'fast' /"//newline
      run = run_deck_text(text)
      wob = value_after(content(results_path//'/summary.csv'), 'Without a push ')
      do i = 1, 2
         run = run_deck_text(replaced(text, '150 ', to_text(part(i)*wob)//' '))
         rows = lines_of(results_path//'/summary.csv')
         if (anyExceptions()) return
         call assertEqual('converged', field(rows(3)%text, col_status))
         call assertTrue(index(rows(3)%text, trim(answer(i))) > 0, message=rows(3)%text)
      end do
   end subroutine test_less_weight

   !> Where beams lock up, the weight on bit, the friction and the depth that are told are followed: yes with 3 % less, NO with 3 %
   !> more.
   subroutine test_ways_down()
      type(run_type) :: run
      real(wp) :: wob, factor, depth
      run = run_slide(15000.0_wp, 60.0_wp, 1.0_wp)
      wob = told('String weight alone brings ')
      factor = told('String weight is enough below about ')
      depth = told('Deepest bit depth possible: about ')
      call expect('yes', 15000.0_wp, 0.97_wp*wob, 1.0_wp)
      call expect('NO ', 15000.0_wp, 1.03_wp*wob, 1.0_wp)
      call expect('yes', 15000.0_wp, 60.0_wp, 0.97_wp*factor)
      call expect('NO ', 15000.0_wp, 60.0_wp, 1.03_wp*factor)
      call expect('yes', 0.97_wp*depth, 60.0_wp, 1.0_wp)
      call expect('NO ', 1.03_wp*depth, 60.0_wp, 1.0_wp)
   contains
      !> A number of the answer.
      function told(words) result(value)
         character(*), intent(in) :: words
         real(wp) :: value
         character(:), allocatable :: number
         value = value_after(run%output, words)
      end function told

      !> Checks the answer to another case.
      subroutine expect(answer, bit_depth, weight, friction_scale)
         character(*), intent(in) :: answer
         real(wp), intent(in) :: bit_depth, weight, friction_scale   !< [ft, klbf, -]
         run = run_slide(bit_depth, weight, friction_scale)
         call assertTrue(index(run%output, newline//'slide  '//answer//' ') > 0, message=answer//' wanted: '//run%output)
      end subroutine expect

      !> Slides by beams on long elements.
      function run_slide(bit_depth, weight, friction_scale) result(run)
         real(wp), intent(in) :: bit_depth, weight, friction_scale   !< [ft, klbf, -]
         type(run_type) :: run
         character(:), allocatable :: text
         text = replaced(deck("operation = 'sliding', friction = "//to_text(0.3_wp*friction_scale)//', wob = '// &
                              to_text(weight), .false.), "models = 'soft'", "models = 'mcge'")
         text = replaced(text, "&load_case name = 'up', operation = 'up', bit_depth = 15000 /", '')
         text = replaced(text, "'slide', bit_depth = 15000", "'slide', bit_depth = "//to_text(bit_depth))
         run = run_deck_text(text//"&solver fidelity = 'fast' /"//newline)
      end function run_slide
   end subroutine test_ways_down

   !> The depth from which it cannot be done, and the rows that say so.
   subroutine test_sweep()
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      integer :: i, no
      run = run_deck_text(deck("operation = 'sliding', wob = 10", .false.)// &
         "&sweep name = 'b', operations = 'sliding', bit_depth_from = 9500, bit_depth_step = 500, frictions = 0.5, wob = 20 /"// &
         newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Cannot be done from ') > 0, message=run%output)
      allocate (rows, source=lines_of(results_path//'/sweep_b.csv'))
      if (anyExceptions()) return
      no = 0
      do i = 2, size(rows)
         if (index(rows(i)%text, ',no,') > 0) no = no + 1
      end do
      call assertTrue(no > 0 .and. no < size(rows) - 1, message='rows that cannot be done')
      call assertTrue(index(rows(2)%text, ',yes,') > 0, message=rows(2)%text)
   end subroutine test_sweep

   !> Casing with air above mud is too light and collapses: both are told, and nothing that would make it heavy enough alone. Slips
   !> hold the liner that is at surface. Less overpull must keep all limits. Running forces of bows do not grow with friction.
   subroutine test_several()
      character(*), parameter :: head = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline
      type(run_type) :: run
      character(:), allocatable :: text
      run = run_deck_text(head//'&trajectory md = 0, 2500, 3400, 6500, inc = 0, 0, 88, 88, azi = 4*0 /'//newline// &
         '&hole diameter = 311, friction = 0.6 /'//newline//"&fluid density = 1500, where = 'outside' /"//newline// &
         "&fluid density = 300, where = 'inside' /"//newline// &
         '&component od = 244.5, id = 220.5, mass = 70, yield = 552 /'//newline// &
         "&load_case name = 'c', operation = 'down', bit_depth = 6500 /"//newline)
      text = unwrapped(run%output)
      call assertTrue(index(text, 'of push needed at surface. Also too much: collapse, 37.6 of 32.9 MPa') > 0, message=text)
      call assertEqual(0, index(text, 'Also passed'), message=text)
      call assertEqual(0, index(text, 'Deepest bit depth') + index(text, 'Rotate the string') + index(text, 'becomes yes'), &
                       message='advice by weight: '//text)
      run = run_deck_text(head//'&trajectory md = 0, 2000, inc = 0, 0 /'//newline//'&hole diameter = 311, friction = 0.2 /'// &
         newline//'&fluid density = 1200 /'//newline//'&strength slip_length = 150 /'//newline// &
         "&component name = 'liner', length = 1500, od = 244.5, id = 220.5, mass = 70, yield = 379 /"//newline// &
         '&component od = 127, id = 108.6, mass = 31.9, yield = 931 /'//newline// &
         "&load_case name = 'c', operation = 'down', bit_depth = 1495 /"//newline)
      ! Reinhold and Spiri: 3322 kN/3.859
      call assertTrue(index(unwrapped(run%output), 'Hook load off bottom (slips): 869.38 kN, 860.95 kN allowed') > 0, &
                      message=run%output)
      text = head//'&trajectory md = 0, 3440, inc = 0, 0 /'//newline//'&hole diameter = 155, friction = 0.3 /'//newline// &
         '&fluid density = 1200 /'//newline//'&rig block_weight = 300, max_hookload = 740 /'//newline// &
         '&component od = 88.9, id = 76, mass = 14, yield = 300 /'//newline// &
         "&load_case name = 'c', operation = 'up', bit_depth = 3440, wob = -250 /"//newline
      run = run_deck_text(text)
      call assertTrue(index(unwrapped(run%output), 'verpull up to about 39.9 kN is possible') > 0, message=run%output)
      run = run_deck_text(replaced(text, '-250', '-39.9'))
      call assertTrue(index(run%output, newline//'c  yes') > 0, message=run%output)
      text = head//'&trajectory md = 0, 1000, 1300, 3000, inc = 0, 0, 60, 60, azi = 4*0 /'//newline// &
         '&hole diameter = 311, friction = 0.3 /'//newline//'&fluid density = 1200 /'//newline// &
         "&component name = 'csg', od = 244.5, id = 220.5, yield = 552 /"//newline//"&centralizer component = 'csg', "// &
         "kind = 'bow', od = 330, spacing = 24, restoring_force = 8, rated_hole = 311, running_force = 5 /"//newline// &
         "&load_case name = 'c', operation = 'down', bit_depth = 3000 /"//newline
      run = run_deck_text(text)
      call check_reserve(0.99_wp, 'yes')
      call check_reserve(1.02_wp, 'NO ')
   contains
      !> The answer at a part of the largest friction that was told.
      subroutine check_reserve(part, answer)
         real(wp), intent(in) :: part
         character(*), intent(in) :: answer
         type(run_type) :: other
         character(:), allocatable :: number
         real(wp) :: factor
         factor = value_after(unwrapped(run%output), 'answer becomes NO above about ')
         other = run_deck_text(replaced(text, 'friction = 0.3', 'friction = '//to_text(0.3_wp*factor*part)))
         call assertTrue(index(other%output, newline//'c  '//answer) > 0, message=other%output)
      end subroutine check_reserve
   end subroutine test_several

   !> A point of a sweep has the answer and the limit of a load case at its depth: make-up torque, slips, design factors.
   subroutine test_sweep_as_case()
      call check('load_case', 'load_case', 'yes', '')
      call check('yield = 135', 'yield = 135, makeup_torque = 5', 'no', 'make_up_torque')
      call check('&load_case', "&strength slip_length = 1 /"//newline//'&load_case', 'no', 'slips')
      call check('&load_case', "&strength tension_factor = 5 /"//newline//'&load_case', 'no', 'tension')
   contains
      subroutine check(old, new, answer, limit)
         character(*), intent(in) :: old, new, answer, limit
         type(run_type) :: run
         type(text_type), allocatable :: rows(:)
         run = run_deck_text(replaced(deck("operation = 'reaming', rpm = 60, trip_speed = 0.1", .false.), old, new)// &
            "&sweep name = 'c', operations = 'reaming', bit_depth_from = 15000, rpm = 60, trip_speed = 0.1 /"//newline)
         call assertEqual(0, run%status, message=run%diagnostics)
         rows = lines_of(results_path//'/summary.csv')
         call assertTrue(index(rows(3)%text, ','//answer//',') > 0 .and. index(rows(3)%text, ','//limit) > 0, message=rows(3)%text)
         rows = lines_of(results_path//'/sweep_c.csv')
         call assertTrue(index(rows(2)%text, ','//answer//','//limit) > 0, message=rows(2)%text)
      end subroutine check
   end subroutine test_sweep_as_case

   !> The page begins with the answer.
   subroutine test_page()
      type(run_type) :: run
      character(:), allocatable :: page
      run = run_deck_text(deck("operation = 'sliding', wob = 150", .true.))
      page = content(results_path//'/report.html')
      call assertTrue(index(page, '<h2>') == index(page, '<h2>Can it be done?</h2>'), message='the first heading')
      call assertTrue(index(page, '<b class="no">NO</b>') > 0)
      call assertEqual(0, index(page, 'No warnings'), message='beside a NO')
      call assertTrue(index(page(:index(page, '<details')), 'scope="col">largest bending moment<') > 0, message='not folded')
   end subroutine test_page

   !> Results of the model that answers stand first, under its name, wherever it stands in the deck.
   subroutine test_models()
      type(run_type) :: run
      character(:), allocatable :: page
      run = run_deck_text(replaced(deck("operation = 'sliding', wob = 10", .true.), "models = 'soft'", &
                                   "models = 'soft', 'mcge'")//"&solver fidelity = 'fast' /"//newline)
      page = content(results_path//'/report.html')
      page = page(index(page, '<h2>Hook load, friction, torque</h2>'):)
      call assertTrue(index(page, '<h3>Model mcge</h3>') > 0, message='its name')
      call assertTrue(index(page, '<h3>Model mcge</h3>') < index(page, '<table>'), message='above its table')
      call assertTrue(index(page, '<table>') < index(page, '<summary>Model soft</summary>'), message='before the other')
   end subroutine test_models

   !> On paper answers stand in the order of their urgency, and one row tells of those that follow the notes.
   subroutine test_paper()
      type(run_type) :: run
      character(:), allocatable :: page, text
      integer :: i
      text = deck("operation = 'sliding', wob = 150", .true.)
      do i = 1, 3
         text = text//'&load_case name = ''s'//to_text(i)//''', bit_depth = 15000, operation = ''sliding'', wob = 150 /'//newline
      end do
      run = run_deck_text(text)
      page = content(results_path//'/report.html')
      call assertEqual(0, index(page, '<tr style="order:'), message='five answers have room')
      run = run_deck_text(text//"&load_case name = 's4', bit_depth = 15000, operation = 'sliding', wob = 150 /"//newline)
      page = content(results_path//'/report.html')
      call assertTrue(index(page, '>1 more below, yes, at most ') > 0, message='one more')
      run = run_deck_text(text//"&load_case name = 's4', bit_depth = 15000, operation = 'sliding', wob = 150 /"//newline// &
                          "&load_case name = 's5', bit_depth = 15000, operation = 'sliding', wob = 150 /"//newline)
      page = content(results_path//'/report.html')
      call assertTrue(index(page, '<td class="text" colspan="3">2 more below, 1 NO, 1 yes.</td>') > 0, message='two more')
      call assertTrue(index(page, '<tr style="order:17"><td class="text"><a href="#case=up&amp;') > 0, message='the last')
      call assertTrue(index(page, '<tr style="order:1"><td class="text"><a href="#case=slide') > 0, message='the first')
   end subroutine test_paper

   !> Depths and weights, and the axial force at a jar.
   subroutine test_head()
      type(run_type) :: run
      run = run_deck_text(replaced(deck("operation = 'sliding', wob = 10", .false.), 'friction = 0.30', 'friction = 0.3025'))
      call assertTrue(index(run%output, 'Well to 15000 ft, true vertical depth 8836.6 ft. '// &
                            'Largest inclination 90 deg at 9200 ft, dogleg 9 deg/100 ft at 9200 ft') > 0, message=run%output)
      call assertTrue(index(run%output, newline//'String, bit at 15000 ft: ') > 0, message=run%output)
      call assertTrue(index(run%output, newline//'Friction factor 0.2 in casing, 0.3025 in open'//newline) > 0, message=run%output)
      call assertTrue(index(run%output, newline//'Least radial clearance 0.875 in: MWD at 14999 ft'//newline) > 0, &
                      message=run%output)
      run = run_deck_text(deck("operation = 'sliding', friction = 0.25, wob = 10", .false.), '--check')
      call assertTrue(index(run%output, '. 1 of 2 load cases have their own, 0.25'//newline) > 0, message=run%output)
      run = run_deck_text(deck("operation = 'sliding', wob = 10", .false.))
      call assertTrue(index(run%output, '  Jar in slide: compression of ') > 0, message=run%output)
      run = run_deck_text(deck("operation = 'sliding', wob = 10", .false.), '--check')
      call assertTrue(index(run%output, newline//'Well to 15000 ft') > 0, message=run%output)
      ! in open hole of 8.5 in; the pipe reaches into it, though most of it stands in casing
      call assertTrue(index(run%output, 'joints 8.5 in, clearance 0 in'//newline) > 0, message=run%output)
      call assertTrue(index(run%output, 'lbm/gal, clearance 0.875 in'//newline) > 0, message=run%output)
      call assertTrue(index(run%output, 'joints 6.625 in, clearance 0.9375 in, yield 135 ksi') > 0, message=run%output)
   end subroutine test_head
end module dg_test_can_be_done
