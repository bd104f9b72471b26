!> Texts on what a verdict leaves open: limits without a rating in the deck, and what may turn a yes.
module dg_unchecked_text
   use dg_kinds, only: wp
   use dg_component, only: component_type, has_bend
   use dg_fatigue_curve, only: fatigue_none
   use dg_model, only: model_type
   use dg_readable, only: first_names
   use dg_text, only: append_text, either, text_type
   use dg_utilisation, only: has_joint_rating, has_rating, joint_ratings, lacks_rating, limit_burst, limit_collapse, &
                             limit_joint_tension, limit_joint_torsion, limit_makeup, limit_tension, limit_torsion, limit_von_mises
   use dg_verdict, only: every_limit_count, limit_bend, limit_code, limit_fatigue, limit_title, verdict_type
   implicit none
   private
   public :: unchecked_text, unchecked_codes, uncertain_codes, components_without_yield

   !> Limits that all need one thing, the yield strength.
   integer, parameter :: by_yield(5) = [limit_von_mises, limit_tension, limit_torsion, limit_burst, limit_collapse]
   !> Limits of connections.
   integer, parameter :: by_joint(7) = [limit_joint_torsion, limit_makeup, joint_ratings]

contains

   !> Names of limits that were not checked. All that need a yield strength have one name, all of connections too if no component
   !> has a rating of them. Components that lack the rating are named if others have it.
   pure function unchecked_text(not_checked, components) result(text)
      logical, intent(in) :: not_checked(:)      !< one for each limit (dg_verdict)
      type(component_type), intent(in) :: components(:)
      character(:), allocatable :: text
      logical :: bare
      integer :: i
      text = ''
      bare = .not. any(has_joint_rating(components))
      if (not_checked(limit_tension)) text = 'pipe strength'//of_unrated(components, limit_tension)//' (no yield)'
      if (bare .and. not_checked(limit_joint_tension)) text = text//either(', ', '', text /= '')// &
         'connections (no make-up torque or rating)'
      do i = 1, every_limit_count
         if (.not. not_checked(i) .or. any(by_yield == i) .or. (bare .and. any(by_joint == i))) cycle
         if (text /= '') text = text//', '
         text = text//trim(limit_title(i))//of_unrated(components, i)
         if (i == limit_fatigue .and. any(components%fatigue%curve /= fatigue_none)) &
            text = text//' (its limit is passed, no '//trim(merge('hours or rpm    ', 'fatigue_exponent', &
                   all(components%fatigue%exponent > 0.0_wp .or. components%fatigue%curve == fatigue_none)))//')'
      end do
   end function unchecked_text

   !> Names of the components without a yield strength, of all strings; '' where none or all lack it.
   pure function components_without_yield(model) result(names)
      type(model_type), intent(in) :: model
      character(:), allocatable :: names
      integer :: i
      names = unrated_names([(model%strings(i)%components, i=1, size(model%strings))], limit_tension)
   end function components_without_yield

   !> ' of NAME, NAME' with the components that a limit is not checked for; '' where it is checked for none.
   pure function of_unrated(components, limit) result(text)
      type(component_type), intent(in) :: components(:)
      integer, intent(in) :: limit
      character(:), allocatable :: text
      text = unrated_names(components, limit)
      if (text /= '') text = ' of '//text
   end function of_unrated

   !> Names of the components that lack a rating, or are bent; '' where all that need a rating lack it.
   pure function unrated_names(components, limit) result(text)
      type(component_type), intent(in) :: components(:)
      integer, intent(in) :: limit
      character(:), allocatable :: text
      integer, parameter :: most_names = 3
      type(text_type), allocatable :: names(:)
      logical :: unchecked(size(components))
      integer :: i
      text = ''
      unchecked = has_bend(components)
      if (limit /= limit_bend) unchecked = lacks_rating(components, limit) .and. any(has_rating(components, limit))
      allocate (names(0))
      do i = 1, size(components)
         if (.not. unchecked(i)) cycle
         if (is_listed(components(i)%name)) cycle      ! of another string
         call append_text(names, components(i)%name)
      end do
      text = first_names(names, most_names)
   contains
      pure function is_listed(name) result(is)
         character(*), intent(in) :: name
         logical :: is
         integer :: k
         is = .false.
         do k = 1, size(names)
            is = is .or. names(k)%text == name
         end do
      end function is_listed
   end function unrated_names

   !> Names of the limits that were not checked as files have them, blanks between them.
   pure function unchecked_codes(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, every_limit_count
         if (.not. verdict%not_checked(i)) cycle
         if (text /= '') text = text//' '
         text = text//trim(limit_code(i))
      end do
   end function unchecked_codes

   !> Codes of the doubts about a yes, as files have them, blanks between.
   pure function uncertain_codes(verdict) result(text)
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      text = either('contact_force', '', verdict%uncertain > 0.0_wp)
      if (verdict%joints_uncertain) text = text//either(' ', '', text /= '')//'tool_joints'
      if (verdict%fatigue_used > 0.0_wp) text = text//either(' ', '', text /= '')//'fatigue'
   end function uncertain_codes
end module dg_unchecked_text
