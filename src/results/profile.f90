!> Results along the string, surface to bit: one type for every model, so that tables and files need no
!> special cases. SI units; conversion happens in the report.
module dg_profile
   use dg_kinds, only: wp
   use dg_missing, only: missing
   use dg_gap_state, only: state_elastic, state_free, state_name, state_rigid
   implicit none
   private
   public :: profile_type, new_profile, state_free, state_elastic, state_rigid, state_name

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
   end function new_profile
end module dg_profile
