!> Chains of nodes with three unknowns, which every linear solver takes, against the same matrix written out in full.
module dg_test_plane_equations
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use dg_block_matrix, only: block_matrix_type, block_product, b => plane_block_size, new_block_matrix
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solve_linear, solver_banded, solver_block, solver_count, &
                               solver_name, solver_sparse
   use dg_small_block_solver, only: new_small_block_solver, small_block_remainder, small_block_solve, small_block_solver_type
   implicit none
   private
   public :: plane_equations_suite

   integer, parameter :: nodes = 7, unknowns = b*nodes

contains

   function plane_equations_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('plane_equations')
      call suite%addTest(TestMethod('all_solvers', test_all_solvers))
      call suite%addTest(TestMethod('lengths', test_lengths))
      call suite%addTest(TestMethod('again', test_again))
      call suite%addTest(TestMethod('units', test_units))
      call suite%addTest(TestMethod('singular_block', test_singular_block))
      call suite%addTest(TestMethod('refined', test_refined))
      call suite%addTest(TestMethod('negative_pivots', test_negative_pivots))
   end function plane_equations_suite

   !> Any numbers, no symmetry.
   function any_matrix() result(matrix)
      type(block_matrix_type) :: matrix
      integer :: k
      matrix = new_block_matrix(nodes, b)
      matrix%diagonal = reshape([(sin(1.7_wp*k*k), k=1, b*b*nodes)], [b, b, nodes])
      matrix%upper = reshape([(cos(2.3_wp*k*k), k=1, b*b*(nodes - 1))], [b, b, nodes - 1])
      matrix%lower = reshape([(sin(0.9_wp*k*k + 1.0_wp), k=1, b*b*(nodes - 1))], [b, b, nodes - 1])
   end function any_matrix

   function full(matrix) result(dense)
      type(block_matrix_type), intent(in) :: matrix
      real(wp) :: dense(unknowns, unknowns)
      integer :: n, a
      dense = 0.0_wp
      do n = 1, nodes
         a = b*(n - 1)
         dense(a + 1:a + b, a + 1:a + b) = matrix%diagonal(:, :, n)
         if (n == nodes) exit
         dense(a + 1:a + b, a + b + 1:a + 2*b) = matrix%upper(:, :, n)
         dense(a + b + 1:a + 2*b, a + 1:a + b) = matrix%lower(:, :, n)
      end do
   end function full

   function load() result(rhs)
      real(wp) :: rhs(b, nodes)
      integer :: k
      rhs = reshape([(sin(3.0_wp*k), k=1, unknowns)], [b, nodes])
   end function load

   subroutine test_all_solvers()
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp) :: x(b, nodes), product(unknowns)
      integer :: kind, info
      matrix = any_matrix()
      do kind = 1, solver_count
         call new_linear_solver(kind, nodes, linear, b)
         call solve_linear(linear, matrix, -load(), x, info)
         call assertEqual(0, info, message=trim(solver_name(kind)))
         product = matmul(full(matrix), reshape(x, [unknowns]))
         call assertEqual(reshape(load(), [unknowns]), product, 1.0e-10_wp, message=trim(solver_name(kind)))
         call assertEqual(product, reshape(block_product(matrix, x), [unknowns]), 1.0e-12_wp, message='product')
         call assertEqual(0, linear%fallbacks, message='not by another solver')
      end do
   end subroutine test_all_solvers

   !> Chains of one node and more, odd and even: the middle node has two neighbours, one or none. LAPACK's band solver agrees.
   subroutine test_lengths()
      type(block_matrix_type) :: whole, matrix
      type(linear_solver_type) :: by_blocks, banded
      real(wp) :: rhs(b, nodes), x(b, nodes), y(b, nodes)
      integer :: n, info
      whole = any_matrix()
      rhs = load()
      do n = 1, nodes
         matrix = block_matrix_type(whole%diagonal(:, :, :n), whole%upper(:, :, :n - 1), whole%lower(:, :, :n - 1))
         call new_linear_solver(solver_block, n, by_blocks, b)
         call solve_linear(by_blocks, matrix, rhs(:, :n), x(:, :n), info)
         call assertEqual(0, info)
         call assertEqual(0, by_blocks%fallbacks, message='not by another solver')
         call new_linear_solver(solver_banded, n, banded, b)
         call solve_linear(banded, matrix, rhs(:, :n), y(:, :n), info)
         call assertEqual(0.0_wp, maxval(abs(x(:, :n) - y(:, :n))), tolerance=1.0e-9_wp*maxval(abs(y(:, :n))))
      end do
   end subroutine test_lengths

   !> A solver's room serves for another right-hand side; the remainder is that of the matrix written out.
   subroutine test_again()
      type(block_matrix_type) :: matrix
      type(small_block_solver_type) :: solver
      real(wp) :: x(b, nodes), first(b, nodes), largest
      integer :: info
      matrix = any_matrix()
      call new_small_block_solver(nodes, solver)
      first = load()
      call small_block_solve(solver, matrix, first, info)
      call assertEqual(0, info)
      x = 2.0_wp*load()
      call small_block_solve(solver, matrix, x, info)
      call assertEqual(0, info)
      call assertEqual(reshape(2.0_wp*load(), [unknowns]), matmul(full(matrix), reshape(x, [unknowns])), 1.0e-10_wp)
      x(2, 4) = x(2, 4) + 0.5_wp
      call small_block_remainder(matrix, -2.0_wp*load(), x, largest)
      call assertEqual(maxval(abs(matmul(full(matrix), reshape(x, [unknowns])) - reshape(2.0_wp*load(), [unknowns]))), largest, &
                       1.0e-10_wp, message='remainder')
   end subroutine test_again

   !> Rows and columns in other units, from 1e-6 to 1e6 of each other: the same solution to the same accuracy, none refined.
   subroutine test_units()
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp) :: x(b, nodes), y(b, nodes)
      real(wp), parameter :: units(b) = [1.0e3_wp, 1.0e-3_wp, 1.0_wp]
      integer :: i, j, info
      matrix = any_matrix()
      call new_linear_solver(solver_block, nodes, linear, b)
      call solve_linear(linear, matrix, load(), x, info)
      do j = 1, b
         do i = 1, b
            matrix%diagonal(i, j, :) = matrix%diagonal(i, j, :)*units(i)*units(j)
            matrix%upper(i, j, :) = matrix%upper(i, j, :)*units(i)*units(j)
            matrix%lower(i, j, :) = matrix%lower(i, j, :)*units(i)*units(j)
         end do
      end do
      call solve_linear(linear, matrix, load()*spread(units, 2, nodes), y, info)
      call assertEqual(0, info)
      call assertEqual(x, y*spread(units, 2, nodes), 1.0e-11_wp*maxval(abs(x)))
   end subroutine test_units

   !> A block that is singular by itself in a matrix that is not: elimination names it, the checked solution takes the band solver.
   subroutine test_singular_block()
      type(block_matrix_type) :: matrix
      type(small_block_solver_type) :: solver
      type(linear_solver_type) :: linear
      real(wp) :: x(b, nodes)
      integer :: info
      matrix = any_matrix()
      matrix%diagonal(:, 2, 1) = 0.0_wp
      call new_small_block_solver(nodes, solver)
      x = load()
      call small_block_solve(solver, matrix, x, info)
      call assertEqual(1, info)
      call new_linear_solver(solver_block, nodes, linear, b)
      call solve_linear(linear, matrix, -load(), x, info)
      call assertEqual(0, info)
      call assertEqual(1, linear%fallbacks)
      call assertEqual(reshape(load(), [unknowns]), matmul(full(matrix), reshape(x, [unknowns])), 1.0e-10_wp)
      matrix%upper(:, :, 1) = 0.0_wp      ! now nothing holds that unknown
      matrix%lower(:, 2, 1) = 0.0_wp
      call solve_linear(linear, matrix, -load(), x, info)
      call assertGreaterThan(info, 0, message='singular')
   end subroutine test_singular_block

   !> A first block singular but for 1e-13: numbers grow, and the answer is good all the same.
   subroutine test_refined()
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp) :: x(b, nodes)
      integer :: info
      matrix = any_matrix()
      matrix%diagonal(:, 2, 1) = matrix%diagonal(:, 1, 1)
      matrix%diagonal(3, 2, 1) = matrix%diagonal(3, 2, 1) + 1.0e-13_wp
      call new_linear_solver(solver_block, nodes, linear, b)
      call solve_linear(linear, matrix, -load(), x, info)
      call assertEqual(0, info)
      call assertGreaterThan(linear%refinements + linear%fallbacks, 0, message='refined, or solved by bands')
      call assertLessThan(maxval(abs(matmul(full(matrix), reshape(x, [unknowns])) - reshape(load(), [unknowns]))), 1.0e-7_wp)
   end subroutine test_refined

   !> A symmetric matrix with two negative eigenvalues: diagonal but for couplings too weak to change a sign.
   subroutine test_negative_pivots()
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp) :: x(b, nodes)
      integer :: n, i, info
      matrix = new_block_matrix(nodes, b)
      do n = 1, nodes
         do i = 1, b
            matrix%diagonal(i, i, n) = 4.0_wp + i
         end do
         if (n == nodes) exit
         matrix%upper(1, 2, n) = 0.5_wp
         matrix%lower(2, 1, n) = 0.5_wp
      end do
      matrix%diagonal(2, 2, 3) = -3.0_wp
      matrix%diagonal(3, 3, 6) = -1.0_wp
      call new_linear_solver(solver_sparse, nodes, linear, b)
      call solve_linear(linear, matrix, -load(), x, info)
      call assertEqual(0, info)
      call assertEqual(2, linear%negative_pivots)
      call assertEqual(reshape(load(), [unknowns]), matmul(full(matrix), reshape(x, [unknowns])), 1.0e-12_wp)
   end subroutine test_negative_pivots
end module dg_test_plane_equations
