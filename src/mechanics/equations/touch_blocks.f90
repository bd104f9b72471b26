!> What gaps that touch take off the blocks of their elements, several side by side.
module dg_touch_blocks
   use dg_kinds, only: wp
   use dg_beam_blocks, only: block_ii, block_jj, view_type
   use dg_gap_contact, only: couple_tangents, moment_tangents, touch_tangent_type, touch_tangents, touch_type
   use dg_gap_element, only: gap_derivative_type, gap_derivatives
   use dg_lanes, only: lanes
   implicit none
   private
   public :: take_touch

contains

   !> Takes the derivatives of the gaps' forces on their nodes off the elements' blocks.
   pure subroutine take_touch(frame, view, touch, blocks)
      real(wp), intent(in) :: frame(lanes + 1, 3, 3)     !< of the nodes
      type(view_type), intent(in) :: view
      type(touch_type), intent(inout) :: touch           !< in space axes; afterwards as seen in `view`
      real(wp), intent(inout) :: blocks(lanes, 6, 6, 4)
      type(touch_tangent_type) :: at_point
      type(gap_derivative_type) :: by
      real(wp) :: point(lanes, 3, 6, 2), direction(lanes, 3, 6, 2)
      integer :: p
      call turn(frame, touch%gap)
      call turn(frame, touch%tangent)
      call turn(frame, touch%curvature)
      call turn(frame, touch%direction)
      call touch_tangents(touch, at_point)
      if (touch%slides) call couple_tangents(touch, at_point)
      if (touch%rubs) call moment_tangents(touch, at_point)
      call gap_derivatives(touch, view%d, at_point, by)
      call on_unknowns(view, by%point, point)
      call on_unknowns(view, by%direction, direction)
      if (touch%rubs) then
         do p = 1, 2
            point(:, :, 4, p) = by%twisting_by_point(:, :, p)
            direction(:, :, 4, p) = by%twisting_by_direction(:, :, p)
         end do
         call take_twist(touch%share(:, 1), by%twist, view, 1, blocks(:, :, :, block_ii))
         call take_twist(touch%share(:, 2), by%twist, view, 2, blocks(:, :, :, block_jj))
      end if
      call take_both(point, direction, touch, view, blocks)
   end subroutine take_touch

   !> Vectors in space axes as seen from the upper nodes.
   pure subroutine turn(frame, vector)
      real(wp), intent(in) :: frame(lanes + 1, 3, 3)
      real(wp), intent(inout) :: vector(lanes, 3)
      real(wp) :: x, y, z
      integer :: l
      do l = 1, lanes
         x = vector(l, 1)
         y = vector(l, 2)
         z = vector(l, 3)
         vector(l, 1) = frame(l, 1, 1)*x + frame(l, 2, 1)*y + frame(l, 3, 1)*z
         vector(l, 2) = frame(l, 1, 2)*x + frame(l, 2, 2)*y + frame(l, 3, 2)*z
         vector(l, 3) = frame(l, 1, 3)*x + frame(l, 2, 3)*y + frame(l, 3, 3)*z
      end do
   end subroutine turn

   !> Columns of forces on (x_i, d_i, x_j, d_j) as rows of both nodes' unknowns; none on the twist.
   pure subroutine on_unknowns(view, forces, rows)
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: forces(lanes, 3, 3, 4)
      real(wp), intent(out) :: rows(lanes, 3, 6, 2)
      integer :: j, l
      do j = 1, 3
         do l = 1, lanes
            rows(l, j, 1, 1) = forces(l, 1, j, 1)
            rows(l, j, 2, 1) = forces(l, 2, j, 1)
            rows(l, j, 3, 1) = forces(l, 3, j, 1)
            rows(l, j, 4, 1) = 0.0_wp
            rows(l, j, 5, 1) = view%g(l, 1, 1, 1)*forces(l, 1, j, 2) + view%g(l, 2, 1, 1)*forces(l, 2, j, 2) &
                               + view%g(l, 3, 1, 1)*forces(l, 3, j, 2)
            rows(l, j, 6, 1) = view%g(l, 1, 2, 1)*forces(l, 1, j, 2) + view%g(l, 2, 2, 1)*forces(l, 2, j, 2) &
                               + view%g(l, 3, 2, 1)*forces(l, 3, j, 2)
            rows(l, j, 1, 2) = view%turn(l, 1, 1)*forces(l, 1, j, 3) + view%turn(l, 2, 1)*forces(l, 2, j, 3) &
                               + view%turn(l, 3, 1)*forces(l, 3, j, 3)
            rows(l, j, 2, 2) = view%turn(l, 1, 2)*forces(l, 1, j, 3) + view%turn(l, 2, 2)*forces(l, 2, j, 3) &
                               + view%turn(l, 3, 2)*forces(l, 3, j, 3)
            rows(l, j, 3, 2) = view%turn(l, 1, 3)*forces(l, 1, j, 3) + view%turn(l, 2, 3)*forces(l, 2, j, 3) &
                               + view%turn(l, 3, 3)*forces(l, 3, j, 3)
            rows(l, j, 4, 2) = 0.0_wp
            rows(l, j, 5, 2) = view%g(l, 1, 1, 2)*forces(l, 1, j, 4) + view%g(l, 2, 1, 2)*forces(l, 2, j, 4) &
                               + view%g(l, 3, 1, 2)*forces(l, 3, j, 4)
            rows(l, j, 6, 2) = view%g(l, 1, 2, 2)*forces(l, 1, j, 4) + view%g(l, 2, 2, 2)*forces(l, 2, j, 4) &
                               + view%g(l, 3, 2, 2)*forces(l, 3, j, 4)
         end do
      end do
   end subroutine on_unknowns

   !> Takes derivatives by r and r' off the blocks.
   pure subroutine take_both(point, direction, touch, view, blocks)
      real(wp), intent(in), dimension(lanes, 3, 6, 2) :: point, direction   !< rows of unknowns by r and by r'
      type(touch_type), intent(in) :: touch
      type(view_type), intent(in) :: view
      real(wp), intent(inout) :: blocks(lanes, 6, 6, 4)
      real(wp) :: x1, x2, x3
      integer :: i, l, p, u, v
      do p = 1, 2
         u = 2*p - 1
         v = 2*p
         do i = 1, 6
            if (i == 4 .and. .not. touch%rubs) cycle
            do l = 1, lanes
               x1 = touch%shape(l, 1)*point(l, 1, i, p) + touch%slope(l, 1)*direction(l, 1, i, p)
               x2 = touch%shape(l, 1)*point(l, 2, i, p) + touch%slope(l, 1)*direction(l, 2, i, p)
               x3 = touch%shape(l, 1)*point(l, 3, i, p) + touch%slope(l, 1)*direction(l, 3, i, p)
               blocks(l, i, 1, u) = blocks(l, i, 1, u) - x1
               blocks(l, i, 2, u) = blocks(l, i, 2, u) - x2
               blocks(l, i, 3, u) = blocks(l, i, 3, u) - x3
               ! N_3 = 1 - N_1
               x1 = point(l, 1, i, p) - x1
               x2 = point(l, 2, i, p) - x2
               x3 = point(l, 3, i, p) - x3
               blocks(l, i, 1, v) = blocks(l, i, 1, v) - (x1*view%turn(l, 1, 1) + x2*view%turn(l, 2, 1) + x3*view%turn(l, 3, 1))
               blocks(l, i, 2, v) = blocks(l, i, 2, v) - (x1*view%turn(l, 1, 2) + x2*view%turn(l, 2, 2) + x3*view%turn(l, 3, 2))
               blocks(l, i, 3, v) = blocks(l, i, 3, v) - (x1*view%turn(l, 1, 3) + x2*view%turn(l, 2, 3) + x3*view%turn(l, 3, 3))
               x1 = touch%shape(l, 2)*point(l, 1, i, p) + touch%slope(l, 2)*direction(l, 1, i, p)
               x2 = touch%shape(l, 2)*point(l, 2, i, p) + touch%slope(l, 2)*direction(l, 2, i, p)
               x3 = touch%shape(l, 2)*point(l, 3, i, p) + touch%slope(l, 2)*direction(l, 3, i, p)
               blocks(l, i, 5, u) = blocks(l, i, 5, u) - (x1*view%g(l, 1, 1, 1) + x2*view%g(l, 2, 1, 1) + x3*view%g(l, 3, 1, 1))
               blocks(l, i, 6, u) = blocks(l, i, 6, u) - (x1*view%g(l, 1, 2, 1) + x2*view%g(l, 2, 2, 1) + x3*view%g(l, 3, 2, 1))
               x1 = touch%shape(l, 4)*point(l, 1, i, p) + touch%slope(l, 4)*direction(l, 1, i, p)
               x2 = touch%shape(l, 4)*point(l, 2, i, p) + touch%slope(l, 4)*direction(l, 2, i, p)
               x3 = touch%shape(l, 4)*point(l, 3, i, p) + touch%slope(l, 4)*direction(l, 3, i, p)
               blocks(l, i, 5, v) = blocks(l, i, 5, v) - (x1*view%g(l, 1, 1, 2) + x2*view%g(l, 2, 1, 2) + x3*view%g(l, 3, 1, 2))
               blocks(l, i, 6, v) = blocks(l, i, 6, v) - (x1*view%g(l, 1, 2, 2) + x2*view%g(l, 2, 2, 2) + x3*view%g(l, 3, 2, 2))
            end do
         end do
      end do
   end subroutine take_both

   !> What the twisting part makes as it turns with a node's director.
   pure subroutine take_twist(share, twist, view, p, block)
      real(wp), intent(in) :: share(lanes), twist(lanes, 3)
      type(view_type), intent(in) :: view
      integer, intent(in) :: p                           !< the node
      real(wp), intent(inout) :: block(lanes, 6, 6)
      real(wp) :: t1, t2, t3, folded
      integer :: l
      do l = 1, lanes
         t1 = share(l)*twist(l, 1)
         t2 = share(l)*twist(l, 2)
         t3 = share(l)*twist(l, 3)
         block(l, 4, 5) = block(l, 4, 5) - (t1*view%g(l, 1, 1, p) + t2*view%g(l, 2, 1, p) + t3*view%g(l, 3, 1, p))
         block(l, 4, 6) = block(l, 4, 6) - (t1*view%g(l, 1, 2, p) + t2*view%g(l, 2, 2, p) + t3*view%g(l, 3, 2, p))
         ! twist.(g_1 x g_2), g_1 x g_2 = s**3 d
         folded = view%fold(l, p)*(t1*view%d(l, 1, p) + t2*view%d(l, 2, p) + t3*view%d(l, 3, p))
         block(l, 5, 6) = block(l, 5, 6) + folded
         block(l, 6, 5) = block(l, 6, 5) - folded
      end do
   end subroutine take_twist
end module dg_touch_blocks
