!> Solve one load case by the model of a given number. Only this module calls all models.
module dg_solve_case
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers, result_not_converged
   use dg_component, only: has_bend
   use dg_error, only: error_type, raise, status_failure
   use dg_fluid_pressure, only: surface_push
   use dg_job, only: model_mcge, model_mixed, model_rigid, model_soft
   use dg_load_case, only: operation_sliding_drilling, operation_static
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: is_straightened, model_type, string_index
   use dg_rig, only: indicated_load
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_solve_by_beams, only: solve_by_beams
   use dg_static_result, only: add_message
   use dg_stopping, only: is_stopped, stop_reason, stop_type
   use dg_text, only: either, quoted, to_text
   use dg_unit_kind, only: in_units, unit_force
   implicit none
   private
   public :: solve_case

   !> Digits of forces in a message.
   integer, parameter :: shown = 4

contains

   !> Solve one case with one model. If that is refused, or is stopped before its end, the result is marked as not converged.
   !> The model is only read: several threads may solve cases of it.
   subroutine solve_case(model, number, case_index, result, error, totals_only, stop)
      type(model_type), intent(in) :: model
      integer, intent(in) :: number            !< of the model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      logical, intent(in), optional :: totals_only   !< true: no profile is wanted, which saves time in some models
      type(stop_type), intent(in), optional :: stop  !< absent: the case is solved to its end
      type(stop_type) :: stopped
      logical :: shortly
      integer, parameter :: nothing = 0
      if (present(stop)) stopped = stop
      shortly = .false.
      if (present(totals_only)) shortly = totals_only
      select case (merge(nothing, number, is_stopped(stopped)))
      case (nothing)
         result%message = 'not begun'
      case (model_mcge)
         call solve_by_beams(model, case_index, shortly, stopped, result, error)
      case (model_soft)
         call solve_soft_string(model, case_index, result, error, totals_only)
      case (model_rigid)
         call solve_rigid_string(model, case_index, result, error)
      case (model_mixed)
         call solve_mixed_string(model, case_index, result, error, stop)
      case default
         call raise(error, status_failure, 'no model of number '//to_text(number))
      end select
      if (allocated(error)) then
         result%status = result_not_converged
         result%message = error%message
      end if
      if (.not. allocated(result%message)) result%message = ''
      if (is_stopped(stopped) .and. result%status == result_not_converged) then
         call empty(result)     ! half an iteration is no valid result
         ! one thread at a time: see to_text in dg_text
         !$omp critical (interruption_text)
         result%message = 'ended by '//stop_reason(stopped)//' before it was solved'
         !$omp end critical (interruption_text)
      end if
      if (has_numbers(result%status)) then
         call note_push(model, case_index, result)
         if (any(number == [model_mcge, model_mixed]) .and. is_straightened(model, model%cases(case_index))) &
            call note_bend(model, case_index, result)
      end if
      if (model%rig%given .and. has_numbers(result%status)) result%weight_indicator = &
         indicated_load(model%rig, model%cases(case_index)%operation, result%hookload)
      result%case_index = case_index
      result%model = number
   end subroutine solve_case

   !> Add a message on the force by which pressure of a closed annulus pushes pipe out at surface.
   subroutine note_push(model, case_index, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(inout) :: result
      real(wp) :: push
      push = surface_push(model, case_index)
      if (push > 0.0_wp) call add_message(result, 'Annulus pressure pushes the pipe up at surface with '// &
         in_units(model%units, unit_force, push, shown)//'. Hook load counts this. If the BOP or a stripper '// &
         'carries it, add it to the hook load')
   end subroutine note_push

   !> Add a message on a bent housing that is solved straight. It names a case that has the bend, if there is one at this depth.
   subroutine note_bend(model, case_index, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(inout) :: result
      integer, parameter :: with_bend(2) = [operation_sliding_drilling, operation_static]
      integer :: i, bent
      associate (cases => model%cases, this => model%cases(case_index))
         associate (parts => model%strings(string_index(model%strings, this%string))%components)
            bent = findloc(has_bend(parts), .true., dim=1)
            i = findloc([(any(cases(i)%operation == with_bend) .and. cases(i)%string == this%string .and. &
                          .not. abs(cases(i)%bit_depth - this%bit_depth) > 0.0_wp, i=1, size(cases))], .true., dim=1)
            call add_message(result, 'The string turns and is solved with a straight housing: bending moments and stresses at '// &
                             quoted(parts(bent)%name)//' are those without its bend. '// &
                             either('Its bend is in '//quoted(cases(max(i, 1))%name), &
                                    "Add a case operation = 'sliding' at this depth, which has the bend", i > 0))
         end associate
      end associate
   end subroutine note_bend

   !> Make a result without numbers, marked as not converged.
   subroutine empty(result)
      type(case_result_type), intent(out) :: result
      result%status = result_not_converged
   end subroutine empty
end module dg_solve_case
