!> Makes, lists and removes folders. POSIX calls, because Fortran has none and a shell command would need quoting.
module dg_folder
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_int16_t, c_int64_t, c_null_char, c_ptr, &
                                          c_signed_char
   use dg_error, only: error_type, raise, status_failure
   use dg_system_reason, only: system_reason
   use dg_text, only: append_text, c_text, text_type
   implicit none
   private
   public :: make_folder, is_folder, is_executable, list_folder, refuse_writing, remove_empty_folder

   !> rwxrwxrwx less the user's umask (0777 octal).
   integer(c_int), parameter :: all_rights = 511_c_int
   !> W_OK + X_OK of unistd.h: files can be made in the folder.
   integer(c_int), parameter :: may_write = 3_c_int
   !> F_OK of unistd.h: the path exists.
   integer(c_int), parameter :: is_there = 0_c_int

   integer, parameter :: longest_name = 256
   !> struct dirent of Linux on 64 bits.
   type, bind(c) :: dirent_type
      integer(c_int64_t) :: inode, offset
      integer(c_int16_t) :: length
      integer(c_signed_char) :: kind
      character(kind=c_char) :: name(longest_name)
   end type dirent_type

   interface
      function c_opendir(path) result(folder) bind(c, name='opendir')
         import :: c_char, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         type(c_ptr) :: folder
      end function c_opendir

      function c_readdir(folder) result(entry) bind(c, name='readdir')
         import :: c_ptr
         implicit none
         type(c_ptr), value :: folder
         type(c_ptr) :: entry
      end function c_readdir

      function c_closedir(folder) result(status) bind(c, name='closedir')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: folder
         integer(c_int) :: status
      end function c_closedir

      function c_rmdir(path) result(status) bind(c, name='rmdir')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: status
      end function c_rmdir

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
      character(:), allocatable :: reason
      character(:), allocatable :: above        ! why the first folder above it cannot be made; '': all are there
      integer :: i
      integer(c_int) :: status
      above = ''
      do i = 2, len(path)
         if (path(i:i) /= '/' .or. path(i - 1:i - 1) == '/') cycle
         status = c_mkdir(c_text(path(:i - 1)), all_rights)
         reason = system_reason()
         if (above == '' .and. c_access(c_text(path(:i - 1)), is_there) /= 0) above = reason
      end do
      status = c_mkdir(c_text(path), all_rights)     ! fails where it exists: what counts is what is there now
      reason = system_reason()
      if (.not. is_folder(path)) then
         if (above /= '') reason = above
         call raise(error, status_failure, 'cannot make the output folder '//path//': '//reason)
      else if (c_access(c_text(path), may_write) /= 0) then
         call refuse_writing(path, error)
      end if
   end subroutine make_folder

   !> The error of an output folder that the system has just refused to write into.
   subroutine refuse_writing(path, error)
      character(*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      call raise(error, status_failure, 'cannot write into the output folder '//path//': '//system_reason()//'; use --output')
   end subroutine refuse_writing

   !> True if a path is a folder: only a folder holds the entry '.'.
   function is_folder(path) result(is)
      character(*), intent(in) :: path
      logical :: is
      is = c_access(c_text(path//'/.'), is_there) == 0
   end function is_folder

   !> True if a path is a file that may be run.
   function is_executable(path) result(is)
      character(*), intent(in) :: path
      logical :: is
      integer(c_int), parameter :: may_execute = 1_c_int   ! X_OK
      is = c_access(c_text(path), may_execute) == 0 .and. .not. is_folder(path)
   end function is_executable

   !> Names of what a folder holds that end so, in no order; none where it cannot be read.
   subroutine list_folder(path, ending, names)
      character(*), intent(in) :: path
      character(*), intent(in) :: ending
      type(text_type), allocatable, intent(out) :: names(:)
      type(dirent_type), pointer :: entry
      type(c_ptr) :: folder, next
      character(:), allocatable :: name
      integer(c_int) :: status
      integer :: length
      allocate (names(0))
      folder = c_opendir(c_text(path))
      if (.not. c_associated(folder)) return
      do
         next = c_readdir(folder)
         if (.not. c_associated(next)) exit
         call c_f_pointer(next, entry)
         length = findloc(entry%name, c_null_char, dim=1) - 1
         name = transfer(entry%name(:length), repeat(' ', length))
         if (len(name) <= len(ending)) cycle
         if (name(len(name) - len(ending) + 1:) == ending) call append_text(names, name)
      end do
      status = c_closedir(folder)
      if (status /= 0) return       ! what was read is there
   end subroutine list_folder

   !> Removes a folder that is empty; nothing happens to any other.
   subroutine remove_empty_folder(path)
      character(*), intent(in) :: path
      integer(c_int) :: status
      status = c_rmdir(c_text(path))
      if (status /= 0) return
   end subroutine remove_empty_folder
end module dg_folder
