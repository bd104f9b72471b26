!> Read &centralizer and put centralizers on the components that they name.
module dg_deck_centralizer
   use dg_kinds, only: wp
   use dg_centralizer, only: centralizer_type
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, is_whole, line_of, real_of, text_of
   use dg_deck_draft, only: draft_component_type, draft_type
   use dg_error, only: error_list_type, key_of, whole_message
   use dg_missing, only: missing
   use dg_string_check, only: check_centralizer
   use dg_text, only: name_shown, quoted, suggestion, to_text
   implicit none
   private
   public :: read_centralizers

contains

   !> All groups &centralizer; the draft has its components.
   subroutine read_centralizers(groups, draft, faults)
      type(checked_group_type), intent(in) :: groups(:)
      type(draft_type), intent(inout) :: draft
      type(error_list_type), intent(inout) :: faults
      !> Keys without effect on a rigid centralizer.
      character(*), parameter :: of_bows(3) = [character(15) :: 'restoring_force', 'running_force', 'rated_hole']
      type(centralizer_type) :: centralizer
      logical :: meant(size(draft%components))    ! by a group
      character(:), allocatable :: name, string
      integer :: i, k, before
      do i = 1, size(groups)
         if (groups(i)%name /= 'centralizer') cycle
         associate (group => groups(i))
            before = faults%noted
            call draft_centralizer(group, centralizer)
            if (.not. is_whole(group)) cycle
            name = text_of(group, 'component', '')
            string = text_of(group, 'string', 'main')
            do k = 1, size(meant)
               meant(k) = draft%components(k)%component%name == name .and. draft%components(k)%string == string
            end do
            if (.not. any(meant)) call report_unknown(draft, group, faults)
            if (centralizer%bow .and. .not. is_given(group, 'restoring_force')) &
               call group_fault(group, 'kind', "kind = 'bow' needs restoring_force", faults)
            do k = 1, size(of_bows)
               if (.not. centralizer%bow .and. is_given(group, trim(of_bows(k)))) call group_fault(group, trim(of_bows(k)), &
                  trim(of_bows(k))//" has no meaning with kind = 'rigid'; leave it out, or give kind = 'bow'", faults)
            end do
            do k = 1, size(meant)
               if (.not. (meant(k) .and. draft%components(k)%sound) .or. faults%noted > before) cycle
               call check_on(draft%components(k))
               draft%components(k)%component%centralizer = centralizer
               if (.not. centralizer%bow) draft%components(k)%line_centralizer = line_of(group, 'od')
            end do
         end associate
      end do

   contains

      !> Check that a component has no other centralizers and is thinner.
      subroutine check_on(item)
         type(draft_component_type), intent(in) :: item
         type(error_list_type) :: found
         character(:), allocatable :: words
         integer :: m
         associate (part => item%component)
            if (part%centralizer%present) &
               call group_fault(groups(i), 'component', quoted(part%name)//' has centralizers already; a component takes one '// &
                                'kind, so cut it in two', faults)
         end associate
         call check_centralizer(centralizer, item%component, 0, draft%units, found)
         do m = 1, found%count
            call whole_message(found%items(m), 'line '//to_text(item%line), words)
            call group_fault(groups(i), key_of(found%items(m)), words, faults)
         end do
      end subroutine check_on

   end subroutine read_centralizers

   !> Values of one group.
   subroutine draft_centralizer(group, centralizer)
      type(checked_group_type), intent(in) :: group
      type(centralizer_type), intent(out) :: centralizer
      real(wp) :: friction
      centralizer%present = .true.
      centralizer%bow = text_of(group, 'kind', 'rigid') == 'bow'
      centralizer%od = real_of(group, 'od', 0.0_wp)
      centralizer%spacing = real_of(group, 'spacing', 0.0_wp)
      centralizer%first = real_of(group, 'first', 0.5_wp*centralizer%spacing)
      centralizer%restoring_force = real_of(group, 'restoring_force', 0.0_wp)
      centralizer%rated_hole = real_of(group, 'rated_hole', centralizer%od)
      centralizer%running_force = real_of(group, 'running_force', 0.0_wp)
      friction = real_of(group, 'friction', missing)
      centralizer%friction_axial = real_of(group, 'friction_axial', friction)
      centralizer%friction_rotary = real_of(group, 'friction_rotary', friction)
   end subroutine draft_centralizer

   !> Report a group whose name and string no component has.
   subroutine report_unknown(draft, group, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(error_list_type), intent(inout) :: faults
      character(name_shown) :: names(size(draft%components))
      logical :: mine(size(names))
      character(:), allocatable :: string, advice
      integer :: k
      if (size(names) == 0 .or. .not. (is_sound(group, 'component') .and. is_sound(group, 'string'))) return
      if (.not. all(draft%components%sound)) return     ! one of them may be meant
      string = text_of(group, 'string', 'main')
      do k = 1, size(names)
         names(k) = draft%components(k)%component%name
         mine(k) = draft%components(k)%string == string
      end do
      if (any(mine)) then
         advice = suggestion(text_of(group, 'component', ''), pack(names, mine))
      else
         do k = 1, size(names)
            if (draft%components(k)%component%name == text_of(group, 'component', '')) exit
         end do
         k = min(k, size(names))
         advice = 'no component belongs to that string. Write string = '//quoted(draft%components(k)%string)
      end if
      call group_fault(group, 'component', 'string '//quoted(string)//' has no component '// &
                       quoted(text_of(group, 'component', ''))//'; '//advice, faults)
   end subroutine report_unknown
end module dg_deck_centralizer
