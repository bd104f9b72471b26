!> Global equilibrium of Eq. 12: residual r(d) = internal - external forces and its consistent tangent.
!>
!> Unknowns d(6,nodes): u along the hole axis, v and w across it (frame n_1, n_2 of the node) [m], phi twist [rad],
!> beta_1, beta_2 slopes of the string against the hole axis [-]. Row and column order of every 6 x 6 block.
!> Work-conjugate residuals: three forces [N], a torque [N.m], two moments [N.m].
module dg_assembly
   use dg_kinds, only: wp
   use dg_beam_bend, only: add_bend, bend_moment
   use dg_beam_blocks, only: add_torque, part_all, part_energy, part_rest, see_nodes
   use dg_block_matrix, only: block_matrix_type
   use dg_director, only: director_gradient
   use dg_element_row, only: add_blocks, find_blocks, find_forces, gather_row, put_blocks, row_type
   use dg_end_supports, only: end_action
   use dg_gap_action, only: contact_type, enter_touch, find_contact, load_type, no_touch
   use dg_gap_contact, only: contact_action, couple_action, touch_type
   use dg_gap_element, only: gap_nodal_force
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_line_load
   use dg_lanes, only: lanes
   use dg_mesh, only: mesh_type
   use dg_scatter, only: clear_element, element_type, hold_top, scatter_more
   use dg_touch_blocks, only: take_touch
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
      type(row_type) :: row
      type(touch_type) :: touch
      type(contact_type) :: contacts(lanes)
      real(wp) :: force(12), twisting(2), above(6)     ! of an element; what the one before leaves at the common node
      real(wp) :: ends(6, 2), top_force(3)             ! forces on the first and the last node
      integer :: first, n, e, l
      row%part = merge(part_energy, part_all, conservative)
      row%tangent = .true.
      if (present(forces_only)) row%tangent = .not. forces_only
      if (allocated(work%contact_force)) then
         work%contact_force = 0.0_wp
         work%contact_moment = 0.0_wp
      end if
      above = 0.0_wp
      residual(dof_twist, 1) = 0.0_wp
      if (row%tangent) matrix%diagonal(:, :, 1) = 0.0_wp
      do first = 1, mesh%elements, lanes
         call gather_row(mesh, first, state, gaps, work, row)
         call find_forces(row)
         if (any(row%closed)) then
            if (row%tangent) call no_touch(touch)
            do l = 1, row%count
               if (.not. row%closed(l)) cycle
               e = first + l - 1
               call find_contact(mesh, loads, gaps, e, work, contacts(l))
               call take_gap_forces(mesh, l, contacts(l), work, row)
               if (row%tangent) call enter_touch(mesh, e, work, contacts(l), row%part, l, touch)
            end do
         end if
         if (row%tangent) then
            call find_blocks(row)
            if (any(row%closed)) call take_touch(row%frame, row%view, touch, row%blocks)
            call put_blocks(row, matrix)
         end if
         do l = 1, row%count
            e = first + l - 1
            call finish_element(mesh, loads, l, contacts(l), row, work, matrix, force, twisting)
            residual(dof_twist, e) = residual(dof_twist, e) + twisting(1)
            residual(dof_twist, e + 1) = twisting(2)
            above = above + force(1:6)
            if (e > 1) then
               call finish_node(mesh, e, above, row%tangent, work, residual, matrix)
            else
               ends(:, 1) = above
            end if
            above = force(7:12)
         end do
      end do
      ends(:, 2) = above
      top_force = ends(1:3, 1)
      residual(dof_twist, mesh%nodes) = residual(dof_twist, mesh%nodes) + loads%tob
      call add_supports(trajectory, mesh, loads, row%tangent, work, ends, matrix)
      call add_end_torques(mesh, loads%tob, residual(dof_twist, 1), row%part, row%tangent, work, ends, matrix)
      do l = 1, 2
         n = merge(1, mesh%nodes, l == 1)
         call finish_node(mesh, n, ends(:, l), row%tangent, work, residual, matrix)
      end do
      work%hookload = -residual(dof_axial, 1)
      work%top_torque = residual(dof_twist, 1)
      ! Reaction = what the string asks for: along the axis the held unknown's, across it the support's.
      work%reaction = top_force - ends(1:3, 1) + mesh%frame(:, 1, 1)*residual(dof_axial, 1)
      residual([dof_axial, dof_twist], 1) = 0.0_wp
      if (row%tangent) call hold_top(matrix)
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

   !> A node's residual but for its twist, from the forces on its place and director in space axes; what these do to the tangent.
   pure subroutine finish_node(mesh, n, force, wanted, work, residual, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: n
      real(wp), intent(in) :: force(6)
      logical, intent(in) :: wanted        !< the tangent is
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: by_slopes(2, 2)
      call take_to_frame(mesh%frame(:, :, n), work%d(:, n), force, residual(:, n), by_slopes)
      if (wanted) matrix%diagonal(5:6, 5:6, n) = matrix%diagonal(5:6, 5:6, n) + by_slopes
      if (allocated(work%node_force)) work%node_force(:, n) = force
   end subroutine finish_node

   !> That residual: dd/dbeta_k = s (n_k - d d.n_k), s = d.t. by_slopes(2,2) is what the director's second derivative makes of the
   !> force on it (director_curvature).
   pure subroutine take_to_frame(frame, d, force, residual, by_slopes)
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
   end subroutine take_to_frame

   !> Completes an element of a row by what is its own: weight, drag, pads, a bend, friction of a string that whirls.
   pure subroutine finish_element(mesh, loads, l, contact, row, work, matrix, force, twisting)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      integer, intent(in) :: l                       !< its lane
      type(contact_type), intent(in) :: contact      !< where its gap is closed
      type(row_type), intent(in) :: row
      type(workspace_type), intent(inout) :: work
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), intent(out) :: force(12)             !< on (x_i, d_i, x_j, d_j)
      real(wp), intent(out) :: twisting(2)           !< torque on both nodes
      real(wp) :: drag, line(4)
      integer :: e, i
      e = row%first + l - 1
      force = row%force(l, :)
      twisting = row%twisting(l, :)
      work%axial(e) = row%axial(l)
      work%torque(e) = row%torque(l)
      call take_weight(mesh%weight(e), mesh%length(e), force)
      if (abs(mesh%drag(e)) > 0.0_wp) then
         drag = 0.5_wp*loads%friction_scale*mesh%drag(e)
         force(1:3) = force(1:3) - drag*mesh%frame(:, 1, e)
         force(7:9) = force(7:9) - drag*mesh%frame(:, 1, e + 1)
      end if
      if (allocated(mesh%push)) then
         line = hermite_line_load(mesh%length(e))
         do i = 1, 4
            force(3*i - 2:3*i) = force(3*i - 2:3*i) - line(i)*mesh%push(:, e)
         end do
      end if
      if (.not. row%closed(l)) work%normal(e) = 0.0_wp
      if (allocated(mesh%bend)) call add_own_bend(mesh, l, row, work, force, matrix)
      if (row%closed(l)) call add_whirl(mesh, l, contact, row, work, force, twisting, matrix)
      if (allocated(work%end_force)) then
         work%end_force(:, e) = force(1:6)
         work%node_torque(e:e + 1) = [twisting(1), -twisting(2)]
      end if
   end subroutine finish_element

   !> Adds the bend of an element that has one.
   pure subroutine add_own_bend(mesh, l, row, work, force, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: l
      type(row_type), intent(in) :: row
      type(workspace_type), intent(in) :: work
      real(wp), intent(inout) :: force(12)
      type(block_matrix_type), intent(inout) :: matrix
      type(element_type) :: element
      real(wp) :: chord(3)
      integer :: e
      e = row%first + l - 1
      if (.not. any(abs(mesh%bend(:, e)) > 0.0_wp)) return
      chord = row%chord(l, :)
      call clear_element(element)
      call add_bend(bend_moment(mesh%ei(e), mesh%length(e), norm2(mesh%bend(:, e))), mesh%bend(:, e), chord, &
                    work%d(:, e), work%d(:, e + 1), row%tangent, force, element%k)
      if (row%tangent) call scatter_more(mesh, e, work%d(:, e:e + 1), element, matrix)
   end subroutine add_own_bend

   !> Adds friction's torque where the string whirls.
   pure subroutine add_whirl(mesh, l, contact, row, work, force, twisting, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: l
      type(contact_type), intent(in) :: contact
      type(row_type), intent(in) :: row
      type(workspace_type), intent(in) :: work
      real(wp), intent(inout) :: force(12), twisting(2)
      type(block_matrix_type), intent(inout) :: matrix
      type(element_type) :: element
      integer :: e
      if (.not. contact%turning%lever > 0.0_wp) return
      e = row%first + l - 1
      call clear_element(element)
      call add_turning(contact%turning, work%d(:, e:e + 1), row%part, row%tangent, twisting, force, element)
      if (row%tangent) call scatter_more(mesh, e, work%d(:, e:e + 1), element, matrix)
   end subroutine add_whirl

   !> A closed gap's MCGE: takes its force off its element's (Eqs. 4 and 6).
   pure subroutine take_gap_forces(mesh, l, contact, work, row)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: l                   !< its lane
      type(contact_type), intent(in) :: contact
      type(workspace_type), intent(inout) :: work
      type(row_type), intent(inout) :: row
      real(wp) :: force(3), moment(3), nodal(12), twisting(2), push(3), bend(3)
      integer :: e, a
      e = row%first + l - 1
      call contact_action(work%gap(:, e), work%axis_tangent(:, e), contact%normal, contact%axial, contact%rotary, &
                          contact%climbing, contact%radius, force, moment)
      call gap_nodal_force(contact%share, contact%shape, contact%slope, work%d(:, e), work%d(:, e + 1), contact%direction, force, &
                           moment, nodal, twisting)
      if (contact%sliding) then
         call couple_action(work%gap(:, e), work%axis_tangent(:, e), contact%direction, &
                            contact%axial*mesh%radius(e)*contact%normal, push, bend)
         do a = 1, 4
            nodal(3*a - 2:3*a) = nodal(3*a - 2:3*a) + contact%shape(a)*push + contact%slope(a)*bend
         end do
      end if
      row%force(l, :) = row%force(l, :) - nodal
      row%twisting(l, :) = row%twisting(l, :) - twisting
      if (.not. allocated(work%contact_force)) return
      work%contact_force(:, e) = force
      work%contact_moment(:, e) = moment
      if (.not. contact%rotary > 0.0_wp) work%contact_moment(:, e) = moment - contact%direction &
                                         *(dot_product(moment, contact%direction)/dot_product(contact%direction, contact%direction))
      if (contact%sliding) then
         work%contact_force(:, e) = force + push
         work%contact_moment(:, e) = moment + cross(contact%direction, bend)
      end if
      if (contact%turning%lever > 0.0_wp) work%contact_moment(:, e) = work%contact_moment(:, e) &
                                                                      + turning_moment(contact%turning, work%d(:, e:e + 1))
   end subroutine take_gap_forces

   !> Adds to the symmetric tangent of the energy at `state` the unsymmetric part, which friction and torque make: the sum is the
   !> whole tangent. Elements without either are left out.
   pure subroutine add_unsymmetric_part(mesh, loads, gaps, state, work, matrix)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work    !< placed and surveyed at `state`
      type(block_matrix_type), intent(inout) :: matrix
      type(row_type) :: row
      type(touch_type) :: touch
      type(contact_type) :: contacts(lanes)
      real(wp) :: ignored(12), unused(2), ends(6, 2)
      integer :: first, e, l
      ignored = 0.0_wp
      unused = 0.0_wp
      ends = 0.0_wp
      row%part = part_rest
      row%tangent = .true.
      do first = 1, mesh%elements, lanes
         call gather_row(mesh, first, state, gaps, work, row)
         do l = 1, row%count
            e = first + l - 1
            row%closed(l) = row%closed(l) .and. (abs(mesh%axial(e)) > 0.0_wp .or. mesh%rotary(e) > 0.0_wp)
         end do
         if (.not. (any(row%closed) .or. any(abs(row%torque) > 0.0_wp))) cycle
         row%blocks = 0.0_wp
         call see_nodes(row%frame, row%d, row%view)
         if (any(abs(row%torque) > 0.0_wp)) &
            call add_torque(row%torque, row%twist_stiffness, part_rest, row%view, row%blocks)
         if (any(row%closed)) then
            call no_touch(touch)
            do l = 1, row%count
               if (.not. row%closed(l)) cycle
               call find_contact(mesh, loads, gaps, first + l - 1, work, contacts(l))
               call enter_touch(mesh, first + l - 1, work, contacts(l), part_rest, l, touch)
            end do
            call take_touch(row%frame, row%view, touch, row%blocks)
         end if
         call add_blocks(row, matrix)
         do l = 1, row%count
            if (row%closed(l)) call add_whirl(mesh, l, contacts(l), row, work, ignored, unused, matrix)
         end do
      end do
      call add_end_torques(mesh, loads%tob, (work%top_torque), part_rest, .true., work, ends, matrix)
      call hold_top(matrix)
   end subroutine add_unsymmetric_part

   !> The torques at bit and top: semi-tangential where the string is compressed near buckling, else about the string's own axis,
   !> which bends nothing.
   pure subroutine add_end_torques(mesh, at_bit, at_top, part, wanted, work, ends, matrix)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: at_bit, at_top     !< torque on bit, and what holds the top [N.m]
      integer, intent(in) :: part                !< of the tangent
      logical, intent(in) :: wanted              !< the tangent is
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: ends(6, 2)      !< forces on the first and the last node
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
         gradient = director_gradient(mesh%frame(:, :, n), work%d(:, n))
         call add_end_torque(mesh, n, torque(i), gradient, work%d(:, n), part, wanted, ends(4:6, i), matrix)
      end do
      work%top_moment = end_moment(at_top, work%d(:, 1), mesh%frame(:, 1, 1))
      work%bit_moment = end_moment(-at_bit, work%d(:, mesh%nodes), mesh%frame(:, 1, mesh%nodes))
   end subroutine add_end_torques

   !> Lateral supports of the ends, and weight on bit.
   pure subroutine add_supports(trajectory, mesh, loads, wanted, work, ends, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      logical, intent(in) :: wanted        !< the tangent is
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: ends(6, 2)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: force(3), by_point(3, 3)
      integer :: n, pass
      do pass = 1, 2
         n = merge(1, mesh%nodes, pass == 1)
         call end_action(trajectory, mesh, n, merge(loads%top_support, loads%bit_support, pass == 1), loads%wob, work, force, &
                         by_point)
         ends(1:3, pass) = ends(1:3, pass) - force
         if (.not. wanted) cycle
         by_point = matmul(transpose(mesh%frame(:, :, n)), matmul(by_point, mesh%frame(:, :, n)))
         matrix%diagonal(1:3, 1:3, n) = matrix%diagonal(1:3, 1:3, n) - by_point
      end do
   end subroutine add_supports
end module dg_assembly
