!> Reads a deck with the groups of all studies.
module dg_read_deck
   use dg_deck_draft, only: deck_type
   use dg_deck_schema, only: group_keys_type
   use dg_deck_source, only: read_source
   use dg_error, only: add_fault, error_list_type
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_open_deck, only: close_deck, open_deck
   use dg_registry, only: deck_groups, register_studies, studies_type
   use dg_text, only: text_type
   implicit none
   private
   public :: read_deck, build_deck

contains

   !> Reads the deck `path` ('-': standard input). `model` and `job` are whole only where `faults%count` is 0. The notes of
   !> the job tell what is legal but unusual.
   subroutine read_deck(path, model, job, faults, studies)
      character(*), intent(in) :: path
      type(model_type), intent(out) :: model
      type(job_type), intent(out) :: job
      type(error_list_type), intent(out) :: faults
      type(studies_type), intent(out), optional :: studies   !< that the deck asks for
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name, failure
      call read_source(path, name, lines, failure)
      if (failure /= '') then
         call add_fault(faults, name, 0, 'deck '//failure)
         return
      end if
      call build_deck(name, lines, model, job, faults, studies)
   end subroutine read_deck

   !> The same of a deck whose lines are read already: a pipe gives them once.
   subroutine build_deck(path, lines, model, job, faults, studies)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(model_type), intent(out) :: model
      type(job_type), intent(out) :: job
      type(error_list_type), intent(out) :: faults
      type(studies_type), intent(out), optional :: studies
      type(studies_type) :: found
      type(deck_type) :: deck
      type(group_keys_type), allocatable :: rules(:)
      logical :: known
      integer :: i
      allocate (job%notes(0))
      call deck_groups(rules)
      call open_deck(path, lines, rules, deck, job, known, faults)
      if (.not. known) return
      call register_studies(found)
      do i = 1, size(found%items)
         call found%items(i)%study%read(deck, job, faults)
      end do
      call close_deck(deck, job, model, faults)
      if (.not. present(studies)) return
      call move_alloc(found%items, studies%items)
      call move_alloc(deck%estimates, studies%estimates)
   end subroutine build_deck
end module dg_read_deck
