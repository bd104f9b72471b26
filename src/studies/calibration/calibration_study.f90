!> &calibrate: friction from measurements, and the gauge's excess over string and block.
module dg_calibration_study
   use dg_column, only: fields_of
   use dg_calibration, only: apply_factors, apply_offset, calibrate_friction_axial, calibrate_friction_rotary, &
                             calibration_type, parameter_name, predicts
   use dg_calibration_file, only: datum_row, write_calibrations
   use dg_calibration_picture, only: calibration_chart
   use dg_calibration_result, only: calibration_result_type
   use dg_calibration_table, only: calibration_table
   use dg_case_result, only: result_not_converged
   use dg_deck_calibrate, only: read_calibration_groups
   use dg_deck_draft, only: deck_type
   use dg_diagnostic, only: report_line
   use dg_error, only: error_list_type, error_type, raise, status_failure, status_not_converged
   use dg_exit_status, only: graver
   use dg_csv_table, only: begin_table
   use dg_factor_columns, only: factor_file, factor_row, found_type
   use dg_fit_calibration, only: fit_calibration
   use dg_friction_estimate, only: friction_estimate_type
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: is_divided, job_type, model_name
   use dg_learnt_friction, only: half_widths_of, learn_friction
   use dg_least_squares, only: fit_done
   use dg_line_list, only: add_line, line_list_type
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_printed_text, only: print_and_keep
   use dg_run_outcome, only: add_part, note_lost
   use dg_study, only: phase_after, phase_first, run_type, study_type
   use dg_text, only: is_separator_free, joined, quoted, text_list, text_type, to_text
   implicit none
   private
   public :: calibration_study_type

   type, extends(study_type) :: calibration_study_type
      private
      type(calibration_type), allocatable :: calibrations(:)
      integer :: estimates = 0     !< of the run that are there before those of the first calibration
      type(calibration_result_type), allocatable :: results(:)
      integer, allocatable :: owner(:)              !< number of the calibration of each result
   contains
      procedure :: read => read_calibrations
      procedure :: run => run_calibrations
      procedure :: echo
      procedure :: add_pictures
   end type calibration_study_type

   !> Columns of the table beneath the picture.
   character(*), parameter :: shown(11) = [character(24) :: 'case', 'operation', 'bit_depth', 'measured_hookload', &
      'before_hookload', 'after_hookload', 'measured_torque', 'before_torque', 'after_torque', 'before_error', 'after_error']

contains

   !> Reads its groups, and announces what they will find of friction.
   subroutine read_calibrations(self, deck, job, faults)
      class(calibration_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      type(friction_estimate_type), allocatable :: longer(:)
      integer :: i
      associate (not_needed => job)
         call read_calibration_groups(deck%draft, deck%groups, self%calibrations, faults)
      end associate
      self%estimates = size(deck%estimates)
      allocate (longer(self%estimates + size(self%calibrations)))
      longer(:self%estimates) = deck%estimates
      do i = 1, size(self%calibrations)
         associate (estimate => longer(self%estimates + i), calibration => self%calibrations(i))
            estimate%name = calibration%name
            estimate%applied = calibration%apply
            estimate%axial = calibration%parameter /= calibrate_friction_rotary
            estimate%rotary = calibration%parameter /= calibrate_friction_axial
         end associate
      end do
      call move_alloc(longer, deck%estimates)
      self%asked = size(self%calibrations) > 0
      self%fits = .true.
      ! before all else where what they find is applied
      self%phase = merge(phase_first, phase_after, any(self%calibrations%apply))
      self%forms = text_list(factor_file, 'calibration_data.csv', 'calibration_prediction.csv')
      self%files = self%forms(:merge(3, 2, any(predicts(self%calibrations))))
   end subroutine read_calibrations

   !> A line a calibration.
   subroutine echo(self, job, lines)
      class(calibration_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      character(:), allocatable :: line
      integer :: i
      associate (not_needed => job)
      end associate
      do i = 1, size(self%calibrations)
         associate (calibration => self%calibrations(i))
            line = 'calibrate   '//calibration%name//': '//trim(parameter_name(calibration%parameter))//'; '// &
               joined(model_name(calibration%models), ', ')//'; '//to_text(size(calibration%unknowns))//' unknowns from '// &
               to_text(size(calibration%data))//' measured values of '//to_text(size(calibration%cases))//' load cases'
            if (predicts(calibration)) line = line//'; '//to_text(size(calibration%predicted))//' predicted'
            if (calibration%apply) line = line//'; applied'
            call add_line(lines, line)
         end associate
      end do
   end subroutine echo

   !> Run each calibration with each of its models. Friction that is to be applied goes into the model of the run. An error
   !> says that a file could not be written, or that there is nothing to apply. A run that is a part of others, or joins them,
   !> only makes calibrations that are applied, and neither prints nor writes them.
   subroutine run_calibrations(self, run, error)
      class(calibration_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: failure
      integer :: i, j, n, lost
      logical :: divided, applied
      divided = is_divided(run%job)
      n = 0
      do i = 1, size(self%calibrations)
         n = n + size(self%calibrations(i)%models)
      end do
      allocate (self%results(n), self%owner(n))
      n = 0
      do i = 1, size(self%calibrations)
         associate (calibration => self%calibrations(i))
            if (divided .and. .not. calibration%apply) cycle
            lost = 0
            do j = 1, size(calibration%models)
               call fit_calibration(run%job, run%given, calibration, j, self%results(n + 1))
               if (is_interrupted()) exit
               n = n + 1
               self%owner(n) = i
               associate (result => self%results(n))
                  if (result%fit%status /= fit_done) then
                     lost = lost + 1
                     call note_lost(run%printed%outcome, 'calibration '//calibration%name, result%model, &
                                    result_not_converged, result%message)
                     call report_line('calibration '//quoted(calibration%name)//', model '//trim(model_name(result%model))// &
                                      ': no fit; '//result%message)
                  else
                     if (calibration%apply) then
                        call apply_factors(calibration, result%fit%unknowns, .not. result%fit%unfelt, run%model%cases, &
                                           run%model%holes)
                        call apply_offset(calibration, result%fit%unknowns, .not. result%fit%unfelt, run%model%rig, applied)
                     end if
                     call hand_on(calibration, result, size(run%model%holes), run%estimates(self%estimates + i))
                  end if
                  if (calibration%apply .and. result%fit%status /= fit_done .and. .not. allocated(error)) &
                     call raise(error, status_not_converged, 'calibration '//quoted(calibration%name)// &
                                ' has found no friction to apply, so what is to use it was not run')
                  if (divided) cycle
                  allocate (lines, source=calibration_table(run%job%units, run%given, calibration, result))
                  call print_and_keep(run%printed, lines)
                  deallocate (lines)
               end associate
            end do
            call add_part(run%printed%outcome, 'calibration '//calibration%name, size(calibration%models), 0, lost)
            if (lost > 0) run%status = graver(run%status, status_not_converged)
         end associate
      end do
      self%owner = self%owner(:n)
      if (.not. divided) then
         call begin_table(run%factors, factor_row(found_type()), run%job%units)
         call write_calibrations(run%job, run%given, self%calibrations, self%owner, self%results(:n), run%factors, failure)
         if (allocated(failure)) call move_alloc(failure, error)
      end if
      if (is_interrupted() .and. .not. allocated(error)) call raise(error, status_failure, 'calibrations: ended by '// &
         interruption_name()//' with '//to_text(n)//' fits of '//to_text(size(self%results))//' done')
   end subroutine run_calibrations

   !> Hand the friction of a calibration to other studies.
   subroutine hand_on(calibration, result, sections, estimate)
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: result
      integer, intent(in) :: sections          !< of the hole
      type(friction_estimate_type), intent(inout) :: estimate
      if (allocated(estimate%deviations)) deallocate (estimate%deviations, estimate%correlation)
      allocate (estimate%deviations(sections), estimate%correlation(sections, sections))
      estimate%found = .true.
      estimate%half_widths = half_widths_of(calibration, result, sections)
      call learn_friction(calibration, result, estimate%deviations, estimate%correlation, estimate%known)
   end subroutine hand_on

   !> A picture for each calibration and model.
   subroutine add_pictures(self, run, list, error)
      class(calibration_study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      type(picture_data_type) :: data
      character(:), allocatable :: name, model
      integer, allocatable :: rows(:)
      integer :: i, k
      if (run%job%merge > 0 .or. .not. allocated(self%owner)) return      ! a run that joins parts has not calibrated
      do i = 1, size(self%owner)
         associate (calibration => self%calibrations(self%owner(i)))
            name = to_text(self%owner(i))             ! where its name is none for a file
            if (is_separator_free(calibration%name)) name = calibration%name
            model = trim(model_name(self%results(i)%model))
            call picked_rows('calibration_data.csv', spread(.true., 1, size(calibration%data)), data, rows)
            do k = 1, size(rows)
               data%rows(k) = fields_of(datum_row(run%given, calibration, self%results(i), rows(k)), shown)
            end do
            call add_picture(list, run%job, calibration_chart('calibration_'//name//'_'//model, run%job%units, run%given, &
                                                              calibration, self%results(i)), &
                             'Friction found from measurements, and the error before and after', 0, data, error)
         end associate
      end do
   end subroutine add_pictures
end module dg_calibration_study
