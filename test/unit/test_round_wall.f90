!> Turns of nodes about the hole axis (dg_round_wall).
module dg_test_round_wall
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_round_wall, only: round_move, turned_part
   implicit none
   private
   public :: round_wall_suite

contains

   function round_wall_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('round_wall')
      call suite%addTest(TestMethod('stays_on_wall', test_stays_on_wall))
      call suite%addTest(TestMethod('slope', test_slope))
      call suite%addTest(TestMethod('part', test_part))
   end function round_wall_suite

   !> A whole turn along the wall keeps the distance from the axis; without a part the move is straight.
   subroutine test_stays_on_wall()
      real(wp), parameter :: offset(2) = [0.03_wp, 0.04_wp], move(2) = [-0.008_wp, 0.006_wp]
      real(wp) :: moved(2), slope(2)
      slope = 0.0_wp
      call round_move([1.0_wp, 0.0_wp], offset, move, [0.0_wp, 0.0_wp], moved, slope)
      call assertEqual(0.05_wp, norm2(offset + moved), tolerance=1.0e-15_wp, message='distance')
      call round_move([0.0_wp, 0.0_wp], offset, move, [0.0_wp, 0.0_wp], moved, slope)
      call assertEqual(move(1), moved(1), message='straight')
      call assertEqual(move(2), moved(2), message='straight')
   end subroutine test_stays_on_wall

   !> The slope of a moved node is the derivative of the moved places, as the slope of a beam must be: by central differences, on a
   !> line that passes near the axis, with large moves and a part that grows along it.
   subroutine test_slope()
      real(wp), parameter :: h = 1.0e-5_wp, beside(3) = [-1.0_wp, 1.0_wp, 0.0_wp]
      real(wp) :: place(2, 3), moved(2), slope(2), s, worst
      integer :: i, k
      worst = 0.0_wp
      do i = 0, 20
         do k = 1, 3                                     ! at last the place between the two others
            s = 0.1_wp*i + beside(k)*h
            slope = line_slope(s)
            call round_move([part(s), 0.3_wp*cos(s)], line(s), step(s), step_slope(s), moved, slope)
            place(:, k) = line(s) + moved
         end do
         worst = max(worst, norm2(slope - (place(:, 2) - place(:, 1))/(2.0_wp*h)))
      end do
      call assertLessThan(worst, 1.0e-8_wp, message='slope')

   contains

      pure function line(s) result(f)
         real(wp), intent(in) :: s
         real(wp) :: f(2)
         f = [0.02_wp*(s - 1.0_wp), 0.01_wp + 0.005_wp*s**2]
      end function line

      pure function line_slope(s) result(f)
         real(wp), intent(in) :: s
         real(wp) :: f(2)
         f = [0.02_wp, 0.01_wp*s]
      end function line_slope

      pure function step(s) result(m)
         real(wp), intent(in) :: s
         real(wp) :: m(2)
         m = [0.01_wp*sin(2.0_wp*s), 0.008_wp*cos(s)]
      end function step

      pure function step_slope(s) result(m)
         real(wp), intent(in) :: s
         real(wp) :: m(2)
         m = [0.02_wp*cos(2.0_wp*s), -0.008_wp*sin(s)]
      end function step_slope

      pure function part(s) result(p)
         real(wp), intent(in) :: s
         real(wp) :: p
         p = 0.4_wp + 0.3_wp*sin(s)
      end function part
   end subroutine test_slope

   !> Next to a place on the axis nodes on the wall hardly turn; five metres away they do.
   subroutine test_part()
      real(wp) :: offset(2, 101), part(2, 101)
      offset(1, :) = 0.05_wp
      offset(2, :) = 0.0_wp
      offset(1, 51) = 0.0_wp
      part = turned_part(offset, spread(0.05_wp, 1, 100), spread(0.1_wp, 1, 100))
      call assertEqual(0.0_wp, part(1, 51), message='on the axis')
      call assertLessThan(part(1, 52), 1.0e-4_wp, message='next to it')
      call assertEqual(1.0_wp, part(1, 101), tolerance=1.0e-12_wp, message='five metres away')
      call assertLessThan(maxval(abs(part(2, :))), 0.4_wp, message='it grows slowly')
   end subroutine test_part
end module dg_test_round_wall
