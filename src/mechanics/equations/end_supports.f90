!> Forces on the ends of the string across the hole, and the formation's push on the bit. A load increment sets both, and
!> friction with them.
module dg_end_supports
   use dg_kinds, only: wp
   use dg_gap_action, only: load_type
   use dg_gap_contact, only: support_action
   use dg_load_case, only: load_case_type
   use dg_mesh, only: mesh_type
   use dg_model, only: model_type
   use dg_packer, only: end_compression
   use dg_trajectory, only: closest_point, trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: end_action, set_loads, force_scale

   !> Stiffness of the support of a centred end [N/m]. A support is a constraint, not a wall. A force of 100 kN moves it by
   !> 0.003 mm, little beside a clearance of 0.4 mm at a blade next to the bit. At 1e11 round-off prevents convergence of
   !> elements of 0.1 m.
   real(wp), parameter :: end_stiffness = 3.0e10_wp
   !> Force scale of a string without weight and load [N].
   real(wp), parameter :: least_scale = 1.0_wp

contains

   !> Force [N] on the top or the bottom node, and its derivative by the node's place (3,3) [N/m]. `support` is the stiffness
   !> of its lateral support [N/m] and `wob` the load at the bit [N]. `work` returns the two parts of the force on the bit.
   pure subroutine end_action(trajectory, mesh, node, support, wob, work, force, by_point)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(in) :: support, wob                !< 0: free [N/m]; > 0 pushes the bit [N]
      type(workspace_type), intent(inout) :: work
      real(wp), intent(out) :: force(3), by_point(3, 3)   !< [N], [N/m]
      real(wp) :: point(3), gap(3), tangent(3), curvature(3), offset, chi
      integer :: arc, j
      arc = mesh%arc(node)
      point = mesh%base(:, node) + work%shift(:, node)
      call closest_point(trajectory, arc, point, offset, gap, tangent, curvature)
      call support_action(gap, tangent, curvature, support, force, by_point)
      if (node /= mesh%nodes) return
      chi = 1.0_wp/(1.0_wp - dot_product(curvature, gap))
      work%bit_reaction = force
      work%bit_load = -wob*tangent                     ! the formation pushes up the hole
      force = force + work%bit_load
      do j = 1, 3
         by_point(:, j) = by_point(:, j) - (wob*chi*tangent(j))*curvature
      end do
   end subroutine end_action

   !> Set bit loads and friction of a load increment, and the supports of the ends. `fraction` is the part of the whole load
   !> [-].
   pure subroutine set_loads(model, load_case, fraction, loads)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: fraction   !< 0 to 1 [-]
      type(load_type), intent(out) :: loads
      loads%wob = fraction*end_compression(model, load_case)
      if (model%hookload%present) loads%hookload = fraction*model%hookload%value
      loads%tob = fraction*load_case%tob
      loads%friction_scale = fraction
      if (model%boundary%top_centred) loads%top_support = end_stiffness
      if (model%boundary%bit_centred) loads%bit_support = end_stiffness
   end subroutine set_loads

   !> Scale to which unbalanced forces are compared [N]: weight of the string, load of its lower end, and forces of pads.
   pure function force_scale(model, load_case, mesh) result(scale)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(mesh_type), intent(in) :: mesh
      real(wp) :: scale
      scale = max(sum(abs(mesh%weight)*mesh%length) + abs(end_compression(model, load_case)), least_scale)
      if (allocated(mesh%push)) scale = scale + sum(norm2(mesh%push, dim=1)*mesh%length)
   end function force_scale
end module dg_end_supports
