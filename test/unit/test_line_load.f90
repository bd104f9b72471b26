!> Forces and means of a load per length: the integral by hand, peaks of any width, ends of the string.
module dg_test_line_load
   use funit, only: assertEqual, assertRelativelyEqual, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_line_load, only: force_between, force_on_length, largest_mean
   implicit none
   private
   public :: line_load_suite

   real(wp), parameter :: rounding = 1.0e-12_wp

contains

   function line_load_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('line_load')
      call suite%addTest(TestMethod('force_on_length', test_force))
      call suite%addTest(TestMethod('mean_of_a_peak', test_peak))
      call suite%addTest(TestMethod('mean_at_an_end', test_end))
      call suite%addTest(TestMethod('mean_of_a_step', test_step))
      call suite%addTest(TestMethod('mean_of_no_load', test_none))
   end function line_load_suite

   !> A load that grows with depth, 2 + 3 s: its integral by hand. Ends of the string cut the length.
   subroutine test_force()
      real(wp), parameter :: md(5) = [0.0_wp, 1.0_wp, 4.0_wp, 4.0_wp, 10.0_wp]
      real(wp), parameter :: load(5) = 2.0_wp + 3.0_wp*md
      call assertEqual([whole(0.0_wp, 1.0_wp), whole(2.0_wp, 4.0_wp), whole(3.0_wp, 5.0_wp), whole(9.0_wp, 10.0_wp)], &
                       force_on_length(md, load, 2.0_wp, [0.0_wp, 3.0_wp, 4.0_wp, 10.0_wp]), rounding)
      call assertEqual([whole(0.0_wp, 0.5_wp), whole(3.0_wp, 9.0_wp)], &
                       force_between(md, load, [-1.0_wp, 3.0_wp], [0.5_wp, 9.0_wp]), rounding, message='between two depths')
   contains
      pure function whole(from, to) result(force)
         real(wp), intent(in) :: from, to
         real(wp) :: force
         force = 2.0_wp*(to - from) + 1.5_wp*(to**2 - from**2)
      end function whole
   end subroutine test_force

   !> 5 kN at 20 m, on a millimetre or on half a metre, in a string of 100 m that presses with 100 N/m: on 10 m of string they have
   !> a mean of 500 N/m. An edge has two rows at one depth, of which the lower one has all of it.
   subroutine test_peak()
      real(wp), parameter :: force = 5.0e3_wp, place = 20.0_wp, plain = 100.0_wp, widths(3) = [2.0_wp**(-10), 0.125_wp, 0.5_wp]
      real(wp) :: mean
      integer :: i, row
      do i = 1, size(widths)
         associate (half => 0.5_wp*widths(i))
            call largest_mean([0.0_wp, place - half, place, place + half, 100.0_wp], &
                              plain + [0.0_wp, 0.0_wp, force/half, 0.0_wp, 0.0_wp], 10.0_wp, mean, row)
            call assertRelativelyEqual(600.0_wp, mean, rounding)
            call assertEqual(3, row)
            call largest_mean([0.0_wp, place, place, place + half, 100.0_wp], &
                              plain + [0.0_wp, 0.0_wp, 2.0_wp*force/half, 0.0_wp, 0.0_wp], 10.0_wp, mean, row)
            call assertRelativelyEqual(600.0_wp, mean, rounding, message='edge')
            call assertEqual(3, row, message='edge')
         end associate
      end do
   end subroutine test_peak

   !> A load that grows with depth has its largest mean on the last metres; a string shorter than the length that of all of it.
   subroutine test_end()
      real(wp), parameter :: md(3) = [1000.0_wp, 1003.0_wp, 1010.0_wp], load(3) = 2.0_wp + 3.0_wp*(md - 1000.0_wp)
      real(wp) :: mean
      integer :: row
      call largest_mean(md, load, 2.0_wp, mean, row)
      call assertRelativelyEqual(29.0_wp, mean, rounding)
      call assertEqual(3, row)
      call largest_mean(md, load, 20.0_wp, mean, row)
      call assertRelativelyEqual(17.0_wp, mean, rounding, message='short string')
      call assertEqual(3, row)
   end subroutine test_end

   !> 300 N/m on 2 m, and nothing above and below: a length of 2 m is found although no row stands in its middle. Of equal ones the
   !> first counts.
   subroutine test_step()
      real(wp), parameter :: md(6) = [0.0_wp, 5.0_wp, 5.0_wp, 7.0_wp, 7.0_wp, 20.0_wp]
      real(wp) :: mean
      integer :: row
      call largest_mean(md, [0.0_wp, 0.0_wp, 300.0_wp, 300.0_wp, 0.0_wp, 0.0_wp], 2.0_wp, mean, row)
      call assertRelativelyEqual(300.0_wp, mean, rounding)
      call assertEqual(3, row)
      call largest_mean([0.0_wp, 30.0_wp, 60.0_wp, 90.0_wp], [7.0_wp, 7.0_wp, 7.0_wp, 7.0_wp], 9.0_wp, mean, row)
      call assertRelativelyEqual(7.0_wp, mean, rounding)
      call assertEqual(1, row, message='the first')
   end subroutine test_step

   subroutine test_none()
      real(wp) :: mean
      integer :: row
      call largest_mean([0.0_wp, 30.0_wp], [0.0_wp, 0.0_wp], 9.5_wp, mean, row)
      call assertEqual(0.0_wp, mean)
      call assertEqual(1, row)
   end subroutine test_none
end module dg_test_line_load
