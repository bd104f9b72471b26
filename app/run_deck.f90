!> Does all that a deck asks for: load cases, calibrations, sweeps, Monte Carlos, pictures and the page.
module dg_run_deck
   use dg_diagnostic, only: report_line
   use dg_error, only: error_type, raise, status_ok, status_failure, status_bad_input
   use dg_exit_status, only: graver, note_ending, note_failure
   use dg_folder, only: make_folder
   use dg_folder_lock, only: folder_lock_type, lock_folder, release_folder
   use dg_interruption, only: is_interrupted, watch_for_signals
   use dg_job, only: is_divided, job_type
   use dg_model, only: model_type
   use dg_part_faults, only: faults_text, start_faults
   use dg_part_list, only: part_list_text
   use dg_printed_text, only: print_line
   use dg_registry, only: name_studies, run_phase, studies_type
   use dg_run_cases, only: run_cases
   use dg_run_memory, only: check_memory
   use dg_run_pictures, only: run_pictures
   use dg_standard_output, only: flush_output
   use dg_study, only: phase_after, phase_first, phase_points, run_type
   use dg_text, only: either, text_type, to_text
   use dg_written_files, only: begin_files, end_files, other_records
   implicit none
   private
   public :: run_deck

contains

   !> Does all that the deck asks for, of a divided run the chosen parts one after another. One that fails does not keep the next
   !> from being run. `status` is the exit status: the gravest of what happened.
   subroutine run_deck(asked, given, studies, chosen, status)
      type(job_type), intent(in) :: asked          !< as deck and command line have it
      type(model_type), intent(in) :: given        !< as the deck has it
      type(studies_type), intent(inout) :: studies
      integer, intent(in) :: chosen(:)             !< parts; 1 of an undivided run
      integer, intent(out) :: status
      type(job_type) :: job                        !< with one part after another
      type(error_type), allocatable :: error
      logical :: failed(size(chosen))
      integer :: i, outcome
      status = status_ok
      job = asked
      call check_memory(job, given, studies, error)
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
         call name_studies(studies, job)
         call run_alone(job, given, studies, outcome)
         status = graver(status, outcome)
         failed(i) = outcome == status_failure .or. outcome == status_bad_input
      end do
      if (size(chosen) > 1 .and. any(failed)) &
         call report_line('not finished: --part '//part_list_text(pack(chosen, failed))//'/'//to_text(job%parts))
   end subroutine run_deck

   !> Takes the output folder for this run, or part of one, alone.
   subroutine run_alone(job, given, studies, status)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: given        !< as the deck has it
      type(studies_type), intent(inout) :: studies
      integer, intent(out) :: status
      type(folder_lock_type) :: lock
      character(:), allocatable :: note
      type(error_type), allocatable :: error
      status = status_ok
      call lock_folder(job%output_dir, job%part, job%parts, lock, note, error)
      call note_failure(error, status)
      if (allocated(error)) return
      if (note /= '' .and. .not. job%quiet) call report_line(note)
      call run_in_folder(job, given, studies, status)
      call release_folder(lock)
   end subroutine run_alone

   !> Print the features of the path that the deck's stations lack. Every number below depends on the path, so even --quiet prints
   !> them.
   subroutine print_path(model)
      type(model_type), intent(in) :: model
      integer :: i
      if (.not. allocated(model%path_notes)) return
      do i = 1, size(model%path_notes)
         call print_line('Path: '//model%path_notes(i)%text)
      end do
   end subroutine print_path

   !> Solves, writes, prints. A case that fails is marked and told on standard error; the others go on.
   subroutine run_in_folder(job, given, studies, status)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: given        !< as the deck has it
      type(studies_type), intent(inout) :: studies
      integer, intent(inout) :: status
      type(run_type) :: run
      type(error_type), allocatable :: error
      integer :: i, rows
      run%job = job
      run%given = given
      run%model = given
      run%estimates = studies%estimates
      run%status = status
      call prepare_run(run, studies, error)
      status = run%status
      if (allocated(error)) return
      rows = 0
      if (.not. is_divided(job)) rows = size(job%models)*size(given%cases)
      allocate (run%results(rows), run%alongs(rows), run%wholes(rows))
      if (rows > 0) call run_cases(run, studies)
      if (.not. is_divided(job)) call run_phase(studies, phase_after, run, 'calibrations')
      call run_phase(studies, phase_points, run, '')
      if (.not. is_interrupted()) then
         do i = 1, size(studies%items)
            call studies%items(i)%study%finish(run)
         end do
      end if
      if (job%parts == 0 .and. .not. (job%quiet .or. is_interrupted())) &
         call print_line('Results in '//job%output_dir// &
                         either('; open report.html there', '', job%plots))
      call flush_output()
      if (job%plots .and. job%parts == 0) then
         if (is_interrupted()) then
            call note_ending('pictures', run%status)
         else
            call run_pictures(run, studies, error)
            call note_failure(error, run%status)
         end if
      end if
      call end_files(job, error)
      call note_failure(error, run%status)
      if (job%parts == 0 .and. .not. job%quiet) call note_records(job)
      status = run%status
   end subroutine run_in_folder

   !> Run the studies that change the scene, then let every study refuse the run. A refused run leaves the results of an earlier
   !> run as they are, unless it has already written some. `error` is printed here.
   subroutine prepare_run(run, studies, error)
      type(run_type), intent(inout) :: run
      type(studies_type), intent(inout) :: studies
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: failure
      logical :: begun
      integer :: i
      begun = .false.
      do i = 1, size(studies%items)
         associate (study => studies%items(i)%study)
            if (study%phase /= phase_first .or. .not. study%asked) cycle
            if (.not. begun) then
               begun = .true.
               call begin_files(run%job, run%given, error)
               if (allocated(error)) exit
               call print_path(run%given)
            end if
            call study%run(run, error)
            if (allocated(error)) exit
         end associate
      end do
      call start_faults(run%part_faults, run%job%merge)
      do i = 1, size(studies%items)
         if (allocated(error)) exit
         call studies%items(i)%study%prepare(run, error)
      end do
      if (.not. allocated(error) .and. faults_text(run%part_faults) /= '') &
         call raise(error, status_bad_input, faults_text(run%part_faults))
      if (.not. (allocated(error) .or. begun)) call begin_files(run%job, run%model, error)
      if (allocated(error)) then
         call report_line(error%message)
         run%status = error%status
         if (begun) call end_files(run%job, failure)
         if (allocated(failure)) call report_line(failure%message)
         return
      end if
      if (.not. begun) call print_path(run%given)
   end subroutine prepare_run

   !> Tells of unfinished work of other sweeps, which stays in the folder.
   subroutine note_records(job)
      type(job_type), intent(in) :: job
      type(text_type), allocatable :: names(:)
      integer :: i
      allocate (names(0))   ! the compiler's flow analysis takes them for undefined otherwise
      call other_records(job, names)
      do i = 1, size(names)
         call report_line('note: '//job%output_dir//'/'//names(i)%text// &
                          ' is unfinished work of an earlier run; remove it if it is not needed')
      end do
   end subroutine note_records
end module dg_run_deck
