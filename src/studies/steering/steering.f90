!> What a &steering of a deck asks: where assemblies drill to.
module dg_steering
   use dg_kinds, only: wp
   use dg_load_case, only: optional_real
   implicit none
   private
   public :: steering_type

   type :: steering_type
      integer, allocatable :: cases(:)         !< numbers of load cases
      real(wp), allocatable :: toolfaces(:)    !< [rad]; none: that of each load case
      real(wp) :: length = 150.0_wp            !< of the string above the bit that is solved [m]
      real(wp) :: hole_enlargement = 0.0_wp    !< of the diameter above the bit [m]
      real(wp), allocatable :: measured(:)     !< doglegs towards the toolface that were measured, one or one a case [1/m]
      type(optional_real) :: side_cutting      !< penetration of the bit sideways over that ahead, for the same force [-]
   end type steering_type
end module dg_steering
