!> Newton-Raphson iteration of one load increment (after Eq. 12): solve, re-judge the states and places of the
!> gaps in the same iteration, repeat until residual, states and places are all at rest.
!>
!> A compressed string may come to rest where it cannot stay, or not at all: then it is for dg_damped_newton.
module dg_newton
   use dg_kinds, only: wp
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, block_size, new_block_matrix, plane_block_size
   use dg_carried_force, only: carry_contact_forces
   use dg_case_result, only: iteration_type
   use dg_gap_survey, only: relocate_gaps, survey_gaps
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type, judge_states, keep_gaps, open_pulling, take_gaps_back
   use dg_interruption, only: is_interrupted
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solve_linear
   use dg_mesh, only: mesh_type
   use dg_numerics, only: gap_at_extremum, numerics_type
   use dg_plane, only: move_in_plane, plane_type, row_lateral, row_slope
   use dg_plane_assembly, only: assemble_in_plane
   use dg_release_front, only: forget_fronts, release_ahead, release_front_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, make_room_for_recovery, nothing_carried, &
                           place_nodes, workspace_type
   implicit none
   private
   public :: newton_type, iterate, make_room, end_iterations, judge, judge_surveyed, take_residual, largest, add_gap_rigidity
   public :: most_pulled, most_rounds, longest_round, largest_turn
   public :: newton_converged, newton_exhausted, newton_singular

   integer, parameter :: newton_converged = 0
   integer, parameter :: newton_exhausted = 1   !< iterations used up
   integer, parameter :: newton_singular = 2    !< no unique solution, or numbers out of range

   !> Against the final wall gaps stay where the softer walls left them until all is at rest; then each may move to the
   !> extremum of its element, and the iteration goes on, no more than so many times.
   integer, parameter :: most_rounds = 4
   !> What walls may pull with in all, over the weight [-]: the usual r_n0 in 10 000 gaps. Gaps that pull with more are opened.
   real(wp), parameter :: most_pulled = 1.0e-5_wp
   !> Iterations after which a string whose gaps have moved is given up and taken back to its rest before.
   integer, parameter :: longest_round = 25
   !> Largest change of a slope in one iteration [rad]: a tenth of what directors could bear.
   real(wp), parameter :: largest_turn = 0.1_wp
   !> Iterations in a row with gaps changing after which they are taken to be cycling.
   integer, parameter :: patience = 8

   !> A string that after so many iterations is out of balance by so many times the residual at the start does not come back.
   integer, parameter :: longest_stray = 15
   real(wp), parameter :: lost = 100.0_wp

   !> Residuals over the tolerance from which the next one is expected to be within it [-]: Newton's last step squares what
   !> is left; while gaps still change it gains less. On the sample wells the next one was so for 19 in 20 of those between a tenth
   !> of the first and itself, and for none above; for a third of those up to the second with gaps changing.
   real(wp), parameter :: near_rest = 1.0e6_wp, near_soft = 80.0_wp

   !> Room and settings of an iteration, made once a case.
   type :: newton_type
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: solver
      real(wp), allocatable :: residual(:, :)     !< (6,nodes), or in a plane (3,nodes)
      real(wp), allocatable :: step(:, :)         !< the same
      logical :: compressed = .false.             !< so that the string may not stay where it is at rest
      logical :: planar = .false.                 !< only what moves the string in its plane is solved for
      type(plane_type) :: plane
      integer :: forces = 3                       !< rows of residual and step: forces come first, then moments
      integer :: laterals(2) = [dof_lateral_1, dof_lateral_2]   !< from the one to the other
      integer :: slopes(2) = [dof_slope_1, dof_slope_2]
      type(release_front_type) :: front           !< of release
      real(wp) :: force_scale = 1.0_wp            !< residuals are compared with this [N]
      real(wp) :: step_limit = 0.0_wp             !< largest lateral change in one iteration [m]
      real(wp) :: wild_step = huge(1.0_wp)        !< one that ends the iteration [m]
      type(iteration_type), allocatable :: history(:)
      integer :: iterations = 0                   !< in all increments so far
      real(wp), allocatable :: rest(:, :)         !< the last rest against the final wall, before gaps moved
      type(gap_table_type) :: gaps_at_rest
      logical :: gaps_taken_back = .false.        !< moved gaps found no rest: they are where they were
   end type newton_type

contains

   !> Iterates `state` to equilibrium under `loads`. `outcome` is one of the numbers above.
   subroutine iterate(newton, trajectory, mesh, loads, numerics, tolerance, soft, increment, gaps, state, work, outcome)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: tolerance          !< of the residual over the force scale [-]
      logical, intent(in) :: soft                !< a stage before the last: gaps may move at once, and need not be at rest
      integer, intent(in) :: increment
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      integer, intent(out) :: outcome
      type(iteration_type) :: row
      integer :: info, stalled, rounds, round_start, start, opened
      real(wp) :: first
      logical :: near, strays
      row%increment = increment
      stalled = 0
      call forget_fronts(newton%front)
      call judge(trajectory, mesh, numerics, soft, row%flips == 0, .false., state, gaps, work, row)
      rounds = 0
      round_start = 0
      start = newton%iterations
      first = huge(first)
      do
         ! Where the end is near forces alone tell whether this is it: the tangent of a state at rest would not be used.
         near = row%iteration > 0 .and. (soft .or. row%flips + row%moves == 0) .and. &
                largest(row) <= merge(near_rest, near_soft, row%flips + row%moves == 0)*tolerance*newton%force_scale
         if (near) then
            call find_residual(newton, trajectory, mesh, loads, gaps, state, .true., work)
            call take_residual(newton, row)
         end if
         if (.not. (near .and. largest(row) <= tolerance*newton%force_scale)) then
            call find_residual(newton, trajectory, mesh, loads, gaps, state, .false., work)
            call take_residual(newton, row)
         end if
         row%hookload = work%hookload
         row%contacts = count(gaps%state /= state_free)
         row%iteration = newton%iterations
         newton%history(newton%iterations + 1) = row
         if (largest(row) <= tolerance*newton%force_scale .and. (row%flips == 0 .or. soft)) then
            if (soft .or. rounds >= most_rounds) then
               outcome = newton_converged
               return
            end if
            rounds = rounds + 1
            call keep_gaps(gaps, newton%gaps_at_rest)
            round_start = newton%iterations
            if (-sum(min(work%normal, 0.0_wp)) > most_pulled*newton%force_scale) then
               newton%rest = state
               call open_pulling(gaps, work%normal, row%flips)
               cycle
            end if
            call judge(trajectory, mesh, numerics, .true., .true., loads%bit_support > 0.0_wp, state, gaps, work, row)
            if (row%moves > 0 .or. row%flips > 0) then
               newton%rest = state
               cycle
            end if
            outcome = newton_converged
            return
         end if
         stalled = merge(stalled + 1, 0, row%flips > 0)
         if (newton%iterations == start) first = largest(row)
         strays = newton%iterations >= start + longest_stray .and. largest(row) > lost*first
         if (rounds > 0 .and. (newton%iterations >= round_start + longest_round .or. (strays .and. rounds < most_rounds))) then
            call take_back()
            cycle
         end if
         if (newton%iterations >= numerics%max_iterations .or. is_interrupted() .or. strays) then
            outcome = newton_exhausted
            return
         end if
         call add_gap_rigidity(mesh, numerics%gk_min, newton%matrix, newton%laterals)
         call solve_linear(newton%solver, newton%matrix, newton%residual, newton%step, info)
         if (info == 0) row%negative_pivots = newton%solver%negative_pivots
         row%lateral_step = maxval(abs(newton%step(newton%laterals(1):newton%laterals(2), :)))
         if (info /= 0 .or. .not. row%lateral_step < huge(row%lateral_step)) then
            if (rounds > 0) then
               call take_back()
               cycle
            end if
            outcome = newton_singular
            return
         end if
         if (row%lateral_step > newton%wild_step) then
            outcome = newton_exhausted
            return
         end if
         call take_step(newton, mesh, gaps, step_share(newton, row, stalled), state, work)
         newton%iterations = newton%iterations + 1
         newton%front%before = gaps%state
         call judge(trajectory, mesh, numerics, soft, row%flips == 0, .false., state, gaps, work, row)
         call release_ahead(newton%front, row%flips, gaps, opened)
         row%flips = row%flips + opened
      end do

   contains

      !> Back to the rest before the gaps moved, which then is the end.
      subroutine take_back()
         state = newton%rest
         work%carried = nothing_carried
         call take_gaps_back(newton%gaps_at_rest, gaps)
         newton%gaps_taken_back = .true.
         rounds = most_rounds
         stalled = 0
         call judge(trajectory, mesh, numerics, .false., .false., .false., state, gaps, work, row)
      end subroutine take_back
   end subroutine iterate

   !> Room for the equations of a mesh, in space or in the plane that `newton` names.
   pure subroutine make_room(newton, kind, nodes, planar)
      type(newton_type), intent(inout) :: newton
      integer, intent(in) :: kind          !< of linear solver
      integer, intent(in) :: nodes
      logical, intent(in) :: planar
      integer :: unknowns
      newton%planar = planar
      unknowns = merge(plane_block_size, block_size, planar)
      newton%forces = (unknowns + 1)/2
      newton%laterals = merge([row_lateral, row_lateral], [dof_lateral_1, dof_lateral_2], planar)
      newton%slopes = merge([row_slope, row_slope], [dof_slope_1, dof_slope_2], planar)
      newton%matrix = new_block_matrix(nodes, unknowns)
      call new_linear_solver(kind, nodes, newton%solver, unknowns)
      allocate (newton%residual(unknowns, nodes), newton%step(unknowns, nodes), source=0.0_wp)
   end subroutine make_room

   !> Residual and, unless forces alone are wanted, tangent.
   pure subroutine find_residual(newton, trajectory, mesh, loads, gaps, state, forces_only, work)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      logical, intent(in) :: forces_only
      type(workspace_type), intent(inout) :: work
      if (newton%planar) then
         call assemble_in_plane(trajectory, mesh, newton%plane, loads, gaps, state, forces_only, work, newton%residual, &
                                newton%matrix)
      else
         call assemble(trajectory, mesh, loads, gaps, state, .false., work, newton%residual, newton%matrix, forces_only)
      end if
   end subroutine find_residual

   !> state <- state + share step.
   pure subroutine take_step(newton, mesh, gaps, share, state, work)
      type(newton_type), intent(inout) :: newton
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: share
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work   !< placed and surveyed at `state`
      if (newton%planar) then
         call move_in_plane(newton%plane, newton%step, share, state)
      else
         newton%step = newton%step*share
         call carry_contact_forces(mesh, gaps, state, newton%step, work)
         state = state + newton%step
      end if
   end subroutine take_step

   !> Gives back what only iterations need, half of a solution's memory, and in the room fills in what the result tells beside, in
   !> space wherever the string was solved.
   pure subroutine end_iterations(newton, trajectory, mesh, loads, gaps, state, work, largest_residual)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out), optional :: largest_residual   !< force or moment out of balance [N, N.m]
      newton%matrix = block_matrix_type()
      newton%solver = linear_solver_type()
      deallocate (newton%residual, newton%step)
      allocate (newton%residual(block_size, mesh%nodes))
      call make_room_for_recovery(mesh, work)
      call assemble(trajectory, mesh, loads, gaps, state, .false., work, newton%residual, newton%matrix, forces_only=.true.)
      if (present(largest_residual)) largest_residual = maxval(abs(newton%residual))
      deallocate (newton%residual)
   end subroutine end_iterations

   !> Puts the largest force and moment out of balance into a row of the history.
   pure subroutine take_residual(newton, row)
      type(newton_type), intent(in) :: newton
      type(iteration_type), intent(inout) :: row
      row%residual_force = maxval(abs(newton%residual(:newton%forces, :)))
      row%residual_moment = maxval(abs(newton%residual(newton%forces + 1:, :)))
   end subroutine take_residual

   !> The larger of both [N, N.m].
   elemental function largest(row) result(residual)
      type(iteration_type), intent(in) :: row
      real(wp) :: residual
      residual = max(row%residual_force, row%residual_moment)
   end function largest

   !> Share of the full step to take: lateral changes stay within the limit, and slopes within what they are good for.
   !> Where gaps have taken turns for long, half steps break the cycle.
   pure function step_share(newton, row, stalled) result(share)
      type(newton_type), intent(in) :: newton
      type(iteration_type), intent(in) :: row
      integer, intent(in) :: stalled        !< iterations in a row with gaps changing
      real(wp) :: share
      share = 1.0_wp/max(1.0_wp, row%lateral_step/newton%step_limit, &
                         maxval(abs(newton%step(newton%slopes(1):newton%slopes(2), :)))/largest_turn)
      if (stalled > patience) share = 0.5_wp*share
   end function step_share

   !> Places the nodes of `state`, measures the gaps, moves them to the extremum where asked for, and re-judges them;
   !> `row` counts what changed.
   subroutine judge(trajectory, mesh, numerics, relocate, closed, closely, state, gaps, work, row)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(numerics_type), intent(in) :: numerics
      logical, intent(in) :: relocate    !< gaps may move
      logical, intent(in) :: closed      !< closed ones too
      logical, intent(in) :: closely     !< those next to the bit by penetration
      real(wp), intent(in) :: state(:, :)
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      type(iteration_type), intent(inout) :: row
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
      call judge_surveyed(trajectory, mesh, numerics, relocate, closed, closely, gaps, work, row)
   end subroutine judge

   !> The same where nodes are placed and gaps measured already.
   pure subroutine judge_surveyed(trajectory, mesh, numerics, relocate, closed, closely, gaps, work, row)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(numerics_type), intent(in) :: numerics
      logical, intent(in) :: relocate, closed, closely
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      type(iteration_type), intent(inout) :: row
      row%moves = 0
      if (relocate .and. numerics%gap_location == gap_at_extremum) &
         call relocate_gaps(trajectory, mesh, numerics%relocation, closed, closely, gaps, work, row%moves)
      call judge_states(gaps, work%displacement, row%flips)
   end subroutine judge_surveyed

   !> Adds the rigidity gk_min of the gaps [N/m2] to the lateral unknowns, from the first to the second of `rows`.
   pure subroutine add_gap_rigidity(mesh, gk_min, matrix, rows)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: gk_min
      type(block_matrix_type), intent(inout) :: matrix
      integer, intent(in) :: rows(2)
      integer :: n, i, e
      do e = 1, mesh%elements
         do n = e, e + 1
            do i = rows(1), rows(2)
               matrix%diagonal(i, i, n) = matrix%diagonal(i, i, n) + 0.5_wp*gk_min*mesh%length(e)
            end do
         end do
      end do
   end subroutine add_gap_rigidity
end module dg_newton
