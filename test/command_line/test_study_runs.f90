!> The group &study from deck to table and file; its faults.
module dg_test_study_runs
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_file_lines, only: read_lines
   use dg_kinds, only: wp
   use dg_program_run, only: deck_path, good_deck, results_path, run_deck_text, run_type
   use dg_result_rows, only: field, number
   use dg_text, only: text_type
   implicit none
   private
   public :: study_runs_suite

   character(*), parameter :: newline = achar(10)
   !> Both iterate to a residual of 1e-9 of the weight.
   real(wp), parameter :: tolerance = 1.0e-8_wp

contains

   function study_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('study_runs')
      call suite%addTest(TestMethod('table_and_file', test_study))
      call suite%addTest(TestMethod('bad_groups', test_bad))
   end function study_runs_suite

   !> Two cases by two models on three meshes, beams with all linear solvers: 2 (3 x 3 + 2) rows and the header; the
   !> linear solvers give the same hook load.
   subroutine test_study()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      run = run_deck_text(good_deck()//"&study models = 'mcge', 'soft', element_lengths = 20, 5, fidelities = 'standard',"// &
                          " linear_solvers = 'block', 'banded', 'sparse' /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Study of 2 cases') > 0, message=run%output)
      call assertTrue(index(run%output, 'Fidelity standard: hook load within ') > 0, message='fidelity in words')
      call read_lines(results_path//'/study.csv', lines, failure)
      call assertEqual('', failure)
      if (failure /= '') return
      call assertEqual(23, size(lines))
      call assertEqual(1, index(lines(1)%text, 'case,model,fidelity,element_length_m,tolerance,wall_stiffness_kN_m2,'))
      call assertEqual(1, index(lines(2)%text, 'u,mcge,,20.00000000,'), message=lines(2)%text)
      call assertEqual(number(lines(2)%text, 11), number(lines(3)%text, 11), tolerance*number(lines(2)%text, 11), &
                       message='hook load by block and by banded')
      call assertEqual(number(lines(2)%text, 11), number(lines(4)%text, 11), tolerance*number(lines(2)%text, 11), &
                       message='hook load by block and by sparse')
      call assertEqual('banded', field(lines(3)%text, 8))
      call assertEqual('yes', field(lines(7)%text, 10), message='5 m, sparse is the finest')
      call assertEqual('soft', field(lines(12)%text, 2))
   end subroutine test_study

   !> Nothing to compare; an unknown case, model, linear solver; lists whose combinations have no end.
   subroutine test_bad()
      call refuse("", 'nothing to compare; give two values or more of element_lengths')
      call refuse("element_lengths = 5, 5", 'nothing to compare')
      call refuse("element_lengths = 5, 10, cases = 'v'", "there is no load case 'v'; did you mean 'u'?")
      call refuse("models = 'mcge', 'sift'", "did you mean 'soft'?")
      call refuse("linear_solvers = 'bandet', 'block'", "did you mean 'banded'?")
      call refuse("element_lengths = 5, 0", 'element_lengths(2) = 0 is out of range; needs a number, 0.01 to 1000 m')
      call refuse("element_lengths = 1,2,3,4,5,6,7,8,9,10, tolerances = 1e-1,1e-2,1e-3,1e-4,1e-5,1e-6,1e-7,1e-8,1e-9,1e-10,"// &
                  newline//"wall_stiffnesses = 1,2,3,4,5,6,7,8,9,10, gap_locations = 'extremum', 'nodes', linear_solvers = "// &
                  "'block', 'banded', fidelities = 'auto', 'fast', 'standard'", '10400 solutions')
   end subroutine test_bad

   !> The good deck with this study, whose group begins in line 21.
   subroutine refuse(keys, expected)
      character(*), intent(in) :: keys, expected
      type(run_type) :: run
      run = run_deck_text(good_deck()//'&study '//keys//' /'//newline)
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, deck_path//':21: group &study: ') > 0 .and. index(run%diagnostics, expected) > 0, &
                      message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse
end module dg_test_study_runs
