!> The beam element of dg_beam_element in a plane, where tangents are angles: the same energy of the same measures,
!>
!>   U = EA L_m/2 (l (1 + b)/L_m - 1)**2 + (2 EI/L)(A + B),  A = alpha_i**2 + alpha_j**2,  B = alpha_i alpha_j
!>
!> with the signed angles alpha from the chord to the string's tangents. Its second derivative has ten numbers by the chord's
!> stretch and turn and by the two angles, and goes straight to the six unknowns of the nodes: a sixth of the work in space.
!>
!> Vectors of two are components along two fixed axes of the plane, the second a quarter turn from the first; angles count from the
!> first to the second. A node's unknowns are u along the hole axis, v across it (`across`, a quarter turn from `axis`) and the
!> slope beta of the string against the hole axis, whose angle is atan(beta).
module dg_plane_beam_element
   use dg_kinds, only: wp
   use dg_beam_angle, only: signed_angle
   use dg_beam_element, only: beam_section_type, energy_weights
   implicit none
   private
   public :: plane_node_type, new_plane_node, quarter_turn, plane_beam, unknowns
   public :: director_force, director_stiffness

   integer, parameter :: unknowns = 6   !< of an element: u, v, beta of its upper and of its lower node

   !> Where a node is and how it may move.
   type :: plane_node_type
      real(wp) :: axis(2) = 0.0_wp    !< hole axis' unit tangent t: motion by u
      real(wp) :: across(2) = 0.0_wp  !< a quarter turn from it: motion by v
      real(wp) :: shift(2) = 0.0_wp   !< displacement [m]
      real(wp) :: d(2) = 0.0_wp       !< string's unit tangent
      real(wp) :: turn = 1.0_wp       !< its angle's derivative by beta, 1/(1 + beta**2)
      real(wp) :: bend = 0.0_wp       !< and the second
   end type plane_node_type

contains

   !> A vector turned from the first axis to the second.
   pure function quarter_turn(a) result(b)
      real(wp), intent(in) :: a(2)
      real(wp) :: b(2)
      b(1) = -a(2)
      b(2) = a(1)
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

   !> Work-conjugate of beta of a force g on the node's director [N.m].
   pure function director_force(node, g) result(moment)
      type(plane_node_type), intent(in) :: node
      real(wp), intent(in) :: g(2)
      real(wp) :: moment
      moment = node%turn*(g(2)*node%d(1) - g(1)*node%d(2))
   end function director_force

   !> Its derivative by beta at fixed g: the consistent tangent has it wherever a force does work on a director.
   pure function director_stiffness(node, g) result(stiffness)
      type(plane_node_type), intent(in) :: node
      real(wp), intent(in) :: g(2)
      real(wp) :: stiffness
      stiffness = node%bend*(g(2)*node%d(1) - g(1)*node%d(2)) - node%turn**2*(g(1)*node%d(1) + g(2)*node%d(2))
   end function director_stiffness

   !> Internal force dU/d(u_i, v_i, beta_i, u_j, v_j, beta_j) [N, N, N.m] and, where it is wanted, the tangent d2U.
   pure subroutine plane_beam(section, chord, i, j, wanted, force, axial, stiffness)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: chord(2)               !< x_j - x_i [m]
      type(plane_node_type), intent(in) :: i, j
      logical, intent(in) :: wanted                  !< the tangent is
      real(wp), intent(out) :: force(unknowns)
      real(wp), intent(out) :: axial                 !< N, tension > 0 [N]
      real(wp), intent(inout) :: stiffness(unknowns, unknowns)
      real(wp) :: length, e(2), angle_i, angle_j, b_i, b_j, bowing, weight_a, weight_b, stretching, moment_i, moment_j
      real(wp) :: along(unknowns), aside(unknowns)   ! motion of the chord's end along and across it, by the unknowns
      real(wp) :: by_along(unknowns), by_aside(unknowns), stretched, slack, carried, bending, u_li, u_lj, u_ii, u_ij, u_jj
      real(wp) :: reciprocal, mixed
      integer :: c
      length = sqrt(chord(1)**2 + chord(2)**2)
      e = chord/length
      angle_i = signed_angle(e(1)*i%d(1) + e(2)*i%d(2), e(1)*i%d(2) - e(2)*i%d(1))
      angle_j = signed_angle(e(1)*j%d(1) + e(2)*j%d(2), e(1)*j%d(2) - e(2)*j%d(1))
      b_i = (4.0_wp*angle_i - angle_j)/30.0_wp       ! derivatives of b = (2 A - B)/30
      b_j = (4.0_wp*angle_j - angle_i)/30.0_wp
      bowing = 0.5_wp*(b_i*angle_i + b_j*angle_j)    ! homogeneous of second degree
      call energy_weights(section, length, bowing, axial, weight_a, weight_b)
      stretching = axial*(1.0_wp + bowing)
      moment_i = 2.0_wp*weight_a*angle_i + weight_b*angle_j
      moment_j = 2.0_wp*weight_a*angle_j + weight_b*angle_i
      along(1) = -(e(1)*i%axis(1) + e(2)*i%axis(2))
      along(2) = -(e(1)*i%across(1) + e(2)*i%across(2))
      along(4) = e(1)*j%axis(1) + e(2)*j%axis(2)
      along(5) = e(1)*j%across(1) + e(2)*j%across(2)
      aside(1) = -along(2)                           ! what is a quarter turn on across is a quarter turn back along
      aside(2) = along(1)
      aside(4) = -along(5)
      aside(5) = along(4)
      along([3, 6]) = 0.0_wp
      aside([3, 6]) = 0.0_wp
      force = stretching*along - ((moment_i + moment_j)/length)*aside
      force(3) = moment_i*i%turn
      force(6) = moment_j*j%turn
      if (.not. wanted) return
      ! second derivatives of U by l, alpha_i, alpha_j: what stretching adds, and what the axial force carries
      stretched = section%axial_stiffness/section%membrane_length
      slack = stretched*(1.0_wp + bowing)*length + axial
      carried = axial*length/30.0_wp
      bending = 2.0_wp*section%bending_stiffness/section%length
      u_li = slack*b_i
      u_lj = slack*b_j
      u_ii = stretched*length**2*b_i*b_i + 4.0_wp*carried + 2.0_wp*bending
      u_ij = stretched*length**2*b_i*b_j - carried + bending
      u_jj = stretched*length**2*b_j*b_j + 4.0_wp*carried + 2.0_wp*bending
      ! by the chord along and aside, alpha = theta - aside/l, and so by the unknowns
      reciprocal = 1.0_wp/length
      mixed = ((moment_i + moment_j)*reciprocal - (u_li + u_lj))*reciprocal
      by_along = stretched*(1.0_wp + bowing)**2*along + mixed*aside
      by_aside = mixed*along + ((u_ii + 2.0_wp*u_ij + u_jj)*reciprocal**2 + stretching*reciprocal)*aside
      do c = 1, unknowns
         stiffness(:, c) = along*by_along(c) + aside*by_aside(c)
      end do
      stiffness(:, 3) = i%turn*(u_li*along - ((u_ii + u_ij)*reciprocal)*aside)
      stiffness(:, 6) = j%turn*(u_lj*along - ((u_ij + u_jj)*reciprocal)*aside)
      stiffness(3, :) = stiffness(:, 3)
      stiffness(6, :) = stiffness(:, 6)
      stiffness(3, 3) = u_ii*i%turn**2 + moment_i*i%bend
      stiffness(6, 6) = u_jj*j%turn**2 + moment_j*j%bend
      stiffness(3, 6) = u_ij*i%turn*j%turn
      stiffness(6, 3) = stiffness(3, 6)
   end subroutine plane_beam
end module dg_plane_beam_element
