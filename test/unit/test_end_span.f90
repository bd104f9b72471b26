!> The span between a centred end and the wall: its equation, its ends, and lengths solved by hand.
module dg_test_end_span
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_end_span, only: lift_end, span_length, span_shape
   use dg_kinds, only: wp
   implicit none
   private
   public :: end_span_suite

contains

   function end_span_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('end_span')
      call suite%addTest(TestMethod('equation_and_ends', test_equation_and_ends))
      call suite%addTest(TestMethod('lengths', test_lengths))
      call suite%addTest(TestMethod('lifted_nodes', test_lifted_nodes))
   end function end_span_suite

   !> y'''' + k^2 y'' = 1 by differences of the slope; y = y'' = 0 at the end, y = 1, y' = y'' = 0 at the wall.
   subroutine test_equation_and_ends()
      real(wp), parameter :: squares(5) = [-40.0_wp, -2.0_wp, 0.5_wp, 2.0_wp, 6.0_wp], step = 0.01_wp
      real(wp) :: x, length, y, slope, rise(-2:2), bend, third
      integer :: i, j, part
      do i = 1, size(squares)
         length = span_length(squares(i))
         call span_shape(squares(i), length, 0.0_wp, y, slope)
         call assertEqual(0.0_wp, y, 1.0e-12_wp, message='on the axis')
         call span_shape(squares(i), length, length, y, slope)
         call assertEqual(1.0_wp, y, 1.0e-9_wp, message='at the wall')
         call assertEqual(0.0_wp, slope, 1.0e-9_wp, message='along it')
         do part = 0, 2
            x = 0.5_wp*part*length
            do j = -2, 2
               call span_shape(squares(i), length, x + j*step, y, rise(j))
            end do
            bend = (rise(1) - rise(-1))/(2.0_wp*step)
            third = (rise(1) - 2.0_wp*rise(0) + rise(-1))/step**2
            if (part /= 1) call assertEqual(0.0_wp, bend, 1.0e-2_wp*step*abs(third) + 1.0e-5_wp, message='no moment at either end')
            call assertEqual(1.0_wp, (rise(2) - 2.0_wp*rise(1) + 2.0_wp*rise(-1) - rise(-2))/(2.0_wp*step**3) + squares(i)*bend, &
                             1.0e-2_wp, message='equation')
         end do
      end do
   end subroutine test_equation_and_ends

   !> Without axial force x = 24^(1/4); under F = F_s, k^2 = 2, x tan(x/sqrt(2))/sqrt(8) - x^2/4 = 1 at 1.744948; under much tension
   !> the string is a rope, x^2/(2 k^2) = 1 but for x/k^3.
   subroutine test_lengths()
      real(wp), parameter :: taut = 1.0e4_wp
      call assertEqual(24.0_wp**0.25_wp, span_length(0.0_wp), 1.0e-3_wp, message='no axial force')
      call assertEqual(1.744948_wp, span_length(2.0_wp), 1.0e-6_wp, message='at the onset of buckling')
      call assertEqual(sqrt(2.0_wp*taut), span_length(-taut), 0.02_wp, message='taut')
   end subroutine test_lengths

   !> Nodes beyond the span stay as they are, the end comes to the axis, heights lie between, whichever end it is.
   subroutine test_lifted_nodes()
      real(wp), parameter :: away(6) = [0.0_wp, 2.0_wp, 4.0_wp, 6.0_wp, 20.0_wp, 40.0_wp], c = 0.03_wp, ei = 1.0e6_wp, n = 300.0_wp
      real(wp) :: offset(2, 6), slope(2, 6), back(2, 6), back_slope(2, 6)
      integer :: i
      offset = spread([0.6_wp, 0.8_wp]*c, 2, size(away))
      slope = 0.0_wp
      back = offset
      back_slope = slope
      call lift_end(away, 1, 0.0_wp, ei, n, c, offset, slope)
      call lift_end(away, -1, 0.0_wp, ei, n, c, back, back_slope)
      call assertEqual(0.0_wp, norm2(offset(:, 1)), 1.0e-12_wp, message='end')
      do i = 2, size(away)
         call assertTrue(norm2(offset(:, i)) > norm2(offset(:, i - 1)) - 1.0e-12_wp, message='rises')
      end do
      call assertEqual(c, norm2(offset(:, 5)), 1.0e-12_wp, message='lies')
      call assertTrue(dot_product(slope(:, 2), offset(:, 2)) > 0.0_wp, message='slopes to the wall')
      call assertEqual(0.0_wp, maxval(abs(back - offset)), 1.0e-15_wp, message='either end')
      call assertEqual(0.0_wp, maxval(abs(back_slope + slope)), 1.0e-15_wp, message='sense')
      slope = 0.0_wp
      offset = spread([0.6_wp, 0.8_wp]*c, 2, size(away))
      call lift_end(away, 1, 0.0_wp, 1.0e4_wp*ei, n, c, offset, slope)
      call assertEqual(c, norm2(offset(:, 1)), 1.0e-15_wp, message='a span as long as the string is left alone')
   end subroutine test_lifted_nodes
end module dg_test_end_span
