!> The wall of the hole as the gap elements have it: its stages of stiffness, and the gaps' laws.
module dg_wall_stages
   use dg_kinds, only: wp
   use dg_gap_state, only: gap_law_type
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_mesh, only: mesh_type
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_nodes, numerics_type
   implicit none
   private
   public :: stage_walls, set_walls, lay_out_gaps, tolerance_at
   public :: soft_penetration

   !> The softest wall yields to the expected contact load by this part of the clearance [-]: as soft as beams of some metres
   !> are between two contacts, so that no single gap matters.
   real(wp), parameter :: soft_penetration = 0.1_wp
   !> Largest ratio of stiffness from one stage to the next [-]: 30 to 200 cost the same.
   real(wp), parameter :: largest_stiffening = 50.0_wp
   !> The penetration where contact forces are kept from one wall to the next [-]: then only what the shape of the string owes to
   !> it matters, and one softer wall is enough. Of 0.005, 0.01 and 0.02 it costs least.
   real(wp), parameter :: kept_penetration = 0.01_wp
   !> Places are known to some units in the last digit of metres [m]; times the wall's stiffness that is the least residual
   !> force that there can be. It rules above the tolerance from walls of 1e9 N/m2 on.
   real(wp), parameter :: round_off_of_places = 100.0_wp*epsilon(1.0_wp)
   !> Where gaps sit at first: mid-element for the paper's x0, the lower node for fixed points.
   real(wp), parameter :: middle = 0.5_wp
   real(wp), parameter :: lower_node = 1.0_wp

contains

   !> Wall stiffnesses to go through over the final one [-], ending in 1. A stiff wall is a hard start: every gap that
   !> opens or closes throws its neighbours about, and a span that overshoots is thrown back with thousands of kN. Against
   !> a soft wall, which the string's weight presses in by a visible part of the clearance, the problem is smooth; each
   !> stiffer wall then starts from the state before.
   pure subroutine stage_walls(model, mesh, pressing, kept, walls)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: pressing   !< largest expected contact load over its clearance [N/m2]
      logical, intent(in) :: kept        !< contact forces are, from one wall to the next: damped Newton
      real(wp), allocatable, intent(out) :: walls(:)
      real(wp) :: soft, stiff, ratio
      integer :: stages, i
      soft = pressing/soft_penetration
      stiff = maxval(mesh%wall)
      stages = 1
      if (kept .and. soft > 0.0_wp .and. model%numerics%soften) then
         walls = [1.0_wp]
         if (pressing < kept_penetration*stiff) walls = [pressing/(kept_penetration*stiff), 1.0_wp]
         return
      end if
      if (soft > 0.0_wp .and. model%numerics%soften) stages = 1 + ceiling(log(max(stiff/soft, 1.0_wp))/log(largest_stiffening))
      allocate (walls(stages), source=1.0_wp)
      if (stages == 1) return
      ratio = (soft/stiff)**(1.0_wp/(stages - 1))
      do i = 1, stages - 1
         walls(i) = ratio**(stages - i)
      end do
   end subroutine stage_walls

   !> Gives every gap its wall, `scale` times the final stiffness: 1 for the deck's, less for a stage before it.
   pure subroutine set_walls(model, mesh, scale, gaps)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: scale
      type(gap_table_type), intent(inout) :: gaps
      gaps%law%contact = scale*mesh%wall*mesh%length
      gaps%law%maximum = scale*max(model%numerics%gk_max, mesh%wall)*mesh%length
   end subroutine set_walls

   !> Tolerance of the residual over the force scale [-].
   pure function tolerance_at(numerics, gaps, force_scale) result(tolerance)
      type(numerics_type), intent(in) :: numerics
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: force_scale    !< [N]
      real(wp) :: tolerance
      tolerance = max(numerics%tolerance, round_off_of_places*maxval(gaps%law%maximum)/force_scale)
   end function tolerance_at

   !> A table of free gaps with their laws, at their first places.
   pure subroutine lay_out_gaps(numerics, mesh, gaps)
      type(numerics_type), intent(in) :: numerics
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(out) :: gaps
      type(gap_law_type), allocatable :: laws(:)
      integer :: e
      allocate (laws(mesh%elements))
      do e = 1, mesh%elements
         laws(e) = gap_law_type(clearance=mesh%clearance(e), contact=mesh%wall(e)*mesh%length(e), &
            maximum=max(numerics%gk_max, mesh%wall(e))*mesh%length(e), eps_n0=numerics%eps_n0, eps_nmax=mesh%eps_nmax(e), &
            r_n0=numerics%r_n0)
      end do
      gaps = new_gap_table(laws, merge(lower_node, middle, numerics%gap_location == gap_at_nodes))
   end subroutine lay_out_gaps
end module dg_wall_stages
