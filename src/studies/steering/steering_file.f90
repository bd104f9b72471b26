!> steering.csv: where assemblies drill to, one row a load case and toolface.
module dg_steering_file
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_angle, quantity_curvature, &
                        quantity_force, quantity_none, quantity_text
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_constants, only: pi
   use dg_error, only: error_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_steering_result, only: steering_result_type
   implicit none
   private
   public :: write_steering, turn_rate, dogleg_clock

   !> Round-off of an angle of many operations [rad].
   real(wp), parameter :: no_angle = 1.0e-9_wp

   !> New ones are added at the end only.
   type(column_type), parameter :: steering_columns(18) = [ &
      column_type('case', quantity_text, 'name of the load case'), &
      column_type('toolface', quantity_angle, 'empty: a straight string, or the mean of a bend that turns'), &
      column_type('inclination', quantity_angle, 'of the hole at the bit'), &
      column_type('hole_build', quantity_curvature, 'build rate of the hole at the bit, as the survey has it'), &
      column_type('hole_turn', quantity_curvature, 'its change of azimuth'), &
      column_type('side_force_high', quantity_force, 'of the bit on the formation in that hole, towards the high side; < 0: to '// &
         'the low side'), &
      column_type('side_force_right', quantity_force, 'the same to the right, looking down the hole'), &
      column_type('tilt_high', quantity_angle, 'to which the bit points against that hole, towards the high side'), &
      column_type('tilt_right', quantity_angle, 'the same to the right'), &
      column_type('build', quantity_curvature, 'build rate of the equilibrium curvature: the hole goes on so'), &
      column_type('turn', quantity_curvature, 'its change of azimuth, clockwise seen from above'), &
      column_type('dogleg', quantity_curvature, 'the curvature itself'), &
      column_type('dogleg_clock', quantity_angle, 'to which the hole bends, from the high side clockwise looking down the hole'), &
      column_type('status', quantity_text, 'converged, or not_converged: then there is no curvature'), &
      column_type('solutions', quantity_none, 'of the string that it took'), &
      column_type('message', quantity_text, 'why there is none, or why it may be off'), &
      column_type('three_point_dogleg', quantity_curvature, 'of a stiff bent assembly that touches at bit and two more points'), &
      column_type('fitted_side_cutting', quantity_none, 'side_cutting that gives the measured dogleg')]

contains

   !> Writes steering.csv to `path`, a row a result. Fails where the file cannot be written.
   subroutine write_steering(path, job, model, results, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(steering_result_type), intent(in) :: results(:)
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call begin_table(table, steering_columns, job%units)
      do i = 1, size(results)
         call steering_fields(model, results(i), row)
         call add_row(table, row)
      end do
      call write_table(table, path, error)
   end subroutine write_steering

   subroutine steering_fields(model, result, row)
      type(model_type), intent(in) :: model
      type(steering_result_type), intent(in) :: result
      type(field_list_type), intent(out) :: row
      call put(row, model%cases(result%case_index)%name)
      call put(row, result%toolface)
      call put(row, result%inclination)
      call put(row, result%hole(1))
      call put(row, turn_rate(result, result%hole))
      call put(row, result%side_force(1))
      call put(row, result%side_force(2))
      call put(row, result%tilt(1))
      call put(row, result%tilt(2))
      if (result%found) then
         call put(row, result%curvature(1))
         call put(row, turn_rate(result, result%curvature))
         call put(row, norm2(result%curvature))
         call put(row, dogleg_clock(result%curvature))
         call put(row, 'converged')
      else
         call put_none(row)
         call put_none(row)
         call put_none(row)
         call put_none(row)
         call put(row, 'not_converged')
      end if
      call put(row, result%solutions)
      call put(row, result%message)
      call put(row, result%three_points)
      call put(row, result%side_cutting)
   end subroutine steering_fields

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
