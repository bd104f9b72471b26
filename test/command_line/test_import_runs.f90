!> Decks made from cases of other programs: an EDM export, WITSML documents, and files that are refused.
module dg_test_import_runs
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_program_run, only: clear_scratch, replaced, run_program, run_type, scratch
   use dg_text, only: append_text, text_list, text_type
   implicit none
   private
   public :: import_runs_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: of = ' well_id="W" wellbore_id="B" '
   !> A bar stands for the end of a line. Stations are in no order, and sections of casing lie in each other.
   character(*), parameter :: survey = '<export>|<CD_WELL well_id="W" well_common_name="Tern 3"/>|'// &
      '<CD_WELLBORE well_id="W" wellbore_id="B" wellbore_name="Tern 3 OH"/>|'// &
      '<CD_DEFINITIVE_SURVEY_HEADER'//of//'def_survey_header_id="P" phase="PLAN" name="Plan"/>|'// &
      '<CD_DEFINITIVE_SURVEY_HEADER'//of//'def_survey_header_id="A" phase="ACTUAL" name="Final"/>|'// &
      '<CD_DEFINITIVE_SURVEY_STATION'//of//'def_survey_header_id="P" md="7" inclination="0"/>|'// &
      '<CD_DEFINITIVE_SURVEY_STATION'//of//'def_survey_header_id="A" md="0" inclination="0" azimuth=""/>|'// &
      '<CD_DEFINITIVE_SURVEY_STATION'//of//'def_survey_header_id="A" md="9000" inclination="52" azimuth="88"/>|'// &
      '<CD_DEFINITIVE_SURVEY_STATION'//of//'def_survey_header_id="A" md="5000" inclination="50" azimuth="86"/>|'
   character(*), parameter :: holes = '<CD_CASE'//of//'case_name="Drill" hole_sect_group_id="G" assembly_id="A1"/>|'// &
      '<CD_HOLE_SECT'//of//'hole_sect_group_id="G" sect_type_code="CAS" id_casing="12.415" length="2500" md_shoe="2500"/>|'// &
      '<CD_HOLE_SECT'//of//'hole_sect_group_id="G" sect_type_code="CAS" id_casing="8.681" length="6000" md_shoe="6000" '// &
      'cof="0.2" catalog_key_desc="9 5/8 in"/>|'// &
      '<CD_HOLE_SECT'//of//'hole_sect_group_id="G" sect_type_code="OPEN" hole_size="8.5" length="3200" md_shoe="9200"/>|'// &
      '<CD_HOLE_SECT'//of//'hole_sect_group_id="H" sect_type_code="OPEN" hole_size="6" length="9200" md_shoe="9200"/>|'
   character(*), parameter :: string = '<CD_ASSEMBLY'//of//'assembly_id="A0" string_type="Casing" assembly_name="Casing"/>|'// &
      '<CD_ASSEMBLY'//of//'assembly_id="A1" string_type="Drillstring" assembly_name="8 1/2&quot; BHA" '// &
      'md_assembly_base="8900"/>|'// &
      '<CD_ASSEMBLY_COMP'//of//'assembly_id="A1" sequence_no="1" sect_type_code="DP" description="Pipe" od_body="5" '// &
      'id_body="4.276" length="8300" approximate_weight="21.4" od_connection="6.625" min_yield_stress="135000"/>|'// &
      '<CD_ASSEMBLY_COMP'//of//'assembly_id="A1" sequence_no="2" sect_type_code="DC" description="Collar" od_body="6.75" '// &
      'id_body="2.8125" length="180" approximate_weight="100" min_yield_stress="15840000"/>|'// &
      '<CD_ASSEMBLY_COMP'//of//'assembly_id="A1" sequence_no="3" sect_type_code="BIT" description="PDC" od_body="8.5" '// &
      'length="1"/>|'
   character(*), parameter :: fluid = '<CD_FLUID'//of//'fluid_name="OBM" density="11.2"/>|'
   character(*), parameter :: foot = '</export>|'
   character(*), parameter :: edm = survey//holes//string//fluid//foot

   character(*), parameter :: trajectory = '<trajectorys version="1.4.1.1"><trajectory><nameWell>Auk 9</nameWell>|'// &
      '<name>Actual</name>|<trajectoryStation><md uom="m">0</md><incl uom="dega">0</incl></trajectoryStation>|'// &
      '<trajectoryStation><md uom="m">2600</md><incl uom="dega">45</incl><azi uom="dega">120</azi></trajectoryStation>|'// &
      '</trajectory></trajectorys>|'
   character(*), parameter :: tubular = '<tubulars version="1.3.1.1"><tubular><nameWell>Auk 9</nameWell><name>BHA</name>|'// &
      '<tubularComponent><sequence>2</sequence><typeTubularComp>drill pipe</typeTubularComp><od uom="in">5</od>'// &
      '<id uom="m">0.1086</id><len uom="m">2500</len><wtPerLen uom="lbm/ft">21.4</wtPerLen>'// &
      '<connection><od uom="mm">168.3</od></connection></tubularComponent>|'// &
      '<tubularComponent><sequence>1</sequence><typeTubularComp>mud motor</typeTubularComp><od uom="mm">171</od>'// &
      '<len uom="ft">30</len><bend><angle uom="dega">1.15</angle></bend></tubularComponent>|</tubular></tubulars>|'
   character(*), parameter :: geometry = '<w:WellboreGeometry xmlns:w="urn:w" xmlns:e="urn:e" schemaVersion="2.1">|'// &
      '<w:Wellbore><e:Title>Auk 9</e:Title></w:Wellbore><w:WellboreGeometrySection><w:TypeHoleCasing>casing'// &
      '</w:TypeHoleCasing><w:SectionMdInterval><e:MdTop uom="m">100</e:MdTop><e:MdBase uom="m">1400</e:MdBase>'// &
      '</w:SectionMdInterval><w:IdSection uom="in">8.681</w:IdSection></w:WellboreGeometrySection>|'// &
      '<w:WellboreGeometrySection><w:TypeHoleCasing>open hole</w:TypeHoleCasing><w:SectionMdInterval>'// &
      '<e:MdTop uom="m">1400</e:MdTop><e:MdBase uom="m">3000</e:MdBase></w:SectionMdInterval>'// &
      '<w:IdSection uom="in">8.5</w:IdSection></w:WellboreGeometrySection></w:WellboreGeometry>|'
   character(*), parameter :: report = '<fluidsReports><fluidsReport><nameWell>Auk 9</nameWell><fluid>'// &
      '<density uom="g/cm3">1.31</density></fluid></fluidsReport></fluidsReports>|'

contains

   function import_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('import_runs')
      call suite%addTest(TestMethod('edm', test_edm))
      call suite%addTest(TestMethod('witsml', test_witsml))
      call suite%addTest(TestMethod('missing_values', test_missing))
      call suite%addTest(TestMethod('hostile_names', test_hostile))
      call suite%addTest(TestMethod('which_well', test_which))
      call suite%addTest(TestMethod('advice_followed', test_followed))
      call suite%addTest(TestMethod('refused', test_refused))
   end function import_runs_suite

   !> Survey of the actual header, narrowest casing, string from the bit, in field units and in SI.
   subroutine test_edm()
      type(run_type) :: run
      run = imported(text_list(edm), '')
      call expect(run%output, "  md = 0, 5000, 9000"//newline//"  inc = 0, 50, 52"//newline//"  azi = 0, 86, 88")
      call expect(run%output, "! GUESSED: survey Final, of 'Plan (plan)', 'Final (actual)'")
      call expect(run%output, "  name = '9 5/8 in'"//newline//'  md_top = 0'//newline//'  md_bottom = 6000'//newline// &
                  '  diameter = 8.681'//newline//'  friction = 0.2'//newline//'  cased = .true.')
      call expect(run%output, '  md_bottom = 9000                      ! end of the survey'//newline//'  diameter = 8.5'// &
                  newline//'  friction = 0.3                        ! GUESSED')
      call assertTrue(index(run%output, "'PDC'") < index(run%output, "'Collar'"), message=run%output)
      call assertTrue(index(run%output, "'Collar'") < index(run%output, "'Pipe'"), message=run%output)
      call expect(run%output, '  mass = 100'//newline//'  yield = 110'//newline)
      call expect(run%output, 'to surface; the file: 8300')
      call expect(run%output, '  density = 11.2'//newline)
      call expect(run%output, 'bit_depth = 8900 /')
      run = imported(text_list(edm), '--units SI')
      call expect(run%output, '  md = 0, 1524, 2743.2')
      call expect(run%output, '  density = 1342.056')
      call expect(run%output, '  od = 171.45')
      run = imported(text_list(replaced(replaced(edm, 'md="0"', 'md="-80"'), '<CD_CASE', &
                                         '<CD_DATUM datum_elevation="82.5" is_default="Y"/><CD_CASE')), '')
      call expect(run%output, 'md = 2.5, 5082.5, 9082.5')
      call expect(run%output, '82.5 ft added')
      run = imported(text_list(replaced(edm, 'hole_size="8.5" length="3200" md_shoe="9200"/>', 'hole_size="8.5" '// &
                                        'md_shoe="9200"/><CD_HOLE_SECT'//of// &
                                        'hole_sect_group_id="G" hole_size="10.5" md_shoe="7000"/>')), '')
      call expect(run%output, '  md_top = 6000'//newline//'  md_bottom = 7000'//newline//'  diameter = 10.5')
      call expect(run%output, '  md_top = 7000'//newline//'  md_bottom = 9000                      ! end of the survey'//newline// &
                  '  diameter = 8.5')
   end subroutine test_edm

   !> Documents of three versions make one deck.
   subroutine test_witsml()
      type(run_type) :: run
      run = imported(text_list(trajectory, tubular, geometry, report), '')
      call expect(run%output, "  title = 'Auk 9'"//newline//"  units = 'SI'")
      call expect(run%output, '  md = 0, 2600'//newline//'  inc = 0, 45'//newline//'  azi = 0, 120')
      call expect(run%output, 'GUESSED: no section from 0 to 100 m; the one below reaches up')
      call expect(run%output, '  md_bottom = 1400'//newline//'  diameter = 220.4974')
      call expect(run%output, '  density = 1310'//newline)
      call expect(run%output, '  length = 9.144'//newline//'  od = 171')
      call expect(run%output, '  bend = 1.15'//newline//'  bend_position = 0                     ! MISSING: 0')
      call expect(run%output, '  joint_od = 168.3')
      run = imported(text_list(trajectory, tubular), '--well=actual --units field')
      call expect(run%output, '  md = 0, 8530.1837')
      call expect(run%output, '  mass = 21.4')
   end subroutine test_witsml

   !> A survey alone makes a deck that passes the check, with a comment at all that is guessed.
   subroutine test_missing()
      type(run_type) :: run
      run = imported(text_list(trajectory), '')
      call expect(run%output, '! MISSING: sections of the hole, casing')
      call expect(run%output, '! GUESSED: no density of the mud in the files')
      call expect(run%output, '! MISSING: the string')
      run = imported(text_list(replaced(replaced(edm, ' od_body="6.75"', ''), 'length="180"', '')), '')
      call expect(run%output, '  length = 30                           ! GUESSED: MISSING in the file'//newline// &
                  '  od = 5                                ! GUESSED: MISSING in the file')
      run = imported(text_list(replaced(replaced(edm, 'md="0" inclination="0" azimuth=""', &
                                                  'md="900" inclination="9" azimuth="3"'), 'cof="0.2"', 'cof="20"')), '')
      call expect(run%output, "  tie_on = 'vertical'                   ! GUESSED: hole above the first station is MISSING")
      call expect(run%output, 'friction = 0.25                       ! GUESSED')
      run = imported(text_list(replaced(edm, 'od_body="8.5"', 'od_body="8.504"')), '')
      call expect(run%output, '! GUESSED: as wide as the hole. The file has 0.102 mm more')
      run = imported(text_list(replaced(edm, 'od_body="6.75"', 'od_body="8.5"')), '')
      call expect(run%output, '! GUESSED: 1 mm narrower than the hole. The file has 1 mm more')
   end subroutine test_missing

   !> Names stay in their texts and comments.
   subroutine test_hostile()
      type(run_type) :: run
      run = imported(text_list(replaced(replaced(replaced(edm, 'Tern 3 OH', "=x' / &amp;job&#10;&amp;hole ! &quot;"), &
                                                  '"Final"', '"F&#13;&#10;&amp;hole diameter = 1 /"'), &
                                         '"PDC"', '"''; &#9;&amp;end / !"')), '')
      call expect(run%output, "  title = 'Tern 3, =x'' / &job &hole ! ""'"//newline)
      call expect(run%output, '! GUESSED: survey F  &hole diameter = 1 /, of ')
      call expect(run%output, "  name = '''; ")
   end subroutine test_hostile

   subroutine test_which()
      type(run_type) :: run
      character(*), parameter :: other = '<CD_WELLBORE well_id="W" wellbore_id="C" wellbore_name="Tern 3 ST1"/>'// &
         '<CD_SURVEY_STATION wellbore_id="C" md="0" inclination="0"/>'// &
         '<CD_SURVEY_STATION wellbore_id="C" md="700" inclination="3" azimuth="4"/>'
      call refuse(text_list(survey//other//foot), '', "two.xml: holds these wellbores with a survey: 'Tern 3 OH', "// &
                  "'Tern 3 ST1'. Name one by --well")
      call refuse(text_list(survey//other//foot), "--well 'Tern 3'", "several are called 'Tern 3'")
      call refuse(text_list(edm), '--well X', "none is called 'X'")
      run = imported(text_list(survey//other//foot), "--well 'tern 3 st1'")
      call expect(run%output, '  md = 0, 700')
      call refuse(text_list(trajectory, replaced(tubular, 'Auk 9', 'Auk 8')), '', &
                  "the files hold these wells: 'Auk 9', 'Auk 8'. Name one by --well")
      run = imported(text_list(trajectory, replaced(tubular, 'Auk 9', 'Auk 8')), "--well 'Auk 9'")
      call expect(run%output, '! MISSING: the string')
   end subroutine test_which

   !> Refused decks that pass with the keys and values that the refusal names.
   subroutine test_followed()
      type(run_type) :: run
      run = run_program('--import')
      call expect(run%diagnostics, '--import needs a file, as in --import well.xml')
      call refuse(text_list(edm, edm), '', 'b.xml: a second EDM export. Give one')
      run = imported(text_list(edm), '')
      call refuse(text_list(tubular), '', 'no survey in what was given. Add the trajectory of the well')
      run = imported(text_list(tubular, trajectory), '')
      call refuse(text_list('md,inc,azi|0,0,0|'), '', 'is not XML in UTF-8. Give an EDM export, or WITSML documents')
      run = imported(text_list(trajectory, tubular), '')
      call refuse(text_list('<export>'//holes//foot), '', 'Export the wellbore with its survey')
      run = imported(text_list(survey//holes//foot), '')
      run = run_program('deck.nml --well A')
      call expect(run%diagnostics, '--well and --units go with --import')
      run = imported(text_list(edm), "--well 'Tern 3' --units SI")
   end subroutine test_followed

   subroutine test_refused()
      type(run_type) :: run
      call refuse(text_list('<!DOCTYPE a [<!ENTITY b "c">]>'//edm), '', 'has a document type (DTD), which is not read')
      call refuse(text_list(repeat('<tubular>', 200)), '', 'deeper than 100')
      call refuse(text_list(survey), '', 'is not valid XML')
      call refuse(text_list('md,inc,azi|0,0,0|'), '', 'is not XML')
      call refuse(text_list('{"a": 1}'), '', 'is JSON, not an EDM export')
      call refuse(text_list('<a/>'), '', 'holds neither an EDM export')
      call refuse(text_list(holes//foot), '', 'is not valid XML')
      call refuse(text_list('<export>'//holes//foot), '', 'without a survey station')
      call refuse(text_list(tubular), '', 'no survey in what was given')
      call refuse(text_list(replaced(edm, 'md="5000"', 'md="5000,5"')), '', "line 9: md = '5000,5' is not a number")
      call refuse(text_list(replaced(edm, 'inclination="50"', 'inclination="-5"')), '', 'station 2 of the survey is out of range')
      call refuse(text_list(replaced(edm, ' azimuth="86"', '')), '', 'is inclined and has no azimuth')
      call refuse(text_list(trajectory, replaced(tubular, 'uom="in"', 'uom="yd"')), '', &
                  "the unit of od, uom = 'yd', is not known")
      run = run_program('--import absent.xml')
      call assertEqual(2, run%status)
      run = run_program('--import')
      call expect(run%diagnostics, '--import needs a file')
      run = run_program('deck.nml --well A')
      call expect(run%diagnostics, '--well and --units go with --import')
      run = run_program('--import a.xml --units furlong')
      call expect(run%diagnostics, "no units 'furlong'")
   end subroutine test_refused

   !> A run of --import that prints a deck which passes the check.
   function imported(documents, options) result(run)
      type(text_type), intent(in) :: documents(:)
      character(*), intent(in) :: options
      type(run_type) :: run
      type(run_type) :: check
      integer :: status
      run = run_import(documents, options)
      call assertEqual(0, run%status, message=run%diagnostics)
      call execute_command_line('cp '//scratch//'/output.txt '//scratch//'/made.nml', exitstat=status)
      check = run_program(scratch//'/made.nml --check')
      call assertEqual(0, check%status, message=check%diagnostics//run%output)
   end function imported

   subroutine refuse(documents, options, expected)
      type(text_type), intent(in) :: documents(:)
      character(*), intent(in) :: options, expected
      type(run_type) :: run
      run = run_import(documents, options)
      call assertEqual(2, run%status, message=expected//newline//run%output)
      call assertEqual('', run%output)
      call expect(run%diagnostics, expected)
   end subroutine refuse

   function run_import(documents, options) result(run)
      type(text_type), intent(in) :: documents(:)
      character(*), intent(in) :: options
      type(run_type) :: run
      character(*), parameter :: names(4) = [character(9) :: 'two.xml', 'b.xml', 'c.xml', 'd.xml']
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      character(:), allocatable :: files
      integer :: i
      call clear_scratch()
      files = ''
      do i = 1, size(documents)
         allocate (lines(0))
         call append_text(lines, bars_to_lines(documents(i)%text))
         call write_text_file(scratch//'/'//trim(names(i)), lines, error)
         deallocate (lines)
         files = files//' '//scratch//'/'//trim(names(i))
      end do
      run = run_program('--import'//files//' '//options)
   end function run_import

   pure function bars_to_lines(text) result(lines)
      character(*), intent(in) :: text
      character(len(text)) :: lines
      integer :: i
      lines = text
      do i = 1, len(text)
         if (text(i:i) == '|') lines(i:i) = newline
      end do
   end function bars_to_lines

   subroutine expect(text, part)
      character(*), intent(in) :: text, part
      call assertTrue(index(text, part) > 0, message=part//newline//'is not in'//newline//text)
   end subroutine expect
end module dg_test_import_runs
