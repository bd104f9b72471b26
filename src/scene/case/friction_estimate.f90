!> Estimates of the friction of hole sections besides the deck: found by one study of a run, for use by others.
module dg_friction_estimate
   use dg_kinds, only: wp
   use dg_contact_friction, only: shift_friction
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: load_case_type, moves_axially, rotates
   use dg_missing, only: is_missing
   implicit none
   private
   public :: friction_estimate_type, upper_friction_type, find_upper_friction, has_upper_friction

   type :: friction_estimate_type
      character(:), allocatable :: name              !< of the study
      logical :: applied = .false.                   !< true if the rest of the run uses the coefficients
      logical :: axial = .true., rotary = .true.     !< which coefficients are estimated
      logical :: found = .false.
      real(wp), allocatable :: half_widths(:)        !< half widths of 95 % intervals, one a hole section [-]; missing: not known
      logical :: known = .false.                     !< true if the numbers below are known
      real(wp), allocatable :: deviations(:)         !< standard deviations, one a hole section [-]
      real(wp), allocatable :: correlation(:, :)     !< of two sections [-]
   end type friction_estimate_type

   !> Friction at the upper end of its 95 % interval.
   type :: upper_friction_type
      logical :: axial = .false., rotary = .false.      !< coefficients that a study of the run has found and applied
      logical :: known = .true.                         !< true if their intervals are known
      type(hole_section_type), allocatable :: holes(:)          !< each section at the upper end of its own interval
      type(friction_estimate_type), allocatable :: estimates(:) !< estimates with known intervals
   end type upper_friction_type

contains

   !> Find the upper end, from hole sections with the estimated friction. Others keep their friction.
   pure subroutine find_upper_friction(holes, estimates, upper)
      type(hole_section_type), intent(in) :: holes(:)
      type(friction_estimate_type), intent(in) :: estimates(:)
      type(upper_friction_type), intent(out) :: upper
      integer :: i
      upper%holes = holes
      allocate (upper%estimates(0))
      do i = 1, size(estimates)
         if (.not. (estimates(i)%applied .and. estimates(i)%found)) cycle
         upper%axial = upper%axial .or. estimates(i)%axial
         upper%rotary = upper%rotary .or. estimates(i)%rotary
         upper%known = upper%known .and. .not. any(is_missing(estimates(i)%half_widths))
         if (.not. upper%known) cycle
         upper%estimates = [upper%estimates, estimates(i)]
         call shift_friction(upper%holes, estimates(i)%half_widths, estimates(i)%axial, estimates(i)%rotary)
      end do
   end subroutine find_upper_friction

   !> True if the friction of a load case has been estimated.
   elemental function has_upper_friction(upper, load_case) result(has)
      type(upper_friction_type), intent(in) :: upper
      type(load_case_type), intent(in) :: load_case
      logical :: has
      has = (upper%axial .and. moves_axially(load_case%operation) .and. .not. load_case%friction_axial%present) .or. &
            (upper%rotary .and. rotates(load_case%operation) .and. .not. load_case%friction_rotary%present)
   end function has_upper_friction
end module dg_friction_estimate
