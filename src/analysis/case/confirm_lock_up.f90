!> Confirms by beams that a load case locks up.
!>
!> The soft string with the friction of coils finds that a string locks up, and the greatest load that comes to its bit. Beams
!> should find an equilibrium at a little less than this load. Where they do not, the message says so, and with which smaller load
!> they do. Cases without a profile, as those of sweeps, are not confirmed: their neighbours are solved anyway.
module dg_confirm_lock_up
   use dg_kinds, only: wp
   use dg_case_result, only: add_sentence, case_result_type, result_converged, result_locked_up
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_solve_again, only: solve_again
   use dg_stopping, only: stop_type
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_force
   use dg_weight_on_bit, only: most_load_at_bit
   implicit none
   private
   public :: confirm_lock_up

   !> Beams are asked for loads that are less by these parts, one after the other until they find an equilibrium [-].
   real(wp), parameter :: less(4) = [0.05_wp, 0.1_wp, 0.2_wp, 0.5_wp]
   !> Iterations at most for the first, and for each other: where beams confirm the first, they took up to 390.
   integer, parameter :: most_iterations(4) = [400, 150, 150, 150]
   !> Part of the load that pipe bears without any friction from which it is not friction that locks the string up [-]: strings
   !> that turn.
   real(wp), parameter :: by_strength = 0.9_wp
   !> Digits in a message.
   integer, parameter :: shown = 4

contains

   !> Takes more solutions where the result is locked up: one that confirms, or up to three more for a load that beams bear. Their
   !> iterations and seconds are added.
   subroutine confirm_lock_up(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      real(wp) :: load
      integer :: i, iterations
      logical :: borne
      if (result%status /= result_locked_up .or. is_missing(result%lock_up_load)) return
      if (result%lock_up_load > by_strength*most_load_at_bit(model, case_index, coiled=.true., pushed=.true., &
                                                             friction_scale=0.0_wp)) return
      do i = 1, size(less)
         load = result%lock_up_load - less(i)*abs(result%lock_up_load)
         call try_load(model, case_index, load, most_iterations(i), stop, result, iterations, borne)
         if (i == 1 .and. .not. borne) &
            call add_sentence(result%message, 'These loads are by the soft string. Beams found no equilibrium with '// &
                              load_text(model, load)//' in '//to_text(iterations)//' iterations')
         if (borne) exit
      end do
      if (.not. borne .or. i == 1) return
      call add_sentence(result%message, 'They found one with '//load_text(model, load)//': use this load')
      result%lock_up_load = load
   end subroutine confirm_lock_up

   !> Solves the case with another load at the bit.
   subroutine try_load(model, case_index, load, most, stop, result, iterations, borne)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: load                !< [N], < 0: a pull
      integer, intent(in) :: most                 !< iterations
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      integer, intent(out) :: iterations          !< that it took
      logical, intent(out) :: borne               !< an equilibrium was found
      type(model_type) :: eased
      type(case_result_type) :: found
      eased = model
      eased%cases(case_index)%wob = load
      eased%numerics%max_iterations = min(eased%numerics%max_iterations, most)
      call solve_again(eased, case_index, stop, result, found)
      iterations = found%iterations
      borne = found%status == result_converged
   end subroutine try_load

   !> 'a weight on bit of 35 kN', 'a pull at the bit of 12 kN'.
   function load_text(model, load) result(text)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: load         !< [N], < 0: a pull
      character(:), allocatable :: text
      text = 'a weight on bit of '
      if (load < 0.0_wp) text = 'a pull at the bit of '
      text = text//in_units(model%units, unit_force, abs(load), shown)
   end function load_text
end module dg_confirm_lock_up
