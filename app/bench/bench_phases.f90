!> Phases of one iteration against the size of the mesh: survey of the gaps, assembly, solution of the equations.
module dg_bench_phases
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_chain, only: chain_type, least_elements, new_chain, phases, time_band, time_chain
   use dg_bench_tools, only: median
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, new_linear_solver
   use dg_model, only: model_type
   implicit none
   private
   public :: print_phases

   real(wp), parameter :: microseconds = 1.0e6_wp

contains

   !> One line a mesh: times per element in microseconds, and what they are together over LAPACK's band solver. The exponents are
   !> those from the first mesh to the last.
   subroutine print_phases(model, case_index, lengths, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: lengths(:)   !< of elements [m]
      integer, intent(in) :: runs
      real(wp) :: cost(phases, size(lengths)), elements(size(lengths)), band
      integer :: i, n
      write (output_unit, '(/,a)') 'Phases of an iteration, '//model%cases(case_index)%name//', microseconds an element'
      write (output_unit, '(a)') 'elements    survey  assembly  solution     total     dgbsv     ratio'
      do i = 1, size(lengths)
         call measure(model, case_index, lengths(i), runs, elements(i), cost(:, i), band)
         write (output_unit, '(i8,6f10.2)') nint(elements(i)), cost(:, i), sum(cost(:, i)), band, sum(cost(:, i))/band
      end do
      n = size(lengths)
      write (output_unit, '(a,3f10.2)') 'exponent', 1.0_wp + log(cost(:, n)/cost(:, 1))/log(elements(n)/elements(1))
   end subroutine print_phases

   subroutine measure(model, case_index, length, runs, elements, cost, band)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, runs
      real(wp), intent(in) :: length
      real(wp), intent(out) :: elements, cost(phases), band
      type(chain_type) :: chain
      type(linear_solver_type) :: solver
      real(wp), allocatable :: x(:, :)
      real(wp) :: times(runs, phases), band_times(runs)
      integer :: run, repeats, i
      call new_chain(model, case_index, length, chain)
      call new_linear_solver(model%numerics%linear_solver, chain%mesh%nodes, solver)
      allocate (x, mold=chain%residual)
      elements = chain%mesh%elements
      repeats = max(1, least_elements/chain%mesh%elements)
      do run = 1, runs
         call time_chain(model, repeats, chain, solver, x, times(run, :))
         call time_band(repeats, chain, x, band_times(run))
      end do
      band = microseconds*median(band_times)/(elements*repeats)
      do i = 1, phases
         cost(i) = microseconds*median(times(:, i))/(elements*repeats)
      end do
   end subroutine measure
end module dg_bench_phases
