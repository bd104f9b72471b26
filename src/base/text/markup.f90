!> Texts within HTML and XML.
module dg_markup
   use dg_text, only: plain_utf8, append_piece
   implicit none
   private
   public :: html_safe

contains

   !> Text for HTML or XML. Control bytes become blanks, and invalid bytes of UTF-8 become '?'. It is filled piece by piece. A
   !> deck may have lines of a hundred kilobytes, and a text that grows by bytes takes the square of its length.
   pure function html_safe(text) result(safe)
      character(*), intent(in) :: text
      character(:), allocatable :: safe
      character(:), allocatable :: room
      character(len(text)) :: plain
      integer, parameter :: longest = 6     ! letters that stand for one: &quot;
      integer :: i, filled
      plain = plain_utf8(text)
      allocate (character(longest*len(text)) :: room)
      filled = 0
      do i = 1, len(text)
         select case (plain(i:i))
         case ('&'); call append_piece(room, filled, '&amp;')
         case ('<'); call append_piece(room, filled, '&lt;')
         case ('>'); call append_piece(room, filled, '&gt;')
         case ('"'); call append_piece(room, filled, '&quot;')
         case default; call append_piece(room, filled, plain(i:i))
         end select
      end do
      safe = room(:filled)
   end function html_safe
end module dg_markup
