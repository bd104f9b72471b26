!> Test of positive definiteness of a symmetric matrix of a chain of nodes with six unknowns each. The matrix is positive definite
!> if all pivots of an elimination without exchange of rows are positive.
module dg_positive_definite
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, b => block_size
   implicit none
   private
   public :: block_positive_definite

contains

   !> Test if the matrix is positive definite with `factor` times `added`(6,nodes) on its diagonal and, where they are given, the
   !> terms of elements. A term is stiffness(e) times the square of an element's row (12,e) by the unknowns of its two nodes. The
   !> upper blocks are not read: lower = transpose(upper).
   pure subroutine block_positive_definite(matrix, factor, added, definite, stiffness, rows)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: factor
      real(wp), intent(in) :: added(:, :)
      logical, intent(out) :: definite
      real(wp), intent(in), optional :: stiffness(:), rows(:, :)
      real(wp) :: a(2*b, 2*b)             ! a node and the next one, lower half; of the latter what the nodes above make of it
      integer :: n, j, nodes
      nodes = size(matrix%diagonal, 3)
      a = 0.0_wp
      do n = 1, nodes
         a(:b, :b) = matrix%diagonal(:, :, n) + a(b + 1:, b + 1:)
         a(:, b + 1:) = 0.0_wp
         do j = 1, b
            a(j, j) = a(j, j) + factor*added(j, n)
         end do
         if (n < nodes) then
            a(b + 1:, :b) = matrix%lower(:, :, n)
            if (present(stiffness)) then
               if (stiffness(n) > 0.0_wp) then
                  do j = 1, 2*b
                     a(:, j) = a(:, j) + (stiffness(n)*rows(j, n))*rows(:, n)
                  end do
               end if
            end if
         else
            a(b + 1:, :b) = 0.0_wp
         end if
         call eliminate(a, definite)
         if (.not. definite) return
      end do
   end subroutine block_positive_definite

   !> Eliminates the first six unknowns.
   pure subroutine eliminate(a, definite)
      real(wp), intent(inout) :: a(2*b, 2*b)
      logical, intent(out) :: definite
      real(wp) :: reciprocal
      integer :: j, k
      do k = 1, b
         definite = a(k, k) > 0.0_wp .and. a(k, k) <= huge(reciprocal)
         if (.not. definite) return
         reciprocal = 1.0_wp/a(k, k)
         do j = k + 1, b
            a(:, j) = a(:, j) - (a(j, k)*reciprocal)*a(:, k)
         end do
         do j = b + 1, 2*b
            a(b + 1:, j) = a(b + 1:, j) - (a(j, k)*reciprocal)*a(b + 1:, k)
         end do
      end do
   end subroutine eliminate
end module dg_positive_definite
