!> Rows of a survey table: stations, other lines counted by kind, and lines that may be damaged stations.
module dg_survey_rows
   use dg_constants, only: degree
   use dg_deck_number, only: is_number
   use dg_error, only: add_fault, error_list_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_survey_cells, only: split_cells
   use dg_survey_columns, only: layout_type
   use dg_survey_heading, only: column_azi, column_inc, column_md, column_name
   use dg_survey_layout, only: is_rule
   use dg_survey_lines, only: is_error_cell, is_header_again, is_quadrant, is_text, longest_run
   use dg_survey_stations, only: station_list_type
   use dg_table_number, only: marks_type, read_cell
   use dg_table_text, only: content_length, skipped_rows_type, split_row
   use dg_text, only: lower_case, quoted, text_type, to_text
   implicit none
   private
   public :: read_rows, kind_names, without_azimuth

   !> Kinds of lines without a station.
   integer, parameter :: above = 1, commented = 2, empty = 3, note = 4, rule = 5, header = 6, without_azimuth = 7, kinds = 7
   character(*), parameter :: kind_names(kinds) = [character(44) :: 'above the header', 'that begin with #', 'without a value', &
      'of text', 'of dashes', 'with the header or its units again', 'without azimuth where the hole is vertical']
   !> Inclination below which a station needs no azimuth [rad].
   real(wp), parameter :: vertical = 0.5_wp*degree
   !> Titles of tables below the stations, as COMPASS prints them.
   character(*), parameter :: other_tables(7) = [character(18) :: 'casing points', 'formations', 'targets', 'design targets', &
      'plan annotations', 'design annotations', 'survey annotations']
   !> Cells for no value.
   character(*), parameter :: no_values(12) = [character(4) :: '', '-', '--', '---', '----', 'n/a', 'na', 'nan', 'none', 'null', &
                                               '*', '.']

contains

   !> Read the rows below the header. A row whose depth, inclination or azimuth has the value for no data gives no station. The
   !> azimuth may be absent where the hole is vertical.
   subroutine read_rows(lines, layout, stations, n, marks, skipped, sound, faults)
      type(text_type), intent(in) :: lines(:)
      type(layout_type), intent(in) :: layout
      type(station_list_type), intent(inout) :: stations
      integer, intent(inout) :: n                       !< stations found
      type(marks_type), intent(inout) :: marks
      type(skipped_rows_type), intent(out) :: skipped(kinds)
      logical, intent(inout) :: sound
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: row(:)
      real(wp) :: numbers(3)
      integer :: line, length, column
      logical :: legal(3), null(3), needed(3)
      character(:), allocatable :: well        ! that the first row names
      logical :: below                         ! the stations, in a table of something else
      well = ''
      below = .false.
      needed = layout%place(:3) > 0
      do line = 1, min(layout%first_row - 1, size(lines))
         if (all_numbers(lines(line)%text, layout)) call skipped(above)%add(line)
      end do
      do line = layout%first_row, size(lines)
         length = content_length(lines(line)%text)
         if (length == 0) then
            if (has_station(lines(line)%text, layout)) call skipped(commented)%add(line)
            if (is_error_cell(lines(line)%text)) call fault('the row begins with an error of a spreadsheet. Give its number')
            cycle
         end if
         if (is_rule(lines(line)%text(:length))) then
            call skipped(rule)%add(line)
            cycle
         end if
         call split_cells(lines(line)%text(:length), layout, row)
         numbers = 0.0_wp
         legal = .not. needed
         null = .false.
         do column = 1, 3
            if (.not. needed(column) .or. layout%place(column) > size(row)) cycle
            call read_cell(row(layout%place(column))%text, layout%separator == ',', line, marks, numbers(column), legal(column))
            if (layout%has_null .and. legal(column)) null(column) = abs(numbers(column) - layout%null) <= spacing(layout%null)
         end do
         below = below .or. (n > 0 .and. any(other_tables == lower_case(adjustl(lines(line)%text(:length)))))
         if (all(legal) .and. size(row) == layout%width) then
            below = .false.
         else if (below .or. .not. all(legal)) then
            if (is_header_again(lines, layout, line)) then
               call skipped(header)%add(line)
               cycle
            else if (below .or. is_text(row, layout, legal)) then
               call skipped(note)%add(line)
               cycle
            end if
         end if
         call read_vertical()
         if (any(null)) then
            call skipped(empty)%add(line)
            cycle
         end if
         if (size(row) /= layout%width) call fault(width_fault(row, layout))
         call fault(well_fault(row, layout, well))
         do column = 1, 3
            call fault(cell_fault(row, layout, legal, column))
         end do
         n = n + 1
         stations%md(n) = numbers(column_md)*layout%factor(column_md)
         stations%inclination(n) = numbers(column_inc)*layout%factor(column_inc)
         stations%azimuth(n) = missing
         if (.not. is_missing(numbers(column_azi))) stations%azimuth(n) = numbers(column_azi)*layout%factor(column_azi)
         stations%lines(n) = line
         call read_others(row, layout, stations, n)
      end do
      call fill_azimuths(stations, n)

   contains

      !> A station without azimuth in a vertical hole is sound. Its azimuth is `missing` until others are known, unless the
      !> inclination is zero.
      subroutine read_vertical()
         logical :: absent
         if (.not. needed(column_azi) .or. .not. legal(column_inc) .or. null(column_inc) .or. .not. legal(column_md)) return
         if (numbers(column_inc)*layout%factor(column_inc) >= vertical) return
         absent = null(column_azi)
         if (.not. legal(column_azi)) then
            if (layout%place(column_azi) > size(row)) return       ! a row that is cut off
            absent = any(no_values == lower_case(row(layout%place(column_azi))%text))
         end if
         if (.not. absent) return
         if (.not. null(column_azi)) call skipped(without_azimuth)%add(line)
         null(column_azi) = .false.
         legal(column_azi) = .true.
         numbers(column_azi) = 0.0_wp
         if (numbers(column_inc) > 0.0_wp) numbers(column_azi) = missing
      end subroutine read_vertical

      subroutine fault(message)
         character(*), intent(in) :: message        !< '': none
         if (message == '') return
         sound = .false.
         call add_fault(faults, stations%file, line, 'survey: '//message)
      end subroutine fault
   end subroutine read_rows

   !> Fault of a row that is of another well than the rows above; '' where it is of the same. `well` is theirs, '' before the first.
   function well_fault(row, layout, well) result(message)
      type(text_type), intent(in) :: row(:)
      type(layout_type), intent(in) :: layout
      character(:), allocatable, intent(inout) :: well
      character(:), allocatable :: message
      character(*), parameter :: several = '?'      ! was told already
      message = ''
      if (layout%well == 0 .or. layout%well > size(row) .or. well == several) return
      if (row(layout%well)%text == '') return
      if (well == '') well = row(layout%well)%text
      if (well == row(layout%well)%text) return
      message = 'the row is of well '//quoted(row(layout%well)%text)//', rows above are of '//quoted(well)// &
                '. Keep the rows of one well'
      well = several
   end function well_fault

   !> Fault of the cell for md, inc or azi that holds no number; '' where there is none.
   pure function cell_fault(row, layout, legal, column) result(message)
      type(text_type), intent(in) :: row(:)
      type(layout_type), intent(in) :: layout
      logical, intent(in) :: legal(3)
      integer, intent(in) :: column
      character(:), allocatable :: message
      integer :: place
      message = ''
      place = layout%place(column)
      if (place == 0 .or. legal(column)) return
      if (place > size(row)) then
         message = 'no value for '//trim(column_name(column))//': the row has '//to_text(size(row))// &
                   ' columns, the header puts it in column '//to_text(place)
      else if (row(place)%text == '') then
         message = 'no value for '//trim(column_name(column))//'. Put # before a line that is not a station'
      else if (column == column_azi .and. is_quadrant(row(place)%text)) then
         message = 'azi = '//quoted(row(place)%text)//' is a bearing by quadrants. Write azimuths from 0 to 360 deg'
      else
         message = trim(column_name(column))//' = '//quoted(row(place)%text)// &
                   ' is not a number. Put # before a line that is not a station'
      end if
   end function cell_fault

   !> Numbers beyond the last heading, or between blanks fewer than headings, leave open which number belongs to which; '' where it
   !> is clear.
   pure function width_fault(row, layout) result(message)
      type(text_type), intent(in) :: row(:)
      type(layout_type), intent(in) :: layout
      character(:), allocatable :: message
      integer :: i
      message = ''
      do i = layout%width + 1, size(row)
         if (.not. is_number(row(i)%text)) cycle
         message = 'the row has a number in column '//to_text(i)//', the header names '//to_text(layout%width)// &
                   ' columns; give each column a name, and write decimals with a point'
         return
      end do
      if (size(row) < layout%width .and. layout%separator == ' ' .and. all(layout%place(:3) <= size(row)) .and. &
          .not. lacks_remark(row, layout)) &
         message = 'the row has '//to_text(size(row))//' columns, the header names '//to_text(layout%width)// &
                   '; between blanks no cell may be empty and no heading of two words: separate them by commas or tabs'
   end function width_fault

   !> True if a row of numbers lacks only the remark of the last column.
   pure function lacks_remark(row, layout) result(lacks)
      type(text_type), intent(in) :: row(:)
      type(layout_type), intent(in) :: layout
      logical :: lacks
      character(*), parameter :: remarks(7) = [character(10) :: 'remark', 'remarks', 'comment', 'comments', 'note', 'notes', &
                                               'annotation']
      lacks = size(row) == layout%width - 1 .and. longest_run(row) == size(row)
      if (lacks) lacks = any(remarks == layout%headings(layout%width)%name)
   end function lacks_remark

   !> Read the positions of a station from the file, and the values of other columns for md, inc and azi. They are `missing` if
   !> a cell has no number.
   subroutine read_others(row, layout, stations, n)
      type(text_type), intent(in) :: row(:)
      type(layout_type), intent(in) :: layout
      type(station_list_type), intent(inout) :: stations
      integer, intent(in) :: n
      integer :: k
      do k = 1, 3
         stations%listed(k, n) = value_at(layout%place(3 + k), layout%factor(3 + k))
         stations%rival(k, n) = value_at(layout%rival(k), layout%rival_factor(k))
      end do

   contains

      function value_at(place, factor) result(number)
         integer, intent(in) :: place
         real(wp), intent(in) :: factor
         real(wp) :: number
         logical :: legal
         type(marks_type) :: unused
         number = missing
         if (place == 0 .or. place > size(row)) return
         call read_cell(row(place)%text, layout%separator == ',', 1, unused, number, legal)
         if (.not. legal) number = missing
         if (legal .and. layout%has_null) then
            if (abs(number - layout%null) <= spacing(layout%null)) number = missing
         end if
         if (.not. is_missing(number)) number = number*factor
      end function value_at
   end subroutine read_others

   !> Gives stations that are nearly vertical and without azimuth that of the next one below, or else above.
   pure subroutine fill_azimuths(stations, n)
      type(station_list_type), intent(inout) :: stations
      integer, intent(in) :: n
      integer :: i
      do i = n - 1, 1, -1
         if (is_missing(stations%azimuth(i))) stations%azimuth(i) = stations%azimuth(i + 1)
      end do
      do i = 2, n
         if (is_missing(stations%azimuth(i))) stations%azimuth(i) = stations%azimuth(i - 1)
      end do
      if (n == 1 .and. is_missing(stations%azimuth(1))) stations%azimuth(1) = 0.0_wp
   end subroutine fill_azimuths

   !> True if a comment line would be a station without its comment mark.
   function has_station(text, layout) result(has)
      character(*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      logical :: has
      type(text_type), allocatable :: row(:)
      type(marks_type) :: unused
      real(wp) :: number
      integer :: first, column, place
      logical :: legal
      has = .false.
      first = verify(text, '# '//achar(9))
      if (first == 0 .or. index(text, '#') == 0) return
      call split_row(text(first:), layout%separator, row)
      do column = column_md, column_inc
         place = layout%place(column)
         if (place > size(row)) return
         call read_cell(row(place)%text, layout%separator == ',', 1, unused, number, legal)
         if (.not. legal) return
      end do
      has = .true.
   end function has_station

   !> True if a line holds numbers only, two or more.
   function all_numbers(text, layout) result(all_are)
      character(*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      logical :: all_are
      type(text_type), allocatable :: row(:)
      integer :: i
      all_are = .false.
      if (content_length(text) == 0) return
      call split_row(text(:content_length(text)), layout%separator, row)
      all_are = size(row) > 1 .and. all([(is_number(row(i)%text), i=1, size(row))])
   end function all_numbers
end module dg_survey_rows
