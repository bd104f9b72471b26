!> Numbers in another unit than the deck's: the message names the unit and the right number, and with that the deck is sound.
module dg_test_followed_units
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: replaced, run_deck_text, run_type
   implicit none
   private
   public :: followed_units_suite

   character(*), parameter :: newline = achar(10)

contains

   function followed_units_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('followed_units')
      call suite%addTest(TestMethod('sound_decks', test_sound))
      call suite%addTest(TestMethod('usual_ranges', test_ranges))
      call suite%addTest(TestMethod('temperatures_and_times', test_temperatures))
      call suite%addTest(TestMethod('hook_loads', test_hook_loads))
      call suite%addTest(TestMethod('stiffness_and_drag', test_stiffness_and_drag))
      call suite%addTest(TestMethod('snubbing', test_snubbing))
      call suite%addTest(TestMethod('casing_and_tubing', test_casing))
      call suite%addTest(TestMethod('pump_and_motor', test_motor))
      call suite%addTest(TestMethod('crossing_under_a_river', test_crossing))
      call suite%addTest(TestMethod('diameters', test_diameters))
      call suite%addTest(TestMethod('systems', test_systems))
      call suite%addTest(TestMethod('mud_weights', test_mud_weights))
      call suite%addTest(TestMethod('weight_on_bit', test_weight_on_bit))
      call suite%addTest(TestMethod('pressures_and_widths', test_pressures))
      call suite%addTest(TestMethod('daN_or_lbf', test_restoring))
      call suite%addTest(TestMethod('joints_and_fatigue', test_joints))
      call suite%addTest(TestMethod('small_bows', test_bows))
      call suite%addTest(TestMethod('deviations', test_deviations))
   end function followed_units_suite

   !> A deviated well in SI, or in the units of the field.
   function well(units) result(text)
      character(*), intent(in) :: units
      character(:), allocatable :: text
      if (units == 'SI') then
         text = "&job plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
            "&trajectory md = 0, 400, 1400, 4200, inc = 0, 0, 60, 60, azi = 4*60 /"//newline// &
            "&hole name = 'casing', md_bottom = 2000, diameter = 220.5, friction = 0.2, cased = .true. /"//newline// &
            "&hole name = 'open', diameter = 215.9, friction = 0.3 /"//newline// &
            "&fluid density = 1300 /"//newline// &
            "&component name = 'bit', kind = 'bit', length = 0.3, od = 150, joint_od = 215.9 /"//newline// &
            "&component name = 'MWD', kind = 'mwd', length = 30, od = 171.4, id = 71.4 /"//newline// &
            "&component name = 'DP', od = 127, id = 108.6, mass = 32, joint_od = 168.3, yield = 931 /"//newline// &
            "&rig block_weight = 350, max_hookload = 2200, max_torque = 52 /"//newline// &
            "&load_case name = 'up', operation = 'trip_out', bit_depth = 4200 /"//newline// &
            "&load_case name = 'turn', operation = 'rotary_drilling', bit_depth = 4200, wob = 80, tob = 8 /"//newline
      else
         text = "&job units = '"//units//"', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
            "&trajectory md = 0, 2000, 3000, 12000, inc = 0, 0, 60, 60, azi = 4*45 /"//newline// &
            "&hole name = 'casing', md_bottom = 7000, diameter = 8.681, friction = 0.2, cased = .true. /"//newline// &
            "&hole name = 'open', diameter = 8.5, friction = 0.3 /"//newline// &
            "&fluid density = 10.2 /"//newline// &
            "&component name = 'bit', kind = 'bit', length = 1, od = 6, joint_od = 8.5 /"//newline// &
            "&component name = 'MWD', kind = 'mwd', length = 90, od = 6.75, id = 3.25 /"//newline// &
            "&component name = 'DP', od = 5, id = 4.276, mass = 21.5, joint_od = 6.625, yield = 135 /"//newline// &
            "&rig block_weight = 60, max_hookload = 750, max_torque = 50 /"//newline// &
            "&load_case name = 'up', operation = 'trip_out', bit_depth = 12000 /"//newline// &
            "&load_case name = 'turn', operation = 'rotary_drilling', bit_depth = 12000, wob = 25, tob = 5 /"//newline
      end if
      if (units /= 'metric') return
      text = replaced(replaced(replaced(text, 'density = 10.2', 'density = 1.22'), 'mass = 21.5', 'mass = 32'), '135', '9310')
      text = replaced(replaced(replaced(text, '0, 2000, 3000, 12000', '0, 600, 1600, 4000'), '12000', '4000'), '12000', '4000')
      text = replaced(replaced(replaced(text, '= 7000', '= 2000'), '= 750', '= 250'), '= 90', '= 30')
      text = replaced(replaced(text, 'weight = 60', 'weight = 30'), 'length = 1,', 'length = 0.3,')
   end function well

   !> With `wrong` in place of `sound` the deck has a message that holds `expected`, with `right` it has none.
   subroutine follow(units, sound, wrong, expected, right)
      character(*), intent(in) :: units, sound, wrong, expected, right
      type(run_type) :: run
      run = run_deck_text(replaced(well(units), sound, wrong), '--check')
      call assertTrue(index(run%output//run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%output// &
                      run%diagnostics)
      call silent(units, sound, right)
   end subroutine follow

   !> With `right` in place of `sound` the deck has neither fault nor note.
   subroutine silent(units, sound, right)
      character(*), intent(in) :: units, sound, right
      type(run_type) :: run
      run = run_deck_text(replaced(well(units), sound, right), '--check')
      call assertEqual(0, run%status, message=right//': '//run%diagnostics)
      call assertEqual(0, index(run%output, newline//'note '), message=right//': '//run%output)
   end subroutine silent

   subroutine test_sound()
      call silent('SI', '&fluid', '&fluid')
      call silent('field', '&fluid', '&fluid')
   end subroutine test_sound

   subroutine test_ranges()
      call follow('SI', 'tob = 8 ', 'tob = 8, pump_pressure = 210 ', 'Is it in bar? Then write 21', 'tob = 8, '// &
               'pump_pressure = 21 ')
      call follow('field', 'tob = 5 ', 'tob = 5, pump_pressure = 20.7 ', 'Is it in MPa? Then write 3002', &
                  'tob = 5, pump_pressure = 3002 ')
      call follow('SI', 'yield = 931', 'yield = 135', 'Is it in ksi? Then write 930.8', 'yield = 930.8')
      call follow('SI', 'wob = 80', 'wob = 8000', 'Is it in N? Then write 8. Is it in kg? Then write 78.45', 'wob = 78.45')
      call follow('SI', 'tob = 8 ', 'tob = 800 ', 'Is it in daN.m? Then write 8', 'tob = 8 ')
      call follow('field', 'tob = 5 ', 'tob = 5, rpm = 2 ', 'Is it in rev/s? Then write 120', 'tob = 5, rpm = 120 ')
      call follow('field', 'yield', 'joint_spacing = 9.5, yield', 'Is it in m? Then write 31.17', 'joint_spacing = 31.17, yield')
      call follow('field', "'field'", "'field', gravity = 32.2", 'Is it in ft/s2? Then write 9.815', "'field', gravity = 9.815")
      call follow('field', 'cased = .true.', 'cased = .true., casing_od = 9.625, wear_factor = 1e-9', &
                  'Is it in 1/psi? Then write 10', 'cased = .true., casing_od = 9.625, wear_factor = 10')
      call follow('SI', "'trip_out'", "'backream', rpm = 60, trip_speed = 18", 'Is it in m/min? Then write 0.3', &
                  "'backream', rpm = 60, trip_speed = 0.3")
      call follow('SI', '&rig', '&strength slip_length = 0.4 / &rig', 'group &strength: slip_length = 0.4 mm is unusual. Usual '// &
                  'is at least 100 mm. Is it in m? Then write 400', '&strength slip_length = 400 / &rig')
      call follow('field', '&rig', '&strength slip_length = 0.4064 / &rig', 'slip_length = 0.4064 in is unusual. Usual is '// &
                  'at least 3.937 in. Is it in m? Then write 16', '&strength slip_length = 16 / &rig')
   end subroutine test_ranges

   !> Bow springs that are smaller than the whole hole, and than the casing alone.
   subroutine test_bows()
      character(*), parameter :: bows = "&centralizer component = 'DP', kind = 'bow', spacing = 12, restoring_force = 7, od = "
      call follow('SI', '&rig', bows//'200 / &rig', "group &centralizer of 'DP': od = 200 mm of its bow springs is smaller "// &
                  'than the hole, 215.9 mm and more where they stand', bows//'220 / &rig')
      call silent('SI', '&rig', bows//'216 / &rig')
   end subroutine test_bows

   !> A force of a catalogue in lbf is as likely as one in daN.
   subroutine test_restoring()
      character(*), parameter :: bows = "&centralizer component = 'DP', kind = 'bow', spacing = 12, od = 8.6, restoring_force = "
      call follow('metric', '&rig', bows//'1700 / &rig', 'restoring_force = 1700 kdaN is unusual. Usual is at most 5 kdaN. '// &
                  'Is it in daN? Then write 1.7. Is it in lbf? Then write 0.7562', bows//'0.7562 / &rig')
   end subroutine test_restoring

   !> Strength and bore of tool joints, strength of an own fatigue curve.
   subroutine test_joints()
      character(*), parameter :: own = "yield = 931, fatigue_curve = 'own', fatigue_limit = "
      call follow('SI', 'yield = 931', "yield = 931, connection = 'NC50', joint_id = 82.6, joint_yield = 120", &
                  'joint_yield = 120 MPa is unusual. Usual is at least 150 MPa. Is it in ksi? Then write 827.4', &
                  "yield = 931, connection = 'NC50', joint_id = 82.6, joint_yield = 827.4")
      call follow('SI', 'yield = 931', 'yield = 931, joint_id = 3.25', 'joint_id = 3.25 mm is unusual. Usual is at least '// &
                  '15 mm. Is it in inches? Then write 82.55', 'yield = 931, joint_id = 82.55')
      call follow('SI', 'yield = 931', own//'20', 'fatigue_limit = 20 MPa is unusual. Usual is at least 30 MPa. Is it in ksi? '// &
                  'Then write 137.9', own//'137.9')
      call follow('field', 'yield = 135', "yield = 135, fatigue_curve = 'own', fatigue_limit = 138", 'fatigue_limit = 138 ksi '// &
                  'is unusual. Usual is at most 87 ksi. Is it in MPa? Then write 20.02', &
                  "yield = 135, fatigue_curve = 'own', fatigue_limit = 20.02")
      call follow('SI', 'yield = 931', 'yield = 931, joint_fatigue_limit = 10', 'joint_fatigue_limit = 10 MPa is unusual. '// &
                  'Usual is at least 15 MPa. Is it in ksi? Then write 68.95', 'yield = 931, joint_fatigue_limit = 68.95')
      call follow('field', 'yield = 135', "yield = 135, fatigue_curve = 'own', fatigue_limit = 20, tensile_strength = 11.5", &
                  'tensile_strength = 11.5 ksi is unusual. Usual is at least 29.01 ksi. Check the unit', &
                  "yield = 135, fatigue_curve = 'own', fatigue_limit = 20, tensile_strength = 115")
   end subroutine test_joints

   !> Standard deviations of studies.
   subroutine test_deviations()
      character(*), parameter :: study = "&uncertainty operations = 'trip_out', model = 'soft', bit_depth_from = 4000, "// &
         "samples = 50, "
      call follow('metric', '&fluid', study//'density_deviation = 20 / &fluid', 'group &uncertainty: density_deviation = 20 sg '// &
                  'is unusual. Usual is at most 0.54 sg. Is it in kg/m3? Then write 0.02', &
                  study//'density_deviation = 0.02 / &fluid')
      call follow('SI', '&fluid', study//'hookload_deviation = 20000 / &fluid', 'hookload_deviation = 20000 kN is unusual. '// &
                  'Usual is at most 3600 kN. Is it in N? Then write 20', study//'hookload_deviation = 20 / &fluid')
      call follow('SI', '&fluid', study//'torque_deviation = 1000 / &fluid', 'torque_deviation = 1000 kN.m is unusual. Usual '// &
                  'is at most 40 kN.m. Is it in N.m? Then write 1', study//'torque_deviation = 1 / &fluid')
      call follow('SI', '&fluid', study//'friction_deviation = 0.4 / &fluid', 'friction_deviation = 0.4 is unusual. Usual is '// &
                  'at most 0.2', study//'friction_deviation = 0.04 / &fluid')
   end subroutine test_deviations

   !> Numbers of casing, completion and rig that were read in another unit.
   subroutine test_pressures()
      character(*), parameter :: bow = "&centralizer component = 'DP', kind = 'bow', spacing = 12, restoring_force = 7, "
      type(run_type) :: run
      run = run_deck_text(replaced(well('SI'), 'density = 1300', 'density = 1300, surface_pressure = 250'), '--check')
      call assertTrue(index(run%output, 'surface_pressure = 250 MPa is unusual. Usual is at most 105 MPa. Is it in bar? Then '// &
                            'write 25') > 0, message=run%output)
      run = run_deck_text(replaced(well('SI'), 'tob = 8 ', 'tob = 8, annulus_pressure = 150 '), '--check')
      call assertTrue(index(run%output, 'annulus_pressure = 150 MPa is unusual. Usual is at most 105 MPa. Is it in bar? Then '// &
                            'write 15. Is it in psi? Then write 1.034') > 0, message=run%output)
      call follow('SI', 'cased = .true.', 'cased = .true., casing_od = 244.5, casing_yield = 80', 'casing_yield = 80 MPa is '// &
                  'unusual. Usual is at least 150 MPa. Is it in ksi? Then write 551.6', &
                  'cased = .true., casing_od = 244.5, casing_yield = 551.6')
      call follow('SI', 'diameter = 215.9', 'diameter = 2159', "'open': diameter = 2159 mm is unusual. Usual is at most 1600 mm", &
                  'diameter = 215.9')
      call follow('SI', '&fluid', '&boundary packer_bore = 4 / &fluid', 'packer_bore = 4 mm is unusual. Usual is at least '// &
                  '20 mm. Is it in inches? Then write 101.6', '&boundary packer_bore = 101.6 / &fluid')
      call follow('SI', 'yield = 931', 'yield = 931, tension_efficiency = 10, compression_efficiency = 6', 'tension_efficiency '// &
                  '= 10 is unusual. Usual is at most 2', 'yield = 931, tension_efficiency = 1, compression_efficiency = 0.6')
      call follow('SI', 'max_hookload = 2200', 'max_hookload = 500', 'block_weight = 350 kN is 70 % of max_hookload. Is '// &
                  'max_hookload in klbf? Then write 2224', 'max_hookload = 2224')
      run = run_deck_text(replaced(well('SI'), 'block_weight = 350', 'block_weight = 35000'), '--check')
      call assertTrue(index(run%output, 'block_weight = 35000 kN is unusual') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'The rig carries'), message=run%output)
      call follow('SI', 'od = 150, joint', 'od = 6, joint', "'bit': od = 6 mm is small for joint_od = 215.9 mm. Is od in "// &
                  'inches? Then write 152.4', 'od = 152.4, joint')
      call follow('SI', 'id = 108.6, mass = 32', 'id = 4.276', 'leaves a wall of 61.36 mm. Is it in inches? '// &
                  'Then write 108.6. Is id the wall? Then write id = 118.4', 'id = 108.6, mass = 32')
      call follow('SI', 'joint_od = 168.3', 'joint_od = 6.625', 'joint_od = 6.625 is smaller than od = 127. Is it in inches? '// &
                  'Then write 168.3', 'joint_od = 168.3')
      call follow('SI', '&rig', bow//'od = 8.5 / &rig', 'Is it in inches? Then write 215.9', bow//'od = 215.9 / &rig')
      call follow('SI', '&rig', bow//'od = 220, rated_hole = 8.5 / &rig', 'Is it in inches? Then write 215.9', &
                  bow//'od = 220, rated_hole = 215.9 / &rig')
      call follow('SI', 'yield = 931', "yield = 724, fatigue_curve = 'S135'", "fatigue_curve = 'S135' is of stronger pipe than "// &
                  "yield = 724 MPa. Write 'E75', or 'own' with fatigue_limit", "yield = 724, fatigue_curve = 'E75'")
   end subroutine test_pressures

   subroutine test_stiffness_and_drag()
      character(*), parameter :: bows = "&centralizer component = 'DP', kind = 'bow', od = 220, spacing = 12, "// &
               "restoring_force = 7, "// &
         'running_force = '
      call follow('SI', 'friction = 0.3 ', 'friction = 0.3, wall_stiffness = 30 ', "'open': wall_stiffness = 30 kN/m2 is "// &
                  'unusual. Usual is at least 50 kN/m2. Is it in GPa? Then write 3e7', 'friction = 0.3, wall_stiffness = 3e7 ')
      call follow('SI', '&rig', bows//'350 / &rig', 'of ''DP'': running_force = 350 kN is '// &
                  'unusual. Usual is at most 20 kN. Is it in N? '// &
                  'Then write 0.35', bows//'0.35 / &rig')
      call follow('SI', 'friction = 0.3 ', 'friction = 0.3, wall_stiffness = 2e4 ', 'wall_stiffness = 20000 kN/m2 is unusual. '// &
                  'Usual is at least 100000 kN/m2. Is it in MPa? Then write 2e7', 'friction = 0.3, wall_stiffness = 2e7 ')
      call follow('SI', 'friction = 0.3 ', 'friction = 0.3, wall_stiffness = 2e10 ', 'wall_stiffness = 2e10 kN/m2 is unusual. '// &
                  'Usual is at most 1e9 kN/m2. Is it in N/m2? Then write 2e7', 'friction = 0.3, wall_stiffness = 2e7 ')
   end subroutine test_stiffness_and_drag

   subroutine test_temperatures()
      call follow('SI', 'tob = 8 ', 'tob = 8, above_ambient_bottom = 473 ', 'Is it a temperature? Then write 176', &
                  'tob = 8, above_ambient_bottom = 176 ')
      call follow('SI', 'tob = 8 ', 'tob = 8, temperature_change_bottom = 373 ', &
                  'Is it a temperature? Then write its rise since the string was run', 'tob = 8, temperature_change_bottom = 76 ')
      call follow('SI', 'tob = 8 ', 'tob = 8, rpm = 100, hours = 5000 ', 'Is it in minutes? Then write 83.33', &
                  'tob = 8, rpm = 100, hours = 83.33 ')
   end subroutine test_temperatures

   !> Of a case, of another program, of a sweep.
   subroutine test_hook_loads()
      character(*), parameter :: sweep = "&sweep operations = 'trip_out', bit_depth_from = 3800, bit_depth_step = 400, "// &
         "measured_depths = 3900, 4000, measured_operations = 'trip_out', "
      call follow('SI', "'trip_out',", "'trip_out', measured_hookload = 150,", 'Is the hook load in t? Then write 1471', &
                  "'trip_out', measured_hookload = 1471,")
      call follow('field', "'trip_out',", "'trip_out', measured_hookload = 1100,", 'Is the hook load in kN? Then write 247.3', &
                  "'trip_out', measured_hookload = 247.3,")
      call follow('SI', "'trip_out',", "'trip_out', reference_hookload = 110,", "'up': reference_hookload = 110 kN is", &
                  "'trip_out', reference_hookload = 1100,")
      call follow('SI', '&fluid', sweep//'measured_hookloads = 150, 1450 / &fluid', &
                  'group &sweep: measured_hookloads at 3900 m = 150 kN is 15 % of what string and block weigh in mud', &
                  sweep//'measured_hookloads = 1471, 1450 / &fluid')
   end subroutine test_hook_loads

   !> Pressure of the annulus pushes pipe out: what the hook bears is less, down to nothing.
   subroutine test_snubbing()
      call unasked('reference_hookload = 300')
      call unasked('reference_hookload = 30')
   contains
      subroutine unasked(load)
         character(*), intent(in) :: load
         type(run_type) :: run
         run = run_deck_text(replaced(well('SI'), "'trip_out',", "'trip_out', annulus_pressure = 35, "//load//","), '--check')
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertEqual(0, index(run%output, load//' kN is'), message=run%output)
      end subroutine unasked
   end subroutine test_snubbing

   !> Distance of centralizers, and mass of insulated tubing.
   subroutine test_casing()
      type(run_type) :: run
      character(*), parameter :: sound = "'DP', od = 5, id = 4.276, mass = 21.5, joint_od = 6.625, yield = 135 /", &
         casing = "'DP', kind = 'casing', od = 5, id = 4.276, mass = 18, yield = 135 / &centralizer component = 'DP', "// &
                  "kind = 'bow', od = 8.5, restoring_force = 1, spacing = "
      call follow('field', sound, casing//'12 /', 'group &centralizer of ''DP'': spacing = 12 ft is unusual. Usual is at '// &
                  'least 13.12 ft. Is it in m? Then write 39.37', casing//'39.37 /')
      run = run_deck_text(replaced(replaced(well('SI'), 'mass = 32', 'mass = 21.5'), "'DP',", "'DP', kind = 'VIT',"), '--check')
      call assertTrue(index(run%output, 'mass = 21.5, but a tube of its od, id and density has 26.73') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'lbm/ft'), message=run%output)
   end subroutine test_casing

   !> Pressure that is too low to drill with a motor. Air does.
   subroutine test_motor()
      call drill('250', "pump_pressure = 250 psi is too low for 'MWD' to drill. Usual is at least 440 psi. Is pump_pressure in "// &
                 'bar? Then write 3626')
      call drill('3626', '')
      call drill('250, inside_density = 0.02', '')
      ! a bend is left out where the string rotates, which no warning can mend
      call silent('SI', "kind = 'mwd', length = 30", "kind = 'motor', bend = 1.5, bend_position = 2, length = 30")
   contains
      subroutine drill(pressure, expected)
         character(*), intent(in) :: pressure, expected
         type(run_type) :: run
         run = run_deck_text(replaced(replaced(well('field'), "'mwd'", "'motor'"), 'tob = 5 ', 'tob = 5, pump_pressure = '// &
                                      pressure//' '), '--check')
         call assertEqual(0, run%status, message=run%diagnostics)
         if (expected == '') call assertEqual(0, index(run%output, 'too low'), message=run%output)
         call assertTrue(index(run%output, expected) > 0, message='wanted: '//expected//'; got: '//run%output)
      end subroutine drill
   end subroutine test_motor

   !> A pipe that is pulled through a crossing under a river: drag is all.
   subroutine test_crossing()
      type(run_type) :: run
      character(*), parameter :: path = 'md = 0, 60, 400, 700, 760, inc = 78, 78, 90, 98, 98, azi = 5*10'
      character(:), allocatable :: deck
      deck = "&job plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory "//path//", tie_on = 'straight' /"//newline// &
         "&hole diameter = 914, friction = 0.3, wall_stiffness = 2e4 /"//newline//"&fluid density = 1150 /"//newline// &
         "&component name = 'pipe', kind = 'casing', od = 609.6, id = 581.2, joint_od = 620 /"//newline// &
         "&load_case name = 'pull', operation = 'trip_out', bit_depth = 760, measured_hookload = 900 /"//newline
      run = run_deck_text(deck, '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, newline//'note '), message=run%output)
      run = run_deck_text(replaced(deck, path, 'md = 0, 100, 250, 550, 700, 800, inc = 78, 78, 90, 90, 102, 102, azi = 6*90'), &
                          '--check')
      call assertTrue(index(run%output, 'Well to 800 m, true vertical depth 0 m, at most 36.442 m. ') > 0, message=run%output)
   end subroutine test_crossing

   !> Holes and pipe in inches or metres. One message for a hole that nothing passes.
   subroutine test_diameters()
      type(run_type) :: run
      call follow('SI', 'diameter = 215.9', 'diameter = 8.5', "'bit' with 215.9 mm does not pass the hole of 8.5 mm (line 4) "// &
                  "in case 'up'. Look at the diameter of that hole. Is it in inches? Then write 215.9", 'diameter = 215.9')
      run = run_deck_text(replaced(well('SI'), 'diameter = 215.9', 'diameter = 8.5'), '--check')
      call assertEqual(index(run%diagnostics, newline), len(run%diagnostics), message='one line: '//run%diagnostics)
      call follow('SI', 'diameter = 215.9', 'diameter = 21.59', &
                  'Is it in inches? Then write 548.4. Is it in cm? Then write 215.9', &
                  'diameter = 215.9')
      call follow('SI', 'diameter = 220.5', 'diameter = 0.2205', 'out of range; needs a number, 1 to 5000 mm. Is it in m? '// &
                  'Then write 220.5', 'diameter = 220.5')
      call follow('field', 'diameter = 8.5,', 'diameter = 0.216,', 'Look at the diameter of that hole. Is it in m? '// &
               'Then write '// &
                  '8.504', 'diameter = 8.504,')
      call follow('SI', 'od = 127, id = 108.6, mass = 32, joint_od = 168.3', 'od = 5, id = 4.276, mass = 32, joint_od = 6.625', &
                  "'DP': it is 6.625 mm wide in holes of 215.9 mm and more; mind the units of od, id and joint_od. Is joint_od "// &
                  'in inches? Then write 168.3', &
                  'od = 127, id = 108.6, mass = 32, joint_od = 168.3')
      call follow('SI', 'od = 127, id = 108.6, mass', 'od = 5, id = 4.276, mass', 'has 0.04141; mind the units, and the '// &
                  'density of what is not steel. Is od in inches? Then write 127. Is id in inches? Then write 108.6', &
                  'od = 127, id = 108.6, mass')
      call follow('field', 'od = 5, id = 4.276, mass = 21.5, joint_od = 6.625', 'od = 127, id = 108.6, joint_od = 168.3', &
                  "'DP' with couplings or joints of 168.3 in does not pass the hole of 8.681 in (line 3) in case 'up'. "// &
                  'Diameters of this deck are in in. Is this one in mm? Then write 6.626', &
                  'od = 5, id = 4.276, mass = 21.5, joint_od = 6.626')
      run = run_deck_text(replaced(well('field'), 'od = 6.75, id = 3.25 /'//newline//"&component name = 'DP', od = 5, "// &
                                   'id = 4.276', 'od = 171.4, id = 71.4 /'//newline//"&component name = 'DP', od = 127, "// &
                                   'id = 108.6'), '--check')
      call assertEqual(index(run%diagnostics, newline), len(run%diagnostics), message='one line: '//run%diagnostics)
      call follow('SI', 'mass = 32', 'mass = 21.5', 'mind the units, and the density of what is not steel. Is mass in lbm/ft? '// &
                  'Then write 32', 'mass = 32')
   end subroutine test_diameters

   !> Decks whose units are forgotten or wrong have one message. With its advice they are sound.
   subroutine test_systems()
      character(*), parameter :: field = "units = 'field', ", metric = "units = 'metric', "
      character(:), allocatable :: deck
      call swap(well('field'), field, '', field, 'group &job: the deck is read in units SI, its numbers look like '// &
               'field: a hole '// &
                "of 8.681 in, mud of 10.2 lbm/gal. Write units = 'field' in &job")
      call swap(well('field'), field, "units = 'SI', ", field, "Write units = 'field' in &job. Depths are then in ft, "// &
               "forces in "// &
                'klbf')
      call swap(well('SI'), '&job ', '&job '//field, '&job ', 'its numbers look like SI: a hole of 220.5 mm, mud of '// &
               '1300 kg/m3. '// &
                "Write units = 'SI' in &job. Depths are then in m, forces in kN")
      call swap(well('SI'), '&job ', '&job '//metric, '&job ', "Write units = 'SI' in &job")
      deck = replaced(replaced(replaced(well('field'), 'density = 10.2', 'density = 1.22'), 'mass = 21.5', 'mass = 32'), &
                      'yield = 135', 'yield = 9310')
      call swap(deck, field, '', metric, "its numbers look like metric: a hole of 8.681 in, mud of 1.22 sg. Write units = "// &
                "'metric' in &job")
      call swap(deck, field, field, metric, 'read in units field, its numbers look like metric: a hole of 8.681 in, mud of '// &
                "1.22 sg. Write units = 'metric' in &job. Depths are then in m, forces in kdaN")
      call swap(well('field'), field, metric, field, 'read in units metric, its numbers look like field: a hole of 8.681 in, '// &
                "mud of 10.2 lbm/gal. Write units = 'field' in &job")
      deck = replaced(replaced(deck, 'mass = 32, joint_od', 'joint_od'), ', yield = 9310', '')
      call swap(replaced(deck, 'tob = 5 ', 'tob = 5, pump_pressure = 200 '), field, field, metric, 'its numbers look like metric')
      deck = replaced(replaced(well('SI'), 'md_bottom = 2000, ', ''), "'open',", "'open', md_top = 2000,")
      call swap(deck, '&job ', '&job '//field, '&job ', "Write units = 'SI' in &job")
      deck = replaced(well('SI'), 'density = 1300', "density = 1300, where = 'outside' / &fluid where = 'inside', density = 1.2")
      call swap(deck, '&job ', '&job '//field, '&job ', 'its numbers look like SI: a hole of 220.5 mm, mud of 1300 kg/m3')
      deck = replaced(well('field'), "&hole name = 'casing'", "&hole name = 'conductor', md_bottom = 100, diameter = 48, "// &
                      "friction = 0.2, cased = .true. / &hole name = 'casing'")
      call swap(deck, field, '', field, "its numbers look like field: a hole of 48 in, mud of 10.2 lbm/gal. Write units = 'field'")
   contains
      subroutine swap(text, sound, wrong, right, expected)
         character(*), intent(in) :: text, sound, wrong, right, expected
         type(run_type) :: run
         run = run_deck_text(replaced(text, sound, wrong), '--check')
         call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
         call assertEqual(index(run%diagnostics, newline), len(run%diagnostics), message='one line: '//run%diagnostics)
         run = run_deck_text(replaced(text, sound, right), '--check')
         call assertEqual(0, run%status, message=run%diagnostics)
      end subroutine swap
   end subroutine test_systems

   !> Mud weights of both sides and of one. Gas, air and hydrogen of one side are right.
   subroutine test_mud_weights()
      character(*), parameter :: inside = 'tob = 8, inside_density = ', still = 'is neither a liquid nor air. Is it in ', &
         fluids = "where = 'outside' / &fluid where = 'inside', density = "
      type(run_type) :: run
      call follow('field', 'density = 10.2', 'density = 0.53', 'Is it in psi/ft? Then write 10.2', 'density = 10.2')
      call follow('SI', 'density = 1300', 'density = 0.55', 'Is it in psi/ft? Then write 1269', 'density = 1269')
      call follow('SI', 'density = 1300', 'density = 80', 'Is it in pcf (lbm/ft3)? Then write 1281', 'density = 1281')
      call follow('field', 'density = 10.2', 'density = 1.22', 'Is it in sg? Then write 10.18. If depths are in '// &
                  "m, write units = 'metric' in &job", 'density = 10.18')
      call follow('metric', 'density = 1.22', 'density = 10.2', 'Is it in lbm/gal? Then write 1.222. Is it in kPa/m? Then '// &
                  "write 1.04. If depths are in ft, write units = 'field' in &job", 'density = 1.222')
      call follow('SI', 'density = 1300', 'density = 12.5', 'Is it in lbm/gal? Then write 1498. Is it in kPa/m? Then write 1275', &
                  'density = 1275')
      run = run_deck_text(replaced(well('SI'), 'density = 1300', 'density = 80, surface_pressure = 8'), '--check')
      call assertTrue(index(run%output, 'density = 80 kg/m3 is that of a gas or foam, water has 1000 kg/m3'//newline) > 0, &
                      message=run%output)
      call follow('SI', 'tob = 8 ', inside//'1.3 ', 'inside_density = 1.3 kg/m3 '//still//'sg? Then write 1300', inside//'1300 ')
      call follow('SI', 'density = 1300', 'density = 1300, '//fluids//'1.3', 'group &fluid in line 5: density = 1.3 '// &
               'kg/m3 '//still, &
                  'density = 1300, '//fluids//'1300')
      call follow('metric', 'tob = 5 ', 'tob = 5, inside_density = 15.8 ', "'turn': inside_density = 15.8 sg is unusual. Usual "// &
                  'is at most 2.7 sg. Is it in lbm/gal? Then write 1.893', 'tob = 5, inside_density = 1.22 ')
      run = run_deck_text(replaced(well('metric'), 'tob = 5 ', 'tob = 5, inside_density = 15.8 '), '--check')
      call assertEqual(index(run%output, newline//'note '), index(run%output, newline//'note ', back=.true.), &
                       message='a single note: '//run%output)
      call unasked('1.2')
      call unasked('150, pump_pressure = 20')
      call unasked('14, pump_pressure = 20')
      call unasked('120')
      call unasked('0.87')
      call unasked('2, annulus_pressure = 0.1')
   contains
      !> A density inside that is no mistake: the only note is on the float valve.
      subroutine unasked(density)
         character(*), intent(in) :: density
         type(run_type) :: run
         run = run_deck_text(replaced(well('SI'), 'tob = 8 ', inside//density//' '), '--check')
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertEqual(0, index(run%output, still), message=run%output)
      end subroutine unasked
   end subroutine test_mud_weights

   !> Weight on bit and overpull. Tonnes are known by the torque on bit.
   subroutine test_weight_on_bit()
      call follow('field', 'wob = 25', 'wob = 110', 'wob = 110 klbf is large for a hole of 8.5 in. Usual is at most '// &
               '60 klbf. Is wob '// &
                  'in kN? Then write 24.73', 'wob = 24.73')
      call follow('field', 'wob = 25', 'wob = 20000', 'Is it in lbf? Then write 20', 'wob = 20')
      call follow('metric', 'wob = 25', 'wob = 120', 'Is it in kN? Then write 12', 'wob = 12')
      call follow('SI', 'wob = 80', 'wob = 8', 'Is wob in tonnes? 8 t are 78.45 kN', 'wob = 78.45')
      call follow('field', "'trip_out',", "'trip_out', wob = -20000,", 'wob = -20000 klbf is unusual. Usual is at least '// &
                  '-674.4 klbf. Is it in lbf? Then write -20', "'trip_out', wob = -20,")
   end subroutine test_weight_on_bit
end module dg_test_followed_units
