!> The groups &sweep of a deck: which string over which depths, with what was measured there.
module dg_deck_sweep
   use dg_kinds, only: wp
   use dg_case_check, only: lies_below
   use dg_checked_group, only: checked_group_type, claim_name, group_fault, named, reals_of, texts_of
   use dg_deck_draft, only: draft_type
   use dg_deck_range, only: read_range
   use dg_error, only: error_list_type
   use dg_load_case, only: drills, operation_from_name, operation_name
   use dg_missing, only: given
   use dg_sweep, only: at_operation, measured_type, sweep_type, with_depths
   use dg_text, only: append_text, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: read_sweep_groups

   !> Digits of a depth in a message.
   integer, parameter :: depth_digits = 7

contains

   !> All sweeps of a deck, in its order, and the faults of each. `notes` gets what is legal but unusual.
   subroutine read_sweep_groups(draft, groups, models, sweeps, notes, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      integer, intent(in) :: models(:)             !< of &job
      type(sweep_type), allocatable, intent(out) :: sweeps(:)
      type(text_type), allocatable, intent(inout) :: notes(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: taken(:)
      integer, allocatable :: mine(:)
      integer :: n
      allocate (taken(0))
      allocate (mine, source=named(groups, 'sweep'))
      allocate (sweeps(size(mine)))
      do n = 1, size(mine)
         associate (group => groups(mine(n)))
            call read_range(draft, group, n, models, sweeps(n), faults)
            if (allocated(sweeps(n)%depths)) call read_listed(draft, group, sweeps(n), faults)
            call claim_name(group, 'name', sweeps(n)%name, taken, faults)
            call note_bit_loads(sweeps(n), notes)
         end associate
      end do
   end subroutine read_sweep_groups

   !> Measurements that the group itself lists.
   subroutine read_listed(draft, group, sweep, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(sweep_type), intent(inout) :: sweep
      type(error_list_type), intent(inout) :: faults
      type(measured_type), allocatable :: listed(:)
      type(text_type), allocatable :: operations(:)
      real(wp), allocatable :: depths(:), hookloads(:), torques(:)
      integer :: i, n
      allocate (depths(0), hookloads(0), torques(0), operations(0))
      depths = reals_of(group, 'measured_depths')
      hookloads = reals_of(group, 'measured_hookloads')
      torques = reals_of(group, 'measured_torques')
      operations = texts_of(group, 'measured_operations')
      n = size(depths)
      call check_size('measured_hookloads', size(hookloads), .false.)
      call check_size('measured_torques', size(torques), .false.)
      call check_size('measured_operations', size(operations), .true.)
      if (n == 0) return
      if (size(operations) == 0) call group_fault(group, 'measured_depths', &
         'measured_depths needs measured_operations: what was done then', faults)
      if (max(size(hookloads), size(torques)) == 0) &
         call group_fault(group, 'measured_depths', 'measured_depths needs measured_hookloads or measured_torques', faults)
      if (.not. any(size(operations) == [1, n]) .or. .not. any(size(hookloads) == [0, n]) .or. &
          .not. any(size(torques) == [0, n])) return
      allocate (listed(n))
      associate (last => sweep%depths(size(sweep%depths)))
         where (.not. lies_below(depths, last)) depths = min(depths, last)
      end associate
      do i = 1, n
         listed(i)%name = 'point '//to_text(i)
         listed(i)%bit_depth = depths(i)
         listed(i)%operation = operation_from_name(operations(min(i, size(operations)))%text)
         if (size(hookloads) == n) then
            if (hookloads(i) > 0.0_wp) listed(i)%hookload = given(hookloads(i))
         end if
         if (size(torques) == n) then
            if (torques(i) > 0.0_wp) listed(i)%torque = given(torques(i))
         end if
         if (.not. any(sweep%operations == listed(i)%operation)) then
            call group_fault(group, 'measured_operations', 'measured_operations holds '// &
               trim(operation_name(listed(i)%operation))//', which is not an operation of this sweep', faults)
            return
         end if
         if (depths(i) < sweep%depths(1) .or. depths(i) > sweep%depths(size(sweep%depths))) then
            call group_fault(group, 'measured_depths', 'measured_depths('//to_text(i)//') = '// &
               to_text(depths(i)/draft%units%length, depth_digits)//' lies outside the depths of the sweep, '// &
               to_text(sweep%depths(1)/draft%units%length, depth_digits)//' to '//in_units(draft%units, unit_length, &
               sweep%depths(size(sweep%depths)), depth_digits), faults)
            return
         end if
      end do
      sweep%measured = [sweep%measured, listed]
      sweep%depths = with_depths(sweep%depths, depths)

   contains

      !> As many values as depths, or none, or one for all.
      subroutine check_size(key, found, one_will_do)
         character(*), intent(in) :: key
         integer, intent(in) :: found
         logical, intent(in) :: one_will_do
         if (found == 0 .or. found == n .or. (one_will_do .and. found == 1 .and. n > 0)) return
         call group_fault(group, key, key//' has '//to_text(found)//' values, measured_depths has '//to_text(n), faults)
      end subroutine check_size
   end subroutine read_listed

   !> A load on the bit acts in every operation of a sweep: hardly meant where the string is off bottom.
   subroutine note_bit_loads(sweep, notes)
      type(sweep_type), intent(in) :: sweep
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      if (.not. (allocated(sweep%wob) .and. allocated(sweep%tob))) return
      if (max(size(sweep%wob), size(sweep%tob)) > 1) return     ! each operation has its own
      if (abs(at_operation(sweep%wob, 1)) <= 0.0_wp .and. at_operation(sweep%tob, 1) <= 0.0_wp) return
      do i = 1, size(sweep%operations)
         if (drills(sweep%operations(i))) cycle
         call append_text(notes, 'sweep '//quoted(sweep%name)//': its wob and tob act in '// &
                          trim(operation_name(sweep%operations(i)))//' too; give one for each operation where that is not meant')
         return
      end do
   end subroutine note_bit_loads
end module dg_deck_sweep
