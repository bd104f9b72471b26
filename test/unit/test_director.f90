!> Directors from slopes: unit length, direction, and both derivatives against central differences.
module dg_test_director
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_director, only: director, director_curvature, director_gradient
   use dg_kinds, only: wp
   implicit none
   private
   public :: director_suite

   real(wp), parameter :: step = 1.0e-5_wp
   !> Truncation of central differences is step**2, round-off 1e-16/step: both near 1e-10 or below.
   real(wp), parameter :: tolerance = 1.0e-9_wp
   real(wp), parameter :: round_off = 1.0e-15_wp
   !> A frame turned out of the axes: columns t, n_1, n_2.
   real(wp), parameter :: frame(3, 3) = reshape([2.0_wp, -1.0_wp, 2.0_wp, 2.0_wp, 2.0_wp, -1.0_wp, -1.0_wp, 2.0_wp, 2.0_wp], &
                                                [3, 3])/3.0_wp
   real(wp), parameter :: slopes(2) = [0.4_wp, -0.7_wp]

contains

   function director_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('director')
      call suite%addTest(TestMethod('unit_vector_of_its_slopes', test_unit_vector))
      call suite%addTest(TestMethod('gradient', test_gradient))
      call suite%addTest(TestMethod('curvature', test_curvature))
   end function director_suite

   subroutine test_unit_vector()
      real(wp) :: d(3)
      d = director(frame, slopes)
      call assertEqual(1.0_wp, norm2(d), round_off, message='length')
      call assertEqual(slopes, matmul(d, frame(:, 2:3))/dot_product(d, frame(:, 1)), 2.0_wp*round_off, message='slopes')
      call assertEqual(frame(:, 1), director(frame, [0.0_wp, 0.0_wp]), message='no slope: the tangent')
   end subroutine test_unit_vector

   subroutine test_gradient()
      real(wp) :: d(3), gradient(3, 2)
      integer :: k
      d = director(frame, slopes)
      gradient = director_gradient(frame, d)
      do k = 1, 2
         call assertEqual((director(frame, slopes + shift(k)) - director(frame, slopes - shift(k)))/(2.0_wp*step), &
                          gradient(:, k), tolerance)
         call assertEqual(0.0_wp, dot_product(gradient(:, k), d), round_off, message='across the director')
      end do
   end subroutine test_gradient

   subroutine test_curvature()
      real(wp), parameter :: g(3) = [0.3_wp, -1.1_wp, 0.6_wp]
      real(wp) :: h(2, 2), plus(2), minus(2)
      integer :: k
      h = director_curvature(frame, director(frame, slopes), g)
      do k = 1, 2
         plus = work(slopes + shift(k))
         minus = work(slopes - shift(k))
         call assertEqual((plus - minus)/(2.0_wp*step), h(:, k), tolerance)
      end do
      call assertEqual(h(1, 2), h(2, 1), message='symmetric')
   contains
      pure function work(s) result(w)
         real(wp), intent(in) :: s(2)
         real(wp) :: w(2)
         w = matmul(g, director_gradient(frame, director(frame, s)))
      end function work
   end subroutine test_curvature

   pure function shift(k) result(s)
      integer, intent(in) :: k
      real(wp) :: s(2)
      s = 0.0_wp
      s(k) = step
   end function shift
end module dg_test_director
