!> The tangent of the beam element and of its torque in the unknowns of its two nodes: four 6 x 6 blocks.
!>
!> It is beam_tangent and torque_tangent of dg_beam_element with the columns of both nodes' frames and directors to left and right.
!> Most of these products need not be made: axial and lateral unknowns of the upper node are components in its own frame, a
!> director's derivatives by its slopes lie across it, and the energy knows directors by three scalars alone. So everything is
!> written in the frame of the upper node. A third of the operations are left. Each number has a name of its own, since
!> the compiler keeps names in registers, but not small arrays.
!>
!> Rows and columns of a block: u, v, w [m], phi [rad], beta_1, beta_2 [-], as in dg_assembly.
module dg_beam_blocks
   use dg_kinds, only: wp
   use dg_beam_element, only: measure_type
   implicit none
   private
   public :: beam_blocks, torque_blocks
   public :: block_ii, block_ij, block_ji, block_jj, part_all, part_energy, part_rest

   !> Parts of a tangent: all of it, what derives from an energy, and the rest, by friction and torque.
   integer, parameter :: part_all = 0, part_energy = 1, part_rest = 2

   !> Order of an element's blocks: rows of the upper node i or the lower node j, columns of i or j.
   integer, parameter :: block_ii = 1, block_ij = 2, block_ji = 3, block_jj = 4

   !> A node's director and its derivatives by both slopes, in a frame that the element is seen in [-].
   type :: node_type
      real(wp) :: d(3), g(3, 2)
      real(wp) :: fold        !< g_1 x g_2 = fold d
   end type node_type

contains

   !> A node in its own frame, from the director in space axes.
   pure function own_node(frame, d) result(node)
      real(wp), intent(in) :: frame(3, 3)     !< columns t, n_1, n_2
      real(wp), intent(in) :: d(3)
      type(node_type) :: node
      real(wp) :: d1, d2, d3
      d1 = frame(1, 1)*d(1) + frame(2, 1)*d(2) + frame(3, 1)*d(3)
      d2 = frame(1, 2)*d(1) + frame(2, 2)*d(2) + frame(3, 2)*d(3)
      d3 = frame(1, 3)*d(1) + frame(2, 3)*d(2) + frame(3, 3)*d(3)
      node%d(1) = d1
      node%d(2) = d2
      node%d(3) = d3
      ! d/dbeta of (1, beta_1, beta_2)/sqrt(1 + beta^2), whose first component is the root's inverse
      node%g(1, 1) = -d1*d1*d2
      node%g(2, 1) = (1.0_wp - d2*d2)*d1
      node%g(3, 1) = -d1*d2*d3
      node%g(1, 2) = -d1*d1*d3
      node%g(2, 2) = node%g(3, 1)
      node%g(3, 2) = (1.0_wp - d3*d3)*d1
      node%fold = d1*d1*d1
   end function own_node

   !> A node seen in another frame, in which the axes of its own are the columns of `turn`(3,3).
   pure function seen_from(turn, own) result(node)
      real(wp), intent(in) :: turn(3, 3)
      type(node_type), intent(in) :: own
      type(node_type) :: node
      integer :: k
      do k = 1, 3
         node%d(k) = turn(k, 1)*own%d(1) + turn(k, 2)*own%d(2) + turn(k, 3)*own%d(3)
         node%g(k, 1) = turn(k, 1)*own%g(1, 1) + turn(k, 2)*own%g(2, 1) + turn(k, 3)*own%g(3, 1)
         node%g(k, 2) = turn(k, 1)*own%g(1, 2) + turn(k, 2)*own%g(2, 2) + turn(k, 3)*own%g(3, 2)
      end do
      node%fold = own%fold
   end function seen_from

   !> The frame of the lower node in that of the upper one: axes in columns.
   pure function turn_of(frame_i, frame_j) result(turn)
      real(wp), intent(in) :: frame_i(3, 3), frame_j(3, 3)
      real(wp) :: turn(3, 3)
      integer :: k
      do k = 1, 3
         turn(1, k) = frame_i(1, 1)*frame_j(1, k) + frame_i(2, 1)*frame_j(2, k) + frame_i(3, 1)*frame_j(3, k)
         turn(2, k) = frame_i(1, 2)*frame_j(1, k) + frame_i(2, 2)*frame_j(2, k) + frame_i(3, 2)*frame_j(3, k)
         turn(3, k) = frame_i(1, 3)*frame_j(1, k) + frame_i(2, 3)*frame_j(2, k) + frame_i(3, 3)*frame_j(3, k)
      end do
   end function turn_of

   !> K0 + KN + Ksigma of Eq. 10 and the torque's tangent, or the part of it that derives from an energy, in the four blocks of an
   !> element, blocks(6,6,4) in the order block_ii, block_ij, block_ji, block_jj [N/m, N, N.m].
   pure subroutine beam_blocks(m, first, c, frame, d, torque, stiffness, part, blocks)
      type(measure_type), intent(in) :: m            !< in space axes
      real(wp), intent(in) :: first(4), c(4, 4)      !< derivatives of the energy by (l, c_i, c_j, p)
      real(wp), intent(in) :: frame(3, 3, 2), d(3, 2)   !< of both nodes
      real(wp), intent(in) :: torque                 !< T = GJ/L (phi_j - phi_i) [N.m]
      real(wp), intent(in) :: stiffness              !< GJ/L [N.m]
      integer, intent(in) :: part                    !< of the torque's tangent
      real(wp), intent(out) :: blocks(6, 6, 4)
      type(node_type) :: i, j
      real(wp) :: turn(3, 3)
      turn = turn_of(frame(:, :, 1), frame(:, :, 2))
      i = own_node(frame(:, :, 1), d(:, 1))
      j = seen_from(turn, own_node(frame(:, :, 2), d(:, 2)))
      call fill_blocks(m, first, c, frame(:, :, 1), turn, i, j, blocks)
      blocks(4, 4, block_ii) = stiffness
      blocks(4, 4, block_jj) = stiffness
      blocks(4, 4, block_ij) = -stiffness
      blocks(4, 4, block_ji) = -stiffness
      if (abs(torque) > 0.0_wp) call add_torque(torque, stiffness, part, i, j, blocks)
   end subroutine beam_blocks

   !> What is not symmetric of the torque's tangent, alone.
   pure subroutine torque_blocks(frame, d, torque, stiffness, blocks)
      real(wp), intent(in) :: frame(3, 3, 2), d(3, 2), torque, stiffness   !< as of beam_blocks
      real(wp), intent(out) :: blocks(6, 6, 4)
      blocks = 0.0_wp
      if (.not. abs(torque) > 0.0_wp) return
      call add_torque(torque, stiffness, part_rest, own_node(frame(:, :, 1), d(:, 1)), &
                      seen_from(turn_of(frame(:, :, 1), frame(:, :, 2)), own_node(frame(:, :, 2), d(:, 2))), blocks)
   end subroutine torque_blocks

   !> The beam's part; rows and columns of the twist are zero.
   pure subroutine fill_blocks(m, first, c, frame, turn, i, j, blocks)
      type(measure_type), intent(in) :: m
      real(wp), intent(in) :: first(4), c(4, 4)
      real(wp), intent(in) :: frame(3, 3)        !< of the upper node
      real(wp), intent(in) :: turn(3, 3)         !< of turn_of
      type(node_type), intent(in) :: i, j        !< both seen from the upper node
      real(wp), intent(out) :: blocks(6, 6, 4)
      real(wp) :: e1, e2, e3, v1, v2, v3, w1, w2, w3, reciprocal, across, f_i, f_j, t_v, t_w
      real(wp) :: p1, p2, p3, q1, q2, q3, r1, r2, r3, s1, s2, s3
      real(wp) :: a11, a21, a31, a22, a32, a33, ar(3, 3)
      real(wp) :: ei(2), ej(2), dji(2), dij(2)     ! e.g_i, e.g_j, d_j.g_i, d_i.g_j
      real(wp) :: b(3, 2), h(3, 2), x, y
      integer :: k, l
      reciprocal = 1.0_wp/m%length
      e1 = frame(1, 1)*m%e(1) + frame(2, 1)*m%e(2) + frame(3, 1)*m%e(3)
      e2 = frame(1, 2)*m%e(1) + frame(2, 2)*m%e(2) + frame(3, 2)*m%e(3)
      e3 = frame(1, 3)*m%e(1) + frame(2, 3)*m%e(2) + frame(3, 3)*m%e(3)
      ! parts of both directors across the chord, over its length
      v1 = (i%d(1) - m%c_i*e1)*reciprocal
      v2 = (i%d(2) - m%c_i*e2)*reciprocal
      v3 = (i%d(3) - m%c_i*e3)*reciprocal
      w1 = (j%d(1) - m%c_j*e1)*reciprocal
      w2 = (j%d(2) - m%c_j*e2)*reciprocal
      w3 = (j%d(3) - m%c_j*e3)*reciprocal
      f_i = first(2)*reciprocal
      f_j = first(3)*reciprocal
      across = (first(1) - f_i*m%c_i - f_j*m%c_j)*reciprocal
      t_v = c(2, 1) - f_i
      t_w = c(3, 1) - f_j
      ! chord by chord: across + e p + v q + w r
      p1 = (c(1, 1) - across)*e1 + t_v*v1 + t_w*w1
      p2 = (c(1, 1) - across)*e2 + t_v*v2 + t_w*w2
      p3 = (c(1, 1) - across)*e3 + t_v*v3 + t_w*w3
      q1 = t_v*e1 + c(2, 2)*v1 + c(3, 2)*w1
      q2 = t_v*e2 + c(2, 2)*v2 + c(3, 2)*w2
      q3 = t_v*e3 + c(2, 2)*v3 + c(3, 2)*w3
      r1 = t_w*e1 + c(3, 2)*v1 + c(3, 3)*w1
      r2 = t_w*e2 + c(3, 2)*v2 + c(3, 3)*w2
      r3 = t_w*e3 + c(3, 2)*v3 + c(3, 3)*w3
      a11 = p1*e1 + q1*v1 + r1*w1 + across
      a21 = p2*e1 + q2*v1 + r2*w1
      a31 = p3*e1 + q3*v1 + r3*w1
      a22 = p2*e2 + q2*v2 + r2*w2 + across
      a32 = p3*e2 + q3*v2 + r3*w2
      a33 = p3*e3 + q3*v3 + r3*w3 + across
      ! chord by slopes
      s1 = c(4, 1)*e1 + c(4, 2)*v1 + c(4, 3)*w1
      s2 = c(4, 1)*e2 + c(4, 2)*v2 + c(4, 3)*w2
      s3 = c(4, 1)*e3 + c(4, 2)*v3 + c(4, 3)*w3
      do k = 1, 2
         ei(k) = i%g(1, k)*e1 + i%g(2, k)*e2 + i%g(3, k)*e3
         ej(k) = j%g(1, k)*e1 + j%g(2, k)*e2 + j%g(3, k)*e3
         dji(k) = i%g(1, k)*j%d(1) + i%g(2, k)*j%d(2) + i%g(3, k)*j%d(3)
         dij(k) = j%g(1, k)*i%d(1) + j%g(2, k)*i%d(2) + j%g(3, k)*i%d(3)
         b(1, k) = q1*ei(k) + s1*dji(k) + f_i*i%g(1, k)
         b(2, k) = q2*ei(k) + s2*dji(k) + f_i*i%g(2, k)
         b(3, k) = q3*ei(k) + s3*dji(k) + f_i*i%g(3, k)
         h(1, k) = r1*ej(k) + s1*dij(k) + f_j*j%g(1, k)
         h(2, k) = r2*ej(k) + s2*dij(k) + f_j*j%g(2, k)
         h(3, k) = r3*ej(k) + s3*dij(k) + f_j*j%g(3, k)
      end do
      blocks(4, :, :) = 0.0_wp
      blocks(:, 4, :) = 0.0_wp
      blocks(1, 1, block_ii) = a11
      blocks(2, 1, block_ii) = a21
      blocks(3, 1, block_ii) = a31
      blocks(1, 2, block_ii) = a21
      blocks(2, 2, block_ii) = a22
      blocks(3, 2, block_ii) = a32
      blocks(1, 3, block_ii) = a31
      blocks(2, 3, block_ii) = a32
      blocks(3, 3, block_ii) = a33
      do k = 1, 3
         ar(1, k) = a11*turn(1, k) + a21*turn(2, k) + a31*turn(3, k)
         ar(2, k) = a21*turn(1, k) + a22*turn(2, k) + a32*turn(3, k)
         ar(3, k) = a31*turn(1, k) + a32*turn(2, k) + a33*turn(3, k)
      end do
      do k = 1, 3
         do l = 1, 3
            blocks(l, k, block_ij) = -ar(l, k)
            blocks(k, l, block_ji) = -ar(l, k)
            blocks(l, k, block_jj) = turn(1, l)*ar(1, k) + turn(2, l)*ar(2, k) + turn(3, l)*ar(3, k)
         end do
      end do
      do k = 1, 2
         do l = 1, 3
            blocks(l, 4 + k, block_ii) = -b(l, k)
            blocks(4 + k, l, block_ii) = -b(l, k)
            blocks(l, 4 + k, block_ij) = -h(l, k)
            blocks(4 + k, l, block_ji) = -h(l, k)
            x = turn(1, l)*b(1, k) + turn(2, l)*b(2, k) + turn(3, l)*b(3, k)
            blocks(4 + k, l, block_ij) = x
            blocks(l, 4 + k, block_ji) = x
            y = turn(1, l)*h(1, k) + turn(2, l)*h(2, k) + turn(3, l)*h(3, k)
            blocks(l, 4 + k, block_jj) = y
            blocks(4 + k, l, block_jj) = y
         end do
      end do
      ! slopes by slopes
      do k = 1, 2
         do l = 1, 2
            blocks(4 + l, 4 + k, block_ii) = c(2, 2)*ei(l)*ei(k) + c(4, 2)*(ei(l)*dji(k) + dji(l)*ei(k)) + c(4, 4)*dji(l)*dji(k)
            blocks(4 + l, 4 + k, block_jj) = c(3, 3)*ej(l)*ej(k) + c(4, 3)*(ej(l)*dij(k) + dij(l)*ej(k)) + c(4, 4)*dij(l)*dij(k)
            x = ei(l)*(c(3, 2)*ej(k) + c(4, 2)*dij(k)) + dji(l)*(c(4, 3)*ej(k) + c(4, 4)*dij(k)) &
                + first(4)*(i%g(1, l)*j%g(1, k) + i%g(2, l)*j%g(2, k) + i%g(3, l)*j%g(3, k))
            blocks(4 + l, 4 + k, block_ij) = x
            blocks(4 + k, 4 + l, block_ji) = x
         end do
      end do
   end subroutine fill_blocks

   !> Adds a part of the torque's tangent but for that of twist by twist: the moments of torque_force by slopes and twist.
   pure subroutine add_torque(torque, stiffness, part, i, j, blocks)
      real(wp), intent(in) :: torque, stiffness
      integer, intent(in) :: part
      type(node_type), intent(in) :: i, j         !< both seen from one frame
      real(wp), intent(inout) :: blocks(6, 6, 4)
      real(wp) :: factor, p, x(3), ti(2), tj(2), dji(2), dij(2), ii(2, 2), jj(2, 2), ij(2, 2), ji(2, 2)
      integer :: k, l
      p = i%d(1)*j%d(1) + i%d(2)*j%d(2) + i%d(3)*j%d(3)
      factor = 1.0_wp/(1.0_wp + p)
      ! derivative by T, d_i x d_j/(1 + p), and its products with the derivatives of the directors
      x(1) = (i%d(2)*j%d(3) - i%d(3)*j%d(2))*factor
      x(2) = (i%d(3)*j%d(1) - i%d(1)*j%d(3))*factor
      x(3) = (i%d(1)*j%d(2) - i%d(2)*j%d(1))*factor
      do k = 1, 2
         ti(k) = i%g(1, k)*x(1) + i%g(2, k)*x(2) + i%g(3, k)*x(3)
         tj(k) = j%g(1, k)*x(1) + j%g(2, k)*x(2) + j%g(3, k)*x(3)
         dji(k) = i%g(1, k)*j%d(1) + i%g(2, k)*j%d(2) + i%g(3, k)*j%d(3)
         dij(k) = j%g(1, k)*i%d(1) + j%g(2, k)*i%d(2) + j%g(3, k)*i%d(3)
      end do
      factor = torque*factor
      do k = 1, 2
         do l = 1, 2
            ii(l, k) = -factor*ti(l)*dji(k)
            jj(l, k) = -factor*tj(l)*dij(k)
            ij(l, k) = factor*(triple(i%g(:, l), i%d, j%g(:, k)) - ti(l)*dij(k))
            ji(l, k) = -factor*(triple(j%g(:, l), j%d, i%g(:, k)) + tj(l)*dji(k))
         end do
      end do
      ! g_1.(d x g_2) = -d.(g_1 x g_2)
      x(1) = factor*p*i%fold
      ii(1, 2) = ii(1, 2) + x(1)
      ii(2, 1) = ii(2, 1) - x(1)
      x(1) = factor*p*j%fold
      jj(1, 2) = jj(1, 2) - x(1)
      jj(2, 1) = jj(2, 1) + x(1)
      call add_part(part, ii, ii, blocks(:, :, block_ii))
      call add_part(part, jj, jj, blocks(:, :, block_jj))
      call add_part(part, ij, ji, blocks(:, :, block_ij))
      call add_part(part, ji, ij, blocks(:, :, block_ji))
      if (part == part_energy) return
      do k = 1, 2
         blocks(4 + k, 4, block_ii) = blocks(4 + k, 4, block_ii) - stiffness*ti(k)
         blocks(4 + k, 4, block_ij) = blocks(4 + k, 4, block_ij) + stiffness*ti(k)
         blocks(4 + k, 4, block_ji) = blocks(4 + k, 4, block_ji) - stiffness*tj(k)
         blocks(4 + k, 4, block_jj) = blocks(4 + k, 4, block_jj) + stiffness*tj(k)
      end do
   end subroutine add_torque

   !> Adds a part of a slopes' matrix (2,2) to a block, `other` being its counterpart beyond the diagonal.
   pure subroutine add_part(part, matrix, other, block)
      integer, intent(in) :: part
      real(wp), intent(in) :: matrix(2, 2), other(2, 2)
      real(wp), intent(inout) :: block(6, 6)
      real(wp) :: plain, turned
      integer :: k, l
      plain = merge(1.0_wp, 0.5_wp, part == part_all)
      turned = 1.0_wp - plain
      if (part == part_rest) turned = -turned
      do k = 1, 2
         do l = 1, 2
            block(4 + l, 4 + k) = block(4 + l, 4 + k) + (plain*matrix(l, k) + turned*other(k, l))
         end do
      end do
   end subroutine add_part

   !> a.(b x c).
   pure function triple(a, b, c) result(product)
      real(wp), intent(in) :: a(3), b(3), c(3)
      real(wp) :: product
      product = a(1)*(b(2)*c(3) - b(3)*c(2)) + a(2)*(b(3)*c(1) - b(1)*c(3)) + a(3)*(b(1)*c(2) - b(2)*c(1))
   end function triple
end module dg_beam_blocks
