!> A deck from the files of another program: an EDM export, or WITSML documents of a well.
module dg_import_case
   use dg_case_deck, only: case_deck
   use dg_constants, only: degree, pi
   use dg_edm_case, only: read_edm_case
   use dg_edm_rows, only: edm_attributes, edm_elements, is_edm
   use dg_error, only: error_list_type
   use dg_file_kind, only: foreign_kind, is_xml
   use dg_file_lines, only: read_lines
   use dg_imported_case, only: empty_case, imported_case_type, one_of
   use dg_kinds, only: wp
   use dg_survey_file, only: column_names_type, read_survey_file, station_list_type
   use dg_text, only: append_text, lower_case, text_type, to_text
   use dg_units, only: field_units, si_units, unit_system, unit_system_type
   use dg_witsml_case, only: has_trajectory, is_called, read_witsml_case, witsml_elements
   use dg_witsml_survey, only: well_of
   use dg_xml, only: read_tree
   use dg_xml_tree, only: xml_tree_type
   implicit none
   private
   public :: import_case

contains

   !> Reads `files` and makes a deck of them. `failure` is '' or names the file and what is wrong.
   subroutine import_case(files, well, units_name, lines, failure)
      type(text_type), intent(in) :: files(:)
      character(*), intent(in) :: well             !< name of a well, wellbore or trajectory; '': the only one
      character(*), intent(in) :: units_name       !< of the deck; '': field of an EDM export, SI of WITSML
      type(text_type), allocatable, intent(out) :: lines(:)
      character(:), allocatable, intent(out) :: failure
      type(xml_tree_type), allocatable :: trees(:)
      type(imported_case_type) :: case
      type(unit_system_type) :: units
      character(:), allocatable :: chosen
      integer :: i
      allocate (lines(0), trees(size(files)))
      case = empty_case()
      failure = ''
      do i = 1, size(files)
         call read_document(files(i)%text, trees(i), failure)
         if (failure /= '') return
         if (case%source /= '') case%source = case%source//', '
         case%source = case%source//files(i)%text
      end do
      units = si_units()
      do i = 1, size(files)
         if (.not. is_edm(trees(i))) cycle
         units = field_units()
         if (size(case%md) > 0) then
            failure = files(i)%text//': a second EDM export. Give one'
            return
         end if
         call read_edm_case(trees(i), well, case, failure)
         if (failure /= '') failure = files(i)%text//': '//failure
         if (failure /= '') return
      end do
      call choose_well(files, trees, well, chosen, failure)
      if (failure /= '') return
      if (case%well == '') case%well = chosen
      do i = 1, size(files)
         if (is_edm(trees(i)) .or. trees(i)%n == 0) cycle
         call read_witsml_case(trees(i), chosen, case, failure)
         if (failure == '' .and. has_trajectory(trees(i), chosen, well)) &
            call read_trajectory(files(i)%text, well, case, failure)
         if (failure /= '') failure = files(i)%text//': '//failure
         if (failure /= '') return
      end do
      if (size(case%md) == 0) then
         failure = files(1)%text//': no survey in what was given. Add the trajectory of the well'
         return
      end if
      failure = survey_fault(case)
      if (failure /= '') failure = files(1)%text//': '//failure
      if (failure /= '') return
      if (units_name /= '') units = unit_system(units_name)
      call case_deck(case, units, lines)
   end subroutine import_case

   !> Reason, in words, why a survey cannot be that of a deck; '' for a valid survey.
   pure function survey_fault(case) result(fault)
      type(imported_case_type), intent(in) :: case
      character(:), allocatable :: fault
      real(wp), parameter :: deepest = 50.0e3_wp, least = 1.0_wp     ! m
      integer :: i
      fault = ''
      if (size(case%md) < 2 .or. maxval(case%md) < least) fault = 'the survey has fewer than two stations, or no depth'
      do i = 1, size(case%md)
         if (case%inclination(i) >= 0.0_wp .and. case%inclination(i) <= pi .and. case%azimuth(i) >= -2.0_wp*pi .and. &
             case%azimuth(i) <= 4.0_wp*pi .and. case%md(i) <= deepest) cycle
         fault = 'station '//to_text(i)//' of the survey is out of range: depth '//to_text(case%md(i), 6)//' m, inclination '// &
                 to_text(case%inclination(i)/degree, 6)//' deg, azimuth '//to_text(case%azimuth(i)/degree, 6)//' deg'
         return
      end do
   end function survey_fault

   !> The parts of one document that make a case. A document without any is a failure.
   subroutine read_document(path, tree, failure)
      character(*), intent(in) :: path
      type(xml_tree_type), intent(inout) :: tree
      character(:), allocatable, intent(inout) :: failure
      type(text_type), allocatable :: text(:)
      failure = foreign_kind(path)
      if (failure /= '') then
         failure = failure(:index(failure//'. ', '. ') - 1)//', not an EDM export or a WITSML document (XML)'
      else if (.not. is_xml(path)) then
         call read_lines(path, text, failure)
         if (failure == '') failure = 'is not XML in UTF-8. Give an EDM export, or WITSML documents'
      end if
      if (failure == '') call read_tree(path, edm_elements//' '//witsml_elements, edm_attributes//' uom', tree, failure)
      if (failure == '' .and. tree%n == 0) failure = 'holds neither an EDM export (CD_WELL ...) nor a trajectory, tubular, '// &
         'wbGeometry or fluidsReport of WITSML'
      if (failure /= '') failure = path//': '//failure
   end subroutine read_document

   !> The one well of all documents, or the one that is meant.
   subroutine choose_well(files, trees, wanted, well, failure)
      type(text_type), intent(in) :: files(:)
      type(xml_tree_type), intent(in) :: trees(:)
      character(*), intent(in) :: wanted
      character(:), allocatable, intent(out) :: well
      character(:), allocatable, intent(inout) :: failure
      type(text_type), allocatable :: wells(:)
      integer :: i, k
      logical :: several
      allocate (wells(0))
      well = ''
      several = .false.
      do k = 1, size(trees)
         if (is_edm(trees(k))) cycle
         do i = 1, trees(k)%n
            if (trees(k)%elements(i)%parent > 0) cycle
            if (well_of(trees(k), i) == '') cycle
            call append_text(wells, well_of(trees(k), i))
            if (.not. is_called(trees(k), i, wanted)) cycle
            if (well == '') well = well_of(trees(k), i)
            several = several .or. lower_case(well) /= lower_case(well_of(trees(k), i))
         end do
      end do
      if (several .or. (well == '' .and. wanted /= '' .and. size(wells) > 0)) &
         failure = files(1)%text//': the files hold these wells: '//one_of(wells)//'. Name one by --well'
   end subroutine choose_well

   !> Stations of the trajectory of a well. Of several, `wanted` says which.
   subroutine read_trajectory(path, wanted, case, failure)
      character(*), intent(in) :: path, wanted
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(station_list_type) :: stations
      type(error_list_type) :: faults
      type(column_names_type) :: names
      logical :: sound
      integer :: at
      names%well = wanted
      call read_survey_file(path, si_units(), stations, sound, faults, named=names)
      if (.not. sound) then
         failure = faults%items(1)%message
         at = index(failure, 'survey_well')
         if (at > 0) failure = failure(:at - 1)//'--well'//failure(at + len('survey_well'):)
      else if (size(case%md) > 0) then
         call append_text(case%survey_notes, 'GUESSED: the trajectory of '//path//' is left out, the first one counts')
      else
         case%md = stations%md
         case%inclination = stations%inclination
         case%azimuth = stations%azimuth
         call append_text(case%survey_notes, stations%columns)
      end if
   end subroutine read_trajectory
end module dg_import_case
