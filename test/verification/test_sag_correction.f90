!> Sag correction of a survey sensor: a span between equal stabilizers on the low side of a straight inclined hole is a beam that is
!> held level at both ends under its own weight.
module dg_test_sag_correction
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: bending_stiffness
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: steel
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: sag_correction_suite

   integer, parameter :: spans = 8, middle = 4      !< of the assembly, and the one with the sensor, from the bit
   real(wp), parameter :: span = 14.0_wp, blade = 0.05_wp, od = 0.1651_wp, id = 0.0714_wp, hole = 0.2159_wp, clearance = 0.001_wp
   real(wp), parameter :: shallow = 300.0_wp, deep = 5000.0_wp, inclination = 60.0_wp*degree
   real(wp), parameter :: close = 0.02_wp           !< axial force is zero in the middle of the span alone, blades have a length

contains

   function sag_correction_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('sag_correction')
      call suite%addTest(TestMethod('span_of_a_beam', test_span))
      call suite%addTest(TestMethod('deep_string', test_deep))
      call suite%addTest(TestMethod('none_without_sensor', test_none))
   end function sag_correction_suite

   !> A string of collars between short stabilizers, with a sensor at a part of the middle span; < 0: without one.
   subroutine build(model, part, depth)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: part         !< of the span, from its lower end [-]
      real(wp), intent(in) :: depth        !< of the bit [m]
      type(error_type), allocatable :: error
      real(wp) :: weight
      integer :: i
      call new_trajectory(model%trajectory, [0.0_wp, depth], [inclination, inclination], [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depth, hole, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(2*spans + 1))
      do i = 1, spans
         model%strings(1)%components(2*i - 1) = steel('collar', span - blade, od, id)
         model%strings(1)%components(2*i) = steel('stabilizer', blade, od, id)
         model%strings(1)%components(2*i)%joint_od = hole - 2.0_wp*clearance
      end do
      model%strings(1)%components(2*spans + 1) = steel('collar', 0.0_wp, od, id)
      if (part >= 0.0_wp) model%strings(1)%components(2*middle - 1)%sensor = part*span - 0.5_wp*blade
      model%mud = standing_mud(0.0_wp)
      weight = model%strings(1)%components(1)%mass*model%gravity
      model%numerics%moments = .true.
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = weight*cos(inclination)*span*(real(middle, wp) - 0.5_wp)      ! no axial force in the middle span
   end subroutine build

   !> Deflection w x^2 (L - x)^2/(24 E I): the slope is w x (L - x) (L - 2 x)/(12 E I). In the lower half of the span the string
   !> points higher than the hole, so that the sensor reads too much.
   subroutine test_span()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      real(wp), parameter :: parts(2) = [0.25_wp, 0.75_wp]
      real(wp) :: across, slope
      integer :: i
      do i = 1, size(parts)
         call build(model, parts(i), shallow)
         call solve_static_analysis(model, 1, result, error)
         call assertEqual(result_converged, result%status)
         call assertEqual(shallow - span*(real(middle - 1, wp) + parts(i)) + 0.5_wp*blade, result%sensor_md, 1.0e-9_wp)
         across = model%strings(1)%components(1)%mass*model%gravity*sin(inclination)
         slope = across*span**3/(128.0_wp*bending_stiffness(model%strings(1)%components(1)))
         call assertRelativelyEqual(merge(-slope, slope, parts(i) < 0.5_wp), result%sag_correction, close)
      end do
   end subroutine test_span

   !> A string that has stretched by a metre: the sensor has come down with it, and the sag is the same.
   subroutine test_deep()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      real(wp), parameter :: part = 0.25_wp
      real(wp) :: across, slope
      call build(model, part, deep)
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_converged, result%status)
      across = model%strings(1)%components(1)%mass*model%gravity*sin(inclination)
      slope = across*span**3/(128.0_wp*bending_stiffness(model%strings(1)%components(1)))
      call assertRelativelyEqual(-slope, result%sag_correction, close)
   end subroutine test_deep

   subroutine test_none()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call build(model, -1.0_wp, shallow)
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_converged, result%status)
      call assertTrue(is_missing(result%sag_correction))
   end subroutine test_none
end module dg_test_sag_correction
