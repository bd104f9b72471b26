!> Casing on centralizers: sag between them, what bow springs yield, friction and running forces, in closed form.
!>
!> An endless row of centralizers L apart, with axial force T and side load q per metre: by symmetry the casing has the hole's
!> direction at each of them, and between two it sags off the line that joins them by (API 10D-2; Juvkam-Wold & Wu 1992)
!>   q L^4/(384 EI) 24/u^4 (u^2/2 - u (cosh u - 1)/sinh u),     u^2 = T L^2/(4 EI),
!> in compression with cos and sin. In a bend of curvature k it is the same with q = w sin(theta) - T k in a build, in the frame of
!> the hole: the line that joins centralizers is then the hole's own.
module dg_test_centralizers
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, contact_centralizer
   use dg_centralizer, only: centralizer_type
   use dg_component, only: bending_stiffness
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_static, operation_trip_in, operation_trip_out
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_profile, only: profile_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_test_wells, only: new_well, note, pipe, solve
   implicit none
   private
   public :: centralizers_suite

   real(wp), parameter :: od = 0.244475_wp, bore = 0.2205_wp    !< of 9-5/8 in casing [m]
   real(wp), parameter :: w = 577.0_wp                          !< its weight in mud [N/m]
   real(wp), parameter :: hole = 0.3111_wp, blades = 0.298_wp   !< diameters of hole and rigid centralizers [m]
   real(wp), parameter :: span = 12.0_wp
   integer, parameter :: spans = 20
   real(wp), parameter :: depth = spans*span
   real(wp), parameter :: clearance = 0.5_wp*(hole - od)
   !> Asked for 1 %. Seen: 3e-5 in a straight hole, in compression, and 1.1e-4 in a bend.
   real(wp), parameter :: within = 1.0e-3_wp
   integer, parameter :: soft = 1, rigid = 2, mixed = 3, beams = 4

contains

   function centralizers_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('centralizers')
      call suite%addTest(TestMethod('sag_in_a_straight_hole', test_straight))
      call suite%addTest(TestMethod('sag_in_a_bend', test_bend))
      call suite%addTest(TestMethod('sag_along_a_casing_run', test_casing_run))
      call suite%addTest(TestMethod('bow_springs', test_bows))
      call suite%addTest(TestMethod('flat_bow_springs', test_flat_bows))
      call suite%addTest(TestMethod('friction', test_friction))
      call suite%addTest(TestMethod('body_between', test_body_between))
      call suite%addTest(TestMethod('running_force', test_running_force))
   end function centralizers_suite

   !> Casing with centralizers every span, half a span from its ends, which are free.
   subroutine build(model, weight, inclination, friction, bow)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: weight           !< [N/m]
      real(wp), intent(in) :: inclination(2)   !< at both ends [deg]
      real(wp), intent(in) :: friction
      logical, intent(in) :: bow
      call new_well(model, [0.0_wp, depth], inclination, [40.0_wp, 40.0_wp], hole, friction, pipe(weight, od, bore))
      model%numerics%moments = .true.
      model%strings(1)%components(1)%centralizer = centralizer_type(present=.true., bow=bow, od=blades, spacing=span, &
                                                                    first=0.5_wp*span)
   end subroutine build

   !> Sag at mid-span [m], of the sign of the side load.
   pure function sag(load, axial) result(depth_of_sag)
      real(wp), intent(in) :: load, axial   !< q [N/m], T [N]
      real(wp) :: depth_of_sag
      real(wp), parameter :: straight = 0.01_wp   ! below, the factor is 1 - u^2/10
      real(wp) :: ei, u, factor
      ei = bending_stiffness(pipe(w, od, bore))
      u = 0.5_wp*span*sqrt(abs(axial)/ei)
      factor = 1.0_wp
      if (u > straight .and. axial > 0.0_wp) factor = 24.0_wp/u**4*(0.5_wp*u**2 - u*(cosh(u) - 1.0_wp)/sinh(u))
      if (u > straight .and. axial < 0.0_wp) factor = 24.0_wp/u**4*(u*(1.0_wp - cos(u))/sin(u) - 0.5_wp*u**2)
      depth_of_sag = load*span**4/(384.0_wp*ei)*factor
   end function sag

   !> Value at a depth [m] of what is known at increasing depths; a straight line between.
   pure function at(md, values, place) result(value)
      real(wp), intent(in) :: md(:), values(:), place
      real(wp) :: value, share
      integer :: i
      i = min(max(count(md <= place), 1), size(md) - 1)
      share = (place - md(i))/(md(i + 1) - md(i))
      value = (1.0_wp - share)*values(i) + share*values(i + 1)
   end function at

   !> Offset towards the low side [m], and at mid-span of the span below a centralizer that less the mean at both of its ends.
   pure function sag_found(profile, top) result(found)
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: top   !< depth of the centralizer [m]
      real(wp) :: found
      real(wp) :: low(size(profile%md))
      low = -profile%displacement*cos(profile%clock)
      found = at(profile%md, low, top + 0.5_wp*span) - 0.5_wp*(at(profile%md, low, top) + at(profile%md, low, top + span))
   end function sag_found

   !> Inclined at 60 deg and horizontal; tension, none and compression. The span in the middle: at the ends the casing hangs free.
   subroutine test_straight()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: theta(2) = [60.0_wp, 90.0_wp], pull(3) = [3.0e5_wp, 0.0_wp, -1.0e5_wp]
      real(wp), parameter :: top = (spans/2 - 0.5_wp)*span
      real(wp) :: expected
      integer :: i, k
      do i = 1, size(theta)
         call build(model, w, [theta(i), theta(i)], 0.0_wp, bow=.false.)
         do k = 1, size(pull)
            call solve(model, operation_static, -pull(k), 0.0_wp, result, 'straight')
            expected = sag(w*sin(theta(i)*degree), at(result%profile%md, result%profile%axial, top + 0.5_wp*span))
            call note('sag, mm', 1.0e3_wp*sag_found(result%profile, top))
            call note('over closed form - 1', sag_found(result%profile, top)/expected - 1.0_wp)
            call assertRelativelyEqual(expected, sag_found(result%profile, top), within, message='sag')
            call assertRelativelyEqual(span*w*sin(theta(i)*degree), force_at(result, top), within, message='force')
         end do
      end do
   end subroutine test_straight

   !> Force of the centralizer at a depth [N].
   pure function force_at(result, md) result(force)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: md
      real(wp) :: force
      force = sum(result%contacts%force, &
                  mask=result%contacts%kind == contact_centralizer .and. abs(result%contacts%md - md) < 1.0_wp)
   end function force_at

   !> A build to 23 deg over the whole length: weightless, pulled towards the high side, and with weight.
   subroutine test_bend()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: radius = 600.0_wp, pull = 4.0e5_wp, top = (spans/2 - 0.5_wp)*span, weight(2) = [0.0_wp, w]
      real(wp) :: axial, load
      integer :: i
      do i = 1, size(weight)
         call build(model, weight(i), [40.0_wp, 40.0_wp + depth/radius/degree], 0.0_wp, bow=.false.)
         call solve(model, operation_static, -pull, 0.0_wp, result, 'bend')
         axial = at(result%profile%md, result%profile%axial, top + 0.5_wp*span)
         load = weight(i)*sin(at(result%profile%md, result%profile%inclination, top + 0.5_wp*span)) - axial/radius
         call note('side load, N/m', load)
         call note('over closed form - 1', sag_found(result%profile, top)/sag(load, axial) - 1.0_wp)
         call assertRelativelyEqual(sag(load, axial), sag_found(result%profile, top), within, message='sag')
      end do
   end subroutine test_bend

   !> Casing lowered with friction into a well that builds and holds, on bow springs: every span that lies within the build or the
   !> hold. Where the side load is about nothing, in the build, what is left is compared with the largest sag.
   subroutine test_casing_run()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: kick = 300.0_wp, landed = 900.0_wp, bottom = 1500.0_wp, angle = 50.0_wp
      real(wp), parameter :: radius = (landed - kick)/(angle*degree), apart = 3.0_wp*span
      real(wp), parameter :: uneven = 5.0e-3_wp   ! axial force changes from span to span: seen 1.3e-3
      real(wp) :: top, axial, load, theta, worst, largest
      integer :: checked
      call new_well(model, [0.0_wp, kick, landed, bottom], [0.0_wp, 0.0_wp, angle, angle], spread(40.0_wp, 1, 4), hole, 0.3_wp, &
                    pipe(w, od, bore))
      model%numerics%moments = .true.
      model%strings(1)%components(1)%centralizer = centralizer_type(present=.true., bow=.true., od=0.32_wp, spacing=span, &
         first=0.5_wp*span, restoring_force=8.0e3_wp, rated_hole=hole, running_force=500.0_wp)
      call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'casing run')
      worst = 0.0_wp
      largest = 0.0_wp
      checked = 0
      top = bottom - 0.5_wp*span
      do
         top = top - span
         if (top < kick + apart) exit
         if (top > bottom - apart - span .or. (top > landed - apart - span .and. top < landed + apart)) cycle
         axial = at(result%profile%md, result%profile%axial, top + 0.5_wp*span)
         theta = at(result%profile%md, result%profile%inclination, top + 0.5_wp*span)
         load = w*sin(theta) - merge(axial/radius, 0.0_wp, top < landed)
         largest = max(largest, abs(sag(load, axial)))
         worst = max(worst, abs(sag_found(result%profile, top) - sag(load, axial)))
         checked = checked + 1
      end do
      call note('spans checked', real(checked, wp))
      call note('largest sag, mm', 1.0e3_wp*largest)
      call note('worst difference over the largest sag', worst/largest)
      call assertGreaterThan(checked, 60)
      call assertLessThan(worst, uneven*largest, message='sag')
   end subroutine test_casing_run

   !> A bow that fills its hole stands off by 67 % under its restoring force. One that is narrower gives way from where it touches.
   subroutine test_bows()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: top = (spans/2 - 0.5_wp)*span, narrow = 0.305_wp
      !> The gap of a full bow begins at 1e-6 m, 3e-5 of the clearance.
      real(wp), parameter :: opening = 1.0e-4_wp
      real(wp) :: expected
      call build(model, w, [90.0_wp, 90.0_wp], 0.0_wp, bow=.true.)
      associate (bow => model%strings(1)%components(1)%centralizer)
         bow%od = 0.33_wp
         bow%rated_hole = hole
         bow%restoring_force = w*span
         call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'bows')
         call assertEqual(0.67_wp, 1.0_wp - at(result%profile%md, result%profile%displacement, top)/clearance, opening, &
                          message='67 %')
         call assertRelativelyEqual(sag(w, 0.0_wp), sag_found(result%profile, top), within, message='sag between')
         bow%od = narrow
         bow%restoring_force = 2.0_wp*w*span
         call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'narrow bows')
         expected = 0.5_wp*(hole - narrow) + 0.5_wp*0.33_wp*clearance
         call assertRelativelyEqual(expected, at(result%profile%md, result%profile%displacement, top), within, message='half of it')
      end associate
   end subroutine test_bows

   !> Bows too weak for the casing lie flat: the body is on the wall, with what they do not carry.
   subroutine test_flat_bows()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: top = (spans/2 - 0.5_wp)*span, weak = 0.1_wp
      call build(model, w, [90.0_wp, 90.0_wp], 0.0_wp, bow=.true.)
      model%numerics%gk_contact = 1.0e9_wp
      model%numerics%gk_max = 1.0e10_wp
      associate (bow => model%strings(1)%components(1)%centralizer)
         bow%od = 0.33_wp
         bow%rated_hole = hole
         bow%restoring_force = weak*w*span
         call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'flat bows')
         call assertRelativelyEqual(clearance, at(result%profile%md, result%profile%displacement, top + 0.5_wp*span), 1.0e-2_wp, &
                                    message='on the wall')
         call assertRelativelyEqual(depth*w, result%normal_force, 1.0e-6_wp, message='sum of contact')
         ! no bow is pressed in further than its clearance, at which it carries its force over 0.33
         call assertLessThan(force_at(result, top), 1.05_wp*bow%restoring_force/0.33_wp, message='bow')
      end associate
   end subroutine test_flat_bows

   subroutine solve_by(model, number, operation, result)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: number, operation
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation
      select case (number)
      case (soft); call solve_soft_string(model, 1, result, error)
      case (rigid); call solve_rigid_string(model, 1, result, error)
      case (mixed); call solve_mixed_string(model, 1, result, error)
      case default; call solve(model, operation, model%cases(1)%wob, 0.0_wp, result, 'friction')
      end select
      call assertFalse(allocated(error), message='solves')
   end subroutine solve_by

   !> Centralizers carry all weight: their friction alone counts, at their diameter; within a bow the casing turns at its own.
   !> mu w L, and mu r w L with the climb's 1/sqrt(1 + mu**2).
   subroutine test_friction()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: of_hole = 0.4_wp, mu = 0.15_wp, along = mu*w*depth
      integer :: i, bow
      do bow = 0, 1
         call build(model, w, [90.0_wp, 90.0_wp], of_hole, bow=bow == 1)
         associate (centralizer => model%strings(1)%components(1)%centralizer)
            centralizer%rated_hole = hole
            centralizer%restoring_force = 2.0_wp*w*span
            centralizer%friction_axial = mu
            centralizer%friction_rotary = mu
         end associate
         model%cases(1)%wob = -1.0e5_wp
         model%numerics%wall_climb = .true.
         do i = soft, beams
            call solve_by(model, i, operation_trip_out, result)
            call assertEqual(1.0e5_wp + along, result%hookload, 1.0e-3_wp*along, message='up')
            call solve_by(model, i, operation_trip_in, result)
            call assertEqual(1.0e5_wp - along, result%hookload, 1.0e-3_wp*along, message='down')
            call solve_by(model, i, operation_rotate_off_bottom, result)
            call assertRelativelyEqual(along/sqrt(1.0_wp + mu**2)*0.5_wp*merge(od, blades, bow == 1), result%torque, 2.0e-3_wp, &
                                       message='torque')
         end do
      end do
   end subroutine test_friction

   !> Centralizers so far apart that the body sags to the wall between them: it rubs, they do not. The part of the load that it
   !> carries, by the strings on the axis and by beams. Bows yield, too.
   subroutine test_body_between()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: of_hole = 0.4_wp, long = 40.0_wp*span, apart(3) = span*[2.0_wp, 2.5_wp, 5.0_wp]
      real(wp), parameter :: pull(3) = [0.0_wp, 4.0e5_wp, -1.0e5_wp]
      !> Of the whole load: seen 0.008. The ends of the row are free.
      real(wp), parameter :: tolerance = 0.01_wp
      real(wp) :: parts(beams)
      integer :: i, j, k, bow
      do bow = 0, 1
         do j = 1, size(apart)
            do k = 1, size(pull)
               call new_well(model, [0.0_wp, long], [90.0_wp, 90.0_wp], [40.0_wp, 40.0_wp], hole, of_hole, pipe(w, od, bore))
               model%numerics%moments = .true.
               model%strings(1)%components(1)%centralizer = centralizer_type(present=.true., bow=bow == 1, od=blades, &
                  spacing=apart(j), first=0.5_wp*apart(j), rated_hole=hole, restoring_force=w*apart(j), friction_axial=0.0_wp, &
                  friction_rotary=0.0_wp)
               model%cases(1)%wob = -pull(k)
               do i = soft, beams
                  call solve_by(model, i, operation_trip_out, result)
                  parts(i) = -result%friction/(of_hole*w*long)
               end do
               call note('part on the body, beams', parts(beams))
               do i = soft, mixed
                  call note('less that of the beams', parts(i) - parts(beams))
                  call assertEqual(parts(beams), parts(i), tolerance, message='part on the body')
               end do
               call solve_by(model, soft, operation_rotate_off_bottom, result)
               call assertEqual(parts(soft), result%torque/(of_hole*w*long*0.5_wp*od), tolerance, message='torque')
            end do
         end do
      end do
   end subroutine test_body_between

   !> Each bow that is wider than its hole drags, against the motion, along the hole alone.
   subroutine test_running_force()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: running = 800.0_wp, weight = w*depth
      integer :: i
      call build(model, w, [0.0_wp, 0.0_wp], 0.0_wp, bow=.true.)
      associate (bow => model%strings(1)%components(1)%centralizer)
         bow%rated_hole = hole
         bow%restoring_force = 8.0e3_wp
         bow%running_force = running
         do i = soft, beams
            bow%od = 0.33_wp
            call solve_by(model, i, operation_trip_out, result)
            call assertRelativelyEqual(weight + spans*running, result%hookload, 1.0e-9_wp, message='up')
            call assertRelativelyEqual(-spans*running, result%friction, 1.0e-6_wp, message='up: friction')
            call solve_by(model, i, operation_trip_in, result)
            call assertRelativelyEqual(weight - spans*running, result%hookload, 1.0e-9_wp, message='down')
            call solve_by(model, i, operation_rotate_off_bottom, result)
            call assertRelativelyEqual(weight, result%hookload, 1.0e-9_wp, message='turning')
            bow%od = 0.305_wp
            call solve_by(model, i, operation_trip_out, result)
            call assertRelativelyEqual(weight, result%hookload, 1.0e-9_wp, message='in a wider hole')
         end do
      end associate
   end subroutine test_running_force
end module dg_test_centralizers
