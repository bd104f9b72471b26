!> Gaps that represent the wall along the whole of their elements.
!>
!> An element of the analysis feels the wall at one place. Where it touches along a part of its length, as at the edge of a
!> tilted blade, neither force nor lever are right. In an assembly with tight blades the sum of contact is wrong by up to 1.3 %
!> on elements of any length. The beam that gives the moments (dg_bending_profile) feels the wall everywhere. A fitted gap sits
!> at the centre of the beam's contact force, and has the clearance at which its own law has that force there.
module dg_fitted_gaps
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, bent_type, length_of
   use dg_bending_element, only: contact_places, contact_xi
   use dg_bending_nodes, only: shape_at
   use dg_gap_state, only: depth_of, gap_law_type, state_elastic, state_free
   use dg_gap_table, only: gap_table_type, fix_gap
   use dg_mesh, only: mesh_type
   use dg_mesh_for_case, only: near_edges
   use dg_trajectory, only: trajectory_type
   implicit none
   private
   public :: fitted_gaps_type, are_worth_fitting, fit_gaps

   !> Difference of the contact force of a part of the string from the beam, over the whole, above which gaps are fitted [-].
   !> The second holds in strings with blades, bends or pads.
   real(wp), parameter :: worth_fitting = 1.0e-3_wp, at_edges = 3.0e-4_wp

   type :: fitted_gaps_type
      type(gap_table_type) :: gaps
      real(wp), allocatable :: normal(:)       !< contact forces of the beam; not allocated where nothing is fitted (e) [N]
   end type fitted_gaps_type

contains

   !> True if the beam is nearer to the true string than the analysis. `share` is the largest difference of contact of a part,
   !> over the whole [-]. The beam neglects the offset of the string over the radius of the hole's bends. Its contact may be
   !> wrong by twice that. In a helically buckled string the beam is less exact than the analysis.
   pure function are_worth_fitting(trajectory, mesh, coiled, share) result(are)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: coiled
      real(wp), intent(in) :: share   !< >= 0 [-]
      logical :: are
      real(wp) :: left_out
      left_out = 2.0_wp*maxval(trajectory%arcs(mesh%arc(:mesh%elements))%curvature*mesh%clearance)
      are = .not. coiled .and. share > max(merge(at_edges, worth_fitting, any(near_edges(mesh))), left_out)
   end function are_worth_fitting

   !> Fit the gaps of all elements that touch by the analysis or by the beam, except contacts at a point, which have one place.
   !> Fitted gaps do not move along their element.
   pure subroutine fit_gaps(mesh, bends, beam, bent, gaps, normal, fitted)
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: bends(:)             !< elements that the beam replaces
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      type(gap_table_type), intent(in) :: gaps    !< of the analysis
      real(wp), intent(in) :: normal(:)           !< contact forces of the analysis, by element [N]
      type(fitted_gaps_type), intent(out) :: fitted
      real(wp) :: force(mesh%elements), place(mesh%elements), xi(mesh%elements), shape(4, mesh%elements), offset(2), pressed
      integer :: of(mesh%elements)                ! an element of the beam in each element of the analysis, 0: none
      type(gap_law_type) :: law
      integer :: e, o, p
      force = 0.0_wp
      place = 0.0_wp
      of = 0
      fitted%gaps = gaps
      fitted%normal = normal
      do e = 1, size(beam%element)
         o = beam%owner(e)
         of(o) = e
         do p = 1, contact_places
            pressed = max(bent%pressed(p, e), 0.0_wp)
            force(o) = force(o) + pressed
            place(o) = place(o) + pressed*(beam%md(e) + contact_xi(p)*(beam%md(e + 1) - beam%md(e)))
         end do
      end do
      xi = gaps%xi
      where (force > 0.0_wp) xi = min(max((place/force - mesh%md(:mesh%elements))/mesh%length, 0.0_wp), 1.0_wp)
      shape = shape_at(beam%md, bent%y, mesh%md(:mesh%elements) + xi*mesh%length)
      do o = 1, mesh%elements
         if (of(o) == 0 .or. .not. bends(o) .or. mesh%centralizer(o) .or. mesh%spacing(o) > 0.0_wp) cycle
         if (.not. (force(o) > 0.0_wp .or. normal(o) > 0.0_wp)) cycle
         offset = shape(1:2, o)
         if (allocated(mesh%blade)) offset = offset + beam%element(of(o))%blade
         call fix_gap(fitted%gaps, o, xi(o), merge(state_elastic, state_free, force(o) > 0.0_wp))
         law = gaps%law(o)
         law%clearance = mesh%opening(o)
         if (force(o) > 0.0_wp) then
            law%clearance = max(law%clearance + length_of(offset) - depth_of(law, force(o)), 0.0_wp)
         else
            law%clearance = max(law%clearance, length_of(offset))
         end if
         fitted%gaps%law(o) = law
         fitted%normal(o) = force(o)
      end do
   end subroutine fit_gaps
end module dg_fitted_gaps
