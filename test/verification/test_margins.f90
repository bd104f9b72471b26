!> A string without friction that is pulled at the bit by its overpull margin is solved anew: its least safety factor is one.
module dg_test_margins
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, &
                    TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_job, only: model_mcge, model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: new_well, note, part
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: margins_suite

   real(wp), parameter :: depth = 1500.0_wp, hole = 0.2159_wp, yield = 724.0e6_wp
   !> Safety factor that is left, less one. Seen: 0.3 %, with joints one by one 1.2 %; soft string round-off.
   real(wp), parameter :: within = 0.03_wp, soft_within = 1.0e-6_wp
   !> Stress by joints that touch all along the pipe over that by joints one by one, less one. Seen: 0.6 %.
   real(wp), parameter :: joints_within = 0.015_wp

contains

   function margins_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('margins')
      call suite%addTest(TestMethod('bends_of_6_to_20_degrees', test_bends))
      call suite%addTest(TestMethod('built_and_dropped', test_dropped))
      call suite%addTest(TestMethod('turning_from_station_to_station', test_stations))
      call suite%addTest(TestMethod('joints_one_by_one', test_joints))
      call suite%addTest(TestMethod('joints_along_the_pipe', test_smeared))
      call suite%addTest(TestMethod('pushed_before', test_pushed))
      call suite%addTest(TestMethod('soft_string', test_soft))
   end function margins_suite

   subroutine build(model, md, inclination, azimuth)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: md(:), inclination(:), azimuth(:)   !< [m, deg, deg]
      type(component_type) :: component
      component = part('drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 31.9_wp, 0.1619_wp)
      component%yield = yield
      component%joint_length = 0.02_wp      ! the closed form of the bending between joints has points
      call new_well(model, md, inclination, azimuth, hole, 0.0_wp, component)
      model%numerics = settings_of('auto')
      model%mud = standing_mud(1200.0_wp)
      model%boundary%bit_centred = .true.
      model%boundary%top_centred = .true.
   end subroutine build

   !> Solves the string under a weight on bit, and finds its limits.
   subroutine find_limits(model, number, wob, whole, stress)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: number     !< of the model
      real(wp), intent(in) :: wob       !< [N]
      type(whole_string_type), intent(out) :: whole
      real(wp), intent(out), optional :: stress   !< largest von Mises stress next to joints or between them [Pa]
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = wob
      if (number == model_soft) then
         call solve_soft_string(model, 1, result, error)
      else
         call solve_static_analysis(model, 1, result, error)
      end if
      call assertFalse(allocated(error), message='error')
      call assertEqual(result_converged, result%status, message='converged')
      result%case_index = 1
      result%model = number
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      if (present(stress)) stress = maxval(along%jointed_von_mises)
      call assertLessThan(abs(1.0_wp - 1.0_wp/whole%least_safety%value - whole%least_envelope_margin%value), soft_within, &
                          message='the envelope holds the same stress')
   end subroutine find_limits

   !> Pulls by the margin that a weight on bit leaves, and looks at the safety factor.
   subroutine pull(model, number, wob, within, what)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: number
      real(wp), intent(in) :: wob, within   !< [N, -]
      character(*), intent(in) :: what
      type(whole_string_type) :: before, after
      call find_limits(model, number, wob, before)
      call assertTrue(before%overpull_margin%present, message=what)
      call assertGreaterThan(before%overpull_margin%value, 0.0_wp, message=what)
      call find_limits(model, number, wob - before%overpull_margin%value, after)
      call note(what//': safety factor left, less one', after%least_safety%value - 1.0_wp)
      call assertEqual(1.0_wp, after%least_safety%value, within, message=what)
      call assertLessThan(abs(after%overpull_margin%value), within*before%overpull_margin%value, message=what//', nothing left')
   end subroutine pull

   subroutine test_bends()
      type(model_type) :: model
      real(wp), parameter :: rates(4) = [6.0_wp, 10.0_wp, 12.0_wp, 20.0_wp]      ! deg/30 m
      integer :: i
      do i = 1, size(rates)
         call build(model, [0.0_wp, 500.0_wp, 500.0_wp + 1800.0_wp/rates(i), depth], [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp], &
                    spread(0.0_wp, 1, 4))
         call pull(model, model_mcge, 0.0_wp, within, 'bend')
      end do
   end subroutine test_bends

   subroutine test_dropped()
      type(model_type) :: model
      call build(model, [0.0_wp, 300.0_wp, 480.0_wp, 800.0_wp, 980.0_wp, depth], &
                 [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp, 0.0_wp, 0.0_wp], spread(0.0_wp, 1, 6))
      call pull(model, model_mcge, 0.0_wp, within, 'built and dropped at 10 deg/30 m')
   end subroutine test_dropped

   !> Stations every 30 m between which the hole bends to and fro by some degrees.
   subroutine test_stations()
      type(model_type) :: model
      integer :: i
      call build(model, [0.0_wp, (300.0_wp + 30.0_wp*i, i=0, 40)], &
                 [0.0_wp, (min(2.0_wp*i, 60.0_wp) + 2.0_wp*(1.0_wp + sin(2.2_wp*i)), i=0, 40)], &
                 [0.0_wp, (40.0_wp + 4.0_wp*sin(1.7_wp*i), i=0, 40)])
      call pull(model, model_mcge, 0.0_wp, within, 'stations')
   end subroutine test_stations

   subroutine test_joints()
      type(model_type) :: model
      call build(model, [0.0_wp, 500.0_wp, 680.0_wp, depth], [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp], spread(0.0_wp, 1, 4))
      model%numerics%discrete_joints = .true.
      call pull(model, model_mcge, 0.0_wp, within, 'joints one by one')
   end subroutine test_joints

   !> Joints that touch all along the pipe give the stress that joints one by one do, in bends where its body touches, too.
   subroutine test_smeared()
      type(model_type) :: model
      type(whole_string_type) :: whole
      real(wp) :: smeared, jointed
      real(wp), parameter :: rates(3) = [2.0_wp, 6.0_wp, 10.0_wp]      ! deg/30 m
      integer :: i
      do i = 1, size(rates)
         call build(model, [0.0_wp, 300.0_wp, 300.0_wp + 1200.0_wp/rates(i), depth], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], &
                    spread(0.0_wp, 1, 4))
         call find_limits(model, model_mcge, -400.0e3_wp, whole, smeared)
         model%numerics%discrete_joints = .true.
         call find_limits(model, model_mcge, -400.0e3_wp, whole, jointed)
         call note('stress over that of joints one by one', smeared/jointed)
         call assertRelativelyEqual(jointed, smeared, joints_within, message='von Mises stress')
      end do
   end subroutine test_smeared

   subroutine test_pushed()
      type(model_type) :: model
      call build(model, [0.0_wp, 500.0_wp, 680.0_wp, depth], [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp], spread(0.0_wp, 1, 4))
      call pull(model, model_mcge, 100.0e3_wp, within, 'pushed')
   end subroutine test_pushed

   !> A soft string's moment is EI times the hole's curvature under any pull.
   subroutine test_soft()
      type(model_type) :: model
      call build(model, [0.0_wp, 500.0_wp, 680.0_wp, depth], [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp], spread(0.0_wp, 1, 4))
      call pull(model, model_soft, 0.0_wp, soft_within, 'soft')
   end subroutine test_soft
end module dg_test_margins
