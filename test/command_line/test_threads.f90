!> However many threads solve the cases, what is written of them is the same to the last digit, in the same order.
module dg_test_threads
   use funit, only: assertEqual, assertGreaterThan, TestMethod, TestSuite
   use dg_file_lines, only: read_lines
   use dg_program_run, only: good_deck, replaced, results_path, run_deck_text, run_type
   use dg_text, only: text_type
   implicit none
   private
   public :: threads_suite

   character(*), parameter :: newline = achar(10)

contains

   function threads_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('threads')
      call suite%addTest(TestMethod('same_results', test_same_results))
   end function threads_suite

   !> Six cases by four models; one case, with too few iterations, is told on standard error.
   subroutine test_same_results()
      character(:), allocatable :: deck
      type(text_type), allocatable :: one(:), many(:), names(:)
      type(run_type) :: run
      character(:), allocatable :: told
      integer :: i
      deck = replaced(good_deck(), "models = 'soft'", "models = 'mcge', 'soft', 'rigid', 'mixed', hdf5 = .false.")
      deck = replaced(deck, 'element_length = 10.0', 'element_length = 30.0, max_iterations = 2')
      deck = deck//"&load_case name = 'd', operation = 'down', bit_depth = 850.0 /"//newline// &
             "&load_case name = 'r', operation = 'rotary', bit_depth = 700.0, wob = 20.0 /"//newline
      run = run_deck_text(deck, '--threads 1')
      call assertEqual(3, run%status)
      told = run%diagnostics
      one = [profiles(), rows_without_seconds()]
      run = run_deck_text(deck, '--threads 4')
      many = [profiles(), rows_without_seconds()]
      call assertEqual(told, run%diagnostics)
      call assertGreaterThan(size(one), 500, message='lines compared')
      call assertEqual(size(one), size(many))
      if (size(one) /= size(many)) return
      do i = 1, size(one)
         if (one(i)%text /= many(i)%text) call assertEqual(one(i)%text, many(i)%text)
      end do
   end subroutine test_same_results

   !> The lines of all profiles.
   function profiles() result(lines)
      type(text_type), allocatable :: lines(:)
      character(*), parameter :: cases = 'usdr', models(4) = [character(5) :: 'mcge', 'soft', 'rigid', 'mixed']
      integer :: i, j
      allocate (lines(0))
      do j = 1, size(models)
         do i = 1, len(cases)
            if (j == 1 .and. cases(i:i) == 'r') cycle     ! it did not converge
            lines = [lines, lines_of('profile_'//cases(i:i)//'_'//trim(models(j))//'.csv')]
         end do
      end do
   end function profiles

   !> summary.csv up to the column of seconds.
   function rows_without_seconds() result(lines)
      type(text_type), allocatable :: lines(:)
      integer, parameter :: columns = 18     ! before seconds
      integer :: i, k, at
      lines = lines_of('summary.csv')
      do i = 1, size(lines)
         at = 0
         do k = 1, columns
            at = at + index(lines(i)%text(at + 1:), ',')
         end do
         lines(i)%text = lines(i)%text(:at)
      end do
   end function rows_without_seconds

   function lines_of(name) result(lines)
      character(*), intent(in) :: name
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      call read_lines(results_path//'/'//name, lines, failure)
      call assertEqual('', failure, message=name)
   end function lines_of
end module dg_test_threads
