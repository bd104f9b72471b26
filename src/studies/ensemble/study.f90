!> Interface of every study: many load cases, or one repeatedly, for one question of a deck. It reads its groups, prints a
!> summary of them, runs, and adds its files and pictures. Studies do not depend on each other. Results for other studies are
!> in the run.
module dg_study
   use dg_case_memory, only: need_type
   use dg_csv_table, only: csv_table_type
   use dg_deck_draft, only: deck_type
   use dg_error, only: error_list_type, error_type
   use dg_findings, only: findings_type
   use dg_friction_estimate, only: friction_estimate_type
   use dg_job, only: job_type
   use dg_line_list, only: line_list_type
   use dg_model, only: model_type
   use dg_part_faults, only: part_faults_type
   use dg_picture_list, only: picture_list_type
   use dg_printed_text, only: printed_text_type
   use dg_text, only: text_type
   implicit none
   private
   public :: study_type, run_type
   public :: phase_first, phase_cases, phase_after, phase_points

   ! When a study runs, in this order.
   integer, parameter :: phase_first = 1     !< before the load cases, whose friction it changes
   integer, parameter :: phase_cases = 2     !< with the load cases, whose results it has
   integer, parameter :: phase_after = 3     !< after them
   integer, parameter :: phase_points = 4    !< at last: it has numbered points, of which a divided run solves some

   !> Data shared by the studies of one run.
   type, extends(findings_type) :: run_type
      type(model_type) :: given                     !< as the deck has it
      type(friction_estimate_type), allocatable :: estimates(:) !< in the order of the deck
      type(csv_table_type) :: factors               !< rows of calibration.csv so far
      type(printed_text_type) :: printed            !< what the page takes as it was printed, and what became of solutions
      type(part_faults_type) :: part_faults         !< of parts that are to be joined
      logical :: written = .true.                   !< of points all files are
      logical :: points_lost = .false.              !< points did not converge
      integer :: status = 0                         !< exit status so far
   end type run_type

   !> A study; the components are set by reading a deck.
   type, abstract :: study_type
      logical :: asked = .false.                 !< the deck asks for it
      integer :: phase = phase_cases             !< when it runs
      logical :: fits = .false.                  !< it makes least squares, by LAPACK
      type(text_type), allocatable :: files(:)   !< names of the results of a run
      type(text_type), allocatable :: forms(:)   !< the same for any deck, '*' for something of the deck
      character(:), allocatable :: record_kind   !< beginning of names of records; not allocated: it keeps none
   contains
      procedure(read_interface), deferred :: read
      procedure(run_interface), deferred :: run
      procedure :: echo => echo_nothing
      procedure :: name_records => no_records
      procedure :: add_need => need_of_fits
      procedure :: prepare => prepare_nothing
      procedure :: finish => finish_nothing
      procedure :: add_pictures => no_pictures
   end type study_type

   abstract interface
      !> Read its groups of an open deck. Notes name legal but unusual settings.
      subroutine read_interface(self, deck, job, faults)
         import :: study_type, deck_type, job_type, error_list_type
         implicit none
         class(study_type), intent(inout) :: self
         type(deck_type), intent(inout) :: deck
         type(job_type), intent(inout) :: job     !< with the notes
         type(error_list_type), intent(inout) :: faults
      end subroutine read_interface

      !> Solve, print and write. Failures are reported and raise the status of the run. `error` prevents the following work.
      subroutine run_interface(self, run, error)
         import :: study_type, run_type, error_type
         implicit none
         class(study_type), intent(inout) :: self
         type(run_type), intent(inout) :: run
         type(error_type), allocatable, intent(out) :: error
      end subroutine run_interface
   end interface

contains

   !> Lines that summarise its groups.
   subroutine echo_nothing(self, job, lines)
      class(study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(line_list_type), intent(inout) :: lines
      associate (none => self, of_these => job, changes => lines)
      end associate
   end subroutine echo_nothing

   !> Names of records of unfinished work that a run of the job may write.
   subroutine no_records(self, job, names)
      class(study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(inout) :: names(:)
      associate (none => self, of_these => job, changes => names)
      end associate
   end subroutine no_records

   !> Memory that it takes beside load cases.
   subroutine need_of_fits(self, job, model, need)
      class(study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(need_type), intent(inout) :: need
      associate (none => job, of_these => model)
         need%fits = need%fits .or. (self%asked .and. self%fits)
      end associate
   end subroutine need_of_fits

   !> Find reasons not to run, before results of an earlier run are removed: an error, or faults of parts in the run.
   subroutine prepare_nothing(self, run, error)
      class(study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      associate (none => self, of_these => run)
         if (allocated(error)) deallocate (error)
      end associate
   end subroutine prepare_nothing

   !> Close records of unfinished work, after all studies have run and written their files.
   subroutine finish_nothing(self, run)
      class(study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      associate (none => self, changes => run)
      end associate
   end subroutine finish_nothing

   !> Adds its pictures. Where there is an error already, nothing is done.
   subroutine no_pictures(self, run, list, error)
      class(study_type), intent(in) :: self
      type(run_type), intent(in) :: run
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      associate (none => self, of_these => run, not_needed => list, nor => error)
      end associate
   end subroutine no_pictures
end module dg_study
