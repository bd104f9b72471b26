!> Elimination of a bending beam's matrix, node by node.
!>
!> Blocks of 4 x 4 are inverted by their quarters, without exchange of rows. Under tension the matrix is positive definite but for
!> friction and torque, whose part is small. An inexact step does no harm: dg_bending_solution judges it by the residual that it
!> leaves. LAPACK's band solver takes ten times the instructions for blocks as small as these.
module dg_bending_elimination
   use dg_kinds, only: wp
   use dg_bending_beam, only: b => node_unknowns
   use dg_block_matrix, only: block_matrix_type
   implicit none
   private
   public :: eliminate

contains

   !> Solves matrix x = right-hand side. The matrix is used up.
   pure subroutine eliminate(matrix, x, regular, definite)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), contiguous, intent(inout) :: x(:, :)     !< right-hand side (4,n) on entry, solution on return
      logical, intent(out) :: regular       !< .false. where a pivot vanishes: x is then no solution
      logical, intent(out) :: definite      !< .false. where a pivot is negative
      real(wp) :: inverse(b, b), pivot(b, b), right(b)
      integer :: n, nodes
      nodes = size(x, 2)
      definite = .true.
      regular = .true.
      do n = 1, nodes
         pivot = matrix%diagonal(:, :, n)
         right = x(:, n)
         if (n > 1) then
            call take_off(matrix%lower(:, :, n - 1), matrix%upper(:, :, n - 1), pivot)
            right = right - product_of(matrix%lower(:, :, n - 1), x(:, n - 1))
         end if
         call invert(pivot, inverse, regular, definite)
         if (.not. regular) return
         x(:, n) = product_of(inverse, right)
         if (n == nodes) exit
         call multiply_by(inverse, matrix%upper(:, :, n))
      end do
      do n = nodes - 1, 1, -1
         right = product_of(matrix%upper(:, :, n), x(:, n + 1))
         x(:, n) = x(:, n) - right
      end do
   end subroutine eliminate

   !> Block times a node's unknowns.
   pure function product_of(a, x) result(y)
      real(wp), intent(in) :: a(b, b), x(b)
      real(wp) :: y(b)
      y = a(:, 1)*x(1) + a(:, 2)*x(2) + a(:, 3)*x(3) + a(:, 4)*x(4)
   end function product_of

   !> c <- c - a d, of blocks.
   pure subroutine take_off(a, d, c)
      real(wp), intent(in) :: a(b, b), d(b, b)
      real(wp), intent(inout) :: c(b, b)
      integer :: j
      do j = 1, b
         c(:, j) = c(:, j) - (a(:, 1)*d(1, j) + a(:, 2)*d(2, j) + a(:, 3)*d(3, j) + a(:, 4)*d(4, j))
      end do
   end subroutine take_off

   !> d <- a d, of blocks.
   pure subroutine multiply_by(a, d)
      real(wp), intent(in) :: a(b, b)
      real(wp), intent(inout) :: d(b, b)
      real(wp) :: x(b)
      integer :: j
      do j = 1, b
         x = d(:, j)
         d(:, j) = a(:, 1)*x(1) + a(:, 2)*x(2) + a(:, 3)*x(3) + a(:, 4)*x(4)
      end do
   end subroutine multiply_by

   !> Inverse of a block: of its upper left quarter, then of what that leaves of the lower right one.
   pure subroutine invert(a, inverse, regular, definite)
      real(wp), intent(in) :: a(b, b)
      real(wp), intent(out) :: inverse(b, b)
      logical, intent(out) :: regular
      logical, intent(inout) :: definite
      real(wp), dimension(2, 2) :: first, second, right, left, above, below
      call invert_quarter(a(1, 1), a(2, 1), a(1, 2), a(2, 2), first, regular, definite)
      if (.not. regular) return
      right = a(1:2, 3:4)
      left = a(3:4, 1:2)
      above = quarter_product(first, right)
      below = quarter_product(left, first)
      second = a(3:4, 3:4) - quarter_product(left, above)
      call invert_quarter(second(1, 1), second(2, 1), second(1, 2), second(2, 2), second, regular, definite)
      if (.not. regular) return
      inverse(3:4, 3:4) = second
      right = -quarter_product(above, second)
      left = -quarter_product(second, below)
      inverse(1:2, 3:4) = right
      inverse(3:4, 1:2) = left
      inverse(1:2, 1:2) = first - quarter_product(above, left)
   end subroutine invert

   !> Product of two quarters.
   pure function quarter_product(a, c) result(product)
      real(wp), intent(in) :: a(2, 2), c(2, 2)
      real(wp) :: product(2, 2)
      product(:, 1) = a(:, 1)*c(1, 1) + a(:, 2)*c(2, 1)
      product(:, 2) = a(:, 1)*c(1, 2) + a(:, 2)*c(2, 2)
   end function quarter_product

   !> Inverse of a quarter, and whether both its pivots are positive.
   pure subroutine invert_quarter(a_11, a_21, a_12, a_22, inverse, regular, definite)
      real(wp), value :: a_11, a_21, a_12, a_22
      real(wp), intent(inout) :: inverse(2, 2)
      logical, intent(out) :: regular
      logical, intent(inout) :: definite
      real(wp) :: determinant, share
      determinant = a_11*a_22 - a_12*a_21
      regular = abs(determinant) > tiny(1.0_wp)
      definite = definite .and. a_11 > 0.0_wp .and. determinant > 0.0_wp
      if (.not. regular) return
      share = 1.0_wp/determinant
      inverse(1, 1) = a_22*share
      inverse(2, 2) = a_11*share
      inverse(1, 2) = -a_12*share
      inverse(2, 1) = -a_21*share
   end subroutine invert_quarter
end module dg_bending_elimination
