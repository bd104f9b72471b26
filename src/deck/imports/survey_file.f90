!> Read stations from a table as other programs export it, a LAS file, or a WITSML document. Tables may be CSV (comma or
!> semicolon), tabs or blanks, with decimal comma. Headings may be in any order with or without units. Lines above the header,
!> and rows of units above or below it, are allowed.
module dg_survey_file
   use dg_error, only: add_fault, add_unreadable, error_list_type, error_type
   use dg_file_kind, only: foreign_kind, is_xml
   use dg_file_lines, only: read_lines
   use dg_survey_columns, only: column_names_type, layout_type, missing_columns, taken_columns
   use dg_survey_heading, only: column_azi
   use dg_survey_layout, only: find_layout
   use dg_survey_rows, only: kind_names, read_rows, without_azimuth
   use dg_survey_stations, only: order_stations, pick_stations, rival_words, station_list_type
   use dg_table_number, only: doubt, doubtful_line, marks_type
   use dg_table_text, only: skipped_rows_type, skipped_words
   use dg_text, only: text_type, to_text
   use dg_units, only: unit_system_type
   use dg_witsml_survey, only: witsml_table
   implicit none
   private
   public :: station_list_type, read_survey_file, column_names_type

contains

   !> Read the table `path`. Stations have no fault if `sound`.
   subroutine read_survey_file(path, units, stations, sound, faults, units_told, asked, named)
      character(*), intent(in) :: path
      type(unit_system_type), intent(in) :: units     !< of numbers whose heading names no unit
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      logical, intent(in), optional :: units_told     !< the deck gives `units` for this very table, whatever its titles say
      type(error_type), intent(in), optional :: asked !< where the deck names the file, for one that cannot be read
      type(column_names_type), intent(in), optional :: named !< headings that the deck names for md, inc, azi
      type(text_type), allocatable :: lines(:)
      type(layout_type) :: layout
      type(marks_type) :: marks
      type(column_names_type) :: names
      type(skipped_rows_type) :: skipped(size(kind_names))
      character(:), allocatable :: failure, chosen
      integer :: i, n
      logical :: told

      if (present(named)) names = named
      stations%file = path
      stations%skipped = ''
      stations%columns = ''
      stations%headings = ''
      sound = .false.
      told = .false.
      if (present(units_told)) told = units_told
      failure = foreign_kind(path)
      allocate (lines(0))
      chosen = ''
      if (is_xml(path)) then
         call witsml_table(path, trim(names%well), lines, chosen, failure)
      else if (failure == '') then
         call read_lines(path, lines, failure)
      end if
      call blank_controls(lines)
      n = size(lines)
      allocate (stations%md(n), stations%inclination(n), stations%azimuth(n), stations%listed(3, n), stations%rival(3, n), &
                stations%lines(n))
      n = 0
      if (failure == '') then
         call find_layout(path, lines, names, units, told, layout, sound, faults)
      else
         call add_unreadable(faults, path, 'survey file '//failure, asked)
      end if
      if (sound) then
         call read_rows(lines, layout, stations, n, marks, skipped, sound, faults)
         stations%has_azimuth = layout%place(column_azi) > 0
         if (stations%has_azimuth) then
            stations%headings = taken_columns(layout)
         else
            stations%headings = missing_columns(layout, .true.)
         end if
      end if
      if (sound .and. doubtful_line(marks, layout%separator == ',') > 0) then
         sound = .false.
         associate (line => doubtful_line(marks, layout%separator == ','))
            call add_fault(faults, path, line, 'survey: '//doubt(marks, line))
         end associate
      end if
      call pick_stations(stations, [(i, i=1, n)])
      if (sound) call finish_stations(layout, skipped, stations, sound, faults)
      if (chosen /= '' .and. stations%columns /= '') chosen = chosen//'. '
      stations%columns = chosen//stations%columns
   end subroutine read_survey_file

   !> Replace form feeds, marks of the end of a file, and non-breaking blanks (UTF-8) by blanks.
   pure subroutine blank_controls(lines)
      type(text_type), intent(inout) :: lines(:)
      character(*), parameter :: no_break = char(194)//char(160), controls = achar(11)//achar(12)//achar(26)
      integer :: i, at
      do i = 1, size(lines)
         do
            at = index(lines(i)%text, no_break)
            if (at == 0) exit
            lines(i)%text(at:at + 1) = ' '
         end do
         do
            at = scan(lines(i)%text, controls)
            if (at == 0) exit
            lines(i)%text(at:at) = ' '
         end do
      end do
   end subroutine blank_controls

   !> Sort stations, remove doubles, and collect remarks on the file.
   subroutine finish_stations(layout, skipped, stations, sound, faults)
      type(layout_type), intent(in) :: layout
      type(skipped_rows_type), intent(in) :: skipped(:)      !< of the kinds in `kind_names`
      type(station_list_type), intent(inout) :: stations
      logical, intent(inout) :: sound
      type(error_list_type), intent(inout) :: faults
      type(skipped_rows_type) :: again
      character(:), allocatable :: problem
      logical :: turned
      call rival_words(stations, layout, stations%columns, problem)
      if (problem /= '') then
         sound = .false.
         call add_fault(faults, stations%file, layout%first_row - 1, 'survey: '//problem)
      end if
      call order_stations(stations, turned, again%count, again%first_line)
      stations%skipped = skipped_words([skipped(:without_azimuth - 1), again], &
                                       [character(len(kind_names)) :: kind_names(:without_azimuth - 1), 'with a station again'])
      if (skipped(without_azimuth)%count > 0) call add(to_text(skipped(without_azimuth)%count)//' without azimuth '// &
         'where the hole is vertical (first in line '//to_text(skipped(without_azimuth)%first_line)//'), read as stations')
      if (turned) call add('deepest station first, order turned')

   contains

      subroutine add(words)
         character(*), intent(in) :: words
         if (stations%skipped /= '') stations%skipped = stations%skipped//'. '
         stations%skipped = stations%skipped//words
      end subroutine add
   end subroutine finish_stations
end module dg_survey_file
