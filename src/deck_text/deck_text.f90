!> The groups of a deck as they stand in its text: keys with their values, still as text, with line numbers.
module dg_deck_text
   use dg_deck_token, only: token_type, token_group, token_end, token_word, token_text, token_open_text, &
      token_equals, token_comma, token_stray
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_text, only: lower_case, quoted, to_text
   implicit none
   private
   public :: value_text_type, entry_type, group_type, parse_groups

   !> One value as written.
   type :: value_text_type
      character(:), allocatable :: text
      logical :: in_quotes = .false.
      integer :: line = 0
   end type value_text_type

   !> `key = values`, or `key(first:last) = values`.
   type :: entry_type
      character(:), allocatable :: key       !< lower case
      integer :: line = 0
      integer :: first = 0                   !< subscript of the first value; 0: none given
      integer :: last = 0                    !< subscript of the last value; 0: none given
      logical :: sound = .true.              !< no fault found in its text
      type(value_text_type), allocatable :: values(:)
   end type entry_type

   type :: group_type
      character(:), allocatable :: name      !< lower case
      integer :: line = 0
      type(entry_type), allocatable :: entries(:)
   end type group_type

   character(*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyz_'
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
      type(group_type) :: group
      type(entry_type) :: entry
      type(value_text_type), allocatable :: values(:)   ! of the entry; the first n_values are meant
      integer :: n_values, n_entries, n_groups          ! of the lists, which have room for more
      logical :: in_group, in_entry, lost
      integer :: i, previous, this, next, stray_line

      allocate (groups(first_capacity), values(first_capacity))
      n_values = 0
      n_entries = 0
      n_groups = 0
      in_group = .false.
      in_entry = .false.
      lost = .false.         ! after a fault: nothing more is said until the next key
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
               call close_entry()
               if (in_group) then
                  call add_fault(faults, path, group%line, 'group &'//group%name//': not closed before &'// &
                                 lower_case(token%text)//' in line '//to_text(token%line)//'; end it with /')
                  call close_group()
               end if
               in_group = .true.
               lost = .false.
               group%name = lower_case(token%text)
               group%line = token%line
               if (allocated(group%entries)) deallocate (group%entries)
               allocate (group%entries(first_capacity))
               n_entries = 0
            case (token_end)
               call close_entry()
               if (in_group) then
                  call close_group()
               else
                  call add_fault(faults, path, token%line, quoted(token%text)//' closes no group; remove it')
               end if
               in_group = .false.
            case (token_equals)
               if (in_entry .and. previous == token_word) then
                  if (n_values == 0) cycle   ! the key's own
               end if
               if (.not. lost) call group_fault(token%line, "'=' without a key before it; write key = value")
               call close_entry()
               lost = .true.
            case (token_comma)
               if (.not. in_entry) cycle
               if (previous == token_comma .or. previous == token_equals) &
                  call entry_fault('no value before a comma; give every value')
            case (token_word, token_text, token_open_text)
               if (token%kind == token_word .and. next == token_equals) then
                  call close_entry()
                  call open_entry(token)
               else if (in_entry) then
                  call take_value(token)
               else if (.not. lost) then
                  call group_fault(token%line, quoted(token%text)//' belongs to no key; write key = value')
                  lost = .true.
               end if
            case default
            end select
         end associate
      end do
      call close_entry()
      if (in_group) then
         call add_fault(faults, path, group%line, 'group &'//group%name//': not closed; end it with /')
         call close_group()
      end if
      groups = groups(:n_groups)

   contains

      subroutine close_group()
         group%entries = group%entries(:n_entries)
         call append_group(groups, n_groups, group)
      end subroutine close_group

      subroutine group_fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, path, line, 'group &'//group%name//': '//message)
      end subroutine group_fault

      !> One fault an entry is enough: what follows from it would only confuse.
      subroutine entry_fault(message)
         character(*), intent(in) :: message
         if (entry%sound) call group_fault(entry%line, entry%key//': '//message)
         entry%sound = .false.
      end subroutine entry_fault

      subroutine open_entry(token)
         type(token_type), intent(in) :: token
         logical :: legal
         in_entry = .true.
         lost = .false.
         entry%line = token%line
         entry%sound = .true.
         n_values = 0
         call split_subscript(lower_case(token%text), entry%key, entry%first, entry%last, legal)
         if (.not. legal) then
            call entry_fault('the subscript of '//quoted(token%text)//' is none; write key(1) = or key(2:5) =')
         end if
      end subroutine open_entry

      subroutine take_value(token)
         type(token_type), intent(in) :: token
         type(value_text_type) :: value
         if (token%kind == token_open_text) then
            call entry_fault('the quote before '//quoted(token%text)//' is not closed on its line')
         else if (token%kind == token_word .and. token%text == '') then
            call entry_fault('a repeat count without a value; write 3*0.1')
         else if (token%repeat < 1) then
            call entry_fault('repeat counts are 1 to 999999')
         end if
         value%text = token%text
         value%in_quotes = token%kind /= token_word
         value%line = token%line
         if (entry%sound) call append_values(values, n_values, value, token%repeat)
      end subroutine take_value

      subroutine close_entry()
         if (in_entry) then
            entry%values = values(:n_values)
            if (n_values == 0) call entry_fault('no value; write '//entry%key//' = value')
            if (entry%sound .and. entry%last > 0) then
               if (entry%last - entry%first + 1 /= size(entry%values)) call entry_fault('the subscript asks for '// &
                  to_text(entry%last - entry%first + 1)//' values, '//to_text(size(entry%values))//' given')
            end if
            call append_entry(group%entries, n_entries, entry)
         end if
         in_entry = .false.
      end subroutine close_entry
   end subroutine parse_groups

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

   !> Puts `count` copies of a value behind the first `n` of a list.
   pure subroutine append_values(list, n, value, count)
      type(value_text_type), allocatable, intent(inout) :: list(:)
      integer, intent(inout) :: n
      type(value_text_type), intent(in) :: value
      integer, intent(in) :: count
      type(value_text_type), allocatable :: longer(:)
      integer :: i
      if (n + count > size(list)) then
         allocate (longer(2*(n + count)))
         longer(:n) = list(:n)
         call move_alloc(longer, list)
      end if
      do i = n + 1, n + count
         list(i) = value
      end do
      n = n + count
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

   !> Puts one group behind the first `n` of a list.
   pure subroutine append_group(list, n, group)
      type(group_type), allocatable, intent(inout) :: list(:)
      integer, intent(inout) :: n
      type(group_type), intent(in) :: group
      type(group_type), allocatable :: longer(:)
      if (n == size(list)) then
         allocate (longer(2*n))
         longer(:n) = list
         call move_alloc(longer, list)
      end if
      n = n + 1
      list(n) = group
   end subroutine append_group
end module dg_deck_text
