!> Comparison of another program's results with ours along the hole: differences, and their places of origin.
!>
!> Forces of a string are summed from the bit up. A difference at some depth may come from anywhere below. Its growth over each
!> interval of the hole shows the place.
module dg_legacy_comparison
   use dg_kinds, only: wp
   use dg_hole_interval, only: hole_intervals, interval_type
   use dg_profile, only: profile_type, side_above, side_below
   use dg_trajectory, only: trajectory_type
   use dg_quantity, only: quantity_force, quantity_line_load, quantity_moment
   implicit none
   private
   public :: comparison_type, parting_type, compare_with_legacy, agreement
   public :: legacy_table_type, quantity_count, quantity_axial, quantity_torque, quantity_side_force, quantity_of

   integer, parameter :: quantity_axial = 1       !< effective, tension > 0 [N]
   integer, parameter :: quantity_torque = 2      !< [N.m]
   integer, parameter :: quantity_side_force = 3  !< normal contact force per metre [N/m]
   integer, parameter :: quantity_count = 3
   !> Units that they are shown in.
   integer, parameter :: quantity_of(quantity_count) = [quantity_force, quantity_moment, quantity_line_load]

   !> Results of another program for one load case: depths, and any of axial force, torque, side force.
   type :: legacy_table_type
      character(:), allocatable :: label             !< safe as part of a file name
      character(:), allocatable :: file
      character(:), allocatable :: skipped           !< rows of the file that are not read, in words; '': all are
      integer :: case_index = 0                      !< in the model's cases
      logical :: has(quantity_count) = .false.
      real(wp), allocatable :: md(:)                 !< ascending [m]
      real(wp), allocatable :: values(:, :)          !< (size(md), quantity_count); zero where a quantity is missing
   end type legacy_table_type

   !> Largest difference over the largest value up to which two programs agree [-].
   real(wp), parameter :: agreement = 1.0e-3_wp
   !> Two programs part where the difference has grown to this part of the largest one [-].
   real(wp), parameter :: parted = 0.05_wp

   !> One quantity: the difference between two programs, and the depth where they part.
   type :: parting_type
      logical :: present = .false.
      logical :: agrees = .true.              !< to `agreement`
      real(wp) :: scale = 0.0_wp              !< our largest absolute value [SI]
      real(wp) :: largest = 0.0_wp            !< difference of largest size, theirs less ours [SI]
      real(wp) :: largest_md = 0.0_wp         !< [m]
      real(wp) :: mean = 0.0_wp               !< of absolute differences [SI]
      real(wp) :: parting_md = 0.0_wp         !< lowest depth above which they are apart [m]
      real(wp) :: at_bottom = 0.0_wp          !< difference at the lowest depth, of a quantity that is summed up [SI]
      integer :: worst = 0                    !< interval with the largest growth of the difference; 0: the lowest depth has more
      real(wp) :: share = 0.0_wp              !< of that in all growth and what is there at the lowest depth [-]
      real(wp), allocatable :: growth(:)      !< of the difference over each interval, from its lower to its upper end [SI];
                                              !< for side force the integral of the difference [N]
   end type parting_type

   type :: comparison_type
      real(wp), allocatable :: md(:)          !< depths of theirs within our string [m]
      real(wp), allocatable :: ours(:, :)     !< (size(md), quantity_count) [SI]
      real(wp), allocatable :: theirs(:, :)   !< the same
      integer :: outside = 0                  !< rows of theirs beyond our string
      type(interval_type), allocatable :: intervals(:)
      type(parting_type) :: parting(quantity_count)
   end type comparison_type

contains

   !> Compare a table with a profile. Rows beyond the ends of the string are counted and left out. If the profile has two rows
   !> at a depth, within round-off, the lower side is compared. If the table also has two, each is compared with its own.
   pure subroutine compare_with_legacy(table, profile, trajectory, comparison)
      type(legacy_table_type), intent(in) :: table
      type(profile_type), intent(in) :: profile
      type(trajectory_type), intent(in) :: trajectory
      type(comparison_type), intent(out) :: comparison
      logical :: inside(size(table%md))
      real(wp) :: slack, md
      integer :: i, n
      n = size(profile%md)
      slack = 1.0e-6_wp*profile%md(n)     ! round-off of converted depths
      inside = table%md >= profile%md(1) - slack .and. table%md <= profile%md(n) + slack
      comparison%md = pack(table%md, inside)
      comparison%outside = count(.not. inside)
      allocate (comparison%theirs(size(comparison%md), quantity_count), comparison%ours(size(comparison%md), quantity_count))
      do i = 1, quantity_count
         comparison%theirs(:, i) = pack(table%values(:, i), inside)
      end do
      do i = 1, size(comparison%md)
         md = comparison%md(i)
         n = findloc(abs(profile%md - md) <= slack .and. &
                     profile%side == merge(side_above, side_below, is_upper(comparison%md, i)), .true., dim=1)
         if (n > 0) then
            comparison%ours(i, :) = [profile%axial(n), profile%torque(n), profile%side_force(n)]
         else
            comparison%ours(i, :) = [interpolated(profile%md, profile%axial, md), interpolated(profile%md, profile%torque, md), &
                                     interpolated(profile%md, profile%side_force, md)]
         end if
      end do
      allocate (comparison%intervals, source=hole_intervals(trajectory, profile%md(size(profile%md))))
      if (size(comparison%md) == 0) return
      do i = 1, quantity_count
         if (table%has(i)) call find_parting(comparison%md, comparison%theirs(:, i) - comparison%ours(:, i), &
                                             maxval(abs(comparison%ours(:, i))), comparison%intervals, &
                                             i == quantity_axial .or. i == quantity_torque, comparison%parting(i))
      end do
   end subroutine compare_with_legacy

   !> True for the first of two rows at a depth.
   pure function is_upper(md, row) result(upper)
      real(wp), intent(in) :: md(:)
      integer, intent(in) :: row
      logical :: upper
      upper = .false.
      if (row < size(md)) upper = md(row + 1) <= md(row)
   end function is_upper

   !> Where a difference arises. `summed`: the quantity is summed up along the string; else its integral is judged.
   pure subroutine find_parting(md, difference, scale, intervals, summed, parting)
      real(wp), intent(in) :: md(:)           !< ascending [m]
      real(wp), intent(in) :: difference(:)   !< theirs less ours
      real(wp), intent(in) :: scale           !< our largest absolute value
      type(interval_type), intent(in) :: intervals(:)
      logical, intent(in) :: summed
      type(parting_type), intent(out) :: parting
      integer :: at, i
      real(wp) :: total, largest, most, total_there(size(md))
      at = maxloc(abs(difference), 1)
      parting%present = .true.
      parting%scale = scale
      parting%largest = difference(at)
      parting%largest_md = md(at)
      parting%mean = sum(abs(difference))/real(size(md), wp)
      parting%agrees = abs(parting%largest) <= agreement*scale
      total_there = difference
      if (.not. summed) then
         total_there(size(md)) = 0.0_wp
         do i = size(md) - 1, 1, -1
            total_there(i) = total_there(i + 1) + 0.5_wp*(difference(i) + difference(i + 1))*(md(i + 1) - md(i))
         end do
      end if
      allocate (parting%growth(size(intervals)))
      do i = 1, size(intervals)
         parting%growth(i) = interpolated(md, total_there, intervals(i)%md_top) &
                             - interpolated(md, total_there, intervals(i)%md_bottom)
      end do
      if (summed) parting%at_bottom = difference(size(md))
      parting%worst = maxloc(abs(parting%growth), 1)
      largest = abs(parting%growth(parting%worst))
      if (abs(parting%at_bottom) > largest) then
         parting%worst = 0
         largest = abs(parting%at_bottom)
      end if
      total = sum(abs(parting%growth)) + abs(parting%at_bottom)
      if (total > 0.0_wp) parting%share = largest/total
      ! The lowest of the depths from which they are apart; the row below still agrees.
      parting%parting_md = md(1)
      most = maxval(abs(total_there - total_there(size(md))))
      do i = size(md), 1, -1
         if (abs(total_there(i) - total_there(size(md))) > parted*most) then
            parting%parting_md = md(min(i + 1, size(md)))
            exit
         end if
      end do
   end subroutine find_parting

   !> Linear interpolation in a table; its end values beyond its ends. At a place that stands twice, the second value.
   pure function interpolated(x, y, at) result(value)
      real(wp), intent(in) :: x(:)   !< never decreasing
      real(wp), intent(in) :: y(:)
      real(wp), intent(in) :: at
      real(wp) :: value
      integer :: low, high, middle
      low = 1
      high = size(x)
      if (at <= x(low)) then
         value = y(low)
      else if (at >= x(high)) then
         value = y(high)
      else
         do while (high - low > 1)
            middle = (low + high)/2
            if (x(middle) <= at) then
               low = middle
            else
               high = middle
            end if
         end do
         value = y(low) + (y(high) - y(low))*(at - x(low))/(x(high) - x(low))
      end if
   end function interpolated
end module dg_legacy_comparison
