!> Rows and headings of tables in their usual forms: separators, quotes, comments, units behind names.
module dg_table_text
   use dg_table_number, only: plain_number
   use dg_text, only: append_text, lower_case, text_type, to_text
   implicit none
   private
   public :: skipped_rows_type, skipped_words
   public :: close_brackets, content_length, find_separator, split_fields, split_row, split_unit, without_comment

   character(*), parameter :: tab = achar(9)
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

   !> Separator of the fields of a header: ; , | tab or blanks. Brackets do not count.
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

   !> A line without its comment; '' where nothing but blanks, tabs and separators stands before it.
   pure function without_comment(line) result(text)
      character(*), intent(in) :: line
      character(:), allocatable :: text
      text = line(:content_length(line))
   end function without_comment

   !> Length of a line without its comment. It is 0 if only blanks, tabs and separators are before the comment, as in empty
   !> rows of spreadsheets.
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
      integer :: i
      call split_row(text, separator, fields)
      do i = 1, size(fields)
         fields(i)%text = plain_number(fields(i)%text, separator == ',')
      end do
   end subroutine split_fields

   !> True if a text begins with a quotation mark that is closed in it. A mark of feet or inches alone in its field does not count.
   pure function opens_quotes(text, separator) result(opens)
      character(*), intent(in) :: text       !< not empty
      character, intent(in) :: separator
      logical :: opens
      opens = (text(1:1) == '"' .or. text(1:1) == '''') .and. len(text) > 1
      if (opens) opens = text(2:2) /= separator .and. index(text(2:), text(1:1)) > 0
   end function opens_quotes

   !> Fields of a row without quotes and without blanks at their ends. Blanks and tabs together are one separator. A field in quotes
   !> may hold the separator.
   pure subroutine split_row(text, separator, row)
      character(*), intent(in) :: text
      character, intent(in) :: separator
      type(text_type), allocatable, intent(inout) :: row(:)   !< its fields (gfortran 12 warns of intent(out))
      type(text_type), allocatable :: fields(:)
      character(len(text)) :: field
      character :: letter, quote          ! the quote that is open; blank: none
      logical :: was_quoted
      integer :: i, n
      allocate (fields(0))
      quote = ' '
      was_quoted = .false.
      n = 0
      do i = 1, len(text) + 1
         letter = separator
         if (i <= len(text)) letter = text(i:i)
         if (letter == tab .and. separator /= tab) letter = ' '
         if (quote /= ' ' .and. letter == quote) then
            quote = ' '
         else if (quote == ' ' .and. letter == separator) then
            ! between blanks a field holds something, or quotes
            if (separator /= ' ' .or. was_quoted .or. field(:n) /= '') call append_text(fields, trim(adjustl(field(:n))))
            was_quoted = .false.
            n = 0
         else if (quote == ' ' .and. field(:n) == '' .and. opens_quotes(text(i:), separator)) then
            quote = letter
            was_quoted = .true.
         else
            n = n + 1
            field(n:n) = letter
         end if
      end do
      call move_alloc(fields, row)
   end subroutine split_row
end module dg_table_text
