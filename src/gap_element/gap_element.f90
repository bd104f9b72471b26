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
   public :: gap_nodal_force, gap_nodal_tangent, add_couple_tangent

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

   !> Derivatives of gap_nodal_force by (x_i, d_i, x_j, d_j), taken off `stiffness`(12,12), and those of the twisting,
   !> twist_row(2,12) with opposite sign: internal less external, as the assembly counts. x0 is held: states and
   !> places of the gaps are re-judged between iterations.
   pure subroutine gap_nodal_tangent(xi, shape, slope, d_i, d_j, direction, moment, force_tangent, moment_tangent, &
                                     stiffness, twist_row)
      real(wp), intent(in) :: xi, shape(4), slope(4), d_i(3), d_j(3), direction(3), moment(3)
      real(wp), intent(in) :: force_tangent(3, 3), moment_tangent(3, 3) !< dF/dr, dM/dr
      real(wp), intent(inout) :: stiffness(12, 12)
      real(wp), intent(out) :: twist_row(2, 12)
      real(wp) :: unit(3), bend(3), along, twist(3), column(3), rest
      real(wp) :: bend_by_r(3, 3), bend_by_slope(3, 3), twist_by_r(3), twist_by_slope(3)
      real(wp) :: by_point(12, 3), by_direction(12, 3), row_by_point(2, 3), row_by_direction(2, 3)
      integer :: b, j
      if (.not. (any(abs(moment) > 0.0_wp) .or. any(abs(moment_tangent) > 0.0_wp))) then
         call take_force_tangent(shape, force_tangent, stiffness)
         twist_row = 0.0_wp
         return
      end if
      rest = 1.0_wp - xi
      unit = direction/(direction(1)**2 + direction(2)**2 + direction(3)**2)
      bend = product_of(moment, unit)
      along = sum(moment*unit)
      twist = direction*along
      do j = 1, 3
         bend_by_r(:, j) = product_of(moment_tangent(:, j), unit)
         bend_by_slope(:, j) = -2.0_wp*bend*unit(j)
      end do
      ! d(M x r')/|r'|^2 at fixed length: the skew matrix of M
      column = moment/(direction(1)**2 + direction(2)**2 + direction(3)**2)
      bend_by_slope(2, 1) = bend_by_slope(2, 1) + column(3)
      bend_by_slope(3, 1) = bend_by_slope(3, 1) - column(2)
      bend_by_slope(1, 2) = bend_by_slope(1, 2) - column(3)
      bend_by_slope(3, 2) = bend_by_slope(3, 2) + column(1)
      bend_by_slope(1, 3) = bend_by_slope(1, 3) + column(2)
      bend_by_slope(2, 3) = bend_by_slope(2, 3) - column(1)
      do j = 1, 3
         by_point(:, j) = spread_out(shape, force_tangent(:, j)) + spread_out(slope, bend_by_r(:, j))
         by_direction(:, j) = spread_out(slope, bend_by_slope(:, j))
         twist_by_r = unit*sum(direction*moment_tangent(:, j))
         twist_by_slope = unit*moment(j) - 2.0_wp*twist*unit(j)
         twist_by_slope(j) = twist_by_slope(j) + along
         by_point(4:6, j) = by_point(4:6, j) + rest*product_of(twist_by_r, d_i)
         by_point(10:12, j) = by_point(10:12, j) + xi*product_of(twist_by_r, d_j)
         by_direction(4:6, j) = by_direction(4:6, j) + rest*product_of(twist_by_slope, d_i)
         by_direction(10:12, j) = by_direction(10:12, j) + xi*product_of(twist_by_slope, d_j)
         row_by_point(:, j) = -[rest*sum(twist_by_r*d_i), xi*sum(twist_by_r*d_j)]
         row_by_direction(:, j) = -[rest*sum(twist_by_slope*d_i), xi*sum(twist_by_slope*d_j)]
      end do
      call take_columns(shape, slope, by_point, by_direction, stiffness)
      do b = 1, 4
         twist_row(:, 3*b - 2:3*b) = shape(b)*row_by_point + slope(b)*row_by_direction
      end do
      ! the directors on which the twisting vector acts
      twist_row(1, 4:6) = twist_row(1, 4:6) - rest*twist
      twist_row(2, 10:12) = twist_row(2, 10:12) - xi*twist
      call take_skew(rest*twist, 4, stiffness)
      call take_skew(xi*twist, 10, stiffness)
   end subroutine gap_nodal_tangent

   !> The same where nothing turns the string: the force alone, a fifth of the work.
   pure subroutine take_force_tangent(shape, force_tangent, stiffness)
      real(wp), intent(in) :: shape(4), force_tangent(3, 3)
      real(wp), intent(inout) :: stiffness(12, 12)
      real(wp) :: by_point(12, 3)
      integer :: b, j, k
      do j = 1, 3
         by_point(:, j) = spread_out(shape, force_tangent(:, j))
      end do
      do b = 1, 4
         do j = 1, 3
            k = 3*(b - 1) + j
            stiffness(:, k) = stiffness(:, k) - shape(b)*by_point(:, j)
         end do
      end do
   end subroutine take_force_tangent

   !> Takes the derivatives of a force F on r and of P on r' at x0, by r and by r' (3,3), off `stiffness`(12,12).
   pure subroutine add_couple_tangent(shape, slope, force_by_point, force_by_direction, bend_by_point, bend_by_direction, stiffness)
      real(wp), intent(in) :: shape(4), slope(4)
      real(wp), intent(in) :: force_by_point(3, 3), force_by_direction(3, 3), bend_by_point(3, 3), bend_by_direction(3, 3)
      real(wp), intent(inout) :: stiffness(12, 12)
      real(wp) :: by_point(12, 3), by_direction(12, 3)
      integer :: j
      do j = 1, 3
         by_point(:, j) = spread_out(shape, force_by_point(:, j)) + spread_out(slope, bend_by_point(:, j))
         by_direction(:, j) = spread_out(shape, force_by_direction(:, j)) + spread_out(slope, bend_by_direction(:, j))
      end do
      call take_columns(shape, slope, by_point, by_direction, stiffness)
   end subroutine add_couple_tangent

   !> What a vector at x0 is on the four nodal vectors that carry it with the weights.
   pure function spread_out(weights, vector) result(nodal)
      real(wp), intent(in) :: weights(4), vector(3)
      real(wp) :: nodal(12)
      integer :: a
      do a = 1, 4
         nodal(3*a - 2) = weights(a)*vector(1)
         nodal(3*a - 1) = weights(a)*vector(2)
         nodal(3*a) = weights(a)*vector(3)
      end do
   end function spread_out

   !> Takes derivatives of nodal forces by r and by r' at x0 (12,3) off `stiffness`(12,12): r = N y, r' = N' y.
   pure subroutine take_columns(shape, slope, by_point, by_direction, stiffness)
      real(wp), intent(in) :: shape(4), slope(4), by_point(12, 3), by_direction(12, 3)
      real(wp), intent(inout) :: stiffness(12, 12)
      integer :: b, j, k
      do b = 1, 4
         do j = 1, 3
            k = 3*(b - 1) + j
            stiffness(:, k) = stiffness(:, k) - shape(b)*by_point(:, j) - slope(b)*by_direction(:, j)
         end do
      end do
   end subroutine take_columns

   !> Takes the matrix S(a), S(a) b = a x b, off the diagonal block that starts at `first`.
   pure subroutine take_skew(a, first, stiffness)
      real(wp), intent(in) :: a(3)
      integer, intent(in) :: first
      real(wp), intent(inout) :: stiffness(12, 12)
      integer :: f
      f = first
      stiffness(f + 1, f) = stiffness(f + 1, f) - a(3)
      stiffness(f + 2, f) = stiffness(f + 2, f) + a(2)
      stiffness(f, f + 1) = stiffness(f, f + 1) + a(3)
      stiffness(f + 2, f + 1) = stiffness(f + 2, f + 1) - a(1)
      stiffness(f, f + 2) = stiffness(f, f + 2) - a(2)
      stiffness(f + 1, f + 2) = stiffness(f + 1, f + 2) + a(1)
   end subroutine take_skew

   !> a x b, here so that it is inlined.
   pure function product_of(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function product_of
end module dg_gap_element
