!> Survey tables as other programs export them. The stations meant are always 0, 500, 1234.5 m; 0, 10, 45.5 deg; 90, 90.25,
!> 100 deg, so that one list checks all forms.
module dg_test_survey_file
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_deck_number, only: read_real
   use dg_error, only: error_list_type, error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_kinds, only: wp
   use dg_survey_file, only: read_survey_file, station_list_type
   use dg_table_text, only: split_fields
   use dg_table_lines, only: lines_between
   use dg_text, only: text_type
   use dg_units, only: field_units, si_units, unit_system_type
   implicit none
   private
   public :: survey_file_suite

   character(*), parameter :: path = 'build/test_survey.txt'
   character(*), parameter :: tab = achar(9)

contains

   function survey_file_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('survey_file')
      call suite%addTest(TestMethod('separators', test_separators, tearDown=remove))
      call suite%addTest(TestMethod('decimal_comma', test_decimal_comma, tearDown=remove))
      call suite%addTest(TestMethod('headings', test_headings, tearDown=remove))
      call suite%addTest(TestMethod('lines_above_and_units_below', test_lines_above, tearDown=remove))
      call suite%addTest(TestMethod('units', test_units, tearDown=remove))
      call suite%addTest(TestMethod('las', test_las, tearDown=remove))
      call suite%addTest(TestMethod('faults', test_faults, tearDown=remove))
      call suite%addTest(TestMethod('numbers_with_commas', test_numbers))
      call suite%addTest(TestMethod('units_beside_a_datum', test_datums, tearDown=remove))
      call suite%addTest(TestMethod('unknown_units', test_unknown_units, tearDown=remove))
      call suite%addTest(TestMethod('rows_of_units', test_unit_rows, tearDown=remove))
      call suite%addTest(TestMethod('titles_that_tell_units', test_titles, tearDown=remove))
      call suite%addTest(TestMethod('marks_between_thousands', test_thousands, tearDown=remove))
      call suite%addTest(TestMethod('cells_and_headings', test_widths, tearDown=remove))
      call suite%addTest(TestMethod('no_value', test_nulls, tearDown=remove))
      call suite%addTest(TestMethod('rows_that_are_skipped', test_skipped, tearDown=remove))
      call suite%addTest(TestMethod('las_units_and_separators', test_las_forms, tearDown=remove))
      call suite%addTest(TestMethod('line_ends', test_line_ends, tearDown=remove))
      call suite%addTest(TestMethod('numbers_to_the_last_digit', test_last_digit))
   end function survey_file_suite

   subroutine remove()
      call delete_file(path)
   end subroutine remove

   subroutine test_separators()
      call accept('comma', 'md,inc,azi|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('tab', 'md;inc;azi|0;0;90|500;10;90.25|1234.5;45.5;100', from=';', to=tab)
      call accept('blanks', '  md   inc  azi |0 0 90|  500  10   90.25|1234.5 45.5 100')
      call accept('blanks in quotes', '"MD" "Inc" "Azi"|"0" 0 90|500 10 90.25|1234.5 45.5 "100"')
      call accept('quoted, as spreadsheets do', '"md","inc","azi","remark"|"0","0","90","tie-on, rig floor"|500,10,90.25,|'// &
                  '1234.5,45.5,100,"TD"')
      call accept('other columns, any order', 'TVD,Azi,DLS,MD,Inc|0,90,0,0,0|500,90.25,1,500,10|900,100,2,1234.5,45.5')
   end subroutine test_separators

   subroutine test_decimal_comma()
      call accept('semicolon', 'md;inc;azi|0,0;0;90|500;10,0;90,25|1234,5;45,5;100,0')
      call accept('tab', 'md;inc;azi|0,0;0;90|500;10,0;90,25|1234,5;45,5;100,0', from=';', to=tab)
      call accept('blanks', 'md inc azi|0,0 0 90|500 10,0 90,25|1234,5 45,5 100,0')
      call accept('points between thousands', 'md;inc;azi|0;0;90|500;10;90,25|1.234,5;45,5;100')
      call accept('commas between thousands', 'md,inc,azi|0,0,90|500,10,90.25|"1,234.5",45.5,100')
   end subroutine test_decimal_comma

   subroutine test_headings()
      call accept('units in brackets', 'MD (m),Inc [deg],Azi (deg)|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('units behind _', 'md_m,inc_deg,azi_deg|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('long names', 'Measured Depth (m),Inclination (deg),Azimuth (deg)|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('long names, blanks between', 'Measured Depth  Inclination  Azimuth|0 0 90|500 10 90.25|1234.5 45.5 100')
      call accept('short names', 'Meas. Depth;Incl.;Azim.|0;0;90|500;10;90,25|1234,5;45,5;100')
      call accept('a datum is no unit', 'MD (RKB),Incl,Azimuth TN|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('which north', 'Measured Depth;Inclination;Azimuth Grid|0;0;90|500;10;90,25|1234,5;45,5;100')
      call accept('plain name before others', 'deviation,md,inc,azi|9,0,0,90|9,500,10,90.25|9,1234.5,45.5,100')
   end subroutine test_headings

   subroutine test_lines_above()
      call accept('titles', 'Company: X, Well: Y|Exported 2024-01-01||MD,Inc,Azi|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('units below', 'MD,Inc,Azi|m,deg,deg|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('units below, bracketed', 'MD Inc Azi|(ft) (deg) (deg)|0 0 90|1640.419947507 10 90.25|4050.1968504 45.5 100')
      call accept('empty rows below', 'MD,Inc,Azi|0,0,90|500,10,90.25|1234.5,45.5,100|,,|||')
   end subroutine test_lines_above

   !> Prefer the units of a heading to those of the deck.
   subroutine test_units()
      call accept('feet in an SI deck', 'MD (ft),Inc,Azi|0,0,90|1640.419947507,10,90.25|4050.1968504,45.5,100')
      call accept('feet of US surveys', 'MD (usft),Inc,Azi|0,0,90|1640.41666666667,10,90.25|4050.18875,45.5,100')
      call accept('radians', 'MD,Inc (rad),Azi (rad)|0,0,1.5707963267949|500,0.174532925199433,1.57515965|'// &
                  '1234.5,0.7941248096574199,1.7453292519943')
      call accept('metres in a field deck', 'md_m,inc,azi|0,0,90|500,10,90.25|1234.5,45.5,100', units=field_units())
      call accept('a field deck', 'md,inc,azi|0,0,90|1640.419947507,10,90.25|4050.1968504,45.5,100', units=field_units())
   end subroutine test_units

   subroutine test_las()
      character(*), parameter :: head = '~Version|VERS. 2.0 : CWLS|WRAP. NO : one line a depth|~Well|STRT.M 0 : first|'// &
         'NULL. -999.25 : no value|~Curve|DEPT.M : measured depth|GR.GAPI : gamma|DEVI.DEG : deviation|HAZI.DEG : azimuth|'
      call accept('LAS', head//'~A DEPT GR DEVI HAZI|0 55 0 90|500 60.2 10 90.25|700 60 -999.25 -999.25|1234.5 -999.25 45.5 100')
      call accept('LAS in feet', '# made up|~V|VERS. 2.0:|~C|DEPT.F:|INCL.DEG:|AZIM.DEG:|~ASCII|0 0 90|'// &
                  '1640.419947507 10 90.25|4050.1968504 45.5 100')
      call refuse('wrapped', '~V|WRAP. YES :|~C|DEPT.M:|DEVI.DEG:|~A|0|0', 'survey: the LAS file has wrapped rows')
      call refuse('no data', '~V|WRAP. NO :|~C|DEPT.M:|DEVI.DEG:', 'no section ~A')
      call refuse('no deviation', '~V|WRAP. NO :|~C|DEPT.M:|GR.GAPI:|~A|0 0', 'names no inc')
   end subroutine test_las

   subroutine test_faults()
      call refuse('no header', '0,0,90|500,10,90', 'the header names no md')
      call refuse('depth of what', 'depth msl,inc,azi|0,0,90', 'the header names no md')
      call refuse('twice', 'md,inc,md|0,0,0', 'the header names md twice')
      call refuse('short row', 'md,inc,azi|0,0', 'no value for azi')
      call refuse('no number', 'md,inc,azi|0,0,90|500,ten,90', "inc = 'ten' is not a number")
      call refuse('empty', '', 'survey file is empty')
      call refuse('gons', 'MD (m),Inc (gon),Azi (gon)|0,0,100|500,11.1,100', "inc in 'gon'")
      call refuse('a length for an angle', 'MD (m),Inc (m),Azi|0,0,90|500,10,90', "inc in 'm'")
      call refuse('kilometres', 'MD [km],Inc,Azi|0,0,90|0.5,10,90', "md in 'km'")
      call refuse('gons in the row of units', 'MD,Inc,Azi|m,gon,gon|0,0,100|500,11.1,100', "inc in 'gon'")
      call refuse('an unknown unit between blanks', 'MD  Inc  Azi|ftRT  radz  radz|0  0  1|500  0.2  1', "inc in 'radz'")
      call refuse('gons in a row above', 'metres,g,m,g|md,Incl,tvd,Azimuth|0,0,0,100|500,11.1,499,100', "inc in 'g'")
      call refuse('UTF-16', char(255)//char(254)//'m'//char(0)//'d'//char(0), 'UTF-16')
   end subroutine test_faults

   subroutine test_numbers()
      call number('1,5', ';', '1.5')
      call number('1,500', ';', '1.500')
      call number('"1,500"', ',', '1500')
      call number('"1,50"', ',', '1.50')
      call number('1,234,567', ';', '1234567')
      call number('1.234,5', ';', '1234.5')
      call number('1,234.5', ';', '1234.5')
      call number('a,b', ';', 'a,b')
      call number('-1,5e3', ' ', '-1.5e3')
   contains
      subroutine number(field, separator, expected)
         character(*), intent(in) :: field, separator, expected
         type(text_type), allocatable :: fields(:)
         call split_fields(field, separator, fields)
         call assertEqual(1, size(fields), message=field)
         call assertEqual(expected, fields(1)%text, message=field)
      end subroutine number
   end subroutine test_numbers

   !> Feet below kelly bushing are feet; a kelly bushing alone is no unit.
   subroutine test_datums()
      character(*), parameter :: feet(22) = [character(20) :: '(ftKB)', '(ft RKB)', '(ftRKB)', '[ft MSL]', '(ft.)', '(FT, GL)', &
         '(feet RKB)', '(RKB) (ft)', '(ft) (RKB)', '(RKB ft)', '(ft below KB)', '(ft-RKB)', '(ftMD)', '(ft MDBRT)', '_ftKB', &
         ' ft RKB', &
         '_ft', ' FT', '(ft DF)', '(f)', '(ft mean sea level)', '(feet MD)']
      character(*), parameter :: metres(12) = [character(30) :: '(RKB)', '(KB)', '(MSL)', '(GL)', '(DF)', '(mRKB)', '(m RKB)', &
         '(mMDRKB)', '(metres below rotary table)', '(m) (KB)', '(-)', '( m )']
      integer :: i
      do i = 1, size(feet)
         call accept(feet(i), 'MD'//trim(feet(i))//';Inc ('//char(194)//char(176)//');Azi (deg TN)|'// &
                     '0;0;90|1640.419947507;10;90.25|4050.1968504;45.5;100')
      end do
      do i = 1, size(metres)
         call accept(metres(i), 'MD '//trim(metres(i))//';Inc (DEG);Azi (degN)|0;0;90|500;10;90.25|1234.5;45.5;100')
      end do
      call accept('feet of US surveys', 'MD (US survey feet RKB);Inc;Azi (GN)|0;0;90|1640.41666666667;10;90.25|4050.18875;45.5;100')
   end subroutine test_datums

   !> A unit that we do not know is never silently one that we do.
   subroutine test_unknown_units()
      character(*), parameter :: lengths(12) = [character(10) :: 'kft', 'km', 'cm', 'in', '0.1in', '0.1 in', 'yd', 'X', &
         'ft x 100', '10 m', 'm/ft', 'deg']
      character(*), parameter :: angles(18) = [character(10) :: 'gon', 'grad', 'g', 'mrad', 'mil', 'mils', '%', 'per cent', &
         'percent', 'rev', 'arcmin', "'", 'deg/30m', 'centesimal', 'm', 'X', 'deg rad', 'RKB']
      integer :: i
      do i = 1, size(lengths)
         call refuse(lengths(i), 'MD ('//trim(lengths(i))//');Inc;Azi|0;0;90|500;10;90', 'survey: md in ')
      end do
      call refuse('a bare kft', 'MD_kft;Inc;Azi|0;0;90|500;10;90', 'survey: md in ')
      do i = 1, size(angles)
         call refuse(angles(i), 'MD;Inc ['//trim(angles(i))//'];Azi|0;0;90|500;10;90', 'survey: inc in ')
         call refuse(angles(i), 'MD;Inc;Azi ('//trim(angles(i))//')|0;0;90|500;10;90', 'survey: azi in ')
      end do
   end subroutine test_unknown_units

   !> Above the headings as below them, and not against them.
   subroutine test_unit_rows()
      character(*), parameter :: head = 'MD,Inc,Azi|', feet = '0,0,90|1640.419947507,10,90.25|4050.1968504,45.5,100', &
                                 metres = '0,0,90|500,10,90.25|1234.5,45.5,100'
      character(*), parameter :: feet_rows(7) = [character(20) :: 'ft,deg,deg', '(ft),(deg),(deg)', 'ftKB,deg,deg', 'ft,,', &
         '"ft","deg","deg"', 'ft RKB,deg,deg TN', 'feet,'//char(176)//','//char(176)]
      character(*), parameter :: wrong_rows(9) = [character(20) :: 'kft,deg,deg', '(kft),(deg),(deg)', 'km,deg,deg', 'm,gon,gon', &
         'm,%,deg', 'm,mrad,mrad', 'm,mil,mil', 'm,xyz,deg', '0.1in,deg,deg']
      integer :: i
      do i = 1, size(feet_rows)
         call accept('above: '//feet_rows(i), trim(feet_rows(i))//'|'//head//feet)
         call accept('below: '//feet_rows(i), head//trim(feet_rows(i))//'|'//feet)
      end do
      do i = 1, size(wrong_rows)
         call refuse('above: '//wrong_rows(i), trim(wrong_rows(i))//'|'//head//metres, '; a heading may name m, ft')
         call refuse('below: '//wrong_rows(i), head//trim(wrong_rows(i))//'|'//metres, '; a heading may name m, ft')
      end do
      call accept('the mark of feet', "',deg,deg|"//head//feet)
      call accept('marks of feet', "',deg,deg,'|MD,Inc,Azi,TVD|0,0,90,0|1640.419947507,10,90.25,1630|4050.1968504,45.5,100,3600")
      call refuse('marks of minutes', "',',deg|"//head//metres, '; a heading may name m, ft')
      call accept('above, with titles', 'Well A, 2024||ft,deg,deg||MD,Inc,Azi|'//feet)
      call accept('above, by blanks', 'ft deg deg|MD Inc Azi|0 0 90|1640.419947507 10 90.25|4050.1968504 45.5 100')
      call accept('a datum alone', 'RKB,deg,deg|'//head//metres)
      call refuse('two units', 'MD (ft),Inc,Azi|m,deg,deg|'//feet, 'names another unit')
   end subroutine test_unit_rows

   !> Use the units of a title where nothing else gives units, unless the deck gives those of this very file.
   subroutine test_titles()
      character(*), parameter :: rows = 'MD,Inc,Azi|0,0,90|500,10,90.25|1234.5,45.5,100'
      call refuse('feet', 'Depths in ft|'//rows, 'speaks of feet')
      call refuse('feet in a comment', '# depth unit: feet|'//rows, 'speaks of feet')
      call refuse('gons', 'Angles in gon|'//rows, 'speaks of other angles')
      call refuse('feet behind the headings', 'MD,Inc,Azi # in ft|0,0,90|500,10,90', 'speaks of feet')
      call refuse('feet below the headings', 'MD,Inc,Azi|# in ft||0,0,90|500,10,90', 'speaks of feet')
      call refuse('feet in another heading', 'MD,Inc,Azi,TVD (ft)|0,0,90,0|500,10,90,499', 'speaks of feet')
      call refuse('metres', 'All depths in metres|'//rows, 'speaks of metres', units=field_units())
      call accept('told by the deck', 'KB elevation 82 ft|'//rows, units_told=.true.)
      call accept('told by the heading', 'KB elevation 82 ft|MD (m),Inc,Azi|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('of the same', 'Depths in metres|'//rows)
   end subroutine test_titles

   !> 1,234 may be one thousand or one: the table must tell.
   subroutine test_thousands()
      call accept('both marks', 'md;inc;azi|0;0;90|500;10;90.25|1,234.5;45.5;100')
      call accept('both marks, the other way', 'md;inc;azi|0;0;90|500;10;90,25|1.234,5;45,5;100')
      call accept('three decimals', 'md;inc;azi|0,000;0,000;90,000|500,000;10,000;90,250|1234,500;45,500;100,000')
      call refuse('whole thousands', 'md;inc;azi|0;0;90|1,000;10.5;90.25|2,000;45.5;100', 'may have a decimal comma or one between')
      call refuse('whole numbers', 'md;inc;azi|0;0;90|1,000;10;90|2,000;45;100', 'may have a decimal comma or one between')
      call refuse('points', 'md;inc;azi|0;0;90|1.000;10,5;90,25|2.000;45,5;100', 'may have a decimal point or one between')
      call refuse('quoted', 'md,inc,azi|0,0,"90,25"|"1,000",10,90|"2,000",45,100', 'may have a decimal comma or one between')
      call refuse('blanks between', 'md;inc;azi|0;0;90|1 234,5;45,5;100', "md = '1 234,5' is not a number")
      call refuse('apostrophes', "md;inc;azi|0;0;90|1'234.5;45.5;100", 'is not a number')
      call refuse('between blanks', 'md inc azi|0 0 90|1 034.5 45.5 100', 'number in column 4')
      call refuse('wrong places', 'md;inc;azi|0;0;90|12,34.5;45.5;100', "md = '12,34.5' is not a number")
      call refuse('two commas', 'md;inc;azi|0;0;90|1,,5;45.5;100', "md = '1,,5' is not a number")
   end subroutine test_thousands

   !> Each number belongs to one heading.
   subroutine test_widths()
      call accept('a remark behind', 'md inc azi|0 0 90 tie-on|500 10 90.25|1234.5 45.5 100 TD')
      call accept('columns without names', 'md,,inc,,azi,,|0,1,0,1,90|500,,10,,90.25|1234.5,,45.5,,100,,,')
      call accept('commas in headings', 'MD, m;Inc, deg;Azi, deg|0;0;90|500;10;90.25|1234.5;45.5;100', from=';', to=tab)
      call refuse('decimal commas between commas', 'md,inc,azi|0,0,0,0,90,0|500,5,10,5,90,25', 'number in column 4')
      call refuse('numbered rows', 'md,inc,azi|1,0,0,90|2,500,10,90', 'number in column 4')
      call refuse('an empty cell between blanks', 'md inc azi dls|0 0 90 0|500 90 1', 'has 3 columns, the header names 4')
      call accept('units among headings', 'MD m Inc deg Azi deg|0 0 90|500 10 90.25|1234.5 45.5 100')
      call refuse('units among headings', 'MD m Inc deg TVD m|0 0|500 10', 'the header names no inc')
   end subroutine test_widths

   !> A row without a value has no station, whichever of the three it is; a vertical hole needs no azimuth.
   subroutine test_nulls()
      character(*), parameter :: head = '~V|VERS. 2.0 :|WRAP. NO :|~W|NULL. -999.25 :|~C|DEPT.M :|DEVI.DEG :|HAZI.DEG :|~A|'
      call accept('no azimuth', head//'0 0 90|500 10 90.25|700 60 -999.25|1234.5 45.5 100')
      call accept('no inclination', head//'0 0 90|500 10 90.25|700 -999.25 90|1234.5 45.5 100')
      call accept('nothing', head//'0 0 90|500 10 90.25|-999.25 -999.25 -999.25|1234.5 45.5 100')
      call accept('glued', '~V|WRAP.NO :|~W|NULL.-999.25 :|~C|DEPT.M :|DEVI.DEG :|HAZI.DEG :|~A|0 0 90|500 10 90.25|'// &
                  '700 60 -999.25|1234.5 45.5 100')
      call accept('vertical', head//'0 0 -999.25|500 10 90.25|1234.5 45.5 100', first_azimuth=0.0_wp)
   end subroutine test_nulls

   subroutine test_las_forms()
      character(*), parameter :: well = '~W|STRT.M 0 :|~C|', rows = '0 0 90|500 10 90.25|1234.5 45.5 100', &
                                 feet = '0 0 90|1640.419947507 10 90.25|4050.1968504 45.5 100'
      call refuse('tenths of an inch', '~V|WRAP. NO :|'//well//'DEPT.0.1IN :|DEVI.DEG :|HAZI.DEG :|~A|'//rows, "md in '0.1in'")
      call refuse('tenths of an inch, short', '~V|WRAP. NO :|'//well//'DEPT..1IN :|DEVI.DEG :|HAZI.DEG :|~A|'//rows, "md in '.1in'")
      call refuse('thousands', '~V|WRAP. NO :|'//well//'DEPT.1000 FT :|DEVI.DEG :|HAZI.DEG :|~A|'//rows, "md in '1000'")
      call refuse('per cent', '~V|WRAP. NO :|'//well//'DEPT.M :|DEVI.% :|HAZI.DEG :|~A|'//rows, "inc in '%'")
      call accept('kelly bushing', '~V|WRAP. NO :|'//well//'DEPT.FTKB :|DEVI.DEG :|HAZI.DEG :|~A|'//feet)
      call accept('unit of the first depth', '~V|WRAP. NO :|~W|STRT.FT 0 :|~C|DEPT. :|DEVI. :|HAZI. :|~A|'//feet)
      call accept('no unit', '~V|WRAP. NO :|~W|STRT. 0 :|~C|DEPT. :|DEVI. :|HAZI. :|~A|'//rows)
      call accept('3.0, commas', '~V|VERS. 3.0 :|WRAP. NO :|DLM. COMMA :|'//well//'DEPT.M :|DEVI.DEG :|HAZI.DEG :|~A|'// &
                  '0,0,90|500,10,90.25|1234.5,45.5,100')
      call refuse('glued WRAP', '~V|WRAP.YES :|'//well//'DEPT.M :|DEVI.DEG :|HAZI.DEG :|~A|0|0 90', 'wrapped rows')
      call refuse('a value missing', '~V|WRAP. NO :|'//well//'DEPT.M :|DEVI.DEG :|HAZI.DEG :|GR.GAPI :|~A|0 0 90', 'has 3 columns')
   end subroutine test_las_forms

   !> LF, CR LF and CR, also where one falls between two pieces in which a file is read.
   subroutine test_line_ends()
      character(*), parameter :: ends(4) = [character(3) :: achar(10), achar(13)//achar(10), achar(13), &
                                            achar(13)//achar(13)//achar(10)]
      integer, parameter :: piece = 65536
      character(:), allocatable :: eol
      integer :: i, length, unit, status
      do i = 1, size(ends)
         eol = trim(ends(i))
         do length = piece - 3, piece + 1
            open (newunit=unit, file=path, access='stream', form='unformatted', status='replace', iostat=status)
            call assertEqual(0, status, message='open '//path)
            if (status /= 0) return
            write (unit) '#'//repeat('x', length - 1)//eol//'md,inc,azi'//eol//'0,0,90'//eol//'500,10,90.25'//eol//eol// &
               '1234.5,45.5,100'
            close (unit)
            call check('ends '//achar(iachar('0') + i), si_units(), .false.)
         end do
      end do
   end subroutine test_line_ends

   !> The way that is quick gives the very double that the processor's own reading gives.
   subroutine test_last_digit()
      integer, parameter :: tries = 20000, digits = 17
      character(40) :: text
      real(wp) :: number, expected, draw(3)
      integer :: i, length, point, worst
      logical :: legal
      worst = 0
      do i = 1, tries
         call random_number(draw)
         length = 1 + int(draw(1)*digits)
         point = int(draw(2)*(length + 1))
         write (text, '(f0.17)') draw(3)                   ! digits behind the point
         text = text(index(text, '.') + 1:)
         text = text(:point)//'.'//text(point + 1:length)
         if (point > length/2) text = '-'//text
         read (text, *) expected
         call read_real(trim(text), number, legal)
         call assertTrue(legal, message=text)
         if (abs(number - expected) > 0.0_wp) worst = worst + 1
      end do
      call assertEqual(0, worst, message='numbers that differ')
   end subroutine test_last_digit

   !> Reads the table with lines parted by | and looks for the three stations.
   subroutine accept(what, table, from, to, units, units_told, first_azimuth)
      character(*), intent(in) :: what, table
      character, intent(in), optional :: from, to      !< letters to change first
      type(unit_system_type), intent(in), optional :: units
      logical, intent(in), optional :: units_told
      real(wp), intent(in), optional :: first_azimuth  !< of the first station [deg]; absent: 90
      type(unit_system_type) :: system
      logical :: told
      system = si_units()
      if (present(units)) system = units
      told = .false.
      if (present(units_told)) told = units_told
      call write_table(table, from, to)
      call check(what, system, told, first_azimuth)
   end subroutine accept

   !> The three stations in the table that was written.
   subroutine check(what, units, units_told, first_azimuth)
      character(*), intent(in) :: what
      type(unit_system_type), intent(in) :: units
      logical, intent(in) :: units_told
      real(wp), intent(in), optional :: first_azimuth
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      logical :: sound
      real(wp) :: azimuth
      real(wp), parameter :: round_off = 1.0e-7_wp     ! of the feet written above
      azimuth = 90.0_wp
      if (present(first_azimuth)) azimuth = first_azimuth
      call read_survey_file(path, units, stations, sound, faults, units_told)
      call assertTrue(sound, message=what)
      if (faults%count > 0) call assertEqual('', faults%items(1)%message, message=what)
      call assertEqual(3, size(stations%md), message=what)
      if (size(stations%md) /= 3) return
      call assertTrue(stations%has_azimuth, message=what)
      call assertEqual([0.0_wp, 500.0_wp, 1234.5_wp], stations%md, round_off, message=what)
      call assertEqual([0.0_wp, 10.0_wp, 45.5_wp], stations%inclination/degree, round_off, message=what)
      call assertEqual([azimuth, 90.25_wp, 100.0_wp], stations%azimuth/degree, round_off, message=what)
   end subroutine check

   !> Rows that hold a station and are not read are counted in words; other comments are not.
   subroutine test_skipped()
      call skip('none', '# 0 is surface|md,inc,azi|0,0,90|# 2 more:|500,10,90.25|1234.5,45.5,100', '')
      call skip('commented', 'md,inc,azi|0,0,90|500,10,90.25|#700,80,90|# 800, 80, 90|1234.5,45.5,100', &
                'rows skipped: 2 that begin with # (first in line 4)')
      call skip('between blanks', 'md inc azi|0 0 90|500 10 90.25|# 700 80 90|1234.5 45.5 100', &
                'rows skipped: 1 that begin with # (first in line 4)')
      call skip('decimal comma', 'md;inc;azi|0;0;90|500;10;90,25|#700,5;80,0;90|1234,5;45,5;100', &
                'rows skipped: 1 that begin with # (first in line 4)')
      call skip('above the header', '0,0,90|Well 3, 4|md,inc,azi|0,0,90|500,10,90.25|1234.5,45.5,100', &
                'rows skipped: 1 above the header (first in line 1)')
      call skip('without a value', '~Version|VERS. 2.0:|WRAP. NO:|~Well|NULL. -999.25:|~Curve|DEPT.M :|DEVI.DEG :|HAZI.DEG :|'// &
                '~ASCII|0 0 90|250 -999.25 90|500 10 90.25|1234.5 45.5 100', 'rows skipped: 1 without a value (first in line 12)')
   end subroutine test_skipped

   !> The stations in a table of which rows are skipped, and the words for these.
   subroutine skip(what, table, expected)
      character(*), intent(in) :: what, table, expected
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      logical :: sound
      call accept(what, table)
      call read_survey_file(path, si_units(), stations, sound, faults)
      call assertEqual(expected, stations%skipped, message=what)
   end subroutine skip

   subroutine refuse(what, table, expected, units)
      character(*), intent(in) :: what, table, expected
      type(unit_system_type), intent(in), optional :: units
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      type(unit_system_type) :: system
      logical :: sound
      system = si_units()
      if (present(units)) system = units
      call write_table(table)
      call read_survey_file(path, system, stations, sound, faults)
      call assertFalse(sound, message=what)
      call assertTrue(faults%count > 0, message=what)
      if (faults%count == 0) return
      call assertTrue(index(faults%items(1)%message, expected) > 0, message=what//': '//faults%items(1)%message)
   end subroutine refuse

   subroutine write_table(table, from, to)
      character(*), intent(in) :: table
      character, intent(in), optional :: from, to
      type(error_type), allocatable :: error
      character(len(table)) :: text
      integer :: i
      text = table
      do i = 1, len(text)
         if (present(from) .and. present(to)) then
            if (text(i:i) == from) text(i:i) = to
         end if
      end do
      call write_text_file(path, lines_between(text, '|'), error)
      call assertFalse(allocated(error))
   end subroutine write_table
end module dg_test_survey_file
