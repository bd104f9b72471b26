!> Sparse solution of symmetric chains, and how many eigenvalues of theirs are negative.
module dg_test_symmetric_solver
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_block_matrix, only: block_matrix_type, block_product, block_size, new_block_matrix
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solve_linear, solver_count, solver_name, solver_sparse
   use dg_missing, only: missing_count
   use dg_symmetric_solver, only: is_symmetric, symmetric_factor, symmetric_solve, symmetric_solver_type
   implicit none
   private
   public :: symmetric_solver_suite

   integer, parameter :: nodes = 7, unknowns = block_size*nodes

contains

   function symmetric_solver_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('symmetric_solver')
      call suite%addTest(TestMethod('same_answer', test_same_answer))
      call suite%addTest(TestMethod('inertia', test_inertia))
      call suite%addTest(TestMethod('symmetry', test_symmetry))
      call suite%addTest(TestMethod('zero_pivot', test_zero_pivot))
      call suite%addTest(TestMethod('used_again', test_used_again))
   end function symmetric_solver_suite

   !> Any numbers with symmetry; diagonally dominant from a `lift` of 12 on, whose rows have 17 others of at most 1.
   function any_symmetric(lift) result(matrix)
      real(wp), intent(in) :: lift
      type(block_matrix_type) :: matrix
      integer :: n, i, k
      matrix = new_block_matrix(nodes)
      matrix%diagonal = reshape([(sin(1.7_wp*k*k), k=1, 36*nodes)], [6, 6, nodes])
      matrix%upper = reshape([(cos(2.3_wp*k*k), k=1, 36*(nodes - 1))], [6, 6, nodes - 1])
      do n = 1, nodes
         matrix%diagonal(:, :, n) = 0.5_wp*(matrix%diagonal(:, :, n) + transpose(matrix%diagonal(:, :, n)))
         do i = 1, block_size
            matrix%diagonal(i, i, n) = matrix%diagonal(i, i, n) + lift
         end do
         if (n < nodes) matrix%lower(:, :, n) = transpose(matrix%upper(:, :, n))
      end do
   end function any_symmetric

   !> Springs of stiffness 1 in a row, held at one end by another; six such rows that have nothing to do with each other. Their
   !> eigenvalues are 2 - 2 cos((2 k - 1) pi/(2 nodes + 1)).
   function springs(less) result(matrix)
      real(wp), intent(in) :: less       !< taken off the diagonal
      type(block_matrix_type) :: matrix
      integer :: n, i
      matrix = new_block_matrix(nodes)
      do n = 1, nodes
         do i = 1, block_size
            matrix%diagonal(i, i, n) = merge(1.0_wp, 2.0_wp, n == nodes) - less
            if (n < nodes) matrix%upper(i, i, n) = -1.0_wp
            if (n < nodes) matrix%lower(i, i, n) = -1.0_wp
         end do
      end do
   end function springs

   function any_load() result(load)
      real(wp) :: load(6, nodes)
      integer :: k
      load = reshape([(sin(3.0_wp*k), k=1, unknowns)], [6, nodes])
   end function any_load

   !> Every solver solves a symmetric matrix, definite or not; the sparse one tells which it is.
   subroutine test_same_answer()
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp) :: x(6, nodes)
      integer :: kind, info, pass
      do pass = 1, 2
         matrix = any_symmetric(merge(20.0_wp, 0.3_wp, pass == 1))
         do kind = 1, solver_count
            call new_linear_solver(kind, nodes, linear)
            call solve_linear(linear, matrix, -any_load(), x, info)
            call assertEqual(0, info)
            call assertEqual(any_load(), block_product(matrix, x), merge(1.0e-14_wp, 1.0e-11_wp, pass == 1), &
                             message=solver_name(kind))
         end do
         if (pass == 1) call assertEqual(0, linear_negatives(matrix), message='dominant diagonal: positive definite')
         if (pass == 2) call assertGreaterThan(linear_negatives(matrix), 0, message='indefinite')
      end do
   end subroutine test_same_answer

   !> Negative eigenvalues by the one interface; the answer is right however many there are.
   function linear_negatives(matrix) result(negatives)
      type(block_matrix_type), intent(in) :: matrix
      integer :: negatives, info
      type(linear_solver_type) :: linear
      real(wp) :: x(6, nodes)
      call new_linear_solver(solver_sparse, nodes, linear)
      call solve_linear(linear, matrix, -any_load(), x, info)
      call assertEqual(0, info)
      call assertEqual(any_load(), block_product(matrix, x), 1.0e-9_wp)    ! next to singular, where an eigenvalue is next to 0
      negatives = linear%negative_pivots
   end function linear_negatives

   !> As many negative pivots as eigenvalues that the shift has passed, six of each.
   subroutine test_inertia()
      real(wp) :: eigenvalue
      integer :: k
      do k = 1, nodes
         eigenvalue = 2.0_wp - 2.0_wp*cos((2*k - 1)*pi/(2*nodes + 1))
         call assertEqual(block_size*(k - 1), linear_negatives(springs(0.9999_wp*eigenvalue)), message='just above')
         call assertEqual(block_size*k, linear_negatives(springs(1.0001_wp*eigenvalue)), message='just below')
      end do
   end subroutine test_inertia

   !> One entry in the diagonal's blocks, or beside them, that differs from its mirror image by more than round-off.
   subroutine test_symmetry()
      type(block_matrix_type) :: matrix
      matrix = any_symmetric(20.0_wp)
      call assertTrue(is_symmetric(matrix))
      matrix%diagonal(2, 5, 3) = matrix%diagonal(2, 5, 3) + 1.0e-13_wp
      matrix%lower(1, 4, 6) = matrix%lower(1, 4, 6) - 1.0e-13_wp
      call assertTrue(is_symmetric(matrix), message='round-off')
      matrix%lower(1, 4, 6) = matrix%lower(1, 4, 6) - 1.0e-8_wp
      call assertFalse(is_symmetric(matrix), message='beside the diagonal')
      call assertEqual(missing_count, linear_negatives(matrix), message='nothing is said')
      matrix = any_symmetric(20.0_wp)
      matrix%diagonal(2, 5, nodes) = matrix%diagonal(2, 5, nodes) + 1.0e-8_wp
      call assertFalse(is_symmetric(matrix), message='in the last block')
      call assertEqual(missing_count, linear_negatives(matrix), message='nothing is said')
   end subroutine test_symmetry

   !> A pivot that is zero is named, and the answer comes from the LU.
   subroutine test_zero_pivot()
      type(block_matrix_type) :: matrix
      type(symmetric_solver_type) :: solver
      integer :: info
      matrix = springs(0.0_wp)
      matrix%diagonal(:, :, 1) = 0.0_wp
      call symmetric_factor(solver, matrix, info)
      call assertEqual(1, info)
      call assertEqual(missing_count, linear_negatives(matrix))
   end subroutine test_zero_pivot

   !> Nothing of a matrix is left in the next, be it longer, shorter or fuller.
   subroutine test_used_again()
      type(block_matrix_type) :: matrix
      type(symmetric_solver_type) :: solver
      real(wp) :: x(6, nodes), short(6, 1)
      integer :: pass, info
      do pass = 1, 3
         matrix = springs(0.0_wp)
         if (pass == 2) matrix = any_symmetric(20.0_wp)
         call symmetric_factor(solver, matrix, info)
         call assertEqual(0, info)
         x = any_load()
         call symmetric_solve(solver, x)
         call assertEqual(any_load(), block_product(matrix, x), 1.0e-13_wp)
         matrix = new_block_matrix(1)
         matrix%diagonal(:, :, 1) = 2.0_wp*unit_block()
         call symmetric_factor(solver, matrix, info)
         short = 4.0_wp
         call symmetric_solve(solver, short)
         call assertEqual(2.0_wp, short(:, 1), 1.0e-15_wp)
         call assertEqual(block_size, solver%fill, message='a diagonal matrix has no other entries')
      end do
   end subroutine test_used_again

   function unit_block() result(block)
      real(wp) :: block(block_size, block_size)
      integer :: i
      block = 0.0_wp
      do i = 1, block_size
         block(i, i) = 1.0_wp
      end do
   end function unit_block
end module dg_test_symmetric_solver
