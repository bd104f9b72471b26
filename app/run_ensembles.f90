!> Runs the sweeps and Monte Carlos of a deck: in parts where asked for, from where an interrupted run stopped.
module dg_run_ensembles
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_result, only: result_not_converged
   use dg_clock, only: seconds_between
   use dg_diagnostic, only: tell
   use dg_ensemble_record, only: close_record, ensemble_title, ensemble_type, failed_text, open_record, taken_text, take_parts, &
      write_record
   use dg_error, only: error_type, raise, status_failure
   use dg_exit_status, only: note_failure
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_model_text, only: sweep_lines, uncertainty_lines
   use dg_part_faults, only: part_faults_type
   use dg_printed_text, only: print_and_keep, print_line, printed_text_type
   use dg_progress, only: end_progress, progress_type, start_progress
   use dg_run_outcome, only: note_sweep, note_uncertainty
   use dg_sample_points, only: sample_text, solve_samples
   use dg_sample_statistics, only: find_point_statistics, point_statistics_type
   use dg_sweep, only: point_count
   use dg_sweep_file, only: write_sweep
   use dg_sweep_points, only: add_indicator, add_margins, point_text, solve_points
   use dg_sweep_result, only: is_solved
   use dg_sweep_table, only: sweep_sentences, sweep_table
   use dg_sweep_work, only: in_part
   use dg_text, only: append_text, text_type, to_text
   use dg_uncertainty, only: piece_count
   use dg_uncertainty_file, only: write_uncertainty
   use dg_uncertainty_table, only: uncertainty_table
   implicit none
   private
   public :: prepare_ensembles, run_ensemble, close_records

   character(*), parameter :: sweep_kind = 'sweep', uncertainty_kind = 'uncertainty'

contains

   !> The sweeps of a job, then its Monte Carlos. Looks for what earlier runs have left: records of interrupted ones, or all parts
   !> where they are to be joined, with their faults. An error (bad input) where a record does not fit the deck.
   subroutine prepare_ensembles(job, model, ensembles, faults, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(ensemble_type), allocatable, intent(out) :: ensembles(:)
      type(part_faults_type), intent(inout) :: faults    !< of parts that are to be joined
      type(error_type), allocatable, intent(out) :: error
      integer :: i, sweeps
      sweeps = size(job%sweeps)
      allocate (ensembles(sweeps + size(job%uncertainties)))
      do i = 1, size(ensembles)
         associate (ensemble => ensembles(i))
            if (i <= sweeps) then
               ensemble%what = sweep_kind
               ensemble%number = i
               ensemble%name = job%sweeps(i)%name
               allocate (ensemble%settings, source=sweep_lines(model, job%sweeps(i)))
               allocate (ensemble%points(point_count(job%sweeps(i))))
            else
               ensemble%what = uncertainty_kind
               ensemble%number = i - sweeps
               ensemble%name = job%uncertainties(i - sweeps)%range%name
               allocate (ensemble%settings, source=uncertainty_lines(model, job%uncertainties(i - sweeps)))
               allocate (ensemble%points(piece_count(job%uncertainties(i - sweeps))))
            end if
            if (job%merge > 0) then
               call take_parts(job, ensemble, faults)
            else
               call open_record(job, ensemble, error)
            end if
         end associate
         if (allocated(error)) return
      end do
   end subroutine prepare_ensembles

   !> Solves what is left of a sweep or Monte Carlo, writes and prints it. `lost` counts the points without solution.
   subroutine run_ensemble(printed, job, model, ensemble, lost, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(ensemble_type), intent(inout) :: ensemble
      integer, intent(out) :: lost
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: points, points_solved   !< what they are called
      integer :: resumed
      real(wp) :: seconds
      points = 'solutions'
      points_solved = points
      if (ensemble%what == sweep_kind) points = 'points'
      if (ensemble%what == sweep_kind) points_solved = 'points solved'
      resumed = count(is_solved(ensemble%points))
      seconds = 0.0_wp
      if (job%merge == 0) call solve_rest(job, model, ensemble, seconds)
      lost = count(ensemble%points%status == result_not_converged)
      if (lost > 0) call tell_lost(job, ensemble, lost, points)
      if (.not. is_interrupted()) call tell_unless_empty(failed_text(ensemble, max(job%parts, job%merge)))
      if (job%merge == 0 .and. (is_interrupted() .or. job%parts > 0)) then
         call write_record(ensemble, error)
         if (allocated(error)) return
         if (is_interrupted()) then
            call raise(error, status_failure, ensemble_title(ensemble)//': ended by '//interruption_name()//' with '// &
                       solved_of_all(ensemble)//' '//points_solved//'; the same command goes on from there ('//ensemble%path//')')
         else
            call print_line(capital(ensemble%what)//' '//ensemble%name//', part '//to_text(job%part)//' of '// &
                            to_text(job%parts)//': '//solved_of_all(ensemble)//' '//points//', in '//ensemble%path)
         end if
         return
      end if
      if (ensemble%what == sweep_kind) then
         call finish_sweep(printed, job, model, ensemble, lines, error)
      else
         call finish_uncertainty(printed, job, model, ensemble, lines, error)
      end if
      if (allocated(error)) return
      if (any(ensemble%points%earlier)) call append_text(lines, to_text(count(ensemble%points%earlier))//' of '// &
         to_text(size(ensemble%points))//' '//points//' were found with other settings of the solver, by a run before --again')
      call print_and_keep(printed, lines)
      if (job%merge > 0) then
         call print_line(to_text(size(ensemble%points))//' '//points//', joined from '//to_text(job%merge)//' parts')
      else
         call print_line(to_text(size(ensemble%points) - resumed)//' '//points_solved//' in '//to_text(seconds, 3)//' s')
      end if
   end subroutine run_ensemble

   !> Solves the points that have no result yet, with their progress on the terminal.
   subroutine solve_rest(job, model, ensemble, seconds)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(ensemble_type), intent(inout) :: ensemble
      real(wp), intent(out) :: seconds
      type(progress_type) :: progress
      integer(int64) :: start, finish
      integer :: i, left
      call tell_unless_empty(taken_text(ensemble, job%again))
      call system_clock(start)
      left = count(.not. is_solved(ensemble%points) .and. &
                   in_part([(i, i=1, size(ensemble%points))], job%part, max(job%parts, 1)))
      call start_progress(progress, ensemble_title(ensemble), to_text(left)//' solutions', job%quiet)
      if (ensemble%what == sweep_kind) then
         call solve_points(job, model, job%sweeps(ensemble%number), ensemble, progress)
      else
         call solve_samples(job, model, job%uncertainties(ensemble%number), ensemble, progress)
      end if
      call end_progress(progress)
      if (allocated(ensemble%failure)) call tell(ensemble%failure%message)
      call system_clock(finish)
      seconds = seconds_between(start, finish)
   end subroutine solve_rest

   !> What follows from the points of a sweep: its file and its table.
   subroutine finish_sweep(printed, job, model, ensemble, lines, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(ensemble_type), intent(inout) :: ensemble
      type(text_type), allocatable, intent(out) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      associate (sweep => job%sweeps(ensemble%number))
         call add_indicator(model, sweep, 1, ensemble%points)
         call add_margins(job, model, sweep, ensemble%points)
         call note_sweep(printed%outcome, sweep, ensemble%points, sweep_sentences(job%units, sweep, ensemble%points))
         call write_sweep(job%output_dir//'/sweep_'//ensemble%name//'.csv', job, sweep, ensemble%points, error)
         if (.not. allocated(error)) allocate (lines, source=sweep_table(job%units, sweep, ensemble%points))
      end associate
   end subroutine finish_sweep

   !> What follows from the samples of a Monte Carlo: its file and its table.
   subroutine finish_uncertainty(printed, job, model, ensemble, lines, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(ensemble_type), intent(inout) :: ensemble
      type(text_type), allocatable, intent(out) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      type(point_statistics_type), allocatable :: statistics(:)
      integer :: i
      associate (uncertainty => job%uncertainties(ensemble%number))
         call note_uncertainty(printed%outcome, uncertainty, ensemble%points)
         call add_indicator(model, uncertainty%range, uncertainty%samples, ensemble%points)
         allocate (statistics(point_count(uncertainty%range)))
         do i = 1, size(statistics)
            statistics(i) = find_point_statistics(uncertainty, i, ensemble%points)
         end do
         call write_uncertainty(job%output_dir//'/uncertainty_'//ensemble%name//'.csv', job, uncertainty, statistics, error)
         if (.not. allocated(error)) allocate (lines, source=uncertainty_table(job%units, uncertainty, statistics, model%rig%given))
      end associate
   end subroutine finish_uncertainty

   !> Records of what is finished: they stay where points of any of them did not converge. What cannot be written is told, and
   !> raises the exit status.
   subroutine close_records(ensembles, status)
      type(ensemble_type), intent(inout) :: ensembles(:)
      integer, intent(inout) :: status
      type(error_type), allocatable :: error
      logical :: lost
      integer :: i
      lost = .false.
      do i = 1, size(ensembles)
         lost = lost .or. any(ensembles(i)%points%status == result_not_converged)
      end do
      do i = 1, size(ensembles)
         call close_record(ensembles(i), lost, error)
         call note_failure(error, status)
      end do
   end subroutine close_records

   !> Tells how many points have no solution, and of the first what it is and why it has none, so that it can be looked into.
   subroutine tell_lost(job, ensemble, lost, points)
      type(job_type), intent(in) :: job
      type(ensemble_type), intent(in) :: ensemble
      integer, intent(in) :: lost
      character(*), intent(in) :: points           !< what they are called
      character(:), allocatable :: text
      integer :: first
      do first = 1, size(ensemble%points)
         if (ensemble%points(first)%status == result_not_converged) exit
      end do
      text = ensemble_title(ensemble)//': '//to_text(lost)//' of '//to_text(count(is_solved(ensemble%points)))//' '//points// &
             ' did not converge'
      if (ensemble%what == sweep_kind) then
         text = text//'; the first: '//point_text(job%units, job%sweeps(ensemble%number), first)
      else
         text = text//' and are left out of the quantiles; the first: '// &
                sample_text(job%units, job%uncertainties(ensemble%number), first)
      end if
      if (allocated(ensemble%points(first)%message)) text = text//': '//ensemble%points(first)%message
      call tell(text)
   end subroutine tell_lost

   subroutine tell_unless_empty(text)
      character(*), intent(in) :: text
      if (text /= '') call tell(text)
   end subroutine tell_unless_empty

   !> How many points have their result: 3 of 5.
   pure function solved_of_all(ensemble) result(text)
      type(ensemble_type), intent(in) :: ensemble
      character(:), allocatable :: text
      text = to_text(count(is_solved(ensemble%points)))//' of '//to_text(size(ensemble%points))
   end function solved_of_all

   !> A word as a sentence begins with it.
   pure function capital(word) result(text)
      character(*), intent(in) :: word
      character(len(word)) :: text
      text = achar(iachar(word(1:1)) - iachar('a') + iachar('A'))//word(2:)
   end function capital
end module dg_run_ensembles
