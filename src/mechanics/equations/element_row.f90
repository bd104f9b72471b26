!> Elements side by side: what their beams do, and where their blocks go.
module dg_element_row
   use dg_kinds, only: wp
   use dg_beam_blocks, only: add_torque, beam_blocks, block_ii, block_ij, block_ji, block_jj, see_nodes, view_type
   use dg_beam_energy, only: energy_hessians, measure_forces, measure_type, sections_type
   use dg_block_matrix, only: block_matrix_type
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   use dg_lanes, only: lanes
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_twist, workspace_type
   implicit none
   private
   public :: row_type, gather_row, find_forces, find_blocks, put_blocks, add_blocks

   !> So many elements one below the other, and what they and their gaps do, internal less external. Where fewer are left, the lanes
   !> that they leave are copies of the last.
   type :: row_type
      integer :: part                        !< of the tangent
      logical :: tangent                     !< is wanted
      integer :: first, count                !< elements first to first + count - 1
      logical :: closed(lanes)               !< gaps
      real(wp) :: frame(lanes + 1, 3, 3)     !< of the nodes, from above down
      real(wp) :: d(lanes + 1, 3)            !< directors in space axes
      real(wp) :: chord(lanes, 3)            !< [m]
      type(sections_type) :: sections
      real(wp) :: twist_stiffness(lanes)     !< GJ/L [N.m]
      real(wp) :: axial(lanes)               !< [N]
      real(wp) :: torque(lanes)              !< GJ/L (phi_j - phi_i) [N.m]
      real(wp) :: force(lanes, 12)           !< on (x_i, d_i, x_j, d_j), in space axes [N, N.m]
      real(wp) :: twisting(lanes, 2)         !< torque on both nodes [N.m]
      type(measure_type) :: measure
      real(wp) :: slopes(lanes, 4)           !< the energy's first derivatives (measure_forces)
      type(view_type) :: view
      real(wp) :: blocks(lanes, 6, 6, 4)     !< the tangent in the nodes' unknowns
   end type row_type

contains

   !> Gathers what is known of the elements from `first` on.
   pure subroutine gather_row(mesh, first, state, gaps, work, row)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: first
      real(wp), intent(in) :: state(:, :)
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(row_type), intent(inout) :: row
      integer :: e, l, n, j
      row%first = first
      row%count = min(lanes, mesh%elements - first + 1)
      do l = 1, lanes + 1
         n = min(first + l - 1, mesh%nodes)
         do j = 1, 3
            row%frame(l, 1, j) = mesh%frame(1, j, n)
            row%frame(l, 2, j) = mesh%frame(2, j, n)
            row%frame(l, 3, j) = mesh%frame(3, j, n)
            row%d(l, j) = work%d(j, n)
         end do
      end do
      do l = 1, lanes
         row%closed(l) = .false.
         if (l <= row%count) row%closed(l) = gaps%state(first + l - 1) /= state_free
      end do
      do l = 1, lanes
         e = min(first + l - 1, mesh%elements)
         do j = 1, 3
            row%chord(l, j) = mesh%chord(j, e) + (work%shift(j, e + 1) - work%shift(j, e))
         end do
         row%sections%membrane_length(l) = work%membrane_length(e)
         row%sections%stretching(l) = mesh%ea(e)/work%membrane_length(e)
         row%sections%bending(l) = 2.0_wp*mesh%ei(e)/mesh%length(e)
         row%twist_stiffness(l) = mesh%gj(e)/mesh%length(e)
         row%torque(l) = row%twist_stiffness(l)*(state(dof_twist, e + 1) - state(dof_twist, e))
      end do
   end subroutine gather_row

   !> Forces of the beams and of their torque.
   pure subroutine find_forces(row)
      type(row_type), intent(inout) :: row
      real(wp) :: factor, x1, x2, x3
      integer :: l
      row%twisting(:, 1) = -row%torque
      row%twisting(:, 2) = row%torque
      call measure_forces(row%sections, row%chord, row%d, row%measure, row%slopes, row%force, row%axial)
      if (.not. any(abs(row%torque) > 0.0_wp)) return
      ! torque_force, here so that it goes side by side
      do l = 1, lanes
         factor = row%torque(l)/(1.0_wp + (row%d(l, 1)*row%d(l + 1, 1) + row%d(l, 2)*row%d(l + 1, 2) + row%d(l, 3)*row%d(l + 1, 3)))
         x1 = factor*(row%d(l, 2)*row%d(l + 1, 3) - row%d(l, 3)*row%d(l + 1, 2))
         x2 = factor*(row%d(l, 3)*row%d(l + 1, 1) - row%d(l, 1)*row%d(l + 1, 3))
         x3 = factor*(row%d(l, 1)*row%d(l + 1, 2) - row%d(l, 2)*row%d(l + 1, 1))
         row%force(l, 4) = row%force(l, 4) + x1
         row%force(l, 5) = row%force(l, 5) + x2
         row%force(l, 6) = row%force(l, 6) + x3
         row%force(l, 10) = row%force(l, 10) + x1
         row%force(l, 11) = row%force(l, 11) + x2
         row%force(l, 12) = row%force(l, 12) + x3
      end do
   end subroutine find_forces

   !> Tangent of the beams and of their torque, after find_forces.
   pure subroutine find_blocks(row)
      type(row_type), intent(inout) :: row
      real(wp) :: second(lanes, 4, 4)
      call energy_hessians(row%measure, row%sections, row%axial, second)
      call see_nodes(row%frame, row%d, row%view)
      call beam_blocks(row%measure, row%slopes, second, row%frame, row%view, row%twist_stiffness, row%blocks)
      if (any(abs(row%torque) > 0.0_wp)) call add_torque(row%torque, row%twist_stiffness, row%part, row%view, row%blocks)
   end subroutine find_blocks

   !> Enters blocks in the chain: added to what the element above left at the first node.
   pure subroutine put_blocks(row, matrix)
      type(row_type), intent(in) :: row
      type(block_matrix_type), intent(inout) :: matrix
      integer :: l, e
      do l = 1, row%count
         e = row%first + l - 1
         call add_lane(l, row%blocks(:, :, :, block_ii), matrix%diagonal(:, :, e))
         call put_lane(l, row%blocks(:, :, :, block_ij), matrix%upper(:, :, e))
         call put_lane(l, row%blocks(:, :, :, block_ji), matrix%lower(:, :, e))
         call put_lane(l, row%blocks(:, :, :, block_jj), matrix%diagonal(:, :, e + 1))
      end do
   end subroutine put_blocks

   !> Adds blocks to a chain.
   pure subroutine add_blocks(row, matrix)
      type(row_type), intent(in) :: row
      type(block_matrix_type), intent(inout) :: matrix
      integer :: l, e
      do l = 1, row%count
         e = row%first + l - 1
         call add_lane(l, row%blocks(:, :, :, block_ii), matrix%diagonal(:, :, e))
         call add_lane(l, row%blocks(:, :, :, block_ij), matrix%upper(:, :, e))
         call add_lane(l, row%blocks(:, :, :, block_ji), matrix%lower(:, :, e))
         call add_lane(l, row%blocks(:, :, :, block_jj), matrix%diagonal(:, :, e + 1))
      end do
   end subroutine add_blocks

   !> A block of one lane. Written two numbers at a time, since they are stored so.
   pure subroutine put_lane(l, from, to)
      integer, intent(in) :: l
      real(wp), intent(in) :: from(lanes, 36)
      real(wp), intent(out) :: to(36)
      integer :: k
      do k = 1, 36, 2
         to(k) = from(l, k)
         to(k + 1) = from(l, k + 1)
      end do
   end subroutine put_lane

   pure subroutine add_lane(l, from, to)
      integer, intent(in) :: l
      real(wp), intent(in) :: from(lanes, 36)
      real(wp), intent(inout) :: to(36)
      integer :: k
      do k = 1, 36, 2
         to(k) = to(k) + from(l, k)
         to(k + 1) = to(k + 1) + from(l, k + 1)
      end do
   end subroutine add_lane
end module dg_element_row
