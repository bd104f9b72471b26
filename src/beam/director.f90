!> Unit tangent of the string at a node (its director d) from two slopes measured in the hole's frame.
!>
!> The slopes are plain additive unknowns: d = y/|y| with y = t + beta_1 n_1 + beta_2 n_2, where t, n_1, n_2 is
!> the rotation-minimising frame of the hole axis at the node. No finite rotation is ever composed, so a state
!> of the string is an array that may be scaled, interpolated and differenced. Valid below 90 deg from the axis.
!> Twist is no part of this: it stays a scalar (conventions 6 and 7 of src/README.md).
module dg_director
   use dg_kinds, only: wp
   implicit none
   private
   public :: director, director_gradient, director_curvature

contains

   !> Director [-] from the node's frame(3,3) = (t, n_1, n_2) in columns and slopes(2) [-].
   pure function director(frame, slopes) result(d)
      real(wp), intent(in) :: frame(3, 3)
      real(wp), intent(in) :: slopes(2)
      real(wp) :: d(3)
      d = (frame(:, 1) + slopes(1)*frame(:, 2) + slopes(2)*frame(:, 3))/sqrt(1.0_wp + slopes(1)**2 + slopes(2)**2)
   end function director

   !> dd/dbeta(3,2): columns span the plane across d.
   pure function director_gradient(frame, slopes, d) result(gradient)
      real(wp), intent(in) :: frame(3, 3)
      real(wp), intent(in) :: slopes(2)
      real(wp), intent(in) :: d(3)        !< director of these slopes
      real(wp) :: gradient(3, 2)
      real(wp) :: reciprocal
      reciprocal = 1.0_wp/sqrt(1.0_wp + slopes(1)**2 + slopes(2)**2)
      gradient(:, 1) = (frame(:, 2) - d*(slopes(1)*reciprocal))*reciprocal
      gradient(:, 2) = (frame(:, 3) - d*(slopes(2)*reciprocal))*reciprocal
   end function director_gradient

   !> Second derivative of d contracted with a director force g(3): h(k,l) = g . d2d/dbeta_k dbeta_l.
   !> It belongs to the consistent tangent wherever a force does work on a director.
   pure function director_curvature(frame, slopes, d, g) result(h)
      real(wp), intent(in) :: frame(3, 3)
      real(wp), intent(in) :: slopes(2)
      real(wp), intent(in) :: d(3)
      real(wp), intent(in) :: g(3)
      real(wp) :: h(2, 2)
      real(wp) :: square, a(2), b(2), gd
      square = 1.0_wp/(1.0_wp + slopes(1)**2 + slopes(2)**2)
      a = slopes*sqrt(square)                      ! d . n_k
      b = [dot_product(g, frame(:, 2)), dot_product(g, frame(:, 3))]
      gd = dot_product(g, d)
      h(1, 1) = -(2.0_wp*a(1)*b(1) + gd*(1.0_wp - 3.0_wp*a(1)*a(1)))*square
      h(2, 2) = -(2.0_wp*a(2)*b(2) + gd*(1.0_wp - 3.0_wp*a(2)*a(2)))*square
      h(1, 2) = -(a(1)*b(2) + a(2)*b(1) - 3.0_wp*gd*a(1)*a(2))*square
      h(2, 1) = h(1, 2)
   end function director_curvature
end module dg_director
