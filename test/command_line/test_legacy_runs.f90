!> The group &legacy from file to words: every form of table reads alike; every fault has its file, line and remedy.
module dg_test_legacy_runs
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_program_run, only: content, deck_path, good_deck, replaced, results_path, run_deck_text, run_program, run_type, scratch, &
                             unwrapped
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: legacy_runs_suite

   character(*), parameter :: newline = achar(10), tab = achar(9)
   !> Outside the scratch folder, which every run empties.
   character(*), parameter :: table_path = 'build/test_legacy_table.txt'
   character(*), parameter :: group = "&legacy label = 'x', file = '../test_legacy_table.txt', case = 'u'"

contains

   function legacy_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('legacy_runs')
      call suite%addTest(TestMethod('noisy_survey', test_noisy_survey))
      call suite%addTest(TestMethod('shipped_example_locates_the_error', test_example))
      call suite%addTest(TestMethod('every_form_of_table', test_forms))
      call suite%addTest(TestMethod('rows_that_are_skipped', test_skipped))
      call suite%addTest(TestMethod('hook_loads_over_depth', test_hookloads))
      call suite%addTest(TestMethod('own_profile', test_own_profile))
      call suite%addTest(TestMethod('bad_tables', test_bad_tables))
      call suite%addTest(TestMethod('bad_groups', test_bad_groups))
      call suite%addTest(TestMethod('advice_followed', test_followed))
      call suite%addTest(TestMethod('loads_on_the_bit', test_loads))
      call suite%addTest(TestMethod('case_without_solution', test_unsolved))
   end function legacy_runs_suite

   !> Writes a table, lines parted by |, and runs the good deck with a group that names it; the group stands in line 21.
   function run_with(table, keys, deck) result(run)
      character(*), intent(in) :: table
      character(*), intent(in) :: keys
      character(*), intent(in), optional :: deck     !< in place of the good deck
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      integer :: first, length
      allocate (lines(0))
      first = 1
      do while (first <= len(table))
         length = index(table(first:)//'|', '|') - 1
         call append_text(lines, table(first:first + length - 1))
         first = first + length + 1
      end do
      call write_text_file(table_path, lines, error)
      call assertFalse(allocated(error), message='table')
      if (present(deck)) then
         run = run_deck_text(deck//group//keys//' /'//newline)
      else
         run = run_deck_text(good_deck()//group//keys//' /'//newline)
      end if
   end function run_with

   !> The program's own profile, which has two rows where side force jumps, agrees with itself on both sides.
   subroutine test_own_profile()
      type(run_type) :: run
      character(:), allocatable :: table
      integer :: i
      run = run_with('md,axial|0,150|900,0', '')
      allocate (table, source=content(results_path//'/profile_u_soft.csv'))
      call assertTrue(index(table, ',above') > 0, message='two rows at a depth')
      do i = 1, len(table)
         if (table(i:i) == newline) table(i:i) = '|'
      end do
      run = run_with(table, ", md = 'md_m', axial = 'axial_kN', side_force = 'side_force_kN_m'")
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Both agree within 0.1 % of the largest side force') > 0, message=run%output)
   end subroutine test_own_profile

   !> Rows behind a mark of comments are counted in a note.
   subroutine test_skipped()
      type(run_type) :: run
      run = run_with('md,axial|0,300|# remark|#200,280|900,0', '')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(unwrapped(run%output), &
                            'test_legacy_table.txt: rows skipped: 1 that begin with # (first in line 4)') > 0, message=run%output)
      run = run_with('0     300|#  200280|900     0', ", md = '1:6', axial = '7:9'")
      call assertTrue(index(unwrapped(run%output), 'rows skipped: 1 that begin with # (first in line 2)') > 0, message=run%output)
   end subroutine test_skipped

   !> A survey that scatters has dozens of intervals: those with the largest changes are listed, the others in one line.
   subroutine test_noisy_survey()
      type(run_type) :: run
      character(:), allocatable :: stations, deck
      character(3) :: number
      integer :: i
      deck = replaced(good_deck(), '0.0, 500.0, 900.0', '0.0')
      stations = '0.0'
      do i = 1, 30
         write (number, '(i0)') 30*i
         deck = replaced(deck, newline//'  inc = 0.0', ', '//trim(number)//newline//'  inc = 0.0')
         stations = stations//merge(', 20.0', ', 21.0', modulo(i, 2) == 0)
      end do
      deck = replaced(replaced(deck, '0.0, 0.0, 30.0', stations), '3*10.0', '31*10.0')
      run = run_with('md,axial|0,200|450,90|900,0', '', deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, newline//'  21 other intervals together: ') > 0, message=run%output)
   end subroutine test_noisy_survey

   !> Hook loads at several bit depths are no forces along one string: a note says so, and what to give in their place.
   subroutine test_hookloads()
      type(run_type) :: run
      character(*), parameter :: advice = 'reference_hookload, one load case per depth'
      run = run_with('md,axial|300,100|600,170|900,240', '')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, advice) > 0, message=run%output)
      run = run_with('md,axial|0,150|900,0', '')
      call assertEqual(0, index(run%output, advice), message='forces along the string')
      run = run_with('MD,Axial (kN),Side Force (kN/m)|0,150,0.1|900,0,0.1', '')
      call assertTrue(index(run%output, 'Difference in side force') > 0, message='a heading of two words: '//run%output)
      run = run_deck_text(replaced(good_deck(), 'bit_depth = 900.0 /', 'bit_depth = 900.0, reference_hookload = 240 /'))
      call assertTrue(index(run%output, '240.0') > 0, message='as the note says: '//run%output)
   end subroutine test_hookloads

   !> The wrong sign of curvature makes its error in the build section alone, in all three operations.
   subroutine test_example()
      type(run_type) :: run
      integer :: at, found
      run = run_program('input/johancsik_well_3.nml --output '//results_path)
      call assertEqual(0, run%status)
      found = 0
      at = 1
      do while (index(run%output(at:), 'arises in the build section, 2399.93 ft to 4199.48 ft.') > 0)
         at = at + index(run%output(at:), 'arises in the build section')
         found = found + 1
      end do
      call assertEqual(12, found, message='three cases, four models')
      call assertTrue(index(run%output, 'The tables differ above 4200 ft. 100 % of the net difference in axial force arises') > 0)
      call assertTrue(index(run%output, 'largest +10.658 klbf (3.24 % of the largest)') > 0, message='48 kN up')
   end subroutine test_example

   !> 150 kN at surface falling to 0 at 900 m: the same table in every form gives the same words.
   subroutine test_forms()
      type(run_type) :: run
      character(:), allocatable :: words
      run = run_with('md,axial,note|0,150,a|450,75,b|900,0,c', '')
      call assertEqual(0, run%status, message=run%diagnostics)
      words = told(run)
      call assertGreaterThan(len(words), 0, message='words')
      call same('semicolons, decimal comma', 'axial;md|150,0;0,0|75,0;450|0;900', '')
      call same('tabs', '# printed by X|MD (m)'//tab//'Axial [kN]|0'//tab//'150||450'//tab//'75|900'//tab//'0', '')
      call same('blanks and headings', 'md   tension|  0   150|450   75|900     0', ", axial = 'tension'")
      call same('numbers of columns, no header', '1 0 150|2 450 75|3 900 0', ", md = '2', axial = '3'")
      call same('fixed', 'report|  md axial|   0 150.0| 450 75| 900   0.0', ", md = '1:4', axial = '5:10', skip = 2")
      call same('newtons', 'md,axial_N|0,150000|450,75000|900,0', ", axial_unit = 'N'")
      call same('a row of units', 'md,axial|m,[kN]|0,150|450,75|900,0', '')
      call same('tonnes', 'md,axial [t]|0,15.29574319|450,7.647871597|900,0', ", axial_unit = 't'")
      call same('decanewtons', 'MD (m),axial (daN)|0,15000|450,7500|900,0', ", axial_unit = 'daN'")
      call same('a unit that only the deck knows', 'md,axial (as printed)|0,150|450,75|900,0', ", axial_unit = 'kN'")
      call same('field units', 'md_ft,axial_klbf|0,33.7213414706957|1476.37795275591,16.8606707353478|2952.75590551181,0', &
                ", units = 'field'")
   contains
      subroutine same(what, table, keys)
         character(*), intent(in) :: what, table, keys
         run = run_with(table, keys)
         call assertEqual(0, run%status, message=what//': '//run%diagnostics)
         call assertEqual(words, told(run), message=what)
      end subroutine same
   end subroutine test_forms

   !> The line that tells the largest difference.
   function told(run) result(words)
      type(run_type), intent(in) :: run
      character(:), allocatable :: words
      integer :: at
      at = index(run%output, 'Difference in')
      words = ''
      if (at > 0) words = run%output(at:at + index(run%output(at:), newline) - 2)
   end function told

   subroutine refuse(table, keys, place, expected)
      character(*), intent(in) :: table, keys, place, expected
      type(run_type) :: run
      run = run_with(table, keys)
      call assertEqual(2, run%status, message='status of: '//expected)
      call assertTrue(index(run%diagnostics, place//' ') > 0 .and. index(run%diagnostics, expected) > 0, &
                      message='wanted '//place//' '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse

   subroutine test_bad_tables()
      character(*), parameter :: file = '/../test_legacy_table.txt:'
      call refuse('md,axial|0,150|450|900,0', '', file//'3:', 'the row has 1 columns, the table 2')
      call refuse('md,axial|0,150|450,75,3|900,0', '', file//'3:', 'the row has 3 columns, the table 2')
      call refuse('md,tension|0,150|900,0', ", axial = 'tensoin'", file//'1:', "did you mean 'tension'?")
      call refuse('depth,axial|0,150|900,0', '', file//'1:', "the header names no 'md' for md")
      call refuse('report|md,axial|0,150|900,0', '', file//'1:', 'headings found: report. Write md = the heading, '// &
                  'or skip = the number of lines above the headings. If headings have blanks, skip them too and give')
      call refuse('md,pull|0,150|900,0', '', file, 'no column axial, torque or side_force')
      call refuse('md (m),axial (klbf)|0,150|900,0', '', file//'1:', 'the header gives axial in klbf')
      call refuse('md_ft,axial|0,150|900,0', '', file//'1:', 'the header gives md in ft')
      call refuse('md,axial (furlong)|0,150|900,0', '', file//'1:', "axial in 'furlong', which is unknown; set axial_unit")
      call refuse('md (ft),axial|0,150|900,0', ", md = '1'", file//'1:', 'the header gives md in ft')
      call refuse('md,axial|0,150|900,0|450,75', '', file//'4:', 'md = 450 is not below md = 900 of line 3')
      call refuse('md,axial|0,150|450,75|450,50|450,0', '', file//'5:', 'depths must increase')
      call refuse('md,axial|0,150|450,abc', '', file//'3:', "axial = 'abc' is not a number")
      call refuse('md;axial|0;150.5|1,000;75|2,000;0', '', file//'3:', "'1,000' may have a decimal comma or one between thousands")
      call refuse('md;axial|0;150|12,34.5;75|2000;0', '', file//'3:', "md = '12,34.5' is not a number")
      call refuse('md,axial|0,150', '', file, 'it has 1 rows of numbers')
      call refuse('', '', file, 'it has 0 rows of numbers')
      call refuse('md,axial,axial|0,150,1|900,0,1', '', file//'1:', "the header names 'axial' twice; give axial as the "// &
                  'number of its column')
      call refuse('0 150|900 0', ", md = '1', axial = '3'", file//'1:', 'axial is to be column 3; the table has 2')
      call refuse('   0 150|900', ", md = '1:4', axial = '5:8'", file//'2:', 'the row ends at character 3')
   end subroutine test_bad_tables

   !> Advice is followed, and the message is gone.
   subroutine test_followed()
      character(*), parameter :: good = 'md,axial|0,150|900,0'
      call follow("   0 150.0| 900   0.0", ", md = '1:4', axial = 'axial'", "give all as 'first:last'", "   0 150.0| 900   0.0", &
                  ", md = '1:4', axial = '5:10'")
      call follow(good, ", axial = ''", "give a heading, a number, or characters 'first:last'", &
                  good, ", axial = 'axial'")
      call follow(good, ", axial = ''", "give a heading, a number, or characters 'first:last'", &
                  good, ", axial = '2'")
      call follow("   0 150.0| 900   0.0", ", md = '1:4', axial = '5:4'", "as in '11:20'", "   0 150.0| 900   0.0", &
                  ", md = '1:4', axial = '5:10'")
      call follow(good, ", axial = '0'", "the first is 1", good, ", axial = '2'")
      call follow("md,pull|0,150|900,0", "", "name at least one of its columns", "md,pull|0,150|900,0", ", axial = 'pull'")
      call follow("md,axial|0,150", "", "two or more make a table", good, "")
      call follow("md,axial|0,150|900,0|450,75", "", "depths must increase", "md,axial|0,150|450,75|900,0", "")
      call follow("md,axial,axial|0,150,1|900,0,1", "", "give axial as the number of its column", &
                  "md,axial,axial|0,150,1|900,0,1", ", axial = '2'")
      call follow("report|md,axial|0,150|900,0", "", "or skip = the number of lines above the headings", &
                  "report|md,axial|0,150|900,0", ", skip = 1")
      call follow("Depth  Pull now|0 150|900 0", ", md = 'Depth', axial = 'Pull now'", "give the number of the column", &
                  "Depth  Pull now|0 150|900 0", ", md = '1', axial = '2', skip = 1")
      call follow("md,axial (furlong)|0,150|900,0", "", "set axial_unit in the deck", "md,axial (furlong)|0,150|900,0", &
                  ", axial_unit = 'kN'")
      call follow("md (m),axial (klbf)|0,30|900,0", "", "set axial_unit, or units, in the deck", "md (m),axial (klbf)|0,30|900,0", &
                  ", axial_unit = 'klbf'")
      call follow("md_ft,axial_klbf|0,30|2950,0", "", "set axial_unit, or units, in the deck", "md_ft,axial_klbf|0,30|2950,0", &
                  ", units = 'field'")
      call follow("md,axial|0,150000|900,0", "", "check the unit of the column (axial_unit)", "md,axial|0,150000|900,0", &
                  ", axial_unit = 'N'")
      call follow(good, " / &legacy label = 'a/b', file = '../test_legacy_table.txt', case = 'u'", &
                  "use 1 to 100 letters, digits and _ - . +", good, &
                  " / &legacy label = 'a-b', file = '../test_legacy_table.txt', case = 'u'")
      call follow("md,axial|0,15|900,0", ", axial_unit = 'tons'", "legal: N, daN, kN, kdaN, t,", "md,axial|0,15|900,0", &
                  ", axial_unit = 't'")
   contains
      subroutine follow(table, keys, expected, new_table, new_keys)
         character(*), intent(in) :: table, keys, expected, new_table, new_keys
         type(run_type) :: run
         run = run_with(table, keys)
         call assertTrue(index(run%output//run%diagnostics, expected) > 0, &
                         message='wanted: '//expected//'; got: '//run%output//run%diagnostics)
         run = run_with(new_table, new_keys)
         call assertEqual(0, run%status, message='followed: '//expected//'; got: '//run%diagnostics)
         call assertEqual(0, index(run%output//run%diagnostics, expected), message='followed: '//run%output)
      end subroutine follow
   end subroutine test_followed

   !> A case without solution is not compared, and the output says so; once it has one it is.
   subroutine test_unsolved()
      character(*), parameter :: table = 'md,axial|0,150|900,0'
      character(*), parameter :: told = 'Legacy x is not compared: case u, model mcge, has no solution (not_converged).'
      type(run_type) :: run
      character(:), allocatable :: deck
      deck = replaced(good_deck(), "'soft'", "'mcge'")
      run = run_with(table, '', replaced(deck, '= 10.0 /', '= 10.0, max_iterations = 1 /'))
      call assertEqual(3, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, told) > 0, message=run%output)
      run = run_with(table, '', deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, told), message=run%output)
      call assertTrue(index(run%output, 'Legacy x compared with case u, model mcge') > 0, message=run%output)
   end subroutine test_unsolved

   !> A difference at the bit is gone with the load on the bit of the other program.
   subroutine test_loads()
      character(*), parameter :: table = 'md,axial|0,250|900,-100', advice = 'at the lowest depth: compare the loads on the bit.'
      type(run_type) :: run
      run = run_with(table, '')
      call assertTrue(index(run%output, advice) > 0, message=run%output)
      run = run_with(table, '', replaced(good_deck(), 'bit_depth = 900.0', 'bit_depth = 900.0, wob = 100'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(run%output, advice), message=run%output)
   end subroutine test_loads

   subroutine test_bad_groups()
      character(*), parameter :: good = 'md,axial|0,150|900,0', line = deck_path//':21:'
      call refuse(good, ", axial_unit = 'tons'", line, "axial_unit = 'tons' is unknown; legal: N, daN, kN, kdaN, t, lbf, klbf, kip")
      call refuse(good, ", axial = '5:4'", line, "axial = '5:4' is not a range of characters")
      call refuse(good, ", md = '1:4', axial = 'axial'", line, 'other columns are characters')
      call refuse(good, ", axial = '0'", line, 'axial = 0 is not a column')
      call refuse(good, ", axil = '2'", line, "did you mean 'axial'?")
      call refuse(good, " / &legacy label = 'X', file = '../test_legacy_table.txt', case = 'u'", line, 'labels must be unique')
      call refuse(good, " / &legacy label = 'y', file = '../test_legacy_table.txt', case = 'v'", line, "no load case 'v'")
      call refuse(good, " / &legacy label = 'a/b', file = '../test_legacy_table.txt', case = 'u'", line, &
                  'cannot be part of a file name')
      call refuse(good, " / &legacy label = 'y', file = 'nowhere.csv', case = 'u'", line//' group &legacy: file: '//scratch// &
                  '/nowhere.csv:', 'legacy file cannot be opened')
      call refuse(good, " / &legacy label = 'y', case = 'u'", line, 'key file is missing')
   end subroutine test_bad_groups
end module dg_test_legacy_runs
