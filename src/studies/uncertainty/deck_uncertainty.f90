!> The groups &uncertainty of a deck: a range of depths, and uncertain data of well, mud and gauges.
module dg_deck_uncertainty
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, claim_name, group_fault, integer_of, is_given, is_sound, named, real_of, &
      reals_of, text_of
   use dg_deck_draft, only: draft_type
   use dg_deck_range, only: read_range
   use dg_error, only: error_list_type
   use dg_friction_estimate, only: friction_estimate_type
   use dg_missing, only: missing
   use dg_sweep, only: point_count
   use dg_text, only: lower_case, quoted, to_text, text_type
   use dg_uncertainty, only: correlation_of, friction_factor_of, uncertainty_type
   implicit none
   private
   public :: read_uncertainty_groups

   !> Words of friction_parameter.
   character(*), parameter :: axial_alone = 'friction_axial', rotary_alone = 'friction_rotary'
   !> Most solutions: more is a slip in bit_depth_step or samples.
   integer, parameter :: most_solutions = 5000000

contains

   !> All of a deck, in its order, and the faults of each.
   subroutine read_uncertainty_groups(draft, groups, models, estimates, uncertainties, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      integer, intent(in) :: models(:)             !< of &job
      type(friction_estimate_type), intent(in) :: estimates(:)
      type(uncertainty_type), allocatable, intent(out) :: uncertainties(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: taken(:)
      integer, allocatable :: mine(:)
      integer :: n
      allocate (taken(0))
      allocate (mine, source=named(groups, 'uncertainty'))
      allocate (uncertainties(size(mine)))
      do n = 1, size(mine)
         associate (group => groups(mine(n)))
            call read_one(draft, group, n, models, estimates, uncertainties(n), faults)
            call claim_name(group, 'name', uncertainties(n)%range%name, taken, faults)
         end associate
      end do
   end subroutine read_uncertainty_groups

   subroutine read_one(draft, group, number, models, estimates, uncertainty, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: number                !< in the deck
      integer, intent(in) :: models(:)
      type(friction_estimate_type), intent(in) :: estimates(:)
      type(uncertainty_type), intent(out) :: uncertainty
      type(error_list_type), intent(inout) :: faults
      integer :: before
      before = faults%count
      uncertainty%samples = integer_of(group, 'samples', uncertainty%samples)
      uncertainty%seed = integer_of(group, 'seed', uncertainty%seed)
      call read_friction(draft, group, estimates, uncertainty, faults)
      uncertainty%density_deviation = real_of(group, 'density_deviation', 0.0_wp)
      uncertainty%inclination_deviation = real_of(group, 'inclination_deviation', 0.0_wp)
      uncertainty%azimuth_deviation = real_of(group, 'azimuth_deviation', 0.0_wp)
      uncertainty%hookload_deviation = real_of(group, 'hookload_deviation', 0.0_wp)
      uncertainty%torque_deviation = real_of(group, 'torque_deviation', 0.0_wp)
      uncertainty%systematic_survey = text_of(group, 'survey_errors', '') == 'systematic'
      uncertainty%interpolation = draft%interpolation
      if (draft%tortuous .and. .not. uncertainty%systematic_survey .and. &
          max(uncertainty%inclination_deviation, uncertainty%azimuth_deviation) > 0.0_wp) &
         call group_fault(group, 'survey_errors', 'errors of single stations '// &
            'would bend the hole at each station that &tortuosity adds; give survey_errors = ''systematic''', faults)
      call read_range(draft, group, number, models, uncertainty%range, faults)
      if (faults%count > before .or. .not. all(group%values%sound .or. .not. group%values%given)) return
      if (.not. (allocated(uncertainty%friction_factor) .or. uncertainty%estimate > 0) .and. &
          .not. any([uncertainty%density_deviation, uncertainty%inclination_deviation, &
                     uncertainty%azimuth_deviation, uncertainty%hookload_deviation, uncertainty%torque_deviation] > 0.0_wp)) &
         call group_fault(group, '', 'nothing is uncertain; give a friction_deviation, '// &
            'density_deviation, inclination_deviation, azimuth_deviation, hookload_deviation or torque_deviation', faults)
      if (.not. allocated(uncertainty%range%depths)) return
      if (real(point_count(uncertainty%range), wp)*real(uncertainty%samples, wp) <= real(most_solutions, wp)) return
      call group_fault(group, 'samples', to_text(point_count(uncertainty%range))//' points with '// &
         to_text(uncertainty%samples)//' samples each are more than '//to_text(most_solutions)// &
         ' solutions; lower samples or raise bit_depth_step', faults)
   end subroutine read_one

   !> Read the variation of friction, and its correlation.
   subroutine read_friction(draft, group, estimates, uncertainty, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(friction_estimate_type), intent(in) :: estimates(:)
      type(uncertainty_type), intent(inout) :: uncertainty
      type(error_list_type), intent(inout) :: faults
      real(wp), allocatable :: above(:)
      logical :: regular
      integer :: n
      n = size(draft%holes)
      uncertainty%friction_deviation = real_of(group, 'friction_deviation', 0.0_wp)
      uncertainty%friction_correlation = real_of(group, 'friction_correlation', 1.0_wp)
      uncertainty%axial = text_of(group, 'friction_parameter', '') /= rotary_alone
      uncertainty%rotary = text_of(group, 'friction_parameter', '') /= axial_alone
      if (is_given(group, 'friction_from')) then
         call read_estimate(group, estimates, uncertainty, regular)
         if (.not. regular) call group_fault(group, 'friction_from', 'friction_from = '//quoted(text_of(group, &
            'friction_from', ''))//' is not a &calibrate of this deck with apply = .true.', faults)
         if (any([is_given(group, 'friction'), is_given(group, 'friction_deviation'), is_given(group, 'friction_correlation'), &
                  is_given(group, 'friction_deviations'), is_given(group, 'friction_correlations'), &
                  is_given(group, 'friction_parameter')])) &
            call group_fault(group, 'friction_from', &
               'friction_from says all of friction; leave out the other keys of friction', faults)
         return
      end if
      if (is_given(group, 'friction_deviations') .and. .not. is_sound(group, 'friction_deviations')) return
      if (is_given(group, 'friction_correlations') .and. .not. is_sound(group, 'friction_correlations')) return
      above = reals_of(group, 'friction_correlations')
      if (is_given(group, 'friction_deviations')) then
         uncertainty%friction_deviations = reals_of(group, 'friction_deviations')
         if (is_given(group, 'friction_deviation')) call group_fault(group, 'friction_deviations', &
            'give friction_deviation, or '//'friction_deviations, not both', faults)
         if (size(uncertainty%friction_deviations) /= n) then
            call group_fault(group, 'friction_deviations', to_text(size(uncertainty%friction_deviations))// &
               ' friction_deviations for '//to_text(n)//' hole sections; give one for each', faults)
            return
         end if
      else
         uncertainty%friction_deviations = spread(uncertainty%friction_deviation, 1, n)
      end if
      if (is_given(group, 'friction_correlations')) then
         if (is_given(group, 'friction_correlation')) call group_fault(group, 'friction_correlations', &
            'give friction_correlation, or '//'friction_correlations, not both', faults)
         if (size(above) /= n*(n - 1)/2) then
            call group_fault(group, 'friction_correlations', to_text(size(above))//' friction_correlations; '//to_text(n)// &
               ' hole sections have '//to_text(n*(n - 1)/2)//' pairs', faults)
            return
         end if
      end if
      if (.not. any(uncertainty%friction_deviations > 0.0_wp)) return
      allocate (uncertainty%friction_factor(n, n))
      call friction_factor_of(uncertainty%friction_deviations, correlation_of(n, uncertainty%friction_correlation, above), &
                              uncertainty%friction_factor, regular)
      if (size(above) > 0) uncertainty%friction_correlation = missing
      if (.not. regular) call group_fault(group, 'friction_correlations', &
         'friction_correlations that no numbers can have: their '//'matrix is not positive', faults)
   end subroutine read_friction

   !> Number of the estimate that `friction_from` names, and which coefficients it is of.
   subroutine read_estimate(group, estimates, uncertainty, found)
      type(checked_group_type), intent(in) :: group
      type(friction_estimate_type), intent(in) :: estimates(:)
      type(uncertainty_type), intent(inout) :: uncertainty
      logical, intent(out) :: found
      integer :: i
      found = .false.
      do i = 1, size(estimates)
         if (lower_case(estimates(i)%name) /= lower_case(text_of(group, 'friction_from', ''))) cycle
         found = estimates(i)%applied
         uncertainty%estimate = i
         uncertainty%axial = estimates(i)%axial
         uncertainty%rotary = estimates(i)%rotary
      end do
   end subroutine read_estimate
end module dg_deck_uncertainty
