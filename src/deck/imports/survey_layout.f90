!> Layout of a survey table: its header, its columns and their units, and remarks in rows above and below the header.
module dg_survey_layout
   use dg_kinds, only: wp
   use dg_error, only: add_fault, error_list_type
   use dg_las_file, only: is_las, las_table
   use dg_deck_number, only: is_number, read_real
   use dg_survey_cells, only: split_cells
   use dg_survey_columns, only: choose_columns, column_names_type, layout_type, missing_columns, set_unit
   use dg_survey_header, only: find_header
   use dg_survey_heading, only: column_inc, column_md, column_name, heading_type, loose_rank, read_heading
   use dg_table_text, only: content_length, without_comment
   use dg_table_unit, only: resembles_unit
   use dg_text, only: lower_case, quoted, text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: find_layout, is_rule, is_unit_row

   !> Words of a title that give the unit of a table whose headings name none. Other units of length also mean something else
   !> in a title.
   character(*), parameter :: feet_words(5) = [character(7) :: 'ft', 'feet', 'usft', 'foot', 'kft']
   character(*), parameter :: metre_words(4) = [character(7) :: 'metre', 'metres', 'meter', 'meters']
   character(*), parameter :: angle_words(6) = [character(7) :: 'gon', 'gons', 'mrad', 'mils', 'radian', 'radians']
   !> Between a foot and a metre [m].
   real(wp), parameter :: short_unit = 0.5_wp

contains

   !> Find header, columns and units. The header names md and inc. If no line does, the line most like a header is reported as
   !> faulty. Rows of units may be above or below it. A header may be in a comment right above the numbers.
   subroutine find_layout(path, lines, names, units, units_told, layout, sound, faults)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(column_names_type), intent(in) :: names    !< headings that the deck names; '': none
      type(unit_system_type), intent(in) :: units     !< of columns whose unit is not told
      logical, intent(in) :: units_told               !< the deck says that they are those of this table
      type(layout_type), intent(out) :: layout
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      integer :: line, header, first_station
      logical :: found
      sound = .true.
      layout%foreign = ''
      if (is_las(lines)) then
         call find_las_layout(path, lines, names, units, layout, sound, faults)
         return
      end if
      call locate_header(lines, names, units, layout, line, found)
      if (line == 0) then
         sound = .false.
         call add_fault(faults, path, 0, 'survey file is empty; it needs a header naming md, inc, azi')
         return
      end if
      call fault(layout%unknown)
      if (.not. sound) return
      if (.not. found) then
         call fault(missing_columns(layout, .false.))
         return
      end if
      header = line
      layout%first_row = header + 1
      call fault(heading_fault(layout, names))
      call fault(layout%foreign)
      do line = 1, layout%first_header - 1
         call read_unit_row()
      end do
      do line = header + 1, size(lines)
         if (content_length(lines(line)%text) == 0) cycle
         if (is_rule(lines(line)%text)) cycle
         if (.not. is_unit_row(lines(line)%text, layout)) exit
         call read_unit_row()
         layout%first_row = line + 1
      end do
      first_station = min(line, size(lines) + 1)
      do line = 1, layout%first_header - 1
         if (.not. layout%told(column_md)) call read_petrel_unit(lower_case(lines(line)%text), layout)
      end do
      do line = 4, size(layout%factor)       ! positions are in the unit of depth where they have none
         if (.not. layout%told(line)) layout%factor(line) = layout%factor(column_md)
      end do
      if (units_told) return
      do line = 1, first_station - 1
         call check_title(lower_case(lines(line)%text))
      end do

   contains

      subroutine read_unit_row()
         if (.not. is_unit_row(lines(line)%text, layout)) return
         layout%foreign = ''
         call read_units(lines(line)%text, layout)
         call fault(layout%foreign)
      end subroutine read_unit_row

      !> A title, comment or heading of another column that names another unit than the numbers would be read in.
      subroutine check_title(title)
         character(*), intent(in) :: title
         character(*), parameter :: advice = '; name the unit in the heading, as in '
         if (.not. layout%told(column_md)) then
            if (layout%factor(column_md) > short_unit .and. has_word(title, feet_words)) &
               call fault('this line speaks of feet, md has no unit and would be read in m'//advice//'MD (ft)')
            if (layout%factor(column_md) < short_unit .and. has_word(title, metre_words)) &
               call fault('this line speaks of metres, md has no unit and would be read in ft'//advice//'MD (m)')
         end if
         if (.not. all(layout%told(column_inc:) .or. layout%place(column_inc:) == 0) .and. has_word(title, angle_words)) &
            call fault('this line speaks of other angles than degrees, inc or azi has no unit'//advice//'Inc (deg)')
      end subroutine check_title

      subroutine fault(message)
         character(*), intent(in) :: message      !< '': none
         if (message == '') return
         sound = .false.
         call add_fault(faults, path, line, 'survey: '//message)
      end subroutine fault
   end subroutine find_layout

   !> Header and columns by lines that are no comments; else by comments, too.
   subroutine locate_header(lines, names, units, layout, line, found)
      type(text_type), intent(in) :: lines(:)
      type(column_names_type), intent(in) :: names
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      integer, intent(out) :: line              !< last of the header; 0: the file is empty
      logical, intent(out) :: found
      type(layout_type) :: commented
      integer :: other_line
      logical :: found_commented
      call find_header(lines, names, units, layout, line, found)
      if (found) return
      call find_header(bared(lines), names, units, commented, other_line, found_commented)
      if (.not. found_commented) return
      layout = commented
      line = other_line
      found = .true.
   end subroutine locate_header

   !> Fault of a header that names a column twice by its own name, or angles by degrees and minutes; '' where there is none.
   pure function heading_fault(layout, names) result(message)
      type(layout_type), intent(in) :: layout
      type(column_names_type), intent(in) :: names
      character(:), allocatable :: message
      integer :: i, column
      message = ''
      do column = 1, 3
         if (layout%place(column) == 0 .or. names%names(column) /= '') cycle
         associate (headings => layout%headings, taken => layout%headings(layout%place(column)))
            if (count([(headings(i)%name == column_name(column) .and. headings(i)%unit == taken%unit, &
                        i=1, layout%width)]) < 2) cycle
         end associate
         message = 'the header names '//trim(column_name(column))//' twice; keep one'
         return
      end do
      do i = 1, layout%width
         if (.not. layout%headings(i)%minutes) cycle
         message = 'the column '//quoted(layout%headings(i)%text)//' gives minutes or a quadrant of an angle. '// &
                   'Write inclination and azimuth in decimal degrees, one column each'
         return
      end do
   end function heading_fault

   !> The same of a LAS file, whose curves have names and units.
   subroutine find_las_layout(path, lines, names, units, layout, sound, faults)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(column_names_type), intent(in) :: names
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      logical, intent(inout) :: sound
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: curves(:), las_units(:)
      type(heading_type), allocatable :: headings(:)
      character(:), allocatable :: null, failure
      integer :: i
      allocate (curves(0), las_units(0))     ! gfortran 12 warns of bounds that are not set else
      call las_table(lines, curves, las_units, layout%separator, layout%first_row, null, failure)
      if (failure /= '') then
         sound = .false.
         call add_fault(faults, path, 0, 'survey: the LAS file '//failure)
         return
      end if
      call read_real(null, layout%null, layout%has_null)
      allocate (layout%extent(2, 0), headings(size(curves)))
      do i = 1, size(curves)
         call read_heading(curves(i)%text, headings(i))
         headings(i)%unit = las_units(i)%text
      end do
      ! the index curve is the measured depth
      if (headings(1)%column == column_md .and. headings(1)%rank > loose_rank) headings(1)%rank = loose_rank - 1
      call choose_columns(headings, names, units, layout)
      if (layout%unknown /= '') call fault(layout%unknown)
      if (any(layout%place(:column_inc) == 0) .and. layout%unknown == '') call fault(missing_columns(layout, .false.))
      do i = 4, size(layout%factor)
         if (.not. layout%told(i)) layout%factor(i) = layout%factor(column_md)
      end do
      if (null /= '' .and. .not. layout%has_null) call fault('NULL = '//quoted(null)//' is not a number')
      if (layout%foreign /= '') call fault(layout%foreign)

   contains

      subroutine fault(message)
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, path, layout%first_row - 1, 'survey: '//message)
      end subroutine fault
   end subroutine find_las_layout

   !> The unit of depth of a well trace by Petrel: 'DEPTH (Z, TVD) GIVEN IN ft-UNITS'.
   pure subroutine read_petrel_unit(title, layout)
      character(*), intent(in) :: title           !< in small letters
      type(layout_type), intent(inout) :: layout
      character(*), parameter :: before = 'depth (z, tvd) given in ', behind = '-units'
      integer :: first, last
      first = index(title, before)
      last = index(title, behind)
      if (first == 0 .or. last <= first) return
      first = first + len(before)
      if (scan(title(first:last - 1), ' ') == 0) call set_unit(layout, column_md, title(first:last - 1))
   end subroutine read_petrel_unit

   !> The first lines of a file with blanks for # and for other marks of comments at their beginning.
   pure function bared(lines) result(bare)
      type(text_type), intent(in) :: lines(:)
      type(text_type), allocatable :: bare(:)
      integer, parameter :: most = 250
      integer :: i, k, first
      allocate (bare(min(size(lines), most)))
      do i = 1, size(bare)
         bare(i)%text = lines(i)%text
         first = verify(bare(i)%text, '#!%/ '//achar(9))
         do k = 1, len(bare(i)%text)
            if (bare(i)%text(k:k) == '#' .or. (k < first .and. bare(i)%text(k:k) /= achar(9))) bare(i)%text(k:k) = ' '
         end do
      end do
   end function bared

   !> True if a line holds dashes and similar marks only.
   pure function is_rule(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      is = verify(text, '-=_*+~|:. ,;'//achar(9)) == 0 .and. scan(text, '-=_*~') > 0
   end function is_rule

   !> True if a line holds the units of the columns: (m), deg, ... Two of the wanted columns must look like units. One is
   !> enough if the others are empty, the separator is not a blank, or the line has as many cells as headings.
   pure function is_unit_row(line, layout) result(is)
      character(*), intent(in) :: line
      type(layout_type), intent(in) :: layout
      logical :: is
      type(text_type), allocatable :: row(:)
      integer :: column, alike, filled
      is = .false.
      call split_cells(tight(line, layout), layout, row)
      alike = 0
      filled = 0
      do column = 1, 3
         if (layout%place(column) == 0 .or. layout%place(column) > size(row)) cycle
         associate (cell => row(layout%place(column))%text)
            if (is_number(cell)) return
            if (cell /= '') filled = filled + 1
            if (resembles_unit(cell, column /= column_md)) alike = alike + 1
         end associate
      end do
      is = alike >= 2 .or. (alike == 1 .and. size(row) > 1 .and. &
                             (filled == 1 .or. layout%separator /= ' ' .or. size(row) == layout%width))
   end function is_unit_row

   pure subroutine read_units(line, layout)
      character(*), intent(in) :: line
      type(layout_type), intent(inout) :: layout
      type(text_type), allocatable :: row(:)
      integer :: column
      call split_cells(tight(line, layout), layout, row)
      do column = 1, size(layout%place)
         if (layout%place(column) == 0 .or. layout%place(column) > size(row)) cycle
         call set_unit(layout, column, row(layout%place(column))%text)
      end do
   end subroutine read_units

   !> A row of units without its comment; where blanks separate its cells brackets hold none, and all letters keep their places.
   pure function tight(line, layout) result(text)
      character(*), intent(in) :: line
      type(layout_type), intent(in) :: layout
      character(:), allocatable :: text
      integer :: i, depth
      text = without_comment(line)
      if (layout%separator /= ' ') return
      depth = 0
      do i = 1, len(text)
         if (scan(text(i:i), '([') == 1) depth = depth + 1
         if (scan(text(i:i), ')]') == 1) depth = max(depth - 1, 0)
         if (depth > 0 .and. text(i:i) == ' ') text(i:i) = '_'
      end do
   end function tight

   !> True if one of some words stands in a lower-case text.
   pure function has_word(text, words) result(has)
      character(*), intent(in) :: text, words(:)
      logical :: has
      character(*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyz'
      integer :: first, length
      has = .false.
      first = 1
      do while (first <= len(text))
         length = verify(text(first:)//' ', letters) - 1
         if (length > 0) has = has .or. any(words == text(first:first + length - 1))
         first = first + length + 1
      end do
   end function has_word
end module dg_survey_layout
