!> Hole axis from a cubic spline of the tangent. Curvature and its rate of change are continuous through the stations, where
!> minimum curvature jumps. The spline is converted to closely spaced tangents, between which minimum curvature is as good as
!> exact. All other code then has arcs only.
module dg_spline_path
   use dg_kinds, only: wp
   use dg_minimum_curvature, only: dogleg_between
   use dg_survey, only: unit
   implicit none
   private
   public :: resample_spline, second_derivatives

   !> Longest arc of the resampled path [m]. An arc in place of a curve whose curvature changes at the rate q deviates by q
   !> h^3/72/sqrt(3). For a build rate of 3 deg/30 m reached within 30 m that is 4 micrometres at h = 2 m. That is far below
   !> any clearance, and a 15 km well needs no more than 7500 arcs.
   real(wp), parameter :: longest_arc = 2.0_wp
   !> Largest angle of a resampled arc [rad], for strong bends between close stations.
   real(wp), parameter :: largest_angle = 0.02_wp
   !> Shortest interpolated tangent that may be normalised [-]. A path that turns by less than 90 deg from station to station
   !> stays above 0.7.
   real(wp), parameter :: shortest_tangent = 0.05_wp

contains

   !> Tangents of the spline through station tangents, at the stations and between. `usable` is false if the stations turn so
   !> sharply that the spline passes near zero.
   pure subroutine resample_spline(md, tangents, fine_md, fine_tangents, usable)
      real(wp), intent(in) :: md(:)                            !< increasing [m]
      real(wp), intent(in) :: tangents(:, :)                   !< (3, size(md)), unit
      real(wp), allocatable, intent(out) :: fine_md(:)         !< [m]
      real(wp), allocatable, intent(out) :: fine_tangents(:, :) !< (3, size(fine_md)), unit
      logical, intent(out) :: usable
      integer :: parts(size(md) - 1)
      real(wp) :: bend(3, size(md)), h, x, y, value(3)
      integer :: i, j, k
      do i = 1, size(parts)
         parts(i) = max(ceiling((md(i + 1) - md(i))/longest_arc), &
                        ceiling(dogleg_between(tangents(:, i), tangents(:, i + 1))/largest_angle), 1)
      end do
      do k = 1, 3
         bend(k, :) = second_derivatives(md, tangents(k, :))
      end do
      allocate (fine_md(sum(parts) + 1), fine_tangents(3, sum(parts) + 1))
      usable = .true.
      k = 0
      do i = 1, size(parts)
         h = md(i + 1) - md(i)
         do j = 0, parts(i) - 1
            k = k + 1
            fine_md(k) = md(i) + h*real(j, wp)/real(parts(i), wp)
            fine_tangents(:, k) = tangents(:, i)
            if (j == 0) cycle
            x = real(parts(i) - j, wp)/real(parts(i), wp)
            y = real(j, wp)/real(parts(i), wp)
            value = x*tangents(:, i) + y*tangents(:, i + 1) &
                    + (h*h/6.0_wp)*((x**3 - x)*bend(:, i) + (y**3 - y)*bend(:, i + 1))
            if (sqrt(dot_product(value, value)) > shortest_tangent) then
               fine_tangents(:, k) = unit(value)
            else
               usable = .false.
            end if
         end do
      end do
      fine_md(k + 1) = md(size(md))
      fine_tangents(:, k + 1) = tangents(:, size(md))
   end subroutine resample_spline

   !> Second derivatives at the knots of the natural cubic spline through (x, y). The system is symmetric, diagonally dominant
   !> and tridiagonal, and is eliminated without exchange of rows (de Boor 1978, chapter IV).
   pure function second_derivatives(x, y) result(bend)
      real(wp), intent(in) :: x(:)  !< increasing
      real(wp), intent(in) :: y(:)
      real(wp) :: bend(size(x))
      real(wp) :: diagonal(size(x)), factor, h, h_next
      integer :: i, n
      n = size(x)
      bend = 0.0_wp
      if (n < 3) return
      do i = 2, n - 1
         h = x(i) - x(i - 1)
         h_next = x(i + 1) - x(i)
         diagonal(i) = (h + h_next)/3.0_wp
         bend(i) = (y(i + 1) - y(i))/h_next - (y(i) - y(i - 1))/h
         if (i == 2) cycle
         factor = (h/6.0_wp)/diagonal(i - 1)
         diagonal(i) = diagonal(i) - factor*h/6.0_wp
         bend(i) = bend(i) - factor*bend(i - 1)
      end do
      bend(n - 1) = bend(n - 1)/diagonal(n - 1)
      do i = n - 2, 2, -1
         bend(i) = (bend(i) - (x(i + 1) - x(i))/6.0_wp*bend(i + 1))/diagonal(i)
      end do
   end function second_derivatives
end module dg_spline_path
