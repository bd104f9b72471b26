!> Where in its element the gap element sits: x0, the extremum of the lateral displacement (Eqs. 1 and 2).
module dg_gap_location
   use dg_kinds, only: wp
   use dg_hermite, only: hermite_value
   implicit none
   private
   public :: extremum_of_displacement

   !> Places where the displacement is sampled before the largest is refined: a cubic in each plane has at most
   !> five extrema of its magnitude, so eight intervals separate those that matter.
   integer, parameter :: intervals = 8
   integer :: sample
   real(wp), parameter :: sampled(0:intervals) = [(real(sample, wp)/intervals, sample=0, intervals)]
   !> Hermite's shape functions there of an element of unit length.
   real(wp), parameter :: offset_i(0:intervals) = (1.0_wp - sampled)**2*(1.0_wp + 2.0_wp*sampled)
   real(wp), parameter :: slope_of_i(0:intervals) = (1.0_wp - sampled)**2*sampled
   real(wp), parameter :: offset_j(0:intervals) = sampled**2*(1.0_wp + 2.0_wp*(1.0_wp - sampled))
   real(wp), parameter :: slope_of_j(0:intervals) = -sampled**2*(1.0_wp - sampled)

contains

   !> xi0 = x0/L in 0..1 where the lateral displacement |f_G(x)| is largest, and that displacement [m].
   !> f_G = N_G d_e from the offsets of the nodes off the hole axis and their slopes against it, all in space
   !> axes and across the hole.
   pure subroutine extremum_of_displacement(gap_i, slope_i, gap_j, slope_j, length, xi, displacement)
      real(wp), intent(in) :: gap_i(3), gap_j(3)     !< offsets [m]
      real(wp), intent(in) :: slope_i(3), slope_j(3) !< d - t [-]
      real(wp), intent(in) :: length                 !< [m]
      real(wp), intent(out) :: xi
      real(wp), intent(out) :: displacement
      real(wp) :: square(0:intervals), turn_i(0:intervals), turn_j(0:intervals), n(4), f(3), left, right, curvature, shift
      integer :: i, best
      turn_i = slope_of_i*length
      turn_j = slope_of_j*length
      square = 0.0_wp
      do i = 1, 3
         square = square + (offset_i*gap_i(i) + turn_i*slope_i(i) + offset_j*gap_j(i) + turn_j*slope_j(i))**2
      end do
      best = maxloc(square, dim=1) - 1
      xi = real(best, wp)/intervals
      if (best > 0 .and. best < intervals) then       ! parabola through the three largest
         left = square(best - 1) - square(best)
         right = square(best + 1) - square(best)
         curvature = left + right
         if (curvature < 0.0_wp) then
            shift = 0.5_wp*(left - right)/curvature
            xi = xi + shift/intervals
         end if
      end if
      n = hermite_value(xi, length)
      f = n(1)*gap_i + n(2)*slope_i + n(3)*gap_j + n(4)*slope_j
      displacement = norm2(f)
      if (displacement**2 < square(best)) then        ! the parabola missed: keep the sample
         xi = real(best, wp)/intervals
         displacement = sqrt(square(best))
      end if
   end subroutine extremum_of_displacement
end module dg_gap_location
