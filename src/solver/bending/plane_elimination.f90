!> A Newton step of a folded bending beam that stays in a plane: what dg_bending_elimination does in space, by blocks of 2 x 2.
module dg_plane_elimination
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type
   use dg_bending_element, only: contact_places, wall_push_type
   use dg_bending_fold, only: folded_beam_type, keep
   use dg_bending_pair, only: beam_pair_type, pair, pair_push_type
   use dg_plane_bending, only: b => plane_unknowns, plane_stiffness
   implicit none
   private
   public :: plane_newton_step

   !> Rows of a pair's equations: those of its outer, then of its inner nodes.
   integer, parameter :: rows = 2*b
   !> Columns by the unknowns of the next pair, or its own, and by the load.
   integer, parameter :: sides = b + 1, load = sides

contains

   !> newton_step in the plane. Its arguments are those.
   pure subroutine plane_newton_step(beam, folded, push, points, viscous, indefinite, residual, step, solved)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      type(pair_push_type), intent(in) :: push(contact_places, folded%middle - 1)
      type(wall_push_type), intent(in) :: points(:)
      integer, intent(in) :: viscous
      logical, intent(in) :: indefinite
      real(wp), intent(in) :: residual(pair, b, folded%middle)
      real(wp), intent(out) :: step(pair, b, folded%middle)
      logical, intent(out) :: solved
      real(wp) :: x(pair, b, sides, folded%middle)          ! unknowns by those of the next pair, and by the load
      real(wp) :: left(pair, b, sides)                      ! what the pair before leaves: block and load of the outer nodes
      real(wp) :: own(pair, rows, b), next(pair, rows, sides)    ! columns of outer nodes; of inner ones, and the load
      integer :: n, middle
      middle = folded%middle
      left(:, :, :b) = 0.0_wp
      left(:, :, load) = residual(:, :, 1)
      do n = 1, middle
         if (n < middle) then
            call put_squares(folded%pairs(n), left, own, next)
            if (max(push(1, n)%force(1), push(1, n)%force(2), push(2, n)%force(1), push(2, n)%force(2)) > 0.0_wp) &
               call plane_stiffness(folded%pairs(n), push(:, n), own, next)
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
         step(:, 1, n) = -(x(:, 1, load, n) + x(:, 1, 1, n)*step(:, 1, n + 1) + x(:, 1, 2, n)*step(:, 2, n + 1))
         step(:, 2, n) = -(x(:, 2, load, n) + x(:, 2, 1, n)*step(:, 1, n + 1) + x(:, 2, 2, n)*step(:, 2, n + 1))
      end do
   end subroutine plane_newton_step

   !> Derivatives of the elements' action by offsets and slopes of their nodes, without the wall.
   pure subroutine put_squares(both, left, own, next)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in) :: left(pair, b, b)               !< is added to what outer nodes do to themselves
      real(wp), intent(out) :: own(pair, rows, b)            !< by outer nodes
      real(wp), intent(out) :: next(pair, rows, b)           !< by inner nodes
      own(:, 1, 1) = left(:, 1, 1) + both%shear
      own(:, 2, 1) = left(:, 2, 1) + both%outer_turn
      own(:, 3, 1) = -both%shear
      own(:, 4, 1) = both%inner_turn
      own(:, 1, 2) = left(:, 1, 2) + both%outer_turn
      own(:, 2, 2) = left(:, 2, 2) + both%outer_couple
      own(:, 3, 2) = -both%outer_turn
      own(:, 4, 2) = both%common_couple
      next(:, 1, 1) = -both%shear
      next(:, 2, 1) = -both%outer_turn
      next(:, 3, 1) = both%shear
      next(:, 4, 1) = -both%inner_turn
      next(:, 1, 2) = both%inner_turn
      next(:, 2, 2) = both%common_couple
      next(:, 3, 2) = -both%inner_turn
      next(:, 4, 2) = both%inner_couple
   end subroutine put_squares

   !> Adds to the nodes' own blocks what holds a compressed string, and the wall that presses at tool joints.
   pure subroutine hold(beam, folded, points, n, viscous, own)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      type(wall_push_type), intent(in) :: points(:)
      integer, intent(in) :: n, viscous
      real(wp), intent(inout) :: own(pair, rows, b)
      integer :: half, p, e
      if (viscous > 0) own(:, 1, 1) = own(:, 1, 1) + viscous*folded%viscous(:, n)
      if (folded%plain(n)) return
      do half = 1, pair
         p = folded%point(half, n)
         if (p == 0) cycle
         if (.not. points(p)%force > 0.0_wp) cycle
         e = min(beam%point(p), size(beam%ei))
         own(half, 1, 1) = own(half, 1, 1) + points(p)%stiffness
         own(half, 2, 1) = own(half, 2, 1) + merge(1, -1, half == 1)*beam%element(e)%lever*points(p)%stiffness
      end do
   end subroutine hold

   !> The middle node's block and load are the sums of both halves', seen from each: slopes have other signs there.
   pure subroutine unite(own, load)
      real(wp), intent(inout) :: own(pair, rows, b), load(pair, rows)
      own(1, 1, 1) = own(1, 1, 1) + own(2, 1, 1)
      own(1, 2, 1) = own(1, 2, 1) - own(2, 2, 1)
      own(1, 1, 2) = own(1, 1, 2) - own(2, 1, 2)
      own(1, 2, 2) = own(1, 2, 2) + own(2, 2, 2)
      load(1, 1) = load(1, 1) + load(2, 1)
      load(1, 2) = load(1, 2) - load(2, 2)
      own(2, :b, :) = own(1, :b, :)
      own(2, 2, 1) = -own(1, 2, 1)
      own(2, 1, 2) = -own(1, 1, 2)
      load(2, 1) = load(1, 1)
      load(2, 2) = -load(1, 2)
   end subroutine unite

   !> Solves the equations of a pair for its unknowns, and takes these unknowns out of the equations of the next pair.
   pure subroutine eliminate(own, next, indefinite, x, left, solved)
      real(wp), intent(in) :: own(pair, rows, b)         !< columns of the unknowns
      real(wp), intent(in) :: next(pair, rows, sides)    !< columns of the next pair's unknowns, and the load
      logical, intent(in) :: indefinite                  !< pivots may be negative
      real(wp), intent(out) :: x(pair, b, sides)         !< the unknowns by those of the next pair, and by the load
      real(wp), intent(out) :: left(pair, b, sides)      !< block and load of the next pair
      logical, intent(out) :: solved
      real(wp), dimension(pair) :: first, second, ratio, per_first, per_second
      real(wp) :: y
      integer :: l, j
      !GCC$ unroll 1
      do l = 1, pair
         first(l) = own(l, 1, 1)
      end do
      call judge(indefinite, first, solved)
      if (.not. solved) return
      !GCC$ unroll 1
      do l = 1, pair
         per_first(l) = 1.0_wp/first(l)
         ratio(l) = own(l, 2, 1)*per_first(l)
         second(l) = own(l, 2, 2) - ratio(l)*own(l, 1, 2)
      end do
      call judge(indefinite, second, solved)
      if (.not. solved) return
      per_second = 1.0_wp/second
      do j = 1, sides
         !GCC$ unroll 1
         do l = 1, pair
            y = (next(l, 2, j) - ratio(l)*next(l, 1, j))*per_second(l)
            x(l, 2, j) = y
            x(l, 1, j) = (next(l, 1, j) - own(l, 1, 2)*y)*per_first(l)
            left(l, 1, j) = next(l, 3, j) - (own(l, 3, 1)*x(l, 1, j) + own(l, 3, 2)*x(l, 2, j))
            left(l, 2, j) = next(l, 4, j) - (own(l, 4, 1)*x(l, 1, j) + own(l, 4, 2)*x(l, 2, j))
         end do
      end do
   end subroutine eliminate

   !> Whether pivots will do.
   pure subroutine judge(indefinite, pivot, good)
      logical, intent(in) :: indefinite                  !< they may be negative
      real(wp), intent(in) :: pivot(pair)
      logical, intent(out) :: good
      if (indefinite) then
         good = min(abs(pivot(1)), abs(pivot(2))) > tiny(1.0_wp)
      else
         good = min(pivot(1), pivot(2)) > tiny(1.0_wp)
      end if
   end subroutine judge
end module dg_plane_elimination
