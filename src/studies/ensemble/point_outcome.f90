!> Outcome of points over bit depth: rows of the missing points, for the page of the run.
module dg_point_outcome
   use dg_case_result, only: result_locked_up, result_not_converged
   use dg_kinds, only: wp
   use dg_job, only: model_name
   use dg_load_case, only: operation_name
   use dg_missing, only: given, optional_real
   use dg_run_outcome, only: add_lost, add_part, lost_type, outcome_type, swept_type
   use dg_sweep, only: point_at, point_type, sweep_type
   use dg_sweep_result, only: sweep_result_type
   use dg_text, only: append_text, text_or_nothing, text_type, to_text
   implicit none
   private
   public :: note_points, note_sweep

   integer, parameter :: digits = 4

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

   !> The points of a sweep. Those that failed have a row each; neighbouring depths that lock up have one. `sentences` tell which
   !> limits the sweep passes.
   pure subroutine note_sweep(outcome, sweep, points, sentences)
      type(outcome_type), intent(inout) :: outcome
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)     !< in the order of their numbers
      type(text_type), intent(in) :: sentences(:)
      type(swept_type) :: one
      integer :: i, last
      do i = 1, size(sentences)
         call append_text(outcome%sentences, sentences(i)%text)
      end do
      if (.not. allocated(outcome%swept)) allocate (outcome%swept(0))
      one%name = sweep%name
      one%string = sweep%string
      one%frictions = frictions_of(sweep)
      one%deepest = maxval(sweep%depths)
      outcome%swept = [outcome%swept, one]
      associate (name => 'sweep '//sweep%name)
         call add_part(outcome, name, size(points), count(points%status == result_locked_up), &
                       count(points%status == result_not_converged))
         do i = 1, size(points)
            if (points(i)%status == result_not_converged) call note_points(outcome, name, sweep, i, i, 1, points(i))
         end do
         i = 1
         do while (i <= size(points))
            last = i
            if (points(i)%status == result_locked_up) then
               do while (modulo(last, size(sweep%depths)) /= 0)       ! depths count fastest
                  if (points(last + 1)%status /= result_locked_up) exit
                  last = last + 1
               end do
               call note_points(outcome, name, sweep, i, last, last - i + 1, points(i))
            end if
            i = last + 1
         end do
      end associate
   end subroutine note_sweep

   !> Range of the friction factors of a sweep, in words; '' for those of the hole sections.
   pure function frictions_of(sweep) result(text)
      type(sweep_type), intent(in) :: sweep
      character(:), allocatable :: text
      text = ''
      if (.not. all(sweep%frictions%present)) return
      text = range_of(sweep%frictions%value)
      if (allocated(sweep%frictions_cased)) text = range_of(sweep%frictions_cased)//' in cased hole, '//text//' in open hole'
   contains
      pure function range_of(values) result(range)
         real(wp), intent(in) :: values(:)
         character(:), allocatable :: range
         range = to_text(minval(values), digits)
         if (maxval(values) > minval(values)) range = range//' to '//to_text(maxval(values), digits)
      end function range_of
   end function frictions_of
end module dg_point_outcome
