!> Line search: shortening and application of a step of the iteration to equilibrium (dg_equilibrium).
module dg_line_search
   use dg_kinds, only: wp
   use dg_beam_element, only: membrane_length, membrane_step
   use dg_contact_problem, only: in_series
   use dg_equations, only: equations_type, find_tangent, forces_alone
   use dg_followed_gaps, only: follow_extrema
   use dg_gap_state, only: depth_of, state_elastic, state_free
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: keep_gaps, restore_gap_table
   use dg_held_coils, only: hold_sideways
   use dg_iteration_state, only: energy_slope, equilibrium_type, go_back, judge_gaps, stiffen_walls
   use dg_node_moves, only: move_across, slide_along, slide_on
   use dg_round_wall, only: turned_part
   use dg_solution, only: solution_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_twist, place_node, place_nodes
   implicit none
   private
   public :: search_along

contains

   !> Apply the step. The step of a damped string is first shortened until the slope of the energy along it is no longer
   !> uphill. It is also short enough if the residual is less than before. The step of any other string is applied as it is.
   pure subroutine search_along(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp) :: part
      integer :: search
      it%origin%growth = it%wall%growth
      it%origin%state = solution%state
      it%origin%force = solution%work%normal
      call keep_gaps(solution%gaps, it%origin%gaps)
      solution%equations%iterations = solution%equations%iterations + 1
      call find_lengths(solution, it%origin%length, it%step%longer)
      if (it%damper%on) then
         it%damper%turning = turned_part(it%origin%offset, solution%mesh%clearance, solution%mesh%length)
         it%damper%slope = slope_at_start(it, solution%equations, solution%work%normal)
         associate (tuning => it%numerics%tuning)
            do search = 0, tuning%most_searches
               call try_step(it, trajectory, solution)
               if (.not. (it%damper%slope < 0.0_wp .and. it%damper%slope_after > tuning%uphill*abs(it%damper%slope)) .or. &
                   search == tuning%most_searches .or. it%residual%trial < it%residual%before) exit
               call go_back(it, trajectory, solution)
               part = max(tuning%shortest, min(tuning%longest, it%damper%slope/(it%damper%slope - it%damper%slope_after)))
               it%step%share = part*it%step%share
               solution%equations%step = part*solution%equations%step
               it%step%longer = part*it%step%longer
               it%damper%slope = part*it%damper%slope
            end do
         end associate
      else
         call move_and_survey(it, trajectory, solution)
      end if
      call move_contacts(it, trajectory, solution)
      if (it%damper%on) call stiffen_walls(it, it%residual%trial, solution)
   end subroutine search_along

   !> Slope of the energy along a step, at its start, with frozen friction forces [J]. Walls press with R + rho h where that is
   !> positive.
   pure function slope_at_start(it, equations, force) result(slope)
      type(equilibrium_type), intent(in) :: it
      type(equations_type), intent(in) :: equations
      real(wp), intent(in) :: force(:)             !< contact forces [N]
      real(wp) :: slope, push
      integer :: e
      slope = energy_slope(equations, it%residual%nodal)
      do e = 1, size(force)
         if (.not. (it%problem%closed(e) .or. it%origin%gaps%state(e) /= state_free)) cycle
         push = max(0.0_wp, force(e) + it%problem%penalty(e)*it%problem%deep(e)) - force(e)
         slope = slope + push*it%step%share*it%problem%moved(e)
      end do
   end function slope_at_start

   !> Move the string by the step, and compute the slope of the energy and the residual there. Walls press with the force of
   !> the linear problem, and softly on the depth beyond it.
   pure subroutine try_step(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp) :: soft, deep, linear
      integer :: e
      associate (equations => solution%equations, mesh => solution%mesh, loads => solution%loads, gaps => solution%gaps, &
                 state => solution%state, work => solution%work)
         call move_and_survey(it, trajectory, solution)
         associate (problem => it%problem)
            do e = 1, mesh%elements
               soft = min(problem%penalty(e), in_series(gaps%law(e)%contact, it%wall%soft*mesh%length(e)))
               deep = work%displacement(e) - depth_of(gaps%law(e), it%origin%force(e))
               if (problem%closed(e) .or. it%origin%gaps%state(e) /= state_free) then
                  linear = problem%deep(e) + it%step%share*problem%moved(e)
                  work%normal(e) = max(0.0_wp, it%origin%force(e) + problem%penalty(e)*linear + soft*(deep - linear))
               else
                  work%normal(e) = max(0.0_wp, soft*deep)
               end if
               gaps%state(e) = merge(state_elastic, state_free, work%normal(e) > 0.0_wp)
            end do
         end associate
         if (it%holder%holding) call hold_sideways(it%holder, it%numerics%tuning%most_held, solution)
         call find_tangent(equations, trajectory, mesh, loads, gaps, state, forces_alone, work, it%problem%load)
         it%damper%slope_after = energy_slope(equations, it%problem%load)
         it%residual%trial = maxval(abs(it%problem%load))
      end associate
   end subroutine try_step

   !> Move the string by the step, with it the gaps that follow, and measure the gaps.
   pure subroutine move_and_survey(it, trajectory, solution)
      type(equilibrium_type), intent(in) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      call move_string(it, trajectory, solution)
      call follow_extrema(it%problem%followers, solution%equations%step, it%step%share, it%origin%gaps%xi, solution%gaps%xi)
      call survey_gaps(trajectory, solution%mesh, solution%gaps, solution%work)
   end subroutine move_and_survey

   !> Add the step to the state; a damped string moves along the round wall. A lateral step lengthens elements by its square,
   !> which the axial stiffness turns into kilonewtons. Nodes are therefore slid along the hole until elements have the lengths
   !> of the linear problem, and so its axial forces.
   pure subroutine move_string(it, trajectory, solution)
      type(equilibrium_type), intent(in) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp) :: slide, chord(3), tangent(3), curvature(3)
      integer :: n, e
      associate (equations => solution%equations, mesh => solution%mesh, work => solution%work, state => solution%state)
         call move_across(it%damper%turning, it%origin%offset, it%step%share, it%step%across, state)
         slide = 0.0_wp
         do n = 1, mesh%nodes
            state(dof_twist, n) = state(dof_twist, n) + equations%step(dof_twist, n)
            call slide_along(trajectory, mesh, n, it%step%share*it%step%slide(n), state(:, n), tangent, curvature)
            if (.not. it%numerics%tuning%keep_lengths) cycle
            call place_node(mesh%frame(:, :, n), state(:, n), work%shift(:, n), work%d(:, n))
            if (n == 1) cycle
            e = n - 1
            chord = mesh%chord(:, e) + (work%shift(:, n) - work%shift(:, e))
            slide = slide + it%origin%length(e) + it%step%longer(e) - membrane_length(chord, work%d(:, e), work%d(:, n))
            call slide_on(trajectory, mesh, n, slide, tangent, curvature, state(:, n))
         end do
         call place_nodes(mesh, state, work)
      end associate
   end subroutine move_string

   !> Lengths of the elements for the axial force, and their change by the step to first order [m].
   pure subroutine find_lengths(solution, length, longer)
      type(solution_type), intent(in) :: solution
      real(wp), intent(out) :: length(:), longer(:)
      real(wp) :: chord(3), moved(6), before(6)
      integer :: e, n
      associate (equations => solution%equations, mesh => solution%mesh, work => solution%work, state => solution%state)
         before = 0.0_wp
         do n = 1, mesh%nodes
            call move_in_space(mesh%frame(:, :, n), work%d(:, n), state(:, n), equations%step(:, n), moved)
            if (n > 1) then
               e = n - 1
               chord = mesh%chord(:, e) + (work%shift(:, n) - work%shift(:, e))
               before(1:3) = moved(1:3) - before(1:3)
               call membrane_step(chord, work%d(:, e), work%d(:, n), before(1:3), before(4:6), moved(4:6), length(e), longer(e))
            end if
            before = moved
         end do
      end associate
   end subroutine find_lengths

   !> Motion of a node by a step of its unknowns, and of its director to first order (6), in space axes [m, -].
   pure subroutine move_in_space(frame, d, state, step, moved)
      real(wp), intent(in) :: frame(3, 3), d(3), state(6), step(6)
      real(wp), intent(out) :: moved(6)
      real(wp) :: reciprocal, along
      integer :: j
      reciprocal = 1.0_wp/sqrt(1.0_wp + state(5)**2 + state(6)**2)
      along = (state(5)*step(5) + state(6)*step(6))*reciprocal
      do j = 1, 3
         moved(j) = frame(j, 1)*step(1) + frame(j, 2)*step(2) + frame(j, 3)*step(3)
         moved(3 + j) = (frame(j, 2)*step(5) + frame(j, 3)*step(6) - along*d(j))*reciprocal
      end do
   end subroutine move_in_space

   !> Change contact forces of a moved string by the taken share of their change in the linear problem, and judge the gaps.
   pure subroutine move_contacts(it, trajectory, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      logical :: whole
      integer :: e
      associate (mesh => solution%mesh, gaps => solution%gaps, work => solution%work)
         call restore_gap_table(it%origin%gaps, gaps)
         call follow_extrema(it%problem%followers, solution%equations%step, it%step%share, it%origin%gaps%xi, gaps%xi)
         whole = .not. it%step%share < 1.0_wp
         do e = 1, mesh%elements
            work%normal(e) = it%origin%force(e) + it%step%share*(it%problem%wanted(e) - it%origin%force(e))
            if (whole .and. (it%problem%closed(e) .neqv. gaps%state(e) /= state_free)) then
               gaps%state(e) = merge(state_elastic, state_free, it%problem%closed(e))
               gaps%flips(e) = gaps%flips(e) + 1
            end if
            if (gaps%state(e) == state_free) work%normal(e) = 0.0_wp
         end do
         call judge_gaps(it, trajectory, it%wall%growth < it%numerics%tuning%stiff, solution)
         if (it%holder%holding) call hold_sideways(it%holder, it%numerics%tuning%most_held, solution)
      end associate
   end subroutine move_contacts
end module dg_line_search
