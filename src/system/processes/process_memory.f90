!> Memory of this process, as Linux tells it.
module dg_process_memory
   use, intrinsic :: iso_c_binding, only: c_int, c_long, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   implicit none
   private
   public :: memory_now, memory_peak, memory_of_machine, address_room, forget_memory_peak, keep_freed_memory

   !> Where Linux tells of a process, and where it takes the wish to forget its peak (proc(5)).
   character(*), parameter :: status_file = '/proc/self/status', wish_file = '/proc/self/clear_refs'
   character, parameter :: forget_peak = '5'
   real(wp), parameter :: kilobyte = 1024.0_wp
   !> Parameters of mallopt(3), and their values [bytes]. Free memory is kept up to the first size. Pieces up to the second,
   !> the greatest that the library allows, come from it.
   integer(c_int), parameter :: trim_threshold = -1_c_int, map_threshold = -3_c_int
   integer(c_int), parameter :: kept = 268435456_c_int, greatest_piece = 33554432_c_int
   !> Heaps of the library; each that a thread has of its own reserves addresses, 128 MB at first.
   integer(c_int), parameter :: most_heaps = -8_c_int
   ! Numbers of Linux: of sysconf, and of the address space in getrlimit.
   integer(c_int), parameter :: page_size = 30_c_int, physical_pages = 85_c_int, address_space = 9_c_int
   !> Where a container's limit stands, if it has one.
   character(*), parameter :: container_limit = '/sys/fs/cgroup/memory.max'

   interface
      !> Gives free memory back to the system (GNU C library).
      function c_malloc_trim(kept) result(given) bind(c, name='malloc_trim')
         import :: c_int, c_size_t
         implicit none
         integer(c_size_t), value :: kept
         integer(c_int) :: given
      end function c_malloc_trim

      !> Sets a parameter of the allocation of memory (GNU C library).
      function c_mallopt(parameter_number, setting) result(done) bind(c, name='mallopt')
         import :: c_int
         implicit none
         integer(c_int), value :: parameter_number, setting
         integer(c_int) :: done
      end function c_mallopt

      function c_sysconf(name) result(value) bind(c, name='sysconf')
         import :: c_int, c_long
         implicit none
         integer(c_int), value :: name
         integer(c_long) :: value
      end function c_sysconf

      ! rlim_t is unsigned long on Linux; RLIM_INFINITY is -1 here
      function c_getrlimit(resource, limits) result(status) bind(c, name='getrlimit')
         import :: c_int, c_long
         implicit none
         integer(c_int), value :: resource
         integer(c_long), intent(out) :: limits(2)
         integer(c_int) :: status
      end function c_getrlimit
   end interface

contains

   !> Keep freed memory for the next solution. Giving it back to the system and requesting it again, page by page, takes a
   !> tenth of the time of short cases. If addresses are limited threads share one heap.
   subroutine keep_freed_memory()
      integer(c_int) :: done
      done = c_mallopt(map_threshold, greatest_piece)
      if (done /= 0) done = c_mallopt(trim_threshold, kept)
      if (address_room() < huge(1.0_wp)) done = c_mallopt(most_heaps, 1_c_int)
   end subroutine keep_freed_memory

   !> Memory that the shell still allows this process (ulimit -v) [bytes]; huge without a limit, so that allocations do not
   !> fail.
   function address_room() result(bytes)
      real(wp) :: bytes
      integer(c_long) :: limits(2)
      bytes = huge(bytes)
      if (c_getrlimit(address_space, limits) /= 0_c_int) return
      if (limits(1) >= 0) bytes = real(limits(1), wp) - told('VmSize:')
   end function address_room

   !> Memory of the machine [bytes], less where a container allows less.
   function memory_of_machine() result(bytes)
      real(wp) :: bytes
      integer(int64) :: number
      integer :: unit, status
      bytes = real(c_sysconf(page_size), wp)*real(c_sysconf(physical_pages), wp)
      open (newunit=unit, file=container_limit, status='old', action='read', iostat=status)
      if (status /= 0) return
      read (unit, *, iostat=status) number       ! or 'max'
      if (status == 0) bytes = min(bytes, real(number, wp))
      close (unit)
   end function memory_of_machine

   !> Memory in use now [bytes]; 0 where the system does not tell.
   function memory_now() result(bytes)
      real(wp) :: bytes
      bytes = told('VmRSS:')
   end function memory_now

   !> Greatest memory in use [bytes] since forget_memory_peak, or ever; 0 where the system does not tell.
   function memory_peak() result(bytes)
      real(wp) :: bytes
      bytes = told('VmHWM:')
   end function memory_peak

   !> Gives back what is free and lets the peak begin anew. done: the system does so.
   subroutine forget_memory_peak(done)
      logical, intent(out) :: done
      integer :: unit, status
      integer(c_int) :: given
      given = c_malloc_trim(0_c_size_t)
      done = given >= 0
      open (newunit=unit, file=wish_file, action='write', status='old', iostat=status)
      if (status /= 0) then
         done = .false.
         return
      end if
      write (unit, '(a)', iostat=status) forget_peak
      if (status /= 0) done = .false.
      close (unit, iostat=status)
      if (status /= 0) done = .false.
   end subroutine forget_memory_peak

   !> A line 'key  number kB' of the system's report [bytes]; 0 where there is none.
   function told(key) result(bytes)
      character(*), intent(in) :: key
      real(wp) :: bytes
      character(256) :: line
      integer :: unit, status
      bytes = 0.0_wp
      open (newunit=unit, file=status_file, action='read', status='old', iostat=status)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (index(line, key) /= 1) cycle
         read (line(len(key) + 1:), *, iostat=status) bytes
         if (status /= 0) bytes = 0.0_wp
         bytes = kilobyte*bytes
         exit
      end do
      close (unit)
   end function told
end module dg_process_memory
