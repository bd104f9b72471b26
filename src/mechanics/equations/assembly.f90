!> Global equilibrium of Eq. 12: residual r(d) = internal - external forces and its consistent tangent.
!>
!> Unknowns are d(6,nodes), which is also the order of rows and columns of every 6 x 6 block:
!> - u along the hole axis, v and w across it (frame n_1, n_2 of the node) [m]
!> - phi twist [rad]
!> - beta_1, beta_2 slopes of the string against the hole axis [-]
!> Work-conjugate residuals are three forces [N], a torque [N.m] and two moments [N.m].
module dg_assembly
   use dg_kinds, only: wp
   use dg_beam_bend, only: add_bend, bend_moment
   use dg_beam_element, only: beam_force, beam_tangent, torque_force, torque_tangent
   use dg_block_matrix, only: block_matrix_type
   use dg_director, only: director_curvature, director_gradient
   use dg_end_supports, only: end_action
   use dg_gap_action, only: add_gap_force, add_gap_tangent, add_whirl, contact_type, find_contact, load_type
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_line_load
   use dg_mesh, only: mesh_type
   use dg_scatter, only: clear_element, element_type, hold_ends, part_all, part_energy, part_of, part_rest, scatter_element
   use dg_trajectory, only: trajectory_type
   use dg_whirling, only: add_end_torque, end_moment
   use dg_workspace, only: dof_axial, dof_twist, workspace_type
   implicit none
   private
   public :: load_type, assemble, add_unsymmetric_part

contains

   !> Residual(6,nodes) and tangent at `state`, whose nodes have been placed and whose gaps have been surveyed in `work`. Top
   !> unknowns that are held (u, phi) have zero residual and a unit diagonal. `conservative` leaves friction and the
   !> unsymmetric part of torque out of the tangent. It is then the second derivative of an energy, whose inertia decides on
   !> stability. `work` returns element forces and reactions, and those of make_room_for_recovery if allocated. With
   !> `forces_only` no tangent is made and `matrix` is unchanged. The rest is the same to the last digit, at a third of the
   !> cost.
   pure subroutine assemble(trajectory, mesh, loads, gaps, state, conservative, work, residual, matrix, forces_only)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)            !< (6,nodes) [m, rad, -]
      logical, intent(in) :: conservative
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)      !< (6,nodes) [N, N.m]
      type(block_matrix_type), intent(inout) :: matrix
      logical, intent(in), optional :: forces_only   !< absent: false
      type(element_type) :: element
      real(wp) :: above(6)                             ! force of the element above on the common node
      real(wp) :: ends(6, 2), top_force(3)             ! forces on the first and the last node
      integer :: n, e, i
      element%part = merge(part_energy, part_all, conservative)
      element%tangent = .true.
      if (present(forces_only)) element%tangent = .not. forces_only
      if (allocated(work%contact_force)) then
         work%contact_force = 0.0_wp
         work%contact_moment = 0.0_wp
      end if
      above = 0.0_wp
      residual(dof_twist, 1) = 0.0_wp
      if (element%tangent) matrix%diagonal(:, :, 1) = 0.0_wp
      do e = 1, mesh%elements
         call find_element(mesh, loads, gaps, e, state, work, element)
         if (element%tangent) then
            matrix%upper(:, :, e) = 0.0_wp
            matrix%lower(:, :, e) = 0.0_wp
            matrix%diagonal(:, :, e + 1) = 0.0_wp
            call scatter_element(mesh, e, work%d(:, e:e + 1), element, matrix)
         end if
         residual(dof_twist, e) = residual(dof_twist, e) + element%twisting(1)
         residual(dof_twist, e + 1) = element%twisting(2)
         above = above + element%force(1:6)
         if (e > 1) then
            call finish_node(mesh, e, above, element%tangent, work, residual, matrix)
         else
            ends(:, 1) = above
         end if
         above = element%force(7:12)
      end do
      ends(:, 2) = above
      top_force = ends(1:3, 1)
      residual(dof_twist, mesh%nodes) = residual(dof_twist, mesh%nodes) + loads%tob
      call add_supports(trajectory, mesh, loads, element%tangent, work, ends, matrix)
      call add_end_torques(mesh, loads%tob, residual(dof_twist, 1), element%part, element%tangent, work, ends, matrix)
      do i = 1, 2
         n = merge(1, mesh%nodes, i == 1)
         call finish_node(mesh, n, ends(:, i), element%tangent, work, residual, matrix)
      end do
      work%hookload = -residual(dof_axial, 1)
      work%top_torque = residual(dof_twist, 1)
      ! The reaction is the force that holds the string: along the axis at the held unknown, across it at the support.
      work%reaction = top_force - ends(1:3, 1) + mesh%frame(:, 1, 1)*residual(dof_axial, 1)
      residual(dof_twist, 1) = 0.0_wp
      work%weight_on_bit = loads%wob
      if (mesh%held > 1) then
         work%weight_on_bit = loads%wob - residual(dof_axial, mesh%nodes)
         work%bit_load = work%bit_load + residual(dof_axial, mesh%nodes)*mesh%frame(:, 1, mesh%nodes)
         residual(dof_axial, 1) = residual(dof_axial, 1) + loads%hookload
      end if
      residual(dof_axial, mesh%held) = 0.0_wp
      if (element%tangent) call hold_ends(mesh%held, matrix)
   end subroutine assemble

   !> Compute a node's residual, except for its twist, from the forces on its place and director in space axes, and their part
   !> of the tangent.
   pure subroutine finish_node(mesh, n, force, wanted, work, residual, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: n
      real(wp), intent(in) :: force(6)
      logical, intent(in) :: wanted        !< true if the tangent is wanted
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      associate (frame => mesh%frame(:, :, n), d => work%d(:, n))
         residual(1:3, n) = matmul(force(1:3), frame)
         residual(5:6, n) = matmul(force(4:6), director_gradient(frame, d))
         if (wanted) matrix%diagonal(5:6, 5:6, n) = matrix%diagonal(5:6, 5:6, n) + director_curvature(frame, d, force(4:6))
      end associate
      if (allocated(work%node_force)) work%node_force(:, n) = force
   end subroutine finish_node

   !> Compute an element: beam, torque, weight, drag, bend, pads, gap.
   pure subroutine find_element(mesh, loads, gaps, e, state, work, element)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      type(element_type), intent(inout) :: element      !< with part and tangent set
      type(contact_type) :: contact
      real(wp) :: chord(3), drag, line(4)
      integer :: i
      call clear_element(element)
      chord = mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e))
      if (element%tangent) then
         call beam_tangent(mesh%section(e), chord, work%d(:, e), work%d(:, e + 1), element%force, work%axial(e), element%k)
         element%twist_stiffness = mesh%section(e)%gj/mesh%length(e)
      else
         call beam_force(mesh%section(e), chord, work%d(:, e), work%d(:, e + 1), element%force, work%axial(e))
      end if
      work%torque(e) = torque_of(mesh, e, state)
      call add_torque(mesh, e, work, element)
      line = hermite_line_load(mesh%length(e))
      element%force(3::3) = element%force(3::3) - line*mesh%weight(e)
      if (abs(mesh%drag(e)) > 0.0_wp) then
         drag = 0.5_wp*loads%friction_scale*mesh%drag(e)
         element%force(1:3) = element%force(1:3) - drag*mesh%frame(:, 1, e)
         element%force(7:9) = element%force(7:9) - drag*mesh%frame(:, 1, e + 1)
      end if
      if (allocated(mesh%bend)) then
         if (any(abs(mesh%bend(:, e)) > 0.0_wp)) &
            call add_bend(bend_moment(mesh%section(e)%ei, mesh%length(e), norm2(mesh%bend(:, e))), mesh%bend(:, e), chord, &
                          work%d(:, e), work%d(:, e + 1), element%tangent, element%force, element%k)
      end if
      if (allocated(mesh%push)) then
         do i = 1, 4
            element%force(3*i - 2:3*i) = element%force(3*i - 2:3*i) - line(i)*mesh%push(:, e)
         end do
      end if
      if (gaps%state(e) /= state_free) then
         call find_contact(mesh, loads, gaps, e, work, contact)
         call add_gap_force(mesh, e, contact, work, element)
         if (element%tangent) call add_gap_tangent(mesh, e, contact, work, element)
         call add_whirl(e, contact, work, element)
      else
         work%normal(e) = 0.0_wp
      end if
      if (allocated(work%end_force)) then
         work%end_force(:, e) = element%force(1:6)
         work%node_torque(e:e + 1) = [element%twisting(1), -element%twisting(2)]
      end if
   end subroutine find_element

   !> Torque in an element [N.m].
   pure function torque_of(mesh, e, state) result(torque)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: state(:, :)
      real(wp) :: torque
      torque = mesh%section(e)%gj/mesh%length(e)*(state(dof_twist, e + 1) - state(dof_twist, e))
   end function torque_of

   !> Add the torque of an element: on both nodes, and its end moments on both directors. The derivative of twisting by twist
   !> is not added here.
   pure subroutine add_torque(mesh, e, work, element)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      type(workspace_type), intent(in) :: work       !< with the torque
      type(element_type), intent(inout) :: element
      integer, parameter :: directors(6) = [4, 5, 6, 10, 11, 12]
      real(wp) :: by_i(3, 3), by_j(3, 3), by_torque(3), moment(3), by_directors(6, 6)
      integer :: i, j
      associate (torque => work%torque(e), d_i => work%d(:, e), d_j => work%d(:, e + 1))
         if (.not. abs(torque) > 0.0_wp) return
         element%twisting = element%twisting + [-torque, torque]
         moment = torque_force(torque, d_i, d_j)
         element%force(4:6) = element%force(4:6) + moment
         element%force(10:12) = element%force(10:12) + moment
         if (.not. element%tangent) return
         call torque_tangent(torque, d_i, d_j, by_i, by_j, by_torque)
         by_directors(1:3, 1:3) = by_i
         by_directors(1:3, 4:6) = by_j
         by_directors(4:6, :) = by_directors(1:3, :)
         by_directors = part_of(by_directors, element%part)
         do j = 1, 6
            do i = 1, 6
               element%k(directors(i), directors(j)) = element%k(directors(i), directors(j)) + by_directors(i, j)
            end do
         end do
         if (element%part == part_energy) return
         by_torque = mesh%section(e)%gj/mesh%length(e)*by_torque
         element%twist_column(4:6) = element%twist_column(4:6) + by_torque
         element%twist_column(10:12) = element%twist_column(10:12) + by_torque
      end associate
   end subroutine add_torque

   !> Add to the symmetric tangent of the energy at `state` the unsymmetric part of friction and torque. The sum is the whole
   !> tangent. Elements without either are skipped.
   pure subroutine add_unsymmetric_part(mesh, loads, gaps, state, work, matrix)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)            !< (6,nodes) [m, rad, -]
      type(workspace_type), intent(inout) :: work    !< placed and surveyed at `state`
      type(block_matrix_type), intent(inout) :: matrix
      type(element_type) :: element
      type(contact_type) :: contact
      real(wp) :: ends(6, 2)
      integer :: e
      logical :: rubs
      ends = 0.0_wp
      element%part = part_rest
      do e = 1, mesh%elements
         work%torque(e) = torque_of(mesh, e, state)
         rubs = gaps%state(e) /= state_free .and. (abs(mesh%friction_along(e)) > 0.0_wp .or. mesh%friction_around(e) > 0.0_wp)
         if (.not. (rubs .or. abs(work%torque(e)) > 0.0_wp)) cycle
         call clear_element(element)
         call add_torque(mesh, e, work, element)
         if (rubs) then
            call find_contact(mesh, loads, gaps, e, work, contact)
            call add_gap_tangent(mesh, e, contact, work, element)
            call add_whirl(e, contact, work, element)
         end if
         call scatter_element(mesh, e, work%d(:, e:e + 1), element, matrix)
      end do
      call add_end_torques(mesh, loads%tob, (work%top_torque), part_rest, .true., work, ends, matrix)
      call hold_ends(mesh%held, matrix)
   end subroutine add_unsymmetric_part

   !> Add the torques at bit and top. If the string is compressed near buckling, they are semi-tangential. Otherwise they act
   !> about the string's own axis, which does not bend it.
   pure subroutine add_end_torques(mesh, at_bit, at_top, part, wanted, work, ends, matrix)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: at_bit, at_top     !< torque on bit, and torque that holds the top [N.m]
      integer, intent(in) :: part                !< of the tangent
      logical, intent(in) :: wanted              !< true if the tangent is wanted
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: ends(6, 2)      !< forces on the first and the last node
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: torque(2), gradient(3, 2)
      integer :: node(2), i, n
      node = [1, mesh%nodes]
      torque = [at_top, -at_bit]
      if (.not. any(work%sideways < 1.0_wp)) then
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

   !> Add lateral supports of the ends, and weight on bit.
   pure subroutine add_supports(trajectory, mesh, loads, wanted, work, ends, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      logical, intent(in) :: wanted        !< true if the tangent is wanted
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
