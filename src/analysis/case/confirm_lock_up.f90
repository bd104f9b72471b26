!> Greatest load at the bit by beams, of a load case that locks up.
!>
!> The soft string with the friction of helical buckling finds lock-up, and the greatest load that comes to the bit. Beams
!> should find an equilibrium at a little less than this load. Close to lock-up the hook load changes up to a hundred times as
!> much as the load at the bit, and they may find none. The reverse problem is well conditioned: the bit is held, a hook load
!> is given, and the reaction at the bit is the load. The load of points of a sweep is not confirmed, as their neighbours are
!> solved anyway.
module dg_confirm_lock_up
   use dg_kinds, only: wp
   use dg_case_result, only: add_sentence, case_result_type, result_converged, result_locked_up, result_not_converged
   use dg_load_case, only: block_way
   use dg_lock_up_result, only: add_load_at_bit
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type
   use dg_soft_string_loads, only: other_loads_type, soft_string_at
   use dg_solve_again, only: solve_again
   use dg_stopping, only: is_stopped, stop_type
   use dg_trajectory, only: top_md
   use dg_weight_on_bit, only: most_load_at_bit
   implicit none
   private
   public :: confirm_lock_up

   !> Beams confirm the load of the soft string if they find an equilibrium at a load that is less by this part of it [-].
   real(wp), parameter :: confirming = 0.05_wp
   !> Parts by which loads are below that of the soft string [-]. The hook load of the soft string under each of them is given, one
   !> after the other until beams find an equilibrium. The first part gives nearly the greatest push. The others only give a
   !> possible load.
   real(wp), parameter :: less(3) = [0.01_wp, 0.05_wp, 0.2_wp]
   integer, parameter :: nearly = 1
   !> Most iterations under a load at the bit, and under a hook load. Of 32 strings that beams confirm under a load, two need 104
   !> and 126.
   integer, parameter :: quick = 130, under_hookload = 150
   !> A case without equilibrium may lock up if its load is above that of the soft string less this part of it [-].
   real(wp), parameter :: near_lock_up = 0.5_wp
   !> Largest shortfall of a load by beams below that of the soft string, over the latter, for which it is used [-].
   real(wp), parameter :: farthest = 2.0_wp
   !> Part of the load that pipe carries without friction [-]. Above it, strength and not friction limits the load, as in
   !> strings that turn.
   real(wp), parameter :: strong = 0.9_wp

contains

   !> Confirm the load of a result that is locked up, or report the smaller load that comes to the bit by beams. A string that
   !> is lowered and found no equilibrium is locked up if beams bring less than its load to the bit. Iterations and seconds are
   !> added.
   subroutine confirm_lock_up(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      if (result%status == result_locked_up) then
         if (.not. is_missing(result%lock_up_load)) call confirm_load(model, case_index, stop, result)
      else if (result%status == result_not_converged .and. block_way(model%cases(case_index)%operation) < 0 .and. &
               .not. is_stopped(stop)) then
         call look_for_lock_up(model, case_index, stop, result)
      end if
   end subroutine confirm_lock_up

   !> Confirm the load at which a string locks up, or say that beams find another one or none.
   subroutine confirm_load(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      character(:), allocatable :: by_soft      ! the end of the message
      real(wp) :: soft, lighter, load
      logical :: found
      soft = result%lock_up_load
      if (by_strength(model, case_index, soft)) return
      lighter = soft - confirming*abs(soft)
      call try_load(model, case_index, lighter, optional_real(), quick, stop, result, load, found)
      if (found) return
      call find_load(model, case_index, soft, size(less), stop, result, load, found)
      if (found) then
         if (load >= soft) return
         by_soft = ''
         call add_load_at_bit(model, soft, .false., by_soft)
         result%message = result%message(:index(result%message, by_soft) - 1)
         call add_load_at_bit(model, load, .true., result%message)
         result%lock_up_load = load
         return
      end if
      if (.not. is_stopped(stop)) &
         call add_sentence(result%message, 'This load is by the soft string. Beams found no equilibrium near it')
   end subroutine confirm_load

   !> Mark a lowered string without equilibrium as locked up where beams bring less to its bit than the load case asks for.
   subroutine look_for_lock_up(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      real(wp) :: soft, load
      logical :: found
      soft = most_load_at_bit(model, case_index, coiled=.true., pushed=.true.)
      if (model%cases(case_index)%wob < soft - near_lock_up*abs(soft)) return
      if (by_strength(model, case_index, soft)) return
      call find_load(model, case_index, soft, nearly, stop, result, load, found)
      if (.not. found .or. load >= model%cases(case_index)%wob) return
      result%status = result_locked_up
      result%lock_up_load = load
      result%message = 'Locked up: friction of helical buckling takes up any push from surface. '
      call add_load_at_bit(model, load, .true., result%message)
   end subroutine look_for_lock_up

   !> True where the strength of pipe, not friction, limits the load at the bit: in strings that turn.
   pure function by_strength(model, case_index, soft) result(is)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: soft                !< greatest load of the soft string [N]
      logical :: is
      is = soft > strong*most_load_at_bit(model, case_index, coiled=.true., pushed=.true., friction_scale=0.0_wp)
   end function by_strength

   !> Load at the bit under a great push by beams, with the bit held. A stiff assembly locks up at another load of the soft
   !> string, as its friction depends on that load.
   subroutine find_load(model, case_index, soft, tries, stop, result, load, found)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: soft                !< greatest load of the soft string [N], < 0: a pull
      integer, intent(in) :: tries                !< number of pushes of `less` to try
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      real(wp), intent(out) :: load               !< [N], < 0: a pull
      logical, intent(out) :: found               !< an equilibrium was found, with a load near enough to be used
      real(wp) :: axial(1), torque(1), greatest, start
      integer :: i
      greatest = soft
      do i = 1, tries
         start = greatest - less(i)*abs(greatest)
         call soft_string_at(model, case_index, [top_md(model%trajectory)], axial, torque, &
                             other=other_loads_type(coiled=.true., wob=given(start)))
         call try_load(model, case_index, start, given(axial(1)), under_hookload, stop, result, load, found)
         if (found) then
            found = load > soft - farthest*abs(soft)
            return
         end if
         if (.not. is_missing(load)) greatest = load
      end do
   end subroutine find_load

   !> Solve the case with another load at the bit, or with a given hook load and its bit held.
   subroutine try_load(model, case_index, start, hookload, iterations, stop, result, load, found)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: start               !< load at the bit, or its first value if a hook load is given [N]
      type(optional_real), intent(in) :: hookload !< [N]; absent: the load at the bit is given
      integer, intent(in) :: iterations           !< at most
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      real(wp), intent(out) :: load               !< at the bit [N]; without equilibrium the load at which the soft string locks up
      logical, intent(out) :: found               !< an equilibrium was found
      type(model_type) :: other
      type(case_result_type) :: solved
      other = model
      other%cases(case_index)%wob = start
      other%hookload = hookload
      other%numerics%max_iterations = min(model%numerics%max_iterations, iterations)
      call solve_again(other, case_index, stop, result%seconds, result%iterations, solved)
      found = solved%status == result_converged
      load = merge(solved%weight_on_bit, solved%lock_up_load, found)
   end subroutine try_load
end module dg_confirm_lock_up
