!> Runs every case of a deck with every model that it asks for, writes the results as they come.
module dg_run_deck
   use, intrinsic :: iso_fortran_env, only: error_unit
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_not_converged, result_status_name
   use dg_contacts_file, only: write_contacts
   use dg_diagnostic, only: tell
   use dg_ensemble_record, only: ensemble_title, ensemble_type
   use dg_error, only: error_type, raise, status_ok, status_failure, status_bad_input, status_not_converged
   use dg_folder, only: make_folder
   use dg_folder_lock, only: folder_lock_type, lock_folder, release_folder
   use dg_history_file, only: write_history
   use dg_interruption, only: interruption_name, is_interrupted, watch_for_signals
   use dg_job, only: job_type, model_name
   use dg_limits_file, only: write_limits
   use dg_limits_table, only: limits_table
   use dg_memory, only: check_memory
   use dg_model, only: model_type
   use dg_model_table, only: model_table
   use dg_paraview_file, only: write_hole_view, write_string_view
   use dg_part_faults, only: faults_text, part_faults_type, start_faults
   use dg_part_list, only: part_list_text
   use dg_printed_text, only: print_line, print_lines, printed_text_type
   use dg_process, only: someone_watches
   use dg_profile_file, only: write_profile
   use dg_result_name, only: case_file, contacts_file, history_file, hole_file, profile_file, view_file
   use dg_result_table, only: result_table
   use dg_run_calibrations, only: run_calibrations
   use dg_run_ensembles, only: close_records, prepare_ensembles, run_ensemble
   use dg_run_legacy, only: run_legacy
   use dg_run_outcome, only: note_cases
   use dg_run_steering, only: run_steering
   use dg_run_study, only: run_study
   use dg_run_pictures, only: run_pictures
   use dg_results_h5, only: write_results_h5
   use dg_solve_case, only: solve_case
   use dg_summary_file, only: write_summary
   use dg_standard_output, only: flush_output
   use dg_text, only: quoted, text_type, to_text
   use dg_threads, only: thread_count
   use dg_utilisation, only: find_utilisation
   use dg_whole_string, only: find_whole_string, whole_string_type
   use dg_written_files, only: begin_files, end_files, other_records
   implicit none
   private
   public :: run_deck

   !> What prevented a result, if anything did.
   type :: failure_type
      type(error_type), allocatable :: error
   end type failure_type

contains

   !> Does all that the deck asks for, of a divided run the chosen parts one after another. One that fails does not keep the next
   !> from being run. `status` is the exit status: the gravest of what happened.
   subroutine run_deck(asked, given, chosen, status)
      type(job_type), intent(in) :: asked          !< as deck and command line have it
      type(model_type), intent(in) :: given        !< as the deck has it
      integer, intent(in) :: chosen(:)             !< parts; 1 of an undivided run
      integer, intent(out) :: status
      type(job_type) :: job                        !< with one part after another
      type(error_type), allocatable :: error
      logical :: failed(size(chosen))
      integer :: i, outcome
      status = status_ok
      job = asked
      call check_memory(job, given, error)
      if (.not. allocated(error)) call make_folder(job%output_dir, error)
      call watch_for_signals()
      call note_failure(error, status)
      if (allocated(error)) return
      failed = .true.
      do i = 1, size(chosen)
         if (i > 1 .and. is_interrupted()) then
            call note_ending('part '//to_text(chosen(i)), status)
            exit
         end if
         job%part = chosen(i)
         call run_alone(job, given, outcome)
         status = graver(status, outcome)
         failed(i) = outcome == status_failure .or. outcome == status_bad_input
      end do
      if (size(chosen) > 1 .and. any(failed)) &
         call tell('not finished: --part '//part_list_text(pack(chosen, failed))//'/'//to_text(job%parts))
   end subroutine run_deck

   !> Takes the output folder for this run, or part of one, alone.
   subroutine run_alone(job, given, status)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: given        !< as the deck has it
      integer, intent(out) :: status
      type(folder_lock_type) :: lock
      character(:), allocatable :: note
      type(error_type), allocatable :: error
      status = status_ok
      call lock_folder(job%output_dir, job%part, job%parts, lock, note, error)
      call note_failure(error, status)
      if (allocated(error)) return
      if (note /= '' .and. .not. job%quiet) call tell(note)
      call run_in_folder(job, given, status)
      call release_folder(lock)
   end subroutine run_alone

   !> What the path has that the deck's stations have not: every number below goes by it, so even --quiet prints it.
   subroutine print_path(model)
      type(model_type), intent(in) :: model
      integer :: i
      if (.not. allocated(model%path_notes)) return
      do i = 1, size(model%path_notes)
         call print_line('Path: '//model%path_notes(i)%text)
      end do
   end subroutine print_path

   !> Solves, writes, prints. A case that fails is marked and told on standard error; the others go on.
   subroutine run_in_folder(asked, given, status)
      type(job_type), intent(in) :: asked          !< as the deck has it
      type(model_type), intent(in) :: given        !< as the deck has it
      integer, intent(inout) :: status
      type(job_type) :: job                        !< with deviations that calibrations hand on
      type(model_type) :: model                    !< with friction that calibrations apply
      type(ensemble_type), allocatable :: ensembles(:)
      type(printed_text_type) :: printed           !< tables of all but load cases
      type(case_result_type), allocatable :: results(:)
      type(along_string_type), allocatable :: alongs(:)
      type(whole_string_type), allocatable :: wholes(:)
      type(error_type), allocatable :: error
      type(part_faults_type) :: faults             !< of parts that are to be joined
      integer :: i, lost, rows
      logical :: calibrated_first, written

      calibrated_first = any(asked%calibrations%apply)
      model = given
      job = asked
      lost = 0
      if (calibrated_first) then
         call begin_files(job, given, error)
         if (.not. allocated(error)) call print_path(given)
         if (.not. allocated(error)) call run_calibrations(printed, asked, given, model, job%uncertainties, lost, error)
         if (lost > 0) status = status_not_converged
      end if
      call start_faults(faults, job%merge)
      if (.not. allocated(error)) call prepare_ensembles(job, model, ensembles, faults, error)
      if (.not. allocated(error) .and. faults_text(faults) /= '') call raise(error, status_bad_input, faults_text(faults))
      ! what is refused so far leaves the results of an earlier run as they are
      if (.not. (allocated(error) .or. calibrated_first)) call begin_files(job, model, error)
      if (allocated(error)) then
         call tell(error%message)
         status = error%status
         if (calibrated_first) call end_files(job, error)
         return
      end if
      if (.not. calibrated_first) call print_path(given)
      rows = 0
      if (job%parts == 0 .and. job%merge == 0) rows = size(job%models)*size(model%cases)
      allocate (results(rows), alongs(rows), wholes(rows))
      if (rows > 0) call run_cases(printed, job, model, results, alongs, wholes, status)
      if (is_interrupted()) then
         if (size(job%calibrations) + size(job%stickings) > 0 .and. .not. calibrated_first) call note_ending('calibrations', status)
      else if (job%parts == 0 .and. job%merge == 0 .and. .not. calibrated_first) then
         call run_calibrations(printed, asked, given, model, job%uncertainties, lost, error)
         call note_failure(error, status)
         if (lost > 0) status = graver(status, status_not_converged)
      end if
      written = .true.
      do i = 1, size(ensembles)
         if (is_interrupted()) then
            call note_ending(ensemble_title(ensembles(i)), status)
            exit
         end if
         call run_ensemble(printed, job, model, ensembles(i), lost, error)
         written = written .and. .not. allocated(error)
         call note_failure(error, status)
         if (lost > 0) status = graver(status, status_not_converged)
      end do
      if (written .and. max(job%parts, job%merge) == 0 .and. .not. is_interrupted()) then
         call close_records(ensembles, error)
         call note_failure(error, status)
      end if
      if (job%parts == 0 .and. .not. (job%quiet .or. is_interrupted())) &
         call print_line('Results in '//job%output_dir// &
                         trim(merge('; open report.html there', '                        ', job%plots)))
      call flush_output()
      if (job%plots .and. job%parts == 0) then
         if (is_interrupted()) then
            call note_ending('pictures', status)
         else
            call run_pictures(printed, job, model, results, alongs, wholes, error)
            call note_failure(error, status)
         end if
      end if
      call end_files(job, error)
      call note_failure(error, status)
      if (job%parts == 0 .and. .not. job%quiet) call note_records(job)
   end subroutine run_in_folder

   !> Tells of unfinished work of other sweeps, which stays in the folder.
   subroutine note_records(job)
      type(job_type), intent(in) :: job
      type(text_type), allocatable :: names(:)
      integer :: i
      allocate (names(0))   ! the compiler's flow analysis takes them for undefined otherwise
      call other_records(job, names)
      do i = 1, size(names)
         call tell('note: '//in_folder(job, names(i)%text)//' is unfinished work of an earlier run; remove it if it is not needed')
      end do
   end subroutine note_records

   !> The load cases of a deck.
   subroutine run_cases(printed, job, model, results, alongs, wholes, status)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(inout) :: results(:)   !< one a model and case
      type(along_string_type), intent(inout) :: alongs(:)   !< as many
      type(whole_string_type), intent(inout) :: wholes(:)   !< as many
      integer, intent(inout) :: status
      type(error_type), allocatable :: error
      type(text_type), allocatable :: lines(:)
      integer :: i, lost
      call solve_all(job, model, results, alongs, wholes, status)
      call note_cases(printed%outcome, model, results)
      call write_summary(in_folder(job, 'summary.csv'), job, model, results, error)
      call note_failure(error, status)
      call write_limits(in_folder(job, 'limits.csv'), job, model, results, wholes, error)
      call note_failure(error, status)
      if (job%hdf5) then
         call write_results_h5(in_folder(job, 'results.h5'), job, model, results, alongs, wholes, error)
         call note_failure(error, status)
      end if
      call print_lines(result_table(job, model, results))
      call print_lines(model_table(job, model, results))
      call limits_table(job, model, results, wholes, lines)
      call print_lines(lines)
      if (allocated(job%legacy)) then
         do i = 1, size(job%legacy)
            call run_legacy(printed, job, model, results, i, error)
            call note_failure(error, status)
         end do
      end if
      if (allocated(job%study)) then
         call run_study(printed, job, model, error)
         call note_failure(error, status)
      end if
      if (allocated(job%steering) .and. .not. is_interrupted()) then
         call run_steering(printed, job, model, lost, error)
         call note_failure(error, status)
         if (lost > 0) status = graver(status, status_not_converged)
      end if
      call flush_output()
      if (is_interrupted()) then
         call tell('ended by '//interruption_name()//': '//to_text(count(results%status /= result_not_converged))//' of '// &
                   to_text(size(results))//' results are there, the others are marked not_converged')
         status = graver(status, status_failure)
      end if
   end subroutine run_cases

   !> Solves every case with every model, as many at a time as the job allows; after a signal no more of them. Cases do not
   !> know of each other, and what is told and written of them comes in the deck's order: nothing depends on the number of
   !> threads. What is solved is written as soon as all before it is.
   subroutine solve_all(job, model, results, alongs, wholes, status)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(inout) :: results(:)
      type(along_string_type), intent(inout) :: alongs(:)
      type(whole_string_type), intent(inout) :: wholes(:)
      integer, intent(inout) :: status
      type(failure_type) :: failures(size(results))
      logical :: solved(size(results)), progress
      integer :: row, next
      progress = someone_watches() .and. .not. job%quiet
      solved = .false.
      next = 1
      !$omp parallel do schedule(dynamic, 1) num_threads(thread_count(job%threads, size(results))) default(shared) private(row)
      do row = 1, size(results)
         call solve_case(model, number_of(row), case_of(row), results(row), failures(row)%error)
         if (allocated(results(row)%profile%md)) then
            call find_along_string(model, results(row), alongs(row))
            call find_whole_string(model, results(row), alongs(row), job%rig_limit, wholes(row))
            call find_utilisation(model, results(row), alongs(row), job%design, job%rig_limit, wholes(row)%utilisation)
         end if
         !$omp critical (results_in_order)
         solved(row) = .true.
         do while (next <= size(results))
            if (.not. solved(next)) exit
            call note_outcome(place(job, model, number_of(next), case_of(next)), results(next), failures(next)%error, status)
            if (allocated(results(next)%profile%md)) call write_case_files(job, model, results(next), alongs(next), status)
            if (progress) write (error_unit, '(a)') '['//to_text(next)//'/'//to_text(size(results))//'] '// &
               place(job, model, number_of(next), case_of(next))//': '//trim(result_status_name(results(next)%status))
            next = next + 1
         end do
         !$omp end critical (results_in_order)
      end do
      !$omp end parallel do

   contains

      !> Number of the model of a row: all cases of the first model come first.
      pure function number_of(row) result(number)
         integer, intent(in) :: row
         integer :: number
         number = job%models((row - 1)/size(model%cases) + 1)
      end function number_of

      !> Load case of a row.
      pure function case_of(row) result(index)
         integer, intent(in) :: row
         integer :: index
         index = modulo(row - 1, size(model%cases)) + 1
      end function case_of
   end subroutine solve_all

   !> Tells what went wrong with a case and raises the exit status by it.
   subroutine note_outcome(where, result, error, status)
      character(*), intent(in) :: where
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(in) :: error
      integer, intent(inout) :: status
      if (allocated(error)) then
         call tell(where//': '//error%message)
         status = graver(status, error%status)
      else if (result%status == result_not_converged .and. .not. is_interrupted()) then
         call tell(where//': did not converge; '//result%message)
         status = graver(status, status_not_converged)
      end if
   end subroutine note_outcome

   !> Writes the files of one case that has a profile; a failure is told and noted in the exit status.
   subroutine write_case_files(job, model, result, along, status)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      integer, intent(inout) :: status
      type(error_type), allocatable :: error
      associate (case => model%cases(result%case_index)%name, number => result%model)
         if (job%profiles) then
            call write_profile(in_folder(job, case_file(profile_file, case, number)), job, result, along, error)
            call note_failure(error, status)
         end if
         if (job%plots) then
            call write_string_view(in_folder(job, case_file(view_file, case, number)), job, result%profile, along, error)
            call note_failure(error, status)
            call write_hole_view(in_folder(job, case_file(hole_file, case, number)), job, result%profile, along, error)
            call note_failure(error, status)
         end if
         if (job%profiles .and. allocated(result%contacts)) then
            call write_contacts(in_folder(job, case_file(contacts_file, case, number)), job, result, error)
            call note_failure(error, status)
         end if
         if (model%numerics%history .and. allocated(result%history)) then
            call write_history(in_folder(job, case_file(history_file, case, number)), job, result, error)
            call note_failure(error, status)
         end if
      end associate
   end subroutine write_case_files

   !> Tells that a signal came before something was begun, unless what it cut short has told it.
   subroutine note_ending(what, status)
      character(*), intent(in) :: what
      integer, intent(inout) :: status
      if (status /= status_failure) call tell('ended by '//interruption_name()//' before '//what)
      status = status_failure
   end subroutine note_ending

   !> Tells an error, if there is one, and raises the exit status by it.
   subroutine note_failure(error, status)
      type(error_type), allocatable, intent(in) :: error
      integer, intent(inout) :: status
      if (.not. allocated(error)) return
      call tell(error%message)
      status = graver(status, error%status)
   end subroutine note_failure

   !> The graver of two exit statuses: failure, then bad input, then a case not converged.
   pure function graver(one, other) result(status)
      integer, intent(in) :: one, other
      integer :: status
      integer, parameter :: order(4) = [status_failure, status_bad_input, status_not_converged, status_ok]
      integer :: i
      do i = 1, size(order)
         status = order(i)
         if (one == status .or. other == status) return
      end do
   end function graver

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
end module dg_run_deck
