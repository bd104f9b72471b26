!> Search for the depth from which something is not possible any more: where a function of depth first falls below 0. It is < 0 at
!> the bottom. The search tries depths from the top down, then looks between two of them (dg_bracket). A string on its way passes
!> all depths, so a depth farther down that is possible again does not count. Depths above the first that is possible do not
!> count either: a short string has no weight for its bit.
!>
!> The caller computes the values:
!>     search = new_depth_search(bottom, tolerance)
!>     do while (search%goes_on)
!>        depth = next_depth(search)
!>        call take_value(search, depth, value at depth)
!>     end do
!> The result is search%greatest.
module dg_depth_search
   use dg_kinds, only: wp
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   implicit none
   private
   public :: depth_search_type, new_depth_search, next_depth, take_value

   !> Number of depths from the top down.
   integer, parameter :: depths = 50

   type :: depth_search_type
      real(wp) :: greatest = 0.0_wp       !< last depth that is possible; 0: none of those that were tried [m]
      logical :: goes_on = .true.
      real(wp), private :: bottom = 0.0_wp, tolerance = 0.0_wp   !< [m]
      real(wp), private :: above = -1.0_wp                       !< value at the depth above the next one
      integer, private :: next = 1                               !< next depth from the top down; 0: between two of them
      type(bracket_type), private :: bracket
   end type depth_search_type

contains

   !> From the bottom, where the value is < 0, and the accuracy of the result.
   pure function new_depth_search(bottom, tolerance) result(search)
      real(wp), intent(in) :: bottom      !< [m]
      real(wp), intent(in) :: tolerance   !< [m]
      type(depth_search_type) :: search
      search%bottom = bottom
      search%tolerance = tolerance
   end function new_depth_search

   !> Depth whose value is needed next [m].
   pure function next_depth(search) result(depth)
      type(depth_search_type), intent(in) :: search
      real(wp) :: depth
      if (search%next > 0) then
         depth = depth_of(search, search%next)
      else
         depth = next_try(search%bracket, search%tolerance)
      end if
   end function next_depth

   !> Take the value at the next depth.
   pure subroutine take_value(search, depth, value)
      type(depth_search_type), intent(inout) :: search
      real(wp), intent(in) :: depth       !< [m]
      real(wp), intent(in) :: value
      if (search%next == 0) then
         call narrow(search%bracket, depth, value)
      else if (search%above >= 0.0_wp .and. value < 0.0_wp) then
         search%bracket = new_bracket(depth_of(search, search%next - 1), search%above, depth, value)
         search%next = 0
      else
         search%above = value
         search%next = search%next + 1
         search%goes_on = search%next <= depths
         return
      end if
      search%greatest = search%bracket%low
      search%goes_on = .not. is_narrow(search%bracket, search%tolerance)
   end subroutine take_value

   !> One of the depths from the top down [m].
   pure function depth_of(search, number) result(depth)
      type(depth_search_type), intent(in) :: search
      integer, intent(in) :: number       !< `depths`: the bottom
      real(wp) :: depth
      depth = search%bottom*(real(number, wp)/real(depths, wp))
   end function depth_of
end module dg_depth_search
