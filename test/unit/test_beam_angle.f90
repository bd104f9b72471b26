!> alpha/sin(alpha) and its derivatives against quadruple precision, across the switch from series to closed form.
module dg_test_beam_angle
   use, intrinsic :: iso_fortran_env, only: real128
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_beam_angle, only: angle_ratios
   use dg_kinds, only: wp
   implicit none
   private
   public :: beam_angle_suite

   integer, parameter :: qp = real128

contains

   function beam_angle_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('beam_angle')
      call suite%addTest(TestMethod('ratio_and_derivatives', test_ratio_and_derivatives))
      call suite%addTest(TestMethod('beyond_one', test_beyond_one))
   end function beam_angle_suite

   !> g = acos(c)/sqrt(1 - c**2), g' = (g c - 1)/(1 - c**2), g'' = (3 c g' + g)/(1 - c**2) in 34 digits, of which the
   !> smallest angle here costs 18. Both derivatives sit near -1/3 and 4/15 at zero angle, so one measure serves.
   subroutine test_ratio_and_derivatives()
      real(wp), parameter :: u(9) = [1.0e-9_wp, 1.0e-5_wp, 1.0e-3_wp, 0.01999_wp, 0.02001_wp, 0.05_wp, 0.3_wp, 1.0_wp, 1.7_wp]
      !> Round-off of g; g' in the closed form divides it by 2 u once, g'' twice.
      real(wp), parameter :: tolerance_g = 1.0e-15_wp, tolerance_dg = 1.0e-13_wp, tolerance_ddg = 1.0e-11_wp
      real(wp), dimension(size(u)) :: g, dg, ddg
      real(qp) :: c, s, exact, d_exact, dd_exact
      integer :: i
      call angle_ratios(size(u), 1.0_wp - u, g, dg, ddg)
      do i = 1, size(u)
         c = real(1.0_wp - u(i), qp)
         s = (1.0_qp - c)*(1.0_qp + c)
         exact = acos(c)/sqrt(s)
         d_exact = (exact*c - 1.0_qp)/s
         dd_exact = (3.0_qp*c*d_exact + exact)/s
         call assertLessThan(abs(real(g(i)/exact - 1.0_qp, wp)), tolerance_g, message='ratio')
         call assertLessThan(abs(real(dg(i)/d_exact - 1.0_qp, wp)), tolerance_dg, message='first derivative')
         call assertLessThan(abs(real(ddg(i)/dd_exact - 1.0_qp, wp)), tolerance_ddg, message='second derivative')
      end do
   end subroutine test_ratio_and_derivatives

   !> Round-off may put the cosine of two unit vectors above one: nothing happens there.
   subroutine test_beyond_one()
      real(wp) :: g(1), dg(1), ddg(1)
      call angle_ratios(1, [1.0_wp + 4.0_wp*epsilon(1.0_wp)], g, dg, ddg)
      call assertEqual(1.0_wp, g(1), 1.0e-15_wp, message='ratio')
      call assertEqual(-1.0_wp/3.0_wp, dg(1), 1.0e-15_wp, message='first derivative')
      call assertEqual(4.0_wp/15.0_wp, ddg(1), 1.0e-15_wp, message='second derivative')
   end subroutine test_beyond_one
end module dg_test_beam_angle
