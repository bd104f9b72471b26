!> &uncertainty: quantiles of hook load and torque over bit depth, for uncertain well, mud, friction and gauges.
module dg_uncertainty_study
   use dg_column, only: fields_of, row_type
   use dg_deck_draft, only: deck_type
   use dg_deck_range, only: note_range_use
   use dg_deck_uncertainty, only: read_uncertainty_groups
   use dg_ensemble_study, only: ensemble_study_type, name_ranges, prepare_points => prepare_ensembles, range_text_type
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_list_type, error_type, raise, status_not_converged
   use dg_friction_estimate, only: friction_estimate_type
   use dg_job, only: job_type, model_name
   use dg_line_list, only: add_line, line_list_type, move_lines
   use dg_model, only: model_type
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_sample_points, only: solve_samples
   use dg_sample_statistics, only: find_point_statistics, point_statistics_type
   use dg_result_name, only: points_file
   use dg_study, only: run_type
   use dg_sweep, only: model_of, point_at, point_count
   use dg_sweep_points, only: add_indicator
   use dg_text, only: joined, quoted, text_type, to_text
   use dg_tornado_picture, only: tornado_chart
   use dg_uncertainty, only: friction_factor_of, piece_count, uncertainty_type, piece_number
   use dg_uncertainty_file, only: uncertainty_row
   use dg_uncertainty_picture, only: uncertainty_chart
   use dg_uncertainty_table, only: deviations_text, uncertainty_table
   use dg_load_case, only: operation_name
   use dg_csv_table, only: add_row, csv_table_type, write_table
   use dg_model_text, only: append_numbers, append_sweep, yes_or_no
   use dg_case_result, only: result_locked_up, result_not_converged
   use dg_point_outcome, only: note_points
   use dg_run_outcome, only: add_part, outcome_type
   use dg_sweep_result, only: sweep_result_type
   implicit none
   private
   public :: uncertainty_study_type
   public :: note_uncertainty

   !> Result for one range of depths.
   type :: found_type
      type(point_statistics_type), allocatable :: statistics(:)      !< of all its points
   end type found_type

   type, extends(ensemble_study_type) :: uncertainty_study_type
      private
      type(uncertainty_type), allocatable :: uncertainties(:)
      type(found_type), allocatable :: found(:)      !< one for each of them, once one is reported
   contains
      procedure :: read => read_uncertainties
      procedure :: echo
      procedure :: prepare
      procedure :: add_pictures
      procedure :: settings
      procedure :: solve
      procedure :: report
   end type uncertainty_study_type

   !> Columns of the table beneath the picture.
   character(*), parameter :: shown(14) = [character(24) :: 'operation', 'bit_depth', 'hookload_p10', 'hookload_p50', &
      'hookload_p90', 'weight_indicator_p10', 'weight_indicator_p50', 'weight_indicator_p90', 'torque_p10', 'torque_p50', &
      'torque_p90', 'samples', 'locked_up', 'not_converged']

   !> Columns of the table beneath the tornado.
   character(*), parameter :: shown_shares(12) = [character(26) :: 'operation', 'bit_depth', 'hookload_deviation', &
      'hookload_share_friction', 'hookload_share_mud_density', 'hookload_share_survey', 'hookload_share_gauge', &
      'torque_deviation', 'torque_share_friction', 'torque_share_mud_density', 'torque_share_survey', 'torque_share_gauge']

contains

   !> Reads its groups.
   subroutine read_uncertainties(self, deck, job, faults)
      class(uncertainty_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      integer :: i
      call read_uncertainty_groups(deck%draft, deck%groups, job%models, deck%estimates, self%uncertainties, faults)
      allocate (self%ranges(size(self%uncertainties)))
      do i = 1, size(self%uncertainties)
         self%ranges(i) = self%uncertainties(i)%range
         call note_range_use(deck, self%ranges(i), 'uncertainty')
      end do
      call name_ranges(self, range_text_type('uncertainty', 'solutions', 'solutions', ' and are left out of the quantiles', &
                                             'fewer samples'), self%uncertainties%samples)
   end subroutine read_uncertainties

   !> A line a Monte Carlo.
   subroutine echo(self, job, lines)
      class(uncertainty_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      integer :: i
      do i = 1, size(self%uncertainties)
         associate (uncertainty => self%uncertainties(i), range => self%uncertainties(i)%range)
            call add_line(lines, 'uncertainty '//range%name//': '//joined(model_name(range%models), ', ')//'; '// &
               joined(operation_name(range%operations), ', ')//'; '//to_text(size(range%depths))//' depths; '// &
               to_text(uncertainty%samples)//' samples, '//to_text(piece_count(uncertainty))//' solutions; '// &
               deviations_text(job%units, uncertainty))
         end associate
      end do
   end subroutine echo

   !> Take the friction estimates of other studies, then find earlier points.
   subroutine prepare(self, run, error)
      class(uncertainty_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      do i = 1, size(self%uncertainties)
         if (self%uncertainties(i)%estimate == 0) cycle
         call copy_estimate(run%estimates(self%uncertainties(i)%estimate), self%uncertainties(i), error)
         if (allocated(error)) return
      end do
      call prepare_points(self, run, error)
   end subroutine prepare

   !> Deviations and correlations of the friction of hole sections.
   subroutine copy_estimate(estimate, uncertainty, error)
      type(friction_estimate_type), intent(in) :: estimate
      type(uncertainty_type), intent(inout) :: uncertainty
      type(error_type), allocatable, intent(out) :: error
      logical :: known
      integer :: n
      if (.not. estimate%found) return
      n = size(estimate%deviations)
      uncertainty%friction_deviations = estimate%deviations
      if (allocated(uncertainty%friction_factor)) deallocate (uncertainty%friction_factor)
      allocate (uncertainty%friction_factor(n, n))
      known = estimate%known
      if (known) call friction_factor_of(estimate%deviations, estimate%correlation, uncertainty%friction_factor, known)
      if (.not. known) call raise(error, status_not_converged, 'calibration '//quoted(estimate%name)// &
         ' knows no intervals of the friction of its hole sections, so uncertainty '//quoted(uncertainty%range%name)// &
         ' was not run')
   end subroutine copy_estimate

   !> Settings that the results depend on. Deviations of gauges may change: they are added when all points are solved.
   function settings(self, number, model) result(lines)
      class(uncertainty_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(model_type), intent(in) :: model
      type(text_type), allocatable :: lines(:)
      type(line_list_type) :: list
      integer :: i
      associate (uncertainty => self%uncertainties(number))
         call append_sweep(list, model, uncertainty%range)
         call add_line(list, 'samples = '//to_text(uncertainty%samples))
         call add_line(list, 'seed = '//to_text(uncertainty%seed))
         if (allocated(uncertainty%friction_factor)) then
            do i = 1, size(uncertainty%friction_factor, 1)
               call append_numbers(list, 'friction of hole '//to_text(i), uncertainty%friction_factor(i, :i))
            end do
            call add_line(list, 'friction axial, rotary = '//yes_or_no(uncertainty%axial)//' '//yes_or_no(uncertainty%rotary))
         end if
         call add_line(list, 'deviation of mud density = '//to_text(uncertainty%density_deviation))
         call add_line(list, 'deviation of inclination, rad = '//to_text(uncertainty%inclination_deviation))
         call add_line(list, 'deviation of azimuth, rad = '//to_text(uncertainty%azimuth_deviation))
         call add_line(list, 'systematic survey errors = '//yes_or_no(uncertainty%systematic_survey))
      end associate
      call move_lines(list, lines)
   end function settings

   !> Solves what is left.
   subroutine solve(self, number, run, watch)
      class(uncertainty_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(in) :: run
      class(ensemble_watch_type), intent(inout) :: watch
      call solve_samples(run%job, run%model, self%uncertainties(number), self%ensembles(number), watch)
   end subroutine solve

   !> Report the samples: quantiles, the file, the table.
   subroutine report(self, number, run, lines, error)
      class(uncertainty_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(inout) :: run
      type(text_type), allocatable, intent(out) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      type(point_statistics_type), allocatable :: statistics(:)
      type(csv_table_type) :: table
      integer :: i
      if (.not. allocated(self%found)) allocate (self%found(size(self%uncertainties)))
      associate (uncertainty => self%uncertainties(number), points => self%ensembles(number)%points)
         call note_uncertainty(run%printed%outcome, uncertainty, points)
         call add_indicator(run%model, uncertainty%range, uncertainty%samples, points)
         allocate (statistics(point_count(uncertainty%range)))
         do i = 1, size(statistics)
            statistics(i) = find_point_statistics(uncertainty, i, points)
            call add_row(table, uncertainty_row(uncertainty%range, point_at(uncertainty%range, i), statistics(i)), run%job%units)
         end do
         self%found(number)%statistics = statistics
         call write_table(table, run%job%output_dir//'/'//points_file('uncertainty', uncertainty%range%name), error)
         if (.not. allocated(error)) &
            allocate (lines, source=uncertainty_table(run%job%units, uncertainty, statistics, run%model%rig%given))
      end associate
   end subroutine report

   !> A broomstick of quantiles for each range of several depths and model; a tornado for each range and model.
   subroutine add_pictures(self, run, list, error)
      class(uncertainty_study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      type(picture_data_type) :: data, shares
      type(row_type) :: row
      integer, allocatable :: rows(:)
      integer :: i, k, r
      if (.not. allocated(self%found)) return
      do i = 1, size(self%uncertainties)
         if (.not. allocated(self%found(i)%statistics)) cycle
         associate (uncertainty => self%uncertainties(i), range => self%uncertainties(i)%range, &
                    statistics => self%found(i)%statistics)
            do k = 1, size(range%models)
               call picked_rows(points_file('uncertainty', range%name), [(model_of(range, r) == k, r=1, size(statistics))], data, &
                                rows)
               shares = data
               do r = 1, size(rows)
                  row = uncertainty_row(range, point_at(range, rows(r)), statistics(rows(r)))
                  data%rows(r) = fields_of(row, shown)
                  shares%rows(r) = fields_of(row, shown_shares)
               end do
               if (size(range%depths) > 1) &
                  call add_picture(list, run%job, uncertainty_chart(run%job%units, range, k, run%model, statistics), &
                                   'What uncertain data make of hook load and torque', 0, data, error)
               call add_picture(list, run%job, tornado_chart(run%job%units, uncertainty, k, statistics), &
                                'What matters most: hook load and torque by one standard deviation of each input', 0, shares, &
                                error)
            end do
         end associate
      end do
   end subroutine add_pictures

   !> Note the failed samples of a Monte Carlo: a row a point. Its table and its file count those that locked up.
   pure subroutine note_uncertainty(outcome, uncertainty, pieces)
      type(outcome_type), intent(inout) :: outcome
      type(uncertainty_type), intent(in) :: uncertainty
      type(sweep_result_type), intent(in) :: pieces(:)     !< a point and sample each
      integer :: point, sample, lost, first
      associate (name => 'uncertainty '//uncertainty%range%name)
         call add_part(outcome, name, size(pieces), count(pieces%status == result_locked_up), &
                       count(pieces%status == result_not_converged))
         do point = 1, point_count(uncertainty%range)
            lost = 0
            first = 0
            do sample = uncertainty%samples, 1, -1
               if (pieces(piece_number(uncertainty, point, sample))%status /= result_not_converged) cycle
               lost = lost + 1
               first = sample
            end do
            if (lost > 0) call note_points(outcome, name, uncertainty%range, point, point, lost, &
                                           pieces(piece_number(uncertainty, point, first)), ' (sample '//to_text(first)//')')
         end do
      end associate
   end subroutine note_uncertainty
end module dg_uncertainty_study
