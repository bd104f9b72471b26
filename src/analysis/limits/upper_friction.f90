!> Friction at the upper end of the 95 % interval of what a load case takes of it.
!>
!> A calibration finds the friction of two hole sections from sums of both: one may be larger where the other is smaller. All of
!> them at the upper ends of their own intervals would be less likely than 1 in 20. With correlations R and half widths h the
!> interval of the sum g.f of frictions f is sqrt(g H R H g), H = diag(h), and f moves by H R H g over that.
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

   !> Change of friction by which the soft string's loads are differenced [-].
   real(wp), parameter :: change = 1.0e-3_wp

contains

   !> Sections of the hole with the friction that takes most of a load case. A study whose correlations are not known has all of
   !> its sections at their own upper ends.
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

   !> Load at the top that a unit of each section's friction takes, by the soft string: hook load, or torque of a string that only
   !> turns [N or N.m].
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

      !> Of a model.
      pure function load_of(any_model) result(at_top)
         type(model_type), intent(in) :: any_model
         real(wp) :: at_top
         real(wp) :: axial(1), torque(1)
         call soft_string_at(any_model, case_index, [top_md(any_model%trajectory)], axial, torque)
         at_top = torque(1)
         if (moves_axially(any_model%cases(case_index)%operation)) at_top = axial(1)
      end function load_of
   end subroutine find_taken

   !> Shifts of all sections that raise what they take together by its own half width. As they were where they take nothing.
   pure subroutine move_together(estimate, taken, shifts)
      type(friction_estimate_type), intent(in) :: estimate
      real(wp), intent(in) :: taken(:)          !< by a unit of friction
      real(wp), intent(inout) :: shifts(:)      !< in: half widths [-]
      real(wp) :: moved(size(taken)), variance
      moved = shifts*matmul(estimate%correlation, shifts*taken)
      variance = dot_product(taken, moved)
      if (.not. variance > 0.0_wp) return
      shifts = moved/sqrt(variance)
   end subroutine move_together
end module dg_upper_friction
