!> Divided runs by lists of parts, and what is told of parts that are not complete.
module dg_test_part_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_program_run, only: content, deck_path, good_deck, is_result, replaced, results_path, run_deck_text, run_interrupted, &
                             run_program, run_type
   use dg_result_rows, only: lines_of
   use dg_text, only: text_type
   implicit none
   private
   public :: part_runs_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: csv = results_path//'/sweep_b.csv', record = results_path//'/sweep_b.part_'
   character(*), parameter :: group = "&sweep name = 'b', frictions = 0.2, 0.3, bit_depth_step = 100 /"//newline
   character(*), parameter :: again = deck_path//' --output '//results_path//' '

contains

   function part_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('part_runs')
      call suite%addTest(TestMethod('list_of_parts', test_list))
      call suite%addTest(TestMethod('faults_in_one_message', test_faults))
      call suite%addTest(TestMethod('two_sweeps_in_one_message', test_two_sweeps))
      call suite%addTest(TestMethod('one_part_fails', test_one_fails))
      call suite%addTest(TestMethod('ended_by_signal', test_signal))
      call suite%addTest(TestMethod('refused_lists', test_refused))
   end function part_runs_suite

   !> Three parts by one command and the fourth by another, joined: the same bytes as by one run.
   subroutine test_list()
      type(run_type) :: run
      character(:), allocatable :: whole
      run = run_deck_text(good_deck()//group)
      call assertEqual(0, run%status, message=run%diagnostics)
      whole = content(csv)
      call delete_file(csv)
      run = run_program(again//'--part 1,3-4/4')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('', run%diagnostics)
      call assertEqual('Sweep b, part 1 of 4: 14 of 54 points, in '//record//'1_of_4'//newline// &
                       'Sweep b, part 3 of 4: 13 of 54 points, in '//record//'3_of_4'//newline// &
                       'Sweep b, part 4 of 4: 13 of 54 points, in '//record//'4_of_4'//newline, run%output)
      run = run_program(again//'--part=2/4')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program(again//'--merge 4')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(content(csv) == whole, message='the same bytes as by one run')
   end subroutine test_list

   !> One part lacks, one is damaged, one cut short: all are told at once, and the list that the message gives makes the whole.
   subroutine test_faults()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      character(:), allocatable :: whole
      integer :: damaged
      logical :: there
      run = run_deck_text(good_deck()//group)
      whole = content(csv)
      call delete_file(csv)
      run = run_program(again//'--part 1-2,4/4')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (lines(0))
      lines = lines_of(record//'4_of_4')
      if (anyExceptions()) return
      call write_text_file(record//'4_of_4', lines(:size(lines) - 3), error)
      lines = lines_of(record//'2_of_4')
      if (anyExceptions()) return
      damaged = size(lines) - 5
      lines(damaged)%text = 'x'//lines(damaged)%text
      call write_text_file(record//'2_of_4', lines, error)
      run = run_program(again//'--merge 4')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'drillgap: the 4 parts are not complete; missing: 3; broken: 2; not finished: 4'// &
                            newline//'  '//record//'2_of_4: line ') == 1, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, ' is damaged; remove it and run --part 2/4'//newline// &
                            '  '//record//'3_of_4: it is missing; run --part 3/4'//newline// &
                            '  '//record//'4_of_4: it lacks 3 of its points; go on with --part 4/4'//newline// &
                            '  --part 2-4/4 runs them again once the broken files are removed'//newline) > 0, &
                      message=run%diagnostics)
      inquire (file=csv, exist=there)
      call assertFalse(there, message='nothing is joined')
      call delete_file(record//'2_of_4')
      run = run_program(again//'--part 2-4/4')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program(again//'--merge 4')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(content(csv) == whole, message='the same bytes as by one run')
   end subroutine test_faults

   subroutine test_two_sweeps()
      type(run_type) :: run
      character(*), parameter :: other = "&sweep name = 'c', operations = 'up', bit_depth_step = 300 /"//newline
      run = run_deck_text(good_deck()//group//other, '--part 1,3/3')
      call assertEqual(0, run%status, message=run%diagnostics)
      call delete_file(results_path//'/sweep_c.part_3_of_3')
      run = run_program(again//'--merge 3')
      call assertEqual(2, run%status)
      call assertEqual('drillgap: the 3 parts are not complete; missing: 2; not finished: 3'//newline// &
                       '  '//results_path//'/sweep_b.part_2_of_3: it is missing; run --part 2/3'//newline// &
                       '  '//results_path//'/sweep_c.part_2_of_3: it is missing; run --part 2/3'//newline// &
                       '  '//results_path//'/sweep_c.part_3_of_3: it is missing; run --part 3/3'//newline// &
                       '  --part 2-3/3 runs them'//newline, run%diagnostics)
   end subroutine test_two_sweeps

   !> A part that fails keeps no other from being run, and is named at the end.
   subroutine test_one_fails()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      logical :: there
      run = run_deck_text(good_deck()//group, '--part 2/4')
      allocate (lines(0))
      lines = lines_of(record//'2_of_4')
      if (anyExceptions()) return
      call write_text_file(record//'2_of_4', lines(2:), error)
      run = run_program(again//'--part 1-3/4')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'cannot go on with '//record//'2_of_4: it is not a record') > 0, &
                      message=run%diagnostics)
      call assertTrue(index(run%diagnostics, newline//'drillgap: not finished: --part 2/4'//newline) > 0, message=run%diagnostics)
      inquire (file=record//'3_of_4', exist=there)
      call assertTrue(there, message='the part after the one that failed')
      inquire (file=results_path//'/drillgap.lock', exist=there)
      call assertFalse(there, message='the folder is free')
   end subroutine test_one_fails

   !> A signal ends the part under way and leaves the next; the same command goes on, and all is as by one run.
   subroutine test_signal()
      type(run_type) :: run
      character(:), allocatable :: deck, whole
      logical :: there
      deck = replaced(good_deck(), "models = 'soft'", "models = 'mcge'")
      deck = replaced(deck(:index(deck, '&load_case') - 1), 'density = 1200.0 /', 'density = 1200.0 / &solver element_length = 3 /')
      run = run_deck_text(deck//"&sweep name = 'b', operations = 'up', frictions = 0.2, 0.3, bit_depth_step = 8 /"//newline)
      whole = content(csv)
      call delete_file(csv)
      run = run_interrupted('--threads 1 --part 1-2/2', is_result('sweep_b.part_1_of_2'), 'TERM')
      call assertEqual(1, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'ended by SIGTERM with') > 0 .and. &
                      index(run%diagnostics, newline//'drillgap: not finished: --part 1-2/2'//newline) > 0, message=run%diagnostics)
      inquire (file=record//'2_of_2', exist=there)
      call assertFalse(there, message='the part after the signal')
      run = run_program(again//'--part 1-2/2')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program(again//'--merge 2')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(content(csv) == whole, message='the same bytes as by one run')
   end subroutine test_signal

   subroutine test_refused()
      call refuse('3,,7', 'it has no /')
      call refuse('3,,7/9', 'a number lacks')
      call refuse('9-7/40', '9-7 runs backwards')
      call refuse('41/40', 'there is no part 41 of 40')
      call refuse('0/40', "'0' is neither a number nor a range")
      call refuse('3/', "'' is not a number of parts, 1 to 9999")
      call refuse('1-2-3/4', "'1-2-3' is neither a number nor a range")
      call refuse('3,2-4/4', 'part 3 is there twice')
   contains
      subroutine refuse(list, wanted)
         character(*), intent(in) :: list, wanted
         type(run_type) :: run
         run = run_deck_text(good_deck()//group, '--part '//list)
         call assertEqual(2, run%status, message=list)
         call assertTrue(index(run%diagnostics, 'drillgap: --part '//list//' is not a part: '//wanted//'. Give i/n with i from '// &
                               '1 to n, as in --part 2/4, or several, each once, as in --part 3,7-9/40. See drillgap --help'// &
                               newline) == 1, &
                         message=list//'; got '//run%diagnostics)
         call assertFalse(run%has_results, message='no folder of results: '//list)
      end subroutine refuse
   end subroutine test_refused
end module dg_test_part_runs
