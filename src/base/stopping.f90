!> A question that long work asks now and then: is it to stop?
module dg_stopping
   implicit none
   private
   public :: stop_type, is_stopped, stop_reason

   !> Who asks for work hands over the procedures that answer. By default it goes on to its end.
   type :: stop_type
      procedure(asked_interface), pointer, nopass :: asked => null()
      procedure(reason_interface), pointer, nopass :: reason => null()
   end type stop_type

   abstract interface
      !> Whether work is to stop; called by several threads, and often.
      function asked_interface() result(is)
         implicit none
         logical :: is
      end function asked_interface

      !> Who has asked for it, in a word.
      function reason_interface() result(name)
         implicit none
         character(:), allocatable :: name
      end function reason_interface
   end interface

contains

   !> Whether work is to stop.
   function is_stopped(stop) result(is)
      type(stop_type), intent(in) :: stop
      logical :: is
      is = .false.
      if (associated(stop%asked)) is = stop%asked()
   end function is_stopped

   !> Who has asked for it; '' where nobody tells.
   function stop_reason(stop) result(name)
      type(stop_type), intent(in) :: stop
      character(:), allocatable :: name
      name = ''
      if (associated(stop%reason)) name = stop%reason()
   end function stop_reason
end module dg_stopping
