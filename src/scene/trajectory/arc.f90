!> One circular arc of the hole axis in closed form. A straight line is the arc of curvature zero.
!>
!> Positions are relative to the start of the arc. Near the bit of a long well absolute coordinates have lost five digits,
!> which gaps of micrometres need. No formula below has cancellation. The chord of an arc of angle 2 h has the length s
!> sin(h)/h and points along the tangent turned by h.
module dg_arc
   use dg_kinds, only: wp
   use dg_vector, only: cross
   implicit none
   private
   public :: arc_type, finish_arc, point_on_arc, frame_on_arc, foot_on_arc, foot_offset
   public :: turn_type, turn_of

   type :: arc_type
      real(wp) :: md = 0.0_wp            !< measured depth at its start [m]
      real(wp) :: length = 0.0_wp        !< [m]
      real(wp) :: origin(3) = 0.0_wp     !< position of its start, north-east-down from the first station [m]
      real(wp) :: tangent(3) = 0.0_wp    !< unit, at its start
      real(wp) :: normal(3) = 0.0_wp     !< unit, at its start, towards the centre; where straight any perpendicular
      real(wp) :: curvature = 0.0_wp     !< >= 0 [1/m]
      real(wp) :: lateral_1(3) = 0.0_wp  !< rotation-minimising frame at its start, unit
      real(wp) :: lateral_2(3) = 0.0_wp  !< tangent x lateral_1
      ! derived from these: finish_arc
      real(wp) :: binormal(3) = 0.0_wp   !< tangent x normal
      real(wp) :: chord(3) = 0.0_wp      !< from its start to its end [m]
      real(wp) :: end_sine = 0.0_wp, end_cosine = 1.0_wp   !< of the angle of the arc
   end type arc_type

   !> A step along an arc towards its start, to be repeated. Tangent t and normal n become cosine t - sine n and cosine n +
   !> sine t.
   type :: turn_type
      real(wp) :: sine = 0.0_wp, cosine = 1.0_wp   !< of the angle turned
      real(wp) :: along = 0.0_wp, inward = 0.0_wp  !< chord of the step, from its end to its begin, along tangent and normal there
                                                   !< [m]
   end type turn_type

   !> Angle [rad], curvature [1/m] or ratio [-] below which sin(x)/x and atan(x)/x are one to the last bit. A quotient of two
   !> such numbers might underflow. Above it the plain quotients are accurate to round-off.
   real(wp), parameter :: vanishing = 1.0e-100_wp

contains

   !> Set the components that follow from an arc's length, curvature, tangent and normal.
   pure subroutine finish_arc(arc)
      type(arc_type), intent(inout) :: arc
      real(wp) :: tangent(3), curvature(3)
      arc%binormal = cross(arc%tangent, arc%normal)
      call point_on_arc(arc, arc%length, arc%chord, tangent, curvature)
      arc%end_sine = sin(arc%curvature*arc%length)
      arc%end_cosine = cos(arc%curvature*arc%length)
   end subroutine finish_arc

   !> Point, unit tangent and curvature vector dt/ds of an arc. `offset` may be outside the arc: the circle goes on.
   pure subroutine point_on_arc(arc, offset, position, tangent, curvature)
      type(arc_type), intent(in) :: arc
      real(wp), intent(in) :: offset         !< along the arc from its start [m]
      real(wp), intent(out) :: position(3)   !< relative to arc%origin [m]
      real(wp), intent(out) :: tangent(3)
      real(wp), intent(out) :: curvature(3)  !< [1/m]
      real(wp) :: half, sine, cosine, full_sine, full_cosine
      if (.not. arc%curvature > 0.0_wp) then
         position = offset*arc%tangent
         tangent = arc%tangent
         curvature = 0.0_wp
         return
      end if
      half = 0.5_wp*arc%curvature*offset
      sine = sin(half)
      cosine = cos(half)
      position = chord_of(half, sine, offset)*(cosine*arc%tangent + sine*arc%normal)
      full_sine = 2.0_wp*sine*cosine
      full_cosine = 1.0_wp - 2.0_wp*sine*sine
      tangent = full_cosine*arc%tangent + full_sine*arc%normal
      curvature = arc%curvature*(full_cosine*arc%normal - full_sine*arc%tangent)
   end subroutine point_on_arc

   !> Step of a given length of an arc, whose angle is 0.02 or less. Sine and cosine of its half are a few terms of their
   !> series. The error is below 0.01^8/8 factorial, which is 3e-21.
   pure function turn_of(arc, length) result(turn)
      type(arc_type), intent(in) :: arc
      real(wp), intent(in) :: length   !< > 0 [m]
      type(turn_type) :: turn
      real(wp) :: half, square, ratio, sine, cosine
      half = 0.5_wp*arc%curvature*length
      square = half*half
      ratio = 1.0_wp - square/6.0_wp*(1.0_wp - square/20.0_wp*(1.0_wp - square/42.0_wp))     ! sine over angle
      sine = half*ratio
      cosine = 1.0_wp - 0.5_wp*square*(1.0_wp - square/12.0_wp*(1.0_wp - square/30.0_wp))
      turn%sine = 2.0_wp*sine*cosine
      turn%cosine = 1.0_wp - 2.0_wp*sine*sine
      turn%along = length*ratio*cosine
      turn%inward = -length*ratio*sine
   end function turn_of

   !> Rotation-minimising frame of an arc: its frame at the start turned about the binormal, exactly. Also the point, as by
   !> point_on_arc, if present.
   pure subroutine frame_on_arc(arc, offset, tangent, lateral_1, lateral_2, position)
      type(arc_type), intent(in) :: arc
      real(wp), intent(in) :: offset         !< along the arc from its start [m]
      real(wp), intent(out) :: tangent(3)
      real(wp), intent(out) :: lateral_1(3)
      real(wp), intent(out) :: lateral_2(3)  !< tangent x lateral_1
      real(wp), intent(out), optional :: position(3)   !< relative to arc%origin [m]
      real(wp) :: half, sine, cosine, change(3), part_1, part_2
      if (.not. arc%curvature > 0.0_wp) then
         tangent = arc%tangent
         lateral_1 = arc%lateral_1
         lateral_2 = arc%lateral_2
         if (present(position)) position = offset*arc%tangent
         return
      end if
      half = 0.5_wp*arc%curvature*offset
      sine = sin(half)
      cosine = cos(half)
      tangent = (1.0_wp - 2.0_wp*sine*sine)*arc%tangent + 2.0_wp*sine*cosine*arc%normal
      change = -2.0_wp*sine*(sine*arc%normal + cosine*arc%tangent)  ! of the normal
      part_1 = arc%lateral_1(1)*arc%normal(1) + arc%lateral_1(2)*arc%normal(2) + arc%lateral_1(3)*arc%normal(3)
      part_2 = arc%lateral_2(1)*arc%normal(1) + arc%lateral_2(2)*arc%normal(2) + arc%lateral_2(3)*arc%normal(3)
      lateral_1 = arc%lateral_1 + part_1*change
      lateral_2 = arc%lateral_2 + part_2*change
      if (present(position)) position = chord_of(half, sine, offset)*(cosine*arc%tangent + sine*arc%normal)
   end subroutine frame_on_arc

   !> Length [m] of the chord of `offset` metres of an arc, from half its angle and that half's sine.
   elemental function chord_of(half, sine, offset) result(chord)
      real(wp), intent(in) :: half, sine, offset
      real(wp) :: chord
      chord = offset
      if (abs(half) > vanishing) chord = offset*(sine/half)
   end function chord_of

   !> Foot of the perpendicular from a point on an arc (or on the circle beyond its ends). Let a, b be the point's components
   !> along tangent and normal, k the curvature and r = hypot(k a, 1 - k b). The foot is at the angle with sine k a/r and
   !> cosine (1 - k b)/r. The distance of the point from the foot, towards the centre, is
   !> (1 - r)/k = (2 b - k (a^2 + b^2))/(1 + r). This holds down to k = 0.
   pure subroutine foot_on_arc(arc, point, gap, tangent, curvature, beyond)
      type(arc_type), intent(in) :: arc
      real(wp), intent(in) :: point(3)       !< relative to arc%origin [m]
      real(wp), intent(out) :: gap(3)        !< from the foot to the point, across the tangent [m]
      real(wp), intent(out) :: tangent(3)    !< unit, at the foot
      real(wp), intent(out) :: curvature(3)  !< dt/ds at the foot [1/m]
      integer, intent(out) :: beyond         !< -1: the foot is above the arc's start; 1: below its end; else 0
      real(wp) :: along, inward, across, sine, cosine, radius, rise, reciprocal
      along = point(1)*arc%tangent(1) + point(2)*arc%tangent(2) + point(3)*arc%tangent(3)
      inward = point(1)*arc%normal(1) + point(2)*arc%normal(2) + point(3)*arc%normal(3)
      across = point(1)*arc%binormal(1) + point(2)*arc%binormal(2) + point(3)*arc%binormal(3)
      beyond = 0
      if (.not. arc%curvature > 0.0_wp) then
         if (along > arc%length) beyond = 1
         tangent = arc%tangent
         curvature = 0.0_wp
         gap = across*arc%binormal + inward*arc%normal
      else
         sine = arc%curvature*along
         cosine = 1.0_wp - arc%curvature*inward
         radius = sqrt(sine*sine + cosine*cosine)
         rise = (2.0_wp*inward - arc%curvature*(along*along + inward*inward))/(1.0_wp + radius)
         if (radius > vanishing) then
            reciprocal = 1.0_wp/radius
            sine = sine*reciprocal
            cosine = cosine*reciprocal
         else                       ! on the arc's centre line all points are equally near: take the start
            sine = 0.0_wp
            cosine = 1.0_wp
         end if
         if (sine*arc%end_cosine > cosine*arc%end_sine) beyond = 1
         tangent = cosine*arc%tangent + sine*arc%normal
         curvature = cosine*arc%normal - sine*arc%tangent
         gap = across*arc%binormal + rise*curvature
         curvature = arc%curvature*curvature
      end if
      if (along < 0.0_wp) beyond = -1
   end subroutine foot_on_arc

   !> Place of the foot of a point on an arc, along the arc from its start [m].
   pure function foot_offset(arc, point) result(offset)
      type(arc_type), intent(in) :: arc
      real(wp), intent(in) :: point(3)       !< relative to arc%origin [m]
      real(wp) :: offset
      real(wp) :: sine, cosine
      offset = dot_product(point, arc%tangent)
      if (.not. arc%curvature > vanishing) return
      sine = arc%curvature*offset
      cosine = 1.0_wp - arc%curvature*dot_product(point, arc%normal)
      offset = 0.0_wp
      if (max(abs(sine), abs(cosine)) > vanishing) offset = atan2(sine, cosine)/arc%curvature
   end function foot_offset
end module dg_arc
