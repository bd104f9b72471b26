!> Where stiffness matters to the mixed model.
module dg_stiff_places
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_curvature_change, only: change_type
   implicit none
   private
   public :: matters, stiffer

   !> Change of curvature that counts as sharp [1/m]: 15 deg in 30 m, where Payne & Abbassian (1997) see
   !> stiff and soft strings part.
   real(wp), parameter :: sharp_turn = 15.0_wp*degree/30.0_wp
   !> Stiffness over that of the uppermost component above which a component is of the assembly [-]: round-off.
   real(wp), parameter :: stiffer = 1.0_wp + 1.0e-6_wp

contains

   !> True if stiffness matters at a change of curvature.
   elemental function matters(change, pipe) result(yes)
      type(change_type), intent(in) :: change
      real(wp), intent(in) :: pipe   !< E I of the uppermost component [N.m2]
      logical :: yes
      yes = change%forced .or. change%stiffness > stiffer*pipe .or. norm2(change%curvature) > sharp_turn
   end function matters
end module dg_stiff_places
