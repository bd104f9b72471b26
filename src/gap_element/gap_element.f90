!> Equivalent nodal forces and stiffness of a gap element at x0 in its beam element: Eqs. 6 and 11 of the paper.
!>
!> A force F at r(xi0) = N y loads the nodal vectors y = (x_i, d_i, x_j, d_j) with N^T F. A moment M there is split
!> along the string's tangent: the part across bends, P = M x r'/|r'|^2 on r' = N' y, so N'^T P (the paper's
!> dN^T/dx term); the part along it, m = r' (M.r')/|r'|^2, twists, and goes to the nodes as vectors (1 - xi) m and
!> xi m. All together are statically the same as F and M, to round-off, in the displaced shape.
!>
!> Innermost loop: cross products are written out, since calls into other modules are not inlined.
module dg_gap_element
   use dg_kinds, only: wp
   implicit none
   private
   public :: gap_derivative_type, gap_nodal_force, gap_derivatives, couple_derivatives

   !> Derivatives of nodal forces and twisting by the point r and by r' at x0: r = N y, r' = N' y. They are of rank six at most, so
   !> no matrix of 12 x 12 is made of them.
   type :: gap_derivative_type
      real(wp) :: point(3, 4, 3)               !< forces on x_i, d_i, x_j, d_j by r
      logical :: turns                         !< a moment acts; without one what follows is not set
      real(wp) :: direction(3, 4, 3)           !< the same by r'
      real(wp) :: twisting_by_point(2, 3)      !< torques on both nodes by r
      real(wp) :: twisting_by_direction(2, 3)  !< the same by r'
      !> Vector whose shares 1 - xi and xi twist the nodes. These parts turn with the nodes' directors: force on d_i changes by
      !> (1 - xi) twist x dd_i, torque on node i by (1 - xi) twist.dd_i.
      real(wp) :: twist(3)
   end type gap_derivative_type

contains

   !> Nodal force(12) on (x_i, d_i, x_j, d_j) and twisting(2) on (phi_i, phi_j) [N, N.m], Eq. 6.
   pure subroutine gap_nodal_force(xi, shape, slope, d_i, d_j, direction, force, moment, nodal, twisting)
      real(wp), intent(in) :: xi                   !< x0/L
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
      nodal(4:6) = nodal(4:6) + (1.0_wp - xi)*product_of(twist, d_i)
      nodal(10:12) = nodal(10:12) + xi*product_of(twist, d_j)
      twisting(1) = (1.0_wp - xi)*sum(twist*d_i)
      twisting(2) = xi*sum(twist*d_j)
   end subroutine gap_nodal_force

   !> Derivatives of gap_nodal_force, where a force and a moment depend on the point by force_tangent and moment_tangent (3,3)
   !> [N/m, N]. x0 is held: states and places of the gaps are re-judged between iterations.
   pure subroutine gap_derivatives(xi, shape, slope, d, direction, moment, force_tangent, moment_tangent, by)
      real(wp), intent(in) :: xi, shape(4), slope(4), d(3, 2), direction(3), moment(3)   !< d: nodal directors
      real(wp), intent(in) :: force_tangent(3, 3), moment_tangent(3, 3) !< dF/dr, dM/dr
      type(gap_derivative_type), intent(out) :: by
      real(wp) :: unit(3), bend(3), along, column(3), share(2), square, twist_by_r(3), twist_by_slope(3), bend_by_slope(3, 3)
      integer :: a, j, p
      by%turns = any(abs(moment) > 0.0_wp) .or. any(abs(moment_tangent) > 0.0_wp)
      if (.not. by%turns) then
         do j = 1, 3
            do a = 1, 4
               by%point(:, a, j) = shape(a)*force_tangent(:, j)
            end do
         end do
         return
      end if
      share = [1.0_wp - xi, xi]
      square = 1.0_wp/(direction(1)**2 + direction(2)**2 + direction(3)**2)
      unit = direction*square
      bend = product_of(moment, unit)
      along = moment(1)*unit(1) + moment(2)*unit(2) + moment(3)*unit(3)
      by%twist = direction*along
      do j = 1, 3
         bend_by_slope(:, j) = -2.0_wp*bend*unit(j)
      end do
      ! d(M x r')/|r'|^2 at fixed length: the skew matrix of M
      column = moment*square
      bend_by_slope(2, 1) = bend_by_slope(2, 1) + column(3)
      bend_by_slope(3, 1) = bend_by_slope(3, 1) - column(2)
      bend_by_slope(1, 2) = bend_by_slope(1, 2) - column(3)
      bend_by_slope(3, 2) = bend_by_slope(3, 2) + column(1)
      bend_by_slope(1, 3) = bend_by_slope(1, 3) + column(2)
      bend_by_slope(2, 3) = bend_by_slope(2, 3) - column(1)
      do j = 1, 3
         column = product_of(moment_tangent(:, j), unit)
         do a = 1, 4
            by%point(:, a, j) = shape(a)*force_tangent(:, j) + slope(a)*column
            by%direction(:, a, j) = slope(a)*bend_by_slope(:, j)
         end do
         twist_by_r = unit*(direction(1)*moment_tangent(1, j) + direction(2)*moment_tangent(2, j) &
                            + direction(3)*moment_tangent(3, j))
         twist_by_slope = unit*moment(j) - 2.0_wp*by%twist*unit(j)
         twist_by_slope(j) = twist_by_slope(j) + along
         do p = 1, 2
            by%point(:, 2*p, j) = by%point(:, 2*p, j) + share(p)*product_of(twist_by_r, d(:, p))
            by%direction(:, 2*p, j) = by%direction(:, 2*p, j) + share(p)*product_of(twist_by_slope, d(:, p))
            by%twisting_by_point(p, j) = share(p)*(twist_by_r(1)*d(1, p) + twist_by_r(2)*d(2, p) + twist_by_r(3)*d(3, p))
            by%twisting_by_direction(p, j) = share(p)*(twist_by_slope(1)*d(1, p) + twist_by_slope(2)*d(2, p) &
                                                       + twist_by_slope(3)*d(3, p))
         end do
      end do
   end subroutine gap_derivatives

   !> The same of a force F on r and of P on r' at x0, that depend on r and r' by derivatives (3,3).
   pure subroutine couple_derivatives(shape, slope, force_by_point, force_by_direction, bend_by_point, bend_by_direction, by)
      real(wp), intent(in) :: shape(4), slope(4)
      real(wp), intent(in) :: force_by_point(3, 3), force_by_direction(3, 3), bend_by_point(3, 3), bend_by_direction(3, 3)
      type(gap_derivative_type), intent(out) :: by
      integer :: a, j
      by%turns = .true.
      by%twist = 0.0_wp
      by%twisting_by_point = 0.0_wp
      by%twisting_by_direction = 0.0_wp
      do j = 1, 3
         do a = 1, 4
            by%point(:, a, j) = shape(a)*force_by_point(:, j) + slope(a)*bend_by_point(:, j)
            by%direction(:, a, j) = shape(a)*force_by_direction(:, j) + slope(a)*bend_by_direction(:, j)
         end do
      end do
   end subroutine couple_derivatives

   !> a x b, here so that it is inlined.
   pure function product_of(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function product_of
end module dg_gap_element
