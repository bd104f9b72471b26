!> Strict cases that do not converge yet, each with what is known of the reason. Not registered in the driver; a case that
!> is cured moves to the suite that it belongs to.
module dg_test_open_cases
   use funit, only: assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static, operation_trip_in, operation_trip_out
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
      call suite%addTest(TestMethod('long_blades', test_long_blades))
   end function open_cases_suite

   !> The assembly of blades_of_real_length (dg_test_assemblies) with elements of 5 m: 18 % more side force at the bit. Both gaps
   !> next to one node of the lower blade stand at that node; a closed gap moves only where the string is deeper by half the
   !> clearance, and 0.2 m along a blade it is deeper by some hundredths of a millimetre. A threshold by penetration would let it
   !> move.
   subroutine test_long_blades()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: fine = 13753.15_wp   !< with elements of 0.5 m [N]
      call new_well(model, [0.0_wp, 150.0_wp], [45.0_wp, 45.0_wp], [0.0_wp, 0.0_wp], 0.3111_wp, 0.0_wp, &
                    pipe(1860.0_wp, 0.2032_wp, 0.0714_wp))
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(5))
      model%strings(1)%components = pipe(1860.0_wp, 0.2032_wp, 0.0714_wp)
      model%strings(1)%components%length = [0.4_wp, 1.8_wp, 18.0_wp, 1.8_wp, 0.0_wp]
      model%strings(1)%components(2)%kind = 'stabilizer'
      model%strings(1)%components(2)%joint_od = 0.3096_wp
      model%strings(1)%components(4)%kind = 'stabilizer'
      model%strings(1)%components(4)%joint_od = 0.3079_wp
      model%boundary%bit_centred = .true.
      model%numerics%element_length = 5.0_wp
      call solve(model, operation_static, 7.5e4_wp, 0.0_wp, result, 'long blades')
      call assertRelativelyEqual(fine, result%bit_side_force, 0.02_wp, message='side force')
   end subroutine test_long_blades

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
