!> Data of a deck's &uncertainty: a range of bit depths as in a sweep. It is solved repeatedly with new random values of the
!> uncertain inputs.
module dg_uncertainty
   use dg_kinds, only: wp
   use dg_sweep, only: point_count, sweep_type
   use dg_trajectory, only: interpolation_minimum_curvature
   implicit none
   private
   public :: uncertainty_type, piece_count, piece_number, correlation_of, friction_factor_of

   type :: uncertainty_type
      type(sweep_type) :: range                     !< models, operations, depths; one friction, absent: that of the hole
      integer :: samples = 1000
      integer :: seed = 1                           !< >= 0
      ! standard deviations
      real(wp) :: friction_deviation = 0.0_wp       !< of each hole section's coefficients [-]
      real(wp) :: friction_correlation = 1.0_wp     !< of the coefficients of two hole sections [-]
      real(wp), allocatable :: friction_deviations(:)  !< one a hole section, in place of these two; not allocated: none [-]
      !> Change of a hole section's coefficient by standard normal numbers, one per section: (sections, sections), lower triangle
      !> [-]. Not allocated if friction is certain.
      real(wp), allocatable :: friction_factor(:, :)
      logical :: axial = .true., rotary = .true.    !< which coefficients change
      integer :: estimate = 0                       !< number of that whose deviations of friction are taken; 0: none
      real(wp) :: density_deviation = 0.0_wp        !< of the mud [kg/m3]
      real(wp) :: inclination_deviation = 0.0_wp    !< of a station [rad]
      real(wp) :: azimuth_deviation = 0.0_wp        !< of a station [rad]
      real(wp) :: hookload_deviation = 0.0_wp       !< of the gauge [N]
      real(wp) :: torque_deviation = 0.0_wp         !< of the gauge [N.m]
      logical :: systematic_survey = .false.        !< all stations are off alike, else each on its own
      integer :: interpolation = interpolation_minimum_curvature !< of the survey
   end type uncertainty_type

   !> Largest pivot that counts as zero, as correlations are rounded to four decimals [-].
   real(wp), parameter :: rounded = 1.0e-3_wp

contains

   !> Solutions in all: each point of the range with each sample.
   pure function piece_count(uncertainty) result(count)
      type(uncertainty_type), intent(in) :: uncertainty
      integer :: count
      count = point_count(uncertainty%range)*uncertainty%samples
   end function piece_count

   !> Number of the solution of a point with a sample.
   elemental function piece_number(uncertainty, point, sample) result(number)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: point, sample
      integer :: number
      number = (point - 1)*uncertainty%samples + sample
   end function piece_number

   !> Matrix of correlations of hole sections [-]: one for all pairs, or those above the diagonal row by row.
   pure function correlation_of(sections, common, above) result(matrix)
      integer, intent(in) :: sections
      real(wp), intent(in) :: common
      real(wp), intent(in) :: above(:)              !< none: `common`
      real(wp) :: matrix(sections, sections)
      integer :: i, j, n
      matrix = common
      n = 0
      do i = 1, sections
         matrix(i, i) = 1.0_wp
         do j = i + 1, sections
            n = n + 1
            if (n <= size(above)) matrix(i, j) = above(n)
            matrix(j, i) = matrix(i, j)
         end do
      end do
   end function correlation_of

   !> Cholesky's factor of the covariance of friction. The first section depends on the first number only. Decks with one
   !> section, and sections without correlation, therefore always draw the same. A pivot within round-off counts as zero.
   pure subroutine friction_factor_of(deviations, correlation, factor, regular)
      real(wp), intent(in) :: deviations(:)         !< one a hole section [-]
      real(wp), intent(in) :: correlation(:, :)
      real(wp), intent(out) :: factor(:, :)
      logical, intent(out) :: regular               !< the correlations fit each other
      real(wp) :: pivot
      integer :: i, j
      regular = .true.
      factor = 0.0_wp
      do j = 1, size(deviations)
         pivot = correlation(j, j) - sum(factor(j, :j - 1)**2)
         regular = regular .and. pivot >= -rounded
         if (pivot > rounded) factor(j, j) = sqrt(pivot)
         do i = j + 1, size(deviations)
            pivot = correlation(i, j) - sum(factor(i, :j - 1)*factor(j, :j - 1))
            if (factor(j, j) > 0.0_wp) then
               factor(i, j) = pivot/factor(j, j)
            else
               regular = regular .and. abs(pivot) <= sqrt(rounded)
            end if
         end do
      end do
      do i = 1, size(deviations)
         factor(i, :) = deviations(i)*factor(i, :)
      end do
   end subroutine friction_factor_of
end module dg_uncertainty
