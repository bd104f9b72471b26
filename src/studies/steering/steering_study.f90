!> &steering: direction of drilling of assemblies, each load case at each tool face.
module dg_steering_study
   use dg_kinds, only: wp
   use dg_case_result, only: result_not_converged
   use dg_deck_draft, only: deck_type
   use dg_deck_steering, only: read_steering_group
   use dg_diagnostic, only: report_line
   use dg_equilibrium_curvature, only: find_equilibrium_curvature
   use dg_error, only: error_list_type, error_type, status_not_converged
   use dg_exit_status, only: graver
   use dg_interruption, only: is_interrupted
   use dg_job, only: job_type
   use dg_line_list, only: add_line, line_list_type
   use dg_missing, only: is_missing, missing
   use dg_printed_text, only: print_and_keep
   use dg_run_outcome, only: add_part, note_lost
   use dg_steering, only: steering_result_type, steering_type
   use dg_steering_table, only: steering_table, steering_row
   use dg_study, only: run_type, study_type
   use dg_text, only: either, quoted, text_list, text_type, to_text
   use dg_threads, only: thread_count
   use dg_csv_table, only: add_row, csv_table_type, write_table
   use dg_unusual_tool, only: note_radians
   use dg_usual_range, only: note_range, usual_enlargement, usual_side_cutting
   implicit none
   private
   public :: steering_study_type

   type, extends(study_type) :: steering_study_type
      private
      type(steering_type), allocatable :: steering
   contains
      procedure :: read => read_steering
      procedure :: run => run_steering
      procedure :: echo
   end type steering_study_type

   character(*), parameter :: file = 'steering.csv'

contains

   !> Reads its group.
   subroutine read_steering(self, deck, job, faults)
      class(steering_study_type), intent(inout) :: self
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(error_list_type), intent(inout) :: faults
      call read_steering_group(deck%draft, deck%groups, self%steering, faults)
      self%asked = allocated(self%steering)
      if (self%asked) then
         call note_radians(self%steering%toolfaces, job%notes)
         if (self%steering%hole_enlargement > 0.0_wp) call note_range(deck%draft%units, 'group &steering', usual_enlargement, &
                                                                      self%steering%hole_enlargement, job%notes)
         if (self%steering%side_cutting%present) call note_range(deck%draft%units, 'group &steering', usual_side_cutting, &
                                                                 self%steering%side_cutting%value, job%notes)
      end if
      self%files = text_list(file)
      self%forms = self%files
   end subroutine read_steering

   !> Add the number of cases and tool faces.
   subroutine echo(self, job, lines)
      class(steering_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      associate (not_needed => job)
         if (self%asked) call add_line(lines, 'steering    '//to_text(size(self%steering%cases))//' cases, '// &
            to_text(max(size(self%steering%toolfaces), 1))//' toolfaces')
      end associate
   end subroutine echo

   !> Solves, writes steering.csv, prints.
   subroutine run_steering(self, run, error)
      class(steering_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(steering_result_type), allocatable :: results(:)
      type(csv_table_type) :: table
      type(text_type), allocatable :: lines(:)
      integer :: i, lost
      if (is_interrupted()) return
      allocate (results(0))   ! the compiler's flow analysis takes it for undefined otherwise
      call solve_all(self%steering, run, results)
      if (is_interrupted()) return
      call once_each(results)
      call report_lost(run, results, lost)
      call add_part(run%printed%outcome, 'steering', size(results), 0, lost)
      do i = 1, size(results)
         call add_row(table, steering_row(run%model, results(i)), run%job%units)
      end do
      call write_table(table, run%job%output_dir//'/'//file, error)
      if (.not. allocated(error)) then
         allocate (lines, source=steering_table(run%job, run%model, self%steering%side_cutting, results))
         call print_and_keep(run%printed, lines)
      end if
      if (lost > 0) run%status = graver(run%status, status_not_converged)
   end subroutine run_steering

   !> Every case at every toolface, on all cores.
   subroutine solve_all(steering, run, results)
      type(steering_type), intent(in) :: steering
      type(run_type), intent(in) :: run
      type(steering_result_type), allocatable, intent(out) :: results(:)
      integer :: k, row, each
      each = max(size(steering%toolfaces), 1)
      allocate (results(each*size(steering%cases)))
      !$omp parallel do schedule(dynamic, 1) num_threads(thread_count(run%job%threads, size(results))) default(shared) &
      !$omp private(row, k)
      do row = 1, size(results)
         k = steering%cases((row - 1)/each + 1)
         call find_equilibrium_curvature(run%model, k, toolface_of(k, modulo(row - 1, each) + 1), steering%length, &
                                         steering%side_cutting, results(row), steering%hole_enlargement, &
                                         measured_of((row - 1)/each + 1))
      end do
      !$omp end parallel do
   contains
      pure function measured_of(place) result(dogleg)
         integer, intent(in) :: place
         real(wp) :: dogleg
         dogleg = missing
         if (size(steering%measured) > 0) dogleg = steering%measured(min(place, size(steering%measured)))
      end function measured_of

      pure function toolface_of(case_index, number) result(toolface)
         integer, intent(in) :: case_index, number
         real(wp) :: toolface
         toolface = run%model%cases(case_index)%toolface
         if (size(steering%toolfaces) > 0) toolface = steering%toolfaces(number)
      end function toolface_of
   end subroutine solve_all

   !> Report cases without a curvature, and those known roughly.
   subroutine report_lost(run, results, lost)
      type(run_type), intent(inout) :: run
      type(steering_result_type), intent(in) :: results(:)
      integer, intent(out) :: lost
      integer :: i
      lost = 0
      do i = 1, size(results)
         if (results(i)%found .and. len(results(i)%message) == 0) cycle
         if (.not. results(i)%found) then
            lost = lost + 1
            call note_lost(run%printed%outcome, 'steering', 0, result_not_converged, results(i)%message, &
                           run%model%cases(results(i)%case_index))
         end if
         call report_line('steering, case '//quoted(run%model%cases(results(i)%case_index)%name)// &
                          either(':', ': no curvature;', results(i)%found)//' '//results(i)%message)
      end do
   end subroutine report_lost

   !> A case that no toolface changes has one row.
   subroutine once_each(results)
      type(steering_result_type), allocatable, intent(inout) :: results(:)
      logical :: kept(size(results))
      type(steering_result_type), allocatable :: fewer(:)
      integer :: i, n
      kept = .true.
      do i = 2, size(results)
         kept(i) = .not. (is_missing(results(i)%toolface) .and. results(i)%case_index == results(i - 1)%case_index)
      end do
      allocate (fewer(count(kept)))
      n = 0
      do i = 1, size(results)
         if (.not. kept(i)) cycle
         n = n + 1
         fewer(n) = results(i)
      end do
      call move_alloc(fewer, results)
   end subroutine once_each
end module dg_steering_study
