!> A slick assembly that leaves the wall near a bit held on the axis: side force, slope and moments in closed form.
module dg_test_bit_side_force
   use funit, only: assertEqual, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_component, only: bending_stiffness, component_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_model, only: model_type
   use dg_test_wells, only: new_well, note, pipe, solve
   implicit none
   private
   public :: bit_side_force_suite

   real(wp), parameter :: w = 1500.0_wp, od = 0.16_wp, id = 0.07_wp, hole = 0.2_wp
   !> The string touches at one place an element and sinks into the wall by micrometres: the place of tangency is known to an
   !> element of 0.25 m in 12 m. Seen: 7e-4 in the side force, 3e-3 in the moment.
   real(wp), parameter :: tolerance = 5.0e-3_wp

contains

   function bit_side_force_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bit_side_force')
      call suite%addTest(TestMethod('shear_is_the_side_force', test_shear))
   end function bit_side_force_suite

   !> Horizontal, no friction, no bit load: tangency length (24 EI c/w)^(1/4), shear at the bit w L/2, none of bending there,
   !> largest moment w L^2/8 at L/2, where the shear is none.
   subroutine test_shear()
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: collar
      real(wp) :: length, shear, moment
      integer :: n, i
      collar = pipe(w, od, id)
      call new_well(model, [0.0_wp, 100.0_wp], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, collar)
      model%boundary%bit_centred = .true.
      model%numerics%element_length = 0.25_wp
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'slick assembly')
      length = (24.0_wp*bending_stiffness(collar)*0.5_wp*(hole - od)/w)**0.25_wp
      shear = 0.5_wp*w*length
      n = size(result%profile%md)
      call note('shear at the bit over w L/2', result%profile%shear(n)/shear)
      call assertRelativelyEqual(shear, result%profile%shear(n), tolerance, message='side force at the bit')
      i = minloc(abs(result%profile%md - (100.0_wp - 0.5_wp*length)), dim=1)
      moment = 0.125_wp*w*length**2
      call note('moment in the middle over w L^2/8', result%profile%bending(i)/moment)
      call assertRelativelyEqual(moment, result%profile%bending(i), tolerance, message='moment')
      call assertEqual(0.0_wp, result%profile%shear(i), 0.05_wp*shear, message='no shear where the moment is largest')
   end subroutine test_shear
end module dg_test_bit_side_force
