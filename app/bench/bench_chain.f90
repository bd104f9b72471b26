!> The equations of one load case as an iteration meets them: mesh, gaps and matrix at the predicted state.
module dg_bench_chain
   use dg_assembly, only: assemble, load_type
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_block_matrix, only: block_matrix_type, block_product, new_block_matrix
   use dg_bench_tools, only: now
   use dg_gap_state, only: gap_law_type
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, solve_linear
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_predictor, only: predict, start_type
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: chain_type, new_chain, assemble_chain, survey_chain, time_chain, time_band, remaining, phases, least_elements

   !> Phases of an iteration: survey of the gaps, assembly, solution.
   integer, parameter :: phases = 3
   !> Elements that a measurement of them goes through at least, smaller meshes several times.
   integer, parameter :: least_elements = 20000

   type :: chain_type
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(workspace_type) :: work
      type(load_type) :: loads
      type(block_matrix_type) :: matrix
      real(wp), allocatable :: state(:, :), residual(:, :)   !< (6,nodes)
   end type chain_type

   !> Springs at the centred ends [N/m].
   real(wp), parameter :: support = 1.0e9_wp
   real(wp), parameter :: middle = 0.5_wp

contains

   !> Sets a case up with elements of a length [m], predicts its state and assembles the equations there.
   subroutine new_chain(model, case_index, length, chain)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: length
      type(chain_type), intent(out) :: chain
      type(gap_law_type), allocatable :: laws(:)
      integer :: e
      call new_mesh(model, model%cases(case_index), node_depths(model, model%cases(case_index), length), chain%mesh)
      associate (mesh => chain%mesh)
         allocate (laws(mesh%elements))
         do e = 1, mesh%elements
            laws(e) = gap_law_type(clearance=mesh%clearance(e), contact=mesh%wall(e)*mesh%length(e), &
                                   maximum=10.0_wp*mesh%wall(e)*mesh%length(e), eps_nmax=mesh%eps_nmax(e))
         end do
         chain%gaps = new_gap_table(laws, middle)
         call new_workspace(mesh, chain%work)
         chain%matrix = new_block_matrix(mesh%nodes)
         allocate (chain%state(6, mesh%nodes), chain%residual(6, mesh%nodes))
         call predict(model, case_index, mesh, start_type(), chain%work%sideways, chain%state, chain%gaps, chain%work%normal)
      end associate
      chain%loads = load_type(wob=model%cases(case_index)%wob, top_support=support, bit_support=support)
      call survey_chain(model, chain)
      call assemble_chain(model, chain)
   end subroutine new_chain

   !> Places the nodes and measures the gaps.
   subroutine survey_chain(model, chain)
      type(model_type), intent(in) :: model
      type(chain_type), intent(inout) :: chain
      call place_nodes(chain%mesh, chain%state, chain%work)
      call survey_gaps(model%trajectory, chain%mesh, chain%gaps, chain%work)
   end subroutine survey_chain

   !> Assembles residual and matrix.
   subroutine assemble_chain(model, chain)
      type(model_type), intent(in) :: model
      type(chain_type), intent(inout) :: chain
      call assemble(model%trajectory, chain%mesh, chain%loads, chain%gaps, chain%state, .false., chain%work, chain%residual, &
                    chain%matrix)
   end subroutine assemble_chain

   !> Seconds of each phase, so many times over; `x` is the solution.
   subroutine time_chain(model, repeats, chain, solver, x, seconds)
      type(model_type), intent(in) :: model
      integer, intent(in) :: repeats
      type(chain_type), intent(inout) :: chain
      type(linear_solver_type), intent(inout) :: solver
      real(wp), intent(inout) :: x(:, :)         !< (6,nodes)
      real(wp), intent(out) :: seconds(phases)
      real(wp) :: t(0:phases)
      integer :: again, info
      t(0) = now()
      do again = 1, repeats
         call survey_chain(model, chain)
      end do
      t(1) = now()
      do again = 1, repeats
         call assemble_chain(model, chain)
      end do
      t(2) = now()
      do again = 1, repeats
         call solve_linear(solver, chain%matrix, chain%residual, x, info)
      end do
      t(3) = now()
      seconds = t(1:) - t(:phases - 1)
   end subroutine time_chain

   !> Seconds of LAPACK's band solver for the same equations, so many times over: what an iteration is compared with.
   subroutine time_band(repeats, chain, x, seconds)
      integer, intent(in) :: repeats
      type(chain_type), intent(in) :: chain
      real(wp), intent(inout) :: x(:, :)         !< (6,nodes)
      real(wp), intent(out) :: seconds
      type(band_solver_type) :: band
      integer :: again, info
      band = new_band_solver(chain%mesh%nodes)
      seconds = now()
      do again = 1, repeats
         call band_factor(band, chain%matrix, info)
         x = -chain%residual
         call band_solve(band, x)
      end do
      seconds = now() - seconds
   end subroutine time_band

   !> Largest |r + K x| over the largest |r| [-].
   pure function remaining(chain, x) result(remainder)
      type(chain_type), intent(in) :: chain
      real(wp), intent(in) :: x(:, :)
      real(wp) :: remainder
      remainder = maxval(abs(chain%residual + block_product(chain%matrix, x)))/maxval(abs(chain%residual))
   end function remaining
end module dg_bench_chain
