!> Quantiles and moments of samples.
module dg_sample_statistics
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_sampled_model, only: draw_of, quantity_hookload, quantity_torque
   use dg_case_result, only: result_converged
   use dg_sweep_result, only: sweep_result_type
   use dg_uncertainty, only: piece_number, uncertainty_type
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

   !> A point of the range over all samples that have a solution.
   type :: point_statistics_type
      integer :: solved = 0
      type(distribution_type) :: hookload    !< [N]
      type(distribution_type) :: torque      !< [N.m]
   end type point_statistics_type

contains

   !> Statistics of one point; what a gauge would show where it has a deviation of its own.
   pure function find_point_statistics(uncertainty, point, results) result(statistics)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: point                        !< its number in the range
      type(sweep_result_type), intent(in) :: results(:)   !< all
      type(point_statistics_type) :: statistics
      integer :: samples(uncertainty%samples), pieces(uncertainty%samples), sample
      samples = [(sample, sample=1, size(samples))]
      samples = pack(samples, results(piece_number(uncertainty, point, samples))%status == result_converged, &
                     spread(0, 1, size(samples)))
      statistics%solved = count(samples > 0)
      pieces = piece_number(uncertainty, point, max(samples, 1))
      associate (solved => samples(:statistics%solved), places => pieces(:statistics%solved))
         statistics%hookload = find_distribution(results(places)%hookload + uncertainty%hookload_deviation* &
                                                 draw_of(uncertainty, solved, quantity_hookload, point))
         statistics%torque = find_distribution(results(places)%torque + uncertainty%torque_deviation* &
                                               draw_of(uncertainty, solved, quantity_torque, point))
      end associate
   end function find_point_statistics

   !> Of a list of numbers; nothing of an empty one.
   pure function find_distribution(numbers) result(distribution)
      real(wp), intent(in) :: numbers(:)
      type(distribution_type) :: distribution
      real(wp) :: sorted(size(numbers))
      integer :: n
      n = size(numbers)
      if (n == 0) return
      sorted = numbers
      call sort(sorted)
      distribution%quantiles = quantile(sorted, shares)
      distribution%mean = sum(sorted)/real(n, wp)
      if (n > 1) distribution%deviation = norm2(sorted - distribution%mean)/sqrt(real(n - 1, wp))
   end function find_distribution

   !> The number under which a share of sorted numbers lies, by straight lines between neighbours (type 7 of Hyndman & Fan 1996).
   pure function quantile(sorted, share) result(numbers)
      real(wp), intent(in) :: sorted(:)      !< ascending, at least one
      real(wp), intent(in) :: share(:)       !< 0 to 1
      real(wp) :: numbers(size(share))
      real(wp) :: place
      integer :: i, below
      do i = 1, size(share)
         place = 1.0_wp + share(i)*real(size(sorted) - 1, wp)
         below = min(int(place), size(sorted))
         numbers(i) = sorted(below) + (place - below)*(sorted(min(below + 1, size(sorted))) - sorted(below))
      end do
   end function quantile

   !> Ascending order, by merging runs of doubling length.
   pure subroutine sort(numbers)
      real(wp), intent(inout) :: numbers(:)
      real(wp) :: merged(size(numbers))
      integer :: run, first, middle, last, i, j, k
      run = 1
      do while (run < size(numbers))
         do first = 1, size(numbers), 2*run
            middle = min(first + run, size(numbers) + 1)
            last = min(first + 2*run, size(numbers) + 1)
            i = first
            j = middle
            do k = first, last - 1
               if (j >= last) then
                  merged(k) = numbers(i)
                  i = i + 1
               else if (i >= middle) then
                  merged(k) = numbers(j)
                  j = j + 1
               else if (numbers(j) < numbers(i)) then
                  merged(k) = numbers(j)
                  j = j + 1
               else
                  merged(k) = numbers(i)
                  i = i + 1
               end if
            end do
         end do
         numbers = merged
         run = 2*run
      end do
   end subroutine sort
end module dg_sample_statistics
