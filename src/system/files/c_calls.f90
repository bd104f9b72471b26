!> Functions of the C library that several modules call.
module dg_c_calls
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long, c_ptr, c_size_t
   implicit none
   private
   public :: c_dlsym, c_errno_location, c_fclose, c_fopen, c_getpid, c_kill, c_waitpid, c_write

   interface
      !> Looks a name of the C library up; a null handle: wherever it is. A Fortran variable of that name would be another one.
      function c_dlsym(handle, name) result(address) bind(c, name='dlsym')
         import :: c_char, c_ptr
         implicit none
         type(c_ptr), value :: handle
         character(kind=c_char), intent(in) :: name(*)
         type(c_ptr) :: address
      end function c_dlsym

      !> Where errno of this thread is (GNU C library).
      function c_errno_location() result(address) bind(c, name='__errno_location')
         import :: c_ptr
         implicit none
         type(c_ptr) :: address
      end function c_errno_location

      function c_fclose(file) result(status) bind(c, name='fclose')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: file
         integer(c_int) :: status
      end function c_fclose

      function c_fopen(path, mode) result(file) bind(c, name='fopen')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: path(*), mode(*)
         type(c_ptr) :: file
      end function c_fopen

      function c_getpid() result(number) bind(c, name='getpid')
         import :: c_int
         implicit none
         integer(c_int) :: number
      end function c_getpid

      function c_kill(process, signal) result(status) bind(c, name='kill')
         import :: c_int
         implicit none
         integer(c_int), value :: process, signal
         integer(c_int) :: status
      end function c_kill

      function c_waitpid(process, status, options) result(ended) bind(c, name='waitpid')
         import :: c_int
         implicit none
         integer(c_int), value :: process, options
         integer(c_int), intent(inout) :: status
         integer(c_int) :: ended
      end function c_waitpid

      ! ssize_t is long on Linux
      function c_write(descriptor, text, length) result(written) bind(c, name='write')
         import :: c_char, c_int, c_long, c_size_t
         implicit none
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: length
         integer(c_long) :: written
      end function c_write
   end interface
end module dg_c_calls
