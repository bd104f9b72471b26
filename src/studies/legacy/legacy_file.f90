!> Reads what another program printed: columns parted by comma, semicolon, bar, tab or blanks, or at fixed places.
module dg_legacy_file
   use dg_kinds, only: wp
   use dg_constants, only: standard_gravity
   use dg_deck_number, only: read_real
   use dg_error, only: add_fault, add_unreadable, error_list_type, error_type
   use dg_file_lines, only: read_lines
   use dg_quantity, only: quantity_force, quantity_length, quantity_line_load, quantity_moment, rows, system_count
   use dg_readable, only: squeezed
   use dg_table_number, only: doubt, doubtful_line, marks_type, read_cell
   use dg_table_text, only: close_brackets, find_separator, skipped_rows_type, skipped_words, split_fields, split_row, &
                            split_unit, without_comment
   use dg_text, only: quoted, suggestion, text_type, to_text
   implicit none
   private
   public :: column_type, column_count, column_name, column_quantity, read_legacy_file, unit_value

   integer, parameter :: column_count = 4
   character(*), parameter :: column_name(column_count) = [character(10) :: 'md', 'axial', 'torque', 'side_force']
   integer, parameter :: column_quantity(column_count) = [quantity_length, quantity_force, quantity_moment, quantity_line_load]
   real(wp), parameter :: thousandth = 1.0e-3_wp
   !> Longest heading that a message repeats.
   integer, parameter :: heading_length = 40
   integer, parameter :: depth_digits = 9

   !> Where one quantity stands and in which unit.
   type :: column_type
      character(:), allocatable :: place     !< heading, number of the column, or places 'first:last' of its characters
      logical :: required = .false.
      real(wp) :: unit = 1.0_wp              !< SI value of one unit of the file
      character(:), allocatable :: unit_name
      logical :: unit_given = .false.       !< by the deck for this column: what the header says and nobody knows does not count
      integer :: number = 0                  !< of the column; 0: by heading, or fixed
      integer :: first = 0, last = 0         !< characters of a fixed column; 0: not fixed
   end type column_type

   !> The table as far as it is read.
   type :: table_type
      character(:), allocatable :: path
      real(wp), allocatable :: numbers(:, :)   !< (:, column_count) [SI]
      integer, allocatable :: line_of(:)       !< of its rows
      integer :: n = 0                         !< rows; the arrays have room for more
      integer :: line = 0                      !< that is read
      integer :: wide = 0                      !< columns of the header
      character :: separator = ' '
      type(marks_type) :: marks                !< how its numbers are written
      type(skipped_rows_type) :: commented     !< rows that begin with #
      logical :: sound = .true.
   end type table_type

contains

   !> Reads the columns of a file; without fault only where `sound`.
   subroutine read_legacy_file(path, skip, columns, md, values, skipped, sound, faults, asked)
      character(*), intent(in) :: path
      integer, intent(in) :: skip                          !< lines on top that are no part of the table
      type(column_type), intent(inout) :: columns(:)       !< (column_count)
      real(wp), allocatable, intent(out) :: md(:)          !< [m]
      real(wp), allocatable, intent(out) :: values(:, :)   !< (:, column_count - 1) [SI]
      character(:), allocatable, intent(out) :: skipped    !< rows that are not read, in words; '': all are
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      type(error_type), intent(in), optional :: asked      !< where the deck names the file, for one that cannot be read
      type(text_type), allocatable :: lines(:)
      type(table_type) :: table
      character(:), allocatable :: failure
      sound = .false.
      skipped = ''
      call read_lines(path, lines, failure)
      if (failure /= '') then
         call add_unreadable(faults, path, 'legacy file '//failure, asked)
         return
      end if
      table%path = path
      allocate (table%numbers(size(lines), column_count), source=0.0_wp)
      allocate (table%line_of(size(lines)), source=0)
      call read_rows(lines, skip, columns, table, faults)
      call check_rows(columns, table, faults)
      if (table%sound .and. .not. any(columns(2:column_count)%number > 0 .or. columns(2:column_count)%last > 0)) &
         call fault(table, 0, 'it has no column axial, torque or side_force; name at least one of its columns', faults)
      sound = table%sound
      skipped = skipped_words([table%commented], ['that begin with #'])
      allocate (md, source=table%numbers(:table%n, 1))
      allocate (values, source=table%numbers(:table%n, 2:))
   end subroutine read_legacy_file

   !> A fault of the file, or of a line in it; the table is then not sound.
   subroutine fault(table, line, message, faults)
      type(table_type), intent(inout) :: table
      integer, intent(in) :: line
      character(*), intent(in) :: message
      type(error_list_type), intent(inout) :: faults
      table%sound = .false.
      call add_fault(faults, table%path, line, 'legacy: '//message)
   end subroutine fault

   !> Rows of numbers from the lines below those that are skipped: header first, unless columns are fixed.
   subroutine read_rows(lines, skip, columns, table, faults)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: skip
      type(column_type), intent(inout) :: columns(:)
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: fields(:)
      character(:), allocatable :: text
      real(wp) :: number
      logical :: fixed, started, is_data
      integer :: k, line
      fixed = any(columns%last > 0)
      started = fixed
      do line = skip + 1, size(lines)
         text = without_comment(lines(line)%text)
         table%line = line
         if (text == '') then
            if (started .and. has_depth(lines(line)%text, columns(1), table)) call table%commented%add(line)
            cycle
         end if
         if (.not. started) then
            started = .true.
            table%separator = find_separator(text)
            call split_fields(close_brackets(text), table%separator, fields)
            table%wide = size(fields)
            call find_columns(fields, columns, table, faults)
            if (.not. table%sound) exit
            call read_real(fields(columns(1)%number)%text, number, is_data)
            if (.not. is_data) cycle                ! headings
         else if (table%n == 0 .and. .not. fixed) then
            call split_fields(close_brackets(text), table%separator, fields)
            if (is_row_of_units(columns, fields)) then
               do k = 1, column_count
                  if (columns(k)%number > 0) call check_unit(k, columns(k), unit_in(fields(columns(k)%number)%text), table, faults)
               end do
               cycle
            end if
         end if
         table%n = table%n + 1
         table%line_of(table%n) = line
         if (fixed) then
            call read_fixed(lines(line)%text, columns, table, faults)
         else
            call read_row(text, columns, table, faults)
         end if
      end do
   end subroutine read_rows

   !> True if a comment line would be a row without its comment mark: a depth stands in the column of depths.
   function has_depth(text, column, table) result(has)
      character(*), intent(in) :: text
      type(column_type), intent(in) :: column      !< of measured depth
      type(table_type), intent(in) :: table
      logical :: has
      type(text_type), allocatable :: row(:)
      type(marks_type) :: unused
      real(wp) :: number
      integer :: mark
      has = .false.
      mark = index(text, '#')
      if (mark == 0) return
      if (column%last > 0) then
         if (column%first > len(text)) return
         associate (letters => text(:mark - 1)//' '//text(mark + 1:))
            call read_real(trim(adjustl(letters(column%first:min(column%last, len(letters))))), number, has)
         end associate
      else
         call split_row(text(:mark - 1)//text(mark + 1:), table%separator, row)
         if (column%number > size(row) .or. size(row) /= table%wide) return
         call read_cell(row(column%number)%text, table%separator == ',', table%line, unused, number, has)
      end if
   end function has_depth

   !> Check that numbers are written in one way, rows are two or more, and depths increase. A depth may have two rows, as at a
   !> change of component, the upper side first.
   subroutine check_rows(columns, table, faults)
      type(column_type), intent(in) :: columns(:)
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      integer :: line, i
      line = doubtful_line(table%marks, table%separator == ',')
      if (table%sound .and. line > 0) call fault(table, line, doubt(table%marks, line), faults)
      if (table%sound .and. table%n < 2) &
         call fault(table, 0, 'it has '//to_text(table%n)//' rows of numbers; two or more make a table', faults)
      do i = 2, table%n
         if (.not. table%sound) exit
         associate (md => table%numbers(i - 1:i, 1), unit => columns(1)%unit)
            if (md(2) > md(1)) cycle
            if (md(2) >= md(1) .and. (i == 2 .or. table%numbers(max(i - 2, 1), 1) < md(1))) cycle
            call fault(table, table%line_of(i), 'md = '//to_text(md(2)/unit, depth_digits)// &
               ' is not below md = '//to_text(md(1)/unit, depth_digits)//' of line '//to_text(table%line_of(i - 1))// &
               '; depths must increase', faults)
         end associate
      end do
   end subroutine check_rows

   !> Columns by heading or number, and their units.
   subroutine find_columns(headings, columns, table, faults)
      type(text_type), intent(in) :: headings(:)
      type(column_type), intent(inout) :: columns(:)
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      character(heading_length) :: names(size(headings))
      character(:), allocatable :: name, unit, advice
      integer :: i, k
      do i = 1, size(headings)
         names(i) = headings(i)%text
      end do
      do k = 1, column_count
         if (columns(k)%number > 0) then
            if (columns(k)%number > size(headings)) call fault(table, table%line, trim(column_name(k))//' is to be column '// &
               to_text(columns(k)%number)//'; the table has '//to_text(size(headings)), faults)
            if (.not. table%sound) cycle
            call split_unit(headings(columns(k)%number)%text, name, unit)
            call check_unit(k, columns(k), unit, table, faults)
            cycle
         end if
         do i = 1, size(headings)
            call split_unit(headings(i)%text, name, unit)
            if (.not. matches(k, columns(k)%place, name, unit)) cycle
            if (columns(k)%number > 0) call fault(table, table%line, 'the header names '//quoted(columns(k)%place)// &
               ' twice; give '//trim(column_name(k))//' as the number of its column', faults)
            columns(k)%number = i
            call check_unit(k, columns(k), unit, table, faults)
         end do
         if (columns(k)%number > 0 .or. .not. columns(k)%required) cycle
         advice = suggestion(columns(k)%place, names)
         if (index(advice, 'legal: ') == 1) advice = 'headings found'//advice(6:)//'. Write '//trim(column_name(k))// &
            ' = the heading, or skip = the number of lines above the headings. If headings have blanks, skip them too and '// &
            'give the number of the column'
         call fault(table, table%line, 'the header names no '//quoted(columns(k)%place)//' for '//trim(column_name(k))// &
                    '; '//advice, faults)
      end do
   end subroutine find_columns

   !> True if a heading is that of a column, plain or followed by _ and a unit. The unit then counts as bracketed.
   function matches(k, place, name, unit) result(is)
      integer, intent(in) :: k
      character(*), intent(in) :: place        !< heading that is looked for
      character(*), intent(in) :: name
      character(:), allocatable, intent(inout) :: unit
      logical :: is
      character(:), allocatable :: wanted, in_brackets
      call split_unit(squeezed(place, ''), wanted, in_brackets)
      is = squeezed(name, '_') == squeezed(wanted, '_')
      if (is .or. len(name) < len(wanted) + 2) return
      if (name(:len(wanted) + 1) /= wanted//'_') return
      is = unit_value(k, name(len(wanted) + 2:)) > 0.0_wp
      if (is) unit = name(len(wanted) + 2:)
   end function matches

   !> Check a unit in the header. It must be that of the column in the group, and a known one unless the deck gives the
   !> column's own.
   subroutine check_unit(k, column, unit, table, faults)
      integer, intent(in) :: k
      type(column_type), intent(in) :: column
      character(*), intent(in) :: unit
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      real(wp), parameter :: same = 1.0e-6_wp
      if (unit_value(k, unit) <= 0.0_wp) then
         if (unit /= '' .and. .not. column%unit_given) call fault(table, table%line, 'the header gives '// &
            trim(column_name(k))//' in '//quoted(unit)//', which is unknown; set '//trim(column_name(k))// &
            '_unit in the deck', faults)
         return
      end if
      if (abs(unit_value(k, unit) - column%unit) <= same*column%unit) return
      call fault(table, table%line, 'the header gives '//trim(column_name(k))//' in '//unit// &
                 ', the group &legacy reads it in '//column%unit_name//'; set '//trim(column_name(k))// &
                 '_unit, or units, in the deck', faults)
   end subroutine check_unit

   !> True if a row below the headings gives the units of all columns that are read.
   function is_row_of_units(columns, row) result(is)
      type(column_type), intent(in) :: columns(:)
      type(text_type), intent(in) :: row(:)
      logical :: is
      integer :: k
      is = size(row) >= maxval(columns%number)
      if (.not. is) return
      do k = 1, column_count
         if (columns(k)%number > 0) is = is .and. unit_value(k, unit_in(row(columns(k)%number)%text)) > 0.0_wp
      end do
   end function is_row_of_units

   !> The unit that a cell holds, in brackets or not.
   function unit_in(cell) result(unit)
      character(*), intent(in) :: cell
      character(:), allocatable :: unit, name
      call split_unit(cell, name, unit)
      if (unit == '') unit = name
   end function unit_in

   !> The last row of the table, from columns that are parted.
   subroutine read_row(text, columns, table, faults)
      character(*), intent(in) :: text
      type(column_type), intent(in) :: columns(:)
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: row(:)
      integer :: k
      call split_row(text, table%separator, row)
      if (size(row) /= table%wide) then
         call fault(table, table%line, 'the row has '//to_text(size(row))//' columns, the table '//to_text(table%wide), faults)
         return
      end if
      do k = 1, column_count
         if (columns(k)%number == 0) cycle
         call read_field(k, columns(k), row(columns(k)%number)%text, table, faults)
      end do
   end subroutine read_row

   !> The same from columns at fixed places.
   subroutine read_fixed(letters, columns, table, faults)
      character(*), intent(in) :: letters
      type(column_type), intent(in) :: columns(:)
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      integer :: k
      do k = 1, column_count
         associate (first => columns(k)%first, last => columns(k)%last)
            if (last == 0) cycle
            if (first > len(letters)) then
               call fault(table, table%line, 'the row ends at character '//to_text(len(letters))//', '// &
                          trim(column_name(k))//' begins at '//to_text(first), faults)
            else
               ! editors cut blanks
               call read_field(k, columns(k), trim(adjustl(letters(first:min(last, len(letters))))), table, faults)
            end if
         end associate
      end do
   end subroutine read_fixed

   !> One number of the last row.
   subroutine read_field(k, column, field, table, faults)
      integer, intent(in) :: k
      type(column_type), intent(in) :: column
      character(*), intent(in) :: field
      type(table_type), intent(inout) :: table
      type(error_list_type), intent(inout) :: faults
      real(wp) :: number
      logical :: legal
      call read_cell(field, table%separator == ',', table%line, table%marks, number, legal)
      table%numbers(table%n, k) = number*column%unit
      if (.not. legal) call fault(table, table%line, trim(column_name(k))//' = '//quoted(field)//' is not a number', faults)
   end subroutine read_field

   !> SI value of a unit of a column, letter case, points, dashes and stars aside; 0 where it is none.
   pure recursive function unit_value(column, name) result(value)
      integer, intent(in) :: column
      character(*), intent(in) :: name
      real(wp) :: value
      character(:), allocatable :: plain
      character(*), parameter :: marks = '.-*'
      integer :: system
      plain = squeezed(name, marks)
      value = 0.0_wp
      do system = 1, system_count
         associate (unit => rows(column_quantity(column))%units(system))
            if (plain == squeezed(unit%label, marks) .or. plain == squeezed(unit%suffix, marks)) value = unit%factor
            if (unit%alike /= '' .and. plain == squeezed(unit%alike, marks)) value = unit%factor/unit%alike_count
         end associate
      end do
      select case (column_quantity(column))
      case (quantity_force)
         if (any(plain == [character(6) :: 't', 'tonne', 'tonnes'])) value = standard_gravity*unit_value(column, 'kN')
         if (any(plain == [character(3) :: 'lb', 'lbs'])) value = unit_value(column, 'lbf')
         if (any(plain == [character(4) :: 'klb', 'klbs', 'kip', 'kips'])) value = unit_value(column, 'klbf')
      case (quantity_moment)
         if (plain == 'lbfft') value = unit_value(column, 'ft.lbf')
      case (quantity_line_load)
         if (plain == 'lbf/ft' .or. plain == 'lbf_ft') value = thousandth*unit_value(column, 'klbf/ft')
      case default
      end select
   end function unit_value
end module dg_legacy_file
