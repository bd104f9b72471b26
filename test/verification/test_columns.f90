!> Columns of a profile and figures of limits.csv at the default settings against closed forms: a rotating string in straight hole,
!> a string that hangs in an arc, a string pushed beyond buckling. Moments, shear and clock of curved holes: dg_test_moments.
module dg_test_columns
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_buckling_limits, only: buckling_none, buckling_sinusoidal
   use dg_case_result, only: case_result_type
   use dg_component, only: component_type
   use dg_constants, only: degree, pi
   use dg_fluid, only: standing_mud
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_static
   use dg_missing, only: given
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_test_wells, only: hold_ends, new_well, note, part, solve
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: columns_suite

   !> Drill pipe, mud, gravity.
   real(wp), parameter :: od = 0.127_wp, id = 0.1086_wp, joint = 0.1619_wp, mass = 31.9_wp, yield = 931.0e6_wp
   real(wp), parameter :: mud = 1200.0_wp, gravity = 10.0_wp, hole = 0.2159_wp, steel = 7850.0_wp
   real(wp), parameter :: youngs = 206.0e9_wp, poisson = 0.3_wp, makeup = 40.0e3_wp, rig = 2.0e6_wp, wall = 1.0e11_wp
   real(wp), parameter :: area = 0.25_wp*pi*(od**2 - id**2), inertia = pi/64.0_wp*(od**4 - id**4)
   real(wp), parameter :: joint_area = 0.25_wp*pi*(joint**2 - id**2), joint_inertia = pi/64.0_wp*(joint**4 - id**4)
   real(wp), parameter :: spacing = 9.5_wp    !< of joints, the default [m]
   real(wp), parameter :: weight = mass*gravity*(1.0_wp - mud/steel)   !< in mud [N/m]
   !> Forces over the largest, and what follows from them; what contact makes over its own size: the string's ends hang free of the
   !> wall over some metres.
   real(wp), parameter :: force_within = 1.0e-3_wp, contact_within = 5.0e-3_wp
   !> Torque over its own size, at the bit too: 6 m of string that hang there are worth 0.5 % of the bit's torque.
   real(wp), parameter :: torque_within = 0.01_wp
   !> Sum of contact in an arc: the centred ends hang off the wall over some metres of 600 m.
   real(wp), parameter :: ends_within = 0.03_wp
   !> Compression at which the margin of stability is used up, over Dawson and Paslay's. Seen: 4.8 % low; the elements are only
   !> as short as the compression that is there needs. On elements of 1 m it is 1 % low.
   real(wp), parameter :: margin_within = 0.05_wp
   !> Rows nearer than this to an end of the string or of a bend are not compared [m].
   real(wp), parameter :: end_part = 40.0_wp
   !> Rounding of the tables of the trajectory [m, rad].
   real(wp), parameter :: rounding = 1.0e-9_wp

contains

   function columns_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('columns')
      call suite%addTest(TestMethod('rotating_in_straight_hole', test_straight))
      call suite%addTest(TestMethod('hanging_in_an_arc', test_arc))
      call suite%addTest(TestMethod('pushed_beyond_buckling', test_pushed))
      call suite%addTest(TestMethod('follows_a_crooked_hole', test_crooked))
      call suite%addTest(TestMethod('margin_of_stability', test_margin))
      call suite%addTest(TestMethod('turns_of_a_coil', test_coil))
      call suite%addTest(TestMethod('weight_before_lock_up', test_lock_up))
   end function columns_suite

   subroutine build(model, md, inclination, azimuth, friction)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: md(:), inclination(:), azimuth(:)   !< [m, deg, deg]
      real(wp), intent(in) :: friction
      type(component_type) :: component
      component = part('drillpipe', 0.0_wp, od, id, mass, joint)
      component%yield = yield
      component%makeup_torque = makeup
      call new_well(model, md, inclination, azimuth, hole, friction, component)
      model%numerics = settings_of('auto')
      model%mud = standing_mud(mud)
      model%gravity = gravity
      call hold_ends(model)
   end subroutine build

   subroutine solve_all(model, operation, wob, tob, result, along, whole)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob, tob
      type(case_result_type), intent(out) :: result
      type(along_string_type), intent(out) :: along
      type(whole_string_type), intent(out) :: whole
      call solve(model, operation, wob, tob, result, 'columns')
      result%model = model_mcge
      result%case_index = 1
      call find_along_string(model, result, along)
      model%rig%max_hookload = given(rig)
      call find_whole_string(model, result, along, whole)
   end subroutine solve_all

   !> 1000 m at 40 deg, rotating on bottom, friction m: contact w sin/sqrt(1 + m^2) at 180 deg - atan m, torque r m times that,
   !> axial force w cos (L - s) - wob.
   subroutine test_straight()
      real(wp), parameter :: depth = 1000.0_wp, theta = 40.0_wp*degree, azimuth = 30.0_wp*degree, m = 0.25_wp, wob = 40.0e3_wp
      real(wp), parameter :: tob = 4.0e3_wp, clearance = 0.5_wp*(hole - joint)
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: axial, torque, contact, pressure, shear_stress, stress, sine, top, turns, envelope, overpull
      integer :: i
      call build(model, [0.0_wp, depth], [40.0_wp, 40.0_wp], [30.0_wp, 30.0_wp], m)
      call solve_all(model, operation_rotary_drilling, wob, tob, result, along, whole)
      contact = weight*sin(theta)/sqrt(1.0_wp + m**2)
      sine = 2.0_wp*sqrt(youngs*inertia*weight*sin(theta)/clearance)
      top = weight*cos(theta)*depth - wob
      envelope = 1.0_wp
      overpull = area*yield
      do i = 1, size(result%profile%md)
         associate (p => result%profile, s => result%profile%md(i))
            call assertEqual(s*cos(theta), p%tvd(i), rounding*depth, message='tvd')
            call assertEqual(s*sin(theta)*cos(azimuth), p%north(i), rounding*depth, message='north')
            call assertEqual(s*sin(theta)*sin(azimuth), p%east(i), rounding*depth, message='east')
            call assertEqual(theta, p%inclination(i), rounding, message='inclination')
            call assertEqual(azimuth, p%azimuth(i), rounding, message='azimuth')
            axial = weight*cos(theta)*(depth - s) - wob
            torque = tob + 0.5_wp*joint*m*contact*(depth - s)
            pressure = mud*gravity*s*cos(theta)
            shear_stress = torque*0.25_wp*od/inertia
            call assertEqual(axial, p%axial(i), force_within*top, message='axial')
            call assertRelativelyEqual(torque, p%torque(i), torque_within, message='torque')
            call assertEqual(pressure, along%pressure(i), rounding*pressure + 1.0e-3_wp, message='pressure')
            call assertEqual(axial - pressure*area, along%true_axial(i), force_within*top, message='true axial')
            call assertEqual(axial/area - pressure, along%axial_stress(i), force_within*top/area, message='axial stress')
            call assertRelativelyEqual(shear_stress, along%torsional_stress(i), torque_within, message='torsional stress')
            call assertEqual(-pressure, along%hoop_stress(i), rounding*pressure + 1.0e-3_wp, message='hoop stress')
            call assertRelativelyEqual(sine, along%sinusoidal(i), rounding, message='sinusoidal load')
            call assertRelativelyEqual(sqrt(2.0_wp)*sine, along%helical(i), rounding, message='helical load')
            call assertRelativelyEqual((2.0_wp*sqrt(2.0_wp) - 1.0_wp)*sine, along%helical_upper(i), rounding, message='upper')
            call assertEqual(sine + axial, along%buckling_margin(i), force_within*top, message='buckling margin')
            call assertEqual(buckling_none, along%buckling(i), message='buckling')
            ! next to the ends, where the string comes to the wall, it is bent
            stress = hypot(abs(axial)/area + along%bending_stress(i), sqrt(3.0_wp)*shear_stress)
            call assertEqual(1.0_wp - stress/yield, along%envelope_margin(i), force_within, message='envelope margin')
            envelope = min(envelope, 1.0_wp - stress/yield)
            overpull = min(overpull, area*(sqrt(yield**2 - 3.0_wp*shear_stress**2) - along%bending_stress(i)) - axial)
            call assertEqual(0.0_wp, along%curvature(i), rounding, message='dogleg')
            call assertEqual(od, along%od(i), rounding, message='od')
            call assertEqual(hole, along%hole_diameter(i), rounding, message='hole')
            if (min(s, depth - s) < end_part) cycle
            ! the mud presses on all sides: what yields is the effective axial stress
            stress = hypot(axial/area, sqrt(3.0_wp)*shear_stress)
            call assertRelativelyEqual(stress, along%von_mises(i), contact_within, message='von Mises')
            call assertRelativelyEqual(yield/stress, along%safety_factor(i), contact_within, message='safety factor')
            stress = hypot(axial/joint_area, sqrt(3.0_wp)*torque*0.25_wp*joint/joint_inertia)
            call assertRelativelyEqual(stress, along%joint_von_mises(i), contact_within, message='von Mises in a joint')
            call assertRelativelyEqual(contact, p%side_force(i), contact_within, message='side force')
            call assertEqual(pi - atan(m), p%clock(i), 0.05_wp*degree, message='clock')
            call assertRelativelyEqual(clearance + contact/wall, p%displacement(i), 1.0e-5_wp, message='displacement')
            call assertGreaterThan(p%gap_state(i), 0, message='gap state')
            call assertLessThan(p%shear(i), contact_within*weight*depth, message='shear')
            call assertEqual(2.0_wp*along%bending_stress(i), along%bending_range(i), 1.0_wp, message='bending range')
            call assertLessThan(along%bending_stress(i), 1.0e-3_wp*youngs*0.5_wp*od/300.0_wp, message='bending stress')
         end associate
      end do
      call assertRelativelyEqual((0.5_wp*weight*cos(theta)*depth - wob)*depth/(youngs*area), whole%stretch, contact_within, &
                                 message='stretch')
      call assertRelativelyEqual(-(1.0_wp - 2.0_wp*poisson)*0.5_wp*mud*gravity*cos(theta)*depth**2/youngs, whole%pressure_stretch, &
                                 1.0e-6_wp, message='pressure stretch')
      turns = (tob + 0.25_wp*joint*m*contact*depth)*depth*(1.0_wp + poisson)/(youngs*inertia)
      call note('windup over the closed form', whole%windup/turns - 1.0_wp)
      call assertRelativelyEqual(turns, whole%windup, contact_within, message='windup')
      call assertEqual(1, size(whole%neutral_points), message='one neutral point')
      call assertEqual(depth - wob/(weight*cos(theta)), whole%neutral_points(1), 0.1_wp, message='neutral point')
      torque = tob + 0.5_wp*joint*m*contact*depth
      shear_stress = torque*0.25_wp*od/inertia
      ! at the top, or some metres below, where it comes to the wall: bending there adds to it
      call assertEqual(minval(along%safety_factor), whole%least_safety%value, rounding, message='least safety factor')
      call assertLessThan(whole%least_safety_md%value, end_part, message='where')
      call assertLessThan(whole%least_safety%value, (1.0_wp + force_within)*yield/hypot(top/area, sqrt(3.0_wp)*shear_stress), &
                          message='least safety factor at most that of the top')
      call assertRelativelyEqual(result%normal_force, whole_contact(result), rounding, message='side force adds up')
      call assertRelativelyEqual(envelope, whole%least_envelope_margin%value, contact_within, message='least envelope margin')
      call assertRelativelyEqual(overpull, whole%overpull_margin%value, contact_within, message='overpull margin')
      call assertEqual(buckling_none, whole%buckling, message='no buckling')
      call assertEqual(sine - wob, whole%buckling_margin%value, force_within*top, message='least buckling margin')
      call assertEqual(depth, whole%buckling_margin_md%value, rounding*depth, message='where')
      call assertRelativelyEqual(sine, whole%wob_buckling%value, 1.0e-6_wp, message='weight on bit to buckle')
      call assertRelativelyEqual(top + wob, whole%wob_no_hookload%value, 1.0e-6_wp, message='weight on bit without hook load')
      call assertEqual(buckling_none, whole%shape, message='shape')
      call assertEqual(rig - result%hookload, whole%rig_margin%value, 1.0_wp, message='rig margin')
      call assertRelativelyEqual(makeup - torque, whole%makeup_margin%value, contact_within, message='makeup margin')
      call assertEqual(0.0_wp, whole%makeup_margin_md%value, rounding, message='where')
   end subroutine test_straight

   !> 600 m from the vertical to 60 deg, without friction, 300 kN pulled at the bit: T = pull + w times the depth below, M = EI/R on
   !> the inside, von Mises' stress at the outer surface of the tensile side.
   subroutine test_arc()
      real(wp), parameter :: depth = 600.0_wp, turn = 60.0_wp*degree, radius = depth/turn, azimuth = 30.0_wp*degree
      real(wp), parameter :: pull = 300.0e3_wp, clearance = 0.5_wp*(hole - joint), bent = youngs*0.5_wp*od/radius
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: axial, contact, theta, stress
      integer :: i, rows
      call build(model, [0.0_wp, depth], [0.0_wp, 60.0_wp], [30.0_wp, 30.0_wp], 0.0_wp)
      call solve_all(model, operation_static, -pull, 0.0_wp, result, along, whole)
      rows = 0
      do i = 1, size(result%profile%md)
         associate (p => result%profile, s => result%profile%md(i))
            theta = s/radius
            call assertEqual(radius*sin(theta), p%tvd(i), rounding*depth, message='tvd')
            call assertEqual(radius*(1.0_wp - cos(theta))*cos(azimuth), p%north(i), rounding*depth, message='north')
            call assertEqual(radius*(1.0_wp - cos(theta))*sin(azimuth), p%east(i), rounding*depth, message='east')
            call assertEqual(theta, p%inclination(i), rounding, message='inclination')
            call assertRelativelyEqual(1.0_wp/radius, along%curvature(i), rounding, message='dogleg')
            axial = pull + weight*radius*(sin(turn) - sin(theta))
            call assertEqual(axial, p%axial(i), force_within*axial, message='axial')
            if (min(s, depth - s) < end_part) cycle
            rows = rows + 1
            contact = axial/radius - weight*sin(theta)
            stress = axial/area + bent
            call assertRelativelyEqual(youngs*inertia/radius, p%bending(i), 0.01_wp, message='bending')
            call assertRelativelyEqual(bent, along%bending_stress(i), 0.01_wp, message='bending stress')
            call assertEqual(0.0_wp, along%bending_range(i), rounding, message='bending range: it does not turn')
            call assertRelativelyEqual(contact, p%side_force(i), contact_within, message='side force')
            call assertRelativelyEqual(stress, along%von_mises(i), contact_within, message='von Mises')
            call assertRelativelyEqual(yield/stress, along%safety_factor(i), contact_within, message='safety factor')
            call assertEqual(1.0_wp, cos(p%clock(i)), 1.0e-6_wp, message='clock: the high side is inside')
            call assertRelativelyEqual(clearance + contact/wall, p%displacement(i), 1.0e-5_wp, message='displacement')
         end associate
      end do
      call assertGreaterThan(rows, 5, message='rows')
      contact = pull*turn + weight*radius*(sin(turn)*turn - 2.0_wp*(1.0_wp - cos(turn)))
      call note('sum of contact over the closed form', result%normal_force/contact - 1.0_wp)
      call assertRelativelyEqual(contact, result%normal_force, ends_within, message='sum of contact')
      call assertRelativelyEqual(result%normal_force, whole_contact(result), rounding, message='side force adds up')
      ! Where the string comes to the wall it presses with up to sqrt(EI T)/R at one place: that is on a joint of pipe too.
      axial = pull + weight*radius*sin(turn)
      call note('largest side force over that at the top', whole%side_force*radius/axial - 1.0_wp)
      call assertGreaterThan(whole%side_force, axial/radius, message='largest side force')
      call assertLessThan(whole%side_force, (axial + sqrt(youngs*inertia*axial)/spacing)/radius, message='with the edge')
      call assertLessThan(whole%side_force_md, end_part, message='where')
   end subroutine test_arc

   !> Bending moment at a tool joint of pipe that hangs from joint to joint in a bend [N.m], by differences over half a span: its
   !> offset y from the hole axis obeys EI y'''' = T (y'' + 1/R), with slope and shear none at joint and mid-span.
   pure function moment_at_joint(radius, tension) result(moment)
      real(wp), intent(in) :: radius, tension
      real(wp) :: moment
      integer, parameter :: n = 400
      real(wp) :: h, pull, pivot(0:n), m(0:n)
      integer :: i
      ! The curvature k = y'' + 1/R obeys EI k'' = T k; none of slope at both ends is a mean of 1/R. Thomas' algorithm for k'' = p k
      ! with k' = 0 at mid-span (0) and k = 1 at the joint (n), then scaled.
      h = 0.5_wp*spacing/n
      pull = tension/(youngs*inertia)*h**2
      pivot(0) = 2.0_wp/(2.0_wp + pull)
      do i = 1, n - 1
         pivot(i) = 1.0_wp/(2.0_wp + pull - pivot(i - 1))
      end do
      m(n) = 1.0_wp
      do i = n - 1, 0, -1
         m(i) = pivot(i)*m(i + 1)
      end do
      moment = youngs*inertia/radius*m(n)*n/(sum(m) - 0.5_wp*(m(0) + m(n)))
   end function moment_at_joint

   !> Side force along the string, summed up by trapezoids [N].
   pure function whole_contact(result) result(contact)
      type(case_result_type), intent(in) :: result
      real(wp) :: contact
      integer :: n
      n = size(result%profile%md)
      associate (md => result%profile%md, force => result%profile%side_force)
         contact = 0.5_wp*sum((md(2:) - md(:n - 1))*(force(2:) + force(:n - 1)))
      end associate
   end function whole_contact

   !> At 60 deg, pushed with 1.2 times Dawson and Paslay's load without friction: beyond it below where weight has taken the rest.
   subroutine test_pushed()
      real(wp), parameter :: depth = 1500.0_wp, theta = 60.0_wp*degree, clearance = 0.5_wp*(hole - joint)
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: sine, wob
      call build(model, [0.0_wp, depth], [60.0_wp, 60.0_wp], [30.0_wp, 30.0_wp], 0.0_wp)
      sine = 2.0_wp*sqrt(youngs*inertia*weight*sin(theta)/clearance)
      wob = 1.2_wp*sine
      call solve_all(model, operation_static, wob, 0.0_wp, result, along, whole)
      call note('length beyond the sinusoidal load', whole%sinusoidal_length)
      call note('length found to snake', whole%snaking_length)
      call assertEqual(buckling_sinusoidal, whole%buckling, message='buckled')
      call assertEqual(buckling_sinusoidal, whole%shape, message='found to snake')
      call assertEqual(sine - wob, whole%buckling_margin%value, 1.0e-3_wp*wob, message='margin')
      call assertEqual((wob - sine)/(weight*cos(theta)), whole%sinusoidal_length, 1.0_wp, message='length')
      call assertEqual(0.0_wp, whole%helical_length, rounding, message='no coil')
      call assertEqual(0.0_wp, whole%coiled_length, rounding, message='none found')
      call assertTrue(whole%snaking_length > 0.0_wp, message='snakes')
      call assertRelativelyEqual(wob, whole%wob_buckling%value*1.2_wp, 1.0e-6_wp, message='weight on bit to buckle')
   end subroutine test_pushed

   !> A hole that bends to and fro between its stations, at 40 deg, and a string pushed with a part of the least load of buckling:
   !> its angle swings about as long as a buckling wave, but it neither snakes nor coils.
   subroutine test_crooked()
      integer, parameter :: stations = 33
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: compression, least
      integer :: i, k
      do k = 1, 3
         call build(model, [(30.0_wp*i, i=0, stations)], [(40.0_wp + 0.8_wp*cos(1.7_wp*i), i=0, stations)], &
                    [(30.0_wp + 1.5_wp*sin(2.1_wp*i), i=0, stations)], 0.25_wp)
         call solve_all(model, operation_sliding_drilling, 20.0e3_wp*k, 0.0_wp, result, along, whole)
         compression = -minval(result%profile%axial)
         least = minval(along%sinusoidal)
         call note('compression over the least load of buckling', compression/least)
         call assertLessThan(compression, 0.6_wp*least, message='far from buckling')
         call assertGreaterThan(maxval(result%profile%clock) - minval(result%profile%clock), 0.5_wp, message='its angle swings')
         call assertEqual(buckling_none, whole%shape, message='follows the hole')
         call assertEqual(0.0_wp, whole%snaking_length, rounding, message='no snake')
      end do
   end subroutine test_crooked

   !> At 90 deg, without friction, the string leaves the low side at Dawson and Paslay's load.
   subroutine test_margin()
      real(wp), parameter :: depth = 800.0_wp, clearance = 0.5_wp*(hole - joint), share(4) = [0.5_wp, 0.6_wp, 0.8_wp, 0.95_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: sine, lost
      integer :: i
      sine = 2.0_wp*sqrt(youngs*inertia*weight/clearance)
      do i = 1, size(share)
         call build(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [30.0_wp, 30.0_wp], 0.0_wp)
         call solve_all(model, operation_static, share(i)*sine, 0.0_wp, result, along, whole)
         call assertTrue(whole%stability_margin%present .neqv. share(i) < 0.55_wp, message='told where it is compressed enough')
         if (.not. whole%stability_margin%present) cycle
         lost = (1.0_wp + whole%stability_margin%value)*share(i)
         call note('lost at, over the closed form', lost)
         call assertEqual(1.0_wp, lost, margin_within, message='margin')
      end do
   end subroutine test_margin

   !> Coils at the default settings: pushed through a horizontal hole with next to no weight, depth/(2 pi) sqrt(F/(2 EI)) turns
   !> (Lubinski); hanging in a vertical one, where compression w s grows to the bit, the integral of that.
   subroutine test_coil()
      real(wp), parameter :: depth = 1500.0_wp, force(2) = [150.0e3_wp, 300.0e3_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: turns
      integer :: i
      do i = 1, 3
         call build(model, [0.0_wp, depth], merge(0.0_wp, 90.0_wp, i == 3)*[1.0_wp, 1.0_wp], [30.0_wp, 30.0_wp], 0.0_wp)
         if (i < 3) then
            model%strings(1)%components(1)%mass = 0.01_wp
            turns = depth/(2.0_wp*pi)*sqrt(force(i)/(2.0_wp*youngs*inertia))
         else
            turns = (force(2)/weight)*2.0_wp/3.0_wp/(2.0_wp*pi)*sqrt(force(2)/(2.0_wp*youngs*inertia))
         end if
         call solve_all(model, operation_static, force(min(i, 2)), 0.0_wp, result, along, whole)
         call note('turns', turns)
         call note('more turns than that', whole%coil_turns - turns)
         call assertEqual(turns, whole%coil_turns, 1.0_wp, message='turns')
      end do
   end subroutine test_coil

   !> A string that slides into a vertical hole: it coils where its weight has compressed it enough, and from there friction of the
   !> coil takes a F^2 a metre, a = friction c/(4 EI), so that F' = w - a F^2.
   subroutine test_lock_up()
      real(wp), parameter :: depth = 3000.0_wp, friction = 0.3_wp, clearance = 0.5_wp*(hole - joint)
      !> Loads at which it begins, over (EI w^2)^(1/3): twice Lubinski's, which the program takes, and Wu and Juvkam-Wold's.
      real(wp), parameter :: begins(2) = [3.88_wp, 5.55_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: most, start, force(size(begins))
      integer :: i
      call build(model, [0.0_wp, depth], [0.0_wp, 0.0_wp], [30.0_wp, 30.0_wp], friction)
      model%numerics%joints_by_need = .false.          ! the closed form knows no pipe between joints
      call solve_all(model, operation_sliding_drilling, 10.0e3_wp, 0.0_wp, result, along, whole)
      most = sqrt(4.0_wp*youngs*inertia*weight/(friction*clearance))
      do i = 1, size(begins)
         start = begins(i)*(youngs*inertia*weight**2)**(1.0_wp/3.0_wp)
         force(i) = most*tanh(atanh(start/most) + (depth - start/weight)*weight/most)
         call note('weight before lock-up over the closed form', whole%wob_lockup%value/force(i) - 1.0_wp)
      end do
      call note('of the weight of the string', force(1)/(weight*depth))
      call assertRelativelyEqual(force(1), whole%wob_lockup%value, contact_within, message='weight before lock-up')
   end subroutine test_lock_up
end module dg_test_columns
