!> The tangent of the beam element and of its torque in the unknowns of its two nodes: four 6 x 6 blocks.
!>
!> It is beam_tangent and torque_tangent of dg_beam_element with the columns of both nodes' frames and directors to left and right.
!> Most of these products need not be made: axial and lateral unknowns of the upper node are components in its own frame, a
!> director's derivatives by its slopes lie across it, and the energy knows directors by three scalars alone. So everything is
!> written in the frame of the upper node. A third of the operations are left, and several elements go through them side by side
!> (dg_lanes). Loops over lanes are long, and each number in them has a name of its own: the compiler turns such loops into
!> instructions of two lanes, and keeps names in registers, but not small arrays.
!>
!> Rows and columns of a block: u, v, w [m], phi [rad], beta_1, beta_2 [-], as in dg_assembly.
module dg_beam_blocks
   use dg_kinds, only: wp
   use dg_beam_energy, only: measure_type
   use dg_lanes, only: lanes
   implicit none
   private
   public :: view_type, see_nodes, beam_blocks, add_torque
   public :: block_ii, block_ij, block_ji, block_jj, part_all, part_energy, part_rest

   !> Parts of a tangent: all of it, what derives from an energy, and the rest, by friction and torque.
   integer, parameter :: part_all = 0, part_energy = 1, part_rest = 2

   !> Order of an element's blocks: rows of the upper node i or the lower node j, columns of i or j.
   integer, parameter :: block_ii = 1, block_ij = 2, block_ji = 3, block_jj = 4

   !> Both nodes of elements side by side, seen from each one's upper node [-]: components in its frame. In (lanes, 2) and where a
   !> last dimension of two is of nodes, the upper one comes first.
   type :: view_type
      real(wp) :: turn(lanes, 3, 3)      !< frame of the lower node: axes in columns
      real(wp) :: d(lanes, 3, 2)         !< directors
      real(wp) :: g(lanes, 3, 2, 2)      !< their derivatives by both slopes
      real(wp) :: fold(lanes, 2)         !< g_1 x g_2 = fold d
   end type view_type

   !> What the energy makes of chords and slopes, seen as in view_type.
   type :: pieces_type
      real(wp) :: chord(lanes, 6)        !< chord by chord: 11, 21, 31, 22, 32, 33
      real(wp) :: slopes(lanes, 3, 2, 2) !< chord by both slopes of a node
      real(wp) :: along(lanes, 2, 2)     !< e.g of both slopes of a node
      real(wp) :: other(lanes, 2, 2)     !< the other node's d.g
   end type pieces_type

contains

   !> Sees the nodes of elements side by side from each one's upper node.
   pure subroutine see_nodes(frame, d, view)
      real(wp), intent(in) :: frame(lanes + 1, 3, 3), d(lanes + 1, 3)   !< of the nodes, from above down, in space axes
      type(view_type), intent(out) :: view
      real(wp) :: d1, d2, d3
      integer :: l, j, k
      do l = 1, lanes
         do k = 1, 3
            do j = 1, 3
               view%turn(l, j, k) = frame(l, 1, j)*frame(l + 1, 1, k) + frame(l, 2, j)*frame(l + 1, 2, k) &
                                    + frame(l, 3, j)*frame(l + 1, 3, k)
            end do
         end do
      end do
      do l = 1, lanes
         d1 = frame(l, 1, 1)*d(l, 1) + frame(l, 2, 1)*d(l, 2) + frame(l, 3, 1)*d(l, 3)
         d2 = frame(l, 1, 2)*d(l, 1) + frame(l, 2, 2)*d(l, 2) + frame(l, 3, 2)*d(l, 3)
         d3 = frame(l, 1, 3)*d(l, 1) + frame(l, 2, 3)*d(l, 2) + frame(l, 3, 3)*d(l, 3)
         view%d(l, 1, 1) = d1
         view%d(l, 2, 1) = d2
         view%d(l, 3, 1) = d3
         ! d/dbeta of (1, beta_1, beta_2)/sqrt(1 + beta^2), whose first component is the root's inverse
         view%g(l, 1, 1, 1) = -d1*d1*d2
         view%g(l, 2, 1, 1) = (1.0_wp - d2*d2)*d1
         view%g(l, 3, 1, 1) = -d1*d2*d3
         view%g(l, 1, 2, 1) = -d1*d1*d3
         view%g(l, 2, 2, 1) = -d1*d2*d3
         view%g(l, 3, 2, 1) = (1.0_wp - d3*d3)*d1
         view%fold(l, 1) = d1*d1*d1
      end do
      do l = 1, lanes
         do k = 1, 3
            view%d(l, k, 2) = frame(l, 1, k)*d(l + 1, 1) + frame(l, 2, k)*d(l + 1, 2) + frame(l, 3, k)*d(l + 1, 3)
         end do
         d1 = frame(l + 1, 1, 1)*d(l + 1, 1) + frame(l + 1, 2, 1)*d(l + 1, 2) + frame(l + 1, 3, 1)*d(l + 1, 3)
         d2 = frame(l + 1, 1, 2)*d(l + 1, 1) + frame(l + 1, 2, 2)*d(l + 1, 2) + frame(l + 1, 3, 2)*d(l + 1, 3)
         d3 = frame(l + 1, 1, 3)*d(l + 1, 1) + frame(l + 1, 2, 3)*d(l + 1, 2) + frame(l + 1, 3, 3)*d(l + 1, 3)
         ! dd/dbeta_k = s (n_k - d d.n_k), s = d.t
         do k = 1, 3
            view%g(l, k, 1, 2) = d1*(view%turn(l, k, 2) - d2*view%d(l, k, 2))
            view%g(l, k, 2, 2) = d1*(view%turn(l, k, 3) - d3*view%d(l, k, 2))
         end do
         view%fold(l, 2) = d1*d1*d1
      end do
   end subroutine see_nodes

   !> K0 + KN + Ksigma of Eq. 10 in the four blocks of elements side by side, blocks(lanes,6,6,4) in the order block_ii, block_ij,
   !> block_ji, block_jj [N/m, N, N.m]. Rows and columns of the twist are those of GJ/L alone.
   pure subroutine beam_blocks(m, first, c, frame, view, stiffness, blocks)
      type(measure_type), intent(in) :: m            !< in space axes
      real(wp), intent(in) :: first(lanes, 4), c(lanes, 4, 4)    !< derivatives of the energy by (l, c_i, c_j, p)
      real(wp), intent(in) :: frame(lanes + 1, 3, 3)             !< of the nodes
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: stiffness(lanes)       !< GJ/L [N.m]
      real(wp), intent(out) :: blocks(lanes, 6, 6, 4)
      type(pieces_type) :: pieces
      integer :: l
      call find_pieces(m, first, c, frame, view, pieces)
      call place_blocks(view%turn, pieces, blocks)
      call slope_blocks(first, c, view, pieces, blocks)
      blocks(:, 4, :, :) = 0.0_wp
      blocks(:, :, 4, :) = 0.0_wp
      do l = 1, lanes
         blocks(l, 4, 4, block_ii) = stiffness(l)
         blocks(l, 4, 4, block_jj) = stiffness(l)
         blocks(l, 4, 4, block_ij) = -stiffness(l)
         blocks(l, 4, 4, block_ji) = -stiffness(l)
      end do
   end subroutine beam_blocks

   !> What the blocks are made of.
   pure subroutine find_pieces(m, first, c, frame, view, pieces)
      type(measure_type), intent(in) :: m
      real(wp), intent(in) :: first(lanes, 4), c(lanes, 4, 4), frame(lanes + 1, 3, 3)
      type(view_type), intent(in) :: view
      type(pieces_type), intent(out) :: pieces
      real(wp) :: e1, e2, e3, v1, v2, v3, w1, w2, w3, reciprocal, across, f_i, f_j, t_v, t_w, x, y
      real(wp) :: p1, p2, p3, q1, q2, q3, r1, r2, r3, s1, s2, s3
      integer :: l, k
      do l = 1, lanes
         reciprocal = 1.0_wp/m%length(l)
         e1 = frame(l, 1, 1)*m%e(l, 1) + frame(l, 2, 1)*m%e(l, 2) + frame(l, 3, 1)*m%e(l, 3)
         e2 = frame(l, 1, 2)*m%e(l, 1) + frame(l, 2, 2)*m%e(l, 2) + frame(l, 3, 2)*m%e(l, 3)
         e3 = frame(l, 1, 3)*m%e(l, 1) + frame(l, 2, 3)*m%e(l, 2) + frame(l, 3, 3)*m%e(l, 3)
         ! parts of both directors across the chord, over its length
         v1 = (view%d(l, 1, 1) - m%c(l, 1)*e1)*reciprocal
         v2 = (view%d(l, 2, 1) - m%c(l, 1)*e2)*reciprocal
         v3 = (view%d(l, 3, 1) - m%c(l, 1)*e3)*reciprocal
         w1 = (view%d(l, 1, 2) - m%c(l, 2)*e1)*reciprocal
         w2 = (view%d(l, 2, 2) - m%c(l, 2)*e2)*reciprocal
         w3 = (view%d(l, 3, 2) - m%c(l, 2)*e3)*reciprocal
         f_i = first(l, 2)*reciprocal
         f_j = first(l, 3)*reciprocal
         across = (first(l, 1) - f_i*m%c(l, 1) - f_j*m%c(l, 2))*reciprocal
         t_v = c(l, 2, 1) - f_i
         t_w = c(l, 3, 1) - f_j
         ! chord by chord: across + e p + v q + w r
         p1 = (c(l, 1, 1) - across)*e1 + t_v*v1 + t_w*w1
         p2 = (c(l, 1, 1) - across)*e2 + t_v*v2 + t_w*w2
         p3 = (c(l, 1, 1) - across)*e3 + t_v*v3 + t_w*w3
         q1 = t_v*e1 + c(l, 2, 2)*v1 + c(l, 3, 2)*w1
         q2 = t_v*e2 + c(l, 2, 2)*v2 + c(l, 3, 2)*w2
         q3 = t_v*e3 + c(l, 2, 2)*v3 + c(l, 3, 2)*w3
         r1 = t_w*e1 + c(l, 3, 2)*v1 + c(l, 3, 3)*w1
         r2 = t_w*e2 + c(l, 3, 2)*v2 + c(l, 3, 3)*w2
         r3 = t_w*e3 + c(l, 3, 2)*v3 + c(l, 3, 3)*w3
         pieces%chord(l, 1) = p1*e1 + q1*v1 + r1*w1 + across
         pieces%chord(l, 2) = p2*e1 + q2*v1 + r2*w1
         pieces%chord(l, 3) = p3*e1 + q3*v1 + r3*w1
         pieces%chord(l, 4) = p2*e2 + q2*v2 + r2*w2 + across
         pieces%chord(l, 5) = p3*e2 + q3*v2 + r3*w2
         pieces%chord(l, 6) = p3*e3 + q3*v3 + r3*w3 + across
         ! chord by slopes
         s1 = c(l, 4, 1)*e1 + c(l, 4, 2)*v1 + c(l, 4, 3)*w1
         s2 = c(l, 4, 1)*e2 + c(l, 4, 2)*v2 + c(l, 4, 3)*w2
         s3 = c(l, 4, 1)*e3 + c(l, 4, 2)*v3 + c(l, 4, 3)*w3
         do k = 1, 2
            x = view%g(l, 1, k, 1)*e1 + view%g(l, 2, k, 1)*e2 + view%g(l, 3, k, 1)*e3
            y = view%g(l, 1, k, 1)*view%d(l, 1, 2) + view%g(l, 2, k, 1)*view%d(l, 2, 2) + view%g(l, 3, k, 1)*view%d(l, 3, 2)
            pieces%along(l, k, 1) = x
            pieces%other(l, k, 1) = y
            pieces%slopes(l, 1, k, 1) = q1*x + s1*y + f_i*view%g(l, 1, k, 1)
            pieces%slopes(l, 2, k, 1) = q2*x + s2*y + f_i*view%g(l, 2, k, 1)
            pieces%slopes(l, 3, k, 1) = q3*x + s3*y + f_i*view%g(l, 3, k, 1)
            x = view%g(l, 1, k, 2)*e1 + view%g(l, 2, k, 2)*e2 + view%g(l, 3, k, 2)*e3
            y = view%g(l, 1, k, 2)*view%d(l, 1, 1) + view%g(l, 2, k, 2)*view%d(l, 2, 1) + view%g(l, 3, k, 2)*view%d(l, 3, 1)
            pieces%along(l, k, 2) = x
            pieces%other(l, k, 2) = y
            pieces%slopes(l, 1, k, 2) = r1*x + s1*y + f_j*view%g(l, 1, k, 2)
            pieces%slopes(l, 2, k, 2) = r2*x + s2*y + f_j*view%g(l, 2, k, 2)
            pieces%slopes(l, 3, k, 2) = r3*x + s3*y + f_j*view%g(l, 3, k, 2)
         end do
      end do
   end subroutine find_pieces

   !> Rows and columns of places, and of places by slopes.
   pure subroutine place_blocks(turn, pieces, blocks)
      real(wp), intent(in) :: turn(lanes, 3, 3)
      type(pieces_type), intent(in) :: pieces
      real(wp), intent(inout) :: blocks(lanes, 6, 6, 4)
      real(wp) :: x1, x2, x3, y1, y2, y3
      integer :: l, k, p
      do l = 1, lanes
         blocks(l, 1, 1, block_ii) = pieces%chord(l, 1)
         blocks(l, 2, 1, block_ii) = pieces%chord(l, 2)
         blocks(l, 3, 1, block_ii) = pieces%chord(l, 3)
         blocks(l, 1, 2, block_ii) = pieces%chord(l, 2)
         blocks(l, 2, 2, block_ii) = pieces%chord(l, 4)
         blocks(l, 3, 2, block_ii) = pieces%chord(l, 5)
         blocks(l, 1, 3, block_ii) = pieces%chord(l, 3)
         blocks(l, 2, 3, block_ii) = pieces%chord(l, 5)
         blocks(l, 3, 3, block_ii) = pieces%chord(l, 6)
      end do
      do l = 1, lanes
         do k = 1, 3
            x1 = pieces%chord(l, 1)*turn(l, 1, k) + pieces%chord(l, 2)*turn(l, 2, k) + pieces%chord(l, 3)*turn(l, 3, k)
            x2 = pieces%chord(l, 2)*turn(l, 1, k) + pieces%chord(l, 4)*turn(l, 2, k) + pieces%chord(l, 5)*turn(l, 3, k)
            x3 = pieces%chord(l, 3)*turn(l, 1, k) + pieces%chord(l, 5)*turn(l, 2, k) + pieces%chord(l, 6)*turn(l, 3, k)
            blocks(l, 1, k, block_ij) = -x1
            blocks(l, 2, k, block_ij) = -x2
            blocks(l, 3, k, block_ij) = -x3
            blocks(l, k, 1, block_ji) = -x1
            blocks(l, k, 2, block_ji) = -x2
            blocks(l, k, 3, block_ji) = -x3
            blocks(l, 1, k, block_jj) = turn(l, 1, 1)*x1 + turn(l, 2, 1)*x2 + turn(l, 3, 1)*x3
            blocks(l, 2, k, block_jj) = turn(l, 1, 2)*x1 + turn(l, 2, 2)*x2 + turn(l, 3, 2)*x3
            blocks(l, 3, k, block_jj) = turn(l, 1, 3)*x1 + turn(l, 2, 3)*x2 + turn(l, 3, 3)*x3
         end do
      end do
      ! slopes of node p: blocks p and 2 p - 1 have them with places of i, 2 + p and 2 p with those of j
      do p = 1, 2
         do k = 1, 2
            do l = 1, lanes
               x1 = pieces%slopes(l, 1, k, p)
               x2 = pieces%slopes(l, 2, k, p)
               x3 = pieces%slopes(l, 3, k, p)
               blocks(l, 1, 4 + k, p) = -x1
               blocks(l, 2, 4 + k, p) = -x2
               blocks(l, 3, 4 + k, p) = -x3
               blocks(l, 4 + k, 1, 2*p - 1) = -x1
               blocks(l, 4 + k, 2, 2*p - 1) = -x2
               blocks(l, 4 + k, 3, 2*p - 1) = -x3
               y1 = turn(l, 1, 1)*x1 + turn(l, 2, 1)*x2 + turn(l, 3, 1)*x3
               y2 = turn(l, 1, 2)*x1 + turn(l, 2, 2)*x2 + turn(l, 3, 2)*x3
               y3 = turn(l, 1, 3)*x1 + turn(l, 2, 3)*x2 + turn(l, 3, 3)*x3
               blocks(l, 1, 4 + k, 2 + p) = y1
               blocks(l, 2, 4 + k, 2 + p) = y2
               blocks(l, 3, 4 + k, 2 + p) = y3
               blocks(l, 4 + k, 1, 2*p) = y1
               blocks(l, 4 + k, 2, 2*p) = y2
               blocks(l, 4 + k, 3, 2*p) = y3
            end do
         end do
      end do
   end subroutine place_blocks

   !> Slopes by slopes.
   pure subroutine slope_blocks(first, c, view, pieces, blocks)
      real(wp), intent(in) :: first(lanes, 4), c(lanes, 4, 4)
      type(view_type), intent(in) :: view
      type(pieces_type), intent(in) :: pieces
      real(wp), intent(inout) :: blocks(lanes, 6, 6, 4)
      real(wp) :: x, along, other
      integer :: l, k, p
      do p = 1, 2
         do l = 1, lanes
            do k = 1, 2
               along = c(l, 1 + p, 1 + p)*pieces%along(l, k, p) + c(l, 4, 1 + p)*pieces%other(l, k, p)
               other = c(l, 4, 1 + p)*pieces%along(l, k, p) + c(l, 4, 4)*pieces%other(l, k, p)
               blocks(l, 5, 4 + k, 3*p - 2) = pieces%along(l, 1, p)*along + pieces%other(l, 1, p)*other
               blocks(l, 6, 4 + k, 3*p - 2) = pieces%along(l, 2, p)*along + pieces%other(l, 2, p)*other
            end do
         end do
      end do
      do l = 1, lanes
         do k = 1, 2
            along = c(l, 3, 2)*pieces%along(l, k, 2) + c(l, 4, 2)*pieces%other(l, k, 2)
            other = c(l, 4, 3)*pieces%along(l, k, 2) + c(l, 4, 4)*pieces%other(l, k, 2)
            x = pieces%along(l, 1, 1)*along + pieces%other(l, 1, 1)*other &
                + first(l, 4)*(view%g(l, 1, 1, 1)*view%g(l, 1, k, 2) + view%g(l, 2, 1, 1)*view%g(l, 2, k, 2) &
                               + view%g(l, 3, 1, 1)*view%g(l, 3, k, 2))
            blocks(l, 5, 4 + k, block_ij) = x
            blocks(l, 4 + k, 5, block_ji) = x
            x = pieces%along(l, 2, 1)*along + pieces%other(l, 2, 1)*other &
                + first(l, 4)*(view%g(l, 1, 2, 1)*view%g(l, 1, k, 2) + view%g(l, 2, 2, 1)*view%g(l, 2, k, 2) &
                               + view%g(l, 3, 2, 1)*view%g(l, 3, k, 2))
            blocks(l, 6, 4 + k, block_ij) = x
            blocks(l, 4 + k, 6, block_ji) = x
         end do
      end do
   end subroutine slope_blocks

   !> Adds a part of the torque's tangent but for that of twist by twist: the moments of torque_force by slopes and twist. Lanes
   !> without torque get nothing.
   pure subroutine add_torque(torque, stiffness, part, view, blocks)
      real(wp), intent(in) :: torque(lanes)         !< T = GJ/L (phi_j - phi_i) [N.m]
      real(wp), intent(in) :: stiffness(lanes)      !< GJ/L [N.m]
      integer, intent(in) :: part
      type(view_type), intent(in) :: view
      real(wp), intent(inout) :: blocks(lanes, 6, 6, 4)
      real(wp) :: ii(lanes, 2, 2), jj(lanes, 2, 2), ij(lanes, 2, 2), ji(lanes, 2, 2), turning(lanes, 2, 2), by_twist(lanes), x
      integer :: l, k
      call torque_pieces(torque, view, ii, jj, ij, ji, turning)
      call add_part(part, ii, ii, blocks(:, :, :, block_ii))
      call add_part(part, jj, jj, blocks(:, :, :, block_jj))
      call add_part(part, ij, ji, blocks(:, :, :, block_ij))
      call add_part(part, ji, ij, blocks(:, :, :, block_ji))
      if (part == part_energy) return
      by_twist = merge(stiffness, 0.0_wp, abs(torque) > 0.0_wp)
      do l = 1, lanes
         do k = 1, 2
            x = by_twist(l)*turning(l, k, 1)
            blocks(l, 4 + k, 4, block_ii) = blocks(l, 4 + k, 4, block_ii) - x
            blocks(l, 4 + k, 4, block_ij) = blocks(l, 4 + k, 4, block_ij) + x
            x = by_twist(l)*turning(l, k, 2)
            blocks(l, 4 + k, 4, block_ji) = blocks(l, 4 + k, 4, block_ji) - x
            blocks(l, 4 + k, 4, block_jj) = blocks(l, 4 + k, 4, block_jj) + x
         end do
      end do
   end subroutine add_torque

   !> Slopes by slopes of the torque, and the products of its derivative by T with the derivatives of the directors.
   pure subroutine torque_pieces(torque, view, ii, jj, ij, ji, turning)
      real(wp), intent(in) :: torque(lanes)
      type(view_type), intent(in) :: view
      real(wp), intent(out), dimension(lanes, 2, 2) :: ii, jj, ij, ji, turning    !< turning: slope, node
      real(wp) :: factor, p, x1, x2, x3, y1, y2, y3, i1, i2, i3, j1, j2, j3, dji, dij
      integer :: l, j, k
      do l = 1, lanes
         i1 = view%d(l, 1, 1)
         i2 = view%d(l, 2, 1)
         i3 = view%d(l, 3, 1)
         j1 = view%d(l, 1, 2)
         j2 = view%d(l, 2, 2)
         j3 = view%d(l, 3, 2)
         p = i1*j1 + i2*j2 + i3*j3
         factor = 1.0_wp/(1.0_wp + p)
         ! derivative by T: d_i x d_j/(1 + p)
         x1 = (i2*j3 - i3*j2)*factor
         x2 = (i3*j1 - i1*j3)*factor
         x3 = (i1*j2 - i2*j1)*factor
         do k = 1, 2
            turning(l, k, 1) = view%g(l, 1, k, 1)*x1 + view%g(l, 2, k, 1)*x2 + view%g(l, 3, k, 1)*x3
            turning(l, k, 2) = view%g(l, 1, k, 2)*x1 + view%g(l, 2, k, 2)*x2 + view%g(l, 3, k, 2)*x3
         end do
         factor = torque(l)*factor
         do k = 1, 2
            dji = view%g(l, 1, k, 1)*j1 + view%g(l, 2, k, 1)*j2 + view%g(l, 3, k, 1)*j3
            dij = view%g(l, 1, k, 2)*i1 + view%g(l, 2, k, 2)*i2 + view%g(l, 3, k, 2)*i3
            ! d_i x g_j and d_j x g_i
            x1 = i2*view%g(l, 3, k, 2) - i3*view%g(l, 2, k, 2)
            x2 = i3*view%g(l, 1, k, 2) - i1*view%g(l, 3, k, 2)
            x3 = i1*view%g(l, 2, k, 2) - i2*view%g(l, 1, k, 2)
            y1 = j2*view%g(l, 3, k, 1) - j3*view%g(l, 2, k, 1)
            y2 = j3*view%g(l, 1, k, 1) - j1*view%g(l, 3, k, 1)
            y3 = j1*view%g(l, 2, k, 1) - j2*view%g(l, 1, k, 1)
            do j = 1, 2
               ii(l, j, k) = -factor*turning(l, j, 1)*dji
               jj(l, j, k) = -factor*turning(l, j, 2)*dij
               ij(l, j, k) = factor*(view%g(l, 1, j, 1)*x1 + view%g(l, 2, j, 1)*x2 + view%g(l, 3, j, 1)*x3 &
                                     - turning(l, j, 1)*dij)
               ji(l, j, k) = -factor*(view%g(l, 1, j, 2)*y1 + view%g(l, 2, j, 2)*y2 + view%g(l, 3, j, 2)*y3 &
                                      + turning(l, j, 2)*dji)
            end do
         end do
         ! g_1.(d x g_2) = -d.(g_1 x g_2)
         x1 = factor*p*view%fold(l, 1)
         ii(l, 1, 2) = ii(l, 1, 2) + x1
         ii(l, 2, 1) = ii(l, 2, 1) - x1
         x1 = factor*p*view%fold(l, 2)
         jj(l, 1, 2) = jj(l, 1, 2) - x1
         jj(l, 2, 1) = jj(l, 2, 1) + x1
      end do
   end subroutine torque_pieces

   !> Adds a part of the slopes' matrices to blocks, `other` being their counterparts beyond the diagonal.
   pure subroutine add_part(part, matrix, other, block)
      integer, intent(in) :: part
      real(wp), intent(in) :: matrix(lanes, 2, 2), other(lanes, 2, 2)
      real(wp), intent(inout) :: block(lanes, 6, 6)
      real(wp) :: plain, turned
      integer :: j, k, l
      plain = merge(1.0_wp, 0.5_wp, part == part_all)
      turned = 1.0_wp - plain
      if (part == part_rest) turned = -turned
      do k = 1, 2
         do j = 1, 2
            do l = 1, lanes
               block(l, 4 + j, 4 + k) = block(l, 4 + j, 4 + k) + (plain*matrix(l, j, k) + turned*other(l, k, j))
            end do
         end do
      end do
   end subroutine add_part
end module dg_beam_blocks
