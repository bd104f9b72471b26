!> Cost of moments along the string: whole cases with and without them. Compared with elements of 1 m, which need no second solution
!> for moments.
module dg_bench_moments
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_tools, only: median, now
   use dg_case_result, only: case_result_type, result_converged
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_numerics, only: set_fidelity
   use dg_static_analysis, only: solve_static_analysis
   use dg_study_comparison, only: compare_lines
   use dg_trajectory, only: azimuth_of, inclination_of, interpolation_minimum_curvature, new_trajectory, position_at
   implicit none
   private
   public :: print_moments

   !> Times that each case is solved; its seconds are their median.
   integer, parameter :: runs = 3
   real(wp), parameter :: per_cent = 100.0_wp
   !> A survey as tools take it: a station a stand, angles off by so much [m, rad].
   real(wp), parameter :: station = 28.5_wp, noise = 0.15_wp*degree
   !> Elements short enough for most moments [m].
   real(wp), parameter :: short = 1.0_wp

contains

   !> One line a case by fidelity auto on the hole as it is, then on a survey with noise.
   subroutine print_moments(model)
      type(model_type), intent(in) :: model
      type(model_type) :: own
      type(error_type), allocatable :: error
      write (output_unit, '(/,a)') 'Moments by fidelity auto: seconds without and with them; elements of 1 m without; how far '// &
         'moments are off those of reference, of the largest'
      own = model
      call set_fidelity(own%numerics, 'auto')
      call print_well(own, 'hole of the deck')
      call make_noisy(own, error)
      if (allocated(error)) return
      call print_well(own, 'stations with noise')
   end subroutine print_moments

   subroutine print_well(model, name)
      type(model_type), intent(in) :: model
      character(*), intent(in) :: name
      type(model_type) :: fine, plain
      type(case_result_type) :: bare, auto, metre, reference
      real(wp) :: seconds(3), total(3), worst(2), off(2)
      integer :: i, lost
      plain = model
      plain%numerics%element_length = short
      plain%numerics%moments = .false.
      fine = model
      call set_fidelity(fine%numerics, 'reference')
      write (output_unit, '(a)') name
      write (output_unit, '(a)') 'case                   elements  beam nodes    without       with  ratio    1 m: elements  '// &
         'seconds  to auto   off %: auto     1 m'
      total = 0.0_wp
      worst = 0.0_wp
      lost = 0
      do i = 1, size(model%cases)
         call time_case(model, i, .true., bare, seconds(1))
         call time_case(model, i, .false., auto, seconds(2))
         call time_case(plain, i, .false., metre, seconds(3))
         call time_case(fine, i, .false., reference)
         if (any([bare%status, auto%status, metre%status, reference%status] /= result_converged)) then
            lost = lost + 1
            cycle
         end if
         off = [off_by(auto, reference), off_by(metre, reference)]
         write (output_unit, '(a22,i9,i12,2f11.4,f7.2,i17,f9.4,f9.1,f14.2,f8.2)') model%cases(i)%name//repeat(' ', 22), &
            auto%elements, auto%beam_nodes, seconds(:2), seconds(2)/seconds(1), metre%elements, seconds(3), seconds(3)/seconds(2), &
            per_cent*off
         total = total + seconds
         worst = max(worst, off)
      end do
      if (lost < size(model%cases)) write (output_unit, '(a22,21x,2f11.4,f7.2,17x,f9.4,f9.1,f14.2,f8.2)') &
         'all, worst'//repeat(' ', 22), total(:2), total(2)/total(1), total(3), total(3)/total(2), per_cent*worst
      if (lost > 0) write (output_unit, '(i0,a)') lost, ' cases without solution are left out'
   end subroutine print_well

   !> Solves a case, and where asked for times it, by the median.
   subroutine time_case(model, case_index, totals_only, result, seconds)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: totals_only
      type(case_result_type), intent(out) :: result
      real(wp), intent(out), optional :: seconds
      type(error_type), allocatable :: error
      real(wp) :: taken(runs), start
      integer :: run
      do run = 1, runs
         start = now()
         call solve_static_analysis(model, case_index, result, error, totals_only=totals_only)
         taken(run) = now() - start
         if (.not. present(seconds)) return
      end do
      seconds = median(taken)
   end subroutine time_case

   !> Largest difference of moments along the string over the reference's largest [-].
   pure function off_by(result, reference) result(share)
      type(case_result_type), intent(in) :: result, reference
      real(wp) :: share
      real(wp) :: largest, rms
      call compare_lines(result%profile%md, result%profile%bending, reference%profile%md, reference%profile%bending, largest, rms)
      share = largest/maxval(reference%profile%bending)
   end function off_by

   !> The same hole by stations that lie close, each off by an angle between plus and minus the noise.
   subroutine make_noisy(model, error)
      type(model_type), intent(inout) :: model
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: irregular = 12.9898_wp, large = 43758.5453_wp    ! noise that is the same everywhere
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      real(wp) :: position(3), tangent(3), bottom
      integer :: i, n
      associate (given => model%trajectory%md)
         bottom = given(size(given))
         n = 1 + int(bottom/station)
         allocate (md, source=[(station*(i - 1), i=1, n)])
      end associate
      if (bottom - md(n) > 0.5_wp*station) then
         md = [md, bottom]
      else
         md(n) = bottom
      end if
      n = size(md)
      allocate (inclination(n), azimuth(n))
      do i = 1, n
         call position_at(model%trajectory, md(i), position, tangent)
         inclination(i) = abs(inclination_of(tangent) + noise*(2.0_wp*modulo(large*sin(irregular*i), 1.0_wp) - 1.0_wp))
         azimuth(i) = azimuth_of(tangent)
         if (inclination(i) > 10.0_wp*noise) azimuth(i) = azimuth(i) &
            + noise/sin(inclination(i))*(2.0_wp*modulo(large*sin(irregular*(i + n)), 1.0_wp) - 1.0_wp)
      end do
      call new_trajectory(model%trajectory, md, inclination, azimuth, interpolation_minimum_curvature, error)
   end subroutine make_noisy
end module dg_bench_moments
