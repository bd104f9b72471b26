!> &sweep: hook load and torque over bit depth.
module dg_sweep_study
   use dg_column, only: fields_of
   use dg_deck_draft, only: deck_type
   use dg_deck_range, only: note_range_use
   use dg_deck_sweep, only: read_sweep_groups
   use dg_ensemble_study, only: ensemble_study_type, name_ranges, range_text_type
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_list_type, error_type
   use dg_job, only: job_type, model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_result_name, only: points_file
   use dg_study, only: run_type
   use dg_sweep, only: model_of, point_at, point_count
   use dg_sweep_file, only: sweep_row
   use dg_point_outcome, only: note_sweep
   use dg_sweep_picture, only: sweep_chart
   use dg_sweep_points, only: add_indicator, add_limits, solve_points
   use dg_sweep_sentences, only: sweep_sentences
   use dg_sweep_table, only: sweep_table
   use dg_text, only: joined, text_type, to_text
   use dg_load_case, only: operation_name
   use dg_kinds, only: wp
   use dg_csv_table, only: add_row, csv_table_type, write_table
   implicit none
   private
   public :: sweep_study_type

   type, extends(ensemble_study_type) :: sweep_study_type
   contains
      procedure :: read => read_sweeps
      procedure :: echo
      procedure :: add_pictures
      procedure :: solve
      procedure :: report
   end type sweep_study_type

   !> Significant digits of a depth.
   integer, parameter :: digits = 7
   !> Columns of the table beneath the picture.
   character(*), parameter :: shown(14) = [character(24) :: 'operation', 'friction', 'friction_cased', 'bit_depth', &
      'hookload', 'weight_indicator', 'torque', 'overpull_margin', 'rig_margin', 'torque_margin', 'measured_hookload', &
      'measured_torque', 'error', 'can_be_done']

contains

   !> Reads its groups.
   subroutine read_sweeps(self, deck, job, faults)
      class(sweep_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      integer :: i
      call read_sweep_groups(deck%draft, deck%groups, job%models, self%ranges, job%notes, faults)
      call name_ranges(self, range_text_type('sweep', 'points', 'points solved', '', &
                                             'fewer frictions or a larger bit_depth_step'), spread(1, 1, size(self%ranges)))
      do i = 1, size(self%ranges)
         call note_range_use(deck, self%ranges(i), 'sweep')
      end do
   end subroutine read_sweeps

   !> A line a sweep.
   subroutine echo(self, job, lines)
      class(sweep_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      character(:), allocatable :: factors
      integer :: i, k
      do i = 1, size(self%ranges)
         associate (sweep => self%ranges(i))
            factors = ''
            do k = 1, size(sweep%frictions)
               if (sweep%frictions(k)%present) factors = factors//' '//to_text(sweep%frictions(k)%value)
               if (allocated(sweep%frictions_cased)) factors = factors//' (cased '//to_text(sweep%frictions_cased(k))//')'
            end do
            if (factors == '') factors = ' of the hole'
            call add_line(lines, 'sweep       '//sweep%name//': '//joined(model_name(sweep%models), ', ')//'; '// &
               joined(operation_name(sweep%operations), ', ')//'; friction'//factors//'; string '//sweep%string//'; '// &
               to_text(size(sweep%depths))//' depths, '//shown(sweep%depths(1))//' to '// &
               shown(sweep%depths(size(sweep%depths)))//' '//trim(job%units%length_label)//'; '// &
               to_text(point_count(sweep))//' points, '//to_text(size(sweep%measured))//' measured')
         end associate
      end do
   contains
      pure function shown(depth) result(text)
         real(wp), intent(in) :: depth     !< [m]
         character(:), allocatable :: text
         text = to_text(depth/job%units%length, digits)
      end function shown
   end subroutine echo

   !> Solves what is left.
   subroutine solve(self, number, run, watch)
      class(sweep_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(in) :: run
      class(ensemble_watch_type), intent(inout) :: watch
      call solve_points(run%job, run%model, self%ranges(number), self%ensembles(number), watch)
   end subroutine solve

   !> Report the points: margins, the file, the table.
   subroutine report(self, number, run, lines, error)
      class(sweep_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(inout) :: run
      type(text_type), allocatable, intent(out) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      integer :: i
      associate (sweep => self%ranges(number), points => self%ensembles(number)%points)
         call add_indicator(run%model, sweep, 1, points)
         call add_limits(run%job, run%model, sweep, points)
         call note_sweep(run%printed%outcome, sweep, points, sweep_sentences(run%job%units, sweep, points))
         do i = 1, size(points)
            call add_row(table, sweep_row(sweep, point_at(sweep, i), points(i)), run%job%units)
         end do
         call write_table(table, run%job%output_dir//'/'//points_file('sweep', sweep%name), error)
         if (.not. allocated(error)) allocate (lines, source=sweep_table(run%job%units, sweep, points))
      end associate
   end subroutine report

   !> A broomstick for each sweep of several depths and model.
   subroutine add_pictures(self, run, list, error)
      class(sweep_study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      type(picture_data_type) :: data
      character(:), allocatable :: model
      integer, allocatable :: rows(:)
      integer :: i, k, r
      do i = 1, size(self%ranges)
         associate (sweep => self%ranges(i))
            if (size(sweep%depths) == 1) cycle
            do k = 1, size(sweep%models)
               model = trim(model_name(sweep%models(k)))
               call picked_rows(points_file('sweep', sweep%name), [(model_of(sweep, r) == k, r=1, point_count(sweep))], data, &
                                rows)
               do r = 1, size(rows)
                  data%rows(r) = fields_of(sweep_row(sweep, point_at(sweep, rows(r)), self%ensembles(i)%points(rows(r))), shown)
               end do
               call add_picture(list, run%job, sweep_chart(run%job%units, sweep, k, run%model, self%ensembles(i)%points), &
                                'Hook load and torque against bit depth', 0, data, error)
            end do
         end associate
      end do
   end subroutine add_pictures
end module dg_sweep_study
