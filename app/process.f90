!> What a program asks of its operating system: how to end, and whether anybody watches.
module dg_process
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: error_unit
   implicit none
   private
   public :: end_process, someone_watches, someone_reads

   !> Descriptors (POSIX).
   integer(c_int), parameter :: standard_output = 1_c_int, standard_error = 2_c_int

   interface
      subroutine c_exit(status) bind(c, name='exit')
         import :: c_int
         implicit none
         integer(c_int), value :: status
      end subroutine c_exit

      function c_isatty(descriptor) result(is) bind(c, name='isatty')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: is
      end function c_isatty
   end interface

contains

   !> Ends the program with an exit status. C's exit instead of STOP: a `stop` with a number prints 'STOP 2'
   !> and notes on floating-point flags to standard error, which is kept for diagnostics.
   subroutine end_process(status)
      integer, intent(in) :: status
      flush (error_unit)
      call c_exit(int(status, c_int))
   end subroutine end_process

   !> Whether standard error is a terminal: only then is progress shown.
   function someone_watches() result(watches)
      logical :: watches
      watches = c_isatty(standard_error) == 1_c_int
   end function someone_watches

   !> Whether standard output is a terminal.
   function someone_reads() result(reads)
      logical :: reads
      reads = c_isatty(standard_output) == 1_c_int
   end function someone_reads
end module dg_process
