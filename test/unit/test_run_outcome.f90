!> Page of a run with missing solutions: counts of all parts in its headline, a row for each case without a solution.
module dg_test_run_outcome
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged, result_locked_up, result_not_converged
   use dg_html_outcome, only: append_lost, append_outcome
   use dg_line_list, only: line_list_type
   use dg_job, only: model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_trip_in, operation_trip_out
   use dg_missing, only: given
   use dg_run_outcome, only: add_part, locked_count, lost_count, note_cases, note_lost, outcome_type, solution_count
   use dg_point_outcome, only: note_sweep
   use dg_uncertainty_study, only: note_uncertainty
   use dg_sweep, only: sweep_type
   use dg_sweep_result, only: sweep_result_type
   use dg_sweep_sentences, only: append_warned, sweep_sentences
   use dg_text, only: text_list, text_type
   use dg_uncertainty, only: uncertainty_type
   use dg_utilisation, only: limit_rig
   use dg_verdict, only: limit_string_weight
   use dg_units, only: si_units
   implicit none
   private
   public :: run_outcome_suite

contains

   function run_outcome_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('run_outcome')
      call suite%addTest(TestMethod('all_converged', test_all_converged))
      call suite%addTest(TestMethod('locked_up', test_locked_up))
      call suite%addTest(TestMethod('sweep', test_sweep))
      call suite%addTest(TestMethod('sweep_sentences', test_sentences))
      call suite%addTest(TestMethod('uncertainty', test_uncertainty))
      call suite%addTest(TestMethod('too_many_rows', test_too_many))
   end function run_outcome_suite

   !> Two operations at four depths.
   function sample_sweep() result(sweep)
      type(sweep_type) :: sweep
      sweep%name = 'b'
      sweep%string = ''
      sweep%models = [model_soft]
      sweep%operations = [operation_trip_out, operation_trip_in]
      sweep%frictions = [given(0.25_wp)]
      sweep%depths = [1000.0_wp, 1100.0_wp, 1200.0_wp, 1300.0_wp]
   end function sample_sweep

   function points_of(status) result(points)
      integer, intent(in) :: status(:)
      type(sweep_result_type) :: points(size(status))
      points%status = status
   end function points_of

   !> One part needs no table.
   subroutine test_all_converged()
      type(outcome_type) :: outcome
      type(line_list_type) :: page
      call append_outcome(page, si_units(), outcome)
      call assertEqual(0, page%count, message='nothing was asked for')
      call add_part(outcome, 'load cases', 8, 0, 0)
      call append_outcome(page, si_units(), outcome)
      call assertEqual(1, page%count)
      call assertEqual('<p class="note">All 8 solutions were found. The answers stand under Can it be done?</p>', &
                       page%lines(1)%text)
   end subroutine test_all_converged

   !> A load case that locks up is no failure. One that failed is named among the warnings, not again in a row.
   subroutine test_locked_up()
      type(outcome_type) :: outcome
      type(line_list_type) :: page, failed
      type(case_result_type) :: results(2)
      results%status = [result_locked_up, result_not_converged]
      call note_cases(outcome, results(:1))
      call append_outcome(page, si_units(), outcome)
      call append_lost(page, si_units(), outcome)
      call assertEqual(1, page%count, message='a row')
      call assertEqual('<p class="note">1 of 1 solution locks up: the string cannot be brought to that '// &
                       'depth or load.</p>', page%lines(1)%text)
      call note_cases(outcome, results(2:))
      call append_lost(failed, si_units(), outcome)
      call assertEqual(1, lost_count(outcome))
      call assertEqual(0, failed%count, message='a row')
   end subroutine test_locked_up

   !> Points that failed have a row each; neighbouring depths that lock up have one, which ends with their curve.
   subroutine test_sweep()
      type(outcome_type) :: outcome
      type(line_list_type) :: page
      type(sweep_result_type) :: points(8)
      call add_part(outcome, 'load cases', 8, 0, 0)
      points = points_of([result_converged, result_not_converged, result_converged, result_locked_up, &
                          result_locked_up, result_locked_up, result_not_converged, result_locked_up])
      points(2)%message = 'too <few>'
      call note_sweep(outcome, sample_sweep(), points, text_list('a sentence'))
      call assertEqual('a sentence', outcome%sentences(1)%text)
      call assertEqual(16, solution_count(outcome))
      call assertEqual(2, lost_count(outcome))
      call assertEqual(4, locked_count(outcome))
      call assertEqual(5, size(outcome%lost))
      call append_outcome(page, si_units(), outcome)
      call append_lost(page, si_units(), outcome)
      call assertTrue(index(page%lines(1)%text, '2 of 16 solutions did not converge (exit status 3). '// &
                            '4 of 16 solutions lock up: the string cannot be brought to that depth or load.<') > 0, &
                      message=page%lines(1)%text)
      call assertEqual('<tr><td class="text">sweep b</td><td>8</td><td>2</td><td>4</td><td>2</td></tr>', page%lines(4)%text)
      call assertEqual('<h2>Not solved, or locked up</h2>', page%lines(6)%text)
      call assertEqual('<tr><td class="text">sweep b</td><td class="text">soft</td><td class="text word">up</td>'// &
                       '<td>1100.00</td><td>&ndash;</td><td>0.25</td><td>1</td><td class="text">not_converged</td>'// &
                       '<td class="text">too &lt;few&gt;</td></tr>', page%lines(8)%text)
      call assertTrue(index(page%lines(9)%text, '>down</td><td>1200.00</td><td>&ndash;<') > 0, message=page%lines(9)%text)
      call assertTrue(index(page%lines(10)%text, '>up</td><td>1300.00</td><td>&ndash;<') > 0, message=page%lines(10)%text)
      call assertTrue(index(page%lines(11)%text, '>down</td><td>1000.00</td><td>1100.00</td><td>0.25</td><td>2</td>') > 0, &
                      message=page%lines(11)%text)
      call assertTrue(index(page%lines(12)%text, '>down</td><td>1300.00</td><td>&ndash;<') > 0, message=page%lines(12)%text)
   end subroutine test_sweep

   !> Which limits a sweep passes, and where first.
   subroutine test_sentences()
      type(sweep_result_type) :: points(8)
      type(text_type), allocatable :: lines(:)
      integer :: i
      points = points_of([(result_converged, i=1, size(points))])
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual(1, size(lines))
      call assertEqual('Sweep b, model soft: Can be done by string weight. No limits of rig or string are known', lines(1)%text)
      deallocate (lines)
      points(3)%hookload = -1.0e3_wp
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual('Sweep b, model soft: Can be done by string weight and push. No limits of rig or string are known', &
                       lines(1)%text)
      deallocate (lines)
      points%rig_margin = 1.0_wp
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual('Sweep b, model soft: Can be done. No limit of rig or string is passed', lines(1)%text)
      deallocate (lines)
      points([2, 4])%limit = limit_rig
      points([7, 8])%limit = limit_string_weight
      points(7)%status = result_not_converged
      points(7)%limit = 0
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual('Sweep b, model soft: Cannot be done at 1100 m, from 1300 m: up, friction 0.25 (rig). '// &
                       'Cannot be done from 1300 m: down, friction 0.25 (string weight)', lines(1)%text)
      deallocate (lines)
      ! the shallowest depth cannot be done, either
      points%limit = 0
      points([1, 2, 5, 6, 7, 8])%limit = limit_rig
      points(7)%status = result_converged
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual('Sweep b, model soft: Cannot be done from 1000 m, the least depth of the sweep, to 1100 m: up, friction '// &
                       '0.25 (rig). Cannot be done at any depth from 1000 m to 1300 m: down, friction 0.25 (rig)', lines(1)%text)
      deallocate (lines)
      points([1, 2, 4, 5, 6, 7, 8])%limit = 0
      points(3)%limit = limit_rig
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual('Sweep b, model soft: Cannot be done at 1200 m: up, friction 0.25 (rig)', lines(1)%text)
      deallocate (lines)
      ! warnings of points that can be done: two of one kind, one of another; a point that cannot be done is not counted
      points(1)%message = 'Compression is 12 times the load'
      points(3)%message = 'Compression is 14 times the load'
      points(6)%message = 'Compression is 13 times the load'
      points(8)%message = 'Contact is rough. Allow 3 %'
      allocate (lines, source=sweep_sentences(si_units(), sample_sweep(), points))
      call assertEqual('Sweep b, model soft: Cannot be done at 1200 m: up, friction 0.25 (rig). Points with a warning: 3, see '// &
                       'column message of its file', lines(1)%text)
      deallocate (lines)
      allocate (lines(0))
      call append_warned(lines, si_units(), sample_sweep(), points, 1)
      call assertEqual(2, size(lines))
      call assertEqual('WARNING at 2 points of model soft, the deepest at 1100 m, down, friction 0.25: '// &
                       'Compression is 13 times the load', lines(1)%text)
      call assertEqual('WARNING at 1 point of model soft, at 1300 m, down, friction 0.25: Contact is rough. Allow 3 %', &
                       lines(2)%text)
   end subroutine test_sentences

   !> A row a point, with the first sample that failed there.
   subroutine test_uncertainty()
      type(outcome_type) :: outcome
      type(line_list_type) :: page
      type(uncertainty_type) :: uncertainty
      type(sweep_result_type) :: pieces(24)
      uncertainty%range = sample_sweep()
      uncertainty%samples = 3
      pieces%status = result_converged
      pieces([5, 6, 24])%status = result_not_converged
      pieces(1)%status = result_locked_up
      call note_uncertainty(outcome, uncertainty, pieces)
      call assertEqual(24, solution_count(outcome))
      call assertEqual(3, lost_count(outcome))
      call assertEqual(1, locked_count(outcome))
      call assertEqual(2, size(outcome%lost))
      call append_outcome(page, si_units(), outcome)
      call append_lost(page, si_units(), outcome)
      call assertTrue(index(page%lines(4)%text, '<td>1100.00</td><td>0.25</td><td>2</td><td class="text">not_converged</td>'// &
                            '<td class="text"> (sample 2)</td>') > 0, message=page%lines(4)%text)
      call assertTrue(index(page%lines(5)%text, '<td>1300.00</td><td>0.25</td><td>1</td>') > 0, message=page%lines(5)%text)
   end subroutine test_uncertainty

   !> Count the rows that are too many for a page.
   subroutine test_too_many()
      type(outcome_type) :: outcome
      type(line_list_type) :: page
      integer :: i
      call add_part(outcome, 'calibration c', 400, 0, 400)
      do i = 1, 400
         call note_lost(outcome, 'calibration c', model_soft, result_not_converged, 'no fit')
      end do
      call assertEqual(400, size(outcome%lost) + outcome%unlisted)
      call assertTrue(outcome%unlisted > 0)
      call append_outcome(page, si_units(), outcome)
      call append_lost(page, si_units(), outcome)
      call assertTrue(index(page%lines(1)%text, '>400 of 400 solutions did not converge') > 0, message=page%lines(1)%text)
      call assertFalse(index(page%lines(page%count)%text, 'rows more') == 0, message=page%lines(page%count)%text)
   end subroutine test_too_many
end module dg_test_run_outcome
