!> Arrays of one solution, allocated once. Nothing is allocated within an iteration.
module dg_workspace
   use dg_kinds, only: wp
   use dg_mesh, only: mesh_type
   implicit none
   private
   public :: workspace_type, new_start_room, new_workspace, place_nodes, place_node, make_room_for_recovery, keep_for_moments
   public :: dof_axial, dof_lateral_1, dof_lateral_2, dof_twist, dof_slope_1, dof_slope_2

   !> Order of a node's six unknowns (conventions of src/README.md).
   integer, parameter :: dof_axial = 1, dof_lateral_1 = 2, dof_lateral_2 = 3
   integer, parameter :: dof_twist = 4, dof_slope_1 = 5, dof_slope_2 = 6

   type :: workspace_type
      ! places of the nodes: place_nodes
      real(wp), allocatable :: shift(:, :)       !< displacement in space axes (3,nodes) [m]
      real(wp), allocatable :: d(:, :)           !< directors (3,nodes)
      ! places of the gaps, by element: survey_gaps
      real(wp), allocatable :: gap(:, :)            !< f, from the hole axis at the point's present place (3,e) [m]
      real(wp), allocatable :: axis_tangent(:, :)   !< t of the hole axis there (3,e)
      real(wp), allocatable :: axis_curvature(:, :) !< dt/ds there (3,e) [1/m]
      real(wp), allocatable :: displacement(:)      !< |f| [m]
      ! forces: assemble
      real(wp), allocatable :: axial(:)             !< beam's axial force, tension > 0 (e) [N]
      real(wp), allocatable :: torque(:)            !< GJ/L (phi_j - phi_i) (e) [N.m]
      real(wp), allocatable :: normal(:)            !< contact force R (e) [N]
      real(wp), allocatable :: sideways(:)          !< share of circumferential friction that acts sideways, 0 where the string
                                                    !< whirls (e) [-]
      real(wp), allocatable :: held(:)              !< share of a sliding string's friction that acts against t x n (e) [-]
      logical :: separate = .false.                 !< contact forces are unknowns of their own, independent of places
      ! forces that only the result needs, filled if allocated: make_room_for_recovery
      real(wp), allocatable :: node_force(:, :)     !< on x and d in space axes, of all elements (6,nodes) [N, N.m]
      real(wp), allocatable :: contact_force(:, :)  !< F (3,e) [N]
      real(wp), allocatable :: contact_moment(:, :) !< M (3,e) [N.m]
      real(wp), allocatable :: end_force(:, :)      !< on (x_i, d_i), the upper end, less element loads (6,e) [N, N.m]
      real(wp), allocatable :: node_torque(:)       !< in the string at a node, less friction of its elements (nodes) [N.m]
      ! of the whole string
      real(wp) :: reaction(3) = 0.0_wp          !< force that holds the top, supports included [N]
      real(wp) :: bit_reaction(3) = 0.0_wp      !< lateral support at the bit [N]
      real(wp) :: weight_on_bit = 0.0_wp        !< given, or by a given hook load [N]
      real(wp) :: bit_load(3) = 0.0_wp          !< force of the formation on the bit [N]
      real(wp) :: top_moment(3) = 0.0_wp        !< of the torque that holds the top [N.m]
      real(wp) :: bit_moment(3) = 0.0_wp        !< of the torque on bit, on the string [N.m]
      real(wp) :: hookload = 0.0_wp             !< [N]
      real(wp) :: top_torque = 0.0_wp           !< [N.m]
   end type workspace_type

contains

   !> Allocate the arrays that the start of an iteration needs and sets.
   pure subroutine new_start_room(mesh, work)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(out) :: work
      allocate (work%sideways(mesh%elements), source=1.0_wp)
      allocate (work%normal(mesh%elements), work%held(mesh%elements), source=0.0_wp)
   end subroutine new_start_room

   !> Allocate the arrays of a mesh, and keep those that a start has set.
   pure subroutine new_workspace(mesh, work)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(inout) :: work
      integer :: n, m
      n = mesh%nodes
      m = mesh%elements
      if (.not. allocated(work%sideways)) call new_start_room(mesh, work)
      allocate (work%shift(3, n), work%d(3, n), source=0.0_wp)
      allocate (work%axial(m), work%torque(m), work%displacement(m), source=0.0_wp)
      allocate (work%gap(3, m), work%axis_tangent(3, m), work%axis_curvature(3, m), source=0.0_wp)
   end subroutine new_workspace

   !> Allocate the forces that only the result needs. The next assembly fills them.
   pure subroutine make_room_for_recovery(mesh, work)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(inout) :: work
      integer :: m
      if (allocated(work%end_force)) return
      m = mesh%elements
      allocate (work%contact_force(3, m), work%contact_moment(3, m), work%end_force(6, m), work%node_force(6, mesh%nodes), &
                work%node_torque(mesh%nodes), source=0.0_wp)
   end subroutine make_room_for_recovery

   !> Release all arrays that the moments along the string do not need, once the forces are in the result.
   pure subroutine keep_for_moments(work)
      type(workspace_type), intent(inout) :: work
      deallocate (work%gap, work%axis_tangent, work%axis_curvature, work%displacement, work%axial)
      deallocate (work%node_force, work%contact_force, work%contact_moment, work%end_force, work%node_torque)
   end subroutine keep_for_moments

   !> Displacements and directors (dg_director) in space axes from the unknowns state(6,nodes).
   pure subroutine place_nodes(mesh, state, work)
      type(mesh_type), intent(in) :: mesh
      real(wp), contiguous, intent(in) :: state(:, :)   !< (6,nodes) [m, rad, -]
      type(workspace_type), intent(inout) :: work
      integer :: n
      do n = 1, mesh%nodes
         call place_node(mesh%frame(:, :, n), state(:, n), work%shift(:, n), work%d(:, n))
      end do
   end subroutine place_nodes

   !> Displacement (3) [m] and director (3) of one node.
   pure subroutine place_node(frame, state, shift, d)
      real(wp), intent(in) :: frame(3, 3), state(6)   !< of the node: axes t, n_1, n_2 [-], unknowns [m, rad, -]
      real(wp), intent(out) :: shift(3), d(3)         !< [m], [-]
      real(wp) :: reciprocal
      integer :: i
      reciprocal = 1.0_wp/sqrt(1.0_wp + state(5)**2 + state(6)**2)
      do i = 1, 3
         shift(i) = state(1)*frame(i, 1) + state(2)*frame(i, 2) + state(3)*frame(i, 3)
         d(i) = reciprocal*(frame(i, 1) + state(5)*frame(i, 2) + state(6)*frame(i, 3))
      end do
   end subroutine place_node
end module dg_workspace
