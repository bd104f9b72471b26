!> Confirms by beams that a load case locks up.
!>
!> The soft string with the friction of coils finds that a string locks up, and the greatest load that comes to its bit. Beams
!> should find an equilibrium at a little less than this load; where they do not, the message says so. Cases without a profile, as
!> those of sweeps, are not confirmed: their neighbours are solved anyway.
module dg_confirm_lock_up
   use dg_kinds, only: wp
   use dg_case_result, only: add_sentence, case_result_type, result_converged, result_locked_up, result_not_converged
   use dg_error, only: error_type
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_stopping, only: stop_type
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_force
   use dg_weight_on_bit, only: bearable_force
   implicit none
   private
   public :: confirm_lock_up

   !> Beams are asked for a load that is less by this part of it [-].
   real(wp), parameter :: less = 0.05_wp
   !> Iterations at most: where beams confirm, they took up to 270.
   integer, parameter :: most_iterations = 400
   !> Digits in a message.
   integer, parameter :: shown = 4

contains

   !> Takes one more solution where the result is locked up. Its iterations and seconds are added.
   subroutine confirm_lock_up(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(model_type) :: eased
      type(case_result_type) :: found
      type(error_type), allocatable :: error
      character(:), allocatable :: load
      if (result%status /= result_locked_up .or. is_missing(result%lock_up_load)) return
      if (abs(result%lock_up_load) > bearable_force(model, case_index)) return
      eased = model
      eased%cases(case_index)%wob = result%lock_up_load - less*abs(result%lock_up_load)
      eased%numerics%max_iterations = min(eased%numerics%max_iterations, most_iterations)
      call solve_static_analysis(eased, case_index, found, error, totals_only=.true., stop=stop)
      result%iterations = found%iterations
      result%seconds = result%seconds + found%seconds
      if (allocated(error)) found%status = result_not_converged
      if (found%status == result_converged) return
      load = 'a weight on bit of '
      if (result%lock_up_load < 0.0_wp) load = 'a pull at the bit of '
      load = load//trim(in_units(model%units, unit_force, abs(eased%cases(case_index)%wob), shown))
      call add_sentence(result%message, 'Beams do not confirm it: with '//load//', which should come down, they found no '// &
                        'equilibrium in '//to_text(found%iterations)//' iterations')
   end subroutine confirm_lock_up
end module dg_confirm_lock_up
