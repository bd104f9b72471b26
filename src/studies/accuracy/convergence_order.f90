!> Order of convergence from differences to the finest of several solutions.
module dg_convergence_order
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: fit_order

   !> Orders that are looked at [-]: beyond them points do not tell one.
   real(wp), parameter :: lowest_order = 0.1_wp, highest_order = 8.0_wp
   real(wp), parameter :: order_step = 0.01_wp

contains

   !> The order p of values v(h) = v(0) + C h^p that best fits the differences |v(h) - v(h_finest)| = |C| (h^p - h_finest^p):
   !> least squares of their logarithms. So the finest solution's own error, which would raise the order of the points near
   !> it, is taken into account. `missing` where fewer than two points stand out, or no order within 0.1 and 8 fits best.
   pure subroutine fit_order(lengths, differences, finest, floor, order)
      real(wp), intent(in) :: lengths(:)      !< h [m]
      real(wp), intent(in) :: differences(:)  !< >= 0, in any unit
      real(wp), intent(in) :: finest          !< h of the finest solution [m]
      real(wp), intent(in) :: floor           !< differences up to this are round-off
      real(wp), intent(out) :: order
      logical :: used(size(lengths))
      real(wp) :: p, spread, least, mean
      real(wp), allocatable :: h(:), d(:), r(:)
      integer :: step, steps, n
      order = missing
      used = lengths > finest*(1.0_wp + 1.0e-6_wp) .and. differences > floor
      n = count(used)
      if (n < 2) return
      allocate (h(n), d(n), r(n))
      h = pack(lengths, used)
      d = pack(differences, used)
      if (.not. maxval(h) > minval(h)*(1.0_wp + 1.0e-6_wp)) return
      steps = nint((highest_order - lowest_order)/order_step)
      least = huge(least)
      do step = 0, steps
         p = lowest_order + step*order_step
         r = log(d) - log(h**p - finest**p)
         mean = sum(r)/n
         spread = sum((r - mean)**2)
         if (spread >= least) cycle
         least = spread
         order = p
         if (step == 0 .or. step == steps) order = missing
      end do
   end subroutine fit_order
end module dg_convergence_order
