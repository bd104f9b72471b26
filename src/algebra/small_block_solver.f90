!> Elimination of a chain of nodes with three unknowns each, block by block from both ends at once.
!>
!> The pass of dg_block_solver with blocks so small that each is inverted by its cofactors: no rows are exchanged, and the units of
!> rows and columns, forces beside moments, do not matter. As there the solution is checked against the matrix by who asks for it.
module dg_small_block_solver
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, b => plane_block_size
   use dg_largest, only: largest_of
   implicit none
   private
   public :: small_block_solver_type, new_small_block_solver, small_block_solve, small_block_remainder

   !> Nodes that go together: one of the upper half, its mate of the lower half.
   integer, parameter :: pair = 2
   !> Right-hand sides of a pivot block: the coupling's three columns and the load.
   integer, parameter :: sides = b + 1, load = sides
   !> A node that is none has the first, and is coupled with others by the second.
   real(wp), parameter :: unit(b, b) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [b, b])
   real(wp), parameter :: nothing(b, b) = 0.0_wp

   type :: small_block_solver_type
      real(wp), allocatable :: solved(:, :, :, :)  !< V and z, as of dg_block_solver (pair,3,sides,nodes/2)
   end type small_block_solver_type

contains

   !> Room for a chain of so many nodes; the solver may be used again for any number of matrices.
   pure subroutine new_small_block_solver(nodes, solver)
      integer, intent(in) :: nodes
      type(small_block_solver_type), intent(out) :: solver
      allocate (solver%solved(pair, b, sides, nodes/2))
   end subroutine new_small_block_solver

   !> Solves; x(3,nodes) is the right-hand side before, the solution after. info = 0: done; > 0: the block of the node that is
   !> the info-th from one of the ends is singular.
   pure subroutine small_block_solve(solver, matrix, x, info)
      type(small_block_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout), contiguous :: x(:, :)
      integer, intent(out) :: info
      real(wp), dimension(pair, b, sides) :: pivot, side, last
      real(wp) :: beside(pair, b, b), next(pair, b)
      logical :: regular
      integer :: n, mate, middle, nodes
      nodes = size(x, 2)
      middle = nodes/2 + 1
      do n = 1, middle - 1
         call take_pair(matrix, x, n, 2*middle - n, pivot, beside, side)
         if (n > 1) call subtract_product(beside, solver%solved(:, :, :, n - 1), pivot)
         side(:, :, load) = pivot(:, :, load)
         call divide(pivot, side, solver%solved(:, :, :, n), regular)
         info = n
         if (.not. regular) return
      end do
      ! the middle node, and a unit block beside it
      call put_side_by_side(matrix%diagonal(:, :, middle), unit, pivot)
      pivot(1, :, load) = x(:, middle)
      pivot(2, :, load) = 0.0_wp
      if (middle > 1) then
         call put_side_by_side(matrix%lower(:, :, middle - 1), nothing, beside)
         if (middle < nodes) beside(2, :, :) = matrix%upper(:, :, middle)
         side = 0.0_wp
         call subtract_product(beside, solver%solved(:, :, :, middle - 1), side)
         pivot(1, :, :) = pivot(1, :, :) + side(1, :, :) + side(2, :, :)
      end if
      side(:, :, :b) = 0.0_wp
      side(:, :, load) = pivot(:, :, load)
      call divide(pivot, side, last, regular)
      info = merge(0, middle, regular)
      if (.not. regular) return
      next = spread(last(1, :, load), 1, pair)
      x(:, middle) = next(1, :)
      do n = middle - 1, 1, -1
         mate = 2*middle - n
         call go_back(solver%solved(:, :, :, n), next)
         x(:, n) = next(1, :)
         if (mate <= nodes) x(:, mate) = next(2, :)
      end do
   end subroutine small_block_solve

   !> The blocks of a node and its mate side by side: on the diagonal with the load, towards the ends (`beside`), and towards the
   !> middle. In a chain of an even number the first node's mate is one beyond the last: a unit block, coupled with none.
   pure subroutine take_pair(matrix, x, n, mate, pivot, beside, side)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in), contiguous :: x(:, :)
      integer, intent(in) :: n, mate
      real(wp), intent(inout), dimension(pair, b, sides) :: pivot, side
      real(wp), intent(inout) :: beside(pair, b, b)
      integer :: nodes
      nodes = size(x, 2)
      pivot(1, :, load) = x(:, n)
      if (mate > nodes) then
         call put_side_by_side(matrix%diagonal(:, :, n), unit, pivot)
         call put_side_by_side(matrix%upper(:, :, n), nothing, side)
         pivot(2, :, load) = 0.0_wp
         return
      end if
      call put_side_by_side(matrix%diagonal(:, :, n), matrix%diagonal(:, :, mate), pivot)
      call put_side_by_side(matrix%upper(:, :, n), matrix%lower(:, :, mate - 1), side)
      pivot(2, :, load) = x(:, mate)
      if (n == 1) return
      if (mate < nodes) then
         call put_side_by_side(matrix%lower(:, :, n - 1), matrix%upper(:, :, mate), beside)
      else
         call put_side_by_side(matrix%lower(:, :, n - 1), nothing, beside)
      end if
   end subroutine take_pair

   pure subroutine put_side_by_side(one, other, both)
      real(wp), intent(in) :: one(b**2), other(b**2)
      real(wp), intent(inout) :: both(pair, b**2)
      integer :: i
      do i = 1, b**2
         both(1, i) = one(i)
         both(2, i) = other(i)
      end do
   end subroutine put_side_by_side

   !> c <- c - a d.
   pure subroutine subtract_product(a, d, c)
      real(wp), intent(in) :: a(pair, b, b), d(pair, b, sides)
      real(wp), intent(inout) :: c(pair, b, sides)
      integer :: i, j
      do j = 1, sides
         do i = 1, b
            c(:, i, j) = c(:, i, j) - (a(:, i, 1)*d(:, 1, j) + a(:, i, 2)*d(:, 2, j) + a(:, i, 3)*d(:, 3, j))
         end do
      end do
   end subroutine subtract_product

   !> solved = pivot^-1 side, by cofactors; not regular where a determinant is zero or numbers are out of range.
   pure subroutine divide(pivot, side, solved, regular)
      real(wp), intent(in) :: pivot(pair, b, sides), side(pair, b, sides)
      real(wp), intent(out) :: solved(pair, b, sides)
      logical, intent(out) :: regular
      real(wp), dimension(pair) :: f11, f12, f13, f21, f22, f23, f31, f32, f33, determinant
      real(wp) :: y1, y2, y3
      integer :: l, j
      !GCC$ unroll 1
      do l = 1, pair
         f11(l) = pivot(l, 2, 2)*pivot(l, 3, 3) - pivot(l, 2, 3)*pivot(l, 3, 2)
         f21(l) = pivot(l, 2, 3)*pivot(l, 3, 1) - pivot(l, 2, 1)*pivot(l, 3, 3)
         f31(l) = pivot(l, 2, 1)*pivot(l, 3, 2) - pivot(l, 2, 2)*pivot(l, 3, 1)
         f12(l) = pivot(l, 1, 3)*pivot(l, 3, 2) - pivot(l, 1, 2)*pivot(l, 3, 3)
         f22(l) = pivot(l, 1, 1)*pivot(l, 3, 3) - pivot(l, 1, 3)*pivot(l, 3, 1)
         f32(l) = pivot(l, 1, 2)*pivot(l, 3, 1) - pivot(l, 1, 1)*pivot(l, 3, 2)
         f13(l) = pivot(l, 1, 2)*pivot(l, 2, 3) - pivot(l, 1, 3)*pivot(l, 2, 2)
         f23(l) = pivot(l, 1, 3)*pivot(l, 2, 1) - pivot(l, 1, 1)*pivot(l, 2, 3)
         f33(l) = pivot(l, 1, 1)*pivot(l, 2, 2) - pivot(l, 1, 2)*pivot(l, 2, 1)
         determinant(l) = pivot(l, 1, 1)*f11(l) + pivot(l, 1, 2)*f21(l) + pivot(l, 1, 3)*f31(l)
      end do
      regular = min(abs(determinant(1)), abs(determinant(2))) > 0.0_wp .and. abs(determinant(1)) <= huge(y1) .and. &
                abs(determinant(2)) <= huge(y1)
      if (.not. regular) return
      determinant = 1.0_wp/determinant
      do j = 1, sides
         !GCC$ unroll 1
         do l = 1, pair
            y1 = side(l, 1, j)*determinant(l)
            y2 = side(l, 2, j)*determinant(l)
            y3 = side(l, 3, j)*determinant(l)
            solved(l, 1, j) = f11(l)*y1 + f12(l)*y2 + f13(l)*y3
            solved(l, 2, j) = f21(l)*y1 + f22(l)*y2 + f23(l)*y3
            solved(l, 3, j) = f31(l)*y1 + f32(l)*y2 + f33(l)*y3
         end do
      end do
   end subroutine divide

   !> The solution at a pair of nodes from that at the next one.
   pure subroutine go_back(v, x)
      real(wp), intent(in) :: v(pair, b, sides)
      real(wp), intent(inout) :: x(pair, b)
      real(wp) :: y1, y2, y3
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         y1 = x(l, 1)
         y2 = x(l, 2)
         y3 = x(l, 3)
         x(l, 1) = v(l, 1, load) - (v(l, 1, 1)*y1 + v(l, 1, 2)*y2 + v(l, 1, 3)*y3)
         x(l, 2) = v(l, 2, load) - (v(l, 2, 1)*y1 + v(l, 2, 2)*y2 + v(l, 2, 3)*y3)
         x(l, 3) = v(l, 3, load) - (v(l, 3, 1)*y1 + v(l, 3, 2)*y2 + v(l, 3, 3)*y3)
      end do
   end subroutine go_back

   !> Largest entry of residual + matrix step.
   pure subroutine small_block_remainder(matrix, residual, step, largest)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in), contiguous :: residual(:, :), step(:, :)
      real(wp), intent(out) :: largest
      real(wp) :: r(b)
      integer :: n, before
      largest = 0.0_wp
      do n = 1, size(step, 2)
         r = residual(:, n) + product_of(matrix%diagonal(:, :, n), step(:, n))
         before = n - 1
         if (before >= 1) r = r + product_of(matrix%lower(:, :, before), step(:, before))
         if (n < size(step, 2)) r = r + product_of(matrix%upper(:, :, n), step(:, n + 1))
         largest = max(largest, largest_of(b, r))
      end do
   end subroutine small_block_remainder

   pure function product_of(a, x) result(y)
      real(wp), intent(in) :: a(b, b), x(b)
      real(wp) :: y(b)
      y = a(:, 1)*x(1) + a(:, 2)*x(2) + a(:, 3)*x(3)
   end function product_of
end module dg_small_block_solver
