!> Clock, median and the name of the machine.
module dg_bench_tools
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   implicit none
   private
   public :: machine_name, median, now, memory

contains

   !> Seconds on a clock that only goes forward.
   function now() result(seconds)
      real(wp) :: seconds
      integer(int64) :: ticks, rate
      call system_clock(ticks, rate)
      seconds = real(ticks, wp)/real(rate, wp)
   end function now

   !> Median of some numbers.
   pure function median(values) result(middle)
      real(wp), intent(in) :: values(:)
      real(wp) :: middle
      real(wp) :: sorted(size(values)), value
      integer :: i, j, n
      n = size(values)
      sorted = values
      do i = 2, n
         value = sorted(i)
         do j = i - 1, 1, -1
            if (sorted(j) <= value) exit
            sorted(j + 1) = sorted(j)
         end do
         sorted(j + 1) = value
      end do
      middle = 0.5_wp*(sorted((n + 1)/2) + sorted(n/2 + 1))
   end function median

   !> Processor as Linux names it, '' elsewhere.
   function machine_name() result(name)
      character(:), allocatable :: name
      name = field_of('/proc/cpuinfo', 'model name')
   end function machine_name

   !> Memory of this process now [bytes], 0 where the system does not tell.
   function memory() result(bytes)
      real(wp) :: bytes
      character(:), allocatable :: text
      integer :: status
      text = field_of('/proc/self/status', 'VmRSS')
      bytes = 0.0_wp
      if (len(text) > 2) then
         read (text(:len(text) - 2), *, iostat=status) bytes     ! ends in 'kB'
         if (status /= 0) bytes = 0.0_wp
      end if
      bytes = 1024.0_wp*bytes
   end function memory

   !> What stands behind the colon of the first line that begins with `key`.
   function field_of(path, key) result(text)
      character(*), intent(in) :: path, key
      character(:), allocatable :: text
      character(256) :: line
      integer :: unit, status
      text = ''
      open (newunit=unit, file=path, action='read', iostat=status)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (index(line, key) /= 1) cycle
         text = trim(adjustl(line(index(line, ':') + 1:)))
         exit
      end do
      close (unit)
   end function field_of
end module dg_bench_tools
