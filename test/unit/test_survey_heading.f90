!> Headings of survey tables: the column that each is taken for, and lines that are no stations.
module dg_test_survey_heading
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_error, only: error_list_type, error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_kinds, only: wp
   use dg_survey_file, only: column_names_type, read_survey_file, station_list_type
   use dg_survey_heading, only: column_name, heading_type, read_heading
   use dg_table_lines, only: lines_between
   use dg_units, only: si_units
   implicit none
   private
   public :: survey_heading_suite

   character(*), parameter :: path = 'build/test_heading.txt'

contains

   function survey_heading_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('survey_heading')
      call suite%addTest(TestMethod('headings_of_one_column', test_single))
      call suite%addTest(TestMethod('north_of_an_azimuth', test_norths))
      call suite%addTest(TestMethod('several_lines', test_lines, tearDown=remove))
      call suite%addTest(TestMethod('several_columns', test_rivals, tearDown=remove))
      call suite%addTest(TestMethod('columns_by_name', test_names, tearDown=remove))
      call suite%addTest(TestMethod('lines_without_station', test_notes, tearDown=remove))
      call suite%addTest(TestMethod('damaged_stations', test_damaged, tearDown=remove))
      call suite%addTest(TestMethod('cells_by_place', test_places, tearDown=remove))
      call suite%addTest(TestMethod('other_formats', test_formats, tearDown=remove))
   end function survey_heading_suite

   subroutine remove()
      call delete_file(path)
   end subroutine remove

   !> A heading by itself: md, inc, azi, tvd, north, east or none.
   subroutine test_single()
      character(*), parameter :: md(37) = [character(34) :: 'MD', 'Measured Depth', 'Meas. Depth', 'MEASURED_DEPTH', &
         'MeasuredDepth', 'Survey MD', 'Total MD', 'Depth', 'Hole Depth', 'Survey Depth', 'Station Depth', 'Svy Depth', 'DEPT', &
         'Drilled Depth', 'Depth MD (m)', 'Depth m MD', 'MD RKB (m)', 'MDRT', 'md_rkb', 'Along Hole Depth', 'AH_DEPTH', 'AHD', &
         'DMEA', 'Survey Point MD', 'STATION_MD', 'Depth (measured)', 'Planned MD', 'Bohrteufe', 'Profondeur mesuree', &
         'Profundidad Medida', 'Gemeten diepte', 'M.D. (ft)', 'M. Depth', 'Measured Depth (MD)', 'Depth below RKB (m)', &
         'MD (from RKB)', 'Measured Depth From RT']
      character(*), parameter :: inc(27) = [character(34) :: 'Inc', 'INCL', 'Inclination (deg)', 'Inc Angle', 'Incl. deg', &
         'Angle of Inclination (Degrees)', 'Deviation Angle', 'DEVIATION_ANGLE', 'DEVI', 'Dev', 'Drift', 'Drift Angle', &
         'Hole Angle', 'Angle', 'HDEV', 'Deviation from vertical', 'Survey Inclination', 'InclinationAngle', 'incl_deg', &
         'Corrected Inclination', 'Inklinasjon', 'Neigung', 'Inclinaison', 'Plan Inc', &
         'Inclination (INC)', 'Incl (deg from vertical)', 'Well Inclination']
      character(*), parameter :: azi(25) = [character(34) :: 'Azi', 'AZIMUTH', 'Azm', 'Az', 'HAZI', 'Corrected Azimuth', &
         'AZIM_TN', &
         'AZIM_GN', 'Azi (GN)', 'Azimuth (deg TN)', 'AzimuthAngle', 'Bearing', 'Hole Direction', 'Drift Direction', &
         'Drift Azimuth', 'Deviation Azimuth', 'Magnetic Azimuth', 'Azimuth (magnetic)', 'Svy Azimuth (corr)', 'azim_deg', &
         'True Bearing', 'Retning', 'Acimut', 'Azimut', 'Azimuth Grid North']
      character(*), parameter :: none(45) = [character(34) :: 'DLS', 'Build', 'Build Rate', 'Turn', 'Dogleg', 'Dog Leg Severity', &
         'Closure Azimuth', 'Closure Direction', 'Vertical Section', 'Vertical Section Azimuth', 'VS Azimuth', 'Course Length', &
         'Dip', 'Dip Angle', 'Magnetic Inclination', 'Toolface', 'Tool Face Azimuth', 'Bit Depth', 'TVDSS', 'Subsea Depth', &
         'Depth (MSL)', 'Depth msl', 'Inc error', 'Azi Error', 'Delta Inc', 'MD TVD', 'Inc Azi', 'Foo', 'Comments', 'Well', &
         'Elevation', 'X', 'Y', 'Z', 'Drift distance', 'Horizontal Displacement', 'Grid Convergence', 'Magnetic Declination', &
         'Depth From Top', 'Vertical', 'Measured', 'Section', 'Vertical Angle', 'Inc 2', 'Survey']
      character(*), parameter :: tvd(9) = [character(34) :: 'TVD', 'True Vertical Depth', 'Vertical Depth (m)', 'TVD RKB', &
         'TV_DEPTH', 'Depth (TVD)', 'Depth TVD', 'True Depth', 'T.V.D.']
      character(*), parameter :: north(9) = [character(34) :: 'North', 'N/S', '+N/-S', 'NS (ft)', 'N-S', 'Northing (m)', 'DY', &
         'Y Offset', 'Local N']
      character(*), parameter :: east(9) = [character(34) :: 'East', 'E/W', '+E/-W', 'EW (ft)', 'E-W', 'Easting (m)', 'DX', &
         'X_OFFSET', 'Local E']
      call are('md', md)
      call are('inc', inc)
      call are('azi', azi)
      call are('', none)
      call are('tvd', tvd)
      call are('north', north)
      call are('east', east)
   contains
      subroutine are(expected, headings)
         character(*), intent(in) :: expected, headings(:)
         type(heading_type) :: heading
         character(8) :: found
         integer :: i
         do i = 1, size(headings)
            call read_heading(trim(headings(i)), heading)
            found = ''
            if (heading%column > 0) found = column_name(heading%column)
            call assertEqual(expected, trim(found), message=headings(i))
         end do
      end subroutine are
   end subroutine test_single

   !> Grid before corrected, true, one that names none, and magnetic.
   subroutine test_norths()
      character(*), parameter :: headings(5) = [character(20) :: 'Azimuth Grid', 'Corrected Azimuth', 'Azi (TN)', 'Azimuth', &
                                                'Mag. Azimuth']
      type(heading_type) :: heading, before
      integer :: i
      do i = 2, size(headings)
         call read_heading(trim(headings(i - 1)), before)
         call read_heading(trim(headings(i)), heading)
         call assertTrue(before%rank < heading%rank, message=headings(i))
      end do
   end subroutine test_norths

   subroutine test_lines()
      call accept('two lines', 'Measured,Drift,Hole;Depth,Angle,Azimuth;0,0,0;500,10,90;1200,45,100')
      call accept('three lines and units', 'Survey,Hole,Corr.;Measured,Incl.,Azimuth;Depth,,(Grid);m,deg,deg;0,0,0;500,10,90;'// &
                  '1200,45,100')
      call accept('by places', '  Measured                     Vertical;     Depth      Inc      Azi     Depth;'// &
                  '      0.00     0.00     0.00      0.00;    500.00    10.00    90.00    497.00;'// &
                  '   1200.00    45.00   100.00   1100.00')
      call accept('words of a line', 'Measured Depth Hole Angle Corrected Azimuth;0 0 0;500 10 90;1200 45 100')
      call accept('a title above', 'True North;MD,Inc,Azi;0,0,0;500,10,90;1200,45,100')
      call accept('in a comment', '# Well 3;# MD Inc Azi;0 0 0;500 10 90;1200 45 100')
      call accept('marks of feet', "MD ('),Inc,Azi;0,0,0;1640.4199,10,90;3937.00787,45,100")
      call accept('marks of feet, bare', "MD_',Inc,Azi;0,0,0;1640.4199,10,90;3937.00787,45,100")
      call accept('marks of feet below', "MD,Inc,Azi;',deg,deg;0,0,0;1640.4199,10,90;3937.00787,45,100")
      call accept('single quotes', "'MD','Inc','Azi';0,0,0;500,10,90;1200,45,100")
      call accept('a number sign', 'Stn#,MD,Inc,Azi;1,0,0,0;2,500,10,90;3,1200,45,100')
      call accept('a page feed', 'MD Inc Azi;0 0 0;500 10 90;'//achar(12)//'MD Inc Azi;1200 45 100;'//achar(26))
      call refuse('vertical above depth', 'Vertical;   Depth   Inc   Azi;    0.0   0.0   0.0;  500.0  10.0  90.0', &
                  "'Vertical Depth'")
      call refuse('true vertical', 'True Vertical,,;Depth,Inc,Azi;0,0,0;500,10,90', 'the header names no md. Headings seen')
   end subroutine test_lines

   subroutine test_rivals()
      call accept('grid and true', 'MD Azi_TN Inc Azi_GN;0 0 0 0;500 92 10 90;1200 102 45 100', &
                  columns="azi is column 'Azi_GN', not 'Azi_TN'. They differ by up to 2 deg")
      call accept('across north', 'MD Inc Azi Azimuth_mag;0 0 0 0;500 10 90 89;1200 45 100 820', &
                  columns="azi is column 'Azi', not 'Azimuth_mag'. They differ by up to 1 deg")
      call accept('feet beside metres', 'MD (m),MD (ft),Inc,Azi;0,0,0,0;500,1640.42,10,90;1200,3937.008,45,100', columns='')
      call accept('depth beside md', 'Depth,MD,Inc,Azi;9,0,0,0;9,500,10,90;9,1200,45,100', columns='')
      call accept('depth by itself', 'Depth,Inc,Azi;0,0,0;500,10,90;1200,45,100', columns="'Depth' is read as measured depth")
      call refuse('depth beside an md of unknown words', 'Depth,MD foo,Inc,Azi;0,0,0,0;500,490,10,90', 'the header names no md')
      call refuse('two azimuths', 'MD,Inc,Azimuth,Azi;0,0,0,0;500,10,90,91;1200,45,100,103', &
                  "two columns may be azi, 'Azimuth' and 'Azi'. They differ by up to 3 deg. Name one")
      call refuse('two depths', 'Depth,Depth,Inc,Azi;0,0,0,0;500,490,10,90;1200,1100,45,100', 'two columns may be md')
      call refuse('minutes', 'MD,Inc Deg,Inc Min,Azi;0,0,0,0;500,10,30,90', 'decimal degrees')
   end subroutine test_rivals

   subroutine test_names()
      character(*), parameter :: table = 'Foo,Bar (deg),Baz,TVD,Baz true;0,0,0,0,0;500,10,90,1,2;1200,45,100,1,2'
      call accept('as they stand', table, names=['Foo      ', 'Bar (deg)', 'Baz      '])
      call accept('without unit, other letters', table, names=['foo', 'BAR', 'baz'])
      call accept('another script', char(208)//char(147)//',Inc,Azi;0,0,0;500,10,90;1200,45,100', &
                  names=[char(208)//char(147), '  ', '  '])
      call accept('one of them', 'MD,Inc,Azi,A1;0,0,9,0;500,10,9,90;1200,45,9,100', names=['  ', '  ', 'A1'])
      call accept('two words on two lines', 'Foo,Inc,Azi;Number 7,,;0,0,0;500,10,90;1200,45,100', &
                  names=['Foo Number 7', '            ', '            '])
      call refuse('no such', table, "md_column = 'Fool' is not a heading of the file. Headings seen: 'Foo', 'Bar (deg)'", &
                  ['Fool', 'Bar ', 'Baz '])
      call refuse('twice', 'A,A,Inc,Azi;0,0,0,0;1,1,1,1', "md_column = 'A' stands twice", ['A', ' ', ' '])
   end subroutine test_names

   subroutine test_notes()
      character(*), parameter :: head = 'MD,Inc,Azi;0,0,0;500,10,90;', last = '1200,45,100'
      call accept('text', head//last//';;End of survey;Page 1 of 2;3/15/2013 2:54:13PM;Approved by: X,,', &
                  skipped='rows skipped: 4 of text (first in line 6)')
      call accept('text between blanks', 'MD Inc Azi;0 0 0;500 10 90;Page 2 of 3;Total depth: 1200 m;1200 45 100', &
                  skipped='rows skipped: 2 of text (first in line 4)')
      call accept('a page in as many words as columns', 'MD Inc Azi TVD;0 0 0 0;500 10 90 490;Page 2 of 3;1200 45 100 999', &
                  skipped='rows skipped: 1 of text (first in line 4)')
      call accept('another table below', 'MD Inc Azi TVD;0 0 0 0;500 10 90 490;1200 45 100 999;;Casing Points;MD TVD Name;'// &
                  '500.00 490.00 20in', skipped='rows skipped: 3 of text (first in line 6)')
      call accept('stations below such a title', 'MD Inc Azi TVD;0 0 0 0;500 10 90 490;Targets;1200 45 100 999', &
                  skipped='rows skipped: 1 of text (first in line 4)')
      call refuse('no title above', 'MD Inc Azi TVD;0 0 0 0;500 10 90 490;1200 45 100 999;500.00 490.00 20in', 'columns')
      call accept('rules', 'MD Inc Azi;--- --- ---;0 0 0;500 10 90;======;1200 45 100', &
                  skipped='rows skipped: 2 of dashes (first in line 2)')
      call accept('headers', 'MD,Inc,Azi;m,deg,deg;0,0,0;500,10,90;MD,Inc,Azi;m,deg,deg;'//last, &
                  skipped='rows skipped: 2 with the header or its units again (first in line 5)')
      call accept('twice', head//'500,10,90;'//last//';500,10,450', &
                  skipped='rows skipped: 2 with a station again (first in line 4)')
      call accept('deepest first', 'MD,Inc,Azi;1200,45,100;500,10,90;0,0,0', skipped='deepest station first, order turned')
      call accept('no azimuth', 'MD,Inc,Azi;0,0,---;200,0.2,N/A;500,10,90;'//last, &
                  skipped='2 without azimuth where the hole is vertical (first in line 2), read as stations', more=1)
      call accept('names of two words', 'Well        MD  Inc  Azi;Well A 1H   0   0   0;Well A 1H  500  10  90;'// &
                  'Well A 1H  1200  45  100', skipped='')
      call accept('names of two words, one blank', 'Well MD Inc Azi;Well A 1H 0 0 0;Well A 1H 500 10 90;Well A 1H 1200 45 100', &
                  skipped='')
   end subroutine test_notes

   !> Never skip a line that may be a station.
   subroutine test_damaged()
      character(*), parameter :: head = 'MD,Inc,Azi;0,0,0;500,10,90;'
      character(*), parameter :: damaged(15) = [character(12) :: '12OO,45,100', 'l200,45,100', 'ERR,45,100', ',45,100', &
         '1200,,100', '1200,4S,100', '1200,45', '1200', '1200,45,---', '1200,0', '12OO', '12OO,4S,lOO', '#REF!,45,100', &
         '1200,45,#N/A', '1200 45 100']
      integer :: i
      do i = 1, size(damaged)
         call refuse(damaged(i), head//trim(damaged(i))//';1500,45,100', 'survey: ')
      end do
      call refuse('between blanks', 'MD Inc Azi;0 0 0;500 1O.0 90;1200 45 100', "inc = '1O.0' is not a number")
      call refuse('one number left', 'MD Inc Azi;0 0 0;NaN 10.0 NaN;1200 45 100', "md = 'NaN' is not a number")
      call refuse('errors', 'MD Inc Azi;0 0 0;ERR 10.0 ERR;1200 45 100', "md = 'ERR' is not a number")
      call refuse('text before numbers', 'MD Inc Azi;0 0 0;Tie 500 10 90;1200 45 100', 'survey: ')
      call refuse('another well', 'Well,MD,Inc,Azi;A,0,0,0;A,500,10,90;B,1200,45,100', &
                  "the row is of well 'B', rows above are of 'A'")
      call refuse('bearings', 'MD,Inc,Bearing;0,0,0;500,10,N45E', 'Write azimuths from 0 to 360 deg')
   end subroutine test_damaged

   !> Between blanks a cell may be empty where the others stand below their headings.
   subroutine test_places()
      call accept('no azimuth', '     MD   Inc     Azi   DLS;   0.00  0.00          0.00; 500.00 10.00   90.00  0.60;'// &
                  '1200.00 45.00  100.00  1.50')
      call accept('no remark', '     MD   Inc     Azi   DLS;   0.00  0.00    0.00; 500.00 10.00   90.00  0.60;'// &
                  '1200.00 45.00  100.00  1.50')
      call accept('remarks behind some', 'MD Inc Azi Remark;0 0 0 tie-on;500 10 90;1200 45 100 TD')
      call refuse('no inclination', '     MD   Inc     Azi   DLS;   0.00  0.00    0.00  0.00; 500.00         90.00  0.60;'// &
                  '1200.00 45.00  100.00  1.50', 'no value for inc')
   end subroutine test_places

   subroutine test_formats()
      call refuse('xlsx', 'PK'//char(3)//char(4)//'    [Content_Types].xml', 'is an Excel workbook (xlsx). Save the sheet as CSV')
      call refuse('zip', 'PK'//char(3)//char(4)//'    survey.csv', 'is a zip archive')
      call refuse('xls', char(208)//char(207)//char(17)//char(224), 'is an Excel workbook of the old form')
      call refuse('pdf', '%PDF-1.7', 'is a PDF document')
      call refuse('gzip', char(31)//char(139)//'x', 'is compressed (gzip). Unpack it')
      call refuse('html', '<html>', 'is a web page')
      call refuse('json', ' {"md": [0, 1]}', 'is JSON')
      call refuse('a list', '[[0, 0], [1, 0]]', 'is JSON')
      call refuse('zeros', 'MD'//char(0)//char(0), 'is not text')
      call accept('a heading in brackets', '[m] [deg] [deg];MD Inc Azi;0 0 0;500 10 90;1200 45 100')
   end subroutine test_formats

   !> Reads a table with lines parted by ; and looks for the last station, and for three in all.
   subroutine accept(what, table, names, skipped, columns, more)
      character(*), intent(in) :: what, table
      character(*), intent(in), optional :: names(:), skipped, columns
      integer, intent(in), optional :: more           !< stations beside the three
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      real(wp), parameter :: round_off = 1.0e-3_wp    ! of the feet written above
      logical :: sound
      integer :: n
      call read_table(table, names, stations, sound, faults)
      if (faults%count > 0) call assertEqual('', faults%items(1)%message, message=what)
      call assertTrue(sound, message=what)
      n = 3
      if (present(more)) n = n + more
      call assertEqual(n, size(stations%md), message=what)
      if (.not. sound .or. size(stations%md) /= n) return
      call assertEqual(1200.0_wp, stations%md(n), round_off, message=what)
      call assertEqual(45.0_wp, stations%inclination(n)/degree, round_off, message=what)
      call assertEqual(100.0_wp, stations%azimuth(n)/degree, round_off, message=what)
      if (present(skipped)) call assertEqual(skipped, stations%skipped, message=what)
      if (.not. present(columns)) return
      if (columns == '') call assertEqual('', stations%columns, message=what)
      call assertEqual(1, index(stations%columns, columns), message=what//': '//stations%columns)
   end subroutine accept

   subroutine refuse(what, table, expected, names)
      character(*), intent(in) :: what, table, expected
      character(*), intent(in), optional :: names(:)
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      logical :: sound
      call read_table(table, names, stations, sound, faults)
      call assertFalse(sound, message=what)
      call assertTrue(faults%count > 0, message=what)
      if (faults%count == 0) return
      call assertTrue(index(faults%items(1)%message, expected) > 0, message=what//': '//faults%items(1)%message)
   end subroutine refuse

   subroutine read_table(table, names, stations, sound, faults)
      character(*), intent(in) :: table
      character(*), intent(in), optional :: names(:)
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      type(column_names_type) :: named
      type(error_type), allocatable :: error
      call write_text_file(path, lines_between(table, ';'), error)
      call assertFalse(allocated(error))
      if (present(names)) named%names = names
      call read_survey_file(path, si_units(), stations, sound, faults, named=named)
   end subroutine read_table
end module dg_test_survey_heading
