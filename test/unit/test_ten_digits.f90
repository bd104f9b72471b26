!> Numbers as text of ten digits against what the run-time library writes, letter by letter.
module dg_test_ten_digits
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_ten_digits, only: longest_number, append_ten_digits
   implicit none
   private
   public :: ten_digits_suite

   !> Number of compared values, number that differed, and the first that did.
   type :: tally_type
      integer :: compared = 0
      integer :: different = 0
      character(80) :: first = ''
   end type tally_type

   !> Largest finite number, by its bits.
   integer(int64), parameter :: largest = int(z'7FEFFFFFFFFFFFFF', int64)

contains

   function ten_digits_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('ten_digits')
      call suite%addTest(TestMethod('any_bits', test_any_bits))
      call suite%addTest(TestMethod('sizes_of_results', test_sizes_of_results))
      call suite%addTest(TestMethod('decimal_ties', test_decimal_ties))
      call suite%addTest(TestMethod('short_decimals', test_short_decimals))
      call suite%addTest(TestMethod('powers_of_ten', test_powers_of_ten))
      call suite%addTest(TestMethod('whole_numbers', test_whole_numbers))
      call suite%addTest(TestMethod('ends_of_range', test_ends_of_range))
      call suite%addTest(TestMethod('behind_other_letters', test_behind_other_letters))
   end function ten_digits_suite

   !> Every pattern of bits is as likely as any other: all exponents, infinite numbers and NaN among them.
   subroutine test_any_bits()
      type(tally_type) :: tally
      integer(int64) :: state
      integer :: i
      state = 88172645463325252_int64
      do i = 1, 100000
         call next(state)
         call compare(transfer(quiet(state), 1.0_wp), tally)
      end do
      call judge(tally, 100000)
   end subroutine test_any_bits

   !> From 1e-25 to 1e25, as results are.
   subroutine test_sizes_of_results()
      type(tally_type) :: tally
      integer(int64) :: state
      real(wp) :: x
      integer :: i
      state = 2463534242_int64
      do i = 1, 100000
         x = uniform(state)
         call compare(sign(10.0_wp**(50.0_wp*abs(x) - 25.0_wp), x), tally)
      end do
      call judge(tally, 100000)
   end subroutine test_sizes_of_results

   !> Eleven digits, the last of them 5, at any place of the point; and the numbers next to each. Some are exact halves.
   subroutine test_decimal_ties()
      type(tally_type) :: tally
      integer(int64) :: state
      real(wp) :: x
      integer :: i, power
      state = 362436069_int64
      do i = 1, 20000
         x = aint(1.0e9_wp + 9.0e9_wp*abs(uniform(state))) + 0.5_wp
         power = modulo(i, 81) - 40
         if (power > 0) x = x*10.0_wp**power
         if (power < 0) x = x/10.0_wp**(-power)
         call compare(x, tally)
         call compare_neighbours(x, 1, tally)
      end do
      call judge(tally, 60000)
   end subroutine test_decimal_ties

   !> A few digits, as decks have them.
   subroutine test_short_decimals()
      type(tally_type) :: tally
      integer :: i, power
      do power = 1, 5
         do i = 1, 4000
            call compare(real(i, wp)/10.0_wp**power, tally)
         end do
      end do
      call judge(tally, 20000)
   end subroutine test_short_decimals

   !> Every power of ten that a double can hold, with its neighbours; and numbers that ten digits round up to one.
   subroutine test_powers_of_ten()
      type(tally_type) :: tally
      real(wp) :: x
      integer :: power
      character(8) :: text
      do power = -323, 308
         write (text, '(a, i0)') '1e', power
         read (text, *) x
         call compare(x, tally)
         call compare_neighbours(x, 20, tally)
         call compare(x*(1.0_wp - 4.0e-11_wp), tally)
         call compare(x*(1.0_wp - 5.0e-11_wp), tally)
         call compare(x*(1.0_wp - 6.0e-11_wp), tally)
      end do
      call judge(tally, 27000)
   end subroutine test_powers_of_ten

   subroutine test_whole_numbers()
      type(tally_type) :: tally
      integer :: i
      do i = -5000, 5000
         call compare(real(i, wp), tally)
         call compare(1.0e10_wp + 5*i, tally)
      end do
      do i = -1074, 1023
         call compare(scale(1.0_wp, i), tally)
      end do
      call judge(tally, 22100)
   end subroutine test_whole_numbers

   !> Both zeros, the least and the greatest denormal and normal number, infinite ones and NaN.
   subroutine test_ends_of_range()
      integer(int64), parameter :: bits(7) = [0_int64, 1_int64, int(z'000FFFFFFFFFFFFF', int64), int(z'0010000000000000', int64), &
         largest, largest + 1, int(z'7FF8000000000000', int64)]
      type(tally_type) :: tally
      integer :: i
      do i = 1, size(bits)
         call compare(transfer(bits(i), 1.0_wp), tally)
         call compare(transfer(ibset(bits(i), 63), 1.0_wp), tally)
      end do
      call judge(tally, 14)
      call assertEqual('-0.1797693135E+309', text_of(-huge(1.0_wp)), message='none is longer')
   end subroutine test_ends_of_range

   subroutine test_behind_other_letters()
      character(30) :: row
      integer :: filled
      row = 'md,'
      filled = 3
      call append_ten_digits(row, filled, -12.5_wp)
      call assertEqual('md,-12.50000000', row(:filled))
      call assertTrue(row(filled + 1:) == '', message='nothing behind')
   end subroutine test_behind_other_letters

   function text_of(value) result(text)
      real(wp), intent(in) :: value
      character(:), allocatable :: text
      character(longest_number) :: buffer
      integer :: filled
      filled = 0
      call append_ten_digits(buffer, filled, value)
      text = buffer(:filled)
   end function text_of

   !> Compares the text of a number with that of the library.
   subroutine compare(value, tally)
      real(wp), intent(in) :: value
      type(tally_type), intent(inout) :: tally
      character(40) :: wanted
      character(:), allocatable :: found
      write (wanted, '(g0.10)') value
      found = text_of(value)
      tally%compared = tally%compared + 1
      if (found == wanted .and. len(found) == len_trim(wanted)) return
      tally%different = tally%different + 1
      if (tally%different == 1) tally%first = trim(wanted)//' became '//found
   end subroutine compare

   !> The numbers next to a positive one, so many on each side.
   subroutine compare_neighbours(value, many, tally)
      real(wp), intent(in) :: value
      integer, intent(in) :: many
      type(tally_type), intent(inout) :: tally
      integer(int64) :: bits
      integer :: i
      bits = transfer(value, bits)
      do i = 1, many
         if (bits + i <= largest) call compare(transfer(bits + i, value), tally)
         if (bits >= i) call compare(transfer(bits - i, value), tally)
      end do
   end subroutine compare_neighbours

   subroutine judge(tally, least)
      type(tally_type), intent(in) :: tally
      integer, intent(in) :: least     !< that must have been compared
      call assertEqual(0, tally%different, message=trim(tally%first))
      call assertTrue(tally%compared >= least, message='too few compared')
   end subroutine judge

   !> Bits of a number; those of a signalling NaN with its first digit set, since the library's own write would be trapped.
   pure function quiet(bits)
      integer(int64), intent(in) :: bits
      integer(int64) :: quiet
      quiet = bits
      if (ibclr(bits, 63) > largest + 1) quiet = ibset(bits, 51)
   end function quiet

   !> The next 64 bits (xorshift; Marsaglia 2003).
   subroutine next(state)
      integer(int64), intent(inout) :: state     !< not zero
      state = ieor(state, ishft(state, 13))
      state = ieor(state, ishft(state, -7))
      state = ieor(state, ishft(state, 17))
   end subroutine next

   !> A number between -1 and 1.
   function uniform(state) result(x)
      integer(int64), intent(inout) :: state
      real(wp) :: x
      call next(state)
      x = scale(real(state, wp), -63)
   end function uniform
end module dg_test_ten_digits
