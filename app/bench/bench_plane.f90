!> What it saves to solve a string in the plane of its hole: phases of an iteration, whole solutions and memory, beside those in
!> space on the same mesh.
module dg_bench_plane
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_chain, only: chain_type, least_elements, new_chain, phases, time_band, time_chain
   use dg_bench_tools, only: median, now
   use dg_block_matrix, only: block_matrix_type, new_block_matrix, plane_block_size
   use dg_case_result, only: case_result_type, way_planar
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_linear_solver, only: linear_solver_type, new_linear_solver, solve_linear
   use dg_model, only: model_type
   use dg_plane, only: find_plane, flatten, plane_type
   use dg_plane_assembly, only: assemble_in_plane
   use dg_process_memory, only: forget_memory_peak, memory_now, memory_peak
   use dg_static_analysis, only: solve_static_analysis
   implicit none
   private
   public :: print_plane

   integer, parameter :: in_space = 1, in_plane = 2
   !> Phases: survey of the gaps, the same for both; assembly; solution.
   integer, parameter :: survey = 1, assembly = 2, solution = 3
   real(wp), parameter :: microseconds = 1.0e6_wp, kilobyte = 1024.0_wp, per_cent = 100.0_wp

contains

   !> One line a mesh and way, times per element in microseconds; the share is that of an iteration in space, and the
   !> ratio an iteration over LAPACK's band solver for the equations in space.
   subroutine print_plane(model, case_index, lengths, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: lengths(:)   !< of elements [m]
      integer, intent(in) :: runs
      type(model_type) :: sized
      type(case_result_type) :: result(2)
      real(wp) :: cost(3, 2), whole(2), memory(2), band
      integer :: i, way
      write (output_unit, '(/,a)') 'In the plane of the hole, '//model%cases(case_index)%name//', microseconds an element'
      write (output_unit, '(a)') 'elements           survey  assembly  solution  iteration  share %  dgbsv ratio  iterations  '// &
         'whole/iteration  share %  peak kB/element  hook load kN'
      do i = 1, size(lengths)
         call measure_phases(model, case_index, lengths(i), runs, cost, band)
         sized = model
         sized%numerics%element_length = lengths(i)
         do way = in_space, in_plane
            sized%numerics%in_plane = way == in_plane
            call measure_whole(sized, case_index, runs, whole(way), memory(way), result(way))
            write (output_unit, '(i8,a,3f10.3,f11.3,f9.0,f13.2,i12,f17.3,f9.0,f17.2,f14.6,a)') result(way)%elements, &
               merge('  space  ', '  plane  ', way == in_space), cost(:, way), sum(cost(:, way)), &
               per_cent*sum(cost(:, way))/sum(cost(:, in_space)), sum(cost(:, way))/band, result(way)%iterations, whole(way), &
               per_cent*whole(way)/whole(in_space), memory(way), result(way)%hookload/1000.0_wp, &
               trim(merge('  not in the plane', '                  ', way == in_plane .and. result(way)%way /= way_planar))
         end do
      end do
   end subroutine print_plane

   subroutine measure_phases(model, case_index, length, runs, cost, band)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, runs
      real(wp), intent(in) :: length
      real(wp), intent(out) :: cost(3, 2), band
      type(chain_type) :: chain
      type(plane_type) :: plane
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: solver(2)
      real(wp), allocatable :: x(:, :), residual(:, :), y(:, :)
      real(wp) :: t(0:2), bands(runs), times(phases + 2, runs)     ! assembly and solution in the plane come last
      logical :: found
      integer :: run, again, repeats, info
      call new_chain(model, case_index, length, chain)
      call find_plane(chain%mesh, plane, found)
      call flatten(plane, chain%state)
      call new_linear_solver(model%numerics%linear_solver, chain%mesh%nodes, solver(in_space))
      call new_linear_solver(model%numerics%linear_solver, chain%mesh%nodes, solver(in_plane), plane_block_size)
      matrix = new_block_matrix(chain%mesh%nodes, plane_block_size)
      allocate (x, mold=chain%residual)
      allocate (residual(plane_block_size, chain%mesh%nodes), y(plane_block_size, chain%mesh%nodes))
      repeats = max(1, least_elements/chain%mesh%elements)
      do run = 1, runs
         call time_chain(model, repeats, chain, solver(in_space), x, times(:phases, run))
         call time_band(repeats, chain, x, bands(run))
         t(0) = now()
         do again = 1, repeats
            call assemble_in_plane(model%trajectory, chain%mesh, plane, chain%loads, chain%gaps, chain%state, .false., chain%work, &
                                   residual, matrix)
         end do
         t(1) = now()
         do again = 1, repeats
            call solve_linear(solver(in_plane), matrix, residual, y, info)
         end do
         t(2) = now()
         times(phases + 1:, run) = t(1:) - t(:1)
      end do
      times = times*microseconds/(real(repeats, wp)*chain%mesh%elements)
      band = microseconds*median(bands)/(real(repeats, wp)*chain%mesh%elements)
      cost(survey, :) = median(times(1, :))
      cost(assembly, in_space) = median(times(2, :))
      cost(solution, in_space) = median(times(3, :))
      cost(assembly, in_plane) = median(times(4, :))
      cost(solution, in_plane) = median(times(5, :))
   end subroutine measure_phases

   subroutine measure_whole(model, case_index, runs, cost, memory, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index, runs
      real(wp), intent(out) :: cost      !< an element and iteration [us]
      real(wp), intent(out) :: memory    !< peak an element [kB]; 0 where it is not known
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      real(wp) :: seconds(runs), start, before
      integer :: run
      logical :: known
      call forget_memory_peak(known)
      before = memory_now()
      do run = 1, runs
         start = now()
         call solve_static_analysis(model, case_index, result, error)
         seconds(run) = now() - start
         if (run == 1) memory = memory_peak() - before
      end do
      memory = merge(memory/(kilobyte*result%elements), 0.0_wp, known)
      cost = microseconds*median(seconds)/(real(result%elements, wp)*max(1, result%iterations))
   end subroutine measure_whole
end module dg_bench_plane
