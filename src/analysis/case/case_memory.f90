!> Memory that load cases need. It is checked before a run begins, so that the system does not end the program in the middle.
module dg_case_memory
   use dg_component, only: has_joints
   use dg_drillstring, only: component_tops
   use dg_error, only: error_type, raise, status_bad_input
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type, string_index
   use dg_text, only: quoted, to_text
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: need_type, add_cases, keep_larger, elements_in, finer_text, check_case_memory, gigabyte, memory_digits

   !> Memory of a case per element [bytes]: while it is solved, and of its result and files. Measured with 100 000 elements.
   real(wp), parameter :: bytes_solving = 5.0e3_wp, bytes_kept = 1.0e3_wp
   real(wp), parameter :: gigabyte = 1.0e9_wp
   !> Need below which the available memory is not checked, as the check takes time in a run of thousands of cases [bytes].
   real(wp), parameter :: surely_there = 1.0e8_wp
   !> Digits of a number in a message on memory.
   integer, parameter :: memory_digits = 3, digits = memory_digits
   !> Elements from one tool joint to the next where joints are discrete [-]. Then the part of an element's length within which
   !> stations are one node (dg_mesh) [-].
   real(wp), parameter :: elements_a_joint = 5.0_wp, merged_share = 1.0e-3_wp

   !> The greatest piece of work so far, and the memory that all results keep.
   type :: need_type
      real(wp) :: bytes = 0.0_wp           !< needed while it is solved [bytes]
      real(wp) :: kept = 0.0_wp            !< of all results [bytes]
      character(:), allocatable :: what
      character(:), allocatable :: remedy
      logical :: banded = .false.          !< true if the banded solver of LAPACK works in every thread
      logical :: fits = .false.            !< true if LAPACK fits least squares
   end type need_type

   abstract interface
      !> Available memory [bytes].
      function memory_interface() result(bytes)
         import :: wp
         implicit none
         real(wp) :: bytes
      end function memory_interface
   end interface

contains

   !> Raise an error (bad input) if the first load case of a model needs more memory than is available.
   subroutine check_case_memory(model, memory_there, error)
      type(model_type), intent(in) :: model
      procedure(memory_interface) :: memory_there
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: elements, wanted, room
      elements = elements_in(model, model%cases(1)%string, model%cases(1)%bit_depth, model%numerics%element_length)
      wanted = (bytes_solving + bytes_kept)*elements
      if (wanted < surely_there) return
      room = memory_there()
      if (wanted > room) call raise(error, status_bad_input, 'the case has '//to_text(elements, digits)//' elements and needs '// &
         to_text(wanted/gigabyte, digits)//' GB of memory, there are '//to_text(max(room, 0.0_wp)/gigabyte, digits)//'; give '// &
         finer_text(model, model%numerics%element_length))
   end subroutine check_case_memory

   !> Add the needs of load cases, one a model and case, and of calibrations.
   subroutine add_cases(job, model, threads, need)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: threads       !< number of cases that are solved at a time
      type(need_type), intent(inout) :: need
      real(wp) :: elements(size(model%cases))
      integer :: i
      if (size(model%cases) == 0) return
      elements = [(elements_in(model, model%cases(i)%string, model%cases(i)%bit_depth, model%numerics%element_length), &
                   i=1, size(model%cases))]
      if (job%parts == 0) need%kept = need%kept + bytes_kept*size(job%models)*sum(elements)
      i = maxloc(elements, 1)
      call keep_larger(need, elements(i), threads, &
                       'case '//quoted(model%cases(i)%name), finer_text(model, model%numerics%element_length))
   end subroutine add_cases

   !> Keep the work that needs most memory.
   subroutine keep_larger(need, elements, threads, what, remedy)
      type(need_type), intent(inout) :: need
      real(wp), intent(in) :: elements
      integer, intent(in) :: threads
      character(*), intent(in) :: what, remedy
      if (bytes_solving*elements*threads < need%bytes) return
      need%bytes = bytes_solving*elements*threads
      need%what = what//', '//to_text(elements, digits)//' elements'
      need%remedy = remedy
      if (threads > 1) need%remedy = remedy//' or fewer threads'
   end subroutine keep_larger

   !> Settings that reduce the number of elements, in words.
   function finer_text(model, element_length) result(text)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: element_length   !< [m]
      character(:), allocatable :: text
      text = 'a larger element_length than '//in_units(model%units, unit_length, element_length, digits)
      if (model%numerics%discrete_joints) text = text//', tool_joints = ''smeared'''
   end function finer_text

   !> Number of elements of a string at a bit depth [-], an upper bound but for round-off.
   pure function elements_in(model, string, bit_depth, element_length) result(elements)
      type(model_type), intent(in) :: model
      character(*), intent(in) :: string
      real(wp), intent(in) :: bit_depth, element_length   !< [m]
      real(wp) :: elements
      real(wp) :: longest, bottom
      real(wp), allocatable :: tops(:)
      integer :: i, number
      number = string_index(model%strings, string)
      associate (pipes => model%strings(number)%components)
         allocate (tops(size(pipes)))
         tops = component_tops(model%strings(number), bit_depth - model%trajectory%md(1))
         elements = 0.0_wp
         bottom = 0.0_wp
         do i = 1, size(pipes)
            longest = element_length
            if (model%numerics%discrete_joints .and. has_joints(pipes(i))) &
               longest = min(longest, pipes(i)%joint_spacing/elements_a_joint)
            if (pipes(i)%centralizer%present) longest = min(longest, pipes(i)%centralizer%spacing/elements_a_joint)
            elements = elements + (tops(i) - bottom)/longest
            bottom = tops(i)
         end do
      end associate
      ! every station is a node, except for stations too near each other
      elements = max(elements, min(real(count(model%trajectory%md < bit_depth), wp), bit_depth/(merged_share*element_length)))
   end function elements_in
end module dg_case_memory
