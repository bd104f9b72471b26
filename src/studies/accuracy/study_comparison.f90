!> Comparison of the solutions of a study: errors against the finest, order of convergence, and settings that are worth their cost.
!> SI units.
module dg_study_comparison
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_missing, only: is_missing, missing
   use dg_study_variant, only: is_finer, same_but_mesh, variant_type
   implicit none
   private
   public :: study_record_type, new_record, compare_case, compare_lines, pareto_set
   public :: error_hookload, error_torque, error_normal_force, error_bending, error_bending_rms, error_count
   public :: fit_order

   integer, parameter :: error_hookload = 1
   integer, parameter :: error_torque = 2
   integer, parameter :: error_normal_force = 3 !< sum of contact forces
   integer, parameter :: error_bending = 4      !< of the bending moment along the string, the largest
   integer, parameter :: error_bending_rms = 5  !< the same, root mean square
   integer, parameter :: error_count = 5

   !> One solution: a variant of one load case.
   type :: study_record_type
      integer :: status = 0
      real(wp) :: hookload = 0.0_wp            !< [N]
      real(wp) :: torque = 0.0_wp              !< at the top [N.m]
      real(wp) :: normal_force = 0.0_wp        !< sum of contact forces [N]
      real(wp) :: bending = 0.0_wp             !< greatest bending moment [N.m]
      integer :: iterations = 0
      integer :: elements = 0
      real(wp) :: mean_length = 0.0_wp         !< of its elements [m]
      real(wp) :: seconds = 0.0_wp
      real(wp) :: memory = missing             !< greatest use while it was solved [bytes]
      real(wp), allocatable :: md(:)           !< where moments are known [m]
      real(wp), allocatable :: moments(:)      !< [N.m]
      ! found by compare_case
      logical :: is_reference = .false.
      logical :: in_pareto_set = .false.
      real(wp) :: errors(error_count) = missing !< against the reference [-]
      real(wp) :: orders(error_count) = missing !< of convergence, of all variants that differ in element length alone [-]
      real(wp) :: cost = missing               !< seconds over the reference's [-]
   end type study_record_type

   !> Torque below which its relative error is ignored [N.m].
   real(wp), parameter :: least_torque = 1.0_wp
   !> Errors up to this count as equal, and give no order of convergence [-]. Two gaps that came to rest in another order make
   !> as much.
   real(wp), parameter :: no_difference = 1.0e-7_wp

   !> Orders that are accepted [-]. Beyond them points do not define one.
   real(wp), parameter :: lowest_order = 0.1_wp, highest_order = 8.0_wp
   real(wp), parameter :: order_step = 0.01_wp

contains

   !> Make the record of a result for a study.
   pure subroutine new_record(result, seconds, memory, record)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: seconds, memory
      type(study_record_type), intent(out) :: record
      integer :: n
      record%status = result%status
      record%hookload = result%hookload
      record%torque = result%torque
      record%normal_force = result%normal_force
      record%iterations = result%iterations
      record%elements = result%elements
      record%seconds = seconds
      record%memory = memory
      if (.not. allocated(result%profile%md)) return
      record%md = result%profile%md
      record%moments = result%profile%bending
      record%bending = maxval(record%moments)
      n = size(record%md)
      record%mean_length = (record%md(n) - record%md(1))/max(1, result%elements)
   end subroutine new_record

   !> Compares all variants of one load case: the finest that converged is the reference.
   pure subroutine compare_case(variants, records)
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(inout) :: records(:)   !< one a variant
      real(wp) :: worst(size(records)), seconds(size(records))
      integer :: i, best
      best = finest_of(variants, records, [(.true., i=1, size(records))])
      if (best == 0) return
      records(best)%is_reference = .true.
      do i = 1, size(records)
         if (records(i)%status /= result_converged) cycle
         records(i)%errors = relative_errors(records(i), records(best))
         if (records(best)%seconds > 0.0_wp) records(i)%cost = records(i)%seconds/records(best)%seconds
      end do
      do i = 1, size(records)
         call find_orders(variants, records, i)
         worst(i) = worst_error(records(i)%errors)
         seconds(i) = records(i)%seconds
      end do
      records%in_pareto_set = pareto_set(worst, seconds)
   end subroutine compare_case

   !> Error of hook load or torque, the larger of the two [-]; missing where neither is known.
   pure function worst_error(errors) result(worst)
      real(wp), intent(in) :: errors(:)
      real(wp) :: worst
      worst = errors(error_hookload)
      if (is_missing(worst)) then
         worst = errors(error_torque)
      else if (.not. is_missing(errors(error_torque))) then
         worst = max(worst, errors(error_torque))
      end if
   end function worst_error

   !> Finest of the chosen variants that converged; 0 if none did.
   pure function finest_of(variants, records, chosen) result(best)
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(in) :: records(:)
      logical, intent(in) :: chosen(:)
      integer :: best
      integer :: i
      best = 0
      do i = 1, size(records)
         if (.not. chosen(i) .or. records(i)%status /= result_converged) cycle
         if (best == 0) then
            best = i
         else if (is_finer(variants(i), variants(best))) then
            best = i
         end if
      end do
   end function finest_of

   !> Errors of a record against a reference [-]. Moments: largest and root mean square of the difference along the string, over the
   !> greatest of the reference.
   pure function relative_errors(record, reference) result(errors)
      type(study_record_type), intent(in) :: record, reference
      real(wp) :: errors(error_count)
      real(wp) :: largest, rms
      errors = missing
      errors(error_hookload) = over(record%hookload - reference%hookload, reference%hookload, 0.0_wp)
      errors(error_torque) = over(record%torque - reference%torque, reference%torque, least_torque)
      errors(error_normal_force) = over(record%normal_force - reference%normal_force, reference%normal_force, 0.0_wp)
      if (.not. (allocated(record%md) .and. allocated(reference%md))) return
      call compare_lines(record%md, record%moments, reference%md, reference%moments, largest, rms)
      errors(error_bending) = over(largest, reference%bending, 0.0_wp)
      errors(error_bending_rms) = over(rms, reference%bending, 0.0_wp)
   end function relative_errors

   !> |difference| over |whole|, missing where the whole is too small.
   pure function over(difference, whole, least) result(share)
      real(wp), intent(in) :: difference, whole, least
      real(wp) :: share
      share = missing
      if (abs(whole) > least) share = abs(difference)/abs(whole)
   end function over

   !> Largest difference of two values along the string, and its root mean square: straight lines between the points of each, at the
   !> points of both.
   pure subroutine compare_lines(md, values, other_md, others, largest, rms)
      real(wp), intent(in) :: md(:), values(:), other_md(:), others(:)   !< depths never decrease
      real(wp), intent(out) :: largest, rms
      real(wp) :: place, before, difference, last, squares
      integer :: i, j
      i = 1
      j = 1
      largest = 0.0_wp
      squares = 0.0_wp
      before = max(md(1), other_md(1))
      last = 0.0_wp
      do while (i <= size(md) .and. j <= size(other_md))
         place = min(md(i), other_md(j))
         difference = value_at(md, values, i, place) - value_at(other_md, others, j, place)
         largest = max(largest, abs(difference))
         if (place > before) then
            squares = squares + (place - before)*(last**2 + last*difference + difference**2)/3.0_wp
            before = place
         end if
         last = difference
         if (.not. md(i) > place) i = i + 1
         if (.not. other_md(j) > place) j = j + 1
      end do
      rms = largest
      place = before - max(md(1), other_md(1))
      if (place > 0.0_wp) rms = sqrt(squares/place)
   end subroutine compare_lines

   !> Value on the straight line that ends at point `i`; that of the first point above it.
   pure function value_at(md, values, i, place) result(value)
      real(wp), intent(in) :: md(:), values(:), place
      integer, intent(in) :: i
      real(wp) :: value
      value = values(i)
      if (i == 1) return
      if (md(i) > md(i - 1)) value = value - (values(i) - values(i - 1))*(md(i) - place)/(md(i) - md(i - 1))
   end function value_at

   !> Orders of convergence of variant `i` from all that differ from it in element length alone, against their own finest.
   pure subroutine find_orders(variants, records, i)
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(inout) :: records(:)
      integer, intent(in) :: i
      logical :: family(size(records))
      real(wp) :: differences(size(records), error_count), lengths(size(records))
      integer :: j, k, best
      do j = 1, size(records)
         family(j) = same_but_mesh(variants(i), variants(j)) .and. records(j)%status == result_converged
      end do
      best = finest_of(variants, records, family)
      if (best == 0) return
      differences = 0.0_wp
      do j = 1, size(records)
         lengths(j) = records(j)%mean_length
         if (.not. family(j)) cycle
         differences(j, :) = relative_errors(records(j), records(best))
         where (is_missing(differences(j, :))) differences(j, :) = 0.0_wp
      end do
      do k = 1, error_count
         call fit_order(lengths, differences(:, k), lengths(best), no_difference, records(i)%orders(k))
      end do
   end subroutine find_orders

   !> True for those of several ways that are worth their price. For such a way no other one is at least as accurate and at
   !> least as fast, and better in one. Ways without error are not.
   pure function pareto_set(errors, seconds) result(worth)
      real(wp), intent(in) :: errors(:)     !< [-]; missing where there is no solution
      real(wp), intent(in) :: seconds(:)
      logical :: worth(size(errors))
      real(wp) :: rounded(size(errors))
      integer :: i, j
      worth = .not. is_missing(errors)
      rounded = errors
      where (worth) rounded = max(errors, no_difference)
      do i = 1, size(errors)
         if (.not. worth(i)) cycle
         do j = 1, size(errors)
            if (j == i .or. is_missing(errors(j))) cycle
            if (rounded(j) <= rounded(i) .and. seconds(j) <= seconds(i) .and. &
                (rounded(j) < rounded(i) .or. seconds(j) < seconds(i))) worth(i) = .false.
         end do
      end do
   end function pareto_set

   !> The order p of values v(h) = v(0) + C h^p that best fits the differences |v(h) - v(h_finest)| = |C| (h^p - h_finest^p):
   !> least squares of their logarithms. So the finest solution's own error, which would raise the order of the points near
   !> it, is taken into account. `missing` where fewer than two points stand out, or no order within 0.1 and 8 fits best.
   pure subroutine fit_order(lengths, differences, finest, floor, order)
      real(wp), intent(in) :: lengths(:)      !< h [m]
      real(wp), intent(in) :: differences(:)  !< >= 0, in any unit
      real(wp), intent(in) :: finest          !< h of the finest solution [m]
      real(wp), intent(in) :: floor           !< differences up to this are round-off
      real(wp), intent(out) :: order
      logical :: used(size(lengths))
      real(wp) :: p, spread, least, mean
      real(wp), allocatable :: h(:), d(:), r(:)
      integer :: step, steps, n
      order = missing
      used = lengths > finest*(1.0_wp + 1.0e-6_wp) .and. differences > floor
      n = count(used)
      if (n < 2) return
      allocate (h(n), d(n), r(n))
      h = pack(lengths, used)
      d = pack(differences, used)
      if (.not. maxval(h) > minval(h)*(1.0_wp + 1.0e-6_wp)) return
      steps = nint((highest_order - lowest_order)/order_step)
      least = huge(least)
      do step = 0, steps
         p = lowest_order + step*order_step
         r = log(d) - log(h**p - finest**p)
         mean = sum(r)/n
         spread = sum((r - mean)**2)
         if (spread >= least) cycle
         least = spread
         order = p
         if (step == 0 .or. step == steps) order = missing
      end do
   end subroutine fit_order
end module dg_study_comparison
