!> Sweeps as a user runs them: the same results alone, interrupted, or in parts on several machines; what does not fit is
!> refused by name.
module dg_test_sweep_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertRelativelyEqual, assertTrue, TestMethod, &
      TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_kinds, only: wp
   use dg_program_run, only: content, deck_path, good_deck, is_result, replaced, results_path, run_deck_text, run_interrupted, &
      run_program, run_type, unwrapped
   use dg_result_rows, only: field, lines_of, number
   use dg_text, only: append_text, text_type, to_text
   implicit none
   private
   public :: sweep_runs_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: csv = results_path//'/sweep_b.csv', partial = results_path//'/sweep_b.partial'
   character(*), parameter :: group = "&sweep name = 'b', frictions = 0.2, 0.3, bit_depth_step = 100 /"//newline
   character(*), parameter :: again = deck_path//' --output '//results_path//' '
   !> Model and operation, two friction factors, nine depths and that of no measurement.
   integer, parameter :: points = 3*2*9

contains

   function sweep_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('sweep_runs')
      call suite%addTest(TestMethod('locked_up_point', test_locked_up))
      call suite%addTest(TestMethod('points_are_load_cases', test_points))
      call suite%addTest(TestMethod('measured_points', test_measured))
      call suite%addTest(TestMethod('all_models_and_field_units', test_models))
      call suite%addTest(TestMethod('threads', test_threads))
      call suite%addTest(TestMethod('resumed', test_resumed))
      call suite%addTest(TestMethod('ended_by_signals', test_signals))
      call suite%addTest(TestMethod('changed_deck', test_changed_deck))
      call suite%addTest(TestMethod('four_parts', test_parts))
      call suite%addTest(TestMethod('refused_parts', test_refused_parts))
      call suite%addTest(TestMethod('no_solution', test_no_solution))
      call suite%addTest(TestMethod('bad_groups', test_bad_groups))
   end function sweep_runs_suite

   subroutine compare(wanted, found, message)
      type(text_type), intent(in) :: wanted(:), found(:)
      character(*), intent(in) :: message
      integer :: i
      call assertEqual(size(wanted), size(found), message=message)
      do i = 1, min(size(wanted), size(found))
         if (wanted(i)%text /= found(i)%text) call assertEqual(wanted(i)%text, found(i)%text, message=message)
      end do
   end subroutine compare

   !> Joints one by one find no equilibrium, smeared ones find one that leaves out most of the friction. The point locks up as its
   !> load case does. It had -29 kN, where 100 m higher the hook load is -552 kN.
   subroutine test_locked_up()
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      run = run_deck_text("&job plots = .false., hdf5 = .false., models = 'mcge' /"//newline// &
         '&trajectory md = 0, 1200, 1980, 5300, inc = 0, 0, 91, 91, azi = 4*220 /'//newline// &
         '&hole md_bottom = 2100, diameter = 216.8, friction = 0.2, cased = .true. /'//newline// &
         '&hole diameter = 215.9, friction = 0.3 /'//newline//'&fluid density = 1320 /'//newline// &
         "&component kind = 'bit', length = 0.3, od = 171.4, id = 57, joint_od = 215.9 /"//newline// &
         "&component kind = 'mwd', length = 15, od = 171.4, id = 76 /"//newline// &
         "&component catalogue = 'HWDP 5 49.3', length = 56 /"//newline// &
         "&component catalogue = 'DP 5 19.50 NC50 6-5/8x2-3/4 S135' /"//newline// &
         "&sweep name = 'b', operations = 'sliding', wob = 60, bit_depth_from = 5200, bit_depth_to = 5200, "// &
         'frictions_cased = 0.18, frictions_open = 0.27 /'//newline)
      rows = lines_of(csv)
      call assertTrue(index(rows(2)%text, ',locked_up,') > 0, message=run%output)
   end subroutine test_locked_up

   !> A deck whose load cases are points of its sweep, with friction given, gives the same hook loads and torques: to the digit
   !> where gaps are not fitted to short elements, which sweeps leave out, else within 1e-4.
   subroutine test_points()
      call compare_points("fidelity = 'fast'", 1.0e-9_wp)
      call compare_points('element_length = 10.0', 1.0e-4_wp)
   end subroutine test_points

   !> Compares hook loads and torques of load cases and of the points of a sweep, with a setting of &solver.
   subroutine compare_points(solver, within)
      character(*), intent(in) :: solver
      real(wp), intent(in) :: within       !< [-]
      type(run_type) :: run
      type(text_type), allocatable :: sweep(:), summary(:)
      character(:), allocatable :: deck
      integer :: i, j, found
      deck = replaced(good_deck(), "models = 'soft'", "models = 'mcge'")
      deck = replaced(deck, 'element_length = 10.0', solver)
      deck = replaced(deck, "operation = 'sliding', bit_depth = 800.0", "operation = 'rotate_off_bottom', bit_depth = 700.0")
      deck = replaced(deck, '  wob = 20.0', '  friction = 0.2, wob = 20.0, tob = 1.0')
      deck = replaced(deck, '  bit_depth = 900.0', '  bit_depth = 900.0, friction = 0.2, wob = 20.0, tob = 1.0')
      run = run_deck_text(deck//"&sweep name = 'b', operations = 'up', 'rotate_off_bottom', frictions = 0.2, wob = 20, tob = 1"// &
                          ', bit_depth_from = 700, bit_depth_step = 100 /'//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(unwrapped(run%output), 'its wob and tob act in trip_out too') > 0, message=run%output)
      allocate (sweep(0), summary(0))
      sweep = lines_of(csv)
      if (anyExceptions()) return
      summary = lines_of(results_path//'/summary.csv')
      if (anyExceptions()) return
      call assertEqual(1 + 2*3, size(sweep))
      found = 0
      do i = 2, size(summary)
         do j = 2, size(sweep)
            ! summary: operation 4, bit depth 5, hook load 8, torque 14; sweep: 2, 4, 5, 6
            if (field(summary(i)%text, 4) /= field(sweep(j)%text, 2)) cycle
            if (field(summary(i)%text, 5) /= field(sweep(j)%text, 4)) cycle
            found = found + 1
            call assertRelativelyEqual(number(summary(i)%text, 8), number(sweep(j)%text, 5), within, message=solver//': hook load')
            call assertRelativelyEqual(number(summary(i)%text, 14), number(sweep(j)%text, 6), within, message=solver//': torque')
            call assertEqual('converged', field(sweep(j)%text, 7))
         end do
      end do
      call assertEqual(2, found, message='points that are load cases')
   end subroutine compare_points

   !> Measured values of load cases join the depths of the sweep, and stand beside the calculated ones. The factor that fits has a
   !> column where one factor can, not with pairs.
   subroutine test_measured()
      type(run_type) :: run
      character(:), allocatable :: deck
      type(text_type), allocatable :: sweep(:)
      integer :: i, found
      deck = replaced(good_deck(), '  bit_depth = 900.0', '  bit_depth = 850.0, measured_hookload = 230')
      run = run_deck_text(deck// &
                          "&sweep name = 'b', frictions = 0.1, 0.5, bit_depth_step = 100,"//newline// &
                          "  measured_depths = 300, 700, 700, measured_operations = 'up', 'up', 'rotate_off_bottom',"//newline// &
                          '  measured_hookloads = 0, 210, 0, measured_torques = 1.5, 0, 2 /'//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (sweep(0))
      sweep = lines_of(csv)
      if (anyExceptions()) return
      call assertEqual(1 + 3*2*10, size(sweep))
      found = 0
      do i = 2, size(sweep)
         if (field(sweep(i)%text, 4) == '700.0000000' .and. field(sweep(i)%text, 2) == 'rotate_off_bottom') &
            call assertEqual('2.000000000', field(sweep(i)%text, 9))
         if (field(sweep(i)%text, 8) == '') cycle
         found = found + 1
         if (field(sweep(i)%text, 4) == '700.0000000') call assertEqual('210.0000000', field(sweep(i)%text, 8))
         if (field(sweep(i)%text, 4) == '700.0000000') cycle
         call assertEqual('trip_out', field(sweep(i)%text, 2))
         call assertEqual('850.0000000', field(sweep(i)%text, 4))
         call assertEqual('230.0000000', field(sweep(i)%text, 8))
      end do
      call assertEqual(2*2, found)
      call assertTrue(index(run%output, 'Measured, and calculated by soft at friction factors') > 0, message=run%output)
      call assertTrue(index(run%output, ' Fits'//newline) > 0, message=run%output)
      call assertTrue(index(run%output, newline//'Fits: friction factor that gives the measured value') > 0, message=run%output)
      deck = replaced(deck, '&hole md_top = 0.0,', '&hole cased = .true., md_top = 0.0,')
      run = run_deck_text(deck//"&sweep name = 'b', frictions_cased = 0.1, 0.2, frictions_open = 0.2, 0.5, bit_depth_step = 100 /")
      call assertTrue(index(run%output, 'Measured, and calculated by soft at friction factors') > 0, message=run%diagnostics)
      call assertEqual(0, index(run%output, 'Fits'), message=run%output)
   end subroutine test_measured

   !> Every model; without load cases; field units in the header; status and one row a point.
   subroutine test_models()
      type(run_type) :: run
      type(text_type), allocatable :: sweep(:)
      character(:), allocatable :: deck
      integer :: from
      deck = good_deck()
      from = index(deck, '&load_case')
      deck = deck(:from - 1)//"&solver /"//newline// &
             "&sweep model = 'mcge', 'soft', 'rigid', 'mixed', bit_depth_step = 300, operations = 'down' /"//newline
      run = run_deck_text(deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (sweep(0))
      sweep = lines_of(results_path//'/sweep_1.csv')
      if (anyExceptions()) return
      call assertEqual(1 + 4*3, size(sweep))
      call assertEqual('model,operation,friction,bit_depth_m,hookload_kN,torque_kNm,status', sweep(1)%text(:66))
      call assertEqual('mixed', field(sweep(13)%text, 1))
      call assertEqual('', field(sweep(13)%text, 3), message='friction of the hole')
      run = run_program(again//'--check')
      call assertTrue(index(run%output, 'sweep       1: mcge, soft, rigid, mixed; trip_in; friction of the hole; string main; '// &
                            '3 depths, 300 to 900 m; 12 points, 0 measured') > 0, message=run%output)
      run = run_deck_text(replaced(replaced(replaced(deck, "title = 'a deck'", "units = 'field'"), 'diameter = 220.0', &
                                            'diameter = 9.0'), 'diameter = 215.9', 'diameter = 8.5'), '--check')
      call assertEqual(2, run%status, message='diameters of components are metric still')
   end subroutine test_models

   subroutine test_threads()
      type(run_type) :: run
      type(text_type), allocatable :: one(:)
      character(:), allocatable :: deck
      deck = replaced(good_deck(), "models = 'soft'", "models = 'mcge', 'soft'")//group
      run = run_deck_text(deck, '--threads 1')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (one(0))
      one = lines_of(csv)
      if (anyExceptions()) return
      call assertEqual(1 + 2*points, size(one))
      run = run_deck_text(deck, '--threads 4')
      call compare(one, lines_of(csv), 'threads do not matter')
      call assertEqual('', run%diagnostics, message='no progress where nobody watches')
   end subroutine test_threads

   !> A record of an interrupted run: what is in it is taken, not solved again (one value is altered to show it); a line cut
   !> short does not count; the rest is solved; nothing is left.
   subroutine test_resumed()
      type(run_type) :: run
      type(text_type), allocatable :: whole(:), record(:)
      type(error_type), allocatable :: error
      integer :: first, at
      logical :: there
      run = run_deck_text(good_deck()//group)
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (whole(0), record(0))
      whole = lines_of(csv)
      if (anyExceptions()) return
      call make_partial(record)
      call append_text(record, '30 converged  1.00000')
      call write_text_file(partial, record, error)
      call delete_file(csv)
      run = run_program(again)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual("drillgap: sweep 'b': 27 points were solved before, in "//partial//newline, run%diagnostics)
      call assertTrue(index(run%output, '27 points solved in') > 0, message=run%output)
      call compare(whole, lines_of(csv), 'as without interruption')
      inquire (file=partial, exist=there)
      call assertFalse(there, message='the record has served')
      ! point 3 is altered: its hook load in the record is 1 kN
      call make_partial(record)
      first = size(record) - 27
      at = index(record(first + 2)%text, 'converged') + len('converged')
      call assertEqual('3 ', record(first + 2)%text(:2))
      record(first + 2)%text(at:at + 24) = '  1.0000000000000000E+003'
      call write_text_file(partial, record, error)
      run = run_program(again)
      record = lines_of(csv)
      if (anyExceptions()) return
      call assertEqual('1.000000000', field(record(4)%text, 5), message='taken from the record')
   end subroutine test_resumed

   !> A record as an interrupted run leaves it: that of one of two parts, as one of a whole.
   subroutine make_partial(record)
      type(text_type), allocatable, intent(out) :: record(:)
      type(run_type) :: run
      type(error_type), allocatable :: error
      run = run_program(again//'--part 1/2')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (record(0))
      record = lines_of(results_path//'/sweep_b.part_1_of_2')
      if (anyExceptions()) return
      record(2)%text = 'part 1 of 1'
      call delete_file(results_path//'/sweep_b.part_1_of_2')
      call write_text_file(partial, record, error)
   end subroutine make_partial

   !> Killed without warning, then asked to end, then left alone: nothing is lost, and all is as if nothing had happened.
   subroutine test_signals()
      type(run_type) :: run
      type(text_type), allocatable :: whole(:)
      character(:), allocatable :: deck
      logical :: there
      deck = replaced(good_deck(), "models = 'soft'", "models = 'mcge'")
      deck = replaced(deck(:index(deck, '&load_case') - 1), 'density = 1200.0 /', 'density = 1200.0 / &solver element_length = 3 /')
      deck = deck//"&sweep name = 'b', frictions = 0.2, 0.3, bit_depth_step = 10 /"//newline
      run = run_deck_text(deck, '--threads 1')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (whole(0))
      whole = lines_of(csv)
      if (anyExceptions()) return
      ! each run must itself remove the file that the one before has left
      call resume('KILL')
      call resume('TERM')
   contains
      subroutine resume(signal)
         character(*), intent(in) :: signal
         run = run_interrupted('--threads 1', is_result('sweep_b.partial'), signal)
         if (signal == 'TERM') then
            call assertEqual(1, run%status, message=run%diagnostics)
            call assertTrue(index(run%diagnostics, 'ended by SIGTERM with') > 0 .and. &
                            index(run%diagnostics, 'the same command goes on from there') > 0, message=run%diagnostics)
         else
            call assertFalse(run%status == 0, message='killed')
         end if
         inquire (file=csv, exist=there)
         call assertFalse(there, message='no file of a sweep that is not finished')
         call assertGreaterThan(size(lines_of(partial)), 50, message='what was solved is on disk')
         run = run_program(again)
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertTrue(index(run%diagnostics, 'points were solved before') > 0, message=run%diagnostics)
         call compare(whole, lines_of(csv), 'as without '//signal)
      end subroutine resume
   end subroutine test_signals

   !> A record of a deck that has changed since is refused by name of what has changed, before anything is solved, and stays.
   subroutine test_changed_deck()
      type(run_type) :: run
      type(text_type), allocatable :: record(:), deck(:)
      type(error_type), allocatable :: error
      integer :: i
      logical :: there
      run = run_deck_text(good_deck()//group)
      call make_partial(record)
      call delete_file(results_path//'/summary.csv')
      allocate (deck(0))
      deck = lines_of(deck_path)
      if (anyExceptions()) return
      do i = 1, size(deck)
         if (index(deck(i)%text, 'diameter = 215.9') > 0) deck(i)%text = replaced(deck(i)%text, '215.9', '216.0')
      end do
      call write_text_file(deck_path, deck, error)
      run = run_program(again)
      call assertEqual(2, run%status)
      call assertEqual('drillgap: sweep b: cannot go on with '//partial//': it is of another deck: hole 2, diameter was '// &
                       '215.9 mm and is 216 mm; restore the deck, or remove that file to begin anew'//newline, run%diagnostics)
      inquire (file=partial, exist=there)
      call assertTrue(there, message='the record stays')
      inquire (file=results_path//'/summary.csv', exist=there)
      call assertFalse(there, message='nothing was solved')
      call delete_file(partial)
      run = run_program(again)
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_changed_deck

   !> Four processes, one part each, joined: the same file as by one process.
   subroutine test_parts()
      type(run_type) :: run
      type(text_type), allocatable :: whole(:)
      integer :: part
      run = run_deck_text(good_deck()//group)
      allocate (whole(0))
      whole = lines_of(csv)
      if (anyExceptions()) return
      call delete_file(csv)
      do part = 1, 4
         run = run_program(again//'--part '//to_text(part)//'/4')
         call assertEqual(0, run%status, message=run%diagnostics)
         ! 54 points: 14, 14, 13, 13
         call assertEqual('Sweep b, part '//to_text(part)//' of 4: '//to_text(merge(14, 13, part <= 2))//' of 54 points, in '// &
                          results_path//'/sweep_b.part_'//to_text(part)//'_of_4'//newline, run%output)
      end do
      run = run_program(again//'--merge 4')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '54 points, joined from 4 parts') > 0, message=run%output)
      call compare(whole, lines_of(csv), 'as by one process')
   end subroutine test_parts

   subroutine test_refused_parts()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      integer :: part
      logical :: there
      run = run_deck_text(good_deck()//group)
      call delete_file(csv)
      allocate (lines(0))
      do part = 1, 3
         run = run_program(again//'--part '//to_text(part)//'/4')
      end do
      call refuse('sweep_b.part_4_of_4: it is missing; run --part 4/4')
      lines = lines_of(results_path//'/sweep_b.part_2_of_4')
      if (anyExceptions()) return
      call write_text_file(results_path//'/sweep_b.part_4_of_4', lines, error)
      call refuse('sweep_b.part_4_of_4: it holds part 2 of 4 instead of part 4 of 4; remove it and run --part 4/4')
      call write_text_file(results_path//'/sweep_b.part_2_of_4', lines(:size(lines) - 3), error)
      call refuse('sweep_b.part_2_of_4: it lacks 3 of its points; go on with --part 2/4')
      call delete_file(results_path//'/sweep_b.part_4_of_4')
      run = run_program(again//'--part 2/4')
      call assertEqual("drillgap: sweep 'b': 11 points were solved before, in "//results_path//'/sweep_b.part_2_of_4'//newline, &
                       run%diagnostics)
      run = run_program(again//'--part 4/4')
      ! a part of another deck
      lines = lines_of(results_path//'/sweep_b.part_3_of_4')
      if (anyExceptions()) return
      do part = 1, size(lines)
         if (index(lines(part)%text, 'hole 1, friction_axial = ') == 1) lines(part)%text = 'hole 1, friction_axial = 0.24'
      end do
      call write_text_file(results_path//'/sweep_b.part_3_of_4', lines, error)
      call refuse('sweep_b.part_3_of_4: it is of another deck: hole 1, friction_axial was 0.24 and is 0.25; remove it and run')
      run = run_program(again//'--merge 3')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'sweep_b.part_1_of_3: it is missing') > 0, message=run%diagnostics)
      run = run_program(again//'--part 5/4')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, '--part 5/4 is not a part') > 0, message=run%diagnostics)
      run = run_program(again//'--part 1/4 --merge 4')
      call assertEqual(2, run%status)
      run = run_deck_text(good_deck(), '--part 1/4')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'has no &sweep') > 0, message=run%diagnostics)
   contains
      subroutine refuse(wanted)
         character(*), intent(in) :: wanted
         run = run_program(again//'--merge 4')
         call assertEqual(2, run%status, message=wanted)
         call assertTrue(index(run%diagnostics, wanted) > 0, message='wanted '//wanted//'; got '//run%diagnostics)
         inquire (file=csv, exist=there)
         call assertFalse(there, message='no joined file: '//wanted)
      end subroutine refuse
   end subroutine test_refused_parts

   !> Points without solution are marked, counted, told once and listed up to ten, with exit status 3; the page says the
   !> same.
   subroutine test_no_solution()
      type(run_type) :: run
      type(text_type), allocatable :: sweep(:)
      character(:), allocatable :: deck, page, row
      integer :: i, lost
      deck = good_deck()
      deck = replaced(deck(:index(deck, '&load_case') - 1), ', plots = .false.', '')//"&solver max_iterations = 1 /"//newline// &
             "&sweep name = 'b', model = 'mcge', operations = 'up', bit_depth_step = 300, frictions = 0.3 /"//newline
      run = run_deck_text(deck)
      call assertEqual(3, run%status)
      allocate (sweep(0))
      sweep = lines_of(csv)
      if (anyExceptions()) return
      lost = 0
      do i = 2, size(sweep)
         if (field(sweep(i)%text, 7) /= 'not_converged') cycle
         lost = lost + 1
         call assertTrue(len(field(sweep(i)%text, 11)) > 0, message='reason')
      end do
      call assertGreaterThan(lost, 0, message='points lost')
      call assertTrue(index(run%diagnostics, 'sweep ''b'': '//to_text(lost)//' of 3 points did not converge; the first: mcge, '// &
                            'up, friction 0.3, bit at') > 0, message=run%diagnostics)
      call assertTrue(index(run%output, '! cannot be done, or no solution') > 0, message=run%output)
      page = content(results_path//'/report.html')
      call assertTrue(index(page, to_text(lost)//' of 3 solutions did not converge (exit status 3)') > 0)
      call assertEqual(lost, rows_of(page, &
                                     '<tr><td class="text">sweep b</td><td class="text">mcge</td><td class="text word">up</td>'))
      call assertTrue(index(run%output, to_text(lost)//' of 3 points did not converge; the file says why'//newline) > 0, &
                      message=run%output)
      call assertFalse(index(run%output, ' of '//to_text(lost)//'; the CSV file has all') > 0, message=run%output)
      deck = replaced(deck, 'bit_depth_step = 300, frictions = 0.3', 'bit_depth_step = 20, frictions = 0.2, 0.3')
      run = run_deck_text(deck)
      sweep = lines_of(csv)
      if (anyExceptions()) return
      lost = 0
      do i = 2, size(sweep)
         if (field(sweep(i)%text, 7) /= 'not_converged') cycle
         lost = lost + 1
         row = repeat(' ', 9 - len(to_text(i - 1)))//to_text(i - 1)//'  mcge   up'
         call assertEqual(lost <= 10, index(run%output, newline//row) > 0, message=row)
      end do
      call assertGreaterThan(lost, 10, message='points lost')
      call assertTrue(index(run%output, '10 of '//to_text(lost)//'; the CSV file has all') > 0, message=run%output)
   contains
      !> Rows of the page that begin with these cells.
      function rows_of(text, cells) result(number)
         character(*), intent(in) :: text, cells
         integer :: number, at, next
         number = 0
         at = 1
         do
            next = index(text(at:), cells)
            if (next == 0) exit
            number = number + 1
            at = at + next
         end do
      end function rows_of
   end subroutine test_no_solution

   subroutine test_bad_groups()
      call refuse("name = 'a/b'", "name = 'a/b' cannot be part of a file name")
      call refuse("operations = 'up', 'sideways'", "operations = 'sideways' is unknown; legal: trip_out")
      call refuse("operations = 'ream', rpm = 60", 'reaming needs trip_speed > 0')
      call refuse('bit_depth_to = 1000', 'bit_depth_to = 1000 m lies below the survey, which ends at 900 m')
      call refuse('bit_depth_from = 800, bit_depth_to = 700', 'bit_depth_from = 800 m lies below bit_depth_to = 700 m')
      call refuse('bit_depth_step = 0', 'bit_depth_step = 0 is out of range; needs a number, > 0')
      call refuse('bit_depth_step = 1e-4', 'bit_depth_step = 0.0001 m makes 2.7e7 points; at most 1000000')
      call refuse('frictions = 0.2, 30', 'frictions(2) = 30 is out of range; needs a number, 0 to 2')
      call refuse('frictions = 0.2, 0.3, 0.2', 'frictions holds 0.2 twice; keep one')
      call refuse("string = 'mian'", "no component belongs to string 'mian'; did you mean 'main'?")
      call refuse("model = 'sofd'", "model = 'sofd' is unknown; did you mean 'soft'?")
      call refuse("measured_depths = 300, 400, measured_hookloads = 5", 'measured_hookloads has 1 values, measured_depths has 2')
      call refuse("measured_depths = 300, measured_hookloads = 5", 'measured_depths needs measured_operations')
      call refuse("measured_depths = 300, measured_operations = 'up'", 'measured_depths needs measured_hookloads or')
      call refuse("measured_depths = 950, measured_operations = 'up', measured_hookloads = 5", &
                  'measured_depths(1) = 950 lies outside the depths of the sweep, 30 to 900 m')
      call refuse("measured_depths = 300, measured_operations = 'ream', measured_hookloads = 5", &
                  'measured_operations holds ream, which is not an operation of this sweep')
      call refuse("name = 'x' / &sweep name = 'X'", "name 'X' is taken; names must be unique, letter case aside")
   contains
      subroutine refuse(keys, wanted)
         character(*), intent(in) :: keys, wanted
         type(run_type) :: run
         run = run_deck_text(good_deck()//'&sweep '//keys//' /'//newline)
         call assertEqual(2, run%status, message='status of: '//wanted)
         call assertTrue(index(run%diagnostics, deck_path//':21: group &sweep: '//wanted) > 0, &
                         message='wanted '//wanted//'; got '//run%diagnostics)
         call assertFalse(run%has_results, message='no folder of results: '//wanted)
      end subroutine refuse
   end subroutine test_bad_groups
end module dg_test_sweep_runs
