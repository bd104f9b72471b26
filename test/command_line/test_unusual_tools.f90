!> Notes on unusual bits, motors and steering tools of a deck. Usual ones have no note.
module dg_test_unusual_tools
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: replaced, run_deck_text, run_type
   implicit none
   private
   public :: unusual_tools_suite

   character(*), parameter :: newline = achar(10)

contains

   function unusual_tools_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('unusual_tools')
      call suite%addTest(TestMethod('angles_in_radians', test_angles))
      call suite%addTest(TestMethod('bends', test_bends))
      call suite%addTest(TestMethod('bits', test_bits))
      call suite%addTest(TestMethod('small_numbers', test_numbers))
      call suite%addTest(TestMethod('speeds', test_speeds))
      call suite%addTest(TestMethod('usual_decks', test_usual))
      call suite%addTest(TestMethod('sizes_advised', test_sizes))
   end function unusual_tools_suite

   !> A motor in an inclined hole.
   function deck() result(text)
      character(:), allocatable :: text
      text = "&job plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 600, 1500, 2400, inc = 0, 0, 60, 60, azi = 45, 45, 45, 45 /'//newline// &
         "&hole name = 'casing', md_bottom = 1400, diameter = 220.5, friction = 0.2, cased = .true. /"//newline// &
         "&hole name = 'open', diameter = 215.9, friction = 0.3 /"//newline//'&fluid density = 1200 /'//newline// &
         "&component name = 'bit', kind = 'bit', length = 0.3, od = 165, id = 50, joint_od = 215.9 /"//newline// &
         "&component name = 'PDM', kind = 'motor', length = 8, od = 171.4, id = 95, bend = 1.5, bend_position = 1.6 /"//newline// &
         "&component name = 'stab', kind = 'stabilizer', length = 1.5, od = 171.4, id = 71.4, joint_od = 212.7, "// &
         'blade_offset = 3 /'//newline// &
         "&component name = 'RSS', kind = 'rss', length = 4, od = 171.4, id = 71.4, pad_force = 10, pad_position = 1 /"//newline// &
         "&component name = 'dc', kind = 'collar', length = 40, od = 165.1, id = 71.4 /"//newline// &
         "&component name = 'dp', kind = 'drillpipe', od = 127, id = 108.6, mass = 31.9, joint_od = 165.1 /"//newline// &
         "&load_case name = 'slide', operation = 'sliding', bit_depth = 2400, wob = 60, tob = 4, toolface = 45 /"//newline// &
         "&load_case name = 'drill', operation = 'drilling', bit_depth = 2400, wob = 80, tob = 5, rpm = 120 /"//newline// &
         "&steering cases = 'slide', hole_enlargement = 2, side_cutting = 0.01 /"//newline
   end function deck

   !> A change of the deck has a note that holds a text.
   subroutine mistake(sound, wrong, expected)
      character(*), intent(in) :: sound, wrong, expected
      type(run_type) :: run
      run = run_deck_text(replaced(deck(), sound, wrong), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, expected) > 0, message='wanted: '//expected//'; got: '//run%output)
   end subroutine mistake

   !> A change of the deck that is usual has no note.
   subroutine usual(sound, other)
      character(*), intent(in) :: sound, other
      type(run_type) :: run
      run = run_deck_text(replaced(deck(), sound, other), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, newline//'note '), message=other//': '//run%output)
   end subroutine usual

   subroutine test_angles()
      character(*), parameter :: expected = 'Are these angles in radians? They are read as degrees'
      call mistake('toolface = 45', 'toolface = 0.785', '0.785 as toolface or clock angle, and none above 6.3 deg. '//expected)
      call mistake('toolface = 45', 'toolface = 3.14', expected)
      call mistake('hole_enlargement = 2', 'hole_enlargement = 2, toolfaces = 0, 1.57, 3.14', expected)
      call usual('hole_enlargement = 2', 'hole_enlargement = 2, toolfaces = 0, 90')
      call usual('toolface = 45', 'toolface = 5')
      call usual('toolface = 45', 'toolface = 0')
      call usual('blade_offset = 3', 'blade_offset = 3, blade_clock = 1.25')      ! beside a toolface of 45
   end subroutine test_angles

   subroutine test_bends()
      call mistake('bend_position = 1.6', 'bend_position = 6.4', 'bend_position = 6.4 m is unusual. It is counted from the '// &
                   'lower end of the component. Usual is at most 4 m and half of its length')
      call mistake("name = 'stab',", "name = 'stab', bend = 1, bend_position = 0.5,", &
                   "'stab' is the second component with a bend of its string, and both bends count")
      call mistake("name = 'dc',", "name = 'dc', bend = 1, bend_position = 1,", &
                   "its kind = 'collar' has no bend. Give the bend to the motor")
      call mistake("name = 'dp',", "name = 'dp', bend = 1, bend_position = 1,", "its kind = 'drillpipe' has no bend")
   end subroutine test_bends

   subroutine test_bits()
      call mistake("name = 'bit', kind = 'bit', length = 0.3, od = 165, id = 50, joint_od = 215.9", &
                   "name = 'shank', kind = 'collar', length = 0.3, od = 165, id = 50", &
                   "String 'main' has a bend or pads, and no kind = 'bit'. List the bit first")
      call mistake('joint_od = 215.9', 'joint_od = 171.4', &
                   "'bit' is 171.4 mm wide, and 'slide' drills a hole of 215.9 mm. Give the diameter of the bit as joint_od")
      call usual('joint_od = 212.7,', 'joint_od = 212.7, opened_od = 214, opened_below = 1400,')
   end subroutine test_bits

   subroutine test_numbers()
      call mistake('pad_force = 10', 'pad_force = 200', 'pad_force = 200 kN is unusual. Usual is at most 100 kN')
      call mistake('pad_force = 10', 'pad_force = 0.01', 'pad_force = 0.01 kN is unusual. Usual is at least 0.1 kN')
      call mistake('blade_offset = 3', 'blade_offset = 0.003', 'blade_offset = 0.003 mm is unusual. Usual is at least 0.1 mm')
      call mistake('hole_enlargement = 2', 'hole_enlargement = 0.002', 'hole_enlargement = 0.002 mm is unusual')
      call mistake('side_cutting = 0.01', 'side_cutting = 10', 'side_cutting = 10 is unusual. Usual is at most 2')
   end subroutine test_numbers

   subroutine test_speeds()
      call mistake('rpm = 120', 'rpm = 12, hours = 60', 'rpm = 12 rpm is unusual. Usual is at least 20 rpm. Is it in rad/s? '// &
                   'Then write 114.6')
      call mistake('toolface = 45', 'toolface = 45, rpm = 60', "rpm is ignored, as operation = 'sliding_drilling' does not rotate")
      call usual('rpm = 120', 'rpm = 3')
   end subroutine test_speeds

   !> The deck as it is, a vertical hole, and a motor with its mass by its maker and the bore of its rotor.
   subroutine test_usual()
      character(*), parameter :: hole = 'inc = 0, 0, 60, 60, azi = 45, 45, 45, 45'
      call usual('&fluid', '&fluid')
      call usual(hole, 'inc = 0.2, 0.5, 1.0, 1.4, azi = 45, 45, 45, 45')
      call mistake(hole, 'inc = 0.2, 0.5, 1.0, 1.4, azi = 0.79, 0.79, 0.79, 0.79', 'Are the inclinations in radians?')
      call usual('od = 171.4, id = 95,', 'od = 171.4, id = 50, mass = 115,')
   end subroutine test_usual

   !> Messages that say a size or a mass which fits at once.
   subroutine test_sizes()
      type(run_type) :: run
      run = run_deck_text(replaced(deck(), 'joint_od = 212.7', 'joint_od = 215.9'), '--check')
      call assertTrue(index(run%diagnostics, 'needs a diameter < 215.9 mm. Give its size under gauge, usually 1/32 in less: '// &
                            '215.1 mm') > 0, message=run%diagnostics)
      call usual('joint_od = 212.7', 'joint_od = 215.1')
      call mistake('mass = 31.9', 'mass = 19.5', "Is it the nominal weight in lbm/ft? The mass with tool joints of "// &
                   "'DP 5 19.50 NC50 6-1/2x3-1/4' is 31.4. Write that")
      call usual('mass = 31.9', 'mass = 31.4')
      call mistake('wob = 80, tob = 5', 'wob = 40, tob = 12', 'Usual is at most 11 kN.m')
   end subroutine test_sizes
end module dg_test_unusual_tools
