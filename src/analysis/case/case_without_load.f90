!> Solve a case that string weight cannot move down once more, without weight on bit.
!>
!> Friction of helical buckling grows with the square of compression. A result that is pushed hard therefore says little about
!> the string. The result without weight on bit shows whether it comes down at all. It also shows the ratio of friction by
!> beams to friction by the soft string.
module dg_case_without_load
   use dg_kinds, only: wp
   use dg_weight_on_bit, only: weight_that_arrives
   use dg_case_result, only: add_sentence, case_result_type, result_converged, result_locked_up, without_load_type
   use dg_load_case, only: rotates
   use dg_model, only: model_type
   use dg_solve_again, only: comes_short, solve_again
   use dg_stopping, only: stop_type
   use dg_text, only: either
   use dg_unit_kind, only: at_most, in_units, unit_force
   use dg_weight_on_bit, only: matching_friction
   implicit none
   private
   public :: solve_without_load

   !> Digits in a message.
   integer, parameter :: shown = 4

contains

   !> Set `result%without_load` of a string that goes down under weight on bit, does not rotate, and locks up or needs more push
   !> than `max_push`. Iterations and seconds are added. The message of a lock-up gets the weight that comes to the bit.
   subroutine solve_without_load(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      associate (load_case => model%cases(case_index))
         if (.not. (load_case%wob > 0.0_wp .and. comes_short(model, case_index, result))) return
         if (.not. rotates(load_case%operation)) call solve_bare(model, case_index, stop, result)
      end associate
      if (result%status == result_locked_up .and. result%lock_up_load > 0.0_wp) call add_sentence(result%message, &
         either('With max_push ', 'Without a push ', model%rig%max_push > 0.0_wp)// &
         in_units(model%units, unit_force, at_most(model%units, unit_force, &
                                                        weight_that_arrives(model, result), shown), shown)//' reach it')
   end subroutine solve_without_load

   !> Solve without weight on bit, and find the factor of friction that the solution shows.
   subroutine solve_bare(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(model_type) :: bare
      type(case_result_type) :: found
      real(wp) :: scale
      bare = model
      bare%cases(case_index)%wob = 0.0_wp
      bare%cases(case_index)%tob = 0.0_wp       ! the bit is off bottom
      call solve_again(bare, case_index, stop, result%seconds, result%iterations, found)
      result%without_load = without_load_type(found%status, found%hookload)
      if (found%status /= result_converged) return
      scale = matching_friction(model, case_index, 0.0_wp, found%hookload)
      if (scale > 0.0_wp) result%without_load%friction_scale = scale
   end subroutine solve_bare
end module dg_case_without_load
