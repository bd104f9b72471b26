!> Survey angles and directions. Frame: x north, y east, z down; a tangent points down the hole. All other code works with unit
!> vectors. A vertical hole, a hole past 90 deg and an azimuth passing north thus need no special cases. Only decks and tables
!> have angles.
module dg_survey
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_error, only: error_type, raise, status_bad_input
   use dg_vector, only: cross
   implicit none
   private
   public :: check_stations, turn_between, tangent_of, inclination_of, azimuth_of, high_side, clock_angle, unit, north

   !> Unit vector to the north.
   real(wp), parameter :: north(3) = [1.0_wp, 0.0_wp, 0.0_wp]
   !> Sine of the inclination below which a hole has no high side [-]. It is well above the round-off of a tangent (1e-16), and
   !> far below the resolution of survey tools (1e-3).
   real(wp), parameter :: vertical_sine = 1.0e-9_wp
   !> Angles closer than this to a full turn are printed as 0: ten digits show them as one turn [rad].
   real(wp), parameter :: no_angle = 1.0e-9_wp
   !> Excess of an inclination over pi that is only the round-off of a conversion from degrees [rad].
   real(wp), parameter :: angle_round_off = 1.0e-12_wp

contains

   !> Refuse invalid stations: fewer than two, sizes that differ, numbers that are not finite. Measured depths must increase,
   !> and inclinations be from 0 to pi.
   pure subroutine check_stations(md, inclination, azimuth, error)
      real(wp), intent(in) :: md(:)           !< [m]
      real(wp), intent(in) :: inclination(:)  !< [rad]
      real(wp), intent(in) :: azimuth(:)      !< [rad]
      type(error_type), allocatable, intent(out) :: error
      character(64) :: place
      integer :: i
      if (size(inclination) /= size(md) .or. size(azimuth) /= size(md)) then
         call raise(error, status_bad_input, 'survey: md, inc and azi must have the same number of stations')
         return
      end if
      if (size(md) < 2) then
         call raise(error, status_bad_input, 'survey: at least two stations are needed')
         return
      end if
      do i = 1, size(md)
         if (.not. all(ieee_is_finite([md(i), inclination(i), azimuth(i)]))) then
            write (place, '(a,i0)') 'survey: station ', i
            call raise(error, status_bad_input, trim(place)//' holds a number that is not finite')
            return
         end if
         if (inclination(i) < 0.0_wp .or. inclination(i) > pi + angle_round_off) then
            write (place, '(a,i0,a,g0.8,a)') 'survey: station ', i, ' at ', md(i), ' m'
            call raise(error, status_bad_input, trim(place)//': inclination must lie between 0 and 180 deg')
            return
         end if
      end do
      do i = 2, size(md)
         if (md(i) > md(i - 1)) cycle
         write (place, '(a,i0,a,g0.8,a)') 'survey: station ', i, ' at ', md(i), ' m'
         call raise(error, status_bad_input, trim(place)//': measured depth must increase from station to station')
         return
      end do
   end subroutine check_stations

   !> Unit tangent from inclination and azimuth [rad].
   pure function tangent_of(inclination, azimuth) result(tangent)
      real(wp), intent(in) :: inclination  !< from vertical [rad]
      real(wp), intent(in) :: azimuth      !< from north, clockwise seen from above [rad]
      real(wp) :: tangent(3)
      tangent = [sin(inclination)*cos(azimuth), sin(inclination)*sin(azimuth), cos(inclination)]
      tangent = unit(tangent)
   end function tangent_of

   !> Inclination of a tangent [rad], 0 to pi.
   pure function inclination_of(tangent) result(inclination)
      real(wp), intent(in) :: tangent(3)
      real(wp) :: inclination
      inclination = atan2(hypot(tangent(1), tangent(2)), tangent(3))
   end function inclination_of

   !> Azimuth of a tangent [rad], 0 <= azimuth < 2 pi; 0 where the hole is vertical.
   pure function azimuth_of(tangent) result(azimuth)
      real(wp), intent(in) :: tangent(3)
      real(wp) :: azimuth
      azimuth = 0.0_wp
      if (hypot(tangent(1), tangent(2)) <= vertical_sine) return
      azimuth = positive_angle(atan2(tangent(2), tangent(1)))
   end function azimuth_of

   !> Unit vector across the hole from which clock angles count. It points to the high side, or to the north where the hole is
   !> vertical.
   pure function high_side(tangent) result(direction)
      real(wp), intent(in) :: tangent(3)
      real(wp) :: direction(3)
      real(wp) :: sine
      sine = hypot(tangent(1), tangent(2))
      if (sine > vertical_sine) then
         direction = [tangent(3)*tangent(1)/sine, tangent(3)*tangent(2)/sine, -sine]
      else
         direction = north - dot_product(north, tangent)*tangent
      end if
      direction = unit(direction)
   end function high_side

   !> Clock angle of a vector across the hole, from the high side (north where vertical), clockwise looking down the hole
   !> [rad]. 0 <= angle < 2 pi. It is 0 for a vector without length, and for one that round-off puts just before the high side.
   pure function clock_angle(tangent, vector) result(angle)
      real(wp), intent(in) :: tangent(3)
      real(wp), intent(in) :: vector(3)
      real(wp) :: angle
      real(wp) :: up(3), x, y
      up = high_side(tangent)
      x = dot_product(vector, up)
      y = dot_product(vector, cross(tangent, up))
      angle = 0.0_wp
      if (hypot(x, y) > tiny(x)) angle = positive_angle(atan2(y, x))
      if (2.0_wp*pi - angle < no_angle) angle = 0.0_wp
   end function clock_angle

   !> Angle of -pi to pi as one of 0 to 2 pi [rad]. A tiny negative one becomes 0, never 2 pi.
   pure function positive_angle(angle) result(positive)
      real(wp), intent(in) :: angle
      real(wp) :: positive
      positive = angle
      if (angle < 0.0_wp) positive = angle + 2.0_wp*pi
      if (positive >= 2.0_wp*pi) positive = 0.0_wp
   end function positive_angle

   !> A vector scaled to length one; it must have a length.
   pure function unit(a) result(scaled)
      real(wp), intent(in) :: a(3)
      real(wp) :: scaled(3)
      scaled = a/sqrt(dot_product(a, a))
   end function unit

   !> Difference of two azimuths, from -pi to pi [rad].
   elemental function turn_between(one, other) result(turn)
      real(wp), intent(in) :: one, other
      real(wp) :: turn
      turn = modulo(one - other + pi, 2.0_wp*pi) - pi
   end function turn_between
end module dg_survey
