!> Interfaces of KLU, the sparse LU of SuiteSparse (Davis & Palamadai Natarajan 2010, ACM TOMS 37, algorithm 907): matrices
!> by columns, row indices from 0.
module dg_klu
   use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_int64_t, c_ptr, c_size_t
   implicit none
   private
   public :: klu_common_type, klu_numeric_head_type
   public :: klu_defaults, klu_analyze_given, klu_factor, klu_solve, klu_condest, klu_free_symbolic, klu_free_numeric

   !> klu_common, and room behind it for versions that have more.
   type, bind(c) :: klu_common_type
      real(c_double) :: tol, memgrow, initmem_amd, initmem, maxwork
      integer(c_int) :: btf, ordering, scale
      type(c_funptr) :: user_order
      type(c_ptr) :: user_data
      integer(c_int) :: halt_if_singular
      integer(c_int) :: status, nrealloc, structural_rank, numerical_rank, singular_col, noffdiag
      real(c_double) :: flops, rcond, condest, rgrowth, work
      integer(c_size_t) :: memusage, mempeak
      integer(c_int64_t) :: room(64)
   end type klu_common_type

   !> Head of klu_numeric: entries of the factors L and U, their diagonals included.
   type, bind(c) :: klu_numeric_head_type
      integer(c_int) :: n, blocks, lower_entries, upper_entries
   end type klu_numeric_head_type

   interface
      function klu_defaults(common) result(done) bind(c, name='klu_defaults')
         import :: c_int, klu_common_type
         implicit none
         type(klu_common_type), intent(out) :: common
         integer(c_int) :: done
      end function klu_defaults

      !> Analysis in a given order of rows and columns; a null pointer stands for the order as it is.
      function klu_analyze_given(n, columns, rows, row_order, column_order, common) result(symbolic) &
         bind(c, name='klu_analyze_given')
         import :: c_int, c_ptr, klu_common_type
         implicit none
         integer(c_int), value :: n
         integer(c_int), intent(in) :: columns(*), rows(*)
         type(c_ptr), value :: row_order, column_order
         type(klu_common_type), intent(inout) :: common
         type(c_ptr) :: symbolic
      end function klu_analyze_given

      function klu_factor(columns, rows, values, symbolic, common) result(numeric) bind(c, name='klu_factor')
         import :: c_double, c_int, c_ptr, klu_common_type
         implicit none
         integer(c_int), intent(in) :: columns(*), rows(*)
         real(c_double), intent(in) :: values(*)
         type(c_ptr), value :: symbolic
         type(klu_common_type), intent(inout) :: common
         type(c_ptr) :: numeric
      end function klu_factor

      function klu_solve(symbolic, numeric, leading, sides, b, common) result(done) bind(c, name='klu_solve')
         import :: c_double, c_int, c_ptr, klu_common_type
         implicit none
         type(c_ptr), value :: symbolic, numeric
         integer(c_int), value :: leading, sides
         real(c_double), intent(inout) :: b(*)
         type(klu_common_type), intent(inout) :: common
         integer(c_int) :: done
      end function klu_solve

      !> Estimate of the condition number in the 1-norm, in common%condest (Higham's form of Hager's method).
      function klu_condest(columns, values, symbolic, numeric, common) result(done) bind(c, name='klu_condest')
         import :: c_double, c_int, c_ptr, klu_common_type
         implicit none
         integer(c_int), intent(in) :: columns(*)
         real(c_double), intent(in) :: values(*)
         type(c_ptr), value :: symbolic, numeric
         type(klu_common_type), intent(inout) :: common
         integer(c_int) :: done
      end function klu_condest

      function klu_free_symbolic(symbolic, common) result(done) bind(c, name='klu_free_symbolic')
         import :: c_int, c_ptr, klu_common_type
         implicit none
         type(c_ptr), intent(inout) :: symbolic
         type(klu_common_type), intent(inout) :: common
         integer(c_int) :: done
      end function klu_free_symbolic

      function klu_free_numeric(numeric, common) result(done) bind(c, name='klu_free_numeric')
         import :: c_int, c_ptr, klu_common_type
         implicit none
         type(c_ptr), intent(inout) :: numeric
         type(klu_common_type), intent(inout) :: common
         integer(c_int) :: done
      end function klu_free_numeric
   end interface
end module dg_klu
