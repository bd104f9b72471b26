!> A string in its hole as a slender beam across the hole axis, under an axial force and a torque that are known.
!>
!> The analysis of a case finds axial force, torque and contact to a ten-thousandth with elements that are long against the bending
!> length sqrt(EI/T); the bending moment between their contact points it does not. Here that moment is found on shorter elements. The
!> unknowns of a node are the offset y = (y_1, y_2) of the string off the hole axis, along n_1 and n_2 of the frame that is carried
!> along without spin (convention 3), and its slope y' by measured depth. With the hole's curvature k, the axial force T (tension
!> positive) and the torque M_t (convention 9), the string of stiffness EI is in equilibrium when for every small displacement v
!>
!>   integral of  EI (k + y'').v'' - M_t t x (k + y'').v' + T y'.v' - (T k + w).v + R n.v + R m (t x n).v + r a R n.v'  = 0.
!>
!> w is the buoyed weight across the hole, R the contact force per metre at |y| > c, n = y/|y|; m and a are the coefficients of
!> friction around and along the hole (convention 13), r the radius of contact. Slopes are small against one.
!> These are the equations of a beam-column in the frame of the hole (Liu, Ding & Zhang 2002, Eqs. 4 to 6 and 9 to 12, linear in y
!> but for the contact).
module dg_bending_beam
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_gap_state, only: contact_force, gap_law_type, state_elastic, state_rigid
   use dg_hermite, only: hermite_slope, hermite_value
   implicit none
   private
   public :: bending_beam_type, node_unknowns, contact_places, contact_xi
   public :: set_linear_part, add_contact, element_forces, contact_forces, point_forces, moment_within, moment_of_offsets

   !> Unknowns of a node: y_1, y_2 [m], their slopes [-].
   integer, parameter :: node_unknowns = 4
   !> Places of an element at which the wall is felt: as many as a node has constraints to give, so that a string that lies on the
   !> wall can bend along it.
   integer, parameter :: contact_places = 2
   real(wp), parameter :: third = 1.0_wp/sqrt(3.0_wp)
   real(wp), parameter :: contact_xi(contact_places) = [0.5_wp*(1.0_wp - third), 0.5_wp*(1.0_wp + third)]
   !> Gauss points and weights of the other integrals, exact to the fifth power.
   real(wp), parameter :: outer = sqrt(0.6_wp)
   real(wp), parameter :: gauss_xi(3) = [0.5_wp*(1.0_wp - outer), 0.5_wp, 0.5_wp*(1.0_wp + outer)]
   real(wp), parameter :: gauss_weight(3) = [5.0_wp, 8.0_wp, 5.0_wp]/18.0_wp

   type :: bending_beam_type
      real(wp), allocatable :: md(:)            !< of the nodes, measured along the string before loading [m]
      real(wp), allocatable :: place(:)         !< measured depth in the hole where the node now is [m]
      real(wp), allocatable :: axial(:)         !< T at the nodes [N]
      real(wp), allocatable :: weight(:, :)     !< buoyed weight across the hole, per length, at the nodes (2,n) [N/m]
      real(wp), allocatable :: viscous(:)       !< at the nodes: resistance that holds a compressed string while it settles [N/m]
      logical, allocatable :: held(:)           !< nodes whose offset and slope stay as they are
      logical, allocatable :: centred(:)        !< nodes whose offset stays as it is
      integer, allocatable :: owner(:)          !< element of the analysis in which an element lies
      real(wp), allocatable :: curvature(:, :)  !< k of the hole, by element (2,e) [1/m]
      real(wp), allocatable :: torque(:)        !< M_t by element [N.m]
      real(wp), allocatable :: ei(:)            !< [N.m2]
      type(gap_law_type), allocatable :: law(:) !< of a metre of wall (stiffnesses in N/m2), by element
      real(wp), allocatable :: radius(:)        !< of contact r, by element [m]
      real(wp), allocatable :: along(:)         !< friction coefficient a, by element [-]
      real(wp), allocatable :: around(:)        !< friction coefficient m, by element [-]
      ! contacts at one node, of tool joints: by contact, from the top down
      integer, allocatable :: point(:)             !< node
      integer, allocatable :: point_owner(:)       !< element of the analysis to which it belongs
      type(gap_law_type), allocatable :: point_law(:)  !< of the whole contact (stiffnesses in N/m)
   end type bending_beam_type

contains

   !> Matrix and load (residual = matrix y - load) of all but contact. Both are overwritten.
   pure subroutine set_linear_part(beam, matrix, load)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(out) :: matrix     !< 4 unknowns a node
      real(wp), intent(out) :: load(:, :)                !< (4,n) [N, N.m]
      real(wp) :: k(8, 8), f(8)
      integer :: e, n
      n = size(beam%md)
      matrix = new_block_matrix(n, node_unknowns)
      load = 0.0_wp
      do e = 1, n - 1
         call linear_element(beam, e, k, f)
         matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + k(:4, :4)
         matrix%diagonal(:, :, e + 1) = matrix%diagonal(:, :, e + 1) + k(5:, 5:)
         matrix%upper(:, :, e) = k(:4, 5:)
         matrix%lower(:, :, e) = k(5:, :4)
         load(:, e) = load(:, e) + f(:4)
         load(:, e + 1) = load(:, e + 1) + f(5:)
      end do
   end subroutine set_linear_part

   !> Those of one element, in the order (y_1, y_2, y_1', y_2') of its upper, then its lower node.
   pure subroutine linear_element(beam, e, k, f)
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: e
      real(wp), intent(out) :: k(8, 8), f(8)
      real(wp) :: length, weight, tension, across(2), value(4), slope(4), bend(4), bent(4, 4), tight(4, 4), turned(4, 4)
      integer :: g, i, j
      integer, parameter :: first(4) = [1, 3, 5, 7]      ! of y_1; those of y_2 follow them
      length = beam%md(e + 1) - beam%md(e)
      bent = 0.0_wp
      tight = 0.0_wp
      turned = 0.0_wp
      f = 0.0_wp
      do g = 1, size(gauss_xi)
         weight = gauss_weight(g)*length
         value = hermite_value(gauss_xi(g), length)
         slope = hermite_slope(gauss_xi(g), length)
         bend = hermite_bend(gauss_xi(g), length)
         tension = (1.0_wp - gauss_xi(g))*beam%axial(e) + gauss_xi(g)*beam%axial(e + 1)
         across = (1.0_wp - gauss_xi(g))*beam%weight(:, e) + gauss_xi(g)*beam%weight(:, e + 1) + tension*beam%curvature(:, e)
         do j = 1, 4
            do i = 1, 4
               bent(i, j) = bent(i, j) + weight*beam%ei(e)*bend(i)*bend(j)
               tight(i, j) = tight(i, j) + weight*tension*slope(i)*slope(j)
               turned(i, j) = turned(i, j) - weight*beam%torque(e)*slope(i)*bend(j)
            end do
         end do
         do i = 1, 4
            f(first(i)) = f(first(i)) + weight*(value(i)*across(1) - beam%ei(e)*bend(i)*beam%curvature(1, e) &
                                                - beam%torque(e)*slope(i)*beam%curvature(2, e))
            f(first(i) + 1) = f(first(i) + 1) + weight*(value(i)*across(2) - beam%ei(e)*bend(i)*beam%curvature(2, e) &
                                                        + beam%torque(e)*slope(i)*beam%curvature(1, e))
         end do
      end do
      k = 0.0_wp
      do j = 1, 4
         do i = 1, 4
            k(first(i), first(j)) = bent(i, j) + tight(i, j)
            k(first(i) + 1, first(j) + 1) = bent(i, j) + tight(i, j)
            k(first(i), first(j) + 1) = -turned(i, j)          ! t x (a_1, a_2) = (-a_2, a_1)
            k(first(i) + 1, first(j)) = turned(i, j)
         end do
      end do
   end subroutine linear_element

   !> Second derivatives of the shape functions [1/m2, 1/m, ...].
   pure function hermite_bend(xi, length) result(n)
      real(wp), intent(in) :: xi, length
      real(wp) :: n(4)
      n(1) = (12.0_wp*xi - 6.0_wp)/length**2
      n(2) = (6.0_wp*xi - 4.0_wp)/length
      n(3) = -n(1)
      n(4) = (6.0_wp*xi - 2.0_wp)/length
   end function hermite_bend

   !> Adds contact to a residual and its matrix.
   pure subroutine add_contact(beam, y, residual, matrix)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)                    !< (4,n)
      real(wp), intent(inout) :: residual(:, :)          !< (4,n) [N, N.m]
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: f(8), k(8, 8), force, by_across(2, 2), by_couple(2, 2)
      logical :: touches
      integer :: e, n, p
      do e = 1, size(beam%md) - 1
         do p = 1, contact_places
            call contact_element(beam, e, p, y, f, touches, k)
            if (.not. touches) cycle
            residual(:, e) = residual(:, e) + f(:4)
            residual(:, e + 1) = residual(:, e + 1) + f(5:)
            matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + k(:4, :4)
            matrix%diagonal(:, :, e + 1) = matrix%diagonal(:, :, e + 1) + k(5:, 5:)
            matrix%upper(:, :, e) = matrix%upper(:, :, e) + k(:4, 5:)
            matrix%lower(:, :, e) = matrix%lower(:, :, e) + k(5:, :4)
         end do
      end do
      do p = 1, size(beam%point)
         n = beam%point(p)
         if (.not. norm2(y(1:2, n)) > beam%point_law(p)%clearance) cycle
         e = min(n, size(beam%ei))
         call wall_action(beam%point_law(p), y(1:2, n), beam%along(e)*beam%radius(e), beam%around(e), force, f(1:2), f(3:4), &
                          by_across, by_couple)
         residual(:, n) = residual(:, n) + f(:4)
         matrix%diagonal(1:2, 1:2, n) = matrix%diagonal(1:2, 1:2, n) + by_across
         matrix%diagonal(3:4, 1:2, n) = matrix%diagonal(3:4, 1:2, n) + by_couple
      end do
   end subroutine add_contact

   !> Force of the wall at one place of an element on its eight unknowns, and its stiffness where that is asked for.
   pure subroutine contact_element(beam, e, p, y, f, touches, k)
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: e, p
      real(wp), intent(in) :: y(:, :)
      real(wp), intent(out) :: f(8)
      logical, intent(out) :: touches
      real(wp), intent(out), optional :: k(8, 8)
      real(wp) :: length, value(4), slope(4), offset(2), force, across(2), couple(2), by_across(2, 2), by_couple(2, 2), weight
      integer :: i, j, a, b
      length = beam%md(e + 1) - beam%md(e)
      value = hermite_value(contact_xi(p), length)
      offset = value(1)*y(1:2, e) + value(2)*y(3:4, e) + value(3)*y(1:2, e + 1) + value(4)*y(3:4, e + 1)
      touches = offset(1)**2 + offset(2)**2 > beam%law(e)%clearance**2
      if (.not. touches) return
      call wall_action(beam%law(e), offset, beam%along(e)*beam%radius(e), beam%around(e), force, across, couple, &
                       by_across, by_couple)
      slope = hermite_slope(contact_xi(p), length)
      weight = length/contact_places
      do i = 1, 4
         a = 2*i - 1
         f(a:a + 1) = weight*(value(i)*across + slope(i)*couple)
      end do
      if (.not. present(k)) return
      do j = 1, 4
         b = 2*j - 1
         do i = 1, 4
            a = 2*i - 1
            k(a:a + 1, b:b + 1) = (weight*value(j)*value(i))*by_across + (weight*value(j)*slope(i))*by_couple
         end do
      end do
   end subroutine contact_element

   !> What the wall adds to the residual where the string touches: R n + R m t x n on the offset, r a R n on the slope, and their
   !> derivatives by the offset.
   pure subroutine wall_action(law, offset, lever, around, force, across, couple, by_across, by_couple)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: offset(2)   !< [m]
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(out) :: force      !< R [N/m, or N]
      real(wp), intent(out) :: across(2), couple(2), by_across(2, 2), by_couple(2, 2)
      real(wp) :: distance, stiffness, n(2), tau(2), by_n(2, 2), by_tau(2, 2)
      integer :: i
      distance = norm2(offset)
      call contact_force(law, merge(state_rigid, state_elastic, distance > (1.0_wp + law%eps_nmax)*law%clearance), distance, &
                         force, stiffness)
      n = offset/distance
      tau = [-n(2), n(1)]
      across = force*(n + around*tau)
      couple = lever*force*n
      do i = 1, 2
         by_n(:, i) = stiffness*n(i)*n + force/distance*tau(i)*tau
         by_tau(:, i) = stiffness*n(i)*tau - force/distance*tau(i)*n
      end do
      by_across = by_n + around*by_tau
      by_couple = lever*by_n
   end subroutine wall_action

   !> Forces that each element exerts on its upper node, and the last one on its lower node, all loads of the element taken off
   !> (4,n): the bending moment at a node is minus its third and fourth, from below, the force across its first and second.
   pure function element_forces(beam, y) result(forces)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      real(wp) :: forces(4, size(y, 2))
      real(wp) :: k(8, 8), f(8), all(8), local(8)
      logical :: touches
      integer :: e, n, p
      n = size(y, 2)
      do e = 1, n - 1
         call linear_element(beam, e, k, f)
         local = [y(:, e), y(:, e + 1)]
         all = matmul(k, local) - f
         do p = 1, contact_places
            call contact_element(beam, e, p, y, f, touches)
            if (touches) all = all + f
         end do
         forces(:, e) = all(:4)
         if (e == n - 1) forces(:, n) = -all(5:)
      end do
   end function element_forces

   !> Contact forces [N] at the places of the elements (contact_places,e), which lie at `contact_xi` of their lengths.
   pure function contact_forces(beam, y) result(forces)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      real(wp) :: forces(contact_places, size(y, 2) - 1)
      real(wp) :: length, value(4), offset(2), a(2), b(2), c(2, 2), d(2, 2)
      integer :: e, p
      do e = 1, size(y, 2) - 1
         length = beam%md(e + 1) - beam%md(e)
         do p = 1, contact_places
            value = hermite_value(contact_xi(p), length)
            offset = value(1)*y(1:2, e) + value(2)*y(3:4, e) + value(3)*y(1:2, e + 1) + value(4)*y(3:4, e + 1)
            forces(p, e) = 0.0_wp
            if (norm2(offset) > beam%law(e)%clearance) &
               call wall_action(beam%law(e), offset, 0.0_wp, 0.0_wp, forces(p, e), a, b, c, d)
            forces(p, e) = forces(p, e)*length/contact_places
         end do
      end do
   end function contact_forces

   !> Contact forces at single nodes [N], in the order of beam%point.
   pure function point_forces(beam, y) result(forces)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      real(wp) :: forces(size(beam%point))
      real(wp) :: a(2), b(2), c(2, 2), d(2, 2)
      integer :: p
      forces = 0.0_wp
      do p = 1, size(beam%point)
         associate (offset => y(1:2, beam%point(p)))
            if (norm2(offset) > beam%point_law(p)%clearance) &
               call wall_action(beam%point_law(p), offset, 0.0_wp, 0.0_wp, forces(p), a, b, c, d)
         end associate
      end do
   end function point_forces

   !> Moment EI (k + y'') of an element's own shape at its upper (side 1) or lower end (2) [N.m]. Where it jumps from one element to
   !> the next, elements are too long.
   pure function moment_within(beam, y, e, side) result(moment)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      integer, intent(in) :: e, side
      real(wp) :: moment(2)
      moment = beam%ei(e)*beam%curvature(:, e) + moment_of_offsets(beam, y, e, side)
   end function moment_within

   !> The part EI y'' of it, which offsets, or a change of them, make.
   pure function moment_of_offsets(beam, y, e, side) result(moment)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      integer, intent(in) :: e, side
      real(wp) :: moment(2)
      real(wp) :: bend(4)
      bend = hermite_bend(real(side - 1, wp), beam%md(e + 1) - beam%md(e))
      moment = beam%ei(e)*(bend(1)*y(1:2, e) + bend(2)*y(3:4, e) + bend(3)*y(1:2, e + 1) + bend(4)*y(3:4, e + 1))
   end function moment_of_offsets
end module dg_bending_beam
