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
!>
!> A string that does not rotate takes M_GA as a couple that bends it, P = -dV/dr' and F = -dV/dr of V = r R a d.n with
!> the string's unit tangent d = r'/|r'|: the same moment d x P = -r R a tau to first order, and in addition
!> F_tau = -r R a (d.tau)/|f| along tau. Applied as a plain vector, M_GA does work on a coiled string that turns as a whole about
!> the hole: in a vertical hole nothing balances that, and no equilibrium exists. On a real string the wall's
!> circumferential stiction does; F_tau, some percent of R, is the least that takes it. A rotating string's friction
!> is used up circumferentially, so that it keeps the plain M.
module dg_gap_contact
   use dg_kinds, only: wp
   implicit none
   private
   public :: normal_force_type, contact_action, contact_action_tangent, couple_action, sliding_couple, support_action

   !> A normal force for contact_action_tangent.
   type :: normal_force_type
      real(wp) :: force = 0.0_wp      !< [N]
      real(wp) :: stiffness = 0.0_wp  !< its derivative by |f| [N/m]
      real(wp) :: carried = 0.0_wp    !< what the derivatives take for it [N]
   end type normal_force_type

contains

   !> Force F(3) [N] and moment M(3) [N.m] on the string.
   pure subroutine contact_action(gap, tangent, normal_force, axial, rotary, climbing, radius, force, moment)
      real(wp), intent(in) :: gap(3)        !< f [m], not zero, across tangent
      real(wp), intent(in) :: tangent(3)    !< t of the hole axis at the foot
      real(wp), intent(in) :: normal_force  !< R [N]
      real(wp), intent(in) :: axial         !< a: > 0 pushes the string down the hole [-]
      real(wp), intent(in) :: rotary        !< m >= 0 [-]
      real(wp), intent(in) :: climbing      !< what stands for m in the force: m, or 0 where the string whirls [-]
      real(wp), intent(in) :: radius        !< r [m]
      real(wp), intent(out) :: force(3)
      real(wp), intent(out) :: moment(3)
      real(wp) :: n(3), tau(3)
      n = gap*(1.0_wp/sqrt(gap(1)*gap(1) + gap(2)*gap(2) + gap(3)*gap(3)))
      tau = product_of(tangent, n)
      force = normal_force*(-n + axial*tangent - climbing*tau)
      moment = -radius*normal_force*(axial*tau + rotary*tangent)
   end subroutine contact_action

   !> As contact_action, with the derivatives of F and M by the point's position (3,3) [N/m, N].
   !> Friction may be asked for at another normal force Q than R, with another derivative: a lagged one, or none. The
   !> derivatives may be asked for as if R and Q were others than in F and M.
   pure subroutine contact_action_tangent(gap, tangent, curvature, normal, pressing, axial, rotary, climbing, radius, &
                                          force, moment, force_tangent, moment_tangent)
      real(wp), intent(in) :: gap(3), tangent(3)
      real(wp), intent(in) :: curvature(3)             !< k = dt/ds of the hole axis at the foot [1/m]
      type(normal_force_type), intent(in) :: normal    !< R
      type(normal_force_type), intent(in) :: pressing  !< Q
      real(wp), intent(in) :: axial, rotary, radius
      real(wp), intent(in) :: climbing      !< what stands for m in the force: m, or 0 where the string whirls [-]
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
      direction = axial*tangent - climbing*tau
      lever = -radius*(axial*tau + rotary*tangent)
      force = pressing%force*direction - normal%force*n
      moment = pressing%force*lever
      ! dyads with n, tau and t on the right
      by_n = pressing%stiffness*direction - normal%stiffness*n
      by_tau = reciprocal*(pressing%carried*climbing*n - normal%carried*tau)
      by_t = pressing%carried*(chi*(axial*curvature + climbing*k_tau*tangent)) &
             - (normal%carried*(1.0_wp - chi)*reciprocal)*tangent
      lever_n = pressing%stiffness*lever
      lever_tau = (pressing%carried*radius*axial*reciprocal)*n
      lever_t = (pressing%carried*radius*chi)*(axial*k_tau*tangent - rotary*curvature)
      do j = 1, 3
         force_tangent(:, j) = by_n*n(j) + by_tau*tau(j) + by_t*tangent(j)
         moment_tangent(:, j) = lever_n*n(j) + lever_tau*tau(j) + lever_t*tangent(j)
      end do
   end subroutine contact_action_tangent

   !> The couple of axial friction on a string that does not rotate: F_tau on the point and P on r'.
   pure subroutine couple_action(gap, tangent, direction, couple, force, bend)
      real(wp), intent(in) :: gap(3), tangent(3)
      real(wp), intent(in) :: direction(3)      !< r' of the string there, not normalised
      real(wp), intent(in) :: couple            !< r R a [N.m]
      real(wp), intent(out) :: force(3)         !< on the point [N]
      real(wp), intent(out) :: bend(3)          !< on r' [N.m]
      real(wp) :: n(3), tau(3), d(3), reciprocal, stretch
      reciprocal = 1.0_wp/sqrt(gap(1)*gap(1) + gap(2)*gap(2) + gap(3)*gap(3))
      stretch = 1.0_wp/sqrt(direction(1)*direction(1) + direction(2)*direction(2) + direction(3)*direction(3))
      n = gap*reciprocal
      d = direction*stretch
      tau = product_of(tangent, n)
      force = -(couple*reciprocal*(d(1)*tau(1) + d(2)*tau(2) + d(3)*tau(3)))*tau
      bend = -(couple*stretch)*(n - d*(d(1)*n(1) + d(2)*n(2) + d(3)*n(3)))
   end subroutine couple_action

   !> As couple_action, with the derivatives of F_tau and P by the point and by r' (3,3); R's own derivative makes them unsymmetric.
   pure subroutine sliding_couple(gap, tangent, curvature, direction, couple, couple_stiffness, force, bend, force_by_point, &
                                  force_by_direction, bend_by_point, bend_by_direction)
      real(wp), intent(in) :: gap(3), tangent(3), curvature(3)
      real(wp), intent(in) :: direction(3)      !< r' of the string there, not normalised
      real(wp), intent(in) :: couple            !< r R a [N.m]
      real(wp), intent(in) :: couple_stiffness  !< its derivative by |f| [N]
      real(wp), intent(out) :: force(3)         !< on the point [N]
      real(wp), intent(out) :: bend(3)          !< on r' [N.m]
      real(wp), intent(out) :: force_by_point(3, 3), force_by_direction(3, 3), bend_by_point(3, 3), bend_by_direction(3, 3)
      real(wp) :: n(3), tau(3), d(3), across(3), by_t(3), reciprocal, chi, stretch, d_n, d_tau
      integer :: j
      reciprocal = 1.0_wp/sqrt(sum(gap*gap))
      n = gap*reciprocal
      tau = product_of(tangent, n)
      chi = 1.0_wp/(1.0_wp - sum(curvature*gap))
      stretch = 1.0_wp/sqrt(sum(direction*direction))
      d = direction*stretch
      d_n = sum(d*n)
      d_tau = sum(d*tau)
      across = n - d*d_n
      force = -(couple*reciprocal*d_tau)*tau
      bend = -(couple*stretch)*across
      by_t = product_of(curvature, n)
      by_t = -(couple*reciprocal*chi)*(sum(d*by_t)*tau + d_tau*by_t)    ! from dtau along t
      do j = 1, 3
         force_by_point(:, j) = by_t*tangent(j) - reciprocal*d_tau*(couple_stiffness - couple*reciprocal)*tau*n(j) &
                                + (couple*reciprocal**2)*(d_n*tau + d_tau*n)*tau(j)
         force_by_direction(:, j) = -(couple*reciprocal*stretch)*tau*(tau(j) - d_tau*d(j))
         bend_by_point(:, j) = -(couple_stiffness*stretch)*across*n(j) &
            - (couple*stretch*reciprocal)*((tau - d*d_tau)*tau(j) + ((1.0_wp - chi)*(tangent - d*sum(d*tangent)))*tangent(j))
         bend_by_direction(:, j) = (couple*stretch**2)*(across*d(j) + d*across(j) - d_n*d*d(j))
         bend_by_direction(j, j) = bend_by_direction(j, j) + couple*stretch**2*d_n
      end do
   end subroutine sliding_couple

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
