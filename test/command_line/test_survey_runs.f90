!> Survey files that a deck names: the hole above the first station, the parent of a sidetrack, columns by name, positions that a
!> file lists.
module dg_test_survey_runs
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_program_run, only: clear_scratch, deck_path, run_program, run_type, scratch
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: survey_runs_suite, check

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: slant = 'MD (m),Inc,Azi;30,45,10;300,60,10;1400,90,10'
   character(*), parameter :: side = 'MD,Inc,Azi;1010,30.5,46;1100,35,60;1400,60,80'
   character(*), parameter :: parent = 'Depth,Deviation,Bearing;0,0,0;500,0,0;800,20,45;1000,30,45;1500,30,45'

contains

   function survey_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('survey_runs')
      call suite%addTest(TestMethod('begins_inclined', test_begins_inclined))
      call suite%addTest(TestMethod('parent', test_parent))
      call suite%addTest(TestMethod('columns', test_columns))
      call suite%addTest(TestMethod('positions', test_positions))
      call suite%addTest(TestMethod('well_trace', test_well_trace))
      call suite%addTest(TestMethod('ends_above_bit', test_ends_above_bit))
   end function survey_runs_suite

   !> Three ways for the hole above; straight is what a station at surface by hand makes.
   subroutine test_begins_inclined()
      type(run_type) :: run
      character(:), allocatable :: by_hand
      run = check(slant, '')
      call assertEqual(2, run%status)
      call expect(run%diagnostics, 'survey.csv:2: survey: the first station is at 30 m and inclined by 45 deg')
      call expect(run%diagnostics, "For a sidetrack give parent_file = 'FILE'")
      call expect(run%diagnostics, "give tie_on = 'straight'")
      call expect(run%diagnostics, "give tie_on = 'vertical', which makes 45 deg/30 m")
      run = check('MD (m),Inc,Azi;0,45,10;30,45,10;300,60,10;1400,90,10', '')
      by_hand = path_line(run)
      run = check(slant, ", tie_on = 'straight'")
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(by_hand, path_line(run))
      call expect(run%output, 'straight up to surface, in the direction of the first station')
      run = check(slant, ", tie_on = 'vertical'")
      call assertEqual(0, run%status, message=run%diagnostics)
      call expect(run%output, '45 deg/30 m. Warning: holes hardly turn by more than 6 deg/30 m')
      run = check('MD (m),Inc,Azi;300,45,10;1400,90,10', ", tie_on = 'vertical'")
      call expect(run%output, 'it turns by 45 deg, 4.5 deg/30 m')
      call assertEqual(0, index(run%output, 'Warning'), message=run%output)
   end subroutine test_begins_inclined

   subroutine test_parent()
      type(run_type) :: run
      character(:), allocatable :: by_hand
      run = check('MD,Inc,Azi;0,0,0;500,0,0;800,20,45;1000,30,45;1010,30.5,46;1100,35,60;1400,60,80', '')
      by_hand = path_line(run)
      run = check(side, ", parent_file = 'parent.csv'", parent)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(by_hand, path_line(run))
      call expect(run%output, '4 stations of parent_file are taken, down to 1000 m')
      call expect(run%output, 'at 1010 m, the hole turns by 0.71 deg, 2.129 deg/30 m')
      call assertEqual(0, index(run%output, 'Warning'), message=run%output)
      run = check(side, ", parent_file = 'parent.csv'", 'MD,Inc,Azi;0,0,0;1000,30,90;1500,30,90')
      call expect(run%output, 'the parent points 21.8 deg away from the first station. Warning: check')
      run = check(side, ", md_column = 'MD', parent_file = 'parent.csv'", parent)
      call assertEqual(0, run%status, message='names of the survey alone: '//run%diagnostics)
      run = check('MD,Inc,Azi;0,0,0;1400,10,10', ", parent_file = 'parent.csv'", parent)
      call expect(run%diagnostics, 'parent_file has no station above. Leave parent_file out')
      run = check(side, ", parent_file = 'absent.csv'", parent)
      call expect(run%diagnostics, 'group &trajectory: parent_file: ')
      run = check(side, ", parent_file = 'parent.csv'", 'MD,Inc,Azi;500,20,45;1000,30,45')
      call expect(run%diagnostics, 'the first station is at 500 m and inclined by 20 deg')
   end subroutine test_parent

   subroutine test_columns()
      type(run_type) :: run
      run = check('Tiefe a,Inc,Azi;0,0,0;1400,10,10', '')
      call expect(run%diagnostics, "survey.csv:1: survey: the header names no md. Headings seen: 'Tiefe a', 'Inc', 'Azi'. "// &
                  'Known for md: MD, Measured Depth,')
      call expect(run%diagnostics, 'Or name the column in &trajectory by md_column')
      run = check('Tiefe a,Inc,Azi;0,0,0;1400,10,10', ", md_column = 'Tiefe a'")
      call assertEqual(0, run%status, message=run%diagnostics)
      run = check('MD,Inc,Azimuth TN,Azimuth GN;0,0,0,0;1400,10,10,12', '')
      call expect(run%output, "azi is column 'Azimuth GN', not 'Azimuth TN'. They differ by up to 2 deg")
      call expect(run%output, "survey.csv: 2 stations, md from column 'MD' [m], inc from 'Inc' [deg], azi from 'Azimuth GN' [deg]")
      run = check('Azi,Depth (ft),Incl;0,0,0;0,4600,10', '')
      call expect(run%output, "2 stations, md from column 'Depth (ft)' [ft], inc from 'Incl' [deg], azi from 'Azi' [deg]")
      run = check('MD,Inc,Azimuth TN,Azimuth GN;0,0,0,0;1400,10,10,12', ", azi_column = 'Azimuth TN'")
      call assertEqual(0, index(run%output, 'azi is column'), message=run%output)
      run = check('MD,Inc;0,0;1400,10', '')
      call expect(run%diagnostics, "the hole is inclined, but the header names no azi. Headings seen: 'MD', 'Inc'")
      run = check('PK'//char(3)//char(4)//'[Content_Types].xml', '')
      call expect(run%diagnostics, 'survey.csv: survey file is an Excel workbook (xlsx). Save the sheet as CSV')
   end subroutine test_columns

   !> A quarter of a circle of 300 m: 300 m down and 300 m to the north, the listing rounded to centimetres.
   subroutine test_positions()
      character(*), parameter :: head = 'MD,Inc,Azi,TVD,N/S,E/W;0,0,0,100,5,7;', last = '471.238898,90,0,400,305,7;1400,90,0,400,'
      type(run_type) :: run
      run = check(head//last//'1233.76,7', '')
      call expect(run%output, 'TVD, north, east agree with those of the file within 0.01 m')
      run = check(head//last//'1233.26,7', '')
      call expect(run%output, 'TVD, north, east differ from those of the file by up to 0.501 m, north at 1400 m')
      call assertEqual(0, index(run%output, 'Warning'), message=run%output)
      run = check(head//last//'1033.76,7', '')
      call expect(run%output, newline//'note        survey ')
      call expect(run%output, 'survey.csv: TVD, north, east differ from those of the file by up to 200 m, '// &
                  'north at 1400 m. Check columns, units and the north of the azimuths')
      call assertEqual(0, index(run%output, 'Path: survey'), message=run%output)
   end subroutine test_positions

   !> A well trace of Petrel in feet for a deck in SI: its title tells the unit.
   subroutine test_well_trace()
      type(run_type) :: run
      run = check('# WELL TRACE FROM PETREL;# DX DY ARE GIVEN IN GRID NORTH IN ft-UNITS;# DEPTH (Z, TVD) GIVEN IN ft-UNITS;'// &
                  '#=====;  MD  X  Y  Z  TVD  DX  DY  AZIM_TN  INCL  DLS  AZIM_GN;#=====;'// &
                  '0 1 2 9 0 0 0 1.5 0 0 0;5000 1 2 9 5000 0 0 11.5 0 0 10', '')
      call assertEqual(0, run%status, message=run%diagnostics)
      call expect(run%output, '2 stations to 1524 measured')
      call expect(run%output, 'TVD, north, east agree with those of the file')
   end subroutine test_well_trace

   !> A survey in ft with one decimal that ends 11 mm above the bit holds the bit at its end. One that ends higher has one message
   !> for all cases.
   subroutine test_ends_above_bit()
      character(*), parameter :: feet = 'MD (ft),Inc,Azi;0,0,0;', more = " /;&load_case name = 'd', operation = 'down', "// &
         'bit_depth = 1390 /;&sweep operations = ''down'', bit_depth_from = 1300, bit_depth_to = 1390, bit_depth_step = 45, '// &
         "measured_depths = 1390, measured_operations = 'down', measured_hookloads = 500"
      type(run_type) :: run
      run = check(feet//'4560.33,10,10', more)
      call assertEqual(0, run%status, message=run%diagnostics)
      call expect(run%output, 'trip_out at 1389.989 m')
      run = check(feet//'4560.2,10,10', more)
      call expect(run%diagnostics, 'bit_depth = 1390 m lies below the survey, which ends at 1389.94896 m')
      call assertEqual(index(run%diagnostics, newline), index(run%diagnostics, newline//scratch//'/deck.nml', back=.true.), &
                       message='two lines: '//run%diagnostics)
   end subroutine test_ends_above_bit

   !> Checks a deck that names a survey, and perhaps a parent, whose lines are parted by semicolons.
   function check(table, keys, above) result(run)
      character(*), intent(in) :: table
      character(*), intent(in) :: keys         !< more of &trajectory
      character(*), intent(in), optional :: above
      type(run_type) :: run
      call clear_scratch()
      call write_text(scratch//'/survey.csv', table)
      if (present(above)) call write_text(scratch//'/parent.csv', above)
      call write_text(deck_path, "&trajectory survey_file = 'survey.csv'"//keys// &
                      ' /;&hole diameter = 215.9 /;&component od = 127 /;'// &
                      "&load_case name = 'u', operation = 'up', bit_depth = 1390 /")
      run = run_program('--check '//deck_path)
   end function check

   subroutine write_text(path, text)
      character(*), intent(in) :: path, text
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      integer :: first, length
      allocate (lines(0))
      first = 1
      do while (first <= len(text))
         length = index(text(first:), ';') - 1
         if (length < 0) length = len(text) - first + 1
         call append_text(lines, text(first:first + length - 1))
         first = first + length + 1
      end do
      call write_text_file(path, lines, error)
   end subroutine write_text

   !> Line of the check on the path, without the number of stations.
   function path_line(run) result(line)
      type(run_type), intent(in) :: run
      character(:), allocatable :: line
      integer :: first
      line = ''
      first = index(run%output, ' stations to ')
      if (first == 0) return
      line = run%output(first:)
      line = line(:index(line, newline) - 1)
   end function path_line

   subroutine expect(text, part)
      character(*), intent(in) :: text, part
      call assertTrue(index(text, part) > 0, message='wanted '//part//'; got: '//text)
   end subroutine expect
end module dg_test_survey_runs
