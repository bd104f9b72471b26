!> Numbers in the cells of tables: decimal points and decimal commas, marks between thousands.
!>
!> A cell by itself may be read in two ways: 1,234 is one and a quarter or one thousand. Each is read in the more likely way,
!> and the evidence of other cells is kept. A table that contradicts that reading, or leaves it open, can then be refused.
module dg_table_number
   use dg_kinds, only: wp
   use dg_deck_number, only: read_real
   use dg_text, only: quoted, to_text
   implicit none
   private
   public :: marks_type, read_cell, plain_number, doubtful_line, doubt

   character(*), parameter :: digits = '0123456789'
   character(*), parameter :: number_letters = digits//'+-.,eEdD'
   !> Digits between two marks of thousands.
   integer, parameter :: group = 3

   !> Marks of numbers in the cells of a table: the line of the first cell with each mark, 0 if absent.
   type :: marks_type
      integer :: decimal_point = 0      !< 45.5 or 1,234.5
      integer :: decimal_comma = 0      !< 45,5 or 1.234,5
      integer :: either_point = 0       !< 1.234
      integer :: either_comma = 0       !< 1,234
      character(:), allocatable :: point_text, comma_text  !< those cells
   end type marks_type

contains

   !> Reads the number in a cell, `legal` where it is one, and notes its marks.
   pure subroutine read_cell(cell, groups, line, marks, number, legal)
      character(*), intent(in) :: cell
      logical, intent(in) :: groups        !< as for plain_number
      integer, intent(in) :: line
      type(marks_type), intent(inout) :: marks
      real(wp), intent(out) :: number
      logical, intent(out) :: legal
      integer :: point, comma
      call read_real(cell, number, legal)
      if (legal) then
         point = index(cell, '.')
         if (point == 0) return
         if (marks%decimal_point > 0 .and. marks%either_point > 0) return
         if (may_part_thousands(cell, point)) then
            if (marks%either_point == 0) then
               marks%either_point = line
               marks%point_text = cell
            end if
         else if (marks%decimal_point == 0) then
            marks%decimal_point = line
         end if
         return
      end if
      comma = index(cell, ',')
      if (comma == 0) return
      call read_real(plain_number(cell, groups), number, legal)
      if (.not. legal) return
      if (index(cell, '.') > comma .or. index(cell, ',', back=.true.) > comma) then
         if (marks%decimal_point == 0) marks%decimal_point = line
      else if (index(cell, '.') == 0 .and. may_part_thousands(cell, comma)) then
         if (marks%either_comma == 0) then
            marks%either_comma = line
            marks%comma_text = cell
         end if
      else if (marks%decimal_comma == 0) then
         marks%decimal_comma = line
      end if
   end subroutine read_cell

   !> Line of the first cell whose mark the table leaves open; 0 if all are clear. A comma before three digits is clear if
   !> other cells have decimal commas and none has a decimal point. Between `groups` it separates thousands unless another cell
   !> has a decimal comma. A point is decimal unless other cells have decimal commas.
   pure function doubtful_line(marks, groups) result(line)
      type(marks_type), intent(in) :: marks
      logical, intent(in) :: groups
      integer :: line
      line = 0
      if (marks%either_comma > 0) then
         if (groups .and. marks%decimal_comma > 0) line = marks%either_comma
         if (.not. groups .and. (marks%decimal_comma == 0 .or. marks%decimal_point > 0)) line = marks%either_comma
      end if
      if (line == 0 .and. marks%either_point > 0 .and. marks%decimal_comma > 0) line = marks%either_point
   end function doubtful_line

   !> Message on a doubtful mark of numbers.
   pure function doubt(marks, line) result(message)
      type(marks_type), intent(in) :: marks
      integer, intent(in) :: line       !< that of doubtful_line
      character(:), allocatable :: message
      if (line == marks%either_comma) then
         message = quoted(marks%comma_text)//' may have a decimal comma or one between thousands'
      else
         message = quoted(marks%point_text)//' may have a decimal point or one between thousands (line '// &
                   to_text(marks%decimal_comma)//' has a decimal comma)'
      end if
      message = message//'; write numbers without marks between thousands, with decimal points'
   end function doubt

   !> A number with commas as Fortran reads it; any other text as it is. Of point and comma the last is the decimal mark; one
   !> comma alone is decimal, unless `groups` says that commas before three digits part thousands. What parts thousands must
   !> stand before three digits each.
   pure function plain_number(field, groups) result(plain)
      character(*), intent(in) :: field
      logical, intent(in) :: groups
      character(:), allocatable :: plain
      character :: decimal, thousands
      integer :: i, comma, last
      plain = field
      comma = index(field, ',', back=.true.)
      if (comma == 0 .or. verify(field, number_letters) > 0) return
      decimal = ','
      if (index(field, '.', back=.true.) > comma) decimal = '.'
      if (index(field, '.') == 0) then
         if (index(field, ',') /= comma) decimal = '.'          ! several: thousands
         if (groups .and. may_part_thousands(field, comma)) decimal = '.'
      end if
      thousands = merge(',', '.', decimal == '.')
      last = scan(field, decimal//'eEdD') - 1
      if (last < 0) last = len(field)
      if (.not. well_parted(field(:last), thousands) .or. index(field(last + 1:), thousands) > 0) return
      plain = ''
      do i = 1, len(field)
         if (field(i:i) == decimal) then
            plain = plain//'.'
         else if (field(i:i) /= thousands) then
            plain = plain//field(i:i)
         end if
      end do
   end function plain_number

   !> True if a mark may part thousands. One to three digits stand before it, the first not 0, and three digits behind it end the
   !> cell.
   pure function may_part_thousands(cell, mark) result(may)
      character(*), intent(in) :: cell
      integer, intent(in) :: mark
      logical :: may
      integer :: first
      may = .false.
      if (len(cell) - mark /= group .or. mark == 1) return
      first = 1
      if (scan(cell(1:1), '+-') == 1) first = 2
      if (mark - first < 1 .or. mark - first > group) return
      if (cell(first:first) == '0') return
      may = verify(cell(first:mark - 1), digits) == 0 .and. verify(cell(mark + 1:), digits) == 0
   end function may_part_thousands

   !> True if a whole number has its marks before three digits each, or none.
   pure function well_parted(whole, mark) result(well)
      character(*), intent(in) :: whole
      character, intent(in) :: mark
      logical :: well
      integer :: i, since
      well = .true.
      if (index(whole, mark) == 0) return
      since = 0
      do i = len(whole), 1, -1
         if (whole(i:i) == mark) then
            well = well .and. since == group
            since = 0
         else if (scan(whole(i:i), digits) == 1) then
            since = since + 1
         end if
      end do
      well = well .and. since >= 1 .and. since <= group
   end function well_parted
end module dg_table_number
