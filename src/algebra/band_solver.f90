!> Banded solution of a chain of nodes by LAPACK: LU with row exchange (dgbtrf, dgbtrs).
module dg_band_solver
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block => block_size
   use dg_lapack, only: dgbtrf, dgbtrs
   implicit none
   private
   public :: band_solver_type, new_band_solver, band_factor, band_solve

   type :: band_solver_type
      integer :: unknowns = 0
      integer :: half_width = 0                !< off-diagonals on each side: two neighbours couple all their unknowns
      real(wp), allocatable :: band(:, :)      !< (3 half_width + 1, unknowns), factors after band_factor
      integer, allocatable :: pivots(:)
   end type band_solver_type

contains

   !> Room for a chain of so many nodes; the solver may be used again for any number of matrices.
   pure function new_band_solver(nodes) result(solver)
      integer, intent(in) :: nodes
      type(band_solver_type) :: solver
      solver%unknowns = block*nodes
      solver%half_width = 2*block - 1
      allocate (solver%band(3*solver%half_width + 1, solver%unknowns), source=0.0_wp)   ! dgbtrf wants room for fill above
      allocate (solver%pivots(solver%unknowns), source=0)
   end function new_band_solver

   !> Factors the matrix. info = 0: done; > 0: the unknown at which it is singular.
   subroutine band_factor(solver, matrix, info)
      type(band_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(out) :: info
      integer :: n, i, j, row, column, nodes
      nodes = solver%unknowns/block
      solver%band = 0.0_wp
      do n = 1, nodes
         do j = 1, block
            column = block*(n - 1) + j
            row = 2*solver%half_width + 1 - j
            do i = 1, block
               solver%band(row + i, column) = matrix%diagonal(i, j, n)
            end do
            if (n < nodes) then
               do i = 1, block
                  solver%band(row + block + i, column) = matrix%lower(i, j, n)
               end do
            end if
            if (n > 1) then
               do i = 1, block
                  solver%band(row - block + i, column) = matrix%upper(i, j, n - 1)
               end do
            end if
         end do
      end do
      call dgbtrf(solver%unknowns, solver%unknowns, solver%half_width, solver%half_width, solver%band, size(solver%band, 1), &
                  solver%pivots, info)
   end subroutine band_factor

   !> Solves with the factors of band_factor; rhs(6,nodes) becomes the solution.
   subroutine band_solve(solver, rhs)
      type(band_solver_type), intent(in) :: solver
      real(wp), intent(inout) :: rhs(:, :)
      integer :: info
      call dgbtrs('N', solver%unknowns, solver%half_width, solver%half_width, 1, solver%band, size(solver%band, 1), &
                  solver%pivots, rhs, solver%unknowns, info)
   end subroutine band_solve
end module dg_band_solver
