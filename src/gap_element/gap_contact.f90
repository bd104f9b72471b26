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
   use dg_vector, only: cross, outer
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
      tau = cross(tangent, n)
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
      real(wp) :: n(3), tau(3), distance, chi, k_tau, direction(3), lever(3)
      distance = norm2(gap)
      n = gap/distance
      tau = cross(tangent, n)
      chi = 1.0_wp/(1.0_wp - dot_product(curvature, gap))
      k_tau = dot_product(curvature, tau)
      direction = -n + axial*tangent - rotary*tau
      lever = -radius*(axial*tau + rotary*tangent)
      force = normal_force*direction
      moment = normal_force*lever
      force_tangent = outer(stiffness*direction, n) + normal_force*( &
         outer((rotary*n - tau)/distance, tau) + &
         outer(chi*(axial*curvature + rotary*k_tau*tangent) - ((1.0_wp - chi)/distance)*tangent, tangent))
      moment_tangent = outer(stiffness*lever, n) + (normal_force*radius)*( &
         outer((axial/distance)*n, tau) + outer(chi*(axial*k_tau*tangent - rotary*curvature), tangent))
   end subroutine contact_action_tangent

   !> A support that holds a node on the hole axis with a stiff spring [N/m], sliding freely along it:
   !> force F = -k f on the string and its derivative.
   pure subroutine support_action(gap, tangent, curvature, stiffness, force, force_tangent)
      real(wp), intent(in) :: gap(3), tangent(3), curvature(3)
      real(wp), intent(in) :: stiffness
      real(wp), intent(out) :: force(3)
      real(wp), intent(out) :: force_tangent(3, 3)
      integer :: i
      force = -stiffness*gap
      force_tangent = outer(tangent*(stiffness/(1.0_wp - dot_product(curvature, gap))), tangent)
      do i = 1, 3
         force_tangent(i, i) = force_tangent(i, i) - stiffness
      end do
   end subroutine support_action
end module dg_gap_contact
