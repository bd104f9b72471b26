!> Strings on their end supports (pinned at top and bit), clear of the wall or just touching: beam, tie, column, and the
!> slick assembly.
module dg_test_supports
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_component, only: axial_stiffness, bending_stiffness, component_type
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static, operation_trip_in
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_nodes, settings_of
   use dg_test_wells, only: hold_ends, new_well, note, part, pipe, solve
   implicit none
   private
   public :: supports_suite

   real(wp), parameter :: length = 20.0_wp
   integer, parameter :: elements = 20

contains

   function supports_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('supports')
      call suite%addTest(TestMethod('beam', test_beam))
      call suite%addTest(TestMethod('tie', test_tie))
      call suite%addTest(TestMethod('beam_column', test_beam_column))
      call suite%addTest(TestMethod('slick_assembly', test_slick_assembly))
      call suite%addTest(TestMethod('narrow_bit', test_narrow_bit))
      call suite%addTest(TestMethod('slick_assembly_under_load', test_slick_assembly_under_load))
      call suite%addTest(TestMethod('free_bit', test_free_bit))
   end function supports_suite

   !> A horizontal string of drill pipe, w per metre, pinned at both ends, in a hole of that clearance.
   subroutine build(model, w, clearance)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: w, clearance
      call new_well(model, [0.0_wp, length], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], 0.127_wp + 2.0_wp*clearance, 0.0_wp, &
                    pipe(w, 0.127_wp, 0.1086_wp))
      call hold_ends(model)
      model%numerics%element_length = length/elements
   end subroutine build

   !> Coiled tubing run in with its bit free. The short elements of moments find an equilibrium at the analysis' one, on any side of
   !> a vertical hole.
   subroutine test_free_bit()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: inclination(3) = [0.0_wp, 0.5_wp, 4.0_wp], wob(3) = [1.5e3_wp, 2.88e3_wp, 2.88e3_wp]   ! [deg, N]
      integer :: i
      do i = 1, size(wob)
         call new_well(model, [0.0_wp, 600.0_wp], spread(inclination(i), 1, 2), [0.0_wp, 0.0_wp], 0.12_wp, 0.3_wp, &
                       part('drillpipe', 0.0_wp, 0.0508_wp, 0.0429_wp, 3.86_wp, 0.0_wp))
         model%boundary%top_centred = .true.
         model%numerics = settings_of('auto')
         model%numerics%friction_range = .false.      ! what another equilibrium may add is not asked here
         call solve(model, operation_trip_in, wob(i), 0.0_wp, result, 'free bit')
         call assertFalse(is_missing(result%moment_error), message='free bit')
         call assertLessThan(result%moment_error, 0.1_wp, message='free bit')
      end do
   end subroutine test_free_bit

   pure function stiffness() result(ei)
      real(wp) :: ei
      ei = bending_stiffness(pipe(1.0_wp, 0.127_wp, 0.1086_wp))
   end function stiffness

   !> Sag 5 w L**4/(384 EI), moment w L**2/8; at 20 N/m the sag is L/600, its square 3e-6. Seen: 9e-6, 1e-5.
   subroutine test_beam()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 20.0_wp, tolerance = 2.0e-5_wp
      integer, parameter :: middle = elements/2 + 1
      call build(model, w, 0.2_wp)
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'beam')
      call note('sag', result%profile%displacement(middle)/(5.0_wp*w*length**4/(384.0_wp*stiffness())) - 1.0_wp)
      call note('moment', result%profile%bending(middle)/(w*length**2/8.0_wp) - 1.0_wp)
      call assertRelativelyEqual(5.0_wp*w*length**4/(384.0_wp*stiffness()), result%profile%displacement(middle), tolerance)
      call assertRelativelyEqual(w*length**2/8.0_wp, result%profile%bending(middle), tolerance)
      call assertEqual(pi, result%profile%clock(middle), 1.0e-9_wp, message='on the low side')
      call assertEqual(0, sum(result%states(1:)), message='no contact')
   end subroutine test_beam

   !> Pulled with T: k = sqrt(T/EI), sag w L**2/(8 T) - w EI/T**2 (1 - 1/cosh(k L/2)), moment w EI/T (1 - 1/cosh(k L/2)).
   !> Stretch e = T/EA, 4e-4 here, makes every unstretched metre 1 + e long: T (1 + e) for T, w (1 + e)**2 for w in the sag.
   subroutine test_tie()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 100.0_wp, pull = 3.0e5_wp, tolerance = 1.0e-5_wp
      real(wp), parameter :: support = 1.0e10_wp   !< stiffness of the ends' supports [N/m]: they yield by 1e-7 m
      integer, parameter :: middle = elements/2 + 1
      real(wp) :: ei, fade, sag, moment, t, q
      ei = stiffness()
      t = pull*(1.0_wp + strain(pull))
      q = w*(1.0_wp + strain(pull))**2
      fade = 1.0_wp - 1.0_wp/cosh(sqrt(t/ei)*0.5_wp*length)
      sag = q*length**2/(8.0_wp*t) - q*ei/t**2*fade + 0.5_wp*w*length/support
      moment = q*ei/t*fade/(1.0_wp + strain(pull))
      call build(model, w, 0.2_wp)
      call solve(model, operation_static, -pull, 0.0_wp, result, 'tie')
      call note('sag', result%profile%displacement(middle)/sag - 1.0_wp)
      call note('moment', result%profile%bending(middle)/moment - 1.0_wp)
      call assertRelativelyEqual(sag, result%profile%displacement(middle), tolerance, message='sag')
      call assertRelativelyEqual(moment, result%profile%bending(middle), 10.0_wp*tolerance, message='moment')
   end subroutine test_tie

   pure function strain(pull) result(e)
      real(wp), intent(in) :: pull
      real(wp) :: e
      e = pull/axial_stiffness(pipe(1.0_wp, 0.127_wp, 0.1086_wp))
   end function strain

   !> Pushed with P below Euler's load P_E = pi**2 EI/L**2: k = sqrt(P/EI), sag w EI/P**2 (1/cos(k L/2) - 1) - w L**2/(8 P),
   !> growing as 1/(1 - P/P_E); strain as for the tie. Just above P_E the string goes to the wall.
   subroutine test_beam_column()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 0.1_wp, clearance = 0.05_wp, share(4) = [0.5_wp, 0.9_wp, 0.99_wp, 1.01_wp]
      !> The mesh's own critical load lies above by (pi/20)**4/720 = 8e-7, magnified near P_E by 1/(1 - P/P_E). The sag shortens
      !> the span: its square over L**2 is below 1e-6, magnified as well.
      real(wp), parameter :: tolerance(4) = [1.0e-5_wp, 2.0e-5_wp, 2.0e-4_wp, 0.0_wp]
      integer, parameter :: middle = elements/2 + 1
      real(wp) :: ei, load, sag, k, p, q
      integer :: i
      ei = stiffness()
      call build(model, w, clearance)
      model%numerics%imperfection = 0.0_wp
      do i = 1, size(share)
         load = share(i)*pi**2*ei/length**2
         p = load*(1.0_wp - strain(load))
         q = w*(1.0_wp - strain(load))**2
         k = sqrt(p/ei)
         sag = q*ei/p**2*(1.0_wp/cos(0.5_wp*k*length) - 1.0_wp) - q*length**2/(8.0_wp*p)
         call solve(model, operation_static, load, 0.0_wp, result, 'beam column')
         if (share(i) < 1.0_wp) then
            call note('sag, deviation', result%profile%displacement(middle)/sag - 1.0_wp)
            call assertRelativelyEqual(sag, result%profile%displacement(middle), tolerance(i), message='sag')
            call assertEqual(0, sum(result%states(1:)), message='no contact')
         else
            call assertGreaterThan(maxval(result%profile%displacement), clearance, message='at the wall')
         end if
      end do
   end subroutine test_beam_column

   !> Slick assembly, bit pinned on the axis, no bit load: it lies on the wall beyond L = (24 EI c/w)**(1/4), with
   !> y = c (2 x - 2 x**3 + x**4), x from the bit over L; moment 12 EI c/L**2 x (1 - x); side force at the bit w L/2.
   subroutine test_slick_assembly()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 1000.0_wp, c = 0.03_wp, mesh = 0.25_wp, depth = 60.0_wp
      real(wp) :: ei, tangency, x, worst, worst_moment, side_force
      type(component_type) :: collar
      integer :: i, n
      collar = pipe(w, 0.17145_wp, 0.0714_wp)
      ei = bending_stiffness(collar)
      tangency = (24.0_wp*ei*c/w)**0.25_wp
      call new_well(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], 0.17145_wp + 2.0_wp*c, 0.0_wp, collar)
      model%boundary%bit_centred = .true.
      model%numerics%element_length = mesh
      model%numerics%gap_location = gap_at_nodes
      model%numerics%gk_contact = 1.0e9_wp
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'slick')
      n = size(result%profile%md)
      worst = 0.0_wp
      worst_moment = 0.0_wp
      ! Contact is spread over (4 EI/k)**(1/4) = 0.3 m of wall, which rounds the last of the moment off.
      do i = 1, n
         x = (depth - result%profile%md(i))/tangency
         if (x > 0.92_wp) cycle
         worst = max(worst, abs(result%profile%displacement(i)/c - (2.0_wp*x - 2.0_wp*x**3 + x**4)))
         worst_moment = max(worst_moment, abs(result%profile%bending(i) - 12.0_wp*ei*c/tangency**2*x*(1.0_wp - x)))
      end do
      side_force = result%profile%bending(n - 1)/mesh + 0.5_wp*w*mesh
      call note('shape, over c', worst)
      call note('moment, over its largest', worst_moment/(3.0_wp*ei*c/tangency**2))
      call note('side force at the bit', side_force/(0.5_wp*w*tangency) - 1.0_wp)
      call assertLessThan(worst, 5.0e-4_wp, message='shape')
      call assertLessThan(worst_moment, 2.0e-3_wp*3.0_wp*ei*c/tangency**2, message='moment')
      call assertRelativelyEqual(0.5_wp*w*tangency, side_force, 1.0e-3_wp, message='side force at the bit')
      call assertEqual(tangency, touch_down(result, depth), 2.0_wp*mesh, message='tangency length')
   end subroutine test_slick_assembly

   !> A bit that is held on the axis does not hold the string by its gauge, whatever its hole: a wide one, casing, its own. Its side
   !> force is that of the slick assembly, w L/2. With its gauge at the wall it was 12.6 times that where the bit is 1 mm
   !> narrower, and 0.68 times at 4 mm.
   subroutine test_narrow_bit()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 1000.0_wp, c = 0.03_wp, depth = 60.0_wp
      real(wp), parameter :: under(5) = [0.0_wp, 0.2e-3_wp, 1.0e-3_wp, 4.0e-3_wp, 0.02_wp]     ! gauge [m]
      real(wp) :: side_force
      type(component_type) :: bit, collar
      integer :: i
      collar = pipe(w, 0.17145_wp, 0.0714_wp)
      side_force = 0.5_wp*w*(24.0_wp*bending_stiffness(collar)*c/w)**0.25_wp
      do i = 1, size(under)
         call new_well(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], collar%od + 2.0_wp*c, 0.0_wp, collar)
         bit = collar
         bit%kind = 'bit'
         bit%length = 0.3_wp
         bit%joint_od = collar%od + 2.0_wp*c - under(i)
         model%strings(1)%components = [bit, collar]
         model%boundary%bit_centred = .true.
         model%numerics = settings_of('auto')
         call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'narrow bit')
         call note('side force of a narrow bit', result%bit_side_force/side_force - 1.0_wp)
         call assertRelativelyEqual(side_force, result%bit_side_force, 1.0e-3_wp, message='side force of a narrow bit')
      end do
   end subroutine test_narrow_bit

   !> Distance from the bit [m] at which the moment first falls to a fiftieth of its largest.
   pure function touch_down(result, depth) result(distance)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: depth
      real(wp) :: distance
      integer :: i
      i = maxloc(result%profile%bending, dim=1)
      do while (result%profile%bending(i) > 0.02_wp*maxval(result%profile%bending))
         i = i - 1
      end do
      distance = depth - result%profile%md(i)
   end function touch_down

   !> The same with bit load P: y = A sin(k x) + B cos(k x) + C x + B (k**2 x**2/2 - 1), x from the bit, B = w/(P k**2) and
   !> A = B tan(k L/2) from no moment at both ends, C from no slope at L; y(L) = c gives L.
   subroutine test_slick_assembly_under_load()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: w = 1000.0_wp, c = 0.03_wp, mesh = 0.25_wp, depth = 60.0_wp, load(2) = [1.0e5_wp, 3.0e5_wp]
      real(wp) :: ei, k, lower, upper, tangency, x, worst, shape
      type(component_type) :: collar
      integer :: i, j
      collar = pipe(w, 0.17145_wp, 0.0714_wp)
      ei = bending_stiffness(collar)
      call new_well(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], 0.17145_wp + 2.0_wp*c, 0.0_wp, collar)
      model%boundary%bit_centred = .true.
      model%numerics%element_length = mesh
      model%numerics%gap_location = gap_at_nodes
      model%numerics%gk_contact = 1.0e9_wp
      do j = 1, size(load)
         k = sqrt(load(j)/ei)
         lower = 1.0_wp
         upper = 3.0_wp/k
         do i = 1, 60
            tangency = 0.5_wp*(lower + upper)
            if (offset(tangency) < c) then
               lower = tangency
            else
               upper = tangency
            end if
         end do
         call solve(model, operation_static, load(j), 0.0_wp, result, 'slick, bit load')
         worst = 0.0_wp
         do i = 1, size(result%profile%md)
            x = depth - result%profile%md(i)
            if (x > 0.92_wp*tangency) cycle
            shape = offset(x)
            worst = max(worst, abs(result%profile%displacement(i) - shape)/c)
         end do
         call note('tangency length under load', tangency)
         call note('touch down under load', touch_down(result, depth))
         call note('shape under load, over c', worst)
         call assertLessThan(worst, 1.0e-3_wp, message='shape')
         call assertEqual(tangency, touch_down(result, depth), 2.0_wp*mesh, message='tangency length')
      end do
   contains
      pure function offset(z) result(y)
         real(wp), intent(in) :: z
         real(wp) :: y, a, b, slope
         b = w/(load(j)*k**2)
         a = b*tan(0.5_wp*k*tangency)
         slope = -k*(a*cos(k*tangency) - b*sin(k*tangency)) - b*k**2*tangency
         y = a*sin(k*z) + b*cos(k*z) + slope*z + b*(0.5_wp*(k*z)**2 - 1.0_wp)
      end function offset
   end subroutine test_slick_assembly_under_load
end module dg_test_supports
