!> Decks that must be refused: status 2, a message with file and line, no folder of results, no traceback.
!> Each fault is one change to a deck that is right.
module dg_test_bad_decks
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: run_type, run_deck_text, good_deck, replaced, deck_path
   use dg_text, only: to_text
   implicit none
   private
   public :: bad_decks_suite

   character(*), parameter :: newline = achar(10)

contains

   function bad_decks_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bad_decks')
      call suite%addTest(TestMethod('good_deck_is_good', test_good))
      call suite%addTest(TestMethod('form', test_form))
      call suite%addTest(TestMethod('groups', test_groups))
      call suite%addTest(TestMethod('keys', test_keys))
      call suite%addTest(TestMethod('values', test_values))
      call suite%addTest(TestMethod('texts_that_run_as_formulas', test_formulas))
      call suite%addTest(TestMethod('texts_that_show_as_others', test_misleading))
      call suite%addTest(TestMethod('survey', test_survey))
      call suite%addTest(TestMethod('files_that_are_not_there', test_missing_files))
      call suite%addTest(TestMethod('holes', test_holes))
      call suite%addTest(TestMethod('components', test_components))
      call suite%addTest(TestMethod('load_cases', test_load_cases))
      call suite%addTest(TestMethod('packers', test_packers))
      call suite%addTest(TestMethod('wear_and_fatigue', test_wear))
      call suite%addTest(TestMethod('all_faults_in_one_run', test_all_faults))
   end function bad_decks_suite

   !> The deck with `old` changed to `new` must be refused at `line` with a message that holds `expected`.
   subroutine refuse(old, new, line, expected)
      character(*), intent(in) :: old, new
      integer, intent(in) :: line
      character(*), intent(in) :: expected
      call refuse_text(replaced(good_deck(), old, new), line, expected)
   end subroutine refuse

   subroutine refuse_text(text, line, expected)
      character(*), intent(in) :: text
      integer, intent(in) :: line
      character(*), intent(in) :: expected
      type(run_type) :: run
      run = run_deck_text(text)
      call assertEqual(2, run%status, message='status of: '//expected)
      call assertTrue(has_message(run%diagnostics, line, expected), &
                      message='wanted in line '//to_text(line)//': '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
      call assertEqual('', run%output, message='nothing on standard output: '//expected)
      call assertEqual(0, index(run%diagnostics, 'acktrace'), message='no traceback: '//expected)
      call assertEqual(0, index(run%diagnostics, 'Fortran runtime'), message='no run-time message: '//expected)
   end subroutine refuse_text

   !> True if one line of the diagnostics starts with file and line and holds `expected`.
   pure function has_message(diagnostics, line, expected) result(has)
      character(*), intent(in) :: diagnostics
      integer, intent(in) :: line
      character(*), intent(in) :: expected
      logical :: has
      integer :: first, last
      character(:), allocatable :: place
      place = deck_path//':'//to_text(line)//': '
      has = .false.
      first = 1
      do while (first <= len(diagnostics))
         last = first + index(diagnostics(first:), newline) - 2
         if (index(diagnostics(first:last), place) == 1 .and. index(diagnostics(first:last), expected) > 0) has = .true.
         first = last + 2
      end do
   end function has_message

   subroutine test_good()
      type(run_type) :: run
      run = run_deck_text(good_deck(), '--check')
      call assertEqual(0, run%status)
      call assertEqual('', run%diagnostics)
   end subroutine test_good

   subroutine test_form()
      call refuse("&job title", "title &job title", 1, "text outside any group: 'title'; a group begins with &")
      call refuse("'a deck'", "'a deck", 1, 'is not closed on its line')
      call refuse("&solver element_length = 10.0 /", "&solver element_length = 10.0", 20, 'group &solver: not closed')
      call refuse("azi = 3*10.0 /", "azi = 3*10.0", 2, 'group &trajectory: not closed before &hole in line 6')
      call refuse("density = 1200.0", "density 1200.0", 10, "group &fluid: 'density' belongs to no key")
      call refuse("density = 1200.0", "density =", 10, 'group &fluid: density: no value')
      call refuse("0.0, 500.0, 900.0", "0.0,, 500.0, 900.0", 3, 'no value before a comma')
      call refuse("3*10.0", "3*", 5, 'azi: a repeat count without a value')
      call refuse("3*10.0", "0*10.0", 5, 'azi: repeat counts are 1 to')
      call refuse("azi =", "azi(2) =", 5, 'comes after 0 values')
      call refuse("azi =", "azi(x) =", 5, 'the subscript of')
      call refuse("azi =", "azi(1:2) =", 5, 'the subscript asks for 2 values, 3 given')
   end subroutine test_form

   subroutine test_groups()
      call refuse("&boundary", "&boundry", 15, "unknown group &boundry; did you mean 'boundary'?")
      call refuse("&hole md_top = 0.0", "&hoel md_top = 0.0", 6, "did you mean 'hole'?")
      call refuse("&boundary top_lateral = 'centred' /", "&boundary /  &boundary /", 15, &
                  'given a second time, first in line 15')
      call refuse("&fluid density = 1200.0 /", "&fluid density = 1200.0 /  &fluid /", 10, &
                  'group &fluid: the fluid in line 10 fills its whole length')
      call refuse("&boundary top_lateral = 'centred' /", "&job /", 15, 'group &job: given a second time, first in line 1')
      call refuse_text("! nothing"//newline, 1, 'group &trajectory: missing')
   end subroutine test_groups

   subroutine test_keys()
      call refuse("md_bottom = 400.0", "md_botom = 400.0", 6, "unknown key 'md_botom'; did you mean 'md_bottom'?")
      call refuse("friction = 0.3", "colour = 0.3", 9, "unknown key 'colour'; input/README.md lists all 14")
      call refuse("friction = 0.3", "diameter = 210", 9, 'diameter is given a second time, first in line 9')
      call refuse("  bit_depth = 900.0 /", "/", 16, 'key bit_depth is missing; needs a number, 0.001')
      call refuse("diameter = 215.9,", "", 8, 'key diameter is missing')
      call refuse("od = 127.0", "od(1) = 127.0", 13, 'od takes one value and no subscript')
      call refuse("od = 127.0", "od = 127.0 128.0", 13, 'od takes one value, 2 given')
   end subroutine test_keys

   subroutine test_values()
      call refuse("'soft'", "'soft', 'rigit'", 1, "did you mean 'rigid'?")
      call refuse("od = 127.0", "od = 'wide'", 13, "od = 'wide' is not a number; needs a number, 1 to 5000 mm")
      call refuse("od = 127.0", "od = wide", 13, 'od = wide is not a number')
      call refuse("od = 127.0", "od = 12O.0", 13, 'od = 12O.0 is not a number')
      call refuse("od = 127.0", "od = nan", 13, 'od = nan is not a number')
      call refuse("od = 127.0", "od = 1e999", 13, 'od = 1e999 is not a number')
      call refuse("diameter = 215.9", "diameter = -215.9", 9, 'diameter = -215.9 is out of range; needs a number, 1 to 5000 mm')
      call refuse("diameter = 215.9", "diameter = 0.2159", 9, 'out of range; needs a number, 1 to 5000 mm')
      call refuse("inc = 0.0, 0.0, 30.0", "inc = 0.0, 0.0, 181", 4, 'inc(3) = 181 is out of range; needs a number, 0 to 180 deg')
      call refuse("friction = 0.3", "friction = 30", 9, 'friction = 30 is out of range; needs a number, 0 to 2')
      call refuse("wob = 20.0", "wob = 200000.0", 19, 'wob = 200000.0 is out of range')
      call refuse("wob = 20.0", "tob = -1", 19, 'tob = -1 is out of range')
      call refuse("element_length = 10.0", "max_iterations = 2.5", 20, 'is not a whole number')
      call refuse("element_length = 10.0", "history = yes", 20, 'history = yes is not a logical value; write .true. or .false.')
      call refuse("'a deck'", "a_deck", 1, "is a text without quotes; write title = 'a_deck'")
      call refuse("title", "units = 'SL', title", 1, "units = 'SL' is unknown; did you mean 'SI'?")
      call refuse("'soft'", "'sofd'", 1, "models = 'sofd' is unknown; did you mean 'soft'?")
      call refuse("'centred'", "'fixed'", 15, "top_lateral = 'fixed' is unknown; legal: centred, free")
      call refuse("operation = 'up'", "operation = 'sideways'", 16, "operation = 'sideways' is unknown; legal: trip_out")
      call refuse("operation = 'sliding'", "operation = 'slidign'", 18, "did you mean 'sliding_drilling'?")
      call refuse("azi = 3*10.0", "azi = 3*10.0, interpolation = 'splin'", 5, "did you mean 'spline'?")
      call refuse("element_length = 10.0", "gap_location = 'node'", 20, "did you mean 'nodes'?")
      call refuse("element_length = 10.0", "fidelity = 'referense'", 20, "did you mean 'reference'?")
      call refuse("element_length = 10.0", "gk_contact = 10.0, gk_max = 5.0", 20, 'gk_max must be at least gk_contact')
      call refuse("element_length = 10.0", "r_n0 = 50.0", 20, 'r_n0 = 50.0 is out of range; needs a number, 0 to 1 kN')
      call refuse("element_length = 10.0", "gk_max = 1e13", 20, 'gk_max = 1e13 is out of range; needs a number, > 0 and <= 1e12')
      call refuse("element_length = 10.0", "step_limit = 1e-9", 20, 'step_limit = 1e-9 is out of range; needs a number, 0.1 to')
   end subroutine test_values

   !> A cell that begins so is run by a spreadsheet that opens summary.csv. Signs inside a name, and of file names, are legal.
   subroutine test_formulas()
      type(run_type) :: run
      call refuse("'a deck'", "'=1+1'", 1, "title = '=1+1' begins with =. A spreadsheet would run that cell")
      call refuse("'a deck'", "'  @sum(a1)'", 1, "title = '  @sum(a1)' begins with @")
      call refuse("'a deck'", "'"//achar(9)//"1'", 1, 'begins with a tab')
      call refuse("'collars'", "'-2'", 11, "name = '-2' begins with -")
      call refuse("'collar'", "'+2'", 11, "kind = '+2' begins with +")
      call refuse("diameter = 215.9", "name = '=a', diameter = 215.9", 9, "name = '=a' begins with =")
      call refuse("'u', operation", "'u', section = '=a', operation", 16, "section = '=a' begins with =")
      call refuse("name = 'u'", "name = '+u'", 16, "name = '+u' begins with +")
      call refuse("&solver", "&sweep name = '-s', bit_depth_to = 900 / &solver", 20, "name = '-s' begins with -")
      run = run_deck_text(replaced(replaced(good_deck(), "'a deck'", "'a=1+2 @-3'"), "name = 'u'", "name = 'u-1+2'"))
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_formulas

   !> Letters that turn the direction of writing, and bytes that make no letter.
   subroutine test_misleading()
      type(run_type) :: run
      character(*), parameter :: override = char(226)//char(128)//char(174), isolate = char(226)//char(129)//char(166), &
         mark = char(216)//char(156)
      call refuse("'a deck'", "'a"//override//"b'", 1, "title = 'a???b' holds the letter U+202E")
      call refuse("'collars'", "'"//isolate//"'", 11, 'holds the letter U+2066, which turns the direction of writing; remove it')
      call refuse("'a deck'", "'"//mark//"'", 1, 'holds the letter U+061C')
      call refuse("md  = 0.0", "survey_file = '"//mark//"' md = 0.0", 3, 'holds the letter U+061C')
      call refuse("'a deck'", "'F"//char(246)//"rde'", 1, 'is not UTF-8: byte 2 is hexadecimal F6; save the file as UTF-8')
      run = run_deck_text(replaced(good_deck(), "'a deck'", "'F"//char(195)//char(182)//"rde'")//'! F'//char(246)//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_misleading

   subroutine test_survey()
      call refuse("0.0, 500.0, 900.0", "0.0, 900.0, 500.0", 3, 'station 3 at 500 m is not below station 2 at 900 m')
      call refuse_text(replaced(replaced(good_deck(), "0.0, 500.0, 900.0", "100.0, 500.0, 900.0"), &
                                "inc = 0.0, 0.0", "inc = 1.0, 0.0"), 3, 'the first station is at 100 m and inclined by 1 deg')
      call refuse("inc = 0.0, 0.0, 30.0", "inc = 0.0, 0.0", 4, 'inc has 2 values, md has 3')
      call refuse("azi = 3*10.0", "", 2, 'key azi is missing')
      call refuse("md  = 0.0, 500.0, 900.0", "", 2, 'key md is missing')
      call refuse("inc = 0.0, 0.0, 30.0", "survey_file = 'x.csv'", 4, 'both survey_file and md are given')
      call refuse("inc = 0.0, 0.0, 30.0", "inc = 0.0, 0.0, 175", 2, 'group &trajectory: survey:')
   end subroutine test_survey

   !> Where the deck names a file that cannot be read there is the fault: line, group and key.
   subroutine test_missing_files()
      character(*), parameter :: absent = ' cannot be opened (No such file or directory)'
      character(:), allocatable :: deck
      deck = replaced(replaced(good_deck(), "inc = 0.0, 0.0, 30.0", ""), "azi = 3*10.0", "")
      call refuse_text(replaced(deck, "md  = 0.0, 500.0, 900.0", "survey_file = 'no.csv'"), 3, &
                       'group &trajectory: survey_file: ')
      call refuse_text(replaced(deck, "md  = 0.0, 500.0, 900.0", "survey_file = 'no.csv'"), 3, 'no.csv: survey file'//absent)
      call refuse_text(replaced(deck, "md  = 0.0, 500.0, 900.0", "survey_file = '.'"), 3, 'cannot be read (it is a folder)')
      call refuse_text(replaced(deck, "md  = 0.0, 500.0, 900.0", "survey_file = '/dev/zero'"), 3, &
                       '/dev/zero: survey file cannot be read (it is a device; give a file)')
      deck = replaced(replaced(good_deck(), "'a deck'", "'a deck', catalogue_file = 'no.csv'"), "od = 171.45", "catalogue = 'x'")
      call refuse_text(deck, 1, 'group &job: catalogue_file: ')
      call refuse_text(deck, 1, 'no.csv: catalogue'//absent)
      deck = good_deck()//"&legacy file = 'no.txt', label = 'other', case = 's' /"//newline
      call refuse_text(deck, 21, 'group &legacy: file: ')
      call refuse_text(deck, 21, 'no.txt: legacy file'//absent)
   end subroutine test_missing_files

   subroutine test_holes()
      call refuse("md_top = 400.0", "md_top = 450.0", 8, 'md_top = 450 m leaves a gap below the section above (line 6)')
      call refuse("md_top = 400.0", "md_top = 350.0", 8, 'leaves an overlap with the section above (line 6)')
      call refuse("md_top = 0.0", "md_top = 10.0", 6, 'holes must begin at surface')
      call refuse("md_top = 0.0, md_bottom = 400.0", "md_bottom = 0.0009, diameter = 230 /  &hole md_bottom = 400.0", 6, &
                  'the section from 0 m to 0.0009 m is shorter than the shortest contact, 1 mm')
      call refuse("md_bottom = 900.0", "md_bottom = 300.0", 8, 'md_bottom = 300 m is not below md_top = 400 m')
      call refuse("md_top = 400.0, md_bottom = 900.0", "md_bottom = 300.0", 6, 'md_bottom = 400 m is not above '// &
                  'md_bottom of the next section (line 8), 300 m')
      call refuse("md_top = 400.0, md_bottom = 900.0", "md_top = 950.0", 8, 'md_top = 950 m is not above the last station, 900 m')
      call refuse("md_bottom = 900.0", "md_bottom = 850.0", 17, 'lies below the lowest hole section, which ends at 850 m')
   end subroutine test_holes

   subroutine test_components()
      call refuse("id = 108.6", "id = 130", 13, 'id = 130 is not smaller than od = 127')
      call refuse("id = 108.6", "id = 108.6, friction = 0.1, friction_scale_rotary = 0.5", 13, &
                  'friction_scale_rotary has nothing to scale: the component has its own rotary friction')
      call refuse("&solver", "&centralizer component = 'colar', od = 200, spacing = 10 / &solver", 20, &
                  "string 'main' has no component 'colar'")
      call refuse("&solver", "&centralizer component = 'collars', kind = 'bow', od = 200, spacing = 10 / &solver", 20, &
                  "kind = 'bow' needs restoring_force")
      call refuse("&solver", "&centralizer component = 'collars', od = 200, spacing = 10, running_force = 1 / &solver", 20, &
                  "running_force has no meaning with kind = 'rigid'")
      call refuse("&solver", "&centralizer component = 'collars', od = 170, spacing = 10 / &solver", 20, &
                  "od = 170 mm is not greater than that of 'collars' (line 11), 171.45 mm")
      call refuse("&solver", "&centralizer component = 'collars', od = 200, spacing = 250 / &solver", 20, &
                  "the lowest stands 125 m above the lower end of 'collars', which is 100 m long")
      call refuse("&solver", "&centralizer component = 'collars', od = 230, spacing = 10 / &solver", 20, &
                  "'collars' with 230 mm does not pass the hole of")
      call refuse("joint_od = 168.3", "joint_od = 100", 14, 'joint_od = 100 is smaller than od = 127')
      call refuse("joint_od = 168.3", "joint_od = 168.3, joint_id = 170", 14, &
                  'joint_id = 170 is not smaller than joint_od = 168.3. Give the bore of the pin')
      call refuse("joint_od = 168.3", "joint_od = 215.9", 14, &
                  'with couplings or joints of 215.9 mm does not pass the hole of 215.9 mm (line 8)')
      call refuse("id = 71.4 /", "id = 71.4, joint_od = 230 / &centralizer component = 'collars', od = 200, spacing = 10 /", 12, &
                  "'collars' with 230 mm does not pass the hole of")
      call refuse("od = 171.45", "od = 240", 12, 'does not pass the hole of 220 mm (line 6)')
      call refuse("length = 100.0", "", 11, "only the last component of string 'main' may reach to surface")
      call refuse("od = 171.45", "od = 171.45, bend = 1.5", 12, 'bend needs bend_position')
      call refuse("&boundary", "&steering side_cutting = 0.1 /"//newline//"&boundary", 15, 'side_cutting needs weight on bit')
      call refuse("&boundary", "&steering measured_dogleg = 3*5 /"//newline//"&boundary", 15, '3 values of measured_dogleg for')
      call refuse("&boundary", "&steering cases = 'nobody' /"//newline//"&boundary", 15, &
                  "group &steering: there is no load case 'nobody'")
      call refuse("od = 171.45", "od = 171.45, bend = 1.5, bend_position = 120", 12, &
                  'bend_position = 120 is greater than length = 100')
      call refuse("od = 171.45", "od = 171.45, bend = 9, bend_position = 1", 12, 'bend = 9 is out of range')
      call refuse("joint_od = 168.3", "length = 700.0", 17, "string 'main' is 800 m long and does not reach surface")
      call refuse("density = 1200.0", "density = 8000.0", 11, 'floats: the mud, 8000')
   end subroutine test_components

   subroutine test_load_cases()
      call refuse("name = 's'", "name = 'U'", 18, "name 'U' is taken by the case in line 16")
      call refuse("name = 's'", "name = 'a/b'", 18, "name = 'a/b' cannot be part of a file name")
      call refuse("name = 's'", "name = ''", 18, 'name is empty; give a text')
      call refuse("bit_depth = 800.0", "bit_depth = 1000.0", 18, 'lies below the survey, which ends at 900 m')
      call refuse("wob = 20.0", "string = 'mian'", 19, "no component belongs to string 'mian'; did you mean 'main'?")
      call refuse("'sliding'", "'ream'", 18, 'operation ream needs rpm > 0')
      call refuse("'sliding'", "'backream', rpm = 60", 18, 'operation backream needs trip_speed > 0')
   end subroutine test_load_cases

   !> Check the requirements of pads, casing wear and fatigue.
   subroutine test_wear()
      call refuse("od = 171.45", "od = 171.45, pad_force = 15", 12, 'pad_force needs pad_position')
      call refuse("od = 171.45", "od = 171.45, pad_force = 15, pad_position = 120", 12, &
                  'pad_position = 120 is greater than length = 100')
      call refuse("od = 171.45", "od = 171.45, blade_offset = 5", 12, "blade_offset needs kind = 'stabilizer' and joint_od")
      call refuse("kind = 'collar', length = 100.0", "kind = 'stabilizer', joint_od = 191.45, blade_offset = 12, length = 1.0", &
                  11, 'blade_offset = 12 is greater than 10: the body would touch before')
      call refuse("diameter = 220.0", "diameter = 220.0, wear_factor = 10", 6, 'wear_factor needs casing_od')
      call refuse("diameter = 220.0", "diameter = 220.0, casing_od = 200", 6, &
                  'casing_od = 200 mm is not greater than diameter = 220 mm, the inside diameter')
      call refuse("wob = 20.0", "wob = 20.0, hours = 5", 18, 'hours needs rpm > 0')
      call refuse("od = 171.45", "od = 171.45, fatigue_curve = 'own'", 12, "fatigue_curve = 'own' needs fatigue_limit")
      call refuse("od = 171.45", "od = 171.45, fatigue_limit = 100", 12, "fatigue_limit needs fatigue_curve = 'own'")
      call refuse("od = 171.45", "od = 171.45, joint_fatigue_exponent = 5", 12, 'joint_fatigue_exponent needs joint_fatigue_limit')
   end subroutine test_wear

   !> Two faults, two messages, in the order of lines; and one slip gives one message.
   subroutine test_all_faults()
      type(run_type) :: run
      run = run_deck_text(replaced(replaced(good_deck(), 'md_bottom = 400.0', 'md_botom = 400.0'), '215.9', '-215.9'))
      call assertEqual(2, run%status)
      call assertEqual(2, times(newline, run%diagnostics), message=run%diagnostics)
      call assertTrue(index(run%diagnostics, deck_path//':6:') < index(run%diagnostics, deck_path//':9:'), &
                      message=run%diagnostics)
      run = run_deck_text(replaced(good_deck(), 'diameter = 215.9', 'diameter = wide'))
      call assertEqual(1, times(newline, run%diagnostics), message=run%diagnostics)
      call one_message(replaced(good_deck(), "name = 's'", "name = 's"), 'is not closed on its line')
      run = run_deck_text(replaced(replaced(good_deck(), "'a deck'", "'a deck', units = 'SI"//newline), '215.9', '-215.9'))
      call assertEqual(2, times(newline, run%diagnostics), message=run%diagnostics)
      call assertTrue(index(run%diagnostics, "units: the quote before 'SI") > 0, message=run%diagnostics)
      call one_message(replaced(good_deck(), "wob = 20.0", "wob = 20.0, hours = 5, rpm = nan"), 'rpm = nan is not a number')
      call one_message(replaced(replaced(good_deck(), "name = 'u'", "name = '=u'"), '  wob = 20.0 /', &
                                "  wob = 20.0, length_reference = 'u' /"), 'begins with =')
   end subroutine test_all_faults

   !> A deck with one slip gives one message, which holds a text.
   subroutine one_message(deck, expected)
      character(*), intent(in) :: deck, expected
      type(run_type) :: run
      run = run_deck_text(deck)
      call assertEqual(1, times(newline, run%diagnostics), message=run%diagnostics)
      call assertTrue(index(run%diagnostics, expected) > 0, message=run%diagnostics)
   end subroutine one_message

   pure function times(part, text) result(number)
      character(*), intent(in) :: part, text
      integer :: number
      integer :: at, found
      number = 0
      at = 1
      do
         found = index(text(at:), part)
         if (found == 0) return
         number = number + 1
         at = at + found - 1 + len(part)
      end do
   end function times

   !> A packer that holds needs its bore; a change of length counts from another case of the same string and depth; the annulus has
   !> its pressure at surface.
   subroutine test_packers()
      character(*), parameter :: packer = "packer_bore = 82.55, packer_hold = 'fixed'", top = "top_lateral = 'centred'"
      character(*), parameter :: last = '  wob = 20.0 /', reference = "  wob = 20.0, length_reference = 'u' /"
      character(:), allocatable :: text
      call refuse(top, "packer_hold = 'fixed'", 15, 'group &boundary: packer_hold needs packer_bore')
      call refuse(last, "  wob = 20.0, length_reference = 'v' /", 19, "there is no load case 'v'")
      call refuse(last, reference, 19, "length_reference 'u' has another string or bit_depth")
      call refuse(last, "  length_reference = 's' /", 19, 'has a length_reference itself')
      call refuse_text(replaced(replaced(replaced(good_deck(), top, packer), last, reference), 'depth = 800.0', 'depth = 900.0'), &
                       19, 'group &load_case: wob follows from packer_hold in a case with length_reference')
      text = replaced(replaced(good_deck(), 'depth = 800.0', 'depth = 900.0'), '&fluid', "&calibrate cases = 's' / &fluid")
      text = replaced(replaced(text, top, packer), last, "  length_reference = 'u', measured_hookload = 9 /")
      call refuse_text(text, 10, "load case 's' (line 18) is held by its packer, whose load depends on friction; leave it out")
      call refuse('density = 1200.0', "density = 1200.0, where = 'inside', surface_pressure = 5.0", 10, &
                  'surface_pressure is the pressure of the annulus')
      call refuse('density = 1200.0', 'density = 1200.0, md_top = 100, surface_pressure = 5.0', 10, &
                  'surface_pressure is the pressure of the annulus')
   end subroutine test_packers
end module dg_test_bad_decks
