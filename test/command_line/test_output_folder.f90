!> The output folder: inputs survive in it, two runs never share it, nothing of an earlier run stays and nothing else goes.
module dg_test_output_folder
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: content, deck_path, good_deck, is_result, program_path, replaced, results_path, run_deck_text, &
                             run_interrupted, run_program, run_type, scratch, until
   implicit none
   private
   public :: output_folder_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: survey = scratch//'/path.csv'
   character(*), parameter :: sweep = "&sweep name = 's', operations = 'up', bit_depth_from = 100, bit_depth_step = 5 /"

contains

   function output_folder_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('output_folder')
      call suite%addTest(TestMethod('inputs_survive', test_inputs))
      call suite%addTest(TestMethod('unfinished_input', test_unfinished_input))
      call suite%addTest(TestMethod('deck_in_its_results', test_deck_as_result))
      call suite%addTest(TestMethod('links_are_not_followed', test_links))
      call suite%addTest(TestMethod('pictures_are_no_folder', test_no_folder))
      call suite%addTest(TestMethod('links_are_refused', test_refused_links))
      call suite%addTest(TestMethod('two_runs', test_two_runs))
      call suite%addTest(TestMethod('parts_share', test_parts))
      call suite%addTest(TestMethod('killed_run', test_killed))
      call suite%addTest(TestMethod('leftovers', test_leftovers))
      call suite%addTest(TestMethod('strangers_stay', test_strangers))
      call suite%addTest(TestMethod('list_is_whole', test_list))
   end function output_folder_suite

   !> A survey under every name by which a run would reach it.
   subroutine test_inputs()
      call survive('mkdir -p '//results_path//' && mv '//survey//' '//results_path//'/summary.csv', 'results/summary.csv')
      call survive('mkdir -p '//results_path//' && mv '//survey//' '//results_path//'/profile_u_soft.csv', &
                   'results/../results/profile_u_soft.csv')
      call survive('mkdir -p '//results_path//' && ln '//survey//' '//results_path//'/limits.csv', 'path.csv')
      call survive('mkdir -p '//results_path//' && ln -s ../path.csv '//results_path//'/results.h5', 'path.csv')
      call survive('mkdir -p '//results_path//' && mv '//survey//' '//results_path//'/profile_s_soft.csv && ln -s '// &
                   'results/profile_s_soft.csv '//survey, 'path.csv')
      call survive('mkdir -p '//results_path//'/pictures && mv '//survey//' '//results_path//'/pictures/path_u.svg', &
                   'results/pictures/path_u.svg')
      call survive('mkdir -p '//results_path//' && mv '//survey//' '//results_path//'/drillgap_files.txt', &
                   'results/drillgap_files.txt')
      call survive('mkdir -p '//scratch//'/elsewhere && ln -s elsewhere '//results_path//' && mv '//survey//' '//scratch// &
                   '/elsewhere/summary.csv', 'elsewhere/summary.csv')
   end subroutine test_inputs

   !> A survey under the name of a file that a killed run was writing stays when those are removed.
   subroutine test_unfinished_input()
      type(run_type) :: run
      character(*), parameter :: name = 'results/summary.csv.7-7.unfinished'
      character(:), allocatable :: deck, before
      deck = replaced(good_deck(), 'md  = 0.0, 500.0, 900.0', "survey_file = '"//name//"'")
      deck = replaced(replaced(deck, 'inc = 0.0, 0.0, 30.0', ''), 'azi = 3*10.0', '')
      run = run_deck_text(deck, '--check')                 ! no survey yet
      call shell('mkdir -p '//results_path//" && printf 'md,inc,azi\n0,0,10\n500,0,10\n900,30,10\n' > "//scratch//'/'//name)
      before = content(scratch//'/'//name)
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(before, content(scratch//'/'//name))
   end subroutine test_unfinished_input

   !> Puts the survey where a command puts it; `name` is how the deck names it. The run is refused and nothing changes.
   subroutine survive(command, name)
      character(*), intent(in) :: command, name
      type(run_type) :: run
      character(:), allocatable :: deck, before
      deck = replaced(good_deck(), ', plots = .false.', '')
      deck = replaced(deck, 'md  = 0.0, 500.0, 900.0', "survey_file = '"//name//"'")
      deck = replaced(replaced(deck, 'inc = 0.0, 0.0, 30.0', ''), 'azi = 3*10.0', '')
      run = run_deck_text(deck, '--check')                 ! no survey yet
      call assertEqual(2, run%status)
      call shell("printf 'md,inc,azi\n0,0,10\n500,0,10\n900,30,10\n' > "//survey//' && '//command)
      before = content(scratch//'/'//name)
      call assertTrue(index(before, '900,30,10') > 0, message=command)
      run = run_program(deck_path//' --check --output '//results_path)
      call assertEqual(2, run%status, message='--check: '//command)
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(2, run%status, message=command)
      call assertTrue(index(run%diagnostics, 'would destroy what it reads') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'build/test_command_line/'//name//': the run would ') > 0, message=run%diagnostics)
      call assertEqual(before, content(scratch//'/'//name), message=command)
      call assertEqual(0, count_of('ls '//results_path//'/ | grep -v -x -e summary.csv -e limits.csv -e results.h5 -e pictures '// &
                                   '-e profile_u_soft.csv -e profile_s_soft.csv -e drillgap_files.txt'), &
                       message='written: '//command)
   end subroutine survive

   subroutine test_deck_as_result()
      type(run_type) :: run
      run = run_deck_text(good_deck(), '--check')
      call shell('mkdir -p '//results_path//' && cp '//deck_path//' '//results_path//'/summary.csv')
      run = run_program(results_path//'/summary.csv --output '//results_path)
      call assertEqual(2, run%status, message=run%diagnostics)
      call assertTrue(index(content(results_path//'/summary.csv'), '&job') > 0, message='the deck')
   end subroutine test_deck_as_result

   !> Links under names that only files being written have, or pictures, are not followed.
   subroutine test_links()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), ', plots = .false.', ''), '--check')
      call shell('mkdir -p '//results_path//'/pictures && echo precious > '//scratch//'/victim && cd '//results_path// &
                 ' && for i in summary.csv limits.csv results.h5 profile_u_soft.csv report.html pictures/path_u.svg; do '// &
                 'ln -s $PWD/../victim $i.unfinished; done; for i in path_u.gp path_u.svg hookload.svg all.gp; do '// &
                 'ln -s ../../victim pictures/$i; done')
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('precious'//newline, content(scratch//'/victim'))
      call shell('test -f '//results_path//'/pictures/path_u.gp -a ! -L '//results_path//'/pictures/path_u.gp')
   end subroutine test_links

   !> A file in place of the folder of pictures refuses the run.
   subroutine test_no_folder()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), ', plots = .false.', ''), '--check')
      call shell('mkdir -p '//results_path//' && echo mine > '//results_path//'/pictures')
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(1, run%status)
      call assertTrue(index(run%diagnostics, '/pictures is not a folder; remove it, or give another folder by output_dir') > 0, &
                      message=run%diagnostics)
      call assertEqual('mine'//newline, content(results_path//'/pictures'))
   end subroutine test_no_folder

   !> Links where results are to stand, also dangling ones, refuse the run before anything is solved or written.
   subroutine test_refused_links()
      character(*), parameter :: results(14) = [character(24) :: 'summary.csv', 'limits.csv', 'results.h5', &
         'profile_u_soft.csv', 'contacts_u_soft.csv', 'view_s_soft.hdf', 'hole_u_soft.hdf', 'report.html', 'sweep_s.csv', &
         'sweep_s.partial', 'sweep_s.failed', 'drillgap_files.txt', 'drillgap.lock', 'pictures/gnuplot.log']
      integer :: i
      do i = 1, size(results)
         call refuse(trim(results(i)), 'victim', '', ': link to ')
      end do
      call refuse('summary.csv', 'nowhere', '', ': link to ')
      call refuse('pictures', 'elsewhere', '', 'pictures is a link to ')
      call refuse('pictures', 'nowhere', '', 'pictures is a link to ')
      call refuse('pictures', 'victim', '', 'pictures is a link to ')
      call refuse('pictures', 'elsewhere', '--merge 2', 'pictures is a link to ')
      call refuse('sweep_s.part_1_of_2', 'victim', '--part 1/2', ': link to ')
      call refuse('sweep_s.part_2_of_2', 'nowhere', '--part 1-2/2', ': link to ')
   end subroutine test_refused_links

   !> Puts a link at a name of the output folder; the run is refused and nothing is there that was not.
   subroutine refuse(name, target, options, told)
      character(*), intent(in) :: name, target, options, told
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), ', plots = .false.', '')//sweep//newline, '--check')
      call shell('mkdir -p '//results_path//'/$(dirname '//name//') '//scratch//'/elsewhere && echo precious > '//scratch// &
                 '/victim && ln -s $(realpath '//scratch//')/'//target//' '//results_path//'/'//name//' && find '//scratch// &
                 ' > build/before')
      run = run_program(deck_path//' --check '//options//' --output '//results_path)
      call assertEqual(1, run%status, message='--check: '//name//' '//run%diagnostics)
      run = run_program(deck_path//' '//options//' --output '//results_path)
      call assertEqual(1, run%status, message=name//' '//run%diagnostics)
      call assertTrue(index(run%diagnostics, told) > 0, message=run%diagnostics)
      call assertEqual('precious'//newline, content(scratch//'/victim'))
      call shell('find '//scratch//' | diff build/before - && test -L '//results_path//'/'//name)
   end subroutine refuse

   !> While a run holds the folder another is refused, and is told by whom. Another folder takes it, and the same one afterwards.
   subroutine test_two_runs()
      character(*), parameter :: short = 'build/test_short_deck.nml'
      type(run_type) :: run
      run = run_deck_text(good_deck(), '--check')
      call shell('cp '//deck_path//' '//short)
      run = run_deck_text(long_deck(), '--check')
      call start('', 'profile_u_mcge.csv')
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(1, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'is in use by another run: process ') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, ' since 2') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, '; wait for its end, or give another folder by --output') > 0, &
                      message=run%diagnostics)
      run = run_program(short//' --output '//scratch//'/another')
      call assertEqual(0, run%status, message=run%diagnostics)
      ! by another way, and as a part: refused as well
      run = run_program(deck_path//' --output '//results_path//'/../results/.')
      call assertEqual(1, run%status, message=run%diagnostics)
      run = run_program(deck_path//' --part 1/2 --output '//results_path)
      call assertEqual(1, run%status, message=run%diagnostics)
      run = run_program(deck_path//' --check --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call stop_run('TERM')
      call assertEqual(0, count_of('ls '//results_path//' | grep lock'), message='the lock')
      run = run_program(short//' --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_two_runs

   !> Parts of a sweep run side by side, but not twice the same, and no whole run beside them.
   subroutine test_parts()
      type(run_type) :: run
      run = run_deck_text(replaced(long_deck(), "operations = 'up'", "operations = 'up', 'down'"), '--check')
      call start('--part 1/2', 'sweep_s.part_1_of_2')
      run = run_program(deck_path//' --part 1/2 --output '//results_path)
      call assertEqual(1, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'process ') > 0 .and. index(run%diagnostics, ', part 1 of 2') > 0, &
                      message=run%diagnostics)
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(1, run%status, message=run%diagnostics)
      run = run_program(deck_path//' --merge 2 --output '//results_path)
      call assertEqual(1, run%status, message=run%diagnostics)
      run = run_interrupted('--part 2/2', is_result('sweep_s.part_2_of_2'), 'INT')
      call assertTrue(index(run%diagnostics, 'ended by SIGINT') > 0, message=run%diagnostics)
      call stop_run('TERM')
      call assertEqual(0, count_of('ls '//results_path//' | grep lock'), message='the lock')
   end subroutine test_parts

   !> A run that is killed holds nothing; what it was writing goes with the next run.
   subroutine test_killed()
      type(run_type) :: run
      run = run_deck_text(long_deck(), '--check')
      call start('', 'profile_u_mcge.csv')
      call stop_run('KILL')
      call shell('echo half > '//results_path//'/limits.csv.123-456.unfinished; echo mine > '//results_path//'/mine.unfinished')
      call shell('test -e '//results_path//'/profile_u_mcge.csv')
      run = run_again(good_deck())
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('drillgap_files.txt limits.csv mine.unfinished profile_s_soft.csv profile_u_soft.csv results.h5 '// &
                       'summary.csv ', listing())
   end subroutine test_killed

   !> Cases, models, sweeps, pictures that an earlier run left under other names.
   subroutine test_leftovers()
      type(run_type) :: run
      run = run_deck_text(replaced(replaced(good_deck(), ', plots = .false.', ''), "'soft'", "'soft', 'rigid'")//sweep//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call shell('test -e '//results_path//'/sweep_s.csv -a -e '//results_path//'/pictures/path_s.svg -a -e '//results_path// &
                 '/profile_s_rigid.csv')
      run = run_again(replaced(replaced(good_deck(), 'plots = .false.', 'plots = .false., hdf5 = .false.'), "name = 's', op", &
                               "name = 't', op"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('drillgap_files.txt limits.csv profile_t_soft.csv profile_u_soft.csv summary.csv ', listing())
      run = run_again(replaced(good_deck(), 'title', 'profiles = .false., title'))
      call assertEqual('drillgap_files.txt limits.csv results.h5 summary.csv ', listing())
   end subroutine test_leftovers

   !> Files that no run has written stay, whatever they are called and whatever a list of files says.
   subroutine test_strangers()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), ', plots = .false.', ''))
      call assertEqual(0, run%status, message=run%diagnostics)
      call shell('cd '//results_path//' && echo mine | tee profile_mine_soft.csv notes.csv pictures/mine.svg sweep_mine.csv '// &
                 '../victim.csv ../profile_x_soft.csv > legacy_mine.csv && mkdir ../other && '// &
                 'echo mine > ../other/path_x.svg && rm profile_u_soft.csv && ln -s ../victim.csv profile_u_soft.csv && '// &
                 'printf ''../victim.csv\n../profile_x_soft.csv\npictures/../../victim.csv\n/etc/passwd\nnotes.csv\n.\n..\n\n'// &
                 'pictures\nview_$(id)_soft.hdf\n'' >> drillgap_files.txt')
      run = run_again(replaced(replaced(good_deck(), "name = 'u', op", "name = 'v', op"), 'title', 'profiles = .false., title'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('drillgap_files.txt legacy_mine.csv limits.csv notes.csv pictures profile_mine_soft.csv '// &
                       'profile_u_soft.csv results.h5 summary.csv sweep_mine.csv ', listing())
      call shell('test "$(ls '//results_path//'/pictures)" = mine.svg')
      call shell('test -e '//scratch//'/victim.csv -a -e '//scratch//'/profile_x_soft.csv')
      ! pictures that stand elsewhere, behind a link, stay, too
      call shell('cd '//results_path//' && rm -r pictures profile_u_soft.csv && ln -s ../other pictures && '// &
                 'echo pictures/path_x.svg >> drillgap_files.txt')
      run = run_again(good_deck())
      call assertEqual(0, run%status, message=run%diagnostics)
      call shell('test -e '//scratch//'/other/path_x.svg')
   end subroutine test_strangers

   !> The list names every file of a run with everything, and no other.
   subroutine test_list()
      type(run_type) :: run
      character(:), allocatable :: deck
      deck = replaced(replaced(good_deck(), ', plots = .false.', ''), 'element_length = 10.0', &
                      'element_length = 30.0, history = .true.')//sweep//newline//"&calibrate separate = 'none' /"//newline// &
             "&study cases = 'u', element_lengths = 10, 30 /"//newline//"&uncertainty name = 'n', operations = 'up', "// &
             "bit_depth_from = 800, bit_depth_step = 100, samples = 3, friction_deviation = 0.02 /"//newline// &
             "&legacy label = 'l', file = 'l.csv', case = 'u', axial = 'axial' /"//newline
      deck = replaced(replaced(deck, '  bit_depth = 900.0 /', '  bit_depth = 900.0, measured_hookload = 250 /'), "'soft'", "'mcge'")
      run = run_deck_text(deck, '--check')
      call shell("printf 'md,axial\n0,250\n900,0\n' > "//scratch//'/l.csv')
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call shell('cd '//results_path//' && find * -type f | grep -v drillgap_files.txt | sort > ../found && '// &
                 'tail -n +2 drillgap_files.txt | sort > ../listed && cmp ../found ../listed')
      call assertTrue(count_of('cat '//scratch//'/found') > 20, message='files')
   end subroutine test_list

   !> Starts the deck in the scratch folder in the background and waits for one of its files.
   subroutine start(options, file)
      character(*), intent(in) :: options, file
      call shell("'"//program_path()//"' "//deck_path//' --threads 1 --output '//results_path//' '//options//' > '//scratch// &
                 '/first.txt 2>&1 & echo $! > '//scratch//'/pid; '//until(is_result(file))//'; '//is_result(file))
   end subroutine start

   !> Ends it by a signal, and waits for its end.
   subroutine stop_run(signal)
      character(*), intent(in) :: signal
      character(*), parameter :: pid = '$(cat '//scratch//'/pid)'
      ! gone, or a child whose end nobody has asked for
      character(*), parameter :: ended = '{ ! kill -0 '//pid//' 2> /dev/null || grep -q "^State:.Z" /proc/'//pid//'/status; }'
      call shell('kill -'//signal//' '//pid//'; '//until(ended)//'; '//ended)
   end subroutine stop_run

   !> Runs another deck in the folder that is there.
   function run_again(text) result(run)
      character(*), intent(in) :: text
      type(run_type) :: run
      integer :: unit
      open (newunit=unit, file=deck_path, action='write', status='replace')
      write (unit, '(a)') text
      close (unit)
      run = run_program(deck_path//' --output '//results_path)
   end function run_again

   !> A deck of one short case and one that takes minutes.
   function long_deck() result(deck)
      character(:), allocatable :: deck
      deck = replaced(replaced(good_deck(), "'soft'", "'mcge'"), 'element_length = 10.0', 'element_length = 0.05')
      deck = replaced(replaced(deck, "operation = 'up'", "operation = 'static'"), '  bit_depth = 900.0', '  bit_depth = 105.0')
      deck = deck//sweep//newline
   end function long_deck

   !> Names in the output folder, a blank after each.
   function listing() result(names)
      character(:), allocatable :: names
      integer :: i
      call shell('ls '//results_path//' > '//scratch//'/listing')
      names = content(scratch//'/listing')
      do i = 1, len(names)
         if (names(i:i) == newline) names(i:i) = ' '
      end do
   end function listing

   !> Lines that a command prints.
   function count_of(command) result(lines)
      character(*), intent(in) :: command
      integer :: lines
      character(:), allocatable :: text
      integer :: i, status
      call execute_command_line(command//' > '//scratch//'/counted', exitstat=status)
      text = content(scratch//'/counted')
      lines = 0
      do i = 1, len(text)
         if (text(i:i) == newline) lines = lines + 1
      end do
   end function count_of

   !> A command that must succeed.
   subroutine shell(command)
      character(*), intent(in) :: command
      integer :: status, command_status
      call execute_command_line(command, exitstat=status, cmdstat=command_status)
      call assertEqual(0, abs(status) + abs(command_status), message=command)
   end subroutine shell
end module dg_test_output_folder
