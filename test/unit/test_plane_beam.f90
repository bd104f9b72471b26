!> The beam element in a plane: force and tangent against those in space, and against differences.
module dg_test_plane_beam
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use dg_beam_angle, only: signed_angle
   use dg_beam_element, only: beam_section_type, beam_tangent
   use dg_director, only: director_curvature, director_gradient
   use dg_kinds, only: wp
   use dg_plane_beam_element, only: plane_beam, plane_node_type, unknowns
   implicit none
   private
   public :: plane_beam_suite

   type(beam_section_type), parameter :: section = beam_section_type(5.0_wp, 5.02_wp, 7.0e8_wp, 1.2e6_wp, 0.9e6_wp)
   !> Configurations: a hole axis that turns by `bend` over the element, nodes off it; the last is bent as no string ever is, beyond
   !> the series of the angles.
   integer, parameter :: configurations = 7
   !> Round-off of a thousand operations on numbers whose largest cancel to a thousandth.
   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   function plane_beam_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('plane_beam')
      call suite%addTest(TestMethod('signed_angle', test_signed_angle))
      call suite%addTest(TestMethod('against_space', test_against_space))
      call suite%addTest(TestMethod('against_differences', test_against_differences))
      call suite%addTest(TestMethod('weights', test_weights))
   end function plane_beam_suite

   !> All quadrants, both sides of the switch to the series.
   subroutine test_signed_angle()
      real(wp), parameter :: angle(10) = [0.0_wp, 1.0e-9_wp, -1.0e-3_wp, 0.19_wp, -0.2_wp, 0.21_wp, 1.0_wp, -1.6_wp, 3.1_wp, &
                                          -3.1_wp]
      integer :: i
      do i = 1, size(angle)
         call assertEqual(angle(i), signed_angle(cos(angle(i)), sin(angle(i))), 4.0_wp*epsilon(1.0_wp)*abs(angle(i)), &
                          message='angle')
      end do
   end subroutine test_signed_angle

   !> The unknowns of a configuration, and the hole axis' tangents at both nodes.
   pure subroutine configuration(number, x, axes)
      integer, intent(in) :: number
      real(wp), intent(out) :: x(unknowns), axes(2, 2)
      real(wp) :: start, bend
      start = 0.9_wp*number
      bend = 0.02_wp*sin(3.7_wp*number)
      x = [0.01_wp*sin(1.1_wp*number), 0.04_wp*cos(2.3_wp*number), 0.03_wp*sin(4.1_wp*number), &
           0.013_wp*cos(1.9_wp*number), 0.05_wp*sin(0.7_wp*number), 0.02_wp*cos(5.3_wp*number)]
      if (number == configurations) then
         bend = 0.9_wp
         x([3, 6]) = [-1.2_wp, 0.8_wp]
      end if
      axes(:, 1) = [cos(start), sin(start)]
      axes(:, 2) = [cos(start + bend), sin(start + bend)]
   end subroutine configuration

   !> A vector turned from the first axis to the second.
   pure function quarter_turn(a) result(b)
      real(wp), intent(in) :: a(2)
      real(wp) :: b(2)
      b = [-a(2), a(1)]
   end function quarter_turn

   !> A node of unknowns u, v [m] and beta [-] where the hole axis points to `axis`.
   pure function new_plane_node(axis, u, v, beta) result(node)
      real(wp), intent(in) :: axis(2)
      real(wp), intent(in) :: u, v, beta
      type(plane_node_type) :: node
      node%axis = axis
      node%across = quarter_turn(axis)
      node%shift = u*node%axis + v*node%across
      node%turn = 1.0_wp/(1.0_wp + beta*beta)
      node%bend = -2.0_wp*beta*node%turn*node%turn
      node%d = (node%axis + beta*node%across)*sqrt(node%turn)
   end function new_plane_node

   pure subroutine set_up(x, axes, i, j, chord)
      real(wp), intent(in) :: x(unknowns), axes(2, 2)
      type(plane_node_type), intent(out) :: i, j
      real(wp), intent(out) :: chord(2)
      i = new_plane_node(axes(:, 1), x(1), x(2), x(3))
      j = new_plane_node(axes(:, 2), x(4), x(5), x(6))
      chord = 2.5_wp*(axes(:, 1) + axes(:, 2)) + j%shift - i%shift
   end subroutine set_up

   !> The element in space, its two axes laid into a tilted plane, and turned to the same unknowns.
   subroutine test_against_space()
      type(plane_node_type) :: i, j
      real(wp) :: x(unknowns), axes(2, 2), chord(2), force(unknowns), axial, stiffness(unknowns, unknowns)
      real(wp) :: plane(3, 2), frames(3, 3, 2), ways(12, unknowns), d(3, 2)
      real(wp) :: spatial(12), spatial_axial, tangent(12, 12), expected(unknowns), matrix(unknowns, unknowns), h(2, 2), g(3, 2)
      integer :: c, n, row
      plane(:, 1) = [2.0_wp, 2.0_wp, 1.0_wp]/3.0_wp
      plane(:, 2) = [-2.0_wp, 1.0_wp, 2.0_wp]/3.0_wp
      do c = 1, configurations
         call configuration(c, x, axes)
         call set_up(x, axes, i, j, chord)
         stiffness = 0.0_wp
         call plane_beam(section, chord, i, j, .true., force, axial, stiffness)
         d(:, 1) = matmul(plane, i%d)
         d(:, 2) = matmul(plane, j%d)
         call beam_tangent(section, matmul(plane, chord), d(:, 1), d(:, 2), spatial, spatial_axial, tangent)
         ways = 0.0_wp
         do n = 1, 2
            frames(:, 1, n) = matmul(plane, axes(:, n))
            frames(:, 2, n) = matmul(plane, quarter_turn(axes(:, n)))
            frames(:, 3, n) = [1.0_wp, -2.0_wp, 2.0_wp]/3.0_wp
            row = 6*(n - 1)
            ways(row + 1:row + 3, 3*n - 2) = frames(:, 1, n)
            ways(row + 1:row + 3, 3*n - 1) = frames(:, 2, n)
            associate (gradient => director_gradient(frames(:, :, n), d(:, n)))
               ways(row + 4:row + 6, 3*n) = gradient(:, 1)
            end associate
         end do
         expected = matmul(spatial, ways)
         matrix = matmul(transpose(ways), matmul(tangent, ways))
         g = reshape([spatial(4:6), spatial(10:12)], [3, 2])
         do n = 1, 2
            h = director_curvature(frames(:, :, n), d(:, n), g(:, n))
            matrix(3*n, 3*n) = matrix(3*n, 3*n) + h(1, 1)
         end do
         call assertEqual(spatial_axial, axial, round_off*section%axial_stiffness, message='axial force')
         call assertLessThan(maxval(abs(force - expected)), 0.01_wp*round_off*maxval(abs(tangent)), message='force')
         call assertLessThan(maxval(abs(stiffness - matrix)), round_off*maxval(abs(tangent)), message='tangent')
      end do
   end subroutine test_against_space

   !> Central differences of the force, their error the third derivative's: 1e-10 of the stiffness with steps of 1e-5.
   subroutine test_against_differences()
      real(wp) :: x(unknowns), axes(2, 2), stiffness(unknowns, unknowns), differences(unknowns, unknowns)
      real(wp), parameter :: step = 1.0e-5_wp, tolerance = 1.0e-7_wp
      integer :: c, k
      do c = 1, configurations
         call configuration(c, x, axes)
         stiffness = 0.0_wp
         do k = 1, unknowns
            differences(:, k) = (moved(k, step) - moved(k, -step))/(2.0_wp*step)
         end do
         call keep_tangent()
         call assertLessThan(maxval(abs(stiffness - differences))/maxval(abs(stiffness)), tolerance, message='tangent')
      end do

   contains

      function moved(k, by) result(force)
         integer, intent(in) :: k
         real(wp), intent(in) :: by
         real(wp) :: force(unknowns)
         type(plane_node_type) :: i, j
         real(wp) :: y(unknowns), chord(2), axial, none(unknowns, unknowns)
         y = x
         y(k) = y(k) + by
         none = 0.0_wp
         call set_up(y, axes, i, j, chord)
         call plane_beam(section, chord, i, j, .false., force, axial, none)
      end function moved

      subroutine keep_tangent()
         type(plane_node_type) :: i, j
         real(wp) :: force(unknowns), chord(2), axial
         call set_up(x, axes, i, j, chord)
         call plane_beam(section, chord, i, j, .true., force, axial, stiffness)
      end subroutine keep_tangent
   end subroutine test_against_differences

   !> Axial force and end moments by the energy's own definition: what it has of A and of B.
   subroutine test_weights()
      type(plane_node_type) :: i, j
      real(wp) :: x(unknowns), axes(2, 2), chord(2), force(unknowns), axial, none(unknowns, unknowns)
      real(wp) :: length, angle(2), bowing, expected, weight_a, weight_b
      integer :: c
      do c = 1, configurations
         call configuration(c, x, axes)
         call set_up(x, axes, i, j, chord)
         call plane_beam(section, chord, i, j, .false., force, axial, none)
         length = norm2(chord)
         angle = [turn_to(i%d), turn_to(j%d)]
         bowing = (2.0_wp*sum(angle**2) - product(angle))/30.0_wp
         expected = section%axial_stiffness*(length*(1.0_wp + bowing)/section%membrane_length - 1.0_wp)
         weight_a = 2.0_wp*section%bending_stiffness/section%length + 2.0_wp*expected*length/30.0_wp
         weight_b = 2.0_wp*section%bending_stiffness/section%length - expected*length/30.0_wp
         call assertEqual(expected, axial, round_off*section%axial_stiffness, message='axial force')
         call assertEqual((2.0_wp*weight_a*angle(1) + weight_b*angle(2))*i%turn, force(3), round_off*section%axial_stiffness, &
                          message='moment')
         call assertEqual((2.0_wp*weight_a*angle(2) + weight_b*angle(1))*j%turn, force(6), round_off*section%axial_stiffness, &
                          message='moment')
      end do

   contains

      function turn_to(d) result(angle)
         real(wp), intent(in) :: d(2)
         real(wp) :: angle
         angle = atan2(chord(1)*d(2) - chord(2)*d(1), dot_product(chord, d))
      end function turn_to
   end subroutine test_weights
end module dg_test_plane_beam
