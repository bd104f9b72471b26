!> The foot of a point on the hole axis: on arcs, across stations, at kinks.
module dg_test_closest_point
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_arc, only: frame_on_arc, point_on_arc
   use dg_kinds, only: wp
   use dg_test_trajectory, only: path, winding, rounding
   use dg_trajectory, only: closest_point, position_at, trajectory_type
   implicit none
   private
   public :: closest_point_suite

contains

   function closest_point_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('closest_point')
      call suite%addTest(TestMethod('foot', test_closest_point))
      call suite%addTest(TestMethod('walks', test_closest_point_walks))
      call suite%addTest(TestMethod('at_kinks', test_closest_point_at_kinks))
   end function closest_point_suite

   !> Against a point made from a known foot, and against search.
   subroutine test_closest_point()
      type(trajectory_type) :: trajectory
      real(wp), dimension(3) :: foot, t, k, l1, l2, point, gap, tangent, curvature, side
      real(wp) :: offset, along, least
      integer :: i, j, index
      trajectory = winding()
      do i = 1, size(trajectory%arcs)
         do j = 1, 7
            along = trajectory%arcs(i)%length*real(j, wp)/8.0_wp
            call point_on_arc(trajectory%arcs(i), along, foot, t, k)
            call frame_on_arc(trajectory%arcs(i), along, t, l1, l2, point)
            call assertEqual(foot, point, message='frame and point at once')
            side = 0.03_wp*(cos(real(j, wp))*l1 + sin(real(j, wp))*l2)
            point = foot + side
            index = i
            call closest_point(trajectory, index, point, offset, gap, tangent, curvature)
            call assertEqual(i, index, message='stays on its arc')
            call assertEqual(foot + side, point, message='is not moved')
            ! Round-off of a point some hundred metres from the start of its arc.
            call assertEqual(side, gap, 2.0e-13_wp, message='gap')
            call assertEqual(along, offset, 2.0e-13_wp, message='offset')
            call assertEqual(t, tangent, rounding, message='tangent')
            call assertEqual(k, curvature, rounding, message='curvature')
            call assertEqual(0.0_wp, dot_product(gap, tangent), 1.0e-17_wp, message='across')
         end do
      end do
      ! A point 20 m off: no other point of the axis is nearer.
      point = trajectory%arcs(6)%origin + [3.0_wp, 20.0_wp, 5.0_wp]
      least = huge(least)
      do i = 0, 18000
         call position_at(trajectory, 0.1_wp*real(i, wp), foot, tangent)
         least = min(least, norm2(point - foot))
      end do
      index = 6
      point = [3.0_wp, 20.0_wp, 5.0_wp]
      call closest_point(trajectory, index, point, offset, gap, tangent, curvature)
      call assertEqual(least, norm2(gap), 1.0e-4_wp, message='search over 0.1 m: 0.05^2/(2 gap)')
      call assertLessThan(norm2(gap), least + rounding, message='search finds nothing nearer')
   end subroutine test_closest_point

   !> From the wrong arc it walks to the right one and re-bases the point.
   subroutine test_closest_point_walks()
      type(trajectory_type) :: trajectory
      real(wp), dimension(3) :: foot, t, k, point, gap, tangent, curvature
      real(wp) :: offset
      integer :: start, goal, index
      trajectory = path([0.0_wp, 100.0_wp, 130.0_wp, 160.0_wp, 400.0_wp], [0.0_wp, 0.0_wp, 5.0_wp, 10.0_wp, 40.0_wp], &
                        [0.0_wp, 0.0_wp, 20.0_wp, 30.0_wp, 40.0_wp])
      do goal = 1, size(trajectory%arcs)
         do start = 1, size(trajectory%arcs)
            call point_on_arc(trajectory%arcs(goal), 7.0_wp, foot, t, k)
            point = foot + 0.02_wp*trajectory%arcs(goal)%lateral_2 &
                    + (trajectory%arcs(goal)%origin - trajectory%arcs(start)%origin)
            index = start
            call closest_point(trajectory, index, point, offset, gap, tangent, curvature)
            call assertEqual(goal, index)
            call assertEqual(foot + 0.02_wp*trajectory%arcs(goal)%lateral_2, point, 1.0e-12_wp, message='re-based')
            call assertEqual(foot + 0.02_wp*trajectory%arcs(goal)%lateral_2, gap + foot_of(offset), 1.0e-12_wp)
         end do
      end do
      ! Beyond the ends the first and last arcs go on.
      index = 2
      point = [0.5_wp, 0.0_wp, -105.0_wp]
      call closest_point(trajectory, index, point, offset, gap, tangent, curvature)
      call assertEqual(1, index)
      call assertEqual(-5.0_wp, offset, 1.0e-12_wp, message='above the first station')
      call assertEqual([0.5_wp, 0.0_wp, 0.0_wp], gap, 1.0e-12_wp)
   contains
      function foot_of(along) result(position)
         real(wp), intent(in) :: along
         real(wp) :: position(3), direction(3), bend(3)
         call point_on_arc(trajectory%arcs(index), along, position, direction, bend)
      end function foot_of
   end subroutine test_closest_point_walks

   !> Points at and about the joint of two strongly different arcs, at the centre of a bend and beyond: it ends,
   !> and gap and foot add up to the point.
   subroutine test_closest_point_at_kinks()
      type(trajectory_type) :: trajectory
      real(wp), dimension(3) :: point, gap, tangent, curvature, foot
      real(wp) :: offset
      integer :: i, j, index
      trajectory = path([0.0_wp, 10.0_wp, 20.0_wp, 20.01_wp, 30.0_wp], [0.0_wp, 0.0_wp, 100.0_wp, 100.0_wp, 0.0_wp], &
                        [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp])
      do i = -20, 20
         do j = 1, size(trajectory%arcs)
            index = j
            point = [real(i, wp), 0.05_wp, 0.0_wp] + epsilon(1.0_wp)*real(i, wp)
            call closest_point(trajectory, index, point, offset, gap, tangent, curvature)
            call point_on_arc(trajectory%arcs(index), offset, foot, tangent, curvature)
            call assertEqual(point, foot + gap, 1.0e-12_wp)
         end do
      end do
      ! The centre of the second arc itself.
      index = 2
      point = trajectory%arcs(2)%normal/trajectory%arcs(2)%curvature
      call closest_point(trajectory, index, point, offset, gap, tangent, curvature)
      call assertEqual(1.0_wp/trajectory%arcs(2)%curvature, norm2(gap), 1.0e-12_wp, message='centre')
   end subroutine test_closest_point_at_kinks
end module dg_test_closest_point
