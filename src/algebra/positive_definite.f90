!> Whether a symmetric matrix of a chain of nodes, six unknowns each, is positive definite: whether all pivots of an elimination
!> without exchange of rows are positive.
!>
!> As in dg_block_solver both ends are eliminated at once towards the middle, a node and its mate side by side. Only halves of
!> blocks that are symmetric are worked on. What else stands on the diagonal is added on the way, and so is the square of an
!> element's row, as one more column that has been eliminated before: nothing is copied.
module dg_positive_definite
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, b => block_size
   implicit none
   private
   public :: block_positive_definite

   !> Nodes that go together: one of the upper half, its mate of the lower half.
   integer, parameter :: pair = 2

contains

   !> Whether the matrix is positive definite with `factor` times `added`(6,nodes) on its diagonal and, where they are given,
   !> stiffness(e) times the square of an element's row (12,e) by the unknowns of its two nodes. The upper blocks are not read:
   !> lower = transpose(upper).
   pure subroutine block_positive_definite(matrix, factor, added, definite, stiffness, rows)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: factor
      real(wp), intent(in) :: added(:, :)
      logical, intent(out) :: definite
      real(wp), intent(in), optional :: stiffness(:), rows(:, :)
      real(wp) :: column(pair, 2*b, 0:b)     ! the row, then those of the pivot block and, below, of the coupling towards the middle
      real(wp) :: taken(pair, b, b)          ! what the nodes before take off the pivot block, lower half
      real(wp) :: square(pair)               ! what the square of the row is taken times
      integer :: n, nodes, mate, middle
      nodes = size(matrix%diagonal, 3)
      middle = nodes/2 + 1
      taken = 0.0_wp
      square = 0.0_wp
      column(:, :, 0) = 0.0_wp
      do n = 1, middle
         mate = 2*middle - n
         if (n == middle) then
            call take_middle(matrix%diagonal(:, :, n), factor*added(:, n), taken, column)
         else
            call take_pair(matrix, factor, added, n, mate, taken, column)
            if (present(stiffness)) then
               square(1) = stiffness(n)
               if (mate <= nodes) square(2) = stiffness(mate - 1)
               call take_rows(rows(:, n), rows(:, min(mate, nodes) - 1), column)
            end if
         end if
         call eliminate(square, column, taken, definite)
         if (.not. definite) return
      end do
   end subroutine block_positive_definite

   !> Columns of a node and its mate side by side. In a chain of an even number the first node's mate is one beyond the last: a unit
   !> block, coupled with none.
   pure subroutine take_pair(matrix, factor, added, n, mate, taken, column)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: factor, added(:, :)
      integer, intent(in) :: n, mate
      real(wp), intent(in) :: taken(pair, b, b)
      real(wp), intent(inout) :: column(pair, 2*b, 0:b)
      real(wp), parameter :: nothing(b, b) = 0.0_wp
      integer :: j
      if (mate > size(matrix%diagonal, 3)) then
         call put_side_by_side(matrix%diagonal(:, :, n), nothing, matrix%lower(:, :, n), nothing, taken, column)
         do j = 1, b
            column(1, j, j) = column(1, j, j) + factor*added(j, n)
            column(2, j, j) = 1.0_wp
         end do
      else
         call put_side_by_side(matrix%diagonal(:, :, n), matrix%diagonal(:, :, mate), matrix%lower(:, :, n), &
                               matrix%lower(:, :, mate - 1), taken, column)
         do j = 1, b
            column(1, j, j) = column(1, j, j) + factor*added(j, n)
            column(2, j, j) = column(2, j, j) + factor*added(j, mate)
         end do
      end if
   end subroutine take_pair

   !> The middle node, from which both halves are taken, beside a unit block.
   pure subroutine take_middle(block, added, taken, column)
      real(wp), intent(in) :: block(b, b), added(b), taken(pair, b, b)
      real(wp), intent(out) :: column(pair, 2*b, 0:b)
      integer :: j
      column = 0.0_wp
      do j = 1, b
         column(1, j:b, j) = block(j:, j) - taken(1, j:, j) - taken(2, j:, j)
         column(1, j, j) = column(1, j, j) + added(j)
         column(2, j, j) = 1.0_wp
      end do
   end subroutine take_middle

   !> The mate's coupling is the transposed one: it lies above the mate.
   pure subroutine put_side_by_side(one, mate, below_one, above_mate, taken, column)
      real(wp), intent(in), dimension(b, b) :: one, mate, below_one, above_mate
      real(wp), intent(in) :: taken(pair, b, b)
      real(wp), intent(inout) :: column(pair, 2*b, 0:b)
      real(wp) :: both(pair)
      integer :: i, j
      do j = 1, b
         do i = j, b
            both(1) = one(i, j)
            both(2) = mate(i, j)
            column(:, i, j) = both - taken(:, i, j)
         end do
         do i = 1, b
            column(1, b + i, j) = below_one(i, j)
            column(2, b + i, j) = above_mate(j, i)
         end do
      end do
   end subroutine put_side_by_side

   !> Rows of the elements towards the middle, by the unknowns of the pair itself and, below, of the next nodes.
   pure subroutine take_rows(below_one, above_mate, column)
      real(wp), intent(in) :: below_one(b, 2), above_mate(b, 2)
      real(wp), intent(inout) :: column(pair, 2*b, 0:b)
      column(1, :b, 0) = below_one(:, 1)
      column(1, b + 1:, 0) = below_one(:, 2)
      column(2, :b, 0) = above_mate(:, 2)
      column(2, b + 1:, 0) = above_mate(:, 1)
   end subroutine take_rows

   !> Eliminates a pair of pivot blocks, column by column: each less what the columns before it have in its row, over their pivots;
   !> the row's is -1/square. `taken` is what that takes off the next nodes' blocks, lower half. Written out, so that the compiler
   !> keeps sums in registers.
   pure subroutine eliminate(square, a, taken, definite)
      real(wp), intent(in) :: square(pair)
      real(wp), intent(inout) :: a(pair, 2*b, 0:b)
      real(wp), intent(out) :: taken(pair, b, b)
      logical, intent(out) :: definite
      real(wp) :: l(pair, 2*b, 0:b)             ! columns over their pivots
      real(wp), dimension(pair) :: reciprocal, largest
      integer :: i, j
      definite = .false.
      largest = 0.0_wp
      do i = 1, 2*b
         l(:, i, 0) = -square*a(:, i, 0)
      end do
      do i = 1, 2*b
         a(:, i, 1) = a(:, i, 1) - l(:, i, 0)*a(:, 1, 0)
      end do
      if (.not. (a(1, 1, 1) > 0.0_wp .and. a(2, 1, 1) > 0.0_wp)) return
      largest = max(largest, a(:, 1, 1))
      reciprocal = 1.0_wp/a(:, 1, 1)
      do i = 2, 2*b
         l(:, i, 1) = a(:, i, 1)*reciprocal
      end do
      do i = 2, 2*b
         a(:, i, 2) = a(:, i, 2) - l(:, i, 0)*a(:, 2, 0) - l(:, i, 1)*a(:, 2, 1)
      end do
      if (.not. (a(1, 2, 2) > 0.0_wp .and. a(2, 2, 2) > 0.0_wp)) return
      largest = max(largest, a(:, 2, 2))
      reciprocal = 1.0_wp/a(:, 2, 2)
      do i = 3, 2*b
         l(:, i, 2) = a(:, i, 2)*reciprocal
      end do
      do i = 3, 2*b
         a(:, i, 3) = a(:, i, 3) - l(:, i, 0)*a(:, 3, 0) - l(:, i, 1)*a(:, 3, 1) - l(:, i, 2)*a(:, 3, 2)
      end do
      if (.not. (a(1, 3, 3) > 0.0_wp .and. a(2, 3, 3) > 0.0_wp)) return
      largest = max(largest, a(:, 3, 3))
      reciprocal = 1.0_wp/a(:, 3, 3)
      do i = 4, 2*b
         l(:, i, 3) = a(:, i, 3)*reciprocal
      end do
      do i = 4, 2*b
         a(:, i, 4) = a(:, i, 4) - l(:, i, 0)*a(:, 4, 0) - l(:, i, 1)*a(:, 4, 1) - l(:, i, 2)*a(:, 4, 2) - l(:, i, 3)*a(:, 4, 3)
      end do
      if (.not. (a(1, 4, 4) > 0.0_wp .and. a(2, 4, 4) > 0.0_wp)) return
      largest = max(largest, a(:, 4, 4))
      reciprocal = 1.0_wp/a(:, 4, 4)
      do i = 5, 2*b
         l(:, i, 4) = a(:, i, 4)*reciprocal
      end do
      do i = 5, 2*b
         a(:, i, 5) = a(:, i, 5) - l(:, i, 0)*a(:, 5, 0) - l(:, i, 1)*a(:, 5, 1) - l(:, i, 2)*a(:, 5, 2) - l(:, i, 3)*a(:, 5, 3) &
                         - l(:, i, 4)*a(:, 5, 4)
      end do
      if (.not. (a(1, 5, 5) > 0.0_wp .and. a(2, 5, 5) > 0.0_wp)) return
      largest = max(largest, a(:, 5, 5))
      reciprocal = 1.0_wp/a(:, 5, 5)
      do i = 6, 2*b
         l(:, i, 5) = a(:, i, 5)*reciprocal
      end do
      do i = 6, 2*b
         a(:, i, 6) = a(:, i, 6) - l(:, i, 0)*a(:, 6, 0) - l(:, i, 1)*a(:, 6, 1) - l(:, i, 2)*a(:, 6, 2) - l(:, i, 3)*a(:, 6, 3) &
                         - l(:, i, 4)*a(:, 6, 4) - l(:, i, 5)*a(:, 6, 5)
      end do
      if (.not. (a(1, 6, 6) > 0.0_wp .and. a(2, 6, 6) > 0.0_wp)) return
      largest = max(largest, a(:, 6, 6))
      reciprocal = 1.0_wp/a(:, 6, 6)
      do i = 7, 2*b
         l(:, i, 6) = a(:, i, 6)*reciprocal
      end do
      if (.not. (largest(1) <= huge(largest) .and. largest(2) <= huge(largest))) return
      definite = .true.
      do j = 1, b
         do i = j, b
            taken(:, i, j) = l(:, b + i, 0)*a(:, b + j, 0) + l(:, b + i, 1)*a(:, b + j, 1) + l(:, b + i, 2)*a(:, b + j, 2) &
                             + l(:, b + i, 3)*a(:, b + j, 3) + l(:, b + i, 4)*a(:, b + j, 4) + l(:, b + i, 5)*a(:, b + j, 5) &
                             + l(:, b + i, 6)*a(:, b + j, 6)
         end do
      end do
   end subroutine eliminate
end module dg_positive_definite
