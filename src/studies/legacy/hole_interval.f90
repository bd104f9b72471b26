!> The kinds of hole along a trajectory: vertical, build, hold, drop, turn.
module dg_hole_interval
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_trajectory, only: inclination_of, point_on_arc, trajectory_type
   implicit none
   private
   public :: interval_type, hole_intervals, interval_at, interval_name
   public :: interval_vertical, interval_build, interval_hold, interval_drop, interval_turn

   integer, parameter :: interval_vertical = 1
   integer, parameter :: interval_build = 2
   integer, parameter :: interval_hold = 3
   integer, parameter :: interval_drop = 4
   integer, parameter :: interval_turn = 5   !< azimuth changes, inclination does not
   character(*), parameter :: interval_name(5) = [character(8) :: 'vertical', 'build', 'hold', 'drop', 'turn']

   type :: interval_type
      integer :: kind = interval_hold
      real(wp) :: md_top = 0.0_wp      !< [m]
      real(wp) :: md_bottom = 0.0_wp   !< [m]
   end type interval_type

   !> Largest inclination of a vertical hole [rad], and largest rate of a hold section [rad/m]. Surveys scatter by some tenths
   !> of a degree.
   real(wp), parameter :: vertical = 1.0_wp*degree
   real(wp), parameter :: held = 0.25_wp*degree/30.0_wp

contains

   !> Intervals of one kind from the top down to a depth.
   pure function hole_intervals(trajectory, bottom) result(intervals)
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(in) :: bottom   !< [m]
      type(interval_type), allocatable :: intervals(:)
      type(interval_type), allocatable :: found(:)
      integer :: i, n, kind
      allocate (found(size(trajectory%arcs)))
      n = 0
      do i = 1, size(trajectory%arcs)
         associate (arc => trajectory%arcs(i))
            if (arc%md >= bottom .and. n > 0) exit
            kind = kind_of(trajectory, i)
            if (n == 0) then
               n = 1
               found(1) = interval_type(kind, arc%md, arc%md)
            else if (kind /= found(n)%kind) then
               n = n + 1
               found(n) = interval_type(kind, arc%md, arc%md)
            end if
            found(n)%md_bottom = min(arc%md + arc%length, bottom)
         end associate
      end do
      allocate (intervals(n))
      intervals = found(:n)
   end function hole_intervals

   !> Kind of one arc of the trajectory.
   pure function kind_of(trajectory, i) result(kind)
      type(trajectory_type), intent(in) :: trajectory
      integer, intent(in) :: i
      integer :: kind
      real(wp) :: position(3), tangent(3), curvature(3), upper, lower, rate
      associate (arc => trajectory%arcs(i))
         call point_on_arc(arc, arc%length, position, tangent, curvature)
         upper = inclination_of(arc%tangent)
         lower = inclination_of(tangent)
         rate = (lower - upper)/arc%length
         if (max(upper, lower) <= vertical) then
            kind = interval_vertical
         else if (rate > held) then
            kind = interval_build
         else if (rate < -held) then
            kind = interval_drop
         else if (arc%curvature > held) then
            kind = interval_turn
         else
            kind = interval_hold
         end if
      end associate
   end function kind_of

   !> Number of the interval that holds a depth; at a joint the lower one.
   pure function interval_at(intervals, md) result(number)
      type(interval_type), intent(in) :: intervals(:)
      real(wp), intent(in) :: md   !< [m]
      integer :: number
      number = max(1, count(intervals%md_top <= md))
   end function interval_at
end module dg_hole_interval
