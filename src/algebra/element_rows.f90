!> Rows by the unknowns of an element's two nodes, those of the upper node first. Products of such rows with the matrix and the
!> vectors of a chain of nodes.
module dg_element_rows
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, u => block_size
   implicit none
   private
   public :: add_dyad, add_rows, multiply_rows

contains

   !> matrix <- matrix + factor a b^T of the rows a and b of element e.
   pure subroutine add_dyad(factor, a, b, e, matrix)
      real(wp), intent(in) :: factor
      real(wp), intent(in) :: a(u, 2), b(u, 2)
      integer, intent(in) :: e
      type(block_matrix_type), intent(inout) :: matrix
      call add_product(factor*a(:, 1), b(:, 1), matrix%diagonal(:, :, e))
      call add_product(factor*a(:, 2), b(:, 1), matrix%lower(:, :, e))
      call add_product(factor*a(:, 1), b(:, 2), matrix%upper(:, :, e))
      call add_product(factor*a(:, 2), b(:, 2), matrix%diagonal(:, :, e + 1))
   end subroutine add_dyad

   !> block <- block + a b^T.
   pure subroutine add_product(a, b, block)
      real(wp), intent(in) :: a(u), b(u)
      real(wp), intent(inout) :: block(u, u)
      integer :: c
      do c = 1, u
         block(:, c) = block(:, c) + a*b(c)
      end do
   end subroutine add_product

   !> vector <- vector + rows^T factor: every element's row with its own factor, on both its nodes.
   pure subroutine add_rows(elements, factor, rows, vector)
      integer, intent(in) :: elements
      real(wp), intent(in) :: factor(elements), rows(u, 2, elements)
      real(wp), intent(inout) :: vector(u, elements + 1)
      integer :: e
      do e = 1, elements
         vector(:, e) = vector(:, e) + factor(e)*rows(:, 1, e)
         vector(:, e + 1) = vector(:, e + 1) + factor(e)*rows(:, 2, e)
      end do
   end subroutine add_rows

   !> product = rows vector: every element's row by the vector of its nodes.
   pure subroutine multiply_rows(elements, rows, vector, product)
      integer, intent(in) :: elements
      real(wp), intent(in) :: rows(u, 2, elements), vector(u, elements + 1)
      real(wp), intent(out) :: product(elements)
      integer :: e
      do e = 1, elements
         product(e) = sum(rows(:, 1, e)*vector(:, e) + rows(:, 2, e)*vector(:, e + 1))
      end do
   end subroutine multiply_rows
end module dg_element_rows
