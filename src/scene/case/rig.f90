!> The rig between the string and its weight indicator: travelling block, lines and sheaves.
!>
!> The indicator measures the tension of the dead line. It shows that tension times the number of lines, which is the load on
!> the block at rest. While the block moves, each sheave that turns takes its share of the tension. The line that leaves a
!> sheave of efficiency e towards the drum has 1/e times the tension when raising, e times when lowering. The dead line, at the
!> far end, therefore has too little of the load when raising and too much when lowering. (Luke & Juvkam-Wold 1993, The
!> determination of true hook-and-line tension under dynamic conditions: inactive and active dead-line sheave.)
module dg_rig
   use dg_kinds, only: wp
   use dg_key_visitor, only: key_visitor_type
   use dg_load_case, only: block_way
   use dg_missing, only: optional_real
   implicit none
   private
   public :: rig_type, visit_rig, indicated_load, string_load, indicator_factor

   type :: rig_type
      logical :: given = .false.               !< the deck has a rig: measured loads are those of its indicator
      real(wp) :: block_weight = 0.0_wp        !< weight of all that hangs on the lines besides the string [N]
      integer :: lines = 1                     !< number of lines to the travelling block
      real(wp) :: sheave_efficiency = 1.0_wp   !< tension after a turning sheave over that before it, 0 to 1 [-]
      !> The sheave of the crown with the dead line turns with the others. Its line does not run, so that it normally does not.
      logical :: active_deadline_sheave = .false.
      type(optional_real) :: max_hookload      !< load that the rig may carry, with its block [N]
      type(optional_real) :: max_torque        !< largest torque of the top drive [N.m]
      real(wp) :: max_push = 0.0_wp            !< largest push at surface: of rig, injector or hanger [N]
   end type rig_type

contains

   !> Visit all numbers of a rig.
   subroutine visit_rig(rig, visitor)
      type(rig_type), intent(inout) :: rig
      class(key_visitor_type), intent(inout) :: visitor
      call visitor%number('block_weight', rig%block_weight)
      call visitor%whole('lines', rig%lines)
      call visitor%number('sheave_efficiency', rig%sheave_efficiency)
      call visitor%optional('max_hookload', rig%max_hookload)
      call visitor%optional('max_torque', rig%max_torque)
      call visitor%number('max_push', rig%max_push)
   end subroutine visit_rig

   !> Load of the weight indicator [N]: block and string, by the tension of the dead line.
   elemental function indicated_load(rig, operation, hookload) result(indicated)
      type(rig_type), intent(in) :: rig
      integer, intent(in) :: operation         !< number (dg_load_case)
      real(wp), intent(in) :: hookload         !< axial force at the top of the string [N]
      real(wp) :: indicated
      indicated = indicator_factor(rig, operation)*(hookload + rig%block_weight)
   end function indicated_load

   !> Axial force at the top of the string at which the indicator shows a load [N].
   elemental function string_load(rig, operation, indicated) result(hookload)
      type(rig_type), intent(in) :: rig
      integer, intent(in) :: operation
      real(wp), intent(in) :: indicated        !< [N]
      real(wp) :: hookload
      hookload = indicated/indicator_factor(rig, operation) - rig%block_weight
   end function string_load

   !> Indicated load over the load on the lines [-]: 1 while the block is still.
   !>
   !> With the tension of the dead line as 1, the lines at the block have 1, 1/e, 1/e^2, ... when raising. An active dead-line
   !> sheave multiplies all of them by 1/e. When lowering e replaces 1/e. The block hangs on their sum.
   elemental function indicator_factor(rig, operation) result(factor)
      type(rig_type), intent(in) :: rig
      integer, intent(in) :: operation
      real(wp) :: factor
      real(wp) :: growth, load
      integer :: line
      growth = 1.0_wp
      if (block_way(operation) > 0) growth = 1.0_wp/rig%sheave_efficiency
      if (block_way(operation) < 0) growth = rig%sheave_efficiency
      load = 0.0_wp
      do line = 1, rig%lines
         load = 1.0_wp + growth*load
      end do
      if (rig%active_deadline_sheave) load = growth*load
      factor = real(rig%lines, wp)/load
   end function indicator_factor
end module dg_rig
