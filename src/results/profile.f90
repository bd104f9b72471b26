!> Results along the string, surface to bit: one type for every model, so that tables and files need no
!> special cases. SI units; conversion happens in the report.
!>
!> Each row has one depth. Where a component, hole section or fluid changes there are two rows at that depth (see
!> dg_profile_rows). The first is for the upper side, the second for the lower side. Depths never decrease from row to row.
module dg_profile
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_named_states, only: state_elastic, state_free, state_name, state_rigid
   implicit none
   private
   public :: profile_type, new_profile, taken_rows, piece_depths, between_ends
   public :: state_free, state_elastic, state_rigid, state_name, side_none, side_above, side_below, side_name

   !> Side of a change that a row stands for; names in files.
   integer, parameter :: side_none = 0, side_above = 1, side_below = 2
   character(*), parameter :: side_name(0:2) = [character(5) :: '', 'above', 'below']

   type :: profile_type
      real(wp), allocatable :: md(:)           !< measured depth [m]
      real(wp), allocatable :: tvd(:)          !< of the hole axis, from the first station [m]
      real(wp), allocatable :: north(:)        !< of the hole axis [m]
      real(wp), allocatable :: east(:)         !< of the hole axis [m]
      real(wp), allocatable :: inclination(:)  !< of the hole axis [rad]
      real(wp), allocatable :: azimuth(:)      !< of the hole axis [rad], 0 to 2 pi
      real(wp), allocatable :: axial(:)        !< effective axial force, tension > 0 [N]
      real(wp), allocatable :: torque(:)       !< right-hand drive > 0 [N.m]
      real(wp), allocatable :: side_force(:)   !< normal contact force per metre, >= 0 [N/m]
      real(wp), allocatable :: bending(:)      !< resultant bending moment [N.m]
      real(wp), allocatable :: displacement(:) !< of the string axis off the hole axis [m]
      real(wp), allocatable :: clock(:)        !< where it lies [rad], from the high side (from north where the
                                               !< hole is vertical), clockwise looking down the hole, 0 to 2 pi
      real(wp), allocatable :: shear(:)        !< resultant shear force [N]; missing where a model has none
      integer, allocatable :: gap_state(:)     !< state_free, state_elastic, state_rigid
      integer, allocatable :: side(:)          !< side_above or side_below where two rows stand at one depth, else side_none
   end type profile_type

contains

   !> A profile of `n` rows, all zero and free, without shear force.
   pure function new_profile(n) result(profile)
      integer, intent(in) :: n
      type(profile_type) :: profile
      allocate (profile%md(n), profile%tvd(n), profile%north(n), profile%east(n), profile%inclination(n), &
                profile%azimuth(n), profile%axial(n), profile%torque(n), profile%side_force(n), profile%bending(n), &
                profile%displacement(n), profile%clock(n), source=0.0_wp)
      allocate (profile%shear(n), source=missing)
      allocate (profile%gap_state(n), source=state_free)
      allocate (profile%side(n), source=side_none)
   end function new_profile

   !> The rows of a profile with these numbers, in this order.
   pure function taken_rows(profile, rows) result(taken)
      type(profile_type), intent(in) :: profile
      integer, intent(in) :: rows(:)
      type(profile_type) :: taken
      taken = new_profile(size(rows))
      taken%md = profile%md(rows)
      taken%tvd = profile%tvd(rows)
      taken%north = profile%north(rows)
      taken%east = profile%east(rows)
      taken%inclination = profile%inclination(rows)
      taken%azimuth = profile%azimuth(rows)
      taken%axial = profile%axial(rows)
      taken%torque = profile%torque(rows)
      taken%side_force = profile%side_force(rows)
      taken%bending = profile%bending(rows)
      taken%displacement = profile%displacement(rows)
      taken%clock = profile%clock(rows)
      taken%shear = profile%shear(rows)
      taken%gap_state = profile%gap_state(rows)
      taken%side = profile%side(rows)
   end function taken_rows

   !> A depth inside the piece of string that each row stands for [m]: half way to the next row on its side. A row without a side
   !> stands for the piece below it, the last one for the piece above it.
   pure function piece_depths(profile) result(depths)
      type(profile_type), intent(in) :: profile
      real(wp) :: depths(size(profile%md))
      integer :: i, n
      n = size(profile%md)
      do i = 1, n
         if (i > 1 .and. (i == n .or. profile%side(i) == side_above)) then
            depths(i) = 0.5_wp*(profile%md(i - 1) + profile%md(i))
         else
            depths(i) = 0.5_wp*(profile%md(i) + profile%md(min(i + 1, n)))
         end if
      end do
   end function piece_depths

   !> A quantity of a row that goes in a straight line with true vertical depth from one end of the string to the other. Where both
   !> ends are level it is that of the upper end.
   pure function between_ends(profile, row, top, bottom) result(quantity)
      type(profile_type), intent(in) :: profile
      integer, intent(in) :: row
      real(wp), intent(in) :: top, bottom    !< of the ends
      real(wp) :: quantity
      real(wp) :: deep
      deep = 0.0_wp
      associate (tvd => profile%tvd)
         if (tvd(size(tvd)) > tvd(1)) deep = (tvd(row) - tvd(1))/(tvd(size(tvd)) - tvd(1))
      end associate
      quantity = top + deep*(bottom - top)
   end function between_ends
end module dg_profile
