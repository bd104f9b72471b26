!> Requests to end the program: SIGINT (Ctrl-C), SIGTERM (a scheduler), SIGHUP (the terminal has gone). Long work asks now and then
!> and ends in good order, with whole files for what is done. A second signal of the same kind ends the program at once.
module dg_interruption
   use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int, c_null_funptr
   use dg_stopping, only: stop_type
   use dg_signal_handler, only: ignore_signal, ignored, set_handler
   implicit none
   private
   public :: watch_for_signals, is_interrupted, interruption_name, by_signals

   ! Numbers of signal.h (POSIX fixes these three).
   integer(c_int), parameter :: signals(3) = [1_c_int, 2_c_int, 15_c_int]
   character(*), parameter :: signal_name(3) = [character(7) :: 'SIGHUP', 'SIGINT', 'SIGTERM']

   !> A file grows beyond what the shell allows (ulimit -f): number of Linux. Ignored, it is an error of writing like others.
   integer(c_int), parameter :: file_too_large = 25_c_int

   !> The signal that came, 0 for none: C's sig_atomic_t. A signal comes at any moment in any thread and has no argument for a
   !> result. Hence this is the only variable of a module in this program.
   integer(c_int), volatile :: arrived = 0_c_int

contains

   !> From now on signals are noted instead of ending the program. Those that are ignored, as under nohup, stay so.
   subroutine watch_for_signals()
      type(c_funptr) :: before
      integer :: i
      call ignore_signal(file_too_large)
      do i = 1, size(signals)
         before = set_handler(signals(i), c_funloc(note_signal))
         if (transfer(before, ignored) == ignored) before = set_handler(signals(i), before)
      end do
   end subroutine watch_for_signals

   !> Notes a signal, and lets the next of its kind do what it does by default: end the program (SIG_DFL is a null pointer).
   subroutine note_signal(number) bind(c, name='dg_note_signal')
      integer(c_int), value :: number
      type(c_funptr) :: before
      arrived = number
      before = set_handler(number, c_null_funptr)
   end subroutine note_signal

   !> True if a signal has come. Costs a look at one variable.
   function is_interrupted() result(is)
      logical :: is
      is = arrived /= 0_c_int
   end function is_interrupted

   !> For work that asks whether to stop: a signal stops it.
   function by_signals() result(question)
      type(stop_type) :: question
      question%asked => is_interrupted
      question%reason => interruption_name
   end function by_signals

   !> Name of the signal that came, '' where none has.
   function interruption_name() result(name)
      character(:), allocatable :: name
      integer :: i
      name = ''
      do i = 1, size(signals)
         if (arrived == signals(i)) name = trim(signal_name(i))
      end do
   end function interruption_name
end module dg_interruption
