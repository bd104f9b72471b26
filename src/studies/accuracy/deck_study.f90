!> The group &study of a deck: what is compared, in which load cases.
module dg_deck_study
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, places_of, reals_of
   use dg_deck_draft, only: draft_type, read_cases
   use dg_error, only: error_list_type
   use dg_job, only: model_name
   use dg_numerics, only: fidelity_name, gap_location_name, solver_name
   use dg_study_plan, only: most_solutions, most_variants, study_plan_type
   use dg_text, only: to_text
   implicit none
   private
   public :: read_study

contains

   !> Read the plan of the deck's study; not allocated without one. Lists that are not given are empty, except that cases are
   !> then all, and models those of the job.
   subroutine read_study(draft, groups, models, plan, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      integer, intent(in) :: models(:)       !< of the job
      type(study_plan_type), allocatable, intent(out) :: plan
      type(error_list_type), intent(inout) :: faults
      integer :: i
      do i = 1, size(groups)
         if (groups(i)%name /= 'study') cycle
         allocate (plan)
         call read_one(draft, groups(i), models, plan, faults)
         return
      end do
   end subroutine read_study

   subroutine read_one(draft, group, models, plan, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: models(:)
      type(study_plan_type), intent(out) :: plan
      type(error_list_type), intent(inout) :: faults
      real(wp) :: solutions
      call read_cases(draft, group, plan%cases, faults)
      plan%models = places_of(group, 'models', model_name)
      if (size(plan%models) == 0) plan%models = models
      plan%element_lengths = without_repeats(reals_of(group, 'element_lengths'))
      plan%tolerances = without_repeats(reals_of(group, 'tolerances'))
      plan%wall_stiffnesses = without_repeats(reals_of(group, 'wall_stiffnesses'))
      plan%gap_locations = places_of(group, 'gap_locations', gap_location_name)
      plan%linear_solvers = places_of(group, 'linear_solvers', solver_name)
      plan%fidelities = places_of(group, 'fidelities', fidelity_name)
      if (.not. all(group%values%sound .or. .not. group%values%given)) return
      solutions = most_variants(plan)*size(plan%cases)
      if (solutions > most_solutions) then
         call group_fault(group, '', to_text(solutions)// &
            ' solutions, every combination of its lists in every case; shorten the lists to '//to_text(most_solutions)// &
            ' or less', faults)
      else if (most_variants(plan) < 1.5_wp) then
         call group_fault(group, '', 'nothing to compare; give two values or more of '// &
            'element_lengths, fidelities, models, tolerances, wall_stiffnesses, gap_locations or linear_solvers', faults)
      end if
   end subroutine read_one

   !> Numbers in their order, each once.
   pure function without_repeats(numbers) result(once)
      real(wp), intent(in) :: numbers(:)
      real(wp), allocatable :: once(:)
      integer :: i
      allocate (once(0))
      do i = 1, size(numbers)
         if (.not. any(abs(once - numbers(i)) <= spacing(numbers(i)))) once = [once, numbers(i)]
      end do
   end function without_repeats
end module dg_deck_study
