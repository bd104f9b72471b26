!> Rows of an EDM export (Landmark): each is an element `CD_...`, its values are attributes.
module dg_edm_rows
   use dg_deck_number, only: read_real
   use dg_imported_case, only: is_meant, one_of
   use dg_kinds, only: wp
   use dg_text, only: append_text, either, lower_case, quoted, text_type, to_text
   use dg_xml_tree, only: attribute, xml_tree_type
   implicit none
   private
   public :: edm_elements, edm_attributes, is_edm, choose_wellbore, pick, is_of, get

   character(*), parameter :: edm_elements = 'cd_well cd_wellbore cd_datum cd_case cd_definitive_survey_header '// &
      'cd_definitive_survey_station cd_survey_header cd_survey_station cd_hole_sect_group cd_hole_sect cd_assembly '// &
      'cd_assembly_comp cd_fluid'
   character(*), parameter :: edm_attributes = 'well_id wellbore_id well_common_name well_name wellbore_name phase name '// &
      'case_name def_survey_header_id survey_header_id md inclination azimuth hole_sect_group_id hole_name assembly_id '// &
      'assembly_name string_type md_assembly_base is_top_down datum_elevation is_default sequence_no sect_type_code '// &
      'comp_type_code description comp_name catalog_key_desc od_body id_body length approximate_weight od_connection '// &
      'id_connection length_tool_joint min_yield_stress makeup_torque blade_od od_blade material id_casing hole_size '// &
      'effective_diameter md_top md_base md_shoe cof density fluid_name'

contains

   !> True if a document holds rows of EDM.
   pure function is_edm(tree) result(is)
      type(xml_tree_type), intent(in) :: tree
      logical :: is
      is = tree%n > 0
      if (is) is = index(tree%elements(1)%name, 'cd_') == 1
   end function is_edm

   !> The wellbore that is meant, of those with a survey; without any survey there is no case.
   subroutine choose_wellbore(tree, wanted, wellbore, well, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: wanted
      character(:), allocatable, intent(out) :: wellbore   !< its id
      character(:), allocatable, intent(inout) :: well     !< names of well and wellbore
      character(:), allocatable, intent(inout) :: failure
      type(text_type), allocatable :: ids(:), names(:), wells(:), choices(:)
      character(:), allocatable :: id
      integer :: i, k
      allocate (ids(0), names(0), wells(0), choices(0))
      do i = 1, tree%n
         if (index(tree%elements(i)%name, 'survey_station') == 0) cycle
         id = attribute(tree%elements(i), 'wellbore_id')
         if (any([(ids(k)%text == id, k=1, size(ids))])) cycle
         call append_text(ids, id)
      end do
      do i = 1, size(ids)
         call append_text(names, name_of('cd_wellbore', 'wellbore_id', ids(i)%text, 'wellbore_name'))
         call append_text(wells, name_of('cd_well', 'well_id', &
                                         name_of('cd_wellbore', 'wellbore_id', ids(i)%text, 'well_id'), 'well_common_name'))
         if (wanted /= '' .and. .not. (is_meant(names(i)%text, wanted) .or. is_meant(wells(i)%text, wanted))) cycle
         call append_text(choices, ids(i)%text)
      end do
      wellbore = ''
      if (size(ids) == 0) then
         failure = 'is an EDM export without a survey station (CD_DEFINITIVE_SURVEY_STATION, CD_SURVEY_STATION). '// &
                   'Export the wellbore with its survey'
      else if (size(choices) /= 1) then
         failure = 'holds these wellbores with a survey: '//one_of(names)//'. Name one by --well'
         if (wanted /= '') failure = failure//'; '//either('several are called', 'none is called', size(choices) > 1)// &
                                     ' '//quoted(wanted)
      else
         wellbore = choices(1)%text
         do i = 1, size(ids)
            if (ids(i)%text /= wellbore) cycle
            well = names(i)%text
            if (index(well, wells(i)%text) == 0) well = wells(i)%text//', '//well
         end do
      end if

   contains

      !> A name of the row that has an id.
      function name_of(table, key, value, name) result(text)
         character(*), intent(in) :: table, key, value, name
         character(:), allocatable :: text
         integer :: j
         text = ''
         do j = 1, tree%n
            if (tree%elements(j)%name /= table) cycle
            if (attribute(tree%elements(j), key) /= value) cycle
            text = attribute(tree%elements(j), name)
            if (text == '' .and. name == 'well_common_name') text = attribute(tree%elements(j), 'well_name')
            return
         end do
         if (index(name, '_name') > 0) text = value
      end function name_of
   end subroutine choose_wellbore

   !> The row of a table that counts for a wellbore: of phase ACTUAL, else the last. A note names the others.
   subroutine pick(tree, table, wellbore, name, key, noun, notes, row)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: table, wellbore, name
      character(*), intent(in) :: key              !< attribute that the row must have
      character(*), intent(in) :: noun             !< for the row
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer, intent(out) :: row                  !< 0: none
      type(text_type), allocatable :: names(:)
      character(:), allocatable :: phase
      logical :: actual
      integer :: i
      row = 0
      actual = .false.
      allocate (names(0))
      do i = 1, tree%n
         if (tree%elements(i)%name /= table .or. .not. is_of(tree, i, wellbore)) cycle
         if (attribute(tree%elements(i), key) == '') cycle
         phase = lower_case(attribute(tree%elements(i), 'phase'))
         call append_text(names, attribute(tree%elements(i), name)//' ('//phase//')')
         if (actual .and. phase /= 'actual') cycle
         actual = phase == 'actual'
         row = i
      end do
      if (size(names) < 2) return
      call append_text(notes, 'GUESSED: '//noun//' '//attribute(tree%elements(row), name)//', of '//one_of(names))
   end subroutine pick

   !> True if a row belongs to a wellbore, or to none.
   pure function is_of(tree, row, wellbore) result(is)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: row
      character(*), intent(in) :: wellbore
      logical :: is
      is = attribute(tree%elements(row), 'wellbore_id') == wellbore .or. attribute(tree%elements(row), 'wellbore_id') == ''
   end function is_of

   !> A value of a row; 0 where it has none.
   subroutine get(tree, row, name, unit, value, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: row
      character(*), intent(in) :: name
      real(wp), intent(in) :: unit
      real(wp), intent(out) :: value
      character(:), allocatable, intent(inout) :: failure
      character(:), allocatable :: text
      logical :: legal
      value = 0.0_wp
      text = attribute(tree%elements(row), name)
      if (text == '') return
      call read_real(text, value, legal)
      if (.not. legal .and. failure == '') failure = 'line '//to_text(tree%elements(row)%line)//': '//name//' = '// &
         quoted(text)//' is not a number'
      value = value*unit
   end subroutine get
end module dg_edm_rows
