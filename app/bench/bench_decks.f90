!> What the fidelity auto is worth on every sample deck: its distance from reference, and how much faster it is.
module dg_bench_decks
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_tools, only: median, now
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_type
   use dg_fault_list, only: fault_list_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_numerics, only: set_fidelity
   use dg_read_deck, only: read_deck
   use dg_static_analysis, only: solve_static_analysis
   use dg_text, only: text_type
   implicit none
   private
   public :: print_decks

   !> Times that each case is solved; its seconds are their median.
   integer, parameter :: runs = 3
   !> Torque under which its relative error says nothing [N.m].
   real(wp), parameter :: least_torque = 1.0_wp
   real(wp), parameter :: per_cent = 100.0_wp

contains

   !> One line a deck: worst case in hook load and torque, all cases in seconds.
   subroutine print_decks(decks)
      character(*), intent(in) :: decks(:)   !< paths
      integer :: i
      write (output_unit, '(/,a,i0,a)') 'Fidelity auto against reference (elements of 1 m): worst case of each deck, '// &
         'seconds of all, medians of ', runs, ' runs'
      write (output_unit, '(a)') 'deck                              cases  hook load %   torque %      elements  iterations'// &
         '   seconds   reference  ratio'
      do i = 1, size(decks)
         call print_deck(trim(decks(i)))
      end do
   end subroutine print_decks

   subroutine print_deck(deck)
      character(*), intent(in) :: deck
      type(model_type) :: coarse_model, fine_model
      type(job_type) :: job
      type(text_type), allocatable :: notes(:)
      type(fault_list_type) :: faults
      type(case_result_type) :: coarse, fine
      type(error_type), allocatable :: error
      real(wp) :: hookload, torque, seconds(2), taken(runs, 2), t(0:2)
      integer :: i, run, elements(2), iterations(2), lost
      character(34) :: name
      character(40) :: note
      name = deck
      allocate (notes(0))
      call read_deck(deck, coarse_model, job, notes, faults)
      if (faults%count > 0) then
         write (output_unit, '(a)') name//'cannot be read'
         return
      end if
      fine_model = coarse_model
      call set_fidelity(coarse_model%numerics, 'auto')
      call set_fidelity(fine_model%numerics, 'reference')
      hookload = 0.0_wp
      torque = 0.0_wp
      seconds = 0.0_wp
      elements = 0
      iterations = 0
      lost = 0
      do i = 1, size(coarse_model%cases)
         do run = 1, runs
            t(0) = now()
            call solve_static_analysis(coarse_model, i, coarse, error)
            t(1) = now()
            call solve_static_analysis(fine_model, i, fine, error)
            t(2) = now()
            taken(run, :) = t(1:) - t(:1)
         end do
         seconds = seconds + [median(taken(:, 1)), median(taken(:, 2))]
         elements = elements + [coarse%elements, fine%elements]
         iterations = iterations + [coarse%iterations, fine%iterations]
         if (coarse%status /= result_converged .or. fine%status /= result_converged) then
            lost = lost + 1
            cycle
         end if
         hookload = max(hookload, abs(coarse%hookload/fine%hookload - 1.0_wp))
         if (abs(fine%torque) > least_torque) torque = max(torque, abs(coarse%torque/fine%torque - 1.0_wp))
      end do
      note = ''
      if (lost > 0) write (note, '(2x,i0,a)') lost, ' cases without solution left out'
      write (output_unit, '(a34,i5,f13.4,f11.4,i7,a,i6,i6,a,i5,f10.3,f12.3,f7.1,a)') name, size(coarse_model%cases), &
         per_cent*hookload, per_cent*torque, elements(1), '/', elements(2), iterations(1), '/', iterations(2), seconds, &
         seconds(2)/seconds(1), trim(note)
   end subroutine print_deck
end module dg_bench_decks
