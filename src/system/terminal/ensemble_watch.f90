!> Who is told how far the solution of an ensemble is.
module dg_ensemble_watch
   use dg_kinds, only: wp
   implicit none
   private
   public :: ensemble_watch_type

   !> A program extends it by what it does with the news.
   type, abstract :: ensemble_watch_type
   contains
      procedure(show_interface), deferred :: show
   end type ensemble_watch_type

   abstract interface
      !> Called by one thread at a time, each time that results have come.
      subroutine show_interface(self, share, first_share, what)
         import :: ensemble_watch_type, wp
         implicit none
         class(ensemble_watch_type), intent(inout) :: self
         real(wp), intent(in) :: share        !< of the work that is done [-]
         real(wp), intent(in) :: first_share  !< of it that was done at the start [-]
         character(*), intent(in) :: what     !< how much, in words
      end subroutine show_interface
   end interface
end module dg_ensemble_watch
