!> Global equilibrium of Eq. 12: residual r(d) = internal - external forces and its consistent tangent.
!>
!> Unknowns d(6,nodes): u along the hole axis, v and w across it (frame n_1, n_2 of the node) [m], phi twist [rad],
!> beta_1, beta_2 slopes of the string against the hole axis [-]. Row and column order of every 6 x 6 block.
!> Work-conjugate residuals: three forces [N], a torque [N.m], two moments [N.m].
module dg_assembly
   use dg_kinds, only: wp
   use dg_beam_bend, only: add_bend, bend_moment
   use dg_beam_blocks, only: beam_blocks, part_all, part_energy, part_rest, torque_blocks
   use dg_beam_element, only: beam_section_type, energy_hessian, measure_force, measure_type, torque_force
   use dg_block_matrix, only: block_matrix_type
   use dg_director, only: director_gradient
   use dg_end_supports, only: end_action
   use dg_gap_action, only: contact_action_at, contact_type, find_contact, load_type
   use dg_gap_contact, only: contact_action, couple_action, normal_force_type, sliding_couple
   use dg_gap_element, only: couple_derivatives, gap_derivative_type, gap_derivatives, gap_nodal_force
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_scatter, only: add_blocks, element_type, hold_top, put_blocks, scatter_more, take_contact
   use dg_trajectory, only: trajectory_type
   use dg_vector, only: cross
   use dg_whirling, only: add_end_torque, add_turning, end_moment, turning_moment
   use dg_workspace, only: dof_axial, dof_twist, workspace_type
   implicit none
   private
   public :: load_type, assemble, add_unsymmetric_part

   !> What one element and its gap do, internal less external.
   type :: action_type
      integer :: part                   !< of the tangent
      logical :: tangent                !< is wanted
      real(wp) :: force(12)             !< on (x_i, d_i, x_j, d_j), in space axes [N, N.m]
      real(wp) :: twisting(2)           !< torque on both nodes [N.m]
      real(wp) :: blocks(6, 6, 4)       !< its tangent in the nodes' unknowns
      logical :: bends                  !< it has a further tangent, in space axes: of a bent housing, or of a string that whirls
      type(element_type) :: element     !< that tangent
   end type action_type

contains

   !> Residual(6,nodes) and tangent at `state`, whose nodes have been placed and whose gaps have been surveyed in `work`.
   !> Top unknowns that are held (u, phi) have zero residual and a unit diagonal. `conservative` leaves friction and
   !> what is not symmetric of torque out of the tangent: it is then the second derivative of an energy, whose inertia tells
   !> stability.
   !> `work` returns element forces and reactions; those of make_room_for_recovery where it has room for them.
   !> `forces_only`: the tangent is not wanted; `matrix` is left as it was, and the rest, the same to the digit, costs a third.
   pure subroutine assemble(trajectory, mesh, loads, gaps, state, conservative, work, residual, matrix, forces_only)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      logical, intent(in) :: conservative
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      logical, intent(in), optional :: forces_only   !< absent: no
      type(action_type) :: action
      real(wp) :: top_force(3), by_slopes(2, 2)
      integer :: e, n
      action%part = merge(part_energy, part_all, conservative)
      action%tangent = .true.
      if (present(forces_only)) action%tangent = .not. forces_only
      work%node_force = 0.0_wp
      if (allocated(work%contact_force)) then
         work%contact_force = 0.0_wp
         work%contact_moment = 0.0_wp
      end if
      residual = 0.0_wp
      if (action%tangent) matrix%diagonal(:, :, 1) = 0.0_wp
      do e = 1, mesh%elements
         call add_beam(mesh, e, state(dof_twist, e + 1) - state(dof_twist, e), work, action)
         call take_weight(mesh%weight(e), mesh%length(e), action%force)
         if (abs(mesh%drag(e)) > 0.0_wp) then
            action%force(1:3) = action%force(1:3) - 0.5_wp*loads%friction_scale*mesh%drag(e)*mesh%frame(:, 1, e)
            action%force(7:9) = action%force(7:9) - 0.5_wp*loads%friction_scale*mesh%drag(e)*mesh%frame(:, 1, e + 1)
         end if
         if (gaps%state(e) == state_free) then
            work%normal(e) = 0.0_wp
         else
            call add_gap(mesh, loads, gaps, e, work, action)
         end if
         residual(dof_twist, e) = residual(dof_twist, e) + action%twisting(1)
         residual(dof_twist, e + 1) = action%twisting(2)
         if (allocated(work%end_force)) work%end_force(:, e) = action%force(1:6)
         work%node_force(:, e) = work%node_force(:, e) + action%force(1:6)
         work%node_force(:, e + 1) = action%force(7:12)
         if (.not. action%tangent) cycle
         call put_blocks(e, action%blocks, matrix)
         if (action%bends) call scatter_more(mesh, e, work%d(:, e:e + 1), action%element, matrix)
      end do
      top_force = work%node_force(1:3, 1)
      call add_supports(trajectory, mesh, loads, action%tangent, work, residual, matrix)
      call add_end_torques(mesh, loads%tob, residual(dof_twist, 1), state, action%part, action%tangent, work, matrix)
      do n = 1, mesh%nodes
         call finish_node(mesh%frame(:, :, n), work%d(:, n), work%node_force(:, n), residual(:, n), by_slopes)
         if (action%tangent) matrix%diagonal(5:6, 5:6, n) = matrix%diagonal(5:6, 5:6, n) + by_slopes
      end do
      work%hookload = -residual(dof_axial, 1)
      work%top_torque = residual(dof_twist, 1)
      ! Reaction = what the string asks for: along the axis the held unknown's, across it the support's.
      work%reaction = top_force - work%node_force(1:3, 1) + mesh%frame(:, 1, 1)*residual(dof_axial, 1)
      residual([dof_axial, dof_twist], 1) = 0.0_wp
      if (action%tangent) call hold_top(matrix)
   end subroutine assemble

   !> Takes an element's weight, down, off its forces: hermite_line_load, here so that it is inlined.
   pure subroutine take_weight(weight, length, force)
      real(wp), intent(in) :: weight, length     !< [N/m, m]
      real(wp), intent(inout) :: force(12)
      real(wp), parameter :: twelfth = 1.0_wp/12.0_wp
      real(wp) :: load, turning
      load = 0.5_wp*weight*length
      turning = twelfth*weight*length*length
      force(3) = force(3) - load
      force(6) = force(6) - turning
      force(9) = force(9) - load
      force(12) = force(12) + turning
   end subroutine take_weight

   !> A node's residual but for its twist, from the forces on its place and director in space axes: dd/dbeta_k = s (n_k - d d.n_k),
   !> s = d.t. by_slopes(2,2) is what the director's second derivative makes of the force on it (director_curvature).
   pure subroutine finish_node(frame, d, force, residual, by_slopes)
      real(wp), intent(in) :: frame(3, 3), d(3), force(6)
      real(wp), intent(inout) :: residual(6)
      real(wp), intent(out) :: by_slopes(2, 2)
      real(wp) :: s, along, d2, d3, m2, m3
      integer :: k
      do k = 1, 3
         residual(k) = force(1)*frame(1, k) + force(2)*frame(2, k) + force(3)*frame(3, k)
      end do
      s = d(1)*frame(1, 1) + d(2)*frame(2, 1) + d(3)*frame(3, 1)
      d2 = d(1)*frame(1, 2) + d(2)*frame(2, 2) + d(3)*frame(3, 2)
      d3 = d(1)*frame(1, 3) + d(2)*frame(2, 3) + d(3)*frame(3, 3)
      m2 = force(4)*frame(1, 2) + force(5)*frame(2, 2) + force(6)*frame(3, 2)
      m3 = force(4)*frame(1, 3) + force(5)*frame(2, 3) + force(6)*frame(3, 3)
      along = force(4)*d(1) + force(5)*d(2) + force(6)*d(3)
      residual(5) = s*(m2 - along*d2)
      residual(6) = s*(m3 - along*d3)
      by_slopes(1, 1) = -(2.0_wp*d2*m2 + along*(1.0_wp - 3.0_wp*d2*d2))*s*s
      by_slopes(2, 2) = -(2.0_wp*d3*m3 + along*(1.0_wp - 3.0_wp*d3*d3))*s*s
      by_slopes(1, 2) = -(d2*m3 + d3*m2 - 3.0_wp*along*d2*d3)*s*s
      by_slopes(2, 1) = by_slopes(1, 2)
   end subroutine finish_node

   !> Begins an element's action by the beam's forces, its torque T = GJ/L (phi_j - phi_i) and their tangent.
   pure subroutine add_beam(mesh, e, twist, work, action)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: twist              !< phi_j - phi_i [rad]
      type(workspace_type), intent(inout) :: work
      type(action_type), intent(inout) :: action
      type(beam_section_type) :: section
      type(measure_type) :: m
      real(wp) :: chord(3), first(4), c(4, 4), end_moment(3)
      chord = mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e))
      section = beam_section_type(mesh%length(e), work%membrane_length(e), mesh%ea(e), mesh%ei(e), mesh%gj(e))
      call measure_force(section, chord, work%d(:, e), work%d(:, e + 1), m, first, action%force, work%axial(e))
      work%torque(e) = section%torsional_stiffness/section%length*twist
      action%twisting = [-work%torque(e), work%torque(e)]
      if (abs(work%torque(e)) > 0.0_wp) then
         end_moment = torque_force(work%torque(e), work%d(:, e), work%d(:, e + 1))
         action%force(4:6) = action%force(4:6) + end_moment
         action%force(10:12) = action%force(10:12) + end_moment
      end if
      action%bends = .false.
      if (allocated(mesh%bend)) then
         if (any(abs(mesh%bend(:, e)) > 0.0_wp)) then
            call begin_rest(action)
            call add_bend(bend_moment(mesh%ei(e), mesh%length(e), norm2(mesh%bend(:, e))), mesh%bend(:, e), chord, work%d(:, e), &
                          work%d(:, e + 1), action%tangent, action%force, action%element%k)
         end if
      end if
      if (.not. action%tangent) return
      call energy_hessian(m, section%axial_stiffness/section%membrane_length, work%axial(e), &
                          2.0_wp*section%bending_stiffness/section%length, c)
      call beam_blocks(m, first, c, mesh%frame(:, :, e:e + 1), work%d(:, e:e + 1), work%torque(e), &
                       section%torsional_stiffness/section%length, action%part, action%blocks)
   end subroutine add_beam

   !> Opens an element's matrix for what few elements have.
   pure subroutine begin_rest(action)
      type(action_type), intent(inout) :: action
      if (action%bends) return
      action%bends = .true.
      action%element%k = 0.0_wp
      action%element%twist_row = 0.0_wp
      action%element%twist_column = 0.0_wp
      action%element%twist_stiffness = 0.0_wp
   end subroutine begin_rest

   !> A closed gap's MCGE: takes its force and its tangent off the element's (Eqs. 4, 6, 11).
   pure subroutine add_gap(mesh, loads, gaps, e, work, action)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      type(workspace_type), intent(inout) :: work
      type(action_type), intent(inout) :: action
      type(contact_type) :: contact
      type(gap_derivative_type) :: by
      real(wp) :: force(3), moment(3), by_point(3, 3), moment_by_point(3, 3), nodal(12), twisting(2)
      call find_contact(mesh, loads, gaps, e, work, contact)
      call contact_action(work%gap(:, e), work%axis_tangent(:, e), contact%normal%force, contact%axial, contact%rotary, &
                          contact%climbing, contact%radius, force, moment)
      if (allocated(work%contact_force)) then
         work%contact_force(:, e) = force
         work%contact_moment(:, e) = moment
      end if
      call gap_nodal_force(gaps%xi(e), contact%shape, contact%slope, work%d(:, e), work%d(:, e + 1), contact%direction, force, &
                           moment, nodal, twisting)
      action%force = action%force - nodal
      action%twisting = action%twisting - twisting
      if (action%tangent) then
         if (action%part == part_energy .and. (abs(contact%axial) > 0.0_wp .or. mesh%rotary(e) > 0.0_wp)) then
            call contact_action_at(contact, contact%normal, normal_force_type(), e, work, force, moment, by_point, moment_by_point)
         else
            call contact_action_at(contact, contact%normal, contact%pressing, e, work, force, moment, by_point, moment_by_point)
         end if
      end if
      if (contact%sliding) then
         if (action%part == part_energy) contact%pressing%stiffness = 0.0_wp
         call add_couple(mesh, e, contact, action%tangent, by_point, work, action%force, by)
      else if (action%tangent) then
         call gap_derivatives(gaps%xi(e), contact%shape, contact%slope, work%d(:, e:e + 1), contact%direction, moment, by_point, &
                              moment_by_point, by)
      end if
      if (action%tangent) call take_contact(by, gaps%xi(e), contact%shape, contact%slope, mesh%frame(:, :, e:e + 1), &
                                            work%d(:, e:e + 1), action%blocks)
      if (.not. contact%turning%lever > 0.0_wp) return
      call begin_rest(action)
      call add_turning(contact%turning, work%d(:, e:e + 1), action%part, action%tangent, action%twisting, action%force, &
                       action%element)
      if (allocated(work%contact_moment)) work%contact_moment(:, e) = work%contact_moment(:, e) &
                                                                      + turning_moment(contact%turning, work%d(:, e:e + 1))
   end subroutine add_gap

   !> Adds to the symmetric tangent of the energy at `state` the unsymmetric part, which friction and torque make: the sum is the
   !> whole tangent. Elements without either are left out.
   pure subroutine add_unsymmetric_part(mesh, loads, gaps, state, work, matrix)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work    !< placed and surveyed at `state`
      type(block_matrix_type), intent(inout) :: matrix
      type(action_type) :: action
      type(contact_type) :: contact
      type(gap_derivative_type) :: by
      real(wp), dimension(3, 3) :: by_point, moment_by_point, push_by_point, push_by_direction, bend_by_point, bend_by_direction
      real(wp), parameter :: none(3, 3) = 0.0_wp
      real(wp) :: ignored(12), unused(2), force(3), moment(3)
      logical :: rubs, twisted
      integer :: e
      ignored = 0.0_wp
      unused = 0.0_wp
      do e = 1, mesh%elements
         twisted = abs(work%torque(e)) > 0.0_wp
         rubs = gaps%state(e) /= state_free .and. (abs(mesh%axial(e)) > 0.0_wp .or. mesh%rotary(e) > 0.0_wp)
         if (.not. (rubs .or. twisted)) cycle
         action%bends = .false.
         call torque_blocks(mesh%frame(:, :, e:e + 1), work%d(:, e:e + 1), work%torque(e), mesh%gj(e)/mesh%length(e), action%blocks)
         if (rubs) then
            call find_contact(mesh, loads, gaps, e, work, contact)
            call contact_action_at(contact, normal_force_type(), contact%pressing, e, work, force, moment, by_point, &
                                   moment_by_point)
            if (contact%sliding) then
               call sliding_couple(work%gap(:, e), work%axis_tangent(:, e), work%axis_curvature(:, e), contact%direction, 0.0_wp, &
                                   contact%axial*mesh%radius(e)*contact%pressing%stiffness, force, moment, push_by_point, &
                                   push_by_direction, bend_by_point, bend_by_direction)
               call couple_derivatives(contact%shape, contact%slope, by_point + push_by_point, none, bend_by_point, none, by)
            else
               call gap_derivatives(gaps%xi(e), contact%shape, contact%slope, work%d(:, e:e + 1), contact%direction, moment, &
                                    by_point, moment_by_point, by)
            end if
            call take_contact(by, gaps%xi(e), contact%shape, contact%slope, mesh%frame(:, :, e:e + 1), &
                              work%d(:, e:e + 1), action%blocks)
            if (contact%turning%lever > 0.0_wp) then
               call begin_rest(action)
               call add_turning(contact%turning, work%d(:, e:e + 1), part_rest, .true., unused, ignored, action%element)
            end if
         end if
         call add_blocks(e, action%blocks, matrix)
         if (action%bends) call scatter_more(mesh, e, work%d(:, e:e + 1), action%element, matrix)
      end do
      call add_end_torques(mesh, loads%tob, (work%top_torque), state, part_rest, .true., work, matrix)
      call hold_top(matrix)
   end subroutine add_unsymmetric_part

   !> The torques at bit and top: semi-tangential where the string is compressed near buckling, else about the string's own axis,
   !> which bends nothing.
   pure subroutine add_end_torques(mesh, at_bit, at_top, state, part, wanted, work, matrix)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: at_bit, at_top     !< torque on bit, and what holds the top [N.m]
      real(wp), intent(in) :: state(:, :)
      integer, intent(in) :: part                !< of the tangent
      logical, intent(in) :: wanted              !< the tangent is
      type(workspace_type), intent(inout) :: work
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: torque(2), gradient(3, 2)
      integer :: node(2), i, n
      node = [1, mesh%nodes]
      torque = [at_top, -at_bit]
      if (.not. any(work%climb < 1.0_wp)) then
         if (allocated(work%end_force)) then
            work%top_moment = at_top*work%d(:, 1)
            work%bit_moment = -at_bit*work%d(:, mesh%nodes)
         end if
         return
      end if
      do i = 1, 2
         n = node(i)
         gradient = director_gradient(mesh%frame(:, :, n), state(5:6, n), work%d(:, n))
         call add_end_torque(mesh, n, torque(i), gradient, part, wanted, work, matrix)
      end do
      work%top_moment = end_moment(at_top, work%d(:, 1), mesh%frame(:, 1, 1))
      work%bit_moment = end_moment(-at_bit, work%d(:, mesh%nodes), mesh%frame(:, 1, mesh%nodes))
   end subroutine add_end_torques

   !> Axial friction's couple on the string at a gap: takes its force off `force`. `by` gets its derivatives, together with those
   !> of the contact force itself.
   pure subroutine add_couple(mesh, e, contact, tangent, force_tangent, work, force, by)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(contact_type), intent(in) :: contact
      logical, intent(in) :: tangent            !< is wanted
      real(wp), intent(in) :: force_tangent(3, 3) !< of the contact force by the point [N/m]
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: force(12)
      type(gap_derivative_type), intent(inout) :: by
      real(wp) :: push(3), bend(3), push_by_point(3, 3), push_by_direction(3, 3), bend_by_point(3, 3), bend_by_direction(3, 3)
      real(wp) :: lever
      integer :: a
      lever = contact%axial*mesh%radius(e)
      if (tangent) then
         call sliding_couple(work%gap(:, e), work%axis_tangent(:, e), work%axis_curvature(:, e), contact%direction, &
                             lever*contact%pressing%force, lever*contact%pressing%stiffness, push, bend, push_by_point, &
                             push_by_direction, bend_by_point, bend_by_direction)
         call couple_derivatives(contact%shape, contact%slope, force_tangent + push_by_point, push_by_direction, bend_by_point, &
                                 bend_by_direction, by)
      else
         call couple_action(work%gap(:, e), work%axis_tangent(:, e), contact%direction, lever*contact%pressing%force, push, bend)
      end if
      if (allocated(work%contact_force)) then
         work%contact_force(:, e) = work%contact_force(:, e) + push
         work%contact_moment(:, e) = work%contact_moment(:, e) + cross(contact%direction, bend)
      end if
      do a = 1, 4
         force(3*a - 2:3*a) = force(3*a - 2:3*a) - contact%shape(a)*push - contact%slope(a)*bend
      end do
   end subroutine add_couple

   !> Lateral supports of the ends, weight and torque on bit.
   pure subroutine add_supports(trajectory, mesh, loads, wanted, work, residual, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      logical, intent(in) :: wanted        !< the tangent is
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: force(3), by_point(3, 3)
      integer :: n, pass
      do pass = 1, 2
         n = merge(1, mesh%nodes, pass == 1)
         call end_action(trajectory, mesh, n, merge(loads%top_support, loads%bit_support, pass == 1), loads%wob, work, force, &
                         by_point)
         work%node_force(1:3, n) = work%node_force(1:3, n) - force
         if (.not. wanted) cycle
         by_point = matmul(transpose(mesh%frame(:, :, n)), matmul(by_point, mesh%frame(:, :, n)))
         matrix%diagonal(1:3, 1:3, n) = matrix%diagonal(1:3, 1:3, n) - by_point
      end do
      residual(dof_twist, mesh%nodes) = residual(dof_twist, mesh%nodes) + loads%tob
   end subroutine add_supports
end module dg_assembly
