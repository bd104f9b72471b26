!> Actions of the program beside solving: a deck to start from, the catalogue, and decks that take pipe from it.
module dg_test_actions
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_kinds, only: wp
   use dg_program_run, only: clear_scratch, content, deck_path, good_deck, program_path, replaced, results_path, run_deck_text, &
                             run_program, run_type, scratch
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: actions_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: pipe = "&component od = 127.0, id = 108.6"//newline//"  joint_od = 168.3 /"

contains

   function actions_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('actions')
      call suite%addTest(TestMethod('template', test_template))
      call suite%addTest(TestMethod('template_in_field_units', test_field_template))
      call suite%addTest(TestMethod('list_catalogue', test_list))
      call suite%addTest(TestMethod('pipe_of_the_catalogue', test_catalogue))
      call suite%addTest(TestMethod('catalogue_within', test_within))
      call suite%addTest(TestMethod('catalogue_faults', test_catalogue_faults))
      call suite%addTest(TestMethod('catalogue_advice_followed', test_catalogue_followed))
      call suite%addTest(TestMethod('convert', test_convert))
      call suite%addTest(TestMethod('metric_template', test_metric_template))
      call suite%addTest(TestMethod('convert_to_metric', test_convert_metric))
      call suite%addTest(TestMethod('convert_comments', test_convert_comments))
      call suite%addTest(TestMethod('convert_what_is_not_said', test_convert_unsaid))
   end function actions_suite

   !> The template runs as it stands, and with every comment that names a default taken in.
   subroutine test_template()
      type(run_type) :: run
      integer :: status
      call clear_scratch()
      run = run_program('--template')
      call assertEqual(0, run%status)
      call assertTrue(index(run%output, '! &solver: ') > 0, message=run%output)
      call execute_command_line('cp '//scratch//'/output.txt '//scratch//'/template.nml', exitstat=status)
      run = run_program(scratch//'/template.nml --quiet --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'My well') > 0, message=run%output)
      ! "! key = value  ! ..." becomes "key = value ! ..."; groups that are comments stay so
      call execute_command_line("sed -E 's/^! ([a-z_]+ = [^ ].*)$/\1/; /^! &/,/^! \//s/^([a-z_]+ = )/! \1/' "//scratch// &
                                '/template.nml > '//scratch//'/whole.nml', exitstat=status)
      run = run_program(scratch//'/whole.nml --check')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program('--template deck.nml')
      call assertEqual(2, run%status)
   end subroutine test_template

   !> The template in field units runs, with field numbers in its values, defaults and ranges.
   subroutine test_field_template()
      type(run_type) :: run
      integer :: status
      call clear_scratch()
      run = run_program('--template field')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, "units = 'field'") > 0, message=run%output)
      call assertTrue(index(run%output, 'density = 65.51142') > 0, message='default of steel in lbm/gal')
      call assertTrue(index(run%output, '[0 to 164040 ft]') > 0, message='range of a depth')
      call assertEqual(0, index(run%output, ' kN]'), message='no range in kN')
      call execute_command_line('cp '//scratch//'/output.txt '//scratch//'/template.nml', exitstat=status)
      run = run_program(scratch//'/template.nml --check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'od 5 in') > 0, message=run%output)
      call assertEqual(0, index(run%output, newline//'note'), message=run%output)
      run = run_program(scratch//'/template.nml --quiet --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call execute_command_line("sed -E 's/^! ([a-z_]+ = [^ ].*)$/\1/; /^! &/,/^! \//s/^([a-z_]+ = )/! \1/' "//scratch// &
                                '/template.nml > '//scratch//'/whole.nml', exitstat=status)
      run = run_program(scratch//'/whole.nml --check')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program('--template metres')
      call assertEqual(2, run%status)
   end subroutine test_field_template

   subroutine test_list()
      type(run_type) :: run
      call clear_scratch()
      run = run_program("--list-catalogue 'csg 9-5/8'")
      call assertTrue(index(run%output, "A grade behind the name of pipe gives its yield: 'CSG 5-1/2 23.00 P110'") > 0, &
                      message=run%output)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'CSG 9-5/8 47.00                       casing') > 0, message=run%output)
      call assertTrue(index(run%output, '   244.5   220.5   69.94    269.9') > 0, message=run%output)
      call assertTrue(index(run%output, '   9.625   8.681   47.00   10.625') > 0, message=run%output)
      call assertFalse(index(run%output, 'DP 5') > 0, message=run%output)
      run = run_program('--list-catalogue S135')
      call assertTrue(index(run%output, newline//'S135                                  grade ') > 0, message=run%output)
      call assertTrue(index(run%output, newline//'A grade stands behind the name of a pipe: ') > 0, message=run%output)
      run = run_program("--list-catalogue 'dp 5 19.50 nc50 s135'")
      call assertTrue(index(run%output, newline//'DP 5 19.50 NC50 S135                  drillpipe         127.') > 0, &
                      message=run%output)
      call assertTrue(index(run%output, '   931.') > 0, message=run%output)
      call assertEqual(0, index(run%output, ' grade '), message=run%output)
      run = run_program('--list-catalogue nothing_like_this')
      call assertEqual(2, run%status)
      run = run_program('--list-catalogue', environment='DRILLGAP_CATALOGUE=/nonexistent/pipes.csv')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, '/nonexistent/pipes.csv: catalogue cannot be opened') > 0, message=run%diagnostics)
   end subroutine test_list

   !> A component takes from the catalogue what it does not give itself.
   subroutine test_catalogue()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), pipe, "&component catalogue = 'dp 5 19.50 NC50 S135' /"), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'dp 5 19.50 NC50 S135 (drillpipe): to surface, od 127 mm, id 108.6104 mm, 31.05798 kg/m') &
                      > 0, message=run%output)
      call assertTrue(index(run%output, 'joints 168.275 mm') > 0, message=run%output)
      run = run_deck_text(replaced(good_deck(), pipe, "&component catalogue = 'DP 5 19.50 NC50', mass = 33.0, name = 'mine' /"), &
                          '--check')
      call assertTrue(index(run%output, 'mine (drillpipe): to surface, od 127 mm, id 108.6104 mm, 33 kg/m') > 0, message=run%output)
   end subroutine test_catalogue

   !> A program that is run where there is no catalogue has one with it; pipe with its tool joint knows their torque.
   subroutine test_within()
      type(run_type) :: run
      integer :: status
      call clear_scratch()
      call execute_command_line("p=$(realpath '"//program_path()//"'); cd "//scratch//' && "$p" --list-catalogue 6-5/8x2-3/4 > '// &
                                'list.txt', exitstat=status)
      call assertEqual(0, status)
      call assertTrue(index(content(scratch//'/list.txt'), 'DP 5 19.50 NC50 6-5/8x2-3/4') > 0)
      run = run_deck_text(replaced(good_deck(), pipe, "&component catalogue = 'DP 5 19.50 NC50 6-5/8x2-3/4 S135' /"), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, ', make-up 51.58') > 0, message=run%output)
      call assertTrue(index(run%output, ', connection 85.96') > 0, message=run%output)
   end subroutine test_within

   subroutine test_catalogue_faults()
      type(run_type) :: run
      call refuse("catalogue = 'DP 5 19.50 NC5'", "input/catalogue.csv has no 'DP 5 19.50 NC5'; did you mean 'DP 5 19.50 NC50'?")
      call refuse("catalogue = 'DP 5 19.5 NC50 S-135'", "did you mean 'DP 5 19.50 NC50 S135'?")
      call refuse("catalogue = 'DP 5 19.50 NC50 S153'", "did you mean 'DP 5 19.50 NC50 S135'?")
      call refuse("catalogue = 'DP 5 19.50 NC50 V150'", "leave out 'V150'. For a grade that the catalogue does not have give yield")
      call refuse("catalogue = 'something else altogether'", '--list-catalogue lists what it has')
      ! by kind, size, weight and grade, then by connection: never heavy weight pipe for drill pipe
      call refuse("catalogue = 'DP 5 19.5 S-135'", "has no 'DP 5 19.5 S-135'; did you mean 'DP 5 19.50 NC50 S135', 'DP 5 19.50 "// &
                  "5-1/2 FH S135', 'DP 5 19.50 NC50 6-3/8x3-3/4 S135',")
      call refuse("catalogue = 'HWDP 5 49.30 NC50'", "did you mean 'HWDP 5 49.3'?")
      call refuse("catalogue = 'casing 9 5/8 47#'", "did you mean 'CSG 9-5/8 47.00'?")
      call refuse("catalogue = 'drillpipe 5-1/2 21.9 FH S135'", "did you mean 'DP 5-1/2 21.90 FH S135'?")
      call refuse("catalogue = '5"" 49.3#'", "did you mean 'HWDP 5 49.3'?")
      call refuse("catalogue = 'DP 7 20'", '--list-catalogue dp lists what it has')
      call refuse("catalogue = 'S135'", "input/catalogue.csv has no 'S135'")
      call refuse("catalogue = 'DP 5 19.50 NC50', od = 'x'", "od = 'x' is not a number")
      call refuse("name = 'pipe'", 'key od is missing')
      call execute_command_line("printf 'name,kind,mass_kg_m\nbare,drillpipe,30\n' > build/test_bare.csv")
      run = run_deck_text(replaced(replaced(good_deck(), pipe, "&component catalogue = 'bare' /"), '&job ', &
                                   "&job catalogue_file = '../test_bare.csv', "), '--check')
      call assertTrue(index(run%diagnostics, "group &component: 'bare' of ") > 0 .and. &
                      index(run%diagnostics, 'test_bare.csv has no od; give it here') > 0, message=run%diagnostics)
   end subroutine test_catalogue_faults

   !> Advice on a catalogue is followed, and the message is gone.
   subroutine test_catalogue_followed()
      type(run_type) :: run
      character(*), parameter :: of_a_grade = "List pipe of a grade so: --list-catalogue 'DP 5 S135'"
      call follow('name,od_mm\na,127\na,127\n', "'a' stands in line 2 already; keep one", 'name,od_mm\na,127\n')
      call follow('name,od\na,127\n', "unknown column 'od'; legal: name, kind", 'name,od_mm\na,127\n')
      call follow('kind,od_mm\na,127\n', 'the header names no name', 'name,od_mm\na,127\n')
      call follow('name,kind\na,drillpipe\n', 'has no od; give it here', 'name,kind\na,drillpipe\n', ', od = 127')
      call follow('name,od_mm,connection\na,127,NC5O\n', "connection = 'NC5O' is unknown; legal: ", &
                  'name,od_mm,connection\na,127,NC50\n')
      call refuse("catalogue = 'DP 5 19.50 NC5'", "did you mean 'DP 5 19.50 NC50'?")
      run = run_deck_text(replaced(good_deck(), pipe, "&component catalogue = 'DP 5 19.50 NC50' /"), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program('--list-catalogue S135')
      call assertTrue(index(run%output, of_a_grade) > 0, message=run%output)
      run = run_program("--list-catalogue 'DP 5 S135'")
      call assertTrue(index(run%output, 'DP 5 19.50 NC50 S135') > 0, message=run%output)
      call assertEqual(0, index(run%output, of_a_grade), message=run%output)
      run = run_program('--list-catalogue dp')         ! as for 'DP 7 20' above
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'DP 5 19.50 NC50') > 0, message=run%output)
   contains
      !> Components 'a' of two catalogues, the second one with a key.
      subroutine follow(faulty, expected, followed, key)
         character(*), intent(in) :: faulty, expected, followed
         character(*), intent(in), optional :: key
         character(:), allocatable :: text
         text = replaced(good_deck(), '&job ', "&job catalogue_file = '../test_follow.csv', ")
         call execute_command_line("printf '"//faulty//"' > build/test_follow.csv")
         run = run_deck_text(replaced(text, pipe, "&component catalogue = 'a' /"), '--check')
         call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
         call execute_command_line("printf '"//followed//"' > build/test_follow.csv")
         text = replaced(text, pipe, "&component catalogue = 'a' /")
         if (present(key)) text = replaced(text, "catalogue = 'a'", "catalogue = 'a'"//key)
         run = run_deck_text(text, '--check')
         call assertEqual(0, run%status, message='followed: '//expected//'; got: '//run%diagnostics)
      end subroutine follow
   end subroutine test_catalogue_followed

   !> To field units and back: the same results, and the numbers that the deck had.
   subroutine test_convert()
      type(run_type) :: run
      real(wp) :: before, after
      real(wp), parameter :: kilopound = 4.4482216152605_wp      ! kN
      run = run_deck_text(good_deck())
      before = first_hookload()
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program('--convert '//deck_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, "&job units = 'field' title = 'a deck'") > 0, message=run%output)
      call assertTrue(index(run%output, 'inc = 0.0, 0.0, 30.0') > 0, message='angles stay')
      call assertTrue(index(run%output, 'azi = 3*10.0 /') > 0, message=run%output)
      call assertTrue(index(run%output, 'joint_od = 6.625984 /') > 0, message=run%output)
      call keep('field.nml')
      run = run_program(scratch//'/field.nml --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      after = first_hookload()
      call assertRelativelyEqual(before, after*kilopound, 1.0e-6_wp)
      run = run_program('--convert '//scratch//'/field.nml')
      call assertTrue(index(run%output, "&job units = 'SI' title = 'a deck'") > 0, message=run%output)
      call assertTrue(index(run%output, 'od = 171.45, id = 71.4 /') > 0, message=run%output)
      call assertTrue(index(run%output, 'md  = 0.0, 500, 900') > 0, message=run%output)
      run = run_program('--convert '//scratch//'/absent.nml')
      call assertEqual(2, run%status)
      run = run_program('--convert')
      call assertEqual(2, run%status)
   end subroutine test_convert

   !> The template in metric units runs, with the numbers of a Norwegian rig.
   subroutine test_metric_template()
      type(run_type) :: run
      call clear_scratch()
      run = run_program('--template METRIC')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, "units = 'metric'") > 0, message=run%output)
      call assertTrue(index(run%output, 'diameter = 8.835 ') > 0, message='inches as in a field deck')
      call assertTrue(index(run%output, 'md = 0, 600, 1500, 2400') > 0, message='metres as in an SI deck')
      call assertTrue(index(run%output, 'density = 1.2 ') > 0, message='specific gravity')
      call assertTrue(index(run%output, 'yield = 9310 ') > 0, message='bar')
      call assertTrue(index(run%output, 'wob = 5 ') > 0, message='kdaN')
      call assertTrue(index(run%output, '[> 0 and <= 10000 kdaN]') > 0, message='range of rig_limit')
      call keep('template.nml')
      run = run_program(scratch//'/template.nml --quiet --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'kdaN') > 0, message=run%output)
      call assertEqual(0, index(run%output, 'kN '), message=run%output)
   end subroutine test_metric_template

   !> From SI to metric units and back: the same numbers, the same hook load.
   subroutine test_convert_metric()
      type(run_type) :: run
      real(wp) :: before, after
      run = run_deck_text(good_deck())
      before = first_hookload()
      run = run_program('--convert '//deck_path//' metric')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, "&job units = 'metric' title = 'a deck'") > 0, message=run%output)
      call assertTrue(index(run%output, 'od = 6.75, id = 2.8110236 /') > 0, message=run%output)
      call keep('metric.nml')
      run = run_program(scratch//'/metric.nml --output '//results_path)
      call assertEqual(0, run%status, message=run%diagnostics)
      after = first_hookload()
      call assertRelativelyEqual(before, 10.0_wp*after, 1.0e-6_wp)
      run = run_program('--convert '//scratch//'/metric.nml')
      call assertTrue(index(run%output, "&job units = 'SI' title = 'a deck'") > 0, message=run%output)
      call assertTrue(index(run%output, 'od = 171.45, id = 71.4 /') > 0, message=run%output)
      run = run_program('--convert '//scratch//'/metric.nml field')
      call assertTrue(index(run%output, "&job units = 'field' title = 'a deck'") > 0, message=run%output)
      run = run_program('--convert '//deck_path//' metres')
      call assertEqual(2, run%status, message='no system of units')
   end subroutine test_convert_metric

   !> Ranges and keys in the comments of a template are in the units of the converted deck, and as in a template of these units.
   subroutine test_convert_comments()
      type(run_type) :: run
      call clear_scratch()
      run = run_program('--template')
      call keep('si.nml')
      run = run_program('--convert '//scratch//'/si.nml')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '[0 to 164040 ft]') > 0, message=run%output)
      call assertTrue(index(run%output, '[> 0 and <= 22481 klbf]') > 0, message=run%output)
      call assertEqual(0, index(run%output, ' m]'), message='no range in m')
      call assertEqual(0, index(run%output, ' kN]'), message='no range in kN')
      call assertTrue(index(run%output, '! joint_spacing = 31.16798 ') > 0, message='a default that is a comment')
      call assertTrue(index(run%output, '[0 to 100 m/s2]') > 0, message='one unit in both systems')
      call keep('field.nml')
      run = run_program(scratch//'/field.nml --check')
      call assertEqual(0, run%status, message=run%diagnostics)
   end subroutine test_convert_comments

   !> A survey file without units, a deck without &job: what the deck left unsaid is said.
   subroutine test_convert_unsaid()
      type(run_type) :: run
      call clear_scratch()
      call write_text('path.csv', [character(80) :: 'md,inc,azi', '0,0,0', '500,0,0', '900,30,0'])
      call write_text('si.nml', [character(80) :: "&trajectory survey_file = 'path.csv' /", '&hole diameter = 215.9 /', &
                                 '&component od = 127 /', "&load_case name = 'u', operation = 'up', bit_depth = 900 /"])
      run = run_program(scratch//'/si.nml --check')
      call assertEqual(0, run%status, message=run%diagnostics)
      run = run_program('--convert '//scratch//'/si.nml')
      call assertTrue(index(run%output, newline//"&job units = 'field' /"//newline// &
                            "&trajectory survey_units = 'SI' survey_file") > 0, message=run%output)
      call keep('field.nml')
      run = run_program(scratch//'/field.nml --check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, '2952.756 measured') > 0, message=run%output)
   end subroutine test_convert_unsaid

   !> Writes a file into the scratch folder.
   subroutine write_text(name, texts)
      character(*), intent(in) :: name, texts(:)
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      integer :: i
      allocate (lines(0))
      do i = 1, size(texts)
         call append_text(lines, trim(texts(i)))
      end do
      call write_text_file(scratch//'/'//name, lines, error)
      call assertFalse(allocated(error))
   end subroutine write_text

   !> Keeps what the program printed last.
   subroutine keep(name)
      character(*), intent(in) :: name
      integer :: status
      call execute_command_line('cp '//scratch//'/output.txt '//scratch//'/'//name, exitstat=status)
      call assertEqual(0, status)
   end subroutine keep

   !> Hook load of the first row of summary.csv, in its units: the eighth field.
   function first_hookload() result(load)
      real(wp) :: load
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure, row
      integer :: field
      load = 0.0_wp
      call read_lines(results_path//'/summary.csv', lines, failure)
      call assertEqual('', failure)
      if (size(lines) < 2) return
      row = lines(2)%text
      do field = 1, 7
         row = row(index(row, ',') + 1:)
      end do
      read (row(:index(row, ',') - 1), *) load
   end function first_hookload

   subroutine refuse(keys, expected)
      character(*), intent(in) :: keys, expected
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), pipe, '&component '//keys//' /'))
      call assertEqual(2, run%status, message=keys)
      call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
   end subroutine refuse
end module dg_test_actions
