!> &sweep: hook load and torque over bit depth.
module dg_sweep_study
   use dg_column, only: fields_of
   use dg_deck_draft, only: deck_type, note_use
   use dg_deck_schema, only: add_group, group_keys_type
   use dg_deck_sweep, only: take_sweeps
   use dg_ensemble_study, only: ensemble_study_type
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_type
   use dg_fault_list, only: fault_list_type
   use dg_job, only: job_type, model_name
   use dg_line_list, only: line_list_type
   use dg_model, only: model_type
   use dg_model_text, only: sweep_lines
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_sweep_keys, only: sweep_keys, sweep_rule
   use dg_range_text, only: range_text_type
   use dg_result_name, only: points_file
   use dg_study, only: run_type
   use dg_sweep, only: model_of, point_at, point_count, sweep_type
   use dg_sweep_echo, only: add_sweeps
   use dg_sweep_file, only: sweep_row, write_sweep
   use dg_sweep_outcome, only: note_sweep
   use dg_sweep_picture, only: sweep_chart
   use dg_sweep_points, only: add_indicator, add_limits, add_margins, point_text, solve_points
   use dg_sweep_table, only: sweep_sentences, sweep_table
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: sweep_study_type

   type, extends(ensemble_study_type) :: sweep_study_type
      type(sweep_type), allocatable :: sweeps(:)
   contains
      procedure :: add_groups
      procedure :: read => read_sweeps
      procedure :: echo
      procedure :: add_pictures
      procedure :: range_count
      procedure :: texts
      procedure :: range => depth_range
      procedure :: points_of
      procedure :: settings
      procedure :: solve
      procedure :: report
      procedure :: place
   end type sweep_study_type

   !> Columns of the table beneath the picture.
   character(*), parameter :: shown(14) = [character(24) :: 'operation', 'friction', 'friction_cased', 'bit_depth', &
      'hookload', 'weight_indicator', 'torque', 'overpull_margin', 'rig_margin', 'torque_margin', 'measured_hookload', &
      'measured_torque', 'error', 'can_be_done']

contains

   !> Its group.
   subroutine add_groups(self, groups)
      class(sweep_study_type), intent(in) :: self
      type(group_keys_type), allocatable, intent(inout) :: groups(:)
      associate (not_needed => self)
         call add_group(groups, sweep_rule, sweep_keys)
      end associate
   end subroutine add_groups

   !> Reads its groups.
   subroutine read_sweeps(self, deck, job, notes, faults)
      class(sweep_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(inout) :: notes(:)
      type(fault_list_type), intent(inout) :: faults
      integer :: i
      call take_sweeps(deck%draft, deck%groups, job%models, self%sweeps, notes, faults)
      do i = 1, size(self%sweeps)
         if (allocated(self%sweeps(i)%depths)) call note_use(deck, self%sweeps(i)%string, maxval(self%sweeps(i)%depths))
      end do
   end subroutine read_sweeps

   !> A line a sweep.
   subroutine echo(self, job, lines)
      class(sweep_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      call add_sweeps(lines, self%sweeps, job%units)
   end subroutine echo

   !> How many there are.
   pure function range_count(self) result(number)
      class(sweep_study_type), intent(in) :: self
      integer :: number
      number = size(self%sweeps)
   end function range_count

   !> What it is called.
   function texts(self)
      class(sweep_study_type), intent(in) :: self
      type(range_text_type) :: texts
      associate (not_needed => self)
         texts%what = 'sweep'
         texts%points = 'points'
         texts%points_solved = 'points solved'
         texts%left_out = ''
         texts%fewer = 'fewer frictions or a larger bit_depth_step'
      end associate
   end function texts

   !> Its depths.
   function depth_range(self, number) result(range)
      class(sweep_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(sweep_type) :: range
      range = self%sweeps(number)
   end function depth_range

   !> Points of all models, operations, frictions and depths.
   pure function points_of(self, number) result(points)
      class(sweep_study_type), intent(in) :: self
      integer, intent(in) :: number
      integer :: points
      points = point_count(self%sweeps(number))
   end function points_of

   !> All that its results depend on.
   function settings(self, number, model) result(lines)
      class(sweep_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(model_type), intent(in) :: model
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=sweep_lines(model, self%sweeps(number)))
   end function settings

   !> Solves what is left.
   subroutine solve(self, number, run, watch)
      class(sweep_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(in) :: run
      class(ensemble_watch_type), intent(inout) :: watch
      call solve_points(run%job, run%model, self%sweeps(number), self%ensembles(number), watch)
   end subroutine solve

   !> What follows from the points: margins, its file, its table.
   subroutine report(self, number, run, lines, error)
      class(sweep_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(inout) :: run
      type(text_type), allocatable, intent(out) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      associate (sweep => self%sweeps(number), points => self%ensembles(number)%points)
         call add_indicator(run%model, sweep, 1, points)
         call add_margins(run%job, run%model, sweep, points)
         call add_limits(run%job, run%model, sweep, points)
         call note_sweep(run%printed%outcome, sweep, points, sweep_sentences(run%job%units, sweep, points))
         call write_sweep(run%job%output_dir//'/'//points_file('sweep', sweep%name), run%job, sweep, points, error)
         if (.not. allocated(error)) allocate (lines, source=sweep_table(run%job%units, sweep, points))
      end associate
   end subroutine report

   !> A point in words.
   function place(self, number, point, units) result(text)
      class(sweep_study_type), intent(in) :: self
      integer, intent(in) :: number, point
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      text = point_text(units, self%sweeps(number), point)
   end function place

   !> A broomstick for each sweep and model.
   subroutine add_pictures(self, run, list, error)
      class(sweep_study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      type(picture_data_type) :: data
      character(:), allocatable :: model
      integer, allocatable :: rows(:)
      integer :: i, k, r
      do i = 1, size(self%sweeps)
         associate (sweep => self%sweeps(i))
            do k = 1, size(sweep%models)
               model = trim(model_name(sweep%models(k)))
               call picked_rows(points_file('sweep', sweep%name), [(model_of(sweep, r) == k, r=1, point_count(sweep))], data, &
                                rows)
               do r = 1, size(rows)
                  data%rows(r) = fields_of(sweep_row(sweep, point_at(sweep, rows(r)), self%ensembles(i)%points(rows(r))), shown)
               end do
               call add_picture(list, run%job, sweep_chart(run%job%units, sweep, k, run%model, self%ensembles(i)%points), &
                                'Hook load and torque against bit depth, sweep '//sweep%name//', model '//model, 0, data, error)
            end do
         end associate
      end do
   end subroutine add_pictures
end module dg_sweep_study
