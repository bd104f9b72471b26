!> Load at the lower end of a string that is sealed in the bore of a packer.
!>
!> Lubinski, Althouse & Logan (1962), Helical buckling of tubing sealed in packers, J. Pet. Technol. 14(6), SPE-178-PA.
!> Pressure p_i acts below the seal and in the string, p_o above the seal. The areas are A_p of the bore, A_i and A_o of the
!> string. The true axial force just above the packer is a compression of (A_p - A_i) p_i - (A_p - A_o) p_o. The effective
!> compression there is then A_p (p_i - p_o), for any size of the string. It is a load of the lower end in addition to weight
!> on bit.
module dg_packer
   use dg_kinds, only: wp
   use dg_component, only: tube_area
   use dg_fluid, only: side_inside, side_outside
   use dg_fluid_pressure, only: fluid_column_type, new_fluid_column, pressure_at
   use dg_load_case, only: load_case_type
   use dg_model, only: model_type
   use dg_trajectory, only: true_vertical_depth
   implicit none
   private
   public :: packer_push, end_compression

contains

   !> Effective compression of the lower end by the pressures at a packer, A_p (p_i - p_o) [N]; < 0 pulls. 0 without a packer.
   pure function packer_push(model, load_case) result(push)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp) :: push
      type(fluid_column_type) :: inside, outside
      real(wp) :: tvd
      push = 0.0_wp
      if (.not. model%boundary%packer_bore > 0.0_wp) return
      call new_fluid_column(model, load_case, side_inside, inside)
      call new_fluid_column(model, load_case, side_outside, outside)
      tvd = true_vertical_depth(model%trajectory, load_case%bit_depth)
      push = tube_area(model%boundary%packer_bore, 0.0_wp)*(pressure_at(inside, load_case%bit_depth, tvd) &
                                                            - pressure_at(outside, load_case%bit_depth, tvd))
   end function packer_push

   !> Effective compression of the lower end [N]: weight on bit plus packer_push.
   pure function end_compression(model, load_case) result(compression)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp) :: compression
      compression = load_case%wob + packer_push(model, load_case)
   end function end_compression
end module dg_packer
