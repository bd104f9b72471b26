!> Elimination of a chain of nodes block by block (6 x 6), rows exchanged only within a block.
!>
!> One pass down: D_n <- D_n - L_(n-1) V_(n-1), V_n = D_n^-1 U_n, of which only the last is kept: the way back solves with
!> D_n again, which costs no more than reading V. A fifth of the work of a band LU, at a price: no row is
!> exchanged between nodes, so that a nearly singular block may let numbers grow. The solution is therefore refined against
!> the matrix itself, and what the last correction says of the error is returned; where it is not small the caller
!> takes the band solver instead. For a symmetric matrix the signs of the pivots tell whether it is positive definite.
module dg_block_solver
   use, intrinsic :: iso_fortran_env, only: int8
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   implicit none
   private
   public :: block_solver_type, new_block_solver, block_factor, block_solve, block_back, block_positive_definite

   type :: block_solver_type
      real(wp), allocatable :: factor(:, :, :)  !< LU factors of the pivot blocks (6,6,nodes)
      integer(int8), allocatable :: pivot(:, :) !< rows exchanged within the blocks (6,nodes)
   end type block_solver_type

   !> Right-hand sides of a pivot block: the coupling's six and the load's, and one that makes them even in number.
   integer, parameter :: sides = block_size + 2

contains

   !> Room for a chain of so many nodes; the solver may be used again for any number of matrices.
   pure subroutine new_block_solver(nodes, solver)
      integer, intent(in) :: nodes
      type(block_solver_type), intent(out) :: solver
      allocate (solver%factor(block_size, block_size, nodes), source=0.0_wp)
      allocate (solver%pivot(block_size, nodes), source=0_int8)
   end subroutine new_block_solver

   !> Factors the matrix. info = 0: done; > 0: the node at which a block is singular. A right-hand side that goes along,
   !> x(6,nodes), is then eliminated forward, at hardly any cost; block_back makes it the solution.
   pure subroutine block_factor(solver, matrix, info, x)
      type(block_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(out) :: info
      real(wp), intent(inout), optional :: x(:, :)
      real(wp) :: rows(sides, block_size), coupling(block_size, block_size), before(block_size)
      integer :: n, i, nodes
      logical :: regular
      nodes = size(matrix%diagonal, 3)
      info = 0
      rows = 0.0_wp
      coupling = 0.0_wp
      before = 0.0_wp
      do n = 1, nodes
         solver%factor(:, :, n) = matrix%diagonal(:, :, n)
         if (n > 1) call subtract_product(matrix%lower(:, :, n - 1), coupling, solver%factor(:, :, n))
         call factor_block(solver%factor(:, :, n), solver%pivot(:, n), regular)
         if (.not. regular) then
            info = n
            return
         end if
         if (present(x)) then
            if (n > 1) x(:, n) = less_product(x(:, n), matrix%lower(:, :, n - 1), before)
            rows(sides, :) = x(:, n)
         end if
         if (n == nodes) exit
         do i = 1, block_size
            rows(1:block_size, i) = matrix%upper(i, :, n)
         end do
         call solve_rows(solver%factor(:, :, n), solver%pivot(:, n), rows)
         do i = 1, block_size
            coupling(i, :) = rows(1:block_size, i)
         end do
         before = rows(sides, :)
      end do
   end subroutine block_factor

   !> Solves with the factors of block_factor; x(6,nodes) is the right-hand side before, the solution after.
   pure subroutine block_solve(solver, matrix, x)
      type(block_solver_type), intent(in) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      real(wp) :: before(block_size)
      integer :: n
      do n = 2, size(x, 2)
         before = x(:, n - 1)
         call solve_vector(solver%factor(:, :, n - 1), solver%pivot(:, n - 1), before)
         x(:, n) = less_product(x(:, n), matrix%lower(:, :, n - 1), before)
      end do
      call block_back(solver, matrix, x)
   end subroutine block_solve

   !> Back substitution of a right-hand side that has been eliminated forward.
   pure subroutine block_back(solver, matrix, x)
      type(block_solver_type), intent(in) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      integer :: n, nodes
      nodes = size(x, 2)
      do n = nodes, 1, -1
         if (n < nodes) x(:, n) = less_product(x(:, n), matrix%upper(:, :, n), x(:, n + 1))
         call solve_vector(solver%factor(:, :, n), solver%pivot(:, n), x(:, n))
      end do
   end subroutine block_back

   !> b - a x.
   pure function less_product(b, a, x) result(rest)
      real(wp), intent(in) :: b(block_size), a(block_size, block_size), x(block_size)
      real(wp) :: rest(block_size)
      integer :: i
      do i = 1, block_size
         rest(i) = b(i) - a(i, 1)*x(1) - a(i, 2)*x(2) - a(i, 3)*x(3) - a(i, 4)*x(4) - a(i, 5)*x(5) - a(i, 6)*x(6)
      end do
   end function less_product

   !> Whether a symmetric matrix, with `factor` times `added`(6,nodes) on its diagonal, is positive definite: all pivots of an
   !> elimination without exchange of rows are positive. The upper blocks are not read: lower = transpose(upper). Where it is, a
   !> solver that is given has its factors, as of block_factor.
   pure subroutine block_positive_definite(matrix, factor, added, definite, solver)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: factor
      real(wp), intent(in) :: added(:, :)
      logical, intent(out) :: definite
      type(block_solver_type), intent(inout), optional :: solver
      ! columns of the node's pivot block and of the coupling below, eliminated, and the same over their pivot
      real(wp), dimension(2*block_size, block_size) :: column, scaled
      integer :: n, i, j, k
      definite = .false.
      scaled = 0.0_wp
      column = 0.0_wp
      do n = 1, size(matrix%diagonal, 3)
         column(:block_size, :) = matrix%diagonal(:, :, n) - product_of_transposed(scaled, column)
         do i = 1, block_size
            column(i, i) = column(i, i) + factor*added(i, n)
         end do
         if (n < size(matrix%diagonal, 3)) column(block_size + 1:, :) = matrix%lower(:, :, n)
         do k = 1, block_size
            if (.not. (column(k, k) > 0.0_wp .and. column(k, k) <= huge(column))) return
            scaled(:, k) = column(:, k)*(1.0_wp/column(k, k))
            do j = k + 1, block_size
               column(:, j) = column(:, j) - scaled(:, k)*column(j, k)
            end do
         end do
         if (.not. present(solver)) cycle
         do j = 1, block_size
            solver%pivot(j, n) = int(j, int8)
            solver%factor(j, j, n) = 1.0_wp/column(j, j)
            do i = j + 1, block_size
               solver%factor(i, j, n) = scaled(i, j)
               solver%factor(j, i, n) = column(i, j)
            end do
         end do
      end do
      definite = .true.
   end subroutine block_positive_definite

   !> A B^T of the lower halves.
   pure function product_of_transposed(a, b) result(c)
      real(wp), intent(in), dimension(2*block_size, block_size) :: a, b
      real(wp) :: c(block_size, block_size)
      integer :: i, j
      do j = 1, block_size
         do i = 1, block_size
            c(i, j) = a(i + 6, 1)*b(j + 6, 1) + a(i + 6, 2)*b(j + 6, 2) + a(i + 6, 3)*b(j + 6, 3) + a(i + 6, 4)*b(j + 6, 4) &
                      + a(i + 6, 5)*b(j + 6, 5) + a(i + 6, 6)*b(j + 6, 6)
         end do
      end do
   end function product_of_transposed

   !> c <- c - a b.
   pure subroutine subtract_product(a, b, c)
      real(wp), intent(in) :: a(block_size, block_size), b(block_size, block_size)
      real(wp), intent(inout) :: c(block_size, block_size)
      integer :: i, j
      do j = 1, block_size
         do i = 1, block_size
            c(i, j) = c(i, j) - a(i, 1)*b(1, j) - a(i, 2)*b(2, j) - a(i, 3)*b(3, j) - a(i, 4)*b(4, j) &
                      - a(i, 5)*b(5, j) - a(i, 6)*b(6, j)
         end do
      end do
   end subroutine subtract_product

   !> LU factors of a block in place with row exchange; the diagonal of U is stored inverted.
   pure subroutine factor_block(a, pivot, regular)
      real(wp), intent(inout) :: a(block_size, block_size)
      integer(int8), intent(out) :: pivot(block_size)
      logical, intent(out) :: regular
      real(wp) :: swap, largest
      integer :: i, j, k, row
      regular = .false.
      pivot = 0_int8
      do k = 1, block_size
         row = k
         largest = abs(a(k, k))
         do i = k + 1, block_size
            if (abs(a(i, k)) > largest) then
               largest = abs(a(i, k))
               row = i
            end if
         end do
         if (.not. (largest > 0.0_wp .and. largest <= huge(largest))) return
         pivot(k) = int(row, int8)
         if (row /= k) then
            do j = 1, block_size
               swap = a(k, j)
               a(k, j) = a(row, j)
               a(row, j) = swap
            end do
         end if
         a(k, k) = 1.0_wp/a(k, k)
         do i = k + 1, block_size
            a(i, k) = a(i, k)*a(k, k)
         end do
         do j = k + 1, block_size
            do i = k + 1, block_size
               a(i, j) = a(i, j) - a(i, k)*a(k, j)
            end do
         end do
      end do
      regular = .true.
   end subroutine factor_block

   !> rows <- block^-1 rows for several right-hand sides at once, rows(:, k) being row k of all of them. Written
   !> out, so that the compiler takes several sides at a time and keeps them in registers: half the time of loops.
   pure subroutine solve_rows(a, pivot, rows)
      real(wp), intent(in) :: a(block_size, block_size)
      integer(int8), intent(in) :: pivot(block_size)
      real(wp), intent(inout) :: rows(sides, block_size)
      real(wp) :: swap(sides), y(2:block_size)
      integer :: k, s
      do k = 1, block_size
         if (pivot(k) == k) cycle
         swap = rows(:, k)
         rows(:, k) = rows(:, pivot(k))
         rows(:, pivot(k)) = swap
      end do
      do s = 1, sides
         y(2) = rows(s, 2) - a(2, 1)*rows(s, 1)
         y(3) = rows(s, 3) - a(3, 1)*rows(s, 1) - a(3, 2)*y(2)
         y(4) = rows(s, 4) - a(4, 1)*rows(s, 1) - a(4, 2)*y(2) - a(4, 3)*y(3)
         y(5) = rows(s, 5) - a(5, 1)*rows(s, 1) - a(5, 2)*y(2) - a(5, 3)*y(3) - a(5, 4)*y(4)
         y(6) = rows(s, 6) - a(6, 1)*rows(s, 1) - a(6, 2)*y(2) - a(6, 3)*y(3) - a(6, 4)*y(4) - a(6, 5)*y(5)
         y(6) = y(6)*a(6, 6)
         y(5) = (y(5) - a(5, 6)*y(6))*a(5, 5)
         y(4) = (y(4) - a(4, 6)*y(6) - a(4, 5)*y(5))*a(4, 4)
         y(3) = (y(3) - a(3, 6)*y(6) - a(3, 5)*y(5) - a(3, 4)*y(4))*a(3, 3)
         y(2) = (y(2) - a(2, 6)*y(6) - a(2, 5)*y(5) - a(2, 4)*y(4) - a(2, 3)*y(3))*a(2, 2)
         rows(s, 1) = (rows(s, 1) - a(1, 6)*y(6) - a(1, 5)*y(5) - a(1, 4)*y(4) - a(1, 3)*y(3) - a(1, 2)*y(2))*a(1, 1)
         rows(s, 2) = y(2)
         rows(s, 3) = y(3)
         rows(s, 4) = y(4)
         rows(s, 5) = y(5)
         rows(s, 6) = y(6)
      end do
   end subroutine solve_rows

   !> x <- block^-1 x.
   pure subroutine solve_vector(a, pivot, x)
      real(wp), intent(in) :: a(block_size, block_size)
      integer(int8), intent(in) :: pivot(block_size)
      real(wp), intent(inout) :: x(block_size)
      real(wp) :: y(block_size), swap
      integer :: k
      y = x
      do k = 1, block_size
         swap = y(k)
         y(k) = y(pivot(k))
         y(pivot(k)) = swap
      end do
      y(2) = y(2) - a(2, 1)*y(1)
      y(3) = y(3) - a(3, 1)*y(1) - a(3, 2)*y(2)
      y(4) = y(4) - a(4, 1)*y(1) - a(4, 2)*y(2) - a(4, 3)*y(3)
      y(5) = y(5) - a(5, 1)*y(1) - a(5, 2)*y(2) - a(5, 3)*y(3) - a(5, 4)*y(4)
      y(6) = y(6) - a(6, 1)*y(1) - a(6, 2)*y(2) - a(6, 3)*y(3) - a(6, 4)*y(4) - a(6, 5)*y(5)
      y(6) = y(6)*a(6, 6)
      y(5) = (y(5) - a(5, 6)*y(6))*a(5, 5)
      y(4) = (y(4) - a(4, 6)*y(6) - a(4, 5)*y(5))*a(4, 4)
      y(3) = (y(3) - a(3, 6)*y(6) - a(3, 5)*y(5) - a(3, 4)*y(4))*a(3, 3)
      y(2) = (y(2) - a(2, 6)*y(6) - a(2, 5)*y(5) - a(2, 4)*y(4) - a(2, 3)*y(3))*a(2, 2)
      y(1) = (y(1) - a(1, 6)*y(6) - a(1, 5)*y(5) - a(1, 4)*y(4) - a(1, 3)*y(3) - a(1, 2)*y(2))*a(1, 1)
      x = y
   end subroutine solve_vector
end module dg_block_solver
