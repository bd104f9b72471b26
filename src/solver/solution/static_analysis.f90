!> The model of the paper for one load case: from deck data to a result.
!>
!> Steps:
!> 1. Make a mesh by the local scale (dg_mesh_for_case). Its loads are those of the soft string with the friction of a stiff
!> assembly (dg_stiff_drag). If that soft string locks up, the case is locked up.
!> 2. Start from the soft string bent into the hole (dg_predictor). Its walls are softened so that the expected load presses
!> visibly into them.
!> 3. Iterate (dg_equilibrium) with the places of the nodes and the contact forces as unknowns. The merit of a step is the
!> energy with frozen friction forces, or the largest residual.
!> 4. Accept an equilibrium only if it is stable, and within the hole.
!> 5. Compare its contact with a beam on shorter elements (dg_bending_profile). Where they differ, fit the gaps and solve again
!> (dg_solution_result).
!> 6. If no equilibrium is found, make the attempts of dg_tuning, on the first mesh and on meshes with shorter elements.
!> 7. Solve a helically buckled string again from other starts (find_range): it can stop at several hook loads.
module dg_static_analysis
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_bent_start, only: pressing_of_bend
   use dg_case_result, only: case_result_type, iteration_type, result_converged, result_not_converged
   use dg_clock, only: seconds_between
   use dg_end_supports, only: force_scale, set_loads
   use dg_equations, only: make_room, release_room
   use dg_equilibrium, only: equilibrium_type, find_equilibrium, new_equilibrium
   use dg_error, only: error_type
   use dg_finite_result, only: finish_result
   use dg_fitted_gaps, only: fitted_gaps_type
   use dg_lock_up_result, only: result_of_lock_up
   use dg_mesh, only: new_mesh
   use dg_mesh_for_case, only: cut_elements, mesh_for_case, near_edges, shortest, shortest_cut
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_numerics, only: numerics_type, patience, settings_of_attempt
   use dg_no_equilibrium, only: list_tried, add_tried
   use dg_outcome, only: outcome_converged, outcome_outside, outcome_stopped
   use dg_predictor, only: predict, start_type
   use dg_profile, only: profile_type
   use dg_profile_rows, only: part_rows
   use dg_refinement, only: transfer_solution
   use dg_solution, only: solution_type
   use dg_solution_result, only: coiled, make_result, solve_fitted, wanted_type
   use dg_soft_string_loads, only: soft_totals_type
   use dg_stability, only: find_stability_margin
   use dg_static_result, only: add_message, look_outside, warn_of_range
   use dg_stiff_drag, only: find_stiff_drag
   use dg_stopping, only: is_stopped, stop_type
   use dg_text, only: to_text
   use dg_tuning, only: attempt_type, mesh_try_type
   use dg_unit_kind, only: in_units, unit_length
   use dg_walls, only: lay_out_gaps, softness
   use dg_weight_limits, only: find_weight_limits
   use dg_whirling, only: find_sideways
   use dg_workspace, only: new_start_room, new_workspace
   implicit none
   private
   public :: solve_static_analysis

   !> Least compression over the helical load at which the margin of stability is computed [-].
   real(wp), parameter :: buckling_share = 0.4_wp
   !> Largest distance of a node outside the hole, over the clearance [-]. Rock yields and elements sag by a tenth or two.
   real(wp), parameter :: largest_excess = 0.5_wp
   !> Axial strain of the soft string, and its contact force over its weight, above which the case is locked up [-]. The
   !> strongest pipe of steel yields at 0.55 %, of aluminium or titanium at 0.75 %. Contact forces that friction makes grow by
   !> factors from bend to bend.
   real(wp), parameter :: most_strain = 0.01_wp, held_by = 10.0_wp
   !> Most iterations times elements on one mesh [-]: about a minute, at 3 to 7 microseconds each. Wells that converge take
   !> less than a tenth of it. A case of half a million elements still has twenty iterations.
   real(wp), parameter :: most_work = 1.0e7_wp
   !> The result has a warning if the error of the moments is above this part of the largest moment [-].
   real(wp), parameter :: doubtful = 0.05_wp
   !> Difference of hook loads, relative, up to which two equilibria are the same [-].
   real(wp), parameter :: same = 1.0e-9_wp
   !> Digits of a length in a message.
   integer, parameter :: shown = 2

contains

   !> Solve one load case by beams with contact gap elements. A case that does not converge, or is locked up, is a result with
   !> its reason. An `error` prevents any result. If the first mesh finds no equilibrium, those of tuning%mesh follow.
   subroutine solve_static_analysis(model, case_index, result, error, totals_only, stop)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      logical, intent(in), optional :: totals_only   !< true: no profile, and moments only where totals need them
      type(stop_type), intent(in), optional :: stop  !< absent: the work is done to its end
      type(iteration_type), allocatable :: history(:)
      type(stop_type) :: stopped
      type(model_type) :: known                   ! with the friction of a stiff assembly, and joints as on its elements
      integer(int64) :: start, finish
      character(:), allocatable :: tried
      integer :: given_up, i
      type(mesh_try_type) :: mesh
      type(wanted_type) :: wanted
      real(wp) :: asked, by_elements
      call system_clock(start)
      if (present(stop)) stopped = stop
      if (present(totals_only)) wanted%profile = .not. totals_only
      wanted%moments = model%numerics%moments .and. wanted%profile
      wanted%limits = wanted%profile
      allocate (history(0))
      known = model
      known%numerics%joints_by_need = .false.
      call find_stiff_drag(known, case_index, known%stiff_drag, known%stiff_share)
      asked = model%numerics%element_length
      do i = 1, model%numerics%tuning%most_meshes
         mesh = model%numerics%tuning%mesh(i)
         mesh%length = mesh%length*asked
         if (i > 1 .and. .not. mesh%length > shortest) cycle
         call solve_on_mesh(known, case_index, mesh, wanted, history, stopped, result)
         if (i == 1) asked = min(asked, result%element_lengths(2))
         if (result%status /= result_not_converged) exit
         call list_tried(model, result%element_lengths(2), result%attempts, tried)
         given_up = result%iterations
         if (given_up >= model%numerics%max_iterations .or. work_is_done(model%numerics, result) .or. is_stopped(stopped)) exit
         history = result%history(:given_up)       ! the next attempt's first row takes the place of the last one
      end do
      if (result%status == result_not_converged) then
         call add_tried(model, case_index, tried, work_is_done(model%numerics, result), result)
      else if (result%status == result_converged .and. size(history) > 0) then
         call add_message(result, 'Converged with elements of at most '// &
                          in_units(model%units, unit_length, mesh%length, shown)//'. Others found no equilibrium in '// &
                          to_text(size(history))//' iterations')
      end if
      by_elements = result%moment_error
      if (result%status == result_converged .and. result%coiled .and. wanted%moments .and. model%numerics%friction_range) &
         call find_range(known, case_index, stopped, result)
      if (result%status == result_converged .and. wanted%moments .and. .not. is_missing(result%moment_error)) &
         call warn_of_moments(model%numerics, by_elements, result)
      if (allocated(result%profile%md)) call part_rows(model, case_index, result%profile)
      call finish_result(result)
      call system_clock(finish)
      result%seconds = seconds_between(start, finish)
   end subroutine solve_static_analysis

   !> Warn of an error of the moments above `doubtful`, and advise shorter elements if their length is the reason.
   pure subroutine warn_of_moments(numerics, by_elements, result)
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: by_elements     !< error of moments from the length of elements, over the largest [-]
      type(case_result_type), intent(inout) :: result
      if (.not. result%moment_error > doubtful) return
      call add_message(result, 'Bending moments may be off by '//to_text(100.0_wp*result%moment_error, shown)//' % of the largest')
      if (by_elements > doubtful .and. .not. numerics%halve_moments) &
         call add_message(result, "Set fidelity = 'reference' to halve elements")
   end subroutine warn_of_moments

   !> Solve a helically buckled string once more, from other starts. Friction along the hole holds the coils where they formed,
   !> so that there are several equilibria. The result keeps the equilibrium of the predicted helix. A message gives the range,
   !> and the error of the moments covers it. The first other start is on the low side of the hole. If that finds no other
   !> equilibrium, the second has coils that turn the other way.
   subroutine find_range(model, case_index, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(inout) :: result
      type(model_type) :: neighbour
      type(case_result_type) :: other, found
      logical :: mirrored
      integer :: i
      neighbour = model
      neighbour%numerics%max_iterations = min(model%numerics%max_iterations, model%numerics%tuning%attempt(1)%longest)
      mirrored = .false.
      do i = 1, 2
         neighbour%numerics%tuning%start_buckled = i == 2
         neighbour%numerics%tuning%start_mirrored = i == 2
         call solve_on_mesh(neighbour, case_index, mesh_try_type(result%element_lengths(2), 1, 1), wanted_type(), &
                            [iteration_type ::], stop, other)
         if (is_stopped(stop)) exit
         if (other%status /= result_converged) cycle
         found = other
         mirrored = i == 2
         if (abs(found%hookload - result%hookload) > same*abs(result%hookload)) exit
      end do
      call warn_of_range(model%units, found, mirrored, result)
   end subroutine find_range

   !> True if a mesh has used its allowed work, except for its last iteration.
   pure function work_is_done(numerics, result) result(done)
      type(numerics_type), intent(in) :: numerics
      type(case_result_type), intent(in) :: result
      logical :: done
      done = real(result%iterations + 1, wp)*result%elements > patience(numerics)*most_work
   end function work_is_done

   !> Solve the case on one mesh. Iterations are counted on from those in `history`.
   subroutine solve_on_mesh(model, case_index, mesh_try, wanted, history, stop, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_try_type), intent(in) :: mesh_try  !< longest element [m], and the attempts
      type(wanted_type), intent(in) :: wanted
      type(iteration_type), intent(in) :: history(:)
      type(stop_type), intent(in) :: stop
      type(case_result_type), intent(out) :: result
      type(solution_type) :: solution
      type(numerics_type) :: numerics
      type(soft_totals_type) :: totals
      type(fitted_gaps_type) :: fitted
      type(wanted_type) :: needed
      real(wp) :: margin, strained
      integer :: most                     ! iterations of all attempts
      integer :: tried                    ! attempts made before
      integer :: i, last, outcome
      associate (equations => solution%equations, mesh => solution%mesh)
         call mesh_for_case(model, case_index, mesh_try%length, mesh, totals, solution%compressed, strained, &
                            solution%pressing, solution%shortened)
         if (totals%runaway .or. (strained > most_strain .and. totals%normal_force > held_by*totals%weight)) then
            call result_of_lock_up(model, case_index, totals, strained, result)
            return
         end if
         ! totals of a stiff assembly are only right with the contact of short elements
         needed = wanted
         if (model%numerics%moments .and. any(near_edges(mesh))) needed = wanted_type()
         most = min(model%numerics%max_iterations, size(history) + int(patience(model%numerics)*most_work/mesh%elements))
         call prepare(model, case_index, solution)
         solution%stop = stop
         equations%iterations = size(history)
         equations%history(:size(history)) = history
         tried = maxval([0, history%attempt])
         last = mesh_try%first - 1
         do i = mesh_try%first, min(mesh_try%last, model%numerics%tuning%most_attempts)
            last = i
            numerics = settings_of_attempt(model%numerics, i, solution%compressed > coiled)
            numerics%max_iterations = min(most, equations%iterations + numerics%max_iterations)
            call make_attempt(model, case_index, numerics, numerics%tuning%attempt(i), tried + 1 + i - mesh_try%first, &
                              solution, outcome)
            if (outcome == outcome_converged .or. equations%iterations >= most) exit
         end do
         if (is_stopped(stop)) outcome = outcome_stopped       ! an attempt that was interrupted does not count
         margin = missing
         if (outcome == outcome_converged .and. solution%compressed > buckling_share) &
            call find_stability_margin(model%trajectory, solution, margin)
         call make_result(model, case_index, numerics, outcome, needed, solution, fitted, result)
         numerics%max_iterations = most
         if (outcome == outcome_converged) &
            call solve_fitted(model, case_index, numerics, numerics%tuning%attempt(last)%growth, fitted, solution, result)
         if (wanted%limits .and. outcome == outcome_converged) &
            call find_weight_limits(model, case_index, numerics, solution, result)
         if (.not. wanted%profile) result%profile = profile_type()
         result%stability_margin = margin
         result%attempts = last - mesh_try%first + 1
      end associate
   end subroutine solve_on_mesh

   !> Make one attempt: from the start, increment by increment, until it converges or fails. If the string then is outside its
   !> hole between its contact points, cut the mesh finer and go on iterating.
   subroutine make_attempt(model, case_index, numerics, attempt, number, solution, outcome)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(numerics_type), intent(in) :: numerics
      type(attempt_type), intent(in) :: attempt
      integer, intent(in) :: number        !< of the attempt
      type(solution_type), intent(inout) :: solution
      integer, intent(out) :: outcome
      type(equilibrium_type) :: it
      type(start_type) :: start
      real(wp) :: fraction, worst
      integer :: increment, place, cut
      call lay_out_gaps(numerics, solution%mesh, solution%gaps)
      call release_room(solution%equations)       ! of the attempt before
      do increment = 1, numerics%load_steps
         fraction = real(increment, wp)/numerics%load_steps
         call set_loads(model, model%cases(case_index), fraction, solution%loads)
         start = start_type(fraction, softness(numerics%tuning%soft_penetration, solution%mesh, solution%pressing), attempt%spread)
         if (increment == 1) then
            call predict(model, case_index, solution%mesh, start, solution%work%sideways, solution%state, solution%gaps, &
                         solution%work%normal)
            solution%pressing = max(solution%pressing, pressing_of_bend(solution%mesh, solution%work%normal))
            if (.not. allocated(solution%work%shift)) call new_workspace(solution%mesh, solution%work)
            call make_room(solution%equations, numerics%linear_solver, solution%mesh%nodes)
         end if
         do cut = 0, numerics%tuning%most_cuts
            call new_equilibrium(solution, numerics, it)
            it%wall%growth = attempt%growth
            it%row%increment = increment
            it%row%attempt = number
            it%row%stage = 1 + cut
            if (increment == numerics%load_steps .and. cut < numerics%tuning%most_cuts) it%cut_from = 2.0_wp*shortest_cut
            call find_equilibrium(it, model%trajectory, solution)
            outcome = it%outcome
            if (outcome /= outcome_outside) exit
            call refine(model, case_index, numerics, it%outside, solution)
         end do
         if (outcome /= outcome_converged) return
      end do
      call look_outside(model, solution%mesh, solution%work, worst, place)
      if (worst > largest_excess) outcome = outcome_outside
   end subroutine make_attempt

   !> Cut the marked elements, and put the string on the finer mesh in its present position.
   subroutine refine(model, case_index, numerics, marked, solution)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(numerics_type), intent(in) :: numerics
      logical, intent(in) :: marked(:)
      type(solution_type), intent(inout) :: solution
      type(solution_type) :: finer
      call new_mesh(model, model%cases(case_index), cut_elements(model, solution%mesh, marked), finer%mesh)
      call new_workspace(finer%mesh, finer%work)
      call find_sideways(model, case_index, finer%mesh, solution%compressed, finer%work%sideways)
      call lay_out_gaps(numerics, finer%mesh, finer%gaps)
      allocate (finer%state(6, finer%mesh%nodes))
      call transfer_solution(model%trajectory, solution, finer)
      solution%mesh = finer%mesh
      solution%gaps = finer%gaps
      solution%work = finer%work
      call move_alloc(finer%state, solution%state)
      call make_room(solution%equations, numerics%linear_solver, solution%mesh%nodes)
   end subroutine refine

   !> Allocate the arrays of the start, and set the scales of the iteration.
   subroutine prepare(model, case_index, solution)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(solution_type), intent(inout) :: solution
      associate (numerics => model%numerics, equations => solution%equations, mesh => solution%mesh, &
                 load_case => model%cases(case_index))
         call new_start_room(mesh, solution%work)
         call find_sideways(model, case_index, mesh, solution%compressed, solution%work%sideways)
         allocate (solution%state(6, mesh%nodes))
         allocate (equations%history(numerics%max_iterations + 1))
         equations%force_scale = force_scale(model, load_case, mesh)
      end associate
   end subroutine prepare
end module dg_static_analysis
