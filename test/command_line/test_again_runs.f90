!> Points that did not converge, solved once more with other settings of the solver: what is solved again, what is taken over,
!> what is told of it, and what does not fit.
module dg_test_again_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_program_run, only: content, deck_path, good_deck, is_result, replaced, results_path, run_deck_text, run_interrupted, &
                             run_program, run_type
   use dg_result_rows, only: field, lines_of
   use dg_text, only: text_list, text_type
   implicit none
   private
   public :: again_runs_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: csv = results_path//'/sweep_b.csv', failed = results_path//'/sweep_b.failed'
   character(*), parameter :: group = "&sweep name = 'b', frictions = 0.2, 0.3, bit_depth_step = 100 /"//newline
   character(*), parameter :: command = deck_path//' --output '//results_path//' '
   !> Settings that leave some points without equilibrium, and settings that find all.
   character(*), parameter :: poor = 'element_length = 20.0, max_iterations = 3', good = 'element_length = 10.0'
   !> Columns.
   integer, parameter :: status_column = 7, settings_column = 17

contains

   function again_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('again_runs')
      call suite%addTest(TestMethod('failed_points', test_failed))
      call suite%addTest(TestMethod('same_settings', test_same))
      call suite%addTest(TestMethod('parts', test_parts))
      call suite%addTest(TestMethod('two_sweeps', test_two))
      call suite%addTest(TestMethod('ended_by_signal', test_signal))
      call suite%addTest(TestMethod('other_model', test_other_model))
      call suite%addTest(TestMethod('samples', test_samples))
      call suite%addTest(TestMethod('nothing_to_solve_again', test_nothing))
   end function again_runs_suite

   !> A deck of beams with a sweep, and these settings of the solver.
   function deck_of(solver, groups) result(deck)
      character(*), intent(in) :: solver
      character(*), intent(in), optional :: groups   !< instead of the one sweep
      character(:), allocatable :: deck
      deck = replaced(good_deck(), "models = 'soft'", "models = 'mcge'")
      deck = replaced(deck(:index(deck, '&load_case') - 1), 'density = 1200.0 /', 'density = 1200.0 / &solver '//solver//' /')
      if (present(groups)) then
         deck = deck//groups
      else
         deck = deck//group
      end if
   end function deck_of

   !> Changes the deck; results and records stay.
   subroutine change_deck(text)
      character(*), intent(in) :: text
      type(error_type), allocatable :: error
      call write_text_file(deck_path, text_list(text), error)
      call assertFalse(allocated(error))
   end subroutine change_deck

   !> One point of 54 fails. Solved again it is that of a run with the good settings to the byte, the others stay those of the
   !> first run, and every row says which it is.
   subroutine test_failed()
      type(run_type) :: run
      type(text_type), allocatable :: first(:), better(:), joined(:)
      integer :: i, lost
      logical :: there
      allocate (first(0), better(0), joined(0))
      run = run_deck_text(deck_of(good))
      call assertEqual(0, run%status, message=run%diagnostics)
      inquire (file=failed, exist=there)
      call assertFalse(there, message='no record where all points converged')
      better = lines_of(csv)
      run = run_deck_text(deck_of(poor))
      call assertEqual(3, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'change settings of the solver and give --again to solve 1 points once more') > 0, &
                      message=run%diagnostics)
      first = lines_of(csv)
      call change_deck(deck_of(good))
      run = run_program(command//'--again')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual("drillgap: sweep 'b': 53 points were solved before, in "//failed//'; 1 that did not converge are '// &
                       'solved again'//newline, run%diagnostics)
      call assertTrue(index(run%output, '53 of 54 points were found with other settings of the solver') > 0, message=run%output)
      call assertTrue(index(run%output, '1 points solved in') > 0, message=run%output)
      joined = lines_of(csv)
      if (anyExceptions()) return
      call assertEqual(size(first), size(joined))
      if (anyExceptions()) return
      lost = 0
      do i = 2, size(joined)
         if (field(first(i)%text, status_column) == 'converged') then
            call assertEqual(replaced(first(i)%text, ',,yes,', ',earlier,yes,'), joined(i)%text)
         else
            lost = lost + 1
            call assertEqual(better(i)%text, joined(i)%text)
         end if
      end do
      call assertEqual(1, lost)
      inquire (file=failed, exist=there)
      call assertFalse(there, message='the record has served')
   end subroutine test_failed

   !> With the settings with which they failed points fail again: nothing is solved, and the run says so.
   subroutine test_same()
      type(run_type) :: run
      character(:), allocatable :: whole
      run = run_deck_text(deck_of(poor))
      whole = content(csv)
      run = run_program(command//'--again')
      call assertEqual(3, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, '54 points were solved before, in '//failed//'; 1 of them did not converge with '// &
                            'the same settings of the solver: change these') > 0, message=run%diagnostics)
      call assertTrue(whole == content(csv), message='the same bytes')
      ! a run without --again begins anew
      call change_deck(deck_of(good))
      run = run_program(command)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('', run%diagnostics)
   end subroutine test_same

   !> Of three parts those that hold failed points are solved again; joined they are what one run makes of it. Parts of two settings
   !> are joined with --again alone.
   subroutine test_parts()
      type(run_type) :: run
      character(:), allocatable :: whole, list
      integer :: at
      run = run_deck_text(deck_of(poor))
      call change_deck(deck_of(good))
      run = run_program(command//'--again')
      whole = content(csv)
      run = run_deck_text(deck_of(poor), '--part 1-3/3')
      call assertEqual(3, run%status, message=run%diagnostics)
      run = run_program(command//'--merge 3')
      call assertEqual(3, run%status, message=run%diagnostics)
      at = index(run%diagnostics, 'they are in ')
      call assertTrue(at > 0, message=run%diagnostics)
      if (anyExceptions()) return
      list = run%diagnostics(at + len('they are in '):)
      list = list(:index(list, newline) - 1)
      call assertEqual('--part 1/3', list)
      call change_deck(deck_of(good))
      run = run_program(command//list//' --again')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program(command//'--merge 3')
      call assertEqual(2, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'broken: 2-3') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, '(--again takes its points over)') > 0, message=run%diagnostics)
      run = run_program(command//'--merge 3 --again')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(whole == content(csv), message='the same bytes as by one run')
   end subroutine test_parts

   !> Where one of two sweeps has failed points, those of the other are taken over, too.
   subroutine test_two()
      character(*), parameter :: deep = "&sweep name = 'a', operations = 'down', frictions = 0.2, bit_depth_step = 300 /"//newline
      type(run_type) :: run
      run = run_deck_text(deck_of(poor, deep//group))
      call assertEqual(3, run%status, message=run%diagnostics)
      call change_deck(deck_of(good, deep//group))
      run = run_program(command//'--again')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, "sweep 'a': 3 points were solved before, in "//results_path//'/sweep_a.failed; '// &
                            'all of them converged or locked up, so none is solved again') > 0, message=run%diagnostics)
   end subroutine test_two

   !> Ended while points are solved again, and started once more.
   subroutine test_signal()
      character(*), parameter :: many = "&sweep name = 'b', frictions = 0.2, 0.3, bit_depth_step = 5 /"//newline
      type(run_type) :: run
      character(:), allocatable :: whole
      run = run_deck_text(deck_of(poor, many), '--threads 1')
      call assertEqual(3, run%status, message=run%diagnostics)
      call change_deck(deck_of('element_length = 2.0', many))
      run = run_interrupted('--threads 1 --again', is_result('sweep_b.partial'), 'TERM')
      call assertEqual(1, run%status, message=run%diagnostics)
      run = run_program(command//'--again')
      call assertEqual(0, run%status, message=run%diagnostics)
      whole = content(csv)
      run = run_deck_text(deck_of(poor, many))
      call change_deck(deck_of('element_length = 2.0', many))
      run = run_program(command//'--again')
      call assertTrue(whole == content(csv), message='the same bytes as without the signal')
   end subroutine test_signal

   !> Points of another model are refused, and stay.
   subroutine test_other_model()
      type(run_type) :: run
      logical :: there
      run = run_deck_text(deck_of(poor))
      call change_deck(replaced(deck_of(good), 'friction = 0.3 /', 'friction = 0.31 /'))
      run = run_program(command//'--again')
      call assertEqual(2, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'hole 2, friction_axial was 0.3 and is 0.31') > 0, message=run%diagnostics)
      inquire (file=failed, exist=there)
      call assertTrue(there, message='the record stays')
   end subroutine test_other_model

   !> The same of a Monte Carlo.
   subroutine test_samples()
      character(*), parameter :: monte_carlo = "&uncertainty name = 'u', samples = 20, friction_deviation = 0.05, "// &
                                               "operations = 'up', bit_depth_from = 700, seed = 3 /"//newline
      type(run_type) :: run
      run = run_deck_text(deck_of(poor, monte_carlo))
      call assertEqual(3, run%status, message=run%diagnostics)
      call change_deck(deck_of(good, monte_carlo))
      run = run_program(command//'--again')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'that did not converge are solved again') > 0, message=run%diagnostics)
      call assertTrue(index(run%output, ' of 160 solutions were found with other settings of the solver') > 0, message=run%output)
   end subroutine test_samples

   !> Without earlier results all is solved; without sweeps there is nothing that could be.
   subroutine test_nothing()
      type(run_type) :: run
      run = run_deck_text(deck_of(good), '--again')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual("drillgap: sweep 'b': there are no earlier results; all points are solved"//newline, run%diagnostics)
      run = run_deck_text(good_deck(), '--again')
      call assertEqual(2, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, '--again is for their points') > 0, message=run%diagnostics)
   end subroutine test_nothing
end module dg_test_again_runs
