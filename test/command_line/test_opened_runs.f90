!> Tools that open below casing, as decks have them: what is refused, that advice helps, and a sweep that opens one on its way.
module dg_test_opened_runs
   use funit, only: anyExceptions, assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_kinds, only: wp
   use dg_program_run, only: deck_path, replaced, results_path, run_deck_text, run_program, run_type, scratch
   use dg_result_rows, only: field, lines_of, number
   use dg_text, only: append_text, text_list, text_type, to_text
   implicit none
   private
   public :: opened_runs_suite

   character(*), parameter :: newline = achar(10)
   !> The lines of the deck that have the diameters of the reamer, and a place for what is put behind them.
   integer, parameter :: line_of_reamer = 9
   character(*), parameter :: tool = 'joint_od = 213.0, opened_od = 250.0'

contains

   function opened_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('opened_runs')
      call suite%addTest(TestMethod('refused', test_refused))
      call suite%addTest(TestMethod('advice', test_advice))
      call suite%addTest(TestMethod('echo_and_note', test_echo))
      call suite%addTest(TestMethod('convert', test_convert))
      call suite%addTest(TestMethod('catalogue', test_catalogue))
      call suite%addTest(TestMethod('sweep_opens_on_its_way', test_sweep))
   end function opened_runs_suite

   !> A reamer 60 m above the bit that opens below the shoe at 700 m, and two load cases: open, and still in the casing.
   function deck() result(text)
      character(:), allocatable :: text
      text = "&job models = 'mcge', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             "&trajectory md = 0.0, 600.0, 1200.0, inc = 0.0, 0.0, 40.0, azi = 3*10.0 /"//newline// &
             "&hole md_bottom = 700.0, diameter = 220.5, friction = 0.2, cased = .true. /"//newline// &
             "&hole md_bottom = 1150.0, diameter = 250.8, friction = 0.3 /"//newline// &
             "&hole md_bottom = 1200.0, diameter = 215.9, friction = 0.3 /"//newline// &
             "&fluid density = 1200.0 /"//newline// &
             "&component name = 'collars', kind = 'collar', length = 60.0, od = 171.45, id = 71.4 /"//newline// &
             "&component name = 'reamer', kind = 'stabilizer', length = 1.2, od = 190.0, id = 71.4"//newline// &
             "  "//tool//" /"//newline// &
             "&component od = 127.0, id = 108.6, joint_od = 168.3 /"//newline// &
             "&load_case name = 'deep', operation = 'up', bit_depth = 1200.0 /"//newline// &
             "&load_case name = 'shallow', operation = 'up', bit_depth = 600.0 /"//newline
   end function deck

   !> The deck with `old` changed to `new` is refused with a message about its reamer that holds `expected`.
   subroutine refuse(old, new, expected, messages)
      character(*), intent(in) :: old, new, expected
      integer, intent(in), optional :: messages      !< one a hole section that it does not pass; absent: 1
      integer :: wanted
      type(run_type) :: run
      run = run_deck_text(replaced(deck(), old, new))
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, deck_path//':'//to_text(line_of_reamer)//': group &component: ') == 1, &
                      message='line of '//run%diagnostics)
      call assertTrue(index(run%diagnostics, expected) > 0, message='wanted '//expected//'; got '//run%diagnostics)
      wanted = 1
      if (present(messages)) wanted = messages
      call assertEqual(wanted, lines_in(run%diagnostics), message='messages: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse

   pure function lines_in(text) result(lines)
      character(*), intent(in) :: text
      integer :: lines, i
      lines = count([(text(i:i) == newline, i=1, len(text))])
   end function lines_in

   subroutine test_refused()
      type(run_type) :: run
      run = run_deck_text(deck())
      call assertEqual(0, run%status, message=run%diagnostics)
      call refuse('opened_od = 250.0', 'opened_od = 213.0', &
                  'opened_od = 213 is not greater than the closed diameter, 213 (the larger of od and joint_od)')
      call refuse('opened_od = 250.0', 'opened_below = 800.0', 'opened_below = 800 has no meaning without opened_od')
      call refuse('cased = .true.', 'cased = .false.', "'reamer' has opened_od and no depth from which on it is open; give "// &
                  'opened_below, or cased = .true.')
      call refuse('opened_od = 250.0', 'opened_od = 251.0', "'reamer' opened to 251 mm does not pass the hole of 250.8 mm "// &
                  "(line 4) in case 'deep'; needs opened_od <= 250.8 mm"//newline)
      call refuse('length = 60.0', 'length = 40.0', "'reamer' opened to 250 mm does not pass the hole of 215.9 mm (line 5) "// &
                  "in case 'deep'; it stands at 1158.8 m to 1160 m, the section above ends at 1150 m; lower md_bottom of that "// &
                  'section to 1160 m, or check opened_od'//newline)
      call refuse(tool, tool//', opened_below = 600', "'reamer' opened to 250 mm does not pass the hole of 220.5 mm (line 3) "// &
                  "in case 'deep'; needs opened_od <= 220.5 mm or opened_below >= 700 m"//newline)
      call refuse('joint_od = 213.0', 'joint_od = 220.5', "'reamer' with 220.5 mm does not pass the hole of 220.5 mm (line 3) "// &
                  "in case 'deep'; needs a diameter < 220.5 mm"//newline)
      call refuse('opened_od = 250.0', 'opened_od = -1', 'opened_od = -1 is out of range')
      call refuse('opened_od = 250.0', "opened_od = 'x'", "opened_od = 'x' is not a number")
      run = run_deck_text(deck()//"&centralizer component = 'reamer', od = 219.0, spacing = 1.0, first = 0.5 /"//newline)
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, "'reamer' has opened_od; a tool that opens carries no centralizers") > 0, &
                      message=run%diagnostics)
      run = run_deck_text(replaced(replaced(deck(), 'length = 60.0', 'length = 40.0'), 'md_bottom = 1150.0', 'md_bottom = 1160'))
      call assertEqual(0, run%status, message=run%diagnostics)
      ! with round-off of the depth of its lower end
      run = run_deck_text(replaced(replaced(replaced(deck(), 'length = 60.0', 'length = 30.1'), 'md_bottom = 1150.0', &
         'md_bottom = 1160.6'), 'bit_depth = 1200.0', 'bit_depth = 1190.7'))
      call assertEqual(0, run%status, message=run%diagnostics)
      ! as wide as its hole: an under-reamer cuts it
      run = run_deck_text(replaced(deck(), 'opened_od = 250.0', 'opened_od = 250.8'))
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_refused

   !> A tool given with its open diameter alone does not pass; what the message advises makes the deck run, as it should.
   subroutine test_advice()
      real(wp) :: wanted
      type(run_type) :: run
      run = run_deck_text(deck())
      wanted = hookload()
      call refuse(tool, 'joint_od = 250.0', "'reamer' with 250 mm does not pass the hole of 220.5 mm (line 3) in case 'deep'; "// &
                  'needs a diameter < 220.5 mm. If it is a tool that opens, give its closed diameter as joint_od, '// &
                  'opened_od = 250 mm and opened_below = 700 m'//newline)
      run = run_deck_text(replaced(deck(), tool, 'joint_od = 213.0, opened_od = 250, opened_below = 700'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(wanted, hookload())
      ! wider than its own hole too: it is no tool that opens
      call refuse(tool, 'joint_od = 260.0', 'needs a diameter < 220.5 mm'//newline, messages=2)
   end subroutine test_advice

   !> Hook load of the first case [kN].
   function hookload() result(load)
      real(wp) :: load
      type(text_type), allocatable :: lines(:)
      allocate (lines(0))
      lines = lines_of(results_path//'/summary.csv')
      load = number(lines(2)%text, 8)
   end function hookload

   subroutine test_echo()
      type(run_type) :: run
      character(*), parameter :: noted = "'reamer' counts as closed everywhere: a tool opens where its whole length is below "// &
                                         'opened_below = '
      run = run_deck_text(deck(), '--check')
      call assertTrue(index(run%output, ', opens to 250 mm below 700 m') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'note '), message=run%output)
      run = run_deck_text(replaced(deck(), tool, tool//', opened_below = 1150'), '--check')
      call assertTrue(index(run%output, noted//'1150 m, and its upper end comes to 1138.8 m') > 0, message=run%output)
      run = run_deck_text(replaced(deck(), 'bit_depth = 1200.0', 'bit_depth = 400.0')// &
                          "&sweep operations = 'up', bit_depth_to = 600 /"//newline, '--check')
      call assertTrue(index(run%output, noted//'700 m, and its upper end comes to 538.8 m') > 0, message=run%output)
      run = run_deck_text(replaced(deck(), 'bit_depth = 1200.0', 'bit_depth = 400.0')// &
                          "&sweep operations = 'up', bit_depth_to = 1200 /"//newline, '--check')
      call assertEqual(0, index(run%output, noted), message='the sweep opens it: '//run%output)
   end subroutine test_echo

   subroutine test_convert()
      type(run_type) :: run
      type(text_type) :: whole(1)
      type(error_type), allocatable :: error
      real(wp) :: before
      real(wp), parameter :: kilopound = 4.4482216152605_wp      ! kN
      run = run_deck_text(replaced(deck(), tool, tool//', opened_below = 750'))
      before = hookload()
      run = run_program('--convert '//deck_path)
      call assertTrue(index(run%output, 'opened_od = 9.84252, opened_below = 2460.63') > 0, message=run%output)
      whole(1)%text = run%output
      call write_text_file(deck_path, whole, error)
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertRelativelyEqual(before, hookload()*kilopound, 1.0e-6_wp)
   end subroutine test_convert

   !> A catalogue may say to what a tool opens; at which depth is a matter of the deck.
   subroutine test_catalogue()
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      run = run_deck_text(deck())
      call append_text(lines, 'name,kind,od_mm,id_mm,joint_od_mm,opened_od_mm')
      call append_text(lines, 'UR 213-250,stabilizer,190.0,71.4,213.0,250.0')
      call write_text_file(scratch//'/tools.csv', lines, error)
      lines = text_list(replaced(replaced(deck(), "&job", "&job catalogue_file = 'tools.csv', "), &
                                 "kind = 'stabilizer', length = 1.2, od = 190.0, id = 71.4"//newline//'  '//tool, &
                                 "length = 1.2, catalogue = 'UR 213-250'"))
      call write_text_file(deck_path, lines, error)
      run = run_program(deck_path//' --check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'opens to 250 mm below 700 m') > 0, message=run%output)
   end subroutine test_catalogue

   !> Points of a sweep across the shoe are the load cases at their depths, to the digit.
   subroutine test_sweep()
      type(run_type) :: run
      type(text_type), allocatable :: sweep(:), summary(:)
      character(:), allocatable :: text
      integer :: i, j, found
      text = deck()
      do i = 700, 1100, 100
         text = text//"&load_case name = 'at_"//to_text(i)//"', operation = 'up', bit_depth = "//to_text(i)//' /'//newline
      end do
      run = run_deck_text(text//"&sweep name = 'b', operations = 'up', bit_depth_from = 600, bit_depth_step = 100 /"//newline// &
                          "&solver fidelity = 'fast' /"//newline)      ! no short elements, as in the points of a sweep
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (sweep(0), summary(0))
      sweep = lines_of(results_path//'/sweep_b.csv')
      if (anyExceptions()) return
      summary = lines_of(results_path//'/summary.csv')
      if (anyExceptions()) return
      call assertEqual(1 + 7, size(sweep))
      found = 0
      do i = 2, size(summary)
         do j = 2, size(sweep)
            ! summary: bit depth 5, hook load 8; sweep: 4, 5
            if (field(summary(i)%text, 5) /= field(sweep(j)%text, 4)) cycle
            found = found + 1
            call assertEqual(field(summary(i)%text, 8), field(sweep(j)%text, 5))
         end do
      end do
      call assertEqual(7, found)
   end subroutine test_sweep
end module dg_test_opened_runs
