!> Numbers and texts as cells of tables and of CSV files.
module dg_number_text
   use dg_kinds, only: wp
   use dg_missing, only: is_shown, optional_real
   use dg_printable, only: printable
   use dg_ten_digits, only: append_ten_digits
   use dg_text, only: append_text, append_piece, text_type, to_text
   implicit none
   private
   public :: fixed_cell, fixed_text, scientific_cell, count_cell, right_aligned, left_aligned
   public :: csv_text, append_csv_number
   public :: append_wrapped, page_width

   !> A cell of a table, '-' where there is no value.
   interface fixed_cell
      module procedure fixed_cell_of_number, fixed_cell_of_optional
   end interface fixed_cell

   character(*), parameter :: absent = '-'
   !> Line feed and carriage return.
   character(*), parameter :: breaks = achar(10)//achar(13)

   integer, parameter :: page_width = 120

contains

   !> `value` with `decimals` digits behind the point, right-aligned. It is in exponent form if it is too long, and '-' if it
   !> is not finite. Negative zero is never shown.
   pure function fixed_cell_of_number(value, width, decimals) result(cell)
      real(wp), intent(in) :: value
      integer, intent(in) :: width
      integer, intent(in) :: decimals
      character(width) :: cell
      character(40) :: buffer, form
      integer :: places
      if (.not. is_shown(value)) then
         cell = right_aligned(absent, width)
         return
      end if
      do places = decimals, 0, -1
         write (form, '(a, i0, a)') '(f40.', places, ')'
         write (buffer, form) value
         buffer = adjustl(buffer)
         if (verify(trim(buffer), '-0.') == 0 .and. buffer(1:1) == '-') buffer = buffer(2:)
         if (places == 0 .and. decimals > 0) buffer = buffer(:index(buffer//'.', '.') - 1)
         if (len_trim(buffer) < width) exit
      end do
      if (len_trim(buffer) >= width) then
         cell = scientific_cell(value, width)
      else
         cell = right_aligned(trim(buffer), width)
      end if
   end function fixed_cell_of_number

   !> The same of a number in SI units that may be absent; `unit` is the SI value of one unit shown.
   pure function fixed_cell_of_optional(number, unit, width, decimals) result(cell)
      type(optional_real), intent(in) :: number
      real(wp), intent(in) :: unit
      integer, intent(in) :: width
      integer, intent(in) :: decimals
      character(width) :: cell
      if (number%present) then
         cell = fixed_cell_of_number(number%value/unit, width, decimals)
      else
         cell = right_aligned(absent, width)
      end if
   end function fixed_cell_of_optional

   !> `value` with `decimals` digits behind the point, for sentences.
   pure function fixed_text(value, decimals) result(text)
      real(wp), intent(in) :: value
      integer, intent(in) :: decimals
      character(:), allocatable :: text
      integer, parameter :: widest = 14
      text = trim(adjustl(fixed_cell_of_number(value, widest, decimals)))
   end function fixed_text

   !> `value` with one digit behind the point and an exponent.
   pure function scientific_cell(value, width) result(cell)
      real(wp), intent(in) :: value
      integer, intent(in) :: width
      character(width) :: cell
      character(12) :: buffer
      if (.not. is_shown(value)) then
         cell = right_aligned(absent, width)
         return
      end if
      write (buffer, '(es12.1e3)') value
      if (abs(value) < 1.0e99_wp .and. (abs(value) > 1.0e-99_wp .or. abs(value) <= 0.0_wp)) &
         write (buffer, '(es12.1e2)') value
      cell = right_aligned(trim(adjustl(buffer)), width)
   end function scientific_cell

   !> A count; '-' where it does not apply.
   pure function count_cell(value, width, applies) result(cell)
      integer, intent(in) :: value
      integer, intent(in) :: width
      logical, intent(in), optional :: applies
      character(width) :: cell
      cell = right_aligned(to_text(value), width)
      if (present(applies)) then
         if (.not. applies) cell = right_aligned(absent, width)
      end if
   end function count_cell

   !> Text at the right edge of a cell; cut at its left where it is too long.
   pure function right_aligned(text, width) result(cell)
      character(*), intent(in) :: text
      integer, intent(in) :: width
      character(width) :: cell
      cell = ''
      if (len(text) <= width) then
         cell(width - len(text) + 1:) = text
      else
         cell = text(len(text) - width + 1:)
      end if
   end function right_aligned

   !> Text at the left edge of a cell, one blank behind it; cut with '...' where it is too long.
   pure function left_aligned(text, width) result(cell)
      character(*), intent(in) :: text
      integer, intent(in) :: width
      character(width) :: cell
      cell = text
      if (len(text) >= width) cell = text(:width - 4)//'...'
   end function left_aligned

   !> Append a number to the letters that a row has so far; nothing where it is no number. Ten significant digits: users compare
   !> files to 1e-6 and better.
   pure subroutine append_csv_number(row, filled, value)
      character(*), intent(inout) :: row      !< with room for `longest_number` letters
      integer, intent(inout) :: filled        !< letters so far
      real(wp), intent(in) :: value
      if (is_shown(value)) call append_ten_digits(row, filled, value + 0.0_wp) ! no negative zero
   end subroutine append_csv_number

   !> Text, quoted where it holds a comma, a quote or a line break (RFC 4180); other control bytes become '?'.
   pure function csv_text(text) result(field)
      character(*), intent(in) :: text
      character(:), allocatable :: field
      character(len(text)) :: plain
      character(:), allocatable :: room
      integer :: i, filled
      plain = printable(text, breaks)
      if (scan(plain, ',"'//breaks) == 0) then
         field = plain
         return
      end if
      allocate (character(2*len(text)) :: room)
      filled = 0
      do i = 1, len(text)
         call append_piece(room, filled, plain(i:i))
         if (plain(i:i) == '"') call append_piece(room, filled, '"')
      end do
      field = '"'//room(:filled)//'"'
   end function csv_text

   !> Appends a text in lines of at most `width`, broken at blanks where there are any, later lines
   !> indented by two. A number stays with its unit. No line for an empty text.
   pure subroutine append_wrapped(lines, text, width)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: text
      integer, intent(in), optional :: width          !< absent: of the page
      character(*), parameter :: indent = '  '
      character(:), allocatable :: rest
      integer :: cut, most
      if (text == '') return
      most = page_width
      if (present(width)) most = width
      rest = text
      do while (len_trim(rest) > most)
         cut = index(rest(:most + 1), ' ', back=.true.)
         if (ends_in_number(rest(:cut - 1))) cut = index(rest(:cut - 1), ' ', back=.true.)
         if (cut <= len(indent) + 1) cut = most + 1
         call append_text(lines, trim(rest(:cut - 1)))
         rest = indent//trim(adjustl(rest(cut:)))
      end do
      call append_text(lines, trim(rest))
   contains
      pure function ends_in_number(words) result(does)
         character(*), intent(in) :: words
         logical :: does
         does = .false.
         if (words /= '') does = scan(words(len(words):), '0123456789') > 0
      end function ends_in_number
   end subroutine append_wrapped
end module dg_number_text
