!> Order of convergence of the beams with the length of their elements, for a case that depends on nothing else. A string is
!> pulled and turned in a hole of one curvature, which it touches everywhere.
module dg_bench_orders
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_case_result, only: case_result_type, result_converged
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_name, operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_extremum, gap_at_nodes, gap_location_name
   use dg_static_analysis, only: solve_static_analysis
   use dg_study_comparison, only: compare_case, error_bending, error_hookload, new_record, study_record_type
   use dg_study_variant, only: variant_type
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: print_orders

   !> Shorter than the local scale asks for, so that every mesh is even [m].
   real(wp), parameter :: lengths(6) = [5.0_wp, 2.5_wp, 1.25_wp, 0.625_wp, 0.3125_wp, 0.15625_wp]
   !> The hole: from 30 to 60 deg over 600 m, 1.5 deg/30 m.
   real(wp), parameter :: bottom = 600.0_wp, top_inclination = 30.0_wp, bottom_inclination = 60.0_wp
   real(wp), parameter :: friction = 0.2_wp
   integer, parameter :: operations(3) = [operation_trip_out, operation_trip_in, operation_rotate_off_bottom]

contains

   !> Errors against the finest mesh and the order that they show, for both places of the gaps.
   subroutine print_orders(model)
      type(model_type), intent(in) :: model     !< whose string, hole and mud are taken
      type(model_type) :: arc
      type(error_type), allocatable :: error
      integer :: i, place
      arc = model
      call new_trajectory(arc%trajectory, [0.0_wp, bottom], [top_inclination, bottom_inclination]*degree, [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      if (allocated(error)) return
      arc%holes = model%holes(:1)
      arc%holes%md_top = 0.0_wp
      arc%holes%md_bottom = bottom
      arc%strings(1)%components = model%strings(1)%components(size(model%strings(1)%components):)
      arc%cases = model%cases(:1)
      write (output_unit, '(/,a)') 'Order of convergence with element length: drill pipe in a bend of 1.5 deg/30 m, 30 to 60 deg'
      write (output_unit, '(a)') 'operation          gaps       error of    5 m     2.5 m    1.25 m   0.625 m   0.312 m   order'
      do place = 1, 2
         do i = 1, size(operations)
            arc%cases(1)%operation = operations(i)
            arc%cases(1)%bit_depth = bottom
            arc%cases(1)%friction_axial%value = friction
            arc%cases(1)%friction_rotary%value = friction
            call print_case(arc, merge(gap_at_extremum, gap_at_nodes, place == 1))
         end do
      end do
   end subroutine print_orders

   !> One operation: a line a quantity.
   subroutine print_case(model, place)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: place               !< of the gaps
      type(variant_type) :: variants(size(lengths))
      type(study_record_type) :: records(size(lengths))
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      character(*), parameter :: quantities(error_bending) = [character(9) :: 'hook load', 'torque', 'contact', 'moment']
      character(9) :: order
      integer :: i, k, n
      n = size(lengths)
      model%numerics%gap_location = place
      do i = 1, n
         model%numerics%element_length = lengths(i)
         variants(i)%model = model_mcge
         variants(i)%numerics = model%numerics
         call solve_static_analysis(model, 1, result, error)
         call new_record(result, result%seconds, 0.0_wp, records(i))
      end do
      call compare_case(variants, records)
      do k = error_hookload, error_bending
         if (is_missing(records(1)%errors(k))) cycle
         order = '        -'
         if (.not. is_missing(records(n)%orders(k))) write (order, '(f9.2)') records(n)%orders(k)
         write (output_unit, '(a18,1x,a9,2x,a9,5es10.1,a)') operation_name(model%cases(1)%operation), gap_location_name(place), &
            quantities(k), (max(records(i)%errors(k), 0.0_wp), i=1, n - 1), order
      end do
      if (any(records%status /= result_converged)) write (output_unit, '(i0,a)') count(records%status /= result_converged), &
         ' meshes without solution'
   end subroutine print_case
end module dg_bench_orders
