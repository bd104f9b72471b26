!> Error of fidelity settings: coarse meshes against elements of 1 m.
module dg_test_fidelity
   use funit, only: assertLessThan, assertEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_trip_in, operation_trip_out
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_nodes, numerics_type, settings_of
   use dg_test_wells, only: new_well, note, pipe, solve
   implicit none
   private
   public :: fidelity_suite

contains

   function fidelity_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('fidelity')
      call suite%addTest(TestMethod('settings', test_settings))
      call suite%addTest(TestMethod('auto_against_reference', test_auto_against_reference))
   end function fidelity_suite

   subroutine test_settings()
      type(numerics_type) :: numerics
      numerics = settings_of('fast')
      call assertEqual(gap_at_nodes, numerics%gap_location, message='fast: gaps')
      call assertEqual(1.0e-6_wp, numerics%tolerance, 1.0e-12_wp, message='fast: tolerance')
      numerics = settings_of('reference')
      call assertEqual(1.0_wp, numerics%element_length, 1.0e-12_wp, message='reference: length')
   end subroutine test_settings

   !> Hook load and torque within 0.5 % of 1 m elements, with an eighth of the elements at most (a ninth; and fewer iterations
   !> on top, so that the cost is a tenth or less).
   subroutine test_auto_against_reference()
      type(model_type) :: model
      type(case_result_type) :: coarse, fine
      integer, parameter :: operation(4) = [operation_trip_out, operation_trip_in, operation_rotary_drilling, &
                                            operation_sliding_drilling]
      real(wp), parameter :: asked = 5.0e-3_wp, wob = 3.0e4_wp, tob = 2.0e3_wp
      real(wp) :: load, torque
      integer :: i
      call new_well(model, [0.0_wp, 600.0_wp, 1200.0_wp, 1700.0_wp, 2600.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 70.0_wp, 70.0_wp], &
                    [0.0_wp, 0.0_wp, 10.0_wp, 30.0_wp, 30.0_wp], 0.2159_wp, 0.25_wp, pipe(262.0_wp, 0.127_wp, 0.1086_wp))
      model%boundary%top_centred = .true.   ! as on a rig: a free top may hang anywhere along the vertical wall
      model%boundary%bit_centred = .true.
      do i = 1, size(operation)
         load = merge(wob, 0.0_wp, i > 2)
         torque = merge(tob, 0.0_wp, i > 2)
         model%numerics = settings_of('auto')
         call solve(model, operation(i), load, torque, coarse, 'auto')
         model%numerics = settings_of('reference')
         call solve(model, operation(i), load, torque, fine, 'reference')
         call note('hook load, auto over reference', coarse%hookload/fine%hookload - 1.0_wp)
         call note('elements, auto over reference', real(coarse%elements, wp)/fine%elements)
         call assertLessThan(abs(coarse%hookload - fine%hookload), asked*abs(fine%hookload), message='hook load')
         call assertLessThan(abs(coarse%torque - fine%torque), asked*max(abs(fine%torque), tob), message='torque')
         call assertLessThan(8*coarse%elements, fine%elements, message='elements')
      end do
   end subroutine test_auto_against_reference
end module dg_test_fidelity
