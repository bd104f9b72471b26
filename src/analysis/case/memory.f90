!> Whether there is the memory that a deck, or one load case, asks for: told before anything is begun, not by the system's killing
!> the program in the middle of it.
module dg_memory
   use dg_component, only: has_joints
   use dg_drillstring, only: component_tops
   use dg_error, only: error_type, raise, status_bad_input, status_failure
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type, string_index
   use dg_numerics, only: fidelity_name, numerics_type, set_fidelity, solver_banded
   use dg_process_memory, only: address_room, memory_of_machine
   use dg_sweep, only: point_count, sweep_type
   use dg_text, only: quoted, to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_threads, only: thread_count
   use dg_uncertainty, only: piece_count
   implicit none
   private
   public :: check_memory, check_case_memory

   !> What a case takes while it is solved, and what its result and the files of it keep, an element [bytes]: 5.4 kB in all
   !> were seen with 100 000 elements. What a point of a sweep or Monte Carlo keeps, with its line in a record.
   real(wp), parameter :: bytes_solving = 5.0e3_wp, bytes_kept = 1.0e3_wp, bytes_of_point = 250.0_wp
   !> What pages, pictures and libraries take beside, and the stack of a thread [bytes].
   real(wp), parameter :: bytes_beside = 2.0e7_wp, bytes_of_stack = 8.4e6_wp
   !> Work space of a thread in OpenBLAS [bytes]: where it does not get that it tries for ever.
   real(wp), parameter :: bytes_of_blas = 1.35e8_wp
   real(wp), parameter :: gigabyte = 1.0e9_wp
   !> Less than this is there: the system is not asked for each case of thousands [bytes].
   real(wp), parameter :: surely_there = 1.0e8_wp
   integer, parameter :: digits = 3
   !> Elements from one tool joint to the next where joints are discrete, and the part of an element's length within which
   !> stations are one node (dg_mesh) [-].
   real(wp), parameter :: elements_a_joint = 5.0_wp, merged_share = 1.0e-3_wp

   !> The greatest piece of work so far, and what all of it keeps.
   type :: need_type
      real(wp) :: bytes = 0.0_wp           !< taken while it is solved
      real(wp) :: kept = 0.0_wp            !< [bytes]
      character(:), allocatable :: what
      character(:), allocatable :: remedy
   end type need_type

contains

   !> An error where the deck's work needs more memory than there is: bad input where the machine has too little, a failure where
   !> only the shell allows too little. The need is a lower bound: elements may be cut finer than asked for.
   subroutine check_memory(job, model, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      type(need_type) :: need
      real(wp) :: room, wanted
      character(:), allocatable :: text
      integer :: i
      need%what = 'the run'
      need%remedy = 'do less in one run'
      if (job%merge == 0) then
         call add_cases(job, model, need)
         if (allocated(job%study) .and. job%parts == 0) call add_study(job, model, need)
      end if
      do i = 1, size(job%sweeps)
         call add_range(job, model, job%sweeps(i), point_count(job%sweeps(i)), 'sweep', &
                        'fewer frictions or a larger bit_depth_step', need)
      end do
      do i = 1, size(job%uncertainties)
         call add_range(job, model, job%uncertainties(i)%range, piece_count(job%uncertainties(i)), 'uncertainty', &
                        'fewer samples', need)
      end do
      wanted = need%bytes + need%kept + bytes_beside
      room = memory_of_machine()
      text = job%deck_path//': '//need%what//', needs '//to_text(wanted/gigabyte, digits)//' GB of memory, the machine has '// &
             to_text(room/gigabyte, digits)//'; give '//need%remedy
      if (wanted > room) call raise(error, status_bad_input, text)
      if (allocated(error)) return
      ! addresses are not all used: threads reserve more than they touch
      if (.not. address_room() < huge(room)) return
      call add_blas(job, model, need, wanted)
      wanted = wanted + bytes_of_stack*(thread_count(job%threads, huge(1)) - 1)
      if (wanted <= address_room()) return
      call raise(error, status_failure, job%deck_path//': '//need%what//', needs '//to_text(wanted/gigabyte, digits)// &
                 ' GB of memory, this shell allows '//to_text(max(address_room(), 0.0_wp)/gigabyte, digits)// &
                 ' GB more than the program itself takes; allow more (ulimit -v), set OPENBLAS_NUM_THREADS=1, which spares '// &
                 'some, or give '//need%remedy)
   end subroutine check_memory

   !> An error (bad input) where the first load case of a model needs more memory than there is.
   subroutine check_case_memory(model, error)
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: elements, wanted, room
      elements = elements_in(model, model%cases(1)%string, model%cases(1)%bit_depth, model%numerics%element_length)
      wanted = (bytes_solving + bytes_kept)*elements
      if (wanted < surely_there) return
      room = min(memory_of_machine(), address_room())
      if (wanted > room) call raise(error, status_bad_input, 'the case has '//to_text(elements, digits)//' elements and needs '// &
         to_text(wanted/gigabyte, digits)//' GB of memory, there are '//to_text(max(room, 0.0_wp)/gigabyte, digits)//'; give '// &
         finer_text(model, model%numerics%element_length))
   end subroutine check_case_memory

   !> Load cases, one a model and case, and what calibrations do with them.
   subroutine add_cases(job, model, need)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(need_type), intent(inout) :: need
      real(wp) :: elements(size(model%cases))
      integer :: i
      if (size(model%cases) == 0) return
      elements = [(elements_in(model, model%cases(i)%string, model%cases(i)%bit_depth, model%numerics%element_length), &
                   i=1, size(model%cases))]
      if (job%parts == 0) need%kept = need%kept + bytes_kept*size(job%models)*sum(elements)
      i = maxloc(elements, 1)
      call take_greater(need, elements(i), thread_count(job%threads, size(job%models)*size(elements)), &
                        'case '//quoted(model%cases(i)%name), finer_text(model, model%numerics%element_length))
   end subroutine add_cases

   !> Solutions of a study go one by one.
   subroutine add_study(job, model, need)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(need_type), intent(inout) :: need
      type(numerics_type) :: numerics
      real(wp) :: shortest
      integer :: i
      shortest = model%numerics%element_length
      if (size(job%study%element_lengths) > 0) shortest = minval(job%study%element_lengths)
      do i = 1, size(job%study%fidelities)
         numerics = model%numerics
         call set_fidelity(numerics, fidelity_name(job%study%fidelities(i)))
         shortest = min(shortest, numerics%element_length)
      end do
      do i = 1, size(job%study%cases)
         associate (case => model%cases(job%study%cases(i)))
            call take_greater(need, elements_in(model, case%string, case%bit_depth, shortest), 1, &
                              'study, case '//quoted(case%name), finer_text(model, shortest))
         end associate
      end do
   end subroutine add_study

   !> A range of bit depths, solved at so many points.
   subroutine add_range(job, model, range, points, kind, fewer, need)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: range
      integer, intent(in) :: points
      character(*), intent(in) :: kind     !< sweep or uncertainty
      character(*), intent(in) :: fewer    !< what makes them less
      type(need_type), intent(inout) :: need
      real(wp) :: elements
      elements = 0.0_wp
      if (job%merge == 0) elements = elements_in(model, range%string, maxval(range%depths), model%numerics%element_length)
      need%kept = need%kept + bytes_of_point*points
      call take_greater(need, elements, thread_count(job%threads, points), kind//' '//quoted(range%name)//', '// &
                        to_text(points)//' solutions', fewer//', '//finer_text(model, model%numerics%element_length))
   end subroutine add_range

   !> Notes the work that takes most.
   subroutine take_greater(need, elements, threads, what, remedy)
      type(need_type), intent(inout) :: need
      real(wp), intent(in) :: elements
      integer, intent(in) :: threads
      character(*), intent(in) :: what, remedy
      if (bytes_solving*elements*threads < need%bytes) return
      need%bytes = bytes_solving*elements*threads
      need%what = what//', '//to_text(elements, digits)//' elements'
      need%remedy = remedy
      if (threads > 1) need%remedy = remedy//' or fewer threads'
   end subroutine take_greater

   !> What makes elements fewer.
   function finer_text(model, element_length) result(text)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: element_length   !< [m]
      character(:), allocatable :: text
      text = 'a larger element_length than '//trim(in_units(model%units, unit_length, element_length, digits))
      if (model%numerics%discrete_joints) text = text//', tool_joints = ''smeared'''
   end function finer_text

   !> Elements of a string at a bit depth, no less than there will be but for round-off [-].
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
      ! every station is a node, but for those that lie too near each other
      elements = max(elements, min(real(count(model%trajectory%md < bit_depth), wp), bit_depth/(merged_share*element_length)))
   end function elements_in

   !> Work space of OpenBLAS, of whose routines calibrations and the banded solver use some, put to what is wanted [bytes].
   subroutine add_blas(job, model, need, wanted)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(need_type), intent(inout) :: need
      real(wp), intent(inout) :: wanted
      logical :: banded
      banded = model%numerics%linear_solver == solver_banded
      if (allocated(job%study)) banded = banded .or. any(job%study%linear_solvers == solver_banded)
      if (.not. banded .and. size(job%calibrations) + size(job%stickings) == 0) return
      wanted = wanted + bytes_of_blas*merge(thread_count(job%threads, huge(1)), 1, banded)
      if (need%bytes > bytes_of_blas) return
      need%what = merge('the banded solver', 'a calibration    ', banded)
      need%what = trim(need%what)//' with the library OpenBLAS'
      need%remedy = 'no &calibrate'
      if (banded) need%remedy = 'another linear_solver'
   end subroutine add_blas
end module dg_memory
