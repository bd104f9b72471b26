!> Runs the Monte Carlo of a deck: on all cores, in parts where asked for, from where an interrupted run stopped.
module dg_run_uncertainties
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged, result_not_converged
   use dg_diagnostic, only: tell
   use dg_error, only: error_type, raise, status_failure
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: job_type, model_name
   use dg_load_case, only: operation_label
   use dg_model, only: model_type
   use dg_model_text, only: uncertainty_lines
   use dg_part_faults, only: part_faults_type
   use dg_printed_text, only: print_and_keep, print_line, printed_text_type
   use dg_progress, only: end_progress, progress_type, seconds_between, show_progress, start_progress
   use dg_rig, only: indicated_load
   use dg_run_outcome, only: note_uncertainty
   use dg_sample_statistics, only: find_point_statistics, point_statistics_type
   use dg_sampled_model, only: draw_model
   use dg_solve_case, only: solve_case
   use dg_sweep, only: point_at, point_case, point_count, point_type
   use dg_sweep_record, only: keep, keeper_type, open_record, take_parts, tell_failed, tell_taken, write_record
   use dg_sweep_result, only: is_solved, sweep_result_type
   use dg_sweep_work, only: in_part
   use dg_text, only: append_text, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_threads, only: thread_count
   use dg_uncertainty, only: piece_count, piece_number, uncertainty_type
   use dg_uncertainty_file, only: write_uncertainty
   use dg_uncertainty_table, only: uncertainty_table
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: uncertainty_run_type, prepare_uncertainties, run_uncertainty

   !> A Monte Carlo with its results as far as they are there: one a point and sample.
   type :: uncertainty_run_type
      type(keeper_type) :: keeper
      type(sweep_result_type), allocatable :: pieces(:)
   end type uncertainty_run_type

   character(*), parameter :: what = 'uncertainty'

contains

   !> Looks for what earlier runs have left: records of interrupted ones, or all parts where they are to be joined, with their
   !> faults. An error (bad input) where a record does not fit the deck.
   subroutine prepare_uncertainties(job, model, runs, faults, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(uncertainty_run_type), allocatable, intent(out) :: runs(:)
      type(part_faults_type), intent(inout) :: faults    !< of parts that are to be joined
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      allocate (runs(size(job%uncertainties)))
      do i = 1, size(runs)
         associate (uncertainty => job%uncertainties(i), run => runs(i))
            allocate (run%pieces(piece_count(uncertainty)))
            if (job%merge > 0) then
               call take_parts(job, what, uncertainty%range%name, uncertainty_lines(model, uncertainty), run%pieces, faults)
            else
               call open_record(job, what, uncertainty%range%name, uncertainty_lines(model, uncertainty), run%pieces, &
                                run%keeper, error)
            end if
         end associate
         if (allocated(error)) return
      end do
   end subroutine prepare_uncertainties

   !> Solves what is left, writes and prints. `lost` counts the solutions that were none.
   subroutine run_uncertainty(printed, job, model, number, run, lost, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: number                !< in the job
      type(uncertainty_run_type), intent(inout) :: run
      integer, intent(out) :: lost
      type(error_type), allocatable, intent(out) :: error
      type(point_statistics_type), allocatable :: statistics(:)
      type(text_type), allocatable :: lines(:)
      integer :: i, resumed
      real(wp) :: seconds
      associate (uncertainty => job%uncertainties(number))
         associate (name => uncertainty%range%name)
            resumed = count(is_solved(run%pieces))
            if (job%merge == 0) call tell_taken(run%keeper, what//' '//quoted(name), run%pieces, job%again)
            seconds = 0.0_wp
            if (job%merge == 0) call solve_samples(job, model, uncertainty, run, seconds)
            lost = count(run%pieces%status == result_not_converged)
            if (lost > 0) call tell_lost(job%units, uncertainty, run%pieces, lost)
            if (.not. is_interrupted()) call tell_failed(what//' '//quoted(name), run%pieces, max(job%parts, job%merge))
            if (job%merge == 0 .and. is_interrupted()) then
               call write_record(run%keeper, run%pieces, error)
               if (.not. allocated(error)) call raise(error, status_failure, what//' '//quoted(name)//': ended by '// &
                  interruption_name()//' with '//to_text(count(is_solved(run%pieces)))//' of '//to_text(size(run%pieces))// &
                  ' solutions; the same command goes on from there ('//run%keeper%path//')')
               return
            end if
            if (job%parts > 0) then
               call write_record(run%keeper, run%pieces, error)
               if (.not. allocated(error)) call print_line('Uncertainty '//name//', part '//to_text(job%part)//' of '// &
                  to_text(job%parts)//': '//to_text(count(is_solved(run%pieces)))//' of '//to_text(size(run%pieces))// &
                  ' solutions, in '//run%keeper%path)
               return
            end if
            call note_uncertainty(printed%outcome, uncertainty, run%pieces)
            allocate (statistics(point_count(uncertainty%range)))
            do i = 1, size(statistics)
               call add_indicator(model, uncertainty, i, run%pieces)
               statistics(i) = find_point_statistics(uncertainty, i, run%pieces)
            end do
            call write_uncertainty(job%output_dir//'/uncertainty_'//name//'.csv', job, uncertainty, statistics, error)
            if (allocated(error)) return
         end associate
         allocate (lines, source=uncertainty_table(job%units, uncertainty, statistics, model%rig%given))
         if (any(run%pieces%earlier)) call append_text(lines, to_text(count(run%pieces%earlier))//' of '// &
            to_text(size(run%pieces))//' solutions were found with other settings of the solver, by a run before --again')
         call print_and_keep(printed, lines)
         if (job%merge > 0) then
            call print_line(to_text(size(run%pieces))//' solutions, joined from '//to_text(job%merge)//' parts')
         else
            call print_line(to_text(size(run%pieces) - resumed)//' solutions in '//to_text(seconds, 3)//' s')
         end if
      end associate
   end subroutine run_uncertainty

   !> What the rig shows of all samples of a point.
   subroutine add_indicator(model, uncertainty, point, pieces)
      type(model_type), intent(in) :: model
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: point                 !< its number in the range
      type(sweep_result_type), intent(inout) :: pieces(:)
      type(point_type) :: place
      integer :: sample, piece
      if (.not. model%rig%given) return
      place = point_at(uncertainty%range, point)
      do sample = 1, uncertainty%samples
         piece = piece_number(uncertainty, point, sample)
         pieces(piece)%weight_indicator = indicated_load(model%rig, uncertainty%range%operations(place%operation), &
                                                         pieces(piece)%hookload)
      end do
   end subroutine add_indicator

   !> Solves what this part still lacks, sample after sample. What a sample draws depends on the seed and its number alone:
   !> results do not depend on the number of threads, on parts, nor on what was solved before.
   subroutine solve_samples(job, model, uncertainty, run, seconds)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(uncertainty_type), intent(in) :: uncertainty
      type(uncertainty_run_type), intent(inout) :: run
      real(wp), intent(out) :: seconds
      type(progress_type) :: progress
      logical, allocatable :: left(:)
      integer(int64) :: start, finish
      real(wp) :: before
      integer :: i, solved
      call system_clock(start)
      left = .not. is_solved(run%pieces) .and. in_part([(i, i=1, size(run%pieces))], job%part, max(job%parts, 1))
      solved = count(is_solved(run%pieces))
      before = share()
      call start_progress(progress, what//' '//uncertainty%range%name, job%quiet)
      !$omp parallel num_threads(thread_count(job%threads, uncertainty%samples)) default(shared)
      call share_samples()
      !$omp end parallel
      call end_progress(progress)
      if (allocated(run%keeper%failure)) call tell(run%keeper%failure%message)
      call system_clock(finish)
      seconds = seconds_between(start, finish)

   contains

      !> Part of the work of this part that is done [-].
      function share() result(done)
         real(wp) :: done
         done = real(solved, wp)*real(max(job%parts, 1), wp)/real(size(run%pieces), wp)
      end function share

      !> What one thread does.
      subroutine share_samples()
         type(model_type) :: mine
         type(error_type), allocatable :: no_path
         type(sweep_result_type) :: found(point_count(uncertainty%range))
         integer :: point, sample, piece
         !$omp do schedule(dynamic, 1)
         do sample = 1, uncertainty%samples
            if (is_interrupted()) cycle
            if (.not. any(left([(piece_number(uncertainty, point, sample), point=1, size(found))]))) cycle
            call draw_model(model, uncertainty, sample, mine, no_path)
            do point = 1, size(found)
               if (.not. left(piece_number(uncertainty, point, sample))) cycle
               if (allocated(no_path)) then
                  found(point)%status = result_not_converged
                  found(point)%message = no_path%message
               else
                  call solve_point(mine, uncertainty, point_at(uncertainty%range, point), found(point))
               end if
            end do
            ! the list of all pieces is touched here only: its record is written from it
            !$omp critical (uncertainty_results)
            do point = 1, size(found)
               piece = piece_number(uncertainty, point, sample)
               if (.not. left(piece) .or. .not. is_solved(found(point))) cycle
               run%pieces(piece) = found(point)
               solved = solved + 1
               call keep(run%keeper, piece, run%pieces)
            end do
            call show_progress(progress, share(), before, to_text(solved)//' of '//to_text(size(run%pieces))//' solutions')
            !$omp end critical (uncertainty_results)
         end do
         !$omp end do
      end subroutine share_samples
   end subroutine solve_samples

   !> Solves one point of a sample. Warnings are left out: there are as many as solutions.
   subroutine solve_point(model, uncertainty, point, found)
      type(model_type), intent(inout) :: model     !< its first load case is overwritten
      type(uncertainty_type), intent(in) :: uncertainty
      type(point_type), intent(in) :: point
      type(sweep_result_type), intent(out) :: found
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call point_case(uncertainty%range, point, model%cases(1))
      model%cases(1)%friction_axial%present = .false.      ! the sections have it as it was drawn
      model%cases(1)%friction_rotary%present = .false.
      call solve_case(model, uncertainty%range%models(point%model), 1, result, error, totals_only=.true.)
      ! a signal in the midst of a solution leaves it for the next run
      if (is_interrupted() .and. result%status == result_not_converged) return
      found%status = result%status
      found%hookload = result%hookload
      found%torque = result%torque
      if (result%status /= result_converged) found%message = result%message
   end subroutine solve_point

   !> Tells how many solutions are none, and of the first what it is and why it is none, so that it can be looked into.
   subroutine tell_lost(units, uncertainty, pieces, lost)
      type(unit_system_type), intent(in) :: units
      type(uncertainty_type), intent(in) :: uncertainty
      type(sweep_result_type), intent(in) :: pieces(:)
      integer, intent(in) :: lost
      type(point_type) :: point
      character(:), allocatable :: text
      integer :: first, sample
      do first = 1, size(pieces)
         if (pieces(first)%status == result_not_converged) exit
      end do
      sample = modulo(first - 1, uncertainty%samples) + 1
      associate (range => uncertainty%range)
         point = point_at(range, (first - 1)/uncertainty%samples + 1)
         text = what//' '//quoted(range%name)//': '//to_text(lost)//' of '//to_text(count(is_solved(pieces)))// &
                ' solutions did not converge and are left out of the quantiles; the first: '// &
                trim(model_name(range%models(point%model)))//', '//trim(operation_label(range%operations(point%operation)))// &
                ', bit at '//trim(in_units(units, unit_length, range%depths(point%depth), 7))//', sample '//to_text(sample)
      end associate
      if (allocated(pieces(first)%message)) text = text//': '//pieces(first)%message
      call tell(text)
   end subroutine tell_lost
end module dg_run_uncertainties
