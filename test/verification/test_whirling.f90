!> A string that turns about the axis of a vertical hole: what drives it, and what it takes to find it.
module dg_test_whirling
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type
   use dg_constants, only: pi
   use dg_error, only: error_type
   use dg_gap_state, only: gap_law_type, state_elastic
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_static
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: hold_ends, new_well, note, pipe, solve, string_weight
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
      call suite%addTest(TestMethod('drive', test_drive))
      call suite%addTest(TestMethod('iterations', test_iterations))
      call suite%addTest(TestMethod('assembly', test_assembly))
      call suite%addTest(TestMethod('sliding_in_s_wells', test_sliding_in_s_wells))
      call suite%addTest(TestMethod('free_bit', test_free_bit))
      call suite%addTest(TestMethod('nearly_vertical', test_nearly_vertical))
   end function whirling_suite

   !> Drilling in a vertical hole with three stabilizers, from where the collars begin to bend between them to where they coil
   !> above: the hook carries the weight less what is on the bit. None of these was found while friction around the hole climbed
   !> in part, while starts let stabilizers out of the hole by all of the clearance of collars, and while of two places as far
   !> off the axis each was held in turn.
   subroutine test_assembly()
      real(wp), parameter :: depth = 2200.0_wp, weights(6) = [10.0e3_wp, 30.0e3_wp, 45.0e3_wp, 60.0e3_wp, 90.0e3_wp, 120.0e3_wp]
      real(wp), parameter :: gauges(3) = [0.2143_wp, 0.2127_wp, 0.2095_wp]      ! of the stabilizers [m]
      real(wp), parameter :: frictions(2) = [0.1_wp, 0.43_wp]
      real(wp), parameter :: coils_from = 100.0e3_wp
      integer, parameter :: most = 120, most_coiled = 400      ! up to 80 are seen where nothing coils, 330 where collars do
      type(model_type) :: model
      type(component_type) :: parts(7)
      type(case_result_type) :: result
      character(40) :: what
      integer :: i, g, f, w
      do g = 1, size(gauges)
         do f = 1, size(frictions)
            call new_well(model, [0.0_wp, depth], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], hole, frictions(f), &
                          pipe(300.0_wp, od, id))
            do i = 1, 6
               parts(i) = pipe(1300.0_wp, 0.1651_wp, 0.0714_wp)
               parts(i)%kind = 'collar'
               if (modulo(i, 2) == 1) parts(i)%kind = 'stabilizer'
            end do
            parts(7) = pipe(300.0_wp, od, id)
            parts(1:6)%length = [2.0_wp, 2.2_wp, 2.0_wp, 9.0_wp, 2.0_wp, 120.0_wp]
            parts(1:5:2)%joint_od = [gauges(g), gauges(g), 0.2127_wp]
            deallocate (model%strings(1)%components)
            allocate (model%strings(1)%components(7))
            do i = 1, 7
               model%strings(1)%components(i) = parts(i)
            end do
            do w = 1, size(weights)
               write (what, '(f6.4, a, f4.2, a, f6.1)') gauges(g), ' m, friction ', frictions(f), ', kN ', 1.0e-3_wp*weights(w)
               call solve(model, operation_rotary_drilling, weights(w), 6.0e3_wp, result, trim(what))
               call assertRelativelyEqual(string_weight(model) - weights(w), result%hookload, 1.0e-9_wp, message=trim(what))
               call assertLessThan(result%iterations, merge(most, most_coiled, weights(w) < coils_from), message=trim(what))
            end do
         end do
      end do
   end subroutine test_assembly

   !> A string in a vertical hole with weight and torque at a free bit, below buckling. Forces balance: they did not (5e-9 of the
   !> weight) while the torque acted about the string's own axis, which drives the string around the hole.
   subroutine test_free_bit()
      real(wp), parameter :: torques(2) = [0.5e3_wp, 5.0e3_wp]
      real(wp), parameter :: balanced = 1.0e-9_wp       ! force over weight [-], at which the iteration stops; 5e-10 is seen
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: t
      do t = 1, size(torques)
         call new_well(model, [0.0_wp, 360.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], hole, 0.3_wp, pipe(360.0_wp, od, id))
         model%boundary%bit_centred = .false.
         call solve(model, operation_sliding_drilling, 12.0e3_wp, torques(t), result, 'free bit')
         call assertGreaterThan(result%normal_force, 1.0_wp, message='it touches the wall')
         call assertLessThan(result%equilibrium_force, balanced*string_weight(model), message='forces balance')
      end do
   end subroutine test_free_bit

   !> Rotary drilling with coiled pipe in a hole that is vertical but for some thousandths of a degree. The hook carries the weight
   !> less what is on the bit. None of these was found while the end of the coil, which the weight does not hold, had friction
   !> sideways: it climbed around the hole for ever.
   subroutine test_nearly_vertical()
      real(wp), parameter :: depth = 4500.0_wp, inclinations(3) = [1.0e-3_wp, 3.4e-3_wp, 1.0e-2_wp]      ! [deg]
      real(wp), parameter :: weight_on_bit = 190.0e3_wp, torque = 12.5e3_wp
      integer, parameter :: most = 60             ! up to 24 are seen
      type(model_type) :: model
      type(case_result_type) :: result
      character(24) :: what
      integer :: i
      do i = 1, size(inclinations)
         write (what, '(f6.4, a)') inclinations(i), ' deg'
         call new_well(model, [0.0_wp, depth], [0.0_wp, inclinations(i)], [0.0_wp, 0.0_wp], 0.3153_wp, 0.5_wp, &
                       pipe(depth, od, id))
         call hold_ends(model)
         call solve(model, operation_rotary_drilling, weight_on_bit, torque, result, what)
         call assertRelativelyEqual(string_weight(model) - weight_on_bit, result%hookload, 1.0e-6_wp, message=what)
         call assertLessThan(result%iterations, most, message=what)
      end do
   end subroutine test_nearly_vertical

   !> A string that slides with a motor's torque and coils in the vertical stretch below an S-shaped well: its hook load beside that
   !> of an integration along a string without bending stiffness. None of these was found while the torque at a free bit acted
   !> about the string's own axis, which drives the coil around.
   subroutine test_sliding_in_s_wells()
      real(wp), parameter :: frictions(2) = [0.1_wp, 0.3_wp], weights(3) = [20.0e3_wp, 35.0e3_wp, 50.0e3_wp]
      real(wp), parameter :: torques(2) = [1.0e3_wp, 6.0e3_wp]
      real(wp), parameter :: bent = 2.0e-3_wp     ! what bending changes of the hook load [-]; up to 1.5e-3 is seen
      integer, parameter :: most = 60             ! up to 44 are seen
      type(model_type) :: model
      type(case_result_type) :: result, soft
      character(40) :: what
      type(error_type), allocatable :: error
      integer :: f, w, t
      do f = 1, size(frictions)
         call new_well(model, [0.0_wp, 700.0_wp, 1200.0_wp, 1700.0_wp, 2000.0_wp, 2535.0_wp], &
                       [0.0_wp, 0.0_wp, 33.0_wp, 33.0_wp, 0.0_wp, 0.0_wp], spread(0.0_wp, 1, 6), 0.1524_wp, frictions(f), &
                       pipe(200.0_wp, 0.0889_wp, 0.0702_wp))
         do w = 1, size(weights)
            model%cases(1)%wob = weights(w)
            model%cases(1)%operation = operation_sliding_drilling
            call solve_soft_string(model, 1, soft, error, totals_only=.true.)
            call assertFalse(allocated(error), message='soft string')
            do t = 1, size(torques)
               write (what, '(a, f4.2, 2(a, f5.1))') 'friction ', frictions(f), ', kN ', 1.0e-3_wp*weights(w), ', kN.m ', &
                  1.0e-3_wp*torques(t)
               call solve(model, operation_sliding_drilling, weights(w), torques(t), result, trim(what))
               call assertRelativelyEqual(soft%hookload, result%hookload, bent, message=trim(what))
               call assertLessThan(result%iterations, most, message=trim(what))
            end do
         end do
      end do
   end subroutine test_sliding_in_s_wells

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
      mesh%friction_around = [(0.1_wp*n, n=1, mesh%elements)]
      gaps%xi = [(real(n - 1, wp)/(mesh%elements - 1), n=1, mesh%elements)]
      gaps%law%clearance = 0.95_wp*mesh%clearance
      gaps%state = state_elastic
      work%sideways = 0.0_wp
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
         state(4, n) = state(4, n - 1) + residual(4, n)*mesh%length(n - 1)/mesh%section(n - 1)%gj
      end do
      call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, residual, matrix, forces_only=.true.)
      call assertLessThan(maxval(abs(residual(4, :))), balanced*loads%tob, message='twist balances torque')
      call assertGreaterThan(abs(work%top_torque), 1.05_wp*loads%tob, message='friction has torque')
      mode = 0.0_wp
      mode(2, :) = -state(3, :)
      mode(3, :) = state(2, :)
      mode(5, :) = -state(6, :)
      mode(6, :) = state(5, :)
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
         call hold_ends(model)
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
