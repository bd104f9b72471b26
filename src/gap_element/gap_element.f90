!> Equivalent nodal forces and stiffness of a gap element at x0 in its beam element: Eqs. 6 and 11 of the paper.
!>
!> A force F at r(xi0) = N y loads the nodal vectors y = (x_i, d_i, x_j, d_j) with N^T F. A moment M there is split
!> along the string's tangent: the part across bends, P = M x r'/|r'|^2 on r' = N' y, so N'^T P (the paper's
!> dN^T/dx term); the part along it, m, twists, and goes to the nodes as vectors (1 - xi) m and xi m.
!> All together are statically the same as F and M, to round-off, in the displaced shape.
module dg_gap_element
   use dg_kinds, only: wp
   use dg_vector, only: cross, outer, skew
   implicit none
   private
   public :: gap_nodal_force, gap_nodal_tangent

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
      reciprocal = 1.0_wp/dot_product(direction, direction)
      bend = cross(moment, direction)*reciprocal
      twist = direction*(dot_product(moment, direction)*reciprocal)
      do a = 1, 4
         nodal(3*a - 2:3*a) = shape(a)*force + slope(a)*bend
      end do
      nodal(4:6) = nodal(4:6) + (1.0_wp - xi)*cross(twist, d_i)
      nodal(10:12) = nodal(10:12) + xi*cross(twist, d_j)
      twisting = [(1.0_wp - xi)*dot_product(twist, d_i), xi*dot_product(twist, d_j)]
   end subroutine gap_nodal_force

   !> Derivatives of gap_nodal_force by (x_i, d_i, x_j, d_j): stiffness(12,12) and twist_stiffness(2,12), signs of
   !> the forces themselves (the assembly subtracts external forces). x0 is held: the states and places of the
   !> gaps are re-judged between iterations.
   pure subroutine gap_nodal_tangent(xi, shape, slope, d_i, d_j, direction, moment, force_tangent, moment_tangent, &
                                     stiffness, twist_stiffness)
      real(wp), intent(in) :: xi, shape(4), slope(4), d_i(3), d_j(3), direction(3), moment(3)
      real(wp), intent(in) :: force_tangent(3, 3), moment_tangent(3, 3) !< dF/dr, dM/dr
      real(wp), intent(out) :: stiffness(12, 12)
      real(wp), intent(out) :: twist_stiffness(2, 12)
      real(wp) :: reciprocal, bend(3), along, twist(3)
      real(wp) :: bend_by_r(3, 3), bend_by_slope(3, 3), twist_by_r(3, 3), twist_by_slope(3, 3)
      real(wp) :: by_node(3, 3), weight(2), director(3, 2)
      integer :: a, b, i, row, column
      reciprocal = 1.0_wp/dot_product(direction, direction)
      bend = cross(moment, direction)*reciprocal
      along = dot_product(moment, direction)*reciprocal
      twist = direction*along
      bend_by_r = -matmul(skew(direction), moment_tangent)*reciprocal
      bend_by_slope = (skew(moment) - 2.0_wp*outer(bend, direction))*reciprocal
      twist_by_r = outer(direction*reciprocal, matmul(direction, moment_tangent))
      twist_by_slope = outer(direction*reciprocal, moment) - outer(twist, direction)*(2.0_wp*reciprocal)
      do i = 1, 3
         twist_by_slope(i, i) = twist_by_slope(i, i) + along
      end do
      do b = 1, 4
         column = 3*b - 2
         do a = 1, 4
            row = 3*a - 2
            stiffness(row:row + 2, column:column + 2) = (shape(a)*shape(b))*force_tangent &
               + (slope(a)*shape(b))*bend_by_r + (slope(a)*slope(b))*bend_by_slope
         end do
      end do
      weight = [1.0_wp - xi, xi]
      director(:, 1) = d_i
      director(:, 2) = d_j
      do a = 1, 2
         row = 6*a - 2
         do b = 1, 4
            column = 3*b - 2
            by_node = weight(a)*(shape(b)*twist_by_r + slope(b)*twist_by_slope)
            stiffness(row:row + 2, column:column + 2) = stiffness(row:row + 2, column:column + 2) &
               - matmul(skew(director(:, a)), by_node)
            twist_stiffness(a, column:column + 2) = matmul(director(:, a), by_node)
         end do
         stiffness(row:row + 2, row:row + 2) = stiffness(row:row + 2, row:row + 2) + weight(a)*skew(twist)
         twist_stiffness(a, row:row + 2) = twist_stiffness(a, row:row + 2) + weight(a)*twist
      end do
   end subroutine gap_nodal_tangent
end module dg_gap_element
