!> Global equilibrium of Eq. 12: residual r(d) = internal - external forces and its consistent tangent.
!>
!> Unknowns d(6,nodes): u along the hole axis, v and w across it (frame n_1, n_2 of the node) [m], phi twist [rad],
!> beta_1, beta_2 slopes of the string against the hole axis [-]. Row and column order of every 6 x 6 block.
!> Work-conjugate residuals: three forces [N], a torque [N.m], two moments [N.m].
module dg_assembly
   use dg_kinds, only: wp
   use dg_beam_bend, only: add_bend, bend_moment
   use dg_beam_element, only: beam_force, beam_section_type, beam_tangent, torque_force, torque_tangent
   use dg_block_matrix, only: block_matrix_type
   use dg_director, only: director_curvature, director_gradient
   use dg_end_supports, only: end_action
   use dg_gap_action, only: contact_action_at, contact_type, find_contact, load_type
   use dg_gap_contact, only: normal_force_type, sliding_couple
   use dg_gap_element, only: add_couple_tangent, gap_nodal_force, gap_nodal_tangent
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_line_load
   use dg_mesh, only: mesh_type
   use dg_scatter, only: element_type, hold_top, part_all, part_energy, part_rest, scatter, scatter_more, scatter_point
   use dg_trajectory, only: trajectory_type
   use dg_vector, only: cross
   use dg_whirling, only: add_end_torque, add_turning, end_moment, turning_moment
   use dg_workspace, only: dof_axial, dof_twist, workspace_type
   implicit none
   private
   public :: load_type, assemble, add_unsymmetric_part

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
      type(element_type) :: element
      type(beam_section_type) :: section
      real(wp) :: force(12), load(4), top_force(3), chord(3)
      real(wp) :: gradient(3, 2), next(3, 2)   ! of directors by slopes
      logical :: tangent
      integer :: e, n, j, part
      part = merge(part_energy, part_all, conservative)
      tangent = .true.
      if (present(forces_only)) tangent = .not. forces_only
      work%node_force = 0.0_wp
      if (allocated(work%contact_force)) then
         work%contact_force = 0.0_wp
         work%contact_moment = 0.0_wp
      end if
      residual = 0.0_wp
      if (tangent) matrix%diagonal(:, :, 1) = 0.0_wp
      gradient = director_gradient(mesh%frame(:, :, 1), state(5:6, 1), work%d(:, 1))
      do e = 1, mesh%elements
         chord = mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e))
         section = beam_section_type(mesh%length(e), work%membrane_length(e), mesh%ea(e), mesh%ei(e), mesh%gj(e))
         if (tangent) then
            call beam_tangent(section, chord, work%d(:, e), work%d(:, e + 1), force, work%axial(e), element%k)
         else
            call beam_force(section, chord, work%d(:, e), work%d(:, e + 1), force, work%axial(e))
         end if
         if (allocated(mesh%bend)) then
            if (any(abs(mesh%bend(:, e)) > 0.0_wp)) &
               call add_bend(bend_moment(mesh%ei(e), mesh%length(e), norm2(mesh%bend(:, e))), mesh%bend(:, e), chord, &
                             work%d(:, e), work%d(:, e + 1), tangent, force, element%k)
         end if
         call add_torque(section, work, e, state(dof_twist, e + 1) - state(dof_twist, e), part, tangent, force, element)
         load = mesh%weight(e)*hermite_line_load(mesh%length(e))
         force(3) = force(3) - load(1)
         force(6) = force(6) - load(2)
         force(9) = force(9) - load(3)
         force(12) = force(12) - load(4)
         force(1:3) = force(1:3) - 0.5_wp*loads%friction_scale*mesh%drag(e)*mesh%frame(:, 1, e)
         force(7:9) = force(7:9) - 0.5_wp*loads%friction_scale*mesh%drag(e)*mesh%frame(:, 1, e + 1)
         element%symmetric = conservative
         call add_gap(mesh, loads, gaps, e, conservative, tangent, work, residual, force, element)
         residual(dof_twist, e) = residual(dof_twist, e) - work%torque(e)
         residual(dof_twist, e + 1) = residual(dof_twist, e + 1) + work%torque(e)
         if (allocated(work%end_force)) work%end_force(:, e) = force(1:6)
         work%node_force(:, e) = work%node_force(:, e) + force(1:6)
         work%node_force(:, e + 1) = work%node_force(:, e + 1) + force(7:12)
         if (tangent) then
            next = director_gradient(mesh%frame(:, :, e + 1), state(5:6, e + 1), work%d(:, e + 1))
            call scatter(mesh, e, gradient, next, element, matrix)
            gradient = next
         end if
      end do
      top_force = work%node_force(1:3, 1)
      call add_supports(trajectory, mesh, loads, tangent, work, residual, matrix)
      call add_end_torques(mesh, loads%tob, residual(dof_twist, 1), state, part, tangent, work, matrix)
      do n = 1, mesh%nodes
         do j = 1, 3
            residual(j, n) = sum(work%node_force(1:3, n)*mesh%frame(:, j, n))
         end do
         gradient = director_gradient(mesh%frame(:, :, n), state(5:6, n), work%d(:, n))
         residual(5, n) = sum(work%node_force(4:6, n)*gradient(:, 1))
         residual(6, n) = sum(work%node_force(4:6, n)*gradient(:, 2))
         if (tangent) matrix%diagonal(5:6, 5:6, n) = matrix%diagonal(5:6, 5:6, n) &
            + director_curvature(mesh%frame(:, :, n), state(5:6, n), work%d(:, n), work%node_force(4:6, n))
      end do
      work%hookload = -residual(dof_axial, 1)
      work%top_torque = residual(dof_twist, 1)
      ! Reaction = what the string asks for: along the axis the held unknown's, across it the support's.
      work%reaction = top_force - work%node_force(1:3, 1) + mesh%frame(:, 1, 1)*residual(dof_axial, 1)
      residual([dof_axial, dof_twist], 1) = 0.0_wp
      if (tangent) call hold_top(matrix)
   end subroutine assemble

   !> Torque T = GJ/L (phi_j - phi_i): its end moments on the directors and its tangent.
   pure subroutine add_torque(section, work, e, twist, part, tangent, force, element)
      type(beam_section_type), intent(in) :: section
      type(workspace_type), intent(inout) :: work
      integer, intent(in) :: e
      real(wp), intent(in) :: twist
      integer, intent(in) :: part          !< of the tangent
      logical, intent(in) :: tangent       !< is wanted
      real(wp), intent(inout) :: force(12)
      type(element_type), intent(inout) :: element
      real(wp) :: by_i(3, 3), by_j(3, 3), by_torque(3), end_moment(3), plain, turned
      element%twist_stiffness = section%torsional_stiffness/section%length
      work%torque(e) = element%twist_stiffness*twist
      element%twist_row = 0.0_wp
      element%twist_column = 0.0_wp
      if (.not. abs(work%torque(e)) > 0.0_wp) return
      end_moment = torque_force(work%torque(e), work%d(:, e), work%d(:, e + 1))
      force(4:6) = force(4:6) + end_moment
      force(10:12) = force(10:12) + end_moment
      if (.not. tangent) return
      call torque_tangent(work%torque(e), work%d(:, e), work%d(:, e + 1), by_i, by_j, by_torque)
      ! from an energy derives the symmetric part, which is all of it but at the ends and at given torque
      plain = merge(1.0_wp, 0.5_wp, part == part_all)
      turned = 1.0_wp - plain
      if (part == part_rest) turned = -turned
      element%k(4:6, 4:6) = element%k(4:6, 4:6) + plain*by_i + turned*transpose(by_i)
      element%k(10:12, 10:12) = element%k(10:12, 10:12) + plain*by_j + turned*transpose(by_j)
      element%k(4:6, 10:12) = element%k(4:6, 10:12) + plain*by_j + turned*transpose(by_i)
      element%k(10:12, 4:6) = element%k(10:12, 4:6) + plain*by_i + turned*transpose(by_j)
      if (part == part_energy) return
      element%twist_column(4:6) = element%twist_stiffness*by_torque
      element%twist_column(10:12) = element%twist_column(4:6)
   end subroutine add_torque

   !> The element's MCGE: takes its force off `force` and its tangent off the element's (Eqs. 4, 6, 11).
   pure subroutine add_gap(mesh, loads, gaps, e, conservative, tangent, work, residual, force, element)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      logical, intent(in) :: conservative
      logical, intent(in) :: tangent     !< is wanted
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :), force(12)
      type(element_type), intent(inout) :: element
      type(contact_type) :: contact
      real(wp) :: action(3), moment(3), by_point(3, 3), moment_by_point(3, 3), nodal(12), twisting(2)
      if (gaps%state(e) == state_free) then
         work%normal(e) = 0.0_wp
         return
      end if
      call find_contact(mesh, loads, gaps, e, work, contact)
      call contact_action_at(contact, contact%normal, contact%pressing, e, work, action, moment, by_point, moment_by_point)
      if (allocated(work%contact_force)) then
         work%contact_force(:, e) = action
         work%contact_moment(:, e) = moment
      end if
      call gap_nodal_force(gaps%xi(e), contact%shape, contact%slope, work%d(:, e), work%d(:, e + 1), contact%direction, action, &
                           moment, nodal, twisting)
      force = force - nodal
      residual(dof_twist, e) = residual(dof_twist, e) - twisting(1)
      residual(dof_twist, e + 1) = residual(dof_twist, e + 1) - twisting(2)
      if (conservative .and. tangent .and. (abs(contact%axial) > 0.0_wp .or. mesh%rotary(e) > 0.0_wp)) &
         call contact_action_at(contact, contact%normal, normal_force_type(), e, work, action, moment, by_point, moment_by_point)
      if (contact%sliding) then
         if (conservative) contact%pressing%stiffness = 0.0_wp
         ! along a curved axis the couple derives from no energy, if hardly so
         element%symmetric = conservative .and. .not. any(abs(work%axis_curvature(:, e)) > 0.0_wp)
         call add_couple(mesh, e, contact, tangent, by_point, work, force, element%k)
      else if (tangent) then
         call gap_nodal_tangent(gaps%xi(e), contact%shape, contact%slope, work%d(:, e), work%d(:, e + 1), contact%direction, &
                                moment, by_point, moment_by_point, element%k, element%twist_row)
      end if
      if (.not. contact%turning%lever > 0.0_wp) return
      twisting = residual(dof_twist, e:e + 1)
      call add_turning(contact%turning, work%d(:, e:e + 1), merge(part_energy, part_all, conservative), tangent, twisting, force, &
                       element)
      residual(dof_twist, e:e + 1) = twisting
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
      type(element_type) :: element
      type(contact_type) :: contact
      real(wp), dimension(3, 3) :: by_point, moment_by_point, push_by_point, push_by_direction, bend_by_point, bend_by_direction
      real(wp) :: ignored(12), unused(2), action(3), moment(3), twist, gradient_i(3, 2), gradient_j(3, 2)
      logical :: rubs, twisted
      integer :: e
      ignored = 0.0_wp
      unused = 0.0_wp
      do e = 1, mesh%elements
         twist = state(dof_twist, e + 1) - state(dof_twist, e)
         twisted = abs(twist) > 0.0_wp
         rubs = gaps%state(e) /= state_free .and. (abs(mesh%axial(e)) > 0.0_wp .or. mesh%rotary(e) > 0.0_wp)
         if (.not. (rubs .or. twisted)) cycle
         gradient_i = director_gradient(mesh%frame(:, :, e), state(5:6, e), work%d(:, e))
         gradient_j = director_gradient(mesh%frame(:, :, e + 1), state(5:6, e + 1), work%d(:, e + 1))
         contact%sliding = .false.
         contact%turning%lever = 0.0_wp
         if (rubs) then
            call find_contact(mesh, loads, gaps, e, work, contact)
            call contact_action_at(contact, normal_force_type(), contact%pressing, e, work, action, moment, by_point, &
                                   moment_by_point)
         end if
         if (contact%sliding) then
            call sliding_couple(work%gap(:, e), work%axis_tangent(:, e), work%axis_curvature(:, e), contact%direction, 0.0_wp, &
                                contact%axial*mesh%radius(e)*contact%pressing%stiffness, action, moment, push_by_point, &
                                push_by_direction, bend_by_point, bend_by_direction)
            call scatter_point(mesh, e, gradient_i, gradient_j, contact%shape, contact%slope, by_point + push_by_point, &
                               bend_by_point, matrix)
            if (.not. (twisted .or. contact%turning%lever > 0.0_wp)) cycle
         end if
         element%k = 0.0_wp
         call add_torque(beam_section_type(length=mesh%length(e), torsional_stiffness=mesh%gj(e)), work, e, twist, part_rest, &
                         .true., ignored, element)
         element%twist_stiffness = 0.0_wp
         if (rubs .and. .not. contact%sliding) &
            call gap_nodal_tangent(gaps%xi(e), contact%shape, contact%slope, work%d(:, e), work%d(:, e + 1), contact%direction, &
                                   moment, by_point, moment_by_point, element%k, element%twist_row)
         if (contact%turning%lever > 0.0_wp) &
            call add_turning(contact%turning, work%d(:, e:e + 1), part_rest, .true., unused, ignored, element)
         call scatter_more(mesh, e, gradient_i, gradient_j, element, matrix)
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

   !> Axial friction's couple on the string at a gap: takes its force off `force` and its tangent off `stiffness`, and with it that
   !> of the contact force itself.
   pure subroutine add_couple(mesh, e, contact, tangent, force_tangent, work, force, stiffness)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(contact_type), intent(in) :: contact
      logical, intent(in) :: tangent            !< is wanted
      real(wp), intent(in) :: force_tangent(3, 3) !< of the contact force by the point [N/m]
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: force(12), stiffness(12, 12)
      real(wp) :: push(3), bend(3), push_by_point(3, 3), push_by_direction(3, 3), bend_by_point(3, 3), bend_by_direction(3, 3)
      integer :: a
      call sliding_couple(work%gap(:, e), work%axis_tangent(:, e), work%axis_curvature(:, e), contact%direction, &
                          contact%axial*mesh%radius(e)*contact%pressing%force, &
                          contact%axial*mesh%radius(e)*contact%pressing%stiffness, push, bend, push_by_point, push_by_direction, &
                          bend_by_point, bend_by_direction)
      if (allocated(work%contact_force)) then
         work%contact_force(:, e) = work%contact_force(:, e) + push
         work%contact_moment(:, e) = work%contact_moment(:, e) + cross(contact%direction, bend)
      end if
      do a = 1, 4
         force(3*a - 2:3*a) = force(3*a - 2:3*a) - contact%shape(a)*push - contact%slope(a)*bend
      end do
      if (tangent) call add_couple_tangent(contact%shape, contact%slope, force_tangent + push_by_point, push_by_direction, &
                                           bend_by_point, bend_by_direction, stiffness)
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
