!> Texts as JSON has them (RFC 8259), fit to stand in a page: no '<' in them.
module dg_json_text
   use dg_text, only: plain_utf8, put_piece
   implicit none
   private
   public :: json_string

   integer, parameter :: last_control = 31

contains

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
      call put_piece(room, filled, '"')
      do i = 1, len(text)
         if (scan(plain(i:i), '"\') == 1) then
            call put_piece(room, filled, '\'//plain(i:i))
         else if (scan(plain(i:i), '<>&') == 1 .or. iachar(plain(i:i)) <= last_control) then
            write (code, '(a, z4.4)') '\u', iachar(plain(i:i))
            call put_piece(room, filled, code)
         else
            call put_piece(room, filled, plain(i:i))
         end if
      end do
      call put_piece(room, filled, '"')
      json = room(:filled)
   end function json_string
end module dg_json_text
