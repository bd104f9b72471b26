!> Unit tangent of the string at a node (its director d) from two slopes measured in the hole's frame.
!>
!> The slopes are plain additive unknowns: d = y/|y| with y = t + beta_1 n_1 + beta_2 n_2. Here t, n_1, n_2 is the
!> rotation-minimising frame of the hole axis at the node. No finite rotations are composed. A state of the string is therefore
!> an array that may be scaled, interpolated and differenced. Valid below 90 deg from the axis. Twist is not included: it stays
!> a scalar (conventions 6 and 7 of src/README.md).
module dg_director
   use dg_kinds, only: wp
   implicit none
   private
   public :: director, director_gradient, director_curvature

contains

   !> Director [-] from the node's frame(3,3) = (t, n_1, n_2) in columns and slopes(2) [-].
   pure function director(frame, slopes) result(d)
      real(wp), intent(in) :: frame(3, 3)   !< [-]
      real(wp), intent(in) :: slopes(2)     !< beta_1, beta_2 [-]
      real(wp) :: d(3)
      d = (frame(:, 1) + slopes(1)*frame(:, 2) + slopes(2)*frame(:, 3))/sqrt(1.0_wp + slopes(1)**2 + slopes(2)**2)
   end function director

   !> Derivative dd/dbeta(3,2) of a director d [-] by its slopes: s (n_k - d d.n_k) with s = d.t. The columns span the plane
   !> across d.
   pure function director_gradient(frame, d) result(gradient)
      real(wp), intent(in) :: frame(3, 3), d(3)   !< as in director [-]
      real(wp) :: gradient(3, 2)
      real(wp) :: s, d2, d3
      s = d(1)*frame(1, 1) + d(2)*frame(2, 1) + d(3)*frame(3, 1)
      d2 = d(1)*frame(1, 2) + d(2)*frame(2, 2) + d(3)*frame(3, 2)
      d3 = d(1)*frame(1, 3) + d(2)*frame(2, 3) + d(3)*frame(3, 3)
      gradient(1, 1) = s*(frame(1, 2) - d(1)*d2)
      gradient(2, 1) = s*(frame(2, 2) - d(2)*d2)
      gradient(3, 1) = s*(frame(3, 2) - d(3)*d2)
      gradient(1, 2) = s*(frame(1, 3) - d(1)*d3)
      gradient(2, 2) = s*(frame(2, 3) - d(2)*d3)
      gradient(3, 2) = s*(frame(3, 3) - d(3)*d3)
   end function director_gradient

   !> Second derivative of d contracted with a director force g(3): h(k,l) = g.d2d/dbeta_k dbeta_l, in the unit of g. It is
   !> part of the consistent tangent wherever a force does work on a director.
   pure function director_curvature(frame, d, g) result(h)
      real(wp), intent(in) :: frame(3, 3), d(3), g(3)   !< as in director [-]; force [N.m]
      real(wp) :: h(2, 2)                               !< [N.m]
      real(wp) :: square, a(2), b(2), gd
      square = dot_product(d, frame(:, 1))**2
      a = matmul(d, frame(:, 2:))
      b = matmul(g, frame(:, 2:))
      gd = dot_product(g, d)
      h(1, 1) = -(2.0_wp*a(1)*b(1) + gd*(1.0_wp - 3.0_wp*a(1)*a(1)))*square
      h(2, 2) = -(2.0_wp*a(2)*b(2) + gd*(1.0_wp - 3.0_wp*a(2)*a(2)))*square
      h(1, 2) = -(a(1)*b(2) + a(2)*b(1) - 3.0_wp*gd*a(1)*a(2))*square
      h(2, 1) = h(1, 2)
   end function director_curvature
end module dg_director
