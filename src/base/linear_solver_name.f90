!> The linear solvers, by number and by name.
module dg_linear_solver_name
   implicit none
   private
   public :: solver_block, solver_banded, solver_sparse, solver_count, solver_name

   integer, parameter :: solver_block = 1   !< elimination by blocks, 6 x 6 or 3 x 3
   integer, parameter :: solver_banded = 2  !< LAPACK's band LU
   !> Of SuiteSparse: LDL where the matrix is symmetric and positive definite, else KLU, a sparse LU.
   integer, parameter :: solver_sparse = 3
   integer, parameter :: solver_count = 3
   !> Names in decks, in the order of the numbers above.
   character(*), parameter :: solver_name(solver_count) = [character(6) :: 'block', 'banded', 'sparse']
end module dg_linear_solver_name
