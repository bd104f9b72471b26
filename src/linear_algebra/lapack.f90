!> Explicit interfaces of the LAPACK routines in use.
module dg_lapack
   use dg_kinds, only: wp
   implicit none
   private
   public :: dgbtrf, dgbtrs

   interface
      !> LU factors of a general band matrix with partial pivoting.
      subroutine dgbtrf(m, n, kl, ku, ab, ldab, ipiv, info)
         import :: wp
         implicit none
         integer, intent(in) :: m, n, kl, ku, ldab
         real(wp), intent(inout) :: ab(ldab, *)
         integer, intent(out) :: ipiv(*)
         integer, intent(out) :: info
      end subroutine dgbtrf
      !> Solution with the factors of dgbtrf.
      subroutine dgbtrs(trans, n, kl, ku, nrhs, ab, ldab, ipiv, b, ldb, info)
         import :: wp
         implicit none
         character, intent(in) :: trans
         integer, intent(in) :: n, kl, ku, nrhs, ldab, ldb
         real(wp), intent(in) :: ab(ldab, *)
         integer, intent(in) :: ipiv(*)
         real(wp), intent(inout) :: b(ldb, *)
         integer, intent(out) :: info
      end subroutine dgbtrs
   end interface
end module dg_lapack
