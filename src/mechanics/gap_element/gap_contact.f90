!> Force and moment of a touching string at one point: Eqs. 4 and 5 of the paper, with their derivatives.
!>
!> Measured at the present place of the point: f is its offset from the hole axis across the tangent t there. n = f/|f| points
!> outwards. A right-hand turning string's surface moves at the wall along tau = t x n. Force and moment are
!>   F = R (-n + a t - m tau)
!>   M = r n x F = -r R (a tau + m t)
!> with the signed axial friction coefficient a, the rotary one m, and the contact radius r. In the paper's letters R_GN = R,
!> R_GA = a R and R_Gt = m R. M_GA = r R_GA is across t, and M_Gt = r R_Gt along t. When the point moves by dr, its foot on the
!> axis moves by ds = chi t.dr, with chi = 1/(1 - k.f) and k the axis' curvature. Hence
!>   d|f| = n.dr,  dn = (tau tau + (1 - chi) t t)/|f| dr,  dt = chi k t.dr,  dtau = chi (k x n) t.dr - n tau.dr/|f|
!> Friction makes the derivative unsymmetric.
!>
!> Near a helix a string that does not rotate takes M_GA as a couple that bends it. P = -dV/dr' acts on its slope r' and
!> F = -dV/dr on its place r. Both derive from V = r R a d.n with the unit tangent d = r'/|r'|. That is the same moment d x
!> P = -r R a tau to first order, and in addition F_tau = -r R a (d.tau)/|f| along tau. As a plain vector, M_GA would do work
!> on a helix that turns as a whole about the hole. In a vertical hole nothing balances that work, and no equilibrium exists.
!> On a real string friction around the hole, at rest, balances it. F_tau, some per cent of R, is the smallest force that
!> cancels that work. Elsewhere F_tau is wrong: at a stabilizer |f| is small, and F_tau large.
module dg_gap_contact
   use dg_kinds, only: wp
   implicit none
   private
   public :: touch_type, touch_tangent_type, contact_action, touch_tangents, moment_tangents, couple_action, couple_tangents
   public :: support_action

   !> A gap that touches, with the inputs of its derivatives. Friction may have another normal force Q than R, with another
   !> derivative. The couple may have another product r R a. Parts of a tangent have some of them at zero.
   type :: touch_type
      real(wp) :: gap(3)         !< f [m], not zero, across tangent
      real(wp) :: tangent(3)     !< t of the hole axis at the foot
      real(wp) :: curvature(3)   !< k = dt/ds there [1/m]
      real(wp) :: direction(3)   !< r' of the string, not normalised
      real(wp) :: normal = 0.0_wp, normal_stiffness = 0.0_wp       !< R and its derivative by |f| [N, N/m]
      real(wp) :: pressing = 0.0_wp, pressing_stiffness = 0.0_wp   !< Q and its derivative [N, N/m]
      real(wp) :: couple = 0.0_wp, couple_stiffness = 0.0_wp       !< r R a of a sliding string and its derivative [N.m, N]
      real(wp) :: axial, rotary, sideways, radius                  !< as in contact_action
      real(wp) :: share(2)            !< 1 - xi and xi, the part of either node in a moment along the string
      real(wp) :: shape(4), slope(4)  !< N and dN/dx at xi
   end type touch_type

   !> Derivatives of F, M and of the couple's P.
   type :: touch_tangent_type
      real(wp), dimension(3) :: n, tau, moment
      real(wp) :: reciprocal, chi             !< 1/|f|, and chi of the header
      real(wp), dimension(3, 3) :: force_by_point, moment_by_point
      !> Derivatives of the couple's force and bend by r and r'; zero without a couple.
      real(wp), dimension(3, 3) :: force_by_direction = 0.0_wp, bend_by_point = 0.0_wp, bend_by_direction = 0.0_wp
   end type touch_tangent_type

contains

   !> Force F(3) [N] and moment M(3) [N.m] on the string.
   pure subroutine contact_action(gap, tangent, normal_force, axial, rotary, sideways, radius, force, moment)
      real(wp), intent(in) :: gap(3)        !< f [m], not zero, across tangent
      real(wp), intent(in) :: tangent(3)    !< t of the hole axis at the foot [-]
      real(wp), intent(in) :: normal_force  !< R [N]
      real(wp), intent(in) :: axial         !< a: > 0 pushes the string down the hole [-]
      real(wp), intent(in) :: rotary        !< m >= 0 [-]
      real(wp), intent(in) :: sideways      !< m in the force: m, or 0 where the string whirls [-]
      real(wp), intent(in) :: radius        !< r [m]
      real(wp), intent(out) :: force(3)     !< [N]
      real(wp), intent(out) :: moment(3)    !< [N.m]
      real(wp) :: n(3), tau(3)
      n = gap*(1.0_wp/sqrt(gap(1)*gap(1) + gap(2)*gap(2) + gap(3)*gap(3)))
      tau = product_of(tangent, n)
      force = normal_force*(-n + axial*tangent - sideways*tau)
      moment = -radius*normal_force*(axial*tau + rotary*tangent)
   end subroutine contact_action

   !> Derivatives of F by the point's position [N/m], and quantities that the other derivatives need.
   pure subroutine touch_tangents(touch, by)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: by
      real(wp), dimension(3) :: x, y, z      ! left factors of dyads with n, tau and t
      integer :: j
      associate (t => touch%tangent, k => touch%curvature)
         by%reciprocal = 1.0_wp/sqrt(dot_product(touch%gap, touch%gap))
         by%n = touch%gap*by%reciprocal
         by%tau = product_of(t, by%n)
         by%chi = 1.0_wp/(1.0_wp - dot_product(k, touch%gap))
         x = touch%pressing_stiffness*(touch%axial*t - touch%sideways*by%tau) - touch%normal_stiffness*by%n
         y = by%reciprocal*(touch%pressing*touch%sideways*by%n - touch%normal*by%tau)
         z = touch%pressing*by%chi*(touch%axial*k + touch%sideways*dot_product(k, by%tau)*t) &
             - touch%normal*(1.0_wp - by%chi)*by%reciprocal*t
         do j = 1, 3
            by%force_by_point(:, j) = x*by%n(j) + y*by%tau(j) + z*t(j)
         end do
      end associate
   end subroutine touch_tangents

   !> M by Q, and its derivatives by the point's position [N.m, N]. Call touch_tangents first.
   pure subroutine moment_tangents(touch, by)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: by
      real(wp), dimension(3) :: lever, x, y, z      ! as in touch_tangents
      integer :: j
      associate (t => touch%tangent, k => touch%curvature)
         lever = -touch%radius*(touch%axial*by%tau + touch%rotary*t)
         by%moment = touch%pressing*lever
         x = touch%pressing_stiffness*lever
         y = touch%pressing*touch%radius*touch%axial*by%reciprocal*by%n
         z = touch%pressing*touch%radius*by%chi*(touch%axial*dot_product(k, by%tau)*t - touch%rotary*k)
         do j = 1, 3
            by%moment_by_point(:, j) = x*by%n(j) + y*by%tau(j) + z*t(j)
         end do
      end associate
   end subroutine moment_tangents

   !> Couple of axial friction on a string that is near a helix and does not rotate: F_tau on the point and P on r'.
   pure subroutine couple_action(gap, tangent, direction, couple, force, bend)
      real(wp), intent(in) :: gap(3), tangent(3)   !< f [m], t of the hole axis at the foot [-]
      real(wp), intent(in) :: direction(3)      !< r' of the string there, not normalised [-]
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

   !> Derivatives of F_tau and P by the point and by r' (3,3). Those of F_tau by the point are added to those of F. Call
   !> touch_tangents first. The couple's own derivative makes them unsymmetric.
   pure subroutine couple_tangents(touch, by)
      type(touch_type), intent(in) :: touch
      type(touch_tangent_type), intent(inout) :: by
      real(wp), dimension(3) :: d, across, along_t, by_t, k_n
      real(wp) :: stretch, d_n, d_tau, swing
      integer :: j
      associate (t => touch%tangent, n => by%n, tau => by%tau)
         stretch = 1.0_wp/sqrt(dot_product(touch%direction, touch%direction))
         d = touch%direction*stretch
         d_n = dot_product(d, n)
         d_tau = dot_product(d, tau)
         k_n = product_of(touch%curvature, n)
         swing = touch%couple*by%reciprocal
         by_t = -swing*by%chi*(dot_product(d, k_n)*tau + d_tau*k_n)      ! from dtau along t
         do j = 1, 3
            by%force_by_point(:, j) = by%force_by_point(:, j) + by_t*t(j) &
                                      - by%reciprocal*d_tau*(touch%couple_stiffness - swing)*tau*n(j) &
                                      + swing*by%reciprocal*(d_n*tau + d_tau*n)*tau(j)
            by%force_by_direction(:, j) = -swing*stretch*tau*(tau(j) - d_tau*d(j))
         end do
         across = n - d*d_n
         along_t = (1.0_wp - by%chi)*(t - d*dot_product(d, t))
         do j = 1, 3
            by%bend_by_point(:, j) = -touch%couple_stiffness*stretch*across*n(j) &
                                     - swing*stretch*((tau - d*d_tau)*tau(j) + along_t*t(j))
            by%bend_by_direction(:, j) = touch%couple*stretch**2*(across*d(j) + d*across(j) - d_n*d*d(j))
            by%bend_by_direction(j, j) = by%bend_by_direction(j, j) + touch%couple*stretch**2*d_n
         end do
      end associate
   end subroutine couple_tangents

   !> Support that holds a node on the hole axis with a stiff spring [N/m], and lets it slide freely along it. Returns the
   !> force F = -k f on the string [N] and its derivative [N/m].
   pure subroutine support_action(gap, tangent, curvature, stiffness, force, force_tangent)
      real(wp), intent(in) :: gap(3), tangent(3), curvature(3)   !< f [m], t [-] and k [1/m] of the hole axis at the foot
      real(wp), intent(in) :: stiffness                          !< k [N/m]
      real(wp), intent(out) :: force(3)                          !< [N]
      real(wp), intent(out) :: force_tangent(3, 3)               !< by the place of the node [N/m]
      real(wp) :: along
      integer :: j
      force = -stiffness*gap
      along = stiffness/(1.0_wp - sum(curvature*gap))
      do j = 1, 3
         force_tangent(:, j) = along*tangent*tangent(j)
         force_tangent(j, j) = force_tangent(j, j) - stiffness
      end do
   end subroutine support_action

   !> a x b, in this module so that it is inlined.
   pure function product_of(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function product_of
end module dg_gap_contact
