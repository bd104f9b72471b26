!> Standard output. Where it cannot be written the exit status says so, a deck may come from a pipe, and text of a deck cannot
!> command the terminal.
module dg_test_standard_output
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: content, deck_path, good_deck, program_path, replaced, results_path, run_deck_text, run_program, &
                             run_type, scratch
   implicit none
   private
   public :: standard_output_suite

   character(*), parameter :: newline = achar(10), escape = achar(27)
   character(*), parameter :: not_written = 'not all could be written to standard output'
   !> All that prints.
   character(*), parameter :: prints(7) = [character(96) :: '--help', '--version', '--template', '--list-catalogue', &
      '--convert '//deck_path, deck_path//' --check', deck_path//' --output '//results_path]

contains

   function standard_output_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('standard_output')
      call suite%addTest(TestMethod('full_disk', test_full_disk))
      call suite%addTest(TestMethod('reader_gone', test_reader_gone))
      call suite%addTest(TestMethod('closed', test_closed))
      call suite%addTest(TestMethod('deck_from_a_pipe', test_pipe))
      call suite%addTest(TestMethod('deck_called_dash', test_dash))
      call suite%addTest(TestMethod('control_bytes', test_control_bytes))
      call suite%addTest(TestMethod('messages_to_nobody', test_messages))
   end function standard_output_suite

   subroutine test_full_disk()
      call try_all('', ' > /dev/full', 1, not_written)
   end subroutine test_full_disk

   !> The reader has ended before anything is printed, or after a line: quiet, and results are whole.
   subroutine test_reader_gone()
      call try_all('( sleep 0.1; ', '; echo $? > '//scratch//'/status ) | true; exit $(cat '//scratch//'/status)', 0, '')
      call try_all('( ', '; echo $? > '//scratch//'/status ) | head -n 1 > '//scratch//'/first; exit $(cat '//scratch//'/status)', &
                   0, '')
   end subroutine test_reader_gone

   !> The first file that is opened must not become standard output.
   subroutine test_closed()
      call try_all('', ' >&-', 1, not_written)
   end subroutine test_closed

   !> All that prints ends with a status and says why; results are written all the same.
   subroutine try_all(before, after, wanted, told)
      character(*), intent(in) :: before, after
      integer, intent(in) :: wanted          !< status
      character(*), intent(in) :: told       !< '': not a word
      type(run_type) :: run
      integer :: i, status
      run = run_deck_text(good_deck(), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      do i = 1, size(prints)
         status = shell(before//"'"//program_path()//"' "//trim(prints(i))//' 2> '//scratch//'/told'//after)
         call assertEqual(wanted, status, message=trim(prints(i))//after)
         call assertTrue(index(content(scratch//'/told'), told) > 0, message=trim(prints(i))//': '//content(scratch//'/told'))
         if (told == '') call assertEqual('', content(scratch//'/told'), message=trim(prints(i)))
      end do
      call assertTrue(index(content(results_path//'/summary.csv'), ',converged,') > 0, message='results')
      call assertEqual(0, index(content(results_path//'/summary.csv'), 'Model soft'), message='printed into a result')
   end subroutine try_all

   !> A pipe gives its text once.
   subroutine test_pipe()
      type(run_type) :: run
      character(:), allocatable :: whole
      integer :: status
      run = run_deck_text(good_deck(), '--check')
      run = run_program('--convert '//deck_path)
      whole = run%output(index(run%output, newline) + 1:)
      status = shell('cat '//deck_path//" | '"//program_path()//"' --convert /dev/stdin > "//scratch//'/piped')
      call assertEqual(0, status)
      run%output = content(scratch//'/piped')
      call assertEqual(whole, run%output(index(run%output, newline) + 1:))
      status = shell('cat '//deck_path//" | '"//program_path()//"' /dev/stdin --output "//results_path//' > '//scratch//'/piped')
      call assertEqual(0, status)
      call assertTrue(index(content(results_path//'/summary.csv'), ',converged,') > 0)
   end subroutine test_pipe

   !> `drillgap -`: paths of the deck are relative to the working folder, and its results need a folder.
   subroutine test_dash()
      type(run_type) :: run
      character(:), allocatable :: from
      integer :: status
      run = run_deck_text(good_deck(), '--check')
      from = ' < '//deck_path
      run = run_program('-'//from)
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'Give output_dir in &job, or --output DIR') > 0, message=run%diagnostics)
      run = run_program('- --output '//results_path//from)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(run%has_results)
      run = run_program('- --check --output '//results_path//from)
      call assertTrue(index(run%output, 'check of standard input: no fault found') > 0, message=run%output)
      run = run_program('--convert -'//from)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '! standard input with numbers in field units') == 1, message=run%output)
      status = shell("printf '%s\n' 'md inc azi' '0 0 0' '900 30 0' > "//scratch//'/path.txt')
      call assertEqual(0, status)
      status = shell("printf '%s\n' ""&trajectory survey_file = '"//scratch//"/path.txt', survey_units = 'SI' /"" '&hole "// &
                     "diameter = 215.9 /' '&component od = 127 /' ""&load_case name = 'u', operation = 'up', "// &
                     'bit_depth = 900 /" > '//scratch//'/path.nml')
      call assertEqual(0, status)
      run = run_program('- --check --output '//results_path//' < '//scratch//'/path.nml')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program('- --check < /dev/null')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'standard input: deck cannot be read') > 0, message=run%diagnostics)
   end subroutine test_dash

   !> In a title, a label, a name, a file's name; C1 as UTF-8 has it; letters stay.
   subroutine test_control_bytes()
      type(run_type) :: run
      character(:), allocatable :: deck
      character(*), parameter :: bell = achar(7), c1 = char(194)//char(155), letter = char(195)//char(169)
      deck = replaced(good_deck(), "'a deck'", "'"//escape//'[31mred'//bell//c1//'2J'//letter//"'")
      deck = replaced(deck, "name = 'u', operation", "name = 'u', section = 'x"//escape//"[2Jy', operation")
      deck = replaced(deck, "name = 'collars'", "name = 'c"//escape//"c'")
      run = run_deck_text(deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '?[31mred???2J'//letter) > 0, message='the title')
      call assertFalse(commands(run%output//run%diagnostics), message='tables')
      call assertFalse(commands(content(results_path//'/summary.csv')), message='summary.csv')
      call assertFalse(commands(content(results_path//'/limits.csv')), message='limits.csv')
      run = run_program(deck_path//' --check')
      call assertEqual(0, run%status)
      call assertFalse(commands(run%output), message='the echo')
      run = run_program("$(printf 'absent\033[2J.nml')")
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'absent?[2J.nml: deck cannot be opened') == 1, message='a file')
      run = run_program(deck_path//" --output $(printf '"//deck_path//"/\033[2J')")
      call assertEqual(1, run%status)
      call assertFalse(commands(run%diagnostics), message='a folder')
      ! a deck that is converted stays as it was
      run = run_program('--convert '//deck_path)
      call assertTrue(index(run%output, escape//'[31mred'//bell//c1) > 0, message='converted')
   end subroutine test_control_bytes

   pure function commands(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      is = scan(text, escape//achar(7)//char(155)) > 0
   end function commands

   !> Messages that nobody can read change no status and end no run.
   subroutine test_messages()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), 'diameter = 220.0', 'diametre = 220.0'), '--check')
      call assertEqual(2, run%status)
      call assertEqual(2, shell("'"//program_path()//"' "//deck_path//' 2> /dev/full'))
      call assertEqual(2, shell("'"//program_path()//"' "//deck_path//' 2>&-'))
      call assertEqual(2, shell("'"//program_path()//"' --nonsense 2> /dev/full"))
   end subroutine test_messages

   !> Exit status of a command of the shell.
   function shell(command) result(status)
      character(*), intent(in) :: command
      integer :: status
      integer :: command_status
      call execute_command_line(command, exitstat=status, cmdstat=command_status)
      if (command_status /= 0) status = -1
   end function shell
end module dg_test_standard_output
