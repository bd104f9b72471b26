!> Runs the calibrations of a deck, prints and writes what they find.
module dg_run_calibrations
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_calibration, only: ahead_of, apply_factors, apply_offset, calibration_type, factors_of_deck, hookload_datum, &
      predicts, solutions_a_step, torque_datum, variance_kinds
   use dg_calibration_file, only: factor_columns, write_calibrations
   use dg_calibration_result, only: calibration_result_type, judge_fit
   use dg_calibration_table, only: calibration_table
   use dg_case_result, only: result_not_converged
   use dg_clock, only: seconds_between
   use dg_csv_table, only: begin_table, csv_table_type
   use dg_diagnostic, only: tell
   use dg_error, only: error_type, raise, status_failure, status_not_converged
   use dg_fit_by_kinds, only: fit_by_kinds
   use dg_fit_statistics, only: as_normal
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: job_type, model_name
   use dg_learnt_friction, only: learn_friction
   use dg_least_squares, only: fit_done, fit_without_values
   use dg_load_case, only: optional_real
   use dg_least_squares, only: unknowns_type
   use dg_model, only: model_type
   use dg_prediction, only: predict
   use dg_printed_text, only: print_and_keep, printed_text_type
   use dg_progress, only: progress_type, show_time, start_progress
   use dg_run_outcome, only: add_part, note_lost
   use dg_run_stickings, only: run_stickings
   use dg_string_function, only: new_string_function, string_function_type
   use dg_text, only: quoted, text_type, to_text
   use dg_uncertainty, only: friction_factor_of, uncertainty_type
   implicit none
   private
   public :: run_calibrations

   !> Bounds of a friction factor, as those of the deck [-].
   real(wp), parameter :: least_friction = 0.0_wp, greatest_friction = 2.0_wp
   !> A friction factor that is a large one [-].
   real(wp), parameter :: friction_scale = 1.0_wp
   !> Steps that a fit usually takes, at most.
   integer, parameter :: usual_steps = 10

contains

   !> Each calibration with each of its models. `calibrated` is the model with the friction that is to be applied. `lost` counts
   !> those without a fit; `error` tells that a file could not be written, or that there is nothing to apply. A run that is a
   !> part of others, or joins them, does what is applied alone, and neither prints nor writes it.
   !> The uncertainties that go on from a calibration get its deviations of friction.
   subroutine run_calibrations(printed, job, model, calibrated, uncertainties, lost, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(model_type), intent(out) :: calibrated
      type(uncertainty_type), intent(inout) :: uncertainties(:)     !< of the deck
      integer, intent(out) :: lost
      type(error_type), allocatable, intent(out) :: error
      type(calibration_result_type), allocatable :: results(:)
      integer, allocatable :: owner(:)     !< number of the calibration of each result
      type(text_type), allocatable :: lines(:)
      type(csv_table_type) :: others
      type(error_type), allocatable :: failure
      integer :: i, j, n, n_lost, before
      logical :: divided, applied
      calibrated = model
      divided = job%parts > 0 .or. job%merge > 0
      n = size(job%stickings)
      do i = 1, size(job%calibrations)
         n = n + size(job%calibrations(i)%models)
      end do
      lost = 0
      if (n == 0) return
      allocate (results(n), owner(n))
      n = 0
      do i = 1, size(job%calibrations)
         if (divided .and. .not. job%calibrations(i)%apply) cycle
         before = lost
         do j = 1, size(job%calibrations(i)%models)
            call calibrate(job, model, job%calibrations(i), j, results(n + 1))
            if (is_interrupted()) exit
            n = n + 1
            owner(n) = i
            if (results(n)%fit%status /= fit_done) then
               lost = lost + 1
               call note_lost(printed%outcome, 'calibration '//job%calibrations(i)%name, results(n)%model, &
                              result_not_converged, results(n)%message)
               call tell('calibration '//quoted(job%calibrations(i)%name)//', model '// &
                         trim(model_name(results(n)%model))//': no fit; '//results(n)%message)
            end if
            if (job%calibrations(i)%apply .and. results(n)%fit%status == fit_done) then
               call apply_factors(job%calibrations(i), results(n)%fit%unknowns, .not. results(n)%fit%unfelt, calibrated%holes)
               call apply_offset(job%calibrations(i), results(n)%fit%unknowns, .not. results(n)%fit%unfelt, calibrated%rig, applied)
            end if
            call hand_on(i, job%calibrations(i), results(n), size(model%holes), uncertainties, error)
            if (job%calibrations(i)%apply .and. results(n)%fit%status /= fit_done .and. .not. allocated(error)) &
               call raise(error, status_not_converged, 'calibration '//quoted(job%calibrations(i)%name)// &
                          ' has found no friction to apply, so what is to use it was not run')
            if (divided) cycle
            allocate (lines, source=calibration_table(job%units, model, job%calibrations(i), results(n)))
            call print_and_keep(printed, lines)
            deallocate (lines)
         end do
         call add_part(printed%outcome, 'calibration '//job%calibrations(i)%name, size(job%calibrations(i)%models), 0, &
                       lost - before)
      end do
      n_lost = lost
      if (.not. divided) then
         call begin_table(others, factor_columns, job%units)
         if (.not. allocated(error)) call run_stickings(printed, job, calibrated, others, lost)
         lost = lost + n_lost
         call write_calibrations(job, model, owner(:n), results(:n), others, failure)
         if (allocated(failure)) call move_alloc(failure, error)
      end if
      if (is_interrupted() .and. .not. allocated(error)) call raise(error, status_failure, 'calibrations: ended by '// &
         interruption_name()//' with '//to_text(n)//' fits of '//to_text(size(results))//' done')
   end subroutine run_calibrations

   !> Gives the deviations that a calibration has found to the uncertainties that go on from it; an error where it found none.
   subroutine hand_on(number, calibration, result, sections, uncertainties, error)
      integer, intent(in) :: number            !< of the calibration in the deck
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: sections          !< of the hole
      type(uncertainty_type), intent(inout) :: uncertainties(:)
      type(error_type), allocatable, intent(inout) :: error
      real(wp) :: deviations(sections), correlation(sections, sections)
      logical :: known
      integer :: i
      if (result%fit%status /= fit_done) return
      do i = 1, size(uncertainties)
         if (uncertainties(i)%calibration /= number) cycle
         call learn_friction(calibration, result, deviations, correlation, known)
         uncertainties(i)%friction_deviations = deviations
         if (allocated(uncertainties(i)%friction_factor)) deallocate (uncertainties(i)%friction_factor)
         allocate (uncertainties(i)%friction_factor(sections, sections))
         if (known) call friction_factor_of(deviations, correlation, uncertainties(i)%friction_factor, known)
         if (.not. known .and. .not. allocated(error)) call raise(error, status_not_converged, 'calibration '// &
            quoted(calibration%name)//' knows no intervals of the friction of its hole sections, so uncertainty '// &
            quoted(uncertainties(i)%range%name)//' was not run')
      end do
   end subroutine hand_on

   !> One calibration with one model.
   subroutine calibrate(job, model, calibration, place, result)
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
         scale = maxval(measured, mask=is_hookload)     ! a gauge that shows nothing but its offset
         lower = -scale
         upper = scale
      end where
      ! a string that does not reach its depth with the friction it has does so with less
      kinds = variance_kinds(calibration)
      call fit_by_kinds(function, unknowns_type(result%start, .not. calibration%unknowns%is_offset, lower, upper, scale), &
                        measured, kinds, deviation, result%fit, result%halvings)
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
   end subroutine calibrate

   !> Predicts the load cases that the calibration names for that, by what it has found.
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
         where (ahead%data%kind == kind)
            deviation = result%deviations(kind)
            freedom = result%freedoms(kind)
         end where
         if (.not. known%present) cycle
         where (ahead%data%kind == kind)
            deviation = known%value
            freedom = real(as_normal, wp)
         end where
      end do
      call predict(function, result%fit, result%statistics, scale, deviation, freedom, result%prediction)
      result%solutions = result%solutions + function%solutions
   end subroutine look_ahead
end module dg_run_calibrations
