!> Advice of messages about a solved case: it is followed, and the message is gone. Decks are wells that had the message, with as
!> few stations as keep it.
module dg_test_followed_advice
   use funit, only: anyExceptions, assertEqual, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_folder, only: make_folder
   use dg_kinds, only: wp
   use dg_program_run, only: content, deck_path, good_deck, replaced, results_path, run_deck_text, run_program, run_type, scratch, &
                             unwrapped
   use dg_result_rows, only: lines_of, number
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: followed_advice_suite

   character(*), parameter :: newline = achar(10)

contains

   function followed_advice_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('followed_advice')
      call suite%addTest(TestMethod('short_elements', test_short_elements))
      call suite%addTest(TestMethod('moments_of_a_steep_string', test_steep))
      call suite%addTest(TestMethod('settings', test_settings))
      call suite%addTest(TestMethod('model_of_a_buckled_string', test_model))
      call suite%addTest(TestMethod('friction_above_a_stuck_point', test_sticking))
      call suite%addTest(TestMethod('not_converged', test_not_converged))
      call suite%addTest(TestMethod('bowed_pipe', test_bowed_pipe))
      call suite%addTest(TestMethod('arguments', test_arguments))
      call suite%addTest(TestMethod('folders', test_folders))
      call suite%addTest(TestMethod('in_the_way_of_results', test_in_the_way))
      call suite%addTest(TestMethod('record_of_an_earlier_run', test_record))
   end function followed_advice_suite

   !> A deck has the message `expected` in its results; with `fault` changed to `remedy` it converges without it.
   subroutine follow(text, expected, fault, remedy, status)
      character(*), intent(in) :: text, expected, fault, remedy
      integer, intent(in) :: status           !< of the first run
      type(run_type) :: run
      character(:), allocatable :: summary
      run = run_deck_text(text)
      summary = content(results_path//'/summary.csv')
      call assertEqual(status, run%status, message=run%diagnostics)
      call assertTrue(index(summary, expected) > 0, message='wanted: '//expected//'; got: '//summary)
      run = run_deck_text(replaced(text, fault, remedy))
      summary = content(results_path//'/summary.csv')
      call assertEqual(0, run%status, message='followed: '//expected//'; got: '//run%diagnostics)
      call assertEqual(0, index(summary, expected), message='followed: '//summary)
   end subroutine follow

   !> Shorter elements where the string is outside its hole, or has contact at the wrong place; halved ones where moments are rough.
   subroutine test_short_elements()
      character(*), parameter :: job = "&job models = 'mcge', plots = .false., hdf5 = .false., profiles = .false. /"//newline
      character(*), parameter :: solver = "&solver element_length = 30 /"//newline
      call follow(job//"&trajectory md = 0, 100, 115, 300, inc = 0, 0, 40, 40, azi = 4*0 /"//newline// &
                  "&hole diameter = 216, friction = 0.3 /"//newline//"&fluid density = 1200 /"//newline// &
                  "&component od = 165, id = 71.4, joint_od = 212 /"//newline// &
                  "&load_case name = 'c', operation = 'trip_in', bit_depth = 250 /"//newline//solver, &
                  'Set element_length to 12 m in &solver, which helps most strings', '= 30 /', '= 12 /', 0)
      call follow(job//large_hole()//solver, 'An element_length of 1.5 m gives most strings contact points where', &
                  '= 30 /', '= 1.5 /', 0)
      call follow(job//"&trajectory md = 0, 600, inc = 30, 30, azi = 0, 0 /"//newline//"&hole md_bottom = 500, diameter = 224 /"// &
                  newline//"&hole diameter = 216 /"//newline//"&component od = 127, id = 108.6, joint_od = 168 /"//newline// &
                  "&load_case name = 'c', operation = 'trip_out', bit_depth = 595.27 /"//newline// &
                  "&solver tool_joints = 'discrete' /"//newline, &
                  'A tool joint ends at 500.02 m, where the hole changes its diameter. Moments there depend on which side the '// &
                  'joint lies. Compare with a bit_depth 0.5 m deeper', '595.27', '595.77', 0)
      call follow(job//rods()//"&solver /"//newline, "of the largest. Set fidelity = 'reference'", '&solver', &
                  "&solver fidelity = 'reference'", 0)
   end subroutine test_short_elements

   !> Tubing that crosses a wide hole slopes too much for short elements to give its moments; a smaller element_length makes them
   !> better, 6 m above the bit from a sixth of what they are to 1 %.
   subroutine test_steep()
      character(*), parameter :: advice = 'slopes by more than a tenth against its hole there, and they are those of '// &
                                          'elements of up to '
      real(wp), parameter :: depth = 212.0_wp    ! m
      real(wp) :: coarse, fine, finest
      coarse = bending('25', depth)
      fine = bending('2', depth)
      finest = bending('0.5', depth)
      call assertTrue(abs(coarse - finest) > 0.5_wp*finest, message='coarse: '//to_text(coarse)//' '//to_text(finest))
      call assertTrue(abs(fine - finest) < 0.01_wp*finest, message='fine: '//to_text(fine)//' '//to_text(finest))
   contains
      !> Bending moment by an element length [kN.m].
      function bending(length, md) result(moment)
         character(*), intent(in) :: length     !< [m]
         real(wp), intent(in) :: md             !< [m]
         real(wp) :: moment
         integer, parameter :: col_bending = 10
         type(run_type) :: run
         type(text_type), allocatable :: rows(:)
         real(wp) :: above, below
         integer :: i
         run = run_deck_text("&job models = 'mcge', plots = .false., hdf5 = .false. /"//newline// &
                             "&trajectory md = 0, 100, 118, 218, inc = 0, 0, 60, 60, azi = 4*40 /"//newline// &
                             "&hole diameter = 2060, friction = 0.2 /"//newline//"&component od = 60.3, id = 50.7 /"//newline// &
                             "&load_case name = 'c', operation = 'trip_out', bit_depth = 218 /"//newline// &
                             "&solver element_length = "//length//" /"//newline)
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertTrue(index(unwrapped(run%output), advice//length//' m. A smaller element_length') > 0, message=run%output)
         moment = 0.0_wp
         rows = lines_of(results_path//'/profile_c_mcge.csv')
         if (anyExceptions()) return
         do i = 3, size(rows)
            above = number(rows(i - 1)%text, 1)
            below = number(rows(i)%text, 1)
            if (below < md) cycle
            moment = number(rows(i - 1)%text, col_bending)
            moment = moment + (number(rows(i)%text, col_bending) - moment)*(md - above)/(below - above)
            return
         end do
      end function bending
   end subroutine test_steep

   !> Settings that a deck has made too coarse.
   subroutine test_settings()
      character(*), parameter :: open = 'element_length = 10.0, r_n0 = 1'
      character(:), allocatable :: deck
      deck = replaced(good_deck(), "'soft'", "'mcge', profiles = .false.")
      call follow(replaced(deck, 'element_length = 10.0', open), 'Set r_n0 to 1e-6 kN, its default', 'r_n0 = 1', 'r_n0 = 1e-6', 3)
      call follow(replaced(deck, 'element_length = 10.0', 'max_iterations = 1'), 'Set max_iterations to 1300, its default', &
                  'max_iterations = 1', 'max_iterations = 1300', 3)
      call follow(replaced(deck, 'diameter = 215.9', 'diameter = 215.9, wall_stiffness = 1'), &
                  'Set wall_stiffness to 1e8 kN/m2, the default', 'wall_stiffness = 1', 'wall_stiffness = 1e8', 0)
   end subroutine test_settings

   !> A soft string does not know what a coil presses.
   subroutine test_model()
      call follow(replaced(good_deck(), 'wob = 20.0', 'wob = 220.0'), 'outside the range of this model. Contact there is too '// &
                  'low. Use model mcge', "'soft'", "'mcge'", 0)
   end subroutine test_model

   !> Less torque than friction above the point takes.
   subroutine test_sticking()
      character(*), parameter :: advice = '! less torque was measured than friction above the point takes. Lower the friction'
      character(:), allocatable :: deck
      type(run_type) :: run
      deck = replaced(good_deck(), "name = 's', operation = 'sliding', bit_depth = 800.0", &
                      "name = 's', operation = 'rotate_off_bottom', bit_depth = 800.0, measured_hookload = 250, "// &
                      "measured_torque = 0.5")//"&calibrate parameter = 'sticking', cases = 's', sticking_depth = 780 /"//newline
      run = run_deck_text(deck)
      call assertTrue(index(run%output, advice) > 0, message=run%output//run%diagnostics)
      run = run_deck_text(replaced(deck, 'diameter = 215.9, friction = 0.3', 'diameter = 215.9, friction = 0.02'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, advice), message=run%output)
   end subroutine test_sticking

   !> Advice on a case that does not converge. Model soft gives its hook load: a torque on bit of 5000 kft.lbf. A case that
   !> converges one day needs another in its place.
   subroutine test_not_converged()
      character(*), parameter :: advice = 'Check the loads of this case: no setting of &solver is known to help. '// &
                                         'Model soft solves it without bending stiffness'
      call follow("&job units = 'field', models = 'mcge', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
                  '&trajectory md = 0, 2000, 8200, 9200, 15000, inc = 0, 0, 0, 90, 90, azi = 5*178 /'//newline// &
                  '&hole diameter = 8.5, friction = 0.3 /'//newline//'&fluid density = 9.6 /'//newline// &
                  '&component od = 5, id = 4.276, mass = 20.87, joint_od = 6.625 /'//newline// &
                  "&load_case name = 'c', operation = 'rotary', bit_depth = 15000, wob = 20, tob = 5000 /"//newline, advice, &
                  "'mcge'", "'soft'", 3)
   end subroutine test_not_converged

   !> Pipe that rubs between its joints where it is buckled: its hook load or torque changes, or it locks up. No such message for
   !> joints that fill their spacing, and for pipe with centralizers.
   subroutine test_bowed_pipe()
      character(*), parameter :: left_out = 'Smeared tool joints leave out the friction of buckled pipe between them', &
                                 sliding = "'sliding_drilling'", &
                                 unsure = 'UNCERTAIN: smeared tool joints leave out friction'
      type(run_type) :: run
      call follow(slid_pipe('140'), left_out//', roughly 21 kN of hook load, by beams often more. Set tool_joints', &
                  "'smeared'", "'discrete'", 0)
      call follow(slid_pipe('260'), left_out//'. The string may lock up by it. Set tool_joints', &
                  "'smeared'", "'discrete'", 0)
      call follow(replaced(slid_pipe('60'), 'inc = 0, 0', 'inc = 80, 80'), left_out//'. It may be a tenth of the weight. '// &
                  'Set tool_joints', "'smeared'", "'discrete'", 0)
      call follow(replaced(slid_pipe('140'), sliding, "'rotary_drilling'"), ' of torque. Set tool_joints', "'smeared'", &
                  "'discrete'", 0)
      run = run_deck_text(longer(slid_pipe('140'), '1200'))
      call assertTrue(index(unwrapped(run%output), unsure) > 0, message=run%output)
      run = run_deck_text(replaced(longer(slid_pipe('140'), '1200'), "'smeared'", "'discrete'"))
      call assertEqual(0, index(unwrapped(run%output), unsure), message=run%output)
      run = run_deck_text(longer(slid_pipe('140'), '3000'))
      call assertEqual(0, index(unwrapped(run%output), unsure), message='more is left than friction can take: '//run%output)
      run = run_deck_text(replaced(longer(slid_pipe('140'), '1200'), "'smeared'", "'auto'"))
      call assertEqual(0, index(unwrapped(run%output), unsure), message='joints one by one where it matters: '//run%output)
      call assertTrue(index(run%output, 'tool joints one by one in 1 case, as compressed pipe bows') > 0, message=run%output)
      run = run_deck_text(replaced(longer(slid_pipe('0'), '1200'), "'smeared'", "'auto'"))
      call assertEqual(0, index(run%output, 'one by one'), message='not where nothing is buckled: '//run%output)
      run = run_deck_text(replaced(slid_pipe('140'), 'joint_length = 0.45', 'joint_length = 9.5'))
      call assertEqual(0, index(content(results_path//'/summary.csv'), left_out), message='joints that fill their spacing')
      run = run_deck_text(replaced(slid_pipe('140'), '&component od', &
         "&centralizer component = 'dp', kind = 'rigid', od = 145, spacing = 9.5 /"//newline//"&component name = 'dp', od"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(content(results_path//'/summary.csv'), left_out), message='centralizers')
   contains
      !> The deck with a longer string.
      function longer(deck, depth) result(text)
         character(*), intent(in) :: deck, depth
         character(:), allocatable :: text
         text = replaced(replaced(deck, 'md = 0, 300', 'md = 0, '//depth), 'bit_depth = 300', 'bit_depth = '//depth)
      end function longer
   end subroutine test_bowed_pipe

   !> Deck of pipe that is slid down a vertical hole.
   pure function slid_pipe(wob) result(text)
      character(*), intent(in) :: wob       !< [kN]
      character(:), allocatable :: text
      text = "&job models = 'mcge', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             '&trajectory md = 0, 300, inc = 0, 0, azi = 0, 0 /'//newline// &
             '&hole diameter = 155, friction = 0.4 /'//newline//'&fluid density = 1200 /'//newline// &
             '&component od = 88.9, id = 70.2, mass = 21, joint_od = 127, joint_length = 0.45 /'//newline// &
             "&load_case name = 'c', operation = 'sliding_drilling', bit_depth = 300, wob = "//wob//' /'//newline// &
             "&solver tool_joints = 'smeared' /"//newline
   end function slid_pipe

   !> Arguments of the program.
   subroutine test_arguments()
      call obey('--threads many', 'Give 0 (all cores) to 9999', '--threads 0')
      call obey('--part 5/4', 'Give i/n with i from 1 to n, as in --part 2/4', '--part 2/4')
      call obey('--merge x', 'Give 1 to 9999, as in --merge 4', '--merge 4')
      call obey('other.nml', '. Give one', '')
      call obey('--chekc', "did you mean '--check'?", '--check')
      call obey('--check=yes', 'takes no value. Write --check', '--check')
      call obey('--part 1/2 --merge 2', 'Join the parts when all are there', '--part 1/2')
      call act('--convert', 'a deck, as in --convert', '--convert '//deck_path)
      call act('--convert '//deck_path//' furlong', 'takes one deck and units, as SI, field', '--convert '//deck_path//' field')
      call act('--template furlong', 'Units are SI, field', '--template field')
      call act('--well 1 '//deck_path, 'go with --import', deck_path//' --check')
      call act('', 'no deck given. Write drillgap DECK.nml', deck_path//' --check')
      call act("''", 'the name of the deck is empty. Give a file', deck_path//' --check')
      call act(deck_path//' --output', '--output needs a value, as in --output ', deck_path//' --check --output '//results_path)
      call act('--template --convert', 'exclude each other. Give one', '--template')
      call act('--template=field', 'after --template comes a blank, not =', '--template field')
      call act('/dev/zero --check', 'it is a device; give a file', deck_path//' --check')
      call shell('mkfifo '//scratch//'/pipe')
      call act(scratch//'/pipe --check', 'it is a pipe; give a file', deck_path//' --check')
   contains
      subroutine obey(option, expected, remedy)
         character(*), intent(in) :: option, expected, remedy
         character(*), parameter :: sweep = "&sweep operations = 'up', bit_depth_to = 900, bit_depth_step = 300 /"//newline
         type(run_type) :: run
         run = run_deck_text(good_deck()//sweep, '--check '//option)
         call assertEqual(2, run%status, message=option)
         call assertTrue(index(run%diagnostics, expected) > 0, message=run%diagnostics)
         run = run_program(scratch//'/deck.nml --check '//remedy)
         call assertEqual(0, run%status, message=remedy//': '//run%diagnostics)
         call assertEqual(0, index(run%diagnostics, expected), message=run%diagnostics)
      end subroutine obey

      !> An option that prints a deck, with what it lacks.
      subroutine act(fault, expected, remedy)
         character(*), intent(in) :: fault, expected, remedy
         type(run_type) :: run
         run = run_program(fault)
         call assertEqual(2, run%status, message=fault)
         call assertTrue(index(run%diagnostics, expected) > 0, message=run%diagnostics)
         run = run_program(remedy)
         call assertEqual(0, run%status, message=remedy//': '//run%diagnostics)
      end subroutine act
   end subroutine test_arguments

   !> The folder of results: unnamed, not to be written into, or with a folder in place of its lock. Options without use in a deck
   !> that has no sweep.
   subroutine test_folders()
      character(*), parameter :: lock = results_path//'/drillgap.lock'
      type(run_type) :: run
      type(error_type), allocatable :: error
      run = run_deck_text(good_deck(), '--check')
      call obey('- < '//deck_path, 'Give output_dir in &job, or --output DIR', '- --output '//results_path//' < '//deck_path)
      call obey(deck_path//' --check --again', 'every run: leave --again out', deck_path//' --check')
      call obey(deck_path//' --check --part 1/2', 'nothing else can be divided into parts', deck_path//' --check')
      call obey(deck_path//' --output /proc', 'cannot write into the output folder /proc', &
                deck_path//' --output '//results_path)
      call make_folder(lock, error)
      call obey(deck_path//' --output '//results_path, lock//' is not a file; remove it', &
                deck_path//' --output '//results_path, remove=lock)
   contains
      subroutine obey(arguments, expected, remedy, remove)
         character(*), intent(in) :: arguments, expected, remedy
         character(*), intent(in), optional :: remove      !< folder
         integer :: status
         run = run_program(arguments)
         call assertTrue(run%status > 0, message=arguments)
         call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
         if (present(remove)) call execute_command_line('rmdir '//remove, exitstat=status)
         run = run_program(remedy)
         call assertEqual(0, run%status, message=remedy//': '//run%diagnostics)
         call assertEqual(0, index(run%diagnostics, expected), message=run%diagnostics)
      end subroutine obey
   end subroutine test_folders

   !> Files in the way of a run's results. The advice removes them, or names another folder.
   subroutine test_in_the_way()
      character(*), parameter :: folder = '; remove it, or give another folder by output_dir or --output'
      character(*), parameter :: results = ' --output '//results_path, other = ' --output '//scratch//'/other'
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), ', plots = .false.', ''), '--check')
      call shell('mkdir -p '//results_path)
      call clear_way('echo mine > '//results_path//'/pictures', '/pictures is not a folder'//folder, '/pictures')
      call clear_way('mkdir '//scratch//'/else; ln -s ../else '//results_path//'/pictures', 'remove the link, or give another', &
                     '/pictures')
      call clear_way('ln -s nowhere '//results_path//'/summary.csv', 'remove them, or give another folder', '/summary.csv')
      call shell('cp '//deck_path//' '//results_path//'/summary.csv')
      run = run_program(results_path//'/summary.csv --check'//results)
      call assertTrue(index(run%diagnostics, 'give another folder by output_dir or --output, or move the file') > 0, &
                      message=run%diagnostics)
      run = run_program(results_path//'/summary.csv --check'//other)
      call assertEqual(0, run%status, message=run%diagnostics)
      call shell('mv '//results_path//'/summary.csv '//scratch//'/moved.nml')
      run = run_program(scratch//'/moved.nml --check'//results)
      call assertEqual(0, run%status, message=run%diagnostics)
   contains
      !> `put` puts something in the way, which is `name` of the folder.
      subroutine clear_way(put, expected, name)
         character(*), intent(in) :: put, expected, name
         call shell(put)
         run = run_program(deck_path//' --check'//results)
         call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
         run = run_program(deck_path//' --check'//other)
         call assertEqual(0, run%status, message=run%diagnostics)
         call shell('rm '//results_path//name)
         run = run_program(deck_path//' --check'//results)
         call assertEqual(0, run%status, message=run%diagnostics)
      end subroutine clear_way
   end subroutine test_in_the_way

   !> A record that no sweep of the deck goes on with.
   subroutine test_record()
      character(*), parameter :: advice = 'is unfinished work of an earlier run; remove it if it is not needed'
      type(run_type) :: run
      run = run_deck_text(good_deck())
      call shell('echo > '//results_path//'/sweep_old.partial')
      run = run_program(deck_path//' --output '//results_path)
      call assertTrue(index(run%diagnostics, 'sweep_old.partial '//advice) > 0, message=run%diagnostics)
      call shell('rm '//results_path//'/sweep_old.partial')
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(0, index(run%diagnostics, advice), message=run%diagnostics)
   end subroutine test_record

   subroutine shell(command)
      character(*), intent(in) :: command
      integer :: status
      call execute_command_line(command, exitstat=status)
      call assertEqual(0, status, message=command)
   end subroutine shell

   !> Collars and a stabiliser in a hole of half a metre.
   pure function large_hole() result(text)
      character(:), allocatable :: text
      text = "&trajectory md = 0, 804.6, 825.93, 861.67, 870.72, inc = 0.36, 12.94, 12.91, 14.01, 13.57"//newline// &
             "  azi = 85.95, 263.36, 260.92, 259.34, 257.6 /"//newline// &
             "&hole md_bottom = 139.8, diameter = 475, friction = 0.3 /"//newline// &
             "&hole diameter = 489, friction = 0.58 /"//newline// &
             "&fluid density = 1550 /"//newline// &
             "&component length = 9, od = 234.9, id = 76.2, mass = 275.08 /"//newline// &
             "&component length = 9, od = 241.3, id = 76.2, mass = 271.46 /"//newline// &
             "&component length = 3, od = 234.9, id = 76.2, mass = 288.92 /"//newline// &
             "&component length = 2.5, od = 234.9, id = 76.2, mass = 278.85 /"//newline// &
             "&component length = 9, od = 241.3, id = 76.2, mass = 264.55 /"//newline// &
             "&component length = 9, od = 234.9, id = 76.2, mass = 306.71 /"//newline// &
             "&component length = 9, od = 234.9, id = 76.2, mass = 316.51 /"//newline// &
             "&component length = 27, od = 241.3, id = 76.2, mass = 280.23 /"//newline// &
             "&component length = 9.5, od = 241.3, id = 76.2, mass = 304.48 /"//newline// &
             "&component kind = 'stabilizer', length = 2, od = 241.3, id = 76.2, mass = 355.5, joint_od = 431.8 /"//newline// &
             "&component od = 168.3, id = 151.5, mass = 41, joint_od = 209.6 /"//newline// &
             "&load_case name = 'c', operation = 'trip_in', bit_depth = 870.72 /"//newline
   end function large_hole

   !> Sucker rods pulled from a stuck pump.
   pure function rods() result(text)
      character(:), allocatable :: text
      text = "&trajectory md = 0, 1620.08, 3240.161, 4860.241, inc = 0, 0.0584, 1.467, 0.5454, azi = 4*228.9709 /"//newline// &
             "&hole diameter = 62, friction = 0.21 /"//newline// &
             "&fluid density = 1400 /"//newline// &
             "&component length = 100, od = 38.1, id = 0, mass = 8.9 /"//newline// &
             "&component length = 2430.1, od = 22.2, id = 0, mass = 3.3, joint_od = 46, joint_length = 0.1"//newline// &
             "  joint_spacing = 7.62 /"//newline// &
             "&component od = 25.4, id = 0, mass = 4.3 /"//newline// &
             "&boundary top_lateral = 'free', bit_lateral = 'free' /"//newline// &
             "&load_case name = 'c', operation = 'trip_out', bit_depth = 4860.241, wob = -12.24 /"//newline
   end function rods

end module dg_test_followed_advice
