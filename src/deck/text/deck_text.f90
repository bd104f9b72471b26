!> The groups of a deck as they stand in its text: keys with their values, still as text, with line numbers.
module dg_deck_text
   use dg_deck_token, only: token_type, token_group, token_end, token_word, token_open_text, token_equals, token_comma
   use dg_error, only: add_fault, error_list_type
   use dg_text, only: lower_case, quoted, to_text
   implicit none
   private
   public :: entry_type, group_type, is_key, parse_groups

   !> `key = values`, or `key(first:last) = values`.
   type :: entry_type
      character(:), allocatable :: key       !< lower case
      integer :: line = 0
      integer :: first = 0                   !< subscript of the first value; 0: none given
      integer :: last = 0                    !< subscript of the last value; 0: none given
      logical :: sound = .true.              !< no fault found in its text
      character(:), allocatable :: open      !< text behind a quote that its line does not close; not allocated: none
      type(token_type), allocatable :: values(:)     !< words and quoted texts, repeated ones as often
   end type entry_type

   type :: group_type
      character(:), allocatable :: name      !< lower case
      integer :: line = 0
      logical :: torn = .false.              !< a quote is not closed: keys behind it on that line, and the closing /, are lost
      type(entry_type), allocatable :: entries(:)
   end type group_type

   character(*), parameter :: digits = '0123456789'
   !> Subscripts of more digits are no station of a deck.
   integer, parameter :: longest_subscript = 6

contains

   !> Build the groups from the tokens of the deck `path` and note every fault of form. Faults are text outside groups, groups
   !> or quotes that are not closed, keys or values that are missing.
   subroutine parse_groups(path, tokens, groups, faults)
      character(*), intent(in) :: path
      type(token_type), intent(in) :: tokens(:)
      type(group_type), allocatable, intent(out) :: groups(:)
      type(error_list_type), intent(inout) :: faults
      integer :: at, n, stray_line
      allocate (groups(count(tokens%kind == token_group)))
      n = 0
      stray_line = 0
      at = 1
      do while (at <= size(tokens))
         associate (token => tokens(at))
            select case (token%kind)
            case (token_group)
               n = n + 1
               call parse_group(path, tokens, at, groups(n), faults)
               cycle
            case (token_end)
               call add_fault(faults, path, token%line, quoted(token%text)//' closes no group; remove it')
            case default
               if (token%line /= stray_line) call add_fault(faults, path, token%line, 'text outside any group: '// &
                  quoted(token%text)//'; a group begins with &, a comment with !; put a text that holds a / into quotes')
               stray_line = token%line
            end select
         end associate
         at = at + 1
      end do
   end subroutine parse_groups

   !> Reads the group that begins at a token; `at` is then the token behind it.
   subroutine parse_group(path, tokens, at, group, faults)
      character(*), intent(in) :: path
      type(token_type), intent(in) :: tokens(:)
      integer, intent(inout) :: at
      type(group_type), intent(inout) :: group
      type(error_list_type), intent(inout) :: faults
      integer :: last, k, n
      logical :: lost          ! after a fault: nothing more is said until the next key
      group%name = lower_case(tokens(at)%text)
      group%line = tokens(at)%line
      last = at
      do while (last < size(tokens))
         if (any(tokens(last + 1)%kind == [token_end, token_group])) exit
         last = last + 1
      end do
      allocate (group%entries(count([(is_key(tokens, k), k=at + 1, last)])))
      n = 0
      lost = .false.
      at = at + 1
      do while (at <= last)
         if (is_key(tokens, at)) then
            n = n + 1
            lost = .false.
            call parse_entry(path, group, tokens(:last), at, group%entries(n), faults)
            cycle
         end if
         if (tokens(at)%kind == token_equals .and. .not. lost) then
            call fault(tokens(at)%line, "'=' without a key before it; write key = value")
         else if (tokens(at)%kind /= token_comma .and. .not. lost) then
            call fault(tokens(at)%line, quoted(tokens(at)%text)//' belongs to no key; write key = value')
         end if
         lost = lost .or. tokens(at)%kind /= token_comma
         at = at + 1
      end do
      if (at > size(tokens)) then
         if (.not. group%torn) call fault(group%line, 'not closed; end it with /')
      else if (tokens(at)%kind == token_end) then
         at = at + 1
      else if (.not. group%torn) then
         call fault(group%line, 'not closed before &'//lower_case(tokens(at)%text)//' in line '//to_text(tokens(at)%line)// &
                    '; end it with /')
      end if

   contains

      subroutine fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, path, line, 'group &'//group%name//': '//message)
      end subroutine fault
   end subroutine parse_group

   !> Reads the entry whose key is a token; `at` is then the token behind it. Values are those before the first fault.
   subroutine parse_entry(path, group, tokens, at, entry, faults)
      character(*), intent(in) :: path
      type(group_type), intent(inout) :: group
      type(token_type), intent(in) :: tokens(:)    !< up to the last one of the group
      integer, intent(inout) :: at
      type(entry_type), intent(out) :: entry
      type(error_list_type), intent(inout) :: faults
      integer :: first, behind, i, k, n
      logical :: legal
      entry%line = tokens(at)%line
      call split_subscript(lower_case(tokens(at)%text), entry%key, entry%first, entry%last, legal)
      if (.not. legal) call fault('the subscript of '//quoted(tokens(at)%text)//' is not valid; write key(1) = or key(2:5) =')
      first = at + 2
      behind = first
      n = 0
      at = first
      do while (at <= size(tokens))
         if (is_key(tokens, at) .or. tokens(at)%kind == token_equals) exit
         call check(tokens(at), tokens(at - 1))
         if (entry%sound) behind = at + 1
         if (entry%sound .and. tokens(at)%kind /= token_comma) n = n + tokens(at)%repeat
         at = at + 1
      end do
      allocate (entry%values(n))
      n = 0
      do k = first, behind - 1
         if (tokens(k)%kind == token_comma) cycle
         do i = n + 1, n + tokens(k)%repeat
            entry%values(i) = tokens(k)
         end do
         n = n + tokens(k)%repeat
      end do
      if (n == 0) call fault('no value; write '//entry%key//' = value')
      if (entry%last > 0 .and. n /= entry%last - entry%first + 1) call fault('the subscript asks for '// &
         to_text(entry%last - entry%first + 1)//' values, '//to_text(n)//' given')

   contains

      !> A value or a comma, by the token before it.
      subroutine check(token, before)
         type(token_type), intent(in) :: token, before
         select case (token%kind)
         case (token_comma)
            if (any(before%kind == [token_comma, token_equals])) call fault('no value before a comma; give every value')
         case (token_open_text)
            group%torn = .true.
            entry%open = token%text
            if (before%kind == token_word .and. verify(before%text, '0123456789.-+/') == 0) then
               call fault('the quote before '//quoted(token%text)// &
                          ' is not closed on its line; a number has no mark of inches behind it')
            else
               call fault('the quote before '//quoted(token%text)//' is not closed on its line')
            end if
         case default
            if (token%kind == token_word .and. token%text == '') call fault('a repeat count without a value; write 3*0.1')
            if (token%repeat < 1) call fault('repeat counts are 1 to 999999')
         end select
      end subroutine check

      !> One fault an entry is enough: what follows from it would only confuse.
      subroutine fault(message)
         character(*), intent(in) :: message
         if (entry%sound) call add_fault(faults, path, entry%line, 'group &'//group%name//': '//entry%key//': '//message)
         entry%sound = .false.
      end subroutine fault
   end subroutine parse_entry

   !> True if a token is a key: a word before =.
   pure function is_key(tokens, i) result(is)
      type(token_type), intent(in) :: tokens(:)
      integer, intent(in) :: i
      logical :: is
      is = .false.
      if (tokens(i)%kind /= token_word .or. i == size(tokens)) return
      is = tokens(i + 1)%kind == token_equals
   end function is_key

   !> Splits `md(2:5)` into key and subscripts; (:) is none, (n) gives the place of the first value.
   pure subroutine split_subscript(text, key, first, last, legal)
      character(*), intent(in) :: text
      character(:), allocatable, intent(out) :: key
      integer, intent(out) :: first, last
      logical, intent(out) :: legal
      character(:), allocatable :: inner
      integer :: bracket, colon
      first = 0
      last = 0
      legal = .true.
      key = text
      bracket = index(text, '(')
      if (bracket == 0) return
      key = text(:bracket - 1)
      legal = index(text, ')') == len(text)
      if (.not. legal) return
      inner = text(bracket + 1:len(text) - 1)
      if (inner == ':') return
      colon = index(inner//':', ':')
      call read_subscript(inner(:colon - 1), first, legal)
      if (.not. legal .or. colon >= len(inner)) return
      call read_subscript(inner(colon + 1:), last, legal)
      legal = legal .and. last >= first
   end subroutine split_subscript

   !> A whole number of at least one.
   pure subroutine read_subscript(text, number, legal)
      character(*), intent(in) :: text
      integer, intent(out) :: number
      logical, intent(out) :: legal
      number = 0
      legal = len(text) > 0 .and. len(text) <= longest_subscript .and. verify(text, digits) == 0
      if (legal) read (text, *) number
      legal = legal .and. number > 0
   end subroutine read_subscript
end module dg_deck_text
