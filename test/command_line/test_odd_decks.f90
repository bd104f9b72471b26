!> Decks that are legal but hardly meant: they are run, and the program says what is odd. The good deck is not odd.
module dg_test_odd_decks
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: deck_path, good_deck, replaced, results_path, run_deck_text, run_program, run_type
   use dg_text, only: to_text
   implicit none
   private
   public :: odd_decks_suite

   character(*), parameter :: newline = achar(10)

contains

   function odd_decks_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('odd_decks')
      call suite%addTest(TestMethod('slips_of_units', test_units))
      call suite%addTest(TestMethod('stabilizer_without_blades', test_blades))
      call suite%addTest(TestMethod('thresholds', test_thresholds))
      call suite%addTest(TestMethod('parts_that_nothing_uses', test_unused))
      call suite%addTest(TestMethod('sparse_spline', test_spline))
      call suite%addTest(TestMethod('little_memory', test_little_memory))
      call suite%addTest(TestMethod('more_than_the_machine_has', test_too_large))
   end function odd_decks_suite

   subroutine test_units()
      type(run_type) :: run
      run = run_deck_text(good_deck(), '--check')
      call assertEqual(0, index(run%output, 'note '), message=run%output)
      call note('density = 1200.0', 'density = 1.2', 'that of a gas')
      call note('od = 127.0, id = 108.6'//newline//'  joint_od = 168.3', 'od = 5.0, id = 4.276'//newline//'  joint_od = 6.63', &
                'it is 6.63 mm wide in holes of 215.9 mm and more')
      ! 29 kg/m in pounds a foot: below three quarters of what the tube weighs
      call note('joint_od = 168.3', 'joint_od = 168.3, mass = 19.5', 'mass = 19.5, but a tube')
      call note('joint_od = 168.3', 'joint_od = 168.3, youngs = 30', 'youngs = 30')
      call note('md  = 0.0, 500.0, 900.0', 'md  = 0.0, 899.0, 900.0', 'the hole turns by 900 deg/30 m')
      call note('od = 171.45', 'mass = 136.0, density = 2800.0, od = 171.45', 'mass = 136')
   end subroutine test_units

   !> Every key has a default, so that a stabilizer may do without joint_od: its od touches.
   subroutine test_blades()
      call note("joint_od = 168.3", "kind = 'stabiliser'", 'a stabilizer without joint_od touches at its od, 127 mm')
      call note('&component od = 127.0', "&centralizer component = 'pipe', od = 160, spacing = 10 /"//newline// &
                "&component name = 'pipe', od = 127.0", 'the centralizers do not touch')
   end subroutine test_blades

   subroutine test_thresholds()
      call note('element_length = 10.0', 'element_length = 10.0, eps_n0 = 0.015', 'this close to the wall is ignored')
   end subroutine test_thresholds

   !> A spline through three stations swings; with stations every 30 m of the same bend it does not, and is not told of.
   subroutine test_spline()
      character(*), parameter :: stations = 'md  = 0.0, 500.0, 900.0'
      type(run_type) :: run
      character(:), allocatable :: text, angles
      integer :: i
      call note(stations, "interpolation = 'spline', "//stations, 'swings between sparse stations')
      text = '0.0'
      angles = '0.0'
      do i = 1, 30
         text = text//', '//to_text(30*i)
         angles = angles//', '//to_text(min(max(2*(i - 8), 0), 40))
      end do
      text = replaced(replaced(good_deck(), 'azi = 3*10.0', "azi = 31*10.0, interpolation = 'spline'"), stations, 'md = '//text)
      run = run_deck_text(replaced(text, 'inc = 0.0, 0.0, 30.0', 'inc = '//angles), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, 'swings'), message=run%output)
   end subroutine test_spline

   subroutine test_unused()
      call note('length = 100.0', 'length = 900.0', "'drillpipe' never enters the hole")
      call note("&boundary", "&component string = 'liner', od = 139.7, id = 121.4 /"//newline//"&boundary", &
                "string 'liner' is used by no case")
      call note('od = 171.45', 'od = 171.45, bend = 1.5, bend_position = 2', 'model soft ignores the bent housing')
      call note('od = 171.45', 'od = 171.45, bend = 1.5, bend_position = 2', 'bent by 1.5 deg at 2 m, straight where the '// &
                'string rotates')
   end subroutine test_unused

   !> A shell that allows 200 MB: solved, or refused in words whose advice helps. The limit of processor time ends a program that
   !> hangs.
   subroutine test_little_memory()
      character(*), parameter :: limits = 'ulimit -t 60; ulimit -v 204800;'
      character(*), parameter :: sweep = "&sweep operations = 'up', bit_depth_to = 900, bit_depth_step = 0.001 /"//newline
      character(*), parameter :: study = "&study cases = 'u', models = 'mcge', element_lengths = 0.01, 5 /"//newline
      character(*), parameter :: chance = "&uncertainty operations = 'up', bit_depth_to = 900, bit_depth_step = 0.9, "// &
                                          "samples = 2000, friction_deviation = 0.02 /"//newline
      character(*), parameter :: fit = "&calibrate cases = 'u', separate = 'none' /"//newline
      type(run_type) :: run
      run = run_program('--version', limits)
      if (run%status /= 0) return      ! built with sanitizers, which ask for terabytes
      run = under_limits(good_deck())
      call assertEqual(0, run%status, message=run%diagnostics)
      call refused(good_deck()//sweep, 'fewer frictions or a larger bit_depth_step', 'step = 0.001', 'step = 10')
      call refused(good_deck()//chance, 'fewer samples', 'samples = 2000', 'samples = 10')
      call refused(good_deck()//study, 'a larger element_length than 0.01 m', '0.01, 5', '1, 5')
      call refused(replaced(good_deck(), 'bit_depth = 900.0', 'bit_depth = 900.0, measured_hookload = 300.0')//fit, &
                   'give no &calibrate', fit, '')
   contains
      function under_limits(text) result(run)
         character(*), intent(in) :: text
         type(run_type) :: run
         run = run_deck_text(text, '--check')
         run = run_program(deck_path//' --output '//results_path, limits)
      end function under_limits

      subroutine refused(text, advice, fault, remedy)
         character(*), intent(in) :: text, advice, fault, remedy
         type(run_type) :: run
         run = under_limits(text)
         call assertEqual(1, run%status, message=run%diagnostics)
         call assertTrue(index(run%diagnostics, 'GB of memory') > 0 .and. index(run%diagnostics, advice) > 0, &
                         message=run%diagnostics)
         call assertFalse(run%has_results)
         run = under_limits(replaced(text, fault, remedy))
         call assertEqual(0, run%status, message=advice//': '//run%diagnostics)
      end subroutine refused
   end subroutine test_little_memory

   !> 400 strings of 50 km on elements of 1 cm need 2 TB; longer elements are solved.
   subroutine test_too_large()
      character(*), parameter :: advice = '; give a larger element_length than 0.01 m'
      character(:), allocatable :: text
      type(run_type) :: run
      integer :: i
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             '&trajectory md = 0, 50000, inc = 2*0, azi = 2*0 /'//newline//'&hole diameter = 215.9, friction = 0.2 /'//newline// &
             '&fluid density = 1200 /'//newline//'&component od = 127, id = 108.6 /'//newline
      do i = 1, 400
         text = text//"&load_case name = '"//to_text(i)//"', operation = 'up', bit_depth = 50000 /"//newline
      end do
      text = text//'&solver element_length = 0.01 /'//newline
      run = run_deck_text(text)
      call assertEqual(2, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'GB of memory, the machine has ') > 0 .and. index(run%diagnostics, advice) > 0, &
                      message=run%diagnostics)
      run = run_deck_text(replaced(text, '= 0.01 /', '= 1000 /'))
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_too_large

   !> The good deck with `old` changed to `new` passes, with a note that holds `expected`.
   subroutine note(old, new, expected)
      character(*), intent(in) :: old, new, expected
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), old, new), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'note ') > 0 .and. index(run%output, expected) > 0, &
                      message='wanted: '//expected//'; got: '//run%output)
   end subroutine note
end module dg_test_odd_decks
