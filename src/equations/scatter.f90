!> From the tangents of elements in space axes to the matrix of the chain's unknowns.
module dg_scatter
   use dg_kinds, only: wp
   use dg_beam_blocks, only: block_ii, block_ij, block_ji, block_jj
   use dg_block_matrix, only: block_matrix_type
   use dg_gap_element, only: gap_derivative_type
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_axial, dof_twist
   implicit none
   private
   public :: element_type, put_blocks, add_blocks, take_contact, scatter_more, hold_top, clear_top

   !> Unknowns of the top that are held.
   integer, parameter :: held(2) = [dof_axial, dof_twist]

   !> Tangent of one element in space axes, and its coupling with the twist.
   type :: element_type
      real(wp) :: k(12, 12)           !< by (x_i, d_i, x_j, d_j)
      real(wp) :: twist_row(2, 12)    !< torque residuals of both nodes by (x_i, d_i, x_j, d_j)
      real(wp) :: twist_column(12)    !< forces by phi_j; by phi_i the opposite
      real(wp) :: twist_stiffness     !< GJ/L
   end type element_type

contains

   !> Enters an element's blocks in the chain: added to what the element above left at their common node.
   pure subroutine put_blocks(e, blocks, matrix)
      integer, intent(in) :: e
      real(wp), intent(in) :: blocks(6, 6, 4)
      type(block_matrix_type), intent(inout) :: matrix
      call add_numbers(blocks(:, :, block_ii), matrix%diagonal(:, :, e))
      call copy_numbers(blocks(:, :, block_ij), matrix%upper(:, :, e))
      call copy_numbers(blocks(:, :, block_ji), matrix%lower(:, :, e))
      call copy_numbers(blocks(:, :, block_jj), matrix%diagonal(:, :, e + 1))
   end subroutine put_blocks

   !> Adds an element's blocks to a chain.
   pure subroutine add_blocks(e, blocks, matrix)
      integer, intent(in) :: e
      real(wp), intent(in) :: blocks(6, 6, 4)
      type(block_matrix_type), intent(inout) :: matrix
      call add_numbers(blocks(:, :, block_ii), matrix%diagonal(:, :, e))
      call add_numbers(blocks(:, :, block_ij), matrix%upper(:, :, e))
      call add_numbers(blocks(:, :, block_ji), matrix%lower(:, :, e))
      call add_numbers(blocks(:, :, block_jj), matrix%diagonal(:, :, e + 1))
   end subroutine add_blocks

   !> A block's numbers one after the other, which go two at a time.
   pure subroutine copy_numbers(from, to)
      real(wp), intent(in) :: from(36)
      real(wp), intent(out) :: to(36)
      to = from
   end subroutine copy_numbers

   pure subroutine add_numbers(from, to)
      real(wp), intent(in) :: from(36)
      real(wp), intent(inout) :: to(36)
      to = to + from
   end subroutine add_numbers

   !> Adds an element's matrix to a chain.
   pure subroutine scatter_more(mesh, e, d, element, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: d(3, 2)          !< directors of both nodes
      type(element_type), intent(in) :: element
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: block(6, 6), gradient_i(3, 2), gradient_j(3, 2)
      gradient_i = gradient_of(mesh%frame(:, :, e), d(:, 1))
      gradient_j = gradient_of(mesh%frame(:, :, e + 1), d(:, 2))
      associate (frame_i => mesh%frame(:, :, e), frame_j => mesh%frame(:, :, e + 1))
         call project(element, 1, 1, frame_i, gradient_i, frame_i, gradient_i, block)
         call add_numbers(block, matrix%diagonal(:, :, e))
         call project(element, 2, 2, frame_j, gradient_j, frame_j, gradient_j, block)
         call add_numbers(block, matrix%diagonal(:, :, e + 1))
         call project(element, 1, 2, frame_i, gradient_i, frame_j, gradient_j, block)
         call add_numbers(block, matrix%upper(:, :, e))
         call project(element, 2, 1, frame_j, gradient_j, frame_i, gradient_i, block)
         call add_numbers(block, matrix%lower(:, :, e))
      end associate
   end subroutine scatter_more

   !> Takes the derivatives of a gap's forces on its nodes off an element's blocks.
   pure subroutine take_contact(by, xi, shape, slope, frame, d, blocks)
      type(gap_derivative_type), intent(in) :: by
      real(wp), intent(in) :: xi, shape(4), slope(4)                !< x0/L, N and dN/dx there
      real(wp), intent(in) :: frame(3, 3, 2), d(3, 2)               !< of both nodes
      real(wp), intent(inout) :: blocks(6, 6, 4)
      real(wp) :: gradient(3, 2, 2), point(6, 3, 2), direction(6, 3, 2), twist(3), folded
      integer :: p, b
      gradient(:, :, 1) = gradient_of(frame(:, :, 1), d(:, 1))
      gradient(:, :, 2) = gradient_of(frame(:, :, 2), d(:, 2))
      call on_unknowns(frame, gradient, by%point, point)
      if (.not. by%turns) then
         do p = 1, 2
            call take_place(point(:, :, p), shape(1:2), frame(:, :, 1), gradient(:, :, 1), blocks(:, :, 2*p - 1))
            call take_place(point(:, :, p), shape(3:4), frame(:, :, 2), gradient(:, :, 2), blocks(:, :, 2*p))
         end do
         return
      end if
      call on_unknowns(frame, gradient, by%direction, direction)
      do p = 1, 2
         point(4, :, p) = by%twisting_by_point(p, :)
         direction(4, :, p) = by%twisting_by_direction(p, :)
         call take_both(point(:, :, p), direction(:, :, p), shape(1:2), slope(1:2), frame(:, :, 1), gradient(:, :, 1), &
                        blocks(:, :, 2*p - 1))
         call take_both(point(:, :, p), direction(:, :, p), shape(3:4), slope(3:4), frame(:, :, 2), gradient(:, :, 2), &
                        blocks(:, :, 2*p))
         twist = merge(1.0_wp - xi, xi, p == 1)*by%twist
         b = merge(block_ii, block_jj, p == 1)
         blocks(4, 5, b) = blocks(4, 5, b) - sum(twist*gradient(:, 1, p))
         blocks(4, 6, b) = blocks(4, 6, b) - sum(twist*gradient(:, 2, p))
         ! twist.(g_1 x g_2), g_1 x g_2 = s**3 d
         folded = (d(1, p)*frame(1, 1, p) + d(2, p)*frame(2, 1, p) + d(3, p)*frame(3, 1, p))**3 &
                  *(twist(1)*d(1, p) + twist(2)*d(2, p) + twist(3)*d(3, p))
         blocks(5, 6, b) = blocks(5, 6, b) + folded
         blocks(6, 5, b) = blocks(6, 5, b) - folded
      end do
   end subroutine take_contact

   !> Derivatives of a director by its slopes: director_gradient, here so that it is inlined, s (n_k - d d.n_k) with s = d.t.
   pure function gradient_of(frame, d) result(gradient)
      real(wp), intent(in) :: frame(3, 3), d(3)
      real(wp) :: gradient(3, 2)
      real(wp) :: s, d2, d3
      s = d(1)*frame(1, 1) + d(2)*frame(2, 1) + d(3)*frame(3, 1)
      d2 = d(1)*frame(1, 2) + d(2)*frame(2, 2) + d(3)*frame(3, 2)
      d3 = d(1)*frame(1, 3) + d(2)*frame(2, 3) + d(3)*frame(3, 3)
      gradient(1, 1) = s*(frame(1, 2) - d(1)*d2)
      gradient(2, 1) = s*(frame(2, 2) - d(2)*d2)
      gradient(3, 1) = s*(frame(3, 2) - d(3)*d2)
      gradient(1, 2) = s*(frame(1, 3) - d(1)*d3)
      gradient(2, 2) = s*(frame(2, 3) - d(2)*d3)
      gradient(3, 2) = s*(frame(3, 3) - d(3)*d3)
   end function gradient_of

   !> Columns of forces on (x_i, d_i, x_j, d_j) as rows of both nodes' unknowns; none on the twist.
   pure subroutine on_unknowns(frame, gradient, forces, rows)
      real(wp), intent(in) :: frame(3, 3, 2), gradient(3, 2, 2), forces(3, 4, 3)
      real(wp), intent(out) :: rows(6, 3, 2)
      integer :: i, j, p
      do p = 1, 2
         do j = 1, 3
            do i = 1, 3
               rows(i, j, p) = frame(1, i, p)*forces(1, 2*p - 1, j) + frame(2, i, p)*forces(2, 2*p - 1, j) &
                               + frame(3, i, p)*forces(3, 2*p - 1, j)
            end do
            rows(4, j, p) = 0.0_wp
            do i = 1, 2
               rows(4 + i, j, p) = gradient(1, i, p)*forces(1, 2*p, j) + gradient(2, i, p)*forces(2, 2*p, j) &
                                   + gradient(3, i, p)*forces(3, 2*p, j)
            end do
         end do
      end do
   end subroutine on_unknowns

   !> Takes derivatives by r off a block whose columns are the unknowns of a node.
   pure subroutine take_place(point, shape, frame, gradient, block)
      real(wp), intent(in) :: point(6, 3)                    !< rows of unknowns by r
      real(wp), intent(in) :: shape(2)                       !< what r has of the node's place and director
      real(wp), intent(in) :: frame(3, 3), gradient(3, 2)    !< of the node
      real(wp), intent(inout) :: block(6, 6)
      integer :: i
      do i = 1, 6
         block(i, 1) = block(i, 1) - shape(1)*(point(i, 1)*frame(1, 1) + point(i, 2)*frame(2, 1) + point(i, 3)*frame(3, 1))
         block(i, 2) = block(i, 2) - shape(1)*(point(i, 1)*frame(1, 2) + point(i, 2)*frame(2, 2) + point(i, 3)*frame(3, 2))
         block(i, 3) = block(i, 3) - shape(1)*(point(i, 1)*frame(1, 3) + point(i, 2)*frame(2, 3) + point(i, 3)*frame(3, 3))
         block(i, 5) = block(i, 5) - shape(2)*(point(i, 1)*gradient(1, 1) + point(i, 2)*gradient(2, 1) &
                                               + point(i, 3)*gradient(3, 1))
         block(i, 6) = block(i, 6) - shape(2)*(point(i, 1)*gradient(1, 2) + point(i, 2)*gradient(2, 2) &
                                               + point(i, 3)*gradient(3, 2))
      end do
   end subroutine take_place

   !> The same by r and r'.
   pure subroutine take_both(point, direction, shape, slope, frame, gradient, block)
      real(wp), intent(in) :: point(6, 3), direction(6, 3)   !< rows of unknowns by r and by r'
      real(wp), intent(in) :: shape(2), slope(2)             !< what r and r' have of the node's place and director
      real(wp), intent(in) :: frame(3, 3), gradient(3, 2)
      real(wp), intent(inout) :: block(6, 6)
      real(wp) :: x1, x2, x3
      integer :: i
      do i = 1, 6
         x1 = shape(1)*point(i, 1) + slope(1)*direction(i, 1)
         x2 = shape(1)*point(i, 2) + slope(1)*direction(i, 2)
         x3 = shape(1)*point(i, 3) + slope(1)*direction(i, 3)
         block(i, 1) = block(i, 1) - (x1*frame(1, 1) + x2*frame(2, 1) + x3*frame(3, 1))
         block(i, 2) = block(i, 2) - (x1*frame(1, 2) + x2*frame(2, 2) + x3*frame(3, 2))
         block(i, 3) = block(i, 3) - (x1*frame(1, 3) + x2*frame(2, 3) + x3*frame(3, 3))
      end do
      do i = 1, 6
         x1 = shape(2)*point(i, 1) + slope(2)*direction(i, 1)
         x2 = shape(2)*point(i, 2) + slope(2)*direction(i, 2)
         x3 = shape(2)*point(i, 3) + slope(2)*direction(i, 3)
         block(i, 5) = block(i, 5) - (x1*gradient(1, 1) + x2*gradient(2, 1) + x3*gradient(3, 1))
         block(i, 6) = block(i, 6) - (x1*gradient(1, 2) + x2*gradient(2, 2) + x3*gradient(3, 2))
      end do
   end subroutine take_both

   !> One 6 x 6 block: rows (x, d) of end p by columns (x, d) of end q become unknowns of those nodes.
   pure subroutine project(element, p, q, frame_p, gradient_p, frame_q, gradient_q, block)
      type(element_type), intent(in) :: element
      integer, intent(in) :: p, q
      real(wp), intent(in) :: frame_p(3, 3), gradient_p(3, 2), frame_q(3, 3), gradient_q(3, 2)
      real(wp), intent(out) :: block(6, 6)
      real(wp) :: half(6, 6)
      integer :: i, j, r, c
      r = 6*(p - 1)
      c = 6*(q - 1)
      do j = 1, 3
         do i = 1, 6
            half(i, j) = element%k(r + i, c + 1)*frame_q(1, j) + element%k(r + i, c + 2)*frame_q(2, j) &
                         + element%k(r + i, c + 3)*frame_q(3, j)
         end do
         block(4, j) = sum(element%twist_row(p, c + 1:c + 3)*frame_q(:, j))
      end do
      half(:, 4) = merge(element%twist_column(r + 1:r + 6), -element%twist_column(r + 1:r + 6), q == 2)
      block(4, 4) = merge(element%twist_stiffness, -element%twist_stiffness, p == q)
      do j = 1, 2
         do i = 1, 6
            half(i, 4 + j) = element%k(r + i, c + 4)*gradient_q(1, j) + element%k(r + i, c + 5)*gradient_q(2, j) &
                             + element%k(r + i, c + 6)*gradient_q(3, j)
         end do
         block(4, 4 + j) = sum(element%twist_row(p, c + 4:c + 6)*gradient_q(:, j))
      end do
      do j = 1, 6
         do i = 1, 3
            block(i, j) = frame_p(1, i)*half(1, j) + frame_p(2, i)*half(2, j) + frame_p(3, i)*half(3, j)
         end do
         do i = 1, 2
            block(4 + i, j) = gradient_p(1, i)*half(4, j) + gradient_p(2, i)*half(5, j) + gradient_p(3, i)*half(6, j)
         end do
      end do
   end subroutine project

   !> Holds u and phi of the top node.
   pure subroutine hold_top(matrix)
      type(block_matrix_type), intent(inout) :: matrix
      integer :: i
      call clear_top(matrix)
      do i = 1, size(held)
         matrix%diagonal(held(i), held(i), 1) = 1.0_wp
      end do
   end subroutine hold_top

   !> Takes the top unknowns that are held out of a matrix.
   pure subroutine clear_top(matrix)
      type(block_matrix_type), intent(inout) :: matrix
      integer :: i
      do i = 1, size(held)
         matrix%diagonal(held(i), :, 1) = 0.0_wp
         matrix%diagonal(:, held(i), 1) = 0.0_wp
         matrix%upper(held(i), :, 1) = 0.0_wp
         matrix%lower(:, held(i), 1) = 0.0_wp
      end do
   end subroutine clear_top
end module dg_scatter
