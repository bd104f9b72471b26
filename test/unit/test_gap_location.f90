!> x0 of Eq. 2 against a fine search.
module dg_test_gap_location
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_gap_location, only: extremum_of_displacement
   use dg_hermite, only: hermite_value
   use dg_kinds, only: wp
   implicit none
   private
   public :: gap_location_suite

   real(wp), parameter :: length = 10.0_wp

contains

   function gap_location_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('gap_location')
      call suite%addTest(TestMethod('fine_search', test_fine_search))
      call suite%addTest(TestMethod('middle_of_a_bow', test_middle_of_a_bow))
      call suite%addTest(TestMethod('at_an_end', test_at_an_end))
      call suite%addTest(TestMethod('straight_along_the_wall', test_straight))
   end function gap_location_suite

   !> Displacements of a hundred shapes; the place counts only through the displacement that is missed there, which
   !> the paper's purpose (first contact) asks for. Samples an eighth apart and one parabola: seen 1.2e-3, where
   !> a kink of |f| (string crossing the axis) stands beside the extremum.
   subroutine test_fine_search()
      real(wp), parameter :: missed = 5.0e-3_wp
      integer, parameter :: shapes = 100, fine = 4000
      real(wp) :: y(3, 4), xi, displacement, largest, f(3), worst
      integer :: i, k
      worst = 0.0_wp
      do i = 1, shapes
         y = reshape([(0.05_wp*sin(real(i*k*k + 3*k, wp)), k=1, 12)], [3, 4])
         y(:, [2, 4]) = y(:, [2, 4])*0.4_wp
         call extremum_of_displacement(y(:, 1), y(:, 2), y(:, 3), y(:, 4), length, xi, displacement)
         largest = 0.0_wp
         do k = 0, fine
            f = matmul(y, hermite_value(real(k, wp)/fine, length))
            largest = max(largest, norm2(f))
         end do
         f = matmul(y, hermite_value(xi, length))
         call assertEqual(norm2(f), displacement, 1.0e-15_wp, message='displacement is that of the place')
         worst = max(worst, 1.0_wp - displacement/largest)
      end do
      call assertLessThan(worst, missed, message='displacement missed')
   end subroutine test_fine_search

   !> Ends held on the axis at slope +-a: f = a x (1 - x/L), largest a L/4 in the middle.
   subroutine test_middle_of_a_bow()
      real(wp), parameter :: a(3) = [0.0_wp, 0.02_wp, 0.0_wp], zero(3) = [0.0_wp, 0.0_wp, 0.0_wp]
      real(wp) :: xi, displacement
      call extremum_of_displacement(zero, a, zero, -a, length, xi, displacement)
      call assertEqual(0.5_wp, xi, 1.0e-14_wp)
      call assertEqual(0.02_wp*length/4.0_wp, displacement, 1.0e-15_wp)
   end subroutine test_middle_of_a_bow

   subroutine test_at_an_end()
      real(wp), parameter :: f(3) = [0.0_wp, 0.0_wp, 0.04_wp], zero(3) = [0.0_wp, 0.0_wp, 0.0_wp]
      real(wp) :: xi, displacement
      call extremum_of_displacement(zero, f/length, f, f/length, length, xi, displacement)
      call assertEqual(1.0_wp, xi)
      call assertEqual(0.04_wp, displacement, 1.0e-16_wp)
      call extremum_of_displacement(f, -f/length, zero, -f/length, length, xi, displacement)
      call assertEqual(0.0_wp, xi)
   end subroutine test_at_an_end

   !> Everywhere as deep: any place will do, but it must be one within the element.
   subroutine test_straight()
      real(wp), parameter :: f(3) = [0.03_wp, 0.0_wp, 0.04_wp], zero(3) = [0.0_wp, 0.0_wp, 0.0_wp]
      real(wp) :: xi, displacement
      call extremum_of_displacement(f, zero, f, zero, length, xi, displacement)
      call assertEqual(0.05_wp, displacement, 1.0e-16_wp)
      call assertLessThan(abs(xi - 0.5_wp), 0.5_wp + epsilon(xi))
   end subroutine test_straight
end module dg_test_gap_location
