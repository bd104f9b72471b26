!> Why the operating system refused: its own words for the last call that failed in this thread.
module dg_system_reason
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_ptr, c_size_t
   use dg_c_calls, only: c_errno_location, c_fopen, c_fclose
   use dg_text, only: c_text
   implicit none
   private
   public :: system_reason, reason_of_failed_write, words_of, from_c_text

   interface
      function c_strerror(number) result(text) bind(c, name='strerror')
         import :: c_int, c_ptr
         implicit none
         integer(c_int), value :: number
         type(c_ptr) :: text
      end function c_strerror

      function c_strlen(text) result(length) bind(c, name='strlen')
         import :: c_ptr, c_size_t
         implicit none
         type(c_ptr), value :: text
         integer(c_size_t) :: length
      end function c_strlen

      function c_fputs(text, file) result(status) bind(c, name='fputs')
         import :: c_char, c_int, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: text(*)
         type(c_ptr), value :: file
         integer(c_int) :: status
      end function c_fputs
   end interface

   !> Text that a disk on which a file was cut short has no room for either [bytes].
   integer, parameter :: more = 65536

contains

   !> The reason of the last failure; to be asked for at once, before another call.
   function system_reason() result(text)
      character(:), allocatable :: text
      integer(c_int), pointer :: number
      call c_f_pointer(c_errno_location(), number)
      text = words_of(number)
   end function system_reason

   !> Why nothing more can be put to the end of a file: the run-time library notes no reason where a full disk cuts one. '' where
   !> more can be.
   function reason_of_failed_write(path) result(text)
      character(*), intent(in) :: path
      character(:), allocatable :: text
      type(c_ptr) :: file
      integer(c_int) :: written, closed
      text = ''
      file = c_fopen(c_text(path), c_text('a'))
      if (.not. c_associated(file)) then
         text = system_reason()
         return
      end if
      written = c_fputs(c_text(repeat(' ', more)), file)
      if (written < 0) text = system_reason()
      closed = c_fclose(file)
      if (closed /= 0 .and. text == '') text = system_reason()
   end function reason_of_failed_write

   !> Meaning of a number of errno.h, in the system's words.
   function words_of(number) result(text)
      integer(c_int), intent(in) :: number
      character(:), allocatable :: text
      text = from_c_text(c_strerror(number))
   end function words_of

   !> A text of C; '' for a null pointer.
   function from_c_text(words) result(text)
      type(c_ptr), intent(in) :: words
      character(:), allocatable :: text
      character(kind=c_char), pointer :: letters(:)
      text = ''
      if (.not. c_associated(words)) return
      call c_f_pointer(words, letters, [c_strlen(words)])
      text = transfer(letters, repeat(' ', size(letters)))
   end function from_c_text
end module dg_system_reason
