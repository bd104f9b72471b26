!> Runs the tests of a suite and reports.
!> Command line: -f PATTERN (only tests whose full name contains it), -d or -v (name each test before it runs, and tell
!> after it how far its numbers were from what was expected), -x FILE (results as JUnit XML). No test at all is a failure:
!> a misspelt pattern must not look like success.
module funit_runner
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: error_unit, int64, output_unit, real64
   use funit_deviation, only: pop_deviation
   use funit_exception, only: Exception, anyExceptions, pop_exceptions
   use funit_suite, only: TestMethod, TestSuite
   implicit none
   private
   public :: run

   abstract interface
      function load_tests_interface() result(suite)
         import :: TestSuite
         implicit none
         type(TestSuite) :: suite
      end function load_tests_interface
   end interface

   type :: outcome_type
      logical :: failed = .false.
      real(real64) :: seconds = 0.0_real64
      type(Exception), allocatable :: exceptions(:)
   end type outcome_type

   type :: options_type
      logical :: understood = .true.
      logical :: verbose = .false.
      character(:), allocatable :: pattern
      character(:), allocatable :: xml_file
   end type options_type

contains

   !> True where at least one test ran and none failed.
   logical function run(load_tests) result(success)
      procedure(load_tests_interface) :: load_tests
      type(TestSuite) :: suite
      type(options_type) :: options
      type(outcome_type), allocatable :: outcomes(:)
      logical, allocatable :: chosen(:)
      integer :: i, tests, failures
      options = read_options()
      success = .false.
      if (.not. options%understood) return
      suite = load_tests()
      allocate (outcomes(size(suite%methods)), chosen(size(suite%methods)))
      do i = 1, size(suite%methods)
         chosen(i) = index(suite%methods(i)%name, options%pattern) > 0 .or. options%pattern == ''
         if (chosen(i)) call run_test(suite%methods(i), options%verbose, outcomes(i))
      end do
      if (on_terminal() .and. .not. options%verbose) write (output_unit, '(a)') ''
      call print_failures(suite, outcomes)
      tests = count(chosen)
      failures = count(outcomes%failed)
      write (output_unit, '(a, i0, a, i0, a)') 'Tests run: ', tests, ', Failures: ', failures, ', Errors: 0'
      if (options%xml_file /= '') call write_xml(options%xml_file, suite, outcomes, chosen)
      if (tests == 0) then
         write (error_unit, '(3a)') 'no test matches "', options%pattern, '"'
         failures = 1
      end if
      write (output_unit, '(i0, a, i0, a)') tests - count(outcomes%failed), ' passed, ', failures, ' failed'
      flush (output_unit)
      success = failures == 0
   end function run

   subroutine run_test(test, verbose, outcome)
      type(TestMethod), intent(in) :: test
      logical, intent(in) :: verbose
      type(outcome_type), intent(out) :: outcome
      integer(int64) :: start, finish, rate
      character(:), allocatable :: deviation
      if (verbose) then
         write (output_unit, '(2a)') 'test ', test%name
         flush (output_unit) ! so that a crash leaves the name of its test
      end if
      call system_clock(start, rate)
      if (associated(test%setUp)) call test%setUp()
      if (.not. anyExceptions()) call test%method()
      if (associated(test%tearDown)) call test%tearDown()
      call system_clock(finish)
      outcome%seconds = real(finish - start, real64)/real(rate, real64)
      call pop_exceptions(outcome%exceptions)
      outcome%failed = size(outcome%exceptions) > 0
      call pop_deviation(deviation)
      if (verbose .and. deviation /= '') write (output_unit, '(2a)') '     ', deviation
      if (verbose .or. .not. on_terminal()) return
      write (output_unit, '(a)', advance='no') merge('F', '.', outcome%failed)     ! progress, as pFUnit prints it
      flush (output_unit)
   end subroutine run_test

   !> True if output goes to a terminal: tables in a file stay as they are.
   function on_terminal() result(is)
      logical :: is
      interface
         function isatty(descriptor) bind(c, name='isatty') result(yes)
            import :: c_int
            implicit none
            integer(c_int), value :: descriptor
            integer(c_int) :: yes
         end function isatty
      end interface
      is = isatty(1_c_int) == 1_c_int
   end function on_terminal

   subroutine print_failures(suite, outcomes)
      type(TestSuite), intent(in) :: suite
      type(outcome_type), intent(in) :: outcomes(:)
      integer :: i, k
      do i = 1, size(outcomes)
         if (.not. outcomes(i)%failed) cycle
         write (output_unit, '(/2a)') 'Failure in: ', suite%methods(i)%name
         do k = 1, size(outcomes(i)%exceptions)
            associate (failure => outcomes(i)%exceptions(k))
               if (failure%location%lineNumber > 0) write (output_unit, '(3a, i0, a)') &
                  '  [', trim(failure%location%fileName), ':', failure%location%lineNumber, ']'
               write (output_unit, '(2a)') '  ', failure%message
            end associate
         end do
      end do
      if (any(outcomes%failed)) write (output_unit, '(a)') ''
   end subroutine print_failures

   function read_options() result(options)
      type(options_type) :: options
      character(:), allocatable :: word
      integer :: i
      options%pattern = ''
      options%xml_file = ''
      i = 0
      do while (i < command_argument_count())
         i = i + 1
         word = argument(i)
         select case (word)
         case ('-d', '-v', '--debug', '--verbose')
            options%verbose = .true.
         case ('-f', '--filter')
            i = i + 1
            options%pattern = argument(i)
            if (options%pattern == '') options%understood = .false.
         case ('-x', '--xml')
            i = i + 1
            options%xml_file = argument(i)
            if (options%xml_file == '') options%understood = .false.
         case default
            options%understood = .false.
         end select
         if (.not. options%understood) then
            write (error_unit, '(3a)') 'option "', word, '" not understood; use -f PATTERN, -d, -x FILE'
            return
         end if
      end do
   end function read_options

   !> A word of the command line; '' past its end.
   function argument(i) result(word)
      integer, intent(in) :: i
      character(:), allocatable :: word
      integer :: length
      length = 0
      if (i <= command_argument_count()) call get_command_argument(i, length=length)
      allocate (character(length) :: word)
      if (length > 0) call get_command_argument(i, word)
   end function argument

   subroutine write_xml(file, suite, outcomes, chosen)
      character(*), intent(in) :: file
      type(TestSuite), intent(in) :: suite
      type(outcome_type), intent(in) :: outcomes(:)
      logical, intent(in) :: chosen(:)
      integer :: unit, status, i, k
      open (newunit=unit, file=file, action='write', status='replace', iostat=status)
      if (status /= 0) then
         write (error_unit, '(2a)') 'cannot write ', file
         return
      end if
      write (unit, '(a)') '<?xml version="1.0" encoding="UTF-8"?>'
      write (unit, '(a, i0, a, i0, a)') '<testsuite name="tests" tests="', count(chosen), '" failures="', &
         count(outcomes%failed), '" errors="0">'
      do i = 1, size(outcomes)
         if (.not. chosen(i)) cycle
         write (unit, '(3a, f0.6, a)') '  <testcase name="', escaped(suite%methods(i)%name), '" time="', &
            outcomes(i)%seconds, '">'
         do k = 1, size(outcomes(i)%exceptions)
            write (unit, '(3a)') '    <failure message="', escaped(outcomes(i)%exceptions(k)%message), '"/>'
         end do
         write (unit, '(a)') '  </testcase>'
      end do
      write (unit, '(a)') '</testsuite>'
      close (unit)
   end subroutine write_xml

   pure function escaped(text) result(safe)
      character(*), intent(in) :: text
      character(:), allocatable :: safe
      integer :: i
      safe = ''
      do i = 1, len(text)
         select case (text(i:i))
         case ('&')
            safe = safe//'&amp;'
         case ('<')
            safe = safe//'&lt;'
         case ('>')
            safe = safe//'&gt;'
         case ('"')
            safe = safe//'&quot;'
         case (achar(10))
            safe = safe//'&#10;'
         case default
            safe = safe//text(i:i)
         end select
      end do
   end function escaped
end module funit_runner
