!> Conversion of the texts of a group's entries into numbers, logicals and names by the table of keys, with every fault against
!> it. Numbers are in SI units.
module dg_deck_values
   use dg_kinds, only: wp
   use dg_checked_group, only: value_type, checked_group_type
   use dg_deck_advice, only: key_advice, meant_key, operation_advice, unit_advice, value_advice
   use dg_deck_number, only: read_real, read_integer, read_logical
   use dg_deck_schema, only: key_rule_type, kind_text, kind_real, kind_integer, kind_logical, range_text, hold_in_range, &
      rule_place, split_words, listed, name_length
   use dg_deck_keys, only: operation_words
   use dg_deck_text, only: group_type, entry_type
   use dg_deck_token, only: token_type, token_word
   use dg_error, only: add_fault, error_list_type
   use dg_load_case, only: operation_from_name, operation_name
   use dg_text, only: append_text, lower_case, quoted, suggestion, to_text, joined
   use dg_text_fault, only: find_text_fault
   use dg_unit_kind, only: unit_factor, unit_label, unit_none
   use dg_units, only: unit_system_type, si_units
   implicit none
   private
   public :: check_group

   !> Advice on the fatigue curve of a grade that has none.
   character(*), parameter :: other_grade = "API RP 7G has curves of E75 and S135 alone. For another grade write 'own', with "// &
      'fatigue_limit and tensile_strength'
   !> Values that a message repeats where there are too many.
   integer, parameter :: values_shown = 3
   !> Texts that a list may have; numbers may be as many as repeat counts allow.
   integer, parameter :: most_texts = 1000
   !> Keys of texts that become no cell of a table: file names, and headings of other programs' tables.
   character(*), parameter :: not_in_cells(13) = [character(14) :: 'output_dir', 'catalogue_file', 'survey_file', 'file', 'md', &
      'axial', 'torque', 'side_force', 'md_column', 'inc_column', 'azi_column', 'survey_well', 'parent_file']

contains

   !> Checks one group of the deck `path` against the table.
   subroutine check_group(path, group, rules, units, checked, faults)
      character(*), intent(in) :: path
      type(group_type), intent(in) :: group
      type(key_rule_type), intent(in) :: rules(:)
      type(unit_system_type), intent(in) :: units
      type(checked_group_type), intent(out) :: checked
      type(error_list_type), intent(inout) :: faults
      integer :: i, k, n
      integer, allocatable :: count_of(:)
      character(name_length), allocatable :: keys(:)   ! a copy: plain arrays pass without a temporary
      character(:), allocatable :: place

      place = 'group &'//group%name//': '
      checked%path = path
      checked%name = group%name
      checked%line = group%line
      n = size(rules)
      allocate (checked%values(n), count_of(n), keys(n))
      keys = rules%key
      checked%values(:)%key = keys
      checked%values(:)%line = group%line
      checked%values(:)%required = rules%required
      count_of = 0
      do i = 1, size(group%entries)
         k = rule_place(rules, group%entries(i)%key)
         if (k == 0) then
            call add_fault(faults, path, group%entries(i)%line, place//'unknown key '//quoted(group%entries(i)%key)// &
                           '; '//key_advice(group%name, group%entries(i)%key, keys, rules%meaning))
         else
            count_of(k) = count_of(k) + 1
            call read_entry(path, place, group%entries(i), rules(k), units, count_of(k), checked%values(k), faults)
         end if
      end do
      do k = 1, n
         if (checked%values(k)%given) cycle
         if (rules(k)%required) then
            if (group%name == 'component' .and. any([(group%entries(i)%key == 'catalogue', i=1, size(group%entries))])) cycle
            if (.not. (group%torn .or. misspelt(group, keys, trim(keys(k))))) &
               call add_fault(faults, path, group%line, place//'key '//trim(rules(k)%key)//' is missing; '// &
                              needed_text(rules(k), units))
         else if (rules(k)%default /= '') then
            call set_default(rules(k), checked%values(k))
         end if
      end do
   end subroutine check_group

   !> True if an unknown key of the group was taken for a misspelling of `key`. Then that key is not reported as missing.
   pure function misspelt(group, keys, key) result(is)
      type(group_type), intent(in) :: group
      character(*), intent(in) :: keys(:)
      character(*), intent(in) :: key
      logical :: is
      integer :: i
      is = .false.
      do i = 1, size(group%entries)
         if (any(keys == group%entries(i)%key)) cycle
         if (meant_key(group%name, group%entries(i)%key, keys) == key) is = .true.
      end do
   end function misspelt

   !> Reads the values of one entry; `times` counts the entries of this key so far.
   subroutine read_entry(path, place, entry, rule, units, times, value, faults)
      character(*), intent(in) :: path
      character(*), intent(in) :: place
      type(entry_type), intent(in) :: entry
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: times
      type(value_type), intent(inout) :: value
      type(error_list_type), intent(inout) :: faults
      integer :: i, held
      character(:), allocatable :: message, name, shown, whole

      if (times > 1 .and. (entry%first == 0 .or. .not. rule%array)) then
         call fault(entry%key//' is given a second time, first in line '//to_text(value%line)//'; keep one')
         return
      end if
      if (times == 1) then
         value%given = .true.
         value%line = entry%line
         value%sound = .true.
         allocate (value%content)
         if (rule%kind == kind_text) allocate (value%content%texts(0))
         if (rule%kind == kind_real .or. rule%kind == kind_integer) allocate (value%content%numbers(0))
      end if
      if (.not. entry%sound) then
         value%sound = .false.
         return
      end if
      if (.not. rule%array) then
         if (entry%first > 0) then
            call fault(entry%key//' takes one value and no subscript')
            return
         end if
         if (size(entry%values) > 1) then
            shown = ''
            whole = ''
            do i = 1, min(values_shown, size(entry%values))
               if (i > 1) shown = shown//', '
               shown = shown//entry%values(i)%text
               whole = trim(whole)//' '//entry%values(i)%text
            end do
            if (size(entry%values) > values_shown) shown = shown//', ...'
            call fault(entry%key//' takes one value, '//to_text(size(entry%values))//' given ('//shown//')'// &
                       value_advice(adjustl(whole), rule, units))
            return
         end if
      else if (value%sound) then
         held = 0
         if (allocated(value%content%numbers)) held = size(value%content%numbers)
         if (allocated(value%content%texts)) held = size(value%content%texts)
         if (max(entry%first, 1) /= held + 1) then
            call fault(entry%key//'('//to_text(entry%first)//') comes after '//to_text(held)// &
                       ' values; give the values in order, without gaps')
            return
         end if
      end if
      if (rule%kind == kind_text .and. size(entry%values) > most_texts) then
         call fault(entry%key//' takes at most '//to_text(most_texts)//' texts, '//to_text(size(entry%values))//' given')
         return
      end if
      if (.not. value%sound) return
      if (allocated(value%content%numbers)) value%content%numbers = [value%content%numbers, spread(0.0_wp, 1, size(entry%values))]
      do i = 1, size(entry%values)
         name = entry%key
         if (rule%array .and. rule%kind /= kind_text) name = name//'('//to_text(i + max(entry%first, 1) - 1)//')'
         call read_value(entry%values(i), name, max(entry%first, 1) + i - 1, rule, units, value, message)
         if (message == '') cycle
         if (entry%values(i)%line /= entry%line) message = message//' [line '//to_text(entry%values(i)%line)//']'
         call fault(message)
      end do

   contains

      subroutine fault(text)
         character(*), intent(in) :: text
         value%sound = .false.
         call add_fault(faults, path, entry%line, place//text)
      end subroutine fault
   end subroutine read_entry

   !> Reads one value and puts it to the others of its key; `message` is '' or says what is wrong.
   subroutine read_value(item, name, place, rule, units, value, message)
      type(token_type), intent(in) :: item
      character(*), intent(in) :: name
      integer, intent(in) :: place             !< of the value among those of its key
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      type(value_type), intent(inout) :: value
      character(:), allocatable, intent(out) :: message
      real(wp) :: number
      integer :: whole
      logical :: legal

      message = ''
      select case (rule%kind)
      case (kind_text)
         call read_text(item, name, rule, value, message)
      case (kind_logical)
         legal = item%kind == token_word
         if (legal) call read_logical(item%text, value%flag, legal)
         if (.not. legal) message = name//' = '//shown(item)//' is not a logical value; write .true. or .false.'
      case default
         legal = item%kind == token_word
         number = 0.0_wp
         if (legal) then
            if (rule%kind == kind_integer) then
               call read_integer(item%text, whole, legal)
               if (legal) number = real(whole, wp)
            else
               call read_real(item%text, number, legal)
            end if
         end if
         if (.not. legal) then
            message = name//' = '//shown(item)//' is not a '//needed_number(rule)//'; '//needed_text(rule, units)// &
                      value_advice(item%text, rule, units)
            return
         end if
         number = number*unit_factor(units, rule%unit)
         call hold_in_range(rule, number, legal)
         if (.not. legal) then
            message = name//' = '//item%text//' is out of range; '//needed_text(rule, units)// &
                      unit_advice(item%text, rule, units)
            return
         end if
         value%content%numbers(place) = number
      end select
   end subroutine read_value

   !> Reads one text, as a name from a list where the key has one. Quotes alone are advised only where the text with them is legal.
   subroutine read_text(item, name, rule, value, message)
      type(token_type), intent(in) :: item
      character(*), intent(in) :: name
      type(key_rule_type), intent(in) :: rule
      type(value_type), intent(inout) :: value
      character(:), allocatable, intent(out) :: message
      character(name_length), allocatable :: choices(:)
      character(:), allocatable :: chosen, advice
      integer :: i, operation
      message = ''
      advice = ''
      chosen = item%text
      if (item%kind == token_word .and. without_curly(item%text) /= item%text) then
         message = name//' = '//item%text//' has curly quotes, as word processors write; write '//name//" = '"// &
                   without_curly(item%text)//"'"
         return
      end if
      if (rule%choices == '*') then
         operation = operation_from_name(item%text)
         if (operation > 0) chosen = trim(operation_name(operation))
         if (operation == 0) advice = operation_advice(item%text)
      else if (rule%choices /= '') then
         call split_words(rule%choices, choices)
         do i = 1, size(choices)
            if (lower_case(item%text) == lower_case(trim(choices(i)))) exit
         end do
         if (i <= size(choices)) chosen = trim(choices(i))
         if (i > size(choices)) then      ! all that are legal, too: a name with digits is near to many
            advice = suggestion(item%text, choices)
            if (index(advice, 'legal: ') /= 1) advice = advice//' legal: '//joined(choices, ', ')
            if (rule%key == 'fatigue_curve' .and. scan(item%text, '0123456789') > 0) advice = other_grade
         end if
      else if (rule%required .and. item%text == '') then
         message = name//' is empty; give a text'
      else
         call find_text_fault(item%text, .not. any(not_in_cells == rule%key), message)
         if (message /= '') message = name//' = '//quoted(item%text)//' '//message
      end if
      if (advice /= '') message = name//' = '//quoted(item%text)//' is unknown; '//advice
      if (message == '' .and. item%kind == token_word) &
         message = name//' = '//item%text//' is a text without quotes; write '//name//" = '"//item%text//"'"
      if (message == '') call append_text(value%content%texts, chosen)
   end subroutine read_text

   !> Sets the default of a key, which the table states in units of SI.
   subroutine set_default(rule, value)
      type(key_rule_type), intent(in) :: rule
      type(value_type), intent(inout) :: value
      real(wp) :: number
      logical :: legal
      legal = .true.
      select case (rule%kind)
      case (kind_text)
         ! By component: gfortran 12 gives a deferred-length text in a structure constructor a wrong length.
         allocate (value%content)
         allocate (value%content%texts(1))
         value%content%texts(1)%text = trim(rule%default)
      case (kind_logical)
         call read_logical(trim(rule%default), value%flag, legal)
      case default
         call read_real(trim(rule%default), number, legal)
         value%number = number*unit_factor(si_units(), rule%unit)
      end select
      value%sound = legal
   end subroutine set_default

   !> A value as the user wrote it.
   pure function shown(item) result(text)
      type(token_type), intent(in) :: item
      character(:), allocatable :: text
      text = quoted(item%text)
      if (item%kind == token_word) text = text(2:len(text) - 1)
   end function shown

   !> 'whole number' or 'number'.
   pure function needed_number(rule) result(text)
      type(key_rule_type), intent(in) :: rule
      character(:), allocatable :: text
      text = 'number'
      if (rule%kind == kind_integer) text = 'whole number'
   end function needed_number

   !> Requirement of a key, with its range: 'needs a number, > 0 mm'.
   pure function needed_text(rule, units) result(text)
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text, range
      select case (rule%kind)
      case (kind_text)
         text = 'needs a text in quotes'
         if (rule%choices == '*') then
            text = text//': '//listed(operation_words())
         else if (rule%choices /= '') then
            text = text//': '//listed(rule%choices)
         end if
      case (kind_logical)
         text = 'needs .true. or .false.'
      case default
         text = 'needs a '//needed_number(rule)
         range = range_text(rule, units)
         if (range /= '') then
            text = text//', '//range
         else if (rule%unit /= unit_none) then
            text = text//' ['//unit_label(units, rule%unit)//']'
         end if
      end select
   end function needed_text

   !> A text without curly quotes at its ends, which word processors write and a deck does not know.
   pure function without_curly(text) result(bare)
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      character(2), parameter :: begins = char(226)//char(128)
      character(4), parameter :: ends = char(152)//char(153)//char(156)//char(157)
      logical :: before, behind
      bare = trim(text)
      if (len(bare) < 6) return
      before = bare(:2) == begins .and. scan(bare(3:3), ends) > 0
      behind = bare(len(bare) - 2:len(bare) - 1) == begins .and. scan(bare(len(bare):), ends) > 0
      if (behind) bare = bare(:len(bare) - 3)
      if (before) bare = bare(4:)
   end function without_curly
end module dg_deck_values
