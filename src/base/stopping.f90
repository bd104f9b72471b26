!> A question that long work asks now and then: is it to stop?
module dg_stopping
   implicit none
   private
   public :: stop_type, watch_type, is_stopped, stop_reason

   !> Watch over long work: told of every iteration, by the thread that does it.
   type, abstract :: watch_type
   contains
      procedure(tick_interface), deferred :: tick
   end type watch_type

   !> Who asks for work hands over the procedures that answer. By default it goes on to its end.
   type :: stop_type
      procedure(asked_interface), pointer, nopass :: asked => null()
      procedure(reason_interface), pointer, nopass :: reason => null()
      class(watch_type), pointer :: watch => null()     !< null: nobody watches
   end type stop_type

   abstract interface
      !> One iteration more is done.
      subroutine tick_interface(self)
         import :: watch_type
         implicit none
         class(watch_type), intent(in) :: self
      end subroutine tick_interface

      !> True if work is to stop; called by several threads, and often.
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

   !> True if work is to stop. Reports to the watch that the work continues.
   function is_stopped(stop) result(is)
      type(stop_type), intent(in) :: stop
      logical :: is
      is = .false.
      if (associated(stop%watch)) call stop%watch%tick()
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
