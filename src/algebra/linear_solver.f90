!> One small interface to the linear solvers. The solution of any of them is checked against the matrix, and refined once if
!> its residual is too large. If that does not help, the pivoted band LU is used.
module dg_linear_solver
   use dg_kinds, only: wp
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_block_matrix, only: block_matrix_type, block_product, block_size
   use dg_block_solver, only: block_solve, block_solver_type, new_block_solver
   use dg_largest, only: largest_of
   use dg_linear_solver_name, only: solver_banded, solver_block, solver_count, solver_name, solver_sparse
   use dg_missing, only: missing_count
   use dg_sparse_solver, only: sparse_factor, sparse_release, sparse_solve, sparse_solver_type
   use dg_symmetric_solver, only: is_symmetric, symmetric_factor, symmetric_solve, symmetric_solver_type
   implicit none
   private
   public :: linear_solver_type, new_linear_solver, solve_linear
   public :: solver_block, solver_banded, solver_sparse, solver_count, solver_name

   !> Residual of a solution over the largest right-hand side, above which it is refined [-]. Newton's next step corrects the
   !> rest, so that four digits would be enough. Eight digits keep its convergence quadratic to the end.
   real(wp), parameter :: refine_above = 1.0e-8_wp

   type :: linear_solver_type
      integer :: kind = solver_block
      type(block_solver_type) :: block
      type(band_solver_type) :: band
      type(sparse_solver_type) :: sparse
      type(symmetric_solver_type) :: symmetric
      integer :: refinements = 0                !< so far
      integer :: fallbacks = 0                  !< so far
      !> Negative eigenvalues of the last matrix, where solver_sparse found it symmetric; missing: not known.
      integer :: negative_pivots = missing_count
   end type linear_solver_type

contains

   !> Room for a chain of so many nodes. The band solver's room is taken when first needed.
   pure subroutine new_linear_solver(kind, nodes, solver)
      integer, intent(in) :: kind
      integer, intent(in) :: nodes
      type(linear_solver_type), intent(out) :: solver
      solver%kind = kind
      if (kind == solver_block) call new_block_solver(nodes, solver%block)
   end subroutine new_linear_solver

   !> Newton's step: solves matrix step = -residual(6,nodes). info = 0: done; > 0: singular.
   subroutine solve_linear(solver, matrix, residual, step, info)
      type(linear_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in), contiguous :: residual(:, :)
      real(wp), intent(out), contiguous :: step(:, :)
      integer, intent(out) :: info
      logical :: good
      step = -residual
      if (solver%kind /= solver_banded) then
         if (solver%kind == solver_block) then
            call block_solve(solver%block, matrix, step, info)
         else
            call solve_symmetric(solver, matrix, residual, step, good)
            if (good) then
               info = 0
               return
            end if
            call sparse_factor(solver%sparse, matrix, info)
            if (info == 0) call sparse_solve(solver%sparse, step)
         end if
         good = info == 0
         if (good) then
            call check(residual, matrix, step, good)
            if (.not. good) call refine(solver, matrix, residual, step, good)
         end if
         if (solver%kind == solver_sparse) call sparse_release(solver%sparse)
         if (good) return
         solver%fallbacks = solver%fallbacks + 1
         step = -residual
      end if
      if (.not. allocated(solver%band%band)) solver%band = new_band_solver(size(step, 2))
      call band_factor(solver%band, matrix, info)
      if (info == 0) call band_solve(solver%band, step)
   end subroutine solve_linear

   !> Solves by LDL; not good: the matrix is not symmetric, not positive definite, or the residual is not small, and the step is
   !> the load.
   !> For a matrix that is symmetric negative_pivots tells how many negative eigenvalues it has.
   subroutine solve_symmetric(solver, matrix, residual, step, good)
      type(linear_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in), contiguous :: residual(:, :)
      real(wp), intent(inout), contiguous :: step(:, :)
      logical, intent(out) :: good
      integer :: info
      solver%negative_pivots = missing_count
      good = is_symmetric(matrix)
      if (.not. good) return
      call symmetric_factor(solver%symmetric, matrix, info)
      good = info == 0
      if (.not. good) return
      solver%negative_pivots = solver%symmetric%negative_pivots
      good = solver%negative_pivots == 0
      if (.not. good) return
      call symmetric_solve(solver%symmetric, step)
      call check(residual, matrix, step, good)
      if (.not. good) step = -residual
   end subroutine solve_symmetric

   !> One step of iterative refinement; good: it was enough. Elimination by blocks is done again, which is cheaper than to
   !> keep its factors: few solutions are refined.
   subroutine refine(solver, matrix, residual, step, good)
      type(linear_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in), contiguous :: residual(:, :)
      real(wp), intent(inout), contiguous :: step(:, :)
      logical, intent(out) :: good
      real(wp), allocatable :: correction(:, :)
      integer :: info
      solver%refinements = solver%refinements + 1
      allocate (correction, source=-residual - block_product(matrix, step))
      if (solver%kind == solver_block) then
         call block_solve(solver%block, matrix, correction, info)
      else
         call sparse_solve(solver%sparse, correction)
      end if
      step = step + correction
      call check(residual, matrix, step, good)
   end subroutine refine

   !> Check that residual + matrix step is small.
   pure subroutine check(residual, matrix, step, good)
      real(wp), intent(in), contiguous :: residual(:, :)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in), contiguous :: step(:, :)
      logical, intent(out) :: good
      real(wp) :: largest
      call remainder(size(step, 2), matrix, residual, step, largest)
      good = largest <= refine_above*largest_of(size(residual), residual)
   end subroutine check

   !> Largest entry of residual + matrix step.
   pure subroutine remainder(nodes, matrix, residual, step, largest)
      integer, intent(in) :: nodes
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: residual(block_size, nodes), step(block_size, nodes)
      real(wp), intent(out) :: largest
      real(wp), parameter :: nothing(block_size, block_size) = 0.0_wp
      integer :: n, before, after
      largest = 0.0_wp
      if (nodes == 1) then
         call look_at_row(residual(:, 1), matrix%diagonal(:, :, 1), step(:, 1), nothing, step(:, 1), nothing, step(:, 1), largest)
         return
      end if
      after = 2
      call look_at_row(residual(:, 1), matrix%diagonal(:, :, 1), step(:, 1), nothing, step(:, 1), matrix%upper(:, :, 1), &
                       step(:, after), largest)
      do n = 2, nodes - 1
         before = n - 1
         after = n + 1
         call look_at_row(residual(:, n), matrix%diagonal(:, :, n), step(:, n), matrix%lower(:, :, before), step(:, before), &
                          matrix%upper(:, :, n), step(:, after), largest)
      end do
      before = nodes - 1
      call look_at_row(residual(:, nodes), matrix%diagonal(:, :, nodes), step(:, nodes), matrix%lower(:, :, before), &
                       step(:, before), nothing, step(:, nodes), largest)
   end subroutine remainder

   !> One node's rows of it.
   pure subroutine look_at_row(residual, diagonal, x, lower, before, upper, after, largest)
      real(wp), intent(in), dimension(block_size) :: residual, x, before, after
      real(wp), intent(in), dimension(block_size, block_size) :: diagonal, lower, upper
      real(wp), intent(inout) :: largest
      real(wp) :: r(block_size)
      r = residual + diagonal(:, 1)*x(1) + diagonal(:, 2)*x(2) + diagonal(:, 3)*x(3) + diagonal(:, 4)*x(4) &
          + diagonal(:, 5)*x(5) + diagonal(:, 6)*x(6) &
          + lower(:, 1)*before(1) + lower(:, 2)*before(2) + lower(:, 3)*before(3) + lower(:, 4)*before(4) &
          + lower(:, 5)*before(5) + lower(:, 6)*before(6) &
          + upper(:, 1)*after(1) + upper(:, 2)*after(2) + upper(:, 3)*after(3) + upper(:, 4)*after(4) &
          + upper(:, 5)*after(5) + upper(:, 6)*after(6)
      largest = max(largest, largest_of(block_size, r))
   end subroutine look_at_row
end module dg_linear_solver
