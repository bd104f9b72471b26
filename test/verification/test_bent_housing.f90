!> Motors with a bent housing: side force, tilt and moments against a string solved independently with a bend as short
!> (dg_independent_beam), in all directions of the toolface; the element that is bent against its closed form; the curvature at
!> which an assembly drills on, against three-point geometry and against that string, whose bit has no side force in such a hole.
module dg_test_bent_housing
   use funit, only: assertEqual, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_beam_bend, only: add_bend, bend_moment, holding_moment
   use dg_beam_element, only: beam_force, membrane_length
   use dg_beam_section, only: beam_section_type
   use dg_case_result, only: case_result_type
   use dg_component, only: closed_diameter, component_type
   use dg_constants, only: degree, pi
   use dg_equilibrium_curvature, only: find_equilibrium_curvature
   use dg_independent_beam, only: bend_independently, independent_beam_type, independent_well_type, push_at_bit
   use dg_fluid, only: fluid_type, standing_mud
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_sliding_drilling, operation_static
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_soft_string_loads, only: soft_string_at
   use dg_steering, only: steering_result_type
   use dg_stiff_drag, only: find_stiff_drag
   use dg_test_wells, only: hold_ends, new_well, note, part, solve, string_weight
   use dg_vector, only: cross
   implicit none
   private
   public :: bent_housing_suite

   !> Force of the bit as a vector over its own size, tilt over the bend (it may be none, between bend and hole), largest moment
   !> over the other one. Seen: 0.3 %, 0.06 %, 0.33 %; what is left is where blades touch, by the steps of the reference.
   real(wp), parameter :: force_within = 5.0e-3_wp, tilt_within = 1.0e-3_wp, moment_within = 5.0e-3_wp
   !> Stiffness of a rigid wall as decks have it by default [N/m2]: in a softer one blades sink by centimetres.
   real(wp), parameter :: rigid = 1.0e9_wp
   !> Of numbers that differ by round-off and differences alone.
   real(wp), parameter :: exact = 1.0e-12_wp, step = 1.0e-6_wp, by_differences = 1.0e-7_wp

contains

   function bent_housing_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bent_housing')
      call suite%addTest(TestMethod('own_shape', test_own_shape))
      call suite%addTest(TestMethod('tangent', test_tangent))
      call suite%addTest(TestMethod('toolfaces', test_toolfaces))
      call suite%addTest(TestMethod('sliding', test_sliding))
      call suite%addTest(TestMethod('curved_hole', test_curved_hole))
      call suite%addTest(TestMethod('turning', test_turning))
      call suite%addTest(TestMethod('three_points', test_three_points))
      call suite%addTest(TestMethod('measured_dogleg', test_measured_dogleg))
      call suite%addTest(TestMethod('no_side_force', test_no_side_force))
      call suite%addTest(TestMethod('full_gauge', test_full_gauge))
      call suite%addTest(TestMethod('fluids_at_depths', test_fluids))
      call suite%addTest(TestMethod('fidelities', test_fidelities))
      call suite%addTest(TestMethod('free_bit', test_free_bit))
      call suite%addTest(TestMethod('stiff_drag', test_stiff_drag))
   end function bent_housing_suite

   !> An element in the shape of its own arc, wherever that lies in space, has neither force nor moment.
   subroutine test_own_shape()
      real(wp), parameter :: length = 0.1_wp, angle = 3.0_wp*degree, ei = 1.7e7_wp
      type(beam_section_type) :: section
      real(wp) :: t(3), q(3), chord(3), d_i(3), d_j(3), force(12), axial, unused(12, 12)
      t = [0.6_wp, 0.0_wp, 0.8_wp]
      q = [-0.8_wp*cos(0.7_wp), sin(0.7_wp), 0.6_wp*cos(0.7_wp)]
      chord = t*length*sin(0.5_wp*angle)/(0.5_wp*angle)
      d_i = cos(0.5_wp*angle)*t - sin(0.5_wp*angle)*q
      d_j = cos(0.5_wp*angle)*t + sin(0.5_wp*angle)*q
      section = beam_section_type(length=length, membrane_length=membrane_length(chord, d_i, d_j), ea=5.0e9_wp, ei=ei)
      call beam_force(section, chord, d_i, d_j, force, axial)
      call assertRelativelyEqual(ei*angle/length, norm2(cross(d_i, force(4:6))), 1.0e-3_wp, message='a straight one is bent')
      call add_bend(bend_moment(ei, length, angle), q + 0.3_wp*t, chord, d_i, d_j, .false., force, unused)
      call assertLessThan(norm2(cross(d_i, force(4:6)))/(ei*angle/length), exact, message='moment at its upper end')
      call assertLessThan(norm2(cross(d_j, force(10:12)))/(ei*angle/length), exact, message='moment at its lower end')
      call assertLessThan(norm2(force(7:9))/(ei*angle/length**2), exact, message='force')
   end subroutine test_own_shape

   !> Tangent against central differences of the force, force against those of the energy, in a shape that is not its own; what
   !> holds the bend has no part along its direction, and none across the plane of that and the chord.
   subroutine test_tangent()
      real(wp), parameter :: moment = 4.0e6_wp, held(3) = [0.2_wp, 1.0_wp, -0.3_wp]
      real(wp) :: y(12), force(12), plus(12), minus(12), tangent(12, 12), differences(12, 12), unused(12, 12), by_energy(12), &
                  holding(3), chord(3)
      integer :: i
      y = [0.01_wp, -0.02_wp, 0.03_wp, 0.02_wp, -0.01_wp, 1.0_wp, 0.05_wp, 0.02_wp, 0.531_wp, -0.015_wp, 0.04_wp, 0.99_wp]
      force = 0.0_wp
      tangent = 0.0_wp
      call add_bend(moment, held, y(7:9) - y(1:3), y(4:6), y(10:12), .true., force, tangent)
      do i = 1, 12
         plus = shifted(i, step)
         minus = shifted(i, -step)
         differences(:, i) = (plus - minus)/(2.0_wp*step)
         by_energy(i) = (energy(i, step) - energy(i, -step))/(2.0_wp*step)
      end do
      call assertLessThan(maxval(abs(differences - tangent))/maxval(abs(tangent)), by_differences, message='tangent')
      call assertLessThan(maxval(abs(tangent - transpose(tangent)))/maxval(abs(tangent)), exact, message='symmetric')
      call assertLessThan(maxval(abs(by_energy - force))/maxval(abs(force)), by_differences, message='force')
      chord = y(7:9) - y(1:3)
      holding = holding_moment(moment, held, chord, y(4:6), y(10:12))
      call assertLessThan(abs(dot_product(holding, held)), exact*moment, message='held across its direction')
      call assertLessThan(abs(dot_product(holding, cross(held, chord))), exact*moment, message='held in their plane')
      call assertTrue(norm2(holding) > 0.0_wp, message='held')
   contains
      function shifted(index, amount) result(f)
         integer, intent(in) :: index
         real(wp), intent(in) :: amount
         real(wp) :: f(12), z(12)
         z = y
         z(index) = z(index) + amount
         f = 0.0_wp
         unused = 0.0_wp
         call add_bend(moment, held, z(7:9) - z(1:3), z(4:6), z(10:12), .false., f, unused)
      end function shifted

      function energy(index, amount) result(u)
         integer, intent(in) :: index
         real(wp), intent(in) :: amount
         real(wp) :: u, z(12), e(3), q(3)
         z = y
         z(index) = z(index) + amount
         e = (z(7:9) - z(1:3))/norm2(z(7:9) - z(1:3))
         q = held - dot_product(held, e)*e
         u = -moment*dot_product(q/norm2(q), z(10:12) - z(4:6))
      end function energy
   end subroutine test_tangent

   !> A motor in a hole of 8-1/2 in: bit, stabilizer with blades of `piece` m, housing with its bend 1.6 m above the bit, an upper
   !> stabilizer under gauge, collars.
   subroutine build(well, bottom_gauge, model)
      type(independent_well_type), intent(inout) :: well     !< its hole and loads are given
      real(wp), intent(in) :: bottom_gauge                   !< diameter of the lower stabilizer [m]
      type(model_type), intent(out) :: model
      character(10), parameter :: kinds(6) = [character(10) :: 'collar', 'stabilizer', 'collar', 'stabilizer', 'collar', 'collar']
      integer :: i
      well%length = [0.61_wp, 0.2_wp, 7.2_wp, 0.2_wp, 20.0_wp, 0.0_wp]      ! ends between two nodes of the reference
      well%od = [0.16_wp, 0.1714_wp, 0.1714_wp, 0.165_wp, 0.165_wp, 0.127_wp]
      well%id = [0.05_wp, 0.08_wp, 0.08_wp, 0.0714_wp, 0.0714_wp, 0.0762_wp]
      well%joint = [0.0_wp, bottom_gauge, 0.0_wp, 0.2096_wp, 0.0_wp, 0.0_wp]
      well%mass = [140.0_wp, 140.0_wp, 140.0_wp, 136.0_wp, 136.0_wp, 73.4_wp]
      well%diameter = 0.2159_wp
      well%mud = 1200.0_wp
      well%step = 0.004_wp
      well%wall = 1.0e10_wp
      well%bend_above = 1.6_wp
      call new_well(model, well%md, well%inclination, well%azimuth, well%diameter, abs(well%along) + well%around, &
                    part(kinds(1), 0.0_wp, well%od(1), well%id(1), well%mass(1), 0.0_wp))
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(size(well%od)))
      do i = 1, size(well%od)
         model%strings(1)%components(i) = part(trim(kinds(i)), well%length(i), well%od(i), well%id(i), well%mass(i), well%joint(i))
      end do
      model%strings(1)%components(3)%bend = well%bend
      model%strings(1)%components(3)%bend_position = well%bend_above - sum(well%length(1:2))
      model%cases(1)%bit_depth = well%bit
      model%cases(1)%toolface = well%toolface
      model%mud = standing_mud(well%mud)
      model%gravity = well%gravity
      call hold_ends(model)
      model%numerics = settings_of('auto')
      model%numerics%gk_contact = well%wall
      model%numerics%gk_max = well%wall
   end subroutine build

   subroutine compare(well, bottom_gauge, operation, what)
      type(independent_well_type), intent(inout) :: well
      real(wp), intent(in) :: bottom_gauge
      integer, intent(in) :: operation
      character(*), intent(in) :: what
      type(independent_beam_type) :: beam
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: push(2), slope(2), largest
      logical :: found
      call build(well, bottom_gauge, model)
      call bend_independently(well, beam, found)
      call assertTrue(found, message=what//': reference')
      call solve(model, operation, well%wob, 0.0_wp, result, what)
      call push_at_bit(beam, push, slope)
      largest = maxval(norm2(beam%moment, dim=1))
      call note(what//': side force of the bit [N]', norm2(push))
      call note(what//': tilt of the bit, deg', norm2(slope)/degree)
      push = result%bit_side_force*direction(result%bit_side_clock)/norm2(push) - push/norm2(push)
      slope = tan(result%bit_tilt)*direction(result%bit_tilt_clock)/well%bend - slope/well%bend
      call note(what//': side force off', norm2(push))
      call note(what//': tilt off, over the bend', norm2(slope))
      call note(what//': largest moment over the other', maxval(result%profile%bending)/largest - 1.0_wp)
      call assertLessThan(norm2(push), force_within, message=what//': side force')
      call assertLessThan(norm2(slope), tilt_within, message=what//': tilt')
      call assertRelativelyEqual(largest, maxval(result%profile%bending), moment_within, message=what//': largest moment')
   end subroutine compare

   pure function direction(clock) result(n)
      real(wp), intent(in) :: clock
      real(wp) :: n(2)
      n = [cos(clock), sin(clock)]
   end function direction

   !> A well of 60 m, straight.
   pure function straight(inclination, bend, toolface) result(well)
      real(wp), intent(in) :: inclination, bend, toolface    !< [deg]
      type(independent_well_type) :: well
      well%md = [0.0_wp, 60.0_wp]
      well%inclination = [inclination, inclination]
      well%azimuth = [30.0_wp, 30.0_wp]
      well%bit = 60.0_wp
      well%wob = 50.0e3_wp
      well%bend = bend*degree
      well%toolface = toolface*degree
   end function straight

   !> Toolfaces all round, bends of 1 to 2 deg, with a lower stabilizer of full gauge and one under gauge.
   subroutine test_toolfaces()
      type(independent_well_type) :: well
      integer :: i
      do i = 0, 4
         well = straight(40.0_wp, 1.5_wp, 60.0_wp*i)
         call compare(well, 0.2127_wp, operation_static, 'full gauge')
      end do
      well = straight(80.0_wp, 1.0_wp, 20.0_wp)
      call compare(well, 0.2032_wp, operation_static, 'under gauge')
      well = straight(20.0_wp, 2.0_wp, 160.0_wp)
      call compare(well, 0.0_wp, operation_static, 'no lower stabilizer')
   end subroutine test_toolfaces

   subroutine test_sliding()
      type(independent_well_type) :: well
      well = straight(60.0_wp, 1.5_wp, 45.0_wp)
      well%along = -0.25_wp
      call compare(well, 0.2127_wp, operation_sliding_drilling, 'sliding')
   end subroutine test_sliding

   !> A hole that builds and turns by 6 deg/30 m or so.
   subroutine test_curved_hole()
      type(independent_well_type) :: well
      well = straight(30.0_wp, 1.5_wp, 30.0_wp)
      well%inclination = [30.0_wp, 40.0_wp]
      well%azimuth = [30.0_wp, 40.0_wp]
      call compare(well, 0.2127_wp, operation_static, 'curved hole')
   end subroutine test_curved_hole

   !> A string that turns is seen without its bend, unless it is asked to stand.
   subroutine test_turning()
      type(independent_well_type) :: well
      type(model_type) :: model
      type(case_result_type) :: without, turning, standing
      well = straight(40.0_wp, 0.0_wp, 0.0_wp)
      call build(well, 0.2127_wp, model)
      call solve(model, operation_rotary_drilling, 50.0e3_wp, 0.0_wp, without, 'straight')
      model%strings(1)%components(3)%bend = 1.5_wp*degree
      call solve(model, operation_rotary_drilling, 50.0e3_wp, 0.0_wp, turning, 'turning')
      call assertRelativelyEqual(without%bit_side_force, turning%bit_side_force, 1.0e-3_wp, message='as if straight')
      model%cases(1)%bend_stands = .true.
      call solve(model, operation_rotary_drilling, 50.0e3_wp, 0.0_wp, standing, 'standing')
      call assertTrue(standing%bit_side_force > 5.0_wp*turning%bit_side_force, message='seen at one toolface')
      call assertEqual(0.0_wp, modulo(standing%bit_side_clock + pi, 2.0_wp*pi) - pi, 0.1_wp, message='towards it')
   end subroutine test_turning

   !> A motor almost without weight under a limp string: where its bit has no side force nothing bends it, and bit and both blades
   !> lie on the hole's arc, 1/R = 2 bend/(L1 + L2), towards any toolface. Play of 0.3 mm at blades of 5 cm leaves 1 % of it open.
   subroutine test_three_points()
      real(wp), parameter :: first = 2.0_wp, second = 7.0_wp, blade = 0.05_wp, bend = 1.0_wp*degree, bend_length = 0.1_wp
      real(wp), parameter :: gauge = 0.2153_wp, toolfaces(3) = [0.0_wp, 70.0_wp*degree, 180.0_wp*degree]
      type(independent_well_type) :: well
      type(model_type) :: model
      type(steering_result_type) :: found
      real(wp) :: expected, room, within
      integer :: i
      well = straight(40.0_wp, 0.0_wp, 0.0_wp)
      call build(well, gauge, model)
      model%gravity = 0.5_wp
      model%mud = standing_mud(0.0_wp)
      model%numerics = settings_of('auto')
      associate (parts => model%strings(1)%components)
         parts%length = [first - 0.5_wp*blade, blade, second - blade, blade, 0.0_wp, 0.0_wp]
         parts(3)%bend = 0.0_wp
         parts(2)%bend = bend
         parts(2)%bend_position = 0.5_wp*blade
         parts(4)%joint_od = gauge
         parts(5)%length = 1.0_wp
         parts(5:)%od = 0.05_wp
         parts(5:)%id = 0.03_wp
         parts(5:)%youngs = 2.0e10_wp
         parts(5:)%mass = 10.0_wp
      end associate
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = 1.0e3_wp
      expected = 2.0_wp*bend/(first + second)
      ! a string that nearly floats may lie anywhere within its blades' clearance, and the bent blade touches with its ends
      room = 0.5_wp*(well%diameter - gauge) + 0.125_wp*blade**2*bend/bend_length
      within = 0.015_wp + 2.0_wp*room*(1.0_wp + (first + second)/first)/((first + second)*second)/expected
      do i = 1, size(toolfaces)
         call find_equilibrium_curvature(model, 1, toolfaces(i), 60.0_wp, optional_real(), found)
         call assertTrue(found%found, message='three points: '//found%message)
         call assertRelativelyEqual(expected - (well%diameter - gauge)*(1.0_wp + (first + second)/first)/ &
                                    ((first + second)*second), found%three_points, 1.0e-9_wp, message='three points')
         if (.not. found%found) cycle
         call note('off, over the curvature of three points', norm2(found%curvature/expected - direction(toolfaces(i))))
         call assertLessThan(norm2(found%curvature/expected - direction(toolfaces(i))), within, message='three points')
      end do
   end subroutine test_three_points

   !> The side cutting that a measured dogleg gives is the one by which that dogleg was found. A hole enlarged above the bit is a
   !> wider hole whose bit fills it.
   subroutine test_measured_dogleg()
      real(wp), parameter :: cut = 0.005_wp, enlargement = 0.006_wp
      type(independent_well_type) :: well
      type(model_type) :: model
      type(steering_result_type) :: drilled, fitted, enlarged
      well = straight(40.0_wp, 1.5_wp, 0.0_wp)
      call build(well, 0.2127_wp, model)
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = well%wob
      call find_equilibrium_curvature(model, 1, 0.0_wp, well%bit, given(cut), drilled)
      call find_equilibrium_curvature(model, 1, 0.0_wp, well%bit, optional_real(), fitted, measured=drilled%curvature(1))
      call assertTrue(drilled%found .and. fitted%found, message='found')
      call note('side cutting over the true one - 1', fitted%side_cutting/cut - 1.0_wp)
      call assertRelativelyEqual(cut, fitted%side_cutting, 0.02_wp, message='side cutting')
      call find_equilibrium_curvature(model, 1, 0.0_wp, well%bit, optional_real(), enlarged, measured=2.0_wp*drilled%curvature(1))
      call assertTrue(is_missing(enlarged%side_cutting), message='sharper than without side force')
      call assertEqual(1, index(enlarged%message, 'no side_cutting above 0 gives the measured dogleg of '))
      call assertTrue(enlarged%reach(1) < drilled%curvature(1) .and. drilled%curvature(1) < enlarged%reach(2), message='reach')
      call assertRelativelyEqual(fitted%curvature(1), enlarged%reach(2), 1.0e-9_wp, message='without side force')
      call find_equilibrium_curvature(model, 1, 0.0_wp, well%bit, optional_real(), enlarged, enlargement=enlargement)
      call note('curvature enlarged over in gauge', enlarged%curvature(1)/fitted%curvature(1))
      call assertTrue(abs(enlarged%curvature(1) - fitted%curvature(1)) > 0.01_wp*fitted%curvature(1), message='enlargement counts')
      associate (bit => model%strings(1)%components(1))
         bit%joint_od = closed_diameter(bit) + enlargement
      end associate
      model%holes(1)%diameter = model%holes(1)%diameter + enlargement
      call find_equilibrium_curvature(model, 1, 0.0_wp, well%bit, optional_real(), fitted)
      call assertRelativelyEqual(fitted%curvature(1), enlarged%curvature(1), 1.0e-9_wp, message='enlarged hole')
      call assertRelativelyEqual(fitted%three_points, enlarged%three_points, 1.0e-9_wp, message='three points')
   end subroutine test_measured_dogleg

   !> A motor as it is: in the hole as it is force and tilt are the independent string's. In a hole of the curvature found that
   !> string's bit has no side force, to a five-hundredth of what it has in the straight hole; where it cuts sideways, tilt and cut
   !> of its side force cancel to as much.
   subroutine test_no_side_force()
      real(wp), parameter :: cuts(2) = [0.0_wp, 0.005_wp], none(2) = [0.002_wp, 0.002_wp]    ! seen: 0.03 %, 0.06 %
      type(independent_well_type) :: well
      type(independent_beam_type) :: beam
      type(model_type) :: model
      type(steering_result_type) :: result
      type(optional_real) :: side_cutting
      real(wp) :: push(2), slope(2), wants(2), left(2), tilt(2), builds(2)
      integer :: i
      logical :: found
      well = straight(40.0_wp, 1.5_wp, 50.0_wp)
      call build(well, 0.2127_wp, model)
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = well%wob
      call bend_independently(well, beam, found)
      call push_at_bit(beam, push, slope)
      do i = 1, size(cuts)
         if (cuts(i) > 0.0_wp) side_cutting = given(cuts(i))
         call find_equilibrium_curvature(model, 1, well%toolface, well%bit, side_cutting, result)
         call assertTrue(result%found, message=result%message)
         if (.not. result%found) return
         call note('solutions', real(result%solutions, wp))
         call assertLessThan(norm2(result%side_force - push), force_within*norm2(push), message='side force')
         call assertLessThan(norm2(result%tilt - slope), tilt_within*well%bend, message='tilt')
         builds(i) = norm2(result%curvature)
         call note('curvature, deg/30 m', builds(i)/degree*30.0_wp)
         call bend_independently(along_arc(well, result%curvature), beam, found)
         call assertTrue(found, message='reference in the curved hole')
         wants = push
         call push_at_bit(beam, left, tilt)
         if (cuts(i) > 0.0_wp) then
            left = tilt + cuts(i)*left/well%wob
            wants = slope + cuts(i)*push/well%wob
         end if
         call note('left over what the bit wants in the straight hole', norm2(left)/norm2(wants))
         call assertLessThan(norm2(left), none(i)*norm2(wants), message='none left')
      end do
      call assertTrue(abs(builds(2) - builds(1)) > 0.05_wp*builds(1), message='side cutting counts')
   end subroutine test_no_side_force

   !> The curvature is sought in the fluids that the assembly lies in, wherever these begin.
   subroutine test_fluids()
      type(independent_well_type) :: well
      type(model_type) :: model
      type(steering_result_type) :: all_along, from_depth
      well = straight(40.0_wp, 1.5_wp, 135.0_wp)
      well%md(2) = 400.0_wp
      well%bit = 400.0_wp
      call build(well, 0.2127_wp, model)
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = well%wob
      model%mud = standing_mud(1400.0_wp)
      call find_equilibrium_curvature(model, 1, well%toolface, 60.0_wp, optional_real(), all_along)
      model%mud%fluids = [fluid_type(density=1000.0_wp), fluid_type(density=1400.0_wp, md_top=well%bit - 70.0_wp)]
      call find_equilibrium_curvature(model, 1, well%toolface, 60.0_wp, optional_real(), from_depth)
      call assertTrue(all_along%found .and. from_depth%found)
      call assertEqual(all_along%side_force, from_depth%side_force, 1.0e-6_wp*norm2(all_along%side_force), message='side force')
   end subroutine test_fluids

   !> A bit as wide as its hole, held at its lower end, does not hold the string by its gauge: the curvature is that of a bit that
   !> touches nowhere else, and hangs little on the wall. Held along its gauge it was, in the sample deck, 11 deg/30 m
   !> at the usual wall, 3 at a stiff one.
   subroutine test_full_gauge()
      real(wp), parameter :: walls(2) = [1.0e8_wp, 1.0e12_wp], alike = 1.0e-3_wp, wall_counts = 0.03_wp
      type(independent_well_type) :: well
      type(model_type) :: model
      type(steering_result_type) :: wide, slender
      real(wp) :: builds(2)
      integer :: i
      do i = 1, size(walls)
         well = straight(40.0_wp, 1.5_wp, 135.0_wp)
         call build(well, 0.2127_wp, model)
         model%cases(1)%operation = operation_static
         model%cases(1)%wob = well%wob
         model%numerics%gk_contact = walls(i)
         model%numerics%gk_max = max(walls(i), rigid)
         call find_equilibrium_curvature(model, 1, well%toolface, well%bit, optional_real(), slender)
         model%strings(1)%components(1)%kind = 'bit'
         model%strings(1)%components(1)%joint_od = well%diameter
         call find_equilibrium_curvature(model, 1, well%toolface, well%bit, optional_real(), wide)
         call assertTrue(slender%found .and. wide%found, message='found')
         if (.not. (slender%found .and. wide%found)) return
         builds(i) = norm2(wide%curvature)
         call note('curvature, deg/30 m', builds(i)/degree*30.0_wp)
         call assertLessThan(norm2(wide%curvature - slender%curvature), alike*builds(i), message='its gauge does not hold it')
      end do
      call assertRelativelyEqual(builds(1), builds(2), wall_counts, message='wall')
   end subroutine test_full_gauge

   !> A motor at rest whose bit is free, and as wide as the hole or 0.8 mm less: the bend tilts it until both its ends press on the
   !> wall. In a vertical hole its top is free, too, and nothing else holds it off the axis. The hook carries the weight along the
   !> hole. While a bit was one element with one gap, a third of such motors found no equilibrium.
   subroutine test_free_bit()
      real(wp), parameter :: inclinations(3) = [0.0_wp, 40.0_wp, 85.0_wp], bends(3) = [0.8_wp, 1.2_wp, 1.8_wp]
      real(wp), parameter :: depth = 1500.0_wp, diameter = 0.3111_wp, play(2) = [0.0_wp, 0.8e-3_wp], under_gauge = 3.0e-3_wp
      integer, parameter :: most = 60           ! up to 26 are seen
      type(model_type) :: model
      type(component_type) :: parts(5)
      type(case_result_type) :: result
      character(60) :: what
      integer :: i, b, k, n, blades
      do i = 1, size(inclinations)
         do b = 1, size(bends)
            do k = 1, size(play)
               do blades = 0, 1
                  write (what, '(2(f4.1, a), f4.1, a, i0)') inclinations(i), ' deg ', bends(b), ', play ', 1.0e3_wp*play(k), &
                     ' mm, blades ', blades
                  call new_well(model, [0.0_wp, depth], spread(inclinations(i), 1, 2), [0.0_wp, 0.0_wp], diameter, 0.3_wp, &
                                part('drillpipe', 0.0_wp, 0.1397_wp, 0.1214_wp, 38.4_wp, 0.1842_wp))
                  parts(1) = part('bit', 0.1_wp, 0.2032_wp, 0.05_wp, 200.0_wp, diameter - play(k))
                  parts(2) = part('motor', 8.0_wp, 0.2032_wp, 0.08_wp, 215.0_wp, 0.0_wp)
                  parts(2)%bend = bends(b)*degree
                  parts(2)%bend_position = 2.0_wp
                  parts(3) = part('stabilizer', 1.5_wp, 0.2032_wp, 0.0714_wp, 223.0_wp, &
                                  merge(diameter - under_gauge, 0.0_wp, blades == 1))
                  parts(4) = part('collar', 30.0_wp, 0.2032_wp, 0.0714_wp, 223.0_wp, 0.0_wp)
                  parts(5) = model%strings(1)%components(1)
                  deallocate (model%strings(1)%components)
                  allocate (model%strings(1)%components(5))
                  do n = 1, 5
                     model%strings(1)%components(n) = parts(n)
                  end do
                  model%cases(1)%toolface = 0.5_wp*pi
                  model%boundary%top_centred = inclinations(i) > 0.0_wp
                  call solve(model, operation_static, 0.0_wp, 0.0_wp, result, trim(what))
                  call assertRelativelyEqual(string_weight(model)*cos(inclinations(i)*degree), result%hookload, 1.0e-7_wp, &
                                             message=trim(what))
                  call assertLessThan(result%iterations, most, message=trim(what))
               end do
            end do
         end do
      end do
   end subroutine test_free_bit

   !> A motor that slides, its bend so sharp that contact of some hundred kN holds it in the hole. Friction of that compresses the
   !> pipe above into coils, which neither weight nor weight on bit do. Without it in mesh and start no equilibrium was found in
   !> 1,300 iterations. Above the assembly the axial force is that of the soft string with this friction, to the 5 % of a start.
   subroutine test_stiff_drag()
      real(wp), parameter :: depth = 707.0_wp, friction(2) = [0.35_wp, 0.30_wp], inclination(2) = [45.0_wp, 60.0_wp]
      real(wp), parameter :: bend(2) = [2.2_wp, 2.4_wp], above = depth - 30.0_wp, alike = 0.1_wp
      integer, parameter :: most = 60           ! 34 are seen
      type(model_type) :: model, known
      type(case_result_type) :: result
      real(wp) :: axial(1), torque(1), found
      integer :: i, n
      do i = 1, 2
         call new_well(model, [0.0_wp, 390.0_wp, 480.0_wp, depth], [0.0_wp, 0.0_wp, inclination(i), inclination(i)], &
                       spread(0.0_wp, 1, 4), 0.2159_wp, friction(i), &
                       part('drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 27.2_wp, 0.1683_wp))
         model%strings(1)%components = [part('bit', 0.3_wp, 0.1651_wp, 0.0714_wp, 116.6_wp, 0.2159_wp), &
                                        part('motor', 8.5_wp, 0.1651_wp, 0.0714_wp, 93.3_wp, 0.0_wp), &
                                        part('stabilizer', 1.5_wp, 0.1651_wp, 0.0714_wp, 116.6_wp, 0.2127_wp), &
                                        part('drillpipe', 175.0_wp, 0.127_wp, 0.0762_wp, 62.6_wp, 0.1651_wp), &
                                        model%strings(1)%components(1)]
         model%strings(1)%components(2)%bend = bend(i)*degree
         model%strings(1)%components(2)%bend_position = 1.1_wp
         model%cases(1)%toolface = 83.0_wp*degree
         call solve(model, operation_sliding_drilling, 40.0e3_wp, 2.0e3_wp, result, 'stiff drag')
         call assertLessThan(result%iterations, most, message='iterations')
         model%cases(1)%wob = 40.0e3_wp
         known = model
         call find_stiff_drag(model, 1, known%stiff_drag, known%stiff_share)
         call soft_string_at(known, 1, [above], axial, torque)
         n = minloc(abs(result%profile%md - above), dim=1)
         found = result%profile%axial(n)
         call note('friction of the assembly [N]', known%stiff_drag)
         call note('axial force above it, over the expected one, less one', found/axial(1) - 1.0_wp)
         call assertRelativelyEqual(axial(1), found, alike, message='axial force above the assembly')
         call soft_string_at(model, 1, [above], axial, torque)
         call assertLessThan(found, 3.0_wp*axial(1), message='most of it is friction of the assembly')
      end do
   end subroutine test_stiff_drag

   !> Side force and tilt of `auto` against those of `reference`, at the usual wall and at a stiff one, with the bend in a blade.
   subroutine test_fidelities()
      real(wp), parameter :: walls(2) = [1.0e8_wp, 1.0e10_wp], alike = 5.0e-3_wp
      type(independent_well_type) :: well
      type(model_type) :: model
      type(case_result_type) :: quick, fine
      integer :: i, k
      do i = 1, size(walls)
         do k = 0, 2
            well = straight(40.0_wp, 1.5_wp, 60.0_wp*k)
            call build(well, 0.2127_wp, model)
            model%strings(1)%components(1)%length = 1.7_wp
            model%strings(1)%components(2)%length = 0.4_wp
            model%strings(1)%components(2)%bend = well%bend           ! in the middle of the blade
            model%strings(1)%components(2)%bend_position = 0.2_wp
            model%strings(1)%components(3)%bend = 0.0_wp
            model%numerics%gk_contact = walls(i)
            model%numerics%gk_max = max(walls(i), rigid)
            call solve(model, operation_static, well%wob, 0.0_wp, quick, 'auto')
            model%numerics = settings_of('reference')
            model%numerics%gk_contact = walls(i)
            model%numerics%gk_max = max(walls(i), rigid)
            call solve(model, operation_static, well%wob, 0.0_wp, fine, 'reference')
            call note('side force off', quick%bit_side_force/fine%bit_side_force - 1.0_wp)
            call note('tilt off', quick%bit_tilt/fine%bit_tilt - 1.0_wp)
            call assertRelativelyEqual(fine%bit_side_force, quick%bit_side_force, alike, message='side force')
            call assertRelativelyEqual(fine%bit_tilt, quick%bit_tilt, alike, message='tilt')
         end do
      end do
   end subroutine test_fidelities

   !> The well in a hole that ends at the bit as it does, along an arc of a curvature [1/m] (towards the high side, to the right).
   pure function along_arc(well, curvature) result(curved)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: curvature(2)
      type(independent_well_type) :: curved
      real(wp) :: i, a, t(3), up(3), right(3), tangent(3), angle, bends
      integer :: n
      i = well%inclination(2)*degree
      a = well%azimuth(2)*degree
      t = [sin(i)*cos(a), sin(i)*sin(a), cos(i)]
      up = [cos(i)*cos(a), cos(i)*sin(a), -sin(i)]
      right = cross(t, up)
      bends = norm2(curvature)
      curved = well
      curved%md = [0.0_wp, 0.5_wp*well%bit, well%bit]
      curved%inclination = [0.0_wp, 0.0_wp, 0.0_wp]
      curved%azimuth = curved%inclination
      do n = 1, 3
         angle = (well%bit - curved%md(n))*bends
         tangent = cos(angle)*t - sin(angle)*(curvature(1)*up + curvature(2)*right)/bends
         curved%inclination(n) = atan2(hypot(tangent(1), tangent(2)), tangent(3))/degree
         curved%azimuth(n) = atan2(tangent(2), tangent(1))/degree
      end do
   end function along_arc
end module dg_test_bent_housing
