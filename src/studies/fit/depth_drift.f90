!> Drift of errors with depth, and its effect on predictions below the data.
!>
!> Some model errors grow with depth: a friction that changes, a wrong weight per metre. Errors of an operation are
!> e = scatter + b (depth - mean depth), with a rate b of its own. Rates follow from the residuals by least squares, beside the
!> fitted unknowns. The part of a drift that the unknowns absorb is therefore included. The variance of the rates is the mean
!> of b^2 over operations, less the median of its part by scatter. That part is var b times chi-square over its freedom (Wilson
!> & Hilferty 1931). The variance is never negative. Half of the fits of data without a drift thus find one. With the mean in
!> place of the median, intervals hold less of the data if a drift is hardly visible.
module dg_depth_drift
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_variance_components, only: invert_normal, spare_of
   implicit none
   private
   public :: drift_type, find_drift, with_drift

   !> Least number of data of a group with a drift: with fewer, chance makes one too often.
   integer, parameter :: least_data = 5

   type :: drift_type
      real(wp) :: rate = 0.0_wp       !< standard deviation of the rates [N/m or N.m/m]; 0: none is found
      real(wp) :: centre = missing    !< mean depth of the data [m]
      logical :: visible = .false.    !< the data are enough to find one
   end type drift_type

contains

   !> Find the drift of one kind of data. It is not found if data are few, or if the unknowns alone can follow it.
   pure subroutine find_drift(jacobian, residual, deviation, depth, group, drift)
      real(wp), intent(in) :: jacobian(:, :)     !< (data, unknowns found), over the deviations
      real(wp), intent(in) :: residual(:)        !< over the deviations [-]
      real(wp), intent(in) :: deviation(:)       !< of each datum [N or N.m]; 0 for data of another kind
      real(wp), intent(in) :: depth(:)           !< [m]
      integer, intent(in) :: group(:)            !< operation and kind of each datum
      type(drift_type), intent(out) :: drift
      real(wp), allocatable :: both(:, :), inverse(:, :), found(:)
      real(wp) :: column(size(depth)), excess, chance, scatter, spare, left(size(depth))
      integer :: g, k, first, rates
      logical :: among(size(depth)), kind(size(depth)), regular
      kind = deviation > 0.0_wp
      if (.not. any(kind)) return
      drift%centre = sum(depth, mask=kind)/real(count(kind), wp)
      both = jacobian
      first = size(jacobian, 2)
      do g = minval(group), maxval(group)
         among = kind .and. group == g
         if (count(among) < least_data) cycle
         column = 0.0_wp
         where (among) column = (depth - sum(depth, mask=among)/real(count(among), wp))/deviation
         if (norm2(column) <= 0.0_wp) cycle
         both = reshape([both, column], [size(depth), size(both, 2) + 1])
      end do
      rates = size(both, 2) - first
      if (rates == 0 .or. size(depth) <= size(both, 2)) return
      allocate (inverse(size(both, 2), size(both, 2)))
      call invert_normal(both, inverse, regular)
      if (.not. regular) return
      found = matmul(inverse, matmul(residual, both))
      left = residual - matmul(both, found)
      spare = spare_of(both, inverse, kind)
      if (spare < 1.0_wp) return
      scatter = sum(left**2, mask=kind)/spare
      drift%visible = .true.
      chance = (1.0_wp - 2.0_wp/(9.0_wp*real(rates, wp)))**3
      excess = 0.0_wp
      do k = first + 1, first + rates
         excess = excess + (found(k)**2 - chance*scatter*inverse(k, k))/real(rates, wp)
      end do
      drift%rate = sqrt(max(excess, 0.0_wp))
   end subroutine find_drift

   !> Standard deviation of a measurement at a depth, with the effect of the drift there [N or N.m].
   elemental function with_drift(deviation, drift, depth) result(wider)
      real(wp), intent(in) :: deviation    !< without it [N or N.m]
      type(drift_type), intent(in) :: drift
      real(wp), intent(in) :: depth        !< [m]
      real(wp) :: wider
      wider = deviation
      if (drift%rate > 0.0_wp) wider = hypot(deviation, drift%rate*(depth - drift%centre))
   end function with_drift
end module dg_depth_drift
