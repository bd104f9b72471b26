!> Intervals of a calibration hold what made the measurements in 95 % of campaigns: simulated with the soft string, whose hook loads
!> and torques have errors of their own.
module dg_test_calibration_coverage
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_calibration_result, only: calibration_result_type, judge_fit
   use dg_component, only: component_type
   use dg_constants, only: degree
   use dg_counter_random, only: normal_number
   use dg_error, only: error_type
   use dg_fit_by_kinds, only: fit_by_kinds
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_least_squares, only: fit_done, measured_function_type, unknowns_type
   use dg_load_case, only: operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_soft_string_loads, only: soft_string_at
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_variance_components, only: estimate_factors
   implicit none
   private
   public :: calibration_coverage_suite

   integer, parameter :: hookload = 1, torque = 2, campaigns = 1500
   !> Of a share of 0.95 among 1500 the standard error is 0.6 %.
   real(wp), parameter :: least_share = 0.90_wp, greatest_share = 0.98_wp
   real(wp), parameter :: friction = 0.25_wp, offset = 20.0e3_wp
   !> Of friction in the table, up to 1.
   integer, parameter :: steps = 50
   real(wp), parameter :: step = 1.0_wp/steps
   real(wp), parameter :: depths(4) = [1500.0_wp, 2000.0_wp, 2500.0_wp, 3000.0_wp]

   !> Simulated measurements of a rig: values of load cases of the soft string, hook loads with an offset. The soft string is solved
   !> for frictions in steps, between which a cubic goes: campaigns and fits take the same.
   type, extends(measured_function_type) :: campaign_type
      type(model_type) :: model
      integer, allocatable :: what(:)       !< hookload or torque, one a load case
      logical :: with_offset = .false.
      real(wp), allocatable :: table(:, :)  !< (load cases, steps of friction from 0)
   contains
      procedure :: evaluate
   end type campaign_type

contains

   function calibration_coverage_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('calibration_coverage')
      call suite%addTest(TestMethod('hook_loads_alone', test_hookloads))
      call suite%addTest(TestMethod('torques_alone', test_torques))
      call suite%addTest(TestMethod('both', test_both))
      call suite%addTest(TestMethod('both_with_an_offset', test_offset))
      call suite%addTest(TestMethod('one_deviation_known', test_one_known))
      call suite%addTest(TestMethod('variances_by_hand', test_by_hand))
   end function calibration_coverage_suite

   subroutine evaluate(self, points, values, solved)
      class(campaign_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      real(wp) :: x
      integer :: p, k
      solved = .true.
      do p = 1, size(points, 2)
         k = min(max(int(points(1, p)/step), 1), steps - 2)
         x = points(1, p)/step - k      ! Lagrange's cubic through x = -1, 0, 1, 2
         values(:, p) = -x*(x - 1.0_wp)*(x - 2.0_wp)/6.0_wp*self%table(:, k - 1) &
                        + (x + 1.0_wp)*(x - 1.0_wp)*(x - 2.0_wp)/2.0_wp*self%table(:, k) &
                        - (x + 1.0_wp)*x*(x - 2.0_wp)/2.0_wp*self%table(:, k + 1) &
                        + (x + 1.0_wp)*x*(x - 1.0_wp)/6.0_wp*self%table(:, k + 2)
         if (self%with_offset) where (self%what == hookload) values(:, p) = values(:, p) + points(2, p)
      end do
   end subroutine evaluate

   !> The soft string for each step of friction.
   subroutine fill_table(campaign)
      type(campaign_type), intent(inout) :: campaign
      real(wp) :: axial(1), torques(1)
      integer :: i, k
      allocate (campaign%table(size(campaign%what), 0:steps))
      do k = 0, steps
         campaign%model%holes%friction_axial = k*step
         campaign%model%holes%friction_rotary = k*step
         do i = 1, size(campaign%what)
            call soft_string_at(campaign%model, i, [0.0_wp], axial, torques)
            campaign%table(i, k) = merge(axial(1), torques(1), campaign%what(i) == hookload)
         end do
      end do
   end subroutine fill_table

   !> Up and down at each of the first depths, rotating at each of the last, in a well that builds to 60 deg.
   subroutine new_campaign(campaign, hookloads, torques, with_offset)
      type(campaign_type), intent(out) :: campaign
      integer, intent(in) :: hookloads, torques    !< depths
      logical, intent(in) :: with_offset
      type(error_type), allocatable :: error
      integer :: i
      campaign%with_offset = with_offset
      associate (model => campaign%model)
         call new_trajectory(model%trajectory, [0.0_wp, 600.0_wp, 1200.0_wp, 3000.0_wp], &
                             [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp]*degree, spread(0.0_wp, 1, 4), &
                             interpolation_minimum_curvature, error)
         call assertFalse(allocated(error), message='trajectory')
         allocate (model%holes(1), model%strings(1), model%cases(2*hookloads + torques))
         model%holes(1) = hole_section_type('hole', 0.0_wp, 3000.0_wp, 0.2159_wp, friction, friction)
         model%strings(1)%name = 'main'
         allocate (model%strings(1)%components(1))
         model%strings(1)%components(1) = component_type(name='pipe', kind='drillpipe', od=0.127_wp, id=0.1086_wp, &
                                                             mass=31.9_wp)
         model%mud = standing_mud(1200.0_wp)
         do i = 1, size(model%cases)
            model%cases(i)%name = 'case'
            model%cases(i)%section = ''
            model%cases(i)%string = 'main'
            if (i > 2*hookloads) then
               model%cases(i)%operation = operation_rotate_off_bottom
               model%cases(i)%bit_depth = depths(size(depths) - torques + i - 2*hookloads)
            else
               model%cases(i)%operation = merge(operation_trip_out, operation_trip_in, modulo(i, 2) == 1)
               model%cases(i)%bit_depth = depths((i + 1)/2)
            end if
         end do
      end associate
      campaign%what = [spread(hookload, 1, 2*hookloads), spread(torque, 1, torques)]
      call fill_table(campaign)
   end subroutine new_campaign

   !> Simulates campaigns whose readings err by `noise`, and looks how many intervals hold the friction and the offset. `known`:
   !> kinds whose noise the fit is told.
   subroutine simulate(campaign, noise, known, seed, what, width)
      type(campaign_type), intent(inout) :: campaign
      real(wp), intent(in) :: noise(2)              !< of hook loads [N] and torques [N.m]
      logical, intent(in) :: known(2)
      integer, intent(in) :: seed
      character(*), intent(in) :: what
      real(wp), intent(out), optional :: width(:)   !< mean half width of the intervals
      type(calibration_result_type) :: result
      real(wp), dimension(size(campaign%what)) :: exact, measured, deviation, depth
      integer :: group(size(campaign%what))
      real(wp), allocatable :: values(:, :), truth(:), scale(:), widths(:), shares(:)
      logical, allocatable :: solved(:, :)
      integer :: kinds(size(exact)), set, k
      truth = [friction]
      scale = [1.0_wp]
      if (campaign%with_offset) then
         truth = [truth, offset]
         scale = [scale, 1.0e6_wp]
      end if
      allocate (values(size(exact), 1), solved(size(exact), 1))
      call campaign%evaluate(reshape(truth, [size(truth), 1]), values, solved)
      exact = values(:, 1)
      depth = campaign%model%cases%bit_depth
      group = 2*campaign%model%cases%operation + campaign%what
      kinds = campaign%what - minval(campaign%what) + 1
      if (known(hookload)) kinds = max(campaign%what - 1, 0)
      allocate (widths(size(truth)), shares(size(truth)), source=0.0_wp)
      do set = 1, campaigns
         measured = exact + noise(campaign%what)*normal_number(seed, set, 1, [(k, k=1, size(exact))])
         do k = hookload, torque
            if (any(campaign%what == k)) where (campaign%what == k) deviation = 0.02_wp*sum(exact, mask=campaign%what == k)/ &
               count(campaign%what == k)
            if (known(k)) where (campaign%what == k) deviation = noise(k)
         end do
         call fit_by_kinds(campaign, unknowns_type(truth*[0.8_wp, (0.0_wp, k=2, size(truth))], &
                                                   spread(.true., 1, size(truth)), &
                                                   merge(0.0_wp, -1.0_wp, scale <= 1.0_wp)*scale, scale, scale), &
                           measured, kinds, deviation, result%fit, result%halvings)
         call assertEqual(fit_done, result%fit%status, message=what)
         call judge_fit(result, measured, deviation, kinds, campaign%what, depth, group)
         call assertFalse(any(is_missing(result%statistics%half_width)), message=what//': has intervals')
         where (abs(result%fit%unknowns - truth) <= result%statistics%half_width) shares = shares + 1.0_wp/campaigns
         widths = widths + result%statistics%half_width/campaigns
      end do
      do k = 1, size(truth)
         call assertGreaterThan(shares(k), least_share, message=what)
         call assertLessThan(shares(k), greatest_share, message=what)
      end do
      if (present(width)) width = widths
   end subroutine simulate

   subroutine test_hookloads()
      type(campaign_type) :: campaign
      call new_campaign(campaign, 3, 0, .false.)
      call simulate(campaign, [10.0e3_wp, 0.0_wp], [.false., .false.], 1, 'hook loads')
      call new_campaign(campaign, 2, 0, .true.)
      call simulate(campaign, [10.0e3_wp, 0.0_wp], [.false., .false.], 2, 'hook loads with an offset')
   end subroutine test_hookloads

   subroutine test_torques()
      type(campaign_type) :: campaign
      call new_campaign(campaign, 0, 3, .false.)
      call simulate(campaign, [0.0_wp, 0.5e3_wp], [.false., .false.], 3, 'torques')
   end subroutine test_torques

   !> Torques that say as much as hook loads, hardly anything, and nearly all; few of them.
   subroutine test_both()
      type(campaign_type) :: campaign
      call new_campaign(campaign, 4, 4, .false.)
      call simulate(campaign, [10.0e3_wp, 0.5e3_wp], [.false., .false.], 4, 'both')
      call simulate(campaign, [10.0e3_wp, 3.0e3_wp], [.false., .false.], 5, 'both, torques scatter')
      call simulate(campaign, [30.0e3_wp, 0.1e3_wp], [.false., .false.], 6, 'both, hook loads scatter')
      call new_campaign(campaign, 2, 2, .false.)
      call simulate(campaign, [10.0e3_wp, 0.5e3_wp], [.false., .false.], 7, 'both, four and two')
   end subroutine test_both

   !> The offset is told by hook loads alone: torques that scatter do not widen its interval.
   subroutine test_offset()
      type(campaign_type) :: campaign
      real(wp) :: width(2), alone(2)
      call new_campaign(campaign, 4, 4, .true.)
      call simulate(campaign, [10.0e3_wp, 0.5e3_wp], [.false., .false.], 8, 'both with an offset')
      call simulate(campaign, [10.0e3_wp, 3.0e3_wp], [.false., .false.], 9, 'offset, torques scatter', width)
      call new_campaign(campaign, 4, 0, .true.)
      call simulate(campaign, [10.0e3_wp, 0.0_wp], [.false., .false.], 9, 'offset, hook loads alone', alone)
      call assertLessThan(width(2), 1.1_wp*alone(2), message='offset')
   end subroutine test_offset

   subroutine test_one_known()
      type(campaign_type) :: campaign
      call new_campaign(campaign, 3, 3, .false.)
      call simulate(campaign, [10.0e3_wp, 1.0e3_wp], [.true., .false.], 10, 'hook loads known')
   end subroutine test_one_known

   !> Two kinds with a mean each: variances 2/1 and 8/2, factors their roots; the same where the first is known.
   subroutine test_by_hand()
      real(wp), parameter :: residual(5) = [1.0_wp, -1.0_wp, 2.0_wp, -2.0_wp, 0.0_wp]
      real(wp) :: jacobian(5, 2), factors(2)
      jacobian = 0.0_wp
      jacobian(1:2, 1) = 1.0_wp
      jacobian(3:5, 2) = 1.0_wp
      call estimate_factors(jacobian, residual, [1, 1, 2, 2, 2], factors)
      call assertRelativelyEqual(sqrt(2.0_wp), factors(1), 1.0e-7_wp)
      call assertRelativelyEqual(2.0_wp, factors(2), 1.0e-7_wp)
      call estimate_factors(jacobian, residual, [0, 0, 1, 1, 1], factors(1:1))
      call assertRelativelyEqual(2.0_wp, factors(1), 1.0e-7_wp)
   end subroutine test_by_hand
end module dg_test_calibration_coverage
