!> An element in space axes, and the transfer of its tangent to the matrix of the chain's unknowns.
module dg_scatter
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type
   use dg_director, only: director_gradient
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_axial, dof_twist
   implicit none
   private
   public :: element_type, clear_element, scatter_element, part_of, hold_ends, clear_held
   public :: part_all, part_energy, part_rest

   !> Parts of a tangent: all of it, the part that derives from an energy, and the rest, by friction and torque.
   integer, parameter :: part_all = 0, part_energy = 1, part_rest = 2

   !> Internal less external forces of an element with its gap and loads, and the wanted part of its tangent.
   type :: element_type
      integer :: part = part_all
      logical :: tangent = .true.     !< true if the tangent is wanted
      real(wp) :: force(12)           !< on (x_i, d_i, x_j, d_j) [N, N.m]
      real(wp) :: twisting(2)         !< torque on both nodes [N.m]
      real(wp) :: k(12, 12)           !< derivative of force by (x_i, d_i, x_j, d_j)
      real(wp) :: twist_row(2, 12)    !< derivative of twisting by (x_i, d_i, x_j, d_j)
      real(wp) :: twist_column(12)    !< derivative of force by phi_j; by phi_i the opposite
      real(wp) :: twist_stiffness     !< GJ/L [N.m]
   end type element_type

contains

   !> Set forces, and the tangent if it is wanted, to zero.
   pure subroutine clear_element(element)
      type(element_type), intent(inout) :: element
      element%force = 0.0_wp
      element%twisting = 0.0_wp
      if (.not. element%tangent) return
      element%k = 0.0_wp
      element%twist_row = 0.0_wp
      element%twist_column = 0.0_wp
      element%twist_stiffness = 0.0_wp
   end subroutine clear_element

   !> Part of a square matrix: all, the symmetric part, or the rest.
   pure function part_of(matrix, part) result(taken)
      real(wp), intent(in) :: matrix(:, :)
      integer, intent(in) :: part
      real(wp) :: taken(size(matrix, 1), size(matrix, 1))
      taken = matrix
      if (part == part_energy) taken = 0.5_wp*(matrix + transpose(matrix))
      if (part == part_rest) taken = 0.5_wp*(matrix - transpose(matrix))
   end function part_of

   !> Add an element's matrix to a chain.
   pure subroutine scatter_element(mesh, e, d, element, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: d(3, 2)   !< directors of both nodes [-]
      type(element_type), intent(in) :: element
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: block(6, 6), gradient_i(3, 2), gradient_j(3, 2)
      gradient_i = director_gradient(mesh%frame(:, :, e), d(:, 1))
      gradient_j = director_gradient(mesh%frame(:, :, e + 1), d(:, 2))
      associate (frame_i => mesh%frame(:, :, e), frame_j => mesh%frame(:, :, e + 1))
         call project(element, 1, 1, frame_i, gradient_i, frame_i, gradient_i, block)
         matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + block
         call project(element, 2, 2, frame_j, gradient_j, frame_j, gradient_j, block)
         matrix%diagonal(:, :, e + 1) = matrix%diagonal(:, :, e + 1) + block
         call project(element, 1, 2, frame_i, gradient_i, frame_j, gradient_j, block)
         matrix%upper(:, :, e) = matrix%upper(:, :, e) + block
         call project(element, 2, 1, frame_j, gradient_j, frame_i, gradient_i, block)
         matrix%lower(:, :, e) = matrix%lower(:, :, e) + block
      end associate
   end subroutine scatter_element

   !> Project one 6 x 6 block: rows (x, d) of end p by columns (x, d) of end q become unknowns of those nodes.
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

   !> Hold phi of the top, and u of the node that is held along the hole.
   pure subroutine hold_ends(held, matrix)
      integer, intent(in) :: held          !< node: the top or the bit
      type(block_matrix_type), intent(inout) :: matrix
      call clear_held(held, matrix)
      matrix%diagonal(dof_twist, dof_twist, 1) = 1.0_wp
      matrix%diagonal(dof_axial, dof_axial, held) = 1.0_wp
   end subroutine hold_ends

   !> Remove these unknowns from a matrix: zero rows and columns.
   pure subroutine clear_held(held, matrix)
      integer, intent(in) :: held          !< node: the top or the bit
      type(block_matrix_type), intent(inout) :: matrix
      call clear_unknown(1, dof_twist, matrix)
      call clear_unknown(held, dof_axial, matrix)
   end subroutine clear_held

   !> Remove one unknown of the first or the last node from a matrix.
   pure subroutine clear_unknown(node, dof, matrix)
      integer, intent(in) :: node, dof
      type(block_matrix_type), intent(inout) :: matrix
      matrix%diagonal(dof, :, node) = 0.0_wp
      matrix%diagonal(:, dof, node) = 0.0_wp
      if (node == 1) then
         matrix%upper(dof, :, 1) = 0.0_wp
         matrix%lower(:, dof, 1) = 0.0_wp
      else
         matrix%upper(:, dof, node - 1) = 0.0_wp
         matrix%lower(dof, :, node - 1) = 0.0_wp
      end if
   end subroutine clear_unknown
end module dg_scatter
