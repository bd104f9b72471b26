!> Curves as pictures show them: points left out move no line, strays are few.
module dg_test_depth_curve
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_depth_curve, only: bands_of, kept_points, least_around, lone_angles
   use dg_missing, only: is_missing, missing
   implicit none
   private
   public :: depth_curve_suite

contains

   function depth_curve_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('depth_curve')
      call suite%addTest(TestMethod('points_kept', test_points))
      call suite%addTest(TestMethod('gaps_and_jumps', test_gaps))
      call suite%addTest(TestMethod('least_and_bands', test_least))
      call suite%addTest(TestMethod('strays', test_strays))
   end function depth_curve_suite

   !> Straight lines between the points kept are within the tolerance of all, few are kept, peaks are.
   subroutine test_points()
      integer, parameter :: n = 2001
      real(wp), parameter :: tolerance = 1.0e-3_wp
      real(wp) :: depth(n), values(n), line
      logical :: kept(n)
      integer :: i, above, below
      depth = [(real(i, wp), i=0, n - 1)]
      values = sin(depth/150.0_wp)
      values(1000) = 3.0_wp
      kept = kept_points(depth, values, tolerance)
      call assertTrue(kept(1) .and. kept(1000) .and. kept(n), message='ends and peak')
      call assertTrue(count(kept) < n/10, message='few')
      above = 1
      do i = 2, n
         if (kept(i)) above = i
         if (kept(i)) cycle
         below = i + findloc(kept(i + 1:), .true., dim=1)
         line = values(above) + (values(below) - values(above))*(depth(i) - depth(above))/(depth(below) - depth(above))
         call assertEqual(values(i), line, 1.001_wp*tolerance)
      end do
      call assertEqual(2, count(kept_points(depth, 2.0_wp*depth, tolerance)), message='a straight line')
   end subroutine test_points

   subroutine test_gaps()
      real(wp), parameter :: depth(6) = [0.0_wp, 1.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp]
      call assertTrue(all(kept_points(depth, [0.0_wp, 0.0_wp, 5.0_wp, 5.0_wp, 5.0_wp, 5.0_wp], 0.1_wp) .eqv. &
                          [.true., .true., .true., .false., .false., .true.]), message='a jump')
      call assertTrue(all(kept_points(depth, [0.0_wp, 0.0_wp, 0.0_wp, missing, 0.0_wp, 0.0_wp], 0.1_wp) .eqv. &
                          [.true., .false., .true., .true., .true., .true.]), message='a gap')
   end subroutine test_gaps

   subroutine test_least()
      real(wp), parameter :: depth(5) = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp]
      real(wp) :: found(5), least(2), mean(2), greatest(2)
      found = least_around(depth, [5.0_wp, 1.0_wp, 7.0_wp, missing, missing], 2.0_wp)
      call assertEqual([1.0_wp, 1.0_wp, 1.0_wp, 7.0_wp], found(:4))
      call assertTrue(is_missing(found(5)), message='none near')
      call bands_of(depth, [0.0_wp, 2.0_wp, 0.0_wp, 4.0_wp, 6.0_wp], least, mean, greatest)
      call assertEqual([0.0_wp, 0.0_wp], least)
      call assertEqual([2.0_wp, 6.0_wp], greatest)
      call assertEqual([1.0_wp, 8.0_wp/3.0_wp], mean, 1.0e-12_wp)
   end subroutine test_least

   !> One row of a hundred that lies elsewhere is a stray; rows that all lie elsewhere are none.
   subroutine test_strays()
      real(wp) :: angle(100)
      logical :: touches(100)
      integer :: i
      angle = pi
      touches = .true.
      angle(1) = 0.5_wp*pi
      call assertEqual(1, count(lone_angles(angle, touches)))
      touches(2) = .false.
      touches(4) = .false.
      angle(3) = 0.1_wp
      call assertFalse(any(lone_angles(angle(2:), touches(2:))), message='a stabilizer that touches alone')
      angle = [(1.5_wp*i, i=1, 100)]
      touches = .true.
      call assertFalse(any(lone_angles(angle, touches)))
   end subroutine test_strays
end module dg_test_depth_curve
