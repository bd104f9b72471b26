!> Linear solvers against the size of the mesh: factors, substitution, fill, and the residual that is left.
module dg_bench_solvers
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_bench_chain, only: chain_type, new_chain, remaining
   use dg_bench_tools, only: median, now
   use dg_block_matrix, only: block_size
   use dg_block_solver, only: block_solve, block_solver_type, new_block_solver
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_model, only: model_type
   use dg_sparse_solver, only: sparse_condition, sparse_factor, sparse_release, sparse_solve, sparse_solver_type
   use dg_symmetric_solver, only: is_symmetric, symmetric_factor, symmetric_solve, symmetric_solver_type
   implicit none
   private
   public :: print_solvers

   real(wp), parameter :: microseconds = 1.0e6_wp
   !> Elements that a measurement goes through at least, smaller meshes several times.
   integer, parameter :: least_elements = 20000
   !> Solvers that are compared; both of the last two are the deck's 'sparse', each where it is good.
   integer, parameter :: by_block = 1, by_band = 2, by_klu = 3, by_ldl = 4
   character(*), parameter :: names(4) = [character(6) :: 'block', 'banded', 'klu', 'ldl']

contains

   !> The case as it is, then without friction, where the matrix is symmetric.
   subroutine print_solvers(model, case_index, lengths, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: lengths(:)     !< of elements [m]
      integer, intent(in) :: runs
      type(model_type), allocatable :: resting
      call print_table(model, case_index, lengths, runs)
      allocate (resting, source=model)
      resting%cases(case_index)%operation = operation_static
      resting%cases(case_index)%wob = 0.0_wp      ! in a bend it follows the bit, without a potential
      call print_table(resting, case_index, lengths, runs)
   end subroutine print_solvers

   !> One line a mesh and solver, times per element in microseconds.
   subroutine print_table(model, case_index, lengths, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: lengths(:)     !< of elements [m]
      integer, intent(in) :: runs
      type(chain_type) :: chain
      type(sparse_solver_type) :: sparse
      real(wp), allocatable :: x(:, :), first(:, :)
      real(wp) :: factor, substitution, fill, condition, difference
      integer :: i, kind, info
      write (output_unit, '(/,a)') 'Linear solvers, '//model%cases(case_index)%name//' at its predicted state'// &
         merge(', without friction', repeat(' ', 18), model%cases(case_index)%operation == operation_static)
      write (output_unit, '(a)') 'elements solver   factor us/el  substit. us/el  fill entries/el  residual/load  '// &
         'differs from block  condition'
      write (output_unit, '(a)') 'block: substitution is part of the elimination'
      write (output_unit, '(a)') 'Round-off: where the condition nears 1/epsilon = 4.5e15 the solvers part, '// &
         'though each leaves a small residual'
      do i = 1, size(lengths)
         call new_chain(model, case_index, lengths(i), chain)
         call sparse_factor(sparse, chain%matrix, info)
         call sparse_condition(sparse, condition)
         call sparse_release(sparse)
         do kind = 1, merge(by_ldl, by_klu, is_symmetric(chain%matrix))
            call measure(chain, kind, runs, factor, substitution, fill, x)
            if (kind == by_block) first = x
            difference = maxval(abs(x - first))/maxval(abs(first))
            write (output_unit, '(i8,1x,a6,f15.2,f16.2,f17.1,es15.1,es20.1,es11.1)') chain%mesh%elements, names(kind), &
               factor, substitution, fill, remaining(chain, x), difference, condition
         end do
      end do
   end subroutine print_table

   !> Medians per element [us], entries of the factors per element, and the solution.
   subroutine measure(chain, kind, runs, factor, substitution, fill, x)
      type(chain_type), intent(in) :: chain
      integer, intent(in) :: kind, runs
      real(wp), intent(out) :: factor, substitution, fill
      real(wp), allocatable, intent(out) :: x(:, :)
      type(block_solver_type) :: block
      type(band_solver_type) :: band
      type(sparse_solver_type) :: sparse
      type(symmetric_solver_type) :: symmetric
      real(wp) :: factors(runs), substitutions(runs), start, between
      integer :: run, again, times, info
      allocate (x, mold=chain%residual)
      times = max(1, least_elements/chain%mesh%elements)
      if (kind == by_block) call new_block_solver(chain%mesh%nodes, block)
      if (kind == by_band) band = new_band_solver(chain%mesh%nodes)
      do run = 1, runs
         start = now()
         do again = 1, times
            select case (kind)
            case (by_block)
               x = -chain%residual
               call block_solve(block, chain%matrix, x, info)
            case (by_band); call band_factor(band, chain%matrix, info)
            case (by_klu); call sparse_factor(sparse, chain%matrix, info)
            case default; call symmetric_factor(symmetric, chain%matrix, info)
            end select
         end do
         between = now()
         do again = 1, times
            if (kind == by_block) exit       ! it does both in one
            x = -chain%residual
            select case (kind)
            case (by_band); call band_solve(band, x)
            case (by_klu); call sparse_solve(sparse, x)
            case default; call symmetric_solve(symmetric, x)
            end select
         end do
         factors(run) = between - start
         substitutions(run) = now() - between
      end do
      factor = microseconds*median(factors)/(real(times, wp)*chain%mesh%elements)
      substitution = microseconds*median(substitutions)/(real(times, wp)*chain%mesh%elements)
      select case (kind)
      case (by_block); fill = real(size(block%solved), wp)/chain%mesh%elements      ! beside the matrix itself, which is kept
      case (by_band); fill = real(size(band%band, 1), wp)*block_size
      case (by_klu); fill = real(sparse%fill, wp)/chain%mesh%elements
      case default; fill = real(symmetric%fill, wp)/chain%mesh%elements
      end select
      if (kind == by_klu) call sparse_release(sparse)
   end subroutine measure
end module dg_bench_solvers
