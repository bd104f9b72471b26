!> Equivalent nodal forces and stiffness of a gap element at x0 in its beam element: Eqs. 6 and 11 of the paper.
!>
!> A force F at r(xi0) = N y loads the nodal vectors y = (x_i, d_i, x_j, d_j) with N^T F. A moment M there is split
!> along the string's tangent: the part across bends, P = M x r'/|r'|^2 on r' = N' y, so N'^T P (the paper's
!> dN^T/dx term); the part along it, m = r' (M.r')/|r'|^2, twists, and goes to the nodes as vectors (1 - xi) m and
!> xi m. All together are statically the same as F and M, to round-off, in the displaced shape.
!>
!> Innermost loop: cross products are written out, since calls into other modules are not inlined.
module dg_gap_element
   use dg_gap_contact, only: touch_tangent_type, touch_type
   use dg_kinds, only: wp
   use dg_lanes, only: lanes
   implicit none
   private
   public :: gap_derivative_type, gap_nodal_force, gap_derivatives

   !> Derivatives of nodal forces and twisting by the point r and by r' at x0: r = N y, r' = N' y. They are of rank six at most, so
   !> no matrix of 12 x 12 is made of them.
   type :: gap_derivative_type
      real(wp) :: point(lanes, 3, 3, 4)               !< forces by r, on x_i, d_i, x_j, d_j in turn
      real(wp) :: direction(lanes, 3, 3, 4)           !< the same by r'
      real(wp) :: twisting_by_point(lanes, 3, 2)      !< torques on both nodes by r; this and what follows are set where gaps rub
      real(wp) :: twisting_by_direction(lanes, 3, 2)  !< the same by r'
      !> Vector whose shares 1 - xi and xi twist the nodes. These parts turn with the nodes' directors: force on d_i changes by
      !> (1 - xi) twist x dd_i, torque on node i by (1 - xi) twist.dd_i.
      real(wp) :: twist(lanes, 3)
   end type gap_derivative_type

contains

   !> Nodal force(12) on (x_i, d_i, x_j, d_j) and twisting(2) on (phi_i, phi_j) [N, N.m], Eq. 6.
   pure subroutine gap_nodal_force(share, shape, slope, d_i, d_j, direction, force, moment, nodal, twisting)
      real(wp), intent(in) :: share(2)             !< of the nodes in M along the string: 1 - xi and xi, or zero
      real(wp), intent(in) :: shape(4), slope(4)   !< N and dN/dx at xi
      real(wp), intent(in) :: d_i(3), d_j(3)       !< nodal directors
      real(wp), intent(in) :: direction(3)         !< r' at xi, not normalised
      real(wp), intent(in) :: force(3), moment(3)  !< F [N] and M [N.m] at the point
      real(wp), intent(out) :: nodal(12)
      real(wp), intent(out) :: twisting(2)
      real(wp) :: reciprocal, bend(3), twist(3)
      integer :: a
      reciprocal = 1.0_wp/(direction(1)**2 + direction(2)**2 + direction(3)**2)
      bend = product_of(moment, direction)*reciprocal
      twist = direction*(sum(moment*direction)*reciprocal)
      do a = 1, 4
         nodal(3*a - 2) = shape(a)*force(1) + slope(a)*bend(1)
         nodal(3*a - 1) = shape(a)*force(2) + slope(a)*bend(2)
         nodal(3*a) = shape(a)*force(3) + slope(a)*bend(3)
      end do
      nodal(4:6) = nodal(4:6) + share(1)*product_of(twist, d_i)
      nodal(10:12) = nodal(10:12) + share(2)*product_of(twist, d_j)
      twisting(1) = share(1)*sum(twist*d_i)
      twisting(2) = share(2)*sum(twist*d_j)
   end subroutine gap_nodal_force

   !> Derivatives of gap_nodal_force and of a sliding string's couple at gaps side by side, from those of force, moment and couple
   !> at the point. x0 is held: states and places of the gaps are re-judged between iterations.
   pure subroutine gap_derivatives(touch, d, at_point, by)
      type(touch_type), intent(in) :: touch
      real(wp), intent(in) :: d(lanes, 3, 2)               !< nodal directors
      type(touch_tangent_type), intent(inout) :: at_point  !< bends by r and r' are completed
      type(gap_derivative_type), intent(inout) :: by
      integer :: p
      if (.not. touch%slides) then
         at_point%force_by_direction = 0.0_wp
         at_point%bend_by_point = 0.0_wp
         at_point%bend_by_direction = 0.0_wp
      end if
      if (touch%rubs) call bend_by_moment(touch, at_point, by%twist)
      call forces_and_bends(touch%shape, touch%slope, at_point%force_by_point, at_point%bend_by_point, by%point)
      call forces_and_bends(touch%shape, touch%slope, at_point%force_by_direction, at_point%bend_by_direction, by%direction)
      if (.not. touch%rubs) return
      do p = 1, 2
         call add_twist(touch, touch%share(:, p), d(:, :, p), at_point, by%point(:, :, :, 2*p), by%direction(:, :, :, 2*p), &
                        by%twisting_by_point(:, :, p), by%twisting_by_direction(:, :, p))
      end do
   end subroutine gap_derivatives

   !> Adds the moment's bend P = M x r'/|r'|^2 by r and r' to that of the couple. `twist` is r' (M.r')/|r'|^2.
   pure subroutine bend_by_moment(touch, at_point, twist)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: at_point
      real(wp), intent(out) :: twist(lanes, 3)
      real(wp) :: square, u1, u2, u3, m1, m2, m3, b1, b2, b3, along
      integer :: l, j
      do l = 1, lanes
         square = 1.0_wp/(touch%direction(l, 1)**2 + touch%direction(l, 2)**2 + touch%direction(l, 3)**2)
         u1 = touch%direction(l, 1)*square
         u2 = touch%direction(l, 2)*square
         u3 = touch%direction(l, 3)*square
         m1 = at_point%moment(l, 1)
         m2 = at_point%moment(l, 2)
         m3 = at_point%moment(l, 3)
         along = m1*u1 + m2*u2 + m3*u3
         twist(l, 1) = touch%direction(l, 1)*along
         twist(l, 2) = touch%direction(l, 2)*along
         twist(l, 3) = touch%direction(l, 3)*along
         ! d(M x r')/|r'|^2 at fixed length: the skew matrix of M
         b1 = -2.0_wp*(m2*u3 - m3*u2)
         b2 = -2.0_wp*(m3*u1 - m1*u3)
         b3 = -2.0_wp*(m1*u2 - m2*u1)
         m1 = m1*square
         m2 = m2*square
         m3 = m3*square
         at_point%bend_by_direction(l, 1, 1) = at_point%bend_by_direction(l, 1, 1) + b1*u1
         at_point%bend_by_direction(l, 2, 1) = at_point%bend_by_direction(l, 2, 1) + b2*u1 + m3
         at_point%bend_by_direction(l, 3, 1) = at_point%bend_by_direction(l, 3, 1) + b3*u1 - m2
         at_point%bend_by_direction(l, 1, 2) = at_point%bend_by_direction(l, 1, 2) + b1*u2 - m3
         at_point%bend_by_direction(l, 2, 2) = at_point%bend_by_direction(l, 2, 2) + b2*u2
         at_point%bend_by_direction(l, 3, 2) = at_point%bend_by_direction(l, 3, 2) + b3*u2 + m1
         at_point%bend_by_direction(l, 1, 3) = at_point%bend_by_direction(l, 1, 3) + b1*u3 + m2
         at_point%bend_by_direction(l, 2, 3) = at_point%bend_by_direction(l, 2, 3) + b2*u3 - m1
         at_point%bend_by_direction(l, 3, 3) = at_point%bend_by_direction(l, 3, 3) + b3*u3
         do j = 1, 3
            at_point%bend_by_point(l, 1, j) = at_point%bend_by_point(l, 1, j) + at_point%moment_by_point(l, 2, j)*u3 &
                                              - at_point%moment_by_point(l, 3, j)*u2
            at_point%bend_by_point(l, 2, j) = at_point%bend_by_point(l, 2, j) + at_point%moment_by_point(l, 3, j)*u1 &
                                              - at_point%moment_by_point(l, 1, j)*u3
            at_point%bend_by_point(l, 3, j) = at_point%bend_by_point(l, 3, j) + at_point%moment_by_point(l, 1, j)*u2 &
                                              - at_point%moment_by_point(l, 2, j)*u1
         end do
      end do
   end subroutine bend_by_moment

   !> What forces on r and bends on r' make of the nodal forces.
   pure subroutine forces_and_bends(shape, slope, force, bend, nodal)
      real(wp), intent(in), dimension(lanes, 4) :: shape, slope
      real(wp), intent(in), dimension(lanes, 3, 3) :: force, bend
      real(wp), intent(out) :: nodal(lanes, 3, 3, 4)
      integer :: l, a, i, j
      do a = 1, 4
         do j = 1, 3
            do i = 1, 3
               do l = 1, lanes
                  nodal(l, i, j, a) = shape(l, a)*force(l, i, j) + slope(l, a)*bend(l, i, j)
               end do
            end do
         end do
      end do
   end subroutine forces_and_bends

   !> What the moment along the string, r' (M.r')/|r'|^2, makes of the force on a node's director and of the twisting there.
   pure subroutine add_twist(touch, share, d, at_point, point, direction, twisting_by_point, twisting_by_direction)
      type(touch_type), intent(in) :: touch
      real(wp), intent(in) :: share(lanes), d(lanes, 3)    !< of the node
      type(touch_tangent_type), intent(in) :: at_point
      real(wp), intent(inout), dimension(lanes, 3, 3) :: point, direction
      real(wp), intent(out), dimension(lanes, 3) :: twisting_by_point, twisting_by_direction
      real(wp) :: across(lanes, 3), u_d(lanes), along(lanes), u1, u2, u3, square, m, w
      integer :: l, j
      do l = 1, lanes
         square = 1.0_wp/(touch%direction(l, 1)**2 + touch%direction(l, 2)**2 + touch%direction(l, 3)**2)
         u1 = touch%direction(l, 1)*square
         u2 = touch%direction(l, 2)*square
         u3 = touch%direction(l, 3)*square
         along(l) = u1*at_point%moment(l, 1) + u2*at_point%moment(l, 2) + u3*at_point%moment(l, 3)
         ! r'/|r'|^2 across and along the director
         across(l, 1) = share(l)*(u2*d(l, 3) - u3*d(l, 2))
         across(l, 2) = share(l)*(u3*d(l, 1) - u1*d(l, 3))
         across(l, 3) = share(l)*(u1*d(l, 2) - u2*d(l, 1))
         u_d(l) = share(l)*(u1*d(l, 1) + u2*d(l, 2) + u3*d(l, 3))
      end do
      do j = 1, 3
         do l = 1, lanes
            m = touch%direction(l, 1)*at_point%moment_by_point(l, 1, j) &
                + touch%direction(l, 2)*at_point%moment_by_point(l, 2, j) &
                + touch%direction(l, 3)*at_point%moment_by_point(l, 3, j)
            point(l, 1, j) = point(l, 1, j) + across(l, 1)*m
            point(l, 2, j) = point(l, 2, j) + across(l, 2)*m
            point(l, 3, j) = point(l, 3, j) + across(l, 3)*m
            twisting_by_point(l, j) = u_d(l)*m
            w = at_point%moment(l, j) - 2.0_wp*along(l)*touch%direction(l, j)
            direction(l, 1, j) = direction(l, 1, j) + across(l, 1)*w
            direction(l, 2, j) = direction(l, 2, j) + across(l, 2)*w
            direction(l, 3, j) = direction(l, 3, j) + across(l, 3)*w
            twisting_by_direction(l, j) = u_d(l)*w + share(l)*along(l)*d(l, j)
         end do
      end do
      ! along the string, e_j x d
      do l = 1, lanes
         u1 = share(l)*along(l)*d(l, 1)
         u2 = share(l)*along(l)*d(l, 2)
         u3 = share(l)*along(l)*d(l, 3)
         direction(l, 2, 1) = direction(l, 2, 1) - u3
         direction(l, 3, 1) = direction(l, 3, 1) + u2
         direction(l, 1, 2) = direction(l, 1, 2) + u3
         direction(l, 3, 2) = direction(l, 3, 2) - u1
         direction(l, 1, 3) = direction(l, 1, 3) - u2
         direction(l, 2, 3) = direction(l, 2, 3) + u1
      end do
   end subroutine add_twist

   !> a x b, here so that it is inlined.
   pure function product_of(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function product_of
end module dg_gap_element
