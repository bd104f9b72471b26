!> A small job with results for the tests of the report: rows of the paper's Table 1 (2075 m).
module dg_test_report_sample
   use dg_case_result, only: case_result_type, iteration_type, result_converged, result_not_converged
   use dg_constants, only: degree
   use dg_findings, only: findings_type
   use dg_job, only: job_type, model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_trip_in, operation_trip_out
   use dg_missing, only: given
   use dg_model, only: model_type
   use dg_profile, only: new_profile, state_elastic
   use dg_verdict, only: answer_yes
   implicit none
   private
   public :: findings_with, sample_job, sample_model, sample_results

contains

   !> Findings of some results, of which some have the answer yes.
   function findings_with(job, model, results, can) result(found)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: can(:)          !< as many: the operation can be done
      type(findings_type) :: found
      found%job = job
      found%model = model
      found%results = results
      allocate (found%wholes(size(results)))
      where (can) found%wholes%verdict%answer = answer_yes
   end function findings_with

   function sample_job() result(job)
      type(job_type) :: job
      job%title = 'Sample'
      job%models = [model_mcge]
   end function sample_job

   !> Up, down, rotary and sliding; the last one with a reference and a name that needs quotes.
   function sample_model() result(model)
      type(model_type) :: model
      integer :: i
      allocate (model%cases(4))
      do i = 1, 4
         model%cases(i)%section = 'Inclined section'
         model%cases(i)%bit_depth = 2075.0_wp
      end do
      model%cases(1)%name = 'i_up'
      model%cases(2)%name = 'i_down'
      model%cases(3)%name = 'i_rotary'
      model%cases(4)%name = 'i_sliding'
      model%cases%operation = [operation_trip_out, operation_trip_in, operation_rotary_drilling, operation_sliding_drilling]
      model%cases%wob = [0.0_wp, 0.0_wp, 150.0e3_wp, 170.0e3_wp]
      model%cases(:3)%measured_hookload = given([745.0e3_wp, 707.0e3_wp, 564.0e3_wp])
      model%cases(4)%reference_hookload = given(524.3e3_wp)
   end function sample_model

   function sample_results() result(results)
      type(case_result_type), allocatable :: results(:)
      integer :: i
      allocate (results(4))
      results%case_index = [(i, i=1, 4)]
      results%model = model_mcge
      results%status = [result_converged, result_converged, result_converged, result_not_converged]
      results%inclination = 65.0_wp*degree
      results%hookload = [733.4e3_wp, 699.6e3_wp, 568.2e3_wp, 530.0e3_wp]
      results%friction = [-17.29e3_wp, 16.37e3_wp, 0.0_wp, 29.84e3_wp]
      results%torque = [0.0_wp, 0.0_wp, 13.69e3_wp, 0.0_wp]
      results%normal_force = 170.0e3_wp
      results%iterations = [7, 8, 9, 200]
      results%elements = 208
      results%seconds = [0.25_wp, 0.25_wp, 0.25_wp, 1.5_wp]
      results%flips = 12
      results%moves = 3
      results%equilibrium_force = 1.0e-6_wp
      results%equilibrium_moment = 2.0e-6_wp
      do i = 1, 4
         results(i)%states = [100, 90, 18]
         results(i)%message = ''
         results(i)%profile = new_profile(2)
      end do
      results(4)%message = 'residual 3 kN after 200 iterations, in the vertical part; try shorter elements'
      results(1)%profile%md = [0.0_wp, 2075.0_wp]
      results(1)%profile%axial = [733.4e3_wp, 0.0_wp]
      results(1)%profile%inclination = [0.0_wp, 65.0_wp*degree]
      results(1)%profile%displacement = [0.0_wp, 0.0445_wp]
      results(1)%profile%gap_state(2) = state_elastic
      allocate (results(1)%history(1))
      results(1)%history(1) = iteration_type(attempt=1, increment=1, stage=2, iteration=1, residual_force=500.0_wp, &
                                             hookload=733.4e3_wp)
   end function sample_results
end module dg_test_report_sample
