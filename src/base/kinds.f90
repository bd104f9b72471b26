!> The one real kind of the program.
module dg_kinds
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: wp

   !> Working precision: IEEE double.
   integer, parameter :: wp = real64
end module dg_kinds
