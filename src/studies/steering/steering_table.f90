!> Directions of drilling: steering.csv, one row per load case and tool face, and in print. Every printed line fits 120
!> columns.
module dg_steering_table
   use dg_constants, only: degree, pi
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing, optional_real
   use dg_model, only: is_straightened, model_type
   use dg_number_text, only: fixed_text
   use dg_steering, only: steering_result_type
   use dg_text, only: append_text, text_type, to_text
   use dg_text_table, only: add_cell, add_instead, append_table, end_row, text_table_type
   use dg_unit_kind, only: unit_factor, unit_label
   use dg_column, only: add, quantity_angle, quantity_curvature, quantity_force, quantity_none, quantity_text, row_type
   implicit none
   private
   public :: steering_table, steering_row

   integer, parameter :: name_width = 20, width = 11

   !> Round-off of an angle of many operations [rad].
   real(wp), parameter :: no_angle = 1.0e-9_wp

contains

   !> Lines of the table of all results of a deck's &steering.
   function steering_table(job, model, side_cutting, results) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(optional_real), intent(in) :: side_cutting      !< with which the curvatures were found
      type(steering_result_type), intent(in) :: results(:)
      type(text_type), allocatable :: lines(:)
      type(text_table_type) :: table
      real(wp) :: force, curvature, bend(2)
      integer :: i
      force = unit_factor(job%units, quantity_force)
      curvature = unit_factor(job%units, quantity_curvature)
      allocate (lines(0))
      call append_text(lines, '')
      call append_text(lines, 'Steering: the bit in the hole as it is ('//unit_label(job%units, quantity_force)//', deg), and '// &
                       'the curvature with which the hole continues ('//unit_label(job%units, quantity_curvature)//')')
      do i = 1, size(results)
         associate (found => results(i))
            call add_cell(table, 'Load case', name_width, model%cases(found%case_index)%name)
            call add_cell(table, 'Toolface', width, turned(found%toolface), degree, 1)
            call add_cell(table, 'Side force|high', width, found%side_force(1), force, 2)
            call add_cell(table, 'Side force|right', width, found%side_force(2), force, 2)
            call add_cell(table, 'Tilt|high', width, found%tilt(1), degree, 3)
            call add_cell(table, 'Tilt|right', width, found%tilt(2), degree, 3)
            bend = merge(found%curvature, 0.0_wp, found%found)
            if (.not. found%found) call add_instead(table, '  no curvature')
            call add_cell(table, 'Build|rate', width, bend(1), curvature, 2)
            call add_cell(table, 'Turn|rate', width, turn_rate(found, bend), curvature, 2)
            call add_cell(table, 'Dogleg', width, norm2(bend), curvature, 2)
            call add_cell(table, 'Dogleg|toward', width, turned(dogleg_clock(bend)), degree, 1)
            call end_row(table, '')
         end associate
      end do
      call append_table(lines, table)
      call add_means(model, results, lines)
      call add_ranges(job, model, side_cutting, results, lines)
   contains
      !> A clock angle that one decimal shows below 360.
      pure function turned(angle) result(shown)
         real(wp), intent(in) :: angle      !< [rad]
         real(wp) :: shown
         shown = angle
         if (.not. is_missing(angle)) shown = modulo(anint(10.0_wp*angle/degree), 3600.0_wp)*0.1_wp*degree
      end function turned
   end function steering_table

   !> A line for each load case with a bent housing that turns.
   subroutine add_means(model, results, lines)
      type(model_type), intent(in) :: model
      type(steering_result_type), intent(in) :: results(:)
      type(text_type), allocatable, intent(inout) :: lines(:)
      integer :: i
      do i = 1, size(results)
         associate (load_case => model%cases(results(i)%case_index))
            if (is_straightened(model, load_case)) call append_text(lines, 'All of '//load_case%name// &
               ': means over the tool faces of its bent housing, which turns. limits.csv has no bit side force for it')
         end associate
      end do
   end subroutine add_means

   !> A line for each load case with a bent housing, its dogleg by three points and as found, and for each side cutting found.
   subroutine add_ranges(job, model, side_cutting, results, lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(optional_real), intent(in) :: side_cutting      !< with which the curvatures were found
      type(steering_result_type), intent(in) :: results(:)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(:), allocatable :: name, unit, kind, text
      real(wp) :: curvature, least, most, three_points
      integer :: i, k
      curvature = unit_factor(job%units, quantity_curvature)
      unit = ' '//unit_label(job%units, quantity_curvature)
      kind = 'zero bit side force'
      if (side_cutting%present) kind = 'side_cutting = '//to_text(side_cutting%value, 3)
      do k = 1, size(model%cases)
         name = model%cases(k)%name
         least = huge(least)
         most = 0.0_wp
         three_points = missing
         do i = 1, size(results)
            if (results(i)%case_index /= k .or. .not. results(i)%found .or. is_missing(results(i)%three_points)) cycle
            three_points = results(i)%three_points
            least = min(least, norm2(results(i)%curvature))
            most = max(most, norm2(results(i)%curvature))
         end do
         if (most > 0.0_wp) call append_text(lines, 'Dogleg of '//name//': '//fixed_text(three_points/curvature, 1)// &
            ' by three-point geometry, '//range_text(least, most)//unit//' with '//kind)
         do i = 1, size(results)
            if (results(i)%case_index /= k .or. is_missing(results(i)%side_cutting)) cycle
            text = 'Measured dogleg of '//name//' fits side_cutting = '//to_text(results(i)%side_cutting, 3)
            if (.not. any(is_missing(results(i)%reach))) text = text//'. side_cutting can give '// &
               range_text(minval(results(i)%reach), maxval(results(i)%reach))//unit
            call append_text(lines, text)
         end do
      end do
   contains
      !> Doglegs from the least to the most.
      pure function range_text(low, high) result(shown)
         real(wp), intent(in) :: low, high      !< [1/m]
         character(:), allocatable :: shown
         shown = fixed_text(low/curvature, 1)
         if (fixed_text(high/curvature, 1) /= shown) shown = shown//' to '//fixed_text(high/curvature, 1)
      end function range_text
   end subroutine add_ranges

   !> A result in the columns of the file. New columns are put at the end only.
   function steering_row(model, result) result(row)
      type(model_type), intent(in) :: model
      type(steering_result_type), intent(in) :: result
      type(row_type) :: row
      real(wp) :: bend(2)                  ! curvature that was found
      bend = merge(result%curvature, 0.0_wp, result%found)
      call add(row, 'case', quantity_text, 'name of the load case', model%cases(result%case_index)%name)
      call add(row, 'toolface', quantity_angle, 'empty: a straight string, or the mean of a bend that turns', result%toolface)
      call add(row, 'inclination', quantity_angle, 'of the hole at the bit', result%inclination)
      call add(row, 'hole_build', quantity_curvature, 'build rate of the hole at the bit, as the survey has it', result%hole(1))
      call add(row, 'hole_turn', quantity_curvature, 'turn rate there', turn_rate(result, result%hole))
      call add(row, 'side_force_high', quantity_force, &
               'side force of the bit on the formation, towards the high side; < 0: to the low side; mean over the tool faces '// &
               'for a bend that turns', result%side_force(1))
      call add(row, 'side_force_right', quantity_force, &
               'side force of the bit to the right, looking down the hole', result%side_force(2))
      call add(row, 'tilt_high', quantity_angle, 'tilt of the bit against the hole, towards the high side', result%tilt(1))
      call add(row, 'tilt_right', quantity_angle, 'tilt of the bit to the right', result%tilt(2))
      call add(row, 'build', quantity_curvature, &
               'expected build rate of the hole', optional_real(result%found, bend(1)))
      call add(row, 'turn', quantity_curvature, &
               'expected turn rate of the hole, clockwise seen from above', optional_real(result%found, turn_rate(result, bend)))
      call add(row, 'dogleg', quantity_curvature, 'expected dogleg of the hole', optional_real(result%found, norm2(bend)))
      call add(row, 'dogleg_clock', quantity_angle, &
               'direction of the dogleg, from the high side clockwise looking down the hole', &
               optional_real(result%found, dogleg_clock(bend)))
      call add(row, 'status', quantity_text, &
               'converged, or not_converged without a dogleg', merge('converged    ', 'not_converged', result%found))
      call add(row, 'solutions', quantity_none, 'solutions of the string that were computed', result%solutions)
      call add(row, 'message', quantity_text, 'reason of a missing or doubtful dogleg', result%message)
      call add(row, 'three_point_dogleg', quantity_curvature, &
               'dogleg of a stiff bent assembly with contact at bit and two more points', result%three_points)
      call add(row, 'fitted_side_cutting', quantity_none, 'side_cutting for the measured dogleg', result%side_cutting)
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
end module dg_steering_table
