!> Progress of load cases on standard error while one of them is solved.
module dg_case_watch
   use dg_progress, only: progress_type, show_cases
   use dg_stopping, only: watch_type
   implicit none
   private
   public :: case_watch_type

   !> Watch over one load case.
   type, extends(watch_type) :: case_watch_type
      type(progress_type), pointer :: progress => null()   !< of all load cases
      logical, pointer :: solved(:) => null()              !< load cases, each with each model
      character(:), allocatable :: what                    !< the case, in words
   contains
      procedure :: tick => show_case
   end type case_watch_type

contains

   !> Show how many cases are solved, and which one is at work. Nothing in the first two seconds of a run.
   subroutine show_case(self)
      class(case_watch_type), intent(in) :: self
      !$omp critical (results_in_order)
      call show_cases(self%progress, count(self%solved), size(self%solved), 'at work on '//self%what)
      !$omp end critical (results_in_order)
   end subroutine show_case
end module dg_case_watch
