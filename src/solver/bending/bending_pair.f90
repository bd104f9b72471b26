!> Two elements of a bending beam side by side, one of its upper and one of its lower half: what dg_bending_element tells of an
!> element, and the derivatives of that.
!>
!> A beam is folded in the middle. The two elements of a pair are equally far from its ends, and each has an outer node towards its
!> end and an inner one towards the middle. In the lower half depth is counted upwards from the end: slopes, torque and the lever of
!> friction along the hole change their signs there, and all formulas are the same in both halves. The first dimension of all arrays
!> is of the two. A loop over them does the same to each, so that a processor takes both at once: such loops are long, and each
!> number in them has a name of its own, for the compiler to see that.
module dg_bending_pair
   use dg_kinds, only: wp
   use dg_bending_element, only: beam_element_type, contact_places, contact_slope, contact_value
   implicit none
   private
   public :: pair, beam_pair_type, pair_push_type, put_element, pair_action, pair_stiffness, raise_moments
   public :: mean_slope, skew_slope

   integer, parameter :: pair = 2

   !> Shape functions of outer offset, outer slope, inner offset and inner slope at the outer (a) and at the inner place (b) of
   !> contact of an element of unit length; their slopes.
   real(wp), parameter :: a1 = contact_value(1, 1), a2 = contact_value(2, 1), a3 = contact_value(3, 1), a4 = contact_value(4, 1)
   real(wp), parameter :: b1 = contact_value(1, 2), b2 = contact_value(2, 2), b3 = contact_value(3, 2), b4 = contact_value(4, 2)
   real(wp), parameter :: sa1 = contact_slope(1, 1), sa2 = contact_slope(2, 1), sa3 = contact_slope(3, 1), sa4 = contact_slope(4, 1)
   real(wp), parameter :: sb1 = contact_slope(1, 2), sb2 = contact_slope(2, 2), sb3 = contact_slope(3, 2), sb4 = contact_slope(4, 2)

   !> Outer and inner offset move the string at the two places by one half plus and minus `skew` of theirs. Of half the sum of both
   !> places and `skew` times their difference, columns of outer and inner offset are the sum and the difference. Those of slopes,
   !> over the length, are `skew_slope` times the second plus and minus `mean_slope` times the first.
   real(wp), parameter :: skew = 0.5_wp*(a1 - b1)
   real(wp), parameter :: mean_slope = a2 + b2, skew_slope = 0.5_wp*(a2 - b2)/skew

   !> beam_element_type of two elements: `outer` and `inner` are what is there of the upper and the lower node. All are zero where
   !> there is no element.
   type :: beam_pair_type
      real(wp), dimension(pair) :: contact = 0.0_wp, maximum = 0.0_wp      !< stiffnesses of the wall [N/m2]
      !> Distances from the hole axis from which the wall presses, and from which its stiffness is `maximum` [m].
      real(wp), dimension(pair, contact_places) :: clearance = 0.0_wp, limit = 0.0_wp
      real(wp), dimension(pair) :: lever = 0.0_wp, around = 0.0_wp, length = 0.0_wp, per_length = 0.0_wp, ei = 0.0_wp
      real(wp), dimension(pair) :: bent_1 = 0.0_wp, bent_2 = 0.0_wp, twist = 0.0_wp, turn = 0.0_wp   !< bent; torque
      real(wp), dimension(pair) :: shear = 0.0_wp, outer_turn = 0.0_wp, inner_turn = 0.0_wp
      real(wp), dimension(pair) :: outer_couple = 0.0_wp, common_couple = 0.0_wp, inner_couple = 0.0_wp
      real(wp) :: outer_load(pair, 4) = 0.0_wp, inner_load(pair, 4) = 0.0_wp
   end type beam_pair_type

   !> How the wall presses at a place of each of both elements, for the half element that belongs to it.
   type :: pair_push_type
      real(wp), dimension(pair) :: force = 0.0_wp       !< 0 where nothing touches [N]
      !> Its derivatives by the offset there: by and in the first direction, by one in the other, by and in the second one; not set
      !> where nothing touches at any place of both elements [N/m].
      real(wp), dimension(pair) :: k11 = 0.0_wp, k12 = 0.0_wp, k22 = 0.0_wp
   end type pair_push_type

contains

   !> Puts an element in its place of a pair.
   pure subroutine put_element(element, half, both)
      type(beam_element_type), intent(in) :: element
      integer, intent(in) :: half            !< 1 upper, 2 lower
      type(beam_pair_type), intent(inout) :: both
      real(wp) :: sign
      integer :: outer, inner
      outer = half
      inner = 3 - half
      sign = merge(1.0_wp, -1.0_wp, half == 1)
      both%contact(half) = element%contact
      both%maximum(half) = element%maximum
      both%clearance(half, :) = element%law%clearance - element%moved([outer, inner])
      both%limit(half, :) = both%clearance(half, :) + element%law%eps_nmax*element%law%clearance
      both%lever(half) = sign*element%lever
      both%around(half) = element%around
      both%length(half) = element%length
      both%per_length(half) = element%per_length
      both%ei(half) = element%ei
      both%bent_1(half) = element%bent(1)
      both%bent_2(half) = element%bent(2)
      both%twist(half) = sign*element%torque(1)
      both%turn(half) = sign*element%torque(2)
      both%shear(half) = element%shear
      both%outer_turn(half) = element%turn(outer)
      both%inner_turn(half) = element%turn(inner)
      both%outer_couple(half) = element%couple(2*outer - 1)
      both%common_couple(half) = element%couple(2)
      both%inner_couple(half) = element%couple(2*inner - 1)
      both%outer_load(half, 1:2) = element%load(4*outer - 3:4*outer - 2)
      both%outer_load(half, 3:4) = sign*element%load(4*outer - 1:4*outer)
      both%inner_load(half, 1:2) = element%load(4*inner - 3:4*inner - 2)
      both%inner_load(half, 3:4) = sign*element%load(4*inner - 1:4*inner)
   end subroutine put_element

   !> Forces and couples that the elements' nodes must be held with at a shape, and how the wall presses. Over the elements they add
   !> up to zero at equilibrium: those of the outer nodes are added to what is there.
   pure subroutine pair_action(both, outer, inner, push, at_outer, at_inner)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in) :: outer(pair, 4), inner(pair, 4)    !< offsets and slopes of the nodes [m, -]
      type(pair_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout) :: at_outer(pair, 4)              !< [N, N.m]
      real(wp), intent(out) :: at_inner(pair, 4)
      real(wp) :: offset(pair, 2*contact_places), depth(pair, contact_places)
      real(wp) :: d1, d2, u1, u2, v1, v2, f1, f2, t1, t2, c1, c2
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         d1 = outer(l, 1) - inner(l, 1)
         d2 = outer(l, 2) - inner(l, 2)
         u1 = outer(l, 3)
         u2 = outer(l, 4)
         v1 = inner(l, 3)
         v2 = inner(l, 4)
         t1 = both%turn(l)*(u1 - v1)
         t2 = both%turn(l)*(u2 - v2)
         c1 = both%turn(l)*d1 + both%twist(l)*(u1 + v1)
         c2 = both%turn(l)*d2 + both%twist(l)*(u2 + v2)
         f1 = both%shear(l)*d1 + both%outer_turn(l)*u1 + both%inner_turn(l)*v1 + t2
         f2 = both%shear(l)*d2 + both%outer_turn(l)*u2 + both%inner_turn(l)*v2 - t1
         at_outer(l, 1) = at_outer(l, 1) + (f1 - both%outer_load(l, 1))
         at_outer(l, 2) = at_outer(l, 2) + (f2 - both%outer_load(l, 2))
         at_inner(l, 1) = -f1 - both%inner_load(l, 1)
         at_inner(l, 2) = -f2 - both%inner_load(l, 2)
         f1 = both%outer_turn(l)*d1 + both%outer_couple(l)*u1 + both%common_couple(l)*v1 - c2
         f2 = both%outer_turn(l)*d2 + both%outer_couple(l)*u2 + both%common_couple(l)*v2 + c1
         at_outer(l, 3) = at_outer(l, 3) + (f1 - both%outer_load(l, 3))
         at_outer(l, 4) = at_outer(l, 4) + (f2 - both%outer_load(l, 4))
         f1 = both%inner_turn(l)*d1 + both%common_couple(l)*u1 + both%inner_couple(l)*v1 + c2
         f2 = both%inner_turn(l)*d2 + both%common_couple(l)*u2 + both%inner_couple(l)*v2 - c1
         at_inner(l, 3) = f1 - both%inner_load(l, 3)
         at_inner(l, 4) = f2 - both%inner_load(l, 4)
         offset(l, 1) = a1*outer(l, 1) + a3*inner(l, 1) + both%length(l)*(a2*u1 + a4*v1)
         offset(l, 2) = a1*outer(l, 2) + a3*inner(l, 2) + both%length(l)*(a2*u2 + a4*v2)
         offset(l, 3) = b1*outer(l, 1) + b3*inner(l, 1) + both%length(l)*(b2*u1 + b4*v1)
         offset(l, 4) = b1*outer(l, 2) + b3*inner(l, 2) + both%length(l)*(b2*u2 + b4*v2)
         depth(l, 1) = offset(l, 1)**2 + offset(l, 2)**2 - both%clearance(l, 1)**2
         depth(l, 2) = offset(l, 3)**2 + offset(l, 4)**2 - both%clearance(l, 2)**2
      end do
      push(1)%force = 0.0_wp
      push(2)%force = 0.0_wp
      if (max(depth(1, 1), depth(2, 1), depth(1, 2), depth(2, 2)) > 0.0_wp) call add_push(both, offset, push, at_outer, at_inner)
   end subroutine pair_action

   !> What the wall adds, which presses by the law of dg_gap_state.
   pure subroutine add_push(both, offset, push, at_outer, at_inner)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in) :: offset(pair, 2, contact_places)   !< from the hole axis [m]
      type(pair_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout) :: at_outer(pair, 4), at_inner(pair, 4)
      real(wp) :: normal(pair, 2, contact_places)
      real(wp) :: distance, per_distance, contact, more, force, steep, turning, n1, n2
      real(wp) :: fa1, fa2, fb1, fb2, ca1, ca2, cb1, cb2
      integer :: l, p
      do p = 1, contact_places
         !GCC$ unroll 1
         do l = 1, pair
            distance = sqrt(offset(l, 1, p)**2 + offset(l, 2, p)**2)
            per_distance = 1.0_wp/max(distance, tiny(1.0_wp))
            contact = 0.5_wp*both%length(l)*both%contact(l)
            more = 0.5_wp*both%length(l)*both%maximum(l) - contact
            force = contact*max(distance - both%clearance(l, p), 0.0_wp) + more*max(distance - both%limit(l, p), 0.0_wp)
            ! factors are one where the wall presses, else zero: the compiler makes jumps of merge
            steep = contact*(0.5_wp - sign(0.5_wp, both%clearance(l, p) - distance)) &
                    + more*(0.5_wp - sign(0.5_wp, both%limit(l, p) - distance))
            n1 = offset(l, 1, p)*per_distance
            n2 = offset(l, 2, p)*per_distance
            turning = force*per_distance
            steep = steep - turning
            push(p)%force(l) = force
            push(p)%k11(l) = turning + steep*n1*n1
            push(p)%k12(l) = steep*n1*n2
            push(p)%k22(l) = turning + steep*n2*n2
            normal(l, 1, p) = n1*force
            normal(l, 2, p) = n2*force
         end do
      end do
      !GCC$ unroll 1
      do l = 1, pair
         fa1 = normal(l, 1, 1) - both%around(l)*normal(l, 2, 1)
         fa2 = normal(l, 2, 1) + both%around(l)*normal(l, 1, 1)
         fb1 = normal(l, 1, 2) - both%around(l)*normal(l, 2, 2)
         fb2 = normal(l, 2, 2) + both%around(l)*normal(l, 1, 2)
         ca1 = both%lever(l)*both%per_length(l)*normal(l, 1, 1)
         ca2 = both%lever(l)*both%per_length(l)*normal(l, 2, 1)
         cb1 = both%lever(l)*both%per_length(l)*normal(l, 1, 2)
         cb2 = both%lever(l)*both%per_length(l)*normal(l, 2, 2)
         at_outer(l, 1) = at_outer(l, 1) + (a1*fa1 + b1*fb1 + sa1*ca1 + sb1*cb1)
         at_outer(l, 2) = at_outer(l, 2) + (a1*fa2 + b1*fb2 + sa1*ca2 + sb1*cb2)
         at_outer(l, 3) = at_outer(l, 3) + both%length(l)*(a2*fa1 + b2*fb1 + sa2*ca1 + sb2*cb1)
         at_outer(l, 4) = at_outer(l, 4) + both%length(l)*(a2*fa2 + b2*fb2 + sa2*ca2 + sb2*cb2)
         at_inner(l, 1) = at_inner(l, 1) + (a3*fa1 + b3*fb1 + sa3*ca1 + sb3*cb1)
         at_inner(l, 2) = at_inner(l, 2) + (a3*fa2 + b3*fb2 + sa3*ca2 + sb3*cb2)
         at_inner(l, 3) = at_inner(l, 3) + both%length(l)*(a4*fa1 + b4*fb1 + sa4*ca1 + sb4*cb1)
         at_inner(l, 4) = at_inner(l, 4) + both%length(l)*(a4*fa2 + b4*fb2 + sa4*ca2 + sb4*cb2)
      end do
   end subroutine add_push

   !> Derivatives of what the wall adds to the nodes' forces and couples by the offsets at both places: half their sum, and `skew`
   !> times their difference [N/m, N]. Friction along the hole acts by the slopes of the shape functions, friction around it by the
   !> stiffness turned by a right angle.
   pure subroutine pair_stiffness(both, push, mean, swing)
      type(beam_pair_type), intent(in) :: both
      type(pair_push_type), intent(in) :: push(contact_places)
      real(wp), intent(out), dimension(pair, 2, 2, 4) :: mean, swing      !< (direction of force, of offset, shape)
      real(wp) :: weight(pair, 4, contact_places), a, b, a11, a12, a22, b11, b12, b22, by_length
      integer :: l, i
      !GCC$ unroll 1
      do l = 1, pair
         by_length = both%lever(l)*both%per_length(l)
         weight(l, 1, 1) = 0.5_wp*a1 + 0.5_wp*sa1*by_length
         weight(l, 2, 1) = 0.5_wp*a2*both%length(l) + 0.5_wp*sa2*both%lever(l)
         weight(l, 3, 1) = 0.5_wp*a3 + 0.5_wp*sa3*by_length
         weight(l, 4, 1) = 0.5_wp*a4*both%length(l) + 0.5_wp*sa4*both%lever(l)
         weight(l, 1, 2) = 0.5_wp*b1 + 0.5_wp*sb1*by_length
         weight(l, 2, 2) = 0.5_wp*b2*both%length(l) + 0.5_wp*sb2*both%lever(l)
         weight(l, 3, 2) = 0.5_wp*b3 + 0.5_wp*sb3*by_length
         weight(l, 4, 2) = 0.5_wp*b4*both%length(l) + 0.5_wp*sb4*both%lever(l)
      end do
      do i = 1, 4
         !GCC$ unroll 1
         do l = 1, pair
            a = weight(l, i, 1)
            b = weight(l, i, 2)
            a11 = a*push(1)%k11(l)
            a12 = a*push(1)%k12(l)
            a22 = a*push(1)%k22(l)
            b11 = b*push(2)%k11(l)
            b12 = b*push(2)%k12(l)
            b22 = b*push(2)%k22(l)
            mean(l, 1, 1, i) = a11 + b11
            mean(l, 2, 1, i) = a12 + b12
            mean(l, 1, 2, i) = a12 + b12
            mean(l, 2, 2, i) = a22 + b22
            swing(l, 1, 1, i) = 2.0_wp*skew*(a11 - b11)
            swing(l, 2, 1, i) = 2.0_wp*skew*(a12 - b12)
            swing(l, 1, 2, i) = 2.0_wp*skew*(a12 - b12)
            swing(l, 2, 2, i) = 2.0_wp*skew*(a22 - b22)
         end do
      end do
      if (.not. max(abs(both%around(1)), abs(both%around(2))) > 0.0_wp) return
      !GCC$ unroll 1
      do l = 1, pair
         by_length = both%around(l)*both%length(l)
         weight(l, 1, 1) = 0.5_wp*a1*both%around(l)
         weight(l, 2, 1) = 0.5_wp*a2*by_length
         weight(l, 3, 1) = 0.5_wp*a3*both%around(l)
         weight(l, 4, 1) = 0.5_wp*a4*by_length
         weight(l, 1, 2) = 0.5_wp*b1*both%around(l)
         weight(l, 2, 2) = 0.5_wp*b2*by_length
         weight(l, 3, 2) = 0.5_wp*b3*both%around(l)
         weight(l, 4, 2) = 0.5_wp*b4*by_length
      end do
      do i = 1, 4
         !GCC$ unroll 1
         do l = 1, pair
            a = weight(l, i, 1)
            b = weight(l, i, 2)
            a11 = a*push(1)%k11(l)
            a12 = a*push(1)%k12(l)
            a22 = a*push(1)%k22(l)
            b11 = b*push(2)%k11(l)
            b12 = b*push(2)%k12(l)
            b22 = b*push(2)%k22(l)
            mean(l, 1, 1, i) = mean(l, 1, 1, i) - (a12 + b12)
            mean(l, 2, 1, i) = mean(l, 2, 1, i) + (a11 + b11)
            mean(l, 1, 2, i) = mean(l, 1, 2, i) - (a22 + b22)
            mean(l, 2, 2, i) = mean(l, 2, 2, i) + (a12 + b12)
            swing(l, 1, 1, i) = swing(l, 1, 1, i) - 2.0_wp*skew*(a12 - b12)
            swing(l, 2, 1, i) = swing(l, 2, 1, i) + 2.0_wp*skew*(a11 - b11)
            swing(l, 1, 2, i) = swing(l, 1, 2, i) - 2.0_wp*skew*(a22 - b22)
            swing(l, 2, 2, i) = swing(l, 2, 2, i) + 2.0_wp*skew*(a12 - b12)
         end do
      end do
   end subroutine pair_stiffness

   !> Raises two numbers of each half to the squares of the elements' moments and of their changes, where these are larger [N2.m2].
   pure subroutine raise_moments(both, outer, inner, outer_change, inner_change, most, changed)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in), dimension(pair, 4) :: outer, inner, outer_change, inner_change
      real(wp), intent(inout), dimension(pair) :: most, changed
      real(wp) :: s, c1, c2, m1, m2, n1, n2
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         s = 2.0_wp*both%ei(l)*both%per_length(l)
         c1 = 3.0_wp*both%per_length(l)*(inner(l, 1) - outer(l, 1))
         c2 = 3.0_wp*both%per_length(l)*(inner(l, 2) - outer(l, 2))
         m1 = s*(c1 - 2.0_wp*outer(l, 3) - inner(l, 3)) + both%ei(l)*both%bent_1(l)
         m2 = s*(c2 - 2.0_wp*outer(l, 4) - inner(l, 4)) + both%ei(l)*both%bent_2(l)
         n1 = s*(2.0_wp*inner(l, 3) + outer(l, 3) - c1) + both%ei(l)*both%bent_1(l)
         n2 = s*(2.0_wp*inner(l, 4) + outer(l, 4) - c2) + both%ei(l)*both%bent_2(l)
         most(l) = max(most(l), m1*m1 + m2*m2, n1*n1 + n2*n2)
         c1 = 3.0_wp*both%per_length(l)*(inner_change(l, 1) - outer_change(l, 1))
         c2 = 3.0_wp*both%per_length(l)*(inner_change(l, 2) - outer_change(l, 2))
         m1 = s*(c1 - 2.0_wp*outer_change(l, 3) - inner_change(l, 3))
         m2 = s*(c2 - 2.0_wp*outer_change(l, 4) - inner_change(l, 4))
         n1 = s*(2.0_wp*inner_change(l, 3) + outer_change(l, 3) - c1)
         n2 = s*(2.0_wp*inner_change(l, 4) + outer_change(l, 4) - c2)
         changed(l) = max(changed(l), m1*m1 + m2*m2, n1*n1 + n2*n2)
      end do
   end subroutine raise_moments
end module dg_bending_pair
