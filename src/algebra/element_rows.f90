!> Rows by the unknowns of an element's two nodes, those of the upper node first, and what they do to the matrix and the vectors of
!> a chain of nodes. Nodes have six unknowns, or three in a plane: numbers that the compiler knows, so that it writes loops out.
module dg_element_rows
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size, plane_block_size
   implicit none
   private
   public :: add_dyad, add_rows, multiply_rows

contains

   !> matrix <- matrix + factor a b^T of the rows a and b of element e.
   pure subroutine add_dyad(factor, a, b, e, matrix)
      real(wp), intent(in) :: factor
      real(wp), intent(in), contiguous :: a(:), b(:)
      integer, intent(in) :: e
      type(block_matrix_type), intent(inout) :: matrix
      if (size(a) == 2*block_size) then
         call dyad_of_six(factor, a, b, matrix%diagonal(:, :, e), matrix%upper(:, :, e), matrix%lower(:, :, e), &
                          matrix%diagonal(:, :, e + 1))
      else
         call dyad_of_three(factor, a, b, matrix%diagonal(:, :, e), matrix%upper(:, :, e), matrix%lower(:, :, e), &
                            matrix%diagonal(:, :, e + 1))
      end if
   end subroutine add_dyad

   pure subroutine dyad_of_six(factor, a, b, above, upper, lower, below)
      integer, parameter :: u = block_size
      real(wp), intent(in) :: factor, a(u, 2), b(u, 2)
      real(wp), intent(inout), dimension(u, u) :: above, upper, lower, below
      real(wp) :: i(u), j(u)
      i = factor*a(:, 1)
      j = factor*a(:, 2)
      call add_product(i, b(:, 1), above)
      call add_product(j, b(:, 1), lower)
      call add_product(i, b(:, 2), upper)
      call add_product(j, b(:, 2), below)
   end subroutine dyad_of_six

   !> block <- block + a b^T.
   pure subroutine add_product(a, b, block)
      integer, parameter :: u = block_size
      real(wp), intent(in) :: a(u), b(u)
      real(wp), intent(inout) :: block(u, u)
      integer :: c
      do c = 1, u
         block(:, c) = block(:, c) + a*b(c)
      end do
   end subroutine add_product

   pure subroutine dyad_of_three(factor, a, b, above, upper, lower, below)
      integer, parameter :: u = plane_block_size
      real(wp), intent(in) :: factor, a(u, 2), b(u, 2)
      real(wp), intent(inout), dimension(u, u) :: above, upper, lower, below
      real(wp) :: i(u), j(u)
      integer :: c
      i = factor*a(:, 1)
      j = factor*a(:, 2)
      do c = 1, u
         above(:, c) = above(:, c) + i*b(c, 1)
         lower(:, c) = lower(:, c) + j*b(c, 1)
         upper(:, c) = upper(:, c) + i*b(c, 2)
         below(:, c) = below(:, c) + j*b(c, 2)
      end do
   end subroutine dyad_of_three

   !> vector(u,elements + 1) <- vector + rows^T factor: every element's row (2 u,elements) with its own factor, on both its nodes.
   pure subroutine add_rows(u, elements, factor, rows, vector)
      integer, intent(in) :: u, elements
      real(wp), intent(in) :: factor(elements), rows(2*u, elements)
      real(wp), intent(inout) :: vector(u, elements + 1)
      if (u == block_size) then
         call rows_of_six(elements, factor, rows, vector)
      else
         call rows_of_three(elements, factor, rows, vector)
      end if
   end subroutine add_rows

   pure subroutine rows_of_six(elements, factor, rows, vector)
      integer, intent(in) :: elements
      real(wp), intent(in) :: factor(elements), rows(block_size, 2, elements)
      real(wp), intent(inout) :: vector(block_size, elements + 1)
      integer :: e
      do e = 1, elements
         vector(:, e) = vector(:, e) + factor(e)*rows(:, 1, e)
         vector(:, e + 1) = vector(:, e + 1) + factor(e)*rows(:, 2, e)
      end do
   end subroutine rows_of_six

   pure subroutine rows_of_three(elements, factor, rows, vector)
      integer, intent(in) :: elements
      real(wp), intent(in) :: factor(elements), rows(plane_block_size, 2, elements)
      real(wp), intent(inout) :: vector(plane_block_size, elements + 1)
      integer :: e
      do e = 1, elements
         vector(:, e) = vector(:, e) + factor(e)*rows(:, 1, e)
         vector(:, e + 1) = vector(:, e + 1) + factor(e)*rows(:, 2, e)
      end do
   end subroutine rows_of_three

   !> product(elements) = rows vector: every element's row (2 u,elements) by the vector(u,elements + 1) of its nodes.
   pure subroutine multiply_rows(u, elements, rows, vector, product)
      integer, intent(in) :: u, elements
      real(wp), intent(in) :: rows(u, 2, elements), vector(u, elements + 1)
      real(wp), intent(out) :: product(elements)
      integer :: e
      if (u == block_size) then
         do e = 1, elements
            product(e) = rows(1, 1, e)*vector(1, e) + rows(1, 2, e)*vector(1, e + 1) &
                         + rows(2, 1, e)*vector(2, e) + rows(2, 2, e)*vector(2, e + 1) &
                         + rows(3, 1, e)*vector(3, e) + rows(3, 2, e)*vector(3, e + 1) &
                         + rows(4, 1, e)*vector(4, e) + rows(4, 2, e)*vector(4, e + 1) &
                         + rows(5, 1, e)*vector(5, e) + rows(5, 2, e)*vector(5, e + 1) &
                         + rows(6, 1, e)*vector(6, e) + rows(6, 2, e)*vector(6, e + 1)
         end do
      else
         do e = 1, elements
            product(e) = rows(1, 1, e)*vector(1, e) + rows(1, 2, e)*vector(1, e + 1) &
                         + rows(2, 1, e)*vector(2, e) + rows(2, 2, e)*vector(2, e + 1) &
                         + rows(3, 1, e)*vector(3, e) + rows(3, 2, e)*vector(3, e + 1)
         end do
      end if
   end subroutine multiply_rows
end module dg_element_rows
