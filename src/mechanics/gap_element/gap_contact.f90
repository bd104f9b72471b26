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
!> Near a helix a string that does not rotate takes M_GA as a couple that bends it, P = -dV/dr' and F = -dV/dr of V = r R a d.n with
!> the string's unit tangent d = r'/|r'|. That is the same moment d x P = -r R a tau to first order, and in addition
!> F_tau = -r R a (d.tau)/|f| along tau. Applied as a plain vector, M_GA does work on a helix that turns as a whole about the hole:
!> in a vertical hole nothing balances that, and no equilibrium exists. On a real string the wall's circumferential stiction does.
!> F_tau, some percent of R, is the least that takes it. Elsewhere F_tau is wrong: at a stabilizer |f| is small, and F_tau large.
module dg_gap_contact
   use dg_kinds, only: wp
   use dg_lanes, only: lanes
   implicit none
   private
   public :: touch_type, touch_tangent_type, contact_action, touch_tangents, moment_tangents, couple_action, couple_tangents
   public :: support_action

   !> Gaps that touch, side by side, as their derivatives ask for them. Friction may be asked for at another normal force Q than
   !> R, with another derivative, and the couple at another product r R a: parts of a tangent have some of them at zero. A gap that
   !> is free has none of the three.
   type :: touch_type
      real(wp), dimension(lanes, 3) :: gap         !< f [m], not zero, across tangent
      real(wp), dimension(lanes, 3) :: tangent     !< t of the hole axis at the foot
      real(wp), dimension(lanes, 3) :: curvature   !< k = dt/ds there [1/m]
      real(wp), dimension(lanes, 3) :: direction   !< r' of the string, not normalised
      real(wp), dimension(lanes) :: normal, normal_stiffness       !< R and its derivative by |f| [N, N/m]
      real(wp), dimension(lanes) :: pressing, pressing_stiffness   !< Q and its derivative [N, N/m]
      real(wp), dimension(lanes) :: couple, couple_stiffness       !< r R a of a sliding string and its derivative [N.m, N]
      real(wp), dimension(lanes) :: axial, rotary, climbing, radius   !< as of contact_action
      real(wp), dimension(lanes, 2) :: share       !< 1 - xi and xi, the part of either node in a moment along the string
      real(wp), dimension(lanes, 4) :: shape, slope   !< N and dN/dx at xi
      logical :: rubs                              !< some have a moment
      logical :: slides                            !< some have a couple
   end type touch_type

   !> Derivatives of F, M and of the couple's P, at gaps side by side.
   type :: touch_tangent_type
      real(wp), dimension(lanes, 3) :: n, tau, moment
      real(wp), dimension(lanes) :: reciprocal, chi             !< 1/|f|, and of the header
      real(wp), dimension(lanes, 3, 3) :: force_by_point, moment_by_point
      real(wp), dimension(lanes, 3, 3) :: force_by_direction, bend_by_point, bend_by_direction   !< of the couple, by r and r'
   end type touch_tangent_type

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

   !> Derivatives of F by the point's position [N/m], and what the other derivatives need.
   pure subroutine touch_tangents(touch, by)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: by
      real(wp) :: n1, n2, n3, tau1, tau2, tau3, t1, t2, t3, reciprocal, chi, k_tau, of_n, of_tau, of_t, along
      real(wp) :: x1, x2, x3, y1, y2, y3, z1, z2, z3
      integer :: l, j
      do l = 1, lanes
         t1 = touch%tangent(l, 1)
         t2 = touch%tangent(l, 2)
         t3 = touch%tangent(l, 3)
         reciprocal = 1.0_wp/sqrt(touch%gap(l, 1)**2 + touch%gap(l, 2)**2 + touch%gap(l, 3)**2)
         n1 = touch%gap(l, 1)*reciprocal
         n2 = touch%gap(l, 2)*reciprocal
         n3 = touch%gap(l, 3)*reciprocal
         tau1 = t2*n3 - t3*n2
         tau2 = t3*n1 - t1*n3
         tau3 = t1*n2 - t2*n1
         chi = 1.0_wp/(1.0_wp - (touch%curvature(l, 1)*touch%gap(l, 1) + touch%curvature(l, 2)*touch%gap(l, 2) &
                                 + touch%curvature(l, 3)*touch%gap(l, 3)))
         k_tau = touch%curvature(l, 1)*tau1 + touch%curvature(l, 2)*tau2 + touch%curvature(l, 3)*tau3
         by%n(l, 1) = n1
         by%n(l, 2) = n2
         by%n(l, 3) = n3
         by%tau(l, 1) = tau1
         by%tau(l, 2) = tau2
         by%tau(l, 3) = tau3
         by%reciprocal(l) = reciprocal
         by%chi(l) = chi
         ! dyads with n, tau and t on the right: x, y and z on the left
         of_n = -touch%normal_stiffness(l)
         of_tau = -touch%pressing_stiffness(l)*touch%climbing(l)
         of_t = touch%pressing_stiffness(l)*touch%axial(l)
         x1 = of_n*n1 + of_tau*tau1 + of_t*t1
         x2 = of_n*n2 + of_tau*tau2 + of_t*t2
         x3 = of_n*n3 + of_tau*tau3 + of_t*t3
         of_n = reciprocal*touch%pressing(l)*touch%climbing(l)
         of_tau = -reciprocal*touch%normal(l)
         y1 = of_n*n1 + of_tau*tau1
         y2 = of_n*n2 + of_tau*tau2
         y3 = of_n*n3 + of_tau*tau3
         along = touch%pressing(l)*chi*touch%axial(l)
         of_t = touch%pressing(l)*chi*touch%climbing(l)*k_tau - touch%normal(l)*(1.0_wp - chi)*reciprocal
         z1 = along*touch%curvature(l, 1) + of_t*t1
         z2 = along*touch%curvature(l, 2) + of_t*t2
         z3 = along*touch%curvature(l, 3) + of_t*t3
         do j = 1, 3
            by%force_by_point(l, 1, j) = x1*by%n(l, j) + y1*by%tau(l, j) + z1*touch%tangent(l, j)
            by%force_by_point(l, 2, j) = x2*by%n(l, j) + y2*by%tau(l, j) + z2*touch%tangent(l, j)
            by%force_by_point(l, 3, j) = x3*by%n(l, j) + y3*by%tau(l, j) + z3*touch%tangent(l, j)
         end do
      end do
   end subroutine touch_tangents

   !> M by Q, and its derivatives by the point's position [N.m, N]; after touch_tangents.
   pure subroutine moment_tangents(touch, by)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: by
      real(wp) :: lever(3), x, y, z, of_n, of_k, of_t, k_tau
      integer :: l, i
      do l = 1, lanes
         k_tau = touch%curvature(l, 1)*by%tau(l, 1) + touch%curvature(l, 2)*by%tau(l, 2) + touch%curvature(l, 3)*by%tau(l, 3)
         of_n = touch%pressing(l)*touch%radius(l)*touch%axial(l)*by%reciprocal(l)
         of_t = touch%pressing(l)*touch%radius(l)*by%chi(l)*touch%axial(l)*k_tau
         of_k = -touch%pressing(l)*touch%radius(l)*by%chi(l)*touch%rotary(l)
         do i = 1, 3
            lever(i) = -touch%radius(l)*(touch%axial(l)*by%tau(l, i) + touch%rotary(l)*touch%tangent(l, i))
            by%moment(l, i) = touch%pressing(l)*lever(i)
            x = touch%pressing_stiffness(l)*lever(i)
            y = of_n*by%n(l, i)
            z = of_t*touch%tangent(l, i) + of_k*touch%curvature(l, i)
            by%moment_by_point(l, i, 1) = x*by%n(l, 1) + y*by%tau(l, 1) + z*touch%tangent(l, 1)
            by%moment_by_point(l, i, 2) = x*by%n(l, 2) + y*by%tau(l, 2) + z*touch%tangent(l, 2)
            by%moment_by_point(l, i, 3) = x*by%n(l, 3) + y*by%tau(l, 3) + z*touch%tangent(l, 3)
         end do
      end do
   end subroutine moment_tangents

   !> The couple of axial friction on a string that is near a helix and does not rotate: F_tau on the point and P on r'.
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

   !> Derivatives of F_tau and P by the point and by r' (3,3): those of F_tau by the point are added to those of F. After
   !> touch_tangents; the couple's own derivative makes them unsymmetric.
   pure subroutine couple_tangents(touch, by)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: by
      real(wp) :: d(3), across(3), along_t(3), by_t(3), stretch, d_n, d_tau, d_t, turned, of_n, of_tau, swing, k_n(3)
      integer :: l, i, j
      do l = 1, lanes
         stretch = 1.0_wp/sqrt(touch%direction(l, 1)**2 + touch%direction(l, 2)**2 + touch%direction(l, 3)**2)
         d(1) = touch%direction(l, 1)*stretch
         d(2) = touch%direction(l, 2)*stretch
         d(3) = touch%direction(l, 3)*stretch
         d_n = d(1)*by%n(l, 1) + d(2)*by%n(l, 2) + d(3)*by%n(l, 3)
         d_tau = d(1)*by%tau(l, 1) + d(2)*by%tau(l, 2) + d(3)*by%tau(l, 3)
         ! from dtau along t
         k_n(1) = touch%curvature(l, 2)*by%n(l, 3) - touch%curvature(l, 3)*by%n(l, 2)
         k_n(2) = touch%curvature(l, 3)*by%n(l, 1) - touch%curvature(l, 1)*by%n(l, 3)
         k_n(3) = touch%curvature(l, 1)*by%n(l, 2) - touch%curvature(l, 2)*by%n(l, 1)
         turned = d(1)*k_n(1) + d(2)*k_n(2) + d(3)*k_n(3)
         swing = touch%couple(l)*by%reciprocal(l)
         of_n = -by%reciprocal(l)*d_tau*(touch%couple_stiffness(l) - swing)
         of_tau = swing*by%reciprocal(l)
         do i = 1, 3
            by_t(i) = -swing*by%chi(l)*(turned*by%tau(l, i) + d_tau*k_n(i))
            do j = 1, 3
               by%force_by_point(l, i, j) = by%force_by_point(l, i, j) + by_t(i)*touch%tangent(l, j) &
                                            + of_n*by%tau(l, i)*by%n(l, j) &
                                            + of_tau*(d_n*by%tau(l, i) + d_tau*by%n(l, i))*by%tau(l, j)
               by%force_by_direction(l, i, j) = -swing*stretch*by%tau(l, i)*(by%tau(l, j) - d_tau*d(j))
            end do
         end do
         d_t = d(1)*touch%tangent(l, 1) + d(2)*touch%tangent(l, 2) + d(3)*touch%tangent(l, 3)
         swing = touch%couple(l)*stretch*by%reciprocal(l)
         do i = 1, 3
            across(i) = by%n(l, i) - d(i)*d_n
            along_t(i) = (1.0_wp - by%chi(l))*(touch%tangent(l, i) - d(i)*d_t)
         end do
         of_n = -touch%couple_stiffness(l)*stretch
         of_tau = touch%couple(l)*stretch*stretch
         do j = 1, 3
            do i = 1, 3
               by%bend_by_point(l, i, j) = of_n*across(i)*by%n(l, j) &
                                       - swing*((by%tau(l, i) - d(i)*d_tau)*by%tau(l, j) + along_t(i)*touch%tangent(l, j))
               by%bend_by_direction(l, i, j) = of_tau*(across(i)*d(j) + d(i)*across(j) - d_n*d(i)*d(j))
            end do
            by%bend_by_direction(l, j, j) = by%bend_by_direction(l, j, j) + of_tau*d_n
         end do
      end do
   end subroutine couple_tangents

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
