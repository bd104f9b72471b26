!> Least squares with data of several kinds, whose deviations the residuals tell.
module dg_fit_by_kinds
   use dg_kinds, only: wp
   use dg_interruption, only: is_interrupted
   use dg_least_squares, only: fit_done, fit_from_less, fit_least_squares, fit_type, fit_without_values, &
                               measured_function_type, unknowns_type
   use dg_variance_components, only: estimate_factors
   implicit none
   private
   public :: fit_by_kinds, free_unknowns

   !> Fits with deviations found anew, at most; what they change by at rest [-].
   integer, parameter :: most_rounds = 8
   real(wp), parameter :: at_rest = 1.0e-3_wp

contains

   !> As fit_from_less. If data have variances of more than one kind, or variances beside known deviations, each kind's
   !> deviation is found from the residuals. The fit is then repeated with them. One kind alone needs no weights.
   subroutine fit_by_kinds(function, unknowns, measured, kinds, deviation, fit, halvings)
      class(measured_function_type), intent(inout) :: function
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: measured(:)
      integer, intent(in) :: kinds(:)          !< number of each datum's variance; 0 where its deviation is known
      real(wp), intent(inout) :: deviation(:)  !< on return those that the intervals go by, but where there is one kind alone
      type(fit_type), intent(out) :: fit
      integer, intent(out) :: halvings
      type(fit_type) :: again
      real(wp) :: changed
      integer :: round
      call fit_from_less(function, unknowns, measured, deviation, fit, halvings)
      if (all(kinds == kinds(1))) return
      do round = 1, most_rounds
         if (fit%status /= fit_done .or. is_interrupted()) return
         call weigh_anew(measured, kinds, deviation, fit, changed)
         if (changed <= at_rest) return
         call fit_least_squares(function, fit%unknowns, unknowns%lower, unknowns%upper, unknowns%scale, measured, deviation, again)
         again%iterations = again%iterations + fit%iterations
         fit = again
      end do
   end subroutine fit_by_kinds

   !> Deviations of each kind of data by the residuals of the fit, whose Jacobian is over them on return.
   subroutine weigh_anew(measured, kinds, deviation, fit, changed)
      real(wp), intent(in) :: measured(:)
      integer, intent(in) :: kinds(:)
      real(wp), intent(inout) :: deviation(:)
      type(fit_type), intent(inout) :: fit
      real(wp), intent(out) :: changed         !< largest change over what a deviation was [-]
      real(wp) :: factors(maxval(kinds))
      integer :: columns(count(free_unknowns(fit))), d, k
      columns = pack([(k, k=1, size(fit%unknowns))], free_unknowns(fit))
      call estimate_factors(fit%jacobian(:, columns), (fit%values - measured)/deviation, kinds, factors)
      changed = maxval(abs(factors - 1.0_wp))
      do d = 1, size(kinds)
         if (kinds(d) == 0) cycle
         deviation(d) = deviation(d)*factors(kinds(d))
         fit%jacobian(d, :) = fit%jacobian(d, :)/factors(kinds(d))
      end do
   end subroutine weigh_anew

   !> Unknowns that a fit was free to choose.
   pure function free_unknowns(fit) result(free)
      type(fit_type), intent(in) :: fit
      logical :: free(size(fit%unknowns))
      free = .not. (fit%at_bound .or. fit%unfelt) .and. fit%status /= fit_without_values
   end function free_unknowns
end module dg_fit_by_kinds
