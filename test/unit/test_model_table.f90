!> The comparison of models: nothing for one model; differences against the first, marked where there is no solution.
module dg_test_model_table
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_job, only: job_type, model_mcge, model_rigid
   use dg_kinds, only: wp
   use dg_model_table, only: model_table
   use dg_test_report_sample, only: findings_with, sample_job, sample_model, sample_results
   use dg_text, only: text_type
   implicit none
   private
   public :: model_table_suite

   logical, parameter :: all_can(4) = .true.

contains

   function model_table_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('model_table')
      call suite%addTest(TestMethod('one_model', test_one))
      call suite%addTest(TestMethod('two_models', test_two))
   end function model_table_suite

   subroutine test_one()
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=model_table(findings_with(sample_job(), sample_model(), sample_results(), all_can)))
      call assertEqual(0, size(lines))
   end subroutine test_one

   subroutine test_two()
      type(case_result_type), allocatable :: first(:), second(:)
      type(text_type), allocatable :: lines(:)
      type(job_type) :: job
      job = sample_job()
      job%models = [model_rigid, model_mcge]
      allocate (first, source=sample_results())
      allocate (second, source=sample_results())
      first%model = model_rigid
      first%hookload = first%hookload - 1.0e3_wp
      allocate (lines, source=model_table(findings_with(job, sample_model(), [first, second], &
                                                       [all_can, [.true., .false., .true., .false.]])))
      call assertTrue(has('Models side by side; differences against rigid'))
      call assertTrue(has('i_up                    rigid        732.400           -        -       0.000           -        -'// &
                          '    0.2500'))
      call assertTrue(has('                        mcge         733.400       1.000    0.137       0.000       0.000        -'// &
                          '    0.2500'))
      call assertTrue(has('                        mcge               -           -        -           -           -        -'// &
                          '    1.5000 !'))
      call assertTrue(has('                        mcge         699.600       1.000    0.143       0.000       0.000        -'// &
                          '    0.2500 !'), message='cannot be done')
      call assertTrue(has('! cannot be done, or no solution'))
   contains
      function has(text) result(found)
         character(*), intent(in) :: text
         logical :: found
         integer :: i
         found = .false.
         do i = 1, size(lines)
            if (lines(i)%text == text) found = .true.
         end do
      end function has
   end subroutine test_two
end module dg_test_model_table
