!> From the tangents of elements in space axes to the matrix of the chain's unknowns.
module dg_scatter
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_axial, dof_twist
   implicit none
   private
   public :: element_type, scatter, scatter_more, scatter_point, hold_top, clear_top
   public :: part_all, part_energy, part_rest

   !> Parts of a tangent: all of it, what derives from an energy, and the rest, by friction and torque.
   integer, parameter :: part_all = 0, part_energy = 1, part_rest = 2
   !> Unknowns of the top that are held.
   integer, parameter :: held(2) = [dof_axial, dof_twist]

   !> Tangent of one element in space axes, and its coupling with the twist.
   type :: element_type
      real(wp) :: k(12, 12)           !< by (x_i, d_i, x_j, d_j)
      real(wp) :: twist_row(2, 12)    !< torque residuals of both nodes by (x_i, d_i, x_j, d_j)
      real(wp) :: twist_column(12)    !< forces by phi_j; by phi_i the opposite
      real(wp) :: twist_stiffness     !< GJ/L
      logical :: symmetric            !< all of it
   end type element_type

contains

   !> Turns an element's matrix from space axes to its 12 unknowns and enters it in the chain: added to what the element above left
   !> at their common node.
   pure subroutine scatter(mesh, e, gradient_i, gradient_j, element, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: gradient_i(3, 2), gradient_j(3, 2)   !< of both nodes' directors by their slopes
      type(element_type), intent(in) :: element
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: block(6, 6)
      associate (frame_i => mesh%frame(:, :, e), frame_j => mesh%frame(:, :, e + 1))
         call project(element, 1, 1, frame_i, gradient_i, frame_i, gradient_i, block)
         call add_block(block, matrix%diagonal(:, :, e))
         call project(element, 2, 2, frame_j, gradient_j, frame_j, gradient_j, matrix%diagonal(:, :, e + 1))
         call project(element, 1, 2, frame_i, gradient_i, frame_j, gradient_j, matrix%upper(:, :, e))
         if (element%symmetric) then
            call transpose_block(matrix%upper(:, :, e), matrix%lower(:, :, e))
         else
            call project(element, 2, 1, frame_j, gradient_j, frame_i, gradient_i, matrix%lower(:, :, e))
         end if
      end associate
   end subroutine scatter

   !> Adds an element's matrix to a chain.
   pure subroutine scatter_more(mesh, e, gradient_i, gradient_j, element, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: gradient_i(3, 2), gradient_j(3, 2)
      type(element_type), intent(in) :: element
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: block(6, 6)
      associate (frame_i => mesh%frame(:, :, e), frame_j => mesh%frame(:, :, e + 1))
         call project(element, 1, 1, frame_i, gradient_i, frame_i, gradient_i, block)
         call add_block(block, matrix%diagonal(:, :, e))
         call project(element, 2, 2, frame_j, gradient_j, frame_j, gradient_j, block)
         call add_block(block, matrix%diagonal(:, :, e + 1))
         call project(element, 1, 2, frame_i, gradient_i, frame_j, gradient_j, block)
         call add_block(block, matrix%upper(:, :, e))
         call project(element, 2, 1, frame_j, gradient_j, frame_i, gradient_i, block)
         call add_block(block, matrix%lower(:, :, e))
      end associate
   end subroutine scatter_more

   !> Takes off a chain what the point r of an element's axis does to a force on it and to a bending vector on r': derivatives (3,3)
   !> by r. Of rank three, it is no matrix of 12 to be turned.
   pure subroutine scatter_point(mesh, e, gradient_i, gradient_j, shape, slope, force_by_point, bend_by_point, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: gradient_i(3, 2), gradient_j(3, 2)
      real(wp), intent(in) :: shape(4), slope(4)       !< N and dN/dx at the point
      real(wp), intent(in) :: force_by_point(3, 3), bend_by_point(3, 3)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), dimension(6, 3) :: left_i, left_j, right_i, right_j
      call sides(mesh%frame(:, :, e), gradient_i, shape(1:2), slope(1:2), force_by_point, bend_by_point, left_i, right_i)
      call sides(mesh%frame(:, :, e + 1), gradient_j, shape(3:4), slope(3:4), force_by_point, bend_by_point, left_j, right_j)
      call take_product(left_i, right_i, matrix%diagonal(:, :, e))
      call take_product(left_j, right_j, matrix%diagonal(:, :, e + 1))
      call take_product(left_i, right_j, matrix%upper(:, :, e))
      call take_product(left_j, right_i, matrix%lower(:, :, e))
   end subroutine scatter_point

   !> A node's part of that: its unknowns' forces by r, and r by its unknowns.
   pure subroutine sides(frame, gradient, shape, slope, force_by_point, bend_by_point, left, right)
      real(wp), intent(in) :: frame(3, 3), gradient(3, 2), shape(2), slope(2), force_by_point(3, 3), bend_by_point(3, 3)
      real(wp), intent(out) :: left(6, 3), right(6, 3)
      real(wp) :: on_place(3), on_director(3)
      integer :: i, j
      left(4, :) = 0.0_wp
      right(4, :) = 0.0_wp
      do j = 1, 3
         on_place = shape(1)*force_by_point(:, j) + slope(1)*bend_by_point(:, j)
         on_director = shape(2)*force_by_point(:, j) + slope(2)*bend_by_point(:, j)
         do i = 1, 3
            left(i, j) = on_place(1)*frame(1, i) + on_place(2)*frame(2, i) + on_place(3)*frame(3, i)
            right(i, j) = shape(1)*frame(j, i)
         end do
         do i = 1, 2
            left(4 + i, j) = on_director(1)*gradient(1, i) + on_director(2)*gradient(2, i) + on_director(3)*gradient(3, i)
            right(4 + i, j) = shape(2)*gradient(j, i)
         end do
      end do
   end subroutine sides

   !> block <- block - left right^T.
   pure subroutine take_product(left, right, block)
      real(wp), intent(in) :: left(6, 3), right(6, 3)
      real(wp), intent(inout) :: block(6, 6)
      integer :: i, j
      do j = 1, 6
         do i = 1, 6
            block(i, j) = block(i, j) - left(i, 1)*right(j, 1) - left(i, 2)*right(j, 2) - left(i, 3)*right(j, 3)
         end do
      end do
   end subroutine take_product

   pure subroutine add_block(block, to)
      real(wp), intent(in) :: block(6, 6)
      real(wp), intent(inout) :: to(6, 6)
      to = to + block
   end subroutine add_block

   pure subroutine transpose_block(from, to)
      real(wp), intent(in) :: from(6, 6)
      real(wp), intent(out) :: to(6, 6)
      to = transpose(from)
   end subroutine transpose_block

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
