!> Matrix of a chain of nodes: square blocks on the diagonal and beside it, 6 x 6 in space, 3 x 3 where a string is solved in a
!> plane. The assembly writes it, the linear solvers read it.
module dg_block_matrix
   use dg_kinds, only: wp
   implicit none
   private
   public :: block_matrix_type, new_block_matrix, block_product, block_size, plane_block_size

   integer, parameter :: block_size = 6         !< unknowns of a node in space
   integer, parameter :: plane_block_size = 3   !< in a plane

   type :: block_matrix_type
      real(wp), allocatable :: diagonal(:, :, :) !< (b,b,nodes), b unknowns a node
      real(wp), allocatable :: upper(:, :, :)    !< (b,b,nodes-1): row block n, column block n+1
      real(wp), allocatable :: lower(:, :, :)    !< (b,b,nodes-1): row block n+1, column block n
   end type block_matrix_type

contains

   !> A zero matrix for so many nodes.
   pure function new_block_matrix(nodes, unknowns) result(matrix)
      integer, intent(in) :: nodes
      integer, intent(in), optional :: unknowns   !< of a node; absent: block_size
      type(block_matrix_type) :: matrix
      integer :: b
      b = block_size
      if (present(unknowns)) b = unknowns
      allocate (matrix%diagonal(b, b, nodes), source=0.0_wp)
      allocate (matrix%upper(b, b, nodes - 1), source=0.0_wp)
      allocate (matrix%lower(b, b, nodes - 1), source=0.0_wp)
   end function new_block_matrix

   !> Matrix times vector(b,nodes).
   pure function block_product(matrix, vector) result(product)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: vector(:, :)
      real(wp) :: product(size(vector, 1), size(vector, 2))
      integer :: n
      do n = 1, size(vector, 2)
         product(:, n) = matmul(matrix%diagonal(:, :, n), vector(:, n))
         if (n > 1) product(:, n) = product(:, n) + matmul(matrix%lower(:, :, n - 1), vector(:, n - 1))
         if (n < size(vector, 2)) product(:, n) = product(:, n) + matmul(matrix%upper(:, :, n), vector(:, n + 1))
      end do
   end function block_product
end module dg_block_matrix
