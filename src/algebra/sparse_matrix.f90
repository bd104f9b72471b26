!> The matrix of a chain of nodes by columns, as SuiteSparse takes it: entries that are zero are left out.
module dg_sparse_matrix
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type
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

   !> Set a sparse matrix from a block matrix; `upper` leaves out what stands below the diagonal. Room is taken the first time.
   pure subroutine set_sparse_matrix(matrix, sparse, upper)
      type(block_matrix_type), intent(in) :: matrix
      type(sparse_matrix_type), intent(inout) :: sparse
      logical, intent(in) :: upper
      integer :: n, j, nodes, place, column, block
      block = size(matrix%diagonal, 1)
      nodes = size(matrix%diagonal, 3)
      if (sparse%unknowns /= block*nodes) then
         if (allocated(sparse%columns)) deallocate (sparse%columns, sparse%rows, sparse%values)
         sparse%unknowns = block*nodes
         allocate (sparse%columns(sparse%unknowns + 1), sparse%rows(3*block*sparse%unknowns), &
                   sparse%values(3*block*sparse%unknowns))
      end if
      place = 0
      do n = 1, nodes
         do j = 1, block
            column = block*(n - 1) + j
            sparse%columns(column) = int(place, c_int)
            if (n > 1) call copy_block(matrix%upper(:, j, n - 1), block*(n - 2), sparse, place)
            call copy_block(matrix%diagonal(:merge(j, block, upper), j, n), block*(n - 1), sparse, place)
            if (n < nodes .and. .not. upper) call copy_block(matrix%lower(:, j, n), block*n, sparse, place)
         end do
      end do
      sparse%columns(sparse%unknowns + 1) = int(place, c_int)
      sparse%entries = place
   end subroutine set_sparse_matrix

   !> A column of a block below the first `above` rows, or the upper part of it, behind the `place` entries that there are; no
   !> zeros.
   pure subroutine copy_block(values, above, sparse, place)
      real(wp), intent(in) :: values(:)
      integer, intent(in) :: above
      type(sparse_matrix_type), intent(inout) :: sparse
      integer, intent(inout) :: place
      integer :: i
      do i = 1, size(values)
         if (.not. abs(values(i)) > 0.0_wp) cycle
         place = place + 1
         sparse%rows(place) = int(above + i - 1, c_int)
         sparse%values(place) = values(i)
      end do
   end subroutine copy_block
end module dg_sparse_matrix
