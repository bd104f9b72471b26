!> Friction of hole sections from a calibration, for a Monte Carlo that continues from it.
module dg_learnt_friction
   use dg_kinds, only: wp
   use dg_calibration, only: calibration_type
   use dg_calibration_result, only: calibration_result_type
   use dg_fit_statistics, only: as_normal, student_quantile, upper_end
   use dg_missing, only: is_missing, missing
   implicit none
   private
   public :: half_widths_of, learn_friction

   !> Deviations and correlations are rounded as printed, so that a deck that repeats them draws the same.
   real(wp), parameter :: deviation_steps = 1.0e5_wp, correlation_steps = 1.0e4_wp

contains

   !> Standard deviations of the coefficients of all hole sections, and their correlations. Sections that share a factor vary
   !> together. Those without an unknown do not vary. A deviation is that of a normal distribution with the factor's 95 %
   !> interval. With few measurements it is larger than the fit's own. `known` is false if a section's factor has no interval.
   pure subroutine learn_friction(calibration, result, deviations, correlation, known)
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      real(wp), intent(out) :: deviations(:)         !< one a hole section of the deck [-]
      real(wp), intent(out) :: correlation(:, :)
      logical, intent(out) :: known
      integer :: unknown(size(deviations)), i, j
      unknown = unknowns_of(calibration, size(deviations))
      known = allocated(result%statistics%half_width) .and. any(unknown > 0)
      deviations = 0.0_wp
      correlation = 0.0_wp
      do i = 1, size(deviations)
         correlation(i, i) = 1.0_wp
         if (unknown(i) == 0 .or. .not. known) cycle
         associate (half => result%statistics%half_width(unknown(i)))
            known = .not. is_missing(half)
            if (known) deviations(i) = anint(deviation_steps*half/student_quantile(upper_end, as_normal))/deviation_steps
         end associate
         do j = 1, i - 1
            if (unknown(j) == 0) cycle
            correlation(i, j) = anint(correlation_steps*result%statistics%correlation(unknown(i), unknown(j)))/correlation_steps
            correlation(j, i) = correlation(i, j)
         end do
      end do
   end subroutine learn_friction

   !> Half of the 95 % interval of the coefficient of each hole section [-]. It is 0 if the coefficient was not an unknown or
   !> is not determined by the data. It is missing if it has no interval.
   pure function half_widths_of(calibration, result, sections) result(half_widths)
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: sections      !< of the hole
      real(wp) :: half_widths(sections)
      integer :: unknown(sections), i
      unknown = unknowns_of(calibration, sections)
      half_widths = 0.0_wp
      do i = 1, sections
         if (unknown(i) == 0) cycle
         if (result%fit%unfelt(unknown(i))) cycle
         half_widths(i) = missing
         if (allocated(result%statistics%half_width)) half_widths(i) = result%statistics%half_width(unknown(i))
      end do
   end function half_widths_of

   !> Number of the unknown that each hole section has as its coefficient; 0: none.
   pure function unknowns_of(calibration, sections) result(unknown)
      type(calibration_type), intent(in) :: calibration
      integer, intent(in) :: sections
      integer :: unknown(sections)
      integer :: j, u
      unknown = 0
      do j = 1, size(calibration%holes)
         do u = 1, size(calibration%unknowns)
            if (calibration%unknowns(u)%is_offset) cycle
            if (calibration%by_hole .and. calibration%unknowns(u)%hole /= calibration%holes(j)) cycle
            unknown(calibration%holes(j)) = u
         end do
      end do
   end function unknowns_of
end module dg_learnt_friction
