!> Random numbers that depend on their place of use, not on earlier numbers: Philox 4x32-10. The method is by Salmon, Moraes,
!> Dror & Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011). The same seed, sample, quantity and index give the
!> same number in any order. This holds on any number of threads, and in any part of a divided run.
module dg_counter_random
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_constants, only: pi
   implicit none
   private
   public :: philox, normal_number, uniform_number

   !> Multipliers and increments of the key (table 2 and section 3.3 there).
   integer(int64), parameter :: multiplier(2) = [int(z'D2511F53', int64), int(z'CD9E8D57', int64)]
   integer(int64), parameter :: key_step(2) = [int(z'9E3779B9', int64), int(z'BB67AE85', int64)]
   integer, parameter :: rounds = 10
   integer(int64), parameter :: word = int(z'FFFFFFFF', int64), half_word = int(z'FFFF', int64)
   integer, parameter :: word_bits = 32, half_bits = 16
   !> Bits of the two words that make one number of 53 bits.
   integer, parameter :: high_bits = 27, low_bits = 26

contains

   !> Four words of 32 bits from a counter and a key, each word in the lower half of a 64-bit integer.
   pure function philox(counter, key) result(words)
      integer(int64), intent(in) :: counter(4)
      integer(int64), intent(in) :: key(2)
      integer(int64) :: words(4)
      integer(int64) :: keys(2), high(2), low(2)
      integer :: i
      words = counter
      keys = key
      do i = 1, rounds
         call multiply(multiplier, words([1, 3]), high, low)
         words = [ieor(ieor(high(2), words(2)), keys(1)), low(2), ieor(ieor(high(1), words(4)), keys(2)), low(1)]
         keys = iand(keys + key_step, word)
      end do
   end function philox

   !> Product of two words as two words. By halves: the whole would not fit a signed integer.
   elemental subroutine multiply(a, b, high, low)
      integer(int64), intent(in) :: a, b
      integer(int64), intent(out) :: high, low
      integer(int64) :: lower, upper
      lower = a*iand(b, half_word)
      upper = a*ishft(b, -half_bits)
      lower = lower + ishft(iand(upper, half_word), half_bits)
      low = iand(lower, word)
      high = ishft(upper, -half_bits) + ishft(lower, -word_bits)
   end subroutine multiply

   !> A number of the standard normal distribution (Box & Muller 1958), for a quantity and an index within it.
   elemental function normal_number(seed, sample, quantity, index) result(number)
      integer, intent(in) :: seed, sample, quantity, index     !< all >= 0
      real(wp) :: number
      integer(int64) :: words(4)
      words = philox([int(index, int64), int(sample, int64), int(quantity, int64), 0_int64], [int(seed, int64), 0_int64])
      number = sqrt(-2.0_wp*log(uniform(words(1), words(2))))*cos(2.0_wp*pi*uniform(words(3), words(4)))
   end function normal_number

   !> A number evenly distributed between 0 and 1, for a quantity and an index within it.
   elemental function uniform_number(seed, sample, quantity, index) result(number)
      integer, intent(in) :: seed, sample, quantity, index     !< all >= 0
      real(wp) :: number
      integer(int64) :: words(4)
      words = philox([int(index, int64), int(sample, int64), int(quantity, int64), 1_int64], [int(seed, int64), 0_int64])
      number = uniform(words(1), words(2))
   end function uniform_number

   !> A number strictly between 0 and 1, in steps of 2^-53.
   elemental function uniform(high, low) result(number)
      integer(int64), intent(in) :: high, low
      real(wp) :: number
      number = (real(ishft(high, high_bits - word_bits), wp)*2.0_wp**low_bits + real(ishft(low, low_bits - word_bits), wp) &
                + 0.5_wp)*2.0_wp**(-high_bits - low_bits)
      number = min(number, 1.0_wp - epsilon(number))      ! the last half step rounds up
   end function uniform
end module dg_counter_random
