!> Memory of this process, as Linux tells it.
module dg_process_memory
   use, intrinsic :: iso_c_binding, only: c_int, c_size_t
   use dg_kinds, only: wp
   implicit none
   private
   public :: memory_now, memory_peak, forget_memory_peak, keep_freed_memory

   !> Where Linux tells of a process, and where it takes the wish to forget its peak (proc(5)).
   character(*), parameter :: status_file = '/proc/self/status', wish_file = '/proc/self/clear_refs'
   character, parameter :: forget_peak = '5'
   real(wp), parameter :: kilobyte = 1024.0_wp
   !> Parameters of mallopt(3), and what they are set to [bytes]: free memory is kept up to the first size, and pieces up to
   !> the second, the greatest that the library takes, come from it.
   integer(c_int), parameter :: trim_threshold = -1_c_int, map_threshold = -3_c_int
   integer(c_int), parameter :: kept = 268435456_c_int, greatest_piece = 33554432_c_int

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
   end interface

contains

   !> Keeps what is freed for the next solution, instead of giving it back to the system and asking for it again, page by page:
   !> a tenth of the time of short cases.
   subroutine keep_freed_memory()
      integer(c_int) :: done
      done = c_mallopt(map_threshold, greatest_piece)
      if (done /= 0) done = c_mallopt(trim_threshold, kept)
   end subroutine keep_freed_memory

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
