!> Sparse solution of a chain of nodes with a symmetric matrix, by LDL, which has half the entries of an LU. By Sylvester's law
!> of inertia D has as many negative pivots as the matrix has negative eigenvalues. That is the number of unstable modes. Rows
!> are not exchanged, so that only a positive definite matrix is solved safely. Nodes stay in their order, which for a chain
!> leaves hardly any fill.
module dg_symmetric_solver
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_null_ptr
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type
   use dg_ldl, only: ldl_dsolve, ldl_lsolve, ldl_ltsolve, ldl_numeric, ldl_symbolic
   use dg_sparse_matrix, only: set_sparse_matrix, sparse_matrix_type
   implicit none
   private
   public :: symmetric_solver_type, symmetric_factor, symmetric_solve, is_symmetric

   type :: symmetric_solver_type
      type(sparse_matrix_type) :: matrix
      integer :: negative_pivots = 0                   !< of the matrix that was factored
      integer :: fill = 0                              !< entries of L and D
      integer(c_int), allocatable :: columns(:)        !< where those of L begin, from 0 (unknowns + 1)
      integer(c_int), allocatable :: rows(:)           !< of the entries of L, from 0
      real(c_double), allocatable :: factor(:)         !< entries of L
      real(c_double), allocatable :: diagonal(:)       !< D (unknowns)
      integer(c_int), allocatable :: room(:, :)        !< (unknowns,4)
      real(c_double), allocatable :: row(:)            !< (unknowns)
   end type symmetric_solver_type

   integer, parameter :: tree = 1, counts = 2, flags = 3, pattern = 4   !< columns of the room
   !> Largest difference of an entry from its mirror image, over the root of the product of the diagonal's [-]: what sums in
   !> another order leave. The smallest friction that a deck may have shows by a thousand times as much.
   real(wp), parameter :: mirror = 1.0e-12_wp

contains

   !> True if a matrix is symmetric but for round-off.
   pure function is_symmetric(matrix) result(symmetric)
      type(block_matrix_type), intent(in) :: matrix
      logical :: symmetric
      real(wp), dimension(size(matrix%diagonal, 1)) :: scale, before
      integer :: n, i, j
      symmetric = .false.
      do n = 1, size(matrix%diagonal, 3)
         do i = 1, size(scale)
            scale(i) = sqrt(abs(matrix%diagonal(i, i, n)))
         end do
         do j = 1, size(scale)
            do i = 1, j - 1
               if (.not. alike(matrix%diagonal(i, j, n), matrix%diagonal(j, i, n), scale(i)*scale(j))) return
            end do
         end do
         if (n > 1) then
            do j = 1, size(scale)
               do i = 1, size(scale)
                  if (.not. alike(matrix%upper(i, j, n - 1), matrix%lower(j, i, n - 1), before(i)*scale(j))) return
               end do
            end do
         end if
         before = scale
      end do
      symmetric = .true.
   end function is_symmetric

   elemental function alike(a, b, scale) result(same)
      real(wp), intent(in) :: a, b, scale
      logical :: same
      same = abs(a - b) <= mirror*scale
   end function alike

   !> Factors a symmetric matrix, of which what stands below the diagonal is not read. info = 0: done; > 0: the unknown at which
   !> a pivot is zero. `solver%negative_pivots` tells whether it is positive definite.
   subroutine symmetric_factor(solver, matrix, info)
      type(symmetric_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(out) :: info
      integer(c_int) :: n, done
      integer :: entries
      call set_sparse_matrix(matrix, solver%matrix, upper=.true.)
      n = int(solver%matrix%unknowns, c_int)
      if (allocated(solver%diagonal)) then
         if (size(solver%diagonal) /= n) deallocate (solver%columns, solver%diagonal, solver%room, solver%row)
      end if
      if (.not. allocated(solver%diagonal)) allocate (solver%columns(n + 1), solver%diagonal(n), solver%room(n, 4), solver%row(n))
      call ldl_symbolic(n, solver%matrix%columns, solver%matrix%rows, solver%columns, solver%room(:, tree), &
                        solver%room(:, counts), solver%room(:, flags), c_null_ptr, c_null_ptr)
      entries = solver%columns(n + 1)
      if (allocated(solver%rows)) then
         if (size(solver%rows) < entries) deallocate (solver%rows, solver%factor)
      end if
      if (.not. allocated(solver%rows)) allocate (solver%rows(entries), solver%factor(entries))
      done = ldl_numeric(n, solver%matrix%columns, solver%matrix%rows, solver%matrix%values, solver%columns, &
                         solver%room(:, tree), solver%room(:, counts), solver%rows, solver%factor, solver%diagonal, solver%row, &
                         solver%room(:, pattern), solver%room(:, flags), c_null_ptr, c_null_ptr)
      info = merge(0, done + 1, done == n)
      solver%fill = entries + n
      solver%negative_pivots = count(solver%diagonal(:done) < 0.0_c_double)
   end subroutine symmetric_factor

   !> Solves with the factors of symmetric_factor; rhs(unknowns of a node,nodes) becomes the solution.
   subroutine symmetric_solve(solver, rhs)
      type(symmetric_solver_type), intent(in) :: solver
      real(wp), intent(inout) :: rhs(:, :)
      integer(c_int) :: n
      n = int(solver%matrix%unknowns, c_int)
      call ldl_lsolve(n, rhs, solver%columns, solver%rows, solver%factor)
      call ldl_dsolve(n, rhs, solver%diagonal)
      call ldl_ltsolve(n, rhs, solver%columns, solver%rows, solver%factor)
   end subroutine symmetric_solve
end module dg_symmetric_solver
