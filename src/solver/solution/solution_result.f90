!> Result of a solution: totals, profile and moments. Where the contact of the beam for the moments differs, the case is solved
!> once more, with gaps that have that contact.
module dg_solution_result
   use dg_kinds, only: wp
   use dg_bending_profile, only: bend_profile
   use dg_case_result, only: case_result_type, result_converged
   use dg_equations, only: end_iterations, make_room
   use dg_equilibrium, only: equilibrium_type, find_equilibrium, new_equilibrium
   use dg_fitted_gaps, only: fitted_gaps_type
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_numerics, only: numerics_type
   use dg_outcome, only: outcome_converged
   use dg_outside_hole, only: measure_rows, outside_type
   use dg_recovery, only: part_profile, recover_profile
   use dg_solution, only: solution_type
   use dg_static_result, only: add_message, add_outside, add_remarks, fill_result, warn_of_contact, warn_of_points, warn_of_slope
   use dg_unit_kind, only: in_units, unit_length
   use dg_workspace, only: keep_for_moments, new_workspace, workspace_type
   implicit none
   private
   public :: make_result, solve_fitted, begin_again, coiled, wanted_type

   !> Parts of a result that take time.
   type :: wanted_type
      logical :: moments = .true.    !< on elements short enough for them; needs the profile
      logical :: profile = .true.
      logical :: limits = .false.    !< friction and weight on bit at which string weight is just enough
   end type wanted_type

   !> Compression over the helical load above which a string counts as helically buckled [-].
   real(wp), parameter :: coiled = 1.0_wp
   !> A fit is kept if it leaves at most this part of the difference in contact [-]. Then the most fits, and the most
   !> iterations for one. A fit takes 2 to 10 iterations.
   real(wp), parameter :: better = 0.9_wp
   integer, parameter :: most_fits = 3, most_to_fit = 50
   !> Digits of a length in a message.
   integer, parameter :: shown = 2

contains

   !> Make the result of a solution, with its profile and moments if they are wanted.
   subroutine make_result(model, case_index, numerics, outcome, wanted, solution, fitted, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(numerics_type), intent(in) :: numerics  !< of the last attempt
      integer, intent(in) :: outcome
      type(wanted_type), intent(in) :: wanted
      type(solution_type), intent(inout) :: solution
      type(fitted_gaps_type), intent(out) :: fitted
      type(case_result_type), intent(out) :: result
      associate (mesh => solution%mesh, work => solution%work, gaps => solution%gaps)
         call end_iterations(solution%equations, model%trajectory, mesh, solution%loads, gaps, solution%state, work)
         call fill_result(model, case_index, solution, outcome, result)
         result%coiled = solution%compressed > coiled
         result%shortened = solution%shortened
         result%element_lengths = [minval(mesh%length), maxval(mesh%length)]
         call add_remarks(model%units, mesh, model%numerics, numerics, result)
         if (.not. (wanted%profile .and. result%status == result_converged)) return
         call recover_profile(model%trajectory, mesh, gaps, work, result%profile)
         if (.not. wanted%moments) then
            call part_profile(model, case_index, mesh, gaps, work, result%profile)
            return
         end if
         call keep_for_moments(work)
         call find_moments(model, solution, fitted, result)
      end associate
   end subroutine make_result

   !> Solve again with fitted gaps where the contact of a part of the string differs from the beam for the moments. Repeat as
   !> long as that brings both nearer to each other.
   subroutine solve_fitted(model, case_index, numerics, growth, fitted, solution, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(numerics_type), intent(in) :: numerics  !< of the attempt that led here, with the most iterations of all
      real(wp), intent(in) :: growth               !< of that attempt [-]
      type(fitted_gaps_type), intent(inout) :: fitted
      type(solution_type), intent(inout) :: solution
      type(case_result_type), intent(inout) :: result
      type(solution_type) :: again
      type(equilibrium_type) :: it
      type(fitted_gaps_type) :: next
      type(case_result_type) :: found
      integer :: round
      do round = 1, most_fits
         if (.not. allocated(fitted%normal)) return
         again = solution
         again%gaps = fitted%gaps
         call begin_again(numerics, fitted%normal, again)
         call new_equilibrium(again, numerics, it)
         it%wall%growth = growth
         it%numerics%max_iterations = min(numerics%max_iterations, again%equations%iterations + most_to_fit)
         it%row = again%equations%history(again%equations%iterations + 1)
         it%row%stage = it%row%stage + 1
         call find_equilibrium(it, model%trajectory, again)
         result%iterations = again%equations%iterations
         result%history = again%equations%history(:result%iterations + 1)
         if (it%outcome /= outcome_converged) return
         again%gaps%followed = solution%gaps%followed
         call make_result(model, case_index, numerics, it%outcome, wanted_type(), again, next, found)
         if (is_missing(found%moment_error) .or. found%unlike_contact%share > better*result%unlike_contact%share) return
         result = found
         solution = again
         fitted = next
      end do
   end subroutine solve_fitted

   !> Prepare a solution to be iterated again from its state, with given contact forces.
   subroutine begin_again(numerics, normal, solution)
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: normal(:)            !< (e) [N]
      type(solution_type), intent(inout) :: solution
      type(workspace_type) :: work
      call new_workspace(solution%mesh, work)
      work%sideways = solution%work%sideways
      work%normal = normal
      solution%work = work
      call make_room(solution%equations, numerics%linear_solver, solution%mesh%nodes)
   end subroutine begin_again

   !> Find moments along the string on elements short enough for them. A message says so if no equilibrium is found on such
   !> elements.
   subroutine find_moments(model, solution, fitted, result)
      type(model_type), intent(in) :: model
      type(solution_type), intent(in) :: solution
      type(fitted_gaps_type), intent(out) :: fitted
      type(case_result_type), intent(inout) :: result
      type(outside_type) :: outside
      real(wp) :: steep(2)
      call bend_profile(model, solution%mesh, solution%gaps, solution%work, result, steep, fitted)
      call measure_rows(solution%mesh, result%profile, outside)
      if (outside%elements > 0) call add_outside(model%units, outside, result)
      if (is_missing(result%moment_error)) then
         call add_message(result, 'Bending moments and stresses are not valid. They are those of elements of up to '// &
                          in_units(model%units, unit_length, maxval(solution%mesh%length), shown)// &
                          ', as short elements found no equilibrium near this one. How far they are off is not known')
      end if
      if (is_missing(result%moment_error)) return
      if (steep(2) > steep(1)) call warn_of_slope(model%units, steep, maxval(solution%mesh%length), result)
      call warn_of_contact(model%units, result)
      call warn_of_points(model%units, result)
   end subroutine find_moments
end module dg_solution_result
