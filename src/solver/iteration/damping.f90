!> Damping that holds the nodes of a string back during the iteration. Its unit is the local F^2/(4 EI). By so much at most an
!> axial compression F can make a beam's lateral stiffness negative: EI v'''' + F v'' + F^2/(4 EI) v is never negative. A
!> damping of one is therefore enough for a uniform string. Each zone gets what it needs, and weakly compressed zones grow as
!> fast as others.
module dg_damping
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   use dg_mesh, only: mesh_type
   use dg_tuning, only: tuning_type
   use dg_workspace, only: dof_axial, dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, workspace_type
   implicit none
   private
   public :: weigh_string, add_damping, ease_damping
   public :: damping_most

   !> Damping of a slope, over damping per length times length cubed [-]. It is 4/420 of the consistent matrix of a cubic
   !> element, rounded.
   real(wp), parameter :: slope_lump = 0.01_wp
   !> Damping above which a run is given up [-].
   real(wp), parameter :: damping_most = 1.0e9_wp

contains

   !> Diagonal terms of a unit of damping (6,nodes). Lateral unknowns get the local F^2/(4 EI) times the node's length. Slopes
   !> get a part of that length's cube, as in the consistent matrix of a line load. Every place has at least a part of a soft
   !> wall's stiffness, and nodes are held along the hole as well.
   pure subroutine weigh_string(tuning, mesh, work, soft, lump)
      type(tuning_type), intent(in) :: tuning
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(in) :: soft                 !< stiffness of a wall that yields visibly [N/m2]
      real(wp), intent(inout) :: lump(:, :)        !< (6,nodes) [N/m, N.m]
      real(wp) :: force, lateral, slope
      integer :: e
      lump = 0.0_wp
      do e = 1, mesh%elements
         force = max(min(work%axial(e), 0.0_wp)**2/(4.0_wp*mesh%section(e)%ei), tuning%of_soft_wall*soft)
         lateral = 0.5_wp*force*mesh%length(e)
         slope = slope_lump*force*mesh%length(e)**3
         lump(dof_axial, e:e + 1) = lump(dof_axial, e:e + 1) + tuning%along_hole*lateral
         lump(dof_lateral_1:dof_lateral_2, e:e + 1) = lump(dof_lateral_1:dof_lateral_2, e:e + 1) + lateral
         lump(dof_slope_1:dof_slope_2, e:e + 1) = lump(dof_slope_1:dof_slope_2, e:e + 1) + slope
      end do
   end subroutine weigh_string

   !> Add damping to a matrix.
   pure subroutine add_damping(damping, lump, matrix)
      real(wp), intent(in) :: damping      !< in units of F^2/(4 EI) [-]
      real(wp), intent(in) :: lump(:, :)   !< diagonal terms of a unit of damping (6,nodes) [N/m, N.m]
      type(block_matrix_type), intent(inout) :: matrix
      integer :: n, i
      do n = 1, size(lump, 2)
         do i = 1, block_size
            matrix%diagonal(i, i, n) = matrix%diagonal(i, i, n) + damping*lump(i, n)
         end do
      end do
   end subroutine add_damping

   !> Lower the damping after a step was accepted, less after a refusal.
   pure subroutine ease_damping(tuning, first_try, damping)
      type(tuning_type), intent(in) :: tuning
      logical, intent(in) :: first_try
      real(wp), intent(inout) :: damping   !< in units of F^2/(4 EI) [-]
      damping = damping*merge(tuning%after_success, tuning%after_refusal, first_try)
   end subroutine ease_damping
end module dg_damping
