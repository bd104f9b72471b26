!> What became of points over bit depth: rows of those that are not there, for the page of the run.
module dg_point_outcome
   use dg_case_result, only: result_status_name
   use dg_column, only: field_list_type, put, put_none
   use dg_job, only: model_name
   use dg_load_case, only: operation_name, optional_real
   use dg_run_outcome, only: add_lost_row, outcome_type
   use dg_sweep, only: point_at, point_type, sweep_type
   use dg_sweep_result, only: sweep_result_type
   use dg_text, only: text_or_nothing
   implicit none
   private
   public :: note_points

contains

   !> A row for neighbouring points of a curve.
   pure subroutine note_points(outcome, part, sweep, first, last, solutions, found, sample)
      type(outcome_type), intent(inout) :: outcome
      character(*), intent(in) :: part
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: first, last           !< numbers of the points
      integer, intent(in) :: solutions             !< that the row stands for
      type(sweep_result_type), intent(in) :: found !< the first of them
      character(*), intent(in), optional :: sample !< what tells the first from others at the same point
      type(field_list_type) :: row
      type(point_type) :: place, deepest
      place = point_at(sweep, first)
      deepest = point_at(sweep, last)
      call put(row, part)
      call put_none(row)
      call put(row, trim(model_name(sweep%models(place%model))))
      call put(row, trim(operation_name(sweep%operations(place%operation))))
      call put(row, sweep%depths(place%depth))
      call put(row, optional_real(last > first, sweep%depths(deepest%depth)))
      call put(row, sweep%frictions(place%friction))
      if (allocated(sweep%frictions_cased)) then
         call put(row, sweep%frictions_cased(place%friction))
      else
         call put_none(row)
      end if
      call put(row, solutions)
      call put(row, trim(result_status_name(found%status)))
      if (present(sample)) then
         call put(row, text_or_nothing(found%message)//sample)
      else
         call put(row, text_or_nothing(found%message))
      end if
      call add_lost_row(outcome, row)
   end subroutine note_points
end module dg_point_outcome
