!> Numbers and logicals as a namelist writes them. Read with rules of our own, because a processor's
!> list-directed read takes more than it should (1*, infinities) and says less than a user needs.
module dg_deck_number
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_text, only: lower_case
   implicit none
   private
   public :: read_real, read_integer, read_logical, read_fraction

   character(*), parameter :: digits = '0123456789'

contains

   !> A real as Fortran writes one: 1, -1.5, .5, 5., 1e3, 1.5d-3. Infinities and what overflows are none.
   pure subroutine read_real(text, number, legal)
      character(*), intent(in) :: text
      real(wp), intent(out) :: number
      logical, intent(out) :: legal
      integer :: at, whole, part, status, exponent
      !> Beyond this a decimal exponent does not fit a double with any sensible mantissa.
      integer, parameter :: greatest_exponent = 290
      integer, parameter :: longest_number = 40
      call read_plain(text, number, legal)
      if (legal) return
      number = 0.0_wp
      if (len(text) == 0 .or. len(text) > longest_number) return
      at = 1
      if (scan(text(1:1), '+-') == 1) at = 2
      whole = verify(text(at:)//' ', digits) - 1
      at = at + whole
      part = 0
      if (at <= len(text)) then
         if (text(at:at) == '.') then
            part = verify(text(at + 1:)//' ', digits) - 1
            at = at + part + 1
         end if
      end if
      if (whole + part == 0) return
      exponent = 0
      if (at <= len(text)) then
         if (scan(text(at:at), 'eEdD') /= 1) return
         call read_integer(text(at + 1:), exponent, legal)
         if (.not. legal) return
      end if
      legal = abs(exponent) <= greatest_exponent
      if (.not. legal) return
      read (text, *, iostat=status) number
      legal = status == 0
   end subroutine read_real

   !> Digits with at most one point, few enough that both the digits as a whole number and the power of ten below them are
   !> doubles without round-off: their quotient is then rounded once, as the processor rounds (Clinger 1990), in a tenth of
   !> the time. Anything else is not `legal` here.
   pure subroutine read_plain(text, number, legal)
      character(*), intent(in) :: text
      real(wp), intent(out) :: number
      logical, intent(out) :: legal
      integer, parameter :: most_digits = 15
      real(wp), parameter :: power(0:most_digits) = [1e0_wp, 1e1_wp, 1e2_wp, 1e3_wp, 1e4_wp, 1e5_wp, 1e6_wp, 1e7_wp, 1e8_wp, &
                                                     1e9_wp, 1e10_wp, 1e11_wp, 1e12_wp, 1e13_wp, 1e14_wp, 1e15_wp]
      integer, parameter :: ten = 10, zero = iachar('0')
      integer(int64) :: whole
      integer :: i, first, found, below
      number = 0.0_wp
      legal = .false.
      first = 1
      if (len(text) > 0) then
         if (text(1:1) == '-' .or. text(1:1) == '+') first = 2
      end if
      whole = 0
      found = 0
      below = -1
      do i = first, len(text)
         if (text(i:i) >= '0' .and. text(i:i) <= '9') then
            found = found + 1
            if (found > most_digits) return
            whole = whole*ten + (iachar(text(i:i)) - zero)
            if (below >= 0) below = below + 1
         else if (text(i:i) == '.' .and. below < 0) then
            below = 0
         else
            return
         end if
      end do
      if (found == 0) return
      legal = .true.
      number = real(whole, wp)/power(max(below, 0))
      if (text(1:1) == '-') number = -number
   end subroutine read_plain

   !> A whole number of at most nine digits.
   pure subroutine read_integer(text, number, legal)
      character(*), intent(in) :: text
      integer, intent(out) :: number
      logical, intent(out) :: legal
      integer, parameter :: longest = 9
      integer :: first
      number = 0
      legal = len(text) > 0
      if (.not. legal) return
      first = merge(2, 1, scan(text(1:1), '+-') == 1)
      legal = len(text) >= first .and. len(text) - first < longest .and. verify(text(first:), digits) == 0
      if (legal) read (text, *) number
   end subroutine read_integer

   !> .true., .t., true, t and the like, letter case aside.
   pure subroutine read_logical(text, flag, legal)
      character(*), intent(in) :: text
      logical, intent(inout) :: flag         !< stays where the text is none
      logical, intent(out) :: legal
      legal = .true.
      select case (lower_case(text))
      case ('.true.', 'true', '.t.', 't'); flag = .true.
      case ('.false.', 'false', '.f.', 'f'); flag = .false.
      case default; legal = .false.
      end select
   end subroutine read_logical

   !> A mixed fraction, 8-1/2 or 8 1/2, or one alone, 1/2.
   pure subroutine read_fraction(text, number, legal)
      character(*), intent(in) :: text
      real(wp), intent(out) :: number
      logical, intent(out) :: legal
      real(wp) :: above, below
      integer :: slash, gap
      number = 0.0_wp
      slash = index(text, '/')
      legal = slash > 1 .and. slash < len(text)
      if (.not. legal) return
      gap = scan(text(:slash), '- ', back=.true.)
      legal = all_digits(text(gap + 1:slash - 1)) .and. all_digits(text(slash + 1:))
      if (legal .and. gap > 0) legal = all_digits(text(:gap - 1))
      if (.not. legal) return
      if (gap > 0) call read_real(text(:gap - 1), number, legal)
      call read_real(text(gap + 1:slash - 1), above, legal)
      call read_real(text(slash + 1:), below, legal)
      legal = below > 0.0_wp
      if (legal) number = number + above/below
   end subroutine read_fraction

   !> True for a text of digits alone.
   pure function all_digits(text) result(are)
      character(*), intent(in) :: text
      logical :: are
      are = len(text) > 0 .and. verify(text, '0123456789') == 0
   end function all_digits
end module dg_deck_number
