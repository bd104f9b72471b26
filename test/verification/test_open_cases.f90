!> Strict cases that do not converge yet, each with what is known of the reason. Not registered in the driver; a case that
!> is cured moves to the suite that it belongs to.
module dg_test_open_cases
   use funit, only: TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_trip_in, operation_trip_out
   use dg_model, only: model_type
   use dg_test_wells, only: new_well, pipe, solve
   implicit none
   private
   public :: open_cases_suite

   real(wp), parameter :: w = 262.0_wp, od = 0.127_wp, id = 0.1086_wp

contains

   function open_cases_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('open_cases')
      call suite%addTest(TestMethod('stiff_walls', test_stiff_walls))
      call suite%addTest(TestMethod('severe_doglegs', test_severe_doglegs))
   end function open_cases_suite

   !> Walls of 1e11 N/m2 and more: round-off of a position times the wall's stiffness is more than 1e-9 of the weight. They
   !> converge to what round-off leaves, and are out of balance by 1.4e-6 (1e11) and 1.7e-4 (1e13) of the weight.
   subroutine test_stiff_walls()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: i
      do i = 11, 13, 2
         call new_well(model, [0.0_wp, 200.0_wp, 500.0_wp], [20.0_wp, 60.0_wp, 60.0_wp], [350.0_wp, 10.0_wp, 10.0_wp], 0.2_wp, &
                       0.3_wp, pipe(w, od, id))
         model%numerics%gk_contact = 10.0_wp**i
         model%numerics%gk_max = 10.0_wp*model%numerics%gk_contact
         call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'stiff wall')
      end do
   end subroutine test_stiff_walls

   !> Going in through 80 deg at 300 deg/30 m (100 and 200 converge).
   subroutine test_severe_doglegs()
      type(model_type) :: model
      type(case_result_type) :: result
      call new_well(model, [0.0_wp, 100.0_wp, 108.0_wp, 200.0_wp], [0.0_wp, 0.0_wp, 80.0_wp, 80.0_wp], &
                    spread(0.0_wp, 1, 4), 0.2_wp, 0.3_wp, pipe(w, od, id))
      model%boundary%top_centred = .true.
      model%boundary%bit_centred = .true.
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'severe dogleg')
   end subroutine test_severe_doglegs
end module dg_test_open_cases
