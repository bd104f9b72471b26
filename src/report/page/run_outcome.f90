!> What became of every solution of a run: how many each part of it asked for, how many are there, and which are not. The page of
!> the run says it in its headline, so that it says what the exit status says.
module dg_run_outcome
   use dg_case_result, only: case_result_type, result_locked_up, result_not_converged, result_status_name
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_length, quantity_none, quantity_text
   use dg_job, only: model_name
   use dg_load_case, only: load_case_type, operation_name
   use dg_model, only: model_type
   use dg_text, only: text_or_nothing, text_type
   implicit none
   private
   public :: outcome_type, part_columns, lost_columns, add_part, note_lost, note_cases, add_lost_row, &
             part_fields, solution_count, lost_count, locked_count

   !> Load cases, a sweep, a Monte Carlo, a calibration, a steering.
   type :: part_type
      character(:), allocatable :: name
      integer :: solutions = 0         !< asked for
      integer :: locked_up = 0
      integer :: not_converged = 0     !< the exit status tells of these
   end type part_type

   type :: outcome_type
      type(part_type), allocatable :: parts(:)
      type(field_list_type), allocatable :: lost(:)     !< rows of `lost_columns`
      integer :: unlisted = 0                           !< rows that were too many
      type(text_type), allocatable :: sentences(:)      !< of studies, for the head of the page
   end type outcome_type

   !> Rows of a run: a page is to be read, and a Monte Carlo may lose thousands.
   integer, parameter :: most_rows = 300

   type(column_type), parameter :: part_columns(5) = [ &
      column_type('part', quantity_text, 'of the run'), &
      column_type('solutions', quantity_none, 'that it asks for'), &
      column_type('converged', quantity_none, 'are solutions'), &
      column_type('locked_up', quantity_none, 'the string cannot be brought there: an answer, no failure'), &
      column_type('not_converged', quantity_none, 'failed: the exit status tells of them')]

   type(column_type), parameter :: lost_columns(11) = [ &
      column_type('part', quantity_text, 'of the run'), &
      column_type('case', quantity_text, 'load case'), &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('operation', quantity_text, 'long name of the operation'), &
      column_type('bit_depth', quantity_length, 'measured depth of the bit'), &
      column_type('down_to', quantity_length, 'last of neighbouring depths'), &
      column_type('friction', quantity_none, 'coefficient along the hole; none: those of the hole sections'), &
      column_type('friction_cased', quantity_none, 'coefficient in cased sections'), &
      column_type('solutions', quantity_none, 'points or samples that are told here'), &
      column_type('status', quantity_text, 'as in the files of results'), &
      column_type('message', quantity_text, 'reason of the first')]

contains

   !> A part of the run.
   pure subroutine add_part(outcome, name, solutions, locked_up, not_converged)
      type(outcome_type), intent(inout) :: outcome
      character(*), intent(in) :: name
      integer, intent(in) :: solutions, locked_up, not_converged
      type(part_type), allocatable :: longer(:)
      integer :: i
      if (.not. allocated(outcome%parts)) allocate (outcome%parts(0))
      allocate (longer(size(outcome%parts) + 1))
      do i = 1, size(outcome%parts)
         longer(i) = outcome%parts(i)
      end do
      associate (part => longer(size(longer)))
         part%name = name
         part%solutions = solutions
         part%locked_up = locked_up
         part%not_converged = not_converged
      end associate
      call move_alloc(longer, outcome%parts)
   end subroutine add_part

   !> The load cases of a deck, each with each model. Those that lock up have their row in the answers.
   pure subroutine note_cases(outcome, model, results)
      type(outcome_type), intent(inout) :: outcome
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      character(*), parameter :: name = 'load cases'
      integer :: i
      call add_part(outcome, name, size(results), count(results%status == result_locked_up), &
                    count(results%status == result_not_converged))
      do i = 1, size(results)
         if (results(i)%status == result_not_converged) call note_lost(outcome, name, results(i)%model, results(i)%status, &
            text_or_nothing(results(i)%message), model%cases(results(i)%case_index))
      end do
   end subroutine note_cases

   !> What a part asked for and is not there: a load case, or a fit of several.
   pure subroutine note_lost(outcome, part, model, status, message, load_case)
      type(outcome_type), intent(inout) :: outcome
      character(*), intent(in) :: part
      integer, intent(in) :: model       !< its number; 0: none
      integer, intent(in) :: status
      character(*), intent(in) :: message
      type(load_case_type), intent(in), optional :: load_case
      type(field_list_type) :: row
      integer :: i
      call put(row, part)
      if (present(load_case)) then
         call put(row, load_case%name)
      else
         call put_none(row)
      end if
      if (model > 0) then
         call put(row, trim(model_name(model)))
      else
         call put_none(row)
      end if
      if (present(load_case)) then
         call put(row, trim(operation_name(load_case%operation)))
         call put(row, load_case%bit_depth)
         call put_none(row)
         call put(row, load_case%friction_axial)
         call put_none(row)
      else
         do i = 1, 5      ! operation, depths, frictions
            call put_none(row)
         end do
      end if
      call put(row, 1)
      call put(row, trim(result_status_name(status)))
      call put(row, message)
      call add_lost_row(outcome, row)
   end subroutine note_lost

   !> A row of `lost_columns`.
   pure subroutine add_lost_row(outcome, row)
      type(outcome_type), intent(inout) :: outcome
      type(field_list_type), intent(in) :: row
      type(field_list_type), allocatable :: longer(:)
      integer :: i
      if (.not. allocated(outcome%lost)) allocate (outcome%lost(0))
      if (size(outcome%lost) == most_rows) then
         outcome%unlisted = outcome%unlisted + 1
         return
      end if
      allocate (longer(size(outcome%lost) + 1))
      do i = 1, size(outcome%lost)
         longer(i) = outcome%lost(i)
      end do
      longer(size(longer)) = row
      call move_alloc(longer, outcome%lost)
   end subroutine add_lost_row

   !> Values of a part in the order of `part_columns`.
   pure subroutine part_fields(part, row)
      type(part_type), intent(in) :: part
      type(field_list_type), intent(inout) :: row
      row%count = 0
      call put(row, part%name)
      call put(row, part%solutions)
      call put(row, part%solutions - part%locked_up - part%not_converged)
      call put(row, part%locked_up)
      call put(row, part%not_converged)
   end subroutine part_fields

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
