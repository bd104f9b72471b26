!> Outcome of every solution of a run: the wanted number of each part, the number found, and those that are missing. The
!> headline of the page shows it, and agrees with the exit status.
module dg_run_outcome
   use dg_case_result, only: case_result_type, result_locked_up, result_not_converged, result_status_name
   use dg_column, only: add, quantity_length, quantity_none, quantity_text, row_type
   use dg_job, only: model_name
   use dg_load_case, only: load_case_type, operation_name
   use dg_kinds, only: wp
   use dg_missing, only: given, optional_real
   use dg_text, only: text_or_nothing, text_type
   implicit none
   private
   public :: outcome_type, lost_type, swept_type, add_part, note_lost, note_cases, add_lost, part_row, lost_row, solution_count, &
             lost_count, locked_count, case_part

   !> Load cases, a sweep, a Monte Carlo, a calibration, a steering.
   type :: part_type
      character(:), allocatable :: name
      integer :: solutions = 0         !< asked for
      integer :: locked_up = 0
      integer :: not_converged = 0     !< the exit status tells of these
   end type part_type

   !> Solutions that failed or locked up.
   type :: lost_type
      character(:), allocatable :: part
      character(:), allocatable :: case, model, operation    !< names; not allocated where there is none
      type(optional_real) :: bit_depth                       !< [m]
      type(optional_real) :: down_to                         !< last of neighbouring depths [m]
      type(optional_real) :: friction, friction_cased        !< coefficients; absent: those of the hole sections [-]
      integer :: solutions = 1
      integer :: status = result_not_converged
      character(:), allocatable :: message
   end type lost_type

   !> A sweep over bit depth.
   type :: swept_type
      character(:), allocatable :: name, string
      character(:), allocatable :: frictions     !< its own factors; '': those of the hole sections
      real(wp) :: deepest = 0.0_wp               !< bit depth [m]
   end type swept_type

   type :: outcome_type
      type(part_type), allocatable :: parts(:)
      type(lost_type), allocatable :: lost(:)
      type(swept_type), allocatable :: swept(:)
      integer :: unlisted = 0                           !< rows that were too many
      type(text_type), allocatable :: sentences(:)      !< of studies, for the head of the page
   end type outcome_type

   !> Name of the part that are the load cases.
   character(*), parameter :: case_part = 'load cases'
   !> Most rows of a run: a Monte Carlo may lose thousands of solutions.
   integer, parameter :: most_rows = 300

contains

   !> A part of the run.
   pure subroutine add_part(outcome, name, solutions, locked_up, not_converged)
      type(outcome_type), intent(inout) :: outcome
      character(*), intent(in) :: name
      integer, intent(in) :: solutions, locked_up, not_converged
      if (.not. allocated(outcome%parts)) allocate (outcome%parts(0))
      outcome%parts = [outcome%parts, part_type(name, solutions, locked_up, not_converged)]
   end subroutine add_part

   !> The load cases of a deck, each with each model. Answers and warnings name those without a solution.
   pure subroutine note_cases(outcome, results)
      type(outcome_type), intent(inout) :: outcome
      type(case_result_type), intent(in) :: results(:)
      call add_part(outcome, case_part, size(results), count(results%status == result_locked_up), &
                    count(results%status == result_not_converged))
   end subroutine note_cases

   !> Note a missing result of a part: of a load case, or of a fit of several.
   pure subroutine note_lost(outcome, part, model, status, message, load_case)
      type(outcome_type), intent(inout) :: outcome
      character(*), intent(in) :: part
      integer, intent(in) :: model       !< its number; 0: none
      integer, intent(in) :: status
      character(*), intent(in) :: message
      type(load_case_type), intent(in), optional :: load_case
      type(lost_type) :: lost
      lost%part = part
      lost%status = status
      lost%message = message
      if (model > 0) lost%model = trim(model_name(model))
      if (present(load_case)) then
         lost%case = load_case%name
         lost%operation = trim(operation_name(load_case%operation))
         lost%bit_depth = given(load_case%bit_depth)
         lost%friction = load_case%friction_axial
      end if
      call add_lost(outcome, lost)
   end subroutine note_lost

   !> Solutions that failed or locked up; beyond the most that a page lists they are counted.
   pure subroutine add_lost(outcome, lost)
      type(outcome_type), intent(inout) :: outcome
      type(lost_type), intent(in) :: lost
      if (.not. allocated(outcome%lost)) allocate (outcome%lost(0))
      if (size(outcome%lost) == most_rows) then
         outcome%unlisted = outcome%unlisted + 1
      else
         outcome%lost = [outcome%lost, lost]
      end if
   end subroutine add_lost

   !> A part in the columns of the page.
   pure function part_row(part) result(row)
      type(part_type), intent(in) :: part
      type(row_type) :: row
      call add(row, 'part', quantity_text, 'of the run', part%name)
      call add(row, 'solutions', quantity_none, 'that it asks for', part%solutions)
      call add(row, 'converged', quantity_none, 'are solutions', part%solutions - part%locked_up - part%not_converged)
      call add(row, 'locked_up', quantity_none, 'the string cannot be brought there: an answer, no failure', part%locked_up)
      call add(row, 'not_converged', quantity_none, 'failed: the exit status tells of them', part%not_converged)
   end function part_row

   !> Row of a missing solution, in the columns of the page.
   pure function lost_row(lost) result(row)
      type(lost_type), intent(in) :: lost
      type(row_type) :: row
      call add(row, 'part', quantity_text, 'of the run', lost%part)
      call add(row, 'case', quantity_text, 'load case', text_or_nothing(lost%case))
      call add(row, 'model', quantity_text, 'as in summary.csv', text_or_nothing(lost%model))
      call add(row, 'operation', quantity_text, 'long name of the operation', text_or_nothing(lost%operation))
      call add(row, 'bit_depth', quantity_length, 'measured depth of the bit', lost%bit_depth)
      call add(row, 'down_to', quantity_length, 'last of neighbouring depths', lost%down_to)
      call add(row, 'friction', quantity_none, 'coefficient along the hole; none: those of the hole sections', lost%friction)
      call add(row, 'friction_cased', quantity_none, 'coefficient in cased sections', lost%friction_cased)
      call add(row, 'solutions', quantity_none, 'points or samples that are told here', lost%solutions)
      call add(row, 'status', quantity_text, 'as in the files of results', result_status_name(lost%status))
      call add(row, 'message', quantity_text, 'reason of the first', text_or_nothing(lost%message))
   end function lost_row

   !> Solutions that all parts ask for.
   pure function solution_count(outcome) result(number)
      type(outcome_type), intent(in) :: outcome
      integer :: number
      number = 0
      if (allocated(outcome%parts)) number = sum(outcome%parts%solutions)
   end function solution_count

   !> Those that failed.
   pure function lost_count(outcome) result(number)
      type(outcome_type), intent(in) :: outcome
      integer :: number
      number = 0
      if (allocated(outcome%parts)) number = sum(outcome%parts%not_converged)
   end function lost_count

   !> Those that lock up.
   pure function locked_count(outcome) result(number)
      type(outcome_type), intent(in) :: outcome
      integer :: number
      number = 0
      if (allocated(outcome%parts)) number = sum(outcome%parts%locked_up)
   end function locked_count
end module dg_run_outcome
