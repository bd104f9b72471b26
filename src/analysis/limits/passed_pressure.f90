!> Limits by pressure that a load case passes, whatever its axial force. They can be judged without a solution.
module dg_passed_pressure
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type
   use dg_design_factors, only: design_factors_type
   use dg_job, only: model_soft
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_profile_rows, only: lay_rows
   use dg_soft_string, only: set_profile
   use dg_string_piece, only: breakpoints
   use dg_utilisation, only: as_much, find_utilisation, limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse, &
                             utilisation_type
   implicit none
   private
   public :: find_passed_pressure

   integer, parameter :: by_pressure(4) = [limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse]

contains

   !> Find the limit that is exceeded most. Axial force counts as zero. The compression of a locked-up string would not reduce
   !> burst and collapse as they are judged.
   pure subroutine find_passed_pressure(model, case_index, design, limit, load, allowed, checked)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(design_factors_type), intent(in) :: design
      integer, intent(out) :: limit              !< number of dg_utilisation; 0: none is exceeded
      real(wp), intent(out) :: load, allowed     !< difference of pressures there, and the allowed one [Pa]
      logical, intent(out) :: checked            !< true if a strength against pressure is known
      type(case_result_type) :: still
      type(along_string_type) :: along
      type(utilisation_type) :: utilisation
      real(wp), allocatable :: breaks(:), md(:), none(:)
      integer, allocatable :: from(:), side(:)
      integer :: i
      allocate (breaks, source=breakpoints(model, case_index))
      call lay_rows(model, case_index, breaks, from, side)
      allocate (md, source=breaks(from))
      allocate (none(size(md)), source=0.0_wp)
      still%case_index = case_index
      still%model = model_soft
      call set_profile(model, case_index, md, side, none, none, spread(none, 1, 3), still)
      call find_along_string(model, still, along)
      call find_utilisation(model, still, along, design, optional_real(), utilisation)
      limit = 0
      load = 0.0_wp
      allowed = 0.0_wp
      associate (used => utilisation%used(by_pressure))
         checked = any(used%present)
         i = maxloc(used%value, dim=1, mask=used%present)
         if (i == 0) return
         if (.not. used(i)%value > 1.0_wp + as_much) return
         limit = by_pressure(i)
         load = utilisation%load(limit)
         allowed = load/used(i)%value
      end associate
   end subroutine find_passed_pressure
end module dg_passed_pressure
