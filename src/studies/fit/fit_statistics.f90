!> Quality of a fit: confidence intervals, and unknowns that the data cannot separate. LAPACK's dgesvd factorizes the Jacobian.
module dg_fit_statistics
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_lapack, only: dgesvd
   use dg_missing, only: missing
   use dg_variance_components, only: adjust_covariance
   implicit none
   private
   public :: statistics_type, find_statistics, student_quantile, quantile_between, as_normal, upper_end

   !> Unknowns of which the data tell only a combination.
   type :: mixture_type
      integer, allocatable :: unknowns(:)    !< numbers, the heaviest first
   end type mixture_type

   type :: statistics_type
      integer :: freedom = 0                        !< data less unknowns found
      real(wp) :: scatter = missing                 !< of the residuals over the deviations given, about 1 where these are right [-]
      real(wp), allocatable :: deviation(:)         !< standard deviation of each unknown; missing where it cannot be told
      real(wp), allocatable :: half_width(:)        !< of its 95 % confidence interval; missing where it cannot be told
      real(wp), allocatable :: correlation(:, :)    !< of unknowns with each other [-]; 0 with those not found
      type(mixture_type), allocatable :: mixtures(:)
   end type statistics_type

   real(wp), parameter :: confidence = 0.95_wp
   !> Probability of less than the upper end of such an interval [-].
   real(wp), parameter :: upper_end = 0.5_wp + 0.5_wp*confidence
   !> Residuals over deviations that are as small as the last steps of a fit [-]. No gauge is as exact. Such data are copies of
   !> one reading or results of a program, and do not show the error of readings.
   real(wp), parameter :: no_scatter = 1.0e-5_wp
   !> Degrees of freedom from which on Student's distribution is the normal one.
   integer, parameter :: as_normal = 100000
   !> Singular values below this part of the largest [-]: two columns then make an angle of less than 0.2 rad. Their factors
   !> then correlate by more than 0.98.
   real(wp), parameter :: separable = 0.1_wp
   !> Unknowns with at least this share in such a combination are named.
   real(wp), parameter :: sharing = 0.25_wp
   !> Part of the largest singular value below which a combination is unknown: the round-off of a difference quotient.
   real(wp), parameter :: nothing_known = 1.0e-6_wp

contains

   !> Statistics of a fit. Known deviations of the data set the intervals. Else the residuals do, and then there must be more
   !> data than unknowns. With data of several kinds the deviations must be those of dg_variance_components.
   subroutine find_statistics(jacobian, residual, found, kinds, statistics)
      real(wp), intent(in) :: jacobian(:, :)     !< (data, unknowns), over the deviations
      real(wp), intent(in) :: residual(:)        !< over the deviations
      logical, intent(in) :: found(:)            !< which unknowns the fit was free to choose
      integer, intent(in) :: kinds(:)            !< number of each datum's variance; 0 where its deviation is known
      type(statistics_type), intent(out) :: statistics
      real(wp) :: factor
      integer :: columns(count(found)), k, n
      logical :: pooled
      n = size(columns)
      columns = pack([(k, k=1, size(found))], found)
      statistics%freedom = size(residual) - n
      if (statistics%freedom > 0) statistics%scatter = norm2(residual)/sqrt(real(statistics%freedom, wp))
      allocate (statistics%deviation(size(found)), statistics%half_width(size(found)), source=missing)
      allocate (statistics%correlation(size(found), size(found)), source=0.0_wp)
      allocate (statistics%mixtures(0))
      if (n == 0 .or. n > size(residual)) return
      call decompose(jacobian(:, columns), columns, statistics)
      pooled = all(kinds == 1)
      if (.not. all(kinds == 0) .and. .not. pooled) then
         if (statistics%freedom > 0 .and. statistics%scatter > no_scatter) then
            call adjust(jacobian(:, columns), kinds, columns, statistics)
         else
            statistics%deviation = missing
         end if
         return
      end if
      if (.not. pooled) then
         factor = student_quantile(upper_end, as_normal)
      else if (statistics%freedom > 0 .and. statistics%scatter > no_scatter) then
         where (statistics%deviation > missing) statistics%deviation = statistics%deviation*statistics%scatter
         factor = student_quantile(upper_end, statistics%freedom)
      else
         statistics%deviation = missing
         return
      end if
      where (statistics%deviation > missing) statistics%half_width = factor*statistics%deviation
   end subroutine find_statistics

   !> Deviations, intervals and correlations where variances of several kinds were estimated.
   subroutine adjust(jacobian, kinds, columns, statistics)
      real(wp), intent(in) :: jacobian(:, :)
      integer, intent(in) :: kinds(:), columns(:)
      type(statistics_type), intent(inout) :: statistics
      real(wp) :: covariance(size(columns), size(columns)), freedom(size(columns)), freedoms
      integer :: k, j
      if (any(statistics%deviation(columns) <= missing)) return
      do k = 1, size(columns)
         do j = 1, size(columns)
            covariance(j, k) = statistics%correlation(columns(j), columns(k))*statistics%deviation(columns(j))* &
                               statistics%deviation(columns(k))
         end do
      end do
      call adjust_covariance(jacobian, kinds, covariance, freedom)
      do k = 1, size(columns)
         statistics%deviation(columns(k)) = sqrt(max(covariance(k, k), 0.0_wp))
         freedoms = min(freedom(k), real(as_normal, wp))
         statistics%half_width(columns(k)) = statistics%deviation(columns(k))*quantile_between(upper_end, freedoms)
      end do
      do k = 1, size(columns)
         do j = 1, size(columns)
            statistics%correlation(columns(j), columns(k)) = covariance(j, k)/ &
               max(statistics%deviation(columns(j))*statistics%deviation(columns(k)), tiny(1.0_wp))
         end do
      end do
   end subroutine adjust

   !> Student's quantile for a freedom that is not a whole number: by a straight line in its inverse.
   pure function quantile_between(probability, freedom) result(quantile)
      real(wp), intent(in) :: probability
      real(wp), intent(in) :: freedom       !< >= 1
      real(wp) :: quantile
      real(wp) :: share
      integer :: below
      below = int(freedom)
      share = (1.0_wp/below - 1.0_wp/freedom)*real(below, wp)*real(below + 1, wp)
      quantile = (1.0_wp - share)*student_quantile(probability, below) + share*student_quantile(probability, below + 1)
   end function quantile_between

   !> Covariances for data of deviation 1, from the singular values of the Jacobian with columns of length 1.
   subroutine decompose(jacobian, columns, statistics)
      real(wp), intent(in) :: jacobian(:, :)
      integer, intent(in) :: columns(:)
      type(statistics_type), intent(inout) :: statistics
      real(wp) :: scaled(size(jacobian, 1), size(jacobian, 2)), length(size(columns)), values(size(columns))
      real(wp) :: right(size(columns), size(columns)), none(1, 1), covariance(size(columns), size(columns))
      real(wp), allocatable :: work(:)
      integer :: k, j, m, n, info, weak
      m = size(jacobian, 1)
      n = size(columns)
      do k = 1, n
         length(k) = norm2(jacobian(:, k))
         scaled(:, k) = jacobian(:, k)/length(k)
      end do
      allocate (work(3*m + 6*n))
      call dgesvd('N', 'S', m, n, scaled, m, values, none, 1, right, n, work, size(work), info)
      if (info /= 0) return
      weak = count(values < separable*values(1))
      deallocate (statistics%mixtures)
      allocate (statistics%mixtures(weak))
      do k = 1, weak      ! singular values fall
         associate (mixture => statistics%mixtures(k))
            mixture%unknowns = columns(descending(abs(right(n - weak + k, :)), sharing))
         end associate
      end do
      if (values(n) <= nothing_known*values(1)) return
      do j = 1, n
         do k = 1, n
            covariance(k, j) = sum(right(:, k)*right(:, j)/values**2)/(length(k)*length(j))
         end do
      end do
      do k = 1, n
         statistics%deviation(columns(k)) = sqrt(covariance(k, k))
         do j = 1, n
            statistics%correlation(columns(k), columns(j)) = covariance(k, j)/sqrt(covariance(k, k)*covariance(j, j))
         end do
      end do
   end subroutine decompose

   !> Places of the numbers above a limit, the greatest first.
   pure function descending(numbers, limit) result(places)
      real(wp), intent(in) :: numbers(:), limit
      integer, allocatable :: places(:)
      real(wp) :: left(size(numbers))
      integer :: i, one
      allocate (places(0))
      left = numbers
      do i = 1, size(numbers)
         one = maxloc(left, dim=1)
         if (left(one) < limit) exit
         places = [places, one]
         left(one) = 0.0_wp
      end do
   end function descending

   !> Quantile of Student's distribution at a probability from 0.5 to below 1, by Newton's method on its distribution function
   !> (Abramowitz & Stegun 1964, 26.7.3 and 26.7.4). That is concave in the angle, so that steps from 0 never pass the quantile.
   pure function student_quantile(probability, freedom) result(quantile)
      real(wp), intent(in) :: probability
      integer, intent(in) :: freedom              !< >= 1
      real(wp) :: quantile
      real(wp) :: angle, step, density, half
      integer :: i
      half = 0.5_wp*real(freedom, wp)
      density = 2.0_wp*exp(log_gamma(half + 0.5_wp) - log_gamma(half))/sqrt(pi)        ! at the angle 0
      angle = 0.0_wp
      do i = 1, digits(angle)
         step = (2.0_wp*probability - 1.0_wp - student_middle(angle, freedom))/(density*cos(angle)**(freedom - 1))
         if (.not. step > 0.0_wp) exit
         angle = angle + step
      end do
      quantile = tan(angle)*sqrt(real(freedom, wp))
   end function student_quantile

   !> Probability that |t| < sqrt(freedom) tan(angle).
   pure function student_middle(angle, freedom) result(probability)
      real(wp), intent(in) :: angle               !< [rad], 0 to pi/2
      integer, intent(in) :: freedom
      real(wp) :: probability
      real(wp) :: term, series, square
      integer :: k
      square = cos(angle)**2
      series = 0.0_wp
      if (modulo(freedom, 2) == 1) then
         term = cos(angle)
         do k = 1, freedom - 2, 2
            series = series + term
            term = term*square*real(k + 1, wp)/real(k + 2, wp)
            if (term <= epsilon(term)*series) exit
         end do
         probability = 2.0_wp/pi*(angle + sin(angle)*series)
      else
         term = 1.0_wp
         do k = 0, freedom - 2, 2
            series = series + term
            term = term*square*real(k + 1, wp)/real(k + 2, wp)
            if (term <= epsilon(term)*series) exit
         end do
         probability = sin(angle)*series
      end if
   end function student_middle
end module dg_fit_statistics
