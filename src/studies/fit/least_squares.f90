!> Nonlinear least squares after Levenberg (1944) and Marquardt (1963). Gauss-Newton steps are damped as far as the sum of
!> squares requires, within bounds. Derivatives are by differences. LAPACK's dgels solves each step.
module dg_least_squares
   use dg_kinds, only: wp
   use dg_interruption, only: is_interrupted
   use dg_lapack, only: dgels
   implicit none
   private
   public :: measured_function_type, unknowns_type, fit_type, fit_least_squares, fit_from_less
   public :: fit_done, fit_without_values, difference_share

   integer, parameter :: fit_done = 1                !< at rest
   integer, parameter :: fit_out_of_iterations = 2   !< the best found so far
   integer, parameter :: fit_without_values = 3      !< the function has no values at the start, or none around the fit

   !> Function that is fitted to the data.
   type, abstract :: measured_function_type
   contains
      procedure(evaluate_points), deferred :: evaluate
   end type measured_function_type

   abstract interface
      !> Values at several points at once, so that they can be computed at the same time.
      subroutine evaluate_points(self, points, values, solved)
         import :: measured_function_type, wp
         implicit none
         class(measured_function_type), intent(inout) :: self
         real(wp), intent(in) :: points(:, :)     !< (unknowns, points)
         real(wp), intent(out) :: values(:, :)    !< (data, points)
         logical, intent(out) :: solved(:, :)     !< (data, points); where false, the value is not valid
      end subroutine evaluate_points
   end interface

   !> Start of a fit, and bounds of its unknowns.
   type :: unknowns_type
      real(wp), allocatable :: start(:)
      logical, allocatable :: lessened(:)   !< begin with half of it where the function has no values there
      real(wp), allocatable :: lower(:), upper(:)
      real(wp), allocatable :: scale(:)     !< > 0: what counts as a large change
   end type unknowns_type

   type :: fit_type
      integer :: status = fit_without_values
      integer :: iterations = 0
      real(wp), allocatable :: unknowns(:)
      real(wp), allocatable :: values(:)         !< of the function there
      real(wp), allocatable :: jacobian(:, :)    !< (data, unknowns), over the deviations of the data
      logical, allocatable :: at_bound(:)        !< the data pull the unknown past its bound
      logical, allocatable :: unfelt(:)          !< the data do not depend on the unknown: it stays at its start
      integer :: lost = 0                        !< number of a datum without value, where that ended the fit
   end type fit_type

   !> Step of differences over an unknown's scale: small compared with its curvature, large compared with the residual of
   !> models.
   real(wp), parameter :: difference_share = 1.0e-3_wp
   !> A step smaller than this part of the scale ends the fit: far below any measurement.
   real(wp), parameter :: rest_share = 1.0e-7_wp
   !> Largest possible decrease of the sum of squares, as a part of it, at which the fit ends.
   real(wp), parameter :: rest_gain = 1.0e-12_wp
   integer, parameter :: most_iterations = 60
   !> First damping, its factor of change, and the largest damping.
   real(wp), parameter :: first_damping = 1.0e-4_wp, damping_factor = 10.0_wp, most_damping = 1.0e12_wp
   !> An unknown has no effect if its whole scale moves no datum by this part of its deviation.
   real(wp), parameter :: felt = 1.0e-2_wp
   !> It also has no effect if it moves no datum by this part of the datum, which is the noise of iterations in a difference.
   real(wp), parameter :: noise = 1.0e-5_wp

   !> Maximum number of halvings of a start without values: a sixteenth of any friction is little.
   integer, parameter :: most_halvings = 4

contains

   !> As fit_least_squares. Where the function has no values at the start, unknowns that may be lessened begin with half of it, and
   !> with half of that.
   subroutine fit_from_less(function, unknowns, measured, deviation, fit, halvings)
      class(measured_function_type), intent(inout) :: function
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: measured(:), deviation(:)
      type(fit_type), intent(out) :: fit
      integer, intent(out) :: halvings
      real(wp) :: begin(size(unknowns%start))
      begin = unknowns%start
      do halvings = 0, most_halvings
         call fit_least_squares(function, begin, unknowns%lower, unknowns%upper, unknowns%scale, measured, deviation, fit)
         if (fit%status /= fit_without_values .or. fit%iterations > 0 .or. is_interrupted()) return
         where (unknowns%lessened) begin = 0.5_wp*begin
      end do
      halvings = most_halvings
   end subroutine fit_from_less

   !> Fits `function` to `measured`. Unknowns stay between `lower` and `upper`.
   subroutine fit_least_squares(function, start, lower, upper, scale, measured, deviation, fit)
      class(measured_function_type), intent(inout) :: function
      real(wp), intent(in) :: start(:), lower(:), upper(:)
      real(wp), intent(in) :: scale(:)        !< > 0: what counts as a large change of each unknown
      real(wp), intent(in) :: measured(:)
      real(wp), intent(in) :: deviation(:)    !< > 0
      type(fit_type), intent(out) :: fit
      real(wp) :: values(size(measured), 1), residual(size(measured)), step(size(start)), trial(size(start), 1)
      real(wp) :: sum_of_squares, trial_sum, damping, pull(size(start))
      logical :: solved(size(measured), 1), free(size(start))
      integer :: i
      fit%unknowns = min(max(start, lower), upper)
      allocate (fit%jacobian(size(measured), size(start)), source=0.0_wp)
      allocate (fit%at_bound(size(start)), fit%unfelt(size(start)), source=.false.)
      trial(:, 1) = fit%unknowns
      call function%evaluate(trial, values, solved)
      fit%values = values(:, 1)
      if (.not. all(solved)) then
         fit%lost = findloc(solved(:, 1), .false., dim=1)
         return
      end if
      residual = (values(:, 1) - measured)/deviation
      sum_of_squares = dot_product(residual, residual)
      damping = first_damping
      do i = 1, most_iterations
         fit%iterations = i
         call differentiate(function, scale, lower, upper, deviation, fit)
         if (fit%lost > 0) return
         pull = -matmul(residual, fit%jacobian)
         do
            free = .not. (fit%unfelt .or. (fit%unknowns <= lower .and. pull < 0.0_wp) .or. &
                          (fit%unknowns >= upper .and. pull > 0.0_wp))
            fit%at_bound = .not. (free .or. fit%unfelt)
            call damped_step(fit%jacobian, residual, free, scale, damping, step)
            trial(:, 1) = min(max(fit%unknowns + step, lower), upper)
            step = trial(:, 1) - fit%unknowns
            if (all(abs(step) <= rest_share*scale)) then
               fit%status = fit_done
               return
            end if
            call function%evaluate(trial, values, solved)
            trial_sum = huge(1.0_wp)
            if (all(solved)) trial_sum = sum(((values(:, 1) - measured)/deviation)**2)
            if (trial_sum < sum_of_squares) exit
            damping = damping*damping_factor
            if (damping > most_damping) then      ! no way down, however short the step
               fit%status = fit_done
               return
            end if
         end do
         damping = damping/damping_factor
         fit%unknowns = trial(:, 1)
         fit%values = values(:, 1)
         residual = (values(:, 1) - measured)/deviation
         if (sum_of_squares - trial_sum <= rest_gain*sum_of_squares) then
            fit%status = fit_done
            call differentiate(function, scale, lower, upper, deviation, fit)
            return
         end if
         sum_of_squares = trial_sum
      end do
      fit%status = fit_out_of_iterations
   end subroutine fit_least_squares

   !> Derivatives of the values over the deviations, by one-sided differences within the bounds. If the function has no values
   !> on one side of an unknown, the other side is used. If it has none there either, the fit is without values, and fit%lost
   !> is a datum without value.
   subroutine differentiate(function, scale, lower, upper, deviation, fit)
      class(measured_function_type), intent(inout) :: function
      real(wp), intent(in) :: scale(:), lower(:), upper(:), deviation(:)
      type(fit_type), intent(inout) :: fit
      real(wp) :: points(size(scale), size(scale)), values(size(deviation), size(scale))
      real(wp), dimension(size(scale)) :: above, below, width
      logical :: solved(size(deviation), size(scale)), known(size(scale))
      integer :: lost(size(scale)), side, k
      above = min(difference_share*scale, upper - fit%unknowns)
      below = min(difference_share*scale, fit%unknowns - lower)
      width = merge(above, -below, above >= below)
      lost = 0
      do side = 1, 2
         do k = 1, size(scale)
            points(:, k) = fit%unknowns
            points(k, k) = fit%unknowns(k) + width(k)
            width(k) = points(k, k) - fit%unknowns(k)     ! as rounded
         end do
         call function%evaluate(points, values, solved)
         known = all(solved, dim=1) .and. abs(width) > rest_share*scale
         do k = 1, size(scale)
            if (.not. all(solved(:, k))) lost(k) = findloc(solved(:, k), .false., dim=1)
         end do
         if (all(known)) exit
         if (side == 1) where (.not. known) width = merge(-below, above, width > 0.0_wp)
      end do
      fit%lost = 0
      do k = size(scale), 1, -1
         if (.not. known(k) .and. lost(k) > 0) fit%lost = lost(k)
      end do
      if (fit%lost > 0) then
         fit%status = fit_without_values
         return
      end if
      fit%jacobian = 0.0_wp
      do k = 1, size(scale)
         if (known(k)) fit%jacobian(:, k) = (values(:, k) - fit%values)/(width(k)*deviation)
      end do
      do k = 1, size(scale)
         fit%unfelt(k) = all(abs(fit%jacobian(:, k))*scale(k) < max(felt, noise*abs(fit%values)/deviation))
      end do
   end subroutine differentiate

   !> The step that minimises the linearised sum of squares plus `damping` times the step's own, each unknown weighted by its
   !> column. It is zero for unknowns that are not free.
   subroutine damped_step(jacobian, residual, free, scale, damping, step)
      real(wp), intent(in) :: jacobian(:, :), residual(:)
      logical, intent(in) :: free(:)
      real(wp), intent(in) :: scale(:)
      real(wp), intent(in) :: damping
      real(wp), intent(out) :: step(:)
      real(wp), allocatable :: matrix(:, :), right(:, :), work(:)
      integer :: columns(count(free)), i, n, m, info
      step = 0.0_wp
      columns = pack([(i, i=1, size(free))], free)
      n = size(columns)
      m = size(residual) + n
      if (n == 0) return
      allocate (matrix(m, n), right(m, 1), source=0.0_wp)
      allocate (work(2*m + n))
      matrix(:size(residual), :) = jacobian(:, columns)
      right(:size(residual), 1) = -residual
      do i = 1, n
         matrix(size(residual) + i, i) = sqrt(damping)*max(norm2(jacobian(:, columns(i))), felt/scale(columns(i)))
      end do
      call dgels('N', m, n, 1, matrix, m, right, m, work, size(work), info)
      if (info == 0) step(columns) = right(:n, 1)
   end subroutine damped_step
end module dg_least_squares
