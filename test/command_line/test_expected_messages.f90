!> Messages that no other test expects: each is one change to a deck that is right, or one command line.
module dg_test_expected_messages
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: good_deck, replaced, run_deck_text, run_program, run_type
   implicit none
   private
   public :: expected_messages_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: boundary = "&boundary top_lateral = 'centred' /"

contains

   function expected_messages_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('expected_messages')
      call suite%addTest(TestMethod('command_line', test_command_line))
      call suite%addTest(TestMethod('form', test_form))
      call suite%addTest(TestMethod('well_and_string', test_well))
      call suite%addTest(TestMethod('studies', test_studies))
      call suite%addTest(TestMethod('notes', test_notes))
      call suite%addTest(TestMethod('no_solution', test_no_solution))
   end function expected_messages_suite

   !> The good deck with `old` changed to `new` is refused with `expected`.
   subroutine refuse(old, new, expected)
      character(*), intent(in) :: old, new, expected
      call check(old, new, expected, 2)
   end subroutine refuse

   !> It passes with a note that holds `expected`.
   subroutine note(old, new, expected)
      character(*), intent(in) :: old, new, expected
      call check(old, new, expected, 0)
   end subroutine note

   subroutine check(old, new, expected, status)
      character(*), intent(in) :: old, new, expected
      integer, intent(in) :: status
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), old, new), '--check')
      call assertEqual(status, run%status, message=new//': '//run%diagnostics)
      call assertTrue(index(run%output//run%diagnostics, expected) > 0, &
                      message='wanted: '//expected//'; got: '//run%output//run%diagnostics)
   end subroutine check

   !> One line on standard error.
   subroutine refuse_line(arguments, expected)
      character(*), intent(in) :: arguments, expected
      type(run_type) :: run
      run = run_program(arguments)
      call assertEqual(2, run%status, message=arguments)
      call assertEqual('drillgap: '//expected//' See drillgap --help'//newline, run%diagnostics)
   end subroutine refuse_line

   subroutine test_command_line()
      call refuse_line('', 'no deck given. Write drillgap DECK.nml.')
      call refuse_line('--template=field', 'after --template comes a blank, not =.')
      call refuse_line('--template --convert', '--convert and --template exclude each other. Give one.')
      call refuse_line('--template foo', '--template takes no deck and no units ''foo''. Units are SI, field, metric.')
      call refuse_line('--part 1/2 --merge 2 d.nml', '--part and --merge exclude each other. Join the parts when all are there.')
   end subroutine test_command_line

   subroutine test_form()
      call refuse('&boundary top', '&boundary = top', "'=' without a key before it; write key = value")
      call refuse('wob = 20.0', 'wob =', 'wob: no value; write wob = value')
      call refuse('element_length = 10.0 /', 'element_length = 10.0', 'group &solver: not closed; end it with /')
      call refuse("&hole md_top = 0.0, md_bottom = 400.0"//newline//"  diameter = 220.0, friction = 0.25 /"//newline// &
                  "&hole md_top = 400.0, md_bottom = 900.0"//newline//"  diameter = 215.9, friction = 0.3 /", '', &
                  'group &hole: missing; a deck needs it (')
   end subroutine test_form

   subroutine test_well()
      call refuse('md  = 0.0, 500.0', "md_column = 'MD', md = 0.0, 500.0", 'md_column has no meaning without survey_file. Leave')
      call refuse('md  = 0.0, 500.0', "parent_file = '', md = 0.0, 500.0", 'parent_file is empty. Give a path relative to the')
      call refuse('md  = 0.0, 500.0, 900.0'//newline//'  inc = 0.0, 0.0, 30.0'//newline//'  azi = 3*10.0', &
                  'md = 900, inc = 0, azi = 0', 'md holds 1 station; at least two are needed')
      call refuse(', md_bottom = 400.0'//newline//'  diameter = 220.0, friction = 0.25 /'//newline//'&hole md_top = 400.0,', &
                  ' diameter = 220.0 / &hole', 'key md_bottom is missing, and the next section has no md_top; give one of them')
      call refuse('density = 1200.0', 'density = 1200.0, md_top = 100, above_bit = 100', &
                  'md_top, tvd_top and above_bit all say where the fluid begins; keep one')
      call refuse(boundary, "&centralizer component = 'collars', kind = 'rigid', od = 200, spacing = 10, restoring_force = 1 /", &
                  'group &centralizer: restoring_force has no meaning')
      call refuse("models = 'soft'", "models = 1001*'soft'", 'models takes at most 1000 texts, 1001 given')
      call refuse(boundary, "&centralizer component = 'none', od = 200, spacing = 10 /", "string 'main' has no component 'none'")
      call refuse('wob = 20.0', "length_reference = 'v'", "there is no load case 'v'; did you mean")
      call refuse('element_length = 10.0', 'eps_n0 = 0.9', 'eps_n0 must be smaller than eps_nmax')
   end subroutine test_well

   subroutine test_studies()
      character(*), parameter :: sweep = ' bit_depth_step = 100, ', uncertain = sweep//'friction_deviation = 0.01'
      call refuse(boundary, "&sweep name = 'k'"//sweep//"/ &sweep name = 'K'"//sweep//'/', &
                  "group &sweep: name 'K' is taken; names must be unique, letter case aside")
      call refuse(boundary, "&uncertainty name = 'k'"//uncertain//" / &uncertainty name = 'K'"//uncertain//' /', &
                  "group &uncertainty: name 'K' is taken; names must be unique, letter case aside")
      call refuse('bit_depth = 900.0', &
                  "bit_depth = 900.0, measured_hookload = 300 / &calibrate name = 'k' / &calibrate name = 'K'", &
                  "group &calibrate: name 'K' is taken; names must be unique, letter case aside")
      call refuse(boundary, '&uncertainty '//uncertain//', friction_deviations = 2*0.01 /', &
                  'give friction_deviation, or friction_deviations, not both')
      call refuse(boundary, '&uncertainty '//uncertain//', friction_correlations = 2*0.1 /', '2 hole sections have 1 pairs')
      call refuse(boundary, '&sweep '//sweep//'frictions = 0.2, frictions_cased = 0.1, frictions_open = 0.2 /', &
                  'frictions_cased and frictions_open stand in place of frictions; keep one way')
      call refuse(boundary, '&sweep '//sweep//'frictions_cased = 2*0.1, frictions_open = 2*0.2 /', &
                  'the pair 0.1, 0.2 stands there twice; keep one')
      call refuse('wob = 20.0', &
                  "wob = 20.0 / &load_case name = 'm', operation = 'up', bit_depth = 300, measured_hookload = 300 /"// &
                  " &calibrate holes = 'hole 2'", "no bit of its cases reaches hole section 'hole 2'; leave it out of holes")
      call refuse(boundary, "&study element_lengths = 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, models = 'mcge', 'soft', "// &
                  "tolerances = 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, "// &
                  "wall_stiffnesses = 1e4, 2e4, 3e4, 4e4, 5e4, 6e4, 7e4, 8e4, 9e4, 1e5, "// &
                  "gap_locations = 'extremum', 'nodes', linear_solvers = 'banded', 'sparse', fidelities = 'fast', 'auto', "// &
                  "'standard' /", 'solutions, every combination of its lists in every case; shorten the lists to 10000 or less')
   end subroutine test_studies

   subroutine test_notes()
      call note('500.0, 900.0', '500.0, 20000.0', 'the last station lies at 20000 m, deeper than any hole so far; mind the units')
      call note('500.0, 900.0', '899.5, 900.0', 'the hole turns by 1800 deg/30 m, more than results were ever checked for')
      call note('id = 108.6', 'id = 108.6, mass = 300', 'mass = 300, but a tube of its od, id and density has 26.73;')
      call note('id = 108.6', 'id = 108.6, youngs = 20', 'youngs = 20; steel has 206')
      call note('&fluid density = 1200.0 /', "&fluid density = 1, where = 'inside' / &fluid density = 3000, where = 'outside' /", &
                "'drillpipe' floats at 800 m: with what is in it it weighs less than the fluid outside that it displaces")
   end subroutine test_notes

   !> Studies that find no solution say so on standard error and end with status 3.
   subroutine test_no_solution()
      call lose('bit_depth = 800.0', "bit_depth = 400 / &steering cases = 's' / &load_case name = 'b', operation = 'sliding', "// &
                'bit_depth = 800', "steering, case 's': no curvature; the hole is vertical there, to 2 deg")
      call lose('element_length = 10.0', "max_iterations = 1 / &load_case name = 'm', operation = 'up', bit_depth = 900, "// &
                "measured_hookload = 300 / &calibrate parameter = 'sticking', sticking_depth = 600, model = 'mcge'", &
                "case 'm', model mcge: no solution; free string: ")
      ! a case that does not converge names the warnings on the deck first
      call lose('element_length = 10.0', 'max_iterations = 1, eps_n0 = 0.02', "did not converge; the deck has warnings, see "// &
                'them first. No')
      call lose('element_length = 10.0', 'max_iterations = 1', 'did not converge; No')
   contains
      subroutine lose(old, new, expected)
         character(*), intent(in) :: old, new, expected
         type(run_type) :: run
         run = run_deck_text(replaced(replaced(good_deck(), "'soft'", "'mcge'"), old, new))
         call assertEqual(3, run%status, message=expected)
         call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
      end subroutine lose
   end subroutine test_no_solution
end module dg_test_expected_messages
