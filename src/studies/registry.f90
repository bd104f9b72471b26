!> All studies that a deck may ask for: the one place that knows them. A new one is a room of its own and a line here.
module dg_registry
   use dg_accuracy_study, only: accuracy_study_type
   use dg_calibrate_keys, only: calibrate_keys, calibrate_rule
   use dg_calibration_study, only: calibration_study_type
   use dg_deck_keys, only: scene_groups
   use dg_deck_schema, only: add_group, group_keys_type
   use dg_error, only: error_type
   use dg_exit_status, only: note_ending, note_failure
   use dg_friction_estimate, only: friction_estimate_type
   use dg_interruption, only: is_interrupted
   use dg_job, only: job_type
   use dg_legacy_keys, only: legacy_keys, legacy_rule
   use dg_legacy_study, only: legacy_study_type
   use dg_steering_keys, only: steering_keys, steering_rule
   use dg_steering_study, only: steering_study_type
   use dg_sticking_study, only: sticking_study_type
   use dg_line_list, only: line_list_type, move_lines
   use dg_study, only: phase_cases, phase_points, run_type, study_type
   use dg_study_keys, only: study_keys, study_rule
   use dg_sweep_keys, only: sweep_keys, sweep_rule
   use dg_sweep_study, only: sweep_study_type
   use dg_text, only: append_text, text_type
   use dg_uncertainty_keys, only: uncertainty_keys, uncertainty_rule
   use dg_uncertainty_study, only: uncertainty_study_type
   implicit none
   private
   public :: studies_type, register_studies, deck_groups, name_studies, echo_studies, run_phase, have_points

   !> One study, of whatever type.
   type :: study_item_type
      class(study_type), allocatable :: study
   end type study_item_type

   type :: studies_type
      type(study_item_type), allocatable :: items(:)
      type(friction_estimate_type), allocatable :: estimates(:)   !< that they will find, in the order of the deck
   end type studies_type

contains

   !> The studies in the order in which they are read, told and drawn, and run within their phase. One that goes on from what
   !> another finds out about friction comes after it.
   subroutine register_studies(studies)
      type(studies_type), intent(out) :: studies
      allocate (studies%items(7))
      allocate (sweep_study_type :: studies%items(1)%study)
      allocate (calibration_study_type :: studies%items(2)%study)
      allocate (sticking_study_type :: studies%items(3)%study)
      allocate (uncertainty_study_type :: studies%items(4)%study)
      allocate (accuracy_study_type :: studies%items(5)%study)
      allocate (steering_study_type :: studies%items(6)%study)
      allocate (legacy_study_type :: studies%items(7)%study)
   end subroutine register_studies

   !> Groups that a deck may have, with their keys: those of the scene, then those of all studies.
   subroutine deck_groups(groups)
      type(group_keys_type), allocatable, intent(out) :: groups(:)
      call scene_groups(groups)
      call add_group(groups, sweep_rule, sweep_keys)
      call add_group(groups, calibrate_rule, calibrate_keys)      ! of strings that are held, too
      call add_group(groups, uncertainty_rule, uncertainty_keys)
      call add_group(groups, study_rule, study_keys)
      call add_group(groups, steering_rule, steering_keys)
      call add_group(groups, legacy_rule, legacy_keys)
   end subroutine deck_groups

   !> Enters the names of files that studies write into the job, for the part of it that is at hand.
   subroutine name_studies(studies, job)
      type(studies_type), intent(in) :: studies
      type(job_type), intent(inout) :: job
      type(text_type), allocatable :: records(:), files(:), forms(:), kinds(:)
      integer :: i
      allocate (records(0), files(0), forms(0), kinds(0))
      do i = 1, size(studies%items)
         associate (study => studies%items(i)%study)
            ! a run that joins parts writes what has points alone
            if (study%asked .and. (job%merge == 0 .or. study%phase == phase_points)) call append_new(files, study%files)
            call append_new(forms, study%forms)
            if (allocated(study%record_kind)) call append_text(kinds, study%record_kind)
            call study%name_records(job, records)
         end associate
      end do
      job%study_files = files
      job%study_records = records
      job%study_forms = forms
      job%study_kinds = kinds
   end subroutine name_studies

   !> Appends names that are not in the list: some studies write rows of one file.
   pure subroutine append_new(list, names)
      type(text_type), allocatable, intent(inout) :: list(:)
      type(text_type), intent(in) :: names(:)
      integer :: i, k
      do i = 1, size(names)
         if (any([(list(k)%text == names(i)%text, k=1, size(list))])) cycle
         call append_text(list, names(i)%text)
      end do
   end subroutine append_new

   !> Summaries of a deck by studies: those that run with the load cases at last.
   subroutine echo_studies(studies, job, before, after)
      type(studies_type), intent(in) :: studies
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(out) :: before(:), after(:)
      type(line_list_type) :: first, last
      integer :: i
      do i = 1, size(studies%items)
         associate (study => studies%items(i)%study)
            if (study%phase == phase_cases) then
               call study%echo(job, last)
            else
               call study%echo(job, first)
            end if
         end associate
      end do
      call move_lines(first, before)
      call move_lines(last, after)
   end subroutine echo_studies

   !> Runs the studies of a phase. What fails is printed and raises the exit status of the run; the next one goes on.
   subroutine run_phase(studies, phase, run, what)
      type(studies_type), intent(inout) :: studies
      integer, intent(in) :: phase
      type(run_type), intent(inout) :: run
      character(*), intent(in) :: what       !< name of them all, for the message that a signal came first; '': each prints its own
      type(error_type), allocatable :: error
      integer :: i
      do i = 1, size(studies%items)
         associate (study => studies%items(i)%study)
            if (study%phase /= phase .or. .not. study%asked) cycle
            if (is_interrupted() .and. what /= '') then
               call note_ending(what, run%status)
               exit
            end if
            call study%run(run, error)
            call note_failure(error, run%status)
         end associate
      end do
   end subroutine run_phase

   !> True if any study has numbered points, of which parts can be solved.
   function have_points(studies) result(have)
      type(studies_type), intent(in) :: studies
      logical :: have
      integer :: i
      have = any([(studies%items(i)%study%asked .and. studies%items(i)%study%phase == phase_points, i=1, size(studies%items))])
   end function have_points
end module dg_registry
