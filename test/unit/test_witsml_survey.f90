!> WITSML documents as survey files: versions, units, several trajectories, and documents that are refused.
module dg_test_witsml_survey
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_error, only: error_list_type, error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_kinds, only: wp
   use dg_survey_file, only: column_names_type, read_survey_file, station_list_type
   use dg_table_lines, only: lines_between
   use dg_units, only: si_units
   implicit none
   private
   public :: witsml_survey_suite

   character(*), parameter :: path = 'build/test_witsml.xml'
   !> Two stations in feet, the lower one first, another md inside of a station.
   character(*), parameter :: actual = '<trajectory uid="t"><nameWell>Well A-1</nameWell><name>Actual</name>|'// &
      '<trajectoryStation><md uom="ft">3937.007874</md><incl uom="dega">45</incl><azi uom="dega">100</azi>'// &
      '<corUsed><md uom="ft">1</md></corUsed></trajectoryStation>|'// &
      '<trajectoryStation><md uom="ft">0</md><incl uom="dega">0</incl></trajectoryStation></trajectory>|'
   character(*), parameter :: plan = '<trajectory><nameWell>Well B</nameWell><name>Plan</name>|'// &
      '<trajectoryStation><md uom="m">0</md><incl uom="rad">0</incl><azi uom="rad">0</azi></trajectoryStation>|'// &
      '<trajectoryStation><md uom="m">1200</md><incl uom="rad">0.78539816340</incl><azi uom="rad">1.7453292520</azi>'// &
      '</trajectoryStation></trajectory>|'
   character(*), parameter :: head = '<?xml version="1.0" encoding="UTF-8"?>|<trajectorys version="1.4.1.1">|'
   character(*), parameter :: foot = '</trajectorys>'

contains

   function witsml_survey_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('witsml_survey')
      call suite%addTest(TestMethod('versions', test_versions, tearDown=remove))
      call suite%addTest(TestMethod('several_trajectories', test_several, tearDown=remove))
      call suite%addTest(TestMethod('positions', test_positions, tearDown=remove))
      call suite%addTest(TestMethod('refused', test_refused, tearDown=remove))
   end function witsml_survey_suite

   subroutine remove()
      call delete_file(path)
   end subroutine remove

   !> Series 1 over several lines and on one, series 2 with prefixes.
   subroutine test_versions()
      character(*), parameter :: two = '<w:Trajectory xmlns:w="urn:w" xmlns:e="urn:e" schemaVersion="2.1">|'// &
         '<e:Citation><e:Title>Run 3</e:Title></e:Citation><w:Wellbore><e:Title>A-2</e:Title></w:Wellbore>|'// &
         '<w:TrajectoryStation><w:Md uom="m">0</w:Md><w:Incl uom="deg">0</w:Incl></w:TrajectoryStation>|'// &
         '<w:TrajectoryStation><w:Md uom="m">1200</w:Md><w:Incl uom="deg">45</w:Incl><w:Azi uom="deg">100</w:Azi>'// &
         '</w:TrajectoryStation></w:Trajectory>'
      call accept('1.4.1', head//actual//foot, '', "WITSML trajectory 'Actual' of well 'Well A-1', 2 stations")
      call accept('one line', without_bars(head//actual//foot), '', "'Actual'")
      call accept('1.3.1', '<trajectorys version="1.3.1.1">'//plan//foot, '', "'Plan' of well 'Well B'")
      call accept('2.1', two, '', "'Run 3' of well 'A-2'")
   end subroutine test_versions

   !> Which of two is said by its name or by its well.
   subroutine test_several()
      call accept('by name', head//actual//plan//foot, 'plan', "'Plan'")
      call accept('by well', head//actual//plan//foot, 'Well A-1', "'Actual'")
      call refuse('none named', head//actual//plan//foot, '', "'Actual' of well 'Well A-1' (2 stations), 'Plan' of well "// &
                  "'Well B' (2 stations). Name one by survey_well")
      call refuse('no such', head//actual//foot, 'C', "none is called 'C'")
      call refuse('two alike', head//actual//actual//foot, 'Actual', "2 are called 'Actual'")
   end subroutine test_several

   !> Positions that the document lists are read beside its stations.
   subroutine test_positions()
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      logical :: sound
      call read_document('<trajectory><trajectoryStation><md uom="m">0</md><incl uom="dega">0</incl><tvd uom="m">0</tvd>'// &
                         '</trajectoryStation><trajectoryStation><md uom="m">10</md><incl uom="dega">0</incl>'// &
                         '<tvd uom="ft">32.80839895</tvd></trajectoryStation></trajectory>', '', stations, sound, faults)
      call assertTrue(sound)
      call assertEqual(10.0_wp, stations%listed(1, 2), 1.0e-6_wp, message='TVD')
   end subroutine test_positions

   subroutine test_refused()
      call refuse('entities', '<!DOCTYPE a [<!ENTITY b "b">]><a>&b;</a>', '', &
                  'has a document type (DTD), which is not read (line 1)')
      call refuse('outside', '<!DOCTYPE a SYSTEM "file:///etc/passwd"><a/>', '', 'has a document type')
      call refuse('cut', head//'<trajectory>', '', 'is not valid XML')
      call refuse('mismatch', head//'<a></b>', '', 'is not valid XML: mismatched tag (line 3)')
      call refuse('deep', deep_document(), '', 'has elements in each other deeper than 100')
      call refuse('another document', '<wells><well/></wells>', '', 'no trajectoryStation is in it')
      call refuse('gons', head//'<trajectory><trajectoryStation><md uom="m">0</md>|<incl uom="gon">0</incl></trajectoryStation>'// &
                  '</trajectory>'//foot, '', "line 4: the unit of incl, uom = 'gon', is not known")
      call refuse('no unit', head//'<trajectory><trajectoryStation><md>0</md></trajectoryStation></trajectory>'//foot, '', &
                  "the unit of md, uom = '', is not known")
      call refuse('no number', head//'<trajectory><trajectoryStation><md uom="m">O</md></trajectoryStation></trajectory>'//foot, &
                  '', "md = 'O' is not a number")
      call refuse('no inclination', head//'<trajectory><trajectoryStation><md uom="m">0</md></trajectoryStation></trajectory>'// &
                  foot, '', 'a trajectoryStation has no incl')
   end subroutine test_refused

   !> Elements in each other.
   pure function deep_document() result(text)
      character(:), allocatable :: text
      text = repeat('<a>', 101)//repeat('</a>', 101)
   end function deep_document

   pure function without_bars(text) result(line)
      character(*), intent(in) :: text
      character(:), allocatable :: line
      integer :: i
      line = ''
      do i = 1, len(text)
         if (text(i:i) /= '|') line = line//text(i:i)
      end do
   end function without_bars

   !> Reads a document whose lines are parted by | and looks for the last station, and for two in all.
   subroutine accept(what, document, wanted, told)
      character(*), intent(in) :: what, document, wanted
      character(*), intent(in) :: told                 !< in the message
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      real(wp), parameter :: round_off = 1.0e-6_wp
      logical :: sound
      call read_document(document, wanted, stations, sound, faults)
      if (faults%count > 0) call assertEqual('', faults%items(1)%message, message=what)
      call assertTrue(sound, message=what)
      call assertEqual(2, size(stations%md), message=what)
      if (.not. sound .or. size(stations%md) /= 2) return
      call assertEqual(1200.0_wp, stations%md(2), round_off, message=what)
      call assertEqual(45.0_wp, stations%inclination(2)/degree, round_off, message=what)
      call assertEqual(100.0_wp, stations%azimuth(2)/degree, round_off, message=what)
      call assertTrue(index(stations%columns, told) > 0, message=what//': '//stations%columns)
   end subroutine accept

   subroutine refuse(what, document, wanted, expected)
      character(*), intent(in) :: what, document, wanted, expected
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      logical :: sound
      call read_document(document, wanted, stations, sound, faults)
      call assertFalse(sound, message=what)
      call assertTrue(faults%count > 0, message=what)
      if (faults%count == 0) return
      call assertTrue(index(faults%items(1)%message, expected) > 0, message=what//': '//faults%items(1)%message)
   end subroutine refuse

   subroutine read_document(document, wanted, stations, sound, faults)
      character(*), intent(in) :: document, wanted
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      type(column_names_type) :: named
      type(error_type), allocatable :: error
      call write_text_file(path, lines_between(document, '|'), error)
      call assertFalse(allocated(error))
      named%well = wanted
      call read_survey_file(path, si_units(), stations, sound, faults, named=named)
   end subroutine read_document
end module dg_test_witsml_survey
