!> Friction by component, of its own or as a share of the hole's, by all models where the answer is a closed form.
module dg_test_component_friction
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_missing, only: given
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_test_wells, only: new_well, note, pipe, solve
   implicit none
   private
   public :: component_friction_suite

   integer, parameter :: soft = 1, rigid = 2, mixed = 3, beams = 4
   !> Of the hole, of the lower component itself, and what the upper one makes of the hole's.
   real(wp), parameter :: of_hole = 0.3_wp, own = 0.1_wp, share = 0.5_wp

contains

   function component_friction_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('component_friction')
      call suite%addTest(TestMethod('straight_hole', test_straight_hole))
      call suite%addTest(TestMethod('capstan', test_capstan))
      call suite%addTest(TestMethod('load_case_overrides_the_hole', test_override))
   end function component_friction_suite

   !> Cuts the string in two: a lower component of that length with friction of its own, an upper one with a share of the hole's.
   subroutine divide(model, lower)
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: lower   !< [m]
      model%strings(1)%components = [model%strings(1)%components(1), model%strings(1)%components(1)]
      associate (parts => model%strings(1)%components)
         parts(1)%length = lower
         parts(1)%friction_axial = own
         parts(1)%friction_rotary = own
         parts(2)%scale_axial = share
         parts(2)%scale_rotary = share
      end associate
   end subroutine divide

   subroutine solve_by(model, number, operation, wob, result)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: number, operation
      real(wp), intent(in) :: wob
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation
      model%cases(1)%wob = wob
      select case (number)
      case (soft); call solve_soft_string(model, 1, result, error)
      case (rigid); call solve_rigid_string(model, 1, result, error)
      case (mixed); call solve_mixed_string(model, 1, result, error)
      case default; call solve(model, operation, wob, 0.0_wp, result, 'friction by component')
      end select
      call assertFalse(allocated(error), message='solves')
   end subroutine solve_by

   !> Hook load w L cos +- w sin (own L_1 + share of_hole L_2), torque r w sin (m_1 L_1 + m_2 L_2) with m = mu/sqrt(1 + mu**2),
   !> as each part climbs to atan(mu) off the low side. Friction of beams acts at the wall, a couple mu r w sin per metre; where it
   !> changes, at the ends and between the parts, the wall presses more or less, and that rubs, too: see `arm`.
   subroutine test_straight_hole()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 262.0_wp, length = 200.0_wp, lower = 80.0_wp, theta = 60.0_wp*degree, radius = 0.0635_wp
      !> Beams go over from one angle about the hole to the other within some metres: seen 1e-5 of the torque.
      real(wp), parameter :: within(4) = [1.0e-12_wp, 1.0e-12_wp, 1.0e-12_wp, 1.0e-7_wp], bridged = 1.0e-4_wp
      real(wp) :: along, around, upper, more
      integer :: i
      call new_well(model, [0.0_wp, length], [60.0_wp, 60.0_wp], [40.0_wp, 40.0_wp], 0.2_wp, of_hole, &
                    pipe(w, 0.127_wp, 0.1086_wp))
      call divide(model, lower)
      model%numerics%element_length = 4.0_wp
      model%numerics%wall_climb = .true.         ! of the models on the axis
      upper = share*of_hole
      along = w*sin(theta)*(own*lower + upper*(length - lower))
      around = radius*w*sin(theta)*(own/sqrt(1.0_wp + own**2)*lower + upper/sqrt(1.0_wp + upper**2)*(length - lower))
      do i = soft, beams
         call solve_by(model, i, operation_trip_out, 0.0_wp, result)
         more = merge(arm(radius*w*sin(theta), upper), 0.0_wp, i == beams)
         call assertEqual(w*length*cos(theta) + along + more, result%hookload, within(i)*w*length, message='up')
         call solve_by(model, i, operation_trip_in, 0.0_wp, result)
         call assertEqual(w*length*cos(theta) - along + more, result%hookload, within(i)*w*length, message='down')
         call solve_by(model, i, operation_rotate_off_bottom, 0.0_wp, result)
         call note('torque over closed form - 1', result%torque/around - 1.0_wp)
         call assertRelativelyEqual(around, result%torque, merge(bridged, within(i), i == beams), message='torque')
      end do
   end subroutine test_straight_hole

   !> Change of hook load by the couple r n mu per metre of friction at the wall, for a string of two parts, pulled or lowered.
   !> Contact is less by r n own at the bit, by r n (upper - own) between, half of it on either part, and more by r n upper at the
   !> top.
   pure function arm(couple, upper) result(force)
      real(wp), intent(in) :: couple, upper   !< r n [N], mu of the upper part
      real(wp) :: force
      force = couple*(upper**2 - own**2 - 0.5_wp*(upper - own)*(upper + own))
   end function arm

   !> Weightless tubing over 90 deg, half of it with either friction: the forces multiply, F exp(mu_1 beta/2) exp(mu_2 beta/2).
   subroutine test_capstan()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: radius = 300.0_wp, beta = 0.5_wp*pi, pull = 5.0e4_wp
      !> Of beams, as a capstan in one piece: arm of friction and ends.
      real(wp), parameter :: within(4) = [1.0e-9_wp, 1.0e-9_wp, 1.0e-9_wp, 5.0e-4_wp]
      real(wp) :: factor
      integer :: i
      call new_well(model, [0.0_wp, radius*beta], [45.0_wp, 90.0_wp], [0.0_wp, 90.0_wp], 0.15_wp, of_hole, &
                    pipe(0.0_wp, 0.073_wp, 0.0548_wp))
      call divide(model, 0.5_wp*radius*beta)
      model%numerics%element_length = 5.0_wp
      factor = exp(0.5_wp*beta*(own + share*of_hole))
      do i = soft, beams
         call solve_by(model, i, operation_trip_out, -pull, result)
         call note('up: over closed form - 1', result%hookload/(pull*factor) - 1.0_wp)
         call assertRelativelyEqual(pull*factor, result%hookload, within(i), message='up')
         call solve_by(model, i, operation_trip_in, -pull, result)
         call assertRelativelyEqual(pull/factor, result%hookload, within(i), message='down')
      end do
   end subroutine test_capstan

   !> A load case, so a point of a sweep, says what the hole is like: a share goes by it, friction of its own does not.
   subroutine test_override()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 262.0_wp, length = 200.0_wp, lower = 80.0_wp, other = 0.4_wp
      real(wp) :: along
      integer :: i
      call new_well(model, [0.0_wp, length], [90.0_wp, 90.0_wp], [40.0_wp, 40.0_wp], 0.2_wp, of_hole, &
                    pipe(w, 0.127_wp, 0.1086_wp))
      call divide(model, lower)
      model%cases(1)%friction_axial = given(other)
      model%numerics%element_length = 4.0_wp
      do i = soft, beams
         call solve_by(model, i, operation_trip_out, 0.0_wp, result)
         along = w*(own*lower + share*other*(length - lower))
         if (i == beams) along = along + arm(0.0635_wp*w, share*other)
         call assertRelativelyEqual(along, result%hookload, 1.0e-6_wp, message='up')
      end do
   end subroutine test_override
end module dg_test_component_friction
