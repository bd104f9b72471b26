!> Action of a gap on its beam element: the contact, its forces, and the rows of a linear problem with contact forces as
!> unknowns.
module dg_gap_action
   use dg_kinds, only: wp
   use dg_gap_contact, only: contact_action, couple_action, couple_tangents, moment_tangents, touch_tangent_type, touch_tangents, &
                             touch_type
   use dg_gap_element, only: gap_derivative_type, gap_derivatives, gap_nodal_force
   use dg_gap_state, only: contact_force
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_slope, hermite_value
   use dg_mesh, only: mesh_type
   use dg_scatter, only: element_type, part_energy, part_rest
   use dg_vector, only: cross, skew
   use dg_whirling, only: add_turning, turning_moment, turning_type
   use dg_workspace, only: dof_axial, dof_twist, workspace_type
   implicit none
   private
   public :: load_type, contact_type, find_contact, add_gap_force, add_gap_tangent, add_whirl, find_contact_rows
   public :: find_side_row, near

   !> Gaps whose |f| over the clearance is below this have no rows [-]: they stay open in the linear problem. After the step
   !> `judge_gaps` may close them.
   real(wp), parameter :: near = 0.3_wp

   !> Loads and supports of a load case at its present increment.
   type :: load_type
      real(wp) :: wob = 0.0_wp              !< weight on bit, > 0 pushes the bit [N]
      real(wp) :: hookload = 0.0_wp         !< given hook load if the bit is held: `wob` is then without the reaction at the bit [N]
      real(wp) :: tob = 0.0_wp              !< torque on bit [N.m]
      real(wp) :: friction_scale = 1.0_wp   !< factor on all friction coefficients [-]
      real(wp) :: top_support = 0.0_wp      !< lateral stiffness of the top's support, 0: free [N/m]
      real(wp) :: bit_support = 0.0_wp      !< lateral stiffness of the bit's support, 0: free [N/m]
   end type load_type

   !> Contact at a gap.
   type :: contact_type
      real(wp) :: shape(4), slope(4)        !< N and dN/dx there
      real(wp) :: share(2)                  !< part of each node in the torque of friction; zero if the string does not rotate [-]
      real(wp) :: direction(3)              !< r' of the string
      real(wp) :: axial, rotary             !< friction coefficients [-]
      real(wp) :: sideways                  !< rotary friction coefficient in the force [-]
      real(wp) :: radius                    !< radius in the plain moment of friction, 0 if friction is a couple that bends the
                                            !< string [m]
      logical :: sliding                    !< friction is such a couple: the string slides without turning, and is near a helix
      type(turning_type) :: turning         !< torque of friction where the string whirls
      real(wp) :: normal                    !< R [N]
      real(wp) :: stiffness                 !< its derivative by |f| [N/m]
   end type contact_type

contains

   !> Find friction and geometry of the contact at a closed gap.
   pure subroutine find_contact(mesh, loads, gaps, e, work, contact)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      type(workspace_type), intent(inout) :: work   !< on return with the normal force, unless that is an unknown
      type(contact_type), intent(out) :: contact
      if (work%separate) then
         contact%stiffness = 0.0_wp
      else
         call contact_force(gaps%law(e), gaps%state(e), work%displacement(e), work%normal(e), contact%stiffness)
      end if
      contact%axial = mesh%friction_along(e)*loads%friction_scale
      contact%rotary = mesh%friction_around(e)*loads%friction_scale
      contact%shape = hermite_value(gaps%xi(e), mesh%length(e))
      contact%slope = hermite_slope(gaps%xi(e), mesh%length(e))
      contact%direction = contact%slope(3)*(mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e))) &
                          + contact%slope(2)*work%d(:, e) + contact%slope(4)*work%d(:, e + 1)
      contact%sideways = work%sideways(e)*contact%rotary
      if (abs(work%held(e)) > 0.0_wp) then      ! Coulomb's law: the size of both parts together is unchanged
         contact%sideways = contact%sideways + abs(contact%axial)*work%held(e)
         contact%axial = contact%axial*sqrt(1.0_wp - work%held(e)**2)
      end if
      contact%turning%lever = 0.0_wp
      if (work%sideways(e) < 1.0_wp) then
         contact%turning%lever = contact%rotary*mesh%radius(e)
         contact%rotary = 0.0_wp
      end if
      ! Axial friction bends a string that does not rotate. Its torque, that of the bit, does not change.
      contact%share = 0.0_wp
      if (contact%rotary > 0.0_wp) contact%share = [1.0_wp - gaps%xi(e), gaps%xi(e)]
      ! Axial friction's moment acts as a couple near a helix. A plain moment would wind sliding helices up.
      contact%sliding = work%sideways(e) < 1.0_wp .and. .not. contact%rotary > 0.0_wp .and. abs(contact%axial) > 0.0_wp
      contact%radius = merge(0.0_wp, mesh%radius(e), contact%sliding)
      contact%normal = work%normal(e)
      if (contact%turning%lever > 0.0_wp) contact%turning = turning_type( &
         contact%turning%lever, [1.0_wp - gaps%xi(e), gaps%xi(e)], contact%shape, contact%normal, &
         contact%stiffness, work%gap(:, e)/work%displacement(e), work%axis_tangent(:, e), &
         work%axis_curvature(:, e)/(1.0_wp - dot_product(work%axis_curvature(:, e), work%gap(:, e))))
   end subroutine find_contact

   !> Subtract the force of a closed gap's MCGE from its element (Eqs. 4 and 6).
   pure subroutine add_gap_force(mesh, e, contact, work, element)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(contact_type), intent(in) :: contact
      type(workspace_type), intent(inout) :: work
      type(element_type), intent(inout) :: element
      real(wp) :: force(3), moment(3), nodal(12), twisting(2)
      call find_contact_action(mesh, e, contact, contact%normal, work, force, moment, nodal, twisting)
      element%force = element%force - nodal
      element%twisting = element%twisting - twisting
      if (.not. allocated(work%contact_force)) return
      work%contact_force(:, e) = force
      work%contact_moment(:, e) = moment
      if (.not. (contact%rotary > 0.0_wp .or. contact%sliding)) work%contact_moment(:, e) = moment - contact%direction &
                                         *(dot_product(moment, contact%direction)/dot_product(contact%direction, contact%direction))
      if (contact%turning%lever > 0.0_wp) work%contact_moment(:, e) = work%contact_moment(:, e) &
                                                                      + turning_moment(contact%turning, work%d(:, e:e + 1))
   end subroutine add_gap_force

   !> Action of a contact force on its element: force and moment at the gap, forces on (x_i, d_i, x_j, d_j), torques on both nodes.
   pure subroutine find_contact_action(mesh, e, contact, normal, work, force, moment, nodal, twisting)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(contact_type), intent(in) :: contact
      real(wp), intent(in) :: normal       !< R [N]
      type(workspace_type), intent(in) :: work
      real(wp), intent(out) :: force(3), moment(3), nodal(12), twisting(2)   !< [N, N.m]
      real(wp) :: push(3), bend(3)
      integer :: a
      call contact_action(work%gap(:, e), work%axis_tangent(:, e), normal, contact%axial, contact%rotary, contact%sideways, &
                          contact%radius, force, moment)
      call gap_nodal_force(contact%share, contact%shape, contact%slope, work%d(:, e), work%d(:, e + 1), contact%direction, force, &
                           moment, nodal, twisting)
      if (.not. contact%sliding) return
      call couple_action(work%gap(:, e), work%axis_tangent(:, e), contact%direction, &
                         contact%axial*mesh%radius(e)*normal, push, bend)
      do a = 1, 4
         nodal(3*a - 2:3*a) = nodal(3*a - 2:3*a) + contact%shape(a)*push + contact%slope(a)*bend
      end do
      force = force + push
      moment = moment + cross(contact%direction, bend)
   end subroutine find_contact_action

   !> Subtract the derivatives of that force (Eq. 11) from the element's tangent, as far as element%part includes them.
   pure subroutine add_gap_tangent(mesh, e, contact, work, element)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(contact_type), intent(in) :: contact
      type(workspace_type), intent(in) :: work
      type(element_type), intent(inout) :: element
      type(touch_type) :: touch
      type(touch_tangent_type) :: at_point
      type(gap_derivative_type) :: by
      integer :: a, b, n, p
      touch = touch_of(mesh, e, work, contact, element%part)
      call touch_tangents(touch, at_point)
      if (contact%sliding) call couple_tangents(touch, at_point)
      call moment_tangents(touch, at_point)
      call gap_derivatives(touch, work%d(:, e:e + 1), at_point, by)
      do b = 1, 4
         associate (k => element%k(:, 3*b - 2:3*b), row => element%twist_row(:, 3*b - 2:3*b))
            do a = 1, 4
               k(3*a - 2:3*a, :) = k(3*a - 2:3*a, :) - (touch%shape(b)*by%point(:, :, a) + touch%slope(b)*by%direction(:, :, a))
            end do
            do p = 1, 2
               if (.not. touch%share(p) > 0.0_wp) cycle
               row(p, :) = row(p, :) - (touch%shape(b)*by%twisting_by_point(:, p) + touch%slope(b)*by%twisting_by_direction(:, p))
            end do
         end associate
      end do
      do p = 1, 2
         if (.not. touch%share(p) > 0.0_wp) cycle
         n = 6*p - 2
         element%k(n:n + 2, n:n + 2) = element%k(n:n + 2, n:n + 2) - skew(touch%share(p)*by%twist)
         element%twist_row(p, n:n + 2) = element%twist_row(p, n:n + 2) - touch%share(p)*by%twist
      end do
   end subroutine add_gap_tangent

   !> Contact of element e, with those forces that a part of the tangent includes.
   pure function touch_of(mesh, e, work, contact, part) result(touch)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(workspace_type), intent(in) :: work
      type(contact_type), intent(in) :: contact
      integer, intent(in) :: part
      type(touch_type) :: touch
      real(wp) :: lever
      touch%gap = work%gap(:, e)
      touch%tangent = work%axis_tangent(:, e)
      touch%curvature = work%axis_curvature(:, e)
      touch%direction = contact%direction
      touch%axial = contact%axial
      touch%rotary = contact%rotary
      touch%sideways = contact%sideways
      touch%radius = contact%radius
      touch%share = contact%share
      touch%shape = contact%shape
      touch%slope = contact%slope
      lever = merge(contact%axial*mesh%radius(e), 0.0_wp, contact%sliding)
      if (part /= part_rest) then
         touch%normal = contact%normal
         touch%normal_stiffness = contact%stiffness
         touch%couple = lever*contact%normal
      end if
      if (part /= part_energy) then
         touch%pressing = contact%normal
         touch%pressing_stiffness = contact%stiffness
         touch%couple_stiffness = lever*contact%stiffness
      end if
   end function touch_of

   !> Add the torque of friction where the string whirls.
   pure subroutine add_whirl(e, contact, work, element)
      integer, intent(in) :: e
      type(contact_type), intent(in) :: contact
      type(workspace_type), intent(in) :: work
      type(element_type), intent(inout) :: element
      if (contact%turning%lever > 0.0_wp) call add_turning(contact%turning, work%d(:, e:e + 1), element)
   end subroutine add_whirl

   !> Rows of every gap near the wall, for elements first to last. `by`(12,e) is the change of |f| by the unknowns of its two
   !> nodes [-, m]. `on`(12,e) is the effect of a contact force of 1 N on their residuals, with friction [-, m]. With R unknown
   !> the change dR adds on*dR to the residual, as forces are linear in R. dR = rho (h + by.d), where h is the excess of the
   !> gap's depth for its force. Held unknowns have no rows.
   pure subroutine find_contact_rows(mesh, loads, gaps, first, last, work, by, on)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: first, last     !< elements
      type(workspace_type), intent(inout) :: work       !< placed and surveyed
      real(wp), intent(out) :: by(:, first:), on(:, first:)   !< (12,first:last) [-, m]
      type(contact_type) :: contact
      real(wp) :: nodal(12), twisting(2), outward(3)
      integer :: e
      do e = first, last
         if (work%displacement(e) < near*gaps%law(e)%clearance) then
            on(:, e) = 0.0_wp
            by(:, e) = 0.0_wp
            cycle
         end if
         call find_contact(mesh, loads, gaps, e, work, contact)
         call unit_force(mesh, e, work, contact, nodal, twisting)
         outward = work%gap(:, e)*(1.0_wp/work%displacement(e))
         call rows_of_node(mesh%frame(:, :, e), work%d(:, e), nodal(1:6), outward, contact%shape(1:2), on(1:6, e), by(1:6, e))
         call rows_of_node(mesh%frame(:, :, e + 1), work%d(:, e + 1), nodal(7:12), outward, contact%shape(3:4), on(7:12, e), &
                           by(7:12, e))
         on(4, e) = twisting(1)
         on(10, e) = twisting(2)
      end do
      if (mesh%held == mesh%nodes .and. last == mesh%elements) then
         on(6 + dof_axial, last) = 0.0_wp
         by(6 + dof_axial, last) = 0.0_wp
      end if
      if (first > 1) return
      on(dof_twist, 1) = 0.0_wp
      by(dof_twist, 1) = 0.0_wp
      if (mesh%held > 1) return
      on(dof_axial, 1) = 0.0_wp
      by(dof_axial, 1) = 0.0_wp
   end subroutine find_contact_rows

   !> Change of a gap's place along t x n by the unknowns of its element's nodes (12) [-, m].
   pure subroutine find_side_row(mesh, gaps, e, work, row)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      type(workspace_type), intent(in) :: work
      real(wp), intent(out) :: row(:)   !< (12) [-, m]
      real(wp), parameter :: no_force(6) = 0.0_wp
      real(wp) :: shape(4), side(3), on(6)
      shape = hermite_value(gaps%xi(e), mesh%length(e))
      side = cross(work%axis_tangent(:, e), work%gap(:, e)/work%displacement(e))
      call rows_of_node(mesh%frame(:, :, e), work%d(:, e), no_force, side, shape(1:2), on, row(1:6))
      call rows_of_node(mesh%frame(:, :, e + 1), work%d(:, e + 1), no_force, side, shape(3:4), on, row(7:12))
      if (e == 1) row(dof_twist) = 0.0_wp
      if (e == mesh%held) row(dof_axial) = 0.0_wp
      if (e + 1 == mesh%held) row(6 + dof_axial) = 0.0_wp
   end subroutine find_side_row

   !> Rows of one node except for the twist, which has no effect on `by`.
   pure subroutine rows_of_node(frame, d, force, outward, shape, on, by)
      real(wp), intent(in) :: frame(3, 3), d(3)   !< of the node
      real(wp), intent(in) :: force(6)       !< on place and director, in space axes
      real(wp), intent(in) :: outward(3)     !< f/|f|
      real(wp), intent(in) :: shape(2)       !< derivatives of r by the node's place and director
      real(wp), intent(inout) :: on(6), by(6)     !< by slopes: dd/dbeta_k = s (n_k - d d.n_k), s = d.t
      real(wp) :: push(3), pull(2:3), along(2:3), s, pulled, pushed
      integer :: a
      do a = 1, 3
         on(a) = force(1)*frame(1, a) + force(2)*frame(2, a) + force(3)*frame(3, a)
         push(a) = outward(1)*frame(1, a) + outward(2)*frame(2, a) + outward(3)*frame(3, a)
         by(a) = shape(1)*push(a)
      end do
      by(4) = 0.0_wp
      s = d(1)*frame(1, 1) + d(2)*frame(2, 1) + d(3)*frame(3, 1)
      pulled = force(4)*d(1) + force(5)*d(2) + force(6)*d(3)
      pushed = outward(1)*d(1) + outward(2)*d(2) + outward(3)*d(3)
      do a = 2, 3
         along(a) = d(1)*frame(1, a) + d(2)*frame(2, a) + d(3)*frame(3, a)
         pull(a) = force(4)*frame(1, a) + force(5)*frame(2, a) + force(6)*frame(3, a)
         on(3 + a) = s*(pull(a) - pulled*along(a))
         by(3 + a) = shape(2)*s*(push(a) - pushed*along(a))
      end do
   end subroutine rows_of_node

   !> Forces on (x_i, d_i, x_j, d_j) and torques at both nodes from a contact force of 1 N, as internal less external forces.
   pure subroutine unit_force(mesh, e, work, contact, nodal, twisting)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(workspace_type), intent(in) :: work
      type(contact_type), intent(inout) :: contact
      real(wp), intent(out) :: nodal(12), twisting(2)
      type(element_type) :: element
      real(wp) :: action(3), moment(3)
      call find_contact_action(mesh, e, contact, 1.0_wp, work, action, moment, nodal, twisting)
      nodal = -nodal
      twisting = -twisting
      if (.not. contact%turning%lever > 0.0_wp) return
      contact%turning%force = 1.0_wp
      element%tangent = .false.
      element%force = nodal
      element%twisting = twisting
      call add_turning(contact%turning, work%d(:, e:e + 1), element)
      nodal = element%force
      twisting = element%twisting
   end subroutine unit_force
end module dg_gap_action
