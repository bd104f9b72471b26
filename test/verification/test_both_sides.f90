!> Both sides of a jump: a profile has two rows where component, hole section or fluid changes, by every method.
!>
!> At a shoulder the true axial force jumps by pressure times difference of areas, which is found by hand here.
module dg_test_both_sides
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type
   use dg_component, only: tube_area
   use dg_error, only: error_type
   use dg_fluid, only: collar_closed, fluid_type
   use dg_job, only: model_mcge, model_mixed, model_name, model_rigid, model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_sliding_drilling, operation_trip_out
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_profile, only: new_profile, profile_type, side_above, side_below, side_none
   use dg_profile_file, only: profile_series
   use dg_profile_rows, only: part_rows
   use dg_series, only: series_list_type
   use dg_solve_case, only: solve_case
   use dg_stuck_string, only: value_at
   use dg_study_comparison, only: compare_lines
   use dg_test_wells, only: hold_ends, note, three_part_well
   use dg_trajectory, only: true_vertical_depth
   use dg_utilisation, only: find_utilisation, limit_tension, limit_von_mises, utilisation_type
   use dg_whole_string, only: find_whole_string, neutral_points_of, whole_string_type
   implicit none
   private
   public :: both_sides_suite

   real(wp), parameter :: depth = 1500.0_wp, shoe = 900.0_wp, collar = 150.0_wp, assembly = 300.0_wp
   real(wp), parameter :: rounding = 1.0e-9_wp
   !> Depths where something changes: casing shoe, drill pipe on heavy pipe, heavy pipe on collars [m].
   real(wp), parameter :: changes(3) = [shoe, depth - assembly, depth - collar]
   integer, parameter :: methods(4) = [model_mcge, model_soft, model_rigid, model_mixed]

contains

   function both_sides_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('both_sides')
      call suite%addTest(TestMethod('true_axial_force_at_a_shoulder', test_shoulders))
      call suite%addTest(TestMethod('limits_use_both_sides', test_limits))
      call suite%addTest(TestMethod('closed_collar', test_collar))
      call suite%addTest(TestMethod('column_side', test_column))
      call suite%addTest(TestMethod('rows_are_doubled_once', test_once))
      call suite%addTest(TestMethod('depths_that_stand_twice', test_twice))
   end function both_sides_suite

   !> A bend of 40 deg, collars, heavy pipe and drill pipe, casing to 900 m. The deeper stations are none of the changes.
   subroutine build(model)
      type(model_type), intent(out) :: model
      call three_part_well(model, [0.0_wp, 400.0_wp, 1000.0_wp, depth], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], shoe)
      call hold_ends(model)
      model%strings(1)%components%yield = [758.0e6_wp, 379.0e6_wp, 724.0e6_wp]
   end subroutine build

   !> Solves by a method, with what follows along the string and of the whole.
   subroutine find(model, method, result, along, whole)
      type(model_type), intent(in) :: model
      integer, intent(in) :: method
      type(case_result_type), intent(out) :: result
      type(along_string_type), intent(out) :: along
      type(whole_string_type), intent(out) :: whole
      type(error_type), allocatable :: error
      call solve_case(model, method, 1, result, error)
      call assertFalse(allocated(error), message='error')
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
   end subroutine find

   !> Every method, pulled and pushed, and mixed with beams at the bit.
   subroutine test_shoulders()
      type(model_type) :: model
      integer :: m
      call build(model)
      do m = 1, size(methods)
         model%cases(1)%wob = 0.0_wp
         model%cases(1)%operation = operation_trip_out
         call look_at_shoulders(model, methods(m), trim(model_name(methods(m)))//', up')
         model%cases(1)%operation = operation_sliding_drilling
         model%cases(1)%wob = 50.0e3_wp
         call look_at_shoulders(model, methods(m), trim(model_name(methods(m)))//', sliding')
      end do
      model%numerics%mixed_elements = .true.
      call look_at_shoulders(model, model_mixed, 'mixed with beams')
      model%numerics%moments = .false.
      call look_at_shoulders(model, model_mcge, 'mcge without moments')
   end subroutine test_shoulders

   !> Depths never decrease, and stand twice at the changes alone, the upper side first. Effective force and torque are one; the
   !> true axial force jumps by p (A below - A above) of the steel, as one mud stands inside and outside. The diameters
   !> are those of each side, and every number is one.
   subroutine look_at_shoulders(model, method, what)
      type(model_type), intent(in) :: model
      integer, intent(in) :: method
      character(*), intent(in) :: what
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: jump, found, pressure
      integer :: i, j, n, above(3), below(3)
      call find(model, method, result, along, whole)
      associate (profile => result%profile, parts => model%strings(1)%components)
         n = size(profile%md)
         call assertTrue(all(profile%md(2:) >= profile%md(:n - 1)), message=what//': depths')
         call assertEqual(3, count(.not. profile%md(2:) > profile%md(:n - 1)), message=what//': depths that stand twice')
         call assertEqual(3, count(profile%side == side_above), message=what//': rows above')
         call assertEqual(3, count(profile%side == side_below), message=what//': rows below')
         above = pack([(i, i=1, n)], profile%side == side_above)
         below = pack([(i, i=1, n)], profile%side == side_below)
         call assertEqual(above + 1, below, message=what//': the upper side first')
         call assertEqual(changes, profile%md(above), rounding*depth, message=what//': where')
         call assertEqual(changes, profile%md(below), rounding*depth, message=what//': where')
         call assertEqual(profile%axial(above), profile%axial(below), rounding*1.0e5_wp, message=what//': effective force')
         call assertEqual(profile%torque(above), profile%torque(below), rounding*1.0e5_wp, message=what//': torque')
         do i = 1, 3
            j = 4 - i          ! number of the component above, from the bit upwards: the shoe is within drill pipe
            pressure = 1440.0_wp*model%gravity*true_vertical_depth(model%trajectory, changes(i))
            jump = 0.0_wp
            if (i > 1) jump = pressure*(tube_area(parts(j)%od, parts(j)%id) - tube_area(parts(j + 1)%od, parts(j + 1)%id))
            found = along%true_axial(above(i)) - along%true_axial(below(i))
            call note(what//': jump of the true axial force [kN]', 1.0e-3_wp*found)
            call assertEqual(jump, found, rounding*1.0e6_wp, message=what//': jump')
            call assertEqual(along%od(above(i)), parts(min(j + 1, 3))%od, rounding, message=what//': od above')
            call assertEqual(along%od(below(i)), parts(j)%od, rounding, message=what//': od below')
            call assertEqual(merge(0.22_wp, 0.2159_wp, i == 1), along%hole_diameter(above(i)), rounding, &
                             message=what//': hole above')
            call assertEqual(0.2159_wp, along%hole_diameter(below(i)), rounding, message=what//': hole below')
         end do
         call assertGreaterThan(abs(along%von_mises(above(3)) - along%von_mises(below(3))), 1.0e5_wp, message=what//': stress')
         call assertTrue(all(ieee_is_finite(along%von_mises)) .and. all(ieee_is_finite(profile%side_force)), message=what)
      end associate
      if (method /= model_mcge) return
      n = size(result%gaps)
      call assertEqual(result%elements, n, message=what//': no more elements')
      call assertTrue(all(result%gaps(2:)%md > result%gaps(:n - 1)%md), message=what//': no element without length')
   end subroutine look_at_shoulders

   !> Find the limit that decides where it stands on one side alone. A collar of little yield is used most at its upper end, where
   !> the row of the pipe's side says little.
   subroutine test_limits()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(utilisation_type) :: used
      character(:), allocatable :: what
      integer :: m, row
      call build(model)
      model%cases(1)%operation = operation_trip_out
      model%strings(1)%components(1)%yield = 20.0e6_wp
      do m = 1, size(methods)
         call find(model, methods(m), result, along, whole)
         what = trim(model_name(methods(m)))
         associate (profile => result%profile)
            row = findloc(profile%side, side_below, dim=1, back=.true.)
            call find_utilisation(model, result, along, used)
            call assertGreaterThan(profile%axial(row), 0.0_wp, message=what)
            call assertRelativelyEqual(profile%axial(row)/(20.0e6_wp*tube_area(0.17145_wp, 0.0714_wp)), &
                                       used%used(limit_tension)%value, rounding, message=what//': tension of the collar')
            call assertEqual(depth - collar, used%md(limit_tension)%value, rounding*depth, message=what//': where')
            call assertRelativelyEqual(1.0_wp/whole%least_safety%value, used%used(limit_von_mises)%value, rounding, message=what)
            call assertEqual(minval(along%safety_factor, mask=.not. is_missing(along%safety_factor)), whole%least_safety%value, &
                             rounding, message=what//': safety')
            call assertEqual(maxval(along%von_mises), whole%von_mises, 1.0e-3_wp, message=what//': largest stress')
            call assertEqual(minval(along%buckling_margin), whole%buckling_margin%value, 1.0e-3_wp, message=what//': buckling')
            call assertGreaterThan(along%safety_factor(row - 1), 2.0_wp*along%safety_factor(row), message=what//': sides differ')
         end associate
      end do
   end subroutine test_limits

   !> A closed collar within one pipe: pressure inside jumps, and with it true axial and hoop stress, though all densities are one.
   subroutine test_collar()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp), parameter :: above_bit = 700.0_wp
      real(wp) :: pressure
      integer :: m, row
      call build(model)
      model%cases(1)%operation = operation_trip_out
      model%mud%fluids = [model%mud%fluids, &
                          fluid_type(outside=.false., density=1440.0_wp, above_bit=above_bit, collar=collar_closed)]
      pressure = 1440.0_wp*model%gravity*true_vertical_depth(model%trajectory, depth - above_bit)
      do m = 1, size(methods)
         call find(model, methods(m), result, along, whole)
         call assertEqual(4, count(result%profile%side == side_below))
         row = findloc(result%profile%side, side_above, dim=1)
         call assertEqual(depth - above_bit, result%profile%md(row), rounding*depth)
         call assertRelativelyEqual(pressure, along%inside_pressure(row), rounding)
         call assertEqual(0.0_wp, along%inside_pressure(row + 1), rounding*pressure)
         call assertRelativelyEqual(pressure*tube_area(0.1086_wp, 0.0_wp), along%true_axial(row) - along%true_axial(row + 1), &
                                    rounding)
      end do
   end subroutine test_collar

   !> The last column of a profile's file tells the sides apart: above, below, else empty.
   subroutine test_column()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(series_list_type) :: list
      integer :: row
      call build(model)
      model%cases(1)%operation = operation_trip_out
      call find(model, model_soft, result, along, whole)
      list = profile_series(result%profile, along)
      call assertEqual('side', trim(list%items(list%count)%column%name), message='the last column')
      row = minloc(abs(result%profile%md - (depth - collar)), dim=1)
      call assertEqual('', side_at(row - 1))
      call assertEqual('above', side_at(row))
      call assertEqual('below', side_at(row + 1))
      call assertEqual('', side_at(row + 2))
   contains
      function side_at(number) result(text)
         integer, intent(in) :: number
         character(:), allocatable :: text
         associate (series => list%items(list%count))
            text = series%words(series%states(number))%text
         end associate
      end function side_at
   end subroutine test_column

   !> Rows that are doubled already stay as they are.
   subroutine test_once()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(profile_type) :: again
      call build(model)
      model%cases(1)%operation = operation_trip_out
      call find(model, model_soft, result, along, whole)
      again = result%profile
      call part_rows(model, 1, again)
      call assertEqual(result%profile%md, again%md)
      call assertEqual(result%profile%side, again%side)
      call assertEqual(result%profile%side_force, again%side_force)
      ! the shoe's row is doubled, though it stands a micrometre off
      again = new_profile(4)
      again%md = [0.0_wp, shoe + 1.0e-6_wp, 1000.0_wp, 1100.0_wp]
      call part_rows(model, 1, again)
      call assertEqual([side_none, side_above, side_below, side_none, side_none], again%side)
   end subroutine test_once

   !> Look up values at a depth that stands twice: the lower side at it, each side next to it, nothing counted twice.
   subroutine test_twice()
      real(wp), parameter :: md(6) = [0.0_wp, 10.0_wp, 10.0_wp, 20.0_wp, 20.0_wp, 30.0_wp]
      real(wp), parameter :: values(6) = [0.0_wp, 1.0_wp, 5.0_wp, 6.0_wp, -2.0_wp, -3.0_wp]
      real(wp), allocatable :: points(:)
      real(wp) :: largest, rms
      call assertEqual(0.5_wp, value_at(md, values, 5.0_wp), rounding)
      call assertEqual(5.0_wp, value_at(md, values, 10.0_wp), rounding)
      call assertEqual(5.5_wp, value_at(md, values, 15.0_wp), rounding)
      call assertEqual(-2.0_wp, value_at(md, values, 20.0_wp), rounding)
      call assertEqual(-3.0_wp, value_at(md, values, 30.0_wp), rounding)
      call compare_lines(md, values, md, values, largest, rms)
      call assertEqual(0.0_wp, largest)
      call compare_lines(md, values + 1.0_wp, md, values, largest, rms)
      call assertEqual(1.0_wp, largest, rounding)
      call assertEqual(1.0_wp, rms, rounding)
      call compare_lines(md, values, [0.0_wp, 5.0_wp, 10.0_wp, 10.0_wp, 20.0_wp, 20.0_wp, 25.0_wp, 30.0_wp], &
                         [0.0_wp, 0.5_wp, 1.0_wp, 5.0_wp, 6.0_wp, -2.0_wp, -2.5_wp, -3.0_wp], largest, rms)
      call assertEqual(0.0_wp, largest, rounding)
      allocate (points, source=neutral_points_of(md, values))
      call assertEqual(1, size(points))
      call assertEqual(20.0_wp, points(1), rounding)
   end subroutine test_twice
end module dg_test_both_sides
