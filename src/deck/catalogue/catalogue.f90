!> The catalogue of pipe: a table whose columns are keys of &component with their unit, one row per entry. Rows of kind 'grade'
!> are steels. The name of a pipe followed by that of a grade is the pipe with the yield strength of the grade.
module dg_catalogue
   use dg_kinds, only: wp
   use dg_catalogue_lines, only: catalogue_lines
   use dg_connection, only: connection_name
   use dg_deck_number, only: read_real
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: hold_in_range, key_rule_type
   use dg_error, only: add_fault, add_unreadable, error_list_type, error_type
   use dg_file_lines, only: beside, read_lines
   use dg_merge_sort, only: first_equal
   use dg_quantity, only: system_count, unit_type
   use dg_table_text, only: split_fields, without_comment
   use dg_text, only: joined, lower_case, quoted, text_type, to_text
   use dg_text_fault, only: find_text_fault
   use dg_unit_kind, only: unit_factor
   use dg_units, only: system_of, unit_in, unit_system_type
   implicit none
   private
   public :: catalogue_type, entry_type, read_catalogue, find_catalogue, find_entry, number_of, numeric_keys
   public :: catalogue_within, kind_of_grades, place_of_name

   !> It is searched beside the deck, then at the variable of the environment, then in input/ of the working folder. Otherwise
   !> it is the one within the program, under a name that no file of a user has.
   character(*), parameter :: catalogue_name = 'catalogue.csv'
   character(*), parameter :: catalogue_variable = 'DRILLGAP_CATALOGUE'
   character(*), parameter :: catalogue_within = 'the catalogue of the program'

   !> Keys of &component that a catalogue may give.
   character(*), parameter :: numeric_keys(21) = [character(22) :: 'od', 'id', 'mass', 'density', 'youngs', 'poisson', 'joint_od', &
      'opened_od', 'joint_length', 'joint_spacing', 'yield', 'makeup_torque', 'joint_id', 'joint_yield', 'joint_torsion', &
      'tension_efficiency', 'compression_efficiency', 'burst_efficiency', 'collapse_efficiency', 'joint_dogleg', &
      'yield_loss']
   character(*), parameter :: kind_of_grades = 'grade'
   !> Columns of texts, and those that no component needs.
   integer, parameter :: column_ignored = 0, column_name = -1, column_kind = -2, column_source = -3, column_connection = -4

   type :: entry_type
      character(:), allocatable :: name
      character(:), allocatable :: kind
      character(:), allocatable :: source
      character(:), allocatable :: connection             !< as a deck may give it; '': not known
      logical :: has(size(numeric_keys)) = .false.
      real(wp) :: numbers(size(numeric_keys)) = 0.0_wp  !< of those keys [SI]
   end type entry_type

   type :: catalogue_type
      character(:), allocatable :: path
      type(entry_type), allocatable :: entries(:)
   end type catalogue_type

contains

   !> Path of the catalogue for a deck ('' for none): `named` in the deck, or the first one that is there, or that of the program.
   subroutine find_catalogue(deck, named, path)
      character(*), intent(in) :: deck          !< path
      character(*), intent(in) :: named         !< named by the deck, from its folder; '': not named
      character(:), allocatable, intent(out) :: path
      character(:), allocatable :: variable
      integer :: length, status
      logical :: is
      path = ''
      if (named /= '') then
         path = beside(deck, named)
         return
      end if
      inquire (file=beside(deck, catalogue_name), exist=is)
      if (is) then
         path = beside(deck, catalogue_name)
         return
      end if
      call get_environment_variable(catalogue_variable, length=length, status=status)
      if (status == 0 .and. length > 0) then
         allocate (character(length) :: variable)
         call get_environment_variable(catalogue_variable, value=variable)
         path = variable
         return
      end if
      inquire (file='input/'//catalogue_name, exist=is)
      if (is) path = 'input/'//catalogue_name
      if (.not. is) path = catalogue_within
   end subroutine find_catalogue

   !> Read the table `path` with all its faults. Two rows of one name, one of them a grade or not, are ambiguous and also a
   !> fault.
   subroutine read_catalogue(path, catalogue, faults, asked)
      character(*), intent(in) :: path
      type(catalogue_type), intent(out) :: catalogue
      type(error_list_type), intent(inout) :: faults
      type(error_type), intent(in), optional :: asked   !< where the deck names the file, for one that cannot be read
      type(text_type), allocatable :: lines(:), fields(:)
      character(:), allocatable :: failure, text
      integer, allocatable :: columns(:), line_of(:)
      real(wp), allocatable :: factors(:)
      integer :: line, n
      logical :: has_header
      catalogue%path = path
      failure = ''
      if (path == catalogue_within) then
         allocate (lines(size(catalogue_lines)))
         do line = 1, size(lines)
            lines(line)%text = trim(catalogue_lines(line))
         end do
      else
         call read_lines(path, lines, failure)
      end if
      allocate (catalogue%entries(size(lines)))
      allocate (line_of(size(lines)), source=0)
      if (failure /= '') call add_unreadable(faults, path, 'catalogue '//failure, asked)
      has_header = .false.
      n = 0
      do line = 1, size(lines)
         text = without_comment(lines(line)%text)
         if (text == '') cycle
         call split_fields(text, ',', fields)
         if (.not. has_header) then
            has_header = .true.
            call read_header(path, line, fields, columns, factors, faults)
            if (.not. any(columns == column_name)) exit
         else
            n = n + 1
            line_of(n) = line
            call read_entry(path, line, fields, columns, factors, catalogue%entries(n), faults)
         end if
      end do
      catalogue%entries = catalogue%entries(:n)
      call check_names(catalogue, line_of, faults)
   end subroutine read_catalogue

   !> Entries of one name, letter case and number of blanks aside, grades among themselves.
   subroutine check_names(catalogue, line_of, faults)
      type(catalogue_type), intent(in) :: catalogue
      integer, intent(in) :: line_of(:)                 !< of each entry
      type(error_list_type), intent(inout) :: faults
      type(text_type) :: names(size(catalogue%entries))
      integer :: first(size(names)), i
      do i = 1, size(names)
         names(i)%text = plain(catalogue%entries(i)%name)
         if (catalogue%entries(i)%kind == kind_of_grades) names(i)%text = kind_of_grades//': '//names(i)%text
      end do
      first = first_equal(names)
      do i = 1, size(names)
         if (first(i) == i .or. catalogue%entries(i)%name == '') cycle
         call add_fault(faults, catalogue%path, line_of(i), 'catalogue: '//quoted(catalogue%entries(i)%name)// &
                        ' stands in line '//to_text(line_of(first(i)))//' already; keep one')
      end do
   end subroutine check_names

   !> Content of each column: the place of its key among `numeric_keys`, or one of the texts; and the SI value of its unit.
   subroutine read_header(path, line, fields, columns, factors, faults)
      character(*), intent(in) :: path
      integer, intent(in) :: line
      type(text_type), intent(in) :: fields(:)
      integer, allocatable, intent(out) :: columns(:)
      real(wp), allocatable, intent(out) :: factors(:)
      type(error_list_type), intent(inout) :: faults
      type(unit_system_type) :: units
      type(key_rule_type) :: rule
      integer :: i, k, system
      allocate (columns(size(fields)), source=column_ignored)
      allocate (factors(size(fields)), source=1.0_wp)
      do i = 1, size(fields)
         select case (lower_case(fields(i)%text))
         case ('name'); columns(i) = column_name
         case ('kind'); columns(i) = column_kind
         case ('source'); columns(i) = column_source
         case ('connection'); columns(i) = column_connection
         case default
            do k = 1, size(numeric_keys)
               rule = rule_of(k)
               do system = 1, system_count
                  units = system_of(system)
                  if (lower_case(fields(i)%text) /= lower_case(heading_of(rule, units))) cycle
                  columns(i) = k
                  factors(i) = unit_factor(units, rule%unit)
               end do
            end do
            if (columns(i) == column_ignored) call add_fault(faults, path, line, 'catalogue: unknown column '// &
               quoted(fields(i)%text)//'; legal: name, kind, source, connection, and '//joined(numeric_keys, ', ')// &
               ' with their unit behind, as in od_in, od_mm, mass_lbm_ft, mass_kg_m')
         end select
      end do
      if (.not. any(columns == column_name)) call add_fault(faults, path, line, 'catalogue: the header names no name')
   end subroutine read_header

   !> One row; a number outside the range that a deck may give is a fault.
   subroutine read_entry(path, line, fields, columns, factors, entry, faults)
      character(*), intent(in) :: path
      integer, intent(in) :: line
      type(text_type), intent(in) :: fields(:)
      integer, intent(in) :: columns(:)
      real(wp), intent(in) :: factors(:)
      type(entry_type), intent(out) :: entry
      type(error_list_type), intent(inout) :: faults
      type(key_rule_type) :: rule
      real(wp) :: number
      integer :: i
      logical :: legal
      character(:), allocatable :: failure
      entry%name = ''
      entry%kind = ''
      entry%source = ''
      entry%connection = ''
      if (size(fields) > size(columns)) call add_fault(faults, path, line, 'catalogue: the row has '//to_text(size(fields))// &
         ' columns, the header '//to_text(size(columns)))
      do i = 1, min(size(fields), size(columns))
         if (fields(i)%text == '') cycle
         if (any(columns(i) == [column_name, column_kind, column_source])) then
            call find_text_fault(fields(i)%text, columns(i) /= column_source, failure)
            if (failure /= '') call add_fault(faults, path, line, 'catalogue: '//quoted(fields(i)%text)//' '//failure)
         end if
         select case (columns(i))
         case (column_name); entry%name = fields(i)%text
         case (column_kind); entry%kind = fields(i)%text
         case (column_source); entry%source = fields(i)%text
         case (column_connection)
            if (.not. any(connection_name == fields(i)%text)) call add_fault(faults, path, line, 'catalogue: connection = '// &
               quoted(fields(i)%text)//' is unknown; legal: '//joined(connection_name, ', '))
            entry%connection = fields(i)%text
         case (column_ignored)
         case default
            call read_real(fields(i)%text, number, legal)
            rule = rule_of(columns(i))
            if (legal) then
               number = number*factors(i)
               call hold_in_range(rule, number, legal)
            end if
            if (.not. legal) then
               call add_fault(faults, path, line, 'catalogue: '//trim(rule%key)//' = '//quoted(fields(i)%text)// &
                              ' is not a number that a deck may give')
               cycle
            end if
            entry%has(columns(i)) = .true.
            entry%numbers(columns(i)) = number
         end select
      end do
      if (entry%name == '') call add_fault(faults, path, line, 'catalogue: the row has no name')
   end subroutine read_entry

   !> Find entry and grade of a name, letter case and number of blanks aside; 0 if not found. A grade follows the name of a
   !> pipe.
   pure subroutine find_entry(catalogue, name, entry, grade)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: name
      integer, intent(out) :: entry, grade
      character(:), allocatable :: wanted
      integer :: cut
      wanted = plain(name)
      grade = 0
      entry = place_of_name(catalogue, wanted, .false.)
      cut = index(wanted, ' ', back=.true.)
      if (entry > 0 .or. cut == 0) return
      grade = place_of_name(catalogue, wanted(cut + 1:), .true.)
      if (grade > 0) entry = place_of_name(catalogue, wanted(:cut - 1), .false.)
   end subroutine find_entry

   !> Place of a name among the entries or the grades of a catalogue, letter case and number of blanks aside; 0: not found.
   pure function place_of_name(catalogue, name, among_grades) result(place)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: name
      logical, intent(in) :: among_grades
      integer :: place
      character(:), allocatable :: wanted
      wanted = plain(name)
      do place = size(catalogue%entries), 1, -1
         if ((catalogue%entries(place)%kind == kind_of_grades) .neqv. among_grades) cycle
         if (plain(catalogue%entries(place)%name) == wanted) return
      end do
   end function place_of_name

   !> Value of one of `numeric_keys` [SI] for an entry with a grade (0: none). `has` is false where the entry has no value.
   pure subroutine number_of(catalogue, entry, grade, key, has, number)
      type(catalogue_type), intent(in) :: catalogue
      integer, intent(in) :: entry, grade
      integer, intent(in) :: key             !< place in `numeric_keys`
      logical, intent(out) :: has
      real(wp), intent(out) :: number
      has = catalogue%entries(entry)%has(key)
      number = catalogue%entries(entry)%numbers(key)
      if (grade == 0) return
      if (.not. catalogue%entries(grade)%has(key)) return
      has = .true.
      number = catalogue%entries(grade)%numbers(key)
   end subroutine number_of

   !> A name for comparison: small letters, single blanks.
   pure function plain(name) result(text)
      character(*), intent(in) :: name
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, len(name)
         if (name(i:i) == ' ') then
            if (len(text) == 0) cycle
            if (text(len(text):) == ' ') cycle
         end if
         text = text//lower_case(name(i:i))
      end do
      text = trim(text)
   end function plain

   !> Heading of a column: key and unit, as in the files of results.
   pure function heading_of(rule, units) result(heading)
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: heading
      type(unit_type) :: unit
      unit = unit_in(units, rule%unit)
      heading = trim(rule%key)
      if (unit%suffix /= '') heading = heading//'_'//trim(unit%suffix)
   end function heading_of

   !> The rule of one of `numeric_keys`.
   pure function rule_of(key) result(rule)
      integer, intent(in) :: key
      type(key_rule_type) :: rule
      type(key_rule_type), allocatable :: rules(:)
      integer :: i
      allocate (rules, source=keys_of('component'))
      do i = 1, size(rules)
         if (rules(i)%key == numeric_keys(key)) rule = rules(i)
      end do
   end function rule_of
end module dg_catalogue
