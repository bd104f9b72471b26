!> Moves of a string on a round wall.
!>
!> A node on the wall that moves around the hole has to turn about the hole axis. Along the tangent it would end in the wall,
!> by the square of the move over twice the clearance. To first order a turn is the straight move.
module dg_round_wall
   use dg_kinds, only: wp
   implicit none
   private
   public :: round_move, smooth_room

   !> Offset over clearance up to which a node moves straight, and above which it turns [-].
   real(wp), parameter :: straight_within = 0.15_wp, turned_beyond = 0.45_wp
   !> Growth of the smoothed clearance along the string [-].
   real(wp), parameter :: growth = 0.01_wp

contains

   !> Move a node across the hole, as a turn about the hole axis if it is off that axis. The part of a move that is a turn
   !> changes smoothly along the string. Otherwise the string would be bent between a neighbour that turns and one that does
   !> not.
   pure subroutine round_move(room, offset, move, change, moved, slope)
      real(wp), intent(in) :: room            !< clearance by smooth_room [m]
      real(wp), intent(in) :: offset(2)       !< of the node from the hole axis [m]
      real(wp), intent(in) :: move(2)         !< across the hole [m]
      real(wp), intent(in) :: change(2)       !< of the slope [-]
      real(wp), intent(out) :: moved(2)       !< offset at the end less that at the start [m]
      real(wp), intent(inout) :: slope(2)     !< against the hole axis [-]
      real(wp) :: square, whole, turn, along, part
      moved = move
      square = offset(1)**2 + offset(2)**2
      part = smooth_step((sqrt(square)/room - straight_within)/(turned_beyond - straight_within))
      if (part > 0.0_wp) then
         whole = (offset(1)*move(2) - offset(2)*move(1))/square
         along = (offset(1)*move(1) + offset(2)*move(2))/square
         turn = part*whole
         moved = turned((1.0_wp + along)*offset, turn) - offset + (whole - turn)*[-offset(2), offset(1)]
         slope = turned(slope + change - turn*[-slope(2), slope(1)], turn)
      else
         slope = slope + change
      end if
   end subroutine round_move

   !> Vector turned by an angle [rad].
   pure function turned(a, angle) result(b)
      real(wp), intent(in) :: a(2), angle
      real(wp) :: b(2)
      b = [cos(angle)*a(1) - sin(angle)*a(2), sin(angle)*a(1) + cos(angle)*a(2)]
   end function turned

   !> Step from 0 at 0 to 1 at 1 with two continuous derivatives.
   pure function smooth_step(x) result(y)
      real(wp), intent(in) :: x
      real(wp) :: y, t
      t = min(max(x, 0.0_wp), 1.0_wp)
      y = t**3*(10.0_wp + t*(6.0_wp*t - 15.0_wp))
   end function smooth_step

   !> Clearance at the nodes, made smooth along the string [m]. It is at most the clearance of the elements beside a node, and
   !> grows by at most `growth` per metre.
   pure function smooth_room(length, clearance) result(room)
      real(wp), intent(in) :: length(:)          !< of the elements [m]
      real(wp), intent(in) :: clearance(:)       !< of the elements [m]
      real(wp) :: room(size(length) + 1)
      integer :: n, elements
      elements = size(length)
      room(1) = clearance(1)
      do n = 1, elements
         room(n + 1) = min(minval(clearance(n:min(n + 1, elements))), room(n) + growth*length(n))
      end do
      do n = elements, 1, -1
         room(n) = min(room(n), room(n + 1) + growth*length(n))
      end do
   end function smooth_room
end module dg_round_wall
