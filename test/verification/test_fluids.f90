!> Strings with different fluids inside and outside, by depth, and pump pressure, by all models.
!>
!> Expected hook loads are those of end forces, which the program never forms: weight of pipe and of the fluid in it, less what
!> the fluid outside pushes up on the closed end and on shoulders. The program's way is weight in fluid along the string.
module dg_test_fluids
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, push_needed
   use dg_component, only: component_type, tube_area
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: collar_closed, collar_open_below, fluid_type, standing_mud
   use dg_fluid_pressure, only: surface_push
   use dg_job, only: model_count, model_mcge, model_mixed, model_rigid, model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static, operation_trip_in, operation_trip_out
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_test_wells, only: new_well, note, part, solve
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: fluids_suite

   !> Casing of 9 5/8 in, steel of 7850 kg/m3, gravity 10 m/s2 as in all wells of new_well.
   real(wp), parameter :: od = 0.2445_wp, id = 0.2205_wp, steel = 7850.0_wp, gravity = 10.0_wp, length = 1000.0_wp
   real(wp), parameter :: mud = 1200.0_wp
   real(wp), parameter :: rounding = 1.0e-9_wp

contains

   function fluids_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('fluids')
      call suite%addTest(TestMethod('floated_casing', test_floated))
      call suite%addTest(TestMethod('annulus_pressure', test_annulus_pressure))
      call suite%addTest(TestMethod('partly_filled', test_partly_filled))
      call suite%addTest(TestMethod('two_densities_and_air_gap', test_two_densities))
      call suite%addTest(TestMethod('float_collar', test_collar))
      call suite%addTest(TestMethod('pump_pressure', test_pump))
      call suite%addTest(TestMethod('shoulder', test_shoulder))
      call suite%addTest(TestMethod('contact_in_an_inclined_hole', test_inclined))
      call suite%addTest(TestMethod('floating_string_lies_on_top', test_floating))
      call suite%addTest(TestMethod('same_as_weights_in_air', test_bend))
   end function fluids_suite

   !> A straight hole with casing of the section above, in air.
   subroutine build(model, inclination, friction)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: inclination   !< [deg]
      real(wp), intent(in) :: friction
      call new_well(model, [0.0_wp, length], [inclination, inclination], [30.0_wp, 30.0_wp], 0.3112_wp, friction, &
                    part('casing', 0.0_wp, od, id, steel*tube_area(od, id), 0.0_wp))
      deallocate (model%mud%fluids)
   end subroutine build

   !> Solves by every model. Sums of contact and hook loads are handed back by model.
   subroutine solve_all(model, operation, wob, results)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob
      type(case_result_type), intent(out) :: results(model_count)
      type(error_type), allocatable :: error
      call solve(model, operation, wob, 0.0_wp, results(model_mcge), 'mcge')
      call solve_soft_string(model, 1, results(model_soft), error)
      call assertFalse(allocated(error), message='soft')
      call solve_rigid_string(model, 1, results(model_rigid), error)
      call assertFalse(allocated(error), message='rigid')
      call solve_mixed_string(model, 1, results(model_mixed), error)
      call assertFalse(allocated(error), message='mixed')
   end subroutine solve_all

   !> Hook load of all models in a vertical hole.
   subroutine check(results, expected, what)
      type(case_result_type), intent(in) :: results(model_count)
      real(wp), intent(in) :: expected   !< hook load [N]
      character(*), intent(in) :: what
      real(wp) :: scale
      integer :: m
      scale = steel*tube_area(od, id)*gravity*length
      do m = 1, model_count
         call note(what//': deviation over weight in air', (results(m)%hookload - expected)/scale)
         call assertEqual(expected, results(m)%hookload, rounding*scale, message=what)
         call assertEqual(0.0_wp, results(m)%friction, rounding*scale, message=what//': friction')
      end do
   end subroutine check

   !> Row of a depth in a profile; where it has two, the lower side's.
   pure function row_at(result, md) result(row)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: md
      integer :: row
      row = minloc(abs(result%profile%md - md), dim=1, back=.true.)
   end function row_at

   !> Air inside, mud outside, a float shoe at the end: hook load = weight in air - p_o A_o at the shoe. True force at the shoe
   !> -p_o A_o, at surface the hook load.
   subroutine test_floated()
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      type(along_string_type) :: along
      real(wp) :: air, push
      integer :: m, n
      call build(model, 0.0_wp, 0.3_wp)
      allocate (model%mud%fluids(1))
      model%mud%fluids(1) = fluid_type(inside=.false., density=mud)
      air = steel*tube_area(od, id)*gravity*length
      push = mud*gravity*length*tube_area(od, 0.0_wp)
      call solve_all(model, operation_trip_in, 0.0_wp, results)
      call check(results, air - push, 'floated')
      do m = 1, model_count
         n = size(results(m)%profile%md)
         call find_along_string(model, results(m), along)
         call assertEqual(-push, along%true_axial(n), rounding*air)
         call assertEqual(air - push, along%true_axial(1), rounding*air)
         call assertRelativelyEqual(mud*gravity*length, along%pressure(n), rounding)
         call assertEqual(0.0_wp, along%inside_pressure(n))
      end do
   end subroutine test_floated

   !> The same with the annulus closed at surface, from no pressure to one that pushes the string out: hook load = weight in air -
   !> (column + annulus pressure) A_o at the shoe. Below zero the string must be held down.
   subroutine test_annulus_pressure()
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      type(component_type) :: pipe
      real(wp), parameter :: pressures(3) = [0.0_wp, 2.0e6_wp, 1.0e7_wp]   ! [Pa]
      integer :: i, m
      call build(model, 0.0_wp, 0.3_wp)
      allocate (model%mud%fluids(1))
      do i = 1, size(pressures)
         model%mud%fluids(1) = fluid_type(inside=.false., density=mud, surface_pressure=pressures(i))
         call solve_all(model, operation_trip_in, 0.0_wp, results)
         call check(results, steel*tube_area(od, id)*gravity*length - (mud*gravity*length + pressures(i))*tube_area(od, 0.0_wp), &
                    'annulus pressure')
         do m = 1, model_count
            call assertEqual(results(m)%hookload < 0.0_wp, index(results(m)%message, push_needed) > 0, message='held down')
         end do
      end do
      ! wider pipe that is still above surface is not at the seal
      pipe = model%strings(1)%components(1)
      model%strings(1)%components = [pipe, pipe]
      model%strings(1)%components(1)%length = length
      model%strings(1)%components(2)%od = 2.0_wp*od
      call assertEqual(pressures(3)*tube_area(od, 0.0_wp), surface_push(model, 1), message='of the pipe at surface')
   end subroutine test_annulus_pressure

   !> Mud inside from a level of 400 m down. The same level in a hole of 60 deg given in both depths: 200 m below surface.
   subroutine test_partly_filled()
      real(wp), parameter :: level = 400.0_wp
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      type(along_string_type) :: along
      real(wp) :: air, expected
      integer :: row
      call build(model, 0.0_wp, 0.3_wp)
      allocate (model%mud%fluids(2))
      model%mud%fluids(1) = fluid_type(inside=.false., density=mud)
      model%mud%fluids(2) = fluid_type(outside=.false., density=mud, md_top=level)
      air = steel*tube_area(od, id)*gravity*length
      expected = air + mud*gravity*(length - level)*tube_area(id, 0.0_wp) - mud*gravity*length*tube_area(od, 0.0_wp)
      call solve_all(model, operation_trip_out, 0.0_wp, results)
      call check(results, expected, 'partly filled')
      call find_along_string(model, results(model_mcge), along)
      row = row_at(results(model_mcge), level)
      call assertEqual(level, results(model_mcge)%profile%md(row), rounding, message='a node at the level')
      call assertEqual(0.0_wp, along%inside_pressure(row), 1.0e-3_wp)
      row = row_at(results(model_mcge), length)
      call assertRelativelyEqual(mud*gravity*(length - level), along%inside_pressure(row), rounding)
   end subroutine test_partly_filled

   !> Air gap of 25 m, sea water to the mud line at 325 m, mud below it, outside; mud from the air gap on inside, open end. True
   !> force at the open end: -(p_o A_o - p_i A_i).
   subroutine test_two_densities()
      real(wp), parameter :: gap = 25.0_wp, mud_line = 325.0_wp, sea = 1030.0_wp
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      type(along_string_type) :: along
      real(wp) :: air, around, within
      integer :: row
      call build(model, 0.0_wp, 0.3_wp)
      allocate (model%mud%fluids(3))
      model%mud%fluids(1) = fluid_type(inside=.false., density=sea, md_top=gap)
      model%mud%fluids(2) = fluid_type(inside=.false., density=mud, md_top=mud_line)
      model%mud%fluids(3) = fluid_type(outside=.false., density=mud, md_top=gap)
      air = steel*tube_area(od, id)*gravity*length
      around = gravity*(sea*(mud_line - gap) + mud*(length - mud_line))
      within = gravity*mud*(length - gap)
      call solve_all(model, operation_static, 0.0_wp, results)
      call check(results, air + within*tube_area(id, 0.0_wp) - around*tube_area(od, 0.0_wp), 'two densities')
      call find_along_string(model, results(model_soft), along)
      row = row_at(results(model_soft), length)
      call assertRelativelyEqual(around, along%pressure(row), rounding)
      call assertRelativelyEqual(within, along%inside_pressure(row), rounding)
      call assertEqual(within*tube_area(id, 0.0_wp) - around*tube_area(od, 0.0_wp), along%true_axial(row), rounding*air)
      row = row_at(results(model_soft), mud_line)
      call assertRelativelyEqual(gravity*sea*(mud_line - gap), along%pressure(row), rounding)
   end subroutine test_two_densities

   !> Mud above a closed collar 600 m above the shoe, air below it. The collar carries the mud: true force just above it is what
   !> hangs below less p A_i of the mud, just below it not. With the collar open below the shoe track of 30 m has the pressure of
   !> the hole.
   subroutine test_collar()
      real(wp), parameter :: chamber = 600.0_wp, track = 30.0_wp
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      type(along_string_type) :: along
      real(wp) :: air, push, above, bore, hanging
      integer :: row
      call build(model, 0.0_wp, 0.3_wp)
      allocate (model%mud%fluids(2))
      model%mud = standing_mud(mud)
      model%mud%fluids = [model%mud%fluids, fluid_type(outside=.false., density=0.0_wp, above_bit=chamber, collar=collar_closed)]
      bore = tube_area(id, 0.0_wp)
      air = steel*tube_area(od, id)*gravity*length
      push = mud*gravity*length*tube_area(od, 0.0_wp)
      above = mud*gravity*(length - chamber)
      call solve_all(model, operation_static, 0.0_wp, results)
      call check(results, air - push + above*bore, 'collar')
      call find_along_string(model, results(model_soft), along)
      row = row_at(results(model_soft), length - chamber)
      hanging = air*chamber/length
      call assertEqual(0.0_wp, along%inside_pressure(row))
      call assertEqual(hanging - push, along%true_axial(row), rounding*air)
      call assertEqual(hanging - push + above*bore, along%true_axial(row - 1), rounding*air)
      row = row_at(results(model_soft), length)
      call assertEqual(-push, along%true_axial(row), rounding*air)
      model%mud%fluids(2) = fluid_type(outside=.false., density=900.0_wp, above_bit=track, collar=collar_open_below)
      call solve_all(model, operation_static, 0.0_wp, results)
      call find_along_string(model, results(model_soft), along)
      row = row_at(results(model_soft), length)
      call assertRelativelyEqual(mud*gravity*length, along%inside_pressure(row), rounding)
      row = row_at(results(model_soft), length - track)
      call assertRelativelyEqual(mud*gravity*length - 900.0_wp*gravity*track, along%inside_pressure(row), rounding)
   end subroutine test_collar

   !> Pump pressure p in a pipe full of mud: hook load, effective force and so contact stay, true axial force grows by p A_i from
   !> top to bit, hoop stress inside by p (r_o^2 + r_i^2)/(r_o^2 - r_i^2), and the pipe, closed by its bit, grows longer by
   !> (1 - 2 nu) p A_i L/(E A). Weightless, von Mises' stress at the inner surface is sqrt(3) p r_o^2/(r_o^2 - r_i^2), the known one
   !> of a closed cylinder.
   subroutine test_pump()
      real(wp), parameter :: p = 20.0e6_wp
      type(model_type) :: model, pumped
      type(case_result_type) :: still(model_count), results(model_count)
      type(along_string_type) :: before, after
      type(whole_string_type) :: whole
      type(error_type), allocatable :: error
      real(wp) :: ratio
      integer :: m
      call build(model, 0.0_wp, 0.3_wp)
      model%mud = standing_mud(mud)
      pumped = model
      pumped%cases(1)%pump_pressure = p
      call solve_all(model, operation_static, 20.0e3_wp, still)
      call solve_all(pumped, operation_static, 20.0e3_wp, results)
      ratio = (od**2 + id**2)/(od**2 - id**2)
      do m = 1, model_count
         call assertEqual(still(m)%hookload, results(m)%hookload, 0.0_wp)
         call find_along_string(model, still(m), before)
         call find_along_string(pumped, results(m), after)
         call assertEqual(0.0_wp, maxval(abs(after%true_axial - before%true_axial - p*tube_area(id, 0.0_wp))), 1.0_wp)
         call assertEqual(0.0_wp, maxval(abs(after%hoop_stress - before%hoop_stress - p*ratio)), 1.0_wp)
      end do
      call assertRelativelyEqual(results(model_soft)%hookload + p*tube_area(id, 0.0_wp), after%true_axial(1), rounding)
      pumped%gravity = 0.0_wp
      pumped%cases(1)%wob = 0.0_wp
      call solve_soft_string(pumped, 1, results(model_soft), error)
      call find_along_string(pumped, results(model_soft), after)
      call assertRelativelyEqual(sqrt(3.0_wp)*p*od**2/(od**2 - id**2), after%von_mises(1), rounding)
      call find_whole_string(pumped, results(model_soft), after, whole)
      call assertRelativelyEqual((1.0_wp - 2.0_wp*0.3_wp)*p*tube_area(id, 0.0_wp)*length/(206.0e9_wp*tube_area(od, id)), &
                                 whole%pressure_stretch, rounding)
   end subroutine test_pump

   !> Liner of 300 m on thinner pipe, air inside, mud outside: the shoulder faces up and is pushed down.
   subroutine test_shoulder()
      real(wp), parameter :: liner = 300.0_wp, od_pipe = 0.127_wp, id_pipe = 0.1086_wp
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      type(component_type) :: parts(2)
      real(wp) :: expected
      call build(model, 0.0_wp, 0.3_wp)
      parts(1) = part('liner', liner, od, id, steel*tube_area(od, id), 0.0_wp)
      parts(2) = part('pipe', 0.0_wp, od_pipe, id_pipe, steel*tube_area(od_pipe, id_pipe), 0.0_wp)
      model%strings(1)%components = parts
      allocate (model%mud%fluids(1))
      model%mud%fluids(1) = fluid_type(inside=.false., density=mud)
      expected = gravity*(parts(1)%mass*liner + parts(2)%mass*(length - liner)) &
                 - mud*gravity*length*tube_area(od, 0.0_wp) + mud*gravity*(length - liner)*tube_area(od, od_pipe)
      call solve_all(model, operation_static, 0.0_wp, results)
      call check(results, expected, 'shoulder')
   end subroutine test_shoulder

   !> A hole of 60 deg, filled from 400 m on: contact force w sin(theta) per metre with w of each part, drag mu times it.
   subroutine test_inclined()
      real(wp), parameter :: level = 400.0_wp, theta = 60.0_wp*degree, mu = 0.3_wp
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      real(wp) :: empty, full, total, scale
      integer :: m
      call build(model, 60.0_wp, mu)
      allocate (model%mud%fluids(2))
      model%mud%fluids(1) = fluid_type(inside=.false., density=0.5_wp*mud)
      model%mud%fluids(2) = fluid_type(outside=.false., density=mud, md_top=level)
      empty = gravity*(steel*tube_area(od, id) - 0.5_wp*mud*tube_area(od, 0.0_wp))
      full = empty + gravity*mud*tube_area(id, 0.0_wp)
      total = empty*level + full*(length - level)
      scale = steel*tube_area(od, id)*gravity*length
      call solve_all(model, operation_trip_out, 0.0_wp, results)
      do m = 1, model_count
         call note('inclined: deviation over weight', (results(m)%hookload - total*(cos(theta) + mu*sin(theta)))/scale)
         call assertEqual(total*(cos(theta) + mu*sin(theta)), results(m)%hookload, 1.0e-6_wp*scale, message='hook load')
         call assertEqual(total*sin(theta), results(m)%normal_force, 1.0e-6_wp*scale, message='contact')
         call assertRelativelyEqual(empty*sin(theta), results(m)%profile%side_force(row_at(results(m), 200.0_wp)), 1.0e-4_wp)
         call assertRelativelyEqual(full*sin(theta), results(m)%profile%side_force(row_at(results(m), 700.0_wp)), 1.0e-4_wp)
      end do
   end subroutine test_inclined

   !> Mud of 2000 kg/m3 around empty casing: it weighs less than nothing, lies on the high side and is pushed down by
   !> |w| (cos + mu sin) per metre.
   subroutine test_floating()
      real(wp), parameter :: theta = 60.0_wp*degree, mu = 0.3_wp, heavy = 2000.0_wp
      type(model_type) :: model
      type(case_result_type) :: results(model_count)
      real(wp) :: weight, scale
      integer :: m, row
      call build(model, 60.0_wp, mu)
      allocate (model%mud%fluids(1))
      model%mud%fluids(1) = fluid_type(inside=.false., density=heavy)
      weight = gravity*(steel*tube_area(od, id) - heavy*tube_area(od, 0.0_wp))
      call assertTrue(weight < 0.0_wp)
      scale = steel*tube_area(od, id)*gravity*length
      call solve_all(model, operation_trip_in, 0.0_wp, results)
      do m = 1, model_count
         call note('floating: deviation over weight', (results(m)%hookload/length/weight - (cos(theta) + mu*sin(theta))))
         call assertEqual(weight*length*(cos(theta) + mu*sin(theta)), results(m)%hookload, 1.0e-6_wp*scale, message='hook load')
         call assertEqual(-weight*length*sin(theta), results(m)%normal_force, 1.0e-6_wp*scale, message='contact')
         row = row_at(results(m), 500.0_wp)
         call assertEqual(1.0_wp, cos(results(m)%profile%clock(row)), 1.0e-6_wp, message='high side')
      end do
   end subroutine test_floating

   !> In a hole that builds and turns, fluids that change at 700 m are the same as two pipes that meet there and weigh in air what
   !> the first weighs in its fluids.
   subroutine test_bend()
      real(wp), parameter :: level = 700.0_wp
      real(wp), parameter :: md(4) = [0.0_wp, 300.0_wp, 800.0_wp, length], inclination(4) = [0.0_wp, 0.0_wp, 50.0_wp, 80.0_wp], &
                             azimuth(4) = [20.0_wp, 20.0_wp, 40.0_wp, 60.0_wp]
      type(model_type) :: fluids, air
      type(case_result_type) :: results(model_count), expected(model_count)
      type(component_type) :: parts(2)
      real(wp) :: w(2)
      integer :: m, operation
      parts(1) = part('casing', 0.0_wp, od, id, steel*tube_area(od, id), 0.0_wp)
      call new_well(fluids, md, inclination, azimuth, 0.3112_wp, 0.3_wp, parts(1))
      deallocate (fluids%mud%fluids)
      allocate (fluids%mud%fluids(2))
      fluids%mud%fluids(1) = fluid_type(inside=.false., density=0.5_wp*mud)
      fluids%mud%fluids(2) = fluid_type(outside=.false., density=mud, md_top=level)
      w(2) = gravity*(steel*tube_area(od, id) - 0.5_wp*mud*tube_area(od, 0.0_wp))
      w(1) = w(2) + gravity*mud*tube_area(id, 0.0_wp)
      parts(2) = parts(1)
      parts%mass = w/gravity
      parts(1)%length = length - level
      call new_well(air, md, inclination, azimuth, 0.3112_wp, 0.3_wp, parts(1))
      air%strings(1)%components = parts
      do operation = operation_trip_out, operation_trip_in
         call solve_all(fluids, operation, 0.0_wp, results)
         call solve_all(air, operation, 0.0_wp, expected)
         do m = 1, model_count
            call note('bend: deviation', results(m)%hookload/expected(m)%hookload - 1.0_wp)
            call assertRelativelyEqual(expected(m)%hookload, results(m)%hookload, 1.0e-8_wp, message='hook load')
            call assertRelativelyEqual(expected(m)%normal_force, results(m)%normal_force, 1.0e-8_wp, message='contact')
            call assertRelativelyEqual(expected(m)%friction, results(m)%friction, 1.0e-7_wp, message='friction')
         end do
      end do
   end subroutine test_bend
end module dg_test_fluids
