!> Survey tables as other programs export them. The stations meant are always 0, 500, 1234.5 m; 0, 10, 45.5 deg; 90, 90.25,
!> 100 deg, so that one list checks all forms.
module dg_test_survey_file
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fault_list, only: fault_list_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_kinds, only: wp
   use dg_survey_file, only: read_survey_file, station_list_type
   use dg_table_text, only: split_fields
   use dg_text, only: append_text, text_type
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
      call accept('no unit we know', 'MD (RKB),Incl (X),Azimuth TN|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('which north', 'Measured Depth;Inclination;Azimuth Grid|0;0;90|500;10;90,25|1234,5;45,5;100')
      call accept('plain name before others', 'deviation,md,inc,azi|9,0,0,90|9,500,10,90.25|9,1234.5,45.5,100')
   end subroutine test_headings

   subroutine test_lines_above()
      call accept('titles', 'Company: X, Well: Y|Exported 2024-01-01||MD,Inc,Azi|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('units below', 'MD,Inc,Azi|m,deg,deg|0,0,90|500,10,90.25|1234.5,45.5,100')
      call accept('units below, bracketed', 'MD Inc Azi|(ft) (deg) (deg)|0 0 90|1640.419947507 10 90.25|4050.1968504 45.5 100')
      call accept('empty rows below', 'MD,Inc,Azi|0,0,90|500,10,90.25|1234.5,45.5,100|,,|||')
   end subroutine test_lines_above

   !> What a heading says goes before the units that the deck has.
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
      call refuse('wrapped', '~V|WRAP. YES :|~C|DEPT.M:|DEVI.DEG:|~A|0|0', 'wrapped rows')
      call refuse('no data', '~V|WRAP. NO :|~C|DEPT.M:|DEVI.DEG:', 'no section ~A')
      call refuse('no deviation', '~V|WRAP. NO :|~C|DEPT.M:|GR.GAPI:|~A|0 0', 'name no inc')
   end subroutine test_las

   subroutine test_faults()
      call refuse('no header', '0,0,90|500,10,90', 'the header names no md')
      call refuse('depth of what', 'depth,inc,azi|0,0,90', 'the header names no md')
      call refuse('twice', 'md,inc,md|0,0,0', 'the header names md twice')
      call refuse('short row', 'md,inc,azi|0,0', 'no value for azi')
      call refuse('no number', 'md,inc,azi|0,0,90|500,ten,90', "inc = 'ten' is no number")
      call refuse('empty', '', 'survey file is empty')
      call refuse('gons', 'MD (m),Inc (gon),Azi (gon)|0,0,100|500,11.1,100', "inc in 'gon'")
      call refuse('a length for an angle', 'MD (m),Inc (m),Azi|0,0,90|500,10,90', "inc in 'm'")
      call refuse('kilometres', 'MD [km],Inc,Azi|0,0,90|0.5,10,90', "md in 'km'")
      call refuse('gons in the row of units', 'MD,Inc,Azi|m,gon,gon|0,0,100|500,11.1,100', "inc in 'gon'")
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

   !> Reads the table with lines parted by | and looks for the three stations.
   subroutine accept(what, table, from, to, units)
      character(*), intent(in) :: what, table
      character, intent(in), optional :: from, to      !< letters to change first
      type(unit_system_type), intent(in), optional :: units
      type(station_list_type) :: stations
      type(fault_list_type) :: faults
      type(unit_system_type) :: system
      logical :: sound
      real(wp), parameter :: round_off = 1.0e-7_wp     ! of the feet written above
      system = si_units()
      if (present(units)) system = units
      call write_table(table, from, to)
      call read_survey_file(path, system, stations, sound, faults)
      call assertTrue(sound, message=what)
      if (faults%count > 0) call assertEqual('', faults%items(1)%message, message=what)
      call assertEqual(3, size(stations%md), message=what)
      if (size(stations%md) /= 3) return
      call assertTrue(stations%has_azimuth, message=what)
      call assertEqual([0.0_wp, 500.0_wp, 1234.5_wp], stations%md, round_off, message=what)
      call assertEqual([0.0_wp, 10.0_wp, 45.5_wp], stations%inclination/degree, round_off, message=what)
      call assertEqual([90.0_wp, 90.25_wp, 100.0_wp], stations%azimuth/degree, round_off, message=what)
   end subroutine accept

   subroutine refuse(what, table, expected)
      character(*), intent(in) :: what, table, expected
      type(station_list_type) :: stations
      type(fault_list_type) :: faults
      logical :: sound
      call write_table(table)
      call read_survey_file(path, si_units(), stations, sound, faults)
      call assertFalse(sound, message=what)
      call assertTrue(faults%count > 0, message=what)
      if (faults%count == 0) return
      call assertTrue(index(faults%items(1)%message, expected) > 0, message=what//': '//faults%items(1)%message)
   end subroutine refuse

   subroutine write_table(table, from, to)
      character(*), intent(in) :: table
      character, intent(in), optional :: from, to
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      character(len(table)) :: text
      integer :: first, length, i
      text = table
      do i = 1, len(text)
         if (present(from) .and. present(to)) then
            if (text(i:i) == from) text(i:i) = to
         end if
      end do
      allocate (lines(0))
      first = 1
      do while (first <= len(text))
         length = index(text(first:), '|') - 1
         if (length < 0) length = len(text) - first + 1
         call append_text(lines, text(first:first + length - 1))
         first = first + length + 1
      end do
      call write_text_file(path, lines, error)
      call assertFalse(allocated(error))
   end subroutine write_table
end module dg_test_survey_file
