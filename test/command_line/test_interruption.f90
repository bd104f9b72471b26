!> A run that is ended by a signal: files of what was done are whole, and everything says that the rest is missing.
module dg_test_interruption
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_file_lines, only: read_lines
   use dg_program_run, only: good_deck, is_result, replaced, results_path, run_deck_text, run_interrupted, run_type
   use dg_text, only: text_type
   implicit none
   private
   public :: interruption_suite

   character(*), parameter :: newline = achar(10)

contains

   function interruption_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('interruption')
      call suite%addTest(TestMethod('terminated', test_terminated))
      call suite%addTest(TestMethod('interrupted', test_interrupted))
   end function interruption_suite

   subroutine test_terminated()
      call end_by('TERM')
   end subroutine test_terminated

   subroutine test_interrupted()
      call end_by('INT')
   end subroutine test_interrupted

   !> The signal comes as soon as the files of the first case, a short one, are there; the others would take some minutes.
   subroutine end_by(signal)
      character(*), intent(in) :: signal
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      logical :: is
      run = run_deck_text(long_deck(), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      ! as an earlier run could have left it
      call execute_command_line('mkdir '//results_path//' && echo old > '//results_path//'/profile_last_mcge.csv', &
                                exitstat=run%status)
      call assertEqual(0, run%status, message='an earlier result')
      run = run_interrupted('--quiet --threads 1', is_result('view_u_mcge.hdf'), signal)     ! a slow run would print its progress
      call assertEqual(1, run%status, message=run%diagnostics)
      call assertEqual('drillgap: ended by SIG'//signal//': 1 of 5 results are there, the others are marked not_converged'// &
                       newline, run%diagnostics)
      call read_lines(results_path//'/summary.csv', lines, failure)
      call assertEqual('', failure)
      if (failure /= '') return
      call assertEqual(6, size(lines))
      if (size(lines) /= 6) return
      call assertTrue(index(lines(2)%text, ',converged,') > 0, message=lines(2)%text)
      call assertTrue(index(lines(3)%text, ',not_converged,') > 0, message=lines(3)%text)
      call assertTrue(index(lines(3)%text, 's,,mcge,sliding_drilling,800.0000000,,20.00000000,,') == 1, &
                      message='numbers of half an iteration: '//lines(3)%text)
      call assertTrue(index(lines(6)%text, 'ended by SIG'//signal//' before it was solved') > 0, message=lines(6)%text)
      inquire (file=results_path//'/results.h5', exist=is)
      call assertTrue(is, message='results.h5')
      inquire (file=results_path//'/profile_last_mcge.csv', exist=is)
      call assertFalse(is, message='a profile of a case that was not begun, or of an earlier run')
      inquire (file=results_path//'/profile_s_mcge.csv', exist=is)
      call assertFalse(is, message='a profile of a case that was not finished')
      call execute_command_line('ls '//results_path//' | grep -q unfinished && exit 1 || exit 0', exitstat=run%status)
      call assertEqual(0, run%status, message='unfinished files')
   end subroutine end_by

   !> The good deck with one short case and four that have some ten thousand elements each.
   function long_deck() result(deck)
      character(:), allocatable :: deck
      deck = replaced(replaced(replaced(good_deck(), ', plots = .false.', ''), "'soft'", "'mcge'"), 'element_length = 10.0', &
                      'element_length = 0.1')
      deck = replaced(replaced(deck, "operation = 'up'", "operation = 'static'"), '  bit_depth = 900.0', '  bit_depth = 105.0')
      deck = deck//"&load_case name = 'b', operation = 'up', bit_depth = 900.0 /"//newline// &
             "&load_case name = 'c', operation = 'down', bit_depth = 900.0 /"//newline// &
             "&load_case name = 'last', operation = 'up', bit_depth = 890.0 /"//newline
   end function long_deck
end module dg_test_interruption
