!> Advice of messages about a deck: it is followed, and the message is gone. Each fault is one change to a deck that is right, each
!> remedy one change to the faulty deck.
module dg_test_followed_faults
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: good_deck, replaced, run_deck_text, run_type
   implicit none
   private
   public :: follow, followed_faults_suite

   character(*), parameter :: newline = achar(10)

contains

   function followed_faults_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('followed_faults')
      call suite%addTest(TestMethod('form', test_form))
      call suite%addTest(TestMethod('path', test_path))
      call suite%addTest(TestMethod('string', test_string))
      call suite%addTest(TestMethod('ranges', test_ranges))
      call suite%addTest(TestMethod('calibrations', test_calibrations))
      call suite%addTest(TestMethod('more_form', test_more_form))
      call suite%addTest(TestMethod('field_units', test_field_units))
      call suite%addTest(TestMethod('keys_without_meaning', test_without_meaning))
      call suite%addTest(TestMethod('notes', test_notes))
      call suite%addTest(TestMethod('names_and_lists', test_lists))
   end function followed_faults_suite

   !> The good deck with `old` changed to `new` has a message with `expected`; '+' for `old` appends. With `fault` changed to
   !> `remedy` the deck is right, and without that message.
   subroutine follow(old, new, expected, fault, remedy, deck)
      character(*), intent(in) :: old, new, expected, fault, remedy
      character(*), intent(in), optional :: deck     !< in place of the good deck
      character(:), allocatable :: text
      type(run_type) :: run
      text = good_deck()//'+'
      if (present(deck)) text = deck//'+'
      text = replaced(text, old, new)
      if (old /= '+') text = replaced(text, newline//'+', newline)
      run = run_deck_text(text, '--check')
      call assertTrue(index(run%output//run%diagnostics, expected) > 0, &
                      message='wanted: '//expected//'; got: '//run%output//run%diagnostics)
      run = run_deck_text(replaced(text, fault, remedy), '--check')
      call assertEqual(0, run%status, message='followed: '//expected//'; got: '//run%diagnostics)
      call assertEqual(0, index(run%output//run%diagnostics, expected), message='followed: '//expected)
   end subroutine follow

   !> Texts of a deck.
   subroutine test_form()
      call follow("density = 1200.0", "density = 1200.0, ,", "no value before a comma; give every value", ", ,", '')
      call follow("&boundary", "&end &boundary", "closes no group; remove it", "&end &boundary", "&boundary")
      call follow("density = 1200.0", "= 1200.0", "write key = value", "= 1200.0", "density = 1200.0")
      call follow("azi = 3*10.0", "azi(1) = 10, azi(3) = 10", "give the values in order, without gaps", "azi(3) = 10", &
                  "azi(2) = 10, azi(3) = 10")
      call follow("'a deck'", "a_deck", "write title = 'a_deck'", "a_deck", "'a_deck'")
      call follow("name = 's'", "name = ''", "name is empty; give a text", "name = ''", "name = 's'")
      call follow("operation = 'sliding'", "operation = 'slidign'", "did you mean 'sliding_drilling'?", "slidign", &
                  "sliding_drilling")
      call follow("md_bottom = 400.0", "md_botom = 400.0", "did you mean 'md_bottom'?", "md_botom", "md_bottom")
      call follow("&boundary", "&boundry", "did you mean 'boundary'?", "boundry", "boundary")
      call follow("element_length = 10.0", "history = yes", "write .true. or .false.", "yes", ".true.")
      call follow("wob = 20.0", "string = 'mian'", "did you mean 'main'?", "mian", "main")
      call follow("title = 'a deck'", "title = "//curly(152)//'deck'//curly(153), "has curly quotes, as word processors "// &
                  "write; write title = 'deck'", curly(152)//'deck'//curly(153), "'deck'")
      call follow("operation = 'sliding'", "operation = "//curly(156)//'sliding'//curly(157), "has curly quotes, as word "// &
                  "processors write; write operation = 'sliding'", curly(156)//'sliding'//curly(157), "'sliding'")
      call follow("&component od = 127.0", "&component string = 'Main', od = 127.0", "string = 'Main' differs from 'main' in "// &
                  "line 11 by capitals only; write one of them", "'Main'", "'main'")
   contains
      !> A curly quote, as word processors write it.
      function curly(last) result(quote)
         integer, intent(in) :: last
         character(3) :: quote
         quote = char(226)//char(128)//char(last)
      end function curly
   end subroutine test_form

   !> Survey, hole and fluid.
   subroutine test_path()
      call follow("inc = 0.0, 0.0, 30.0", "inc = 0.0, 0.0, 30.0, survey_file = 'x.csv'", &
                  "both survey_file and md are given; keep one", ", survey_file = 'x.csv'", '')
      call follow("azi = 3*10.0", '', "key azi is missing; give md, inc and azi", "inc =", "azi = 3*10, inc =")
      call follow("inc = 0.0, 0.0, 30.0", "inc = 0.0, 30.0", "inc has 2 values, md has 3; give one for each station", &
                  "inc = 0.0, 30.0", "inc = 0.0, 0.0, 30.0")
      call follow("inc = 0.0, 0.0, 30.0", "inc = 0.0, 0.0, 175", "add a station between", "0.0, 500.0, 900.0"//newline// &
                  "  inc = 0.0, 0.0, 175"//newline//"  azi = 3*", "0.0, 500.0, 700.0, 900.0"//newline// &
                  "  inc = 0.0, 0.0, 90, 175"//newline//"  azi = 4*")
      call follow("0.0, 500.0, 900.0"//newline//"  inc = 0.0", "10.0, 500.0, 900.0"//newline//"  inc = 1.0", &
                  "give tie_on = 'vertical'", "azi =", "tie_on = 'vertical', azi =")
      call follow("0.0, 500.0, 900.0"//newline//"  inc = 0.0", "10.0, 500.0, 900.0"//newline//"  inc = 1.0", &
                  "give tie_on = 'straight'", "azi =", "tie_on = 'straight', azi =")
      call follow("md  =", "interpolation = 'spline', md  =", "or interpolation = 'minimum_curvature'", "'spline'", &
                  "'minimum_curvature'")
      call follow("&hole md_top = 0.0, md_bottom = 400.0"//newline//"  diameter = 220.0, friction = 0.25 /"//newline// &
                  "&hole md_top = 400.0,", "&hole md_top = 0.0"//newline//"  diameter = 220.0, friction = 0.25 /"//newline// &
                  "&hole", "give one of them", "&hole md_top = 0.0"//newline, "&hole md_top = 0.0, md_bottom = 400"//newline)
      call follow("&fluid", "&fluid tvd_top = 2000, density = 1500 / &fluid", "deeper than the hole; leave this fluid out", &
                  "&fluid tvd_top = 2000, density = 1500 / ", '')
   end subroutine test_path

   !> Components and centralizers.
   subroutine test_string()
      call follow("length = 100.0", "length = 0.0009", "length of 'collars' is 0.0009 m, shorter than the shortest contact, "// &
                  "1 mm. Give 0.001 m or more", "0.0009", "0.001")
      call follow("joint_od = 168.3", "joint_od = 168.3, joint_length = 0.0009", "1 mm. Give 0.001 m or more", "0.0009", "0.001")
      call follow("id = 108.6", "id = 108.6, friction = 0.1, friction_scale = 0.5", "give one of the two", &
                  ", friction_scale = 0.5", '')
      call follow("joint_od = 168.3", "joint_od = 168.3, length = 700.0", "leave out the length of its last component", &
                  ", length = 700.0", '')
      call follow("od = 171.45", "od = 171.45, opened_od = 200", "give opened_below", "opened_od = 200", &
                  "opened_od = 200, opened_below = 500")
      call follow("od = 171.45", "od = 171.45, opened_od = 200", "or cased = .true. in the hole sections", "diameter = 220.0", &
                  "cased = .true., diameter = 220.0")
      call follow("od = 171.45", "od = 171.45, opened_below = 500", "the diameter of the open tool; give both", "opened_below", &
                  "opened_od = 200, opened_below")
      call follow("od = 171.45", "od = 171.45, opened_od = 218, opened_below = 200", "needs opened_od <= 215.9 mm", "= 218", &
                  "= 215.9")
      call follow("joint_od = 168.3", "kind = 'stabilizer'", "give blades as joint_od", "kind = 'stabilizer'", &
                  "kind = 'stabilizer', joint_od = 200")
      call follow("od = 127.0", "connection = 'NC50', od = 127.0", "or give joint_torsion", "connection", &
                  "joint_torsion = 50, connection")
      call follow("&solver", "&centralizer component = 'collars', od = 200, spacing = 10, running_force = 1 / &solver", &
                  "leave it out, or give kind = 'bow'", ", running_force = 1", '')
      call follow("&solver", "&centralizer component = 'collars', od = 200, spacing = 10, running_force = 1 / &solver", &
                  "leave it out, or give kind = 'bow'", "running_force = 1", &
                  "running_force = 1, kind = 'bow', restoring_force = 5")
      call follow("&solver", &
                  "&centralizer component = 'collars', od = 200, spacing = 10 / &centralizer component = 'collars', od = "// &
                  "200, spacing = 10 / &solver", "a component takes one kind, so cut it in two", &
                  " / &centralizer component = 'collars', od = 200, spacing = 10 / ", " / ")
      call follow("+", "&tortuosity kind = 'sine', amplitude = 1, period = 60, seed = 3 /", &
                  "leave it out, or give kind = 'random'", ", seed = 3", '')
   end subroutine test_string

   !> Tortuosity, studies, sweeps and uncertainties.
   subroutine test_ranges()
      call follow("+", "&tortuosity kind = 'sine', amplitude = 1, period = 60, seed = 3 /", &
                  "leave it out, or give kind = 'random'", "'sine'", "'random'")
      call follow("+", "&tortuosity kind = 'sine', amplitude = 1, period = 500 /", "a shorter period", "period = 500", &
                  "period = 100")
      call follow("+", "&tortuosity kind = 'sine', amplitude = 1, period = 60, md_bottom = 950 /", "end it there or above", &
                  "= 950", "= 900")
      call follow("+", "&tortuosity kind = 'sine', amplitude = 1, period = 60 /"//newline// &
                  "&tortuosity kind = 'sine', amplitude = 1, period = 60 /", "part them by md_top and md_bottom", &
                  "period = 60 /"//newline//"&tortuosity", "period = 60, md_bottom = 450 /"//newline// &
                  "&tortuosity md_top = 450,")
      call follow("+", "&study cases = 'u', models = 'mcge' /", "nothing to compare; give two values or more", &
                  "models = 'mcge'", "models = 'mcge', 'soft'")
      call follow("+", "&sweep operations = 'up', 'down', bit_depth_to = 900, name = 'a/b' /", &
                  "use letters, digits and _ - . +", "a/b", "a-b")
      call follow("+", "&sweep operations = 'up', 'down', bit_depth_to = 900, wob = 1, 2, 3 /", "give one, or one for each", &
                  "1, 2, 3", "0, 2")
      call follow("+", "&sweep operations = 'up', 'down', bit_depth_to = 900, wob = 5 /", "give one for each operation", &
                  "wob = 5", "wob = 0, 5")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900 /", &
                  "nothing is uncertain; give a friction_deviation", "900 /", "900, friction_deviation = 0.02 /")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900 /", "hookload_deviation or torque_deviation", &
                  "900 /", "900, hookload_deviation = 5 /")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900, inclination_deviation = 0.1 /"//newline// &
                  "&tortuosity kind = 'sine', amplitude = 1, period = 60 /", "give survey_errors = 'systematic'", "= 0.1 /", &
                  "= 0.1, survey_errors = 'systematic' /")
      call follow("+", &
                  "&uncertainty operations = 'up', bit_depth_to = 900, friction_deviation = 0.02, friction_deviations = "// &
                  "0.02, 0.03 /", "not both", " friction_deviation = 0.02,", '')
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900, friction_deviations = 0.02 /", "give one for each", &
                  "= 0.02", "= 0.02, 0.03")
      call follow("+", &
                  "&uncertainty operations = 'up', bit_depth_to = 900, friction_deviation = 0.02, friction_correlation = "// &
                  "0.5, friction_correlations = 0.5 /", "friction_correlations, not both", " friction_correlation = 0.5,", '')
      call follow("+", &
                  "&uncertainty operations = 'up', bit_depth_to = 900, friction_deviation = 0.02, samples = 9999, "// &
                  "bit_depth_step = 0.1 /", "lower samples or raise bit_depth_step", "= 9999", "= 10")
      call follow("+", &
                  "&uncertainty operations = 'up', bit_depth_to = 900, friction_deviation = 0.02, samples = 9999, "// &
                  "bit_depth_step = 0.1 /", "lower samples or raise bit_depth_step", "= 0.1", "= 300")
      call follow("+", "&calibrate cases = 'u', separate = 'none' /", "give one or leave it out", "bit_depth = 900.0", &
                  "measured_hookload = 300, bit_depth = 900.0")
   end subroutine test_ranges

   !> Calibrations, stuck points, names of cases.
   subroutine test_calibrations()
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'none', 'holes'", "keep one", "'none', 'holes'", "'none'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'holes'", "or leave out separate or offset", "'holes'", "'none'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'none', sticking_depth = 300", "leave it out", ", sticking_depth = 300", &
                  '')
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'operations', predict = 's'", "leave it out or separate less", &
                  ", predict = 's'", '')
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'none', model = 'soft', 'rigid', apply = .true.", &
                  "apply needs one model", "'soft', 'rigid'", "'soft'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'operations', apply = .true.", &
                  "apply needs separate = 'none' or 'holes'", "'operations'", "'none'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'none', parameter = 'friction_rotary'", "add such a case or leave out", &
                  ", parameter = 'friction_rotary'", '')
      call follow("bit_depth = 900.0", "measured_hookload = 300, friction = 0.2, bit_depth = 900.0 /"//newline// &
                  "&calibrate cases = 'u', separate = 'none', apply = .true.", "or leave out apply", ", apply = .true.", '')
      call follow("bit_depth = 900.0 /"//newline//"&load_case name = 's',", "measured_hookload = 300, bit_depth = 900.0 /"// &
                  newline//"&calibrate parameter = 'sticking', sticking_depth = 600, cases = 'u', 's' /"//newline// &
                  "&load_case name = 's', measured_torque = 1,", "give it or leave the case out", "'u', 's'", "'u'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 /"//newline// &
                  "&calibrate parameter = 'sticking', sticking_depth = 600, cases = 'u', separate = 'none'", "leave it out", &
                  ", separate = 'none'", '')
      call follow("name = 's', operation", "name = 'a/b', operation", "use 1 to 100 letters", "a/b", "a-b")
   end subroutine test_calibrations

   !> Marks, subscripts and operations.
   subroutine test_more_form()
      call follow("&boundary", "odd &boundary", "text outside any group", "odd &b", "! odd"//newline//"&b")
      call follow("'a deck'", "a / deck", "put a text that holds a / into quotes", "a / deck", "'a / deck'")
      call follow("azi = 3*10.0", "azi(x) = 3*10.0", "write key(1) = or key(2:5) =", "azi(x)", "azi(1)")
      call follow("azi = 3*10.0", "azi(x) = 3*10.0", "write key(1) = or key(2:5) =", "azi(x)", "azi(1:3)")
      call follow("azi = 3*10.0", "azi = 3*", "a repeat count without a value; write 3*0.1", "3*", "3*0.1")
      call follow("wob = 20.0", "wob =", "wob: no value; write wob = value", "wob =", "wob = 20")
      call follow("&boundary top", "&boundary = top", "'=' without a key before it; write key = value", "= top", "top")
      call follow("= 10.0 /", "= 10.0", "not closed; end it with /", "element_length = 10.0", "element_length = 10.0 /")
      call follow("'up'", "'overpull'", "write 'trip_out' with a wob below 0", "'overpull'", "'trip_out', wob = -20")
      call follow("'up'", "'tripping'", "write 'trip_out' or 'trip_in'", "'tripping'", "'trip_out'")
      call follow("'up'", "'tripping'", "write 'trip_out' or 'trip_in'", "'tripping'", "'trip_in'")
      call follow("'up'", "up", "write operation = 'up'", "= up", "= 'up'")
      call follow("'centred'", "fre", "top_lateral = 'fre' is unknown; did you mean 'free'?", "= fre", "= 'free'")
      call follow("name = 's'", "name = 'U'", "names must be unique, letter case aside", "'U'", "'s'")
   end subroutine test_more_form

   !> Numbers as people write them, and a string of tools alone.
   subroutine test_field_units()
      character(*), parameter :: deck = "&job units = 'field' /"//newline//'&trajectory md = 0, 9000, inc = 2*0, azi = 2*0 /'// &
         newline//'&hole diameter = 8.5 /'//newline//'&fluid density = 10 /'//newline// &
         "&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 /"//newline// &
         '&component od = 5, id = 4.276, yield = 135 /'//newline// &
         "&load_case name = 'u', operation = 'up', bit_depth = 9000 /"//newline
      call follow("diameter = 8.5", "diameter = 8-1/2", "; write 8.5", "8-1/2", "8.5", deck)
      call follow("yield = 135", "yield = 135 ksi", "; write the number alone", " ksi", "", deck)
      call follow("yield = 135", "yield = 135000", "Is it in psi? Then write 135", "135000", "135", deck)
      call follow("density = 10", "density = 75", "Is it in pcf (lbm/ft3)? Then write 10.03", "= 75", "= 10.03", deck)
      call follow("wob = 20.0", "wob = 20.0, pump_pressure = 3000", &
                  "Is it in psi? Then write 20.68. Is it in kPa? Then write 3", "3000", "20.68")
      call follow("bit_depth = 9000", "bit_depth = 9,000", "decimals have a point: 9.000. Thousands have no mark: 9000", "9,000", &
                  "9000", deck)
      call follow("md = 0, 9000", "md = 0, 2743.2", "Is md of the survey in m? 2743.2 m are 9000 ft. In a file write "// &
                  "survey_units = 'SI'", "2743.2", "9000", deck)
      call follow("kind = 'collar', length = 90", "kind = 'PDC', length = 90, joint_od = 8.5", &
                  "Only a bit may fill its hole: is it one? Then write kind = 'bit'", "'PDC'", "'bit'", deck)
      call follow("&component od = 5, id = 4.276, yield = 135 /"//newline, "", &
                  "add drill pipe without a length as last component", "id = 3.25 /", &
                  "id = 3.25 / &component od = 5, id = 4.276 /", deck)
   end subroutine test_field_units

   !> Keys that have no meaning where they stand.
   subroutine test_without_meaning()
      call follow("md  = 0.0", "md_column = 'MD', md  = 0.0", "md_column has no meaning without survey_file. Leave it out", &
                  "md_column = 'MD', ", "")
      call follow("md  = 0.0", "parent_file = '', md  = 0.0", "parent_file is empty. Give a path", "parent_file = '', ", "")
      call follow("md  = 0.0", "kick_off = 100, md  = 0.0", &
                  "kick_off has no meaning without tie_on = 'vertical'; give both or none", "kick_off = 100, ", "")
      call follow("density = 1200.0", "density = 1200.0, md_top = 100, above_bit = 100", &
                  "all say where the fluid begins; keep one", ", above_bit = 100", "")
      call follow("density = 1200.0 /", "density = 1200.0 / &fluid density = 1100, md_top = 300, surface_pressure = 5 /", &
                  "give it in the uppermost fluid", &
                  "density = 1200.0 / &fluid density = 1100, md_top = 300, surface_pressure = 5 /", &
                  "density = 1200.0, surface_pressure = 5 / &fluid density = 1100, md_top = 300 /")
      call follow("&job title = 'a deck'", "&rig max_hookload = 900 / &job rig_limit = 900, title = 'a deck'", &
                  "max_hookload is rig_limit of &job under another name; keep one", "rig_limit = 900, ", "")
      call follow("wob = 20.0", "wob = 20.0 / &load_case name = 'v', operation = 'static', bit_depth = 800 /"// &
                  " &load_case name = 'w', operation = 'static', bit_depth = 800, length_reference = 'v' /"// &
                  " &load_case name = 'x', operation = 'static', bit_depth = 800, length_reference = 'w'", &
                  "has a length_reference itself; name a case without one", "length_reference = 'w'", "length_reference = 'v'")
   end subroutine test_without_meaning

   !> Decks that are legal and hardly meant.
   subroutine test_notes()
      call follow("od = 127.0, id = 108.6", "od = 127.0", "Give the inside diameter", "od = 127.0", "od = 127.0, id = 108.6")
      call follow("friction = 0.3 /", "/", "has no friction. Drag and torque there are zero. Give friction", "215.9, ", &
                  "215.9, friction = 0 ")
      call follow("&component od = 127.0", &
                  "&centralizer component = 'pipe', od = 160, spacing = 10 / &component name = 'pipe', od = 127.0", &
                  "the centralizers do not touch; check both", "od = 160", "od = 200")
      call follow("kind = 'collar', length = 100.0", "kind = 'motor', bend = 1.5, bend_position = 2, length = 9.0", &
                  "ignores the bent housing. Use mcge", "'soft'", "'mcge'")
      call follow("kind = 'collar', length = 100.0", "pad_force = 5, pad_clock = 0, pad_position = 1, length = 9.0", &
                  "ignores the force of the pads. Use mcge", "'soft'", "'mcge'")
      call follow("kind = 'collar', length = 100.0", "kind = 'stabilizer', joint_od = 210, blade_offset = 5, length = 1.0", &
                  "ignores the offset of the blades. Use mcge", "'soft'", "'mcge'")
   end subroutine test_notes

   !> Names that are taken, and values that stand twice.
   subroutine test_lists()
      call follow("+", "&sweep name = 'k' bit_depth_step = 100, / &sweep name = 'K' bit_depth_step = 100, /", &
                  "group &sweep: name 'K' is taken", "'K'", "'j'")
      call follow("+", "&uncertainty name = 'k' bit_depth_step = 100, friction_deviation = 0.1 / &uncertainty name = 'K' "// &
                  "bit_depth_step = 100, friction_deviation = 0.1 /", "group &uncertainty: name 'K' is taken", "'K'", "'j'")
      call follow("bit_depth = 900.0", &
                  "bit_depth = 900.0, measured_hookload = 300 / &calibrate name = 'k', separate = 'none' / &calibrate name "// &
                  "= 'K', separate = 'none'", "group &calibrate: name 'K' is taken", "'K'", "'j'")
      call follow("+", "&sweep bit_depth_step = 100, frictions = 0.2, 0.2 /", "frictions holds 0.2 twice; keep one", "0.2, 0.2", &
                  "0.2")
      call follow("+", "&sweep bit_depth_step = 100, frictions = 0.2, frictions_cased = 0.1, frictions_open = 0.2 /", &
                  "stand in place of frictions; keep one way", "frictions_cased = 0.1, frictions_open = 0.2", "")
      call follow("wob = 20.0", &
                  "wob = 20.0 / &load_case name = 'm', operation = 'up', bit_depth = 300, measured_hookload = 300 / "// &
                  "&calibrate separate = 'none', holes = 'hole 1', 'hole 2'", "leave it out of holes", ", 'hole 2'", "")
      call follow("bit_depth = 900.0", &
                  "bit_depth = 900.0, measured_hookload = 300 / &calibrate separate = 'none', cases = 'u', predict = 'u'", &
                  "so it would be no prediction; keep it in one", ", predict = 'u'", "")
      call follow("bit_depth = 900.0", &
                  "bit_depth = 900.0, measured_hookload = 300 / &calibrate name = 'a', separate = 'none', apply = .true. / "// &
                  "&calibrate name = 'b', separate = 'none', apply = .true.", "already; keep one", &
                  ", apply = .true. / &calibrate name = 'b'", " / &calibrate name = 'b'")
      call follow("+", "&study element_lengths = 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, models = 'mcge', 'soft', tolerances = 1e-4, "// &
                  "1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, wall_stiffnesses = 1e4, 2e4, 3e4, 4e4, 5e4, 6e4, 7e4, 8e4, 9e4, "// &
                  "1e5, gap_locations = 'extremum', 'nodes', linear_solvers = 'banded', 'sparse', fidelities = 'fast', "// &
                  "'auto', 'standard' /", "shorten the lists to 10000 or less", &
                  "wall_stiffnesses = 1e4, 2e4, 3e4, 4e4, 5e4, 6e4, 7e4, 8e4, 9e4, 1e5, ", "")
      call follow("diameter = 220.0, friction = 0.25 /", &
                  "cased = .true., diameter = 220.0, friction = 0.25 / &sweep bit_depth_step = 100, frictions_cased = "// &
                  "2*0.1, frictions_open = 2*0.2 /", "the pair 0.1, 0.2 stands there twice; keep one", &
                  "frictions_cased = 2*0.1, frictions_open = 2*0.2", "frictions_cased = 0.1, frictions_open = 0.2")
   end subroutine test_lists
end module dg_test_followed_faults
