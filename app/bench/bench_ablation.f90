!> Worth of each number of dg_tuning: wells solved with it and without it.
module dg_bench_ablation
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_list_type, error_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_read_deck, only: read_deck
   use dg_static_analysis, only: solve_static_analysis
   use dg_tuning, only: tuning_type
   implicit none
   private
   public :: print_ablation

   !> Numbers in the list.
   integer, parameter :: numbers = 46
   !> For a threshold that nothing reaches, and a count that none does.
   real(wp), parameter :: never = 1.0e30_wp
   integer, parameter :: endless = 1000000000
   !> Hook load or torque that differ by more than this part are another answer [-], torque also by more than a newton metre.
   real(wp), parameter :: other_answer = 1.0e-3_wp, least_torque = 1.0_wp

   !> A number, as it is and as it is tried.
   type :: change_type
      character(16) :: name = ''
      character(8) :: value = '', other = ''
   end type change_type

   !> Outcome of the cases of all decks.
   type :: outcome_type
      logical, allocatable :: converged(:)           !< (case)
      real(wp), allocatable :: totals(:, :)          !< hook load and torque (2,case) [N, N.m]
      integer :: iterations = 0                      !< those of failed cases included
   end type outcome_type

   interface change
      procedure change_real, change_integer, change_logical
   end interface change

contains

   !> One line a number.
   subroutine print_ablation(decks)
      character(*), intent(in) :: decks(:)   !< paths
      type(model_type), allocatable :: models(:)
      type(tuning_type) :: tuning
      type(outcome_type) :: with, without
      type(change_type) :: changed
      integer :: number
      call read_models(decks, models)
      call solve_all(models, tuning, with)
      write (output_unit, '(i0,a,i0,a,i0,a)') size(models), ' decks, ', size(with%converged), ' cases, ', count(with%converged), &
         ' converged. Without: the number as it is tried instead'
      write (output_unit, '(a)') 'Another answer: cases that converge with and without it to hook loads or torques 0.1 % apart'
      write (output_unit, '(a)') 'number             value   tried  converged without  iterations without  another answer'
      do number = 1, numbers
         tuning = tuning_type()
         call change_number(number, tuning, changed)
         call solve_all(models, tuning, without)
         write (output_unit, '(a16,2a8,i11,i8,i12,i8,i16)') changed%name, adjustr(changed%value), adjustr(changed%other), &
            count(with%converged), count(without%converged), with%iterations, without%iterations, count(apart(with, without))
         flush (output_unit)
      end do
   end subroutine print_ablation

   !> The models of decks that can be read.
   subroutine read_models(decks, models)
      character(*), intent(in) :: decks(:)
      type(model_type), allocatable, intent(out) :: models(:)
      type(model_type) :: all(size(decks))
      type(job_type) :: job
      type(error_list_type) :: faults
      integer :: i, n
      n = 0
      do i = 1, size(decks)
         call read_deck(trim(decks(i)), all(n + 1), job, faults)
         if (faults%count > 0) then
            write (output_unit, '(a)') trim(decks(i))//' cannot be read'
         else
            n = n + 1
         end if
      end do
      models = all(:n)
   end subroutine read_models

   !> Solves every case of every model, without moments.
   subroutine solve_all(models, tuning, outcome)
      type(model_type), intent(inout) :: models(:)
      type(tuning_type), intent(in) :: tuning
      type(outcome_type), intent(out) :: outcome
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i, j, n
      n = 0
      do i = 1, size(models)
         n = n + size(models(i)%cases)
      end do
      allocate (outcome%converged(n), source=.false.)
      allocate (outcome%totals(2, n), source=0.0_wp)
      n = 0
      do i = 1, size(models)
         models(i)%numerics%tuning = tuning
         do j = 1, size(models(i)%cases)
            call solve_static_analysis(models(i), j, result, error, totals_only=.true.)
            n = n + 1
            outcome%iterations = outcome%iterations + result%iterations
            outcome%converged(n) = result%status == result_converged
            if (outcome%converged(n)) outcome%totals(:, n) = [result%hookload, result%torque]
         end do
      end do
   end subroutine solve_all

   !> Cases that converge to different answers.
   pure function apart(a, b)
      type(outcome_type), intent(in) :: a, b
      logical :: apart(size(a%converged))
      apart = a%converged .and. b%converged .and. &
              (abs(a%totals(1, :) - b%totals(1, :)) > other_answer*abs(a%totals(1, :)) .or. &
               abs(a%totals(2, :) - b%totals(2, :)) > max(other_answer*abs(a%totals(2, :)), least_torque))
   end function apart

   !> Changes one number of the list: to what switches its helper off, or else to some times as much.
   subroutine change_number(number, tuning, changed)
      integer, intent(in) :: number            !< in the list, 1 to `numbers`
      type(tuning_type), intent(inout) :: tuning
      type(change_type), intent(out) :: changed
      select case (number)
      case (1); call change('most_attempts', tuning%most_attempts, 1, changed)
      case (2); call change('most_cuts', tuning%most_cuts, 0, changed)
      case (3); call change('most_meshes', tuning%most_meshes, 1, changed)
      case (4); call change('damped_share', tuning%damped_share, 0.4_wp, changed)
      case (5); call change('soft_penetration', tuning%soft_penetration, 0.01_wp, changed)
      case (6); call change('start_buckled', tuning%start_buckled, changed)
      case (7); call change('start_bent', tuning%start_bent, changed)
      case (8); call change('start_outside', tuning%start_outside, never, changed)
      case (9); call change('sliver', tuning%sliver, 0.0_wp, changed)
      case (10); call change('aside', tuning%aside, never, changed)
      case (11); call change('most_settlings', tuning%most_settlings, 1, changed)
      case (12); call change('growth', tuning%growth, 10.0_wp, changed)
      case (13); call change('few', tuning%few, 0.0_wp, changed)
      case (14); call change('calm', tuning%calm, never, changed)
      case (15); call change('stiff', tuning%stiff, 0.0_wp, changed)
      case (16); call change('gently', tuning%gently, never, changed)
      case (17); call change('most_moves', tuning%most_moves, 0, changed)
      case (18); call change('longest_round', tuning%longest_round, endless, changed)
      case (19); call change('of_soft_wall', tuning%of_soft_wall, 0.0_wp, changed)
      case (20); call change('along_hole', tuning%along_hole, 0.0_wp, changed)
      case (21); call change('damping_start', tuning%damping_start, 1.0e-2_wp, changed)
      case (22); call change('after_success', tuning%after_success, 0.0_wp, changed)
      case (23); call change('after_refusal', tuning%after_refusal, 0.3_wp, changed)
      case (24); call change('until_definite', tuning%until_definite, 4.0_wp, changed)
      case (25); call change('raise_damping', tuning%raise_damping, 2.0_wp, changed)
      case (26); call change('most_raises', tuning%most_raises, 0, changed)
      case (27); call change('near', tuning%near, 0.0_wp, changed)
      case (28); call change('keep_lengths', tuning%keep_lengths, changed)
      case (29); call change('uphill', tuning%uphill, 0.6_wp, changed)
      case (30); call change('most_searches', tuning%most_searches, 0, changed)
      case (31); call change('shortest', tuning%shortest, 0.0_wp, changed)
      case (32); call change('longest', tuning%longest, 0.35_wp, changed)
      case (33); call change('refused', tuning%refused, never, changed)
      case (34); call change('nearly', tuning%nearly, 0.0_wp, changed)
      case (35); call change('long', tuning%attempt(4)%reach, 1.0_wp, changed)
      case (36); call change('more_moves', tuning%more_moves, 0, changed)
      case (37); call change('astray', tuning%astray, 0.0_wp, changed)
      case (38); call change('start_mirrored', tuning%start_mirrored, changed)
      case (39); call change('longest_stall', tuning%longest_stall, 400, changed)
      case (40); call change('coiled_longest', tuning%coiled_longest, 170, changed)
      case (41); call change('longest_quiet', tuning%longest_quiet, endless, changed)
      case (42); call change('hold_stiffness', tuning%hold_stiffness, 0.1_wp, changed)
      case (43); call change('most_held', tuning%most_held, 0.02_wp, changed)
      case (44); call change('longest_cycle', tuning%longest_cycle, endless, changed)
      case (45); call change('hold_slipping', tuning%hold_slipping, 1.0_wp, changed)
      case default; call change('still', tuning%still, never, changed)
      end select
   end subroutine change_number

   pure subroutine change_real(name, value, other, changed)
      character(*), intent(in) :: name
      real(wp), intent(inout) :: value
      real(wp), intent(in) :: other
      type(change_type), intent(out) :: changed
      changed%name = name
      write (changed%value, '(es8.1)') value
      write (changed%other, '(es8.1)') other
      if (.not. other < never) changed%other = 'never'
      value = other
   end subroutine change_real

   pure subroutine change_integer(name, value, other, changed)
      character(*), intent(in) :: name
      integer, intent(inout) :: value
      integer, intent(in) :: other
      type(change_type), intent(out) :: changed
      changed%name = name
      write (changed%value, '(i0)') value
      changed%other = 'never'
      if (other < endless) write (changed%other, '(i0)') other
      value = other
   end subroutine change_integer

   pure subroutine change_logical(name, value, changed)
      character(*), intent(in) :: name
      logical, intent(inout) :: value
      type(change_type), intent(out) :: changed
      changed%name = name
      changed%value = merge('yes', 'no ', value)
      value = .not. value
      changed%other = merge('yes', 'no ', value)
   end subroutine change_logical
end module dg_bench_ablation
