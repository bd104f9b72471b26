!> Steps of the iteration with contact forces as unknowns (dg_force_iteration): its state, how a step is found, shortened and taken.
module dg_force_step
   use dg_kinds, only: wp
   use dg_assembly, only: assemble
   use dg_block_matrix, only: block_matrix_type
   use dg_case_result, only: iteration_type
   use dg_contact_problem, only: add_pushes, change_of_gap, contact_problem_type, hold_by_viscosity, in_series, &
                                 measure_contacts, new_contact_problem, prepare_problem, solve_problem
   use dg_gap_action, only: load_type
   use dg_gap_depths, only: depth_of
   use dg_gap_state, only: state_elastic, state_free, state_rigid
   use dg_gap_survey, only: relocate_gaps, survey_gaps
   use dg_gap_table, only: gap_table_type, keep_gaps, take_gaps_back
   use dg_mesh, only: mesh_type
   use dg_newton, only: add_gap_rigidity, largest_turn, newton_exhausted, newton_singular, newton_type
   use dg_numerics, only: gap_at_extremum, numerics_type
   use dg_trajectory, only: trajectory_type
   use dg_turning_step, only: turn_along_wall
   use dg_viscosity, only: damped_type, until_definite, viscosity_start, weigh_all
   use dg_wall_stages, only: soft_penetration
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, place_nodes, workspace_type
   implicit none
   private
   public :: force_iteration_type, new_force_iteration, find_step, search_along, go_back, look, move_gaps, measure
   public :: rigid, stiff

   !> It grows by this factor when few gaps change, this part of the closed ones, and the residual is below this part of the force
   !> scale; so much stiffer than it began it is the wall's own [-].
   real(wp), parameter :: stiffening = 10.0_wp, few = 0.05_wp, calm = 1.0e-2_wp, stiff = 1.0e4_wp
   real(wp), parameter :: rigid = 1.0e30_wp
   !> Viscosity is raised by this factor, so often at most, while a node moves by more than `far` of its clearance; what is left is
   !> a matter of the step's share [-].
   real(wp), parameter :: held_more = 4.0_wp, far = 2.0_wp
   integer, parameter :: most_holds = 8
   !> A slope at a step's end over that at its start from which the step is shortened [-]; times that it is shortened,
   !> each between these parts.
   real(wp), parameter :: uphill = 0.3_wp, shortest = 0.1_wp, longest = 0.7_wp
   integer, parameter :: most_searches = 3

   !> One run of the iteration: what it is asked for, and its state.
   type :: force_iteration_type
      type(numerics_type) :: numerics
      type(load_type) :: loads
      real(wp) :: tolerance = 0.0_wp          !< of the residual over the force scale [-]
      real(wp) :: soft = 0.0_wp               !< stiffness that rho begins with: that of the first stage of walls [N/m2]
      logical :: watched = .false.            !< compressed: the energy's tangent is to be positive definite
      integer :: outcome = newton_exhausted   !< one of the numbers of dg_newton
      ! state
      type(contact_problem_type) :: problem
      type(iteration_type) :: row
      logical :: friction = .false.
      real(wp) :: growth = 1.0_wp             !< of rho since the start [-]
      real(wp) :: raised = until_definite     !< what a refusal raises viscosity by
      real(wp) :: before = 0.0_wp             !< largest residual at the state, pushes included [N, N.m]
      real(wp) :: slope = 0.0_wp, slope_after = 0.0_wp   !< along the step, at its start and end [J]
      real(wp) :: share = 1.0_wp              !< of the linear problem's step [-]
      real(wp) :: old_growth = 1.0_wp
      integer :: rounds = 0, round_start = 0
      real(wp), allocatable :: residual(:, :) !< r(d, R) at the state (6,nodes)
      real(wp), allocatable :: old(:, :), old_force(:)
      type(gap_table_type) :: kept            !< gaps before the step
      real(wp), allocatable :: rest(:, :), rest_force(:)
      type(gap_table_type) :: rest_gaps       !< before gaps moved
   end type force_iteration_type

contains

   !> A run on a mesh.
   pure subroutine new_force_iteration(mesh, loads, numerics, tolerance, pressing, watched, increment, it)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: tolerance
      real(wp), intent(in) :: pressing       !< largest expected contact load over its clearance [N/m2]
      logical, intent(in) :: watched
      integer, intent(in) :: increment
      type(force_iteration_type), intent(out) :: it
      real(wp), parameter :: least = 1.0e-9_wp      ! of the wall's stiffness, where nothing presses
      it%numerics = numerics
      it%loads = loads
      it%tolerance = tolerance
      it%soft = max(pressing, least*maxval(mesh%wall))/soft_penetration
      it%watched = watched
      it%row%increment = increment
      it%friction = any(abs(mesh%axial) > 0.0_wp) .or. any(mesh%rotary > 0.0_wp) .or. abs(loads%tob) > 0.0_wp
      call new_contact_problem(mesh, it%problem)
      allocate (it%residual(6, mesh%nodes), it%old(6, mesh%nodes), it%rest(6, mesh%nodes), source=0.0_wp)
      allocate (it%old_force(mesh%elements), it%rest_force(mesh%elements), source=0.0_wp)
   end subroutine new_force_iteration

   !> The step and the forces at its end, viscosity raised as far as it must be.
   subroutine find_step(it, newton, damped, mesh, gaps, state, work)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: reach
      logical :: live          ! friction follows the contact forces within the step
      integer :: hold, fault
      call weigh_all(mesh, work, it%soft, damped%lump)
      live = it%friction
      it%problem%closed = gaps%state /= state_free
      do hold = 0, most_holds
         if (it%watched) call hold_by_viscosity(it%problem, newton%matrix, damped)
         do
            call prepare_problem(damped, mesh, it%loads, gaps, state, live, work, it%problem)
            call add_gap_rigidity(mesh, it%numerics%gk_min, it%problem%base, newton%laterals)
            call solve_problem(newton, gaps, it%residual, work%normal, live, it%problem, it%slope, fault)
            if (fault /= 0) then
               it%outcome = newton_singular
               return
            end if
            if (.not. (it%watched .and. live) .or. it%slope < 0.0_wp) exit
            live = .false.          ! friction's tangent leads uphill: its forces are left as they are
            it%problem%closed = gaps%state /= state_free
         end do
         reach = reach_of(newton%step, mesh)
         if (.not. it%watched .and. (reach > far .or. .not. it%slope < 0.0_wp)) then
            it%watched = .true.
            cycle
         end if
         if (reach <= far .or. hold == most_holds) exit
         damped%viscosity = max(damped%viscosity, viscosity_start)*held_more
      end do
      it%row%viscosity = damped%viscosity
      it%row%lateral_step = maxval(abs(newton%step(dof_lateral_1:dof_lateral_2, :)))
      it%share = 1.0_wp/max(1.0_wp, reach)
      newton%step = it%share*newton%step
   end subroutine find_step

   !> Largest lateral step of a node over its clearance, or turn over the largest one [-].
   pure function reach_of(step, mesh) result(reach)
      real(wp), intent(in) :: step(:, :)
      type(mesh_type), intent(in) :: mesh
      real(wp) :: reach
      integer :: n
      reach = maxval(abs(step(dof_slope_1:dof_slope_2, :)))/largest_turn
      do n = 1, mesh%nodes
         reach = max(reach, norm2(step(dof_lateral_1:dof_lateral_2, n))/mesh%clearance(min(n, mesh%elements)))
      end do
   end function reach_of

   !> Shortens the step until the slope along it is no longer uphill, and takes it.
   subroutine search_along(it, newton, trajectory, mesh, gaps, state, work)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: moved(mesh%elements), after, part
      integer :: search, e
      it%old_growth = it%growth
      it%old = state
      it%old_force = work%normal
      call keep_gaps(gaps, it%kept)
      newton%iterations = newton%iterations + 1
      do e = 1, mesh%elements
         moved(e) = change_of_gap(it%problem, newton%step, e)/it%share
      end do
      it%slope = slope_at_start(it, newton%step, work%normal)
      do search = 0, most_searches
         call find_slope_after(it, newton, trajectory, mesh, moved, gaps, state, work, after)
         call go_back(it, trajectory, mesh, gaps, state, work)
         if (.not. (it%slope < 0.0_wp .and. after > uphill*abs(it%slope)) .or. search == most_searches .or. &
             maxval(abs(newton%residual)) < it%before) exit
         part = max(shortest, min(longest, it%slope/(it%slope - after)))
         it%share = part*it%share
         newton%step = part*newton%step
         it%slope = part*it%slope
      end do
      call take_step(it, newton, trajectory, mesh, gaps, state, work)
      it%growth = merge(it%growth*stiffening, it%growth, it%row%flips <= nint(few*count(gaps%state /= state_free)) .and. &
                        it%before < calm*newton%force_scale)
      if (it%growth >= stiff) it%growth = rigid
      it%slope_after = after
   end subroutine search_along

   !> The slope along a step, at its start, of the energy with friction's forces frozen; walls press with R + rho h where that is
   !> positive.
   pure function slope_at_start(it, step, force) result(slope)
      type(force_iteration_type), intent(in) :: it
      real(wp), intent(in) :: step(:, :), force(:)
      real(wp) :: slope, push
      integer :: e
      slope = sum(step*it%residual)
      associate (problem => it%problem)
         do e = 1, size(force)
            if (.not. (problem%closed(e) .or. it%kept%state(e) /= state_free)) cycle
            push = max(0.0_wp, force(e) + problem%penalty(e)*problem%deep(e)) - force(e)
            slope = slope + push*(sum(problem%on(1:6, e)*step(:, e)) + sum(problem%on(7:12, e)*step(:, e + 1)))
         end do
      end associate
   end function slope_at_start

   !> The same at its end: walls press with what the linear problem has there, and softly on what is off it. The residual stays in
   !> newton%residual.
   subroutine find_slope_after(it, newton, trajectory, mesh, moved, gaps, state, work, slope)
      type(force_iteration_type), intent(in) :: it
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: moved(:)       !< change of |f| by the whole step [m]
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out) :: slope
      real(wp) :: soft, deep, linear
      integer :: e
      call move_string(it, newton%step, trajectory, mesh, work, state)
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
      associate (problem => it%problem)
         do e = 1, mesh%elements
            soft = min(problem%penalty(e), in_series(gaps%law(e)%contact, it%soft*mesh%length(e)))
            deep = work%displacement(e) - depth_of(gaps%law(e), it%old_force(e))
            if (problem%closed(e) .or. it%kept%state(e) /= state_free) then
               linear = problem%deep(e) + it%share*moved(e)
               work%normal(e) = max(0.0_wp, it%old_force(e) + problem%penalty(e)*linear + soft*(deep - linear))
            else
               work%normal(e) = max(0.0_wp, soft*deep)
            end if
            gaps%state(e) = merge(state_elastic, state_free, work%normal(e) > 0.0_wp)
         end do
      end associate
      call assemble(trajectory, mesh, it%loads, gaps, state, .true., work, newton%residual, newton%matrix, forces_only=.true.)
      slope = sum(newton%step*newton%residual)
   end subroutine find_slope_after

   !> state <- state + step; along the wall where the string is compressed.
   pure subroutine move_string(it, step, trajectory, mesh, work, state)
      type(force_iteration_type), intent(in) :: it
      real(wp), intent(in) :: step(:, :)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< placed at `state`
      real(wp), intent(inout) :: state(:, :)
      if (it%watched) then
         call turn_along_wall(trajectory, mesh, work, step, state)
      else
         state = state + step
      end if
   end subroutine move_string

   !> Back to the state before the step.
   pure subroutine go_back(it, trajectory, mesh, gaps, state, work)
      type(force_iteration_type), intent(in) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      state = it%old
      work%normal = it%old_force
      call take_gaps_back(it%kept, gaps)
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
   end subroutine go_back

   !> To the end of the step, with that share of the forces that the linear problem has there.
   subroutine take_step(it, newton, trajectory, mesh, gaps, state, work)
      type(force_iteration_type), intent(inout) :: it
      type(newton_type), intent(in) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: whole
      integer :: e
      call move_string(it, newton%step, trajectory, mesh, work, state)
      whole = .not. it%share < 1.0_wp
      do e = 1, mesh%elements
         work%normal(e) = work%normal(e) + it%share*(it%problem%wanted(e) - work%normal(e))
         if (whole .and. (it%problem%closed(e) .neqv. gaps%state(e) /= state_free)) then
            gaps%state(e) = merge(state_elastic, state_free, it%problem%closed(e))
            gaps%flips(e) = gaps%flips(e) + 1
         end if
         if (gaps%state(e) == state_free) work%normal(e) = 0.0_wp
      end do
      call look(it, trajectory, mesh, it%growth < stiff, gaps, state, work)
   end subroutine take_step

   !> Residual, tangent at given contact forces, contact rows, and the largest residual with the pushes of gaps that are too deep.
   subroutine measure(it, trajectory, mesh, gaps, state, work, matrix, largest)
      type(force_iteration_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), intent(out) :: largest
      call assemble(trajectory, mesh, it%loads, gaps, state, .true., work, it%residual, matrix)
      call measure_contacts(mesh, it%loads, gaps, state, it%soft*it%growth, work, it%problem)
      call add_pushes(gaps, it%residual, it%problem, it%problem%load)
      it%row%residual_force = maxval(abs(it%problem%load(1:3, :)))
      it%row%residual_moment = maxval(abs(it%problem%load(4:6, :)))
      largest = max(it%row%residual_force, it%row%residual_moment)
   end subroutine measure

   !> Where the string is, and which gaps are closed there; row%flips counts those that changed since the step began. A gap closes
   !> when it is in the wall. It opens when it would pull, R + rho (|f| - depth(R)) < 0 with the softest rho. Both by more than the
   !> thresholds of Eqs. 7 and 8.
   subroutine look(it, trajectory, mesh, relocate, gaps, state, work)
      type(force_iteration_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: relocate        !< gaps may move
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: deep
      integer :: e, next
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
      it%row%moves = 0
      if (relocate) call move_gaps(it, trajectory, mesh, it%row%flips == 0, .false., gaps, work)
      it%row%flips = 0
      do e = 1, mesh%elements
         associate (law => gaps%law(e), force => work%normal(e))
            deep = work%displacement(e) - depth_of(law, max(force, 0.0_wp))
            next = gaps%state(e)
            if (next == state_free) then
               if (deep > law%eps_n0*law%clearance .and. law%contact*deep > law%r_n0) next = state_elastic
            else
               next = merge(state_rigid, state_elastic, force > law%contact*law%clearance*law%eps_nmax)
               if (force < -law%r_n0 .or. (force + it%soft*mesh%length(e)*deep < -law%r_n0 .and. &
                                           deep < -law%eps_n0*law%clearance)) next = state_free
            end if
            if (next /= it%kept%state(e)) it%row%flips = it%row%flips + 1
            if (next /= gaps%state(e)) gaps%flips(e) = gaps%flips(e) + 1
            gaps%state(e) = next
            if (next == state_free) force = 0.0_wp
         end associate
      end do
   end subroutine look

   !> Moves gaps to where the string is deepest (Eq. 2).
   pure subroutine move_gaps(it, trajectory, mesh, closed, closely, gaps, work)
      type(force_iteration_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: closed, closely     !< as of relocate_gaps
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      it%row%moves = 0
      if (it%numerics%gap_location == gap_at_extremum) &
         call relocate_gaps(trajectory, mesh, it%numerics%relocation, closed, closely, gaps, work, it%row%moves)
   end subroutine move_gaps
end module dg_force_step
