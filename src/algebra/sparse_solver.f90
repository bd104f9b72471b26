!> Sparse solution of a chain of nodes by KLU: LU without zeros. Nodes stay in their order, which for a chain leaves hardly any
!> fill. Rows are exchanged if a diagonal entry is below KLU's thousandth of the largest in its column. With full exchange
!> factors are larger, take longer and have larger residuals.
!>
!> Factors live in memory of the library. They are given back by sparse_release, which the next sparse_factor calls itself;
!> a solver that holds factors must not be copied.
module dg_sparse_solver
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_null_ptr, c_ptr
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type
   use dg_klu, only: klu_analyze_given, klu_common_type, klu_condest, klu_defaults, klu_factor, klu_free_numeric, &
                     klu_free_symbolic, klu_numeric_head_type, klu_solve
   use dg_sparse_matrix, only: set_sparse_matrix, sparse_matrix_type
   implicit none
   private
   public :: sparse_solver_type, sparse_factor, sparse_solve, sparse_release, sparse_condition

   type :: sparse_solver_type
      type(sparse_matrix_type) :: matrix
      type(klu_common_type) :: common
      type(c_ptr) :: symbolic = c_null_ptr
      type(c_ptr) :: numeric = c_null_ptr
      integer :: fill = 0                     !< entries of both factors
   end type sparse_solver_type

   integer(c_int), parameter :: success = 1_c_int

contains

   !> Factors the matrix. info = 0: done; > 0: singular, or no memory for the factors.
   subroutine sparse_factor(solver, matrix, info)
      type(sparse_solver_type), intent(inout) :: solver
      type(block_matrix_type), intent(in) :: matrix
      integer, intent(out) :: info
      type(klu_numeric_head_type), pointer :: head
      call sparse_release(solver)
      call set_sparse_matrix(matrix, solver%matrix, upper=.false.)
      info = 1
      if (klu_defaults(solver%common) /= success) return
      solver%common%btf = 0_c_int             ! a string hangs together: there are no blocks to be found
      solver%symbolic = klu_analyze_given(int(solver%matrix%unknowns, c_int), solver%matrix%columns, solver%matrix%rows, &
                                          c_null_ptr, c_null_ptr, solver%common)
      if (.not. c_associated(solver%symbolic)) return
      solver%numeric = klu_factor(solver%matrix%columns, solver%matrix%rows, solver%matrix%values, solver%symbolic, solver%common)
      if (.not. c_associated(solver%numeric)) then
         call sparse_release(solver)
         return
      end if
      call c_f_pointer(solver%numeric, head)
      solver%fill = head%lower_entries + head%upper_entries
      info = 0
   end subroutine sparse_factor

   !> Solves with the factors of sparse_factor; rhs(unknowns of a node,nodes) becomes the solution.
   subroutine sparse_solve(solver, rhs)
      type(sparse_solver_type), intent(inout) :: solver
      real(wp), intent(inout) :: rhs(:, :)
      integer(c_int) :: done
      done = klu_solve(solver%symbolic, solver%numeric, int(solver%matrix%unknowns, c_int), 1_c_int, rhs, solver%common)
      if (done /= success) rhs = huge(1.0_wp)   ! no factors: a residual that nobody can take for small
   end subroutine sparse_solve

   !> Estimated condition number (1-norm) of the matrix that has been factored [-]; 0 where there is none.
   subroutine sparse_condition(solver, condition)
      type(sparse_solver_type), intent(inout) :: solver
      real(wp), intent(out) :: condition
      condition = 0.0_wp
      if (.not. c_associated(solver%numeric)) return
      if (klu_condest(solver%matrix%columns, solver%matrix%values, solver%symbolic, solver%numeric, solver%common) == success) &
         condition = solver%common%condest
   end subroutine sparse_condition

   !> Gives the factors back.
   subroutine sparse_release(solver)
      type(sparse_solver_type), intent(inout) :: solver
      integer(c_int) :: done
      if (c_associated(solver%numeric)) done = klu_free_numeric(solver%numeric, solver%common)
      if (c_associated(solver%symbolic)) done = klu_free_symbolic(solver%symbolic, solver%common)
      solver%numeric = c_null_ptr
      solver%symbolic = c_null_ptr
   end subroutine sparse_release
end module dg_sparse_solver
