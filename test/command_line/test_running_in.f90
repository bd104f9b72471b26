!> friction_running_in of &hole: the axial friction of trip_in alone, wherever friction is asked for, overridden or looked for.
module dg_test_running_in
   use funit, only: anyExceptions, assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: replaced, results_path, run_deck_text, run_type
   use dg_result_rows, only: lines_of, number
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: running_in_suite

   character(*), parameter :: newline = achar(10)
   !> Straight hole of 1000 m at 60 deg, pipe of 20 kg/m without mud: weight along the hole and across it [kN].
   real(wp), parameter :: along = 20.0_wp*9.80665_wp*0.5_wp, across = 20.0_wp*9.80665_wp*0.8660254037844386_wp
   !> Column of the hook load in summary.csv.
   integer, parameter :: hookload = 8
   !> Friction of a section, and the coefficients that its operations then have.
   character(*), parameter :: given = 'friction = 0.2, friction_running_in = 0.3', low = 'friction = 0.2', high = 'friction = 0.3'

contains

   function running_in_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('running_in')
      call suite%addTest(TestMethod('all_models', test_models))
      call suite%addTest(TestMethod('load_case_overrides', test_override))
      call suite%addTest(TestMethod('sweeps_and_samples', test_sweeps))
      call suite%addTest(TestMethod('calibration', test_calibration))
      call suite%addTest(TestMethod('told', test_told))
   end function running_in_suite

   !> A deck whose second section has that friction.
   function deck(friction, more) result(text)
      character(*), intent(in) :: friction, more
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
         "&hole name = 'upper', md_bottom = 400, diameter = 220, friction = 0.1, cased = .true. /"//newline// &
         "&hole name = 'lower', md_bottom = 1000, diameter = 215.9, "//friction//" /"//newline// &
         "&fluid density = 0 /"//newline//"&component od = 127, id = 108.6, mass = 20 /"//newline// &
         "&load_case name = 'in', operation = 'down', bit_depth = 1000 /"//newline// &
         "&load_case name = 'out', operation = 'up', bit_depth = 1000 /"//newline// &
         "&load_case name = 'slide', operation = 'sliding', bit_depth = 1000 /"//newline//more//newline
   end function deck

   !> Lines of a file of results that hold a word.
   function rows(file, word) result(found)
      character(*), intent(in) :: file, word
      type(text_type), allocatable :: found(:)
      type(text_type), allocatable :: lines(:)
      integer :: i
      allocate (found(0))
      allocate (lines, source=lines_of(results_path//'/'//file))
      do i = 1, size(lines)
         if (index(lines(i)%text, word) > 0) found = [found, lines(i)]
      end do
   end function rows

   !> A run that ends well, and the rows of its file.
   subroutine run_rows(text, file, word, found)
      character(*), intent(in) :: text, file, word
      type(text_type), allocatable, intent(out) :: found(:)
      type(run_type) :: run
      run = run_deck_text(text)
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (found, source=rows(file, word))
      call assertTrue(size(found) > 0, message=file//' has no '//word)
   end subroutine run_rows

   !> Hook loads of each model: of trip_in as with the one friction, of the others as with the other.
   subroutine test_models()
      character(*), parameter :: models = "models = 'soft', 'rigid', 'mcge'"
      type(text_type), allocatable :: mine(:), in(:), out(:)
      integer :: i
      call run_rows(replaced(deck(given, ''), "models = 'soft'", models), 'summary.csv', ',converged,', mine)
      call run_rows(replaced(deck(high, ''), "models = 'soft'", models), 'summary.csv', ',converged,', in)
      call run_rows(replaced(deck(low, ''), "models = 'soft'", models), 'summary.csv', ',converged,', out)
      if (anyExceptions()) return
      call assertEqual(9, size(mine), message='three cases, three models')
      do i = 1, size(mine)
         if (index(mine(i)%text, ',trip_in,') > 0) then
            call assertEqual(number(in(i)%text, hookload), number(mine(i)%text, hookload), message=mine(i)%text)
            call assertTrue(number(out(i)%text, hookload) - number(mine(i)%text, hookload) > 5.0_wp, message=mine(i)%text)
         else
            call assertEqual(number(out(i)%text, hookload), number(mine(i)%text, hookload), message=mine(i)%text)
         end if
      end do
   end subroutine test_models

   !> A load case with friction of its own keeps it.
   subroutine test_override()
      character(*), parameter :: keys(2) = [character(20) :: 'friction = 0.15', 'friction_axial = 0.15']
      type(text_type), allocatable :: mine(:), other(:)
      integer :: i
      do i = 1, size(keys)
         call run_rows(replaced(deck(given, ''), "'down',", "'down', "//trim(keys(i))//','), 'summary.csv', ',trip_in,', mine)
         call run_rows(replaced(deck(low, ''), "'down',", "'down', "//trim(keys(i))//','), 'summary.csv', ',trip_in,', other)
         if (anyExceptions()) return
         call assertEqual(number(other(1)%text, hookload), number(mine(1)%text, hookload), message=trim(keys(i)))
      end do
   end subroutine test_override

   !> Sweeps and samples with the friction of the hole have it; those with friction of their own do not.
   subroutine test_sweeps()
      character(*), parameter :: sweeps = "&sweep name = 'hole', bit_depth_step = 250 /"//newline// &
         "&sweep name = 'own', bit_depth_step = 500, frictions = 0.15 /"//newline// &
         "&sweep name = 'pairs', bit_depth_step = 500, frictions_cased = 0.1, 0.15, frictions_open = 0.2, 0.25 /"//newline// &
         "&uncertainty name = 'drawn', bit_depth_step = 500, samples = 9, friction_deviation = 0.02 /"//newline// &
         "&uncertainty name = 'fixed', bit_depth_step = 500, samples = 9, friction = 0.25, friction_deviation = 0.02 /"
      call same_rows('sweep_hole.csv', 'trip_in', high)
      call same_rows('sweep_hole.csv', 'trip_out', low)
      call same_rows('uncertainty_drawn.csv', 'trip_in', high)
      call same_rows('uncertainty_drawn.csv', 'trip_out', low)
      call same_rows('sweep_own.csv', 'trip_in', low)
      call same_rows('sweep_pairs.csv', 'trip_in', low)
      call same_rows('uncertainty_fixed.csv', 'trip_in', low)
   contains
      subroutine same_rows(file, operation, friction)
         character(*), intent(in) :: file, operation
         character(*), intent(in) :: friction      !< of a deck that says the same
         type(text_type), allocatable :: mine(:), other(:)
         integer :: i
         call run_rows(deck(given, sweeps), file, ','//operation//',', mine)
         call run_rows(deck(friction, sweeps), file, ','//operation//',', other)
         if (anyExceptions()) return
         call assertEqual(size(other), size(mine), message=file)
         do i = 1, size(mine)
            call assertEqual(other(i)%text, mine(i)%text, message=file//' '//friction)
         end do
      end subroutine same_rows
   end subroutine test_sweeps

   !> A hook load of trip_in tells the friction of trip_in alone, and applying it leaves the others as they are.
   subroutine test_calibration()
      type(run_type) :: run
      character(:), allocatable :: text
      text = deck(given, "&calibrate name = 'k', holes = 'lower', cases = 'in', parameter = 'friction_axial', apply = .true. /")
      run = run_deck_text(replaced(text, "'down',", "'down', measured_hookload = "// &
                                   to_text(along - 0.4_wp*0.1_wp*across - 0.6_wp*0.35_wp*across)//','))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'lower: friction axial 0.2, rotary 0.2, running in 0.35') > 0, message=run%output)
      if (anyExceptions()) return
      call check_hookload('out', along + (0.4_wp*0.1_wp + 0.6_wp*0.2_wp)*across)
      call check_hookload('in', along - (0.4_wp*0.1_wp + 0.6_wp*0.35_wp)*across)
   contains
      subroutine check_hookload(name, wanted)
         character(*), intent(in) :: name
         real(wp), intent(in) :: wanted    !< [kN]
         type(text_type), allocatable :: found(:)
         allocate (found, source=rows('summary.csv', name//',,'))
         if (anyExceptions()) return
         call assertEqual(wanted, number(found(1)%text, hookload), 1.0e-3_wp, message=name)
      end subroutine check_hookload
   end subroutine test_calibration

   !> The check prints it; one out of range is a fault; a section that has it alone is not without friction when running in.
   subroutine test_told()
      type(run_type) :: run
      run = run_deck_text(deck(given, ''), '--check')
      call assertTrue(index(run%output, 'friction axial 0.2, rotary 0.2, running in 0.3'//newline) > 0, message=run%output)
      run = run_deck_text(deck(low, ''), '--check')
      call assertEqual(0, index(run%output, 'running in'), message=run%output)
      run = run_deck_text(deck('friction = 0.2, friction_running_in = 3', ''))
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'friction_running_in = 3') > 0, message=run%diagnostics)
      run = run_deck_text(deck('friction_running_in = 0.3', ''), '--check')
      call assertEqual(0, index(run%output, 'has no friction'), message=run%output)
   end subroutine test_told
end module dg_test_running_in
