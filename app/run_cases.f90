!> Solves the load cases of a deck with every model that it asks for, writes the results as they come, and prints them.
module dg_run_cases
   use dg_along_string, only: along_string_type, find_along_string
   use dg_bowed_pipe, only: with_joints_apart
   use dg_case_result, only: case_result_type, has_numbers, result_not_converged
   use dg_case_watch, only: case_watch_type
   use dg_findings, only: findings_type
   use dg_wear_files, only: write_casing_wear, write_fatigue
   use dg_solution_series, only: contact_series, history_series
   use dg_csv_table, only: write_series
   use dg_diagnostic, only: report_line
   use dg_error, only: error_type, status_failure, status_not_converged
   use dg_exit_status, only: graver, note_failure
   use dg_find_verdict, only: find_verdict
   use dg_friction_estimate, only: find_upper_friction, upper_friction_type
   use dg_held_string, only: find_packer_loads
   use dg_interruption, only: by_signals, interruption_name, is_interrupted
   use dg_job, only: job_type, model_name
   use dg_length_change, only: less
   use dg_limits_file, only: write_limits
   use dg_limits_table, only: limits_table
   use dg_model, only: model_type
   use dg_model_table, only: model_table
   use dg_paraview_file, only: write_hole_view, write_string_view
   use dg_printed_text, only: print_line, print_lines
   use dg_profile_file, only: profile_series
   use dg_progress, only: end_progress, progress_type, start_progress
   use dg_registry, only: run_phase, studies_type
   use dg_result_name, only: case_file, case_files, contacts_file, fatigue_file, history_file, hole_file, profile_file, view_file, &
      wanted_files, wear_file
   use dg_result_table, only: cost_table, result_table
   use dg_results_h5, only: write_results_h5
   use dg_run_outcome, only: note_cases
   use dg_solve_case, only: solve_case
   use dg_standard_output, only: flush_output
   use dg_stopping, only: stop_type
   use dg_study, only: phase_cases, run_type
   use dg_summary_file, only: write_summary
   use dg_text, only: either, quoted, text_type, to_text
   use dg_threads, only: thread_count
   use dg_utilisation, only: find_utilisation
   use dg_verdict, only: verdict_type
   use dg_verdict_table, only: verdict_table
   use dg_warnings_table, only: deck_warnings, warnings_table
   use dg_well_head, only: well_head
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: run_cases

   !> Error that prevented a result, if any.
   type :: failure_type
      type(error_type), allocatable :: error
   end type failure_type

contains

   !> The load cases of a deck.
   subroutine run_cases(run, studies)
      type(run_type), intent(inout) :: run                  !< with room for a result a model and case
      type(studies_type), intent(inout) :: studies
      type(error_type), allocatable :: error
      type(text_type), allocatable :: lines(:)
      type(upper_friction_type) :: upper
      call settle_packers(run%model, run%status)
      call find_upper_friction(run%model%holes, run%estimates, upper)
      call solve_all(run, upper)
      call count_from_references(run%model, run%results, run%wholes)
      call note_cases(run%printed%outcome, run%results)
      call write_summary(in_folder(run%job, 'summary.csv'), run%findings_type, error)
      call note_failure(error, run%status)
      call write_limits(in_folder(run%job, 'limits.csv'), run%findings_type, error)
      call note_failure(error, run%status)
      if (run%job%hdf5) then
         call write_results_h5(in_folder(run%job, 'results.h5'), run%findings_type, error)
         call note_failure(error, run%status)
      end if
      call print_lines(verdict_table(run%findings_type))
      call print_lines(warnings_table(run%findings_type))
      call print_line('')
      call print_lines(well_head(run%job%units, run%model, upper))
      call print_lines(result_table(run%findings_type))
      call print_lines(model_table(run%findings_type))
      call limits_table(run%findings_type, lines)
      call print_lines(lines)
      call print_lines(cost_table(run%findings_type))
      call run_phase(studies, phase_cases, run, '')
      call flush_output()
      if (is_interrupted()) then
         call report_line('ended by '//interruption_name()//': '// &
                          to_text(count(run%results%status /= result_not_converged))//' of '// &
                          to_text(size(run%results))//' results are there, the others are marked not_converged')
         run%status = graver(run%status, status_failure)
      end if
   end subroutine run_cases

   !> Find the force on the packer of each load case that its packer holds. A message names cases where it was not found.
   subroutine settle_packers(model, status)
      type(model_type), intent(inout) :: model
      integer, intent(inout) :: status
      integer, allocatable :: failed(:)
      integer :: i
      call find_packer_loads(model, failed)
      do i = 1, size(failed)
         call report_line('load case '//quoted(model%cases(failed(i))%name)// &
                          ': the force on the packer was not found; it is solved '// &
                          'without one, and its lower end moves')
         status = graver(status, status_not_converged)
      end do
   end subroutine settle_packers

   !> Changes of length of load cases that count from another one.
   subroutine count_from_references(model, results, wholes)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)         !< all cases of the first method come first
      type(whole_string_type), intent(inout) :: wholes(:)
      integer :: i, reference
      do i = 1, size(results)
         reference = model%cases(results(i)%case_index)%length_reference
         if (reference == 0) cycle
         reference = i - results(i)%case_index + reference
         wholes(i)%length_change = less(wholes(i)%length_change, wholes(reference)%length_change)
      end do
   end subroutine count_from_references

   !> Solve every case with every model, as many at a time as the job allows. After a signal no more are begun. Cases are
   !> independent, and output is in the deck's order, so that results do not depend on the number of threads. A case is written
   !> as soon as all before it are.
   subroutine solve_all(run, upper)
      type(run_type), intent(inout) :: run
      type(upper_friction_type), intent(in) :: upper
      type(failure_type) :: failures(size(run%results))
      type(progress_type), target :: progress
      type(case_watch_type), target :: watches(size(run%results))
      logical, target :: solved(size(run%results))
      integer :: row, next
      logical :: doubt
      doubt = size(deck_warnings(run%job, run%model)) > 0
      call start_progress(progress, 'load cases', '', run%job%quiet)
      solved = .false.
      do row = 1, size(run%results)      ! before threads begin: gfortran keeps the length of such a text in a static variable
         watches(row)%progress => progress
         watches(row)%solved => solved
         watches(row)%what = place(run%job, run%model, number_of(row), case_of(row))
      end do
      next = 1
      !$omp parallel do schedule(dynamic, 1) num_threads(thread_count(run%job%threads, size(run%results))) default(shared) &
      !$omp private(row)
      do row = 1, size(run%results)
         call solve_watched(run%model, number_of(row), case_of(row), watches(row), run%results(row), failures(row)%error)
         if (run%results(row)%joints_apart) then
            call judge_result(with_joints_apart(run%model), upper, run%results(row), run%alongs(row), run%wholes(row))
         else
            call judge_result(run%model, upper, run%results(row), run%alongs(row), run%wholes(row))
         end if
         !$omp critical (results_in_order)
         solved(row) = .true.
         if (allocated(failures(row)%error) .or. run%results(row)%status == result_not_converged) call end_progress(progress)
         do while (next <= size(run%results))
            if (.not. solved(next)) exit
            call note_outcome(place(run%job, run%model, number_of(next), case_of(next)), run%results(next), &
                              failures(next)%error, doubt, run%status)
            call write_case_files(run%job, run%model, run%results(next), run%alongs(next), run%status)
            next = next + 1
         end do
         !$omp end critical (results_in_order)
      end do
      !$omp end parallel do
      call end_progress(progress)

   contains

      !> Number of the model of a row: all cases of the first model come first.
      pure function number_of(row) result(number)
         integer, intent(in) :: row
         integer :: number
         number = run%job%models((row - 1)/size(run%model%cases) + 1)
      end function number_of

      !> Load case of a row.
      pure function case_of(row) result(index)
         integer, intent(in) :: row
         integer :: index
         index = modulo(row - 1, size(run%model%cases)) + 1
      end function case_of
   end subroutine solve_all

   !> Find stresses, limits and the answer of a result.
   subroutine judge_result(model, upper, result, along, whole)
      type(model_type), intent(in) :: model        !< by which the result was found
      type(upper_friction_type), intent(in) :: upper
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(inout) :: along
      type(whole_string_type), intent(inout) :: whole
      type(verdict_type) :: verdict
      if (allocated(result%profile%md)) then
         call find_along_string(model, result, along)
         call find_whole_string(model, result, along, whole)
         call find_utilisation(model, result, along, whole%utilisation)
      end if
      call find_verdict(model, result, whole, verdict, upper)
      whole%verdict = verdict
   end subroutine judge_result

   !> Solve a case. A signal ends it early, and its watch hears of every iteration.
   subroutine solve_watched(model, number, case_index, watch, result, error)
      type(model_type), intent(in) :: model
      integer, intent(in) :: number            !< of the model
      integer, intent(in) :: case_index
      type(case_watch_type), intent(in), target :: watch
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(stop_type) :: stop
      stop = by_signals()
      stop%watch => watch
      call solve_case(model, number, case_index, result, error, stop=stop)
   end subroutine solve_watched

   !> Tells what went wrong with a case and raises the exit status by it. Unusual numbers of the deck are the likeliest reason.
   subroutine note_outcome(where, result, error, doubt, status)
      character(*), intent(in) :: where
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(in) :: error
      logical, intent(in) :: doubt             !< the deck has warnings
      integer, intent(inout) :: status
      if (allocated(error)) then
         call report_line(where//': '//error%message)
         status = graver(status, error%status)
      else if (result%status == result_not_converged .and. .not. is_interrupted()) then
         call report_line(where//': did not converge; '//either('the deck has warnings, see them first. ', '', doubt)// &
                          result%message)
         status = graver(status, status_not_converged)
      end if
   end subroutine note_outcome

   !> Write the files of one case. A failure is printed and raises the exit status. A case that did not converge has no file but
   !> its history.
   subroutine write_case_files(job, model, result, along, status)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      integer, intent(inout) :: status
      type(error_type), allocatable :: error
      character(:), allocatable :: path
      logical :: wanted(case_files), there(case_files)
      integer :: kind
      wanted = wanted_files(job, model, model%cases(result%case_index))
      there = has_numbers(result%status)
      there(contacts_file) = allocated(result%contacts)
      there(history_file) = allocated(result%history)
      do kind = 1, case_files
         if (.not. (wanted(kind) .and. there(kind))) cycle
         path = in_folder(job, case_file(kind, model%cases(result%case_index)%name, result%model))
         select case (kind)
         case (profile_file); call write_series(profile_series(result%profile, along), path, job%units, error)
         case (contacts_file); call write_series(contact_series(result%contacts), path, job%units, error)
         case (wear_file); call write_casing_wear(path, job, model, result, error)
         case (fatigue_file); call write_fatigue(path, job, model, result, along, error)
         case (view_file); call write_string_view(path, job, result%profile, along, error)
         case (hole_file); call write_hole_view(path, job, result%profile, along, error)
         case default; call write_series(history_series(result%history), path, job%units, error)
         end select
         call note_failure(error, status)
      end do
   end subroutine write_case_files

   !> Case and model for messages.
   pure function place(job, model, number, case_index) result(text)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: number, case_index
      character(:), allocatable :: text
      text = 'case '//quoted(model%cases(case_index)%name)
      if (size(job%models) > 1) text = text//', model '//trim(model_name(number))
   end function place

   !> Path of a file in the output folder.
   pure function in_folder(job, name) result(path)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: name
      character(:), allocatable :: path
      path = job%output_dir//'/'//name
   end function in_folder
end module dg_run_cases
