!> Elimination of a chain of nodes block by block (6 x 6) from both ends at once, rows exchanged only within a block.
!>
!> From above D_n <- D_n - L_(n-1) V_(n-1), V_n = D_n^-1 U_n, from below the same with L and U exchanged; in the middle both meet,
!> and on the way back x_n = z_n - V_n x_(n+1). The two halves have nothing to do with each other until then. A node of the one
!> and its mate of the other go side by side through every operation, two numbers that lie next to each other: a processor takes
!> them in one instruction, and waits half as often for a result.
!>
!> A seventh of the time of a band LU, at a price: no row is exchanged between nodes, so that a nearly singular block may let
!> numbers grow. The caller checks the solution against the matrix itself, refines it where that asks for it, and takes the band
!> solver where that does not help.
module dg_block_solver
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   implicit none
   private
   public :: block_solver_type, new_block_solver, block_solve

   !> Nodes that go together: one of the upper half, its mate of the lower half.
   integer, parameter :: pair = 2
   !> Right-hand sides of a pivot block: the coupling's six columns and the load.
   integer, parameter :: sides = block_size + 1, load = sides

   type :: block_solver_type
      real(wp), allocatable :: solved(:, :, :, :)  !< V of each pair (pair,6,6,nodes/2); z = D^-1 of the load is kept in x
   end type block_solver_type

contains

   !> Room for a chain of so many nodes; the solver may be used again for any number of matrices.
   pure subroutine new_block_solver(nodes, solver)
      integer, intent(in) :: nodes
      type(block_solver_type), intent(out) :: solver
      allocate (solver%solved(pair, block_size, block_size, nodes/2))
   end subroutine new_block_solver

   !> Solves; x(6,nodes) is the right-hand side before, the solution after. info = 0: done; > 0: the block of the node that is
   !> the info-th from one of the ends is singular, and x is neither.
   pure subroutine block_solve(solver, matrix, x, info)
      type(block_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      integer, intent(out) :: info
      real(wp), dimension(pair, block_size, sides) :: pivot, side    ! blocks and, last, loads
      real(wp) :: beside(pair, block_size, block_size)
      real(wp), dimension(pair, block_size) :: z, y, next
      logical :: regular
      integer :: n, i, mate, middle
      middle = size(x, 2)/2 + 1
      info = 0
      do n = 1, middle - 1
         mate = 2*middle - n
         call take_pair(matrix, x, n, mate, pivot, beside, side)
         if (n > 1) call subtract_product(beside, solver%solved(:, :, :, n - 1), z, pivot)
         side(:, :, load) = pivot(:, :, load)
         call factor_pair(pivot, side, regular)
         if (.not. regular) then
            info = n
            return
         end if
         call solve_sides(pivot, side, solver%solved(:, :, :, n), z)
         x(:, n) = z(1, :)
         if (mate <= size(x, 2)) x(:, mate) = z(2, :)
      end do
      call solve_middle(solver, matrix, middle, z, x(:, middle), regular)
      if (.not. regular) then
         info = middle
         return
      end if
      next(1, :) = x(:, middle)
      next(2, :) = x(:, middle)
      do n = middle - 1, 1, -1
         mate = 2*middle - n
         z(1, :) = x(:, n)
         z(2, :) = x(:, min(mate, size(x, 2)))
         associate (v => solver%solved(:, :, :, n))
            do i = 1, block_size
               y(:, i) = z(:, i) - v(:, i, 1)*next(:, 1) - v(:, i, 2)*next(:, 2) - v(:, i, 3)*next(:, 3) &
                         - v(:, i, 4)*next(:, 4) - v(:, i, 5)*next(:, 5) - v(:, i, 6)*next(:, 6)
            end do
         end associate
         next = y
         x(:, n) = next(1, :)
         if (mate <= size(x, 2)) x(:, mate) = next(2, :)
      end do
   end subroutine block_solve

   !> The blocks of a node and its mate side by side: on the diagonal with the load, towards the ends (`beside`), and towards the
   !> middle. In a chain of an even number the first node's mate is one beyond the last: a unit block, coupled with none.
   pure subroutine take_pair(matrix, x, n, mate, pivot, beside, side)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: x(:, :)
      integer, intent(in) :: n, mate
      real(wp), intent(out) :: pivot(pair, block_size, sides), beside(pair, block_size, block_size)
      real(wp), intent(out) :: side(pair, block_size, sides)
      real(wp), parameter :: nothing(block_size, block_size) = 0.0_wp
      integer :: i
      if (mate > size(x, 2)) then
         call put_side_by_side(matrix%diagonal(:, :, n), nothing, pivot)
         call put_side_by_side(matrix%upper(:, :, n), nothing, side)
         do i = 1, block_size
            pivot(2, i, i) = 1.0_wp
         end do
         pivot(1, :, load) = x(:, n)
         pivot(2, :, load) = 0.0_wp
         return
      end if
      call put_side_by_side(matrix%diagonal(:, :, n), matrix%diagonal(:, :, mate), pivot)
      call put_side_by_side(matrix%upper(:, :, n), matrix%lower(:, :, mate - 1), side)
      pivot(1, :, load) = x(:, n)
      pivot(2, :, load) = x(:, mate)
      if (n == 1) return
      if (mate < size(x, 2)) then
         call put_side_by_side(matrix%lower(:, :, n - 1), matrix%upper(:, :, mate), beside)
      else
         call put_side_by_side(matrix%lower(:, :, n - 1), nothing, beside)
      end if
   end subroutine take_pair

   pure subroutine put_side_by_side(one, other, both)
      real(wp), intent(in) :: one(block_size**2), other(block_size**2)
      real(wp), intent(inout) :: both(pair, block_size**2)
      integer :: i
      do i = 1, block_size**2
         both(1, i) = one(i)
         both(2, i) = other(i)
      end do
   end subroutine put_side_by_side

   !> Solves for the middle node, x its load before, from which and from whose block both halves are taken off.
   pure subroutine solve_middle(solver, matrix, middle, z, x, regular)
      type(block_solver_type), intent(in) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(in) :: middle
      real(wp), intent(in) :: z(pair, block_size)     !< of the pair before
      real(wp), intent(inout) :: x(block_size)
      logical, intent(out) :: regular
      real(wp), dimension(pair, block_size, block_size) :: pivot, beside, unused
      real(wp) :: side(pair, block_size, sides), solution(pair, block_size)
      integer :: i
      side = 0.0_wp
      if (middle > 1) then
         beside = 0.0_wp
         beside(1, :, :) = matrix%lower(:, :, middle - 1)
         if (middle < size(matrix%diagonal, 3)) beside(2, :, :) = matrix%upper(:, :, middle)
         call subtract_product(beside, solver%solved(:, :, :, middle - 1), z, side)
      end if
      pivot(1, :, :) = matrix%diagonal(:, :, middle) + side(1, :, :block_size) + side(2, :, :block_size)
      x = x + side(1, :, load) + side(2, :, load)
      side = 0.0_wp
      side(1, :, load) = x
      pivot(2, :, :) = 0.0_wp
      do i = 1, block_size
         pivot(2, i, i) = 1.0_wp
      end do
      call factor_pair(pivot, side, regular)
      if (.not. regular) return
      call solve_sides(pivot, side, unused, solution)
      x = solution(1, :)
   end subroutine solve_middle

   !> c <- c - a [v z].
   pure subroutine subtract_product(a, v, z, c)
      real(wp), intent(in), dimension(pair, block_size, block_size) :: a, v
      real(wp), intent(in) :: z(pair, block_size)
      real(wp), intent(inout) :: c(pair, block_size, sides)
      integer :: j
      do j = 1, block_size
         call subtract_column(a, v(:, :, j), c(:, :, j))
      end do
      call subtract_column(a, z, c(:, :, load))
   end subroutine subtract_product

   pure subroutine subtract_column(a, b, c)
      real(wp), intent(in) :: a(pair, block_size, block_size), b(pair, block_size)
      real(wp), intent(inout) :: c(pair, block_size)
      integer :: i
      do i = 1, block_size
         c(:, i) = c(:, i) - a(:, i, 1)*b(:, 1) - a(:, i, 2)*b(:, 2) - a(:, i, 3)*b(:, 3) &
                   - a(:, i, 4)*b(:, 4) - a(:, i, 5)*b(:, 5) - a(:, i, 6)*b(:, 6)
      end do
   end subroutine subtract_column

   !> LU factors of a pair of blocks in place, column by column, with row exchange, in the right-hand sides too; the diagonal of U
   !> is stored inverted. Not regular where a pivot is zero or out of range. Written out, so that the compiler keeps sums in
   !> registers: a third of the time of loops.
   pure subroutine factor_pair(a, side, regular)
      real(wp), intent(inout) :: a(pair, block_size, block_size), side(pair, block_size, sides)
      logical, intent(out) :: regular
      real(wp), dimension(pair) :: largest, lag
      largest = max(abs(a(:, 1, 1)), abs(a(:, 2, 1)), abs(a(:, 3, 1)), abs(a(:, 4, 1)), abs(a(:, 5, 1)), abs(a(:, 6, 1)))
      call look_at_pivots(largest, regular)
      if (.not. regular) return
      lag = largest - abs(a(:, 1, 1))
      if (lag(1) + lag(2) > 0.0_wp) call exchange_rows(1, largest, a, side)
      a(:, 1, 1) = 1.0_wp/a(:, 1, 1)
      a(:, 2, 1) = a(:, 2, 1)*a(:, 1, 1)
      a(:, 3, 1) = a(:, 3, 1)*a(:, 1, 1)
      a(:, 4, 1) = a(:, 4, 1)*a(:, 1, 1)
      a(:, 5, 1) = a(:, 5, 1)*a(:, 1, 1)
      a(:, 6, 1) = a(:, 6, 1)*a(:, 1, 1)
      a(:, 2, 2) = a(:, 2, 2) - a(:, 2, 1)*a(:, 1, 2)
      a(:, 3, 2) = a(:, 3, 2) - a(:, 3, 1)*a(:, 1, 2)
      a(:, 4, 2) = a(:, 4, 2) - a(:, 4, 1)*a(:, 1, 2)
      a(:, 5, 2) = a(:, 5, 2) - a(:, 5, 1)*a(:, 1, 2)
      a(:, 6, 2) = a(:, 6, 2) - a(:, 6, 1)*a(:, 1, 2)
      largest = max(abs(a(:, 2, 2)), abs(a(:, 3, 2)), abs(a(:, 4, 2)), abs(a(:, 5, 2)), abs(a(:, 6, 2)))
      call look_at_pivots(largest, regular)
      if (.not. regular) return
      lag = largest - abs(a(:, 2, 2))
      if (lag(1) + lag(2) > 0.0_wp) call exchange_rows(2, largest, a, side)
      a(:, 2, 2) = 1.0_wp/a(:, 2, 2)
      a(:, 3, 2) = a(:, 3, 2)*a(:, 2, 2)
      a(:, 4, 2) = a(:, 4, 2)*a(:, 2, 2)
      a(:, 5, 2) = a(:, 5, 2)*a(:, 2, 2)
      a(:, 6, 2) = a(:, 6, 2)*a(:, 2, 2)
      a(:, 2, 3) = a(:, 2, 3) - a(:, 2, 1)*a(:, 1, 3)
      a(:, 3, 3) = a(:, 3, 3) - a(:, 3, 1)*a(:, 1, 3) - a(:, 3, 2)*a(:, 2, 3)
      a(:, 4, 3) = a(:, 4, 3) - a(:, 4, 1)*a(:, 1, 3) - a(:, 4, 2)*a(:, 2, 3)
      a(:, 5, 3) = a(:, 5, 3) - a(:, 5, 1)*a(:, 1, 3) - a(:, 5, 2)*a(:, 2, 3)
      a(:, 6, 3) = a(:, 6, 3) - a(:, 6, 1)*a(:, 1, 3) - a(:, 6, 2)*a(:, 2, 3)
      largest = max(abs(a(:, 3, 3)), abs(a(:, 4, 3)), abs(a(:, 5, 3)), abs(a(:, 6, 3)))
      call look_at_pivots(largest, regular)
      if (.not. regular) return
      lag = largest - abs(a(:, 3, 3))
      if (lag(1) + lag(2) > 0.0_wp) call exchange_rows(3, largest, a, side)
      a(:, 3, 3) = 1.0_wp/a(:, 3, 3)
      a(:, 4, 3) = a(:, 4, 3)*a(:, 3, 3)
      a(:, 5, 3) = a(:, 5, 3)*a(:, 3, 3)
      a(:, 6, 3) = a(:, 6, 3)*a(:, 3, 3)
      a(:, 2, 4) = a(:, 2, 4) - a(:, 2, 1)*a(:, 1, 4)
      a(:, 3, 4) = a(:, 3, 4) - a(:, 3, 1)*a(:, 1, 4) - a(:, 3, 2)*a(:, 2, 4)
      a(:, 4, 4) = a(:, 4, 4) - a(:, 4, 1)*a(:, 1, 4) - a(:, 4, 2)*a(:, 2, 4) - a(:, 4, 3)*a(:, 3, 4)
      a(:, 5, 4) = a(:, 5, 4) - a(:, 5, 1)*a(:, 1, 4) - a(:, 5, 2)*a(:, 2, 4) - a(:, 5, 3)*a(:, 3, 4)
      a(:, 6, 4) = a(:, 6, 4) - a(:, 6, 1)*a(:, 1, 4) - a(:, 6, 2)*a(:, 2, 4) - a(:, 6, 3)*a(:, 3, 4)
      largest = max(abs(a(:, 4, 4)), abs(a(:, 5, 4)), abs(a(:, 6, 4)))
      call look_at_pivots(largest, regular)
      if (.not. regular) return
      lag = largest - abs(a(:, 4, 4))
      if (lag(1) + lag(2) > 0.0_wp) call exchange_rows(4, largest, a, side)
      a(:, 4, 4) = 1.0_wp/a(:, 4, 4)
      a(:, 5, 4) = a(:, 5, 4)*a(:, 4, 4)
      a(:, 6, 4) = a(:, 6, 4)*a(:, 4, 4)
      a(:, 2, 5) = a(:, 2, 5) - a(:, 2, 1)*a(:, 1, 5)
      a(:, 3, 5) = a(:, 3, 5) - a(:, 3, 1)*a(:, 1, 5) - a(:, 3, 2)*a(:, 2, 5)
      a(:, 4, 5) = a(:, 4, 5) - a(:, 4, 1)*a(:, 1, 5) - a(:, 4, 2)*a(:, 2, 5) - a(:, 4, 3)*a(:, 3, 5)
      a(:, 5, 5) = a(:, 5, 5) - a(:, 5, 1)*a(:, 1, 5) - a(:, 5, 2)*a(:, 2, 5) - a(:, 5, 3)*a(:, 3, 5) &
                     - a(:, 5, 4)*a(:, 4, 5)
      a(:, 6, 5) = a(:, 6, 5) - a(:, 6, 1)*a(:, 1, 5) - a(:, 6, 2)*a(:, 2, 5) - a(:, 6, 3)*a(:, 3, 5) &
                     - a(:, 6, 4)*a(:, 4, 5)
      largest = max(abs(a(:, 5, 5)), abs(a(:, 6, 5)))
      call look_at_pivots(largest, regular)
      if (.not. regular) return
      lag = largest - abs(a(:, 5, 5))
      if (lag(1) + lag(2) > 0.0_wp) call exchange_rows(5, largest, a, side)
      a(:, 5, 5) = 1.0_wp/a(:, 5, 5)
      a(:, 6, 5) = a(:, 6, 5)*a(:, 5, 5)
      a(:, 2, 6) = a(:, 2, 6) - a(:, 2, 1)*a(:, 1, 6)
      a(:, 3, 6) = a(:, 3, 6) - a(:, 3, 1)*a(:, 1, 6) - a(:, 3, 2)*a(:, 2, 6)
      a(:, 4, 6) = a(:, 4, 6) - a(:, 4, 1)*a(:, 1, 6) - a(:, 4, 2)*a(:, 2, 6) - a(:, 4, 3)*a(:, 3, 6)
      a(:, 5, 6) = a(:, 5, 6) - a(:, 5, 1)*a(:, 1, 6) - a(:, 5, 2)*a(:, 2, 6) - a(:, 5, 3)*a(:, 3, 6) &
                     - a(:, 5, 4)*a(:, 4, 6)
      a(:, 6, 6) = a(:, 6, 6) - a(:, 6, 1)*a(:, 1, 6) - a(:, 6, 2)*a(:, 2, 6) - a(:, 6, 3)*a(:, 3, 6) &
                     - a(:, 6, 4)*a(:, 4, 6) - a(:, 6, 5)*a(:, 5, 6)
      call look_at_pivots(abs(a(:, 6, 6)), regular)
      if (.not. regular) return
      a(:, 6, 6) = 1.0_wp/a(:, 6, 6)
   end subroutine factor_pair

   !> Whether the pivots of a pair may divide: neither is zero, infinite or none.
   pure subroutine look_at_pivots(largest, regular)
      real(wp), intent(in) :: largest(pair)     !< sizes
      logical, intent(out) :: regular
      regular = largest(1) > 0.0_wp .and. largest(2) > 0.0_wp .and. largest(1) <= huge(largest) .and. largest(2) <= huge(largest)
   end subroutine look_at_pivots

   !> Puts the largest of column k, from the diagonal down, on the diagonal of either block where it is not there.
   pure subroutine exchange_rows(k, largest, a, side)
      integer, intent(in) :: k
      real(wp), intent(in) :: largest(pair)
      real(wp), intent(inout) :: a(pair, block_size, block_size), side(pair, block_size, sides)
      real(wp) :: kept
      integer :: row, lane, j
      do lane = 1, pair
         row = k
         do while (abs(a(lane, row, k)) < largest(lane))
            row = row + 1
         end do
         if (row == k) cycle
         do j = 1, block_size
            kept = a(lane, k, j)
            a(lane, k, j) = a(lane, row, j)
            a(lane, row, j) = kept
         end do
         do j = 1, sides
            kept = side(lane, k, j)
            side(lane, k, j) = side(lane, row, j)
            side(lane, row, j) = kept
         end do
      end do
   end subroutine exchange_rows

   !> [v z] <- a^-1 side, a as of factor_pair.
   pure subroutine solve_sides(a, side, v, z)
      real(wp), intent(in) :: a(pair, block_size, block_size), side(pair, block_size, sides)
      real(wp), intent(out) :: v(pair, block_size, block_size), z(pair, block_size)
      integer :: s
      do s = 1, block_size
         call solve_side(a, side(:, :, s), v(:, :, s))
      end do
      call solve_side(a, side(:, :, load), z)
   end subroutine solve_sides

   pure subroutine solve_side(a, side, x)
      real(wp), intent(in) :: a(pair, block_size, block_size), side(pair, block_size)
      real(wp), intent(out) :: x(pair, block_size)
      real(wp), dimension(pair) :: y1, y2, y3, y4, y5, y6
      y1 = side(:, 1)
      y2 = side(:, 2) - a(:, 2, 1)*y1
      y3 = side(:, 3) - a(:, 3, 1)*y1 - a(:, 3, 2)*y2
      y4 = side(:, 4) - a(:, 4, 1)*y1 - a(:, 4, 2)*y2 - a(:, 4, 3)*y3
      y5 = side(:, 5) - a(:, 5, 1)*y1 - a(:, 5, 2)*y2 - a(:, 5, 3)*y3 - a(:, 5, 4)*y4
      y6 = side(:, 6) - a(:, 6, 1)*y1 - a(:, 6, 2)*y2 - a(:, 6, 3)*y3 - a(:, 6, 4)*y4 - a(:, 6, 5)*y5
      y6 = y6*a(:, 6, 6)
      y5 = (y5 - a(:, 5, 6)*y6)*a(:, 5, 5)
      y4 = (y4 - a(:, 4, 6)*y6 - a(:, 4, 5)*y5)*a(:, 4, 4)
      y3 = (y3 - a(:, 3, 6)*y6 - a(:, 3, 5)*y5 - a(:, 3, 4)*y4)*a(:, 3, 3)
      y2 = (y2 - a(:, 2, 6)*y6 - a(:, 2, 5)*y5 - a(:, 2, 4)*y4 - a(:, 2, 3)*y3)*a(:, 2, 2)
      y1 = (y1 - a(:, 1, 6)*y6 - a(:, 1, 5)*y5 - a(:, 1, 4)*y4 - a(:, 1, 3)*y3 - a(:, 1, 2)*y2)*a(:, 1, 1)
      x(:, 1) = y1
      x(:, 2) = y2
      x(:, 3) = y3
      x(:, 4) = y4
      x(:, 5) = y5
      x(:, 6) = y6
   end subroutine solve_side
end module dg_block_solver
