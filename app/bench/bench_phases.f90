!> Phases of one iteration against the size of the mesh: survey of the gaps, assembly, linear solvers; and memory.
module dg_bench_phases
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_assembly, only: assemble, load_type
   use dg_bench_tools, only: median, memory, now
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_block_solver, only: block_factor, block_solve, block_solver_type, new_block_solver
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_gap_state, only: gap_law_type
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_kinds, only: wp
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_predictor, only: predict
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: print_phases

   !> Element lengths [m] of the longest string of the deck: some hundreds to a hundred thousand elements.
   real(wp), parameter :: lengths(5) = [10.0_wp, 3.2_wp, 1.0_wp, 0.32_wp, 0.032_wp]

contains

   !> One line a mesh, times per element in microseconds.
   subroutine print_phases(model, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: runs
      real(wp) :: row(6), first(6), elements, smallest
      integer :: i, longest
      longest = maxloc(model%cases%bit_depth, dim=1)
      write (output_unit, '(/,a)') 'Phases of an iteration, '//model%cases(longest)%name//', microseconds an element'
      write (output_unit, '(a)') 'elements    survey  assembly     block LU  band LU  | their residuals over the load  | kB/element'
      smallest = 1.0_wp
      first = 0.0_wp
      do i = 1, size(lengths)
         call measure(model, longest, lengths(i), runs, elements, row)
         if (i == 2) then
            smallest = elements
            first = row
         end if
      end do
      write (output_unit, '(a,f5.2,a,f5.2)') 'growth from the second mesh to the last, exponent: assembly ', &
         1.0_wp + log(row(2)/first(2))/log(elements/smallest), ', block LU ', &
         1.0_wp + log(row(3)/first(3))/log(elements/smallest)
   end subroutine print_phases

   subroutine measure(model, case_index, length, runs, elements, row)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, runs
      real(wp), intent(in) :: length
      real(wp), intent(out) :: elements, row(6)
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(workspace_type) :: work
      type(load_type) :: loads
      type(block_matrix_type) :: matrix
      type(block_solver_type) :: block
      type(band_solver_type) :: band
      type(gap_law_type), allocatable :: laws(:)
      real(wp), allocatable :: state(:, :), residual(:, :), x(:, :)
      real(wp) :: t(0:4), times(runs, 4), before, remainder(2), used
      integer :: run, repeat, repeats, e, info
      before = memory()
      call new_mesh(model, model%cases(case_index), node_depths(model, model%cases(case_index), length), mesh)
      allocate (laws(mesh%elements))
      do e = 1, mesh%elements
         laws(e) = gap_law_type(clearance=mesh%clearance(e), contact=mesh%wall(e)*mesh%length(e), &
                                maximum=mesh%wall(e)*mesh%length(e), eps_nmax=mesh%eps_nmax(e))
      end do
      gaps = new_gap_table(laws, 0.5_wp)
      call new_workspace(mesh, work)
      matrix = new_block_matrix(mesh%nodes)
      call new_block_solver(mesh%nodes, block)
      allocate (state(6, mesh%nodes), residual(6, mesh%nodes), x(6, mesh%nodes))
      call predict(model, case_index, mesh, 1.0_wp, 1.0_wp, mesh%wall, state, gaps)
      loads = load_type(wob=model%cases(case_index)%wob, top_support=1.0e9_wp, bit_support=1.0e9_wp)
      repeats = max(1, 20000/mesh%elements)
      do run = 1, runs
         t(0) = now()
         do repeat = 1, repeats
            call place_nodes(mesh, state, work)
            call survey_gaps(model%trajectory, mesh, gaps, work)
         end do
         t(1) = now()
         do repeat = 1, repeats
            call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, residual, matrix)
         end do
         t(2) = now()
         do repeat = 1, repeats
            call block_factor(block, matrix, info)
            x = -residual
            call block_solve(block, matrix, x)
         end do
         t(3) = now()
         if (run == runs) then
            remainder(1) = remaining(matrix, residual, x)
            used = memory() - before
         end if
         times(run, 1:3) = t(1:3) - t(0:2)
      end do
      band = new_band_solver(mesh%nodes)
      do run = 1, runs
         t(3) = now()
         do repeat = 1, repeats
            call band_factor(band, matrix, info)
            x = -residual
            call band_solve(band, x)
         end do
         times(run, 4) = now() - t(3)
      end do
      remainder(2) = remaining(matrix, residual, x)
      elements = mesh%elements
      do e = 1, 4
         row(e) = 1.0e6_wp*median(times(:, e))/(elements*repeats)
      end do
      row(5:6) = remainder
      write (output_unit, '(i8,4f10.2,3x,2es12.1,f18.2)') mesh%elements, row, max(used, 0.0_wp)/1024.0_wp/elements
   end subroutine measure

   !> Largest |r + K x| over the largest |r|.
   pure function remaining(matrix, residual, x) result(remainder)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: residual(:, :), x(:, :)
      real(wp) :: remainder
      real(wp) :: r(6)
      integer :: n, before, after
      remainder = 0.0_wp
      do n = 1, size(x, 2)
         r = residual(:, n) + matmul(matrix%diagonal(:, :, n), x(:, n))
         before = n - 1
         after = n + 1
         if (before >= 1) r = r + matmul(matrix%lower(:, :, before), x(:, before))
         if (after <= size(x, 2)) r = r + matmul(matrix%upper(:, :, n), x(:, after))
         remainder = max(remainder, maxval(abs(r)))
      end do
      remainder = remainder/maxval(abs(residual))
   end function remaining
end module dg_bench_phases
