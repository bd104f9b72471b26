!> Reads stations from a table as other programs export it: CSV (comma or semicolon), tabs or blanks, decimal comma, headings in
!> any order with or without units, lines above the header, rows of units above or below it; or a LAS file.
module dg_survey_file
   use dg_kinds, only: wp
   use dg_deck_number, only: read_real
   use dg_fault_list, only: add_fault, add_unreadable, fault_list_type, fault_type
   use dg_file_lines, only: read_lines
   use dg_survey_layout, only: column_azi, column_inc, column_md, column_name, find_layout, layout_type
   use dg_table_number, only: doubt, doubtful_line, marks_type, read_cell
   use dg_table_text, only: content_length, row_type, skipped_rows_type, skipped_words, split_row
   use dg_text, only: quoted, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: station_list_type, read_survey_file

   !> Stations as read, with the place of each for messages. SI units.
   type :: station_list_type
      character(:), allocatable :: file          !< that holds them
      logical :: has_azimuth = .false.
      real(wp), allocatable :: md(:)             !< [m]
      real(wp), allocatable :: inclination(:)    !< [rad]
      real(wp), allocatable :: azimuth(:)        !< [rad]; zero where the table has none
      integer, allocatable :: lines(:)           !< of each station in its file
      character(:), allocatable :: skipped       !< rows of the file that are no stations, in words; '': all are
   end type station_list_type

contains

   !> Reads the table `path`; stations without fault only where `sound`.
   subroutine read_survey_file(path, units, stations, sound, faults, units_told, asked)
      character(*), intent(in) :: path
      type(unit_system_type), intent(in) :: units     !< of numbers whose heading names no unit
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(fault_list_type), intent(inout) :: faults
      logical, intent(in), optional :: units_told     !< the deck gives `units` for this very table, whatever its titles say
      type(fault_type), intent(in), optional :: asked !< where the deck names the file, for one that cannot be read
      type(text_type), allocatable :: lines(:)
      type(layout_type) :: layout
      type(marks_type) :: marks
      character(:), allocatable :: failure
      integer :: n
      logical :: told

      stations%file = path
      stations%skipped = ''
      sound = .false.
      told = .false.
      if (present(units_told)) told = units_told
      call read_lines(path, lines, failure)
      allocate (stations%md(size(lines)), stations%inclination(size(lines)), stations%azimuth(size(lines)), &
                stations%lines(size(lines)))
      n = 0
      if (failure == '') then
         call find_layout(path, lines, units, told, layout, sound, faults)
      else
         call add_unreadable(faults, path, 'survey file '//failure, asked)
      end if
      if (sound) then
         call read_rows(lines, layout, stations, n, marks, sound, faults)
         stations%has_azimuth = layout%place(column_azi) > 0
      end if
      if (sound .and. doubtful_line(marks, layout%separator == ',') > 0) then
         sound = .false.
         associate (line => doubtful_line(marks, layout%separator == ','))
            call add_fault(faults, path, line, 'survey: '//doubt(marks, line))
         end associate
      end if
      stations%md = stations%md(:n)
      stations%inclination = stations%inclination(:n)
      stations%azimuth = stations%azimuth(:n)
      stations%lines = stations%lines(:n)
   end subroutine read_survey_file

   !> The rows below the header. A row whose depth, inclination or azimuth is what stands for no value has no station; in a
   !> vertical hole the azimuth may be missing.
   subroutine read_rows(lines, layout, stations, n, marks, sound, faults)
      type(text_type), intent(in) :: lines(:)
      type(layout_type), intent(in) :: layout
      type(station_list_type), intent(inout) :: stations
      integer, intent(inout) :: n                       !< stations found
      type(marks_type), intent(inout) :: marks
      logical, intent(inout) :: sound
      type(fault_list_type), intent(inout) :: faults
      type(row_type) :: row
      real(wp) :: numbers(3)
      integer :: line, length, column, place
      logical :: legal(3), null(3)
      type(skipped_rows_type) :: above, commented, empty
      do line = 1, layout%first_row - 1
         if (all_numbers(lines(line)%text, layout)) call above%add(line)
      end do
      do line = layout%first_row, size(lines)
         length = content_length(lines(line)%text)
         if (length == 0) then
            if (has_station(lines(line)%text, layout)) call commented%add(line)
            cycle
         end if
         call split_row(lines(line)%text(:length), layout%separator, row)
         numbers = 0.0_wp
         legal = .true.
         null = .false.
         do column = 1, 3
            place = layout%place(column)
            if (place == 0 .or. place > row%count) cycle
            call read_cell(row%text(row%first(place):row%last(place)), layout%separator == ',', line, marks, &
                           numbers(column), legal(column))
            if (layout%has_null .and. legal(column)) null(column) = abs(numbers(column) - layout%null) <= spacing(layout%null)
         end do
         if (null(column_azi) .and. legal(column_inc) .and. .not. null(column_inc) .and. numbers(column_inc) <= 0.0_wp) then
            null(column_azi) = .false.
            numbers(column_azi) = 0.0_wp
         end if
         if (any(null)) then
            call empty%add(line)
            cycle
         end if
         if (row%count /= layout%width) call check_width()
         do column = 1, 3
            place = layout%place(column)
            if (place > row%count) then
               call fault('no value for '//trim(column_name(column))//': the row has '//to_text(row%count)// &
                          ' columns, the header puts it in column '//to_text(place))
            else if (.not. legal(column)) then
               call fault(trim(column_name(column))//' = '//quoted(row%text(row%first(place):row%last(place)))//' is no number')
            end if
         end do
         n = n + 1
         stations%md(n) = numbers(column_md)*layout%factor(column_md)
         stations%inclination(n) = numbers(column_inc)*layout%factor(column_inc)
         stations%azimuth(n) = numbers(column_azi)*layout%factor(column_azi)
         stations%lines(n) = line
      end do
      stations%skipped = skipped_words([above, commented, empty], &
                                       [character(22) :: 'above the header', 'that begin with #', 'without a value'])

   contains

      !> Numbers beyond the last heading, or between blanks fewer than headings, leave open which number belongs to which.
      subroutine check_width()
         real(wp) :: number
         integer :: i
         logical :: is_number
         do i = layout%width + 1, row%count
            call read_real(row%text(row%first(i):row%last(i)), number, is_number)
            if (.not. is_number) cycle
            call fault('the row has a number in column '//to_text(i)//', the header names '//to_text(layout%width)// &
                       ' columns; give each a name, and numbers with decimal points')
            return
         end do
         if (row%count < layout%width .and. layout%separator == ' ' .and. all(layout%place <= row%count)) &
            call fault('the row has '//to_text(row%count)//' columns, the header names '//to_text(layout%width)// &
                       '; between blanks no cell may be empty and no heading of two words: separate them by commas or tabs')
      end subroutine check_width

      subroutine fault(message)
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, stations%file, line, 'survey: '//message)
      end subroutine fault
   end subroutine read_rows

   !> Whether a line that is a comment would be a station without its mark.
   function has_station(text, layout) result(has)
      character(*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      logical :: has
      type(row_type) :: row
      type(marks_type) :: unused
      real(wp) :: number
      integer :: first, column, place
      logical :: is_number
      has = .false.
      first = verify(text, '# '//achar(9))
      if (first == 0 .or. index(text, '#') == 0) return
      call split_row(text(first:), layout%separator, row)
      do column = column_md, column_inc
         place = layout%place(column)
         if (place > row%count) return
         call read_cell(row%text(row%first(place):row%last(place)), layout%separator == ',', 1, unused, number, is_number)
         if (.not. is_number) return
      end do
      has = .true.
   end function has_station

   !> Whether a line holds nothing but numbers, two or more.
   function all_numbers(text, layout) result(all_are)
      character(*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      logical :: all_are
      type(row_type) :: row
      real(wp) :: number
      integer :: i
      all_are = .false.
      if (content_length(text) == 0) return
      call split_row(text(:content_length(text)), layout%separator, row)
      do i = 1, row%count
         call read_real(row%text(row%first(i):row%last(i)), number, all_are)
         if (.not. all_are) return
      end do
      all_are = row%count > 1
   end function all_numbers
end module dg_survey_file
