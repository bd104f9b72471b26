!> Calculated against measured and reference values, and which of friction and moment a load case shows.
module dg_comparison
   use dg_kinds, only: wp
   use dg_load_case, only: given, operation_backream, operation_ream, operation_rotary_drilling, &
      operation_rotate_off_bottom, operation_sliding_drilling, operation_trip_in, operation_trip_out, optional_real
   implicit none
   private
   public :: percent_error, moves_axially, rotates

contains

   !> 100 |calculated - other|/|other| [%]; absent where `other` is absent or zero.
   elemental function percent_error(calculated, other) result(error)
      real(wp), intent(in) :: calculated
      type(optional_real), intent(in) :: other
      type(optional_real) :: error
      if (.not. other%present) return
      if (abs(other%value) <= 0.0_wp) return
      error = given(100.0_wp*abs(calculated - other%value)/abs(other%value))
   end function percent_error

   !> Whether friction acts along the hole, so that Table 1 has a frictional resistance.
   elemental function moves_axially(operation) result(yes)
      integer, intent(in) :: operation
      logical :: yes
      yes = any(operation == [operation_trip_out, operation_trip_in, operation_sliding_drilling, operation_ream, &
                              operation_backream])
   end function moves_axially

   !> Whether the string turns, so that Table 1 has a force moment.
   elemental function rotates(operation) result(yes)
      integer, intent(in) :: operation
      logical :: yes
      yes = any(operation == [operation_rotate_off_bottom, operation_rotary_drilling, operation_ream, operation_backream])
   end function rotates
end module dg_comparison
