!> The chain matrix and its solutions, banded and by blocks, against the same matrix written out in full.
module dg_test_block_matrix
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_block_matrix, only: block_matrix_type, block_product, block_size, new_block_matrix
   use dg_block_solver, only: block_solve, block_solver_type, new_block_solver
   use dg_kinds, only: wp
   use dg_sparse_matrix, only: set_sparse_matrix, sparse_matrix_type
   use dg_sparse_solver, only: sparse_condition, sparse_factor, sparse_release, sparse_solve, sparse_solver_type
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solve_linear, solver_banded, solver_block, solver_count, &
                               solver_sparse
   use dg_positive_definite, only: block_positive_definite
   implicit none
   private
   public :: block_matrix_suite

   integer, parameter :: nodes = 5, unknowns = block_size*nodes

contains

   function block_matrix_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('block_matrix')
      call suite%addTest(TestMethod('product', test_product))
      call suite%addTest(TestMethod('band_solution', test_band_solution))
      call suite%addTest(TestMethod('row_exchange', test_row_exchange))
      call suite%addTest(TestMethod('block_solution', test_block_solution))
      call suite%addTest(TestMethod('turned_round', test_turned_round))
      call suite%addTest(TestMethod('singular_block', test_singular_block))
      call suite%addTest(TestMethod('refined', test_refined))
      call suite%addTest(TestMethod('one_node', test_one_node))
      call suite%addTest(TestMethod('singular', test_singular))
      call suite%addTest(TestMethod('definiteness', test_definiteness))
      call suite%addTest(TestMethod('definiteness_of_any_chain', test_definiteness_of_any_chain))
      call suite%addTest(TestMethod('sparse_columns', test_sparse_columns))
      call suite%addTest(TestMethod('sparse_solution', test_sparse_solution))
      call suite%addTest(TestMethod('sparse_singular', test_sparse_singular))
      call suite%addTest(TestMethod('condition', test_condition))
   end function block_matrix_suite

   !> Any numbers, no symmetry.
   function any_matrix() result(matrix)
      type(block_matrix_type) :: matrix
      integer :: k
      matrix = new_block_matrix(nodes)
      matrix%diagonal = reshape([(sin(1.7_wp*k*k), k=1, 36*nodes)], [6, 6, nodes])
      matrix%upper = reshape([(cos(2.3_wp*k*k), k=1, 36*(nodes - 1))], [6, 6, nodes - 1])
      matrix%lower = reshape([(sin(0.9_wp*k*k + 1.0_wp), k=1, 36*(nodes - 1))], [6, 6, nodes - 1])
   end function any_matrix

   function full(matrix) result(dense)
      type(block_matrix_type), intent(in) :: matrix
      real(wp) :: dense(unknowns, unknowns)
      integer :: n, a
      dense = 0.0_wp
      do n = 1, nodes
         a = block_size*(n - 1)
         dense(a + 1:a + 6, a + 1:a + 6) = matrix%diagonal(:, :, n)
         if (n == nodes) exit
         dense(a + 1:a + 6, a + 7:a + 12) = matrix%upper(:, :, n)
         dense(a + 7:a + 12, a + 1:a + 6) = matrix%lower(:, :, n)
      end do
   end function full

   subroutine test_product()
      type(block_matrix_type) :: matrix
      real(wp) :: x(unknowns)
      integer :: k
      matrix = any_matrix()
      x = [(cos(1.0_wp*k), k=1, unknowns)]
      call assertEqual(matmul(full(matrix), x), reshape(block_product(matrix, reshape(x, [6, nodes])), [unknowns]), 1.0e-13_wp)
   end subroutine test_product

   subroutine check_solution(matrix)
      type(block_matrix_type), intent(in) :: matrix
      type(band_solver_type) :: solver
      real(wp) :: b(unknowns), x(6, nodes)
      integer :: k, info, twice
      solver = new_band_solver(nodes)
      do twice = 1, 2       ! nothing of a first matrix is left in a second one
         call band_factor(solver, matrix, info)
         call assertEqual(0, info)
         b = [(sin(3.0_wp*k), k=1, unknowns)]
         x = reshape(b, [6, nodes])
         call band_solve(solver, x)
         ! Backward stable: residual of round-off times |A||x|, about 1e2 here.
         call assertEqual(b, matmul(full(matrix), reshape(x, [unknowns])), 1.0e-12_wp)
      end do
   end subroutine check_solution

   subroutine test_band_solution()
      call check_solution(any_matrix())
   end subroutine test_band_solution

   !> Zero on the whole diagonal: only an exchange of rows gets through.
   subroutine test_row_exchange()
      type(block_matrix_type) :: matrix
      integer :: n, i
      matrix = any_matrix()
      do n = 1, nodes
         do i = 1, 6
            matrix%diagonal(i, i, n) = 0.0_wp
         end do
      end do
      call check_solution(matrix)
   end subroutine test_row_exchange

   !> Chains of one node to seven, an even number too, with zeros on the diagonal and without, against LAPACK's band LU: rows are
   !> exchanged in blocks of either half. A solver is used again.
   subroutine test_block_solution()
      type(block_matrix_type) :: matrix, whole
      type(block_solver_type) :: solver
      type(band_solver_type) :: band
      real(wp), allocatable :: b(:, :), x(:, :), expected(:, :)
      integer :: chain, pass, i, k, info
      do chain = 1, 7
         whole = new_block_matrix(chain)
         whole%diagonal = reshape([(sin(1.7_wp*k*k), k=1, 36*chain)], [6, 6, chain])
         whole%upper = reshape([(cos(2.3_wp*k*k), k=1, 36*(chain - 1))], [6, 6, chain - 1])
         whole%lower = reshape([(sin(0.9_wp*k*k + 1.0_wp), k=1, 36*(chain - 1))], [6, 6, chain - 1])
         b = reshape([(sin(3.0_wp*k), k=1, 6*chain)], [6, chain])
         call new_block_solver(chain, solver)
         band = new_band_solver(chain)
         do pass = 1, 2
            matrix = whole
            if (pass == 2) then
               do i = 1, 6
                  matrix%diagonal(i, i, :) = 0.0_wp
               end do
            end if
            expected = b
            call band_factor(band, matrix, info)
            call band_solve(band, expected)
            x = b
            call block_solve(solver, matrix, x, info)
            call assertEqual(0, info)
            ! no exchange between blocks: a few digits less than the band's; round-off grows with the solution
            call assertEqual(b, block_product(matrix, x), 1.0e-11_wp*max(1.0_wp, maxval(abs(x))))
            call assertEqual(expected, x, 1.0e-11_wp*max(1.0_wp, maxval(abs(expected))))
         end do
      end do
   end subroutine test_block_solution

   !> The nodes of a chain in the order from the other end: the same solution.
   subroutine test_turned_round()
      type(block_matrix_type) :: matrix, turned
      type(block_solver_type) :: solver
      real(wp) :: x(6, nodes), y(6, nodes)
      integer :: n, k, info
      matrix = any_matrix()
      turned = matrix
      do n = 1, nodes
         turned%diagonal(:, :, n) = matrix%diagonal(:, :, nodes + 1 - n)
         if (n == nodes) exit
         turned%upper(:, :, n) = matrix%lower(:, :, nodes - n)
         turned%lower(:, :, n) = matrix%upper(:, :, nodes - n)
      end do
      call new_block_solver(nodes, solver)
      x = reshape([(sin(3.0_wp*k), k=1, unknowns)], [6, nodes])
      y = x(:, nodes:1:-1)
      call block_solve(solver, matrix, x, info)
      call block_solve(solver, turned, y, info)
      call assertEqual(x, y(:, nodes:1:-1), 1.0e-13_wp*maxval(abs(x)))
   end subroutine test_turned_round

   !> A first block that is singular by itself in a matrix that is not: elimination by blocks names it, the checked
   !> solution takes the band solver.
   subroutine test_singular_block()
      type(block_matrix_type) :: matrix
      type(block_solver_type) :: solver
      type(linear_solver_type) :: linear
      real(wp) :: b(unknowns), x(6, nodes)
      integer :: k, info
      matrix = any_matrix()
      matrix%diagonal(:, 2, 1) = 0.0_wp
      b = [(sin(3.0_wp*k), k=1, unknowns)]
      call new_block_solver(nodes, solver)
      x = reshape(b, [6, nodes])
      call block_solve(solver, matrix, x, info)
      call assertEqual(1, info)
      call new_linear_solver(solver_block, nodes, linear)
      call solve_linear(linear, matrix, -reshape(b, [6, nodes]), x, info)
      call assertEqual(0, info)
      call assertEqual(1, linear%fallbacks)
      call assertEqual(b, matmul(full(matrix), reshape(x, [unknowns])), 1.0e-12_wp)
   end subroutine test_singular_block

   !> A first block singular but for 1e-13: numbers grow, and the answer is good all the same; all kinds agree.
   subroutine test_refined()
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp) :: b(unknowns), x(6, nodes, solver_count)
      integer :: k, kind, info
      matrix = any_matrix()
      matrix%diagonal(:, 2, 1) = matrix%diagonal(:, 1, 1)*(1.0_wp + 1.0e-13_wp)
      matrix%diagonal(3, 2, 1) = matrix%diagonal(3, 2, 1) + 1.0e-13_wp
      b = [(sin(3.0_wp*k), k=1, unknowns)]
      do kind = 1, solver_count
         call new_linear_solver(kind, nodes, linear)
         call solve_linear(linear, matrix, -reshape(b, [6, nodes]), x(:, :, kind), info)
         call assertEqual(0, info)
         call assertEqual(b, matmul(full(matrix), reshape(x(:, :, kind), [unknowns])), 1.0e-7_wp)
         if (kind == solver_block) call assertGreaterThan(linear%refinements, 0, message='refined')
      end do
      call assertEqual(x(:, :, solver_banded), x(:, :, solver_block), 1.0e-7_wp)
      call assertEqual(x(:, :, solver_banded), x(:, :, solver_sparse), 1.0e-7_wp)
   end subroutine test_refined

   !> The matrix by columns, zeros left out, is the matrix written out, and so is its upper part.
   subroutine test_sparse_columns()
      type(block_matrix_type) :: matrix
      type(sparse_matrix_type) :: sparse
      real(wp) :: dense(unknowns, unknowns), whole(unknowns, unknowns)
      integer :: pass, j, k
      matrix = any_matrix()
      matrix%upper(2, :, 3) = 0.0_wp
      whole = full(matrix)
      do pass = 1, 2             ! whole; upper part
         call set_sparse_matrix(matrix, sparse, upper=pass == 2)
         dense = 0.0_wp
         do j = 1, unknowns
            do k = sparse%columns(j) + 1, sparse%columns(j + 1)
               dense(sparse%rows(k) + 1, j) = sparse%values(k)
            end do
            if (pass == 2) whole(j + 1:, j) = 0.0_wp
         end do
         if (pass == 1) call assertEqual(36*(3*nodes - 2) - 6, sparse%entries, message='six zeros left out')
         call assertEqual(whole, dense, message='the same numbers')
      end do
   end subroutine test_sparse_columns

   !> With and without zeros on the whole diagonal, where only an exchange of rows gets through.
   subroutine test_sparse_solution()
      type(block_matrix_type) :: matrix
      type(sparse_solver_type) :: solver
      real(wp) :: b(unknowns), x(6, nodes)
      integer :: k, info, pass, n, i
      matrix = any_matrix()
      b = [(sin(3.0_wp*k), k=1, unknowns)]
      do pass = 1, 2
         call sparse_factor(solver, matrix, info)
         call assertEqual(0, info)
         x = reshape(b, [6, nodes])
         call sparse_solve(solver, x)
         ! pivots need not be the largest: a few digits less than the band's
         call assertEqual(b, matmul(full(matrix), reshape(x, [unknowns])), 1.0e-11_wp)
         call assertGreaterThan(solver%fill, 36*(3*nodes - 2), message='entries of the factors')
         do n = 1, nodes
            do i = 1, 6
               matrix%diagonal(i, i, n) = 0.0_wp
            end do
         end do
      end do
      call sparse_release(solver)
      call sparse_release(solver)       ! nothing is given back twice
   end subroutine test_sparse_solution

   !> An unknown without any entry: refused, and by the one interface too, which asks the band solver.
   subroutine test_sparse_singular()
      type(block_matrix_type) :: matrix
      type(sparse_solver_type) :: solver
      type(linear_solver_type) :: linear
      real(wp) :: x(6, nodes), ones(6, nodes), condition
      integer :: info
      matrix = new_block_matrix(nodes)
      matrix%diagonal = any_diagonal()
      matrix%diagonal(:, 2, 3) = 0.0_wp
      call sparse_factor(solver, matrix, info)
      call assertGreaterThan(info, 0, message='info')
      call sparse_condition(solver, condition)
      call assertEqual(0.0_wp, condition, message='no factors, no condition')
      call new_linear_solver(solver_sparse, nodes, linear)
      ones = 1.0_wp
      call solve_linear(linear, matrix, ones, x, info)
      call assertEqual(6*2 + 2, info)
   end subroutine test_sparse_singular

   !> Condition of a diagonal matrix with entries from 1 + 1 + 1 to 1 + 6 + nodes: the largest over the smallest.
   subroutine test_condition()
      type(block_matrix_type) :: matrix
      type(sparse_solver_type) :: solver
      real(wp) :: condition
      integer :: info
      matrix = new_block_matrix(nodes)
      matrix%diagonal = any_diagonal()
      call sparse_factor(solver, matrix, info)
      call assertEqual(0, info)
      call sparse_condition(solver, condition)
      call sparse_release(solver)
      call assertEqual((1.0_wp + 6.0_wp + nodes)/3.0_wp, condition, 1.0e-12_wp)
   end subroutine test_condition

   subroutine test_one_node()
      type(block_matrix_type) :: matrix
      type(band_solver_type) :: solver
      real(wp) :: x(6, 1)
      integer :: i, info
      matrix = new_block_matrix(1)
      do i = 1, 6
         matrix%diagonal(i, i, 1) = 2.0_wp*i
      end do
      solver = new_band_solver(1)
      call band_factor(solver, matrix, info)
      x(:, 1) = [(4.0_wp*i, i=1, 6)]
      call band_solve(solver, x)
      call assertEqual(2.0_wp, x(:, 1), 1.0e-15_wp)
   end subroutine test_one_node

   !> An unknown without any row is named.
   subroutine test_singular()
      type(block_matrix_type) :: matrix
      type(band_solver_type) :: solver
      integer :: info
      matrix = new_block_matrix(nodes)
      matrix%diagonal = any_diagonal()
      matrix%diagonal(:, 2, 3) = 0.0_wp
      solver = new_band_solver(nodes)
      call band_factor(solver, matrix, info)
      call assertEqual(6*2 + 2, info)
   end subroutine test_singular

   pure function any_diagonal() result(diagonal)
      real(wp) :: diagonal(6, 6, nodes)
      integer :: n, i
      diagonal = 0.0_wp
      do n = 1, nodes
         do i = 1, 6
            diagonal(i, i, n) = 1.0_wp + i + n
         end do
      end do
   end function any_diagonal

   !> A chain of springs, stiffness 1 each and held at one end by 1: the smallest eigenvalue of the 1-d chain of N unknowns
   !> free at the other end is 2 - 2 cos(pi/(2 N + 1)). Taking more than that off the diagonal must be seen.
   subroutine test_definiteness()
      type(block_matrix_type) :: matrix
      real(wp) :: ones(6, nodes), least
      real(wp), parameter :: pi = 3.14159265358979324_wp
      integer :: n, i
      matrix = new_block_matrix(nodes)
      do n = 1, nodes
         do i = 1, 6
            matrix%diagonal(i, i, n) = merge(1.0_wp, 2.0_wp, n == nodes)
            if (n < nodes) matrix%upper(i, i, n) = -1.0_wp
            if (n < nodes) matrix%lower(i, i, n) = -1.0_wp
         end do
      end do
      ones = 1.0_wp
      least = 2.0_wp - 2.0_wp*cos(pi/(2*nodes + 1))
      call assertTrue(definite(0.0_wp), message='as it is')
      call assertTrue(definite(-0.999_wp*least), message='just above')
      call assertFalse(definite(-1.001_wp*least), message='just below')
      matrix%diagonal(3, 3, 2) = matrix%diagonal(3, 3, 2) - 10.0_wp
      call assertFalse(definite(0.0_wp), message='one soft unknown')
      call assertTrue(definite(20.0_wp), message='stiffened')
   contains
      function definite(factor)
         real(wp), intent(in) :: factor
         logical :: definite
         call block_positive_definite(matrix, factor, ones, definite)
      end function definite
   end subroutine test_definiteness

   !> Chains of one to six nodes, any symmetric matrix on ever stiffer ground, with rows of elements and without: as by the matrix
   !> written out in full.
   subroutine test_definiteness_of_any_chain()
      type(block_matrix_type) :: matrix
      integer, parameter :: longest = 6, grounds = 40
      real(wp) :: ones(6, longest), rows(12, longest), stiffness(longest), dense(6*longest, 6*longest)
      integer :: chain, ground, ties, e, i, k, positive(0:1)
      logical :: definite
      ones = 1.0_wp
      positive = 0
      do chain = 1, longest
         matrix = new_block_matrix(chain)
         matrix%diagonal = reshape([(sin(1.7_wp*k*k), k=1, 36*chain)], [6, 6, chain])
         do i = 1, chain
            matrix%diagonal(:, :, i) = matrix%diagonal(:, :, i) + transpose(matrix%diagonal(:, :, i))
         end do
         matrix%lower = reshape([(cos(2.3_wp*k*k), k=1, 36*(chain - 1))], [6, 6, chain - 1])
         matrix%upper = huge(1.0_wp)         ! is not read
         rows = reshape([(sin(0.9_wp*k*k + chain), k=1, 12*longest)], [12, longest])
         stiffness = [(merge(0.0_wp, 0.7_wp*e, modulo(e + chain, 3) == 0), e=1, longest)]
         do ground = 1, grounds
            do ties = 0, 1
               dense = 0.0_wp
               do i = 1, chain
                  k = 6*(i - 1)
                  dense(k + 1:k + 6, k + 1:k + 6) = matrix%diagonal(:, :, i)
                  if (i < chain) dense(k + 7:k + 12, k + 1:k + 6) = matrix%lower(:, :, i)
                  if (i < chain) dense(k + 1:k + 6, k + 7:k + 12) = transpose(matrix%lower(:, :, i))
               end do
               do i = 1, 6*chain
                  dense(i, i) = dense(i, i) + 0.3_wp*ground
               end do
               if (ties == 0) then
                  call block_positive_definite(matrix, 0.3_wp*ground, ones(:, :chain), definite)
               else
                  do e = 1, chain - 1
                     k = 6*(e - 1)
                     dense(k + 1:k + 12, k + 1:k + 12) = dense(k + 1:k + 12, k + 1:k + 12) &
                                                         + stiffness(e)*spread(rows(:, e), 2, 12)*spread(rows(:, e), 1, 12)
                  end do
                  call block_positive_definite(matrix, 0.3_wp*ground, ones(:, :chain), definite, stiffness(:chain - 1), &
                                               rows(:, :chain - 1))
               end if
               call assertTrue(definite .eqv. all_pivots_positive(dense(:6*chain, :6*chain)), message='definite')
               if (definite) positive(ties) = positive(ties) + 1
            end do
         end do
      end do
      call assertGreaterThan(positive(0), longest*grounds/4, message='many are')
      call assertGreaterThan(longest*grounds*3/4, positive(1), message='many are not')
      call assertGreaterThan(positive(1), positive(0), message='rows stiffen')

   contains

      pure function all_pivots_positive(full) result(all_are)
         real(wp), intent(in) :: full(:, :)
         logical :: all_are
         real(wp) :: a(size(full, 1), size(full, 1))
         integer :: p, j
         a = full
         all_are = .false.
         do p = 1, size(a, 1)
            if (.not. a(p, p) > 0.0_wp) return
            do j = p + 1, size(a, 1)
               a(p + 1:, j) = a(p + 1:, j) - a(p + 1:, p)*(a(p, j)/a(p, p))
            end do
         end do
         all_are = .true.
      end function all_pivots_positive
   end subroutine test_definiteness_of_any_chain
end module dg_test_block_matrix
