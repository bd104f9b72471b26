!> Makes folders. POSIX calls, because Fortran has none and a shell command would need quoting.
module dg_folder
   use, intrinsic :: iso_c_binding, only: c_char, c_int
   use dg_error, only: error_type, raise, status_failure
   use dg_text, only: c_text
   implicit none
   private
   public :: make_folder, is_folder

   !> rwxrwxrwx less the user's umask (0777 octal).
   integer(c_int), parameter :: all_rights = 511_c_int
   !> W_OK + X_OK of unistd.h: files can be made in the folder.
   integer(c_int), parameter :: may_write = 3_c_int

   interface
      ! mode_t is unsigned int on Linux; 0777 is the same in int
      function c_mkdir(path, mode) result(status) bind(c, name='mkdir')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
         integer(c_int) :: status
      end function c_mkdir

      function c_access(path, mode) result(status) bind(c, name='access')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
         integer(c_int) :: status
      end function c_access
   end interface

contains

   !> Makes the folder `path` with all folders above it; one that is there already will do. An error where
   !> that fails or nothing can be written into it.
   subroutine make_folder(path, error)
      character(*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      integer(c_int) :: status
      do i = 2, len(path)
         if (path(i:i) /= '/') cycle
         if (path(i - 1:i - 1) /= '/') status = c_mkdir(c_text(path(:i - 1)), all_rights)
      end do
      status = c_mkdir(c_text(path), all_rights)     ! fails where it exists: what counts is what is there now
      if (.not. is_folder(path)) then
         call raise(error, status_failure, 'cannot make the output folder '//path// &
                    ' (is a file in its way, or a folder above it not writable?)')
      else if (c_access(c_text(path), may_write) /= 0) then
         call raise(error, status_failure, 'cannot write into the output folder '//path//'; change its rights or '// &
                    'use --output')
      end if
   end subroutine make_folder

   !> Whether a path is a folder: only a folder holds the entry '.'.
   function is_folder(path) result(is)
      character(*), intent(in) :: path
      logical :: is
      integer(c_int), parameter :: exists = 0_c_int   ! F_OK
      is = c_access(c_text(path//'/.'), exists) == 0
   end function is_folder
end module dg_folder
