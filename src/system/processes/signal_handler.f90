!> Response to a signal: C's `signal`, the one place where it is bound.
module dg_signal_handler
   use, intrinsic :: iso_c_binding, only: c_funptr, c_int, c_intptr_t
   implicit none
   private
   public :: set_handler, ignore_signal, ignored

   !> Handler of a signal that is ignored (SIG_IGN).
   integer(c_intptr_t), parameter :: ignored = 1_c_intptr_t

   interface
      !> Gives a signal its handler; a null pointer for what it does by default. Returns the handler before, or SIG_ERR.
      function set_handler(number, handler) result(before) bind(c, name='signal')
         import :: c_funptr, c_int
         implicit none
         integer(c_int), value :: number
         type(c_funptr), value :: handler
         type(c_funptr) :: before
      end function set_handler
   end interface

contains

   !> Lets a signal pass unheard.
   subroutine ignore_signal(number)
      integer(c_int), intent(in) :: number
      type(c_funptr) :: before
      before = set_handler(number, transfer(ignored, before))
   end subroutine ignore_signal
end module dg_signal_handler
