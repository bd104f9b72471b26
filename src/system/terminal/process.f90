!> Requests to the operating system: end of the program, and terminals at its output.
!>
!> It ends by _exit: libraries are not asked to tidy up. OpenBLAS would wait for its threads, and one that found no memory for its
!> work space when it began never ends.
module dg_process
   use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int, c_long, c_size_t
   use, intrinsic :: iso_fortran_env, only: error_unit
   use dg_c_calls, only: c_write
   use dg_error, only: status_failure
   use dg_kinds, only: wp
   use dg_process_memory, only: address_room
   use dg_signal_handler, only: set_handler
   use dg_version, only: program_name
   implicit none
   private
   public :: begin_process, end_process, someone_watches, someone_reads

   !> A bad address: number of Linux.
   integer(c_int), parameter :: bad_address = 11_c_int
   !> Descriptors (POSIX).
   integer(c_int), parameter :: standard_output = 1_c_int, standard_error = 2_c_int

   !> Message where a library ended the program. The run-time library has said before what it could not allocate.
   character(*), parameter :: last_word = program_name//': a library has ended the program. If memory or threads are what it '// &
      'lacked: allow more (ulimit -v), use --threads 1, or give a larger element_length or fewer points and samples'//new_line('a')

   interface
      subroutine c_exit_now(status) bind(c, name='_exit')
         import :: c_int
         implicit none
         integer(c_int), value :: status
      end subroutine c_exit_now

      function c_atexit(handler) result(failed) bind(c, name='atexit')
         import :: c_funptr, c_int
         implicit none
         type(c_funptr), value :: handler
         integer(c_int) :: failed
      end function c_atexit

      !> Options of gfortran's run-time library (its manual, "Non-Fortran main program"). The first four are standards with
      !> warnings, allowed standards, pedantry, and tracebacks.
      subroutine gfortran_set_options(number, options) bind(c, name='_gfortran_set_options')
         import :: c_int
         implicit none
         integer(c_int), value :: number
         integer(c_int), intent(in) :: options(*)
      end subroutine gfortran_set_options

      function c_isatty(descriptor) result(is) bind(c, name='isatty')
         import :: c_int
         implicit none
         integer(c_int), value :: descriptor
         integer(c_int) :: is
      end function c_isatty
   end interface

contains

   !> Call this first. If memory is limited, any allocation may fail. The run-time library's message then has no traceback,
   !> which needs memory itself. Libraries that do not check their allocations end by SIGSEGV, which is reported in the same
   !> words.
   subroutine begin_process()
      integer(c_int), parameter :: warned = 66_c_int, allowed = 32767_c_int, plain(4) = [warned, allowed, 0_c_int, 0_c_int]
      type(c_funptr) :: before
      if (c_atexit(c_funloc(say_last_word)) /= 0_c_int) return
      if (.not. address_room() < huge(1.0_wp)) return
      call gfortran_set_options(size(plain, kind=c_int), plain)
      before = set_handler(bad_address, c_funloc(note_bad_address))
   end subroutine begin_process

   !> SIGSEGV.
   subroutine note_bad_address(number) bind(c, name='dg_note_bad_address')
      integer(c_int), value :: number
      if (number == bad_address) call say_last_word()
   end subroutine note_bad_address

   !> Runs when a library ends the program, before libraries tidy up.
   subroutine say_last_word() bind(c, name='dg_say_last_word')
      integer(c_long) :: written
      written = c_write(standard_error, last_word, len(last_word, c_size_t))
      if (written >= 0) call c_exit_now(int(status_failure, c_int))
   end subroutine say_last_word

   !> End the program with an exit status. This is C's _exit instead of STOP. A `stop` with a number prints 'STOP 2' and notes
   !> on floating-point flags to standard error, which is for diagnostics only.
   subroutine end_process(status)
      integer, intent(in) :: status
      flush (error_unit)
      call c_exit_now(int(status, c_int))
   end subroutine end_process

   !> True if standard error is a terminal: only then is progress shown.
   function someone_watches() result(watches)
      logical :: watches
      watches = c_isatty(standard_error) == 1_c_int
   end function someone_watches

   !> True if standard output is a terminal.
   function someone_reads() result(reads)
      logical :: reads
      reads = c_isatty(standard_output) == 1_c_int
   end function someone_reads
end module dg_process
