!> Result of a calibration with one model. SI units.
module dg_calibration_result
   use dg_kinds, only: wp
   use dg_depth_correlation, only: find_succession, scatter_along, succession_type, widen_intervals
   use dg_depth_drift, only: drift_type, find_drift
   use dg_fit_statistics, only: find_statistics, statistics_type
   use dg_fit_by_kinds, only: free_unknowns
   use dg_kinds_apart, only: are_apart
   use dg_least_squares, only: fit_done, fit_type
   use dg_missing, only: is_missing, missing
   use dg_prediction, only: prediction_type
   use dg_variance_components, only: scatter_of
   implicit none
   private
   public :: calibration_result_type, judge_fit, verdict_of
   public :: verdict_found, verdict_at_bound, verdict_not_felt, verdict_not_separated, verdict_name

   integer, parameter :: verdict_found = 1
   integer, parameter :: verdict_at_bound = 2       !< 0 or the greatest: friction alone cannot explain the data
   integer, parameter :: verdict_not_felt = 3       !< the data do not depend on it: it keeps its first value
   integer, parameter :: verdict_not_separated = 4  !< the data only determine a combination with others
   integer, parameter :: verdict_no_fit = 5
   character(*), parameter :: verdict_name(5) = [character(13) :: 'found', 'at_bound', 'not_felt', 'not_separated', 'no_fit']

   type :: calibration_result_type
      integer :: model = 0                        !< number (dg_job)
      real(wp), allocatable :: start(:)           !< of each unknown
      real(wp), allocatable :: before(:)          !< each datum as the deck has it; missing where there is no solution
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      !> Standard deviations of hook loads [N] and torques [N.m] by the residuals, whether known or not. Their ratios to
      !> the deviations for the intervals follow [-]; missing if no value is spare.
      real(wp) :: deviations(2) = missing, scatters(2) = missing
      real(wp) :: freedoms(2) = 0.0_wp            !< spare values of each kind for its deviation
      logical :: apart = .false.                  !< hook loads and torques ask for different friction
      type(succession_type) :: succession         !< of errors along the depth; deviations and intervals are those with it
      type(drift_type) :: drifts(2)               !< of hook loads and torques with depth
      type(prediction_type) :: prediction         !< of load cases that the fit has not used; not allocated: none
      character(:), allocatable :: message        !< reason why there is no fit, else ''
      integer :: halvings = 0                     !< halvings of the factors before the fit could begin
      integer :: solutions = 0                    !< load cases solved
      real(wp) :: seconds = 0.0_wp
   end type calibration_result_type

contains

   !> Statistics of what was fitted; of nothing where the function had no values.
   subroutine judge_fit(result, measured, deviation, kinds, of_what, depth, group)
      type(calibration_result_type), intent(inout) :: result
      real(wp), intent(in) :: measured(:), deviation(:)
      integer, intent(in) :: kinds(:)     !< number of each datum's variance; 0 where its deviation is known
      integer, intent(in) :: of_what(:)   !< hookload_datum or torque_datum
      real(wp), intent(in) :: depth(:)    !< of each datum [m]
      integer, intent(in) :: group(:)     !< data whose errors may be alike along the depth
      integer :: columns(count(free_unknowns(result%fit))), k
      associate (fit => result%fit, residual => (result%fit%values - measured)/deviation)
         call find_statistics(fit%jacobian, residual, free_unknowns(fit), kinds, result%statistics)
         if (fit%status /= fit_done) return
         columns = pack([(k, k=1, size(fit%unknowns))], free_unknowns(fit))
         do k = 1, size(result%scatters)
            result%scatters(k) = scatter_of(fit%jacobian(:, columns), residual, of_what == k)
            if (.not. any(of_what == k) .or. is_missing(result%scatters(k))) cycle
            if (result%scatters(k) > 0.0_wp) result%freedoms(k) = sum(residual**2, mask=of_what == k)/result%scatters(k)**2
         end do
         result%apart = are_apart(fit%jacobian(:, columns), residual, of_what)
         call find_succession(fit%jacobian(:, columns), residual, depth, group, result%succession)
         do k = 1, size(result%drifts)
            call find_drift(fit%jacobian(:, columns), residual, merge(deviation, 0.0_wp, of_what == k), depth, group, &
                            result%drifts(k))
         end do
         if (result%succession%correlation > 0.0_wp) call judge_anew(residual, kinds, of_what, columns, result)
         do k = 1, size(result%scatters)
            if (any(of_what == k) .and. .not. is_missing(result%scatters(k))) &
               result%deviations(k) = result%scatters(k)*maxval(deviation, mask=of_what == k)
         end do
      end associate
   end subroutine judge_fit

   !> Deviations and intervals of errors that are alike along the depth.
   pure subroutine judge_anew(residual, kinds, of_what, columns, result)
      real(wp), intent(in) :: residual(:)
      integer, intent(in) :: kinds(:), of_what(:)
      integer, intent(in) :: columns(:)   !< unknowns found
      type(calibration_result_type), intent(inout) :: result
      real(wp) :: growth(size(residual)), before, scatter, freedom
      integer :: k
      growth = 1.0_wp
      do k = 1, size(result%scatters)
         before = result%scatters(k)
         if (.not. any(of_what == k) .or. is_missing(before) .or. .not. before > 0.0_wp) cycle
         call scatter_along(result%succession, residual, of_what == k, result%scatters(k), result%freedoms(k))
         where (of_what == k .and. kinds > 0) growth = result%scatters(k)/before
      end do
      freedom = result%statistics%freedom
      scatter = 0.0_wp
      call scatter_along(result%succession, residual, spread(.true., 1, size(residual)), scatter, freedom)
      call widen_intervals(result%succession, growth, any(kinds > 0), freedom, columns, result%statistics)
   end subroutine judge_anew

   !> Verdict on a found value.
   pure function verdict_of(result, unknown) result(verdict)
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: unknown
      integer :: verdict
      integer :: k
      verdict = verdict_no_fit
      if (result%fit%status /= fit_done) return
      verdict = verdict_found
      if (result%fit%at_bound(unknown)) verdict = verdict_at_bound
      if (result%fit%unfelt(unknown)) verdict = verdict_not_felt
      do k = 1, size(result%statistics%mixtures)
         if (any(result%statistics%mixtures(k)%unknowns == unknown)) verdict = verdict_not_separated
      end do
   end function verdict_of
end module dg_calibration_result
