!> Elimination of a chain of nodes with three unknowns each, block by block.
!>
!> The pass of dg_block_solver with blocks so small that each is inverted by its cofactors: no rows are exchanged, and the units of
!> rows and columns, forces beside moments, do not matter. As there the solution is checked against the matrix by who asks for it.
module dg_small_block_solver
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, b => plane_block_size
   implicit none
   private
   public :: small_block_solver_type, new_small_block_solver, small_block_factor, small_block_solve, small_block_back
   public :: small_block_remainder

   type :: small_block_solver_type
      real(wp), allocatable :: inverse(:, :, :)  !< of the pivot blocks (3,3,nodes)
   end type small_block_solver_type

contains

   !> Room for a chain of so many nodes; the solver may be used again for any number of matrices.
   pure subroutine new_small_block_solver(nodes, solver)
      integer, intent(in) :: nodes
      type(small_block_solver_type), intent(out) :: solver
      allocate (solver%inverse(b, b, nodes), source=0.0_wp)
   end subroutine new_small_block_solver

   !> Factors the matrix and eliminates the right-hand side x(3,nodes) forward; small_block_back makes it the solution.
   !> info = 0: done; > 0: the node at which a block is singular.
   pure subroutine small_block_factor(solver, matrix, info, x)
      type(small_block_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(out) :: info
      real(wp), intent(inout) :: x(:, :)
      real(wp) :: pivot(b, b), inverse(b, b), coupling(b, b), solved(b)
      integer :: n, j, above
      logical :: regular
      info = 0
      coupling = 0.0_wp
      solved = 0.0_wp
      do n = 1, size(matrix%diagonal, 3)
         pivot = matrix%diagonal(:, :, n)
         if (n > 1) then
            above = n - 1
            do j = 1, b
               pivot(:, j) = pivot(:, j) - product_of(matrix%lower(:, :, above), coupling(:, j))
            end do
            x(:, n) = x(:, n) - product_of(matrix%lower(:, :, above), solved)
         end if
         call invert(pivot, inverse, regular)
         if (.not. regular) then
            info = n
            return
         end if
         solver%inverse(:, :, n) = inverse
         if (n == size(matrix%diagonal, 3)) exit
         do j = 1, b
            coupling(:, j) = product_of(inverse, matrix%upper(:, j, n))
         end do
         solved = product_of(inverse, x(:, n))
      end do
   end subroutine small_block_factor

   !> Solves with the factors of small_block_factor; x(3,nodes) is the right-hand side before, the solution after.
   pure subroutine small_block_solve(solver, matrix, x)
      type(small_block_solver_type), intent(in) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      integer :: n, above
      do n = 2, size(x, 2)
         above = n - 1
         x(:, n) = x(:, n) - product_of(matrix%lower(:, :, above), product_of(solver%inverse(:, :, above), x(:, above)))
      end do
      call small_block_back(solver, matrix, x)
   end subroutine small_block_solve

   !> Back substitution of a right-hand side that has been eliminated forward.
   pure subroutine small_block_back(solver, matrix, x)
      type(small_block_solver_type), intent(in) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      integer :: n
      do n = size(x, 2), 1, -1
         if (n < size(x, 2)) x(:, n) = x(:, n) - product_of(matrix%upper(:, :, n), x(:, n + 1))
         x(:, n) = product_of(solver%inverse(:, :, n), x(:, n))
      end do
   end subroutine small_block_back

   !> Largest entry of residual + matrix step.
   pure subroutine small_block_remainder(matrix, residual, step, largest)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: residual(:, :), step(:, :)
      real(wp), intent(out) :: largest
      real(wp) :: r(b)
      integer :: n, before
      largest = 0.0_wp
      do n = 1, size(step, 2)
         r = residual(:, n) + product_of(matrix%diagonal(:, :, n), step(:, n))
         before = n - 1
         if (before >= 1) r = r + product_of(matrix%lower(:, :, before), step(:, before))
         if (n < size(step, 2)) r = r + product_of(matrix%upper(:, :, n), step(:, n + 1))
         largest = max(largest, abs(r(1)), abs(r(2)), abs(r(3)))
      end do
   end subroutine small_block_remainder

   pure function product_of(a, x) result(y)
      real(wp), intent(in) :: a(b, b), x(b)
      real(wp) :: y(b)
      y = a(:, 1)*x(1) + a(:, 2)*x(2) + a(:, 3)*x(3)
   end function product_of

   !> Inverse by cofactors; not regular where the determinant is zero or numbers are out of range.
   pure subroutine invert(a, inverse, regular)
      real(wp), intent(in) :: a(b, b)
      real(wp), intent(out) :: inverse(b, b)
      logical, intent(out) :: regular
      real(wp) :: determinant
      inverse(1, 1) = a(2, 2)*a(3, 3) - a(2, 3)*a(3, 2)
      inverse(2, 1) = a(2, 3)*a(3, 1) - a(2, 1)*a(3, 3)
      inverse(3, 1) = a(2, 1)*a(3, 2) - a(2, 2)*a(3, 1)
      inverse(1, 2) = a(1, 3)*a(3, 2) - a(1, 2)*a(3, 3)
      inverse(2, 2) = a(1, 1)*a(3, 3) - a(1, 3)*a(3, 1)
      inverse(3, 2) = a(1, 2)*a(3, 1) - a(1, 1)*a(3, 2)
      inverse(1, 3) = a(1, 2)*a(2, 3) - a(1, 3)*a(2, 2)
      inverse(2, 3) = a(1, 3)*a(2, 1) - a(1, 1)*a(2, 3)
      inverse(3, 3) = a(1, 1)*a(2, 2) - a(1, 2)*a(2, 1)
      determinant = a(1, 1)*inverse(1, 1) + a(1, 2)*inverse(2, 1) + a(1, 3)*inverse(3, 1)
      regular = abs(determinant) > 0.0_wp .and. abs(determinant) <= huge(determinant)
      if (regular) inverse = inverse*(1.0_wp/determinant)
   end subroutine invert
end module dg_small_block_solver
