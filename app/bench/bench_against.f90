!> This program beside another one, as an earlier commit has it: time, iterations and hook loads, deck by deck.
module dg_bench_against
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_runs, only: column_of, folder, out, program_beside, time_run
   use dg_bench_tools, only: median
   use dg_error, only: error_type
   use dg_folder, only: make_folder
   use dg_kinds, only: wp
   implicit none
   private
   public :: print_against

   !> Pairs of runs of each deck, one program after the other, so that both see the same machine.
   integer, parameter :: pairs = 5
   character(*), parameter :: hookloads(2) = [character(13) :: 'hookload_kN', 'hookload_klbf']

contains

   !> One line a deck: this program's time over the other's, medians of ratios; iterations of all cases; how far hook loads differ.
   !> Whole runs, quiet, on one thread, pictures included where the deck has them.
   subroutine print_against(other, decks)
      character(*), intent(in) :: other      !< path of the other program
      character(*), intent(in) :: decks(:)   !< paths
      character(:), allocatable :: own
      type(error_type), allocatable :: error
      integer :: i
      own = program_beside()
      call make_folder(folder, error)
      if (own == '' .or. allocated(error)) then
         write (output_unit, '(a)') 'no drillgap beside this program'
         return
      end if
      write (output_unit, '(a,i0,a)') 'This program over '//other//', medians of ', pairs, ' pairs of runs on one thread'
      write (output_unit, '(a)') 'deck                                   run  solutions  iterations: this  other  '// &
         'hook loads differ, of the largest'
      do i = 1, size(decks)
         call print_deck(own, other, trim(decks(i)))
      end do
   end subroutine print_against

   subroutine print_deck(own, other, deck)
      character(*), intent(in) :: own, other, deck
      real(wp) :: run(pairs), solutions(pairs), wall(2), solved(2), differ
      real(wp), allocatable :: pulls(:), others(:)
      integer :: iterations(2), i
      character(36) :: name
      name = deck
      do i = 1, pairs
         call run_once(own, deck, wall(1), solved(1), iterations(1), pulls)
         call run_once(other, deck, wall(2), solved(2), iterations(2), others)
         if (size(pulls) == 0 .or. size(pulls) /= size(others)) then
            write (output_unit, '(a)') name//' no two runs to compare'
            return
         end if
         run(i) = wall(1)/wall(2)
         solutions(i) = solved(1)/max(solved(2), tiny(1.0_wp))
      end do
      differ = maxval(abs(pulls - others))/max(maxval(abs(others)), tiny(1.0_wp))
      write (output_unit, '(a36,f7.2,f11.2,i18,i7,es13.1)') name, median(run), median(solutions), iterations, differ
   end subroutine print_deck

   !> A run's wall time, the sum of its solution times [s], its iterations and its hook loads, of all cases and models.
   subroutine run_once(program, deck, wall, solved, iterations, pulls)
      character(*), intent(in) :: program, deck
      real(wp), intent(out) :: wall, solved
      integer, intent(out) :: iterations
      real(wp), allocatable, intent(inout) :: pulls(:)
      integer :: i
      call time_run(program, deck, wall)
      solved = sum(column_of(out//'/summary.csv', 'seconds'))
      iterations = nint(sum(column_of(out//'/summary.csv', 'iterations')))
      do i = 1, size(hookloads)
         pulls = column_of(out//'/summary.csv', trim(hookloads(i)))
         if (size(pulls) > 0) return
      end do
   end subroutine run_once
end module dg_bench_against
