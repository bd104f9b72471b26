!> Centralizers keep a component off the wall at places along it. A rigid one touches at its diameter. A bow spring presses
!> as an elastic gap does, from where its bows reach the wall until the body itself touches.
module dg_centralizer
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: centralizer_type, contact_length, bow_stiffness, bow_opening, at_centralizer, centralizer_ends

   !> Length of string at which a centralizer touches [m]. It acts at the middle, as at a point. With elements of 0.2 m,
   !> round-off in the places of nodes leaves lateral forces of a millinewton.
   real(wp), parameter :: contact_length = 0.5_wp
   !> Offset of a body over the clearance at a standoff of 67 %, for which API 10D states a restoring force [-].
   real(wp), parameter :: rated_offset = 0.33_wp
   !> Offset at which a bow that fills its hole begins to press [m]. A gap only has a direction if the string is off the axis.
   real(wp), parameter :: least_opening = 1.0e-6_wp

   !> The centralizers of one component, all alike.
   type :: centralizer_type
      logical :: present = .false.
      logical :: bow = .false.                 !< a bow spring, else rigid
      real(wp) :: od = 0.0_wp                  !< of blades, or of unloaded bows [m]
      real(wp) :: spacing = 0.0_wp             !< from one to the next [m]
      real(wp) :: first = 0.0_wp               !< of the lowest above the lower end of its component [m]
      real(wp) :: restoring_force = 0.0_wp     !< of a bow at 67 % standoff [N]
      real(wp) :: rated_hole = 0.0_wp          !< diameter of the hole for which that is [m]
      real(wp) :: running_force = 0.0_wp       !< drag of one bow in a hole narrower than it [N]
      real(wp) :: friction_axial = missing     !< mu2 where it touches [-]; missing: that of the component
      real(wp) :: friction_rotary = missing    !< mu1 where it touches [-]; missing: that of the component
   end type centralizer_type

contains

   !> Force of a bow per length that it is pressed in [N/m], by its rating, for a body of that diameter.
   elemental function bow_stiffness(centralizer, od) result(stiffness)
      type(centralizer_type), intent(in) :: centralizer
      real(wp), intent(in) :: od           !< of the body [m]
      real(wp) :: stiffness
      stiffness = centralizer%restoring_force/(rated_offset*0.5_wp*(centralizer%rated_hole - od))
   end function bow_stiffness

   !> Offset of the body at which a bow begins to press [m]; almost 0 in a hole that its bows fill.
   elemental function bow_opening(centralizer, hole) result(opening)
      type(centralizer_type), intent(in) :: centralizer
      real(wp), intent(in) :: hole         !< its diameter [m]
      real(wp) :: opening
      opening = max(0.5_wp*(hole - centralizer%od), least_opening)
   end function bow_opening

   !> True if a place, by its distance above the lower end of its component [m], is at a centralizer.
   pure function at_centralizer(centralizer, distance) result(at)
      type(centralizer_type), intent(in) :: centralizer
      real(wp), intent(in) :: distance
      logical :: at
      real(wp) :: beyond
      at = .false.
      if (.not. centralizer%present) return
      beyond = distance - centralizer%first
      at = abs(beyond - centralizer%spacing*max(anint(beyond/centralizer%spacing), 0.0_wp)) &
           <= 0.5_wp*contact_length
   end function at_centralizer

   !> Ends of the contacts of a component's centralizers, as distances above its lower end [m].
   pure function centralizer_ends(centralizer, length) result(ends)
      type(centralizer_type), intent(in) :: centralizer
      real(wp), intent(in) :: length       !< of the component in the hole [m]
      real(wp), allocatable :: ends(:)
      real(wp) :: centre
      integer :: k, n
      n = 0
      if (centralizer%present .and. length > centralizer%first) n = int((length - centralizer%first)/centralizer%spacing) + 1
      allocate (ends(2*n))
      do k = 1, n
         centre = centralizer%first + (k - 1)*centralizer%spacing
         ends(2*k - 1:2*k) = min(max(centre + 0.5_wp*contact_length*[-1.0_wp, 1.0_wp], 0.0_wp), length)
      end do
   end function centralizer_ends
end module dg_centralizer
