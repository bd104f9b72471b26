!> Solve one load case by beams, with tool joints smeared along their components or one by one.
!>
!> Smeared joints are exact enough where pipe lies along the hole. Helically buckled pipe also touches the hole between its joints,
!> and bows out farther there. Smeared joints may then leave out most of the friction: of seven such wells, two lock up by it. They
!> leave out a third of the length that buckling takes up. Pipe that bows out between its joints, while the string as a whole does
!> not buckle yet, may take a tenth of the hook load. So joints are solved one by one where pipe bows out, unless the deck asks for
!> one of both ways. If that finds no equilibrium, the joints are smeared, and a message says so.
module dg_solve_by_beams
   use dg_kinds, only: wp
   use dg_bowed_pipe, only: bows_between_joints, note_bowed_pipe
   use dg_case_result, only: case_result_type, has_numbers, result_not_converged
   use dg_case_without_load, only: solve_without_load
   use dg_confirm_lock_up, only: confirm_lock_up
   use dg_drillstring, only: component_tops, joint_ends
   use dg_error, only: error_type
   use dg_limits_by_beams, only: find_limits_by_beams
   use dg_model, only: model_type, string_index
   use dg_static_analysis, only: solve_static_analysis
   use dg_static_result, only: add_message
   use dg_stopping, only: is_stopped, stop_type
   use dg_trajectory, only: top_md
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: solve_by_beams

   !> Most iterations with joints one by one. Of 655 wells that converge none takes more this way, and three would take 500 in vain.
   integer, parameter :: most_apart = 250
   !> Digits of lengths and depths in a message.
   integer, parameter :: shown = 4, shown_depth = 7
   !> A joint within `close_to_step` of a step of the hole may be on either side of it [m]. A bit depth that differs by
   !> `deeper_by` puts it clearly on one side [m].
   real(wp), parameter :: close_to_step = 0.1_wp, deeper_by = 0.5_wp

contains

   !> Solve one load case. Seconds and iterations of both ways are added.
   subroutine solve_by_beams(model, case_index, totals_only, stop, result, error)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: totals_only         !< no profile is wanted, and the load of a lock-up is not confirmed
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(model_type) :: other
      type(case_result_type) :: smeared
      logical :: tried
      other = model
      tried = model%numerics%joints_by_need
      if (tried) tried = bows_between_joints(model, case_index)
      if (tried) then
         other%numerics%discrete_joints = .true.
         other%numerics%max_iterations = min(model%numerics%max_iterations, most_apart)
         call solve_one_way(other, case_index, totals_only, stop, result, error)
         result%joints_apart = .true.
         if (result%status /= result_not_converged .or. is_stopped(stop)) return
      end if
      other%numerics%discrete_joints = model%numerics%discrete_joints
      other%numerics%joints_by_need = .false.
      other%numerics%max_iterations = model%numerics%max_iterations
      call solve_one_way(other, case_index, totals_only, stop, smeared, error)
      smeared%iterations = smeared%iterations + result%iterations
      smeared%seconds = smeared%seconds + result%seconds
      result = smeared
      ! where the soft string sees no pipe that bows out, nothing is left out
      if (tried .or. .not. (totals_only .or. model%numerics%joints_by_need)) &
         call note_bowed_pipe(model, case_index, tried, result)
   end subroutine solve_by_beams

   !> Solve one load case with its joints as the model says.
   subroutine solve_one_way(model, case_index, totals_only, stop, result, error)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: totals_only
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      call solve_static_analysis(model, case_index, result, error, totals_only, stop)
      if (allocated(error) .or. (totals_only .and. result%status /= result_not_converged)) return
      call confirm_lock_up(model, case_index, stop, result)     ! a point of a sweep without equilibrium may lock up
      if (totals_only) return
      call solve_without_load(model, case_index, stop, result)
      call find_limits_by_beams(model, case_index, stop, result)
      call note_joint_at_step(model, case_index, result)
   end subroutine solve_one_way

   !> Add a message on a tool joint that ends close to a change of the hole's diameter. The string is centimetres shorter than
   !> the hole along its axis, so that the side of the joint is uncertain. With 2 cm between, moments can be wrong by 11 %.
   subroutine note_joint_at_step(model, case_index, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(inout) :: result
      real(wp), allocatable :: ends(:), tops(:)
      real(wp) :: bit
      integer :: i, joint
      if (.not. (model%numerics%discrete_joints .and. has_numbers(result%status))) return
      bit = model%cases(case_index)%bit_depth
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)), &
                 steps => model%holes%md_bottom)
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         allocate (ends, source=bit - joint_ends(string, tops))
         if (size(ends) == 0) return
         do i = 1, size(steps) - 1
            joint = minloc(abs(ends - steps(i)), dim=1)
            if (abs(ends(joint) - steps(i)) > close_to_step) cycle
            call add_message(result, 'A tool joint ends at '//in_units(model%units, unit_length, ends(joint), shown_depth)// &
               ', where the hole changes its diameter. Moments there depend on which side the joint lies. Compare with a '// &
               'bit_depth '//in_units(model%units, unit_length, deeper_by, shown)//' deeper')
            return
         end do
      end associate
   end subroutine note_joint_at_step
end module dg_solve_by_beams
