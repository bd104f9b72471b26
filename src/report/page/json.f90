!> Texts of the page's data, which is JSON within an element of HTML.
module dg_json
   use dg_quantity, only: quantity_force, quantity_length, quantity_width
   use dg_text, only: plain_utf8, append_piece, to_text
   implicit none
   private
   public :: json_string, quantity_key

   integer, parameter :: last_control = 31

contains

   !> Name of a quantity in the data: words for those that the script asks for.
   pure function quantity_key(quantity) result(key)
      integer, intent(in) :: quantity
      character(:), allocatable :: key
      select case (quantity)
      case (quantity_length); key = 'length'
      case (quantity_width); key = 'width'
      case (quantity_force); key = 'force'
      case default; key = 'q'//to_text(quantity)
      end select
   end function quantity_key

   !> A text with its quotes. Bytes that make no UTF-8 become '?'. Put in place piece by piece, as html_safe does.
   pure function json_string(text) result(json)
      character(*), intent(in) :: text
      character(:), allocatable :: json
      character(:), allocatable :: room
      character(len(text)) :: plain
      character(6) :: code
      integer :: i, filled
      plain = plain_utf8(text)
      allocate (character(len(code)*len(text) + 2) :: room)
      filled = 0
      call append_piece(room, filled, '"')
      do i = 1, len(text)
         if (scan(plain(i:i), '"\') == 1) then
            call append_piece(room, filled, '\'//plain(i:i))
         else if (scan(plain(i:i), '<>&') == 1 .or. iachar(plain(i:i)) <= last_control) then
            write (code, '(a, z4.4)') '\u', iachar(plain(i:i))
            call append_piece(room, filled, code)
         else
            call append_piece(room, filled, plain(i:i))
         end if
      end do
      call append_piece(room, filled, '"')
      json = room(:filled)
   end function json_string
end module dg_json
