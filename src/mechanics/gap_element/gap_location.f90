!> Place of the gap element in its element: x0, the extremum of the lateral displacement (Eqs. 1 and 2).
module dg_gap_location
   use dg_kinds, only: wp
   implicit none
   private
   public :: extremum_of_displacement, bend_of_displacement

   !> Number of intervals between samples of the displacement, before the largest is refined. The magnitude of a cubic in each
   !> plane has at most five extrema, so that eight intervals separate those that matter.
   integer, parameter :: intervals = 8, half = intervals/2
   !> Squares that differ by less than this part are equal [-]. Where a string is straight along its wall its gap thus stays in
   !> the middle.
   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   !> Place xi0 = x0/L in 0..1 of the largest lateral displacement |f_G(x)|, and that displacement [m]. f_G = N_G d_e follows
   !> from the offsets of the nodes from the hole axis and their slopes against it. All are in space axes and across the hole.
   pure subroutine extremum_of_displacement(gap_i, slope_i, gap_j, slope_j, length, xi, displacement)
      real(wp), intent(in) :: gap_i(3), gap_j(3)     !< offsets [m]
      real(wp), intent(in) :: slope_i(3), slope_j(3) !< d - t [-]
      real(wp), intent(in) :: length                 !< [m]
      real(wp), intent(out) :: xi                    !< 0 to 1 [-]
      real(wp), intent(out) :: displacement          !< >= 0 [m]
      real(wp) :: square(-half:half), even_1(3), even_2(3), odd_1(3), odd_2(3), a(3), b(3), f(3), left, right, curvature, t, bar
      integer :: k, best
      ! The cubic from the middle of the element: f = even + odd t, both linear in t**2, t from -1 to 1. Two places at +-t
      ! share them.
      even_2 = (0.125_wp*length)*(slope_j - slope_i)
      even_1 = 0.5_wp*(gap_i + gap_j) - even_2
      odd_2 = (0.125_wp*length)*(slope_i + slope_j) - 0.25_wp*(gap_j - gap_i)
      odd_1 = 0.5_wp*(gap_j - gap_i) - odd_2
      square(-half) = gap_i(1)*gap_i(1) + gap_i(2)*gap_i(2) + gap_i(3)*gap_i(3)
      square(half) = gap_j(1)*gap_j(1) + gap_j(2)*gap_j(2) + gap_j(3)*gap_j(3)
      square(0) = even_1(1)*even_1(1) + even_1(2)*even_1(2) + even_1(3)*even_1(3)
      do k = 1, half - 1
         t = real(k, wp)/half
         a = even_1 + t*t*even_2
         b = t*odd_1 + t*t*t*odd_2
         f = a - b
         square(-k) = f(1)*f(1) + f(2)*f(2) + f(3)*f(3)
         f = a + b
         square(k) = f(1)*f(1) + f(2)*f(2) + f(3)*f(3)
      end do
      best = 0
      bar = (1.0_wp + round_off)*square(0)
      do k = -half, half
         if (square(k) > bar) then
            best = k
            bar = (1.0_wp + round_off)*square(k)
         end if
      end do
      t = real(best, wp)/half
      if (abs(best) < half) then                      ! parabola through the three largest
         left = square(best - 1) - square(best)
         right = square(best + 1) - square(best)
         curvature = left + right
         if (curvature < -round_off*square(best)) t = t + 0.5_wp*(left - right)/(curvature*half)
      end if
      f = even_1 + t*t*even_2 + t*(odd_1 + t*t*odd_2)
      displacement = f(1)*f(1) + f(2)*f(2) + f(3)*f(3)
      if (displacement < square(best)) then           ! the parabola missed: keep the sample
         t = real(best, wp)/half
         displacement = square(best)
      end if
      xi = 0.5_wp + 0.5_wp*t
      displacement = sqrt(displacement)
   end subroutine extremum_of_displacement

   !> Curvature -d2|f_G|/dxi2 at xi of the same element [m].
   pure function bend_of_displacement(gap_i, slope_i, gap_j, slope_j, length, xi) result(bend)
      real(wp), intent(in) :: gap_i(3), gap_j(3)       !< as in extremum_of_displacement [m]
      real(wp), intent(in) :: slope_i(3), slope_j(3)   !< as in extremum_of_displacement [-]
      real(wp), intent(in) :: length, xi               !< [m], [-]
      real(wp) :: bend
      real(wp) :: linear(3), square(3), cubic(3), f(3), first(3), second(3)
      linear = length*slope_i
      cubic = 2.0_wp*(gap_i - gap_j) + length*(slope_i + slope_j)
      square = gap_j - gap_i - linear - cubic
      f = gap_i + xi*(linear + xi*(square + xi*cubic))
      first = linear + xi*(2.0_wp*square + 3.0_wp*xi*cubic)
      second = 2.0_wp*square + 6.0_wp*xi*cubic
      bend = (dot_product(f, first)**2/dot_product(f, f) - dot_product(first, first) - dot_product(f, second))/norm2(f)
   end function bend_of_displacement
end module dg_gap_location
