!> The model of the paper for one load case: from deck data to a result. The only door of this room.
module dg_static_analysis
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_assembly, only: load_type
   use dg_block_matrix, only: new_block_matrix
   use dg_case_result, only: case_result_type, iteration_type, result_converged, result_not_converged
   use dg_error, only: error_type
   use dg_gap_state, only: gap_law_type
   use dg_gap_table, only: count_states, gap_table_type, new_gap_table
   use dg_job, only: model_mcge
   use dg_load_case, only: load_case_type
   use dg_linear_solver, only: new_linear_solver
   use dg_mesh, only: mesh_type
   use dg_mesh_for_case, only: mesh_for_case
   use dg_model, only: model_type
   use dg_newton, only: iterate, newton_converged, newton_exhausted, newton_singular, newton_type
   use dg_numerics, only: gap_at_nodes
   use dg_predictor, only: predict
   use dg_recovery, only: buoyed_axial_weight, check_equilibrium, recover_profile
   use dg_trajectory, only: inclination_of, position_at
   use dg_workspace, only: new_workspace, workspace_type
   implicit none
   private
   public :: solve_static_analysis

   !> Support springs at centred ends over the wall's greatest stiffness per metre [m]: stiff enough to hold the
   !> string within micrometres of the axis, not so stiff as to spoil the matrix.
   real(wp), parameter :: support_length = 1.0_wp
   !> The softest wall yields to the string's weight by this part of the clearance [-]: as soft as beams of some metres
   !> are between two contacts, so that no single gap matters.
   real(wp), parameter :: soft_penetration = 0.1_wp
   !> Largest ratio of stiffness from one stage to the next [-]: 30 to 100 cost the same, more loses cases.
   real(wp), parameter :: largest_stiffening = 50.0_wp
   !> Residual over weight at which a stage before the last is left [-].
   real(wp), parameter :: stage_tolerance = 1.0e-3_wp
   !> Where gaps sit at first: mid-element for the paper's x0, the lower node for fixed points.
   real(wp), parameter :: middle = 0.5_wp
   real(wp), parameter :: lower_node = 1.0_wp

contains

   !> Solves one load case by beams with contact gap elements. A case that does not converge is a result with its
   !> reason, no error; `error` stands for what prevents any result.
   subroutine solve_static_analysis(model, case_index, result, error)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(newton_type) :: newton
      type(workspace_type) :: work
      type(load_type) :: loads
      real(wp), allocatable :: state(:, :)
      real(wp) :: fraction, tolerance
      real(wp), allocatable :: walls(:)
      integer(int64) :: ticks, start, rate
      logical :: may_buckle
      integer :: increment, stage, outcome
      call system_clock(start, rate)
      associate (load_case => model%cases(case_index))
         call mesh_for_case(model, case_index, model%numerics%element_length, mesh, may_buckle)
         call prepare(model, load_case, mesh, gaps, newton, work)
         newton%stabilise = may_buckle
         if (may_buckle) newton%conservative = new_block_matrix(mesh%nodes)
         allocate (state(6, mesh%nodes))
         call stage_walls(model, mesh, walls)
         do increment = 1, model%numerics%load_steps
            fraction = real(increment, wp)/model%numerics%load_steps
            call set_loads(model, load_case, fraction, loads)
            do stage = merge(1, size(walls), increment == 1), size(walls)
               call set_walls(model, mesh, walls(stage), gaps)
               if (increment == 1 .and. stage == 1) &
                  call predict(model, case_index, mesh, fraction, fraction, walls(1)*mesh%wall, state, gaps)
               tolerance = merge(model%numerics%tolerance, max(model%numerics%tolerance, stage_tolerance), stage == size(walls))
               call iterate(newton, model%trajectory, mesh, loads, model%numerics, tolerance, increment, gaps, state, work, outcome)
               if (outcome /= newton_converged) exit
            end do
            if (outcome /= newton_converged) exit
         end do
         call fill_result(model, case_index, mesh, gaps, newton, loads, outcome, work, result)
      end associate
      call system_clock(ticks)
      result%seconds = real(ticks - start, wp)/real(rate, wp)
   end subroutine solve_static_analysis

   !> Wall stiffnesses to go through over the final one [-], ending in 1. A stiff wall is a hard start: every gap that
   !> opens or closes throws its neighbours about, and a span that overshoots is thrown back with thousands of kN. Against
   !> a soft wall, which the string's weight presses in by a visible part of the clearance, the problem is smooth; each
   !> stiffer wall then starts from the state before.
   pure subroutine stage_walls(model, mesh, walls)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      real(wp), allocatable, intent(out) :: walls(:)
      real(wp) :: soft, stiff, ratio
      integer :: stages, i
      soft = maxval(mesh%weight/mesh%clearance)/soft_penetration
      stiff = maxval(mesh%wall)
      stages = 1
      if (soft > 0.0_wp .and. model%numerics%soften) stages = 1 + ceiling(log(max(stiff/soft, 1.0_wp))/log(largest_stiffening))
      allocate (walls(stages), source=1.0_wp)
      if (stages == 1) return
      ratio = (soft/stiff)**(1.0_wp/(stages - 1))
      do i = 1, stages - 1
         walls(i) = ratio**(stages - i)
      end do
   end subroutine stage_walls

   !> Gives every gap its wall, `scale` times the final stiffness.
   pure subroutine set_walls(model, mesh, scale, gaps)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: scale
      type(gap_table_type), intent(inout) :: gaps
      gaps%law%contact = scale*mesh%wall*mesh%length
      gaps%law%maximum = scale*max(model%numerics%gk_max, mesh%wall)*mesh%length
   end subroutine set_walls

   !> Room for the solution, the gaps' laws and the iteration's scales.
   subroutine prepare(model, load_case, mesh, gaps, newton, work)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(out) :: gaps
      type(newton_type), intent(out) :: newton
      type(workspace_type), intent(out) :: work
      type(gap_law_type), allocatable :: laws(:)
      integer :: e
      associate (numerics => model%numerics)
         allocate (laws(mesh%elements))
         do e = 1, mesh%elements
            laws(e) = gap_law_type(clearance=mesh%clearance(e), minimum=numerics%gk_min*mesh%length(e), &
               contact=mesh%wall(e)*mesh%length(e), maximum=max(numerics%gk_max, mesh%wall(e))*mesh%length(e), &
               eps_n0=numerics%eps_n0, eps_nmax=mesh%eps_nmax(e), r_n0=numerics%r_n0)
         end do
         gaps = new_gap_table(laws, merge(lower_node, middle, numerics%gap_location == gap_at_nodes))
         call new_workspace(mesh, work)
         newton%matrix = new_block_matrix(mesh%nodes)
         call new_linear_solver(numerics%linear_solver, mesh%nodes, newton%solver)
         allocate (newton%residual(6, mesh%nodes), newton%step(6, mesh%nodes), source=0.0_wp)
         allocate (newton%lump(6, mesh%nodes), source=0.0_wp)
         allocate (newton%history(numerics%max_iterations + 1))
         newton%force_scale = sum(mesh%weight*mesh%length) + abs(load_case%wob)
         newton%step_limit = numerics%step_limit*maxval(mesh%clearance)
         newton%viscous_limit = numerics%viscous_limit*maxval(mesh%clearance)
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

   !> The result of the last state, converged or not.
   subroutine fill_result(model, case_index, mesh, gaps, newton, loads, outcome, work, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(newton_type), intent(in) :: newton
      type(load_type), intent(in) :: loads
      integer, intent(in) :: outcome
      type(workspace_type), intent(in) :: work
      type(case_result_type), intent(out) :: result
      type(iteration_type) :: last
      real(wp) :: position(3), tangent(3)
      character(200) :: text
      result%case_index = case_index
      result%model = model_mcge
      last = newton%history(newton%iterations + 1)
      result%message = ''
      select case (outcome)
      case (newton_converged)
         result%status = result_converged
      case (newton_exhausted)
         result%status = result_not_converged
         write (text, '(a,i0,a,es9.2,a,i0,a)') 'iterations used up in load step ', last%increment, ': residual ', &
            last%residual_force, ' N, ', last%flips, ' gaps still changing; try shorter elements, more max_iterations or load_steps'
         result%message = trim(text)
      case default
         result%status = result_not_converged
         write (text, '(a,i0,a)') 'no unique equilibrium at iteration ', last%iteration, &
            ': the string can move freely somewhere; check supports and loads, or try more load_steps'
         result%message = trim(text)
      end select
      call position_at(model%trajectory, mesh%md(mesh%nodes), position, tangent)
      result%inclination = inclination_of(tangent)
      result%hookload = work%hookload
      result%friction = buoyed_axial_weight(mesh) - loads%wob - work%hookload
      result%torque = work%top_torque
      result%normal_force = sum(work%normal)
      result%iterations = newton%iterations
      result%elements = mesh%elements
      result%states = count_states(gaps)
      result%flips = sum(gaps%flips)
      result%moves = sum(gaps%moves)
      call recover_profile(model%trajectory, mesh, gaps, work, result%profile)
      call check_equilibrium(model%trajectory, mesh, loads, work, result%equilibrium_force, result%equilibrium_moment)
      result%history = newton%history(:newton%iterations + 1)
   end subroutine fill_result
end module dg_static_analysis
