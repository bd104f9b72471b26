module dg_test_report_table
   use funit, only: assertFalse, assertLessThanOrEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_job, only: job_type, model_mcge, model_soft
   use dg_kinds, only: wp
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_result_table, only: cost_table, result_table
   use dg_test_report_sample, only: findings_with, sample_job, sample_model, sample_results
   use dg_text, only: text_type
   use dg_units, only: field_units
   use dg_findings, only: findings_type
   implicit none
   private
   public :: report_table_suite

   integer, parameter :: page_width = 120

contains

   !> The tables, each converged case with the answer yes.
   function table_of(job, model, results) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(text_type), allocatable :: lines(:)
      type(findings_type) :: found
      found = findings_with(job, model, results, results%status == result_converged)
      allocate (lines, source=[result_table(found), cost_table(found)])
   end function table_of

   function report_table_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('report_table')
      call suite%addTest(TestMethod('rows_of_table_1', test_rows_of_table_1))
      call suite%addTest(TestMethod('no_reference_no_column', test_no_reference_no_column))
      call suite%addTest(TestMethod('empty_columns', test_empty_columns))
      call suite%addTest(TestMethod('errors_over_solved_cases', test_errors_over_solved_cases))
      call suite%addTest(TestMethod('costs_and_states', test_costs_and_states))
      call suite%addTest(TestMethod('what_is_no_solution_is_marked', test_what_is_no_solution_is_marked))
      call suite%addTest(TestMethod('label_of_a_lone_case', test_label_of_a_lone_case))
      call suite%addTest(TestMethod('one_page_wide', test_one_page_wide))
      call suite%addTest(TestMethod('field_units', test_field_units))
      call suite%addTest(TestMethod('with_a_rig', test_with_a_rig))
      call suite%addTest(TestMethod('a_table_each_model', test_a_table_each_model))
   end function report_table_suite

   subroutine test_rows_of_table_1()
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=sample_table())
      call assertTrue(has(lines, 'Model mcge (beams with contact)'))
      call assertTrue(has(lines, 'Inclined section up               i_up           0.0      733.4     745.0     1.56     -17.29'// &
                          '        -         -     -'), message='up')
      call assertTrue(has(lines, '2075 m, 65 deg   down             i_down         0.0      699.6     707.0     1.05      16.37'// &
                          '        -         -     -'), message='down')
      call assertTrue(has(lines, '                 rotary drilling  i_rotary     150.0      568.2     564.0     0.74          -'// &
                          '    13.69         -     -'), message='rotary')
      call assertTrue(has(lines, '                 sliding drilling i_sliding    170.0          -         -        -          -'// &
                          '        -     524.3     - !'), message='sliding')
   end subroutine test_rows_of_table_1

   subroutine test_no_reference_no_column()
      type(text_type), allocatable :: lines(:)
      type(model_type) :: model
      model = sample_model()
      model%cases(4)%reference_hookload = optional_real()
      allocate (lines, source=table_of(sample_job(), model, sample_results()))
      call assertFalse(contains_text(lines, 'Reference'))
      call assertFalse(contains_text(lines, 'against reference'))
      call assertTrue(contains_text(lines, 'Measured'))
   end subroutine test_no_reference_no_column

   !> Columns that would be empty are left out: nothing measured, only strings that turn, only strings that move.
   subroutine test_empty_columns()
      type(text_type), allocatable :: lines(:)
      type(case_result_type), allocatable :: results(:)
      type(model_type) :: model
      model = sample_model()
      model%cases%measured_hookload = optional_real()
      model%cases%measured_torque = optional_real()
      allocate (results, source=sample_results())
      allocate (lines, source=table_of(sample_job(), model, results(1:2)))
      call assertFalse(contains_text(lines, 'Measured'), message='nothing measured')
      call assertFalse(contains_text(lines, 'Relative'), message='no error')
      call assertFalse(contains_text(lines, 'surface'), message='nothing turns')
      call assertTrue(contains_text(lines, '(drag)'))
      deallocate (lines)
      allocate (lines, source=table_of(sample_job(), model, results(3:3)))
      call assertFalse(contains_text(lines, '(drag)'), message='nothing moves')
      call assertTrue(contains_text(lines, 'surface'))
   end subroutine test_empty_columns

   !> Mean of 1.557, 1.047 and 0.745 %.
   subroutine test_errors_over_solved_cases()
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=sample_table())
      call assertTrue(has(lines, 'Hook load against measurement: mean error 1.12 %, worst 1.56 % (i_up), 3 cases, '// &
                          '0.62 % too low on average'))
      call assertTrue(has(lines, 'Hook load against reference: no case solved, 1 not solved left out'))
      call assertFalse(contains_text(lines, 'Torque against'))
   end subroutine test_errors_over_solved_cases

   subroutine test_costs_and_states()
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=sample_table())
      call assertTrue(has(lines, 'i_up                    converged          208          7    0.250     100      90'// &
                          '      18      12       3'))
      call assertTrue(has(lines, 'all                     3 of 4             832        224    2.250'// &
                          '   out of balance 1.0E-09 kN, 2.0E-09 kN.m'))
   end subroutine test_costs_and_states

   subroutine test_what_is_no_solution_is_marked()
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=sample_table())
      call assertTrue(has(lines, '! cannot be done, or no solution'))
   end subroutine test_what_is_no_solution_is_marked

   !> A label of two lines beside one row: the second line stands alone.
   subroutine test_label_of_a_lone_case()
      type(text_type), allocatable :: lines(:)
      type(case_result_type), allocatable :: results(:)
      allocate (results, source=sample_results())
      allocate (lines, source=table_of(sample_job(), sample_model(), results(1:1)))
      call assertTrue(has(lines, '2075 m, 65 deg'))
   end subroutine test_label_of_a_lone_case

   subroutine test_one_page_wide()
      type(text_type), allocatable :: lines(:)
      type(model_type) :: model
      integer :: i
      model = sample_model()
      model%cases(1)%name = repeat('long', 40)
      model%cases(2)%section = repeat('horizontal section ', 5)
      model%cases(3)%section = repeat('x', 200)
      model%cases(4)%wob = 1.0e12_wp
      allocate (lines, source=table_of(sample_job(), model, sample_results()))
      do i = 1, size(lines)
         call assertLessThanOrEqual(len(lines(i)%text), page_width, message=lines(i)%text)
      end do
   end subroutine test_one_page_wide

   !> 733.4 kN = 164.9 klbf, 2075 m = 6807.7 ft, 13.69 kN.m = 10.10 kft.lbf.
   subroutine test_field_units()
      type(text_type), allocatable :: lines(:)
      type(job_type) :: job
      job = sample_job()
      job%units = field_units()
      allocate (lines, source=table_of(job, sample_model(), sample_results()))
      call assertTrue(contains_text(lines, 'up               i_up           0.0      164.9     167.5     1.56      -3.89'))
      call assertTrue(contains_text(lines, '6807.7 ft, 65 deg'))
      call assertTrue(contains_text(lines, ' 10.10 '))
      call assertTrue(contains_text(lines, 'klbf'))
      call assertTrue(contains_text(lines, 'kft.lbf'))
      call assertFalse(contains_text(lines, 'kN.m'))
   end subroutine test_field_units

   !> 733.4 kN and a block of 150 kN, measured 880 kN: 0.39 %. With a reference, too, the labels are narrower.
   subroutine test_with_a_rig()
      type(case_result_type), allocatable :: results(:)
      type(text_type), allocatable :: lines(:)
      type(model_type) :: model
      integer :: i
      model = sample_model()
      model%cases(1)%measured_hookload%value = 880.0e3_wp
      allocate (results, source=sample_results())
      results%weight_indicator = results%hookload + 150.0e3_wp
      allocate (lines, source=table_of(sample_job(), model, results))
      call assertTrue(has(lines, 'Inclined       up                    0.0      733.4     880.0     0.39     -17.29'// &
                          '        -     883.4         -     -'), message='up')
      call assertTrue(contains_text(lines, 'Weight indicator, block included, against measurement: mean error'))
      call assertTrue(contains_text(lines, '(no block)') .and. contains_text(lines, '(+ block)'), message='hook load and indicator')
      do i = 1, size(lines)
         call assertLessThanOrEqual(len(lines(i)%text), page_width, message=lines(i)%text)
      end do
      deallocate (lines)
      model%cases(4)%reference_hookload = optional_real()
      allocate (lines, source=table_of(sample_job(), model, results))
      call assertTrue(has(lines, 'Inclined section up               i_up           0.0      733.4     880.0     0.39     -17.29'// &
                          '        -     883.4'), message='without reference')
   end subroutine test_with_a_rig

   subroutine test_a_table_each_model()
      type(text_type), allocatable :: lines(:)
      type(job_type) :: job
      type(case_result_type), allocatable :: results(:)
      integer :: i
      job = sample_job()
      job%models = [model_soft, model_mcge]
      allocate (results(4), source=sample_results())
      do i = 1, 2
         results(i)%model = model_soft
         results(i)%states = 0
         results(i)%iterations = 0
      end do
      results(4)%status = result_converged
      allocate (lines, source=table_of(job, sample_model(), results))
      call assertLessThanOrEqual(line_of(lines, 'Model soft') + 1, line_of(lines, 'Model mcge'))
      call assertTrue(contains_text(lines, 'Model soft'))
      call assertTrue(has(lines, 'i_up                    converged          208          -    0.250       -       -'// &
                          '       -       -       -'), message='no gaps in this model')
      call assertTrue(has(lines, 'all                     2 of 2             416          -    0.500'), message='nor iterations')
   end subroutine test_a_table_each_model

   function sample_table() result(lines)
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=table_of(sample_job(), sample_model(), sample_results()))
   end function sample_table

   !> True if one of the lines is this text.
   pure logical function has(lines, text)
      type(text_type), intent(in) :: lines(:)
      character(*), intent(in) :: text
      integer :: i
      has = .false.
      do i = 1, size(lines)
         has = has .or. lines(i)%text == text
      end do
   end function has

   pure logical function contains_text(lines, text)
      type(text_type), intent(in) :: lines(:)
      character(*), intent(in) :: text
      contains_text = line_of(lines, text) <= size(lines)
   end function contains_text

   !> Number of the first line that holds a text; one past the last where none does.
   pure integer function line_of(lines, text)
      type(text_type), intent(in) :: lines(:)
      character(*), intent(in) :: text
      do line_of = 1, size(lines)
         if (index(lines(line_of)%text, text) > 0) return
      end do
      line_of = size(lines) + 1
   end function line_of
end module dg_test_report_table
