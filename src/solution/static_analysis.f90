!> The model of the paper for one load case: from deck data to a result. The only door of this room.
module dg_static_analysis
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_assembly, only: load_type
   use dg_bending_beam, only: contact_places
   use dg_bending_profile, only: bend_profile
   use dg_case_result, only: case_result_type, iteration_type, result_converged, result_not_converged, scale_count, way_left, &
                             way_planar
   use dg_damped_newton, only: iterate_damped
   use dg_error, only: error_type
   use dg_force_iteration, only: force_iteration_type, iterate_forces, new_force_iteration
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   use dg_interruption, only: is_interrupted
   use dg_load_case, only: load_case_type, rotates
   use dg_mesh, only: mesh_type
   use dg_mesh_for_case, only: mesh_for_case, shortest
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_newton, only: end_iterations, iterate, make_room, newton_converged, newton_exhausted, newton_type
   use dg_numerics, only: gap_at_nodes, numerics_type, other_location, settings_of
   use dg_outside_hole, only: measure_rows, outside_type
   use dg_plane, only: choose_way, flatten
   use dg_predictor, only: predict
   use dg_pressed_start, only: press_start
   use dg_refinement, only: take_over
   use dg_release_front, only: new_release_front
   use dg_soft_string_loads, only: soft_totals_type
   use dg_stability, only: find_stability_margin, is_stable, push_off
   use dg_static_result, only: add_message, add_outside, fill_result, look_outside, outcome_outside, result_of_lock_up, touched
   use dg_text, only: to_text
   use dg_turning_step, only: is_straight_down
   use dg_viscosity, only: damped_type, new_damped
   use dg_whirling, only: find_climb
   use dg_wall_stages, only: lay_out_gaps, set_walls, stage_walls, tolerance_at
   use dg_workspace, only: new_workspace, nothing_carried, workspace_type
   implicit none
   private
   public :: solve_static_analysis

   !> Support springs at centred ends over the wall's greatest stiffness per metre [m]: stiff enough to hold the
   !> string within micrometres of the axis, not so stiff as to spoil the matrix.
   real(wp), parameter :: support_length = 1.0_wp
   !> Of a string without weight and load, which has no scale of its own [N].
   real(wp), parameter :: least_scale = 1.0_wp
   !> Residual over weight at which a stage before the last is left [-].
   real(wp), parameter :: stage_tolerance = 1.0e-3_wp
   !> The same in damped Newton: a string settles among its next to unresisted modes much sooner against a soft wall [-].
   real(wp), parameter :: settled_tolerance = 1.0e-6_wp
   !> Ways to iterate, each with its longest run, and the attempts at a case, at most three: plain Newton, which finds an ordinary
   !> string's equilibrium in a few iterations from the soft string's line, and most of the others' from that line bent into the
   !> hole; or damped Newton where the string will buckle over more than a few waves; then the iteration with contact forces as
   !> unknowns, slower and surer. A compressed string, which may be at rest where it cannot stay, is left by plain Newton sooner,
   !> and may have damped Newton last. The bent line is not for the first attempt of a string that lies: with it gaps find fewer
   !> reasons to move to the extremum of their element, and the torque of a short-radius lateral is 1.4 % off instead of 0.2 %.
   integer, parameter :: nothing = 0, by_newton = 1, briefly = 2, by_damping = 3, other_place_damped = 4, damped_briefly = 5, &
                         by_forces = 6, from_bent = 7
   integer, parameter :: longest_attempt(7) = [70, 25, 150, 250, 120, 250, 70]
   !> A lateral step over the clearance by which plain Newton shows that a compressed string's tangent is next to singular [-]:
   !> those that it solves take steps of less than one.
   real(wp), parameter :: wild = 3.0_wp
   !> Parts of the coiling load [-]: from the first on equilibria are checked for stability, from the second on the plan is that
   !> of a string that may buckle. Sinusoidal buckling comes at 1/sqrt(2) of it, Lubinski's first mode of a vertical string
   !> at 1/2, at 1/4 when it is very long.
   real(wp), parameter :: watch_share = 0.25_wp, buckling_share = 0.4_wp
   real(wp), parameter :: most_waves = 0.1_wp
   !> Part of the clearance by which an unstable equilibrium is pushed off [-].
   real(wp), parameter :: push = 0.1_wp
   !> How far outside the hole a node may lie, over the clearance [-]: rock yields and elements sag by a tenth or two.
   real(wp), parameter :: largest_excess = 0.5_wp
   !> A mesh with so many times the elements of the coarsest is solved on that first; the iterations that may take, and its
   !> tolerance [-].
   real(wp), parameter :: much_finer = 2.5_wp
   integer, parameter :: coarse_iterations = 60
   real(wp), parameter :: coarse_tolerance = 1.0e-6_wp
   !> Where that many iterations, or half of those allowed, found no rest, elements so much shorter have the others. A string that
   !> is pushed near lock-up leaves the soft string that its mesh was made for behind; a quarter cures most of those, a half few.
   integer, parameter :: enough = 400
   real(wp), parameter :: finer = 0.25_wp
   !> Most iterations times elements on one mesh [-]: about a minute, at 3 to 7 microseconds each. Random wells that converge take
   !> no more than a tenth of it, most a hundredth; a case of half a million elements still has twenty iterations.
   real(wp), parameter :: most_work = 1.0e7_wp
   !> The result says how far moments may be off when that is more than this part of the largest moment [-].
   real(wp), parameter :: doubtful = 0.05_wp
   !> Digits of a length in a message.
   integer, parameter :: shown = 2

contains

   !> Solves one load case by beams with contact gap elements. A case that does not converge, or is locked up, is a result
   !> with its reason, no error; `error` stands for what prevents any result. Where the mesh asked for finds no rest a finer one
   !> has what is left of the iterations.
   subroutine solve_static_analysis(model, case_index, result, error, totals_only)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      logical, intent(in), optional :: totals_only   !< .true.: no moments on shorter elements, which cost time
      type(iteration_type), allocatable :: history(:)
      integer(int64) :: ticks, start, rate
      integer :: most, first, given_up
      logical :: moments
      real(wp) :: length
      call system_clock(start, rate)
      most = model%numerics%max_iterations
      moments = model%numerics%moments
      if (present(totals_only)) moments = moments .and. .not. totals_only
      allocate (history(0))
      first = most
      if (finer*model%numerics%element_length > shortest) first = min(most, max(enough, most/2))
      call solve_on_mesh(model, case_index, model%numerics%element_length, first, moments, history, result)
      length = finer*min(model%numerics%element_length, result%element_lengths(2))
      if (result%status == result_not_converged .and. result%iterations < most .and. length > shortest .and. &
          .not. work_is_done(result) .and. .not. is_interrupted()) then
         history = result%history
         given_up = result%iterations
         call solve_on_mesh(model, case_index, length, most, moments, history, result)
         if (result%status == result_converged) call add_message(result, 'converged with elements of at most '// &
            to_text(length, shown)//' m: longer ones found no rest in '//to_text(given_up)//' iterations')
      end if
      call system_clock(ticks)
      result%seconds = real(ticks - start, wp)/real(rate, wp)
   end subroutine solve_static_analysis

   !> Whether a mesh has had the work that it may have, but for its last iteration.
   pure function work_is_done(result) result(done)
      type(case_result_type), intent(in) :: result
      logical :: done
      done = real(result%iterations + 1, wp)*result%elements > most_work
   end function work_is_done

   !> Solves the case with elements no longer than asked for, going on after the iterations in `history`.
   subroutine solve_on_mesh(model, case_index, element_length, allowed, moments, history, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: element_length       !< [m]
      integer, intent(in) :: allowed               !< iterations, those in `history` included
      logical, intent(in) :: moments               !< whether moments are found on elements short enough for them
      type(iteration_type), intent(in) :: history(:)
      type(case_result_type), intent(out) :: result
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(newton_type) :: newton
      type(damped_type) :: damped
      type(workspace_type) :: work
      type(load_type) :: loads
      type(numerics_type) :: numerics
      real(wp), allocatable :: state(:, :)
      type(soft_totals_type) :: totals
      real(wp) :: worst, pressing, compressed, waves, viscous_step, margin
      logical :: may_buckle, started, damping, stable, straight_down, stays
      logical :: known             ! the energy's tangent at the rest that has been found
      integer, allocatable :: gap_states(:)
      integer :: shortened(scale_count)
      integer :: plan(3)
      integer :: attempt, outcome, place, way, in_plane
      integer :: most              ! iterations
      integer :: tried             ! attempts on a mesh before
      call mesh_for_case(model, case_index, element_length, mesh, totals, compressed, waves, pressing, shortened)
      if (totals%runaway) then
         call result_of_lock_up(model, case_index, result)
         return
      end if
      most = min(allowed, size(history) + int(most_work/mesh%elements))
      may_buckle = compressed > buckling_share
      allocate (state(6, mesh%nodes))
      allocate (gap_states(mesh%elements), source=state_free)
      started = .false.
      if (size(history) == 0) call start_from_coarse(model, case_index, mesh, waves > most_waves, state, gap_states, started)
      call prepare(model, model%cases(case_index), mesh, compressed, newton, work, way)
      newton%iterations = size(history)
      newton%history(:size(history)) = history
      if (may_buckle) call find_climb(model, case_index, mesh, work%climb)
      viscous_step = model%numerics%viscous_limit*maxval(mesh%clearance)
      margin = missing
      straight_down = is_straight_down(mesh)
      plan = plan_of(may_buckle, waves > most_waves, rotates(model%cases(case_index)%operation), straight_down)
      numerics = model%numerics
      if (newton%planar) then
         call try_in_plane(model, case_index, most, pressing, started, gap_states, mesh, numerics, newton, gaps, state, work, &
                           loads, stays)
         outcome = newton_converged
         if (.not. stays) then     ! whatever the reason, space decides, as if nothing had been tried before
            way = way_left
            in_plane = newton%iterations - size(history)
            newton%iterations = size(history)
            if (started) call start_from_coarse(model, case_index, mesh, .false., state, gap_states, started)
            call make_room(newton, numerics%linear_solver, mesh%nodes, planar=.false.)
         end if
      end if
      tried = maxval([0, newton%history(:newton%iterations)%attempt])
      do attempt = 1, merge(0, count(plan /= nothing), newton%planar)
         known = .false.
         numerics = model%numerics
         numerics%max_iterations = min(most, newton%iterations + longest_attempt(plan(attempt)))
         if (attempt == count(plan /= nothing)) numerics%max_iterations = most
         newton%wild_step = merge(wild*maxval(mesh%clearance), huge(wild), plan(attempt) == briefly)
         damping = is_damped(plan(attempt))
         if ((damping .or. plan(attempt) == by_forces) .and. .not. allocated(damped%lump)) &
            call new_damped(mesh, viscous_step, damped)
         if (plan(attempt) == other_place_damped) numerics%gap_location = other_location(numerics%gap_location)
         call go_through_increments(model, case_index, numerics, pressing, started .and. attempt == 1, gap_states, &
                                    plan(attempt), mesh, &
                                    newton, damped, gaps, state, work, loads, outcome)
         call enter_attempt(tried + attempt, newton)
         if (outcome == newton_converged .and. compressed > watch_share .and. .not. damping .and. &
             plan(attempt) /= by_forces) then
            call is_stable(newton, model%trajectory, mesh, loads, gaps, state, work, stable)
            known = stable
            if (.not. stable) then
               if (.not. allocated(damped%lump)) call new_damped(mesh, viscous_step, damped)
               call push_off(newton, damped, model%trajectory, mesh, push, state, work, outcome)
               if (outcome /= newton_converged) exit
               gap_states = gaps%state
               numerics%max_iterations = min(most, newton%iterations + longest_attempt(damped_briefly))
               call go_through_increments(model, case_index, numerics, pressing, .true., gap_states, damped_briefly, mesh, newton, &
                                          damped, gaps, state, work, loads, outcome)
               call enter_attempt(tried + attempt, newton)
            end if
         end if
         if (outcome == newton_converged) then
            call look_outside(model, mesh, work, worst, place)
            if (worst > largest_excess) outcome = outcome_outside
         end if
         if (outcome == newton_converged .or. newton%iterations >= most) exit
      end do
      if (is_interrupted()) outcome = newton_exhausted     ! what an attempt that was cut short led to does not count
      if (outcome == newton_converged .and. may_buckle) &
         call find_stability_margin(newton, model%trajectory, mesh, loads, gaps, state, work, known, margin)
      if (.not. newton%planar) call end_iterations(newton, model%trajectory, mesh, loads, gaps, state, work)
      call fill_result(model, case_index, mesh, gaps, newton, damped%drive, loads, outcome, work, result)
      if (result%status == result_not_converged .and. most < allowed .and. newton%iterations >= most) &
         result%message = to_text(newton%iterations)//' iterations with '//to_text(mesh%elements)//' elements are the most '// &
         'work that is done for a case, and found no rest; give a larger element_length'
      result%stability_margin = margin
      if (outcome == newton_converged .and. moments) call find_moments(model, mesh, gaps, work, result)
      result%way = way
      if (way == way_left) call add_message(result, 'solved in space: '//to_text(in_plane)//' iterations in the plane of the '// &
         'hole, which are not counted, found no rest that lasts')
      result%shortened = shortened
      result%element_lengths = [minval(mesh%length), maxval(mesh%length)]
      if (result%status == result_converged .and. numerics%gap_location /= model%numerics%gap_location) &
         call add_message(result, 'converged with gaps '//trim(merge('at the nodes         ', 'at their extremum x0 ', &
                          numerics%gap_location == gap_at_nodes))//', as with those at the place asked for it found no rest: '// &
                          'hook load, torque and contact force may be off by a percent, '//touched)
   end subroutine solve_on_mesh

   !> Moments along the string on elements short enough for them. A message says where they may be off by more than `doubtful`, and
   !> where no equilibrium was found on such elements.
   subroutine find_moments(model, mesh, gaps, work, result)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(case_result_type), intent(inout) :: result
      type(outside_type) :: outside
      call bend_profile(model, mesh, gaps, work, result)
      call measure_rows(mesh, result%profile, outside)
      if (outside%elements > 0) call add_outside(outside, result)
      if (is_missing(result%moment_error)) then
         call add_message(result, 'moments and stresses along the string may be off by tens of per cent: no equilibrium near '// &
                          'this one was found on short elements, so they are those of elements of up to '// &
                          to_text(maxval(mesh%length), shown)//' m; a smaller element_length makes them better')
      else if (result%moment_error > doubtful) then
         call add_message(result, 'moments along the string may be off by '// &
                          to_text(100.0_wp*result%moment_error, shown)//' % of the largest one'// &
                          trim(merge('                                          ', &
                                     '; fidelity = ''reference'' makes them better', model%numerics%halve_moments)))
      end if
   end subroutine find_moments

   !> Solves the case in the plane of its hole by Newton, from the soft string's line or from that line bent. The string
   !> stays there when it finds rest within the hole, and when that is rest in space too: with every force out of the plane within
   !> the tolerance.
   subroutine try_in_plane(model, case_index, most, pressing, started, gap_states, mesh, numerics, newton, gaps, state, work, &
                           loads, stays)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, most
      real(wp), intent(in) :: pressing
      logical, intent(in) :: started
      integer, intent(in) :: gap_states(:)
      type(mesh_type), intent(in) :: mesh
      type(numerics_type), intent(out) :: numerics   !< that led to rest
      type(newton_type), intent(inout) :: newton
      type(gap_table_type), intent(out) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      type(load_type), intent(out) :: loads
      logical, intent(out) :: stays
      type(damped_type) :: damped
      real(wp) :: residual, worst
      integer :: attempt, outcome, place
      integer :: tried             ! attempts on a mesh before
      integer, parameter :: plan(2) = [by_newton, from_bent]
      tried = maxval([0, newton%history(:newton%iterations)%attempt])
      do attempt = 1, size(plan)
         numerics = model%numerics
         numerics%max_iterations = min(most, newton%iterations + longest_attempt(plan(attempt)))
         call go_through_increments(model, case_index, numerics, pressing, started .and. attempt == 1, gap_states, &
                                    plan(attempt), mesh, &
                                    newton, damped, gaps, state, work, loads, outcome)
         call enter_attempt(tried + attempt, newton)
         stays = outcome == newton_converged
         if (stays) then
            call look_outside(model, mesh, work, worst, place)
            stays = worst <= largest_excess
         end if
         if (stays) exit
      end do
      call end_iterations(newton, model%trajectory, mesh, loads, gaps, state, work, residual)
      stays = stays .and. residual <= tolerance_at(numerics, gaps, newton%force_scale)*newton%force_scale
   end subroutine try_in_plane

   !> Enters the number of an attempt into its rows of the history: those that have none.
   pure subroutine enter_attempt(attempt, newton)
      integer, intent(in) :: attempt
      type(newton_type), intent(inout) :: newton
      where (newton%history(:newton%iterations + 1)%attempt == 0) newton%history(:newton%iterations + 1)%attempt = attempt
   end subroutine enter_attempt

   !> The attempts in their order.
   pure function plan_of(may_buckle, buckles, rotating, straight_down) result(plan)
      logical, intent(in) :: may_buckle, buckles, rotating
      logical, intent(in) :: straight_down    !< where every attempt is as it whirls
      integer :: plan(3)
      if (.not. may_buckle) then
         plan = [by_newton, from_bent, by_forces]
      else if (rotating .and. .not. straight_down) then
         plan = [briefly, by_forces, damped_briefly]
      else if (buckles .and. (straight_down .or. .not. rotating)) then
         plan = [by_damping, by_forces, other_place_damped]
      else
         plan = [briefly, by_forces, by_damping]
      end if
   end function plan_of

   !> Whether a way to iterate is damped Newton's.
   pure function is_damped(way) result(damped)
      integer, intent(in) :: way
      logical :: damped
      damped = any(way == [by_damping, other_place_damped, damped_briefly])
   end function is_damped

   !> Solves the case on the coarsest mesh that the local scale bears, where the mesh asked for is much finer and the string
   !> does not buckle, and takes its shape over as a start.
   subroutine start_from_coarse(model, case_index, mesh, buckles, state, gap_states, started)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: buckles
      real(wp), intent(inout) :: state(:, :)
      integer, intent(inout) :: gap_states(:)
      logical, intent(out) :: started
      type(mesh_type) :: coarse
      type(gap_table_type) :: gaps
      type(newton_type) :: newton
      type(damped_type) :: damped
      type(workspace_type) :: work
      type(load_type) :: loads
      type(numerics_type) :: numerics
      real(wp), allocatable :: solved(:, :)
      type(soft_totals_type) :: totals
      real(wp) :: pressing, compressed, waves
      integer :: outcome, way, shortened(scale_count), none(0)
      started = .false.
      if (buckles .or. model%numerics%load_steps > 1) return
      numerics = settings_of('auto')
      if (.not. model%numerics%element_length*much_finer < numerics%element_length) return
      call mesh_for_case(model, case_index, numerics%element_length, coarse, totals, compressed, waves, pressing, shortened)
      if (mesh%elements < much_finer*coarse%elements) return
      numerics = model%numerics
      numerics%max_iterations = min(coarse_iterations, numerics%max_iterations)
      numerics%tolerance = max(numerics%tolerance, coarse_tolerance)
      call prepare(model, model%cases(case_index), coarse, compressed, newton, work, way)
      allocate (solved(6, coarse%nodes))
      call go_through_increments(model, case_index, numerics, pressing, .false., none, by_newton, coarse, newton, damped, gaps, &
                                 solved, work, loads, outcome)
      started = outcome == newton_converged
      if (started) call take_over(model%trajectory, coarse, work, gaps, solved, mesh, state, gap_states)
   end subroutine start_from_coarse

   !> One attempt: from the soft string, increment by increment, wall by wall, to the end or to where it fails.
   subroutine go_through_increments(model, case_index, numerics, pressing, started, gap_states, way, mesh, newton, damped, &
                                    gaps, state, work, loads, outcome)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: pressing     !< largest expected contact load over its clearance [N/m2]
      logical, intent(in) :: started       !< `state` is a start already: one increment, from the middle walls on
      integer, intent(in) :: gap_states(:) !< of the gaps at such a start
      integer, intent(in) :: way           !< to iterate: by_newton and its like
      type(mesh_type), intent(in) :: mesh
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(gap_table_type), intent(out) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      type(load_type), intent(out) :: loads
      integer, intent(out) :: outcome
      real(wp), allocatable :: walls(:)
      real(wp) :: pressed(contact_places, mesh%elements), fraction, tolerance
      type(force_iteration_type) :: by_force
      logical :: damping
      integer :: increment, stage, first
      damping = is_damped(way)
      newton%gaps_taken_back = .false.
      work%carried = nothing_carried
      call lay_out_gaps(numerics, mesh, gaps)
      if (started) gaps%state = gap_states
      call stage_walls(model, mesh, pressing, damping, walls)
      outcome = newton_exhausted
      do increment = 1, numerics%load_steps
         fraction = real(increment, wp)/numerics%load_steps
         call set_loads(model, model%cases(case_index), fraction, loads)
         first = merge(merge(max(1, size(walls) - 1), 1, started), size(walls), increment == 1)
         do stage = first, size(walls)
            call set_walls(model, mesh, walls(stage), gaps)
            damped%continued = stage > 1
            if (increment == 1 .and. stage == 1 .and. .not. started) then
               if (way == by_newton) then
                  call predict(model, case_index, mesh, fraction, walls(1)*mesh%wall, work%climb, state, gaps)
               else
                  call predict(model, case_index, mesh, fraction, walls(1)*mesh%wall, work%climb, state, gaps, pressed)
                  call press_start(model%trajectory, mesh, numerics, pressed, gaps, state, work)
                  damped%continued = .true.
               end if
            end if
            if (newton%planar) call flatten(newton%plane, state)
            tolerance = tolerance_at(numerics, gaps, newton%force_scale)
            if (stage < size(walls)) tolerance = max(tolerance, merge(settled_tolerance, stage_tolerance, damping))
            if (way == by_forces) then
               if (stage < size(walls)) cycle          ! the soft wall was for the start
               call new_force_iteration(mesh, loads, numerics, tolerance, pressing, newton%compressed, increment, by_force)
               call iterate_forces(by_force, newton, damped, model%trajectory, mesh, gaps, state, work)
               outcome = by_force%outcome
            else if (damping) then
               call iterate_damped(newton, damped, model%trajectory, mesh, loads, numerics, tolerance, stage < size(walls), &
                                   increment, gaps, state, work, outcome)
            else
               call iterate(newton, model%trajectory, mesh, loads, numerics, tolerance, stage < size(walls), increment, gaps, &
                            state, work, outcome)
            end if
            where (newton%history(:newton%iterations + 1)%stage == 0) newton%history(:newton%iterations + 1)%stage = stage
            if (outcome /= newton_converged) return
         end do
      end do
   end subroutine go_through_increments

   !> Room for the solution, in the plane of the hole or in space, and the iteration's scales.
   subroutine prepare(model, load_case, mesh, compressed, newton, work, way)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: compressed   !< over the coiling load [-]
      type(newton_type), intent(out) :: newton
      type(workspace_type), intent(out) :: work
      integer, intent(out) :: way          !< of solution, and why
      associate (numerics => model%numerics)
         call new_workspace(mesh, work)
         call choose_way(numerics%in_plane, mesh, load_case%tob, compressed > watch_share, newton%plane, way)
         call make_room(newton, numerics%linear_solver, mesh%nodes, planar=way == way_planar)
         call new_release_front(mesh%elements, newton%front)
         allocate (newton%history(numerics%max_iterations + 1))
         newton%force_scale = max(sum(mesh%weight*mesh%length) + abs(load_case%wob), least_scale)
         newton%step_limit = numerics%step_limit*maxval(mesh%clearance)
         newton%compressed = compressed > watch_share
      end associate
   end subroutine prepare

   pure subroutine set_loads(model, load_case, fraction, loads)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: fraction
      type(load_type), intent(out) :: loads
      real(wp) :: support
      support = max(model%numerics%gk_max, model%numerics%gk_contact)*support_length
      loads%wob = fraction*load_case%wob
      loads%tob = fraction*load_case%tob
      loads%friction_scale = fraction
      if (model%boundary%top_centred) loads%top_support = support
      if (model%boundary%bit_centred) loads%bit_support = support
   end subroutine set_loads
end module dg_static_analysis
