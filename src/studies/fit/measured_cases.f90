!> Common parts of a deck's groups that fit measurements: their load cases and models.
module dg_measured_cases
   use dg_checked_group, only: checked_group_type, group_fault, is_given, line_of, places_of, texts_of
   use dg_deck_draft, only: draft_type, find_case
   use dg_error, only: error_list_type
   use dg_job, only: model_name, model_soft
   use dg_model, only: hold_free
   use dg_text, only: quoted, text_type, to_text
   implicit none
   private
   public :: list_measured_cases, list_models

contains

   !> Models, each once; the soft string where none is named.
   subroutine list_models(group, models)
      type(checked_group_type), intent(in) :: group
      integer, allocatable, intent(out) :: models(:)
      models = places_of(group, 'model', model_name)
      if (size(models) == 0) models = [model_soft]
   end subroutine list_models

   !> Numbers of the load cases named; all with measurements where none is, less those that are left out.
   subroutine list_measured_cases(draft, group, cases, faults, left_out)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, allocatable, intent(out) :: cases(:)
      type(error_list_type), intent(inout) :: faults
      integer, intent(in), optional :: left_out(:)
      type(text_type), allocatable :: wanted(:)
      logical :: measured(size(draft%cases)), held(size(draft%cases))
      integer :: i, k, found
      allocate (wanted, source=texts_of(group, 'cases'))
      do k = 1, size(measured)
         measured(k) = draft%cases(k)%load_case%measured_hookload%present .or. draft%cases(k)%load_case%measured_torque%present
         ! The weight on such a packer follows from friction: a fit does not find it.
         held(k) = draft%boundary%packer_hold /= hold_free .and. draft%cases(k)%length_reference /= ''
      end do
      allocate (cases(0))
      if (.not. is_given(group, 'cases')) then
         if (present(left_out)) measured(left_out) = .false.
         measured = measured .and. .not. held
         cases = pack([(k, k=1, size(measured))], measured)
         if (size(cases) == 0) call group_fault(group, 'cases', &
            'no load case has a measured_hookload or measured_torque to calibrate with', faults)
      end if
      do i = 1, size(wanted)
         call find_case(draft, group%name, line_of(group, 'cases'), wanted(i)%text, found, faults)
         if (found == 0) cycle
         if (.not. measured(found)) then
            if (.not. draft%cases(found)%sound) cycle
            call group_fault(group, 'cases', 'load case '//quoted(wanted(i)%text)//' (line '// &
               to_text(draft%cases(found)%line)// &
               ') has neither measured_hookload nor measured_torque; give one or leave it out', faults)
         else if (held(found)) then
            call group_fault(group, 'cases', 'load case '//quoted(wanted(i)%text)//' (line '// &
               to_text(draft%cases(found)%line)//') is held by its packer, whose load depends on friction; leave it out', faults)
         else if (.not. any(cases == found)) then
            cases = [cases, found]
         end if
      end do
   end subroutine list_measured_cases
end module dg_measured_cases
