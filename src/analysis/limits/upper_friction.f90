!> Friction at the upper end of the 95 % interval, in the combination that matters for a load case.
!>
!> A calibration finds the friction of two hole sections from sums of both: one may be larger where the other is smaller. All
!> of them at the upper ends of their own intervals would be less likely than 1 in 20. With correlations R, half widths h and
!> H = diag(h), the interval of the sum g.f of frictions f is sqrt(g H R H g). There f changes by H R H g over that interval.
module dg_upper_friction
   use dg_kinds, only: wp
   use dg_contact_friction, only: shift_friction
   use dg_friction_estimate, only: friction_estimate_type, upper_friction_type
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: moves_axially
   use dg_model, only: model_type
   use dg_soft_string_loads, only: soft_string_at
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: raise_friction

   !> Change of friction for the numerical derivative of the soft string's loads [-].
   real(wp), parameter :: change = 1.0e-3_wp

contains

   !> Hole sections with the friction that raises the loads of a case most. A study without known correlations has all of its
   !> sections at their own upper ends.
   pure subroutine raise_friction(model, case_index, upper, holes)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(upper_friction_type), intent(in) :: upper          !< intervals known
      type(hole_section_type), intent(out) :: holes(:)
      real(wp) :: shifts(size(holes)), taken(size(holes))
      integer :: i
      holes = model%holes
      do i = 1, size(upper%estimates)
         associate (estimate => upper%estimates(i))
            shifts = estimate%half_widths
            if (estimate%known) then
               call find_taken(model, case_index, estimate, taken)
               call move_together(estimate, taken, shifts)
            end if
            call shift_friction(holes, shifts, estimate%axial, estimate%rotary)
         end associate
      end do
   end subroutine raise_friction

   !> Absolute change of the load at the top over that of each section's friction, by the soft string. The load is hook load, or
   !> torque of a string that only turns [N or N.m].
   pure subroutine find_taken(model, case_index, estimate, taken)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(friction_estimate_type), intent(in) :: estimate
      real(wp), intent(out) :: taken(:)
      type(model_type) :: changed
      real(wp) :: load
      integer :: i
      load = load_of(model)
      changed = model
      do i = 1, size(taken)
         call shift_friction(changed%holes(i), change, estimate%axial, estimate%rotary)
         taken(i) = abs(load_of(changed) - load)/change
         changed%holes(i) = model%holes(i)
      end do

   contains

      !> Load at the top for a model [N or N.m].
      pure function load_of(any_model) result(at_top)
         type(model_type), intent(in) :: any_model
         real(wp) :: at_top
         real(wp) :: axial(1), torque(1)
         call soft_string_at(any_model, case_index, [top_md(any_model%trajectory)], axial, torque)
         at_top = torque(1)
         if (moves_axially(any_model%cases(case_index)%operation)) at_top = axial(1)
      end function load_of
   end subroutine find_taken

   !> Shifts of all sections that raise their sum of loads by its own half width. Unchanged if they have no load.
   pure subroutine move_together(estimate, taken, shifts)
      type(friction_estimate_type), intent(in) :: estimate
      real(wp), intent(in) :: taken(:)          !< load by a unit of friction [N or N.m]
      real(wp), intent(inout) :: shifts(:)      !< on entry half widths [-]
      real(wp) :: moved(size(taken)), variance
      moved = shifts*matmul(estimate%correlation, shifts*taken)
      variance = dot_product(taken, moved)
      if (.not. variance > 0.0_wp) return
      shifts = moved/sqrt(variance)
   end subroutine move_together
end module dg_upper_friction
