!> One step of the iteration to equilibrium (dg_equilibrium): its state, how a step is found, shortened and taken.
module dg_step
   use dg_kinds, only: wp
   use dg_assembly, only: add_friction
   use dg_beam_element, only: membrane_change, membrane_length
   use dg_block_matrix, only: block_matrix_type, copy_matrix, new_block_matrix, swap_matrices
   use dg_case_result, only: iteration_type
   use dg_contact_problem, only: add_pushes, change_of_gap, contact_problem_type, hold_by_viscosity, in_series, &
                                 measure_contacts, new_contact_problem, solve_problem
   use dg_director, only: director_gradient
   use dg_equations, only: add_gap_rigidity, equations_type, find_tangent, outcome_exhausted, outcome_singular
   use dg_gap_action, only: load_type
   use dg_gap_state, only: depth_of, state_elastic, state_free, state_rigid
   use dg_gap_survey, only: relocate_gaps, survey_gaps
   use dg_gap_table, only: gap_table_type, keep_gaps, take_gaps_back
   use dg_mesh, only: is_straight_down, mesh_type
   use dg_numerics, only: gap_at_extremum, numerics_type
   use dg_plane, only: unfold
   use dg_trajectory, only: trajectory_type
   use dg_tuning, only: tuning_type
   use dg_viscosity, only: add_viscosity, weigh_all
   use dg_node_moves, only: move_across, slide_along, split_step
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_twist, place_nodes, workspace_type
   implicit none
   private
   public :: equilibrium_type, new_equilibrium, find_step, search_along, go_back, look, measure, move_gaps, settle
   public :: margin_of, rigid

   !> What rho grows by where it is the wall's own [-].
   real(wp), parameter :: rigid = 1.0e30_wp
   !> Viscosity that a compressed equilibrium may need and still count as stable [-]: F would have to drop by half of it. The same
   !> of a string under torque, which friction and the ends' part of torque, neither of them in the energy, turn out of its minimum
   !> and hold there: a shaft at 0.97 of Greenhill's load under 0.3 of its torque needs 0.23.
   real(wp), parameter :: stable = 0.02_wp, stable_twisted = 0.25_wp

   !> One run of the iteration: what it is asked for, and its state.
   type :: equilibrium_type
      type(numerics_type) :: numerics
      type(load_type) :: loads
      real(wp) :: tolerance = 0.0_wp          !< of the residual over the force scale [-]
      real(wp) :: soft = 0.0_wp               !< stiffness of a wall that the expected load presses in visibly [N/m2]
      logical :: watched = .false.            !< compressed: the energy's tangent is to be positive definite
      real(wp) :: cut_from = huge(1.0_wp)     !< elements so long that stand outside the hole end the run, to be cut [m]
      logical, allocatable :: outside(:)      !< elements that stand outside there (e)
      integer :: outcome = outcome_exhausted
      ! state
      type(contact_problem_type) :: problem
      type(iteration_type) :: row
      type(block_matrix_type) :: energy       !< the tangent without friction and torque, where the string is watched
      real(wp), allocatable :: lump(:, :)     !< what a unit of viscosity adds to its diagonal
      real(wp) :: viscosity = 0.0_wp          !< in units of F^2/(4 EI) [-]
      real(wp) :: raised = 1.0_wp             !< what a refusal raises viscosity by
      real(wp) :: growth = 1.0_wp             !< of rho since the softest [-]
      real(wp) :: before = 0.0_wp             !< largest residual at the state, pushes included [N, N.m]
      real(wp) :: trial = 0.0_wp              !< the same at the end of a step, walls pressing with the linear problem's forces
      real(wp) :: slope = 0.0_wp, slope_after = 0.0_wp   !< of the energy along the step, at its start and end [J]
      real(wp) :: share = 1.0_wp              !< of the linear problem's step [-]
      real(wp) :: old_growth = 1.0_wp
      integer :: rounds = 0, round_start = 0
      real(wp), allocatable :: residual(:, :) !< r(d, R) at the state (unknowns,nodes)
      real(wp), allocatable :: move(:, :)     !< that share of the step, in space (6,nodes)
      real(wp), allocatable :: offset(:, :)   !< of the nodes from the hole axis before the step (2,nodes) [m]
      real(wp), allocatable :: slide(:)       !< along the hole by the whole step (nodes) [m]
      real(wp), allocatable :: across(:, :)   !< lateral (2) and slopes (2) by the whole step, across the hole (4,nodes) [m, -]
      real(wp), allocatable :: length(:), longer(:)   !< of elements before the step, and its first change by the step (e) [m]
      real(wp), allocatable :: old(:, :), old_force(:)
      type(gap_table_type) :: kept            !< gaps before the step
      real(wp), allocatable :: settled(:, :), settled_force(:)   !< the equilibrium before gaps moved
      type(gap_table_type) :: settled_gaps
   end type equilibrium_type

contains

   !> A run on a mesh.
   pure subroutine new_equilibrium(mesh, loads, numerics, tolerance, pressing, watched, unknowns, it)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: tolerance
      real(wp), intent(in) :: pressing       !< largest expected contact load over its clearance [N/m2]
      logical, intent(in) :: watched
      integer, intent(in) :: unknowns        !< of a node
      type(equilibrium_type), intent(out) :: it
      real(wp), parameter :: least = 1.0e-9_wp      ! of the wall's stiffness, where nothing presses
      it%numerics = numerics
      it%loads = loads
      it%tolerance = tolerance
      it%soft = max(pressing, least*maxval(mesh%wall))/numerics%tuning%soft_penetration
      it%raised = numerics%tuning%until_definite
      it%growth = numerics%tuning%growth
      it%watched = watched
      call new_contact_problem(mesh, unknowns, it%problem)
      allocate (it%residual(unknowns, mesh%nodes), it%move(6, mesh%nodes), it%old(6, mesh%nodes), it%across(4, mesh%nodes), &
                it%slide(mesh%nodes), it%offset(2, mesh%nodes), source=0.0_wp)
      allocate (it%outside(mesh%elements), source=.false.)
      allocate (it%old_force(mesh%elements), it%length(mesh%elements), it%longer(mesh%elements), source=0.0_wp)
      if (watched) call make_room_to_watch(mesh, it)
   end subroutine new_equilibrium

   !> Room for the energy's tangent and viscosity.
   pure subroutine make_room_to_watch(mesh, it)
      type(mesh_type), intent(in) :: mesh
      type(equilibrium_type), intent(inout) :: it
      it%watched = .true.
      it%energy = new_block_matrix(mesh%nodes)
      allocate (it%lump(6, mesh%nodes), source=0.0_wp)
   end subroutine make_room_to_watch

   !> The step and the forces at its end. A string that is watched has viscosity raised as far as it must be; one that is not has
   !> the whole tangent ready in equations%matrix, and is watched from where it moves too far or up the energy's slope.
   subroutine find_step(it, equations, trajectory, mesh, gaps, state, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: reach
      integer :: fault
      it%problem%closed = gaps%state /= state_free
      if (.not. it%watched) then
         call add_gap_rigidity(mesh, it%numerics%gk_min, equations%laterals, equations%matrix)
         call solve_problem(it%numerics%tuning%most_settlings, equations, gaps, it%residual, work%normal, .true., it%problem, fault)
         if (fault /= 0) then
            it%outcome = outcome_singular
            return
         end if
         call find_reach(it, equations, trajectory, mesh, work, reach)
         if ((reach > it%numerics%step_limit .or. .not. energy_slope(equations, it%problem%load) < 0.0_wp) &
             .and. .not. equations%planar) then
            call make_room_to_watch(mesh, it)
            call find_tangent(equations, trajectory, mesh, it%loads, gaps, state, .true., .false., work)
            call swap_matrices(equations%matrix, it%energy)
         end if
      end if
      if (it%watched) call find_held_step(it, equations, trajectory, mesh, gaps, state, work, reach)
      if (it%outcome == outcome_singular) return
      it%row%viscosity = it%viscosity
      it%row%lateral_step = maxval(abs(it%across(1:2, :)))
      it%share = 1.0_wp/max(1.0_wp, reach)
      equations%step = it%share*equations%step
      it%move = it%share*it%move
   end subroutine find_step

   !> The step of a string that is watched. Viscosity is raised while a node moves too far, and while gaps do not settle that have
   !> walls of their own stiffness: a gap that would pull when closed and be in the wall when open has no solution in a linear
   !> problem that is nearly indefinite, and leaves the string where it is.
   subroutine find_held_step(it, equations, trajectory, mesh, gaps, state, work, reach)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out) :: reach           !< of the step
      real(wp) :: margin
      logical :: live          ! friction follows the contact forces within the step
      logical :: settled       ! every gap is open or closed in the linear problem's solution, or walls are soft
      integer :: hold, fault
      call weigh_all(it%numerics%tuning, mesh, work, it%soft, it%lump)
      it%problem%closed = gaps%state /= state_free
      associate (tuning => it%numerics%tuning)
         margin = 0.0_wp         ! next to an equilibrium that counts as stable nothing needs to be held
         if (it%before < tuning%near*equations%force_scale) margin = margin_of(it, mesh)
         live = any(abs(mesh%axial) > 0.0_wp) .or. any(mesh%rotary > 0.0_wp) .or. abs(it%loads%tob) > 0.0_wp
         do hold = 0, tuning%most_holds
            call hold_by_viscosity(tuning, it%energy, it%lump, it%problem, margin, equations%matrix, it%viscosity)
            do
               call copy_matrix(it%energy, equations%matrix)
               if (live) call add_friction(mesh, it%loads, gaps, state, work, equations%matrix)
               call add_viscosity(it%viscosity, it%lump, equations%matrix)
               call add_gap_rigidity(mesh, it%numerics%gk_min, equations%laterals, equations%matrix)
               call solve_problem(tuning%most_settlings, equations, gaps, it%residual, work%normal, live, it%problem, fault)
               if (fault /= 0) then
                  it%outcome = outcome_singular
                  reach = 0.0_wp
                  return
               end if
               if (.not. live .or. energy_slope(equations, it%problem%load) < 0.0_wp) exit
               live = .false.          ! friction's tangent leads uphill: its forces are left as they are
               it%problem%closed = gaps%state /= state_free
            end do
            call find_reach(it, equations, trajectory, mesh, work, reach)
            settled = it%problem%unsettled == 0 .or. it%growth < rigid
            if ((reach <= it%numerics%step_limit .and. settled) .or. hold == tuning%most_holds) exit
            it%viscosity = max(it%viscosity, tuning%viscosity_start)*tuning%held_more
         end do
      end associate
   end subroutine find_held_step

   !> Holds the turn of the whole string about the axis of a vertical hole, which nothing resists: by a spring, as stiff as the
   !> string there, on the node farthest off the axis, across its offset. It stands in the tangent only, and what would turn the
   !> string, some newtons of torque's work on the ends, is taken off the residual there.
   pure subroutine hold_turn(state, matrix, residual)
      real(wp), intent(in) :: state(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), intent(inout) :: residual(:, :)
      real(wp) :: across(2), stiffness
      integer :: i, node
      node = maxloc(state(dof_lateral_1, :)**2 + state(dof_lateral_2, :)**2, dim=1)
      across = [-state(dof_lateral_2, node), state(dof_lateral_1, node)]
      if (.not. norm2(across) > 0.0_wp) return
      across = across/norm2(across)
      associate (block => matrix%diagonal(dof_lateral_1:dof_lateral_2, dof_lateral_1:dof_lateral_2, node), &
                 force => residual(dof_lateral_1:dof_lateral_2, node))
         stiffness = abs(block(1, 1)) + abs(block(2, 2))
         do i = 1, 2
            block(:, i) = block(:, i) + stiffness*across(i)*across
         end do
         force = force - dot_product(across, force)*across
      end associate
   end subroutine hold_turn

   !> Viscosity that an equilibrium of this string may need and still count as stable [-].
   pure function margin_of(it, mesh) result(margin)
      type(equilibrium_type), intent(in) :: it
      type(mesh_type), intent(in) :: mesh
      real(wp) :: margin
      margin = merge(stable_twisted, stable, any(mesh%rotary > 0.0_wp) .or. abs(it%loads%tob) > 0.0_wp)
   end function margin_of

   !> Largest move of a node across the hole by the step, over its clearance [-]; the step is taken apart for it.
   pure subroutine find_reach(it, equations, trajectory, mesh, work, reach)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(in) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< nodes placed where the step begins
      real(wp), intent(out) :: reach
      integer :: n
      if (equations%planar) then
         call unfold(equations%plane, equations%step, it%move)
      else
         it%move = equations%step
      end if
      call split_step(trajectory, mesh, work, it%move, it%offset, it%slide, it%across)
      reach = 0.0_wp
      do n = 1, mesh%nodes
         reach = max(reach, norm2(it%across(1:2, n))/mesh%clearance(min(n, mesh%elements)))
      end do
   end subroutine find_reach

   !> Slope of the energy along equations%step, `load` its gradient, in the lateral unknowns [J]: axial force and torque follow
   !> from the contact forces by statics, with nothing to be held back.
   pure function energy_slope(equations, load) result(slope)
      type(equations_type), intent(in) :: equations
      real(wp), intent(in) :: load(:, :)
      real(wp) :: slope
      associate (v => equations%laterals, b => equations%slopes)
         slope = sum(equations%step(v(1):v(2), :)*load(v(1):v(2), :)) + sum(equations%step(b(1):b(2), :)*load(b(1):b(2), :))
      end associate
   end function energy_slope

   !> Shortens the step until the slope along it is no longer uphill, or the residual is less than before it, and takes it.
   subroutine search_along(it, equations, trajectory, mesh, gaps, state, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: moved(mesh%elements), part
      integer :: search, e
      it%old_growth = it%growth
      it%old = state
      it%old_force = work%normal
      call keep_gaps(gaps, it%kept)
      equations%iterations = equations%iterations + 1
      do e = 1, mesh%elements
         moved(e) = change_of_gap(it%problem, equations%step, e)/it%share
      end do
      it%slope = slope_at_start(it, equations, work%normal)
      call find_lengths(mesh, work, state, it%move, it%length, it%longer)
      associate (tuning => it%numerics%tuning)
         do search = 0, tuning%most_searches
            call try_step(it, equations, trajectory, mesh, moved, gaps, state, work)
            if (.not. (it%slope < 0.0_wp .and. it%slope_after > tuning%uphill*abs(it%slope)) .or. &
                search == tuning%most_searches .or. it%trial < it%before) exit
            call go_back(it, trajectory, mesh, gaps, state, work)
            part = max(tuning%shortest, min(tuning%longest, it%slope/(it%slope - it%slope_after)))
            it%share = part*it%share
            equations%step = part*equations%step
            it%move = part*it%move
            it%longer = part*it%longer
            it%slope = part*it%slope
         end do
         call take_step(it, trajectory, mesh, gaps, work)
         if (it%row%flips <= nint(tuning%few*count(gaps%state /= state_free)) .and. it%before < tuning%calm*equations%force_scale) &
            it%growth = it%growth*tuning%growth
         if (it%growth >= tuning%stiff) it%growth = rigid
      end associate
   end subroutine search_along

   !> The slope along a step, at its start, of the energy with friction's forces frozen; walls press with R + rho h where that is
   !> positive.
   pure function slope_at_start(it, equations, force) result(slope)
      type(equilibrium_type), intent(in) :: it
      type(equations_type), intent(in) :: equations
      real(wp), intent(in) :: force(:)
      real(wp) :: slope, push
      integer :: e, u
      u = it%problem%unknowns
      slope = energy_slope(equations, it%residual)
      do e = 1, size(force)
         if (.not. (it%problem%closed(e) .or. it%kept%state(e) /= state_free)) cycle
         push = max(0.0_wp, force(e) + it%problem%penalty(e)*it%problem%deep(e)) - force(e)
         slope = slope + push*change_of_gap(it%problem, equations%step, e)
      end do
   end function slope_at_start

   !> Moves the string by the step, and finds the slope of the energy and the residual there: walls press with what the linear
   !> problem has there, and softly on what is off it.
   subroutine try_step(it, equations, trajectory, mesh, moved, gaps, state, work)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: moved(:)       !< change of |f| by the whole step [m]
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp) :: soft, deep, linear
      integer :: e
      call move_string(it, trajectory, mesh, work, state)
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
      call find_tangent(equations, trajectory, mesh, it%loads, gaps, state, .true., .true., work)
      it%slope_after = energy_slope(equations, equations%residual)
      it%trial = maxval(abs(equations%residual))
   end subroutine try_step

   !> state <- state + step, along the wall where the string is watched. A lateral step makes elements longer by its square, which
   !> an axial stiffness turns into kilonewtons: nodes are slid along the hole until elements have the lengths of the linear
   !> problem, and so its axial forces.
   pure subroutine move_string(it, trajectory, mesh, work, state)
      type(equilibrium_type), intent(in) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(inout) :: work       !< placed at `state`, before and after
      real(wp), intent(inout) :: state(:, :)
      real(wp) :: slide
      integer :: e
      call move_across(it%numerics%tuning%turned_beyond, it%watched, mesh, it%offset, it%share*it%across, state)
      state(dof_twist, :) = state(dof_twist, :) + it%move(dof_twist, :)
      do e = 1, mesh%nodes
         call slide_along(trajectory, mesh, e, it%share*it%slide(e), state(:, e))
      end do
      call place_nodes(mesh, state, work)
      if (.not. it%numerics%tuning%keep_lengths) return
      slide = 0.0_wp
      do e = 1, mesh%elements
         slide = slide + it%length(e) + it%longer(e) - membrane_length(mesh%chord(:, e) + (work%shift(:, e + 1) &
                                                                       - work%shift(:, e)), work%d(:, e), work%d(:, e + 1))
         call slide_along(trajectory, mesh, e + 1, slide, state(:, e + 1))
      end do
      call place_nodes(mesh, state, work)
   end subroutine move_string

   !> Lengths of the elements that axial forces go by, and their change by a step (6,nodes) to first order [m].
   pure subroutine find_lengths(mesh, work, state, step, length, longer)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< placed at `state`
      real(wp), intent(in) :: state(:, :), step(:, :)
      real(wp), intent(out) :: length(:), longer(:)
      real(wp) :: moved(12), gradient(3, 2), chord(3)
      integer :: e, n, j
      moved = 0.0_wp
      do n = 1, mesh%nodes
         moved(1:6) = moved(7:12)
         gradient = director_gradient(mesh%frame(:, :, n), state(5:6, n), work%d(:, n))
         do j = 1, 3
            moved(6 + j) = mesh%frame(j, 1, n)*step(1, n) + mesh%frame(j, 2, n)*step(2, n) + mesh%frame(j, 3, n)*step(3, n)
            moved(9 + j) = gradient(j, 1)*step(5, n) + gradient(j, 2)*step(6, n)
         end do
         if (n == 1) cycle
         e = n - 1
         chord = mesh%chord(:, e) + (work%shift(:, n) - work%shift(:, e))
         length(e) = membrane_length(chord, work%d(:, e), work%d(:, n))
         longer(e) = membrane_change(chord, work%d(:, e), work%d(:, n), moved)
      end do
   end subroutine find_lengths

   !> Places the nodes and measures the gaps.
   pure subroutine settle(trajectory, mesh, gaps, state, work)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
   end subroutine settle

   !> Back to the state before the step.
   pure subroutine go_back(it, trajectory, mesh, gaps, state, work)
      type(equilibrium_type), intent(in) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      state = it%old
      work%normal = it%old_force
      call take_gaps_back(it%kept, gaps)
      call settle(trajectory, mesh, gaps, state, work)
   end subroutine go_back

   !> Gives a string that has been moved that share of the change of contact forces that the linear problem has.
   pure subroutine take_step(it, trajectory, mesh, gaps, work)
      type(equilibrium_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      logical :: whole
      integer :: e
      call take_gaps_back(it%kept, gaps)
      whole = .not. it%share < 1.0_wp
      do e = 1, mesh%elements
         work%normal(e) = it%old_force(e) + it%share*(it%problem%wanted(e) - it%old_force(e))
         if (whole .and. (it%problem%closed(e) .neqv. gaps%state(e) /= state_free)) then
            gaps%state(e) = merge(state_elastic, state_free, it%problem%closed(e))
            gaps%flips(e) = gaps%flips(e) + 1
         end if
         if (gaps%state(e) == state_free) work%normal(e) = 0.0_wp
      end do
      call look(it, trajectory, mesh, it%growth < it%numerics%tuning%stiff, gaps, work)
   end subroutine take_step

   !> Residual, tangent at given contact forces in equations%matrix, contact rows, and the largest residual with the pushes of gaps
   !> that are too deep. The tangent is the energy's where the string is watched.
   pure subroutine measure(it, equations, trajectory, mesh, gaps, state, work, largest)
      type(equilibrium_type), intent(inout) :: it
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out) :: largest
      call find_tangent(equations, trajectory, mesh, it%loads, gaps, state, it%watched, .false., work)
      if (it%watched .and. any(gaps%state /= state_free) .and. is_straight_down(mesh)) &
         call hold_turn(state, equations%matrix, equations%residual)
      it%residual = equations%residual
      call measure_contacts(equations, mesh, it%loads, gaps, state, it%soft*it%growth, work, it%problem)
      call add_pushes(gaps, it%residual, it%problem, it%problem%load)
      it%row%residual_force = maxval(abs(it%problem%load(:equations%forces, :)))
      it%row%residual_moment = maxval(abs(it%problem%load(equations%forces + 1:, :)))
      largest = max(it%row%residual_force, it%row%residual_moment)
   end subroutine measure

   !> Which gaps are closed where the string is; row%flips counts those that changed since the step began. A gap closes
   !> when it is in the wall. It opens when it would pull, R + rho (|f| - depth(R)) < 0 with the softest rho. Both by more than the
   !> thresholds of Eqs. 7 and 8.
   pure subroutine look(it, trajectory, mesh, relocate, gaps, work)
      type(equilibrium_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: relocate        !< gaps may move
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work   !< placed and surveyed
      real(wp) :: deep
      integer :: e, next
      it%row%moves = 0
      if (relocate) call move_gaps(it, trajectory, mesh, it%numerics%tuning%gently, it%row%flips == 0, .false., gaps, work)
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
   pure subroutine move_gaps(it, trajectory, mesh, most, closed, closely, gaps, work)
      type(equilibrium_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: most               !< as of relocate_gaps
      logical, intent(in) :: closed, closely     !< the same
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      it%row%moves = 0
      if (it%numerics%gap_location == gap_at_extremum) &
         call relocate_gaps(trajectory, mesh, it%numerics%relocation, most, closed, closely, gaps, work, it%row%moves)
   end subroutine move_gaps
end module dg_step
