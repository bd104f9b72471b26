!> Elimination of a bending beam's matrix, node by node.
!>
!> Blocks of 4 x 4 are eliminated without exchange of rows. Under tension the matrix is positive definite but for friction and
!> torque, whose part is small. An inexact step does no harm: dg_bending_solution judges it by the residual that it leaves.
!> LAPACK's band solver takes ten times the instructions for blocks as small as these.
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
      real(wp), intent(inout) :: x(:, :)    !< right-hand side (4,n) on entry, solution on return
      logical, intent(out) :: regular       !< .false. where a pivot vanishes: x is then no solution
      logical, intent(out) :: definite      !< .false. where a pivot is negative
      real(wp) :: pivot(b, b), right(b, b + 1)
      integer :: n, nodes, j
      nodes = size(x, 2)
      definite = .true.
      regular = .true.
      do n = 1, nodes
         pivot = matrix%diagonal(:, :, n)
         right(:, b + 1) = x(:, n)
         if (n > 1) call take_off_above(matrix%lower(:, :, n - 1), matrix%upper(:, :, n - 1), x(:, n - 1), pivot, right(:, b + 1))
         right(:, :b) = 0.0_wp
         if (n < nodes) right(:, :b) = matrix%upper(:, :, n)
         call solve_block(pivot, right, regular, definite)
         if (.not. regular) return
         if (n < nodes) matrix%upper(:, :, n) = right(:, :b)
         x(:, n) = right(:, b + 1)
      end do
      do n = nodes - 1, 1, -1
         do j = 1, b
            x(:, n) = x(:, n) - matrix%upper(:, j, n)*x(j, n + 1)
         end do
      end do
   end subroutine eliminate

   !> What the node above, eliminated, takes off the block and the right-hand side of a node.
   pure subroutine take_off_above(lower, eliminated, x, pivot, right)
      real(wp), intent(in) :: lower(b, b)        !< row of this node, column of the one above
      real(wp), intent(in) :: eliminated(b, b)   !< of the node above: its block's inverse times its upper block
      real(wp), intent(in) :: x(b)               !< and times its right-hand side
      real(wp), intent(inout) :: pivot(b, b), right(b)
      integer :: j, k
      do j = 1, b
         do k = 1, b
            pivot(:, j) = pivot(:, j) - lower(:, k)*eliminated(k, j)
         end do
         right = right - lower(:, j)*x(j)
      end do
   end subroutine take_off_above

   !> right <- pivot**-1 right.
   pure subroutine solve_block(pivot, right, regular, definite)
      real(wp), intent(inout) :: pivot(b, b), right(b, b + 1)
      logical, intent(out) :: regular
      logical, intent(inout) :: definite
      real(wp) :: share
      integer :: i, j, k
      regular = .true.
      do k = 1, b
         if (.not. abs(pivot(k, k)) > tiny(1.0_wp)) then
            regular = .false.
            return
         end if
         if (pivot(k, k) < 0.0_wp) definite = .false.
         share = 1.0_wp/pivot(k, k)
         do j = k + 1, b
            pivot(k, j) = pivot(k, j)*share
         end do
         do j = 1, b + 1
            right(k, j) = right(k, j)*share
         end do
         do j = k + 1, b
            do i = k + 1, b
               pivot(i, j) = pivot(i, j) - pivot(i, k)*pivot(k, j)
            end do
         end do
         do j = 1, b + 1
            do i = k + 1, b
               right(i, j) = right(i, j) - pivot(i, k)*right(k, j)
            end do
         end do
      end do
      do k = b, 2, -1
         do j = 1, b + 1
            do i = 1, k - 1
               right(i, j) = right(i, j) - pivot(i, k)*right(k, j)
            end do
         end do
      end do
   end subroutine solve_block
end module dg_bending_elimination
