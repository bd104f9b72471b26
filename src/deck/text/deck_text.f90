!> The groups of a deck as they stand in its text: keys with their values, still as text, with line numbers.
module dg_deck_text
   use dg_deck_token, only: token_type, token_group, token_end, token_word, token_text, token_open_text, &
      token_equals, token_comma, token_stray
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_text, only: lower_case, quoted, to_text
   implicit none
   private
   public :: entry_type, group_type, parse_groups

   !> `key = values`, or `key(first:last) = values`.
   type :: entry_type
      character(:), allocatable :: key       !< lower case
      integer :: line = 0
      integer :: first = 0                   !< subscript of the first value; 0: none given
      integer :: last = 0                    !< subscript of the last value; 0: none given
      logical :: sound = .true.              !< no fault found in its text
      type(token_type), allocatable :: values(:)     !< words and quoted texts, repeated ones as often
   end type entry_type

   type :: group_type
      character(:), allocatable :: name      !< lower case
      integer :: line = 0
      logical :: torn = .false.              !< a quote is not closed: keys behind it on that line, and the closing /, are lost
      type(entry_type), allocatable :: entries(:)
   end type group_type

   !> Groups as far as they are read; the last of them is open, or was last. So of entries and their values.
   type :: parser_type
      character(:), allocatable :: path
      type(group_type), allocatable :: groups(:)
      type(entry_type) :: entry
      type(token_type), allocatable :: values(:)             !< of the entry
      integer :: n_groups = 0, n_entries = 0, n_values = 0        !< of the lists, which have room for more
      logical :: in_group = .false., in_entry = .false.
      logical :: lost = .false.     !< after a fault: nothing more is said until the next key
   end type parser_type

   character(*), parameter :: digits = '0123456789'
   !> Subscripts of more digits are no station of a deck.
   integer, parameter :: longest_subscript = 6
   integer, parameter :: first_capacity = 64

contains

   !> Builds the groups from the tokens of the deck `path` and notes every fault of form: text outside
   !> groups, groups that are not closed, quotes that are not closed, keys or values that are missing.
   subroutine parse_groups(path, tokens, groups, faults)
      character(*), intent(in) :: path
      type(token_type), intent(in) :: tokens(:)
      type(group_type), allocatable, intent(out) :: groups(:)
      type(fault_list_type), intent(inout) :: faults
      type(parser_type) :: parser
      integer :: i, previous, this, next, stray_line
      parser%path = path
      allocate (parser%groups(count(tokens%kind == token_group)), parser%values(first_capacity))
      stray_line = 0
      this = 0
      do i = 1, size(tokens)
         previous = this
         this = tokens(i)%kind
         next = 0
         if (i < size(tokens)) next = tokens(i + 1)%kind
         associate (token => tokens(i))
            select case (token%kind)
            case (token_stray)
               if (token%line == stray_line) cycle
               stray_line = token%line
               call add_fault(faults, path, token%line, 'text outside any group: '//quoted(token%text)// &
                              '; start a comment with !, put a text that holds a / into quotes')
            case (token_group)
               call close_entry(parser, faults)
               call tell_open(parser, ' before &'//lower_case(token%text)//' in line '//to_text(token%line), faults)
               call open_group(parser, token)
            case (token_end)
               call close_entry(parser, faults)
               if (.not. parser%in_group) &
                  call add_fault(faults, path, token%line, quoted(token%text)//' closes no group; remove it')
               call close_group(parser)
            case (token_equals)
               if (parser%in_entry .and. previous == token_word) then
                  if (parser%n_values == 0) cycle   ! the key's own
               end if
               if (.not. parser%lost) &
                  call group_fault(parser, token%line, "'=' without a key before it; write key = value", faults)
               call close_entry(parser, faults)
               parser%lost = .true.
            case (token_comma)
               if (.not. parser%in_entry) cycle
               if (previous == token_comma .or. previous == token_equals) &
                  call entry_fault(parser, 'no value before a comma; give every value', faults)
            case (token_word, token_text, token_open_text)
               if (token%kind == token_word .and. next == token_equals) then
                  call close_entry(parser, faults)
                  call open_entry(parser, token, faults)
               else if (parser%in_entry) then
                  call take_value(parser, token, faults)
               else if (.not. parser%lost) then
                  call group_fault(parser, token%line, quoted(token%text)//' belongs to no key; write key = value', faults)
                  parser%lost = .true.
               end if
            case default
            end select
         end associate
      end do
      call close_entry(parser, faults)
      call tell_open(parser, '', faults)
      call close_group(parser)
      call move_alloc(parser%groups, groups)
   end subroutine parse_groups

   !> Tells of a group that is not closed, unless an open quote has taken its end.
   subroutine tell_open(parser, before, faults)
      type(parser_type), intent(in) :: parser
      character(*), intent(in) :: before      !< the next group, or ''
      type(fault_list_type), intent(inout) :: faults
      if (.not. parser%in_group) return
      associate (group => parser%groups(parser%n_groups))
         if (.not. group%torn) call group_fault(parser, group%line, 'not closed'//before//'; end it with /', faults)
      end associate
   end subroutine tell_open

   subroutine open_group(parser, token)
      type(parser_type), intent(inout) :: parser
      type(token_type), intent(in) :: token
      call close_group(parser)
      parser%in_group = .true.
      parser%lost = .false.
      parser%n_groups = parser%n_groups + 1
      parser%n_entries = 0
      associate (group => parser%groups(parser%n_groups))
         group%name = lower_case(token%text)
         group%line = token%line
         allocate (group%entries(first_capacity))
      end associate
   end subroutine open_group

   !> Closes the group that is open, if one is.
   subroutine close_group(parser)
      type(parser_type), intent(inout) :: parser
      if (.not. parser%in_group) return
      parser%in_group = .false.
      associate (group => parser%groups(parser%n_groups))
         group%entries = group%entries(:parser%n_entries)
      end associate
   end subroutine close_group

   !> A fault within the group that is open, or was last.
   subroutine group_fault(parser, line, message, faults)
      type(parser_type), intent(in) :: parser
      integer, intent(in) :: line
      character(*), intent(in) :: message
      type(fault_list_type), intent(inout) :: faults
      call add_fault(faults, parser%path, line, 'group &'//parser%groups(parser%n_groups)%name//': '//message)
   end subroutine group_fault

   !> One fault an entry is enough: what follows from it would only confuse.
   subroutine entry_fault(parser, message, faults)
      type(parser_type), intent(inout) :: parser
      character(*), intent(in) :: message
      type(fault_list_type), intent(inout) :: faults
      if (parser%entry%sound) call group_fault(parser, parser%entry%line, parser%entry%key//': '//message, faults)
      parser%entry%sound = .false.
   end subroutine entry_fault

   subroutine open_entry(parser, token, faults)
      type(parser_type), intent(inout) :: parser
      type(token_type), intent(in) :: token
      type(fault_list_type), intent(inout) :: faults
      logical :: legal
      parser%in_entry = .true.
      parser%lost = .false.
      parser%n_values = 0
      associate (entry => parser%entry)
         entry%line = token%line
         entry%sound = .true.
         call split_subscript(lower_case(token%text), entry%key, entry%first, entry%last, legal)
      end associate
      if (.not. legal) call entry_fault(parser, 'the subscript of '//quoted(token%text)// &
                                        ' is none; write key(1) = or key(2:5) =', faults)
   end subroutine open_entry

   subroutine take_value(parser, token, faults)
      type(parser_type), intent(inout) :: parser
      type(token_type), intent(in) :: token
      type(fault_list_type), intent(inout) :: faults
      if (token%kind == token_open_text) then
         call entry_fault(parser, 'the quote before '//quoted(token%text)//' is not closed on its line'//inches(), faults)
         parser%groups(parser%n_groups)%torn = .true.
      else if (token%kind == token_word .and. token%text == '') then
         call entry_fault(parser, 'a repeat count without a value; write 3*0.1', faults)
      else if (token%repeat < 1) then
         call entry_fault(parser, 'repeat counts are 1 to 999999', faults)
      end if
      if (parser%entry%sound) call append_values(parser%values, parser%n_values, token)
   contains
      !> Advice where a mark of inches stands behind a number.
      function inches() result(advice)
         character(:), allocatable :: advice
         advice = ''
         if (parser%n_values == 0) return
         if (parser%values(parser%n_values)%kind /= token_word) return
         if (verify(parser%values(parser%n_values)%text, '0123456789.-+/') == 0) &
            advice = '; a number has no mark of inches behind it'
      end function inches
   end subroutine take_value

   !> Puts the entry that is open, if one is, into its group.
   subroutine close_entry(parser, faults)
      type(parser_type), intent(inout) :: parser
      type(fault_list_type), intent(inout) :: faults
      integer :: wanted
      if (.not. parser%in_entry) return
      parser%in_entry = .false.
      parser%entry%values = parser%values(:parser%n_values)
      if (parser%n_values == 0) call entry_fault(parser, 'no value; write '//parser%entry%key//' = value', faults)
      if (parser%entry%sound .and. parser%entry%last > 0) then
         wanted = parser%entry%last - parser%entry%first + 1
         if (wanted /= parser%n_values) call entry_fault(parser, 'the subscript asks for '//to_text(wanted)//' values, '// &
                                                         to_text(parser%n_values)//' given', faults)
      end if
      call append_entry(parser%groups(parser%n_groups)%entries, parser%n_entries, parser%entry)
   end subroutine close_entry

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
      colon = index(inner, ':')
      if (colon == 0) then
         call read_subscript(inner, first, legal)
      else
         call read_subscript(inner(:colon - 1), first, legal)
         if (legal .and. colon < len(inner)) then
            call read_subscript(inner(colon + 1:), last, legal)
            if (legal) legal = last >= first
         end if
      end if
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

   !> Puts a value behind the first `n` of a list, as often as it says.
   pure subroutine append_values(list, n, value)
      type(token_type), allocatable, intent(inout) :: list(:)
      integer, intent(inout) :: n
      type(token_type), intent(in) :: value
      type(token_type), allocatable :: longer(:)
      integer :: i
      if (n + value%repeat > size(list)) then
         allocate (longer(2*(n + value%repeat)))
         longer(:n) = list(:n)
         call move_alloc(longer, list)
      end if
      do i = n + 1, n + value%repeat
         list(i) = value
      end do
      n = n + value%repeat
   end subroutine append_values

   !> Puts one entry behind the first `n` of a list.
   pure subroutine append_entry(list, n, entry)
      type(entry_type), allocatable, intent(inout) :: list(:)
      integer, intent(inout) :: n
      type(entry_type), intent(in) :: entry
      type(entry_type), allocatable :: longer(:)
      if (n == size(list)) then
         allocate (longer(2*n))
         longer(:n) = list
         call move_alloc(longer, list)
      end if
      n = n + 1
      list(n) = entry
   end subroutine append_entry
end module dg_deck_text
