!> The largest of plain numbers.
module dg_largest
   use dg_kinds, only: wp
   implicit none
   private
   public :: largest_of, largest_of_rows

contains

   !> Largest size of n numbers; huge where one of them is infinite or none: what is compared with it must not pass. `max` alone may
   !> leave out a number that is none.
   pure function largest_of(n, numbers) result(largest)
      integer, intent(in) :: n
      real(wp), intent(in) :: numbers(n)
      real(wp) :: largest, one
      integer :: i
      largest = 0.0_wp
      do i = 1, n
         one = abs(numbers(i))
         if (.not. one <= huge(one)) one = huge(one)
         largest = max(largest, one)
      end do
   end function largest_of

   !> The same of each row of numbers(rows,n).
   pure subroutine largest_of_rows(rows, n, numbers, largest)
      integer, intent(in) :: rows, n
      real(wp), intent(in) :: numbers(rows, n)
      real(wp), intent(out) :: largest(rows)
      real(wp) :: one
      integer :: i, j
      largest = 0.0_wp
      do j = 1, n
         do i = 1, rows
            one = abs(numbers(i, j))
            if (.not. one <= huge(one)) one = huge(one)
            largest(i) = max(largest(i), one)
         end do
      end do
   end subroutine largest_of_rows
end module dg_largest
