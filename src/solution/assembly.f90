!> Global equilibrium of Eq. 12: residual r(d) = internal - external forces and its consistent tangent.
!>
!> Unknowns d(6,nodes): u along the hole axis, v and w across it (frame n_1, n_2 of the node) [m], phi twist [rad],
!> beta_1, beta_2 slopes of the string against the hole axis [-]. Row and column order of every 6 x 6 block.
!> Work-conjugate residuals: three forces [N], a torque [N.m], two moments [N.m].
module dg_assembly
   use dg_kinds, only: wp
   use dg_beam_element, only: beam_section_type, beam_tangent, membrane_length, torque_force, torque_tangent
   use dg_block_matrix, only: block_matrix_type
   use dg_director, only: director, director_curvature, director_gradient
   use dg_gap_contact, only: contact_action_tangent, support_action
   use dg_gap_element, only: gap_nodal_force, gap_nodal_tangent
   use dg_gap_state, only: contact_force, gap_law_type, state_free
   use dg_gap_table, only: gap_table_type
   use dg_hermite, only: hermite_line_load, hermite_slope, hermite_value
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: closest_point, trajectory_type
   implicit none
   private
   public :: dof_axial, dof_lateral_1, dof_lateral_2, dof_twist, dof_slope_1, dof_slope_2
   public :: load_type, workspace_type, new_workspace, assemble, place_nodes

   integer, parameter :: dof_axial = 1, dof_lateral_1 = 2, dof_lateral_2 = 3
   integer, parameter :: dof_twist = 4, dof_slope_1 = 5, dof_slope_2 = 6

   !> Loads and supports of a load case at its present increment.
   type :: load_type
      real(wp) :: wob = 0.0_wp              !< > 0 pushes the bit [N]
      real(wp) :: tob = 0.0_wp              !< torque on bit [N.m]
      real(wp) :: friction_scale = 1.0_wp   !< of all friction coefficients [-]
      real(wp) :: top_support = 0.0_wp      !< lateral stiffness of the top's support, 0: free [N/m]
      real(wp) :: bit_support = 0.0_wp      !< of the bit's [N/m]
   end type load_type

   !> Arrays of one solution, allocated once: nothing is allocated within an iteration.
   type :: workspace_type
      type(beam_section_type), allocatable :: section(:)
      real(wp), allocatable :: shift(:, :)      !< displacement of nodes in space axes (3,nodes) [m]
      real(wp), allocatable :: d(:, :)          !< directors (3,nodes)
      real(wp), allocatable :: gradient(:, :, :) !< their derivatives (3,2,nodes)
      real(wp), allocatable :: node_force(:, :) !< on x and d in space axes (6,nodes)
      ! by element, for recovery
      real(wp), allocatable :: axial(:)         !< beam's axial force, tension > 0 [N]
      real(wp), allocatable :: torque(:)        !< GJ/L (phi_j - phi_i) [N.m]
      real(wp), allocatable :: normal(:)        !< contact force R [N]
      real(wp), allocatable :: contact_force(:, :)  !< F (3,elements) [N]
      real(wp), allocatable :: contact_moment(:, :) !< M (3,elements) [N.m]
      real(wp), allocatable :: contact_point(:, :)  !< off the axis at the upper node (3,elements) [m]
      real(wp), allocatable :: displacement(:)  !< |f| at x0 [m]
      real(wp), allocatable :: end_force(:, :)  !< on (x_i, d_i, x_j, d_j), element loads taken off (12,elements)
      ! of the whole string
      real(wp) :: reaction(3) = 0.0_wp          !< force that holds the top, space axes, supports included [N]
      real(wp) :: bit_reaction(3) = 0.0_wp      !< lateral support at the bit [N]
      real(wp) :: bit_load(3) = 0.0_wp          !< force of the formation on the bit [N]
      real(wp) :: hookload = 0.0_wp             !< [N]
      real(wp) :: top_torque = 0.0_wp           !< [N.m]
   end type workspace_type

contains

   !> Room and element sections for a mesh.
   pure function new_workspace(mesh) result(work)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type) :: work
      integer :: e, n, m
      n = mesh%nodes
      m = mesh%elements
      allocate (work%section(m))
      allocate (work%shift(3, n), work%d(3, n), work%node_force(6, n), source=0.0_wp)
      allocate (work%gradient(3, 2, n), source=0.0_wp)
      allocate (work%axial(m), work%torque(m), work%normal(m), work%displacement(m), source=0.0_wp)
      allocate (work%contact_force(3, m), work%contact_moment(3, m), work%contact_point(3, m), source=0.0_wp)
      allocate (work%end_force(12, m), source=0.0_wp)
      do e = 1, m
         work%section(e) = beam_section_type(mesh%length(e), &
            membrane_length(mesh%chord(:, e), mesh%frame(:, 1, e), mesh%frame(:, 1, e + 1)), mesh%ea(e), mesh%ei(e), mesh%gj(e))
      end do
   end function new_workspace

   !> Displacements and directors in space axes from the unknowns.
   pure subroutine place_nodes(mesh, state, work)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      integer :: n
      do n = 1, mesh%nodes
         work%shift(:, n) = state(1, n)*mesh%frame(:, 1, n) + state(2, n)*mesh%frame(:, 2, n) + state(3, n)*mesh%frame(:, 3, n)
         work%d(:, n) = director(mesh%frame(:, :, n), state(5:6, n))
         work%gradient(:, :, n) = director_gradient(mesh%frame(:, :, n), state(5:6, n), work%d(:, n))
      end do
   end subroutine place_nodes

   !> Residual(6,nodes) and tangent at `state`. Top unknowns that are held (u, phi) have zero residual and a unit
   !> diagonal. `conservative` leaves friction and torque out of the tangent: it is then the symmetric second
   !> derivative of an energy, whose inertia tells stability. `work` returns element forces and reactions.
   pure subroutine assemble(trajectory, mesh, loads, gaps, state, conservative, work, residual, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      logical, intent(in) :: conservative
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: force(12), stiffness(12, 12), twist_row(2, 12), twist_column(12), twist_stiffness
      real(wp) :: load(4), top_force(3)
      integer :: e, n
      call place_nodes(mesh, state, work)
      work%node_force = 0.0_wp
      residual = 0.0_wp
      matrix%diagonal = 0.0_wp
      do e = 1, mesh%elements
         call beam_tangent(work%section(e), mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e)), work%d(:, e), &
                           work%d(:, e + 1), force, work%axial(e), stiffness)
         twist_row = 0.0_wp
         call add_torque(work, e, state(dof_twist, e + 1) - state(dof_twist, e), conservative, force, stiffness, &
                         twist_stiffness, twist_column)
         load = mesh%weight(e)*hermite_line_load(mesh%length(e))
         force(3) = force(3) - load(1)
         force(6) = force(6) - load(2)
         force(9) = force(9) - load(3)
         force(12) = force(12) - load(4)
         call add_gap(trajectory, mesh, loads, gaps, e, conservative, work, residual, force, stiffness, twist_row)
         residual(dof_twist, e) = residual(dof_twist, e) - work%torque(e)
         residual(dof_twist, e + 1) = residual(dof_twist, e + 1) + work%torque(e)
         work%end_force(:, e) = force
         work%node_force(:, e) = work%node_force(:, e) + force(1:6)
         work%node_force(:, e + 1) = work%node_force(:, e + 1) + force(7:12)
         call scatter(mesh, work, e, stiffness, twist_row, twist_column, twist_stiffness, matrix)
      end do
      top_force = work%node_force(1:3, 1)
      call add_supports(trajectory, mesh, loads, work, residual, matrix)
      do n = 1, mesh%nodes
         residual(1:3, n) = matmul(work%node_force(1:3, n), mesh%frame(:, :, n))
         residual(5:6, n) = matmul(work%node_force(4:6, n), work%gradient(:, :, n))
         matrix%diagonal(5:6, 5:6, n) = matrix%diagonal(5:6, 5:6, n) &
            + director_curvature(mesh%frame(:, :, n), state(5:6, n), work%d(:, n), work%node_force(4:6, n))
      end do
      work%hookload = -residual(dof_axial, 1)
      work%top_torque = residual(dof_twist, 1)
      ! Reaction = what the string asks for: along the axis the held unknown's, across it the support's.
      work%reaction = top_force - work%node_force(1:3, 1) + mesh%frame(:, 1, 1)*residual(dof_axial, 1)
      call hold_top(residual, matrix)
   end subroutine assemble

   !> Torque T = GJ/L (phi_j - phi_i): its end moments on the directors and its tangent.
   pure subroutine add_torque(work, e, twist, conservative, force, stiffness, twist_stiffness, twist_column)
      type(workspace_type), intent(inout) :: work
      integer, intent(in) :: e
      real(wp), intent(in) :: twist
      logical, intent(in) :: conservative
      real(wp), intent(inout) :: force(12), stiffness(12, 12)
      real(wp), intent(out) :: twist_stiffness, twist_column(12)
      real(wp) :: by_i(3, 3), by_j(3, 3), by_torque(3), end_moment(3)
      twist_stiffness = work%section(e)%torsional_stiffness/work%section(e)%length
      work%torque(e) = twist_stiffness*twist
      twist_column = 0.0_wp
      if (.not. abs(work%torque(e)) > 0.0_wp) return
      end_moment = torque_force(work%torque(e), work%d(:, e), work%d(:, e + 1))
      force(4:6) = force(4:6) + end_moment
      force(10:12) = force(10:12) + end_moment
      if (conservative) return
      call torque_tangent(work%torque(e), work%d(:, e), work%d(:, e + 1), by_i, by_j, by_torque)
      stiffness(4:6, 4:6) = stiffness(4:6, 4:6) + by_i
      stiffness(10:12, 4:6) = stiffness(10:12, 4:6) + by_i
      stiffness(4:6, 10:12) = stiffness(4:6, 10:12) + by_j
      stiffness(10:12, 10:12) = stiffness(10:12, 10:12) + by_j
      twist_column(4:6) = twist_stiffness*by_torque      ! by phi_j; by phi_i the same with opposite sign
      twist_column(10:12) = twist_column(4:6)
   end subroutine add_torque

   !> The element's MCGE: takes its force off `force` and its tangent off `stiffness` (Eqs. 4, 6, 11).
   pure subroutine add_gap(trajectory, mesh, loads, gaps, e, conservative, work, residual, force, stiffness, twist_row)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      logical, intent(in) :: conservative
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :), force(12), stiffness(12, 12), twist_row(2, 12)
      real(wp) :: shape(4), slope(4), point(3), direction(3), gap(3), tangent(3), curvature(3), offset
      real(wp) :: axial, rotary, gap_stiffness, action(3), moment(3), by_point(3, 3), moment_by_point(3, 3)
      real(wp) :: nodal(12), twisting(2), nodal_tangent(12, 12)
      integer :: arc
      shape = hermite_value(gaps%xi(e), mesh%length(e))
      point = shape(1)*work%shift(:, e) + shape(2)*work%d(:, e) &
              + shape(3)*(mesh%chord(:, e) + work%shift(:, e + 1)) + shape(4)*work%d(:, e + 1)
      work%contact_point(:, e) = point
      point = mesh%base(:, e) + point
      arc = mesh%arc(e)
      call closest_point(trajectory, arc, point, offset, gap, tangent, curvature)
      work%displacement(e) = norm2(gap)
      call contact_force(gaps%law(e), gaps%state(e), work%displacement(e), work%normal(e), gap_stiffness)
      work%contact_force(:, e) = 0.0_wp
      work%contact_moment(:, e) = 0.0_wp
      if (gaps%state(e) == state_free) return
      axial = mesh%axial(e)*loads%friction_scale
      rotary = mesh%rotary(e)*loads%friction_scale
      slope = hermite_slope(gaps%xi(e), mesh%length(e))
      direction = slope(1)*work%shift(:, e) + slope(2)*work%d(:, e) &
                  + slope(3)*(mesh%chord(:, e) + work%shift(:, e + 1)) + slope(4)*work%d(:, e + 1)
      call contact_action_tangent(gap, tangent, curvature, work%normal(e), gap_stiffness, axial, rotary, mesh%radius(e), &
                                  action, moment, by_point, moment_by_point)
      work%contact_force(:, e) = action
      work%contact_moment(:, e) = moment
      call gap_nodal_force(gaps%xi(e), shape, slope, work%d(:, e), work%d(:, e + 1), direction, action, moment, nodal, twisting)
      force = force - nodal
      residual(dof_twist, e:e + 1) = residual(dof_twist, e:e + 1) - twisting
      if (conservative) then
         call contact_action_tangent(gap, tangent, curvature, work%normal(e), gap_stiffness, 0.0_wp, 0.0_wp, mesh%radius(e), &
                                     action, moment, by_point, moment_by_point)
         moment = 0.0_wp
      end if
      call gap_nodal_tangent(gaps%xi(e), shape, slope, work%d(:, e), work%d(:, e + 1), direction, moment, by_point, &
                             moment_by_point, nodal_tangent, twist_row)
      stiffness = stiffness - nodal_tangent
      twist_row = -twist_row
   end subroutine add_gap

   !> Turns an element's matrix from space axes to its 12 unknowns and adds it to the chain.
   pure subroutine scatter(mesh, work, e, stiffness, twist_row, twist_column, twist_stiffness, matrix)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      integer, intent(in) :: e
      real(wp), intent(in) :: stiffness(12, 12), twist_row(2, 12), twist_column(12), twist_stiffness
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: block(6, 6)
      call project(stiffness(1:6, 1:6), twist_row(1, 1:6), -twist_column(1:6), twist_stiffness, mesh%frame(:, :, e), &
                   work%gradient(:, :, e), mesh%frame(:, :, e), work%gradient(:, :, e), block)
      matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + block
      call project(stiffness(7:12, 7:12), twist_row(2, 7:12), twist_column(7:12), twist_stiffness, mesh%frame(:, :, e + 1), &
                   work%gradient(:, :, e + 1), mesh%frame(:, :, e + 1), work%gradient(:, :, e + 1), block)
      matrix%diagonal(:, :, e + 1) = matrix%diagonal(:, :, e + 1) + block
      call project(stiffness(1:6, 7:12), twist_row(1, 7:12), twist_column(1:6), -twist_stiffness, mesh%frame(:, :, e), &
                   work%gradient(:, :, e), mesh%frame(:, :, e + 1), work%gradient(:, :, e + 1), block)
      matrix%upper(:, :, e) = block
      call project(stiffness(7:12, 1:6), twist_row(2, 1:6), -twist_column(7:12), -twist_stiffness, mesh%frame(:, :, e + 1), &
                   work%gradient(:, :, e + 1), mesh%frame(:, :, e), work%gradient(:, :, e), block)
      matrix%lower(:, :, e) = block
   end subroutine scatter

   !> One 6 x 6 block: rows (x, d) of one node by columns (x, d) of another become its unknowns.
   pure subroutine project(k, twist_row, twist_column, twist_stiffness, frame_row, gradient_row, frame_column, gradient_column, &
                           block)
      real(wp), intent(in) :: k(6, 6), twist_row(6), twist_column(6), twist_stiffness
      real(wp), intent(in) :: frame_row(3, 3), gradient_row(3, 2), frame_column(3, 3), gradient_column(3, 2)
      real(wp), intent(out) :: block(6, 6)
      real(wp) :: half(6, 6)
      integer :: j
      do j = 1, 3
         half(:, j) = k(:, 1)*frame_column(1, j) + k(:, 2)*frame_column(2, j) + k(:, 3)*frame_column(3, j)
         block(4, j) = dot_product(twist_row(1:3), frame_column(:, j))
      end do
      half(:, 4) = twist_column
      block(4, 4) = twist_stiffness
      do j = 1, 2
         half(:, 4 + j) = k(:, 4)*gradient_column(1, j) + k(:, 5)*gradient_column(2, j) + k(:, 6)*gradient_column(3, j)
         block(4, 4 + j) = dot_product(twist_row(4:6), gradient_column(:, j))
      end do
      do j = 1, 6
         block(1, j) = dot_product(frame_row(:, 1), half(1:3, j))
         block(2, j) = dot_product(frame_row(:, 2), half(1:3, j))
         block(3, j) = dot_product(frame_row(:, 3), half(1:3, j))
         block(5, j) = dot_product(gradient_row(:, 1), half(4:6, j))
         block(6, j) = dot_product(gradient_row(:, 2), half(4:6, j))
      end do
   end subroutine project

   !> Lateral supports of the ends, weight and torque on bit.
   pure subroutine add_supports(trajectory, mesh, loads, work, residual, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: point(3), gap(3), tangent(3), curvature(3), offset, force(3), by_point(3, 3), support, chi
      integer :: n, arc, i, j, pass
      work%bit_reaction = 0.0_wp
      do pass = 1, 2
         n = merge(1, mesh%nodes, pass == 1)
         support = merge(loads%top_support, loads%bit_support, pass == 1)
         arc = mesh%arc(n)
         point = mesh%base(:, n) + work%shift(:, n)
         call closest_point(trajectory, arc, point, offset, gap, tangent, curvature)
         call support_action(gap, tangent, curvature, support, force, by_point)
         if (pass == 2) then
            chi = 1.0_wp/(1.0_wp - dot_product(curvature, gap))
            work%bit_reaction = force
            work%bit_load = -loads%wob*tangent          ! the formation pushes up the hole
            force = force + work%bit_load
            do j = 1, 3
               by_point(:, j) = by_point(:, j) - (loads%wob*chi*tangent(j))*curvature
            end do
            residual(dof_twist, n) = residual(dof_twist, n) + loads%tob
         end if
         work%node_force(1:3, n) = work%node_force(1:3, n) - force
         by_point = matmul(transpose(mesh%frame(:, :, n)), matmul(by_point, mesh%frame(:, :, n)))
         do j = 1, 3
            do i = 1, 3
               matrix%diagonal(i, j, n) = matrix%diagonal(i, j, n) - by_point(i, j)
            end do
         end do
      end do
   end subroutine add_supports

   !> Holds u and phi of the top node.
   pure subroutine hold_top(residual, matrix)
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      integer, parameter :: held(2) = [dof_axial, dof_twist]
      integer :: i
      do i = 1, size(held)
         residual(held(i), 1) = 0.0_wp
         matrix%diagonal(held(i), :, 1) = 0.0_wp
         matrix%diagonal(:, held(i), 1) = 0.0_wp
         matrix%diagonal(held(i), held(i), 1) = 1.0_wp
         matrix%upper(held(i), :, 1) = 0.0_wp
         matrix%lower(:, held(i), 1) = 0.0_wp
      end do
   end subroutine hold_top
end module dg_assembly
