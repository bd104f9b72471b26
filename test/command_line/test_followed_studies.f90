!> Advice of messages about sweeps, uncertainties and calibrations: it is followed, and the message is gone.
module dg_test_followed_studies
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: good_deck, replaced, run_deck_text, run_type, unwrapped
   use dg_test_followed_faults, only: follow
   use dg_text, only: to_text
   implicit none
   private
   public :: followed_studies_suite

   character(*), parameter :: newline = achar(10)
   !> Straight hole of 1000 m at 60 deg, pipe of 20 kg/m without mud: weight along the hole and across it [kN].
   real(wp), parameter :: along = 20.0_wp*9.80665_wp*0.5_wp, across = 20.0_wp*9.80665_wp*0.8660254037844386_wp

contains

   function followed_studies_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('followed_studies')
      call suite%addTest(TestMethod('sweeps', test_sweeps))
      call suite%addTest(TestMethod('measured_cases', test_data))
      call suite%addTest(TestMethod('too_many', test_many))
      call suite%addTest(TestMethod('factors_not_told_apart', test_apart))
      call suite%addTest(TestMethod('no_fit', test_no_fit))
   end function followed_studies_suite

   !> Sweeps and uncertainties.
   subroutine test_sweeps()
      call follow("+", "&sweep operations = 'ream', bit_depth_step = 300, trip_speed = 0.1 /", "reaming needs rpm > 0", "= 0.1", &
                  "= 0.1, rpm = 60")
      call follow("+", "&sweep operations = 'ream', bit_depth_step = 300, rpm = 60 /", "reaming needs trip_speed > 0", "= 60", &
                  "= 60, trip_speed = 0.1")
      call follow("+", "&sweep bit_depth_step = 300, measured_depths = 600, measured_hookloads = 300 /", &
                  "measured_depths needs measured_operations", "= 600", "= 600, measured_operations = 'up'")
      call follow("+", "&sweep bit_depth_step = 300, measured_depths = 600, measured_operations = 'up' /", &
                  "needs measured_hookloads or measured_torques", "= 600", "= 600, measured_hookloads = 3")
      call follow("+", "&sweep bit_depth_step = 300, measured_depths = 600, measured_operations = 'up' /", &
                  "needs measured_hookloads or measured_torques", "= 600", "= 600, measured_torques = 3")
      call follow("+", "&sweep bit_depth_step = 300, frictions_cased = 0.1, frictions_open = 0.3 /", &
                  "need a hole section with cased = .true.", "diameter = 220.0", "cased = .true., diameter = 220.0")
      call follow("diameter = 220.0, friction = 0.25 /", "cased = .true., diameter = 220.0, friction = 0.25 / &sweep "// &
                  "bit_depth_step = 300, frictions_cased = 0.1, 0.2, frictions_open = 0.3 /", "they go in pairs", "= 0.1, 0.2", &
                  "= 0.1")
      call follow("+", "&sweep bit_depth_step = 0.0001 /", "at most 1000000 can be solved in one sweep", "= 0.0001", "= 300")
      call follow("+", "&sweep bit_depth_step = 300, operations = 'up', 'rotary', wob = 5, tob = 1 /", &
                  "give one for each operation where that is not meant", "wob = 5, tob = 1", "wob = 0, 5, tob = 0, 1")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate name = 'k', separate = "// &
                  "'none', apply = .true., hookload_deviation = 3 / &uncertainty bit_depth_step = 300, friction_from = 'k', "// &
                  "friction_deviation = 0.02", "leave out the other keys of friction", ", friction_deviation = 0.02", "")
   end subroutine test_sweeps

   !> Cases that a calibration needs, or cannot use.
   subroutine test_data()
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate parameter = 'free_point', "// &
                  "stretch = 0.5, cases = 'u'", "a free point needs two", "cases = 'u'", &
                  "cases = 'u', 'v' / &load_case name = 'v', operation = 'up', measured_hookload = 400, bit_depth = 900")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate parameter = 'free_point', "// &
                  "stretch = 0.5, cases = 'u', 'v' / &load_case name = 'v', operation = 'up', measured_hookload = 400, "// &
                  "bit_depth = 800", "must have the same string, operation and bit_depth", "= 800", "= 900")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate parameter = 'free_point', "// &
                  "stretch = 0.5, cases = 'u', 'v' / &load_case name = 'v', operation = 'up', measured_hookload = 300, "// &
                  "bit_depth = 900", "must differ in measured_hookload", "= 300, bit_depth = 900 /", "= 400, bit_depth = 900 /")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate parameter = 'free_point', "// &
                  "cases = 'u', 'v' / &load_case name = 'v', operation = 'up', measured_hookload = 400, bit_depth = 900", &
                  "parameter = 'free_point' needs stretch", "'free_point'", "'free_point', stretch = 0.5")
      call follow("bit_depth = 900.0", &
                  "measured_hookload = 300, bit_depth = 900.0 / &calibrate parameter = 'sticking', cases = 'u'", &
                  "parameter = 'sticking' needs sticking_depth", "'sticking'", "'sticking', sticking_depth = 300")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &load_case name = 'v', operation = "// &
                  "'up', bit_depth = 800, measured_torque = 3 / &calibrate parameter = 'sticking', sticking_depth = 300, "// &
                  "cases = 'u', 'v'", "give it or leave the case out", "= 3 /", "= 3, measured_hookload = 250 /")
      call follow("bit_depth = 900.0", &
                  "measured_hookload = 300, bit_depth = 900.0 / &calibrate cases = 'u', 's', separate = 'none'", &
                  "give one or leave it out", ", 's', sep", ", sep")
      call follow("'centred' /", "'centred', packer_bore = 100, packer_hold = 'fixed' / &load_case name = 'v', operation = "// &
                  "'trip_out', bit_depth = 800, measured_hookload = 300 / &load_case name = 'w', operation = 'trip_out', "// &
                  "bit_depth = 800, length_reference = 'v', measured_hookload = 300 / &calibrate cases = 'v', 'w', separate "// &
                  "= 'none' /", "whose load depends on friction; leave it out", "'v', 'w'", "'v'")
      call follow("bit_depth = 900.0", &
                  "measured_hookload = 300, bit_depth = 900.0 / &calibrate separate = 'none', parameter = 'friction_rotary'", &
                  "add such a case or leave out", "'friction_rotary'", "'friction_rotary' / &load_case name = 'r', operation "// &
                  "= 'rotate_off_bottom', bit_depth = 900, measured_torque = 3")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate separate = 'holes'", &
                  "add measurements, or leave out separate or offset", "'holes'", &
                  "'holes' / &load_case name = 'm', operation = 'up', bit_depth = 600, measured_hookload = 200")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &load_case name = 'w', operation = "// &
                  "'down', bit_depth = 900 / &calibrate cases = 'u', separate = 'operations', predict = 'w'", &
                  "leave it out or separate less", "'operations'", "'none'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0, friction = 0.2 / &calibrate cases = 'u', "// &
                  "separate = 'none', apply = .true.", "leave it out there, or leave out apply", ", friction = 0.2 /", " /")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &load_case name = 'm', operation = "// &
                  "'up', bit_depth = 800, measured_hookload = 300 / &load_case name = 'n', operation = 'down', bit_depth = "// &
                  "800, measured_hookload = 200 / &rig block_weight = 60 / &calibrate name = 'a', holes = 'hole 1', "// &
                  "parameter = 'friction_axial', offset = 'one', apply = .true. / &calibrate name = 'b', holes = 'hole 2', "// &
                  "parameter = 'friction_axial', offset = 'one', apply = .true.", "to the block_weight of &rig already; keep one", &
                  "offset = 'one', apply = .true. / &calibrate name = 'b'", "apply = .true. / &calibrate name = 'b'")
   end subroutine test_data
   !> More than a calibration holds.
   subroutine test_many()
      character(*), parameter :: by_depth = "&calibrate separate = 'depths' /"
      character(*), parameter :: advice = "name fewer cases or holes, or separate less"
      character(:), allocatable :: deck
      deck = good_deck()//cases(1001)
      call follow("+", by_depth, advice, "'depths'", "'none'", deck)
      call follow("+", by_depth, advice, "'depths'", "'depths', cases = 'c1', 'c2'", deck)
      call follow("+", "&calibrate parameter = 'sticking', sticking_depth = 50, model = 'mcge', 'soft', 'rigid', 'mixed' /", &
                  "; name fewer cases", "th = 50,", "th = 50, cases = 'c1',", good_deck()//cases(2501))
   end subroutine test_many

   !> Load cases with a measured hook load, each at a bit depth of its own.
   function cases(n) result(text)
      integer, intent(in) :: n
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, n
         text = text//"&load_case name = 'c"//to_text(i)//"', operation = 'up', measured_hookload = 100, bit_depth = "// &
                to_text(100.0_wp + 0.2_wp*i)//' /'//newline
      end do
   end function cases

   !> Hook loads that know only a mixture of two sections, or are below the weight of the string.
   subroutine test_apart()
      character(*), parameter :: apart = "measure at other depths or in other operations, or "// &
                                          "find one factor for all (separate = 'none')"
      character(:), allocatable :: deck
      deck = straight_deck(70.0_wp, 150.0_wp, 60.0_wp, "cases = 'b', 'c'")
      call follow_run(deck, apart, "cases = 'b', 'c'", "cases = 'a', 'b', 'c'")
      call follow_run(deck, apart, "cases = 'b', 'c'", "cases = 'b', 'c', separate = 'none'")
      deck = straight_deck(0.45_wp*along, along + 0.26_wp*across, along - 0.26_wp*across, "name = 'k'")
      call follow_run(deck, "one section that takes the friction of another (separate = 'none' finds one factor for all)", &
                      "'k'", "'k', separate = 'none'")
   end subroutine test_apart

   !> A string that locks up at all factors of friction, or at those with which the fit begins.
   subroutine test_no_fit()
      character(*), parameter :: advice = "; leave it out, or begin with other factors in the deck"
      character(*), parameter :: next_hole = " /"//newline//"&hole name = 'lower', diameter = 215.9, friction = "
      character(:), allocatable :: deck
      deck = straight_deck(0.5_wp*(along + 0.01_wp*across), along + 0.01_wp*across, 60.0_wp, &
                           "separate = 'none', model = 'mcge'")//"&solver fidelity = 'fast' /"//newline
      deck = replaced(deck, "'c', operation = 'down'", "'c', operation = 'sliding', wob = 800")
      deck = replaced(replaced(deck, 'friction = 0.1', 'friction = 1.9'), 'friction = 0.1', 'friction = 1.9')
      call follow_run(deck, advice, "model =", "cases = 'a', 'b', model =", 3)
      call follow_run(deck, advice, 'friction = 1.9'//next_hole//'1.9', 'friction = 0.05'//next_hole//'0.05', 3)
   end subroutine test_no_fit

   !> The run of a deck has a message with `expected`; with `fault` changed to `remedy` it has not.
   subroutine follow_run(deck, expected, fault, remedy, status)
      character(*), intent(in) :: deck, expected, fault, remedy
      integer, intent(in), optional :: status       !< of the first run
      type(run_type) :: run
      integer :: wanted
      wanted = 0
      if (present(status)) wanted = status
      run = run_deck_text(deck)
      call assertEqual(wanted, run%status, message=run%diagnostics)
      call assertTrue(index(unwrapped(run%output), expected) > 0, message='wanted: '//expected//'; got: '//run%output)
      run = run_deck_text(replaced(deck, fault, remedy))
      call assertEqual(0, run%status, message='followed: '//expected//'; got: '//run%diagnostics)
      call assertEqual(0, index(unwrapped(run%output), expected), message='followed: '//run%output)
   end subroutine follow_run

   !> A straight inclined hole in two sections; hook loads [kN] of pulling out at two depths, and of lowering.
   function straight_deck(up_half, up_full, down_full, calibrate) result(text)
      real(wp), intent(in) :: up_half, up_full, down_full
      character(*), intent(in) :: calibrate           !< keys of the group
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
             "&hole name = 'upper', md_bottom = 400, diameter = 220, friction = 0.1 /"//newline// &
             "&hole name = 'lower', diameter = 215.9, friction = 0.1 /"//newline// &
             "&fluid density = 0 /"//newline//"&component od = 127, id = 108.6, mass = 20 /"//newline// &
             "&load_case name = 'a', operation = 'up', bit_depth = 500, measured_hookload = "//to_text(up_half)//" /"//newline// &
             "&load_case name = 'b', operation = 'up', bit_depth = 1000, measured_hookload = "//to_text(up_full)//" /"//newline// &
             "&load_case name = 'c', operation = 'down', bit_depth = 1000, measured_hookload = "//to_text(down_full)// &
             " /"//newline// &
             "&calibrate "//calibrate//" /"//newline
   end function straight_deck
end module dg_test_followed_studies
