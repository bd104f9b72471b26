!> The start of a buckled string against what the iteration finds from it: amplitude, wave number and above all phase. Drill pipe
!> in a straight horizontal hole, no friction; its hand in a hole that turns.
module dg_test_buckled_start
   use funit, only: assertEqual, assertLessThan, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged, scale_count
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: pi
   use dg_error, only: error_type
   use dg_gap_table, only: gap_table_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_sliding_drilling, operation_static
   use dg_mesh, only: mesh_type
   use dg_mesh_for_case, only: mesh_for_case
   use dg_model, only: model_type
   use dg_predictor, only: predict, start_type
   use dg_soft_string_loads, only: soft_totals_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: hold_ends, new_well, note, pipe, solve
   use dg_walls, only: lay_out_gaps
   implicit none
   private
   public :: buckled_start_suite

   real(wp), parameter :: weight = 265.0_wp, od = 0.127_wp, id = 0.1086_wp, clearance = 0.027_wp, length = 400.0_wp

contains

   function buckled_start_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('buckled_start')
      call suite%addTest(TestMethod('snake', test_sinusoidal))
      call suite%addTest(TestMethod('coil', test_coil))
      call suite%addTest(TestMethod('few_iterations', test_few_iterations))
      call suite%addTest(TestMethod('mirrored', test_mirrored))
   end function buckled_start_suite

   !> A hole that turns and its mirror image, without torque: coils are images, too. All coiled to the right, hook loads differed by
   !> 4e-4 of the largest force.
   subroutine test_mirrored()
      type(model_type) :: model
      type(case_result_type) :: result(2)
      integer :: i
      do i = 1, 2
         call new_well(model, [0.0_wp, 200.0_wp, 400.0_wp, 600.0_wp, 800.0_wp], [0.0_wp, 2.0_wp, 4.0_wp, 6.0_wp, 8.0_wp], &
                       (3.0_wp - 2.0_wp*i)*[0.0_wp, 0.0_wp, 60.0_wp, 120.0_wp, 180.0_wp], 0.2159_wp, 0.4_wp, &
                       pipe(weight, od, id))
         call solve(model, operation_sliding_drilling, 200.0e3_wp, 0.0_wp, result(i), 'mirrored')
      end do
      call assertTrue(result(1)%coiled, message='helically buckled')
      call assertEqual(result(1)%hookload, result(2)%hookload, 1.0e-3_wp, message='hook load [N]')
      call assertEqual(result(1)%normal_force, result(2)%normal_force, 1.0e-3_wp, message='contact force [N]')
   end subroutine test_mirrored

   !> Drill pipe in the hole, pushed by so many times Dawson & Paslay's load.
   subroutine pushed(ratio, model)
      real(wp), intent(in) :: ratio
      type(model_type), intent(out) :: model
      type(component_type) :: component
      component = pipe(weight, od, id)
      call new_well(model, [0.0_wp, length], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], od + 2.0_wp*clearance, 0.0_wp, component)
      call hold_ends(model)
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = ratio*2.0_wp*sqrt(bending_stiffness(component)*weight/clearance)
   end subroutine pushed

   !> Angles [rad] off the low side at the nodes as predicted and as found, under so many times Dawson & Paslay's load.
   subroutine angles(ratio, md, predicted, found)
      real(wp), intent(in) :: ratio
      real(wp), allocatable, intent(out) :: md(:), predicted(:), found(:)
      type(model_type) :: model
      type(case_result_type) :: result
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(soft_totals_type) :: totals
      type(error_type), allocatable :: error
      real(wp), allocatable :: state(:, :), pressed(:)
      real(wp) :: compressed, strained, pressing
      integer :: shortened(scale_count)
      call pushed(ratio, model)
      call mesh_for_case(model, 1, model%numerics%element_length, mesh, totals, compressed, strained, pressing, shortened)
      call lay_out_gaps(model%numerics, mesh, gaps)
      allocate (state(6, mesh%nodes), pressed(mesh%elements))
      call predict(model, 1, mesh, start_type(), spread(1.0_wp, 1, mesh%elements), state, gaps, pressed)
      md = mesh%md
      predicted = atan2(state(3, :), -state(2, :))      ! n_1 is the high side here
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_converged, result%status, message=result%message)
      call assertEqual(mesh%nodes, size(result%profile%md), message='nodes')
      found = pi - result%profile%clock
      call note('iterations', real(result%iterations, wp))
   end subroutine angles

   !> Amplitude and phase together: the mean square of what differs over that of the snake, either handedness; a quarter wave off it
   !> is 2, at opposite phase 4.
   subroutine test_sinusoidal()
      real(wp), parameter :: ratio(2) = [1.1_wp, 1.3_wp], off_end = 3.0_wp, allowed = 0.05_wp
      real(wp), allocatable :: md(:), predicted(:), found(:)
      real(wp) :: differs
      integer :: i
      do i = 1, size(ratio)
         call angles(ratio(i), md, predicted, found)
         associate (on_wall => md > off_end .and. md < length - off_end)
            differs = min(sum((predicted - found)**2, on_wall), sum((predicted + found)**2, on_wall))/sum(found**2, on_wall)
         end associate
         call note('differs', differs)
         call assertLessThan(differs, allowed, message='snake')
      end do
   end subroutine test_sinusoidal

   !> A coil's angle, unrolled, less what was predicted [rad]: over 25 turns within a twelfth of one.
   subroutine test_coil()
      real(wp), parameter :: ratio = 2.5_wp, off_end = 3.0_wp, allowed = pi/6.0_wp
      real(wp), allocatable :: md(:), predicted(:), found(:)
      real(wp) :: worst
      call angles(ratio, md, predicted, found)
      associate (on_wall => md > off_end .and. md < length - off_end)
         worst = min(maxval(abs(unrolled(predicted - found)), on_wall), maxval(abs(unrolled(predicted + found)), on_wall))
      end associate
      call note('worst angle', worst)
      call assertLessThan(worst, allowed, message='coil')
   end subroutine test_coil

   !> However few iterations are allowed, in the middle of gaps that move too, so many are done and no more, or the string is at
   !> rest.
   subroutine test_few_iterations()
      real(wp), parameter :: ratio = 1.8_wp, element_length = 3.0_wp
      integer, parameter :: most = 15
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i
      call pushed(ratio, model)
      model%numerics%element_length = element_length
      do i = 1, most
         model%numerics%max_iterations = i
         call solve_static_analysis(model, 1, result, error)
         if (result%status /= result_converged) call assertEqual(i, result%iterations, message='all that are allowed')
         call assertTrue(result%iterations <= i, message='no more')
      end do
   end subroutine test_few_iterations

   !> The same angle in (-pi, pi] [rad].
   elemental function unrolled(angle) result(small)
      real(wp), intent(in) :: angle
      real(wp) :: small
      small = angle - 2.0_wp*pi*anint(angle/(2.0_wp*pi))
   end function unrolled
end module dg_test_buckled_start
