!> What a calibration with one model found. SI units.
module dg_calibration_result
   use dg_kinds, only: wp
   use dg_fit_statistics, only: find_statistics, statistics_type
   use dg_least_squares, only: fit_done, fit_type, fit_without_values
   implicit none
   private
   public :: calibration_result_type, judge_fit, verdict_of
   public :: verdict_found, verdict_at_bound, verdict_not_felt, verdict_not_separated, verdict_no_fit, verdict_name

   integer, parameter :: verdict_found = 1
   integer, parameter :: verdict_at_bound = 2       !< 0 or the greatest: the data ask for more than friction can do
   integer, parameter :: verdict_not_felt = 3       !< the data do not depend on it: as it was
   integer, parameter :: verdict_not_separated = 4  !< the data tell only a combination with others
   integer, parameter :: verdict_no_fit = 5
   character(*), parameter :: verdict_name(5) = [character(13) :: 'found', 'at_bound', 'not_felt', 'not_separated', 'no_fit']

   type :: calibration_result_type
      integer :: model = 0                        !< number (dg_job)
      real(wp), allocatable :: start(:)           !< of each unknown
      real(wp), allocatable :: before(:)          !< each datum as the deck has it; missing where there is no solution
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      character(:), allocatable :: message        !< why there is no fit; '' else
      integer :: halvings = 0                     !< of the factors, until the fit could begin
      integer :: solutions = 0                    !< load cases solved
      real(wp) :: seconds = 0.0_wp
   end type calibration_result_type

contains

   !> Statistics of what was fitted; of nothing where the function had no values.
   subroutine judge_fit(result, measured, deviation, deviations_known)
      type(calibration_result_type), intent(inout) :: result
      real(wp), intent(in) :: measured(:), deviation(:)
      logical, intent(in) :: deviations_known
      call find_statistics(result%fit%jacobian, (result%fit%values - measured)/deviation, &
                           .not. (result%fit%at_bound .or. result%fit%unfelt) .and. result%fit%status /= fit_without_values, &
                           deviations_known, result%statistics)
   end subroutine judge_fit

   !> What a found value is worth.
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
