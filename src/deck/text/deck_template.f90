!> A commented deck to start from: a small well that runs as printed, with every other key of every group as a comment. It is
!> made from the tables of keys, so that it names all of them.
module dg_deck_template
   use dg_deck_keys, only: operation_words
   use dg_deck_number, only: read_real
   use dg_deck_schema, only: group_keys_type, key_rule_type, kind_real, kind_text, listed, name_length, range_text, split_words
   use dg_key_visitor, only: key_visitor_type
   use dg_kinds, only: wp
   use dg_numerics, only: numerics_type, visit_numerics
   use dg_quantity, only: deck_systems
   use dg_text, only: append_text, text_type, to_text
   use dg_unit_kind, only: unit_diameter, unit_factor, unit_force, unit_label, unit_length, unit_mass, unit_none
   use dg_units, only: field_units, si_units, unit_system, unit_system_type
   use dg_version, only: program_name, program_version
   implicit none
   private
   public :: deck_template

   !> One key that the template gives.
   type :: example_type
      character(12) :: group = ''
      integer :: copy = 1              !< of a group that stands several times
      character(20) :: key = ''
      character(60) :: value = ''      !< in units of SI
      character(60) :: field = ''      !< in field units; '': the same
   end type example_type

   type(example_type), parameter :: examples(*) = [ &
      example_type('job', 1, 'title', '''My well'''), &
      example_type('job', 1, 'units', '''SI'''), &
      example_type('job', 1, 'models', '''mcge'', ''soft'''), &
      example_type('trajectory', 1, 'md', '0, 600, 1500, 2400', '0, 2000, 5000, 8000'), &
      example_type('trajectory', 1, 'inc', '0, 0, 60, 60'), &
      example_type('trajectory', 1, 'azi', '45, 45, 45, 45'), &
      example_type('hole', 1, 'name', '''casing'''), &
      example_type('hole', 1, 'md_top', '0'), &
      example_type('hole', 1, 'md_bottom', '1500', '5000'), &
      example_type('hole', 1, 'diameter', '224.4', '8.835'), &
      example_type('hole', 1, 'friction', '0.20'), &
      example_type('hole', 2, 'name', '''open hole'''), &
      example_type('hole', 2, 'md_bottom', '2400', '8000'), &
      example_type('hole', 2, 'diameter', '215.9', '8.5'), &
      example_type('hole', 2, 'friction', '0.30'), &
      example_type('fluid', 1, 'density', '1200', '10'), &
      example_type('component', 1, 'name', '''collars'''), &
      example_type('component', 1, 'kind', '''collar'''), &
      example_type('component', 1, 'length', '120', '400'), &
      example_type('component', 1, 'od', '165.1', '6.5'), &
      example_type('component', 1, 'id', '71.4', '2.8125'), &
      example_type('component', 2, 'name', '''drill pipe'''), &
      example_type('component', 2, 'od', '127.0', '5'), &
      example_type('component', 2, 'id', '108.6', '4.276'), &
      example_type('component', 2, 'mass', '31.9', '20.87'), &
      example_type('component', 2, 'joint_od', '161.9', '6.625'), &
      example_type('component', 2, 'yield', '931', '135'), &
      example_type('load_case', 1, 'name', '''up'''), &
      example_type('load_case', 1, 'operation', '''trip_out'''), &
      example_type('load_case', 1, 'bit_depth', '2400', '8000'), &
      example_type('load_case', 2, 'name', '''drill'''), &
      example_type('load_case', 2, 'operation', '''rotary_drilling'''), &
      example_type('load_case', 2, 'bit_depth', '2400', '8000'), &
      example_type('load_case', 2, 'wob', '50', '12'), &
      example_type('load_case', 2, 'tob', '3', '2')]

   !> Finds the default of a number of the solver, which stands in its type.
   type, extends(key_visitor_type) :: default_finder_type
      character(name_length) :: key = ''
      real(wp) :: value = 0.0_wp       !< [SI]
      logical :: found = .false.
   contains
      procedure :: number => look_at_number
   end type default_finder_type

   !> Column at which what is said of a key begins.
   integer, parameter :: remark_column = 42
   !> Significant digits of a default that is not stated in the units of the deck.
   integer, parameter :: default_digits = 7
   !> Significant digits of an example that is converted.
   integer, parameter :: example_digits = 5
   !> Letters of a remark in one line.
   integer, parameter :: remark_width = 76

contains

   !> The lines of the template.
   subroutine deck_template(groups, units, lines)
      type(group_keys_type), intent(in) :: groups(:)     !< that a deck may have, with their keys
      type(unit_system_type), intent(in) :: units        !< of the deck
      type(text_type), allocatable, intent(out) :: lines(:)
      character(name_length), allocatable :: systems(:)
      type(unit_system_type) :: other
      integer :: i, copy, copies
      allocate (lines(0))
      call split_words(deck_systems, systems)
      call append_text(lines, '! A deck of '//program_name//' '//program_version//' to start from: it runs as it stands.')
      call append_text(lines, '! Keys behind ! are optional and show their default. Legal values and units stand in brackets.')
      call append_text(lines, '! Groups may come in any order.')
      do i = 1, size(systems)
         if (systems(i) == units%name) cycle
         other = unit_system(systems(i))
         call append_text(lines, '! `'//program_name//' --template '//trim(systems(i))//'` prints one in '// &
                          unit_label(other, unit_length)//', '//unit_label(other, unit_diameter)//', '// &
                          unit_label(other, unit_mass)//' and '//unit_label(other, unit_force)//'.')
      end do
      do i = 1, size(groups)
         copies = 0
         if (any(examples%group == groups(i)%rule%name)) &
            copies = maxval(examples%copy, mask=examples%group == groups(i)%rule%name)
         call append_text(lines, '')
         call append_text(lines, head(i))
         do copy = 1, copies
            call append_group(lines, groups(i), units, copy, with_rest=copy == copies, commented=.false.)
         end do
         if (copies == 0) call append_group(lines, groups(i), units, 1, with_rest=.true., commented=.true.)
      end do

   contains
      pure function head(number) result(text)
         integer, intent(in) :: number
         character(:), allocatable :: text
         text = '! &'//trim(groups(number)%rule%name)//': '//trim(groups(number)%rule%meaning)
         if (groups(number)%rule%repeatable) text = text//'; may be repeated'
         if (.not. groups(number)%rule%required) text = text//'; may be left out'
      end function head
   end subroutine deck_template

   !> One group: the keys that it gives, then, `with_rest`, the others as comments.
   subroutine append_group(lines, group, units, copy, with_rest, commented)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(group_keys_type), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: copy
      logical, intent(in) :: with_rest
      logical, intent(in) :: commented         !< the whole group
      character(:), allocatable :: mark
      integer :: i, k
      mark = ''
      if (commented) mark = '! '
      call append_text(lines, mark//'&'//trim(group%rule%name))
      do k = 1, size(group%keys)
         do i = 1, size(examples)
            if (examples(i)%group == group%rule%name .and. examples(i)%copy == copy .and. examples(i)%key == group%keys(k)%key) exit
         end do
         if (i <= size(examples)) then
            call append_key(lines, mark//'  '//trim(group%keys(k)%key)//' = '//value_of(examples(i), group%keys(k), units), &
                            group%keys(k), units)
         else if (with_rest) then
            call append_key(lines, '! '//trim(group%keys(k)%key)//' = '//default_text(group%keys(k), units), group%keys(k), units)
         end if
      end do
      call append_text(lines, mark//'/')
   end subroutine append_group

   !> A line of a key with its meaning, unit and legal values behind it, and below it where they are long.
   pure subroutine append_key(lines, start, rule, units)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: start
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: line, rest
      integer :: cut, bracket
      line = start//repeat(' ', max(1, remark_column - len(start)))//'! '
      rest = remark_of(rule, units)
      do while (len(rest) > remark_width)
         cut = index(rest(:remark_width + 1), ' ', back=.true.)
         bracket = index(rest(:cut), '[', back=.true.)      ! a range stays in one line
         if (bracket > 1 .and. index(rest(bracket + 1:cut), ']') == 0) cut = bracket - 1
         if (cut == 0) exit
         call append_text(lines, line//rest(:cut - 1))
         rest = rest(cut + 1:)
         line = '!'//repeat(' ', remark_column - 1)//'  '
      end do
      call append_text(lines, line//rest)
   end subroutine append_key

   !> Meaning, unit and legal values of a key.
   pure function remark_of(rule, units) result(line)
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: line
      line = trim(rule%meaning)
      if (rule%choices == '*') then
         line = line//' ['//listed(operation_words())//']'
      else if (rule%choices /= '') then
         line = line//' ['//listed(rule%choices)//']'
      else if (range_text(rule, units) /= '') then
         line = line//' ['//range_text(rule, units)//']'
      else if (rule%unit /= unit_none) then
         line = line//' ['//unit_label(units, rule%unit)//']'
      end if
      if (rule%required) line = line//'; required'
   end function remark_of

   !> The value of an example in the units of the deck: that of SI or field units where the key has their unit.
   pure function value_of(example, rule, units) result(text)
      type(example_type), intent(in) :: example
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      real(wp) :: number, factor
      logical :: legal
      text = trim(example%value)
      if (example%group == 'job' .and. example%key == 'units') text = ''''//trim(units%name)//''''
      factor = unit_factor(units, rule%unit)
      if (is_same(factor, unit_factor(si_units(), rule%unit))) return
      if (is_same(factor, unit_factor(field_units(), rule%unit))) then
         if (example%field /= '') text = trim(example%field)
      else
         call read_real(text, number, legal)
         if (legal) text = to_text(number*unit_factor(si_units(), rule%unit)/factor, example_digits)
      end if
   contains
      pure logical function is_same(one, other)
         real(wp), intent(in) :: one, other
         is_same = abs(one - other) <= epsilon(one)*abs(other)
      end function is_same
   end function value_of

   !> A default as a deck would write it; empty without a default.
   function default_text(rule, units) result(text)
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      type(numerics_type) :: numerics
      type(default_finder_type) :: finder
      real(wp) :: number, scale
      logical :: legal
      text = trim(rule%default)
      if (rule%group == 'solver' .and. text == '' .and. index(rule%meaning, 'default') == 0) then
         finder%key = rule%key
         call visit_numerics(numerics, finder)
         if (finder%found) text = to_text(finder%value/unit_factor(units, rule%unit), default_digits)
         return
      end if
      if (rule%kind == kind_text .and. text /= '') text = ''''//text//''''
      if (rule%kind /= kind_real .or. text == '') return
      scale = unit_factor(si_units(), rule%unit)/unit_factor(units, rule%unit)
      call read_real(text, number, legal)
      if (legal .and. abs(scale - 1.0_wp) > epsilon(scale)) text = to_text(number*scale, default_digits)
   end function default_text

   !> Keeps the number whose default is looked for.
   subroutine look_at_number(self, key, value)
      class(default_finder_type), intent(inout) :: self
      character(*), intent(in) :: key
      real(wp), intent(inout) :: value
      if (key /= self%key) return
      self%value = value
      self%found = .true.
   end subroutine look_at_number
end module dg_deck_template
