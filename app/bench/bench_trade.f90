!> Accuracy against cost: errors of each fidelity against `reference` in each printed quantity, and its processor time, over the
!> load cases of many decks.
module dg_bench_trade
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_along_string, only: along_string_type, find_along_string
   use dg_bench_tools, only: median, now
   use dg_case_result, only: case_result_type, result_converged, result_status_name
   use dg_error, only: error_list_type, error_type
   use dg_fidelity_errors, only: fidelity_errors, new_printed, printed_type, quantity_count, quantity_name
   use dg_job, only: job_type, model_mcge
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_numerics, only: fidelity_name, set_fidelity
   use dg_read_deck, only: read_deck
   use dg_sample_statistics, only: quantile
   use dg_solve_case, only: solve_case
   implicit none
   private
   public :: print_trade

   integer, parameter :: fidelities = size(fidelity_name)
   !> Places in fidelity_name.
   integer, parameter :: auto = 1, reference = 4
   real(wp), parameter :: per_cent = 100.0_wp

   !> One load case at all fidelities.
   type :: trade_type
      character(:), allocatable :: name                            !< deck and load case
      integer :: status(fidelities) = 0                            !< as results have it
      real(wp) :: seconds(fidelities) = 0.0_wp                     !< processor time [s]
      real(wp) :: errors(quantity_count, fidelities) = missing     !< against reference [-]
   end type trade_type

contains

   !> Solves every load case of the decks by mcge at every fidelity, and prints both tables.
   subroutine print_trade(decks)
      character(*), intent(in) :: decks(:)   !< paths
      type(trade_type), allocatable :: trades(:)
      integer :: i
      write (output_unit, '(/,a)') 'Accuracy against cost: errors of each fidelity against reference, model mcge'
      allocate (trades(0))
      do i = 1, size(decks)
         call add_deck(trim(decks(i)), trades)
      end do
      call print_lost(trades)
      trades = pack(trades, trades%status(reference) == result_converged)
      if (size(trades) == 0) return
      call print_errors(trades)
      call print_costs(trades)
   end subroutine print_trade

   !> Solves the load cases of one deck.
   subroutine add_deck(deck, trades)
      character(*), intent(in) :: deck
      type(trade_type), allocatable, intent(inout) :: trades(:)
      type(model_type) :: model
      type(job_type) :: job
      type(error_list_type) :: faults
      type(trade_type) :: trade
      integer :: i, first, last
      call read_deck(deck, model, job, faults)
      if (faults%count > 0) then
         write (output_unit, '(a)') deck//' cannot be read'
         return
      end if
      first = index(deck, '/', back=.true.) + 1
      last = index(deck, '.', back=.true.) - 1
      if (last < first) last = len(deck)
      do i = 1, size(model%cases)
         trade%name = deck(first:last)//' '//model%cases(i)%name
         call solve_fidelities(model, i, trade)
         trades = [trades, trade]
      end do
   end subroutine add_deck

   !> Solves one load case at all fidelities.
   subroutine solve_fidelities(model, case_index, trade)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(trade_type), intent(inout) :: trade
      type(model_type) :: own
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(printed_type) :: printed(fidelities)
      type(error_type), allocatable :: error
      real(wp) :: start
      integer :: i
      own = model
      do i = 1, fidelities
         call set_fidelity(own%numerics, fidelity_name(i))
         start = now()
         call solve_case(own, model_mcge, case_index, result, error)
         trade%seconds(i) = now() - start
         trade%status(i) = result%status
         if (result%status /= result_converged) cycle
         call find_along_string(own, result, along)
         call new_printed(result, own%cases(case_index)%wob, maxval(along%von_mises), printed(i))
      end do
      trade%errors = missing
      if (trade%status(reference) /= result_converged) return
      do i = 1, fidelities
         if (trade%status(i) == result_converged) trade%errors(:, i) = fidelity_errors(printed(i), printed(reference))
      end do
   end subroutine solve_fidelities

   !> One line for each load case that a fidelity did not solve; counts.
   subroutine print_lost(trades)
      type(trade_type), intent(in) :: trades(:)
      integer :: i, k
      do i = 1, size(trades)
         if (trades(i)%status(reference) /= result_converged) then
            write (output_unit, '(a)') trades(i)%name//': left out, reference is '// &
               trim(result_status_name(trades(i)%status(reference)))
            cycle
         end if
         do k = 1, fidelities
            if (trades(i)%status(k) /= result_converged) write (output_unit, '(a)') trades(i)%name//': '// &
               trim(fidelity_name(k))//' is '//trim(result_status_name(trades(i)%status(k)))//', reference is converged'
         end do
      end do
      k = count(trades%status(reference) == result_converged)
      write (output_unit, '(i0,a,i0,a)') size(trades), ' load cases, ', size(trades) - k, &
         ' of them left out, as reference is not converged or is locked up'
   end subroutine print_lost

   !> One line a fidelity and quantity.
   subroutine print_errors(trades)
      type(trade_type), intent(in) :: trades(:)
      integer :: k, quantity
      write (output_unit, '(a)') 'Errors in %. Hook load: over the hook load, at least 0.3 of the weight along the hole'
      write (output_unit, '(a)') 'Torque: from 0.1 kN.m. Moment by row: largest difference at one depth over the largest moment'
      write (output_unit, '(a)') 'Other quantities: over themselves, at least 1 kN of contact, 0.02 kN.m, 0.5 kN at the bit, '// &
         '0.02 deg, 1 MPa'
      write (output_unit, '(a)') 'fidelity   quantity             cases    median      90 %     worst  worst at'
      do k = 1, fidelities
         if (k == reference) cycle
         do quantity = 1, quantity_count
            call print_quantity(trades, k, quantity)
         end do
      end do
   end subroutine print_errors

   !> Median, 90 % and worst error of one quantity.
   subroutine print_quantity(trades, fidelity, quantity)
      type(trade_type), intent(in) :: trades(:)
      integer, intent(in) :: fidelity, quantity
      real(wp), allocatable :: errors(:)
      integer, allocatable :: order(:), places(:)
      integer :: i, n
      places = pack([(i, i=1, size(trades))], [(.not. is_missing(trades(i)%errors(quantity, fidelity)), i=1, size(trades))])
      n = size(places)
      if (n == 0) return
      errors = [(trades(places(i))%errors(quantity, fidelity), i=1, n)]
      order = sorted_places(errors)
      write (output_unit, '(a11,a18,i8,3f10.4,2x,a)') fidelity_name(fidelity)//'  ', quantity_name(quantity)//'  ', n, &
         per_cent*quantile(errors(order), [0.5_wp, 0.9_wp, 1.0_wp], 0, 0), trades(places(order(n)))%name
   end subroutine print_quantity

   !> One line a fidelity: cases that it solves, and processor time. Instructions cannot be counted from within a program.
   subroutine print_costs(trades)
      type(trade_type), intent(in) :: trades(:)
      real(wp) :: ratios(size(trades))
      integer :: i, k, lost
      write (output_unit, '(a)') 'Cost: processor time of each solution, one run, over that of auto'
      write (output_unit, '(a)') 'fidelity   solved  not solved    median      90 %  all cases   seconds'
      do k = 1, fidelities
         lost = count(trades%status(k) /= result_converged)
         ratios = [(trades(i)%seconds(k)/max(trades(i)%seconds(auto), tiny(1.0_wp)), i=1, size(trades))]
         write (output_unit, '(a11,i6,i12,2f10.2,f11.2,f10.2)') fidelity_name(k)//'  ', size(trades) - lost, lost, &
            median(ratios), quantile(ratios(sorted_places(ratios)), [0.9_wp], 0, 0), &
            sum(trades%seconds(k))/sum(trades%seconds(auto)), sum(trades%seconds(k))
      end do
   end subroutine print_costs
end module dg_bench_trade
