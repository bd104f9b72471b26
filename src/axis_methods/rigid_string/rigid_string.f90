!> The rigid model (stiff string that follows the hole) of a load case, with a result like any other model's.
!>
!> Valid if the string follows the hole. Bends must leave clearance, and compression must be below helical buckling. `message`
!> says where a case leaves that range.
module dg_rigid_string
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_clock, only: seconds_between
   use dg_curvature_change, only: change_type, curvature_changes
   use dg_error, only: error_type
   use dg_finite_result, only: finish_result
   use dg_job, only: model_rigid
   use dg_model, only: model_type
   use dg_rigid_string_loads, only: rigid_string_at
   use dg_profile_rows, only: lay_rows
   use dg_soft_string, only: check_string_case, subdivided, set_profile, set_totals
   use dg_soft_string_loads, only: soft_totals_type
   use dg_string_piece, only: breakpoints
   implicit none
   private
   public :: solve_rigid_string, solve_at_changes

contains

   !> Solve a load case with the stiff string, stiff everywhere. Statuses and refusals are those of the soft string.
   subroutine solve_rigid_string(model, case_index, result, error)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(change_type), allocatable :: changes(:)
      integer(int64) :: start, finish
      call system_clock(start)
      call check_string_case(model, case_index, error)
      if (allocated(error)) return
      call curvature_changes(model, case_index, changes)
      call solve_at_changes(model, case_index, changes, result)
      result%model = model_rigid
      call system_clock(finish)
      result%seconds = seconds_between(start, finish)
   end subroutine solve_rigid_string

   !> Solve a load case that has passed check_string_case with a string that is stiff at some changes of curvature.
   subroutine solve_at_changes(model, case_index, changes, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(change_type), intent(in) :: changes(:)
      type(case_result_type), intent(out) :: result
      real(wp), allocatable :: md(:), axial(:), torque(:), contact(:, :), across(:, :)
      integer, allocatable :: from(:), side(:)
      type(soft_totals_type) :: totals
      md = subdivided(breakpoints(model, case_index), model%numerics%element_length)
      call lay_rows(model, case_index, md, from, side)
      md = md(from)
      allocate (axial(size(md)), torque(size(md)), contact(3, size(md)), across(2, size(md)))
      call rigid_string_at(model, case_index, changes, md, axial, torque, contact, across, totals)
      call set_totals(model, case_index, md, axial, torque, totals, result)
      call set_profile(model, case_index, md, side, axial, torque, contact, result)
      result%profile%bending = across(1, :)
      result%profile%shear = across(2, :)
      call finish_result(result)
   end subroutine solve_at_changes
end module dg_rigid_string
