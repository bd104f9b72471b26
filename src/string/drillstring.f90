!> A drillstring: named components in order from the bit upwards.
module dg_drillstring
   use dg_kinds, only: wp
   use dg_component, only: component_type
   implicit none
   private
   public :: drillstring_type, component_at, component_tops

   type :: drillstring_type
      character(:), allocatable :: name
      type(component_type), allocatable :: components(:) !< from the bit upwards
   end type drillstring_type

contains

   !> Distance of each component's upper end from the bit [m]; the last one ends at `length`, the depth of
   !> the bit. Components that lie above the surface (string longer than the hole) get tops at `length`.
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
      integer :: index
      do index = 1, size(tops) - 1
         if (distance < tops(index)) return
      end do
      index = size(tops)
   end function component_at
end module dg_drillstring
