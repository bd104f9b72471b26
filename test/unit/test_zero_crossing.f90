!> Zeros of a moment between rows of a profile.
module dg_test_zero_crossing
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_zero_crossing, only: add_zeros
   implicit none
   private
   public :: zero_crossing_suite

contains

   function zero_crossing_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('zero_crossing')
      call suite%addTest(TestMethod('crossing', test_crossing))
      call suite%addTest(TestMethod('no_crossing', test_no_crossing))
   end function zero_crossing_suite

   !> A moment of 3 - 2 x by a shear force of 2: zero at 1.5.
   subroutine test_crossing()
      real(wp), allocatable :: md(:), moment(:)
      md = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp]
      moment = abs(3.0_wp - 2.0_wp*md)
      call add_zeros(md, moment, spread(2.0_wp, 1, 4))
      call assertEqual(5, size(md))
      call assertEqual(1.5_wp, md(3), tolerance=1.0e-12_wp)
      call assertEqual(0.0_wp, moment(3), tolerance=1.0e-12_wp)
   end subroutine test_crossing

   !> A least moment that is not zero: a parabola, 1 + x**2 / 2; one that turns about the string; one that is zero at a row.
   subroutine test_no_crossing()
      real(wp), allocatable :: md(:), moment(:)
      md = [-1.5_wp, -0.5_wp, 0.5_wp, 1.5_wp]
      moment = 1.0_wp + 0.5_wp*md**2
      call add_zeros(md, moment, abs(md))
      call assertEqual(4, size(md), message='parabola')
      moment = spread(1.0_wp, 1, 4)
      call add_zeros(md, moment, spread(1.0_wp, 1, 4))
      call assertEqual(4, size(md), message='turning')
      moment = [2.0_wp, 1.0_wp, 0.0_wp, 1.0_wp]
      call add_zeros(md, moment, spread(1.0_wp, 1, 4))
      call assertEqual(4, size(md), message='zero at a row')
   end subroutine test_no_crossing
end module dg_test_zero_crossing
