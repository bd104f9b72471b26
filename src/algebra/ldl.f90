!> Interfaces of LDL, the sparse factors L D L^T of SuiteSparse (Davis 2005, ACM TOMS 31, algorithm 849). Matrices are by
!> columns, with indices from 0. Only entries on and above the diagonal are read. The caller allocates all arrays.
module dg_ldl
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
   implicit none
   private
   public :: ldl_symbolic, ldl_numeric, ldl_lsolve, ldl_dsolve, ldl_ltsolve

   interface
      !> Analysis: where each column of L begins (n + 1), and the tree of the elimination; null orders stand for the order as it is.
      subroutine ldl_symbolic(n, columns, rows, factor_columns, parent, counts, flag, order, inverse_order) &
         bind(c, name='ldl_symbolic')
         import :: c_int, c_ptr
         implicit none
         integer(c_int), value :: n
         integer(c_int), intent(in) :: columns(*), rows(*)
         integer(c_int), intent(out) :: factor_columns(*), parent(*), counts(*), flag(*)
         type(c_ptr), value :: order, inverse_order
      end subroutine ldl_symbolic

      !> Factors. done = n, or the row, from 0, at which the diagonal became zero.
      function ldl_numeric(n, columns, rows, values, factor_columns, parent, counts, factor_rows, factor, diagonal, work, pattern, &
                           flag, order, inverse_order) result(done) bind(c, name='ldl_numeric')
         import :: c_double, c_int, c_ptr
         implicit none
         integer(c_int), value :: n
         integer(c_int), intent(in) :: columns(*), rows(*)
         real(c_double), intent(in) :: values(*)
         integer(c_int), intent(in) :: factor_columns(*), parent(*)
         integer(c_int), intent(out) :: counts(*), factor_rows(*)
         real(c_double), intent(out) :: factor(*), diagonal(*), work(*)
         integer(c_int), intent(out) :: pattern(*), flag(*)
         type(c_ptr), value :: order, inverse_order
         integer(c_int) :: done
      end function ldl_numeric

      !> x <- L^-1 x; L has a unit diagonal, which is not stored.
      subroutine ldl_lsolve(n, x, factor_columns, factor_rows, factor) bind(c, name='ldl_lsolve')
         import :: c_double, c_int
         implicit none
         integer(c_int), value :: n
         real(c_double), intent(inout) :: x(*)
         integer(c_int), intent(in) :: factor_columns(*), factor_rows(*)
         real(c_double), intent(in) :: factor(*)
      end subroutine ldl_lsolve

      !> x <- D^-1 x.
      subroutine ldl_dsolve(n, x, diagonal) bind(c, name='ldl_dsolve')
         import :: c_double, c_int
         implicit none
         integer(c_int), value :: n
         real(c_double), intent(inout) :: x(*)
         real(c_double), intent(in) :: diagonal(*)
      end subroutine ldl_dsolve

      !> x <- L^-T x.
      subroutine ldl_ltsolve(n, x, factor_columns, factor_rows, factor) bind(c, name='ldl_ltsolve')
         import :: c_double, c_int
         implicit none
         integer(c_int), value :: n
         real(c_double), intent(inout) :: x(*)
         integer(c_int), intent(in) :: factor_columns(*), factor_rows(*)
         real(c_double), intent(in) :: factor(*)
      end subroutine ldl_ltsolve
   end interface
end module dg_ldl
