!> What an answer says about a string that does not come down, followed: bit depth, speed along the hole of a string that turns. And
!> a yes whose hours are limited.
module dg_test_ways_down
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: content, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: value_after
   use dg_text, only: to_text
   implicit none
   private
   public :: ways_down_suite

   character(*), parameter :: newline = achar(10)

contains

   function ways_down_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('ways_down')
      call suite%addTest(TestMethod('depth_with_a_bend', test_bend))
      call suite%addTest(TestMethod('held_down_while_backreaming', test_held_down))
      call suite%addTest(TestMethod('yield_before_lock_up', test_yield))
      call suite%addTest(TestMethod('first_of_two_depths', test_floated))
      call suite%addTest(TestMethod('speed_of_a_string_that_turns', test_speed))
      call suite%addTest(TestMethod('limited_hours', test_hours))
   end function ways_down_suite

   !> A deck without pictures: vertical, a build of 10 deg/30 m, horizontal.
   function deck(more) result(text)
      character(*), intent(in) :: more
      character(:), allocatable :: text
      text = '&job plots = .false., hdf5 = .false., profiles = .false. /'//newline// &
         '&trajectory md = 0, 300, 570, 3000, inc = 0, 0, 90, 90, azi = 4*0 /'//newline// &
         "&hole name = 'cased', md_bottom = 570, diameter = 224.4, friction = 0.2, cased = .true. /"//newline// &
         "&hole name = 'open', md_bottom = 3000, diameter = 222.2, friction = 0.3 /"//newline// &
         '&fluid density = 1200 /'//newline//more//newline
   end function deck

   !> A floated casing: light at first, heavier on top when its bit is deeper than the air in it is long.
   function floated(operation) result(text)
      character(*), intent(in) :: operation
      character(:), allocatable :: text
      text = deck("&fluid density = 1.2, where = 'inside', above_bit = 1800, float_collar = 'closed' /"//newline// &
                  "&component catalogue = 'CSG 5-1/2 23.00 P110' /"//newline// &
                  "&load_case name = 'run', operation = "//operation//', bit_depth = 3000 /')
   end function floated

   !> Run a deck and compare its answer.
   subroutine expect(answer, text)
      character(*), intent(in) :: answer, text
      type(run_type) :: run
      run = run_deck_text(text)
      call assertTrue(index(run%output, newline//'run  '//answer) > 0, message=text//run%output)
   end subroutine expect

   !> A bend presses the hole in a slide. With it the depth is 2 % right; without its friction it would be 10 % too deep.
   subroutine test_bend()
      character(:), allocatable :: slide
      type(run_type) :: run
      real(wp) :: depth
      slide = deck("&component name = 'bit', kind = 'bit', length = 0.3, od = 150, joint_od = 222.2 /"//newline// &
                   "&component name = 'motor', kind = 'motor', length = 8, od = 171, id = 86, bend = 1.83, "// &
                   'bend_position = 1.7 /'//newline// &
                   "&component name = 'pipe', catalogue = 'DP 5 19.50 NC50 6-5/8x2-3/4 S135' /"//newline// &
                   "&load_case name = 'run', operation = 'sliding', bit_depth = 3000, wob = 20 /")
      run = run_deck_text(slide)
      call assertTrue(index(run%output, newline//'run  NO ') > 0, message=run%output)
      depth = value_after(run%output, 'Deepest bit depth possible: about ')
      call expect('yes ', replaced(slide, 'bit_depth = 3000', 'bit_depth = '//to_text(0.98_wp*depth)))
      call expect('NO ', replaced(slide, 'bit_depth = 3000', 'bit_depth = '//to_text(1.02_wp*depth)))
   end subroutine test_bend

   !> The string stops first at about 1,670 m. Farther down it would come to 2,480 m, but it does not get there.
   subroutine test_floated()
      character(*), parameter :: floats = ' of push needed at surface, as the weight of the '// &
                                'string in mud, along the hole, is below zero'
      type(run_type) :: run
      real(wp) :: depth
      run = run_deck_text(floated("'trip_in'"))
      depth = value_after(run%output, 'Deepest bit depth possible: about ')
      call expect('yes ', replaced(floated("'trip_in'"), 'bit_depth = 3000', 'bit_depth = '//to_text(0.98_wp*depth)))
      call expect('NO ', replaced(floated("'trip_in'"), 'bit_depth = 3000', 'bit_depth = '//to_text(1.02_wp*depth)))
      call expect('yes ', replaced(floated("'trip_in'"), 'bit_depth = 3000', 'bit_depth = 2200'))
      run = run_deck_text(replaced(floated("'trip_in'"), 'density = 1200', 'density = 2300'))
      call assertEqual(0, index(unwrapped(run%output), floats), message='mud above the air: '//run%output)
      run = run_deck_text(replaced(replaced(floated("'trip_in'"), 'density = 1200', 'density = 2300'), 'above_bit = 1800', &
                                   'above_bit = 3500'))
      call assertTrue(index(unwrapped(run%output), floats) > 0, message=run%output)
   end subroutine test_floated

   !> 'at 20 rpm at most about' a speed: a tenth less is a yes, a tenth more a NO.
   subroutine test_speed()
      type(run_type) :: run
      real(wp) :: speed
      run = run_deck_text(floated("'trip_in'"))
      speed = value_after(run%output, 'move it slowly (at 20 rpm at most about ')
      call expect('yes ', floated("'reaming', rpm = 20, trip_speed = "//to_text(0.9_wp*speed)))
      call expect('NO ', floated("'reaming', rpm = 20, trip_speed = "//to_text(1.1_wp*speed)))
   end subroutine test_speed

   !> Rotation beyond the fatigue limit, without an exponent: the answer says so at its head, and in a column.
   subroutine test_hours()
      character(*), parameter :: turning = &
         "&load_case name = 'run', operation = 'rotate', bit_depth = 3000, rpm = 120, hours = 10 /"
      character(*), parameter :: pipe = "&component name = 'pipe', catalogue = 'DP 5 19.50 NC50 6-5/8x2-3/4 S135', "
      type(run_type) :: run
      run = run_deck_text(replaced(deck(pipe//"fatigue_curve = 'S135' /"//newline//turning), '300, 570', '300, 350'))
      call assertTrue(index(unwrapped(run%output), '% of the fatigue limit. Hours of rotation are limited, how many is not '// &
                            'known.') > 0, message=run%output)
      call assertTrue(index(content(results_path//'/summary.csv'), ',fatigue,') > 0, message='column uncertain')
      run = run_deck_text(deck(pipe//"fatigue_curve = 'S135' /"//newline//turning))
      call assertEqual(0, index(run%output, 'UNCERTAIN'), message='a gentle bend: '//run%output)
   end subroutine test_hours

   !> Beyond the horizontal a string wants to go up: less drag, by a slower pull, does not help.
   subroutine test_held_down()
      type(run_type) :: run
      run = run_deck_text("&job plots = .false., hdf5 = .false., models = 'mcge' /"//newline// &
                          '&trajectory md = 0, 100, 700, 1500, inc = 0, 0, 130, 130, azi = 4*0 /'//newline// &
                          '&hole diameter = 216, friction = 0.2 /'//newline//'&fluid density = 1100 /'//newline// &
                          "&component kind = 'bit', length = 0.5, od = 150, joint_od = 210 /"//newline// &
                          "&component catalogue = 'DP 5 19.50 NC50 6-5/8x2-3/4 S135' /"//newline// &
                          "&load_case name = 'c', operation = 'backreaming', bit_depth = 1500, rpm = 60, trip_speed = 0.1 /")
      call assertTrue(index(unwrapped(run%output), 'The top must be held down with ') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'more slowly'), message=run%output)
   end subroutine test_held_down

   !> More weight comes to the bit than a thin pipe above it carries: the answer names the weight at which it yields. A little
   !> less is a yes, and a little more is a NO.
   subroutine test_yield()
      character(*), parameter :: more = ', but compressed pipe yields above about '
      type(run_type) :: run
      real(wp) :: most
      run = run_deck_text(thin_pipe(5.0_wp))
      call assertTrue(index(unwrapped(run%output), more) > 0, message=run%output)
      most = value_after(unwrapped(run%output), more)
      run = run_deck_text(thin_pipe(0.97_wp*most))
      call assertTrue(index(run%output, newline//'c  yes ') > 0, message=run%output)
      run = run_deck_text(thin_pipe(1.03_wp*most))
      call assertTrue(index(run%output, newline//'c  NO ') > 0, message=run%output)
   contains
      function thin_pipe(wob) result(text)
         real(wp), intent(in) :: wob          !< [kN]
         character(:), allocatable :: text
         text = "&job plots = .false., hdf5 = .false., models = 'soft' /"//newline// &
                '&trajectory md = 0, 1500, inc = 20, 20, azi = 2*0 /'//newline// &
                '&hole diameter = 200, friction = 0.2 /'//newline//'&fluid density = 1100 /'//newline// &
                "&component kind = 'bit', length = 0.5, od = 80, joint_od = 190 /"//newline// &
                '&component od = 73, id = 62, yield = 380, length = 60 /'//newline// &
                "&component kind = 'collar', od = 120, id = 50, yield = 760 /"//newline// &
                "&load_case name = 'c', operation = 'sliding', bit_depth = 1500, wob = "//to_text(wob)//' /'
      end function thin_pipe
   end subroutine test_yield
end module dg_test_ways_down
