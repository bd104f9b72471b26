!> Rows and headings of tables as people have them: separators, quotes, comments, units behind names.
module dg_table_text
   use dg_table_number, only: plain_number
   use dg_text, only: lower_case, text_type, to_text
   implicit none
   private
   public :: skipped_rows_type, skipped_words
   public :: row_type, blank_brackets, close_brackets, content_length, find_separator, split_fields, split_row, squeezed, &
             split_unit, without_comment

   character(*), parameter :: tab = achar(9)
   integer, parameter :: first_capacity = 16
   !> gfortran 12 compares a letter with a blank by a call of its library, with a code at once.
   integer, parameter :: blank_code = iachar(' ')

   !> The fields of a row, kept in place from row to row: a list of texts would cost more than all else that reading does.
   type :: row_type
      integer :: count = 0
      integer, allocatable :: first(:), last(:)   !< letters of each field in `text`
      character(:), allocatable :: text           !< without quotes
   end type row_type

   !> Rows that are not read, of one kind.
   type :: skipped_rows_type
      integer :: count = 0
      integer :: first_line = 0
   contains
      procedure :: add
   end type skipped_rows_type

contains

   pure subroutine add(rows, line)
      class(skipped_rows_type), intent(inout) :: rows
      integer, intent(in) :: line
      if (rows%count == 0) rows%first_line = line
      rows%count = rows%count + 1
   end subroutine add

   !> Numbers of skipped rows in words: 'rows skipped: 2 that begin with # (first in line 7)'; '' where there are none.
   pure function skipped_words(rows, kinds) result(words)
      type(skipped_rows_type), intent(in) :: rows(:)
      character(*), intent(in) :: kinds(:)        !< of each
      character(:), allocatable :: words
      integer :: i
      words = ''
      do i = 1, size(rows)
         if (rows(i)%count == 0) cycle
         if (words /= '') words = words//', '
         words = words//to_text(rows(i)%count)//' '//trim(kinds(i))//' (first in line '//to_text(rows(i)%first_line)//')'
      end do
      if (words /= '') words = 'rows skipped: '//words
   end function skipped_words

   !> What separates the fields of a header: ; , | tab or blanks. Brackets do not count.
   pure function find_separator(header) result(separator)
      character(*), intent(in) :: header
      character :: separator
      character(len(header)) :: bare
      bare = blank_brackets(header)
      separator = ' '
      if (index(bare, tab) > 0) separator = tab
      if (index(bare, ',') > 0) separator = ','
      if (index(bare, ';') > 0) separator = ';'
      if (index(bare, '|') > 0) separator = '|'
   end function find_separator

   !> Name and bracketed unit of a heading, both lower case: 'MD (m)' gives md and m.
   pure subroutine split_unit(heading, name, unit)
      character(*), intent(in) :: heading
      character(:), allocatable, intent(out) :: name, unit
      integer :: bracket
      bracket = scan(heading, '([')
      if (bracket == 0) then
         name = trim(adjustl(lower_case(heading)))
         unit = ''
      else
         name = trim(adjustl(lower_case(heading(:bracket - 1))))
         unit = trim(adjustl(lower_case(heading(bracket + 1:))))
         if (len(unit) > 0) then
            if (scan(unit(len(unit):), ')]') == 1) unit = trim(unit(:len(unit) - 1))
         end if
      end if
   end subroutine split_unit

   !> The text with brackets and what they hold made blank.
   pure function blank_brackets(text) result(bare)
      character(*), intent(in) :: text
      character(len(text)) :: bare
      integer :: i, depth
      depth = 0
      bare = text
      do i = 1, len(text)
         if (scan(text(i:i), '([') == 1) depth = depth + 1
         if (depth > 0) bare(i:i) = ' '
         if (scan(text(i:i), ')]') == 1) depth = max(depth - 1, 0)
      end do
   end function blank_brackets

   !> The text without blanks before and inside brackets, so that 'MD (m)' is one field. With `joint` blanks inside become one '_',
   !> so that the words of 'MD (from RKB)' stay apart.
   pure function close_brackets(text, joint) result(tight)
      character(*), intent(in) :: text
      logical, intent(in), optional :: joint       !< absent: no
      character(:), allocatable :: tight
      logical :: joined
      integer :: i, depth
      joined = .false.
      if (present(joint)) joined = joint
      depth = 0
      tight = ''
      do i = 1, len(text)
         if (scan(text(i:i), '([') == 1) then
            depth = depth + 1
            tight = trim(tight)
         end if
         if (depth == 0 .or. scan(text(i:i), ' '//tab) == 0) then
            tight = tight//text(i:i)
         else if (joined) then
            if (scan(tight(len(tight):), '([_') == 0) tight = tight//'_'
         end if
         if (scan(text(i:i), ')]') == 1) depth = max(depth - 1, 0)
      end do
   end function close_brackets

   !> Small letters without blanks, tabs and the letters of `also`.
   pure function squeezed(text, also) result(tight)
      character(*), intent(in) :: text
      character(*), intent(in) :: also
      character(:), allocatable :: tight
      integer :: i
      tight = ''
      do i = 1, len(text)
         if (scan(text(i:i), ' '//tab//also) == 0) tight = tight//lower_case(text(i:i))
      end do
   end function squeezed

   !> A line without its comment; '' where nothing but blanks, tabs and separators stands before it.
   pure function without_comment(line) result(text)
      character(*), intent(in) :: line
      character(:), allocatable :: text
      text = line(:content_length(line))
   end function without_comment

   !> Length of a line without its comment; 0 where nothing but blanks, tabs and separators stands before it, as in the rows of
   !> empty cells that spreadsheets leave.
   pure function content_length(line) result(length)
      character(*), intent(in) :: line
      integer :: length
      integer :: i
      logical :: blank
      blank = .true.
      length = 0
      do i = 1, len(line)
         if (line(i:i) == '#') exit
         length = i
         select case (line(i:i))
         case (' ', tab, ',', ';')
         case default
            blank = .false.
         end select
      end do
      if (blank) length = 0
   end function content_length

   !> Fields of a row as texts, numbers with a decimal comma or with marks between thousands made plain. Else as split_row.
   pure subroutine split_fields(text, separator, fields)
      character(*), intent(in) :: text
      character, intent(in) :: separator
      type(text_type), allocatable, intent(out) :: fields(:)
      type(row_type) :: row
      integer :: i
      call split_row(text, separator, row)
      allocate (fields(row%count))
      do i = 1, row%count
         fields(i)%text = plain_number(row%text(row%first(i):row%last(i)), separator == ',')
      end do
   end subroutine split_fields

   !> Whether a text begins with a quotation mark that is closed in it. The mark of feet or inches, alone in its field, is none.
   pure function opens_quotes(text, separator) result(opens)
      character(*), intent(in) :: text       !< not empty
      character, intent(in) :: separator
      logical :: opens
      opens = (text(1:1) == '"' .or. text(1:1) == '''') .and. len(text) > 1
      if (opens) opens = text(2:2) /= separator .and. index(text(2:), text(1:1)) > 0
   end function opens_quotes

   !> Fields of a row, as they stand there; blanks and tabs together are one separator. A field in quotes may hold the separator.
   pure subroutine split_row(text, separator, row)
      character(*), intent(in) :: text
      character, intent(in) :: separator
      type(row_type), intent(inout) :: row      !< used again from row to row
      character :: letter
      integer :: quote          ! code of the one that is open; 0: none
      logical :: was_quoted, blank
      integer :: i, n, start
      if (.not. allocated(row%first)) allocate (row%first(first_capacity), row%last(first_capacity))
      if (.not. allocated(row%text)) allocate (character(len(text)) :: row%text)
      if (len(row%text) < len(text)) then
         deallocate (row%text)
         allocate (character(2*len(text)) :: row%text)
      end if
      row%count = 0
      quote = 0
      was_quoted = .false.
      blank = .true.
      n = 0
      start = 1
      do i = 1, len(text)
         letter = text(i:i)
         if (quote > 0 .and. iachar(letter) == quote) then
            quote = 0
         else if (quote == 0 .and. blank .and. opens_quotes(text(i:), separator)) then
            quote = iachar(letter)
            was_quoted = .true.
         else if (quote == 0 .and. (letter == separator .or. (iachar(separator) == blank_code .and. letter == tab))) then
            call close_field(separator, was_quoted, start, n, row)
            was_quoted = .false.
            blank = .true.
         else
            n = n + 1
            if (letter == tab) letter = achar(blank_code)
            row%text(n:n) = letter
            if (iachar(letter) /= blank_code) blank = .false.
         end if
      end do
      call close_field(separator, was_quoted, start, n, row)
   end subroutine split_row

   !> Notes a field that has ended, without blanks at its ends; between blanks only one that holds something, or quotes.
   pure subroutine close_field(separator, was_quoted, start, n, row)
      character, intent(in) :: separator
      logical, intent(in) :: was_quoted
      integer, intent(inout) :: start      !< its first letter in the row's text; on return that of the next
      integer, intent(in) :: n             !< its last letter
      type(row_type), intent(inout) :: row
      integer, allocatable :: longer(:)
      integer :: first, last
      first = start
      last = n
      start = n + 1
      do while (first <= last)
         if (iachar(row%text(first:first)) /= blank_code) exit
         first = first + 1
      end do
      do while (last >= first)
         if (iachar(row%text(last:last)) /= blank_code) exit
         last = last - 1
      end do
      if (last < first .and. iachar(separator) == blank_code .and. .not. was_quoted) return
      if (row%count == size(row%first)) then
         allocate (longer(2*row%count))
         longer(:row%count) = row%first
         call move_alloc(longer, row%first)
         allocate (longer(2*row%count))
         longer(:row%count) = row%last
         call move_alloc(longer, row%last)
      end if
      row%count = row%count + 1
      row%first(row%count) = first
      row%last(row%count) = last
   end subroutine close_field
end module dg_table_text
