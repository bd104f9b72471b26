!> What became of points over bit depth: rows of those that are not there, for the page of the run.
module dg_point_outcome
   use dg_job, only: model_name
   use dg_load_case, only: given, operation_name, optional_real
   use dg_run_outcome, only: add_lost, lost_type, outcome_type
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
      type(lost_type) :: lost
      type(point_type) :: place, deepest
      place = point_at(sweep, first)
      deepest = point_at(sweep, last)
      lost%part = part
      lost%model = trim(model_name(sweep%models(place%model)))
      lost%operation = trim(operation_name(sweep%operations(place%operation)))
      lost%bit_depth = given(sweep%depths(place%depth))
      lost%down_to = optional_real(last > first, sweep%depths(deepest%depth))
      lost%friction = sweep%frictions(place%friction)
      if (allocated(sweep%frictions_cased)) lost%friction_cased = given(sweep%frictions_cased(place%friction))
      lost%solutions = solutions
      lost%status = found%status
      lost%message = text_or_nothing(found%message)
      if (present(sample)) lost%message = lost%message//sample
      call add_lost(outcome, lost)
   end subroutine note_points
end module dg_point_outcome
