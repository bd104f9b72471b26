!> The largest of plain numbers.
module dg_largest
   use dg_kinds, only: wp
   implicit none
   private
   public :: largest_of

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
end module dg_largest
