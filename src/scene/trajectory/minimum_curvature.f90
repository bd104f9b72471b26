!> Minimum curvature: between two stations the hole is the circular arc that has both tangents
!> (Taylor & Mason 1972; Sawaryn & Thorogood 2005, SPE 84246).
module dg_minimum_curvature
   use dg_kinds, only: wp
   use dg_arc, only: arc_type, finish_arc, frame_on_arc
   use dg_survey, only: unit, high_side
   use dg_vector, only: cross
   implicit none
   private
   public :: dogleg_between, chain_arcs

   !> Dogleg below which two tangents differ only by round-off and the arc is straight [rad].
   real(wp), parameter :: straight_dogleg = 8.0_wp*epsilon(1.0_wp)

contains

   !> Angle between two unit vectors [rad], 0 to pi. It is accurate at both ends of that range, where the arc cosine of their
   !> product is not (half-angle form of W. Kahan).
   pure function dogleg_between(t1, t2) result(angle)
      real(wp), intent(in) :: t1(3), t2(3)
      real(wp) :: angle
      angle = 2.0_wp*atan2(sqrt(dot_product(t2 - t1, t2 - t1)), sqrt(dot_product(t2 + t1, t2 + t1)))
   end function dogleg_between

   !> Chain of arcs through unit tangents at increasing depths. The frame starts at the high side (north where
   !> vertical) and is carried without spin. The caller keeps doglegs away from pi, where no arc is defined.
   pure subroutine chain_arcs(md, tangents, arcs)
      real(wp), intent(in) :: md(:)          !< [m], at least two
      real(wp), intent(in) :: tangents(:, :) !< (3, size(md)), unit
      type(arc_type), intent(out) :: arcs(:) !< (size(md) - 1)
      real(wp) :: origin(3), lateral(3), t(3), other(3)
      integer :: i
      origin = 0.0_wp
      lateral = high_side(tangents(:, 1))
      do i = 1, size(arcs)
         ! Each arc starts at its station's own tangent, so that round-off does not add up along the chain.
         t = tangents(:, i)
         arcs(i)%md = md(i)
         arcs(i)%length = md(i + 1) - md(i)
         arcs(i)%origin = origin
         arcs(i)%tangent = t
         arcs(i)%lateral_1 = unit(lateral - dot_product(lateral, t)*t)
         arcs(i)%lateral_2 = cross(t, arcs(i)%lateral_1)
         call bend(arcs(i), tangents(:, i + 1))
         call finish_arc(arcs(i))
         call frame_on_arc(arcs(i), arcs(i)%length, t, lateral, other)
         origin = origin + arcs(i)%chord
      end do
   end subroutine chain_arcs

   !> Set curvature and normal of an arc from the tangent at its end.
   pure subroutine bend(arc, end_tangent)
      type(arc_type), intent(inout) :: arc
      real(wp), intent(in) :: end_tangent(3)
      real(wp) :: dogleg, difference(3)
      dogleg = dogleg_between(arc%tangent, end_tangent)
      if (dogleg <= straight_dogleg) then
         arc%curvature = 0.0_wp
         arc%normal = arc%lateral_1
         return
      end if
      arc%curvature = dogleg/arc%length
      ! The difference of the tangents is accurate where they nearly agree; its own part along the tangent
      ! is -|difference|^2/2.
      difference = end_tangent - arc%tangent
      difference = unit(difference + 0.5_wp*dot_product(difference, difference)*arc%tangent)
      arc%normal = unit(difference - dot_product(difference, arc%tangent)*arc%tangent)
   end subroutine bend
end module dg_minimum_curvature
