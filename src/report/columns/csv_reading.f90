!> Reads CSV files of results back as they were written (RFC 4180): for tables of pages, which show what pictures draw from.
module dg_csv_reading
   use dg_kinds, only: wp
   use dg_column, only: column_header, column_type, field_list_type, put, put_none, quantity_none, quantity_text, unit_size
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: csv_texts, columns_in, read_csv_row, ends_in_quotes

   character(*), parameter :: quote = '"'

contains

   !> The texts of a row, without their quotes.
   pure subroutine csv_texts(line, texts)
      character(*), intent(in) :: line
      type(text_type), allocatable, intent(out) :: texts(:)
      character(len(line)) :: text
      integer :: i, filled, number
      logical :: quoted
      allocate (texts(count([(line(i:i) == ',', i=1, len(line))]) + 1))      ! and one for each comma within quotes
      number = 0
      filled = 0
      quoted = .false.
      do i = 1, len(line)
         if (line(i:i) == quote) then
            quoted = .not. quoted
            ! two quotes within quotes are one
            if (.not. quoted .or. i == 1) cycle
            if (line(i - 1:i - 1) /= quote) cycle
         else if (line(i:i) == ',' .and. .not. quoted) then
            number = number + 1
            texts(number)%text = text(:filled)
            filled = 0
            cycle
         end if
         filled = filled + 1
         text(filled:filled) = line(i:i)
      end do
      number = number + 1
      texts(number)%text = text(:filled)
      texts = texts(:number)
   end subroutine csv_texts

   !> Whether a line breaks off within quotes: its row goes on in the next one.
   pure function ends_in_quotes(line) result(open)
      character(*), intent(in) :: line
      logical :: open
      integer :: i
      open = modulo(count([(line(i:i) == quote, i=1, len(line))]), 2) == 1
   end function ends_in_quotes

   !> Where the columns of those names stand in a file with that header; 0 where it has none.
   pure function columns_in(header, columns, units) result(places)
      type(text_type), intent(in) :: header(:)
      type(column_type), intent(in) :: columns(:)
      type(unit_system_type), intent(in) :: units
      integer :: places(size(columns))
      integer :: i, j
      places = 0
      do i = 1, size(columns)
         do j = 1, size(header)
            if (header(j)%text == column_header(columns(i), units)) places(i) = j
         end do
      end do
   end function columns_in

   !> A row with a value for each column, in SI units; an empty text is no value.
   pure subroutine read_csv_row(texts, places, columns, units, row)
      type(text_type), intent(in) :: texts(:)
      integer, intent(in) :: places(:)               !< of columns_in
      type(column_type), intent(in) :: columns(:)    !< as many
      type(unit_system_type), intent(in) :: units    !< of the file
      type(field_list_type), intent(out) :: row
      integer :: i, status
      real(wp) :: value
      do i = 1, size(columns)
         if (places(i) < 1 .or. places(i) > size(texts)) then
            call put_none(row)
            cycle
         end if
         associate (text => texts(places(i))%text)
            if (text == '') then
               call put_none(row)
            else if (columns(i)%quantity == quantity_text) then
               call put(row, text)
            else
               read (text, *, iostat=status) value
               if (status /= 0) then
                  call put_none(row)
               else if (columns(i)%quantity == quantity_none .and. verify(text, '-0123456789') == 0) then
                  call put(row, nint(value))
               else
                  call put(row, value*unit_size(columns(i)%quantity, units))
               end if
            end if
         end associate
      end do
   end subroutine read_csv_row
end module dg_csv_reading
