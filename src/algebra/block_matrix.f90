!> Matrix of a chain of nodes: square blocks on the diagonal and beside it. The assembly writes it, the linear solvers read it.
module dg_block_matrix
   use dg_kinds, only: wp
   implicit none
   private
   public :: block_matrix_type, make_matrix_room, new_block_matrix, new_symmetric_matrix, keep_symmetric, copy_symmetric
   public :: add_symmetric, block_product
   public :: block_size

   integer, parameter :: block_size = 6         !< unknowns of a node

   type :: block_matrix_type
      real(wp), allocatable :: diagonal(:, :, :) !< (6,6,nodes)
      real(wp), allocatable :: upper(:, :, :)    !< (6,6,nodes-1): row block n, column block n+1; of a matrix that is kept as
                                                 !< symmetric, where lower = transpose(upper), there is none
      real(wp), allocatable :: lower(:, :, :)    !< (6,6,nodes-1): row block n+1, column block n
   end type block_matrix_type

contains

   !> Room for the matrix of so many nodes, for an assembly that puts in every number.
   pure subroutine make_matrix_room(nodes, matrix)
      integer, intent(in) :: nodes
      type(block_matrix_type), intent(out) :: matrix
      integer, parameter :: b = block_size
      allocate (matrix%diagonal(b, b, nodes), matrix%upper(b, b, nodes - 1), matrix%lower(b, b, nodes - 1))
   end subroutine make_matrix_room

   !> A zero matrix for so many nodes.
   pure function new_block_matrix(nodes) result(matrix)
      integer, intent(in) :: nodes
      type(block_matrix_type) :: matrix
      call make_matrix_room(nodes, matrix)
      call clear(size(matrix%diagonal), matrix%diagonal)
      call clear(size(matrix%upper), matrix%upper)
      call clear(size(matrix%lower), matrix%lower)
   end function new_block_matrix

   !> Plain numbers, which go many at a time: `source=` goes column by column.
   pure subroutine clear(n, a)
      integer, intent(in) :: n
      real(wp), intent(out) :: a(n)
      a = 0.0_wp
   end subroutine clear

   !> Room for a symmetric matrix, for keep_symmetric.
   pure function new_symmetric_matrix(nodes) result(matrix)
      integer, intent(in) :: nodes
      type(block_matrix_type) :: matrix
      allocate (matrix%diagonal(block_size, block_size, nodes), matrix%lower(block_size, block_size, nodes - 1))
   end function new_symmetric_matrix

   !> kept <- matrix, which is symmetric, without its upper blocks.
   pure subroutine keep_symmetric(matrix, kept)
      type(block_matrix_type), intent(in) :: matrix
      type(block_matrix_type), intent(inout) :: kept
      call copy(size(matrix%diagonal), matrix%diagonal, kept%diagonal)
      call copy(size(matrix%lower), matrix%lower, kept%lower)
   end subroutine keep_symmetric

   !> matrix <- kept, its upper blocks as well.
   pure subroutine copy_symmetric(kept, matrix)
      type(block_matrix_type), intent(in) :: kept
      type(block_matrix_type), intent(inout) :: matrix
      integer :: n
      call keep_symmetric(kept, matrix)
      do n = 1, size(kept%lower, 3)
         call turn_over(kept%lower(:, :, n), matrix%upper(:, :, n))
      end do
   end subroutine copy_symmetric

   pure subroutine turn_over(lower, upper)
      real(wp), intent(in) :: lower(block_size, block_size)
      real(wp), intent(out) :: upper(block_size, block_size)
      integer :: i
      do i = 1, block_size
         upper(:, i) = lower(i, :)
      end do
   end subroutine turn_over

   !> Plain numbers, which go several at a time.
   pure subroutine copy(n, from, to)
      integer, intent(in) :: n
      real(wp), intent(in) :: from(n)
      real(wp), intent(out) :: to(n)
      to = from
   end subroutine copy

   !> matrix <- matrix + factor*other of symmetric matrices of the same size; the upper blocks are left as they are.
   pure subroutine add_symmetric(factor, other, matrix)
      real(wp), intent(in) :: factor
      type(block_matrix_type), intent(in) :: other
      type(block_matrix_type), intent(inout) :: matrix
      call add(size(matrix%diagonal), factor, other%diagonal, matrix%diagonal)
      call add(size(matrix%lower), factor, other%lower, matrix%lower)
   end subroutine add_symmetric

   pure subroutine add(n, factor, other, total)
      integer, intent(in) :: n
      real(wp), intent(in) :: factor, other(n)
      real(wp), intent(inout) :: total(n)
      total = total + factor*other
   end subroutine add

   !> Matrix times vector(6,nodes).
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
