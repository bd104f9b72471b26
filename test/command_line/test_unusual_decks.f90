!> Decks that are legal and hardly meant: each mistake has its note, and with what the note advises the note is gone.
module dg_test_unusual_decks
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: replaced, run_deck_text, run_type
   implicit none
   private
   public :: unusual_decks_suite

   character(*), parameter :: newline = achar(10)

contains

   function unusual_decks_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('unusual_decks')
      call suite%addTest(TestMethod('nothing_unusual', test_nothing_unusual))
      call suite%addTest(TestMethod('survey', test_survey))
      call suite%addTest(TestMethod('gap_in_survey', test_gap))
      call suite%addTest(TestMethod('radians', test_radians))
      call suite%addTest(TestMethod('azimuths', test_azimuths))
      call suite%addTest(TestMethod('string', test_string))
      call suite%addTest(TestMethod('fluid_and_friction', test_fluid_and_friction))
      call suite%addTest(TestMethod('loads', test_loads))
      call suite%addTest(TestMethod('set_down', test_set_down))
      call suite%addTest(TestMethod('ways_of_loads', test_ways))
      call suite%addTest(TestMethod('conditions', test_conditions))
      call suite%addTest(TestMethod('measured_and_block', test_measured))
      call suite%addTest(TestMethod('sections_and_collars', test_sections))
      call suite%addTest(TestMethod('materials_and_places', test_materials))
      call suite%addTest(TestMethod('rig_and_hole', test_rig))
      call suite%addTest(TestMethod('no_mistakes', test_no_mistakes))
   end function unusual_decks_suite

   !> A lateral in field units.
   function deck() result(text)
      character(:), allocatable :: text
      text = "&job units = 'field', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 2000, 8200, 9200, 12000, 15000'//newline// &
         '  inc = 0, 0, 0, 90, 91, 90, azi = 178, 178, 178, 178, 178, 178 /'//newline// &
         "&hole name = 'casing', md_bottom = 8000, diameter = 8.681, friction = 0.20, cased = .true. /"//newline// &
         "&hole name = 'open', diameter = 8.5, friction = 0.30 /"//newline// &
         '&fluid density = 9.6 /'//newline// &
         "&component name = 'bit', kind = 'bit', length = 1, od = 6.0, joint_od = 8.5 /"//newline// &
         "&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 /"//newline// &
         "&component name = 'DP', od = 5, id = 4.276, mass = 20.87, joint_od = 6.625, yield = 135 /"//newline// &
         "&load_case name = 'up', operation = 'up', bit_depth = 15000 /"//newline// &
         "&load_case name = 'turn', operation = 'rotary', bit_depth = 15000, wob = 20, tob = 5 /"//newline
   end function deck

   !> A mistake has a note that holds `expected`. The sound deck has none.
   subroutine mistake(sound, wrong, expected)
      character(*), intent(in) :: sound, wrong     !< in the deck, and in its place
      character(*), intent(in) :: expected
      type(run_type) :: run
      run = run_deck_text(replaced(deck(), sound, wrong), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, newline//'note ') > 0, message='a note: '//run%output)
      call assertTrue(index(run%output, expected) > 0, message=expected//': '//run%output)
   end subroutine mistake

   !> A change of the deck that is usual has no note.
   subroutine usual(sound, other)
      character(*), intent(in) :: sound, other     !< in the deck, and in its place
      type(run_type) :: run
      run = run_deck_text(replaced(deck(), sound, other), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, newline//'note '), message=run%output)
   end subroutine usual

   subroutine test_nothing_unusual()
      type(run_type) :: run
      run = run_deck_text(deck(), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, newline//'note '), message=run%output)
   end subroutine test_nothing_unusual

   !> Radians, a mistyped station, metres read as feet.
   subroutine test_survey()
      type(run_type) :: run
      call mistake('0, 0, 0, 90, 91, 90', '0, 0, 0, 1.5708, 1.5708, 1.5708', 'Are the inclinations in radians?')
      call mistake('0, 0, 0, 90, 91, 90', '0, 0, 0, 0, 0, 1.047', 'Are the inclinations in radians?')
      call usual('0, 0, 0, 90, 91, 90', '0, 0, 0, 0, 0, 1.05')
      call mistake('0, 0, 0, 90, 91, 90, azi = 178, 178, 178, 178, 178, 178', '6*0, azi = 0, 0, 0, 90, 91, 90', &
                   'all inclinations are 0, and the azimuth goes from 0 to 91 deg. Are inc and azi swapped?')
      call mistake('0, 0, 0, 90, 91, 90', '0, 0, 0, 90, 9, 90', 'from 90 to 9 and back to 90 deg at 12000 ft')
      call mistake('0, 0, 0, 90, 91, 90', '0, 0, 0, 90, 91, 9', &
                   'from 91 to 9 deg over 3000 ft without a station between')
      call mistake('0, 0, 0, 90, 91, 90', '0, 0, 35, 90, 91, 90', 'from 0 to 35 deg over 6200 ft without a station')
      call usual('0, 0, 0, 90, 91, 90', '0, 0, 45, 90, 91, 90')
      call mistake('0, 2000, 8200, 9200, 12000, 15000', '0, 2000, 8200, 8500, 12000, 15000', &
                   'the dogleg is 30 deg/100 ft at 8500 ft. Usual in a hole of 8.5 in is at most 24.3 deg/100 ft. Check '// &
                   'depths, angles '// &
                   'and their units: are depths in m? 1 m is 3.281 ft')
      call mistake('&hole name = ''casing''', '&tortuosity kind = ''sine'', amplitude = 5, period = 60 / &hole name = ''casing''', &
                   'group &tortuosity: the dogleg is ')
      run = run_deck_text(replaced(deck(), '&fluid', "&tortuosity kind = 'random', amplitude = 5, period = 95 / &fluid"), &
                          '--check')
      call assertTrue(index(run%output, 'random changes of 5 deg') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'group &trajectory'), message=run%output)
      call mistake('0, 2000, 8200, 9200, 12000, 15000', '0, 2000, 8200, 8290, 12000, 15000', &
                   'the dogleg is 100 deg/100 ft at 8290 ft. Usual in a hole of 8.5 in is at most 24.3 deg/100 ft. Check '// &
                   'depths, angles '// &
                   'and their units'//newline)
   end subroutine test_survey

   !> A survey that lacks its stations in a bend has a note, one that has them all has none. A gap in a straight part has none.
   subroutine test_gap()
      character(:), allocatable :: plan
      plan = deck()
      plan = plan(index(plan, '&trajectory'):index(plan, '&hole') - 1)
      call mistake(plan, surveyed(31, 44), 'group &trajectory: no station between 3000 and 4500 ft, where the hole turns by '// &
                   '30 deg: are stations missing?')
      call usual(plan, surveyed(0, -1))
      call usual(plan, surveyed(31, 39))
      call usual(plan, surveyed(61, 140))
   contains
      !> A survey every 100 ft to 15000 ft of a hole that builds by 2 deg/100 ft from 3000 to 6000 ft, without some stations.
      function surveyed(first, last) result(text)
         integer, intent(in) :: first, last     !< that are left out
         character(:), allocatable :: text
         character(5) :: word
         integer :: i, k
         text = '&trajectory'
         do k = 1, 3
            text = text//newline//trim(merge('md = ', merge('inc =', 'azi =', k == 2), k == 1))
            do i = 0, 150
               if (i >= first .and. i <= last) cycle
               if (k == 1) write (word, '(i0)') 100*i
               if (k == 2) write (word, '(i0)') min(max(0, 2*(i - 30)), 60)
               if (k == 3) write (word, '(i0)') 178
               text = text//newline//word
            end do
         end do
         text = text//' /'//newline
      end function surveyed
   end subroutine test_gap

   !> Radians whose inclination rises and falls, with azimuths that turn or cross north. A hole that is nearly vertical is usual.
   subroutine test_radians()
      character(*), parameter :: angles = 'inc = 0, 0, 0, 90, 91, 90, azi = 178, 178, 178, 178, 178, 178', &
         expected = 'Are the inclinations in radians? They are read as degrees'
      call mistake(angles, 'inc = 0, 0, 0, 1.222, 1.047, 1.134, azi = 0, 0, 6.196, 0.087, 0.175, 6.2', expected)
      call mistake(angles, 'inc = 0, 0, 0.349, 0.698, 1.047, 1.047, azi = 0, 0, 6.196, 0.087, 0.175, 0.175', expected)
      call mistake(angles, 'inc = 0, 0, 0, 1.7, 1.047, 1.134, azi = 0, 0, 0, 3.1, -3.1, -3', expected)
      call mistake(angles, 'inc = 0, 0, 20, 60, 60, 60, azi = 0.61, 0.61, 0.61, 0.8, 1.1, 1.3962', 'azimuth goes from 0.61 '// &
                   'to 1.396 deg. Is it in radians? It is read as degrees')
      call usual(angles, 'inc = 0, 0, 20, 60, 60, 60, azi = 35, 35, 35, 45.8, 63, 80')
      call usual(angles, 'inc = 0, 0, 20, 60, 60, 60, azi = 0.61, 0.61, 0.61, 0.8, 0.7, 1.3962')
      call usual(angles, 'inc = 0, 0, 20, 60, 60, 60, azi = 2, 2, 2, 2.5, 3, 5.5')
      call usual(angles, 'inc = 0, 0, 0, 60, 60, 60, azi = 2.0944, 2.0944, 2.0944, 2.0944, 2.0944, 2.0944')
      call usual(angles, 'inc = 0, 0.5, 1.2, 0.7, 1.2, 0.9, azi = 0, 120, 250, 10, 200, 5')
      call usual(angles, 'inc = 0, 0, 1, 0.5, 1, 0.5, azi = 4, 4, 4, 4, 4, 4')
      call usual(angles, 'inc = 0, 0, 0, 0, 0, 0.5, azi = 4, 4, 4, 4, 4, 4')
   end subroutine test_radians

   !> Swapped columns, a mistyped azimuth within the survey and at its end. Slant holes that turn and quarter turns are usual.
   subroutine test_azimuths()
      character(*), parameter :: angles = 'inc = 0, 0, 0, 90, 91, 90, azi = 178, 178, 178, 178, 178, 178'
      call mistake(angles, 'inc = 45, 45, 45, 45, 45, 45, azi = 0, 0, 0, 60, 60, 60', &
                   'inclined by 45 deg from surface on, and its azimuth goes from 0 to 60 deg. Are inc and azi swapped?')
      call mistake(angles, 'inc = 0, 0, 0, 60, 60, 60, azi = 178, 178, 178, 178, 358, 178', &
                   'azimuth goes from 178 to 358 and back to 178 deg at 12000 ft. Is that station mistyped?')
      call mistake(angles, 'inc = 0, 0, 0, 60, 60, 60, azi = 178, 178, 178, 178, 178, 358', &
                   'azimuth goes from 178 to 358 deg over 3000 ft, down to 15000 ft. Is an azimuth mistyped?')
      call mistake(angles, 'inc = 178, 178, 178, 178, 175, 170, azi = 0, 0, 0, 90, 91, 90', 'Are inc and azi swapped?')
      call mistake(angles, 'inc = 60, 60, 60, 60, 100, 100, azi = 0, 0, 0, 78, 78, 78', &
                   'inclined by 60 deg from surface on, and its azimuth goes from 0 to 78 deg. Are inc and azi swapped?')
      call mistake(angles, 'inc = 35, 35, 35, 35, 60, 135, azi = 0, 0, 20, 40, 60, 60', &
                   'inclined by 35 deg from surface on, and its azimuth goes from 0 to 60 deg. Are inc and azi swapped?')
      call usual(angles, 'inc = 0, 0, 20, 40, 60, 60, azi = 35, 35, 35, 35, 60, 135')
      call usual(angles, 'inc = 0, 0, 0, 78, 78, 78, azi = 60, 60, 60, 60, 100, 100')
      call usual(angles, 'inc = 45, 45, 45, 45, 45, 45, azi = 30, 30, 30, 60, 60, 60')
      call usual(angles, 'inc = 45, 45, 45, 60, 70, 90, azi = 0, 0, 0, 60, 60, 60')
      call usual(angles, 'inc = 0, 0, 0, 60, 60, 60, azi = 350, 350, 350, 350, 350, 80')
      call mistake(angles, 'inc = 90, 90, 70, 30, 30, 30, azi = 6*178', 'the hole is level at surface, inc = 90 deg, and goes '// &
                   'down deeper, inc = 30 deg. Is inc counted from the horizontal? Then write 90 - inc')
      call usual(angles, 'inc = 0, 0, 20, 60, 60, 60, azi = 6*178')
      call usual(angles, 'inc = 90, 90, 88, 86, 84, 82, azi = 6*178')
      call usual(angles, 'inc = 78, 78, 85, 90, 95, 99, azi = 6*178')
      call usual(angles, 'inc = 0, 0, 0, 5, 5, 5, azi = 350, 350, 350, 350, 120, 250')
   end subroutine test_azimuths

   !> A bar, the wrong order, too long, yield in MPa.
   subroutine test_string()
      type(run_type) :: run
      call mistake('od = 5, id = 4.276, mass = 20.87', 'od = 5', '''DP'' is a solid bar of 66.82 lbm/ft')
      call mistake('od = 5, id = 4.276, mass = 20.87', 'od = 5, mass = 20.87', &
                   '''DP'': it has no id. Stiffness and strength are those of a solid bar, which has 66.82 lbm/ft')
      call mistake('od = 6.75, id = 3.25', 'od = 6.75', '''MWD'' is a solid bar of')
      call mistake("'DP', od", "'DP', length = 16000, od", 'is 16091 ft long, the hole ends at 15000 ft')
      call mistake('yield = 135', 'yield = 931', 'yield = 931 ksi is unusual. Usual is at most 181 ksi. '// &
                   'Is it in MPa? Then write 135')
      call mistake("&component name = 'bit', kind = 'bit', length = 1,", &
                   "&component name = 'low', length = 1, od = 5, id = 4 /"//newline// &
                   "&component name = 'bit', kind = 'bit', length = 1,", &
                   'bit ''bit'' stands above ''low''. List components from the bit upwards')
      call mistake("&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 "// &
               "/"//newline//"&component name = "// &
                   "'DP', od = 5,", "&component name = 'HW', length = 14900, kind = 'drillpipe', joint_od = 6.625, od "// &
                   "= 5, id = 4 /"// &
                   newline//"&component name = 'MWD', kind = 'collar', od = 5,", &
                   'drill pipe ''HW'' stands at the bit, collars ''MWD'' above it. List components from the bit upwards')
      call mistake('mass = 20.87', 'mass = 13', 'mass = 13, but a tube of its od, id and density has 17.95')
      call mistake('mass = 20.87, joint_od = 6.625', 'joint_od = 6.625, joint_length = 1.6', &
                   '''DP'': without mass it weighs 17.95 lbm/ft, as a tube without tool joints. Give mass, joints counted in')
      call mistake('joint_od = 6.625', 'joint_od = 6.625, joint_spacing = 9.5', 'joint_spacing = 9.5 ft is unusual')
      call usual('joint_od = 6.625', 'joint_od = 6.625, joint_spacing = 31.2, joint_length = 1.6')
      call mistake('joint_od = 6.625', 'joint_od = 6.625, joint_length = 17', 'joint_length = 17 ft is unusual')
      call mistake("length = 90,", "length = 90, bend = 0.026, bend_position = 5,", 'bend = 0.026 deg is unusual')
      call mistake("kind = 'collar'", "kind = 'colar'", 'kind = ''colar'' is not known. Did you mean ''collar''?')
      call usual("kind = 'collar'", "kind = 'LWD'")
      call mistake('yield = 135', 'yield = 135, joint_torsion = 20, makeup_torque = 30', &
                   '''DP'': makeup_torque is above joint_torsion, 20 kft.lbf: its joints would yield in make-up')
      call mistake('yield = 135', 'yield = 135, joint_torsion = 52, makeup_torque = 30000', 'makeup_torque = 30000 kft.lbf is')
      call usual('yield = 135', 'yield = 135, joint_torsion = 52, makeup_torque = 30')
      call mistake('yield = 135', 'yield = 135, joint_torsion = 52000', 'joint_torsion = 52000 kft.lbf is')
      run = run_deck_text(replaced(deck(), 'yield = 135', 'yield = 135, joint_torsion = 52000'), '--check')
      call assertEqual(0, index(run%output, 'makeup_torque'), message='follows from joint_torsion: '//run%output)
   end subroutine test_string

   !> Left out: fluid, friction.
   subroutine test_fluid_and_friction()
      call mistake('&fluid density = 9.6 /'//newline, '', 'There is no &fluid')
      call mistake('&fluid density = 9.6', "&fluid where = 'both'", 'group &fluid in line 6 has no density: the string is '// &
                   'weighed in air. Give density, or density = 0 for air')
      call mistake('&fluid density = 9.6', "&fluid density = 9.6, where = 'inside' / &fluid where = 'outside'", 'has no density')
      call usual('&fluid density = 9.6', '&fluid density = 0')
      call usual('&fluid density = 9.6', "&fluid density = 0.01, where = 'outside' / &fluid where = 'inside'")
      call mistake('diameter = 8.5, friction = 0.30', 'diameter = 8.5', '''open'' has no friction')
      call mistake('friction = 0.30', 'friction = 0.025', '''open'': friction = 0.025 is unusual. Usual is at least 0.03')
      call mistake('friction = 0.30', 'friction = 0.30, friction_running_in = 0.025', &
                   'friction_running_in = 0.025 is unusual. Usual is at least 0.03')
      call mistake("operation = 'up',", "operation = 'up', friction = 0.02,", 'case ''up'': friction = 0.02 is unusual')
      call mistake('friction = 0.30', 'friction_axial = 0.3', '''open'' has no friction_rotary, so that torque there is zero')
      call mistake('&fluid density = 9.6 /', '&fluid density = 9.6 / &fluid density = 10, md_top = 16000 /', &
                   'md_top = 16000 ft is below the hole, so that this fluid is nowhere')
      call mistake('friction = 0.30', 'friction_rotary = 0.3', &
                   '''open'' has no friction_axial, so that drag there is zero. Give it, or friction for both')
      call usual('friction = 0.30', 'friction_rotary = 0.3, friction_axial = 0.25')
      call mistake('density = 9.6', 'density = 24', 'density = 24 lbm/gal is unusual. Usual is at most 22.5 lbm/gal')
   end subroutine test_fluid_and_friction

   !> Pounds, foot-pounds, a pressure in ksi.
   subroutine test_loads()
      call mistake('&fluid', '&rig block_weight = 600 /'//newline//'&fluid', &
                   'block_weight = 600 klbf is unusual. Usual is at most 337 klbf')
      call mistake('&fluid', '&rig lines = 1, sheave_efficiency = 0.98 /'//newline//'&fluid', &
                   'group &rig: lines = 1 is unusual. Usual is at least 4')
      call mistake('&fluid', '&rig lines = 20, sheave_efficiency = 0.98 /'//newline//'&fluid', &
                   'group &rig: lines = 20 is unusual. Usual is at most 16')
      call usual('&fluid', '&rig lines = 12, sheave_efficiency = 0.98 /'//newline//'&fluid')
      call mistake('&fluid', '&boundary packer_bore = 9 /'//newline//'&fluid', &
                   'packer_bore = 9 in is wider than the hole at the packer, 8.5 in at ')
      call usual('&fluid', '&boundary packer_bore = 8.5 /'//newline//'&fluid')
      call mistake('&fluid', '&rig max_torque = 1000 /'//newline//'&fluid', 'max_torque = 1000 kft.lbf is unusual')
      call mistake('&fluid', '&rig max_hookload = 20000 /'//newline//'&fluid', 'max_hookload = 20000 klbf is unusual')
      call mistake('tob = 5 ', 'tob = 5, measured_torque = 20000 ', 'measured_torque = 20000 kft.lbf is unusual')
      call mistake('&fluid', '&rig max_hookload = 70 /'//newline//'&fluid', &
                   'The rig carries 70 klbf, string and block weigh 156.5 klbf in mud without drag. Is its limit in tonnes? '// &
                   '70 t are 154.3 klbf')
      call usual('&fluid', '&rig max_hookload = 154.3, block_weight = 0 /'//newline//'&fluid')
      call mistake('wob = 20,', 'wob = 5,', &
                   'tob = 5 kft.lbf is large for wob = 5 klbf in a hole of 8.5 in. Usual is at most 4.7 '// &
                   'kft.lbf. Is wob in tonnes? 5 t are 11.02 klbf')
      call usual('wob = 20,', 'wob = 11.02,')
      call mistake('tob = 5 ', 'tob = 25 ', 'tob = 25 kft.lbf is large for wob = 20 klbf in a hole of 8.5 in. Usual is at most '// &
                   '18 kft.lbf. Is wob in tonnes? 20 t are 44.09 klbf. Is tob the torque at surface? Give that of the bit')
      call mistake('wob = 20, tob = 5 ', 'wob = 30, tob = 30 ', 'Is tob in kN.m? Then write 22.13. Is tob the torque at surface?')
      call usual('wob = 20, tob = 5 ', 'wob = 30, tob = 22.13 ')
      call mistake('tob = 5 ', 'tob = 15, measured_torque = 15 ', 'tob = 15 kft.lbf is not below measured_torque = 15 kft.lbf '// &
                   'at surface, which has the friction of the string in it. Give the torque of the bit alone')
      call usual('tob = 5 ', 'tob = 5, measured_torque = 15 ')
      call usual("'bit', kind = 'bit', length = 1, od = 6.0, joint_od = 8.5 /", "'shoe mill', kind = 'mill', length = 1, "// &
                 "od = 8.4 / &load_case name = 'mill', operation = 'rotary', bit_depth = 15000, wob = 5, tob = 5 /")
      call mistake("'up', bit_depth", "'up', wob = 60, bit_depth", &
                   'wob = 60 klbf pushes the bit in trip_out. An overpull is a wob below 0')
      call mistake('tob = 5 ', 'tob = 5, rpm = 1200 ', 'rpm = 1200 rpm is unusual')
      call mistake("operation = 'up',", "operation = 'backream', rpm = 60, trip_speed = 30,", 'trip_speed = 30 ft/s is unusual')
      call mistake('&fluid', "&sweep operations = 'sliding', bit_depth_from = 15000, wob = 20000, tob = 5000 /"//newline// &
                   '&fluid', 'group &sweep: wob = 20000 klbf is unusual')
      call mistake('wob = 20,', 'wob = 20000,', 'wob = 20000 klbf is unusual. Usual is at most 157 klbf')
      call mistake('tob = 5 ', 'tob = 5000 ', 'tob = 5000 kft.lbf is unusual. Usual is at most 73.7 kft.lbf. Is it in ft.lbf? '// &
                   'Then write 5')
      call mistake('wob = 20,', 'wob = 200,', 'wob = 200 klbf is unusual. Usual is at most 157 klbf. Is it in kN? Then write 44.96')
      call mistake('tob = 5 ', 'tob = 5, pump_pressure = 3 ', 'pump_pressure = 3 psi is unusual. Usual is at least 50.76 psi')
   end subroutine test_loads

   !> A string that is set down by more than a fifth of its weight in air, and by less: casing on a heavy landing string.
   subroutine test_set_down()
      type(run_type) :: run
      character(*), parameter :: pipe = 'od = 5, id = 4.276, mass = 20.87, joint_od = 6.625, yield = 135 /', &
         set = " / &load_case name = 'set', operation = 'down', bit_depth = 15000, wob = 200 /"
      call mistake(pipe, pipe//set(3:), "case 'set': wob = 200 klbf is unusual. Usual is at most 157 klbf. Is it in kN?")
      call usual(pipe, 'od = 6.625, id = 4, mass = 85, joint_od = 8.25, yield = 135'//set)
      call mistake(pipe, 'od = 6.625, id = 4, mass = 85, joint_od = 8.25, yield = 135 / &sweep operations = ''sliding'', '// &
                   'bit_depth_from = 15000, wob = 200 /', 'group &sweep: wob = 200 klbf is unusual')
      run = run_deck_text(replaced(deck(), pipe, 'od = 6.625, id = 4, mass = 85, joint_od = 8.25, yield = 135 / &sweep '// &
                                   'operations = ''trip_in'', bit_depth_from = 15000, wob = 200 /'), '--check')
      call assertEqual(0, index(run%output, 'is unusual'), message=run%output)
   end subroutine test_set_down

   !> A bit that is pulled while it drills, and one that is turned in a trip.
   subroutine test_ways()
      call mistake('wob = 20,', 'wob = -20,', 'wob = -20 klbf pulls the bit in rotary_drilling. Weight on bit is a wob above 0')
      call mistake('&fluid', "&sweep operations = 'up', 'sliding', bit_depth_from = 15000, wob = 0, -20, tob = 0, 2 /"// &
                   newline//'&fluid', 'group &sweep: wob = -20 klbf pulls the bit in sliding_drilling')
      call mistake("'up', bit_depth", "'up', tob = 6, bit_depth", &
                   'tob = 6 kft.lbf turns the free bit in trip_out. Give tob = 0 there')
      call mistake("'rotary', bit", "'trip_in', bit", &
                   'with wob and tob the bit drills, and in trip_in the string does not turn. '// &
                   'Drilling is rotary or sliding')
      call usual("'rotary', bit", "'sliding', bit")
      call usual("'up', bit_depth", "'up', wob = -60, bit_depth")
      call usual("'up', bit_depth", "'up', wob = -60, tob = 6, bit_depth")
      call usual('&fluid', "&sweep operations = 'up', 'sliding', bit_depth_from = 15000, wob = -20, 20, tob = 0, 2 /"// &
                 newline//'&fluid')
   end subroutine test_ways

   !> Gravity in ft/s2, hours in seconds, temperatures in kelvin. Steam is usual.
   subroutine test_conditions()
      type(run_type) :: run
      call mistake('profiles = .false. /', 'profiles = .false., gravity = 32.174 /', &
                   'gravity = 32.17 m/s2 is unusual. Usual is at most 10 m/s2')
      call mistake('tob = 5 ', 'tob = 5, rpm = 60, hours = 36000 ', 'hours = 36000 is unusual. Usual is at most 3000')
      call mistake('tob = 5 ', 'tob = 5, above_ambient_bottom = 700 ', &
                   'above_ambient_bottom = 700 degF is unusual. Usual is at most 585 degF')
      call mistake('tob = 5 ', 'tob = 5, above_ambient_top = 700 ', 'above_ambient_top = 700 degF is unusual')
      call mistake('tob = 5 ', 'tob = 5, temperature_change_bottom = 700 ', 'temperature_change_bottom = 700 degF is unusual')
      call mistake('tob = 5 ', 'tob = 5, temperature_change_top = -500 ', &
                   'temperature_change_top = -500 degF is unusual. Usual is at least -468 degF')
      call usual('tob = 5 ', 'tob = 5, above_ambient_bottom = 540, temperature_change_bottom = 450 ')
      call usual('tob = 5 ', 'tob = 5, rpm = 60, hours = 300 ')
      call usual('tob = 5 ', 'tob = 5, rpm = 600 ')
      call usual('tob = 5 ', 'tob = 5, temperature_change_top = -330 ')
      call mistake('&fluid', "&boundary packer_bore = 4, packer_hold = 'fixed' / &fluid", "packer_hold = 'fixed' holds the "// &
                   'string in load cases with length_reference, and none has one')
      call usual('&fluid', "&boundary packer_bore = 4, packer_hold = 'fixed' / "//warm('150')//' / &fluid')
      call mistake('&fluid', "&boundary packer_bore = 4, packer_hold = 'fixed' / "//warm('15')//' / &fluid', 'load case '// &
                   "'hot': above_ambient_bottom differs by -85 degF from that of its length_reference, "// &
                   'temperature_change_bottom by 50 degF. Check both')
      call mistake('&fluid density = 9.6 /', "&fluid density = 9.6, where = 'inside' /", &
                   "There is no fluid outside. For one on both sides write where = 'both'")
      call mistake('&fluid density = 9.6 /', "&fluid density = 9.6, where = 'outside' /", &
                   "There is no fluid inside. For one on both sides")
      run = run_deck_text(replaced(replaced(deck(), '&fluid density = 9.6 /', "&fluid density = 9.6, where = 'outside' /"), &
         "'up', bit", "'up', inside_density = 0, temperature_change_top = -10, temperature_change_bottom = 5, bit"), '--check')
      call assertTrue(index(run%output, "load case 'up': without pump pressure the fluid inside presses on the bit") > 0, &
                      message=run%output)
      call assertEqual(0, index(run%output, 'There is no fluid inside'), message=run%output)
      call assertTrue(index(run%output, ', cooler at top by 10 degF, warmer at bit by 5 degF') > 0, message=run%output)
   contains
      !> A packer set in a warm string that gets warmer by 50 degF.
      function warm(hot) result(text)
         character(*), intent(in) :: hot       !< above the air [degF]
         character(:), allocatable :: text
         text = "&load_case name = 'set', operation = 'static', bit_depth = 15000, above_ambient_bottom = 100 / &load_case "// &
                "name = 'hot', operation = 'static', bit_depth = 15000, length_reference = 'set', temperature_change_bottom = "// &
                '50, above_ambient_bottom = '//hot
      end function warm
   end subroutine test_conditions

   !> Hook loads in another unit, two that are swapped, a block in tonnes. The deck's string weighs 156 klbf in mud along the hole.
   subroutine test_measured()
      character(*), parameter :: up = "'up', operation = 'up', bit_depth = 15000", rig = '&fluid'
      call mistake(up, up//', measured_hookload = 25', 'measured_hookload = 25 klbf is ')
      call mistake(up, up//', measured_hookload = 1100', ' % of what the string weighs in mud, ')
      call usual(up, up//', measured_hookload = 250')
      call unblocked('200', '136', &
                     'load case ''turn'': measured_hookload = 136 klbf is the weight of the string in mud less WOB. With '// &
                     'block_weight it would be 196 klbf. If loads are measured without the block, write block_weight = 0')
      call unblocked('260', '196', '')
      call unblocked('260', '136', '')
      call mistake(up, up//", measured_hookload = 150 / &load_case name = 'down', operation = 'down', bit_depth = 15000, "// &
                   'measured_hookload = 260', &
                   'measured_hookload = 150 klbf of pick-up is below the 260 klbf of slack-off in ''down''. Are the two swapped?')
      call usual(up, up//", measured_hookload = 260 / &load_case name = 'down', operation = 'down', bit_depth = 15000, "// &
                 'measured_hookload = 150')
      call mistake(rig, '&rig block_weight = 5 / '//rig, 'group &rig: block_weight = 5 klbf is ')
      call mistake(rig, '&rig block_weight = 8, max_hookload = 500 / '//rig, &
                   'block_weight = 8 klbf is 1.6 % of max_hookload. Is block_weight in tonnes? 8 t are 17.64 klbf')
      call usual(rig, '&rig block_weight = 60, max_hookload = 500 / '//rig)
      call mistake(up, up//', measured_hookload = 110 / &rig block_weight = 120', &
                   'measured_hookload is no more than block_weight of &rig')
      call mistake(', tob = 5 ', ' ', 'case ''turn'' drills without tob, the torque on bit. Torque at surface lacks it. Give tob')
      call usual('tob = 5 ', 'tob = 0 ')
   contains
      !> Two measured loads beside a block of 60 klbf: a note on a block that is left out, or none.
      subroutine unblocked(pulled, turned, expected)
         character(*), intent(in) :: pulled, turned, expected
         type(run_type) :: run
         run = run_deck_text(replaced(replaced(deck(), up, up//', measured_hookload = '//pulled), 'tob = 5 ', &
                                      'tob = 5, measured_hookload = '//turned//' / &rig block_weight = 60 '), '--check')
         call assertEqual(0, run%status, message=run%diagnostics)
         if (expected == '') call assertEqual(0, index(run%output, 'left out'), message=run%output)
         if (expected == '') call assertEqual(0, index(run%output, newline//'note '), message=run%output)
         call assertTrue(index(run%output, expected) > 0, message=expected//': '//run%output)
      end subroutine unblocked
   end subroutine test_measured

   !> A cased section below an open one, too many collars, one station that turns off and back.
   subroutine test_sections()
      character(*), parameter :: path = 'md = 0, 2000, 8200, 9200, 12000, 15000'//newline// &
         '  inc = 0, 0, 0, 90, 91, 90, azi = 178, 178, 178, 178, 178, 178', &
         close = 'md = 0, 2000, 4000, 8000, 8100, 8200, 15000, inc = 0, 0, 45, 45, '
      call mistake('friction = 0.20, cased = .true. /', 'friction = 0.20 / &hole name = ''liner'', md_bottom = 9000, '// &
                   'diameter = 8.6, friction = 0.2, cased = .true. /', '''liner'' is cased, ''casing'' above it is not')
      call usual('friction = 0.20, cased = .true. /', 'friction = 0.20, cased = .true. / &hole name = ''liner'', '// &
                 'md_bottom = 9000, diameter = 8.6, friction = 0.2, cased = .true. /')
      call usual('friction = 0.20, cased = .true. /', 'friction = 0.20 /')
      call mistake('diameter = 8.681', 'diameter = 9.625', "'casing': diameter = 9.625 in is the outside diameter of a casing. "// &
                   'The hole needs its inside diameter')
      call mistake("name = 'casing', md_bottom = 8000, diameter = 8.681, friction = 0.20, cased = .true.", &
                   "name = '13 3/8 csg', md_bottom = 8000, diameter = 13.375, friction = 0.20", &
                   'diameter = 13.375 in is the outside diameter of a casing')
      call usual('diameter = 8.681', 'diameter = 9.625, casing_od = 11')
      call usual("name = 'casing', md_bottom = 8000, diameter = 8.681, friction = 0.20, cased = .true.", &
                 "name = 'open', md_bottom = 8000, diameter = 9.625, friction = 0.20")
      call mistake('length = 90, od = 6.75', 'length = 3900, od = 6.75', 'String ''main'' has 3900 ft of collars. Usual is at '// &
                   'most 1640 ft. Is a length mistyped?')
      call usual('length = 90, od = 6.75', 'length = 900, od = 6.75')
      call mistake(path, close//'54, 45, 45, azi = 7*178', 'inclination goes from 45 to 54 and back to 45 deg at 8100 ft')
      call usual(path, close//'47, 45, 45, azi = 7*178')
      call usual(path, close//'54, 63, 63, azi = 7*178')
   end subroutine test_sections

   !> Pipe without its joints, its nominal weight, two materials, a wall as id, a tool as long as pipe or up to surface, a kind.
   subroutine test_materials()
      character(*), parameter :: pipe = 'od = 5, id = 4.276, mass = 20.87, joint_od = 6.625', &
         tool = "kind = 'collar', length = 90", &
         collar = "&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 /"//newline, &
         motor = "&component name = 'MWD', kind = 'motor', length = 30, od = 6.75, id = 3.25 /"//newline, &
         heavy = "od = 5.5, id = 3.375, mass = 61, joint_od = 7 /"//newline
      call mistake(pipe, 'od = 5, id = 4.276', "'DP': without joint_od and mass it is plain pipe. Tool joints add 12 to 35 % "// &
                   "to its mass. Give both, or a name of the catalogue. Pipe without joints needs its kind, as 'casing'")
      call mistake('mass = 20.87', 'mass = 19.5', "'DP': mass = 19.5 lbm/ft is little more than its tube has. Is it the "// &
                   'nominal weight? Give the mass with tool joints, or a name of the catalogue')
      call mistake(pipe, 'od = 5, id = 4.276, mass = 20.87, joint_od = 6.625, youngs = 10', &
                   "'DP': youngs = 10 and density = 65.51 lbm/gal are of two materials. Give both")
      call mistake(pipe, 'od = 5, id = 0.362, mass = 66, joint_od = 6.625', &
                   "'DP': id = 0.362 in leaves a wall of 2.319 in. Is id the wall? Then write id = 4.276")
      call mistake(tool, "kind = 'motor', length = 3000", "'MWD' is 3000 ft long. Usual for a tool is at most 492.1 ft. Is a "// &
                   'length mistyped?')
      call mistake("name = 'DP',", "name = 'DP', length = 14000, od = 5, id = 4.276, mass = 20.87, joint_od = 6.625 /"// &
                   newline//"&component name = 'top', kind = 'MWD', ", &
                   "'top' has no length, so that it goes up to surface. List components from the bit upwards, or give its length")
      call mistake(collar, motor//motor, "'MWD' stands twice in a row, first in line 8. Is one a copy? Leave it out")
      call usual(collar, motor)
      call usual(collar, collar//collar)
      call mistake(collar, collar//"&component name = 'HWDP', kind = 'hwdp', length = 31, "//heavy, &
                   "'HWDP' is 31 ft long, and no other part of the string has its od. Is length that of one joint? Give the "// &
                   'length of all its joints together')
      call usual(collar, collar//"&component name = 'HWDP', kind = 'hwdp', length = 930, "//heavy)
      call usual(collar, collar//"&component name = 'HWDP', kind = 'hwdp', length = 31, "//heavy//motor)
      call mistake("kind = 'collar'", "kind = 'coler'", "kind = 'coler' is not known. Did you mean 'collar'?")
      call mistake("kind = 'collar'", "kind = 'drill coller'", "kind = 'drill coller' is not known. Did you mean 'collar'?")
      call usual("kind = 'collar'", "kind = 'coring'")
      call usual("kind = 'collar'", "kind = 'riser'")
      call usual(pipe, 'od = 5, id = 4, density = 23.4, youngs = 10.4, mass = 10, joint_od = 6.625')
   end subroutine test_materials

   !> A limit with a block that is not given, an efficiency of the whole block, friction swapped or 0, wear, a survey in ft.
   subroutine test_rig()
      type(run_type) :: run
      call mistake('&fluid', '&rig max_hookload = 500 / &fluid', 'group &rig: max_hookload includes the block, and '// &
                   'block_weight is not given. Give it, or 0 for a limit without block')
      call usual('&fluid', '&rig max_hookload = 500, block_weight = 0 / &fluid')
      call mistake('&fluid', '&rig lines = 12, sheave_efficiency = 0.5 / &fluid', 'sheave_efficiency = 0.5 is unusual. Usual '// &
                   'is at least 0.93')
      call mistake('&fluid', '&rig lines = 12, sheave_efficiency = 0.85 / &fluid', &
                   'sheave_efficiency is that of one sheave, 0.85 here. If it is of the whole block, write 0.975')
      call usual('&fluid', '&rig lines = 12, sheave_efficiency = 0.975 / &fluid')
      call mistake('friction = 0.20', 'friction = 0.60', 'friction = 0.6 in casing is above 0.3 of open hole ''open''. Are the '// &
                   'two swapped?')
      call mistake("operation = 'up',", "operation = 'up', friction = 0,", &
                   'case ''up'': axial friction is 0, so that there is no drag. Leave it out for that of &hole')
      call mistake(', wob = 20, tob = 5 ', ' ', 'case ''turn'' drills without wob and tob. Give both, or rotate_off_bottom')
      call mistake('density = 9.6 /', 'density = 9.6 / &fluid density = 9, above_bit = 20000, where = ''inside'' /', &
                   'above_bit = 20000 ft is longer than any string in the hole, so that this fluid fills all of it')
      call mistake('cased = .true.', 'cased = .true., casing_od = 9.625, wear_factor = 1.0e-5', 'wear_factor = ')
      call usual('cased = .true.', 'cased = .true., casing_od = 9.625, wear_factor = 8')
      run = run_deck_text("&job plots = .false., hdf5 = .false., profiles = .false. / &trajectory md = 0, 6562, 13124, "// &
         "inc = 0, 0, 30, azi = 0, 0, 0 / &hole md_bottom = 4000, diameter = 311, friction = 0.3 / &fluid density = 1200 / "// &
         "&component od = 127, id = 108.6, mass = 32, joint_od = 168 / &load_case name = 'up', operation = 'up', "// &
         'bit_depth = 4000 /'//newline, '--check')
      call assertTrue(index(run%output, 'the survey ends at 13124 m, 3.281 times as deep as bit and hole. Is it in ft? In a '// &
                            'file write survey_units = ''field''. In the deck write md in m: '// &
                            '4000 at its end') > 0, message=run%output)
   end subroutine test_rig

   !> Decks that looked like a mistake and are right.
   subroutine test_no_mistakes()
      character(*), parameter :: tool = "&component name = 'MWD', kind = 'collar', length = 90, od = 6.75, id = 3.25 /", &
         low = "&component name = 'low', length = 5000, od = 5, id = 4.276, mass = 20.87, joint_od = 6.625 /"//newline, &
         casing = "&hole name = 'casing'", riser = "&hole name = 'riser', md_bottom = 1500, diameter = 19, friction = 0.2, "// &
         "cased = .true. / &hole name = 'casing'", open = "&hole name = 'open', diameter = 8.5, friction = 0.30 /"
      call usual(tool, low//tool)
      call usual(casing, "&hole name = 'air', md_bottom = 80, diameter = 40 /"//newline//riser)
      call mistake(casing, "&hole name = 'air', md_bottom = 80, diameter = 18 /"//newline//riser, "'air' has no friction")
      call usual(open, "&hole name = 'open', diameter = 8.5, friction = 0.30 / &boundary packer_bore = 8.5 /")
      call usual(open, "&hole name = 'liner', md_bottom = 14900, diameter = 9, friction = 0.30 / &hole name = 'end', "// &
               "diameter = "// &
                 '8.5, friction = 0.3 / &boundary packer_bore = 8.9 /')
      call usual('cased = .true.', 'cased = .true., casing_od = 9.625, wear_factor = 0.02')
      call usual('joint_od = 6.625', 'joint_od = 6.625, joint_spacing = 9.84')
      call usual("name = 'DP', od", "name = 'DP', kind = 'coring rod', joint_spacing = 4.92, joint_length = 0.3, od")
   end subroutine test_no_mistakes
end module dg_test_unusual_decks
