!> Reads what another program printed: columns parted by comma, semicolon, tab or blanks, or at fixed places.
module dg_legacy_file
   use dg_kinds, only: wp
   use dg_constants, only: standard_gravity
   use dg_deck_number, only: read_real
   use dg_fault_list, only: add_fault, add_unreadable, fault_list_type, fault_type
   use dg_file_lines, only: read_lines
   use dg_table_number, only: doubt, doubtful_line, marks_type, read_cell
   use dg_table_text, only: blank_brackets, close_brackets, row_type, split_fields, split_row, split_unit, without_comment
   use dg_text, only: lower_case, quoted, suggestion, text_type, to_text
   use dg_units, only: field_units, si_units, unit_system_type
   implicit none
   private
   public :: column_type, column_count, column_name, read_legacy_file, unit_value

   integer, parameter :: column_count = 4
   character(*), parameter :: column_name(column_count) = [character(10) :: 'md', 'axial', 'torque', 'side_force']
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

contains

   !> Reads the columns of a file; without fault only where `sound`.
   subroutine read_legacy_file(path, skip, columns, md, values, has, sound, faults, asked)
      character(*), intent(in) :: path
      integer, intent(in) :: skip                          !< lines on top that are no part of the table
      type(column_type), intent(inout) :: columns(:)       !< (column_count)
      real(wp), allocatable, intent(out) :: md(:)          !< [m]
      real(wp), allocatable, intent(out) :: values(:, :)   !< (:, column_count - 1) [SI]
      logical, intent(out) :: has(:)                       !< (column_count - 1)
      logical, intent(out) :: sound
      type(fault_list_type), intent(inout) :: faults
      type(fault_type), intent(in), optional :: asked      !< where the deck names the file, for one that cannot be read
      type(text_type), allocatable :: lines(:), fields(:)
      type(row_type) :: row
      type(marks_type) :: marks
      character(:), allocatable :: failure, text
      real(wp), allocatable :: table(:, :)
      integer, allocatable :: line_of(:)
      character :: separator
      integer :: line, n, wide, c
      logical :: fixed, started, legal
      sound = .false.
      has = .false.
      call read_lines(path, lines, failure)
      if (failure /= '') then
         call add_unreadable(faults, path, 'legacy file '//failure, asked)
         return
      end if
      sound = .true.
      fixed = any(columns%last > 0)
      started = fixed
      separator = ' '
      wide = 0
      n = 0
      allocate (table(size(lines), column_count), source=0.0_wp)
      allocate (line_of(size(lines)), source=0)
      do line = skip + 1, size(lines)
         text = without_comment(lines(line)%text)
         if (text == '') cycle
         if (fixed) then
            n = n + 1
            call take_fixed(lines(line)%text)
            cycle
         end if
         if (.not. started) then
            started = .true.
            call find_separator(text, separator)
            call split_fields(close_brackets(text), separator, fields)
            wide = size(fields)
            call find_columns(fields)
            if (.not. sound) exit
            if (.not. is_data(fields)) cycle
         end if
         call split_row(text, separator, row)
         n = n + 1
         call take_row()
      end do
      line = doubtful_line(marks, separator == ',')
      if (sound .and. line > 0) call fault(line, doubt(marks, line))
      if (sound .and. n < 2) call fault(0, 'it has '//to_text(n)//' rows of numbers; two or more make a table')
      do line = 2, n
         if (.not. sound) exit
         if (table(line, 1) <= table(line - 1, 1)) &
            call fault(line_of(line), 'md = '//to_text(table(line, 1)/columns(1)%unit, depth_digits)//' is not below md = '// &
                       to_text(table(line - 1, 1)/columns(1)%unit, depth_digits)//' of line '//to_text(line_of(line - 1))// &
                       '; depths must increase')
      end do
      do c = 2, column_count
         has(c - 1) = columns(c)%number > 0 .or. columns(c)%last > 0
      end do
      if (sound .and. .not. any(has)) call fault(0, 'it has none of axial, torque, side_force; name at least one of its columns')
      allocate (md, source=table(:n, 1))
      allocate (values, source=table(:n, 2:))

   contains

      subroutine fault(where, message)
         integer, intent(in) :: where
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, path, where, 'legacy: '//message)
      end subroutine fault

      !> Columns by heading or number, and their units.
      subroutine find_columns(headings)
         type(text_type), intent(in) :: headings(:)
         character(heading_length) :: names(size(headings))
         character(:), allocatable :: name, unit
         integer :: i, k
         do i = 1, size(headings)
            names(i) = headings(i)%text
         end do
         do k = 1, column_count
            if (columns(k)%number > 0) then
               if (columns(k)%number > size(headings)) call fault(line, trim(column_name(k))//' is to be column '// &
                  to_text(columns(k)%number)//'; the table has '//to_text(size(headings)))
               if (.not. sound) cycle
               call split_unit(headings(columns(k)%number)%text, name, unit)
               call check_unit(k, unit)
               cycle
            end if
            do i = 1, size(headings)
               call split_unit(headings(i)%text, name, unit)
               if (.not. matches(k, name, unit)) cycle
               if (columns(k)%number > 0) call fault(line, 'the header names '//quoted(columns(k)%place)// &
                                                     ' twice; give '//trim(column_name(k))//' as the number of its column')
               columns(k)%number = i
               call check_unit(k, unit)
            end do
            if (columns(k)%number == 0 .and. columns(k)%required) &
               call fault(line, 'the header names no '//quoted(columns(k)%place)//' for '//trim(column_name(k))//'; '// &
                          suggestion(columns(k)%place, names))
         end do
      end subroutine find_columns

      !> Whether a heading is that of a column, plain or followed by _ and a unit, which then counts as bracketed.
      function matches(k, name, unit) result(is)
         integer, intent(in) :: k
         character(*), intent(in) :: name
         character(:), allocatable, intent(inout) :: unit
         logical :: is
         character(:), allocatable :: wanted
         wanted = lower_case(columns(k)%place)
         is = name == wanted
         if (is .or. len(name) < len(wanted) + 2) return
         if (name(:len(wanted) + 1) /= wanted//'_') return
         is = unit_value(k, name(len(wanted) + 2:)) > 0.0_wp
         if (is) unit = name(len(wanted) + 2:)
      end function matches

      !> A unit in the header must be the one in which the group reads the column, and one that is known unless the deck gives
      !> the column's own.
      subroutine check_unit(k, unit)
         integer, intent(in) :: k
         character(*), intent(in) :: unit
         real(wp), parameter :: same = 1.0e-6_wp
         if (unit_value(k, unit) <= 0.0_wp) then
            if (unit /= '' .and. .not. columns(k)%unit_given) call fault(line, 'the header gives '//trim(column_name(k))//' in '// &
               quoted(unit)//', which is unknown; set '//trim(column_name(k))//'_unit in the deck')
            return
         end if
         if (abs(unit_value(k, unit) - columns(k)%unit) <= same*columns(k)%unit) return
         call fault(line, 'the header gives '//trim(column_name(k))//' in '//unit//', the group &legacy reads it in '// &
                    columns(k)%unit_name//'; set '//trim(column_name(k))//'_unit, or units, in the deck')
      end subroutine check_unit

      !> Whether a first row is data already: columns given by number, no headings.
      function is_data(row) result(is)
         type(text_type), intent(in) :: row(:)
         logical :: is
         real(wp) :: number
         call read_real(row(columns(1)%number)%text, number, is)
      end function is_data

      subroutine take_row()
         integer :: k
         line_of(n) = line
         if (row%count /= wide) then
            call fault(line, 'the row has '//to_text(row%count)//' columns, the table '//to_text(wide))
            return
         end if
         do k = 1, column_count
            if (columns(k)%number == 0) cycle
            call take(k, row%text(row%first(columns(k)%number):row%last(columns(k)%number)))
         end do
      end subroutine take_row

      subroutine take_fixed(letters)
         character(*), intent(in) :: letters
         integer :: k
         line_of(n) = line
         do k = 1, column_count
            if (columns(k)%last == 0) cycle
            if (columns(k)%first > len(letters)) then
               call fault(line, 'the row ends at character '//to_text(len(letters))//', '//trim(column_name(k))//' begins at '// &
                          to_text(columns(k)%first))
            else
               call take(k, trim(adjustl(letters(columns(k)%first:min(columns(k)%last, len(letters))))))  ! editors cut blanks
            end if
         end do
      end subroutine take_fixed

      subroutine take(k, field)
         integer, intent(in) :: k
         character(*), intent(in) :: field
         real(wp) :: number
         call read_cell(field, separator == ',', line, marks, number, legal)
         table(n, k) = number*columns(k)%unit
         if (.not. legal) call fault(line, trim(column_name(k))//' = '//quoted(field)//' is no number')
      end subroutine take
   end subroutine read_legacy_file

   !> The character between columns of a row.
   pure subroutine find_separator(text, separator)
      character(*), intent(in) :: text
      character, intent(out) :: separator
      character(:), allocatable :: bare
      bare = blank_brackets(text)
      separator = ' '
      if (index(bare, achar(9)) > 0) separator = achar(9)
      if (index(bare, ',') > 0) separator = ','
      if (index(bare, ';') > 0) separator = ';'
   end subroutine find_separator

   !> SI value of a unit of a column, letter case, points and dashes aside; 0 where it is none.
   pure function unit_value(column, name) result(value)
      integer, intent(in) :: column
      character(*), intent(in) :: name
      real(wp) :: value
      type(unit_system_type) :: si, field
      character(:), allocatable :: plain
      character :: letter
      integer :: i
      real(wp), parameter :: thousandth = 1.0e-3_wp, ten = 10.0_wp
      plain = ''
      do i = 1, len(name)
         letter = lower_case(name(i:i))
         if (scan(letter, '.-* ') == 0) plain = plain//letter
      end do
      si = si_units()
      field = field_units()
      value = 0.0_wp
      select case (column)
      case (1)
         if (plain == 'm') value = si%length
         if (plain == 'ft') value = field%length
      case (2)
         if (plain == 'n') value = thousandth*si%force
         if (plain == 'dan') value = ten*thousandth*si%force
         if (plain == 'kn') value = si%force
         if (plain == 'kdan') value = ten*si%force
         if (plain == 't' .or. plain == 'tonne' .or. plain == 'tonnes') value = standard_gravity*si%force
         if (any(plain == [character(5) :: 'lbf', 'lb', 'lbs'])) value = thousandth*field%force
         if (any(plain == [character(5) :: 'klbf', 'klb', 'klbs', 'kip', 'kips'])) value = field%force
      case (3)
         if (plain == 'nm') value = thousandth*si%moment
         if (plain == 'knm') value = si%moment
         if (plain == 'ftlbf' .or. plain == 'lbfft') value = thousandth*field%moment
         if (plain == 'kftlbf') value = field%moment
      case default
         if (plain == 'n/m' .or. plain == 'n_m') value = thousandth*si%force_per_length
         if (plain == 'kn/m' .or. plain == 'kn_m') value = si%force_per_length
         if (plain == 'lbf/ft' .or. plain == 'lbf_ft') value = thousandth*field%force_per_length
         if (plain == 'klbf/ft' .or. plain == 'klbf_ft') value = field%force_per_length
      end select
   end function unit_value
end module dg_legacy_file
