!> Friction that a calibration applies: all that follows uses it, as if the deck had named it; what cannot be applied is refused.
module dg_test_applied_friction
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: deck_path, replaced, results_path, run_deck_text, run_program, run_type, unwrapped
   use dg_result_rows, only: field, lines_of
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: applied_friction_suite

   character(*), parameter :: newline = achar(10)
   !> Straight hole of 1000 m at 60 deg, pipe of 20 kg/m without mud: weight along the hole and across it [kN].
   real(wp), parameter :: along = 20.0_wp*9.80665_wp*0.5_wp, across = 20.0_wp*9.80665_wp*0.8660254037844386_wp
   character(*), parameter :: applied = "&calibrate name = 'k', apply = .true. /"
   integer, parameter :: parts = 3

contains

   function applied_friction_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('applied_friction')
      call suite%addTest(TestMethod('used_by_all', test_used))
      call suite%addTest(TestMethod('errors_of_factors_as_printed', test_rounded))
      call suite%addTest(TestMethod('parts', test_parts))
      call suite%addTest(TestMethod('handed_on', test_handed_on))
      call suite%addTest(TestMethod('nothing_to_apply', test_nothing))
      call suite%addTest(TestMethod('refused', test_refused))
      call suite%addTest(TestMethod('at_its_bound', test_bound))
      call suite%addTest(TestMethod('friction_that_is_possible', test_possible))
   end function applied_friction_suite

   !> Friction 0.2 down to 400 m and 0.3 below, as hook loads of tripping out at 500 and 1000 m tell it; 0.1 in the deck. What uses
   !> friction stands in line 9, a calibration in line 10.
   function deck(calibrate) result(text)
      character(*), intent(in) :: calibrate
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
         "&hole name = 'upper', md_bottom = 400, diameter = 220, friction = 0.1 /"//newline// &
         "&hole name = 'lower', md_bottom = 1000, diameter = 215.9, friction = 0.11 /"//newline// &
         "&fluid density = 0 /"//newline//"&component od = 127, id = 108.6, mass = 20 /"//newline// &
         "&load_case name = 'a', operation = 'up', bit_depth = 500, measured_hookload = "// &
         to_text(0.5_wp*along + 0.11_wp*across)//" /"//newline// &
         "&load_case name = 'b', operation = 'up', bit_depth = 1000, measured_hookload = "//to_text(along + 0.26_wp*across)// &
         " /"//newline//"&sweep name = 's', bit_depth_step = 250 / &uncertainty name = 'u', bit_depth_step = 500, samples = 9, "// &
         "friction_deviation = 0.02 / &sweep name = 'own', bit_depth_step = 500, frictions = 0.15 /"//newline//calibrate//newline
   end function deck

   !> The same deck with the factors in its hole sections and without calibration gives the same files; a sweep with friction of
   !> its own keeps it.
   subroutine test_used()
      character(*), parameter :: files(4) = [character(17) :: 'summary.csv', 'sweep_s.csv', 'sweep_own.csv', 'uncertainty_u.csv']
      type(run_type) :: run
      type(text_type), allocatable :: found(:), named(:), lines(:)
      run = run_deck_text(deck(applied))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'lower: friction axial 0.3, rotary 0.3') > 0, message=run%output)
      call assertTrue(index(run%output, 'Not every hole section has a 95 % interval') > 0, message=run%output)
      call assertTrue(index(run%output, 'Calibration k') < index(run%output, 'Model soft'), message='calibrated first')
      allocate (lines, source=lines_of(results_path//'/calibration.csv'))
      if (anyExceptions()) return
      call assertEqual('0.2000000000', field(lines(2)%text, 28), message=lines(2)%text)
      call assertEqual('0.3000000000', field(lines(3)%text, 28), message=lines(3)%text)
      allocate (found, source=contents())
      run = run_deck_text(replaced(replaced(deck(''), 'friction = 0.11', 'friction = 0.3'), 'friction = 0.1 ', 'friction = 0.2 '))
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (named, source=contents())
      call compare(found, named)
   contains
      !> The files one after the other, of the summary what comes before the status and the seconds.
      function contents() result(all_lines)
         type(text_type), allocatable :: all_lines(:)
         type(text_type), allocatable :: one(:)
         integer :: i, k
         allocate (all_lines(0))
         do i = 1, size(files)
            allocate (one, source=lines_of(results_path//'/'//trim(files(i))))
            do k = 1, size(one)
               if (i == 1) one(k)%text = one(k)%text(:index(one(k)%text//',converged', ',converged') - 1)
            end do
            all_lines = [all_lines, one]
            deallocate (one)
         end do
      end function contents
   end subroutine test_used

   !> Errors of a case that a calibration prints are those of the case with the printed factors.
   subroutine test_rounded()
      type(run_type) :: run
      type(text_type), allocatable :: data(:), cases(:)
      run = run_deck_text(replaced(deck(applied), to_text(0.5_wp*along + 0.11_wp*across), &
                                   to_text(0.5_wp*along + 0.111234_wp*across)))
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (data, source=lines_of(results_path//'/calibration_data.csv'))
      allocate (cases, source=lines_of(results_path//'/summary.csv'))
      if (anyExceptions()) return
      call assertEqual(field(cases(2)%text, 8), field(data(2)%text, 8), message=data(2)%text)
   end subroutine test_rounded

   !> An uncertainty goes on from a calibration: hook loads known to s = 2 kN tell friction with the covariance s^2 inverse(J'J),
   !> J = [0.4 0.1; 0.4 0.6] times the weight across the hole. Another deck that repeats what is printed gives the same.
   subroutine test_handed_on()
      character(*), parameter :: from = "&calibrate name = 'k', apply = .true., hookload_deviation = 2 /"
      !> Of det(J) = 0.2: columns of lengths sqrt(0.32), sqrt(0.37), product 0.28.
      real(wp), parameter :: deviations(2) = 2.0_wp/across*sqrt([0.37_wp, 0.32_wp])/0.2_wp
      character(:), allocatable :: printed, pairs, text
      type(run_type) :: run
      type(text_type), allocatable :: found(:), repeated(:)
      real(wp) :: read_back(2), ends(2)
      integer :: i
      run = run_deck_text(replaced(deck(from), 'friction_deviation = 0.02', "friction_from = 'K'"))
      call assertEqual(0, run%status, message=run%diagnostics)
      ends = [0.2_wp, 0.3_wp] + 1.959963984540054_wp*deviations
      call assertTrue(index(run%output, newline//'Upper end of its 95 % interval, each section alone (together less): '// &
                            to_text(ends(1), 4)//' in upper, '//to_text(ends(2), 4)//' in lower'//newline) > 0, message=run%output)
      allocate (found, source=lines_of(results_path//'/uncertainty_u.csv'))
      if (anyExceptions()) return
      i = index(run%output, 'friction_deviations = ')
      call assertTrue(i > 0, message=run%output)
      printed = run%output(i:i + index(run%output(i:), newline) - 2)
      read (printed(len('friction_deviations = ') + 1:index(printed, ', friction_parameter') - 1), *) read_back
      call assertEqual(deviations, read_back, 1.0e-5_wp, message='closed form')
      i = index(run%output, 'friction_correlations = ')
      call assertTrue(i > 0, message=run%output)
      pairs = run%output(i:i + index(run%output(i:), newline) - 2)
      read (pairs(len('friction_correlations = ') + 1:), *) read_back(1)
      call assertEqual(-0.28_wp/sqrt(0.32_wp*0.37_wp), read_back(1), 1.0e-4_wp, message='correlation')
      text = replaced(replaced(deck(''), 'friction = 0.11', 'friction = 0.3'), 'friction = 0.1 ', 'friction = 0.2 ')
      run = run_deck_text(replaced(text, 'friction_deviation = 0.02', printed//', '//pairs))
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (repeated, source=lines_of(results_path//'/uncertainty_u.csv'))
      if (anyExceptions()) return
      call compare(found, repeated)
   end subroutine test_handed_on

   !> Pipe that goes down a hole of 60 deg with the friction found, 0.45, and does not with the upper end of its interval. It does
   !> with the friction that the answer tells, weight along over weight across the hole, and not with 2 % more.
   subroutine test_possible()
      real(wp), parameter :: found = 0.45_wp
      character(*), parameter :: told = 'With up to about ', mark = newline//'x  '
      type(run_type) :: run
      character(:), allocatable :: number
      real(wp) :: factor
      integer :: at
      run = run_deck_text(well(0.1_wp)//"&calibrate separate = 'none', apply = .true., hookload_deviation = 19 /"//newline)
      call assertTrue(index(run%output, mark//'NO ') > 0, message=run%output)
      number = unwrapped(run%output)
      at = index(number, told)
      call assertTrue(at > 0 .and. index(number, ' times the calibrated friction the answer is yes') > at, message=run%output)
      if (at == 0) return
      read (number(at + len(told):), *) factor
      call assertEqual(along/across/found, factor, 0.01_wp, message='closed form')
      run = run_deck_text(well(found*factor))
      call assertTrue(index(run%output, mark//'yes ') > 0, message=run%output)
      run = run_deck_text(well(1.02_wp*found*factor))
      call assertTrue(index(run%output, mark//'NO ') > 0, message=run%output)
   contains
      !> Its deck, with hook loads of friction 0.45.
      function well(friction) result(text)
         real(wp), intent(in) :: friction      !< of the deck [-]
         character(:), allocatable :: text
         character(:), allocatable :: up
         up = "operation = 'up', measured_hookload = "
         text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
                "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
                "&hole diameter = 220, friction = "//to_text(friction)//" /"//newline//"&fluid density = 0 /"//newline// &
                "&component od = 127, id = 108.6, mass = 20 /"//newline// &
                "&load_case name = 'a', "//up//to_text(0.5_wp*(along + found*across))//", bit_depth = 500 /"//newline// &
                "&load_case name = 'b', "//up//to_text(along + found*across)//", bit_depth = 1000 /"//newline// &
                "&load_case name = 'x', operation = 'down', bit_depth = 1000 /"//newline
      end function well
   end subroutine test_possible

   !> A hook load below the weight asks for friction below 0. One factor for both sections is within its bounds.
   subroutine test_bound()
      type(run_type) :: run
      character(:), allocatable :: text
      text = replaced(deck(applied), to_text(0.5_wp*along + 0.11_wp*across), to_text(0.45_wp*along))
      run = run_deck_text(text)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'upper: friction axial 0, rotary 0, at its bound: no measured friction') > 0, &
                      message=run%output)
      call assertTrue(index(run%output, 'Warning: upper: the measurements ask for friction below 0; look for another cause') > 0, &
                      message=run%output)
      call assertTrue(index(unwrapped(run%output), 'Do not rely on them: after the calibration friction is 0 in upper') > 0, &
                      message=run%output)
      run = run_deck_text(replaced(text, 'apply', "separate = 'none', apply"))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, 'at its bound'), message=run%output)
      call assertEqual(0, index(unwrapped(run%output), 'Do not rely'), message=run%output)
   end subroutine test_bound

   !> Parts find the same friction each, and join.
   subroutine test_parts()
      type(run_type) :: run
      type(text_type), allocatable :: whole(:), joined(:)
      integer :: i
      run = run_deck_text(deck(applied))
      allocate (whole, source=lines_of(results_path//'/sweep_s.csv'))
      if (anyExceptions()) return
      do i = 1, parts
         run = run_program(deck_path//' --output '//results_path//' --part '//to_text(i)//'/'//to_text(parts))
         call assertEqual(0, run%status, message=run%diagnostics)
         call assertEqual(0, index(run%output, 'Calibration'), message='nothing told twice')
      end do
      run = run_program(deck_path//' --output '//results_path//' --merge '//to_text(parts))
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (joined, source=lines_of(results_path//'/sweep_s.csv'))
      if (anyExceptions()) return
      call compare(whole, joined)
   end subroutine test_parts

   !> No fit: nothing is run with friction that was not asked for.
   subroutine test_nothing()
      type(run_type) :: run
      logical :: there
      run = run_deck_text(replaced(deck("&calibrate name = 'k', apply = .true., model = 'mcge' / &solver max_iterations = 1 /"), &
                                   "name = 's'", "name = 's', model = 'soft'"))
      call assertEqual(3, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'calibration ''k'' has found no friction to apply') > 0, message=run%diagnostics)
      inquire (file=results_path//'/sweep_s.csv', exist=there)
      call assertFalse(there, message='no sweep')
      inquire (file=results_path//'/calibration.csv', exist=there)
      call assertTrue(there, message='what was tried is written')
   end subroutine test_nothing

   subroutine test_refused()
      call refuse("separate = 'depths', apply = .true.", 'apply needs separate = ''none'' or ''holes''')
      call refuse("model = 'soft', 'rigid', apply = .true.", 'apply needs one model')
      call refuse("apply = .true. / &calibrate separate = 'none', parameter = 'friction_axial', apply = .true.", &
                  'calibration ''1'' applies friction of hole section ''upper'' already')
      call refuse("parameter = 'sticking', sticking_depth = 300, apply = .true.", 'apply has no meaning with parameter')
      call refuse("apply = 1", 'apply = 1')
      call refuse("apply = .true. / &load_case name = 'c', operation = 'down', bit_depth = 900, friction = 0.2, "// &
                  "measured_hookload = 60", 'load case ''c'' (line 10) has friction of its own')
   end subroutine test_refused

   subroutine refuse(keys, expected)
      character(*), intent(in) :: keys, expected
      type(run_type) :: run
      run = run_deck_text(deck('&calibrate '//keys//' /'))
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, deck_path//':10: group &calibrate: ') > 0 .and. &
                      index(run%diagnostics, expected) > 0, message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse

   subroutine compare(one, two)
      type(text_type), intent(in) :: one(:), two(:)
      integer :: i
      call assertEqual(size(one), size(two))
      do i = 1, min(size(one), size(two))
         call assertEqual(one(i)%text, two(i)%text)
      end do
   end subroutine compare
end module dg_test_applied_friction
