!> Change of curvature along a stiff string: continuity, balance of moment and shear, length, choice of the mixed model.
module dg_test_curvature_change
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_curvature_change, only: bending_at, change_type, curvature_changes
   use dg_constants, only: degree
   use dg_component, only: bending_stiffness, component_type
   use dg_error, only: error_type
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_model, only: model_type
   use dg_assembly_elements, only: matters
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: curvature_change_suite

   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   function curvature_change_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('curvature_change')
      call suite%addTest(TestMethod('moment_has_no_jump', test_no_jump))
      call suite%addTest(TestMethod('shear_is_slope_of_moment', test_shear))
      call suite%addTest(TestMethod('length_and_force', test_length))
      call suite%addTest(TestMethod('none_without_stiffness_or_bend', test_none))
      call suite%addTest(TestMethod('choice_of_the_mixed_model', test_choice))
   end function curvature_change_suite

   pure function one_change() result(change)
      type(change_type) :: change
      change%md = 100.0_wp
      change%moment = [2.0e3_wp, 0.0_wp, 0.0_wp]
      change%curvature = [1.0e-3_wp, 0.0_wp, 0.0_wp]
      change%length = 3.0_wp
      change%stiffness = 2.0e6_wp
   end function one_change

   pure subroutine look(md, side, curvature, moment, shear, slope)
      real(wp), intent(in) :: md, side
      real(wp), intent(out) :: curvature(3), moment(3), shear(3), slope(3)
      real(wp) :: curvature_slope(3)
      call bending_at([one_change()], md, side, [0.0_wp, 0.0_wp, 1.0_wp], curvature, curvature_slope, moment, shear, slope)
   end subroutine look

   !> Above the change the hole asks for nothing, below for the whole: moment and curvature meet half way.
   subroutine test_no_jump()
      real(wp), dimension(3) :: curvature, above, below, shear, slope
      call look(100.0_wp, 99.0_wp, curvature, above, shear, slope)
      call assertEqual(1.0e3_wp, above(1), round_off, message='moment from above')
      call assertEqual(0.5e-3_wp, curvature(1), round_off, message='curvature from above')
      call look(100.0_wp, 101.0_wp, curvature, below, shear, slope)
      call assertEqual(1.0e3_wp, below(1) + 2.0e3_wp, round_off, message='moment from below')
      call look(40.0_wp - 1.0e-3_wp, 39.0_wp, curvature, above, shear, slope)
      call assertEqual(0.0_wp, above(1), message='nothing beyond its reach')
   end subroutine test_no_jump

   !> V = -dM/ds on both sides, and dV/ds by difference (central, step 1e-3 of the length: 1e-6 of the value).
   subroutine test_shear()
      real(wp), dimension(3) :: curvature, moment, shear, slope, before, after, shear_before, shear_after, other
      real(wp), parameter :: step = 3.0e-3_wp, difference = 1.0e-6_wp
      real(wp), parameter :: places(2) = [97.5_wp, 104.0_wp]
      integer :: i
      do i = 1, size(places)
         call look(places(i), places(i), curvature, moment, shear, slope)
         call look(places(i) - step, places(i), curvature, before, shear_before, other)
         call look(places(i) + step, places(i), curvature, after, shear_after, other)
         call assertRelativelyEqual(-(after(1) - before(1))/(2.0_wp*step), shear(1), difference, message='shear')
         call assertRelativelyEqual((shear_after(1) - shear_before(1))/(2.0_wp*step), slope(1), difference, message='its slope')
      end do
   end subroutine test_shear

   !> A weightless pipe pulled at the bit through a hole that is straight and then a bend of 1e-3 /m.
   subroutine build(model, pull, clearance)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: pull        !< [N]
      real(wp), intent(in) :: clearance   !< [m]
      type(error_type), allocatable :: error
      type(component_type) :: part
      call new_trajectory(model%trajectory, [0.0_wp, 100.0_wp, 300.0_wp], [0.0_wp, 0.0_wp, 0.2_wp], [0.0_wp, 0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error), message='trajectory')
      allocate (model%holes(1), model%strings(1), model%cases(1))
      part%name = 'pipe'
      part%kind = 'drillpipe'
      part%od = 0.127_wp
      part%id = 0.1086_wp
      model%holes(1) = hole_section_type('hole', 0.0_wp, 300.0_wp, part%od + 2.0_wp*clearance, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      model%strings(1)%components = [part]
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%operation = operation_static
      model%cases(1)%bit_depth = 300.0_wp
      model%cases(1)%wob = -pull
   end subroutine build

   !> E I |dk| against 2 |T| c decides which of sqrt(E I/|T|) and sqrt(2 c/|dk|) it is.
   subroutine test_length()
      type(model_type) :: model
      type(change_type), allocatable :: changes(:)
      real(wp) :: stiffness
      call build(model, 1.0e6_wp, 0.05_wp)
      stiffness = bending_stiffness(model%strings(1)%components(1))
      call curvature_changes(model, 1, changes)
      call assertEqual(1, size(changes), message='one change')
      call assertEqual(100.0_wp, changes(1)%md, round_off, message='where')
      call assertFalse(changes(1)%forced, message='pulled hard it bends as it likes')
      call assertRelativelyEqual(sqrt(stiffness/1.0e6_wp), changes(1)%length, round_off, message='bending length')
      call assertRelativelyEqual(1.0e-3_wp*stiffness, norm2(changes(1)%moment), round_off, message='jump of moment')
      call build(model, 1.0e4_wp, 0.05_wp)
      call curvature_changes(model, 1, changes)
      call assertTrue(changes(1)%forced, message='slack it is forced by the wall')
      call assertRelativelyEqual(sqrt(2.0_wp*0.05_wp/1.0e-3_wp), changes(1)%length, round_off, message='length of the clearance')
   end subroutine test_length

   subroutine test_none()
      type(model_type) :: model
      type(change_type), allocatable :: changes(:)
      type(error_type), allocatable :: error
      call build(model, 1.0e4_wp, 0.05_wp)
      model%strings(1)%components(1)%youngs = 0.0_wp
      call curvature_changes(model, 1, changes)
      call assertEqual(0, size(changes), message='no stiffness')
      call build(model, 1.0e4_wp, 0.05_wp)
      call new_trajectory(model%trajectory, [0.0_wp, 100.0_wp, 300.0_wp], [30.0_wp, 30.0_wp, 30.0_wp]*degree, &
                          [0.0_wp, 0.0_wp, 0.0_wp], interpolation_minimum_curvature, error)
      call curvature_changes(model, 1, changes)
      call assertEqual(0, size(changes), message='no bend')
   end subroutine test_none

   subroutine test_choice()
      type(change_type) :: change
      change = one_change()
      call assertFalse(matters(change, 2.0e6_wp), message='drill pipe in a gentle bend')
      call assertTrue(matters(change, 1.0e6_wp), message='assembly')
      change%forced = .true.
      call assertTrue(matters(change, 2.0e6_wp), message='forced by the wall')
      change%forced = .false.
      change%curvature = [0.0_wp, 9.0e-3_wp, 0.0_wp]     ! 15.5 deg in 30 m
      call assertTrue(matters(change, 2.0e6_wp), message='sharp')
   end subroutine test_choice
end module dg_test_curvature_change
