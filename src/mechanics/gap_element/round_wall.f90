!> Moves of a string on a round wall.
!>
!> A node on the wall that moves around the hole has to turn about the hole axis. Along the tangent it would end in the wall,
!> by the square of the move over twice the clearance. To first order a turn is the straight move.
module dg_round_wall
   use dg_kinds, only: wp
   implicit none
   private
   public :: round_move, turned_part

   !> Offset over clearance up to which a node moves straight, and above which it turns [-].
   real(wp), parameter :: straight_within = 0.15_wp, turned_beyond = 0.45_wp
   !> Growth of that part of a move that is a turn, along the string [1/m]. A motor's bend may cross the hole axis within
   !> decimetres. A turn on one side of it only would bend its short elements with meganewtons.
   real(wp), parameter :: growth = 0.2_wp

contains

   !> Move a node across the hole, in part as a turn about the hole axis. With f the offset, m the move, along = f.m/f^2,
   !> whole = (f x m)/f^2 and J f the offset turned by a quarter, m = along f + whole J f. The part `turn` of the angle `whole` is
   !> a turn T, the rest is straight: the node ends at T (1 + along) f + (whole - turn) J f. The slope is the derivative of
   !> that place along the string.
   pure subroutine round_move(part, offset, move, change, moved, slope)
      real(wp), intent(in) :: part(2)         !< of the angle that is a turn, and its derivative along the string [-, 1/m]
      real(wp), intent(in) :: offset(2)       !< of the node from the hole axis [m]
      real(wp), intent(in) :: move(2)         !< across the hole [m]
      real(wp), intent(in) :: change(2)       !< of the slope [-]
      real(wp), intent(out) :: moved(2)       !< offset at the end less that at the start [m]
      real(wp), intent(inout) :: slope(2)     !< against the hole axis [-]
      real(wp) :: square, grows, along, whole, turn, along_by_s, whole_by_s, turn_by_s, place(2)
      moved = move
      if (.not. part(1) > 0.0_wp) then
         slope = slope + change
         return
      end if
      square = dot_product(offset, offset)
      grows = 2.0_wp*dot_product(offset, slope)/square
      along = dot_product(offset, move)/square
      whole = dot_product(quarter(offset), move)/square
      turn = part(1)*whole
      along_by_s = (dot_product(slope, move) + dot_product(offset, change))/square - grows*along
      whole_by_s = (dot_product(quarter(slope), move) + dot_product(quarter(offset), change))/square - grows*whole
      turn_by_s = part(2)*whole + part(1)*whole_by_s
      place = turned((1.0_wp + along)*offset, turn)
      moved = place - offset + (whole - turn)*quarter(offset)
      slope = turned((1.0_wp + along)*slope + along_by_s*offset, turn) + turn_by_s*quarter(place) &
              + (whole_by_s - turn_by_s)*quarter(offset) + (whole - turn)*quarter(slope)
   end subroutine round_move

   !> Part of the nodes' moves that is a turn, and its derivative along the string (2,nodes) [-, 1/m]. It is 0 near the axis and
   !> 1 near the wall, and changes smoothly along the string.
   pure function turned_part(offset, clearance, length) result(part)
      real(wp), intent(in) :: offset(:, :)    !< of the nodes from the hole axis (2,nodes) [m]
      real(wp), intent(in) :: clearance(:)    !< of the elements [m]
      real(wp), intent(in) :: length(:)       !< of the elements [m]
      real(wp) :: part(2, size(length) + 1)
      integer :: n, elements
      elements = size(length)
      do n = 1, elements + 1
         part(1, n) = norm2(offset(:, n))/minval(clearance(max(1, n - 1):min(n, elements)))
         part(1, n) = max(0.0_wp, (part(1, n) - straight_within)/(turned_beyond - straight_within))
      end do
      do n = 1, elements
         part(1, n + 1) = min(part(1, n + 1), part(1, n) + growth*length(n))
      end do
      do n = elements, 1, -1
         part(1, n) = min(part(1, n), part(1, n + 1) + growth*length(n))
      end do
      part(1, :) = smooth_step(part(1, :))
      part(2, :) = 0.0_wp
      do n = 2, elements
         part(2, n) = (part(1, n + 1) - part(1, n - 1))/(length(n - 1) + length(n))
      end do
   end function turned_part

   !> Vector turned by a quarter.
   pure function quarter(a) result(b)
      real(wp), intent(in) :: a(2)
      real(wp) :: b(2)
      b = [-a(2), a(1)]
   end function quarter

   !> Vector turned by an angle [rad].
   pure function turned(a, angle) result(b)
      real(wp), intent(in) :: a(2), angle
      real(wp) :: b(2)
      b = cos(angle)*a + sin(angle)*quarter(a)
   end function turned

   !> Step from 0 at 0 to 1 at 1 with two continuous derivatives.
   elemental function smooth_step(x) result(y)
      real(wp), intent(in) :: x
      real(wp) :: y, t
      t = min(max(x, 0.0_wp), 1.0_wp)
      y = t**3*(10.0_wp + t*(6.0_wp*t - 15.0_wp))
   end function smooth_step
end module dg_round_wall
