!> Newton-Raphson iteration of one load increment (after Eq. 12): solve, re-judge the states and places of the
!> gaps in the same iteration, repeat until residual, states and places are all at rest.
!>
!> Where the string is compressed the tangent may be indefinite and Newton's step leads uphill. A viscous term on the
!> lateral unknowns (pseudo-transient continuation) is then raised until the tangent without friction and torque,
!> which is the second derivative of an energy, is positive definite, and lowered again as soon as that allows.
!> It acts on steps, not on the residual: the converged string feels nothing of it.
module dg_newton
   use dg_kinds, only: wp
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, block_size
   use dg_block_solver, only: block_positive_definite
   use dg_case_result, only: iteration_type
   use dg_gap_survey, only: relocate_gaps, survey_gaps
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type, judge_states
   use dg_linear_solver, only: linear_solver_type, solve_linear
   use dg_mesh, only: mesh_type
   use dg_numerics, only: gap_at_extremum, numerics_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, place_nodes, workspace_type
   implicit none
   private
   public :: newton_type, iterate, newton_converged, newton_exhausted, newton_singular

   integer, parameter :: newton_converged = 0
   integer, parameter :: newton_exhausted = 1   !< iterations used up
   integer, parameter :: newton_singular = 2    !< no unique solution, or numbers out of range

   !> Viscosity is counted in units of F^2/(4 EI) of the place [-]: the most by which an axial compression F can make a
   !> beam's lateral stiffness negative, EI v'''' + F v'' + F^2/(4 EI) v being never so. One is therefore enough where the
   !> string is uniform; each zone gets what it needs, and weakly compressed ones grow as fast as others.
   real(wp), parameter :: viscosity_least = 0.1_wp
   real(wp), parameter :: viscosity_growth = 1.5_wp
   real(wp), parameter :: viscosity_decay = 0.4_wp
   real(wp), parameter :: viscosity_most = 1.0e9_wp
   !> Viscosity on a slope over that of a lateral unknown times length squared: 4/420 of the consistent matrix of a
   !> cubic element, rounded.
   real(wp), parameter :: slope_lump = 0.01_wp
   !> What every place gets of the largest F^2/(4 EI) [-], lest something else than compression be unstable.
   real(wp), parameter :: viscosity_everywhere = 1.0e-4_wp
   !> Against the final wall gaps stay where the softer walls left them until all is at rest; then each may move to the
   !> extremum of its element, and the iteration goes on, no more than so many times.
   integer, parameter :: most_rounds = 4
   !> Largest change of a slope in one iteration [rad]: a tenth of what directors could bear.
   real(wp), parameter :: largest_turn = 0.1_wp
   !> A growing mode is drawn out to this part of the clearance [-], by no more than this factor, when the residual over
   !> the weight is below this [-].
   real(wp), parameter :: mode_growth = 0.25_wp
   real(wp), parameter :: most_drawn = 1.0e3_wp
   real(wp), parameter :: mode_residual = 1.0e-3_wp
   !> Iterations in a row with gaps changing after which they are taken to be cycling.
   integer, parameter :: patience = 8

   !> Room and settings of an iteration, made once a case.
   type :: newton_type
      type(block_matrix_type) :: matrix
      type(block_matrix_type) :: conservative
      type(linear_solver_type) :: solver
      real(wp), allocatable :: residual(:, :)     !< (6,nodes)
      real(wp), allocatable :: step(:, :)         !< (6,nodes)
      real(wp), allocatable :: lump(:, :)         !< what a unit of viscosity adds to the diagonal (6,nodes)
      logical :: stabilise = .false.              !< watch definiteness: the string is compressed somewhere
      real(wp) :: viscosity = 0.0_wp              !< present, in units of F^2/(4 EI) [-]
      real(wp) :: force_scale = 1.0_wp            !< residuals are compared with this [N]
      real(wp) :: step_limit = 0.0_wp             !< largest lateral change in one iteration [m]
      real(wp) :: viscous_limit = 0.0_wp          !< the same while viscosity acts [m]
      type(iteration_type), allocatable :: history(:)
      integer :: iterations = 0                   !< in all increments so far
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
      logical :: stable
      integer :: info, stalled, rounds
      row%increment = increment
      stalled = 0
      call judge(trajectory, mesh, numerics, soft, row%flips == 0, state, gaps, work, row)
      rounds = 0
      do
         call assemble(trajectory, mesh, loads, gaps, state, .false., work, newton%residual, newton%matrix)
         row%residual_force = maxval(abs(newton%residual(1:3, :)))
         row%residual_moment = maxval(abs(newton%residual(4:6, :)))
         row%hookload = work%hookload
         row%contacts = count(gaps%state /= state_free)
         row%iteration = newton%iterations
         newton%history(newton%iterations + 1) = row
         if (max(row%residual_force, row%residual_moment) <= tolerance*newton%force_scale .and. &
             (row%flips == 0 .or. soft)) then
            stable = .true.
            if (newton%stabilise) call check_stability(newton, trajectory, mesh, loads, gaps, state, work, stable)
            if (stable .and. .not. soft .and. rounds < most_rounds) then
               rounds = rounds + 1
               call judge(trajectory, mesh, numerics, .true., .true., state, gaps, work, row)
               if (row%moves > 0 .or. row%flips > 0) cycle
            end if
            if (stable) then
               outcome = newton_converged
               return
            end if
         end if
         stalled = merge(stalled + 1, 0, row%flips > 0)
         if (newton%iterations >= numerics%max_iterations) then
            outcome = newton_exhausted
            return
         end if
         if (newton%stabilise) call choose_viscosity(newton, trajectory, mesh, loads, gaps, state, work)
         row%viscosity = newton%viscosity
         call add_lateral(newton, mesh, numerics%gk_min)
         newton%step = -newton%residual
         call solve_linear(newton%solver, newton%matrix, newton%step, info)
         if (info /= 0) then
            outcome = newton_singular
            return
         end if
         row%lateral_step = maxval(abs(newton%step(dof_lateral_1:dof_lateral_2, :)))
         if (.not. row%lateral_step < huge(row%lateral_step)) then
            outcome = newton_singular
            return
         end if
         state = state + newton%step*step_share(newton, row, stalled)
         newton%iterations = newton%iterations + 1
         call judge(trajectory, mesh, numerics, soft, row%flips == 0, state, gaps, work, row)
      end do
   end subroutine iterate

   !> Share of the full step to take. Lateral changes stay within the limit, and slopes within what they are good for.
   !> Near an unstable equilibrium, all at rest but held by viscosity, the step is the mode that grows, only small: it
   !> is drawn out to a visible part of the clearance. Where gaps have taken turns for long, half steps break the cycle.
   pure function step_share(newton, row, stalled) result(share)
      type(newton_type), intent(in) :: newton
      type(iteration_type), intent(in) :: row
      integer, intent(in) :: stalled        !< iterations in a row with gaps changing
      real(wp) :: share
      real(wp) :: lateral, slope, limit, goal
      logical :: held
      held = newton%viscosity > 0.0_wp
      limit = merge(newton%viscous_limit, newton%step_limit, held)
      lateral = row%lateral_step/limit
      slope = maxval(abs(newton%step(dof_slope_1:dof_slope_2, :)))/largest_turn
      share = 1.0_wp/max(1.0_wp, lateral, slope)
      goal = mode_growth*newton%viscous_limit
      if (held .and. row%flips == 0 .and. row%moves == 0 .and. row%lateral_step < goal .and. &
          row%residual_force < mode_residual*newton%force_scale) then
         share = min(goal/max(row%lateral_step, goal/most_drawn), 1.0_wp/max(slope, tiny(1.0_wp)))
      else if (stalled > patience) then
         share = 0.5_wp*share
      end if
   end function step_share

   !> Places the nodes of `state`, measures the gaps, moves them to the extremum where asked for, and re-judges them;
   !> `row` counts what changed.
   subroutine judge(trajectory, mesh, numerics, relocate, closed, state, gaps, work, row)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(numerics_type), intent(in) :: numerics
      logical, intent(in) :: relocate    !< gaps may move
      logical, intent(in) :: closed      !< closed ones too
      real(wp), intent(in) :: state(:, :)
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work
      type(iteration_type), intent(inout) :: row
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
      row%moves = 0
      if (relocate .and. numerics%gap_location == gap_at_extremum) &
         call relocate_gaps(trajectory, mesh, numerics%relocation, closed, gaps, work, row%moves)
      call judge_states(gaps, work%displacement, row%flips)
   end subroutine judge

   !> Whether the present equilibrium is stable: the conservative tangent without viscosity is positive definite.
   subroutine check_stability(newton, trajectory, mesh, loads, gaps, state, work, stable)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical, intent(out) :: stable
      call assemble(trajectory, mesh, loads, gaps, state, .true., work, newton%step, newton%conservative)
      call block_positive_definite(newton%conservative, 0.0_wp, newton%lump, stable)
   end subroutine check_stability

   !> Viscosity for the present iteration: lowered a step, then raised until the conservative tangent with it is
   !> positive definite.
   subroutine choose_viscosity(newton, trajectory, mesh, loads, gaps, state, work)
      type(newton_type), intent(inout) :: newton
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      logical :: definite
      call assemble(trajectory, mesh, loads, gaps, state, .true., work, newton%step, newton%conservative)
      call weigh(mesh, work, newton%lump)
      newton%viscosity = newton%viscosity*viscosity_decay
      if (newton%viscosity < viscosity_least) newton%viscosity = 0.0_wp
      do
         call block_positive_definite(newton%conservative, newton%viscosity, newton%lump, definite)
         if (definite .or. newton%viscosity > viscosity_most) return
         newton%viscosity = max(newton%viscosity*viscosity_growth, viscosity_least)
      end do
   end subroutine choose_viscosity

   !> What a unit of viscosity adds to the diagonal: F^2/(4 EI) of the place times the node's length for lateral unknowns,
   !> times a part of its cube for slopes, as the consistent matrix of a line load has it, so that no pattern of slopes
   !> escapes.
   pure subroutine weigh(mesh, work, lump)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(inout) :: lump(:, :)
      real(wp) :: least, force, lateral, slope
      integer :: e
      least = viscosity_everywhere*maxval(min(work%axial, 0.0_wp)**2/(4.0_wp*mesh%ei))
      lump = 0.0_wp
      do e = 1, mesh%elements
         force = max(min(work%axial(e), 0.0_wp)**2/(4.0_wp*mesh%ei(e)), least)
         lateral = 0.5_wp*force*mesh%length(e)
         slope = slope_lump*force*mesh%length(e)**3
         lump(dof_lateral_1:dof_lateral_2, e:e + 1) = lump(dof_lateral_1:dof_lateral_2, e:e + 1) + lateral
         lump(dof_slope_1:dof_slope_2, e:e + 1) = lump(dof_slope_1:dof_slope_2, e:e + 1) + slope
      end do
   end subroutine weigh

   !> Adds the viscosity, and the rigidity gk_min of the gaps [N/m2], to the lateral unknowns.
   pure subroutine add_lateral(newton, mesh, gk_min)
      type(newton_type), intent(inout) :: newton
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: gk_min
      integer :: n, i, e
      do n = 1, mesh%nodes
         do i = 1, block_size
            newton%matrix%diagonal(i, i, n) = newton%matrix%diagonal(i, i, n) + newton%viscosity*newton%lump(i, n)
         end do
      end do
      do e = 1, mesh%elements
         do n = e, e + 1
            do i = dof_lateral_1, dof_lateral_2
               newton%matrix%diagonal(i, i, n) = newton%matrix%diagonal(i, i, n) + 0.5_wp*gk_min*mesh%length(e)
            end do
         end do
      end do
   end subroutine add_lateral
end module dg_newton
