!> Strict cases that do not converge yet, each with what is known of the reason. Not registered in the driver; a case that
!> is cured moves to the suite that it belongs to.
module dg_test_open_cases
   use funit, only: assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_static, operation_trip_in, &
      operation_trip_out
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
      call suite%addTest(TestMethod('vertical_with_torque', test_vertical_with_torque))
      call suite%addTest(TestMethod('light_column', test_light_column))
      call suite%addTest(TestMethod('stiff_walls', test_stiff_walls))
      call suite%addTest(TestMethod('severe_doglegs', test_severe_doglegs))
      call suite%addTest(TestMethod('straight_up', test_straight_up))
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

   !> Collars past Lubinski's load in an exactly vertical hole, with torque on bit: w L - WOB. The buckled string may turn about
   !> the hole axis at no cost; torque that follows its tangent, or circumferential friction, turns it for ever. Without torque, or
   !> in a hole of 0.1 deg, it converges.
   subroutine test_vertical_with_torque()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: wob = 60.0e3_wp
      integer :: i
      call new_well(model, [0.0_wp, 400.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.2159_wp, 0.3_wp, &
                    pipe(1288.0_wp, 0.17145_wp, 0.0714_wp))
      model%boundary%top_centred = .true.
      model%boundary%bit_centred = .true.
      do i = operation_rotary_drilling, operation_sliding_drilling
         call solve(model, i, wob, 2700.0_wp, result, 'vertical with torque')
         call assertRelativelyEqual(1288.0_wp*400.0_wp - wob, result%hookload, 1.0e-3_wp, message='hook load')
      end do
   end subroutine test_vertical_with_torque

   !> Half of Euler's load on a string of almost no weight, the wall half a metre away. The softest stage of the wall is measured
   !> by the weight alone, and the helix laid at the start is pressed metres into it by c F**2/(4 EI).
   subroutine test_light_column()
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: component
      real(wp), parameter :: length = 20.0_wp, weight = 0.1_wp
      real(wp) :: ei, load, sag
      component = pipe(weight, od, id)
      ei = bending_stiffness(component)
      load = 0.5_wp*pi**2*ei/length**2
      sag = weight*ei/load**2*(1.0_wp/cos(0.5_wp*sqrt(load/ei)*length) - 1.0_wp) - weight*length**2/(8.0_wp*load)
      call new_well(model, [0.0_wp, length], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], od + 1.0_wp, 0.0_wp, component)
      model%boundary%top_centred = .true.
      model%boundary%bit_centred = .true.
      model%numerics%element_length = 1.0_wp
      call solve(model, operation_static, load, 0.0_wp, result, 'light column')
      call assertRelativelyEqual(sag, maxval(result%profile%displacement), 1.0e-3_wp, message='sag')
   end subroutine test_light_column

   !> Walls of 1e9 N/m2 and more: round-off of a position times the wall's stiffness is more than 1e-9 of the weight, so
   !> that the residual stays at 1.3e-9 (1e9), 2e-7 (1e11), 2e-5 (1e13) with nothing else changing.
   subroutine test_stiff_walls()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: i
      do i = 9, 13, 2
         call new_well(model, [0.0_wp, 200.0_wp, 500.0_wp], [20.0_wp, 60.0_wp, 60.0_wp], [350.0_wp, 10.0_wp, 10.0_wp], 0.2_wp, &
                       0.3_wp, pipe(w, od, id))
         model%numerics%gk_contact = 10.0_wp**i
         model%numerics%gk_max = 10.0_wp*model%numerics%gk_contact
         call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'stiff wall')
      end do
   end subroutine test_stiff_walls

   !> Going in through 80 deg at 100, 200 and 300 deg/30 m (coming out and rotating converge).
   subroutine test_severe_doglegs()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: i
      do i = 1, 3
         call new_well(model, [0.0_wp, 100.0_wp, 100.0_wp + 24.0_wp/i, 200.0_wp], [0.0_wp, 0.0_wp, 80.0_wp, 80.0_wp], &
                       spread(0.0_wp, 1, 4), 0.2_wp, 0.3_wp, pipe(w, od, id))
         model%boundary%top_centred = .true.
         model%boundary%bit_centred = .true.
         call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'severe dogleg')
      end do
   end subroutine test_severe_doglegs

   !> Straight up, standing on the surface: -w L. The static case converges; friction at a wall touched without weight does not.
   subroutine test_straight_up()
      type(model_type) :: model
      type(case_result_type) :: result
      call new_well(model, [0.0_wp, 50.0_wp], [180.0_wp, 180.0_wp], [0.0_wp, 0.0_wp], 0.2_wp, 0.3_wp, pipe(w, od, id))
      model%boundary%top_centred = .true.
      model%boundary%bit_centred = .true.
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'straight up')
      call assertRelativelyEqual(-50.0_wp*w, result%hookload, 1.0e-2_wp, message='hook load')
   end subroutine test_straight_up
end module dg_test_open_cases
