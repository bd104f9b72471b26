!> drillgap: torque and drag of drillstrings with beams and multi-directional contact gap elements.
!> Reads the command line and the deck, hands over, prints what went wrong, ends with the status of the
!> contract. The only place where the program ends.
program main
   use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
   use dg_arguments, only: arguments_type, read_arguments, print_usage
   use dg_deck_echo, only: print_echo
   use dg_diagnostic, only: tell, tell_faults
   use dg_error, only: error_type, status_ok, status_bad_input
   use dg_fault_list, only: fault_list_type
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_process, only: end_process
   use dg_process_memory, only: keep_freed_memory
   use dg_read_deck, only: read_deck
   use dg_run_action, only: run_action
   use dg_run_deck, only: run_deck
   use dg_text, only: text_type
   use dg_version, only: program_name, program_version
   implicit none
   type(arguments_type) :: arguments
   type(error_type), allocatable :: error
   integer :: status

   call keep_freed_memory()
   call read_arguments(arguments, error)
   if (allocated(error)) then
      call tell(error%message)
      call print_usage(error_unit)
      status = error%status
   else if (arguments%help) then
      call print_usage(output_unit)
      status = status_ok
   else if (arguments%version) then
      write (output_unit, '(a)') program_name//' '//program_version
      status = status_ok
   else if (arguments%action /= '') then
      call run_action(arguments%action, arguments%deck, status)
   else
      call work(arguments, status)
   end if
   call end_process(status)

contains

   !> Everything that needs a deck.
   subroutine work(arguments, status)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status
      type(model_type) :: model
      type(job_type) :: job
      type(text_type), allocatable :: notes(:)
      type(fault_list_type) :: faults

      allocate (notes(0))   ! the compiler's flow analysis takes them for undefined otherwise
      call read_deck(arguments%deck, model, job, notes, faults)
      if (faults%count > 0) then
         call tell_faults(faults)
         status = status_bad_input
         return
      end if
      if (arguments%output_dir /= '') job%output_dir = arguments%output_dir
      job%quiet = arguments%quiet
      if (arguments%threads_given) job%threads = arguments%threads
      job%part = arguments%part
      job%parts = arguments%parts
      job%merge = arguments%merge
      if (max(job%parts, job%merge) > 0 .and. size(job%sweeps) + size(job%uncertainties) == 0) then
         call tell(arguments%deck//' has no &sweep and no &uncertainty; nothing else can be divided into parts')
         status = status_bad_input
         return
      end if
      if (arguments%check) then
         call print_echo(output_unit, job, model, notes)
         status = status_ok
         return
      end if
      if (.not. job%quiet) call print_notes(notes)
      call run_deck(job, model, status)
   end subroutine work

   !> What is legal in the deck but hardly meant.
   subroutine print_notes(notes)
      type(text_type), intent(in) :: notes(:)
      integer :: i
      do i = 1, size(notes)
         call tell('note: '//notes(i)%text)
      end do
   end subroutine print_notes
end program main
