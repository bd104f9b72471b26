!> Texts and numbers as JSON has them (RFC 8259), fit to stand in a page: no '<' in them.
module dg_json_text
   use dg_kinds, only: wp
   use dg_text, only: plain_utf8, to_text
   implicit none
   private
   public :: json_string, json_number

   integer, parameter :: last_control = 31

contains

   !> A text with its quotes. Bytes that make no UTF-8 become '?'.
   pure function json_string(text) result(json)
      character(*), intent(in) :: text
      character(:), allocatable :: json
      character(len(text)) :: plain
      character(6) :: code
      integer :: i
      plain = plain_utf8(text)
      json = '"'
      do i = 1, len(text)
         select case (plain(i:i))
         case ('"', '\')
            json = json//'\'//plain(i:i)
         case ('<', '>', '&')
            write (code, '(a, z4.4)') '\u', iachar(plain(i:i))
            json = json//code
         case default
            if (iachar(plain(i:i)) <= last_control) then
               write (code, '(a, z4.4)') '\u', iachar(plain(i:i))
               json = json//code
            else
               json = json//plain(i:i)
            end if
         end select
      end do
      json = json//'"'
   end function json_string

   !> A finite number to so many digits.
   pure function json_number(number, digits) result(json)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      character(:), allocatable :: json
      json = to_text(number, digits)
   end function json_number
end module dg_json_text
