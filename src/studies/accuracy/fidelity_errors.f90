!> Errors of a solution at one fidelity against the same load case at fidelity `reference`: one error for each printed quantity.
module dg_fidelity_errors
   use dg_case_result, only: case_result_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_study_comparison, only: compare_lines
   implicit none
   private
   public :: printed_type, new_printed, fidelity_errors, quantity_count, quantity_name

   integer, parameter :: hookload = 1, torque = 2, contact_sum = 3, largest_moment = 4, moment_by_row = 5, side_force = 6, &
                         tilt = 7, von_mises = 8
   integer, parameter :: quantity_count = 8
   !> Names in tables, in the order of the numbers above.
   character(*), parameter :: quantity_name(quantity_count) = [character(16) :: 'hook load', 'torque', 'contact sum', &
      'largest moment', 'moment by row', 'bit side force', 'bit tilt', 'von Mises stress']

   !> The error of the hook load is relative to the larger of the hook load and this part of the weight along the hole [-].
   real(wp), parameter :: weight_share = 0.3_wp
   !> Torque at surface below which it has no error [N.m].
   real(wp), parameter :: least_torque = 100.0_wp
   !> The other errors are relative to the quantity itself, or to these floors where it is less [N, N.m, N, rad, Pa].
   real(wp), parameter :: least_contact = 1.0e3_wp, least_moment = 20.0_wp, least_side_force = 500.0_wp, &
                          least_tilt = 3.5e-4_wp, least_stress = 1.0e6_wp

   !> The printed quantities of one solution.
   type :: printed_type
      real(wp) :: hookload = 0.0_wp         !< [N]
      real(wp) :: weight = 0.0_wp           !< buoyed weight along the hole [N]
      real(wp) :: torque = 0.0_wp           !< at surface [N.m]
      real(wp) :: contact_sum = 0.0_wp      !< sum of contact forces [N]
      real(wp) :: side_force = missing      !< of the bit on the formation [N]; missing if the bit is not held
      real(wp) :: tilt = missing            !< of the bit against the hole [rad]
      real(wp) :: von_mises = 0.0_wp        !< largest stress [Pa]
      real(wp), allocatable :: md(:)        !< depths of the rows [m]
      real(wp), allocatable :: moments(:)   !< bending moments at the rows [N.m]
   end type printed_type

contains

   !> The printed quantities of a converged result. SI units.
   pure subroutine new_printed(result, wob, stress, printed)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: wob      !< weight on bit [N]
      real(wp), intent(in) :: stress   !< largest von Mises stress [Pa]
      type(printed_type), intent(out) :: printed
      printed%hookload = result%hookload
      printed%weight = result%hookload + result%friction + wob
      printed%torque = result%torque
      printed%contact_sum = result%normal_force
      printed%side_force = result%bit_side_force
      printed%tilt = result%bit_tilt
      printed%von_mises = stress
      printed%md = result%profile%md
      printed%moments = result%profile%bending
   end subroutine new_printed

   !> Relative error of each quantity [-], in the order of quantity_name. Missing where the reference has no such quantity.
   pure function fidelity_errors(printed, reference) result(errors)
      type(printed_type), intent(in) :: printed, reference
      real(wp) :: errors(quantity_count)
      real(wp) :: largest, rms, moment
      errors = missing
      errors(hookload) = relative_error(printed%hookload, reference%hookload, weight_share*abs(reference%weight))
      if (abs(reference%torque) >= least_torque) errors(torque) = relative_error(printed%torque, reference%torque, least_torque)
      errors(contact_sum) = relative_error(printed%contact_sum, reference%contact_sum, least_contact)
      moment = maxval(reference%moments)
      errors(largest_moment) = relative_error(maxval(printed%moments), moment, least_moment)
      call compare_lines(printed%md, printed%moments, reference%md, reference%moments, largest, rms)
      errors(moment_by_row) = largest/max(moment, least_moment)
      errors(side_force) = relative_error(printed%side_force, reference%side_force, least_side_force)
      errors(tilt) = relative_error(printed%tilt, reference%tilt, least_tilt)
      errors(von_mises) = relative_error(printed%von_mises, reference%von_mises, least_stress)
   end function fidelity_errors

   !> |value - reference| over |reference|, or over the floor if that is larger [-]; missing if either is missing.
   pure function relative_error(value, reference, floor) result(error)
      real(wp), intent(in) :: value, reference, floor
      real(wp) :: error
      error = missing
      if (is_missing(value) .or. is_missing(reference)) return
      error = abs(value - reference)/max(abs(reference), floor, tiny(1.0_wp))
   end function relative_error
end module dg_fidelity_errors
