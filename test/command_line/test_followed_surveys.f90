!> Advice of messages about a survey file: it is followed, and the message is gone. Lines of a file are parted by semicolons.
module dg_test_followed_surveys
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: deck_path, run_program, run_type, scratch
   use dg_test_survey_runs, only: check_survey => check
   implicit none
   private
   public :: followed_surveys_suite

   character(*), parameter :: sound = 'MD,Inc,Azi;0,0,0;1400,10,10'

contains

   function followed_surveys_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('followed_surveys')
      call suite%addTest(TestMethod('rows', test_rows))
      call suite%addTest(TestMethod('headings', test_headings))
      call suite%addTest(TestMethod('other_kinds_of_file', test_kinds))
      call suite%addTest(TestMethod('positions_and_parents', test_others))
      call suite%addTest(TestMethod('columns', test_columns))
      call suite%addTest(TestMethod('hole_above', test_above))
      call suite%addTest(TestMethod('documents', test_documents))
   end function followed_surveys_suite

   !> A file has a message with `expected`; the file that follows the advice is read without it. `keys`: of &trajectory, before and
   !> after; parents likewise.
   subroutine follow(faulty, expected, followed, keys, new_keys, parent, new_parent)
      character(*), intent(in) :: faulty, expected, followed
      character(*), intent(in), optional :: keys, new_keys, parent, new_parent
      type(run_type) :: run
      character(:), allocatable :: before, after
      before = ''
      after = ''
      if (present(keys)) before = keys
      if (present(new_keys)) after = new_keys
      run = check_survey(faulty, before, parent)
      call assertTrue(index(run%output//run%diagnostics, expected) > 0, &
                      message='wanted: '//expected//'; got: '//run%output//run%diagnostics)
      run = check_survey(followed, after, new_parent)
      call assertEqual(0, run%status, message='followed: '//expected//'; got: '//run%diagnostics)
      call assertEqual(0, index(run%output//run%diagnostics, expected), message='followed: '//expected)
   end subroutine follow

   !> Cells and rows.
   subroutine test_rows()
      character(*), parameter :: no_station = 'Put # before a line that is not a station'
      call follow('MD,Inc,Azi;0,0,0;700,,10;1400,10,10', 'no value for inc. '//no_station, 'MD,Inc,Azi;0,0,0;#700,,10;1400,10,10')
      call follow('MD,Inc,Azi;0,0,0;700,x1,10;1400,10,10', 'is not a number. '//no_station, &
                  'MD,Inc,Azi;0,0,0;#700,x1,10;1400,10,10')
      call follow('MD,Inc,Azi;0,0,0;1400,200,10', 'is out of range; needs a number, 0 to 180', sound)
      call follow('Inc,MD,Azi;0,0,0;350,4,10;700,7,10;1000,9,10;1400,10,10', 'survey.csv:3: survey: inc = 350 is out of range; '// &
                  'needs a number, 0 to 180 deg. So are 3 more stations. Do the columns stand below their headings?'// &
                  achar(10), 'MD,Inc,Azi;0,0,0;350,4,10;700,7,10;1000,9,10;1400,10,10')
      call follow('MD,Inc,Azi;0,0,0;1400,10,N10E', 'Write azimuths from 0 to 360 deg', sound)
      call follow('MD,Inc,Azi;0,0,0;#REF!,5,10;1400,10,10', 'an error of a spreadsheet. Give its number', &
                  'MD,Inc,Azi;0,0,0;700,5,10;1400,10,10')
      call follow('Well,MD,Inc,Azi;A,0,0,0;B,700,5,10;A,1400,10,10', 'Keep the rows of one well', &
                  'Well,MD,Inc,Azi;A,0,0,0;A,1400,10,10')
      call follow('MD,Inc,Azi;0,0,0;1400,10,10,7', 'give each column a name, and write decimals with', &
                  'MD,Inc,Azi,DLS;0,0,0;1400,10,10,7')
      call follow('MD Inc Azi;0 0 0;1,400 10 10', 'write numbers without marks between thousands, with decimal points', &
                  'MD Inc Azi;0 0 0;1400 10 10')
   end subroutine test_rows

   !> Names and units of columns.
   subroutine test_headings()
      character(*), parameter :: feet = 'MD,Inc,Azi;0,0,0;4593,10,10'
      call follow('MD,Inc,MD,Azi;0,0,0,0;1400,10,1400,10', 'the header names md twice; keep one', sound)
      call follow('depths in feet;MD,Inc,Azi;0,0,0;4600,10,10', 'name the unit in the heading, as in MD (ft)', &
                  'depths in feet;MD (ft),Inc,Azi;0,0,0;4600,10,10')
      call follow(feet, 'the survey ends at 4593 m, 3.304 times as deep as bit and hole. Is it in ft? In a file write '// &
                  "survey_units = 'field'", feet, new_keys=", survey_units = 'field'")
      call follow('MD,Inc,Azi;0,0,0.61;500,20,0.61;900,40,0.8;1400,60,1.3', 'In a file write its unit into the heading: '// &
                  'Azi (rad)', 'MD,Inc,Azi (rad);0,0,0.61;500,20,0.61;900,40,0.8;1400,60,1.3')
      call follow('MD,Inc deg,Inc min,Azi;0,0,0,0;1400,10,30,10', 'inclination and azimuth in decimal degrees, one column each', &
                  'MD,Inc,Azi;0,0,0;1400,10.5,10')
      call follow('Tiefe a,Inc,Azi;0,0,0;1400,10,10', 'Or name the column in &trajectory by md_column', &
                  'Tiefe a,Inc,Azi;0,0,0;1400,10,10', new_keys=", md_column = 'Tiefe a'")
   end subroutine test_headings

   !> Files that are no text, by their first bytes.
   subroutine test_kinds()
      character(*), parameter :: zip = 'PK'//char(3)//char(4)
      call follow(zip//'[Content_Types].xml', 'Save the sheet as CSV, and name that file', sound)
      call follow(zip//'word/', 'Save its table as CSV, and name that file', sound)
      call follow(zip//'other', 'Save the sheet as CSV, or unpack the archive', sound)
      call follow('%PDF-1.4', 'or copy its table to a sheet and save that as CSV', sound)
      call follow(char(31)//char(139)//'x', 'Unpack it, and name the file that was in it', sound)
      call follow('{\rtf1', 'Save it as plain text or CSV, and name that file', sound)
      call follow('<html><table>', 'Open it in a spreadsheet, save the sheet as CSV, and name that file', sound)
      call follow('{"md": [0]}', 'Export the survey as CSV, and name that file', sound)
   end subroutine test_kinds

   !> Columns that the header leaves open.
   subroutine test_columns()
      character(*), parameter :: twice = 'MD,Inc,Azimuth,Azi;0,0,0,0;1400,10,10,12', other = 'Tiefe a,Inc,Azi;0,0,0;1400,10,10'
      character(*), parameter :: north = 'MD,Inc,Azimuth TN,Azimuth GN;0,0,0,0;1400,10,10,12', blanks = 'MD Inc Azi Bit Run;'
      call follow('Foo,MD a,MD a,Inc,Azi;1,0,0,0,0;1,1400,5,10,10', 'stands twice in the header. Rename one of them', &
                  'Foo,MD a,MD b,Inc,Azi;1,0,0,0,0;1,1400,5,10,10', ", md_column = 'MD a'", ", md_column = 'MD a'")
      call follow(other, "Did you mean 'Tiefe a'?", other, ", md_column = 'Tiefe b'", ", md_column = 'Tiefe a'")
      call follow('MD (furlong),Inc,Azi;0,0,0;7,10,10', 'a heading may name m, ft or usft, deg or rad', &
                  'MD (m),Inc,Azi;0,0,0;1408,10,10')
      call follow('MD,Inc (gon),Azi;0,0,0;1400,11,10', 'or usft, deg or rad', 'MD,Inc (deg),Azi;0,0,0;1400,9.9,10')
      call follow(';0,0.00,0.00;700,0,10;1400,10,10', 'survey.csv:2: survey: the header names no md and no inc, it holds '// &
                  'numbers. Write a line with the names of the columns above it, as MD,Inc,Azi', ';'//sound)
      call follow('0 0 0 7;1400 10 80 7', 'above it, as MD Inc Azi', 'MD Inc Azi TF;0 0 0 7;1400 10 80 7')
      call follow('', 'it needs a header naming md, inc, azi', sound)
      call follow(blanks//'0 0 0 1;1400 10 80 1', 'no heading of two words: separate them by commas or tabs', &
                  'MD,Inc,Azi,Bit Run;0,0,0,1;1400,10,80,1')
      call follow(twice, "Name one in &trajectory: azi_column = 'Azimuth'", twice, new_keys=", azi_column = 'Azimuth'")
      call follow(north, 'To take another: azi_column', north, new_keys=", azi_column = 'Azimuth TN'")
      call follow(char(255)//char(254)//'M'//char(0)//'D'//char(0), 'its text is UTF-16; save it as UTF-8', sound)
   end subroutine test_columns

   !> The hole above a survey that begins inclined.
   subroutine test_above()
      character(*), parameter :: slant = 'MD,Inc,Azi;30,45,10;300,60,10;1400,90,10', vertical = ", tie_on = 'vertical'"
      character(*), parameter :: side = 'MD,Inc,Azi;1010,30.5,46;1100,35,60;1400,60,80', key = ", parent_file = 'parent.csv'"
      character(*), parameter :: parent = 'MD,Inc,Azi;0,0,0;500,0,0;800,20,45;1000,30,45'
      call follow(side, "For a sidetrack give parent_file = 'FILE'", side, new_keys=key, new_parent=parent)
      call follow(side, "parent_file is empty. Give a path relative to the deck", side, ", parent_file = ''", key, &
                  new_parent=parent)
      call follow(side, "For a slant well or a river crossing give tie_on = 'straight'", side, new_keys=", tie_on = 'straight'")
      call follow(slant, 'Warning: holes hardly turn by more than', slant, vertical, ", tie_on = 'straight'")
      call follow(slant, 'For a sidetrack give parent_file, for a slant well', slant, vertical, key, &
                  new_parent='MD,Inc,Azi;0,45,10;20,45,10')
   end subroutine test_above

   !> An XML document with several trajectories, or none, or on a machine without the library that reads it: an empty file stands
   !> for the library.
   subroutine test_documents()
      character(*), parameter :: head = '<trajectorys version="1.4.1.1">', foot = '</trajectorys>'
      character(*), parameter :: stations = '<trajectoryStation><md uom="m">0</md><incl uom="dega">0</incl></trajectoryStation>'// &
         '<trajectoryStation><md uom="m">1400</md><incl uom="dega">10</incl><azi uom="dega">10</azi></trajectoryStation>'
      character(*), parameter :: one = '<trajectory><name>Plan</name>'//stations//'</trajectory>'
      character(*), parameter :: other = '<trajectory><name>Actual</name>'//stations//'</trajectory>'
      type(run_type) :: run
      call follow(head//one//other//foot, 'Name one by survey_well', head//one//other//foot, new_keys=", survey_well = 'Actual'")
      call follow('<wells><well/></wells>', 'Export the survey as CSV', sound)
      call follow('<wells><well/></wells>', 'or as a WITSML trajectory', head//one//foot)
      run = check_survey(head//one//foot, '')
      call assertEqual(0, run%status, message='with the library: '//run%diagnostics)
      call execute_command_line(': > '//scratch//'/libexpat.so.1')
      run = run_program('--check '//deck_path, 'LD_LIBRARY_PATH='//scratch)
      call assertEqual(2, run%status, message='without the library')
      call assertTrue(index(run%diagnostics, 'Install it (package libexpat1), or export the survey as CSV') > 0, &
                      message=run%diagnostics)
   end subroutine test_documents

   !> Positions that the file lists, and the hole that a sidetrack leaves.
   subroutine test_others()
      character(*), parameter :: listed = 'MD,Inc,Azi,TVD,N/S,E/W;0,0,0,100,5,7;471.238898,90,0,400,305,7;1400,90,0,400,'
      character(*), parameter :: side = 'MD,Inc,Azi;1010,30.5,46;1100,35,60;1400,60,80', key = ", parent_file = 'parent.csv'"
      character(*), parameter :: parent = 'MD,Inc,Azi;0,0,0;1000,30,'
      call follow(listed//'1033.76,7', 'Check columns, units and the north', listed//'1233.76,7')
      call follow(side, 'Warning: check that both surveys count depth', side, key, key, parent//'90;1500,30,90', &
                  parent//'45;1500,30,45')
      call follow(sound, 'Leave parent_file out', sound, key, parent=parent//'45')
   end subroutine test_others
end module dg_test_followed_surveys
