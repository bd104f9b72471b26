!> A slick assembly that leaves the wall near a bit held on the axis: side force, slope and moments in closed form.
module dg_test_bit_side_force
   use funit, only: assertEqual, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: degree
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_test_wells, only: new_well, note, pipe, solve
   implicit none
   private
   public :: bit_side_force_suite

   real(wp), parameter :: w = 1500.0_wp, od = 0.16_wp, id = 0.07_wp, hole = 0.2_wp
   !> The string touches at one place an element and sinks into the wall by micrometres: the place of tangency is known to an
   !> element of 0.25 m in 12 m. Seen: 7e-4 in the side force, 3e-3 in the moment.
   real(wp), parameter :: tolerance = 5.0e-3_wp
   !> Side force over half the weight of the span, tilt over itself. Seen: 0.2 %; by the elements of the analysis 11 % and 22 %.
   real(wp), parameter :: at_default = 5.0e-3_wp

contains

   function bit_side_force_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bit_side_force')
      call suite%addTest(TestMethod('shear_is_the_side_force', test_shear))
      call suite%addTest(TestMethod('at_the_default_settings', test_default))
      call suite%addTest(TestMethod('heavy_foot', test_heavy_foot))
   end function bit_side_force_suite

   !> Horizontal, no friction, no bit load: tangency length (24 EI c/w)^(1/4), shear at the bit w L/2, none of bending there,
   !> largest moment w L^2/8 at L/2, where the shear is none.
   subroutine test_shear()
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: collar
      real(wp) :: length, shear, moment
      integer :: n, i
      collar = pipe(w, od, id)
      call new_well(model, [0.0_wp, 100.0_wp], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, collar)
      model%boundary%bit_centred = .true.
      model%numerics%element_length = 0.25_wp
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'slick assembly')
      length = (24.0_wp*bending_stiffness(collar)*0.5_wp*(hole - od)/w)**0.25_wp
      shear = 0.5_wp*w*length
      n = size(result%profile%md)
      call note('shear at the bit over w L/2', result%profile%shear(n)/shear)
      call assertRelativelyEqual(shear, result%profile%shear(n), tolerance, message='side force at the bit')
      i = minloc(abs(result%profile%md - (100.0_wp - 0.5_wp*length)), dim=1)
      moment = 0.125_wp*w*length**2
      call note('moment in the middle over w L^2/8', result%profile%bending(i)/moment)
      call assertRelativelyEqual(moment, result%profile%bending(i), tolerance, message='moment')
      call assertEqual(0.0_wp, result%profile%shear(i), 0.05_wp*shear, message='no shear where the moment is largest')
   end subroutine test_shear
   !> Straight and built holes of several inclinations, bit loads up to 150 kN, at the default settings, against `land`.
   subroutine test_default()
      real(wp), parameter :: inclination(3) = [90.0_wp, 45.0_wp, 15.0_wp], load(3) = [0.0_wp, 75.0e3_wp, 150.0e3_wp]
      real(wp), parameter :: build(3) = [0.0_wp, 2.0_wp, -2.0_wp]   !< [deg/30 m]
      real(wp), parameter :: depth = 120.0_wp
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: collar
      real(wp) :: force, tilt, weighs, found, worst(2)
      integer :: i, j, k
      collar = pipe(w, od, id)
      worst = 0.0_wp
      do k = 1, size(build)
         do i = 1, size(inclination)
            do j = 1, size(load)
               call new_well(model, [0.0_wp, depth], inclination(i) - [build(k)*depth/30.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], hole, &
                             0.0_wp, collar)
               model%numerics = settings_of('auto')
               model%boundary%bit_centred = .true.
               call solve(model, operation_static, load(j), 0.0_wp, result, 'slick assembly')
               call land(inclination(i)*degree, build(k)*degree/30.0_wp, load(j), bending_stiffness(collar), force, tilt, weighs)
               found = -result%bit_side_force*cos(result%bit_side_clock)
               call note('side force [N]', force)
               call note('side force found', found)
               worst(1) = max(worst(1), abs(found - force)/weighs)
               call note('tilt [-]', tilt)
               found = tan(result%bit_tilt)*cos(result%bit_tilt_clock)
               call note('tilt over the reference', found/tilt)
               worst(2) = max(worst(2), abs(found/tilt - 1.0_wp))
            end do
         end do
      end do
      call note('worst side force', worst(1))
      call note('worst tilt', worst(2))
      call assertLessThan(worst(1), at_default, message='side force')
      call assertLessThan(worst(2), at_default, message='tilt')
   end subroutine test_default

   !> Horizontal, no friction, no bit load; the lowest part of the string, as stiff as the rest, is four times as heavy, or light.
   !> With q its weight beyond the rest's, on a length a: EI y'' = -F x + w x^2/2 + q (x^2 - max(x - a, 0)^2)/2. It is zero at the
   !> length L where the string lies down; no slope there gives L.
   subroutine test_heavy_foot()
      real(wp), parameter :: a(3) = [0.3_wp, 1.0_wp, 3.0_wp], part_of_weight(2) = [4.0_wp, 0.05_wp]
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: q, low, high, length, force, offset, worst
      integer :: i, j, k
      worst = 0.0_wp
      do j = 1, size(part_of_weight)
         q = w*(part_of_weight(j) - 1.0_wp)
         do i = 1, size(a)
            call new_well(model, [0.0_wp, 100.0_wp], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, pipe(w, od, id))
            deallocate (model%strings(1)%components)
            allocate (model%strings(1)%components(2))
            model%strings(1)%components(1) = pipe(w + q, od, id)
            model%strings(1)%components(1)%length = a(i)
            model%strings(1)%components(2) = pipe(w, od, id)
            model%numerics = settings_of('auto')
            model%boundary%bit_centred = .true.
            call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'heavy foot')
            low = a(i)
            high = 40.0_wp
            do k = 1, 60
               length = 0.5_wp*(low + high)
               force = 0.5_wp*w*length + q*a(i)*(1.0_wp - 0.5_wp*a(i)/length)
               ! EI times the offset at L: the moments of the curvature about the bit
               offset = force*length**3/3.0_wp - w*length**4/8.0_wp &
                        - q*a(i)*(length**3/3.0_wp - a(i)*length**2/4.0_wp + a(i)**3/24.0_wp)
               if (offset > bending_stiffness(pipe(w, od, id))*0.5_wp*(hole - od)) then
                  high = length
               else
                  low = length
               end if
            end do
            call note('side force over the closed form', -result%bit_side_force*cos(result%bit_side_clock)/force)
            worst = max(worst, abs(-result%bit_side_force*cos(result%bit_side_clock)/force - 1.0_wp))
         end do
      end do
      call assertLessThan(worst, at_default, message='side force')
   end subroutine test_heavy_foot

   !> A slick assembly from its bit to where it lies down on the low side, as a beam-column of its own: y down from the axis of the
   !> hole, x from the bit up, compression P = load - w cos(theta) x, hole of curvature k (up: build) on the low side:
   !>   EI y'''' + (P y')' = w sin(theta) + P k,   y(0) = 0, EI (y''(0) - k) = 0,   y = c, y' = 0, y'' = 0 where it lies.
   !> By Runge and Kutta; slope and shear at the bit by superposition from the last two, the length by halving from the first.
   subroutine land(theta, k, load, ei, force, tilt, weighs)
      real(wp), intent(in) :: theta, k, load, ei   !< inclination at the bit [rad], [1/m], [N], [N.m2]
      real(wp), intent(out) :: force               !< of the bit on the low side [N]
      real(wp), intent(out) :: tilt                !< slope of the bit to the high side [-]
      real(wp), intent(out) :: weighs              !< half the weight across the hole of the span: the force without bit load [N]
      real(wp) :: low, high, middle, offset
      integer :: i
      low = 2.0_wp
      high = 30.0_wp
      do i = 1, 50
         middle = 0.5_wp*(low + high)
         call span(middle, offset)
         if (offset > 0.5_wp*(hole - od)) then
            high = middle
         else
            low = middle
         end if
      end do
      weighs = 0.5_wp*w*sin(theta)*middle
   contains
      !> Offset at the end of a span that has neither slope nor y'' there.
      subroutine span(length, offset)
         real(wp), intent(in) :: length
         real(wp), intent(out) :: offset
         real(wp) :: own(4), by_slope(4), by_shear(4), matrix(2, 2), right(2), determinant
         own = march(length, 0.0_wp, 0.0_wp)
         by_slope = march(length, 1.0_wp, 0.0_wp) - own
         by_shear = march(length, 0.0_wp, 1.0_wp) - own
         matrix(:, 1) = by_slope(2:3)
         matrix(:, 2) = by_shear(2:3)
         right = -own(2:3)
         determinant = matrix(1, 1)*matrix(2, 2) - matrix(1, 2)*matrix(2, 1)
         tilt = (right(1)*matrix(2, 2) - matrix(1, 2)*right(2))/determinant
         force = (matrix(1, 1)*right(2) - right(1)*matrix(2, 1))/determinant
         offset = own(1) + tilt*by_slope(1) + force*by_shear(1)
         force = -force*ei
      end subroutine span

      !> y, y', y'' and force across the hole over EI at the end of a span, for the slope and that force at the bit.
      function march(length, slope, shear) result(y)
         real(wp), intent(in) :: length, slope, shear
         real(wp) :: y(4), a(4), b(4), c(4), d(4), h
         integer, parameter :: steps = 400
         integer :: n
         h = length/steps
         y = [0.0_wp, slope, k, shear]
         do n = 0, steps - 1
            a = rate(n*h, y)
            b = rate((n + 0.5_wp)*h, y + 0.5_wp*h*a)
            c = rate((n + 0.5_wp)*h, y + 0.5_wp*h*b)
            d = rate((n + 1.0_wp)*h, y + h*c)
            y = y + h/6.0_wp*(a + 2.0_wp*b + 2.0_wp*c + d)
         end do
      end function march

      !> Of y, y', y'' and S/EI = y''' + P y'/EI by x.
      function rate(x, y) result(change)
         real(wp), intent(in) :: x, y(4)
         real(wp) :: change(4), compression, incline
         incline = theta - k*x
         compression = load - w*cos(theta - 0.5_wp*k*x)*x
         change = [y(2), y(3), y(4) - compression/ei*y(2), (w*sin(incline) + compression*k)/ei]
      end function rate
   end subroutine land
end module dg_test_bit_side_force
