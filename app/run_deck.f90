!> Does all that a deck asks for: load cases, calibrations, sweeps, Monte Carlos, pictures and the page.
module dg_run_deck
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_diagnostic, only: tell
   use dg_ensemble_record, only: ensemble_title, ensemble_type
   use dg_error, only: error_type, raise, status_ok, status_failure, status_bad_input, status_not_converged
   use dg_exit_status, only: graver, note_ending, note_failure
   use dg_folder, only: make_folder
   use dg_folder_lock, only: folder_lock_type, lock_folder, release_folder
   use dg_interruption, only: is_interrupted, watch_for_signals
   use dg_job, only: job_type
   use dg_memory, only: check_memory
   use dg_model, only: model_type
   use dg_part_faults, only: faults_text, part_faults_type, start_faults
   use dg_part_list, only: part_list_text
   use dg_printed_text, only: print_line, printed_text_type
   use dg_run_calibrations, only: run_calibrations
   use dg_run_cases, only: run_cases
   use dg_run_ensembles, only: close_records, prepare_ensembles, run_ensemble
   use dg_run_pictures, only: run_pictures
   use dg_standard_output, only: flush_output
   use dg_text, only: text_type, to_text
   use dg_whole_string, only: whole_string_type
   use dg_written_files, only: begin_files, end_files, other_records
   implicit none
   private
   public :: run_deck

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
      if (written .and. max(job%parts, job%merge) == 0 .and. .not. is_interrupted()) call close_records(ensembles, status)
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
         call tell('note: '//job%output_dir//'/'//names(i)%text// &
                   ' is unfinished work of an earlier run; remove it if it is not needed')
      end do
   end subroutine note_records
end module dg_run_deck
