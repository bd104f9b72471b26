!> Texts within HTML and XML.
module dg_markup
   use dg_text, only: plain_utf8, put_piece
   implicit none
   private
   public :: html_safe

contains

   !> A text as HTML or XML shows it. Control bytes become blanks; bytes that make no UTF-8 become '?'. Put in place piece by piece:
   !> lines of a hundred kilobytes are legal in a deck, and a text that grows by a byte at a time takes the square of its length.
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
         case ('&'); call put_piece(room, filled, '&amp;')
         case ('<'); call put_piece(room, filled, '&lt;')
         case ('>'); call put_piece(room, filled, '&gt;')
         case ('"'); call put_piece(room, filled, '&quot;')
         case default; call put_piece(room, filled, plain(i:i))
         end select
      end do
      safe = room(:filled)
   end function html_safe
end module dg_markup
