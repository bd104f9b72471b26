!> Shares of uncertain inputs in the variance of a result.
!>
!> Samples are a linear function of the standard normal numbers that they were drawn from, and what is left:
!>     y = sum b_k x_k + e.
!> The share of a number is b_k cov(x_k, y)/var(y), with the covariance of the numbers that were drawn. The shares add up to the
!> part of the variance that is linear, whatever variance and correlation a few draws have by chance. With many draws they are the
!> squares b_k^2/var(y) (first-order index of a linear model; Saltelli et al. 2008, Global sensitivity analysis, sec. 1.2.5).
!> Chance alone gives a number without effect var(e)/(n - 1), which is taken off. Errors of stations each on their own are too
!> many numbers for that: what is left counts as theirs.
module dg_variance_shares
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_sampled_model, only: draw_of, quantity_azimuth, quantity_density, quantity_friction, quantity_inclination
   use dg_uncertainty, only: uncertainty_type
   use dg_variance_components, only: invert_normal
   implicit none
   private
   public :: variance_shares, varies, input_count, input_name
   public :: input_friction, input_density, input_survey, input_gauge, input_rest

   integer, parameter :: input_friction = 1, input_density = 2, input_survey = 3, input_gauge = 4, input_rest = 5
   integer, parameter :: input_count = 5
   !> Names in files, with blanks for '_' in texts.
   character(*), parameter :: input_name(input_count) = [character(11) :: 'friction', 'mud_density', 'survey', 'gauge', 'rest']

   !> Fewest samples for each coefficient.
   integer, parameter :: samples_each = 10
   !> Deviation that is round-off: over the largest value [-], and of a value that is zero [N or N.m].
   real(wp), parameter :: round_off = 1.0e-9_wp, round_off_of_zero = 1.0e-6_wp

contains

   !> Share of each input [-]; their sum is 1. Missing where samples are few, or alike up to round-off.
   pure function variance_shares(uncertainty, samples, values, gauge) result(shares)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: samples(:)      !< numbers of those that are solved
      real(wp), intent(in) :: values(:)      !< of each, without the gauge's error [N or N.m]
      real(wp), intent(in) :: gauge          !< standard deviation of the gauge [N or N.m]
      real(wp) :: shares(input_count)
      real(wp) :: left(size(samples)), freedom, variance, total
      real(wp), allocatable :: drawn(:, :), inverse(:, :), along(:), found(:)
      integer, allocatable :: input(:), quantity(:), place(:)
      integer :: n, k
      logical :: regular
      shares = missing
      call list_numbers(uncertainty, input, quantity, place)
      n = size(input)
      if (size(samples) < samples_each*(n + 1)) return
      allocate (drawn(size(samples), n))
      do k = 1, n
         drawn(:, k) = draw_of(uncertainty, samples, quantity(k), place(k))
         drawn(:, k) = drawn(:, k) - sum(drawn(:, k))/real(size(samples), wp)
      end do
      freedom = real(size(samples) - 1, wp)
      left = values - sum(values)/real(size(values), wp)
      total = sum(left**2)/freedom + gauge**2
      if (sqrt(total) <= max(round_off*maxval(abs(values)), round_off_of_zero)) return
      allocate (inverse(n, n))
      call invert_normal(drawn, inverse, regular)
      if (.not. regular) return
      along = matmul(left, drawn)
      found = matmul(inverse, along)
      left = left - matmul(drawn, found)
      variance = sum(left**2)/real(size(samples) - n - 1, wp)
      shares = 0.0_wp
      do k = 1, n
         shares(input(k)) = shares(input(k)) + (found(k)*along(k) - variance)/(freedom*total)
      end do
      shares = max(shares, 0.0_wp)
      shares(input_gauge) = gauge**2/total
      shares(input_rest) = max(1.0_wp - sum(shares), 0.0_wp)
      if (.not. varies(uncertainty, input_rest)) then
         shares(input_survey) = shares(input_rest)
         shares(input_rest) = 0.0_wp
      end if
      shares = shares/sum(shares)
   end function variance_shares

   !> The numbers of a sample that act on the whole string: input that each belongs to, and how it is drawn (dg_sampled_model).
   pure subroutine list_numbers(uncertainty, input, quantity, place)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, allocatable, intent(out) :: input(:), quantity(:), place(:)
      logical, allocatable :: drawn(:)
      integer :: j, sections
      sections = 0
      if (allocated(uncertainty%friction_factor)) sections = size(uncertainty%friction_factor, 2)
      allocate (drawn(sections))
      do j = 1, sections
         drawn(j) = any(abs(uncertainty%friction_factor(:, j)) > 0.0_wp)
      end do
      drawn = [drawn, uncertainty%density_deviation > 0.0_wp, &
               uncertainty%systematic_survey .and. uncertainty%inclination_deviation > 0.0_wp, &
               uncertainty%systematic_survey .and. uncertainty%azimuth_deviation > 0.0_wp]
      input = pack([spread(input_friction, 1, sections), input_density, input_survey, input_survey], drawn)
      quantity = pack([spread(quantity_friction, 1, sections), quantity_density, quantity_inclination, quantity_azimuth], drawn)
      place = pack([(j, j=1, sections), 0, 0, 0], drawn)
   end subroutine list_numbers

   !> True if an input is uncertain. The remainder belongs to the survey where the errors of its stations are independent.
   pure function varies(uncertainty, input) result(does)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: input
      logical :: does
      does = .false.
      select case (input)
      case (input_friction)
         does = allocated(uncertainty%friction_factor)
         if (does) does = any(abs(uncertainty%friction_factor) > 0.0_wp)
      case (input_density); does = uncertainty%density_deviation > 0.0_wp
      case (input_survey); does = uncertainty%inclination_deviation > 0.0_wp .or. uncertainty%azimuth_deviation > 0.0_wp
      case (input_gauge); does = uncertainty%hookload_deviation > 0.0_wp .or. uncertainty%torque_deviation > 0.0_wp
      case (input_rest)
         does = uncertainty%systematic_survey .or. &
                .not. (uncertainty%inclination_deviation > 0.0_wp .or. uncertainty%azimuth_deviation > 0.0_wp)
      case default
      end select
   end function varies
end module dg_variance_shares
