!> Edges of contact found among forces that are made up.
module dg_test_contact_edges
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_contact_edges, only: centroid, contact_edge_type, find_edges, moments_of_misplacing
   use dg_kinds, only: wp
   implicit none
   private
   public :: contact_edges_suite

   real(wp), parameter :: round_off = 1.0e-12_wp
   !> Stretches of half a metre under 1 kN/m.
   integer, parameter :: n = 40
   real(wp), parameter :: half = 0.5_wp, load = 1000.0_wp

contains

   function contact_edges_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('contact_edges')
      call suite%addTest(TestMethod('spread_contact_has_none', test_spread))
      call suite%addTest(TestMethod('force_and_place', test_edge))
      call suite%addTest(TestMethod('first_and_last_stretch', test_ends))
      call suite%addTest(TestMethod('small_ones_left_out', test_small))
      call suite%addTest(TestMethod('nothing_touches', test_nothing))
      call suite%addTest(TestMethod('misplaced_force', test_misplaced))
   end function contact_edges_suite

   !> Middles of the stretches [m].
   pure function places() result(md)
      real(wp) :: md(n)
      integer :: i
      md = [(half*(i - half), i=1, n)]
   end function places

   subroutine find(force, total, edges)
      real(wp), intent(in) :: force(n)
      real(wp), intent(in) :: total
      type(contact_edge_type), allocatable, intent(out) :: edges(:)
      call find_edges(places(), spread(half, 1, n), force, spread(load, 1, n), total, edges)
   end subroutine find

   !> Count contact that varies by a third as spread. Half of the load is spread, too, where the other half is carried elsewhere.
   subroutine test_spread()
      type(contact_edge_type), allocatable :: edges(:)
      real(wp) :: force(n)
      force = half*load
      force(::2) = 1.33_wp*force(::2)
      force(2::2) = 0.67_wp*force(2::2)
      call find(force, sum(force), edges)
      call assertEqual(0, size(edges))
      force = 0.25_wp*load
      call find(force, sum(force), edges)
      call assertEqual(0, size(edges), message='half the load')
   end subroutine test_spread

   !> A free span, then a lift-off of 6 kN of which a sixth has spread to the next stretch.
   subroutine test_edge()
      type(contact_edge_type), allocatable :: edges(:)
      real(wp) :: force(n), md(n)
      force = half*load
      force(11:20) = 0.0_wp
      force(21) = force(21) + 5.0e3_wp
      force(22) = force(22) + 1.0e3_wp
      force(23) = 1.05_wp*force(23)         ! no part of it
      call find(force, sum(force), edges)
      md = places()
      call assertEqual(1, size(edges))
      call assertEqual(6.0e3_wp, edges(1)%force, round_off*6.0e3_wp)
      call assertEqual(2.0_wp*half, edges(1)%length, round_off)
      call assertEqual((5.0_wp*md(21) + md(22))/6.0_wp, edges(1)%md, round_off*edges(1)%md)
   end subroutine test_edge

   subroutine test_ends()
      type(contact_edge_type), allocatable :: edges(:)
      real(wp) :: force(n), md(n)
      force = half*load
      force(1) = force(1) + 2.0e3_wp
      force(n) = force(n) + 3.0e3_wp
      call find(force, sum(force), edges)
      md = places()
      call assertEqual(2, size(edges))
      call assertEqual([2.0e3_wp, 3.0e3_wp], edges%force, round_off*3.0e3_wp)
      call assertEqual([md(1), md(n)], edges%md, round_off*md(n))
   end subroutine test_ends

   !> A thousandth of the sum of contact counts, less does not.
   subroutine test_small()
      type(contact_edge_type), allocatable :: edges(:)
      real(wp) :: force(n)
      force = half*load
      force(5) = force(5) + 1.0e3_wp
      call find(force, 0.99e6_wp, edges)
      call assertEqual(1, size(edges))
      call find(force, 1.01e6_wp, edges)
      call assertEqual(0, size(edges), message='less')
   end subroutine test_small

   subroutine test_nothing()
      type(contact_edge_type), allocatable :: edges(:)
      call find(spread(0.0_wp, 1, n), 0.0_wp, edges)
      call assertEqual(0, size(edges))
      call assertEqual(1.5_wp, centroid([1.0_wp, 2.0_wp], [0.0_wp, 0.0_wp]), round_off, message='the middle')
   end subroutine test_nothing

   !> Ten newtons felt at one place of an element of 2 m may act 0.3 lengths away: 6 N.m at least, within the string and at its end;
   !> next to an element of 30 m not more than the half of that element's length away.
   subroutine test_misplaced()
      real(wp), parameter :: force = 10.0_wp, long = 30.0_wp
      real(wp), parameter :: at_least = 6.0_wp, at_most = 0.5_wp*long*force
      real(wp) :: length(3), pressed(2, 3), moments(4)
      length = 2.0_wp
      pressed = 0.0_wp
      pressed(2, 2) = force
      moments = moments_of_misplacing(length, pressed)
      call assertTrue(all(moments(2:3) > at_least), message='within')
      pressed = 0.0_wp
      pressed(2, 3) = force
      moments = moments_of_misplacing(length, pressed)
      call assertTrue(all(moments(3:4) > at_least), message='at the end')
      length = [long, 0.2_wp, long]
      pressed = 0.0_wp
      pressed(1, 2) = force
      moments = moments_of_misplacing(length, pressed)
      call assertTrue(all(moments < at_most), message='beside a long element')
   end subroutine test_misplaced
end module dg_test_contact_edges
