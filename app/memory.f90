!> Whether the machine has the memory that a deck asks for: told before anything is begun, not by the system's killing the
!> program in the middle of it.
module dg_memory
   use, intrinsic :: iso_c_binding, only: c_int, c_long
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_error, only: error_type, raise, status_bad_input
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_text, only: quoted, to_text
   use dg_threads, only: thread_count
   implicit none
   private
   public :: check_memory

   !> What a case takes while it is solved, and what its result and the files of it keep, an element [bytes]: 5.4 kB in all
   !> were seen with 100 000 elements.
   real(wp), parameter :: bytes_solving = 5.0e3_wp, bytes_kept = 1.0e3_wp
   real(wp), parameter :: gigabyte = 1.0e9_wp
   integer, parameter :: digits = 3
   ! Numbers of Linux: of sysconf, and of the address space in getrlimit.
   integer(c_int), parameter :: page_size = 30_c_int, physical_pages = 85_c_int, address_space = 9_c_int
   !> Where a container's limit stands, if it has one.
   character(*), parameter :: container_limit = '/sys/fs/cgroup/memory.max'

   interface
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

   !> Bad input where the cases need more memory than the machine has. The need is a lower bound: elements may be cut finer
   !> than asked for, and no model but mcge needs as much.
   subroutine check_memory(job, model, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: elements(size(model%cases)), need, there
      integer :: longest, models
      if (size(model%cases) == 0) return      ! sweeps alone: their elements are long
      models = size(job%models)
      elements = model%cases%bit_depth/model%numerics%element_length
      longest = maxloc(elements, 1)
      need = bytes_solving*elements(longest)*thread_count(job%threads, models*size(elements)) + bytes_kept*models*sum(elements)
      there = memory_there()
      if (need > there) call raise(error, status_bad_input, job%deck_path//': group &solver: elements of '// &
         to_text(model%numerics%element_length, digits)//' m, '//to_text(elements(longest), digits)//' of them in case '// &
         quoted(model%cases(longest)%name)//', need '//to_text(need/gigabyte, digits)//' GB of memory, the machine has '// &
         to_text(there/gigabyte, digits)//'; give a larger element_length or fewer threads')
   end subroutine check_memory

   !> Memory that this process can have [bytes]: the machine's, less where its container or shell allows less.
   function memory_there() result(bytes)
      real(wp) :: bytes
      integer(c_long) :: limits(2)
      integer(int64) :: number
      integer :: unit, status
      bytes = real(c_sysconf(page_size), wp)*real(c_sysconf(physical_pages), wp)
      if (c_getrlimit(address_space, limits) == 0_c_int) then
         if (limits(1) > 0) bytes = min(bytes, real(limits(1), wp))
      end if
      open (newunit=unit, file=container_limit, status='old', action='read', iostat=status)
      if (status /= 0) return
      read (unit, *, iostat=status) number       ! or 'max'
      if (status == 0) bytes = min(bytes, real(number, wp))
      close (unit)
   end function memory_there
end module dg_memory
