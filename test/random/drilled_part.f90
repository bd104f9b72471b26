!> Wells as they are drilled (dg_drilled_well) against what must hold for any of them: numbers, balance, the well turned about the
!> vertical and its mirror image. Prints how many find their equilibrium, by plan and by string, in how many iterations, and what
!> part of the time goes into those that do not.
module dg_drilled_part
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_drilled_well, only: draw_drilled_well, plan_count, plan_name, string_count, string_name
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_name, rotates
   use dg_model, only: model_type
   use dg_random_well, only: lay_path, stations_type
   use dg_static_analysis, only: solve_static_analysis
   implicit none
   private
   public :: check_drilled_wells

   !> Wells that may find no equilibrium: one in so many, and one.
   integer, parameter :: marked_one_in = 10
   !> Forces out of balance over the largest [-]: above what converged results keep without a message (dg_static_result).
   real(wp), parameter :: balanced = 1.0e-4_wp
   !> Hook load of the turned or mirrored well over the largest force [-]. Compressed strings, and those with friction, have
   !> equilibria next to each other, between which round-off decides.
   real(wp), parameter :: same = 5.0e-3_wp
   real(wp), parameter :: turn = 137.0_wp      ! deg

contains

   !> Solves the wells of `number` seeds from `first` on, and counts seeds on which all held and others.
   subroutine check_drilled_wells(first, number, passed, failed)
      integer, intent(in) :: first, number
      integer, intent(inout) :: passed, failed
      type(stations_type) :: stations
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: seed, plan, string, found, counts(3), by_plan(2, plan_count), by_string(2, string_count), iterations(number)
      real(wp) :: seconds(2), turned_worst
      logical :: sound
      counts = 0
      by_plan = 0
      by_string = 0
      seconds = 0.0_wp
      turned_worst = 0.0_wp
      do seed = first, first + number - 1
         sound = .true.
         call draw_drilled_well(seed, stations, model, plan, string)
         call lay_path(stations, model)
         call solve(model, seed, result, sound)
         found = 3
         if (result%status == result_converged) found = 1
         if (result%status == result_locked_up) found = 2
         counts(found) = counts(found) + 1
         seconds(merge(2, 1, found == 3)) = seconds(merge(2, 1, found == 3)) + result%seconds
         by_plan(:, plan) = by_plan(:, plan) + [1, merge(1, 0, found == 3)]
         by_string(:, string) = by_string(:, string) + [1, merge(1, 0, found == 3)]
         if (found == 1) then
            iterations(counts(1)) = result%iterations
            call look_at(model, stations, seed, result, sound, turned_worst)
         else if (found == 3) then
            write (output_unit, '(a,i0,8a)') 'marked: seed ', seed, ', ', trim(plan_name(plan)), ', ', &
               trim(string_name(string)), ', ', trim(operation_name(model%cases(1)%operation)), ', ', result%message
         end if
         if (sound) then
            passed = passed + 1
         else
            failed = failed + 1
         end if
      end do
      call print_table(first, number, counts, by_plan, by_string, iterations(:counts(1)), seconds, turned_worst)
      if (counts(3) > 1 + number/marked_one_in) then
         write (output_unit, '(a)') 'FAIL too many wells marked'
         failed = failed + 1
      else
         passed = passed + 1
      end if
   end subroutine check_drilled_wells

   !> Check a converged well, and the same well turned about the vertical. A string that neither turns nor carries torque is
   !> mirrored, too.
   subroutine look_at(model, stations, seed, result, sound, worst)
      type(model_type), intent(in) :: model
      type(stations_type), intent(in) :: stations
      integer, intent(in) :: seed
      type(case_result_type), intent(in) :: result
      logical, intent(inout) :: sound
      real(wp), intent(inout) :: worst      !< difference of hook loads [-]
      type(stations_type) :: other
      type(model_type) :: changed
      type(case_result_type) :: again
      real(wp) :: largest, off
      largest = max(maxval(abs(result%profile%axial)), abs(model%cases(1)%wob), 1.0_wp)
      if (.not. all(ieee_is_finite([result%hookload, result%torque, result%normal_force, result%equilibrium_force])) .or. &
          .not. all(ieee_is_finite(result%profile%axial))) call fail(seed, 'converged to no number', sound)
      ! a string that whirls has no static equilibrium: its message says what is left out
      if (result%equilibrium_force > balanced*largest .and. index(result%message, 'whirl') == 0) &
         call fail(seed, 'forces out of balance', sound)
      other = stations
      other%azimuth = modulo(stations%azimuth + turn, 360.0_wp)
      if (modulo(seed, 2) == 0 .and. .not. rotates(model%cases(1)%operation) .and. .not. model%cases(1)%tob > 0.0_wp) &
         other%azimuth = modulo(-stations%azimuth, 360.0_wp)
      changed = model
      call lay_path(other, changed)
      call solve(changed, seed, again, sound)
      if (again%status /= result_converged) return
      off = abs(again%hookload - result%hookload)/largest
      worst = max(worst, off)
      if (off > same) call fail(seed, 'another hook load of the well turned about the vertical, or mirrored', sound)
   end subroutine look_at

   subroutine print_table(first, number, counts, by_plan, by_string, iterations, seconds, worst)
      integer, intent(in) :: first, number
      integer, intent(in) :: counts(3)         !< converged, locked up, neither
      integer, intent(in) :: by_plan(:, :), by_string(:, :)      !< wells, and those that are neither
      integer, intent(in) :: iterations(:)     !< of converged wells
      real(wp), intent(in) :: seconds(2)       !< spent on answers, and on what found none
      real(wp), intent(in) :: worst
      integer :: i
      write (output_unit, '(a,i0,a,i0,a,3(i0,a))') 'wells as they are drilled, seeds ', first, ' to ', first + number - 1, ': ', &
         counts(1), ' converged, ', counts(2), ' locked up, ', counts(3), ' marked as not converged'
      do i = 1, size(by_plan, 2)
         write (output_unit, '(2x,a,i0,a,i0)') plan_name(i)//' marked ', by_plan(2, i), ' of ', by_plan(1, i)
      end do
      do i = 1, size(by_string, 2)
         write (output_unit, '(2x,a,i0,a,i0)') string_name(i)//'  marked ', by_string(2, i), ' of ', by_string(1, i)
      end do
      if (size(iterations) > 0) write (output_unit, '(2x,4(a,i0))') 'iterations of those that converged: median ', &
         quantile(iterations, 0.5_wp), ', p90 ', quantile(iterations, 0.9_wp), ', p99 ', quantile(iterations, 0.99_wp), ', most ', &
         maxval(iterations)
      write (output_unit, '(2x,a,f0.1,a,i0,a)') 'solved in ', sum(seconds), ' s, of which for wells marked ', &
         nint(100.0_wp*seconds(2)/max(sum(seconds), tiny(1.0_wp))), ' %'
      write (output_unit, '(2x,a,es8.1,a,es8.1)') 'turned or mirrored: hook load off by at most ', worst, ', allowed ', same
   end subroutine print_table

   !> The smallest of the numbers below or at which a part of them lies.
   pure function quantile(numbers, part) result(number)
      integer, intent(in) :: numbers(:)
      real(wp), intent(in) :: part     !< [-]
      integer :: number
      do number = minval(numbers), maxval(numbers)
         if (count(numbers <= number) >= part*size(numbers)) return
      end do
   end function quantile

   subroutine solve(model, seed, result, sound)
      type(model_type), intent(in) :: model
      integer, intent(in) :: seed
      type(case_result_type), intent(out) :: result
      logical, intent(inout) :: sound
      type(error_type), allocatable :: error
      type(model_type) :: plain
      plain = model
      plain%numerics%moments = .false.       ! which nothing here asks for
      call solve_static_analysis(plain, 1, result, error)
      if (allocated(error)) call fail(seed, 'refused: '//error%message, sound)
   end subroutine solve

   subroutine fail(seed, what, sound)
      integer, intent(in) :: seed
      character(*), intent(in) :: what
      logical, intent(out) :: sound
      sound = .false.
      write (output_unit, '(a,i0,2a)') 'FAIL drilled seed ', seed, ': ', what
   end subroutine fail
end module dg_drilled_part
