!> Buckled shape of a string by beams, from its angle about the hole. Sinusoidal: the angle swings back and forth within about
!> the length of a buckling wave. Helical: the angle grows without return, about as fast as in a free helix. Without enough
!> compression to buckle it is neither: then the angle follows a hole that turns from station to station.
module dg_buckled_shape
   use dg_kinds, only: wp
   use dg_buckling_limits, only: buckling_helical, buckling_none, buckling_sinusoidal
   use dg_constants, only: pi
   use dg_missing, only: given, optional_real
   implicit none
   private
   public :: find_buckled_shape, span_of

   !> Least distance from the axis, over the clearance, at which a node has an angle about it [-].
   real(wp), parameter :: off_axis = 0.2_wp
   !> Swings below this angle are ignored [rad].
   real(wp), parameter :: least_swing = 0.05_wp
   !> Longest swing over half a wave pi sqrt(2 EI/F) [-]. A longer change of sides is due to a hole that turns.
   real(wp), parameter :: longest_swing = 2.5_wp
   !> Least compression of a buckled swing or coil over the sinusoidal load [-]. It must be reached over half of a swing's
   !> length or half of a coil's turns. Sinusoids begin at 0.97 to 1.06 of that load.
   real(wp), parameter :: enough = 0.95_wp
   !> A coil begins and ends where it turns at this part of the rate of a free helix, sqrt(F/(2 EI)) [-]. Beyond its ends the
   !> string lies along the low side, or climbs the wall of a bend.
   real(wp), parameter :: least_rate = 0.4_wp

contains

   !> Find the state of every row (buckling_none, ...) and the turns of all coils [-].
   pure subroutine find_buckled_shape(md, axial, off, clock, ei, critical, shape, turns)
      real(wp), intent(in) :: md(:)      !< [m]
      real(wp), intent(in) :: axial(:)   !< tension > 0 [N]
      real(wp), intent(in) :: off(:)     !< distance from the hole axis over the clearance [-]
      real(wp), intent(in) :: clock(:)   !< angle about the hole axis [rad]
      real(wp), intent(in) :: ei(:)      !< bending stiffness [N.m2]
      real(wp), intent(in) :: critical(:) !< compression at sinusoidal buckling; missing where any compression makes it buckle [N]
      integer, intent(out) :: shape(:)
      real(wp), intent(out) :: turns
      integer :: first, last
      shape = buckling_none
      turns = 0.0_wp
      first = 1
      do while (first <= size(md))
         last = first
         if (lies(first)) then
            do while (last < size(md))
               if (.not. lies(last + 1)) exit
               last = last + 1
            end do
            if (last > first) call look_at(md(first:last), axial(first:last), clock(first:last), ei(first:last), &
                                           -axial(first:last) >= enough*max(critical(first:last), 0.0_wp), shape(first:last), turns)
         end if
         first = last + 1
      end do

   contains

      !> True if a row is compressed, and off the axis.
      pure function lies(i) result(yes)
         integer, intent(in) :: i
         logical :: yes
         yes = axial(i) < 0.0_wp .and. off(i) > off_axis
      end function lies
   end subroutine find_buckled_shape

   !> Find the state of string that is compressed and off the axis throughout, from turning point to turning point of its
   !> angle.
   pure subroutine look_at(md, axial, clock, ei, pressed, shape, turns)
      real(wp), intent(in) :: md(:), axial(:), clock(:), ei(:)
      logical, intent(in) :: pressed(:)   !< true if compressed enough to buckle
      integer, intent(inout) :: shape(:)
      real(wp), intent(inout) :: turns
      real(wp) :: angle(size(md)), swing, wave
      integer :: pivots(size(md) + 1), i, n, extreme, from, to
      logical :: waves, winding(size(md))
      angle(1) = 0.0_wp
      do i = 2, size(md)
         angle(i) = angle(i - 1) + modulo(clock(i) - clock(i - 1) + pi, 2.0_wp*pi) - pi
      end do
      winding = winds(md, angle, -axial, ei)
      n = 1
      pivots(1) = 1
      extreme = 1
      do i = 2, size(md)
         swing = angle(extreme) - angle(pivots(n))
         if ((angle(i) - angle(extreme))*sign(1.0_wp, swing) >= 0.0_wp) then
            extreme = i
         else if (abs(angle(i) - angle(extreme)) > least_swing) then
            if (abs(swing) > least_swing) then
               n = n + 1
               pivots(n) = extreme
            end if
            extreme = i
         end if
      end do
      n = n + 1
      pivots(n) = size(md)
      do i = 1, n - 1
         from = pivots(i)
         to = pivots(i + 1)
         swing = abs(angle(to) - angle(from))
         if (swing >= 2.0_wp*pi) then
            if (.not. (any(winding(from:to)) .and. mostly(angle(from:to), pressed(from:to)))) cycle
            to = from - 1 + findloc(winding(from:to), .true., dim=1, back=.true.)
            from = from + findloc(winding(from:to), .true., dim=1) - 1
            swing = abs(angle(to) - angle(from))
            if (swing < 2.0_wp*pi) cycle
            turns = turns + swing/(2.0_wp*pi)
            shape(from:to) = buckling_helical
            cycle
         end if
         wave = pi*sqrt(2.0_wp*maxval(ei(from:to))/maxval(-axial(from:to)))
         waves = n > 2 .and. swing > least_swing .and. md(to) - md(from) < longest_swing*wave
         if (waves) waves = mostly(md(from:to), pressed(from:to))
         if (waves) shape(from:to) = max(shape(from:to), buckling_sinusoidal)
      end do
   end subroutine look_at

   !> True for rows where the string turns as fast as a coil, from the row above to the row below.
   pure function winds(md, angle, compression, ei) result(fast)
      real(wp), intent(in) :: md(:)            !< [m]
      real(wp), intent(in) :: angle(:)         !< without jumps [rad]
      real(wp), intent(in) :: compression(:)   !< > 0 [N]
      real(wp), intent(in) :: ei(:)            !< [N.m2]
      logical :: fast(size(md))
      integer :: i, from, to
      do i = 1, size(md)
         from = max(i - 1, 1)
         to = min(i + 1, size(md))
         fast(i) = abs(angle(to) - angle(from)) >= least_rate*sqrt(0.5_wp*compression(i)/ei(i))*(md(to) - md(from))
      end do
   end function winds

   !> True if `holds` is true over half of the total change of a number from row to row. A step between two rows counts by half
   !> for each.
   pure function mostly(number, holds) result(yes)
      real(wp), intent(in) :: number(:)   !< depth of a swing [m], or angle of a coil [rad]
      logical, intent(in) :: holds(:)
      logical :: yes
      real(wp) :: held, way
      integer :: i
      held = 0.0_wp
      way = 0.0_wp
      do i = 2, size(number)
         held = held + 0.5_wp*count(holds(i - 1:i))*abs(number(i) - number(i - 1))
         way = way + abs(number(i) - number(i - 1))
      end do
      yes = held >= 0.5_wp*way
   end function mostly

   !> First and last depth where something is true.
   pure function span_of(true_there, md) result(span)
      logical, intent(in) :: true_there(:)
      real(wp), intent(in) :: md(:)          !< as many [m]
      type(optional_real) :: span(2)
      if (.not. any(true_there)) return
      span(1) = given(minval(md, mask=true_there))
      span(2) = given(maxval(md, mask=true_there))
   end function span_of
end module dg_buckled_shape
