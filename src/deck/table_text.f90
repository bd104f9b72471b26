!> Rows and headings of tables as people have them: separators, quotes, decimal commas, units behind names.
module dg_table_text
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_text, only: append_text, lower_case, text_type
   implicit none
   private
   public :: blank_brackets, close_brackets, find_separator, length_unit, angle_unit, other_unit, split_fields, split_heading, &
             split_unit, without_comment

   character(*), parameter :: tab = achar(9)
   character(*), parameter :: digits = '0123456789'
   character(*), parameter :: number_letters = digits//'+-.,eEdD'
   !> Feet of 1959 and of the United States' surveys (NIST SP 811) [m].
   real(wp), parameter :: foot = 0.3048_wp, survey_foot = 1200.0_wp/3937.0_wp

contains

   !> What separates the fields of a header: ; , tab or blanks. Brackets do not count.
   pure function find_separator(header) result(separator)
      character(*), intent(in) :: header
      character :: separator
      character(len(header)) :: bare
      bare = blank_brackets(header)
      separator = ' '
      if (index(bare, tab) > 0) separator = tab
      if (index(bare, ',') > 0) separator = ','
      if (index(bare, ';') > 0) separator = ';'
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

   !> The same, for units behind _ or a blank too ('md_ft', 'Incl. deg'), the name without blanks and marks: 'Meas. Depth [ft]'
   !> gives measdepth and ft.
   pure subroutine split_heading(heading, name, unit)
      character(*), intent(in) :: heading
      character(:), allocatable, intent(out) :: name, unit
      character(:), allocatable :: whole
      integer :: cut, i
      call split_unit(heading, whole, unit)
      cut = scan(whole, ' _', back=.true.)
      if (unit == '' .and. cut > 1) then
         if (length_unit(whole(cut + 1:)) > 0.0_wp .or. angle_unit(whole(cut + 1:)) > 0.0_wp) then
            unit = whole(cut + 1:)
            whole = whole(:cut - 1)
         end if
      end if
      name = ''
      do i = 1, len(whole)
         if (scan(whole(i:i), ' _.-') == 0) name = name//whole(i:i)
      end do
   end subroutine split_heading

   !> Whether a heading's text in small letters is a unit of length or angle that is not converted here. Taken for no unit,
   !> it would make wrong numbers of right ones.
   pure function other_unit(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      character(*), parameter :: others(16) = [character(7) :: 'gon', 'gons', 'grad', 'grads', 'dms', 'turn', 'rev', 'km', 'hm', &
         'cm', 'mm', 'in', 'inch', 'yd', 'mi', 'fathom']
      is = any(others == name)
   end function other_unit

   !> SI value of a unit of length by its name in small letters [m]; 0 where it is none that we know.
   pure function length_unit(name) result(value)
      character(*), intent(in) :: name
      real(wp) :: value
      select case (name)
      case ('ft', 'f', 'feet', 'foot'); value = foot
      case ('usft', 'ftus', 'ft us', 'us ft'); value = survey_foot
      case ('m', 'meter', 'metre', 'meters', 'metres'); value = 1.0_wp
      case default; value = 0.0_wp
      end select
   end function length_unit

   !> SI value of a unit of angle by its name in small letters [rad]; 0 where it is none that we know.
   pure function angle_unit(name) result(value)
      character(*), intent(in) :: name
      real(wp) :: value
      select case (name)
      case ('deg', 'degree', 'degrees', 'dega'); value = degree
      case ('rad', 'radian', 'radians'); value = 1.0_wp
      case default; value = 0.0_wp
      end select
   end function angle_unit

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

   !> The text without blanks before and inside brackets, so that 'MD (m)' is one field.
   pure function close_brackets(text) result(tight)
      character(*), intent(in) :: text
      character(:), allocatable :: tight
      integer :: i, depth
      depth = 0
      tight = ''
      do i = 1, len(text)
         if (scan(text(i:i), '([') == 1) then
            depth = depth + 1
            tight = trim(tight)
         end if
         if (depth == 0 .or. scan(text(i:i), ' '//tab) == 0) tight = tight//text(i:i)
         if (scan(text(i:i), ')]') == 1) depth = max(depth - 1, 0)
      end do
   end function close_brackets

   !> A line without its comment, tabs at its ends and blanks.
   pure function without_comment(line) result(text)
      character(*), intent(in) :: line
      character(:), allocatable :: text
      integer :: last
      last = index(line, '#') - 1
      if (last < 0) last = len(line)
      text = line(:last)
      if (verify(text, ' '//tab//',;') == 0) text = ''    ! a row of empty cells, as spreadsheets leave them
   end function without_comment

   !> Fields of a row; blanks and tabs together are one separator. A field in quotes may hold the separator. Numbers with a
   !> decimal comma or with marks between thousands become plain ones.
   pure subroutine split_fields(text, separator, fields)
      character(*), intent(in) :: text
      character, intent(in) :: separator
      type(text_type), allocatable, intent(out) :: fields(:)
      character :: quote
      character(:), allocatable :: field
      logical :: was_quoted
      integer :: i
      allocate (fields(0))
      field = ''
      quote = ' '
      was_quoted = .false.
      do i = 1, len(text)
         if (quote /= ' ') then
            if (text(i:i) == quote) then
               quote = ' '
            else
               field = field//text(i:i)
            end if
         else if (scan(text(i:i), '"''') == 1 .and. field == '') then
            quote = text(i:i)
            was_quoted = .true.
         else if (is_separator(text(i:i))) then
            call close_field(separator, field, was_quoted, fields)
         else
            field = field//text(i:i)
         end if
      end do
      call close_field(separator, field, was_quoted, fields)

   contains

      pure function is_separator(letter) result(is)
         character, intent(in) :: letter
         logical :: is
         is = letter == separator .or. (separator == ' ' .and. letter == tab)
      end function is_separator
   end subroutine split_fields

   !> Puts a field that has ended to the others, and begins the next.
   pure subroutine close_field(separator, field, was_quoted, fields)
      character, intent(in) :: separator
      character(:), allocatable, intent(inout) :: field
      logical, intent(inout) :: was_quoted
      type(text_type), allocatable, intent(inout) :: fields(:)
      field = trim(adjustl(untabbed(field)))
      if (field /= '' .or. separator /= ' ' .or. was_quoted) call append_text(fields, plain_number(field, separator == ','))
      field = ''
      was_quoted = .false.
   end subroutine close_field

   !> Tabs as blanks.
   pure function untabbed(text) result(blank)
      character(*), intent(in) :: text
      character(len(text)) :: blank
      integer :: i
      blank = text
      do i = 1, len(text)
         if (text(i:i) == tab) blank(i:i) = ' '
      end do
   end function untabbed

   !> A number with commas as Fortran reads it; any other text as it is. Of point and comma the last is the decimal mark; one
   !> comma alone is decimal, unless `groups` says that commas before three digits part thousands.
   pure function plain_number(field, groups) result(plain)
      character(*), intent(in) :: field
      logical, intent(in) :: groups
      character(:), allocatable :: plain
      character :: decimal
      integer :: i, comma
      plain = field
      comma = index(field, ',', back=.true.)
      if (comma == 0 .or. verify(field, number_letters) > 0) return
      decimal = ','
      if (index(field, '.', back=.true.) > comma) decimal = '.'
      if (index(field, '.') == 0) then
         if (index(field, ',') /= comma) decimal = '.'          ! several: thousands
         if (groups .and. len(field) - comma == 3) decimal = '.'
      end if
      plain = ''
      do i = 1, len(field)
         if (field(i:i) == decimal) then
            plain = plain//'.'
         else if (scan(field(i:i), '.,') == 0) then
            plain = plain//field(i:i)
         end if
      end do
   end function plain_number
end module dg_table_text
