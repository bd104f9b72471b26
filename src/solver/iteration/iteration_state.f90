!> State of the iteration to equilibrium (dg_equilibrium), and quantities measured at it.
module dg_iteration_state
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, new_symmetric_matrix
   use dg_case_result, only: iteration_type
   use dg_contact_problem, only: add_pushes, contact_problem_type, measure_contacts, new_contact_problem
   use dg_equations, only: energy_tangent, equations_type, find_tangent, forces_alone, whole_tangent
   use dg_followed_gaps, only: add_place_forces, add_place_stiffness, measure_followers
   use dg_gap_state, only: depth_of, next_state, state_free
   use dg_gap_survey, only: move_rule_type, relocate_gaps, survey_gaps
   use dg_gap_table, only: gap_table_type, restore_gap_table
   use dg_held_coils, only: holder_type
   use dg_largest, only: largest_of_rows
   use dg_mesh, only: is_vertical, mesh_type
   use dg_numerics, only: gap_at_extremum, numerics_type
   use dg_outcome, only: outcome_open
   use dg_solution, only: solution_type
   use dg_trajectory, only: trajectory_type
   use dg_walls, only: tolerance_at
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_2, dof_twist, place_nodes
   implicit none
   private
   public :: equilibrium_type, new_equilibrium, make_room_to_damp, measure, margin_of, energy_slope, place_and_survey, go_back
   public :: judge_gaps, move_gaps, rigid, stiffen_walls

   !> Growth of rho from which on it is the wall's own stiffness [-].
   real(wp), parameter :: rigid = 1.0e30_wp
   !> Damping that a compressed equilibrium may need and still count as stable [-]. F would have to drop by half of it. A
   !> string under torque is allowed more. Friction and the ends' part of torque, neither in the energy, turn it out of its
   !> minimum and hold it there. A shaft at 0.97 of Greenhill's load under 0.3 of its torque needs 0.23.
   real(wp), parameter :: stable = 0.02_wp, stable_twisted = 0.25_wp

   !> Walls during the iteration.
   type :: wall_type
      real(wp) :: soft = 0.0_wp               !< stiffness of a wall that yields visibly to the expected load [N/m2]
      real(wp) :: growth = 1.0_wp             !< growth of rho since the softest [-]
   end type wall_type

   !> Damping, which keeps the energy's tangent positive definite.
   type :: damper_type
      logical :: on = .false.
      type(block_matrix_type) :: energy       !< tangent without friction and torque
      real(wp), allocatable :: lump(:, :)     !< diagonal terms of a unit of damping (6,nodes)
      real(wp), allocatable :: turning(:, :)  !< turned_part of the nodes (2,nodes) [-, 1/m]; 0 without damping
      real(wp) :: factor = 0.0_wp             !< in units of F^2/(4 EI) [-]
      real(wp) :: raised = 1.0_wp             !< factor on it at a refusal
      real(wp) :: slope = 0.0_wp, slope_after = 0.0_wp   !< of the energy along the step, at its start and end [J]
   end type damper_type

   !> Residuals at the state, the largest with pushes of gaps that are too deep.
   type :: residual_type
      real(wp), allocatable :: nodal(:, :)    !< r(d, R) (6,nodes)
      real(wp) :: before = 0.0_wp             !< largest where the step begins [N, N.m]
      real(wp) :: trial = 0.0_wp              !< largest where the step of a damped string ends [N, N.m]
      real(wp) :: unbalanced = 0.0_wp         !< largest without pushes [N, N.m]
      real(wp) :: flipped = 0.0_wp            !< largest force of a gap that opened or closed in the step [N]
      real(wp) :: least = huge(1.0_wp)        !< least so far [N, N.m]
      integer :: least_at = 0                 !< iteration with it
   end type residual_type

   !> String where the step begins.
   type :: origin_type
      real(wp), allocatable :: state(:, :), force(:)
      type(gap_table_type) :: gaps
      real(wp) :: growth = 1.0_wp             !< of rho [-]
      real(wp), allocatable :: offset(:, :)   !< of the nodes from the hole axis (2,nodes) [m]
      real(wp), allocatable :: length(:)      !< of elements (e) [m]
   end type origin_type

   !> Step of the linear problem.
   type :: step_type
      real(wp) :: share = 1.0_wp              !< share of it that is taken [-]
      real(wp), allocatable :: slide(:)       !< slide along the hole by the whole step (nodes) [m]
      real(wp), allocatable :: across(:, :)   !< lateral (2) and slopes (2) by the whole step, across the hole (4,nodes) [m, -]
      real(wp), allocatable :: longer(:)      !< first change of the length of elements (e) [m]
   end type step_type

   !> Moves of gaps near an equilibrium, and the string before the last of them.
   type :: moving_type
      integer :: rounds = 0                   !< number of times that gaps have moved
      integer :: start = 0                    !< iteration at which they last moved
      real(wp), allocatable :: state(:, :), force(:), held(:)
      type(gap_table_type) :: gaps
   end type moving_type

   !> One run of the iteration: its settings, and its state.
   type :: equilibrium_type
      type(numerics_type) :: numerics
      real(wp) :: tolerance(2) = 0.0_wp       !< limit of the residual over the force scale, with pushes and without [-]
      real(wp) :: cut_from = huge(1.0_wp)     !< least length of an element outside the hole that ends the run, to be cut [m]
      logical, allocatable :: outside(:)      !< elements outside the hole that are to be cut (e)
      integer :: outcome = outcome_open
      type(contact_problem_type) :: problem
      type(iteration_type) :: row
      type(wall_type) :: wall
      type(damper_type) :: damper
      type(residual_type) :: residual
      type(origin_type) :: origin
      type(step_type) :: step
      type(moving_type) :: moving
      type(holder_type) :: holder             !< of a string that drifts
      integer :: held = 0                     !< node that is held against turning in a vertical hole; 0: none
   end type equilibrium_type

contains

   !> Set up a run from the present state.
   pure subroutine new_equilibrium(solution, numerics, it)
      type(solution_type), intent(in) :: solution
      type(numerics_type), intent(in) :: numerics
      type(equilibrium_type), intent(out) :: it
      real(wp), parameter :: least = 0.1_wp      ! where no load presses [N/m2]
      associate (mesh => solution%mesh)
         it%numerics = numerics
         it%tolerance = tolerance_at(numerics, mesh, solution%gaps, solution%loads, solution%equations%force_scale)
         it%wall%soft = max(solution%pressing, least)/numerics%tuning%soft_penetration
         it%damper%raised = numerics%tuning%until_definite
         it%wall%growth = numerics%tuning%growth
         call new_contact_problem(mesh, it%problem)
         allocate (it%residual%nodal(6, mesh%nodes), it%origin%state(6, mesh%nodes), it%step%across(4, mesh%nodes), &
                   it%step%slide(mesh%nodes), it%origin%offset(2, mesh%nodes), source=0.0_wp)
         allocate (it%outside(mesh%elements), source=.false.)
         allocate (it%damper%turning(2, mesh%nodes), source=0.0_wp)
         allocate (it%origin%force(mesh%elements), it%origin%length(mesh%elements), it%step%longer(mesh%elements), source=0.0_wp)
         if (solution%compressed > numerics%tuning%damped_share) call make_room_to_damp(mesh, it)
      end associate
   end subroutine new_equilibrium

   !> Allocate the energy's tangent and damping.
   pure subroutine make_room_to_damp(mesh, it)
      type(mesh_type), intent(in) :: mesh
      type(equilibrium_type), intent(inout) :: it
      it%damper%on = .true.
      it%damper%energy = new_symmetric_matrix(mesh%nodes)
      allocate (it%damper%lump(6, mesh%nodes), source=0.0_wp)
   end subroutine make_room_to_damp

   !> Compute residual, tangent at given contact forces in equations%matrix, and contact rows. Compute the largest residual
   !> with the pushes of gaps that are too deep. The tangent of a damped string is that of its energy. Without damping walls
   !> get stiffer here after a step.
   pure subroutine measure(it, trajectory, forces_only, stepped, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      logical, intent(in) :: forces_only     !< without the tangent
      logical, intent(in) :: stepped         !< a step has just been taken
      real(wp) :: force, moment
      integer :: wanted
      associate (mesh => solution%mesh, loads => solution%loads, gaps => solution%gaps, work => solution%work, &
                 equations => solution%equations, state => solution%state)
         wanted = merge(energy_tangent, whole_tangent, it%damper%on)
         if (forces_only) wanted = forces_alone
         call find_tangent(equations, trajectory, mesh, loads, gaps, state, wanted, work, it%residual%nodal)
         if (it%damper%on .and. any(gaps%state /= state_free) .and. is_vertical(mesh)) &
            call hold_turn(state, it%held, equations%matrix, it%residual%nodal)
         if (it%moving%rounds > 0) call measure_followers(trajectory, mesh, loads, it%numerics%relocation, gaps, work, &
                                                   it%problem%followers)
         if (.not. forces_only) call add_place_stiffness(it%problem%followers, .true., .not. it%damper%on, equations%matrix)
         call find_largest(it%residual%nodal, force, moment)
         it%residual%unbalanced = max(force, moment)
         if (stepped .and. .not. it%damper%on) call stiffen_walls(it, it%residual%unbalanced, solution)
         call measure_contacts(mesh, loads, gaps, it%wall%soft*it%wall%growth, work, it%problem)
         call add_place_forces(it%problem%followers, it%residual%nodal)
         call add_pushes(gaps, it%residual%nodal, it%problem)
         call find_largest(it%problem%load, it%row%residual_force, it%row%residual_moment)
         it%residual%before = max(it%row%residual_force, it%row%residual_moment)
      end associate
   end subroutine measure

   !> Let rho grow after a step in which few gaps changed, and with a small residual.
   pure subroutine stiffen_walls(it, left, solution)
      type(equilibrium_type), intent(inout) :: it
      type(solution_type), intent(in) :: solution
      real(wp), intent(in) :: left           !< largest residual [N, N.m]
      associate (tuning => it%numerics%tuning)
         if (it%row%flips <= nint(tuning%few*count(solution%gaps%state /= state_free)) .and. &
             left < tuning%calm*solution%equations%force_scale) it%wall%growth = it%wall%growth*tuning%growth
         if (it%wall%growth >= tuning%stiff) it%wall%growth = rigid
      end associate
   end subroutine stiffen_walls

   !> Largest force and moment of a right-hand side.
   pure subroutine find_largest(load, force, moment)
      real(wp), contiguous, intent(in) :: load(:, :)
      real(wp), intent(out) :: force, moment
      real(wp) :: largest(6)
      call largest_of_rows(6, size(load, 2), load, largest)
      force = maxval(largest(:3))
      moment = maxval(largest(4:))
   end subroutine find_largest

   !> Hold the turn of the whole string about the axis of a vertical hole, which no force resists. A spring, as stiff as the
   !> string there, holds one node across its offset. It is the node farthest off the axis when the string first touched, and
   !> it stays the same. Otherwise two equally far nodes would alternate. The spring is in the tangent only. The force that
   !> would turn the string, some newtons from torque at the ends, is removed from the residual there.
   pure subroutine hold_turn(state, node, matrix, residual)
      real(wp), contiguous, intent(in) :: state(:, :)
      integer, intent(inout) :: node           !< the node that is held; 0: none yet
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), intent(inout) :: residual(:, :)
      real(wp) :: across(2), stiffness
      integer :: i
      if (node == 0) node = maxloc(state(dof_lateral_1, :)**2 + state(dof_lateral_2, :)**2, dim=1)
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

   !> Damping that an equilibrium of this string may need and still count as stable [-].
   pure function margin_of(solution) result(margin)
      type(solution_type), intent(in) :: solution
      real(wp) :: margin
      margin = merge(stable_twisted, stable, any(solution%mesh%friction_around > 0.0_wp) .or. abs(solution%loads%tob) > 0.0_wp)
   end function margin_of

   !> Slope of the energy along equations%step in the lateral unknowns [J]. `load` is its gradient. Axial force and torque
   !> follow from the contact forces by statics, and need no search.
   pure function energy_slope(equations, load) result(slope)
      type(equations_type), intent(in) :: equations
      real(wp), contiguous, intent(in) :: load(:, :)   !< (6,nodes) [N, N.m]
      real(wp) :: slope
      integer :: n, i
      slope = 0.0_wp
      do i = dof_lateral_1, dof_slope_2
         if (i == dof_twist) cycle
         do n = 1, size(load, 2)
            slope = slope + equations%step(i, n)*load(i, n)
         end do
      end do
   end function energy_slope

   !> Place the nodes and measure the gaps.
   pure subroutine place_and_survey(trajectory, solution)
      type(trajectory_type), intent(in) :: trajectory
      type(solution_type), intent(inout) :: solution
      call place_nodes(solution%mesh, solution%state, solution%work)
      call survey_gaps(trajectory, solution%mesh, solution%gaps, solution%work)
   end subroutine place_and_survey

   !> Restore places, contact forces and gaps before the step. Hook load, axial forces and torque stay those of the trial until
   !> the next measurement.
   pure subroutine go_back(it, trajectory, solution)
      type(equilibrium_type), intent(in) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(solution_type), intent(inout) :: solution
      solution%state = it%origin%state
      solution%work%normal = it%origin%force
      if (it%holder%holding) solution%work%held = it%holder%before
      call restore_gap_table(it%origin%gaps, solution%gaps)
      call place_and_survey(trajectory, solution)
   end subroutine go_back

   !> Judge which gaps are closed at the present state. The count of those that changed since the step began is row%flips. A
   !> gap closes when it is in the wall. It opens when it would pull, R + rho (|f| - depth(R)) < 0 with the softest rho.
   !> Both must exceed the thresholds of Eqs. 7 and 8.
   pure subroutine judge_gaps(it, trajectory, relocate, solution)
      type(equilibrium_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(solution_type), intent(inout) :: solution
      logical, intent(in) :: relocate        !< gaps may move
      real(wp) :: deep
      integer :: e, next
      associate (mesh => solution%mesh, gaps => solution%gaps, work => solution%work)
         it%row%moves = 0
         if (relocate) call move_gaps(it, trajectory, move_rule_type(most=it%numerics%tuning%gently, &
                                                                     closed=it%row%flips == 0), solution)
         it%row%flips = 0
         it%residual%flipped = 0.0_wp
         do e = 1, mesh%elements
            associate (law => gaps%law(e), force => work%normal(e))
               deep = work%displacement(e) - depth_of(law, max(force, 0.0_wp))
               next = next_state(law, gaps%thresholds, gaps%state(e), force, deep, it%wall%soft*mesh%length(e))
               if (next /= it%origin%gaps%state(e)) then
                  it%row%flips = it%row%flips + 1
                  it%residual%flipped = max(it%residual%flipped, abs(force), abs(law%contact*deep))
               end if
               if (next /= gaps%state(e)) gaps%flips(e) = gaps%flips(e) + 1
               gaps%state(e) = next
               if (next == state_free) force = 0.0_wp
            end associate
         end do
      end associate
   end subroutine judge_gaps

   !> Move gaps to where the string is deepest (Eq. 2), by a rule whose threshold is that of the deck.
   pure subroutine move_gaps(it, trajectory, rule, solution)
      type(equilibrium_type), intent(inout) :: it
      type(trajectory_type), intent(in) :: trajectory
      type(solution_type), intent(inout) :: solution
      type(move_rule_type), intent(in) :: rule
      type(move_rule_type) :: ours
      it%row%moves = 0
      ours = rule
      ours%threshold = it%numerics%relocation
      if (it%numerics%gap_location == gap_at_extremum) &
         call relocate_gaps(trajectory, solution%mesh, ours, solution%gaps, solution%work, it%row%moves)
   end subroutine move_gaps
end module dg_iteration_state
