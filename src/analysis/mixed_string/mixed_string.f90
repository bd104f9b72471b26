!> The mixed model (Ma & Han 1996): stiff where stiffness or curvature matters, soft elsewhere, as a result like any
!> other model's.
!>
!> The string is stiff around a change of curvature (dg_curvature_change)
!> - where the string is stiffer than its uppermost component (the bottom-hole assembly), or
!> - where the wall forces the bend, E I |dk| > 2 |T| c, or
!> - where the curvature changes by more than 15 deg/30 m.
!> Elsewhere it is soft. Each stiff part reaches 20 bending lengths to both sides of its change. Moment and shear of the bend
!> have died out to 2e-9 there, so that only axial force and torque are passed on at the joins. Valid where the rigid model is.
!>
!> With `mixed_parts = 'elements'`, the string next to the bit is finite elements instead (dg_assembly_elements). They include
!> stabilizers, clearances and the bit's side force, which strings on the axis neglect.
module dg_mixed_string
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_assembly_elements, only: matters, solve_with_elements
   use dg_case_result, only: case_result_type
   use dg_clock, only: seconds_between
   use dg_component, only: bending_stiffness
   use dg_curvature_change, only: change_type, curvature_changes
   use dg_error, only: error_type
   use dg_finite_result, only: finish_result
   use dg_job, only: model_mixed
   use dg_model, only: model_type, string_index
   use dg_rigid_string, only: solve_at_changes
   use dg_soft_string, only: check_string_case
   use dg_stopping, only: stop_type
   implicit none
   private
   public :: solve_mixed_string

contains

   !> Solve a load case with the mixed string. Statuses and refusals are those of the soft string.
   subroutine solve_mixed_string(model, case_index, result, error, stop)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(stop_type), intent(in), optional :: stop
      type(change_type), allocatable :: changes(:)
      integer(int64) :: start, finish
      real(wp) :: pipe
      call system_clock(start)
      call check_string_case(model, case_index, error)
      if (allocated(error)) return
      if (model%numerics%mixed_elements) then
         call solve_with_elements(model, case_index, result, error, stop)
         call close_result()
         return
      end if
      call curvature_changes(model, case_index, changes)
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         pipe = bending_stiffness(string%components(size(string%components)))
      end associate
      call solve_at_changes(model, case_index, pack(changes, matters(changes, pipe)), result)
      call close_result()
   contains
      subroutine close_result()
         result%model = model_mixed
         call finish_result(result)
         call system_clock(finish)
         result%seconds = seconds_between(start, finish)
      end subroutine close_result
   end subroutine solve_mixed_string
end module dg_mixed_string
