!> A gap element on a string that stays in a plane and does not rotate: what Eqs. 4, 5, 6 and 11 of the paper leave there.
!>
!> The string is off the hole axis by f = sigma |f| along p, a quarter turn from the axis' tangent t at the foot, sigma = 1 or -1.
!> Of dg_gap_contact's F there remains F = R (-sigma p + a t), of its moment the couple P = -c/|r'| (n.q) q on r', c = r R a and q a
!> quarter turn from the string's tangent d: d.tau = 0, so that nothing pushes out of the plane and nothing twists.
module dg_plane_gap
   use dg_kinds, only: wp
   use dg_plane_beam_element, only: director_stiffness, plane_node_type, unknowns
   implicit none
   private
   public :: plane_gap

contains

   !> Takes the gap's force off `force` and, where it is wanted, its tangent off `stiffness`, both by u, v, beta of nodes i and j.
   !> As in space x0 is held.
   pure subroutine plane_gap(shape, slope, i, j, direction, gap, tangent, curvature, normal_force, normal_stiffness, axial, &
                             radius, wanted, force, stiffness)
      real(wp), intent(in) :: shape(4), slope(4)        !< N and dN/dx at the gap
      type(plane_node_type), intent(in) :: i, j
      real(wp), intent(in) :: direction(2)              !< r' there, not normalised
      real(wp), intent(in) :: gap(2)                    !< f [m], not zero
      real(wp), intent(in) :: tangent(2)                !< t of the hole axis at the foot
      real(wp), intent(in) :: curvature(2)              !< dt/ds there [1/m]
      real(wp), intent(in) :: normal_force              !< R [N]
      real(wp), intent(in) :: normal_stiffness          !< dR/d|f| [N/m]
      real(wp), intent(in) :: axial                     !< a: > 0 pushes the string down the hole [-]
      real(wp), intent(in) :: radius                    !< r [m]
      logical, intent(in) :: wanted                     !< the tangent is
      real(wp), intent(inout) :: force(unknowns), stiffness(unknowns, unknowns)
      real(wp) :: p(2), d(2), q(2), offset, side, stretch, couple, across, along_t, along_p, bend
      real(wp) :: by_t(unknowns), by_p(unknowns), by_d(unknowns), by_q(unknowns), on_t(unknowns), on_p(unknowns), on_q(unknowns)
      real(wp) :: chi, turning, pull(2)
      integer :: c
      p = [-tangent(2), tangent(1)]                     ! quarter turns written out: a call costs more
      offset = gap(1)*p(1) + gap(2)*p(2)
      side = sign(1.0_wp, offset)
      by_t = motion(tangent, shape, i, j)
      by_p = motion(p, shape, i, j)
      along_t = normal_force*axial
      along_p = -normal_force*side
      force = force - along_t*by_t - along_p*by_p
      couple = axial*radius*normal_force
      stretch = 1.0_wp/sqrt(direction(1)**2 + direction(2)**2)
      d = direction*stretch
      q = [-d(2), d(1)]
      across = side*(p(1)*q(1) + p(2)*q(2))             ! n.q
      bend = -couple*stretch*across
      if (abs(couple) > 0.0_wp) then
         by_q = motion(q, slope, i, j)
         force = force - bend*by_q
      end if
      if (.not. wanted) return
      chi = 1.0_wp/(1.0_wp - (curvature(1)*gap(1) + curvature(2)*gap(2)))
      turning = (1.0_wp - chi)/abs(offset)              ! of the normal with the foot
      on_t = (normal_stiffness*axial*side)*by_p - (normal_force*turning)*by_t
      on_p = (along_t*chi*(curvature(1)*p(1) + curvature(2)*p(2)))*by_t - normal_stiffness*by_p
      do c = 1, unknowns
         stiffness(:, c) = stiffness(:, c) - by_t*on_t(c) - by_p*on_p(c)
      end do
      if (abs(couple) > 0.0_wp) then
         by_d = motion(d, slope, i, j)
         on_q = (couple*stretch**2)*(across*by_d + side*(p(1)*d(1) + p(2)*d(2))*by_q) &
                - (axial*radius*normal_stiffness*side*stretch*across)*by_p &
                - (couple*stretch*turning*(tangent(1)*q(1) + tangent(2)*q(2)))*by_t
         do c = 1, unknowns
            stiffness(:, c) = stiffness(:, c) - by_q*on_q(c) + (bend*stretch*by_q(c))*by_d
         end do
      end if
      ! the directors on which the forces act
      pull = along_t*tangent + along_p*p
      stiffness(3, 3) = stiffness(3, 3) - director_stiffness(i, shape(2)*pull + (slope(2)*bend)*q)
      stiffness(6, 6) = stiffness(6, 6) - director_stiffness(j, shape(4)*pull + (slope(4)*bend)*q)
   end subroutine plane_gap

   !> Motion along a unit vector w of what the shape functions N carry, by the six unknowns.
   pure function motion(w, n, i, j) result(by)
      real(wp), intent(in) :: w(2), n(4)
      type(plane_node_type), intent(in) :: i, j
      real(wp) :: by(unknowns)
      by(1) = n(1)*(w(1)*i%axis(1) + w(2)*i%axis(2))
      by(2) = n(1)*(w(1)*i%across(1) + w(2)*i%across(2))
      by(3) = (n(2)*i%turn)*(w(2)*i%d(1) - w(1)*i%d(2))
      by(4) = n(3)*(w(1)*j%axis(1) + w(2)*j%axis(2))
      by(5) = n(3)*(w(1)*j%across(1) + w(2)*j%across(2))
      by(6) = (n(4)*j%turn)*(w(2)*j%d(1) - w(1)*j%d(2))
   end function motion
end module dg_plane_gap
