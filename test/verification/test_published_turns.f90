!> Turn rates of slick motors against a fit to those of drilled wells (US patent 4,938,298): 55 times the interference over the
!> bend length [in/ft], plus 1.5, in deg/100 ft. The interference I is how far bit and motor overlap the wall, with bit and hole
!> diameters D, motor diameter d, bend angle theta at a length L from the bit's face, and the height h of a pad below the bend:
!>
!>   I = h + d/2 + L sin(theta) - D/2.
!>
!> The patent does not give what is above the bend, inclination and weight on bit; they are assumed. A pad is an eccentric
!> stabilizer that touches as the body does on the other side.
module dg_test_published_turns
   use funit, only: assertFalse, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree, foot, inch, pound_force
   use dg_equilibrium_curvature, only: find_equilibrium_curvature
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_sliding_drilling
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_steering, only: steering_result_type
   use dg_test_wells, only: note, steel
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: published_turns_suite

   real(wp), parameter :: hole = 4.5_wp*inch, body = 2.875_wp*inch, bore = 1.5_wp*inch, bit = 6.0_wp*inch, bend_at = 33.0_wp*inch
   real(wp), parameter :: pad_length = 6.0_wp*inch, motor_above = 12.0_wp*foot, collars = 60.0_wp*foot, depth = 1000.0_wp*foot
   real(wp), parameter :: per_hundred = degree/(100.0_wp*foot)

contains

   function published_turns_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('published_turns')
      call suite%addTest(TestMethod('within_the_range', test_range))
   end function published_turns_suite

   !> The fit lies between three-point geometry and the curvature without side force.
   subroutine test_range()
      real(wp), parameter :: bends(6) = [1.5_wp, 2.0_wp, 2.5_wp, 3.0_wp, 1.5_wp, 1.5_wp]*degree
      real(wp), parameter :: pads(6) = [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.25_wp, 0.5_wp]*inch
      type(steering_result_type) :: found
      real(wp) :: published
      integer :: i
      do i = 1, size(bends)
         call steer(bends(i), pads(i), found)
         published = turn_of_fit(bends(i), pads(i))
         call note('published [deg/100 ft]', published/per_hundred)
         call note('three points', found%three_points/per_hundred)
         call note('without side force', found%curvature(1)/per_hundred)
         call assertTrue(found%three_points <= published .and. published <= found%curvature(1))
      end do
   end subroutine test_range

   !> Turn rate by the patent [1/m].
   pure function turn_of_fit(bend, pad) result(turn)
      real(wp), intent(in) :: bend, pad    !< theta, h [rad, m]
      real(wp) :: turn
      real(wp) :: interference
      interference = pad + 0.5_wp*body + (bit + bend_at)*sin(bend) - 0.5_wp*hole
      turn = (55.0_wp*(interference/inch)/((bit + bend_at)/foot) + 1.5_wp)*per_hundred
   end function turn_of_fit

   !> &steering of the motor, sliding at 60 deg.
   subroutine steer(bend, pad, found)
      real(wp), intent(in) :: bend, pad    !< [rad, m]
      type(steering_result_type), intent(out) :: found
      type(model_type) :: model
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, depth], [60.0_wp, 60.0_wp]*degree, [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depth, hole, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(5))
      model%strings(1)%components = [steel('bit', bit, body, bore), steel('motor', bend_at - pad_length, body, bore), &
                                     steel('motor', pad_length, body, bore), steel('motor', motor_above, body, bore), &
                                     steel('collar', 0.0_wp, body, bore)]
      associate (components => model%strings(1)%components)
         components(1)%joint_od = hole
         if (pad > 0.0_wp) then
            components(3)%kind = 'stabilizer'
            components(3)%joint_od = body + pad
            components(3)%blade_offset = 0.5_wp*pad
            components(3)%blade_clock = 180.0_wp*degree
         end if
         components(4)%bend = bend
      end associate
      model%mud = standing_mud(1080.0_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation_sliding_drilling
      model%cases(1)%wob = 2000.0_wp*pound_force
      call find_equilibrium_curvature(model, 1, 0.0_wp, collars, optional_real(), found)
      call assertTrue(found%found, message=found%message)
   end subroutine steer
end module dg_test_published_turns
