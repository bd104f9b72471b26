!> Runs on paths that have more than the deck's stations: tortuosity against a soft string of the test's own, the same digits for
!> any threads, where results name it, refusals.
module dg_test_path_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree, pi
   use dg_kinds, only: wp
   use dg_program_run, only: content, deck_path, results_path, run_deck_text, run_program, run_type
   use dg_result_rows, only: lines_of, number
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: path_runs_suite

   character(*), parameter :: newline = achar(10)
   !> Straight hole of 1000 m, pipe of 20 kg/m without mud [deg, N/m, -, m].
   real(wp), parameter :: inclination = 60.0_wp, weight = 20.0_wp*9.80665_wp, friction = 0.3_wp, radius = 0.0635_wp
   real(wp), parameter :: amplitude = 1.0_wp, period = 100.0_wp, length = 1000.0_wp
   integer, parameter :: summary_hookload = 8, summary_torque = 14

contains

   function path_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('path_runs')
      call suite%addTest(TestMethod('against_johancsik', test_johancsik))
      call suite%addTest(TestMethod('threads', test_threads))
      call suite%addTest(TestMethod('named_in_results', test_named))
      call suite%addTest(TestMethod('bad_tortuosity', test_bad_tortuosity))
      call suite%addTest(TestMethod('bad_tie_on', test_bad_tie_on))
   end function path_runs_suite

   !> The deck; `group` stands in line 3.
   function deck(keys, group) result(text)
      character(*), intent(in) :: keys        !< of &job
      character(*), intent(in) :: group
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. "//keys//'/'//newline// &
         '&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /'//newline//group//newline// &
         '&hole diameter = 220, friction = 0.3 /'//newline//'&component od = 127, id = 108.6, mass = 20 /'//newline// &
         "&load_case name = 'up', operation = 'up', bit_depth = 1000 /"//newline// &
         "&load_case name = 'rot', operation = 'rotate_off_bottom', bit_depth = 1000 /"//newline
   end function deck

   !> Hook load and torque of the formulas of Johancsik, Friesen & Dawson (1984), stepped from the bit in 2000 pieces of half a
   !> metre along a hole whose angles vary linearly between stations a sixteenth of the period apart.
   pure subroutine johancsik(swing, rubbing, hookload, torque)
      real(wp), intent(in) :: swing           !< amplitude [rad]
      real(wp), intent(in) :: rubbing         !< friction along the hole [-]; 0: the string turns
      real(wp), intent(out) :: hookload       !< [N]
      real(wp), intent(out) :: torque         !< [N m]
      real(wp), parameter :: piece = 0.5_wp
      real(wp) :: lower, upper, between, pressing
      integer :: i
      hookload = 0.0_wp
      torque = 0.0_wp
      do i = nint(length/piece), 1, -1
         lower = change(i*piece)
         upper = change((i - 1)*piece)
         between = inclination*degree + 0.5_wp*(lower + upper)
         pressing = hypot(hookload*(lower - upper)*sin(between), hookload*(lower - upper) - weight*piece*sin(between))
         hookload = hookload + weight*piece*cos(between) + rubbing*pressing
         torque = torque + friction*pressing*radius
      end do
   contains
      !> Of inclination and azimuth alike.
      pure function change(md) result(angle)
         real(wp), intent(in) :: md
         real(wp) :: angle
         real(wp) :: place
         integer :: station
         place = 16.0_wp*md/period
         station = int(place)
         angle = swing*(sin(2.0_wp*pi*station/16) + (place - station)*(sin(2.0_wp*pi*(station + 1)/16) - &
                                                                      sin(2.0_wp*pi*station/16)))
      end function change
   end subroutine johancsik

   !> Compare the effect of the sine on hook load and torque with that of the test's own soft string. The effect agrees within 1 %,
   !> hook load and torque within 0.1 %.
   subroutine test_johancsik()
      character(*), parameter :: sine = "&tortuosity kind = 'sine', amplitude = 1, period = 100 /"
      real(wp), dimension(2) :: ours, ours_smooth, theirs, theirs_smooth
      real(wp) :: unused
      call solve('', ours_smooth)
      call solve(sine, ours)
      call johancsik(0.0_wp, friction, theirs_smooth(1), unused)
      call johancsik(0.0_wp, 0.0_wp, unused, theirs_smooth(2))
      call johancsik(amplitude*degree, friction, theirs(1), unused)
      call johancsik(amplitude*degree, 0.0_wp, unused, theirs(2))
      call assertTrue(all(abs(ours_smooth - theirs_smooth) < 1.0e-3_wp*theirs_smooth), message='smooth')
      call assertTrue(all(abs(ours - theirs) < 1.0e-3_wp*theirs), message=to_text(ours(1))//' '//to_text(theirs(1)))
      call assertTrue(all(theirs > 1.02_wp*theirs_smooth), message='it adds something')
      call assertTrue(all(abs((ours - ours_smooth) - (theirs - theirs_smooth)) < 0.01_wp*(theirs - theirs_smooth)), &
                      message='added: '//to_text(ours(1) - ours_smooth(1))//' '//to_text(theirs(1) - theirs_smooth(1))//', '// &
                      to_text(ours(2) - ours_smooth(2))//' '//to_text(theirs(2) - theirs_smooth(2)))
   end subroutine test_johancsik

   !> Hook load up [N] and torque rotating [N m] of the program.
   subroutine solve(group, found)
      character(*), intent(in) :: group
      real(wp), intent(out) :: found(2)
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      run = run_deck_text(deck('', group))
      found = 0.0_wp
      call assertEqual(0, run%status, message=run%diagnostics)
      if (run%status /= 0) return
      allocate (lines, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      found = [1.0e3_wp*number(lines(2)%text, summary_hookload), 1.0e3_wp*number(lines(3)%text, summary_torque)]
   end subroutine solve

   !> A sweep on a random hole: the same file on one thread and on two, and in a second run.
   subroutine test_threads()
      character(*), parameter :: random = "&tortuosity kind = 'random', amplitude = 1, period = 30, seed = 3 / "// &
         "&sweep name = 's', operations = 'up', 'rotate_off_bottom' /"
      type(run_type) :: run
      character(:), allocatable :: first
      run = run_deck_text(deck('', random), '--threads 1')
      call assertEqual(0, run%status, message=run%diagnostics)
      first = content(results_path//'/sweep_s.csv')
      call assertTrue(len(first) > 1000, message='a sweep')
      run = run_deck_text(deck('', random), '--threads 2')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(first == content(results_path//'/sweep_s.csv'), message='threads')
   end subroutine test_threads

   !> Table, page and check name it; a deck without it has no word of a path.
   subroutine test_named()
      character(*), parameter :: sine = "&tortuosity kind = 'sine', amplitude = 1, period = 100, md_top = 200 /"
      character(*), parameter :: words = 'group &tortuosity in line 3: laid on the path from 200 to 1000 m'
      character(:), allocatable :: drawn
      integer :: at
      type(run_type) :: run
      drawn = deck('', sine)
      at = index(drawn, 'plots = .false.')
      drawn(at:at + 14) = 'plots = .true. '
      run = run_deck_text(drawn, '--quiet')
      call assertEqual(1, index(run%output, 'Path: '//words), message=run%output)
      call assertTrue(index(content(results_path//'/report.html'), &
                            'Path: group &amp;tortuosity in line 3: laid on the path from 200 to 1000 m') > 0)
      run = run_program(deck_path//' --check')
      call assertTrue(index(run%output, 'note        '//words) > 0, message=run%output)
      run = run_deck_text(deck('', sine))
      call assertEqual(1, index(run%output, 'Path: '//words), message=run%output)
      run = run_deck_text(deck('', ''))
      call assertEqual(0, index(run%output, 'Path'))
   end subroutine test_named

   subroutine test_bad_tortuosity()
      call refuse("amplitude = 1, period = 100", 'key kind is missing')
      call refuse("kind = 'sine', period = 100", 'key amplitude is missing')
      call refuse("kind = 'sine', amplitude = 1", 'key period is missing')
      call refuse("kind = 'sin', amplitude = 1, period = 100", "did you mean 'sine'?")
      call refuse("kind = 'sine', amplitude = 0, period = 100", 'amplitude = 0 is out of range; needs a number, > 0 and <= 10 deg')
      call refuse("kind = 'sine', amplitude = 11, period = 100", 'amplitude = 11 is out of range')
      call refuse("kind = 'sine', amplitude = 1, period = 0.5", 'period = 0.5 is out of range; needs a number, 1 to 50000 m')
      call refuse("kind = 'sine', amplitude = 1, period = 501", 'there is no room for two periods of 501 m')
      call refuse("kind = 'random', amplitude = 1, period = 30, md_top = 950", 'there is no room for two periods of 30 m')
      call refuse("kind = 'random', amplitude = 1, period = 30, md_bottom = 1001", 'is below the last station, 1000 m')
      call refuse("kind = 'sine', amplitude = 1, period = 30, seed = 2", "seed has no meaning with kind = 'sine'")
      call refuse("kind = 'sine', amplitude = 1, period = 30, md_bottom = 500 / &tortuosity kind = 'random', amplitude = 1, "// &
                  "period = 30, md_top = 499", 'overlaps the section in line 3, 0 m to 500 m')
      call refuse_text(deck('', "&tortuosity kind = 'sine', amplitude = 1, period = 100 / &uncertainty "// &
                            "inclination_deviation = 0.1 /"), 3, "group &uncertainty: errors of single stations")
   end subroutine test_bad_tortuosity

   subroutine test_bad_tie_on()
      call refuse_path("md = 100, 1000, inc = 0.6, 60, azi = 0, 0", "give tie_on = 'vertical', which makes 0.18 deg/30 m")
      call refuse_path("md = 100, 1000, inc = 0, 60, azi = 0, 0, kick_off = 50", "kick_off has no meaning without tie_on")
      call refuse_path("md = 100, 1000, inc = 5, 60, azi = 0, 0, tie_on = 'vertical', kick_off = 100", &
                       'kick_off is not above the first station, 100 m')
      call refuse_path("md = 0, 1000, inc = 5, 60, azi = 0, 0, tie_on = 'vertical', kick_off = 10", &
                       'kick_off is not above the first station, 0 m')
      call refuse_path("md = 100, 1000, inc = 5, 60, azi = 0, 0, tie_on = 'sideways'", "tie_on = 'sideways' is unknown")
   contains
      subroutine refuse_path(keys, expected)
         character(*), intent(in) :: keys, expected
         call refuse_text('&trajectory '//keys//' /'//newline//'&hole diameter = 220 /'//newline//'&component od = 127 /'// &
                          newline//"&load_case name = 'a', operation = 'up', bit_depth = 1000 /"//newline, 1, expected)
      end subroutine refuse_path
   end subroutine test_bad_tie_on

   subroutine refuse(keys, expected)
      character(*), intent(in) :: keys, expected
      call refuse_text(deck('', '&tortuosity '//keys//' /'), 3, expected)
   end subroutine refuse

   subroutine refuse_text(text, line, expected)
      character(*), intent(in) :: text
      integer, intent(in) :: line
      character(*), intent(in) :: expected
      type(run_type) :: run
      run = run_deck_text(text)
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, deck_path//':'//to_text(line)//': group &') > 0 .and. &
                      index(run%diagnostics, expected) > 0, message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse_text
end module dg_test_path_runs
