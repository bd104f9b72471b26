!> Runs of strings with a bent housing, and of strings that wear casing: answers, what they leave out, and doglegs.
module dg_test_bent_runs
   use funit, only: anyExceptions, assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: content, replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: field, lines_of
   use dg_text, only: text_type
   implicit none
   private
   public :: bent_runs_suite

   character(*), parameter :: newline = achar(10)
   !> Columns of summary.csv.
   integer, parameter :: col_answer = 31, col_not_checked = 36

contains

   function bent_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bent_runs')
      call suite%addTest(TestMethod('casing_worn_through', test_worn))
      call suite%addTest(TestMethod('bend_that_turns', test_turning))
      call suite%addTest(TestMethod('side_force_of_a_bend_that_turns', test_side_force))
      call suite%addTest(TestMethod('doglegs_by_name', test_doglegs))
      call suite%addTest(TestMethod('page_without_warnings', test_page))
      call suite%addTest(TestMethod('sag_at_rest', test_sag))
      call suite%addTest(TestMethod('what_holds_a_string', test_holding))
   end function bent_runs_suite

   !> A motor in a lateral. Its 7 kN of friction are the little that locks the string up, but helical buckling is what holds it. The
   !> stiff assembly was given as the reason.
   subroutine test_holding()
      type(run_type) :: run
      run = run_deck_text('&job plots = .false., hdf5 = .false., profiles = .false. /'//newline// &
         '&trajectory md = 0, 609.6, 883.92, 5943.6, inc = 0, 0, 90, 90, azi = 4*0 /'//newline// &
         '&hole md_bottom = 883.92, diameter = 224.4, friction = 0.2, cased = .true. /'//newline// &
         '&hole md_bottom = 5943.6, diameter = 222.25, friction = 0.3 /'//newline//'&fluid density = 1198.3 /'//newline// &
         "&component kind = 'bit', length = 0.3, od = 152.4, id = 50.8, joint_od = 222.25 /"//newline// &
         "&component kind = 'motor', length = 7.92, od = 171.45, id = 101.6, bend = 1.83, bend_position = 1.524 /"//newline// &
         "&component kind = 'mwd', length = 9.14, od = 171.45, id = 82.55 /"//newline// &
         "&component catalogue = 'DP 5 19.50 NC50 6-5/8x2-3/4 S135' /"//newline// &
         "&load_case name = 'a', operation = 'sliding', bit_depth = 3980, wob = 66.72 /"//newline)
      call assertTrue(index(unwrapped(run%output), 'Locked up: with the bit at 3980 m, friction of helical buckling') > 0, &
                      message=run%output)
   end subroutine test_holding

   !> A deck without pictures, and more groups.
   function deck(models, inclination, more) result(text)
      character(*), intent(in) :: models, inclination, more
      character(:), allocatable :: text
      text = "&job models = '"//models//"', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
         '&trajectory md = 0, 600, inc = '//inclination//', '//inclination//', azi = 30, 30 /'//newline// &
         '&fluid density = 1200 /'//newline//more//newline
   end function deck

   !> Pipe that turns for some hours in casing with a wear factor.
   function worn(hours) result(text)
      character(*), intent(in) :: hours
      character(:), allocatable :: text
      text = deck('soft', '60', "&hole name = 'casing', diameter = 220.5, friction = 0.2, cased = .true., casing_od = 244.5, "// &
         'casing_yield = 552, wear_factor = 100 /'//newline// &
         "&component name = 'pipe', kind = 'drillpipe', od = 127, id = 108.6, mass = 31.9, joint_od = 165.1, "// &
         'yield = 931 /'//newline// &
         "&load_case name = 'turn', operation = 'rotate', bit_depth = 600, rpm = 120, hours = "//hours//' /')
   end function worn

   !> A motor with a bend, sliding and rotating.
   function bent(more) result(text)
      character(*), intent(in) :: more
      character(:), allocatable :: text
      text = deck('mcge', '40', '&hole diameter = 215.9, friction = 0.25, wall_stiffness = 1e7 /'//newline// &
         "&component name = 'bit', kind = 'bit', length = 0.3, od = 165, id = 50, joint_od = 215.9 /"//newline// &
         "&component name = 'sleeve', kind = 'stabilizer', length = 0.4, od = 171.4, id = 80, joint_od = 212.7 /"//newline// &
         "&component name = 'PDM', kind = 'motor', length = 6.6, od = 171.4, id = 95, yield = 180, bend = 1.5, "// &
         'bend_position = 0.5 /'//newline// &
         "&component name = 'stab', kind = 'stabilizer', length = 0.6, od = 171.4, id = 75, joint_od = 209.5 /"//newline// &
         "&component name = 'hw', kind = 'hwdp', od = 127, id = 76.2, mass = 73.4, joint_od = 165.1 /"//newline// &
         "&load_case name = 'slide', operation = 'sliding', bit_depth = 600, wob = 60, tob = 3 /"//newline// &
         "&load_case name = 'turn', operation = 'rotary', bit_depth = 600, wob = 60, tob = 3 /"//newline//more)
   end function bent

   !> The row of a load case in a file.
   function row_of(file, name) result(row)
      character(*), intent(in) :: file, name
      character(:), allocatable :: row
      type(text_type), allocatable :: lines(:)
      integer :: i
      row = ''
      allocate (lines, source=lines_of(results_path//'/'//file))
      do i = 1, size(lines)
         if (index(lines(i)%text, name//',') == 1) row = lines(i)%text
      end do
   end function row_of

   !> Number of a column of a file, 0 where it has none of that name.
   function column_of(file, name) result(number)
      character(*), intent(in) :: file, name
      integer :: number
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=lines_of(results_path//'/'//file))
      do number = 1, 1000
         if (index(field(lines(1)%text, number), name) == 1) return
      end do
      number = 0
   end function column_of

   !> Casing that is worn through is a NO. What is left of worn casing is not checked.
   subroutine test_worn()
      type(run_type) :: run
      run = run_deck_text(worn('200'))
      call assertEqual(0, run%status, message=run%diagnostics)
      if (anyExceptions()) return
      call assertEqual('yes', field(row_of('summary.csv', 'turn'), col_answer), message='little wear')
      call assertTrue(index(field(row_of('summary.csv', 'turn'), col_not_checked), 'strength_of_the_worn_casing') > 0)
      call assertTrue(index(unwrapped(run%output), 'strength of the worn casing') > 0, message=run%output)
      run = run_deck_text(worn('2900'))
      call assertEqual('no', field(row_of('summary.csv', 'turn'), col_answer), message='worn through')
      call assertTrue(index(row_of('summary.csv', 'turn'), ',casing_wear,') > 0)
      call assertEqual(0, index(unwrapped(run%output), 'strength of the worn casing'), message=run%output)
      call assertTrue(index(unwrapped(run%output), 'Casing wear by hours of rotation at ') > 0, message=run%output)
   end subroutine test_worn

   !> A bend is left out where the string turns: a warning that names the case with the bend, and a limit that is not checked.
   subroutine test_turning()
      type(run_type) :: run
      run = run_deck_text(bent(''))
      call assertEqual(0, run%status, message=run%diagnostics)
      if (anyExceptions()) return
      call assertTrue(index(unwrapped(run%output), "turn: The string turns and is solved with a straight housing: bending "// &
                            "moments and stresses at 'PDM' are those without its bend. Its bend is in 'slide'.") > 0, &
                      message=run%output)
      call assertTrue(index(unwrapped(run%output), 'bend of PDM') > 0, message=run%output)
      call assertTrue(index(field(row_of('summary.csv', 'turn'), col_not_checked), 'bend') > 0)
      call assertEqual(0, index(field(row_of('summary.csv', 'slide'), col_not_checked), 'bend'))
      run = run_deck_text(replaced(bent(''), 'sliding', 'up'))
      call assertTrue(index(unwrapped(run%output), "Add a case operation = 'sliding' at this depth") > 0, message=run%output)
   end subroutine test_turning

   !> limits.csv has no side force of a straight housing, and the table says what its own is.
   subroutine test_side_force()
      type(run_type) :: run
      integer :: column
      run = run_deck_text(bent('&steering length = 60 /'))
      call assertEqual(0, run%status, message=run%diagnostics)
      column = column_of('limits.csv', 'bit_side_force')
      if (anyExceptions()) return
      call assertTrue(column > 0)
      call assertEqual('', field(row_of('limits.csv', 'turn'), column))
      call assertTrue(field(row_of('limits.csv', 'slide'), column) /= '')
      call assertTrue(index(run%output, 'All of turn: means over the tool faces of its bent housing, which turns') > 0, &
                      message=run%output)
      call assertEqual(0, index(run%output, 'All of slide'))
   end subroutine test_side_force

   !> Each dogleg is named by how it was found. A measured one has the range that side_cutting can give.
   subroutine test_doglegs()
      character(*), parameter :: group = "&steering cases = 'slide', toolfaces = 0, length = 60, "
      type(run_type) :: run
      run = run_deck_text(bent(group//'side_cutting = 0.0144 /'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, ' by three-point geometry, ') > 0, message=run%output)
      call assertTrue(index(run%output, ' deg/30 m with side_cutting = 0.0144') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'zero bit side force'))
      run = run_deck_text(bent(group//'measured_dogleg = 12 /'))
      call assertTrue(index(run%output, ' deg/30 m with zero bit side force') > 0, message=run%output)
      call assertTrue(index(run%output, '. side_cutting can give ') > 0, message=run%output)
      run = run_deck_text(bent(group//'measured_dogleg = 50 /'))
      call assertTrue(index(run%diagnostics, 'no side_cutting above 0 gives the measured dogleg of 50 deg/30 m. '// &
                            'Without side cutting it is ') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'Check unit (per 30 m or 100 ft) and sign') > 0, message=run%diagnostics)
   end subroutine test_doglegs

   !> The page says of what it has no warnings: studies may have some. Small angles have three decimals.
   subroutine test_page()
      type(run_type) :: run
      run = run_deck_text(replaced(worn('200'), 'plots = .false.', 'plots = .true.'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(content(results_path//'/report.html'), 'No warnings on deck and load cases.') > 0)
      run = run_deck_text(replaced(bent(''), 'plots = .false.', 'plots = .true.'))
      call assertTrue(index(content(results_path//'/report.html'), '<td>0.0</td>') == 0)
   end subroutine test_page

   !> A deck with a static case gets no advice to use one.
   subroutine test_sag()
      character(*), parameter :: advice = "Surveys are taken at rest: use 'static'"
      character(:), allocatable :: deck_text
      type(run_type) :: run
      deck_text = replaced(bent(''), "kind = 'hwdp',", "kind = 'hwdp', sensor = 5,")
      run = run_deck_text(deck_text)
      call assertTrue(index(run%output, advice) > 0, message=run%output)
      run = run_deck_text(deck_text//"&load_case name = 'rest', operation = 'static', bit_depth = 600 /"//newline)
      call assertTrue(index(run%output, 'Sag correction in ') > 0, message=run%output)
      call assertEqual(0, index(run%output, advice))
   end subroutine test_sag
end module dg_test_bent_runs
