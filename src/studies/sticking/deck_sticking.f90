!> The groups &calibrate of a deck that ask for a resistance at a stuck point, or for the free point.
module dg_deck_sticking
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, is_given, named, real_of, text_of, optional_of
   use dg_deck_draft, only: draft_type
   use dg_error, only: error_list_type
   use dg_missing, only: given
   use dg_measured_cases, only: list_measured_cases, list_models
   use dg_rig, only: string_load
   use dg_sticking, only: find_free_point, find_resistance, sticking_name, sticking_type
   use dg_text, only: quoted, to_text
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: read_sticking_groups

   !> Digits of a depth in a message.
   integer, parameter :: depth_digits = 7
   !> Keys that only friction has a use for, and those of one kind alone.
   character(*), parameter :: of_friction(5) = [character(14) :: 'holes', 'separate', 'offset', 'apply', 'predict']
   character(*), parameter :: own_key(2) = [character(14) :: 'sticking_depth', 'stretch']
   !> Load cases times models of one group; each takes some ten solutions.
   integer, parameter :: most_results = 10000

contains

   !> All of a deck, in its order, and the faults of each.
   subroutine read_sticking_groups(draft, groups, stickings, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      type(sticking_type), allocatable, intent(out) :: stickings(:)
      type(error_list_type), intent(inout) :: faults
      integer, allocatable :: mine(:)
      integer :: n
      allocate (mine, source=named(groups, 'calibrate'))
      mine = pack(mine, [(kind_of(groups(mine(n))) > 0, n=1, size(mine))])
      allocate (stickings(size(mine)))
      do n = 1, size(mine)
         call read_one(draft, groups(mine(n)), n, stickings(n), faults)
      end do
   end subroutine read_sticking_groups

   !> Unknown of a &calibrate: a resistance or a free point; 0: friction.
   pure function kind_of(group) result(kind)
      type(checked_group_type), intent(in) :: group
      integer :: kind
      kind = findloc(sticking_name == text_of(group, 'parameter', ''), .true., dim=1)
   end function kind_of

   subroutine read_one(draft, group, number, sticking, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: number
      type(sticking_type), intent(out) :: sticking
      type(error_list_type), intent(inout) :: faults
      integer :: i, kind, other, before
      before = faults%count
      kind = kind_of(group)
      sticking%kind = kind
      sticking%name = text_of(group, 'name', trim(sticking_name(kind))//' '//to_text(number))
      sticking%depth = real_of(group, 'sticking_depth', 0.0_wp)
      sticking%stretch = real_of(group, 'stretch', 0.0_wp)
      sticking%hookload_deviation = optional_of(group, 'hookload_deviation')
      sticking%torque_deviation = optional_of(group, 'torque_deviation')
      do i = 1, size(of_friction)
         call refuse_key(of_friction(i))
      end do
      other = merge(find_free_point, find_resistance, kind == find_resistance)
      call refuse_key(own_key(other))
      if (.not. is_given(group, trim(own_key(kind)))) &
         call group_fault(group, 'parameter', 'parameter = '//quoted(trim(sticking_name(kind)))//' needs '// &
            trim(own_key(kind)), faults)
      call list_models(group, sticking%models)
      call list_measured_cases(draft, group, sticking%cases, faults)
      if (faults%count > before .or. .not. all(group%values%sound .or. .not. group%values%given)) return
      if (size(sticking%cases)*size(sticking%models) > most_results) then
         call group_fault(group, 'cases', to_text(size(sticking%cases)*size(sticking%models))// &
            ' pairs of load case and model; a group has '//'at most '//to_text(most_results)//'; name fewer cases', faults)
         return
      end if
      do i = 1, size(sticking%cases)
         associate (case => draft%cases(sticking%cases(i)))
            if (.not. case%load_case%measured_hookload%present) then
               if (.not. case%sound) cycle
               call group_fault(group, 'cases', 'load case '//quoted(case%load_case%name)//' (line '//to_text(case%line)// &
                  ') has no measured_hookload; give it or leave the case out', faults)
            else if (case%sound .and. string_load(draft%rig, case%load_case%operation, case%load_case%measured_hookload%value) &
                     <= 0.0_wp) then
               call group_fault(group, 'cases', 'load case '//quoted(case%load_case%name)//' (line '//to_text(case%line)// &
                  ') has a measured_hookload that is not larger than block_weight; no weight is left for the string', faults)
            else if (kind == find_resistance .and. case%sound .and. sticking%depth > case%load_case%bit_depth) then
               call group_fault(group, 'sticking_depth', 'sticking_depth = '//shown(sticking%depth)// &
                  ' lies below the bit of load case '//quoted(case%load_case%name)//' at '//shown(case%load_case%bit_depth), &
                  faults)
            end if
         end associate
      end do
      if (faults%count == before .and. kind == find_free_point) call check_pulls(draft, group, sticking, faults)

   contains

      subroutine refuse_key(key)
         character(*), intent(in) :: key
         if (is_given(group, trim(key))) call group_fault(group, trim(key), trim(key)//' has no meaning with parameter = '// &
            quoted(trim(sticking_name(kind)))//'; leave it out', faults)
      end subroutine refuse_key

      function shown(depth) result(text)
         real(wp), intent(in) :: depth
         character(:), allocatable :: text
         text = in_units(draft%units, unit_length, depth, depth_digits)
      end function shown
   end subroutine read_one

   !> Two pulls of one string at one depth in one operation; the smaller one comes first.
   subroutine check_pulls(draft, group, sticking, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(sticking_type), intent(inout) :: sticking
      type(error_list_type), intent(inout) :: faults
      if (.not. all(draft%cases%sound)) return
      if (size(sticking%cases) /= 2) then
         call group_fault(group, 'cases', to_text(size(sticking%cases))// &
            ' load cases; a free point needs two, the string at two pulls', faults)
         return
      end if
      associate (one => draft%cases(sticking%cases(1))%load_case, two => draft%cases(sticking%cases(2))%load_case)
         if (one%string /= two%string .or. one%operation /= two%operation .or. &
             abs(one%bit_depth - two%bit_depth) > 0.0_wp) then
            call group_fault(group, 'cases', 'load cases '//quoted(one%name)//' and '//quoted(two%name)// &
               ' must have the same string, operation and bit_depth', faults)
         else if (abs(one%measured_hookload%value - two%measured_hookload%value) <= 0.0_wp) then
            call group_fault(group, 'cases', 'load cases '//quoted(one%name)//' and '//quoted(two%name)// &
               ' must differ in measured_hookload', faults)
         else if (one%measured_hookload%value > two%measured_hookload%value) then
            sticking%cases = sticking%cases([2, 1])
         end if
      end associate
   end subroutine check_pulls
end module dg_deck_sticking
