!> Contact of pipe on centralizers, and the part of the body where it sags to the wall between two of them.
!>
!> Spans of a long row are clamped by symmetry. Under a load q per length the body sags by
!>
!>   d = q L^4/(384 E I (1 + T/T_c)),   T_c = 4 pi^2 E I/L^2,
!>
!> Tension T stiffens it. T_c is the buckling load of clamped columns, and the formula is within 2 % of the closed form up to
!> T = 2 T_c. The centralizers hold it off the wall by h. With d > h it touches at mid-span with (1 - h/d)/2 of the load of the
!> span, like a clamped beam on a third support. From d = 3 h on it lies on the wall, and the centralizers carry x = 4/3
!> (3 h/(16 d))^(1/4). There d has the free length, 3/2 x L, in T_c. A bow yields by C times its load: h = g - C (1 - share).
module dg_centralized_contact
   use dg_kinds, only: wp
   use dg_centralizer, only: bow_opening, bow_stiffness
   use dg_component, only: bending_stiffness, centralizer_diameter, component_type
   use dg_constants, only: pi
   implicit none
   private
   public :: spans_type, spans_of, body_share

   !> Spans between the centralizers of a component.
   type :: spans_type
      logical :: present = .false.
      real(wp) :: length = 0.0_wp      !< L [m]
      real(wp) :: stiffness = 0.0_wp   !< E I of the body [N.m2]
      real(wp) :: room = 0.0_wp        !< g: height of the body above the wall at an unloaded centralizer [m]
      real(wp) :: yielding = 0.0_wp    !< C over load per length: span over stiffness of a bow; rigid: 0 [m2/N]
   end type spans_type

   !> Part of T_c in compression at which a span counts as buckled against the wall [-].
   real(wp), parameter :: nearly = 0.999_wp
   !> Number of halvings of the centralizers' part.
   integer, parameter :: halvings = 30

contains

   !> Spans of a component in a hole.
   pure function spans_of(component, hole, clearance) result(spans)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: hole        !< diameter [m]
      real(wp), intent(in) :: clearance   !< of the body [m]
      type(spans_type) :: spans
      spans%present = component%centralizer%present
      if (.not. spans%present) return
      spans%length = component%centralizer%spacing
      spans%stiffness = bending_stiffness(component)
      spans%room = clearance - 0.5_wp*(hole - centralizer_diameter(component))
      if (.not. component%centralizer%bow) return
      spans%room = clearance - min(clearance, bow_opening(component%centralizer, hole))
      spans%yielding = spans%length/bow_stiffness(component%centralizer, component%od)
   end function spans_of

   !> Part of the contact that the body carries [-].
   elemental function body_share(spans, load, axial) result(share)
      type(spans_type), intent(in) :: spans
      real(wp), intent(in) :: load    !< across the hole, >= 0 [N/m]
      real(wp), intent(in) :: axial   !< effective, tension > 0 [N]
      real(wp) :: share
      real(wp) :: sag, touching, tight, yielded, low, high, middle
      integer :: i
      yielded = spans%yielding*load
      tight = axial*(0.5_wp*spans%length/pi)**2/spans%stiffness
      sag = load*spans%length**4/(384.0_wp*spans%stiffness)
      touching = sag/(1.0_wp + max(tight, -nearly))
      share = 0.0_wp
      if (touching + yielded > spans%room) share = (touching + yielded - spans%room)/(2.0_wp*touching + yielded)
      if (3.0_wp*share <= 1.0_wp) return
      low = 0.0_wp
      high = 2.0_wp/3.0_wp
      if (tight < 0.0_wp) high = min(high, 2.0_wp/3.0_wp*sqrt(-nearly/tight))
      do i = 1, halvings
         middle = 0.5_wp*(low + high)
         if (27.0_wp/16.0_wp*sag*middle**4/(1.0_wp + 2.25_wp*tight*middle**2) + yielded*middle < spans%room) then
            low = middle
         else
            high = middle
         end if
      end do
      share = 1.0_wp - low
   end function body_share
end module dg_centralized_contact
