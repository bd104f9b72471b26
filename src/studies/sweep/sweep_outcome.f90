!> What became of the points of a sweep.
module dg_sweep_outcome
   use dg_case_result, only: result_locked_up, result_not_converged
   use dg_point_outcome, only: note_points
   use dg_run_outcome, only: add_part, outcome_type
   use dg_sweep, only: sweep_type
   use dg_sweep_result, only: sweep_result_type
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: note_sweep

contains

   !> The points of a sweep. Those that failed have a row each; neighbouring depths that lock up have one. `sentences` tell which
   !> limits the sweep passes.
   pure subroutine note_sweep(outcome, sweep, points, sentences)
      type(outcome_type), intent(inout) :: outcome
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)     !< in the order of their numbers
      type(text_type), intent(in) :: sentences(:)
      integer :: i, last
      do i = 1, size(sentences)
         call append_text(outcome%sentences, sentences(i)%text)
      end do
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
end module dg_sweep_outcome
