!> Print the cost of solutions. Parts: whole cases, the rest of the program, growth with size, memory, phases of an iteration,
!> linear solvers. Then orders of convergence, the effect of the wall's stiffness, and errors against cost of each fidelity on
!> the sample decks. `fpm run --example bench --flag -O3` from the root of the repository. Medians of several runs;
!> there are no assertions.
!>
!> `-- ablation [DECK ...]` prints instead what each number of dg_tuning is worth: these decks, or all wells of input/, solved with
!> it and without it. `-- against PROGRAM [DECK ...]` runs them by this program and by another one, as an earlier commit built it,
!> in turns, and prints ratios. `-- trade [DECK ...]` prints errors against cost of each fidelity alone, for these decks or the
!> wells of input/. `-- once` prints all costs by one run each, without the largest sizes: to see that all of it works. Any other
!> argument is refused.
program bench
   use, intrinsic :: iso_fortran_env, only: compiler_options, compiler_version, error_unit, output_unit
   use dg_bench_against, only: print_against
   use dg_bench_ablation, only: print_ablation
   use dg_bench_moments, only: print_moments
   use dg_bench_orders, only: print_orders
   use dg_bench_phases, only: print_phases
   use dg_bench_program, only: print_program
   use dg_bench_sizes, only: print_sizes
   use dg_bench_solvers, only: print_solvers
   use dg_bench_tools, only: machine_name, median, now
   use dg_bench_trade, only: print_trade
   use dg_bench_walls, only: print_walls
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_list_type, error_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_process_memory, only: keep_freed_memory
   use dg_read_deck, only: read_deck
   use dg_static_analysis, only: solve_static_analysis
   use dg_version, only: program_name, program_version
   implicit none
   character(*), parameter :: deck = 'input/gp1.nml', sweep_deck = 'input/sweep_gp1.nml'
   !> All wells of input/; decks for studies, sweeps and calibration are GP1 again.
   character(*), parameter :: decks(9) = [character(30) :: 'input/gp1.nml', 'input/johancsik_well_3.nml', &
      'input/extended_reach_10km.nml', 'input/short_radius_lateral.nml', 'input/casing_run.nml', 'input/tubing_string.nml', &
      'input/sucker_rods.nml', 'input/bha_analysis.nml', 'input/operations.nml']
   integer, parameter :: runs = 5
   !> A processor that has just woken takes twice as long [s].
   real(wp), parameter :: warm_up = 0.3_wp
   !> The case on which sizes are tried: it turns, so that hook load and torque are told.
   integer, parameter :: turning = 11
   !> Element lengths: a thousand to a hundred thousand elements [m].
   real(wp), parameter :: lengths(5) = [3.2_wp, 1.0_wp, 0.32_wp, 0.1_wp, 0.032_wp]
   !> Sizes of a quick look.
   integer, parameter :: quick = 3
   character(4096), allocatable :: arguments(:)
   integer :: i

   allocate (arguments(command_argument_count()))
   do i = 1, size(arguments)
      call get_command_argument(i, arguments(i))
   end do
   call keep_freed_memory()      ! as the program does
   if (size(arguments) == 0) then
      call print_costs(runs, lengths)
   else if (arguments(1) == 'once') then
      call print_costs(1, lengths(:quick))
   else if (arguments(1) == 'ablation') then
      call print_ablation(chosen(2))
   else if (arguments(1) == 'against' .and. size(arguments) > 1) then
      call print_against(trim(arguments(2)), chosen(3))
   else if (arguments(1) == 'trade') then
      call print_trade(chosen(2))
   else
      write (error_unit, '(a)') 'bench: unknown argument '//trim(arguments(1))//'. Give ablation, against PROGRAM, once or trade'
      error stop 2
   end if

contains

   !> Decks named from argument `first` on, else all wells.
   function chosen(first) result(paths)
      integer, intent(in) :: first
      character(len(arguments)), allocatable :: paths(:)
      paths = decks
      if (size(arguments) >= first) paths = arguments(first:)
   end function chosen

   !> Print the cost of solutions.
   subroutine print_costs(runs, lengths)
      integer, intent(in) :: runs            !< of what is timed
      real(wp), intent(in) :: lengths(:)     !< of elements [m]
      type(model_type) :: model
      type(job_type) :: job
      type(error_list_type) :: faults
      call read_deck(deck, model, job, faults)
      if (faults%count > 0) then
         write (error_unit, '(a)') 'bench: cannot read '//deck//'; run it from the root of the repository'
         error stop 2
      end if
      write (output_unit, '(a)') program_name//' '//program_version//', '//machine_name()
      write (output_unit, '(a)') compiler_version()
      write (output_unit, '(a)') compiler_options()
      if (index(compiler_options(), '-O') == 0) write (output_unit, '(a)') 'NOT OPTIMISED: add --flag -O3'
      write (output_unit, '(a,i0,a)') 'Processor time; medians of ', runs, ' runs where not said otherwise'
      call print_cases(model, runs)
      call print_program(deck, sweep_deck, runs)
      call print_moments(model)
      call print_sizes(model, turning, lengths, runs)
      call print_phases(model, turning, lengths, runs)
      call print_solvers(model, turning, lengths, runs)
      call print_orders(model)
      call print_walls(model, turning)
      call print_trade(decks)
   end subroutine print_costs

   !> The cases of the deck, each several times.
   subroutine print_cases(model, runs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: runs
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      real(wp) :: seconds(runs), total, work, start, wall
      integer :: i, run, iterations, lost
      total = 0.0_wp
      wall = 0.0_wp
      work = 0.0_wp
      iterations = 0
      lost = 0
      write (output_unit, '(/,a)') 'Cases of '//deck
      write (output_unit, '(a)') 'case                   elements iterations     seconds   us/element/iteration'
      start = now()
      do while (now() - start < warm_up)
         call solve_static_analysis(model, size(model%cases), result, error)
      end do
      do i = 1, size(model%cases)
         do run = 1, runs
            start = now()
            call solve_static_analysis(model, i, result, error)
            seconds(run) = now() - start
            if (run == 1) wall = wall + result%seconds
         end do
         if (result%status /= result_converged) lost = lost + 1
         write (output_unit, '(a22,2i10,f13.4,f13.2)') model%cases(i)%name//repeat(' ', 22), result%elements, &
            result%iterations, median(seconds), 1.0e6_wp*median(seconds)/(real(result%elements, wp)*result%iterations)
         total = total + median(seconds)
         work = work + real(result%elements, wp)*result%iterations
         iterations = iterations + result%iterations
      end do
      write (output_unit, '(a22,10x,i10,f13.4,f13.2)') 'all'//repeat(' ', 22), iterations, total, 1.0e6_wp*total/work
      write (output_unit, '(a,f8.4,a)') 'wall time of all, first run of each: ', wall, ' s'
      if (lost > 0) write (output_unit, '(i0,a)') lost, ' cases did not converge'
   end subroutine print_cases
end program bench
