!> Shape functions: they reproduce every cubic, its slope, its bend, and the work of a line load on it.
module dg_test_hermite
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_hermite, only: hermite_line_load, hermite_slope, hermite_value
   use dg_kinds, only: wp
   implicit none
   private
   public :: hermite_suite

   real(wp), parameter :: length = 3.7_wp
   real(wp), parameter :: round_off = 1.0e-14_wp
   !> p(x) = sum c_k x**k.
   real(wp), parameter :: c(0:3) = [0.7_wp, -1.2_wp, 0.5_wp, -0.11_wp]

contains

   function hermite_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('hermite')
      call suite%addTest(TestMethod('partition_of_unity', test_partition_of_unity))
      call suite%addTest(TestMethod('any_cubic', test_any_cubic))
      call suite%addTest(TestMethod('line_load', test_line_load))
   end function hermite_suite

   subroutine test_partition_of_unity()
      real(wp) :: n(4), slope(4)
      integer :: i
      do i = 0, 10
         n = hermite_value(0.1_wp*i, length)
         slope = hermite_slope(0.1_wp*i, length)
         call assertEqual(1.0_wp, n(1) + n(3), round_off, message='a shift')
         call assertEqual(0.0_wp, slope(1) + slope(3), round_off, message='a shift has no slope')
         call assertEqual(1.0_wp, slope(2) + slope(3)*length + slope(4), round_off, message='a line of slope one')
      end do
   end subroutine test_partition_of_unity

   subroutine test_any_cubic()
      real(wp) :: x, y(4)
      integer :: i
      y = [p(0.0_wp), dp(0.0_wp), p(length), dp(length)]
      do i = 0, 10
         x = 0.1_wp*i*length
         call assertEqual(p(x), dot_product(hermite_value(x/length, length), y), round_off)
         call assertEqual(dp(x), dot_product(hermite_slope(x/length, length), y), round_off)
         call assertEqual(ddp(x), dot_product(hermite_bend(x/length, length), y), round_off)
      end do
   end subroutine test_any_cubic

   !> Integral of p over the element, by the nodes and in closed form.
   subroutine test_line_load()
      real(wp) :: integral
      integer :: k
      integral = 0.0_wp
      do k = 0, 3
         integral = integral + c(k)*length**(k + 1)/(k + 1)
      end do
      call assertEqual(integral, dot_product(hermite_line_load(length), [p(0.0_wp), dp(0.0_wp), p(length), dp(length)]), &
                       10.0_wp*round_off)
   end subroutine test_line_load

   pure function p(x) result(value)
      real(wp), intent(in) :: x
      real(wp) :: value
      value = c(0) + x*(c(1) + x*(c(2) + x*c(3)))
   end function p

   pure function dp(x) result(value)
      real(wp), intent(in) :: x
      real(wp) :: value
      value = c(1) + x*(2.0_wp*c(2) + x*3.0_wp*c(3))
   end function dp

   pure function ddp(x) result(value)
      real(wp), intent(in) :: x
      real(wp) :: value
      value = 2.0_wp*c(2) + x*6.0_wp*c(3)
   end function ddp

   !> d2N/dx2(4) at xi [1/m2, 1/m, 1/m2, 1/m].
   pure function hermite_bend(xi, length) result(n)
      real(wp), intent(in) :: xi, length   !< place in the element, 0 to 1 [-]; its length [m]
      real(wp) :: n(4)
      n(1) = (12.0_wp*xi - 6.0_wp)/length**2
      n(2) = (6.0_wp*xi - 4.0_wp)/length
      n(3) = -n(1)
      n(4) = (6.0_wp*xi - 2.0_wp)/length
   end function hermite_bend
end module dg_test_hermite
