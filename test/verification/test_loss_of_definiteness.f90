!> Number of unstable modes of a string from the factors of a symmetric tangent.
module dg_test_loss_of_definiteness
   use funit, only: assertEqual, assertGreaterThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_case_result, only: case_result_type
   use dg_component, only: axial_stiffness, bending_stiffness
   use dg_constants, only: pi
   use dg_gap_state, only: gap_law_type
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solve_linear, solver_count, solver_name, solver_sparse
   use dg_load_case, only: operation_static, operation_trip_out
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_test_wells, only: new_well, pipe, solve
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: loss_of_definiteness_suite

   real(wp), parameter :: length = 100.0_wp, od = 0.127_wp, id = 0.1086_wp
   integer, parameter :: elements = 20

contains

   function loss_of_definiteness_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('loss_of_definiteness')
      call suite%addTest(TestMethod('euler_loads', test_euler_loads))
      call suite%addTest(TestMethod('same_answer', test_same_answer))
   end function loss_of_definiteness_suite

   !> A straight column between two supports, pushed by P, has two negative eigenvalues, one a plane, for every Euler load
   !> k**2 pi**2 EI/L**2 below P. The wall is far away.
   subroutine test_euler_loads()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(workspace_type) :: work
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: linear
      real(wp), allocatable :: state(:, :), residual(:, :), step(:, :)
      real(wp), parameter :: share(6) = [0.98_wp, 1.02_wp, 3.9_wp, 4.1_wp, 8.8_wp, 9.2_wp]
      integer, parameter :: passed(6) = [0, 1, 1, 2, 2, 3]
      real(wp) :: load
      integer :: i, e, info
      call new_well(model, [0.0_wp, length], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], 1.0_wp, 0.0_wp, pipe(0.0_wp, od, id))
      model%cases(1)%operation = operation_static
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), length/elements), mesh)
      call new_workspace(mesh, work)
      matrix = new_block_matrix(mesh%nodes)
      allocate (state(6, mesh%nodes), residual(6, mesh%nodes), step(6, mesh%nodes), source=0.0_wp)
      gaps = new_gap_table([(gap_law_type(clearance=mesh%clearance(e), contact=1.0_wp, maximum=1.0_wp, eps_nmax=0.1_wp), &
                             e=1, mesh%elements)], 0.5_wp)
      do i = 1, size(share)
         load = share(i)*pi**2*bending_stiffness(pipe(0.0_wp, od, id))/length**2
         loads = load_type(wob=load, top_support=1.0e9_wp, bit_support=1.0e9_wp)
         state(1, :) = -load*mesh%md/axial_stiffness(pipe(0.0_wp, od, id))
         call place_nodes(mesh, state, work)
         call survey_gaps(model%trajectory, mesh, gaps, work)
         call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, residual, matrix)
         call new_linear_solver(solver_sparse, mesh%nodes, linear)
         residual(2, :) = 1.0_wp
         call solve_linear(linear, matrix, residual, step, info)
         call assertEqual(0, info)
         call assertEqual(2*passed(i), linear%negative_pivots, message='two a load')
      end do
   end subroutine test_euler_loads

   !> A string in a bend, with and without friction, by every linear solver. Without friction, in tension, no step's matrix is
   !> indefinite; with friction it is not symmetric, and nothing is said.
   subroutine test_same_answer()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: hookload(solver_count)
      integer :: kind, pass
      do pass = 1, 2
         call new_well(model, [0.0_wp, 200.0_wp, 400.0_wp, 500.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], &
                       [0.0_wp, 0.0_wp, 30.0_wp, 30.0_wp], 0.2159_wp, merge(0.0_wp, 0.2_wp, pass == 1), &
                       pipe(300.0_wp, od, id))
         do kind = 1, solver_count
            model%numerics%linear_solver = kind
            call solve(model, merge(operation_static, operation_trip_out, pass == 1), 0.0_wp, 0.0_wp, result, solver_name(kind))
            hookload(kind) = result%hookload
            if (kind == solver_sparse .and. pass == 1) then
               ! rows that begin a stage of the wall have no step
               call assertTrue(all(result%history%negative_pivots <= 0), message='never indefinite')
               call assertGreaterThan(2*count(result%history%negative_pivots == 0), result%iterations, message='and told so')
            else
               call assertTrue(all(is_missing(result%history%negative_pivots)), message='nothing is said')
            end if
         end do
         do kind = 2, solver_count
            ! the iteration ends at 1e-9 of the weight
            call assertRelativelyEqual(hookload(1), hookload(kind), 1.0e-9_wp, message=solver_name(kind))
         end do
      end do
   end subroutine test_same_answer
end module dg_test_loss_of_definiteness
