!> The plane of a hole that does not turn, in which a string that neither rotates nor buckles stays: nothing pushes it out.
!>
!> Its fixed axes are a horizontal one and the vertical, down. The frames of the nodes are rotation-minimising, so that the same
!> combination of n_1 and n_2 lies in the plane at every depth: unknowns in the plane are v on it, and beta its slope.
module dg_plane
   use dg_kinds, only: wp
   use dg_case_result, only: way_buckles, way_not_asked, way_planar, way_rotates, way_turns
   use dg_mesh, only: mesh_type
   use dg_workspace, only: dof_axial, dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, dof_twist
   implicit none
   private
   public :: plane_type, choose_way, find_plane, flatten, unfold
   public :: row_axial, row_lateral, row_slope

   !> Order of a node's three unknowns in the plane.
   integer, parameter :: row_axial = 1, row_lateral = 2, row_slope = 3

   type :: plane_type
      real(wp) :: horizontal(3) = 0.0_wp  !< unit, in the plane
      real(wp) :: lateral(2) = 0.0_wp     !< direction across the hole in the plane, along n_1 and n_2 of any node
   end type plane_type

   !> How far out of the plane tangents and frames may point [-]: round-off of a survey's azimuths and of a thousand arcs. A string
   !> of 10 MN feels a hundredth of a millinewton of it.
   real(wp), parameter :: flat = 1.0e-12_wp

contains

   !> Chooses plane or space. Where the hole lies in a vertical plane and the string neither rotates nor has torque on its bit,
   !> weight, walls and friction leave it there, and its equilibrium is there if it has any; where it may buckle out of the plane
   !> that equilibrium would not last.
   pure subroutine choose_way(asked, mesh, tob, may_buckle, plane, way)
      logical, intent(in) :: asked          !< for planes
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: tob           !< torque on bit [N.m]
      logical, intent(in) :: may_buckle
      type(plane_type), intent(out) :: plane
      integer, intent(out) :: way           !< way_planar, or why it is not
      logical :: found
      way = way_not_asked
      if (.not. asked) return
      way = way_rotates
      if (any(abs(mesh%rotary) > 0.0_wp) .or. abs(tob) > 0.0_wp) return
      way = way_turns
      if (allocated(mesh%bend) .or. allocated(mesh%push)) return
      call find_plane(mesh, plane, found)
      if (.not. found) return
      way = merge(way_buckles, way_planar, may_buckle)
   end subroutine choose_way

   !> The vertical plane of the hole along the string. found: there is one.
   pure subroutine find_plane(mesh, plane, found)
      type(mesh_type), intent(in) :: mesh
      type(plane_type), intent(out) :: plane
      logical, intent(out) :: found
      real(wp) :: normal(3), level(2), across(2)
      integer :: n
      ! the horizontal part of the most inclined tangent; of any vector across where the hole is vertical
      n = maxloc(mesh%frame(1, 1, :)**2 + mesh%frame(2, 1, :)**2, dim=1)
      level = mesh%frame(1:2, 1, n)
      if (.not. norm2(level) > flat) level = mesh%frame(1:2, 2, n)
      plane%horizontal = [level/norm2(level), 0.0_wp]
      normal = [plane%horizontal(2), -plane%horizontal(1), 0.0_wp]     ! horizontal x down
      found = .false.
      do n = 1, mesh%nodes
         if (abs(dot_product(mesh%frame(:, 1, n), normal)) > flat) return
         across = lateral_of(n)
         if (n == 1) plane%lateral = across
         if (any(abs(across - plane%lateral) > flat)) return
      end do
      plane%lateral = plane%lateral/norm2(plane%lateral)
      found = .true.

   contains

      !> normal x t on n_1 and n_2: t x n_1 = n_2.
      pure function lateral_of(node) result(on)
         integer, intent(in) :: node
         real(wp) :: on(2)
         on(1) = dot_product(normal, mesh%frame(:, 3, node))
         on(2) = -dot_product(normal, mesh%frame(:, 2, node))
      end function lateral_of
   end subroutine find_plane

   !> Takes everything out of the plane off a state(6,nodes).
   pure subroutine flatten(plane, state)
      type(plane_type), intent(in) :: plane
      real(wp), intent(inout) :: state(:, :)
      integer :: n
      do n = 1, size(state, 2)
         state(dof_lateral_1:dof_lateral_2, n) = plane%lateral*dot_product(plane%lateral, state(dof_lateral_1:dof_lateral_2, n))
         state(dof_slope_1:dof_slope_2, n) = plane%lateral*dot_product(plane%lateral, state(dof_slope_1:dof_slope_2, n))
         state(dof_twist, n) = 0.0_wp
      end do
   end subroutine flatten

   !> A node's step(3) in the plane as one in space (6).
   pure subroutine unfold(plane, step, in_space)
      type(plane_type), intent(in) :: plane
      real(wp), intent(in) :: step(3)
      real(wp), intent(out) :: in_space(6)
      in_space(dof_axial) = step(row_axial)
      in_space(dof_lateral_1:dof_lateral_2) = step(row_lateral)*plane%lateral
      in_space(dof_twist) = 0.0_wp
      in_space(dof_slope_1:dof_slope_2) = step(row_slope)*plane%lateral
   end subroutine unfold
end module dg_plane
