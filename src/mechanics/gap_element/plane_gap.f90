!> A gap element on a string that stays in a plane and does not rotate: what Eqs. 4, 5, 6 and 11 of the paper leave there.
!>
!> The string is off the hole axis by f = sigma |f| along p, a quarter turn from the axis' tangent t at the foot, sigma = 1 or -1.
!> Of dg_gap_contact's F there remains F = R (-sigma p + a t), of its moment the bend P = -sigma c/|r'| q on r', c = r R a and q a
!> quarter turn from the string's tangent d: nothing pushes out of the plane and nothing twists.
!>
!> Innermost loop: quarter turns and the work on directors are written out, since calls into other modules are not inlined.
module dg_plane_gap
   use dg_kinds, only: wp
   use dg_plane_beam_element, only: plane_node_type, unknowns
   implicit none
   private
   public :: plane_contact_type, plane_gap, plane_gap_rows

   !> Contact at a gap.
   type :: plane_contact_type
      real(wp) :: shape(4), slope(4)     !< N and dN/dx there
      real(wp) :: direction(2)           !< r' of the string, not normalised
      real(wp) :: gap(2)                 !< f [m], not zero
      real(wp) :: tangent(2)             !< t of the hole axis at the foot
      real(wp) :: curvature(2)           !< dt/ds there [1/m]
      real(wp) :: axial                  !< a: > 0 pushes the string down the hole [-]
      real(wp) :: radius                 !< r [m]
   end type plane_contact_type

contains

   !> Takes the gap's force off `force` and, where it is wanted, its tangent off `stiffness`, both by u, v, beta of nodes i and j.
   !> As in space x0 is held.
   pure subroutine plane_gap(contact, i, j, normal_force, normal_stiffness, wanted, force, stiffness)
      type(plane_contact_type), intent(in) :: contact
      type(plane_node_type), intent(in) :: i, j
      real(wp), intent(in) :: normal_force              !< R [N]
      real(wp), intent(in) :: normal_stiffness          !< dR/d|f| [N/m]
      logical, intent(in) :: wanted                     !< the tangent is
      real(wp), intent(inout) :: force(unknowns), stiffness(unknowns, unknowns)
      real(wp), dimension(unknowns) :: by_t, by_p, by_d, by_q, left_t, left_p, left_d, left_q
      real(wp) :: side, stretch, along_t, along_p, bend, chi, turned
      integer :: c
      associate (t => contact%tangent)
         side = sign(1.0_wp, t(1)*contact%gap(2) - t(2)*contact%gap(1))
         call find_motions(t, contact%shape, i, j, by_t, by_p)
         call find_bending(contact, i, j, stretch, by_d, by_q)
         along_t = normal_force*contact%axial
         along_p = -normal_force*side
         bend = -side*along_t*contact%radius*stretch
         force = force - along_t*by_t - along_p*by_p - bend*by_q
         if (.not. wanted) return
         chi = 1.0_wp/(1.0_wp - (contact%curvature(1)*contact%gap(1) + contact%curvature(2)*contact%gap(2)))
         turned = chi*(contact%curvature(2)*t(1) - contact%curvature(1)*t(2))     ! of the normal with the foot
         ! the tangent is a sum of these by the motions along t, d and q
         left_t = (along_t*turned)*by_p + (side*turned*normal_force)*by_t
         left_d = -(bend*stretch)*by_q
         left_q = -(bend*stretch)*by_d
         do c = 1, unknowns
            stiffness(:, c) = stiffness(:, c) - left_t*by_t(c) - left_d*by_d(c) - left_q*by_q(c)
         end do
         if (normal_stiffness > 0.0_wp) then
            left_p = normal_stiffness*((contact%axial*side)*by_t - by_p &
                                       - (contact%axial*contact%radius*stretch)*by_q)
            do c = 1, unknowns
               stiffness(:, c) = stiffness(:, c) - left_p*by_p(c)
            end do
         end if
         ! the directors on which the forces act
         associate (n => contact%shape, s => contact%slope, along_1 => along_t*t(1) - along_p*t(2), &
                    along_2 => along_t*t(2) + along_p*t(1), bend_1 => -bend*stretch*contact%direction(2), &
                    bend_2 => bend*stretch*contact%direction(1))
            stiffness(3, 3) = stiffness(3, 3) - by_slope(i, n(2)*along_1 + s(2)*bend_1, n(2)*along_2 + s(2)*bend_2)
            stiffness(6, 6) = stiffness(6, 6) - by_slope(j, n(4)*along_1 + s(4)*bend_1, n(4)*along_2 + s(4)*bend_2)
         end associate
      end associate
   end subroutine plane_gap

   !> Change of |f| by the unknowns of nodes i and j, and what a newton of R adds to their residual.
   pure subroutine plane_gap_rows(contact, i, j, by, on)
      type(plane_contact_type), intent(in) :: contact
      type(plane_node_type), intent(in) :: i, j
      real(wp), intent(out) :: by(unknowns), on(unknowns)
      real(wp), dimension(unknowns) :: by_t, by_p, by_d, by_q
      real(wp) :: side, stretch
      side = sign(1.0_wp, contact%tangent(1)*contact%gap(2) - contact%tangent(2)*contact%gap(1))
      call find_motions(contact%tangent, contact%shape, i, j, by_t, by_p)
      call find_bending(contact, i, j, stretch, by_d, by_q)
      by = side*by_p
      on = by - contact%axial*by_t + (contact%axial*contact%radius*stretch*side)*by_q
   end subroutine plane_gap_rows

   !> How friction's bend goes by r': 1/|r'|, and motions of r' along d and q.
   pure subroutine find_bending(contact, i, j, stretch, by_d, by_q)
      type(plane_contact_type), intent(in) :: contact
      type(plane_node_type), intent(in) :: i, j
      real(wp), intent(out) :: stretch
      real(wp), intent(out) :: by_d(unknowns), by_q(unknowns)
      real(wp) :: d(2)
      stretch = 1.0_wp/sqrt(contact%direction(1)**2 + contact%direction(2)**2)
      d = contact%direction*stretch
      call find_motions(d, contact%slope, i, j, by_d, by_q)
   end subroutine find_bending

   !> Motions along a unit vector w, and a quarter turn from it, of what the shape functions n carry, by the six unknowns.
   pure subroutine find_motions(w, n, i, j, along, aside)
      real(wp), intent(in) :: w(2), n(4)
      type(plane_node_type), intent(in) :: i, j
      real(wp), intent(out) :: along(unknowns), aside(unknowns)
      along(1) = n(1)*(w(1)*i%axis(1) + w(2)*i%axis(2))
      along(2) = n(1)*(w(1)*i%across(1) + w(2)*i%across(2))
      along(3) = (n(2)*i%turn)*(w(2)*i%d(1) - w(1)*i%d(2))
      along(4) = n(3)*(w(1)*j%axis(1) + w(2)*j%axis(2))
      along(5) = n(3)*(w(1)*j%across(1) + w(2)*j%across(2))
      along(6) = (n(4)*j%turn)*(w(2)*j%d(1) - w(1)*j%d(2))
      aside(1) = -along(2)
      aside(2) = along(1)
      aside(3) = (n(2)*i%turn)*(w(1)*i%d(1) + w(2)*i%d(2))
      aside(4) = -along(5)
      aside(5) = along(4)
      aside(6) = (n(4)*j%turn)*(w(1)*j%d(1) + w(2)*j%d(2))
   end subroutine find_motions

   !> Second derivative by beta of the work of a force (g_1, g_2) on the node's director: the consistent tangent has it wherever a
   !> force does work on a director.
   pure function by_slope(node, g_1, g_2) result(stiffness)
      type(plane_node_type), intent(in) :: node
      real(wp), intent(in) :: g_1, g_2
      real(wp) :: stiffness
      stiffness = node%bend*(g_2*node%d(1) - g_1*node%d(2)) - node%turn**2*(g_1*node%d(1) + g_2*node%d(2))
   end function by_slope
end module dg_plane_gap
