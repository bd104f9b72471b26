!> Numbers and logicals as a namelist writes them. They are not read list-directed, because that accepts too much (1*,
!> infinities) and explains too little.
module dg_deck_number
   use dg_kinds, only: wp
   use dg_text, only: lower_case
   implicit none
   private
   public :: is_number, read_real, read_integer, read_logical, read_fraction

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
      number = 0.0_wp
      legal = .false.
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

   !> True if a text is a real.
   pure function is_number(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      real(wp) :: number
      call read_real(text, number, is)
   end function is_number

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
      are = len(text) > 0 .and. verify(text, digits) == 0
   end function all_digits
end module dg_deck_number
