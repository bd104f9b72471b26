!> The fit of one calibration with one model.
module dg_fit_calibration
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_calibration, only: ahead_of, applied_factor, calibration_type, factors_of_deck, hookload_datum, predicts, &
      solutions_a_step, torque_datum, variance_kinds
   use dg_calibration_result, only: calibration_result_type, judge_fit
   use dg_clock, only: seconds_between
   use dg_depth_drift, only: with_drift
   use dg_fit_by_kinds, only: fit_by_kinds
   use dg_fit_statistics, only: as_normal
   use dg_job, only: job_type, model_name
   use dg_least_squares, only: fit_done, fit_type, fit_without_values, unknowns_type
   use dg_missing, only: is_missing, optional_real
   use dg_model, only: model_type
   use dg_prediction, only: predict
   use dg_progress, only: progress_type, show_time, start_progress
   use dg_string_function, only: new_string_function, string_function_type
   use dg_text, only: quoted, to_text
   implicit none
   private
   public :: fit_calibration

   !> Bounds of a friction factor, as those of the deck [-].
   real(wp), parameter :: least_friction = 0.0_wp, greatest_friction = 2.0_wp
   !> Size of a large friction factor [-].
   real(wp), parameter :: friction_scale = 1.0_wp
   !> Steps that a fit usually takes, at most.
   integer, parameter :: usual_steps = 10

contains

   !> Fit one calibration with one model, and make its predictions.
   subroutine fit_calibration(job, model, calibration, place, result)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      integer, intent(in) :: place             !< of the model in the calibration's
      type(calibration_result_type), intent(out) :: result
      type(string_function_type) :: function
      real(wp), dimension(size(calibration%unknowns)) :: lower, upper, scale
      real(wp), dimension(size(calibration%data)) :: measured, deviation, depth
      logical :: is_hookload(size(calibration%data))
      integer, dimension(size(calibration%data)) :: kinds, of_case, group
      integer, allocatable :: of_kind(:)   !< of every measured value
      integer(int64) :: start, finish
      type(progress_type) :: progress
      integer :: expected
      call system_clock(start)
      call new_string_function(function, model, calibration, calibration%models(place), job%threads)
      result%model = calibration%models(place)
      result%message = ''
      result%start = factors_of_deck(calibration, model%holes, model%cases)
      allocate (result%before(size(calibration%data)))
      expected = usual_steps*solutions_a_step(calibration)
      call start_progress(progress, 'calibration '//quoted(calibration%name)//', model '//trim(model_name(result%model)), &
                          'about '//to_text(expected)//' solutions', job%quiet)
      call function%as_given(result%before)
      call show_time(progress, real(function%solutions, wp)/real(expected, wp))
      measured = calibration%data%measured
      deviation = calibration%data%deviation
      is_hookload = calibration%data%kind == hookload_datum
      lower = least_friction
      upper = greatest_friction
      scale = friction_scale
      where (calibration%unknowns%is_offset)
         scale = maxval(measured, mask=is_hookload)     ! a gauge that only shows its offset
         lower = -scale
         upper = scale
      end where
      ! a string that does not reach its depth with this friction does so with less
      kinds = variance_kinds(calibration)
      call fit_by_kinds(function, unknowns_type(result%start, .not. calibration%unknowns%is_offset, lower, upper, scale), &
                        measured, kinds, deviation, result%fit, result%halvings)
      if (result%fit%status == fit_done) call round_factors(calibration, function, result%fit)
      of_kind = calibration%data%kind       ! a section would be copied to be passed
      of_case = calibration%cases(calibration%data%case)
      depth = model%cases(of_case)%bit_depth
      ! hook loads of an operation, and torques
      group = 2*model%cases(of_case)%operation + of_kind
      call judge_fit(result, measured, deviation, kinds, of_kind, depth, group)
      if (result%statistics%freedom > 0) result%statistics%scatter = norm2((result%fit%values - measured)/ &
         calibration%data%deviation)/sqrt(real(result%statistics%freedom, wp))
      if (result%fit%status == fit_done .and. predicts(calibration)) &
         call look_ahead(model, calibration, job%threads, scale, result)
      if (result%fit%status == fit_without_values) then
         associate (datum => calibration%data(result%fit%lost))
            result%message = 'load case '//quoted(model%cases(calibration%cases(datum%case))%name)//' has no solution: '// &
                             function%message//'; leave it out, or begin with other factors in the deck'
         end associate
      else if (result%fit%status /= fit_done) then
         result%message = 'the sum of squares still falls after all its iterations; separate less'
      end if
      result%solutions = result%solutions + function%solutions
      call system_clock(finish)
      result%seconds = seconds_between(start, finish)
   end subroutine fit_calibration

   !> Round the factors of a fit to those that are printed and applied, and find the values of these.
   subroutine round_factors(calibration, function, fit)
      type(calibration_type), intent(in) :: calibration
      type(string_function_type), intent(inout) :: function
      type(fit_type), intent(inout) :: fit
      real(wp) :: point(size(fit%unknowns), 1), values(size(fit%values), 1)
      logical :: solved(size(fit%values), 1)
      point(:, 1) = merge(fit%unknowns, applied_factor(fit%unknowns), calibration%unknowns%is_offset .or. fit%unfelt)
      call function%evaluate(point, values, solved)
      if (.not. all(solved)) return
      fit%unknowns = point(:, 1)
      fit%values = values(:, 1)
   end subroutine round_factors

   !> Predict the load cases that the calibration names for it, by its results.
   subroutine look_ahead(model, calibration, threads, scale, result)
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      integer, intent(in) :: threads
      real(wp), intent(in) :: scale(:)         !< of the unknowns
      type(calibration_result_type), intent(inout) :: result
      type(calibration_type) :: ahead
      type(string_function_type) :: function
      type(optional_real) :: known
      real(wp), allocatable :: deviation(:), freedom(:)
      integer :: kind
      ahead = ahead_of(calibration, model%cases)
      call new_string_function(function, model, ahead, result%model, threads)
      allocate (deviation(size(ahead%data)), freedom(size(ahead%data)))
      do kind = hookload_datum, torque_datum
         known = calibration%hookload_deviation
         if (kind /= hookload_datum) known = calibration%torque_deviation
         if (.not. known%present) known%value = result%deviations(kind)
         where (ahead%data%kind == kind)
            deviation = known%value
            freedom = merge(real(as_normal, wp), result%freedoms(kind), known%present)
         end where
         if (is_missing(known%value)) cycle
         where (ahead%data%kind == kind) &
            deviation = with_drift(deviation, result%drifts(kind), model%cases(ahead%cases(ahead%data%case))%bit_depth)
      end do
      call predict(function, result%fit, result%statistics, scale, deviation, freedom, result%prediction)
      result%solutions = result%solutions + function%solutions
   end subroutine look_ahead
end module dg_fit_calibration
