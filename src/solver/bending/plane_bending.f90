!> Two elements of a bending beam that stays in a plane, side by side: what dg_bending_pair tells of two elements in space.
!>
!> The plane's direction across the hole is the first one of a pair here, and nothing is of the second: no torque, and no friction
!> around the hole. A node has two unknowns, its offset in the plane and its slope. Names of shape functions, halves and loops over
!> a pair are as in dg_bending_pair.
module dg_plane_bending
   use dg_kinds, only: wp
   use dg_bending_element, only: contact_places
   use dg_bending_pair, only: a1, a2, a3, a4, b1, b2, b3, b4, beam_pair_type, pair, pair_push_type, sa1, sa2, sa3, sa4, sb1, sb2, &
                              sb3, sb4
   implicit none
   private
   public :: turn_into_plane, plane_action, plane_stiffness, raise_plane_moments, plane_unknowns

   !> Unknowns of a node: offset [m], slope [-].
   integer, parameter :: plane_unknowns = 2

contains

   !> Turns elements so that their first direction is that of the plane.
   pure subroutine turn_into_plane(lateral, both)
      real(wp), intent(in) :: lateral(2)         !< direction of the plane across the hole, on n_1 and n_2
      type(beam_pair_type), intent(inout) :: both
      both%bent_1 = lateral(1)*both%bent_1 + lateral(2)*both%bent_2
      both%outer_load(:, 1) = lateral(1)*both%outer_load(:, 1) + lateral(2)*both%outer_load(:, 2)
      both%outer_load(:, 3) = lateral(1)*both%outer_load(:, 3) + lateral(2)*both%outer_load(:, 4)
      both%inner_load(:, 1) = lateral(1)*both%inner_load(:, 1) + lateral(2)*both%inner_load(:, 2)
      both%inner_load(:, 3) = lateral(1)*both%inner_load(:, 3) + lateral(2)*both%inner_load(:, 4)
   end subroutine turn_into_plane

   !> pair_action in the plane. Of `push` force and k11 are set.
   pure subroutine plane_action(both, outer, inner, push, at_outer, at_inner)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in), dimension(pair, plane_unknowns) :: outer, inner     !< offset and slope of the nodes [m, -]
      type(pair_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout) :: at_outer(pair, plane_unknowns)                 !< [N, N.m]
      real(wp), intent(out) :: at_inner(pair, plane_unknowns)
      real(wp) :: offset(pair, contact_places), depth(pair, contact_places), d, u, v, f
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         d = outer(l, 1) - inner(l, 1)
         u = outer(l, 2)
         v = inner(l, 2)
         f = both%shear(l)*d + both%outer_turn(l)*u + both%inner_turn(l)*v
         at_outer(l, 1) = at_outer(l, 1) + (f - both%outer_load(l, 1))
         at_inner(l, 1) = -f - both%inner_load(l, 1)
         f = both%outer_turn(l)*d + both%outer_couple(l)*u + both%common_couple(l)*v
         at_outer(l, 2) = at_outer(l, 2) + (f - both%outer_load(l, 3))
         f = both%inner_turn(l)*d + both%common_couple(l)*u + both%inner_couple(l)*v
         at_inner(l, 2) = f - both%inner_load(l, 3)
         offset(l, 1) = a1*outer(l, 1) + a3*inner(l, 1) + both%length(l)*(a2*u + a4*v)
         offset(l, 2) = b1*outer(l, 1) + b3*inner(l, 1) + both%length(l)*(b2*u + b4*v)
         depth(l, 1) = abs(offset(l, 1)) - both%clearance(l, 1)
         depth(l, 2) = abs(offset(l, 2)) - both%clearance(l, 2)
      end do
      push(1)%force = 0.0_wp
      push(2)%force = 0.0_wp
      if (max(depth(1, 1), depth(2, 1), depth(1, 2), depth(2, 2)) > 0.0_wp) call add_push(both, offset, push, at_outer, at_inner)
   end subroutine plane_action

   !> What the wall adds, which presses by the law of dg_gap_state.
   pure subroutine add_push(both, offset, push, at_outer, at_inner)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in) :: offset(pair, contact_places)      !< from the hole axis [m]
      type(pair_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout), dimension(pair, plane_unknowns) :: at_outer, at_inner
      real(wp) :: normal(pair, contact_places), distance, contact, more, force, a, b, c, d
      integer :: l, p
      do p = 1, contact_places
         !GCC$ unroll 1
         do l = 1, pair
            distance = abs(offset(l, p))
            contact = 0.5_wp*both%length(l)*both%contact(l)
            more = 0.5_wp*both%length(l)*both%maximum(l) - contact
            force = contact*max(distance - both%clearance(l, p), 0.0_wp) + more*max(distance - both%limit(l, p), 0.0_wp)
            ! factors are one where the wall presses, else zero: the compiler makes jumps of merge
            push(p)%k11(l) = contact*(0.5_wp - sign(0.5_wp, both%clearance(l, p) - distance)) &
                             + more*(0.5_wp - sign(0.5_wp, both%limit(l, p) - distance))
            push(p)%force(l) = force
            normal(l, p) = sign(force, offset(l, p))
         end do
      end do
      !GCC$ unroll 1
      do l = 1, pair
         a = normal(l, 1)
         b = normal(l, 2)
         c = both%lever(l)*both%per_length(l)*a
         d = both%lever(l)*both%per_length(l)*b
         at_outer(l, 1) = at_outer(l, 1) + (a1*a + b1*b + sa1*c + sb1*d)
         at_outer(l, 2) = at_outer(l, 2) + both%length(l)*(a2*a + b2*b + sa2*c + sb2*d)
         at_inner(l, 1) = at_inner(l, 1) + (a3*a + b3*b + sa3*c + sb3*d)
         at_inner(l, 2) = at_inner(l, 2) + both%length(l)*(a4*a + b4*b + sa4*c + sb4*d)
      end do
   end subroutine add_push

   !> Adds the derivatives of what the wall adds to forces and couples, by the outer node's offset and slope and by the inner one's.
   pure subroutine plane_stiffness(both, push, own, next)
      type(beam_pair_type), intent(in) :: both
      type(pair_push_type), intent(in) :: push(contact_places)
      !> Rows are of the outer node, then of the inner one [N/m, N, N.m].
      real(wp), intent(inout), dimension(pair, 2*plane_unknowns, plane_unknowns) :: own, next
      real(wp) :: a(pair, 4), b(pair, 4), friction, w, v
      integer :: l, i
      !GCC$ unroll 1
      do l = 1, pair
         friction = both%lever(l)*both%per_length(l)
         a(l, 1) = (a1 + sa1*friction)*push(1)%k11(l)
         a(l, 2) = (a2 + sa2*friction)*both%length(l)*push(1)%k11(l)
         a(l, 3) = (a3 + sa3*friction)*push(1)%k11(l)
         a(l, 4) = (a4 + sa4*friction)*both%length(l)*push(1)%k11(l)
         b(l, 1) = (b1 + sb1*friction)*push(2)%k11(l)
         b(l, 2) = (b2 + sb2*friction)*both%length(l)*push(2)%k11(l)
         b(l, 3) = (b3 + sb3*friction)*push(2)%k11(l)
         b(l, 4) = (b4 + sb4*friction)*both%length(l)*push(2)%k11(l)
      end do
      do i = 1, 2*plane_unknowns
         !GCC$ unroll 1
         do l = 1, pair
            own(l, i, 1) = own(l, i, 1) + (a1*a(l, i) + b1*b(l, i))
            next(l, i, 1) = next(l, i, 1) + (a3*a(l, i) + b3*b(l, i))
            w = a2*a(l, i) + b2*b(l, i)
            v = a4*a(l, i) + b4*b(l, i)
            own(l, i, 2) = own(l, i, 2) + both%length(l)*w
            next(l, i, 2) = next(l, i, 2) + both%length(l)*v
         end do
      end do
   end subroutine plane_stiffness

   !> raise_moments in the plane.
   pure subroutine raise_plane_moments(both, outer, inner, outer_change, inner_change, most, changed)
      type(beam_pair_type), intent(in) :: both
      real(wp), intent(in), dimension(pair, plane_unknowns) :: outer, inner, outer_change, inner_change
      real(wp), intent(inout), dimension(pair) :: most, changed      !< squares [N2.m2]
      real(wp) :: s, c, m, n
      integer :: l
      !GCC$ unroll 1
      do l = 1, pair
         s = 2.0_wp*both%ei(l)*both%per_length(l)
         c = 3.0_wp*both%per_length(l)*(inner(l, 1) - outer(l, 1))
         m = s*(c - 2.0_wp*outer(l, 2) - inner(l, 2)) + both%ei(l)*both%bent_1(l)
         n = s*(2.0_wp*inner(l, 2) + outer(l, 2) - c) + both%ei(l)*both%bent_1(l)
         most(l) = max(most(l), m*m, n*n)
         c = 3.0_wp*both%per_length(l)*(inner_change(l, 1) - outer_change(l, 1))
         m = s*(c - 2.0_wp*outer_change(l, 2) - inner_change(l, 2))
         n = s*(2.0_wp*inner_change(l, 2) + outer_change(l, 2) - c)
         changed(l) = max(changed(l), m*m, n*n)
      end do
   end subroutine raise_plane_moments
end module dg_plane_bending
