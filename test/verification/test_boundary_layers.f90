!> Moments at the default settings against closed forms: where a bend begins, in long bends and in straight hole, between tool
!> joints.
!>
!> Where a hole's curvature jumps from 0 to 1/R the string cannot follow: it leaves the wall. Free and under tension T its curvature
!> k obeys EI k'' = T k + w, w the weight across the hole, and it begins and ends where the string touches the wall again with the
!> wall's slope and curvature. The default wall yields: about the places where the string meets it, over (4 EI/stiffness)^(1/4), the
!> corner of a stiff wall's moment is round, and rows there are left out.
module dg_test_boundary_layers
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type
   use dg_component, only: axial_stiffness, bending_stiffness, component_type
   use dg_constants, only: degree, pi
   use dg_fluid, only: standing_mud
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_static, operation_trip_in, operation_trip_out
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_test_wells, only: hold_ends, new_well, note, part, pipe, solve
   implicit none
   private
   public :: boundary_layers_suite

   !> Over the moment EI/R of the bend: every row of a boundary layer, rows of long bends, rows of straight hole.
   real(wp), parameter :: layer_within = 0.02_wp, bend_within = 0.01_wp, straight_within = 0.01_wp
   !> Over the closed form: the peak under a tool joint, smeared and joint by joint.
   real(wp), parameter :: joint_within = 0.03_wp, smeared_within = 0.05_wp
   real(wp), parameter :: hole = 0.2159_wp, od = 0.127_wp, id = 0.1086_wp   !< [m]

contains

   function boundary_layers_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('boundary_layers')
      call suite%addTest(TestMethod('touches_in_a_bend', test_touch))
      call suite%addTest(TestMethod('lifts_off_before_a_bend', test_lift))
      call suite%addTest(TestMethod('long_bends', test_long_bends))
      call suite%addTest(TestMethod('free_top', test_free_top))
      call suite%addTest(TestMethod('bridge_between_joints', test_joints))
      call suite%addTest(TestMethod('smeared_joints', test_smeared))
   end function boundary_layers_suite

   !> Over which a yielding wall takes a force that stands at one place [m].
   pure function round_part(model, ei) result(length)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: ei
      real(wp) :: length
      length = (4.0_wp*ei/model%numerics%gk_contact)**0.25_wp
   end function round_part

   !> Weightless pipe, held on the axis at the top, straight for L, then in an arc. It is straight up to some bending lengths 1/q,
   !> q = sqrt(T/EI), at an angle phi, bends by k = exp(q (s - b))/R and touches the inside of the bend at b after its beginning:
   !> with the hole's slope there, phi + 1/(q R) = b/R, and at the wall, phi (L + b) + 1/(q^2 R) - b^2/(2 R) = c.
   subroutine test_touch()
      real(wp), parameter :: straight = 100.0_wp, radius = 300.0_wp, pull(3) = [50.0e3_wp, 200.0e3_wp, 800.0e3_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: ei, q, b, half, off, at
      integer :: i, row, rows
      call new_well(model, [0.0_wp, straight, straight + 200.0_wp], [0.0_wp, 0.0_wp, 200.0_wp/radius/degree], &
                    spread(0.0_wp, 1, 3), hole, 0.0_wp, pipe(0.0_wp, od, id))
      model%numerics = settings_of('auto')
      model%boundary%top_centred = .true.
      ei = bending_stiffness(model%strings(1)%components(1))
      do i = 1, size(pull)
         call solve(model, operation_static, -pull(i), 0.0_wp, result, 'touches in a bend')
         q = sqrt(pull(i)/ei)
         half = straight - 1.0_wp/q
         b = sqrt(half**2 + 2.0_wp*(straight/q - 1.0_wp/q**2 + radius*0.5_wp*(hole - od))) - half
         off = 0.0_wp
         rows = 0
         do row = 1, size(result%profile%md)
            at = result%profile%md(row)*(1.0_wp + pull(i)/axial_stiffness(model%strings(1)%components(1))) - straight
            if (at > 100.0_wp) exit
            if (abs(at - b) < round_part(model, ei)) cycle
            if (abs(at - b) < 3.0_wp/q) rows = rows + 1
            off = max(off, abs(result%profile%bending(row)*radius/ei - exp(min(q*(at - b), 0.0_wp))))
         end do
         call note('pull', pull(i))
         call note('touches below the beginning of the bend', b)
         call note('moment off, over EI/R', off)
         call assertLessThan(off, layer_within, message='moment')
         call assertGreaterThan(rows, 5, message='rows in the layer')
      end do
   end subroutine test_touch

   !> Heavy pipe that lies on the low side, in straight hole, then in a bend downwards. Before the bend it lifts off, since it could
   !> bend towards the bend on the wall only through it. From where it does, k = p (cosh qx - 1) + d sinh qx, p = w/T. Where it lies
   !> down again, after the length l and b after the beginning of the bend, it has the bend's curvature, slope and place: d, b
   !> and l follow.
   subroutine test_lift()
      real(wp), parameter :: jump = 400.0_wp, radius(2) = [300.0_wp, 100.0_wp], weight = 250.0_wp, inclination = 60.0_wp*degree
      real(wp), parameter :: turn = 30.0_wp*degree, tension = 300.0e3_wp
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: component
      real(wp) :: ei, q, p, d, b, l, low, high, off, at, x, k, gap, expected
      integer :: i, row, rows
      component = pipe(weight, od, id)
      ei = bending_stiffness(component)
      q = sqrt(tension/ei)
      p = weight*sin(inclination)/tension
      do i = 1, size(radius)
         call new_well(model, [0.0_wp, jump, jump + turn*radius(i)], [inclination, inclination, inclination - turn]/degree, &
                       spread(0.0_wp, 1, 3), hole, 0.0_wp, component)
         model%numerics = settings_of('auto')
         call solve(model, operation_static, -tension + weight*radius(i)*(sin(inclination) - sin(inclination - turn)), 0.0_wp, &
                    result, 'lifts off before a bend')
         low = 1.0_wp/q
         high = 30.0_wp/q
         do while (high - low > 1.0e-9_wp)
            l = 0.5_wp*(low + high)
            if (place_off(l) < 0.0_wp) high = l
            if (place_off(l) >= 0.0_wp) low = l
         end do
         off = 0.0_wp
         rows = 0
         gap = 0.0_wp
         do row = 1, size(result%profile%md)
            at = result%profile%md(row) - jump
            if (abs(at) > 30.0_wp) cycle
            ! the top is held: the string has slid down by its stretch
            at = at + (result%profile%md(row)*(result%hookload - 0.5_wp*weight*cos(inclination)*result%profile%md(row))) &
                 /axial_stiffness(component)
            x = min(max(at + l - b, 0.0_wp), l)
            k = p*(cosh(q*x) - 1.0_wp) + d*sinh(q*x)
            if (x > 0.0_wp .and. x < l) rows = rows + 1
            expected = abs(k)*radius(i)
            if (at < 0.0_wp .and. .not. x > 0.0_wp) expected = 0.0_wp
            if (min(abs(at + l - b), abs(at - b)) > round_part(model, ei)) &
               off = max(off, abs(result%profile%bending(row)*radius(i)/ei - expected))
            expected = p*((cosh(q*x) - 1.0_wp)/q**2 - 0.5_wp*x**2) + d*(sinh(q*x)/q**2 - x/q)
            if (x > l - b) expected = expected - 0.5_wp*(x - l + b)**2/radius(i)
            gap = max(gap, abs(0.5_wp*(hole - od) - result%profile%displacement(row) + expected))
         end do
         call note('lies down after', l)
         call note('begins before the bend', l - b)
         call note('moment off, over EI/R', off)
         call note('distance from the wall off, m', gap)
         call assertLessThan(off, layer_within, message='moment')
         call assertLessThan(gap, 1.0e-4_wp, message='distance from the wall')      ! the wall yields by 5e-5
         call assertGreaterThan(rows, 5, message='rows in the layer')
      end do
   contains
      !> Distance outside the wall at which a string that is free for a length touches; d and b on the way.
      function place_off(length) result(y)
         real(wp), intent(in) :: length
         real(wp) :: y
         d = (1.0_wp/radius(i) + p - p*cosh(q*length))/sinh(q*length)
         b = radius(i)*(p*(sinh(q*length)/q - length) + d*(cosh(q*length) - 1.0_wp)/q)
         y = p*((cosh(q*length) - 1.0_wp)/q**2 - 0.5_wp*length**2) + d*(sinh(q*length)/q**2 - length/q) - 0.5_wp*b**2/radius(i)
      end function place_off
   end subroutine test_lift

   !> Pipe of five kinds on the inside of a long bend: EI/R there, nothing in the straight hole above and below.
   subroutine test_long_bends()
      character(13), parameter :: name(5) = [character(13) :: 'drill pipe', 'casing', 'tubing', 'sucker rods', 'coiled tubing']
      integer, parameter :: operations(3) = [operation_trip_out, operation_trip_in, operation_rotate_off_bottom]
      real(wp), parameter :: holes(5) = [0.2159_wp, 0.3112_wp, 0.1243_wp, 0.062_wp, 0.1_wp], away = 60.0_wp
      real(wp), parameter :: md(4) = [0.0_wp, 300.0_wp, 540.0_wp, 1140.0_wp], inc(4) = [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp]
      type(component_type) :: strings(5)
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: unit, in_bend, in_straight, deepest
      integer :: i, o, row, rows
      strings = [part('drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 31.9_wp, 0.1619_wp), &
                 part('casing', 0.0_wp, 0.2445_wp, 0.2205_wp, 69.9_wp, 0.2699_wp), &
                 part('tubing', 0.0_wp, 0.073_wp, 0.062_wp, 9.67_wp, 0.0786_wp), &
                 part('rods', 0.0_wp, 0.0222_wp, 0.0_wp, 3.2_wp, 0.046_wp), &
                 part('coiled', 0.0_wp, 0.0508_wp, 0.044_wp, 3.7_wp, 0.0_wp)]
      deepest = md(4) - 20.0_wp
      do i = 1, size(strings)
         call new_well(model, md, inc, spread(20.0_wp, 1, 4), holes(i), 0.2_wp, strings(i))
         model%numerics = settings_of('auto')
         model%mud = standing_mud(1100.0_wp)
         call hold_ends(model)
         model%cases(1)%bit_depth = deepest
         unit = bending_stiffness(strings(i))*(inc(3) - inc(2))*degree/(md(3) - md(2))
         do o = 1, size(operations)
            call solve(model, operations(o), 0.0_wp, 0.0_wp, result, trim(name(i)))
            in_bend = 0.0_wp
            in_straight = 0.0_wp
            rows = 0
            do row = 1, size(result%profile%md)
               associate (at => result%profile%md(row), moment => result%profile%bending(row)/unit)
                  if (minval(abs(at - [md(1:3), deepest])) < away) cycle
                  if (at > md(2) .and. at < md(3)) then
                     in_bend = max(in_bend, abs(moment - 1.0_wp))
                     rows = rows + 1
                  else
                     in_straight = max(in_straight, moment)
                  end if
               end associate
            end do
            call note(trim(name(i))//': moment in the bend off EI/R', in_bend)
            call note(trim(name(i))//': moment in straight hole over EI/R', in_straight)
            call assertGreaterThan(rows, 2, message=trim(name(i))//': rows in the bend')
            call assertLessThan(in_bend, bend_within, message=trim(name(i))//': bend')
            call assertLessThan(in_straight, straight_within*maxval(result%profile%bending)/unit, &
                                message=trim(name(i))//': straight')
         end do
      end do
   end subroutine test_long_bends

   !> Coiled tubing that nothing holds across a vertical hole at its top: below, all is as if it were held.
   subroutine test_free_top()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: unit
      integer :: row
      call new_well(model, [0.0_wp, 300.0_wp, 540.0_wp, 1140.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], spread(20.0_wp, 1, 4), &
                    0.1_wp, 0.2_wp, part('coiled', 0.0_wp, 0.0508_wp, 0.044_wp, 3.7_wp, 0.0_wp))
      model%numerics = settings_of('auto')
      unit = bending_stiffness(model%strings(1)%components(1))*40.0_wp*degree/240.0_wp
      call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'free top')
      do row = 1, size(result%profile%md)
         associate (at => result%profile%md(row), moment => result%profile%bending(row)/unit)
            if (minval(abs(at - [300.0_wp, 540.0_wp, 1140.0_wp])) < 60.0_wp) cycle
            call assertEqual(merge(1.0_wp, 0.0_wp, at > 300.0_wp .and. at < 540.0_wp), moment, bend_within, message='free top')
         end associate
      end do
   end subroutine test_free_top

   !> Weightless drill pipe in an arc of 600 m, 24 joints 9.5 m apart, under tension EI (kL/L)^2, as in dg_test_tool_joints.
   subroutine jointed(model, kl, joint_length)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: kl, joint_length
      real(wp), parameter :: depth = 24.0_wp*9.5_wp
      type(component_type) :: component
      component = pipe(0.0_wp, od, id)
      component%joint_od = 0.1683_wp
      component%joint_length = joint_length
      component%joint_spacing = 9.5_wp
      call new_well(model, [0.0_wp, depth], [0.0_wp, depth/600.0_wp/degree], [0.0_wp, 0.0_wp], hole, 0.0_wp, component)
      model%numerics = settings_of('auto')
      call hold_ends(model)
      model%cases(1)%wob = -bending_stiffness(component)*(kl/4.75_wp)**2
   end subroutine jointed

   !> Joints one by one: kL/tanh(kL) at the joint in the middle of the string. The second joint length is the usual one.
   subroutine test_joints()
      real(wp), parameter :: kl(4) = [1.0_wp, 2.0_wp, 3.0_wp, 3.8_wp], lengths(2) = [0.1_wp, 0.5_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp) :: at_joint, expected
      integer :: i, j, row
      do j = 1, size(lengths)
         do i = 1, size(kl)
            call jointed(model, kl(i), lengths(j))
            model%numerics%discrete_joints = .true.
            call solve(model, operation_static, model%cases(1)%wob, 0.0_wp, result, 'jointed')
            at_joint = maxval(result%profile%bending, mask=abs(result%profile%md - 12.0_wp*9.5_wp) < 2.0_wp)
            at_joint = at_joint*600.0_wp/bending_stiffness(model%strings(1)%components(1))
            call note('kL', kl(i))
            call note('at the joint', at_joint)
            expected = magnified(kl(i), lengths(j)/9.5_wp)
            call note('over the closed form', at_joint/expected)
            call assertRelativelyEqual(expected, at_joint, joint_within, message='at the joint')
            result%model = model_mcge
            call find_along_string(model, result, along)
            row = minloc(abs(result%profile%md - 12.0_wp*9.5_wp), dim=1)
            call note('stress in the joint over that', along%joint_von_mises(row)/stress_in_joint(model, expected))
            call assertRelativelyEqual(stress_in_joint(model, expected), along%joint_von_mises(row), joint_within, &
                                       message='stress in the joint')
         end do
      end do
   end subroutine test_joints

   !> Joints smeared along the string: EI/R, and the magnification that is told with it.
   subroutine test_smeared()
      real(wp), parameter :: kl(4) = [1.0_wp, 2.0_wp, 3.0_wp, 3.8_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      real(wp) :: at_joint, stress
      integer :: i, row
      do i = 1, size(kl)
         call jointed(model, kl(i), 0.5_wp)
         call solve(model, operation_static, model%cases(1)%wob, 0.0_wp, result, 'smeared')
         result%model = model_mcge
         call find_along_string(model, result, along)
         row = minloc(abs(result%profile%md - 12.0_wp*9.5_wp), dim=1)
         at_joint = along%magnification(row)*result%profile%bending(row)*600.0_wp &
                    /bending_stiffness(model%strings(1)%components(1))
         stress = along%jointed_bending(row)*600.0_wp/(model%strings(1)%components(1)%youngs*0.5_wp*od)
         call note('kL', kl(i))
         call note('at the joint', at_joint)
         call note('over kL/tanh(kL)', at_joint*tanh(kl(i))/kl(i))
         call assertRelativelyEqual(kl(i)/tanh(kl(i)), at_joint, smeared_within, message='magnification')
         call assertRelativelyEqual(kl(i)/tanh(kl(i)), stress, smeared_within, message='stress in the body')
         call note('stress in the joint over that', along%joint_von_mises(row)/stress_in_joint(model, magnified(kl(i), 0.0_wp)))
         call assertRelativelyEqual(stress_in_joint(model, magnified(kl(i), 0.0_wp)), along%joint_von_mises(row), smeared_within, &
                                    message='stress in the joint')
      end do
   end subroutine test_smeared

   !> Moment at a joint over EI/R. In tension a joint of length l touches with both edges, as the pipe bends more than the hole, and
   !> is as free between them as the pipe of length L - l/2 beside it: kL/(tanh(k(L - l/2)) + tanh(kl/2)), kL/tanh(kL) for a point.
   pure function magnified(kl, part) result(factor)
      real(wp), intent(in) :: kl        !< L half the distance of joints [-]
      real(wp), intent(in) :: part      !< l/(2 L) [-]
      real(wp) :: factor
      factor = kl/(tanh(kl*(1.0_wp - part)) + tanh(kl*part))
   end function magnified

   !> Tension and a moment, over EI/R, on a joint as thick as it is, with the bore of the pipe [Pa].
   function stress_in_joint(model, factor) result(stress)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: factor
      real(wp) :: stress, moment
      associate (part => model%strings(1)%components(1))
         moment = factor*bending_stiffness(part)/600.0_wp
         stress = -model%cases(1)%wob/(0.25_wp*pi*(part%joint_od**2 - part%id**2)) &
                  + moment*0.5_wp*part%joint_od/(pi/64.0_wp*(part%joint_od**4 - part%id**4))
      end associate
   end function stress_in_joint
end module dg_test_boundary_layers
