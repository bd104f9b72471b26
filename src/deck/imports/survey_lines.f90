!> Lines of a survey file without a station, and lines that may be a damaged station.
module dg_survey_lines
   use dg_deck_number, only: is_number
   use dg_readable, only: squeezed
   use dg_survey_columns, only: layout_type
   use dg_survey_heading, only: column_md
   use dg_survey_layout, only: is_unit_row
   use dg_table_number, only: plain_number
   use dg_table_text, only: content_length
   use dg_text, only: lower_case, text_type
   implicit none
   private
   public :: is_text, longest_run, is_header_again, is_error_cell, is_quadrant

   character(*), parameter :: digits = '0123456789', letters = 'abcdefghijklmnopqrstuvwxyz'

contains

   !> True if a line without all three numbers is text: a footer, a note, the title of a page. A line that may be a damaged station
   !> is not text. It has two of the three numbers or md, numbers side by side, or a cell that begins like a number.
   pure function is_text(row, layout, legal) result(is)
      type(text_type), intent(in) :: row(:)
      type(layout_type), intent(in) :: layout
      logical, intent(in) :: legal(3)
      logical :: is
      integer :: numbers, k, place
      is = .false.
      if (.not. any([(scan(lower_case(row(k)%text), letters) > 0, k=1, size(row))])) return
      numbers = count(legal .and. layout%place(:3) > 0)
      if (size(row) == layout%width) then
         if (numbers > merge(1, 0, layout%separator == ' ') .or. legal(column_md)) return
         if (numbers == 1 .and. count_words(row) < 2) return
         do k = 1, 3
            place = layout%place(k)
            if (place == 0 .or. legal(k)) cycle
            if (may_be_number(row(place)%text)) return
         end do
      else
         if (numbers > 1 .or. may_be_number(row(1)%text)) return
         if (legal(column_md) .and. layout%place(column_md) == 1) return
      end if
      is = longest_run(row) < 2
   end function is_text

   !> Cells that hold a word of two letters or more, other than those for a value that is absent or wrong.
   pure function count_words(row) result(words)
      type(text_type), intent(in) :: row(:)
      integer :: words
      character(*), parameter :: no_words(9) = [character(5) :: 'na', 'nan', 'null', 'none', 'err', 'error', 'bad', 'fail', 'inf']
      character(:), allocatable :: text
      integer :: i
      words = 0
      do i = 1, size(row)
         text = lower_case(row(i)%text)
         if (len(text) > 1 .and. verify(text, letters//':,.') == 0 .and. .not. any(no_words == text)) words = words + 1
      end do
   end function count_words

   !> True if a cell is a number that may be damaged: it begins like one, or is mostly digits, and is no date or time.
   pure function may_be_number(text) result(may)
      character(*), intent(in) :: text
      logical :: may
      integer :: first
      may = .false.
      if (len(text) == 0) return
      first = 1
      if (scan(text(1:1), '+-.,') == 1 .and. len(text) > 1) first = 2
      may = scan(text(first:first), digits) == 1 .or. 3*count_in(text, digits) > 2*len(text)
      if (index(text, ')') == len(text) .or. index(text, ' ') > 0) may = may .and. count_in(text, digits) > len(text)/2
      if (first > 1) return
      if (count_in(text, '/') == 2 .or. count_in(text, ':') > 0 .or. count_in(text, '-') == 2) may = .false.
      if (count_in(text, '.') == 2 .and. verify(text, digits//'.') == 0) may = len(text) < 8 .or. len(text) > 10
   end function may_be_number

   pure function count_in(text, set) result(number)
      character(*), intent(in) :: text, set
      integer :: number
      integer :: i
      number = 0
      do i = 1, len(text)
         if (scan(text(i:i), set) == 1) number = number + 1
      end do
   end function count_in

   !> Numbers that stand side by side in a row, the most.
   pure function longest_run(row) result(longest)
      type(text_type), intent(in) :: row(:)
      integer :: longest
      integer :: i, run
      longest = 0
      run = 0
      do i = 1, size(row)
         run = merge(run + 1, 0, is_number(plain_number(row(i)%text, .false.)))
         longest = max(longest, run)
      end do
   end function longest_run

   !> True if a line repeats the header, or its units.
   pure function is_header_again(lines, layout, line) result(is)
      type(text_type), intent(in) :: lines(:)
      type(layout_type), intent(in) :: layout
      integer, intent(in) :: line
      logical :: is
      integer :: i
      is = .false.
      do i = max(layout%first_header, 1), min(layout%first_row - 1, size(lines))
         if (content_length(lines(i)%text) > 0) is = is .or. squeezed(lines(i)%text, '') == squeezed(lines(line)%text, '')
      end do
      if (.not. is) is = is_unit_row(lines(line)%text, layout)
   end function is_header_again

   !> True if a line begins with a spreadsheet's mark of an error: #N/A, #REF!, ...
   pure function is_error_cell(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      character(*), parameter :: errors(6) = [character(8) :: '#n/a', '#ref!', '#value!', '#num!', '#div/0!', '#name?']
      character(:), allocatable :: plain
      integer :: i
      plain = lower_case(adjustl(text))
      is = .false.
      do i = 1, size(errors)
         is = is .or. index(plain, trim(errors(i))) == 1
      end do
   end function is_error_cell

   !> True if a text is a bearing such as N 45 E.
   pure function is_quadrant(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      character(len(text)) :: plain
      plain = lower_case(text)
      is = .false.
      if (len(text) > 1) is = scan(plain(1:1), 'ns') == 1 .and. (scan(plain, digits) > 0 .or. scan(trim(plain), 'ew') > 0)
   end function is_quadrant
end module dg_survey_lines
