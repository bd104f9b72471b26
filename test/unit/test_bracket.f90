!> Roots between two numbers.
module dg_test_bracket
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_depth_search, only: depth_search_type, new_depth_search, next_depth, take_value
   use dg_kinds, only: wp
   use funit, only: assertEqual, assertLessThanOrEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: bracket_suite

   real(wp), parameter :: tolerance = 1.0e-12_wp
   !> Functions that fall through zero, with their roots.
   integer, parameter :: straight = 1, curved = 2, kinked = 3, jumping = 4, steep = 5, flat = 6
   real(wp), parameter :: roots(6) = [0.25_wp, sqrt(0.5_wp), 0.1_wp, 1.0_wp/3.0_wp, 0.01_wp, 0.5_wp]

contains

   function bracket_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bracket')
      call suite%addTest(TestMethod('finds_roots', test_roots))
      call suite%addTest(TestMethod('smooth_roots_cost_little', test_cost))
      call suite%addTest(TestMethod('ends_where_no_number_lies_between', test_no_number))
      call suite%addTest(TestMethod('first_depth_that_is_not_possible', test_depths))
   end function bracket_suite

   pure function value_of(which, x) result(value)
      integer, intent(in) :: which
      real(wp), intent(in) :: x
      real(wp) :: value
      select case (which)
      case (straight); value = 3.0_wp*(roots(straight) - x)
      case (curved); value = 0.5_wp - x**2
      case (kinked); value = min(1.0_wp - x, 1.0e3_wp*(roots(kinked) - x))
      case (jumping); value = merge(2.0_wp, -1.0e9_wp, x < roots(jumping))
      case (steep); value = roots(steep)/x - 1.0_wp
      case default; value = (roots(flat) - x)**9
      end select
   end function value_of

   !> Both ends within twice the tolerance of the root, on either side of it; `tries`: how many values that took.
   subroutine search(which, tries, bracket)
      integer, intent(in) :: which
      integer, intent(out) :: tries
      type(bracket_type), intent(out) :: bracket
      real(wp) :: x
      real(wp), parameter :: low = 1.0e-3_wp, high = 1.0_wp
      bracket = new_bracket(low, value_of(which, low), high, value_of(which, high))
      tries = 0
      do while (.not. is_narrow(bracket, tolerance) .and. tries < 1000)
         x = next_try(bracket, tolerance)
         call narrow(bracket, x, value_of(which, x))
         tries = tries + 1
      end do
   end subroutine search

   subroutine test_roots()
      type(bracket_type) :: bracket
      integer :: which, tries
      do which = 1, size(roots)
         call search(which, tries, bracket)
         call assertEqual(roots(which), bracket%low, 2.1_wp*tolerance)
         call assertEqual(roots(which), bracket%high, 2.1_wp*tolerance)
         call assertTrue(bracket%low < bracket%high)
         ! halving alone takes 40
         call assertLessThanOrEqual(tries, 120)
      end do
   end subroutine test_roots

   subroutine test_cost()
      type(bracket_type) :: bracket
      integer :: tries
      call search(straight, tries, bracket)
      call assertLessThanOrEqual(tries, 3)
      call search(curved, tries, bracket)
      call assertLessThanOrEqual(tries, 10)
      call search(kinked, tries, bracket)
      call assertLessThanOrEqual(tries, 20)   ! half of what halving takes
   end subroutine test_cost

   subroutine test_no_number()
      type(bracket_type) :: bracket
      bracket = new_bracket(1.0_wp, 1.0_wp, nearest(1.0_wp, 1.0_wp), -1.0_wp)
      call assertTrue(is_narrow(bracket, 0.0_wp))
   end subroutine test_no_number

   !> Possible between the first two of some depths and between the next two: the second counts. Possible nowhere, and only just
   !> above the bottom.
   subroutine test_depths()
      call assertEqual(40.0_wp, deepest([0.0_wp, 40.0_wp]), 1.0e-6_wp, message='from the top')
      call assertEqual(40.0_wp, deepest([10.0_wp, 40.0_wp, 60.0_wp, 80.0_wp]), 1.0e-6_wp, message='in two parts')
      call assertEqual(99.5_wp, deepest([10.0_wp, 99.5_wp]), 1.0e-6_wp, message='above the bottom')
      call assertEqual(0.0_wp, deepest([200.0_wp, 300.0_wp]), 0.0_wp, message='nowhere')
   end subroutine test_depths

   !> Deepest depth of 100 m at which a function is >= 0 that changes its sign at each of some depths.
   function deepest(changes) result(depth)
      real(wp), intent(in) :: changes(:)   !< the function is < 0 above the first [m]
      real(wp) :: depth
      type(depth_search_type) :: search
      search = new_depth_search(100.0_wp, 1.0e-7_wp)
      do while (search%goes_on)
         depth = next_depth(search)
         call take_value(search, depth, value_at(depth))
      end do
      depth = search%greatest
   contains
      function value_at(md) result(value)
         real(wp), intent(in) :: md
         real(wp) :: value
         value = minval(abs(md - changes))*merge(1.0_wp, -1.0_wp, modulo(count(changes <= md), 2) == 1)
      end function value_at
   end function deepest
end module dg_test_bracket
