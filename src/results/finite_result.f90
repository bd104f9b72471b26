!> The guard of all models: a result with a number that is none is no solution.
module dg_finite_result
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use dg_case_result, only: case_result_type, result_not_converged
   use dg_kinds, only: wp
   use dg_profile, only: profile_type
   implicit none
   private
   public :: refuse_runaway

contains

   !> Marks a result that holds a NaN or an infinity as not converged, without numbers to show. Every model ends with it.
   pure subroutine refuse_runaway(result)
      type(case_result_type), intent(inout) :: result
      if (is_finite(result)) return
      call clear(result%profile)
      result%hookload = 0.0_wp
      result%friction = 0.0_wp
      result%torque = 0.0_wp
      result%normal_force = 0.0_wp
      result%status = result_not_converged
      result%message = 'numbers beyond all bounds: the iteration ran away; try shorter elements or more load_steps'
   end subroutine refuse_runaway

   !> Leaves no row: all arrays are deallocated on entry.
   pure subroutine clear(profile)
      type(profile_type), intent(out) :: profile
      if (allocated(profile%md)) deallocate (profile%md)
   end subroutine clear

   !> Whether every number of a result is one: no NaN, no infinity.
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
