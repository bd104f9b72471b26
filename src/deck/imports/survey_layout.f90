!> How a survey table is laid out: its header, its columns and their units, and what rows above and below the header say of them.
module dg_survey_layout
   use dg_kinds, only: wp
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_las_file, only: is_las, las_table
   use dg_deck_number, only: read_real
   use dg_table_text, only: close_brackets, content_length, find_separator, row_type, split_fields, split_heading, split_row, &
                            split_unit, without_comment
   use dg_table_unit, only: read_unit, resembles_unit
   use dg_text, only: lower_case, quoted, text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: layout_type, find_layout, column_md, column_inc, column_azi, column_name

   integer, parameter :: column_md = 1, column_inc = 2, column_azi = 3
   character(*), parameter :: column_name(3) = ['md ', 'inc', 'azi']
   !> Other headings for the same, without blanks and marks, as programs write them.
   character(*), parameter :: md_names(11) = [character(13) :: 'md', 'measureddepth', 'measdepth', 'mdepth', 'mdrkb', 'mdrt', &
      'mdkb', 'mdbrt', 'depthmd', 'ahdepth', 'ahd']
   character(*), parameter :: inc_names(6) = [character(13) :: 'inc', 'inclination', 'incl', 'inclin', 'deviation', 'devi']
   character(*), parameter :: azi_names(13) = [character(13) :: 'azi', 'azimuth', 'azim', 'azm', 'hazi', 'az', 'azimuthtn', &
      'azimuthgn', 'azimuthtrue', 'azimuthgrid', 'azitrue', 'azigrid', 'gridazimuth']
   !> Curves of LAS files that have other names there: the index curve is the measured depth.
   character(*), parameter :: las_md_names(2) = [character(13) :: 'dept', 'depth']
   character(*), parameter :: las_inc_names(1) = [character(13) :: 'dev']
   !> Lines among which the header is looked for: titles above it are few.
   integer, parameter :: header_lines = 200
   !> Words of a title that tell the unit of a table whose headings name none. Other units of length do not stand in a title by
   !> themselves without meaning something else, too.
   character(*), parameter :: feet_words(5) = [character(7) :: 'ft', 'feet', 'usft', 'foot', 'kft']
   character(*), parameter :: metre_words(4) = [character(7) :: 'metre', 'metres', 'meter', 'meters']
   character(*), parameter :: angle_words(6) = [character(7) :: 'gon', 'gons', 'mrad', 'mils', 'radian', 'radians']
   !> Between a foot and a metre [m].
   real(wp), parameter :: short_unit = 0.5_wp

   !> Columns of a table and the SI values of their units.
   type :: layout_type
      character :: separator = ' '
      integer :: place(3) = 0                    !< column of md, inc, azi; 0: none
      integer :: width = 0                       !< columns that the header names
      real(wp) :: factor(3) = 1.0_wp
      logical :: told(3) = .false.               !< the table itself names the unit
      integer :: first_row = 0                   !< line below the header and its units
      logical :: has_null = .false.
      real(wp) :: null = 0.0_wp                  !< what stands for no value
      character(:), allocatable :: foreign       !< what is wrong with a unit, for a message; '': nothing
   end type layout_type

contains

   !> Finds header, columns and units. The header is the first line that names md and inc; where none does the first line is told
   !> to be a bad one. Rows of units may stand above or below it.
   subroutine find_layout(path, lines, units, units_told, layout, sound, faults)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(unit_system_type), intent(in) :: units     !< of columns whose unit is not told
      logical, intent(in) :: units_told               !< the deck says that they are those of this table
      type(layout_type), intent(out) :: layout
      logical, intent(out) :: sound
      type(fault_list_type), intent(inout) :: faults
      integer :: line, header, first_station
      sound = .true.
      layout%foreign = ''
      if (is_las(lines)) then
         call find_las_layout(path, lines, units, layout, sound, faults)
         return
      end if
      header = 0
      do line = 1, min(size(lines), header_lines)
         if (content_length(lines(line)%text) == 0) cycle
         call take_header(lines(line)%text, units, layout)
         if (all(layout%place(:column_inc) > 0)) exit
         if (header == 0) header = line
      end do
      if (any(layout%place(:column_inc) == 0)) then
         line = header
         if (header == 0) then
            sound = .false.
            call add_fault(faults, path, 0, 'survey file is empty; it needs a header naming md, inc, azi')
            return
         end if
         call take_header(lines(line)%text, units, layout)
         if (layout%place(column_md) == 0) call fault('the header names no md; it needs md, inc, azi')
         if (layout%place(column_inc) == 0) call fault('the header names no inc; it needs md, inc, azi')
         return
      end if
      header = line
      layout%first_row = header + 1
      call check_once()
      if (layout%foreign /= '') call fault(layout%foreign)
      do line = 1, header - 1
         call take_unit_row()
      end do
      do line = header + 1, size(lines)
         if (content_length(lines(line)%text) == 0) cycle
         if (.not. is_unit_row(lines(line)%text, layout)) exit
         call take_unit_row()
         layout%first_row = line + 1
      end do
      if (units_told) return
      first_station = line
      do line = 1, first_station - 1
         call check_title(lower_case(lines(line)%text))
      end do

   contains

      subroutine take_unit_row()
         if (.not. is_unit_row(lines(line)%text, layout)) return
         layout%foreign = ''
         call take_units(lines(line)%text, layout)
         if (layout%foreign /= '') call fault(layout%foreign)
      end subroutine take_unit_row

      !> Whether the header names a column twice by its own name.
      subroutine check_once()
         type(text_type), allocatable :: fields(:)
         character(:), allocatable :: name, unit
         integer :: i, column, times
         call split_fields(header_text(lines(header)%text, layout%separator), layout%separator, fields)
         do column = 1, 3
            times = 0
            do i = 1, size(fields)
               call split_unit(fields(i)%text, name, unit)
               if (name == column_name(column)) times = times + 1
            end do
            if (times > 1) call fault('the header names '//trim(column_name(column))//' twice; keep one')
         end do
      end subroutine check_once

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
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, path, line, 'survey: '//message)
      end subroutine fault
   end subroutine find_layout

   !> The same of a LAS file, whose curves have names and units.
   subroutine find_las_layout(path, lines, units, layout, sound, faults)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      logical, intent(inout) :: sound
      type(fault_list_type), intent(inout) :: faults
      type(text_type), allocatable :: names(:), las_units(:)
      character(:), allocatable :: null, failure
      allocate (names(0), las_units(0))     ! gfortran 12 warns of bounds that are not set else
      call las_table(lines, names, las_units, layout%separator, layout%first_row, null, failure)
      if (failure /= '') then
         sound = .false.
         call add_fault(faults, path, 0, 'survey: the LAS file '//failure)
         return
      end if
      call read_real(null, layout%null, layout%has_null)
      call match_columns(names, las_units, .true., units, layout)
      if (layout%place(column_md) == 0) call fault('the curves name no md (DEPT, DEPTH, MD)')
      if (layout%place(column_inc) == 0) call fault('the curves name no inc (INCL, INC, DEVI, DEV)')
      if (null /= '' .and. .not. layout%has_null) call fault('NULL = '//quoted(null)//' is no number')
      if (layout%foreign /= '') call fault(layout%foreign)

   contains

      subroutine fault(message)
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, path, layout%first_row - 1, 'survey: '//message)
      end subroutine fault
   end subroutine find_las_layout

   !> Columns by a line that may be the header; none where it names none. Where several separators stand in it, the one between
   !> names that we know counts.
   pure subroutine take_header(line, units, layout)
      character(*), intent(in) :: line
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      character(:), allocatable :: header, name, unit
      type(text_type), allocatable :: fields(:), names(:), bracketed(:)
      integer :: i, attempt
      character, parameter :: tab = achar(9)
      do attempt = 1, 2
         layout%separator = find_separator(without_comment(line))
         if (attempt == 2) layout%separator = tab      ! commas inside of headings
         header = header_text(line, layout%separator)
         call split_fields(header, layout%separator, fields)
         allocate (names(size(fields)), bracketed(size(fields)))
         do i = 1, size(fields)
            call split_heading(fields(i)%text, name, unit)
            names(i)%text = name
            bracketed(i)%text = unit
         end do
         call match_columns(names, bracketed, .false., units, layout)
         if (all(layout%place(:column_inc) > 0) .or. index(header, tab) == 0) exit
         deallocate (names, bracketed)
      end do
   end subroutine take_header

   !> A line of headings without comment. Where blanks separate its fields its brackets hold none, and names of two words
   !> are one.
   pure function header_text(line, separator) result(header)
      character(*), intent(in) :: line
      character, intent(in) :: separator
      character(:), allocatable :: header
      integer :: at
      header = without_comment(line)
      if (separator /= ' ') return
      header = close_brackets(header)
      at = index(lower_case(header), 'measured depth')
      if (at > 0) header = header(:at + len('measured') - 1)//'_'//header(at + len('measured '):)
   end function header_text

   !> Columns by their headings: the plain name goes before others, the first before later ones.
   pure subroutine match_columns(names, unit_names, las, units, layout)
      type(text_type), intent(in) :: names(:), unit_names(:)
      logical, intent(in) :: las
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      integer :: i, column
      logical :: is
      layout%place = 0
      layout%width = size(names)
      layout%factor = [units%length, units%angle, units%angle]
      layout%told = .false.
      layout%foreign = ''
      do column = 1, 3
         do i = size(names), 1, -1
            select case (column)
            case (column_md)
               is = any(md_names == names(i)%text) .or. (las .and. any(las_md_names == names(i)%text))
            case (column_inc)
               is = any(inc_names == names(i)%text) .or. (las .and. any(las_inc_names == names(i)%text))
            case default
               is = any(azi_names == names(i)%text)
            end select
            if (is) layout%place(column) = i
         end do
         do i = size(names), 1, -1
            if (names(i)%text == column_name(column)) layout%place(column) = i
         end do
         if (layout%place(column) > 0) call take_unit(layout, column, unit_names(layout%place(column))%text)
      end do
   end subroutine match_columns

   !> Sets the unit of a column, if the text names one ('MD (RKB)' does not). One that is unknown, or another than was told
   !> before, is kept for a fault.
   pure subroutine take_unit(layout, column, name)
      type(layout_type), intent(inout) :: layout
      integer, intent(in) :: column
      character(*), intent(in) :: name
      real(wp) :: value
      logical :: known
      call read_unit(name, column /= column_md, value, known)
      if (.not. known) then
         if (layout%foreign == '') layout%foreign = trim(column_name(column))//' in '//quoted(name)// &
            '; convert it: md in m, ft or usft, angles in deg or rad'
      else if (value > 0.0_wp) then
         if (layout%told(column) .and. abs(value - layout%factor(column)) > 0.0_wp .and. layout%foreign == '') &
            layout%foreign = trim(column_name(column))//' in '//quoted(name)//', but its heading or another row names another unit'
         layout%factor(column) = value
         layout%told(column) = .true.
      end if
   end subroutine take_unit

   !> Whether a line holds the units of the columns: (m), deg, ... What looks like a unit stands in two of the columns wanted; or
   !> in one, while the others are empty or told apart from words by their separator.
   pure function is_unit_row(line, layout) result(is)
      character(*), intent(in) :: line
      type(layout_type), intent(in) :: layout
      logical :: is
      type(row_type) :: row
      integer :: column, alike, filled
      real(wp) :: number
      logical :: legal
      is = .false.
      call split_row(without_comment(line), layout%separator, row)
      alike = 0
      filled = 0
      do column = 1, 3
         if (layout%place(column) == 0 .or. layout%place(column) > row%count) cycle
         associate (cell => row%text(row%first(layout%place(column)):row%last(layout%place(column))))
            call read_real(cell, number, legal)
            if (legal) return
            if (cell /= '') filled = filled + 1
            if (resembles_unit(cell, column /= column_md)) alike = alike + 1
         end associate
      end do
      is = alike >= 2 .or. (alike == 1 .and. (filled == 1 .or. layout%separator /= ' ') .and. row%count > 1)
   end function is_unit_row

   pure subroutine take_units(line, layout)
      character(*), intent(in) :: line
      type(layout_type), intent(inout) :: layout
      type(row_type) :: row
      integer :: column
      call split_row(without_comment(line), layout%separator, row)
      do column = 1, 3
         if (layout%place(column) == 0 .or. layout%place(column) > row%count) cycle
         call take_unit(layout, column, row%text(row%first(layout%place(column)):row%last(layout%place(column))))
      end do
   end subroutine take_units

   !> Whether one of some words stands in a text of small letters.
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
