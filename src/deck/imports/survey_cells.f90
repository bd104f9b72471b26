!> Cells of the rows of a survey table: between separators, or by their place below the headings.
module dg_survey_cells
   use dg_deck_number, only: is_number
   use dg_survey_columns, only: layout_type, no_extent
   use dg_table_number, only: plain_number
   use dg_table_text, only: content_length, split_row
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: count_numbers, find_extents, part_phrases, split_cells

   character, parameter :: tab = achar(9)

contains

   !> Numbers in a line, whatever separates them.
   pure function count_numbers(text) result(numbers)
      character(*), intent(in) :: text
      integer :: numbers
      type(text_type), allocatable :: row(:)
      character(len(text)) :: plain
      integer :: i
      numbers = 0
      if (content_length(text) == 0) return
      plain = text
      do i = 1, len(text)
         if (scan(text(i:i), ';|"'//tab) == 1) plain(i:i) = ' '
      end do
      call split_row(plain(:content_length(plain)), ' ', row)
      if (size(row) == 1) then
         do i = 1, len(plain)
            if (plain(i:i) == ',') plain(i:i) = ' '
         end do
         call split_row(plain(:content_length(plain)), ' ', row)
      end if
      numbers = count([(is_number(plain_number(row(i)%text, .false.)), i=1, size(row))])
   end function count_numbers

   !> Fields between which two blanks or more stand, or tabs.
   pure subroutine part_phrases(text, row)
      character(*), intent(in) :: text
      type(text_type), allocatable, intent(inout) :: row(:)
      character(len(text)) :: marked
      type(text_type), allocatable :: cells(:)
      integer :: i
      marked = text
      do i = 2, len(text)
         if (text(i - 1:i) == '  ') marked(i - 1:i) = tab//tab
      end do
      ! a single blank joins; a run of tabs parts once
      call split_row(marked, tab, cells)
      if (allocated(row)) deallocate (row)
      do i = 1, size(cells)
         if (cells(i)%text /= '') call append_text(row, cells(i)%text)
      end do
      if (.not. allocated(row)) allocate (row(0))
   end subroutine part_phrases

   !> First and last letters of the columns of rows that have as many fields as the first one. None if fields of neighbours are
   !> one above the other, or if tabs separate them.
   pure subroutine find_extents(lines, first_line, width, extent)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line      !< of the rows
      integer, intent(in) :: width           !< fields of a row
      integer, allocatable, intent(inout) :: extent(:, :)   !< (2, width), or (2, 0)
      integer, parameter :: most = 200
      integer :: found(2, width), line, k
      logical :: has
      if (allocated(extent)) deallocate (extent)
      allocate (extent(2, width))
      extent(1, :) = huge(0)
      extent(2, :) = 0
      do line = first_line, min(size(lines), first_line + most)
         if (count_numbers(lines(line)%text) < 2) cycle
         call find_fields(lines(line)%text, width, found, has)
         if (.not. has) cycle
         extent(1, :) = min(extent(1, :), found(1, :))
         extent(2, :) = max(extent(2, :), found(2, :))
      end do
      do k = 2, width
         if (extent(1, k) > extent(2, k - 1)) cycle
         call find_fields(lines(first_line)%text, width, found, has)
         if (has) then
            extent = found
         else
            extent = no_extent
         end if
         return
      end do
      if (any(extent(2, :) == 0)) then
         extent = no_extent
      end if
   end subroutine find_extents

   !> First and last letters of the fields between blanks of a line; whether it has so many, and neither tabs nor quotes.
   pure subroutine find_fields(text, width, found, has)
      character(*), intent(in) :: text
      integer, intent(in) :: width
      integer, intent(out) :: found(2, width)
      logical, intent(out) :: has
      integer :: i, n, length
      found = 0
      has = .false.
      length = content_length(text)
      if (scan(text(:length), tab//'"') > 0) return
      n = 0
      do i = 1, length
         if (text(i:i) == ' ') cycle
         if (i == 1) then
            n = n + 1
         else if (text(i - 1:i - 1) == ' ') then
            n = n + 1
         end if
         if (n > width) return
         if (found(1, n) == 0) found(1, n) = i
         found(2, n) = i
      end do
      has = n == width
   end subroutine find_fields

   !> Split a row into cells. A row between blanks with fewer fields than columns is read by the places of its fields, if each
   !> is below one column. One with more fields, because a name at its begin has several words, is read from its end.
   pure subroutine split_cells(text, layout, row)
      character(*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      type(text_type), allocatable, intent(inout) :: row(:)
      if (layout%wide) then
         call part_phrases(text, row)
         if (size(row) == layout%width) return
      end if
      call split_row(text, layout%separator, row)
      if (layout%separator /= ' ' .or. size(row) == layout%width) return
      if (size(row) < layout%width .and. size(layout%extent, 2) == layout%width) call place_fields(text, layout, row)
      if (size(row) > layout%width .and. .not. layout%wide) call join_first(layout, row)
   end subroutine split_cells

   !> Gives each field the column below which it stands alone; leaves the row as it is where one stands below none or two.
   pure subroutine place_fields(text, layout, row)
      character(*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      type(text_type), allocatable, intent(inout) :: row(:)
      type(text_type), allocatable :: placed(:)
      integer :: found(2, size(row)), column(size(row)), i, k, times
      logical :: has
      call find_fields(text, size(row), found, has)
      if (.not. has) return
      do i = 1, size(row)
         times = 0
         do k = 1, layout%width
            if (found(1, i) > layout%extent(2, k) .or. found(2, i) < layout%extent(1, k)) cycle
            times = times + 1
            column(i) = k
         end do
         if (times /= 1) return
      end do
      if (any(column(2:) <= column(:size(row) - 1))) return
      allocate (placed(0))
      do k = 1, layout%width
         call append_text(placed, '')
      end do
      do i = 1, size(row)
         placed(column(i))%text = row(i)%text
      end do
      call move_alloc(placed, row)
   end subroutine place_fields

   !> Joins the words of a name in the first column, where all fields behind it are numbers.
   pure subroutine join_first(layout, row)
      type(layout_type), intent(in) :: layout
      type(text_type), allocatable, intent(inout) :: row(:)
      integer :: i, more
      if (any(layout%place == 1) .or. layout%width < 2) return
      more = size(row) - layout%width
      do i = more + 2, size(row)
         if (.not. is_number(plain_number(row(i)%text, .false.))) return
      end do
      if (is_number(row(1)%text)) return
      do i = 1, more
         row(more + 1)%text = row(more + 1 - i)%text//row(more + 1)%text
      end do
      row = row(more + 1:)
   end subroutine join_first
end module dg_survey_cells
