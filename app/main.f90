!> Torque and drag of drillstrings with beams and multi-directional contact gap elements: the program. It
!> reads the command line and the deck, hands over, prints what went wrong, ends with the status of the
!> contract. The only place where the program ends.
program main
   use dg_arguments, only: arguments_type, read_arguments, usage_lines
   use dg_deck_echo, only: echo_lines
   use dg_diagnostic, only: report_line, report_lines
   use dg_error, only: error_lines, error_list_type, error_type, status_bad_input, status_failure, status_ok
   use dg_job, only: is_divided, job_type
   use dg_model, only: model_type
   use dg_printed_text, only: print_line, print_lines
   use dg_process, only: begin_process, end_process
   use dg_process_memory, only: keep_freed_memory
   use dg_read_deck, only: read_deck
   use dg_registry, only: echo_studies, have_points, name_studies, studies_type
   use dg_run_action, only: run_action
   use dg_run_deck, only: run_deck
   use dg_standard_output, only: guard_descriptors, output_failed
   use dg_text, only: text_type
   use dg_version, only: program_name, program_version
   use dg_well_head, only: well_head
   use dg_written_files, only: check_inputs, check_links
   implicit none
   type(arguments_type) :: arguments
   type(error_type), allocatable :: error
   type(text_type), allocatable :: usage(:)
   integer :: status

   call guard_descriptors()
   call begin_process()
   call keep_freed_memory()
   call usage_lines(usage)
   call read_arguments(arguments, error)
   if (allocated(error)) then
      call report_line(error%message)
      status = error%status
   else if (arguments%help) then
      call print_lines(usage)
      status = status_ok
   else if (arguments%version) then
      call print_line(program_name//' '//program_version)
      status = status_ok
   else if (arguments%action /= '') then
      call run_action(arguments, status)
   else
      call work(arguments, status)
   end if
   if (output_failed()) then
      call report_line('not all could be written to standard output (is the disk full?)')
      status = status_failure
   end if
   call end_process(status)

contains

   !> Everything that needs a deck.
   subroutine work(arguments, status)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status
      type(model_type) :: model
      type(job_type) :: job
      type(studies_type) :: studies
      type(error_list_type) :: faults
      type(error_type), allocatable :: error
      character(:), allocatable :: refusal
      integer :: i

      call read_deck(arguments%deck, model, job, faults, studies)
      if (faults%count > 0) then
         call report_lines(error_lines(faults))
         status = status_bad_input
         return
      end if
      if (arguments%output_dir /= '') job%output_dir = arguments%output_dir
      job%quiet = arguments%quiet
      if (arguments%threads_given) job%threads = arguments%threads
      job%parts = arguments%parts
      job%merge = arguments%merge
      job%again = arguments%again
      refusal = ''
      if (job%output_dir == '') then
         refusal = ': no folder of results is named. Give output_dir in &job, or --output DIR'
      else if (is_divided(job) .and. .not. have_points(studies)) then
         refusal = ' has no &sweep and no &uncertainty; nothing else can be divided into parts'
      else if (job%again .and. .not. have_points(studies)) then
         refusal = ' has no &sweep and no &uncertainty; --again is for their points. Load cases are solved by every run: leave '// &
                   '--again out'
      end if
      if (refusal /= '') then
         call report_line(job%deck_path//refusal)
         status = status_bad_input
         return
      end if
      do i = 1, size(arguments%chosen)
         job%part = arguments%chosen(i)
         call name_studies(studies, job)
         call check_inputs(job, model, error)
         if (.not. allocated(error)) call check_links(job, model, error)
         if (allocated(error)) exit
      end do
      if (allocated(error)) then
         call report_line(error%message)
         status = error%status
         return
      end if
      if (arguments%check) then
         call print_echo(job, model, studies)
         status = status_ok
         return
      end if
      if (.not. job%quiet .and. (size(model%cases) == 0 .or. is_divided(job))) call print_notes(job%notes)
      call run_deck(job, model, studies, arguments%chosen, status)
   end subroutine work

   !> Print the summary of a deck, for a run that only checks it.
   subroutine print_echo(job, model, studies)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(studies_type), intent(in) :: studies
      type(text_type), allocatable :: lines(:), before(:), after(:)
      integer :: i
      call print_line(program_name//' '//program_version//', check of '//job%deck_path//': no fault found, nothing solved')
      do i = 1, size(job%notes)
         call print_line('note        '//job%notes(i)%text)
      end do
      call print_lines(well_head(job%units, model))
      call echo_studies(studies, job, before, after)
      call echo_lines(job, model, before, after, lines)
      call print_lines(lines)
   end subroutine print_echo

   !> Print notes on legal but unlikely input. Load cases have a block of warnings for it.
   subroutine print_notes(notes)
      type(text_type), intent(in) :: notes(:)
      integer :: i
      do i = 1, size(notes)
         call report_line('note: '//notes(i)%text)
      end do
   end subroutine print_notes
end program main
