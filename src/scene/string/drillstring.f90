!> A drillstring: named components in order from the bit upwards.
module dg_drillstring
   use dg_kinds, only: wp
   use dg_centralizer, only: centralizer_ends
   use dg_component, only: component_type, effective_joint_length, has_bend, has_joints, has_pad
   implicit none
   private
   public :: drillstring_type, component_at, component_tops, topmost, joint_ends, all_centralizer_ends, tool_ends, pad_within, &
             bend_within, at_joint, pipe_joint

   type :: drillstring_type
      character(:), allocatable :: name
      type(component_type), allocatable :: components(:) !< from the bit upwards
   end type drillstring_type

   !> Length of the piece over which a bent housing bends, or pads press [m]. It is short compared with the distances to bit
   !> and stabilizers, but longer than the distance at which depths are joined.
   real(wp), parameter :: piece_length = 0.1_wp

contains

   !> Distance of each component's upper end from the bit [m]. The last one ends at `length`, the depth of the bit. Components
   !> above the surface (string longer than the hole) get tops at `length`.
   pure function component_tops(string, length) result(tops)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: length  !< of the string in the hole: the bit's measured depth [m]
      real(wp) :: tops(size(string%components))
      integer :: i
      real(wp) :: distance
      distance = 0.0_wp
      do i = 1, size(string%components)
         distance = min(distance + string%components(i)%length, length)
         tops(i) = distance
      end do
      tops(size(tops)) = length
   end function component_tops

   !> Index of the component at a distance above the bit [m]; at a joint, the upper one.
   pure function component_at(tops, distance) result(index)
      real(wp), intent(in) :: tops(:)    !< from component_tops
      real(wp), intent(in) :: distance   !< [m]
      integer :: index, middle, high
      index = 1
      high = size(tops)
      do while (index < high)
         middle = (index + high)/2
         if (distance < tops(middle)) then
            high = middle
         else
            index = middle + 1
         end if
      end do
   end function component_at

   !> Index of the uppermost component in the hole.
   pure function topmost(tops) result(index)
      real(wp), intent(in) :: tops(:)    !< from component_tops
      integer :: index
      index = findloc(tops >= tops(size(tops)), .true., dim=1)
   end function topmost

   !> Length of a joint of pipe [m]: of the component with joints that makes most of the string. Without joints it is that of
   !> range 2.
   pure function pipe_joint(string, tops) result(joint)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)        !< from component_tops
      real(wp) :: joint
      real(wp), parameter :: usual = 9.5_wp
      real(wp) :: lengths(size(tops))
      integer :: longest
      lengths(1) = tops(1)
      lengths(2:) = tops(2:) - tops(:size(tops) - 1)
      longest = maxloc(lengths, mask=has_joints(string%components), dim=1)
      joint = usual
      if (longest > 0) joint = string%components(longest)%joint_spacing
   end function pipe_joint

   !> Ends of all tool joints, as distances above the bit [m]. Components with centralizers have none. Joints are every
   !> joint_spacing from a component's lower end, half a joint at its ends.
   pure function joint_ends(string, tops) result(ends)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)    !< from component_tops
      real(wp), allocatable :: ends(:)
      real(wp) :: bottom(size(tops)), centre, half
      integer :: joints(size(tops)), i, k, n
      bottom = [0.0_wp, tops(:size(tops) - 1)]
      joints = 0
      do i = 1, size(tops)
         if (has_joints(string%components(i)) .and. .not. string%components(i)%centralizer%present) &
            joints(i) = int((tops(i) - bottom(i))/string%components(i)%joint_spacing) + 2
      end do
      allocate (ends(2*sum(joints)))
      n = 0
      do i = 1, size(tops)
         half = 0.5_wp*effective_joint_length(string%components(i))
         do k = 0, joints(i) - 1
            centre = bottom(i) + k*string%components(i)%joint_spacing
            ends(n + 1:n + 2) = min(max([centre - half, centre + half], bottom(i)), tops(i))
            n = n + 2
         end do
      end do
   end function joint_ends

   !> Ends of the contacts of all centralizers, as distances above the bit [m].
   pure function all_centralizer_ends(string, tops) result(ends)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)    !< from component_tops
      real(wp), allocatable :: ends(:)
      real(wp) :: bottom(size(tops))
      integer :: after(size(tops) + 1), i
      bottom = [0.0_wp, tops(:size(tops) - 1)]
      after(1) = 0
      do i = 1, size(tops)
         after(i + 1) = after(i) + size(centralizer_ends(string%components(i)%centralizer, tops(i) - bottom(i)))
      end do
      allocate (ends(after(size(after))))
      do i = 1, size(tops)
         ends(after(i) + 1:after(i + 1)) = bottom(i) + centralizer_ends(string%components(i)%centralizer, tops(i) - bottom(i))
      end do
   end function all_centralizer_ends

   !> Ends of the pieces that are bent, or pressed by pads, as distances above the bit [m].
   pure function tool_ends(string, tops) result(ends)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)    !< from component_tops
      real(wp), allocatable :: ends(:)
      integer :: i
      allocate (ends(0))
      do i = 1, size(tops)
         associate (part => string%components(i))
            if (has_bend(part)) ends = [ends, short_piece(string, tops, i, part%bend_position)]
            if (has_pad(part)) ends = [ends, short_piece(string, tops, i, part%pad_position)]
         end associate
      end do
   end function tool_ends

   !> Angle by which the string is bent between two distances above the bit [rad].
   pure function bend_within(string, tops, low, high) result(angle)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)    !< from component_tops
      real(wp), intent(in) :: low, high  !< [m]
      real(wp) :: angle
      real(wp) :: piece(2)
      integer :: i
      angle = 0.0_wp
      do i = 1, size(tops)
         if (.not. has_bend(string%components(i))) cycle
         piece = short_piece(string, tops, i, string%components(i)%bend_position)
         angle = angle + string%components(i)%bend*share_within(piece, low, high)
      end do
   end function bend_within

   !> Force of pads on the string between two distances above the bit [N], towards the high side and to the right of it.
   pure function pad_within(string, tops, low, high) result(force)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)    !< from component_tops
      real(wp), intent(in) :: low, high  !< [m]
      real(wp) :: force(2)
      integer :: i
      force = 0.0_wp
      do i = 1, size(tops)
         associate (part => string%components(i))
            if (has_pad(part)) force = force + part%pad_force*[cos(part%pad_clock), sin(part%pad_clock)]* &
                                       share_within(short_piece(string, tops, i, part%pad_position), low, high)
         end associate
      end do
   end function pad_within

   !> Part of a piece between two distances above the bit [-].
   pure function share_within(piece, low, high) result(share)
      real(wp), intent(in) :: piece(2)   !< its ends, as distances above the bit [m]
      real(wp), intent(in) :: low, high  !< [m]
      real(wp) :: share
      share = max(min(high, piece(2)) - max(low, piece(1)), 0.0_wp)/(piece(2) - piece(1))
   end function share_within

   !> Lower and upper end of the piece of a component that is bent or pressed, as distances above the bit [m].
   pure function short_piece(string, tops, part, position) result(piece)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: tops(:)
      integer, intent(in) :: part        !< number of the component
      real(wp), intent(in) :: position   !< of the middle, above the lower end of the component [m]
      real(wp) :: piece(2)
      real(wp) :: bottom
      bottom = 0.0_wp
      if (part > 1) bottom = tops(part - 1)
      piece(2) = max(position + 0.5_wp*piece_length, piece_length)
      if (string%components(part)%length > piece_length) piece(2) = min(piece(2), string%components(part)%length)
      piece = bottom + [piece(2) - piece_length, piece(2)]
   end function short_piece

   !> True if a place, by its distance above the lower end of its component [m], is at a tool joint.
   pure function at_joint(component, distance) result(at)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: distance
      logical :: at
      at = has_joints(component) .and. abs(distance - component%joint_spacing*anint(distance/component%joint_spacing)) &
           <= 0.5_wp*effective_joint_length(component)
   end function at_joint
end module dg_drillstring
