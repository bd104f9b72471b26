!> Equivalent nodal forces and stiffness of a gap element at x0 in its beam element: Eqs. 6 and 11 of the paper.
!>
!> A force F at r(xi0) = N y loads the nodal vectors y = (x_i, d_i, x_j, d_j) with N^T F. A moment M there is split along the
!> string's tangent:
!> - The part across bends: P = M x r'/|r'|^2 on r' = N' y, so N'^T P (the paper's dN^T/dx term).
!> - The part along it, m = r' (M.r')/|r'|^2, twists, and goes to the nodes as vectors (1 - xi) m and xi m.
!> Together they are statically the same as F and M, to round-off, in the displaced shape.
module dg_gap_element
   use dg_gap_contact, only: touch_tangent_type, touch_type
   use dg_kinds, only: wp
   use dg_vector, only: cross, skew
   implicit none
   private
   public :: gap_derivative_type, gap_nodal_force, gap_derivatives

   !> Derivatives of nodal forces and twisting by the point r and by r' at x0: r = N y, r' = N' y. Their rank is six at most,
   !> so that no matrix of 12 x 12 is made of them.
   type :: gap_derivative_type
      real(wp) :: point(3, 3, 4)               !< forces by r, on x_i, d_i, x_j, d_j in turn
      real(wp) :: direction(3, 3, 4)           !< the same by r'
      real(wp) :: twisting_by_point(3, 2) = 0.0_wp      !< torques on both nodes by r
      real(wp) :: twisting_by_direction(3, 2) = 0.0_wp  !< the same by r'
      !> Vector whose parts 1 - xi and xi twist the nodes. These parts turn with the nodes' directors. The force on d_i changes
      !> by (1 - xi) twist x dd_i, and the torque on node i by (1 - xi) twist.dd_i.
      !> (1 - xi) twist x dd_i, torque on node i by (1 - xi) twist.dd_i.
      real(wp) :: twist(3)
   end type gap_derivative_type

contains

   !> Nodal force(12) on (x_i, d_i, x_j, d_j) and twisting(2) on (phi_i, phi_j) [N, N.m], Eq. 6.
   pure subroutine gap_nodal_force(share, shape, slope, d_i, d_j, direction, force, moment, nodal, twisting)
      real(wp), intent(in) :: share(2)             !< parts of the nodes in M along the string: 1 - xi and xi, or zero [-]
      real(wp), intent(in) :: shape(4), slope(4)   !< N [-, m] and dN/dx [1/m, -] at xi
      real(wp), intent(in) :: d_i(3), d_j(3)       !< nodal directors [-]
      real(wp), intent(in) :: direction(3)         !< r' at xi, not normalised [-]
      real(wp), intent(in) :: force(3), moment(3)  !< F [N] and M [N.m] at the point
      real(wp), intent(out) :: nodal(12)           !< [N, N.m]
      real(wp), intent(out) :: twisting(2)         !< [N.m]
      real(wp) :: reciprocal, bend(3), twist(3)
      integer :: a
      reciprocal = 1.0_wp/(direction(1)**2 + direction(2)**2 + direction(3)**2)
      bend = cross(moment, direction)*reciprocal
      twist = direction*(sum(moment*direction)*reciprocal)
      do a = 1, 4
         nodal(3*a - 2) = shape(a)*force(1) + slope(a)*bend(1)
         nodal(3*a - 1) = shape(a)*force(2) + slope(a)*bend(2)
         nodal(3*a) = shape(a)*force(3) + slope(a)*bend(3)
      end do
      nodal(4:6) = nodal(4:6) + share(1)*cross(twist, d_i)
      nodal(10:12) = nodal(10:12) + share(2)*cross(twist, d_j)
      twisting(1) = share(1)*sum(twist*d_i)
      twisting(2) = share(2)*sum(twist*d_j)
   end subroutine gap_nodal_force

   !> Derivatives of gap_nodal_force and of a sliding string's couple, from those of force, moment and couple at the point. x0
   !> is constant, as places and states of the gaps are judged between iterations.
   pure subroutine gap_derivatives(touch, d, at_point, by)
      type(touch_type), intent(in) :: touch
      real(wp), intent(in) :: d(3, 2)   !< nodal directors [-]
      type(touch_tangent_type), intent(in) :: at_point
      type(gap_derivative_type), intent(out) :: by
      real(wp) :: u(3), across(3), turned(3), bend_by_point(3, 3), bend_by_direction(3, 3), along, square, moment, turn(3)
      integer :: a, j, p
      ! the moment's bend P = M x r'/|r'|^2 by r and r', besides that of the couple
      square = 1.0_wp/dot_product(touch%direction, touch%direction)
      u = touch%direction*square
      along = dot_product(at_point%moment, u)
      by%twist = touch%direction*along
      turned = -2.0_wp*cross(at_point%moment, u)
      bend_by_direction = at_point%bend_by_direction + skew(at_point%moment*square)
      do j = 1, 3
         bend_by_direction(:, j) = bend_by_direction(:, j) + turned*u(j)
         bend_by_point(:, j) = at_point%bend_by_point(:, j) + cross(at_point%moment_by_point(:, j), u)
      end do
      do a = 1, 4
         by%point(:, :, a) = touch%shape(a)*at_point%force_by_point + touch%slope(a)*bend_by_point
         by%direction(:, :, a) = touch%shape(a)*at_point%force_by_direction + touch%slope(a)*bend_by_direction
      end do
      ! effect of the moment along the string, r' (M.r')/|r'|^2, on the force on a node's director and on the twisting there
      turn = at_point%moment - 2.0_wp*along*touch%direction
      do p = 1, 2
         if (.not. touch%share(p) > 0.0_wp) cycle
         across = touch%share(p)*cross(u, d(:, p))
         do j = 1, 3
            moment = dot_product(touch%direction, at_point%moment_by_point(:, j))
            by%point(:, j, 2*p) = by%point(:, j, 2*p) + across*moment
            by%direction(:, j, 2*p) = by%direction(:, j, 2*p) + across*turn(j)
            by%twisting_by_point(j, p) = touch%share(p)*dot_product(u, d(:, p))*moment
         end do
         by%direction(:, :, 2*p) = by%direction(:, :, 2*p) - skew(touch%share(p)*along*d(:, p))
         by%twisting_by_direction(:, p) = touch%share(p)*(dot_product(u, d(:, p))*turn + along*d(:, p))
      end do
   end subroutine gap_derivatives
end module dg_gap_element
