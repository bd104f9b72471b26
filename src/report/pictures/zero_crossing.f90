!> Zeros of a bending moment between two rows. A profile has its magnitude, which a line from row to row does not bring to zero.
!>
!> The moment changes by shear force times length. Where that is the sum of the magnitudes of two rows, its sign changes between
!> them. A moment that turns about the string has no zero.
module dg_zero_crossing
   use dg_kinds, only: wp
   implicit none
   private
   public :: add_zeros

   !> Difference from the sum of two magnitudes, of that sum [-]: shear times length is exact without contact between the rows.
   real(wp), parameter :: alike = 0.02_wp

contains

   !> Add a row with a moment of zero between rows where its sign changes.
   pure subroutine add_zeros(md, moment, shear)
      real(wp), allocatable, intent(inout) :: md(:), moment(:)   !< [m], magnitudes [N.m]; longer by the rows that are new
      real(wp), intent(in) :: shear(:)                           !< magnitudes, one a row [N]
      real(wp) :: places(2*size(md)), values(2*size(md))
      integer :: i, n
      n = 0
      do i = 1, size(md)
         n = n + 1
         places(n) = md(i)
         values(n) = moment(i)
         if (i == size(md)) exit
         if (.not. crosses(md(i + 1) - md(i), moment(i:i + 1), shear(i:i + 1))) cycle
         n = n + 1
         places(n) = md(i) + (md(i + 1) - md(i))*moment(i)/(moment(i) + moment(i + 1))
         values(n) = 0.0_wp
      end do
      md = places(:n)
      moment = values(:n)
   end subroutine add_zeros

   !> True if the moment has another sign at the second of two rows.
   pure function crosses(length, moment, shear) result(does)
      real(wp), intent(in) :: length, moment(2), shear(2)
      logical :: does
      real(wp) :: change, tolerance
      change = 0.5_wp*(shear(1) + shear(2))*length
      tolerance = alike*sum(moment)
      does = minval(moment) > tolerance*alike .and. abs(change - sum(moment)) <= tolerance .and. &
             abs(change - abs(moment(2) - moment(1))) > tolerance
   end function crosses
end module dg_zero_crossing
