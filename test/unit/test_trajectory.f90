!> The hole axis: survey angles, arcs, frames, spline.
module dg_test_trajectory
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, TestMethod, TestSuite
   use dg_arc, only: arc_type, finish_arc, foot_offset, foot_on_arc, frame_on_arc, point_on_arc
   use dg_constants, only: degree, pi
   use dg_error, only: error_type, status_bad_input
   use dg_kinds, only: wp
   use dg_minimum_curvature, only: dogleg_between
   use dg_path_difference, only: find_difference, path_difference_type
   use dg_spline_path, only: second_derivatives
   use dg_survey, only: azimuth_of, clock_angle, high_side, inclination_of, tangent_of
   use dg_trajectory, only: arc_at, interpolation_minimum_curvature, interpolation_spline, new_trajectory, &
      position_at, trajectory_type, true_vertical_depth
   use dg_vector, only: cross
   implicit none
   private
   public :: trajectory_suite
   ! For tests of other things on a path.
   public :: path, winding, rounding

   !> A few roundings of unit vectors and angles.
   real(wp), parameter :: rounding = 1.0e-14_wp
   !> Round-off of positions of kilometres [m].
   real(wp), parameter :: position_rounding = 1.0e-11_wp

contains

   function trajectory_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('trajectory')
      call suite%addTest(TestMethod('angles', test_angles))
      call suite%addTest(TestMethod('clock_angle', test_clock_angle))
      call suite%addTest(TestMethod('published_station', test_published_station))
      call suite%addTest(TestMethod('quarter_circle', test_quarter_circle))
      call suite%addTest(TestMethod('helix', test_helix))
      call suite%addTest(TestMethod('through_north', test_through_north))
      call suite%addTest(TestMethod('straight_up', test_straight_up))
      call suite%addTest(TestMethod('stations_far_and_near', test_stations_far_and_near))
      call suite%addTest(TestMethod('frame', test_frame))
      call suite%addTest(TestMethod('frame_does_not_spin', test_frame_does_not_spin))
      call suite%addTest(TestMethod('vanishing_curvature', test_vanishing_curvature))
      call suite%addTest(TestMethod('small_doglegs', test_small_doglegs))
      call suite%addTest(TestMethod('spline', test_spline))
      call suite%addTest(TestMethod('difference_of_paths', test_difference))
      call suite%addTest(TestMethod('natural_spline', test_second_derivatives))
      call suite%addTest(TestMethod('faults', test_faults))
   end function trajectory_suite

   !> A trajectory that must be accepted; angles in degrees.
   function path(md, inclination, azimuth, interpolation) result(trajectory)
      real(wp), intent(in) :: md(:), inclination(:), azimuth(:)
      integer, intent(in), optional :: interpolation
      type(trajectory_type) :: trajectory
      type(error_type), allocatable :: error
      integer :: method
      method = interpolation_minimum_curvature
      if (present(interpolation)) method = interpolation
      call new_trajectory(trajectory, md, inclination*degree, azimuth*degree, method, error)
      call assertFalse(allocated(error), message='the survey is a good one')
   end function path

   !> A three-dimensional well: build and turn through north, past 90 deg.
   function winding() result(trajectory)
      type(trajectory_type) :: trajectory
      trajectory = path([0.0_wp, 300.0_wp, 330.0_wp, 500.0_wp, 500.5_wp, 900.0_wp, 1500.0_wp, 1800.0_wp], &
                        [0.0_wp, 0.0_wp, 3.0_wp, 40.0_wp, 40.01_wp, 95.0_wp, 80.0_wp, 80.0_wp], &
                        [0.0_wp, 0.0_wp, 340.0_wp, 350.0_wp, 350.0_wp, 20.0_wp, 100.0_wp, 100.0_wp])
   end function winding

   subroutine test_angles()
      call assertEqual([0.0_wp, 0.0_wp, 1.0_wp], tangent_of(0.0_wp, 1.0_wp), rounding, message='down')
      call assertEqual([0.0_wp, 1.0_wp, 0.0_wp], tangent_of(90.0_wp*degree, 90.0_wp*degree), rounding, message='east')
      call assertEqual(30.0_wp*degree, inclination_of(tangent_of(30.0_wp*degree, 4.0_wp)), rounding)
      call assertEqual(pi, inclination_of([0.0_wp, 0.0_wp, -1.0_wp]), rounding, message='straight up')
      call assertEqual(350.0_wp*degree, azimuth_of(tangent_of(1.0_wp, -10.0_wp*degree)), rounding, message='0 to 2 pi')
      call assertEqual(0.0_wp, azimuth_of([0.0_wp, 0.0_wp, 1.0_wp]), message='vertical')
      call assertEqual([0.0_wp, 0.0_wp, -1.0_wp], high_side([1.0_wp, 0.0_wp, 0.0_wp]), rounding, message='horizontal')
      call assertEqual([1.0_wp, 0.0_wp, 0.0_wp], high_side([0.0_wp, 0.0_wp, 1.0_wp]), rounding, message='north where vertical')
      call assertEqual([-0.5_wp, 0.0_wp, -sqrt(0.75_wp)]*[-1.0_wp, 1.0_wp, 1.0_wp], &
                       high_side(tangent_of(60.0_wp*degree, 0.0_wp)), rounding, message='60 deg to the north')
   end subroutine test_angles

   !> Looking north along a horizontal hole the right hand points east, clockwise from the high side.
   subroutine test_clock_angle()
      real(wp), parameter :: ahead(3) = [1.0_wp, 0.0_wp, 0.0_wp], down(3) = [0.0_wp, 0.0_wp, 1.0_wp]
      real(wp), parameter :: east(3) = [0.0_wp, 1.0_wp, 0.0_wp]
      call assertEqual(0.0_wp, clock_angle(ahead, -down), rounding, message='high side')
      call assertEqual(90.0_wp*degree, clock_angle(ahead, east), rounding, message='right')
      call assertEqual(180.0_wp*degree, clock_angle(ahead, 5.0_wp*down), rounding, message='low side')
      call assertEqual(270.0_wp*degree, clock_angle(ahead, -east), rounding, message='left')
      call assertEqual(90.0_wp*degree, clock_angle(down, east), rounding, message='vertical: from north to east')
      call assertEqual(0.0_wp, clock_angle(ahead, 0.0_wp*east), message='no vector, no angle')
   end subroutine test_clock_angle

   !> Worked example of www.drillingformulas.com, 'Minimum Curvature Method': 3500 ft, 15 deg, azimuth 20 deg to
   !> 3600 ft, 25 deg, 45 deg gives dogleg 0.22605 rad, north 27.22, east 19.45, vertical 94.01 ft.
   subroutine test_published_station()
      type(trajectory_type) :: trajectory
      real(wp), parameter :: printed = 0.005_wp
      trajectory = path([3500.0_wp, 3600.0_wp], [15.0_wp, 25.0_wp], [20.0_wp, 45.0_wp])
      call assertEqual([27.22_wp, 19.45_wp, 94.01_wp], trajectory%arcs(1)%chord, printed)
      call assertEqual(0.22605_wp, trajectory%arcs(1)%curvature*100.0_wp, 1.0e-5_wp)
   end subroutine test_published_station

   !> From vertical to horizontal in one arc of length L: radius 2 L/pi, all of it north and down.
   subroutine test_quarter_circle()
      type(trajectory_type) :: trajectory
      real(wp), parameter :: length = 500.0_wp, radius = 2.0_wp*length/pi
      real(wp) :: position(3), tangent(3)
      trajectory = path([100.0_wp, 100.0_wp + length], [0.0_wp, 90.0_wp], [0.0_wp, 0.0_wp])
      call position_at(trajectory, 100.0_wp + length, position, tangent)
      call assertEqual([radius, 0.0_wp, radius], position, position_rounding, message='end')
      call assertEqual([1.0_wp, 0.0_wp, 0.0_wp], tangent, rounding, message='end tangent')
      call position_at(trajectory, 100.0_wp + length/3.0_wp, position, tangent)
      call assertEqual([radius*(1.0_wp - sqrt(0.75_wp)), 0.0_wp, 0.5_wp*radius], position, position_rounding, message='30 deg')
      call assertEqual([0.5_wp, 0.0_wp, sqrt(0.75_wp)], tangent, rounding, message='30 deg tangent')
      call assertEqual(1.0_wp/radius, trajectory%arcs(1)%curvature, rounding, message='curvature')
      call assertEqual(0.5_wp*radius, true_vertical_depth(trajectory, 100.0_wp + length/3.0_wp), position_rounding)
   end subroutine test_quarter_circle

   !> A hole of constant inclination whose azimuth grows evenly. Minimum curvature approaches it with the square
   !> of the distance of stations, the spline much faster.
   subroutine test_helix()
      real(wp), parameter :: length = 600.0_wp, inclination = 50.0_wp, turn = 120.0_wp
      real(wp) :: exact(3), errors(3), q
      integer :: i
      q = turn*degree/length
      exact = [sin(inclination*degree)*sin(q*length)/q, sin(inclination*degree)*(1.0_wp - cos(q*length))/q, &
               length*cos(inclination*degree)]
      do i = 1, 2
         errors(i) = norm2(end_of(helix(10*i, interpolation_minimum_curvature)) - exact)
      end do
      errors(3) = norm2(end_of(helix(20, interpolation_spline)) - exact)
      ! Second order: halving the distance divides the error by four, the next order is (q h)^2 = 4 % of that.
      call assertEqual(4.0_wp, errors(1)/errors(2), 0.16_wp, message='second order')
      call assertLessThan(errors(2), 1.0e-3_wp*length, message='minimum curvature')
      call assertLessThan(errors(3), 0.1_wp*errors(2), message='spline')
   contains
      function helix(parts, interpolation) result(trajectory)
         integer, intent(in) :: parts, interpolation
         type(trajectory_type) :: trajectory
         real(wp) :: md(parts + 1)
         integer :: k
         md = [(length*real(k, wp)/real(parts, wp), k=0, parts)]
         trajectory = path(md, spread(inclination, 1, parts + 1), md/length*turn, interpolation)
      end function helix
      function end_of(trajectory) result(position)
         type(trajectory_type), intent(in) :: trajectory
         real(wp) :: position(3), tangent(3)
         call position_at(trajectory, length, position, tangent)
      end function end_of
   end subroutine test_helix

   !> The same well turned by 180 deg about the vertical, so that once its azimuth passes north.
   subroutine test_through_north()
      type(trajectory_type) :: north, south
      real(wp), parameter :: md(3) = [0.0_wp, 100.0_wp, 200.0_wp], inclination(3) = [30.0_wp, 40.0_wp, 50.0_wp]
      integer :: method, i
      do method = interpolation_minimum_curvature, interpolation_spline
         north = path(md, inclination, [350.0_wp, 359.0_wp, 8.0_wp], method)
         south = path(md, inclination, [170.0_wp, 179.0_wp, 188.0_wp], method)
         call assertEqual(size(north%arcs), size(south%arcs))
         do i = 1, size(north%arcs)
            call assertEqual(north%arcs(i)%chord*[-1.0_wp, -1.0_wp, 1.0_wp], south%arcs(i)%chord, position_rounding)
         end do
      end do
   end subroutine test_through_north

   subroutine test_straight_up()
      type(trajectory_type) :: trajectory
      trajectory = path([0.0_wp, 50.0_wp, 150.0_wp], [180.0_wp, 180.0_wp, 100.0_wp], [77.0_wp, 12.0_wp, 90.0_wp])
      call assertEqual(-50.0_wp, true_vertical_depth(trajectory, 50.0_wp), position_rounding, message='rises')
      call assertEqual([0.0_wp, 0.0_wp, -50.0_wp], trajectory%arcs(1)%chord, position_rounding)
      call assertEqual(80.0_wp*degree/100.0_wp, trajectory%arcs(2)%curvature, rounding, message='past 90 deg')
      ! 169 deg in one arc is legal; its chord is 2 R sin(84.5 deg).
      trajectory = path([0.0_wp, 100.0_wp], [0.0_wp, 169.0_wp], [0.0_wp, 0.0_wp])
      call assertEqual(2.0_wp*100.0_wp/(169.0_wp*degree)*sin(84.5_wp*degree), norm2(trajectory%arcs(1)%chord), position_rounding)
   end subroutine test_straight_up

   !> Splitting arcs at points of their own changes nothing, be the pieces 1 km or 1 cm long.
   subroutine test_stations_far_and_near()
      type(trajectory_type) :: whole, parts
      real(wp), parameter :: turn = 30.0_wp/1000.0_wp
      real(wp), parameter :: md(6) = [0.0_wp, 1000.0_wp, 1000.01_wp, 1000.02_wp, 2000.0_wp, 3000.0_wp]
      real(wp) :: one(3), other(3), tangent(3)
      integer :: i
      whole = path([0.0_wp, 3000.0_wp], [0.0_wp, 90.0_wp], [33.0_wp, 33.0_wp])
      parts = path(md, turn*md, spread(33.0_wp, 1, size(md)))
      do i = 0, 60
         call position_at(whole, 50.0_wp*real(i, wp), one, tangent)
         call position_at(parts, 50.0_wp*real(i, wp), other, tangent)
         call assertEqual(one, other, 10.0_wp*position_rounding)
      end do
      ! A curvature from tangents 0.01 m apart holds to the round-off of a tangent over 0.01 m.
      call assertEqual(turn*degree, parts%arcs(2)%curvature, 1.0e-13_wp, message='curvature of the short arc')
      call assertEqual(1, arc_at(parts, 999.999_wp))
      call assertEqual(2, arc_at(parts, 1000.0_wp), message='at a joint the lower one')
      call assertEqual(5, arc_at(parts, 9999.0_wp), message='outside the last')
      call assertEqual(1, arc_at(parts, -1.0_wp), message='outside the first')
      do i = 1, size(parts%arcs)
         call assertEqual([1, 1, 2, 5], [arc_at(parts, -1.0_wp, near=i), arc_at(parts, 999.999_wp, near=i), &
                                         arc_at(parts, 1000.0_wp, near=i), arc_at(parts, 9999.0_wp, near=i)], &
                          message='wherever it is looked for from')
      end do
   end subroutine test_stations_far_and_near

   subroutine test_frame()
      type(trajectory_type) :: trajectory
      real(wp), dimension(3) :: t, l1, l2, before_1, before_2, position, tangent, curvature
      integer :: i
      trajectory = winding()
      call assertEqual([1.0_wp, 0.0_wp, 0.0_wp], trajectory%arcs(1)%lateral_1, rounding, message='vertical start: north')
      do i = 1, size(trajectory%arcs)
         associate (arc => trajectory%arcs(i))
            call frame_on_arc(arc, 0.37_wp*arc%length, t, l1, l2)
            call assertEqual(1.0_wp, norm2(t), rounding)
            call assertEqual(1.0_wp, norm2(l1), rounding)
            call assertEqual(0.0_wp, dot_product(t, l1), rounding)
            call assertEqual(l2, cross(t, l1), rounding, message='right-handed')
            call point_on_arc(arc, 0.37_wp*arc%length, position, tangent, curvature)
            call assertEqual(t, tangent, rounding)
            call assertEqual(0.0_wp, dot_product(tangent, curvature), rounding, message='curvature lies across')
            call frame_on_arc(arc, arc%length, t, before_1, before_2)
         end associate
         if (i == size(trajectory%arcs)) cycle
         associate (next => trajectory%arcs(i + 1))
            call assertEqual(next%tangent, t, rounding, message='tangent continues')
            call assertEqual(next%lateral_1, before_1, rounding, message='frame continues')
            call assertEqual(next%lateral_2, before_2, rounding, message='frame continues')
         end associate
      end do
      trajectory = path([0.0_wp, 10.0_wp], [60.0_wp, 60.0_wp], [0.0_wp, 0.0_wp])
      call assertEqual([0.5_wp, 0.0_wp, -sqrt(0.75_wp)], trajectory%arcs(1)%lateral_1, rounding, message='inclined: high side')
   end subroutine test_frame

   !> The frame turns about axes across the hole only. Its angle against the high side after a full turn of
   !> azimuth at constant inclination is the solid angle that the tangent has gone round, 2 pi (1 - cos).
   subroutine test_frame_does_not_spin()
      type(trajectory_type) :: trajectory
      real(wp), parameter :: step = 1.0e-3_wp, inclination = 40.0_wp
      !> Central difference over 1 mm: curvature^3 step^2 and round-off/step.
      real(wp), parameter :: difference = 1.0e-12_wp
      integer, parameter :: stations = 721
      real(wp), dimension(3) :: t, l1, l2, ahead, behind, other
      real(wp) :: md(stations), expected
      integer :: i
      trajectory = winding()
      do i = 1, 179
         call frame_at(trajectory, 10.0_wp*real(i, wp) + 0.3_wp, t, l1, l2)
         call frame_at(trajectory, 10.0_wp*real(i, wp) + 0.3_wp + step, t, ahead, other)
         call frame_at(trajectory, 10.0_wp*real(i, wp) + 0.3_wp - step, t, behind, other)
         call assertEqual(0.0_wp, dot_product(ahead - behind, l2)/(2.0_wp*step), difference)
      end do
      md = [(2.0_wp*real(i, wp), i=0, stations - 1)]
      trajectory = path(md, spread(inclination, 1, stations), md/md(stations)*360.0_wp)
      associate (arc => trajectory%arcs(stations - 1))
         call frame_on_arc(arc, arc%length, t, l1, l2)
      end associate
      expected = 2.0_wp*pi*(1.0_wp - cos(inclination*degree))
      ! Great circles between stations cut the circle of latitude: second order, (0.5 deg)^2.
      call assertEqual(expected, clock_angle(t, l1), 1.0e-4_wp)
   end subroutine test_frame_does_not_spin

   !> Down to curvature zero everything is continuous, and equal to the first terms of the series in k s.
   subroutine test_vanishing_curvature()
      type(arc_type) :: arc
      real(wp), dimension(3) :: position, tangent, curvature, gap, expected
      real(wp) :: k, s
      integer :: i, beyond
      arc%length = 100.0_wp
      arc%tangent = [1.0_wp, 0.0_wp, 0.0_wp]
      arc%normal = [0.0_wp, 1.0_wp, 0.0_wp]
      s = 30.0_wp
      do i = 1, 330
         k = 10.0_wp**(-4.0_wp - real(i, wp))
         if (i > 300) k = 0.0_wp
         arc%curvature = k
         call finish_arc(arc)
         call point_on_arc(arc, s, position, tangent, curvature)
         expected = [s, 0.0_wp, 0.0_wp]
         if (k > 1.0e-100_wp) expected = [s - (k*s)**2*s/6.0_wp, k*s*s/2.0_wp - (k*s)**3*s/24.0_wp, 0.0_wp]
         call assertEqual(expected, position, 1.0e-14_wp, message='position')
         call foot_on_arc(arc, position + [0.0_wp, 0.0_wp, 0.02_wp], gap, tangent, curvature, beyond)
         call assertEqual(0, beyond, message='within the arc')
         call assertEqual(s, foot_offset(arc, position), 1.0e-14_wp, message='offset')
         call assertEqual([0.0_wp, 0.0_wp, 0.02_wp], gap, 1.0e-16_wp, message='gap')
      end do
   end subroutine test_vanishing_curvature

   !> The dogleg keeps its digits where the arc cosine of t1.t2 has lost them.
   subroutine test_small_doglegs()
      type(trajectory_type) :: trajectory
      real(wp) :: dogleg
      integer :: i
      do i = 1, 12
         dogleg = 10.0_wp**(-i)
         ! Inclined by 1 rad the tangents differ by the dogleg to their own round-off.
         call assertEqual(dogleg, dogleg_between(tangent_of(1.0_wp, 2.0_wp), tangent_of(1.0_wp + dogleg, 2.0_wp)), 4.0e-16_wp)
         trajectory = path([0.0_wp, 1.0_wp, 2.0_wp], [10.0_wp, 10.0_wp + dogleg, 10.0_wp], [5.0_wp, 5.0_wp, 5.0_wp])
         call assertEqual(1.0_wp, norm2(trajectory%arcs(2)%normal), rounding)
         call assertEqual(0.0_wp, dot_product(trajectory%arcs(2)%normal, trajectory%arcs(2)%tangent), rounding)
      end do
      call assertEqual(0.0_wp, dogleg_between([1.0_wp, 0.0_wp, 0.0_wp], [1.0_wp, 0.0_wp, 0.0_wp]))
      call assertEqual(pi, dogleg_between([1.0_wp, 0.0_wp, 0.0_wp], [-1.0_wp, 0.0_wp, 0.0_wp]), rounding)
   end subroutine test_small_doglegs

   !> The spline passes its stations, its arcs are short, and its curvature has no jumps.
   subroutine test_spline()
      type(trajectory_type) :: arcs, spline
      real(wp), parameter :: md(6) = [0.0_wp, 300.0_wp, 330.0_wp, 360.0_wp, 390.0_wp, 700.0_wp]
      real(wp), parameter :: inclination(6) = [0.0_wp, 0.0_wp, 3.0_wp, 7.0_wp, 10.0_wp, 10.0_wp]
      real(wp) :: position(3), tangent(3), largest
      integer :: i
      arcs = path(md, inclination, spread(340.0_wp, 1, 6))
      spline = path(md, inclination, spread(340.0_wp, 1, 6), interpolation_spline)
      call assertEqual(6, size(spline%md), message='stations stay as given')
      do i = 1, 6
         call position_at(spline, md(i), position, tangent)
         call assertEqual(inclination(i)*degree, inclination_of(tangent), 10.0_wp*rounding)
      end do
      call assertLessThan(maxval(spline%arcs%length), 2.0_wp + rounding)
      largest = maxval(abs(spline%arcs(2:)%curvature - spline%arcs(:size(spline%arcs) - 1)%curvature))
      call assertLessThan(largest, 0.15_wp*maxval(spline%arcs%curvature), message='curvature is continuous')
      call assertGreaterThan(abs(arcs%arcs(2)%curvature - arcs%arcs(1)%curvature), largest, message='unlike minimum curvature')
      ! Two stations: nothing to bend.
      spline = path([0.0_wp, 30.0_wp], [20.0_wp, 20.0_wp], [0.0_wp, 0.0_wp], interpolation_spline)
      call assertLessThan(maxval(spline%arcs%curvature), rounding)
   end subroutine test_spline

   !> A natural spline bends no straight line; through three knots it is one equation by hand.
   subroutine test_second_derivatives()
      real(wp), parameter :: x(4) = [0.0_wp, 1.0_wp, 3.0_wp, 4.0_wp]
      real(wp) :: bend(3)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], second_derivatives(x, 2.0_wp*x - 1.0_wp), rounding)
      ! Three knots 0, 1, 2 with y = 0, 1, 0: the one equation (2/3) M = -2.
      bend = second_derivatives([0.0_wp, 1.0_wp, 2.0_wp], [0.0_wp, 1.0_wp, 0.0_wp])
      call assertEqual([0.0_wp, -3.0_wp, 0.0_wp], bend, rounding)
   end subroutine test_second_derivatives

   subroutine test_faults()
      real(wp) :: nan
      nan = ieee_value(1.0_wp, ieee_quiet_nan)
      call refused([0.0_wp], [0.0_wp], [0.0_wp], 'two stations')
      call refused([0.0_wp, 1.0_wp], [0.0_wp], [0.0_wp, 0.0_wp], 'same number')
      call refused([0.0_wp, 10.0_wp, 10.0_wp], [0.0_wp, 0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp, 0.0_wp], 'station 3')
      call refused([0.0_wp], [0.0_wp], [0.0_wp], 'survey: at least two stations are needed')
      call refused([0.0_wp, 10.0_wp], [0.0_wp, 181.0_wp], [0.0_wp, 0.0_wp], ': inclination must lie between 0 and 180 deg')
      call refused([0.0_wp, 10.0_wp], [-1.0_wp, 1.0_wp], [0.0_wp, 0.0_wp], '0 and 180')
      call refused([0.0_wp, nan], [0.0_wp, 1.0_wp], [0.0_wp, 0.0_wp], 'finite')
      call refused([0.0_wp, 10.0_wp], [0.0_wp, 1.0_wp], [0.0_wp, nan], 'finite')
      call refused([0.0_wp, 10.0_wp], [0.0_wp, 171.0_wp], [0.0_wp, 0.0_wp], '170 deg')
   end subroutine test_faults

   subroutine refused(md, inclination, azimuth, word)
      real(wp), intent(in) :: md(:), inclination(:), azimuth(:)
      character(*), intent(in) :: word
      type(trajectory_type) :: trajectory
      type(error_type), allocatable :: error
      call new_trajectory(trajectory, md, inclination*degree, azimuth*degree, interpolation_minimum_curvature, error)
      call assertTrue(allocated(error), message='refused: '//word)
      if (.not. allocated(error)) return
      call assertEqual(status_bad_input, error%status, message=word)
      call assertTrue(index(error%message, word) > 0, message=word//' in: '//error%message)
   end subroutine refused

   !> A build to 60 deg at the same rate over 600 m and over its first half: 30 deg apart at 300 m; the ends are those of arcs of
   !> radius R = 600 m/(pi/3), and of R/2 and a straight line.
   subroutine test_difference()
      type(trajectory_type) :: early, even
      type(error_type), allocatable :: error
      type(path_difference_type) :: difference
      real(wp), parameter :: turn = 60.0_wp*degree, radius = 600.0_wp/turn
      real(wp) :: down, across
      call new_trajectory(early, [0.0_wp, 300.0_wp, 600.0_wp], [0.0_wp, turn, turn], [0.0_wp, 0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call new_trajectory(even, [0.0_wp, 600.0_wp], [0.0_wp, turn], [0.0_wp, 0.0_wp], interpolation_minimum_curvature, error)
      difference = find_difference(early, even)
      call assertEqual(0.5_wp*turn, difference%direction, 1.0e-9_wp)
      call assertEqual(300.0_wp, difference%direction_md, 1.0e-9_wp)
      down = 0.5_wp*radius*sin(turn) - 300.0_wp*cos(turn)
      across = 0.5_wp*radius*(1.0_wp - cos(turn)) - 300.0_wp*sin(turn)
      call assertEqual(hypot(down, across), difference%position, 1.0e-6_wp)
      call assertEqual([turn, turn], difference%turns, 1.0e-9_wp)
   end subroutine test_difference

   !> Rotation-minimising frame at a measured depth [m].
   pure subroutine frame_at(trajectory, md, tangent, lateral_1, lateral_2)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: md
      real(wp), intent(out) :: tangent(3), lateral_1(3), lateral_2(3)
      integer :: index
      index = arc_at(trajectory, md)
      call frame_on_arc(trajectory%arcs(index), md - trajectory%arcs(index)%md, tangent, lateral_1, lateral_2)
   end subroutine frame_at
end module dg_test_trajectory
