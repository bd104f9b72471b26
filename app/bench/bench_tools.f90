!> Clock, median and the name of the machine.
module dg_bench_tools
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   implicit none
   private
   public :: machine_name, median, now

contains

   !> Seconds of processor time of this process: unlike wall time not lengthened by what else the machine does.
   function now() result(seconds)
      real(wp) :: seconds
      call cpu_time(seconds)
   end function now

   !> Median of some numbers.
   pure function median(values) result(middle)
      real(wp), intent(in) :: values(:)
      real(wp) :: middle
      real(wp) :: sorted(size(values))
      integer :: n
      n = size(values)
      sorted = values(sorted_places(values))
      middle = 0.5_wp*(sorted((n + 1)/2) + sorted(n/2 + 1))
   end function median

   !> Processor as Linux names it, '' elsewhere.
   function machine_name() result(name)
      character(:), allocatable :: name
      name = field_of('/proc/cpuinfo', 'model name')
   end function machine_name

   !> Text behind the colon of the first line that begins with `key`.
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
