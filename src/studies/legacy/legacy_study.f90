!> &legacy: lays other programs' results beside ours.
module dg_legacy_study
   use dg_column, only: fields_of, add, quantity_force, quantity_length, quantity_line_load, quantity_moment, quantity_text, &
                        row_type
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_deck_draft, only: deck_type
   use dg_deck_legacy, only: read_legacy
   use dg_error, only: error_list_type, error_type
   use dg_exit_status, only: note_failure
   use dg_job, only: job_type, model_name
   use dg_legacy_comparison, only: comparison_type, compare_with_legacy, legacy_table_type, quantity_count, quantity_axial, &
                                   quantity_side_force, quantity_torque
   use dg_legacy_picture, only: legacy_chart
   use dg_legacy_report, only: legacy_report
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_picture_list, only: add_picture, picture_list_type
   use dg_printed_text, only: print_and_keep
   use dg_study, only: run_type, study_type
   use dg_text, only: append_text, text_list, text_type
   use dg_comparison, only: difference
   use dg_hole_interval, only: interval_at, interval_name
   implicit none
   private
   public :: legacy_study_type

   type, extends(study_type) :: legacy_study_type
      private
      type(legacy_table_type), allocatable :: tables(:)
   contains
      procedure :: read => read_tables
      procedure :: run => compare_tables
      procedure :: add_pictures
   end type legacy_study_type

   !> Values of a row for a quantity that no program gives.
   real(wp), parameter :: nothing(quantity_count) = missing
   !> Columns of the table beneath the picture.
   character(*), parameter :: shown(12) = [character(24) :: 'model', 'md', 'hole', 'axial', 'legacy_axial', &
      'axial_difference', 'torque', 'legacy_torque', 'torque_difference', 'side_force', 'legacy_side_force', &
      'side_force_difference']

contains

   !> Reads its groups, with the files that they name.
   subroutine read_tables(self, deck, job, faults)
      class(legacy_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      integer :: i
      call read_legacy(deck%draft, deck%groups, self%tables, faults)
      self%asked = size(self%tables) > 0
      self%forms = text_list('legacy_*.csv')
      allocate (self%files(0))
      do i = 1, size(self%tables)
         call append_text(self%files, file_of(self%tables(i)))
         call append_text(deck%inputs, self%tables(i)%file)
         if (self%tables(i)%skipped /= '') &
            call append_text(job%notes, 'legacy '//self%tables(i)%file//': '//self%tables(i)%skipped)
      end do
   end subroutine read_tables

   !> Each table beside all results of its case.
   subroutine compare_tables(self, run, error)
      class(legacy_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: failure
      integer :: i
      do i = 1, size(self%tables)
         call compare_one(self%tables(i), run, failure)
         call note_failure(failure, run%status)
      end do
      if (allocated(error)) return
   end subroutine compare_tables

   !> One table beside all results of its case: printed, written to legacy_<label>.csv.
   subroutine compare_one(table, run, error)
      type(legacy_table_type), intent(in) :: table
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(comparison_type) :: comparisons(size(run%results))
      type(csv_table_type) :: rows
      type(text_type), allocatable :: lines(:)
      integer :: i, k
      call compare_all(table, run, comparisons)
      associate (results => run%results, case => run%model%cases(table%case_index))
         call begin_table(rows, legacy_row(case%name, run%job%models(1), missing, '', nothing, nothing), run%job%units)
         do i = 1, size(results)
            if (results(i)%case_index /= table%case_index) cycle
            lines = legacy_report(run%job%units, table, case%name, results(i)%model, results(i)%status, comparisons(i), &
                                  results(i)%model == run%job%models(1))
            call print_and_keep(run%printed, lines)
            if (.not. allocated(comparisons(i)%md)) cycle
            do k = 1, size(comparisons(i)%md)
               call add_row(rows, row_of_depth(case%name, results(i)%model, comparisons(i), k), run%job%units)
            end do
         end do
      end associate
      call write_table(rows, run%job%output_dir//'/'//file_of(table), error)
   end subroutine compare_one

   !> A table beside each result of its case; others get no depths.
   subroutine compare_all(table, run, comparisons)
      type(legacy_table_type), intent(in) :: table
      type(run_type), intent(in) :: run
      type(comparison_type), intent(out) :: comparisons(:)     !< one a result
      integer :: i
      do i = 1, size(comparisons)
         associate (result => run%results(i))
            if (result%case_index == table%case_index .and. allocated(result%profile%md)) &
               call compare_with_legacy(table, result%profile, run%model%trajectory, comparisons(i))
         end associate
      end do
   end subroutine compare_all

   !> Some rows of the file for the page.
   function page_rows(table, run) result(data)
      type(legacy_table_type), intent(in) :: table
      type(run_type), intent(in) :: run
      type(picture_data_type) :: data
      type(comparison_type) :: comparisons(size(run%results))
      integer, allocatable :: owner(:), depth(:), rows(:)
      integer :: i, k
      call compare_all(table, run, comparisons)
      allocate (owner(0), depth(0))
      do i = 1, size(comparisons)
         if (.not. allocated(comparisons(i)%md)) cycle
         owner = [owner, spread(i, 1, size(comparisons(i)%md))]
         depth = [depth, (k, k=1, size(comparisons(i)%md))]
      end do
      call picked_rows(file_of(table), owner > 0, data, rows)
      do i = 1, size(rows)
         data%rows(i) = fields_of(row_of_depth(run%model%cases(table%case_index)%name, run%results(owner(rows(i)))%model, &
                                               comparisons(owner(rows(i))), depth(rows(i))), shown)
      end do
   end function page_rows

   !> A picture for each table.
   subroutine add_pictures(self, run, list, error)
      class(legacy_study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      integer :: i
      if (run%job%merge > 0) return
      do i = 1, size(self%tables)
         associate (table => self%tables(i))
            call add_picture(list, run%job, legacy_chart(run%job, run%model, table, run%results), &
                             'Our results of '//run%model%cases(table%case_index)%name//' and those of '//table%label, 0, &
                             page_rows(table, run), error)
         end associate
      end do
   end subroutine add_pictures

   pure function file_of(table) result(name)
      type(legacy_table_type), intent(in) :: table
      character(:), allocatable :: name
      name = 'legacy_'//table%label//'.csv'
   end function file_of

   !> A depth of a comparison in the columns of the file.
   pure function row_of_depth(case_name, model, comparison, number) result(row)
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      type(comparison_type), intent(in) :: comparison
      integer, intent(in) :: number                       !< of the depth
      type(row_type) :: row
      associate (md => comparison%md(number), intervals => comparison%intervals)
         row = legacy_row(case_name, model, md, interval_name(intervals(interval_at(intervals, md))%kind), &
                          comparison%ours(number, :), &
                          merge(comparison%theirs(number, :), missing, comparison%parting%present))
      end associate
   end function row_of_depth

   !> A row of the file.
   pure function legacy_row(case_name, model, md, hole, ours, theirs) result(row)
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      real(wp), intent(in) :: md                          !< [m]
      character(*), intent(in) :: hole                    !< kind of hole there
      real(wp), intent(in) :: ours(:), theirs(:)          !< by quantity; theirs missing where the table has none [N, N.m, N/m]
      type(row_type) :: row
      call add(row, 'case', quantity_text, 'name of the load case', case_name)
      call add(row, 'model', quantity_text, 'as in summary.csv', model_name(model))
      call add(row, 'md', quantity_length, 'measured depth, of the other program''s row', md)
      call add(row, 'hole', quantity_text, &
               'kind of hole there: vertical (to 1 deg), build, hold, drop, turn (0.25 deg/30 m and less is held)', hole)
      call add(row, 'axial', quantity_force, 'axial force of drillgap, interpolated', ours(quantity_axial))
      call add(row, 'legacy_axial', quantity_force, 'value of the other program', theirs(quantity_axial))
      call add(row, 'axial_difference', quantity_force, '', difference(theirs(quantity_axial), ours(quantity_axial)))
      call add(row, 'torque', quantity_moment, 'torque of drillgap', ours(quantity_torque))
      call add(row, 'legacy_torque', quantity_moment, 'value of the other program', theirs(quantity_torque))
      call add(row, 'torque_difference', quantity_moment, '', difference(theirs(quantity_torque), ours(quantity_torque)))
      call add(row, 'side_force', quantity_line_load, 'contact force per length of drillgap', ours(quantity_side_force))
      call add(row, 'legacy_side_force', quantity_line_load, 'value of the other program', theirs(quantity_side_force))
      call add(row, 'side_force_difference', quantity_line_load, &
               '', difference(theirs(quantity_side_force), ours(quantity_side_force)))
   end function legacy_row
end module dg_legacy_study
