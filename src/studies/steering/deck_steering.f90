!> The group &steering of a deck: the load cases whose direction of drilling is wanted.
module dg_deck_steering
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, real_of, reals_of, optional_of
   use dg_deck_draft, only: draft_type, read_cases
   use dg_error, only: error_list_type
   use dg_steering, only: steering_type
   use dg_text, only: quoted, to_text
   implicit none
   private
   public :: read_steering_group

contains

   !> Read the deck's &steering; not allocated where the deck has none. All load cases where none is named.
   subroutine read_steering_group(draft, groups, steering, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      type(steering_type), allocatable, intent(out) :: steering
      type(error_list_type), intent(inout) :: faults
      character(15) :: key
      integer :: i, k
      do i = 1, size(groups)
         if (groups(i)%name /= 'steering') cycle
         allocate (steering)
         call read_cases(draft, groups(i), steering%cases, faults)
         allocate (steering%toolfaces, source=reals_of(groups(i), 'toolfaces'))
         steering%length = real_of(groups(i), 'length', steering%length)
         steering%hole_enlargement = real_of(groups(i), 'hole_enlargement', 0.0_wp)
         allocate (steering%measured, source=reals_of(groups(i), 'measured_dogleg'))
         if (all(size(steering%measured) /= [0, 1, size(steering%cases)])) call group_fault(groups(i), 'measured_dogleg', &
            to_text(size(steering%measured))//' values of measured_dogleg for '//to_text(size(steering%cases))// &
            ' cases; needs one, or one per case', faults)
         steering%side_cutting = optional_of(groups(i), 'side_cutting')
         if (.not. draft%boundary%bit_centred) call group_fault(groups(i), '', &
            'the bit is free; its side force needs bit_lateral = ''centred'' in &boundary', faults)
         if (.not. steering%side_cutting%present .and. size(steering%measured) == 0) return
         key = merge('side_cutting   ', 'measured_dogleg', steering%side_cutting%present)
         do k = 1, size(steering%cases)
            associate (case => draft%cases(steering%cases(k)))
               if (.not. case%sound .or. case%load_case%wob > 0.0_wp) cycle
               call group_fault(groups(i), trim(key), trim(key)//' needs weight on bit, and load case '// &
                  quoted(case%load_case%name)//' (line '//to_text(case%line)//') has no wob > 0; give wob > 0 or no '//trim(key), &
                  faults)
            end associate
         end do
         return
      end do
   end subroutine read_steering_group
end module dg_deck_steering
