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
      real(wp) :: unit(3), bend(3), along, twist(3), column(3), by_shape(3), by_slope(3), rest
      real(wp) :: bend_by_r(3, 3), bend_by_slope(3, 3), twist_by_r(3, 3), twist_by_slope(3, 3)
      integer :: a, b, j, k
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
         twist_by_r(:, j) = unit*sum(direction*moment_tangent(:, j))
         twist_by_slope(:, j) = unit*moment(j) - 2.0_wp*twist*unit(j)
         twist_by_slope(j, j) = twist_by_slope(j, j) + along
      end do
      ! d(M x r')/|r'|^2 at fixed length: the skew matrix of M
      column = moment/(direction(1)**2 + direction(2)**2 + direction(3)**2)
      bend_by_slope(2, 1) = bend_by_slope(2, 1) + column(3)
      bend_by_slope(3, 1) = bend_by_slope(3, 1) - column(2)
      bend_by_slope(1, 2) = bend_by_slope(1, 2) - column(3)
      bend_by_slope(3, 2) = bend_by_slope(3, 2) + column(1)
      bend_by_slope(1, 3) = bend_by_slope(1, 3) + column(2)
      bend_by_slope(2, 3) = bend_by_slope(2, 3) - column(1)
      do b = 1, 4
         do j = 1, 3
            k = 3*(b - 1) + j
            by_shape = shape(b)*force_tangent(:, j)
            by_slope = shape(b)*bend_by_r(:, j) + slope(b)*bend_by_slope(:, j)
            do a = 1, 4
               stiffness(3*a - 2, k) = stiffness(3*a - 2, k) - shape(a)*by_shape(1) - slope(a)*by_slope(1)
               stiffness(3*a - 1, k) = stiffness(3*a - 1, k) - shape(a)*by_shape(2) - slope(a)*by_slope(2)
               stiffness(3*a, k) = stiffness(3*a, k) - shape(a)*by_shape(3) - slope(a)*by_slope(3)
            end do
            column = shape(b)*twist_by_r(:, j) + slope(b)*twist_by_slope(:, j)
            stiffness(4:6, k) = stiffness(4:6, k) - rest*product_of(column, d_i)
            stiffness(10:12, k) = stiffness(10:12, k) - xi*product_of(column, d_j)
            twist_row(1, k) = -rest*sum(column*d_i)
            twist_row(2, k) = -xi*sum(column*d_j)
         end do
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
      real(wp) :: by_shape(3)
      integer :: a, b, j, k
      do b = 1, 4
         do j = 1, 3
            k = 3*(b - 1) + j
            by_shape = shape(b)*force_tangent(:, j)
            do a = 1, 4
               stiffness(3*a - 2, k) = stiffness(3*a - 2, k) - shape(a)*by_shape(1)
               stiffness(3*a - 1, k) = stiffness(3*a - 1, k) - shape(a)*by_shape(2)
               stiffness(3*a, k) = stiffness(3*a, k) - shape(a)*by_shape(3)
            end do
         end do
      end do
   end subroutine take_force_tangent

   !> Takes the derivatives of a force F on r and of P on r' at x0, by r and by r' (3,3), off `stiffness`(12,12).
   pure subroutine add_couple_tangent(shape, slope, force_by_point, force_by_direction, bend_by_point, bend_by_direction, stiffness)
      real(wp), intent(in) :: shape(4), slope(4)
      real(wp), intent(in) :: force_by_point(3, 3), force_by_direction(3, 3), bend_by_point(3, 3), bend_by_direction(3, 3)
      real(wp), intent(inout) :: stiffness(12, 12)
      real(wp) :: on_force(3), on_bend(3)
      integer :: a, b, j, k
      do b = 1, 4
         do j = 1, 3
            k = 3*(b - 1) + j
            on_force = shape(b)*force_by_point(:, j) + slope(b)*force_by_direction(:, j)
            on_bend = shape(b)*bend_by_point(:, j) + slope(b)*bend_by_direction(:, j)
            do a = 1, 4
               stiffness(3*a - 2:3*a, k) = stiffness(3*a - 2:3*a, k) - shape(a)*on_force - slope(a)*on_bend
            end do
         end do
      end do
   end subroutine add_couple_tangent

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
