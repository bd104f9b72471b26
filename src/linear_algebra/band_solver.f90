!> Banded solution of a chain of nodes by LAPACK: LU with row exchange (dgbtrf, dgbtrs).
module dg_band_solver
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   use dg_lapack, only: dgbtrf, dgbtrs
   implicit none
   private
   public :: band_solver_type, new_band_solver, band_factor, band_solve

   !> Off-diagonals on each side: two neighbouring nodes couple all their unknowns.
   integer, parameter :: half_width = 2*block_size - 1
   integer, parameter :: band_rows = 3*half_width + 1  !< dgbtrf wants room for fill above

   type :: band_solver_type
      integer :: unknowns = 0
      real(wp), allocatable :: band(:, :)      !< (band_rows, unknowns), factors after band_factor
      integer, allocatable :: pivots(:)
   end type band_solver_type

contains

   !> Room for a chain of so many nodes; the solver may be used again for any number of matrices.
   pure function new_band_solver(nodes) result(solver)
      integer, intent(in) :: nodes
      type(band_solver_type) :: solver
      solver%unknowns = block_size*nodes
      allocate (solver%band(band_rows, solver%unknowns), source=0.0_wp)
      allocate (solver%pivots(solver%unknowns), source=0)
   end function new_band_solver

   !> Factors the matrix. info = 0: done; > 0: the unknown (6 a node) at which it is singular.
   subroutine band_factor(solver, matrix, info)
      type(band_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(out) :: info
      integer :: n, i, j, row, column, nodes
      integer, parameter :: centre = 2*half_width + 1
      nodes = solver%unknowns/block_size
      solver%band = 0.0_wp
      do n = 1, nodes
         do j = 1, block_size
            column = block_size*(n - 1) + j
            row = centre - j
            do i = 1, block_size
               solver%band(row + i, column) = matrix%diagonal(i, j, n)
            end do
            if (n < nodes) then
               do i = 1, block_size
                  solver%band(row + block_size + i, column) = matrix%lower(i, j, n)
               end do
            end if
            if (n > 1) then
               do i = 1, block_size
                  solver%band(row - block_size + i, column) = matrix%upper(i, j, n - 1)
               end do
            end if
         end do
      end do
      call dgbtrf(solver%unknowns, solver%unknowns, half_width, half_width, solver%band, band_rows, solver%pivots, info)
   end subroutine band_factor

   !> Solves with the factors of band_factor; rhs(6,nodes) becomes the solution.
   subroutine band_solve(solver, rhs)
      type(band_solver_type), intent(in) :: solver
      real(wp), intent(inout) :: rhs(:, :)
      integer :: info
      call dgbtrs('N', solver%unknowns, half_width, half_width, 1, solver%band, band_rows, solver%pivots, rhs, &
                  solver%unknowns, info)
   end subroutine band_solve
end module dg_band_solver
