!> Viscosity on the lateral unknowns of a compressed string, in units of F^2/(4 EI) of the place [-]: the most by which an
!> axial compression F can make a beam's lateral stiffness negative, EI v'''' + F v'' + F^2/(4 EI) v being never so. One is
!> therefore enough where the string is uniform; each zone gets what it needs, and weakly compressed ones grow as fast as
!> others.
module dg_viscosity
   use dg_kinds, only: wp
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, workspace_type
   implicit none
   private
   public :: weigh

   !> Viscosity on a slope over that of a lateral unknown times length squared: 4/420 of the consistent matrix of a
   !> cubic element, rounded.
   real(wp), parameter :: slope_lump = 0.01_wp
   !> What every place gets of the largest F^2/(4 EI) [-], lest something else than compression be unstable.
   real(wp), parameter :: viscosity_everywhere = 1.0e-4_wp

contains

   !> What a unit of viscosity adds to the diagonal: F^2/(4 EI) of the place times the node's length for lateral unknowns,
   !> times a part of its cube for slopes, as the consistent matrix of a line load has it, so that no pattern of slopes
   !> escapes.
   pure subroutine weigh(mesh, work, lump)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(inout) :: lump(:, :)
      real(wp) :: least, force, lateral, slope
      integer :: e
      least = viscosity_everywhere*maxval(min(work%axial, 0.0_wp)**2/(4.0_wp*mesh%ei))
      lump = 0.0_wp
      do e = 1, mesh%elements
         force = max(min(work%axial(e), 0.0_wp)**2/(4.0_wp*mesh%ei(e)), least)
         lateral = 0.5_wp*force*mesh%length(e)
         slope = slope_lump*force*mesh%length(e)**3
         lump(dof_lateral_1:dof_lateral_2, e:e + 1) = lump(dof_lateral_1:dof_lateral_2, e:e + 1) + lateral
         lump(dof_slope_1:dof_slope_2, e:e + 1) = lump(dof_slope_1:dof_slope_2, e:e + 1) + slope
      end do
   end subroutine weigh

end module dg_viscosity
