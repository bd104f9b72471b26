!> Whole solutions against the size of the mesh: iterations, cost per element and iteration, memory per element, and how they
!> grow.
module dg_bench_sizes
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_tools, only: median, now
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_process_memory, only: forget_memory_peak, memory_now, memory_peak
   use dg_static_analysis, only: solve_static_analysis
   implicit none
   private
   public :: print_sizes

   !> Meshes of more elements are solved once.
   integer, parameter :: many_elements = 20000
   real(wp), parameter :: kilobyte = 1024.0_wp, microseconds = 1.0e6_wp, kilonewton = 1.0e3_wp

contains

   !> One line an element length; the exponent is that of seconds per iteration from the first mesh to the last.
   subroutine print_sizes(model, case_index, lengths, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: lengths(:)   !< [m]
      integer, intent(in) :: runs
      type(model_type) :: sized
      type(case_result_type), allocatable :: result
      type(error_type), allocatable :: error
      real(wp) :: seconds(runs), start, before, memory, elements(size(lengths)), cost(size(lengths))
      integer :: i, run, times
      logical :: known
      character(14) :: kilobytes, note
      write (output_unit, '(/,a)') 'Whole solutions, '//model%cases(case_index)%name//', against the size of the mesh'
      write (output_unit, '(a)') 'elements  length m  iterations     seconds  us/element/iteration  peak kB/element  '// &
         'hook load kN  torque kN.m  contact kN  balance kN'
      sized = model
      do i = 1, size(lengths)
         sized%numerics%element_length = lengths(i)
         call forget_memory_peak(known)
         before = memory_now()
         allocate (result)
         start = now()
         call solve_static_analysis(sized, case_index, result, error)
         seconds(1) = now() - start
         memory = memory_peak() - before
         times = merge(1, runs, result%elements > many_elements)
         do run = 2, times
            start = now()
            call solve_static_analysis(sized, case_index, result, error)
            seconds(run) = now() - start
         end do
         elements(i) = real(result%elements, wp)
         cost(i) = median(seconds(:times))/real(max(1, result%iterations), wp)
         kilobytes = '-'
         if (known) write (kilobytes, '(f14.2)') memory/(kilobyte*elements(i))
         note = ''
         if (result%status /= result_converged) note = 'not converged'
         write (output_unit, '(i8,f10.3,i12,f12.4,f22.2,3x,a,f14.5,f13.6,f12.4,es12.1,2x,a)') result%elements, lengths(i), &
            result%iterations, median(seconds(:times)), microseconds*cost(i)/elements(i), kilobytes, &
            [result%hookload, result%torque, result%normal_force, result%equilibrium_force]/kilonewton, trim(note)
         deallocate (result)
      end do
      write (output_unit, '(a)') 'balance: what is left of the sum of all forces on the string'
      write (output_unit, '(a,f5.2)') 'growth of seconds an iteration with elements, exponent', &
         log(cost(size(lengths))/cost(1))/log(elements(size(lengths))/elements(1))
   end subroutine print_sizes
end module dg_bench_sizes
