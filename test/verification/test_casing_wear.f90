!> Wear of casing: the crescent against an integral, the way from side force to groove against a closed form, and a published
!> example. Ghalambor & Guo (2005), Directional drilling, slide 110: 9 5/8 in casing of 53.5 lb/ft, P110, bursts at 10,900 psi; with
!> 10 % of its wall worn off at 9,810 psi. API Bulletin 5C2 has 7,950 psi for its collapse.
module dg_test_casing_wear
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_casing_wear, only: crescent_area, find_casing_wear, groove_depth, groove_type, worst_groove
   use dg_component, only: tube_area
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge, model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_trip_out
   use dg_model, only: model_type
   use dg_solve_case, only: solve_case
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: casing_wear_suite

   real(wp), parameter :: inch = 0.0254_wp, psi = 6894.757293168_wp
   real(wp), parameter :: casing_od = 9.625_wp*inch, casing_id = 8.535_wp*inch, joint_od = 6.5_wp*inch
   real(wp), parameter :: wall = 0.5_wp*(casing_od - casing_id)
   real(wp), parameter :: shoe = 800.0_wp, depth = 1000.0_wp, friction = 0.2_wp, inclination = 30.0_wp*degree

contains

   function casing_wear_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('casing_wear')
      call suite%addTest(TestMethod('crescent', test_crescent))
      call suite%addTest(TestMethod('depth_of_a_volume', test_depth))
      call suite%addTest(TestMethod('straight_hole', test_straight))
      call suite%addTest(TestMethod('published_strength', test_published))
      call suite%addTest(TestMethod('not_without_rotation', test_still))
   end function casing_wear_suite

   !> The joint's circle outside the bore, by strips across the groove.
   subroutine test_crescent()
      integer, parameter :: strips = 200000
      real(wp), parameter :: depths(4) = [1.0e-6_wp, 1.0e-3_wp, 8.0e-3_wp, wall]
      real(wp) :: r, bore, apart, across, half_chord, area
      integer :: i, k
      r = 0.5_wp*joint_od
      bore = 0.5_wp*casing_id
      do i = 1, size(depths)
         apart = bore - r + depths(i)
         half_chord = sqrt(bore**2 - ((bore**2 - r**2 + apart**2)/(2.0_wp*apart))**2)
         area = 0.0_wp
         do k = 1, strips
            across = half_chord*(k - 0.5_wp)/strips
            area = area + 2.0_wp*half_chord/strips*(apart + sqrt(r**2 - across**2) - sqrt(bore**2 - across**2))
         end do
         call assertRelativelyEqual(area, crescent_area(depths(i), bore, r), merge(1.0e-4_wp, 1.0e-7_wp, i == 1))
      end do
   end subroutine test_crescent

   subroutine test_depth()
      real(wp), parameter :: bore = 0.5_wp*casing_id, r = 0.5_wp*joint_od
      real(wp), parameter :: depths(3) = [1.0e-5_wp, 2.0e-3_wp, 0.9_wp*wall]
      integer :: i
      do i = 1, size(depths)
         call assertEqual(depths(i), groove_depth(crescent_area(depths(i), bore, r), bore, r, wall), 2.0e-9_wp*wall)
      end do
      call assertEqual(wall, groove_depth(1.0_wp, bore, r, wall), 0.0_wp)
      call assertEqual(0.0_wp, groove_depth(0.0_wp, bore, r, wall), 0.0_wp)
   end subroutine test_depth

   !> A straight hole of casing above open hole, a string that turns in it for some hours.
   subroutine solve(method, operation, factor, model, grooves)
      integer, intent(in) :: method, operation
      real(wp), intent(in) :: factor       !< [1/Pa]
      type(model_type), intent(out) :: model
      type(groove_type), allocatable, intent(out) :: grooves(:)
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, depth], [inclination, inclination], [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(2), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('casing', 0.0_wp, shoe, casing_id, friction, friction)
      model%holes(1)%casing_od = casing_od
      model%holes(1)%casing_yield = 110.0e3_wp*psi
      model%holes(1)%wear_factor = factor
      model%holes(2) = hole_section_type('hole', shoe, depth, casing_id, 0.3_wp, 0.3_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      associate (pipe => model%strings(1)%components(1))
         pipe%name = 'pipe'
         pipe%kind = 'drillpipe'
         pipe%od = 5.0_wp*inch
         pipe%id = 4.276_wp*inch
         pipe%joint_od = joint_od
         pipe%mass = pipe%density*tube_area(pipe%od, pipe%id)
      end associate
      model%mud = standing_mud(0.0_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation
      model%cases(1)%angular_speed = 12.0_wp
      model%cases(1)%hours = 50.0_wp
      call solve_case(model, method, 1, result, error)
      call assertFalse(allocated(error))
      call assertEqual(result_converged, result%status)
      call find_casing_wear(model, result, grooves)
   end subroutine solve

   !> Side force w sin(inclination): every place of the casing is worn alike, by that times the factor and the way, omega r t.
   !> Beams climb the wall, so that friction carries a part of the weight.
   subroutine test_straight()
      type(model_type) :: model
      type(groove_type), allocatable :: grooves(:)
      real(wp) :: volume
      integer :: i
      call solve(model_soft, operation_rotate_off_bottom, 2.0e-13_wp, model, grooves)
      volume = 2.0e-13_wp*12.0_wp*50.0_wp*3600.0_wp*0.5_wp*joint_od*model%strings(1)%components(1)%mass*model%gravity* &
               sin(inclination)
      call assertTrue(size(grooves) > 1)
      do i = 1, size(grooves)
         call assertRelativelyEqual(volume, grooves(i)%volume, 1.0e-9_wp)
         call assertRelativelyEqual(volume, crescent_area(grooves(i)%depth, 0.5_wp*casing_id, 0.5_wp*joint_od), 1.0e-7_wp)
      end do
      call assertTrue(maxval(grooves%md) <= shoe)
      call solve(model_mcge, operation_rotate_off_bottom, 2.0e-13_wp, model, grooves)
      i = minloc(abs(grooves%md - 0.5_wp*shoe), dim=1)
      call assertRelativelyEqual(volume/sqrt(1.0_wp + friction**2), grooves(i)%volume, 1.0e-3_wp)
   end subroutine test_straight

   !> A factor for a tenth of the wall.
   subroutine test_published()
      type(model_type) :: model
      type(groove_type), allocatable :: grooves(:)
      type(groove_type) :: groove
      real(wp) :: factor
      call solve(model_soft, operation_rotate_off_bottom, 1.0e-18_wp, model, grooves)
      groove = worst_groove(grooves)
      call assertEqual(10900.0_wp, groove%burst/psi, 10.0_wp)         ! rounded to 10 psi
      call assertEqual(7950.0_wp, groove%collapse/psi, 10.0_wp)
      factor = 1.0e-18_wp*crescent_area(0.1_wp*wall, 0.5_wp*casing_id, 0.5_wp*joint_od)/groove%volume
      call solve(model_soft, operation_rotate_off_bottom, factor, model, grooves)
      groove = worst_groove(grooves)
      call assertRelativelyEqual(0.9_wp, groove%wall_left, 1.0e-6_wp)
      call assertEqual(9810.0_wp, groove%burst/psi, 10.0_wp)
      call assertTrue(groove%collapse < 7000.0_wp*psi)
   end subroutine test_published

   subroutine test_still()
      type(model_type) :: model
      type(groove_type), allocatable :: grooves(:)
      type(groove_type) :: none
      call solve(model_soft, operation_trip_out, 2.0e-13_wp, model, grooves)
      call assertEqual(0, size(grooves))
      none = worst_groove(grooves)
      call assertFalse(none%present)
   end subroutine test_still
end module dg_test_casing_wear
