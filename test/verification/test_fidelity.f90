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
      call suite%addTest(TestMethod('auto_in_a_short_string', test_auto_in_a_short_string))
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

   !> Collars of 240 m lowered through a bend that turns, against elements of half a metre. Elements of auto shrink in such a short
   !> string. Without that, contact is less exact by a factor of five at least.
   subroutine test_auto_in_a_short_string()
      real(wp), parameter :: asked = 3.0e-4_wp, gain = 5.0_wp
      type(model_type) :: model
      type(case_result_type) :: auto, long, fine
      call new_well(model, [0.0_wp, 80.0_wp, 140.0_wp, 240.0_wp], [70.0_wp, 70.0_wp, 82.0_wp, 82.0_wp], &
                    [0.0_wp, 0.0_wp, 15.0_wp, 15.0_wp], 0.2159_wp, 0.3_wp, pipe(1300.0_wp, 0.1651_wp, 0.0714_wp))
      model%boundary%top_centred = .true.
      model%boundary%bit_centred = .true.
      model%numerics = settings_of('auto')
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, auto, 'auto')
      model%numerics%full_length = 0.0_wp
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, long, 'long elements')
      model%numerics%element_length = 0.5_wp
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, fine, 'elements of 0.5 m')
      call note('contact, auto over short elements, less one', auto%normal_force/fine%normal_force - 1.0_wp)
      call note('contact, long over short elements, less one', long%normal_force/fine%normal_force - 1.0_wp)
      call note('hook load, auto over short elements, less one', auto%hookload/fine%hookload - 1.0_wp)
      call assertLessThan(abs(auto%normal_force - fine%normal_force), asked*fine%normal_force, message='contact')
      call assertLessThan(abs(auto%hookload - fine%hookload), asked*abs(fine%hookload), message='hook load')
      call assertLessThan(gain*abs(auto%normal_force - fine%normal_force), abs(long%normal_force - fine%normal_force), &
                          message='long elements are worse')
   end subroutine test_auto_in_a_short_string
end module dg_test_fidelity
