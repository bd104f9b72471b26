!> The fluids inside and outside the string, by measured depth.
!>
!> Fluids are listed from the top down. Each fills its side of the wall from its upper end down to the next fluid of that side.
!> The last one reaches down to the bit. Above the first one there is air without weight and pressure. A first fluid that
!> begins below the surface thus leaves an air gap. A fluid inside may begin at a place of the string instead of a depth. It
!> then moves with the string, like the fluid held by a float collar.
module dg_fluid
   use dg_kinds, only: wp
   implicit none
   private
   public :: fluid_type, mud_type, standing_mud, density_at, fluid_at, fluid_top, fluid_tops, fills, heaviest_fluid, &
             cut_mud, shift_mud
   public :: side_inside, side_outside, collar_none, collar_closed, collar_open_below, collar_name

   integer, parameter :: side_inside = 1
   integer, parameter :: side_outside = 2

   !> Separation of a fluid inside from the one above it.
   integer, parameter :: collar_none = 1        !< no collar: pressure goes through
   integer, parameter :: collar_closed = 2      !< a closed collar; the fluid below it begins at no pressure, as filled at surface
   integer, parameter :: collar_open_below = 3  !< a closed collar; the fluid below it has the pressure of the hole at the bit
   character(*), parameter :: collar_name(3) = [character(10) :: 'none', 'closed', 'open_below']

   type :: fluid_type
      logical :: inside = .true.         !< fills the string
      logical :: outside = .true.        !< fills the annulus
      real(wp) :: density = 0.0_wp       !< [kg/m3]
      real(wp) :: md_top = 0.0_wp        !< upper end, where above_bit is 0 [m]
      real(wp) :: above_bit = 0.0_wp     !< > 0: upper end, as distance from the bit [m]
      integer :: collar = collar_none
      real(wp) :: surface_pressure = 0.0_wp   !< of the annulus, where the fluid is the uppermost outside [Pa]
   end type fluid_type

   type :: mud_type
      type(fluid_type), allocatable :: fluids(:)   !< from the top down; not allocated: air
   end type mud_type

contains

   !> One fluid, inside and outside, from the surface down.
   pure function standing_mud(density) result(mud)
      real(wp), intent(in) :: density   !< [kg/m3]
      type(mud_type) :: mud
      allocate (mud%fluids(1))
      mud%fluids(1)%density = density
   end function standing_mud

   !> True if a fluid fills a side.
   elemental function fills(fluid, side) result(yes)
      type(fluid_type), intent(in) :: fluid
      integer, intent(in) :: side
      logical :: yes
      yes = merge(fluid%inside, fluid%outside, side == side_inside)
   end function fills

   !> Measured depth of the upper end of a fluid [m]. It is at surface if its place of the string is not in the hole yet.
   elemental function fluid_top(fluid, bit_depth) result(md)
      type(fluid_type), intent(in) :: fluid
      real(wp), intent(in) :: bit_depth   !< [m]
      real(wp) :: md
      md = fluid%md_top
      if (fluid%above_bit > 0.0_wp) md = max(bit_depth - fluid%above_bit, 0.0_wp)
   end function fluid_top

   !> Number of the fluid at a measured depth, the last one listed that begins there or above; 0 for air.
   pure function fluid_at(mud, side, md, bit_depth) result(index)
      type(mud_type), intent(in) :: mud
      integer, intent(in) :: side
      real(wp), intent(in) :: md          !< [m]
      real(wp), intent(in) :: bit_depth   !< [m]
      integer :: index
      index = 0
      if (.not. allocated(mud%fluids)) return
      do index = size(mud%fluids), 1, -1
         if (fills(mud%fluids(index), side) .and. fluid_top(mud%fluids(index), bit_depth) <= md) return
      end do
      index = 0
   end function fluid_at

   !> Density at a measured depth [kg/m3]. Where two fluids meet it is that of the lower one.
   pure function density_at(mud, side, md, bit_depth) result(density)
      type(mud_type), intent(in) :: mud
      integer, intent(in) :: side         !< side_inside or side_outside
      real(wp), intent(in) :: md          !< [m]
      real(wp), intent(in) :: bit_depth   !< [m]
      real(wp) :: density
      integer :: i
      density = 0.0_wp
      i = fluid_at(mud, side, md, bit_depth)
      if (i > 0) density = mud%fluids(i)%density
   end function density_at

   !> Depths between surface and bit at which a fluid of either side begins [m], ascending.
   pure function fluid_tops(mud, bit_depth) result(tops)
      type(mud_type), intent(in) :: mud
      real(wp), intent(in) :: bit_depth   !< [m]
      real(wp), allocatable :: tops(:)
      real(wp) :: moving
      integer :: i, j
      allocate (tops(0))
      if (.not. allocated(mud%fluids)) return
      do i = 1, size(mud%fluids)
         moving = fluid_top(mud%fluids(i), bit_depth)
         if (.not. (moving > 0.0_wp .and. moving < bit_depth)) cycle
         tops = [tops, moving]
         do j = size(tops), 2, -1
            if (tops(j - 1) <= moving) exit
            tops(j) = tops(j - 1)
            tops(j - 1) = moving
         end do
      end do
   end function fluid_tops

   !> Density of the heaviest fluid [kg/m3].
   pure function heaviest_fluid(mud) result(density)
      type(mud_type), intent(in) :: mud
      real(wp) :: density
      density = 0.0_wp
      if (.not. allocated(mud%fluids)) return
      if (size(mud%fluids) > 0) density = maxval(mud%fluids%density)
   end function heaviest_fluid

   !> Count from a new lower end of the string, `off` above the old one. Fluids that began below it are removed.
   pure subroutine cut_mud(mud, off)
      type(mud_type), intent(inout) :: mud
      real(wp), intent(in) :: off   !< > 0 [m]
      if (.not. allocated(mud%fluids)) return
      mud%fluids = pack(mud%fluids, .not. (mud%fluids%above_bit > 0.0_wp .and. mud%fluids%above_bit <= off))
      where (mud%fluids%above_bit > 0.0_wp) mud%fluids%above_bit = mud%fluids%above_bit - off
   end subroutine cut_mud

   !> Move the fluids that begin at depths down a hole [m].
   pure subroutine shift_mud(mud, by)
      type(mud_type), intent(inout) :: mud
      real(wp), intent(in) :: by   !< [m]
      if (allocated(mud%fluids)) mud%fluids%md_top = mud%fluids%md_top + by
   end subroutine shift_mud
end module dg_fluid
