!> A string that turns about the axis of a vertical hole: its step, its phase, its contacts, and what it takes to find it.
module dg_test_whirling
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, &
                    TestSuite
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, block_product, new_block_matrix
   use dg_case_result, only: case_result_type, result_converged
   use dg_constants, only: pi
   use dg_error, only: error_type
   use dg_gap_depths, only: close_gently, depths_after, depths_type, keep_forces, new_depths, put_gaps
   use dg_gap_state, only: gap_law_type, state_elastic, state_free
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solver_block
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_static
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: new_well, note, pipe
   use dg_turning_step, only: phase_type, solve_turning, take_off_drive, turn_to_rest, turning_mode
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: whirling_suite

   real(wp), parameter :: length = 60.0_wp, od = 0.127_wp, id = 0.1086_wp, hole = 0.2159_wp
   integer, parameter :: elements = 8

contains

   function whirling_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('whirling')
      call suite%addTest(TestMethod('step', test_step))
      call suite%addTest(TestMethod('phase', test_phase))
      call suite%addTest(TestMethod('depths', test_depths))
      call suite%addTest(TestMethod('forces', test_forces))
      call suite%addTest(TestMethod('drive', test_drive))
      call suite%addTest(TestMethod('iterations', test_iterations))
   end function whirling_suite

   !> The step p solves (K - lambda M J) p - dlambda M m = -r for one dlambda, and does not turn: M m.p = 0. K is any regular
   !> matrix of a chain, with J d = m; seen 2e-13.
   subroutine test_step()
      integer, parameter :: nodes = 5
      real(wp), parameter :: exact = 1.0e-10_wp
      type(block_matrix_type) :: matrix, stiffness
      type(linear_solver_type) :: linear
      real(wp) :: state(6, nodes), lump(6, nodes), mode(6, nodes), residual(6, nodes), room(6, nodes), step(6, nodes)
      real(wp) :: left(6, nodes), drive, pull, part
      integer :: n, i, j, info
      stiffness = new_block_matrix(nodes)
      lump = 0.0_wp
      do n = 1, nodes
         do j = 1, 6
            state(j, n) = sin(real(3*n + 5*j, wp))
            residual(j, n) = cos(real(7*n + 2*j, wp))
            do i = 1, 6
               stiffness%diagonal(i, j, n) = sin(real(i + 2*j + 3*n, wp)) + merge(9.0_wp, 0.0_wp, i == j)
               if (n == nodes) cycle
               stiffness%upper(i, j, n) = 0.5_wp*sin(real(2*i - j + n, wp))
               stiffness%lower(i, j, n) = 0.5_wp*cos(real(i + j - n, wp))
            end do
         end do
         lump(2:3, n) = 1.0_wp + 0.1_wp*n
         lump(5:6, n) = 0.3_wp
      end do
      mode = 0.0_wp
      call turning_mode(state, mode)
      call take_off_drive(lump, mode, residual, drive, pull)
      call assertLessThan(abs(sum(mode*residual)), exact, message='the drive is off')
      call assertGreaterThan(drive, 0.01_wp, message='there was one')
      matrix = stiffness
      call new_linear_solver(solver_block, nodes, linear)
      call solve_turning(linear, lump, mode, pull, residual, matrix, room, step, info)
      call assertEqual(0, info)
      call assertLessThan(abs(sum(lump*mode*step)), exact, message='does not turn')
      ! a turn may have been taken off the solution: the held node's part of it is put back
      n = maxloc(mode(2, :)**2 + mode(3, :)**2, dim=1)
      step = step - sum(mode(2:3, n)*step(2:3, n))/sum(mode(2:3, n)**2)*mode
      call turning_mode(step, room)                     ! J p: u and phi do not turn
      room([1, 4], :) = 0.0_wp
      left = block_product(stiffness, step) - pull*lump*room + residual
      part = sum(mode*left)/sum(mode*lump*mode)
      call assertLessThan(maxval(abs(left - part*lump*mode)), exact, message='solves')
   end subroutine test_step

   !> A drive 0.3 + 0.5 cos(theta) - 0.8 sin(theta) of a string turned by theta comes to nothing, and grows with theta there;
   !> one of 1 + 0.5 cos(theta) never does.
   subroutine test_phase()
      real(wp), parameter :: a(2) = [0.3_wp, 1.0_wp], b = 0.5_wp, c(2) = [-0.8_wp, 0.0_wp], exact = 1.0e-12_wp
      type(phase_type) :: phase
      real(wp) :: state(6, 1), theta, drive
      logical :: lost
      integer :: i, turn
      do i = 1, size(a)
         phase = phase_type()
         state = reshape([0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 2.0_wp], shape(state))
         do turn = 1, 4
            theta = atan2(state(3, 1), state(2, 1))
            drive = a(i) + b*cos(theta) + c(i)*sin(theta)
            if (turn == 4) exit
            call turn_to_rest(phase, drive, state, lost)
            if (lost) exit
         end do
         call assertTrue(lost .eqv. i == 2, message='found where there is one')
         if (i == 2) cycle
         call assertLessThan(abs(drive), exact, message='nothing drives it')
         call assertGreaterThan(c(i)*cos(theta) - b*sin(theta), 0.1_wp, message='a turn is resisted')
         call assertRelativelyEqual(2.0_wp, hypot(state(5, 1), state(6, 1)), exact, message='slopes turn')
         call assertRelativelyEqual(theta + 0.5_wp*pi, atan2(state(6, 1), state(5, 1)), exact, message='as offsets do')
      end do
   end subroutine test_phase

   !> Gaps come to the depths asked for, ends stay, other gaps are surveyed where they now are. Two of them stand at one node.
   subroutine test_depths()
      real(wp), parameter :: exact = 1.0e-12_wp
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(gap_table_type) :: gaps
      type(depths_type) :: depth
      real(wp), allocatable :: state(:, :), before(:, :), step(:, :)
      integer :: e
      call hang(model, mesh, work, gaps, state)
      gaps%xi(3:4) = [1.0_wp, 0.0_wp]
      gaps%state = state_elastic
      gaps%state(6) = state_free
      allocate (step(6, mesh%nodes))
      call new_depths(mesh%elements, depth)
      call place_nodes(mesh, state, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      ! a step of a micrometre: its depths to first order are those it leads to, but for its square over the clearance
      step = 1.0e-6_wp*cos(state*1.0e4_wp)
      step(4, :) = 0.0_wp
      call depths_after(mesh, gaps, step, work, depth)
      call place_nodes(mesh, state + step, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      call assertLessThan(maxval(abs(depth%wanted - work%displacement), mask=gaps%state /= state_free), 1.0e-9_wp, &
                          message='first order')
      do e = 1, mesh%elements
         depth%wanted(e) = mesh%clearance(e) + 1.0e-5_wp*e
      end do
      depth%wanted(4) = depth%wanted(3)
      depth%wanted(6) = 0.0_wp
      before = state
      call place_nodes(mesh, state, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      call put_gaps(model%trajectory, mesh, gaps, depth, state, work)
      call assertLessThan(maxval(abs(depth%wanted - work%displacement), mask=depth%wanted > 0.0_wp), exact, message='depths')
      call assertEqual(0.0_wp, maxval(abs(state(:4, [1, mesh%nodes]) - before(:4, [1, mesh%nodes]))), message='ends stay')
      call assertLessThan(maxval(abs(state(2:3, :) - before(2:3, :))), 0.5_wp*mesh%clearance(1), message='not far')
      call assertEqual(state_free, gaps%state(6), message='open ones stay open')
   end subroutine test_depths

   !> Forces outlast a wall ten times as stiff; a gap that closes deep in the wall begins with none.
   subroutine test_forces()
      real(wp), parameter :: digits = 1.0e-8_wp
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(gap_table_type) :: gaps
      type(depths_type) :: depth
      real(wp), allocatable :: state(:, :)
      integer :: e
      call hang(model, mesh, work, gaps, state)
      gaps%state = state_elastic
      call new_depths(mesh%elements, depth)
      call place_nodes(mesh, state, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      work%normal = [(100.0_wp*e, e=1, mesh%elements)]
      gaps%law%contact = 10.0_wp*gaps%law%contact
      call keep_forces(model%trajectory, mesh, gaps, depth, state, work)
      do e = 1, mesh%elements
         call assertRelativelyEqual(100.0_wp*e, gaps%law(e)%contact*(work%displacement(e) - mesh%clearance(e)), digits, &
                                    message='kept')
      end do
      depth%wanted(5) = 0.0_wp      ! as if it had just closed
      call close_gently(model%trajectory, mesh, gaps, depth, state, work)
      call assertLessThan(abs(work%displacement(5) - mesh%clearance(5)), 1.0e-12_wp, message='touches')
      call assertEqual(state_elastic, gaps%state(5))
   end subroutine test_forces

   !> Torques of friction, bit and top do no work together as a string that whirls in a vertical hole turns as a whole, whatever its
   !> contact forces, once its twist balances them; the moments that they bend it with are not nothing. About the string's own axis
   !> or the hole's they would leave some percent of it. Moments and forces balance, too.
   subroutine test_drive()
      real(wp), parameter :: exact = 1.0e-11_wp, balanced = 1.0e-9_wp
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(block_matrix_type) :: matrix
      real(wp), allocatable :: state(:, :), residual(:, :), mode(:, :)
      real(wp) :: torque, worked
      integer :: n
      call hang(model, mesh, work, gaps, state)
      mesh%rotary = [(0.1_wp*n, n=1, mesh%elements)]
      gaps%xi = [(real(n - 1, wp)/(mesh%elements - 1), n=1, mesh%elements)]
      gaps%law%clearance = 0.95_wp*mesh%clearance
      gaps%state = state_elastic
      work%climb = 0.0_wp
      loads%tob = 4.0e3_wp
      matrix = new_block_matrix(mesh%nodes)
      allocate (residual, mode, mold=state)
      call place_nodes(mesh, state, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, residual, matrix, forces_only=.true.)
      call assertGreaterThan(minval(work%normal), 1.0_wp, message='touches')
      torque = 0.0_wp
      do n = mesh%nodes, 2, -1          ! of the element above a node
         torque = torque - residual(4, n)
         residual(4, n) = torque
      end do
      do n = 2, mesh%nodes
         state(4, n) = state(4, n - 1) + residual(4, n)*mesh%length(n - 1)/mesh%gj(n - 1)
      end do
      call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, residual, matrix, forces_only=.true.)
      call assertLessThan(maxval(abs(residual(4, :))), balanced*loads%tob, message='twist balances torque')
      call assertGreaterThan(abs(work%top_torque), 1.05_wp*loads%tob, message='friction has torque')
      mode = 0.0_wp
      call turning_mode(state, mode)
      worked = sum(abs(mode*residual))
      call assertGreaterThan(worked, 1.0_wp, message='there is something to balance')
      call assertLessThan(abs(sum(mode*residual)), exact*worked, message='no drive')
   end subroutine test_drive

   !> A kilometre of pipe in a vertical hole, rotating under torque, sliding and standing, buckled: the weight less the bit's
   !> hangs on the hook but for sliding friction. 50 iterations were seen; from a start with another phase of the helix 103, without
   !> the turn in the step, and with gaps left where steps along the wall leave them, 280.
   subroutine test_iterations()
      integer, parameter :: operation(4) = [operation_rotary_drilling, operation_sliding_drilling, operation_rotary_drilling, &
                                            operation_static]
      real(wp), parameter :: wob(4) = [5.0e4_wp, 5.0e4_wp, 1.0e5_wp, 1.0e5_wp], tob(4) = [5.0e3_wp, 3.0e3_wp, 1.0e4_wp, 0.0_wp]
      real(wp), parameter :: depth = 1000.0_wp, weight = 265.0_wp, balance = 1.0e-8_wp
      integer, parameter :: most = 70
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i, iterations
      iterations = 0
      do i = 1, size(operation)
         call new_well(model, [0.0_wp, depth], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], hole, 0.25_wp, pipe(weight, od, id))
         model%boundary%top_centred = .true.
         model%boundary%bit_centred = .true.
         model%cases(1)%operation = operation(i)
         model%cases(1)%wob = wob(i)
         model%cases(1)%tob = tob(i)
         call solve_static_analysis(model, 1, result, error)   ! what drives the turn balances nothing: `solve` would object
         call assertFalse(allocated(error), message='solved')
         call assertEqual(result_converged, result%status, message='converged')
         iterations = iterations + result%iterations
         if (operation(i) /= operation_sliding_drilling) &
            call assertRelativelyEqual(weight*depth - wob(i), result%hookload, balance, message='hook load')
         call assertGreaterThan(sum(result%states(1:)), 0, message='touches')
      end do
      call note('iterations', real(iterations, wp))
      call assertLessThan(iterations, most, message='iterations')
   end subroutine test_iterations

   !> A short string laid as a helix just inside the wall of a vertical hole.
   subroutine hang(model, mesh, work, gaps, state)
      type(model_type), intent(out) :: model
      type(mesh_type), intent(out) :: mesh
      type(workspace_type), intent(out) :: work
      type(gap_table_type), intent(out) :: gaps
      real(wp), allocatable, intent(out) :: state(:, :)
      type(gap_law_type), allocatable :: laws(:)
      real(wp) :: angle
      integer :: e, n
      call new_well(model, [0.0_wp, length], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, pipe(300.0_wp, od, id))
      model%cases(1)%operation = operation_static
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), length/elements), mesh)
      call new_workspace(mesh, work)
      allocate (laws(mesh%elements), state(6, mesh%nodes))
      do e = 1, mesh%elements
         laws(e) = gap_law_type(clearance=mesh%clearance(e), contact=1.0e6_wp, maximum=1.0e6_wp, eps_nmax=0.1_wp)
      end do
      gaps = new_gap_table(laws, 0.4_wp)
      state = 0.0_wp
      do n = 1, mesh%nodes
         angle = pi*mesh%md(n)/length
         state(2:3, n) = 0.98_wp*mesh%clearance(1)*[cos(angle), sin(angle)]
         state(5:6, n) = 0.98_wp*mesh%clearance(1)*pi/length*[-sin(angle), cos(angle)]
      end do
   end subroutine hang
end module dg_test_whirling
