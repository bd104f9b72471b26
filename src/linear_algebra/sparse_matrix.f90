!> The matrix of a chain of nodes by columns, as SuiteSparse takes it: entries that are zero are left out.
module dg_sparse_matrix
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   implicit none
   private
   public :: sparse_matrix_type, set_sparse_matrix

   type :: sparse_matrix_type
      integer :: unknowns = 0
      integer :: entries = 0
      integer(c_int), allocatable :: columns(:)  !< where each column begins, from 0 (unknowns + 1)
      integer(c_int), allocatable :: rows(:)     !< of the entries, from 0, ascending in each column
      real(c_double), allocatable :: values(:)
   end type sparse_matrix_type

contains

   !> Takes over a block matrix, with `factor` times `added`(6,nodes) on its diagonal where given; `lower` leaves out what
   !> stands above the diagonal. Room is taken the first time.
   pure subroutine set_sparse_matrix(matrix, sparse, lower, factor, added)
      type(block_matrix_type), intent(in) :: matrix
      type(sparse_matrix_type), intent(inout) :: sparse
      logical, intent(in) :: lower
      real(wp), intent(in), optional :: factor, added(:, :)
      real(wp) :: value
      integer :: n, i, j, nodes, place, column, first
      nodes = size(matrix%diagonal, 3)
      if (sparse%unknowns /= block_size*nodes) then
         if (allocated(sparse%columns)) deallocate (sparse%columns, sparse%rows, sparse%values)
         sparse%unknowns = block_size*nodes
         allocate (sparse%columns(sparse%unknowns + 1), sparse%rows(3*block_size*sparse%unknowns), &
                   sparse%values(3*block_size*sparse%unknowns))
      end if
      place = 0
      do n = 1, nodes
         do j = 1, block_size
            column = block_size*(n - 1) + j
            sparse%columns(column) = int(place, c_int)
            if (n > 1 .and. .not. lower) call put_block(matrix%upper(:, j, n - 1), n - 1, sparse, place)
            first = 1
            if (lower) first = j
            do i = first, block_size
               value = matrix%diagonal(i, j, n)
               if (present(factor) .and. present(added) .and. i == j) value = value + factor*added(i, n)
               call put_entry(value, block_size*(n - 1) + i, sparse, place)
            end do
            if (n < nodes) call put_block(matrix%lower(:, j, n), n + 1, sparse, place)
         end do
      end do
      sparse%columns(sparse%unknowns + 1) = int(place, c_int)
      sparse%entries = place
   end subroutine set_sparse_matrix

   !> A column of the block of node `row` behind the `place` entries that there are.
   pure subroutine put_block(values, row, sparse, place)
      real(wp), intent(in) :: values(:)
      integer, intent(in) :: row
      type(sparse_matrix_type), intent(inout) :: sparse
      integer, intent(inout) :: place
      integer :: i
      do i = 1, block_size
         call put_entry(values(i), block_size*(row - 1) + i, sparse, place)
      end do
   end subroutine put_block

   !> One entry, unless it is zero.
   pure subroutine put_entry(value, row, sparse, place)
      real(wp), intent(in) :: value
      integer, intent(in) :: row
      type(sparse_matrix_type), intent(inout) :: sparse
      integer, intent(inout) :: place
      if (.not. abs(value) > 0.0_wp) return
      place = place + 1
      sparse%rows(place) = int(row - 1, c_int)
      sparse%values(place) = value
   end subroutine put_entry
end module dg_sparse_matrix
