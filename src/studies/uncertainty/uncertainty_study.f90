!> &uncertainty: quantiles of hook load and torque over bit depth, where well, mud, friction and gauges are not known for sure.
module dg_uncertainty_study
   use dg_column, only: fields_of, row_type
   use dg_deck_draft, only: deck_type, note_use
   use dg_deck_schema, only: add_group, group_keys_type
   use dg_deck_uncertainty, only: take_uncertainties
   use dg_ensemble_study, only: ensemble_study_type, prepare_points => prepare_ensembles
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_type, raise, status_not_converged
   use dg_fault_list, only: fault_list_type
   use dg_friction_estimate, only: friction_estimate_type
   use dg_job, only: job_type
   use dg_line_list, only: line_list_type
   use dg_model, only: model_type
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_sample_points, only: sample_text, solve_samples
   use dg_sample_statistics, only: find_point_statistics, point_statistics_type
   use dg_uncertainty_keys, only: uncertainty_keys, uncertainty_rule
   use dg_range_text, only: range_text_type
   use dg_result_name, only: points_file
   use dg_study, only: run_type
   use dg_sweep, only: model_of, point_at, point_count, sweep_type
   use dg_sweep_points, only: add_indicator
   use dg_text, only: quoted, text_type
   use dg_tornado_picture, only: tornado_chart
   use dg_uncertainty, only: friction_factor_of, piece_count, uncertainty_type
   use dg_uncertainty_echo, only: add_uncertainties
   use dg_uncertainty_file, only: uncertainty_row, write_uncertainty
   use dg_uncertainty_outcome, only: note_uncertainty
   use dg_uncertainty_picture, only: uncertainty_chart
   use dg_uncertainty_table, only: uncertainty_table
   use dg_uncertainty_text, only: uncertainty_lines
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: uncertainty_study_type

   !> What is found of one range of depths.
   type :: found_type
      type(point_statistics_type), allocatable :: statistics(:)      !< of all its points
   end type found_type

   type, extends(ensemble_study_type) :: uncertainty_study_type
      private
      type(uncertainty_type), allocatable :: uncertainties(:)
      type(found_type), allocatable :: found(:)      !< one for each of them, once one is reported
   contains
      procedure :: add_groups
      procedure :: read => read_uncertainties
      procedure :: echo
      procedure :: prepare
      procedure :: add_pictures
      procedure :: range_count
      procedure :: texts
      procedure :: range => depth_range
      procedure :: points_of
      procedure :: settings
      procedure :: solve
      procedure :: report
      procedure :: place
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

   !> Its group.
   subroutine add_groups(self, groups)
      class(uncertainty_study_type), intent(in) :: self
      type(group_keys_type), allocatable, intent(inout) :: groups(:)
      associate (not_needed => self)
         call add_group(groups, uncertainty_rule, uncertainty_keys)
      end associate
   end subroutine add_groups

   !> Reads its groups.
   subroutine read_uncertainties(self, deck, job, notes, faults)
      class(uncertainty_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(inout) :: notes(:)
      type(fault_list_type), intent(inout) :: faults
      integer :: i
      associate (not_needed => notes)
         call take_uncertainties(deck%draft, deck%groups, job%models, deck%estimates, self%uncertainties, faults)
      end associate
      do i = 1, size(self%uncertainties)
         associate (range => self%uncertainties(i)%range)
            if (allocated(range%depths)) call note_use(deck, range%string, maxval(range%depths))
         end associate
      end do
   end subroutine read_uncertainties

   !> A line a Monte Carlo.
   subroutine echo(self, job, lines)
      class(uncertainty_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      call add_uncertainties(lines, self%uncertainties, job%units)
   end subroutine echo

   !> Takes what others have found out about friction, then looks for earlier points.
   subroutine prepare(self, run, error)
      class(uncertainty_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      do i = 1, size(self%uncertainties)
         if (self%uncertainties(i)%estimate == 0) cycle
         call take_estimate(run%estimates(self%uncertainties(i)%estimate), self%uncertainties(i), error)
         if (allocated(error)) return
      end do
      call prepare_points(self, run, error)
   end subroutine prepare

   !> Deviations and correlations of the friction of hole sections.
   subroutine take_estimate(estimate, uncertainty, error)
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
   end subroutine take_estimate

   !> How many there are.
   pure function range_count(self) result(number)
      class(uncertainty_study_type), intent(in) :: self
      integer :: number
      number = size(self%uncertainties)
   end function range_count

   !> What it is called.
   function texts(self)
      class(uncertainty_study_type), intent(in) :: self
      type(range_text_type) :: texts
      associate (not_needed => self)
         texts%what = 'uncertainty'
         texts%points = 'solutions'
         texts%points_solved = 'solutions'
         texts%left_out = ' and are left out of the quantiles'
         texts%fewer = 'fewer samples'
      end associate
   end function texts

   !> Its depths.
   function depth_range(self, number) result(range)
      class(uncertainty_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(sweep_type) :: range
      range = self%uncertainties(number)%range
   end function depth_range

   !> Points of the range, each with all samples.
   pure function points_of(self, number) result(points)
      class(uncertainty_study_type), intent(in) :: self
      integer, intent(in) :: number
      integer :: points
      points = piece_count(self%uncertainties(number))
   end function points_of

   !> All that its results depend on.
   function settings(self, number, model) result(lines)
      class(uncertainty_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(model_type), intent(in) :: model
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=uncertainty_lines(model, self%uncertainties(number)))
   end function settings

   !> Solves what is left.
   subroutine solve(self, number, run, watch)
      class(uncertainty_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(in) :: run
      class(ensemble_watch_type), intent(inout) :: watch
      call solve_samples(run%job, run%model, self%uncertainties(number), self%ensembles(number), watch)
   end subroutine solve

   !> What follows from the samples: quantiles, its file, its table.
   subroutine report(self, number, run, lines, error)
      class(uncertainty_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(inout) :: run
      type(text_type), allocatable, intent(out) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      type(point_statistics_type), allocatable :: statistics(:)
      integer :: i
      if (.not. allocated(self%found)) allocate (self%found(size(self%uncertainties)))
      associate (uncertainty => self%uncertainties(number), points => self%ensembles(number)%points)
         call note_uncertainty(run%printed%outcome, uncertainty, points)
         call add_indicator(run%model, uncertainty%range, uncertainty%samples, points)
         allocate (statistics(point_count(uncertainty%range)))
         do i = 1, size(statistics)
            statistics(i) = find_point_statistics(uncertainty, i, points)
         end do
         self%found(number)%statistics = statistics
         call write_uncertainty(run%job%output_dir//'/'//points_file('uncertainty', uncertainty%range%name), run%job, &
                                uncertainty, statistics, error)
         if (.not. allocated(error)) &
            allocate (lines, source=uncertainty_table(run%job%units, uncertainty, statistics, run%model%rig%given))
      end associate
   end subroutine report

   !> A sample in words.
   function place(self, number, point, units) result(text)
      class(uncertainty_study_type), intent(in) :: self
      integer, intent(in) :: number, point
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      text = sample_text(units, self%uncertainties(number), point)
   end function place

   !> A broomstick of quantiles for each range of depths and model.
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
               call add_picture(list, run%job, uncertainty_chart(run%job%units, range, k, run%model, statistics), &
                                'What uncertain data make of hook load and torque', 0, data, error)
               call add_picture(list, run%job, tornado_chart(run%job%units, uncertainty, k, statistics), &
                                'What matters most: hook load and torque by one standard deviation of each input', 0, shares, &
                                error)
            end do
         end associate
      end do
   end subroutine add_pictures
end module dg_uncertainty_study
