!> Hints of messages go by what was meant: operations, keys and groups of other programs, numbers as people write them.
module dg_test_hints
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: deck_path, good_deck, replaced, run_deck_text, run_program, run_type
   implicit none
   private
   public :: hints_suite

   character(*), parameter :: newline = achar(10)
   !> A deck in field units.
   character(*), parameter :: field_deck = "&job units = 'field' /"//newline//'&trajectory md = 0, 9000, inc = 2*0, azi = 2*0 /'// &
      newline//'&hole md_bottom = 5000, diameter = 8.681 /'//newline//'&hole diameter = 8.5 /'//newline//'&fluid density = 10 /'// &
      newline//"&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 /"//newline// &
      '&component od = 5, id = 4.276, yield = 135 /'//newline//"&load_case name = 'u', operation = 'up', bit_depth = 9000 /"// &
      newline

contains

   function hints_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('hints')
      call suite%addTest(TestMethod('operations', test_operations))
      call suite%addTest(TestMethod('aliases_of_operations', test_aliases))
      call suite%addTest(TestMethod('names_of_other_programs', test_foreign))
      call suite%addTest(TestMethod('fractions_and_units', test_values))
      call suite%addTest(TestMethod('short_string', test_short_string))
      call suite%addTest(TestMethod('all_sections_too_narrow', test_sections))
      call suite%addTest(TestMethod('said_once', test_once))
      call suite%addTest(TestMethod('centralizers_and_fatigue', test_names))
   end function hints_suite

   !> The deck with a change is refused with these words.
   subroutine refuse(text, old, new, expected)
      character(*), intent(in) :: text, old, new, expected
      type(run_type) :: run
      run = run_deck_text(replaced(text, old, new), '--check')
      call assertEqual(2, run%status, message=new)
      call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
   end subroutine refuse

   !> The deck with a change is sound.
   subroutine pass(text, old, new)
      character(*), intent(in) :: text, old, new
      type(run_type) :: run
      run = run_deck_text(replaced(text, old, new), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine pass

   subroutine refuse_operation(name, expected)
      character(*), intent(in) :: name, expected
      call refuse(good_deck(), "'up'", "'"//name//"'", "operation = '"//name//"' is unknown; "//expected)
   end subroutine refuse_operation

   !> Never the opposite: a name as near to one operation as to another gets both.
   subroutine test_operations()
      call refuse_operation('rotate_on_botom', "did you mean 'rotary_drilling'? legal: trip_out, ")
      call refuse_operation('rotate_of_bottom', "did you mean 'rotate_off_bottom' or 'rotary_drilling'?")
      call refuse_operation('slak_off', "did you mean 'trip_in'?")
      call refuse_operation('pool', "did you mean 'trip_out'?")
      call refuse_operation('trip_up', "did you mean 'trip_out' or 'trip_in'?")
      call refuse_operation('run_out', 'legal: trip_out, ')
      call refuse_operation('pickup hole', "did you mean 'trip_out'? legal")
      call refuse_operation('tripping', "write 'trip_out' or 'trip_in'")
      call refuse_operation('overpull', "write 'trip_out' with a wob below 0")
   end subroutine test_operations

   !> Results and converted decks have the long name.
   subroutine test_aliases()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), "'up'", "'Pick-up'"), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '  u: trip_out at 900 m') > 0, message=run%output)
      run = run_program('--convert '//deck_path)
      call assertTrue(index(run%output, "operation = 'trip_out'") > 0, message=run%output)
      run = run_deck_text(good_deck()//"&sweep name = 's', operations = 'POOH', 2*'slack off', bit_depth_from = 500, "// &
                          'bit_depth_to = 900, bit_depth_step = 400, frictions = 0.2 /'//newline, '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'trip_out, trip_in; friction') > 0, message=run%output)
      run = run_program('--convert '//deck_path)
      call assertTrue(index(run%output, "operations = 'trip_out', 2*'trip_in'") > 0, message=run%output)
   end subroutine test_aliases

   subroutine test_foreign()
      call refuse(good_deck(), 'joint_od', 'tool_joint_od', "unknown key 'tool_joint_od'; did you mean 'joint_od'?")
      call refuse(good_deck(), 'joint_od', 'tj_od', "unknown key 'tj_od'; did you mean 'joint_od'?")
      call refuse(good_deck(), 'diameter = 220.0', 'id = 220.0', "unknown key 'id'; did you mean 'diameter'?")
      call refuse(good_deck(), 'density', 'mud_weight', "unknown key 'mud_weight'; did you mean 'density'?")
      call refuse(good_deck(), 'density', 'mudweight', "unknown key 'mudweight'; did you mean 'density'?")
      call refuse(good_deck(), 'joint_od', 'grade', "unknown key 'grade'; did you mean 'yield'?")
      call refuse(good_deck()//'&rig block = 100 /', '&fluid', '&fluid', "unknown key 'block'; did you mean 'block_weight'?")
      call refuse(good_deck(), 'bit_depth', 'surface_rpm = 60, bit_depth', "unknown key 'surface_rpm'; did you mean 'rpm'?")
      call refuse(good_deck(), 'bit_depth', 'back_pressure = 2, bit_depth', &
                  "unknown key 'back_pressure'; did you mean 'annulus_pressure'?")
      call refuse(good_deck(), 'bit_depth', 'flow_rate = 2000, bit_depth', "unknown key 'flow_rate'; hydraulics are not "// &
                  'calculated. Of the flow only pump_pressure of &load_case counts')
      call refuse(good_deck(), 'bit_depth', 'mud_weight = 1300, bit_depth', &
                  "unknown key 'mud_weight'; the mud stands in &fluid. "// &
                  'Write inside_density for another one within the string')
      call refuse(good_deck(), 'density', "name = 'OBM', density", "unknown key 'name'; no result depends on it. Leave it out")
      call refuse(good_deck(), 'joint_od', 'wall_thickness', "'wall_thickness'; give id, which is od less twice the wall")
      call refuse(good_deck(), 'joint_od', 'nominal_weight', "'nominal_weight'; give mass, with that of the tool joints")
      call refuse(good_deck(), 'diameter = 220.0', 'casing_id = 220.0', "unknown key 'casing_id'; did you mean 'diameter'?")
      call refuse(good_deck(), 'bit_depth', 'rop = 20, bit_depth', "unknown key 'rop'; no result depends on it. Leave it out")
      call refuse(good_deck(), 'bit_depth = 900.0', 'bit_depth = 900.0, overpull = 50', &
                  "unknown key 'overpull'; keys of similar meaning: wob. input/README.md lists all 25")
      call refuse(good_deck(), 'joint_od', 'buckling', "unknown key 'buckling'; input/README.md lists all 54")
      call refuse(good_deck(), 'friction = 0.3', 'friction_factor_open = 0.3', "unknown key 'friction_factor_open'; keys of "// &
                  'similar meaning: friction, friction_axial, ')
      call refuse(good_deck(), '&component', '&bha', "unknown group &bha; did you mean 'component'?")
      call refuse(good_deck(), '&component', '&string', "unknown group &string; did you mean 'component'?")
      call refuse(good_deck(), '&load_case', '&bitrun', "unknown group &bitrun; did you mean 'load_case'?")
      call refuse(good_deck(), '&load_case', '&loadcase', "unknown group &loadcase; did you mean 'load_case'?")
      call refuse(good_deck(), '&trajectory', '&survey', "unknown group &survey; did you mean 'trajectory'?")
      call refuse(good_deck(), '&fluid', '&mud', "unknown group &mud; did you mean 'fluid'?")
      call refuse(good_deck(), '&hole', '&casing', "unknown group &casing; did you mean 'hole'?")
      call refuse(good_deck(), '&job', '&well', "unknown group &well; did you mean 'job'?")
   end subroutine test_foreign

   subroutine test_values()
      call refuse(field_deck, 'diameter = 8.5', 'diameter = 215.9', &
                  'diameter = 215.9 is out of range; needs a number, 0.03937 to 196.85 in. Is it in mm? Then write 8.5')
      call refuse(field_deck, 'diameter = 8.5', 'diameter = 8-1/2', &
                  'diameter = 8-1/2 is not a number; needs a number, 0.03937 to '// &
                  '196.85 in; write 8.5')
      call refuse(field_deck, 'diameter = 8.5', 'diameter = 8 1/2', '2 given (8, 1/2); write 8.5')
      call refuse(field_deck, 'diameter = 8.5', "diameter = '8-1/2""'", '; write 8.5')
      call refuse(field_deck, 'diameter = 8.5', 'diameter = 8,5', '; decimals have a point: 8.5')
      call refuse(field_deck, 'diameter = 8.5', 'diameter = 8.5"', 'a number has no mark of inches behind it')
      call refuse(field_deck, 'diameter = 8.5', 'diameter = 8.5in', '; write the number alone; its unit is in')
      call refuse(field_deck, 'yield = 135', 'yield = 135 ksi', '; write the number alone; its unit is ksi')
      call refuse(field_deck, 'yield = 135', 'yield = 135000', '. Is it in psi? Then write 135')
      call refuse(field_deck, 'density = 10', 'density = 75', &
                  'Look at the density of the mud. Is it in pcf (lbm/ft3)? Then write 10.03')
      call refuse(field_deck, 'density = 10', 'density = 1260', '. Is it in kg/m3? Then write 10.52')
      call pass(field_deck, 'density = 10', 'density = 10.52')
      call refuse(replaced(field_deck, 'field', 'metric'), 'density = 10', 'density = 1260', '. Is it in kg/m3? Then write 1.26')
      call refuse(replaced(replaced(field_deck, 'field', 'metric'), 'yield = 135', 'yield = 9310'), 'density = 10', &
                  'density = 10.4', &
                  'Look at the density of the mud. Is it in lbm/gal? Then write 1.246')
   end subroutine test_values

   !> A string of tools alone needs pipe; no tool is made longer.
   subroutine test_short_string()
      call refuse(field_deck, '&component od = 5, id = 4.276, yield = 135 /', '', 'does not reach surface from bit_depth = '// &
                  '9000 ft: 8910 ft of pipe are missing; add drill pipe without a length as last component, after ''MWD'' (line 6)')
      call refuse(field_deck, 'yield = 135', 'yield = 135, length = 8000', &
                  '910 ft of pipe are missing; leave out the length of its last component (line 7)')
   end subroutine test_short_string

   !> One run tells all sections that are too narrow for all components.
   subroutine test_sections()
      type(run_type) :: run
      run = run_deck_text(replaced(replaced(field_deck, 'od = 6.75', 'od = 8.75'), 'id = 4.276', 'id = 4.276, joint_od = 8.6'), &
                          '--check')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, "does not pass the hole of 8.681 in (line 3) in case 'u'; "// &
                            'needs a diameter < 8.5 in') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'does not pass the hole of 8.5 in (line 4)') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'with couplings or joints of 8.6 in does not pass the hole of 8.5 in (line 4)') > 0, &
                      message=run%diagnostics)
   end subroutine test_sections

   !> Components of the string that is named, and a grade without a fatigue curve. With the advice the deck is sound.
   subroutine test_names()
      character(*), parameter :: liner = "&component string = 'liner', name = 'shoe', length = 5, od = 7, id = 6 /"//newline// &
         "&component string = 'liner', name = 'pipe', od = 5, id = 4.276 /"//newline, place = ', od = 8, spacing = 40 /'//newline
      call refuse(field_deck//liner//"&centralizer string = 'liner', component = 'casing'"//place, '&fluid', '&fluid', &
                  "string 'liner' has no component 'casing'; legal: shoe, pipe"//newline)
      call pass(field_deck//liner//"&centralizer string = 'liner', component = 'pipe'"//place, '&fluid', '&fluid')
      call refuse(field_deck//liner//"&centralizer string = 'linr', component = 'pipe'"//place, '&fluid', '&fluid', &
                  "string 'linr' has no component 'pipe'; no component belongs to that string. Write string = 'liner'")
      call refuse(field_deck, 'yield = 135', "yield = 105, fatigue_curve = 'G105'", "fatigue_curve = 'G105' is "// &
               "unknown; API RP 7G "// &
                  "has curves of E75 and S135 alone. For another grade write 'own', with fatigue_limit and tensile_strength")
      call pass(field_deck, 'yield = 135', "yield = 105, fatigue_curve = 'own', fatigue_limit = 19, tensile_strength = 115")
   end subroutine test_names

   !> One mistake that touches all components has one message. With its advice the deck is sound.
   subroutine test_once()
      type(run_type) :: run
      character(*), parameter :: unitless = "&job models = 'soft' /", catalogue = "catalogue = 'DP 5 19.50 NC50 S135'"
      character(:), allocatable :: text
      run = run_deck_text(replaced(field_deck, 'density = 10', 'density = 75'), '--check')
      call assertEqual(2, run%status)
      call assertEqual(index(run%diagnostics, 'floats'), index(run%diagnostics, 'floats', back=.true.), message=run%diagnostics)
      text = replaced(replaced(field_deck, "&job units = 'field' /", unitless), 'od = 5, id = 4.276, yield = 135', catalogue)
      text = replaced(text, "kind = 'collar', length = 90, od = 6.75, id = 3.25", &
                      "catalogue = 'DC 6-3/4 2-13/16 NC50', length = 90")
      run = run_deck_text(text, '--check')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, "its numbers look like field: a hole of 8.681 in, mud of 10 lbm/gal. "// &
                            "Write units = 'field' in &job") > 0, &
                      message=run%diagnostics)
      call assertEqual(index(run%diagnostics, newline), len(run%diagnostics), message='one line: '//run%diagnostics)
      call pass(text, "models = 'soft'", "units = 'field'")
      ! Pipe that is typed in passes the hole.
      call refuse(replaced(field_deck, '&fluid density = 10 /'//newline, ''), "&job units = 'field' /", unitless, &
                  "group &hole: diameter = 8.681 mm: are these inches? Write units = 'metric' or 'field' in &job")
      ! Holes alone in inches.
      text = replaced(replaced(field_deck, 'density = 10', 'density = 1200'), "&job units = 'field' /", unitless)
      call refuse(text, 'od = 5, id = 4.276, yield = 135', 'od = 127, id = 108.6', &
                  'does not pass the hole of 8.681 mm (line 3)')
      ! A model of it in a laboratory.
      text = replaced(replaced(field_deck, "&job units = 'field' /", unitless), 'md = 0, 9000', 'md = 0, 90')
      text = replaced(text, 'density = 10', 'density = 1000')
      text = replaced(replaced(text, 'md_bottom = 5000', 'md_bottom = 50'), 'length = 90', 'length = 9')
      call pass(text, 'bit_depth = 9000', 'bit_depth = 90')
   end subroutine test_once
end module dg_test_hints
