!> Makes the model of a draft that is without fault.
module dg_deck_model
   use dg_deck_draft, only: draft_type, lowest_of, sections_of
   use dg_deck_fluid, only: place_fluids
   use dg_drillstring, only: drillstring_type
   use dg_error, only: error_type
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_model, only: model_type
   use dg_trajectory, only: new_trajectory
   implicit none
   private
   public :: build_model

contains

   !> Builds the model. Faults left to find are a path that the stations do not allow, and what fluids need the path for.
   subroutine build_model(draft, model, faults)
      type(draft_type), intent(in) :: draft
      type(model_type), intent(out) :: model
      type(fault_list_type), intent(inout) :: faults
      type(error_type), allocatable :: error
      integer :: i

      call new_trajectory(model%trajectory, draft%stations%md, draft%stations%inclination, draft%stations%azimuth, &
                          draft%interpolation, error)
      if (allocated(error)) then
         call add_fault(faults, draft%path, draft%trajectory_line, 'group &trajectory: '//error%message)
         return
      end if
      if (allocated(draft%path_notes)) model%path_notes = draft%path_notes
      model%holes = sections_of(draft)
      allocate (model%cases(size(draft%cases)))
      do i = 1, size(draft%cases)
         model%cases(i) = draft%cases(i)%load_case
      end do
      call build_strings(draft, model%strings)
      model%boundary = draft%boundary
      model%numerics = draft%numerics
      model%rig = draft%rig
      call place_fluids(draft, model%trajectory, model%mud, faults)
      model%gravity = draft%gravity
      model%units = draft%units
   end subroutine build_model

   !> Components of one name make one string, in the deck's order.
   pure subroutine build_strings(draft, strings)
      type(draft_type), intent(in) :: draft
      type(drillstring_type), allocatable, intent(out) :: strings(:)
      integer :: lowest(size(draft%components)), i, k, n
      integer, allocatable :: parts(:)
      lowest = lowest_of(draft)
      allocate (strings(count(lowest == [(i, i=1, size(lowest))])))
      n = 0
      do i = 1, size(lowest)
         if (lowest(i) < i) cycle
         n = n + 1
         strings(n)%name = draft%components(i)%string
         parts = pack([(k, k=1, size(lowest))], lowest == i)
         allocate (strings(n)%components(size(parts)))
         do k = 1, size(parts)
            strings(n)%components(k) = draft%components(parts(k))%component
         end do
      end do
   end subroutine build_strings
end module dg_deck_model
