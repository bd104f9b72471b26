!> Dogleg of a stiff bent assembly that touches its hole at three points: the circle through them.
!>
!> Karlsson, Brassfield & Krueger 1985 (SPE 13474): bit, first and second contact. Heights above the bit are a and b, and the
!> bend of angle t is at c <= b. Backwards from the bit the hole rises by k s^2/2 above its tangent there, the tool by t
!> (s - c) above the bend. The tool is off the hole axis by half the clearances there, e_1 away from the tool face and e_2
!> towards it. Eccentric blades towards the tool face add to e_1 and take from e_2.
!>
!>   k = 2 (t (b - c) - t max(a - c, 0) b/a - e_1 b/a - e_2)/(b (b - a)),
!>
!> with tight contacts and c = a the usual 2 t/b. It leaves out stiffness and weight. A stiff string that must also hold its bit
!> without side force drills a sharper hole.
module dg_three_points
   use dg_kinds, only: wp
   use dg_component, only: contact_diameter, has_bend, has_blades
   use dg_drillstring, only: component_tops, drillstring_type
   use dg_missing, only: missing
   implicit none
   private
   public :: three_point_dogleg

contains

   !> Dogleg by three points of a string [1/m]; missing where it has no bend. First contact is the blade next below the bend, or the
   !> bent housing itself. Second contact is the next blade above, or the upper end of the housing.
   pure function three_point_dogleg(string, bit_depth, diameter) result(dogleg)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit_depth   !< [m]
      real(wp), intent(in) :: diameter    !< of the hole [m]
      real(wp) :: dogleg
      real(wp) :: tops(size(string%components)), heights(2), rooms(2), bend, middle, room, below, towards
      integer :: i, bent
      dogleg = missing
      bent = findloc(has_bend(string%components), .true., dim=1)
      if (bent == 0) return
      tops = component_tops(string, bit_depth)
      below = 0.0_wp
      if (bent > 1) below = tops(bent - 1)
      bend = below + string%components(bent)%bend_position
      room = 0.5_wp*(diameter - contact_diameter(string%components(bent), bit_depth - tops(bent)))
      heights = [bend, tops(bent)]
      rooms = room
      below = 0.0_wp
      do i = 1, size(tops)
         middle = 0.5_wp*(below + tops(i))
         below = tops(i)
         if (.not. has_blades(string%components(i))) cycle
         room = 0.5_wp*(diameter - contact_diameter(string%components(i), bit_depth - tops(i)))
         towards = string%components(i)%blade_offset*cos(string%components(i)%blade_clock)
         if (middle <= bend .or. i == bent) then
            heights(1) = middle
            rooms(1) = room + towards
         else
            heights(2) = middle
            rooms(2) = room - towards
            exit
         end if
      end do
      if (heights(1) > 0.0_wp .and. heights(2) > heights(1)) &
         dogleg = max(dogleg_of_points(string%components(bent)%bend, bend, heights, rooms), 0.0_wp)
   end function three_point_dogleg

   !> Curvature of the circle through bit and two contacts [1/m].
   pure function dogleg_of_points(angle, bend, heights, rooms) result(dogleg)
      real(wp), intent(in) :: angle        !< t [rad]
      real(wp), intent(in) :: bend         !< c [m]
      real(wp), intent(in) :: heights(2)   !< a, b [m]
      real(wp), intent(in) :: rooms(2)     !< e_1, e_2 [m]
      real(wp) :: dogleg
      associate (a => heights(1), b => heights(2))
         dogleg = 2.0_wp*(angle*(b - bend) - (angle*max(a - bend, 0.0_wp) + rooms(1))*b/a - rooms(2))/(b*(b - a))
      end associate
   end function dogleg_of_points
end module dg_three_points
