!> Figures that a run prints beside its answers: they agree with the deck, with another run, and with what the advice brings.
module dg_test_printed_figures
   use funit, only: anyExceptions, assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: content, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: lines_of, number, value_after
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: printed_figures_suite

   character(*), parameter :: newline = achar(10)
   integer, parameter :: col_torque = 14, col_true_axial = 14

contains

   function printed_figures_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('printed_figures')
      call suite%addTest(TestMethod('whirling', test_whirling))
      call suite%addTest(TestMethod('uncertain_contact', test_contact))
      call suite%addTest(TestMethod('weight_on_bit', test_weight_on_bit))
      call suite%addTest(TestMethod('overpull', test_overpull))
      call suite%addTest(TestMethod('slips', test_slips))
      call suite%addTest(TestMethod('locked_up_and_burst', test_burst))
      call suite%addTest(TestMethod('weight_of_coiled_pipe', test_coiled_weight))
      call suite%addTest(TestMethod('weight_below_the_pipe', test_below_pipe))
      call suite%addTest(TestMethod('pump_pressure_advised', test_pump))
      call suite%addTest(TestMethod('yield_under_weight_on_bit', test_yield))
      call suite%addTest(TestMethod('tubing_in_its_hanger', test_hanger))
      call suite%addTest(TestMethod('packer', test_packer))
      call suite%addTest(TestMethod('directions_on_the_page', test_directions))
      call suite%addTest(TestMethod('locked_up_on_the_page', test_locked))
      call suite%addTest(TestMethod('models_in_short', test_short))
   end function printed_figures_suite

   !> A string on a slant. `loads` are those of its load case.
   function slant(model, loads) result(text)
      character(*), intent(in) :: model, loads
      character(:), allocatable :: text
      text = "&job models = '"//model//"', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
             "&hole diameter = 215.9, friction = 0.4 /"//newline// &
             "&fluid density = 1200 /"//newline//"&component name = 'dp', od = 127, id = 108.6, joint_od = 168 /"//newline// &
             "&load_case name = 'c', bit_depth = 1000, "//loads//" /"//newline
   end function slant

   !> A well with collars, drill pipe and the limits of a rig.
   function well(model, friction, loads) result(text)
      character(*), intent(in) :: model, friction, loads
      character(:), allocatable :: text
      text = "&job models = '"//model//"', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             "&trajectory md = 0, 600, 1200, 3500, inc = 0, 0, 60, 60, azi = 4*0 /"//newline// &
             "&hole diameter = 215.9, friction = "//friction//" /"//newline//"&fluid density = 1200 /"//newline// &
             "&rig max_hookload = 2000, max_torque = 40 /"//newline// &
             "&component name = 'dc', kind = 'collar', length = 100, od = 165.1, id = 71.4, yield = 758 /"//newline// &
             "&component name = 'dp', od = 127, id = 108.6, mass = 31.9, joint_od = 168, yield = 931 /"//newline// &
             "&load_case name = 'c', bit_depth = 3500, "//loads//" /"//newline// &
             "&solver fidelity = 'fast' /"//newline
   end function well

   !> Torque without sideways friction lies above that of a string that keeps its side, by what the message says. Nothing is said
   !> where the torque does not change, as in a vertical hole.
   subroutine test_whirling()
      character(*), parameter :: whirls = 'the rotating string does not stay on one side of the hole'
      type(run_type) :: run
      real(wp) :: held, found, high
      run = run_deck_text(slant('mcge', "operation = 'rotary', tob = 0, wob = 0.001"))
      call assertEqual(0, index(unwrapped(run%output), whirls), message=run%output)
      held = torque()
      run = run_deck_text(slant('mcge', "operation = 'rotary', tob = 0, wob = 150"))
      call assertTrue(index(unwrapped(run%output), whirls) > 0, message=run%output)
      found = torque()
      high = value_after(run%output, ' % too high, torque at surface ')
      call assertTrue(found > held .and. abs(found*(1.0_wp - 0.01_wp*high) - held) < found - held, &
                      message=to_text(held)//' held, '//to_text(found)//' found, % too high '//to_text(high))
      run = run_deck_text(replaced(slant('mcge', "operation = 'rotary', tob = 4, wob = 30"), 'inc = 60, 60', 'inc = 0, 0'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(unwrapped(run%output), whirls), message=run%output)
   contains
      !> Torque at surface [kN.m].
      function torque() result(value)
         real(wp) :: value
         type(text_type), allocatable :: rows(:)
         allocate (rows, source=lines_of(results_path//'/summary.csv'))
         value = 0.0_wp
         if (.not. anyExceptions()) value = number(rows(2)%text, col_torque)
      end function torque
   end subroutine test_whirling

   !> A place is named where it is a part of the string.
   subroutine test_contact()
      character(*), parameter :: head = 'Contact force uncertain by ', place = ' %, mostly between '
      type(run_type) :: run
      run = run_deck_text(replaced(slant('mcge', "operation = 'rotary', tob = 4, wob = 100"), 'inc = 60, 60', 'inc = 0, 0'))
      call assertTrue(index(unwrapped(run%output), head) > 0, message=run%output)
      call assertEqual(0, index(unwrapped(run%output), place), message=run%output)
      run = run_deck_text(replaced(slant('mcge', "operation = 'sliding', friction = 0.2, wob = 300"), '&component', &
                                   "&solver tool_joints = 'smeared' / &component name = 'hw', length = 300, od = 127, "// &
                                   "id = 76.2, joint_od = 160 / &component"))
      call assertTrue(index(unwrapped(run%output), place//'0 m and 700 m: ') > 0, message=run%output)
   end subroutine test_contact

   !> The weight on bit of the deck, where it takes the string weight alone.
   subroutine test_weight_on_bit()
      type(run_type) :: run
      run = run_deck_text(slant('mcge', "operation = 'rotary', tob = 4, wob = 50.3"))
      call assertTrue(index(unwrapped(run%output), 'WOB takes 50.3 kN of it') > 0, message=run%output)
   end subroutine test_weight_on_bit

   !> The overpull that is possible, and what limits it, does not depend on the overpull that was asked. With 1 % less it can be
   !> done, with 1 % more it cannot.
   subroutine test_overpull()
      character(*), parameter :: words = 'verpull up to about '
      type(run_type) :: run
      real(wp) :: pull, other
      run = run_deck_text(well('mcge', '0.3', "operation = 'up', wob = -1500"))
      pull = value_after(run%output, words)
      call assertTrue(index(unwrapped(run%output), '. By the limits checked, o'//words) > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), ' kN is possible: then hook load with block (rig) is at its limit') > 0, &
                      message=run%output)
      run = run_deck_text(well('mcge', '0.3', "operation = 'up', wob = -1000"))
      other = value_after(run%output, words)
      call assertTrue(abs(pull - other) < 0.01_wp*pull, message=to_text(pull)//' and '//to_text(other))
      run = run_deck_text(well('mcge', '0.3', "operation = 'up', wob = "//to_text(-0.99_wp*pull)))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      run = run_deck_text(well('mcge', '0.3', "operation = 'up', wob = "//to_text(-1.01_wp*pull)))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
      ! every limit that is passed, by the columns of limits.csv
      call assertEqual(0, index(unwrapped(run%output), 'Also passed'), message=run%output)
      run = run_deck_text(well('soft', '0.3', "operation = 'up', wob = -1500"))
      call assertTrue(index(unwrapped(run%output), ' too much, with 1500 kN of overpull at the bit. Also passed: von') > 0, &
                      message=run%output)
      call assertEqual(109.5_wp, value_after(run%output, 'Also passed: von Mises ('), 0.6_wp, message=run%output)
      ! the design factor of the answer
      run = run_deck_text(replaced(well('soft', '0.3', "operation = 'up', wob = -400"), '&rig', &
                                   '&strength tension_factor = 3 /'//newline//'&rig'))
      call assertTrue(index(unwrapped(run%output), 'Tension of the pipe at ') > 0, message=run%output)
      call assertEqual(value_after(run%output, ' kN allowed, '), -value_after(run%output, 'Overpull left, pipe or rig '), 2.0_wp, &
                       message=run%output)
   end subroutine test_overpull

   !> Slips bear a string that hangs, weight on bit with it. Under a pull at the bit they are not set, however short they are.
   subroutine test_slips()
      character(*), parameter :: passed = 'Hook load off bottom (slips): '
      type(run_type) :: run
      run = run_deck_text(held("operation = 'up', wob = -400"))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), "Slips NOT CHECKED for 'c': none are set while the bit is pulled.") > 0, &
                      message=run%output)
      run = run_deck_text(held("operation = 'up'"))
      call assertTrue(index(unwrapped(run%output), passed) > 0, message=run%output)
      call assertEqual(0, index(run%output, 'Slips NOT CHECKED'), message=run%output)
      run = run_deck_text(replaced(held("operation = 'up'"), 'slip_length = 50', 'slip_length = 420'))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message='longer slips: '//run%output)
      run = run_deck_text(held("operation = 'rotary', tob = 0, wob = 200"))
      call assertTrue(index(unwrapped(run%output), passed) > 0, message='more than the hook load on bottom: '//run%output)
   contains
      function held(loads) result(text)
         character(*), intent(in) :: loads
         character(:), allocatable :: text
         text = replaced(well('soft', '0.3', loads), '&rig', '&strength slip_length = 50 /'//newline//'&rig')
      end function held
   end subroutine test_slips

   !> Burst is judged where friction of a coil leaves no solution. Then no friction makes it possible; with less pressure one does.
   subroutine test_burst()
      character(*), parameter :: advice = 'String weight is enough below about ', also = 'Also too much: burst, 20000 of 17100 psi.'
      type(run_type) :: run
      real(wp) :: factor
      run = run_deck_text(lateral(1.0_wp, '20000'))
      call assertTrue(index(content(results_path//'/summary.csv'), ',locked_up,') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), also) > 0, message=run%output)
      call assertTrue(value_after(run%output, 'Pushed at surface with all that pipe bears, the string brings at most ') > &
                      value_after(run%output, 'String weight alone brings '), message=run%output)
      call assertEqual(0, index(unwrapped(run%output), advice), message=run%output)
      call assertTrue(index(unwrapped(run%output), 'There is no solution: tension, torque and bending along the string are '// &
                            'not known. Of the other limits only burst and collapse are judged.') > 0, message=run%output)
      run = run_deck_text(lateral(1.0_wp, '10000'))
      call assertEqual(0, index(unwrapped(run%output), 'Also too much'), message=run%output)
      factor = value_after(run%output, advice)
      run = run_deck_text(lateral(0.97_wp*factor, '10000'))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      run = run_deck_text(lateral(0.97_wp*factor, '20000'))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
   contains
      !> A lateral in which friction of a coil takes all weight.
      function lateral(scale, pump) result(text)
         real(wp), intent(in) :: scale          !< on friction [-]
         character(*), intent(in) :: pump       !< [psi]
         character(:), allocatable :: text
         text = "&job units = 'field', models = 'mcge', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
                '&trajectory md = 0, 2000, 8200, 9200, 15000, inc = 0, 0, 0, 90, 90, azi = 5*178 /'//newline// &
                '&hole diameter = 8.5, friction = 0.2 /'//newline//'&fluid density = 9.6 /'//newline// &
                "&component name = 'MWD', kind = 'collar', length = 120, od = 6.75, id = 3.25, yield = 110 /"//newline// &
                "&component name = 'DP', od = 5, id = 4.276, mass = 20.87, joint_od = 6.625, yield = 135 /"//newline// &
                "&load_case name = 'c', operation = 'sliding', bit_depth = 15000, wob = 60, friction = "// &
                to_text(0.3_wp*scale)//', pump_pressure = '//pump//' /'//newline//"&solver fidelity = 'fast' /"//newline
      end function lateral
   end subroutine test_burst

   !> A NO by burst or collapse names the pump pressure that helps: with it the answer is yes, with 1 % less help it is NO. Where
   !> another limit is passed then, there is no such advice.
   subroutine test_pump()
      character(*), parameter :: advice = 'The answer becomes yes with a pump_pressure of at '
      character(*), parameter :: load = "operation = 'rotate_off_bottom', pump_pressure = "
      type(run_type) :: run
      real(wp) :: pump
      run = run_deck_text(pumped(120.0_wp))
      call assertTrue(index(unwrapped(run%output), 'Burst at ') > 0, message=run%output)
      pump = value_after(run%output, advice//'most ')
      run = run_deck_text(pumped(pump))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      run = run_deck_text(pumped(1.01_wp*pump))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
      run = run_deck_text(replaced(pumped(120.0_wp), 'max_torque = 40', 'max_torque = 1'))
      call assertEqual(0, index(unwrapped(run%output), advice), message='its torque is too much, too: '//run%output)
      run = run_deck_text(empty(0.0_wp))
      call assertTrue(index(unwrapped(run%output), 'Collapse at ') > 0, message=run%output)
      pump = value_after(run%output, advice//'least ')
      run = run_deck_text(empty(pump))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      run = run_deck_text(empty(0.99_wp*pump))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
      run = run_deck_text(replaced(replaced(empty(0.0_wp), 'yield = 379', 'yield = 758'), 'density = 100,', 'density = 0,'))
      call assertEqual(0, index(unwrapped(run%output), advice), message='nobody pumps up an empty string: '//run%output)
      call assertTrue(index(unwrapped(run%output), 'Fill the empty string: ') > 0, message=run%output)
      run = run_deck_text(replaced(replaced(empty(0.0_wp), 'yield = 379', 'yield = 758'), 'density = 100,', 'density = 1200,'))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message='filled: '//run%output)
   contains
      function pumped(pump) result(text)
         real(wp), intent(in) :: pump           !< [MPa]
         character(:), allocatable :: text
         text = well('soft', '0.2', load//to_text(pump))
      end function pumped

      !> Thin pipe with gas inside.
      function empty(pump) result(text)
         real(wp), intent(in) :: pump           !< [MPa]
         character(:), allocatable :: text
         text = replaced(pumped(pump), '&fluid density = 1200 /', &
                         "&fluid density = 1200, where = 'outside' / &fluid density = 100, where = 'inside' /")
         text = replaced(text, 'id = 108.6, mass = 31.9, joint_od = 168, yield = 931', &
                         'id = 118, mass = 31.9, joint_od = 168, yield = 379')
      end function empty
   end subroutine test_pump

   !> The soft string's yes ends at the weight on bit at which coils yield.
   subroutine test_yield()
      type(run_type) :: run
      real(wp) :: most
      run = run_deck_text(deck(250.0_wp))
      call assertTrue(index(unwrapped(run%output), 'Compressed pipe yields, its buckling counted: WOB 250 kN, ') > 0, &
                      message=run%output)
      call assertTrue(index(unwrapped(run%output), 'Model mcge solves its bending') > 0, message=run%output)
      most = value_after(run%output, 'WOB 250 kN, ')
      run = run_deck_text(deck(most))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), 'Close to its limit: yield under WOB, WOB ') > 0, message=run%output)
      run = run_deck_text(deck(1.01_wp*most))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
      run = run_deck_text(replaced(deck(1.03_wp*most), "'soft'", "'mcge'"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
      call assertTrue(index(unwrapped(run%output), 'Von Mises stress at ') > 0, message='by its bending: '//run%output)
   contains
      function deck(wob) result(text)
         real(wp), intent(in) :: wob     !< [kN]
         character(:), allocatable :: text
         text = replaced(well('soft', '0.2', "operation = 'rotary', tob = 2, wob = "//to_text(wob)), &
                         'od = 127, id = 108.6, mass = 31.9, joint_od = 168', 'od = 73, id = 54.6, mass = 16.1, joint_od = 105')
         text = replaced(text, 'diameter = 215.9', 'diameter = 311')
      end function deck
   end subroutine test_yield

   !> Tubing that a pressure at its packer pulls is not compressed pipe: it fails by no weight on bit. Tubing in its hanger may
   !> have a hook load below zero, as pressure inside pulls its steel. Where its steel is compressed the hanger must hold it down.
   subroutine test_hanger()
      type(run_type) :: run
      run = run_deck_text(tubing('pump_pressure = 50, temperature_change_bottom = -60'))
      call assertTrue(index(run%output, newline//'case  yes ') > 0, message=run%output)
      run = run_deck_text(tubing('pump_pressure = 55, temperature_change_top = 80, temperature_change_bottom = 80'))
      call assertTrue(index(run%output, newline//'case  yes ') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'pushed'), message=run%output)
      run = run_deck_text(tubing('pump_pressure = 20, temperature_change_top = 80, temperature_change_bottom = 80'))
      call assertTrue(index(run%output, newline//'case  NO  ') > 0, message=run%output)
      call assertEqual(-top_force(), value_after(run%output, 'The top must be held down with '), 0.5_wp, 'force on the hanger')
      run = run_deck_text(replaced(tubing('pump_pressure = 20, temperature_change_top = 80, temperature_change_bottom = 80, '// &
                                          'annulus_pressure = 4'), '&fluid', '&fluid surface_pressure = 3,'))
      call assertEqual(-top_force(), value_after(run%output, 'The top must be held down with '), 0.5_wp, 'with annulus pressure')
      run = run_deck_text(tubing('pump_pressure = 90, temperature_change_bottom = -60'))
      call assertTrue(index(unwrapped(run%output), ' kN of pull on the packer') > 0, message=run%output)
      call assertEqual(0, index(unwrapped(run%output), 'No shallower'), message=run%output)
      ! a hanger may hold the top down, and nothing helps against collapse
      run = run_deck_text("&job models = 'soft' plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 5000, inc = 0, 0, azi = 0, 0 /'//newline//'&hole diameter = 220.5, friction = 0.2 /'//newline// &
         "&fluid density = 2000, where = 'outside' /"//newline//"&fluid density = 2000, where = 'inside' /"//newline// &
         "&component name = 'tieback', catalogue = 'CSG 7 32.00 P110' /"//newline// &
         "&load_case name = 'c', operation = 'static', bit_depth = 5000, inside_density = 0 /"//newline)
      call assertTrue(index(unwrapped(run%output), "Collapse at 5000 m in 'tieback': 98.07 MPa, 74.33 MPa allowed, 23.74 MPa "// &
                            'too much. The top must be held down with ') > 0, message=run%output)
      call assertEqual(0, index(unwrapped(run%output), 'The answer becomes yes'), message='a push is missing, too: '//run%output)
   contains
      !> Deck of tubing that is set on a packer, then pumped through.
      function tubing(loads) result(text)
         character(*), intent(in) :: loads
         character(:), allocatable :: text
         text = "&job models = 'soft', plots = .false., hdf5 = .false. /"//newline// &
                '&trajectory md = 0, 1000, inc = 0, 0, azi = 0, 0 /'//newline// &
                '&hole diameter = 220.5, friction = 0.2, cased = .true. /'//newline//'&fluid density = 1150 /'//newline// &
                '&component od = 139.7, id = 124.3, mass = 25.3, yield = 758 /'//newline// &
                "&boundary packer_bore = 152.4, packer_hold = 'fixed' /"//newline// &
                "&load_case name = 'set', operation = 'static', wob = 20, bit_depth = 999 /"//newline// &
                "&load_case name = 'case', operation = 'static', bit_depth = 999, length_reference = 'set', "//loads//' /'//newline
      end function tubing

      !> True axial force at the top, from the profile [kN].
      function top_force() result(force)
         real(wp) :: force
         type(text_type), allocatable :: lines(:)
         allocate (lines, source=lines_of(results_path//'/profile_case_soft.csv'))
         force = number(lines(2)%text, col_true_axial)
      end function top_force
   end subroutine test_hanger

   !> The page says in words which way a length changes and a packer is pressed. A deck that asks for neither has no such table.
   subroutine test_directions()
      character(*), parameter :: heading = '<h2>Change of length and force on the packer</h2>'
      type(run_type) :: run
      character(:), allocatable :: page
      run = run_deck_text(tubing("&boundary packer_bore = 101.6, packer_hold = 'fixed' /"//newline, 'set'))
      page = content(results_path//'/report.html')
      call assertTrue(index(page, heading) > 0, message=run%diagnostics)
      page = page(index(page, heading):)
      page = page(:index(page, '</table>'))
      call assertTrue(index(page, '>50 kN down<') > 0 .and. index(page, ' kN up<') > index(page, '>50 kN down<'), message=page)
      call assertTrue(index(page, ' m longer<') > 0 .and. index(page, ' m shorter<') > 0, message=page)
      run = run_deck_text(tubing('', ''))
      call assertEqual(0, index(content(results_path//'/report.html'), '<h2>Change of length'), message='not asked for')
   contains
      function tubing(boundary, reference) result(text)
         character(*), intent(in) :: boundary, reference
         character(:), allocatable :: text
         text = "&job models = 'soft', hdf5 = .false., profiles = .false. /"//newline// &
                '&trajectory md = 0, 3000, inc = 0, 0 /'//newline// &
                '&hole diameter = 220.5, friction = 0.2, cased = .true. /'//newline//'&fluid density = 1100 /'//newline// &
                "&component kind = 'tubing', od = 114.3, id = 100.5, mass = 19, yield = 552 /"//newline//boundary// &
                "&load_case name = 'set', operation = 'static', wob = 50, bit_depth = 3000 /"//newline// &
                "&load_case name = 'test', operation = 'static', bit_depth = 3000, pump_pressure = 35, length_reference = '"// &
                reference//"' /"//newline
         if (reference == '') text = replaced(text, ", length_reference = ''", '')
      end function tubing
   end subroutine test_directions

   !> The page in short compares models in a case that must be pushed by one of them, too, and names the other's answer.
   subroutine test_short()
      type(run_type) :: run
      character(:), allocatable :: page
      run = run_deck_text("&job models = 'mcge', 'soft', hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 500, 900, 3500, inc = 0, 0, 90, 90, azi = 4*0 /'//newline// &
         '&hole diameter = 215.9, friction = 0.3 /'//newline//'&fluid density = 1200 /'//newline// &
         "&component name = 'pipe', od = 127, id = 108.6, mass = 31.9, joint_od = 161.9 /"//newline// &
         '&rig max_torque = 10.5 /'//newline// &
         "&load_case name = 'rob', operation = 'rotate_off_bottom', bit_depth = 2340 /"//newline// &
         "&load_case name = 'rih', operation = 'trip_in', bit_depth = 2340 /"//newline)
      page = content(results_path//'/report.html')
      page = page(index(page, '<h2>In short</h2>'):)
      page = page(:index(page, '</ul>'))
      call assertTrue(index(page, ' % of the greatest; the worst is rih. Model soft answers otherwise: ''rob'' NO.</li>') > 0, &
                      message=page//run%output)
   end subroutine test_short

   !> A case that locks up is named beside those that are found to buckle, as impossible, and as one without curves.
   subroutine test_locked()
      type(run_type) :: run
      character(:), allocatable :: page
      run = run_deck_text('&job hdf5 = .false., profiles = .false. /'//newline// &
         '&trajectory md = 0, 1800, 2150, 5150, inc = 0, 0, 90, 90, azi = 4*0 /'//newline// &
         '&hole diameter = 97.2, friction = 0.25, cased = .true. /'//newline//'&fluid density = 1020 /'//newline// &
         "&component name = 'coil', kind = 'tubing', od = 50.8, id = 42.85, yield = 552 /"//newline// &
         "&load_case name = 'rih', operation = 'trip_in', bit_depth = 5150 /"//newline// &
         "&load_case name = 'pooh', operation = 'trip_out', bit_depth = 5150 /"//newline)
      page = content(results_path//'/report.html')
      call assertTrue(index(page, '<li>Found to buckle: no load case with a solution.</li>') > 0, message=run%output)
      call assertTrue(index(page, '<li>Locked up, buckling not known: rih.</li>') > 0, message=run%output)
      call assertTrue(index(page, '<p class="note">No solution, so no curves: ''rih'' (locked up). Shown first: ''pooh''.</p>') > 0)
      page = page(index(page, '<h2>In short</h2>'):)
      call assertTrue(index(page, '<li>rih: <b class="no">NO</b> (lock-up). Possible down to about <span data-field="') > 0)
      call assertTrue(index(page, '</span> (pooh), bending between tool joints included.</li>') > 0)
   end subroutine test_locked

   !> A packer and its seals have no limits in a deck: the answer says so.
   subroutine test_packer()
      type(run_type) :: run
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             '&trajectory md = 0, 3000, inc = 0, 0 /'//newline// &
             '&hole diameter = 159, friction = 0.3, cased = .true. /'//newline// &
             '&fluid density = 1000 /'//newline//'&component od = 73, id = 62, yield = 552 /'//newline// &
             "&boundary packer_bore = 82, packer_hold = 'landed' /"//newline// &
             "&load_case name = 'c', operation = 'static', bit_depth = 3000, wob = 40 /"//newline
      run = run_deck_text(text)
      call assertTrue(index(unwrapped(run%output), ', seal travel, packer force.') > 0, message=run%output)
      call assertTrue(index(content(results_path//'/summary.csv'), ' seal_travel packer_force,') > 0)
      run = run_deck_text(replaced(replaced(text, 'landed', 'free'), ', wob = 40', ''))
      call assertTrue(index(unwrapped(run%output), ', seal travel.') > 0, message=run%output)
      run = run_deck_text(replaced(text, "&boundary packer_bore = 82, packer_hold = 'landed' /", ''))
      call assertEqual(0, index(unwrapped(run%output), 'seal travel'), message=run%output)
   end subroutine test_packer

   !> The weight on bit that a helically buckled string still brings, and the friction that is possible. Beams confirm both: the
   !> friction of their coils grows faster than that of the soft string.
   subroutine test_coiled_weight()
      real(wp), parameter :: wob = 48.0_wp, apart = 0.03_wp, easy = 0.4_wp
      character(*), parameter :: sooner = ', perhaps sooner, as pipe buckles then'
      type(run_type) :: run
      real(wp) :: most, factor
      run = run_deck_text(lateral(wob, 1.0_wp))
      most = value_after(run%output, 'String weight alone brings ')
      factor = value_after(unwrapped(run%output), 'The answer becomes yes below about ')
      run = run_deck_text(lateral(wob, (1.0_wp - apart)*factor))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message='less friction: '//run%output)
      run = run_deck_text(lateral((1.0_wp + apart)*most, 1.0_wp))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message='more: '//run%output)
      run = run_deck_text(lateral((1.0_wp - apart)*most, 1.0_wp))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message='less: '//run%output)
      call assertRelativelyEqual(most, value_after(unwrapped(run%output), 'String weight brings at most about '), apart, &
                                 message='beside a yes')
      call assertEqual(0, index(unwrapped(run%output), sooner), message='it is buckled: '//run%output)
      run = run_deck_text(lateral(1.0_wp, easy))
      call assertTrue(index(unwrapped(run%output), sooner) > 0, message='buckles by friction: '//run%output)
      factor = value_after(unwrapped(run%output), 'The answer becomes NO above about ')
      run = run_deck_text(lateral(1.0_wp, 0.8_wp*factor*easy))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message='not much sooner: '//run%output)
      run = run_deck_text(lateral(1.0_wp, 1.02_wp*factor*easy))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message='more friction: '//run%output)
   contains
      !> Drill pipe of 2 7/8 in that slides in a lateral.
      function lateral(weight, scale) result(text)
         real(wp), intent(in) :: weight, scale   !< [kN, -]
         character(:), allocatable :: text
         text = "&job plots = .false., hdf5 = .false., models = 'mcge' /"//newline// &
                '&trajectory md = 0, 600, 900, 3500, inc = 0, 0, 90, 90, azi = 4*0 /'//newline// &
                '&hole diameter = 157.1, md_bottom = 1000, friction = '//to_text(0.22_wp*scale)//' /'//newline// &
                '&hole diameter = 155.6, friction = '//to_text(0.3_wp*scale)//' /'//newline//'&fluid density = 1050 /'//newline// &
                "&component kind = 'bit', length = 0.5, od = 90, joint_od = 150 /"//newline// &
                "&component catalogue = 'DP 2-7/8 10.40 NC31 4-1/8x2-1/8 S135', length = 2600 /"//newline// &
                "&load_case name = 'c', operation = 'sliding', bit_depth = 1500, wob = "//to_text(weight)//' /'//newline
      end function lateral
   end subroutine test_coiled_weight

   !> Weight below the drill pipe: wash pipe is none, and casing alone has none.
   subroutine test_below_pipe()
      character(*), parameter :: words = ' in mud below the drill pipe'
      type(run_type) :: run
      type(text_type), allocatable :: rows(:)
      character(:), allocatable :: text, washing
      text = well('soft', '0.2', "operation = 'up'")
      run = run_deck_text(text)
      call assertTrue(index(run%output, weight_below(100.0_wp, 0.1651_wp, 0.0714_wp)//words) > 0, message=run%output)
      ! along the hole: hook load without friction and WOB
      rows = lines_of(results_path//'/summary.csv')
      call assertEqual(number(rows(2)%text, 8) + number(rows(2)%text, 13), &
                       value_after(run%output, ' in mud of 1200 kg/m3, '), 0.1_wp, message=run%output)
      washing = replaced(text, "&component name = 'dc'", "&component kind = 'washpipe', length = 50, od = 165.1, id = 71.4 /"// &
                         newline//"&component name = 'dc'")
      run = run_deck_text(washing)
      call assertTrue(index(run%output, weight_below(150.0_wp, 0.1651_wp, 0.0714_wp)//words) > 0, message=run%output)
      run = run_deck_text(replaced(text, "name = 'dp'", "name = 'dp', kind = 'casing'"))
      call assertEqual(0, index(run%output, words), message=run%output)
   contains
      !> Weight in mud of steel, three digits.
      function weight_below(length, od, id) result(text)
         real(wp), intent(in) :: length, od, id   !< [m]
         character(:), allocatable :: text
         text = to_text(length*0.25e-3_wp*acos(-1.0_wp)*(od**2 - id**2)*(7850.0_wp - 1200.0_wp)*9.80665_wp, 3)//' kN'
      end function weight_below
   end subroutine test_below_pipe
end module dg_test_printed_figures
