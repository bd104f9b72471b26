!> Bottom-hole assemblies against the beam-column equation, and strings over a change of hole size.
!>
!> Beam-column (Timoshenko & Gere 1961, ch. 1): a span of length l under a load w across it and a compression P, its ends at
!> offsets y_a and y_b (down positive), with end moments M_a and M_b (sagging positive), turns at its ends by
!>   theta_a = (y_b - y_a)/l + w l^3/(24 EI) chi + M_a l/(3 EI) psi + M_b l/(6 EI) phi
!>   theta_b = (y_b - y_a)/l - w l^3/(24 EI) chi - M_a l/(6 EI) phi - M_b l/(3 EI) psi
!> with u = l/2 sqrt(P/EI) and chi = 3 (tan u - u)/u^3, psi = 3/(2u) (1/(2u) - 1/tan 2u), phi = 3/u (1/sin 2u - 1/(2u)),
!> all one without compression. Spans join with one slope; where the string lies down on the wall it has neither slope
!> nor moment.
module dg_test_assemblies
   use funit, only: assertEqual, assertGreaterThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: pi
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_test_wells, only: new_well, note, pipe, solve
   implicit none
   private
   public :: assemblies_suite

   real(wp), parameter :: w = 1500.0_wp, od = 0.17145_wp, id = 0.0714_wp, hole = 0.2159_wp
   real(wp), parameter :: depth = 80.0_wp
   real(wp), parameter :: blade = 0.1_wp       !< length of a stabilizer [m]: the closed form's has none
   real(wp), parameter :: one_percent = 0.01_wp
   !> Bit loads [N].
   real(wp), parameter :: loads(3) = [0.0_wp, 1.0e5_wp, 2.0e5_wp]

contains

   function assemblies_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('assemblies')
      call suite%addTest(TestMethod('slick', test_slick))
      call suite%addTest(TestMethod('two_stabilizers', test_two_stabilizers))
      call suite%addTest(TestMethod('under_gauge_stabilizer', test_under_gauge))
      call suite%addTest(TestMethod('blades_of_real_length', test_long_blades))
      call suite%addTest(TestMethod('casing_shoe_and_change_of_size', test_change_of_size))
   end function assemblies_suite

   !> A horizontal hole with collars, the bit held on the axis.
   subroutine build(model)
      type(model_type), intent(out) :: model
      call new_well(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, pipe(w, od, id))
      model%boundary%bit_centred = .true.
      model%numerics%element_length = 0.25_wp
      model%numerics%gk_contact = 1.0e11_wp
      model%numerics%gk_max = 1.0e11_wp
   end subroutine build

   !> A piece of collar, or one that carries the blades of a stabilizer.
   pure function part(length, joint_od) result(component)
      real(wp), intent(in) :: length     !< [m]
      real(wp), intent(in) :: joint_od   !< of the blades, 0: a collar [m]
      type(component_type) :: component
      component = pipe(w, od, id)
      component%kind = 'collar'
      component%length = length
      if (.not. joint_od > 0.0_wp) return
      component%kind = 'stabilizer'
      component%joint_od = joint_od
   end function part

   pure function chi(u) result(factor)
      real(wp), intent(in) :: u
      real(wp) :: factor
      factor = 1.0_wp
      if (u > 0.0_wp) factor = 3.0_wp*(tan(u) - u)/u**3
   end function chi

   pure function psi(u) result(factor)
      real(wp), intent(in) :: u
      real(wp) :: factor
      factor = 1.0_wp
      if (u > 0.0_wp) factor = 1.5_wp/u*(0.5_wp/u - 1.0_wp/tan(2.0_wp*u))
   end function psi

   pure function phi(u) result(factor)
      real(wp), intent(in) :: u
      real(wp) :: factor
      factor = 1.0_wp
      if (u > 0.0_wp) factor = 3.0_wp/u*(1.0_wp/sin(2.0_wp*u) - 0.5_wp/u)
   end function phi

   !> Slopes at the ends of a span, [a, b].
   pure function slopes(length, rise, load, ei, moment_a, moment_b) result(theta)
      real(wp), intent(in) :: length, rise       !< rise: y_b - y_a [m]
      real(wp), intent(in) :: load, ei           !< [N, N.m2]
      real(wp), intent(in) :: moment_a, moment_b !< [N.m]
      real(wp) :: theta(2), u, sag
      u = 0.5_wp*length*sqrt(load/ei)
      sag = w*length**3/(24.0_wp*ei)*chi(u)
      theta(1) = rise/length + sag + length/(6.0_wp*ei)*(2.0_wp*moment_a*psi(u) + moment_b*phi(u))
      theta(2) = rise/length - sag - length/(6.0_wp*ei)*(moment_a*phi(u) + 2.0_wp*moment_b*psi(u))
   end function slopes

   !> Moment at the far end of a span that comes down to the wall at its near end, without slope or moment there.
   pure function landing_moment(length, rise, load, ei) result(moment)
      real(wp), intent(in) :: length, rise, load, ei
      real(wp) :: moment, flat(2), unit(2)
      flat = slopes(length, rise, load, ei, 0.0_wp, 0.0_wp)
      unit = slopes(length, rise, load, ei, 1.0_wp, 0.0_wp)
      moment = -flat(2)/(unit(2) - flat(2))
   end function landing_moment

   !> Side force [N] and tilt of a bit on the axis, x from it: supports at offsets(i) at x = places(i), the wall at `clearance`
   !> beyond the last.
   pure subroutine beam_column(places, offsets, clearance, load, ei, side_force, tilt)
      real(wp), intent(in) :: places(:), offsets(:)   !< none or two [m]
      real(wp), intent(in) :: clearance, load, ei     !< [m, N, N.m2]
      real(wp), intent(out) :: side_force, tilt
      real(wp) :: low, high, middle, first, at_bit(2), moment, length, rise
      integer :: i
      low = 0.5_wp
      high = 40.0_wp
      if (load > 0.0_wp) high = min(high, 0.999_wp*pi*sqrt(ei/load))
      do i = 1, 60
         middle = 0.5_wp*(low + high)
         if (kink(middle) > 0.0_wp) then
            high = middle
         else
            low = middle
         end if
      end do
      call first_span(middle, length, rise, moment)
      at_bit = slopes(length, rise, load, ei, 0.0_wp, moment)
      tilt = at_bit(1)
      side_force = (moment + 0.5_wp*w*length**2 - load*rise)/length
   contains
      !> Grows with the length of the last span, none where it is right: without supports the moment that lands must be none.
      pure function kink(last) result(difference)
         real(wp), intent(in) :: last
         real(wp) :: difference, above(2), below(2), m(2)
         if (size(places) == 0) then
            difference = -landing_moment(last, clearance, load, ei)
            return
         end if
         call moments(last, m)
         above = slopes(last, clearance - offsets(2), load, ei, m(2), 0.0_wp)
         below = slopes(places(2) - places(1), offsets(2) - offsets(1), load, ei, m(1), m(2))
         difference = below(2) - above(1)
      end function kink

      !> Moments at the two supports: the second from the landing, the first from one slope at it.
      pure subroutine moments(last, m)
         real(wp), intent(in) :: last
         real(wp), intent(out) :: m(2)
         real(wp) :: left(2), right(2), none, unit
         m(2) = landing_moment(last, clearance - offsets(2), load, ei)
         left = slopes(places(1), offsets(1), load, ei, 0.0_wp, 0.0_wp)
         right = slopes(places(2) - places(1), offsets(2) - offsets(1), load, ei, 0.0_wp, m(2))
         none = right(1) - left(2)
         left = slopes(places(1), offsets(1), load, ei, 0.0_wp, 1.0_wp)
         right = slopes(places(2) - places(1), offsets(2) - offsets(1), load, ei, 1.0_wp, m(2))
         unit = right(1) - left(2) - none
         m(1) = -none/unit
      end subroutine moments

      !> The span next to the bit.
      pure subroutine first_span(last, span, climb, far)
         real(wp), intent(in) :: last
         real(wp), intent(out) :: span, climb, far
         real(wp) :: m(2)
         span = last
         climb = clearance
         far = 0.0_wp
         if (size(places) == 0) return
         call moments(last, m)
         span = places(1)
         climb = offsets(1)
         far = m(1)
      end subroutine first_span
   end subroutine beam_column

   !> The bit of the solved assembly against the beam-column; both press and point in the plane of the hole, to the low side (pi)
   !> where the beam-column's are positive for the force, to the high side (0) for the tilt.
   subroutine compare(model, places, offsets, what)
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: places(:), offsets(:)
      character(*), intent(in) :: what
      type(case_result_type) :: result
      real(wp) :: side_force, tilt, touches(size(places))
      integer :: i, j, k
      do i = 1, size(loads)
         call solve(model, operation_static, loads(i), 0.0_wp, result, what)
         do j = 1, size(places)
            k = maxloc(result%gaps%force, mask=abs(depth - result%gaps%md - places(j)) < 0.6_wp*blade, dim=1)
            touches(j) = depth - result%gaps(k)%md
            call note('touches from the middle of the blade [m]', touches(j) - places(j))
         end do
         call beam_column(touches, offsets, 0.5_wp*(hole - od), loads(i), bending_stiffness(pipe(w, od, id)), side_force, tilt)
         call note('side force [N]', side_force)
         call note('side force over the beam-column', -result%bit_side_force*cos(result%bit_side_clock)/side_force)
         call note('tilt', tilt)
         call note('tilt over the beam-column', tan(result%bit_tilt)*cos(result%bit_tilt_clock)/tilt)
         call assertRelativelyEqual(side_force, -result%bit_side_force*cos(result%bit_side_clock), one_percent, &
                                    message=what//': side force')
         call assertRelativelyEqual(tilt, tan(result%bit_tilt)*cos(result%bit_tilt_clock), one_percent, message=what//': tilt')
      end do
   end subroutine compare

   subroutine test_slick()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: side_force, tilt, length, ei, nothing(0)
      call build(model)
      ! The beam-column itself, without bit load: L = (24 EI c/w)^(1/4), side force w L/2, slope 2c/L.
      ei = bending_stiffness(pipe(w, od, id))
      length = (12.0_wp*ei*(hole - od)/w)**0.25_wp
      call beam_column(nothing, nothing, 0.5_wp*(hole - od), 0.0_wp, ei, side_force, tilt)
      call assertRelativelyEqual(0.5_wp*w*length, side_force, 1.0e-10_wp, message='side force of the closed form')
      call assertRelativelyEqual((hole - od)/length, tilt, 1.0e-10_wp, message='slope of the closed form')
      call compare(model, nothing, nothing, 'slick')
      model%boundary%bit_centred = .false.
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'bit not held')
      call assertEqual(.true., is_missing(result%bit_side_force), message='nothing holds the bit')
   end subroutine test_slick

   subroutine test_two_stabilizers()
      call stabilized(0.2127_wp, 0.2127_wp, 'two stabilizers')
   end subroutine test_two_stabilizers

   !> The upper stabilizer half an inch under gauge: the assembly drops where the one before held or built.
   subroutine test_under_gauge()
      call stabilized(0.2127_wp, 0.2032_wp, 'upper one under gauge')
   end subroutine test_under_gauge

   !> Stabilizers 4 m and 14 m above the bit, of these diameters [m].
   subroutine stabilized(lower, upper, what)
      real(wp), intent(in) :: lower, upper
      character(*), intent(in) :: what
      type(model_type) :: model
      real(wp), parameter :: places(2) = [4.0_wp, 14.0_wp]
      call build(model)
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(5))
      model%strings(1)%components(1) = part(places(1) - 0.5_wp*blade, 0.0_wp)
      model%strings(1)%components(2) = part(blade, lower)
      model%strings(1)%components(3) = part(places(2) - places(1) - blade, 0.0_wp)
      model%strings(1)%components(4) = part(blade, upper)
      model%strings(1)%components(5) = part(0.0_wp, 0.0_wp)
      call compare(model, places, 0.5_wp*(hole - [lower, upper]), what)
   end subroutine stabilized

   !> Blades of 1.8 m under an ordinary wall, whatever the element length: the lower one touches at its upper end, the upper one at
   !> both. Seen: 0.5 %. Where gaps of a blade moved only when they were deeper elsewhere by half the clearance, 5 m gave
   !> 18 % more: both gaps next to one node stood at that node, and the blade's end, deeper by hundredths of a millimetre, had none.
   subroutine test_long_blades()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: lengths(5) = [0.5_wp, 3.0_wp, 5.0_wp, 10.0_wp, 30.0_wp], steady = 0.001_wp
      real(wp) :: fine
      integer :: i
      fine = 0.0_wp
      do i = 1, size(lengths)
         call new_well(model, [0.0_wp, 150.0_wp], [45.0_wp, 45.0_wp], [0.0_wp, 0.0_wp], 0.3111_wp, 0.0_wp, &
                       pipe(1860.0_wp, 0.2032_wp, 0.0714_wp))
         deallocate (model%strings(1)%components)
         allocate (model%strings(1)%components(5))
         model%strings(1)%components = pipe(1860.0_wp, 0.2032_wp, 0.0714_wp)
         model%strings(1)%components%length = [0.4_wp, 1.8_wp, 18.0_wp, 1.8_wp, 0.0_wp]
         model%strings(1)%components(2)%kind = 'stabilizer'
         model%strings(1)%components(2)%joint_od = 0.3096_wp
         model%strings(1)%components(4)%kind = 'stabilizer'
         model%strings(1)%components(4)%joint_od = 0.3079_wp
         model%boundary%bit_centred = .true.
         model%numerics%element_length = lengths(i)
         model%numerics%moments = .true.          ! as at the default: the side force is that of the bent string
         call solve(model, operation_static, 7.5e4_wp, 0.0_wp, result, 'long blades')
         call note('side force [N]', result%bit_side_force)
         if (i == 1) fine = result%bit_side_force
         call assertRelativelyEqual(fine, result%bit_side_force, steady, message='side force')
         call assertEqual(0, index(result%message, 'Contact points'), message='gaps at rest: '//result%message)
      end do
   end subroutine test_long_blades

   !> A string lies across an edge: on the higher floor of a narrow hole it lifts off a before the edge, comes down on the lower
   !> floor of a wide one, h below, b behind it. With l = (24 EI h/w)^(1/4) the span equations above, P = 0, give
   !>   M = -w a^2/4,   (a/l)^2 = (b/l)^2 - (l/b)^2,   3 u - 1 = (1 - u)^(3/2) for u = (l/b)^4,
   !> and the edge carries w (a + b)/2 + |M| (1/a + 1/b). Narrow above wide is a string entering an enlarged hole, wide above
   !> narrow one leaving a casing shoe for the hole below.
   subroutine test_change_of_size()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: narrow = 0.2159_wp, wide = 0.2445_wp, edge = 40.0_wp
      !> The last piece of the narrow hole: one short element, so that its gap is at the edge [m].
      real(wp), parameter :: lip = 0.02_wp
      character(*), parameter :: names(2) = [character(16) :: 'change of size', 'casing shoe']
      real(wp) :: ei, step, unit, u, a, b, moment, peak, force, low, high
      integer :: i
      ei = bending_stiffness(pipe(w, od, id))
      step = 0.5_wp*(wide - narrow)
      unit = (24.0_wp*ei*step/w)**0.25_wp
      low = 1.0_wp/3.0_wp
      high = 1.0_wp
      do i = 1, 60
         u = 0.5_wp*(low + high)
         if (3.0_wp*u - 1.0_wp < (1.0_wp - u)**1.5_wp) then
            low = u
         else
            high = u
         end if
      end do
      b = unit*u**(-0.25_wp)
      a = unit*sqrt((b/unit)**2 - (unit/b)**2)
      moment = 0.25_wp*w*a**2
      force = 0.5_wp*w*(a + b) + moment*(1.0_wp/a + 1.0_wp/b)
      do i = 1, 2
         call build(model)
         model%boundary%bit_centred = .false.
         deallocate (model%holes)
         allocate (model%holes(3))
         model%holes(1) = hole_section_type('above', 0.0_wp, edge - 0.5_wp*lip, merge(narrow, wide, i == 1), 0.0_wp, 0.0_wp)
         model%holes(2) = hole_section_type('edge', edge - 0.5_wp*lip, edge + 0.5_wp*lip, narrow, 0.0_wp, 0.0_wp)
         model%holes(3) = hole_section_type('below', edge + 0.5_wp*lip, depth, merge(wide, narrow, i == 1), 0.0_wp, 0.0_wp)
         call solve(model, operation_static, 0.0_wp, 0.0_wp, result, trim(names(i)))
         peak = maxval(result%profile%bending, mask=abs(result%profile%md - edge) < lip)
         call note('moment at the edge', peak/moment)
         call note('contact force at the edge', sum(result%gaps%force, mask=abs(result%gaps%md - edge) < 0.5_wp*a)/force)
         call assertRelativelyEqual(moment, peak, one_percent, message=trim(names(i))//': moment')
         call assertRelativelyEqual(force, sum(result%gaps%force, mask=abs(result%gaps%md - edge) < 0.5_wp*a), one_percent, &
                                    message=trim(names(i))//': force')
         ! Off the wall on both sides, as far as the closed form says, but for the rounding of contact at its end.
         associate (md => result%gaps%md - edge, closed => result%gaps%state > 0)
            call assertEqual(0, count(closed .and. abs(md) > 0.5_wp .and. md*merge(1, -1, i == 1) > -0.9_wp*a .and. &
                                      md*merge(1, -1, i == 1) < 0.9_wp*b), message=trim(names(i))//': clear of the wall')
            call assertGreaterThan(count(closed .and. abs(md) > 1.1_wp*b), 0, message=trim(names(i))//': lies beyond')
         end associate
      end do
   end subroutine test_change_of_size
end module dg_test_assemblies
