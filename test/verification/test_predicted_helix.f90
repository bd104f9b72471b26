!> The start of a string that coils in a vertical hole: the ends of its helix, its turns, and what hangs above.
module dg_test_predicted_helix
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_coiling, only: coil_force
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_predicted_helix, only: end_at_bit, helix_landing, helix_touch, lay_helix
   use dg_test_wells, only: new_well, pipe
   implicit none
   private
   public :: predicted_helix_suite

   real(wp), parameter :: od = 0.127_wp, id = 0.1086_wp, hole = 0.2159_wp, weight = 265.0_wp, bottom = 1000.0_wp, bent = 1100.0_wp
   real(wp), parameter :: rigid = 1.0e9_wp

contains

   function predicted_helix_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('predicted_helix')
      call suite%addTest(TestMethod('end', test_end))
      call suite%addTest(TestMethod('turns', test_turns))
      call suite%addTest(TestMethod('lying', test_lying))
      call suite%addTest(TestMethod('both_ends', test_both_ends))
      call suite%addTest(TestMethod('leaning', test_leaning))
   end function predicted_helix_suite

   !> At a centred bit y'''' + 2 y'' = 0: y'' + 2 y is linear but for a jump of its slope where the wall presses, inwards. The
   !> string is on the axis at the bit without moment, touches the wall twice, and lies on it from the second place on as
   !> u' = 1 - u^2 has it, which is what far up becomes a helix of angle t. Differences over 1e-4 are good for 1e-7.
   subroutine test_end()
      real(wp), parameter :: step = 1.0e-4_wp, digits = 1.0e-6_wp
      complex(wp) :: y, slope, jump
      real(wp) :: t, rate
      integer :: i
      call end_at_bit(0.0_wp, y, slope)
      call assertLessThan(abs(y) + abs(bend(0.0_wp + step)), 10.0_wp*step, message='on the axis, without moment')
      do i = 1, 30
         t = 0.1_wp*i
         if (abs(t - helix_touch) < 0.1_wp) cycle
         call assertLessThan(abs(work(t - 0.05_wp) - 2.0_wp*work(t) + work(t + 0.05_wp)), digits, message='in balance')
         call end_at_bit(t, y, slope)
         call assertLessThan(abs(y), 1.0_wp, message='in the hole')
         if (t > helix_touch) call assertGreaterThan(abs(y), 0.997_wp, message='next to the wall')
      end do
      call touches(helix_touch)
      call assertLessThan(abs(bend(helix_touch + 2.0_wp*step) - bend(helix_touch - 2.0_wp*step)), 20.0_wp*step, &
                          message='moment does not jump')
      call end_at_bit(helix_touch, y, slope)
      jump = (work(helix_touch + 0.1_wp) - work(helix_touch + 0.05_wp) &
              - work(helix_touch - 0.05_wp) + work(helix_touch - 0.1_wp))/0.05_wp/y
      call assertLessThan(abs(aimag(jump)), 1.0e-5_wp, message='the wall is smooth')
      call assertLessThan(real(jump), -1.0_wp, message='and presses')
      call touches(helix_landing)
      call end_at_bit(helix_landing, y, slope)
      rate = aimag(slope/y)
      call assertLessThan(abs(bend(helix_landing)/y - cmplx(-rate**2, 1.0_wp - rate**2, wp)), digits, message='moment of the wall')
      ! beyond, theta = ln cosh(t - t_0) + const tends to t: the angle at the landing is t_0 + ln(2 cosh(t - t_0))
      t = atanh(rate)
      call assertLessThan(abs(modulo(atan2(aimag(y), real(y)) - (helix_landing - t + log(2.0_wp*cosh(t))) + pi, 2.0_wp*pi) - pi), &
                          digits, message='turned')

   contains

      subroutine touches(place)
         real(wp), intent(in) :: place
         call end_at_bit(place, y, slope)
         call assertRelativelyEqual(1.0_wp, abs(y), digits, message='touches')
         call assertLessThan(abs(real(slope/y)), digits, message='along the wall')
      end subroutine touches

      function bend(at) result(second)
         real(wp), intent(in) :: at
         complex(wp) :: second, left, right, ignored
         call end_at_bit(at - step, ignored, left)
         call end_at_bit(at + step, ignored, right)
         second = (right - left)/(2.0_wp*step)
      end function bend

      function work(at) result(sum)
         real(wp), intent(in) :: at
         complex(wp) :: sum, offset, ignored
         call end_at_bit(at, offset, ignored)
         sum = bend(at) + 2.0_wp*offset
      end function work
   end subroutine test_end

   !> A kilometre of pipe with 200 kN on the bit, in units of (EI/w)^(1/3): at the neutral point u is 0.3670615515, the solution of
   !> Hastings & McLeod (1980) there, and down to x below it the string turns by (sqrt(2)/3) x^(3/2) + ln(2)/2 (Baik, Buckingham,
   !> DiFranco & Its 2009). Deep down the wall presses as Lubinski's helix does. Slopes are those of the offsets.
   subroutine test_turns()
      real(wp), parameter :: neutral = 300.0_wp, far = 700.0_wp, element = 1.0_wp
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp), allocatable :: axial(:), load(:), wall(:), place(:), offset(:, :), slope(:, :)
      complex(wp), allocatable :: y(:), y_prime(:)
      real(wp) :: unit, angle, turned, x, worst
      integer :: i, last, at_neutral, at_far
      call vertical(model, mesh, bottom, element)
      call room(mesh, axial, load, wall, place, offset, slope)
      at_neutral = minloc(abs(mesh%md - neutral), dim=1)
      axial = -weight*(mesh%md - mesh%md(at_neutral))
      at_far = minloc(abs(mesh%md - far), dim=1)
      unit = (mesh%ei(1)/weight)**(1.0_wp/3.0_wp)
      call lay_helix(mesh, axial, place, .true., .true., wall, load, offset, slope, last, angle)
      call assertEqual(mesh%nodes, last, message='to the bit')
      allocate (y(mesh%nodes), y_prime(mesh%nodes))
      y = cmplx(offset(1, :), offset(2, :), wp)
      y_prime = cmplx(slope(1, :), slope(2, :), wp)
      call assertLessThan(abs(y(1)) + abs(y(mesh%nodes)), 1.0e-12_wp, message='centred')
      call assertLessThan(maxval(abs(y)), mesh%clearance(1)*1.0001_wp, message='in the hole')
      call assertRelativelyEqual(0.3670615515_wp/unit, aimag(y_prime(at_neutral)/y(at_neutral)), 2.0e-3_wp, message='u(0)')
      turned = 0.0_wp
      do i = 2, at_far
         if (abs(y(i - 1)) > 0.0_wp) turned = turned + aimag(log(y(i)/y(i - 1)))
      end do
      x = (mesh%md(at_far) - mesh%md(at_neutral))/unit
      call assertRelativelyEqual(sqrt(2.0_wp)/3.0_wp*x**1.5_wp + 0.5_wp*log(2.0_wp), turned, 2.0e-5_wp, message='turns')
      call assertRelativelyEqual(coil_force(mesh%ei(1), -axial(at_far), mesh%clearance(1)), load(at_far), 1.0e-3_wp, &
                                 message='force')
      worst = 0.0_wp
      do i = 2, mesh%nodes - 1
         worst = max(worst, abs((y(i + 1) - y(i - 1))/(mesh%md(i + 1) - mesh%md(i - 1)) - y_prime(i)))
      end do
      call assertLessThan(worst, 0.02_wp*maxval(abs(y_prime)), message='slopes')
   end subroutine test_turns

   !> Above a bend in which the string lies on one side the helix ends on that side.
   subroutine test_lying()
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp), allocatable :: axial(:), load(:), wall(:), place(:), offset(:, :), slope(:, :)
      real(wp) :: angle, side(2)
      integer :: last
      call vertical(model, mesh, bent, 2.0_wp)
      call room(mesh, axial, load, wall, place, offset, slope)
      axial = -weight*(mesh%md - 700.0_wp)
      side = [-0.6_wp, 0.8_wp]
      load = merge(1.0e4_wp, 0.0_wp, mesh%md > bottom)
      offset = mesh%clearance(1)*spread(side, 2, mesh%nodes)*spread(merge(1.0_wp, 0.0_wp, mesh%md > bottom), 1, 2)
      call lay_helix(mesh, axial, place, .true., .true., wall, load, offset, slope, last, angle)
      call assertEqual(bottom, mesh%md(last), 1.0e-6_wp, message='as far as the hole is vertical')
      call assertGreaterThan(dot_product(offset(:, last), side), 0.999_wp*mesh%clearance(1), message='ends where it lies')
      call assertLessThan(norm2(slope(:, last)), 1.0e-3_wp*maxval(abs(slope)), message='and as it lies')
      call assertLessThan(dot_product(offset(:, last - 10), side), 0.9_wp*mesh%clearance(1), message='it came round')
   end subroutine test_lying

   !> A string without weight, compressed from the top on, is the same helix seen from either end.
   subroutine test_both_ends()
      real(wp), parameter :: compression = 1.5e5_wp
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp), allocatable :: axial(:), load(:), wall(:), place(:), offset(:, :), slope(:, :)
      real(wp) :: angle
      integer :: last, i, other
      call vertical(model, mesh, 200.0_wp, 2.0_wp)
      call room(mesh, axial, load, wall, place, offset, slope)
      axial = -compression
      call lay_helix(mesh, axial, place, .true., .true., wall, load, offset, slope, last, angle)
      call assertEqual(mesh%nodes, last, message='to the bit')
      do i = 1, mesh%nodes
         other = mesh%nodes + 1 - i
         call assertEqual(norm2(offset(:, other)), norm2(offset(:, i)), 1.0e-9_wp, message='as far off the axis')
         call assertEqual(norm2(slope(:, other)), norm2(slope(:, i)), 1.0e-9_wp, message='as steep')
         if (i > 1 .and. i < mesh%nodes) call assertGreaterThan(offset(1, i)*slope(2, i) - offset(2, i)*slope(1, i), 0.0_wp, &
                                                                 message='turns one way')
      end do
   end subroutine test_both_ends

   !> Where it does not coil it leans from the top to the first node that lies, but for the bending length b = sqrt(EI/T) along a
   !> straight line: v = (1 - exp((s - L)/b))/T up to L. In tension there, and where nothing lies, nothing is changed.
   subroutine test_leaning()
      real(wp), parameter :: tension = 1.0e4_wp
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp), allocatable :: axial(:), load(:), wall(:), place(:), offset(:, :), slope(:, :)
      real(wp) :: angle, side(2), bending, middle
      integer :: last, first, i
      call vertical(model, mesh, bent, 2.0_wp)
      call room(mesh, axial, load, wall, place, offset, slope)
      side = [-0.6_wp, 0.8_wp]
      first = findloc(mesh%md > bottom, .true., dim=1)
      axial = tension
      call lay_helix(mesh, axial, place, .true., .true., wall, load, offset, slope, last, angle)
      call assertEqual(0, last, message='no helix')
      call assertTrue(all(abs(offset) <= 0.0_wp), message='nothing touched')
      do i = first, mesh%nodes
         offset(:, i) = mesh%clearance(1)*side
      end do
      call lay_helix(mesh, axial, place, .true., .true., wall, load, offset, slope, last, angle)
      call assertTrue(all(abs(offset(:, :first - 1)) <= 0.0_wp), message='tension lifts it off')
      axial(first) = -tension
      call lay_helix(mesh, axial, place, .true., .true., wall, load, offset, slope, last, angle)
      bending = sqrt(mesh%ei(1)/tension)
      middle = mesh%clearance(1)/(mesh%md(first) - bending)
      i = first/2
      call assertRelativelyEqual(middle, dot_product(slope(:, i), side), 1.0e-4_wp, message='leans')
      call assertRelativelyEqual(middle*mesh%md(i), dot_product(offset(:, i), side), 1.0e-4_wp, message='along a line')
      call assertLessThan(norm2(slope(:, first)), 1.0e-12_wp, message='along the wall')
      call assertRelativelyEqual(mesh%clearance(1), norm2(offset(:, first)), 1.0e-12_wp, message='to where it lies')
   end subroutine test_leaning

   !> A vertical hole, bent from `bottom` on, its string and mesh.
   subroutine vertical(model, mesh, depth, element)
      type(model_type), intent(out) :: model
      type(mesh_type), intent(out) :: mesh
      real(wp), intent(in) :: depth, element    !< of the bit, of elements [m]
      call new_well(model, [0.0_wp, bottom, bent], [0.0_wp, 0.0_wp, 20.0_wp], [0.0_wp, 0.0_wp, 0.0_wp], hole, 0.0_wp, &
                    pipe(weight, od, id))
      model%cases(1)%bit_depth = depth
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), element), mesh)
   end subroutine vertical

   subroutine room(mesh, axial, load, wall, place, offset, slope)
      type(mesh_type), intent(in) :: mesh
      real(wp), allocatable, intent(out) :: axial(:), load(:), wall(:), place(:), offset(:, :), slope(:, :)
      allocate (axial(mesh%nodes), load(mesh%nodes), offset(2, mesh%nodes), slope(2, mesh%nodes), source=0.0_wp)
      allocate (wall(mesh%elements), source=rigid)
      allocate (place(mesh%elements), source=1.0_wp)
   end subroutine room
end module dg_test_predicted_helix
