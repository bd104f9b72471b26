!> Held strings as a user runs them, against closed forms: a straight inclined hole, where friction does not change with the
!> pull, and a weightless string in an arc, where a pull dies away as exp(-mu beta).
module dg_test_stuck_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: deck_path, results_path, run_deck_text, run_type
   use dg_result_rows, only: field, lines_of, number
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: stuck_runs_suite

   character(*), parameter :: newline = achar(10)
   real(wp), parameter :: pi = 3.141592653589793_wp
   !> E A of the pipe [kN].
   real(wp), parameter :: stiffness = 206.0e6_wp*0.25_wp*pi*(0.127_wp**2 - 0.1086_wp**2)
   !> Columns of calibration.csv.
   integer, parameter :: verdict = 12, depth = 19, frictionless = 20, resistance = 23, half_interval = 24, torque_resistance = 27

contains

   function stuck_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('stuck_runs')
      call suite%addTest(TestMethod('resistance_in_a_straight_hole', test_resistance))
      call suite%addTest(TestMethod('free_point_in_a_straight_hole', test_straight_free_point))
      call suite%addTest(TestMethod('free_point_in_an_arc', test_arc_free_point))
      call suite%addTest(TestMethod('free_to_the_bit', test_below_bit))
      call suite%addTest(TestMethod('bad_groups', test_bad_groups))
   end function stuck_runs_suite

   !> 1000 m of pipe in a hole of friction 0.2 (0.3 in the arc); nine lines before what is appended.
   function deck(inclinations, mass, friction) result(text)
      character(*), intent(in) :: inclinations, mass, friction
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = "//inclinations//", azi = 0, 0 /"//newline// &
         "&hole md_bottom = 1000, diameter = 220, friction = "//friction//" /"//newline//"&fluid density = 0 /"//newline// &
         "&component od = 127, id = 108.6, mass = "//mass//" /"//newline
   end function deck

   !> 20 kg/m at 60 deg: w L (cos 60 + 0.2 sin 60) free, 30 kN more held; torque 0.2 w L sin 60 r free, 2 kN.m more held. Any
   !> model, any depth: in a straight hole nothing above the point changes friction.
   subroutine test_resistance()
      real(wp), parameter :: weight = 20.0_wp*9.80665_wp, sine = sqrt(0.75_wp)
      real(wp), parameter :: models_apart = 1.0e-5_wp     ! beams: stretched, their contact forces turn with the string
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      integer :: i
      run = run_deck_text(deck('60, 60', '20', '0.2')// &
         "&load_case name = 'u', operation = 'up', bit_depth = 1000, measured_hookload = "// &
         to_text(weight*(0.5_wp + 0.2_wp*sine) + 30.0_wp)//" /"//newline// &
         "&load_case name = 'r', operation = 'rotate_off_bottom', bit_depth = 1000, measured_hookload = "// &
         to_text(weight*0.5_wp)//", measured_torque = "//to_text(0.2_wp*weight*sine*0.0635_wp + 2.0_wp)//" /"//newline// &
         "&calibrate parameter = 'sticking', sticking_depth = 600, model = 'soft', 'rigid', hookload_deviation = 1 /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'resistance at 600 m') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual(5, size(lines))
      if (size(lines) /= 5) return
      do i = 2, 4, 2
         call assertEqual('found', field(lines(i)%text, verdict))
         call assertEqual(30.0_wp, number(lines(i)%text, resistance), models_apart*weight, message=lines(i)%text)
         call assertEqual(1.96_wp, number(lines(i)%text, half_interval), 1.0e-3_wp, message='of a gauge of 1 kN')
         call assertEqual(0.0_wp, number(lines(i + 1)%text, resistance), models_apart*weight, message=lines(i + 1)%text)
         call assertEqual(2.0_wp, number(lines(i + 1)%text, torque_resistance), models_apart, message=lines(i + 1)%text)
      end do
   end subroutine test_resistance

   !> Stretch = change of pull times depth over E A, friction or not.
   subroutine test_straight_free_point()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(deck('60, 60', '20', '0.2')//pulls()// &
         "&calibrate parameter = 'free_point', stretch = "//to_text(100.0_wp*640.0_wp/stiffness)//" /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'with friction, model soft:      640 m') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual(640.0_wp, number(lines(2)%text, depth), 1.0e-2_wp)
      call assertEqual(640.0_wp, number(lines(2)%text, frictionless), 1.0e-2_wp)
   end subroutine test_straight_free_point

   !> Arc of 90 deg over 1000 m, weightless: the additional pull is 100 kN exp(-mu s/R) at s, so that the stretch down to D is
   !> 100 kN R/(mu E A) (1 - exp(-mu D/R)); the usual formula takes R/mu (1 - exp(-mu D/R)) for the depth.
   subroutine test_arc_free_point()
      real(wp), parameter :: radius = 2000.0_wp/pi, friction = 0.3_wp, held = 800.0_wp
      real(wp), parameter :: apparent = radius/friction*(1.0_wp - exp(-friction*held/radius))
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(deck('0, 90', '0', '0.3')//pulls()//'&solver element_length = 10 /'//newline// &
         "&calibrate parameter = 'free_point', stretch = "//to_text(100.0_wp*apparent/stiffness)//" /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      ! straight lines between points of the profile, 10 m apart: (mu h/R)^2/12 of the stretch, 2 mm; the search 1 mm
      call assertEqual(held, number(lines(2)%text, depth), 4.0e-3_wp)
      call assertEqual(apparent, number(lines(2)%text, frictionless), 1.0e-2_wp)
      call assertTrue(apparent < held - 100.0_wp, message='the usual formula is far too shallow here')
   end subroutine test_arc_free_point

   !> More stretch than the whole string has: it is free down to the bit, and no depth is made up.
   subroutine test_below_bit()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(deck('60, 60', '20', '0.2')//pulls()// &
         "&calibrate parameter = 'free_point', stretch = "//to_text(101.0_wp*1000.0_wp/stiffness)//" /"//newline)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'below the bit') > 0, message=run%output)
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual('below_bit', field(lines(2)%text, verdict))
      call assertEqual('', field(lines(2)%text, depth))
      call assertEqual('', field(lines(2)%text, frictionless), message='without friction')
   end subroutine test_below_bit

   !> The string at 300 and 400 kN, the greater pull first.
   function pulls() result(text)
      character(:), allocatable :: text
      text = "&load_case name = 'b', operation = 'up', bit_depth = 1000, measured_hookload = 400 /"//newline// &
             "&load_case name = 'a', operation = 'up', bit_depth = 1000, measured_hookload = 300 /"//newline
   end function pulls

   subroutine test_bad_groups()
      call refuse("parameter = 'sticking'", 'parameter = ''sticking'' needs sticking_depth')
      call refuse("parameter = 'sticking', sticking_depth = 1200", &
                  'sticking_depth = 1200 m lies below the bit of load case ''b'' at 1000 m')
      call refuse("parameter = 'sticking', sticking_depth = 600, separate = 'holes'", 'separate has no meaning')
      call refuse("parameter = 'sticking', sticking_depth = 600, cases = 'c'", 'there is no load case ''c''')
      call refuse("parameter = 'free_point'", 'needs stretch')
      call refuse("parameter = 'free_point', stretch = 0.5, cases = 'a'", '1 load cases; a free point needs two')
      call refuse("parameter = 'free_point', stretch = 0.5, sticking_depth = 5", 'sticking_depth has no meaning')
      call refuse("sticking_depth = 5", 'sticking_depth has no meaning with parameter = ''friction''')
      call refuse("parameter = 'free_point', stretch = 0", 'stretch = 0 is out of range')
      call refuse("parameter = 'free_point', stretch = 0.5 / &load_case name = 'c', operation = 'up', bit_depth = 900,"// &
                  " measured_hookload = 9 / &calibrate parameter = 'free_point', stretch = 1, cases = 'a', 'c'", &
                  'must have the same string, operation and bit_depth')
      call refuse("parameter = 'free_point', stretch = 0.5 / &load_case name = 'c', operation = 'up', bit_depth = 1000,"// &
                  " measured_hookload = 300 / &calibrate parameter = 'free_point', stretch = 1, cases = 'a', 'c'", &
                  'must differ in measured_hookload')
   end subroutine test_bad_groups

   subroutine refuse(keys, expected)
      character(*), intent(in) :: keys, expected
      type(run_type) :: run
      run = run_deck_text(deck('60, 60', '20', '0.2')//pulls()//'&calibrate '//keys//' /'//newline)
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, deck_path//':8: group &calibrate: ') > 0 .and. &
                      index(run%diagnostics, expected) > 0, message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse
end module dg_test_stuck_runs
