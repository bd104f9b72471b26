!> Cut the text of a deck into tokens: the words, quoted texts and marks of a Fortran namelist. A namelist read is not used,
!> because it skips misspelt groups in silence, takes the last of two equal keys, and has no line numbers.
module dg_deck_token
   use dg_text, only: lower_case, text_type
   implicit none
   private
   public :: token_type, tokenize
   public :: token_group, token_end, token_word, token_text, token_open_text, token_equals, token_comma, token_stray

   integer, parameter :: token_group = 1     !< &name
   integer, parameter :: token_end = 2       !< / or &end
   integer, parameter :: token_word = 3      !< a key, a number, a logical; anything without quotes
   integer, parameter :: token_text = 4      !< 'text' or "text"
   integer, parameter :: token_open_text = 5 !< a quote that its line does not close
   integer, parameter :: token_equals = 6
   integer, parameter :: token_comma = 7
   integer, parameter :: token_stray = 8     !< text outside any group

   type :: token_type
      integer :: kind = 0
      integer :: line = 0
      integer :: first = 0                   !< place in its line, from ...
      integer :: last = 0                    !< ... to, count and quotes included
      integer :: repeat = 1                  !< 3 in 3*0.1; negative where the count is too large to be read
      character(:), allocatable :: text
   end type token_type

   type :: token_list_type
      integer :: count = 0
      type(token_type), allocatable :: items(:)
   end type token_list_type

   character(*), parameter :: blanks = ' '//achar(9)//achar(13)//achar(12)
   character(*), parameter :: word_ends = blanks//',=/!&''"'
   character(*), parameter :: digits = '0123456789'
   character(*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_'
   !> Longest repeat count that is read: a million values are more than any deck holds.
   integer, parameter :: longest_count = 6
   integer, parameter :: first_capacity = 256

contains

   !> Tokens of a deck in order. `!` starts a comment outside quotes; a quote inside a quoted text is written
   !> twice; a quoted text ends on its line.
   pure subroutine tokenize(lines, tokens)
      type(text_type), intent(in) :: lines(:)
      type(token_type), allocatable, intent(out) :: tokens(:)
      type(token_list_type) :: list
      logical :: inside
      integer :: line
      allocate (list%items(first_capacity))
      inside = .false.
      do line = 1, size(lines)
         call tokenize_line(lines(line)%text, line, inside, list)
      end do
      tokens = list%items(:list%count)
   end subroutine tokenize

   !> Tokens of one line; `inside` tells whether a group is open.
   pure subroutine tokenize_line(text, line, inside, list)
      character(*), intent(in) :: text
      integer, intent(in) :: line
      logical, intent(inout) :: inside
      type(token_list_type), intent(inout) :: list
      integer :: at, length, repeats, first
      character(:), allocatable :: content
      logical :: closed

      at = 1
      repeats = 1
      do
         at = at + span(text(at:), blanks)
         if (at > len(text)) return
         first = at
         select case (text(at:at))
         case ('!')
            return
         case ('&')
            length = span(text(at + 1:), letters//digits)
            content = text(at + 1:at + length)
            at = at + length + 1
            if (lower_case(content) == 'end') then      ! as old namelists do
               call append(list, token_end, line, '&'//content)
               inside = .false.
            else
               call append(list, token_group, line, content, first=first, last=at - 1)
               inside = .true.
            end if
            cycle
         case default
         end select
         if (.not. inside) then
            length = scan(text(at:), '!&') - 1
            if (length < 0) length = len(text) - at + 1
            call append(list, token_stray, line, trim(text(at:at + length - 1)))
            at = at + length
            cycle
         end if
         select case (text(at:at))
         case ('/')
            call append(list, token_end, line, '/')
            inside = .false.
            at = at + 1
         case ('=')
            call append(list, token_equals, line, '=')
            at = at + 1
         case (',')
            call append(list, token_comma, line, ',')
            at = at + 1
         case ('''', '"')
            call read_quoted(text, at, content, closed)
            call append(list, merge(token_text, token_open_text, closed), line, content, repeats, first, at - 1)
            repeats = 1
         case default
            call read_word(text, at, content)
            call split_count(content, repeats)
            ! the count of a repeated quoted text waits for it
            if (content == '' .and. at <= len(text)) then
               if (text(at:at) == '''' .or. text(at:at) == '"') cycle
            end if
            call append(list, token_word, line, content, repeats, first, at - 1)
            repeats = 1
         end select
      end do
   end subroutine tokenize_line

   !> Reads a quoted text that starts at `at`; `at` then points behind it.
   pure subroutine read_quoted(text, at, content, closed)
      character(*), intent(in) :: text
      integer, intent(inout) :: at
      character(:), allocatable, intent(out) :: content
      logical, intent(out) :: closed
      character :: quote
      character(len(text)) :: held
      integer :: n
      quote = text(at:at)
      n = 0
      closed = .false.
      at = at + 1
      do while (at <= len(text))
         if (text(at:at) == quote) then
            if (at == len(text)) then
               closed = .true.
            else
               closed = text(at + 1:at + 1) /= quote
            end if
            at = at + 1
            if (closed) exit
         end if
         n = n + 1
         held(n:n) = text(at:at)
         at = at + 1
      end do
      content = held(:n)
      if (.not. closed) content = trim(content)
   end subroutine read_quoted

   !> Reads a word that starts at `at`, its subscript in brackets included; `at` then points behind it.
   pure subroutine read_word(text, at, content)
      character(*), intent(in) :: text
      integer, intent(inout) :: at
      character(:), allocatable, intent(out) :: content
      character(len(text)) :: held
      integer :: length, bracket, i, n
      length = scan(text(at:), word_ends) - 1
      if (length < 0) length = len(text) - at + 1
      ! 8-1/2 is one word, which no number is: behind a / between two digits a group does not end
      if (at + length < len(text) .and. length > 0) then
         if (text(at + length:at + length) == '/' .and. scan(text(at + length - 1:at + length - 1), digits) == 1 .and. &
             scan(text(at + length + 1:at + length + 1), digits) == 1) &
            length = length + 1 + span(text(at + length + 1:), digits)
      end if
      ! a subscript may hold blanks
      if (scan(text(at:at), letters) == 1) then
         bracket = scan(text(at:at + length - 1), '(')
         if (bracket == 0) then
            i = span(text(at + length:), blanks)
            if (at + length + i <= len(text)) then
               if (text(at + length + i:at + length + i) == '(') bracket = length + i + 1
            end if
         end if
         if (bracket > 0) then
            i = index(text(at:), ')')
            if (i > bracket) length = i
         end if
      end if
      n = 0
      do i = at, at + length - 1
         if (scan(text(i:i), blanks) > 0) cycle
         n = n + 1
         held(n:n) = text(i:i)
      end do
      content = held(:n)
      at = at + length
   end subroutine read_word

   !> Cuts the count off a word of the form 3*0.1.
   pure subroutine split_count(word, count)
      character(:), allocatable, intent(inout) :: word
      integer, intent(out) :: count
      integer :: star
      count = 1
      star = index(word, '*')
      if (star < 2) return
      if (verify(word(:star - 1), digits) /= 0) return
      if (star - 1 > longest_count) then
         count = -1
      else
         read (word(:star - 1), *) count
      end if
      word = word(star + 1:)
   end subroutine split_count

   !> Length of the leading part of `text` that consists of letters of `set`.
   pure function span(text, set) result(length)
      character(*), intent(in) :: text
      character(*), intent(in) :: set
      integer :: length
      length = verify(text, set) - 1
      if (length < 0) length = len(text)
   end function span

   !> Append one token at the end of the list.
   pure subroutine append(list, kind, line, text, repeats, first, last)
      type(token_list_type), intent(inout) :: list
      integer, intent(in) :: kind
      integer, intent(in) :: line
      character(*), intent(in) :: text
      integer, intent(in), optional :: repeats, first, last
      type(token_type), allocatable :: longer(:)
      if (list%count == size(list%items)) then
         allocate (longer(2*list%count))
         longer(:list%count) = list%items
         call move_alloc(longer, list%items)
      end if
      list%count = list%count + 1
      list%items(list%count)%kind = kind
      list%items(list%count)%line = line
      list%items(list%count)%text = text
      if (present(repeats)) list%items(list%count)%repeat = repeats
      if (present(first)) list%items(list%count)%first = first
      if (present(last)) list%items(list%count)%last = last
   end subroutine append
end module dg_deck_token
