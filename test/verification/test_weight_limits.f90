!> Friction and weight on bit with which string weight is just enough, against the string solved anew a little to either side.
module dg_test_weight_limits
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type
   use dg_error, only: error_type
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_sliding_drilling
   use dg_model, only: model_type
   use dg_solve_case, only: solve_case
   use dg_test_wells, only: new_well, note, pipe
   implicit none
   private
   public :: weight_limits_suite

   !> Part by which friction or load is changed to either side of a limit [-].
   real(wp), parameter :: beside = 0.03_wp

contains

   function weight_limits_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('weight_limits')
      call suite%addTest(TestMethod('enough', test_enough))
      call suite%addTest(TestMethod('pushed', test_pushed))
      call suite%addTest(TestMethod('far', test_far))
   end function weight_limits_suite

   !> Tubing in a lateral that its weight moves down: it takes more friction and more weight on bit.
   subroutine test_enough()
      type(case_result_type) :: result
      call solve_lateral(12.0e3_wp, 1.0_wp, .false., result)
      call assertEqual(result_converged, result%status, message=result%message)
      call assertGreaterThan(result%hookload, 0.0_wp, message='weight is enough')
      call assertTrue(result%weight_limits%friction%present .and. result%weight_limits%wob%present, message='both limits')
      call assertGreaterThan(result%weight_limits%friction%value, 1.0_wp, message='friction')
      call assertGreaterThan(result%weight_limits%wob%value, 12.0e3_wp, message='weight on bit')
      call look_beside(12.0e3_wp, result, 1.0_wp)
   end subroutine test_enough

   !> The same tubing under a weight on bit that needs a push.
   subroutine test_pushed()
      type(case_result_type) :: result
      call solve_lateral(20.0e3_wp, 1.0_wp, .false., result)
      call assertEqual(result_converged, result%status, message=result%message)
      call assertLessThan(result%hookload, 0.0_wp, message='weight is not enough')
      call assertLessThan(result%weight_limits%friction%value, 1.0_wp, message='friction')
      call assertLessThan(result%weight_limits%wob%value, 20.0e3_wp, message='weight on bit')
      call look_beside(20.0e3_wp, result, 1.0_wp)
   end subroutine test_pushed

   !> The same tubing with 1.8 times the friction: its weight on bit is more than five times the limit.
   subroutine test_far()
      real(wp), parameter :: wob = 12.0e3_wp, friction = 1.8_wp
      type(case_result_type) :: result
      call solve_lateral(wob, friction, .false., result)
      call assertLessThan(result%hookload, 0.0_wp, message='weight is not enough')
      call assertLessThan(result%weight_limits%wob%value, 0.2_wp*wob, message='weight on bit')
      call look_beside(wob, result, friction)
   end subroutine test_far

   !> Solve the string anew beside its limits: the sign of its hook load changes.
   subroutine look_beside(wob, result, friction)
      real(wp), intent(in) :: wob                      !< of the result [N]
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: friction                 !< over 0.25, of the result [-]
      type(case_result_type) :: less, more
      associate (limits => result%weight_limits)
         call note('iterations to the limits', real(limits%iterations, wp))
         call note('weight on bit at its limit, kN', 1.0e-3_wp*limits%wob%value)
         call solve_lateral((1.0_wp - beside)*limits%wob%value, friction, .true., less)
         call solve_lateral((1.0_wp + beside)*limits%wob%value, friction, .true., more)
         call assertGreaterThan(less%hookload, 0.0_wp, message='less weight on bit')
         call assertLessThan(more%hookload, 0.0_wp, message='more weight on bit')
         call note('friction at its limit, over that of the case', limits%friction%value)
         call solve_lateral(wob, (1.0_wp - beside)*limits%friction%value*friction, .true., less)
         call solve_lateral(wob, (1.0_wp + beside)*limits%friction%value*friction, .true., more)
         call assertGreaterThan(less%hookload, 0.0_wp, message='less friction')
         call assertLessThan(more%hookload, 0.0_wp, message='more friction')
      end associate
   end subroutine look_beside

   !> Slide tubing of 60.3 mm in a lateral: 500 m down, a bend of 15 deg/30 m, 500 m along.
   subroutine solve_lateral(wob, friction, totals_only, result)
      real(wp), intent(in) :: wob        !< [N]
      real(wp), intent(in) :: friction   !< over 0.25 [-]
      logical, intent(in) :: totals_only
      type(case_result_type), intent(out) :: result
      type(model_type) :: model
      type(error_type), allocatable :: error
      type(component_type) :: tubing
      tubing = pipe(0.0_wp, 0.0603_wp, 0.0507_wp)
      tubing%mass = 6.99_wp
      call new_well(model, [0.0_wp, 500.0_wp, 680.0_wp, 1180.0_wp], [0.0_wp, 0.0_wp, 90.0_wp, 90.0_wp], &
                    [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], 0.0984_wp, 0.25_wp*friction, tubing)
      model%cases(1)%operation = operation_sliding_drilling
      model%cases(1)%wob = wob
      call solve_case(model, model_mcge, 1, result, error, totals_only=totals_only)
   end subroutine solve_lateral
end module dg_test_weight_limits
