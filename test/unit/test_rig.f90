!> Load of a weight indicator, against the lines and sheaves one by one, the balance of power, and published numbers.
module dg_test_rig
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_load_case, only: operation_backream, operation_count, operation_ream, operation_rotary_drilling, &
      operation_rotate_off_bottom, operation_sliding_drilling, operation_static, operation_trip_in, operation_trip_out
   use dg_rig, only: indicated_load, indicator_factor, rig_type, string_load
   implicit none
   private
   public :: rig_suite

   real(wp), parameter :: rounding = 100.0_wp*epsilon(1.0_wp)
   !> Load on the lines of the tests [N].
   real(wp), parameter :: load = 1.2e6_wp

contains

   function rig_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('rig')
      call suite%addTest(TestMethod('no_rig_shows_the_string', test_no_rig))
      call suite%addTest(TestMethod('sheave_by_sheave', test_sheave_by_sheave))
      call suite%addTest(TestMethod('power_of_the_drum', test_power))
      call suite%addTest(TestMethod('published_efficiencies', test_published))
      call suite%addTest(TestMethod('closed_forms', test_closed_forms))
      call suite%addTest(TestMethod('which_way_the_block_moves', test_motion))
      call suite%addTest(TestMethod('string_of_what_is_shown', test_inverse))
   end function rig_suite

   subroutine test_no_rig()
      integer :: operation
      do operation = 1, operation_count
         call assertEqual(731.8e3_wp, indicated_load(rig_type(), operation, 731.8e3_wp))
      end do
   end subroutine test_no_rig

   !> Tensions from the drum to the anchor: behind each of the sheaves that turn it is e times that before when raising, 1/e times
   !> when lowering. tensions(0) is the fast line, tensions(lines) the last at the block, tensions(lines + 1) the dead line.
   pure function tensions_of(rig, raising) result(tensions)
      type(rig_type), intent(in) :: rig
      logical, intent(in) :: raising
      real(wp) :: tensions(0:rig%lines + 1)
      real(wp) :: loss
      integer :: i
      loss = rig%sheave_efficiency
      if (.not. raising) loss = 1.0_wp/loss
      tensions(0) = 1.0_wp
      do i = 1, rig%lines
         tensions(i) = tensions(i - 1)*loss
      end do
      tensions(rig%lines + 1) = tensions(rig%lines)
      if (rig%active_deadline_sheave) tensions(rig%lines + 1) = tensions(rig%lines)*loss
      tensions = tensions*load/sum(tensions(1:rig%lines))      ! the block hangs on these
   end function tensions_of

   subroutine test_sheave_by_sheave()
      type(rig_type) :: rig
      real(wp) :: tensions(0:15), shown
      integer :: lines, k, active
      real(wp), parameter :: efficiencies(4) = [1.0_wp, 0.99_wp, 0.96_wp, 0.874_wp]
      rig%block_weight = 0.25_wp*load
      do lines = 1, 14
         do k = 1, size(efficiencies)
            do active = 0, 1
               rig%lines = lines
               rig%sheave_efficiency = efficiencies(k)
               rig%active_deadline_sheave = active == 1
               tensions(:lines + 1) = tensions_of(rig, raising=.true.)
               shown = indicated_load(rig, operation_trip_out, 0.75_wp*load)
               call assertRelativelyEqual(lines*tensions(lines + 1), shown, rounding, message='raising')
               tensions(:lines + 1) = tensions_of(rig, raising=.false.)
               shown = indicated_load(rig, operation_trip_in, 0.75_wp*load)
               call assertRelativelyEqual(lines*tensions(lines + 1), shown, rounding, message='lowering')
            end do
         end do
      end do
   end subroutine test_sheave_by_sheave

   !> The block rises with speed 1: the fast line runs with speed n, and the rims of the sheaves, from the drum, with n, n - 1, ...,
   !> 1. The sheave of the dead line stands. What the drum gives is what the load takes and what the sheaves lose.
   subroutine test_power()
      type(rig_type) :: rig
      real(wp) :: tensions(0:11), lost
      integer :: i
      rig%lines = 10
      rig%sheave_efficiency = 0.96_wp
      tensions = tensions_of(rig, raising=.true.)
      lost = sum([((tensions(i - 1) - tensions(i))*(rig%lines - i + 1), i=1, rig%lines)])
      call assertRelativelyEqual(tensions(0)*rig%lines, load + lost, rounding)
      call assertRelativelyEqual(rig%lines*tensions(11), indicated_load(rig, operation_trip_out, load), rounding)
   end subroutine test_power

   !> API RP 9B prints the efficiency of lines on roller bearings (K = 1.04) with three digits: load over lines times fast line.
   !> The dead line has the fast line's tension over K^n.
   subroutine test_published()
      type(rig_type) :: rig
      integer, parameter :: lines(4) = [6, 8, 10, 12]
      real(wp), parameter :: printed(4) = [0.874_wp, 0.842_wp, 0.811_wp, 0.782_wp], k = 1.04_wp, last_digit = 0.0005_wp/0.782_wp
      integer :: i
      rig%sheave_efficiency = 1.0_wp/k
      do i = 1, size(lines)
         rig%lines = lines(i)
         call assertRelativelyEqual(1.0_wp/(k**lines(i)*printed(i)), indicator_factor(rig, operation_trip_out), last_digit)
      end do
   end subroutine test_published

   !> Sums of the geometric series, as they are usually printed.
   subroutine test_closed_forms()
      type(rig_type) :: rig
      real(wp), parameter :: e = 0.96_wp
      integer, parameter :: n = 12
      rig%lines = n
      rig%sheave_efficiency = e
      call assertRelativelyEqual(n*e**(n - 1)*(1.0_wp - e)/(1.0_wp - e**n), indicator_factor(rig, operation_trip_out), rounding)
      call assertRelativelyEqual(n*(1.0_wp - e)/(1.0_wp - e**n), indicator_factor(rig, operation_trip_in), rounding)
      rig%active_deadline_sheave = .true.
      call assertRelativelyEqual(n*e**n*(1.0_wp - e)/(1.0_wp - e**n), indicator_factor(rig, operation_trip_out), rounding)
      call assertRelativelyEqual(n*(1.0_wp - e)/(e*(1.0_wp - e**n)), indicator_factor(rig, operation_trip_in), rounding)
   end subroutine test_closed_forms

   subroutine test_motion()
      type(rig_type) :: rig
      rig%lines = 8
      rig%sheave_efficiency = 0.97_wp
      call assertEqual(1.0_wp, indicator_factor(rig, operation_static))
      call assertEqual(1.0_wp, indicator_factor(rig, operation_rotate_off_bottom))
      call assertTrue(indicator_factor(rig, operation_trip_out) < 1.0_wp)
      call assertEqual(indicator_factor(rig, operation_trip_out), indicator_factor(rig, operation_backream))
      call assertTrue(all(indicator_factor(rig, [operation_trip_in, operation_sliding_drilling, operation_rotary_drilling, &
                                                 operation_ream]) > 1.0_wp))
   end subroutine test_motion

   subroutine test_inverse()
      type(rig_type) :: rig
      integer :: operation
      rig = rig_type(given=.true., block_weight=180.0e3_wp, lines=12, sheave_efficiency=0.98_wp, active_deadline_sheave=.true.)
      do operation = 1, operation_count
         call assertRelativelyEqual(load, string_load(rig, operation, indicated_load(rig, operation, load)), rounding)
      end do
   end subroutine test_inverse
end module dg_test_rig
