!> Texts of users as a terminal may get them.
module dg_printable
   implicit none
   private
   public :: printable, turning_code

   character, parameter :: stand_in = '?'
   !> Bytes of ASCII that command a terminal instead of being shown: below the blank, and DEL.
   integer, parameter :: first_shown = 32, delete = 127
   !> Commands of eight bits (ISO 6429, C1): bare in 8-bit texts, after the byte 194 in UTF-8.
   integer, parameter :: first_command = 128, last_command = 159, lead_of_commands = 194
   !> Range of the bytes that follow the first byte of a letter in UTF-8 (RFC 3629).
   integer, parameter :: first_follower = 128, last_follower = 191
   !> Letters that turn the direction of writing (Unicode, UAX #9), in UTF-8, and their numbers.
   character(*), parameter :: turning(12) = [character(3) :: char(216)//char(156), &
      char(226)//char(128)//char(142), char(226)//char(128)//char(143), char(226)//char(128)//char(170), &
      char(226)//char(128)//char(171), char(226)//char(128)//char(172), char(226)//char(128)//char(173), &
      char(226)//char(128)//char(174), char(226)//char(129)//char(166), char(226)//char(129)//char(167), &
      char(226)//char(129)//char(168), char(226)//char(129)//char(169)]
   character(4), parameter :: turning_number(12) = ['061C', '200E', '200F', '202A', '202B', '202C', '202D', '202E', '2066', &
      '2067', '2068', '2069']

contains

   !> `text` with every control byte and every letter that turns the direction of writing replaced by '?', at the same length.
   !> Bytes in `kept` and other letters, in UTF-8 and in Latin-1, stay.
   pure function printable(text, kept) result(shown)
      character(*), intent(in) :: text
      character(*), intent(in) :: kept      !< such as a tab; may be ''
      character(len(text)) :: shown
      integer :: i, length
      shown = text
      i = 1
      do while (i <= len(text))
         length = letter_length(text(i:))
         if (length > 1) then
            if (iachar(text(i:i)) == lead_of_commands .and. iachar(text(i + 1:i + 1)) <= last_command) &
               shown(i:i + 1) = stand_in//stand_in
            if (turning_code(text(i:i + length - 1)) /= '') shown(i:i + length - 1) = repeat(stand_in, length)
         else if (is_command(iachar(text(i:i))) .and. index(kept, text(i:i)) == 0) then
            shown(i:i) = stand_in
         end if
         i = i + length
      end do
   end function printable

   !> Number of a letter that turns the direction of writing, as Unicode gives it: '202E'; '' for any other letter.
   pure function turning_code(letter) result(code)
      character(*), intent(in) :: letter
      character(4) :: code
      integer :: i
      code = ''
      do i = 1, size(turning)
         if (letter == turning(i)) code = turning_number(i)
      end do
   end function turning_code

   pure function is_command(code) result(is)
      integer, intent(in) :: code
      logical :: is
      is = code < first_shown .or. code == delete .or. (code >= first_command .and. code <= last_command)
   end function is_command

   !> Bytes of the letter with which a text begins: more than one where it is a letter in UTF-8.
   pure function letter_length(text) result(length)
      character(*), intent(in) :: text      !< not empty
      integer :: length
      integer :: i
      select case (iachar(text(1:1)))
      case (194:223); length = 2
      case (224:239); length = 3
      case (240:244); length = 4
      case default; length = 1
      end select
      if (length > len(text)) length = 1
      do i = 2, length
         if (iachar(text(i:i)) >= first_follower .and. iachar(text(i:i)) <= last_follower) cycle
         length = 1
         return
      end do
   end function letter_length
end module dg_printable
