!> The wall of the hole in the gap elements: its softened stiffness for a start, and the gaps' laws.
module dg_walls
   use dg_kinds, only: wp
   use dg_gap_action, only: load_type
   use dg_gap_state, only: gap_law_type, gap_thresholds_type
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_mesh, only: mesh_type
   use dg_numerics, only: gap_at_nodes, numerics_type
   implicit none
   private
   public :: softness, lay_out_gaps, tolerance_at

   !> Round-off of places of some metres [m]. Times the wall's stiffness it is the least possible residual force. It exceeds
   !> the tolerance for walls of 1e9 N/m2 or more, and where stations are kilometres apart: places count from the station
   !> above.
   real(wp), parameter :: far = 100.0_wp
   real(wp), parameter :: round_off_of_places = far*epsilon(1.0_wp)
   !> Round-off of offsets from the hole axis [m].
   real(wp), parameter :: round_off_of_offsets = epsilon(1.0_wp)
   !> Round-off of an element's shape, times 12 EI/L^3, for each metre that the string slides, at least one [-]. Collars in an
   !> element of 4 mm, between a station and the end of a component, have 0.1 N of it.
   real(wp), parameter :: round_off_of_shapes = 4.0_wp*epsilon(1.0_wp)
   !> Largest tolerance of the iteration [-]: the residuals of many nodes add up in the sum of contact.
   real(wp), parameter :: loosest = 1.0e-6_wp
   !> First places of the gaps: mid-element for the paper's x0, the lower node for fixed points.
   real(wp), parameter :: middle = 0.5_wp
   real(wp), parameter :: lower_node = 1.0_wp

contains

   !> Stiffness of the walls for a start over their own [-]: the expected load presses in by a visible part of the clearance.
   !> Against the wall itself every gap that opens or closes would change the contact of its neighbours.
   pure function softness(soft_penetration, mesh, pressing) result(share)
      real(wp), intent(in) :: soft_penetration   !< as in tuning_type [-]
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: pressing   !< largest expected contact load over its clearance [N/m2]
      real(wp) :: share
      share = 1.0_wp
      if (pressing > 0.0_wp) share = min(1.0_wp, pressing/(soft_penetration*maxval(mesh%wall)))
   end function softness

   !> Tolerances of the residual over the force scale [-]: with the pushes of gaps that are too deep for their forces, and
   !> without. Neither is below the round-off of short elements, and the first is not below that of stiff walls. Contact forces
   !> are unknowns of their own, and exact to the round-off of offsets, not of places. Those of the ends' supports follow from
   !> places, and are in both residuals. With soft walls they dominate.
   pure function tolerance_at(numerics, mesh, gaps, loads, force_scale) result(tolerance)
      type(numerics_type), intent(in) :: numerics
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(load_type), intent(in) :: loads   !< with the supports of the ends
      real(wp), intent(in) :: force_scale    !< [N]
      real(wp) :: tolerance(2)
      real(wp) :: walls, places, slide
      walls = maxval(gaps%law%maximum)/force_scale
      slide = max(1.0_wp, force_scale*sum(mesh%length/mesh%section%ea))
      tolerance = max(min(numerics%tolerance, loosest), &
                      slide*round_off_of_shapes*maxval(12.0_wp*mesh%section%ei/mesh%length**3)/force_scale)
      places = max(1.0_wp, maxval(norm2(mesh%base, dim=1))/far)*round_off_of_places
      tolerance = max(tolerance, places*max(loads%top_support, loads%bit_support)/force_scale)
      tolerance(1) = max(tolerance(1), places*walls)
      tolerance(2) = max(tolerance(2), round_off_of_offsets*walls)
   end function tolerance_at

   !> Make a table of free gaps with their laws, at their first places.
   pure subroutine lay_out_gaps(numerics, mesh, gaps)
      type(numerics_type), intent(in) :: numerics
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(out) :: gaps
      type(gap_law_type), allocatable :: laws(:)
      integer :: e
      allocate (laws(mesh%elements))
      do e = 1, mesh%elements
         laws(e) = gap_law_type(clearance=mesh%opening(e), contact=mesh%wall(e)*mesh%length(e), &
            maximum=mesh%rigid(e)*mesh%length(e), eps_nmax=mesh%eps_nmax(e))
      end do
      gaps = new_gap_table(laws, merge(lower_node, middle, numerics%gap_location == gap_at_nodes))
      gaps%thresholds = gap_thresholds_type(eps_n0=numerics%eps_n0, r_n0=numerics%r_n0)
      where (mesh%centralizer) gaps%xi = middle
   end subroutine lay_out_gaps
end module dg_walls
