!> steering.csv: where assemblies drill to, one row a load case and toolface.
module dg_steering_file
   use dg_column, only: put, quantity_angle, quantity_curvature, quantity_force, quantity_none, quantity_text, row_type
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_load_case, only: optional_real
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_steering, only: steering_result_type
   implicit none
   private
   public :: steering_row, turn_rate, dogleg_clock

   !> Round-off of an angle of many operations [rad].
   real(wp), parameter :: no_angle = 1.0e-9_wp

contains

   !> A result in the columns of the file. New columns are put at the end only.
   function steering_row(model, result) result(row)
      type(model_type), intent(in) :: model
      type(steering_result_type), intent(in) :: result
      type(row_type) :: row
      call put(row, 'case', quantity_text, 'name of the load case', model%cases(result%case_index)%name)
      call put(row, 'toolface', quantity_angle, 'empty: a straight string, or the mean of a bend that turns', result%toolface)
      call put(row, 'inclination', quantity_angle, 'of the hole at the bit', result%inclination)
      call put(row, 'hole_build', quantity_curvature, 'build rate of the hole at the bit, as the survey has it', result%hole(1))
      call put(row, 'hole_turn', quantity_curvature, 'its change of azimuth', turn_rate(result, result%hole))
      call put(row, 'side_force_high', quantity_force, &
               'of the bit on the formation in that hole, towards the high side; < 0: to the low side', result%side_force(1))
      call put(row, 'side_force_right', quantity_force, 'the same to the right, looking down the hole', result%side_force(2))
      call put(row, 'tilt_high', quantity_angle, 'to which the bit points against that hole, towards the high side', result%tilt(1))
      call put(row, 'tilt_right', quantity_angle, 'the same to the right', result%tilt(2))
      call put(row, 'build', quantity_curvature, &
               'build rate of the equilibrium curvature: the hole goes on so', optional_real(result%found, result%curvature(1)))
      call put(row, 'turn', quantity_curvature, &
               'its change of azimuth, clockwise seen from above', optional_real(result%found, turn_rate(result, result%curvature)))
      call put(row, 'dogleg', quantity_curvature, 'the curvature itself', optional_real(result%found, norm2(result%curvature)))
      call put(row, 'dogleg_clock', quantity_angle, &
               'to which the hole bends, from the high side clockwise looking down the hole', &
               optional_real(result%found, dogleg_clock(result%curvature)))
      call put(row, 'status', quantity_text, &
               'converged, or not_converged: then there is no curvature', merge('converged    ', 'not_converged', result%found))
      call put(row, 'solutions', quantity_none, 'of the string that it took', result%solutions)
      call put(row, 'message', quantity_text, 'why there is none, or why it may be off', result%message)
      call put(row, 'three_point_dogleg', quantity_curvature, &
               'of a stiff bent assembly that touches at bit and two more points', result%three_points)
      call put(row, 'fitted_side_cutting', quantity_none, 'side_cutting that gives the measured dogleg', result%side_cutting)
   end function steering_row

   !> Change of azimuth per length of a hole that curves to the right [rad/m].
   pure function turn_rate(result, curvature) result(rate)
      type(steering_result_type), intent(in) :: result
      real(wp), intent(in) :: curvature(2)
      real(wp) :: rate
      rate = curvature(2)
      if (sin(result%inclination) > 0.0_wp .and. .not. is_missing(rate)) rate = rate/sin(result%inclination)
   end function turn_rate

   !> Clock angle to which a hole curves [rad], 0 to 2 pi.
   pure function dogleg_clock(curvature) result(clock)
      real(wp), intent(in) :: curvature(2)
      real(wp) :: clock
      clock = 0.0_wp
      if (norm2(curvature) > 0.0_wp) clock = modulo(atan2(curvature(2), curvature(1)), 2.0_wp*pi)
      if (2.0_wp*pi - clock < no_angle) clock = 0.0_wp
   end function dogleg_clock
end module dg_steering_file
