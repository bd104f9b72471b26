!> Check of the memory that a run needs. It is made before a run begins, so that the system does not end the program in the
!> middle.
module dg_run_memory
   use dg_case_memory, only: add_cases, gigabyte, memory_digits, need_type
   use dg_error, only: error_type, raise, status_bad_input, status_failure
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_numerics, only: solver_banded
   use dg_process_memory, only: address_room, memory_of_machine
   use dg_registry, only: studies_type
   use dg_text, only: to_text
   use dg_threads, only: thread_count
   implicit none
   private
   public :: check_memory

   !> Memory of pages, pictures and libraries, and the stack of a thread [bytes].
   real(wp), parameter :: bytes_beside = 2.0e7_wp, bytes_of_stack = 8.4e6_wp
   !> Work space of a thread in OpenBLAS [bytes]. Without it OpenBLAS retries for ever.
   real(wp), parameter :: bytes_of_blas = 1.35e8_wp
   integer, parameter :: digits = memory_digits

contains

   !> Raise an error if the deck's work needs more memory than is available. It is bad input if the machine has too little, a
   !> failure if only the shell allows too little. The need is a lower bound: elements may be cut finer than asked for.
   subroutine check_memory(job, model, studies, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(studies_type), intent(in) :: studies
      type(error_type), allocatable, intent(out) :: error
      type(need_type) :: need
      real(wp) :: room, wanted
      character(:), allocatable :: text
      integer :: i
      need%what = 'the run'
      need%remedy = 'do less in one run'
      need%banded = model%numerics%linear_solver == solver_banded
      if (job%merge == 0) &
         call add_cases(job, model, thread_count(job%threads, size(job%models)*size(model%cases)), need)
      do i = 1, size(studies%items)
         call studies%items(i)%study%add_need(job, model, need)
      end do
      wanted = need%bytes + need%kept + bytes_beside
      room = memory_of_machine()
      text = job%deck_path//': '//need%what//', needs '//to_text(wanted/gigabyte, digits)//' GB of memory, the machine has '// &
             to_text(room/gigabyte, digits)//'; give '//need%remedy
      if (wanted > room) call raise(error, status_bad_input, text)
      if (allocated(error)) return
      ! addresses are not all used: threads reserve more than they touch
      if (.not. address_room() < huge(room)) return
      call add_blas(job, need, wanted)
      wanted = wanted + bytes_of_stack*(thread_count(job%threads, huge(1)) - 1)
      if (wanted <= address_room()) return
      call raise(error, status_failure, job%deck_path//': '//need%what//', needs '//to_text(wanted/gigabyte, digits)// &
                 ' GB of memory, this shell allows '//to_text(max(address_room(), 0.0_wp)/gigabyte, digits)// &
                 ' GB more than the program itself takes; allow more (ulimit -v), set OPENBLAS_NUM_THREADS=1, which spares '// &
                 'some, or give '//need%remedy)
   end subroutine check_memory

   !> Work space of OpenBLAS, of whose routines calibrations and the banded solver use some, put to what is wanted [bytes].
   subroutine add_blas(job, need, wanted)
      type(job_type), intent(in) :: job
      type(need_type), intent(inout) :: need
      real(wp), intent(inout) :: wanted
      if (.not. (need%banded .or. need%fits)) return
      wanted = wanted + bytes_of_blas*merge(thread_count(job%threads, huge(1)), 1, need%banded)
      if (need%bytes > bytes_of_blas) return
      need%what = merge('the banded solver', 'a calibration    ', need%banded)
      need%what = trim(need%what)//' with the library OpenBLAS'
      need%remedy = 'no &calibrate'
      if (need%banded) need%remedy = 'another linear_solver'
   end subroutine add_blas
end module dg_run_memory
