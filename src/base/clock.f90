!> The clock on the wall.
module dg_clock
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   implicit none
   private
   public :: seconds_between

contains

   !> Wall time between two readings of system_clock [s].
   function seconds_between(from, to) result(seconds)
      integer(int64), intent(in) :: from, to     !< ticks
      real(wp) :: seconds
      integer(int64) :: rate
      call system_clock(count_rate=rate)
      seconds = real(to - from, wp)/real(rate, wp)
   end function seconds_between
end module dg_clock
