!> Standard output, through C's buffer. gfortran's run-time library (12) does not report a failed write, neither when its own
!> buffer is written nor by `flush`. C's library does.
module dg_standard_output
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_long, c_null_ptr, c_ptr, c_short, c_size_t
   use dg_c_calls, only: c_dlsym, c_fopen
   use dg_file_identity, only: identity_of_open, identity_type
   use dg_signal_handler, only: ignore_signal
   use dg_text, only: c_text
   implicit none
   private
   public :: guard_descriptors, write_line, flush_output, output_failed

   !> Descriptors of standard input, output and error (POSIX).
   integer(c_int), parameter :: standard_descriptors(3) = [0_c_int, 1_c_int, 2_c_int]
   character(*), parameter :: nowhere = '/dev/null'
   !> Writing to a pipe that nobody reads (POSIX).
   integer(c_int), parameter :: broken_pipe = 13_c_int
   !> Event of poll for a pipe without a reader (POSIX, number of Linux).
   integer(c_short), parameter :: no_reader = 8_c_short

   !> Descriptor for poll, with events asked for and events found.
   type, bind(c) :: polled_type
      integer(c_int) :: descriptor = 1_c_int
      integer(c_short) :: asked = 0_c_short, told = 0_c_short
   end type polled_type

   interface
      function c_fwrite(text, size, count, file) result(written) bind(c, name='fwrite')
         import :: c_char, c_ptr, c_size_t
         implicit none
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: size, count
         type(c_ptr), value :: file
         integer(c_size_t) :: written
      end function c_fwrite

      function c_fflush(file) result(status) bind(c, name='fflush')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: file
         integer(c_int) :: status
      end function c_fflush

      function c_poll(polled, number, wait) result(found) bind(c, name='poll')
         import :: c_int, c_long, polled_type
         implicit none
         type(polled_type), intent(inout) :: polled
         integer(c_long), value :: number
         integer(c_int), value :: wait
         integer(c_int) :: found
      end function c_poll

      function c_ferror(file) result(status) bind(c, name='ferror')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: file
         integer(c_int) :: status
      end function c_ferror
   end interface

contains

   !> Call this before any file is opened. Standard descriptors that were closed before the program started are taken.
   !> Otherwise the next file of results would get the number, and printed text would go into it. Printing then fails, and is
   !> reported. A reader who goes away does not end the program.
   subroutine guard_descriptors()
      type(identity_type) :: found
      type(c_ptr) :: file
      integer :: i
      do i = 1, size(standard_descriptors)
         found = identity_of_open(standard_descriptors(i))
         if (found%exists) cycle
         ! the lowest number that is free; for reading only, so that writing to standard output fails
         file = c_fopen(c_text(nowhere), c_text(merge('w', 'r', i == size(standard_descriptors))))
         if (.not. c_associated(file)) return
      end do
      call ignore_signal(broken_pipe)
   end subroutine guard_descriptors

   !> Write one line; output_failed tells whether it could be written.
   subroutine write_line(line)
      character(*), intent(in) :: line
      character(:), allocatable :: whole
      integer(c_size_t) :: written
      type(c_ptr) :: stream
      stream = standard_stream()
      if (.not. c_associated(stream)) return
      whole = line//new_line('a')
      written = c_fwrite(whole, 1_c_size_t, int(len(whole), c_size_t), stream)
      if (written < len(whole)) return      ! the stream keeps that in mind
   end subroutine write_line

   !> Write all waiting output.
   subroutine flush_output()
      integer(c_int) :: status
      type(c_ptr) :: stream
      stream = standard_stream()
      if (.not. c_associated(stream)) return
      status = c_fflush(stream)
      if (status /= 0) return               ! as above
   end subroutine flush_output

   !> True where anything that was put could not be written (full disk, closed). A reader who has gone, as `head` does, wants no
   !> more.
   function output_failed() result(failed)
      logical :: failed
      type(c_ptr) :: stream
      call flush_output()
      stream = standard_stream()
      failed = .not. c_associated(stream)
      if (.not. failed) failed = c_ferror(stream) /= 0_c_int
      if (failed) failed = .not. reader_has_gone()
   end function output_failed

   !> True where standard output is a pipe whose reader has ended.
   function reader_has_gone() result(gone)
      logical :: gone
      type(polled_type) :: polled
      gone = c_poll(polled, 1_c_long, 0_c_int) > 0_c_int
      if (gone) gone = iand(polled%told, no_reader) /= 0_c_short
   end function reader_has_gone

   !> C's own stream, with its buffer and its note of what failed. It is a variable of C, and a Fortran variable bound to that
   !> name would be another one.
   function standard_stream() result(stream)
      type(c_ptr) :: stream
      type(c_ptr), pointer :: variable
      type(c_ptr) :: address
      stream = c_null_ptr
      address = c_dlsym(c_null_ptr, c_text('stdout'))
      if (.not. c_associated(address)) return
      call c_f_pointer(address, variable)
      stream = variable
   end function standard_stream
end module dg_standard_output
