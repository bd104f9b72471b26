!> Reads &centralizer and puts centralisers on the components that they name.
module dg_deck_centralizer
   use dg_kinds, only: wp
   use dg_centralizer, only: centralizer_type
   use dg_checked_group, only: checked_group_type, is_given, is_sound, is_whole, line_of, real_of, text_of
   use dg_deck_draft, only: draft_component_type, draft_type
   use dg_fault_list, only: add_fault, fault_list_type
   use dg_missing, only: missing
   use dg_model_fault, only: fault_words, model_faults_type
   use dg_string_check, only: check_centralizer
   use dg_text, only: name_shown, quoted, suggestion, to_text
   implicit none
   private
   public :: take_centralizers

contains

   !> All groups &centralizer; the draft has its components.
   subroutine take_centralizers(groups, draft, faults)
      type(checked_group_type), intent(in) :: groups(:)
      type(draft_type), intent(inout) :: draft
      type(fault_list_type), intent(inout) :: faults
      type(centralizer_type) :: centralizer
      integer :: i, k, before
      logical :: named(size(draft%components))
      do i = 1, size(groups)
         if (groups(i)%name /= 'centralizer') cycle
         associate (group => groups(i))
            before = faults%count
            call draft_centralizer(group, centralizer)
            if (.not. is_whole(group)) cycle
            call find_named(draft, group, named, faults)
            if (centralizer%bow .and. .not. is_given(group, 'restoring_force')) &
               call fault('kind', "kind = 'bow' needs restoring_force")
            if (.not. centralizer%bow) call refuse_bows('restoring_force')
            if (.not. centralizer%bow) call refuse_bows('running_force')
            if (.not. centralizer%bow) call refuse_bows('rated_hole')
            do k = 1, size(named)
               if (.not. named(k) .or. .not. draft%components(k)%sound .or. faults%count > before) cycle
               call check_on(draft%components(k))
               draft%components(k)%component%centralizer = centralizer
               if (.not. centralizer%bow) draft%components(k)%line_centralizer = line_of(group, 'od')
            end do
         end associate
      end do

   contains

      !> A key that says nothing of a rigid centraliser.
      subroutine refuse_bows(key)
         character(*), intent(in) :: key
         if (is_given(groups(i), key)) &
            call fault(key, key//" has no meaning with kind = 'rigid'; leave it out, or give kind = 'bow'")
      end subroutine refuse_bows

      !> Whether a component has no others, and is thinner.
      subroutine check_on(item)
         type(draft_component_type), intent(in) :: item
         type(model_faults_type) :: found
         character(:), allocatable :: words
         integer :: m
         associate (part => item%component)
            if (part%centralizer%present) &
               call fault('component', quoted(part%name)//' has centralisers already; a component takes one kind, so cut it in two')
         end associate
         call check_centralizer(centralizer, item%component, 0, draft%units, found)
         do m = 1, found%count
            call fault_words(found%items(m), 'line '//to_text(item%line), words)
            call fault(trim(found%items(m)%key), words)
         end do
      end subroutine check_on

      subroutine fault(key, message)
         character(*), intent(in) :: key, message
         call add_fault(faults, draft%path, line_of(groups(i), key), 'group &centralizer: '//message)
      end subroutine fault
   end subroutine take_centralizers

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

   !> Components of the name and string that a group names; there must be one.
   subroutine find_named(draft, group, named, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      logical, intent(out) :: named(:)
      type(fault_list_type), intent(inout) :: faults
      character(name_shown) :: names(size(draft%components))
      integer :: k
      do k = 1, size(named)
         names(k) = draft%components(k)%component%name
         named(k) = draft%components(k)%component%name == text_of(group, 'component', '') .and. &
                    draft%components(k)%string == text_of(group, 'string', 'main')
      end do
      if (any(named) .or. size(named) == 0 .or. .not. is_sound(group, 'component')) return
      call add_fault(faults, draft%path, line_of(group, 'component'), 'group &centralizer: string '// &
                     quoted(text_of(group, 'string', 'main'))//' has no component '//quoted(text_of(group, 'component', ''))// &
                     '; '//suggestion(text_of(group, 'component', ''), names))
   end subroutine find_named
end module dg_deck_centralizer
