!> The last step of all models: which results have numbers. A result that is not finite has not converged. Only a converged one has
!> numbers.
module dg_finite_result
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use dg_case_result, only: case_result_type, has_numbers, result_locked_up, result_not_converged, unlike_contact_type
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_profile, only: profile_type
   implicit none
   private
   public :: finish_result

contains

   !> Mark a result with a NaN or an infinity as not converged. Remove the numbers of every result that has not converged or is
   !> locked up. Every model ends with it, so that such a case shows no numbers.
   pure subroutine finish_result(result)
      type(case_result_type), intent(inout) :: result
      if (result%status /= result_locked_up .and. .not. is_finite(result)) then
         result%status = result_not_converged
         result%message = 'Forces grew beyond all numbers: nothing is known of this case'
      end if
      if (.not. has_numbers(result%status)) call clear_numbers(result)
   end subroutine finish_result

   !> Takes away the state of the string. Status, message, hole at the bit, and what tells of the iteration stay: iterations, mesh,
   !> time, history, states and places of the gaps.
   pure subroutine clear_numbers(result)
      type(case_result_type), intent(inout) :: result
      result%profile = profile_type()
      result%hookload = 0.0_wp
      result%weight_indicator = missing
      result%friction = 0.0_wp
      result%torque = 0.0_wp
      result%normal_force = 0.0_wp
      result%stability_margin = missing
      result%coiled = .false.
      result%beam_nodes = 0
      result%moment_error = missing
      result%unlike_contact = unlike_contact_type()
      result%left_out_friction = 0.0_wp
      result%bit_side_force = missing
      result%bit_side_clock = missing
      result%bit_tilt = missing
      result%bit_tilt_clock = missing
      result%sag_correction = missing
      result%sensor_md = missing
      result%shortening = missing
      result%equilibrium_force = 0.0_wp
      result%equilibrium_moment = 0.0_wp
      if (allocated(result%gaps)) result%gaps%force = missing
      if (allocated(result%contacts)) deallocate (result%contacts)
   end subroutine clear_numbers

   !> True if every number of a result is finite: no NaN, no infinity.
   pure function is_finite(result) result(is)
      type(case_result_type), intent(in) :: result
      logical :: is
      real(wp) :: numbers(6)
      numbers = [result%hookload, result%friction, result%torque, result%normal_force, result%equilibrium_force, &
                 result%equilibrium_moment]
      is = all(ieee_is_finite(numbers))
      if (.not. (is .and. allocated(result%profile%md))) return
      associate (profile => result%profile)
         is = all(ieee_is_finite(profile%axial)) .and. all(ieee_is_finite(profile%torque)) .and. &
              all(ieee_is_finite(profile%side_force)) .and. all(ieee_is_finite(profile%bending)) .and. &
              all(ieee_is_finite(profile%displacement)) .and. all(ieee_is_finite(profile%clock)) .and. &
              all(ieee_is_finite(profile%shear))
      end associate
   end function is_finite
end module dg_finite_result
