!> The groups &uncertainty of a deck: a range of depths, and what is not known of well, mud and gauges.
module dg_deck_uncertainty
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, integer_of, is_sound, line_of, real_of, text_of
   use dg_deck_draft, only: draft_type
   use dg_deck_sweep, only: take_range
   use dg_fault_list, only: add_fault, fault_list_type
   use dg_sweep, only: point_count
   use dg_text, only: lower_case, quoted, to_text
   use dg_uncertainty, only: uncertainty_type
   implicit none
   private
   public :: take_uncertainties

   !> Most solutions: more is a slip in bit_depth_step or samples.
   integer, parameter :: most_solutions = 5000000

contains

   !> All of a deck, in its order, and the faults of each.
   subroutine take_uncertainties(draft, groups, models, uncertainties, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      integer, intent(in) :: models(:)             !< of &job
      type(uncertainty_type), allocatable, intent(out) :: uncertainties(:)
      type(fault_list_type), intent(inout) :: faults
      integer :: i, j, n
      n = 0
      do i = 1, size(groups)
         if (groups(i)%name == 'uncertainty') n = n + 1
      end do
      allocate (uncertainties(n))
      n = 0
      do i = 1, size(groups)
         if (groups(i)%name /= 'uncertainty') cycle
         n = n + 1
         call take_one(draft, groups(i), n, models, uncertainties(n), faults)
         do j = 1, n - 1
            if (lower_case(uncertainties(j)%range%name) /= lower_case(uncertainties(n)%range%name)) cycle
            call add_fault(faults, draft%path, line_of(groups(i), 'name'), 'group &uncertainty: name '// &
                           quoted(uncertainties(n)%range%name)//' is taken; names must be unique, letter case aside')
         end do
      end do
   end subroutine take_uncertainties

   subroutine take_one(draft, group, number, models, uncertainty, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: number                !< in the deck
      integer, intent(in) :: models(:)
      type(uncertainty_type), intent(out) :: uncertainty
      type(fault_list_type), intent(inout) :: faults
      integer :: before
      before = faults%count
      uncertainty%samples = integer_of(group, 'samples', uncertainty%samples)
      uncertainty%seed = integer_of(group, 'seed', uncertainty%seed)
      uncertainty%friction_deviation = real_of(group, 'friction_deviation', 0.0_wp)
      uncertainty%density_deviation = real_of(group, 'density_deviation', 0.0_wp)
      uncertainty%inclination_deviation = real_of(group, 'inclination_deviation', 0.0_wp)
      uncertainty%azimuth_deviation = real_of(group, 'azimuth_deviation', 0.0_wp)
      uncertainty%hookload_deviation = real_of(group, 'hookload_deviation', 0.0_wp)
      uncertainty%torque_deviation = real_of(group, 'torque_deviation', 0.0_wp)
      uncertainty%systematic_survey = text_of(group, 'survey_errors', '') == 'systematic'
      uncertainty%interpolation = draft%interpolation
      call take_range(draft, group, number, models, uncertainty%range, faults)
      if (faults%count > before .or. .not. all(group%values%sound .or. .not. group%values%given)) return
      if (.not. any([uncertainty%friction_deviation, uncertainty%density_deviation, uncertainty%inclination_deviation, &
                     uncertainty%azimuth_deviation, uncertainty%hookload_deviation, uncertainty%torque_deviation] > 0.0_wp)) &
         call add_fault(faults, draft%path, group%line, 'group &uncertainty: nothing is uncertain; give a friction_deviation, '// &
                        'density_deviation, inclination_deviation, azimuth_deviation, hookload_deviation or torque_deviation')
      if (.not. allocated(uncertainty%range%depths)) return
      if (real(point_count(uncertainty%range), wp)*real(uncertainty%samples, wp) <= real(most_solutions, wp)) return
      call add_fault(faults, draft%path, line_of(group, 'samples'), 'group &uncertainty: '// &
                     to_text(point_count(uncertainty%range))//' points with '//to_text(uncertainty%samples)// &
                     ' samples each are more than '//to_text(most_solutions)//' solutions; lower samples or raise bit_depth_step')
   end subroutine take_one
end module dg_deck_uncertainty
