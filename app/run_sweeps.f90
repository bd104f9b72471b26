!> Runs the sweeps of a deck: on all cores, in parts where asked for, from where an interrupted run stopped.
module dg_run_sweeps
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged, result_not_converged
   use dg_diagnostic, only: tell
   use dg_error, only: error_type, raise, status_failure
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: job_type, model_mcge, model_name, model_soft
   use dg_load_case, only: operation_label
   use dg_missing, only: is_missing, missing
   use dg_model, only: copy_without_cases, model_type, string_index
   use dg_model_text, only: sweep_lines
   use dg_part_faults, only: part_faults_type
   use dg_printed_text, only: print_and_keep, print_line, printed_text_type
   use dg_progress, only: end_progress, progress_type, seconds_between, show_progress, start_progress
   use dg_rig, only: indicated_load
   use dg_run_outcome, only: note_sweep
   use dg_solve_case, only: solve_case
   use dg_sweep, only: point_at, point_case, point_count, point_holes, point_type, sweep_type
   use dg_sweep_file, only: write_sweep
   use dg_sweep_record, only: keep, keeper_type, open_record, take_parts, tell_failed, tell_taken, write_record
   use dg_sweep_result, only: is_solved, sweep_result_type
   use dg_sweep_table, only: sweep_table
   use dg_sweep_work, only: in_part
   use dg_text, only: append_text, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_threads, only: thread_count
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: sweep_run_type, prepare_sweeps, run_sweep

   !> A sweep with its results as far as they are there.
   type :: sweep_run_type
      type(keeper_type) :: keeper
      type(sweep_result_type), allocatable :: points(:)
   end type sweep_run_type

   !> Most points that a thread solves before it hands over their results.
   integer, parameter :: block_size = 16

contains

   !> Looks for what earlier runs have left: records of interrupted ones, or all parts where they are to be joined, with
   !> their faults. An error (bad input) where a record does not fit the deck.
   subroutine prepare_sweeps(job, model, runs, faults, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(sweep_run_type), allocatable, intent(out) :: runs(:)
      type(part_faults_type), intent(inout) :: faults    !< of parts that are to be joined
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      allocate (runs(size(job%sweeps)))
      do i = 1, size(runs)
         associate (sweep => job%sweeps(i), run => runs(i))
            allocate (run%points(point_count(sweep)))
            if (job%merge > 0) then
               call take_parts(job, 'sweep', sweep%name, sweep_lines(model, sweep), run%points, faults)
            else
               call open_record(job, 'sweep', sweep%name, sweep_lines(model, sweep), run%points, run%keeper, error)
            end if
         end associate
         if (allocated(error)) return
      end do
   end subroutine prepare_sweeps

   !> Solves what is left of a sweep, writes and prints it. `lost` counts the points without solution.
   subroutine run_sweep(printed, job, model, number, run, lost, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: number                !< of the sweep in the job
      type(sweep_run_type), intent(inout) :: run
      integer, intent(out) :: lost
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: resumed
      real(wp) :: seconds
      associate (sweep => job%sweeps(number))
         resumed = count(is_solved(run%points))
         if (job%merge == 0) call tell_taken(run%keeper, 'sweep '//quoted(sweep%name), run%points, job%again)
         seconds = 0.0_wp
         if (job%merge == 0) call solve_points(job, model, sweep, run, seconds)
         lost = count(run%points%status == result_not_converged)
         if (lost > 0) call tell_lost(job%units, sweep, run%points, lost)
         if (.not. is_interrupted()) call tell_failed('sweep '//quoted(sweep%name), run%points, max(job%parts, job%merge))
         if (job%merge == 0 .and. is_interrupted()) then
            call write_record(run%keeper, run%points, error)
            if (.not. allocated(error)) call raise(error, status_failure, 'sweep '//quoted(sweep%name)//': ended by '// &
               interruption_name()//' with '//to_text(count(is_solved(run%points)))//' of '//to_text(size(run%points))// &
               ' points solved; the same command goes on from there ('//run%keeper%path//')')
            return
         end if
         if (job%parts > 0) then
            call write_record(run%keeper, run%points, error)
            if (.not. allocated(error)) call print_line('Sweep '//sweep%name//', part '//to_text(job%part)// &
               ' of '//to_text(job%parts)//': '//to_text(count(is_solved(run%points)))//' of '// &
               to_text(size(run%points))//' points, in '//run%keeper%path)
            return
         end if
         call note_sweep(printed%outcome, sweep, run%points)
         call add_indicator(model, sweep, run%points)
         call add_margins(job, model, sweep, run%points)
         call write_sweep(job%output_dir//'/sweep_'//sweep%name//'.csv', job, sweep, run%points, error)
         if (allocated(error)) return
         allocate (lines, source=sweep_table(job%units, sweep, run%points))
         if (any(run%points%earlier)) call append_text(lines, to_text(count(run%points%earlier))//' of '// &
            to_text(size(run%points))//' points were found with other settings of the solver, by a run before --again')
         call print_and_keep(printed, lines)
         if (job%merge > 0) then
            call print_line(to_text(size(run%points))//' points, joined from '//to_text(job%merge)//' parts')
         else
            call print_line(to_text(size(run%points) - resumed)//' points solved in '//to_text(seconds, 3)//' s')
         end if
      end associate
   end subroutine run_sweep

   !> What the rig shows of points that are solved.
   subroutine add_indicator(model, sweep, points)
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(inout) :: points(:)
      type(point_type) :: place
      integer :: i
      if (.not. model%rig%given) return
      do i = 1, size(points)
         place = point_at(sweep, i)
         points(i)%weight_indicator = indicated_load(model%rig, sweep%operations(place%operation), points(i)%hookload)
      end do
   end subroutine add_indicator

   !> What is left to the limits of rig and string. The pull until something yields is that of the soft string, which has a force
   !> at every depth in microseconds.
   subroutine add_margins(job, model, sweep, points)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(inout) :: points(:)
      logical :: yields
      associate (rig => model%rig)
         where (points%status == result_converged)
            points%rig_margin = merge(rig%max_hookload%value - rig%block_weight - points%hookload, missing, &
                                      rig%max_hookload%present)
            points%torque_margin = merge(rig%max_torque%value - points%torque, missing, rig%max_torque%present)
         end where
      end associate
      yields = any(model%strings(string_index(model%strings, sweep%string))%components%yield > 0.0_wp)
      if (.not. yields) return
      !$omp parallel num_threads(thread_count(job%threads, size(points)/block_size)) default(shared)
      call share_pulls()
      !$omp end parallel
   contains
      subroutine share_pulls()
         type(model_type) :: mine
         type(case_result_type) :: result
         type(along_string_type) :: along
         type(error_type), allocatable :: error
         integer :: i
         call copy_without_cases(model, mine)
         !$omp do schedule(dynamic, block_size)
         do i = 1, size(points)
            if (points(i)%status /= result_converged .or. is_interrupted()) cycle
            call point_case(sweep, point_at(sweep, i), mine%cases(1))
            call point_holes(sweep, point_at(sweep, i), mine%holes)
            call solve_case(mine, model_soft, 1, result, error)
            if (result%status /= result_converged) cycle
            call find_along_string(mine, result, along)
            if (all(is_missing(along%overpull))) cycle
            points(i)%overpull_margin = minval(along%overpull, mask=.not. is_missing(along%overpull))
         end do
         !$omp end do
      end subroutine share_pulls
   end subroutine add_margins

   !> Solves the points of this part that have no result yet, as many at a time as the job allows. Points do not know of each
   !> other: results do not depend on the number of threads, nor on what was solved before.
   subroutine solve_points(job, model, sweep, run, seconds)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(sweep_run_type), intent(inout) :: run
      real(wp), intent(out) :: seconds
      type(progress_type) :: progress
      integer, allocatable :: left(:), blocks(:)
      real(wp) :: work, done, before
      integer(int64) :: start, finish
      integer :: i, solved
      call system_clock(start)
      left = pack([(i, i=1, size(run%points))], .not. is_solved(run%points) .and. &
                  in_part([(i, i=1, size(run%points))], job%part, max(job%parts, 1)))
      blocks = starts_of_blocks(sweep, left)
      ! a deep string costs more than a shallow one, about in proportion
      work = sum_of_depths(sweep, job)
      done = work - sum([(depth_of(sweep, left(i)), i=1, size(left))])
      before = done/work
      solved = count(is_solved(run%points))
      call start_progress(progress, 'sweep '//sweep%name, job%quiet)
      !$omp parallel num_threads(thread_count(job%threads, size(blocks) - 1)) default(shared)
      call share_points()
      !$omp end parallel
      call end_progress(progress)
      if (allocated(run%keeper%failure)) call tell(run%keeper%failure%message)
      call system_clock(finish)
      seconds = seconds_between(start, finish)

   contains

      !> What one thread does: with a model of its own, whose one load case becomes point after point.
      subroutine share_points()
         type(model_type) :: mine
         type(sweep_result_type) :: found(block_size)
         integer :: block, k, first, last
         call copy_without_cases(model, mine)
         !$omp do schedule(dynamic, 1)
         do block = 1, size(blocks) - 1
            first = blocks(block)
            last = blocks(block + 1) - 1
            do k = first, last
               call solve_point(mine, sweep, point_at(sweep, left(k)), found(k - first + 1))
            end do
            ! the list of all points is touched here only: its record is written from it
            !$omp critical (sweep_results)
            do k = first, last
               if (.not. is_solved(found(k - first + 1))) cycle      ! a signal came
               run%points(left(k)) = found(k - first + 1)
               done = done + depth_of(sweep, left(k))
               solved = solved + 1
               call keep(run%keeper, left(k), run%points)
            end do
            call show_progress(progress, done/work, before, to_text(solved)//' of '//to_text(size(run%points))//' points')
            !$omp end critical (sweep_results)
         end do
         !$omp end do
      end subroutine share_points
   end subroutine solve_points

   !> Where blocks of points begin that a thread solves before it hands over the results, and the end of the last + 1. Beams
   !> go one by one; the other models take microseconds, less than the threads would wait for each other.
   pure function starts_of_blocks(sweep, left) result(starts)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: left(:)       !< numbers of points, ascending
      integer, allocatable :: starts(:)
      type(point_type) :: point
      integer :: k, n
      allocate (starts(size(left) + 1))
      n = 0
      k = 1
      do while (k <= size(left))
         n = n + 1
         starts(n) = k
         point = point_at(sweep, left(k))
         k = k + merge(1, block_size, sweep%models(point%model) == model_mcge)
      end do
      n = n + 1
      starts(n) = size(left) + 1
      starts = starts(:n)
   end function starts_of_blocks

   !> Solves one point.
   subroutine solve_point(model, sweep, point, found)
      type(model_type), intent(inout) :: model     !< its first load case is overwritten
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(sweep_result_type), intent(out) :: found
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call point_case(sweep, point, model%cases(1))
      call point_holes(sweep, point, model%holes)
      call solve_case(model, sweep%models(point%model), 1, result, error, totals_only=.true.)
      ! a signal in the midst of a point leaves it for the next run
      if (is_interrupted() .and. result%status == result_not_converged) return
      found%status = result%status
      found%hookload = result%hookload
      found%torque = result%torque
      if (result%message /= '') found%message = result%message
   end subroutine solve_point

   !> Bit depth of a point [m].
   pure function depth_of(sweep, number) result(depth)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number
      real(wp) :: depth
      depth = sweep%depths(modulo(number - 1, size(sweep%depths)) + 1)
   end function depth_of

   !> Sum of the bit depths of all points of this part [m].
   pure function sum_of_depths(sweep, job) result(depths)
      type(sweep_type), intent(in) :: sweep
      type(job_type), intent(in) :: job
      real(wp) :: depths
      integer :: i
      depths = 0.0_wp
      do i = job%part, point_count(sweep), max(job%parts, 1)
         depths = depths + depth_of(sweep, i)
      end do
   end function sum_of_depths

   !> Tells how many points have no solution, and why the first has none.
   subroutine tell_lost(units, sweep, points, lost)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: lost
      type(point_type) :: first
      character(:), allocatable :: text
      integer :: i
      do i = 1, size(points)
         if (points(i)%status == result_not_converged) exit
      end do
      first = point_at(sweep, i)
      text = 'sweep '//quoted(sweep%name)//': '//to_text(lost)//' of '//to_text(count(is_solved(points)))// &
         ' points did not converge; the first: '//trim(model_name(sweep%models(first%model)))//', '// &
         trim(operation_label(sweep%operations(first%operation)))
      if (sweep%frictions(first%friction)%present) text = text//', friction '//to_text(sweep%frictions(first%friction)%value)
      text = text//', bit at '//trim(in_units(units, unit_length, sweep%depths(first%depth), 7))
      if (allocated(points(i)%message)) text = text//': '//points(i)%message
      call tell(text)
   end subroutine tell_lost
end module dg_run_sweeps
