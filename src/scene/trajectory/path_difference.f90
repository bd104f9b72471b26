!> Distance between two paths through the same stations, at depths between the stations.
module dg_path_difference
   use dg_kinds, only: wp
   use dg_minimum_curvature, only: dogleg_between
   use dg_trajectory, only: arc_at, frame_on_arc, point_on_arc, trajectory_type
   implicit none
   private
   public :: path_difference_type, find_difference

   type :: path_difference_type
      real(wp) :: direction = 0.0_wp      !< largest angle between the tangents [rad]
      real(wp) :: direction_md = 0.0_wp   !< depth of that angle [m]
      real(wp) :: position = 0.0_wp       !< largest distance [m]
      real(wp) :: turns(2) = 0.0_wp       !< total angle by which each turns [rad]
   end type path_difference_type

contains

   !> Compare two paths at the beginnings of arcs of the first one, and at its end. The first should have the shorter arcs.
   pure function find_difference(one, other) result(difference)
      type(trajectory_type), intent(in) :: one, other
      type(path_difference_type) :: difference
      real(wp), dimension(3) :: tangent_one, tangent_other, lateral_1, lateral_2, at_one, at_other, unused
      real(wp) :: md, angle
      integer :: i, k
      k = 1
      do i = 1, size(one%arcs) + 1
         associate (arc => one%arcs(min(i, size(one%arcs))))
            md = arc%md
            if (i > size(one%arcs)) md = md + arc%length
            k = arc_at(other, md, near=k)
            call frame_on_arc(arc, md - arc%md, tangent_one, lateral_1, lateral_2)
            call frame_on_arc(other%arcs(k), md - other%arcs(k)%md, tangent_other, lateral_1, lateral_2)
            call point_on_arc(arc, md - arc%md, at_one, lateral_1, unused)
            call point_on_arc(other%arcs(k), md - other%arcs(k)%md, at_other, lateral_2, unused)
            angle = dogleg_between(tangent_one, tangent_other)
            if (angle > difference%direction) then
               difference%direction = angle
               difference%direction_md = md
            end if
            difference%position = max(difference%position, norm2(arc%origin + at_one - other%arcs(k)%origin - at_other))
         end associate
      end do
      difference%turns = [sum(one%arcs%curvature*one%arcs%length), sum(other%arcs%curvature*other%arcs%length)]
   end function find_difference
end module dg_path_difference
