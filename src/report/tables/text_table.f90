!> Printed tables. One statement puts a cell into a row: head, width and value of its column. The first row lays the head.
!>
!> A head may have several lines, with '|' between them. Words stand at the left of their column, numbers at the right. Words beside
!> a number keep two blanks between.
module dg_text_table
   use dg_kinds, only: wp
   use dg_line_list, only: add_line, line_list_type
   use dg_missing, only: known, optional_real
   use dg_number_text, only: count_cell, fixed_cell, left_aligned, right_aligned
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: text_table_type, add_cell, add_right, add_instead, end_row, close_rows, append_table

   integer, parameter :: most_heads = 4
   character(*), parameter :: head_end = '|'
   character(*), parameter :: word_gap = '  '

   !> A table as it is filled, row after row.
   type :: text_table_type
      private
      integer :: width = 0                       !< letters of the columns so far
      integer :: head_lines = 0
      type(text_type) :: heads(most_heads)
      logical :: is_headed = .false.             !< the first row is complete
      logical :: is_closed = .false.             !< a rule stands below the rows
      logical :: at_number = .false.             !< the last cell stands at the right of its column
      logical :: is_full = .false.               !< words stand in place of the other cells of the row
      character(:), allocatable :: row
      type(line_list_type) :: rows
   end type text_table_type

   !> Add the next cell of a row.
   interface add_cell
      module procedure add_words, add_count, add_number, add_optional
   end interface add_cell

contains

   !> Words at the left; cut with '...' where they leave no blank behind them.
   pure subroutine add_words(table, head, width, words)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      integer, intent(in) :: width
      character(*), intent(in) :: words
      if (table%at_number) call add_aligned(table, '', word_gap, .true.)
      call add_aligned(table, head, left_aligned(trim(words), width), .true.)
      table%at_number = .false.
   end subroutine add_words

   !> A count; '-' where it does not apply.
   pure subroutine add_count(table, head, width, count, applies)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      integer, intent(in) :: width
      integer, intent(in) :: count
      logical, intent(in), optional :: applies
      call add_right(table, head, width, count_cell(count, width, applies))
   end subroutine add_count

   !> A number in SI units, '-' where it is missing.
   pure subroutine add_number(table, head, width, value, unit, decimals)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      integer, intent(in) :: width
      real(wp), intent(in) :: value
      real(wp), intent(in) :: unit         !< SI value of one unit shown
      integer, intent(in) :: decimals
      call add_optional(table, head, width, known(value), unit, decimals)
   end subroutine add_number

   !> A number in SI units, '-' where it is absent.
   pure subroutine add_optional(table, head, width, value, unit, decimals)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      integer, intent(in) :: width
      type(optional_real), intent(in) :: value
      real(wp), intent(in) :: unit         !< SI value of one unit shown
      integer, intent(in) :: decimals
      call add_right(table, head, width, fixed_cell(value, unit, width, decimals))
   end subroutine add_optional

   !> Words at the right, as of a number with its mark.
   pure subroutine add_right(table, head, width, words)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      integer, intent(in) :: width
      character(*), intent(in) :: words
      call add_aligned(table, head, right_aligned(words, width), .false.)
      table%at_number = .true.
   end subroutine add_right

   !> Add a cell, and the head of its column where this is the first row.
   pure subroutine add_aligned(table, head, cell, at_left)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      character(*), intent(in) :: cell
      logical, intent(in) :: at_left
      if (.not. table%is_headed) call add_head(table, head, len(cell), at_left)
      if (table%is_full) return
      if (.not. allocated(table%row)) table%row = ''
      table%row = table%row//cell
   end subroutine add_aligned

   pure subroutine add_head(table, head, width, at_left)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: head
      integer, intent(in) :: width
      logical, intent(in) :: at_left
      character(width) :: shown
      character(:), allocatable :: rest
      integer :: i, cut
      rest = head
      do i = 1, most_heads
         cut = index(rest//head_end, head_end)
         if (at_left) shown = rest(:cut - 1)
         if (.not. at_left) shown = right_aligned(rest(:cut - 1), width)
         if (.not. allocated(table%heads(i)%text)) table%heads(i)%text = ''
         table%heads(i)%text = table%heads(i)%text//shown
         if (shown /= '') table%head_lines = max(table%head_lines, i)
         rest = rest(min(cut, len(rest)) + 1:)
      end do
      table%width = table%width + width
   end subroutine add_head

   !> Add words in place of the other cells of the row, behind one at least.
   pure subroutine add_instead(table, words)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: words
      table%row = table%row//words
      table%is_full = .true.
   end subroutine add_instead

   !> Ends a row, with a mark or a remark behind it.
   pure subroutine end_row(table, remark)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: remark
      call add_line(table%rows, trim(trim(table%row)//remark))
      table%row = ''
      table%is_headed = .true.
      table%is_full = .false.
      table%at_number = .false.
   end subroutine end_row

   !> Puts a rule below the rows so far; sums may follow.
   pure subroutine close_rows(table)
      type(text_table_type), intent(inout) :: table
      call add_line(table%rows, rule_of(table))
      table%is_closed = .true.
   end subroutine close_rows

   !> Appends the lines of a table: its head between rules, its rows, and a rule where none is below them. A rule that stands last
   !> in `lines` is that above the head.
   pure subroutine append_table(lines, table)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(text_table_type), intent(in) :: table
      integer :: i
      logical :: follows
      follows = .false.
      if (size(lines) > 0) follows = len(lines(size(lines))%text) > 0 .and. verify(lines(size(lines))%text, '-') == 0
      if (.not. follows) call append_text(lines, rule_of(table))
      do i = 1, table%head_lines
         call append_text(lines, trim(table%heads(i)%text))
      end do
      call append_text(lines, rule_of(table))
      do i = 1, table%rows%count
         call append_text(lines, table%rows%lines(i)%text)
      end do
      if (.not. table%is_closed) call append_text(lines, rule_of(table))
   end subroutine append_table

   pure function rule_of(table) result(rule)
      type(text_table_type), intent(in) :: table
      character(:), allocatable :: rule
      rule = repeat('-', table%width)
   end function rule_of
end module dg_text_table
