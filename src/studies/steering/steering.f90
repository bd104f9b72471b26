!> Data of a deck's &steering: directions in which assemblies drill.
module dg_steering
   use dg_kinds, only: wp
   use dg_missing, only: missing, optional_real
   implicit none
   private
   public :: steering_type
   public :: steering_result_type

   type :: steering_type
      integer, allocatable :: cases(:)         !< numbers of load cases
      real(wp), allocatable :: toolfaces(:)    !< [rad]; none: that of each load case
      real(wp) :: length = 150.0_wp            !< of the string above the bit that is solved [m]
      real(wp) :: hole_enlargement = 0.0_wp    !< of the diameter above the bit [m]
      real(wp), allocatable :: measured(:)     !< doglegs towards the toolface that were measured, one or one a case [1/m]
      type(optional_real) :: side_cutting      !< penetration of the bit sideways over that ahead, for the same force [-]
   end type steering_type

   !> Direction of drilling of an assembly: its bit in the given hole, and the curvature at which the hole goes on. Pairs are
   !> parts towards the high side (north where the hole is vertical) and to the right of it, looking down the hole.
   type :: steering_result_type
      integer :: case_index = 0
      real(wp) :: toolface = missing          !< [rad]; missing: a straight string, or the mean over a turn
      real(wp) :: inclination = 0.0_wp        !< of the hole at the bit [rad]
      real(wp) :: hole(2) = missing           !< curvature of the hole at the bit [1/m]
      real(wp) :: side_force(2) = missing     !< of the bit on the formation in that hole [N]
      real(wp) :: tilt(2) = missing           !< to which the bit points there, against the hole axis [rad]
      real(wp) :: curvature(2) = missing      !< at which the hole goes on [1/m]
      real(wp) :: three_points = missing      !< curvature of a stiff assembly on three points [1/m]; missing: it has no bend
      !> Doglegs towards the tool face without side cutting and without side force; missing: none was measured, or not found [1/m].
      real(wp) :: reach(2) = missing
      real(wp) :: side_cutting = missing      !< side cutting that gives the measured dogleg [-]; missing: none was measured, or
                                              !< there is none
      integer :: solutions = 0                !< of the string
      logical :: found = .false.
      character(:), allocatable :: message    !< reason without a result
   end type steering_result_type
end module dg_steering
