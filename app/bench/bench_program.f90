!> Time of the program beside its solutions: reading, limits, files, pictures, page.
module dg_bench_program
   use, intrinsic :: iso_fortran_env, only: int64, output_unit
   use dg_bench_runs, only: column_of, folder, out, program_beside, since, time_run
   use dg_bench_tools, only: median
   use dg_case_result, only: case_result_type
   use dg_error, only: error_list_type, error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_folder, only: make_folder
   use dg_job, only: job_type, model_mcge
   use dg_kinds, only: wp
   use dg_model, only: copy_without_cases, model_type
   use dg_read_deck, only: read_deck
   use dg_registry, only: studies_type
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_sweep_study, only: sweep_study_type
   use dg_sweep, only: point_at, point_case, point_count, point_holes, point_type, sweep_type
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: print_program

   !> A sweep takes seconds.
   integer, parameter :: sweep_runs = 3

contains

   !> Ratios of wall times, one thread, each of one run of the program and the solutions in it; medians. The deck is run without
   !> and with pictures, the sweep quietly.
   subroutine print_program(deck, sweep_deck, runs)
      character(*), intent(in) :: deck, sweep_deck   !< in input/, with the survey in the file beside them that they name
      integer, intent(in) :: runs
      type(error_type), allocatable :: error
      character(:), allocatable :: program
      real(wp) :: bare(runs), drawn(runs), swept(sweep_runs)
      integer :: i
      write (output_unit, '(/,a)') 'Program over solutions, one thread, wall times of one run'
      program = program_beside()
      call make_folder(folder, error)
      if (program == '' .or. allocated(error)) then
         write (output_unit, '(a)') 'no drillgap beside this program'
         return
      end if
      call write_without_pictures(deck)
      do i = 1, runs
         bare(i) = ratio_of_run(program, folder//'/bare.nml')
         drawn(i) = ratio_of_run(program, deck)
      end do
      do i = 1, sweep_runs
         swept(i) = ratio_of_sweep(program, sweep_deck)
      end do
      write (output_unit, '(a,f6.2)') deck//' without pictures ', median(bare)
      write (output_unit, '(a,f6.2)') deck//' with pictures    ', median(drawn)
      write (output_unit, '(a,f6.2)') sweep_deck//' --quiet    ', median(swept)
   end subroutine print_program

   !> The deck with `plots = .false.`, one folder deeper than the root as the deck is, twice.
   subroutine write_without_pictures(deck)
      character(*), intent(in) :: deck
      type(text_type), allocatable :: lines(:), changed(:)
      type(error_type), allocatable :: error
      character(:), allocatable :: failure
      integer :: i, quote
      allocate (lines(0), changed(0))   ! the compiler's flow analysis takes them for undefined otherwise
      call read_lines(deck, lines, failure)
      do i = 1, size(lines)
         quote = index(lines(i)%text, "'")
         if (index(lines(i)%text, 'survey_file') > 0 .and. quote > 0) lines(i)%text = lines(i)%text(:quote)//'../../input/'// &
            lines(i)%text(quote + 1:)
         call append_text(changed, lines(i)%text)
         if (index(lines(i)%text, '&job') == 1) call append_text(changed, '  plots = .false.')
      end do
      call write_text_file(folder//'/bare.nml', changed, error)
   end subroutine write_without_pictures

   !> Wall time of a run over the sum of its solutions' [-]; 0 where it fails.
   function ratio_of_run(program, deck) result(ratio)
      character(*), intent(in) :: program, deck
      real(wp) :: ratio
      real(wp) :: seconds, solutions
      call time_run(program, deck, seconds)
      solutions = sum(column_of(out//'/summary.csv', 'seconds'))
      ratio = 0.0_wp
      if (solutions > 0.0_wp) ratio = seconds/solutions
   end function ratio_of_run

   !> Wall time of a deck's run over that of the solutions of its sweeps alone, done here, and of its load cases [-].
   function ratio_of_sweep(program, deck) result(ratio)
      character(*), intent(in) :: program, deck
      real(wp) :: ratio
      type(model_type) :: model
      type(studies_type) :: studies
      type(job_type) :: job
      type(error_list_type) :: faults
      real(wp) :: seconds, solutions
      integer(int64) :: start
      integer :: i, k
      ratio = 0.0_wp
      call read_deck(deck, model, job, faults, studies)
      if (faults%count > 0) return
      call time_run(program, deck, seconds)
      solutions = sum(column_of(out//'/summary.csv', 'seconds'))
      call system_clock(start)
      do i = 1, size(studies%items)
         select type (study => studies%items(i)%study)
         type is (sweep_study_type)
            do k = 1, size(study%ranges)
               call solve_sweep(model, study%ranges(k))
            end do
         end select
      end do
      ratio = seconds/(solutions + since(start))
   end function ratio_of_sweep

   subroutine solve_sweep(model, sweep)
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(model_type) :: mine
      type(point_type) :: point
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i
      call copy_without_cases(model, mine)
      do i = 1, point_count(sweep)
         point = point_at(sweep, i)
         call point_case(sweep, point, mine%cases(1))
         call point_holes(sweep, point, mine%holes)
         if (sweep%models(point%model) == model_mcge) then
            call solve_static_analysis(mine, 1, result, error, totals_only=.true.)
         else
            call solve_soft_string(mine, 1, result, error, totals_only=.true.)
         end if
      end do
   end subroutine solve_sweep
end module dg_bench_program
