!> Quantiles and moments of samples.
module dg_sample_statistics
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_sampled_model, only: draw_of, quantity_hookload, quantity_torque
   use dg_case_result, only: result_converged, result_locked_up, result_not_converged
   use dg_load_case, only: rotates
   use dg_merge_sort, only: sorted_places
   use dg_sweep, only: point_at, point_type
   use dg_sweep_result, only: sweep_result_type
   use dg_uncertainty, only: piece_number, uncertainty_type
   use dg_variance_shares, only: input_count, variance_shares
   implicit none
   private
   public :: distribution_type, point_statistics_type, find_distribution, find_point_statistics, quantile, p10, p50, p90

   integer, parameter :: p10 = 1, p50 = 2, p90 = 3
   !> Shares of samples below P10, P50, P90.
   real(wp), parameter :: shares(3) = [0.1_wp, 0.5_wp, 0.9_wp]

   type :: distribution_type
      real(wp) :: quantiles(3) = missing     !< P10, P50, P90
      real(wp) :: mean = missing
      real(wp) :: deviation = missing        !< standard deviation
   end type distribution_type

   !> A point of the range over all samples. Samples that lock up count. Their hook load is below every other, since no push
   !> brings the string down, and if it turns their torque is above. A quantile among them has no number. Samples without
   !> solution are left out.
   type :: point_statistics_type
      integer :: solved = 0
      integer :: locked_up = 0
      integer :: not_converged = 0
      type(distribution_type) :: hookload    !< [N]
      type(distribution_type) :: weight_indicator !< as the rig shows it; nothing where none is given [N]
      type(distribution_type) :: torque      !< [N.m]
      real(wp) :: hookload_shares(input_count) = missing, torque_shares(input_count) = missing !< of the variance, by input [-]
   end type point_statistics_type

contains

   !> Statistics of one point; what a gauge would show where it has a deviation of its own.
   pure function find_point_statistics(uncertainty, point, results) result(statistics)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: point                        !< its number in the range
      type(sweep_result_type), intent(in) :: results(:)   !< all
      type(point_statistics_type) :: statistics
      integer :: samples(uncertainty%samples), pieces(uncertainty%samples), sample, tight
      real(wp) :: values(uncertainty%samples)
      type(point_type) :: place
      samples = [(sample, sample=1, size(samples))]
      pieces = piece_number(uncertainty, point, samples)
      statistics%locked_up = count(results(pieces)%status == result_locked_up)
      statistics%not_converged = count(results(pieces)%status == result_not_converged)
      samples = pack(samples, results(pieces)%status == result_converged, spread(0, 1, size(samples)))
      statistics%solved = count(samples > 0)
      pieces = piece_number(uncertainty, point, max(samples, 1))
      place = point_at(uncertainty%range, point)
      tight = 0
      if (rotates(uncertainty%range%operations(place%operation))) tight = statistics%locked_up
      associate (solved => samples(:statistics%solved), places => pieces(:statistics%solved))
         statistics%hookload = find_distribution(results(places)%hookload + uncertainty%hookload_deviation* &
                                                 draw_of(uncertainty, solved, quantity_hookload, point), &
                                                 below=statistics%locked_up)
         if (.not. any(is_missing(results(places)%weight_indicator))) statistics%weight_indicator = &
            find_distribution(results(places)%weight_indicator + uncertainty%hookload_deviation* &
                              draw_of(uncertainty, solved, quantity_hookload, point), below=statistics%locked_up)
         statistics%torque = find_distribution(results(places)%torque + uncertainty%torque_deviation* &
                                               draw_of(uncertainty, solved, quantity_torque, point), above=tight)
         values(:statistics%solved) = results(places)%hookload
         statistics%hookload_shares = variance_shares(uncertainty, solved, values(:statistics%solved), &
                                                      uncertainty%hookload_deviation)
         values(:statistics%solved) = results(places)%torque
         statistics%torque_shares = variance_shares(uncertainty, solved, values(:statistics%solved), uncertainty%torque_deviation)
      end associate
   end function find_point_statistics

   !> Distribution of a list of numbers; empty for an empty list. In addition there may be some that are only known to be below
   !> or above all. They count for quantiles, not for mean and deviation.
   pure function find_distribution(numbers, below, above) result(distribution)
      real(wp), intent(in) :: numbers(:)
      integer, intent(in), optional :: below, above
      type(distribution_type) :: distribution
      real(wp) :: sorted(size(numbers))
      integer :: n, low, high
      n = size(numbers)
      if (n == 0) return
      low = 0
      high = 0
      if (present(below)) low = below
      if (present(above)) high = above
      sorted = numbers(sorted_places(numbers))
      distribution%quantiles = quantile(sorted, shares, low, high)
      distribution%mean = sum(sorted)/real(n, wp)
      if (n > 1) distribution%deviation = norm2(sorted - distribution%mean)/sqrt(real(n - 1, wp))
   end function find_distribution

   !> Number below which a share of sorted numbers is, linear between neighbours (type 7 of Hyndman & Fan 1996). It is missing
   !> among, or next to, those that are only known to be below or above all.
   pure function quantile(sorted, share, below, above) result(numbers)
      real(wp), intent(in) :: sorted(:)      !< ascending, at least one
      real(wp), intent(in) :: share(:)       !< 0 to 1
      integer, intent(in) :: below, above    !< how many more lie below and above the sorted ones
      real(wp) :: numbers(size(share))
      real(wp) :: place
      integer :: i, low, next
      do i = 1, size(share)
         numbers(i) = missing
         place = 1.0_wp + share(i)*real(below + size(sorted) + above - 1, wp)
         low = int(place) - below
         place = place - below
         next = merge(low + 1, low, place > real(low, wp))
         if (low < 1 .or. next > size(sorted)) cycle
         numbers(i) = sorted(low) + (place - low)*(sorted(next) - sorted(low))
      end do
   end function quantile
end module dg_sample_statistics
