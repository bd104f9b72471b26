!> The mixed model with finite elements at the bit: the beams' answer at the bit, the string's answer at the top, and no seam
!> between. And the trajectory cut where they join.
module dg_test_mixed_elements
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use dg_assembly_elements, only: join_depth
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: fluid_type, standing_mud
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_static, operation_trip_in, &
      operation_trip_out
   use dg_missing, only: is_missing
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: new_well, note, pipe
   use dg_trajectory, only: cut_trajectory, interpolation_minimum_curvature, interpolation_spline, new_trajectory, position_at, &
      trajectory_type
   implicit none
   private
   public :: mixed_elements_suite

   real(wp), parameter :: depth = 1500.0_wp, assembly = 60.0_wp
   !> Bit side force and tilt against the beams of the whole string: the same beams, mesh and force. Seen: 5e-5,
   !> most 1e-8.
   real(wp), parameter :: at_bit = 1.0e-3_wp
   !> Hook load over the weight, torque: a string on the axis counts more contact below the bend than beams do.
   real(wp), parameter :: at_top = 0.01_wp, torque_at_top = 0.02_wp

contains

   function mixed_elements_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('mixed_elements')
      call suite%addTest(TestMethod('beams_at_the_bit_string_above', test_both))
      call suite%addTest(TestMethod('join_in_a_bend', test_join_in_bend))
      call suite%addTest(TestMethod('short_string_is_all_beams', test_short))
      call suite%addTest(TestMethod('fluid_above_bit', test_fluid_above_bit))
      call suite%addTest(TestMethod('lower_part_is_pushed', test_pushed))
      call suite%addTest(TestMethod('cut_trajectory', test_cut))
   end function mixed_elements_suite

   !> Vertical to 300 m, built to 50 deg, held; two stabilizers in 60 m of collars under drill pipe; the bit held on the axis.
   subroutine build(model, md)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: md(:)
      call new_well(model, md, [0.0_wp, 0.0_wp, 50.0_wp, 50.0_wp], [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], 0.2159_wp, 0.25_wp, &
                    pipe(300.0_wp, 0.127_wp, 0.1086_wp))
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(6))
      model%strings(1)%components(1) = collar(2.0_wp, 0.0_wp)
      model%strings(1)%components(2) = collar(1.5_wp, 0.2143_wp)
      model%strings(1)%components(3) = collar(15.0_wp, 0.0_wp)
      model%strings(1)%components(4) = collar(1.5_wp, 0.2111_wp)
      model%strings(1)%components(5) = collar(assembly - 20.0_wp, 0.0_wp)
      model%strings(1)%components(6) = pipe(300.0_wp, 0.127_wp, 0.1086_wp)
      model%boundary%bit_centred = .true.
      model%numerics%mixed_elements = .true.
      model%numerics%wall_climb = .true.
   end subroutine build

   pure function collar(length, blades) result(part)
      real(wp), intent(in) :: length, blades   !< [m]
      type(component_type) :: part
      part = pipe(1200.0_wp, 0.1651_wp, 0.0714_wp)
      part%kind = 'collar'
      part%length = length
      part%joint_od = blades
      if (blades > 0.0_wp) part%kind = 'stabilizer'
   end function collar

   subroutine solve_both(model, operation, wob, tob, mixed, beams, what)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob, tob
      type(case_result_type), intent(out) :: mixed, beams
      character(*), intent(in) :: what
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation
      model%cases(1)%wob = wob
      model%cases(1)%tob = tob
      call solve_mixed_string(model, 1, mixed, error)
      call assertFalse(allocated(error), message=what)
      call solve_static_analysis(model, 1, beams, error)
      call assertEqual(result_converged, mixed%status, message=what//', mixed: '//mixed%message)
      call assertEqual(result_converged, beams%status, message=what//', beams: '//beams%message)
   end subroutine solve_both

   !> The lowest 500 m of the string are empty: hanging still, it has the weight along the hole that the soft string has.
   subroutine test_fluid_above_bit()
      type(model_type) :: model
      type(case_result_type) :: mixed, soft
      type(error_type), allocatable :: error
      call build(model, [0.0_wp, 300.0_wp, 900.0_wp, depth])
      model%mud = standing_mud(1200.0_wp)
      model%mud%fluids = [model%mud%fluids(1), fluid_type(outside=.false., density=1.0_wp, above_bit=500.0_wp)]
      model%cases(1)%operation = operation_static
      call solve_mixed_string(model, 1, mixed, error)
      call assertFalse(allocated(error))
      call solve_soft_string(model, 1, soft, error)
      call assertFalse(allocated(error))
      call assertRelativelyEqual(soft%hookload, mixed%hookload, 1.0e-6_wp, message='weight in the fluids')
   end subroutine test_fluid_above_bit

   !> Weight on bit that the assembly alone does not have: what is above pushes it, and nothing is said of a push at surface.
   subroutine test_pushed()
      type(model_type) :: model
      type(case_result_type) :: mixed, beams
      call build(model, [0.0_wp, 300.0_wp, 900.0_wp, depth])
      call solve_both(model, operation_sliding_drilling, 60.0e3_wp, 0.0_wp, mixed, beams, 'pushed')
      call assertGreaterThan(mixed%hookload, 0.0_wp)
      call assertEqual(0, index(mixed%message, 'pushed at surface'), message=mixed%message)
   end subroutine test_pushed

   subroutine compare(model, operation, wob, tob, what)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob, tob
      character(*), intent(in) :: what
      type(case_result_type) :: mixed, beams
      real(wp) :: weight, join
      integer :: n
      call solve_both(model, operation, wob, tob, mixed, beams, what)
      weight = beams%hookload + beams%friction + wob
      call note(what//': hook load', (mixed%hookload - beams%hookload)/weight)
      call note(what//': side force of the bit', mixed%bit_side_force/beams%bit_side_force - 1.0_wp)
      call note(what//': tilt of the bit', mixed%bit_tilt/beams%bit_tilt - 1.0_wp)
      call note(what//': elements', real(mixed%elements, wp))
      call assertEqual(beams%hookload, mixed%hookload, at_top*weight, message=what//': hook load')
      call assertEqual(beams%torque, mixed%torque, torque_at_top*max(beams%torque, 1.0_wp), message=what//': torque')
      call assertRelativelyEqual(beams%bit_side_force, mixed%bit_side_force, at_bit, message=what//': side force')
      call assertRelativelyEqual(beams%bit_tilt, mixed%bit_tilt, at_bit, message=what//': tilt')
      call assertRelativelyEqual(weight, mixed%hookload + mixed%friction + wob, 1.0e-9_wp, message=what//': one weight')
      ! No seam: depths never decrease, forces change by no more than weight and friction of a step.
      associate (profile => mixed%profile)
         n = size(profile%md)
         call assertTrue(all(profile%md(2:) >= profile%md(:n - 1)), message=what//': depths')
         call assertTrue(all(profile%tvd(2:) >= profile%tvd(:n - 1)), message=what//': vertical depths')
         call assertEqual(profile%md(1), 0.0_wp, message=what//': from surface')
         join = join_depth(model, 1)
         call assertLessThan(maxval(abs(profile%axial(2:) - profile%axial(:n - 1))/ &
                                    max(profile%md(2:) - profile%md(:n - 1), tiny(join)), &
                                    mask=abs(profile%md(2:) - join) < 30.0_wp), 2.0_wp*300.0_wp, message=what//': axial force')
         call assertEqual(maxval(profile%tvd), beams%profile%tvd(size(beams%profile%tvd)), 1.0e-6_wp, message=what//': depth')
      end associate
   end subroutine compare

   subroutine test_both()
      type(model_type) :: model
      call build(model, [0.0_wp, 300.0_wp, 900.0_wp, depth])
      call assertEqual(depth - assembly - 100.0_wp, join_depth(model, 1), 1.0e-9_wp, message='join')
      call compare(model, operation_trip_out, 0.0_wp, 0.0_wp, 'up')
      call compare(model, operation_trip_in, 0.0_wp, 0.0_wp, 'down')
      call compare(model, operation_rotary_drilling, 3.0e4_wp, 2.0e3_wp, 'rotary')
      call compare(model, operation_sliding_drilling, 3.0e4_wp, 2.0e3_wp, 'sliding')
   end subroutine test_both

   !> The well ends 100 m below its bend: the join lies within it.
   subroutine test_join_in_bend()
      type(model_type) :: model
      call build(model, [0.0_wp, 300.0_wp, depth - 100.0_wp, depth])
      model%numerics%element_length = 5.0_wp
      call compare(model, operation_trip_out, 0.0_wp, 0.0_wp, 'up, in a bend')
      call compare(model, operation_sliding_drilling, 3.0e4_wp, 2.0e3_wp, 'sliding, in a bend')
   end subroutine test_join_in_bend

   !> With no more than 100 m of pipe above assembly and reach all is beams, to the digit.
   subroutine test_short()
      type(model_type) :: model
      type(case_result_type) :: mixed, beams
      call build(model, [0.0_wp, 20.0_wp, 150.0_wp, 240.0_wp])
      model%cases(1)%bit_depth = 240.0_wp
      call assertEqual(0.0_wp, join_depth(model, 1))
      call solve_both(model, operation_trip_in, 0.0_wp, 0.0_wp, mixed, beams, 'short')
      call assertEqual(beams%hookload, mixed%hookload)
      call assertEqual(beams%profile%bending, mixed%profile%bending)
      call assertFalse(is_missing(mixed%bit_side_force))
      call assertGreaterThan(mixed%iterations, 0)
   end subroutine test_short

   !> Below the cut every depth has the place and direction that it had, in a bend of minimum curvature and of a spline.
   subroutine test_cut()
      type(trajectory_type) :: whole, below
      type(error_type), allocatable :: error
      real(wp) :: before(3), after(3), was(3), is(3), md
      integer :: interpolation, i
      integer, parameter :: interpolations(2) = [interpolation_minimum_curvature, interpolation_spline]
      do interpolation = 1, size(interpolations)
         call new_trajectory(whole, [0.0_wp, 300.0_wp, 900.0_wp, 1500.0_wp], [0.0_wp, 10.0_wp, 50.0_wp, 80.0_wp]*degree, &
                             [0.0_wp, 20.0_wp, 40.0_wp, 100.0_wp]*degree, interpolations(interpolation), error)
         call cut_trajectory(whole, 517.0_wp, below)
         call assertEqual(517.0_wp, below%md(1))
         call assertEqual(3, size(below%md))
         do i = 0, 10
            md = 517.0_wp + i*98.3_wp
            call position_at(whole, md, before, was)
            call position_at(below, md, after, is)
            call assertEqual(0.0_wp, norm2(after - before), 1.0e-9_wp, message='place')
            call assertEqual(0.0_wp, norm2(is - was), 1.0e-12_wp, message='direction')
         end do
      end do
   end subroutine test_cut
end module dg_test_mixed_elements
