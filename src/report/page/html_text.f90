!> Pieces of an HTML page: texts made safe, tables of our columns, pictures put inline.
module dg_html_text
   use dg_kinds, only: wp
   use dg_column, only: column_type, field_absent, field_integer, field_real, field_text, field_type, fields_of, quantity_angle, &
                        quantity_length, quantity_line_load, quantity_moment, quantity_none, quantity_percent, quantity_text, &
                        quantity_time, quantity_turns, row_type
   use dg_json, only: quantity_key
   use dg_line_list, only: add_line, line_list_type
   use dg_load_case, only: operation_from_name, operation_label
   use dg_markup, only: html_safe
   use dg_missing, only: is_shown
   use dg_number_text, only: fixed_text
   use dg_quantity, only: quantity_rows => rows, system_base, system_name
   use dg_readable, only: spaced
   use dg_text, only: plain_utf8, text_type, to_text
   use dg_units, only: system_of, unit_system_type
   use dg_unit_kind, only: at_most, in_units, unit_factor, unit_label
   implicit none
   private
   public :: append_rows, append_table, append_preformatted, append_inline_svg, css_string, heading_of, number_cell, said, &
             said_number, switched

   !> A column of residuals: its order of magnitude matters, however small.
   character(*), parameter :: residual_name = 'equilibrium'
   integer, parameter :: residual_digits = 2
   character(*), parameter :: operation_column = 'operation'
   !> Heading of a column that differs from its name in files.
   type :: heading_type
      character(21) :: column
      character(44) :: heading
   end type heading_type

   type(heading_type), parameter :: own_headings(*) = [ &
      heading_type('governing_limit', 'most used limit'), &
      heading_type('governing_utilisation', 'of it used'), &
      heading_type('governing_md', 'depth of most used limit'), &
      heading_type('largest_von_mises', 'largest von Mises, no bending between joints'), &
      heading_type('side_force_on_joint', 'side force per joint of pipe'), &
      heading_type('largest_bending', 'largest bending moment'), &
      heading_type('largest_bending_md', 'depth of largest moment'), &
      heading_type('side_force', 'side force (at an edge: over a short length)'), &
      heading_type('largest_side_force', 'largest mean side force'), &
      heading_type('largest_side_force_md', 'depth of largest mean side force'), &
      heading_type('least_safety_md', 'depth of least safety factor'), &
      heading_type('buckling_margin_md', 'depth of buckling margin'), &
      heading_type('windup', 'wind-up'), &
      heading_type('neutral_top', 'neutral point'), &
      heading_type('wob_buckling', 'WOB at buckling'), &
      heading_type('wob_no_hookload', 'WOB at zero hook load'), &
      heading_type('wob_lockup', 'WOB at lock-up'), &
      heading_type('rig_margin', 'margin to rig limit'), &
      heading_type('snaking_length', 'length of sinusoidal buckling'), &
      heading_type('coiled_length', 'length of helical buckling'), &
      heading_type('coil_turns', 'turns of helix')]
   !> A number without unit below this is shown with so many digits, not with so many decimals.
   real(wp), parameter :: small_number = 1.0_wp
   integer, parameter :: few_digits = 3
   !> Digits of a number from which the script makes another unit's, and the difference that it does not see [-].
   integer, parameter :: switched_digits = 7
   real(wp), parameter :: unseen = 1.0e-7_wp
   !> A text longer than this is a sentence, which may be broken.
   integer, parameter :: longest_name = 40

   !> Attributes that gnuplot writes into each group of a picture; they say what holds without them.
   character(*), parameter :: idle_attributes = ' stroke-linecap="butt" stroke-linejoin="miter"'

   integer, parameter :: last_ascii = 127

contains

   !> Text as a string of CSS that is also valid in HTML. All but letters, digits, blanks and bytes beyond ASCII are written as
   !> numbers.
   pure function css_string(text) result(string)
      character(*), intent(in) :: text
      character(:), allocatable :: string
      character(len(text)) :: plain
      character(8) :: number     ! its last blank ends it and is not shown
      integer :: i
      plain = plain_utf8(text)
      string = '"'
      do i = 1, len(text)
         select case (plain(i:i))
         case ('a':'z', 'A':'Z', '0':'9', ' ', ',', '.', ':', '-', '+', '(', ')')
            string = string//plain(i:i)
         case default
            if (iachar(plain(i:i)) > last_ascii) then
               string = string//plain(i:i)
            else
               write (number, '(a,z6.6,1x)') '\', iachar(plain(i:i))
               string = string//number
            end if
         end select
      end do
      string = string//'"'
   end function css_string

   !> A table of the columns of those names that have any value; each with its unit below, its meaning where the mouse rests.
   subroutine append_table(page, names, units, rows, marked)
      type(line_list_type), intent(inout) :: page
      character(*), intent(in) :: names(:)
      type(unit_system_type), intent(in) :: units
      type(row_type), intent(in) :: rows(:)
      logical, intent(in) :: marked(:)                !< rows that cannot be done or have no solution: their first cell has a '!'
      type(row_type) :: shown(size(rows))
      character(:), allocatable :: head, line
      logical :: used(size(names))
      integer :: k, row
      do row = 1, size(rows)
         shown(row) = fields_of(rows(row), names)
      end do
      head = '<div class="wide" tabindex="0"><table><thead><tr>'
      do k = 1, size(names)
         used(k) = any([(has_value(shown(row)%fields(k)), row=1, size(rows))])
         if (used(k)) head = head//head_cell(shown(1)%fields(k)%column, units)
      end do
      call add_line(page, head//'</tr></thead><tbody>')
      do row = 1, size(rows)
         line = ''
         do k = 1, size(names)
            if (used(k)) line = line//table_cell(shown(row)%fields(k), units)
            if (marked(row) .and. k == findloc(used, .true., dim=1)) line = line(:len(line) - len('</td>'))//' !</td>'
         end do
         call add_line(page, '<tr'//trim(merge(' class="bad"', '            ', marked(row)))//'>'//line//'</tr>')
      end do
      call add_line(page, '</tbody></table></div>')
   end subroutine append_table

   !> A table of all columns that have any value.
   subroutine append_rows(page, units, rows, marked)
      type(line_list_type), intent(inout) :: page
      type(unit_system_type), intent(in) :: units
      type(row_type), intent(in) :: rows(:)     !< one or more
      logical, intent(in) :: marked(:)          !< as append_table
      call append_table(page, rows(1)%fields(:rows(1)%count)%column%name, units, rows, marked)
   end subroutine append_rows

   !> Heading of a column.
   pure function head_cell(column, units) result(cell)
      type(column_type), intent(in) :: column
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: cell
      cell = '<th'//trim(merge(' class="text"', '             ', column%quantity == quantity_text))//' title="'// &
             html_safe(trim(column%meaning))//'"'//switched(column%quantity)//' scope="col">'// &
             heading_of(trim(column%name))//'<br><small>'//html_safe(unit_label(units, column%quantity))//'</small></th>'
   end function head_cell

   pure function table_cell(field, units) result(cell)
      type(field_type), intent(in) :: field
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: cell
      real(wp) :: value
      integer :: place
      cell = '<td>&ndash;</td>'
      if (.not. has_value(field)) return
      select case (field%kind)
      case (field_text)
         place = 0
         if (field%column%name == operation_column) place = operation_from_name(field%text)
         if (place > 0) then
            cell = '<td class="text word">'//trim(operation_label(place))//'</td>'      ! as in Table 1
            return
         end if
         cell = '<td class="text'//trim(merge(' long', '     ', len(field%text) > longest_name))//'">'//html_safe(field%text)// &
                '</td>'
      case (field_integer)
         cell = '<td>'//to_text(field%integer_value)//'</td>'
      case (field_real)
         value = field%real_value/unit_factor(units, field%column%quantity)
         if (field%column%name == residual_name) then
            cell = '<td>'//to_text(value, residual_digits)//'</td>'
         else if (field%column%quantity == quantity_none .and. abs(value) < small_number) then
            ! numbers without unit have any size: a tolerance, a friction factor
            cell = '<td>'//to_text(value, few_digits)//'</td>'
         else
            cell = number_cell(value, fixed_text(value, decimals(field%column%quantity, value)), field%column%quantity)
         end if
      case default
      end select
   end function table_cell

   !> Attribute of a heading that lets the script show its column in other units; '' where all systems have the same.
   pure function switched(quantity) result(attribute)
      integer, intent(in) :: quantity
      character(:), allocatable :: attribute
      attribute = ''
      if (has_units(quantity)) attribute = ' data-q="'//quantity_key(quantity)//'"'
   end function switched

   !> Attributes of an element whose text is a sentence: the sentence in each other system of units, where it differs.
   pure function said(text, systems) result(found)
      character(*), intent(in) :: text              !< in the deck's units
      type(text_type), intent(in) :: systems(:)     !< by system
      character(:), allocatable :: found
      character(:), allocatable :: name
      integer :: k
      found = ''
      do k = 1, size(systems)
         name = trim(system_name(k))
         if (name == 'SI') name = 'si'              ! names of found have no capitals
         if (systems(k)%text /= text) found = found//' data-'//name//'="'//html_safe(systems(k)%text)//'"'
      end do
   end function said

   !> A number in a sentence, with its unit.
   pure function said_number(units, quantity, value, digits, down) result(span)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      real(wp), intent(in) :: value                 !< [SI]
      integer, intent(in) :: digits
      logical, intent(in), optional :: down         !< rounded down
      character(:), allocatable :: span
      type(text_type) :: systems(system_base - 1)
      integer :: k
      do k = 1, size(systems)
         systems(k)%text = shown(system_of(k))
      end do
      span = shown(units)
      span = '<span'//said(span, systems)//'>'//html_safe(span)//'</span>'
   contains
      pure function shown(system) result(text)
         type(unit_system_type), intent(in) :: system
         character(:), allocatable :: text
         text = in_units(system, quantity, value, digits)
         if (present(down)) then
            if (down) text = in_units(system, quantity, at_most(system, quantity, value, digits), digits)
         end if
      end function shown
   end function said_number

   !> True if the systems of units that decks have differ in a quantity.
   pure function has_units(quantity) result(has)
      integer, intent(in) :: quantity
      logical :: has
      has = any(quantity_rows(quantity)%units(:system_base - 1)%label /= quantity_rows(quantity)%units(1)%label)
   end function has_units

   !> A number with its text. Where the text has less digits than another unit's needs, the number stands beside it.
   pure function number_cell(value, text, quantity) result(cell)
      real(wp), intent(in) :: value         !< in the deck's units
      character(*), intent(in) :: text
      integer, intent(in) :: quantity
      character(:), allocatable :: cell
      real(wp) :: shown
      integer :: failed
      cell = '<td>'//text//'</td>'
      if (.not. has_units(quantity)) return
      read (text, *, iostat=failed) shown
      if (failed == 0) then
         if (abs(shown - value) <= unseen*abs(value)) return
      end if
      cell = '<td data-v="'//to_text(value, switched_digits)//'">'//text//'</td>'
   end function number_cell

   pure function has_value(field) result(has)
      type(field_type), intent(in) :: field
      logical :: has
      has = field%kind /= field_absent
      if (field%kind == field_real) has = is_shown(field%real_value)
      if (field%kind == field_text) has = field%text /= ''
   end function has_value

   !> Digits behind the point that an engineer reads of a quantity. Angles below a degree are those of bit and sensor.
   pure function decimals(quantity, value) result(number)
      integer, intent(in) :: quantity
      real(wp), intent(in) :: value     !< in its unit
      integer :: number
      select case (quantity)
      case (quantity_line_load, quantity_time)
         number = 3
      case (quantity_none, quantity_length, quantity_moment, quantity_percent, quantity_turns)
         number = 2
      case (quantity_angle)
         number = merge(3, 1, abs(value) < 1.0_wp)
      case default
         number = 1
      end select
   end function decimals

   !> Words over a column.
   pure function heading_of(name) result(heading)
      character(*), intent(in) :: name
      character(:), allocatable :: heading
      integer :: i
      heading = spaced(name)
      do i = 1, size(own_headings)
         if (name == own_headings(i)%column) heading = trim(own_headings(i)%heading)
      end do
   end function heading_of

   !> Lines as they are, in letters of one width.
   pure subroutine append_preformatted(lines, texts)
      type(line_list_type), intent(inout) :: lines
      type(text_type), intent(in) :: texts(:)
      integer :: i
      call add_line(lines, '<pre tabindex="0">')
      do i = 1, size(texts)
         call add_line(lines, html_safe(texts(i)%text))
      end do
      call add_line(lines, '</pre>')
   end subroutine append_preformatted

   !> Append a picture within the page. What stands before <svg>, groups without content and idle attributes are left out. `prefix`
   !> makes the names of its marks its own.
   pure subroutine append_inline_svg(lines, svg, prefix)
      type(line_list_type), intent(inout) :: lines
      type(text_type), intent(in) :: svg(:)      !< lines of the file
      character(*), intent(in) :: prefix         !< other for each picture of a page
      integer :: i
      logical :: inside
      inside = .false.
      i = 0
      do while (i < size(svg))
         i = i + 1
         associate (text => svg(i)%text)
            if (index(text, '<svg') > 0) inside = .true.
            if (.not. inside .or. text == '') cycle
            if (is_empty_group(i)) then
               i = i + 1
            else
               call add_line(lines, own(text))
            end if
         end associate
      end do
   contains
      !> True if an empty group begins in line i: it ends in the next line. gnuplot writes one for each change of a pen.
      pure function is_empty_group(i) result(is)
         integer, intent(in) :: i
         logical :: is
         is = .false.
         if (i == size(svg)) return
         associate (text => svg(i)%text)
            is = index(text, '<g ') == 1 .and. index(text, '>') == len_trim(text) .and. svg(i + 1)%text == '</g>'
         end associate
      end function is_empty_group

      !> With the names that gnuplot gives in every picture.
      pure function own(text) result(changed)
         character(*), intent(in) :: text
         character(:), allocatable :: changed
         integer :: at
         changed = text
         at = index(text, idle_attributes)
         if (at > 0) changed = text(:at - 1)//text(at + len(idle_attributes):)
         if (index(text, '''') == 0) return       ! they stand in single quotes
         changed = renamed(renamed(renamed(renamed(changed, 'gpPt'), 'gpDot'), 'textbox'), 'greybox')
      end function own

      pure function renamed(text, name) result(changed)
         character(*), intent(in) :: text, name
         character(:), allocatable :: changed
         integer :: at, next
         changed = ''
         at = 1
         do
            next = index(text(at:), name)
            if (next == 0) exit
            changed = changed//text(at:at + next - 2)//prefix//name
            at = at + next - 1 + len(name)
         end do
         changed = changed//text(at:)
      end function renamed
   end subroutine append_inline_svg
end module dg_html_text
