!> The hole axis as a chain of circular arcs, for any interpolation between survey stations. Frame: x north, y east, z down,
!> origin at the first station. Measured depth s grows down the hole.
module dg_trajectory
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_error, only: error_type, raise, status_bad_input
   use dg_arc, only: arc_type, finish_arc, foot_offset, foot_on_arc, frame_on_arc, point_on_arc, turn_of, turn_type
   use dg_minimum_curvature, only: chain_arcs, dogleg_between
   use dg_spline_path, only: resample_spline
   use dg_survey, only: check_stations, tangent_of, inclination_of, azimuth_of, high_side, clock_angle
   implicit none
   private
   public :: trajectory_type, new_trajectory, interpolation_minimum_curvature, interpolation_spline
   public :: cut_trajectory, arc_at, closest_point, gap_to_axis, position_at
   public :: true_vertical_depth, measured_depth_at, top_md, bottom_md
   ! Public names of this folder that users of a trajectory also need.
   public :: arc_type, point_on_arc, frame_on_arc, foot_offset, turn_type, turn_of
   public :: tangent_of, inclination_of, azimuth_of, high_side, clock_angle

   integer, parameter :: interpolation_minimum_curvature = 1
   integer, parameter :: interpolation_spline = 2

   !> Largest angle between two stations [rad]. Towards 180 deg the plane of the arc is lost.
   real(wp), parameter :: largest_dogleg = 170.0_wp*degree

   !> Number of parts of an arc in the search of a true vertical depth.
   integer, parameter :: pieces = 16

   type :: trajectory_type
      real(wp), allocatable :: md(:)           !< stations as given [m]
      real(wp), allocatable :: inclination(:)  !< stations as given [rad]
      real(wp), allocatable :: azimuth(:)      !< stations as given [rad]
      type(arc_type), allocatable :: arcs(:)   !< from the first station to the last
   end type trajectory_type

contains

   !> Make a trajectory through survey stations. Refused (bad input): faults of check_stations, a dogleg above 170 deg between
   !> two stations.
   pure subroutine new_trajectory(self, md, inclination, azimuth, interpolation, error)
      type(trajectory_type), intent(out) :: self
      real(wp), intent(in) :: md(:)           !< increasing [m]
      real(wp), intent(in) :: inclination(:)  !< 0 to pi [rad]
      real(wp), intent(in) :: azimuth(:)      !< [rad]
      integer, intent(in) :: interpolation    !< one of the numbers above
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: tangents(:, :), fine_md(:), fine_tangents(:, :)
      character(120) :: place
      logical :: usable
      integer :: i
      call check_stations(md, inclination, azimuth, error)
      if (allocated(error)) return
      allocate (tangents(3, size(md)))
      do i = 1, size(md)
         tangents(:, i) = tangent_of(inclination(i), azimuth(i))
      end do
      do i = 2, size(md)
         if (dogleg_between(tangents(:, i - 1), tangents(:, i)) <= largest_dogleg) cycle
         write (place, '(a,g0.8,a,g0.8,a)') 'survey: between ', md(i - 1), ' and ', md(i), ' m'
         call raise(error, status_bad_input, trim(place)// &
                    ' the hole turns by more than 170 deg, so that no arc is defined; add a station between')
         return
      end do
      self%md = md
      self%inclination = inclination
      self%azimuth = azimuth
      if (interpolation == interpolation_spline) then
         call resample_spline(md, tangents, fine_md, fine_tangents, usable)
         if (.not. usable) then
            call raise(error, status_bad_input, 'survey: stations turn too sharply for a spline; '// &
                       "add stations or use interpolation = 'minimum_curvature'")
            return
         end if
         allocate (self%arcs(size(fine_md) - 1))
         call chain_arcs(fine_md, fine_tangents, self%arcs)
      else
         allocate (self%arcs(size(md) - 1))
         call chain_arcs(md, tangents, self%arcs)
      end if
   end subroutine new_trajectory

   !> The part of a trajectory below a depth, at which its first station then is. Positions still count from the first station
   !> of the whole.
   pure subroutine cut_trajectory(trajectory, md, below)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: md                       !< between its first and its last station [m]
      type(trajectory_type), intent(out) :: below
      real(wp) :: position(3), tangent(3), curvature(3)
      integer :: first
      first = arc_at(trajectory, md)
      below%arcs = trajectory%arcs(first:)
      associate (arc => below%arcs(1), whole => trajectory%arcs(first))
         call point_on_arc(whole, md - whole%md, position, tangent, curvature)
         arc%md = md
         arc%length = whole%md + whole%length - md
         arc%origin = whole%origin + position
         if (whole%curvature > 0.0_wp) arc%normal = curvature/whole%curvature
         call frame_on_arc(whole, md - whole%md, arc%tangent, arc%lateral_1, arc%lateral_2)
         call finish_arc(arc)
         below%md = [md, pack(trajectory%md, trajectory%md > md)]
         below%inclination = [inclination_of(arc%tangent), pack(trajectory%inclination, trajectory%md > md)]
         below%azimuth = [azimuth_of(arc%tangent), pack(trajectory%azimuth, trajectory%md > md)]
      end associate
   end subroutine cut_trajectory

   !> Measured depth of the first station [m].
   pure function top_md(trajectory) result(md)
      type(trajectory_type), intent(in) :: trajectory
      real(wp) :: md
      md = trajectory%md(1)
   end function top_md

   !> Measured depth of the last station [m].
   pure function bottom_md(trajectory) result(md)
      type(trajectory_type), intent(in) :: trajectory
      real(wp) :: md
      md = trajectory%md(size(trajectory%md))
   end function bottom_md

   !> Index of the arc that holds a measured depth [m]; at a joint the lower one, outside the first or last.
   pure function arc_at(trajectory, md, near) result(index)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: md
      integer, intent(in), optional :: near   !< a near arc, from which the search starts
      integer :: index
      integer :: above, middle
      if (present(near)) then
         index = near
         do while (index > 1 .and. trajectory%arcs(index)%md > md)
            index = index - 1
         end do
         do while (index < size(trajectory%arcs))
            if (trajectory%arcs(index + 1)%md > md) exit
            index = index + 1
         end do
         return
      end if
      index = 1
      above = size(trajectory%arcs) + 1
      do while (above - index > 1)
         middle = (index + above)/2
         if (trajectory%arcs(middle)%md <= md) then
            index = middle
         else
            above = middle
         end if
      end do
   end function arc_at

   !> Foot of the perpendicular from a point on the hole axis, as by gap_to_axis, and its place along the hole.
   pure subroutine closest_point(trajectory, index, point, offset, gap, tangent, curvature)
      type(trajectory_type), intent(in) :: trajectory
      integer, intent(inout) :: index
      real(wp), intent(inout) :: point(3)
      real(wp), intent(out) :: offset           !< of the foot from the start of arc `index` [m]
      real(wp), intent(out) :: gap(3), tangent(3), curvature(3)
      call gap_to_axis(trajectory, index, point, gap, tangent, curvature)
      offset = foot_offset(trajectory%arcs(index), point)
   end subroutine closest_point

   !> Offset of a point from the hole axis: across the tangent at the foot of the perpendicular. Beyond its ends the axis goes
   !> on as the circles (or lines) of its first and last arc. The search starts at the arc `index`, so that a caller who keeps
   !> the index needs one arc.
   pure subroutine gap_to_axis(trajectory, index, point, gap, tangent, curvature)
      type(trajectory_type), intent(in) :: trajectory
      integer, intent(inout) :: index           !< arc to start from; on return the one that holds the foot
      real(wp), intent(inout) :: point(3)       !< relative to the origin of arc `index` [m], before and after
      real(wp), intent(out) :: gap(3)           !< from the foot to the point, across the tangent [m]
      real(wp), intent(out) :: tangent(3)       !< unit, at the foot
      real(wp), intent(out) :: curvature(3)     !< dt/ds at the foot [1/m]
      integer :: direction, beyond
      direction = 0
      do
         call foot_on_arc(trajectory%arcs(index), point, gap, tangent, curvature, beyond)
         ! A foot within round-off of a joint, or a point beyond the centre of a bend, would alternate between two arcs. Once
         ! moved one way, never go back.
         if (beyond == 0 .or. beyond*direction < 0) return
         if (index + beyond < 1 .or. index + beyond > size(trajectory%arcs)) return
         direction = beyond
         if (beyond > 0) then
            point = point - trajectory%arcs(index)%chord
            index = index + 1
         else
            index = index - 1
            point = point + trajectory%arcs(index)%chord
         end if
      end do
   end subroutine gap_to_axis

   !> Position, north-east-down from the first station [m], and unit tangent at a measured depth [m].
   pure subroutine position_at(trajectory, md, position, tangent)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: md
      real(wp), intent(out) :: position(3)
      real(wp), intent(out) :: tangent(3)
      real(wp) :: curvature(3)
      integer :: index
      index = arc_at(trajectory, md)
      call point_on_arc(trajectory%arcs(index), md - trajectory%arcs(index)%md, position, tangent, curvature)
      position = trajectory%arcs(index)%origin + position
   end subroutine position_at

   !> True vertical depth below the first station [m] at a measured depth [m].
   pure function true_vertical_depth(trajectory, md) result(tvd)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: md
      real(wp) :: tvd
      real(wp) :: position(3), tangent(3)
      call position_at(trajectory, md, position, tangent)
      tvd = position(3)
   end function true_vertical_depth

   !> Least measured depth [m] at which the hole reaches a true vertical depth below the first station [m]; huge if it does
   !> not.
   pure function measured_depth_at(trajectory, tvd) result(md)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: tvd
      real(wp) :: md
      real(wp) :: low, high
      integer :: i, k
      if (tvd <= 0.0_wp) then
         md = top_md(trajectory)
         return
      end if
      do i = 1, size(trajectory%arcs)
         associate (arc => trajectory%arcs(i))
            do k = 1, pieces       ! a bend past 90 deg comes up again
               high = arc%md + arc%length*k/pieces
               if (true_vertical_depth(trajectory, high) < tvd) cycle
               low = arc%md + arc%length*(k - 1)/pieces
               do
                  md = 0.5_wp*(low + high)
                  if (md <= low .or. md >= high) exit
                  if (true_vertical_depth(trajectory, md) < tvd) then
                     low = md
                  else
                     high = md
                  end if
               end do
               md = high
               return
            end do
         end associate
      end do
      md = huge(md)
   end function measured_depth_at
end module dg_trajectory
