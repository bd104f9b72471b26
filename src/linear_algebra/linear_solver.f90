!> One small interface to the linear solvers. Whatever solves, the solution is checked against the matrix: it is
!> refined once where the residual asks for it, and where that does not help the pivoted band LU takes over.
module dg_linear_solver
   use dg_kinds, only: wp
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_block_matrix, only: block_matrix_type, block_product
   use dg_block_solver, only: block_back, block_factor, block_solve, block_solver_type, new_block_solver
   use dg_sparse_solver, only: sparse_factor, sparse_release, sparse_solve, sparse_solver_type
   use dg_symmetric_solver, only: is_symmetric, symmetric_factor, symmetric_solve, symmetric_solver_type
   implicit none
   private
   public :: linear_solver_type, new_linear_solver, solve_linear
   public :: solver_block, solver_banded, solver_sparse, solver_count, solver_name

   integer, parameter :: solver_block = 1   !< 6 x 6 block elimination
   integer, parameter :: solver_banded = 2  !< LAPACK's band LU
   !> Of SuiteSparse: LDL where the matrix is symmetric and positive definite, else KLU, a sparse LU.
   integer, parameter :: solver_sparse = 3
   integer, parameter :: solver_count = 3
   !> Names in decks, in the order of the numbers above.
   character(*), parameter :: solver_name(solver_count) = [character(6) :: 'block', 'banded', 'sparse']

   !> Residual of a solution over the largest right-hand side at which it is refined [-]: Newton's next step corrects what
   !> is left, so that four digits would do; eight keep its convergence quadratic to the end.
   real(wp), parameter :: refine_above = 1.0e-8_wp

   type :: linear_solver_type
      integer :: kind = solver_block
      type(block_solver_type) :: block
      type(band_solver_type) :: band
      type(sparse_solver_type) :: sparse
      type(symmetric_solver_type) :: symmetric
      real(wp), allocatable :: rhs(:, :)        !< (6,nodes)
      integer :: refinements = 0                !< so far
      integer :: fallbacks = 0                  !< so far
      !> Negative eigenvalues of the last matrix, where solver_sparse found it symmetric; -1: not known.
      integer :: negative_pivots = -1
   end type linear_solver_type

contains

   !> Room for a chain of so many nodes. The band solver's room is taken when first needed.
   pure subroutine new_linear_solver(kind, nodes, solver)
      integer, intent(in) :: kind
      integer, intent(in) :: nodes
      type(linear_solver_type), intent(out) :: solver
      solver%kind = kind
      if (kind == solver_block) call new_block_solver(nodes, solver%block)
      allocate (solver%rhs(6, nodes), source=0.0_wp)
   end subroutine new_linear_solver

   !> Solves matrix x = x(6,nodes). info = 0: done; > 0: singular.
   subroutine solve_linear(solver, matrix, x, info)
      type(linear_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      integer, intent(out) :: info
      logical :: good
      solver%rhs = x
      if (solver%kind /= solver_banded) then
         if (solver%kind == solver_block) then
            call block_factor(solver%block, matrix, info, x)
            if (info == 0) call block_back(solver%block, matrix, x)
         else
            call solve_symmetric(solver, matrix, x, good)
            if (good) then
               info = 0
               return
            end if
            call sparse_factor(solver%sparse, matrix, info)
            if (info == 0) call sparse_solve(solver%sparse, x)
         end if
         good = info == 0
         if (good) then
            call check(solver%rhs, matrix, x, good)
            if (.not. good) call refine(solver, matrix, x, good)
         end if
         if (solver%kind == solver_sparse) call sparse_release(solver%sparse)
         if (good) return
         solver%fallbacks = solver%fallbacks + 1
         x = solver%rhs
      end if
      if (.not. allocated(solver%band%band)) solver%band = new_band_solver(size(x, 2))
      call band_factor(solver%band, matrix, info)
      if (info == 0) call band_solve(solver%band, x)
   end subroutine solve_linear

   !> Solves by LDL; not good: the matrix is not symmetric, not positive definite, or the residual is not small, and x is as it was.
   !> For a matrix that is symmetric negative_pivots tells how many negative eigenvalues it has.
   subroutine solve_symmetric(solver, matrix, x, good)
      type(linear_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      logical, intent(out) :: good
      integer :: info
      solver%negative_pivots = -1
      good = is_symmetric(matrix)
      if (.not. good) return
      call symmetric_factor(solver%symmetric, matrix, info)
      good = info == 0
      if (.not. good) return
      solver%negative_pivots = solver%symmetric%negative_pivots
      good = solver%negative_pivots == 0
      if (.not. good) return
      call symmetric_solve(solver%symmetric, x)
      call check(solver%rhs, matrix, x, good)
      if (.not. good) x = solver%rhs
   end subroutine solve_symmetric

   !> One step of iterative refinement with the factors that there are; good: it was enough.
   subroutine refine(solver, matrix, x, good)
      type(linear_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(inout) :: x(:, :)
      logical, intent(out) :: good
      real(wp), allocatable :: correction(:, :)
      solver%refinements = solver%refinements + 1
      allocate (correction, source=solver%rhs - block_product(matrix, x))
      if (solver%kind == solver_block) then
         call block_solve(solver%block, matrix, correction)
      else
         call sparse_solve(solver%sparse, correction)
      end if
      x = x + correction
      call check(solver%rhs, matrix, x, good)
   end subroutine refine

   !> Whether rhs - matrix x is small.
   pure subroutine check(rhs, matrix, x, good)
      real(wp), intent(in) :: rhs(:, :)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: x(:, :)
      logical, intent(out) :: good
      integer :: n, j, before
      real(wp) :: r(6), largest, scale
      largest = 0.0_wp
      scale = 0.0_wp
      do n = 1, size(x, 2)
         r = rhs(:, n)
         scale = max(scale, maxval(abs(r)))
         do j = 1, 6
            r = r - matrix%diagonal(:, j, n)*x(j, n)
         end do
         before = n - 1
         if (before >= 1) then
            do j = 1, 6
               r = r - matrix%lower(:, j, before)*x(j, before)
            end do
         end if
         if (n < size(x, 2)) then
            do j = 1, 6
               r = r - matrix%upper(:, j, n)*x(j, n + 1)
            end do
         end if
         largest = max(largest, maxval(abs(r)))
      end do
      good = largest <= refine_above*scale
   end subroutine check
end module dg_linear_solver
