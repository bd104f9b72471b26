!> Force and moment of a touching string at one point: Eqs. 4 and 5 of the paper, with their derivatives.
!>
!> Measured where the point now is: f is its offset from the hole axis across the tangent t there. With n = f/|f|
!> outwards and tau = t x n (the way a right-hand turning string's surface moves at the wall),
!>   F = R (-n + a t - m tau)                           a: signed axial, m: rotary friction coefficient
!>   M = r n x F = -r R (a tau + m t)                   r: contact radius; M_GA across, M_Gt along t
!> R_GN = R, R_GA = a R, R_Gt = m R, M_GA = r R_GA, M_Gt = r R_Gt in the paper's letters.
!> Moving the point by dr moves its foot on the axis by ds = chi t.dr, chi = 1/(1 - k.f), k the axis' curvature, so
!>   d|f| = n.dr,  dn = (tau tau + (1 - chi) t t)/|f| dr,  dt = chi k t.dr,  dtau = chi (k x n) t.dr - n tau.dr/|f|
!> Friction makes the derivative unsymmetric.
module dg_gap_contact
   use dg_kinds, only: wp
   implicit none
   private
   public :: contact_action, contact_action_tangent, support_action

contains

   !> Force F(3) [N] and moment M(3) [N.m] on the string.
   pure subroutine contact_action(gap, tangent, normal_force, axial, rotary, radius, force, moment)
      real(wp), intent(in) :: gap(3)        !< f [m], not zero, across tangent
      real(wp), intent(in) :: tangent(3)    !< t of the hole axis at the foot
      real(wp), intent(in) :: normal_force  !< R [N]
      real(wp), intent(in) :: axial         !< a: > 0 pushes the string down the hole [-]
      real(wp), intent(in) :: rotary        !< m >= 0 [-]
      real(wp), intent(in) :: radius        !< r [m]
      real(wp), intent(out) :: force(3)
      real(wp), intent(out) :: moment(3)
      real(wp) :: n(3), tau(3)
      n = gap/norm2(gap)
      tau = product_of(tangent, n)
      force = normal_force*(-n + axial*tangent - rotary*tau)
      moment = -radius*normal_force*(axial*tau + rotary*tangent)
   end subroutine contact_action

   !> As contact_action, with the derivatives of F and M by the point's position (3,3) [N/m, N].
   pure subroutine contact_action_tangent(gap, tangent, curvature, normal_force, stiffness, axial, rotary, radius, &
                                          force, moment, force_tangent, moment_tangent)
      real(wp), intent(in) :: gap(3), tangent(3)
      real(wp), intent(in) :: curvature(3)  !< k = dt/ds of the hole axis at the foot [1/m]
      real(wp), intent(in) :: normal_force  !< R [N]
      real(wp), intent(in) :: stiffness     !< dR/d|f| [N/m]
      real(wp), intent(in) :: axial, rotary, radius
      real(wp), intent(out) :: force(3), moment(3)
      real(wp), intent(out) :: force_tangent(3, 3), moment_tangent(3, 3)
      real(wp) :: n(3), tau(3), reciprocal, chi, k_tau, direction(3), lever(3)
      real(wp) :: by_n(3), by_tau(3), by_t(3), lever_n(3), lever_tau(3), lever_t(3)
      integer :: j
      reciprocal = 1.0_wp/sqrt(sum(gap*gap))
      n = gap*reciprocal
      tau = product_of(tangent, n)
      chi = 1.0_wp/(1.0_wp - sum(curvature*gap))
      k_tau = sum(curvature*tau)
      direction = -n + axial*tangent - rotary*tau
      lever = -radius*(axial*tau + rotary*tangent)
      force = normal_force*direction
      moment = normal_force*lever
      ! dyads with n, tau and t on the right
      by_n = stiffness*direction
      by_tau = (normal_force*reciprocal)*(rotary*n - tau)
      by_t = normal_force*(chi*(axial*curvature + rotary*k_tau*tangent) - ((1.0_wp - chi)*reciprocal)*tangent)
      lever_n = stiffness*lever
      lever_tau = (normal_force*radius*axial*reciprocal)*n
      lever_t = (normal_force*radius*chi)*(axial*k_tau*tangent - rotary*curvature)
      do j = 1, 3
         force_tangent(:, j) = by_n*n(j) + by_tau*tau(j) + by_t*tangent(j)
         moment_tangent(:, j) = lever_n*n(j) + lever_tau*tau(j) + lever_t*tangent(j)
      end do
   end subroutine contact_action_tangent

   !> A support that holds a node on the hole axis with a stiff spring [N/m], sliding freely along it:
   !> force F = -k f on the string and its derivative.
   pure subroutine support_action(gap, tangent, curvature, stiffness, force, force_tangent)
      real(wp), intent(in) :: gap(3), tangent(3), curvature(3)
      real(wp), intent(in) :: stiffness
      real(wp), intent(out) :: force(3)
      real(wp), intent(out) :: force_tangent(3, 3)
      real(wp) :: along
      integer :: j
      force = -stiffness*gap
      along = stiffness/(1.0_wp - sum(curvature*gap))
      do j = 1, 3
         force_tangent(:, j) = along*tangent*tangent(j)
         force_tangent(j, j) = force_tangent(j, j) - stiffness
      end do
   end subroutine support_action

   !> a x b, here so that it is inlined.
   pure function product_of(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function product_of
end module dg_gap_contact
