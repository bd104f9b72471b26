!> A deck in another system of units: numbers change in place, in ranges and keys that are comments too.
!> All else of the text stays.
module dg_deck_convert
   use dg_kinds, only: wp
   use dg_deck_comment, only: convert_comments, shortest
   use dg_deck_number, only: read_real
   use dg_deck_schema, only: group_keys_type, group_place, kind_real, rule_place
   use dg_deck_text, only: is_key
   use dg_deck_token, only: token_group, token_text, token_type, token_word, tokenize
   use dg_load_case, only: operation_from_name, operation_name
   use dg_text, only: append_text, lower_case, text_type
   use dg_unit_kind, only: unit_factor
   use dg_units, only: unit_system_type
   use dg_version, only: program_name
   implicit none
   private
   public :: convert_deck

   !> Keys of operations, which get their long names.
   character(*), parameter :: operation_keys = ' operation operations measured_operations '

contains

   !> The lines of a deck without fault, in other units. Files that it names stay, and the converted deck states their units.
   subroutine convert_deck(path, read, units, other, groups, lines)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: read(:)            !< the lines of the deck
      type(unit_system_type), intent(in) :: units       !< of the deck
      type(unit_system_type), intent(in) :: other       !< that are wanted
      type(group_keys_type), intent(in) :: groups(:)    !< that a deck may have, with their keys
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(text_type), allocatable :: deck(:)
      type(token_type), allocatable :: tokens(:)
      logical :: has_job
      integer :: i
      allocate (deck, source=read)
      call tokenize(deck, tokens)
      has_job = any([(tokens(i)%kind == token_group .and. lower_case(tokens(i)%text) == 'job', i=1, size(tokens))])
      call convert_tokens(tokens, units, other, groups, deck)
      call convert_comments(units, other, groups, deck)
      if (allocated(lines)) deallocate (lines)
      allocate (lines(0))
      call append_text(lines, '! '//path//' with numbers in '//trim(other%name)//' units, by '//program_name// &
                       '. Sentences in comments are unchanged.')
      if (.not. has_job) call append_text(lines, "&job units = '"//trim(other%name)//"' /")
      do i = 1, size(deck)
         call append_text(lines, deck(i)%text)
      end do
   end subroutine convert_deck

   !> Changes the numbers in the lines, from the last to the first, so that places in a line stay true.
   pure subroutine convert_tokens(tokens, units, other, groups, lines)
      type(token_type), intent(in) :: tokens(:)
      type(unit_system_type), intent(in) :: units      !< of the deck
      type(unit_system_type), intent(in) :: other      !< that is wanted
      type(group_keys_type), intent(in) :: groups(:)
      type(text_type), intent(inout) :: lines(:)
      character(:), allocatable :: group, key, new
      type(text_type) :: group_of(size(tokens)), key_of(size(tokens))
      integer :: i
      group = ''
      key = ''
      do i = 1, size(tokens)
         if (tokens(i)%kind == token_group) then
            group = lower_case(tokens(i)%text)
            key = ''
         else if (is_key(tokens, i)) then
            key = lower_case(tokens(i)%text)
            if (index(key, '(') > 0) key = key(:index(key, '(') - 1)
         end if
         group_of(i)%text = group
         key_of(i)%text = key
      end do
      do i = size(tokens), 1, -1
         new = ''
         associate (token => tokens(i))
            select case (token%kind)
            case (token_group)
               new = '&'//token%text//added(i)
            case (token_text)
               if (index(operation_keys, ' '//key_of(i)%text//' ') > 0 .and. operation_from_name(token%text) > 0) &
                  new = count_of(lines(token%line)%text(token%first:token%last))// &
                        "'"//trim(operation_name(operation_from_name(token%text)))//"'"
               if (group_of(i)%text == 'job' .and. key_of(i)%text == 'units') new = "'"//trim(other%name)//"'"
            case (token_word)
               if (.not. is_key(tokens, i)) new = converted(token, lines(token%line)%text(token%first:token%last))
            case default
            end select
            if (new /= '') lines(token%line)%text = lines(token%line)%text(:token%first - 1)//new// &
                                                    lines(token%line)%text(token%last + 1:)
         end associate
      end do

   contains

      !> Repeat count before a value, '4*' in '4*20'; '' without one.
      pure function count_of(written) result(text)
         character(*), intent(in) :: written
         character(:), allocatable :: text
         text = written(:index(written, '*'))
      end function count_of

      !> A number in the other units, its count before it; '' where it stays as it is.
      pure function converted(token, written) result(new)
         type(token_type), intent(in) :: token
         character(*), intent(in) :: written
         character(:), allocatable :: new
         real(wp) :: number, from, to
         logical :: legal
         integer :: k, key
         new = ''
         k = group_place(groups, group_of(i)%text)
         if (k == 0) return
         key = rule_place(groups(k)%keys, key_of(i)%text)
         if (key == 0) return
         associate (rule => groups(k)%keys(key))
            if (rule%kind /= kind_real) return
            from = unit_factor(units, rule%unit)
            to = unit_factor(other, rule%unit)
         end associate
         call read_real(token%text, number, legal)
         if (abs(from - to) <= 0.0_wp .or. abs(number) <= 0.0_wp .or. .not. legal) return
         new = written(:index(written, '*'))//shortest(number*from/to)
      end function converted

      !> Key of units that a group needs and lacks: the new units of the deck, or those of the file that it names.
      pure function added(start) result(text)
         integer, intent(in) :: start
         character(:), allocatable :: text
         text = ''
         select case (lower_case(tokens(start)%text))
         case ('job')
            if (.not. has(start, 'units')) text = " units = '"//trim(other%name)//"'"
         case ('trajectory')
            if (has(start, 'survey_file') .and. .not. has(start, 'survey_units')) text = " survey_units = '"// &
               trim(units%name)//"'"
         case ('legacy')
            if (.not. has(start, 'units')) text = " units = '"//trim(units%name)//"'"
         case default
         end select
      end function added

      !> True if the group that begins at `start` has a key.
      pure function has(start, name) result(is)
         integer, intent(in) :: start
         character(*), intent(in) :: name
         logical :: is
         integer :: k
         is = .false.
         do k = start + 1, size(tokens)
            if (tokens(k)%kind == token_group) return
            if (is_key(tokens, k) .and. key_of(k)%text == name) is = .true.
         end do
      end function has
   end subroutine convert_tokens
end module dg_deck_convert
