!> The shape of a compressed string in the vertical part of a hole, as a start of the iteration.
!>
!> A helix of the pitch that belongs to the compression of each place is only its middle. Where it begins and ends rules the phase
!> of all its turns, and a start with the wrong phase costs many times the iterations of one with the right. With F the
!> compression, c the clearance, s the depth, y the offset as a complex number and theta its angle:
!>   on the wall       u = theta' solves EI (u'' - 2 u^3) + F u = 0: the beam's equation along the wall without torque,
!>                     integrated once (Mitchell 1988 for constant F; where F grows with depth it is the second equation of
!>                     Painleve, and this the solution of Hastings & McLeod 1980). Far below the neutral point u is
!>                     sqrt(F/(2 EI)), above it dies out. The wall presses with c (EI (3 u'^2 + 7 u^4) - 3 F u^2) per length.
!>   above             the string leans from the centred top to where it touches: EI v'' + F v = -H, v the slope d|y|/ds and H the
!>                     side force at the top. Where it touches v = 0, and v' = -c u^2 as the bending moment does not jump: the
!>                     two conditions give the depth.
!>   at a centred bit  F is that of the bit, and lengths count in 1/beta = sqrt(2 EI/F): see `end_at_bit`. The same
!>                     end is used at a centred top that is compressed.
!>   beside a bend     where the string comes to lie on one side, u = beta tanh(beta (s_end - s)), which solves the equation above.
module dg_predicted_helix
   use dg_kinds, only: wp
   use dg_coiling, only: coiling_load
   use dg_gap_state, only: state_elastic, state_free
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type, upright
   implicit none
   private
   public :: lay_helix, touch_above_bit, end_at_bit, helix_touch, helix_landing

   !> Nodes from the neutral point to the end of a helix that can be told from noise.
   integer, parameter :: fewest_nodes = 3
   !> Newton's steps for u from sqrt(F/(2 EI)), each squaring what is missing.
   integer, parameter :: rate_steps = 4

   !> End of a helix at a centred bit, t = beta times the distance from it: the string touches at `helix_touch`, turning by
   !> `touch_rate`, with the force `touch_force` times c EI beta^3; up to `helix_landing` it is off the wall by 0.002 c at most, and
   !> lies on it from there on. These four, u and theta at the landing make y, y' and y'' those of the wall there: the roots of six
   !> equations. That |y| = 1 and |y|' = 0 where it touches is built in.
   real(wp), parameter :: helix_touch = 1.74561045_wp, helix_landing = 3.09787147_wp
   real(wp), parameter :: touch_rate = 0.65979746_wp, touch_force = 1.72614151_wp
   !> y = line t + sine sin(k t) above the bit, where it is on the axis without moment; k = sqrt(F/EI)/beta.
   real(wp), parameter :: k = sqrt(2.0_wp)
   complex(wp), parameter :: sine = cmplx(1.0_wp, -touch_rate*helix_touch, wp) &
                                    /(sin(k*helix_touch) - helix_touch*k*cos(k*helix_touch))
   complex(wp), parameter :: line = cmplx(0.0_wp, touch_rate, wp) - sine*k*cos(k*helix_touch)
   !> Second and third derivative just beyond the touch.
   complex(wp), parameter :: bend = -k**2*sine*sin(k*helix_touch), shear = -k**3*sine*cos(k*helix_touch) - touch_force
   !> y and y' at the landing.
   real(wp), parameter :: span = helix_landing - helix_touch
   complex(wp), parameter :: landed = cmplx(1.0_wp, touch_rate*span, wp) + bend*(1.0_wp - cos(k*span))/k**2 &
                                      + shear*(k*span - sin(k*span))/k**3
   complex(wp), parameter :: landed_slope = cmplx(0.0_wp, touch_rate, wp) + bend*sin(k*span)/k + shear*(1.0_wp - cos(k*span))/k**2
   !> From the landing on u = tanh(t - t_0); t_0 of a string that comes to lie is 0.
   real(wp), parameter :: shift_at_bit = helix_landing - atanh(aimag(landed_slope/landed)), shift_lying = 0.0_wp
   !> Angle at the touch with which the angle far away becomes t.
   real(wp), parameter :: touch_angle = log(2.0_wp*cosh(helix_landing - shift_at_bit)) + shift_at_bit &
                                        - atan2(aimag(landed), real(landed))
   complex(wp), parameter :: turned = cmplx(cos(touch_angle), sin(touch_angle), wp)

contains

   !> Lays the string where it coils in a vertical part of the hole that begins at the top and, without a break, below, and what
   !> hangs above. `last` = 0: it does not coil there, and nothing is changed.
   pure subroutine lay_helix(mesh, axial, place, top_centred, bit_centred, wall, load, offset, slope, last, angle, snakes)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)               !< by node, tension positive [N]
      real(wp), intent(in) :: place(:)               !< x0/L of the gaps, by element [-]
      logical, intent(in) :: top_centred, bit_centred
      real(wp), intent(in) :: wall(:)                !< stiffness per length, by element [N/m2]
      real(wp), intent(inout) :: load(:)             !< contact force, by node [N/m]
      real(wp), intent(inout) :: offset(:, :)        !< (2,nodes) [m]; beyond `last` where the soft string lies
      real(wp), intent(inout) :: slope(:, :)         !< (2,nodes) [-]
      integer, intent(out) :: last                   !< node to which the helix goes
      real(wp), intent(out) :: angle                 !< of its end [rad]
      logical, intent(in), optional :: snakes(:)     !< by node; a helix goes over into a snake without slowing down; absent: none
      real(wp) :: turn(mesh%nodes), rate(mesh%nodes), radius(mesh%nodes), growth(mesh%nodes), start, t
      complex(wp) :: y, y_prime
      logical :: lies, swings
      integer :: i, e, neutral, first
      angle = 0.0_wp
      call find_helix(mesh, axial, load, neutral, last)
      if (last == 0) then
         if (top_centred) call lean_on_bend(mesh, axial, offset, slope)
         return
      end if
      call find_rate(mesh, axial, last, rate)
      turn(1) = 0.0_wp
      do i = 2, last
         turn(i) = turn(i - 1) + 0.5_wp*(rate(i) + rate(i - 1))*mesh%length(i - 1) &
                   + (change_at(mesh%md, rate, i - 1, last) - change_at(mesh%md, rate, i, last))*mesh%length(i - 1)**2/12.0_wp
      end do
      do i = 1, last
         e = min(i, mesh%elements)
         radius(i) = mesh%clearance(e)
         growth(i) = 0.0_wp
         if (mesh%frame(3, 1, i) > upright) load(i) = 0.0_wp      ! as the bend begins half a load is on its first node
         load(i) = max(radius(i)*(mesh%ei(e)*(3.0_wp*change_at(mesh%md, rate, i, last)**2 + 7.0_wp*rate(i)**4) &
                                  + 3.0_wp*axial(i)*rate(i)**2), load(i))
      end do
      first = neutral
      if (top_centred .and. neutral > 1) call lean(mesh, axial, rate, neutral, last, first, radius, growth)
      load(:first - 1) = 0.0_wp
      do i = first, last
         radius(i) = radius(i) + load(i)*mesh%gathered(min(i, mesh%elements))/wall(min(i, mesh%elements)) &
                     + cut_short(mesh, place, rate(i), i)
      end do
      lies = .false.
      swings = .false.
      if (last < mesh%nodes) then
         lies = norm2(offset(:, last + 1)) > 0.0_wp
         if (present(snakes)) swings = lies .and. snakes(last + 1)
         lies = lies .and. .not. swings
      end if
      start = 0.0_wp
      if (swings) start = atan2(offset(2, last + 1), offset(1, last + 1)) - turn(last)
      if (lies) start = atan2(offset(2, last + 1), offset(1, last + 1)) + far_angle(0.0_wp, shift_lying) - turn(last)
      do i = 1, last
         t = turn(last) - turn(i)
         angle = start + turn(i)
         y = cmplx(radius(i), 0.0_wp, wp)
         y_prime = cmplx(growth(i), radius(i)*rate(i), wp)
         if (top_centred .and. neutral == 1 .and. t > 0.5_wp*turn(last)) then       ! compressed from the top on
            t = turn(i)
            if (t < helix_landing) then
               call end_at_bit(t, y, y_prime)
               angle = start
               y = radius(i)*y
               y_prime = radius(i)*rate(i)*y_prime
               load(i) = 0.0_wp
            else
               angle = start + far_angle(t, shift_at_bit)
               y_prime = cmplx(growth(i), radius(i)*rate(i)*tanh(t - shift_at_bit), wp)
            end if
         else if (lies) then
            angle = start + turn(last) - far_angle(t, shift_lying)
            y_prime = cmplx(growth(i), radius(i)*rate(i)*tanh(t - shift_lying), wp)
         else if (last == mesh%nodes .and. bit_centred) then
            if (t < helix_landing) then
               call end_at_bit(t, y, y_prime)
               angle = start + turn(last)
               y = radius(i)*conjg(y)                       ! t counts upwards
               y_prime = -radius(i)*rate(i)*conjg(y_prime)
               load(i) = 0.0_wp
            else
               angle = start + turn(last) - far_angle(t, shift_at_bit)
               y_prime = cmplx(growth(i), radius(i)*rate(i)*tanh(t - shift_at_bit), wp)
            end if
         end if
         y = y*cmplx(cos(angle), sin(angle), wp)
         y_prime = y_prime*cmplx(cos(angle), sin(angle), wp)
         offset(:, i) = [real(y), aimag(y)]
         slope(:, i) = [real(y_prime), aimag(y_prime)]
      end do
      if (top_centred) offset(:, 1) = 0.0_wp
   end subroutine lay_helix

   !> The gaps above a centred bit at which a helix ends: the one where it touches is closed, there, and those up to the landing
   !> are open.
   pure subroutine touch_above_bit(mesh, axial, gaps)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)                 !< by node [N]
      type(gap_table_type), intent(inout) :: gaps
      real(wp) :: below, above
      integer :: e
      below = 0.0_wp
      do e = mesh%elements, 1, -1
         above = below + sqrt(max(-axial(e) - axial(e + 1), 0.0_wp)/(4.0_wp*mesh%ei(e)))*mesh%length(e)
         if (0.5_wp*(below + above) > helix_landing) return
         gaps%state(e) = state_free
         if (below <= helix_touch .and. above > helix_touch) then
            gaps%state(e) = state_elastic
            if (gaps%xi(e) < 1.0_wp) gaps%xi(e) = (above - helix_touch)/(above - below)     ! not those held at the node
         end if
         below = above
      end do
   end subroutine touch_above_bit

   !> End of a helix at a centred bit: y/c and its derivative at t, the distance from the bit times beta, up to the landing. Turned
   !> so that far up the angle of y is t.
   pure subroutine end_at_bit(t, y, y_prime)
      real(wp), intent(in) :: t
      complex(wp), intent(out) :: y, y_prime
      real(wp) :: s
      if (t < helix_touch) then
         y = line*t + sine*sin(k*t)
         y_prime = line + sine*k*cos(k*t)
      else
         s = t - helix_touch
         y = cmplx(1.0_wp, touch_rate*s, wp) + bend*(1.0_wp - cos(k*s))/k**2 + shear*(k*s - sin(k*s))/k**3
         y_prime = cmplx(0.0_wp, touch_rate, wp) + bend*sin(k*s)/k + shear*(1.0_wp - cos(k*s))/k**2
      end if
      y = y*turned
      y_prime = y_prime*turned
   end subroutine end_at_bit

   !> Angle of a string that turns by tanh(t - shift), tending to t.
   elemental function far_angle(t, shift) result(angle)
      real(wp), intent(in) :: t, shift
      real(wp) :: angle
      angle = abs(t - shift) + log(1.0_wp + exp(-2.0_wp*abs(t - shift))) + shift
   end function far_angle

   !> First node below the neutral point, and the last one that coils; last = 0: none does in the vertical part at the top.
   pure subroutine find_helix(mesh, axial, side, neutral, last)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:), side(:)        !< by node [N, N/m]
      integer, intent(out) :: neutral, last
      logical :: vertical
      integer :: i
      neutral = 0
      last = 0
      do i = 1, mesh%nodes
         vertical = mesh%frame(3, 1, i) > upright
         if (.not. vertical .and. (last == 0 .or. last < i - 1)) exit
         if (.not. axial(i) < 0.0_wp) cycle
         if (neutral == 0) neutral = i
         if (coils(mesh, axial, merge(0.0_wp, side(i), vertical), i)) last = i
      end do
      if (last < neutral + fewest_nodes) last = 0
   end subroutine find_helix

   !> Whether the string is compressed beyond its coiling load at a node, under a side load [N/m].
   pure function coils(mesh, axial, side, node) result(yes)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:), side
      integer, intent(in) :: node
      logical :: yes
      integer :: e
      e = min(node, mesh%elements)
      yes = -axial(node) > coiling_load(mesh%ei(e), side, mesh%weight(e), mesh%clearance(e))
   end function coils

   !> u at the nodes down to `last` [1/m], by differences.
   pure subroutine find_rate(mesh, axial, last, rate)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)
      integer, intent(in) :: last
      real(wp), intent(inout) :: rate(:)
      real(wp) :: share, above, below, pivot, factor(last), change(last)
      integer :: i, step
      do i = 1, last
         rate(i) = sqrt(max(-axial(i), 0.0_wp)/(2.0_wp*mesh%ei(min(i, mesh%elements))))
      end do
      factor(1) = 0.0_wp
      change(1) = 0.0_wp
      do step = 1, rate_steps
         do i = 2, last - 1
            share = -axial(i)/mesh%ei(i)
            call second_difference(mesh, i, above, below)
            pivot = above + below + max(6.0_wp*rate(i)**2 - share, 0.0_wp) - above*factor(i - 1)
            factor(i) = below/pivot
            change(i) = (above*(rate(i - 1) - rate(i) + change(i - 1)) + below*(rate(i + 1) - rate(i)) &
                         - 2.0_wp*rate(i)**3 + share*rate(i))/pivot
         end do
         do i = last - 1, 2, -1
            if (i < last - 1) change(i) = change(i) + factor(i)*change(i + 1)
            rate(i) = rate(i) + change(i)
         end do
      end do
   end subroutine find_rate

   !> Radius and its slope of the part that leans from the top to the node `first` where it touches. Where no place suits it stays
   !> on the axis down to the neutral point.
   pure subroutine lean(mesh, axial, rate, neutral, last, first, radius, growth)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:), rate(:)
      integer, intent(in) :: neutral, last
      integer, intent(out) :: first
      real(wp), intent(inout) :: radius(:), growth(:)  !< r and r' [m, -]
      real(wp) :: v(last), r(last), bend
      logical :: fits
      fits = .false.
      do first = max(neutral, fewest_nodes), last - 1
         call lean_to(mesh, axial, first, v, r, bend, fits)
         if (.not. fits) exit             ! the span buckles before it touches
         fits = -bend <= r(first)*rate(first)**2
         if (fits) exit
      end do
      if (fits) then
         growth(:first) = v(:first)*radius(first)/r(first)
         radius(:first) = min(r(:first)*radius(first)/r(first), radius(:first))
      else
         first = neutral
         radius(:first - 1) = 0.0_wp
      end if
   end subroutine lean

   !> Shape of a string that leans from a centred top, with a unit of lateral force, to a node where it touches: slopes v, offsets
   !> r, and v' where it touches. `holds`: it does not buckle above.
   pure subroutine lean_to(mesh, axial, first, v, r, bend, holds)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)
      integer, intent(in) :: first
      real(wp), intent(out) :: v(:), r(:), bend
      logical, intent(out) :: holds
      real(wp) :: factor(first), above, below, pivot, before
      integer :: i
      holds = .false.
      factor(1) = 1.0_wp                  ! no moment at the top
      r = 0.0_wp
      v = 0.0_wp
      bend = 0.0_wp
      do i = 2, first - 1
         call second_difference(mesh, i, above, below)
         pivot = above*(1.0_wp - factor(i - 1)) + below + axial(i)/mesh%ei(i)
         holds = pivot > 0.0_wp
         if (.not. holds) return
         factor(i) = below/pivot
         v(i) = (1.0_wp/mesh%ei(i) + above*v(i - 1))/pivot
      end do
      do i = first - 1, 1, -1
         v(i) = v(i) + factor(i)*v(i + 1)
      end do
      do i = 2, first
         before = bend
         associate (length => mesh%length(i - 1))
            if (i < first) then
               bend = change_at(mesh%md, v, i, first)
            else
               bend = -v(i - 1)/length - 0.5_wp*length/mesh%ei(i - 1)     ! v'' = -1/EI where v = 0
            end if
            r(i) = r(i - 1) + 0.5_wp*length*(v(i) + v(i - 1)) + length**2*(before - bend)/12.0_wp
         end associate
      end do
   end subroutine lean_to

   !> Leans the string, where it does not coil, from a centred top down a vertical part of the hole to where compression lays it
   !> against the outside of a bend below: left as a step from the axis to the wall it leads the iteration astray. Tension
   !> would lay it against the inside, which it reaches only further down.
   pure subroutine lean_on_bend(mesh, axial, offset, slope)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)
      real(wp), intent(inout) :: offset(:, :), slope(:, :)
      real(wp) :: v(mesh%nodes), r(mesh%nodes), bend
      logical :: holds
      integer :: i, first
      do first = 1, mesh%nodes - 1
         if (norm2(offset(:, first)) > 0.0_wp) exit
         if (.not. mesh%frame(3, 1, first) > upright) return
      end do
      if (first < fewest_nodes .or. first == mesh%nodes .or. axial(first) > 0.0_wp) return
      call lean_to(mesh, axial, first, v, r, bend, holds)
      if (.not. holds) return
      do i = 2, first
         slope(:, i) = offset(:, first)*v(i)/r(first)
         if (i < first) offset(:, i) = offset(:, first)*r(i)/r(first)
      end do
   end subroutine lean_on_bend

   !> By how much the cubic between two nodes of a helix cuts short at the gap, |y''''| L^4 xi^2 (1 - xi)^2/24, as a mean of the
   !> elements at a node [m]: else the gaps of long elements would start open.
   pure function cut_short(mesh, place, rate, node) result(short)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: place(:), rate
      integer, intent(in) :: node
      real(wp) :: short
      integer :: e
      short = 0.0_wp
      do e = max(node - 1, 1), min(node, mesh%elements)
         short = short + 0.5_wp*mesh%clearance(e)*(rate*mesh%length(e))**4*(place(e)*(1.0_wp - place(e)))**2/24.0_wp
      end do
   end function cut_short

   !> Derivative at a node of what is given at nodes 1 to `last`.
   pure function change_at(md, values, node, last) result(change)
      real(wp), intent(in) :: md(:), values(:)
      integer, intent(in) :: node, last
      real(wp) :: change
      integer :: above, below
      above = max(node - 1, 1)
      below = min(node + 1, last)
      change = (values(below) - values(above))/(md(below) - md(above))
   end function change_at

   !> What the neighbours above and below have in the second derivative at a node [1/m2].
   pure subroutine second_difference(mesh, node, above, below)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(out) :: above, below
      associate (up => mesh%length(node - 1), down => mesh%length(node))
         above = 2.0_wp/(up*(up + down))
         below = 2.0_wp/(down*(up + down))
      end associate
   end subroutine second_difference
end module dg_predicted_helix
