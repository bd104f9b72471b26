!> A Newton step of a folded bending beam: its matrix is made and eliminated at once, pair by pair, from both ends to the middle.
!>
!> Blocks of 4 x 4 are solved by their quarters, without exchange of rows. Under tension the matrix is positive definite but for
!> friction and torque, whose part is small. An inexact step does no harm: dg_bending_solution judges it by the residual that it
!> leaves. No matrix is kept: what a pair leaves for the next one is all that goes on. Loops over a pair are as in dg_bending_pair.
module dg_bending_elimination
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, b => node_unknowns
   use dg_bending_element, only: add_stiffness, contact_places, wall_push_type
   use dg_bending_fold, only: folded_beam_type, keep, mirror
   use dg_bending_pair, only: beam_pair_type, mean_slope, pair, pair_push_type, pair_stiffness, skew_slope
   implicit none
   private
   public :: newton_step

   !> Rows of a pair's equations: those of its outer, then of its inner nodes.
   integer, parameter :: rows = 2*b
   !> Columns by the unknowns of the next pair, or its own, and by the load.
   integer, parameter :: sides = b + 1, load = sides

contains

   !> Solves matrix step = -residual where the wall presses so.
   pure subroutine newton_step(beam, folded, push, points, viscous, indefinite, residual, step, solved)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      type(pair_push_type), intent(in) :: push(contact_places, folded%middle - 1)      !< at the places of the elements
      type(wall_push_type), intent(in) :: points(:)         !< of tool joints
      integer, intent(in) :: viscous        !< how many times the stiffness that holds a compressed string is added
      logical, intent(in) :: indefinite     !< pivots may be negative
      !> Zero for unknowns that stay, and in the lower half of the middle node [N, N.m].
      real(wp), intent(in) :: residual(pair, b, folded%middle)
      real(wp), intent(out) :: step(pair, b, folded%middle)            !< [m, -]
      logical, intent(out) :: solved        !< .false. where a pivot vanishes, or is negative: there is no step then
      real(wp) :: x(pair, b, sides, folded%middle)          ! unknowns by those of the next pair, and by the load
      real(wp) :: left(pair, b, sides)                      ! what the pair before leaves: block and load of the outer nodes
      real(wp) :: own(pair, rows, b), next(pair, rows, sides)    ! columns of outer nodes; of inner ones, and the load
      logical :: touches
      integer :: n, middle
      middle = folded%middle
      left(:, :, :b) = 0.0_wp
      left(:, :, load) = residual(:, :, 1)
      do n = 1, middle
         if (n < middle) then
            call put_squares(folded%pairs(n), left, own, next)
            touches = max(push(1, n)%force(1), push(1, n)%force(2), push(2, n)%force(1), push(2, n)%force(2)) > 0.0_wp
            if (touches) call add_wall(folded%pairs(n), push(:, n), own, next)
            next(:, b + 1:, load) = residual(:, :, n + 1)
         else
            own(:, :b, :) = left(:, :, :b)
            own(:, b + 1:, :) = 0.0_wp
            next = 0.0_wp
         end if
         next(:, :b, load) = left(:, :, load)
         call hold(beam, folded, points, n, viscous, own)
         if (n == middle) call unite(own, next(:, :, load))
         if (.not. folded%plain(n)) call keep(folded%fixed(:, n), own, next)
         call eliminate(own, next, indefinite, x(:, :, :, n), left, solved)
         if (.not. solved) return
      end do
      step(:, :, middle) = -x(:, :, load, middle)
      do n = middle - 1, 1, -1
         call go_back(x(:, :, :, n), step(:, :, n + 1), step(:, :, n))
      end do
   end subroutine newton_step

   !> Derivatives of the elements' action by offsets and slopes of their nodes, without the wall. What couples an unknown in both
   !> directions with another is a number in each direction. By torque it is another one from the second on the first, too, and
   !> minus that from the first on the second.
   pure subroutine put_squares(both, left, own, next)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in) :: left(pair, b, b)               !< is added to what outer nodes do to themselves
      real(wp), intent(out) :: own(pair, rows, b)            !< by outer nodes
      real(wp), intent(out) :: next(pair, rows, b)           !< by inner nodes
      real(wp) :: shear, near, far, turn, twist, couple
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         shear = both%shear(l)
         near = both%outer_turn(l)
         far = both%inner_turn(l)
         turn = both%turn(l)
         twist = both%twist(l)
         couple = both%outer_couple(l)
         own(l, 1, 1) = left(l, 1, 1) + shear
         own(l, 2, 1) = left(l, 2, 1)
         own(l, 1, 2) = left(l, 1, 2)
         own(l, 2, 2) = left(l, 2, 2) + shear
         own(l, 3, 1) = left(l, 3, 1) + near
         own(l, 4, 1) = left(l, 4, 1) + turn
         own(l, 3, 2) = left(l, 3, 2) - turn
         own(l, 4, 2) = left(l, 4, 2) + near
         own(l, 1, 3) = left(l, 1, 3) + near
         own(l, 2, 3) = left(l, 2, 3) - turn
         own(l, 3, 3) = left(l, 3, 3) + couple
         own(l, 4, 3) = left(l, 4, 3) + twist
         own(l, 1, 4) = left(l, 1, 4) + turn
         own(l, 2, 4) = left(l, 2, 4) + near
         own(l, 3, 4) = left(l, 3, 4) - twist
         own(l, 4, 4) = left(l, 4, 4) + couple
         couple = both%common_couple(l)
         next(l, 1, 1) = -shear
         next(l, 2, 1) = 0.0_wp
         next(l, 3, 1) = -near
         next(l, 4, 1) = -turn
         next(l, 1, 2) = 0.0_wp
         next(l, 2, 2) = -shear
         next(l, 3, 2) = turn
         next(l, 4, 2) = -near
         next(l, 1, 3) = far
         next(l, 2, 3) = turn
         next(l, 3, 3) = couple
         next(l, 4, 3) = twist
         next(l, 1, 4) = -turn
         next(l, 2, 4) = far
         next(l, 3, 4) = -twist
         next(l, 4, 4) = couple
         own(l, 5, 1) = -shear
         own(l, 6, 1) = 0.0_wp
         own(l, 7, 1) = far
         own(l, 8, 1) = -turn
         own(l, 5, 2) = 0.0_wp
         own(l, 6, 2) = -shear
         own(l, 7, 2) = turn
         own(l, 8, 2) = far
         own(l, 5, 3) = -near
         own(l, 6, 3) = turn
         own(l, 7, 3) = couple
         own(l, 8, 3) = -twist
         own(l, 5, 4) = -turn
         own(l, 6, 4) = -near
         own(l, 7, 4) = twist
         own(l, 8, 4) = couple
         couple = both%inner_couple(l)
         next(l, 5, 1) = shear
         next(l, 6, 1) = 0.0_wp
         next(l, 7, 1) = -far
         next(l, 8, 1) = turn
         next(l, 5, 2) = 0.0_wp
         next(l, 6, 2) = shear
         next(l, 7, 2) = -turn
         next(l, 8, 2) = -far
         next(l, 5, 3) = -far
         next(l, 6, 3) = -turn
         next(l, 7, 3) = couple
         next(l, 8, 3) = -twist
         next(l, 5, 4) = turn
         next(l, 6, 4) = -far
         next(l, 7, 4) = twist
         next(l, 8, 4) = couple
      end do
   end subroutine put_squares

   !> Adds the wall: columns of both nodes by sum and difference of both places.
   pure subroutine add_wall(both, push, own, next)
      type(beam_pair_type), intent(in) :: both
      type(pair_push_type), intent(in) :: push(contact_places)
      real(wp), intent(inout), dimension(pair, 2, 4, 2, 2) :: own, next   !< (direction, shape) of row, then of column
      real(wp), dimension(pair, 2, 2, 4) :: mean, swing      ! half the sum, and the difference
      real(wp) :: m, s, p, r
      integer :: l, i
      call pair_stiffness(both, push, mean, swing)
      do i = 1, 4
         !GCC$ unroll 1
         do l = 1, pair
            m = mean(l, 1, 1, i)
            s = swing(l, 1, 1, i)
            p = mean_slope*both%length(l)*m
            r = skew_slope*both%length(l)*s
            own(l, 1, i, 1, 1) = own(l, 1, i, 1, 1) + (m + s)
            own(l, 1, i, 1, 2) = own(l, 1, i, 1, 2) + (r + p)
            next(l, 1, i, 1, 1) = next(l, 1, i, 1, 1) + (m - s)
            next(l, 1, i, 1, 2) = next(l, 1, i, 1, 2) + (r - p)
            m = mean(l, 2, 1, i)
            s = swing(l, 2, 1, i)
            p = mean_slope*both%length(l)*m
            r = skew_slope*both%length(l)*s
            own(l, 2, i, 1, 1) = own(l, 2, i, 1, 1) + (m + s)
            own(l, 2, i, 1, 2) = own(l, 2, i, 1, 2) + (r + p)
            next(l, 2, i, 1, 1) = next(l, 2, i, 1, 1) + (m - s)
            next(l, 2, i, 1, 2) = next(l, 2, i, 1, 2) + (r - p)
            m = mean(l, 1, 2, i)
            s = swing(l, 1, 2, i)
            p = mean_slope*both%length(l)*m
            r = skew_slope*both%length(l)*s
            own(l, 1, i, 2, 1) = own(l, 1, i, 2, 1) + (m + s)
            own(l, 1, i, 2, 2) = own(l, 1, i, 2, 2) + (r + p)
            next(l, 1, i, 2, 1) = next(l, 1, i, 2, 1) + (m - s)
            next(l, 1, i, 2, 2) = next(l, 1, i, 2, 2) + (r - p)
            m = mean(l, 2, 2, i)
            s = swing(l, 2, 2, i)
            p = mean_slope*both%length(l)*m
            r = skew_slope*both%length(l)*s
            own(l, 2, i, 2, 1) = own(l, 2, i, 2, 1) + (m + s)
            own(l, 2, i, 2, 2) = own(l, 2, i, 2, 2) + (r + p)
            next(l, 2, i, 2, 1) = next(l, 2, i, 2, 1) + (m - s)
            next(l, 2, i, 2, 2) = next(l, 2, i, 2, 2) + (r - p)
         end do
      end do
   end subroutine add_wall

   !> Adds to the nodes' own blocks what holds a compressed string, and the wall that presses at tool joints.
   pure subroutine hold(beam, folded, points, n, viscous, own)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      type(wall_push_type), intent(in) :: points(:)
      integer, intent(in) :: n, viscous
      real(wp), intent(inout) :: own(pair, rows, b)
      integer :: half, p, e
      if (viscous > 0) then
         own(:, 1, 1) = own(:, 1, 1) + viscous*folded%viscous(:, n)
         own(:, 2, 2) = own(:, 2, 2) + viscous*folded%viscous(:, n)
      end if
      if (folded%plain(n)) return
      do half = 1, pair
         p = folded%point(half, n)
         if (p == 0) cycle
         if (.not. points(p)%force > 0.0_wp) cycle
         e = min(beam%point(p), size(beam%ei))
         call add_stiffness(points(p), merge(1, -1, half == 1)*beam%element(e)%lever, beam%element(e)%around, &
                            own(half, :b, :))
      end do
   end subroutine hold

   !> The middle node's block and load are the sums of both halves', seen from each.
   pure subroutine unite(own, load)
      real(wp), intent(inout) :: own(pair, rows, b), load(pair, rows)
      integer :: j
      do j = 1, b
         own(1, :b, j) = own(1, :b, j) + mirror*mirror(j)*own(2, :b, j)
         own(2, :b, j) = mirror*mirror(j)*own(1, :b, j)
      end do
      load(1, :b) = load(1, :b) + mirror*load(2, :b)
      load(2, :b) = mirror*load(1, :b)
   end subroutine unite

   !> Solves the equations of a pair for its unknowns, first for the offsets, then for the slopes, and takes these unknowns out of
   !> the equations of the next pair.
   pure subroutine eliminate(own, next, indefinite, x, left, solved)
      real(wp), intent(in) :: own(pair, rows, b)         !< columns of the unknowns
      real(wp), intent(in) :: next(pair, rows, sides)    !< columns of the next pair's unknowns, and the load
      logical, intent(in) :: indefinite                  !< pivots may be negative
      real(wp), intent(out) :: x(pair, b, sides)         !< the unknowns by those of the next pair, and by the load
      real(wp), intent(out) :: left(pair, b, sides)      !< block and load of the next pair
      logical, intent(out) :: solved
      real(wp), dimension(pair, 2) :: pivot, determinant
      real(wp), dimension(pair) :: f11, f21, f12, f22, d11, d21, d12, d22, h11, h21, h12, h22, g11, g21, g12, g22
      real(wp) :: share, r11, r21, r12, r22, x1, x2, x3, x4, y1, y2
      integer :: l, j
      !GCC$ unroll 1
      do l = 1, pair
         pivot(l, 1) = own(l, 1, 1)
         determinant(l, 1) = own(l, 1, 1)*own(l, 2, 2) - own(l, 1, 2)*own(l, 2, 1)
         share = 1.0_wp/determinant(l, 1)
         f11(l) = own(l, 2, 2)*share
         f21(l) = -own(l, 2, 1)*share
         f12(l) = -own(l, 1, 2)*share
         f22(l) = own(l, 1, 1)*share
         d11(l) = own(l, 3, 1)
         d21(l) = own(l, 4, 1)
         d12(l) = own(l, 3, 2)
         d22(l) = own(l, 4, 2)
         h11(l) = f11(l)*own(l, 1, 3) + f12(l)*own(l, 2, 3)
         h21(l) = f21(l)*own(l, 1, 3) + f22(l)*own(l, 2, 3)
         h12(l) = f11(l)*own(l, 1, 4) + f12(l)*own(l, 2, 4)
         h22(l) = f21(l)*own(l, 1, 4) + f22(l)*own(l, 2, 4)
         r11 = own(l, 3, 3) - (d11(l)*h11(l) + d12(l)*h21(l))
         r21 = own(l, 4, 3) - (d21(l)*h11(l) + d22(l)*h21(l))
         r12 = own(l, 3, 4) - (d11(l)*h12(l) + d12(l)*h22(l))
         r22 = own(l, 4, 4) - (d21(l)*h12(l) + d22(l)*h22(l))
         pivot(l, 2) = r11
         determinant(l, 2) = r11*r22 - r12*r21
         share = 1.0_wp/determinant(l, 2)
         g11(l) = r22*share
         g21(l) = -r21*share
         g12(l) = -r12*share
         g22(l) = r11*share
      end do
      if (indefinite) then
         solved = minval(abs(determinant)) > tiny(1.0_wp)
      else
         solved = min(determinant(1, 1), determinant(2, 1), determinant(1, 2), determinant(2, 2)) > tiny(1.0_wp) &
                  .and. min(pivot(1, 1), pivot(2, 1), pivot(1, 2), pivot(2, 2)) > 0.0_wp
      end if
      if (.not. solved) return
      do j = 1, sides
         !GCC$ unroll 1
         do l = 1, pair
            y1 = next(l, 1, j)
            y2 = next(l, 2, j)
            x1 = f11(l)*y1 + f12(l)*y2
            x2 = f21(l)*y1 + f22(l)*y2
            y1 = next(l, 3, j) - (d11(l)*x1 + d12(l)*x2)
            y2 = next(l, 4, j) - (d21(l)*x1 + d22(l)*x2)
            x3 = g11(l)*y1 + g12(l)*y2
            x4 = g21(l)*y1 + g22(l)*y2
            x1 = x1 - (h11(l)*x3 + h12(l)*x4)
            x2 = x2 - (h21(l)*x3 + h22(l)*x4)
            x(l, 1, j) = x1
            x(l, 2, j) = x2
            x(l, 3, j) = x3
            x(l, 4, j) = x4
            left(l, 1, j) = next(l, 5, j) - (own(l, 5, 1)*x1 + own(l, 5, 2)*x2 + own(l, 5, 3)*x3 + own(l, 5, 4)*x4)
            left(l, 2, j) = next(l, 6, j) - (own(l, 6, 1)*x1 + own(l, 6, 2)*x2 + own(l, 6, 3)*x3 + own(l, 6, 4)*x4)
            left(l, 3, j) = next(l, 7, j) - (own(l, 7, 1)*x1 + own(l, 7, 2)*x2 + own(l, 7, 3)*x3 + own(l, 7, 4)*x4)
            left(l, 4, j) = next(l, 8, j) - (own(l, 8, 1)*x1 + own(l, 8, 2)*x2 + own(l, 8, 3)*x3 + own(l, 8, 4)*x4)
         end do
      end do
   end subroutine eliminate

   !> The step of a pair by that of the next one.
   pure subroutine go_back(x, next, step)
      real(wp), intent(in) :: x(pair, b, sides), next(pair, b)
      real(wp), intent(out) :: step(pair, b)
      real(wp) :: y1, y2, y3, y4
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         y1 = next(l, 1)
         y2 = next(l, 2)
         y3 = next(l, 3)
         y4 = next(l, 4)
         step(l, 1) = -(x(l, 1, load) + x(l, 1, 1)*y1 + x(l, 1, 2)*y2 + x(l, 1, 3)*y3 + x(l, 1, 4)*y4)
         step(l, 2) = -(x(l, 2, load) + x(l, 2, 1)*y1 + x(l, 2, 2)*y2 + x(l, 2, 3)*y3 + x(l, 2, 4)*y4)
         step(l, 3) = -(x(l, 3, load) + x(l, 3, 1)*y1 + x(l, 3, 2)*y2 + x(l, 3, 3)*y3 + x(l, 3, 4)*y4)
         step(l, 4) = -(x(l, 4, load) + x(l, 4, 1)*y1 + x(l, 4, 2)*y2 + x(l, 4, 3)*y3 + x(l, 4, 4)*y4)
      end do
   end subroutine go_back
end module dg_bending_elimination
