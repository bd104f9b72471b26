!> Search for the place that holds a string: resistance at a known depth, and the free point from stretch.
module dg_hold_string
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_type
   use dg_fit_statistics, only: find_statistics, statistics_type
   use dg_interruption, only: by_signals
   use dg_least_squares, only: fit_done, fit_least_squares, fit_type, measured_function_type
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index, copy_without_cases
   use dg_progress, only: progress_type, show_time
   use dg_rig, only: indicator_factor, string_load
   use dg_solve_case, only: solve_case
   use dg_sticking, only: find_resistance, sticking_at_bound, sticking_below_bit, sticking_found, sticking_result_type, &
                           sticking_type
   use dg_stuck_string, only: free_point_without_friction, stretch_between, value_at, cut_string
   implicit none
   private
   public :: resistance, free_point, usual_solutions

   !> Range of pulls and torques of the search, over measured hook loads and torques [-].
   real(wp), parameter :: widest = 10.0_wp
   !> Deviation if none is known, over the measured value [-]. One datum for one unknown is met with any weight.
   real(wp), parameter :: any_deviation = 1.0e-3_wp
   !> A free point is found to this part of the bit's depth [-], far finer than stretch can be measured.
   real(wp), parameter :: depth_share = 1.0e-6_wp
   integer, parameter :: most_trials = 60
   !> Solutions that a resistance and a free point usually take, and trials of a free point.
   integer, parameter :: usual_solutions(2) = [6, 20], usual_trials = 3
   !> Least depth of a free point over that of the bit [-]: some string must be left.
   real(wp), parameter :: shallowest = 1.0e-3_wp

   !> Hook load and torque at the top of a string held at its lower end, as a function of pull and torque there.
   type, extends(measured_function_type) :: stuck_function_type
      type(model_type) :: model                !< its string ends where it is held
      integer :: number = 0                    !< of the model that solves
      character(:), allocatable :: message     !< of the last solution that was none
   contains
      procedure :: evaluate
   end type stuck_function_type

contains

   !> Resistance at a known depth: pull and torque above it that give the measured values, less those of a free string.
   subroutine resistance(model, sticking, result, progress)
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(inout) :: result
      type(progress_type), intent(inout) :: progress
      type(stuck_function_type) :: function
      type(case_result_type) :: free
      type(error_type), allocatable :: error
      type(fit_type) :: fit
      type(statistics_type) :: statistics
      real(wp), allocatable :: start(:), measured(:), deviation(:), lower(:)
      result%depth = sticking%depth
      call solve_case(model, result%model, result%case_index, free, error, stop=by_signals())
      call show_time(progress, 1.0_wp/real(usual_solutions(find_resistance)*size(sticking%models)*size(sticking%cases), wp))
      if (free%status /= result_converged) then
         result%message = 'free string: '//free%message
         return
      end if
      result%free_hookload = free%hookload
      result%tension_below = value_at(free%profile%md, free%profile%axial, sticking%depth)
      result%torque_below = value_at(free%profile%md, free%profile%torque, sticking%depth)
      call new_stuck_function(function, model, result%case_index, sticking%depth, result%model)
      associate (case => model%cases(result%case_index))
         measured = [string_load(model%rig, case%operation, case%measured_hookload%value)]
         start = [result%tension_below + measured(1) - free%hookload]
         lower = [-widest*measured(1)]
         if (case%measured_torque%present) then
            measured = [measured, case%measured_torque%value]
            start = [start, max(result%torque_below + measured(2) - free%torque, 0.0_wp)]
            lower = [lower, 0.0_wp]
         else
            function%model%cases(1)%tob = result%torque_below
         end if
      end associate
      deviation = any_deviation*max(measured, tiny(1.0_wp)/any_deviation)
      if (size(measured) > 1) deviation(2) = max(deviation(2), any_deviation)      ! a torque of nothing
      if (sticking%hookload_deviation%present) deviation(1) = sticking%hookload_deviation%value &
         /indicator_factor(model%rig, model%cases(result%case_index)%operation)
      if (size(measured) > 1 .and. sticking%torque_deviation%present) deviation(2) = sticking%torque_deviation%value
      call fit_least_squares(function, start, lower, widest*max(measured, 1.0_wp), max(measured, 1.0_wp), measured, deviation, fit)
      if (fit%status /= fit_done) then
         result%message = 'held string: '//function%message
         return
      end if
      result%status = sticking_found
      result%tension_above = fit%unknowns(1)
      if (size(measured) > 1) result%torque_above = fit%unknowns(2)
      if (any(fit%at_bound)) result%status = sticking_at_bound
      if (.not. sticking%hookload_deviation%present) return
      call find_statistics(fit%jacobian, (fit%values - measured)/deviation, .not. (fit%at_bound .or. fit%unfelt), &
                           spread(0, 1, size(measured)), statistics)
      result%half_width = statistics%half_width(1)
   end subroutine resistance

   !> Free point: the depth at which the held string stretches as measured from the first pull to the second, friction acting in
   !> both. By regula falsi (Illinois), between a point near surface and the bit.
   subroutine free_point(model, sticking, result, progress)
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(inout) :: result
      type(progress_type), intent(inout) :: progress
      real(wp) :: low, high, at_low, at_high, depth, found
      integer :: trial, side
      associate (first => model%cases(sticking%cases(1)), second => model%cases(sticking%cases(2)))
         result%depth_without_friction = free_point_without_friction( &
            model%strings(string_index(model%strings, first%string)), first%bit_depth, &
            string_load(model%rig, second%operation, second%measured_hookload%value) - &
            string_load(model%rig, first%operation, first%measured_hookload%value), sticking%stretch)
         low = shallowest*first%bit_depth
         high = first%bit_depth
      end associate
      side = 0
      call excess(model, sticking, result, high, at_high)
      call show_time(progress, 1.0_wp/real(usual_trials*size(sticking%models), wp))
      if (is_missing(at_high)) return
      if (at_high < 0.0_wp) then
         result%status = sticking_below_bit
         return
      end if
      at_low = -sticking%stretch
      do trial = 1, most_trials
         depth = low + (high - low)*at_low/(at_low - at_high)
         call excess(model, sticking, result, depth, found)
         if (is_missing(found)) return
         if (found < 0.0_wp) then
            if (side == -1) at_high = 0.5_wp*at_high
            if (depth - low < depth_share*high .and. trial > 1) exit
            low = depth
            at_low = found
            side = -1
         else
            if (side == 1) at_low = 0.5_wp*at_low
            if (high - depth < depth_share*high) exit
            high = depth
            at_high = found
            side = 1
         end if
         if (abs(found) <= depth_share*sticking%stretch) exit
      end do
      result%depth = depth
      result%status = sticking_found
   end subroutine free_point

   !> Stretch of the string held at a depth between the two pulls, less the measured one [m]; missing where there is no
   !> solution. Notes the pull at that depth in the second state.
   subroutine excess(model, sticking, result, depth, found)
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(inout) :: result
      real(wp), intent(in) :: depth
      real(wp), intent(out) :: found
      type(stuck_function_type) :: function
      type(case_result_type) :: held(2)
      type(fit_type) :: fit
      real(wp) :: measured(1)
      integer :: i
      found = missing
      do i = 1, 2
         call new_stuck_function(function, model, sticking%cases(i), depth, result%model)
         associate (case => model%cases(sticking%cases(i)))
            measured = string_load(model%rig, case%operation, case%measured_hookload%value)
         end associate
         call fit_least_squares(function, measured, -widest*measured, widest*measured, measured, measured, &
                                any_deviation*measured, fit)
         if (fit%status == fit_done) call solve_held(function, fit%unknowns, held(i), totals_only=.false.)
         if (fit%status /= fit_done .or. held(i)%status /= result_converged) then
            result%message = 'held string: '//function%message
            return
         end if
      end do
      result%tension_above = fit%unknowns(1)
      associate (case => function%model%cases(1))
         found = stretch_between(held(1)%profile, held(2)%profile, &
                                 function%model%strings(string_index(function%model%strings, case%string)), case%bit_depth) &
                 - sticking%stretch
      end associate
   end subroutine excess

   !> The string of a load case held at a depth [m].
   subroutine new_stuck_function(function, model, case_index, depth, number)
      type(stuck_function_type), intent(out) :: function
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: depth
      integer, intent(in) :: number
      call copy_without_cases(model, function%model)
      function%model%cases(1) = model%cases(case_index)
      call cut_string(function%model, depth)
      function%number = number
      function%message = ''
   end subroutine new_stuck_function

   !> Points hold the pull [N] and, where looked for, the torque [N.m] at the lower end.
   subroutine evaluate(self, points, values, solved)
      class(stuck_function_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      type(case_result_type) :: result
      integer :: p
      do p = 1, size(points, 2)
         call solve_held(self, points(:, p), result, totals_only=.true.)
         values(1, p) = result%hookload
         if (size(values, 1) > 1) values(2, p) = result%torque
         solved(:, p) = result%status == result_converged
         if (.not. solved(1, p)) self%message = result%message
      end do
   end subroutine evaluate

   !> The string with a pull and torque at its lower end.
   subroutine solve_held(function, point, result, totals_only)
      class(stuck_function_type), intent(inout) :: function
      real(wp), intent(in) :: point(:)
      type(case_result_type), intent(out) :: result
      logical, intent(in) :: totals_only
      type(error_type), allocatable :: error
      function%model%cases(1)%wob = -point(1)
      if (size(point) > 1) function%model%cases(1)%tob = point(2)
      call solve_case(function%model, function%number, 1, result, error, totals_only=totals_only, stop=by_signals())
   end subroutine solve_held
end module dg_hold_string
